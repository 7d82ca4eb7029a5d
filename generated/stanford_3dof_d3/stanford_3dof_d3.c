/*
 * stanford_3dof_d3: Stanford arm, first three joints, the set of the thesis's listing D.3.1
 * Numbers: the 1990 thesis, listing D.3.1 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
 *   tables
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: bcd66090e2e722726ca6b04337b104f9 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute   alpha 0      a 0  d 0       theta q
 *   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
 *   3  prismatic  alpha pi/2   a 0  d q       theta 0
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 5.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 30 multiplications, 16 additions = 46; 0 unary minus; 2 sine/cosine
 *   gravity: 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
 *   bias: 23 multiplications, 9 additions = 32; 0 unary minus; 2 sine/cosine
 *   mass_matrix: 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
 *   forward_dynamics: 41 multiplications, 23 additions, 2 divisions = 66; 0 unary minus; 2
 *       sine/cosine
 */
#include "stanford_3dof_d3.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 30 multiplications, 16 additions = 46; 0 unary minus; 2 sine/cosine */
void stanford_3dof_d3_inverse_dynamics(
    const stanford_3dof_d3_real q[3],
    const stanford_3dof_d3_real qd[3],
    const stanford_3dof_d3_real qdd[3],
    stanford_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real c2 = cos(q[1]);
    const stanford_3dof_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_d3_real neg_w2_x = s2*qd[0];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_d3_real lam2_23 = s2*qdd[0];
    const stanford_3dof_d3_real t1 = 6.561679790026247*(q[2] - 0.6447);
    const stanford_3dof_d3_real t2 = t1*t1 + 16.756430559057236;
    const stanford_3dof_d3_real t3 = c2*(t2*neg_w2_x);
    const stanford_3dof_d3_real t4 = 13.123359580052494*qd[2];
    const stanford_3dof_d3_real t5 = t1*qdd[1] + qd[1]*t4;
    const stanford_3dof_d3_real t6 = 6.561679790026247*qdd[2] - qd[1]*(t1*qd[1]);
    const stanford_3dof_d3_real t7 = t1*neg_w2_x;
    const stanford_3dof_d3_real t8 = 5.308500951741299*qdd[0] + t3*qd[1] - 0.5*(c2*t5 + s2*(t6 -
        (t4*t7 + t2*lam2_23)));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n1_z = 0.3005413344*t8;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_d3_real neg_lam2_13 = c2*qdd[0];
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n2_z = 4.721*(qdd[1] + 0.03183026206312222*(t1*(t5 - (neg_lam2_13 +
        64.30446194225722*s2)) - qd[0]*t3));
    /* link 3: force that moves the link [N] */
    const stanford_3dof_d3_real fc3_z = 0.986028*(t6 - neg_w2_x*t7 - (lam2_23 -
        64.30446194225722*c2));
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* torques that hold the arm at rest
 * 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine */
void stanford_3dof_d3_gravity(const stanford_3dof_d3_real q[3], stanford_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real c2 = cos(q[1]);
    /* link 3: force that moves the link [N] */
    const stanford_3dof_d3_real fc3_z = 63.406*c2;
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real s2 = sin(q[1]);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n2_z = -63.406*(s2*(q[2] - 0.6447));
    tau[0] = 0.0;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 23 multiplications, 9 additions = 32; 0 unary minus; 2 sine/cosine */
void stanford_3dof_d3_bias(
    const stanford_3dof_d3_real q[3],
    const stanford_3dof_d3_real qd[3],
    stanford_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real c2 = cos(q[1]);
    const stanford_3dof_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_d3_real neg_w2_x = s2*qd[0];
    const stanford_3dof_d3_real t1 = 6.561679790026247*(q[2] - 0.6447);
    const stanford_3dof_d3_real t2 = c2*((t1*t1 + 16.756430559057236)*neg_w2_x);
    const stanford_3dof_d3_real t3 = 13.123359580052494*qd[2];
    const stanford_3dof_d3_real t4 = qd[1]*t3;
    const stanford_3dof_d3_real t5 = qd[1]*(t1*qd[1]);
    const stanford_3dof_d3_real t6 = t1*neg_w2_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n1_z = 0.3005413344*(t2*qd[1] - 0.5*(c2*t4 - s2*(t5 + t3*t6)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n2_z = 0.1502706672*(t1*(t4 - 64.30446194225722*s2) - qd[0]*t2);
    /* link 3: force that moves the link [N] */
    const stanford_3dof_d3_real fc3_z = 0.986028*(64.30446194225722*c2 - (t5 + neg_w2_x*t6));
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine */
void stanford_3dof_d3_mass_matrix(const stanford_3dof_d3_real q[3], stanford_3dof_d3_real M[9])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real c2 = cos(q[1]);
    const stanford_3dof_d3_real s2 = sin(q[1]);
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_d3_real m1_3 = -0.986028*s2;
    const stanford_3dof_d3_real t1 = q[2] - 1.2894;
    const stanford_3dof_d3_real t2 = 6.47*(q[2]*t1);
    const stanford_3dof_d3_real m1_1 = (t2 + 5.2071784423)*(s2*s2) + 1.5954239597;
    const stanford_3dof_d3_real m1_2 = -0.493014*(c2*(q[2] + t1));
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_d3_real m2_2 = t2 + 7.4101784423;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = 0.0;
    M[6] = m1_3;
    M[7] = 0.0;
    M[8] = 6.47;
}

/* accelerations that the torques tau give
 * 41 multiplications, 23 additions, 2 divisions = 66; 0 unary minus; 2 sine/cosine */
void stanford_3dof_d3_forward_dynamics(
    const stanford_3dof_d3_real q[3],
    const stanford_3dof_d3_real qd[3],
    const stanford_3dof_d3_real tau[3],
    stanford_3dof_d3_real qdd[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_d3_real c2 = cos(q[1]);
    const stanford_3dof_d3_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_d3_real neg_w2_x = s2*qd[0];
    const stanford_3dof_d3_real t1 = 6.561679790026247*(q[2] - 0.6447);
    const stanford_3dof_d3_real t2 = c2*(neg_w2_x*(t1*t1 + 16.756430559057236));
    const stanford_3dof_d3_real t3 = 13.123359580052494*qd[2];
    const stanford_3dof_d3_real t4 = qd[1]*t3;
    const stanford_3dof_d3_real t5 = qd[1]*(t1*qd[1]);
    const stanford_3dof_d3_real t6 = neg_w2_x*t1;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n1_z = 0.3005413344*(t2*qd[1] - 0.5*(c2*t4 - s2*(t5 + t3*t6)));
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_d3_real n2_z = 0.1502706672*(t1*(t4 - 64.30446194225722*s2) - qd[0]*t2);
    /* link 3: force that moves the link [N] */
    const stanford_3dof_d3_real fc3_z = 0.986028*(64.30446194225722*c2 - (t5 + neg_w2_x*t6));
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_d3_real neg_m1_3 = 0.986028*s2;
    const stanford_3dof_d3_real t7 = q[2] - 1.2894;
    const stanford_3dof_d3_real t8 = 6.47*(q[2]*t7);
    const stanford_3dof_d3_real m1_1 = (t8 + 5.2071784423)*(s2*s2) + 1.5954239597;
    const stanford_3dof_d3_real neg_m1_2 = 0.493014*(c2*(q[2] + t7));
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_d3_real m2_2 = t8 + 7.4101784423;
    /* link 2: forward substitution */
    const stanford_3dof_d3_real y2 = tau[1] - n2_z;
    /* link 3: forward substitution */
    const stanford_3dof_d3_real neg_y3 = fc3_z - tau[2];
    /* factorisation M = U D U^T */
    const stanford_3dof_d3_real neg_u1_3 = 0.1524*s2;
    const stanford_3dof_d3_real ipivot2 = 1.0 / m2_2;
    const stanford_3dof_d3_real neg_u1_2 = neg_m1_2*ipivot2;
    const stanford_3dof_d3_real pivot1 = m1_1 - neg_m1_3*neg_u1_3 - neg_m1_2*neg_u1_2;
    const stanford_3dof_d3_real ipivot1 = 1.0 / pivot1;
    /* link 1: forward substitution */
    const stanford_3dof_d3_real y1 = y2*neg_u1_2 - (n1_z - tau[0] + neg_y3*neg_u1_3);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_d3_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_d3_real qdd2 = y2*ipivot2 + neg_u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_d3_real qdd3 = neg_u1_3*qdd1 - 0.1545595054095827*neg_y3;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
