/*
 * stanford_d3: Stanford arm, the set of the thesis's listing D.3.2
 * Numbers: the 1990 thesis, listing D.3.2 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
 *   tables
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
 *   inverse_dynamics: 128 multiplications, 97 additions = 225; 5 unary minus; 8 sine/cosine
 *   gravity: 25 multiplications, 10 additions = 35; 0 unary minus; 6 sine/cosine
 *   bias: 120 multiplications, 81 additions = 201; 6 unary minus; 8 sine/cosine
 *   mass_matrix: 56 multiplications, 44 additions = 100; 3 unary minus; 6 sine/cosine
 *   forward_dynamics: 262 multiplications, 192 additions, 6 divisions = 460; 15 unary minus; 8
 *       sine/cosine
 */
#include "stanford_d3.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 128 multiplications, 97 additions = 225; 5 unary minus; 8 sine/cosine */
void stanford_d3_inverse_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real qdd[6],
    stanford_d3_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_d3_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(again[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(again[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(again[4]);
    const stanford_d3_real c6 = cos(q[5]);
    const stanford_d3_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_z = -0.1524*ww1_zz;
    const stanford_d3_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real w2_x = t1*s2;
    const stanford_d3_real w2_y = t1*c2;
    const stanford_d3_real t2 = 0.1524*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_x = -9.8*s2 - c2*t2;
    const stanford_d3_real a2_y = s2*t2 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww2_yz = qd[1]*w2_y;
    const stanford_d3_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha2_x = ww2_yz - qdd[0]*s2;
    const stanford_d3_real alpha2_y = -qdd[0]*c2 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww2_xy = w2_x*w2_y;
    const stanford_d3_real ww2_xx = w2_x*w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam2_12 = ww2_xy - qdd[1];
    const stanford_d3_real lam2_21 = qdd[1] + ww2_xy;
    const stanford_d3_real lam2_22 = -ww2_xx - ww2_zz;
    const stanford_d3_real neg_lam2_31 = alpha2_y - ww2_zx;
    const stanford_d3_real lam2_32 = ww2_yz + alpha2_x;
    const stanford_d3_real t3 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a3_x = a2_x - q[2]*lam2_12 + qd[1]*t3;
    const stanford_d3_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t3;
    const stanford_d3_real a3_z = qdd[2] - (a2_y - q[2]*lam2_22);
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_d3_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_x = qd[3]*w4_y - (-qdd[1]*s4 - c4*alpha2_x);
    const stanford_d3_real alpha4_y = qdd[1]*c4 - s4*alpha2_x - qd[3]*w4_x;
    const stanford_d3_real alpha4_z = qdd[3] - alpha2_y;
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    const stanford_d3_real ww4_zx = w4_x*w4_z;
    const stanford_d3_real ww4_xy = w4_x*w4_y;
    const stanford_d3_real ww4_xx = w4_x*w4_x;
    const stanford_d3_real ww4_yy = w4_y*w4_y;
    const stanford_d3_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_12 = ww4_xy - alpha4_z;
    const stanford_d3_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_d3_real lam4_21 = alpha4_z + ww4_xy;
    const stanford_d3_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_d3_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_d3_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_d3_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_d3_real t4 = -c5;
    const stanford_d3_real w5_y = t4*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = c5*a4_x - s5*a3_z;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = t4*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
    const stanford_d3_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww5_zx = w5_x*w5_z;
    const stanford_d3_real ww5_xy = w5_x*w5_y;
    const stanford_d3_real ww5_xx = w5_x*w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha5_z;
    const stanford_d3_real lam5_21 = alpha5_z + ww5_xy;
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_d3_real neg_lam5_31 = alpha5_y - ww5_zx;
    const stanford_d3_real lam5_32 = w5_y*(qd[4] + w5_z) - (s5*alpha4_z - c5*alpha4_x);
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_d3_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww6_yz = w6_y*w6_z;
    const stanford_d3_real ww6_zx = w6_x*w6_z;
    /* link 1: moment that turns the link [N m] */
    const stanford_d3_real nc1_z = 0.3436532925*qdd[0];
    /* link 2: moment that turns the link [N m] */
    const stanford_d3_real nc2_x = 5.3340532937*lam2_32;
    const stanford_d3_real nc2_y = 1.1015*neg_lam2_31;
    const stanford_d3_real nc2_z = 1.1015*lam2_21 - 5.3340532937*lam2_12;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 6.47*a3_x + 2.749911*lam2_12;
    const stanford_d3_real fc3_y = 6.47*a3_y + 2.749911*lam2_32;
    const stanford_d3_real fc3_z = 6.47*a3_z - 2.749911*lam2_22;
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = 2.749911*a3_y;
    const stanford_d3_real neg_nc3_y = 2.749911*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real neg_fc4_x = 0.005832*lam4_12;
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real fc4_z = -0.005832*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_d3_real nc4_y = 5.36544e-05*lam4_12 - 0.053*lam4_31;
    const stanford_d3_real neg_nc4_x = -0.0057314928*lam4_32 - 5.36544e-05*(neg_lam4_22 -
        neg_lam4_33) + 0.005832*a3_z;
    const stanford_d3_real nc4_z = 0.053*lam4_21 - 0.0057314928*lam4_12 - 5.36544e-05*lam4_13 +
        0.005832*a4_x;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_x = -0.114912*lam5_12;
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    const stanford_d3_real neg_fc5_z = 0.114912*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_d3_real nc5_y = 0.0487*neg_lam5_31;
    const stanford_d3_real nc5_x = 0.0786343144*lam5_32 - 0.114912*a4_y;
    const stanford_d3_real nc5_z = 0.0487*lam5_21 - 0.0786343144*lam5_12 + 0.114912*a5_x;
    /* link 6: moment that turns the link [N m] */
    const stanford_d3_real nc6_x = 0.0203*ww6_yz;
    const stanford_d3_real nc6_y = -0.0203*ww6_zx;
    const stanford_d3_real nc6_z = 0.0203*alpha6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_d3_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_x = nc5_x + n06_x;
    const stanford_d3_real n5_y = nc5_y - nc6_z;
    const stanford_d3_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f05_x = c5*fc5_x - s5*fc5_y;
    const stanford_d3_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_d3_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_x = n05_x - neg_nc4_x;
    const stanford_d3_real n4_y = nc4_y + n5_z;
    const stanford_d3_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_x = f05_x - neg_fc4_x;
    const stanford_d3_real f4_y = fc4_y - neg_fc5_z;
    const stanford_d3_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_d3_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_d3_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n3_x = nc3_x + n04_x;
    const stanford_d3_real n3_y = n04_y - neg_nc3_y;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x + f04_x;
    const stanford_d3_real f3_y = fc3_y + f04_y;
    const stanford_d3_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_d3_real n2_y = nc2_y - n4_z;
    const stanford_d3_real n2_z = n3_y + (nc2_z + q[2]*f3_x);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f02_x = c2*f3_x + s2*f3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = nc1_z - 0.1524*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 25 multiplications, 10 additions = 35; 0 unary minus; 6 sine/cosine */
void stanford_d3_gravity(const stanford_d3_real q[6], stanford_d3_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_d3_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(again[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(again[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(again[4]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_x = -9.8*s2;
    const stanford_d3_real a2_y = -9.8*c2;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_x = c4*a2_x;
    const stanford_d3_real neg_a4_y = s4*a2_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = c5*a4_x + s5*a2_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = -63.406*s2;
    const stanford_d3_real fc3_z = 63.406*c2;
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_y = 26.9491278*s2;
    /* link 4: moment that turns the link [N m] */
    const stanford_d3_real neg_nc4_x = 0.0571536*c2;
    const stanford_d3_real nc4_z = 0.005832*a4_x;
    /* link 5: moment that turns the link [N m] */
    const stanford_d3_real nc5_x = 0.114912*neg_a4_y;
    const stanford_d3_real nc5_z = 0.114912*a5_x;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n05_x = c5*nc5_x;
    const stanford_d3_real n05_y = s5*nc5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_x = n05_x - neg_nc4_x;
    const stanford_d3_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n04_x = c4*n4_x - s4*nc5_z;
    const stanford_d3_real n04_y = s4*n4_x + c4*nc5_z;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n3_y = nc3_y + n04_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_z = n3_y + q[2]*fc3_x;
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f02_x = c2*fc3_x + s2*fc3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real neg_n02_y = c2*n4_z - s2*n04_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = neg_n02_y - 0.1524*f02_x;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 120 multiplications, 81 additions = 201; 6 unary minus; 8 sine/cosine */
void stanford_d3_bias(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    stanford_d3_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_d3_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(again[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(again[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(again[4]);
    const stanford_d3_real c6 = cos(q[5]);
    const stanford_d3_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_z = -0.1524*ww1_zz;
    const stanford_d3_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real w2_x = t1*s2;
    const stanford_d3_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a2_x = 9.8*s2;
    const stanford_d3_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha2_x = qd[1]*w2_y;
    const stanford_d3_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww2_xy = w2_x*w2_y;
    const stanford_d3_real ww2_xx = w2_x*w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam2_22 = -ww2_xx - ww2_zz;
    const stanford_d3_real lam2_32 = 2.0*alpha2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a3_z = neg_a2_y + q[2]*lam2_22;
    const stanford_d3_real t2 = 2.0*qd[2];
    const stanford_d3_real a3_x = qd[1]*t2 - (neg_a2_x + q[2]*ww2_xy);
    const stanford_d3_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t2;
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_d3_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_x = c4*alpha2_x + qd[3]*w4_y;
    const stanford_d3_real alpha4_y = -qd[3]*w4_x - s4*alpha2_x;
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    const stanford_d3_real ww4_zx = w4_x*w4_z;
    const stanford_d3_real ww4_xy = w4_x*w4_y;
    const stanford_d3_real ww4_xx = w4_x*w4_x;
    const stanford_d3_real ww4_yy = w4_y*w4_y;
    const stanford_d3_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_12 = ww4_xy - neg_alpha2_y;
    const stanford_d3_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_d3_real lam4_21 = neg_alpha2_y + ww4_xy;
    const stanford_d3_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_d3_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_d3_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_d3_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_d3_real w5_y = -c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = c5*a4_x - s5*a3_z;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = -s5*alpha4_x - c5*neg_alpha2_y - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww5_zx = w5_x*w5_z;
    const stanford_d3_real ww5_xy = w5_x*w5_y;
    const stanford_d3_real ww5_xx = w5_x*w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha4_y;
    const stanford_d3_real lam5_21 = alpha4_y + ww5_xy;
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_d3_real neg_lam5_31 = alpha5_y - ww5_zx;
    const stanford_d3_real lam5_32 = w5_y*(qd[4] + w5_z) - (s5*neg_alpha2_y - c5*alpha4_x);
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_d3_real w6_y = c6*w5_z - s6*w5_x;
    const stanford_d3_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww6_yz = w6_y*w6_z;
    const stanford_d3_real ww6_zx = w6_x*w6_z;
    /* link 2: moment that turns the link [N m] */
    const stanford_d3_real nc2_x = 10.6681065874*alpha2_x;
    const stanford_d3_real nc2_y = -2.203*neg_alpha2_y;
    const stanford_d3_real neg_nc2_z = 4.2325532937*ww2_xy;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 6.47*a3_x + 2.749911*ww2_xy;
    const stanford_d3_real fc3_y = 6.47*a3_y + 5.499822*alpha2_x;
    const stanford_d3_real fc3_z = 6.47*a3_z - 2.749911*lam2_22;
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = 2.749911*a3_y;
    const stanford_d3_real neg_nc3_y = 2.749911*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real neg_fc4_x = 0.005832*lam4_12;
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real fc4_z = -0.005832*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_d3_real nc4_y = 5.36544e-05*lam4_12 - 0.053*lam4_31;
    const stanford_d3_real neg_nc4_x = -0.0057314928*lam4_32 - 5.36544e-05*(neg_lam4_22 -
        neg_lam4_33) + 0.005832*a3_z;
    const stanford_d3_real nc4_z = 0.005832*a4_x - (0.0057314928*lam4_12 - 0.053*lam4_21 +
        5.36544e-05*lam4_13);
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_x = -0.114912*lam5_12;
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    const stanford_d3_real neg_fc5_z = 0.114912*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_d3_real nc5_y = 0.0487*neg_lam5_31;
    const stanford_d3_real nc5_x = 0.0786343144*lam5_32 - 0.114912*a4_y;
    const stanford_d3_real nc5_z = 0.0487*lam5_21 - 0.0786343144*lam5_12 + 0.114912*a5_x;
    /* link 6: moment that turns the link [N m] */
    const stanford_d3_real nc6_x = 0.0203*ww6_yz;
    const stanford_d3_real nc6_y = -0.0203*ww6_zx;
    const stanford_d3_real nc6_z = -0.0203*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_d3_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_x = nc5_x + n06_x;
    const stanford_d3_real n5_y = nc5_y - nc6_z;
    const stanford_d3_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f05_x = c5*fc5_x - s5*fc5_y;
    const stanford_d3_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_d3_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_x = n05_x - neg_nc4_x;
    const stanford_d3_real n4_y = nc4_y + n5_z;
    const stanford_d3_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_x = f05_x - neg_fc4_x;
    const stanford_d3_real f4_y = fc4_y - neg_fc5_z;
    const stanford_d3_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_d3_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_d3_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n3_x = nc3_x + n04_x;
    const stanford_d3_real n3_y = n04_y - neg_nc3_y;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x + f04_x;
    const stanford_d3_real f3_y = fc3_y + f04_y;
    const stanford_d3_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_d3_real n2_y = nc2_y - n4_z;
    const stanford_d3_real n2_z = n3_y + (q[2]*f3_x - neg_nc2_z);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real neg_f02_x = -s2*f3_z - c2*f3_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = 0.1524*neg_f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 56 multiplications, 44 additions = 100; 3 unary minus; 6 sine/cosine */
void stanford_d3_mass_matrix(const stanford_d3_real q[6], stanford_d3_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_d3_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(again[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(again[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(again[4]);
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu5_x = 0.0203*s5;
    const stanford_d3_real neg_nu5_y = 0.0203*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu4_x = c4*nu5_x;
    const stanford_d3_real nu4_y = s4*nu5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y = c2*neg_nu5_y - s2*nu4_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h5_x = 0.114912*s5;
    const stanford_d3_real neg_h5_y = 0.114912*c5;
    const stanford_d3_real t1 = 0.0096343144*(c5*c5);
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_d3_real k5_yy = t1 + 0.05885;
    const stanford_d3_real k5_xy = -0.0096343144*(c5*s5);
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu4_x = c4*neg_h5_y;
    const stanford_d3_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu4_x = 0.1273343144*s4;
    const stanford_d3_real nu4_y_2 = 0.1273343144*c4;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_5 = nu4_y_2 + q[2]*fu4_x;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x = c2*fu4_x - s2*h5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y_2 = s2*(neg_nu4_x + q[2]*fu4_y);
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_5 = neg_nu2_y_2 - 0.1524*fu2_x;
    /* link 4: mass matrix, its row of this joint */
    const stanford_d3_real m4_4 = 0.1373658072 - t1;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h4_x = c4*h5_x + 0.005832*s4;
    const stanford_d3_real neg_h4_y = 0.005832*c4 - s4*h5_x;
    const stanford_d3_real t2 = t1 - 0.1056028216;
    const stanford_d3_real t3 = c4*c4*t2;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_d3_real k4_xx = 0.0158814928 - t3;
    const stanford_d3_real k4_yy = t3 - (t1 - 0.1214843144);
    const stanford_d3_real k4_xy = t2*(-c4*s4);
    const stanford_d3_real k4_xz = -5.36544e-05*s4 - c4*k5_xy;
    const stanford_d3_real k4_yz = 5.36544e-05*c4 - s4*k5_xy;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_4 = q[2]*neg_h4_y - k4_yz;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x_2 = c2*neg_h4_y;
    const stanford_d3_real t4 = k4_xz + q[2]*h4_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y_3 = s2*t4 + c2*m4_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_4 = neg_nu2_y_3 - 0.1524*fu2_x_2;
    const stanford_d3_real t5 = k5_yy - k4_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_d3_real k3_zz = k4_yy + t5;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h3_z = neg_h5_y - 2.749911;
    const stanford_d3_real t6 = k5_yy - t5;
    const stanford_d3_real t7 = t6 - k4_xx;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_d3_real k3_xx = t6 - t7;
    const stanford_d3_real k3_yy = k4_xx + t7;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_3 = s2*(neg_h4_y - 0.986028);
    const stanford_d3_real t8 = 6.47*q[2];
    const stanford_d3_real t9 = k3_zz + q[2]*(t8 + 2.0*h3_z);
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_2 = k3_xx + t9 + 6.4355532937;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h2_y = s2*h4_x - c2*(h3_z + t8);
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_d3_real k2_xx = t9 + 5.3340532937 + (c2*c2*(k3_xx - t9 - 4.2325532937) +
        t4*(2.0*(c2*s2)));
    const stanford_d3_real k2_yz = s2*k4_xy + c2*m2_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_2 = k2_yz + 0.1524*h2_y;
    const stanford_d3_real m1_1 = k2_xx + (k3_yy + 0.1524*(0.986028 - 2.0*neg_h4_y)) + 0.3436532925;
    const stanford_d3_real t10 = -h4_x;
    const stanford_d3_real t11 = -h5_x;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = neg_nu2_y;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = t10;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = nu4_y;
    M[12] = m1_3;
    M[13] = t10;
    M[14] = 6.47;
    M[15] = 0.0;
    M[16] = t11;
    M[17] = 0.0;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = 0.0;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = t11;
    M[27] = 0.0;
    M[28] = 0.1273343144;
    M[29] = 0.0;
    M[30] = neg_nu2_y;
    M[31] = nu4_y;
    M[32] = 0.0;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.0203;
}

/* accelerations that the torques tau give
 * 262 multiplications, 192 additions, 6 divisions = 460; 15 unary minus; 8 sine/cosine */
void stanford_d3_forward_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real tau[6],
    stanford_d3_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_d3_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(again[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(again[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(again[4]);
    const stanford_d3_real c6 = cos(q[5]);
    const stanford_d3_real s6 = sin(again[5]);
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu5_x = 0.0203*s5;
    const stanford_d3_real nu5_y = -0.0203*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu4_x = c4*nu5_x;
    const stanford_d3_real nu4_y = s4*nu5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu2_y = s2*nu4_x + c2*nu5_y;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h5_x = 0.114912*s5;
    const stanford_d3_real neg_h5_y = 0.114912*c5;
    const stanford_d3_real t1 = 0.0096343144*(c5*c5);
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_d3_real k5_yy = t1 + 0.05885;
    const stanford_d3_real k5_xy = -0.0096343144*(c5*s5);
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu4_x = c4*neg_h5_y;
    const stanford_d3_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu4_x = 0.1273343144*s4;
    const stanford_d3_real nu4_y_2 = 0.1273343144*c4;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_5 = nu4_y_2 + q[2]*fu4_x;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x = c2*fu4_x - s2*h5_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y = s2*(neg_nu4_x + q[2]*fu4_y);
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_5 = neg_nu2_y - 0.1524*fu2_x;
    /* link 4: mass matrix, its row of this joint */
    const stanford_d3_real m4_4 = 0.1373658072 - t1;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h4_x = c4*h5_x + 0.005832*s4;
    const stanford_d3_real neg_h4_y = 0.005832*c4 - s4*h5_x;
    const stanford_d3_real t2 = t1 - 0.1056028216;
    const stanford_d3_real t3 = c4*c4*t2;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_d3_real k4_xx = 0.0158814928 - t3;
    const stanford_d3_real k4_yy = t3 - (t1 - 0.1214843144);
    const stanford_d3_real k4_xy = t2*(-c4*s4);
    const stanford_d3_real k4_xz = -5.36544e-05*s4 - c4*k5_xy;
    const stanford_d3_real k4_yz = 5.36544e-05*c4 - s4*k5_xy;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_4 = q[2]*neg_h4_y - k4_yz;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x_2 = c2*neg_h4_y;
    const stanford_d3_real t4 = k4_xz + q[2]*h4_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y_2 = s2*t4 + c2*m4_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_4 = neg_nu2_y_2 - 0.1524*fu2_x_2;
    const stanford_d3_real t5 = k5_yy - k4_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_d3_real k3_zz = k4_yy + t5;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h3_z = neg_h5_y - 2.749911;
    const stanford_d3_real t6 = k5_yy - t5;
    const stanford_d3_real t7 = t6 - k4_xx;
    /* link 3: second moment of the composite body [kg m^2] */
    const stanford_d3_real k3_xx = t6 - t7;
    const stanford_d3_real k3_yy = k4_xx + t7;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_3 = s2*(neg_h4_y - 0.986028);
    const stanford_d3_real t8 = 6.47*q[2];
    const stanford_d3_real t9 = k3_zz + q[2]*(t8 + 2.0*h3_z);
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_2 = k3_xx + t9 + 6.4355532937;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h2_y = s2*h4_x - c2*(h3_z + t8);
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_d3_real k2_xx = t9 + 5.3340532937 + (c2*c2*(k3_xx - t9 - 4.2325532937) +
        t4*(2.0*(c2*s2)));
    const stanford_d3_real k2_yz = s2*k4_xy + c2*m2_4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_2 = k2_yz + 0.1524*h2_y;
    const stanford_d3_real m1_1 = k2_xx + (k3_yy + 0.1524*(0.986028 - 2.0*neg_h4_y)) + 0.3436532925;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_z = -0.1524*ww1_zz;
    const stanford_d3_real t10 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real w2_x = t10*s2;
    const stanford_d3_real w2_y = t10*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a2_x = 9.8*s2;
    const stanford_d3_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha2_x = qd[1]*w2_y;
    const stanford_d3_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww2_xy = w2_x*w2_y;
    const stanford_d3_real ww2_xx = w2_x*w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam2_22 = -ww2_xx - ww2_zz;
    const stanford_d3_real lam2_32 = 2.0*alpha2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a3_z = neg_a2_y + q[2]*lam2_22;
    const stanford_d3_real t11 = 2.0*qd[2];
    const stanford_d3_real a3_x = qd[1]*t11 - (neg_a2_x + q[2]*ww2_xy);
    const stanford_d3_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t11;
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_x = c4*w2_x + qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 - s4*w2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_x = c4*a3_x + s4*a3_y;
    const stanford_d3_real a4_y = c4*a3_y - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_x = c4*alpha2_x + qd[3]*w4_y;
    const stanford_d3_real alpha4_y = -qd[3]*w4_x - s4*alpha2_x;
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    const stanford_d3_real ww4_zx = w4_x*w4_z;
    const stanford_d3_real ww4_xy = w4_x*w4_y;
    const stanford_d3_real ww4_xx = w4_x*w4_x;
    const stanford_d3_real ww4_yy = w4_y*w4_y;
    const stanford_d3_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_12 = ww4_xy - neg_alpha2_y;
    const stanford_d3_real lam4_13 = alpha4_y + ww4_zx;
    const stanford_d3_real lam4_21 = neg_alpha2_y + ww4_xy;
    const stanford_d3_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_d3_real lam4_31 = ww4_zx - alpha4_y;
    const stanford_d3_real lam4_32 = alpha4_x + ww4_yz;
    const stanford_d3_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_x = c5*w4_x - s5*w4_z;
    const stanford_d3_real w5_y = -c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = c5*a4_x - s5*a3_z;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = -s5*alpha4_x - c5*neg_alpha2_y - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww5_zx = w5_x*w5_z;
    const stanford_d3_real ww5_xy = w5_x*w5_y;
    const stanford_d3_real ww5_xx = w5_x*w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha4_y;
    const stanford_d3_real lam5_21 = alpha4_y + ww5_xy;
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    const stanford_d3_real lam5_31 = ww5_zx - alpha5_y;
    const stanford_d3_real lam5_32 = w5_y*(qd[4] + w5_z) - (s5*neg_alpha2_y - c5*alpha4_x);
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_x = c6*w5_x + s6*w5_z;
    const stanford_d3_real w6_y = c6*w5_z - s6*w5_x;
    const stanford_d3_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww6_yz = w6_y*w6_z;
    const stanford_d3_real ww6_zx = w6_x*w6_z;
    /* link 2: moment that turns the link [N m] */
    const stanford_d3_real nc2_x = 10.6681065874*alpha2_x;
    const stanford_d3_real nc2_y = -2.203*neg_alpha2_y;
    const stanford_d3_real neg_nc2_z = 4.2325532937*ww2_xy;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 6.47*a3_x + 2.749911*ww2_xy;
    const stanford_d3_real fc3_y = 6.47*a3_y + 5.499822*alpha2_x;
    const stanford_d3_real fc3_z = 6.47*a3_z - 2.749911*lam2_22;
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = 2.749911*a3_y;
    const stanford_d3_real neg_nc3_y = 2.749911*a3_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real neg_fc4_x = 0.005832*lam4_12;
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real fc4_z = -0.005832*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const stanford_d3_real nc4_y = 5.36544e-05*lam4_12 - 0.053*lam4_31;
    const stanford_d3_real neg_nc4_x = -0.0057314928*lam4_32 - 5.36544e-05*(neg_lam4_22 -
        neg_lam4_33) + 0.005832*a3_z;
    const stanford_d3_real nc4_z = 0.005832*a4_x - (0.0057314928*lam4_12 - 0.053*lam4_21 +
        5.36544e-05*lam4_13);
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_x = -0.114912*lam5_12;
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    const stanford_d3_real neg_fc5_z = 0.114912*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const stanford_d3_real neg_nc5_y = 0.0487*lam5_31;
    const stanford_d3_real nc5_x = 0.0786343144*lam5_32 - 0.114912*a4_y;
    const stanford_d3_real nc5_z = 0.0487*lam5_21 - 0.0786343144*lam5_12 + 0.114912*a5_x;
    /* link 6: moment that turns the link [N m] */
    const stanford_d3_real nc6_x = 0.0203*ww6_yz;
    const stanford_d3_real nc6_y = -0.0203*ww6_zx;
    const stanford_d3_real neg_nc6_z = 0.0203*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_x = c6*nc6_x - s6*nc6_y;
    const stanford_d3_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_x = nc5_x + n06_x;
    const stanford_d3_real n5_y = neg_nc6_z - neg_nc5_y;
    const stanford_d3_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f05_x = c5*fc5_x - s5*fc5_y;
    const stanford_d3_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n05_x = c5*n5_x - s5*n5_y;
    const stanford_d3_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_x = n05_x - neg_nc4_x;
    const stanford_d3_real n4_y = nc4_y + n5_z;
    const stanford_d3_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_x = f05_x - neg_fc4_x;
    const stanford_d3_real f4_y = fc4_y - neg_fc5_z;
    const stanford_d3_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_x = c4*f4_x - s4*f4_y;
    const stanford_d3_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n04_x = c4*n4_x - s4*n4_y;
    const stanford_d3_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n3_x = nc3_x + n04_x;
    const stanford_d3_real n3_y = n04_y - neg_nc3_y;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x + f04_x;
    const stanford_d3_real f3_y = fc3_y + f04_y;
    const stanford_d3_real f3_z = fc3_z + f4_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_x = n3_x + (nc2_x - q[2]*f3_y);
    const stanford_d3_real n2_y = nc2_y - n4_z;
    const stanford_d3_real n2_z = n3_y + (q[2]*f3_x - neg_nc2_z);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real neg_f02_x = -s2*f3_z - c2*f3_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = 0.1524*neg_f02_x - n02_y;
    /* link 1: forward substitution */
    const stanford_d3_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const stanford_d3_real ipivot1 = 1.0 / m1_1;
    const stanford_d3_real l2_1 = m1_2*ipivot1;
    const stanford_d3_real l3_1 = m1_3*ipivot1;
    const stanford_d3_real l4_1 = m1_4*ipivot1;
    const stanford_d3_real l5_1 = m1_5*ipivot1;
    const stanford_d3_real l6_1 = -nu2_y*ipivot1;
    const stanford_d3_real pivot2 = m2_2 - m1_2*l2_1;
    const stanford_d3_real ipivot2 = 1.0 / pivot2;
    const stanford_d3_real ld3_2 = -h4_x - m1_2*l3_1;
    const stanford_d3_real l3_2 = ipivot2*ld3_2;
    const stanford_d3_real ld4_2 = m2_4 - m1_2*l4_1;
    const stanford_d3_real l4_2 = ipivot2*ld4_2;
    const stanford_d3_real ld5_2 = m2_5 - m1_2*l5_1;
    const stanford_d3_real l5_2 = ipivot2*ld5_2;
    const stanford_d3_real ld6_2 = nu4_y - m1_2*l6_1;
    const stanford_d3_real l6_2 = ipivot2*ld6_2;
    const stanford_d3_real pivot3 = 6.47 - m1_3*l3_1 - ld3_2*l3_2;
    const stanford_d3_real ipivot3 = 1.0 / pivot3;
    const stanford_d3_real t12 = -ld3_2;
    const stanford_d3_real ld4_3 = t12*l4_2 - m1_3*l4_1;
    const stanford_d3_real l4_3 = ipivot3*ld4_3;
    const stanford_d3_real ld5_3 = -m1_3*l5_1 - h5_x - ld3_2*l5_2;
    const stanford_d3_real l5_3 = ipivot3*ld5_3;
    const stanford_d3_real ld6_3 = t12*l6_2 - m1_3*l6_1;
    const stanford_d3_real l6_3 = ipivot3*ld6_3;
    const stanford_d3_real pivot4 = -ld4_3*l4_3 - (ld4_2*l4_2 - (m4_4 - m1_4*l4_1));
    const stanford_d3_real ipivot4 = 1.0 / pivot4;
    const stanford_d3_real t13 = -ld4_2;
    const stanford_d3_real ld5_4 = t13*l5_2 - m1_4*l5_1 - ld4_3*l5_3;
    const stanford_d3_real l5_4 = ipivot4*ld5_4;
    const stanford_d3_real ld6_4 = t13*l6_2 - (nu5_y + m1_4*l6_1) - ld4_3*l6_3;
    const stanford_d3_real l6_4 = ipivot4*ld6_4;
    const stanford_d3_real pivot5 = 0.1273343144 - m1_5*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const stanford_d3_real ipivot5 = 1.0 / pivot5;
    const stanford_d3_real ld6_5 = -(m1_5*l6_1 + ld5_2*l6_2 + ld5_3*l6_3) - ld5_4*l6_4;
    const stanford_d3_real l6_5 = ipivot5*ld6_5;
    const stanford_d3_real pivot6 = nu2_y*l6_1 + 0.0203 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 -
        ld6_5*l6_5;
    const stanford_d3_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const stanford_d3_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const stanford_d3_real y3 = tau[2] - f3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const stanford_d3_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const stanford_d3_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const stanford_d3_real y6 = tau[5] + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 -
        l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd3 = ipivot3*y3 - l4_3*qdd4 - l5_3*qdd5 - l6_3*qdd6;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd1 = -l6_1*qdd6 - (l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 +
        l5_1*qdd5);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
