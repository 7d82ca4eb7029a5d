/*
 * iiwa: KUKA iiwa 14 geometry, random full inertias
 * Numbers: published iiwa geometry; inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
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
 *   seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 258 multiplications, 247 additions = 505; 6 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 243 multiplications, 227 additions = 470; 7 unary minus; 12 sine/cosine
 *   mass_matrix: 133 multiplications, 125 additions = 258; 6 unary minus; 12 sine/cosine
 *   forward_dynamics: 500 multiplications, 455 additions, 6 divisions = 961; 18 unary minus; 12
 *       sine/cosine
 */
#include "iiwa.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 258 multiplications, 247 additions = 505; 6 unary minus; 12 sine/cosine */
void iiwa_inverse_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real qdd[7],
    iiwa_real tau[7])
{
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(q[1]);
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
    const iiwa_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y + (s3*qdd[1] + alpha2_x*c3);
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
    const iiwa_real lam3_31 = ww3_zx - alpha3_y;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(q[3]);
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
    const iiwa_real s5 = sin(q[4]);
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
    const iiwa_real s6 = sin(q[5]);
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
    const iiwa_real s7 = sin(q[6]);
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
    const iiwa_real alpha4_x = s4*alpha3_z + (qd[3]*w4_y + alpha3_x*c4);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz + alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real lam4_22 = t1 - neg_lam5_22;
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
    const iiwa_real neg_alpha5_y = s5*alpha4_x + w5_x*qd[4] + alpha4_z*c5;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_z = qdd[5] - neg_alpha5_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha6_z;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x - (s6*alpha5_z - qd[5]*w6_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha6_z;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t7 = 0.150926706942488*s7;
    const iiwa_real t8 = 0.3999801598546772*c7;
    const iiwa_real t9 = t7*t8;
    const iiwa_real t10 = c7*c7;
    const iiwa_real t11 = 1.6791988194353373*t9 - 0.2114247825686032*(t10 + (t10 - 1.0));
    const iiwa_real t12 = qd[6] + w7_z;
    const iiwa_real t13 = alpha6_x + w6_z*t12;
    const iiwa_real t14 = w6_x*t12 - alpha6_z;
    const iiwa_real t15 = 0.10136935104159488*t10 + 7.004567783863868*(t9 + 0.027254918056712832);
    const iiwa_real t16 = t15 - 0.48318719298539553;
    const iiwa_real t17 = t8 - 0.283322719186478*s7;
    const iiwa_real t18 = c7 - 1.886194582347621*t17;
    const iiwa_real t19 = 0.6146235514133187*t18;
    const iiwa_real t20 = 24.525*s2;
    const iiwa_real t21 = c3*t20;
    const iiwa_real t22 = lam3_13 - t21;
    const iiwa_real t23 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t24 = c4*t22 - s4*t23;
    const iiwa_real t25 = lam4_12 + t24;
    const iiwa_real t26 = s3*t20;
    const iiwa_real t27 = lam3_23 + t26;
    const iiwa_real t28 = t27 - lam4_32;
    const iiwa_real t29 = c5*t25 + s5*t28;
    const iiwa_real t30 = s4*t22 + c4*t23;
    const iiwa_real t31 = t30 - lam4_22;
    const iiwa_real t32 = c6*t29 + s6*t31;
    const iiwa_real t33 = t11*t13 + t14*t16 - (t6*t19 - 0.516451399126078*(t32 -
        3.9286492336466137*lam6_12)) + 0.4239952187044951*lam6_21;
    const iiwa_real t34 = s6*t29 - c6*t31;
    const iiwa_real t35 = t7 - 0.32845591866705903*c7;
    const iiwa_real t36 = neg_lam5_22 + lam6_22;
    const iiwa_real t37 = t33 - ((t17 - 0.6262523039785531)*t34 - t35*(t4 + lam6_22)) -
        0.0870114460092663*lam6_13 + 0.36144292274665746*(t3 - t36);
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = t37 - 0.042925575293549574*lam6_23;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx + neg_alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t38 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = n6_z - 0.10101181803004346*(t31 - 0.40735671351278135*(t1 - t38) +
        0.562393163526197*lam5_12) - 0.09474888781047501*lam5_31 + 0.03284626166448073*lam5_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy + alpha5_z;
    const iiwa_real t39 = -ww6_zx - alpha7_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_31 = -qdd[6] - t39;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t40 = 0.2166040477707155*(s7 - 5.3266962774999085*t18);
    const iiwa_real t41 = s5*t25 - c5*t28;
    const iiwa_real t42 = t16*t39 + lam6_12*t19 + (t3*t11 + t32*t40 - (t17*t41 - t35*lam6_32));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t6*t15 + t42;
    const iiwa_real t43 = t11*t14 + 0.20655564034097101*lam6_23 + 0.36144292274665746*lam6_31 +
        (0.0870114460092663*t36 + t35*t39 - t13*t15);
    const iiwa_real t44 = 0.516451399126078*t41 - (t43 + (-2.0289563933923875*lam6_32 - t2*t19) +
        t34*(t40 - 0.16772238154175834) - 0.042925575293549574*lam6_21);
    const iiwa_real t45 = 0.0870114460092663*(lam6_12 - 4.872867170364478*lam6_31) - (nc7_z +
        0.6262523039785531*t41) + 0.20655564034097101*lam6_13 + 0.16772238154175834*(t32 +
        2.155007098183065*lam6_32 - 0.25593230252852256*t3);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = c6*t44 - s6*t45 - 0.05680835589544868*(t1 - 0.7243272854859414*(lam5_21 -
        0.7982499176974512*lam5_31));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_13 = ww4_zx + alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx - neg_alpha5_y;
    const iiwa_real t46 = 0.05680835589544868*lam5_13 - s6*t44 + 0.03284626166448073*(t38 -
        1.2527404987206214*lam5_23) + 0.09474888781047501*lam5_21 - c6*t45;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = 0.10101181803004346*t41 + t46;
    const iiwa_real t47 = neg_lam4_11 + lam4_22;
    const iiwa_real t48 = 0.16772238154175834*neg_lam5_22 - (t5*t40 - 0.516451399126078*lam6_32 -
        0.6262523039785531*lam6_31) + t17*t39 + 0.10101181803004346*lam5_21;
    const iiwa_real t49 = t13*t40 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 - t14*t17;
    const iiwa_real t50 = t4*t17 - t6*t40 - 0.6262523039785531*neg_lam6_11 -
        0.16772238154175834*lam6_13 + 0.516451399126078*lam6_12;
    const iiwa_real t51 = s6*t49 + c6*t50 - 0.10101181803004346*neg_lam5_11;
    const iiwa_real t52 = s5*t48 - c5*t51;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = 3.221934173968582*(-0.00407339877875826*lam4_23 - (t24 +
        1.1078721061879098*lam4_12 + 0.03002866125812244*lam4_13 - 0.07713506882125255*lam4_21)) -
        (0.20921122087079386*t47 + s5*n5_x + (t52 + (c5*n5_y - 0.2067207712712513*t30)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - alpha3_z;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t53 = 0.2067207712712513*(1.2125863432641177*lam4_13 - t27 -
        1.2022212993802541*lam4_31) + (n5_z + 0.09675036990607108*lam4_12) +
        0.20921122087079386*lam4_32;
    const iiwa_real t54 = ww4_zz - ww4_yy;
    const iiwa_real t55 = t53 + 0.013124222729483126*(t47 + t54);
    const iiwa_real t56 = s5*t51 + c5*t48;
    const iiwa_real t57 = s5*n5_y + 0.20921122087079386*(lam4_31 - 0.06273192553848952*lam4_21) -
        (t56 + 0.09675036990607108*t54 + c5*n5_x);
    const iiwa_real t58 = t57 + 0.2506667841125447*lam4_23 + 3.221934173968582*t27 -
        3.569490999313376*lam4_32;
    const iiwa_real t59 = ww3_zz - ww3_yy;
    const iiwa_real t60 = ww3_xx - ww3_zz;
    const iiwa_real t61 = c4*t55 + 0.40382182094267666*alpha3_z - s4*t58 +
        0.0816122074936837*(lam3_13 - 4.983886823520953*t26) + 0.1005265342798281*(t59 + t60);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t61 - 0.24444456225550676*(lam3_23 + 0.07183008482147359*t21);
    const iiwa_real t62 = c4*t58 - (t56 - (s4*t55 - 0.40382182094267666*alpha3_x) +
        3.221934173968582*lam4_32 - 0.1005265342798281*lam3_31);
    const iiwa_real t63 = t62 + 0.43062156604456925*c2 - 0.24444456225550676*lam3_21 +
        0.2067207712712513*lam4_31 + 0.0816122074936837*t59;
    const iiwa_real t64 = s4*(s6*t50 - 0.2067207712712513*lam4_21 - c6*t49 +
        3.221934173968582*lam4_22 - 0.10101181803004346*lam5_31);
    const iiwa_real t65 = 0.40382182094267666*(alpha3_y - 0.6053277697695444*t60 +
        24.70259225523076*c2) - (n4_z + t64) + 0.1005265342798281*lam3_32 -
        0.0816122074936837*lam3_12;
    const iiwa_real t66 = c4*(t52 + 3.221934173968582*lam4_12 + 0.2067207712712513*neg_lam4_11) +
        t65;
    const iiwa_real t67 = c2 + 1.3168563631156125*s2;
    const iiwa_real t68 = 0.41715488532235584*c2 - 0.15257424953911117*t67;
    const iiwa_real t69 = 3.509903939799839*c2;
    const iiwa_real t70 = c2*t69;
    const iiwa_real t71 = s2*t69;
    const iiwa_real t72 = qd[0]*(t71 + 0.29735998936351243*(t70 - 1.7549519698999194));
    const iiwa_real t73 = qdd[0]*(t70 - 4.842302505434623 - 0.29735998936351243*t71) -
        (2.0*(qd[1]*t72) + c2*n3_z) + 0.20091837135316784*(ww2_zz*t67);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t63 + s3*t66) + qdd[1]*t68 - t73;
    const iiwa_real t74 = qd[0]*t72 - (c3*t66 - s3*t63 + 4.563077810408968*(qdd[1] +
        2.9130293283131543*(c2 - 5.768255406554391*s2)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = qdd[0]*t68 - t74;
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
    /* sines and cosines of the joint angles */
    const iiwa_real s7 = sin(q[6]);
    const iiwa_real c7 = cos(q[6]);
    /* link 7: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const iiwa_real hw7_y = 9.809513420435959*s7 + 6.948489688048372*c7;
    /* sines and cosines of the joint angles */
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s2 = sin(q[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s4 = sin(q[3]);
    const iiwa_real s5 = sin(q[4]);
    const iiwa_real s3 = sin(q[2]);
    const iiwa_real s6 = sin(q[5]);
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
 * 243 multiplications, 227 additions = 470; 7 unary minus; 12 sine/cosine */
void iiwa_bias(const iiwa_real q[7], const iiwa_real qd[7], iiwa_real tau[7])
{
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(q[1]);
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
    const iiwa_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y + ww2_yz*c3;
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
    const iiwa_real lam3_31 = ww3_zx - alpha3_y;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(q[3]);
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
    const iiwa_real s5 = sin(q[4]);
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
    const iiwa_real s6 = sin(q[5]);
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
    const iiwa_real s7 = sin(q[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zx = w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_y = c4*ww2_zx - alpha3_x*s4 - w4_x*qd[3];
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_21 = ww3_xy + ww2_zx;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = s4*ww2_zx + (qd[3]*w4_y + alpha3_x*c4);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz + alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real lam4_22 = t1 - neg_lam5_22;
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
    const iiwa_real alpha5_x = qd[4]*w5_y + alpha3_y*s5 + c5*alpha4_x;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_z = s6*alpha5_x - (-w6_x*qd[5] - c6*alpha4_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_13 = ww6_zx - alpha7_z;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_y = -w5_x*qd[4] - s5*alpha4_x + alpha3_y*c5;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x - (s6*alpha4_y - qd[5]*w6_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t6 = neg_lam5_22 + lam6_22;
    const iiwa_real t7 = 0.150926706942488*s7;
    const iiwa_real t8 = t7 - 0.32845591866705903*c7;
    const iiwa_real t9 = 0.3999801598546772*c7;
    const iiwa_real t10 = t9 - 0.283322719186478*s7;
    const iiwa_real t11 = t10 - 0.6262523039785531;
    const iiwa_real t12 = 24.525*s2;
    const iiwa_real t13 = c3*t12;
    const iiwa_real t14 = lam3_13 - t13;
    const iiwa_real t15 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t16 = c4*t14 - s4*t15;
    const iiwa_real t17 = lam4_12 + t16;
    const iiwa_real t18 = s3*t12;
    const iiwa_real t19 = lam3_23 + t18;
    const iiwa_real t20 = t19 - lam4_32;
    const iiwa_real t21 = c5*t17 + s5*t20;
    const iiwa_real t22 = s4*t14 + c4*t15;
    const iiwa_real t23 = t22 - lam4_22;
    const iiwa_real t24 = s6*t21 - c6*t23;
    const iiwa_real t25 = c6*t21 + s6*t23;
    const iiwa_real t26 = t7*t9;
    const iiwa_real t27 = c7*c7;
    const iiwa_real t28 = 1.6791988194353373*t26 - 0.2114247825686032*(t27 + (t27 - 1.0));
    const iiwa_real t29 = qd[6] + w7_z;
    const iiwa_real t30 = alpha6_x + w6_z*t29;
    const iiwa_real t31 = alpha5_y - w6_x*t29;
    const iiwa_real t32 = 0.10136935104159488*t27 + 7.004567783863868*(t26 + 0.027254918056712832);
    const iiwa_real t33 = t32 - 0.48318719298539553;
    const iiwa_real t34 = t11*t24 - (0.4239952187044951*lam6_21 + (0.516451399126078*(t25 -
        3.9286492336466137*lam6_12) + (t28*t30 - t31*t33)));
    const iiwa_real t35 = c7 - 1.886194582347621*t10;
    const iiwa_real t36 = 0.6146235514133187*t35;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = 0.36144292274665746*(t3 - t6) + (t8*(t4 + lam6_22) - t34) -
        0.042925575293549574*lam6_23 + lam6_13*(t36 - 0.0870114460092663);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t37 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = n6_z - 0.10101181803004346*(t23 - 0.40735671351278135*(t1 - t37) +
        0.562393163526197*lam5_12) - 0.09474888781047501*lam5_31 + 0.03284626166448073*lam5_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy + alpha4_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_31 = ww6_zx + alpha7_z;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t38 = 0.2166040477707155*(s7 - 5.3266962774999085*t35);
    const iiwa_real t39 = s5*t17 - c5*t20;
    const iiwa_real t40 = lam6_12*t36 - t33*lam6_31 + (t3*t28 + t25*t38 - (t10*t39 - t8*lam6_32));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t40 - lam6_13*t32;
    const iiwa_real t41 = t38 - 0.16772238154175834;
    const iiwa_real t42 = -2.0289563933923875*lam6_32 - (t30*t32 - (0.0870114460092663*t6 - (t28*t31
        - 0.20655564034097101*lam6_23))) - t2*t36;
    const iiwa_real t43 = 0.516451399126078*t39 + (0.042925575293549574*lam6_21 - (t24*t41 + t42)) +
        lam6_31*(t8 - 0.36144292274665746);
    const iiwa_real t44 = 0.0870114460092663*(lam6_12 - 4.872867170364478*lam6_31) - (nc7_z +
        0.6262523039785531*t39) + 0.20655564034097101*lam6_13 + 0.16772238154175834*(t25 +
        2.155007098183065*lam6_32 - 0.25593230252852256*t3);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = c6*t43 - s6*t44 - 0.05680835589544868*(t1 - 0.7243272854859414*(lam5_21 -
        0.7982499176974512*lam5_31));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_13 = ww4_zx + alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx + alpha5_y;
    const iiwa_real t45 = s6*t43 - 0.05680835589544868*lam5_13 - 0.03284626166448073*(t37 -
        1.2527404987206214*lam5_23) - 0.09474888781047501*lam5_21 + c6*t44;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = 0.10101181803004346*t39 - t45;
    const iiwa_real t46 = neg_lam4_11 + lam4_22;
    const iiwa_real t47 = -0.516451399126078*lam6_32 - (0.16772238154175834*neg_lam5_22 - t5*t38) -
        0.10101181803004346*lam5_21 + t11*lam6_31;
    const iiwa_real t48 = t30*t38 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 + t31*t10;
    const iiwa_real t49 = 0.516451399126078*lam6_12 + (t4*t10 - 0.6262523039785531*neg_lam6_11) +
        lam6_13*t41;
    const iiwa_real t50 = s6*t48 + c6*t49 - 0.10101181803004346*neg_lam5_11;
    const iiwa_real t51 = s5*t47 + c5*t50;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = 3.221934173968582*(-0.00407339877875826*lam4_23 - (t16 +
        1.1078721061879098*lam4_12 + 0.03002866125812244*lam4_13 - 0.07713506882125255*lam4_21)) -
        (0.20921122087079386*t46 + s5*n5_x - (t51 - (c5*n5_y - 0.2067207712712513*t22)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t52 = 0.2067207712712513*(1.2125863432641177*lam4_13 - t19 -
        1.2022212993802541*lam4_31) + (n5_z + 0.09675036990607108*lam4_12) +
        0.20921122087079386*lam4_32;
    const iiwa_real t53 = ww4_zz - ww4_yy;
    const iiwa_real t54 = t52 + 0.013124222729483126*(t46 + t53);
    const iiwa_real t55 = s5*t50 - c5*t47;
    const iiwa_real t56 = s5*n5_y + 0.20921122087079386*(lam4_31 - 0.06273192553848952*lam4_21) -
        (t55 + 0.09675036990607108*t53 + c5*n5_x);
    const iiwa_real t57 = t56 + 0.2506667841125447*lam4_23 + 3.221934173968582*t19 -
        3.569490999313376*lam4_32;
    const iiwa_real t58 = ww3_zz - ww3_yy;
    const iiwa_real t59 = ww3_xx - ww3_zz;
    const iiwa_real t60 = c4*t54 + 0.40382182094267666*ww2_zx - s4*t57 + 0.0816122074936837*(lam3_13
        - 4.983886823520953*t18) + 0.1005265342798281*(t58 + t59);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t60 - 0.24444456225550676*(lam3_23 + 0.07183008482147359*t13);
    const iiwa_real t61 = c4*t57 - (t55 - (s4*t54 - 0.40382182094267666*alpha3_x) +
        3.221934173968582*lam4_32 - 0.1005265342798281*lam3_31);
    const iiwa_real t62 = t61 + 0.43062156604456925*c2 - 0.24444456225550676*lam3_21 +
        0.2067207712712513*lam4_31 + 0.0816122074936837*t58;
    const iiwa_real t63 = s4*(s6*t49 - 0.2067207712712513*lam4_21 - c6*t48 +
        3.221934173968582*lam4_22 - 0.10101181803004346*lam5_31);
    const iiwa_real t64 = 0.40382182094267666*(alpha3_y - 0.6053277697695444*t59 +
        24.70259225523076*c2) - (n4_z + t63) + 0.1005265342798281*lam3_32 -
        0.0816122074936837*lam3_12;
    const iiwa_real t65 = c4*(t51 - 3.221934173968582*lam4_12 - 0.2067207712712513*neg_lam4_11) -
        t64;
    const iiwa_real t66 = 3.509903939799839*c2;
    const iiwa_real t67 = qd[0]*(s2*t66 + 0.29735998936351243*(c2*t66 - 1.7549519698999194));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t62 - s3*t65) + (2.0*(qd[1]*t67) + c2*n3_z -
        0.20091837135316784*(ww2_zz*(c2 + 1.3168563631156125*s2)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = 13.292379489096295*(c2 - 5.768255406554391*s2) - (c3*t65 + s3*t62) -
        qd[0]*t67;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 133 multiplications, 125 additions = 258; 6 unary minus; 12 sine/cosine */
void iiwa_mass_matrix(const iiwa_real q[7], iiwa_real M[49])
{
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(q[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(q[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(q[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(q[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(q[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(q[6]);
    const iiwa_real t1 = 0.150926706942488*s7;
    const iiwa_real t2 = 0.32845591866705903*c7;
    const iiwa_real t3 = t1 - t2;
    const iiwa_real t4 = c7 + 8.666599685695806*t3;
    const iiwa_real t5 = t4 - 35.29326509144399*t1;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_7 = 0.08173239305750822*t5;
    const iiwa_real t6 = -m6_7 - 0.0870114460092663;
    const iiwa_real t7 = 1.2873860421003098*t2;
    const iiwa_real t8 = c7*t7 - 0.25435035786215276;
    const iiwa_real t9 = s7*t7;
    const iiwa_real t10 = t8 - 0.23972911266611452*t9;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xz = s6*t6 + c6*t10;
    const iiwa_real k6_yz = s6*t10 - c6*t6;
    const iiwa_real t11 = t9 + (0.23972911266611452*t8 + 1.3736580882709999);
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real neg_m6_6 = t11 - 4.057912786784775;
    const iiwa_real t12 = c6*t11;
    const iiwa_real t13 = 0.48318719298539553*c6;
    const iiwa_real t14 = 4.139182554990548*(t13*(t3 - 0.36144292274665746));
    const iiwa_real t15 = c6*t12 + (s6*t14 - 5.266399726626112);
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = neg_m6_6 - t15;
    const iiwa_real t16 = t3 - (c6*t14 + 0.4025907649653271) + s6*t12;
    const iiwa_real t17 = -k6_yz - 0.05680835589544868;
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_yz = s5*t16 + c5*t17;
    const iiwa_real t18 = 0.09953035942575048*(c7 - t5);
    const iiwa_real t19 = t18 + 0.16772238154175834;
    const iiwa_real t20 = 0.2166040477707155*t4;
    const iiwa_real t21 = t20 + 0.6262523039785531;
    const iiwa_real t22 = 0.516451399126078*s6;
    const iiwa_real t23 = c6*t21 - t22;
    const iiwa_real t24 = t23 + 0.10101181803004346;
    const iiwa_real t25 = c5*t19 - s5*t24;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = k5_yz + t25;
    const iiwa_real t26 = c5*s5;
    const iiwa_real t27 = t15 + (t11 + 2.227476104061723);
    const iiwa_real t28 = k6_xz - 0.06569252332896146;
    const iiwa_real t29 = k6_xz + t28;
    const iiwa_real t30 = c5*c5;
    const iiwa_real t31 = t26*t27 + 0.019722038934997604 + (t28 - t29*t30);
    const iiwa_real t32 = m4_5 - 0.09675036990607108;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xz = c4*t31 + s4*t32;
    const iiwa_real t33 = s6*t21 + 1.0688433108815611*t13;
    const iiwa_real t34 = t33 + 3.221934173968582;
    const iiwa_real t35 = neg_m6_6 - t33;
    const iiwa_real t36 = t34 - t35;
    const iiwa_real t37 = t26*t29 + (t30*t27 + 0.19378159890865698);
    const iiwa_real t38 = t37 - (t27 + 0.884611426310538);
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t36 - t38;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real neg_k4_yz = c4*t32 - s4*t31;
    const iiwa_real t39 = s5*t19 + c5*t24;
    const iiwa_real t40 = t39 - c5*t16 + s5*t17;
    const iiwa_real t41 = s4*t40;
    const iiwa_real t42 = 0.4184224417415877*(s4 + 4.7798583452538*t41);
    const iiwa_real t43 = s4*(t37 + t36 - m5_5);
    const iiwa_real t44 = c4*t42 + (s4*t43 + 0.9030127193018334);
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = m5_5 + t44;
    const iiwa_real t45 = t39 + 0.2067207712712513;
    const iiwa_real t46 = t40 + (c4*(t43 + t45) + 0.4536557831263006 - s4*(t42 - t34));
    const iiwa_real t47 = t25 - (0.0816122074936837 - neg_k4_yz);
    const iiwa_real t48 = c3*t46 + s3*t47;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y = c2*m3_3 - s2*t48;
    const iiwa_real t49 = t37 + (t38 + 1.4022036176609902) - t44;
    const iiwa_real t50 = c3*t49;
    const iiwa_real t51 = c3*k4_xz;
    const iiwa_real t52 = 0.2010530685596562*c3 + 2.0*t51;
    const iiwa_real t53 = c3*t50 + 3.9137257607425155 - s3*t52;
    const iiwa_real t54 = c4*t34 - s4*t45;
    const iiwa_real t55 = t54 + m4_4;
    const iiwa_real t56 = t54 + t55;
    const iiwa_real t57 = t53 + t56;
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = t57 - (c2*(c2*t57 + (s2*(t48 - 1.0437049982058304) - neg_nu2_y)) -
        1.3323985656347848);
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = s3*t46 - c3*t47;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_yz = c2*(m2_3 + 0.26458063578324464) + s2*(k4_xz - (c3*t52 + (s3*t50 +
        0.10039183707333973)));
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_y = t41 + c4*m5_5;
    const iiwa_real t58 = s5*t35 - c5*k6_xz;
    const iiwa_real nu4_x = c4*t58 - s4*k6_yz;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = c5*t35 + s5*k6_xz;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_y = s6*t3 - t13;
    const iiwa_real nu6_x = c6*t3 + 0.9355908296560508*t22;
    const iiwa_real t59 = c6*t18;
    const iiwa_real t60 = s5*t20 - c5*t59;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = -s5*nu6_x - (t60 + c5*m6_7);
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = t49 + t56 + 8.88062539209416 - t53;
    const iiwa_real m2_4 = -s3*k4_xz - c3*t55;
    const iiwa_real t61 = t39 + c4*t40 - s4*m5_5;
    const iiwa_real t62 = m4_5 + c4*t25;
    const iiwa_real m2_5 = s3*t61 - c3*t62;
    const iiwa_real t63 = c4*(c5*t33) - s4*t23 - m4_6;
    const iiwa_real t64 = s5*t33 - nu4_x;
    const iiwa_real m2_6 = c3*t63 - s3*t64;
    const iiwa_real t65 = c5*t20 + s5*t59;
    const iiwa_real t66 = c5*nu6_x + t65 - s5*m6_7;
    const iiwa_real t67 = c4*t66 + (t65 + s4*nu6_y);
    const iiwa_real t68 = t18*(s4*s6) - (c4*t60 - m4_7);
    const iiwa_real m2_7 = s3*t67 - c3*t68;
    const iiwa_real t69 = c2*neg_k4_yz + s2*(t51 - s3*t55);
    const iiwa_real t70 = c2*nu4_y - s2*(c3*t61 + s3*t62);
    const iiwa_real t71 = s4*t58 + c4*k6_yz;
    const iiwa_real t72 = c2*t71 + s2*(c3*t64 + s3*t63);
    const iiwa_real t73 = s4*t66 - c4*nu6_y;
    const iiwa_real t74 = c2*t73 - s2*(c3*t67 + s3*t68);
    const iiwa_real t75 = -nu6_y;
    const iiwa_real t76 = -neg_m6_6;
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y;
    M[3] = t69;
    M[4] = t70;
    M[5] = t72;
    M[6] = t74;
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
    M[19] = t71;
    M[20] = t73;
    M[21] = t69;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = t70;
    M[29] = m2_5;
    M[30] = nu4_y;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = k6_yz;
    M[34] = t75;
    M[35] = t72;
    M[36] = m2_6;
    M[37] = t71;
    M[38] = m4_6;
    M[39] = k6_yz;
    M[40] = t76;
    M[41] = m6_7;
    M[42] = t74;
    M[43] = m2_7;
    M[44] = t73;
    M[45] = m4_7;
    M[46] = t75;
    M[47] = m6_7;
    M[48] = 0.48318719298539553;
}

/* accelerations that the torques tau give
 * 500 multiplications, 455 additions, 6 divisions = 961; 18 unary minus; 12 sine/cosine */
void iiwa_forward_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real tau[7],
    iiwa_real qdd[7])
{
    /* sines and cosines of the joint angles */
    const iiwa_real s2 = sin(q[1]);
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
    const iiwa_real s3 = sin(q[2]);
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = w2_x*c3 + qd[1]*s3;
    const iiwa_real w3_z = qd[2] - w2_y;
    const iiwa_real w3_y = qd[1]*c3 - w2_x*s3;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y + ww2_yz*c3;
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
    const iiwa_real lam3_31 = ww3_zx - alpha3_y;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    /* sines and cosines of the joint angles */
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(q[3]);
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
    const iiwa_real s5 = sin(q[4]);
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
    const iiwa_real s6 = sin(q[5]);
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
    const iiwa_real s7 = sin(q[6]);
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zx = w2_x*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real neg_alpha4_y = alpha3_x*s4 - c4*ww2_zx + w4_x*qd[3];
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_31 = ww4_zx + neg_alpha4_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_21 = ww3_xy + ww2_zx;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = s4*ww2_zx + (qd[3]*w4_y + alpha3_x*c4);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_32 = ww4_yz + alpha4_x;
    const iiwa_real t1 = ww5_zz - ww5_yy;
    const iiwa_real lam4_22 = t1 - neg_lam5_22;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_12 = ww5_xy + neg_alpha4_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_zz = w7_z*w7_z;
    const iiwa_real t2 = ww7_zz - ww6_zz;
    const iiwa_real t3 = neg_lam5_22 - neg_lam6_11;
    const iiwa_real t4 = ww6_zz + ww7_zz;
    const iiwa_real t5 = t3 + t4;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_22 = t2 - t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y + alpha3_y*s5 + c5*alpha4_x;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_z = s6*alpha5_x - (c6*neg_alpha4_y - w6_x*qd[5]);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_13 = ww6_zx - alpha7_z;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_y = -s5*alpha4_x - w5_x*qd[4] + alpha3_y*c5;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_21 = ww6_xy + alpha5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = c6*alpha5_x + (s6*neg_alpha4_y + qd[5]*w6_y);
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real t6 = neg_lam5_22 + lam6_22;
    const iiwa_real t7 = 0.150926706942488*s7;
    const iiwa_real t8 = t7 - 0.32845591866705903*c7;
    const iiwa_real t9 = 0.3999801598546772*c7;
    const iiwa_real t10 = t9 - 0.283322719186478*s7;
    const iiwa_real t11 = t10 - 0.6262523039785531;
    const iiwa_real t12 = 24.525*s2;
    const iiwa_real t13 = c3*t12;
    const iiwa_real t14 = lam3_13 - t13;
    const iiwa_real t15 = ww3_yy + (ww3_xx - 24.525*c2);
    const iiwa_real t16 = c4*t14 - s4*t15;
    const iiwa_real t17 = lam4_12 + t16;
    const iiwa_real t18 = s3*t12;
    const iiwa_real t19 = lam3_23 + t18;
    const iiwa_real t20 = t19 - lam4_32;
    const iiwa_real t21 = c5*t17 + s5*t20;
    const iiwa_real t22 = s4*t14 + c4*t15;
    const iiwa_real t23 = t22 - lam4_22;
    const iiwa_real t24 = s6*t21 - c6*t23;
    const iiwa_real t25 = c6*t21 + s6*t23;
    const iiwa_real t26 = t7*t9;
    const iiwa_real t27 = c7*c7;
    const iiwa_real t28 = 1.6791988194353373*t26 - 0.2114247825686032*(t27 + (t27 - 1.0));
    const iiwa_real t29 = qd[6] + w7_z;
    const iiwa_real t30 = alpha6_x + w6_z*t29;
    const iiwa_real t31 = alpha5_y - w6_x*t29;
    const iiwa_real t32 = 0.10136935104159488*t27 + 7.004567783863868*(t26 + 0.027254918056712832);
    const iiwa_real t33 = t32 - 0.48318719298539553;
    const iiwa_real t34 = t11*t24 - (0.4239952187044951*lam6_21 + (0.516451399126078*(t25 -
        3.9286492336466137*lam6_12) + (t28*t30 - t31*t33)));
    const iiwa_real t35 = c7 - 1.886194582347621*t10;
    const iiwa_real t36 = 0.6146235514133187*t35;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_z = 0.36144292274665746*(t3 - t6) + (t8*(t4 + lam6_22) - t34) -
        0.042925575293549574*lam6_23 + lam6_13*(t36 - 0.0870114460092663);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = ww5_yz + alpha5_x;
    const iiwa_real t37 = ww5_xx - ww5_yy;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_y = n6_z - 0.10101181803004346*(t23 - 0.40735671351278135*(t1 - t37) +
        0.562393163526197*lam5_12) - 0.09474888781047501*lam5_31 + 0.03284626166448073*lam5_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_zz + ww5_yy;
    const iiwa_real lam5_21 = ww5_xy - neg_alpha4_y;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam6_31 = ww6_zx + alpha7_z;
    const iiwa_real lam6_32 = ww6_yz + alpha6_x;
    const iiwa_real t38 = 0.2166040477707155*(s7 - 5.3266962774999085*t35);
    const iiwa_real t39 = s5*t17 - c5*t20;
    const iiwa_real t40 = lam6_12*t36 - t33*lam6_31 + (t3*t28 + t25*t38 - (t10*t39 - t8*lam6_32));
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_z = t40 - lam6_13*t32;
    const iiwa_real t41 = t38 - 0.16772238154175834;
    const iiwa_real t42 = -2.0289563933923875*lam6_32 - (t30*t32 - (0.0870114460092663*t6 - (t28*t31
        - 0.20655564034097101*lam6_23))) - t2*t36;
    const iiwa_real t43 = t8 - 0.36144292274665746;
    const iiwa_real t44 = 0.516451399126078*t39 + (0.042925575293549574*lam6_21 - (t24*t41 + t42)) +
        lam6_31*t43;
    const iiwa_real t45 = 0.0870114460092663*(lam6_12 - 4.872867170364478*lam6_31) - (nc7_z +
        0.6262523039785531*t39) + 0.20655564034097101*lam6_13 + 0.16772238154175834*(t25 +
        2.155007098183065*lam6_32 - 0.25593230252852256*t3);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = c6*t44 - s6*t45 - 0.05680835589544868*(t1 - 0.7243272854859414*(lam5_21 -
        0.7982499176974512*lam5_31));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_13 = ww4_zx - neg_alpha4_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_13 = ww5_zx + alpha5_y;
    const iiwa_real t46 = s6*t44 - 0.05680835589544868*lam5_13 - 0.03284626166448073*(t37 -
        1.2527404987206214*lam5_23) - 0.09474888781047501*lam5_21 + c6*t45;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_z = 0.10101181803004346*t39 - t46;
    const iiwa_real t47 = neg_lam4_11 + lam4_22;
    const iiwa_real t48 = -0.516451399126078*lam6_32 - (0.16772238154175834*neg_lam5_22 - t5*t38) -
        0.10101181803004346*lam5_21 + t11*lam6_31;
    const iiwa_real t49 = t30*t38 + 0.16772238154175834*lam6_23 - 0.6262523039785531*lam6_21 -
        0.516451399126078*lam6_22 + t10*t31;
    const iiwa_real t50 = 0.516451399126078*lam6_12 + (t4*t10 - 0.6262523039785531*neg_lam6_11) +
        lam6_13*t41;
    const iiwa_real t51 = s6*t49 + c6*t50 - 0.10101181803004346*neg_lam5_11;
    const iiwa_real t52 = s5*t48 + c5*t51;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_z = 3.221934173968582*(-0.00407339877875826*lam4_23 - (t16 +
        1.1078721061879098*lam4_12 + 0.03002866125812244*lam4_13 - 0.07713506882125255*lam4_21)) -
        (0.20921122087079386*t47 + s5*n5_x - (t52 - (c5*n5_y - 0.2067207712712513*t22)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real lam3_12 = ww3_xy - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_zz = qd[1]*qd[1];
    const iiwa_real t53 = 0.2067207712712513*(1.2125863432641177*lam4_13 - t19 -
        1.2022212993802541*lam4_31) + (n5_z + 0.09675036990607108*lam4_12) +
        0.20921122087079386*lam4_32;
    const iiwa_real t54 = ww4_zz - ww4_yy;
    const iiwa_real t55 = t53 + 0.013124222729483126*(t47 + t54);
    const iiwa_real t56 = s5*t51 - c5*t48;
    const iiwa_real t57 = s5*n5_y + 0.20921122087079386*(lam4_31 - 0.06273192553848952*lam4_21) -
        (t56 + 0.09675036990607108*t54 + c5*n5_x);
    const iiwa_real t58 = t57 + 0.2506667841125447*lam4_23 + 3.221934173968582*t19 -
        3.569490999313376*lam4_32;
    const iiwa_real t59 = ww3_zz - ww3_yy;
    const iiwa_real t60 = ww3_xx - ww3_zz;
    const iiwa_real t61 = c4*t55 + 0.40382182094267666*ww2_zx - s4*t58 + 0.0816122074936837*(lam3_13
        - 4.983886823520953*t18) + 0.1005265342798281*(t59 + t60);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_z = t61 - 0.24444456225550676*(lam3_23 + 0.07183008482147359*t13);
    const iiwa_real t62 = c4*t58 - (t56 - (s4*t55 - 0.40382182094267666*alpha3_x) +
        3.221934173968582*lam4_32 - 0.1005265342798281*lam3_31);
    const iiwa_real t63 = t62 + 0.43062156604456925*c2 - 0.24444456225550676*lam3_21 +
        0.2067207712712513*lam4_31 + 0.0816122074936837*t59;
    const iiwa_real t64 = s4*(s6*t50 - 0.2067207712712513*lam4_21 - c6*t49 +
        3.221934173968582*lam4_22 - 0.10101181803004346*lam5_31);
    const iiwa_real t65 = 0.40382182094267666*(alpha3_y - 0.6053277697695444*t60 +
        24.70259225523076*c2) - (n4_z + t64) + 0.1005265342798281*lam3_32 -
        0.0816122074936837*lam3_12;
    const iiwa_real t66 = c4*(t52 - 3.221934173968582*lam4_12 - 0.2067207712712513*neg_lam4_11) -
        t65;
    const iiwa_real t67 = 3.509903939799839*c2;
    const iiwa_real t68 = qd[0]*(s2*t67 + 0.29735998936351243*(c2*t67 - 1.7549519698999194));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = s2*(c3*t63 - s3*t66) + (2.0*(qd[1]*t68) + c2*n3_z -
        0.20091837135316784*(ww2_zz*(c2 + 1.3168563631156125*s2)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = 13.292379489096295*(c2 - 5.768255406554391*s2) - (c3*t66 + s3*t63) -
        qd[0]*t68;
    const iiwa_real t69 = c7 + 8.666599685695806*t8;
    const iiwa_real t70 = t69 - 5.3266962774999085*s7;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_7 = 0.08173239305750822*t70;
    const iiwa_real t71 = 0.4228495651372064*c7;
    const iiwa_real t72 = c7*t71 - 0.25435035786215276;
    const iiwa_real t73 = s7*t71;
    const iiwa_real t74 = t72 - 0.23972911266611452*t73;
    const iiwa_real t75 = 0.0870114460092663 + m6_7;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xz = c6*t74 - s6*t75;
    const iiwa_real k6_yz = s6*t74 + c6*t75;
    const iiwa_real t76 = t73 + (0.23972911266611452*t72 + 1.3736580882709999);
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 4.057912786784775 - t76;
    const iiwa_real t77 = 0.48318719298539553*c6;
    const iiwa_real t78 = 4.139182554990548*(t43*t77);
    const iiwa_real t79 = c6*t76;
    const iiwa_real t80 = 5.266399726626112 - s6*t78 - c6*t79;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t80 - m6_6;
    const iiwa_real t81 = t8 - (c6*t78 + 0.4025907649653271) + s6*t79;
    const iiwa_real t82 = k6_yz + 0.05680835589544868;
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_yz = s5*t81 - c5*t82;
    const iiwa_real t83 = 0.09953035942575048*(c7 - t70);
    const iiwa_real t84 = 0.16772238154175834 + t83;
    const iiwa_real t85 = 0.2166040477707155*t69;
    const iiwa_real t86 = 0.6262523039785531 + t85;
    const iiwa_real t87 = c6*t86 - 0.516451399126078*s6;
    const iiwa_real t88 = t87 + 0.10101181803004346;
    const iiwa_real t89 = c5*t84 - s5*t88;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = k5_yz + t89;
    const iiwa_real t90 = c5*s5;
    const iiwa_real t91 = t76 + 2.227476104061723 - t80;
    const iiwa_real t92 = 0.06569252332896146 - k6_xz;
    const iiwa_real t93 = t92 - k6_xz;
    const iiwa_real t94 = c5*c5;
    const iiwa_real t95 = t90*t91 + 0.019722038934997604 - (t92 - t93*t94);
    const iiwa_real t96 = m4_5 - 0.09675036990607108;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xz = c4*t95 + s4*t96;
    const iiwa_real t97 = s6*t86 + 0.516451399126078*c6;
    const iiwa_real t98 = t97 + 3.221934173968582;
    const iiwa_real t99 = -m6_6 - t97;
    const iiwa_real t100 = t98 - t99;
    const iiwa_real t101 = t90*t93 - (t91*t94 + 0.19378159890865698);
    const iiwa_real t102 = t101 + (t91 + 0.884611426310538);
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t100 + t102;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_yz = s4*t95 - c4*t96;
    const iiwa_real t103 = s5*t84 + c5*t88;
    const iiwa_real t104 = t103 - c5*t81 - s5*t82;
    const iiwa_real t105 = s4*t104;
    const iiwa_real t106 = 0.4184224417415877*(s4 + 4.7798583452538*t105);
    const iiwa_real t107 = s4*(m5_5 - (t100 - t101));
    const iiwa_real t108 = c4*t106 - (s4*t107 - 0.9030127193018334);
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = m5_5 + t108;
    const iiwa_real t109 = t103 + 0.2067207712712513;
    const iiwa_real t110 = t104 - (c4*(t107 - t109) - 0.4536557831263006 - s4*(t98 - t106));
    const iiwa_real t111 = t89 - (k4_yz + 0.0816122074936837);
    const iiwa_real t112 = c3*t110 + s3*t111;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y = s2*t112 - c2*m3_3;
    const iiwa_real t113 = t108 + (t101 + (t102 - 1.4022036176609902));
    const iiwa_real t114 = c3*t113;
    const iiwa_real t115 = c3*k4_xz;
    const iiwa_real t116 = 0.2010530685596562*c3 + 2.0*t115;
    const iiwa_real t117 = c3*t114 - 3.9137257607425155 + s3*t116;
    const iiwa_real t118 = c4*t98 - s4*t109;
    const iiwa_real t119 = m4_4 + t118;
    const iiwa_real t120 = t118 + t119;
    const iiwa_real t121 = t117 - t120;
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = c2*(c2*t121 - (nu2_y + s2*(t112 - 1.0437049982058304))) +
        1.3323985656347848 - t121;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = s3*t110 - c3*t111;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_yz = c2*(m2_3 + 0.26458063578324464) + s2*(k4_xz - (c3*t116 - (s3*t114 -
        0.10039183707333973)));
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_y = t105 + c4*m5_5;
    const iiwa_real t122 = s5*t99 - c5*k6_xz;
    const iiwa_real nu4_x = c4*t122 - s4*k6_yz;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = c5*t99 + s5*k6_xz;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_y = s6*t8 - t77;
    const iiwa_real nu6_x = c6*t8 + 0.48318719298539553*s6;
    const iiwa_real t123 = c6*t83;
    const iiwa_real t124 = s5*t85 - c5*t123;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = -c5*m6_7 - t124 - s5*nu6_x;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = t117 - (t113 - t120 - 8.88062539209416);
    const iiwa_real m2_4 = -c3*t119 - s3*k4_xz;
    const iiwa_real t125 = t103 + c4*t104 - s4*m5_5;
    const iiwa_real t126 = m4_5 + c4*t89;
    const iiwa_real m2_5 = s3*t125 - c3*t126;
    const iiwa_real t127 = nu4_x - s5*t97;
    const iiwa_real t128 = m4_6 - (c4*(c5*t97) - s4*t87);
    const iiwa_real m2_6 = s3*t127 - c3*t128;
    const iiwa_real t129 = c5*t85 + s5*t123;
    const iiwa_real t130 = c5*nu6_x + t129 - s5*m6_7;
    const iiwa_real t131 = c4*t130 + (t129 + s4*nu6_y);
    const iiwa_real t132 = t83*(s4*s6) - (c4*t124 - m4_7);
    const iiwa_real m2_7 = s3*t131 - c3*t132;
    /* factorisation M = U D U^T */
    const iiwa_real ud3_7 = s4*t130 - c4*nu6_y;
    const iiwa_real ud1_7 = c2*ud3_7 - s2*(c3*t131 + s3*t132);
    /* link 7: forward substitution */
    const iiwa_real y7 = tau[6] - nc7_z;
    /* factorisation M = U D U^T */
    const iiwa_real u6_7 = 0.16915264776063427*t70;
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
    const iiwa_real t133 = s4*t122 + c4*k6_yz;
    const iiwa_real ud3_6 = t133 - m6_7*u3_7;
    const iiwa_real u3_6 = ipivot6*ud3_6;
    const iiwa_real ud2_6 = m2_6 - m6_7*u2_7;
    const iiwa_real u2_6 = ipivot6*ud2_6;
    const iiwa_real ud1_6 = c2*t133 - s2*(c3*t127 + s3*t128) - m6_7*u1_7;
    const iiwa_real u1_6 = ipivot6*ud1_6;
    const iiwa_real pivot5 = m5_5 + nu6_y*u5_7 - ud5_6*u5_6;
    const iiwa_real ipivot5 = 1.0 / pivot5;
    const iiwa_real ud4_5 = m4_5 + nu6_y*u4_7 - ud5_6*u4_6;
    const iiwa_real u4_5 = ipivot5*ud4_5;
    const iiwa_real ud3_5 = nu4_y + nu6_y*u3_7 - ud5_6*u3_6;
    const iiwa_real u3_5 = ipivot5*ud3_5;
    const iiwa_real ud2_5 = m2_5 + nu6_y*u2_7 - ud5_6*u2_6;
    const iiwa_real u2_5 = ipivot5*ud2_5;
    const iiwa_real ud1_5 = c2*nu4_y - s2*(c3*t125 + s3*t126) + nu6_y*u1_7 - ud5_6*u1_6;
    const iiwa_real u1_5 = ipivot5*ud1_5;
    const iiwa_real pivot4 = m4_4 - m4_7*u4_7 - ud4_6*u4_6 - ud4_5*u4_5;
    const iiwa_real ipivot4 = 1.0 / pivot4;
    const iiwa_real ud3_4 = -ud4_6*u3_6 - (k4_yz + m4_7*u3_7) - ud4_5*u3_5;
    const iiwa_real u3_4 = ipivot4*ud3_4;
    const iiwa_real ud2_4 = -ud4_5*u2_5 - (ud4_6*u2_6 - (m2_4 - m4_7*u2_7));
    const iiwa_real u2_4 = ipivot4*ud2_4;
    const iiwa_real ud1_4 = s2*(t115 - s3*t119) - c2*k4_yz - m4_7*u1_7 - ud4_6*u1_6 - ud4_5*u1_5;
    const iiwa_real u1_4 = ipivot4*ud1_4;
    const iiwa_real pivot3 = m3_3 - ud3_7*u3_7 - ud3_6*u3_6 - ud3_5*u3_5 - ud3_4*u3_4;
    const iiwa_real ipivot3 = 1.0 / pivot3;
    const iiwa_real ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 - ud3_4*u2_4;
    const iiwa_real u2_3 = ipivot3*ud2_3;
    const iiwa_real ud1_3 = -ud3_6*u1_6 - (nu2_y + ud3_7*u1_7) - ud3_5*u1_5 - ud3_4*u1_4;
    const iiwa_real u1_3 = ipivot3*ud1_3;
    const iiwa_real pivot2 = m2_2 - m2_7*u2_7 - ud2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3;
    const iiwa_real ipivot2 = 1.0 / pivot2;
    const iiwa_real ud1_2 = k2_yz - m2_7*u1_7 - ud2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3;
    const iiwa_real u1_2 = ipivot2*ud1_2;
    const iiwa_real t134 = ud1_7*u1_7 - m1_1 + ud1_6*u1_6 + ud1_5*u1_5 + ud1_4*u1_4 + ud1_3*u1_3;
    const iiwa_real pivot1 = -ud1_2*u1_2 - t134;
    const iiwa_real ipivot1 = 1.0 / pivot1;
    /* link 6: forward substitution */
    const iiwa_real y6 = tau[5] - n6_z - y7*u6_7;
    /* link 5: forward substitution */
    const iiwa_real y5 = -u5_6*y6 - (n5_z - tau[4] + y7*u5_7);
    /* link 4: forward substitution */
    const iiwa_real y4 = -u4_6*y6 - (n4_z - tau[3] + y7*u4_7) - u4_5*y5;
    /* link 3: forward substitution */
    const iiwa_real y3 = -(n3_z - tau[2] + y7*u3_7 + u3_6*y6 + u3_5*y5) - u3_4*y4;
    const iiwa_real t135 = -u2_4*y4 - (n2_z - tau[1] + y7*u2_7 + u2_6*y6 + u2_5*y5);
    /* link 2: forward substitution */
    const iiwa_real y2 = t135 - u2_3*y3;
    const iiwa_real t136 = n1_z - tau[0] + y7*u1_7 + u1_6*y6 + u1_5*y5 + u1_4*y4 + u1_3*y3;
    /* link 1: forward substitution */
    const iiwa_real neg_y1 = t136 + u1_2*y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd2 = ipivot2*y2 + u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd3 = u1_3*neg_qdd1 - (u2_3*qdd2 - ipivot3*y3);
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd4 = u1_4*neg_qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd5 = u1_5*neg_qdd1 - (u4_5*qdd4 - ipivot5*y5 + u3_5*qdd3 + u2_5*qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd6 = ipivot6*y6 - u5_6*qdd5 - u4_6*qdd4 - u3_6*qdd3 - u2_6*qdd2 +
        u1_6*neg_qdd1;
    const iiwa_real t137 = u6_7*qdd6 - 2.069591277495274*y7 + u5_7*qdd5 + u4_7*qdd4 + u3_7*qdd3 +
        u2_7*qdd2;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd7 = u1_7*neg_qdd1 - t137;
    const iiwa_real t138 = -neg_qdd1;
    qdd[0] = t138;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
