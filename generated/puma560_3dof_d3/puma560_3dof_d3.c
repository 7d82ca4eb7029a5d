/*
 * puma560_3dof_d3: PUMA 560, first three joints, the set of the thesis's listing D.3.3
 * Numbers: the 1990 thesis, program D.2, first three links (listing D.3.3)
 * Origin of numbers: geometry, inertia; mass, centre of mass (joints 2, 3): stated by the
 *     description
 * Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 71d3f4095a700e86936e2038b13dbc17 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0       d 0        theta q
 *   2  revolute  alpha -pi/2  a 0       d 0.2435   theta q
 *   3  revolute  alpha 0      a 0.4318  d -0.0934  theta q
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
 *   inverse_dynamics: 36 multiplications, 26 additions = 62; 0 unary minus; 4 sine/cosine
 *   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
 *   bias: 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
 *   mass_matrix: 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 49 multiplications, 34 additions, 2 divisions = 85; 0 unary minus; 4
 *       sine/cosine
 */
#include "puma560_3dof_d3.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 36 multiplications, 26 additions = 62; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d3_inverse_dynamics(
    const puma560_3dof_d3_real q[3],
    const puma560_3dof_d3_real qd[3],
    const puma560_3dof_d3_real qdd[3],
    puma560_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real c2 = cos(q[1]);
    const puma560_3dof_d3_real s2 = sin(q[1]);
    const puma560_3dof_d3_real angle23 = q[1] + q[2];
    const puma560_3dof_d3_real c23 = cos(angle23);
    const puma560_3dof_d3_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d3_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d3_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d3_real t1 = s2*qdd[1] + c2*ww2_zz;
    const puma560_3dof_d3_real t2 = c2 + 0.524658682370586*s23;
    const puma560_3dof_d3_real t3 = 0.1450848*c23;
    const puma560_3dof_d3_real t4 = w3_z*t3;
    const puma560_3dof_d3_real t5 = 0.1450848*s23;
    const puma560_3dof_d3_real t6 = t5 + 1.449223552*c2;
    const puma560_3dof_d3_real t7 = s2*t6;
    const puma560_3dof_d3_real t8 = alpha3_z*t3 - ww3_zz*t5;
    const puma560_3dof_d3_real t9 = 0.3476146364057434*(5.753497668221186*((t2*t4 - qd[1]*t7)*qd[0])
        - t8) + (t2*t5 + (c2*t6 + 2.778329198))*qdd[0];
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d3_real n1_z = 0.022994064*t1 + t9;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d3_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d3_real nc3_z = 0.96302*alpha3_z + t5*(c2*qdd[1] - (s2*ww2_zz +
        22.69569245020843)) - t3*(t1 + (0.3476146364057434*qdd[0] + t2*neg_lam2_33));
    const puma560_3dof_d3_real t10 = nc3_z - (s2*(t8 - 0.022994064*qdd[0]) - c2*(w3_z*t4 +
        (alpha3_z*t5 - 8.716512)));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d3_real n02_z = 6.305523552*qdd[1] + t7*neg_lam2_33 + t10;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques that hold the arm at rest
 * 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine */
void puma560_3dof_d3_gravity(const puma560_3dof_d3_real q[3], puma560_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real angle23 = q[1] + q[2];
    const puma560_3dof_d3_real s23 = sin(angle23);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d3_real nc3_z = -3.2928*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real c2 = cos(q[1]);
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d3_real neg_nc2_z = 8.716512*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d3_real n02_z = nc3_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine */
void puma560_3dof_d3_bias(
    const puma560_3dof_d3_real q[3],
    const puma560_3dof_d3_real qd[3],
    puma560_3dof_d3_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real c2 = cos(q[1]);
    const puma560_3dof_d3_real s2 = sin(q[1]);
    const puma560_3dof_d3_real angle23 = q[1] + q[2];
    const puma560_3dof_d3_real c23 = cos(angle23);
    const puma560_3dof_d3_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d3_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d3_real t1 = c2*ww2_zz;
    const puma560_3dof_d3_real t2 = c2 + 0.524658682370586*s23;
    const puma560_3dof_d3_real t3 = 0.1450848*c23;
    const puma560_3dof_d3_real t4 = w3_z*t3;
    const puma560_3dof_d3_real t5 = 0.1450848*s23;
    const puma560_3dof_d3_real t6 = s2*(t5 + 1.449223552*c2);
    const puma560_3dof_d3_real t7 = ww3_zz*t5;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d3_real n1_z = 0.022994064*t1 + 0.3476146364057434*(5.753497668221186*((t2*t4
        - qd[1]*t6)*qd[0]) + t7);
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d3_real lam2_33 = -qd[0]*qd[0];
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d3_real nc3_z = t3*(t2*lam2_33 - t1) - t5*(s2*ww2_zz + 22.69569245020843);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d3_real n02_z = nc3_z + (s2*t7 + c2*(w3_z*t4 - 8.716512)) - t6*lam2_33;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d3_mass_matrix(const puma560_3dof_d3_real q[3], puma560_3dof_d3_real M[9])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real c2 = cos(q[1]);
    const puma560_3dof_d3_real s2 = sin(q[1]);
    const puma560_3dof_d3_real angle23 = q[1] + q[2];
    const puma560_3dof_d3_real c23 = cos(angle23);
    const puma560_3dof_d3_real s23 = sin(angle23);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d3_real m1_3 = -0.0504336*c23;
    const puma560_3dof_d3_real m1_1 = 1.449223552*(c2*(c2 + 0.20022418183830343*s23)) + 2.854449198
        + m1_3*(1.5093112528155832*c23);
    const puma560_3dof_d3_real m1_2 = m1_3 + 0.022994064*s2;
    const puma560_3dof_d3_real t1 = 0.1450848*(s2*c23 - c2*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d3_real m2_2 = 7.268543552 - t1 - t1;
    const puma560_3dof_d3_real m2_3 = 0.96302 - t1;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = m2_3;
    M[6] = m1_3;
    M[7] = m2_3;
    M[8] = 0.96302;
}

/* accelerations that the torques tau give
 * 49 multiplications, 34 additions, 2 divisions = 85; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d3_forward_dynamics(
    const puma560_3dof_d3_real q[3],
    const puma560_3dof_d3_real qd[3],
    const puma560_3dof_d3_real tau[3],
    puma560_3dof_d3_real qdd[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d3_real c2 = cos(q[1]);
    const puma560_3dof_d3_real s2 = sin(q[1]);
    const puma560_3dof_d3_real angle23 = q[1] + q[2];
    const puma560_3dof_d3_real c23 = cos(angle23);
    const puma560_3dof_d3_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d3_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d3_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d3_real t1 = c2*ww2_zz;
    const puma560_3dof_d3_real t2 = c2 + 0.524658682370586*s23;
    const puma560_3dof_d3_real t3 = 0.1450848*c23;
    const puma560_3dof_d3_real t4 = w3_z*t3;
    const puma560_3dof_d3_real t5 = 0.1450848*s23;
    const puma560_3dof_d3_real t6 = 1.449223552*c2;
    const puma560_3dof_d3_real t7 = s2*(t5 + t6);
    const puma560_3dof_d3_real t8 = ww3_zz*t5;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d3_real n1_z = 0.022994064*(t1 + 86.97896987674731*((t2*t4 - qd[1]*t7)*qd[0]
        + 0.1738073182028717*t8));
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d3_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d3_real neg_nc3_z = t3*(t1 + t2*neg_lam2_33) + t5*(s2*ww2_zz +
        22.69569245020843);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d3_real n02_z = t7*neg_lam2_33 - (neg_nc3_z - (s2*t8 + c2*(w3_z*t4 -
        8.716512)));
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d3_real m1_2 = 0.022994064*(s2 - 2.193331287587962*c23);
    const puma560_3dof_d3_real t9 = 0.1450848*(s2*c23 - c2*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d3_real neg_m2_2 = t9 + (t9 - 7.268543552);
    const puma560_3dof_d3_real neg_m2_3 = t9 - 0.96302;
    /* link 3: forward substitution */
    const puma560_3dof_d3_real y3 = neg_nc3_z + tau[2];
    /* factorisation M = U D U^T */
    const puma560_3dof_d3_real neg_u2_3 = 1.038400033228801*neg_m2_3;
    const puma560_3dof_d3_real neg_u1_3 = 0.052370251915848064*c23;
    const puma560_3dof_d3_real neg_pivot2 = neg_m2_2 + neg_m2_3*neg_u2_3;
    const puma560_3dof_d3_real neg_ipivot2 = 1.0 / neg_pivot2;
    const puma560_3dof_d3_real ud1_2 = m1_2 - neg_m2_3*neg_u1_3;
    const puma560_3dof_d3_real neg_u1_2 = neg_ipivot2*ud1_2;
    const puma560_3dof_d3_real pivot1 = ud1_2*neg_u1_2 + (c2*(t6 + 0.2901696*s23) + 2.854449198) -
        0.07876122033702311*(c23*c23);
    const puma560_3dof_d3_real ipivot1 = 1.0 / pivot1;
    /* link 2: forward substitution */
    const puma560_3dof_d3_real y2 = tau[1] - n02_z + y3*neg_u2_3;
    /* link 1: forward substitution */
    const puma560_3dof_d3_real y1 = neg_u1_2*y2 - (n1_z - tau[0] - y3*neg_u1_3);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d3_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d3_real qdd2 = neg_u1_2*qdd1 - neg_ipivot2*y2;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d3_real qdd3 = neg_u1_3*qdd1 - (-1.038400033228801*y3 - neg_u2_3*qdd2);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
