/*
 * stanford_3dof: Stanford arm, first three joints
 * Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; first three links, Izz of link 3
 *   assumed
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 prismatic
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
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 44 multiplications, 29 additions = 73; 2 unary minus; 2 sine/cosine
 *   gravity: 7 multiplications, 2 additions = 9; 0 unary minus; 2 sine/cosine
 *   bias: 36 multiplications, 16 additions = 52; 0 unary minus; 2 sine/cosine
 *   mass_matrix: 7 multiplications, 7 additions = 14; 0 unary minus; 2 sine/cosine
 *   forward_dynamics: 59 multiplications, 35 additions, 3 divisions = 97; 3 unary minus; 2
 *       sine/cosine
 */
#include "stanford_3dof.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 44 multiplications, 29 additions = 73; 2 unary minus; 2 sine/cosine */
void stanford_3dof_inverse_dynamics(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    const stanford_3dof_real qdd[3],
    stanford_3dof_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_3dof_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(again[1]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_z = -0.1524*ww1_zz;
    const stanford_3dof_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real w2_x = t1*s2;
    const stanford_3dof_real w2_y = t1*c2;
    const stanford_3dof_real t2 = 0.1524*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_x = -9.8*s2 - c2*t2;
    const stanford_3dof_real a2_y = s2*t2 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_yz = qd[1]*w2_y;
    const stanford_3dof_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_3dof_real alpha2_x = ww2_yz - qdd[0]*s2;
    const stanford_3dof_real alpha2_y = -qdd[0]*c2 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xy = w2_x*w2_y;
    const stanford_3dof_real ww2_xx = w2_x*w2_x;
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real lam2_12 = ww2_xy - qdd[1];
    const stanford_3dof_real lam2_21 = qdd[1] + ww2_xy;
    const stanford_3dof_real neg_lam2_22 = ww2_xx + ww2_zz;
    const stanford_3dof_real neg_lam2_31 = alpha2_y - ww2_zx;
    const stanford_3dof_real lam2_32 = ww2_yz + alpha2_x;
    const stanford_3dof_real t3 = 2.0*qd[2];
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a3_x = a2_x - q[2]*lam2_12 + qd[1]*t3;
    const stanford_3dof_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t3;
    const stanford_3dof_real a3_z = qdd[2] - (a2_y + q[2]*neg_lam2_22);
    /* link 2: moment that turns the link [N m] */
    const stanford_3dof_real nc2_x = 4.2864618825*lam2_32;
    const stanford_3dof_real nc2_y = 0.008*neg_lam2_31;
    const stanford_3dof_real nc2_z = 0.008*lam2_21 - 4.2864618825*lam2_12;
    /* link 3: force that moves the link [N] */
    const stanford_3dof_real fc3_x = 4.25*a3_x - 2.739975*lam2_12;
    const stanford_3dof_real fc3_y = 4.25*a3_y - 2.739975*lam2_32;
    const stanford_3dof_real neg_fc3_z = 2.739975*neg_lam2_22 - 4.25*a3_z;
    /* link 3: moment that turns the link [N m] */
    const stanford_3dof_real nc3_x = -2.739975*a3_y;
    const stanford_3dof_real nc3_y = 2.739975*a3_x;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau3 = 0.782*qdd[2] - neg_fc3_z;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n2_x = nc3_x + (nc2_x - q[2]*fc3_y);
    const stanford_3dof_real n2_z = nc3_y + (nc2_z + q[2]*fc3_x);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_3dof_real neg_f02_x = s2*neg_fc3_z - c2*fc3_x;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau2 = n2_z + 2.193*qdd[1];
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const stanford_3dof_real tau1 = 0.1524*neg_f02_x - (s2*n2_x + c2*nc2_y) + 1.4431532925*qdd[0];
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
}

/* torques that hold the arm at rest
 * 7 multiplications, 2 additions = 9; 0 unary minus; 2 sine/cosine */
void stanford_3dof_gravity(const stanford_3dof_real q[3], stanford_3dof_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_3dof_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(again[1]);
    /* link 3: force that moves the link [N] */
    const stanford_3dof_real neg_fc3_x = 41.65*s2;
    const stanford_3dof_real fc3_z = 41.65*c2;
    /* link 3: moment that turns the link [N m] */
    const stanford_3dof_real nc3_y = -26.851755*s2;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n2_z = nc3_y - q[2]*neg_fc3_x;
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_3dof_real f02_x = s2*fc3_z - c2*neg_fc3_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n1_z = -0.1524*f02_x;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 36 multiplications, 16 additions = 52; 0 unary minus; 2 sine/cosine */
void stanford_3dof_bias(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    stanford_3dof_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_3dof_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(again[1]);
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real neg_a2_z = 0.1524*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real neg_w2_x = qd[0]*s2;
    const stanford_3dof_real neg_w2_y = qd[0]*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_x = -9.8*s2;
    const stanford_3dof_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_3dof_real neg_alpha2_x = qd[1]*neg_w2_y;
    const stanford_3dof_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xy = neg_w2_x*neg_w2_y;
    const stanford_3dof_real ww2_xx = neg_w2_x*neg_w2_x;
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real neg_lam2_22 = ww2_xx + ww2_zz;
    const stanford_3dof_real neg_lam2_32 = 2.0*neg_alpha2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a3_z = neg_a2_y - q[2]*neg_lam2_22;
    const stanford_3dof_real t1 = 2.0*qd[2];
    const stanford_3dof_real a3_x = qd[1]*t1 - (q[2]*ww2_xy - a2_x);
    const stanford_3dof_real neg_a3_y = neg_a2_z - q[2]*neg_lam2_32 - neg_w2_x*t1;
    /* link 2: moment that turns the link [N m] */
    const stanford_3dof_real neg_nc2_x = 8.572923765*neg_alpha2_x;
    const stanford_3dof_real nc2_y = 0.016*alpha2_y;
    const stanford_3dof_real nc2_z = -4.2784618825*ww2_xy;
    /* link 3: force that moves the link [N] */
    const stanford_3dof_real neg_fc3_x = 2.739975*ww2_xy - 4.25*a3_x;
    const stanford_3dof_real neg_fc3_y = 4.25*neg_a3_y - 5.47995*neg_alpha2_x;
    const stanford_3dof_real fc3_z = 4.25*a3_z - 2.739975*neg_lam2_22;
    /* link 3: moment that turns the link [N m] */
    const stanford_3dof_real nc3_x = 2.739975*neg_a3_y;
    const stanford_3dof_real nc3_y = 2.739975*a3_x;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n2_x = nc3_x - (neg_nc2_x - q[2]*neg_fc3_y);
    const stanford_3dof_real n2_z = nc3_y + (nc2_z - q[2]*neg_fc3_x);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_3dof_real f02_x = s2*fc3_z - c2*neg_fc3_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_3dof_real n02_y = s2*n2_x + c2*nc2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n1_z = -0.1524*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = fc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 7 multiplications, 7 additions = 14; 0 unary minus; 2 sine/cosine */
void stanford_3dof_mass_matrix(const stanford_3dof_real q[3], stanford_3dof_real M[9])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_3dof_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(again[1]);
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real m1_3 = -0.6477*s2;
    const stanford_3dof_real t1 = 4.25*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_3dof_real neg_h2_y = c2*(t1 + 2.739975);
    const stanford_3dof_real t2 = q[2]*(t1 + 5.47995);
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_3dof_real k2_xx = t2 + 4.2864618825 - c2*c2*(t2 + 4.2784618825);
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_real m2_2 = t2 + 6.4874618825;
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real m1_2 = -0.1524*neg_h2_y;
    const stanford_3dof_real m1_1 = k2_xx + 1.5418627725;
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
 * 59 multiplications, 35 additions, 3 divisions = 97; 3 unary minus; 2 sine/cosine */
void stanford_3dof_forward_dynamics(
    const stanford_3dof_real q[3],
    const stanford_3dof_real qd[3],
    const stanford_3dof_real tau[3],
    stanford_3dof_real qdd[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile stanford_3dof_real *const again = q;
    /* sines and cosines of the joint angles */
    const stanford_3dof_real c2 = cos(q[1]);
    const stanford_3dof_real s2 = sin(again[1]);
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real m1_3 = -0.6477*s2;
    const stanford_3dof_real t1 = 4.25*q[2];
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const stanford_3dof_real neg_h2_y = c2*(t1 + 2.739975);
    const stanford_3dof_real t2 = q[2]*(t1 + 5.47995);
    /* link 2: second moment of the composite body [kg m^2] */
    const stanford_3dof_real k2_xx = t2 + 4.2864618825 - c2*c2*(t2 + 4.2784618825);
    /* link 2: mass matrix, its row of this joint */
    const stanford_3dof_real m2_2 = t2 + 6.4874618825;
    /* link 1: mass matrix, its row of this joint */
    const stanford_3dof_real m1_2 = -0.1524*neg_h2_y;
    const stanford_3dof_real m1_1 = k2_xx + 1.5418627725;
    /* link 1: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a2_z = -0.1524*ww1_zz;
    const stanford_3dof_real t3 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const stanford_3dof_real w2_x = t3*s2;
    const stanford_3dof_real w2_y = t3*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real neg_a2_x = 9.8*s2;
    const stanford_3dof_real neg_a2_y = 9.8*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const stanford_3dof_real alpha2_x = qd[1]*w2_y;
    const stanford_3dof_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const stanford_3dof_real ww2_xy = w2_x*w2_y;
    const stanford_3dof_real ww2_xx = w2_x*w2_x;
    const stanford_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const stanford_3dof_real lam2_22 = -ww2_xx - ww2_zz;
    const stanford_3dof_real lam2_32 = 2.0*alpha2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const stanford_3dof_real a3_z = neg_a2_y + q[2]*lam2_22;
    const stanford_3dof_real t4 = 2.0*qd[2];
    const stanford_3dof_real a3_x = qd[1]*t4 - (neg_a2_x + q[2]*ww2_xy);
    const stanford_3dof_real a3_y = a2_z - q[2]*lam2_32 - w2_x*t4;
    /* link 2: moment that turns the link [N m] */
    const stanford_3dof_real nc2_x = 8.572923765*alpha2_x;
    const stanford_3dof_real nc2_y = -0.016*neg_alpha2_y;
    const stanford_3dof_real neg_nc2_z = 4.2784618825*ww2_xy;
    /* link 3: force that moves the link [N] */
    const stanford_3dof_real fc3_x = 4.25*a3_x - 2.739975*ww2_xy;
    const stanford_3dof_real fc3_y = 4.25*a3_y - 5.47995*alpha2_x;
    const stanford_3dof_real neg_fc3_z = -4.25*a3_z - 2.739975*lam2_22;
    /* link 3: moment that turns the link [N m] */
    const stanford_3dof_real nc3_x = -2.739975*a3_y;
    const stanford_3dof_real nc3_y = 2.739975*a3_x;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n2_x = nc3_x + (nc2_x - q[2]*fc3_y);
    const stanford_3dof_real n2_z = nc3_y + (q[2]*fc3_x - neg_nc2_z);
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const stanford_3dof_real neg_f02_x = s2*neg_fc3_z - c2*fc3_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const stanford_3dof_real n02_y = s2*n2_x + c2*nc2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const stanford_3dof_real n1_z = 0.1524*neg_f02_x - n02_y;
    /* link 1: forward substitution */
    const stanford_3dof_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const stanford_3dof_real ipivot1 = 1.0 / m1_1;
    const stanford_3dof_real l2_1 = m1_2*ipivot1;
    const stanford_3dof_real l3_1 = m1_3*ipivot1;
    const stanford_3dof_real pivot2 = m2_2 - m1_2*l2_1;
    const stanford_3dof_real ipivot2 = 1.0 / pivot2;
    const stanford_3dof_real neg_ld3_2 = m1_2*l3_1;
    const stanford_3dof_real l3_2 = -ipivot2*neg_ld3_2;
    const stanford_3dof_real pivot3 = neg_ld3_2*l3_2 - (m1_3*l3_1 - 5.032);
    const stanford_3dof_real ipivot3 = 1.0 / pivot3;
    /* link 2: forward substitution */
    const stanford_3dof_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const stanford_3dof_real y3 = tau[2] + neg_fc3_z - y1*l3_1 - l3_2*y2;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd3 = ipivot3*y3;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd2 = ipivot2*y2 - l3_2*qdd3;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const stanford_3dof_real qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
