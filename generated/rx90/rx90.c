/*
 * rx90: Staubli RX90 geometry, random full inertias
 * Numbers: published RX90 geometry; inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 585cc70ab770fd33a78850636aafb009 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0     d 0     theta q
 *   2  revolute  alpha pi/2   a 0     d 0     theta q
 *   3  revolute  alpha 0      a 0.45  d 0     theta q
 *   4  revolute  alpha -pi/2  a 0     d 0.45  theta q
 *   5  revolute  alpha pi/2   a 0     d 0     theta q
 *   6  revolute  alpha -pi/2  a 0     d 0     theta q
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
 * Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
 *   parameters, equal to the recursion without being written like it: robodyn --optimize full,
 *   seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 212 multiplications, 201 additions = 413; 3 unary minus; 10 sine/cosine
 *   gravity: 24 multiplications, 18 additions = 42; 0 unary minus; 10 sine/cosine
 *   bias: 191 multiplications, 173 additions = 364; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 105 multiplications, 94 additions = 199; 1 unary minus; 10 sine/cosine
 *   forward_dynamics: 376 multiplications, 336 additions, 5 divisions = 717; 14 unary minus; 10
 *       sine/cosine
 */
#include "rx90.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 212 multiplications, 201 additions = 413; 3 unary minus; 10 sine/cosine */
void rx90_inverse_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real qdd[6],
    rx90_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const rx90_real angle23 = q[1] + q[2];
    const rx90_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const rx90_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_23 = s23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_yz = w3_z*w3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_x = neg_lam3_23 + ww3_yz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_zx = w3_z*w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_y = lam3_13 - ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_12 = ww3_xy - alpha3_z;
    const rx90_real lam3_32 = ww3_yz + alpha3_x;
    const rx90_real lam3_21 = alpha3_z + ww3_xy;
    const rx90_real lam3_31 = ww3_zx - alpha3_y;
    /* sines and cosines of the joint angles */
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = w3_x*c4 - w3_z*s4;
    const rx90_real w4_z = w3_y + qd[3];
    const rx90_real w4_y = -w3_z*c4 - w3_x*s4;
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_z = alpha3_y + qdd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real ww4_xy = w4_x*w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_zz = w4_z*w4_z;
    const rx90_real ww4_yz = w4_z*w4_y;
    const rx90_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_21 = alpha4_z + ww4_xy;
    const rx90_real lam4_12 = ww4_xy - alpha4_z;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* sines and cosines of the joint angles */
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = w4_x*c5 + w4_z*s5;
    const rx90_real w5_z = qd[4] - w4_y;
    const rx90_real w5_y = w4_z*c5 - w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_zz = w5_z*w5_z;
    const rx90_real ww5_yz = w5_z*w5_y;
    const rx90_real ww5_xy = w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(q[5]);
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = qd[3]*w4_y - (alpha3_z*s4 - alpha3_x*c4);
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_y = alpha4_z*c5 - (w5_x*qd[4] + s5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_31 = ww5_zx - alpha5_y;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x + (alpha4_z*s5 + qd[4]*w5_y);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_32 = ww5_yz + alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_zz = w6_z*w6_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam2_13 = qdd[0]*c2;
    const rx90_real t1 = 2.0*(qd[1]*qd[0]);
    const rx90_real lam2_31 = s2*t1 - lam2_13;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam2_33 = -qd[0]*qd[0];
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real neg_alpha4_y = alpha3_z*c4 + (alpha3_x*s4 + w4_x*qd[3]);
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_z = neg_alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_21 = ww5_xy + alpha5_z;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xx = w3_x*w3_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_22 = -ww3_zz - ww3_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_12 = ww5_xy - alpha5_z;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_31 = ww4_zx + neg_alpha4_y;
    const rx90_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_13 = ww5_zx + alpha5_y;
    const rx90_real t2 = 0.706845523804052*c6 + 0.2821950289584464*s6;
    const rx90_real t3 = lam3_32 + lam2_31;
    const rx90_real t4 = qdd[1]*s2 + c2*(ww2_zz - lam2_33);
    const rx90_real t5 = qdd[1]*c2 - (s2*ww2_zz - 21.77777777777778);
    const rx90_real t6 = c23*t4 - s23*t5 - lam3_12;
    const rx90_real t7 = c4*t3 - s4*t6;
    const rx90_real t8 = 0.47205526469446013*c6 - 0.5674357966404597*t2;
    const rx90_real t9 = 0.706845523804052*s6 - 0.2821950289584464*c6;
    const rx90_real t10 = s4*t3 + c4*t6;
    const rx90_real t11 = s23*t4 + c23*t5;
    const rx90_real t12 = t11 + lam3_22;
    const rx90_real t13 = c5*t10 - s5*t12;
    const rx90_real t14 = 0.1601275610650136*c6 + 0.07096581179296485*s6;
    const rx90_real t15 = lam5_31 - qdd[5];
    const rx90_real t16 = 0.31005692653217237*c6;
    const rx90_real t17 = c6*t16;
    const rx90_real t18 = s6*t16;
    const rx90_real t19 = t17 + (0.8915767942352734*t18 + 0.13354610634435332);
    const rx90_real t20 = t19 - 0.5771491392208791;
    const rx90_real t21 = qdd[5] + lam5_13;
    const rx90_real t22 = t2*t7 - t8*lam5_12 - (t9*t13 - t14*lam5_32 + t15*t19) - t20*t21;
    const rx90_real t23 = t18 - 0.13821978029399798*(6.450428385422554*t17 - 1.0);
    const rx90_real t24 = ww5_xx - ww5_zz;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_z = t22 - t23*t24;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_11 = t24 - neg_lam4_22;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real t25 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_11 = lam3_22 + t25;
    const rx90_real lam4_13 = ww4_zx - neg_alpha4_y;
    const rx90_real lam4_23 = ww4_yz - alpha4_x;
    const rx90_real t26 = s5*t10 + c5*t12;
    const rx90_real t27 = 2.0*w6_z;
    const rx90_real t28 = lam5_32 - w5_z*t27;
    const rx90_real t29 = w5_x*t27 - lam5_12;
    const rx90_real t30 = ww5_zz - ww6_zz;
    const rx90_real t31 = t30 + t24;
    const rx90_real t32 = t26*(t2 + 0.40383849355176565) - (t28*t23 - (0.09969734753381411*lam5_12 -
        t19*t29) + t8*t21 + t14*t31);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_z = 0.4973859781056681*lam5_21 + (0.3630349860955984*t13 -
        (0.06545842652927093*lam5_13 - 0.022422989561630666*lam5_23 + t32 -
        0.04994749004669093*(neg_lam5_22 + lam5_11)));
    const rx90_real t33 = t28*t20 - (0.3630349860955984*t7 - 0.022422989561630666*lam5_21) + ((t9 -
        0.48442678791853194)*t26 - t29*t23);
    const rx90_real t34 = 0.04994749004669093*lam5_31 + t14*t15 - (0.09969734753381411*lam5_32 -
        t30*t8) + t33 + 0.06545842652927093*(neg_lam4_22 - neg_lam5_22);
    const rx90_real t35 = neg_lam4_22 + lam3_22;
    const rx90_real t36 = 0.40383849355176565*t7 + 0.06545842652927093*lam5_12 +
        (0.04994749004669093*lam5_32 + 0.48442678791853194*t13) + (nc6_z + (0.022422989561630666*t24
        - 0.4973859781056681*lam5_31));
    const rx90_real t37 = c5*t34 - (4.226760246817004*t7 + 0.09181695932507075*lam4_31) +
        (-0.7570061710726514*lam4_32 - (0.02981305527252843*t35 - s5*t36));
    const rx90_real t38 = 0.1094831940191231*lam4_21 + t37;
    const rx90_real t39 = t9*t21 - t2*(t31 - neg_lam5_22) - 0.40383849355176565*lam5_11 +
        (0.3630349860955984*lam5_12 - 0.48442678791853194*lam5_13);
    const rx90_real t40 = 0.48442678791853194*lam5_23 + (t2*t29 + (0.3630349860955984*neg_lam5_22 +
        0.40383849355176565*lam5_21) + t28*t9);
    const rx90_real t41 = c5*t39 + (s5*t40 + 0.09791727023389989*lam4_11 +
        4.226760246817004*lam4_13);
    const rx90_real t42 = t9*(t30 - neg_lam5_22) + (0.3630349860955984*lam5_32 -
        4.226760246817004*lam4_23 - (0.09791727023389989*lam4_21 - 0.48442678791853194*neg_lam4_22)
        - t15*t2);
    const rx90_real t43 = t42 - 0.40383849355176565*lam5_31;
    const rx90_real t44 = s4*t41 - (0.06558551272001446*lam3_31 + c4*t43);
    const rx90_real t45 = 4.226760246817004*t10 - 0.02981305527252843*lam4_12 + (n5_z +
        0.09791727023389989*t12) - (0.1094831940191231*t25 - 0.09181695932507075*lam4_32 -
        0.1886810537096668*lam4_31);
    const rx90_real t46 = lam3_22 - lam2_33;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = -0.1093030288471206*lam3_21 - (c4*t38 + 3.0574321390485957*lam3_32 + (t44
        - s4*t45 + 0.0672049454639226*t46));
    const rx90_real t47 = 0.1886810537096668*lam4_21 - (s5*t34 - 0.1094831940191231*lam4_23 +
        0.09181695932507075*(t35 + t25)) - 0.02981305527252843*lam4_13;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_z = t47 + (-0.7570061710726514*lam4_12 - (0.09791727023389989*t7 - c5*t36));
    const rx90_real t48 = ww3_zz - ww3_xx;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_y = 0.1800707921647878*lam2_31 - 0.06558551272001446*lam3_32 -
        0.19252101484679798*lam3_31 - (0.1093030288471206*t48 - 0.0672049454639226*lam3_12 - n4_z);
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    const rx90_real t49 = 0.09496171507178643*c2;
    const rx90_real t50 = 0.017315109477737248*s2 + t49;
    const rx90_real t51 = 0.09496171507178643*s2;
    const rx90_real t52 = 0.017315109477737248*c2 - t51;
    const rx90_real t53 = 7.0674063888484*c2;
    const rx90_real t54 = t51*t53;
    const rx90_real t55 = t49*t53;
    const rx90_real t56 = 6.104207957983257*t54 + (t55 - 0.3355665158971724);
    const rx90_real t57 = qdd[1]*t50 + (ww2_zz*t52 + t1*t56) + qdd[0]*(t54 - (6.104207957983257*t55
        + 1.1871933280055555));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const rx90_real n1_z = n03_y - (t57 - c2*(t44 + 0.24565630488480228*lam3_31));
    const rx90_real t58 = t46 + t48;
    const rx90_real t59 = c4*t41 + s4*t43;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_z = c4*t45 - (0.1800707921647878*t11 - 0.06558551272001446*t58) -
        0.1093030288471206*neg_lam3_23 - (-3.0574321390485957*lam3_12 - (0.19252101484679798*lam3_21
        - (0.0672049454639226*lam3_13 + t59)) - s4*t38);
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_11 = lam3_22 - t58;
    const rx90_real t60 = t59 - 0.1800707921647878*lam3_11;
    const rx90_real t61 = c5*t40 - s5*t39 - 0.09791727023389989*lam4_31 +
        (0.1800707921647878*lam3_21 - 4.226760246817004*lam3_22);
    const rx90_real t62 = 5.195184633739834*qdd[1] + c2*(s23*t60 - c23*t61) - (qdd[0]*t50 - n3_z) -
        lam2_33*t56;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_z = 4681.18660659102*(t52 + 0.09865834996998242*s2) + (t62 - s2*(c23*t60 +
        s23*t61));
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 24 multiplications, 18 additions = 42; 0 unary minus; 10 sine/cosine */
void rx90_gravity(const rx90_real q[6], rx90_real tau[6])
{
    /* sines and cosines of the joint angles */
    const rx90_real s6 = sin(q[5]);
    const rx90_real c6 = cos(q[5]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real neg_hw6_y = 15.393524740621578*s6 - 6.14558063065061*c6;
    /* sines and cosines of the joint angles */
    const rx90_real c5 = cos(q[4]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real angle23 = q[1] + q[2];
    const rx90_real s23 = sin(angle23);
    const rx90_real s5 = sin(q[4]);
    const rx90_real c23 = cos(angle23);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real neg_hw6_x = 15.393524740621578*c6 + 6.14558063065061*s6;
    /* sines and cosines of the joint angles */
    const rx90_real s4 = sin(q[3]);
    const rx90_real t1 = c4*s23;
    const rx90_real t2 = s23*s4;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const rx90_real tau6 = neg_hw6_y*(c5*t1 + s5*c23) + neg_hw6_x*t2;
    const rx90_real t3 = neg_hw6_x + 8.794704970682897;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real neg_hw5_y = s5*t3 - 7.906095252748588*c5;
    const rx90_real neg_hw5_x = c5*t3 + 7.906095252748588*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const rx90_real tau5 = t1*neg_hw5_y - c23*neg_hw5_x;
    const rx90_real t4 = neg_hw6_y - 10.549738936892474;
    const rx90_real t5 = neg_hw5_x - 2.1324205517604864;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const rx90_real tau4 = t1*t4 + t2*t5;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real hw4_x = s4*t4 - c4*t5;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real hw3_x = s23*(neg_hw5_y - 92.04944537512587) - c23*(3.921541696033157 - hw4_x);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const rx90_real hw2_x = hw3_x + (81.05525857884084*c2 + 17.30463777489202*s2);
    tau[0] = 0.0;
    tau[1] = hw2_x;
    tau[2] = hw3_x;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 191 multiplications, 173 additions = 364; 0 unary minus; 10 sine/cosine */
void rx90_bias(const rx90_real q[6], const rx90_real qd[6], rx90_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const rx90_real angle23 = q[1] + q[2];
    const rx90_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const rx90_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_yz = w3_z*w3_y;
    const rx90_real ww3_zx = w3_z*w3_x;
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_32 = 2.0*ww3_yz;
    /* sines and cosines of the joint angles */
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = w3_x*c4 - w3_z*s4;
    const rx90_real w4_z = w3_y + qd[3];
    const rx90_real neg_w4_y = w3_x*s4 + w3_z*c4;
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real neg_ww4_xy = w4_x*neg_w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_zz = w4_z*w4_z;
    const rx90_real neg_ww4_yz = w4_z*neg_w4_y;
    const rx90_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam4_21 = ww3_zx + neg_ww4_xy;
    const rx90_real lam4_12 = ww3_zx - neg_ww4_xy;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* sines and cosines of the joint angles */
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = w4_x*c5 + w4_z*s5;
    const rx90_real w5_z = neg_w4_y + qd[4];
    const rx90_real w5_y = w4_z*c5 - w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_zz = w5_z*w5_z;
    const rx90_real ww5_yz = w5_z*w5_y;
    const rx90_real ww5_xy = w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(q[5]);
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = ww3_yz*c4 - qd[3]*neg_w4_y;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real neg_alpha5_y = ww3_zx*c5 + (w5_x*qd[4] + s5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_31 = ww5_zx + neg_alpha5_y;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x - (ww3_zx*s5 - qd[4]*w5_y);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_32 = ww5_yz + alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_zz = w6_z*w6_z;
    const rx90_real t1 = 2.0*(qd[1]*qd[0]);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam2_31 = s2*t1;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam2_33 = qd[0]*qd[0];
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real neg_alpha4_y = ww3_yz*s4 + w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_21 = ww5_xy + neg_alpha4_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xx = w3_x*w3_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_22 = ww3_zz + ww3_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_12 = ww5_xy - neg_alpha4_y;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_31 = ww4_zx + neg_alpha4_y;
    const rx90_real neg_lam4_32 = neg_ww4_yz - alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_13 = ww5_zx - neg_alpha5_y;
    const rx90_real t2 = 0.706845523804052*c6 + 0.2821950289584464*s6;
    const rx90_real t3 = lam3_32 + lam2_31;
    const rx90_real t4 = c2*(ww2_zz + neg_lam2_33);
    const rx90_real t5 = s2*ww2_zz - 21.77777777777778;
    const rx90_real t6 = ww3_xy - (c23*t4 + s23*t5);
    const rx90_real t7 = c4*t3 + s4*t6;
    const rx90_real t8 = 0.47205526469446013*c6 - 0.5674357966404597*t2;
    const rx90_real t9 = 0.706845523804052*s6 - 0.2821950289584464*c6;
    const rx90_real t10 = s4*t3 - c4*t6;
    const rx90_real t11 = s23*t4 - c23*t5;
    const rx90_real t12 = t11 - neg_lam3_22;
    const rx90_real t13 = c5*t10 - s5*t12;
    const rx90_real t14 = 0.1601275610650136*c6 + 0.07096581179296485*s6;
    const rx90_real t15 = 0.31005692653217237*c6;
    const rx90_real t16 = c6*t15;
    const rx90_real t17 = s6*t15;
    const rx90_real t18 = t16 + 0.8915767942352734*(t17 + 0.1497864314188426);
    const rx90_real t19 = t18 - 0.5771491392208791;
    const rx90_real t20 = t2*t7 - t8*lam5_12 - (t9*t13 - t14*lam5_32 + lam5_31*t18) - t19*lam5_13;
    const rx90_real t21 = t17 - 0.8915767942352734*(t16 - 0.15502846326608619);
    const rx90_real t22 = ww5_xx - ww5_zz;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_z = t20 - t21*t22;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_11 = t22 - neg_lam4_22;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real t23 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_11 = t23 - neg_lam3_22;
    const rx90_real lam4_13 = ww4_zx - neg_alpha4_y;
    const rx90_real neg_lam4_23 = neg_ww4_yz + alpha4_x;
    const rx90_real t24 = ww5_zz - ww6_zz;
    const rx90_real t25 = t24 + t22;
    const rx90_real t26 = 2.0*w6_z;
    const rx90_real t27 = w5_x*t26 - lam5_12;
    const rx90_real t28 = lam5_32 - w5_z*t26;
    const rx90_real t29 = s5*t10 + c5*t12;
    const rx90_real t30 = t2 + 0.40383849355176565;
    const rx90_real t31 = t28*t21 - (t29*t30 - 0.3630349860955984*(t13 + 1.3700772574428703*lam5_21
        + 0.06176536813376437*lam5_23)) - 0.09969734753381411*lam5_12;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_z = t14*t25 + (t18*t27 + t31) + 0.04994749004669093*(neg_lam5_22 + lam5_11) +
        lam5_13*(t8 - 0.06545842652927093);
    const rx90_real t32 = t9 - 0.48442678791853194;
    const rx90_real t33 = t32*t29 + (t28*t19 + (t24*t8 - 0.09969734753381411*lam5_32) -
        0.3630349860955984*t7 + 0.022422989561630666*lam5_21);
    const rx90_real t34 = t27*t21 - t33 - 0.06545842652927093*(neg_lam4_22 - neg_lam5_22) -
        lam5_31*(t14 + 0.04994749004669093);
    const rx90_real t35 = nc6_z + 0.022422989561630666*(t22 - 22.18196537703319*lam5_31) +
        0.40383849355176565*(t7 + 0.16209060694923627*lam5_12 + 1.1995557522463771*(t13 +
        0.10310637498248922*lam5_32));
    const rx90_real t36 = neg_lam4_22 - neg_lam3_22;
    const rx90_real t37 = c5*t34 + 4.226760246817004*(t7 + 0.02172277440959994*lam4_31) - (s5*t35 -
        0.02981305527252843*t36 + 0.7570061710726514*neg_lam4_32);
    const rx90_real t38 = t37 + 0.1094831940191231*neg_lam4_21;
    const rx90_real t39 = t2*(neg_lam5_22 - t25) - 0.40383849355176565*lam5_11 +
        0.3630349860955984*lam5_12 + t32*lam5_13;
    const rx90_real t40 = t2*t27 + 0.3630349860955984*(neg_lam5_22 + 1.1123955238997885*lam5_21) +
        t28*t9 + 0.48442678791853194*lam5_23;
    const rx90_real t41 = c5*t39 + (s5*t40 + 0.09791727023389989*lam4_11 +
        4.226760246817004*lam4_13);
    const rx90_real t42 = t9*(t24 - neg_lam5_22) + 0.3630349860955984*lam5_32 +
        4.226760246817004*neg_lam4_23 + 0.09791727023389989*neg_lam4_21 +
        0.48442678791853194*neg_lam4_22;
    const rx90_real t43 = t42 - lam5_31*t30;
    const rx90_real t44 = s4*t41 - (c4*t43 + 0.13117102544002893*ww3_zx);
    const rx90_real t45 = n5_z + 0.09791727023389989*t12 + 4.226760246817004*(t10 -
        0.007053405807670163*lam4_12) - 0.1094831940191231*(t23 + 0.838639757888625*neg_lam4_32 -
        1.7233791487368413*lam4_31);
    const rx90_real t46 = neg_lam2_33 - neg_lam3_22;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = c4*t38 - 6.114864278097191*ww3_yz - (t44 - s4*t45 +
        0.0672049454639226*t46) - 0.1093030288471206*ww3_xy;
    const rx90_real t47 = s5*t34 - 0.1094831940191231*neg_lam4_23 - 0.09181695932507075*(t36 + t23)
        - 0.1886810537096668*neg_lam4_21 - 0.02981305527252843*lam4_13;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_z = t47 + (c5*t35 - 0.09791727023389989*t7 - 0.7570061710726514*lam4_12);
    const rx90_real t48 = ww3_zz - ww3_xx;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_y = n4_z - 0.1093030288471206*(t48 - 0.6148498003465253*ww3_xy) +
        0.1800707921647878*(lam2_31 - 0.7284414305235613*ww3_yz - 2.138281422904128*ww3_zx);
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    const rx90_real t49 = 0.6711330317943448*(c2*c2) - 0.3355665158971724 +
        4.09673559354447*(c2*s2);
    const rx90_real t50 = s2 - 0.18233779228447872*c2;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const rx90_real n1_z = n03_y - (t1*t49 - 0.09496171507178643*(ww2_zz*t50) - c2*(t44 +
        0.49131260976960456*ww3_zx));
    const rx90_real t51 = c4*t41 + s4*t43;
    const rx90_real t52 = t46 + t48;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_z = 3.249953153895394*ww3_xy - (s4*t38 + (t51 - (c4*t45 -
        0.1800707921647878*t11 + 0.06558551272001446*t52)));
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_11 = neg_lam3_22 + t52;
    const rx90_real t53 = c5*t40 - s5*t39 - 0.09791727023389989*lam4_31 +
        4.226760246817004*(neg_lam3_22 + 0.04260255648528718*ww3_xy);
    const rx90_real t54 = t51 + 0.1800707921647878*neg_lam3_11;
    const rx90_real t55 = neg_lam2_33*t49 - (c2*(c23*t53 - s23*t54) - n3_z) - s2*(c23*t54 +
        s23*t53);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_z = t55 + 461.83814650785126*(s2 - 0.962530947463436*t50);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 105 multiplications, 94 additions = 199; 1 unary minus; 10 sine/cosine */
void rx90_mass_matrix(const rx90_real q[6], rx90_real M[36])
{
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(q[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(q[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(q[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(q[5]);
    const rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_xz = -0.07096581179296485*s6 - 0.1601275610650136*c6;
    const rx90_real t1 = 0.3992315427559742*k6_xz;
    const rx90_real t2 = 0.1884593515900491*s6 + t1;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h6_y = 9.809478269877111*t2;
    const rx90_real t3 = 0.007037838551227997*c6;
    const rx90_real h6_x = 22.13414869766047*(t1 - t3);
    const rx90_real t4 = 0.8974188745594792 - h6_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h5_x = 0.8067444135457743*s5 + c5*t4;
    const rx90_real t5 = neg_h6_y - 1.0765039731522932;
    const rx90_real t6 = neg_h5_x - 0.21759393385311085;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h4_x = s4*t5 - c4*t6;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h5_y = 0.8067444135457743*c5 - s5*t4;
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_yz = t3 - t2;
    const rx90_real t7 = 0.31005692653217237*c6;
    const rx90_real t8 = s6*t7 + 0.1157967907323673;
    const rx90_real t9 = c6*t7;
    const rx90_real t10 = t8 - 0.8915767942352734*t9;
    const rx90_real t11 = k6_yz - 0.06545842652927093;
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real neg_k5_yz = s5*t10 + c5*t11;
    const rx90_real t12 = neg_k5_yz + 0.02981305527252843;
    const rx90_real t13 = c5*s5;
    const rx90_real t14 = t9 + (0.8915767942352734*t8 - 1.303850935413074);
    const rx90_real t15 = t14 + 1.7318439408653845;
    const rx90_real t16 = c5*c5;
    const rx90_real t17 = 0.09989498009338187 - k6_xz - k6_xz;
    const rx90_real t18 = t13*t15 - ((t16 - 0.5)*t17 - 0.1094831940191231);
    /* link 4: second moment of the composite body [kg m^2] */
    const rx90_real neg_k4_xz = s4*t12 - c4*t18;
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real k5_xz = s5*t11 - c5*t10;
    /* link 5: mass matrix, its row of this joint */
    const rx90_real m5_5 = t14 + 1.9312386359330127;
    const rx90_real t19 = t13*t17 + (t15*t16 + 0.2883784012434809);
    /* link 4: mass matrix, its row of this joint */
    const rx90_real m4_4 = t19 - t14;
    const rx90_real t20 = 0.45*c2;
    const rx90_real t21 = c23*t20;
    const rx90_real t22 = h4_x - 0.4001573159217507;
    const rx90_real t23 = s23*t20;
    const rx90_real t24 = h5_y + 9.392800548482231;
    const rx90_real t25 = t21*t22 - t23*t24;
    const rx90_real t26 = 0.45*h4_x;
    const rx90_real t27 = neg_k4_xz - t26;
    const rx90_real t28 = t25 + (t27 - 0.06558551272001446)*(c23*s23);
    const rx90_real t29 = 0.09496171507178643*c2;
    const rx90_real t30 = c4*s4;
    const rx90_real t31 = 0.1836339186501415 - 2.0*k5_xz;
    const rx90_real t32 = c4*c4;
    const rx90_real t33 = t14 + t19;
    const rx90_real t34 = t14 - 0.19252101484679798 + t30*t31 - t32*t33;
    const rx90_real t35 = 0.45*h5_y;
    const rx90_real t36 = t35 + m5_5;
    const rx90_real t37 = t35 + 5.584769408295079 + t36 - t19;
    /* link 1: mass matrix, its row of this joint */
    const rx90_real m1_1 = t28 + (t29*(43.140918321110114*c2 - 7.0674063888484*s2) + (t28 +
        1.3797143428523535)) + ((t34 + t37)*(s23*s23) + m4_4);
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h4_y = c4*t5 + s4*t6;
    const rx90_real t38 = 0.45*neg_h4_y;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_4 = c4*t12 - (t38 - s4*t18);
    /* link 3: second moment of the composite body [kg m^2] */
    const rx90_real neg_k3_yz = s23*(t30*t33 + (k5_xz + (t31*t32 - 0.20111998817219134))) +
        c23*(m3_4 - 0.0672049454639226);
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real neg_k2_yz = neg_k3_yz - t29 - s2*(t38 + 0.017315109477737248);
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y = s23*t27 + c2*t26 + c23*m4_4;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y = c23*neg_k5_yz + s23*(s4*t36 - c4*k5_xz);
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_x = c5*neg_h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const rx90_real nu5_y = 0.5771491392208791*c5 - s5*k6_xz;
    const rx90_real nu5_x = -0.5771491392208791*s5 - c5*k6_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x = s4*k6_yz + c4*nu5_x;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h3_y = c23*t24 + s23*t22;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_3 = t37 - t34;
    const rx90_real t39 = 0.45*s2;
    const rx90_real t40 = t25 + t39*h3_y;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_3 = t40 + m3_3;
    const rx90_real m2_2 = t40 + (m2_3 + 5.195184633739834);
    const rx90_real t41 = c23*t39 - t23;
    const rx90_real m2_4 = m3_4 - neg_h4_y*t41;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_5 = c4*t36 + s4*k5_xz;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real neg_fu4_x = c4*h5_y;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_5 = m3_5 + neg_h5_x*(-s23*t39 - t21) + t41*neg_fu4_x;
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_y = s5*neg_h6_y;
    const rx90_real t42 = c4*fu5_x - s4*h6_x;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_6 = c4*k6_yz - 0.45*t42 - s4*nu5_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x = c23*t42 - s23*fu5_y;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_6 = t21*fu5_y + m3_6 + (t23*t42 - t39*fu3_x);
    const rx90_real t43 = nu3_y - s4*(c2*t35);
    const rx90_real t44 = 0.45*fu4_y;
    const rx90_real t45 = c2*t44 + (c23*nu5_y - s23*(t44 - nu4_x));
    M[0] = m1_1;
    M[1] = neg_k2_yz;
    M[2] = neg_k3_yz;
    M[3] = nu2_y;
    M[4] = t43;
    M[5] = t45;
    M[6] = neg_k2_yz;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = neg_k3_yz;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = m3_6;
    M[18] = nu2_y;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = neg_k5_yz;
    M[23] = nu5_y;
    M[24] = t43;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = neg_k5_yz;
    M[28] = m5_5;
    M[29] = k6_yz;
    M[30] = t45;
    M[31] = m2_6;
    M[32] = m3_6;
    M[33] = nu5_y;
    M[34] = k6_yz;
    M[35] = 0.5771491392208791;
}

/* accelerations that the torques tau give
 * 376 multiplications, 336 additions, 5 divisions = 717; 14 unary minus; 10 sine/cosine */
void rx90_forward_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real tau[6],
    rx90_real qdd[6])
{
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const rx90_real angle23 = q[1] + q[2];
    const rx90_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const rx90_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_yz = w3_z*w3_y;
    const rx90_real ww3_zx = w3_z*w3_x;
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_32 = 2.0*ww3_yz;
    /* sines and cosines of the joint angles */
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = w3_x*c4 - w3_z*s4;
    const rx90_real w4_z = w3_y + qd[3];
    const rx90_real w4_y = -w3_z*c4 - w3_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real ww4_xy = w4_x*w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_zz = w4_z*w4_z;
    const rx90_real ww4_yz = w4_z*w4_y;
    const rx90_real ww4_zx = w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_21 = ww4_xy - ww3_zx;
    const rx90_real lam4_12 = ww3_zx + ww4_xy;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* sines and cosines of the joint angles */
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = w4_x*c5 + w4_z*s5;
    const rx90_real w5_z = qd[4] - w4_y;
    const rx90_real w5_y = w4_z*c5 - w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_zz = w5_z*w5_z;
    const rx90_real ww5_yz = w5_z*w5_y;
    const rx90_real ww5_xy = w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(q[5]);
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(q[1]);
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = ww3_yz*c4 + qd[3]*w4_y;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real neg_alpha5_y = ww3_zx*c5 + (w5_x*qd[4] + s5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_31 = ww5_zx + neg_alpha5_y;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x - (ww3_zx*s5 - qd[4]*w5_y);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_32 = ww5_yz + alpha5_x;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_zz = w6_z*w6_z;
    const rx90_real t1 = 2.0*(qd[1]*qd[0]);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam2_31 = s2*t1;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam2_33 = -qd[0]*qd[0];
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real neg_alpha4_y = ww3_yz*s4 + w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_21 = ww5_xy + neg_alpha4_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xx = w3_x*w3_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_22 = -ww3_zz - ww3_xx;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_12 = ww5_xy - neg_alpha4_y;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_31 = ww4_zx + neg_alpha4_y;
    const rx90_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam5_13 = ww5_zx - neg_alpha5_y;
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_xz = -0.07096581179296485*s6 - 0.1601275610650136*c6;
    const rx90_real t2 = 0.706845523804052*c6 + 0.2821950289584464*s6;
    const rx90_real t3 = lam3_32 + lam2_31;
    const rx90_real t4 = c2*(ww2_zz - lam2_33);
    const rx90_real t5 = s2*ww2_zz - 21.77777777777778;
    const rx90_real t6 = ww3_xy - (c23*t4 + s23*t5);
    const rx90_real t7 = c4*t3 + s4*t6;
    const rx90_real t8 = 0.47205526469446013*c6 - 0.5674357966404597*t2;
    const rx90_real t9 = 0.706845523804052*s6 - 0.2821950289584464*c6;
    const rx90_real t10 = s4*t3 - c4*t6;
    const rx90_real t11 = c23*t5 - s23*t4;
    const rx90_real t12 = t11 - lam3_22;
    const rx90_real t13 = c5*t10 + s5*t12;
    const rx90_real t14 = 0.31005692653217237*c6;
    const rx90_real t15 = c6*t14;
    const rx90_real t16 = s6*t14;
    const rx90_real t17 = t15 + 0.8915767942352734*(t16 + 0.1497864314188426);
    const rx90_real t18 = t17 - 0.5771491392208791;
    const rx90_real t19 = t2*t7 - lam5_12*t8 - (t9*t13 + lam5_32*k6_xz + lam5_31*t17) - lam5_13*t18;
    const rx90_real t20 = 0.8915767942352734*t15;
    const rx90_real t21 = t16 - (t20 - 0.13821978029399798);
    const rx90_real t22 = ww5_xx - ww5_zz;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_z = t19 - t21*t22;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam5_11 = neg_lam4_22 - t22;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real t23 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam4_11 = lam3_22 + t23;
    const rx90_real lam4_13 = ww4_zx - neg_alpha4_y;
    const rx90_real lam4_23 = ww4_yz - alpha4_x;
    const rx90_real t24 = 2.0*w6_z;
    const rx90_real t25 = lam5_32 - w5_z*t24;
    const rx90_real t26 = s5*t10 - c5*t12;
    const rx90_real t27 = t2 + 0.40383849355176565;
    const rx90_real t28 = t21*t25 - (t26*t27 - 0.022422989561630666*(lam5_23 +
        22.18196537703319*(lam5_21 + 0.7298858473619311*t13))) - 0.09969734753381411*lam5_12;
    const rx90_real t29 = lam5_12 - w5_x*t24;
    const rx90_real t30 = ww5_zz - ww6_zz;
    const rx90_real t31 = t22 + t30;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_z = t28 - t17*t29 - k6_xz*t31 + 0.04994749004669093*(neg_lam5_22 -
        neg_lam5_11) + lam5_13*(t8 - 0.06545842652927093);
    const rx90_real t32 = t9 - 0.48442678791853194;
    const rx90_real t33 = t26*t32 + (t18*t25 + (t8*t30 - 0.09969734753381411*lam5_32) -
        0.3630349860955984*t7 + 0.022422989561630666*lam5_21);
    const rx90_real t34 = t21*t29 + t33 + 0.06545842652927093*(neg_lam4_22 - neg_lam5_22) +
        lam5_31*(0.04994749004669093 - k6_xz);
    const rx90_real t35 = nc6_z - 0.4973859781056681*(lam5_31 - 0.04508166805793422*t22) +
        0.48442678791853194*(t13 + 0.10310637498248922*lam5_32 + 0.13512553013538*(lam5_12 +
        6.169388953631232*t7));
    const rx90_real t36 = neg_lam4_22 + lam3_22;
    const rx90_real t37 = c5*t34 - 0.09181695932507075*(lam4_31 + 46.034635408176506*t7) + (s5*t35 -
        0.02981305527252843*t36 - 0.7570061710726514*lam4_32);
    const rx90_real t38 = t37 + 0.1094831940191231*lam4_21;
    const rx90_real t39 = 0.40383849355176565*neg_lam5_11 - t2*(t31 - neg_lam5_22) +
        0.3630349860955984*lam5_12 + lam5_13*t32;
    const rx90_real t40 = t2*t29 - 0.40383849355176565*(lam5_21 + 0.8989608268956737*neg_lam5_22) -
        t9*t25 - 0.48442678791853194*lam5_23;
    const rx90_real t41 = c5*t39 - (s5*t40 - 0.09791727023389989*lam4_11 -
        4.226760246817004*lam4_13);
    const rx90_real t42 = -0.3630349860955984*lam5_32 - t9*(t30 - neg_lam5_22) +
        4.226760246817004*lam4_23 + 0.09791727023389989*lam4_21 - 0.48442678791853194*neg_lam4_22;
    const rx90_real t43 = t42 + lam5_31*t27;
    const rx90_real t44 = s4*t41 + (c4*t43 - 0.13117102544002893*ww3_zx);
    const rx90_real t45 = n5_z - 0.09791727023389989*t12 - 0.02981305527252843*(lam4_12 -
        141.7754808482108*t10) + 0.1886810537096668*(lam4_31 -
        0.4866252202849906*(1.1924070980341053*t23 - lam4_32));
    const rx90_real t46 = lam3_22 - lam2_33;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = -0.1093030288471206*ww3_xy - (c4*t38 + 6.114864278097191*ww3_yz + (t44 -
        s4*t45 + 0.0672049454639226*t46));
    const rx90_real t47 = s5*t34 - 0.1094831940191231*lam4_23 + 0.09181695932507075*(t23 + t36) -
        0.1886810537096668*lam4_21 + 0.02981305527252843*lam4_13;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_z = c5*t35 - 0.09791727023389989*t7 - 0.7570061710726514*lam4_12 - t47;
    const rx90_real t48 = ww3_zz - ww3_xx;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_y = n4_z + 0.0672049454639226*(ww3_xy - 1.6264134743744028*t48) -
        0.38504202969359597*(ww3_zx + 0.3406667722596689*(ww3_yz - 1.3727939654410626*lam2_31));
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    const rx90_real t49 = 0.6711330317943448*(c2*c2 - 0.5) + 4.09673559354447*(c2*s2);
    const rx90_real t50 = s2 - 0.18233779228447872*c2;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const rx90_real n1_z = n03_y - (t1*t49 - 0.09496171507178643*(ww2_zz*t50) - c2*(t44 +
        0.49131260976960456*ww3_zx));
    const rx90_real t51 = c4*t41 - s4*t43;
    const rx90_real t52 = t46 + t48;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_z = s4*t38 - (t51 - (c4*t45 + 0.1800707921647878*t11 +
        0.06558551272001446*t52)) + 3.249953153895394*ww3_xy;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real lam3_11 = lam3_22 - t52;
    const rx90_real t53 = c5*t40 + s5*t39 + 0.09791727023389989*lam4_31 - 0.1800707921647878*(ww3_xy
        - 23.472769770174487*lam3_22);
    const rx90_real t54 = t51 - 0.1800707921647878*lam3_11;
    const rx90_real t55 = n3_z + c2*(c23*t53 + s23*t54) - lam2_33*t49 - s2*(c23*t54 - s23*t53);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_z = t55 - 444.53350873295926*(t50 - 1.0389276341039282*s2);
    const rx90_real t56 = 0.3992315427559742*k6_xz;
    const rx90_real t57 = 0.1884593515900491*s6 + t56;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h6_y = 9.809478269877111*t57;
    const rx90_real t58 = 0.007037838551227997*c6;
    const rx90_real h6_x = 22.13414869766047*(t56 - t58);
    const rx90_real t59 = 0.8974188745594792 - h6_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h5_x = -0.8067444135457743*s5 - c5*t59;
    const rx90_real t60 = neg_h6_y - 1.0765039731522932;
    const rx90_real t61 = h5_x + 0.21759393385311085;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h4_x = s4*t60 + c4*t61;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h5_y = s5*t59 - 0.8067444135457743*c5;
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_yz = t58 - t57;
    const rx90_real t62 = t20 - (t16 + 0.1157967907323673);
    const rx90_real t63 = 0.06545842652927093 - k6_yz;
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real k5_yz = s5*t62 + c5*t63;
    const rx90_real t64 = k5_yz - 0.02981305527252843;
    const rx90_real t65 = c5*s5;
    const rx90_real t66 = t15 + 0.8915767942352734*(t16 - 1.346613339099935);
    const rx90_real t67 = t66 + 1.7318439408653845;
    const rx90_real t68 = c5*c5;
    const rx90_real t69 = 0.09989498009338187 - k6_xz - k6_xz;
    const rx90_real t70 = t65*t67 + ((0.5 - t68)*t69 + 0.1094831940191231);
    /* link 4: second moment of the composite body [kg m^2] */
    const rx90_real k4_xz = s4*t64 + c4*t70;
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real k5_xz = c5*t62 - s5*t63;
    /* link 5: mass matrix, its row of this joint */
    const rx90_real m5_5 = t66 + 1.9312386359330127;
    const rx90_real t71 = t65*t69 + (t67*t68 + 0.2883784012434809);
    /* link 4: mass matrix, its row of this joint */
    const rx90_real m4_4 = t71 - t66;
    const rx90_real t72 = 0.45*c2;
    const rx90_real t73 = c23*t72;
    const rx90_real t74 = h4_x - 0.4001573159217507;
    const rx90_real t75 = s23*t72;
    const rx90_real t76 = neg_h5_y - 9.392800548482231;
    const rx90_real t77 = t73*t74 + t75*t76;
    const rx90_real t78 = 0.45*h4_x;
    const rx90_real t79 = k4_xz + t78;
    const rx90_real t80 = t77 - (t79 + 0.06558551272001446)*(s23*c23);
    const rx90_real t81 = c4*s4;
    const rx90_real t82 = 0.1836339186501415 - 2.0*k5_xz;
    const rx90_real t83 = c4*c4;
    const rx90_real t84 = t66 + t71;
    const rx90_real t85 = t66 - 0.19252101484679798 + t81*t82 - t83*t84;
    const rx90_real t86 = 0.45*neg_h5_y;
    const rx90_real t87 = m5_5 - t86;
    const rx90_real t88 = t71 + (t86 - 5.584769408295079 - t87);
    /* link 1: mass matrix, its row of this joint */
    const rx90_real m1_1 = t80 + (t80 + 1.3797143428523535 + 4.09673559354447*(c2*(c2 -
        0.1638214174358479*s2))) + (m4_4 + (t85 - t88)*(s23*s23));
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h4_y = s4*t61 - c4*t60;
    const rx90_real t89 = 0.45*h4_y;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_4 = s4*t70 + t89 - c4*t64;
    /* link 3: second moment of the composite body [kg m^2] */
    const rx90_real k3_yz = c23*(0.0672049454639226 - m3_4) - s23*(t81*t84 + (k5_xz + (t82*t83 -
        0.20111998817219134)));
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real k2_yz = k3_yz + 0.09496171507178643*c2 + s2*(0.017315109477737248 - t89);
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y = c23*m4_4 - (s23*t79 - c2*t78);
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y = s23*(s4*t87 - c4*k5_xz) - c23*k5_yz;
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_x = c5*neg_h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const rx90_real nu5_y = 0.5771491392208791*c5 - s5*k6_xz;
    const rx90_real nu5_x = -0.5771491392208791*s5 - c5*k6_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x = s4*k6_yz + c4*nu5_x;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h3_y = s23*t74 - c23*t76;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real neg_m3_3 = t85 + t88;
    const rx90_real t90 = 0.45*s2;
    const rx90_real t91 = t77 + h3_y*t90;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_3 = t91 - neg_m3_3;
    const rx90_real m2_2 = t91 + (m2_3 + 5.195184633739834);
    const rx90_real t92 = t75 - c23*t90;
    const rx90_real m2_4 = m3_4 - h4_y*t92;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_5 = c4*t87 + s4*k5_xz;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_x = c4*neg_h5_y;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_5 = m3_5 + h5_x*(t73 + s23*t90) + t92*fu4_x;
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_y = s5*neg_h6_y;
    const rx90_real t93 = c4*fu5_x - s4*h6_x;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_6 = -s4*nu5_x - (0.45*t93 - c4*k6_yz);
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x = c23*t93 - s23*fu5_y;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_6 = m3_6 + t73*fu5_y + (t75*t93 - t90*fu3_x);
    const rx90_real t94 = 0.45*fu4_y;
    /* factorisation M = U D U^T */
    const rx90_real ud1_6 = c2*t94 + (c23*nu5_y - s23*(t94 - nu4_x));
    /* link 6: forward substitution */
    const rx90_real y6 = tau[5] - nc6_z;
    /* factorisation M = U D U^T */
    const rx90_real u5_6 = 1.7326544077496977*k6_yz;
    const rx90_real u4_6 = 1.7326544077496977*nu5_y;
    const rx90_real u3_6 = 1.7326544077496977*m3_6;
    const rx90_real u2_6 = 1.7326544077496977*m2_6;
    const rx90_real u1_6 = 1.7326544077496977*ud1_6;
    const rx90_real pivot5 = m5_5 - k6_yz*u5_6;
    const rx90_real ipivot5 = 1.0 / pivot5;
    const rx90_real ud4_5 = -k5_yz - k6_yz*u4_6;
    const rx90_real u4_5 = ipivot5*ud4_5;
    const rx90_real neg_ud3_5 = k6_yz*u3_6 - m3_5;
    const rx90_real u3_5 = -ipivot5*neg_ud3_5;
    const rx90_real ud2_5 = m2_5 - k6_yz*u2_6;
    const rx90_real u2_5 = ipivot5*ud2_5;
    const rx90_real ud1_5 = nu3_y + s4*(c2*t86) - k6_yz*u1_6;
    const rx90_real u1_5 = ipivot5*ud1_5;
    const rx90_real t95 = -ud4_5;
    const rx90_real pivot4 = t95*u4_5 - (nu5_y*u4_6 - m4_4);
    const rx90_real ipivot4 = 1.0 / pivot4;
    const rx90_real ud3_4 = m3_4 - nu5_y*u3_6 - ud4_5*u3_5;
    const rx90_real u3_4 = ipivot4*ud3_4;
    const rx90_real ud2_4 = m2_4 - nu5_y*u2_6 - ud4_5*u2_5;
    const rx90_real u2_4 = ipivot4*ud2_4;
    const rx90_real ud1_4 = t95*u1_5 - (nu5_y*u1_6 - nu2_y);
    const rx90_real u1_4 = ipivot4*ud1_4;
    const rx90_real pivot3 = neg_ud3_5*u3_5 - (neg_m3_3 + m3_6*u3_6) - ud3_4*u3_4;
    const rx90_real ipivot3 = 1.0 / pivot3;
    const rx90_real ud2_3 = neg_ud3_5*u2_5 - (m3_6*u2_6 - m2_3) - ud3_4*u2_4;
    const rx90_real u2_3 = ipivot3*ud2_3;
    const rx90_real ud1_3 = neg_ud3_5*u1_5 - (k3_yz + m3_6*u1_6) - ud3_4*u1_4;
    const rx90_real u1_3 = ipivot3*ud1_3;
    const rx90_real pivot2 = m2_2 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3;
    const rx90_real ipivot2 = 1.0 / pivot2;
    const rx90_real ud1_2 = -ud2_5*u1_5 - (k2_yz + m2_6*u1_6) - ud2_4*u1_4 - ud2_3*u1_3;
    const rx90_real u1_2 = ipivot2*ud1_2;
    const rx90_real pivot1 = m1_1 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3 - ud1_2*u1_2;
    const rx90_real ipivot1 = 1.0 / pivot1;
    /* link 5: forward substitution */
    const rx90_real y5 = -y6*u5_6 - (n5_z - tau[4]);
    /* link 4: forward substitution */
    const rx90_real y4 = tau[3] - n4_z - y6*u4_6 - u4_5*y5;
    /* link 3: forward substitution */
    const rx90_real y3 = -u3_4*y4 - (n3_z - tau[2] + y6*u3_6 + u3_5*y5);
    /* link 2: forward substitution */
    const rx90_real y2 = -u2_4*y4 - (n02_z - tau[1] + y6*u2_6 + u2_5*y5) - u2_3*y3;
    /* link 1: forward substitution */
    const rx90_real y1 = tau[0] - n1_z - y6*u1_6 - u1_5*y5 - u1_4*y4 - u1_3*y3 - u1_2*y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd2 = ipivot2*y2 - u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd5 = -(u4_5*qdd4 - ipivot5*y5 + u3_5*qdd3 + u2_5*qdd2) - u1_5*qdd1;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd6 = -u1_6*qdd1 - (u5_6*qdd5 - 1.7326544077496977*y6 + u4_6*qdd4 + u3_6*qdd3 +
        u2_6*qdd2);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
