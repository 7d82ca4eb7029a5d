/*
 * iiwa: KUKA iiwa 14 geometry, random full inertias
 * Numbers: published iiwa geometry; inertial parameters drawn at random
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 470f3a2263cc6972820aa958e2c80090 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0  d 0.34   theta q
 *   2  revolute  alpha -pi/2  a 0  d 0      theta q
 *   3  revolute  alpha pi/2   a 0  d 0.4    theta q
 *   4  revolute  alpha pi/2   a 0  d 0      theta q
 *   5  revolute  alpha -pi/2  a 0  d 0.4    theta q
 *   6  revolute  alpha -pi/2  a 0  d 0      theta q
 *   7  revolute  alpha pi/2   a 0  d 0.126  theta q
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
 * Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
 *   parameters, equal to the recursion without being written like it: robodyn --optimize full,
 *   seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 259 multiplications, 247 additions = 506; 8 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 244 multiplications, 227 additions = 471; 6 unary minus; 12 sine/cosine
 *   mass_matrix: 161 multiplications, 137 additions = 298; 2 unary minus; 12 sine/cosine
 *   forward_dynamics: 531 multiplications, 469 additions, 6 divisions = 1006; 20 unary minus; 12
 *       sine/cosine
 */
#include "iiwa.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 259 multiplications, 247 additions = 506; 8 unary minus; 12 sine/cosine */
void iiwa_inverse_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real qdd[7],
    iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = -s2*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_y = -qd[0]*c2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam2_23 = s2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_yz = w2_y*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = ww2_yz - lam2_23;
    /* sines and cosines of the joint angles */
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y - (-s3*qdd[1] - alpha2_x*c3);
    const iiwa_real alpha3_y = c3*qdd[1] - alpha2_x*s3 - w3_x*qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_yz = w3_z*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_zz = w3_z*w3_z;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_xy = w3_x*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa_real w4_z = qd[3] - w3_y;
    const iiwa_real w4_y = w3_z*c4 - w3_x*s4;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_yz = w4_z*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_12 = ww4_xy - alpha4_z;
    const iiwa_real lam4_21 = alpha4_z + ww4_xy;
    const iiwa_real neg_lam4_11 = ww4_zz + ww4_yy;
    /* sines and cosines of the joint angles */
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa_real w5_z = w4_y + qd[4];
    const iiwa_real w5_y = -w4_z*c5 - w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_zz = w5_z*w5_z;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_yz = w5_z*w5_y;
    const iiwa_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa_real w6_z = w5_y + qd[5];
    const iiwa_real w6_y = -w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_zz = w6_z*w6_z;
    const iiwa_real ww6_yz = w6_z*w6_y;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_yy = w6_y*w6_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_zz + ww6_yy;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* sines and cosines of the joint angles */
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam2_13 = c2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zx = w2_x*qd[1];
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_z = neg_lam2_13 + (ww2_zx + qdd[2]);
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_y = c4*alpha3_z - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_21 = ww3_xy + alpha3_z;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = s4*alpha3_z - (-qd[3]*w4_y - alpha3_x*c4);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz + alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real neg_lam4_22 = neg_lam5_22 - t1;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_12 = ww5_xy - alpha5_z;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_zz = w7_z*w7_z;
    const iiwa_real t2 = ww7_zz - ww6_zz;
    const iiwa_real t3 = neg_lam5_22 - neg_lam6_11;
    const iiwa_real t4 = ww6_zz + ww7_zz;
    const iiwa_real t5 = t3 + t4;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_22 = t2 - t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - alpha4_z*s5 + c5*alpha4_x;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_z = s6*alpha5_x + (c6*alpha5_z + (w6_x*qd[5] + qdd[6]));
    const iiwa_real t6 = alpha7_z - ww6_zx;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_13 = qdd[6] - t6;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_y = -s5*alpha4_x - w5_x*qd[4] - alpha4_z*c5;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_z = alpha5_y + qdd[5];
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha6_z;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x + (qd[5]*w6_y - s6*alpha5_z);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha6_z;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t7 = neg_lam5_22 + lam6_22;
    const iiwa_real t8 = 0.150926706942488*s7;
    const iiwa_real t9 = 0.3999801598546772*c7;
    const iiwa_real t10 = t8*t9;
    const iiwa_real t11 = c7*c7;
    const iiwa_real t12 = 1.6791988194353373*t10 - 0.2114247825686032*(t11 + (t11 - 1.0));
    const iiwa_real t13 = qd[6] + w7_z;
    const iiwa_real t14 = w6_z*t13 + alpha6_x;
    const iiwa_real t15 = alpha6_z - w6_x*t13;
    const iiwa_real t16 = 0.10136935104159488*t11 + (7.004567783863868*t10 + 0.19090892097190032);
    const iiwa_real t17 = t16 - 0.48318719298539553;
    const iiwa_real t18 = 24.525*s2;
    const iiwa_real t19 = c3*t18;
    const iiwa_real t20 = lam3_13 - t19;
    const iiwa_real t21 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t22 = c4*t20 - s4*t21;
    const iiwa_real t23 = lam4_12 + t22;
    const iiwa_real t24 = s3*t18;
    const iiwa_real t25 = lam3_23 + t24;
    const iiwa_real t26 = t25 - lam4_32;
    const iiwa_real t27 = c5*t23 + s5*t26;
    const iiwa_real t28 = s4*t20 + c4*t21;
    const iiwa_real t29 = t28 + neg_lam4_22;
    const iiwa_real t30 = c6*t27 + s6*t29;
    const iiwa_real t31 = t9 - 0.283322719186478*s7;
    const iiwa_real t32 = 1.1592996128590562*(t31 - 0.5301679950513729*c7);
    const iiwa_real t33 = -0.4239952187044951*lam6_21 - (t12*t14 - t15*t17 + (0.516451399126078*t30
        - 2.0289563933923875*lam6_12 + t6*t32));
    const iiwa_real t34 = s6*t27 - c6*t29;
    const iiwa_real t35 = t8 - 0.32845591866705903*c7;
    const iiwa_real t36 = 0.36144292274665746*(t3 - t7) - (0.0870114460092663*lam6_13 + (t33 + ((t31
        - 0.6262523039785531)*t34 - t35*(t4 + lam6_22))));
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = t36 - 0.042925575293549574*lam6_23;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t37 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = 0.03284626166448073*lam5_32 - (0.10101181803004346*t29 -
        0.041147842218669614*(t1 - t37) + 0.05680835589544868*lam5_12 - n6_z +
        0.09474888781047501*lam5_31);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy + alpha5_z;
    const iiwa_real t38 = -ww6_zx - alpha7_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_31 = qdd[6] + t38;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t39 = 1.8772205723301225*(t32 + 0.11538550714999525*s7);
    const iiwa_real t40 = s5*t23 - c5*t26;
    const iiwa_real t41 = t17*t38 - lam6_12*t32 + (t3*t12 + t30*t39 + (t35*lam6_32 - t31*t40));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t41 + t6*t16;
    const iiwa_real t42 = 0.042925575293549574*t3 - (0.36144292274665746*lam6_32 +
        0.16772238154175834*t30) - (0.4239952187044951*neg_lam6_31 + 0.0870114460092663*lam6_12 -
        (0.6262523039785531*t40 + nc7_z) + 0.20655564034097101*lam6_13);
    const iiwa_real t43 = t12*t15 - 0.20655564034097101*lam6_23 + 0.36144292274665746*neg_lam6_31 -
        (t35*t38 + 0.0870114460092663*t7 - t14*t16);
    const iiwa_real t44 = -0.042925575293549574*lam6_21 - (t43 + (2.0289563933923875*lam6_32 -
        t2*t32) - t34*(t39 - 0.16772238154175834)) - 0.516451399126078*t40;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = s6*t42 - c6*t44 - (0.05680835589544868*t1 + (0.03284626166448073*lam5_31
        - 0.041147842218669614*lam5_21));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_13 = ww4_zx + alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx + alpha5_y;
    const iiwa_real t45 = 0.03284626166448073*t37 - 0.041147842218669614*lam5_23 -
        (-0.05680835589544868*lam5_13 - s6*t44) + 0.09474888781047501*lam5_21 + c6*t42;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = t45 + 0.10101181803004346*t40;
    const iiwa_real t46 = neg_lam4_11 - neg_lam4_22;
    const iiwa_real t47 = -0.10101181803004346*lam5_21 - (t31*t38 + (0.16772238154175834*neg_lam5_22
        - (0.6262523039785531*neg_lam6_31 - (0.516451399126078*lam6_32 - t5*t39))));
    const iiwa_real t48 = t14*t39 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 + t15*t31;
    const iiwa_real t49 = 0.16772238154175834*lam6_13 + (0.6262523039785531*neg_lam6_11 - (t4*t31 -
        t6*t39)) - 0.516451399126078*lam6_12;
    const iiwa_real t50 = 0.10101181803004346*neg_lam5_11 - (s6*t48 - c6*t49);
    const iiwa_real t51 = s5*t47 - c5*t50;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = -0.013124222729483126*lam4_23 - (3.569490999313376*lam4_12 +
        3.221934173968582*t22 + 0.09675036990607108*lam4_13 - 0.24852411424661205*lam4_21) -
        (0.20921122087079386*t46 + s5*n5_x - (t51 + (0.2067207712712513*t28 - c5*n5_y)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - alpha3_z;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t52 = ww3_zz - ww3_yy;
    const iiwa_real t53 = ww3_xx - ww3_zz;
    const iiwa_real t54 = 0.2067207712712513*t25 - 0.2506667841125447*lam4_13 +
        0.24852411424661205*lam4_31 - (0.09675036990607108*lam4_12 + n5_z) -
        0.20921122087079386*lam4_32;
    const iiwa_real t55 = ww4_zz - ww4_yy;
    const iiwa_real t56 = t54 - 0.013124222729483126*(t55 + t46);
    const iiwa_real t57 = s5*t50 + c5*t47;
    const iiwa_real t58 = 0.013124222729483126*(lam4_21 - 15.940846569207324*lam4_31) - s5*n5_y +
        (0.09675036990607108*t55 - t57 + c5*n5_x);
    const iiwa_real t59 = 3.221934173968582*t25 - (t58 - 0.2506667841125447*lam4_23) -
        3.569490999313376*lam4_32;
    const iiwa_real t60 = 0.1005265342798281*(t52 + t53) + (0.0816122074936837*lam3_13 -
        0.4067460055662282*t24 - (c4*t56 - 0.40382182094267666*alpha3_z + s4*t59));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t60 - 0.01755847364096103*(t19 + 13.921743270739537*lam3_23);
    const iiwa_real t61 = c4*t59 - (0.1005265342798281*neg_lam3_31 - (t57 +
        (-0.40382182094267666*alpha3_x - s4*t56) - 3.221934173968582*lam4_32));
    const iiwa_real t62 = 0.0816122074936837*t52 + (0.2067207712712513*lam4_31 +
        (0.43062156604456925*c2 + t61 - 0.24444456225550676*lam3_21));
    const iiwa_real t63 = s4*(3.221934173968582*neg_lam4_22 - (-0.2067207712712513*lam4_21 - s6*t49
        - c6*t48) + 0.10101181803004346*lam5_31);
    const iiwa_real t64 = -0.1005265342798281*lam3_32 - (t63 - n4_z + (9.975445786511747*c2 +
        (0.40382182094267666*alpha3_y - 0.24444456225550676*t53))) + 0.0816122074936837*lam3_12;
    const iiwa_real t65 = c4*(0.2067207712712513*neg_lam4_11 + (3.221934173968582*lam4_12 - t51)) -
        t64;
    const iiwa_real t66 = 0.20091837135316784*c2 + 0.26458063578324464*s2;
    const iiwa_real t67 = 0.41715488532235584*c2 - 0.7593842639253783*t66;
    const iiwa_real t68 = 3.509903939799839*c2;
    const iiwa_real t69 = c2*t68;
    const iiwa_real t70 = s2*t68;
    const iiwa_real t71 = qd[0]*(t70 + (0.29735998936351243*t69 - 0.5218524991029152));
    const iiwa_real t72 = t66*ww2_zz + (qdd[0]*(t69 - 4.842302505434623 - 0.29735998936351243*t70) -
        (2.0*(qd[1]*t71) + c2*n3_z));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t62 + s3*t65) + qdd[1]*t67 - t72;
    const iiwa_real t73 = 24.525*(0.186058218569173*qdd[1] + (0.5419930474657001*c2 -
        3.126354326358915*s2)) + (c3*t65 - s3*t62);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = qdd[0]*t67 - (qd[0]*t71 - t73);
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
void iiwa_gravity(const iiwa_real q[7], iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real s7 = sin(again[6]);
    const iiwa_real c7 = cos(q[6]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw7_y = 9.809513420435959*s7 + 6.948489688048372*c7;
    /* sines and cosines of the joint angles */
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real s6 = sin(again[5]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw7_x = 9.809513420435959*c7 - 6.948489688048372*s7;
    const iiwa_real t1 = s2*c3;
    const iiwa_real t2 = c4*t1 - c2*s4;
    const iiwa_real t3 = s2*s3;
    const iiwa_real t4 = c5*t2 - s5*t3;
    const iiwa_real t5 = t1*s4 + c4*c2;
    /* link 7: joint torque [N m], at a prismatic joint force [N] */
    const iiwa_real tau7 = hw7_y*(c6*t4 + s6*t5) + hw7_x*(t2*s5 + c5*t3);
    const iiwa_real t6 = hw7_x - 15.358837755074015;
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw6_y = s6*t6 - 12.665970563567063*c6;
    const iiwa_real hw6_x = c6*t6 + 12.665970563567063*s6;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const iiwa_real tau6 = t4*hw6_y - t5*hw6_x;
    const iiwa_real t7 = hw6_x - 2.4773148371868157;
    const iiwa_real t8 = hw7_y + 4.113391407311623;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw5_y = s5*t7 + c5*t8;
    const iiwa_real hw5_x = c5*t7 - s5*t8;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const iiwa_real tau5 = t2*hw5_y + t3*hw5_x;
    const iiwa_real t9 = hw5_x - 5.069826915427438;
    const iiwa_real t10 = hw6_y - 79.01793561657948;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw4_y = s4*t9 - c4*t10;
    const iiwa_real hw4_x = c4*t9 + s4*t10;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const iiwa_real tau4 = t1*hw4_y + c2*hw4_x;
    const iiwa_real t11 = hw5_y - 0.43062156604456925;
    const iiwa_real t12 = hw4_x - 9.975445786511747;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const iiwa_real tau3 = t1*t11 + t3*t12;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw3_x = c3*t12 - s3*t11;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw2_x = c2*(hw3_x - 13.292379489096295) + s2*(hw4_y + 76.6738398539524);
    const iiwa_real t13 = -hw2_x;
    tau[0] = 0.0;
    tau[1] = t13;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
    tau[6] = tau7;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 244 multiplications, 227 additions = 471; 6 unary minus; 12 sine/cosine */
void iiwa_bias(const iiwa_real q[7], const iiwa_real qd[7], iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = -s2*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_y = -qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_yz = w2_y*qd[1];
    /* sines and cosines of the joint angles */
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = ww2_yz*c3 + qd[2]*w3_y;
    const iiwa_real alpha3_y = -w3_x*qd[2] - ww2_yz*s3;
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_yz = w3_z*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_zz = w3_z*w3_z;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_xy = w3_x*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa_real w4_z = qd[3] - w3_y;
    const iiwa_real w4_y = w3_z*c4 - w3_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_yz = w4_z*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real neg_lam4_11 = ww4_zz + ww4_yy;
    /* sines and cosines of the joint angles */
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa_real w5_z = w4_y + qd[4];
    const iiwa_real w5_y = -w4_z*c5 - w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_zz = w5_z*w5_z;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_yz = w5_z*w5_y;
    const iiwa_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa_real w6_z = w5_y + qd[5];
    const iiwa_real w6_y = -w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_zz = w6_z*w6_z;
    const iiwa_real ww6_yz = w6_z*w6_y;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_yy = w6_y*w6_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_zz + ww6_yy;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* sines and cosines of the joint angles */
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zx = w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_y = c4*ww2_zx - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_21 = ww3_xy + ww2_zx;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real neg_alpha4_x = -qd[3]*w4_y - alpha3_x*c4 - s4*ww2_zx;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz - neg_alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real neg_lam4_22 = neg_lam5_22 - t1;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_12 = ww5_xy - alpha4_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_zz = w7_z*w7_z;
    const iiwa_real t2 = ww7_zz - ww6_zz;
    const iiwa_real t3 = neg_lam5_22 - neg_lam6_11;
    const iiwa_real t4 = ww6_zz + ww7_zz;
    const iiwa_real t5 = t3 + t4;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_22 = t2 - t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = alpha3_y*s5 + qd[4]*w5_y - c5*neg_alpha4_x;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_z = s6*alpha5_x + (c6*alpha4_y + w6_x*qd[5]);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_13 = ww6_zx - alpha7_z;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_y = alpha3_y*c5 + (s5*neg_alpha4_x - w5_x*qd[4]);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x + (qd[5]*w6_y - s6*alpha4_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t6 = 0.150926706942488*s7;
    const iiwa_real t7 = t6 - 0.32845591866705903*c7;
    const iiwa_real t8 = 0.3999801598546772*c7;
    const iiwa_real t9 = t8 - 0.283322719186478*s7;
    const iiwa_real t10 = t9 - 0.6262523039785531;
    const iiwa_real t11 = 24.525*s2;
    const iiwa_real t12 = c3*t11;
    const iiwa_real t13 = lam3_13 - t12;
    const iiwa_real t14 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t15 = c4*t13 - s4*t14;
    const iiwa_real t16 = lam4_12 + t15;
    const iiwa_real t17 = s3*t11;
    const iiwa_real t18 = lam3_23 + t17;
    const iiwa_real t19 = t18 - lam4_32;
    const iiwa_real t20 = c5*t16 + s5*t19;
    const iiwa_real t21 = s4*t13 + c4*t14;
    const iiwa_real t22 = t21 + neg_lam4_22;
    const iiwa_real t23 = s6*t20 - c6*t22;
    const iiwa_real t24 = c6*t20 + s6*t22;
    const iiwa_real t25 = neg_lam5_22 + lam6_22;
    const iiwa_real t26 = t6*t8;
    const iiwa_real t27 = c7*c7;
    const iiwa_real t28 = 1.6791988194353373*t26 - 0.2114247825686032*(t27 + (t27 - 1.0));
    const iiwa_real t29 = qd[6] + w7_z;
    const iiwa_real t30 = w6_z*t29 + alpha6_x;
    const iiwa_real t31 = alpha5_y - w6_x*t29;
    const iiwa_real t32 = 0.10136935104159488*t27 + (7.004567783863868*t26 + 0.19090892097190032);
    const iiwa_real t33 = 0.48318719298539553 - t32;
    const iiwa_real t34 = 0.516451399126078*t24 - (-0.4239952187044951*lam6_21 -
        0.36144292274665746*(t3 - t25) - t28*t30 - t31*t33);
    const iiwa_real t35 = 1.1592996128590562*(t9 - 0.5301679950513729*c7);
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = t7*(t4 + lam6_22) - (t10*t23 - (t34 - 2.0289563933923875*lam6_12)) -
        0.042925575293549574*lam6_23 - lam6_13*(t35 + 0.0870114460092663);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t36 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = 0.03284626166448073*lam5_32 - (0.10101181803004346*t22 -
        0.041147842218669614*(t1 - t36) + 0.05680835589544868*lam5_12 - n6_z +
        0.09474888781047501*lam5_31);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy + alpha4_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_31 = ww6_zx + alpha7_z;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t37 = 1.8772205723301225*(t35 + 0.11538550714999525*s7);
    const iiwa_real t38 = s5*t16 - c5*t19;
    const iiwa_real t39 = t33*lam6_31 - lam6_12*t35 + (t3*t28 + t24*t37 + (t7*lam6_32 - t9*t38));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t39 - lam6_13*t32;
    const iiwa_real t40 = 0.042925575293549574*t3 - (0.36144292274665746*lam6_32 +
        0.16772238154175834*t24) - (0.0870114460092663*lam6_12 - 0.4239952187044951*lam6_31 -
        (0.6262523039785531*t38 + nc7_z) + 0.20655564034097101*lam6_13);
    const iiwa_real t41 = t37 - 0.16772238154175834;
    const iiwa_real t42 = t30*t32 - (0.0870114460092663*t25 + (0.20655564034097101*lam6_23 +
        (-0.042925575293549574*lam6_21 - t28*t31))) - t2*t35;
    const iiwa_real t43 = 0.516451399126078*t38 - (t23*t41 - (2.0289563933923875*lam6_32 + t42)) +
        lam6_31*(t7 - 0.36144292274665746);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = s6*t40 + c6*t43 - (0.05680835589544868*t1 + (0.03284626166448073*lam5_31
        - 0.041147842218669614*lam5_21));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz + neg_alpha4_x;
    const iiwa_real lam4_13 = ww4_zx + alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx + alpha5_y;
    const iiwa_real t44 = 0.03284626166448073*t36 - 0.041147842218669614*lam5_23 - (s6*t43 -
        0.05680835589544868*lam5_13) + 0.09474888781047501*lam5_21 + c6*t40;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = t44 + 0.10101181803004346*t38;
    const iiwa_real t45 = neg_lam4_11 - neg_lam4_22;
    const iiwa_real t46 = t5*t37 - (0.516451399126078*lam6_32 - (-0.16772238154175834*neg_lam5_22 -
        0.10101181803004346*lam5_21)) + t10*lam6_31;
    const iiwa_real t47 = t30*t37 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 + t31*t9;
    const iiwa_real t48 = t4*t9 - (0.6262523039785531*neg_lam6_11 - 0.516451399126078*lam6_12) +
        lam6_13*t41;
    const iiwa_real t49 = 0.10101181803004346*neg_lam5_11 - (s6*t47 + c6*t48);
    const iiwa_real t50 = s5*t46 - c5*t49;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = -0.013124222729483126*lam4_23 - (3.569490999313376*lam4_12 +
        3.221934173968582*t15 + 0.09675036990607108*lam4_13 - 0.24852411424661205*lam4_21) -
        (0.20921122087079386*t45 + s5*n5_x - (t50 + (0.2067207712712513*t21 - c5*n5_y)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t51 = ww3_zz - ww3_yy;
    const iiwa_real t52 = ww3_xx - ww3_zz;
    const iiwa_real t53 = 0.2067207712712513*t18 - 0.2506667841125447*lam4_13 +
        0.24852411424661205*lam4_31 - (0.09675036990607108*lam4_12 + n5_z) -
        0.20921122087079386*lam4_32;
    const iiwa_real t54 = ww4_zz - ww4_yy;
    const iiwa_real t55 = t53 - 0.013124222729483126*(t54 + t45);
    const iiwa_real t56 = s5*t49 + c5*t46;
    const iiwa_real t57 = 0.013124222729483126*(lam4_21 - 15.940846569207324*lam4_31) - s5*n5_y +
        (0.09675036990607108*t54 - t56 + c5*n5_x);
    const iiwa_real t58 = 3.221934173968582*t18 - (t57 - 0.2506667841125447*lam4_23) -
        3.569490999313376*lam4_32;
    const iiwa_real t59 = 0.1005265342798281*(t51 + t52) + (0.0816122074936837*lam3_13 -
        0.4067460055662282*t17 - (c4*t55 - 0.40382182094267666*ww2_zx + s4*t58));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t59 - 0.01755847364096103*(t12 + 13.921743270739537*lam3_23);
    const iiwa_real t60 = c4*t58 - (0.1005265342798281*neg_lam3_31 - (t56 +
        (-0.40382182094267666*alpha3_x - s4*t55) - 3.221934173968582*lam4_32));
    const iiwa_real t61 = 0.0816122074936837*t51 + (0.2067207712712513*lam4_31 +
        (0.43062156604456925*c2 + t60 - 0.24444456225550676*lam3_21));
    const iiwa_real t62 = s4*(3.221934173968582*neg_lam4_22 - (s6*t48 - 0.2067207712712513*lam4_21 -
        c6*t47) + 0.10101181803004346*lam5_31);
    const iiwa_real t63 = -0.1005265342798281*lam3_32 - (t62 - n4_z + (9.975445786511747*c2 +
        (0.40382182094267666*alpha3_y - 0.24444456225550676*t52))) + 0.0816122074936837*lam3_12;
    const iiwa_real t64 = c4*(0.2067207712712513*neg_lam4_11 + (3.221934173968582*lam4_12 - t50)) -
        t63;
    const iiwa_real t65 = 3.509903939799839*c2;
    const iiwa_real t66 = qd[0]*(s2*t65 + (0.29735998936351243*(c2*t65) - 0.5218524991029152));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t61 + s3*t64) - ((0.20091837135316784*c2 +
        0.26458063578324464*s2)*ww2_zz - (2.0*(qd[1]*t66) + c2*n3_z));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = 24.525*(0.5419930474657001*c2 - 3.126354326358915*s2) + (c3*t64 - s3*t61)
        - qd[0]*t66;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 161 multiplications, 137 additions = 298; 2 unary minus; 12 sine/cosine */
void iiwa_mass_matrix(const iiwa_real q[7], iiwa_real M[49])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    const iiwa_real t1 = 0.9999503996366931*s7;
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_y = 0.708306797966195*c7 + t1;
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu6_x = c6*h7_y;
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_x = 1.4117475682965523*h7_y - 2.119984343070462*s7;
    const iiwa_real t2 = h7_x - 1.5656307599463828;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = 1.291128497815195*s6 + c6*t2;
    const iiwa_real t3 = h7_y + 0.4193059538543958;
    const iiwa_real t4 = h6_x - 0.25252954507510866;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h5_x = s5*t3 - c5*t4;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h6_y = 1.291128497815195*c6 - s6*t2;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_y = c5*t3 + s5*t4;
    const iiwa_real t5 = neg_h5_x + 0.5168019281781282;
    const iiwa_real t6 = neg_h6_y + 8.054835434921454;
    const iiwa_real t7 = c4*t5 + (s4*t6 + 1.0168650139155704);
    const iiwa_real t8 = h5_y - 0.04389618410240257;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h3_x = c3*t7 + s3*t8;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real neg_m6_7 = 0.11539123059695529*(t1 + 1.846595961484861*h7_y);
    const iiwa_real t9 = neg_m6_7 - 0.0870114460092663;
    const iiwa_real t10 = 0.4228495651372064*c7;
    const iiwa_real t11 = c7*t10;
    const iiwa_real t12 = s7*t10;
    const iiwa_real t13 = t11 - (0.23972911266611452*t12 + 0.25435035786215276);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xz = s6*t9 + c6*t13;
    const iiwa_real k6_yz = s6*t13 - c6*t9;
    const iiwa_real t14 = c6*c6;
    const iiwa_real t15 = 0.15093419333331276*h7_y - 0.4353636338505884*c7;
    const iiwa_real t16 = 2.0*t15 - 0.7228858454933149;
    const iiwa_real t17 = t12 + (0.23972911266611452*t11 + 1.3126829026743974);
    const iiwa_real t18 = c6*s6;
    const iiwa_real t19 = t14*t16 - (t15 - 0.4025907649653271 + t17*t18);
    const iiwa_real t20 = k6_yz + 0.05680835589544868;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = 0.4*h5_y - s5*t19 - c5*t20;
    const iiwa_real t21 = c5*c5;
    const iiwa_real t22 = k6_xz + (k6_xz - 0.06569252332896146);
    const iiwa_real t23 = c5*s5;
    const iiwa_real t24 = t14*t17 + t18*t16;
    const iiwa_real t25 = t24 + (t17 - 3.0389236225643885);
    const iiwa_real t26 = t21*t22 - (k6_xz + (t23*t25 - 0.045970484393963854));
    const iiwa_real t27 = m4_5 - 0.09675036990607108;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real neg_k4_yz = s4*t26 + c4*t27;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real neg_m5_5 = t24 - (t17 + 1.2084869398413365);
    const iiwa_real t28 = neg_k4_yz - 0.06405373385272267;
    const iiwa_real t29 = c4*s4;
    const iiwa_real t30 = t24 - (t21*t25 + 7.016595671833826 + t22*t23);
    const iiwa_real t31 = t30 - 4.4699270629915056 + 0.8*neg_h6_y;
    const iiwa_real t32 = 2.0*(t30 - 3.067723445330515 - neg_m5_5);
    const iiwa_real t33 = t31 - t32;
    const iiwa_real t34 = 0.4*neg_h5_x + c5*t19 - s5*t20;
    const iiwa_real t35 = t34 + (t34 + 0.4184224417415877);
    const iiwa_real t36 = s4*s4;
    const iiwa_real t37 = t29*t33 + 0.04690977756007243 + (t34 - t35*t36);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real neg_k3_xz = s3*t28 + c3*t37;
    const iiwa_real t38 = t29*t35 + (t33*t36 + 0.9030127193018334);
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = t38 - neg_m5_5;
    const iiwa_real t39 = s2*(0.4*neg_h3_x + neg_k3_xz);
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y = c2*m3_3 - t39;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real neg_k4_xz = c4*t26 - s4*t27;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t31 + 16.41827590041618;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h4_y = c4*t6 - s4*t5;
    const iiwa_real t40 = c3*c3;
    const iiwa_real t41 = t32 + (t38 + (neg_m5_5 + 15.016072282755191));
    const iiwa_real t42 = c3*s3;
    const iiwa_real t43 = neg_k4_xz + (neg_k4_xz - 0.2010530685596562);
    const iiwa_real t44 = t40*t41 - (t42*t43 + 3.9137257607425155);
    const iiwa_real t45 = 0.4*h4_y;
    const iiwa_real t46 = m4_4 + t45;
    const iiwa_real t47 = t45 + t46;
    const iiwa_real t48 = t44 - t47;
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = 1.3323985656347848 - c2*(t39 - neg_nu2_y - (c2*t48 +
        1.0437049982058304*s2)) - t48;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h3_y = c3*t8 - s3*t7;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = s3*t37 - 0.4*h3_y - c3*t28;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_yz = c2*(m2_3 + 0.26458063578324464) + s2*(t41*t42 + (t40*t43 -
        0.10039183707333973) - neg_k4_xz);
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_y = s4*t34 - c4*neg_m5_5;
    const iiwa_real nu4_x = s4*neg_m5_5 + c4*t34;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c3*nu4_x + s3*m4_5;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu4_x = c4*h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu3_y = s3*neg_fu4_x + c3*neg_h5_x;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 4.057912786784775 - t17;
    const iiwa_real t49 = 0.4*neg_h6_y;
    const iiwa_real t50 = t49 + m6_6;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = s5*k6_xz - c5*t50;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = 0.48318719298539553*s6 + c6*t15;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c5*nu6_x + s5*neg_m6_7;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_y = s5*neg_fu6_x - c5*h7_x;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu6_y = 0.48318719298539553*c6 - s6*t15;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = c5*neg_fu6_x + s5*h7_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_y = s5*nu6_x - c5*neg_m6_7;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = 0.4*neg_fu5_x - nu5_y;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = t44 + (t47 - t30 - m3_3) - t30;
    const iiwa_real m2_4 = s3*neg_k4_xz - c3*t46;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_y = s3*nu4_x - c3*m4_5;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = s3*neg_h5_x - c3*neg_fu4_x;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_5 = nu3_y + 0.4*fu3_x;
    const iiwa_real t51 = 0.4*(s4*h6_x + neg_h6_y*(c4*c5)) - m4_6;
    const iiwa_real t52 = s5*t50 + c5*k6_xz;
    const iiwa_real t53 = c4*t52 + (s5*t49 + s4*k6_yz);
    const iiwa_real m2_6 = c3*t51 - s3*t53;
    const iiwa_real t54 = c4*neg_fu5_x + h7_y*(s4*s6);
    const iiwa_real t55 = nu5_x + 0.4*neg_fu5_y;
    const iiwa_real t56 = c4*t55 - s4*neg_nu6_y;
    const iiwa_real m2_7 = 0.4*(s3*neg_fu5_y - c3*t54) - (c3*m4_7 - s3*t56);
    const iiwa_real t57 = c2*neg_k4_yz - s2*(c3*neg_k4_xz + s3*t46);
    const iiwa_real t58 = c2*nu4_y - s2*(nu3_x + 0.4*neg_fu3_y);
    const iiwa_real t59 = c4*k6_yz - s4*t52;
    const iiwa_real t60 = c2*t59 + s2*(c3*t53 + s3*t51);
    const iiwa_real t61 = s4*t55 + c4*neg_nu6_y;
    const iiwa_real t62 = c2*t61 - s2*(c3*t56 + (0.4*(c3*neg_fu5_y + s3*t54) + s3*m4_7));
    const iiwa_real t63 = -neg_m5_5;
    const iiwa_real t64 = -neg_m6_7;
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y;
    M[3] = t57;
    M[4] = t58;
    M[5] = t60;
    M[6] = t62;
    M[7] = k2_yz;
    M[8] = m2_2;
    M[9] = m2_3;
    M[10] = m2_4;
    M[11] = m2_5;
    M[12] = m2_6;
    M[13] = m2_7;
    M[14] = neg_nu2_y;
    M[15] = m2_3;
    M[16] = m3_3;
    M[17] = neg_k4_yz;
    M[18] = nu4_y;
    M[19] = t59;
    M[20] = t61;
    M[21] = t57;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = t58;
    M[29] = m2_5;
    M[30] = nu4_y;
    M[31] = m4_5;
    M[32] = t63;
    M[33] = k6_yz;
    M[34] = neg_nu6_y;
    M[35] = t60;
    M[36] = m2_6;
    M[37] = t59;
    M[38] = m4_6;
    M[39] = k6_yz;
    M[40] = m6_6;
    M[41] = t64;
    M[42] = t62;
    M[43] = m2_7;
    M[44] = t61;
    M[45] = m4_7;
    M[46] = neg_nu6_y;
    M[47] = t64;
    M[48] = 0.48318719298539553;
}

/* accelerations that the torques tau give
 * 531 multiplications, 469 additions, 6 divisions = 1006; 20 unary minus; 12 sine/cosine */
void iiwa_forward_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real tau[7],
    iiwa_real qdd[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = -s2*qd[0];
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_y = -qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_yz = w2_y*qd[1];
    /* sines and cosines of the joint angles */
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = ww2_yz*c3 + qd[2]*w3_y;
    const iiwa_real alpha3_y = -ww2_yz*s3 - w3_x*qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_yz = w3_z*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_zz = w3_z*w3_z;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_xy = w3_x*w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = w3_x*c4 + w3_z*s4;
    const iiwa_real w4_z = qd[3] - w3_y;
    const iiwa_real w4_y = w3_z*c4 - w3_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_yz = w4_z*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real neg_lam4_11 = ww4_zz + ww4_yy;
    /* sines and cosines of the joint angles */
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = w4_x*c5 - w4_z*s5;
    const iiwa_real w5_z = w4_y + qd[4];
    const iiwa_real w5_y = -w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_zz = w5_z*w5_z;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_yz = w5_z*w5_y;
    const iiwa_real ww5_zx = w5_x*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* sines and cosines of the joint angles */
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = w5_x*c6 - w5_z*s6;
    const iiwa_real w6_z = w5_y + qd[5];
    const iiwa_real w6_y = -w5_z*c6 - w5_x*s6;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_zz = w6_z*w6_z;
    const iiwa_real ww6_yz = w6_z*w6_y;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_yy = w6_y*w6_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_zz + ww6_yy;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* sines and cosines of the joint angles */
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zx = w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_y = c4*ww2_zx - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_21 = ww3_xy + ww2_zx;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = qd[3]*w4_y + alpha3_x*c4 + s4*ww2_zx;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz + alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real neg_lam4_22 = neg_lam5_22 - t1;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_12 = ww5_xy - alpha4_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_zz = w7_z*w7_z;
    const iiwa_real t2 = ww7_zz - ww6_zz;
    const iiwa_real t3 = neg_lam5_22 - neg_lam6_11;
    const iiwa_real t4 = ww6_zz + ww7_zz;
    const iiwa_real t5 = t3 + t4;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_22 = t2 - t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = alpha3_y*s5 + qd[4]*w5_y + c5*alpha4_x;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_z = s6*alpha5_x - (-w6_x*qd[5] - c6*alpha4_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_13 = ww6_zx - alpha7_z;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_y = alpha3_y*c5 - (s5*alpha4_x + w5_x*qd[4]);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x - (s6*alpha4_y - qd[5]*w6_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t6 = 0.150926706942488*s7;
    const iiwa_real t7 = t6 - 0.32845591866705903*c7;
    const iiwa_real t8 = 0.3999801598546772*c7;
    const iiwa_real t9 = t8 - 0.283322719186478*s7;
    const iiwa_real t10 = t9 - 0.6262523039785531;
    const iiwa_real t11 = 24.525*s2;
    const iiwa_real t12 = c3*t11;
    const iiwa_real t13 = lam3_13 - t12;
    const iiwa_real t14 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t15 = c4*t13 - s4*t14;
    const iiwa_real t16 = lam4_12 + t15;
    const iiwa_real t17 = s3*t11;
    const iiwa_real t18 = lam3_23 + t17;
    const iiwa_real t19 = t18 - lam4_32;
    const iiwa_real t20 = c5*t16 + s5*t19;
    const iiwa_real t21 = s4*t13 + c4*t14;
    const iiwa_real t22 = neg_lam4_22 + t21;
    const iiwa_real t23 = s6*t20 - c6*t22;
    const iiwa_real t24 = c6*t20 + s6*t22;
    const iiwa_real t25 = neg_lam5_22 + lam6_22;
    const iiwa_real t26 = t6*t8;
    const iiwa_real t27 = c7*c7;
    const iiwa_real t28 = 1.6791988194353373*t26 - 0.2114247825686032*(t27 + (t27 - 1.0));
    const iiwa_real t29 = qd[6] + w7_z;
    const iiwa_real t30 = alpha6_x + w6_z*t29;
    const iiwa_real t31 = alpha5_y - w6_x*t29;
    const iiwa_real t32 = 0.10136935104159488*t27 + (7.004567783863868*t26 + 0.19090892097190032);
    const iiwa_real t33 = t32 - 0.48318719298539553;
    const iiwa_real t34 = 0.516451399126078*t24 + (0.4239952187044951*lam6_21 +
        0.36144292274665746*(t3 - t25) + t28*t30 - t31*t33);
    const iiwa_real t35 = 1.1592996128590562*(0.5301679950513729*c7 - t9);
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = t7*(t4 + lam6_22) - (t10*t23 - (t34 - 2.0289563933923875*lam6_12)) -
        0.042925575293549574*lam6_23 - lam6_13*(0.0870114460092663 - t35);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t36 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = 0.03284626166448073*lam5_32 + (n6_z - (0.10101181803004346*t22 -
        0.041147842218669614*(t1 - t36) + 0.05680835589544868*lam5_12) -
        0.09474888781047501*lam5_31);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy + alpha4_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_31 = ww6_zx + alpha7_z;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t37 = 1.8772205723301225*(0.11538550714999525*s7 - t35);
    const iiwa_real t38 = s5*t16 - c5*t19;
    const iiwa_real t39 = lam6_12*t35 - t33*lam6_31 + (t3*t28 + t24*t37 - (t9*t38 - t7*lam6_32));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t39 - lam6_13*t32;
    const iiwa_real t40 = 0.042925575293549574*t3 + (-0.36144292274665746*lam6_32 -
        0.16772238154175834*t24) - (0.0870114460092663*lam6_12 - 0.4239952187044951*lam6_31 - (nc7_z
        + 0.6262523039785531*t38) + 0.20655564034097101*lam6_13);
    const iiwa_real t41 = t37 - 0.16772238154175834;
    const iiwa_real t42 = t30*t32 - (0.0870114460092663*t25 - (0.042925575293549574*lam6_21 +
        t28*t31 - 0.20655564034097101*lam6_23)) + t2*t35;
    const iiwa_real t43 = 0.516451399126078*t38 - (t23*t41 + (-2.0289563933923875*lam6_32 - t42)) +
        lam6_31*(t7 - 0.36144292274665746);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = s6*t40 + c6*t43 - (0.05680835589544868*t1 - (0.041147842218669614*lam5_21
        - 0.03284626166448073*lam5_31));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_13 = ww4_zx + alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx + alpha5_y;
    const iiwa_real t44 = 0.03284626166448073*t36 - 0.041147842218669614*lam5_23 - (s6*t43 -
        0.05680835589544868*lam5_13) + 0.09474888781047501*lam5_21 + c6*t40;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = t44 + 0.10101181803004346*t38;
    const iiwa_real t45 = neg_lam4_11 - neg_lam4_22;
    const iiwa_real t46 = t5*t37 + (-0.516451399126078*lam6_32 - (0.16772238154175834*neg_lam5_22 +
        0.10101181803004346*lam5_21)) + t10*lam6_31;
    const iiwa_real t47 = t30*t37 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 + t9*t31;
    const iiwa_real t48 = t4*t9 - (0.6262523039785531*neg_lam6_11 - 0.516451399126078*lam6_12) +
        lam6_13*t41;
    const iiwa_real t49 = 0.10101181803004346*neg_lam5_11 - (s6*t47 + c6*t48);
    const iiwa_real t50 = s5*t46 - c5*t49;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = -0.013124222729483126*lam4_23 - (3.569490999313376*lam4_12 +
        3.221934173968582*t15 + 0.09675036990607108*lam4_13 - 0.24852411424661205*lam4_21) -
        (0.20921122087079386*t45 + s5*n5_x - (t50 + (0.2067207712712513*t21 - c5*n5_y)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t51 = ww3_zz - ww3_yy;
    const iiwa_real t52 = ww3_xx - ww3_zz;
    const iiwa_real t53 = 0.2067207712712513*t18 - 0.2506667841125447*lam4_13 +
        0.24852411424661205*lam4_31 - (n5_z + 0.09675036990607108*lam4_12) -
        0.20921122087079386*lam4_32;
    const iiwa_real t54 = ww4_zz - ww4_yy;
    const iiwa_real t55 = t53 - 0.013124222729483126*(t45 + t54);
    const iiwa_real t56 = s5*t49 + c5*t46;
    const iiwa_real t57 = 0.013124222729483126*(15.940846569207324*lam4_31 - lam4_21) + s5*n5_y -
        (0.09675036990607108*t54 - t56 + c5*n5_x);
    const iiwa_real t58 = 3.221934173968582*t18 + (t57 + 0.2506667841125447*lam4_23) -
        3.569490999313376*lam4_32;
    const iiwa_real t59 = 0.1005265342798281*(t51 + t52) + (0.0816122074936837*lam3_13 -
        0.4067460055662282*t17 - (c4*t55 - 0.40382182094267666*ww2_zx + s4*t58));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t59 - 0.01755847364096103*(t12 + 13.921743270739537*lam3_23);
    const iiwa_real t60 = c4*t58 - (0.1005265342798281*neg_lam3_31 - (t56 +
        (-0.40382182094267666*alpha3_x - s4*t55) - 3.221934173968582*lam4_32));
    const iiwa_real t61 = 0.0816122074936837*t51 + (0.2067207712712513*lam4_31 +
        (0.43062156604456925*c2 + t60 - 0.24444456225550676*lam3_21));
    const iiwa_real t62 = s4*(3.221934173968582*neg_lam4_22 - (s6*t48 - 0.2067207712712513*lam4_21 -
        c6*t47) + 0.10101181803004346*lam5_31);
    const iiwa_real t63 = n4_z - t62 - (9.975445786511747*c2 + (0.40382182094267666*alpha3_y -
        0.24444456225550676*t52)) - 0.1005265342798281*lam3_32 + 0.0816122074936837*lam3_12;
    const iiwa_real t64 = c4*(0.2067207712712513*neg_lam4_11 - (t50 - 3.221934173968582*lam4_12)) -
        t63;
    const iiwa_real t65 = 3.509903939799839*c2;
    const iiwa_real t66 = qd[0]*(s2*t65 + (0.29735998936351243*(c2*t65) - 0.5218524991029152));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t61 + s3*t64) - (ww2_zz*(0.20091837135316784*c2 +
        0.26458063578324464*s2) - (2.0*(qd[1]*t66) + c2*n3_z));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = 24.525*(0.5419930474657001*c2 - 3.126354326358915*s2) + (c3*t64 - s3*t61)
        - qd[0]*t66;
    const iiwa_real t67 = 0.9999503996366931*s7;
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_y = 0.708306797966195*c7 + t67;
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real fu6_x = -c6*h7_y;
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_x = 1.4117475682965523*h7_y - 2.119984343070462*s7;
    const iiwa_real t68 = h7_x - 1.5656307599463828;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = 1.291128497815195*s6 + c6*t68;
    const iiwa_real t69 = h6_x - 0.25252954507510866;
    const iiwa_real t70 = h7_y + 0.4193059538543958;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_x = c5*t69 - s5*t70;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_y = s6*t68 - 1.291128497815195*c6;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_y = c5*t70 + s5*t69;
    const iiwa_real t71 = 0.5168019281781282 - h5_x;
    const iiwa_real t72 = 8.054835434921454 - h6_y;
    const iiwa_real t73 = c4*t71 + (s4*t72 + 1.0168650139155704);
    const iiwa_real t74 = h5_y - 0.04389618410240257;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h3_x = c3*t73 + s3*t74;
    const iiwa_real t75 = t67 + 1.846595961484861*h7_y;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_7 = -0.11539123059695529*t75;
    const iiwa_real t76 = 0.4228495651372064*c7;
    const iiwa_real t77 = c7*t76;
    const iiwa_real t78 = s7*t76;
    const iiwa_real t79 = t77 - (0.23972911266611452*t78 + 0.25435035786215276);
    const iiwa_real t80 = 0.0870114460092663 + m6_7;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xz = c6*t79 - s6*t80;
    const iiwa_real k6_yz = s6*t79 + c6*t80;
    const iiwa_real t81 = c6*c6;
    const iiwa_real t82 = 0.15093419333331276*h7_y - 0.4353636338505884*c7;
    const iiwa_real t83 = 2.0*t82 - 0.7228858454933149;
    const iiwa_real t84 = t78 + (0.23972911266611452*t77 + 1.3126829026743974);
    const iiwa_real t85 = c6*s6;
    const iiwa_real t86 = t81*t83 - (t82 - 0.4025907649653271 + t84*t85);
    const iiwa_real t87 = k6_yz + 0.05680835589544868;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = 0.4*h5_y - s5*t86 - c5*t87;
    const iiwa_real t88 = c5*c5;
    const iiwa_real t89 = 0.06569252332896146 - k6_xz - k6_xz;
    const iiwa_real t90 = c5*s5;
    const iiwa_real t91 = t81*t84 + t83*t85;
    const iiwa_real t92 = t91 + (t84 - 3.0389236225643885);
    const iiwa_real t93 = t88*t89 + (k6_xz + (t90*t92 - 0.045970484393963854));
    const iiwa_real t94 = m4_5 - 0.09675036990607108;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_yz = s4*t93 - c4*t94;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t84 + 1.2084869398413365 - t91;
    const iiwa_real t95 = k4_yz + 0.06405373385272267;
    const iiwa_real t96 = c4*s4;
    const iiwa_real t97 = t91 - (t88*t92 + 7.016595671833826 - t89*t90);
    const iiwa_real t98 = t97 - 4.4699270629915056 - 0.8*h6_y;
    const iiwa_real t99 = -2.0*(m5_5 + (t97 - 3.067723445330515));
    const iiwa_real t100 = t98 + t99;
    const iiwa_real t101 = c5*t86 - 0.4*h5_x - s5*t87;
    const iiwa_real t102 = t101 + (t101 + 0.4184224417415877);
    const iiwa_real t103 = s4*s4;
    const iiwa_real t104 = t96*t100 + 0.04690977756007243 + (t101 - t102*t103);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_xz = s3*t95 - c3*t104;
    const iiwa_real t105 = t96*t102 + (t100*t103 + 0.9030127193018334);
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = m5_5 + t105;
    const iiwa_real t106 = s2*(k3_xz - 0.4*neg_h3_x);
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y = c2*m3_3 + t106;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xz = c4*t93 + s4*t94;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t98 + 16.41827590041618;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h4_y = c4*t72 - s4*t71;
    const iiwa_real t107 = c3*c3;
    const iiwa_real t108 = t99 - (t105 + (15.016072282755191 - m5_5));
    const iiwa_real t109 = c3*s3;
    const iiwa_real t110 = k4_xz + (k4_xz + 0.2010530685596562);
    const iiwa_real t111 = t107*t108 - (t109*t110 - 3.9137257607425155);
    const iiwa_real t112 = 0.4*h4_y;
    const iiwa_real t113 = m4_4 + t112;
    const iiwa_real t114 = t112 + t113;
    const iiwa_real t115 = t111 + t114;
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = t115 + (c2*(t106 + neg_nu2_y - (c2*t115 - 1.0437049982058304*s2)) +
        1.3323985656347848);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h3_y = c3*t74 - s3*t73;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = s3*t104 - 0.4*h3_y + c3*t95;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_yz = c2*(m2_3 + 0.26458063578324464) + s2*(k4_xz - (t108*t109 + (t107*t110 +
        0.10039183707333973)));
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_y = s4*t101 + c4*m5_5;
    const iiwa_real nu4_x = c4*t101 - s4*m5_5;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c3*nu4_x + s3*m4_5;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x = -c4*h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_y = s3*fu4_x + c3*h5_x;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 4.057912786784775 - t84;
    const iiwa_real t116 = 0.4*h6_y;
    const iiwa_real t117 = t116 - m6_6;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = s5*k6_xz + c5*t117;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = 0.48318719298539553*s6 + c6*t82;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c5*nu6_x - s5*m6_7;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real fu5_y = s5*fu6_x + c5*h7_x;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_y = s6*t82 - 0.48318719298539553*c6;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = s5*h7_x - c5*fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_y = s5*nu6_x + c5*m6_7;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = 0.4*neg_fu5_x - nu5_y;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real neg_m2_2 = t97 + (t111 + (m3_3 + (t97 - t114)));
    const iiwa_real t118 = -c3;
    const iiwa_real m2_4 = t118*t113 - s3*k4_xz;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_y = s3*nu4_x - c3*m4_5;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = c3*fu4_x - s3*h5_x;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_5 = nu3_y + 0.4*fu3_x;
    const iiwa_real t119 = 0.4*(s4*h6_x - h6_y*(c4*c5)) - m4_6;
    const iiwa_real t120 = s5*t117 - c5*k6_xz;
    const iiwa_real t121 = c4*t120 - (s4*k6_yz - s5*t116);
    const iiwa_real m2_6 = c3*t119 + s3*t121;
    const iiwa_real t122 = h7_y*(-s4*s6) - c4*neg_fu5_x;
    const iiwa_real t123 = nu5_x - 0.4*fu5_y;
    const iiwa_real t124 = c4*t123 + s4*nu6_y;
    const iiwa_real m2_7 = 0.4*(c3*t122 - s3*fu5_y) + (s3*t124 - c3*m4_7);
    /* factorisation M = U D U^T */
    const iiwa_real ud3_7 = s4*t123 - c4*nu6_y;
    const iiwa_real ud1_7 = c2*ud3_7 - s2*(c3*t124 + (0.4*(t118*fu5_y - s3*t122) + s3*m4_7));
    /* link 7: forward substitution */
    const iiwa_real y7 = tau[6] - nc7_z;
    /* factorisation M = U D U^T */
    const iiwa_real u6_7 = -0.2388126843429044*t75;
    const iiwa_real u5_7 = -2.069591277495274*nu6_y;
    const iiwa_real u4_7 = 2.069591277495274*m4_7;
    const iiwa_real u3_7 = 2.069591277495274*ud3_7;
    const iiwa_real u2_7 = 2.069591277495274*m2_7;
    const iiwa_real u1_7 = 2.069591277495274*ud1_7;
    const iiwa_real pivot6 = m6_6 - m6_7*u6_7;
    const iiwa_real ipivot6 = 1.0 / pivot6;
    const iiwa_real ud5_6 = k6_yz - m6_7*u5_7;
    const iiwa_real u5_6 = ipivot6*ud5_6;
    const iiwa_real ud4_6 = m4_6 - m6_7*u4_7;
    const iiwa_real u4_6 = ipivot6*ud4_6;
    const iiwa_real t125 = c4*k6_yz + s4*t120;
    const iiwa_real ud3_6 = t125 - m6_7*u3_7;
    const iiwa_real u3_6 = ipivot6*ud3_6;
    const iiwa_real ud2_6 = m2_6 - m6_7*u2_7;
    const iiwa_real u2_6 = ipivot6*ud2_6;
    const iiwa_real ud1_6 = c2*t125 - s2*(c3*t121 - s3*t119) - m6_7*u1_7;
    const iiwa_real u1_6 = ipivot6*ud1_6;
    const iiwa_real pivot5 = m5_5 + nu6_y*u5_7 - ud5_6*u5_6;
    const iiwa_real ipivot5 = 1.0 / pivot5;
    const iiwa_real ud4_5 = m4_5 + nu6_y*u4_7 - ud5_6*u4_6;
    const iiwa_real u4_5 = ipivot5*ud4_5;
    const iiwa_real ud3_5 = nu4_y + nu6_y*u3_7 - ud5_6*u3_6;
    const iiwa_real u3_5 = ipivot5*ud3_5;
    const iiwa_real ud2_5 = m2_5 + nu6_y*u2_7 - ud5_6*u2_6;
    const iiwa_real u2_5 = ipivot5*ud2_5;
    const iiwa_real ud1_5 = c2*nu4_y - s2*(nu3_x - 0.4*fu3_y) + nu6_y*u1_7 - ud5_6*u1_6;
    const iiwa_real u1_5 = ipivot5*ud1_5;
    const iiwa_real pivot4 = m4_4 - m4_7*u4_7 - ud4_6*u4_6 - ud4_5*u4_5;
    const iiwa_real ipivot4 = 1.0 / pivot4;
    const iiwa_real neg_ud3_4 = k4_yz + m4_7*u3_7 + ud4_6*u3_6 + ud4_5*u3_5;
    const iiwa_real u3_4 = -ipivot4*neg_ud3_4;
    const iiwa_real ud2_4 = m2_4 - m4_7*u2_7 - ud4_6*u2_6 - ud4_5*u2_5;
    const iiwa_real u2_4 = ipivot4*ud2_4;
    const iiwa_real t126 = -ud4_6*u1_6 - (c2*k4_yz - s2*(c3*k4_xz - s3*t113) + m4_7*u1_7);
    const iiwa_real ud1_4 = t126 - ud4_5*u1_5;
    const iiwa_real u1_4 = ipivot4*ud1_4;
    const iiwa_real pivot3 = neg_ud3_4*u3_4 - (ud3_7*u3_7 - m3_3 + ud3_6*u3_6 + ud3_5*u3_5);
    const iiwa_real ipivot3 = 1.0 / pivot3;
    const iiwa_real ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 + neg_ud3_4*u2_4;
    const iiwa_real u2_3 = ipivot3*ud2_3;
    const iiwa_real ud1_3 = neg_ud3_4*u1_4 - (ud3_7*u1_7 - neg_nu2_y + ud3_6*u1_6 + ud3_5*u1_5);
    const iiwa_real u1_3 = ipivot3*ud1_3;
    const iiwa_real pivot2 = -ud2_4*u2_4 - (neg_m2_2 + m2_7*u2_7 + ud2_6*u2_6 + ud2_5*u2_5) -
        ud2_3*u2_3;
    const iiwa_real ipivot2 = 1.0 / pivot2;
    const iiwa_real ud1_2 = k2_yz - m2_7*u1_7 - ud2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3;
    const iiwa_real u1_2 = ipivot2*ud1_2;
    const iiwa_real t127 = m1_1 - ud1_7*u1_7 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3;
    const iiwa_real pivot1 = t127 - ud1_2*u1_2;
    const iiwa_real ipivot1 = 1.0 / pivot1;
    /* link 6: forward substitution */
    const iiwa_real y6 = -y7*u6_7 - (n6_z - tau[5]);
    /* link 5: forward substitution */
    const iiwa_real y5 = -u5_6*y6 - (n5_z - tau[4] + y7*u5_7);
    /* link 4: forward substitution */
    const iiwa_real y4 = -u4_5*y5 - (n4_z - tau[3] + y7*u4_7 + u4_6*y6);
    /* link 3: forward substitution */
    const iiwa_real y3 = -u3_4*y4 - (n3_z - tau[2] + y7*u3_7 + u3_6*y6 + u3_5*y5);
    /* link 2: forward substitution */
    const iiwa_real neg_y2 = n2_z - tau[1] + y7*u2_7 + u2_6*y6 + u2_5*y5 + u2_4*y4 + u2_3*y3;
    const iiwa_real t128 = n1_z - tau[0] + y7*u1_7 + u1_6*y6 + u1_5*y5 + u1_4*y4 + u1_3*y3;
    /* link 1: forward substitution */
    const iiwa_real y1 = u1_2*neg_y2 - t128;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd2 = -u1_2*qdd1 - ipivot2*neg_y2;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd5 = ipivot5*y5 - u4_5*qdd4 - u3_5*qdd3 - u2_5*qdd2 - u1_5*qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd6 = ipivot6*y6 - u5_6*qdd5 - u4_6*qdd4 - u3_6*qdd3 - u2_6*qdd2 - u1_6*qdd1;
    const iiwa_real t129 = -u2_7*qdd2 - (u6_7*qdd6 - 2.069591277495274*y7 + u5_7*qdd5 + u4_7*qdd4 +
        u3_7*qdd3);
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd7 = t129 - u1_7*qdd1;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
