/*
 * puma560_full: PUMA 560 geometry, random full inertias
 * Numbers: Table 2.1 geometry; masses, centres and inertias drawn at random: a test of generic
 *   parameters
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 4ba5f6ba4580930ac3ece4f91e671e11 (a hash of its numbers)
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 1.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 218 multiplications, 209 additions = 427; 0 unary minus; 10 sine/cosine
 *   gravity: 24 multiplications, 18 additions = 42; 1 unary minus; 10 sine/cosine
 *   bias: 198 multiplications, 181 additions = 379; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 116 multiplications, 110 additions = 226; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 400 multiplications, 359 additions, 5 divisions = 764; 4 unary minus; 10
 *       sine/cosine
 */
#include "puma560_full.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 218 multiplications, 209 additions = 427; 0 unary minus; 10 sine/cosine */
void puma560_full_inverse_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real qdd[6],
    puma560_full_real tau[6])
{
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_x = qd[0]*s23;
    /* sines and cosines of the joint angles */
    const puma560_full_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_23 = s23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww3_yz = w3_z*neg_w3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha3_x = lam3_23 + neg_ww3_yz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_y = neg_ww3_zx - neg_lam3_13;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    const puma560_full_real ww3_xy = neg_w3_x*neg_w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real neg_lam3_12 = alpha3_z - ww3_xy;
    const puma560_full_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const puma560_full_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    const puma560_full_real lam3_21 = alpha3_z + ww3_xy;
    /* sines and cosines of the joint angles */
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_full_real w4_z = neg_w3_y + qd[3];
    const puma560_full_real w4_y = neg_w3_x*s4 + w3_z*c4;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_yz = w4_z*w4_y;
    const puma560_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_21 = alpha4_z - neg_ww4_xy;
    const puma560_full_real neg_lam4_11 = ww4_zz + ww4_yy;
    const puma560_full_real neg_lam4_12 = alpha4_z + neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_full_real w5_z = w4_y + qd[4];
    const puma560_full_real w5_y = neg_w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    const puma560_full_real ww5_yz = w5_z*w5_y;
    const puma560_full_real neg_ww5_xy = neg_w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(q[5]);
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = alpha3_z*s4 - (neg_alpha3_x*c4 - qd[3]*w4_y);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_23 = ww4_yz - alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_13 = w4_y*neg_w5_x + (alpha4_z*c5 + s5*alpha4_x);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_y = neg_alpha3_x*s4 + (alpha3_z*c4 + neg_w4_x*qd[3]);
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_12 = neg_ww5_xy + alpha5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha5_x = alpha4_z*s5 - (qd[4]*w5_y + c5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_32 = ww5_yz - neg_alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    const puma560_full_real t1 = ww3_yy - ww3_zz;
    const puma560_full_real t2 = ww1_zz - neg_lam3_11;
    const puma560_full_real t3 = t1 - t2;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_22 = t3 - neg_lam3_11;
    const puma560_full_real t4 = neg_lam5_13 + qdd[5];
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_z = t4 - neg_ww5_zx;
    const puma560_full_real t5 = neg_ww5_zx - alpha6_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_31 = qdd[5] + t5;
    const puma560_full_real t6 = 0.2519035474197792*c6 - 0.1902613160848803*s6;
    const puma560_full_real t7 = 0.1902613160848803*c6 + 0.2519035474197792*s6;
    const puma560_full_real t8 = 0.561954526137403*c6;
    const puma560_full_real t9 = 0.062417998297925076*c6;
    const puma560_full_real t10 = t8*t9 + 0.43637196239865417;
    const puma560_full_real t11 = 0.561954526137403*s6;
    const puma560_full_real t12 = t9*t11;
    const puma560_full_real t13 = t10 + 22.918482381900507*t12;
    const puma560_full_real t14 = t13 - 0.907820001453264;
    const puma560_full_real t15 = 0.9969983837450935*c2;
    const puma560_full_real t16 = 0.9969983837450935*s2;
    const puma560_full_real t17 = qdd[1]*t15 - (ww2_zz*t16 + 22.627568690833527);
    const puma560_full_real t18 = 0.3465712306626645*qdd[0] + (t15*(ww1_zz + ww2_zz) + qdd[1]*t16);
    const puma560_full_real t19 = s23*t17 - c23*t18;
    const puma560_full_real t20 = 0.04687139228815516*neg_lam3_11 + (neg_lam3_12 + t19);
    const puma560_full_real t21 = qd[0]*qd[1];
    const puma560_full_real t22 = 0.07491193080123078*s2;
    const puma560_full_real t23 = qdd[0]*t15 - 0.3465712306626645*ww1_zz -
        26.617879771127544*(t21*t22);
    const puma560_full_real t24 = neg_lam3_32 + (0.04687139228815516*neg_lam3_31 + t23);
    const puma560_full_real t25 = s4*t20 - c4*t24;
    const puma560_full_real t26 = t11 + 0.4844385865269322*c6;
    const puma560_full_real t27 = 0.04687139228815516*lam3_21 - s23*t18 - (c23*t17 - lam3_22);
    const puma560_full_real t28 = c4*t20 + s4*t24;
    const puma560_full_real t29 = s5*t27 - c5*t28;
    const puma560_full_real t30 = t8 - 0.4844385865269322*s6;
    const puma560_full_real t31 = ww5_xx + ww6_zz;
    const puma560_full_real t32 = ww5_zz + ww6_zz;
    const puma560_full_real t33 = t31 - t32;
    const puma560_full_real t34 = t12 - (22.918482381900507*t10 - 10.402928354621762);
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_z = neg_lam5_12*t6 - lam5_32*t7 - (t4*t14 + t5*t13 - t25*t26) +
        (t29*t30 - t33*t34);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_21 = neg_ww5_xy - alpha5_z;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real t35 = ww4_zz - ww4_yy;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_22 = lam3_22 - t35;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_23 = ww5_yz + neg_alpha5_x;
    const puma560_full_real t36 = 0.08058935149735619*lam5_32;
    const puma560_full_real t37 = 0.37765802516131436*t29;
    const puma560_full_real t38 = 0.18116108322165295*neg_lam5_12 - t36 - (0.1558184212675505*t33 +
        t37 - 0.1513642331069161*neg_lam5_31 + 0.2064157143738513*t25 + nc6_z);
    const puma560_full_real t39 = 0.2788425785236688*neg_lam5_13 - t38;
    const puma560_full_real t40 = neg_lam4_11 + lam3_22;
    const puma560_full_real t41 = qd[5] + w6_z;
    const puma560_full_real t42 = alpha5_z + neg_w5_x*t41;
    const puma560_full_real t43 = s5*t28 + c5*t27;
    const puma560_full_real t44 = neg_lam5_22 + lam4_22;
    const puma560_full_real t45 = neg_alpha5_x - w5_z*t41;
    const puma560_full_real t46 = 0.06568070130666698*t25 - (t34*t42 - (t30 +
        0.37765802516131436)*t43) + (t5*t7 - (0.18116108322165295*t44 + t6*(t31 - neg_lam5_22)) +
        t14*t45);
    const puma560_full_real t47 = 0.08058935149735619*neg_lam5_31 + (0.1558184212675505*neg_lam5_21
        - (t46 + 0.3901127773977262*lam5_32) + 0.2788425785236688*lam5_23);
    const puma560_full_real t48 = 0.3473260245772809*lam4_21 + (c5*t39 - 0.10734691974802549*lam4_13
        - 0.05337162017689789*(t35 - t40)) + s5*t47;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_z = 0.2837491060266096*lam4_23 + (t48 - 0.33686216557830156*t25);
    const puma560_full_real t49 = t33 + t44;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_11 = t49 - neg_lam5_22;
    const puma560_full_real t50 = t26*t42 - (0.06568070130666698*neg_lam5_22 +
        (0.37765802516131436*lam5_23 + 0.2064157143738513*neg_lam5_21)) - t30*t45;
    const puma560_full_real t51 = -0.2064157143738513*lam5_11 - (t4*t30 - t32*t26) +
        (0.06568070130666698*neg_lam5_12 - 0.37765802516131436*neg_lam5_13);
    const puma560_full_real t52 = 0.33686216557830156*neg_lam4_11 + (9.668724351427649*t28 - s5*t50
        - c5*t51);
    const puma560_full_real t53 = t31*t30 - (9.668724351427649*t25 + t5*t26 -
        0.8150047132321409*(t36 - 0.2532693504989058*neg_lam5_31)) - 0.37765802516131436*lam4_22;
    const puma560_full_real t54 = 0.33686216557830156*lam4_21 - t53;
    const puma560_full_real t55 = s4*t52 - c4*t54;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_y = 0.060845712710754084*neg_lam3_12 + n4_z -
        (0.4930056644597067*neg_lam3_31 + (0.7393454722568493*neg_lam3_32 - (0.04687139228815516*t55
        - 0.01894848286257894*t2)));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n4_x = c5*t47 - (s5*t39 - 0.05337162017689789*neg_lam4_31 -
        (0.2837491060266096*lam4_21 - 0.10734691974802549*t35));
    const puma560_full_real t56 = 0.1513642331069161*neg_lam5_21 - t13*t42 +
        0.17391580988809086*(t37 + 0.8959416706728075*lam5_23) - t43*(t26 + 0.2064157143738513);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_z = t7*(ww5_xx - ww6_zz) - t56 + (t34*t45 +
        0.3901127773977262*neg_lam5_12 + t4*t6) - (0.18116108322165295*neg_lam5_13 +
        0.08058935149735619*t49);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_32 = ww4_yz + alpha4_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n4_y = 0.10734691974802549*neg_lam4_12 - n5_z +
        0.2837491060266096*t40 - 0.3473260245772809*neg_lam4_31 + (0.05337162017689789*lam4_32 +
        0.33686216557830156*t27);
    const puma560_full_real t57 = t55 + s4*neg_n4_y - (0.7393454722568493*neg_lam3_31 +
        0.060845712710754084*(t1 + 216.1081950128016*neg_lam3_32) + 12.150081500837414*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_x = 0.01894848286257894*lam3_21 + c4*neg_n4_x - t57;
    const puma560_full_real t58 = 4.508184091221399*s2 + 0.07491193080123078*c2;
    const puma560_full_real t59 = 0.2348119600832282*c2;
    const puma560_full_real t60 = s2*t59;
    const puma560_full_real t61 = c2*t59;
    const puma560_full_real t62 = 55.04847880816545*t60 + (t61 - 0.1174059800416141);
    const puma560_full_real t63 = t21*t62;
    const puma560_full_real t64 = c4*t52 + s4*t54;
    const puma560_full_real t65 = 12.150081500837414*neg_lam3_12 - t64;
    const puma560_full_real t66 = 0.33686216557830156*neg_lam4_31 + (s5*t51 - c5*t50 +
        9.668724351427649*t27);
    const puma560_full_real t67 = t66 - 12.150081500837414*lam3_22;
    const puma560_full_real t68 = c23*t65 - s23*t67;
    const puma560_full_real t69 = ww2_zz*(t22 - 4.508184091221399*c2) + qdd[0]*(t60 -
        (55.04847880816545*t61 + 3.9979337853179913)) + (t63 - s23*neg_n3_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = c23*neg_n3_y + (qdd[1]*t58 - (t63 + 0.3465712306626645*t68 + (t69
        + t15*(t55 - 12.150081500837414*neg_lam3_32))));
    const puma560_full_real t70 = c4*neg_n4_y - 12.150081500837414*t19 -
        (0.01894848286257894*lam3_23 + (0.4930056644597067*lam3_21 + 0.7393454722568493*t3) -
        0.04687139228815516*t66);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_z = 0.060845712710754084*neg_lam3_13 - (t64 -
        (13.149257148188545*neg_lam3_12 - s4*neg_n4_x)) - t70;
    const puma560_full_real t71 = n3_z + t15*(s23*t65 + c23*t67) + (qdd[0]*t58 -
        293.22217760906653*(c2 - 0.005370026967362786*s2) - t16*t68);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_z = 13.340650116616965*qdd[1] + ww1_zz*t62 + t71;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 24 multiplications, 18 additions = 42; 1 unary minus; 10 sine/cosine */
void puma560_full_gravity(const puma560_full_real q[6], puma560_full_real tau[6])
{
    /* sines and cosines of the joint angles */
    const puma560_full_real s6 = sin(q[5]);
    const puma560_full_real c6 = cos(q[5]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real hw6_y = 12.715664641298892*c6 - 10.96166739312846*s6;
    /* sines and cosines of the joint angles */
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real s23 = sin(angle23);
    const puma560_full_real s5 = sin(q[4]);
    const puma560_full_real c23 = cos(angle23);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real hw6_x = -12.715664641298892*s6 - 10.96166739312846*c6;
    /* sines and cosines of the joint angles */
    const puma560_full_real s4 = sin(q[3]);
    const puma560_full_real t1 = c4*s23;
    const puma560_full_real t2 = s23*s4;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const puma560_full_real tau6 = hw6_y*(c5*t1 + s5*c23) + hw6_x*t2;
    const puma560_full_real t3 = 4.670685755861793 - hw6_x;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real hw5_y = -1.4861945804787264*c5 - s5*t3;
    const puma560_full_real hw5_x = 1.4861945804787264*s5 - c5*t3;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_full_real tau5 = t1*hw5_y - c23*hw5_x;
    const puma560_full_real t4 = hw5_x + 7.622371790965955;
    const puma560_full_real t5 = -hw6_y - 8.545482905982176;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_full_real tau4 = t2*t4 - t1*t5;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real hw4_x = c4*t4 + s4*t5;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real neg_hw3_x = s23*(hw5_y - 56.14707934476033) - c23*(hw4_x +
        10.254510287734192);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_full_real neg_hw2_x = neg_hw3_x - (75.09914597144959*c2 - 1.5746110011895278*s2);
    tau[0] = 0.0;
    tau[1] = neg_hw2_x;
    tau[2] = neg_hw3_x;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 198 multiplications, 181 additions = 379; 0 unary minus; 10 sine/cosine */
void puma560_full_bias(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    puma560_full_real tau[6])
{
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_x = qd[0]*s23;
    /* sines and cosines of the joint angles */
    const puma560_full_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_full_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_full_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    const puma560_full_real ww3_xy = neg_w3_x*neg_w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real lam3_32 = -2.0*neg_ww3_yz;
    /* sines and cosines of the joint angles */
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_full_real w4_z = neg_w3_y + qd[3];
    const puma560_full_real w4_y = neg_w3_x*s4 + w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_yz = w4_z*w4_y;
    const puma560_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_21 = neg_ww3_zx + neg_ww4_xy;
    const puma560_full_real neg_lam4_11 = ww4_zz + ww4_yy;
    const puma560_full_real lam4_12 = neg_ww3_zx - neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_full_real w5_z = w4_y + qd[4];
    const puma560_full_real w5_y = neg_w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    const puma560_full_real ww5_yz = w5_z*w5_y;
    const puma560_full_real neg_ww5_xy = neg_w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(q[5]);
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha4_x = neg_ww3_yz*c4 - qd[3]*w4_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_23 = ww4_yz + neg_alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_13 = w4_y*neg_w5_x - (neg_ww3_zx*c5 + s5*neg_alpha4_x);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_12 = neg_ww5_xy + alpha4_y;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = neg_ww3_zx*s5 + (qd[4]*w5_y - c5*neg_alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_32 = ww5_yz + alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    const puma560_full_real t1 = ww3_yy - ww3_zz;
    const puma560_full_real t2 = ww1_zz - neg_lam3_11;
    const puma560_full_real t3 = t1 - t2;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_22 = t3 - neg_lam3_11;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_z = neg_lam5_13 - neg_ww5_zx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_31 = neg_ww5_zx - alpha6_z;
    const puma560_full_real t4 = 0.2519035474197792*c6 - 0.1902613160848803*s6;
    const puma560_full_real t5 = 0.1902613160848803*c6 + 0.2519035474197792*s6;
    const puma560_full_real t6 = 0.561954526137403*c6;
    const puma560_full_real t7 = 0.062417998297925076*c6;
    const puma560_full_real t8 = t6*t7 + 0.43637196239865417;
    const puma560_full_real t9 = 0.561954526137403*s6;
    const puma560_full_real t10 = t7*t9;
    const puma560_full_real t11 = t8 + 22.918482381900507*t10;
    const puma560_full_real t12 = t11 - 0.907820001453264;
    const puma560_full_real t13 = 0.9969983837450935*s2;
    const puma560_full_real t14 = ww2_zz*t13 + 22.627568690833527;
    const puma560_full_real t15 = 0.9969983837450935*c2;
    const puma560_full_real t16 = t15*(ww1_zz + ww2_zz);
    const puma560_full_real t17 = s23*t14 + c23*t16;
    const puma560_full_real t18 = 0.04687139228815516*neg_lam3_11 - (ww3_xy + t17);
    const puma560_full_real t19 = qd[0]*qd[1];
    const puma560_full_real t20 = 0.07491193080123078*s2;
    const puma560_full_real t21 = 0.3465712306626645*ww1_zz + 26.617879771127544*(t19*t20);
    const puma560_full_real t22 = 0.09374278457631031*neg_ww3_zx - t21 - lam3_32;
    const puma560_full_real t23 = s4*t18 - c4*t22;
    const puma560_full_real t24 = t9 + 0.4844385865269322*c6;
    const puma560_full_real t25 = 0.04687139228815516*ww3_xy - s23*t16 + (c23*t14 + lam3_22);
    const puma560_full_real t26 = c4*t18 + s4*t22;
    const puma560_full_real t27 = s5*t25 - c5*t26;
    const puma560_full_real t28 = t6 - 0.4844385865269322*s6;
    const puma560_full_real t29 = ww5_xx + ww6_zz;
    const puma560_full_real t30 = ww5_zz + ww6_zz;
    const puma560_full_real t31 = t29 - t30;
    const puma560_full_real t32 = t10 - (22.918482381900507*t8 - 10.402928354621762);
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_z = neg_lam5_12*t4 - lam5_32*t5 - (neg_lam5_13*t12 + neg_lam5_31*t11
        - t23*t24) + (t27*t28 - t31*t32);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_21 = neg_ww5_xy - alpha4_y;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real t33 = ww4_zz - ww4_yy;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_22 = lam3_22 - t33;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_23 = ww5_yz - alpha5_x;
    const puma560_full_real t34 = 0.08058935149735619*lam5_32;
    const puma560_full_real t35 = 0.37765802516131436*t27;
    const puma560_full_real t36 = 0.18116108322165295*neg_lam5_12 - t34 - (0.1558184212675505*t31 +
        t35 - 0.1513642331069161*neg_lam5_31 + 0.2064157143738513*t23 + nc6_z);
    const puma560_full_real t37 = 0.2788425785236688*neg_lam5_13 - t36;
    const puma560_full_real t38 = neg_lam4_11 + lam3_22;
    const puma560_full_real t39 = qd[5] + w6_z;
    const puma560_full_real t40 = alpha5_x + w5_z*t39;
    const puma560_full_real t41 = neg_lam5_22 + lam4_22;
    const puma560_full_real t42 = t28 + 0.37765802516131436;
    const puma560_full_real t43 = s5*t26 + c5*t25;
    const puma560_full_real t44 = alpha4_y + neg_w5_x*t39;
    const puma560_full_real t45 = t4*(t29 - neg_lam5_22) + (0.18116108322165295*t41 - (t42*t43 -
        (t32*t44 + (0.1558184212675505*neg_lam5_21 - 0.06568070130666698*t23))));
    const puma560_full_real t46 = 0.2788425785236688*lam5_23 - (0.3901127773977262*lam5_32 -
        (t12*t40 + t45)) - neg_lam5_31*(t5 - 0.08058935149735619);
    const puma560_full_real t47 = 0.3473260245772809*neg_lam4_21 - (c5*t37 -
        0.10734691974802549*lam4_13 - 0.05337162017689789*(t33 - t38)) - s5*t46;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_z = 0.2837491060266096*lam4_23 - (t47 + 0.33686216557830156*t23);
    const puma560_full_real t48 = t31 + t41;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_11 = t48 - neg_lam5_22;
    const puma560_full_real t49 = t24*t44 - (0.06568070130666698*neg_lam5_22 +
        (0.37765802516131436*lam5_23 + 0.2064157143738513*neg_lam5_21)) + t28*t40;
    const puma560_full_real t50 = 0.06568070130666698*neg_lam5_12 + (t30*t24 -
        0.2064157143738513*lam5_11) - neg_lam5_13*t42;
    const puma560_full_real t51 = 0.33686216557830156*neg_lam4_11 + (9.668724351427649*t26 - s5*t49
        - c5*t50);
    const puma560_full_real t52 = t29*t28 - (9.668724351427649*t23 + neg_lam5_31*t24 -
        0.8150047132321409*(t34 - 0.2532693504989058*neg_lam5_31)) - 0.37765802516131436*lam4_22;
    const puma560_full_real t53 = 0.33686216557830156*neg_lam4_21 + t52;
    const puma560_full_real t54 = s4*t51 + c4*t53;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_y = 0.060845712710754084*ww3_xy - n4_z +
        (0.9860113289194135*neg_ww3_zx + (1.4786909445136986*neg_ww3_yz - (0.04687139228815516*t54 -
        0.01894848286257894*t2)));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n4_x = c5*t46 - (s5*t37 - 0.05337162017689789*neg_lam4_31 +
        (0.2837491060266096*neg_lam4_21 + 0.10734691974802549*t33));
    const puma560_full_real t55 = 0.17391580988809086*(t35 + 0.8959416706728075*lam5_23) - (t11*t44
        + (t5*(ww5_xx - ww6_zz) - 0.1513642331069161*neg_lam5_21));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_z = neg_lam5_13*(t4 - 0.18116108322165295) - (0.08058935149735619*t48
        - (0.3901127773977262*neg_lam5_12 - (t32*t40 - (t43*(t24 + 0.2064157143738513) - t55))));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_32 = ww4_yz - neg_alpha4_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_y = 0.10734691974802549*lam4_12 + n5_z - 0.2837491060266096*t38 +
        0.3473260245772809*neg_lam4_31 - (0.05337162017689789*lam4_32 + 0.33686216557830156*t25);
    const puma560_full_real t56 = t54 - s4*n4_y - (1.4786909445136986*neg_ww3_zx +
        0.060845712710754084*(t1 + 432.2163900256032*neg_ww3_yz) - 12.150081500837414*t21);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_x = 0.01894848286257894*ww3_xy + c4*neg_n4_x - t56;
    const puma560_full_real t57 = 0.2348119600832282*c2;
    const puma560_full_real t58 = 55.04847880816545*(s2*t57) + (c2*t57 - 0.1174059800416141);
    const puma560_full_real t59 = t19*t58;
    const puma560_full_real t60 = t15*(24.30016300167483*neg_ww3_yz - t54) - (ww2_zz*(t20 -
        4.508184091221399*c2) + (t59 - s23*neg_n3_x));
    const puma560_full_real t61 = c4*t51 - s4*t53;
    const puma560_full_real t62 = 12.150081500837414*ww3_xy + t61;
    const puma560_full_real t63 = 0.33686216557830156*neg_lam4_31 + (s5*t50 - c5*t49 +
        9.668724351427649*t25);
    const puma560_full_real t64 = t63 - 12.150081500837414*lam3_22;
    const puma560_full_real t65 = c23*t62 + s23*t64;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = t60 - (t59 - 0.3465712306626645*t65) - c23*n3_y;
    const puma560_full_real t66 = 0.04687139228815516*t63 - (0.7393454722568493*t3 -
        (12.150081500837414*t17 - (c4*n4_y - (t61 + s4*neg_n4_x))));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_z = -12.656251483728838*ww3_xy - t66;
    const puma560_full_real t67 = t15*(s23*t62 - c23*t64) - n3_z + (293.22217760906653*(c2 -
        0.005370026967362786*s2) - t13*t65);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_z = ww1_zz*t58 - t67;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 116 multiplications, 110 additions = 226; 0 unary minus; 10 sine/cosine */
void puma560_full_mass_matrix(const puma560_full_real q[6], puma560_full_real M[36])
{
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(q[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(q[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(q[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(q[5]);
    const puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    const puma560_full_real t1 = 1.1185374890947408*s6;
    const puma560_full_real t2 = 0.8038904448657128*c6;
    const puma560_full_real t3 = 1.6140468000577937*t2;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h6_y = t1 - t3;
    const puma560_full_real t4 = 8.074308788029867*neg_h6_y;
    const puma560_full_real t5 = t4 + 13.331564749028798*t3;
    const puma560_full_real h6_x = 0.1639752994550661*(t1 - t5);
    const puma560_full_real t6 = h6_x - 0.47660058733283606;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = 0.15165250821211493*s5 + c5*t6;
    const puma560_full_real t7 = neg_h6_y - 0.8719880516308344;
    const puma560_full_real t8 = h5_x + 0.7777930398944852;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = s4*t7 + c4*t8;
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real k6_xz = 0.02789191831646398*t5;
    const puma560_full_real t9 = c5*k6_xz;
    const puma560_full_real t10 = t9 - 0.08058935149735619*c5;
    const puma560_full_real t11 = s6*t2 - 0.7502906175782786;
    const puma560_full_real t12 = c6*t2;
    const puma560_full_real t13 = t11 + 0.04363290654837309*t12;
    const puma560_full_real t14 = t13 + 0.9479140356861228;
    const puma560_full_real t15 = s5*t14 - t10;
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = s5*t10 - (s5*t15 - 1.6853528376611298);
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real neg_k6_yz = 0.02404451046533376*(t1 - t4);
    const puma560_full_real t16 = t12 - (0.04363290654837309*t11 + 0.27886416156622007);
    const puma560_full_real t17 = neg_k6_yz - 0.18116108322165295;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real neg_k5_xz = c5*t16 + s5*t17;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h5_y = 0.15165250821211493*c5 - s5*t6;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h4_y = c4*t7 - s4*t8;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real k5_yz = c5*t17 - s5*t16;
    const puma560_full_real t18 = 0.0203*h4_x;
    const puma560_full_real t19 = c4*c4;
    const puma560_full_real t20 = t13 + (t13 + m4_4);
    const puma560_full_real t21 = c4*s4;
    const puma560_full_real t22 = neg_k5_xz - 0.034423137314318945;
    const puma560_full_real t23 = t22 + (neg_k5_xz - 0.07232010303947682);
    const puma560_full_real t24 = t18 - t19*t20 + (t18 + (t13 - (t21*t23 + 0.47176417886368593)));
    const puma560_full_real t25 = 0.4331*neg_h5_y;
    const puma560_full_real t26 = t25 + 5.555998411819751 + (t25 - m4_4);
    const puma560_full_real t27 = 0.4331*neg_h4_y;
    const puma560_full_real t28 = t18 + 0.3465712306626645*t27;
    const puma560_full_real t29 = 0.07491193080123078*c2;
    const puma560_full_real t30 = 5.764101864437669*t29;
    const puma560_full_real t31 = c23*t30;
    const puma560_full_real t32 = h4_x + 1.046378600789203;
    const puma560_full_real t33 = s23*t30;
    const puma560_full_real t34 = neg_h5_y + 5.729293810689829;
    const puma560_full_real t35 = t31*t32 + t33*t34;
    const puma560_full_real t36 = 0.04687139228815516*t25;
    const puma560_full_real t37 = k5_yz - 0.10734691974802549;
    const puma560_full_real t38 = k6_xz + (c5*(t15 - t10) - 0.36433845752396576);
    const puma560_full_real t39 = s4*t37 + (21.334975369458128*t18 - c4*t38);
    const puma560_full_real t40 = t35 - s23*(c23*(t36 + 0.28615890025504537 - t39));
    const puma560_full_real t41 = 0.005305812062437387*s2;
    const puma560_full_real t42 = t29 - t41;
    const puma560_full_real t43 = t28 - m4_4;
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_1 = s23*s23*(t24 + t26) - (t28 - (t40 + 3.3083718390798666 +
        102.49099587639564*(t30*t42))) + (t40 - t43);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_y = s23*t32 - c23*t34;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_4 = s4*t38 + (t27 + c4*t37);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_3 = 0.1501*h3_y + c23*(m3_4 + 0.060845712710754084) + s23*(t20*t21 +
        (t22 - (t19*t23 - 0.04687139228815516*t27)));
    const puma560_full_real t44 = 81.3824528495718*t41;
    const puma560_full_real m1_2 = m1_3 + (t42 - t44*(neg_h4_y - 2.7157163660839054));
    const puma560_full_real m1_4 = h4_x*t30 + (s23*t39 - c23*t43);
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c4*neg_h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c23*fu4_x - s23*h5_x;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t14 + 0.7802255547954524;
    const puma560_full_real t45 = t25 + m5_5;
    const puma560_full_real t46 = s4*t36;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y = s23*(c4*neg_k5_xz - s4*t45) - c23*(k5_yz - t46);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_5 = 0.1501*(141.7117652271228*(c2*t46) - fu3_x) - nu3_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu5_y = 0.907820001453264*c5 + s5*k6_xz;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = c5*neg_h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu5_x = t9 - 0.907820001453264*s5;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_y = s5*neg_h6_y;
    const puma560_full_real t47 = 0.4331*fu4_y;
    const puma560_full_real t48 = c4*fu5_x - s4*h6_x;
    const puma560_full_real t49 = s23*fu5_y - c23*t48;
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_6 = c23*(neg_nu5_y - 0.04687139228815516*t47) + (s23*(t47 +
        s4*neg_k6_yz + c4*neg_nu5_x) + (t30*fu4_y + 0.1501*t49));
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_3 = t26 - t24;
    const puma560_full_real t50 = t35 + h3_y*t44;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_3 = t50 + m3_3;
    const puma560_full_real m2_2 = t50 + (m2_3 + 3.7298822532370677);
    const puma560_full_real m2_4 = m3_4 + neg_h4_y*(t33 - c23*t44);
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_5 = s4*neg_k5_xz - (0.0203*h5_x - c4*t45);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_5 = t33*fu4_x + h5_x*t31 - (t44*fu3_x - m3_5);
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_6 = c4*neg_k6_yz + 0.4331*t48 - (0.0203*fu5_y + s4*neg_nu5_x);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_6 = m3_6 + (t44*t49 + (t31*fu5_y + t33*t48));
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = m1_6;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = m1_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = m3_6;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = k5_yz;
    M[28] = m5_5;
    M[29] = neg_k6_yz;
    M[30] = m1_6;
    M[31] = m2_6;
    M[32] = m3_6;
    M[33] = neg_nu5_y;
    M[34] = neg_k6_yz;
    M[35] = 0.907820001453264;
}

/* accelerations that the torques tau give
 * 400 multiplications, 359 additions, 5 divisions = 764; 4 unary minus; 10 sine/cosine */
void puma560_full_forward_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real tau[6],
    puma560_full_real qdd[6])
{
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_x = qd[0]*s23;
    /* sines and cosines of the joint angles */
    const puma560_full_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_full_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_full_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    const puma560_full_real ww3_xy = neg_w3_x*neg_w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real lam3_32 = -2.0*neg_ww3_yz;
    /* sines and cosines of the joint angles */
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_full_real w4_z = neg_w3_y + qd[3];
    const puma560_full_real w4_y = neg_w3_x*s4 + w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_yz = w4_z*w4_y;
    const puma560_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_21 = neg_ww3_zx + neg_ww4_xy;
    const puma560_full_real neg_lam4_11 = ww4_zz + ww4_yy;
    const puma560_full_real lam4_12 = neg_ww3_zx - neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_full_real w5_z = w4_y + qd[4];
    const puma560_full_real w5_y = neg_w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    const puma560_full_real ww5_yz = w5_z*w5_y;
    const puma560_full_real neg_ww5_xy = neg_w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(q[5]);
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha4_x = neg_ww3_yz*c4 - qd[3]*w4_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_23 = ww4_yz + neg_alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_13 = w4_y*neg_w5_x - (neg_ww3_zx*c5 + s5*neg_alpha4_x);
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_12 = neg_ww5_xy + alpha4_y;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = neg_ww3_zx*s5 + (qd[4]*w5_y - c5*neg_alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_32 = ww5_yz + alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    const puma560_full_real t1 = ww3_yy - ww3_zz;
    const puma560_full_real t2 = ww1_zz - neg_lam3_11;
    const puma560_full_real t3 = t1 - t2;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_22 = neg_lam3_11 - t3;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_z = neg_lam5_13 - neg_ww5_zx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_31 = neg_ww5_zx - alpha6_z;
    const puma560_full_real t4 = 0.2519035474197792*c6 - 0.1902613160848803*s6;
    const puma560_full_real t5 = 0.1902613160848803*c6 + 0.2519035474197792*s6;
    const puma560_full_real t6 = 0.561954526137403*c6;
    const puma560_full_real t7 = 0.062417998297925076*c6;
    const puma560_full_real t8 = t6*t7 + 0.43637196239865417;
    const puma560_full_real t9 = 0.561954526137403*s6;
    const puma560_full_real t10 = t7*t9;
    const puma560_full_real t11 = t8 + 22.918482381900507*t10;
    const puma560_full_real t12 = t11 - 0.907820001453264;
    const puma560_full_real t13 = 0.9969983837450935*s2;
    const puma560_full_real t14 = ww2_zz*t13 + 22.627568690833527;
    const puma560_full_real t15 = 0.9969983837450935*c2;
    const puma560_full_real t16 = t15*(ww1_zz + ww2_zz);
    const puma560_full_real t17 = s23*t14 + c23*t16;
    const puma560_full_real t18 = 0.04687139228815516*neg_lam3_11 - (ww3_xy + t17);
    const puma560_full_real t19 = qd[0]*qd[1];
    const puma560_full_real t20 = 0.07491193080123078*s2;
    const puma560_full_real t21 = 0.3465712306626645*ww1_zz + 26.617879771127544*(t19*t20);
    const puma560_full_real t22 = 0.09374278457631031*neg_ww3_zx - t21 - lam3_32;
    const puma560_full_real t23 = s4*t18 - c4*t22;
    const puma560_full_real t24 = t9 + 0.4844385865269322*c6;
    const puma560_full_real t25 = 0.04687139228815516*ww3_xy - s23*t16 - (neg_lam3_22 - c23*t14);
    const puma560_full_real t26 = c4*t18 + s4*t22;
    const puma560_full_real t27 = s5*t25 - c5*t26;
    const puma560_full_real t28 = t6 - 0.4844385865269322*s6;
    const puma560_full_real t29 = ww5_xx + ww6_zz;
    const puma560_full_real t30 = ww5_zz + ww6_zz;
    const puma560_full_real t31 = t29 - t30;
    const puma560_full_real t32 = t10 - (22.918482381900507*t8 - 10.402928354621762);
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_z = neg_lam5_12*t4 - lam5_32*t5 - (neg_lam5_13*t12 + neg_lam5_31*t11
        - t23*t24) + (t27*t28 - t31*t32);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_21 = neg_ww5_xy - alpha4_y;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real t33 = ww4_zz - ww4_yy;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_22 = neg_lam3_22 + t33;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_23 = ww5_yz - alpha5_x;
    const puma560_full_real t34 = 0.08058935149735619*lam5_32;
    const puma560_full_real t35 = 0.37765802516131436*t27;
    const puma560_full_real t36 = 0.18116108322165295*neg_lam5_12 - t34 - (nc6_z +
        (0.1558184212675505*t31 + t35 - 0.1513642331069161*neg_lam5_31 + 0.2064157143738513*t23));
    const puma560_full_real t37 = 0.2788425785236688*neg_lam5_13 - t36;
    const puma560_full_real t38 = neg_lam4_11 - neg_lam3_22;
    const puma560_full_real t39 = qd[5] + w6_z;
    const puma560_full_real t40 = alpha5_x + w5_z*t39;
    const puma560_full_real t41 = neg_lam5_22 - neg_lam4_22;
    const puma560_full_real t42 = t28 + 0.37765802516131436;
    const puma560_full_real t43 = s5*t26 + c5*t25;
    const puma560_full_real t44 = alpha4_y + neg_w5_x*t39;
    const puma560_full_real t45 = t4*(t29 - neg_lam5_22) + (0.18116108322165295*t41 - (t42*t43 -
        (t32*t44 + (0.1558184212675505*neg_lam5_21 - 0.06568070130666698*t23))));
    const puma560_full_real t46 = 0.2788425785236688*lam5_23 - (0.3901127773977262*lam5_32 -
        (t12*t40 + t45)) - neg_lam5_31*(t5 - 0.08058935149735619);
    const puma560_full_real t47 = 0.3473260245772809*neg_lam4_21 - (c5*t37 -
        0.10734691974802549*lam4_13 - 0.05337162017689789*(t33 - t38)) - s5*t46;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_z = 0.2837491060266096*lam4_23 - (t47 + 0.33686216557830156*t23);
    const puma560_full_real t48 = t31 + t41;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam5_11 = t48 - neg_lam5_22;
    const puma560_full_real t49 = t24*t44 - (0.06568070130666698*neg_lam5_22 +
        (0.37765802516131436*lam5_23 + 0.2064157143738513*neg_lam5_21)) + t28*t40;
    const puma560_full_real t50 = 0.06568070130666698*neg_lam5_12 + (t24*t30 -
        0.2064157143738513*lam5_11) - neg_lam5_13*t42;
    const puma560_full_real t51 = 0.33686216557830156*neg_lam4_11 + (9.668724351427649*t26 - s5*t49
        - c5*t50);
    const puma560_full_real t52 = t28*t29 - (9.668724351427649*t23 + neg_lam5_31*t24 -
        0.8150047132321409*(t34 - 0.2532693504989058*neg_lam5_31)) +
        0.37765802516131436*neg_lam4_22;
    const puma560_full_real t53 = 0.33686216557830156*neg_lam4_21 + t52;
    const puma560_full_real t54 = s4*t51 + c4*t53;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_y = n4_z - 0.060845712710754084*ww3_xy -
        (0.9860113289194135*neg_ww3_zx + (1.4786909445136986*neg_ww3_yz - (0.04687139228815516*t54 -
        0.01894848286257894*t2)));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n4_x = c5*t46 - (s5*t37 - 0.05337162017689789*neg_lam4_31 +
        (0.2837491060266096*neg_lam4_21 + 0.10734691974802549*t33));
    const puma560_full_real t55 = 0.17391580988809086*(t35 + 0.8959416706728075*lam5_23) - (t11*t44
        + (t5*(ww5_xx - ww6_zz) - 0.1513642331069161*neg_lam5_21));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_z = neg_lam5_13*(t4 - 0.18116108322165295) - (0.08058935149735619*t48
        - (0.3901127773977262*neg_lam5_12 - (t32*t40 - (t43*(t24 + 0.2064157143738513) - t55))));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam4_32 = ww4_yz - neg_alpha4_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_y = n5_z + 0.10734691974802549*lam4_12 - 0.2837491060266096*t38 +
        0.3473260245772809*neg_lam4_31 - (0.05337162017689789*lam4_32 + 0.33686216557830156*t25);
    const puma560_full_real t56 = t54 - s4*n4_y - (1.4786909445136986*neg_ww3_zx +
        0.060845712710754084*(t1 + 432.2163900256032*neg_ww3_yz) - 12.150081500837414*t21);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_x = 0.01894848286257894*ww3_xy + c4*neg_n4_x - t56;
    const puma560_full_real t57 = 0.2348119600832282*c2;
    const puma560_full_real t58 = 55.04847880816545*(s2*t57) + (c2*t57 - 0.1174059800416141);
    const puma560_full_real t59 = t19*t58;
    const puma560_full_real t60 = t15*(t54 - 24.30016300167483*neg_ww3_yz) + (ww2_zz*(t20 -
        4.508184091221399*c2) + (t59 - s23*neg_n3_x));
    const puma560_full_real t61 = c4*t51 - s4*t53;
    const puma560_full_real t62 = 12.150081500837414*ww3_xy + t61;
    const puma560_full_real t63 = 0.33686216557830156*neg_lam4_31 + (s5*t50 - c5*t49 +
        9.668724351427649*t25);
    const puma560_full_real t64 = t63 + 12.150081500837414*neg_lam3_22;
    const puma560_full_real t65 = c23*t62 + s23*t64;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = c23*neg_n3_y - (t60 + (t59 - 0.3465712306626645*t65));
    const puma560_full_real t66 = 0.04687139228815516*t63 - (0.7393454722568493*t3 -
        (12.150081500837414*t17 - (c4*n4_y - (t61 + s4*neg_n4_x))));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n3_z = 12.656251483728838*ww3_xy + t66;
    const puma560_full_real t67 = neg_n3_z + t15*(s23*t62 - c23*t64) + (293.22217760906653*(c2 -
        0.005370026967362786*s2) - t13*t65);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_z = ww1_zz*t58 - t67;
    const puma560_full_real t68 = 1.1185374890947408*s6;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h6_y = t68 - 1.2975168001325401*c6;
    const puma560_full_real t69 = 8.074308788029867*neg_h6_y;
    const puma560_full_real t70 = t69 + 17.297929233919618*c6;
    const puma560_full_real h6_x = 0.1639752994550661*(t68 - t70);
    const puma560_full_real t71 = h6_x - 0.47660058733283606;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = 0.15165250821211493*s5 + c5*t71;
    const puma560_full_real t72 = neg_h6_y - 0.8719880516308344;
    const puma560_full_real t73 = h5_x + 0.7777930398944852;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = s4*t72 + c4*t73;
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real k6_xz = 0.02789191831646398*t70;
    const puma560_full_real t74 = c5*k6_xz;
    const puma560_full_real t75 = t74 - 0.08058935149735619*c5;
    const puma560_full_real t76 = 0.8038904448657128*c6;
    const puma560_full_real t77 = s6*t76 - 0.7502906175782786;
    const puma560_full_real t78 = c6*t76;
    const puma560_full_real t79 = t77 + 0.04363290654837309*t78;
    const puma560_full_real t80 = t75 + (t75 - s5*(t79 + 0.9479140356861228));
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = s5*t80 + 1.6853528376611298;
    const puma560_full_real t81 = t68 - t69;
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real neg_k6_yz = 0.02404451046533376*t81;
    const puma560_full_real t82 = t78 - (0.04363290654837309*t77 + 0.27886416156622007);
    const puma560_full_real t83 = 0.18116108322165295 - neg_k6_yz;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real neg_k5_xz = c5*t82 - s5*t83;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h5_y = 0.15165250821211493*c5 - s5*t71;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real neg_h4_y = c4*t72 - s4*t73;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real neg_k5_yz = c5*t83 + s5*t82;
    const puma560_full_real t84 = 0.0203*h4_x;
    const puma560_full_real t85 = c4*c4;
    const puma560_full_real t86 = t79 + (t79 + m4_4);
    const puma560_full_real t87 = c4*s4;
    const puma560_full_real t88 = 2.0*neg_k5_xz - 0.10674324035379577;
    const puma560_full_real t89 = t84 - t85*t86 + (t84 + (t79 - (t87*t88 + 0.47176417886368593)));
    const puma560_full_real t90 = 0.4331*neg_h5_y;
    const puma560_full_real t91 = t90 + 5.555998411819751 - (m4_4 - t90);
    const puma560_full_real t92 = t84 + 0.1501*neg_h4_y;
    const puma560_full_real t93 = 0.4318*c2;
    const puma560_full_real t94 = c23*t93;
    const puma560_full_real t95 = h4_x + 1.046378600789203;
    const puma560_full_real t96 = s23*t93;
    const puma560_full_real t97 = neg_h5_y + 5.729293810689829;
    const puma560_full_real t98 = t94*t95 + t96*t97;
    const puma560_full_real t99 = 0.0203*neg_h5_y;
    const puma560_full_real t100 = neg_k5_yz + 0.10734691974802549;
    const puma560_full_real t101 = k6_xz - (c5*t80 + 0.36433845752396576);
    const puma560_full_real t102 = s4*t100 - (0.4331*h4_x - c4*t101);
    const puma560_full_real t103 = t98 - s23*(c23*(t99 + 0.28615890025504537 + t102));
    const puma560_full_real t104 = 0.07491193080123078*c2 - 0.005305812062437387*s2;
    const puma560_full_real t105 = m4_4 - t92;
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_1 = s23*s23*(t89 + t91) - (t92 - (t103 + 3.3083718390798666 +
        102.49099587639564*(t93*t104))) + (t103 + t105);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_y = s23*t95 - c23*t97;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_4 = s4*t101 + (0.4331*neg_h4_y - c4*t100);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_3 = 0.1501*h3_y + c23*(m3_4 + 0.060845712710754084) + s23*(t86*t87 +
        (neg_k5_xz - 0.034423137314318945 - (t85*t88 - 0.0203*neg_h4_y)));
    const puma560_full_real t106 = 0.4318*s2;
    const puma560_full_real m1_2 = m1_3 + (t104 - t106*(neg_h4_y - 2.7157163660839054));
    const puma560_full_real m1_4 = h4_x*t93 - (s23*t102 - c23*t105);
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c4*neg_h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c23*fu4_x - s23*h5_x;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t79 + 1.728139590481575;
    const puma560_full_real t107 = t90 + m5_5;
    const puma560_full_real t108 = s4*t99;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y = s23*(c4*neg_k5_xz - s4*t107) + c23*(neg_k5_yz + t108);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real neg_m1_5 = nu3_y + 0.1501*(fu3_x - 141.7117652271228*(c2*t108));
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu5_y = 0.907820001453264*c5 + s5*k6_xz;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = c5*neg_h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu5_x = t74 - 0.907820001453264*s5;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_y = s5*neg_h6_y;
    const puma560_full_real t109 = c4*fu5_x - s4*h6_x;
    const puma560_full_real t110 = s23*fu5_y - c23*t109;
    const puma560_full_real t111 = s23*(0.4331*fu4_y + s4*neg_k6_yz + c4*neg_nu5_x) + (t93*fu4_y +
        0.1501*t110);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_6 = c23*(neg_nu5_y - 0.0203*fu4_y) + t111;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real neg_m3_3 = t89 - t91;
    const puma560_full_real t112 = t98 + h3_y*t106;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real neg_m2_3 = neg_m3_3 - t112;
    const puma560_full_real m2_2 = t112 - (neg_m2_3 - 3.7298822532370677);
    const puma560_full_real m2_4 = m3_4 + neg_h4_y*(t96 - c23*t106);
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_5 = s4*neg_k5_xz - (0.0203*h5_x - c4*t107);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_5 = t96*fu4_x + h5_x*t94 + (m3_5 - t106*fu3_x);
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_6 = c4*neg_k6_yz + 0.4331*t109 - (0.0203*fu5_y + s4*neg_nu5_x);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_6 = m3_6 + (t106*t110 + (t94*fu5_y + t96*t109));
    /* link 6: forward substitution */
    const puma560_full_real neg_y6 = nc6_z - tau[5];
    /* factorisation M = U D U^T */
    const puma560_full_real u5_6 = 0.026485988881983898*t81;
    const puma560_full_real u4_6 = 1.1015399510907136*neg_nu5_y;
    const puma560_full_real u3_6 = 1.1015399510907136*m3_6;
    const puma560_full_real u2_6 = 1.1015399510907136*m2_6;
    const puma560_full_real u1_6 = 1.1015399510907136*m1_6;
    const puma560_full_real pivot5 = m5_5 - neg_k6_yz*u5_6;
    const puma560_full_real ipivot5 = 1.0 / pivot5;
    const puma560_full_real neg_ud4_5 = neg_k5_yz + neg_k6_yz*u4_6;
    const puma560_full_real neg_u4_5 = ipivot5*neg_ud4_5;
    const puma560_full_real ud3_5 = m3_5 - neg_k6_yz*u3_6;
    const puma560_full_real u3_5 = ipivot5*ud3_5;
    const puma560_full_real ud2_5 = m2_5 - neg_k6_yz*u2_6;
    const puma560_full_real u2_5 = ipivot5*ud2_5;
    const puma560_full_real neg_ud1_5 = neg_m1_5 + neg_k6_yz*u1_6;
    const puma560_full_real neg_u1_5 = ipivot5*neg_ud1_5;
    const puma560_full_real pivot4 = m4_4 - neg_nu5_y*u4_6 - neg_ud4_5*neg_u4_5;
    const puma560_full_real ipivot4 = 1.0 / pivot4;
    const puma560_full_real ud3_4 = m3_4 - neg_nu5_y*u3_6 + neg_ud4_5*u3_5;
    const puma560_full_real u3_4 = ipivot4*ud3_4;
    const puma560_full_real ud2_4 = m2_4 - neg_nu5_y*u2_6 + neg_ud4_5*u2_5;
    const puma560_full_real u2_4 = ipivot4*ud2_4;
    const puma560_full_real ud1_4 = m1_4 - neg_nu5_y*u1_6 - neg_ud4_5*neg_u1_5;
    const puma560_full_real u1_4 = ipivot4*ud1_4;
    const puma560_full_real neg_pivot3 = neg_m3_3 + m3_6*u3_6 + ud3_5*u3_5 + ud3_4*u3_4;
    const puma560_full_real neg_ipivot3 = 1.0 / neg_pivot3;
    const puma560_full_real neg_ud2_3 = neg_m2_3 + m3_6*u2_6 + ud3_5*u2_5 + ud3_4*u2_4;
    const puma560_full_real u2_3 = neg_ipivot3*neg_ud2_3;
    const puma560_full_real ud1_3 = m1_3 - m3_6*u1_6 + ud3_5*neg_u1_5 - ud3_4*u1_4;
    const puma560_full_real neg_u1_3 = neg_ipivot3*ud1_3;
    const puma560_full_real pivot2 = m2_2 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 + neg_ud2_3*u2_3;
    const puma560_full_real ipivot2 = 1.0 / pivot2;
    const puma560_full_real ud1_2 = m1_2 - m2_6*u1_6 + ud2_5*neg_u1_5 - ud2_4*u1_4 -
        neg_ud2_3*neg_u1_3;
    const puma560_full_real u1_2 = ipivot2*ud1_2;
    const puma560_full_real pivot1 = m1_1 - m1_6*u1_6 - neg_ud1_5*neg_u1_5 - ud1_4*u1_4 +
        ud1_3*neg_u1_3 - ud1_2*u1_2;
    const puma560_full_real ipivot1 = 1.0 / pivot1;
    /* link 5: forward substitution */
    const puma560_full_real neg_y5 = n5_z - tau[4] - neg_y6*u5_6;
    /* link 4: forward substitution */
    const puma560_full_real neg_y4 = n4_z - tau[3] - neg_y6*u4_6 + neg_u4_5*neg_y5;
    /* link 3: forward substitution */
    const puma560_full_real y3 = neg_n3_z + tau[2] + neg_y6*u3_6 + u3_5*neg_y5 + u3_4*neg_y4;
    /* link 2: forward substitution */
    const puma560_full_real neg_y2 = n02_z - tau[1] - neg_y6*u2_6 - u2_5*neg_y5 - u2_4*neg_y4 +
        u2_3*y3;
    /* link 1: forward substitution */
    const puma560_full_real y1 = tau[0] - n1_z + neg_y6*u1_6 - neg_u1_5*neg_y5 + u1_4*neg_y4 +
        neg_u1_3*y3 + u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real neg_qdd2 = ipivot2*neg_y2 + u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real neg_qdd3 = neg_ipivot3*y3 - u2_3*neg_qdd2 - neg_u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real neg_qdd4 = ipivot4*neg_y4 - u3_4*neg_qdd3 - u2_4*neg_qdd2 + u1_4*qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd5 = neg_u1_5*qdd1 - (ipivot5*neg_y5 + neg_u4_5*neg_qdd4 -
        u3_5*neg_qdd3 - u2_5*neg_qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd6 = -u1_6*qdd1 - (1.1015399510907136*neg_y6 + u5_6*qdd5 -
        u4_6*neg_qdd4 - u3_6*neg_qdd3 - u2_6*neg_qdd2);
    const puma560_full_real t113 = -neg_qdd2;
    const puma560_full_real t114 = -neg_qdd3;
    const puma560_full_real t115 = -neg_qdd4;
    qdd[0] = qdd1;
    qdd[1] = t113;
    qdd[2] = t114;
    qdd[3] = t115;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
