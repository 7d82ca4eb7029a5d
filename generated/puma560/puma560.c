/*
 * puma560: PUMA 560, six joints
 * Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: rotor inertia; inertia (joints 1 to 3); mass, centre of mass (joints 2, 3):
 *     measured on the arm
 * Origin of numbers: limits; mass, centre of mass, inertia (joints 4 to 6): assumed
 * Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: b422b6e98684ac1e67f70c9b558f78f5 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   5  revolute  alpha -pi/2  a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   6  revolute  alpha pi/2   a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 * Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2, joint 4 0.2 kg
 *     m^2, joint 5 0.179 kg m^2, joint 6 0.193 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
 *   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
 *   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 55 multiplications, 55 additions = 110; 1 unary minus; 8 sine/cosine
 *   forward_dynamics: 246 multiplications, 204 additions, 4 divisions = 454; 9 unary minus; 8
 *       sine/cosine
 */
#include "puma560.h"

#include <math.h>

/* torques that give the accelerations qdd
 * with rotor inertia
 * 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine */
void puma560_inverse_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real qdd[6],
    puma560_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_y = neg_ww3_zx - neg_lam3_13;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_12 = alpha3_z - ww3_xy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const puma560_real lam3_21 = alpha3_z + ww3_xy;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(q[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = neg_w3_x*s4 + w3_z*c4;
    const puma560_real w4_z = neg_w3_y + qd[3];
    const puma560_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_real w5_y = neg_w4_x*s5 - w4_z*c5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_32 = s23*qdd[0] + w3_z*(2.0*neg_w3_y);
    const puma560_real t1 = neg_lam3_12*c4 + s4*neg_lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy + t1) + qdd[4];
    const puma560_real t2 = neg_lam3_12*s4 - c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz + t2;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = neg_w5_x*qd[4] - s5*alpha4_x - alpha4_z*c5;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_z = 4e-05*(qdd[5] - alpha5_y);
    const puma560_real t3 = 0.0002*w5_y;
    const puma560_real t4 = t3 - 4e-05*w6_z;
    const puma560_real t5 = 0.000432288*s5;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*(w5_y*(qd[4] + w5_z)) - (alpha4_z*t5 - t6*alpha4_x);
    const puma560_real t8 = 2.876748834110593*s2;
    const puma560_real t9 = 2.876748834110593*c2;
    const puma560_real t10 = qdd[1]*t8 + (qdd[0] + t9*(neg_lam2_33 + ww2_zz));
    const puma560_real t11 = ww2_zz*t8;
    const puma560_real t12 = t11 - (qdd[1]*t9 - 65.28980679546969);
    const puma560_real t13 = 0.13524317121918722*neg_lam3_11 - (c23*t10 + s23*t12);
    const puma560_real t14 = 2.0*(qd[1]*qd[0]);
    const puma560_real t15 = 0.13524317121918722*neg_lam3_31 - (neg_lam2_33 - qdd[0]*t9) - t14*t8;
    const puma560_real t16 = s4*t13 - c4*t15;
    const puma560_real t17 = t7 + 0.044830870394712535*t16;
    const puma560_real t18 = 0.1293554295*t2 + t17;
    const puma560_real t19 = w5_z*t4 - 0.00964264124684461*(t18 + 129.06435256003232*t7);
    const puma560_real t20 = 0.0001*neg_ww5_zx - n06_z + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = 0.0013*alpha4_z + s5*t19 - c5*t20;
    const puma560_real t21 = 46.378743915669716*neg_lam3_12;
    const puma560_real t22 = 67.24917867772109*neg_lam3_32;
    const puma560_real t23 = c4*t13 + s4*t15;
    const puma560_real t24 = neg_lam5_22*t5 - t6*neg_lam5_12;
    const puma560_real t25 = 0.0281625125*t23 - (t24 - 0.1293554295*t1);
    const puma560_real t26 = 0.01666835789471254*t16 - t18;
    const puma560_real t27 = s4*t25 + c4*t26;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_y = 0.13524317121918722*(0.0007499511665665606*(t21 - t22) + t27) +
        (0.01625*neg_lam3_31 - n4_z);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t20 - c5*t19;
    const puma560_real t28 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = t28 - neg_lam2_33;
    const puma560_real t29 = c23*t12 + (0.13524317121918722*lam3_21 - s23*t10);
    const puma560_real t30 = -2.8854097268487675*lam3_22 - t29;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t5*t30 + (0.00064216*neg_lam5_12 + t6*(t23 + 2.8854097268487675*t1) -
        neg_w5_x*(t3 + t4));
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real t31 = 2.8854097268487675*t17 + n4_x;
    const puma560_real t32 = 2.8854097268487675*t24 - n5_z - (nc4_y + 0.1293554295*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t31 - 0.004704*(t22 - t28) + (0.0068208*neg_lam3_31 + s4*t32);
    const puma560_real t33 = 0.0141984*c2;
    const puma560_real t34 = t33 + 0.3642398174241758*s2;
    const puma560_real t35 = t34 - 0.36469509561966457*s2;
    const puma560_real t36 = 1.6727941176470589*t34;
    const puma560_real t37 = s2*t33;
    const puma560_real t38 = c2*t33;
    const puma560_real t39 = 96.40502817218841*(t37 - 7.363931254000739e-05) + t38;
    const puma560_real t40 = ww2_zz*(42.91316091954023*t35) + (qdd[1]*t36 - t39*t14) +
        (qdd[0]*(96.40502817218841*t38 - (t37 - 2.646693438)) - (c23*n3_y - t9*t27));
    const puma560_real t41 = c4*t25 - s4*t26;
    const puma560_real t42 = 0.01666835789471254*(t29 + 2.689579302165907*t30) + (neg_lam5_22*t6 +
        t5*neg_lam5_12);
    const puma560_real t43 = c23*t41 - s23*t42;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t40 - s23*n3_x - t43 - 0.0014646998319327732*t11;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = 0.0068208*(t21 - (neg_lam3_11 + lam3_22 - (2.382418484635233*lam3_21 -
        19.8280511405095*t42))) - 0.004704*neg_lam3_13 + (s4*t31 - c4*t32);
    const puma560_real t44 = 6.225049952*qdd[1] + neg_lam2_33*t39 + (n3_z - (2247.2413793103447*t35
        - t9*(s23*t41 + c23*t42)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = t44 - (t8*t43 - qdd[0]*t36);
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau3 = n3_z + 0.83*qdd[2];
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau4 = n4_z + 0.2*qdd[3];
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau5 = n5_z + 0.179*qdd[4];
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau6 = n06_z + 0.193*qdd[5];
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques that hold the arm at rest
 * 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine */
void puma560_gravity(const puma560_real q[6], puma560_real tau[6])
{
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw5_y = -0.028224*c5;
    /* sines and cosines of the joint angles */
    const puma560_real c4 = cos(q[3]);
    const puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    const puma560_real c23 = cos(angle23);
    const puma560_real s5 = sin(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw5_x = 0.028224*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau5 = hw5_y*(c4*s23) - c23*hw5_x;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(q[3]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw4_y = hw5_x*s4;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau4 = s23*hw4_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw4_x = c4*hw5_x;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw3_x = c23*(hw4_x - 0.248675) + s23*(8.445591 - hw5_y);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_real hw2_x = hw3_x + (37.196782*c2 - 1.02312*s2);
    const puma560_real t1 = -hw2_x;
    const puma560_real t2 = -hw3_x;
    tau[0] = 0.0;
    tau[1] = t1;
    tau[2] = t2;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine */
void puma560_bias(const puma560_real q[6], const puma560_real qd[6], puma560_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(q[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = neg_w3_x*s4 + w3_z*c4;
    const puma560_real w4_z = neg_w3_y + qd[3];
    const puma560_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_real w5_y = neg_w4_x*s5 - w4_z*c5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_32 = w3_z*(2.0*neg_w3_y);
    const puma560_real t1 = ww3_xy*c4 - s4*neg_lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy - t1);
    const puma560_real t2 = ww3_xy*s4 + c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz - t2;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_z = -4e-05*alpha5_y;
    const puma560_real t3 = 0.0002*w5_y;
    const puma560_real t4 = t3 - 4e-05*w6_z;
    const puma560_real t5 = 0.000432288*s5;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*(w5_y*(qd[4] + w5_z)) + (neg_ww3_zx*t5 + t6*alpha4_x);
    const puma560_real t8 = 2.876748834110593*c2;
    const puma560_real t9 = t8*(neg_lam2_33 + ww2_zz);
    const puma560_real t10 = 2.876748834110593*s2;
    const puma560_real t11 = ww2_zz*t10;
    const puma560_real t12 = t11 + 65.28980679546969;
    const puma560_real t13 = 0.13524317121918722*neg_lam3_11 - (c23*t9 + s23*t12);
    const puma560_real t14 = 2.0*(qd[1]*qd[0]);
    const puma560_real t15 = neg_lam2_33 - 0.27048634243837444*neg_ww3_zx + t14*t10;
    const puma560_real t16 = s4*t13 + c4*t15;
    const puma560_real t17 = t7 + 0.044830870394712535*t16;
    const puma560_real t18 = 0.1293554295*t2 - t17;
    const puma560_real t19 = w5_z*t4 + 0.00964264124684461*(t18 - 129.06435256003232*t7);
    const puma560_real t20 = 0.0001*neg_ww5_zx - n06_z + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = s5*t19 - 0.0013*neg_ww3_zx - c5*t20;
    const puma560_real t21 = 46.378743915669716*ww3_xy;
    const puma560_real t22 = 67.24917867772109*neg_lam3_32;
    const puma560_real t23 = c4*t13 - s4*t15;
    const puma560_real t24 = neg_lam5_22*t5 - t6*neg_lam5_12;
    const puma560_real t25 = 0.0281625125*t23 - (t24 + 0.1293554295*t1);
    const puma560_real t26 = 0.01666835789471254*t16 + t18;
    const puma560_real t27 = s4*t25 + c4*t26;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n3_y = 0.13524317121918722*(0.0007499511665665606*(t21 + t22) - t27) -
        (0.0325*neg_ww3_zx - n4_z);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t20 - c5*t19;
    const puma560_real t28 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = t28 - neg_lam2_33;
    const puma560_real t29 = c23*t12 + (0.13524317121918722*ww3_xy - s23*t9);
    const puma560_real t30 = -2.8854097268487675*lam3_22 - t29;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t5*t30 + (0.00064216*neg_lam5_12 + t6*(t23 - 2.8854097268487675*t1) -
        neg_w5_x*(t3 + t4));
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real t31 = 2.8854097268487675*t17 + n4_x;
    const puma560_real t32 = 2.8854097268487675*t24 - n5_z - (nc4_y + 0.1293554295*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t31 - 0.004704*(t22 - t28) + (0.0136416*neg_ww3_zx + s4*t32);
    const puma560_real t33 = 0.0141984*c2;
    const puma560_real t34 = t33 - 0.0004552781954887218*s2;
    const puma560_real t35 = 96.40502817218841*(s2*t33 - 7.363931254000739e-05) + c2*t33;
    const puma560_real t36 = ww2_zz*(42.91316091954023*t34) - t35*t14 + (c23*neg_n3_y + t8*t27) -
        s23*n3_x;
    const puma560_real t37 = c4*t25 - s4*t26;
    const puma560_real t38 = 0.01666835789471254*(t29 + 2.689579302165907*t30) + (neg_lam5_22*t6 +
        t5*neg_lam5_12);
    const puma560_real t39 = c23*t37 - s23*t38;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t36 - t39 - 0.0014646998319327732*t11;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = s4*t31 - c4*t32 - 0.0068208*(t21 + (neg_lam3_11 + lam3_22 -
        (2.382418484635233*ww3_xy - 19.8280511405095*t38)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = neg_lam2_33*t35 - (2247.2413793103447*t34 - t8*(s23*t37 + c23*t38) -
        n3_z) - t10*t39;
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 55 multiplications, 55 additions = 110; 1 unary minus; 8 sine/cosine */
void puma560_mass_matrix(const puma560_real q[6], puma560_real M[36])
{
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(q[1]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(q[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(q[4]);
    const puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu5_y = 4e-05*c5;
    const puma560_real t1 = 5.8464e-05*s5;
    const puma560_real t2 = s4*t1;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_y = 0.6841817186644773*t2;
    const puma560_real t3 = 31.1832*neg_nu5_y;
    const puma560_real t4 = t3 + 0.00064216;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_5 = c4*t4 - t1;
    const puma560_real t5 = 1.4616*neg_nu5_y;
    const puma560_real t6 = 59145.01926194356*t5 + 21.334975369458128;
    const puma560_real t7 = t5*t6;
    const puma560_real t8 = t3 - t7;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = t8 + 0.20184216;
    const puma560_real t9 = t7 + 0.00034;
    const puma560_real t10 = t3 + (t9 - 6.125008753);
    const puma560_real t11 = c4*t9 - m3_5;
    const puma560_real t12 = c4*(t1 + t11);
    const puma560_real t13 = 21.27093596059113*c2;
    const puma560_real t14 = c4*t1;
    const puma560_real t15 = t14 - 0.0005151125;
    const puma560_real t16 = t5 + 0.0174944385;
    const puma560_real t17 = t13*(c23*t15 + s23*t16);
    const puma560_real t18 = 7.394088669950739*t2;
    const puma560_real t19 = t18 - (t14 - (t8 + 0.00184216));
    const puma560_real t20 = s23*t14;
    const puma560_real t21 = t6*t20;
    const puma560_real t22 = t17 + 4.45115636 + (t19 + c23*(t21 - s23*(t16 - 0.0068208)));
    const puma560_real t23 = 0.008863689302339443*s2;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_1 = s23*(s23*(t10 + 6.423043777 + t12)) + t22 - (m4_4 - (t22 +
        1.601861202*(c2*(c2 - t23) - 3.7523173977217037)));
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_4 = -t2*t6;
    const puma560_real t24 = 7.394088669950739*(s23*t15 - c23*t16);
    const puma560_real t25 = s4*s23;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_3 = t24 - t11*t25 - c23*(0.004704 - m3_4);
    const puma560_real t26 = 324.55434029612445*t23;
    const puma560_real t27 = t18*t26;
    const puma560_real m1_2 = 0.023751*c2 + m1_3 + t27 + 0.23996349309842518*t26;
    const puma560_real t28 = t1*t13;
    const puma560_real m1_4 = t21 + (c4*t28 + c23*t19);
    const puma560_real t29 = c23*t5;
    const puma560_real t30 = 7.394088669950739*(s23*t1 - c4*t29);
    const puma560_real t31 = t5*t13;
    const puma560_real m1_5 = t4*t25 + t30 - s4*(t29 - t31);
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu3_y = 0.6841817186644773*(t29 - t20);
    const puma560_real t32 = t17 + 6.458114002 + t24*t26;
    const puma560_real t33 = t10 - t12;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_3 = t32 + t33;
    const puma560_real m2_2 = t32 + m2_3;
    const puma560_real m2_4 = m3_4 + c23*t27 - t25*t28;
    const puma560_real m2_5 = t26*t30 + (c4*(s23*t31) + (m3_5 + c23*t28));
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = t33 + 7.288114002;
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
    M[28] = 0.17964216;
    M[29] = 0.0;
    M[30] = neg_nu3_y;
    M[31] = nu4_y;
    M[32] = nu4_y;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.19304;
}

/* accelerations that the torques tau give
 * with rotor inertia
 * 246 multiplications, 204 additions, 4 divisions = 454; 9 unary minus; 8 sine/cosine */
void puma560_forward_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real tau[6],
    puma560_real qdd[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = -s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    const puma560_real t1 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_y = t1*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_zx = w3_z*w3_x;
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam2_33 = t1*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(q[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = w3_z*c4 - w3_x*s4;
    const puma560_real w4_z = qd[3] - w3_y;
    const puma560_real w4_x = w3_x*c4 + w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_z*w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = w4_x*c5 - w4_z*s5;
    const puma560_real w5_y = -w4_z*c5 - w4_x*s5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real ww5_xy = w5_x*w5_y;
    const puma560_real ww5_xx = w5_x*w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam5_22 = -ww5_xx - ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_32 = w3_z*(2.0*w3_y);
    const puma560_real t2 = ww3_xy*c4 + s4*lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam5_12 = ww4_zx + (ww5_xy + t2);
    const puma560_real t3 = ww3_xy*s4 - c4*lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz - t3;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real ww5_zx = w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = -s5*alpha4_x - w5_x*qd[4] - ww3_zx*c5;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real neg_n06_z = 4e-05*alpha5_y;
    const puma560_real t4 = 0.0002*w5_y;
    const puma560_real t5 = t4 - 4e-05*w6_z;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*s5;
    const puma560_real t8 = 0.000432288*(w5_y*(qd[4] + w5_z)) + (alpha4_x*t6 - ww3_zx*t7);
    const puma560_real t9 = 2.876748834110593*c2;
    const puma560_real t10 = t9*(ww2_zz - lam2_33);
    const puma560_real t11 = 2.876748834110593*s2;
    const puma560_real t12 = ww2_zz*t11;
    const puma560_real t13 = t12 + 65.28980679546969;
    const puma560_real t14 = 0.13524317121918722*neg_lam3_11 - (c23*t10 + s23*t13);
    const puma560_real t15 = 2.0*(qd[1]*qd[0]);
    const puma560_real t16 = t11*t15 - (lam2_33 - 0.27048634243837444*ww3_zx);
    const puma560_real t17 = s4*t14 + c4*t16;
    const puma560_real t18 = t8 + 0.044830870394712535*t17;
    const puma560_real t19 = 0.1293554295*t3 - t18;
    const puma560_real t20 = w5_z*t5 + 0.00964264124684461*(t19 - 129.06435256003232*t8);
    const puma560_real t21 = neg_n06_z - 0.0001*ww5_zx + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = s5*t20 + 0.0013*ww3_zx - c5*t21;
    const puma560_real t22 = 46.378743915669716*ww3_xy;
    const puma560_real t23 = -67.24917867772109*lam3_32;
    const puma560_real t24 = c4*t14 - s4*t16;
    const puma560_real t25 = lam5_12*t6 - lam5_22*t7;
    const puma560_real t26 = 0.0281625125*t24 - (t25 + 0.1293554295*t2);
    const puma560_real t27 = t19 + 0.01666835789471254*t17;
    const puma560_real t28 = s4*t26 + c4*t27;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_y = -0.0325*ww3_zx - n4_z -
        0.13524317121918722*(0.0007499511665665606*(t22 + t23) - t28);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t21 - c5*t20;
    const puma560_real t29 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = lam2_33 + t29;
    const puma560_real t30 = c23*t13 + (0.13524317121918722*ww3_xy - s23*t10);
    const puma560_real t31 = -2.8854097268487675*lam3_22 - t30;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t7*t31 + (t6*(t24 - 2.8854097268487675*t2) - 0.00064216*lam5_12 +
        w5_x*(t4 + t5));
    /* link 4: moment that turns the link [N m] */
    const puma560_real neg_nc4_y = 0.0013*ww4_zx;
    const puma560_real t32 = n4_x + 2.8854097268487675*t18;
    const puma560_real t33 = n5_z - 2.8854097268487675*t25 + (0.1293554295*t24 - neg_nc4_y);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t32 - 0.004704*(t23 - t29) + (-0.0136416*ww3_zx - s4*t33);
    const puma560_real t34 = 0.0141984*c2;
    const puma560_real t35 = t34 - 0.0004552781954887218*s2;
    const puma560_real t36 = 96.40502817218841*(s2*t34 - 7.363931254000739e-05) + c2*t34;
    const puma560_real t37 = ww2_zz*(42.91316091954023*t35) - t15*t36 + (t9*t28 - c23*n3_y) -
        s23*n3_x;
    const puma560_real t38 = c4*t26 - s4*t27;
    const puma560_real t39 = 0.01666835789471254*(t30 + 2.689579302165907*t31) + (-lam5_12*t7 -
        lam5_22*t6);
    const puma560_real t40 = c23*t38 - s23*t39;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t37 - t40 - 0.0014646998319327732*t12;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = s4*t32 + c4*t33 - 0.0068208*(t22 + (neg_lam3_11 + lam3_22 -
        (2.382418484635233*ww3_xy - 19.8280511405095*t39)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = n3_z - (2247.2413793103447*t35 - t9*(s23*t38 + c23*t39)) - lam2_33*t36
        - t11*t40;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_real nu5_y = -4e-05*c5;
    const puma560_real t41 = 5.8464e-05*s5;
    const puma560_real t42 = s4*t41;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_y = 0.6841817186644773*t42;
    const puma560_real t43 = 0.001247328*c5;
    const puma560_real t44 = t43 + 0.00064216;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_5 = c4*t44 - t41;
    const puma560_real t45 = 5.8464e-05*c5;
    const puma560_real t46 = 3.4578544061302683*c5 + 21.334975369458128;
    const puma560_real t47 = t45*t46;
    const puma560_real t48 = t43 - t47;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = t48 + 0.20184216;
    const puma560_real t49 = t43 + (t47 - 6.124668753);
    const puma560_real t50 = c4*(t47 + 0.00034) - m3_5;
    const puma560_real t51 = c4*(t41 + t50);
    const puma560_real t52 = 21.27093596059113*c2;
    const puma560_real t53 = c4*t41;
    const puma560_real t54 = t53 - 0.0005151125;
    const puma560_real t55 = t45 + 0.0174944385;
    const puma560_real t56 = t52*(c23*t54 + s23*t55);
    const puma560_real t57 = 7.394088669950739*t42;
    const puma560_real t58 = t57 - (t53 - (t48 + 0.00184216));
    const puma560_real t59 = s23*t53;
    const puma560_real t60 = t46*t59;
    const puma560_real t61 = t56 + 4.45115636 + (t58 + c23*(t60 - s23*(t45 + 0.0106736385)));
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_1 = s23*(s23*(t49 + 6.423043777 + t51)) + t61 - (m4_4 - (t61 +
        1.601861202*(c2*(c2 - 0.008863689302339443*s2) - 3.7523173977217037)));
    /* link 3: mass matrix, its row of this joint */
    const puma560_real neg_m3_4 = t42*t46;
    const puma560_real t62 = 7.394088669950739*(s23*t54 - c23*t55);
    const puma560_real t63 = s23*s4;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_3 = t62 - t50*t63 - c23*(neg_m3_4 + 0.004704);
    const puma560_real t64 = t11*t57;
    const puma560_real m1_2 = m1_3 + 0.023751*c2 + t64 + 0.690314699*s2;
    const puma560_real t65 = t41*t52;
    const puma560_real m1_4 = t60 + (c4*t65 + c23*t58);
    const puma560_real t66 = c23*t45;
    const puma560_real t67 = 7.394088669950739*(s23*t41 - c4*t66);
    const puma560_real t68 = t45*t52;
    const puma560_real m1_5 = t44*t63 + t67 - s4*(t66 - t68);
    const puma560_real t69 = t66 - t59;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = -0.6841817186644773*t69;
    const puma560_real t70 = t56 + 6.458114002 + t11*t62;
    const puma560_real t71 = t49 - t51;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_3 = t70 + t71;
    const puma560_real m2_2 = t70 + m2_3;
    const puma560_real m2_4 = c23*t64 - neg_m3_4 - t63*t65;
    const puma560_real m2_5 = t11*t67 + (c4*(s23*t68) + (m3_5 + c23*t65));
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = t71 + 7.288114002;
    /* link 5: forward substitution */
    const puma560_real y5 = tau[4] - n5_z;
    /* link 6: forward substitution */
    const puma560_real y6 = neg_n06_z + tau[5];
    /* factorisation M = U D U^T */
    const puma560_real u4_6 = 0.00020721094073767094*c5;
    const puma560_real u3_6 = 3.5442484389995714*t42;
    const puma560_real u1_6 = 3.5442484389995714*t69;
    const puma560_real u3_5 = 5.566622000091738*m3_5;
    const puma560_real u2_5 = 5.566622000091738*m2_5;
    const puma560_real u1_5 = 5.566622000091738*m1_5;
    const puma560_real pivot4 = m4_4 + nu5_y*u4_6;
    const puma560_real ipivot4 = 1.0 / pivot4;
    const puma560_real t72 = nu5_y*u3_6;
    const puma560_real ud3_4 = t72 - neg_m3_4;
    const puma560_real u3_4 = ipivot4*ud3_4;
    const puma560_real ud2_4 = m2_4 + t72;
    const puma560_real u2_4 = ipivot4*ud2_4;
    const puma560_real ud1_4 = m1_4 + nu5_y*u1_6;
    const puma560_real u1_4 = ipivot4*ud1_4;
    const puma560_real t73 = nu4_y*u3_6;
    const puma560_real pivot3 = m3_3 - t73 - m3_5*u3_5 - ud3_4*u3_4;
    const puma560_real ipivot3 = 1.0 / pivot3;
    const puma560_real ud2_3 = m2_3 - t73 - m3_5*u2_5 - ud3_4*u2_4;
    const puma560_real u2_3 = ipivot3*ud2_3;
    const puma560_real t74 = nu4_y*u1_6;
    const puma560_real ud1_3 = m1_3 - t74 - m3_5*u1_5 - ud3_4*u1_4;
    const puma560_real u1_3 = ipivot3*ud1_3;
    const puma560_real pivot2 = m2_2 - t73 - m2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3;
    const puma560_real ipivot2 = 1.0 / pivot2;
    const puma560_real ud1_2 = m1_2 - t74 - m2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3;
    const puma560_real u1_2 = ipivot2*ud1_2;
    const puma560_real pivot1 = m1_1 + nu3_y*u1_6 - m1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3 -
        ud1_2*u1_2;
    const puma560_real ipivot1 = 1.0 / pivot1;
    /* link 4: forward substitution */
    const puma560_real neg_y4 = n4_z - tau[3] + y6*u4_6;
    const puma560_real t75 = y6*u3_6;
    /* link 3: forward substitution */
    const puma560_real y3 = u3_4*neg_y4 - (n3_z - tau[2] + t75 + y5*u3_5);
    /* link 2: forward substitution */
    const puma560_real y2 = u2_4*neg_y4 - (tau2 - tau[1] + t75 + y5*u2_5) - u2_3*y3;
    const puma560_real t76 = -(tau1 - tau[0] + y6*u1_6 + y5*u1_5 - u1_4*neg_y4 + u1_3*y3);
    /* link 1: forward substitution */
    const puma560_real y1 = t76 - u1_2*y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd2 = ipivot2*y2 - u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd4 = -u2_4*qdd2 - (ipivot4*neg_y4 + u3_4*qdd3) - u1_4*qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd5 = -(u3_5*qdd3 - 5.566622000091738*y5 + u2_5*qdd2) - u1_5*qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd6 = 5.180273518441774*y6 - u4_6*qdd4 - u1_6*qdd1 - u3_6*(qdd2 + qdd3);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
