/*
 * puma560: PUMA 560, six joints
 * Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
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
 *   inverse_dynamics: 193 multiplications, 159 additions = 352; 8 unary minus; 10 sine/cosine
 *   gravity: 28 multiplications, 12 additions = 40; 3 unary minus; 8 sine/cosine
 *   bias: 174 multiplications, 129 additions = 303; 8 unary minus; 10 sine/cosine
 *   mass_matrix: 109 multiplications, 92 additions = 201; 3 unary minus; 8 sine/cosine
 *   forward_dynamics: 369 multiplications, 290 additions, 6 divisions = 665; 19 unary minus; 10
 *       sine/cosine
 */
#include "puma560.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 193 multiplications, 159 additions = 352; 8 unary minus; 10 sine/cosine */
void puma560_inverse_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real qdd[6],
    puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c3 = cos(q[2]);
    const puma560_real s3 = sin(again[2]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    const puma560_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_real w2_x = t1*s2;
    const puma560_real w2_y = t1*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_yz = qd[1]*w2_y;
    const puma560_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real alpha2_x = ww2_yz - qdd[0]*s2;
    const puma560_real alpha2_y = -(qdd[0]*c2) - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = w2_x*w2_y;
    const puma560_real ww2_xx = w2_x*w2_x;
    const puma560_real ww2_yy = w2_y*w2_y;
    const puma560_real neg_ww2_zz = -qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam2_11 = neg_ww2_zz - ww2_yy;
    const puma560_real lam2_12 = ww2_xy - qdd[1];
    const puma560_real lam2_13 = ww2_zx + alpha2_y;
    const puma560_real lam2_21 = qdd[1] + ww2_xy;
    const puma560_real lam2_22 = neg_ww2_zz - ww2_xx;
    const puma560_real lam2_23 = ww2_yz - alpha2_x;
    const puma560_real lam2_31 = ww2_zx - alpha2_y;
    const puma560_real lam2_32 = ww2_yz + alpha2_x;
    const puma560_real lam2_33 = -ww2_xx - ww2_yy;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_z = -0.2435*ww1_zz;
    const puma560_real t2 = 0.2435*qdd[0];
    const puma560_real neg_a2_x = c2*t2 + 9.8*s2;
    const puma560_real a2_y = s2*t2 - 9.8*c2;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = c3*w2_x + s3*w2_y;
    const puma560_real w3_y = c3*w2_y - s3*w2_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_x = qd[2]*w3_y - (-c3*alpha2_x - s3*alpha2_y);
    const puma560_real alpha3_y = c3*alpha2_y - s3*alpha2_x - qd[2]*w3_x;
    const puma560_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_yz = w3_y*w3_z;
    const puma560_real ww3_zx = w3_x*w3_z;
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real ww3_xx = w3_x*w3_x;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real lam3_12 = ww3_xy - alpha3_z;
    const puma560_real lam3_13 = alpha3_y + ww3_zx;
    const puma560_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_real lam3_31 = ww3_zx - alpha3_y;
    const puma560_real lam3_32 = alpha3_x + ww3_yz;
    const puma560_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_z = a2_z - (0.0934*lam2_33 - 0.4318*lam2_31);
    const puma560_real t3 = a2_y + (0.4318*lam2_21 - 0.0934*lam2_23);
    const puma560_real t4 = neg_a2_x + (0.0934*lam2_13 - 0.4318*lam2_11);
    const puma560_real a3_x = s3*t3 - c3*t4;
    const puma560_real a3_y = s3*t4 + c3*t3;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = qd[3]*w4_y - (-c4*alpha3_x - s4*alpha3_z);
    const puma560_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const puma560_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_x*w4_z;
    const puma560_real ww4_xy = w4_x*w4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_z = 0.0203*lam3_21 - 0.4331*neg_lam3_22 - a3_y;
    const puma560_real t5 = 0.4331*lam3_12 - 0.0203*neg_lam3_11 - a3_x;
    const puma560_real t6 = 0.0203*lam3_31 + 0.4331*lam3_32 - a3_z;
    const puma560_real a4_x = -(c4*t5) - s4*t6;
    const puma560_real a4_y = s4*t5 - c4*t6;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_real t7 = -s5;
    const puma560_real w5_y = t7*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = t7*alpha4_x - c5*alpha4_z - qd[4]*w5_x;
    const puma560_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real ww5_zx = w5_x*w5_z;
    const puma560_real ww5_xy = w5_x*w5_y;
    const puma560_real ww5_xx = w5_x*w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam5_12 = ww5_xy - alpha5_z;
    const puma560_real lam5_21 = alpha5_z + ww5_xy;
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_real lam5_32 = w5_y*(qd[4] + w5_z) - (s5*alpha4_z - c5*alpha4_x);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x - s5*a4_z;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_real ww6_yz = w6_y*w6_z;
    const puma560_real ww6_zx = w6_x*w6_z;
    /* link 2: force that moves the link [N] */
    const puma560_real fc2_x = 3.79559*lam2_11 + 0.1044*lam2_12;
    const puma560_real fc2_y = 3.79559*lam2_21 + 0.1044*lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_real neg_nc2_x = 0.0016704*(lam2_33 - lam2_22) - 0.0731264*lam2_32 +
        (-0.0070992*lam2_31 - 0.233911466*lam2_21) + 0.0254214*ww1_zz;
    const puma560_real nc2_y = 0.233911466*(lam2_33 - lam2_11) - 1.674987602*lam2_31 +
        (-0.0016704*lam2_12 - 0.0070992*lam2_32) + 0.924226165*ww1_zz;
    const puma560_real t8 = 1.674987602*lam2_21 - 0.0731264*lam2_12 + 0.0070992*(lam2_22 - lam2_11)
        + (0.0016704*lam2_13 - 0.233911466*lam2_23);
    const puma560_real nc2_z = t8 + (3.79559*a2_y + 0.1044*neg_a2_x);
    /* link 3: force that moves the link [N] */
    const puma560_real fc3_x = 0.025375*neg_lam3_11 - 0.861795*lam3_12;
    const puma560_real fc3_y = 0.861795*neg_lam3_22 - 0.025375*lam3_21;
    const puma560_real fc3_z = -0.025375*lam3_31 - 0.861795*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_x = -0.861795*a3_z - (0.004704*(neg_lam3_22 - neg_lam3_33) -
        0.3163401365*lam3_32 - 0.0106736385*lam3_31);
    const puma560_real nc3_y = -0.004704*lam3_12 - 0.0106736385*lam3_32 - 0.0167651125*lam3_31 +
        0.025375*a3_z;
    const puma560_real nc3_z = 0.0167651125*lam3_21 - 0.3163401365*lam3_12 +
        0.0106736385*(neg_lam3_11 - neg_lam3_22) + 0.004704*lam3_13 - (0.025375*a3_y -
        0.861795*a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = -0.0013*ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz + 0.0001*alpha4_x;
    const puma560_real nc4_z = 0.0014*alpha4_z - 0.0001*ww4_xy;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = -0.00288*lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = -0.00288*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_y = -0.0002*lam5_31;
    const puma560_real nc5_x = 0.00044216*lam5_32 - 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 - 0.00044216*lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = -4e-05*ww6_zx;
    const puma560_real nc6_z = 4e-05*alpha6_z;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau6 = nc6_z + 0.193*qdd[5];
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_x = nc5_x + (c6*nc6_x - s6*nc6_y);
    const puma560_real n5_y = nc5_y - nc6_z;
    const puma560_real n5_z = nc5_z + (s6*nc6_x + c6*nc6_y);
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau5 = n5_z + 0.179*qdd[4];
    /* link 4: force through the joint [N] */
    const puma560_real f4_x = c5*fc5_x - s5*fc5_y;
    const puma560_real neg_f4_z = s5*fc5_x + c5*fc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x - (s5*n5_y - c5*n5_x);
    const puma560_real n4_y = nc4_y + n5_z;
    const puma560_real n4_z = nc4_z + (t7*n5_x - c5*n5_y);
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau4 = n4_z + 0.2*qdd[3];
    const puma560_real t9 = s4*f4_x + c4*fc5_z;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*n4_x - s4*n4_y - (0.4331*t9 - nc3_x);
    const puma560_real n3_y = nc3_y + 0.0203*t9 - n4_z;
    const puma560_real t10 = c4*f4_x - s4*fc5_z;
    const puma560_real n3_z = s4*n4_x + c4*n4_y + (nc3_z - (0.0203*neg_f4_z - 0.4331*t10));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + t10;
    const puma560_real f3_y = fc3_y + neg_f4_z;
    const puma560_real f3_z = fc3_z + t9;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau3 = n3_z + 0.83*qdd[2];
    const puma560_real t11 = s3*f3_x + c3*f3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const puma560_real n2_x = c3*n3_x - s3*n3_y + (0.0934*t11 - neg_nc2_x);
    const puma560_real t12 = c3*f3_x - s3*f3_y;
    const puma560_real n2_y = s3*n3_x + c3*n3_y + (nc2_y - (0.0934*t12 + 0.4318*f3_z));
    const puma560_real n2_z = n3_z + (nc2_z + 0.4318*t11);
    /* link 2: force through the joint [N] */
    const puma560_real f2_x = fc2_x + t12;
    const puma560_real f2_y = fc2_y + t11;
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = n2_z + 4.71*qdd[1];
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = 0.2435*(s2*f2_y - c2*f2_x) - (s2*n2_x + c2*n2_y) +
        2.6017295505*qdd[0];
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques that hold the arm at rest
 * 28 multiplications, 12 additions = 40; 3 unary minus; 8 sine/cosine */
void puma560_gravity(const puma560_real q[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c3 = cos(q[2]);
    const puma560_real s3 = sin(again[2]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_x = -9.8*s2;
    const puma560_real a2_y = -9.8*c2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_x = c3*a2_x + s3*a2_y;
    const puma560_real a3_y = c3*a2_y - s3*a2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_x = c4*a3_x;
    const puma560_real neg_a4_y = s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x + s5*a3_y;
    /* link 2: moment that turns the link [N m] */
    const puma560_real nc2_z = 1.02312*s2 - 37.196782*c2;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_z = 0.861795*a3_x - 0.025375*a3_y;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_x = 0.00288*neg_a4_y;
    const puma560_real nc5_z = 0.00288*a5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = c5*nc5_x;
    const puma560_real n4_z = -s5*nc5_x;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*n4_x - s4*nc5_z;
    const puma560_real n3_z = nc3_z - (-s4*n4_x - c4*nc5_z);
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n2_x = -c3*n3_x - s3*n4_z;
    const puma560_real n2_y = s3*n3_x - c3*n4_z;
    const puma560_real n2_z = nc2_z + n3_z;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_real n1_z = s2*neg_n2_x - c2*n2_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 174 multiplications, 129 additions = 303; 8 unary minus; 10 sine/cosine */
void puma560_bias(const puma560_real q[6], const puma560_real qd[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c3 = cos(q[2]);
    const puma560_real s3 = sin(again[2]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    const puma560_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_real w2_x = t1*s2;
    const puma560_real w2_y = t1*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real alpha2_x = qd[1]*w2_y;
    const puma560_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = w2_x*w2_y;
    const puma560_real ww2_xx = w2_x*w2_x;
    const puma560_real ww2_yy = w2_y*w2_y;
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_z = -0.2435*ww1_zz;
    const puma560_real a2_x = -9.8*s2;
    const puma560_real a2_y = -9.8*c2;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = c3*w2_x + s3*w2_y;
    const puma560_real w3_y = c3*w2_y - s3*w2_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_x = qd[2]*w3_y - (-c3*alpha2_x - s3*alpha2_y);
    const puma560_real alpha3_y = c3*alpha2_y - s3*alpha2_x - qd[2]*w3_x;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_yz = w3_y*w3_z;
    const puma560_real ww3_zx = w3_x*w3_z;
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real neg_ww3_xx = -w3_x*w3_x;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real lam3_13 = alpha3_y + ww3_zx;
    const puma560_real lam3_22 = neg_ww3_xx - ww3_zz;
    const puma560_real lam3_31 = ww3_zx - alpha3_y;
    const puma560_real lam3_32 = alpha3_x + ww3_yz;
    const puma560_real lam3_33 = neg_ww3_xx - ww3_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_z = a2_z - (0.8636*alpha2_y - 0.0934*neg_lam2_33);
    const puma560_real t2 = 0.4318*neg_lam2_11 - a2_x;
    const puma560_real t3 = -0.4318*ww2_xy - a2_y;
    const puma560_real neg_a3_x = c3*t2 + s3*t3;
    const puma560_real a3_y = s3*t2 - c3*t3;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_real alpha4_y = -s4*alpha3_x - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_x*w4_z;
    const puma560_real ww4_xy = w4_x*w4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_z = 0.0203*ww3_xy + 0.4331*lam3_22 - a3_y;
    const puma560_real t4 = neg_a3_x + (0.4331*ww3_xy - 0.0203*neg_lam3_11);
    const puma560_real t5 = 0.0203*lam3_31 + 0.4331*lam3_32 - a3_z;
    const puma560_real a4_x = -(c4*t4) - s4*t5;
    const puma560_real a4_y = s4*t4 - c4*t5;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_real t6 = -s5;
    const puma560_real w5_y = t6*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real ww5_zx = w5_x*w5_z;
    const puma560_real ww5_xy = w5_x*w5_y;
    const puma560_real ww5_xx = w5_x*w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_real lam5_21 = alpha4_y + ww5_xy;
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_real lam5_32 = w5_y*(qd[4] + w5_z) - (-c5*alpha4_x - s5*alpha3_y);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x - s5*a4_z;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_real w6_y = c6*w5_z - s6*w5_x;
    const puma560_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_real ww6_yz = w6_y*w6_z;
    const puma560_real ww6_zx = w6_x*w6_z;
    /* link 2: force that moves the link [N] */
    const puma560_real fc2_x = 0.1044*ww2_xy - 3.79559*neg_lam2_11;
    const puma560_real fc2_y = 3.79559*ww2_xy - 0.1044*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_real neg_nc2_x = 0.0016704*(neg_lam2_22 - neg_lam2_33) - 0.1462528*alpha2_x +
        (0.0141984*alpha2_y - 0.233911466*ww2_xy) + 0.0254214*ww1_zz;
    const puma560_real nc2_y = 3.349975204*alpha2_y + 0.233911466*(neg_lam2_11 - neg_lam2_33) -
        (0.0016704*ww2_xy + 0.0141984*alpha2_x) + 0.924226165*ww1_zz;
    const puma560_real nc2_z = 1.601861202*ww2_xy + 0.0070992*(neg_lam2_11 - neg_lam2_22) -
        (37.196782*c2 - 1.02312*s2);
    /* link 3: force that moves the link [N] */
    const puma560_real fc3_x = 0.025375*neg_lam3_11 - 0.861795*ww3_xy;
    const puma560_real fc3_y = -0.025375*ww3_xy - 0.861795*lam3_22;
    const puma560_real fc3_z = -0.025375*lam3_31 - 0.861795*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_x = -0.861795*a3_z - (0.004704*(lam3_33 - lam3_22) - 0.3163401365*lam3_32
        - 0.0106736385*lam3_31);
    const puma560_real nc3_y = -0.004704*ww3_xy - 0.0106736385*lam3_32 - 0.0167651125*lam3_31 +
        0.025375*a3_z;
    const puma560_real nc3_z = 0.0106736385*(neg_lam3_11 + lam3_22) - 0.299575024*ww3_xy +
        0.004704*lam3_13 - (0.025375*a3_y + 0.861795*neg_a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = -0.0013*ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz + 0.0001*alpha4_x;
    const puma560_real nc4_z = -0.0001*ww4_xy - 0.0014*alpha3_y;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = -0.00288*lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = -0.00288*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_y = -0.0002*lam5_31;
    const puma560_real nc5_x = 0.00044216*lam5_32 - 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 - 0.00044216*lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = -4e-05*ww6_zx;
    const puma560_real nc6_z = -4e-05*alpha5_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_x = nc5_x + (c6*nc6_x - s6*nc6_y);
    const puma560_real n5_y = nc5_y - nc6_z;
    const puma560_real n5_z = nc5_z + (s6*nc6_x + c6*nc6_y);
    /* link 4: force through the joint [N] */
    const puma560_real f4_x = c5*fc5_x - s5*fc5_y;
    const puma560_real neg_f4_z = s5*fc5_x + c5*fc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x - (s5*n5_y - c5*n5_x);
    const puma560_real n4_y = nc4_y + n5_z;
    const puma560_real n4_z = nc4_z + (t6*n5_x - c5*n5_y);
    const puma560_real t7 = s4*f4_x + c4*fc5_z;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*n4_x - s4*n4_y - (0.4331*t7 - nc3_x);
    const puma560_real n3_y = nc3_y + 0.0203*t7 - n4_z;
    const puma560_real t8 = c4*f4_x - s4*fc5_z;
    const puma560_real n3_z = s4*n4_x + c4*n4_y + (nc3_z - (0.0203*neg_f4_z - 0.4331*t8));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + t8;
    const puma560_real f3_y = fc3_y + neg_f4_z;
    const puma560_real f3_z = fc3_z + t7;
    const puma560_real t9 = s3*f3_x + c3*f3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const puma560_real n2_x = c3*n3_x - s3*n3_y + (0.0934*t9 - neg_nc2_x);
    const puma560_real t10 = c3*f3_x - s3*f3_y;
    const puma560_real n2_y = s3*n3_x + c3*n3_y + (nc2_y - (0.0934*t10 + 0.4318*f3_z));
    const puma560_real n2_z = n3_z + (nc2_z + 0.4318*t9);
    /* link 2: force through the joint [N] */
    const puma560_real f2_x = fc2_x + t10;
    const puma560_real f2_y = fc2_y + t9;
    /* link 1: force through the joint [N] */
    const puma560_real neg_f1_x = s2*f2_y - c2*f2_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_real n1_z = 0.2435*neg_f1_x - (s2*n2_x + c2*n2_y);
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 109 multiplications, 92 additions = 201; 3 unary minus; 8 sine/cosine */
void puma560_mass_matrix(const puma560_real q[6], puma560_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c3 = cos(q[2]);
    const puma560_real s3 = sin(again[2]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_x = 4e-05*s5;
    const puma560_real nu4_z = 4e-05*c5;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_x = c4*nu4_x;
    const puma560_real nu3_z = s4*nu4_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_x = c3*nu3_x + s3*nu4_z;
    const puma560_real nu2_y = s3*nu3_x - c3*nu4_z;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z = -(s2*nu2_x) - c2*nu2_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_real fu4_x = 0.00288*c5;
    const puma560_real fu4_z = -0.00288*s5;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x = c4*fu4_x;
    const puma560_real fu3_z = s4*fu4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = 0.0203*fu3_z;
    const puma560_real nu3_x_2 = -0.4331*fu3_z - 0.00064216*s4;
    const puma560_real nu3_z_2 = 0.00064216*c4 - (5.8464e-05*s5 - 0.4331*fu3_x);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x = c3*fu3_x + s3*fu4_z;
    const puma560_real fu2_y = s3*fu3_x - c3*fu4_z;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu2_x = s3*nu3_y - c3*nu3_x_2 - 0.0934*fu2_y;
    const puma560_real nu2_y_2 = s3*nu3_x_2 + c3*nu3_y - (0.0934*fu2_x + 0.4318*fu3_z);
    const puma560_real nu2_z = nu3_z_2 + 0.4318*fu2_y;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x = c2*fu2_x - s2*fu2_y;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2 - 0.2435*fu1_x;
    const puma560_real t1 = 0.00020216*(c5*c5);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_real k4_zz = t1 + 0.00022;
    const puma560_real k4_xz = 0.00020216*(c5*s5);
    const puma560_real k4_xx = 0.00107216 - t1;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = 0.20184216 - t1;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x_2 = s4*fu4_z;
    const puma560_real fu3_z_2 = -c4*fu4_z;
    const puma560_real t2 = c4*k4_xz;
    const puma560_real t3 = 0.4331*fu3_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu3_x = t2 + t3;
    const puma560_real nu3_y_2 = t1 - 0.00184216 + 0.0203*fu3_z_2;
    const puma560_real nu3_z_3 = 0.4331*fu3_x_2 - s4*k4_xz;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x_2 = c3*fu3_x_2;
    const puma560_real fu2_y_2 = s3*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2 - 0.0934*fu2_y_2;
    const puma560_real nu2_y_3 = -0.0934*fu2_x_2 - 0.4318*fu3_z_2 - (s3*neg_nu3_x - c3*nu3_y_2);
    const puma560_real nu2_z_2 = nu3_z_3 + 0.4318*fu2_y_2;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_3 = s2*neg_nu2_x_2 - c2*nu2_y_3 - 0.2435*fu1_x_2;
    const puma560_real t4 = t1 - 0.00030216;
    const puma560_real t5 = c4*c4*t4;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_zz = k4_xx + t5;
    const puma560_real neg_k3_xz = t4*(c4*s4) - 0.0203*fu3_x_2;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h3_x = fu3_z_2 - 0.025375;
    const puma560_real neg_h3_y = fu4_x + 0.861795;
    const puma560_real t6 = t5 - 0.00077 + 0.0406*fu3_z_2;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_xx = 0.0167651125 - t6;
    const puma560_real t7 = k4_zz + 0.002494656*c5;
    const puma560_real k3_yy = t7 + 0.3156901365;
    const puma560_real k3_xy = 0.0106736385 - (t3 + (t2 - 5.8464e-05*c5));
    const puma560_real k3_yz = nu3_z_3 - 0.004704;
    const puma560_real t8 = t6 - t7;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = 1.162455249 - t8;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x_3 = c3*neg_h3_y - s3*h3_x;
    const puma560_real fu2_y_3 = s3*neg_h3_y + c3*h3_x;
    const puma560_real t9 = c3*neg_k3_xz + s3*k3_yz;
    const puma560_real t10 = 0.0934*fu2_y_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_x_2 = t9 + t10;
    const puma560_real nu2_y_4 = s3*neg_k3_xz - c3*k3_yz - 0.0934*fu2_x_3;
    const puma560_real nu2_z_3 = 0.4318*fu2_y_3 - (t8 - 0.332455249);
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_4 = -0.2435*fu1_x_3 - (s2*nu2_x_2 + c2*nu2_y_4);
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_x = fu2_y_3 + 3.79559;
    const puma560_real neg_h2_y = fu2_x_3 - 0.1044;
    const puma560_real t11 = t6 + t7 + 0.298925024;
    const puma560_real t12 = c3*s3;
    const puma560_real t13 = c3*c3;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xy = 0.0070992 - (t11*t12 - k3_xy*(2.0*t13 - 1.0) + 0.4318*fu2_x_3);
    const puma560_real neg_k2_xz = t10 + (t9 + 0.4318*fu3_x_2) + 0.233911466;
    const puma560_real k2_yz = -nu2_y_4 - 0.0016704;
    const puma560_real t14 = k3_xy*(-2.0*t12) - t13*t11;
    const puma560_real t15 = t14 - k3_xx;
    const puma560_real t16 = k3_zz + t15;
    const puma560_real t17 = t16 - k3_zz;
    const puma560_real t18 = k3_yy + t14 + 0.8636*fu2_y_3;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = 6.458114002 - (t17 - t18);
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_4 = c2*neg_h2_y - s2*h2_x;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_5 = -0.2435*fu1_x_4 - (s2*neg_k2_xz - c2*k2_yz);
    const puma560_real t19 = c2*c2*(t17 + t18 + 1.601861202) - (t17 - 0.0731264) -
        k2_xy*(2.0*(c2*s2));
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_1 = -0.3002*fu3_x_2 - (t15 - t19 - t16 - 2.6017295505);
    M[0] = m1_1;
    M[1] = nu1_z_5;
    M[2] = nu1_z_4;
    M[3] = nu1_z_3;
    M[4] = nu1_z_2;
    M[5] = nu1_z;
    M[6] = nu1_z_5;
    M[7] = m2_2;
    M[8] = nu2_z_3;
    M[9] = nu2_z_2;
    M[10] = nu2_z;
    M[11] = nu3_z;
    M[12] = nu1_z_4;
    M[13] = nu2_z_3;
    M[14] = m3_3;
    M[15] = nu3_z_3;
    M[16] = nu3_z_2;
    M[17] = nu3_z;
    M[18] = nu1_z_3;
    M[19] = nu2_z_2;
    M[20] = nu3_z_3;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = nu4_z;
    M[24] = nu1_z_2;
    M[25] = nu2_z;
    M[26] = nu3_z_2;
    M[27] = 0.0;
    M[28] = 0.17964216;
    M[29] = 0.0;
    M[30] = nu1_z;
    M[31] = nu3_z;
    M[32] = nu3_z;
    M[33] = nu4_z;
    M[34] = 0.0;
    M[35] = 0.19304;
}

/* accelerations that the torques tau give
 * 369 multiplications, 290 additions, 6 divisions = 665; 19 unary minus; 10 sine/cosine */
void puma560_forward_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real tau[6],
    puma560_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c3 = cos(q[2]);
    const puma560_real s3 = sin(again[2]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_x = 4e-05*s5;
    const puma560_real nu4_z = 4e-05*c5;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_x = c4*nu4_x;
    const puma560_real nu3_z = s4*nu4_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_x = c3*nu3_x + s3*nu4_z;
    const puma560_real nu2_y = s3*nu3_x - c3*nu4_z;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z = -(s2*nu2_x) - c2*nu2_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_real fu4_x = 0.00288*c5;
    const puma560_real fu4_z = -0.00288*s5;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x = c4*fu4_x;
    const puma560_real fu3_z = s4*fu4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = 0.0203*fu3_z;
    const puma560_real nu3_x_2 = -0.4331*fu3_z - 0.00064216*s4;
    const puma560_real nu3_z_2 = 0.00064216*c4 - (5.8464e-05*s5 - 0.4331*fu3_x);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x = c3*fu3_x + s3*fu4_z;
    const puma560_real fu2_y = s3*fu3_x - c3*fu4_z;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu2_x = s3*nu3_y - c3*nu3_x_2 - 0.0934*fu2_y;
    const puma560_real nu2_y_2 = s3*nu3_x_2 + c3*nu3_y - (0.0934*fu2_x + 0.4318*fu3_z);
    const puma560_real nu2_z = nu3_z_2 + 0.4318*fu2_y;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x = c2*fu2_x - s2*fu2_y;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_2 = s2*neg_nu2_x - c2*nu2_y_2 - 0.2435*fu1_x;
    const puma560_real t1 = 0.00020216*(c5*c5);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_real k4_zz = t1 + 0.00022;
    const puma560_real k4_xz = 0.00020216*(c5*s5);
    const puma560_real k4_xx = 0.00107216 - t1;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = 0.20184216 - t1;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x_2 = s4*fu4_z;
    const puma560_real fu3_z_2 = -c4*fu4_z;
    const puma560_real t2 = c4*k4_xz;
    const puma560_real t3 = 0.4331*fu3_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu3_x = t2 + t3;
    const puma560_real nu3_y_2 = t1 - 0.00184216 + 0.0203*fu3_z_2;
    const puma560_real nu3_z_3 = 0.4331*fu3_x_2 - s4*k4_xz;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x_2 = c3*fu3_x_2;
    const puma560_real fu2_y_2 = s3*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2 - 0.0934*fu2_y_2;
    const puma560_real nu2_y_3 = -0.0934*fu2_x_2 - 0.4318*fu3_z_2 - (s3*neg_nu3_x - c3*nu3_y_2);
    const puma560_real nu2_z_2 = nu3_z_3 + 0.4318*fu2_y_2;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_3 = s2*neg_nu2_x_2 - c2*nu2_y_3 - 0.2435*fu1_x_2;
    const puma560_real t4 = t1 - 0.00030216;
    const puma560_real t5 = c4*c4*t4;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_zz = k4_xx + t5;
    const puma560_real neg_k3_xz = t4*(c4*s4) - 0.0203*fu3_x_2;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h3_x = fu3_z_2 - 0.025375;
    const puma560_real neg_h3_y = fu4_x + 0.861795;
    const puma560_real t6 = t5 - 0.00077 + 0.0406*fu3_z_2;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_xx = 0.0167651125 - t6;
    const puma560_real t7 = k4_zz + 0.002494656*c5;
    const puma560_real k3_yy = t7 + 0.3156901365;
    const puma560_real k3_xy = 0.0106736385 - (t3 + (t2 - 5.8464e-05*c5));
    const puma560_real k3_yz = nu3_z_3 - 0.004704;
    const puma560_real t8 = t6 - t7;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = 1.162455249 - t8;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_real fu2_x_3 = c3*neg_h3_y - s3*h3_x;
    const puma560_real fu2_y_3 = s3*neg_h3_y + c3*h3_x;
    const puma560_real t9 = c3*neg_k3_xz + s3*k3_yz;
    const puma560_real t10 = 0.0934*fu2_y_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_x_2 = t9 + t10;
    const puma560_real nu2_y_4 = s3*neg_k3_xz - c3*k3_yz - 0.0934*fu2_x_3;
    const puma560_real nu2_z_3 = 0.4318*fu2_y_3 - (t8 - 0.332455249);
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_4 = -0.2435*fu1_x_3 - (s2*nu2_x_2 + c2*nu2_y_4);
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_x = fu2_y_3 + 3.79559;
    const puma560_real neg_h2_y = fu2_x_3 - 0.1044;
    const puma560_real t11 = t6 + t7 + 0.298925024;
    const puma560_real t12 = c3*s3;
    const puma560_real t13 = c3*c3;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xy = 0.0070992 - (t11*t12 - k3_xy*(2.0*t13 - 1.0) + 0.4318*fu2_x_3);
    const puma560_real neg_k2_xz = t10 + (t9 + 0.4318*fu3_x_2) + 0.233911466;
    const puma560_real k2_yz = -nu2_y_4 - 0.0016704;
    const puma560_real t14 = k3_xy*(-2.0*t12) - t13*t11;
    const puma560_real t15 = t14 - k3_xx;
    const puma560_real t16 = k3_zz + t15;
    const puma560_real t17 = t16 - k3_zz;
    const puma560_real t18 = k3_yy + t14 + 0.8636*fu2_y_3;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = 6.458114002 - (t17 - t18);
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_real fu1_x_4 = c2*neg_h2_y - s2*h2_x;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_real nu1_z_5 = -0.2435*fu1_x_4 - (s2*neg_k2_xz - c2*k2_yz);
    const puma560_real t19 = c2*c2*(t17 + t18 + 1.601861202) - (t17 - 0.0731264) -
        k2_xy*(2.0*(c2*s2));
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_1 = -0.3002*fu3_x_2 - (t15 - t19 - t16 - 2.6017295505);
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    const puma560_real t20 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_real w2_x = t20*s2;
    const puma560_real w2_y = t20*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real alpha2_x = qd[1]*w2_y;
    const puma560_real alpha2_y = -qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = w2_x*w2_y;
    const puma560_real ww2_xx = w2_x*w2_x;
    const puma560_real ww2_yy = w2_y*w2_y;
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_z = -0.2435*ww1_zz;
    const puma560_real a2_x = -9.8*s2;
    const puma560_real a2_y = -9.8*c2;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = c3*w2_x + s3*w2_y;
    const puma560_real w3_y = c3*w2_y - s3*w2_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_x = qd[2]*w3_y - (-c3*alpha2_x - s3*alpha2_y);
    const puma560_real alpha3_y = c3*alpha2_y - s3*alpha2_x - qd[2]*w3_x;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_yz = w3_y*w3_z;
    const puma560_real ww3_zx = w3_x*w3_z;
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real neg_ww3_xx = -w3_x*w3_x;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real lam3_13 = alpha3_y + ww3_zx;
    const puma560_real lam3_22 = neg_ww3_xx - ww3_zz;
    const puma560_real lam3_31 = ww3_zx - alpha3_y;
    const puma560_real lam3_32 = alpha3_x + ww3_yz;
    const puma560_real lam3_33 = neg_ww3_xx - ww3_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_z = a2_z - (0.8636*alpha2_y - 0.0934*neg_lam2_33);
    const puma560_real t21 = 0.4318*neg_lam2_11 - a2_x;
    const puma560_real t22 = -0.4318*ww2_xy - a2_y;
    const puma560_real neg_a3_x = c3*t21 + s3*t22;
    const puma560_real a3_y = s3*t21 - c3*t22;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_real alpha4_y = -s4*alpha3_x - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_x*w4_z;
    const puma560_real ww4_xy = w4_x*w4_y;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_z = 0.0203*ww3_xy + 0.4331*lam3_22 - a3_y;
    const puma560_real t23 = neg_a3_x + (0.4331*ww3_xy - 0.0203*neg_lam3_11);
    const puma560_real t24 = 0.0203*lam3_31 + 0.4331*lam3_32 - a3_z;
    const puma560_real a4_x = -(c4*t23) - s4*t24;
    const puma560_real a4_y = s4*t23 - c4*t24;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_real t25 = -s5;
    const puma560_real w5_y = t25*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real ww5_zx = w5_x*w5_z;
    const puma560_real ww5_xy = w5_x*w5_y;
    const puma560_real ww5_xx = w5_x*w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_real lam5_21 = alpha4_y + ww5_xy;
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_real lam5_32 = w5_y*(qd[4] + w5_z) - (-c5*alpha4_x - s5*alpha3_y);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x - s5*a4_z;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_real w6_y = c6*w5_z - s6*w5_x;
    const puma560_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_real ww6_yz = w6_y*w6_z;
    const puma560_real ww6_zx = w6_x*w6_z;
    /* link 2: force that moves the link [N] */
    const puma560_real fc2_x = 0.1044*ww2_xy - 3.79559*neg_lam2_11;
    const puma560_real fc2_y = 3.79559*ww2_xy - 0.1044*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_real neg_nc2_x = 0.0016704*(neg_lam2_22 - neg_lam2_33) - 0.1462528*alpha2_x +
        (0.0141984*alpha2_y - 0.233911466*ww2_xy) + 0.0254214*ww1_zz;
    const puma560_real nc2_y = 3.349975204*alpha2_y + 0.233911466*(neg_lam2_11 - neg_lam2_33) -
        (0.0016704*ww2_xy + 0.0141984*alpha2_x) + 0.924226165*ww1_zz;
    const puma560_real nc2_z = 1.601861202*ww2_xy + 0.0070992*(neg_lam2_11 - neg_lam2_22) -
        (37.196782*c2 - 1.02312*s2);
    /* link 3: force that moves the link [N] */
    const puma560_real fc3_x = 0.025375*neg_lam3_11 - 0.861795*ww3_xy;
    const puma560_real fc3_y = -0.025375*ww3_xy - 0.861795*lam3_22;
    const puma560_real fc3_z = -0.025375*lam3_31 - 0.861795*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_x = -0.861795*a3_z - (0.004704*(lam3_33 - lam3_22) - 0.3163401365*lam3_32
        - 0.0106736385*lam3_31);
    const puma560_real nc3_y = -0.004704*ww3_xy - 0.0106736385*lam3_32 - 0.0167651125*lam3_31 +
        0.025375*a3_z;
    const puma560_real nc3_z = 0.0106736385*(neg_lam3_11 + lam3_22) - 0.299575024*ww3_xy +
        0.004704*lam3_13 - (0.025375*a3_y + 0.861795*neg_a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = -0.0013*ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz + 0.0001*alpha4_x;
    const puma560_real nc4_z = -0.0001*ww4_xy - 0.0014*alpha3_y;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = -0.00288*lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = -0.00288*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_y = -0.0002*lam5_31;
    const puma560_real nc5_x = 0.00044216*lam5_32 - 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 - 0.00044216*lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = -4e-05*ww6_zx;
    const puma560_real nc6_z = -4e-05*alpha5_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_x = nc5_x + (c6*nc6_x - s6*nc6_y);
    const puma560_real n5_y = nc5_y - nc6_z;
    const puma560_real n5_z = nc5_z + (s6*nc6_x + c6*nc6_y);
    /* link 4: force through the joint [N] */
    const puma560_real f4_x = c5*fc5_x - s5*fc5_y;
    const puma560_real neg_f4_z = s5*fc5_x + c5*fc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x - (s5*n5_y - c5*n5_x);
    const puma560_real n4_y = nc4_y + n5_z;
    const puma560_real n4_z = nc4_z + (t25*n5_x - c5*n5_y);
    const puma560_real t26 = s4*f4_x + c4*fc5_z;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*n4_x - s4*n4_y - (0.4331*t26 - nc3_x);
    const puma560_real n3_y = nc3_y + 0.0203*t26 - n4_z;
    const puma560_real t27 = c4*f4_x - s4*fc5_z;
    const puma560_real n3_z = s4*n4_x + c4*n4_y + (nc3_z - (0.0203*neg_f4_z - 0.4331*t27));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + t27;
    const puma560_real f3_y = fc3_y + neg_f4_z;
    const puma560_real f3_z = fc3_z + t26;
    const puma560_real t28 = s3*f3_x + c3*f3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const puma560_real n2_x = c3*n3_x - s3*n3_y + (0.0934*t28 - neg_nc2_x);
    const puma560_real t29 = c3*f3_x - s3*f3_y;
    const puma560_real n2_y = s3*n3_x + c3*n3_y + (nc2_y - (0.0934*t29 + 0.4318*f3_z));
    const puma560_real n2_z = n3_z + (nc2_z + 0.4318*t28);
    /* link 2: force through the joint [N] */
    const puma560_real f2_x = fc2_x + t29;
    const puma560_real f2_y = fc2_y + t28;
    /* link 1: force through the joint [N] */
    const puma560_real neg_f1_x = s2*f2_y - c2*f2_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_real n1_z = 0.2435*neg_f1_x - (s2*n2_x + c2*n2_y);
    /* link 1: forward substitution */
    const puma560_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const puma560_real ipivot1 = 1.0 / m1_1;
    const puma560_real l2_1 = nu1_z_5*ipivot1;
    const puma560_real l3_1 = nu1_z_4*ipivot1;
    const puma560_real l4_1 = nu1_z_3*ipivot1;
    const puma560_real l5_1 = nu1_z_2*ipivot1;
    const puma560_real l6_1 = nu1_z*ipivot1;
    const puma560_real pivot2 = m2_2 - nu1_z_5*l2_1;
    const puma560_real ipivot2 = 1.0 / pivot2;
    const puma560_real ld3_2 = nu2_z_3 - nu1_z_5*l3_1;
    const puma560_real l3_2 = ipivot2*ld3_2;
    const puma560_real ld4_2 = nu2_z_2 - nu1_z_5*l4_1;
    const puma560_real l4_2 = ipivot2*ld4_2;
    const puma560_real ld5_2 = nu2_z - nu1_z_5*l5_1;
    const puma560_real l5_2 = ipivot2*ld5_2;
    const puma560_real ld6_2 = nu3_z - nu1_z_5*l6_1;
    const puma560_real l6_2 = ipivot2*ld6_2;
    const puma560_real pivot3 = m3_3 - nu1_z_4*l3_1 - ld3_2*l3_2;
    const puma560_real ipivot3 = 1.0 / pivot3;
    const puma560_real ld4_3 = -ld3_2*l4_2 - (nu1_z_4*l4_1 - nu3_z_3);
    const puma560_real l4_3 = ipivot3*ld4_3;
    const puma560_real ld5_3 = nu3_z_2 - nu1_z_4*l5_1 - ld3_2*l5_2;
    const puma560_real l5_3 = ipivot3*ld5_3;
    const puma560_real ld6_3 = nu3_z - nu1_z_4*l6_1 - ld3_2*l6_2;
    const puma560_real l6_3 = ipivot3*ld6_3;
    const puma560_real pivot4 = -ld4_3*l4_3 - (ld4_2*l4_2 - (m4_4 - nu1_z_3*l4_1));
    const puma560_real ipivot4 = 1.0 / pivot4;
    const puma560_real ld5_4 = -nu1_z_3*l5_1 - ld4_2*l5_2 - ld4_3*l5_3;
    const puma560_real l5_4 = ipivot4*ld5_4;
    const puma560_real ld6_4 = nu4_z - nu1_z_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3;
    const puma560_real l6_4 = ipivot4*ld6_4;
    const puma560_real pivot5 = 0.17964216 - nu1_z_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const puma560_real ipivot5 = 1.0 / pivot5;
    const puma560_real ld6_5 = -ld5_4*l6_4 - (nu1_z_2*l6_1 + ld5_2*l6_2 + ld5_3*l6_3);
    const puma560_real l6_5 = ipivot5*ld6_5;
    const puma560_real pivot6 = 0.19304 - nu1_z*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4 -
        ld6_5*l6_5;
    const puma560_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const puma560_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const puma560_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const puma560_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const puma560_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const puma560_real y6 = tau[5] - nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4);
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd2 = -l6_2*qdd6 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5);
    const puma560_real t30 = -l5_1*qdd5 - (l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd1 = t30 - l6_1*qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
