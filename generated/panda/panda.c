/*
 * panda: Franka Emika Panda, hand locked
 * Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
 *   fingers locked at the neutral pose
 * Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 4ff65a695f92e93333f180c48f97cb00 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0       d 0.333  theta q + -pi
 *       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 15 rad/s^2, 87 N m
 *   2  revolute  alpha pi/2  a 0       d 0      theta q + -pi
 *       limits: -1.7628 to 1.7628 rad, 2.175 rad/s, 7.5 rad/s^2, 87 N m
 *   3  revolute  alpha pi/2  a 0       d 0.316  theta q
 *       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 10 rad/s^2, 87 N m
 *   4  revolute  alpha pi/2  a 0.0825  d 0      theta q + -pi
 *       limits: -3.0718 to -0.0698 rad, 2.175 rad/s, 12.5 rad/s^2, 87 N m
 *   5  revolute  alpha pi/2  a 0.0825  d 0.384  theta q + -pi
 *       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 15 rad/s^2, 12 N m
 *   6  revolute  alpha pi/2  a 0       d 0      theta q
 *       limits: -0.0175 to 3.7525 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
 *   7  revolute  alpha pi/2  a 0.088   d 0      theta q
 *       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 1.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize search, from the record of an arm that is built alike.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine
 *   mass_matrix: 170 multiplications, 163 additions = 333; 2 unary minus; 12 sine/cosine
 *   forward_dynamics: 553 multiplications, 511 additions, 6 divisions = 1070; 1 unary minus; 12
 *       sine/cosine
 */
#include "panda.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine */
void panda_inverse_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real qdd[7],
    panda_real tau[7])
{
    /* sines and cosines of the joint angles */
    const panda_real s2 = sin(q[1]);
    const panda_real t1 = -s2;
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_x = t1*qd[0];
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const panda_real w2_y = -qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_yz = w2_y*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam2_23 = s2*qdd[0];
    /* link 2: angular acceleration [rad/s^2] */
    const panda_real alpha2_x = ww2_yz - lam2_23;
    /* sines and cosines of the joint angles */
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const panda_real w3_x = w2_x*c3 + qd[1]*s3;
    const panda_real w3_z = qd[2] - w2_y;
    const panda_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    const panda_real ww3_zx = w3_x*w3_z;
    const panda_real ww3_xy = w3_x*w3_y;
    const panda_real ww3_yz = w3_z*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const panda_real w4_x = -w3_z*s4 - w3_x*c4;
    const panda_real w4_z = qd[3] - w3_y;
    const panda_real w4_y = w3_x*s4 - w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_zz = w4_z*w4_z;
    const panda_real ww4_zx = w4_x*w4_z;
    const panda_real ww4_xy = w4_x*w4_y;
    const panda_real ww4_xx = w4_x*w4_x;
    const panda_real ww4_yz = w4_z*w4_y;
    /* sines and cosines of the joint angles */
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = -w4_z*s5 - w4_x*c5;
    const panda_real w5_z = qd[4] - w4_y;
    const panda_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real ww5_yz = w5_z*w5_y;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real ww5_xy = w5_x*w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_22 = ww4_zz + ww4_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = w5_x*c6 + w5_z*s6;
    const panda_real w6_z = qd[5] - w5_y;
    const panda_real w6_y = w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_zz = w6_z*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_yy = w6_y*w6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real neg_w7_z = w6_y - qd[6];
    /* sines and cosines of the joint angles */
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(q[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_y = c3*qdd[1] - w3_x*qd[2] - alpha2_x*s3;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_13 = ww3_zx + alpha3_y;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_21 = ww4_xy + alpha4_z;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = qd[2]*w3_y + (s3*qdd[1] + alpha2_x*c3);
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_zx = w2_x*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_13 = c2*qdd[0];
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_z = ww2_zx + (neg_lam2_13 + qdd[2]);
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_y = s4*alpha3_x + (-c4*alpha3_z - w4_x*qd[3]);
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_z = qdd[4] - alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_21 = ww5_xy + alpha5_z;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_x = qd[3]*w4_y - (c4*alpha3_x + s4*alpha3_z);
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real neg_alpha5_x = s5*alpha4_z - qd[4]*w5_y + c5*alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_32 = ww5_yz - neg_alpha5_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_31 = ww3_zx - alpha3_y;
    const panda_real t2 = t1*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xx = qd[0]*t2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_22 = ww2_zz + ww2_xx;
    const panda_real t3 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_22 = t3 - neg_lam2_22;
    const panda_real t4 = ww4_zz - ww4_xx;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_11 = lam3_22 - t4;
    const panda_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real lam3_21 = ww3_xy + alpha3_z;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_y = s5*alpha4_x - w5_x*qd[4] - c5*alpha4_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_13 = ww5_zx + alpha5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const panda_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_21 = ww6_xy + alpha6_z;
    const panda_real t5 = qd[5] + w6_z;
    const panda_real t6 = -c6*alpha5_z - s6*neg_alpha5_x;
    const panda_real lam6_31 = w6_x*t5 + t6;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_zz = neg_w7_z*neg_w7_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_23 = ww5_yz + neg_alpha5_x;
    const panda_real t7 = c6*neg_alpha5_x - s6*alpha5_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_32 = w6_y*t5 - t7;
    const panda_real lam6_12 = ww6_xy - alpha6_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real t8 = ww5_xx - ww5_zz;
    const panda_real lam5_11 = t8 - neg_lam4_22;
    const panda_real t9 = ww6_zz - ww6_yy;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_22 = neg_lam5_22 + t9;
    const panda_real t10 = ww6_zz - ww7_zz;
    const panda_real t11 = ww6_zz + ww7_zz;
    const panda_real t12 = t11 - neg_lam6_22;
    const panda_real t13 = t10 + t12;
    const panda_real neg_lam6_11 = neg_lam5_22 + t13;
    const panda_real neg_lam6_13 = t6 + w5_y*w6_x;
    const panda_real t14 = 0.0002123224431354016*s7;
    const panda_real t15 = t14 + 0.00016784129658960374*c7;
    const panda_real t16 = 118.9090909090909*c2 + lam3_31 - 3.83030303030303*neg_lam2_22;
    const panda_real t17 = 118.9090909090909*s2;
    const panda_real t18 = c3*t17;
    const panda_real t19 = neg_lam3_11 + t18 - 3.83030303030303*lam3_13;
    const panda_real t20 = s4*t16 - c4*t19;
    const panda_real t21 = t20 - lam4_11;
    const panda_real t22 = 3.83030303030303*lam3_23 + (s3*t17 + lam3_21);
    const panda_real t23 = lam4_31 - t22;
    const panda_real t24 = c5*t21 - s5*t23;
    const panda_real t25 = t24 + 4.654545454545454*lam5_13;
    const panda_real t26 = s4*t19 + c4*t16;
    const panda_real t27 = lam4_21 - t26;
    const panda_real t28 = 4.654545454545454*neg_lam4_22 + t27;
    const panda_real t29 = c6*t25 - s6*t28;
    const panda_real t30 = 1.0666666666666667*neg_lam6_11 - t29;
    const panda_real t31 = 11.402203849817942*c7;
    const panda_real t32 = t14*t31;
    const panda_real t33 = 0.0002123224431354016*c7;
    const panda_real t34 = t31*t33;
    const panda_real t35 = 0.32333777029991095*t32 - (t34 + 0.00213160409441986);
    const panda_real t36 = qdd[6] + neg_lam6_13;
    const panda_real t37 = 0.0009653051699191118*s7 + 0.0012555365982729084*c7;
    const panda_real t38 = t32 + (0.32333777029991095*t34 - 0.0003913912816842475);
    const panda_real t39 = lam6_31 + qdd[6];
    const panda_real t40 = t35 + 0.006684151967360947;
    const panda_real t41 = s5*t21 + c5*t23;
    const panda_real t42 = t41 + (1.0666666666666667*lam6_31 - 4.654545454545454*lam5_23);
    const panda_real t43 = t33 - 0.00016784129658960374*s7;
    const panda_real t44 = t15*t30 - (t35*t36 - (t37*lam6_12 - (t38*t13 - t39*t40))) + t42*t43;
    const panda_real t45 = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_z = t44 - lam6_32*t45;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_23 = t7 - w5_y*w6_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_12 = ww5_xy - alpha5_z;
    const panda_real t46 = 2.0*neg_w7_z;
    const panda_real t47 = w6_x*t46 - lam6_12;
    const panda_real t48 = 0.0011196707334275547*lam6_21 - 0.028934422545659907*lam6_12 - (t37*t36 +
        0.0005462437073966822*(neg_lam6_22 - neg_lam6_11)) - (9.35690973146064e-05*neg_lam6_13 -
        t47*t40);
    const panda_real t49 = lam6_32 - w6_z*t46;
    const panda_real t50 = s6*t25 + c6*t28;
    const panda_real t51 = t50 - 1.0666666666666667*lam6_21;
    const panda_real t52 = t15*t49 - (0.014338888209442497*neg_lam6_22 - 0.017931959153753906*t51 +
        t47*t43);
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_z = t48 - (t45*t12 - 0.0001037589172186853*lam6_23) -
        (1.0666666666666667*t52 + 0.014338888209442497*t30 - t38*t49 + t51*t43);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_32 = ww4_yz + alpha4_x;
    const panda_real t53 = t37*t10 + 0.014338888209442497*t42 - 0.028934422545659907*lam6_32 -
        (t15*t51 + t38*t47 - (t35*t49 + t45*t39));
    const panda_real t54 = 0.0055993270925625*t50 + 0.0001037589172186853*lam6_21 +
        (9.35690973146064e-05*t9 - 0.0005462437073966822*lam6_31 + t53);
    const panda_real t55 = neg_lam5_22 + lam5_11;
    const panda_real t56 = 0.017931959153753906*t42 + (t39*t43 - (0.014338888209442497*lam6_32 +
        t15*(t11 - t13)));
    const panda_real t57 = 0.0055993270925625*neg_lam5_22 + t56;
    const panda_real t58 = 0.0005462437073966822*lam6_32 + nc7_z + (9.35690973146064e-05*lam6_12 +
        0.0001037589172186853*t13 + 1.0666666666666667*(t56 + 0.005249369149277343*t29));
    const panda_real t59 = t58 + 0.0011196707334275547*lam6_31;
    const panda_real t60 = c6*t54 - 0.010045187828321245*lam5_32 - 0.00151524447332703*lam5_31 -
        0.0021640520520981327*(t8 - t55) - (4.654545454545454*t57 + s6*t59);
    const panda_real t61 = t60 - 0.0010267877770288932*lam5_21;
    const panda_real t62 = 0.014338888209442497*lam6_12 + (t43*t11 + 0.017931959153753906*t30 -
        (0.0055993270925625*neg_lam6_13 - t15*t36));
    const panda_real t63 = t52 + 0.0055993270925625*lam6_23;
    const panda_real t64 = c6*t62 - s6*t63;
    const panda_real t65 = 0.0010267877770288932*t8 + (0.001208932934385*t27 + 4.654545454545454*t64
        - (-0.0021640520520981327*lam5_12 - n6_z - 0.00151524447332703*lam5_32));
    const panda_real t66 = 0.001451156065026714*lam5_31 + t65;
    const panda_real t67 = neg_lam4_22 + lam3_22;
    const panda_real t68 = 0.0039053550262761055*lam4_21 - c5*t61 + 0.07937575371526083*lam4_31 +
        (s5*t66 - (0.08256807420204747*t22 - 0.00164448757736928*t67));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = 0.30879988491513166*lam4_32 - t68;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_23 = ww4_yz - alpha4_x;
    const panda_real lam4_13 = ww4_zx + alpha4_y;
    const panda_real lam4_12 = ww4_xy - alpha4_z;
    const panda_real t69 = 0.0021640520520981327*lam5_13 - 0.0010267877770288932*lam5_23 - (c6*t59 +
        s6*t54) - (0.010045187828321245*lam5_12 - 0.001451156065026714*lam5_21);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_z = t69 - (0.00151524447332703*t55 - 0.001208932934385*t41);
    const panda_real t70 = 0.022178148964878252*lam4_23 - n4_x;
    const panda_real t71 = t64 - (0.02767241350487109*t24 - 0.001208932934385*lam5_11);
    const panda_real t72 = t57 - (-0.001208932934385*lam5_21 - 0.02767241350487109*t41);
    const panda_real t73 = s5*t71 + c5*t72;
    const panda_real t74 = 0.02759391246306875*lam4_13 - 0.00164448757736928*lam4_12 - t73 - n5_z -
        (0.010831526996380998*ww4_zx + (0.0039053550262761055*t4 - 0.07937575371526083*lam4_32));
    const panda_real t75 = t73 - (0.08256807420204747*lam4_32 + 0.016011409030815008*t22);
    const panda_real t76 = c4*t74 - 0.0001219124209507298*(neg_lam3_11 + lam3_22) -
        (0.005487648106562251*lam3_23 + (0.002328735327434986*t18 - 1.3360662912304e-05*lam3_21 -
        t75));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_z = s4*t70 - t76 - 0.013297019103287523*lam3_13;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_12 = ww3_xy - alpha3_z;
    const panda_real t77 = 0.001208932934385*lam5_31 + (s6*t62 + 0.02767241350487109*t27 + c6*t63);
    const panda_real t78 = 0.0039053550262761055*lam4_23 + c5*t66 - (0.30879988491513166*lam4_12 -
        (0.00164448757736928*lam4_13 - 0.07937575371526083*(t4 - t67) +
        0.005415763498190499*lam4_21));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_z = t77 + (s5*t61 - 0.08256807420204747*t20) + t78;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_32 = ww3_yz + alpha3_x;
    const panda_real t79 = t2 - (qd[0] - t2);
    const panda_real t80 = 0.0007689361029464017*s2;
    const panda_real t81 = 0.0007689361029464017*(c2 + 13.344544210747523*s2);
    const panda_real t82 = 0.27690780075317833*c2;
    const panda_real t83 = ww2_zz*(0.010261101821008168*c2 - t80) + (t81*qdd[1] +
        (qdd[0]*(37.41570986608598*(t80*t82) - 0.03733744848940618) - c2*n3_z));
    const panda_real t84 = 3.83030303030303*t75 + (s4*t74 + c4*t70) - (0.10510540975539216*lam3_23 -
        (t82 - (0.013297019103287523*t3 + 0.005487648106562251*lam3_21 -
        0.0001219124209507298*lam3_31)));
    const panda_real t85 = 0.016011409030815008*t20 + 0.08256807420204747*lam4_12 - (c5*t71 -
        s5*t72);
    const panda_real t86 = 0.08256807420204747*neg_lam4_22 + (t77 - 0.016011409030815008*t26);
    const panda_real t87 = s4*t85 - c4*t86 - 3.83030303030303*(c4*t85 + s4*t86) -
        0.013297019103287523*lam3_12;
    const panda_real t88 = t87 + (n4_z + (0.005487648106562251*(neg_lam3_11 - neg_lam2_22 -
        0.0024346792383292625*lam3_31) + (0.0001219124209507298*lam3_32 -
        0.10510540975539216*lam3_13)));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const panda_real n1_z = 0.007966717767871044*qd[1]*t79 - (t83 + s2*(c3*t84 + s3*t88));
    const panda_real t89 = 0.04615576498986361*qdd[1] - t79*(0.003983358883935522*qd[0]) + s3*t84 -
        (4.746153896127808*s2 - 0.01993386669246*c2);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real n2_z = t89 - qdd[0]*t81 - c3*t88;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques that hold the arm at rest
 * 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine */
void panda_gravity(const panda_real q[7], panda_real tau[7])
{
    /* sines and cosines of the joint angles */
    const panda_real s7 = sin(q[6]);
    const panda_real c7 = cos(q[6]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw7_y = 0.02524706869282775*s7 + 0.019957855994472883*c7;
    /* sines and cosines of the joint angles */
    const panda_real c6 = cos(q[5]);
    const panda_real c5 = cos(q[4]);
    const panda_real c4 = cos(q[3]);
    const panda_real s2 = sin(q[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real c2 = cos(q[1]);
    const panda_real s4 = sin(q[3]);
    const panda_real s5 = sin(q[4]);
    const panda_real s3 = sin(q[2]);
    const panda_real s6 = sin(q[5]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw7_x = 0.02524706869282775*c7 - 0.019957855994472883*s7;
    const panda_real t1 = s2*c3;
    const panda_real t2 = c4*t1 - c2*s4;
    const panda_real t3 = s2*s3;
    const panda_real t4 = c5*t2 - s5*t3;
    const panda_real t5 = t1*s4 + c4*c2;
    /* link 7: joint torque [N m], at a prismatic joint force [N] */
    const panda_real tau7 = hw7_y*(c6*t4 - s6*t5) - hw7_x*(t2*s5 + c5*t3);
    const panda_real t6 = hw7_x + 2.2744244919379497;
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw6_y = s6*t6 - 1.7050241616318897*c6;
    const panda_real hw6_x = c6*t6 + 1.7050241616318897*s6;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const panda_real tau6 = t4*hw6_y + t5*hw6_x;
    const panda_real t7 = hw7_y - 0.66581089427925;
    const panda_real t8 = hw6_x - 0.14375311619778;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw5_y = c5*t7 - s5*t8;
    const panda_real neg_hw5_x = c5*t8 + s5*t7;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const panda_real tau5 = t3*neg_hw5_x - t2*hw5_y;
    const panda_real t9 = neg_hw5_x - 5.422774494316499;
    const panda_real t10 = hw6_y + 19.742856060845426;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw4_y = s4*t9 + c4*t10;
    const panda_real hw4_x = c4*t9 - s4*t10;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const panda_real tau4 = t1*hw4_y + c2*hw4_x;
    const panda_real t11 = 0.27690780075317833 - hw5_y;
    const panda_real t12 = hw4_x + 7.32667658634432;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const panda_real tau3 = t1*t11 + t3*t12;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw3_x = c3*t12 - s3*t11;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw2_x = s2*(-hw4_y - 32.809545426852715) - c2*(hw3_x - 0.01993386669246);
    tau[0] = 0.0;
    tau[1] = hw2_x;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
    tau[6] = tau7;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine */
void panda_bias(const panda_real q[7], const panda_real qd[7], panda_real tau[7])
{
    /* sines and cosines of the joint angles */
    const panda_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const panda_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const panda_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real neg_ww2_yz = neg_w2_y*qd[1];
    /* sines and cosines of the joint angles */
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const panda_real neg_w3_x = neg_w2_x*c3 - qd[1]*s3;
    const panda_real w3_z = neg_w2_y + qd[2];
    const panda_real w3_y = qd[1]*c3 + neg_w2_x*s3;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    const panda_real neg_ww3_zx = neg_w3_x*w3_z;
    const panda_real neg_ww3_xy = neg_w3_x*w3_y;
    const panda_real ww3_yz = w3_z*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const panda_real neg_w4_x = w3_z*s4 - neg_w3_x*c4;
    const panda_real neg_w4_z = w3_y - qd[3];
    const panda_real neg_w4_y = neg_w3_x*s4 + w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_zz = neg_w4_z*neg_w4_z;
    const panda_real ww4_zx = neg_w4_x*neg_w4_z;
    const panda_real ww4_xy = neg_w4_x*neg_w4_y;
    const panda_real ww4_xx = neg_w4_x*neg_w4_x;
    const panda_real ww4_yz = neg_w4_z*neg_w4_y;
    /* sines and cosines of the joint angles */
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = neg_w4_x*c5 + neg_w4_z*s5;
    const panda_real w5_z = neg_w4_y + qd[4];
    const panda_real neg_w5_y = neg_w4_x*s5 - neg_w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real neg_ww5_yz = w5_z*neg_w5_y;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real neg_ww5_xy = w5_x*neg_w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_22 = ww4_zz + ww4_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = w5_x*c6 + w5_z*s6;
    const panda_real w6_z = neg_w5_y + qd[5];
    const panda_real w6_y = w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_zz = w6_z*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_yy = w6_y*w6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_z = qd[6] - w6_y;
    /* sines and cosines of the joint angles */
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(q[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_y = neg_ww2_yz*s3 + neg_w3_x*qd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_13 = neg_ww3_zx - alpha3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = qd[2]*w3_y - neg_ww2_yz*c3;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real neg_ww2_zx = neg_w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_y = s4*alpha3_x + (neg_w4_x*qd[3] + c4*neg_ww2_zx);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_21 = neg_ww5_xy + alpha4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real neg_alpha4_x = qd[3]*neg_w4_y + (c4*alpha3_x - s4*neg_ww2_zx);
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real neg_alpha5_x = qd[4]*neg_w5_y - s5*alpha3_y - c5*neg_alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_32 = neg_ww5_yz + neg_alpha5_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const panda_real t1 = s2*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xx = qd[0]*t1;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_22 = ww2_zz + ww2_xx;
    const panda_real t2 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_22 = t2 - neg_lam2_22;
    const panda_real t3 = ww4_zz - ww4_xx;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_11 = lam3_22 - t3;
    const panda_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real neg_lam3_21 = neg_ww3_xy + neg_ww2_zx;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_y = c5*alpha3_y - (w5_x*qd[4] + s5*neg_alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_13 = ww5_zx + alpha5_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_21 = ww6_xy - alpha5_y;
    const panda_real t4 = qd[5] + w6_z;
    const panda_real t5 = c6*alpha4_y - s6*neg_alpha5_x;
    const panda_real lam6_31 = w6_x*t4 + t5;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_zz = w7_z*w7_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_23 = neg_ww5_yz - neg_alpha5_x;
    const panda_real t6 = s6*alpha4_y + c6*neg_alpha5_x;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_32 = w6_y*t4 - t6;
    const panda_real lam6_12 = ww6_xy + alpha5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real t7 = ww5_xx - ww5_zz;
    const panda_real lam5_11 = t7 - neg_lam4_22;
    const panda_real t8 = ww6_zz - ww6_yy;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_22 = neg_lam5_22 + t8;
    const panda_real t9 = ww6_zz - ww7_zz;
    const panda_real t10 = ww6_zz + ww7_zz;
    const panda_real t11 = t10 - neg_lam6_22;
    const panda_real t12 = t9 + t11;
    const panda_real neg_lam6_11 = neg_lam5_22 + t12;
    const panda_real neg_lam6_13 = t5 - neg_w5_y*w6_x;
    const panda_real t13 = 0.0002123224431354016*s7;
    const panda_real t14 = t13 + 0.00016784129658960374*c7;
    const panda_real t15 = 118.9090909090909*c2 - neg_lam3_31 - 3.83030303030303*neg_lam2_22;
    const panda_real t16 = 118.9090909090909*s2;
    const panda_real t17 = c3*t16;
    const panda_real t18 = neg_lam3_11 + t17 + 3.83030303030303*neg_lam3_13;
    const panda_real t19 = s4*t15 - c4*t18;
    const panda_real t20 = t19 - lam4_11;
    const panda_real t21 = 3.83030303030303*lam3_23 + (s3*t16 - neg_lam3_21);
    const panda_real t22 = lam4_31 - t21;
    const panda_real t23 = c5*t20 - s5*t22;
    const panda_real t24 = t23 + 4.654545454545454*lam5_13;
    const panda_real t25 = s4*t18 + c4*t15;
    const panda_real t26 = lam4_21 - t25;
    const panda_real t27 = 4.654545454545454*neg_lam4_22 + t26;
    const panda_real t28 = c6*t24 - s6*t27;
    const panda_real t29 = 1.0666666666666667*neg_lam6_11 - t28;
    const panda_real t30 = 11.402203849817942*c7;
    const panda_real t31 = t13*t30;
    const panda_real t32 = 0.0002123224431354016*c7;
    const panda_real t33 = t30*t32;
    const panda_real t34 = 0.32333777029991095*t31 - (t33 + 0.00213160409441986);
    const panda_real t35 = 0.0009653051699191118*s7 + 0.0012555365982729084*c7;
    const panda_real t36 = t31 + (0.32333777029991095*t33 - 0.0003913912816842475);
    const panda_real t37 = t34 + 0.006684151967360947;
    const panda_real t38 = s5*t20 + c5*t22;
    const panda_real t39 = t38 + (4.654545454545454*neg_lam5_23 + 1.0666666666666667*lam6_31);
    const panda_real t40 = t32 - 0.00016784129658960374*s7;
    const panda_real t41 = t14*t29 - (t34*neg_lam6_13 - (t35*lam6_12 - (t36*t12 - lam6_31*t37))) +
        t39*t40;
    const panda_real t42 = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_z = t41 - lam6_32*t42;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_23 = t6 + neg_w5_y*w6_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_12 = neg_ww5_xy - alpha4_y;
    const panda_real t43 = -2.0*w7_z;
    const panda_real t44 = w6_x*t43 - lam6_12;
    const panda_real t45 = s6*t24 + c6*t27;
    const panda_real t46 = t45 - 1.0666666666666667*lam6_21;
    const panda_real t47 = lam6_32 - w6_z*t43;
    const panda_real t48 = t14*t47 - (0.014338888209442497*neg_lam6_22 - 0.017931959153753906*t46 +
        t44*t40);
    const panda_real t49 = 0.0001037589172186853*lam6_23 - (t42*t11 + (t46*t40 - (t36*t47 -
        (1.0666666666666667*t48 + 0.014338888209442497*t29))));
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_z = t44*t37 - (0.0005462437073966822*(neg_lam6_22 - neg_lam6_11) +
        (0.028934422545659907*lam6_12 - (0.0011196707334275547*lam6_21 + t49))) - neg_lam6_13*(t35 +
        9.35690973146064e-05);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_32 = ww4_yz - neg_alpha4_x;
    const panda_real t50 = 0.028934422545659907*lam6_32 - (0.014338888209442497*t39 + (t35*t9 +
        (9.35690973146064e-05*t8 + (0.0055993270925625*t45 + 0.0001037589172186853*lam6_21))));
    const panda_real t51 = t34*t47 - (t36*t44 + (t14*t46 + t50)) + lam6_31*(t42 -
        0.0005462437073966822);
    const panda_real t52 = neg_lam5_22 + lam5_11;
    const panda_real t53 = 0.017931959153753906*t39 + (lam6_31*t40 - (0.014338888209442497*lam6_32 +
        t14*(t10 - t12)));
    const panda_real t54 = 0.0055993270925625*neg_lam5_22 + t53;
    const panda_real t55 = 0.0005462437073966822*lam6_32 + nc7_z + (9.35690973146064e-05*lam6_12 +
        0.0001037589172186853*t12 + 1.0666666666666667*(t53 + 0.005249369149277343*t28));
    const panda_real t56 = t55 + 0.0011196707334275547*lam6_31;
    const panda_real t57 = 0.010045187828321245*neg_lam5_32 + c6*t51 - 0.00151524447332703*lam5_31 -
        0.0021640520520981327*(t7 - t52) - (4.654545454545454*t54 + s6*t56);
    const panda_real t58 = 0.0010267877770288932*neg_lam5_21 + t57;
    const panda_real t59 = 0.017931959153753906*t29 + (0.014338888209442497*lam6_12 + t40*t10) +
        neg_lam6_13*(t14 - 0.0055993270925625);
    const panda_real t60 = t48 + 0.0055993270925625*lam6_23;
    const panda_real t61 = c6*t59 - s6*t60;
    const panda_real t62 = 0.0010267877770288932*t7 + (0.001208932934385*t26 + 4.654545454545454*t61
        - (0.00151524447332703*neg_lam5_32 + (0.0021640520520981327*neg_lam5_12 - n6_z)));
    const panda_real t63 = 0.001451156065026714*lam5_31 + t62;
    const panda_real t64 = neg_lam4_22 + lam3_22;
    const panda_real t65 = 0.0039053550262761055*lam4_21 - c5*t58 + 0.07937575371526083*lam4_31 +
        (s5*t63 - (0.08256807420204747*t21 - 0.00164448757736928*t64));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = 0.30879988491513166*lam4_32 - t65;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_23 = ww4_yz + neg_alpha4_x;
    const panda_real lam4_13 = ww4_zx + alpha4_y;
    const panda_real lam4_12 = ww4_xy + alpha3_y;
    const panda_real t66 = 0.0010267877770288932*neg_lam5_23 + 0.0021640520520981327*lam5_13 -
        (c6*t56 + s6*t51) - (0.001451156065026714*neg_lam5_21 - 0.010045187828321245*neg_lam5_12);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_z = t66 - (0.00151524447332703*t52 - 0.001208932934385*t38);
    const panda_real t67 = 0.022178148964878252*lam4_23 - n4_x;
    const panda_real t68 = t61 - (0.02767241350487109*t23 - 0.001208932934385*lam5_11);
    const panda_real t69 = t54 - (0.001208932934385*neg_lam5_21 - 0.02767241350487109*t38);
    const panda_real t70 = s5*t68 + c5*t69;
    const panda_real t71 = 0.02759391246306875*lam4_13 - 0.00164448757736928*lam4_12 - t70 - n5_z -
        (0.010831526996380998*ww4_zx + (0.0039053550262761055*t3 - 0.07937575371526083*lam4_32));
    const panda_real t72 = t70 - (0.08256807420204747*lam4_32 + 0.016011409030815008*t21);
    const panda_real t73 = c4*t71 - 0.0001219124209507298*(neg_lam3_11 + lam3_22) -
        (0.005487648106562251*lam3_23 + (0.002328735327434986*t17 + 1.3360662912304e-05*neg_lam3_21
        - t72));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_z = 0.013297019103287523*neg_lam3_13 + (s4*t67 - t73);
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_12 = neg_ww2_zx - neg_ww3_xy;
    const panda_real t74 = 0.001208932934385*lam5_31 + (s6*t59 + 0.02767241350487109*t26 + c6*t60);
    const panda_real t75 = 0.0039053550262761055*lam4_23 + c5*t63 - (0.30879988491513166*lam4_12 -
        (0.00164448757736928*lam4_13 - 0.07937575371526083*(t3 - t64) +
        0.005415763498190499*lam4_21));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_z = t74 + (s5*t58 - 0.08256807420204747*t19) + t75;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_32 = ww3_yz + alpha3_x;
    const panda_real t76 = t1 - (qd[0] - t1);
    const panda_real t77 = 3.83030303030303*t72 + (s4*t71 + c4*t67) - (0.10510540975539216*lam3_23 -
        (0.27690780075317833*c2 - (0.013297019103287523*t2 - 0.005487648106562251*neg_lam3_21 +
        0.0001219124209507298*neg_lam3_31)));
    const panda_real t78 = 0.016011409030815008*t19 + 0.08256807420204747*lam4_12 - (c5*t68 -
        s5*t69);
    const panda_real t79 = 0.08256807420204747*neg_lam4_22 + (t74 - 0.016011409030815008*t25);
    const panda_real t80 = s4*t78 - c4*t79 - 3.83030303030303*(c4*t78 + s4*t79) -
        0.013297019103287523*lam3_12;
    const panda_real t81 = t80 + (n4_z + (0.005487648106562251*(0.0024346792383292625*neg_lam3_31 +
        (neg_lam3_11 - neg_lam2_22)) + (0.0001219124209507298*lam3_32 +
        0.10510540975539216*neg_lam3_13)));
    const panda_real t82 = ww2_zz*(0.010261101821008168*c2 - 0.0007689361029464017*s2) - c2*n3_z +
        s2*(c3*t77 + s3*t81);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const panda_real n1_z = 0.007966717767871044*qd[1]*t76 - t82;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real n2_z = -c3*t81 - (t76*(0.003983358883935522*qd[0]) - s3*t77 +
        (4.746153896127808*s2 - 0.01993386669246*c2));
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 170 multiplications, 163 additions = 333; 2 unary minus; 12 sine/cosine */
void panda_mass_matrix(const panda_real q[7], panda_real M[49])
{
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    const panda_real s2 = sin(q[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(q[2]);
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(q[3]);
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(q[4]);
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(q[5]);
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(q[6]);
    const panda_real t1 = 0.000179030716362244*(s7 - 1.2650190832031087*c7);
    const panda_real t2 = 5.270530539521458*t1;
    const panda_real t3 = 0.002420943778521227*c7;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real k7_yz = 1.0230167595416089*(t2 + t3);
    const panda_real t4 = k7_yz + 9.35690973146064e-05;
    const panda_real t5 = t2 + 0.0006089563838965577*s7;
    const panda_real t6 = 0.1367578289558041*(t3 + t5);
    const panda_real t7 = c7*t3;
    const panda_real t8 = s7*t3;
    const panda_real t9 = 1.0666666666666667*t6 - (0.32333777029991095*t7 - 0.0004951501989029328 +
        t8);
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real neg_k6_yz = c6*t4 - s6*t9;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real neg_k7_xz = 0.8086967012001633*t5;
    const panda_real t10 = neg_k6_yz - 0.0021640520520981327;
    const panda_real t11 = c6*c6;
    const panda_real t12 = neg_k7_xz - (0.029497140765350628 - neg_k7_xz);
    const panda_real t13 = c6*s6;
    const panda_real t14 = 0.32333777029991095*t8 - (t7 + 0.009543771269492213);
    const panda_real t15 = 0.006684151967360947 - t1;
    const panda_real t16 = t1 - t14 - t15;
    const panda_real t17 = (t11 - 0.5)*t12 - (t13*t16 - 0.004600245517563107);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xz = s5*t10 - c5*t17;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xz = c6*t9 + s6*t4;
    const panda_real t18 = c5*s5;
    const panda_real t19 = k6_xz + (k6_xz - 0.00303048894665406);
    const panda_real t20 = c5*c5;
    const panda_real t21 = t14 - 0.0026330206532488923;
    const panda_real t22 = t12*t13 + 0.6173375163284962 + t11*t16;
    const panda_real t23 = 0.6477230949391829 - t22;
    const panda_real t24 = t21 + t23;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_yy = t18*t19 + (t20*t24 - t23);
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t23 - t21;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = 0.057868845091319815 - t16;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_yz = c5*t10 + s5*t17;
    const panda_real t25 = 0.9375*t1;
    const panda_real t26 = t25 - 0.0191274230973375;
    const panda_real t27 = 0.014338888209442497*s6 - c6*t26;
    const panda_real t28 = t27 - 0.001208932934385;
    const panda_real t29 = t6 - 0.0055993270925625;
    const panda_real t30 = s5*t28 - c5*t29;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = neg_k5_yz + 4.654545454545454*t30;
    const panda_real t31 = m4_5 - 0.00164448757736928;
    const panda_real t32 = t18*t24 - (t30 - (t19*(0.5 - t20) + 0.0039053550262761055));
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xz = s4*t31 - c4*t32;
    const panda_real t33 = 0.014338888209442497*c6 + s6*t26;
    const panda_real t34 = 4.654545454545454*t33;
    const panda_real t35 = t34 - m6_6;
    const panda_real t36 = t34 - (t22 - t35);
    const panda_real t37 = s5*t29 + c5*t28;
    const panda_real t38 = t37 - m5_5;
    const panda_real t39 = t37 + (t38 - neg_k5_yy);
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = 0.10204027231363098 - t36 - t39;
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real neg_k4_yz = s4*t32 + c4*t31;
    const panda_real t40 = 0.022178148964878252 - neg_k5_yy;
    const panda_real t41 = t33 - 0.16284087268546082;
    const panda_real t42 = t41 - 0.0031923204867866503;
    const panda_real t43 = t37 - 0.04560437265862499;
    const panda_real t44 = c4*t42 - s4*t43;
    const panda_real t45 = 3.83030303030303*t44;
    const panda_real t46 = c4*s4;
    const panda_real t47 = 4.654545454545454*t37 - k5_xz;
    const panda_real t48 = t41 + t47;
    const panda_real t49 = t45 - t46*t48;
    const panda_real t50 = c4*c4;
    const panda_real t51 = t36 - t39;
    const panda_real t52 = t49 - 1.0831821973886961 + (t39 + (t49 + t50*t51));
    const panda_real t53 = s4*t42 + c4*t43;
    const panda_real t54 = t45 - t53;
    const panda_real t55 = t54 - m4_4;
    const panda_real t56 = t52 - (t54 - 1.0937644822584085 + t55);
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = t40 + t56;
    const panda_real t57 = t30 + 0.0023287353274349695;
    const panda_real t58 = k4_xz - (t57 - 0.00220682290648424);
    const panda_real t59 = 2.0*(s3*t58) + c3*(t56 - t40);
    const panda_real t60 = c3*t59 + 0.04525603145981006 - neg_k5_yy;
    const panda_real t61 = t52 + t60;
    const panda_real t62 = t53 + 0.06161578168943999;
    const panda_real t63 = t44 + (t48 - 0.005487648106562261) - (t46*t51 + t50*(2.0*t48));
    const panda_real t64 = neg_k4_yz + 0.004377257121839638;
    const panda_real t65 = s2*(3.83030303030303*(c3*t62 - s3*t57) - (c3*t63 + s3*t64));
    const panda_real t66 = c2*(0.003983358883935522*s2 - t65);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = c2*(c2*t61) + 0.03733744848940618 - (t66 + (t66 - m3_3)) - t61;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_3 = s3*t63 - c3*t64 - 3.83030303030303*(s3*t62 + c3*t57);
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real neg_k2_yz = s2*(s3*t59 - (t58 + 0.010261101821008168)) -
        c2*(0.0007689361029464017 - m2_3);
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = t65 + c2*m3_3;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_5 = t37 - c4*t38 - s4*t47;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = s4*t38 - c4*t47;
    const panda_real t67 = s5*t33;
    const panda_real t68 = c5*k6_xz + s5*t35;
    const panda_real t69 = neg_k6_yz - t67;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = t67 - s4*t68 + c4*t69;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_6 = s5*k6_xz - t27 - c5*t35;
    const panda_real t70 = c5*t33;
    const panda_real t71 = c4*t27 + (m4_6 + s4*t70);
    const panda_real t72 = c4*t68 + s4*t69;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s3*t71 - c3*t72;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = s6*t15 + c6*neg_k7_xz;
    const panda_real nu6_y = s6*neg_k7_xz - c6*t15;
    const panda_real t73 = c6*t6;
    const panda_real t74 = c5*t25 - s5*t73;
    const panda_real t75 = nu6_y - t74;
    const panda_real t76 = s5*k7_yz + (4.654545454545454*t74 - c5*nu6_x);
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_y = c4*t75 - s4*t76;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = t74 + nu4_y;
    const panda_real t77 = s6*t6;
    const panda_real t78 = s5*t25 + c5*t73;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_7 = t77 - c5*k7_yz + 4.654545454545454*t78 - s5*nu6_x;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = t60 - t52;
    const panda_real m2_4 = c3*t55 - s3*k4_xz;
    const panda_real t79 = m4_5 - s4*t30;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_y = s3*nu4_x - c3*t79;
    const panda_real t80 = c4*t30;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = nu3_y - 3.83030303030303*(c3*t80 + s3*t37);
    const panda_real t81 = s4*t27 - c4*t70;
    const panda_real m2_6 = -s3*t72 - c3*t71 - 3.83030303030303*(c3*t81 + s3*t67);
    const panda_real t82 = s4*t78 - (m4_7 - c4*t77);
    const panda_real t83 = c4*t76 + s4*t75;
    const panda_real t84 = c4*t78 - s4*t77;
    const panda_real m2_7 = c3*t82 - (s3*t83 + 3.83030303030303*(c3*t84 + s3*t74));
    const panda_real t85 = c2*neg_k4_yz + s2*(c3*k4_xz + s3*t55);
    const panda_real t86 = c2*m3_5 + s2*(3.83030303030303*(c3*t37 - s3*t80) - c3*nu4_x - s3*t79);
    const panda_real t87 = c2*m3_6 - s2*(nu3_x + 3.83030303030303*(s3*t81 - c3*t67));
    const panda_real t88 = c2*m3_7 + s2*(s3*t82 + (c3*t83 + 3.83030303030303*(c3*t74 - s3*t84)));
    const panda_real t89 = -k7_yz;
    M[0] = m1_1;
    M[1] = neg_k2_yz;
    M[2] = nu2_y;
    M[3] = t85;
    M[4] = t86;
    M[5] = t87;
    M[6] = t88;
    M[7] = neg_k2_yz;
    M[8] = m2_2;
    M[9] = m2_3;
    M[10] = m2_4;
    M[11] = m2_5;
    M[12] = m2_6;
    M[13] = m2_7;
    M[14] = nu2_y;
    M[15] = m2_3;
    M[16] = m3_3;
    M[17] = neg_k4_yz;
    M[18] = m3_5;
    M[19] = m3_6;
    M[20] = m3_7;
    M[21] = t85;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = t86;
    M[29] = m2_5;
    M[30] = m3_5;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = neg_k6_yz;
    M[34] = nu6_y;
    M[35] = t87;
    M[36] = m2_6;
    M[37] = m3_6;
    M[38] = m4_6;
    M[39] = neg_k6_yz;
    M[40] = m6_6;
    M[41] = t89;
    M[42] = t88;
    M[43] = m2_7;
    M[44] = m3_7;
    M[45] = m4_7;
    M[46] = nu6_y;
    M[47] = t89;
    M[48] = 0.006684151967360947;
}

/* accelerations that the torques tau give
 * 553 multiplications, 511 additions, 6 divisions = 1070; 1 unary minus; 12 sine/cosine */
void panda_forward_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real tau[7],
    panda_real qdd[7])
{
    /* sines and cosines of the joint angles */
    const panda_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const panda_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const panda_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const panda_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real neg_ww2_yz = neg_w2_y*qd[1];
    /* sines and cosines of the joint angles */
    const panda_real c3 = cos(q[2]);
    const panda_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const panda_real neg_w3_x = neg_w2_x*c3 - qd[1]*s3;
    const panda_real w3_z = neg_w2_y + qd[2];
    const panda_real w3_y = qd[1]*c3 + neg_w2_x*s3;
    /* link 3: products of the angular velocity [1/s^2] */
    const panda_real ww3_yy = w3_y*w3_y;
    const panda_real ww3_zz = w3_z*w3_z;
    const panda_real neg_ww3_zx = neg_w3_x*w3_z;
    const panda_real neg_ww3_xy = neg_w3_x*w3_y;
    const panda_real ww3_yz = w3_z*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const panda_real c4 = cos(q[3]);
    const panda_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const panda_real neg_w4_x = w3_z*s4 - neg_w3_x*c4;
    const panda_real neg_w4_z = w3_y - qd[3];
    const panda_real neg_w4_y = neg_w3_x*s4 + w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const panda_real ww4_zz = neg_w4_z*neg_w4_z;
    const panda_real ww4_zx = neg_w4_x*neg_w4_z;
    const panda_real ww4_xy = neg_w4_x*neg_w4_y;
    const panda_real ww4_xx = neg_w4_x*neg_w4_x;
    const panda_real ww4_yz = neg_w4_z*neg_w4_y;
    /* sines and cosines of the joint angles */
    const panda_real c5 = cos(q[4]);
    const panda_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const panda_real w5_x = neg_w4_x*c5 + neg_w4_z*s5;
    const panda_real w5_z = neg_w4_y + qd[4];
    const panda_real neg_w5_y = neg_w4_x*s5 - neg_w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const panda_real neg_ww5_yz = w5_z*neg_w5_y;
    const panda_real ww5_zx = w5_x*w5_z;
    const panda_real neg_ww5_xy = w5_x*neg_w5_y;
    const panda_real ww5_xx = w5_x*w5_x;
    const panda_real ww5_zz = w5_z*w5_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_22 = ww4_zz + ww4_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const panda_real c6 = cos(q[5]);
    const panda_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const panda_real w6_x = w5_x*c6 + w5_z*s6;
    const panda_real w6_z = neg_w5_y + qd[5];
    const panda_real w6_y = w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const panda_real ww6_zz = w6_z*w6_z;
    const panda_real ww6_xy = w6_x*w6_y;
    const panda_real ww6_yy = w6_y*w6_y;
    /* link 7: angular velocity [rad/s] */
    const panda_real w7_z = qd[6] - w6_y;
    /* sines and cosines of the joint angles */
    const panda_real c7 = cos(q[6]);
    const panda_real s7 = sin(q[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_y = neg_ww2_yz*s3 + neg_w3_x*qd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_13 = neg_ww3_zx - alpha3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_21 = ww4_xy - alpha3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const panda_real alpha3_x = qd[2]*w3_y - neg_ww2_yz*c3;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real neg_ww2_zx = neg_w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real alpha4_y = s4*alpha3_x + (neg_w4_x*qd[3] + c4*neg_ww2_zx);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_21 = neg_ww5_xy + alpha4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const panda_real neg_alpha4_x = qd[3]*neg_w4_y + (c4*alpha3_x - s4*neg_ww2_zx);
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real neg_alpha5_x = qd[4]*neg_w5_y - s5*alpha3_y - c5*neg_alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_32 = neg_ww5_yz + neg_alpha5_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const panda_real t1 = s2*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const panda_real ww2_xx = qd[0]*t1;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam2_22 = ww2_zz + ww2_xx;
    const panda_real t2 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_22 = t2 - neg_lam2_22;
    const panda_real t3 = ww4_zz - ww4_xx;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam4_11 = t3 - lam3_22;
    const panda_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_23 = ww3_yz - alpha3_x;
    const panda_real neg_lam3_21 = neg_ww3_xy + neg_ww2_zx;
    /* link 5: angular acceleration [rad/s^2] */
    const panda_real alpha5_y = c5*alpha3_y - (w5_x*qd[4] + s5*neg_alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_13 = ww5_zx + alpha5_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_21 = ww6_xy - alpha5_y;
    const panda_real t4 = qd[5] + w6_z;
    const panda_real t5 = c6*alpha4_y - s6*neg_alpha5_x;
    const panda_real lam6_31 = w6_x*t4 + t5;
    /* link 7: products of the angular velocity [1/s^2] */
    const panda_real ww7_zz = w7_z*w7_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_23 = neg_ww5_yz - neg_alpha5_x;
    const panda_real t6 = s6*alpha4_y + c6*neg_alpha5_x;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_32 = w6_y*t4 - t6;
    const panda_real lam6_12 = ww6_xy + alpha5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam5_31 = ww5_zx - alpha5_y;
    const panda_real t7 = ww5_xx - ww5_zz;
    const panda_real lam5_11 = t7 - neg_lam4_22;
    const panda_real t8 = ww6_zz - ww6_yy;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam6_22 = neg_lam5_22 + t8;
    const panda_real t9 = ww6_zz - ww7_zz;
    const panda_real t10 = ww6_zz + ww7_zz;
    const panda_real t11 = neg_lam6_22 - t10;
    const panda_real t12 = t9 - t11;
    const panda_real neg_lam6_11 = neg_lam5_22 + t12;
    const panda_real neg_lam6_13 = t5 - neg_w5_y*w6_x;
    const panda_real t13 = 0.0002123224431354016*s7;
    const panda_real t14 = t13 + 0.00016784129658960374*c7;
    const panda_real t15 = neg_lam3_31 - 118.9090909090909*c2 + 3.83030303030303*neg_lam2_22;
    const panda_real t16 = 118.9090909090909*s2;
    const panda_real t17 = c3*t16;
    const panda_real t18 = neg_lam3_11 + t17 + 3.83030303030303*neg_lam3_13;
    const panda_real t19 = s4*t15 + c4*t18;
    const panda_real t20 = neg_lam4_11 - t19;
    const panda_real t21 = 3.83030303030303*lam3_23 - (neg_lam3_21 - s3*t16);
    const panda_real t22 = lam4_31 - t21;
    const panda_real t23 = c5*t20 - s5*t22;
    const panda_real t24 = t23 + 4.654545454545454*lam5_13;
    const panda_real t25 = s4*t18 - c4*t15;
    const panda_real t26 = lam4_21 - t25;
    const panda_real t27 = 4.654545454545454*neg_lam4_22 + t26;
    const panda_real t28 = c6*t24 - s6*t27;
    const panda_real t29 = 1.0666666666666667*neg_lam6_11 - t28;
    const panda_real t30 = 11.402203849817942*c7;
    const panda_real t31 = t13*t30;
    const panda_real t32 = 0.0002123224431354016*c7;
    const panda_real t33 = t30*t32;
    const panda_real t34 = 0.32333777029991095*t31 - (t33 + 0.00213160409441986);
    const panda_real t35 = 0.0009653051699191118*s7 + 0.0012555365982729084*c7;
    const panda_real t36 = t31 + (0.32333777029991095*t33 - 0.0003913912816842475);
    const panda_real t37 = t34 + 0.006684151967360947;
    const panda_real t38 = s5*t20 + c5*t22;
    const panda_real t39 = t38 + (4.654545454545454*neg_lam5_23 + 1.0666666666666667*lam6_31);
    const panda_real t40 = t32 - 0.00016784129658960374*s7;
    const panda_real t41 = t14*t29 - (neg_lam6_13*t34 - (lam6_12*t35 - (t12*t36 - lam6_31*t37))) +
        t39*t40;
    const panda_real t42 = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    /* link 7: moment that turns the link [N m] */
    const panda_real nc7_z = t41 - lam6_32*t42;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_23 = t6 + neg_w5_y*w6_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_12 = neg_ww5_xy - alpha4_y;
    const panda_real t43 = -2.0*w7_z;
    const panda_real t44 = lam6_12 - w6_x*t43;
    const panda_real t45 = s6*t24 + c6*t27;
    const panda_real t46 = t45 - 1.0666666666666667*lam6_21;
    const panda_real t47 = lam6_32 - w6_z*t43;
    const panda_real t48 = t14*t47 - (0.014338888209442497*neg_lam6_22 - 0.017931959153753906*t46 -
        t40*t44);
    const panda_real t49 = 0.0001037589172186853*lam6_23 + (t11*t42 - (t40*t46 - (t36*t47 -
        (1.0666666666666667*t48 + 0.014338888209442497*t29))));
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real neg_n6_z = t37*t44 + (0.0005462437073966822*(neg_lam6_22 - neg_lam6_11) +
        (0.028934422545659907*lam6_12 - (0.0011196707334275547*lam6_21 + t49))) + neg_lam6_13*(t35 +
        9.35690973146064e-05);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_32 = ww4_yz - neg_alpha4_x;
    const panda_real t50 = 0.028934422545659907*lam6_32 - (0.014338888209442497*t39 + (t9*t35 +
        (9.35690973146064e-05*t8 + (0.0055993270925625*t45 + 0.0001037589172186853*lam6_21))));
    const panda_real t51 = t34*t47 + (t36*t44 - (t14*t46 + t50)) + lam6_31*(t42 -
        0.0005462437073966822);
    const panda_real t52 = neg_lam5_22 + lam5_11;
    const panda_real t53 = 0.017931959153753906*t39 + (lam6_31*t40 - (0.014338888209442497*lam6_32 +
        t14*(t10 - t12)));
    const panda_real t54 = 0.0055993270925625*neg_lam5_22 + t53;
    const panda_real t55 = nc7_z + 0.0005462437073966822*lam6_32 + (9.35690973146064e-05*lam6_12 +
        0.0001037589172186853*t12 + 1.0666666666666667*(t53 + 0.005249369149277343*t28));
    const panda_real t56 = t55 + 0.0011196707334275547*lam6_31;
    const panda_real t57 = 0.010045187828321245*neg_lam5_32 + c6*t51 - 0.00151524447332703*lam5_31 -
        0.0021640520520981327*(t7 - t52) - (4.654545454545454*t54 + s6*t56);
    const panda_real t58 = 0.0010267877770288932*neg_lam5_21 + t57;
    const panda_real t59 = 0.017931959153753906*t29 + (0.014338888209442497*lam6_12 + t10*t40) +
        neg_lam6_13*(t14 - 0.0055993270925625);
    const panda_real t60 = t48 + 0.0055993270925625*lam6_23;
    const panda_real t61 = c6*t59 - s6*t60;
    const panda_real t62 = 0.0010267877770288932*t7 + (0.001208932934385*t26 + 4.654545454545454*t61
        - (0.00151524447332703*neg_lam5_32 + (neg_n6_z + 0.0021640520520981327*neg_lam5_12)));
    const panda_real t63 = 0.001451156065026714*lam5_31 + t62;
    const panda_real t64 = neg_lam4_22 + lam3_22;
    const panda_real t65 = 0.0039053550262761055*lam4_21 - c5*t58 + 0.07937575371526083*lam4_31 +
        (s5*t63 - (0.08256807420204747*t21 - 0.00164448757736928*t64));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = 0.30879988491513166*lam4_32 - t65;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_23 = ww4_yz + neg_alpha4_x;
    const panda_real lam4_13 = ww4_zx + alpha4_y;
    const panda_real lam4_12 = ww4_xy + alpha3_y;
    const panda_real t66 = 0.0010267877770288932*neg_lam5_23 + 0.0021640520520981327*lam5_13 -
        (c6*t56 + s6*t51) - (0.001451156065026714*neg_lam5_21 - 0.010045187828321245*neg_lam5_12);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_z = t66 - (0.00151524447332703*t52 - 0.001208932934385*t38);
    const panda_real t67 = n4_x - 0.022178148964878252*lam4_23;
    const panda_real t68 = t61 - (0.02767241350487109*t23 - 0.001208932934385*lam5_11);
    const panda_real t69 = t54 - (0.001208932934385*neg_lam5_21 - 0.02767241350487109*t38);
    const panda_real t70 = s5*t68 + c5*t69;
    const panda_real t71 = n5_z - (0.02759391246306875*lam4_13 - 0.00164448757736928*lam4_12 - t70)
        + (0.010831526996380998*ww4_zx + (0.0039053550262761055*t3 - 0.07937575371526083*lam4_32));
    const panda_real t72 = t70 - (0.08256807420204747*lam4_32 + 0.016011409030815008*t21);
    const panda_real t73 = c4*t71 + 0.0001219124209507298*(neg_lam3_11 + lam3_22) +
        (0.005487648106562251*lam3_23 + (0.002328735327434986*t17 + 1.3360662912304e-05*neg_lam3_21
        - t72));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_z = 0.013297019103287523*neg_lam3_13 - (s4*t67 - t73);
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_12 = neg_ww2_zx - neg_ww3_xy;
    const panda_real t74 = 0.001208932934385*lam5_31 + (s6*t59 + 0.02767241350487109*t26 + c6*t60);
    const panda_real t75 = 0.0039053550262761055*lam4_23 + c5*t63 - (0.30879988491513166*lam4_12 -
        (0.00164448757736928*lam4_13 - 0.07937575371526083*(t3 - t64) +
        0.005415763498190499*lam4_21));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_z = t74 + (s5*t58 + 0.08256807420204747*t19) + t75;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_32 = ww3_yz + alpha3_x;
    const panda_real t76 = t1 - (qd[0] - t1);
    const panda_real t77 = 3.83030303030303*t72 - (s4*t71 + c4*t67) - (0.10510540975539216*lam3_23 -
        (0.27690780075317833*c2 - (0.013297019103287523*t2 - 0.005487648106562251*neg_lam3_21 +
        0.0001219124209507298*neg_lam3_31)));
    const panda_real t78 = 0.016011409030815008*t19 - 0.08256807420204747*lam4_12 + (c5*t68 -
        s5*t69);
    const panda_real t79 = 0.08256807420204747*neg_lam4_22 + (t74 - 0.016011409030815008*t25);
    const panda_real t80 = s4*t78 + c4*t79 - 3.83030303030303*(c4*t78 - s4*t79) +
        0.013297019103287523*lam3_12;
    const panda_real t81 = t80 - (n4_z + (0.005487648106562251*(0.0024346792383292625*neg_lam3_31 +
        (neg_lam3_11 - neg_lam2_22)) + (0.0001219124209507298*lam3_32 +
        0.10510540975539216*neg_lam3_13)));
    const panda_real t82 = ww2_zz*(0.010261101821008168*c2 - 0.0007689361029464017*s2) - c2*n3_z +
        s2*(c3*t77 - s3*t81);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const panda_real n1_z = 0.007966717767871044*qd[1]*t76 - t82;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real n2_z = c3*t81 - (t76*(0.003983358883935522*qd[0]) - s3*t77 +
        (4.746153896127808*s2 - 0.01993386669246*c2));
    const panda_real t83 = s7 - 1.2650190832031087*c7;
    const panda_real t84 = 0.0009435868580996108*t83;
    const panda_real t85 = 0.002420943778521227*c7;
    const panda_real t86 = t84 + t85;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real k7_yz = 1.0230167595416089*t86;
    const panda_real t87 = 9.35690973146064e-05 + k7_yz;
    const panda_real t88 = t84 + 0.0006089563838965577*s7;
    const panda_real t89 = t85 + t88;
    const panda_real t90 = c7*t85;
    const panda_real t91 = s7*t85;
    const panda_real t92 = 0.1458750175528577*t89 - (0.32333777029991095*t90 - 0.0004951501989029328
        + t91);
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real neg_k6_yz = c6*t87 - s6*t92;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real neg_k7_xz = 0.8086967012001633*t88;
    const panda_real t93 = neg_k6_yz - 0.0021640520520981327;
    const panda_real t94 = c6*c6;
    const panda_real t95 = neg_k7_xz + (neg_k7_xz - 0.029497140765350628);
    const panda_real t96 = c6*s6;
    const panda_real t97 = 0.000179030716362244*t83;
    const panda_real t98 = 0.32333777029991095*t91 - (t90 + 0.009543771269492213);
    const panda_real t99 = 0.006684151967360947 - t97;
    const panda_real t100 = t97 - t98 - t99;
    const panda_real t101 = (t94 - 0.5)*t95 - (t96*t100 - 0.004600245517563107);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_xz = s5*t93 - c5*t101;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xz = c6*t92 + s6*t87;
    const panda_real t102 = c5*s5;
    const panda_real t103 = k6_xz + (k6_xz - 0.00303048894665406);
    const panda_real t104 = t95*t96 + 0.6173375163284962 + t94*t100;
    const panda_real t105 = c5*c5;
    const panda_real t106 = t98 - t104 + 0.645090074285934;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_yy = t102*t103 + (t104 - 0.6477230949391829 + t105*t106);
    /* link 5: mass matrix, its row of this joint */
    const panda_real neg_m5_5 = t98 + t104 - 0.6503561155924318;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = 0.057868845091319815 - t100;
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_yz = c5*t93 + s5*t101;
    const panda_real t107 = 0.00016784129658960374*t83;
    const panda_real t108 = t107 - 0.0191274230973375;
    const panda_real t109 = 0.014338888209442497*s6 - c6*t108;
    const panda_real t110 = t109 - 0.001208932934385;
    const panda_real t111 = 0.1367578289558041*t89;
    const panda_real t112 = 0.0055993270925625 - t111;
    const panda_real t113 = s5*t110 + c5*t112;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = neg_k5_yz + 4.654545454545454*t113;
    const panda_real t114 = m4_5 - 0.00164448757736928;
    const panda_real t115 = t102*t106 - (t113 - (t103*(0.5 - t105) + 0.0039053550262761055));
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real k4_xz = s4*t114 - c4*t115;
    const panda_real t116 = s5*t112 - c5*t110;
    const panda_real t117 = neg_m5_5 - t116;
    const panda_real t118 = t116 + (neg_k5_yy - t117);
    const panda_real t119 = 0.014338888209442497*c6 + s6*t108;
    const panda_real t120 = 4.654545454545454*t119;
    const panda_real t121 = t120 - m6_6;
    const panda_real t122 = t120 - (t104 - t121);
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t118 - (t122 - 0.10204027231363098);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real neg_k4_yz = s4*t115 + c4*t114;
    const panda_real t123 = neg_k5_yy - 0.022178148964878252;
    const panda_real t124 = t119 - 0.16603319317224746;
    const panda_real t125 = t116 + 0.04560437265862499;
    const panda_real t126 = c4*t124 + s4*t125;
    const panda_real t127 = 3.83030303030303*t126;
    const panda_real t128 = c4*s4;
    const panda_real t129 = k5_xz + 4.654545454545454*t116;
    const panda_real t130 = t119 - 0.16284087268546082 - t129;
    const panda_real t131 = t127 - t128*t130;
    const panda_real t132 = c4*c4;
    const panda_real t133 = t122 + t118;
    const panda_real t134 = t131 - 1.0831821973886961 - (t118 - (t131 + t132*t133));
    const panda_real t135 = s4*t124 - c4*t125;
    const panda_real t136 = t127 - t135;
    const panda_real t137 = t136 - m4_4;
    const panda_real t138 = t134 - (t136 - 1.0937644822584085 + t137);
    /* link 3: mass matrix, its row of this joint */
    const panda_real neg_m3_3 = t123 - t138;
    const panda_real t139 = k4_xz - (t113 + 0.0001219124209507298);
    const panda_real t140 = 2.0*(s3*t139) + c3*(t123 + t138);
    const panda_real t141 = neg_k5_yy - (c3*t140 + 0.04525603145981006);
    const panda_real t142 = t134 - t141;
    const panda_real t143 = t135 + 0.06161578168943999;
    const panda_real t144 = t113 + 0.0023287353274349695;
    const panda_real t145 = t126 + (t130 - 0.005487648106562261) - (t128*t133 + t132*(2.0*t130));
    const panda_real t146 = neg_k4_yz + 0.004377257121839638;
    const panda_real t147 = s2*(3.83030303030303*(c3*t143 - s3*t144) - (c3*t145 + s3*t146));
    const panda_real t148 = c2*(0.003983358883935522*s2 - t147);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = c2*(c2*t142) + 0.03733744848940618 - (t148 + (neg_m3_3 + t148)) - t142;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_3 = s3*t145 - c3*t146 - 3.83030303030303*(s3*t143 + c3*t144);
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real neg_k2_yz = s2*(s3*t140 - (t139 + 0.010261101821008168)) + c2*(m2_3 -
        0.0007689361029464017);
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = t147 - c2*neg_m3_3;
    /* link 3: mass matrix, its row of this joint */
    const panda_real neg_m3_5 = t116 + c4*t117 - s4*t129;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = s4*t117 + c4*t129;
    const panda_real t149 = s5*t119;
    const panda_real t150 = c5*k6_xz + s5*t121;
    const panda_real t151 = neg_k6_yz - t149;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = t149 - s4*t150 + c4*t151;
    /* link 4: mass matrix, its row of this joint */
    const panda_real neg_m4_6 = t109 - s5*k6_xz + c5*t121;
    const panda_real t152 = c5*t119;
    const panda_real t153 = c4*t109 - (neg_m4_6 - s4*t152);
    const panda_real t154 = c4*t150 + s4*t151;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s3*t153 - c3*t154;
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_x = s6*t99 + c6*neg_k7_xz;
    const panda_real nu6_y = s6*neg_k7_xz - c6*t99;
    const panda_real t155 = c6*t111;
    const panda_real t156 = c5*t107 - s5*t155;
    const panda_real t157 = nu6_y - t156;
    const panda_real t158 = s5*k7_yz + (4.654545454545454*t156 - c5*nu6_x);
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_y = c4*t157 - s4*t158;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = t156 + nu4_y;
    const panda_real t159 = s6*t111;
    const panda_real t160 = s5*t107 + c5*t155;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_7 = t159 - c5*k7_yz + 4.654545454545454*t160 - s5*nu6_x;
    /* link 2: mass matrix, its row of this joint */
    const panda_real neg_m2_2 = t134 + t141;
    const panda_real m2_4 = c3*t137 - s3*k4_xz;
    const panda_real t161 = m4_5 - s4*t113;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_y = s3*nu4_x - c3*t161;
    const panda_real t162 = c4*t113;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = nu3_y - 3.83030303030303*(c3*t162 - s3*t116);
    const panda_real t163 = s4*t109 - c4*t152;
    const panda_real neg_m2_6 = s3*t154 + c3*t153 + 3.83030303030303*(c3*t163 + s3*t149);
    const panda_real t164 = s4*t160 - (m4_7 - c4*t159);
    const panda_real t165 = c4*t158 + s4*t157;
    const panda_real t166 = c4*t160 - s4*t159;
    const panda_real m2_7 = c3*t164 - (s3*t165 + 3.83030303030303*(c3*t166 + s3*t156));
    /* factorisation M = U D U^T */
    const panda_real ud1_7 = c2*m3_7 + s2*(s3*t164 + (c3*t165 + 3.83030303030303*(c3*t156 -
        s3*t166)));
    /* link 7: forward substitution */
    const panda_real neg_y7 = nc7_z - tau[6];
    /* factorisation M = U D U^T */
    const panda_real neg_u6_7 = 153.05109227573695*t86;
    const panda_real u5_7 = 149.60760989322964*nu6_y;
    const panda_real u4_7 = 149.60760989322964*m4_7;
    const panda_real u3_7 = 149.60760989322964*m3_7;
    const panda_real u2_7 = 149.60760989322964*m2_7;
    const panda_real u1_7 = 149.60760989322964*ud1_7;
    const panda_real neg_pivot6 = k7_yz*neg_u6_7 - m6_6;
    const panda_real neg_ipivot6 = 1.0 / neg_pivot6;
    const panda_real ud5_6 = neg_k6_yz + k7_yz*u5_7;
    const panda_real neg_u5_6 = neg_ipivot6*ud5_6;
    const panda_real neg_ud4_6 = neg_m4_6 - k7_yz*u4_7;
    const panda_real u4_6 = neg_ipivot6*neg_ud4_6;
    const panda_real ud3_6 = m3_6 + k7_yz*u3_7;
    const panda_real neg_u3_6 = neg_ipivot6*ud3_6;
    const panda_real neg_ud2_6 = neg_m2_6 - k7_yz*u2_7;
    const panda_real u2_6 = neg_ipivot6*neg_ud2_6;
    const panda_real ud1_6 = c2*m3_6 - s2*(nu3_x + 3.83030303030303*(s3*t163 - c3*t149)) +
        k7_yz*u1_7;
    const panda_real neg_u1_6 = neg_ipivot6*ud1_6;
    const panda_real neg_pivot5 = neg_m5_5 + nu6_y*u5_7 - ud5_6*neg_u5_6;
    const panda_real neg_ipivot5 = 1.0 / neg_pivot5;
    const panda_real ud4_5 = m4_5 - nu6_y*u4_7 - ud5_6*u4_6;
    const panda_real neg_u4_5 = neg_ipivot5*ud4_5;
    const panda_real neg_ud3_5 = neg_m3_5 + nu6_y*u3_7 - ud5_6*neg_u3_6;
    const panda_real u3_5 = neg_ipivot5*neg_ud3_5;
    const panda_real ud2_5 = m2_5 - nu6_y*u2_7 - ud5_6*u2_6;
    const panda_real neg_u2_5 = neg_ipivot5*ud2_5;
    const panda_real t167 = c2*neg_m3_5 + s2*(3.83030303030303*(c3*t116 + s3*t162) + c3*nu4_x +
        s3*t161);
    const panda_real neg_ud1_5 = t167 + nu6_y*u1_7 - ud5_6*neg_u1_6;
    const panda_real u1_5 = neg_ipivot5*neg_ud1_5;
    const panda_real neg_pivot4 = m4_7*u4_7 - m4_4 - neg_ud4_6*u4_6 - ud4_5*neg_u4_5;
    const panda_real neg_ipivot4 = 1.0 / neg_pivot4;
    const panda_real ud3_4 = neg_k4_yz - m4_7*u3_7 - neg_ud4_6*neg_u3_6 - ud4_5*u3_5;
    const panda_real neg_u3_4 = neg_ipivot4*ud3_4;
    const panda_real ud2_4 = m2_4 - m4_7*u2_7 + neg_ud4_6*u2_6 + ud4_5*neg_u2_5;
    const panda_real neg_u2_4 = neg_ipivot4*ud2_4;
    const panda_real t168 = c2*neg_k4_yz + s2*(c3*k4_xz + s3*t137) - m4_7*u1_7 - neg_ud4_6*neg_u1_6;
    const panda_real ud1_4 = t168 - ud4_5*u1_5;
    const panda_real neg_u1_4 = neg_ipivot4*ud1_4;
    const panda_real neg_pivot3 = neg_m3_3 + m3_7*u3_7 - ud3_6*neg_u3_6 - neg_ud3_5*u3_5 -
        ud3_4*neg_u3_4;
    const panda_real neg_ipivot3 = 1.0 / neg_pivot3;
    const panda_real ud2_3 = m2_3 - m3_7*u2_7 - ud3_6*u2_6 - neg_ud3_5*neg_u2_5 + ud3_4*neg_u2_4;
    const panda_real neg_u2_3 = neg_ipivot3*ud2_3;
    const panda_real ud1_3 = nu2_y - m3_7*u1_7 + ud3_6*neg_u1_6 + neg_ud3_5*u1_5 + ud3_4*neg_u1_4;
    const panda_real neg_u1_3 = neg_ipivot3*ud1_3;
    const panda_real neg_pivot2 = neg_m2_2 + m2_7*u2_7 - neg_ud2_6*u2_6 - ud2_5*neg_u2_5 -
        ud2_4*neg_u2_4 - ud2_3*neg_u2_3;
    const panda_real neg_ipivot2 = 1.0 / neg_pivot2;
    const panda_real ud1_2 = neg_k2_yz - m2_7*u1_7 - neg_ud2_6*neg_u1_6 - ud2_5*u1_5 +
        ud2_4*neg_u1_4 + ud2_3*neg_u1_3;
    const panda_real neg_u1_2 = neg_ipivot2*ud1_2;
    const panda_real t169 = ud1_7*u1_7 - m1_1 - ud1_6*neg_u1_6 - neg_ud1_5*u1_5 - ud1_4*neg_u1_4 -
        ud1_3*neg_u1_3;
    const panda_real neg_pivot1 = t169 - ud1_2*neg_u1_2;
    const panda_real neg_ipivot1 = 1.0 / neg_pivot1;
    /* link 6: forward substitution */
    const panda_real y6 = neg_n6_z + tau[5] - neg_y7*neg_u6_7;
    /* link 5: forward substitution */
    const panda_real neg_y5 = n5_z - tau[4] - neg_y7*u5_7 - neg_u5_6*y6;
    /* link 4: forward substitution */
    const panda_real neg_y4 = n4_z - tau[3] - neg_y7*u4_7 + u4_6*y6 + neg_u4_5*neg_y5;
    /* link 3: forward substitution */
    const panda_real neg_y3 = n3_z - tau[2] - neg_y7*u3_7 - neg_u3_6*y6 - u3_5*neg_y5 +
        neg_u3_4*neg_y4;
    /* link 2: forward substitution */
    const panda_real neg_y2 = n2_z - tau[1] - neg_y7*u2_7 + u2_6*y6 + neg_u2_5*neg_y5 +
        neg_u2_4*neg_y4 + neg_u2_3*neg_y3;
    const panda_real t170 = n1_z - tau[0] - neg_y7*u1_7 - neg_u1_6*y6 - u1_5*neg_y5 +
        neg_u1_4*neg_y4 + neg_u1_3*neg_y3;
    /* link 1: forward substitution */
    const panda_real neg_y1 = t170 + neg_u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd1 = neg_ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd2 = neg_ipivot2*neg_y2 + neg_u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd3 = neg_ipivot3*neg_y3 + neg_u2_3*qdd2 + neg_u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd4 = neg_ipivot4*neg_y4 + neg_u3_4*qdd3 + neg_u2_4*qdd2 + neg_u1_4*qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd5 = neg_ipivot5*neg_y5 + neg_u4_5*qdd4 - u3_5*qdd3 + neg_u2_5*qdd2 -
        u1_5*qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd6 = neg_u1_6*qdd1 - (neg_ipivot6*y6 - neg_u5_6*qdd5 + u4_6*qdd4 -
        neg_u3_6*qdd3 + u2_6*qdd2);
    const panda_real t171 = 149.60760989322964*neg_y7 - neg_u6_7*qdd6 + u5_7*qdd5 + u4_7*qdd4 +
        u3_7*qdd3 + u2_7*qdd2;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd7 = -u1_7*qdd1 - t171;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
