/*
 * puma560_3dof: PUMA 560, first three joints
 * Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; first three links
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: inertia, rotor inertia; mass, centre of mass (joints 2, 3): measured on the
 *     arm
 * Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: a3748b578bcf07f13e7166c4520ffff7 (a hash of its numbers)
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
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 45 multiplications, 35 additions = 80; 0 unary minus; 4 sine/cosine
 *   gravity: 3 multiplications, 3 additions = 6; 0 unary minus; 3 sine/cosine
 *   bias: 29 multiplications, 18 additions = 47; 1 unary minus; 4 sine/cosine
 *   mass_matrix: 12 multiplications, 12 additions = 24; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 55 multiplications, 42 additions, 2 divisions = 99; 2 unary minus; 4
 *       sine/cosine
 */
#include "puma560_3dof.h"

#include <math.h>

/* torques that give the accelerations qdd
 * with rotor inertia
 * 45 multiplications, 35 additions = 80; 0 unary minus; 4 sine/cosine */
void puma560_3dof_inverse_dynamics(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    const puma560_3dof_real qdd[3],
    puma560_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_real c2 = cos(q[1]);
    const puma560_3dof_real s2 = sin(q[1]);
    const puma560_3dof_real angle23 = q[1] + q[2];
    const puma560_3dof_real c23 = cos(angle23);
    const puma560_3dof_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_real t1 = 0.0015049505482314155*c2;
    const puma560_3dof_real t2 = t1 - 5.866434376976675e-05*s2;
    const puma560_3dof_real t3 = 0.03851*s23;
    const puma560_3dof_real t4 = 0.1450848*c2;
    const puma560_3dof_real t5 = t3 + t4;
    const puma560_3dof_real t6 = t3 + t5;
    const puma560_3dof_real t7 = 0.1450848*s2;
    const puma560_3dof_real t8 = 0.0041505871655958945*c2;
    const puma560_3dof_real t9 = t7*(s23 + 1668.1814005825509*(t2 + t8)) + 0.0070992;
    const puma560_3dof_real t10 = t1 + t7;
    const puma560_3dof_real t11 = (c23*(w3_z*t6) - qd[1]*t9)*qd[0] - (32.51361556999726*(t7*t10) -
        (s23*t5 + 2.015870295))*qdd[0];
    const puma560_3dof_real t12 = 4.199600674915636*(t8 + t10);
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau1 = 404.8626213771833*(ww2_zz*t2) - (0.0551376*(c23*alpha3_z -
        s23*ww3_zz) - (t11 + (t11 + qdd[1]*t12)));
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_real neg_lam2_33 = qd[0]*qd[0];
    const puma560_3dof_real t13 = s23*t4 - c23*t7;
    const puma560_3dof_real t14 = c23*t4 + s23*t7;
    const puma560_3dof_real t15 = 0.10952*alpha3_z - (ww2_zz*t14 + (3.2928*s23 +
        c23*(0.0551376*qdd[0] + t6*neg_lam2_33)));
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_real nc3_z = qdd[1]*t13 + t15;
    const puma560_3dof_real t16 = 1.02312*s2 + nc3_z + t9*neg_lam2_33 + (alpha3_z*t13 -
        (31.907232*c2 - ww3_zz*t14));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau2 = qdd[0]*t12 + (6.225049952*qdd[1] + t16);
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau3 = nc3_z + 0.83*qdd[2];
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
}

/* torques that hold the arm at rest
 * 3 multiplications, 3 additions = 6; 0 unary minus; 3 sine/cosine */
void puma560_3dof_gravity(const puma560_3dof_real q[3], puma560_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_real angle23 = q[1] + q[2];
    const puma560_3dof_real s23 = sin(angle23);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_real nc3_z = -3.2928*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_real c2 = cos(q[1]);
    const puma560_3dof_real s2 = sin(q[1]);
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_real nc2_z = 1.02312*s2 - 31.907232*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_real n02_z = nc3_z + nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 29 multiplications, 18 additions = 47; 1 unary minus; 4 sine/cosine */
void puma560_3dof_bias(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    puma560_3dof_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_real c2 = cos(q[1]);
    const puma560_3dof_real s2 = sin(q[1]);
    const puma560_3dof_real angle23 = q[1] + q[2];
    const puma560_3dof_real c23 = cos(angle23);
    const puma560_3dof_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_real t1 = 0.03851*s23;
    const puma560_3dof_real t2 = 0.1450848*c2;
    const puma560_3dof_real t3 = t1 + (t2 + t1);
    const puma560_3dof_real t4 = 0.1450848*s2;
    const puma560_3dof_real t5 = c2 - 0.03898091125898309*s2;
    const puma560_3dof_real t6 = t4*(s23 + 6.9239323111437185*(c2 + 0.36258738539595314*t5)) +
        0.0070992;
    const puma560_3dof_real t7 = s23*ww3_zz + 36.272888192449436*((c23*(w3_z*t3) - qd[1]*t6)*qd[0])
        + 11.050503177505005*(ww2_zz*t5);
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau1 = 0.0551376*t7;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_real lam2_33 = -qd[0]*qd[0];
    const puma560_3dof_real t8 = c23*t2 + s23*t4;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_real nc3_z = c23*(t3*lam2_33) - 3.2928*s23 - ww2_zz*t8;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau2 = ww3_zz*t8 - 31.907232*c2 - (t6*lam2_33 - (nc3_z + 1.02312*s2));
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = nc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 12 multiplications, 12 additions = 24; 0 unary minus; 4 sine/cosine */
void puma560_3dof_mass_matrix(const puma560_3dof_real q[3], puma560_3dof_real M[9])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_real c2 = cos(q[1]);
    const puma560_3dof_real s2 = sin(q[1]);
    const puma560_3dof_real angle23 = q[1] + q[2];
    const puma560_3dof_real c23 = cos(angle23);
    const puma560_3dof_real s23 = sin(angle23);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_real m1_3 = -0.0551376*c23;
    const puma560_3dof_real t1 = 0.1450848*c2;
    const puma560_3dof_real t2 = s23*t1;
    const puma560_3dof_real t3 = t2 + 0.10952;
    const puma560_3dof_real t4 = 0.09786276715410573*s2;
    const puma560_3dof_real m1_1 = t3 + (t1*(9.434462824499878*c2 - t4) + (t2 + 2.630443438 +
        1.3968689242912278*(c23*m1_3)));
    const puma560_3dof_real m1_2 = m1_3 + (0.023751*c2 + 0.609298224*s2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_real m2_3 = t3 - t4*(1.4825331862068964*c23);
    const puma560_3dof_real m2_2 = m2_3 + (m2_3 + 6.115529952);
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = m2_3;
    M[6] = m1_3;
    M[7] = m2_3;
    M[8] = 0.93952;
}

/* accelerations that the torques tau give
 * with rotor inertia
 * 55 multiplications, 42 additions, 2 divisions = 99; 2 unary minus; 4 sine/cosine */
void puma560_3dof_forward_dynamics(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    const puma560_3dof_real tau[3],
    puma560_3dof_real qdd[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_real c2 = cos(q[1]);
    const puma560_3dof_real s2 = sin(q[1]);
    const puma560_3dof_real angle23 = q[1] + q[2];
    const puma560_3dof_real c23 = cos(angle23);
    const puma560_3dof_real s23 = sin(angle23);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww2_zz = qd[1]*qd[1];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_real t1 = c2 - 0.03898091125898309*s2;
    const puma560_3dof_real t2 = 0.03851*s23;
    const puma560_3dof_real t3 = 0.1450848*c2;
    const puma560_3dof_real t4 = t2 + (t3 + t2);
    const puma560_3dof_real t5 = 0.1450848*s2;
    const puma560_3dof_real t6 = t5*(s23 + 2.51053051335616*(t1 + 2.7579558480998414*c2)) +
        0.0070992;
    const puma560_3dof_real t7 = ww2_zz*t1 + 3.282464844341972*((c23*(w3_z*t4) - qd[1]*t6)*qd[0] +
        0.0275688*(s23*ww3_zz));
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau1 = 0.609298224*t7;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_real lam2_33 = -qd[0]*qd[0];
    const puma560_3dof_real t8 = c23*t3 + s23*t5;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_real neg_nc3_z = 3.2928*s23 - c23*(t4*lam2_33) + ww2_zz*t8;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_3dof_real tau2 = ww3_zz*t8 - 31.907232*c2 + (1.02312*s2 - neg_nc3_z - t6*lam2_33);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_real m1_3 = -0.0551376*c23;
    const puma560_3dof_real t9 = s23*t3;
    const puma560_3dof_real t10 = t9 + 0.10952;
    const puma560_3dof_real m1_1 = t10 + (t9 + 2.630443438 + 1.3968689242912278*(c23*m1_3) +
        9.434462824499878*(t3*(c2 - 0.010372902938360292*s2)));
    const puma560_3dof_real m1_2 = m1_3 + 0.023751*(c2 + 25.653581912340535*s2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_real m2_3 = t10 - c23*t5;
    const puma560_3dof_real m2_2 = m2_3 + (m2_3 + 6.115529952);
    /* link 3: forward substitution */
    const puma560_3dof_real y3 = neg_nc3_z + tau[2];
    /* factorisation M = U D U^T */
    const puma560_3dof_real u2_3 = 1.0643732970027249*m2_3;
    const puma560_3dof_real u1_3 = -0.05868698910081744*c23;
    const puma560_3dof_real pivot2 = m2_2 - m2_3*u2_3;
    const puma560_3dof_real ipivot2 = 1.0 / pivot2;
    const puma560_3dof_real ud1_2 = m1_2 - m2_3*u1_3;
    const puma560_3dof_real u1_2 = ipivot2*ud1_2;
    const puma560_3dof_real pivot1 = m1_1 - m1_3*u1_3 - ud1_2*u1_2;
    const puma560_3dof_real ipivot1 = 1.0 / pivot1;
    /* link 2: forward substitution */
    const puma560_3dof_real neg_y2 = tau2 - tau[1] + y3*u2_3;
    /* link 1: forward substitution */
    const puma560_3dof_real y1 = u1_2*neg_y2 - (tau1 - tau[0] + y3*u1_3);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_real qdd2 = -(ipivot2*neg_y2) - u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_real qdd3 = 1.0643732970027249*y3 - u2_3*qdd2 - u1_3*qdd1;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
