/*
 * puma560_d2: PUMA 560, the set of the thesis's program D.2
 * Numbers: the 1990 thesis, program D.2 (reduce_puma6), with z4 = -0.019 as listing D.3.4 uses it
 * Origin of numbers: geometry, inertia; mass, centre of mass (joints 2 to 6): stated by the
 *     description
 * Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: b8f01132844a21fecaa07c198852efc3 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0        d 0        theta q
 *   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
 *   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
 *   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
 *   5  revolute  alpha -pi/2  a 0        d 0        theta q
 *   6  revolute  alpha pi/2   a 0        d 0        theta q
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 128 multiplications, 101 additions = 229; 0 unary minus; 8 sine/cosine
 *   gravity: 11 multiplications, 6 additions = 17; 2 unary minus; 7 sine/cosine
 *   bias: 119 multiplications, 83 additions = 202; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 53 multiplications, 49 additions = 102; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 232 multiplications, 189 additions, 4 divisions = 425; 2 unary minus; 8
 *       sine/cosine
 */
#include "puma560_d2.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 128 multiplications, 101 additions = 229; 0 unary minus; 8 sine/cosine */
void puma560_d2_inverse_dynamics(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    const puma560_d2_real qdd[6],
    puma560_d2_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_d2_real angle23 = q[1] + q[2];
    const puma560_d2_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_d2_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_d2_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha3_y = neg_ww3_zx - c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_d2_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_12 = alpha3_z - ww3_xy;
    const puma560_d2_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const puma560_d2_real lam3_21 = alpha3_z + ww3_xy;
    /* sines and cosines of the joint angles */
    const puma560_d2_real s4 = sin(q[3]);
    const puma560_d2_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_d2_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_d2_real w4_z = neg_w3_y + qd[3];
    const puma560_d2_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww4_yz = w4_y*w4_z;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_d2_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c5 = cos(q[4]);
    const puma560_d2_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_d2_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_d2_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_d2_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_d2_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_d2_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c2 = cos(q[1]);
    const puma560_d2_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_32 = s23*qdd[0] + 2.0*neg_ww3_yz;
    const puma560_d2_real t1 = neg_lam3_12*s4 - c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_x = ww4_yz + t1;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha5_y = neg_w5_x*qd[4] - (alpha4_z*c5 + s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n06_z = 0.193*(qdd[5] - alpha5_y);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam5_32 = alpha4_z*s5 + (neg_w5_y*(qd[4] + w5_z) - c5*alpha4_x);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam2_33 = qd[0]*qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_d2_real neg_w2_x = qd[0]*s2;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_d2_real ww3_yy = neg_lam2_33 - ww3_xx;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_11 = ww3_zz + ww3_yy;
    const puma560_d2_real t2 = 0.1794*alpha5_y - n06_z;
    const puma560_d2_real t3 = 0.193*(1.9295336787564767*neg_w5_y + qd[5]);
    const puma560_d2_real t4 = 21.27093596059113*c2;
    const puma560_d2_real t5 = neg_w2_x*(42.54187192118226*qd[1]);
    const puma560_d2_real t6 = neg_lam3_31 - 7.394088669950739*neg_lam2_33 + (qdd[0]*t4 - t5);
    const puma560_d2_real t7 = neg_lam5_32 - 299.234375*t1;
    const puma560_d2_real t8 = 21.27093596059113*s2;
    const puma560_d2_real t9 = qdd[1]*t8 + t4*ww2_zz;
    const puma560_d2_real t10 = 0.06813163062899491*c2;
    const puma560_d2_real t11 = t10*neg_lam2_33;
    const puma560_d2_real t12 = t9 + 312.203535482957*(t11 + 0.023683552008828473*qdd[0]);
    const puma560_d2_real t13 = qdd[1]*t4 - (t8*ww2_zz + 482.7586206896552);
    const puma560_d2_real t14 = c23*t12 - (neg_lam3_11 + s23*t13);
    const puma560_d2_real t15 = c4*t6 + (0.07129854439169339*t7 + s4*t14);
    const puma560_d2_real t16 = 0.0174944385*t15;
    const puma560_d2_real t17 = w5_z*t3 - 0.003341862043757506*(53.781451552625*neg_lam5_32 + t16);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n4_z = 0.0222*alpha4_z - (c5*t2 + s5*t17) - w4_y*(0.1791*neg_w4_x);
    const puma560_d2_real t18 = neg_lam3_12*c4 + s4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_y = neg_ww4_zx + t18;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real lam5_12 = ww5_xy - alpha5_z;
    const puma560_d2_real t19 = 0.0005151125*(t15 + 0.042198992554119415*t7);
    const puma560_d2_real t20 = 5.8464e-05*s5;
    const puma560_d2_real t21 = 5.8464e-05*c5;
    const puma560_d2_real t22 = neg_lam5_22*t20 + t21*lam5_12;
    const puma560_d2_real t23 = s4*t6 - c4*t14;
    const puma560_d2_real t24 = t22 - 0.0174944385*(t18 + 0.029444357416787054*t23);
    const puma560_d2_real t25 = c4*t19 - s4*t24;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_y = 0.44345*neg_lam3_31 - (0.0068208*neg_lam3_32 + (n4_z - t25));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_22 = ww3_zz + ww3_xx;
    const puma560_d2_real t26 = lam3_21 - (21.334975369458128*neg_lam3_22 + (s23*t12 + c23*t13));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n5_z = t21*(t23 + 21.334975369458128*t18) + (neg_w5_x*t3 - (t20*t26 +
        0.17973436*lam5_12));
    const puma560_d2_real t27 = n5_z + (0.7429401365*alpha4_y - (0.5416401365*neg_ww4_zx +
        21.334975369458128*(t22 - 0.0008199886897945047*t23)));
    const puma560_d2_real t28 = t16 + (0.1569*ww4_yz - (0.190596722*t1 - s5*t2) - c5*t17);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_x = 0.0068208*neg_lam3_31 - s4*t27 - c4*t28;
    const puma560_d2_real t29 = c4*t24 + s4*t19;
    const puma560_d2_real t30 = neg_lam5_22*t21 + (0.006504526*neg_lam3_22 - (t20*lam5_12 +
        0.0005151125*t26));
    const puma560_d2_real t31 = c23*t29 + s23*t30;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n1_z = 0.001081008566929134*t9 + qdd[0]*(t4*t10 + 2.334879198) - (c23*n3_y
        - (t4*t25 - (t10*t5 - 7.394088669950739*t31)) + s23*n3_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_z = 0.44345*lam3_21 + c4*t27 - (t30 + (0.0068208*(neg_lam3_11 -
        neg_lam3_22) + s4*t28));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n02_z = t8*(0.001081008566929134*qdd[0] + (t11 + t31)) +
        (6.305523552*qdd[1] + t4*(c23*t30 - (s23*t29 + 0.40978507086614174)) + n3_z);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* torques that hold the arm at rest
 * 11 multiplications, 6 additions = 17; 2 unary minus; 7 sine/cosine */
void puma560_d2_gravity(const puma560_d2_real q[6], puma560_d2_real tau[6])
{
    /* sines and cosines of the joint angles */
    const puma560_d2_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw5_y = -0.028224*c5;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c4 = cos(q[3]);
    const puma560_d2_real angle23 = q[1] + q[2];
    const puma560_d2_real s23 = sin(angle23);
    const puma560_d2_real c23 = cos(angle23);
    const puma560_d2_real s5 = sin(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw5_x = 0.028224*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_d2_real tau5 = hw5_y*(c4*s23) - c23*hw5_x;
    /* sines and cosines of the joint angles */
    const puma560_d2_real s4 = sin(q[3]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw4_y = hw5_x*s4;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_d2_real tau4 = s23*hw4_y;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c2 = cos(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw4_x = c4*hw5_x;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw3_x = c23*(hw4_x - 0.248675) + s23*(8.445591 - hw5_y);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_d2_real hw2_x = hw3_x + 14.006062*c2;
    const puma560_d2_real t1 = -hw2_x;
    const puma560_d2_real t2 = -hw3_x;
    tau[0] = 0.0;
    tau[1] = t1;
    tau[2] = t2;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 119 multiplications, 83 additions = 202; 0 unary minus; 8 sine/cosine */
void puma560_d2_bias(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    puma560_d2_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_d2_real angle23 = q[1] + q[2];
    const puma560_d2_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_d2_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_d2_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_d2_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_d2_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_31 = 2.0*neg_ww3_zx;
    /* sines and cosines of the joint angles */
    const puma560_d2_real s4 = sin(q[3]);
    const puma560_d2_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_d2_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_d2_real w4_z = neg_w3_y + qd[3];
    const puma560_d2_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww4_yz = w4_y*w4_z;
    const puma560_d2_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c5 = cos(q[4]);
    const puma560_d2_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_d2_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_d2_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_d2_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_d2_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_d2_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c2 = cos(q[1]);
    const puma560_d2_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_32 = 2.0*neg_ww3_yz;
    const puma560_d2_real t1 = ww3_xy*s4 + c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_x = ww4_yz - t1;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha5_y = neg_w5_x*qd[4] + (neg_ww3_zx*c5 - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n06_z = -0.193*alpha5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real lam5_32 = neg_ww3_zx*s5 - (neg_w5_y*(qd[4] + w5_z) - c5*alpha4_x);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam2_33 = qd[0]*qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_d2_real neg_w2_x = qd[0]*s2;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_d2_real ww3_yy = neg_lam2_33 - ww3_xx;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_11 = ww3_zz + ww3_yy;
    const puma560_d2_real t2 = 0.3724*alpha5_y;
    const puma560_d2_real t3 = 0.193*(1.9295336787564767*neg_w5_y + qd[5]);
    const puma560_d2_real t4 = neg_w2_x*(42.54187192118226*qd[1]);
    const puma560_d2_real t5 = neg_lam3_31 - 7.394088669950739*neg_lam2_33 - t4;
    const puma560_d2_real t6 = lam5_32 - 299.234375*t1;
    const puma560_d2_real t7 = 21.27093596059113*c2;
    const puma560_d2_real t8 = t7*ww2_zz;
    const puma560_d2_real t9 = 0.06813163062899491*c2;
    const puma560_d2_real t10 = t9*neg_lam2_33;
    const puma560_d2_real t11 = t8 + 312.203535482957*t10;
    const puma560_d2_real t12 = 21.27093596059113*s2;
    const puma560_d2_real t13 = t12*ww2_zz + 482.7586206896552;
    const puma560_d2_real t14 = c23*t11 - (neg_lam3_11 - s23*t13);
    const puma560_d2_real t15 = c4*t5 - (0.07129854439169339*t6 - s4*t14);
    const puma560_d2_real t16 = 0.0174944385*t15;
    const puma560_d2_real t17 = w5_z*t3 + 0.003341862043757506*(53.781451552625*lam5_32 - t16);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n4_z = w4_y*(-0.1791*neg_w4_x) - (0.0222*neg_ww3_zx + (c5*t2 + s5*t17));
    const puma560_d2_real t18 = ww3_xy*c4 - s4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_y = neg_ww4_zx - t18;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_d2_real t19 = 0.0005151125*(t15 - 0.042198992554119415*t6);
    const puma560_d2_real t20 = 5.8464e-05*s5;
    const puma560_d2_real t21 = 5.8464e-05*c5;
    const puma560_d2_real t22 = neg_lam5_22*t20 + t21*lam5_12;
    const puma560_d2_real t23 = s4*t5 - c4*t14;
    const puma560_d2_real t24 = t22 + 0.0174944385*(t18 - 0.029444357416787054*t23);
    const puma560_d2_real t25 = c4*t19 - s4*t24;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_y = 0.8869*neg_ww3_zx - (0.0136416*neg_ww3_yz - (t25 - n4_z));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_22 = ww3_zz + ww3_xx;
    const puma560_d2_real t26 = ww3_xy - (21.334975369458128*neg_lam3_22 + (s23*t11 - c23*t13));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n5_z = t21*(t23 - 21.334975369458128*t18) + (neg_w5_x*t3 - (t20*t26 +
        0.17973436*lam5_12));
    const puma560_d2_real t27 = n5_z + (0.7429401365*alpha4_y - (0.5416401365*neg_ww4_zx +
        21.334975369458128*(t22 - 0.0008199886897945047*t23)));
    const puma560_d2_real t28 = t16 + (0.1569*ww4_yz + (0.190596722*t1 + s5*t2) - c5*t17);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_x = 0.0136416*neg_ww3_zx - s4*t27 - c4*t28;
    const puma560_d2_real t29 = c4*t24 + s4*t19;
    const puma560_d2_real t30 = neg_lam5_22*t21 + (0.006504526*neg_lam3_22 - (t20*lam5_12 +
        0.0005151125*t26));
    const puma560_d2_real t31 = c23*t29 + s23*t30;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n1_z = 0.001081008566929134*t8 - (c23*n3_y - (t7*t25 - (t9*t4 -
        7.394088669950739*t31)) + s23*n3_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_z = 0.44345*ww3_xy + c4*t27 - (t30 + (0.0068208*(neg_lam3_11 -
        neg_lam3_22) + s4*t28));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n02_z = t12*(t10 + t31) + (t7*(c23*t30 - (s23*t29 + 0.40978507086614174))
        + n3_z);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 53 multiplications, 49 additions = 102; 0 unary minus; 8 sine/cosine */
void puma560_d2_mass_matrix(const puma560_d2_real q[6], puma560_d2_real M[36])
{
    /* sines and cosines of the joint angles */
    const puma560_d2_real c2 = cos(q[1]);
    const puma560_d2_real s2 = sin(q[1]);
    const puma560_d2_real c4 = cos(q[3]);
    const puma560_d2_real s4 = sin(q[3]);
    const puma560_d2_real c5 = cos(q[4]);
    const puma560_d2_real s5 = sin(q[4]);
    const puma560_d2_real angle23 = q[1] + q[2];
    const puma560_d2_real c23 = cos(angle23);
    const puma560_d2_real s23 = sin(angle23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_d2_real nu5_x = 0.193*s5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_d2_real nu4_y = s4*nu5_x;
    const puma560_d2_real t1 = 0.9982675647668394*c5;
    const puma560_d2_real t2 = t1 - 0.006462839378238342;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real m3_4 = nu4_y*t2;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_d2_real neg_nu5_y = 0.19333494026231143*t1;
    const puma560_d2_real t3 = 5.856546086785376e-05*t1;
    const puma560_d2_real t4 = t3 + 0.0174944385;
    const puma560_d2_real t5 = 21.334975369458128*t4 - 0.1935090545;
    const puma560_d2_real t6 = t5 + 0.2155;
    const puma560_d2_real t7 = t2*neg_nu5_y;
    const puma560_d2_real t8 = 0.1933 - t7;
    /* link 4: mass matrix, its row of this joint */
    const puma560_d2_real m4_4 = t6 - t8;
    const puma560_d2_real t9 = 0.0003029222797927461*nu5_x;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real m3_5 = c4*t5 - t9;
    const puma560_d2_real t10 = 21.27093596059113*c2;
    const puma560_d2_real t11 = c4*s23;
    const puma560_d2_real t12 = nu5_x*t11;
    const puma560_d2_real t13 = t2*t12;
    const puma560_d2_real t14 = s23*t4;
    const puma560_d2_real t15 = c4*t9;
    const puma560_d2_real t16 = t15 - 0.0005151125;
    const puma560_d2_real t17 = t10*(t14 + c23*t16);
    const puma560_d2_real t18 = c23*(t13 - (0.0068208*s23 - t14)) - t17;
    const puma560_d2_real t19 = 0.0022398341968911917*nu4_y;
    const puma560_d2_real t20 = t15 - t19;
    const puma560_d2_real t21 = t20 - m4_4;
    const puma560_d2_real t22 = m3_5 - c4*t8;
    const puma560_d2_real t23 = c4*(t9 - t22);
    const puma560_d2_real t24 = t6 + 0.984970889 - t7;
    /* link 1: mass matrix, its row of this joint */
    const puma560_d2_real m1_1 = t10*(0.0037181511794085144*t10) - (t18 + t20 + t21) - (t18 -
        (s23*(s23*(t23 - 1.103430225 + t24)) + 2.807006823));
    const puma560_d2_real t25 = 7.394088669950739*(s23*t16 - c23*t4);
    const puma560_d2_real t26 = s4*s23;
    const puma560_d2_real m1_3 = c23*m3_4 + t25 + t22*t26;
    const puma560_d2_real t27 = 2.876748834110593*s2;
    const puma560_d2_real t28 = t19*t27;
    const puma560_d2_real m1_2 = 0.036155585696850394*t27 + (t28 + m1_3);
    const puma560_d2_real t29 = t10*t9;
    const puma560_d2_real m1_4 = c4*t29 - c23*t21 - t13;
    const puma560_d2_real t30 = c23*t3;
    const puma560_d2_real t31 = t10*t3;
    const puma560_d2_real t32 = 7.394088669950739*(s23*t9 - c4*t30);
    const puma560_d2_real m1_5 = t5*t26 - (s4*(t30 - t31) - t32);
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_d2_real neg_nu3_y = 3301.176792556103*t30 - t12;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real m3_3 = t24 - t23;
    const puma560_d2_real t33 = t17 + t27*t25;
    /* link 2: mass matrix, its row of this joint */
    const puma560_d2_real m2_3 = m3_3 + t33;
    const puma560_d2_real m2_2 = m2_3 + (t33 + 6.538587602);
    const puma560_d2_real m2_4 = m3_4 + (c23*t28 - t26*t29);
    const puma560_d2_real m2_5 = t11*t31 + (m3_5 + (c23*t29 + t27*t32));
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = neg_nu3_y;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = nu4_y;
    M[12] = m1_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = nu4_y;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = 0.0;
    M[28] = 0.17973436;
    M[29] = 0.0;
    M[30] = neg_nu3_y;
    M[31] = nu4_y;
    M[32] = nu4_y;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.193;
}

/* accelerations that the torques tau give
 * 232 multiplications, 189 additions, 4 divisions = 425; 2 unary minus; 8 sine/cosine */
void puma560_d2_forward_dynamics(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    const puma560_d2_real tau[6],
    puma560_d2_real qdd[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_d2_real angle23 = q[1] + q[2];
    const puma560_d2_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_d2_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_d2_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_d2_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_d2_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_d2_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_31 = 2.0*neg_ww3_zx;
    /* sines and cosines of the joint angles */
    const puma560_d2_real s4 = sin(q[3]);
    const puma560_d2_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_d2_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_d2_real w4_z = neg_w3_y + qd[3];
    const puma560_d2_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww4_yz = w4_y*w4_z;
    const puma560_d2_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c5 = cos(q[4]);
    const puma560_d2_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_d2_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_d2_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_d2_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_d2_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_d2_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const puma560_d2_real c2 = cos(q[1]);
    const puma560_d2_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_32 = 2.0*neg_ww3_yz;
    const puma560_d2_real t1 = ww3_xy*s4 + c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_x = ww4_yz - t1;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha5_y = neg_w5_x*qd[4] + (neg_ww3_zx*c5 - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n06_z = -0.193*alpha5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real lam5_32 = neg_ww3_zx*s5 - (neg_w5_y*(qd[4] + w5_z) - c5*alpha4_x);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam2_33 = qd[0]*qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_d2_real neg_w2_x = qd[0]*s2;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_d2_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_d2_real ww3_yy = neg_lam2_33 - ww3_xx;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_11 = ww3_zz + ww3_yy;
    const puma560_d2_real t2 = 0.3724*alpha5_y;
    const puma560_d2_real t3 = 0.193*(1.9295336787564767*neg_w5_y + qd[5]);
    const puma560_d2_real t4 = neg_w2_x*(42.54187192118226*qd[1]);
    const puma560_d2_real t5 = neg_lam3_31 - 7.394088669950739*neg_lam2_33 - t4;
    const puma560_d2_real t6 = lam5_32 - 299.234375*t1;
    const puma560_d2_real t7 = 21.27093596059113*c2;
    const puma560_d2_real t8 = ww2_zz*t7;
    const puma560_d2_real t9 = 0.06813163062899491*c2;
    const puma560_d2_real t10 = neg_lam2_33*t9;
    const puma560_d2_real t11 = t8 + 312.203535482957*t10;
    const puma560_d2_real t12 = 21.27093596059113*s2;
    const puma560_d2_real t13 = ww2_zz*t12 + 482.7586206896552;
    const puma560_d2_real t14 = c23*t11 - (neg_lam3_11 - s23*t13);
    const puma560_d2_real t15 = c4*t5 - (0.07129854439169339*t6 - s4*t14);
    const puma560_d2_real t16 = 0.0174944385*t15;
    const puma560_d2_real t17 = w5_z*t3 + 0.003341862043757506*(53.781451552625*lam5_32 - t16);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real neg_n4_z = w4_y*(0.1791*neg_w4_x) + (0.0222*neg_ww3_zx + (c5*t2 +
        s5*t17));
    const puma560_d2_real t18 = ww3_xy*c4 - s4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_d2_real alpha4_y = neg_ww4_zx - t18;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_d2_real t19 = 0.0005151125*(t15 - 0.042198992554119415*t6);
    const puma560_d2_real t20 = 5.8464e-05*s5;
    const puma560_d2_real t21 = 5.8464e-05*c5;
    const puma560_d2_real t22 = neg_lam5_22*t20 + lam5_12*t21;
    const puma560_d2_real t23 = s4*t5 - c4*t14;
    const puma560_d2_real t24 = t22 + 0.0174944385*(t18 - 0.029444357416787054*t23);
    const puma560_d2_real t25 = c4*t19 - s4*t24;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_y = 0.8869*neg_ww3_zx - (0.0136416*neg_ww3_yz - (neg_n4_z + t25));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_d2_real neg_lam3_22 = ww3_zz + ww3_xx;
    const puma560_d2_real t26 = ww3_xy - (21.334975369458128*neg_lam3_22 + (s23*t11 - c23*t13));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n5_z = t21*(t23 - 21.334975369458128*t18) + (neg_w5_x*t3 - (t20*t26 +
        0.17973436*lam5_12));
    const puma560_d2_real t27 = n5_z + (0.7429401365*alpha4_y - (0.5416401365*neg_ww4_zx +
        21.334975369458128*(t22 - 0.0008199886897945047*t23)));
    const puma560_d2_real t28 = t16 + (0.1569*ww4_yz + (0.190596722*t1 + s5*t2) - c5*t17);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_x = 0.0136416*neg_ww3_zx - s4*t27 - c4*t28;
    const puma560_d2_real t29 = c4*t24 + s4*t19;
    const puma560_d2_real t30 = neg_lam5_22*t21 + (0.006504526*neg_lam3_22 - (lam5_12*t20 +
        0.0005151125*t26));
    const puma560_d2_real t31 = c23*t29 + s23*t30;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n1_z = 0.001081008566929134*t8 - (c23*n3_y - (t7*t25 - (t4*t9 -
        7.394088669950739*t31)) + s23*n3_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_d2_real n3_z = 0.44345*ww3_xy + c4*t27 - (t30 + (0.0068208*(neg_lam3_11 -
        neg_lam3_22) + s4*t28));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_d2_real n02_z = t12*(t10 + t31) + (n3_z + t7*(c23*t30 - (s23*t29 +
        0.40978507086614174)));
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_d2_real nu5_x = 0.193*s5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_d2_real nu4_y = s4*nu5_x;
    const puma560_d2_real t32 = 0.9982675647668394*c5 - 0.006462839378238342;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real m3_4 = nu4_y*t32;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_d2_real neg_nu5_y = 0.193*c5;
    const puma560_d2_real t33 = t21 + 0.0174944385;
    const puma560_d2_real t34 = 21.334975369458128*t33;
    const puma560_d2_real t35 = t32*neg_nu5_y;
    /* link 4: mass matrix, its row of this joint */
    const puma560_d2_real m4_4 = t34 + t35 - 0.1713090545;
    const puma560_d2_real t36 = t34 - 0.1935090545;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real neg_m3_5 = t20 - c4*t36;
    const puma560_d2_real t37 = s23*c4;
    const puma560_d2_real t38 = nu5_x*t37;
    const puma560_d2_real t39 = t32*t38;
    const puma560_d2_real t40 = s23*t33;
    const puma560_d2_real t41 = c4*t20;
    const puma560_d2_real t42 = t41 - 0.0005151125;
    const puma560_d2_real t43 = t7*(t40 + c23*t42);
    const puma560_d2_real t44 = c23*(t39 - (0.0068208*s23 - t40)) - t43;
    const puma560_d2_real t45 = 0.0022398341968911917*nu4_y;
    const puma560_d2_real t46 = t41 - t45;
    const puma560_d2_real t47 = m4_4 - t46;
    const puma560_d2_real t48 = neg_m3_5 - c4*(t35 - 0.1933);
    const puma560_d2_real t49 = c4*(t20 + t48);
    const puma560_d2_real t50 = t35 - (t34 + 1.0069618345);
    /* link 1: mass matrix, its row of this joint */
    const puma560_d2_real m1_1 = t7*(0.0790885556289949*c2) - (t44 + t46 - t47) - (t44 -
        (s23*(s23*(t49 - 1.103430225 - t50)) + 2.807006823));
    const puma560_d2_real t51 = 7.394088669950739*(s23*t42 - c23*t33);
    const puma560_d2_real t52 = s23*s4;
    const puma560_d2_real m1_3 = c23*m3_4 + t51 - t48*t52;
    const puma560_d2_real t53 = 2.876748834110593*s2;
    const puma560_d2_real t54 = t45*t53;
    const puma560_d2_real m1_2 = 0.104010539*s2 + (m1_3 + t54);
    const puma560_d2_real t55 = t7*t20;
    const puma560_d2_real neg_m1_4 = t39 - (c4*t55 + c23*t47);
    const puma560_d2_real t56 = c23*t21;
    const puma560_d2_real t57 = t7*t21;
    const puma560_d2_real t58 = 7.394088669950739*(s23*t20 - c4*t56);
    const puma560_d2_real m1_5 = t36*t52 - (s4*(t56 - t57) - t58);
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_d2_real nu3_y = t38 - 3301.176792556103*t56;
    /* link 3: mass matrix, its row of this joint */
    const puma560_d2_real neg_m3_3 = t49 + t50;
    const puma560_d2_real t59 = t43 + t51*t53;
    /* link 2: mass matrix, its row of this joint */
    const puma560_d2_real m2_3 = t59 - neg_m3_3;
    const puma560_d2_real m2_2 = m2_3 + (t59 + 6.538587602);
    const puma560_d2_real m2_4 = m3_4 + (c23*t54 - t52*t55);
    const puma560_d2_real m2_5 = t37*t57 - (neg_m3_5 - (c23*t55 + t53*t58));
    /* link 5: forward substitution */
    const puma560_d2_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const puma560_d2_real y6 = tau[5] - n06_z;
    /* factorisation M = U D U^T */
    const puma560_d2_real u3_6 = 5.181347150259067*nu4_y;
    const puma560_d2_real neg_u1_6 = 5.181347150259067*nu3_y;
    const puma560_d2_real neg_u3_5 = 5.56376643842613*neg_m3_5;
    const puma560_d2_real u2_5 = 5.56376643842613*m2_5;
    const puma560_d2_real u1_5 = 5.56376643842613*m1_5;
    const puma560_d2_real pivot4 = m4_4 - c5*neg_nu5_y;
    const puma560_d2_real ipivot4 = 1.0 / pivot4;
    const puma560_d2_real t60 = neg_nu5_y*u3_6;
    const puma560_d2_real ud3_4 = m3_4 - t60;
    const puma560_d2_real u3_4 = ipivot4*ud3_4;
    const puma560_d2_real ud2_4 = m2_4 - t60;
    const puma560_d2_real u2_4 = ipivot4*ud2_4;
    const puma560_d2_real neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6;
    const puma560_d2_real neg_u1_4 = ipivot4*neg_ud1_4;
    const puma560_d2_real t61 = nu4_y*u3_6;
    const puma560_d2_real neg_pivot3 = neg_m3_3 + t61 + neg_m3_5*neg_u3_5 + ud3_4*u3_4;
    const puma560_d2_real neg_ipivot3 = 1.0 / neg_pivot3;
    const puma560_d2_real neg_ud2_3 = t61 - m2_3 - neg_m3_5*u2_5 + ud3_4*u2_4;
    const puma560_d2_real u2_3 = neg_ipivot3*neg_ud2_3;
    const puma560_d2_real t62 = nu4_y*neg_u1_6;
    const puma560_d2_real ud1_3 = m1_3 + t62 + neg_m3_5*u1_5 + ud3_4*neg_u1_4;
    const puma560_d2_real neg_u1_3 = neg_ipivot3*ud1_3;
    const puma560_d2_real neg_pivot2 = t61 - m2_2 + m2_5*u2_5 + ud2_4*u2_4 - neg_ud2_3*u2_3;
    const puma560_d2_real neg_ipivot2 = 1.0 / neg_pivot2;
    const puma560_d2_real ud1_2 = m1_2 + t62 - m2_5*u1_5 + ud2_4*neg_u1_4 - neg_ud2_3*neg_u1_3;
    const puma560_d2_real neg_u1_2 = neg_ipivot2*ud1_2;
    const puma560_d2_real pivot1 = m1_1 - nu3_y*neg_u1_6 - m1_5*u1_5 - neg_ud1_4*neg_u1_4 +
        ud1_3*neg_u1_3 + ud1_2*neg_u1_2;
    const puma560_d2_real ipivot1 = 1.0 / pivot1;
    /* link 4: forward substitution */
    const puma560_d2_real y4 = neg_n4_z + tau[3] - c5*y6;
    const puma560_d2_real t63 = y6*u3_6;
    /* link 3: forward substitution */
    const puma560_d2_real neg_y3 = n3_z - tau[2] + t63 + neg_y5*neg_u3_5 + u3_4*y4;
    /* link 2: forward substitution */
    const puma560_d2_real neg_y2 = n02_z - tau[1] + t63 - neg_y5*u2_5 + u2_4*y4 - u2_3*neg_y3;
    /* link 1: forward substitution */
    const puma560_d2_real neg_y1 = n1_z - tau[0] - y6*neg_u1_6 - neg_y5*u1_5 - neg_u1_4*y4 +
        neg_u1_3*neg_y3 + neg_u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real qdd2 = neg_ipivot2*neg_y2 - neg_u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 - neg_u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real qdd4 = ipivot4*y4 - u3_4*qdd3 - u2_4*qdd2 - neg_u1_4*neg_qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real qdd5 = u1_5*neg_qdd1 - (5.56376643842613*neg_y5 - neg_u3_5*qdd3 +
        u2_5*qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_d2_real qdd6 = u3_6*(-qdd2 - qdd3) - (neg_u1_6*neg_qdd1 - (5.181347150259067*y6 -
        c5*qdd4));
    const puma560_d2_real t64 = -neg_qdd1;
    qdd[0] = t64;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
