/*
 * iiwa7: KUKA LBR iiwa 7 R800
 * Numbers: MJCF of robosuite 1.5.2 (MIT), turned into modified DH; the damping that it simulates
 *   with is left out
 * Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 17d842b0070c2c20fc4a1a2bf9c43b77 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  joint_1  revolute  alpha 0      a 0  d 0.34  theta q
 *       limits: -2.96706 to 2.96706 rad, 176 N m
 *   2  joint_2  revolute  alpha -pi/2  a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 176 N m
 *   3  joint_3  revolute  alpha pi/2   a 0  d 0.4   theta q
 *       limits: -2.96706 to 2.96706 rad, 110 N m
 *   4  joint_4  revolute  alpha pi/2   a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 110 N m
 *   5  joint_5  revolute  alpha -pi/2  a 0  d 0.4   theta q
 *       limits: -2.96706 to 2.96706 rad, 110 N m
 *   6  joint_6  revolute  alpha -pi/2  a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 40 N m
 *   7  joint_7  revolute  alpha pi/2   a 0  d 0     theta q
 *       limits: -3.05433 to 3.05433 rad, 40 N m
 * Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
 * Tool frame in the last link: [0, 0, 0.125] m, roll, pitch, yaw 0, 0, pi rad
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of mass_matrix, forward_dynamics the best program known for these parameters, equal to the
 *   recursion without being written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 216 multiplications, 194 additions = 410; 9 unary minus; 12 sine/cosine
 *   gravity: 30 multiplications, 18 additions = 48; 2 unary minus; 10 sine/cosine
 *   bias: 209 multiplications, 177 additions = 386; 8 unary minus; 12 sine/cosine
 *   mass_matrix: 103 multiplications, 94 additions = 197; 2 unary minus; 12 sine/cosine
 *   forward_dynamics: 428 multiplications, 368 additions, 6 divisions = 802; 16 unary minus; 12
 *       sine/cosine
 */
#include "iiwa7.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 216 multiplications, 194 additions = 410; 9 unary minus; 12 sine/cosine */
void iiwa7_inverse_dynamics(
    const iiwa7_real q[7],
    const iiwa7_real qd[7],
    const iiwa7_real qdd[7],
    iiwa7_real tau[7])
{
    /* sines and cosines of the joint angles */
    const iiwa7_real c2 = cos(q[1]);
    const iiwa7_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_y = t1*c2;
    /* sines and cosines of the joint angles */
    const iiwa7_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_x = t1*s2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam2_23 = s2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa7_real ww2_yz = w2_y*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa7_real alpha2_x = ww2_yz - lam2_23;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam2_13 = -c2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa7_real ww2_zx = w2_x*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa7_real alpha2_y = lam2_13 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa7_real ww2_xy = w2_y*w2_x;
    const iiwa7_real ww2_xx = w2_x*w2_x;
    const iiwa7_real ww2_zz = qd[1]*qd[1];
    const iiwa7_real ww2_yy = w2_y*w2_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam2_12 = ww2_xy - qdd[1];
    const iiwa7_real lam2_32 = ww2_yz + alpha2_x;
    const iiwa7_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa7_real lam2_21 = ww2_xy + qdd[1];
    const iiwa7_real neg_lam2_11 = ww2_zz + ww2_yy;
    const iiwa7_real neg_lam2_33 = qd[0]*qd[0];
    const iiwa7_real lam2_31 = ww2_zx - alpha2_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real s3 = sin(q[2]);
    const iiwa7_real c3 = cos(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa7_real w3_y = qd[1]*c3 - w2_x*s3;
    const iiwa7_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa7_real w3_z = qd[2] - w2_y;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa7_real alpha3_x = w3_y*qd[2] - (-qdd[1]*s3 - alpha2_x*c3);
    const iiwa7_real alpha3_z = qdd[2] - alpha2_y;
    const iiwa7_real alpha3_y = qdd[1]*c3 - alpha2_x*s3 - w3_x*qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa7_real ww3_xy = w3_y*w3_x;
    const iiwa7_real ww3_zx = w3_x*w3_z;
    const iiwa7_real ww3_xx = w3_x*w3_x;
    const iiwa7_real ww3_zz = w3_z*w3_z;
    const iiwa7_real ww3_yz = w3_y*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam3_21 = alpha3_z + ww3_xy;
    const iiwa7_real lam3_12 = ww3_xy - alpha3_z;
    const iiwa7_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa7_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa7_real neg_lam3_31 = alpha3_y - ww3_zx;
    /* sines and cosines of the joint angles */
    const iiwa7_real s4 = sin(q[3]);
    const iiwa7_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa7_real w4_y = w3_z*c4 - w3_x*s4;
    const iiwa7_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa7_real w4_z = qd[3] - w3_y;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa7_real alpha4_x = w4_y*qd[3] - (-alpha3_z*s4 - alpha3_x*c4);
    const iiwa7_real alpha4_z = qdd[3] - alpha3_y;
    const iiwa7_real alpha4_y = alpha3_z*c4 - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa7_real ww4_xy = w4_y*w4_x;
    const iiwa7_real ww4_yz = w4_y*w4_z;
    const iiwa7_real ww4_xx = w4_x*w4_x;
    const iiwa7_real ww4_zz = w4_z*w4_z;
    const iiwa7_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam4_12 = ww4_xy - alpha4_z;
    const iiwa7_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa7_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa7_real lam4_21 = alpha4_z + ww4_xy;
    const iiwa7_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa7_real neg_lam4_33 = ww3_xx + ww3_zz;
    const iiwa7_real lam4_31 = ww4_zx - alpha4_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real s5 = sin(q[4]);
    const iiwa7_real c5 = cos(q[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa7_real w5_y = -w4_z*c5 - w4_x*s5;
    const iiwa7_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa7_real w5_z = w4_y + qd[4];
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa7_real alpha5_x = w5_y*qd[4] - (alpha4_z*s5 - alpha4_x*c5);
    const iiwa7_real alpha5_z = alpha4_y + qdd[4];
    const iiwa7_real alpha5_y = -alpha4_z*c5 - alpha4_x*s5 - w5_x*qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa7_real ww5_xy = w5_y*w5_x;
    const iiwa7_real ww5_xx = w5_x*w5_x;
    const iiwa7_real t2 = -w5_z;
    const iiwa7_real neg_ww5_zz = t2*w5_z;
    const iiwa7_real ww5_yy = w5_y*w5_y;
    const iiwa7_real ww5_yz = w5_y*w5_z;
    const iiwa7_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam5_21 = alpha5_z + ww5_xy;
    const iiwa7_real lam5_12 = ww5_xy - alpha5_z;
    const iiwa7_real lam5_22 = neg_ww5_zz - ww5_xx;
    const iiwa7_real lam5_11 = neg_ww5_zz - ww5_yy;
    const iiwa7_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa7_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa7_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa7_real lam5_31 = ww5_zx - alpha5_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c6 = cos(q[5]);
    const iiwa7_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa7_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa7_real w6_z = w5_y + qd[5];
    const iiwa7_real w6_y = t2*c6 - w5_x*s6;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa7_real alpha6_y = -alpha5_z*c6 - alpha5_x*s6 - w6_x*qd[5];
    const iiwa7_real alpha6_z = alpha5_y + qdd[5];
    const iiwa7_real alpha6_x = qd[5]*w6_y - (alpha5_z*s6 - alpha5_x*c6);
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa7_real ww6_xy = w6_x*w6_y;
    const iiwa7_real ww6_zx = w6_x*w6_z;
    const iiwa7_real ww6_yz = w6_z*w6_y;
    const iiwa7_real ww6_xx = w6_x*w6_x;
    const iiwa7_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam6_21 = alpha6_z + ww6_xy;
    const iiwa7_real lam6_12 = ww6_xy - alpha6_z;
    const iiwa7_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa7_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa7_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa7_real lam6_31 = ww6_zx - alpha6_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c7 = cos(q[6]);
    const iiwa7_real s7 = sin(q[6]);
    /* link 7: angular velocity [rad/s] */
    const iiwa7_real w7_x = w6_x*c7 + w6_z*s7;
    const iiwa7_real w7_y = w6_z*c7 - w6_x*s7;
    const iiwa7_real w7_z = qd[6] - w6_y;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa7_real alpha7_z = qdd[6] - alpha6_y;
    const iiwa7_real alpha7_x = w7_y*qd[6] - (-alpha6_z*s7 - alpha6_x*c7);
    const iiwa7_real alpha7_y = alpha6_z*c7 - alpha6_x*s7 - w7_x*qd[6];
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa7_real ww7_xy = w7_x*w7_y;
    const iiwa7_real ww7_xx = w7_x*w7_x;
    const iiwa7_real ww7_yy = w7_y*w7_y;
    const iiwa7_real ww7_yz = w7_y*w7_z;
    const iiwa7_real ww7_zx = w7_x*w7_z;
    /* link 7: moment that turns the link [N m] */
    const iiwa7_real nc7_z = 0.0005911788535720988*(ww7_xx - ww7_yy) -
        0.002872*(-0.0034821092676768804*ww7_xy - alpha7_z);
    const iiwa7_real nc7_x = 0.002872*ww7_yz - 1.0000617816768e-05*alpha7_x +
        0.0005911788535720988*(alpha7_y - ww7_zx);
    const iiwa7_real nc7_y = 0.0005911788535720988*(alpha7_x + ww7_yz) -
        0.002882000617816768*ww7_zx;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n07_y = s7*nc7_x + c7*nc7_y;
    const iiwa7_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa7_real t3 = lam2_12 + 24.525*s2;
    const iiwa7_real t4 = c3*t3 + lam2_32*s3;
    const iiwa7_real t5 = neg_lam2_22 - 24.525*c2;
    const iiwa7_real t6 = t4*c4 + t5*s4;
    const iiwa7_real t7 = lam4_12 - t6;
    const iiwa7_real t8 = s3*t3 - lam2_32*c3;
    const iiwa7_real t9 = t8 - lam4_32;
    const iiwa7_real t10 = c5*t7 + s5*t9;
    const iiwa7_real t11 = neg_lam4_22 + (t5*c4 - t4*s4);
    /* link 6: moment that turns the link [N m] */
    const iiwa7_real nc6_z = 0.0021385000000000006*(lam6_21 - 22.893746966169505*lam6_12) -
        0.00040380860809999307*lam6_13 + 0.126974784*(t10*c6 + t11*s6);
    const iiwa7_real t12 = s5*t7 - c5*t9;
    const iiwa7_real nc6_x = 0.126974784*t12 - (-0.00040380860809999307*(lam5_22 + neg_lam6_22) -
        0.0489582778871535*lam6_32);
    const iiwa7_real nc6_y = 0.00040380860809999307*lam6_12 - 0.0021385000000000006*lam6_31;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n6_z = n07_y + nc6_z;
    const iiwa7_real n6_x = n07_x + nc6_x;
    const iiwa7_real n6_y = nc6_y - nc7_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n06_y = s6*n6_x + c6*n6_y;
    const iiwa7_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa7_real t13 = 0.0019790216329999993*(lam5_21 - 11.494554054627578*lam5_12) -
        4.54293e-06*(lam5_11 - lam5_22) + (2.466162e-05*lam5_23 - 0.001232947371581177*lam5_13);
    /* link 5: moment that turns the link [N m] */
    const iiwa7_real nc5_z = t13 + (8.6532e-05*t12 + 0.074771712*t10);
    const iiwa7_real nc5_x = 0.074771712*t11 - (2.466162e-05*lam5_21 - 4.54293e-06*lam5_31 +
        0.001232947371581177*(neg_lam4_22 + lam5_22 - 18.45007472348394*lam5_32));
    const iiwa7_real nc5_y = 2.466162e-05*(neg_lam4_22 + lam5_11) - 0.0019790216329999993*lam5_31 +
        0.001232947371581177*(lam5_12 - 0.0036846098257819226*lam5_32) - 8.6532e-05*t11;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n5_z = nc5_z - n06_y;
    const iiwa7_real n5_x = n06_x + nc5_x;
    const iiwa7_real n5_y = n6_z + nc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n05_y = s5*n5_x + c5*n5_y;
    const iiwa7_real n05_x = c5*n5_x - s5*n5_y;
    /* link 4: moment that turns the link [N m] */
    const iiwa7_real nc4_z = 1.21690048*(t6 - 0.009497438493991343*(lam4_13 +
        0.2922356284490603*(318.82012208965233*lam4_12 - lam4_21)));
    const iiwa7_real nc4_x = 1.21690048*(0.009497438493991343*(neg_lam4_22 - neg_lam4_33 +
        93.1705987410757*lam4_32) - t8);
    const iiwa7_real nc4_y = 0.011557437462108543*(lam4_12 - 0.2922356284490603*lam4_31);
    const iiwa7_real t14 = -0.126974784*lam6_12;
    const iiwa7_real t15 = 0.126974784*neg_lam6_22;
    const iiwa7_real t16 = c6*t14 - s6*t15 + (-8.6532e-05*lam5_11 - 0.074771712*lam5_12);
    const iiwa7_real t17 = 8.6532e-05*lam5_21 + 0.074771712*lam5_22 + 0.126974784*lam6_32;
    const iiwa7_real t18 = c5*t16 + s5*t17;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n4_z = nc4_z - (t18 + n05_y);
    const iiwa7_real t19 = s5*t16 - c5*t17;
    const iiwa7_real n4_x = nc4_x - (t19 - n05_x);
    const iiwa7_real n4_y = n5_z + nc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment that turns the link [N m] */
    const iiwa7_real nc3_z = 0.00131684*(t4 + 10.273228415812028*(lam3_13 +
        0.2993735727362736*(lam3_21 - 12.695980561828286*lam3_12)));
    const iiwa7_real nc3_y = 0.013528198107077912*(0.2993735727362736*neg_lam3_31 - lam3_12);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n3_z = n04_y + nc3_z;
    const iiwa7_real n3_y = nc3_y - n4_z;
    /* link 2: moment that turns the link [N m] */
    const iiwa7_real nc2_y = 0.003669880873643688*(neg_lam2_11 - neg_lam2_33 -
        1.201756801003488*lam2_31 - 2.3512054197641956*(lam2_12 + 0.007142857142857143*lam2_32));
    const iiwa7_real t20 = s4*(s6*t14 + c6*t15 - (-8.6532e-05*lam5_31 - 0.074771712*lam5_32) +
        1.21690048*neg_lam4_22);
    const iiwa7_real t21 = c4*(t18 + 1.21690048*lam4_12) + t20 + 0.00131684*lam3_12 + n3_y;
    const iiwa7_real t22 = 0.004410304298773924*(lam2_21 - 514.5784139189633*lam2_12) -
        (0.003669880873643688*(lam2_23 - 2.3512054197641956*lam2_13) - 0.0102478203*(c2 -
        5775.2525774676205*s2));
    const iiwa7_real t23 = c4*n4_x - (t19 - 1.21690048*lam4_32) - s4*n4_y - 0.00131684*(t5 -
        10.273228415812028*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155*lam3_32) - neg_lam4_33);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n2_z = c3*t21 - (6.163317e-05*(neg_lam2_22 - neg_lam2_11) - t22) + s3*t23;
    const iiwa7_real t24 = s3*t21 - (0.003669880873643688*lam2_21 - (0.0086286438*(neg_lam2_22 -
        neg_lam2_33 - 263.0132201033808*lam2_32) - 6.163317e-05*lam2_31));
    const iiwa7_real n2_x = c3*t23 - t24;
    const iiwa7_real n2_y = nc2_y - n3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment that turns the link [N m] */
    const iiwa7_real nc1_z = 0.047459659690009905*qdd[0];
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n1_z = nc1_z - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques that hold the arm at rest
 * 30 multiplications, 18 additions = 48; 2 unary minus; 10 sine/cosine */
void iiwa7_gravity(const iiwa7_real q[7], iiwa7_real tau[7])
{
    /* sines and cosines of the joint angles */
    const iiwa7_real c6 = cos(q[5]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw6_y = -3.1140565776*c6;
    /* sines and cosines of the joint angles */
    const iiwa7_real c5 = cos(q[4]);
    const iiwa7_real c4 = cos(q[3]);
    const iiwa7_real s2 = sin(q[1]);
    const iiwa7_real c3 = cos(q[2]);
    const iiwa7_real c2 = cos(q[1]);
    const iiwa7_real s4 = sin(q[3]);
    const iiwa7_real s5 = sin(q[4]);
    const iiwa7_real s3 = sin(q[2]);
    const iiwa7_real s6 = sin(q[5]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw6_x = 3.1140565776*s6;
    const iiwa7_real t1 = s2*c3;
    const iiwa7_real t2 = c4*t1 - c2*s4;
    const iiwa7_real t3 = s2*s3;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const iiwa7_real tau6 = hw6_y*(c5*t2 - s5*t3) + hw6_x*(-c4*c2 - t1*s4);
    const iiwa7_real t4 = hw6_x - 0.0021221973;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw5_y = s5*t4 - 1.8337762368*c5;
    const iiwa7_real hw5_x = c5*t4 + 1.8337762368*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const iiwa7_real tau5 = t2*hw5_y + t3*hw5_x;
    const iiwa7_real t5 = 29.844484272 - hw6_y;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw4_y = s4*hw5_x + c4*t5;
    const iiwa7_real hw4_x = c4*hw5_x - s4*t5;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const iiwa7_real tau4 = t1*hw4_y + c2*hw4_x;
    const iiwa7_real t6 = hw5_y + 0.032295501;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const iiwa7_real tau3 = t1*t6 + t3*hw4_x;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw3_x = c3*hw4_x - s3*t6;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa7_real hw2_x = c2*(hw3_x - 0.0102478203) + s2*(hw4_y + 59.183750601);
    const iiwa7_real t7 = -hw2_x;
    tau[0] = 0.0;
    tau[1] = t7;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
    tau[6] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 209 multiplications, 177 additions = 386; 8 unary minus; 12 sine/cosine */
void iiwa7_bias(const iiwa7_real q[7], const iiwa7_real qd[7], iiwa7_real tau[7])
{
    /* sines and cosines of the joint angles */
    const iiwa7_real c2 = cos(q[1]);
    const iiwa7_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_y = t1*c2;
    /* sines and cosines of the joint angles */
    const iiwa7_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_x = t1*s2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa7_real alpha2_x = w2_y*qd[1];
    const iiwa7_real neg_alpha2_y = w2_x*qd[1];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa7_real ww2_xy = w2_y*w2_x;
    const iiwa7_real ww2_xx = w2_x*w2_x;
    const iiwa7_real ww2_zz = qd[1]*qd[1];
    const iiwa7_real ww2_yy = w2_y*w2_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa7_real neg_lam2_11 = ww2_zz + ww2_yy;
    const iiwa7_real neg_lam2_33 = qd[0]*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa7_real s3 = sin(q[2]);
    const iiwa7_real c3 = cos(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa7_real w3_y = qd[1]*c3 - w2_x*s3;
    const iiwa7_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa7_real w3_z = qd[2] - w2_y;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa7_real alpha3_x = alpha2_x*c3 + w3_y*qd[2];
    const iiwa7_real alpha3_y = -w3_x*qd[2] - alpha2_x*s3;
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa7_real ww3_xy = w3_y*w3_x;
    const iiwa7_real ww3_zx = w3_x*w3_z;
    const iiwa7_real ww3_xx = w3_x*w3_x;
    const iiwa7_real ww3_zz = w3_z*w3_z;
    const iiwa7_real ww3_yz = w3_y*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam3_21 = neg_alpha2_y + ww3_xy;
    const iiwa7_real lam3_12 = ww3_xy - neg_alpha2_y;
    const iiwa7_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa7_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa7_real neg_lam3_31 = alpha3_y - ww3_zx;
    /* sines and cosines of the joint angles */
    const iiwa7_real s4 = sin(q[3]);
    const iiwa7_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa7_real w4_y = w3_z*c4 - w3_x*s4;
    const iiwa7_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa7_real w4_z = qd[3] - w3_y;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa7_real alpha4_x = w4_y*qd[3] - (-alpha3_x*c4 - neg_alpha2_y*s4);
    const iiwa7_real alpha4_y = neg_alpha2_y*c4 - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa7_real ww4_xy = w4_y*w4_x;
    const iiwa7_real ww4_yz = w4_y*w4_z;
    const iiwa7_real ww4_xx = w4_x*w4_x;
    const iiwa7_real ww4_zz = w4_z*w4_z;
    const iiwa7_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa7_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa7_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa7_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa7_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa7_real neg_lam4_33 = ww3_xx + ww3_zz;
    const iiwa7_real lam4_31 = ww4_zx - alpha4_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real s5 = sin(q[4]);
    const iiwa7_real c5 = cos(q[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa7_real w5_y = -w4_z*c5 - w4_x*s5;
    const iiwa7_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa7_real w5_z = w4_y + qd[4];
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa7_real alpha5_x = w5_y*qd[4] - (-alpha3_y*s5 - alpha4_x*c5);
    const iiwa7_real alpha5_y = alpha3_y*c5 - alpha4_x*s5 - w5_x*qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa7_real ww5_xy = w5_y*w5_x;
    const iiwa7_real ww5_xx = w5_x*w5_x;
    const iiwa7_real t2 = -w5_z;
    const iiwa7_real neg_ww5_zz = t2*w5_z;
    const iiwa7_real ww5_yy = w5_y*w5_y;
    const iiwa7_real ww5_yz = w5_y*w5_z;
    const iiwa7_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam5_21 = alpha4_y + ww5_xy;
    const iiwa7_real lam5_12 = ww5_xy - alpha4_y;
    const iiwa7_real lam5_22 = neg_ww5_zz - ww5_xx;
    const iiwa7_real lam5_11 = neg_ww5_zz - ww5_yy;
    const iiwa7_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa7_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa7_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa7_real lam5_31 = ww5_zx - alpha5_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c6 = cos(q[5]);
    const iiwa7_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa7_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa7_real w6_z = w5_y + qd[5];
    const iiwa7_real w6_y = t2*c6 - w5_x*s6;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa7_real alpha6_y = -alpha4_y*c6 - alpha5_x*s6 - w6_x*qd[5];
    const iiwa7_real alpha6_x = qd[5]*w6_y - (alpha4_y*s6 - alpha5_x*c6);
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa7_real ww6_xy = w6_x*w6_y;
    const iiwa7_real ww6_zx = w6_x*w6_z;
    const iiwa7_real ww6_yz = w6_z*w6_y;
    const iiwa7_real ww6_xx = w6_x*w6_x;
    const iiwa7_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam6_21 = alpha5_y + ww6_xy;
    const iiwa7_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa7_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa7_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa7_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa7_real lam6_31 = ww6_zx - alpha6_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c7 = cos(q[6]);
    const iiwa7_real s7 = sin(q[6]);
    /* link 7: angular velocity [rad/s] */
    const iiwa7_real w7_x = w6_x*c7 + w6_z*s7;
    const iiwa7_real w7_y = w6_z*c7 - w6_x*s7;
    const iiwa7_real w7_z = qd[6] - w6_y;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa7_real alpha7_x = w7_y*qd[6] - (-alpha5_y*s7 - alpha6_x*c7);
    const iiwa7_real alpha7_y = alpha5_y*c7 - alpha6_x*s7 - w7_x*qd[6];
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa7_real ww7_xy = w7_x*w7_y;
    const iiwa7_real ww7_xx = w7_x*w7_x;
    const iiwa7_real ww7_yy = w7_y*w7_y;
    const iiwa7_real ww7_yz = w7_y*w7_z;
    const iiwa7_real ww7_zx = w7_x*w7_z;
    /* link 7: moment that turns the link [N m] */
    const iiwa7_real nc7_z = 0.0005911788535720988*(ww7_xx - ww7_yy) - 0.002872*(alpha6_y -
        0.0034821092676768804*ww7_xy);
    const iiwa7_real nc7_x = 0.002872*ww7_yz - 1.0000617816768e-05*alpha7_x +
        0.0005911788535720988*(alpha7_y - ww7_zx);
    const iiwa7_real nc7_y = 0.0005911788535720988*(alpha7_x + ww7_yz) -
        0.002882000617816768*ww7_zx;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n07_y = s7*nc7_x + c7*nc7_y;
    const iiwa7_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa7_real t3 = ww2_xy + 24.525*s2;
    const iiwa7_real t4 = -2.0*alpha2_x;
    const iiwa7_real t5 = c3*t3 - s3*t4;
    const iiwa7_real t6 = neg_lam2_22 - 24.525*c2;
    const iiwa7_real t7 = t5*c4 + t6*s4;
    const iiwa7_real t8 = lam4_12 - t7;
    const iiwa7_real t9 = s3*t3 + c3*t4;
    const iiwa7_real t10 = t9 - lam4_32;
    const iiwa7_real t11 = c5*t8 + s5*t10;
    const iiwa7_real t12 = neg_lam4_22 + (t6*c4 - t5*s4);
    /* link 6: moment that turns the link [N m] */
    const iiwa7_real nc6_z = 0.0021385000000000006*(lam6_21 - 22.893746966169505*lam6_12) -
        0.00040380860809999307*lam6_13 + 0.126974784*(t11*c6 + t12*s6);
    const iiwa7_real t13 = s5*t8 - c5*t10;
    const iiwa7_real nc6_x = 0.126974784*t13 - (-0.00040380860809999307*(lam5_22 + neg_lam6_22) -
        0.0489582778871535*lam6_32);
    const iiwa7_real nc6_y = 0.00040380860809999307*lam6_12 - 0.0021385000000000006*lam6_31;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n6_z = n07_y + nc6_z;
    const iiwa7_real n6_x = n07_x + nc6_x;
    const iiwa7_real n6_y = nc6_y - nc7_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n06_y = s6*n6_x + c6*n6_y;
    const iiwa7_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa7_real t14 = 0.0019790216329999993*(lam5_21 - 11.494554054627578*lam5_12) -
        4.54293e-06*(lam5_11 - lam5_22) + (2.466162e-05*lam5_23 - 0.001232947371581177*lam5_13);
    /* link 5: moment that turns the link [N m] */
    const iiwa7_real nc5_z = t14 + (8.6532e-05*t13 + 0.074771712*t11);
    const iiwa7_real nc5_x = 0.074771712*t12 - (2.466162e-05*lam5_21 - 4.54293e-06*lam5_31 +
        0.001232947371581177*(neg_lam4_22 + lam5_22 - 18.45007472348394*lam5_32));
    const iiwa7_real nc5_y = 2.466162e-05*(neg_lam4_22 + lam5_11) - 0.0019790216329999993*lam5_31 +
        0.001232947371581177*(lam5_12 - 0.0036846098257819226*lam5_32) - 8.6532e-05*t12;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n5_z = nc5_z - n06_y;
    const iiwa7_real n5_x = n06_x + nc5_x;
    const iiwa7_real n5_y = n6_z + nc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n05_y = s5*n5_x + c5*n5_y;
    const iiwa7_real n05_x = c5*n5_x - s5*n5_y;
    /* link 4: moment that turns the link [N m] */
    const iiwa7_real nc4_z = 1.21690048*(t7 - 0.009497438493991343*(lam4_13 +
        0.2922356284490603*(318.82012208965233*lam4_12 - lam4_21)));
    const iiwa7_real nc4_x = 1.21690048*(0.009497438493991343*(neg_lam4_22 - neg_lam4_33 +
        93.1705987410757*lam4_32) - t9);
    const iiwa7_real nc4_y = 0.011557437462108543*(lam4_12 - 0.2922356284490603*lam4_31);
    const iiwa7_real t15 = -0.126974784*lam6_12;
    const iiwa7_real t16 = 0.126974784*neg_lam6_22;
    const iiwa7_real t17 = c6*t15 - s6*t16 + (-8.6532e-05*lam5_11 - 0.074771712*lam5_12);
    const iiwa7_real t18 = 8.6532e-05*lam5_21 + 0.074771712*lam5_22 + 0.126974784*lam6_32;
    const iiwa7_real t19 = c5*t17 + s5*t18;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n4_z = nc4_z - (t19 + n05_y);
    const iiwa7_real t20 = s5*t17 - c5*t18;
    const iiwa7_real n4_x = nc4_x - (t20 - n05_x);
    const iiwa7_real n4_y = n5_z + nc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment that turns the link [N m] */
    const iiwa7_real nc3_z = 0.00131684*(t5 + 10.273228415812028*(lam3_13 -
        0.2993735727362736*(12.695980561828286*lam3_12 - lam3_21)));
    const iiwa7_real nc3_y = 0.013528198107077912*(0.2993735727362736*neg_lam3_31 - lam3_12);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n3_z = n04_y + nc3_z;
    const iiwa7_real n3_y = nc3_y - n4_z;
    /* link 2: moment that turns the link [N m] */
    const iiwa7_real neg_nc2_z = 2.265037086664298*(ww2_xy + 2.7210667040673794e-05*(neg_lam2_22 -
        neg_lam2_11) - 0.004524349892695083*(c2 - 5775.2525774676205*s2));
    const iiwa7_real nc2_y = 0.003669880873643688*(neg_lam2_11 - neg_lam2_33 -
        2.403513602006976*neg_alpha2_y - 2.3512054197641956*(ww2_xy +
        0.014285714285714285*alpha2_x));
    const iiwa7_real t21 = s4*(s6*t15 + c6*t16 - (-8.6532e-05*lam5_31 - 0.074771712*lam5_32) +
        1.21690048*neg_lam4_22);
    const iiwa7_real t22 = c4*(t19 + 1.21690048*lam4_12) + t21 + 0.00131684*lam3_12 + n3_y;
    const iiwa7_real t23 = c4*n4_x - (t20 - 1.21690048*lam4_32) - s4*n4_y - 0.00131684*(t6 -
        10.273228415812028*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155*lam3_32) - neg_lam4_33);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n2_z = c3*t22 - neg_nc2_z + s3*t23;
    const iiwa7_real t24 = s3*t22 - (0.003669880873643688*ww2_xy - (0.0086286438*(neg_lam2_22 -
        neg_lam2_33 - 526.0264402067615*alpha2_x) - 0.00012326634*neg_alpha2_y));
    const iiwa7_real n2_x = c3*t23 - t24;
    const iiwa7_real neg_n2_y = n3_z - nc2_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real neg_n02_y = c2*neg_n2_y - s2*n2_x;
    tau[0] = neg_n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 103 multiplications, 94 additions = 197; 2 unary minus; 12 sine/cosine */
void iiwa7_mass_matrix(const iiwa7_real q[7], iiwa7_real M[49])
{
    /* sines and cosines of the joint angles */
    const iiwa7_real c2 = cos(q[1]);
    const iiwa7_real s2 = sin(q[1]);
    const iiwa7_real c3 = cos(q[2]);
    const iiwa7_real s3 = sin(q[2]);
    const iiwa7_real c4 = cos(q[3]);
    const iiwa7_real s4 = sin(q[3]);
    const iiwa7_real c5 = cos(q[4]);
    const iiwa7_real s5 = sin(q[4]);
    const iiwa7_real c6 = cos(q[5]);
    const iiwa7_real s6 = sin(q[5]);
    const iiwa7_real c7 = cos(q[6]);
    const iiwa7_real s7 = sin(q[6]);
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu6_x = 0.002872*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu5_x = c5*nu6_x;
    const iiwa7_real nu5_y = s5*nu6_x;
    const iiwa7_real t1 = 1.0000617816768e-05*c7;
    const iiwa7_real t2 = c7*t1;
    const iiwa7_real t3 = s7*t1;
    /* link 7: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k7_xy = 118.22846636152245*t2 - (t3 + 0.0005911788535720988);
    const iiwa7_real t4 = 0.00040380860809999307*c6;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real k6_yz = t4 - s6*neg_k7_xy;
    /* link 6: mass matrix, its row of this joint */
    const iiwa7_real m6_6 = t2 + (118.22846636152245*t3 + 0.05108677726933673);
    const iiwa7_real t5 = m6_6 - 0.025779449502795836;
    const iiwa7_real t6 = c6*(t5 - 0.0692551056536944);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real k6_xy = s6*t6;
    const iiwa7_real t7 = 0.001232947371581177 - k6_yz;
    const iiwa7_real t8 = k6_xy - 2.466162e-05;
    const iiwa7_real t9 = 0.074771712*c5;
    const iiwa7_real t10 = 44.21127576601671*nu6_x;
    const iiwa7_real t11 = t10 - 8.6532e-05;
    const iiwa7_real t12 = t9 - s5*t11;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real m4_5 = c5*t7 - (s5*t8 + t12);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k6_xz = c6*neg_k7_xy + 0.0031802267771528013*t10;
    const iiwa7_real t13 = c5*s5;
    const iiwa7_real t14 = c6*t6;
    const iiwa7_real t15 = t5 + t14;
    const iiwa7_real t16 = c5*c5;
    const iiwa7_real t17 = neg_k6_xz + (neg_k6_xz - 9.08586e-06);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa7_real k5_xy = t13*t15 - (t16 - 0.5)*t17;
    const iiwa7_real t18 = 0.011557437462108543 - m4_5;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k4_xz = s4*t18 + c4*k5_xy;
    /* link 5: mass matrix, its row of this joint */
    const iiwa7_real m5_5 = t14 - (t5 - 0.09899259842249024);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k5_xz = c5*t8 + s5*t7;
    const iiwa7_real t19 = 0.074771712*s5 + c5*t11;
    const iiwa7_real t20 = neg_k5_xz - t19;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu4_y = c4*m5_5 + s4*t20;
    const iiwa7_real t21 = 314.4429847532073*t4;
    const iiwa7_real t22 = t21 + 1.21690048;
    const iiwa7_real t23 = t21 + t22;
    const iiwa7_real t24 = t14 + 0.10895114560701302 - t15*t16 - t13*t17;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real m4_4 = t23 - t24;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k4_yz = s4*k5_xy - c4*t18;
    const iiwa7_real t25 = t23 + (t24 - 0.12566468279153584);
    const iiwa7_real t26 = 2.0*nu4_y - c4*t25;
    const iiwa7_real t27 = c4*t26 - (m5_5 - 0.05884601083569623);
    /* link 3: mass matrix, its row of this joint */
    const iiwa7_real m3_3 = t25 + t27;
    const iiwa7_real t28 = s4*(t22 - t26) + (t20 - c4*t19);
    const iiwa7_real t29 = t12 - (neg_k4_yz - 0.012211358107077913);
    const iiwa7_real t30 = s2*(c3*t28 - s3*t29);
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa7_real neg_nu2_y = c2*m3_3 - t30;
    const iiwa7_real t31 = c4*t22 + s4*t19;
    const iiwa7_real t32 = m4_4 + t31;
    const iiwa7_real t33 = t31 + 2.3209570356530818 + t32;
    const iiwa7_real t34 = s3*neg_k4_xz;
    const iiwa7_real t35 = t27 + (m4_4 - 0.10959205167139245);
    const iiwa7_real t36 = c3*t35 - t34;
    const iiwa7_real t37 = c3*(t34 - t36);
    const iiwa7_real t38 = t33 + t37;
    /* link 1: mass matrix, its row of this joint */
    const iiwa7_real m1_1 = t38 - c2*(t30 + 0.00012326634*s2 - (neg_nu2_y - c2*(t38 -
        0.05186996398878383)));
    /* link 2: mass matrix, its row of this joint */
    const iiwa7_real m2_3 = s3*t28 + c3*t29;
    const iiwa7_real t39 = c3*neg_k4_xz;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa7_real k2_yz = c2*(m2_3 - 0.0086286438) + s2*(c3*t39 - 0.003669880873643688 + s3*t36);
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu4_x = c4*t20 - s4*m5_5;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa7_real neg_nu6_y = 0.022618664190836506*t21;
    const iiwa7_real t40 = m6_6 + t21;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real m4_6 = -c5*t40 - s5*neg_k6_xz;
    const iiwa7_real t41 = c4*nu5_x - s4*neg_nu6_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa7_real neg_nu3_x = s3*nu5_y - c3*t41;
    /* link 2: mass matrix, its row of this joint */
    const iiwa7_real m2_2 = t33 - t35 - (t37 + 0.04304935539123598);
    const iiwa7_real m2_4 = t34 - c3*t32;
    const iiwa7_real t42 = c4*t12 - m4_5;
    const iiwa7_real t43 = t19 - nu4_x;
    const iiwa7_real m2_5 = c3*t42 - s3*t43;
    const iiwa7_real t44 = c4*neg_nu6_y;
    const iiwa7_real t45 = 591.2834490939129*(t9*t44) + (s4*t10 - m4_6);
    const iiwa7_real t46 = c5*neg_k6_xz - s5*t40;
    const iiwa7_real t47 = s4*k6_yz + (s5*t21 - c4*t46);
    const iiwa7_real m2_6 = c3*t45 - s3*t47;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu3_y = c3*nu5_y + s3*t41;
    const iiwa7_real t48 = c2*neg_k4_yz - s2*(t39 + s3*t32);
    const iiwa7_real t49 = c2*nu4_y + s2*(s3*t42 + c3*t43);
    const iiwa7_real t50 = c4*k6_yz + s4*t46;
    const iiwa7_real t51 = s2*(s3*t45 + c3*t47) + c2*t50;
    const iiwa7_real t52 = t44 + s4*nu5_x;
    const iiwa7_real t53 = c2*t52 + s2*neg_nu3_x;
    const iiwa7_real t54 = -nu5_y;
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y;
    M[3] = t48;
    M[4] = t49;
    M[5] = t51;
    M[6] = t53;
    M[7] = k2_yz;
    M[8] = m2_2;
    M[9] = m2_3;
    M[10] = m2_4;
    M[11] = m2_5;
    M[12] = m2_6;
    M[13] = nu3_y;
    M[14] = neg_nu2_y;
    M[15] = m2_3;
    M[16] = m3_3;
    M[17] = neg_k4_yz;
    M[18] = nu4_y;
    M[19] = t50;
    M[20] = t52;
    M[21] = t48;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = t54;
    M[28] = t49;
    M[29] = m2_5;
    M[30] = nu4_y;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = k6_yz;
    M[34] = neg_nu6_y;
    M[35] = t51;
    M[36] = m2_6;
    M[37] = t50;
    M[38] = m4_6;
    M[39] = k6_yz;
    M[40] = m6_6;
    M[41] = 0.0;
    M[42] = t53;
    M[43] = nu3_y;
    M[44] = t52;
    M[45] = t54;
    M[46] = neg_nu6_y;
    M[47] = 0.0;
    M[48] = 0.002872;
}

/* accelerations that the torques tau give
 * 428 multiplications, 368 additions, 6 divisions = 802; 16 unary minus; 12 sine/cosine */
void iiwa7_forward_dynamics(
    const iiwa7_real q[7],
    const iiwa7_real qd[7],
    const iiwa7_real tau[7],
    iiwa7_real qdd[7])
{
    /* sines and cosines of the joint angles */
    const iiwa7_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_y = -c2*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa7_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa7_real w2_x = -qd[0]*s2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa7_real alpha2_x = w2_y*qd[1];
    const iiwa7_real alpha2_y = -w2_x*qd[1];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa7_real ww2_xy = w2_y*w2_x;
    const iiwa7_real ww2_xx = w2_x*w2_x;
    const iiwa7_real ww2_zz = qd[1]*qd[1];
    const iiwa7_real ww2_yy = w2_y*w2_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa7_real neg_lam2_11 = ww2_zz + ww2_yy;
    const iiwa7_real neg_lam2_33 = qd[0]*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa7_real s3 = sin(q[2]);
    const iiwa7_real c3 = cos(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa7_real w3_y = qd[1]*c3 - w2_x*s3;
    const iiwa7_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa7_real w3_z = qd[2] - w2_y;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa7_real alpha3_x = alpha2_x*c3 + w3_y*qd[2];
    const iiwa7_real alpha3_y = -alpha2_x*s3 - w3_x*qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa7_real ww3_xy = w3_y*w3_x;
    const iiwa7_real ww3_zx = w3_x*w3_z;
    const iiwa7_real ww3_xx = w3_x*w3_x;
    const iiwa7_real ww3_zz = w3_z*w3_z;
    const iiwa7_real ww3_yz = w3_y*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam3_21 = ww3_xy - alpha2_y;
    const iiwa7_real lam3_12 = alpha2_y + ww3_xy;
    const iiwa7_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa7_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa7_real neg_lam3_31 = alpha3_y - ww3_zx;
    /* sines and cosines of the joint angles */
    const iiwa7_real s4 = sin(q[3]);
    const iiwa7_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa7_real w4_y = w3_z*c4 - w3_x*s4;
    const iiwa7_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa7_real w4_z = qd[3] - w3_y;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa7_real alpha4_x = w4_y*qd[3] - (alpha2_y*s4 - alpha3_x*c4);
    const iiwa7_real alpha4_y = -(alpha2_y*c4 + alpha3_x*s4) - w4_x*qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa7_real ww4_xy = w4_y*w4_x;
    const iiwa7_real ww4_yz = w4_y*w4_z;
    const iiwa7_real ww4_xx = w4_x*w4_x;
    const iiwa7_real ww4_zz = w4_z*w4_z;
    const iiwa7_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa7_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa7_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa7_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa7_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa7_real neg_lam4_33 = ww3_xx + ww3_zz;
    const iiwa7_real lam4_31 = ww4_zx - alpha4_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real s5 = sin(q[4]);
    const iiwa7_real c5 = cos(q[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa7_real w5_y = -w4_x*s5 - w4_z*c5;
    const iiwa7_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa7_real w5_z = w4_y + qd[4];
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa7_real alpha5_x = w5_y*qd[4] + (alpha3_y*s5 + alpha4_x*c5);
    const iiwa7_real alpha5_y = alpha3_y*c5 - alpha4_x*s5 - w5_x*qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa7_real ww5_xy = w5_y*w5_x;
    const iiwa7_real ww5_xx = w5_x*w5_x;
    const iiwa7_real t1 = -w5_z;
    const iiwa7_real neg_ww5_zz = t1*w5_z;
    const iiwa7_real ww5_yy = w5_y*w5_y;
    const iiwa7_real ww5_yz = w5_y*w5_z;
    const iiwa7_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam5_21 = alpha4_y + ww5_xy;
    const iiwa7_real lam5_12 = ww5_xy - alpha4_y;
    const iiwa7_real lam5_22 = neg_ww5_zz - ww5_xx;
    const iiwa7_real lam5_11 = neg_ww5_zz - ww5_yy;
    const iiwa7_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa7_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa7_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa7_real lam5_31 = ww5_zx - alpha5_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c6 = cos(q[5]);
    const iiwa7_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa7_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa7_real w6_z = w5_y + qd[5];
    const iiwa7_real w6_y = t1*c6 - w5_x*s6;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa7_real alpha6_y = -alpha5_x*s6 - alpha4_y*c6 - w6_x*qd[5];
    const iiwa7_real alpha6_x = qd[5]*w6_y + (alpha5_x*c6 - alpha4_y*s6);
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa7_real ww6_xy = w6_x*w6_y;
    const iiwa7_real ww6_zx = w6_x*w6_z;
    const iiwa7_real ww6_yz = w6_z*w6_y;
    const iiwa7_real ww6_xx = w6_x*w6_x;
    const iiwa7_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa7_real lam6_21 = alpha5_y + ww6_xy;
    const iiwa7_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa7_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa7_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa7_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa7_real lam6_31 = ww6_zx - alpha6_y;
    /* sines and cosines of the joint angles */
    const iiwa7_real c7 = cos(q[6]);
    const iiwa7_real s7 = sin(q[6]);
    /* link 7: angular velocity [rad/s] */
    const iiwa7_real w7_x = w6_x*c7 + w6_z*s7;
    const iiwa7_real w7_y = w6_z*c7 - w6_x*s7;
    const iiwa7_real w7_z = qd[6] - w6_y;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa7_real alpha7_x = w7_y*qd[6] + (alpha5_y*s7 + alpha6_x*c7);
    const iiwa7_real alpha7_y = alpha5_y*c7 - alpha6_x*s7 - w7_x*qd[6];
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa7_real ww7_xy = w7_x*w7_y;
    const iiwa7_real ww7_xx = w7_x*w7_x;
    const iiwa7_real ww7_yy = w7_y*w7_y;
    const iiwa7_real ww7_yz = w7_y*w7_z;
    const iiwa7_real ww7_zx = w7_x*w7_z;
    /* link 7: moment that turns the link [N m] */
    const iiwa7_real nc7_z = 0.0005911788535720988*(ww7_xx - ww7_yy) - 0.002872*(alpha6_y -
        0.0034821092676768804*ww7_xy);
    const iiwa7_real nc7_x = 0.002872*ww7_yz - 1.0000617816768e-05*alpha7_x +
        0.0005911788535720988*(alpha7_y - ww7_zx);
    const iiwa7_real nc7_y = 0.0005911788535720988*(alpha7_x + ww7_yz) -
        0.002882000617816768*ww7_zx;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n07_y = s7*nc7_x + c7*nc7_y;
    const iiwa7_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa7_real t2 = ww2_xy + 24.525*s2;
    const iiwa7_real t3 = -2.0*alpha2_x;
    const iiwa7_real t4 = c3*t2 - s3*t3;
    const iiwa7_real t5 = neg_lam2_22 - 24.525*c2;
    const iiwa7_real t6 = c4*t4 + s4*t5;
    const iiwa7_real t7 = lam4_12 - t6;
    const iiwa7_real t8 = s3*t2 + c3*t3;
    const iiwa7_real t9 = lam4_32 - t8;
    const iiwa7_real t10 = c5*t7 - s5*t9;
    const iiwa7_real t11 = neg_lam4_22 + (c4*t5 - s4*t4);
    /* link 6: moment that turns the link [N m] */
    const iiwa7_real nc6_z = 0.0021385000000000006*(lam6_21 - 22.893746966169505*lam6_12) -
        0.00040380860809999307*lam6_13 + 0.126974784*(c6*t10 + s6*t11);
    const iiwa7_real t12 = s5*t7 + c5*t9;
    const iiwa7_real nc6_x = 0.126974784*t12 - (-0.00040380860809999307*(lam5_22 + neg_lam6_22) -
        0.0489582778871535*lam6_32);
    const iiwa7_real nc6_y = 0.00040380860809999307*lam6_12 - 0.0021385000000000006*lam6_31;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n6_z = n07_y + nc6_z;
    const iiwa7_real n6_x = n07_x + nc6_x;
    const iiwa7_real n6_y = nc6_y - nc7_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n06_y = s6*n6_x + c6*n6_y;
    const iiwa7_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa7_real t13 = 0.0019790216329999993*(11.494554054627578*lam5_12 - lam5_21) +
        4.54293e-06*(lam5_11 - lam5_22) + (0.001232947371581177*lam5_13 - 2.466162e-05*lam5_23);
    /* link 5: moment that turns the link [N m] */
    const iiwa7_real nc5_z = 8.6532e-05*t12 + 0.074771712*t10 - t13;
    const iiwa7_real nc5_x = 0.074771712*t11 + (4.54293e-06*lam5_31 - 2.466162e-05*lam5_21 -
        0.001232947371581177*(neg_lam4_22 + lam5_22 - 18.45007472348394*lam5_32));
    const iiwa7_real nc5_y = 2.466162e-05*(neg_lam4_22 + lam5_11) - 0.0019790216329999993*lam5_31 +
        0.001232947371581177*(lam5_12 - 0.0036846098257819226*lam5_32) - 8.6532e-05*t11;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n5_z = nc5_z - n06_y;
    const iiwa7_real n5_x = n06_x + nc5_x;
    const iiwa7_real n5_y = n6_z + nc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n05_y = s5*n5_x + c5*n5_y;
    const iiwa7_real n05_x = c5*n5_x - s5*n5_y;
    /* link 4: moment that turns the link [N m] */
    const iiwa7_real nc4_z = 1.21690048*(t6 - 0.009497438493991343*(lam4_13 +
        0.2922356284490603*(318.82012208965233*lam4_12 - lam4_21)));
    const iiwa7_real neg_nc4_x = 1.21690048*(t8 - 0.009497438493991343*(neg_lam4_22 - neg_lam4_33 +
        93.1705987410757*lam4_32));
    const iiwa7_real nc4_y = 0.011557437462108543*(lam4_12 - 0.2922356284490603*lam4_31);
    const iiwa7_real t14 = -0.126974784*lam6_12;
    const iiwa7_real t15 = 0.126974784*neg_lam6_22;
    const iiwa7_real t16 = c6*t14 - s6*t15 + (-8.6532e-05*lam5_11 - 0.074771712*lam5_12);
    const iiwa7_real t17 = -8.6532e-05*lam5_21 - 0.074771712*lam5_22 - 0.126974784*lam6_32;
    const iiwa7_real t18 = c5*t16 - s5*t17;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n4_z = nc4_z - (n05_y + t18);
    const iiwa7_real t19 = s5*t16 + c5*t17;
    const iiwa7_real n4_x = n05_x - t19 - neg_nc4_x;
    const iiwa7_real n4_y = n5_z + nc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment that turns the link [N m] */
    const iiwa7_real nc3_z = 0.00131684*(t4 + 10.273228415812028*(lam3_13 -
        0.2993735727362736*(12.695980561828286*lam3_12 - lam3_21)));
    const iiwa7_real nc3_y = 0.013528198107077912*(0.2993735727362736*neg_lam3_31 - lam3_12);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real n3_z = n04_y + nc3_z;
    const iiwa7_real n3_y = nc3_y - n4_z;
    /* link 2: moment that turns the link [N m] */
    const iiwa7_real neg_nc2_z = 2.265037086664298*(ww2_xy + 2.7210667040673794e-05*(neg_lam2_22 -
        neg_lam2_11) - 0.004524349892695083*(c2 - 5775.2525774676205*s2));
    const iiwa7_real nc2_y = 0.003669880873643688*(neg_lam2_11 - neg_lam2_33 +
        2.403513602006976*alpha2_y - 2.3512054197641956*(ww2_xy + 0.014285714285714285*alpha2_x));
    const iiwa7_real t20 = s4*(s6*t14 + c6*t15 - (-8.6532e-05*lam5_31 - 0.074771712*lam5_32) +
        1.21690048*neg_lam4_22);
    const iiwa7_real t21 = -0.00131684*lam3_12 - (c4*(t18 + 1.21690048*lam4_12) + t20) - n3_y;
    const iiwa7_real t22 = t19 - 1.21690048*lam4_32 - c4*n4_x + s4*n4_y + 0.00131684*(t5 -
        10.273228415812028*(neg_lam2_22 - neg_lam4_33 + 3.8008410601848155*lam3_32) - neg_lam4_33);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa7_real neg_n2_z = neg_nc2_z + c3*t21 + s3*t22;
    const iiwa7_real t23 = s3*t21 + (0.003669880873643688*ww2_xy - (0.0086286438*(neg_lam2_22 -
        neg_lam2_33 - 526.0264402067615*alpha2_x) + 0.00012326634*alpha2_y));
    const iiwa7_real n2_x = t23 - c3*t22;
    const iiwa7_real n2_y = nc2_y - n3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa7_real n02_y = c2*n2_y + s2*n2_x;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu6_x = 0.002872*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu5_x = c5*nu6_x;
    const iiwa7_real nu5_y = s5*nu6_x;
    const iiwa7_real t24 = 1.0000617816768e-05*c7;
    const iiwa7_real t25 = s7*t24;
    const iiwa7_real t26 = c7*t24;
    /* link 7: second moment of the composite body [kg m^2] */
    const iiwa7_real k7_xy = t25 + 0.0005911788535720988 - 118.22846636152245*t26;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real k6_yz = 0.00040380860809999307*c6 + s6*k7_xy;
    /* link 6: mass matrix, its row of this joint */
    const iiwa7_real m6_6 = t26 + (118.22846636152245*t25 + 0.05108677726933673);
    const iiwa7_real t27 = c6*(m6_6 - 0.09503455515649023);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real k6_xy = s6*t27;
    const iiwa7_real t28 = k6_yz - 0.001232947371581177;
    const iiwa7_real t29 = k6_xy - 2.466162e-05;
    const iiwa7_real t30 = 0.074771712*c5;
    const iiwa7_real t31 = 0.126974784*s6;
    const iiwa7_real t32 = t31 - 8.6532e-05;
    const iiwa7_real t33 = t30 - s5*t32;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real neg_m4_5 = c5*t28 + (s5*t29 + t33);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa7_real k6_xz = c6*k7_xy - 0.00040380860809999307*s6;
    const iiwa7_real t34 = s5*c5;
    const iiwa7_real t35 = c6*t27;
    const iiwa7_real t36 = m6_6 - 0.025779449502795836 + t35;
    const iiwa7_real t37 = c5*c5;
    const iiwa7_real t38 = -k6_xz - (k6_xz + 9.08586e-06);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa7_real k5_xy = t34*t36 - (t37 - 0.5)*t38;
    const iiwa7_real t39 = neg_m4_5 + 0.011557437462108543;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k4_xz = s4*t39 + c4*k5_xy;
    /* link 5: mass matrix, its row of this joint */
    const iiwa7_real m5_5 = t35 - (m6_6 - 0.12477204792528607);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa7_real neg_k5_xz = c5*t29 - s5*t28;
    const iiwa7_real t40 = 0.074771712*s5 + c5*t32;
    const iiwa7_real t41 = neg_k5_xz - t40;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu4_y = c4*m5_5 + s4*t41;
    const iiwa7_real t42 = 0.126974784*c6;
    const iiwa7_real t43 = t42 + 1.21690048;
    const iiwa7_real t44 = t42 + t43;
    const iiwa7_real t45 = t35 + 0.10895114560701302 - t36*t37 - t34*t38;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real m4_4 = t44 - t45;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa7_real k4_yz = c4*t39 - s4*k5_xy;
    const iiwa7_real t46 = t44 + (t45 - 0.12566468279153584);
    const iiwa7_real t47 = 2.0*nu4_y - c4*t46;
    const iiwa7_real t48 = c4*t47 - (m5_5 - 0.05884601083569623);
    /* link 3: mass matrix, its row of this joint */
    const iiwa7_real m3_3 = t46 + t48;
    const iiwa7_real t49 = s4*(t43 - t47) + (t41 - c4*t40);
    const iiwa7_real t50 = t33 + (k4_yz + 0.012211358107077913);
    const iiwa7_real t51 = s2*(c3*t49 - s3*t50);
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu2_y = t51 - c2*m3_3;
    const iiwa7_real t52 = c4*t43 + s4*t40;
    const iiwa7_real t53 = m4_4 + t52;
    const iiwa7_real t54 = t52 + 2.3209570356530818 + t53;
    const iiwa7_real t55 = s3*neg_k4_xz;
    const iiwa7_real t56 = t48 + (m4_4 - 0.10959205167139245);
    const iiwa7_real t57 = c3*t56 - t55;
    const iiwa7_real t58 = c3*(t55 - t57);
    const iiwa7_real t59 = t54 + t58;
    /* link 1: mass matrix, its row of this joint */
    const iiwa7_real m1_1 = t59 - c2*(t51 + 0.00012326634*s2 + (nu2_y + c2*(t59 -
        0.05186996398878383)));
    /* link 2: mass matrix, its row of this joint */
    const iiwa7_real m2_3 = s3*t49 + c3*t50;
    const iiwa7_real t60 = -c3*neg_k4_xz;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa7_real k2_yz = c2*(m2_3 - 0.0086286438) + s2*(s3*t57 - (c3*t60 +
        0.003669880873643688));
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu4_x = c4*t41 - s4*m5_5;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu6_y = -0.002872*c6;
    const iiwa7_real t61 = m6_6 + t42;
    /* link 4: mass matrix, its row of this joint */
    const iiwa7_real m4_6 = s5*k6_xz - c5*t61;
    const iiwa7_real t62 = c4*nu5_x + s4*nu6_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu3_x = c3*t62 - s3*nu5_y;
    /* link 2: mass matrix, its row of this joint */
    const iiwa7_real m2_2 = t54 - t56 - (t58 + 0.04304935539123598);
    const iiwa7_real m2_4 = t55 - c3*t53;
    const iiwa7_real t63 = neg_m4_5 + c4*t33;
    const iiwa7_real t64 = t40 - nu4_x;
    const iiwa7_real m2_5 = c3*t63 - s3*t64;
    const iiwa7_real t65 = c4*nu6_y;
    const iiwa7_real t66 = s4*t31 - m4_6 - 591.2834490939129*(t30*t65);
    const iiwa7_real t67 = -s5*t61 - c5*k6_xz;
    const iiwa7_real t68 = s4*k6_yz + (s5*t42 - c4*t67);
    const iiwa7_real m2_6 = c3*t66 - s3*t68;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa7_real nu3_y = c3*nu5_y + s3*t62;
    /* factorisation M = U D U^T */
    const iiwa7_real ud3_6 = c4*k6_yz + s4*t67;
    const iiwa7_real ud1_6 = s2*(s3*t66 + c3*t68) + c2*ud3_6;
    const iiwa7_real ud3_7 = s4*nu5_x - t65;
    const iiwa7_real ud1_7 = c2*ud3_7 - s2*nu3_x;
    /* link 6: forward substitution */
    const iiwa7_real y6 = tau[5] - n6_z;
    /* link 7: forward substitution */
    const iiwa7_real y7 = tau[6] - nc7_z;
    /* factorisation M = U D U^T */
    const iiwa7_real u4_7 = -348.18941504178275*nu5_y;
    const iiwa7_real u3_7 = 348.18941504178275*ud3_7;
    const iiwa7_real u2_7 = 348.18941504178275*nu3_y;
    const iiwa7_real u1_7 = 348.18941504178275*ud1_7;
    const iiwa7_real ipivot6 = 1.0 / m6_6;
    const iiwa7_real u5_6 = k6_yz*ipivot6;
    const iiwa7_real u4_6 = m4_6*ipivot6;
    const iiwa7_real u3_6 = ud3_6*ipivot6;
    const iiwa7_real u2_6 = m2_6*ipivot6;
    const iiwa7_real u1_6 = ud1_6*ipivot6;
    const iiwa7_real pivot5 = m5_5 + c6*nu6_y - k6_yz*u5_6;
    const iiwa7_real ipivot5 = 1.0 / pivot5;
    const iiwa7_real ud4_5 = nu6_y*u4_7 - neg_m4_5 - k6_yz*u4_6;
    const iiwa7_real u4_5 = ipivot5*ud4_5;
    const iiwa7_real ud3_5 = nu4_y + nu6_y*u3_7 - k6_yz*u3_6;
    const iiwa7_real u3_5 = ipivot5*ud3_5;
    const iiwa7_real ud2_5 = m2_5 + nu6_y*u2_7 - k6_yz*u2_6;
    const iiwa7_real u2_5 = ipivot5*ud2_5;
    const iiwa7_real ud1_5 = c2*nu4_y + s2*(s3*t63 + c3*t64) + nu6_y*u1_7 - k6_yz*u1_6;
    const iiwa7_real u1_5 = ipivot5*ud1_5;
    const iiwa7_real pivot4 = m4_4 + nu5_y*u4_7 - m4_6*u4_6 - ud4_5*u4_5;
    const iiwa7_real ipivot4 = 1.0 / pivot4;
    const iiwa7_real ud3_4 = nu5_y*u3_7 - k4_yz - m4_6*u3_6 - ud4_5*u3_5;
    const iiwa7_real u3_4 = ipivot4*ud3_4;
    const iiwa7_real ud2_4 = m2_4 + nu5_y*u2_7 - m4_6*u2_6 - ud4_5*u2_5;
    const iiwa7_real u2_4 = ipivot4*ud2_4;
    const iiwa7_real ud1_4 = s2*(t60 - s3*t53) - c2*k4_yz + nu5_y*u1_7 - m4_6*u1_6 - ud4_5*u1_5;
    const iiwa7_real u1_4 = ipivot4*ud1_4;
    const iiwa7_real pivot3 = m3_3 - ud3_7*u3_7 - ud3_6*u3_6 - ud3_5*u3_5 - ud3_4*u3_4;
    const iiwa7_real ipivot3 = 1.0 / pivot3;
    const iiwa7_real ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 - ud3_4*u2_4;
    const iiwa7_real u2_3 = ipivot3*ud2_3;
    const iiwa7_real ud1_3 = -ud3_6*u1_6 - (nu2_y + ud3_7*u1_7) - ud3_5*u1_5 - ud3_4*u1_4;
    const iiwa7_real u1_3 = ipivot3*ud1_3;
    const iiwa7_real pivot2 = m2_2 - nu3_y*u2_7 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3;
    const iiwa7_real ipivot2 = 1.0 / pivot2;
    const iiwa7_real ud1_2 = k2_yz - nu3_y*u1_7 - m2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3;
    const iiwa7_real u1_2 = ipivot2*ud1_2;
    const iiwa7_real t69 = m1_1 - ud1_7*u1_7 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3;
    const iiwa7_real pivot1 = t69 - ud1_2*u1_2;
    const iiwa7_real ipivot1 = 1.0 / pivot1;
    /* link 5: forward substitution */
    const iiwa7_real y5 = tau[4] - n5_z - c6*y7 - y6*u5_6;
    /* link 4: forward substitution */
    const iiwa7_real y4 = -y6*u4_6 - (n4_z - tau[3] + y7*u4_7) - u4_5*y5;
    /* link 3: forward substitution */
    const iiwa7_real y3 = tau[2] - n3_z - y7*u3_7 - y6*u3_6 - u3_5*y5 - u3_4*y4;
    /* link 2: forward substitution */
    const iiwa7_real y2 = neg_n2_z + tau[1] - y7*u2_7 - y6*u2_6 - u2_5*y5 - u2_4*y4 - u2_3*y3;
    const iiwa7_real t70 = n02_y + tau[0] - y7*u1_7 - y6*u1_6 - u1_5*y5 - u1_4*y4 - u1_3*y3;
    /* link 1: forward substitution */
    const iiwa7_real y1 = t70 - u1_2*y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd2 = ipivot2*y2 - u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd5 = ipivot5*y5 - u4_5*qdd4 - u3_5*qdd3 - u2_5*qdd2 - u1_5*qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd6 = -u1_6*qdd1 - (u5_6*qdd5 - y6*ipivot6 + u4_6*qdd4 + u3_6*qdd3 +
        u2_6*qdd2);
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa7_real qdd7 = -u1_7*qdd1 - (c6*qdd5 - 348.18941504178275*y7 + u4_7*qdd4 + u3_7*qdd3 +
        u2_7*qdd2);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
