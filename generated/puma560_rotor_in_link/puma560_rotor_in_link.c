/*
 * puma560_rotor_in_link: PUMA 560, Tables 2.1, 2.5, 2.6, rotor folded into Izz as the thesis does
 * Numbers: Tables 2.1, 2.5, 2.6 with links 5 and 6 corrected
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 3944b9c8df3efa29ca11b7e595201cb9 (a hash of its numbers)
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 139 multiplications, 115 additions = 254; 0 unary minus; 8 sine/cosine
 *   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
 *   bias: 125 multiplications, 90 additions = 215; 1 unary minus; 8 sine/cosine
 *   mass_matrix: 60 multiplications, 54 additions = 114; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 247 multiplications, 201 additions, 4 divisions = 452; 3 unary minus; 8
 *       sine/cosine
 */
#include "puma560_rotor_in_link.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 139 multiplications, 115 additions = 254; 0 unary minus; 8 sine/cosine */
void puma560_rotor_in_link_inverse_dynamics(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    const puma560_rotor_in_link_real qdd[6],
    puma560_rotor_in_link_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real angle23 = q[1] + q[2];
    const puma560_rotor_in_link_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_y = c23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_x = qd[0]*s23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real neg_ww3_yz = w3_z*neg_w3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real neg_alpha3_x = neg_ww3_yz + s23*qdd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real neg_alpha3_y = neg_lam3_13 - neg_ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_rotor_in_link_real ww3_zz = w3_z*w3_z;
    const puma560_rotor_in_link_real ww3_xy = neg_w3_y*neg_w3_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_rotor_in_link_real neg_lam3_12 = alpha3_z - ww3_xy;
    const puma560_rotor_in_link_real lam3_31 = neg_alpha3_y - neg_ww3_zx;
    const puma560_rotor_in_link_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    const puma560_rotor_in_link_real lam3_21 = alpha3_z + ww3_xy;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s4 = sin(q[3]);
    const puma560_rotor_in_link_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_rotor_in_link_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_rotor_in_link_real w4_z = neg_w3_y + qd[3];
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_z = neg_alpha3_y + qdd[3];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c5 = cos(q[4]);
    const puma560_rotor_in_link_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_rotor_in_link_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_rotor_in_link_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_rotor_in_link_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_rotor_in_link_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_rotor_in_link_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w6_z = neg_w5_y + qd[5];
    const puma560_rotor_in_link_real t1 = 0.19304*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_y = neg_w5_x*t1;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c2 = cos(q[1]);
    const puma560_rotor_in_link_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww2_zz = qd[1]*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_y = alpha3_z*c4 + (neg_alpha3_x*s4 + neg_w4_x*qd[3]);
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_x = alpha3_z*s4 + (w4_y*qd[3] - neg_alpha3_x*c4);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_32 = c5*alpha4_x - (alpha4_z*s5 + neg_w5_y*(qd[4] +
        w5_z));
    const puma560_rotor_in_link_real t2 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_22 = neg_lam2_33 - t2;
    const puma560_rotor_in_link_real t3 = 21.27093596059113*c2;
    const puma560_rotor_in_link_real t4 = 21.27093596059113*s2;
    const puma560_rotor_in_link_real t5 = t3*(neg_lam2_33 + ww2_zz) + qdd[1]*t4 +
        7.394088669950739*qdd[0];
    const puma560_rotor_in_link_real t6 = t4*ww2_zz - (qdd[1]*t3 - 482.7586206896552);
    const puma560_rotor_in_link_real t7 = c23*t5 + s23*t6;
    const puma560_rotor_in_link_real t8 = neg_lam3_11 + 21.334975369458128*neg_lam3_12 - t7;
    const puma560_rotor_in_link_real t9 = 2.0*(qd[1]*qd[0]);
    const puma560_rotor_in_link_real t10 = qdd[0]*t3 - 7.394088669950739*neg_lam2_33 - t4*t9;
    const puma560_rotor_in_link_real t11 = 21.334975369458128*neg_lam3_32;
    const puma560_rotor_in_link_real t12 = t11 - lam3_31;
    const puma560_rotor_in_link_real t13 = t10 + t12;
    const puma560_rotor_in_link_real t14 = c4*t8 + s4*t13;
    const puma560_rotor_in_link_real t15 = 5.8464e-05*c5;
    const puma560_rotor_in_link_real t16 = 5.8464e-05*s5;
    const puma560_rotor_in_link_real t17 = lam3_21 - 21.334975369458128*neg_lam3_22 - (s23*t5 -
        c23*t6);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n5_z = t14*t15 + (n06_y + 0.17964216*(alpha5_z -
        0.0013480131835422152*ww5_xy)) - t16*t17;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha5_y = neg_w5_x*qd[4] - s5*alpha4_x - alpha4_z*c5;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_z = 0.19304*(qdd[5] - alpha5_y);
    const puma560_rotor_in_link_real t18 = 0.0005151125*t14 - (neg_lam5_22*t16 + lam5_12*t15);
    const puma560_rotor_in_link_real t19 = s4*t8 - c4*t13;
    const puma560_rotor_in_link_real t20 = -0.00054216*lam5_32 - 0.00477684375*t19;
    const puma560_rotor_in_link_real t21 = 0.10783532536520585*t20;
    const puma560_rotor_in_link_real t22 = s4*t18 + c4*t21;
    const puma560_rotor_in_link_real t23 = 3280.019999836749*t22;
    const puma560_rotor_in_link_real t24 = 0.2013*alpha4_y + n5_z;
    const puma560_rotor_in_link_real t25 = 0.1791*neg_ww5_zx - (n06_z - 0.0003*alpha5_y);
    const puma560_rotor_in_link_real t26 = t20 - (w5_z*(t1 - 0.1788*neg_w5_y) - 0.00471837975*t19);
    const puma560_rotor_in_link_real t27 = s5*t25 + (c5*t26 - 0.2013*alpha4_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real neg_n3_x = 0.006504526*(t10 + t23) + s4*t24 - (0.004704*t2 +
        (-0.014170080666358808*lam3_31 - (0.013853806666358808*t12 + c4*t27)));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n4_z = 0.2013*alpha4_z + s5*t26 - c5*t25;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_y = 0.004704*neg_lam3_12 - n4_z + (t22 -
        9.201024402078819*neg_lam3_32 + 0.43125*t12);
    const puma560_rotor_in_link_real t28 = 0.0011165940250115794*(t3 + 545.6756980171745*s2);
    const puma560_rotor_in_link_real t29 = c4*t18 - s4*t21;
    const puma560_rotor_in_link_real t30 = t29 + 0.006504526*neg_lam3_12;
    const puma560_rotor_in_link_real t31 = t16*lam5_12 - neg_lam5_22*t15 + 0.0005151125*t17;
    const puma560_rotor_in_link_real t32 = 0.006504526*neg_lam3_22 - t31;
    const puma560_rotor_in_link_real t33 = c23*t30 - s23*t32;
    const puma560_rotor_in_link_real t34 = 0.06435058403334877*c2;
    const puma560_rotor_in_link_real t35 = t3*t34;
    const puma560_rotor_in_link_real t36 = t4*t34;
    const puma560_rotor_in_link_real t37 = 7.394088669950739*t33 - (ww2_zz*(0.609298224*c2 -
        0.023751*s2) - c23*n3_y) - qdd[0]*(t35 + 2.231693438 - 0.010372902938360292*t36);
    const puma560_rotor_in_link_real t38 = 0.010372902938360292*t35 + (t36 - 0.0070992);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n1_z = s23*neg_n3_x + qdd[1]*t28 - (t37 + (t9*t38 -
        0.006485001909027938*c2*(t11 + t23)));
    const puma560_rotor_in_link_real t39 = 21.334975369458128*(t29 - 0.00030487618979450475*t7) +
        (t31 + c4*t24) - (s4*t27 + 0.004704*neg_lam3_13);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_z = 0.8625*(ww3_xy + 0.8426905785507246*neg_lam3_12) -
        (0.000316274*(neg_lam3_11 - neg_lam3_22) - t39);
    const puma560_rotor_in_link_real t40 = n3_z + (neg_lam2_33*t38 + 6.225049952*qdd[1] +
        t3*(s23*t30 + (c23*t32 - 1.5019138889382213)));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n02_z = t40 + (t28*(qdd[0] + 1.6791777157715793) - t4*t33);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* torques that hold the arm at rest
 * 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine */
void puma560_rotor_in_link_gravity(
    const puma560_rotor_in_link_real q[6],
    puma560_rotor_in_link_real tau[6])
{
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw5_y = -0.028224*c5;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c4 = cos(q[3]);
    const puma560_rotor_in_link_real angle23 = q[1] + q[2];
    const puma560_rotor_in_link_real s23 = sin(angle23);
    const puma560_rotor_in_link_real c23 = cos(angle23);
    const puma560_rotor_in_link_real s5 = sin(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw5_x = 0.028224*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_rotor_in_link_real tau5 = hw5_y*(c4*s23) - c23*hw5_x;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s4 = sin(q[3]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw4_y = hw5_x*s4;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_rotor_in_link_real tau4 = s23*hw4_y;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c2 = cos(q[1]);
    const puma560_rotor_in_link_real s2 = sin(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw4_x = c4*hw5_x;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw3_x = c23*(hw4_x - 0.248675) + s23*(8.445591 - hw5_y);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const puma560_rotor_in_link_real hw2_x = hw3_x + (37.196782*c2 - 1.02312*s2);
    const puma560_rotor_in_link_real t1 = -hw2_x;
    const puma560_rotor_in_link_real t2 = -hw3_x;
    tau[0] = 0.0;
    tau[1] = t1;
    tau[2] = t2;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 125 multiplications, 90 additions = 215; 1 unary minus; 8 sine/cosine */
void puma560_rotor_in_link_bias(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    puma560_rotor_in_link_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real angle23 = q[1] + q[2];
    const puma560_rotor_in_link_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_y = c23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_x = qd[0]*s23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_rotor_in_link_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_rotor_in_link_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_rotor_in_link_real ww3_zz = w3_z*w3_z;
    const puma560_rotor_in_link_real ww3_xy = neg_w3_y*neg_w3_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_rotor_in_link_real lam3_31 = -2.0*neg_ww3_zx;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s4 = sin(q[3]);
    const puma560_rotor_in_link_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_rotor_in_link_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_rotor_in_link_real w4_z = neg_w3_y + qd[3];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c5 = cos(q[4]);
    const puma560_rotor_in_link_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_rotor_in_link_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_rotor_in_link_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_rotor_in_link_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_rotor_in_link_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_rotor_in_link_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w6_z = neg_w5_y + qd[5];
    const puma560_rotor_in_link_real t1 = 0.19304*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_y = neg_w5_x*t1;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c2 = cos(q[1]);
    const puma560_rotor_in_link_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww2_zz = qd[1]*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_x = w4_y*qd[3] - neg_ww3_yz*c4;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_32 = neg_ww3_zx*s5 - neg_w5_y*(qd[4] + w5_z) +
        c5*alpha4_x;
    const puma560_rotor_in_link_real t2 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_22 = neg_lam2_33 - t2;
    const puma560_rotor_in_link_real t3 = 21.27093596059113*c2;
    const puma560_rotor_in_link_real t4 = t3*(neg_lam2_33 + ww2_zz);
    const puma560_rotor_in_link_real t5 = 21.27093596059113*s2;
    const puma560_rotor_in_link_real t6 = t5*ww2_zz + 482.7586206896552;
    const puma560_rotor_in_link_real t7 = c23*t4 + s23*t6;
    const puma560_rotor_in_link_real t8 = neg_lam3_11 - 21.334975369458128*ww3_xy - t7;
    const puma560_rotor_in_link_real t9 = 2.0*(qd[1]*qd[0]);
    const puma560_rotor_in_link_real t10 = 7.394088669950739*neg_lam2_33 + t5*t9;
    const puma560_rotor_in_link_real t11 = 42.669950738916256*neg_ww3_yz;
    const puma560_rotor_in_link_real t12 = t11 - lam3_31;
    const puma560_rotor_in_link_real t13 = t10 - t12;
    const puma560_rotor_in_link_real t14 = c4*t8 - s4*t13;
    const puma560_rotor_in_link_real t15 = 5.8464e-05*c5;
    const puma560_rotor_in_link_real t16 = 5.8464e-05*s5;
    const puma560_rotor_in_link_real t17 = ww3_xy - 21.334975369458128*neg_lam3_22 - (s23*t4 -
        c23*t6);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n5_z = t14*t15 + (n06_y + 0.17964216*(alpha4_y -
        0.0013480131835422152*ww5_xy)) - t16*t17;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_z = -0.19304*alpha5_y;
    const puma560_rotor_in_link_real t18 = 0.0005151125*t14 - (neg_lam5_22*t16 + lam5_12*t15);
    const puma560_rotor_in_link_real t19 = s4*t8 + c4*t13;
    const puma560_rotor_in_link_real t20 = 0.00054216*lam5_32 + 0.00477684375*t19;
    const puma560_rotor_in_link_real t21 = 0.10783532536520585*t20;
    const puma560_rotor_in_link_real t22 = s4*t18 - c4*t21;
    const puma560_rotor_in_link_real t23 = 3280.019999836749*t22;
    const puma560_rotor_in_link_real t24 = 0.2013*alpha4_y + n5_z;
    const puma560_rotor_in_link_real t25 = 0.1791*neg_ww5_zx + 0.19334*alpha5_y;
    const puma560_rotor_in_link_real t26 = t20 + (w5_z*(t1 - 0.1788*neg_w5_y) - 0.00471837975*t19);
    const puma560_rotor_in_link_real t27 = s5*t25 - (c5*t26 + 0.2013*alpha4_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_x = 0.006504526*(t10 - t23) - s4*t24 + (0.004704*t2 +
        (0.028340161332717616*neg_ww3_zx - (0.013853806666358808*t12 + c4*t27)));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n4_z = -c5*t25 - (0.2013*neg_ww3_zx + s5*t26);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real neg_n3_y = 0.004704*ww3_xy + n4_z - (t22 -
        18.402048804157637*neg_ww3_yz + 0.43125*t12);
    const puma560_rotor_in_link_real t28 = 0.06435058403334877*c2;
    const puma560_rotor_in_link_real t29 = 0.010372902938360292*(t3*t28) + (t5*t28 - 0.0070992);
    const puma560_rotor_in_link_real t30 = c4*t18 + s4*t21;
    const puma560_rotor_in_link_real t31 = t30 - 0.006504526*ww3_xy;
    const puma560_rotor_in_link_real t32 = t16*lam5_12 - neg_lam5_22*t15 + 0.0005151125*t17;
    const puma560_rotor_in_link_real t33 = 0.006504526*neg_lam3_22 - t32;
    const puma560_rotor_in_link_real t34 = c23*t31 - s23*t33;
    const puma560_rotor_in_link_real t35 = 0.006485001909027938*c2*(t11 + t23) - t9*t29 -
        (7.394088669950739*t34 - (ww2_zz*(0.609298224*c2 - 0.023751*s2) + c23*neg_n3_y));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n1_z = t35 - s23*n3_x;
    const puma560_rotor_in_link_real t36 = 0.000316274*(neg_lam3_11 - neg_lam3_22) -
        (21.334975369458128*(t30 - 0.00030487618979450475*t7) + (t32 + c4*t24) - s4*t27);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_z = 0.135679376*ww3_xy - t36;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n02_z = n3_z + (neg_lam2_33*t29 + t3*(s23*t31 + (c23*t33 -
        1.5019138889382213))) + (0.0018749598043631376*(t3 + 545.6756980171745*s2) - t5*t34);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 60 multiplications, 54 additions = 114; 0 unary minus; 8 sine/cosine */
void puma560_rotor_in_link_mass_matrix(
    const puma560_rotor_in_link_real q[6],
    puma560_rotor_in_link_real M[36])
{
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c2 = cos(q[1]);
    const puma560_rotor_in_link_real s2 = sin(q[1]);
    const puma560_rotor_in_link_real c4 = cos(q[3]);
    const puma560_rotor_in_link_real s4 = sin(q[3]);
    const puma560_rotor_in_link_real c5 = cos(q[4]);
    const puma560_rotor_in_link_real s5 = sin(q[4]);
    const puma560_rotor_in_link_real angle23 = q[1] + q[2];
    const puma560_rotor_in_link_real c23 = cos(angle23);
    const puma560_rotor_in_link_real s23 = sin(angle23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real neg_nu5_y = 0.19304*c5;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h5_x = 0.00288*s5;
    const puma560_rotor_in_link_real neg_h5_y = 0.00288*c5;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h4_x = c4*h5_x;
    const puma560_rotor_in_link_real h4_y = s4*h5_x;
    const puma560_rotor_in_link_real t1 = h4_x - 0.025375;
    const puma560_rotor_in_link_real t2 = neg_h5_y + 0.861795;
    const puma560_rotor_in_link_real t3 = s23*t2;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h3_x = c23*t1 + t3;
    const puma560_rotor_in_link_real h3_y = s23*t1 - c23*t2;
    const puma560_rotor_in_link_real t4 = 66.94369444444445*c5;
    const puma560_rotor_in_link_real t5 = neg_h5_y*t4;
    /* link 4: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m4_4 = t5 + 0.20184216;
    const puma560_rotor_in_link_real t6 = 0.4318*c2;
    const puma560_rotor_in_link_real t7 = 5.8464e-05*s5;
    const puma560_rotor_in_link_real t8 = t7 - c4*(t5 - 0.01369784);
    const puma560_rotor_in_link_real t9 = c4*t7;
    const puma560_rotor_in_link_real t10 = c4*t8 + (t9 - 0.5395351125);
    const puma560_rotor_in_link_real t11 = 0.001247328*c5;
    const puma560_rotor_in_link_real t12 = t5 - t11;
    const puma560_rotor_in_link_real t13 = t11 - (t12 - 0.8169101365);
    const puma560_rotor_in_link_real t14 = t4 - 0.4331;
    const puma560_rotor_in_link_real t15 = s23*h5_x;
    const puma560_rotor_in_link_real t16 = c4*t15;
    const puma560_rotor_in_link_real t17 = t14*t16;
    const puma560_rotor_in_link_real t18 = h3_x*t6;
    const puma560_rotor_in_link_real t19 = t9 - (0.1501*h4_y + m4_4);
    const puma560_rotor_in_link_real t20 = c23*(t17 - 0.0068208*(s23 - 2.9761904761904763*t3)) -
        (t18 - (t12 - 0.540869687) - t19);
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m1_1 = t6*(3.709729509031959*c2 - 0.03288188976377953*s2) -
        (c23*(c23*(t10 + t13)) - (t10 - (t20 + (t20 - 2.2249496655))));
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m3_4 = h4_y*t14;
    const puma560_rotor_in_link_real t21 = s4*s23;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_rotor_in_link_real k3_yz = c23*(m3_4 - 0.004704) - t8*t21;
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m1_3 = 0.1501*h3_y + k3_yz;
    const puma560_rotor_in_link_real t22 = 0.4318*s2;
    const puma560_rotor_in_link_real t23 = h4_y*t22;
    const puma560_rotor_in_link_real m1_2 = 0.690314699*s2 + (t23 + 0.023751*c2 + m1_3);
    const puma560_rotor_in_link_real m1_4 = h4_x*t6 - c23*t19 - t17;
    const puma560_rotor_in_link_real t24 = c23*neg_h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real neg_fu3_x = t15 - c4*t24;
    const puma560_rotor_in_link_real t25 = t11 + 0.17964216;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu3_y = 0.0203*(s4*t24) - t21*t25;
    const puma560_rotor_in_link_real t26 = s4*t6;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu2_y = nu3_y - neg_h5_y*t26;
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m1_5 = 0.1501*neg_fu3_x - nu2_y;
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m3_3 = t13 - t10;
    const puma560_rotor_in_link_real t27 = t18 + h3_y*t22;
    /* link 2: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m2_3 = t27 + m3_3;
    const puma560_rotor_in_link_real m2_2 = t27 + (m2_3 + 6.458114002);
    const puma560_rotor_in_link_real m2_4 = m3_4 + c23*t23 - t15*t26;
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m3_5 = c4*t25 - t7;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real fu3_y = c23*h5_x + neg_h5_y*(c4*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m2_5 = m3_5 + (t22*neg_fu3_x + t6*fu3_y);
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu4_y = 67.02777777777777*h4_y;
    const puma560_rotor_in_link_real t28 = 67.02777777777777*(t24 - t16);
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = t28;
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
    M[30] = t28;
    M[31] = nu4_y;
    M[32] = nu4_y;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.19304;
}

/* accelerations that the torques tau give
 * 247 multiplications, 201 additions, 4 divisions = 452; 3 unary minus; 8 sine/cosine */
void puma560_rotor_in_link_forward_dynamics(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    const puma560_rotor_in_link_real tau[6],
    puma560_rotor_in_link_real qdd[6])
{
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real angle23 = q[1] + q[2];
    const puma560_rotor_in_link_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_y = c23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w3_x = qd[0]*s23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_rotor_in_link_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_rotor_in_link_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_rotor_in_link_real ww3_zz = w3_z*w3_z;
    const puma560_rotor_in_link_real ww3_xy = neg_w3_y*neg_w3_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_rotor_in_link_real lam3_31 = -2.0*neg_ww3_zx;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real s4 = sin(q[3]);
    const puma560_rotor_in_link_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w4_y = w3_z*c4 + neg_w3_x*s4;
    const puma560_rotor_in_link_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const puma560_rotor_in_link_real w4_z = neg_w3_y + qd[3];
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c5 = cos(q[4]);
    const puma560_rotor_in_link_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_rotor_in_link_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_rotor_in_link_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    const puma560_rotor_in_link_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww5_xy = neg_w5_x*neg_w5_y;
    const puma560_rotor_in_link_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_rotor_in_link_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_rotor_in_link_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_rotor_in_link_real w6_z = neg_w5_y + qd[5];
    const puma560_rotor_in_link_real t1 = 0.19304*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_y = neg_w5_x*t1;
    /* sines and cosines of the joint angles */
    const puma560_rotor_in_link_real c2 = cos(q[1]);
    const puma560_rotor_in_link_real s2 = sin(q[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_rotor_in_link_real ww2_zz = qd[1]*qd[1];
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha4_x = w4_y*qd[3] - neg_ww3_yz*c4;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real lam5_32 = neg_ww3_zx*s5 - neg_w5_y*(qd[4] + w5_z) +
        c5*alpha4_x;
    const puma560_rotor_in_link_real t2 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_rotor_in_link_real neg_lam3_22 = neg_lam2_33 - t2;
    const puma560_rotor_in_link_real t3 = 21.27093596059113*c2;
    const puma560_rotor_in_link_real t4 = t3*(neg_lam2_33 + ww2_zz);
    const puma560_rotor_in_link_real t5 = 21.27093596059113*s2;
    const puma560_rotor_in_link_real t6 = ww2_zz*t5 + 482.7586206896552;
    const puma560_rotor_in_link_real t7 = c23*t4 + s23*t6;
    const puma560_rotor_in_link_real t8 = neg_lam3_11 - 21.334975369458128*ww3_xy - t7;
    const puma560_rotor_in_link_real t9 = 2.0*(qd[1]*qd[0]);
    const puma560_rotor_in_link_real t10 = 7.394088669950739*neg_lam2_33 + t5*t9;
    const puma560_rotor_in_link_real t11 = 42.669950738916256*neg_ww3_yz;
    const puma560_rotor_in_link_real t12 = t11 - lam3_31;
    const puma560_rotor_in_link_real t13 = t10 - t12;
    const puma560_rotor_in_link_real t14 = c4*t8 - s4*t13;
    const puma560_rotor_in_link_real t15 = 5.8464e-05*c5;
    const puma560_rotor_in_link_real t16 = 5.8464e-05*s5;
    const puma560_rotor_in_link_real t17 = ww3_xy - 21.334975369458128*neg_lam3_22 - (s23*t4 -
        c23*t6);
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n5_z = t14*t15 + (n06_y + 0.17964216*(alpha4_y -
        0.0013480131835422152*ww5_xy)) - t16*t17;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_rotor_in_link_real alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n06_z = -0.19304*alpha5_y;
    const puma560_rotor_in_link_real t18 = 0.0005151125*t14 - (neg_lam5_22*t16 + lam5_12*t15);
    const puma560_rotor_in_link_real t19 = s4*t8 + c4*t13;
    const puma560_rotor_in_link_real t20 = 0.00054216*lam5_32 + 0.00477684375*t19;
    const puma560_rotor_in_link_real t21 = 0.10783532536520585*t20;
    const puma560_rotor_in_link_real t22 = s4*t18 - c4*t21;
    const puma560_rotor_in_link_real t23 = 3280.019999836749*t22;
    const puma560_rotor_in_link_real t24 = n5_z + 0.2013*alpha4_y;
    const puma560_rotor_in_link_real t25 = 0.1791*neg_ww5_zx + 0.19334*alpha5_y;
    const puma560_rotor_in_link_real t26 = t20 + (w5_z*(t1 - 0.1788*neg_w5_y) - 0.00471837975*t19);
    const puma560_rotor_in_link_real t27 = s5*t25 - (c5*t26 + 0.2013*alpha4_x);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_x = 0.006504526*(t10 - t23) - s4*t24 + (0.004704*t2 +
        (0.028340161332717616*neg_ww3_zx - (0.013853806666358808*t12 + c4*t27)));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real neg_n4_z = c5*t25 + (0.2013*neg_ww3_zx + s5*t26);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_y = neg_n4_z - 0.004704*ww3_xy + (t22 -
        18.402048804157637*neg_ww3_yz + 0.43125*t12);
    const puma560_rotor_in_link_real t28 = 0.06435058403334877*c2;
    const puma560_rotor_in_link_real t29 = 0.010372902938360292*(t3*t28) + (t5*t28 - 0.0070992);
    const puma560_rotor_in_link_real t30 = c4*t18 + s4*t21;
    const puma560_rotor_in_link_real t31 = t30 - 0.006504526*ww3_xy;
    const puma560_rotor_in_link_real t32 = lam5_12*t16 - neg_lam5_22*t15 + 0.0005151125*t17;
    const puma560_rotor_in_link_real t33 = 0.006504526*neg_lam3_22 - t32;
    const puma560_rotor_in_link_real t34 = c23*t31 - s23*t33;
    const puma560_rotor_in_link_real t35 = 0.006485001909027938*c2*(t11 + t23) - t9*t29 -
        (7.394088669950739*t34 - (ww2_zz*(0.609298224*c2 - 0.023751*s2) - c23*n3_y));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n1_z = t35 - s23*n3_x;
    const puma560_rotor_in_link_real t36 = 0.000316274*(neg_lam3_11 - neg_lam3_22) -
        (21.334975369458128*(t30 - 0.00030487618979450475*t7) + (t32 + c4*t24) - s4*t27);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_rotor_in_link_real n3_z = 0.135679376*ww3_xy - t36;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_rotor_in_link_real n02_z = n3_z + (neg_lam2_33*t29 + t3*(s23*t31 + (c23*t33 -
        1.5019138889382213))) + (0.0018749598043631376*(t3 + 545.6756980171745*s2) - t5*t34);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real neg_nu5_y = 0.19304*c5;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h5_x = 0.00288*s5;
    const puma560_rotor_in_link_real neg_h5_y = 0.00288*c5;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h4_x = c4*h5_x;
    const puma560_rotor_in_link_real h4_y = s4*h5_x;
    const puma560_rotor_in_link_real t37 = h4_x - 0.025375;
    const puma560_rotor_in_link_real t38 = neg_h5_y + 0.861795;
    const puma560_rotor_in_link_real t39 = s23*t38;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_rotor_in_link_real h3_x = c23*t37 + t39;
    const puma560_rotor_in_link_real h3_y = s23*t37 - c23*t38;
    const puma560_rotor_in_link_real t40 = 66.94369444444445*c5;
    const puma560_rotor_in_link_real t41 = neg_h5_y*t40;
    /* link 4: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m4_4 = t41 + 0.20184216;
    const puma560_rotor_in_link_real t42 = 0.4318*c2;
    const puma560_rotor_in_link_real t43 = t16 - c4*(t41 - 0.01369784);
    const puma560_rotor_in_link_real t44 = c4*t16;
    const puma560_rotor_in_link_real t45 = c4*t43 + (t44 - 0.5395351125);
    const puma560_rotor_in_link_real t46 = 0.001247328*c5;
    const puma560_rotor_in_link_real t47 = t41 - t46;
    const puma560_rotor_in_link_real t48 = t46 - (t47 - 0.8169101365);
    const puma560_rotor_in_link_real t49 = t40 - 0.4331;
    const puma560_rotor_in_link_real t50 = s23*h5_x;
    const puma560_rotor_in_link_real t51 = c4*t50;
    const puma560_rotor_in_link_real t52 = t49*t51;
    const puma560_rotor_in_link_real t53 = h3_x*t42;
    const puma560_rotor_in_link_real t54 = t44 - (m4_4 + 0.1501*h4_y);
    const puma560_rotor_in_link_real t55 = c23*(t52 - 0.0068208*(s23 - 2.9761904761904763*t39)) -
        (t53 - (t47 - 0.540869687) - t54);
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m1_1 = t42*(3.709729509031959*c2 - 0.03288188976377953*s2) -
        (c23*(c23*(t45 + t48)) - (t45 - (t55 + (t55 - 2.2249496655))));
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m3_4 = h4_y*t49;
    const puma560_rotor_in_link_real t56 = s23*s4;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_rotor_in_link_real k3_yz = c23*(m3_4 - 0.004704) - t43*t56;
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real m1_3 = k3_yz + 0.1501*h3_y;
    const puma560_rotor_in_link_real t57 = 0.4318*s2;
    const puma560_rotor_in_link_real t58 = h4_y*t57;
    const puma560_rotor_in_link_real m1_2 = 0.690314699*s2 + (m1_3 + (t58 + 0.023751*c2));
    const puma560_rotor_in_link_real neg_m1_4 = t52 - (h4_x*t42 - c23*t54);
    const puma560_rotor_in_link_real t59 = c23*neg_h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real neg_fu3_x = t50 - c4*t59;
    const puma560_rotor_in_link_real t60 = t46 + 0.17964216;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu3_y = 0.0203*(s4*t59) - t56*t60;
    const puma560_rotor_in_link_real t61 = s4*t42;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu2_y = nu3_y - neg_h5_y*t61;
    /* link 1: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real neg_m1_5 = nu2_y - 0.1501*neg_fu3_x;
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real neg_m3_3 = t45 - t48;
    const puma560_rotor_in_link_real t62 = t53 + h3_y*t57;
    /* link 2: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real neg_m2_3 = neg_m3_3 - t62;
    const puma560_rotor_in_link_real m2_2 = t62 - (neg_m2_3 - 6.458114002);
    const puma560_rotor_in_link_real m2_4 = m3_4 + c23*t58 - t50*t61;
    /* link 3: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real neg_m3_5 = t16 - c4*t60;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real fu3_y = c23*h5_x + neg_h5_y*(s23*c4);
    /* link 2: mass matrix, its row of this joint */
    const puma560_rotor_in_link_real neg_m2_5 = neg_m3_5 - (t57*neg_fu3_x + t42*fu3_y);
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_rotor_in_link_real nu4_y = 67.02777777777777*h4_y;
    const puma560_rotor_in_link_real t63 = t51 - t59;
    /* factorisation M = U D U^T */
    const puma560_rotor_in_link_real neg_ud1_6 = 67.02777777777777*t63;
    /* link 5: forward substitution */
    const puma560_rotor_in_link_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const puma560_rotor_in_link_real y6 = tau[5] - n06_z;
    /* factorisation M = U D U^T */
    const puma560_rotor_in_link_real u3_6 = 347.22222222222223*h4_y;
    const puma560_rotor_in_link_real neg_u1_6 = 347.22222222222223*t63;
    const puma560_rotor_in_link_real neg_u3_5 = 5.566622000091738*neg_m3_5;
    const puma560_rotor_in_link_real neg_u2_5 = 5.566622000091738*neg_m2_5;
    const puma560_rotor_in_link_real neg_u1_5 = 5.566622000091738*neg_m1_5;
    const puma560_rotor_in_link_real pivot4 = m4_4 - c5*neg_nu5_y;
    const puma560_rotor_in_link_real ipivot4 = 1.0 / pivot4;
    const puma560_rotor_in_link_real t64 = neg_nu5_y*u3_6;
    const puma560_rotor_in_link_real ud3_4 = m3_4 - t64;
    const puma560_rotor_in_link_real u3_4 = ipivot4*ud3_4;
    const puma560_rotor_in_link_real ud2_4 = m2_4 - t64;
    const puma560_rotor_in_link_real u2_4 = ipivot4*ud2_4;
    const puma560_rotor_in_link_real neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6;
    const puma560_rotor_in_link_real neg_u1_4 = ipivot4*neg_ud1_4;
    const puma560_rotor_in_link_real t65 = nu4_y*u3_6;
    const puma560_rotor_in_link_real neg_pivot3 = neg_m3_3 + t65 + neg_m3_5*neg_u3_5 + ud3_4*u3_4;
    const puma560_rotor_in_link_real neg_ipivot3 = 1.0 / neg_pivot3;
    const puma560_rotor_in_link_real neg_ud2_3 = neg_m2_3 + t65 + neg_m3_5*neg_u2_5 + ud3_4*u2_4;
    const puma560_rotor_in_link_real u2_3 = neg_ipivot3*neg_ud2_3;
    const puma560_rotor_in_link_real t66 = nu4_y*neg_u1_6;
    const puma560_rotor_in_link_real ud1_3 = m1_3 + t66 - neg_m3_5*neg_u1_5 + ud3_4*neg_u1_4;
    const puma560_rotor_in_link_real neg_u1_3 = neg_ipivot3*ud1_3;
    const puma560_rotor_in_link_real pivot2 = m2_2 - t65 - neg_m2_5*neg_u2_5 - ud2_4*u2_4 +
        neg_ud2_3*u2_3;
    const puma560_rotor_in_link_real ipivot2 = 1.0 / pivot2;
    const puma560_rotor_in_link_real ud1_2 = m1_2 + t66 - neg_m2_5*neg_u1_5 + ud2_4*neg_u1_4 -
        neg_ud2_3*neg_u1_3;
    const puma560_rotor_in_link_real u1_2 = ipivot2*ud1_2;
    const puma560_rotor_in_link_real pivot1 = m1_1 - neg_ud1_6*neg_u1_6 - neg_m1_5*neg_u1_5 -
        neg_ud1_4*neg_u1_4 + ud1_3*neg_u1_3 - ud1_2*u1_2;
    const puma560_rotor_in_link_real ipivot1 = 1.0 / pivot1;
    /* link 4: forward substitution */
    const puma560_rotor_in_link_real y4 = neg_n4_z + tau[3] - c5*y6;
    const puma560_rotor_in_link_real t67 = y6*u3_6;
    /* link 3: forward substitution */
    const puma560_rotor_in_link_real neg_y3 = n3_z - tau[2] + t67 + neg_y5*neg_u3_5 + u3_4*y4;
    /* link 2: forward substitution */
    const puma560_rotor_in_link_real neg_y2 = n02_z - tau[1] + t67 + neg_y5*neg_u2_5 + u2_4*y4 -
        u2_3*neg_y3;
    /* link 1: forward substitution */
    const puma560_rotor_in_link_real neg_y1 = n1_z - tau[0] - y6*neg_u1_6 + neg_y5*neg_u1_5 -
        neg_u1_4*y4 + neg_u1_3*neg_y3 - u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real neg_qdd2 = ipivot2*neg_y2 - u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real qdd3 = neg_ipivot3*neg_y3 + u2_3*neg_qdd2 - neg_u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real qdd4 = ipivot4*y4 - u3_4*qdd3 + u2_4*neg_qdd2 -
        neg_u1_4*neg_qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real qdd5 = -neg_u1_5*neg_qdd1 - (5.566622000091738*neg_y5 -
        neg_u3_5*qdd3 + neg_u2_5*neg_qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_rotor_in_link_real qdd6 = u3_6*(neg_qdd2 - qdd3) - (neg_u1_6*neg_qdd1 -
        (5.180273518441774*y6 - c5*qdd4));
    const puma560_rotor_in_link_real t68 = -neg_qdd1;
    const puma560_rotor_in_link_real t69 = -neg_qdd2;
    qdd[0] = t68;
    qdd[1] = t69;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
