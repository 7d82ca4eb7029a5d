/*
 * stanford_3dof: Stanford arm, first three joints
 * Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; first three links, Izz of link 3
 *   assumed
 * Origin of numbers: geometry, mass, centre of mass, inertia, rotor inertia: stated by the
 *     description
 * Origin of numbers: friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: eb451b6920f3abb15f88e11742e4d38d (a hash of its numbers)
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
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 0.953 kg m^2, joint 2 2.193 kg m^2, joint 3 0.782 kg
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 5.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 30 multiplications, 17 additions = 47; 0 unary minus; 2 sine/cosine
 *   gravity: 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
 *   bias: 21 multiplications, 9 additions = 30; 0 unary minus; 2 sine/cosine
 *   mass_matrix: 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
 *   forward_dynamics: 39 multiplications, 23 additions, 2 divisions = 64; 0 unary minus; 2
 *       sine/cosine
 */
#include "stanford_3dof.h"

#include <math.h>

/* torques that give the accelerations qdd
 * with rotor inertia
 * 30 multiplications, 17 additions = 47; 0 unary minus; 2 sine/cosine */
void stanford_3dof_inverse_dynamics(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    const stanford_3dof_real qdd[3],
    stanford_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real neg_w2_x = s2*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    const stanford_3dof_real t1 = 2.0*qd[1];
    const stanford_3dof_real t2 = q[2] + 0.6447;
    const stanford_3dof_real t3 = 4.25*t2;
    const stanford_3dof_real t4 = t2*t3 + 2.512;
    const stanford_3dof_real t5 = c2*(neg_w2_x*t4);
    const stanford_3dof_real t6 = t2*qdd[1] + t1*qd[2];
    const stanford_3dof_real t7 = 0.015551020408163266*qdd[0];
    const stanford_3dof_real t8 = s2*t7;
    const stanford_3dof_real t9 = c2*t6 - s2*(t4*(99.28124431412262*t8) + t2*(ww2_zz +
        neg_w2_x*(13.123359580052494*qd[2])) - qdd[2]);
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau1 = t1*t5 + 0.6477*(2.3928713486181876*qdd[0] - t9);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_x = -9.8*(s2 + c2*t7);
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau2 = 4.721*qdd[1] + t3*(t6 + a2_x) - qd[0]*t5;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xx = neg_w2_x*neg_w2_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real neg_lam2_22 = ww2_zz + ww2_xx;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau3 = 5.032*qdd[2] + (41.65*(c2 - t8) - t3*neg_lam2_22);
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
}

/* torques that hold the arm at rest
 * 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine */
void stanford_3dof_gravity(const stanford_3dof_real q[3], stanford_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    /* link 3: force that moves the link [N] */
    const stanford_3dof_real fc3_z = 41.65*c2;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real s2 = sin(q[1]);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n2_z = -41.65*(s2*(q[2] + 0.6447));
    tau[0] = 0.0;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 21 multiplications, 9 additions = 30; 0 unary minus; 2 sine/cosine */
void stanford_3dof_bias(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    stanford_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real neg_w2_x = s2*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    const stanford_3dof_real t1 = 2.0*qd[1];
    const stanford_3dof_real t2 = q[2] + 0.6447;
    const stanford_3dof_real t3 = 4.25*t2;
    const stanford_3dof_real t4 = c2*(neg_w2_x*(t2*t3 + 2.512));
    const stanford_3dof_real t5 = t1*qd[2];
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau1 = t1*t4 - 0.6477*(c2*t5 - s2*(t2*(ww2_zz +
        neg_w2_x*(13.123359580052494*qd[2]))));
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_x = -9.8*s2;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau2 = t3*(t5 + a2_x) - qd[0]*t4;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xx = neg_w2_x*neg_w2_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real neg_lam2_22 = ww2_zz + ww2_xx;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau3 = 41.65*c2 - t3*neg_lam2_22;
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
}

/* mass matrix, rotor inertias on its diagonal
 * 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine */
void stanford_3dof_mass_matrix(const stanford_3dof_real q[3], stanford_3dof_real M[9])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(q[1]);
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real m1_3 = -0.6477*s2;
    const stanford_3dof_real t1 = q[2] + 1.2894;
    const stanford_3dof_real t2 = 4.25*(q[2]*t1);
    const stanford_3dof_real m1_1 = (t2 + 4.2784618825)*(s2*s2) + 1.5498627725;
    const stanford_3dof_real m1_2 = -0.32385*(c2*(q[2] + t1));
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_real m2_2 = t2 + 6.4874618825;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = 0.0;
    M[6] = m1_3;
    M[7] = 0.0;
    M[8] = 5.032;
}

/* accelerations that the torques tau give
 * with rotor inertia
 * 39 multiplications, 23 additions, 2 divisions = 64; 0 unary minus; 2 sine/cosine */
void stanford_3dof_forward_dynamics(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    const stanford_3dof_real tau[3],
    stanford_3dof_real qdd[3])
{
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(q[1]);
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real neg_w2_x = s2*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    const stanford_3dof_real t1 = 2.0*qd[1];
    const stanford_3dof_real t2 = q[2] + 0.6447;
    const stanford_3dof_real t3 = 4.25*t2;
    const stanford_3dof_real t4 = c2*(neg_w2_x*(t2*t3 + 2.512));
    const stanford_3dof_real t5 = t1*qd[2];
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau1 = t1*t4 - 0.6477*(c2*t5 - s2*(t2*(ww2_zz +
        neg_w2_x*(13.123359580052494*qd[2]))));
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_x = -9.8*s2;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau2 = t3*(t5 + a2_x) - qd[0]*t4;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xx = neg_w2_x*neg_w2_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real neg_lam2_22 = ww2_zz + ww2_xx;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau3 = 41.65*c2 - t3*neg_lam2_22;
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real neg_m1_3 = 0.6477*s2;
    const stanford_3dof_real t6 = q[2] + 1.2894;
    const stanford_3dof_real t7 = 4.25*(q[2]*t6);
    const stanford_3dof_real m1_1 = (t7 + 4.2784618825)*(s2*s2) + 1.5498627725;
    const stanford_3dof_real neg_m1_2 = 0.32385*(c2*(q[2] + t6));
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_real m2_2 = t7 + 6.4874618825;
    /* link 2: forward substitution */
    const stanford_3dof_real y2 = tau[1] - tau2;
    /* link 3: forward substitution */
    const stanford_3dof_real neg_y3 = tau3 - tau[2];
    /* factorisation M = U D U^T */
    const stanford_3dof_real neg_u1_3 = 0.1287162162162162*s2;
    const stanford_3dof_real ipivot2 = 1.0 / m2_2;
    const stanford_3dof_real neg_u1_2 = neg_m1_2*ipivot2;
    const stanford_3dof_real pivot1 = m1_1 - neg_m1_3*neg_u1_3 - neg_m1_2*neg_u1_2;
    const stanford_3dof_real ipivot1 = 1.0 / pivot1;
    /* link 1: forward substitution */
    const stanford_3dof_real y1 = y2*neg_u1_2 - (tau1 - tau[0] + neg_y3*neg_u1_3);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd2 = y2*ipivot2 + neg_u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd3 = neg_u1_3*qdd1 - 0.1987281399046105*neg_y3;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
