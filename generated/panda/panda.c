/*
 * panda: Franka Emika Panda, hand locked
 * Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
 *   fingers locked at the neutral pose
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 4ff65a695f92e93333f180c48f97cb00 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0       d 0.333  theta q + -pi
 *   2  revolute  alpha pi/2  a 0       d 0      theta q + -pi
 *   3  revolute  alpha pi/2  a 0       d 0.316  theta q
 *   4  revolute  alpha pi/2  a 0.0825  d 0      theta q + -pi
 *   5  revolute  alpha pi/2  a 0.0825  d 0.384  theta q + -pi
 *   6  revolute  alpha pi/2  a 0       d 0      theta q
 *   7  revolute  alpha pi/2  a 0.088   d 0      theta q
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
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine
 *   mass_matrix: 173 multiplications, 163 additions = 336; 1 unary minus; 12 sine/cosine
 *   forward_dynamics: 554 multiplications, 509 additions, 6 divisions = 1069; 5 unary minus; 12
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
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real s2 = sin(again[1]);
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
    const panda_real s3 = sin(again[2]);
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
    const panda_real s4 = sin(again[3]);
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
    const panda_real s5 = sin(again[4]);
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
    const panda_real s6 = sin(again[5]);
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
    const panda_real s7 = sin(again[6]);
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
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real s7 = sin(again[6]);
    const panda_real c7 = cos(q[6]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const panda_real hw7_y = 0.02524706869282775*s7 + 0.019957855994472883*c7;
    /* sines and cosines of the joint angles */
    const panda_real c6 = cos(q[5]);
    const panda_real c5 = cos(q[4]);
    const panda_real c4 = cos(q[3]);
    const panda_real s2 = sin(again[1]);
    const panda_real c3 = cos(q[2]);
    const panda_real c2 = cos(q[1]);
    const panda_real s4 = sin(again[3]);
    const panda_real s5 = sin(again[4]);
    const panda_real s3 = sin(again[2]);
    const panda_real s6 = sin(again[5]);
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
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile panda_real *const again = q;
    /* sines and cosines of the joint angles */
    const panda_real s2 = sin(again[1]);
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
    const panda_real s3 = sin(again[2]);
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
    const panda_real s4 = sin(again[3]);
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
    const panda_real s5 = sin(again[4]);
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
    const panda_real s6 = sin(again[5]);
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
    const panda_real s7 = sin(again[6]);
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
 * 173 multiplications, 163 additions = 336; 1 unary minus; 12 sine/cosine */
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
    const panda_real t1 = 5.2340439032551704e-05*(s7 - 0.7688387349655652*c7);
    const panda_real t2 = 3.056565956646895*t1;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real neg_k7_xz = 7.847986436435337*t2;
    const panda_real t3 = 1.2650190832031087*c7;
    const panda_real t4 = 0.00026172175548237644*t3;
    const panda_real t5 = t4 + t2;
    const panda_real k7_yz = 6.033835963815859*t5;
    const panda_real t6 = k7_yz + 9.35690973146064e-05;
    const panda_real t7 = 7.312195635418935*t4;
    const panda_real t8 = c7*t7;
    const panda_real t9 = s7*t7;
    const panda_real t10 = t1 + t5;
    const panda_real t11 = 0.32333777029991095*t8 + (t9 - 0.0004951501989029328) -
        1.0666666666666667*t10;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xz = s6*t6 - c6*t11;
    const panda_real t12 = c5*c5;
    const panda_real t13 = t8 + 0.012176791922741105 - 0.32333777029991095*t9;
    const panda_real t14 = c6*s6;
    const panda_real t15 = neg_k7_xz + (neg_k7_xz - 0.029497140765350628);
    const panda_real t16 = c6*c6;
    const panda_real t17 = s7 - t3;
    const panda_real t18 = 0.000179030716362244*t17 - 0.0026330206532488923;
    const panda_real t19 = t18 - 0.004051131314112054;
    const panda_real t20 = t19 + (t13 + t18);
    const panda_real t21 = t14*t15 + (t16*t20 + 0.6173375163284962);
    const panda_real t22 = t21 - 0.6477230949391829;
    const panda_real t23 = t13 + t22;
    const panda_real t24 = c5*s5;
    const panda_real t25 = k6_xz + (k6_xz - 0.00303048894665406);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_yy = t12*t23 - (t22 + t24*t25);
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t13 - t22;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = 0.057868845091319815 - t20;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real neg_k6_yz = s6*t11 + c6*t6;
    const panda_real t26 = k5_yy + 0.022178148964878252;
    const panda_real t27 = c4*c4;
    const panda_real t28 = 0.00016784129658960374*t17;
    const panda_real t29 = t28 - 0.0191274230973375;
    const panda_real t30 = c6*t29 - 0.014338888209442497*s6;
    const panda_real t31 = t30 + 0.001208932934385;
    const panda_real t32 = t10 - 0.0055993270925625;
    const panda_real t33 = c5*t31 - s5*t32;
    const panda_real t34 = t33 + m5_5;
    const panda_real t35 = t34 - (k5_yy - t33);
    const panda_real t36 = s6*t29 + 0.014338888209442497*c6;
    const panda_real t37 = 4.654545454545454*t36;
    const panda_real t38 = t37 - m6_6;
    const panda_real t39 = t21 - (t37 + t38);
    const panda_real t40 = t35 - t39;
    const panda_real t41 = c4*s4;
    const panda_real t42 = t14*t20 - 0.004600245517563107 - t15*(t16 - 0.5);
    const panda_real t43 = neg_k6_yz - 0.0021640520520981327;
    const panda_real t44 = c5*t42 + (4.654545454545454*t33 + s5*t43);
    const panda_real t45 = t36 - 0.16284087268546082 - t44;
    const panda_real t46 = t36 - 0.16603319317224746;
    const panda_real t47 = t33 + 0.04560437265862499;
    const panda_real t48 = s4*t46 - c4*t47;
    const panda_real t49 = t27*t40 + 0.11262255718334319 + (t39 - 2.0*(t41*t45 - t48));
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = t26 + t49;
    const panda_real t50 = s5*t31 + c5*t32;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = c5*t43 - (s5*t42 + 4.654545454545454*t50);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_xy = t25*(t12 - 0.5) + t23*t24;
    const panda_real t51 = m4_5 - 0.00164448757736928;
    const panda_real t52 = t50 - 0.002328735327434986;
    const panda_real t53 = t52 + 0.006234090353711091 - neg_k5_xy;
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real neg_k4_yz = c4*t51 + s4*t53;
    const panda_real neg_k4_xz = c4*t53 - s4*t51;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t35 + (t39 + 0.10204027231363098);
    const panda_real t54 = neg_k4_yz + 0.0043772571218395765;
    const panda_real t55 = t48 + 0.06161578168944;
    const panda_real t56 = t27*t45;
    const panda_real t57 = c4*t46 + s4*t47;
    const panda_real t58 = t45 - (t56 + (t56 + 0.005487648106562251)) + t57 - t40*t41;
    const panda_real t59 = s2*(s3*t54 - 3.83030303030303*(c3*t55 + s3*t52) + c3*t58);
    const panda_real t60 = c2*(t59 + 0.003983358883935522*s2);
    const panda_real t61 = c3*c3;
    const panda_real t62 = t26 - t49;
    const panda_real t63 = c3*s3;
    const panda_real t64 = neg_k4_xz - (t50 - 0.0001219124209507298);
    const panda_real t65 = 2.0*t64;
    const panda_real t66 = t26 - (t61*t62 - 0.023077882494931805 + t63*t65);
    const panda_real t67 = t48 - 3.83030303030303*t57;
    const panda_real t68 = m4_4 + t67;
    const panda_real t69 = t68 + 1.0937644822584085 - (t49 - t67);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = m3_3 - t60 - (t60 + ((t66 - t69)*(s2*s2) - 0.03733744848940618));
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_3 = s3*t58 - (c3*t54 + 3.83030303030303*(s3*t55 - c3*t52));
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real neg_k2_yz = s2*(t61*t65 - t62*t63 - (t64 + 0.010261101821008168)) -
        c2*(0.0007689361029464017 - m2_3);
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = c2*m3_3 - t59;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_5 = c4*t34 - (t33 - s4*t44);
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_x = c4*t44 - s4*t34;
    const panda_real t70 = m4_5 + s4*t50;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s3*t70 + c3*nu4_x;
    const panda_real t71 = s5*t36;
    const panda_real t72 = neg_k6_yz - t71;
    const panda_real t73 = s5*t38 + c5*k6_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_y = c4*t72 - s4*t73;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = t71 + nu4_y;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_6 = t30 + (s5*k6_xz - c5*t38);
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real nu6_y = c6*t19 + s6*neg_k7_xz;
    const panda_real neg_nu6_x = s6*t19 - c6*neg_k7_xz;
    const panda_real t74 = c6*t10;
    const panda_real t75 = c5*t28 - s5*t74;
    const panda_real t76 = t75 - nu6_y;
    const panda_real t77 = c5*neg_nu6_x + (s5*k7_yz + 4.654545454545454*t75);
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = t75 - c4*t76 - s4*t77;
    const panda_real t78 = s6*t10;
    const panda_real t79 = s5*t28 + c5*t74;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_7 = t78 - c5*k7_yz + (4.654545454545454*t79 + s5*neg_nu6_x);
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = t66 + t69;
    const panda_real m2_4 = s3*neg_k4_xz - c3*t68;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_y = s3*nu4_x - c3*t70;
    const panda_real t80 = c4*t50;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = 3.83030303030303*(c3*t80 + s3*t33) + nu3_y;
    const panda_real t81 = c5*t36;
    const panda_real t82 = c4*t30 - (s4*t81 + m4_6);
    const panda_real t83 = s4*t30 + c4*t81;
    const panda_real t84 = c4*t73 + s4*t72;
    const panda_real m2_6 = c3*t82 + (3.83030303030303*(c3*t83 - s3*t71) - s3*t84);
    const panda_real t85 = c4*t78 - (m4_7 - s4*t79);
    const panda_real t86 = c4*t79 - s4*t78;
    const panda_real t87 = c4*t77 - s4*t76;
    const panda_real m2_7 = c3*t85 - 3.83030303030303*(c3*t86 + s3*t75) - s3*t87;
    const panda_real t88 = c2*neg_k4_yz - s2*(c3*neg_k4_xz + s3*t68);
    const panda_real t89 = c2*m3_5 - s2*(nu3_x - 3.83030303030303*(s3*t80 - c3*t33));
    const panda_real t90 = c2*m3_6 + s2*(3.83030303030303*(s3*t83 + c3*t71) + s3*t82 + c3*t84);
    const panda_real t91 = c2*m3_7 + s2*(s3*t85 + (3.83030303030303*(c3*t75 - s3*t86) + c3*t87));
    const panda_real t92 = -k7_yz;
    M[0] = m1_1;
    M[1] = neg_k2_yz;
    M[2] = nu2_y;
    M[3] = t88;
    M[4] = t89;
    M[5] = t90;
    M[6] = t91;
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
    M[21] = t88;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = t89;
    M[29] = m2_5;
    M[30] = m3_5;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = neg_k6_yz;
    M[34] = nu6_y;
    M[35] = t90;
    M[36] = m2_6;
    M[37] = m3_6;
    M[38] = m4_6;
    M[39] = neg_k6_yz;
    M[40] = m6_6;
    M[41] = t92;
    M[42] = t91;
    M[43] = m2_7;
    M[44] = m3_7;
    M[45] = m4_7;
    M[46] = nu6_y;
    M[47] = t92;
    M[48] = 0.006684151967360947;
}

/* accelerations that the torques tau give
 * 554 multiplications, 509 additions, 6 divisions = 1069; 5 unary minus; 12 sine/cosine */
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
    const panda_real s2 = sin(again[1]);
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
    const panda_real s3 = sin(again[2]);
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
    const panda_real s4 = sin(again[3]);
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
    const panda_real s5 = sin(again[4]);
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
    const panda_real s6 = sin(again[5]);
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
    const panda_real s7 = sin(again[6]);
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
    const panda_real lam5_23 = neg_alpha5_x - neg_ww5_yz;
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
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real k7_xz = 0.0009653051699191118*c7 - 0.0012555365982729084*s7;
    const panda_real t13 = 0.0002123224431354016*s7;
    const panda_real t14 = t13 + 0.00016784129658960374*c7;
    const panda_real t15 = neg_lam3_31 - 118.9090909090909*c2 + 3.83030303030303*neg_lam2_22;
    const panda_real t16 = 118.9090909090909*s2;
    const panda_real t17 = c3*t16;
    const panda_real t18 = neg_lam3_11 + t17 + 3.83030303030303*neg_lam3_13;
    const panda_real t19 = s4*t15 + c4*t18;
    const panda_real t20 = neg_lam4_11 - t19;
    const panda_real t21 = neg_lam3_21 - s3*t16 - 3.83030303030303*lam3_23;
    const panda_real t22 = lam4_31 + t21;
    const panda_real t23 = c5*t20 - s5*t22;
    const panda_real t24 = t23 + 4.654545454545454*lam5_13;
    const panda_real t25 = s4*t18 - c4*t15;
    const panda_real t26 = lam4_21 - t25;
    const panda_real t27 = t26 + 4.654545454545454*neg_lam4_22;
    const panda_real t28 = c6*t24 - s6*t27;
    const panda_real t29 = t28 - 1.0666666666666667*neg_lam6_11;
    const panda_real t30 = 11.402203849817942*c7;
    const panda_real t31 = 0.0002123224431354016*c7;
    const panda_real t32 = t30*t31;
    const panda_real t33 = t13*t30;
    const panda_real t34 = t32 + 0.00213160409441986 - 0.32333777029991095*t33;
    const panda_real t35 = 0.0009653051699191118*s7 + 0.0012555365982729084*c7;
    const panda_real t36 = t33 + 0.32333777029991095*(t32 - 0.0012104718892606136);
    const panda_real t37 = t34 - 0.006684151967360947;
    const panda_real t38 = s5*t20 + c5*t22;
    const panda_real t39 = t38 + 4.654545454545454*(0.22916666666666666*lam6_31 - lam5_23);
    const panda_real t40 = t31 - 0.00016784129658960374*s7;
    const panda_real t41 = t14*t29 - (neg_lam6_13*t34 + (lam6_12*t35 - (t12*t36 + lam6_31*t37))) -
        t39*t40;
    /* link 7: moment that turns the link [N m] */
    const panda_real neg_nc7_z = t41 + lam6_32*k7_xz;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam6_23 = t6 + neg_w5_y*w6_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real neg_lam5_12 = neg_ww5_xy - alpha4_y;
    const panda_real t42 = -2.0*w7_z;
    const panda_real t43 = lam6_12 - w6_x*t42;
    const panda_real t44 = s6*t24 + c6*t27;
    const panda_real t45 = t44 - 1.0666666666666667*lam6_21;
    const panda_real t46 = lam6_32 - w6_z*t42;
    const panda_real t47 = t14*t46 + (t40*t43 - 0.014338888209442497*(neg_lam6_22 -
        1.2505822551810737*t45));
    const panda_real t48 = t11*k7_xz - (t40*t45 - (t36*t46 + 0.014338888209442497*(t29 -
        74.38977493138147*t47))) + 0.0001037589172186853*lam6_23;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const panda_real n6_z = t37*t43 + (t48 + 0.0011196707334275547*lam6_21 -
        0.028934422545659907*lam6_12 - 0.0005462437073966822*(neg_lam6_22 - neg_lam6_11)) -
        neg_lam6_13*(t35 + 9.35690973146064e-05);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_32 = ww4_yz - neg_alpha4_x;
    const panda_real t49 = t9*t35 + 0.0055993270925625*(t44 + 0.01853060475007911*lam6_21 +
        0.016710775378508038*t8) + 0.014338888209442497*t39 - 0.028934422545659907*lam6_32;
    const panda_real t50 = t34*t46 - (t36*t43 - (t14*t45 - t49)) - lam6_31*(k7_xz -
        0.0005462437073966822);
    const panda_real t51 = neg_lam5_22 + lam5_11;
    const panda_real t52 = lam6_31*t40 - (t14*(t10 - t12) + 0.014338888209442497*lam6_32) +
        0.017931959153753906*t39;
    const panda_real t53 = neg_nc7_z - 0.0005462437073966822*lam6_32 - (9.35690973146064e-05*lam6_12
        + 0.0001037589172186853*t12 + 0.0055993270925625*(t28 + 190.49908123486904*t52));
    const panda_real t54 = t53 - 0.0011196707334275547*lam6_31;
    const panda_real t55 = t52 + 0.0055993270925625*neg_lam5_22;
    const panda_real t56 = c6*t50 - 0.010045187828321245*neg_lam5_32 + 0.00151524447332703*lam5_31 +
        0.0021640520520981327*(t7 - t51) - (s6*t54 - 4.654545454545454*t55);
    const panda_real t57 = t56 - 0.0010267877770288932*neg_lam5_21;
    const panda_real t58 = t10*t40 + 0.014338888209442497*lam6_12 - 0.017931959153753906*t29 +
        neg_lam6_13*(t14 - 0.0055993270925625);
    const panda_real t59 = t47 + 0.0055993270925625*lam6_23;
    const panda_real t60 = c6*t58 - s6*t59;
    const panda_real t61 = n6_z - 0.0021640520520981327*neg_lam5_12 -
        0.00151524447332703*neg_lam5_32 + 4.654545454545454*(t60 + 0.00025973168512177737*t26) +
        0.0010267877770288932*t7;
    const panda_real t62 = t61 + 0.001451156065026714*lam5_31;
    const panda_real t63 = neg_lam4_22 + lam3_22;
    const panda_real t64 = c5*t57 + 0.0039053550262761055*lam4_21 + 0.07937575371526083*lam4_31 +
        (s5*t62 + 0.08256807420204747*(t21 + 0.019916748613333906*t63));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_x = 0.30879988491513166*lam4_32 - t64;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam4_23 = ww4_yz + neg_alpha4_x;
    const panda_real lam4_13 = ww4_zx + alpha4_y;
    const panda_real lam4_12 = ww4_xy + alpha3_y;
    const panda_real t65 = c6*t54 + s6*t50 + 0.0010267877770288932*(2.1075942862896366*lam5_13 -
        lam5_23) - 0.001451156065026714*(neg_lam5_21 - 6.922196771534925*neg_lam5_12);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const panda_real n5_z = t65 + 0.001208932934385*(t38 - 1.2533734752605237*t51);
    const panda_real t66 = 0.022178148964878252*lam4_23 - n4_x;
    const panda_real t67 = t60 - 0.001208932934385*(22.889949241848065*t23 - lam5_11);
    const panda_real t68 = t55 - 0.001208932934385*(neg_lam5_21 - 22.889949241848065*t38);
    const panda_real t69 = s5*t67 + c5*t68;
    const panda_real t70 = n5_z + (t69 + 0.00164448757736928*(lam4_12 - 16.779641781916826*lam4_13))
        + 0.0039053550262761055*(t3 - 20.32484964393837*lam4_32 + 2.773506358193827*ww4_zx);
    const panda_real t71 = t69 - 0.08256807420204747*(lam4_32 - 0.19391767563373744*t21);
    const panda_real t72 = c4*t70 + 0.0001219124209507298*(neg_lam3_11 + lam3_22) - (t71 -
        0.002328735327434986*(t17 + 0.005737304173171223*neg_lam3_21) -
        0.005487648106562251*lam3_23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const panda_real n3_z = s4*t66 + t72 + 0.013297019103287523*neg_lam3_13;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_12 = neg_ww2_zx - neg_ww3_xy;
    const panda_real t73 = s6*t58 + 0.02767241350487109*t26 + c6*t59 + 0.001208932934385*lam5_31;
    const panda_real t74 = c5*t62 + 0.0039053550262761055*lam4_23 + 0.00164448757736928*(lam4_13 -
        48.26777338278214*(t3 - t63) + 3.293283313732418*lam4_21 - 187.77878845951824*lam4_12);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const panda_real n4_z = t73 - (s5*t57 - 0.08256807420204747*t19) + t74;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const panda_real lam3_32 = ww3_yz + alpha3_x;
    const panda_real t75 = s4*t70 - c4*t66 - 3.83030303030303*t71 + 0.013297019103287523*(t2 -
        0.41269761770933294*neg_lam3_21 + 0.009168402331661572*neg_lam3_31 - 20.824802807474068*c2 +
        7.904433989224409*lam3_23);
    const panda_real t76 = c5*t67 - s5*t68 - 0.08256807420204747*(lam4_12 -
        0.19391767563373744*t19);
    const panda_real t77 = t73 - 0.016011409030815008*t25 + 0.08256807420204747*neg_lam4_22;
    const panda_real t78 = s4*t76 + c4*t77 - 3.83030303030303*(c4*t76 - s4*t77) +
        0.013297019103287523*lam3_12;
    const panda_real t79 = t78 - (n4_z + (0.0001219124209507298*lam3_32 +
        0.10510540975539216*neg_lam3_13 + 1.3360662912304e-05*(neg_lam3_31 +
        410.731723611454*(neg_lam3_11 - neg_lam2_22))));
    const panda_real t80 = c2*n3_z - 0.010261101821008168*(ww2_zz*(c2 - 0.07493699179284168*s2)) +
        s2*(c3*t75 + s3*t79);
    const panda_real t81 = t1 - (qd[0] - t1);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const panda_real n1_z = t80 + 0.007966717767871044*(qd[1]*t81);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const panda_real n2_z = c3*t79 - (s3*t75 + 0.003983358883935522*(qd[0]*t81) +
        4.746153896127808*(s2 - 0.004200004283199334*c2));
    const panda_real t82 = 0.12742121920055377*k7_xz - 0.00033108301517462406*c7;
    /* link 7: second moment of the composite body [kg m^2] */
    const panda_real neg_k7_yz = 6.033835963815859*t82;
    const panda_real t83 = 9.35690973146064e-05 - neg_k7_yz;
    const panda_real t84 = 0.002420943778521227*c7;
    const panda_real t85 = s7*t84;
    const panda_real t86 = c7*t84;
    const panda_real t87 = t82 + 0.04168770476667123*k7_xz;
    const panda_real t88 = t85 - 0.0004951501989029328 + 0.32333777029991095*t86 +
        1.0666666666666667*t87;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real k6_xz = s6*t83 - c6*t88;
    const panda_real t89 = c5*c5;
    const panda_real t90 = t86 + 0.012176791922741105 - 0.32333777029991095*t85;
    const panda_real t91 = c6*s6;
    const panda_real t92 = k7_xz + (k7_xz + 0.029497140765350628);
    const panda_real t93 = c6*c6;
    const panda_real t94 = s7 - 1.2650190832031087*c7;
    const panda_real t95 = 0.000179030716362244*t94;
    const panda_real t96 = 0.006684151967360947 - t95;
    const panda_real t97 = t96 - (t90 + (t95 - 0.0026330206532488923));
    const panda_real t98 = t91*t92 + (t93*t97 - 0.6173375163284962);
    const panda_real t99 = t98 + 0.6477230949391829;
    const panda_real t100 = t90 - t99;
    const panda_real t101 = c5*s5;
    const panda_real t102 = k6_xz + (k6_xz - 0.00303048894665406);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real k5_yy = t89*t100 + (t99 - t101*t102);
    /* link 5: mass matrix, its row of this joint */
    const panda_real m5_5 = t90 + t99;
    /* link 6: mass matrix, its row of this joint */
    const panda_real m6_6 = t97 + 0.057868845091319815;
    /* link 6: second moment of the composite body [kg m^2] */
    const panda_real neg_k6_yz = s6*t88 + c6*t83;
    const panda_real t103 = k5_yy + 0.022178148964878252;
    const panda_real t104 = c4*c4;
    const panda_real t105 = 0.00016784129658960374*t94;
    const panda_real t106 = t105 - 0.0191274230973375;
    const panda_real t107 = c6*t106 - 0.014338888209442497*s6;
    const panda_real t108 = t107 + 0.001208932934385;
    const panda_real t109 = 0.0055993270925625 + t87;
    const panda_real t110 = c5*t108 + s5*t109;
    const panda_real t111 = m5_5 + t110;
    const panda_real t112 = t111 - (k5_yy - t110);
    const panda_real t113 = s6*t106 + 0.014338888209442497*c6;
    const panda_real t114 = 4.654545454545454*t113;
    const panda_real t115 = m6_6 - t114;
    const panda_real t116 = t98 + (t114 - t115);
    const panda_real t117 = t112 + t116;
    const panda_real t118 = c4*s4;
    const panda_real t119 = t91*t97 + 0.004600245517563107 - t92*(t93 - 0.5);
    const panda_real t120 = neg_k6_yz - 0.0021640520520981327;
    const panda_real t121 = c5*t119 - (s5*t120 + 4.654545454545454*t110);
    const panda_real t122 = t113 - 0.16284087268546082 + t121;
    const panda_real t123 = t113 - 0.16603319317224746;
    const panda_real t124 = t110 + 0.04560437265862499;
    const panda_real t125 = s4*t123 - c4*t124;
    const panda_real t126 = t104*t117 + 0.11262255718334319 - (t116 + 2.0*(t118*t122 - t125));
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_3 = t103 + t126;
    const panda_real t127 = s5*t108 - c5*t109;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_5 = c5*t120 + (s5*t119 - 4.654545454545454*t127);
    /* link 5: second moment of the composite body [kg m^2] */
    const panda_real neg_k5_xy = t102*(t89 - 0.5) + t100*t101;
    const panda_real t128 = m4_5 - 0.00164448757736928;
    const panda_real t129 = neg_k5_xy - (t127 + 0.0039053550262761055);
    /* link 4: second moment of the composite body [kg m^2] */
    const panda_real neg_k4_yz = c4*t128 - s4*t129;
    const panda_real k4_xz = c4*t129 + s4*t128;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_4 = t112 - (t116 - 0.10204027231363098);
    const panda_real t130 = neg_k4_yz + 0.0043772571218395765;
    const panda_real t131 = t125 + 0.06161578168944;
    const panda_real t132 = t127 - 0.002328735327434986;
    const panda_real t133 = t104*t122;
    const panda_real t134 = c4*t123 + s4*t124;
    const panda_real t135 = t122 - (t133 + (t133 + 0.005487648106562251)) + t134 - t117*t118;
    const panda_real t136 = s2*(s3*t130 - 3.83030303030303*(c3*t131 + s3*t132) + c3*t135);
    const panda_real t137 = c2*(t136 + 0.003983358883935522*s2);
    const panda_real t138 = c3*c3;
    const panda_real t139 = t103 - t126;
    const panda_real t140 = c3*s3;
    const panda_real t141 = k4_xz + (t127 - 0.0001219124209507298);
    const panda_real t142 = 2.0*t141;
    const panda_real t143 = t103 - (t138*t139 - 0.023077882494931805 - t140*t142);
    const panda_real t144 = t125 - 3.83030303030303*t134;
    const panda_real t145 = m4_4 + t144;
    const panda_real t146 = t145 + 1.0937644822584085 - (t126 - t144);
    /* link 1: mass matrix, its row of this joint */
    const panda_real m1_1 = m3_3 - t137 - (t137 + ((t143 - t146)*(s2*s2) - 0.03733744848940618));
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_3 = s3*t135 - (c3*t130 + 3.83030303030303*(s3*t131 - c3*t132));
    /* link 2: second moment of the composite body [kg m^2] */
    const panda_real k2_yz = s2*(t138*t142 + t139*t140 - (t141 - 0.010261101821008168)) - c2*(m2_3 -
        0.0007689361029464017);
    /* link 2: moment for a unit acceleration of a joint further out */
    const panda_real nu2_y = c2*m3_3 - t136;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_5 = c4*t111 - (t110 + s4*t121);
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real neg_nu4_x = c4*t121 + s4*t111;
    const panda_real t147 = m4_5 + s4*t127;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real nu3_x = s3*t147 - c3*neg_nu4_x;
    const panda_real t148 = s5*t113;
    const panda_real t149 = neg_k6_yz - t148;
    const panda_real t150 = s5*t115 - c5*k6_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const panda_real nu4_y = c4*t149 + s4*t150;
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_6 = t148 + nu4_y;
    /* link 4: mass matrix, its row of this joint */
    const panda_real m4_6 = t107 + (s5*k6_xz + c5*t115);
    /* link 6: moment for a unit acceleration of a joint further out */
    const panda_real neg_nu6_y = c6*t96 + s6*k7_xz;
    const panda_real nu6_x = s6*t96 - c6*k7_xz;
    const panda_real t151 = c6*t87;
    const panda_real t152 = c5*t105 + s5*t151;
    const panda_real t153 = neg_nu6_y + t152;
    const panda_real t154 = c5*nu6_x + (s5*neg_k7_yz - 4.654545454545454*t152);
    /* link 3: mass matrix, its row of this joint */
    const panda_real m3_7 = t152 - c4*t153 + s4*t154;
    const panda_real t155 = s6*t87;
    const panda_real t156 = s5*t105 - c5*t151;
    /* link 4: mass matrix, its row of this joint */
    const panda_real neg_m4_7 = t155 - c5*neg_k7_yz + (s5*nu6_x - 4.654545454545454*t156);
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_2 = t143 + t146;
    const panda_real neg_m2_4 = s3*k4_xz + c3*t145;
    /* link 3: moment for a unit acceleration of a joint further out */
    const panda_real neg_nu3_y = s3*neg_nu4_x + c3*t147;
    const panda_real t157 = c4*t127;
    /* link 2: mass matrix, its row of this joint */
    const panda_real m2_5 = 3.83030303030303*(c3*t157 + s3*t110) - neg_nu3_y;
    const panda_real t158 = c5*t113;
    const panda_real t159 = c4*t107 - (m4_6 + s4*t158);
    const panda_real t160 = c4*t150 - s4*t149;
    const panda_real t161 = s4*t107 + c4*t158;
    const panda_real m2_6 = c3*t159 + (s3*t160 + 3.83030303030303*(c3*t161 - s3*t148));
    const panda_real t162 = c4*t155 - (neg_m4_7 + s4*t156);
    const panda_real t163 = c4*t156 + s4*t155;
    const panda_real t164 = c4*t154 + s4*t153;
    const panda_real neg_m2_7 = c3*t162 + 3.83030303030303*(c3*t163 + s3*t152) - s3*t164;
    /* factorisation M = U D U^T */
    const panda_real ud1_7 = c2*m3_7 - s2*(s3*t162 + (c3*t164 - 3.83030303030303*(c3*t152 -
        s3*t163)));
    /* link 7: forward substitution */
    const panda_real y7 = neg_nc7_z + tau[6];
    /* factorisation M = U D U^T */
    const panda_real u6_7 = 902.7077770343022*t82;
    const panda_real neg_u5_7 = 149.60760989322964*neg_nu6_y;
    const panda_real neg_u4_7 = 149.60760989322964*neg_m4_7;
    const panda_real u3_7 = 149.60760989322964*m3_7;
    const panda_real neg_u2_7 = 149.60760989322964*neg_m2_7;
    const panda_real u1_7 = 149.60760989322964*ud1_7;
    const panda_real pivot6 = m6_6 - neg_k7_yz*u6_7;
    const panda_real ipivot6 = 1.0 / pivot6;
    const panda_real ud5_6 = neg_k6_yz + neg_k7_yz*neg_u5_7;
    const panda_real u5_6 = ipivot6*ud5_6;
    const panda_real ud4_6 = m4_6 + neg_k7_yz*neg_u4_7;
    const panda_real u4_6 = ipivot6*ud4_6;
    const panda_real ud3_6 = m3_6 - neg_k7_yz*u3_7;
    const panda_real u3_6 = ipivot6*ud3_6;
    const panda_real ud2_6 = m2_6 + neg_k7_yz*neg_u2_7;
    const panda_real u2_6 = ipivot6*ud2_6;
    const panda_real t165 = c2*m3_6 + s2*(s3*t159 + 3.83030303030303*(s3*t161 + c3*t148) - c3*t160);
    const panda_real ud1_6 = t165 - neg_k7_yz*u1_7;
    const panda_real u1_6 = ipivot6*ud1_6;
    const panda_real pivot5 = m5_5 - neg_nu6_y*neg_u5_7 - ud5_6*u5_6;
    const panda_real ipivot5 = 1.0 / pivot5;
    const panda_real ud4_5 = m4_5 - neg_nu6_y*neg_u4_7 - ud5_6*u4_6;
    const panda_real u4_5 = ipivot5*ud4_5;
    const panda_real ud3_5 = m3_5 + neg_nu6_y*u3_7 - ud5_6*u3_6;
    const panda_real u3_5 = ipivot5*ud3_5;
    const panda_real neg_ud2_5 = neg_nu6_y*neg_u2_7 - m2_5 + ud5_6*u2_6;
    const panda_real neg_u2_5 = ipivot5*neg_ud2_5;
    const panda_real t166 = c2*m3_5 - s2*(nu3_x - 3.83030303030303*(s3*t157 - c3*t110)) +
        neg_nu6_y*u1_7;
    const panda_real ud1_5 = t166 - ud5_6*u1_6;
    const panda_real u1_5 = ipivot5*ud1_5;
    const panda_real pivot4 = m4_4 - neg_m4_7*neg_u4_7 - ud4_6*u4_6 - ud4_5*u4_5;
    const panda_real ipivot4 = 1.0 / pivot4;
    const panda_real ud3_4 = neg_k4_yz + neg_m4_7*u3_7 - ud4_6*u3_6 - ud4_5*u3_5;
    const panda_real u3_4 = ipivot4*ud3_4;
    const panda_real neg_ud2_4 = neg_m2_4 + neg_m4_7*neg_u2_7 + ud4_6*u2_6 - ud4_5*neg_u2_5;
    const panda_real neg_u2_4 = ipivot4*neg_ud2_4;
    const panda_real t167 = c2*neg_k4_yz + s2*(c3*k4_xz - s3*t145) + neg_m4_7*u1_7 - ud4_6*u1_6;
    const panda_real ud1_4 = t167 - ud4_5*u1_5;
    const panda_real u1_4 = ipivot4*ud1_4;
    const panda_real pivot3 = m3_3 - m3_7*u3_7 - ud3_6*u3_6 - ud3_5*u3_5 - ud3_4*u3_4;
    const panda_real ipivot3 = 1.0 / pivot3;
    const panda_real ud2_3 = m2_3 + m3_7*neg_u2_7 - ud3_6*u2_6 + ud3_5*neg_u2_5 + ud3_4*neg_u2_4;
    const panda_real u2_3 = ipivot3*ud2_3;
    const panda_real neg_ud1_3 = m3_7*u1_7 - nu2_y + ud3_6*u1_6 + ud3_5*u1_5 + ud3_4*u1_4;
    const panda_real neg_u1_3 = ipivot3*neg_ud1_3;
    const panda_real pivot2 = m2_2 - neg_m2_7*neg_u2_7 - ud2_6*u2_6 - neg_ud2_5*neg_u2_5 -
        neg_ud2_4*neg_u2_4 - ud2_3*u2_3;
    const panda_real ipivot2 = 1.0 / pivot2;
    const panda_real neg_ud1_2 = k2_yz - neg_m2_7*u1_7 + ud2_6*u1_6 - neg_ud2_5*u1_5 -
        neg_ud2_4*u1_4 - ud2_3*neg_u1_3;
    const panda_real neg_u1_2 = ipivot2*neg_ud1_2;
    const panda_real t168 = m1_1 - ud1_7*u1_7 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 -
        neg_ud1_3*neg_u1_3;
    const panda_real pivot1 = t168 - neg_ud1_2*neg_u1_2;
    const panda_real ipivot1 = 1.0 / pivot1;
    /* link 6: forward substitution */
    const panda_real neg_y6 = n6_z - tau[5] + y7*u6_7;
    /* link 5: forward substitution */
    const panda_real neg_y5 = n5_z - tau[4] - y7*neg_u5_7 - u5_6*neg_y6;
    /* link 4: forward substitution */
    const panda_real neg_y4 = n4_z - tau[3] - y7*neg_u4_7 - u4_6*neg_y6 - u4_5*neg_y5;
    /* link 3: forward substitution */
    const panda_real neg_y3 = n3_z - tau[2] + y7*u3_7 - u3_6*neg_y6 - u3_5*neg_y5 - u3_4*neg_y4;
    /* link 2: forward substitution */
    const panda_real neg_y2 = n2_z - tau[1] - y7*neg_u2_7 - u2_6*neg_y6 + neg_u2_5*neg_y5 +
        neg_u2_4*neg_y4 - u2_3*neg_y3;
    const panda_real t169 = n1_z - tau[0] + y7*u1_7 - u1_6*neg_y6 - u1_5*neg_y5 - u1_4*neg_y4 +
        neg_u1_3*neg_y3;
    /* link 1: forward substitution */
    const panda_real neg_y1 = t169 + neg_u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real neg_qdd2 = ipivot2*neg_y2 + neg_u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real neg_qdd3 = ipivot3*neg_y3 - u2_3*neg_qdd2 + neg_u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real neg_qdd4 = ipivot4*neg_y4 - u3_4*neg_qdd3 + neg_u2_4*neg_qdd2 - u1_4*neg_qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real neg_qdd5 = ipivot5*neg_y5 - u4_5*neg_qdd4 - u3_5*neg_qdd3 + neg_u2_5*neg_qdd2 -
        u1_5*neg_qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd6 = u1_6*neg_qdd1 - (ipivot6*neg_y6 - u5_6*neg_qdd5 - u4_6*neg_qdd4 -
        u3_6*neg_qdd3 - u2_6*neg_qdd2);
    const panda_real t170 = 149.60760989322964*y7 - u6_7*qdd6 - neg_u5_7*neg_qdd5 -
        neg_u4_7*neg_qdd4 + u3_7*neg_qdd3 - neg_u2_7*neg_qdd2;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const panda_real qdd7 = t170 + u1_7*neg_qdd1;
    const panda_real t171 = -neg_qdd1;
    const panda_real t172 = -neg_qdd2;
    const panda_real t173 = -neg_qdd3;
    const panda_real t174 = -neg_qdd4;
    const panda_real t175 = -neg_qdd5;
    qdd[0] = t171;
    qdd[1] = t172;
    qdd[2] = t173;
    qdd[3] = t174;
    qdd[4] = t175;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
