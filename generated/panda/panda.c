/*
 * panda: Franka Emika Panda, hand locked
 * Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
 *   fingers locked at the neutral pose
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute, 7
 *   revolute
 * Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
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
 *   inverse_dynamics: 308 multiplications, 292 additions = 600; 11 unary minus; 12 sine/cosine
 *   gravity: 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine
 *   bias: 300 multiplications, 273 additions = 573; 12 unary minus; 12 sine/cosine
 *   mass_matrix: 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine
 *   forward_dynamics: 629 multiplications, 551 additions, 7 divisions = 1187; 21 unary minus; 12
 *       sine/cosine
 */
#include "panda.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 308 multiplications, 292 additions = 600; 11 unary minus; 12 sine/cosine */
void panda_inverse_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real qdd[7],
    panda_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(again[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(again[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(again[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(again[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(again[6]);
    const panda_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_x = t1*s2;
    const panda_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a2_x = -9.81*s2;
    const panda_real a2_y = -9.81*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_yz = qd[1]*w2_y;
    const panda_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = ww2_yz - qdd[0]*s2;
    const panda_real neg_alpha2_y = qdd[0]*c2 + ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xy = w2_x*w2_y;
    const panda_real ww2_xx = w2_x*w2_x;
    const panda_real ww2_yy = w2_y*w2_y;
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_11 = ww2_yy + ww2_zz;
    const panda_real lam2_12 = ww2_xy - qdd[1];
    const panda_real lam2_13 = ww2_zx - neg_alpha2_y;
    const panda_real lam2_21 = qdd[1] + ww2_xy;
    const panda_real neg_lam2_22 = ww2_xx + ww2_zz;
    const panda_real lam2_23 = ww2_yz - alpha2_x;
    const panda_real lam2_31 = ww2_zx + neg_alpha2_y;
    const panda_real lam2_32 = ww2_yz + alpha2_x;
    const panda_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_z = -0.316*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t2 = -0.316*lam2_32;
    const panda_real t3 = 0.316*lam2_12 - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t2 - c3*t3;
    const panda_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = qd[2]*w3_y - (-c3*alpha2_x - qdd[1]*s3);
    const panda_real alpha3_y = qdd[1]*c3 - s3*alpha2_x - qd[2]*w3_x;
    const panda_real alpha3_z = qdd[2] + neg_alpha2_y;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yz = w3_y*w3_z;
    const panda_real ww3_zx = w3_x*w3_z;
    const panda_real ww3_xy = w3_x*w3_y;
    const panda_real ww3_xx = w3_x*w3_x;
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    const panda_real lam3_12 = ww3_xy - alpha3_z;
    const panda_real lam3_13 = alpha3_y + ww3_zx;
    const panda_real lam3_21 = alpha3_z + ww3_xy;
    const panda_real neg_lam3_22 = ww3_xx + ww3_zz;
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real lam3_32 = alpha3_x + ww3_yz;
    const panda_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a4_z = a3_y + 0.0825*lam3_21;
    const panda_real t4 = -c4;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t4*w3_x - s4*w3_z;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t5 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t6 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t5 - s4*t6;
    const panda_real neg_a4_y = s4*t5 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = t4*alpha3_x - s4*alpha3_z + qd[3]*w4_y;
    const panda_real neg_alpha4_y = c4*alpha3_z - s4*alpha3_x + qd[3]*w4_x;
    const panda_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_yz = w4_y*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yy = w4_y*w4_y;
    const panda_real neg_ww4_zz = -w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_11 = neg_ww4_zz - ww4_yy;
    const panda_real lam4_12 = ww4_xy - alpha4_z;
    const panda_real lam4_13 = ww4_zx - neg_alpha4_y;
    const panda_real lam4_21 = alpha4_z + ww4_xy;
    const panda_real lam4_22 = neg_ww4_zz - ww4_xx;
    const panda_real lam4_23 = ww4_yz - alpha4_x;
    const panda_real lam4_31 = neg_alpha4_y + ww4_zx;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real lam4_33 = -ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (0.384*lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -(c5*w4_x) - s5*w4_z;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t7 = neg_a4_z + (0.384*lam4_32 - 0.0825*lam4_31);
    const panda_real t8 = a4_x - (0.384*lam4_12 - 0.0825*lam4_11);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*t7 - c5*t8;
    const panda_real a5_y = s5*t8 + c5*t7;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_x = qd[4]*w5_y - (c5*alpha4_x + s5*alpha4_z);
    const panda_real alpha5_y = s5*alpha4_x - c5*alpha4_z - qd[4]*w5_x;
    const panda_real alpha5_z = qdd[4] + neg_alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real ww5_yz = w5_y*w5_z;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real ww5_xy = w5_x*w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_yy = w5_y*w5_y;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_11 = ww5_yy + ww5_zz;
    const panda_real lam5_12 = ww5_xy - alpha5_z;
    const panda_real lam5_13 = alpha5_y + ww5_zx;
    const panda_real lam5_21 = alpha5_z + ww5_xy;
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    const panda_real lam5_23 = ww5_yz - alpha5_x;
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real lam5_32 = alpha5_x + ww5_yz;
    const panda_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = c6*w5_x + s6*w5_z;
    const panda_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a6_x = c6*a5_x + s6*a5_z;
    const panda_real a6_y = c6*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const panda_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*alpha5_z);
    const panda_real alpha6_y = c6*alpha5_z - s6*alpha5_x - qd[5]*w6_x;
    const panda_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_yz = w6_y*w6_z;
    const panda_real ww6_zx = w6_x*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_xx = w6_x*w6_x;
    const panda_real ww6_yy = w6_y*w6_y;
    const panda_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_11 = ww6_yy + ww6_zz;
    const panda_real lam6_12 = ww6_xy - alpha6_z;
    const panda_real lam6_13 = alpha6_y + ww6_zx;
    const panda_real lam6_21 = alpha6_z + ww6_xy;
    const panda_real neg_lam6_22 = ww6_xx + ww6_zz;
    const panda_real lam6_23 = ww6_yz - alpha6_x;
    const panda_real lam6_31 = ww6_zx - alpha6_y;
    const panda_real lam6_32 = alpha6_x + ww6_yz;
    const panda_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a7_z = -0.088*lam6_21 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_x = c7*w6_x + s7*w6_z;
    const panda_real w7_y = c7*w6_z - s7*w6_x;
    const panda_real t9 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t10 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t9 + s7*t10;
    const panda_real a7_y = s7*t9 - c7*t10;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (-c7*alpha6_x - s7*alpha6_z);
    const panda_real alpha7_y = c7*alpha6_z - s7*alpha6_x - qd[6]*w7_x;
    const panda_real alpha7_z = qdd[6] - alpha6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_yz = w7_y*w7_z;
    const panda_real ww7_zx = w7_x*w7_z;
    const panda_real ww7_xy = w7_x*w7_y;
    const panda_real ww7_xx = w7_x*w7_x;
    const panda_real ww7_yy = w7_y*w7_y;
    const panda_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam7_11 = ww7_yy + ww7_zz;
    const panda_real lam7_12 = ww7_xy - alpha7_z;
    const panda_real lam7_13 = alpha7_y + ww7_zx;
    const panda_real lam7_21 = alpha7_z + ww7_xy;
    const panda_real neg_lam7_22 = ww7_xx + ww7_zz;
    const panda_real lam7_23 = ww7_yz - alpha7_x;
    const panda_real neg_lam7_31 = alpha7_y - ww7_zx;
    const panda_real lam7_32 = alpha7_x + ww7_yz;
    const panda_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 1: moment that turns the link [N m] */
    const panda_real nc1_z = 0.014259565994474374*qdd[0];
    /* link 2: moment that turns the link [N m] */
    const panda_real neg_nc2_x = 0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) -
        1.0321620612318807*lam2_32 + (-0.003983358883935522*lam2_31 - 0.010261101821008168*lam2_21);
    const panda_real nc2_y = 0.010261101821008168*(neg_lam2_11 - neg_lam2_33) -
        0.023077882494931805*lam2_31 + (-0.0007689361029464017*lam2_12 -
        0.003983358883935522*lam2_32);
    const panda_real t11 = 0.023077882494931805*lam2_21 - 1.0321620612318807*lam2_12 +
        0.003983358883935522*(neg_lam2_11 - neg_lam2_22) + (0.0007689361029464017*lam2_13 -
        0.010261101821008168*lam2_23);
    const panda_real nc2_z = t11 + (0.01993386669246*c2 - 32.809545426852715*s2);
    /* link 3: force that moves the link [N] */
    const panda_real fc3_x = 0.028227094877999827*lam3_12 - 0.746857959872*neg_lam3_11;
    const panda_real fc3_y = 0.746857959872*lam3_21 - 0.028227094877999827*neg_lam3_22;
    /* link 3: moment that turns the link [N m] */
    const panda_real nc3_x = 0.028227094877999827*a3_z - (-0.022178148964878252*lam3_32 -
        0.0043772571218395765*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251*lam3_21 -
        0.0001219124209507298*lam3_31));
    const panda_real nc3_y = -0.061602421026527694*lam3_31 - 0.005487648106562251*(neg_lam3_11 -
        neg_lam3_33) - (0.0001219124209507298*lam3_32 - 0.0043772571218395765*lam3_12) -
        0.746857959872*a3_z;
    const panda_real t12 = 0.061602421026527694*lam3_21 - 0.022178148964878252*lam3_12 +
        0.0001219124209507298*(neg_lam3_11 - neg_lam3_22) + (0.005487648106562251*lam3_23 -
        0.0043772571218395765*lam3_13);
    const panda_real nc3_z = t12 + (0.746857959872*a3_y - 0.028227094877999827*a3_x);
    /* link 4: force that moves the link [N] */
    const panda_real fc4_x = 0.5527802746499999*lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 - 2.0125235536029997*lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(lam4_33 - lam4_22) -
        (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) + 2.0125235536029997*neg_a4_z;
    const panda_real nc4_y = 0.5527802746499999*neg_a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(lam4_33 - lam4_11) - (0.16284087268546082*lam4_32 -
        0.00164448757736928*lam4_12));
    const panda_real t13 = 0.05102013615681549*lam4_21 - 0.6972920750309717*lam4_12 -
        0.16284087268546082*(lam4_22 - lam4_11) - (-0.0039053550262761055*lam4_23 -
        0.00164448757736928*lam4_13);
    const panda_real nc4_z = t13 - (0.5527802746499999*neg_a4_y - 2.0125235536029997*a4_x);
    /* link 5: force that moves the link [N] */
    const panda_real fc5_x = 0.014653732538*neg_lam5_11 + 0.067870631425*lam5_12;
    const panda_real fc5_y = -0.067870631425*neg_lam5_22 - 0.014653732538*lam5_21;
    const panda_real fc5_z = 0.067870631425*lam5_32 - 0.014653732538*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const panda_real nc5_x = 0.067870631425*a5_z - (0.0021640520520981327*(neg_lam5_22 -
        neg_lam5_33) - 0.010045187828321245*lam5_32 + (0.004600245517563107*lam5_21 -
        0.00151524447332703*lam5_31));
    const panda_real nc5_y = -0.001451156065026714*lam5_31 - 0.004600245517563107*(neg_lam5_11 -
        neg_lam5_33) + (-0.0021640520520981327*lam5_12 - 0.00151524447332703*lam5_32) +
        0.014653732538*a5_z;
    const panda_real t14 = 0.001451156065026714*lam5_21 - 0.010045187828321245*lam5_12 +
        0.00151524447332703*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107*lam5_23 +
        0.0021640520520981327*lam5_13);
    const panda_real nc5_z = t14 - (0.014653732538*a5_y + 0.067870631425*a5_x);
    /* link 6: force that moves the link [N] */
    const panda_real fc6_x = -0.231847552695*neg_lam6_11 - 0.17380470556899996*lam6_12;
    const panda_real fc6_y = 0.231847552695*lam6_21 + 0.17380470556899996*neg_lam6_22;
    const panda_real fc6_z = 0.231847552695*lam6_31 - 0.17380470556899996*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const panda_real nc6_x = 0.17380470556899996*a5_y - (9.35690973146064e-05*(neg_lam6_22 -
        neg_lam6_33) - 0.028934422545659907*lam6_32 - (-0.014748570382675314*lam6_31 -
        0.0001037589172186853*lam6_21));
    const panda_real nc6_y = -0.021522255370587554*lam6_31 - 0.0001037589172186853*(neg_lam6_11 -
        neg_lam6_33) + (0.014748570382675314*lam6_32 - 9.35690973146064e-05*lam6_12) +
        0.231847552695*a5_y;
    const panda_real t15 = 0.021522255370587554*lam6_21 - 0.028934422545659907*lam6_12 -
        0.014748570382675314*(neg_lam6_11 - neg_lam6_22) + (0.0001037589172186853*lam6_23 +
        9.35690973146064e-05*lam6_13);
    const panda_real nc6_z = t15 + (0.231847552695*a6_y + 0.17380470556899996*a6_x);
    /* link 7: force that moves the link [N] */
    const panda_real fc7_x = 0.0020344399586618637*lam7_12 - 0.002573605371338201*neg_lam7_11;
    const panda_real fc7_y = 0.002573605371338201*lam7_21 - 0.0020344399586618637*neg_lam7_22;
    const panda_real neg_fc7_z = 0.002573605371338201*neg_lam7_31 - 0.0020344399586618637*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = 0.0020344399586618637*a7_z - (-0.004552547872941087*lam7_32 -
        0.0012555365982729084*(neg_lam7_22 - neg_lam7_33) - (0.0003913912816842475*neg_lam7_31 -
        0.0009653051699191118*lam7_21));
    const panda_real nc7_y = 0.00213160409441986*neg_lam7_31 - 0.0009653051699191118*(neg_lam7_11 -
        neg_lam7_33) - (-0.0012555365982729084*lam7_12 - 0.0003913912816842475*lam7_32) -
        0.002573605371338201*a7_z;
    const panda_real t16 = 0.00213160409441986*lam7_21 - 0.004552547872941087*lam7_12 -
        0.0003913912816842475*(neg_lam7_11 - neg_lam7_22) + (0.0009653051699191118*lam7_23 -
        0.0012555365982729084*lam7_13);
    const panda_real nc7_z = t16 + (0.002573605371338201*a7_y + 0.0020344399586618637*neg_a7_x);
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f07_x = c7*fc7_x - s7*fc7_y;
    const panda_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y - 0.088*f07_y - nc7_z;
    const panda_real n6_z = n07_y + (nc6_z + 0.088*neg_fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y + neg_fc7_z;
    const panda_real f6_z = fc6_z + f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f06_x = c6*f6_x - s6*f6_y;
    const panda_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n06_x = c6*n6_x - s6*n6_y;
    const panda_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_x = nc5_x + n06_x;
    const panda_real n5_y = nc5_y - n6_z;
    const panda_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const panda_real f5_x = fc5_x + f06_x;
    const panda_real f5_y = fc5_y - f6_z;
    const panda_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const panda_real neg_f05_x = c5*f5_x - s5*f5_y;
    const panda_real f05_y = -c5*f5_y - s5*f5_x;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = -s5*n5_x - c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x - 0.384*f05_y);
    const panda_real n4_y = nc4_y - 0.0825*f05_y - n5_z;
    const panda_real n4_z = n05_y + (nc4_z - (0.0825*f5_z + 0.384*neg_f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x - neg_f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = -s4*f4_x - c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real n04_y = t4*n4_y - s4*n4_x;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = n04_y + (nc3_z - 0.0825*f4_z);
    /* link 3: force through the joint [N] */
    const panda_real f3_x = fc3_x + f04_x;
    const panda_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const panda_real neg_f03_x = s3*f3_y - c3*f3_x;
    const panda_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n03_x = c3*n3_x - s3*n3_y;
    const panda_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real neg_n2_x = neg_nc2_x + 0.316*f03_y - n03_x;
    const panda_real n2_y = nc2_y - n3_z;
    const panda_real n2_z = n03_y + (nc2_z - 0.316*neg_f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = s2*neg_n2_x - c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const panda_real n1_z = nc1_z + n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques that hold the arm at rest
 * 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine */
void panda_gravity(const panda_real q[7], panda_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(again[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(again[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(again[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(again[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(again[6]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a2_x = -9.81*s2;
    const panda_real a2_y = -9.81*c2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = c3*a2_x;
    const panda_real a3_y = -s3*a2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = s4*a2_y - c4*a3_x;
    const panda_real a4_y = s4*a3_x + c4*a2_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*a3_y - c5*a4_x;
    const panda_real a5_y = s5*a4_x + c5*a3_y;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a6_x = c6*a5_x - s6*a4_y;
    const panda_real a6_y = -s6*a5_x - c6*a4_y;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = s7*a5_y - c7*a6_x;
    const panda_real a7_y = -s7*a6_x - c7*a5_y;
    /* link 2: moment that turns the link [N m] */
    const panda_real nc2_z = 0.01993386669246*c2 - 32.809545426852715*s2;
    /* link 3: moment that turns the link [N m] */
    const panda_real nc3_x = 0.27690780075317833*c2;
    const panda_real nc3_y = -7.32667658634432*c2;
    const panda_real nc3_z = 0.746857959872*a3_y - 0.028227094877999827*a3_x;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 2.0125235536029997*a3_y;
    const panda_real nc4_y = 0.5527802746499999*a3_y;
    const panda_real nc4_z = 0.5527802746499999*a4_y + 2.0125235536029997*a4_x;
    /* link 5: moment that turns the link [N m] */
    const panda_real nc5_x = -0.067870631425*a4_y;
    const panda_real nc5_y = -0.014653732538*a4_y;
    const panda_real nc5_z = -0.067870631425*a5_x - 0.014653732538*a5_y;
    /* link 6: moment that turns the link [N m] */
    const panda_real nc6_x = 0.17380470556899996*a5_y;
    const panda_real nc6_y = 0.231847552695*a5_y;
    const panda_real nc6_z = 0.231847552695*a6_y + 0.17380470556899996*a6_x;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = -0.0020344399586618637*a6_y;
    const panda_real nc7_y = 0.002573605371338201*a6_y;
    const panda_real nc7_z = 0.002573605371338201*a7_y + 0.0020344399586618637*neg_a7_x;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y - nc7_z;
    const panda_real n6_z = nc6_z + n07_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n06_x = c6*n6_x - s6*n6_y;
    const panda_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_x = nc5_x + n06_x;
    const panda_real n5_y = nc5_y - n6_z;
    const panda_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real neg_n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = nc4_x + n05_x;
    const panda_real n4_y = nc4_y - n5_z;
    const panda_real n4_z = nc4_z - neg_n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real neg_n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - n4_z;
    const panda_real n3_z = nc3_z - neg_n04_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n03_x = c3*n3_x - s3*n3_y;
    const panda_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real n2_z = nc2_z + n03_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = c2*n3_z - s2*n03_x;
    tau[0] = n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 300 multiplications, 273 additions = 573; 12 unary minus; 12 sine/cosine */
void panda_bias(const panda_real q[7], const panda_real qd[7], panda_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(again[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(again[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(again[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(again[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(again[6]);
    const panda_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_x = t1*s2;
    const panda_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a2_x = -9.81*s2;
    const panda_real a2_y = -9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = qd[1]*w2_y;
    const panda_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xy = w2_x*w2_y;
    const panda_real ww2_xx = w2_x*w2_x;
    const panda_real ww2_yy = w2_y*w2_y;
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_11 = ww2_yy + ww2_zz;
    const panda_real neg_lam2_22 = ww2_xx + ww2_zz;
    const panda_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_z = -0.316*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t2 = -0.632*alpha2_x;
    const panda_real t3 = 0.316*ww2_xy - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t2 - c3*t3;
    const panda_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const panda_real alpha3_y = -s3*alpha2_x - qd[2]*w3_x;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yz = w3_y*w3_z;
    const panda_real ww3_zx = w3_x*w3_z;
    const panda_real ww3_xy = w3_x*w3_y;
    const panda_real ww3_xx = w3_x*w3_x;
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    const panda_real lam3_12 = alpha2_y + ww3_xy;
    const panda_real lam3_13 = alpha3_y + ww3_zx;
    const panda_real lam3_21 = ww3_xy - alpha2_y;
    const panda_real neg_lam3_22 = ww3_xx + ww3_zz;
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real lam3_32 = alpha3_x + ww3_yz;
    const panda_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_z = -0.0825*lam3_21 - a3_y;
    const panda_real t4 = -c4;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t4*w3_x - s4*w3_z;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t5 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t6 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t5 - s4*t6;
    const panda_real neg_a4_y = s4*t5 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = s4*alpha2_y - c4*alpha3_x + qd[3]*w4_y;
    const panda_real alpha4_y = s4*alpha3_x + c4*alpha2_y - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_yz = w4_y*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yy = w4_y*w4_y;
    const panda_real neg_ww4_zz = -w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_11 = neg_ww4_zz - ww4_yy;
    const panda_real lam4_12 = alpha3_y + ww4_xy;
    const panda_real lam4_13 = alpha4_y + ww4_zx;
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    const panda_real lam4_22 = neg_ww4_zz - ww4_xx;
    const panda_real lam4_23 = ww4_yz - alpha4_x;
    const panda_real lam4_31 = ww4_zx - alpha4_y;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real lam4_33 = -ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (0.384*lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -(c5*w4_x) - s5*w4_z;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t7 = 0.384*lam4_32 - 0.0825*lam4_31 - a4_z;
    const panda_real t8 = a4_x - (0.384*lam4_12 - 0.0825*lam4_11);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*t7 - c5*t8;
    const panda_real a5_y = s5*t8 + c5*t7;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_x = qd[4]*w5_y - (c5*alpha4_x - s5*alpha3_y);
    const panda_real alpha5_y = s5*alpha4_x + c5*alpha3_y - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real ww5_yz = w5_y*w5_z;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real ww5_xy = w5_x*w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_yy = w5_y*w5_y;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_11 = ww5_yy + ww5_zz;
    const panda_real lam5_12 = alpha4_y + ww5_xy;
    const panda_real lam5_13 = alpha5_y + ww5_zx;
    const panda_real lam5_21 = ww5_xy - alpha4_y;
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    const panda_real lam5_23 = ww5_yz - alpha5_x;
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real lam5_32 = alpha5_x + ww5_yz;
    const panda_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = c6*w5_x + s6*w5_z;
    const panda_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a6_x = c6*a5_x + s6*a5_z;
    const panda_real a6_y = c6*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const panda_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const panda_real alpha6_y = -s6*alpha5_x - c6*alpha4_y - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_yz = w6_y*w6_z;
    const panda_real ww6_zx = w6_x*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_xx = w6_x*w6_x;
    const panda_real ww6_yy = w6_y*w6_y;
    const panda_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_11 = ww6_yy + ww6_zz;
    const panda_real lam6_12 = alpha5_y + ww6_xy;
    const panda_real lam6_13 = alpha6_y + ww6_zx;
    const panda_real lam6_21 = ww6_xy - alpha5_y;
    const panda_real neg_lam6_22 = ww6_xx + ww6_zz;
    const panda_real lam6_23 = ww6_yz - alpha6_x;
    const panda_real lam6_31 = ww6_zx - alpha6_y;
    const panda_real lam6_32 = alpha6_x + ww6_yz;
    const panda_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a7_z = -0.088*lam6_21 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_x = c7*w6_x + s7*w6_z;
    const panda_real w7_y = c7*w6_z - s7*w6_x;
    const panda_real t9 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t10 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t9 + s7*t10;
    const panda_real a7_y = s7*t9 - c7*t10;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (s7*alpha5_y - c7*alpha6_x);
    const panda_real t11 = -s7;
    const panda_real alpha7_y = t11*alpha6_x - c7*alpha5_y - qd[6]*w7_x;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_yz = w7_y*w7_z;
    const panda_real ww7_zx = w7_x*w7_z;
    const panda_real ww7_xy = w7_x*w7_y;
    const panda_real ww7_xx = w7_x*w7_x;
    const panda_real ww7_yy = w7_y*w7_y;
    const panda_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam7_11 = ww7_yy + ww7_zz;
    const panda_real lam7_12 = alpha6_y + ww7_xy;
    const panda_real lam7_13 = alpha7_y + ww7_zx;
    const panda_real lam7_21 = ww7_xy - alpha6_y;
    const panda_real neg_lam7_22 = ww7_xx + ww7_zz;
    const panda_real lam7_23 = ww7_yz - alpha7_x;
    const panda_real neg_lam7_31 = alpha7_y - ww7_zx;
    const panda_real lam7_32 = alpha7_x + ww7_yz;
    const panda_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 2: moment that turns the link [N m] */
    const panda_real neg_nc2_x = 0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) -
        2.0643241224637614*alpha2_x + (0.007966717767871044*alpha2_y - 0.010261101821008168*ww2_xy);
    const panda_real nc2_y = 0.04615576498986361*alpha2_y + 0.010261101821008168*(neg_lam2_11 -
        neg_lam2_33) - (0.0007689361029464017*ww2_xy + 0.007966717767871044*alpha2_x);
    const panda_real nc2_z = 0.01993386669246*c2 - 32.809545426852715*s2 - (1.009084178736949*ww2_xy
        - 0.003983358883935522*(neg_lam2_11 - neg_lam2_22));
    /* link 3: force that moves the link [N] */
    const panda_real fc3_x = 0.028227094877999827*lam3_12 - 0.746857959872*neg_lam3_11;
    const panda_real fc3_y = 0.746857959872*lam3_21 - 0.028227094877999827*neg_lam3_22;
    /* link 3: moment that turns the link [N m] */
    const panda_real nc3_x = 0.028227094877999827*a3_z - (-0.022178148964878252*lam3_32 -
        0.0043772571218395765*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251*lam3_21 -
        0.0001219124209507298*lam3_31));
    const panda_real nc3_y = -0.061602421026527694*lam3_31 - 0.005487648106562251*(neg_lam3_11 -
        neg_lam3_33) + (0.0043772571218395765*lam3_12 - 0.0001219124209507298*lam3_32) -
        0.746857959872*a3_z;
    const panda_real t12 = 0.022178148964878252*lam3_12 - 0.061602421026527694*lam3_21 -
        0.0001219124209507298*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251*lam3_23 -
        0.0043772571218395765*lam3_13);
    const panda_real nc3_z = 0.746857959872*a3_y - 0.028227094877999827*a3_x - t12;
    /* link 4: force that moves the link [N] */
    const panda_real fc4_x = 0.5527802746499999*lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 - 2.0125235536029997*lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(lam4_33 - lam4_22) -
        (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) - 2.0125235536029997*a4_z;
    const panda_real nc4_y = -0.5527802746499999*a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(lam4_33 - lam4_11) + (0.00164448757736928*lam4_12 -
        0.16284087268546082*lam4_32));
    const panda_real t13 = 0.6972920750309717*lam4_12 - 0.05102013615681549*lam4_21 +
        0.16284087268546082*(lam4_22 - lam4_11) + (-0.0039053550262761055*lam4_23 -
        0.00164448757736928*lam4_13);
    const panda_real neg_nc4_z = t13 + (0.5527802746499999*neg_a4_y - 2.0125235536029997*a4_x);
    /* link 5: force that moves the link [N] */
    const panda_real fc5_x = 0.014653732538*neg_lam5_11 + 0.067870631425*lam5_12;
    const panda_real fc5_y = -0.067870631425*neg_lam5_22 - 0.014653732538*lam5_21;
    const panda_real fc5_z = 0.067870631425*lam5_32 - 0.014653732538*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const panda_real nc5_x = 0.067870631425*a5_z - (0.0021640520520981327*(neg_lam5_22 -
        neg_lam5_33) - 0.010045187828321245*lam5_32 + (0.004600245517563107*lam5_21 -
        0.00151524447332703*lam5_31));
    const panda_real nc5_y = -0.001451156065026714*lam5_31 - 0.004600245517563107*(neg_lam5_11 -
        neg_lam5_33) + (-0.0021640520520981327*lam5_12 - 0.00151524447332703*lam5_32) +
        0.014653732538*a5_z;
    const panda_real t14 = 0.001451156065026714*lam5_21 - 0.010045187828321245*lam5_12 +
        0.00151524447332703*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107*lam5_23 +
        0.0021640520520981327*lam5_13);
    const panda_real nc5_z = t14 - (0.014653732538*a5_y + 0.067870631425*a5_x);
    /* link 6: force that moves the link [N] */
    const panda_real fc6_x = -0.231847552695*neg_lam6_11 - 0.17380470556899996*lam6_12;
    const panda_real fc6_y = 0.231847552695*lam6_21 + 0.17380470556899996*neg_lam6_22;
    const panda_real fc6_z = 0.231847552695*lam6_31 - 0.17380470556899996*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const panda_real nc6_x = 0.17380470556899996*a5_y - (9.35690973146064e-05*(neg_lam6_22 -
        neg_lam6_33) - 0.028934422545659907*lam6_32 - (-0.014748570382675314*lam6_31 -
        0.0001037589172186853*lam6_21));
    const panda_real nc6_y = -0.021522255370587554*lam6_31 - 0.0001037589172186853*(neg_lam6_11 -
        neg_lam6_33) - (9.35690973146064e-05*lam6_12 - 0.014748570382675314*lam6_32) +
        0.231847552695*a5_y;
    const panda_real t15 = 0.028934422545659907*lam6_12 - 0.021522255370587554*lam6_21 +
        0.014748570382675314*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853*lam6_23 +
        9.35690973146064e-05*lam6_13);
    const panda_real nc6_z = 0.231847552695*a6_y + 0.17380470556899996*a6_x - t15;
    /* link 7: force that moves the link [N] */
    const panda_real fc7_x = 0.0020344399586618637*lam7_12 - 0.002573605371338201*neg_lam7_11;
    const panda_real fc7_y = 0.002573605371338201*lam7_21 - 0.0020344399586618637*neg_lam7_22;
    const panda_real neg_fc7_z = 0.002573605371338201*neg_lam7_31 - 0.0020344399586618637*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = 0.0020344399586618637*a7_z - (-0.004552547872941087*lam7_32 -
        0.0012555365982729084*(neg_lam7_22 - neg_lam7_33) - (0.0003913912816842475*neg_lam7_31 -
        0.0009653051699191118*lam7_21));
    const panda_real nc7_y = 0.00213160409441986*neg_lam7_31 - 0.0009653051699191118*(neg_lam7_11 -
        neg_lam7_33) + (0.0012555365982729084*lam7_12 + 0.0003913912816842475*lam7_32) -
        0.002573605371338201*a7_z;
    const panda_real t16 = 0.004552547872941087*lam7_12 - 0.00213160409441986*lam7_21 +
        0.0003913912816842475*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118*lam7_23 -
        0.0012555365982729084*lam7_13);
    const panda_real nc7_z = 0.002573605371338201*a7_y + 0.0020344399586618637*neg_a7_x - t16;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f07_x = c7*fc7_x - s7*fc7_y;
    const panda_real neg_f07_y = t11*fc7_x - c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y + 0.088*neg_f07_y - nc7_z;
    const panda_real n6_z = n07_y + (nc6_z + 0.088*neg_fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y + neg_fc7_z;
    const panda_real f6_z = fc6_z - neg_f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f06_x = c6*f6_x - s6*f6_y;
    const panda_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n06_x = c6*n6_x - s6*n6_y;
    const panda_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_x = nc5_x + n06_x;
    const panda_real n5_y = nc5_y - n6_z;
    const panda_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const panda_real f5_x = fc5_x + f06_x;
    const panda_real f5_y = fc5_y - f6_z;
    const panda_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const panda_real neg_f05_x = c5*f5_x - s5*f5_y;
    const panda_real f05_y = -c5*f5_y - s5*f5_x;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = -s5*n5_x - c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x - 0.384*f05_y);
    const panda_real n4_y = nc4_y - 0.0825*f05_y - n5_z;
    const panda_real n4_z = n05_y - (neg_nc4_z + (0.0825*f5_z + 0.384*neg_f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x - neg_f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = -s4*f4_x - c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real n04_y = t4*n4_y - s4*n4_x;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = n04_y - (0.0825*f4_z - nc3_z);
    /* link 3: force through the joint [N] */
    const panda_real f3_x = fc3_x + f04_x;
    const panda_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f03_x = c3*f3_x - s3*f3_y;
    const panda_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n03_x = c3*n3_x - s3*n3_y;
    const panda_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real neg_n2_x = neg_nc2_x + 0.316*f03_y - n03_x;
    const panda_real n2_y = nc2_y - n3_z;
    const panda_real n2_z = n03_y - (-0.316*f03_x - nc2_z);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = s2*neg_n2_x - c2*n2_y;
    tau[0] = n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine */
void panda_mass_matrix(const panda_real q[7], panda_real M[49])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(again[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(again[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(again[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(again[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(again[6]);
    /* link 6: force for a unit acceleration of a joint further out */
    const panda_real fu6_x = -0.002573605371338201*s7 - 0.0020344399586618637*c7;
    const panda_real fu6_z = 0.002573605371338201*c7 - 0.0020344399586618637*s7;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = 0.0012555365982729084*s7 - 0.0009653051699191118*c7;
    const panda_real nu6_z = -0.0012555365982729084*c7 - 0.0009653051699191118*s7;
    const panda_real nu6_y = -0.088*fu6_z - 0.006684151967360947;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x = c6*fu6_x;
    const panda_real fu5_z = s6*fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real neg_nu5_x = s6*nu6_y - c6*nu6_x;
    const panda_real nu5_z = s6*nu6_x + c6*nu6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x = -c5*fu5_x - s5*fu6_z;
    const panda_real fu4_z = c5*fu6_z - s5*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = c5*neg_nu5_x - s5*nu6_z - 0.384*fu4_z;
    const panda_real t1 = -0.0825*fu4_z;
    const panda_real nu4_y = t1 - nu5_z;
    const panda_real nu4_z = s5*neg_nu5_x + c5*nu6_z + (0.384*fu4_x - 0.0825*fu5_z);
    const panda_real t2 = -s4;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x = t2*fu5_z - c4*fu4_x;
    const panda_real neg_fu3_z = s4*fu4_x - c4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s4*nu4_y - c4*nu4_x;
    const panda_real nu3_y = 0.0825*neg_fu3_z - nu4_z;
    const panda_real nu3_z = t1 - (s4*nu4_x + c4*nu4_y);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x = c3*fu3_x + s3*fu4_z;
    const panda_real neg_fu2_z = c3*fu4_z - s3*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x = 0.316*neg_fu2_z - (s3*nu3_y - c3*nu3_x);
    const panda_real t3 = -s3;
    const panda_real nu2_z = 0.316*fu2_x - (t3*nu3_x - c3*nu3_y);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z = c2*nu3_z - s2*nu2_x;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h6_x = fu6_z + 0.231847552695;
    const panda_real t4 = c7*c7;
    const panda_real t5 = c7*s7;
    const panda_real t6 = 0.002420943778521227*t4 - 0.000782782563368495*t5;
    const panda_real t7 = t6 - 0.004552547872941087 - 0.176*fu6_z;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xx = 0.021522255370587554 - t7;
    const panda_real k6_xy = nu6_x - 0.014748570382675314;
    const panda_real k6_xz = 0.0001037589172186853 - (0.002420943778521227*t5 +
        0.0003913912816842475*(2.0*t4 - 1.0) + 0.088*fu6_x);
    const panda_real k6_yz = nu6_z - 9.35690973146064e-05;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = 0.05045667791624746 - t7;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x_2 = 0.17380470556899996*c6 - s6*h6_x;
    const panda_real fu5_z_2 = 0.17380470556899996*s6 + c6*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x = s6*k6_yz - c6*k6_xz;
    const panda_real nu5_z_2 = -s6*k6_xz - c6*k6_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real neg_fu4_x = c5*fu5_x_2;
    const panda_real t8 = -s5;
    const panda_real fu4_z_2 = t8*fu5_x_2;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_2 = -0.384*fu4_z_2 - (c5*nu5_x + s5*m6_6);
    const panda_real t9 = -0.0825*fu4_z_2;
    const panda_real nu4_y_2 = t9 - nu5_z_2;
    const panda_real nu4_z_2 = -0.384*neg_fu4_x - 0.0825*fu5_z_2 - (s5*nu5_x - c5*m6_6);
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_2 = c4*neg_fu4_x - s4*fu5_z_2;
    const panda_real fu3_z = s4*neg_fu4_x + c4*fu5_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_2 = s4*nu4_y_2 - c4*nu4_x_2;
    const panda_real nu3_y_2 = -0.0825*fu3_z - nu4_z_2;
    const panda_real nu3_z_2 = t9 + (t2*nu4_x_2 - c4*nu4_y_2);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const panda_real fu2_z = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2 - 0.316*fu2_z;
    const panda_real nu2_z_2 = s3*nu3_x_2 + c3*nu3_y_2 + 0.316*fu2_x_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2;
    const panda_real t10 = c6*c6;
    const panda_real t11 = t7 + 0.007412167175072353;
    const panda_real t12 = c6*s6;
    const panda_real t13 = t10*t11 + k6_xy*(2.0*t12);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_zz = k6_xx + t13;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h5_x = fu5_z_2 - 0.014653732538;
    const panda_real h5_y = fu6_x + 0.067870631425;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xx = 0.03038557861068662 - t13;
    const panda_real k5_yy = t6 + 0.012176791922741105;
    const panda_real k5_xy = nu5_x + 0.00151524447332703;
    const panda_real k5_xz = 0.004600245517563107 - (t11*t12 + k6_xy*(1.0 - 2.0*t10));
    const panda_real k5_yz = nu5_z_2 - 0.0021640520520981327;
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t6 - t13 + 0.04256237053342773;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_2 = c5*h5_y + s5*h5_x;
    const panda_real fu4_z_3 = s5*h5_y - c5*h5_x;
    const panda_real t14 = -0.384*fu4_z_3;
    const panda_real t15 = s5*k5_yz - c5*k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_3 = t14 - t15;
    const panda_real t16 = -0.0825*fu4_z_3;
    const panda_real nu4_y_3 = t16 - m5_5;
    const panda_real nu4_z_3 = 0.384*fu4_x_2 - (t8*k5_xz - c5*k5_yz);
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_3 = -c4*fu4_x_2;
    const panda_real neg_fu3_z_2 = s4*fu4_x_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_3 = s4*nu4_y_3 - c4*nu4_x_3;
    const panda_real nu3_y_3 = 0.0825*neg_fu3_z_2 - nu4_z_3;
    const panda_real nu3_z_3 = t16 + (t2*nu4_x_3 - c4*nu4_y_3);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3;
    const panda_real fu2_z_2 = s3*fu3_x_3 - c3*fu4_z_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_3 = c3*nu3_x_3 - s3*nu3_y_3 - 0.316*fu2_z_2;
    const panda_real nu2_z_3 = s3*nu3_x_3 + c3*nu3_y_3 + 0.316*fu2_x_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3;
    const panda_real t17 = c5*c5;
    const panda_real t18 = t6 + t13 - 0.018208786687945514;
    const panda_real t19 = c5*s5;
    const panda_real t20 = t17*t18 + k5_xy*(2.0*t19);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_zz = k5_xx + t20;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h4_x = fu4_z_3 + 0.5527802746499999;
    const panda_real h4_y = fu5_x_2 - 2.0125235536029997;
    const panda_real t21 = k5_yy - t20 + 0.165*fu4_z_3;
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xx = t21 + 0.05102013615681549;
    const panda_real t22 = 0.768*fu5_x_2 - k5_zz;
    const panda_real k4_yy = 0.6972920750309717 - t22;
    const panda_real k4_xy = t14 - (t15 - 0.0825*fu5_x_2) - 0.16284087268546082;
    const panda_real t23 = -0.0825*fu4_x_2;
    const panda_real k4_xz = 0.0039053550262761055 - (t18*t19 + k5_xy*(1.0 - 2.0*t17) - t23);
    const panda_real k4_yz = nu4_z_3 - 0.00164448757736928;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t21 - t22 + 0.7483122111877871;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_4 = c4*h4_y + s4*h4_x;
    const panda_real fu3_z_2 = s4*h4_y - c4*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_4 = c4*k4_xz - s4*k4_yz;
    const panda_real nu3_z_4 = s4*k4_xz + c4*k4_yz;
    const panda_real nu3_y_4 = -0.0825*fu3_z_2 - m4_4;
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_4 = c3*fu3_x_4;
    const panda_real fu2_z_3 = s3*fu3_x_4;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_4 = -0.316*fu2_z_3 - (s3*nu3_y_4 - c3*nu3_x_4);
    const panda_real nu2_z_4 = 0.316*fu2_x_4 - (t3*nu3_x_4 - c3*nu3_y_4);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4;
    const panda_real t24 = c4*s4;
    const panda_real t25 = c4*c4;
    const panda_real t26 = t21 + t22 - 0.6462719388741561;
    const panda_real t27 = k4_xy*(2.0*t24) - t25*t26;
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_zz = k4_xx + t27;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h3_x = fu3_z_2 + 0.746857959872;
    const panda_real h3_y = fu4_x_2 + 0.028227094877999827;
    const panda_real t28 = t27 - k4_yy - 0.165*fu3_z_2;
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_xx = 0.061602421026527694 - t28;
    const panda_real k3_yy = k4_zz + 0.022178148964878252;
    const panda_real k3_xy = 0.0001219124209507298 - (t23 - nu3_x_4);
    const panda_real k3_xz = t26*t24 - k4_xy*(1.0 - 2.0*t25) - 0.0825*fu3_x_4 +
        0.005487648106562251;
    const panda_real k3_yz = nu3_z_4 + 0.0043772571218395765;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = 0.08378056999140594 - (t28 - k4_zz);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_5 = -c3*h3_y - s3*h3_x;
    const panda_real fu2_z_4 = c3*h3_x - s3*h3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_5 = -0.316*fu2_z_4 - (c3*k3_xz - s3*k3_yz);
    const panda_real nu2_z_5 = 0.316*fu2_x_5 - (s3*k3_xz + c3*k3_yz);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_5 = c2*m3_3 - s2*nu2_x_5;
    const panda_real t29 = c3*s3;
    const panda_real t30 = c3*c3;
    const panda_real t31 = 0.039424272061649446 - (k4_zz + t28);
    const panda_real t32 = k3_xy*(2.0*t29) - t30*t31;
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real k2_zz = k3_xx + t32;
    const panda_real t33 = k3_zz - 0.632*fu3_x_4;
    const panda_real k2_yy = t33 + 1.0321620612318807;
    const panda_real k2_xy = nu2_x_5 + 0.003983358883935522;
    const panda_real k2_xz = t31*t29 - k3_xy*(1.0 - 2.0*t30) - 0.010261101821008168;
    const panda_real k2_yz = nu2_z_5 - 0.0007689361029464017;
    const panda_real t34 = t32 - k3_yy;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = 1.0552399437268125 - (t34 - t33);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_6 = s2*k2_xz + c2*k2_yz;
    const panda_real t35 = k2_zz + (k2_yy - (c2*c2*(t34 + t33 + 1.009084178736949) +
        k2_xy*(2.0*(c2*s2))));
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = t35 + 0.014259565994474374;
    M[0] = m1_1;
    M[1] = nu1_z_6;
    M[2] = nu1_z_5;
    M[3] = nu1_z_4;
    M[4] = nu1_z_3;
    M[5] = nu1_z_2;
    M[6] = nu1_z;
    M[7] = nu1_z_6;
    M[8] = m2_2;
    M[9] = nu2_z_5;
    M[10] = nu2_z_4;
    M[11] = nu2_z_3;
    M[12] = nu2_z_2;
    M[13] = nu2_z;
    M[14] = nu1_z_5;
    M[15] = nu2_z_5;
    M[16] = m3_3;
    M[17] = nu3_z_4;
    M[18] = nu3_z_3;
    M[19] = nu3_z_2;
    M[20] = nu3_z;
    M[21] = nu1_z_4;
    M[22] = nu2_z_4;
    M[23] = nu3_z_4;
    M[24] = m4_4;
    M[25] = nu4_z_3;
    M[26] = nu4_z_2;
    M[27] = nu4_z;
    M[28] = nu1_z_3;
    M[29] = nu2_z_3;
    M[30] = nu3_z_3;
    M[31] = nu4_z_3;
    M[32] = m5_5;
    M[33] = nu5_z_2;
    M[34] = nu5_z;
    M[35] = nu1_z_2;
    M[36] = nu2_z_2;
    M[37] = nu3_z_2;
    M[38] = nu4_z_2;
    M[39] = nu5_z_2;
    M[40] = m6_6;
    M[41] = nu6_z;
    M[42] = nu1_z;
    M[43] = nu2_z;
    M[44] = nu3_z;
    M[45] = nu4_z;
    M[46] = nu5_z;
    M[47] = nu6_z;
    M[48] = 0.006684151967360947;
}

/* accelerations that the torques tau give
 * 629 multiplications, 551 additions, 7 divisions = 1187; 21 unary minus; 12 sine/cosine */
void panda_forward_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real tau[7],
    panda_real qdd[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(again[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(again[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(again[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(again[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(again[6]);
    /* link 6: force for a unit acceleration of a joint further out */
    const panda_real fu6_x = -0.002573605371338201*s7 - 0.0020344399586618637*c7;
    const panda_real fu6_z = 0.002573605371338201*c7 - 0.0020344399586618637*s7;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = 0.0012555365982729084*s7 - 0.0009653051699191118*c7;
    const panda_real nu6_z = -0.0012555365982729084*c7 - 0.0009653051699191118*s7;
    const panda_real nu6_y = -0.088*fu6_z - 0.006684151967360947;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x = c6*fu6_x;
    const panda_real fu5_z = s6*fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real neg_nu5_x = s6*nu6_y - c6*nu6_x;
    const panda_real nu5_z = s6*nu6_x + c6*nu6_y;
    const panda_real t1 = -c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x = t1*fu5_x - s5*fu6_z;
    const panda_real fu4_z = c5*fu6_z - s5*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = c5*neg_nu5_x - s5*nu6_z - 0.384*fu4_z;
    const panda_real t2 = -0.0825*fu4_z;
    const panda_real nu4_y = t2 - nu5_z;
    const panda_real nu4_z = s5*neg_nu5_x + c5*nu6_z + (0.384*fu4_x - 0.0825*fu5_z);
    const panda_real t3 = -s4;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x = t3*fu5_z - c4*fu4_x;
    const panda_real neg_fu3_z = s4*fu4_x - c4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s4*nu4_y - c4*nu4_x;
    const panda_real nu3_y = 0.0825*neg_fu3_z - nu4_z;
    const panda_real nu3_z = t2 - (s4*nu4_x + c4*nu4_y);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x = c3*fu3_x + s3*fu4_z;
    const panda_real neg_fu2_z = c3*fu4_z - s3*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x = 0.316*neg_fu2_z - (s3*nu3_y - c3*nu3_x);
    const panda_real t4 = -s3;
    const panda_real nu2_z = 0.316*fu2_x - (t4*nu3_x - c3*nu3_y);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z = c2*nu3_z - s2*nu2_x;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h6_x = fu6_z + 0.231847552695;
    const panda_real t5 = c7*c7;
    const panda_real t6 = c7*s7;
    const panda_real t7 = 0.002420943778521227*t5 - 0.000782782563368495*t6;
    const panda_real t8 = t7 - 0.004552547872941087 - 0.176*fu6_z;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xx = 0.021522255370587554 - t8;
    const panda_real k6_xy = nu6_x - 0.014748570382675314;
    const panda_real k6_xz = 0.0001037589172186853 - (0.002420943778521227*t6 +
        0.0003913912816842475*(2.0*t5 - 1.0) + 0.088*fu6_x);
    const panda_real k6_yz = nu6_z - 9.35690973146064e-05;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = 0.05045667791624746 - t8;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x_2 = 0.17380470556899996*c6 - s6*h6_x;
    const panda_real fu5_z_2 = 0.17380470556899996*s6 + c6*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x = s6*k6_yz - c6*k6_xz;
    const panda_real t9 = -s6;
    const panda_real nu5_z_2 = t9*k6_xz - c6*k6_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real neg_fu4_x = c5*fu5_x_2;
    const panda_real t10 = -s5;
    const panda_real fu4_z_2 = t10*fu5_x_2;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_2 = -0.384*fu4_z_2 - (c5*nu5_x + s5*m6_6);
    const panda_real t11 = -0.0825*fu4_z_2;
    const panda_real nu4_y_2 = t11 - nu5_z_2;
    const panda_real neg_nu4_z = s5*nu5_x - c5*m6_6 + (0.0825*fu5_z_2 + 0.384*neg_fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_2 = c4*neg_fu4_x - s4*fu5_z_2;
    const panda_real fu3_z = s4*neg_fu4_x + c4*fu5_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_2 = s4*nu4_y_2 - c4*nu4_x_2;
    const panda_real nu3_y_2 = neg_nu4_z - 0.0825*fu3_z;
    const panda_real nu3_z_2 = t11 + (t3*nu4_x_2 - c4*nu4_y_2);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const panda_real fu2_z = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_2 = c3*nu3_x_2 - s3*nu3_y_2 - 0.316*fu2_z;
    const panda_real nu2_z_2 = s3*nu3_x_2 + c3*nu3_y_2 + 0.316*fu2_x_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2;
    const panda_real t12 = c6*c6;
    const panda_real t13 = t8 + 0.007412167175072353;
    const panda_real t14 = c6*s6;
    const panda_real t15 = t12*t13 + k6_xy*(2.0*t14);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_zz = k6_xx + t15;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h5_x = fu5_z_2 - 0.014653732538;
    const panda_real h5_y = fu6_x + 0.067870631425;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xx = 0.03038557861068662 - t15;
    const panda_real k5_yy = t7 + 0.012176791922741105;
    const panda_real k5_xy = nu5_x + 0.00151524447332703;
    const panda_real k5_xz = 0.004600245517563107 - (t13*t14 + k6_xy*(1.0 - 2.0*t12));
    const panda_real k5_yz = nu5_z_2 - 0.0021640520520981327;
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t7 - t15 + 0.04256237053342773;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_2 = c5*h5_y + s5*h5_x;
    const panda_real fu4_z_3 = s5*h5_y - c5*h5_x;
    const panda_real t16 = -0.384*fu4_z_3;
    const panda_real t17 = s5*k5_yz - c5*k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_3 = t16 - t17;
    const panda_real t18 = -0.0825*fu4_z_3;
    const panda_real nu4_y_3 = t18 - m5_5;
    const panda_real nu4_z_2 = 0.384*fu4_x_2 - (t10*k5_xz - c5*k5_yz);
    const panda_real t19 = -c4;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_3 = t19*fu4_x_2;
    const panda_real neg_fu3_z_2 = s4*fu4_x_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_3 = s4*nu4_y_3 - c4*nu4_x_3;
    const panda_real nu3_y_3 = 0.0825*neg_fu3_z_2 - nu4_z_2;
    const panda_real nu3_z_3 = t18 + (t3*nu4_x_3 - c4*nu4_y_3);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3;
    const panda_real fu2_z_2 = s3*fu3_x_3 - c3*fu4_z_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_3 = c3*nu3_x_3 - s3*nu3_y_3 - 0.316*fu2_z_2;
    const panda_real nu2_z_3 = s3*nu3_x_3 + c3*nu3_y_3 + 0.316*fu2_x_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3;
    const panda_real t20 = c5*c5;
    const panda_real t21 = t7 + t15 - 0.018208786687945514;
    const panda_real t22 = c5*s5;
    const panda_real t23 = t20*t21 + k5_xy*(2.0*t22);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_zz = k5_xx + t23;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h4_x = fu4_z_3 + 0.5527802746499999;
    const panda_real h4_y = fu5_x_2 - 2.0125235536029997;
    const panda_real t24 = k5_yy - t23 + 0.165*fu4_z_3;
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xx = t24 + 0.05102013615681549;
    const panda_real t25 = 0.768*fu5_x_2 - k5_zz;
    const panda_real k4_yy = 0.6972920750309717 - t25;
    const panda_real k4_xy = t16 - (t17 - 0.0825*fu5_x_2) - 0.16284087268546082;
    const panda_real t26 = -0.0825*fu4_x_2;
    const panda_real k4_xz = 0.0039053550262761055 - (t21*t22 + k5_xy*(1.0 - 2.0*t20) - t26);
    const panda_real k4_yz = nu4_z_2 - 0.00164448757736928;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t24 - t25 + 0.7483122111877871;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_4 = c4*h4_y + s4*h4_x;
    const panda_real fu3_z_2 = s4*h4_y - c4*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_4 = c4*k4_xz - s4*k4_yz;
    const panda_real nu3_z_4 = s4*k4_xz + c4*k4_yz;
    const panda_real nu3_y_4 = -0.0825*fu3_z_2 - m4_4;
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_4 = c3*fu3_x_4;
    const panda_real fu2_z_3 = s3*fu3_x_4;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_4 = -0.316*fu2_z_3 - (s3*nu3_y_4 - c3*nu3_x_4);
    const panda_real nu2_z_4 = 0.316*fu2_x_4 - (t4*nu3_x_4 - c3*nu3_y_4);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4;
    const panda_real t27 = c4*s4;
    const panda_real t28 = c4*c4;
    const panda_real t29 = t24 + t25 - 0.6462719388741561;
    const panda_real t30 = k4_xy*(2.0*t27) - t28*t29;
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_zz = k4_xx + t30;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h3_x = fu3_z_2 + 0.746857959872;
    const panda_real h3_y = fu4_x_2 + 0.028227094877999827;
    const panda_real t31 = t30 - k4_yy - 0.165*fu3_z_2;
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_xx = 0.061602421026527694 - t31;
    const panda_real k3_yy = k4_zz + 0.022178148964878252;
    const panda_real k3_xy = 0.0001219124209507298 - (t26 - nu3_x_4);
    const panda_real k3_xz = t29*t27 - k4_xy*(1.0 - 2.0*t28) - 0.0825*fu3_x_4 +
        0.005487648106562251;
    const panda_real k3_yz = nu3_z_4 + 0.0043772571218395765;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = 0.08378056999140594 - (t31 - k4_zz);
    /* link 2: force for a unit acceleration of a joint further out */
    const panda_real fu2_x_5 = -c3*h3_y - s3*h3_x;
    const panda_real fu2_z_4 = c3*h3_x - s3*h3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_x_5 = -0.316*fu2_z_4 - (c3*k3_xz - s3*k3_yz);
    const panda_real nu2_z_5 = 0.316*fu2_x_5 - (s3*k3_xz + c3*k3_yz);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_5 = c2*m3_3 - s2*nu2_x_5;
    const panda_real t32 = c3*s3;
    const panda_real t33 = c3*c3;
    const panda_real t34 = 0.039424272061649446 - (k4_zz + t31);
    const panda_real t35 = k3_xy*(2.0*t32) - t33*t34;
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real k2_zz = k3_xx + t35;
    const panda_real t36 = k3_zz - 0.632*fu3_x_4;
    const panda_real k2_yy = t36 + 1.0321620612318807;
    const panda_real k2_xy = nu2_x_5 + 0.003983358883935522;
    const panda_real k2_xz = t34*t32 - k3_xy*(1.0 - 2.0*t33) - 0.010261101821008168;
    const panda_real k2_yz = nu2_z_5 - 0.0007689361029464017;
    const panda_real t37 = t35 - k3_yy;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = 1.0552399437268125 - (t37 - t36);
    /* link 1: moment for a unit acceleration of a joint further out */
    const panda_real nu1_z_6 = s2*k2_xz + c2*k2_yz;
    const panda_real t38 = k2_zz + (k2_yy - (c2*c2*(t37 + t36 + 1.009084178736949) +
        k2_xy*(2.0*(c2*s2))));
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = t38 + 0.014259565994474374;
    const panda_real t39 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_x = t39*s2;
    const panda_real w2_y = t39*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a2_x = -9.81*s2;
    const panda_real a2_y = -9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = qd[1]*w2_y;
    const panda_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xy = w2_x*w2_y;
    const panda_real ww2_xx = w2_x*w2_x;
    const panda_real ww2_yy = w2_y*w2_y;
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_11 = ww2_yy + ww2_zz;
    const panda_real neg_lam2_22 = ww2_xx + ww2_zz;
    const panda_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_z = -0.316*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t40 = -0.632*alpha2_x;
    const panda_real t41 = 0.316*ww2_xy - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t40 - c3*t41;
    const panda_real a3_y = s3*t41 + c3*t40;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const panda_real alpha3_y = t4*alpha2_x - qd[2]*w3_x;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yz = w3_y*w3_z;
    const panda_real ww3_zx = w3_x*w3_z;
    const panda_real ww3_xy = w3_x*w3_y;
    const panda_real ww3_xx = w3_x*w3_x;
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    const panda_real lam3_12 = alpha2_y + ww3_xy;
    const panda_real lam3_13 = alpha3_y + ww3_zx;
    const panda_real lam3_21 = ww3_xy - alpha2_y;
    const panda_real neg_lam3_22 = ww3_xx + ww3_zz;
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real lam3_32 = alpha3_x + ww3_yz;
    const panda_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_z = -0.0825*lam3_21 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t19*w3_x - s4*w3_z;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t42 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t43 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t42 - s4*t43;
    const panda_real neg_a4_y = s4*t42 + c4*t43;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = s4*alpha2_y - c4*alpha3_x + qd[3]*w4_y;
    const panda_real alpha4_y = s4*alpha3_x + c4*alpha2_y - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_yz = w4_y*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yy = w4_y*w4_y;
    const panda_real neg_ww4_zz = -w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_11 = neg_ww4_zz - ww4_yy;
    const panda_real lam4_12 = alpha3_y + ww4_xy;
    const panda_real lam4_13 = alpha4_y + ww4_zx;
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    const panda_real lam4_22 = neg_ww4_zz - ww4_xx;
    const panda_real lam4_23 = ww4_yz - alpha4_x;
    const panda_real lam4_31 = ww4_zx - alpha4_y;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real lam4_33 = -ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (0.384*lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -(c5*w4_x) - s5*w4_z;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t44 = 0.384*lam4_32 - 0.0825*lam4_31 - a4_z;
    const panda_real t45 = a4_x - (0.384*lam4_12 - 0.0825*lam4_11);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*t44 - c5*t45;
    const panda_real a5_y = s5*t45 + c5*t44;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_x = qd[4]*w5_y - (c5*alpha4_x - s5*alpha3_y);
    const panda_real alpha5_y = s5*alpha4_x + c5*alpha3_y - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real ww5_yz = w5_y*w5_z;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real ww5_xy = w5_x*w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_yy = w5_y*w5_y;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_11 = ww5_yy + ww5_zz;
    const panda_real lam5_12 = alpha4_y + ww5_xy;
    const panda_real lam5_13 = alpha5_y + ww5_zx;
    const panda_real lam5_21 = ww5_xy - alpha4_y;
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    const panda_real lam5_23 = ww5_yz - alpha5_x;
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real lam5_32 = alpha5_x + ww5_yz;
    const panda_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = c6*w5_x + s6*w5_z;
    const panda_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a6_x = c6*a5_x + s6*a5_z;
    const panda_real a6_y = c6*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const panda_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const panda_real alpha6_y = t9*alpha5_x - c6*alpha4_y - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_yz = w6_y*w6_z;
    const panda_real ww6_zx = w6_x*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_xx = w6_x*w6_x;
    const panda_real ww6_yy = w6_y*w6_y;
    const panda_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_11 = ww6_yy + ww6_zz;
    const panda_real lam6_12 = alpha5_y + ww6_xy;
    const panda_real lam6_13 = alpha6_y + ww6_zx;
    const panda_real lam6_21 = ww6_xy - alpha5_y;
    const panda_real neg_lam6_22 = ww6_xx + ww6_zz;
    const panda_real lam6_23 = ww6_yz - alpha6_x;
    const panda_real lam6_31 = ww6_zx - alpha6_y;
    const panda_real lam6_32 = alpha6_x + ww6_yz;
    const panda_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a7_z = -0.088*lam6_21 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_x = c7*w6_x + s7*w6_z;
    const panda_real w7_y = c7*w6_z - s7*w6_x;
    const panda_real t46 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t47 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t46 + s7*t47;
    const panda_real a7_y = s7*t46 - c7*t47;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (s7*alpha5_y - c7*alpha6_x);
    const panda_real t48 = -s7;
    const panda_real alpha7_y = t48*alpha6_x - c7*alpha5_y - qd[6]*w7_x;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_yz = w7_y*w7_z;
    const panda_real ww7_zx = w7_x*w7_z;
    const panda_real ww7_xy = w7_x*w7_y;
    const panda_real ww7_xx = w7_x*w7_x;
    const panda_real ww7_yy = w7_y*w7_y;
    const panda_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam7_11 = ww7_yy + ww7_zz;
    const panda_real lam7_12 = alpha6_y + ww7_xy;
    const panda_real lam7_13 = alpha7_y + ww7_zx;
    const panda_real lam7_21 = ww7_xy - alpha6_y;
    const panda_real neg_lam7_22 = ww7_xx + ww7_zz;
    const panda_real lam7_23 = ww7_yz - alpha7_x;
    const panda_real neg_lam7_31 = alpha7_y - ww7_zx;
    const panda_real lam7_32 = alpha7_x + ww7_yz;
    const panda_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 2: moment that turns the link [N m] */
    const panda_real neg_nc2_x = 0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) -
        2.0643241224637614*alpha2_x + (0.007966717767871044*alpha2_y - 0.010261101821008168*ww2_xy);
    const panda_real nc2_y = 0.04615576498986361*alpha2_y + 0.010261101821008168*(neg_lam2_11 -
        neg_lam2_33) - (0.0007689361029464017*ww2_xy + 0.007966717767871044*alpha2_x);
    const panda_real nc2_z = 0.01993386669246*c2 - 32.809545426852715*s2 - (1.009084178736949*ww2_xy
        - 0.003983358883935522*(neg_lam2_11 - neg_lam2_22));
    /* link 3: force that moves the link [N] */
    const panda_real fc3_x = 0.028227094877999827*lam3_12 - 0.746857959872*neg_lam3_11;
    const panda_real fc3_y = 0.746857959872*lam3_21 - 0.028227094877999827*neg_lam3_22;
    /* link 3: moment that turns the link [N m] */
    const panda_real nc3_x = 0.028227094877999827*a3_z - (-0.022178148964878252*lam3_32 -
        0.0043772571218395765*(neg_lam3_22 - neg_lam3_33) + (0.005487648106562251*lam3_21 -
        0.0001219124209507298*lam3_31));
    const panda_real nc3_y = -0.061602421026527694*lam3_31 - 0.005487648106562251*(neg_lam3_11 -
        neg_lam3_33) + (0.0043772571218395765*lam3_12 - 0.0001219124209507298*lam3_32) -
        0.746857959872*a3_z;
    const panda_real t49 = 0.022178148964878252*lam3_12 - 0.061602421026527694*lam3_21 -
        0.0001219124209507298*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251*lam3_23 -
        0.0043772571218395765*lam3_13);
    const panda_real nc3_z = 0.746857959872*a3_y - 0.028227094877999827*a3_x - t49;
    /* link 4: force that moves the link [N] */
    const panda_real fc4_x = 0.5527802746499999*lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 - 2.0125235536029997*lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(lam4_33 - lam4_22) -
        (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) - 2.0125235536029997*a4_z;
    const panda_real nc4_y = -0.5527802746499999*a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(lam4_33 - lam4_11) + (0.00164448757736928*lam4_12 -
        0.16284087268546082*lam4_32));
    const panda_real t50 = 0.6972920750309717*lam4_12 - 0.05102013615681549*lam4_21 +
        0.16284087268546082*(lam4_22 - lam4_11) + (-0.0039053550262761055*lam4_23 -
        0.00164448757736928*lam4_13);
    const panda_real neg_nc4_z = t50 + (0.5527802746499999*neg_a4_y - 2.0125235536029997*a4_x);
    /* link 5: force that moves the link [N] */
    const panda_real fc5_x = 0.014653732538*neg_lam5_11 + 0.067870631425*lam5_12;
    const panda_real fc5_y = -0.067870631425*neg_lam5_22 - 0.014653732538*lam5_21;
    const panda_real fc5_z = 0.067870631425*lam5_32 - 0.014653732538*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const panda_real nc5_x = 0.067870631425*a5_z - (0.0021640520520981327*(neg_lam5_22 -
        neg_lam5_33) - 0.010045187828321245*lam5_32 + (0.004600245517563107*lam5_21 -
        0.00151524447332703*lam5_31));
    const panda_real nc5_y = -0.001451156065026714*lam5_31 - 0.004600245517563107*(neg_lam5_11 -
        neg_lam5_33) + (-0.0021640520520981327*lam5_12 - 0.00151524447332703*lam5_32) +
        0.014653732538*a5_z;
    const panda_real t51 = 0.001451156065026714*lam5_21 - 0.010045187828321245*lam5_12 +
        0.00151524447332703*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107*lam5_23 +
        0.0021640520520981327*lam5_13);
    const panda_real nc5_z = t51 - (0.014653732538*a5_y + 0.067870631425*a5_x);
    /* link 6: force that moves the link [N] */
    const panda_real fc6_x = -0.231847552695*neg_lam6_11 - 0.17380470556899996*lam6_12;
    const panda_real fc6_y = 0.231847552695*lam6_21 + 0.17380470556899996*neg_lam6_22;
    const panda_real fc6_z = 0.231847552695*lam6_31 - 0.17380470556899996*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const panda_real nc6_x = 0.17380470556899996*a5_y - (9.35690973146064e-05*(neg_lam6_22 -
        neg_lam6_33) - 0.028934422545659907*lam6_32 - (-0.014748570382675314*lam6_31 -
        0.0001037589172186853*lam6_21));
    const panda_real nc6_y = -0.021522255370587554*lam6_31 - 0.0001037589172186853*(neg_lam6_11 -
        neg_lam6_33) - (9.35690973146064e-05*lam6_12 - 0.014748570382675314*lam6_32) +
        0.231847552695*a5_y;
    const panda_real t52 = 0.028934422545659907*lam6_12 - 0.021522255370587554*lam6_21 +
        0.014748570382675314*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853*lam6_23 +
        9.35690973146064e-05*lam6_13);
    const panda_real nc6_z = 0.231847552695*a6_y + 0.17380470556899996*a6_x - t52;
    /* link 7: force that moves the link [N] */
    const panda_real fc7_x = 0.0020344399586618637*lam7_12 - 0.002573605371338201*neg_lam7_11;
    const panda_real fc7_y = 0.002573605371338201*lam7_21 - 0.0020344399586618637*neg_lam7_22;
    const panda_real neg_fc7_z = 0.002573605371338201*neg_lam7_31 - 0.0020344399586618637*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = 0.0020344399586618637*a7_z - (-0.004552547872941087*lam7_32 -
        0.0012555365982729084*(neg_lam7_22 - neg_lam7_33) - (0.0003913912816842475*neg_lam7_31 -
        0.0009653051699191118*lam7_21));
    const panda_real nc7_y = 0.00213160409441986*neg_lam7_31 - 0.0009653051699191118*(neg_lam7_11 -
        neg_lam7_33) + (0.0012555365982729084*lam7_12 + 0.0003913912816842475*lam7_32) -
        0.002573605371338201*a7_z;
    const panda_real t53 = 0.004552547872941087*lam7_12 - 0.00213160409441986*lam7_21 +
        0.0003913912816842475*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118*lam7_23 -
        0.0012555365982729084*lam7_13);
    const panda_real nc7_z = 0.002573605371338201*a7_y + 0.0020344399586618637*neg_a7_x - t53;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f07_x = c7*fc7_x - s7*fc7_y;
    const panda_real neg_f07_y = t48*fc7_x - c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y + 0.088*neg_f07_y - nc7_z;
    const panda_real n6_z = n07_y + (nc6_z + 0.088*neg_fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y + neg_fc7_z;
    const panda_real f6_z = fc6_z - neg_f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f06_x = c6*f6_x - s6*f6_y;
    const panda_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n06_x = c6*n6_x - s6*n6_y;
    const panda_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_x = nc5_x + n06_x;
    const panda_real n5_y = nc5_y - n6_z;
    const panda_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const panda_real f5_x = fc5_x + f06_x;
    const panda_real f5_y = fc5_y - f6_z;
    const panda_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const panda_real neg_f05_x = c5*f5_x - s5*f5_y;
    const panda_real f05_y = t1*f5_y - s5*f5_x;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = t10*n5_x - c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x - 0.384*f05_y);
    const panda_real n4_y = nc4_y - 0.0825*f05_y - n5_z;
    const panda_real n4_z = n05_y - (neg_nc4_z + (0.0825*f5_z + 0.384*neg_f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x - neg_f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = t3*f4_x - c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real n04_y = t19*n4_y - s4*n4_x;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = n04_y - (0.0825*f4_z - nc3_z);
    /* link 3: force through the joint [N] */
    const panda_real f3_x = fc3_x + f04_x;
    const panda_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f03_x = c3*f3_x - s3*f3_y;
    const panda_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n03_x = c3*n3_x - s3*n3_y;
    const panda_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real neg_n2_x = neg_nc2_x + 0.316*f03_y - n03_x;
    const panda_real n2_y = nc2_y - n3_z;
    const panda_real n2_z = n03_y - (-0.316*f03_x - nc2_z);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = s2*neg_n2_x - c2*n2_y;
    /* link 1: forward substitution */
    const panda_real y1 = tau[0] - n02_y;
    /* factorisation M = L D L^T */
    const panda_real ipivot1 = 1.0 / m1_1;
    const panda_real l2_1 = nu1_z_6*ipivot1;
    const panda_real l3_1 = nu1_z_5*ipivot1;
    const panda_real l4_1 = nu1_z_4*ipivot1;
    const panda_real l5_1 = nu1_z_3*ipivot1;
    const panda_real l6_1 = nu1_z_2*ipivot1;
    const panda_real l7_1 = nu1_z*ipivot1;
    const panda_real pivot2 = m2_2 - nu1_z_6*l2_1;
    const panda_real ipivot2 = 1.0 / pivot2;
    const panda_real ld3_2 = nu2_z_5 - nu1_z_6*l3_1;
    const panda_real l3_2 = ipivot2*ld3_2;
    const panda_real ld4_2 = nu2_z_4 - nu1_z_6*l4_1;
    const panda_real l4_2 = ipivot2*ld4_2;
    const panda_real ld5_2 = nu2_z_3 - nu1_z_6*l5_1;
    const panda_real l5_2 = ipivot2*ld5_2;
    const panda_real ld6_2 = nu2_z_2 - nu1_z_6*l6_1;
    const panda_real l6_2 = ipivot2*ld6_2;
    const panda_real ld7_2 = nu2_z - nu1_z_6*l7_1;
    const panda_real l7_2 = ipivot2*ld7_2;
    const panda_real pivot3 = m3_3 - nu1_z_5*l3_1 - ld3_2*l3_2;
    const panda_real ipivot3 = 1.0 / pivot3;
    const panda_real ld4_3 = nu3_z_4 - nu1_z_5*l4_1 - ld3_2*l4_2;
    const panda_real l4_3 = ipivot3*ld4_3;
    const panda_real ld5_3 = nu3_z_3 - nu1_z_5*l5_1 - ld3_2*l5_2;
    const panda_real l5_3 = ipivot3*ld5_3;
    const panda_real ld6_3 = nu3_z_2 - nu1_z_5*l6_1 - ld3_2*l6_2;
    const panda_real l6_3 = ipivot3*ld6_3;
    const panda_real ld7_3 = nu3_z - nu1_z_5*l7_1 - ld3_2*l7_2;
    const panda_real l7_3 = ipivot3*ld7_3;
    const panda_real pivot4 = m4_4 - nu1_z_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const panda_real ipivot4 = 1.0 / pivot4;
    const panda_real ld5_4 = -(nu1_z_4*l5_1 - nu4_z_2 + ld4_2*l5_2) - ld4_3*l5_3;
    const panda_real l5_4 = ipivot4*ld5_4;
    const panda_real ld6_4 = -(neg_nu4_z + nu1_z_4*l6_1 + ld4_2*l6_2) - ld4_3*l6_3;
    const panda_real l6_4 = ipivot4*ld6_4;
    const panda_real ld7_4 = nu4_z - nu1_z_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3;
    const panda_real l7_4 = ipivot4*ld7_4;
    const panda_real pivot5 = m5_5 - nu1_z_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const panda_real ipivot5 = 1.0 / pivot5;
    const panda_real ld6_5 = nu5_z_2 - nu1_z_3*l6_1 - ld5_2*l6_2 - ld5_3*l6_3 - ld5_4*l6_4;
    const panda_real l6_5 = ipivot5*ld6_5;
    const panda_real ld7_5 = -ld5_4*l7_4 - (nu1_z_3*l7_1 - nu5_z + ld5_2*l7_2 + ld5_3*l7_3);
    const panda_real l7_5 = ipivot5*ld7_5;
    const panda_real pivot6 = -(ld6_2*l6_2 - (m6_6 - nu1_z_2*l6_1) + ld6_3*l6_3 + ld6_4*l6_4) -
        ld6_5*l6_5;
    const panda_real ipivot6 = 1.0 / pivot6;
    const panda_real ld7_6 = -ld6_5*l7_5 - (nu1_z_2*l7_1 - nu6_z + ld6_2*l7_2 + ld6_3*l7_3 +
        ld6_4*l7_4);
    const panda_real l7_6 = ipivot6*ld7_6;
    const panda_real t54 = 0.006684151967360947 - nu1_z*l7_1 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4
        - ld7_5*l7_5;
    const panda_real pivot7 = t54 - ld7_6*l7_6;
    const panda_real ipivot7 = 1.0 / pivot7;
    /* link 2: forward substitution */
    const panda_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const panda_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const panda_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const panda_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const panda_real y6 = tau[5] - n6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    const panda_real t55 = tau[6] - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5;
    /* link 7: forward substitution */
    const panda_real y7 = t55 - l7_6*y6;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd7 = ipivot7*y7;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd6 = ipivot6*y6 - l7_6*qdd7;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd3 = -(l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6) - l7_3*qdd7;
    const panda_real t56 = -(l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 + l6_2*qdd6);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd2 = t56 - l7_2*qdd7;
    const panda_real t57 = l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd1 = -l7_1*qdd7 - t57;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
