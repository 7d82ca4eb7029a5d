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
 *   inverse_dynamics: 308 multiplications, 292 additions = 600; 8 unary minus; 12 sine/cosine
 *   gravity: 64 multiplications, 38 additions = 102; 1 unary minus; 12 sine/cosine
 *   bias: 300 multiplications, 273 additions = 573; 8 unary minus; 12 sine/cosine
 *   mass_matrix: 203 multiplications, 173 additions = 376; 7 unary minus; 12 sine/cosine
 *   forward_dynamics: 629 multiplications, 551 additions, 7 divisions = 1187; 22 unary minus; 12
 *       sine/cosine
 */
#include "panda.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 308 multiplications, 292 additions = 600; 8 unary minus; 12 sine/cosine */
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
    const panda_real neg_a2_x = 9.81*s2;
    const panda_real neg_a2_y = 9.81*c2;
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
    const panda_real a3_z = neg_a2_y - 0.316*neg_lam2_22;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t2 = -0.316*lam2_32;
    const panda_real t3 = neg_a2_x + 0.316*lam2_12;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t2 - c3*t3;
    const panda_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = qd[2]*w3_y - (-qdd[1]*s3 - c3*alpha2_x);
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
    const panda_real t4 = -s4;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t4*w3_z - c4*w3_x;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t5 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t6 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t5 - s4*t6;
    const panda_real neg_a4_y = s4*t5 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = t4*alpha3_z - c4*alpha3_x + qd[3]*w4_y;
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
    const panda_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_11 = ww4_yy + ww4_zz;
    const panda_real lam4_12 = ww4_xy - alpha4_z;
    const panda_real lam4_13 = ww4_zx - neg_alpha4_y;
    const panda_real lam4_21 = alpha4_z + ww4_xy;
    const panda_real neg_lam4_22 = ww4_xx + ww4_zz;
    const panda_real neg_lam4_23 = alpha4_x - ww4_yz;
    const panda_real lam4_31 = neg_alpha4_y + ww4_zx;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (-0.384*neg_lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -s5*w4_z - c5*w4_x;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t7 = neg_a4_z + (0.384*lam4_32 - 0.0825*lam4_31);
    const panda_real t8 = a4_x - (0.0825*neg_lam4_11 + 0.384*lam4_12);
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
    const panda_real alpha6_x = qd[5]*w6_y - (-s6*alpha5_z - c6*alpha5_x);
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
    const panda_real neg_a7_z = a6_y + 0.088*lam6_21;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_x = c7*w6_x + s7*w6_z;
    const panda_real w7_y = c7*w6_z - s7*w6_x;
    const panda_real t9 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t10 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t9 + s7*t10;
    const panda_real a7_y = s7*t9 - c7*t10;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (-s7*alpha6_z - c7*alpha6_x);
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
    const panda_real nc2_x = 0.003983358883935522*lam2_31 + 0.010261101821008168*lam2_21 -
        (0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) - 1.0321620612318807*lam2_32);
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
    const panda_real fc4_x = -0.5527802746499999*neg_lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 + 2.0125235536029997*neg_lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(neg_lam4_22 -
        neg_lam4_33) - (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) +
        2.0125235536029997*neg_a4_z;
    const panda_real nc4_y = 0.5527802746499999*neg_a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(neg_lam4_11 - neg_lam4_33) - (0.16284087268546082*lam4_32 -
        0.00164448757736928*lam4_12));
    const panda_real t13 = 0.05102013615681549*lam4_21 - 0.6972920750309717*lam4_12 -
        0.16284087268546082*(neg_lam4_11 - neg_lam4_22) - (0.0039053550262761055*neg_lam4_23 -
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
    const panda_real fc7_z = 0.0020344399586618637*lam7_32 - 0.002573605371338201*neg_lam7_31;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = -0.0020344399586618637*neg_a7_z - (-0.004552547872941087*lam7_32 -
        0.0012555365982729084*(neg_lam7_22 - neg_lam7_33) - (0.0003913912816842475*neg_lam7_31 -
        0.0009653051699191118*lam7_21));
    const panda_real nc7_y = 0.00213160409441986*neg_lam7_31 - 0.0009653051699191118*(neg_lam7_11 -
        neg_lam7_33) - (-0.0012555365982729084*lam7_12 - 0.0003913912816842475*lam7_32) +
        0.002573605371338201*neg_a7_z;
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
    const panda_real n6_z = n07_y + (nc6_z - 0.088*fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y - fc7_z;
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
    const panda_real f05_x = s5*f5_y - c5*f5_x;
    const panda_real neg_f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = -c5*n5_y - s5*n5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x + 0.384*neg_f05_y);
    const panda_real n4_y = nc4_y + 0.0825*neg_f05_y - n5_z;
    const panda_real n4_z = n05_y + (nc4_z - (0.0825*f5_z - 0.384*f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x + f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z - neg_f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = -c4*f4_y - s4*f4_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real neg_n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = nc3_z - 0.0825*f4_z - neg_n04_y;
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
    const panda_real n2_x = n03_x + (nc2_x - 0.316*f03_y);
    const panda_real neg_n2_y = n3_z - nc2_y;
    const panda_real n2_z = n03_y + (nc2_z + 0.316*f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = c2*neg_n2_y - s2*n2_x;
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
 * 64 multiplications, 38 additions = 102; 1 unary minus; 12 sine/cosine */
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
    const panda_real neg_a2_x = 9.81*s2;
    const panda_real neg_a2_y = 9.81*c2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a3_x = c3*neg_a2_x;
    const panda_real a3_y = s3*neg_a2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*neg_a3_x - s4*neg_a2_y;
    const panda_real neg_a4_y = s4*neg_a3_x + c4*neg_a2_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*a3_y - c5*a4_x;
    const panda_real a5_y = s5*a4_x + c5*a3_y;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a6_x = c6*a5_x + s6*neg_a4_y;
    const panda_real a6_y = c6*neg_a4_y - s6*a5_x;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a7_x = c7*a6_x - s7*a5_y;
    const panda_real a7_y = -c7*a5_y - s7*a6_x;
    /* link 2: moment that turns the link [N m] */
    const panda_real nc2_z = 0.01993386669246*c2 - 32.809545426852715*s2;
    /* link 3: moment that turns the link [N m] */
    const panda_real nc3_x = 0.27690780075317833*c2;
    const panda_real nc3_y = -7.32667658634432*c2;
    const panda_real nc3_z = 0.746857959872*a3_y + 0.028227094877999827*neg_a3_x;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 2.0125235536029997*a3_y;
    const panda_real nc4_y = 0.5527802746499999*a3_y;
    const panda_real nc4_z = 2.0125235536029997*a4_x - 0.5527802746499999*neg_a4_y;
    /* link 5: moment that turns the link [N m] */
    const panda_real nc5_x = 0.067870631425*neg_a4_y;
    const panda_real nc5_y = 0.014653732538*neg_a4_y;
    const panda_real nc5_z = -0.067870631425*a5_x - 0.014653732538*a5_y;
    /* link 6: moment that turns the link [N m] */
    const panda_real nc6_x = 0.17380470556899996*a5_y;
    const panda_real nc6_y = 0.231847552695*a5_y;
    const panda_real nc6_z = 0.231847552695*a6_y + 0.17380470556899996*a6_x;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = -0.0020344399586618637*a6_y;
    const panda_real nc7_y = 0.002573605371338201*a6_y;
    const panda_real nc7_z = 0.002573605371338201*a7_y - 0.0020344399586618637*a7_x;
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
 * 300 multiplications, 273 additions = 573; 8 unary minus; 12 sine/cosine */
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
    const panda_real neg_a2_x = 9.81*s2;
    const panda_real neg_a2_y = 9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = qd[1]*w2_y;
    const panda_real neg_alpha2_y = qd[1]*w2_x;
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
    const panda_real a3_z = neg_a2_y - 0.316*neg_lam2_22;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t2 = -0.632*alpha2_x;
    const panda_real t3 = neg_a2_x + 0.316*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t2 - c3*t3;
    const panda_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const panda_real alpha3_y = -qd[2]*w3_x - s3*alpha2_x;
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
    const panda_real lam3_12 = ww3_xy - neg_alpha2_y;
    const panda_real lam3_13 = alpha3_y + ww3_zx;
    const panda_real lam3_21 = neg_alpha2_y + ww3_xy;
    const panda_real neg_lam3_22 = ww3_xx + ww3_zz;
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real lam3_32 = alpha3_x + ww3_yz;
    const panda_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_z = -0.0825*lam3_21 - a3_y;
    const panda_real t4 = -s4;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t4*w3_z - c4*w3_x;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t5 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t6 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t5 - s4*t6;
    const panda_real neg_a4_y = s4*t5 + c4*t6;
    const panda_real t7 = -c4;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = t7*alpha3_x - s4*neg_alpha2_y + qd[3]*w4_y;
    const panda_real neg_alpha4_y = c4*neg_alpha2_y - s4*alpha3_x + qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_yz = w4_y*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yy = w4_y*w4_y;
    const panda_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_11 = ww4_yy + ww4_zz;
    const panda_real lam4_12 = alpha3_y + ww4_xy;
    const panda_real lam4_13 = ww4_zx - neg_alpha4_y;
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    const panda_real neg_lam4_22 = ww4_xx + ww4_zz;
    const panda_real neg_lam4_23 = alpha4_x - ww4_yz;
    const panda_real lam4_31 = neg_alpha4_y + ww4_zx;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (-0.384*neg_lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -s5*w4_z - c5*w4_x;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t8 = 0.384*lam4_32 - 0.0825*lam4_31 - a4_z;
    const panda_real t9 = a4_x - (0.0825*neg_lam4_11 + 0.384*lam4_12);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*t8 - c5*t9;
    const panda_real a5_y = s5*t9 + c5*t8;
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
    const panda_real lam5_12 = ww5_xy - neg_alpha4_y;
    const panda_real lam5_13 = alpha5_y + ww5_zx;
    const panda_real lam5_21 = neg_alpha4_y + ww5_xy;
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
    const panda_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*neg_alpha4_y);
    const panda_real alpha6_y = c6*neg_alpha4_y - s6*alpha5_x - qd[5]*w6_x;
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
    const panda_real t10 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t11 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t10 + s7*t11;
    const panda_real a7_y = s7*t10 - c7*t11;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (s7*alpha5_y - c7*alpha6_x);
    const panda_real alpha7_y = -c7*alpha5_y - s7*alpha6_x - qd[6]*w7_x;
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
    const panda_real nc2_x = 0.007966717767871044*neg_alpha2_y + 0.010261101821008168*ww2_xy -
        (0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) - 2.0643241224637614*alpha2_x);
    const panda_real nc2_y = 0.010261101821008168*(neg_lam2_11 - neg_lam2_33) -
        0.04615576498986361*neg_alpha2_y - (0.0007689361029464017*ww2_xy +
        0.007966717767871044*alpha2_x);
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
    const panda_real fc4_x = -0.5527802746499999*neg_lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 + 2.0125235536029997*neg_lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(neg_lam4_22 -
        neg_lam4_33) - (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) -
        2.0125235536029997*a4_z;
    const panda_real nc4_y = -0.5527802746499999*a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(neg_lam4_11 - neg_lam4_33) + (0.00164448757736928*lam4_12 -
        0.16284087268546082*lam4_32));
    const panda_real t13 = 0.6972920750309717*lam4_12 - 0.05102013615681549*lam4_21 +
        0.16284087268546082*(neg_lam4_11 - neg_lam4_22) + (0.0039053550262761055*neg_lam4_23 -
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
    const panda_real fc7_z = 0.0020344399586618637*lam7_32 - 0.002573605371338201*neg_lam7_31;
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
    const panda_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y - 0.088*f07_y - nc7_z;
    const panda_real n6_z = n07_y + (nc6_z - 0.088*fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y - fc7_z;
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
    const panda_real f05_x = s5*f5_y - c5*f5_x;
    const panda_real neg_f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = -c5*n5_y - s5*n5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x + 0.384*neg_f05_y);
    const panda_real n4_y = nc4_y + 0.0825*neg_f05_y - n5_z;
    const panda_real n4_z = n05_y - (neg_nc4_z + (0.0825*f5_z - 0.384*f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x + f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z - neg_f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = t7*f4_y - s4*f4_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real n04_y = t4*n4_x - c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = n04_y - (0.0825*f4_z - nc3_z);
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
    const panda_real n2_x = n03_x + (nc2_x - 0.316*f03_y);
    const panda_real neg_n2_y = n3_z - nc2_y;
    const panda_real n2_z = n03_y - (0.316*neg_f03_x - nc2_z);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = c2*neg_n2_y - s2*n2_x;
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
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h7_x = 0.002573605371338201*c7 - 0.0020344399586618637*s7;
    const panda_real neg_h7_y = -0.0020344399586618637*c7 - 0.002573605371338201*s7;
    const panda_real t1 = c7*c7;
    const panda_real t2 = c7*s7;
    const panda_real t3 = 0.002420943778521227*t1 - 0.000782782563368495*t2;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real k7_xx = 0.004552547872941087 - t3;
    const panda_real neg_k7_xy = 0.002420943778521227*t2 + 0.0003913912816842475*(2.0*t1 - 1.0);
    const panda_real k7_xz = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    const panda_real neg_k7_yz = -0.0012555365982729084*c7 - 0.0009653051699191118*s7;
    /* link 6: force for a unit acceleration of a joint further out */
    const panda_real fu6_x = c6*neg_h7_y;
    const panda_real fu6_y = s6*neg_h7_y;
    const panda_real t4 = 0.088*h7_x + 0.006684151967360947;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = s6*t4 - c6*k7_xz;
    const panda_real nu6_y = -c6*t4 - s6*k7_xz;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x = -s5*h7_x - c5*fu6_x;
    const panda_real fu5_y = c5*h7_x - s5*fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x = -c5*nu6_x - s5*neg_k7_yz;
    const panda_real nu5_y = c5*neg_k7_yz - s5*nu6_x;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_7 = nu5_y + (0.384*fu5_x - 0.0825*fu6_y);
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x = -c4*fu5_x - s4*fu6_y;
    const panda_real fu4_y = c4*fu6_y - s4*fu5_x;
    const panda_real t5 = 0.384*fu5_y - nu5_x;
    const panda_real t6 = 0.0825*fu5_y;
    const panda_real t7 = nu6_y + t6;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = c4*t5 - s4*t7;
    const panda_real nu4_y = s4*t5 + c4*t7;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = nu4_y - t6;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x = c3*fu4_x + s3*fu5_y;
    const panda_real fu3_y = s3*fu4_x - c3*fu5_y;
    const panda_real t8 = m4_7 + 0.0825*fu4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = c3*nu4_x + s3*t8;
    const panda_real nu3_y = s3*nu4_x - c3*t8;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_7 = nu3_y + 0.316*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = c2*m3_7 - s2*(nu3_x - 0.316*fu3_y);
    const panda_real t9 = k7_xx + 0.176*h7_x;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = t9 + 0.05045667791624746;
    const panda_real t10 = h7_x + 0.231847552695;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h6_x = c6*t10 + 0.17380470556899996*s6;
    const panda_real h6_y = s6*t10 - 0.17380470556899996*c6;
    const panda_real t11 = c6*c6;
    const panda_real t12 = 0.007412167175072353 - t9;
    const panda_real t13 = k7_xz + 0.014748570382675314;
    const panda_real t14 = c6*s6;
    const panda_real t15 = t11*t12 - t13*(2.0*t14);
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_yy = t9 + 0.021522255370587554 + t15;
    const panda_real neg_k6_xy = t12*t14 - t13*(1.0 - 2.0*t11);
    const panda_real t16 = 9.35690973146064e-05 - neg_k7_yz;
    const panda_real t17 = neg_k7_xy + 0.088*neg_h7_y - 0.0001037589172186853;
    const panda_real k6_xz = s6*t16 - c6*t17;
    const panda_real neg_k6_yz = s6*t17 + c6*t16;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x_2 = c5*h6_y;
    const panda_real fu5_y_2 = s5*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x_2 = c5*k6_xz - s5*m6_6;
    const panda_real nu5_y_2 = s5*k6_xz + c5*m6_6;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_6 = nu5_y_2 - (0.0825*h6_x - 0.384*fu5_x_2);
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_2 = -s4*h6_x - c4*fu5_x_2;
    const panda_real neg_fu4_y = s4*fu5_x_2 - c4*h6_x;
    const panda_real t18 = 0.384*fu5_y_2 - nu5_x_2;
    const panda_real t19 = 0.0825*fu5_y_2;
    const panda_real t20 = neg_k6_yz + t19;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_2 = c4*t18 - s4*t20;
    const panda_real nu4_y_2 = s4*t18 + c4*t20;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = nu4_y_2 - t19;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_2 = c3*fu4_x_2 + s3*fu5_y_2;
    const panda_real fu3_y_2 = s3*fu4_x_2 - c3*fu5_y_2;
    const panda_real t21 = 0.0825*neg_fu4_y - m4_6;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_2 = c3*nu4_x_2 - s3*t21;
    const panda_real nu3_y_2 = s3*nu4_x_2 + c3*t21;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_6 = nu3_y_2 + 0.316*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_2 = c2*m3_6 - s2*(nu3_x_2 - 0.316*fu3_y_2);
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t3 - t15 + 0.04256237053342773;
    const panda_real t22 = 0.014653732538 - h6_x;
    const panda_real t23 = neg_h7_y + 0.067870631425;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h5_x = c5*t22 + s5*t23;
    const panda_real h5_y = s5*t22 - c5*t23;
    const panda_real t24 = c5*c5;
    const panda_real t25 = t3 + t15 - 0.018208786687945514;
    const panda_real t26 = 0.00151524447332703 - k6_xz;
    const panda_real t27 = c5*s5;
    const panda_real t28 = t24*t25 + t26*(2.0*t27);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xx = t3 + 0.012176791922741105 - t28;
    const panda_real k5_yy = t28 - (t15 - 0.03038557861068662);
    const panda_real neg_k5_xy = t25*t27 + t26*(1.0 - 2.0*t24);
    const panda_real t29 = neg_k6_xy - 0.004600245517563107;
    const panda_real t30 = neg_k6_yz - 0.0021640520520981327;
    const panda_real k5_xz = c5*t29 + s5*t30;
    const panda_real k5_yz = s5*t29 - c5*t30;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = -0.384*h5_y - k5_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_3 = c4*h5_y;
    const panda_real fu4_y_2 = s4*h5_y;
    const panda_real t31 = -0.384*h5_x;
    const panda_real t32 = k5_xz - t31;
    const panda_real t33 = 0.0825*h5_x;
    const panda_real t34 = m5_5 + t33;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_3 = c4*t32 - s4*t34;
    const panda_real nu4_y_3 = s4*t32 + c4*t34;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_5 = nu4_y_3 - t33;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_3 = c3*fu4_x_3 + s3*h5_x;
    const panda_real fu3_y_3 = s3*fu4_x_3 - c3*h5_x;
    const panda_real t35 = -0.0825*fu4_y_2 - m4_5;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_3 = c3*nu4_x_3 - s3*t35;
    const panda_real nu3_y_3 = s3*nu4_x_3 + c3*t35;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = nu3_y_3 + 0.316*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_3 = c2*m3_5 - s2*(nu3_x_3 - 0.316*fu3_y_3);
    const panda_real t36 = k5_xx + 0.165*h5_x;
    const panda_real t37 = k6_yy + 0.768*h6_y;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t36 + t37 + 0.7483122111877871;
    const panda_real t38 = -h5_x - 0.5527802746499999;
    const panda_real t39 = h6_y + 2.0125235536029997;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h4_x = c4*t38 - s4*t39;
    const panda_real h4_y = s4*t38 + c4*t39;
    const panda_real t40 = c4*c4;
    const panda_real t41 = t36 - t37 - 0.6462719388741561;
    const panda_real t42 = t31 - (k5_xz + 0.0825*h6_y) - 0.16284087268546082;
    const panda_real t43 = c4*s4;
    const panda_real t44 = t40*t41 - t42*(2.0*t43);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xx = t37 + 0.6972920750309717 + t44;
    const panda_real k4_yy = t36 + 0.05102013615681549 - t44;
    const panda_real k4_xy = t41*t43 - t42*(1.0 - 2.0*t40);
    const panda_real t45 = -0.0825*h5_y;
    const panda_real t46 = neg_k5_xy + t45 - 0.0039053550262761055;
    const panda_real t47 = m4_5 - 0.00164448757736928;
    const panda_real k4_xz = c4*t46 + s4*t47;
    const panda_real neg_k4_yz = c4*t47 - s4*t46;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real neg_fu3_x = c3*h4_y;
    const panda_real neg_fu3_y = s3*h4_y;
    const panda_real t48 = m4_4 + 0.0825*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_4 = s3*t48 - c3*k4_xz;
    const panda_real neg_nu3_y = s3*k4_xz + c3*t48;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_4 = -0.316*neg_fu3_x - neg_nu3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_4 = c2*neg_k4_yz - s2*(nu3_x_4 + 0.316*neg_fu3_y);
    const panda_real t49 = -0.165*h4_x - k4_xx;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = 0.08378056999140594 - (t49 - k5_yy);
    const panda_real t50 = h4_x + 0.746857959872;
    const panda_real t51 = 0.028227094877999827 - h5_y;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h3_x = c3*t50 - s3*t51;
    const panda_real h3_y = s3*t50 + c3*t51;
    const panda_real t52 = c3*c3;
    const panda_real t53 = 0.039424272061649446 - (k5_yy + t49);
    const panda_real t54 = t45 - k4_xz + 0.0001219124209507298;
    const panda_real t55 = c3*s3;
    const panda_real t56 = t52*t53 - t54*(2.0*t55);
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_xx = k5_yy + 0.022178148964878252 + t56;
    const panda_real neg_k3_yy = t49 - 0.061602421026527694 + t56;
    const panda_real k3_xy = t53*t55 - t54*(1.0 - 2.0*t52);
    const panda_real t57 = k4_xy + 0.0825*h4_y + 0.005487648106562251;
    const panda_real t58 = -neg_k4_yz - 0.0043772571218395765;
    const panda_real k3_xz = c3*t57 + s3*t58;
    const panda_real k3_yz = s3*t57 - c3*t58;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_3 = -0.316*h3_y - k3_yz;
    const panda_real t59 = k3_xz + 0.316*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_5 = s2*t59 + c2*m3_3;
    const panda_real t60 = k4_yy + 0.632*h4_y;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = k3_xx + t60 + 1.0552399437268125;
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real k2_xx = t60 + 1.0321620612318807 - (c2*c2*(t60 - k3_xx + 1.009084178736949) -
        (t59 - 0.003983358883935522)*(2.0*(c2*s2)));
    const panda_real neg_k2_yz = s2*(k3_xy - 0.010261101821008168) - c2*(0.0007689361029464017 -
        m2_3);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = k2_xx - neg_k3_yy + 0.014259565994474374;
    M[0] = m1_1;
    M[1] = neg_k2_yz;
    M[2] = nu2_y_5;
    M[3] = nu2_y_4;
    M[4] = nu2_y_3;
    M[5] = nu2_y_2;
    M[6] = nu2_y;
    M[7] = neg_k2_yz;
    M[8] = m2_2;
    M[9] = m2_3;
    M[10] = m2_4;
    M[11] = m2_5;
    M[12] = m2_6;
    M[13] = m2_7;
    M[14] = nu2_y_5;
    M[15] = m2_3;
    M[16] = m3_3;
    M[17] = neg_k4_yz;
    M[18] = m3_5;
    M[19] = m3_6;
    M[20] = m3_7;
    M[21] = nu2_y_4;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = nu2_y_3;
    M[29] = m2_5;
    M[30] = m3_5;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = neg_k6_yz;
    M[34] = nu6_y;
    M[35] = nu2_y_2;
    M[36] = m2_6;
    M[37] = m3_6;
    M[38] = m4_6;
    M[39] = neg_k6_yz;
    M[40] = m6_6;
    M[41] = neg_k7_yz;
    M[42] = nu2_y;
    M[43] = m2_7;
    M[44] = m3_7;
    M[45] = m4_7;
    M[46] = nu6_y;
    M[47] = neg_k7_yz;
    M[48] = 0.006684151967360947;
}

/* accelerations that the torques tau give
 * 629 multiplications, 551 additions, 7 divisions = 1187; 22 unary minus; 12 sine/cosine */
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
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h7_x = 0.002573605371338201*c7 - 0.0020344399586618637*s7;
    const panda_real neg_h7_y = -0.0020344399586618637*c7 - 0.002573605371338201*s7;
    const panda_real t1 = c7*c7;
    const panda_real t2 = c7*s7;
    const panda_real t3 = 0.002420943778521227*t1 - 0.000782782563368495*t2;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real k7_xx = 0.004552547872941087 - t3;
    const panda_real neg_k7_xy = 0.002420943778521227*t2 + 0.0003913912816842475*(2.0*t1 - 1.0);
    const panda_real k7_xz = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    const panda_real k7_yz = 0.0009653051699191118*s7 + 0.0012555365982729084*c7;
    /* link 6: force for a unit acceleration of a joint further out */
    const panda_real fu6_x = c6*neg_h7_y;
    const panda_real fu6_y = s6*neg_h7_y;
    const panda_real t4 = 0.088*h7_x + 0.006684151967360947;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = s6*t4 - c6*k7_xz;
    const panda_real neg_nu6_y = s6*k7_xz + c6*t4;
    const panda_real t5 = -s5;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x = t5*h7_x - c5*fu6_x;
    const panda_real fu5_y = c5*h7_x - s5*fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x = s5*k7_yz - c5*nu6_x;
    const panda_real t6 = -c5;
    const panda_real nu5_y = t6*k7_yz - s5*nu6_x;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_7 = nu5_y + (0.384*fu5_x - 0.0825*fu6_y);
    const panda_real t7 = -c4;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x = t7*fu5_x - s4*fu6_y;
    const panda_real fu4_y = c4*fu6_y - s4*fu5_x;
    const panda_real t8 = 0.384*fu5_y - nu5_x;
    const panda_real t9 = 0.0825*fu5_y;
    const panda_real t10 = t9 - neg_nu6_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = c4*t8 - s4*t10;
    const panda_real nu4_y = s4*t8 + c4*t10;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = nu4_y - t9;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x = c3*fu4_x + s3*fu5_y;
    const panda_real fu3_y = s3*fu4_x - c3*fu5_y;
    const panda_real t11 = m4_7 + 0.0825*fu4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = c3*nu4_x + s3*t11;
    const panda_real nu3_y = s3*nu4_x - c3*t11;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_7 = nu3_y + 0.316*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = c2*m3_7 - s2*(nu3_x - 0.316*fu3_y);
    const panda_real t12 = k7_xx + 0.176*h7_x;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = t12 + 0.05045667791624746;
    const panda_real t13 = h7_x + 0.231847552695;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h6_x = c6*t13 + 0.17380470556899996*s6;
    const panda_real h6_y = s6*t13 - 0.17380470556899996*c6;
    const panda_real t14 = c6*c6;
    const panda_real t15 = 0.007412167175072353 - t12;
    const panda_real t16 = k7_xz + 0.014748570382675314;
    const panda_real t17 = c6*s6;
    const panda_real t18 = t14*t15 - t16*(2.0*t17);
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_yy = t12 + 0.021522255370587554 + t18;
    const panda_real neg_k6_xy = t15*t17 - t16*(1.0 - 2.0*t14);
    const panda_real t19 = k7_yz + 9.35690973146064e-05;
    const panda_real t20 = neg_k7_xy + 0.088*neg_h7_y - 0.0001037589172186853;
    const panda_real k6_xz = s6*t19 - c6*t20;
    const panda_real neg_k6_yz = s6*t20 + c6*t19;
    /* link 5: force for a unit acceleration of a joint further out */
    const panda_real fu5_x_2 = c5*h6_y;
    const panda_real fu5_y_2 = s5*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const panda_real nu5_x_2 = c5*k6_xz - s5*m6_6;
    const panda_real nu5_y_2 = s5*k6_xz + c5*m6_6;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_6 = nu5_y_2 - (0.0825*h6_x - 0.384*fu5_x_2);
    const panda_real t21 = -s4;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_2 = t21*h6_x - c4*fu5_x_2;
    const panda_real neg_fu4_y = s4*fu5_x_2 - c4*h6_x;
    const panda_real t22 = 0.384*fu5_y_2 - nu5_x_2;
    const panda_real t23 = 0.0825*fu5_y_2;
    const panda_real t24 = neg_k6_yz + t23;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_2 = c4*t22 - s4*t24;
    const panda_real nu4_y_2 = s4*t22 + c4*t24;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = nu4_y_2 - t23;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_2 = c3*fu4_x_2 + s3*fu5_y_2;
    const panda_real fu3_y_2 = s3*fu4_x_2 - c3*fu5_y_2;
    const panda_real t25 = 0.0825*neg_fu4_y - m4_6;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_2 = c3*nu4_x_2 - s3*t25;
    const panda_real nu3_y_2 = s3*nu4_x_2 + c3*t25;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_6 = nu3_y_2 + 0.316*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_2 = c2*m3_6 - s2*(nu3_x_2 - 0.316*fu3_y_2);
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t3 - t18 + 0.04256237053342773;
    const panda_real t26 = 0.014653732538 - h6_x;
    const panda_real t27 = neg_h7_y + 0.067870631425;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h5_x = c5*t26 + s5*t27;
    const panda_real h5_y = s5*t26 - c5*t27;
    const panda_real t28 = c5*c5;
    const panda_real t29 = t3 + t18 - 0.018208786687945514;
    const panda_real t30 = 0.00151524447332703 - k6_xz;
    const panda_real t31 = c5*s5;
    const panda_real t32 = t28*t29 + t30*(2.0*t31);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xx = t3 + 0.012176791922741105 - t32;
    const panda_real k5_yy = t32 - (t18 - 0.03038557861068662);
    const panda_real neg_k5_xy = t29*t31 + t30*(1.0 - 2.0*t28);
    const panda_real t33 = neg_k6_xy - 0.004600245517563107;
    const panda_real t34 = neg_k6_yz - 0.0021640520520981327;
    const panda_real k5_xz = c5*t33 + s5*t34;
    const panda_real k5_yz = s5*t33 - c5*t34;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = -0.384*h5_y - k5_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const panda_real fu4_x_3 = c4*h5_y;
    const panda_real fu4_y_2 = s4*h5_y;
    const panda_real t35 = -0.384*h5_x;
    const panda_real t36 = k5_xz - t35;
    const panda_real t37 = 0.0825*h5_x;
    const panda_real t38 = m5_5 + t37;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x_3 = c4*t36 - s4*t38;
    const panda_real nu4_y_3 = s4*t36 + c4*t38;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_5 = nu4_y_3 - t37;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real fu3_x_3 = c3*fu4_x_3 + s3*h5_x;
    const panda_real fu3_y_3 = s3*fu4_x_3 - c3*h5_x;
    const panda_real t39 = -0.0825*fu4_y_2 - m4_5;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_3 = c3*nu4_x_3 - s3*t39;
    const panda_real nu3_y_3 = s3*nu4_x_3 + c3*t39;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = nu3_y_3 + 0.316*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_3 = c2*m3_5 - s2*(nu3_x_3 - 0.316*fu3_y_3);
    const panda_real t40 = k5_xx + 0.165*h5_x;
    const panda_real t41 = k6_yy + 0.768*h6_y;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t40 + t41 + 0.7483122111877871;
    const panda_real t42 = -h5_x - 0.5527802746499999;
    const panda_real t43 = h6_y + 2.0125235536029997;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h4_x = c4*t42 - s4*t43;
    const panda_real h4_y = s4*t42 + c4*t43;
    const panda_real t44 = c4*c4;
    const panda_real t45 = t40 - t41 - 0.6462719388741561;
    const panda_real t46 = t35 - (k5_xz + 0.0825*h6_y) - 0.16284087268546082;
    const panda_real t47 = c4*s4;
    const panda_real t48 = t44*t45 - t46*(2.0*t47);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xx = t41 + 0.6972920750309717 + t48;
    const panda_real k4_yy = t40 + 0.05102013615681549 - t48;
    const panda_real k4_xy = t45*t47 - t46*(1.0 - 2.0*t44);
    const panda_real t49 = -0.0825*h5_y;
    const panda_real t50 = neg_k5_xy + t49 - 0.0039053550262761055;
    const panda_real t51 = 0.00164448757736928 - m4_5;
    const panda_real k4_xz = c4*t50 - s4*t51;
    const panda_real k4_yz = s4*t50 + c4*t51;
    /* link 3: force for a unit acceleration of a joint further out */
    const panda_real neg_fu3_x = c3*h4_y;
    const panda_real neg_fu3_y = s3*h4_y;
    const panda_real t52 = m4_4 + 0.0825*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x_4 = s3*t52 - c3*k4_xz;
    const panda_real neg_nu3_y = s3*k4_xz + c3*t52;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_4 = -0.316*neg_fu3_x - neg_nu3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_4 = -c2*k4_yz - s2*(nu3_x_4 + 0.316*neg_fu3_y);
    const panda_real t53 = -0.165*h4_x - k4_xx;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = 0.08378056999140594 - (t53 - k5_yy);
    const panda_real t54 = h4_x + 0.746857959872;
    const panda_real t55 = 0.028227094877999827 - h5_y;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const panda_real h3_x = c3*t54 - s3*t55;
    const panda_real h3_y = s3*t54 + c3*t55;
    const panda_real t56 = c3*c3;
    const panda_real t57 = 0.039424272061649446 - (k5_yy + t53);
    const panda_real t58 = t49 - k4_xz + 0.0001219124209507298;
    const panda_real t59 = c3*s3;
    const panda_real t60 = t56*t57 - t58*(2.0*t59);
    /* link 3: second moment of the composite body [kg m^2] */
    const panda_real k3_xx = k5_yy + 0.022178148964878252 + t60;
    const panda_real neg_k3_yy = t53 - 0.061602421026527694 + t60;
    const panda_real k3_xy = t57*t59 - t58*(1.0 - 2.0*t56);
    const panda_real t61 = k4_xy + 0.0825*h4_y + 0.005487648106562251;
    const panda_real t62 = k4_yz - 0.0043772571218395765;
    const panda_real k3_xz = c3*t61 + s3*t62;
    const panda_real k3_yz = s3*t61 - c3*t62;
    /* link 2: mass matrix, its row of this joint */
    const panda_real neg_m2_3 = k3_yz + 0.316*h3_y;
    const panda_real t63 = k3_xz + 0.316*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y_5 = s2*t63 + c2*m3_3;
    const panda_real t64 = k4_yy + 0.632*h4_y;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = k3_xx + t64 + 1.0552399437268125;
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real k2_xx = t64 + 1.0321620612318807 - (c2*c2*(t64 - k3_xx + 1.009084178736949) -
        (t63 - 0.003983358883935522)*(2.0*(c2*s2)));
    const panda_real k2_yz = c2*(neg_m2_3 + 0.0007689361029464017) - s2*(k3_xy -
        0.010261101821008168);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = k2_xx - neg_k3_yy + 0.014259565994474374;
    const panda_real t65 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_x = t65*s2;
    const panda_real w2_y = t65*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a2_x = 9.81*s2;
    const panda_real neg_a2_y = 9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = qd[1]*w2_y;
    const panda_real neg_alpha2_y = qd[1]*w2_x;
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
    const panda_real a3_z = neg_a2_y - 0.316*neg_lam2_22;
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = c3*w2_x + qd[1]*s3;
    const panda_real w3_y = qd[1]*c3 - s3*w2_x;
    const panda_real t66 = -0.632*alpha2_x;
    const panda_real t67 = neg_a2_x + 0.316*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a3_x = s3*t66 - c3*t67;
    const panda_real a3_y = s3*t67 + c3*t66;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const panda_real alpha3_y = -qd[2]*w3_x - s3*alpha2_x;
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
    const panda_real lam3_12 = ww3_xy - neg_alpha2_y;
    const panda_real lam3_13 = alpha3_y + ww3_zx;
    const panda_real lam3_21 = neg_alpha2_y + ww3_xy;
    const panda_real neg_lam3_22 = ww3_xx + ww3_zz;
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real lam3_32 = alpha3_x + ww3_yz;
    const panda_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_z = -0.0825*lam3_21 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = t21*w3_z - c4*w3_x;
    const panda_real w4_y = s4*w3_x - c4*w3_z;
    const panda_real t68 = 0.0825*neg_lam3_11 - a3_x;
    const panda_real t69 = a3_z + 0.0825*lam3_31;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a4_x = c4*t68 - s4*t69;
    const panda_real neg_a4_y = s4*t68 + c4*t69;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = t7*alpha3_x - s4*neg_alpha2_y + qd[3]*w4_y;
    const panda_real neg_alpha4_y = c4*neg_alpha2_y - s4*alpha3_x + qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_yz = w4_y*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yy = w4_y*w4_y;
    const panda_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_11 = ww4_yy + ww4_zz;
    const panda_real lam4_12 = alpha3_y + ww4_xy;
    const panda_real lam4_13 = ww4_zx - neg_alpha4_y;
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    const panda_real neg_lam4_22 = ww4_xx + ww4_zz;
    const panda_real neg_lam4_23 = alpha4_x - ww4_yz;
    const panda_real lam4_31 = neg_alpha4_y + ww4_zx;
    const panda_real lam4_32 = alpha4_x + ww4_yz;
    const panda_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_z = neg_a4_y + (-0.384*neg_lam4_22 - 0.0825*lam4_21);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = t5*w4_z - c5*w4_x;
    const panda_real w5_y = s5*w4_x - c5*w4_z;
    const panda_real t70 = 0.384*lam4_32 - 0.0825*lam4_31 - a4_z;
    const panda_real t71 = a4_x - (0.0825*neg_lam4_11 + 0.384*lam4_12);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real a5_x = s5*t70 - c5*t71;
    const panda_real a5_y = s5*t71 + c5*t70;
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
    const panda_real lam5_12 = ww5_xy - neg_alpha4_y;
    const panda_real lam5_13 = alpha5_y + ww5_zx;
    const panda_real lam5_21 = neg_alpha4_y + ww5_xy;
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
    const panda_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*neg_alpha4_y);
    const panda_real alpha6_y = c6*neg_alpha4_y - s6*alpha5_x - qd[5]*w6_x;
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
    const panda_real t72 = 0.088*neg_lam6_11 - a6_x;
    const panda_real t73 = a5_y - 0.088*lam6_31;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const panda_real neg_a7_x = c7*t72 + s7*t73;
    const panda_real a7_y = s7*t72 - c7*t73;
    /* link 7: angular acceleration [rad/s^2] */
    const panda_real alpha7_x = qd[6]*w7_y - (s7*alpha5_y - c7*alpha6_x);
    const panda_real alpha7_y = -c7*alpha5_y - s7*alpha6_x - qd[6]*w7_x;
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
    const panda_real nc2_x = 0.007966717767871044*neg_alpha2_y + 0.010261101821008168*ww2_xy -
        (0.0007689361029464017*(neg_lam2_22 - neg_lam2_33) - 2.0643241224637614*alpha2_x);
    const panda_real nc2_y = 0.010261101821008168*(neg_lam2_11 - neg_lam2_33) -
        0.04615576498986361*neg_alpha2_y - (0.0007689361029464017*ww2_xy +
        0.007966717767871044*alpha2_x);
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
    const panda_real t74 = 0.022178148964878252*lam3_12 - 0.061602421026527694*lam3_21 -
        0.0001219124209507298*(neg_lam3_11 - neg_lam3_22) - (0.005487648106562251*lam3_23 -
        0.0043772571218395765*lam3_13);
    const panda_real nc3_z = 0.746857959872*a3_y - 0.028227094877999827*a3_x - t74;
    /* link 4: force that moves the link [N] */
    const panda_real fc4_x = -0.5527802746499999*neg_lam4_11 - 2.0125235536029997*lam4_12;
    const panda_real fc4_y = 0.5527802746499999*lam4_21 + 2.0125235536029997*neg_lam4_22;
    const panda_real fc4_z = 0.5527802746499999*lam4_31 - 2.0125235536029997*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const panda_real nc4_x = 0.6972920750309717*lam4_32 - 0.00164448757736928*(neg_lam4_22 -
        neg_lam4_33) - (0.16284087268546082*lam4_31 + 0.0039053550262761055*lam4_21) -
        2.0125235536029997*a4_z;
    const panda_real nc4_y = -0.5527802746499999*a4_z - (0.05102013615681549*lam4_31 +
        0.0039053550262761055*(neg_lam4_11 - neg_lam4_33) + (0.00164448757736928*lam4_12 -
        0.16284087268546082*lam4_32));
    const panda_real t75 = 0.6972920750309717*lam4_12 - 0.05102013615681549*lam4_21 +
        0.16284087268546082*(neg_lam4_11 - neg_lam4_22) + (0.0039053550262761055*neg_lam4_23 -
        0.00164448757736928*lam4_13);
    const panda_real neg_nc4_z = t75 + (0.5527802746499999*neg_a4_y - 2.0125235536029997*a4_x);
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
    const panda_real t76 = 0.001451156065026714*lam5_21 - 0.010045187828321245*lam5_12 +
        0.00151524447332703*(neg_lam5_11 - neg_lam5_22) + (0.004600245517563107*lam5_23 +
        0.0021640520520981327*lam5_13);
    const panda_real nc5_z = t76 - (0.014653732538*a5_y + 0.067870631425*a5_x);
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
    const panda_real t77 = 0.028934422545659907*lam6_12 - 0.021522255370587554*lam6_21 +
        0.014748570382675314*(neg_lam6_11 - neg_lam6_22) - (0.0001037589172186853*lam6_23 +
        9.35690973146064e-05*lam6_13);
    const panda_real nc6_z = 0.231847552695*a6_y + 0.17380470556899996*a6_x - t77;
    /* link 7: force that moves the link [N] */
    const panda_real fc7_x = 0.0020344399586618637*lam7_12 - 0.002573605371338201*neg_lam7_11;
    const panda_real fc7_y = 0.002573605371338201*lam7_21 - 0.0020344399586618637*neg_lam7_22;
    const panda_real fc7_z = 0.0020344399586618637*lam7_32 - 0.002573605371338201*neg_lam7_31;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_x = 0.0020344399586618637*a7_z - (-0.004552547872941087*lam7_32 -
        0.0012555365982729084*(neg_lam7_22 - neg_lam7_33) - (0.0003913912816842475*neg_lam7_31 -
        0.0009653051699191118*lam7_21));
    const panda_real nc7_y = 0.00213160409441986*neg_lam7_31 - 0.0009653051699191118*(neg_lam7_11 -
        neg_lam7_33) + (0.0012555365982729084*lam7_12 + 0.0003913912816842475*lam7_32) -
        0.002573605371338201*a7_z;
    const panda_real t78 = 0.004552547872941087*lam7_12 - 0.00213160409441986*lam7_21 +
        0.0003913912816842475*(neg_lam7_11 - neg_lam7_22) - (0.0009653051699191118*lam7_23 -
        0.0012555365982729084*lam7_13);
    const panda_real nc7_z = 0.002573605371338201*a7_y + 0.0020344399586618637*neg_a7_x - t78;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f07_x = c7*fc7_x - s7*fc7_y;
    const panda_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n07_x = c7*nc7_x - s7*nc7_y;
    const panda_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_x = nc6_x + n07_x;
    const panda_real n6_y = nc6_y - 0.088*f07_y - nc7_z;
    const panda_real n6_z = n07_y + (nc6_z - 0.088*fc7_z);
    /* link 6: force through the joint [N] */
    const panda_real f6_x = fc6_x + f07_x;
    const panda_real f6_y = fc6_y - fc7_z;
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
    const panda_real f05_x = s5*f5_y - c5*f5_x;
    const panda_real neg_f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n05_x = s5*n5_y - c5*n5_x;
    const panda_real n05_y = t6*n5_y - s5*n5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = n05_x + (nc4_x + 0.384*neg_f05_y);
    const panda_real n4_y = nc4_y + 0.0825*neg_f05_y - n5_z;
    const panda_real n4_z = n05_y - (neg_nc4_z + (0.0825*f5_z - 0.384*f05_x));
    /* link 4: force through the joint [N] */
    const panda_real f4_x = fc4_x + f05_x;
    const panda_real f4_y = fc4_y - f5_z;
    const panda_real f4_z = fc4_z - neg_f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const panda_real f04_x = s4*f4_y - c4*f4_x;
    const panda_real f04_y = t7*f4_y - s4*f4_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n04_x = s4*n4_y - c4*n4_x;
    const panda_real n04_y = t21*n4_x - c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_x = nc3_x + n04_x;
    const panda_real n3_y = nc3_y - 0.0825*f04_y - n4_z;
    const panda_real n3_z = n04_y - (0.0825*f4_z - nc3_z);
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
    const panda_real n2_x = n03_x + (nc2_x - 0.316*f03_y);
    const panda_real neg_n2_y = n3_z - nc2_y;
    const panda_real n2_z = n03_y - (0.316*neg_f03_x - nc2_z);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const panda_real n02_y = c2*neg_n2_y - s2*n2_x;
    /* link 1: forward substitution */
    const panda_real y1 = tau[0] - n02_y;
    /* factorisation M = L D L^T */
    const panda_real ipivot1 = 1.0 / m1_1;
    const panda_real l2_1 = -k2_yz*ipivot1;
    const panda_real l3_1 = nu2_y_5*ipivot1;
    const panda_real l4_1 = nu2_y_4*ipivot1;
    const panda_real l5_1 = nu2_y_3*ipivot1;
    const panda_real l6_1 = nu2_y_2*ipivot1;
    const panda_real l7_1 = nu2_y*ipivot1;
    const panda_real pivot2 = m2_2 + k2_yz*l2_1;
    const panda_real ipivot2 = 1.0 / pivot2;
    const panda_real ld3_2 = k2_yz*l3_1 - neg_m2_3;
    const panda_real l3_2 = ipivot2*ld3_2;
    const panda_real ld4_2 = m2_4 + k2_yz*l4_1;
    const panda_real l4_2 = ipivot2*ld4_2;
    const panda_real ld5_2 = m2_5 + k2_yz*l5_1;
    const panda_real l5_2 = ipivot2*ld5_2;
    const panda_real ld6_2 = m2_6 + k2_yz*l6_1;
    const panda_real l6_2 = ipivot2*ld6_2;
    const panda_real ld7_2 = m2_7 + k2_yz*l7_1;
    const panda_real l7_2 = ipivot2*ld7_2;
    const panda_real pivot3 = m3_3 - nu2_y_5*l3_1 - ld3_2*l3_2;
    const panda_real ipivot3 = 1.0 / pivot3;
    const panda_real ld4_3 = -(k4_yz + nu2_y_5*l4_1) - ld3_2*l4_2;
    const panda_real l4_3 = ipivot3*ld4_3;
    const panda_real ld5_3 = m3_5 - nu2_y_5*l5_1 - ld3_2*l5_2;
    const panda_real l5_3 = ipivot3*ld5_3;
    const panda_real ld6_3 = -ld3_2*l6_2 - (nu2_y_5*l6_1 - m3_6);
    const panda_real l6_3 = ipivot3*ld6_3;
    const panda_real ld7_3 = m3_7 - nu2_y_5*l7_1 - ld3_2*l7_2;
    const panda_real l7_3 = ipivot3*ld7_3;
    const panda_real pivot4 = m4_4 - nu2_y_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const panda_real ipivot4 = 1.0 / pivot4;
    const panda_real ld5_4 = -ld4_3*l5_3 - (nu2_y_4*l5_1 - m4_5 + ld4_2*l5_2);
    const panda_real l5_4 = ipivot4*ld5_4;
    const panda_real ld6_4 = -ld4_2*l6_2 - (nu2_y_4*l6_1 - m4_6) - ld4_3*l6_3;
    const panda_real l6_4 = ipivot4*ld6_4;
    const panda_real ld7_4 = m4_7 - nu2_y_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3;
    const panda_real l7_4 = ipivot4*ld7_4;
    const panda_real pivot5 = m5_5 - nu2_y_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const panda_real ipivot5 = 1.0 / pivot5;
    const panda_real ld6_5 = -ld5_2*l6_2 - (nu2_y_3*l6_1 - neg_k6_yz) - ld5_3*l6_3 - ld5_4*l6_4;
    const panda_real l6_5 = ipivot5*ld6_5;
    const panda_real ld7_5 = -ld5_3*l7_3 - (neg_nu6_y + nu2_y_3*l7_1 + ld5_2*l7_2) - ld5_4*l7_4;
    const panda_real l7_5 = ipivot5*ld7_5;
    const panda_real pivot6 = -ld6_5*l6_5 - (ld6_2*l6_2 - (m6_6 - nu2_y_2*l6_1) + ld6_3*l6_3 +
        ld6_4*l6_4);
    const panda_real ipivot6 = 1.0 / pivot6;
    const panda_real ld7_6 = -(k7_yz + nu2_y_2*l7_1 + ld6_2*l7_2 + ld6_3*l7_3 + ld6_4*l7_4) -
        ld6_5*l7_5;
    const panda_real l7_6 = ipivot6*ld7_6;
    const panda_real t79 = 0.006684151967360947 - nu2_y*l7_1 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4
        - ld7_5*l7_5;
    const panda_real pivot7 = t79 - ld7_6*l7_6;
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
    const panda_real t80 = tau[6] - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5;
    /* link 7: forward substitution */
    const panda_real y7 = t80 - l7_6*y6;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd7 = ipivot7*y7;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd6 = ipivot6*y6 - l7_6*qdd7;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd3 = -l7_3*qdd7 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd2 = -l7_2*qdd7 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 +
        l6_2*qdd6);
    const panda_real t81 = l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd1 = -t81 - l7_1*qdd7;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
