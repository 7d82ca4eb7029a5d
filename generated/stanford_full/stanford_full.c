/*
 * stanford_full: Stanford geometry, random full inertias
 * Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 84b51ffbe87f1ac4bb6e33f59e330781 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute   alpha 0      a 0  d 0       theta q
 *   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
 *   3  prismatic  alpha pi/2   a 0  d q       theta 0
 *   4  revolute   alpha 0      a 0  d 0       theta q
 *   5  revolute   alpha -pi/2  a 0  d 0       theta q
 *   6  revolute   alpha pi/2   a 0  d 0       theta q
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
 *   inverse_dynamics: 200 multiplications, 188 additions = 388; 1 unary minus; 8 sine/cosine
 *   gravity: 24 multiplications, 16 additions = 40; 1 unary minus; 8 sine/cosine
 *   bias: 184 multiplications, 164 additions = 348; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 90 multiplications, 84 additions = 174; 3 unary minus; 8 sine/cosine
 *   forward_dynamics: 358 multiplications, 316 additions, 5 divisions = 679; 2 unary minus; 8
 *       sine/cosine
 */
#include "stanford_full.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 200 multiplications, 188 additions = 388; 1 unary minus; 8 sine/cosine */
void stanford_full_inverse_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real qdd[6],
    stanford_full_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_full_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_y = qd[0]*c2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam2_23 = s2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww2_yz = neg_w2_y*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_full_real neg_alpha2_x = lam2_23 + neg_ww2_yz;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_13 = c2*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww3_xy = neg_w2_x*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_full_real alpha2_y = neg_ww3_xy - neg_lam2_13;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    const stanford_full_real ww2_yy = neg_w2_y*neg_w2_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam2_12 = ww2_xy - qdd[1];
    const stanford_full_real neg_lam2_32 = neg_ww2_yz + neg_alpha2_x;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_zz + ww2_yy;
    const stanford_full_real neg_lam2_31 = neg_ww3_xy + alpha2_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam3_31 = ww2_xy + qdd[1];
    /* sines and cosines of the joint angles */
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_full_real w4_z = neg_w2_y + qd[3];
    const stanford_full_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_z = qdd[3] - alpha2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const stanford_full_real ww4_xx = neg_w4_x*neg_w4_x;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    const stanford_full_real ww4_yz = w4_z*w4_y;
    const stanford_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_21 = alpha4_z - neg_ww4_xy;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real neg_lam4_12 = alpha4_z + neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_full_real w5_z = w4_y + qd[4];
    const stanford_full_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    const stanford_full_real ww5_xy = neg_w5_x*neg_w5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = neg_w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(q[5]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_z = 0.1524*ww1_zz;
    const stanford_full_real t1 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_y = neg_a2_z - (neg_lam2_32*q[2] + neg_w2_x*t1);
    const stanford_full_real t2 = ww2_zz - ww2_yy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_22 = ww1_zz + t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_z = 0.1524*lam2_23 - (9.8*c2 - q[2]*neg_lam2_22) - qdd[2];
    /* link 3: moment that turns the link [N m] */
    const stanford_full_real nc3_x = 0.012168751997232599*neg_a3_y - 0.4516316755890639*neg_a3_z;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2 + 0.1524*neg_lam2_13;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_x = neg_a2_x - (qd[1]*t1 - lam2_12*q[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_y = c4*neg_a3_y - s4*neg_a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = qdd[1]*s4 + (qd[3]*w4_y - neg_alpha2_x*c4);
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_y = neg_w5_x*qd[4] - s5*alpha4_x - alpha4_z*c5;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_31 = neg_ww5_zx + alpha5_y;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_y = neg_alpha2_x*s4 + (qdd[1]*c4 + neg_w4_x*qd[3]);
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_x = c4*neg_a3_x + s4*neg_a3_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a5_x = c5*neg_a4_x - s5*neg_a3_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_23 = neg_lam4_12*s5 - c5*lam4_32;
    const stanford_full_real t3 = 2.0*w5_z;
    const stanford_full_real neg_lam5_32 = lam5_23 + neg_w5_y*t3;
    const stanford_full_real neg_lam5_13 = neg_ww5_zx - alpha5_y;
    const stanford_full_real t4 = ww5_xx - ww5_zz;
    const stanford_full_real t5 = 0.0625396920897071*c6;
    const stanford_full_real t6 = 0.16255029097038232*c6;
    const stanford_full_real t7 = t5*t6 + 0.3409906449060338;
    const stanford_full_real t8 = 0.0625396920897071*s6;
    const stanford_full_real t9 = t6*t8;
    const stanford_full_real t10 = 62.4559348502784*t7 + (t9 - 21.61434818388583);
    const stanford_full_real t11 = 0.06483323523282834*s6;
    const stanford_full_real t12 = 18.778467160320414*(t11 + 0.06355169650371038*c6);
    const stanford_full_real t13 = t7 - 62.4559348502784*t9;
    const stanford_full_real t14 = t13 - 0.6921471349584476;
    const stanford_full_real t15 = neg_lam5_31 - qdd[5];
    const stanford_full_real t16 = t5 - t11;
    const stanford_full_real t17 = 1.193403445777575*s6 - 1.2174687787169953*c6;
    const stanford_full_real t18 = t8 + 0.06483323523282834*c6;
    const stanford_full_real t19 = qdd[5] + neg_lam5_13;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_z = t4*t10 - (neg_a4_y*t12 - (t14*t15 + t16*lam5_12)) +
        (t17*neg_a5_x - t18*neg_lam5_32 + t13*t19);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_y = c5*neg_a3_z + s5*neg_a4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_21 = ww5_xy + alpha5_z;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_zz = w6_z*w6_z;
    const stanford_full_real t20 = 0.28054187970758354*neg_a5_x + (1.1561689763413345*neg_lam5_13 -
        (0.20245111268601115*neg_lam5_31 - (0.13660343902034475*t4 + 0.5911078910549018*neg_a4_y)))
        + 0.23560176217086468*lam5_12;
    const stanford_full_real t21 = nc6_z - (0.060693211657558095*neg_lam5_32 - t20);
    const stanford_full_real t22 = 0.17535491873574263*neg_lam5_32 + (t17 +
        0.28054187970758354)*a5_y - (0.13660343902034475*lam5_21 - (0.060693211657558095*neg_lam5_31
        + t15*t18));
    const stanford_full_real t23 = lam5_23 - qd[5]*t3;
    const stanford_full_real t24 = ww5_xx - ww6_zz;
    const stanford_full_real t25 = lam5_21 + neg_w5_x*(2.0*qd[5]);
    const stanford_full_real t26 = 0.23560176217086468*(neg_lam4_22 - neg_lam5_22) +
        (0.6468331423588011*neg_a4_y - t22) - (t13*t23 + (1.1561689763413345*lam5_23 - (t16*(t4 -
        t24) + t10*t25)));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = s5*t21 + 0.06784076259315977*neg_lam4_31 + (c5*t26 +
        0.23523950726161555*(neg_lam2_22 - (neg_lam4_22 - 0.011289042504553535*lam4_21)));
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_11 = t4 - neg_lam4_22;
    const stanford_full_real t27 = neg_lam5_22 - t24;
    const stanford_full_real t28 = 0.28054187970758354*neg_lam5_13 + (0.6468331423588011*lam5_12 +
        t12*t27) + t17*t19 + 0.5911078910549018*lam5_11;
    const stanford_full_real t29 = 0.6468331423588011*neg_lam5_22 + (0.28054187970758354*lam5_23 +
        t17*t23 + t12*t25 - 0.5911078910549018*lam5_21);
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_z = s5*t28 - c5*t29 - (0.4516316755890639*lam2_23 +
        19.732838668844984*neg_a3_z) - 0.9022885982543313*neg_lam4_31 -
        0.22200183325724177*(neg_lam3_31 + 0.05481374553845334*neg_lam2_22);
    const stanford_full_real t30 = 0.9022885982543313*lam4_21 - (0.28054187970758354*neg_lam4_22 -
        0.6468331423588011*neg_lam5_32 - (0.5911078910549018*neg_lam5_31 - t17*(t4 + t27)));
    /* link 4: force through the joint [N] */
    const stanford_full_real f4_y = t30 - t12*t15;
    const stanford_full_real t31 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_11 = t31 - neg_lam2_22;
    /* link 4: force through the joint [N] */
    const stanford_full_real neg_f4_x = s5*t29 + c5*t28 - 0.9022885982543313*lam4_11;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_y = 0.012168751997232599*neg_lam2_32 + (c4*f4_y -
        19.732838668844984*neg_a3_y - (0.22200183325724177*neg_lam2_31 + (0.4516316755890639*ww1_zz
        + s4*neg_f4_x)));
    const stanford_full_real t32 = 0.23560176217086468*neg_lam5_13 + (t18*t24 + (t14*t25 -
        (0.20245111268601115*lam5_21 - 0.17535491873574263*lam5_12 - t16*t19)));
    const stanford_full_real t33 = 0.13660343902034475*lam5_23 + (t32 +
        (0.060693211657558095*(neg_lam5_22 + lam5_11) - a5_y*(t12 - 0.5911078910549018))) + t10*t23;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real neg_n5_z = 0.6468331423588011*neg_a5_x + t33;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_y = 0.23523950726161555*neg_lam4_12 - (0.002655628796226608*t31 -
        0.3448462092987837*neg_lam4_31 - 0.06784076259315977*lam4_32 + (neg_n5_z -
        0.9022885982543313*neg_a3_z));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real t34 = 0.06784076259315977*(neg_lam4_22 + lam4_11) - s5*t26 +
        (0.3448462092987837*lam4_21 - (0.002655628796226608*lam4_23 + 0.9022885982543313*neg_a4_y));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_z = c5*t21 + 0.23523950726161555*lam4_13 + t34;
    const stanford_full_real t35 = 0.012168751997232599*lam2_12;
    /* link 3: force through the joint [N] */
    const stanford_full_real neg_f3_x = 0.22200183325724177*neg_lam2_11 + (t35 +
        0.4516316755890639*neg_lam2_13 + (c4*neg_f4_x + 19.732838668844984*neg_a3_x)) + s4*f4_y;
    const stanford_full_real t36 = 0.15279302557916313*t2 + (0.49862309142001715*neg_lam2_32 +
        0.04911220265093226*neg_lam2_31 + (0.248077550893258*neg_alpha2_x - nc3_x)) - c4*n4_x;
    const stanford_full_real t37 = ww1_zz - neg_lam2_11;
    const stanford_full_real t38 = 0.22200183325724177*neg_a3_y - n4_z - 12.556178777734242*(t35 +
        0.0359688790342758*neg_a3_x) + 0.07388986205514168*t37 - 0.1524*neg_f3_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = s2*(t36 + (0.1524*(0.4848416145350504*neg_lam3_31 - f3_z) +
        (q[2]*f3_y + s4*n4_y))) + (0.9889371240787524*qdd[0] + c2*(-0.248077550893258*alpha2_y -
        (0.04911220265093226*neg_lam2_32 + t38)));
    const stanford_full_real t39 = q[2]*neg_f3_x + (5.4475438357201735*s2 +
        (0.49862309142001715*lam2_12 + (0.04911220265093226*(t2 + t37) - c4*n4_y)));
    const stanford_full_real t40 = 0.248077550893258*qdd[1] - (t39 + 0.012168751997232599*neg_a3_x -
        (0.07388986205514168*lam2_23 - 0.15279302557916313*neg_lam2_13)) - (1.4591749065920876*c2 -
        s4*n4_x);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_z = 0.22200183325724177*neg_a3_z + t40;
    const stanford_full_real t41 = -neg_n5_z;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = t41;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 24 multiplications, 16 additions = 40; 1 unary minus; 8 sine/cosine */
void stanford_full_gravity(const stanford_full_real q[6], stanford_full_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_full_real s6 = sin(q[5]);
    const stanford_full_real c6 = cos(q[5]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_full_real hw6_y = 11.695353768620235*s6 - 11.931194031426555*c6;
    /* sines and cosines of the joint angles */
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s2 = sin(q[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s5 = sin(q[4]);
    /* link 6: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_full_real hw6_x = 11.695353768620235*c6 + 11.931194031426555*s6;
    /* sines and cosines of the joint angles */
    const stanford_full_real s4 = sin(q[3]);
    const stanford_full_real t1 = s2*c4;
    const stanford_full_real t2 = s2*s4;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const stanford_full_real tau6 = hw6_y*(c5*t1 + c2*s5) + hw6_x*t2;
    const stanford_full_real t3 = hw6_x - 5.792857332338038;
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_full_real hw5_y = s5*t3 - 6.33896479511625*c5;
    const stanford_full_real hw5_x = c5*t3 + 6.33896479511625*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const stanford_full_real tau5 = t1*hw5_y - c2*hw5_x;
    const stanford_full_real t4 = hw6_y + 2.749310421134319;
    const stanford_full_real t5 = hw5_x + 8.842428262892447;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const stanford_full_real tau4 = t1*t4 + t2*t5;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_full_real tau3 = 193.38181895468085*c2;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_full_real hw4_x = c4*t5 - s4*t4;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_full_real hw2_x = c2*(hw4_x + 3.634792872513057) + s2*(193.38181895468085*q[2] -
        (hw5_y - 5.566797605293052));
    const stanford_full_real t6 = -hw2_x;
    tau[0] = 0.0;
    tau[1] = t6;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 184 multiplications, 164 additions = 348; 0 unary minus; 8 sine/cosine */
void stanford_full_bias(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    stanford_full_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_full_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww2_yz = neg_w2_y*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww3_xy = neg_w2_x*qd[1];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    const stanford_full_real ww2_yy = neg_w2_y*neg_w2_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_32 = 2.0*neg_ww2_yz;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_zz + ww2_yy;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2;
    /* sines and cosines of the joint angles */
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_full_real w4_z = neg_w2_y + qd[3];
    const stanford_full_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const stanford_full_real ww4_xx = neg_w4_x*neg_w4_x;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    const stanford_full_real ww4_yz = w4_z*w4_y;
    const stanford_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_21 = neg_ww3_xy + neg_ww4_xy;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real lam4_12 = neg_ww3_xy - neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_full_real w5_z = w4_y + qd[4];
    const stanford_full_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    const stanford_full_real ww5_xy = neg_w5_x*neg_w5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = neg_w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(q[5]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_z = 0.1524*ww1_zz;
    const stanford_full_real t1 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_y = neg_a2_z - (neg_lam2_32*q[2] + neg_w2_x*t1);
    const stanford_full_real t2 = ww2_zz - ww2_yy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_22 = ww1_zz + t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a3_z = 9.8*c2 - q[2]*neg_lam2_22;
    const stanford_full_real neg_a3_x = neg_a2_x - (qd[1]*t1 - ww2_xy*q[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_y = c4*neg_a3_y - s4*neg_a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = qd[3]*w4_y - neg_ww2_yz*c4;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_y = neg_ww3_xy*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_31 = neg_ww5_zx + alpha5_y;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_y = neg_ww2_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_x = c4*neg_a3_x + s4*neg_a3_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a5_x = c5*neg_a4_x + s5*a3_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_23 = lam4_12*s5 + c5*lam4_32;
    const stanford_full_real t3 = 2.0*w5_z;
    const stanford_full_real lam5_32 = neg_lam5_23 - neg_w5_y*t3;
    const stanford_full_real neg_lam5_13 = neg_ww5_zx - alpha5_y;
    const stanford_full_real t4 = ww5_xx - ww5_zz;
    const stanford_full_real t5 = 0.0625396920897071*c6;
    const stanford_full_real t6 = 0.16255029097038232*c6;
    const stanford_full_real t7 = t5*t6 + 0.3409906449060338;
    const stanford_full_real t8 = 0.0625396920897071*s6;
    const stanford_full_real t9 = t6*t8;
    const stanford_full_real t10 = 62.4559348502784*t7 + (t9 - 21.61434818388583);
    const stanford_full_real t11 = 0.06483323523282834*s6;
    const stanford_full_real t12 = 18.778467160320414*(t11 + 0.06355169650371038*c6);
    const stanford_full_real t13 = t7 - 62.4559348502784*t9;
    const stanford_full_real t14 = t13 - 0.6921471349584476;
    const stanford_full_real t15 = t5 - t11;
    const stanford_full_real t16 = 1.193403445777575*s6 - 1.2174687787169953*c6;
    const stanford_full_real t17 = t8 + 0.06483323523282834*c6;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_z = t4*t10 - (neg_a4_y*t12 - (t14*neg_lam5_31 + t15*lam5_12)) +
        (t16*neg_a5_x + t17*lam5_32 + t13*neg_lam5_13);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a5_y = c5*a3_z - s5*neg_a4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_21 = ww5_xy + alpha4_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_zz = w6_z*w6_z;
    const stanford_full_real t18 = 0.28054187970758354*neg_a5_x + (1.1561689763413345*neg_lam5_13 -
        (0.20245111268601115*neg_lam5_31 - (0.13660343902034475*t4 + 0.5911078910549018*neg_a4_y)))
        + 0.23560176217086468*lam5_12;
    const stanford_full_real t19 = nc6_z + (0.060693211657558095*lam5_32 + t18);
    const stanford_full_real t20 = lam5_21 + neg_w5_x*(2.0*qd[5]);
    const stanford_full_real t21 = ww5_xx - ww6_zz;
    const stanford_full_real t22 = neg_lam5_23 + qd[5]*t3;
    const stanford_full_real t23 = t16 + 0.28054187970758354;
    const stanford_full_real t24 = 0.13660343902034475*lam5_21 + (t23*neg_a5_y +
        (0.17535491873574263*lam5_32 + (0.23560176217086468*(neg_lam4_22 - neg_lam5_22) +
        0.6468331423588011*neg_a4_y)));
    const stanford_full_real t25 = t10*t20 + (t15*(t4 - t21) + (1.1561689763413345*neg_lam5_23 +
        (t13*t22 + t24))) - neg_lam5_31*(t17 + 0.060693211657558095);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = s5*t19 + 0.06784076259315977*neg_lam4_31 + (c5*t25 +
        0.23523950726161555*(neg_lam2_22 - (neg_lam4_22 + 0.011289042504553535*neg_lam4_21)));
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_11 = t4 - neg_lam4_22;
    const stanford_full_real t26 = neg_lam5_22 - t21;
    const stanford_full_real t27 = -0.5911078910549018*lam5_11 - (0.6468331423588011*lam5_12 +
        t12*t26) - neg_lam5_13*t23;
    const stanford_full_real t28 = 0.6468331423588011*neg_lam5_22 - (0.28054187970758354*neg_lam5_23
        + t16*t22 - t12*t20 + 0.5911078910549018*lam5_21);
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_z = -0.22200183325724177*(ww2_xy + 0.05481374553845334*neg_lam2_22)
        - (s5*t27 + c5*t28 - 19.732838668844984*a3_z + 0.9022885982543313*neg_lam4_31);
    const stanford_full_real t29 = t12 - 0.5911078910549018;
    /* link 4: force through the joint [N] */
    const stanford_full_real neg_f4_y = t16*(t4 + t26) + (0.6468331423588011*lam5_32 +
        (0.9022885982543313*neg_lam4_21 + 0.28054187970758354*neg_lam4_22)) + neg_lam5_31*t29;
    const stanford_full_real t30 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_11 = t30 - neg_lam2_22;
    /* link 4: force through the joint [N] */
    const stanford_full_real neg_f4_x = s5*t28 - c5*t27 - 0.9022885982543313*lam4_11;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_y = 0.024337503994465198*neg_ww2_yz - (c4*neg_f4_y +
        19.732838668844984*neg_a3_y + (0.44400366651448353*neg_ww3_xy + (0.4516316755890639*ww1_zz +
        s4*neg_f4_x)));
    const stanford_full_real t31 = 0.17535491873574263*lam5_12 - (0.20245111268601115*lam5_21 -
        (t14*t20 + (t17*t21 + (0.6468331423588011*neg_a5_x - 0.13660343902034475*neg_lam5_23))));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_z = t10*t22 - (neg_a5_y*t29 + (0.060693211657558095*(neg_lam5_22 +
        lam5_11) + t31)) - neg_lam5_13*(t15 + 0.23560176217086468);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real neg_n4_y = 0.23523950726161555*lam4_12 + (0.002655628796226608*t30 -
        0.3448462092987837*neg_lam4_31 - 0.06784076259315977*lam4_32 - (n5_z -
        0.9022885982543313*a3_z));
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real t32 = 0.06784076259315977*(neg_lam4_22 + lam4_11) - s5*t25 -
        (0.3448462092987837*neg_lam4_21 + (0.002655628796226608*lam4_23 +
        0.9022885982543313*neg_a4_y));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_z = c5*t19 + 0.23523950726161555*lam4_13 + t32;
    const stanford_full_real t33 = 0.012168751997232599*ww2_xy;
    /* link 3: force through the joint [N] */
    const stanford_full_real neg_f3_x = 0.22200183325724177*neg_lam2_11 + (t33 + (c4*neg_f4_x +
        19.732838668844984*neg_a3_x)) - s4*neg_f4_y;
    const stanford_full_real t34 = ww1_zz - neg_lam2_11;
    const stanford_full_real t35 = 0.1524*neg_f3_x - (0.22200183325724177*neg_a3_y - n4_z -
        12.556178777734242*(t33 + 0.0359688790342758*neg_a3_x) + 0.07388986205514168*t34);
    const stanford_full_real t36 = 0.1524*(0.4848416145350504*ww2_xy - f3_z) - (c4*n4_x +
        (0.4516316755890639*a3_z + (0.012168751997232599*neg_a3_y - (0.15279302557916313*t2 +
        0.09822440530186452*neg_ww3_xy))));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = c2*(t35 - 0.09822440530186452*neg_ww2_yz -
        0.248077550893258*neg_ww3_xy) - s2*(s4*neg_n4_y - (q[2]*f3_y + t36) -
        1.2453237337332923*neg_ww2_yz);
    const stanford_full_real t37 = q[2]*neg_f3_x + (5.4475438357201735*s2 +
        (0.49862309142001715*ww2_xy + (0.04911220265093226*(t2 + t34) + c4*neg_n4_y)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_z = s4*n4_x - 1.4591749065920876*c2 - (t37 +
        0.012168751997232599*neg_a3_x) - 0.22200183325724177*a3_z;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 90 multiplications, 84 additions = 174; 3 unary minus; 8 sine/cosine */
void stanford_full_mass_matrix(const stanford_full_real q[6], stanford_full_real M[36])
{
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    const stanford_full_real s2 = sin(q[1]);
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(q[3]);
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(q[4]);
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(q[5]);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_x = 1.193403445777575*c6 + 1.2174687787169953*s6;
    const stanford_full_real t1 = h6_x - 0.5911078910549018;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h5_x = c5*t1 + 0.6468331423588011*s5;
    const stanford_full_real h5_y = s5*t1 - 0.6468331423588011*c5;
    const stanford_full_real t2 = 0.6349173621603285*c6;
    const stanford_full_real t3 = s6*t2;
    const stanford_full_real t4 = c6*t2 - 0.1808552420598195;
    /* link 5: mass matrix, its row of this joint */
    const stanford_full_real m5_5 = t3 + 0.7260667959919797 - 0.01601128863729661*t4;
    const stanford_full_real t5 = 0.05432633487209812*h6_x;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k6_xz = t5 - 0.003600924479196722*s6;
    const stanford_full_real t6 = c5*c5;
    const stanford_full_real t7 = m5_5 - 0.35070983747148526;
    const stanford_full_real t8 = c5*s5;
    const stanford_full_real t9 = neg_k6_xz + (neg_k6_xz + 0.12138642331511619);
    const stanford_full_real t10 = t6*t7 - (t8*t9 - 3.589792571474863);
    const stanford_full_real t11 = m5_5 + 0.8434693007188008;
    /* link 4: mass matrix, its row of this joint */
    const stanford_full_real m4_4 = t10 - t11;
    const stanford_full_real t12 = 0.1286340586837634*c6;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_y = 19.08233644747969*(neg_k6_xz - t12);
    const stanford_full_real t13 = h5_x + 0.9022885982543313;
    const stanford_full_real t14 = h6_y + 0.28054187970758354;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h4_y = s4*t13 + c4*t14;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k6_yz = 0.9802333058883194*(t5 - t12);
    const stanford_full_real t15 = neg_k6_yz - 0.23560176217086468;
    const stanford_full_real t16 = t4 + 0.01601128863729661*t3;
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k5_xz = s5*t15 + c5*t16;
    const stanford_full_real t17 = c4*t13 - (s4*t14 - 0.3708972318890874);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real neg_h3_x = 0.14889539863184567 - t17;
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real k5_yz = c5*t15 - s5*t16;
    const stanford_full_real t18 = 0.1524*h4_y;
    const stanford_full_real t19 = m4_4 + t18;
    const stanford_full_real t20 = 19.732838668844984*q[2] - (h5_y - 0.5680405719686789);
    const stanford_full_real t21 = h5_y*q[2];
    const stanford_full_real t22 = m4_4 - q[2]*(t20 - 0.5437030679742136) + t21;
    const stanford_full_real t23 = c4*c4;
    const stanford_full_real t24 = t10 + (m5_5 - 5.295713586161873);
    const stanford_full_real t25 = c4*s4;
    const stanford_full_real t26 = neg_k5_xz + (neg_k5_xz + 0.13568152518631954);
    const stanford_full_real t27 = t11 - t23*t24 - t25*t26;
    const stanford_full_real t28 = t9*(t6 - 0.5) + (t7*t8 + 0.002655628796226608);
    const stanford_full_real t29 = -k5_yz - 0.23523950726161555;
    const stanford_full_real t30 = c4*t28 + q[2]*neg_h3_x + s4*t29;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_1 = t19 - (s2*(s2*(t22 - t27) + c2*(t30 + (t30 +
        0.09822440530186452))) - (t18 + 1.8329821847328702));
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h2_y = s2*t17 - c2*t20;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k4_yz = s4*t28 - c4*t29;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_4 = neg_k4_yz - h4_y*q[2];
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_2 = c2*(m2_4 - 0.06807816021551473 - 0.4516316755890639*q[2]) -
        (s2*(t26*(t23 - 0.5) - (t24*t25 + 0.0511982033036484)) - 0.1524*h2_y);
    const stanford_full_real m1_3 = s2*(-h4_y - 3.45891628872104);
    const stanford_full_real m1_4 = c2*t19 - s2*(t30 + 0.22200183325724177*q[2]);
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x = s2*h5_x + h5_y*(c2*c4);
    const stanford_full_real t31 = m5_5 - t21;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y = s2*(c4*neg_k5_xz - s4*t31) - c2*k5_yz;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_5 = 0.1524*neg_fu2_x - nu2_y;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu5_x = c5*h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu4_x = s4*h6_x + c4*neg_fu5_x;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu5_y = s5*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_full_real neg_nu5_y = 0.6921471349584476*c5 - s5*neg_k6_xz;
    const stanford_full_real nu5_x = 0.6921471349584476*s5 + c5*neg_k6_xz;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_y = c4*h6_x - s4*neg_fu5_x;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_6 = 0.1524*(c2*neg_fu4_x - s2*neg_fu5_y) + (c2*neg_nu5_y -
        s2*(c4*nu5_x - (s4*neg_k6_yz + q[2]*fu4_y)));
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_2 = 6.387260437773931 - t27 - t22;
    const stanford_full_real m2_5 = c4*t31 + s4*neg_k5_xz;
    const stanford_full_real m2_6 = s4*nu5_x - q[2]*neg_fu4_x + c4*neg_k6_yz;
    const stanford_full_real t32 = -h5_x;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = m1_6;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = neg_h3_x;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = m1_3;
    M[13] = neg_h3_x;
    M[14] = 19.732838668844984;
    M[15] = 0.0;
    M[16] = t32;
    M[17] = neg_fu5_y;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = 0.0;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = t32;
    M[27] = k5_yz;
    M[28] = m5_5;
    M[29] = neg_k6_yz;
    M[30] = m1_6;
    M[31] = m2_6;
    M[32] = neg_fu5_y;
    M[33] = neg_nu5_y;
    M[34] = neg_k6_yz;
    M[35] = 0.6921471349584476;
}

/* accelerations that the torques tau give
 * 358 multiplications, 316 additions, 5 divisions = 679; 2 unary minus; 8 sine/cosine */
void stanford_full_forward_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real tau[6],
    stanford_full_real qdd[6])
{
    /* sines and cosines of the joint angles */
    const stanford_full_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_full_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_full_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww2_yz = neg_w2_y*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww3_xy = neg_w2_x*qd[1];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_full_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_full_real ww2_zz = qd[1]*qd[1];
    const stanford_full_real ww2_yy = neg_w2_y*neg_w2_y;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_11 = ww2_zz + ww2_yy;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_x = 9.8*s2;
    /* sines and cosines of the joint angles */
    const stanford_full_real c4 = cos(q[3]);
    const stanford_full_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_full_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_full_real w4_z = neg_w2_y + qd[3];
    const stanford_full_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww4_xy = neg_w4_x*w4_y;
    const stanford_full_real ww4_xx = neg_w4_x*neg_w4_x;
    const stanford_full_real ww4_zz = w4_z*w4_z;
    const stanford_full_real ww4_yz = w4_z*w4_y;
    const stanford_full_real neg_ww4_zx = neg_w4_x*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_21 = neg_ww3_xy + neg_ww4_xy;
    const stanford_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const stanford_full_real lam4_12 = neg_ww3_xy - neg_ww4_xy;
    /* sines and cosines of the joint angles */
    const stanford_full_real c5 = cos(q[4]);
    const stanford_full_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_full_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_full_real w5_z = w4_y + qd[4];
    const stanford_full_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_full_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_full_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_full_real ww5_zz = w5_z*w5_z;
    const stanford_full_real ww5_xy = neg_w5_x*neg_w5_y;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_full_real w6_z = neg_w5_y + qd[5];
    /* sines and cosines of the joint angles */
    const stanford_full_real c6 = cos(q[5]);
    const stanford_full_real s6 = sin(q[5]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a2_z = 0.1524*ww1_zz;
    const stanford_full_real t1 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_y = neg_a2_z - (neg_w2_x*t1 + 2.0*(neg_ww2_yz*q[2]));
    const stanford_full_real t2 = ww2_zz - ww2_yy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam2_22 = ww1_zz + t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a3_z = q[2]*neg_lam2_22 - 9.8*c2;
    const stanford_full_real neg_a3_x = neg_a2_x - (qd[1]*t1 - ww2_xy*q[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_y = c4*neg_a3_y - s4*neg_a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_x = qd[3]*w4_y - neg_ww2_yz*c4;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_full_real alpha5_y = neg_ww3_xy*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_31 = neg_ww5_zx + alpha5_y;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_full_real alpha4_y = neg_ww2_yz*s4 + neg_w4_x*qd[3];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a4_x = c4*neg_a3_x + s4*neg_a3_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real neg_a5_x = c5*neg_a4_x - s5*neg_a3_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam5_23 = lam4_12*s5 + c5*lam4_32;
    const stanford_full_real t3 = 2.0*w5_z;
    const stanford_full_real lam5_32 = neg_lam5_23 - neg_w5_y*t3;
    const stanford_full_real neg_lam5_13 = neg_ww5_zx - alpha5_y;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_x = 1.2174687787169953*s6 + 1.193403445777575*c6;
    const stanford_full_real t4 = ww5_xx - ww5_zz;
    const stanford_full_real t5 = 0.16255029097038232*c6;
    const stanford_full_real t6 = 0.0625396920897071*s6;
    const stanford_full_real t7 = t5*t6;
    const stanford_full_real t8 = 0.0625396920897071*c6;
    const stanford_full_real t9 = t8*t5 + 0.3409906449060338;
    const stanford_full_real t10 = t7 - 21.61434818388583 + 62.4559348502784*t9;
    const stanford_full_real t11 = t9 - 62.4559348502784*t7;
    const stanford_full_real t12 = t11 - 0.6921471349584476;
    const stanford_full_real t13 = t8 - 0.06483323523282834*s6;
    const stanford_full_real t14 = 1.193403445777575*s6 - 1.2174687787169953*c6;
    const stanford_full_real t15 = t6 + 0.06483323523282834*c6;
    /* link 6: moment that turns the link [N m] */
    const stanford_full_real nc6_z = t4*t10 - (neg_a4_y*h6_x - (neg_lam5_31*t12 + lam5_12*t13)) +
        (neg_a5_x*t14 + lam5_32*t15 + neg_lam5_13*t11);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real neg_lam4_31 = neg_ww4_zx + alpha4_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_full_real a5_y = c5*neg_a3_z + s5*neg_a4_x;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_21 = ww5_xy + alpha4_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const stanford_full_real ww6_zz = w6_z*w6_z;
    const stanford_full_real t16 = neg_a5_x + 0.486927082554413*(t4 + 4.327181623640283*neg_a4_y -
        1.4820352557585283*neg_lam5_31 + 8.463688649662348*neg_lam5_13) +
        0.8398095942624995*lam5_12;
    const stanford_full_real t17 = nc6_z + 0.28054187970758354*(t16 + 0.21634278532966372*lam5_32);
    const stanford_full_real t18 = lam5_21 + 2.0*(neg_w5_x*qd[5]);
    const stanford_full_real t19 = ww5_xx - ww6_zz;
    const stanford_full_real t20 = neg_lam5_23 + qd[5]*t3;
    const stanford_full_real t21 = t14 + 0.28054187970758354;
    const stanford_full_real t22 = a5_y*t21 - 0.6468331423588011*(neg_a4_y +
        0.3642388534880846*(neg_lam4_22 - neg_lam5_22) + 0.27109760964980445*lam5_32) -
        0.13660343902034475*lam5_21;
    const stanford_full_real t23 = t10*t18 + (t13*(t4 - t19) + (t11*t20 - t22 +
        1.1561689763413345*neg_lam5_23)) - neg_lam5_31*(t15 + 0.060693211657558095);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_x = s5*t17 + 0.06784076259315977*neg_lam4_31 + (c5*t23 +
        0.23523950726161555*(neg_lam2_22 - (neg_lam4_22 + 0.011289042504553535*neg_lam4_21)));
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam5_11 = t4 - neg_lam4_22;
    const stanford_full_real t24 = neg_lam5_22 - t19;
    const stanford_full_real t25 = h6_x*t24 + 0.6468331423588011*lam5_12 +
        0.5911078910549018*lam5_11 + neg_lam5_13*t21;
    const stanford_full_real t26 = t14*t20 + 0.28054187970758354*neg_lam5_23 - h6_x*t18 +
        0.5911078910549018*lam5_21 - 0.6468331423588011*neg_lam5_22;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_z = s5*t25 + c5*t26 - 19.732838668844984*neg_a3_z -
        0.9022885982543313*neg_lam4_31 - 0.012168751997232599*(neg_lam2_22 +
        18.243599122385692*ww2_xy);
    const stanford_full_real t27 = h6_x - 0.5911078910549018;
    /* link 4: force through the joint [N] */
    const stanford_full_real neg_f4_y = t14*(t4 + t24) + 0.6468331423588011*(lam5_32 +
        1.39493254004265*(neg_lam4_21 + 0.310922558758197*neg_lam4_22)) + neg_lam5_31*t27;
    const stanford_full_real t28 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_11 = t28 - neg_lam2_22;
    /* link 4: force through the joint [N] */
    const stanford_full_real f4_x = s5*t26 - c5*t25 + 0.9022885982543313*lam4_11;
    /* link 3: force through the joint [N] */
    const stanford_full_real neg_f3_y = c4*neg_f4_y + 19.732838668844984*neg_a3_y - (s4*f4_x -
        0.4516316755890639*ww1_zz - 0.44400366651448353*neg_ww3_xy) -
        0.024337503994465198*neg_ww2_yz;
    const stanford_full_real t29 = t12*t18 + (t15*t19 + 0.6468331423588011*(neg_a5_x -
        0.2111880639297395*neg_lam5_23)) - 0.20245111268601115*lam5_21 +
        0.17535491873574263*lam5_12;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n5_z = t10*t20 + (a5_y*t27 - (t29 + 0.060693211657558095*(neg_lam5_22 +
        lam5_11))) - neg_lam5_13*(t13 + 0.23560176217086468);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_y = n5_z + 0.9022885982543313*neg_a3_z +
        0.06784076259315977*(lam4_32 - 0.03914503161104455*(t28 - 129.85482375728748*neg_lam4_31)) -
        0.23523950726161555*lam4_12;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_full_real lam4_13 = alpha4_y - neg_ww4_zx;
    const stanford_full_real lam4_23 = ww4_yz - alpha4_x;
    const stanford_full_real t30 = s5*t23 - 0.06784076259315977*(neg_lam4_22 + lam4_11) +
        0.9022885982543313*(neg_a4_y + 0.002943214400984879*lam4_23 +
        0.38219058731980193*neg_lam4_21);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n4_z = c5*t17 + 0.23523950726161555*lam4_13 - t30;
    /* link 3: force through the joint [N] */
    const stanford_full_real f3_x = c4*f4_x - 19.732838668844984*neg_a3_x -
        0.012168751997232599*ww2_xy - 0.22200183325724177*neg_lam2_11 + s4*neg_f4_y;
    const stanford_full_real t31 = ww1_zz - neg_lam2_11;
    const stanford_full_real t32 = n4_z - 0.22200183325724177*neg_a3_y + 0.15279302557916313*(ww2_xy
        + 2.955839599858374*neg_a3_x) - 0.07388986205514168*t31 - 0.1524*f3_x;
    const stanford_full_real t33 = c4*n4_x + 0.012168751997232599*(neg_a3_y -
        8.071855299886346*(neg_ww3_xy + 1.5555505285025408*t2) - 37.11405045412819*neg_a3_z) -
        0.07388986205514168*(ww2_xy - 2.0625292260833925*f3_z);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n1_z = c2*(t32 - 0.09822440530186452*neg_ww2_yz -
        0.248077550893258*neg_ww3_xy) + s2*(s4*n4_y - (q[2]*neg_f3_y + t33) +
        1.2453237337332923*neg_ww2_yz);
    const stanford_full_real t34 = q[2]*f3_x + (c4*n4_y - 0.04911220265093226*(t2 + t31) -
        0.49862309142001715*ww2_xy - 5.4475438357201735*s2);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_full_real n2_z = s4*n4_x - 1.4591749065920876*c2 + (t34 -
        0.012168751997232599*neg_a3_x) + 0.22200183325724177*neg_a3_z;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h5_x = c5*t27 + 0.6468331423588011*s5;
    const stanford_full_real h5_y = s5*t27 - 0.6468331423588011*c5;
    const stanford_full_real t35 = 0.6349173621603285*c6;
    const stanford_full_real t36 = s6*t35;
    const stanford_full_real t37 = c6*t35 - 0.1808552420598195;
    /* link 5: mass matrix, its row of this joint */
    const stanford_full_real m5_5 = t36 + 0.7260667959919797 - 0.01601128863729661*t37;
    const stanford_full_real t38 = 0.05432633487209812*h6_x;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k6_xz = t38 - 0.003600924479196722*s6;
    const stanford_full_real t39 = c5*c5;
    const stanford_full_real t40 = m5_5 - 0.35070983747148526;
    const stanford_full_real t41 = c5*s5;
    const stanford_full_real t42 = neg_k6_xz + (neg_k6_xz + 0.12138642331511619);
    const stanford_full_real t43 = t39*t40 - (t41*t42 - 3.589792571474863);
    const stanford_full_real t44 = m5_5 + 0.8434693007188008;
    /* link 4: mass matrix, its row of this joint */
    const stanford_full_real m4_4 = t43 - t44;
    const stanford_full_real t45 = 0.1286340586837634*c6;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h6_y = 19.08233644747969*(neg_k6_xz - t45);
    const stanford_full_real t46 = h5_x + 0.9022885982543313;
    const stanford_full_real t47 = 0.28054187970758354 + h6_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h4_y = s4*t46 + c4*t47;
    const stanford_full_real t48 = t38 - t45;
    /* link 6: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k6_yz = 0.9802333058883194*t48;
    const stanford_full_real t49 = 0.23560176217086468 - neg_k6_yz;
    const stanford_full_real t50 = t37 + 0.01601128863729661*t36;
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real k5_xz = s5*t49 - c5*t50;
    const stanford_full_real t51 = c4*t46 - (s4*t47 - 0.3708972318890874);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h3_x = t51 - 0.14889539863184567;
    /* link 5: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k5_yz = c5*t49 + s5*t50;
    const stanford_full_real t52 = 0.1524*h4_y;
    const stanford_full_real t53 = m4_4 + t52;
    const stanford_full_real t54 = h5_y - 0.5680405719686789 - 19.732838668844984*q[2];
    const stanford_full_real t55 = q[2]*h5_y;
    const stanford_full_real t56 = m4_4 + q[2]*(t54 + 0.5437030679742136) + t55;
    const stanford_full_real t57 = c4*c4;
    const stanford_full_real t58 = t43 + (m5_5 - 5.295713586161873);
    const stanford_full_real t59 = c4*s4;
    const stanford_full_real t60 = k5_xz + (k5_xz - 0.13568152518631954);
    const stanford_full_real t61 = t44 - t57*t58 + t59*t60;
    const stanford_full_real t62 = t42*(t39 - 0.5) + (t40*t41 + 0.002655628796226608);
    const stanford_full_real t63 = neg_k5_yz - 0.23523950726161555;
    const stanford_full_real t64 = c4*t62 - q[2]*h3_x + s4*t63;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_1 = t53 - (s2*(s2*(t56 - t61) + c2*(t64 + (t64 +
        0.09822440530186452))) - (t52 + 1.8329821847328702));
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_full_real h2_y = s2*t51 + c2*t54;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_full_real neg_k4_yz = s4*t62 - c4*t63;
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real m2_4 = neg_k4_yz - q[2]*h4_y;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_2 = c2*(m2_4 - 0.06807816021551473 - 0.4516316755890639*q[2]) +
        (s2*(t60*(t57 - 0.5) + (t58*t59 + 0.0511982033036484)) + 0.1524*h2_y);
    const stanford_full_real neg_m1_3 = s2*(h4_y + 3.45891628872104);
    const stanford_full_real m1_4 = c2*t53 - s2*(t64 + 0.22200183325724177*q[2]);
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu2_x = s2*h5_x + h5_y*(c2*c4);
    const stanford_full_real t65 = m5_5 - t55;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu2_y = c2*neg_k5_yz - s2*(c4*k5_xz + s4*t65);
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real m1_5 = 0.1524*neg_fu2_x - nu2_y;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu5_x = c5*h6_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu4_x = s4*h6_x + c4*neg_fu5_x;
    /* link 5: force for a unit acceleration of a joint further out */
    const stanford_full_real neg_fu5_y = s5*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_full_real nu5_y = s5*neg_k6_xz - 0.6921471349584476*c5;
    const stanford_full_real nu5_x = c5*neg_k6_xz + 0.6921471349584476*s5;
    /* link 4: force for a unit acceleration of a joint further out */
    const stanford_full_real fu4_y = c4*h6_x - s4*neg_fu5_x;
    /* link 1: mass matrix, its row of this joint */
    const stanford_full_real neg_m1_6 = c2*nu5_y + s2*(c4*nu5_x - (s4*neg_k6_yz + q[2]*fu4_y)) -
        0.1524*(c2*neg_fu4_x - s2*neg_fu5_y);
    /* link 2: mass matrix, its row of this joint */
    const stanford_full_real neg_m2_2 = t56 + (t61 - 6.387260437773931);
    const stanford_full_real m2_5 = c4*t65 - s4*k5_xz;
    const stanford_full_real m2_6 = s4*nu5_x - q[2]*neg_fu4_x + c4*neg_k6_yz;
    /* link 6: forward substitution */
    const stanford_full_real neg_y6 = nc6_z - tau[5];
    /* factorisation M = U D U^T */
    const stanford_full_real u5_6 = 1.4162209975010107*t48;
    const stanford_full_real neg_u4_6 = 1.4447795121770373*nu5_y;
    const stanford_full_real u3_6 = 1.4447795121770373*neg_fu5_y;
    const stanford_full_real u2_6 = 1.4447795121770373*m2_6;
    const stanford_full_real neg_u1_6 = 1.4447795121770373*neg_m1_6;
    const stanford_full_real pivot5 = m5_5 - neg_k6_yz*u5_6;
    const stanford_full_real ipivot5 = 1.0 / pivot5;
    const stanford_full_real neg_ud4_5 = neg_k5_yz - neg_k6_yz*neg_u4_6;
    const stanford_full_real neg_u4_5 = ipivot5*neg_ud4_5;
    const stanford_full_real neg_ud3_5 = h5_x + neg_k6_yz*u3_6;
    const stanford_full_real neg_u3_5 = ipivot5*neg_ud3_5;
    const stanford_full_real ud2_5 = m2_5 - neg_k6_yz*u2_6;
    const stanford_full_real u2_5 = ipivot5*ud2_5;
    const stanford_full_real ud1_5 = m1_5 + neg_k6_yz*neg_u1_6;
    const stanford_full_real u1_5 = ipivot5*ud1_5;
    const stanford_full_real pivot4 = m4_4 - nu5_y*neg_u4_6 - neg_ud4_5*neg_u4_5;
    const stanford_full_real ipivot4 = 1.0 / pivot4;
    const stanford_full_real ud3_4 = nu5_y*u3_6 - neg_ud4_5*neg_u3_5;
    const stanford_full_real u3_4 = ipivot4*ud3_4;
    const stanford_full_real ud2_4 = m2_4 + nu5_y*u2_6 + neg_ud4_5*u2_5;
    const stanford_full_real u2_4 = ipivot4*ud2_4;
    const stanford_full_real ud1_4 = m1_4 - nu5_y*neg_u1_6 + neg_ud4_5*u1_5;
    const stanford_full_real u1_4 = ipivot4*ud1_4;
    const stanford_full_real neg_pivot3 = neg_fu5_y*u3_6 - 19.732838668844984 + neg_ud3_5*neg_u3_5 +
        ud3_4*u3_4;
    const stanford_full_real neg_ipivot3 = 1.0 / neg_pivot3;
    const stanford_full_real neg_ud2_3 = h3_x + neg_fu5_y*u2_6 - neg_ud3_5*u2_5 + ud3_4*u2_4;
    const stanford_full_real u2_3 = neg_ipivot3*neg_ud2_3;
    const stanford_full_real neg_ud1_3 = neg_m1_3 - neg_fu5_y*neg_u1_6 - neg_ud3_5*u1_5 +
        ud3_4*u1_4;
    const stanford_full_real u1_3 = neg_ipivot3*neg_ud1_3;
    const stanford_full_real neg_pivot2 = neg_m2_2 + m2_6*u2_6 + ud2_5*u2_5 + ud2_4*u2_4 -
        neg_ud2_3*u2_3;
    const stanford_full_real neg_ipivot2 = 1.0 / neg_pivot2;
    const stanford_full_real ud1_2 = m1_2 + m2_6*neg_u1_6 - ud2_5*u1_5 - ud2_4*u1_4 +
        neg_ud2_3*u1_3;
    const stanford_full_real neg_u1_2 = neg_ipivot2*ud1_2;
    const stanford_full_real pivot1 = m1_1 - neg_m1_6*neg_u1_6 - ud1_5*u1_5 - ud1_4*u1_4 +
        neg_ud1_3*u1_3 + ud1_2*neg_u1_2;
    const stanford_full_real ipivot1 = 1.0 / pivot1;
    /* link 5: forward substitution */
    const stanford_full_real neg_y5 = n5_z - tau[4] - neg_y6*u5_6;
    /* link 4: forward substitution */
    const stanford_full_real neg_y4 = n4_z - tau[3] + neg_y6*neg_u4_6 + neg_u4_5*neg_y5;
    /* link 3: forward substitution */
    const stanford_full_real neg_y3 = f3_z - tau[2] - neg_y6*u3_6 + neg_u3_5*neg_y5 - u3_4*neg_y4;
    /* link 2: forward substitution */
    const stanford_full_real neg_y2 = n2_z - tau[1] - neg_y6*u2_6 - u2_5*neg_y5 - u2_4*neg_y4 -
        u2_3*neg_y3;
    /* link 1: forward substitution */
    const stanford_full_real neg_y1 = n1_z - tau[0] + neg_y6*neg_u1_6 - u1_5*neg_y5 - u1_4*neg_y4 -
        u1_3*neg_y3 + neg_u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd2 = neg_ipivot2*neg_y2 - neg_u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 + u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real neg_qdd4 = ipivot4*neg_y4 + u3_4*qdd3 + u2_4*qdd2 - u1_4*neg_qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd5 = u1_5*neg_qdd1 - (ipivot5*neg_y5 + neg_u4_5*neg_qdd4 -
        neg_u3_5*qdd3 + u2_5*qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_full_real qdd6 = -1.4447795121770373*neg_y6 - u5_6*qdd5 - neg_u4_6*neg_qdd4 -
        u3_6*qdd3 - u2_6*qdd2 - neg_u1_6*neg_qdd1;
    const stanford_full_real t66 = -neg_qdd1;
    const stanford_full_real t67 = -neg_qdd4;
    qdd[0] = t66;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = t67;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
