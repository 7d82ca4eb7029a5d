/*
 * stanford_full: Stanford geometry, random full inertias
 * Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 prismatic, 4 revolute, 5 revolute, 6 revolute
 * Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 223 multiplications, 208 additions = 431; 6 unary minus; 8 sine/cosine
 *   gravity: 48 multiplications, 27 additions = 75; 1 unary minus; 8 sine/cosine
 *   bias: 211 multiplications, 186 additions = 397; 7 unary minus; 8 sine/cosine
 *   mass_matrix: 105 multiplications, 98 additions = 203; 9 unary minus; 8 sine/cosine
 *   forward_dynamics: 402 multiplications, 354 additions, 6 divisions = 762; 20 unary minus; 8
 *       sine/cosine
 */
#include "stanford_full.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 223 multiplications, 208 additions = 431; 6 unary minus; 8 sine/cosine */
void stanford_full_inverse_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real qdd[6],
    stanford_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(again[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(again[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(again[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a2_z = -0.1524*ww1_zz;
    const stanford_full_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real w2_x = t1*s2;
    const stanford_full_real w2_y = t1*c2;
    const stanford_full_real t2 = 0.1524*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a2_x = -9.8*s2 - c2*t2;
    const stanford_full_real a2_y = s2*t2 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_yz = qd[1]*w2_y;
    const stanford_full_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_full_real alpha2_x = ww2_yz - qdd[0]*s2;
    const stanford_full_real alpha2_y = -qdd[0]*c2 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = w2_x*w2_y;
    const stanford_full_real neg_ww2_xx = -w2_x*w2_x;
    const stanford_full_real ww2_yy = w2_y*w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const stanford_full_real lam2_12 = ww2_xy - qdd[1];
    const stanford_full_real lam2_13 = ww2_zx + alpha2_y;
    const stanford_full_real lam2_21 = qdd[1] + ww2_xy;
    const stanford_full_real lam2_22 = neg_ww2_xx - ww2_zz;
    const stanford_full_real lam2_23 = ww2_yz - alpha2_x;
    const stanford_full_real neg_lam2_31 = alpha2_y - ww2_zx;
    const stanford_full_real lam2_32 = ww2_yz + alpha2_x;
    const stanford_full_real lam2_33 = neg_ww2_xx - ww2_yy;
    const stanford_full_real t3 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a3_x = a2_x - q[2]*lam2_12 + qd[1]*t3;
    const stanford_full_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t3;
    const stanford_full_real a3_z = qdd[2] - (a2_y - q[2]*lam2_22);
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_full_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_full_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = qd[3]*w4_y - (-qdd[1]*s4 - c4*alpha2_x);
    const stanford_full_real alpha4_y = qdd[1]*c4 - s4*alpha2_x - qd[3]*w4_x;
    const stanford_full_real alpha4_z = qdd[3] - alpha2_y;
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real ww4_yz = w4_y*w4_z;
    const stanford_full_real ww4_zx = w4_x*w4_z;
    const stanford_full_real ww4_xy = w4_x*w4_y;
    const stanford_full_real ww4_xx = w4_x*w4_x;
    const stanford_full_real ww4_yy = w4_y*w4_y;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const stanford_full_real lam4_12 = ww4_xy - alpha4_z;
    const stanford_full_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_full_real lam4_21 = alpha4_z + ww4_xy;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_full_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_full_real t4 = -c5;
    const stanford_full_real w5_y = t4*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_x = c5*a4_x - s5*a3_z;
    const stanford_full_real a5_y = t4*a3_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const stanford_full_real alpha5_y = t4*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
    const stanford_full_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real ww5_yz = w5_y*w5_z;
    const stanford_full_real ww5_zx = w5_x*w5_z;
    const stanford_full_real ww5_xy = w5_x*w5_y;
    const stanford_full_real ww5_xx = w5_x*w5_x;
    const stanford_full_real ww5_yy = w5_y*w5_y;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const stanford_full_real lam5_12 = ww5_xy - alpha5_z;
    const stanford_full_real lam5_13 = alpha5_y + ww5_zx;
    const stanford_full_real lam5_21 = alpha5_z + ww5_xy;
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_full_real lam5_23 = ww5_yz - alpha5_x;
    const stanford_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const stanford_full_real lam5_32 = alpha5_x + ww5_yz;
    const stanford_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a6_x = c6*a5_x + s6*a4_y;
    const stanford_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const stanford_full_real alpha6_x = qd[5]*w6_y - (-s6*alpha5_z - c6*alpha5_x);
    const stanford_full_real alpha6_y = c6*alpha5_z - s6*alpha5_x - qd[5]*w6_x;
    const stanford_full_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_yz = w6_y*w6_z;
    const stanford_full_real ww6_zx = w6_x*w6_z;
    const stanford_full_real ww6_xy = w6_x*w6_y;
    const stanford_full_real ww6_xx = w6_x*w6_x;
    const stanford_full_real ww6_yy = w6_y*w6_y;
    const stanford_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const stanford_full_real lam6_12 = ww6_xy - alpha6_z;
    const stanford_full_real lam6_13 = alpha6_y + ww6_zx;
    const stanford_full_real lam6_21 = alpha6_z + ww6_xy;
    const stanford_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const stanford_full_real lam6_23 = ww6_yz - alpha6_x;
    const stanford_full_real lam6_31 = ww6_zx - alpha6_y;
    const stanford_full_real lam6_32 = alpha6_x + ww6_yz;
    const stanford_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 1: moment that turns the link [N m] */
    const stanford_full_real nc1_z = 1.1129758995253813*qdd[0];
    /* link 2: force that moves the link [N] */
    const stanford_full_real fc2_x = -0.14889539863184567*neg_lam2_11 - 0.5558718199714463*lam2_12;
    const stanford_full_real fc2_y = 0.14889539863184567*lam2_21 - 0.5558718199714463*lam2_22;
    /* link 2: moment that turns the link [N m] */
    const stanford_full_real nc2_x = 0.0847148653636484*ww1_zz - (0.06807816021551473*(lam2_33 -
        lam2_22) - 0.6226618668666462*lam2_32 + (0.04911220265093226*neg_lam2_31 +
        0.0511982033036484*lam2_21));
    const stanford_full_real nc2_y = 0.124038775446629*neg_lam2_31 - 0.0511982033036484*(neg_lam2_11
        + lam2_33) + (-0.06807816021551473*lam2_12 - 0.04911220265093226*lam2_32) +
        0.02269165875149328*ww1_zz;
    const stanford_full_real t5 = 0.124038775446629*lam2_21 - 0.6226618668666462*lam2_12 +
        0.04911220265093226*(neg_lam2_11 + lam2_22) - (-0.0511982033036484*lam2_23 -
        0.06807816021551473*lam2_13);
    const stanford_full_real nc2_z = t5 + (0.14889539863184567*a2_y + 0.5558718199714463*a2_x);
    /* link 3: force that moves the link [N] */
    const stanford_full_real fc3_x = 19.732838668844984*a3_x - (0.22200183325724177*neg_lam2_11 -
        0.4516316755890639*lam2_13 + 0.012168751997232599*lam2_12);
    const stanford_full_real fc3_y = 19.732838668844984*a3_y - (0.22200183325724177*neg_lam2_31 -
        0.4516316755890639*lam2_33 + 0.012168751997232599*lam2_32);
    const stanford_full_real fc3_z = 19.732838668844984*a3_z - (0.22200183325724177*lam2_21 +
        0.4516316755890639*lam2_23 - 0.012168751997232599*lam2_22);
    /* link 3: moment that turns the link [N m] */
    const stanford_full_real nc3_x = 0.4516316755890639*a3_z - 0.012168751997232599*a3_y;
    const stanford_full_real nc3_y = 0.012168751997232599*a3_x - 0.22200183325724177*a3_z;
    const stanford_full_real nc3_z = 0.22200183325724177*a3_y - 0.4516316755890639*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_full_real fc4_x = 0.28054187970758354*lam4_12 - 0.9022885982543313*neg_lam4_11;
    const stanford_full_real fc4_y = 0.9022885982543313*lam4_21 - 0.28054187970758354*neg_lam4_22;
    const stanford_full_real fc4_z = 0.9022885982543313*lam4_31 + 0.28054187970758354*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_full_real nc4_x = 0.28054187970758354*a3_z - (0.23523950726161555*(neg_lam4_22 -
        neg_lam4_33) - 1.1561689763413345*lam4_32 - (0.002655628796226608*lam4_21 -
        0.06784076259315977*lam4_31));
    const stanford_full_real nc4_y = 0.002655628796226608*(neg_lam4_11 - neg_lam4_33) -
        0.3448462092987837*lam4_31 + (0.06784076259315977*lam4_32 - 0.23523950726161555*lam4_12) -
        0.9022885982543313*a3_z;
    const stanford_full_real t6 = 0.3448462092987837*lam4_21 - 1.1561689763413345*lam4_12 -
        0.06784076259315977*(neg_lam4_11 - neg_lam4_22) - (0.002655628796226608*lam4_23 -
        0.23523950726161555*lam4_13);
    const stanford_full_real nc4_z = t6 + (0.9022885982543313*a4_y - 0.28054187970758354*a4_x);
    /* link 5: force that moves the link [N] */
    const stanford_full_real fc5_x = 0.5911078910549018*neg_lam5_11 - 0.6468331423588011*lam5_12;
    const stanford_full_real fc5_y = 0.6468331423588011*neg_lam5_22 - 0.5911078910549018*lam5_21;
    const stanford_full_real fc5_z = 0.5911078910549018*neg_lam5_31 - 0.6468331423588011*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_full_real neg_nc5_x = 0.23560176217086468*(neg_lam5_22 - neg_lam5_33) -
        0.17535491873574263*lam5_32 + (0.060693211657558095*neg_lam5_31 -
        0.13660343902034475*lam5_21) + 0.6468331423588011*a4_y;
    const stanford_full_real nc5_y = 0.20245111268601115*neg_lam5_31 +
        0.13660343902034475*(neg_lam5_11 - neg_lam5_33) + (-0.23560176217086468*lam5_12 -
        0.060693211657558095*lam5_32) + 0.5911078910549018*a4_y;
    const stanford_full_real t7 = 0.20245111268601115*lam5_21 - 0.17535491873574263*lam5_12 -
        0.060693211657558095*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475*lam5_23 -
        0.23560176217086468*lam5_13);
    const stanford_full_real nc5_z = t7 - (0.5911078910549018*a5_y - 0.6468331423588011*a5_x);
    /* link 6: force that moves the link [N] */
    const stanford_full_real fc6_x = -1.193403445777575*neg_lam6_11 - 1.2174687787169953*lam6_12;
    const stanford_full_real fc6_y = 1.193403445777575*lam6_21 + 1.2174687787169953*neg_lam6_22;
    const stanford_full_real fc6_z = 1.193403445777575*lam6_31 - 1.2174687787169953*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_x = 1.2174687787169953*a5_y - (-0.35115649005241384*lam6_32 -
        0.0625396920897071*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834*lam6_21 -
        0.31745868108016423*lam6_31));
    const stanford_full_real nc6_y = 0.06483323523282834*(neg_lam6_11 - neg_lam6_33) -
        0.3409906449060338*lam6_31 - (-0.0625396920897071*lam6_12 - 0.31745868108016423*lam6_32) +
        1.193403445777575*a5_y;
    const stanford_full_real t8 = 0.3409906449060338*lam6_21 - 0.35115649005241384*lam6_12 -
        0.31745868108016423*(neg_lam6_11 - neg_lam6_22) - (0.06483323523282834*lam6_23 +
        0.0625396920897071*lam6_13);
    const stanford_full_real nc6_z = t8 + (1.193403445777575*a6_y + 1.2174687787169953*a6_x);
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const stanford_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_x = n06_x - neg_nc5_x;
    const stanford_full_real n5_y = nc5_y - nc6_z;
    const stanford_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const stanford_full_real f5_x = fc5_x + f06_x;
    const stanford_full_real f5_y = fc5_y - fc6_z;
    const stanford_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f05_x = c5*f5_x - s5*f5_y;
    const stanford_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = nc4_x + n05_x;
    const stanford_full_real n4_y = nc4_y + n5_z;
    const stanford_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_full_real f4_x = fc4_x + f05_x;
    const stanford_full_real f4_y = fc4_y + f5_z;
    const stanford_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n3_x = nc3_x + n04_x;
    const stanford_full_real n3_y = nc3_y + n04_y;
    const stanford_full_real n3_z = nc3_z + n4_z;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_x = fc3_x + f04_x;
    const stanford_full_real f3_y = fc3_y + f04_y;
    const stanford_full_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_full_real n2_y = nc2_y - n3_z;
    const stanford_full_real n2_z = n3_y + (nc2_z + q[2]*f3_x);
    /* link 2: force through the joint [N] */
    const stanford_full_real f2_x = fc2_x + f3_x;
    const stanford_full_real f2_y = fc2_y - f3_z;
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f02_x = c2*f2_x - s2*f2_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = nc1_z - 0.1524*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 48 multiplications, 27 additions = 75; 1 unary minus; 8 sine/cosine */
void stanford_full_gravity(const stanford_full_real q[6], stanford_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(again[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(again[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(again[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(again[5]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2;
    const stanford_full_real a2_y = -9.8*c2;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a4_x = -c4*neg_a2_x;
    const stanford_full_real a4_y = s4*neg_a2_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_x = c5*a4_x + s5*a2_y;
    const stanford_full_real a5_y = c5*a2_y - s5*a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a6_x = c6*a5_x + s6*a4_y;
    const stanford_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 3: force that moves the link [N] */
    const stanford_full_real neg_fc3_x = 193.38181895468085*s2;
    const stanford_full_real fc3_z = 193.38181895468085*c2;
    /* link 3: moment that turns the link [N m] */
    const stanford_full_real nc3_x = 4.425990420772826*c2;
    const stanford_full_real nc3_z = 4.425990420772826*s2;
    /* link 4: moment that turns the link [N m] */
    const stanford_full_real nc4_x = 2.749310421134319*c2;
    const stanford_full_real neg_nc4_y = 8.842428262892447*c2;
    const stanford_full_real nc4_z = 0.9022885982543313*a4_y - 0.28054187970758354*a4_x;
    /* link 5: moment that turns the link [N m] */
    const stanford_full_real neg_nc5_x = 0.6468331423588011*a4_y;
    const stanford_full_real nc5_y = 0.5911078910549018*a4_y;
    const stanford_full_real nc5_z = 0.6468331423588011*a5_x - 0.5911078910549018*a5_y;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_x = 1.2174687787169953*a5_y;
    const stanford_full_real nc6_y = 1.193403445777575*a5_y;
    const stanford_full_real nc6_z = 1.193403445777575*a6_y + 1.2174687787169953*a6_x;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_x = n06_x - neg_nc5_x;
    const stanford_full_real n5_y = nc5_y - nc6_z;
    const stanford_full_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = nc4_x + n05_x;
    const stanford_full_real n4_y = n5_z - neg_nc4_y;
    const stanford_full_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n04_x = c4*n4_x - s4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n3_x = nc3_x + n04_x;
    const stanford_full_real n3_z = nc3_z + n4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_z = -3.634792872513057*c2 - (5.566797605293052*s2 - (s4*n4_x -
        (q[2]*neg_fc3_x - c4*n4_y)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real neg_f02_x = c2*neg_fc3_x - s2*fc3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n02_y = s2*n3_x - c2*n3_z;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = 0.1524*neg_f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 211 multiplications, 186 additions = 397; 7 unary minus; 8 sine/cosine */
void stanford_full_bias(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    stanford_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(again[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(again[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(again[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a2_z = -0.1524*ww1_zz;
    const stanford_full_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real w2_x = t1*s2;
    const stanford_full_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2;
    const stanford_full_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_full_real alpha2_x = qd[1]*w2_y;
    const stanford_full_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = w2_x*w2_y;
    const stanford_full_real neg_ww2_xx = -w2_x*w2_x;
    const stanford_full_real ww2_yy = w2_y*w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const stanford_full_real lam2_22 = neg_ww2_xx - ww2_zz;
    const stanford_full_real lam2_32 = 2.0*alpha2_x;
    const stanford_full_real lam2_33 = neg_ww2_xx - ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a3_z = neg_a2_y + q[2]*lam2_22;
    const stanford_full_real t2 = 2.0*qd[2];
    const stanford_full_real a3_x = qd[1]*t2 - (neg_a2_x + q[2]*ww2_xy);
    const stanford_full_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t2;
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_full_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_full_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = c4*alpha2_x + qd[3]*w4_y;
    const stanford_full_real alpha4_y = -qd[3]*w4_x - s4*alpha2_x;
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real ww4_yz = w4_y*w4_z;
    const stanford_full_real ww4_zx = w4_x*w4_z;
    const stanford_full_real ww4_xy = w4_x*w4_y;
    const stanford_full_real ww4_xx = w4_x*w4_x;
    const stanford_full_real ww4_yy = w4_y*w4_y;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const stanford_full_real lam4_12 = alpha2_y + ww4_xy;
    const stanford_full_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_full_real lam4_21 = ww4_xy - alpha2_y;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_full_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_full_real t3 = -c5;
    const stanford_full_real w5_y = t3*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_x = c5*a4_x - s5*a3_z;
    const stanford_full_real a5_y = t3*a3_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_x = qd[4]*w5_y - (-s5*alpha2_y - c5*alpha4_x);
    const stanford_full_real alpha5_y = c5*alpha2_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real ww5_yz = w5_y*w5_z;
    const stanford_full_real ww5_zx = w5_x*w5_z;
    const stanford_full_real ww5_xy = w5_x*w5_y;
    const stanford_full_real ww5_xx = w5_x*w5_x;
    const stanford_full_real ww5_yy = w5_y*w5_y;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const stanford_full_real lam5_12 = ww5_xy - alpha4_y;
    const stanford_full_real lam5_13 = alpha5_y + ww5_zx;
    const stanford_full_real lam5_21 = alpha4_y + ww5_xy;
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_full_real lam5_23 = ww5_yz - alpha5_x;
    const stanford_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const stanford_full_real lam5_32 = alpha5_x + ww5_yz;
    const stanford_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a6_x = c6*a5_x + s6*a4_y;
    const stanford_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const stanford_full_real alpha6_x = qd[5]*w6_y - (-s6*alpha4_y - c6*alpha5_x);
    const stanford_full_real alpha6_y = c6*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_yz = w6_y*w6_z;
    const stanford_full_real ww6_zx = w6_x*w6_z;
    const stanford_full_real ww6_xy = w6_x*w6_y;
    const stanford_full_real ww6_xx = w6_x*w6_x;
    const stanford_full_real ww6_yy = w6_y*w6_y;
    const stanford_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const stanford_full_real lam6_12 = alpha5_y + ww6_xy;
    const stanford_full_real lam6_13 = alpha6_y + ww6_zx;
    const stanford_full_real lam6_21 = ww6_xy - alpha5_y;
    const stanford_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const stanford_full_real lam6_23 = ww6_yz - alpha6_x;
    const stanford_full_real lam6_31 = ww6_zx - alpha6_y;
    const stanford_full_real lam6_32 = alpha6_x + ww6_yz;
    const stanford_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const stanford_full_real fc2_x = -0.14889539863184567*neg_lam2_11 - 0.5558718199714463*ww2_xy;
    const stanford_full_real fc2_y = 0.14889539863184567*ww2_xy - 0.5558718199714463*lam2_22;
    /* link 2: moment that turns the link [N m] */
    const stanford_full_real nc2_x = 0.0847148653636484*ww1_zz - (0.06807816021551473*(lam2_33 -
        lam2_22) - 1.2453237337332923*alpha2_x + (0.09822440530186452*alpha2_y +
        0.0511982033036484*ww2_xy));
    const stanford_full_real nc2_y = 0.248077550893258*alpha2_y - 0.0511982033036484*(neg_lam2_11 +
        lam2_33) - (0.06807816021551473*ww2_xy + 0.09822440530186452*alpha2_x) +
        0.02269165875149328*ww1_zz;
    const stanford_full_real neg_nc2_z = 0.49862309142001715*ww2_xy -
        0.04911220265093226*(neg_lam2_11 + lam2_22) + (1.4591749065920876*c2 +
        5.4475438357201735*s2);
    /* link 3: force that moves the link [N] */
    const stanford_full_real fc3_x = 19.732838668844984*a3_x - (0.22200183325724177*neg_lam2_11 +
        0.012168751997232599*ww2_xy);
    const stanford_full_real fc3_y = 19.732838668844984*a3_y - (0.44400366651448353*alpha2_y -
        0.4516316755890639*lam2_33 + 0.024337503994465198*alpha2_x);
    const stanford_full_real fc3_z = 19.732838668844984*a3_z - (0.22200183325724177*ww2_xy -
        0.012168751997232599*lam2_22);
    /* link 3: moment that turns the link [N m] */
    const stanford_full_real nc3_x = 0.4516316755890639*a3_z - 0.012168751997232599*a3_y;
    const stanford_full_real nc3_y = 0.012168751997232599*a3_x - 0.22200183325724177*a3_z;
    const stanford_full_real nc3_z = 0.22200183325724177*a3_y - 0.4516316755890639*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_full_real fc4_x = 0.28054187970758354*lam4_12 - 0.9022885982543313*neg_lam4_11;
    const stanford_full_real fc4_y = 0.9022885982543313*lam4_21 - 0.28054187970758354*neg_lam4_22;
    const stanford_full_real fc4_z = 0.9022885982543313*lam4_31 + 0.28054187970758354*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_full_real nc4_x = 0.28054187970758354*a3_z - (0.23523950726161555*(neg_lam4_22 -
        neg_lam4_33) - 1.1561689763413345*lam4_32 - (0.002655628796226608*lam4_21 -
        0.06784076259315977*lam4_31));
    const stanford_full_real nc4_y = 0.002655628796226608*(neg_lam4_11 - neg_lam4_33) -
        0.3448462092987837*lam4_31 - (0.23523950726161555*lam4_12 - 0.06784076259315977*lam4_32) -
        0.9022885982543313*a3_z;
    const stanford_full_real t4 = 1.1561689763413345*lam4_12 - 0.3448462092987837*lam4_21 +
        0.06784076259315977*(neg_lam4_11 - neg_lam4_22) + (0.002655628796226608*lam4_23 -
        0.23523950726161555*lam4_13);
    const stanford_full_real nc4_z = 0.9022885982543313*a4_y - 0.28054187970758354*a4_x - t4;
    /* link 5: force that moves the link [N] */
    const stanford_full_real fc5_x = 0.5911078910549018*neg_lam5_11 - 0.6468331423588011*lam5_12;
    const stanford_full_real fc5_y = 0.6468331423588011*neg_lam5_22 - 0.5911078910549018*lam5_21;
    const stanford_full_real fc5_z = 0.5911078910549018*neg_lam5_31 - 0.6468331423588011*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_full_real neg_nc5_x = 0.23560176217086468*(neg_lam5_22 - neg_lam5_33) -
        0.17535491873574263*lam5_32 + (0.060693211657558095*neg_lam5_31 -
        0.13660343902034475*lam5_21) + 0.6468331423588011*a4_y;
    const stanford_full_real nc5_y = 0.20245111268601115*neg_lam5_31 +
        0.13660343902034475*(neg_lam5_11 - neg_lam5_33) + (-0.23560176217086468*lam5_12 -
        0.060693211657558095*lam5_32) + 0.5911078910549018*a4_y;
    const stanford_full_real t5 = 0.20245111268601115*lam5_21 - 0.17535491873574263*lam5_12 -
        0.060693211657558095*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475*lam5_23 -
        0.23560176217086468*lam5_13);
    const stanford_full_real nc5_z = t5 - (0.5911078910549018*a5_y - 0.6468331423588011*a5_x);
    /* link 6: force that moves the link [N] */
    const stanford_full_real fc6_x = -1.193403445777575*neg_lam6_11 - 1.2174687787169953*lam6_12;
    const stanford_full_real fc6_y = 1.193403445777575*lam6_21 + 1.2174687787169953*neg_lam6_22;
    const stanford_full_real fc6_z = 1.193403445777575*lam6_31 - 1.2174687787169953*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_x = 1.2174687787169953*a5_y - (-0.35115649005241384*lam6_32 -
        0.0625396920897071*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834*lam6_21 -
        0.31745868108016423*lam6_31));
    const stanford_full_real nc6_y = 0.06483323523282834*(neg_lam6_11 - neg_lam6_33) -
        0.3409906449060338*lam6_31 + (0.0625396920897071*lam6_12 + 0.31745868108016423*lam6_32) +
        1.193403445777575*a5_y;
    const stanford_full_real t6 = 0.35115649005241384*lam6_12 - 0.3409906449060338*lam6_21 +
        0.31745868108016423*(neg_lam6_11 - neg_lam6_22) + (0.06483323523282834*lam6_23 +
        0.0625396920897071*lam6_13);
    const stanford_full_real nc6_z = 1.193403445777575*a6_y + 1.2174687787169953*a6_x - t6;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const stanford_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_x = n06_x - neg_nc5_x;
    const stanford_full_real n5_y = nc5_y - nc6_z;
    const stanford_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const stanford_full_real f5_x = fc5_x + f06_x;
    const stanford_full_real f5_y = fc5_y - fc6_z;
    const stanford_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f05_x = c5*f5_x - s5*f5_y;
    const stanford_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = nc4_x + n05_x;
    const stanford_full_real n4_y = nc4_y + n5_z;
    const stanford_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_full_real f4_x = fc4_x + f05_x;
    const stanford_full_real f4_y = fc4_y + f5_z;
    const stanford_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n3_x = nc3_x + n04_x;
    const stanford_full_real n3_y = nc3_y + n04_y;
    const stanford_full_real n3_z = nc3_z + n4_z;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_x = fc3_x + f04_x;
    const stanford_full_real f3_y = fc3_y + f04_y;
    const stanford_full_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_full_real n2_y = nc2_y - n3_z;
    const stanford_full_real n2_z = n3_y + (q[2]*f3_x - neg_nc2_z);
    /* link 2: force through the joint [N] */
    const stanford_full_real f2_x = fc2_x + f3_x;
    const stanford_full_real f2_y = fc2_y - f3_z;
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f02_x = c2*f2_x - s2*f2_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = -0.1524*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 105 multiplications, 98 additions = 203; 9 unary minus; 8 sine/cosine */
void stanford_full_mass_matrix(const stanford_full_real q[6], stanford_full_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(again[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(again[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(again[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(again[5]);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_x = 1.193403445777575*c6 + 1.2174687787169953*s6;
    const stanford_full_real h6_y = 1.193403445777575*s6 - 1.2174687787169953*c6;
    const stanford_full_real t1 = c6*c6;
    const stanford_full_real t2 = c6*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real k6_xy = 0.31745868108016423*(1.0 - 2.0*t1) - 0.010165845146380005*t2;
    const stanford_full_real k6_xz = -0.0625396920897071*s6 - 0.06483323523282834*c6;
    const stanford_full_real k6_yz = 0.0625396920897071*c6 - 0.06483323523282834*s6;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real fu5_x = -c5*h6_y;
    const stanford_full_real neg_fu5_y = s5*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu5_x = 0.6921471349584476*s5 - c5*k6_xz;
    const stanford_full_real neg_nu5_y = s5*k6_xz + 0.6921471349584476*c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_x = c4*fu5_x - s4*h6_x;
    const stanford_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu4_x = c4*nu5_x + s4*k6_yz;
    const stanford_full_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_6 = nu4_y + q[2]*fu4_x;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x = -c2*fu4_x - s2*neg_fu5_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y = s2*(nu4_x - q[2]*fu4_y) - c2*neg_nu5_y;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_6 = 0.1524*neg_fu2_x - nu2_y;
    const stanford_full_real t3 = 0.010165845146380005*t1 - 0.6349173621603285*t2;
    /* link 5: mass matrix, its row of this joint */
    const stanford_full_real m5_5 = 0.7289625214741676 - t3;
    const stanford_full_real t4 = h6_x - 0.5911078910549018;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h5_x = c5*t4 + 0.6468331423588011*s5;
    const stanford_full_real neg_h5_y = 0.6468331423588011*c5 - s5*t4;
    const stanford_full_real t5 = c5*c5;
    const stanford_full_real t6 = t3 - 0.37825268400268236;
    const stanford_full_real t7 = 0.060693211657558095 - k6_xz;
    const stanford_full_real t8 = c5*s5;
    const stanford_full_real t9 = t5*t6 + t7*(2.0*t8);
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real k5_yy = t9 - (t3 - 0.553607602738425);
    const stanford_full_real neg_k5_xy = t6*t8 + t7*(1.0 - 2.0*t5);
    const stanford_full_real t10 = k6_xy - 0.13660343902034475;
    const stanford_full_real t11 = k6_yz + 0.23560176217086468;
    const stanford_full_real k5_xz = c5*t10 + s5*t11;
    const stanford_full_real k5_yz = s5*t10 - c5*t11;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_x_2 = c4*neg_h5_y;
    const stanford_full_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu4_x_2 = -s4*m5_5 - c4*k5_xz;
    const stanford_full_real nu4_y_2 = c4*m5_5 - s4*k5_xz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_5 = nu4_y_2 + q[2]*fu4_x_2;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real fu2_x = c2*fu4_x_2 - s2*h5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y_2 = s2*(nu4_x_2 - q[2]*fu4_y_2) - c2*k5_yz;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_5 = -0.1524*fu2_x - nu2_y_2;
    /* link 4: mass matrix, its row of this joint */
    const stanford_full_real m4_4 = t3 - t9 + 2.017360749281895;
    const stanford_full_real t12 = h5_x + 0.9022885982543313;
    const stanford_full_real t13 = h6_y + 0.28054187970758354;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h4_x = c4*t12 - s4*t13;
    const stanford_full_real h4_y = s4*t12 + c4*t13;
    const stanford_full_real t14 = c4*c4;
    const stanford_full_real t15 = t3 + t9 + 0.976958493212842;
    const stanford_full_real t16 = 0.06784076259315977 - k5_xz;
    const stanford_full_real t17 = c4*s4;
    const stanford_full_real t18 = t14*t15 - t16*(2.0*t17);
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_full_real k4_xx = t3 + 1.4971596212473683 - t18;
    const stanford_full_real k4_yy = t18 - (t9 - 0.5202011280345263);
    const stanford_full_real k4_xy = t16*(1.0 - 2.0*t14) - t15*t17;
    const stanford_full_real t19 = neg_k5_xy - 0.002655628796226608;
    const stanford_full_real t20 = -k5_yz - 0.23523950726161555;
    const stanford_full_real k4_xz = c4*t19 - s4*t20;
    const stanford_full_real k4_yz = s4*t19 + c4*t20;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_4 = -q[2]*h4_y - k4_yz;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x_2 = c2*h4_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real neg_nu2_y = s2*(k4_xz + q[2]*h4_x) + c2*m4_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_4 = neg_nu2_y + 0.1524*neg_fu2_x_2;
    const stanford_full_real t21 = k4_yy - k5_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_full_real k3_zz = k4_yy - t21;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h3_x = h4_x + 0.22200183325724177;
    const stanford_full_real h3_y = h4_y + 0.4516316755890639;
    const stanford_full_real h3_z = neg_h5_y + 0.012168751997232599;
    const stanford_full_real t22 = k5_yy + t21;
    const stanford_full_real t23 = k4_xx - t22;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_full_real k3_xx = t22 + t23;
    const stanford_full_real k3_yy = k4_xx - t23;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_3 = s2*(-h4_y - 3.45891628872104);
    const stanford_full_real t24 = 19.732838668844984*q[2];
    const stanford_full_real t25 = q[2]*(-2.0*h3_z - t24) - k3_zz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_2 = 0.7467006423132752 - (t25 - k3_xx);
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h2_y = s2*(h4_x + 0.3708972318890874) - c2*(h3_z + t24 +
        0.5558718199714463);
    const stanford_full_real t26 = c2*c2*(0.49862309142001715 - (k3_xx + t25)) - (k4_xz + q[2]*h3_x
        - 0.04911220265093226)*(2.0*(c2*s2));
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k2_xx = t25 - 0.6226618668666462 + t26;
    const stanford_full_real k2_yz = s2*(k4_xy + 0.0511982033036484) - c2*(k4_yz + q[2]*h3_y +
        0.06807816021551473);
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_2 = k2_yz + 0.1524*h2_y;
    const stanford_full_real m1_1 = k3_yy + 0.1524*(3.0072846131319757 + 2.0*h3_y) - neg_k2_xx +
        1.1129758995253813;
    const stanford_full_real t27 = -h3_x;
    const stanford_full_real t28 = -h5_x;
    const stanford_full_real t29 = -k6_yz;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = m1_6;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = t27;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = m1_3;
    M[13] = t27;
    M[14] = 19.732838668844984;
    M[15] = 0.0;
    M[16] = t28;
    M[17] = neg_fu5_y;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = 0.0;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = t28;
    M[27] = k5_yz;
    M[28] = m5_5;
    M[29] = t29;
    M[30] = m1_6;
    M[31] = m2_6;
    M[32] = neg_fu5_y;
    M[33] = neg_nu5_y;
    M[34] = t29;
    M[35] = 0.6921471349584476;
}

/* accelerations that the torques tau give
 * 402 multiplications, 354 additions, 6 divisions = 762; 20 unary minus; 8 sine/cosine */
void stanford_full_forward_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real tau[6],
    stanford_full_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(again[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(again[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(again[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(again[5]);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_x = 1.193403445777575*c6 + 1.2174687787169953*s6;
    const stanford_full_real neg_h6_y = 1.2174687787169953*c6 - 1.193403445777575*s6;
    const stanford_full_real t1 = c6*c6;
    const stanford_full_real t2 = c6*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real k6_xy = 0.31745868108016423*(1.0 - 2.0*t1) - 0.010165845146380005*t2;
    const stanford_full_real k6_xz = -0.0625396920897071*s6 - 0.06483323523282834*c6;
    const stanford_full_real k6_yz = 0.0625396920897071*c6 - 0.06483323523282834*s6;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real fu5_x = c5*neg_h6_y;
    const stanford_full_real fu5_y = s5*neg_h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu5_x = 0.6921471349584476*s5 - c5*k6_xz;
    const stanford_full_real nu5_y = -0.6921471349584476*c5 - s5*k6_xz;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_x = c4*fu5_x - s4*h6_x;
    const stanford_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu4_x = c4*nu5_x + s4*k6_yz;
    const stanford_full_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_6 = nu4_y + q[2]*fu4_x;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x = s2*fu5_y - c2*fu4_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y = s2*(nu4_x - q[2]*fu4_y) + c2*nu5_y;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_6 = 0.1524*neg_fu2_x - nu2_y;
    const stanford_full_real t3 = 0.010165845146380005*t1 - 0.6349173621603285*t2;
    /* link 5: mass matrix, its row of this joint */
    const stanford_full_real m5_5 = 0.7289625214741676 - t3;
    const stanford_full_real t4 = h6_x - 0.5911078910549018;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h5_x = c5*t4 + 0.6468331423588011*s5;
    const stanford_full_real neg_h5_y = 0.6468331423588011*c5 - s5*t4;
    const stanford_full_real t5 = c5*c5;
    const stanford_full_real t6 = t3 - 0.37825268400268236;
    const stanford_full_real t7 = 0.060693211657558095 - k6_xz;
    const stanford_full_real t8 = c5*s5;
    const stanford_full_real t9 = t5*t6 + t7*(2.0*t8);
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real k5_yy = t9 - (t3 - 0.553607602738425);
    const stanford_full_real neg_k5_xy = t6*t8 + t7*(1.0 - 2.0*t5);
    const stanford_full_real t10 = k6_xy - 0.13660343902034475;
    const stanford_full_real t11 = k6_yz + 0.23560176217086468;
    const stanford_full_real k5_xz = c5*t10 + s5*t11;
    const stanford_full_real k5_yz = s5*t10 - c5*t11;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_x_2 = c4*neg_h5_y;
    const stanford_full_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu4_x_2 = -s4*m5_5 - c4*k5_xz;
    const stanford_full_real nu4_y_2 = c4*m5_5 - s4*k5_xz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_5 = nu4_y_2 + q[2]*fu4_x_2;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real fu2_x = c2*fu4_x_2 - s2*h5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y_2 = s2*(nu4_x_2 - q[2]*fu4_y_2) - c2*k5_yz;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_5 = -0.1524*fu2_x - nu2_y_2;
    /* link 4: mass matrix, its row of this joint */
    const stanford_full_real m4_4 = t3 - t9 + 2.017360749281895;
    const stanford_full_real t12 = h5_x + 0.9022885982543313;
    const stanford_full_real t13 = 0.28054187970758354 - neg_h6_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h4_x = c4*t12 - s4*t13;
    const stanford_full_real h4_y = s4*t12 + c4*t13;
    const stanford_full_real t14 = c4*c4;
    const stanford_full_real t15 = t3 + t9 + 0.976958493212842;
    const stanford_full_real t16 = 0.06784076259315977 - k5_xz;
    const stanford_full_real t17 = c4*s4;
    const stanford_full_real t18 = t14*t15 - t16*(2.0*t17);
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_full_real k4_xx = t3 + 1.4971596212473683 - t18;
    const stanford_full_real k4_yy = t18 - (t9 - 0.5202011280345263);
    const stanford_full_real k4_xy = t16*(1.0 - 2.0*t14) - t15*t17;
    const stanford_full_real t19 = neg_k5_xy - 0.002655628796226608;
    const stanford_full_real t20 = -k5_yz - 0.23523950726161555;
    const stanford_full_real k4_xz = c4*t19 - s4*t20;
    const stanford_full_real k4_yz = s4*t19 + c4*t20;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_4 = -q[2]*h4_y - k4_yz;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x_2 = c2*h4_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real neg_nu2_y = s2*(k4_xz + q[2]*h4_x) + c2*m4_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_4 = neg_nu2_y + 0.1524*neg_fu2_x_2;
    const stanford_full_real t21 = k4_yy - k5_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_full_real k3_zz = k4_yy - t21;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h3_x = h4_x + 0.22200183325724177;
    const stanford_full_real h3_y = h4_y + 0.4516316755890639;
    const stanford_full_real h3_z = neg_h5_y + 0.012168751997232599;
    const stanford_full_real t22 = k5_yy + t21;
    const stanford_full_real t23 = k4_xx - t22;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_full_real k3_xx = t22 + t23;
    const stanford_full_real k3_yy = k4_xx - t23;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_3 = s2*(-h4_y - 3.45891628872104);
    const stanford_full_real t24 = 19.732838668844984*q[2];
    const stanford_full_real t25 = q[2]*(-2.0*h3_z - t24) - k3_zz;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_2 = 0.7467006423132752 - (t25 - k3_xx);
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h2_y = s2*(h4_x + 0.3708972318890874) - c2*(h3_z + t24 +
        0.5558718199714463);
    const stanford_full_real t26 = c2*c2*(0.49862309142001715 - (k3_xx + t25)) - (k4_xz + q[2]*h3_x
        - 0.04911220265093226)*(2.0*(c2*s2));
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k2_xx = t25 - 0.6226618668666462 + t26;
    const stanford_full_real k2_yz = s2*(k4_xy + 0.0511982033036484) - c2*(k4_yz + q[2]*h3_y +
        0.06807816021551473);
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_2 = k2_yz + 0.1524*h2_y;
    const stanford_full_real m1_1 = k3_yy + 0.1524*(3.0072846131319757 + 2.0*h3_y) - neg_k2_xx +
        1.1129758995253813;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a2_z = -0.1524*ww1_zz;
    const stanford_full_real t27 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real w2_x = t27*s2;
    const stanford_full_real w2_y = t27*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2;
    const stanford_full_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_full_real alpha2_x = qd[1]*w2_y;
    const stanford_full_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = w2_x*w2_y;
    const stanford_full_real neg_ww2_xx = -w2_x*w2_x;
    const stanford_full_real ww2_yy = w2_y*w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const stanford_full_real lam2_22 = neg_ww2_xx - ww2_zz;
    const stanford_full_real lam2_32 = 2.0*alpha2_x;
    const stanford_full_real lam2_33 = neg_ww2_xx - ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a3_z = neg_a2_y + q[2]*lam2_22;
    const stanford_full_real t28 = 2.0*qd[2];
    const stanford_full_real a3_x = qd[1]*t28 - (neg_a2_x + q[2]*ww2_xy);
    const stanford_full_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t28;
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_full_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_full_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = c4*alpha2_x + qd[3]*w4_y;
    const stanford_full_real alpha4_y = -qd[3]*w4_x - s4*alpha2_x;
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real ww4_yz = w4_y*w4_z;
    const stanford_full_real ww4_zx = w4_x*w4_z;
    const stanford_full_real ww4_xy = w4_x*w4_y;
    const stanford_full_real ww4_xx = w4_x*w4_x;
    const stanford_full_real ww4_yy = w4_y*w4_y;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const stanford_full_real lam4_12 = alpha2_y + ww4_xy;
    const stanford_full_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_full_real lam4_21 = ww4_xy - alpha2_y;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_full_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_full_real t29 = -c5;
    const stanford_full_real w5_y = t29*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_x = c5*a4_x - s5*a3_z;
    const stanford_full_real a5_y = t29*a3_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_x = qd[4]*w5_y - (-s5*alpha2_y - c5*alpha4_x);
    const stanford_full_real alpha5_y = c5*alpha2_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real ww5_yz = w5_y*w5_z;
    const stanford_full_real ww5_zx = w5_x*w5_z;
    const stanford_full_real ww5_xy = w5_x*w5_y;
    const stanford_full_real ww5_xx = w5_x*w5_x;
    const stanford_full_real ww5_yy = w5_y*w5_y;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const stanford_full_real lam5_12 = ww5_xy - alpha4_y;
    const stanford_full_real lam5_13 = alpha5_y + ww5_zx;
    const stanford_full_real lam5_21 = alpha4_y + ww5_xy;
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_full_real lam5_23 = ww5_yz - alpha5_x;
    const stanford_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const stanford_full_real lam5_32 = alpha5_x + ww5_yz;
    const stanford_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a6_x = c6*a5_x + s6*a4_y;
    const stanford_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const stanford_full_real alpha6_x = qd[5]*w6_y - (-s6*alpha4_y - c6*alpha5_x);
    const stanford_full_real alpha6_y = c6*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_yz = w6_y*w6_z;
    const stanford_full_real ww6_zx = w6_x*w6_z;
    const stanford_full_real ww6_xy = w6_x*w6_y;
    const stanford_full_real ww6_xx = w6_x*w6_x;
    const stanford_full_real ww6_yy = w6_y*w6_y;
    const stanford_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const stanford_full_real lam6_12 = alpha5_y + ww6_xy;
    const stanford_full_real lam6_13 = alpha6_y + ww6_zx;
    const stanford_full_real lam6_21 = ww6_xy - alpha5_y;
    const stanford_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const stanford_full_real lam6_23 = ww6_yz - alpha6_x;
    const stanford_full_real lam6_31 = ww6_zx - alpha6_y;
    const stanford_full_real lam6_32 = alpha6_x + ww6_yz;
    const stanford_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const stanford_full_real fc2_x = -0.14889539863184567*neg_lam2_11 - 0.5558718199714463*ww2_xy;
    const stanford_full_real fc2_y = 0.14889539863184567*ww2_xy - 0.5558718199714463*lam2_22;
    /* link 2: moment that turns the link [N m] */
    const stanford_full_real nc2_x = 0.0847148653636484*ww1_zz - (0.06807816021551473*(lam2_33 -
        lam2_22) - 1.2453237337332923*alpha2_x + (0.09822440530186452*alpha2_y +
        0.0511982033036484*ww2_xy));
    const stanford_full_real nc2_y = 0.248077550893258*alpha2_y - 0.0511982033036484*(neg_lam2_11 +
        lam2_33) - (0.06807816021551473*ww2_xy + 0.09822440530186452*alpha2_x) +
        0.02269165875149328*ww1_zz;
    const stanford_full_real neg_nc2_z = 0.49862309142001715*ww2_xy -
        0.04911220265093226*(neg_lam2_11 + lam2_22) + (1.4591749065920876*c2 +
        5.4475438357201735*s2);
    /* link 3: force that moves the link [N] */
    const stanford_full_real fc3_x = 19.732838668844984*a3_x - (0.22200183325724177*neg_lam2_11 +
        0.012168751997232599*ww2_xy);
    const stanford_full_real fc3_y = 19.732838668844984*a3_y - (0.44400366651448353*alpha2_y -
        0.4516316755890639*lam2_33 + 0.024337503994465198*alpha2_x);
    const stanford_full_real fc3_z = 19.732838668844984*a3_z - (0.22200183325724177*ww2_xy -
        0.012168751997232599*lam2_22);
    /* link 3: moment that turns the link [N m] */
    const stanford_full_real nc3_x = 0.4516316755890639*a3_z - 0.012168751997232599*a3_y;
    const stanford_full_real nc3_y = 0.012168751997232599*a3_x - 0.22200183325724177*a3_z;
    const stanford_full_real nc3_z = 0.22200183325724177*a3_y - 0.4516316755890639*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_full_real fc4_x = 0.28054187970758354*lam4_12 - 0.9022885982543313*neg_lam4_11;
    const stanford_full_real fc4_y = 0.9022885982543313*lam4_21 - 0.28054187970758354*neg_lam4_22;
    const stanford_full_real fc4_z = 0.9022885982543313*lam4_31 + 0.28054187970758354*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_full_real nc4_x = 0.28054187970758354*a3_z - (0.23523950726161555*(neg_lam4_22 -
        neg_lam4_33) - 1.1561689763413345*lam4_32 - (0.002655628796226608*lam4_21 -
        0.06784076259315977*lam4_31));
    const stanford_full_real nc4_y = 0.002655628796226608*(neg_lam4_11 - neg_lam4_33) -
        0.3448462092987837*lam4_31 - (0.23523950726161555*lam4_12 - 0.06784076259315977*lam4_32) -
        0.9022885982543313*a3_z;
    const stanford_full_real t30 = 1.1561689763413345*lam4_12 - 0.3448462092987837*lam4_21 +
        0.06784076259315977*(neg_lam4_11 - neg_lam4_22) + (0.002655628796226608*lam4_23 -
        0.23523950726161555*lam4_13);
    const stanford_full_real nc4_z = 0.9022885982543313*a4_y - 0.28054187970758354*a4_x - t30;
    /* link 5: force that moves the link [N] */
    const stanford_full_real fc5_x = 0.5911078910549018*neg_lam5_11 - 0.6468331423588011*lam5_12;
    const stanford_full_real fc5_y = 0.6468331423588011*neg_lam5_22 - 0.5911078910549018*lam5_21;
    const stanford_full_real fc5_z = 0.5911078910549018*neg_lam5_31 - 0.6468331423588011*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_full_real neg_nc5_x = 0.23560176217086468*(neg_lam5_22 - neg_lam5_33) -
        0.17535491873574263*lam5_32 + (0.060693211657558095*neg_lam5_31 -
        0.13660343902034475*lam5_21) + 0.6468331423588011*a4_y;
    const stanford_full_real nc5_y = 0.20245111268601115*neg_lam5_31 +
        0.13660343902034475*(neg_lam5_11 - neg_lam5_33) + (-0.23560176217086468*lam5_12 -
        0.060693211657558095*lam5_32) + 0.5911078910549018*a4_y;
    const stanford_full_real t31 = 0.20245111268601115*lam5_21 - 0.17535491873574263*lam5_12 -
        0.060693211657558095*(neg_lam5_22 - neg_lam5_11) - (0.13660343902034475*lam5_23 -
        0.23560176217086468*lam5_13);
    const stanford_full_real nc5_z = t31 - (0.5911078910549018*a5_y - 0.6468331423588011*a5_x);
    /* link 6: force that moves the link [N] */
    const stanford_full_real fc6_x = -1.193403445777575*neg_lam6_11 - 1.2174687787169953*lam6_12;
    const stanford_full_real fc6_y = 1.193403445777575*lam6_21 + 1.2174687787169953*neg_lam6_22;
    const stanford_full_real fc6_z = 1.193403445777575*lam6_31 - 1.2174687787169953*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_x = 1.2174687787169953*a5_y - (-0.35115649005241384*lam6_32 -
        0.0625396920897071*(neg_lam6_22 - neg_lam6_33) - (0.06483323523282834*lam6_21 -
        0.31745868108016423*lam6_31));
    const stanford_full_real nc6_y = 0.06483323523282834*(neg_lam6_11 - neg_lam6_33) -
        0.3409906449060338*lam6_31 + (0.0625396920897071*lam6_12 + 0.31745868108016423*lam6_32) +
        1.193403445777575*a5_y;
    const stanford_full_real t32 = 0.35115649005241384*lam6_12 - 0.3409906449060338*lam6_21 +
        0.31745868108016423*(neg_lam6_11 - neg_lam6_22) + (0.06483323523282834*lam6_23 +
        0.0625396920897071*lam6_13);
    const stanford_full_real nc6_z = 1.193403445777575*a6_y + 1.2174687787169953*a6_x - t32;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const stanford_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_x = n06_x - neg_nc5_x;
    const stanford_full_real n5_y = nc5_y - nc6_z;
    const stanford_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const stanford_full_real f5_x = fc5_x + f06_x;
    const stanford_full_real f5_y = fc5_y - fc6_z;
    const stanford_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f05_x = c5*f5_x - s5*f5_y;
    const stanford_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = nc4_x + n05_x;
    const stanford_full_real n4_y = nc4_y + n5_z;
    const stanford_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_full_real f4_x = fc4_x + f05_x;
    const stanford_full_real f4_y = fc4_y + f5_z;
    const stanford_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n3_x = nc3_x + n04_x;
    const stanford_full_real n3_y = nc3_y + n04_y;
    const stanford_full_real n3_z = nc3_z + n4_z;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_x = fc3_x + f04_x;
    const stanford_full_real f3_y = fc3_y + f04_y;
    const stanford_full_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_full_real n2_y = nc2_y - n3_z;
    const stanford_full_real n2_z = n3_y + (q[2]*f3_x - neg_nc2_z);
    /* link 2: force through the joint [N] */
    const stanford_full_real f2_x = fc2_x + f3_x;
    const stanford_full_real f2_y = fc2_y - f3_z;
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_full_real f02_x = c2*f2_x - s2*f2_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_full_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = -0.1524*f02_x - n02_y;
    /* link 1: forward substitution */
    const stanford_full_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const stanford_full_real ipivot1 = 1.0 / m1_1;
    const stanford_full_real l2_1 = m1_2*ipivot1;
    const stanford_full_real l3_1 = m1_3*ipivot1;
    const stanford_full_real l4_1 = m1_4*ipivot1;
    const stanford_full_real l5_1 = m1_5*ipivot1;
    const stanford_full_real l6_1 = m1_6*ipivot1;
    const stanford_full_real pivot2 = m2_2 - m1_2*l2_1;
    const stanford_full_real ipivot2 = 1.0 / pivot2;
    const stanford_full_real ld3_2 = -h3_x - m1_2*l3_1;
    const stanford_full_real l3_2 = ipivot2*ld3_2;
    const stanford_full_real ld4_2 = m2_4 - m1_2*l4_1;
    const stanford_full_real l4_2 = ipivot2*ld4_2;
    const stanford_full_real ld5_2 = m2_5 - m1_2*l5_1;
    const stanford_full_real l5_2 = ipivot2*ld5_2;
    const stanford_full_real ld6_2 = m2_6 - m1_2*l6_1;
    const stanford_full_real l6_2 = ipivot2*ld6_2;
    const stanford_full_real pivot3 = 19.732838668844984 - m1_3*l3_1 - ld3_2*l3_2;
    const stanford_full_real ipivot3 = 1.0 / pivot3;
    const stanford_full_real ld4_3 = -m1_3*l4_1 - ld3_2*l4_2;
    const stanford_full_real l4_3 = ipivot3*ld4_3;
    const stanford_full_real t33 = -ld3_2;
    const stanford_full_real ld5_3 = t33*l5_2 - (h5_x + m1_3*l5_1);
    const stanford_full_real l5_3 = ipivot3*ld5_3;
    const stanford_full_real ld6_3 = t33*l6_2 - (fu5_y + m1_3*l6_1);
    const stanford_full_real l6_3 = ipivot3*ld6_3;
    const stanford_full_real pivot4 = m4_4 - m1_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const stanford_full_real ipivot4 = 1.0 / pivot4;
    const stanford_full_real ld5_4 = -ld4_3*l5_3 - (m1_4*l5_1 - k5_yz + ld4_2*l5_2);
    const stanford_full_real l5_4 = ipivot4*ld5_4;
    const stanford_full_real ld6_4 = -ld4_2*l6_2 - (nu5_y + m1_4*l6_1) - ld4_3*l6_3;
    const stanford_full_real l6_4 = ipivot4*ld6_4;
    const stanford_full_real pivot5 = -ld5_4*l5_4 - (ld5_2*l5_2 - (m5_5 - m1_5*l5_1) + ld5_3*l5_3);
    const stanford_full_real ipivot5 = 1.0 / pivot5;
    const stanford_full_real ld6_5 = -ld5_2*l6_2 - (k6_yz + m1_5*l6_1) - ld5_3*l6_3 - ld5_4*l6_4;
    const stanford_full_real l6_5 = ipivot5*ld6_5;
    const stanford_full_real pivot6 = 0.6921471349584476 - m1_6*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 -
        ld6_4*l6_4 - ld6_5*l6_5;
    const stanford_full_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const stanford_full_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const stanford_full_real y3 = tau[2] - f3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const stanford_full_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const stanford_full_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const stanford_full_real y6 = tau[5] - nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd3 = ipivot3*y3 - l4_3*qdd4 - l5_3*qdd5 - l6_3*qdd6;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd2 = -l5_2*qdd5 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4) - l6_2*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd1 = -l6_1*qdd6 - (l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 +
        l5_1*qdd5);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
