/*
 * stanford_d3: Stanford arm, the set of the thesis's listing D.3.2
 * Numbers: the 1990 thesis, listing D.3.2 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
 *   tables
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 0e9c705765a81730942efe1f695fcd86 (a hash of its numbers)
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 117 multiplications, 84 additions = 201; 0 unary minus; 6 sine/cosine
 *   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
 *   bias: 110 multiplications, 71 additions = 181; 0 unary minus; 6 sine/cosine
 *   mass_matrix: 40 multiplications, 32 additions = 72; 2 unary minus; 6 sine/cosine
 *   forward_dynamics: 207 multiplications, 150 additions, 4 divisions = 361; 1 unary minus; 6
 *       sine/cosine
 */
#include "stanford_d3.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 117 multiplications, 84 additions = 201; 0 unary minus; 6 sine/cosine */
void stanford_d3_inverse_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real qdd[6],
    stanford_d3_real tau[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_33 = qd[0]*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_x = qd[0]*s2;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww2_zx = neg_w2_x*qd[1];
    const stanford_d3_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_d3_real ww2_xx = neg_w2_x*neg_w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_22 = ww2_xx + ww2_zz;
    const stanford_d3_real lam2_12 = ww2_xy - qdd[1];
    /* sines and cosines of the joint angles */
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    const stanford_d3_real w4_z = neg_w2_y + qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww4_zx = neg_w4_x*w4_z;
    const stanford_d3_real neg_ww4_xy = neg_w4_x*w4_y;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_d3_real w5_z = w4_y + qd[4];
    const stanford_d3_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_d3_real ww5_xy = neg_w5_x*neg_w5_y;
    const stanford_d3_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_z = neg_w5_y + qd[5];
    const stanford_d3_real t1 = 0.0203*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_y = neg_w5_x*t1;
    const stanford_d3_real n06_x = w5_z*t1;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam2_23 = s2*qdd[0];
    const stanford_d3_real t2 = 2.0*qd[1];
    const stanford_d3_real neg_lam2_32 = lam2_23 + neg_w2_y*t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_y = 0.1524*neg_lam2_33 - (neg_lam2_32*q[2] +
        2.0*(neg_w2_x*qd[2]));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = -2.749911*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_13 = c2*qdd[0];
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha2_y = neg_ww2_zx - neg_lam2_13;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_12 = alpha2_y - (neg_ww4_xy + qdd[3]);
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_32 = c4*neg_lam2_32 + (lam2_12*s4 - 2.0*ww4_yz);
    const stanford_d3_real t3 = c5*lam4_12 + s5*neg_lam4_32;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = neg_ww5_zx + t3;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_z = 0.0203*(qdd[5] - alpha5_y);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_z = neg_lam2_22*q[2] - 9.8*(c2 - 0.015551020408163266*lam2_23) -
        qdd[2];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_x = -9.8*s2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_x = lam2_12*q[2] - a2_x + (0.1524*neg_lam2_13 - t2*qd[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_y = s4*neg_a3_x - c4*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_13 = s4*neg_lam2_32 - lam2_12*c4;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_y = neg_ww4_zx + lam4_13;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_z = alpha4_y + qdd[4];
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a4_x = s4*neg_a3_y + c4*neg_a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = s5*neg_a3_z - c5*neg_a4_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_z = n06_y - (0.0299343144*lam5_12 - 0.0974*alpha5_z) + 0.114912*a5_x;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real neg_fc5_x = 0.114912*lam5_12;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_z = 2.749911*neg_lam2_22 - 6.47*neg_a3_z;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_z = 0.005832*neg_lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_z = s5*neg_fc5_x + fc3_z + fc4_z - c5*fc5_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real neg_fc3_y = 6.47*(neg_a3_y + 0.4250248840803709*neg_lam2_32);
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_x = -0.005832*lam4_12;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real neg_f05_x = s5*fc5_y + c5*neg_fc5_x;
    /* link 4: force through the joint [N] */
    const stanford_d3_real neg_f4_x = neg_f05_x - fc4_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real t4 = c5*neg_lam4_32 - s5*lam4_12;
    const stanford_d3_real t5 = 0.1572686288*(w5_z*neg_w5_y) + 0.0786343144*t4;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_z = 1.4613467527097814*t5;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_y = fc4_y + fc5_z;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_y = c4*f4_y - s4*neg_f4_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real neg_f3_y = neg_fc3_y - f04_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 2.749911*lam2_12 - 6.47*neg_a3_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x - c4*neg_f4_x - s4*f4_y;
    const stanford_d3_real t6 = 0.114912*a4_y + (0.0587314928*t4 - (n06_x - t5));
    const stanford_d3_real t7 = 0.0100314928*t3 + (0.0974*alpha5_y - n06_z);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_z = s5*t6 - c5*t7 - (0.005832*neg_a4_x + 5.36544e-05*lam4_13) -
        0.106*neg_ww4_xy;
    const stanford_d3_real t8 = 5.36544e-05*(neg_lam2_22 - neg_lam4_22) + (s5*t7 -
        0.005832*neg_a3_z) + (c5*t6 + 0.106*ww4_yz);
    const stanford_d3_real t9 = 0.106*alpha4_y + (5.36544e-05*lam4_12 + n5_z);
    const stanford_d3_real t10 = 0.3436532925*lam2_23 - nc3_x + c4*t8 + 5.2810532937*neg_lam2_32 +
        (s4*t9 - 0.1524*f3_z - q[2]*neg_f3_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = s2*t10 - c2*(0.1524*f3_x + (2.203*(alpha2_y +
        0.344006676123468*neg_lam2_13) - n4_z));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_y = 2.749911*neg_a3_x;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_z = c4*t9 - (s4*t8 - (nc3_y - (6.3825532937*lam2_12 - (2.203*ww2_xy +
        q[2]*f3_x))));
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* torques that hold the arm at rest
 * 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine */
void stanford_d3_gravity(const stanford_d3_real q[6], stanford_d3_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_d3_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real hw5_y = -1.1261376*c5;
    /* sines and cosines of the joint angles */
    const stanford_d3_real s2 = sin(q[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s5 = sin(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real hw5_x = 1.1261376*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const stanford_d3_real tau5 = hw5_y*(s2*c4) - c2*hw5_x;
    /* sines and cosines of the joint angles */
    const stanford_d3_real s4 = sin(q[3]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real hw4_y = hw5_x*s4 - 0.0571536*c4;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const stanford_d3_real tau4 = s2*hw4_y;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_d3_real tau3 = 63.406*c2;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real hw4_x = c4*hw5_x + 0.0571536*s4;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real neg_hw3_z = hw5_y + 26.9491278;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_d3_real hw2_x = c2*hw4_x + s2*(63.406*q[2] - neg_hw3_z);
    const stanford_d3_real t1 = -hw2_x;
    tau[0] = 0.0;
    tau[1] = t1;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 110 multiplications, 71 additions = 181; 0 unary minus; 6 sine/cosine */
void stanford_d3_bias(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    stanford_d3_real tau[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_33 = qd[0]*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_x = qd[0]*s2;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww2_zx = neg_w2_x*qd[1];
    const stanford_d3_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_d3_real ww2_xx = neg_w2_x*neg_w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_22 = ww2_xx + ww2_zz;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    const stanford_d3_real w4_z = neg_w2_y + qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww4_zx = neg_w4_x*w4_z;
    const stanford_d3_real neg_ww4_xy = neg_w4_x*w4_y;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_d3_real w5_z = w4_y + qd[4];
    const stanford_d3_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_d3_real ww5_xy = neg_w5_x*neg_w5_y;
    const stanford_d3_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_z = neg_w5_y + qd[5];
    const stanford_d3_real t1 = 0.0203*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_y = neg_w5_x*t1;
    const stanford_d3_real n06_x = w5_z*t1;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    const stanford_d3_real t2 = 2.0*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_32 = neg_w2_y*t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_y = 0.1524*neg_lam2_33 - (neg_lam2_32*q[2] +
        2.0*(neg_w2_x*qd[2]));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = -2.749911*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    const stanford_d3_real lam4_12 = neg_ww2_zx - neg_ww4_xy;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_32 = c4*neg_lam2_32 + (ww2_xy*s4 - 2.0*ww4_yz);
    const stanford_d3_real t3 = c5*lam4_12 + s5*neg_lam4_32;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = neg_ww5_zx + t3;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_z = -0.0203*alpha5_y;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_z = neg_lam2_22*q[2] - 9.8*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_x = -9.8*s2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_x = ww2_xy*q[2] - a2_x - t2*qd[2];
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_y = s4*neg_a3_x - c4*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_13 = s4*neg_lam2_32 - ww2_xy*c4;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_y = neg_ww4_zx + lam4_13;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a4_x = s4*neg_a3_y + c4*neg_a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = s5*neg_a3_z - c5*neg_a4_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_z = n06_y - (0.0299343144*lam5_12 - 0.0974*alpha4_y) + 0.114912*a5_x;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real neg_fc5_x = 0.114912*lam5_12;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_z = 2.749911*neg_lam2_22 - 6.47*neg_a3_z;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_z = 0.005832*neg_lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_z = s5*neg_fc5_x + fc3_z + fc4_z - c5*fc5_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real neg_fc3_y = 6.47*(neg_a3_y + 0.4250248840803709*neg_lam2_32);
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_x = -0.005832*lam4_12;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real neg_f05_x = s5*fc5_y + c5*neg_fc5_x;
    /* link 4: force through the joint [N] */
    const stanford_d3_real neg_f4_x = neg_f05_x - fc4_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real t4 = c5*neg_lam4_32 - s5*lam4_12;
    const stanford_d3_real t5 = 0.1572686288*(w5_z*neg_w5_y) + 0.0786343144*t4;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_z = 1.4613467527097814*t5;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_y = fc4_y + fc5_z;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_y = c4*f4_y - s4*neg_f4_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real neg_f3_y = neg_fc3_y - f04_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 2.749911*ww2_xy - 6.47*neg_a3_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x - c4*neg_f4_x - s4*f4_y;
    const stanford_d3_real t6 = 0.114912*a4_y + (0.0587314928*t4 - (n06_x - t5));
    const stanford_d3_real t7 = 0.0100314928*t3 + 0.1177*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_z = s5*t6 - c5*t7 - (0.005832*neg_a4_x + 5.36544e-05*lam4_13) -
        0.106*neg_ww4_xy;
    const stanford_d3_real t8 = 5.36544e-05*(neg_lam2_22 - neg_lam4_22) + (s5*t7 -
        0.005832*neg_a3_z) + (c5*t6 + 0.106*ww4_yz);
    const stanford_d3_real t9 = 0.106*alpha4_y + (5.36544e-05*lam4_12 + n5_z);
    const stanford_d3_real t10 = c4*t8 - nc3_x + 5.2810532937*neg_lam2_32 + (s4*t9 - 0.1524*f3_z -
        q[2]*neg_f3_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = s2*t10 - c2*(0.1524*f3_x + (2.203*neg_ww2_zx - n4_z));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_y = 2.749911*neg_a3_x;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_z = q[2]*f3_x + (nc3_y + (c4*t9 - s4*t8)) - 4.1795532937*ww2_xy;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 40 multiplications, 32 additions = 72; 2 unary minus; 6 sine/cosine */
void stanford_d3_mass_matrix(const stanford_d3_real q[6], stanford_d3_real M[36])
{
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    const stanford_d3_real s2 = sin(q[1]);
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(q[3]);
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(q[4]);
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu5_y = 0.0203*c5;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h5_x = 0.114912*s5;
    const stanford_d3_real neg_h5_y = 0.114912*c5;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h4_x = c4*h5_x + 0.005832*s4;
    const stanford_d3_real t1 = s4*h5_x;
    const stanford_d3_real neg_h4_y = 0.005832*c4 - t1;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h3_z = neg_h5_y - 2.749911;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_3 = s2*(neg_h4_y - 0.986028);
    const stanford_d3_real t2 = s2*h4_x;
    const stanford_d3_real t3 = h3_z + 6.47*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h2_y = t2 - c2*t3;
    const stanford_d3_real t4 = 0.08384080339738234*c5;
    const stanford_d3_real t5 = neg_h5_y*t4;
    /* link 4: mass matrix, its row of this joint */
    const stanford_d3_real m4_4 = 0.1373658072 - t5;
    const stanford_d3_real t6 = 0.1524*neg_h4_y;
    const stanford_d3_real t7 = m4_4 - t6;
    const stanford_d3_real t8 = s2*s4;
    const stanford_d3_real t9 = s2*h5_x;
    const stanford_d3_real t10 = c4*t9;
    const stanford_d3_real t11 = 5.36544e-05*t8 - (t4*t10 + t2*q[2]);
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_4 = c2*t7 - t11;
    const stanford_d3_real t12 = c4*(t5 - 0.1056028216);
    const stanford_d3_real t13 = 1.1173814928 - c4*t12;
    const stanford_d3_real t14 = q[2]*(h3_z + t3) + (t5 + 5.3929032937);
    const stanford_d3_real t15 = t13 - t14 - t7;
    const stanford_d3_real m1_1 = 1.5954239597 - c2*(t11 - (c2*t15 + m1_4)) - (t6 + t15);
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_4 = neg_h4_y*q[2] - 5.36544e-05*c4 - t1*t4;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_2 = 0.1524*h2_y + c2*m2_4 - t12*t8;
    const stanford_d3_real t16 = neg_h5_y*q[2] + 0.1273343144;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y = t8*t16;
    const stanford_d3_real t17 = c2*neg_h5_y;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x = c4*t17 - t9;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_5 = neg_nu2_y - 0.1524*fu2_x;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_2 = t13 + t14;
    const stanford_d3_real m2_5 = c4*t16;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu4_y = 0.1766569200779727*t1;
    const stanford_d3_real t18 = 0.1766569200779727*(t17 - t10);
    const stanford_d3_real t19 = -h4_x;
    const stanford_d3_real t20 = -h5_x;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = t18;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = t19;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = nu4_y;
    M[12] = m1_3;
    M[13] = t19;
    M[14] = 6.47;
    M[15] = 0.0;
    M[16] = t20;
    M[17] = 0.0;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = 0.0;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = t20;
    M[27] = 0.0;
    M[28] = 0.1273343144;
    M[29] = 0.0;
    M[30] = t18;
    M[31] = nu4_y;
    M[32] = 0.0;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.0203;
}

/* accelerations that the torques tau give
 * 207 multiplications, 150 additions, 4 divisions = 361; 1 unary minus; 6 sine/cosine */
void stanford_d3_forward_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real tau[6],
    stanford_d3_real qdd[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_33 = qd[0]*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_x = qd[0]*s2;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_d3_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww2_zx = neg_w2_x*qd[1];
    const stanford_d3_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_d3_real ww2_xx = neg_w2_x*neg_w2_x;
    const stanford_d3_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_22 = ww2_xx + ww2_zz;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c4 = cos(q[3]);
    const stanford_d3_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_d3_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_d3_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    const stanford_d3_real w4_z = neg_w2_y + qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww4_zx = neg_w4_x*w4_z;
    const stanford_d3_real neg_ww4_xy = neg_w4_x*w4_y;
    /* sines and cosines of the joint angles */
    const stanford_d3_real c5 = cos(q[4]);
    const stanford_d3_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_d3_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_d3_real w5_z = w4_y + qd[4];
    const stanford_d3_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_d3_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_d3_real ww5_xy = neg_w5_x*neg_w5_y;
    const stanford_d3_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_d3_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_d3_real w6_z = neg_w5_y + qd[5];
    const stanford_d3_real t1 = 0.0203*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_y = neg_w5_x*t1;
    const stanford_d3_real n06_x = w5_z*t1;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_y = 0.114912*neg_lam5_22;
    const stanford_d3_real t2 = 2.0*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam2_32 = neg_w2_y*t2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_y = 0.1524*neg_lam2_33 - (neg_lam2_32*q[2] +
        2.0*(neg_w2_x*qd[2]));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_x = -2.749911*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    const stanford_d3_real lam4_12 = neg_ww2_zx - neg_ww4_xy;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_d3_real ww4_yz = w4_y*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real neg_lam4_32 = c4*neg_lam2_32 + (ww2_xy*s4 - 2.0*ww4_yz);
    const stanford_d3_real t3 = c5*lam4_12 + s5*neg_lam4_32;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha5_y = neg_ww5_zx + t3;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_d3_real n06_z = -0.0203*alpha5_y;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_z = neg_lam2_22*q[2] - 9.8*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a2_x = -9.8*s2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a3_x = ww2_xy*q[2] - a2_x - t2*qd[2];
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a4_y = s4*neg_a3_x - c4*neg_a3_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam4_13 = s4*neg_lam2_32 - ww2_xy*c4;
    /* link 4: angular acceleration [rad/s^2] */
    const stanford_d3_real alpha4_y = neg_ww4_zx + lam4_13;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_d3_real lam5_12 = ww5_xy - alpha4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real neg_a4_x = s4*neg_a3_y + c4*neg_a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_d3_real a5_x = s5*neg_a3_z - c5*neg_a4_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n5_z = n06_y - (0.0299343144*lam5_12 - 0.0974*alpha4_y) + 0.114912*a5_x;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real neg_fc5_x = 0.114912*lam5_12;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_z = 2.749911*neg_lam2_22 - 6.47*neg_a3_z;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_z = 0.005832*neg_lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_z = fc4_z + (fc3_z + s5*neg_fc5_x) - c5*fc5_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real neg_fc3_y = 6.47*(neg_a3_y + 0.4250248840803709*neg_lam2_32);
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_x = -0.005832*lam4_12;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real neg_f05_x = s5*fc5_y + c5*neg_fc5_x;
    /* link 4: force through the joint [N] */
    const stanford_d3_real neg_f4_x = neg_f05_x - fc4_x;
    /* link 4: force that moves the link [N] */
    const stanford_d3_real fc4_y = 0.005832*neg_lam4_22;
    const stanford_d3_real t4 = c5*neg_lam4_32 - s5*lam4_12;
    const stanford_d3_real t5 = 0.1572686288*(w5_z*neg_w5_y) + 0.0786343144*t4;
    /* link 5: force that moves the link [N] */
    const stanford_d3_real fc5_z = 1.4613467527097814*t5;
    /* link 4: force through the joint [N] */
    const stanford_d3_real f4_y = fc4_y + fc5_z;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const stanford_d3_real f04_y = c4*f4_y - s4*neg_f4_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real neg_f3_y = neg_fc3_y - f04_y;
    /* link 3: force that moves the link [N] */
    const stanford_d3_real fc3_x = 2.749911*ww2_xy - 6.47*neg_a3_x;
    /* link 3: force through the joint [N] */
    const stanford_d3_real f3_x = fc3_x - c4*neg_f4_x - s4*f4_y;
    const stanford_d3_real t6 = 0.114912*a4_y + (0.0587314928*t4 - (n06_x - t5));
    const stanford_d3_real t7 = 0.0100314928*t3 + 0.1177*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n4_z = s5*t6 - c5*t7 - (0.005832*neg_a4_x + 5.36544e-05*lam4_13) -
        0.106*neg_ww4_xy;
    const stanford_d3_real t8 = 5.36544e-05*(neg_lam2_22 - neg_lam4_22) + (s5*t7 -
        0.005832*neg_a3_z) + (c5*t6 + 0.106*ww4_yz);
    const stanford_d3_real t9 = 0.106*alpha4_y + (n5_z + 5.36544e-05*lam4_12);
    const stanford_d3_real t10 = c4*t8 - nc3_x + 5.2810532937*neg_lam2_32 + (s4*t9 - 0.1524*f3_z -
        q[2]*neg_f3_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n1_z = s2*t10 - c2*(0.1524*f3_x - (n4_z - 2.203*neg_ww2_zx));
    /* link 3: moment that turns the link [N m] */
    const stanford_d3_real nc3_y = 2.749911*neg_a3_x;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_d3_real n2_z = q[2]*f3_x + (nc3_y + (c4*t9 - s4*t8)) - 4.1795532937*ww2_xy;
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu5_y = 0.0203*c5;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h5_x = 0.114912*s5;
    const stanford_d3_real neg_h5_y = 0.114912*c5;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h4_x = c4*h5_x + 0.005832*s4;
    const stanford_d3_real t11 = s4*h5_x;
    const stanford_d3_real neg_h4_y = 0.005832*c4 - t11;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h3_z = neg_h5_y - 2.749911;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_3 = s2*(neg_h4_y - 0.986028);
    const stanford_d3_real t12 = s2*h4_x;
    const stanford_d3_real t13 = h3_z + 6.47*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_d3_real h2_y = t12 - c2*t13;
    const stanford_d3_real t14 = 0.08384080339738234*c5;
    const stanford_d3_real t15 = neg_h5_y*t14;
    /* link 4: mass matrix, its row of this joint */
    const stanford_d3_real m4_4 = 0.1373658072 - t15;
    const stanford_d3_real t16 = 0.1524*neg_h4_y;
    const stanford_d3_real t17 = t16 - m4_4;
    const stanford_d3_real t18 = s2*s4;
    const stanford_d3_real t19 = s2*h5_x;
    const stanford_d3_real t20 = c4*t19;
    const stanford_d3_real t21 = 5.36544e-05*t18 - (t14*t20 + q[2]*t12);
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real neg_m1_4 = c2*t17 + t21;
    const stanford_d3_real t22 = c4*(t15 - 0.1056028216);
    const stanford_d3_real t23 = c4*t22 - 1.1173814928;
    const stanford_d3_real t24 = q[2]*(h3_z + t13) + (t15 + 5.3929032937);
    const stanford_d3_real t25 = t17 - (t23 + t24);
    const stanford_d3_real neg_m1_1 = c2*(t21 + (neg_m1_4 - c2*t25)) - 1.5954239597 + (t16 + t25);
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_4 = q[2]*neg_h4_y - 5.36544e-05*c4 - t11*t14;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_2 = 0.1524*h2_y + c2*m2_4 - t18*t22;
    const stanford_d3_real t26 = q[2]*neg_h5_y + 0.1273343144;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_d3_real neg_nu2_y = t18*t26;
    const stanford_d3_real t27 = c2*neg_h5_y;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_d3_real fu2_x = c4*t27 - t19;
    /* link 1: mass matrix, its row of this joint */
    const stanford_d3_real m1_5 = neg_nu2_y - 0.1524*fu2_x;
    /* link 2: mass matrix, its row of this joint */
    const stanford_d3_real m2_2 = t24 - t23;
    const stanford_d3_real m2_5 = c4*t26;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_d3_real nu4_y = 0.1766569200779727*t11;
    const stanford_d3_real t28 = t20 - t27;
    /* factorisation M = U D U^T */
    const stanford_d3_real neg_ud1_6 = 0.1766569200779727*t28;
    /* link 5: forward substitution */
    const stanford_d3_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const stanford_d3_real y6 = tau[5] - n06_z;
    /* factorisation M = U D U^T */
    const stanford_d3_real u2_6 = 8.70231133389028*t11;
    const stanford_d3_real neg_u1_6 = 8.70231133389028*t28;
    const stanford_d3_real neg_u3_5 = 0.9024433087142769*s5;
    const stanford_d3_real u2_5 = 7.853342633617698*m2_5;
    const stanford_d3_real u1_5 = 7.853342633617698*m1_5;
    const stanford_d3_real neg_pivot4 = c5*neg_nu5_y - m4_4;
    const stanford_d3_real neg_ipivot4 = 1.0 / neg_pivot4;
    const stanford_d3_real ud2_4 = m2_4 - neg_nu5_y*u2_6;
    const stanford_d3_real neg_u2_4 = neg_ipivot4*ud2_4;
    const stanford_d3_real neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6;
    const stanford_d3_real u1_4 = neg_ipivot4*neg_ud1_4;
    const stanford_d3_real neg_pivot3 = h5_x*neg_u3_5 - 6.47;
    const stanford_d3_real neg_ipivot3 = 1.0 / neg_pivot3;
    const stanford_d3_real neg_ud2_3 = h4_x - h5_x*u2_5;
    const stanford_d3_real u2_3 = neg_ipivot3*neg_ud2_3;
    const stanford_d3_real ud1_3 = m1_3 + h5_x*u1_5;
    const stanford_d3_real neg_u1_3 = neg_ipivot3*ud1_3;
    const stanford_d3_real neg_pivot2 = nu4_y*u2_6 - m2_2 + m2_5*u2_5 - ud2_4*neg_u2_4 -
        neg_ud2_3*u2_3;
    const stanford_d3_real neg_ipivot2 = 1.0 / neg_pivot2;
    const stanford_d3_real ud1_2 = m1_2 + nu4_y*neg_u1_6 - m2_5*u1_5 - ud2_4*u1_4 -
        neg_ud2_3*neg_u1_3;
    const stanford_d3_real neg_u1_2 = neg_ipivot2*ud1_2;
    const stanford_d3_real neg_pivot1 = neg_m1_1 + neg_ud1_6*neg_u1_6 + m1_5*u1_5 - neg_ud1_4*u1_4 -
        ud1_3*neg_u1_3 - ud1_2*neg_u1_2;
    const stanford_d3_real neg_ipivot1 = 1.0 / neg_pivot1;
    /* link 4: forward substitution */
    const stanford_d3_real neg_y4 = n4_z - tau[3] + c5*y6;
    /* link 3: forward substitution */
    const stanford_d3_real neg_y3 = f3_z - tau[2] + neg_y5*neg_u3_5;
    /* link 2: forward substitution */
    const stanford_d3_real neg_y2 = n2_z - tau[1] + y6*u2_6 - neg_y5*u2_5 + neg_u2_4*neg_y4 -
        u2_3*neg_y3;
    /* link 1: forward substitution */
    const stanford_d3_real neg_y1 = n1_z - tau[0] - y6*neg_u1_6 - neg_y5*u1_5 - u1_4*neg_y4 +
        neg_u1_3*neg_y3 + neg_u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd1 = neg_ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd2 = neg_ipivot2*neg_y2 + neg_u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 + neg_u1_3*qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd4 = neg_ipivot4*neg_y4 + neg_u2_4*qdd2 - u1_4*qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd5 = -u1_5*qdd1 - (7.853342633617698*neg_y5 - neg_u3_5*qdd3 +
        u2_5*qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_d3_real qdd6 = 49.26108374384236*y6 - c5*qdd4 - u2_6*qdd2 + neg_u1_6*qdd1;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
