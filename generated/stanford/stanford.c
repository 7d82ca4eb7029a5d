/*
 * stanford: Stanford arm, six joints
 * Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; Izz of link 3 assumed
 * Origin of numbers: geometry, mass, centre of mass, inertia, rotor inertia: stated by the
 *     description
 * Origin of numbers: friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: de26546409d6162d87592b49cbe31f58 (a hash of its numbers)
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
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 0.953 kg m^2, joint 2 2.193 kg m^2, joint 3 0.782 kg, joint 4 0.106 kg
 *     m^2, joint 5 0.097 kg m^2, joint 6 0.02 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 114 multiplications, 87 additions = 201; 6 unary minus; 6 sine/cosine
 *   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
 *   bias: 104 multiplications, 70 additions = 174; 0 unary minus; 6 sine/cosine
 *   mass_matrix: 41 multiplications, 32 additions = 73; 2 unary minus; 6 sine/cosine
 *   forward_dynamics: 201 multiplications, 149 additions, 4 divisions = 354; 2 unary minus; 6
 *       sine/cosine
 */
#include "stanford.h"

#include <math.h>

/* torques that give the accelerations qdd
 * with rotor inertia
 * 114 multiplications, 87 additions = 201; 6 unary minus; 6 sine/cosine */
void stanford_inverse_dynamics(
    const stanford_real q[6],
    const stanford_real qd[6],
    const stanford_real qdd[6],
    stanford_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real w2_x = -s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real w2_y = -qd[0]*c2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_13 = -c2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_real ww2_zx = w2_x*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_real alpha2_y = lam2_13 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_real ww2_yz = w2_y*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_23 = s2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_real ww2_xy = w2_x*w2_y;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a2_x = 9.8*s2;
    const stanford_real neg_a2_y = 9.8*c2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_12 = ww2_xy - qdd[1];
    /* sines and cosines of the joint angles */
    const stanford_real c4 = cos(q[3]);
    const stanford_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_real w4_x = w2_x*c4 + qd[1]*s4;
    const stanford_real w4_y = qd[1]*c4 - w2_x*s4;
    const stanford_real w4_z = qd[3] - w2_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_real ww4_yz = w4_y*w4_z;
    const stanford_real ww4_xy = w4_x*w4_y;
    const stanford_real ww4_zz = w4_z*w4_z;
    /* sines and cosines of the joint angles */
    const stanford_real c5 = cos(q[4]);
    const stanford_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_real w5_x = w4_x*c5 - w4_z*s5;
    const stanford_real w5_z = w4_y + qd[4];
    const stanford_real neg_w5_y = w4_z*c5 + w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_real ww5_zx = w5_x*w5_z;
    const stanford_real ww5_xy = -w5_x*neg_w5_y;
    const stanford_real ww5_xx = w5_x*w5_x;
    const stanford_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam5_22 = -ww5_xx - ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_real w6_z = neg_w5_y + qd[5];
    const stanford_real t1 = 0.0003*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real neg_n06_y = w5_x*t1;
    const stanford_real n06_x = w5_z*t1;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_32 = 2.0*ww2_yz - lam2_23;
    /* link 2: moment that turns the link [N m] */
    const stanford_real nc2_x = 4.2875532937*lam2_32;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam4_12 = alpha2_y + ww4_xy - qdd[3];
    const stanford_real lam4_32 = ww4_yz + c4*lam2_32 + (ww4_yz - lam2_12*s4);
    const stanford_real t2 = w5_z*neg_w5_y;
    const stanford_real t3 = t2 - s5*lam4_12 - c5*lam4_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam5_32 = t2 + t3;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    /* link 4: force through the joint [N] */
    const stanford_real f4_y = 0.005832*(neg_lam4_22 + 19.703703703703702*neg_lam5_32);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam4_13 = lam2_12*c4 + s4*lam2_32;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_z = qdd[4] - neg_lam4_13 - w4_x*w4_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: force that moves the link [N] */
    const stanford_real neg_fc4_x = 0.005832*lam4_12;
    const stanford_real t4 = 0.114912*s5;
    const stanford_real t5 = 0.114912*c5;
    /* link 4: force through the joint [N] */
    const stanford_real f4_x = lam5_22*t4 - neg_fc4_x - lam5_12*t5;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_33 = qd[0]*qd[0];
    const stanford_real t6 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_y = -lam2_32*q[2] - w2_x*t6 - 0.1524*neg_lam2_33;
    /* link 3: force that moves the link [N] */
    const stanford_real fc3_y = 6.47*(a3_y - 0.4219534775888717*lam2_32);
    /* link 3: force through the joint [N] */
    const stanford_real f3_y = c4*f4_y + (fc3_y + s4*f4_x);
    const stanford_real t7 = ww4_zz - w4_y*w4_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_22 = t7 - neg_lam4_22;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_z = neg_a2_y + (q[2]*lam2_22 - (0.1524*lam2_23 - qdd[2]));
    /* link 4: force that moves the link [N] */
    const stanford_real neg_fc4_z = 0.005832*lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_real f3_z = 6.47*a3_z + lam5_12*t4 - (neg_fc4_z + (-2.730039*lam2_22 -
        lam5_22*t5));
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_x = 0.1524*lam2_13 + (qd[1]*t6 - lam2_12*q[2] - neg_a2_x);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a4_y = c4*a3_y - s4*a3_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_y = c5*lam4_12 - s5*lam4_32 - ww5_zx;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real neg_n06_z = 0.0003*(alpha5_y - qdd[5]);
    const stanford_real t8 = n06_x - (0.0289028216*t2 + 0.114912*a4_y + 0.0313658072*t3);
    const stanford_real t9 = -0.0010314928*ww5_zx - (neg_n06_z + 0.0014314928*alpha5_y);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_x = 5.36544e-05*t7 - (0.005832*a3_z - c5*t8) + s5*t9;
    /* link 4: moment that turns the link [N m] */
    const stanford_real nc4_y = 5.36544e-05*lam4_12;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a4_x = c4*a3_x + s4*a3_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_real n5_z = t5*a4_x - neg_n06_y - (t4*a3_z + 0.0299343144*(lam5_12 -
        0.013362590993565565*alpha5_z));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_y = nc4_y + n5_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real n2_x = nc2_x - q[2]*f3_y - (2.730039*(a3_y - 0.055823378347342294*f3_z) -
        c4*n4_x + s4*n4_y);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_z = 5.36544e-05*neg_lam4_13 + 0.005832*a4_x + c5*t9 - s5*t8;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam2_31 = ww2_zx - alpha2_y;
    /* link 2: moment that turns the link [N m] */
    const stanford_real neg_nc2_y = 0.008*lam2_31;
    /* link 3: force through the joint [N] */
    const stanford_real f3_x = c4*f4_x + 6.47*a3_x - s4*f4_y - 2.730039*lam2_12;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real n2_y = 0.1524*f3_x - neg_nc2_y - n4_z;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau1 = 1.4431532925*qdd[0] - s2*n2_x - c2*n2_y;
    /* link 3: moment that turns the link [N m] */
    const stanford_real nc3_y = 2.730039*a3_x;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau2 = s4*n4_x + (6.4885532937*qdd[1] + c4*n4_y) - (4.2795532937*ww2_xy -
        q[2]*f3_x - nc3_y);
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau3 = f3_z + 0.782*qdd[2];
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau4 = n4_z + 0.106*qdd[3];
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau5 = n5_z + 0.097*qdd[4];
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau6 = 0.02*qdd[5] - neg_n06_z;
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques that hold the arm at rest
 * 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine */
void stanford_gravity(const stanford_real q[6], stanford_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw5_y = -1.1261376*c5;
    /* sines and cosines of the joint angles */
    const stanford_real s2 = sin(q[1]);
    const stanford_real c4 = cos(q[3]);
    const stanford_real c2 = cos(q[1]);
    const stanford_real s5 = sin(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw5_x = 1.1261376*s5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau5 = hw5_y*(s2*c4) - c2*hw5_x;
    /* sines and cosines of the joint angles */
    const stanford_real s4 = sin(q[3]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw4_y = hw5_x*s4 - 0.0571536*c4;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau4 = s2*hw4_y;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau3 = 63.406*c2;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw4_x = c4*hw5_x + 0.0571536*s4;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw3_z = 26.7543822 - hw5_y;
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const stanford_real hw2_x = c2*hw4_x + s2*(hw3_z + 63.406*q[2]);
    const stanford_real t1 = -hw2_x;
    tau[0] = 0.0;
    tau[1] = t1;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 104 multiplications, 70 additions = 174; 0 unary minus; 6 sine/cosine */
void stanford_bias(const stanford_real q[6], const stanford_real qd[6], stanford_real tau[6])
{
    /* sines and cosines of the joint angles */
    const stanford_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_real neg_ww2_zx = neg_w2_x*qd[1];
    const stanford_real neg_ww2_yz = neg_w2_y*qd[1];
    const stanford_real ww2_xy = neg_w2_x*neg_w2_y;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a2_x = 9.8*s2;
    const stanford_real neg_a2_y = 9.8*c2;
    /* sines and cosines of the joint angles */
    const stanford_real c4 = cos(q[3]);
    const stanford_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    const stanford_real w4_z = neg_w2_y + qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_real ww4_yz = w4_y*w4_z;
    const stanford_real neg_ww4_xy = neg_w4_x*w4_y;
    const stanford_real ww4_zz = w4_z*w4_z;
    /* sines and cosines of the joint angles */
    const stanford_real c5 = cos(q[4]);
    const stanford_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_real w5_z = w4_y + qd[4];
    const stanford_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_real ww5_xy = neg_w5_x*neg_w5_y;
    const stanford_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_real w6_z = neg_w5_y + qd[5];
    const stanford_real t1 = 0.0003*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real n06_y = neg_w5_x*t1;
    const stanford_real n06_x = w5_z*t1;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_32 = 2.0*neg_ww2_yz;
    /* link 2: moment that turns the link [N m] */
    const stanford_real nc2_x = -8.5751065874*neg_ww2_yz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam4_12 = neg_ww2_zx - neg_ww4_xy;
    const stanford_real lam4_32 = ww4_yz - c4*neg_lam2_32 + (ww4_yz - ww2_xy*s4);
    const stanford_real t2 = w5_z*neg_w5_y;
    const stanford_real t3 = t2 - s5*lam4_12 - c5*lam4_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam5_32 = t2 + t3;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    /* link 4: force through the joint [N] */
    const stanford_real f4_y = 0.005832*(neg_lam4_22 + 19.703703703703702*neg_lam5_32);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam4_13 = s4*neg_lam2_32 - ww2_xy*c4;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_z = lam4_13 + neg_w4_x*w4_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: force that moves the link [N] */
    const stanford_real fc4_x = -0.005832*lam4_12;
    const stanford_real t4 = 0.114912*c5;
    const stanford_real t5 = 0.114912*s5;
    /* link 4: force through the joint [N] */
    const stanford_real neg_f4_x = lam5_12*t4 + (neg_lam5_22*t5 - fc4_x);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_33 = qd[0]*qd[0];
    const stanford_real t6 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_y = neg_w2_x*t6 + neg_lam2_32*q[2] - 0.1524*neg_lam2_33;
    /* link 3: force that moves the link [N] */
    const stanford_real fc3_y = 6.47*(a3_y + 0.8439069551777434*neg_ww2_yz);
    /* link 3: force through the joint [N] */
    const stanford_real f3_y = c4*f4_y + (fc3_y - s4*neg_f4_x);
    const stanford_real t7 = ww4_zz - w4_y*w4_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_22 = neg_lam4_22 - t7;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_z = neg_a2_y - q[2]*neg_lam2_22;
    /* link 4: force that moves the link [N] */
    const stanford_real fc4_z = -0.005832*lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_real f3_z = 6.47*a3_z + lam5_12*t5 - (2.730039*neg_lam2_22 + neg_lam5_22*t4 -
        fc4_z);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a3_x = neg_a2_x - (qd[1]*t6 - ww2_xy*q[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a4_y = c4*a3_y + s4*neg_a3_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_y = neg_ww5_zx + (c5*lam4_12 - s5*lam4_32);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real n06_z = -0.0003*alpha5_y;
    const stanford_real t8 = n06_x - (0.0289028216*t2 + 0.114912*a4_y + 0.0313658072*t3);
    const stanford_real t9 = 0.0010314928*neg_ww5_zx - 0.0017314928*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_x = 5.36544e-05*t7 - (0.005832*a3_z - c5*t8) + s5*t9;
    /* link 4: moment that turns the link [N m] */
    const stanford_real nc4_y = 5.36544e-05*lam4_12;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a4_x = c4*neg_a3_x - s4*a3_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_real n5_z = n06_y - t4*neg_a4_x - (t5*a3_z + 0.0299343144*(lam5_12 -
        0.013362590993565565*alpha5_z));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_y = nc4_y + n5_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real neg_n2_x = q[2]*f3_y - nc2_x + (2.730039*(a3_y - 0.055823378347342294*f3_z)
        - c4*n4_x + s4*n4_y);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_z = -5.36544e-05*lam4_13 - 0.005832*neg_a4_x + c5*t9 - s5*t8;
    /* link 2: moment that turns the link [N m] */
    const stanford_real nc2_y = 0.016*neg_ww2_zx;
    /* link 3: force through the joint [N] */
    const stanford_real neg_f3_x = 2.730039*ww2_xy + (s4*f4_y + (c4*neg_f4_x + 6.47*neg_a3_x));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real neg_n2_y = n4_z - (nc2_y - 0.1524*neg_f3_x);
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau1 = s2*neg_n2_x + c2*neg_n2_y;
    /* link 3: moment that turns the link [N m] */
    const stanford_real nc3_y = -2.730039*neg_a3_x;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau2 = s4*n4_x + c4*n4_y - (4.2795532937*ww2_xy + q[2]*neg_f3_x - nc3_y);
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = f3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 41 multiplications, 32 additions = 73; 2 unary minus; 6 sine/cosine */
void stanford_mass_matrix(const stanford_real q[6], stanford_real M[36])
{
    /* sines and cosines of the joint angles */
    const stanford_real c2 = cos(q[1]);
    const stanford_real s2 = sin(q[1]);
    const stanford_real c4 = cos(q[3]);
    const stanford_real s4 = sin(q[3]);
    const stanford_real c5 = cos(q[4]);
    const stanford_real s5 = sin(q[4]);
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_real neg_nu5_y = 0.0003*c5;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h5_x = 0.114912*s5;
    const stanford_real neg_h5_y = 0.114912*c5;
    const stanford_real t1 = c4*h5_x;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h4_x = t1 + 0.005832*s4;
    const stanford_real t2 = s4*h5_x;
    const stanford_real neg_h4_y = 0.005832*c4 - t2;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h3_z = neg_h5_y + 2.730039;
    const stanford_real t3 = neg_h4_y - 0.986028;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_3 = s2*t3;
    const stanford_real t4 = s2*h4_x;
    const stanford_real t5 = h3_z + 6.47*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h2_y = t4 - c2*t5;
    const stanford_real t6 = 0.257887030075188*c5;
    const stanford_real t7 = neg_h5_y*t6;
    const stanford_real t8 = t7 + 4.2785218009 + q[2]*(h3_z + t5);
    const stanford_real t9 = c4*(t7 - 0.0286028216);
    const stanford_real t10 = c4*t9;
    const stanford_real t11 = 0.1524*t3;
    const stanford_real t12 = s2*s4;
    const stanford_real t13 = s2*t1;
    const stanford_real t14 = t4*q[2] - (5.36544e-05*t12 - t6*t13);
    const stanford_real t15 = c2*t14;
    const stanford_real t16 = t11 + (t7 + 0.11890486);
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_1 = (t8 + t10)*(s2*s2) - (t11 - (t15 + (t15 + 1.4511532925))) - t16;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_real k4_yz = 5.36544e-05*c4 + t2*t6;
    /* link 2: mass matrix, its row of this joint */
    const stanford_real m2_4 = neg_h4_y*q[2] - k4_yz;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_2 = c2*m2_4 + (0.1524*h2_y - t9*t12);
    const stanford_real m1_4 = t14 - c2*t16;
    const stanford_real t17 = neg_h5_y*q[2] + 0.0303343144;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_real neg_nu2_y = t12*t17;
    const stanford_real t18 = t13 - c2*neg_h5_y;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_real neg_fu2_x = c4*t18 + t2*t12;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_5 = neg_nu2_y + 0.1524*neg_fu2_x;
    /* link 2: mass matrix, its row of this joint */
    const stanford_real m2_2 = t8 + 2.2117629856 - t10;
    const stanford_real m2_5 = c4*t17;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_real nu4_y = 0.0026106934001670842*t2;
    /* link 4: mass matrix, its row of this joint */
    const stanford_real m4_4 = 0.1373658072 - t7;
    const stanford_real t19 = -0.0026106934001670842*t18;
    const stanford_real t20 = -h4_x;
    const stanford_real t21 = -h5_x;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = t19;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = t20;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = nu4_y;
    M[12] = m1_3;
    M[13] = t20;
    M[14] = 7.252;
    M[15] = 0.0;
    M[16] = t21;
    M[17] = 0.0;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = 0.0;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = t21;
    M[27] = 0.0;
    M[28] = 0.1273343144;
    M[29] = 0.0;
    M[30] = t19;
    M[31] = nu4_y;
    M[32] = 0.0;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.0203;
}

/* accelerations that the torques tau give
 * with rotor inertia
 * 201 multiplications, 149 additions, 4 divisions = 354; 2 unary minus; 6 sine/cosine */
void stanford_forward_dynamics(
    const stanford_real q[6],
    const stanford_real qd[6],
    const stanford_real tau[6],
    stanford_real qdd[6])
{
    /* sines and cosines of the joint angles */
    const stanford_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real neg_w2_x = s2*qd[0];
    /* sines and cosines of the joint angles */
    const stanford_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_real neg_w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_real neg_ww2_zx = neg_w2_x*qd[1];
    const stanford_real neg_ww2_yz = neg_w2_y*qd[1];
    const stanford_real ww2_xy = neg_w2_x*neg_w2_y;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a2_x = 9.8*s2;
    const stanford_real neg_a2_y = 9.8*c2;
    /* sines and cosines of the joint angles */
    const stanford_real c4 = cos(q[3]);
    const stanford_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const stanford_real neg_w4_x = neg_w2_x*c4 - qd[1]*s4;
    const stanford_real w4_y = qd[1]*c4 + neg_w2_x*s4;
    const stanford_real w4_z = neg_w2_y + qd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const stanford_real ww4_yz = w4_y*w4_z;
    const stanford_real neg_ww4_xy = neg_w4_x*w4_y;
    const stanford_real ww4_zz = w4_z*w4_z;
    /* sines and cosines of the joint angles */
    const stanford_real c5 = cos(q[4]);
    const stanford_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const stanford_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const stanford_real w5_z = w4_y + qd[4];
    const stanford_real neg_w5_y = w4_z*c5 - neg_w4_x*s5;
    /* link 5: products of the angular velocity [1/s^2] */
    const stanford_real neg_ww5_zx = neg_w5_x*w5_z;
    const stanford_real ww5_xy = neg_w5_x*neg_w5_y;
    const stanford_real ww5_xx = neg_w5_x*neg_w5_x;
    const stanford_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const stanford_real w6_z = neg_w5_y + qd[5];
    const stanford_real t1 = 0.0003*w6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real n06_y = neg_w5_x*t1;
    const stanford_real n06_x = w5_z*t1;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_32 = 2.0*neg_ww2_yz;
    /* link 2: moment that turns the link [N m] */
    const stanford_real nc2_x = -8.5751065874*neg_ww2_yz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam4_12 = neg_ww2_zx - neg_ww4_xy;
    const stanford_real lam4_32 = ww4_yz - c4*neg_lam2_32 + (ww4_yz - ww2_xy*s4);
    const stanford_real t2 = w5_z*neg_w5_y;
    const stanford_real t3 = t2 - s5*lam4_12 - c5*lam4_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam5_32 = t2 + t3;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y;
    /* link 4: force through the joint [N] */
    const stanford_real f4_y = 0.005832*(neg_lam4_22 + 19.703703703703702*neg_lam5_32);
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam4_13 = s4*neg_lam2_32 - ww2_xy*c4;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_z = lam4_13 + neg_w4_x*w4_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real lam5_12 = ww5_xy - alpha5_z;
    /* link 4: force that moves the link [N] */
    const stanford_real fc4_x = -0.005832*lam4_12;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real neg_h5_y = 0.114912*c5;
    const stanford_real h5_x = 0.114912*s5;
    /* link 4: force through the joint [N] */
    const stanford_real neg_f4_x = lam5_12*neg_h5_y + (neg_lam5_22*h5_x - fc4_x);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_33 = qd[0]*qd[0];
    const stanford_real t4 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_y = neg_w2_x*t4 + neg_lam2_32*q[2] - 0.1524*neg_lam2_33;
    /* link 3: force that moves the link [N] */
    const stanford_real fc3_y = 6.47*(a3_y + 0.8439069551777434*neg_ww2_yz);
    /* link 3: force through the joint [N] */
    const stanford_real f3_y = c4*f4_y + (fc3_y - s4*neg_f4_x);
    const stanford_real t5 = ww4_zz - w4_y*w4_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_real neg_lam2_22 = neg_lam4_22 - t5;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a3_z = neg_a2_y - q[2]*neg_lam2_22;
    /* link 4: force that moves the link [N] */
    const stanford_real fc4_z = -0.005832*lam4_32;
    /* link 3: force through the joint [N] */
    const stanford_real f3_z = 6.47*a3_z + lam5_12*h5_x - (2.730039*neg_lam2_22 +
        neg_lam5_22*neg_h5_y - fc4_z);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a3_x = neg_a2_x - (qd[1]*t4 - ww2_xy*q[2]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real a4_y = c4*a3_y + s4*neg_a3_x;
    /* link 5: angular acceleration [rad/s^2] */
    const stanford_real alpha5_y = neg_ww5_zx + (c5*lam4_12 - s5*lam4_32);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_real n06_z = -0.0003*alpha5_y;
    const stanford_real t6 = n06_x - (0.0289028216*t2 + 0.114912*a4_y + 0.0313658072*t3);
    const stanford_real t7 = 0.0010314928*neg_ww5_zx - 0.0017314928*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_x = 5.36544e-05*t5 - (0.005832*a3_z - c5*t6) + s5*t7;
    /* link 4: moment that turns the link [N m] */
    const stanford_real nc4_y = 5.36544e-05*lam4_12;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_real neg_a4_x = c4*neg_a3_x - s4*a3_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const stanford_real n5_z = n06_y - neg_h5_y*neg_a4_x - (h5_x*a3_z + 0.0299343144*(lam5_12 -
        0.013362590993565565*alpha5_z));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real n4_y = nc4_y + n5_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real neg_n2_x = q[2]*f3_y - nc2_x + (2.730039*(a3_y - 0.055823378347342294*f3_z)
        - c4*n4_x + s4*n4_y);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const stanford_real neg_n4_z = 5.36544e-05*lam4_13 + 0.005832*neg_a4_x - c5*t7 + s5*t6;
    /* link 2: moment that turns the link [N m] */
    const stanford_real nc2_y = 0.016*neg_ww2_zx;
    /* link 3: force through the joint [N] */
    const stanford_real neg_f3_x = 2.730039*ww2_xy + (s4*f4_y + (c4*neg_f4_x + 6.47*neg_a3_x));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_real n2_y = neg_n4_z + (nc2_y - 0.1524*neg_f3_x);
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau1 = s2*neg_n2_x - c2*n2_y;
    /* link 3: moment that turns the link [N m] */
    const stanford_real nc3_y = -2.730039*neg_a3_x;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_real tau2 = s4*n4_x + c4*n4_y - (4.2795532937*ww2_xy + q[2]*neg_f3_x - nc3_y);
    /* link 5: moment for a unit acceleration of a joint further out */
    const stanford_real neg_nu5_y = 0.0003*c5;
    const stanford_real t8 = c4*h5_x;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h4_x = t8 + 0.005832*s4;
    const stanford_real t9 = s4*h5_x;
    const stanford_real neg_h4_y = 0.005832*c4 - t9;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h3_z = neg_h5_y + 2.730039;
    const stanford_real t10 = neg_h4_y - 0.986028;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_3 = s2*t10;
    const stanford_real t11 = s2*h4_x;
    const stanford_real t12 = h3_z + 6.47*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_real h2_y = t11 - c2*t12;
    const stanford_real t13 = 0.257887030075188*c5;
    const stanford_real t14 = neg_h5_y*t13;
    const stanford_real t15 = t14 + 4.2785218009 + q[2]*(h3_z + t12);
    const stanford_real t16 = c4*(t14 - 0.0286028216);
    const stanford_real t17 = c4*t16;
    const stanford_real t18 = 0.1524*t10;
    const stanford_real t19 = s2*s4;
    const stanford_real t20 = s2*t8;
    const stanford_real t21 = q[2]*t11 - (5.36544e-05*t19 - t13*t20);
    const stanford_real t22 = c2*t21;
    const stanford_real t23 = t18 + (t14 + 0.11890486);
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_1 = (t15 + t17)*(s2*s2) - (t18 - (t22 + (t22 + 1.4511532925))) - t23;
    /* link 4: second moment of the composite body [kg m^2] */
    const stanford_real k4_yz = 5.36544e-05*c4 + t9*t13;
    /* link 2: mass matrix, its row of this joint */
    const stanford_real neg_m2_4 = k4_yz - q[2]*neg_h4_y;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real neg_m1_2 = c2*neg_m2_4 - (0.1524*h2_y - t16*t19);
    const stanford_real m1_4 = t21 - c2*t23;
    const stanford_real t24 = neg_h5_y*q[2] + 0.0303343144;
    /* link 2: moment for a unit acceleration of a joint further out */
    const stanford_real neg_nu2_y = t19*t24;
    const stanford_real t25 = t20 - c2*neg_h5_y;
    /* link 2: force for a unit acceleration of a joint further out */
    const stanford_real neg_fu2_x = c4*t25 + t9*t19;
    /* link 1: mass matrix, its row of this joint */
    const stanford_real m1_5 = neg_nu2_y + 0.1524*neg_fu2_x;
    /* link 2: mass matrix, its row of this joint */
    const stanford_real m2_2 = t15 + 2.2117629856 - t17;
    const stanford_real m2_5 = c4*t24;
    /* link 4: moment for a unit acceleration of a joint further out */
    const stanford_real nu4_y = 0.0026106934001670842*t9;
    /* link 4: mass matrix, its row of this joint */
    const stanford_real m4_4 = 0.1373658072 - t14;
    /* factorisation M = U D U^T */
    const stanford_real neg_ud1_6 = 0.0026106934001670842*t25;
    /* link 5: forward substitution */
    const stanford_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const stanford_real y6 = tau[5] - n06_z;
    /* factorisation M = U D U^T */
    const stanford_real u4_6 = 0.014778325123152709*c5;
    const stanford_real u2_6 = 0.1286055862151273*t9;
    const stanford_real neg_u1_6 = 0.1286055862151273*t25;
    const stanford_real neg_u3_5 = 0.9024433087142769*s5;
    const stanford_real u2_5 = 7.853342633617698*m2_5;
    const stanford_real u1_5 = 7.853342633617698*m1_5;
    const stanford_real neg_pivot4 = neg_nu5_y*u4_6 - m4_4;
    const stanford_real neg_ipivot4 = 1.0 / neg_pivot4;
    const stanford_real neg_ud2_4 = neg_m2_4 + neg_nu5_y*u2_6;
    const stanford_real u2_4 = neg_ipivot4*neg_ud2_4;
    const stanford_real ud1_4 = m1_4 + neg_nu5_y*neg_u1_6;
    const stanford_real neg_u1_4 = neg_ipivot4*ud1_4;
    const stanford_real neg_pivot3 = h5_x*neg_u3_5 - 7.252;
    const stanford_real neg_ipivot3 = 1.0 / neg_pivot3;
    const stanford_real neg_ud2_3 = h4_x - h5_x*u2_5;
    const stanford_real u2_3 = neg_ipivot3*neg_ud2_3;
    const stanford_real ud1_3 = m1_3 + h5_x*u1_5;
    const stanford_real neg_u1_3 = neg_ipivot3*ud1_3;
    const stanford_real neg_pivot2 = nu4_y*u2_6 - m2_2 + m2_5*u2_5 - neg_ud2_4*u2_4 -
        neg_ud2_3*u2_3;
    const stanford_real neg_ipivot2 = 1.0 / neg_pivot2;
    const stanford_real neg_ud1_2 = neg_m1_2 - nu4_y*neg_u1_6 + m2_5*u1_5 + neg_ud2_4*neg_u1_4 +
        neg_ud2_3*neg_u1_3;
    const stanford_real u1_2 = neg_ipivot2*neg_ud1_2;
    const stanford_real pivot1 = m1_1 - neg_ud1_6*neg_u1_6 - m1_5*u1_5 + ud1_4*neg_u1_4 +
        ud1_3*neg_u1_3 + neg_ud1_2*u1_2;
    const stanford_real ipivot1 = 1.0 / pivot1;
    /* link 4: forward substitution */
    const stanford_real y4 = neg_n4_z + tau[3] - y6*u4_6;
    /* link 3: forward substitution */
    const stanford_real neg_y3 = f3_z - tau[2] + neg_y5*neg_u3_5;
    /* link 2: forward substitution */
    const stanford_real neg_y2 = tau2 - tau[1] + y6*u2_6 - neg_y5*u2_5 + u2_4*y4 - u2_3*neg_y3;
    /* link 1: forward substitution */
    const stanford_real neg_y1 = tau1 - tau[0] - y6*neg_u1_6 - neg_y5*u1_5 - neg_u1_4*y4 +
        neg_u1_3*neg_y3 - u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real qdd2 = neg_ipivot2*neg_y2 + u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 - neg_u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real neg_qdd4 = neg_ipivot4*y4 + u2_4*qdd2 + neg_u1_4*neg_qdd1;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real qdd5 = u1_5*neg_qdd1 - (7.853342633617698*neg_y5 - neg_u3_5*qdd3 +
        u2_5*qdd2);
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_real qdd6 = 49.26108374384236*y6 + u4_6*neg_qdd4 - u2_6*qdd2 - neg_u1_6*neg_qdd1;
    const stanford_real t26 = -neg_qdd1;
    const stanford_real t27 = -neg_qdd4;
    qdd[0] = t26;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = t27;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
