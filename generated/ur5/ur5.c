/*
 * ur5: Universal Robots UR5
 * Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
 * Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
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
 *   inverse_dynamics: 153 multiplications, 113 additions = 266; 0 unary minus; 10 sine/cosine
 *   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
 *   bias: 136 multiplications, 79 additions = 215; 5 unary minus; 10 sine/cosine
 *   mass_matrix: 54 multiplications, 53 additions = 107; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 272 multiplications, 200 additions, 6 divisions = 478; 15 unary minus; 10
 *       sine/cosine
 */
#include "ur5.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 153 multiplications, 113 additions = 266; 0 unary minus; 10 sine/cosine */
void ur5_inverse_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real qdd[6],
    ur5_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile ur5_real *const again = q;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(again[1]);
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(again[4]);
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(again[5]);
    const volatile ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const ur5_real alpha3_z = qdd[1] + qdd[2];
    /* sines and cosines of the joint angles */
    const volatile ur5_real angle2to4 = q[3] + angle23;
    const ur5_real c2to4 = cos(angle2to4);
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = qd[3] + w3_z;
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_z = qdd[3] + alpha3_z;
    /* link 1: products of the angular velocity [1/s^2] */
    const ur5_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a2_z = -0.10915*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const ur5_real neg_w2_x = qd[0]*s2;
    const ur5_real neg_w2_y = qd[0]*c2;
    const ur5_real t1 = 0.10915*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a2_y = s2*t1 - 9.81*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real neg_ww2_yz = qd[1]*neg_w2_y;
    const ur5_real neg_ww2_zx = qd[1]*neg_w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const ur5_real neg_alpha2_x = qdd[0]*s2 + neg_ww2_yz;
    const ur5_real alpha2_y = neg_ww2_zx - qdd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_xy = neg_w2_x*neg_w2_y;
    const ur5_real ww2_xx = neg_w2_x*neg_w2_x;
    const ur5_real ww2_yy = neg_w2_y*neg_w2_y;
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam2_11 = ww2_yy + ww2_zz;
    const ur5_real lam2_12 = ww2_xy - qdd[1];
    const ur5_real lam2_21 = qdd[1] + ww2_xy;
    const ur5_real lam2_23 = neg_alpha2_x - neg_ww2_yz;
    const ur5_real neg_lam2_31 = neg_ww2_zx + alpha2_y;
    const ur5_real neg_lam2_32 = neg_ww2_yz + neg_alpha2_x;
    const ur5_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_z = a2_z - 0.425*neg_lam2_31;
    /* link 3: angular velocity [rad/s] */
    const ur5_real neg_w3_x = qd[0]*s23;
    const ur5_real neg_w3_y = qd[0]*c23;
    const ur5_real t2 = 0.425*neg_lam2_11;
    const ur5_real t3 = 0.425*lam2_21;
    const ur5_real t4 = t1 + (c2*t2 + s2*t3);
    const ur5_real t5 = s2*t2 - c2*t3 + 9.81;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_y = s23*t4 - c23*t5;
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real neg_ww3_yz = w3_z*neg_w3_y;
    const ur5_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const ur5_real neg_alpha3_x = qdd[0]*s23 + neg_ww3_yz;
    const ur5_real neg_alpha3_y = qdd[0]*c23 - neg_ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_xy = neg_w3_x*neg_w3_y;
    const ur5_real ww3_xx = neg_w3_x*neg_w3_x;
    const ur5_real ww3_yy = neg_w3_y*neg_w3_y;
    const ur5_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam3_11 = ww3_yy + ww3_zz;
    const ur5_real lam3_12 = ww3_xy - alpha3_z;
    const ur5_real lam3_21 = alpha3_z + ww3_xy;
    const ur5_real lam3_23 = neg_alpha3_x - neg_ww3_yz;
    const ur5_real lam3_31 = neg_alpha3_y - neg_ww3_zx;
    const ur5_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    const ur5_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_z = a3_z + 0.39225*lam3_31;
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    const ur5_real w4_y = qd[0]*c2to4;
    const ur5_real t6 = 0.39225*neg_lam3_11;
    const ur5_real t7 = 0.39225*lam3_21;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_x = c2to4*(t4 + (c23*t6 + s23*t7)) + s2to4*(t5 + (s23*t6 - c23*t7));
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_yz = w4_z*w4_y;
    const ur5_real ww4_zx = w4_z*w4_x;
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_x = qdd[0]*s2to4 + ww4_yz;
    const ur5_real alpha4_y = qdd[0]*c2to4 - ww4_zx;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_xy = w4_x*w4_y;
    const ur5_real ww4_xx = w4_x*w4_x;
    const ur5_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam4_12 = alpha4_z - ww4_xy;
    const ur5_real lam4_21 = alpha4_z + ww4_xy;
    const ur5_real neg_lam4_22 = ww4_xx + ww4_zz;
    const ur5_real neg_lam4_31 = alpha4_y - ww4_zx;
    const ur5_real lam4_32 = ww4_yz + alpha4_x;
    /* link 5: angular velocity [rad/s] */
    const ur5_real neg_w5_x = c5*w4_x + s5*w4_z;
    const ur5_real w5_y = s5*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real neg_alpha5_x = c5*alpha4_x + s5*alpha4_z - qd[4]*w5_y;
    const ur5_real alpha5_y = s5*alpha4_x - c5*alpha4_z + qd[4]*neg_w5_x;
    const ur5_real alpha5_z = qdd[4] - alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real ww5_yz = w5_y*w5_z;
    const ur5_real neg_ww5_zx = neg_w5_x*w5_z;
    const ur5_real neg_ww5_xy = neg_w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const ur5_real neg_w6_x = c6*neg_w5_x - s6*w5_z;
    const ur5_real w6_y = s6*neg_w5_x + c6*w5_z;
    /* link 6: angular acceleration [rad/s^2] */
    const ur5_real alpha6_x = qd[5]*w6_y - (c6*neg_alpha5_x - s6*alpha5_z);
    const ur5_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const ur5_real ww6_yz = w6_y*w6_z;
    const ur5_real neg_ww6_zx = neg_w6_x*w6_z;
    const ur5_real neg_ww6_xy = neg_w6_x*w6_y;
    /* link 1: moment that turns the link [N m] */
    const ur5_real nc1_z = 0.29853861244275*qdd[0];
    /* link 2: force that moves the link [N] */
    const ur5_real neg_fc2_x = 4.4329225*neg_lam2_11;
    const ur5_real fc2_y = 4.4329225*lam2_21;
    /* link 2: moment that turns the link [N m] */
    const ur5_real neg_nc2_x = 0.0075537*neg_lam2_32 - 0.075354282*lam2_21;
    const ur5_real nc2_y = 1.76257323841*neg_lam2_31 + 0.075354282*(neg_lam2_11 - neg_lam2_33) +
        0.483853490875*ww1_zz;
    const ur5_real nc2_z = 1.76257323841*lam2_21 - 0.0075537*lam2_12 - 0.075354282*lam2_23 +
        4.4329225*a2_y;
    /* link 3: force that moves the link [N] */
    const ur5_real neg_fc3_x = 1.598759275*neg_lam3_11;
    const ur5_real fc3_y = 1.598759275*lam3_21;
    const ur5_real fc3_z = 1.598759275*lam3_31;
    /* link 3: moment that turns the link [N m] */
    const ur5_real neg_nc3_x = 0.0020475*neg_lam3_32 - 0.09736195574999999*lam3_21;
    const ur5_real nc3_y = 0.09736195574999999*(neg_lam3_11 - neg_lam3_33) -
        0.59360445167475*lam3_31 - 1.598759275*a3_z;
    const ur5_real nc3_z = 0.59360445167475*lam3_21 - 0.0020475*lam3_12 -
        0.09736195574999999*lam3_23 + 1.598759275*a3_y;
    /* link 4: force that moves the link [N] */
    const ur5_real fc4_x = 0.017784735*neg_lam4_12;
    const ur5_real fc4_y = 0.017784735*neg_lam4_22;
    const ur5_real neg_fc4_z = 0.017784735*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const ur5_real nc4_y = 0.10971*neg_lam4_31;
    const ur5_real nc4_x = 0.11431883622975*lam4_32 - 0.017784735*a4_z;
    const ur5_real nc4_z = 0.10971*lam4_21 + 0.11431883622975*neg_lam4_12 + 0.017784735*a4_x;
    /* link 5: moment that turns the link [N m] */
    const ur5_real nc5_y = 0.21942*neg_ww5_zx;
    const ur5_real nc5_x = 0.253242*ww5_yz - 0.033822*neg_alpha5_x;
    const ur5_real nc5_z = 0.033822*neg_ww5_xy + 0.253242*alpha5_z;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_y = 0.033822*neg_ww6_zx;
    const ur5_real nc6_x = 0.0171364731454*ww6_yz - 0.0166855268546*alpha6_x;
    const ur5_real nc6_z = 0.0171364731454*alpha6_z - 0.0166855268546*neg_ww6_xy;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n06_x = c6*nc6_x - s6*nc6_y;
    const ur5_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_x = nc5_x + n06_x;
    const ur5_real n5_y = nc5_y - nc6_z;
    const ur5_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n05_x = s5*n5_y - c5*n5_x;
    const ur5_real neg_n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_x = nc4_x + n05_x;
    const ur5_real neg_n4_y = n5_z - nc4_y;
    const ur5_real n4_z = nc4_z - neg_n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f04_x = c2to4*fc4_x - s2to4*fc4_y;
    const ur5_real f04_y = s2to4*fc4_x + c2to4*fc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n04_y = s2to4*n4_x - c2to4*neg_n4_y;
    const ur5_real t8 = 0.39225*c23;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_y = n04_y + (s23*neg_nc3_x - c23*nc3_y - neg_fc4_z*t8);
    const ur5_real n03_z = n4_z + (nc3_z - (f04_y*t8 - f04_x*(0.39225*s23)));
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f03_x = f04_x + (c23*neg_fc3_x + s23*fc3_y);
    const ur5_real f03_y = f04_y + (s23*neg_fc3_x - c23*fc3_y);
    const ur5_real neg_f03_z = neg_fc4_z - fc3_z;
    const ur5_real t9 = 0.425*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_y = n03_y + (s2*neg_nc2_x - c2*nc2_y - neg_f03_z*t9);
    const ur5_real n02_z = n03_z + (nc2_z - (f03_y*t9 - f03_x*(0.425*s2)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f02_x = f03_x + (c2*neg_fc2_x + s2*fc2_y);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = n02_y + (nc1_z + 0.10915*f02_x);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine */
void ur5_gravity(const ur5_real q[6], ur5_real tau[6])
{
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const volatile ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const volatile ur5_real angle2to4 = q[3] + angle23;
    const ur5_real s2to4 = sin(angle2to4);
    /* link 2: moment that turns the link [N m] */
    const ur5_real neg_nc2_z = 43.486969725*c2;
    /* link 3: moment that turns the link [N m] */
    const ur5_real neg_nc3_z = 15.683828487749999*c23;
    /* link 4: moment that turns the link [N m] */
    const ur5_real nc4_z = 0.17446825035*s2to4;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_z = nc4_z - neg_nc3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_z = n03_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = nc4_z;
    tau[4] = 0.0;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 136 multiplications, 79 additions = 215; 5 unary minus; 10 sine/cosine */
void ur5_bias(const ur5_real q[6], const ur5_real qd[6], ur5_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile ur5_real *const again = q;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(again[1]);
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(again[4]);
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(again[5]);
    const volatile ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile ur5_real angle2to4 = q[3] + angle23;
    const ur5_real c2to4 = cos(angle2to4);
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = qd[3] + w3_z;
    /* link 1: products of the angular velocity [1/s^2] */
    const ur5_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real neg_a2_z = 0.10915*ww1_zz;
    const ur5_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const ur5_real w2_x = t1*s2;
    const ur5_real w2_y = t1*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const ur5_real alpha2_x = qd[1]*w2_y;
    const ur5_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_xy = w2_x*w2_y;
    const ur5_real ww2_xx = w2_x*w2_x;
    const ur5_real ww2_yy = w2_y*w2_y;
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam2_11 = ww2_yy + ww2_zz;
    const ur5_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_z = 0.85*neg_alpha2_y - neg_a2_z;
    /* link 3: angular velocity [rad/s] */
    const ur5_real neg_w3_x = qd[0]*s23;
    const ur5_real neg_w3_y = qd[0]*c23;
    const ur5_real t2 = 0.425*neg_lam2_11;
    const ur5_real t3 = 0.425*ww2_xy;
    const ur5_real t4 = c2*t2 + s2*t3;
    const ur5_real t5 = s2*t2 - c2*t3 + 9.81;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_y = s23*t4 - c23*t5;
    /* link 3: angular acceleration [rad/s^2] */
    const ur5_real neg_alpha3_x = w3_z*neg_w3_y;
    const ur5_real alpha3_y = w3_z*neg_w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_xy = neg_w3_x*neg_w3_y;
    const ur5_real ww3_xx = neg_w3_x*neg_w3_x;
    const ur5_real ww3_yy = neg_w3_y*neg_w3_y;
    const ur5_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam3_11 = ww3_yy + ww3_zz;
    const ur5_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_z = a3_z - 0.7845*alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    const ur5_real w4_y = qd[0]*c2to4;
    const ur5_real t6 = 0.39225*neg_lam3_11;
    const ur5_real t7 = 0.39225*ww3_xy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_x = c2to4*(t4 + (c23*t6 + s23*t7)) + s2to4*(t5 + (s23*t6 - c23*t7));
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_x = w4_z*w4_y;
    const ur5_real alpha4_y = -w4_z*w4_x;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_xy = w4_x*w4_y;
    const ur5_real ww4_xx = w4_x*w4_x;
    const ur5_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_x = -s5*w4_z - c5*w4_x;
    const ur5_real w5_y = s5*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_x = qd[4]*w5_y - c5*alpha4_x;
    const ur5_real alpha5_y = s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real ww5_yz = w5_y*w5_z;
    const ur5_real ww5_zx = w5_x*w5_z;
    const ur5_real ww5_xy = w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_x = c6*w5_x + s6*w5_z;
    const ur5_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const ur5_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const ur5_real ww6_yz = w6_y*w6_z;
    const ur5_real ww6_zx = w6_x*w6_z;
    const ur5_real ww6_xy = w6_x*w6_y;
    /* link 2: force that moves the link [N] */
    const ur5_real fc2_x = -4.4329225*neg_lam2_11;
    const ur5_real fc2_y = 4.4329225*ww2_xy;
    /* link 2: moment that turns the link [N m] */
    const ur5_real nc2_x = 0.0151074*alpha2_x + 0.075354282*ww2_xy;
    const ur5_real nc2_y = 0.075354282*(neg_lam2_11 - neg_lam2_33) - 3.52514647682*neg_alpha2_y +
        0.483853490875*ww1_zz;
    const ur5_real nc2_z = 1.75501953841*ww2_xy - 43.486969725*c2;
    /* link 3: force that moves the link [N] */
    const ur5_real fc3_x = -1.598759275*neg_lam3_11;
    const ur5_real fc3_y = 1.598759275*ww3_xy;
    const ur5_real neg_fc3_z = 3.19751855*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const ur5_real nc3_x = 0.09736195574999999*ww3_xy - 0.004095*neg_alpha3_x;
    const ur5_real neg_nc3_y = 1.598759275*a3_z - (1.1872089033495*alpha3_y +
        0.09736195574999999*(neg_lam3_11 - neg_lam3_33));
    const ur5_real nc3_z = 0.59155695167475*ww3_xy + 1.598759275*a3_y;
    /* link 4: force that moves the link [N] */
    const ur5_real fc4_x = -0.017784735*ww4_xy;
    const ur5_real fc4_y = 0.017784735*neg_lam4_22;
    const ur5_real fc4_z = -0.03556947*alpha4_x;
    /* link 4: moment that turns the link [N m] */
    const ur5_real nc4_y = 0.21942*alpha4_y;
    const ur5_real nc4_x = 0.2286376724595*alpha4_x - 0.017784735*a4_z;
    const ur5_real nc4_z = 0.017784735*a4_x - 0.00460883622975*ww4_xy;
    /* link 5: moment that turns the link [N m] */
    const ur5_real nc5_y = -0.21942*ww5_zx;
    const ur5_real nc5_x = 0.253242*ww5_yz + 0.033822*alpha5_x;
    const ur5_real nc5_z = -0.033822*ww5_xy - 0.253242*alpha4_y;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_y = -0.033822*ww6_zx;
    const ur5_real nc6_x = 0.0171364731454*ww6_yz - 0.0166855268546*alpha6_x;
    const ur5_real nc6_z = 0.0166855268546*ww6_xy - 0.0171364731454*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n06_x = c6*nc6_x - s6*nc6_y;
    const ur5_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_x = nc5_x + n06_x;
    const ur5_real n5_y = nc5_y - nc6_z;
    const ur5_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n05_x = s5*n5_y - c5*n5_x;
    const ur5_real neg_n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_x = nc4_x + n05_x;
    const ur5_real n4_y = nc4_y - n5_z;
    const ur5_real n4_z = nc4_z - neg_n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f04_x = c2to4*fc4_x - s2to4*fc4_y;
    const ur5_real f04_y = s2to4*fc4_x + c2to4*fc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n04_y = s2to4*n4_x + c2to4*n4_y;
    const ur5_real t8 = 0.39225*c23;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_y = n04_y + (c23*neg_nc3_y - s23*nc3_x + fc4_z*t8);
    const ur5_real n03_z = n4_z + (nc3_z + (f04_x*(0.39225*s23) - f04_y*t8));
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f03_x = f04_x + (s23*fc3_y - c23*fc3_x);
    const ur5_real f03_y = f04_y + (-c23*fc3_y - s23*fc3_x);
    const ur5_real f03_z = fc4_z - neg_fc3_z;
    const ur5_real t9 = 0.425*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_y = n03_y + (-c2*nc2_y - s2*nc2_x + f03_z*t9);
    const ur5_real n02_z = n03_z + (nc2_z + (f03_x*(0.425*s2) - f03_y*t9));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f02_x = f03_x + (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = n02_y + 0.10915*f02_x;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 54 multiplications, 53 additions = 107; 0 unary minus; 10 sine/cosine */
void ur5_mass_matrix(const ur5_real q[6], ur5_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile ur5_real *const again = q;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(again[1]);
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(again[4]);
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(again[5]);
    const volatile ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    const volatile ur5_real angle2to4 = q[3] + angle23;
    const ur5_real c2to4 = cos(angle2to4);
    const ur5_real s2to4 = sin(angle2to4);
    /* link 6: second moment of the composite body [kg m^2] */
    const ur5_real k6_xy = 0.0166855268546*(c6*s6);
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur5_real nu5_x = -0.0171364731454*s5;
    const ur5_real nu5_y = 0.0171364731454*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y = s2to4*nu5_x;
    const ur5_real t1 = 0.0166855268546*(c6*c6);
    /* link 5: mass matrix, its row of this joint */
    const ur5_real m5_5 = t1 + 0.2365564731454;
    const ur5_real t2 = t1 - 0.0166855268546;
    const ur5_real t3 = c5*c5*t2;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real k5_yy = t1 + 0.1099354731454 - t3;
    const ur5_real k5_xy = t2*(c5*s5);
    const ur5_real neg_k5_xz = c5*k6_xy;
    const ur5_real neg_k5_yz = s5*k6_xy;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y_2 = s2to4*neg_k5_xz - c2to4*m5_5;
    /* link 4: mass matrix, its row of this joint */
    const ur5_real m4_4 = 0.25785083622975 - (t1 - t3);
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real h4_x = 0.017784735*s2to4;
    const ur5_real neg_h4_y = 0.017784735*c2to4;
    const ur5_real t4 = c2to4*c2to4*(t1 + t3 + 0.21481116377025) - neg_k5_xz*(2.0*(c2to4*s2to4));
    /* link 4: second moment of the composite body [kg m^2] */
    const ur5_real k4_xx = t4 - (t1 - 0.02151983622975);
    const ur5_real k4_yy = t3 + 0.236331 - t4;
    const ur5_real k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz;
    const ur5_real t5 = 0.39225*s23;
    const ur5_real t6 = 0.39225*c23;
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_4 = m4_4 + (t5*neg_h4_y - t6*h4_x);
    const ur5_real t7 = 0.425*s2;
    const ur5_real t8 = 0.425*c2;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_4 = m3_4 + (t7*neg_h4_y - t8*h4_x);
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_4 = 0.00194120382525*c2to4 - k4_yz;
    const ur5_real t9 = k5_yy - k4_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const ur5_real k3_zz = k4_yy + t9;
    const ur5_real t10 = t6*(0.03556947*s2to4) - k4_xx;
    const ur5_real t11 = k5_yy - t9 + t5*(0.03556947*c2to4);
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_3 = 0.5956519516747499 - (t10 - t11);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real h3_x = h4_x - 1.598759275*c23;
    const ur5_real neg_h3_y = neg_h4_y + 1.598759275*s23;
    const ur5_real t12 = 0.59155695167475*(c23*c23);
    /* link 3: second moment of the composite body [kg m^2] */
    const ur5_real k3_xx = t12 + 0.0020475 - t10;
    const ur5_real k3_yy = t11 - (t12 - 0.59360445167475);
    const ur5_real k3_yz = k4_yz + 0.09736195574999999*s23;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_3 = m3_3 + (t7*neg_h3_y - t8*h3_x);
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_3 = 0.10915*neg_h3_y - k3_yz;
    const ur5_real t13 = k3_zz - k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const ur5_real k2_zz = k3_yy + t13;
    const ur5_real t14 = t8*(2.0*h3_x) - k3_xx;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_2 = 1.77012693841 - (t14 - (k3_zz - t13 + t7*(2.0*neg_h3_y)));
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real neg_h2_y = neg_h3_y + 4.4329225*s2;
    /* link 2: second moment of the composite body [kg m^2] */
    const ur5_real k2_xx = 1.75501953841*(c2*c2) + 0.0075537 - t14;
    const ur5_real k2_yz = k3_yz + 0.075354282*s2;
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_2 = 0.10915*neg_h2_y - k2_yz;
    const ur5_real m1_1 = k2_zz + k2_xx + 0.29853861244275;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = nu4_y_2;
    M[5] = nu4_y;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = neg_k5_yz;
    M[11] = nu5_y;
    M[12] = m1_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = neg_k5_yz;
    M[17] = nu5_y;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = neg_k5_yz;
    M[23] = nu5_y;
    M[24] = nu4_y_2;
    M[25] = neg_k5_yz;
    M[26] = neg_k5_yz;
    M[27] = neg_k5_yz;
    M[28] = m5_5;
    M[29] = 0.0;
    M[30] = nu4_y;
    M[31] = nu5_y;
    M[32] = nu5_y;
    M[33] = nu5_y;
    M[34] = 0.0;
    M[35] = 0.0171364731454;
}

/* accelerations that the torques tau give
 * 272 multiplications, 200 additions, 6 divisions = 478; 15 unary minus; 10 sine/cosine */
void ur5_forward_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real tau[6],
    ur5_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile ur5_real *const again = q;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(again[1]);
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(again[4]);
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(again[5]);
    const volatile ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    const volatile ur5_real angle2to4 = q[3] + angle23;
    const ur5_real c2to4 = cos(angle2to4);
    const ur5_real s2to4 = sin(angle2to4);
    /* link 6: second moment of the composite body [kg m^2] */
    const ur5_real k6_xy = 0.0166855268546*(c6*s6);
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur5_real nu5_x = -0.0171364731454*s5;
    const ur5_real nu5_y = 0.0171364731454*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y = s2to4*nu5_x;
    const ur5_real t1 = 0.0166855268546*(c6*c6);
    /* link 5: mass matrix, its row of this joint */
    const ur5_real m5_5 = t1 + 0.2365564731454;
    const ur5_real t2 = t1 - 0.0166855268546;
    const ur5_real t3 = c5*c5*t2;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real k5_yy = t1 + 0.1099354731454 - t3;
    const ur5_real k5_xy = t2*(c5*s5);
    const ur5_real k5_xz = -c5*k6_xy;
    const ur5_real neg_k5_yz = s5*k6_xy;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y_2 = -c2to4*m5_5 - s2to4*k5_xz;
    /* link 4: mass matrix, its row of this joint */
    const ur5_real m4_4 = 0.25785083622975 - (t1 - t3);
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real h4_x = 0.017784735*s2to4;
    const ur5_real h4_y = -0.017784735*c2to4;
    const ur5_real t4 = c2to4*c2to4*(t1 + t3 + 0.21481116377025) + k5_xz*(2.0*(c2to4*s2to4));
    /* link 4: second moment of the composite body [kg m^2] */
    const ur5_real k4_xx = t4 - (t1 - 0.02151983622975);
    const ur5_real k4_yy = t3 + 0.236331 - t4;
    const ur5_real k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz;
    const ur5_real t5 = 0.39225*c23;
    const ur5_real t6 = 0.39225*s23;
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_4 = m4_4 - (t5*h4_x + t6*h4_y);
    const ur5_real t7 = 0.425*c2;
    const ur5_real t8 = 0.425*s2;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_4 = m3_4 - (t7*h4_x + t8*h4_y);
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_4 = 0.00194120382525*c2to4 - k4_yz;
    const ur5_real t9 = k5_yy - k4_yy;
    /* link 3: second moment of the composite body [kg m^2] */
    const ur5_real k3_zz = k4_yy + t9;
    const ur5_real t10 = t5*(0.03556947*s2to4) - k4_xx;
    const ur5_real t11 = k5_yy - t9 + t6*(0.03556947*c2to4);
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_3 = 0.5956519516747499 - (t10 - t11);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real h3_x = h4_x - 1.598759275*c23;
    const ur5_real h3_y = h4_y - 1.598759275*s23;
    const ur5_real t12 = 0.59155695167475*(c23*c23);
    /* link 3: second moment of the composite body [kg m^2] */
    const ur5_real k3_xx = t12 + 0.0020475 - t10;
    const ur5_real k3_yy = t11 - (t12 - 0.59360445167475);
    const ur5_real k3_yz = k4_yz + 0.09736195574999999*s23;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_3 = m3_3 - (t7*h3_x + t8*h3_y);
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_3 = -0.10915*h3_y - k3_yz;
    const ur5_real t13 = k3_zz - k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const ur5_real k2_zz = k3_yy + t13;
    const ur5_real t14 = t7*(2.0*h3_x) - k3_xx;
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_2 = 1.77012693841 - (t14 - (k3_zz - t13 + t8*(-2.0*h3_y)));
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const ur5_real neg_h2_y = 4.4329225*s2 - h3_y;
    /* link 2: second moment of the composite body [kg m^2] */
    const ur5_real k2_xx = 1.75501953841*(c2*c2) + 0.0075537 - t14;
    const ur5_real k2_yz = k3_yz + 0.075354282*s2;
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_2 = 0.10915*neg_h2_y - k2_yz;
    const ur5_real m1_1 = k2_zz + k2_xx + 0.29853861244275;
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = qd[3] + w3_z;
    /* link 1: products of the angular velocity [1/s^2] */
    const ur5_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real neg_a2_z = 0.10915*ww1_zz;
    const ur5_real t15 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const ur5_real w2_x = t15*s2;
    const ur5_real w2_y = t15*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const ur5_real alpha2_x = qd[1]*w2_y;
    const ur5_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_xy = w2_x*w2_y;
    const ur5_real ww2_xx = w2_x*w2_x;
    const ur5_real ww2_yy = w2_y*w2_y;
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam2_11 = ww2_yy + ww2_zz;
    const ur5_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_z = 0.85*neg_alpha2_y - neg_a2_z;
    /* link 3: angular velocity [rad/s] */
    const ur5_real neg_w3_x = qd[0]*s23;
    const ur5_real neg_w3_y = qd[0]*c23;
    const ur5_real t16 = 0.425*neg_lam2_11;
    const ur5_real t17 = 0.425*ww2_xy;
    const ur5_real t18 = c2*t16 + s2*t17;
    const ur5_real t19 = s2*t16 - c2*t17 + 9.81;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a3_y = s23*t18 - c23*t19;
    /* link 3: angular acceleration [rad/s^2] */
    const ur5_real neg_alpha3_x = w3_z*neg_w3_y;
    const ur5_real alpha3_y = w3_z*neg_w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_xy = neg_w3_x*neg_w3_y;
    const ur5_real ww3_xx = neg_w3_x*neg_w3_x;
    const ur5_real ww3_yy = neg_w3_y*neg_w3_y;
    const ur5_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam3_11 = ww3_yy + ww3_zz;
    const ur5_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_z = a3_z - 0.7845*alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    const ur5_real w4_y = qd[0]*c2to4;
    const ur5_real t20 = 0.39225*neg_lam3_11;
    const ur5_real t21 = 0.39225*ww3_xy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const ur5_real a4_x = c2to4*(t18 + (c23*t20 + s23*t21)) + s2to4*(t19 + (s23*t20 - c23*t21));
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_x = w4_z*w4_y;
    const ur5_real alpha4_y = -w4_z*w4_x;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_xy = w4_x*w4_y;
    const ur5_real ww4_xx = w4_x*w4_x;
    const ur5_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_x = -s5*w4_z - c5*w4_x;
    const ur5_real w5_y = s5*w4_x - c5*w4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_x = qd[4]*w5_y - c5*alpha4_x;
    const ur5_real alpha5_y = s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real ww5_yz = w5_y*w5_z;
    const ur5_real ww5_zx = w5_x*w5_z;
    const ur5_real ww5_xy = w5_x*w5_y;
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_x = c6*w5_x + s6*w5_z;
    const ur5_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const ur5_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const ur5_real ww6_yz = w6_y*w6_z;
    const ur5_real ww6_zx = w6_x*w6_z;
    const ur5_real ww6_xy = w6_x*w6_y;
    /* link 2: force that moves the link [N] */
    const ur5_real fc2_x = -4.4329225*neg_lam2_11;
    const ur5_real fc2_y = 4.4329225*ww2_xy;
    /* link 2: moment that turns the link [N m] */
    const ur5_real nc2_x = 0.0151074*alpha2_x + 0.075354282*ww2_xy;
    const ur5_real nc2_y = 0.075354282*(neg_lam2_11 - neg_lam2_33) - 3.52514647682*neg_alpha2_y +
        0.483853490875*ww1_zz;
    const ur5_real nc2_z = 1.75501953841*ww2_xy - 43.486969725*c2;
    /* link 3: force that moves the link [N] */
    const ur5_real fc3_x = -1.598759275*neg_lam3_11;
    const ur5_real fc3_y = 1.598759275*ww3_xy;
    const ur5_real neg_fc3_z = 3.19751855*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const ur5_real nc3_x = 0.09736195574999999*ww3_xy - 0.004095*neg_alpha3_x;
    const ur5_real neg_nc3_y = 1.598759275*a3_z - (1.1872089033495*alpha3_y +
        0.09736195574999999*(neg_lam3_11 - neg_lam3_33));
    const ur5_real nc3_z = 0.59155695167475*ww3_xy + 1.598759275*a3_y;
    /* link 4: force that moves the link [N] */
    const ur5_real fc4_x = -0.017784735*ww4_xy;
    const ur5_real fc4_y = 0.017784735*neg_lam4_22;
    const ur5_real fc4_z = -0.03556947*alpha4_x;
    /* link 4: moment that turns the link [N m] */
    const ur5_real nc4_y = 0.21942*alpha4_y;
    const ur5_real nc4_x = 0.2286376724595*alpha4_x - 0.017784735*a4_z;
    const ur5_real nc4_z = 0.017784735*a4_x - 0.00460883622975*ww4_xy;
    /* link 5: moment that turns the link [N m] */
    const ur5_real nc5_y = -0.21942*ww5_zx;
    const ur5_real nc5_x = 0.253242*ww5_yz + 0.033822*alpha5_x;
    const ur5_real nc5_z = -0.033822*ww5_xy - 0.253242*alpha4_y;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_y = -0.033822*ww6_zx;
    const ur5_real nc6_x = 0.0171364731454*ww6_yz - 0.0166855268546*alpha6_x;
    const ur5_real nc6_z = 0.0166855268546*ww6_xy - 0.0171364731454*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n06_x = c6*nc6_x - s6*nc6_y;
    const ur5_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_x = nc5_x + n06_x;
    const ur5_real n5_y = nc5_y - nc6_z;
    const ur5_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n05_x = s5*n5_y - c5*n5_x;
    const ur5_real neg_n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_x = nc4_x + n05_x;
    const ur5_real n4_y = nc4_y - n5_z;
    const ur5_real n4_z = nc4_z - neg_n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f04_x = c2to4*fc4_x - s2to4*fc4_y;
    const ur5_real f04_y = s2to4*fc4_x + c2to4*fc4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n04_y = s2to4*n4_x + c2to4*n4_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_y = n04_y + (c23*neg_nc3_y - s23*nc3_x + t5*fc4_z);
    const ur5_real n03_z = n4_z + (nc3_z + (t6*f04_x - t5*f04_y));
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f03_x = f04_x + (s23*fc3_y - c23*fc3_x);
    const ur5_real f03_y = f04_y + (-c23*fc3_y - s23*fc3_x);
    const ur5_real f03_z = fc4_z - neg_fc3_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_y = n03_y + (-c2*nc2_y - s2*nc2_x + t7*f03_z);
    const ur5_real n02_z = n03_z + (nc2_z + (t8*f03_x - t7*f03_y));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const ur5_real f02_x = f03_x + (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = n02_y + 0.10915*f02_x;
    /* link 1: forward substitution */
    const ur5_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const ur5_real ipivot1 = 1.0 / m1_1;
    const ur5_real l2_1 = m1_2*ipivot1;
    const ur5_real l3_1 = m1_3*ipivot1;
    const ur5_real l4_1 = m1_4*ipivot1;
    const ur5_real l5_1 = nu4_y_2*ipivot1;
    const ur5_real l6_1 = nu4_y*ipivot1;
    const ur5_real pivot2 = m2_2 - m1_2*l2_1;
    const ur5_real ipivot2 = 1.0 / pivot2;
    const ur5_real ld3_2 = m2_3 - m1_2*l3_1;
    const ur5_real l3_2 = ipivot2*ld3_2;
    const ur5_real ld4_2 = m2_4 - m1_2*l4_1;
    const ur5_real l4_2 = ipivot2*ld4_2;
    const ur5_real ld5_2 = neg_k5_yz - m1_2*l5_1;
    const ur5_real l5_2 = ipivot2*ld5_2;
    const ur5_real ld6_2 = nu5_y - m1_2*l6_1;
    const ur5_real l6_2 = ipivot2*ld6_2;
    const ur5_real pivot3 = m3_3 - m1_3*l3_1 - ld3_2*l3_2;
    const ur5_real ipivot3 = 1.0 / pivot3;
    const ur5_real ld4_3 = m3_4 - m1_3*l4_1 - ld3_2*l4_2;
    const ur5_real l4_3 = ipivot3*ld4_3;
    const ur5_real ld5_3 = -ld3_2*l5_2 - (m1_3*l5_1 - neg_k5_yz);
    const ur5_real l5_3 = ipivot3*ld5_3;
    const ur5_real ld6_3 = nu5_y - m1_3*l6_1 - ld3_2*l6_2;
    const ur5_real l6_3 = ipivot3*ld6_3;
    const ur5_real pivot4 = -(m1_4*l4_1 - m4_4 + ld4_2*l4_2) - ld4_3*l4_3;
    const ur5_real ipivot4 = 1.0 / pivot4;
    const ur5_real ld5_4 = -ld4_2*l5_2 - (m1_4*l5_1 - neg_k5_yz) - ld4_3*l5_3;
    const ur5_real l5_4 = ipivot4*ld5_4;
    const ur5_real ld6_4 = nu5_y - m1_4*l6_1 - ld4_2*l6_2 - ld4_3*l6_3;
    const ur5_real l6_4 = ipivot4*ld6_4;
    const ur5_real pivot5 = m5_5 - nu4_y_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const ur5_real ipivot5 = 1.0 / pivot5;
    const ur5_real ld6_5 = -ld5_2*l6_2 - nu4_y_2*l6_1 - ld5_3*l6_3 - ld5_4*l6_4;
    const ur5_real l6_5 = ipivot5*ld6_5;
    const ur5_real pivot6 = -ld6_5*l6_5 - (nu4_y*l6_1 - 0.0171364731454 + ld6_2*l6_2 + ld6_3*l6_3 +
        ld6_4*l6_4);
    const ur5_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const ur5_real y2 = tau[1] - n02_z - y1*l2_1;
    /* link 3: forward substitution */
    const ur5_real y3 = tau[2] - n03_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const ur5_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const ur5_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const ur5_real y6 = tau[5] - nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4);
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd2 = -l6_2*qdd6 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3 - l4_1*qdd4 - l5_1*qdd5 - l6_1*qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
