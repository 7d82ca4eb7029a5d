/*
 * puma560_3dof_d12: PUMA 560, first three joints, the set of the thesis's program D.1.2
 * Numbers: the 1990 thesis, program D.1.2 (Newton-Euler), payload 0
 * Origin of numbers: geometry, inertia; mass, centre of mass (joints 2, 3): stated by the
 *     description
 * Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 16c8c8cbba57926adbdacd5fb2c4cd18 (a hash of its numbers)
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
 *   inverse_dynamics: 38 multiplications, 26 additions = 64; 0 unary minus; 4 sine/cosine
 *   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
 *   bias: 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
 *   mass_matrix: 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 49 multiplications, 34 additions, 2 divisions = 85; 2 unary minus; 4
 *       sine/cosine
 */
#include "puma560_3dof_d12.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 38 multiplications, 26 additions = 64; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d12_inverse_dynamics(
    const puma560_3dof_d12_real q[3],
    const puma560_3dof_d12_real qd[3],
    const puma560_3dof_d12_real qdd[3],
    puma560_3dof_d12_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real c2 = cos(q[1]);
    const puma560_3dof_d12_real s2 = sin(q[1]);
    const puma560_3dof_d12_real angle23 = q[1] + q[2];
    const puma560_3dof_d12_real c23 = cos(angle23);
    const puma560_3dof_d12_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d12_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d12_real alpha3_z = qdd[1] + qdd[2];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d12_real neg_lam2_33 = qd[0]*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d12_real t1 = s2*qdd[1] + c2*ww2_zz;
    const puma560_3dof_d12_real t2 = c2 + 1.1278396957793986*s23;
    const puma560_3dof_d12_real t3 = 0.1828673*c23;
    const puma560_3dof_d12_real t4 = w3_z*t3;
    const puma560_3dof_d12_real t5 = 0.1828673*s23;
    const puma560_3dof_d12_real t6 = 1.602487602*c2;
    const puma560_3dof_d12_real t7 = t5 + t6;
    const puma560_3dof_d12_real t8 = 0.104010539*qdd[0];
    const puma560_3dof_d12_real t9 = alpha3_z*t3 - t5*ww3_zz;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d12_real n1_z = 0.104010539*t1 + 2.0*(qd[0]*(t2*t4 - t7*(s2*qd[1]))) +
        (t8*(1.558875134188362*(t2*t2 + 3.459309734072025*(t6*t6)) + 26.952958204552715) -
        0.3476146364057434*t9);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d12_real nc3_z = t5*(c2*qdd[1] - 22.69569245020843 - s2*ww2_zz) +
        (1.071645*alpha3_z - t3*(neg_lam2_33*t2 + (t1 + 0.3476146364057434*qdd[0])));
    const puma560_3dof_d12_real t10 = c2*(alpha3_z*t5 + (w3_z*t4 - 14.006062)) + (s2*(neg_lam2_33*t7
        + (t8 - t9)) + nc3_z);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d12_real n02_z = 6.457487602*qdd[1] + t10;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques that hold the arm at rest
 * 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine */
void puma560_3dof_d12_gravity(const puma560_3dof_d12_real q[3], puma560_3dof_d12_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real angle23 = q[1] + q[2];
    const puma560_3dof_d12_real s23 = sin(angle23);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d12_real nc3_z = -4.1503*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real c2 = cos(q[1]);
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d12_real neg_nc2_z = 14.006062*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d12_real n02_z = nc3_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine */
void puma560_3dof_d12_bias(
    const puma560_3dof_d12_real q[3],
    const puma560_3dof_d12_real qd[3],
    puma560_3dof_d12_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real c2 = cos(q[1]);
    const puma560_3dof_d12_real s2 = sin(q[1]);
    const puma560_3dof_d12_real angle23 = q[1] + q[2];
    const puma560_3dof_d12_real c23 = cos(angle23);
    const puma560_3dof_d12_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d12_real w3_z = qd[1] + qd[2];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d12_real lam2_33 = -qd[0]*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d12_real t1 = c2*ww2_zz;
    const puma560_3dof_d12_real t2 = c2 + 1.1278396957793986*s23;
    const puma560_3dof_d12_real t3 = 0.1828673*c23;
    const puma560_3dof_d12_real t4 = w3_z*t3;
    const puma560_3dof_d12_real t5 = 0.1828673*s23;
    const puma560_3dof_d12_real t6 = t5 + 1.602487602*c2;
    const puma560_3dof_d12_real t7 = t5*ww3_zz;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d12_real n1_z = 0.104010539*t1 + 2.0*(qd[0]*(t2*t4 - t6*(s2*qd[1]))) +
        0.3476146364057434*t7;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d12_real nc3_z = t3*(lam2_33*t2 - t1) - t5*(s2*ww2_zz + 22.69569245020843);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d12_real n02_z = c2*(w3_z*t4 - 14.006062) + (s2*(t7 - lam2_33*t6) + nc3_z);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d12_mass_matrix(const puma560_3dof_d12_real q[3], puma560_3dof_d12_real M[9])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real c2 = cos(q[1]);
    const puma560_3dof_d12_real s2 = sin(q[1]);
    const puma560_3dof_d12_real angle23 = q[1] + q[2];
    const puma560_3dof_d12_real c23 = cos(angle23);
    const puma560_3dof_d12_real s23 = sin(angle23);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d12_real m1_3 = -0.06356735*c23;
    const puma560_3dof_d12_real m1_1 = 1.602487602*(c2*(c2 + 0.22822928523349661*s23)) +
        3.0096367105 + m1_3*(3.2445115298970304*c23);
    const puma560_3dof_d12_real m1_2 = m1_3 + 0.104010539*s2;
    const puma560_3dof_d12_real t1 = 0.1828673*(s2*c23 - c2*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d12_real m2_2 = 7.529132602 - t1 - t1;
    const puma560_3dof_d12_real m2_3 = 1.071645 - t1;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = m2_3;
    M[6] = m1_3;
    M[7] = m2_3;
    M[8] = 1.071645;
}

/* accelerations that the torques tau give
 * 49 multiplications, 34 additions, 2 divisions = 85; 2 unary minus; 4 sine/cosine */
void puma560_3dof_d12_forward_dynamics(
    const puma560_3dof_d12_real q[3],
    const puma560_3dof_d12_real qd[3],
    const puma560_3dof_d12_real tau[3],
    puma560_3dof_d12_real qdd[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d12_real c2 = cos(q[1]);
    const puma560_3dof_d12_real s2 = sin(q[1]);
    const puma560_3dof_d12_real angle23 = q[1] + q[2];
    const puma560_3dof_d12_real c23 = cos(angle23);
    const puma560_3dof_d12_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d12_real w3_z = qd[1] + qd[2];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d12_real lam2_33 = -qd[0]*qd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d12_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d12_real t1 = c2*ww2_zz;
    const puma560_3dof_d12_real t2 = c2 + 1.1278396957793986*s23;
    const puma560_3dof_d12_real t3 = 0.1828673*c23;
    const puma560_3dof_d12_real t4 = w3_z*t3;
    const puma560_3dof_d12_real t5 = 0.1828673*s23;
    const puma560_3dof_d12_real t6 = 1.602487602*c2;
    const puma560_3dof_d12_real t7 = t5 + t6;
    const puma560_3dof_d12_real t8 = ww3_zz*t5;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d12_real n1_z = 0.104010539*(t1 + 19.228820648646*(qd[0]*(t2*t4 -
        t7*(s2*qd[1]))) + 3.342109749145165*t8);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d12_real neg_nc3_z = t3*(t1 - lam2_33*t2) + t5*(s2*ww2_zz +
        22.69569245020843);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d12_real n02_z = c2*(w3_z*t4 - 14.006062) + (s2*(t8 - lam2_33*t7) -
        neg_nc3_z);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d12_real m1_2 = 0.104010539*(s2 - 0.6111625861298536*c23);
    const puma560_3dof_d12_real t9 = 0.1828673*(s2*c23 - c2*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d12_real m2_2 = 7.529132602 - t9 - t9;
    const puma560_3dof_d12_real m2_3 = 1.071645 - t9;
    /* link 3: forward substitution */
    const puma560_3dof_d12_real y3 = neg_nc3_z + tau[2];
    /* factorisation M = U D U^T */
    const puma560_3dof_d12_real u2_3 = 0.933144838076042*m2_3;
    const puma560_3dof_d12_real u1_3 = -0.059317544522673085*c23;
    const puma560_3dof_d12_real pivot2 = m2_2 - m2_3*u2_3;
    const puma560_3dof_d12_real ipivot2 = 1.0 / pivot2;
    const puma560_3dof_d12_real ud1_2 = m1_2 - m2_3*u1_3;
    const puma560_3dof_d12_real u1_2 = ipivot2*ud1_2;
    const puma560_3dof_d12_real pivot1 = c2*(t6 + 0.3657346*s23) + 3.0096367105 - ud1_2*u1_2 -
        0.21001565911381334*(c23*c23);
    const puma560_3dof_d12_real ipivot1 = 1.0 / pivot1;
    /* link 2: forward substitution */
    const puma560_3dof_d12_real neg_y2 = n02_z - tau[1] + y3*u2_3;
    /* link 1: forward substitution */
    const puma560_3dof_d12_real y1 = u1_2*neg_y2 - (n1_z - tau[0] + y3*u1_3);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d12_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d12_real qdd2 = -u1_2*qdd1 - ipivot2*neg_y2;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d12_real qdd3 = 0.933144838076042*y3 - u2_3*qdd2 - u1_3*qdd1;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
