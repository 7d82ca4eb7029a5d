/*
 * puma560_3dof_d4: PUMA 560, first three joints, the set of the thesis's simulation D.4
 * Numbers: the 1990 thesis, simulation D.4: program D.1.2 with a payload of 10 kg
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 revolute
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
 *   inverse_dynamics: 70 multiplications, 49 additions = 119; 0 unary minus; 4 sine/cosine
 *   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
 *   bias: 59 multiplications, 29 additions = 88; 0 unary minus; 4 sine/cosine
 *   mass_matrix: 18 multiplications, 14 additions = 32; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 91 multiplications, 55 additions, 3 divisions = 149; 3 unary minus; 4
 *       sine/cosine
 */
#include "puma560_3dof_d4.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 70 multiplications, 49 additions = 119; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d4_inverse_dynamics(
    const puma560_3dof_d4_real q[3],
    const puma560_3dof_d4_real qd[3],
    const puma560_3dof_d4_real qdd[3],
    puma560_3dof_d4_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d4_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d4_real c2 = cos(q[1]);
    const puma560_3dof_d4_real s2 = sin(again[1]);
    const volatile puma560_3dof_d4_real angle23 = q[1] + q[2];
    const puma560_3dof_d4_real c23 = cos(angle23);
    const puma560_3dof_d4_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real alpha3_z = qdd[1] + qdd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d4_real neg_w2_x = qd[0]*s2;
    const puma560_3dof_d4_real neg_w2_y = qd[0]*c2;
    const puma560_3dof_d4_real t1 = 0.1501*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a2_y = s2*t1 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real neg_ww2_yz = qd[1]*neg_w2_y;
    const puma560_3dof_d4_real neg_ww2_zx = qd[1]*neg_w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real neg_alpha2_x = qdd[0]*s2 + neg_ww2_yz;
    const puma560_3dof_d4_real alpha2_y = neg_ww2_zx - qdd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_3dof_d4_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_3dof_d4_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_3dof_d4_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_3dof_d4_real lam2_12 = ww2_xy - qdd[1];
    const puma560_3dof_d4_real lam2_21 = qdd[1] + ww2_xy;
    const puma560_3dof_d4_real lam2_23 = neg_alpha2_x - neg_ww2_yz;
    const puma560_3dof_d4_real neg_lam2_31 = neg_ww2_zx + alpha2_y;
    const puma560_3dof_d4_real neg_lam2_32 = neg_ww2_yz + neg_alpha2_x;
    const puma560_3dof_d4_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a3_z = a2_z - 0.4318*neg_lam2_31;
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real neg_w3_x = qd[0]*s23;
    const puma560_3dof_d4_real neg_w3_y = qd[0]*c23;
    const puma560_3dof_d4_real t2 = 0.4318*neg_lam2_11;
    const puma560_3dof_d4_real t3 = 0.4318*lam2_21;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real neg_a3_x = c23*(t1 + (c2*t2 + s2*t3)) + s23*(s2*t2 - c2*t3 + 9.8);
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_3dof_d4_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real neg_alpha3_x = qdd[0]*s23 + neg_ww3_yz;
    const puma560_3dof_d4_real neg_alpha3_y = qdd[0]*c23 - neg_ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_3dof_d4_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_3dof_d4_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam3_12 = alpha3_z - ww3_xy;
    const puma560_3dof_d4_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_3dof_d4_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_3dof_d4_real lam3_31 = neg_alpha3_y - neg_ww3_zx;
    const puma560_3dof_d4_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    /* link 1: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc1_z = 0.1684918105*qdd[0];
    /* link 2: force that moves the link [N] */
    const puma560_3dof_d4_real neg_fc2_x = 5.74719*neg_lam2_11;
    const puma560_3dof_d4_real fc2_y = 5.74719*lam2_21;
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d4_real neg_nc2_x = 2.4275*neg_lam2_32 - 0.11051088*lam2_21;
    const puma560_3dof_d4_real nc2_y = 5.894500002*neg_lam2_31 + 0.11051088*(neg_lam2_11 -
        neg_lam2_33) + 0.862653219*ww1_zz;
    const puma560_3dof_d4_real nc2_z = 5.894500002*lam2_21 - 2.4275*lam2_12 - 0.11051088*lam2_23 +
        5.74719*a2_y;
    /* link 3: force that moves the link [N] */
    const puma560_3dof_d4_real fc3_x = 4.74117*neg_lam3_12;
    const puma560_3dof_d4_real fc3_y = 4.74117*neg_lam3_22;
    const puma560_3dof_d4_real fc3_z = 4.74117*neg_lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc3_y = -0.4327*lam3_31;
    const puma560_3dof_d4_real neg_nc3_x = 3.874353618*neg_lam3_32 + 4.74117*a3_z;
    const puma560_3dof_d4_real nc3_z = 0.4327*lam3_21 + 3.874353618*neg_lam3_12 - 4.74117*neg_a3_x;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real f03_x = c23*fc3_x - s23*fc3_y;
    const puma560_3dof_d4_real f03_y = s23*fc3_x + c23*fc3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n03_y = c23*nc3_y - s23*neg_nc3_x;
    const puma560_3dof_d4_real t4 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + fc3_z*t4);
    const puma560_3dof_d4_real n02_z = nc3_z + (nc2_z + (f03_y*t4 - f03_x*(0.4318*s2)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real f02_x = f03_x - (c2*neg_fc2_x + s2*fc2_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d4_real n1_z = nc1_z - 0.1501*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques that hold the arm at rest
 * 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine */
void puma560_3dof_d4_gravity(const puma560_3dof_d4_real q[3], puma560_3dof_d4_real tau[3])
{
    /* sines and cosines of the joint angles */
    const puma560_3dof_d4_real c2 = cos(q[1]);
    const volatile puma560_3dof_d4_real angle23 = q[1] + q[2];
    const puma560_3dof_d4_real s23 = sin(angle23);
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d4_real neg_nc2_z = 56.322462*c2;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc3_z = -46.463466*s23;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n02_z = nc3_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 59 multiplications, 29 additions = 88; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d4_bias(
    const puma560_3dof_d4_real q[3],
    const puma560_3dof_d4_real qd[3],
    puma560_3dof_d4_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d4_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d4_real c2 = cos(q[1]);
    const puma560_3dof_d4_real s2 = sin(again[1]);
    const volatile puma560_3dof_d4_real angle23 = q[1] + q[2];
    const puma560_3dof_d4_real c23 = cos(angle23);
    const puma560_3dof_d4_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d4_real neg_w2_x = qd[0]*s2;
    const puma560_3dof_d4_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real neg_alpha2_x = qd[1]*neg_w2_y;
    const puma560_3dof_d4_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_3dof_d4_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_3dof_d4_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_3dof_d4_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_3dof_d4_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a3_z = a2_z - 0.8636*alpha2_y;
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real neg_w3_x = qd[0]*s23;
    const puma560_3dof_d4_real neg_w3_y = qd[0]*c23;
    const puma560_3dof_d4_real t1 = 0.4318*neg_lam2_11;
    const puma560_3dof_d4_real t2 = 0.4318*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real neg_a3_x = c23*(c2*t1 + s2*t2) + s23*(s2*t1 - c2*t2 + 9.8);
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real neg_alpha3_x = w3_z*neg_w3_y;
    const puma560_3dof_d4_real alpha3_y = w3_z*neg_w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_3dof_d4_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_3dof_d4_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam3_22 = ww3_xx + ww3_zz;
    /* link 2: force that moves the link [N] */
    const puma560_3dof_d4_real neg_fc2_x = 5.74719*neg_lam2_11;
    const puma560_3dof_d4_real fc2_y = 5.74719*ww2_xy;
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d4_real neg_nc2_x = 4.855*neg_alpha2_x - 0.11051088*ww2_xy;
    const puma560_3dof_d4_real nc2_y = 11.789000004*alpha2_y + 0.11051088*(neg_lam2_11 -
        neg_lam2_33) + 0.862653219*ww1_zz;
    const puma560_3dof_d4_real nc2_z = 3.467000002*ww2_xy - 56.322462*c2;
    /* link 3: force that moves the link [N] */
    const puma560_3dof_d4_real neg_fc3_x = 4.74117*ww3_xy;
    const puma560_3dof_d4_real fc3_y = 4.74117*neg_lam3_22;
    const puma560_3dof_d4_real fc3_z = 9.48234*neg_alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc3_y = 0.8654*alpha3_y;
    const puma560_3dof_d4_real neg_nc3_x = 7.748707236*neg_alpha3_x + 4.74117*a3_z;
    const puma560_3dof_d4_real nc3_z = -4.74117*neg_a3_x - 3.441653618*ww3_xy;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real neg_f03_x = c23*neg_fc3_x + s23*fc3_y;
    const puma560_3dof_d4_real neg_f03_y = s23*neg_fc3_x - c23*fc3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n03_y = c23*nc3_y - s23*neg_nc3_x;
    const puma560_3dof_d4_real t3 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + fc3_z*t3);
    const puma560_3dof_d4_real n02_z = nc3_z + (nc2_z - (neg_f03_y*t3 - neg_f03_x*(0.4318*s2)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real neg_f02_x = neg_f03_x + (c2*neg_fc2_x + s2*fc2_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d4_real n1_z = 0.1501*neg_f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 18 multiplications, 14 additions = 32; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d4_mass_matrix(const puma560_3dof_d4_real q[3], puma560_3dof_d4_real M[9])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d4_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d4_real c2 = cos(q[1]);
    const puma560_3dof_d4_real s2 = sin(again[1]);
    const volatile puma560_3dof_d4_real angle23 = q[1] + q[2];
    const puma560_3dof_d4_real c23 = cos(angle23);
    const puma560_3dof_d4_real s23 = sin(angle23);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_3dof_d4_real h3_x = 4.74117*s23;
    const puma560_3dof_d4_real h3_y = -4.74117*c23;
    const puma560_3dof_d4_real t1 = 3.441653618*(c23*c23);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real k3_xx = 3.874353618 - t1;
    const puma560_3dof_d4_real k3_yy = t1 + 0.4327;
    const puma560_3dof_d4_real t2 = 0.4318*c2;
    const puma560_3dof_d4_real t3 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m2_3 = t2*h3_x + t3*h3_y + 4.307053618;
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m1_3 = -0.711649617*c23;
    const puma560_3dof_d4_real t4 = k3_xx + t2*(9.48234*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m2_2 = 8.322000002 - (t3*(9.48234*c23) - k3_yy - t4);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real neg_k2_yz = 0.11051088*s2;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_3dof_d4_real h2_y = h3_y + 5.74719*s2;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real k2_xx = t4 + (3.467000002*(c2*c2) + 2.4275);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m1_2 = 0.1501*h2_y - neg_k2_yz;
    const puma560_3dof_d4_real m1_1 = k2_xx + 0.1684918105;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = m2_3;
    M[6] = m1_3;
    M[7] = m2_3;
    M[8] = 4.307053618;
}

/* accelerations that the torques tau give
 * 91 multiplications, 55 additions, 3 divisions = 149; 3 unary minus; 4 sine/cosine */
void puma560_3dof_d4_forward_dynamics(
    const puma560_3dof_d4_real q[3],
    const puma560_3dof_d4_real qd[3],
    const puma560_3dof_d4_real tau[3],
    puma560_3dof_d4_real qdd[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d4_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d4_real c2 = cos(q[1]);
    const puma560_3dof_d4_real s2 = sin(again[1]);
    const volatile puma560_3dof_d4_real angle23 = q[1] + q[2];
    const puma560_3dof_d4_real c23 = cos(angle23);
    const puma560_3dof_d4_real s23 = sin(angle23);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_3dof_d4_real h3_x = 4.74117*s23;
    const puma560_3dof_d4_real h3_y = -4.74117*c23;
    const puma560_3dof_d4_real t1 = 3.441653618*(c23*c23);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real k3_xx = 3.874353618 - t1;
    const puma560_3dof_d4_real k3_yy = t1 + 0.4327;
    const puma560_3dof_d4_real t2 = 0.4318*c2;
    const puma560_3dof_d4_real t3 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m2_3 = t2*h3_x + t3*h3_y + 4.307053618;
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m1_3 = -0.711649617*c23;
    const puma560_3dof_d4_real t4 = k3_xx + t2*(9.48234*s23);
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m2_2 = 8.322000002 - (t3*(9.48234*c23) - k3_yy - t4);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real neg_k2_yz = 0.11051088*s2;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_3dof_d4_real h2_y = h3_y + 5.74719*s2;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d4_real k2_xx = t4 + (3.467000002*(c2*c2) + 2.4275);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d4_real m1_2 = 0.1501*h2_y - neg_k2_yz;
    const puma560_3dof_d4_real m1_1 = k2_xx + 0.1684918105;
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real neg_a2_z = 0.1501*ww1_zz;
    const puma560_3dof_d4_real t5 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d4_real w2_x = t5*s2;
    const puma560_3dof_d4_real w2_y = t5*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real alpha2_x = qd[1]*w2_y;
    const puma560_3dof_d4_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww2_xy = w2_x*w2_y;
    const puma560_3dof_d4_real ww2_xx = w2_x*w2_x;
    const puma560_3dof_d4_real ww2_yy = w2_y*w2_y;
    const puma560_3dof_d4_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_3dof_d4_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real a3_z = 0.8636*neg_alpha2_y - neg_a2_z;
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d4_real w3_x = t5*s23;
    const puma560_3dof_d4_real w3_y = t5*c23;
    const puma560_3dof_d4_real t6 = 0.4318*neg_lam2_11;
    const puma560_3dof_d4_real t7 = 0.4318*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_3dof_d4_real neg_a3_x = c23*(c2*t6 + s2*t7) + s23*(s2*t6 - c2*t7 + 9.8);
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d4_real alpha3_x = w3_z*w3_y;
    const puma560_3dof_d4_real neg_alpha3_y = w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d4_real ww3_xy = w3_x*w3_y;
    const puma560_3dof_d4_real ww3_xx = w3_x*w3_x;
    const puma560_3dof_d4_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d4_real neg_lam3_22 = ww3_xx + ww3_zz;
    /* link 2: force that moves the link [N] */
    const puma560_3dof_d4_real fc2_x = -5.74719*neg_lam2_11;
    const puma560_3dof_d4_real fc2_y = 5.74719*ww2_xy;
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc2_x = 4.855*alpha2_x + 0.11051088*ww2_xy;
    const puma560_3dof_d4_real nc2_y = 0.11051088*(neg_lam2_11 - neg_lam2_33) -
        11.789000004*neg_alpha2_y + 0.862653219*ww1_zz;
    const puma560_3dof_d4_real nc2_z = 3.467000002*ww2_xy - 56.322462*c2;
    /* link 3: force that moves the link [N] */
    const puma560_3dof_d4_real fc3_x = -4.74117*ww3_xy;
    const puma560_3dof_d4_real fc3_y = 4.74117*neg_lam3_22;
    const puma560_3dof_d4_real fc3_z = -9.48234*alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d4_real nc3_y = -0.8654*neg_alpha3_y;
    const puma560_3dof_d4_real nc3_x = 7.748707236*alpha3_x - 4.74117*a3_z;
    const puma560_3dof_d4_real nc3_z = -4.74117*neg_a3_x - 3.441653618*ww3_xy;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real f03_x = c23*fc3_x - s23*fc3_y;
    const puma560_3dof_d4_real f03_y = s23*fc3_x + c23*fc3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n03_y = s23*nc3_x + c23*nc3_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d4_real n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + t2*fc3_z);
    const puma560_3dof_d4_real n02_z = nc3_z + (nc2_z - (t3*f03_x - t2*f03_y));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_3dof_d4_real neg_f02_x = s2*fc2_y - c2*fc2_x - f03_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d4_real n1_z = 0.1501*neg_f02_x - n02_y;
    /* link 1: forward substitution */
    const puma560_3dof_d4_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const puma560_3dof_d4_real ipivot1 = 1.0 / m1_1;
    const puma560_3dof_d4_real l2_1 = m1_2*ipivot1;
    const puma560_3dof_d4_real l3_1 = m1_3*ipivot1;
    const puma560_3dof_d4_real pivot2 = m2_2 - m1_2*l2_1;
    const puma560_3dof_d4_real ipivot2 = 1.0 / pivot2;
    const puma560_3dof_d4_real ld3_2 = m2_3 - m1_2*l3_1;
    const puma560_3dof_d4_real l3_2 = ipivot2*ld3_2;
    const puma560_3dof_d4_real pivot3 = 4.307053618 - m1_3*l3_1 - ld3_2*l3_2;
    const puma560_3dof_d4_real ipivot3 = 1.0 / pivot3;
    /* link 2: forward substitution */
    const puma560_3dof_d4_real y2 = tau[1] - n02_z - y1*l2_1;
    /* link 3: forward substitution */
    const puma560_3dof_d4_real y3 = tau[2] - nc3_z - y1*l3_1 - l3_2*y2;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d4_real qdd3 = ipivot3*y3;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d4_real qdd2 = ipivot2*y2 - l3_2*qdd3;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d4_real qdd1 = -l3_1*qdd3 - (l2_1*qdd2 - y1*ipivot1);
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
