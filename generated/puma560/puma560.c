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
 *   inverse_dynamics: 187 multiplications, 151 additions = 338; 3 unary minus; 10 sine/cosine
 *   gravity: 20 multiplications, 9 additions = 29; 1 unary minus; 8 sine/cosine
 *   bias: 165 multiplications, 116 additions = 281; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 84 multiplications, 71 additions = 155; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 333 multiplications, 255 additions, 6 divisions = 594; 15 unary minus; 10
 *       sine/cosine
 */
#include "puma560.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 187 multiplications, 151 additions = 338; 3 unary minus; 10 sine/cosine */
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
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_z = qdd[1] + qdd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a2_z = 0.1501*ww1_zz;
    const puma560_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_real w2_x = t1*s2;
    const puma560_real w2_y = t1*c2;
    const puma560_real t2 = 0.1501*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a2_x = c2*t2 + 9.8*s2;
    const puma560_real a2_y = s2*t2 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_yz = qd[1]*w2_y;
    const puma560_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real alpha2_x = ww2_yz - qdd[0]*s2;
    const puma560_real neg_alpha2_y = qdd[0]*c2 + ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = w2_x*w2_y;
    const puma560_real ww2_xx = w2_x*w2_x;
    const puma560_real ww2_yy = w2_y*w2_y;
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_real lam2_12 = ww2_xy - qdd[1];
    const puma560_real lam2_13 = ww2_zx - neg_alpha2_y;
    const puma560_real lam2_21 = qdd[1] + ww2_xy;
    const puma560_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_real lam2_23 = ww2_yz - alpha2_x;
    const puma560_real lam2_31 = ww2_zx + neg_alpha2_y;
    const puma560_real lam2_32 = ww2_yz + alpha2_x;
    const puma560_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_z = 0.4318*lam2_31 - neg_a2_z;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = t1*s23;
    const puma560_real w3_y = t1*c23;
    const puma560_real t3 = 0.4318*neg_lam2_11;
    const puma560_real t4 = 0.4318*lam2_21;
    const puma560_real t5 = t2 + (c2*t3 + s2*t4);
    const puma560_real t6 = s2*t3 - c2*t4 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a3_x = c23*t5 + s23*t6;
    const puma560_real a3_y = s23*t5 - c23*t6;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_yz = w3_z*w3_y;
    const puma560_real ww3_zx = w3_z*w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_x = ww3_yz - qdd[0]*s23;
    const puma560_real neg_alpha3_y = qdd[0]*c23 + ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real ww3_xx = w3_x*w3_x;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real lam3_12 = ww3_xy - alpha3_z;
    const puma560_real lam3_13 = ww3_zx - neg_alpha3_y;
    const puma560_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_real lam3_31 = ww3_zx + neg_alpha3_y;
    const puma560_real lam3_32 = ww3_yz + alpha3_x;
    const puma560_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_z = 0.0203*lam3_21 - 0.4331*neg_lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_real t7 = a3_z + (-0.0203*lam3_31 - 0.4331*lam3_32);
    const puma560_real t8 = neg_a3_x + (0.4331*lam3_12 - 0.0203*neg_lam3_11);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_x = s4*t7 - c4*t8;
    const puma560_real a4_y = s4*t8 + c4*t7;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = qd[3]*w4_y - (-s4*alpha3_z - c4*alpha3_x);
    const puma560_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const puma560_real alpha4_z = qdd[3] + neg_alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_x*w4_z;
    const puma560_real ww4_xy = w4_x*w4_y;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_real t9 = -c5;
    const puma560_real w5_y = t9*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x - s5*a4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = t9*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
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
    const puma560_real neg_lam5_31 = alpha5_y - ww5_zx;
    const puma560_real lam5_32 = w5_y*(qd[4] + w5_z) - (s5*alpha4_z - c5*alpha4_x);
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
    const puma560_real fc2_x = 0.1044*lam2_12 - 3.79559*neg_lam2_11;
    const puma560_real fc2_y = 3.79559*lam2_21 - 0.1044*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_real nc2_x = -0.01567044*ww1_zz - (-0.0731264*lam2_32 - 0.00808056*(neg_lam2_22 -
        neg_lam2_33) + (0.12059664*lam2_21 - 0.0070992*lam2_31));
    const puma560_real nc2_y = -1.674987602*lam2_31 - 0.12059664*(neg_lam2_11 - neg_lam2_33) -
        (0.0070992*lam2_32 - 0.00808056*lam2_12) + 0.569718059*ww1_zz;
    const puma560_real t10 = 1.674987602*lam2_21 - 0.0731264*lam2_12 + 0.0070992*(neg_lam2_11 -
        neg_lam2_22) - (0.00808056*lam2_13 - 0.12059664*lam2_23);
    const puma560_real nc2_z = t10 + (3.79559*a2_y + 0.1044*neg_a2_x);
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
        0.0106736385*(neg_lam3_11 - neg_lam3_22) + 0.004704*lam3_13 - (0.025375*a3_y +
        0.861795*neg_a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real neg_nc4_y = 0.0013*ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz + 0.0001*alpha4_x;
    const puma560_real nc4_z = 0.0014*alpha4_z - 0.0001*ww4_xy;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = -0.00288*lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = -0.00288*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_y = 0.0002*neg_lam5_31;
    const puma560_real nc5_x = 0.00044216*lam5_32 - 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 - 0.00044216*lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = -4e-05*ww6_zx;
    const puma560_real nc6_z = 4e-05*alpha6_z;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau6 = nc6_z + 0.193*qdd[5];
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_x = nc5_x + n06_x;
    const puma560_real n5_y = nc5_y - nc6_z;
    const puma560_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f05_x = c5*fc5_x - s5*fc5_y;
    const puma560_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_real n05_y = s5*n5_x + c5*n5_y;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau5 = n5_z + 0.179*qdd[4];
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x + n05_x;
    const puma560_real n4_y = n5_z - neg_nc4_y;
    const puma560_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f04_x = c4*f05_x - s4*fc5_z;
    const puma560_real f04_y = s4*f05_x + c4*fc5_z;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_real n04_y = s4*n4_x + c4*n4_y;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau4 = n4_z + 0.2*qdd[3];
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = n04_x - (0.4331*f04_y - nc3_x);
    const puma560_real n3_y = nc3_y + 0.0203*f04_y - n4_z;
    const puma560_real n3_z = n04_y + (nc3_z - (0.0203*f05_y - 0.4331*f04_x));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + f04_x;
    const puma560_real f3_y = fc3_y + f05_y;
    const puma560_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau3 = n3_z + 0.83*qdd[2];
    const puma560_real t11 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n02_z = n3_z + (nc2_z + (f03_y*t11 - f03_x*(0.4318*s2)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f02_x = f03_x - (s2*fc2_y - c2*fc2_x);
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = n02_z + 4.71*qdd[1];
    const puma560_real t12 = 0.1501*f02_x - (f3_z*t11 - (c2*nc2_y + (s2*nc2_x + (s23*n3_x +
        c23*n3_y))));
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = 2.6017295505*qdd[0] - t12;
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques that hold the arm at rest
 * 20 multiplications, 9 additions = 29; 1 unary minus; 8 sine/cosine */
void puma560_gravity(const puma560_real q[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_x = -9.8*s23;
    const puma560_real a3_y = -9.8*c23;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_x = c4*a3_x;
    const puma560_real neg_a4_y = s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x + s5*a3_y;
    /* link 2: moment that turns the link [N m] */
    const puma560_real nc2_z = 1.02312*s2 - 37.196782*c2;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_z = 0.248675*c23 - 8.445591*s23;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_x = 0.00288*neg_a4_y;
    const puma560_real nc5_z = 0.00288*a5_x;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n05_x = c5*nc5_x;
    const puma560_real neg_n05_y = -s5*nc5_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n04_x = c4*n05_x - s4*nc5_z;
    const puma560_real n04_y = s4*n05_x + c4*nc5_z;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = nc3_z + n04_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real neg_n03_y = c23*neg_n05_y - s23*n04_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n02_z = nc2_z + n3_z;
    tau[0] = neg_n03_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = neg_n05_y;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 165 multiplications, 116 additions = 281; 0 unary minus; 10 sine/cosine */
void puma560_bias(const puma560_real q[6], const puma560_real qd[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_real neg_w2_x = qd[0]*s2;
    const puma560_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real neg_alpha2_x = qd[1]*neg_w2_y;
    const puma560_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a3_z = 0.8636*alpha2_y - a2_z;
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = qd[0]*s23;
    const puma560_real neg_w3_y = qd[0]*c23;
    const puma560_real t1 = 0.4318*neg_lam2_11;
    const puma560_real t2 = 0.4318*ww2_xy;
    const puma560_real t3 = c2*t1 + s2*t2;
    const puma560_real t4 = s2*t1 - c2*t2 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a3_x = c23*t3 + s23*t4;
    const puma560_real a3_y = s23*t3 - c23*t4;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real neg_alpha3_x = w3_z*neg_w3_y;
    const puma560_real alpha3_y = w3_z*neg_w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a4_z = a3_y - (0.0203*ww3_xy - 0.4331*neg_lam3_22);
    /* link 4: angular velocity [rad/s] */
    const puma560_real neg_w4_x = c4*neg_w3_x - s4*w3_z;
    const puma560_real w4_y = s4*neg_w3_x + c4*w3_z;
    const puma560_real t5 = neg_a3_x - (0.0203*neg_lam3_11 - 0.4331*ww3_xy);
    const puma560_real t6 = neg_a3_z - (0.0406*alpha3_y + 0.8662*neg_alpha3_x);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a4_x = c4*t5 + s4*t6;
    const puma560_real a4_y = s4*t5 - c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real neg_alpha4_x = c4*neg_alpha3_x - qd[3]*w4_y;
    const puma560_real alpha4_y = s4*neg_alpha3_x + qd[3]*neg_w4_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] + neg_w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real neg_ww4_zx = neg_w4_x*w4_z;
    const puma560_real neg_ww4_xy = neg_w4_x*w4_y;
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = c5*neg_w4_x + s5*w4_z;
    const puma560_real w5_y = s5*neg_w4_x - c5*w4_z;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = s5*neg_a4_z - c5*neg_a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = s5*neg_alpha4_x + c5*alpha3_y + qd[4]*neg_w5_x;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = alpha4_y + neg_ww5_xy;
    const puma560_real lam5_21 = alpha4_y - neg_ww5_xy;
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_real neg_lam5_31 = alpha5_y + neg_ww5_zx;
    const puma560_real neg_lam5_32 = c5*neg_alpha4_x - s5*alpha3_y - w5_y*(qd[4] + w5_z);
    /* link 6: angular velocity [rad/s] */
    const puma560_real neg_w6_x = c6*neg_w5_x - s6*w5_z;
    const puma560_real w6_y = s6*neg_w5_x + c6*w5_z;
    const puma560_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_real ww6_yz = w6_y*w6_z;
    const puma560_real neg_ww6_zx = neg_w6_x*w6_z;
    /* link 2: force that moves the link [N] */
    const puma560_real neg_fc2_x = 3.79559*neg_lam2_11 - 0.1044*ww2_xy;
    const puma560_real fc2_y = 3.79559*ww2_xy - 0.1044*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_real neg_nc2_x = 0.1462528*neg_alpha2_x - 0.00808056*(neg_lam2_22 - neg_lam2_33) +
        (0.0141984*alpha2_y + 0.12059664*ww2_xy) + 0.01567044*ww1_zz;
    const puma560_real nc2_y = 3.349975204*alpha2_y - 0.12059664*(neg_lam2_11 - neg_lam2_33) +
        (0.00808056*ww2_xy + 0.0141984*neg_alpha2_x) + 0.569718059*ww1_zz;
    const puma560_real nc2_z = 1.601861202*ww2_xy + 0.0070992*(neg_lam2_11 - neg_lam2_22) -
        (37.196782*c2 - 1.02312*s2);
    /* link 3: force that moves the link [N] */
    const puma560_real fc3_x = 0.025375*neg_lam3_11 - 0.861795*ww3_xy;
    const puma560_real neg_fc3_y = 0.025375*ww3_xy - 0.861795*neg_lam3_22;
    const puma560_real fc3_z = 0.05075*alpha3_y + 1.72359*neg_alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_x = 0.861795*neg_a3_z - (0.632680273*neg_alpha3_x + 0.004704*(neg_lam3_22
        - neg_lam3_33) + 0.021347277*alpha3_y);
    const puma560_real nc3_y = 0.033530225*alpha3_y - (0.004704*ww3_xy - 0.021347277*neg_alpha3_x) -
        0.025375*neg_a3_z;
    const puma560_real neg_nc3_z = 0.299575024*ww3_xy - 0.0106736385*(neg_lam3_11 - neg_lam3_22) +
        (0.025375*a3_y + 0.861795*neg_a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz - 0.0001*neg_alpha4_x;
    const puma560_real nc4_z = 0.0001*neg_ww4_xy - 0.0014*alpha3_y;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = 0.00288*neg_lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = 0.00288*neg_lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_y = 0.0002*neg_lam5_31;
    const puma560_real neg_nc5_x = 0.00044216*neg_lam5_32 + 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 + 0.00044216*neg_lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = 4e-05*neg_ww6_zx;
    const puma560_real nc6_z = -4e-05*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n5_x = neg_nc5_x - n06_x;
    const puma560_real n5_y = nc5_y - nc6_z;
    const puma560_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f05_x = c5*fc5_x - s5*fc5_y;
    const puma560_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real neg_n05_x = c5*neg_n5_x + s5*n5_y;
    const puma560_real n05_y = c5*n5_y - s5*neg_n5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x - neg_n05_x;
    const puma560_real n4_y = nc4_y + n5_z;
    const puma560_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f04_x = c4*f05_x - s4*fc5_z;
    const puma560_real f04_y = s4*f05_x + c4*fc5_z;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = n04_x - (0.4331*f04_y - nc3_x);
    const puma560_real neg_n3_y = n4_z - (nc3_y + 0.0203*f04_y);
    const puma560_real n3_z = n04_y - (neg_nc3_z + (0.0203*f05_y - 0.4331*f04_x));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + f04_x;
    const puma560_real neg_f3_y = neg_fc3_y - f05_y;
    const puma560_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f03_x = c23*f3_x + s23*neg_f3_y;
    const puma560_real f03_y = s23*f3_x - c23*neg_f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n03_y = s23*n3_x - c23*neg_n3_y;
    const puma560_real t7 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t7);
    const puma560_real n02_z = n3_z + (nc2_z + (f03_y*t7 - f03_x*(0.4318*s2)));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real neg_f02_x = c2*neg_fc2_x + s2*fc2_y - f03_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_real n1_z = 0.1501*neg_f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 84 multiplications, 71 additions = 155; 0 unary minus; 8 sine/cosine */
void puma560_mass_matrix(const puma560_real q[6], puma560_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_real nu5_x = 4e-05*s5;
    const puma560_real neg_nu5_y = 4e-05*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_x = c4*nu5_x;
    const puma560_real nu4_y = s4*nu5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu3_y = c23*neg_nu5_y - s23*nu4_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h5_x = 0.00288*s5;
    const puma560_real neg_h5_y = 0.00288*c5;
    const puma560_real t1 = 0.00020216*(c5*c5);
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_real k5_yy = t1 + 0.00022;
    const puma560_real neg_k5_xy = 0.00020216*(c5*s5);
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_real fu4_x = c4*neg_h5_y;
    const puma560_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu4_x = 0.00064216*s4;
    const puma560_real nu4_y_2 = 0.00064216*c4;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_5 = nu4_y_2 - (5.8464e-05*s5 - 0.4331*fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x = c23*fu4_x - s23*h5_x;
    const puma560_real fu3_y = s23*fu4_x + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = c23*(0.0203*fu4_y) - s23*(neg_nu4_x + 0.4331*fu4_y);
    const puma560_real t2 = 0.4318*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y = nu3_y - t2*fu4_y;
    const puma560_real t3 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_5 = m3_5 + (t2*fu3_y - t3*fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_5 = -0.1501*fu3_x - nu2_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h4_x = c4*h5_x;
    const puma560_real h4_y = s4*h5_x;
    const puma560_real t4 = t1 - 0.00030216;
    const puma560_real t5 = c4*c4*t4;
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_real k4_xx = 0.00077 - t5;
    const puma560_real k4_yy = t5 - (t1 - 0.00107216);
    const puma560_real neg_k4_xy = t4*(c4*s4);
    const puma560_real k4_xz = c4*neg_k5_xy;
    const puma560_real k4_yz = s4*neg_k5_xy;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = 0.20184216 - t1;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_4 = -0.4331*h4_y - k4_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real neg_fu3_x = c23*h4_y;
    const puma560_real neg_fu3_y = s23*h4_y;
    const puma560_real t6 = 0.4331*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y_2 = c23*(t1 - 0.00184216 + 0.0203*h4_x) - s23*(k4_xz + t6);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y_2 = nu3_y_2 - t2*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_4 = m3_4 - (t2*neg_fu3_y - t3*neg_fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_4 = 0.1501*neg_fu3_x - nu2_y_2;
    const puma560_real t7 = h4_x - 0.025375;
    const puma560_real t8 = neg_h5_y + 0.861795;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h3_x = c23*t7 + s23*t8;
    const puma560_real h3_y = s23*t7 - c23*t8;
    const puma560_real t9 = k5_yy + 0.002494656*c5;
    const puma560_real t10 = k4_xx - 0.0406*h4_x;
    const puma560_real t11 = c23*c23*(t10 - t9 - 0.298925024) + (t6 + (k4_xz - 5.8464e-05*c5) -
        0.0106736385)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_xx = t9 + 0.3156901365 + t11;
    const puma560_real k3_yy = t10 + 0.0167651125 - t11;
    const puma560_real neg_k3_yz = s23*(neg_k4_xy + 0.0203*h4_y) + c23*(0.004704 - m3_4);
    const puma560_real t12 = t10 + t9;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = t12 + 1.162455249;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_3 = t12 + 0.332455249 + (t2*h3_x + t3*h3_y);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_3 = 0.1501*h3_y - neg_k3_yz;
    const puma560_real t13 = k3_yy - k4_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_zz = k3_yy - t13;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_y = h3_y + (3.79559*s2 + 0.1044*c2);
    const puma560_real t14 = k3_xx + t2*(2.0*h3_x);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xx = t14 + (1.601861202*(c2*c2) - 0.0141984*(c2*s2) + 0.0731264);
    const puma560_real k2_yz = t3*h4_y - neg_k3_yz + (0.12059664*s2 + 0.00808056*c2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = t14 - (t3*(-2.0*h3_y) - (k4_yy + t13)) + 6.458114002;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_2 = k2_yz + 0.1501*h2_y;
    const puma560_real m1_1 = k2_xx + (k2_zz + 0.3002*h4_y) + 2.6017295505;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = neg_nu3_y;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = nu4_y;
    M[12] = m1_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = nu4_y;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = 0.0;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = 0.0;
    M[28] = 0.17964216;
    M[29] = 0.0;
    M[30] = neg_nu3_y;
    M[31] = nu4_y;
    M[32] = nu4_y;
    M[33] = neg_nu5_y;
    M[34] = 0.0;
    M[35] = 0.19304;
}

/* accelerations that the torques tau give
 * 333 multiplications, 255 additions, 6 divisions = 594; 15 unary minus; 10 sine/cosine */
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
    const puma560_real c4 = cos(q[3]);
    const puma560_real s4 = sin(again[3]);
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    const puma560_real c6 = cos(q[5]);
    const puma560_real s6 = sin(again[5]);
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real c23 = cos(angle23);
    const puma560_real s23 = sin(angle23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_real nu5_x = 4e-05*s5;
    const puma560_real nu5_y = -4e-05*c5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_x = c4*nu5_x;
    const puma560_real nu4_y = s4*nu5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = s23*nu4_x + c23*nu5_y;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h5_x = 0.00288*s5;
    const puma560_real neg_h5_y = 0.00288*c5;
    const puma560_real t1 = 0.00020216*(c5*c5);
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_real k5_yy = t1 + 0.00022;
    const puma560_real neg_k5_xy = 0.00020216*(c5*s5);
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_real fu4_x = c4*neg_h5_y;
    const puma560_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real neg_nu4_x = 0.00064216*s4;
    const puma560_real nu4_y_2 = 0.00064216*c4;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_5 = nu4_y_2 - (5.8464e-05*s5 - 0.4331*fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x = c23*fu4_x - s23*h5_x;
    const puma560_real fu3_y = s23*fu4_x + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y_2 = c23*(0.0203*fu4_y) - s23*(neg_nu4_x + 0.4331*fu4_y);
    const puma560_real t2 = 0.4318*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y = nu3_y_2 - t2*fu4_y;
    const puma560_real t3 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_5 = m3_5 + (t2*fu3_y - t3*fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_5 = -0.1501*fu3_x - nu2_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h4_x = c4*h5_x;
    const puma560_real h4_y = s4*h5_x;
    const puma560_real t4 = t1 - 0.00030216;
    const puma560_real t5 = c4*c4*t4;
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_real k4_xx = 0.00077 - t5;
    const puma560_real k4_yy = t5 - (t1 - 0.00107216);
    const puma560_real neg_k4_xy = t4*(c4*s4);
    const puma560_real k4_xz = c4*neg_k5_xy;
    const puma560_real k4_yz = s4*neg_k5_xy;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = 0.20184216 - t1;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_4 = -0.4331*h4_y - k4_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real neg_fu3_x = c23*h4_y;
    const puma560_real neg_fu3_y = s23*h4_y;
    const puma560_real t6 = 0.4331*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y_3 = c23*(t1 - 0.00184216 + 0.0203*h4_x) - s23*(k4_xz + t6);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y_2 = nu3_y_3 - t2*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_4 = m3_4 - (t2*neg_fu3_y - t3*neg_fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_4 = 0.1501*neg_fu3_x - nu2_y_2;
    const puma560_real t7 = h4_x - 0.025375;
    const puma560_real t8 = neg_h5_y + 0.861795;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h3_x = c23*t7 + s23*t8;
    const puma560_real h3_y = s23*t7 - c23*t8;
    const puma560_real t9 = k5_yy + 0.002494656*c5;
    const puma560_real t10 = 0.0406*h4_x - k4_xx;
    const puma560_real t11 = c23*c23*(t10 + t9 + 0.298925024) - (t6 + (k4_xz - 5.8464e-05*c5) -
        0.0106736385)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_xx = t9 + 0.3156901365 - t11;
    const puma560_real k3_yy = t11 - (t10 - 0.0167651125);
    const puma560_real neg_k3_yz = s23*(neg_k4_xy + 0.0203*h4_y) + c23*(0.004704 - m3_4);
    const puma560_real t12 = t10 - t9;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = 1.162455249 - t12;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_3 = t2*h3_x + t3*h3_y - (t12 - 0.332455249);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_3 = 0.1501*h3_y - neg_k3_yz;
    const puma560_real t13 = k3_yy - k4_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_zz = k3_yy - t13;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_y = h3_y + (3.79559*s2 + 0.1044*c2);
    const puma560_real t14 = k3_xx + t2*(2.0*h3_x);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xx = t14 + (1.601861202*(c2*c2) - 0.0141984*(c2*s2) + 0.0731264);
    const puma560_real k2_yz = t3*h4_y - neg_k3_yz + (0.12059664*s2 + 0.00808056*c2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = t14 - (t3*(-2.0*h3_y) - (k4_yy + t13)) + 6.458114002;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_2 = k2_yz + 0.1501*h2_y;
    const puma560_real m1_1 = k2_xx + (k2_zz + 0.3002*h4_y) + 2.6017295505;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_real neg_w2_x = qd[0]*s2;
    const puma560_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_real neg_alpha2_x = qd[1]*neg_w2_y;
    const puma560_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_z = a2_z - 0.8636*alpha2_y;
    const puma560_real t15 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_x = t15*s23;
    const puma560_real w3_y = t15*c23;
    const puma560_real t16 = 0.4318*neg_lam2_11;
    const puma560_real t17 = 0.4318*ww2_xy;
    const puma560_real t18 = c2*t16 + s2*t17;
    const puma560_real t19 = s2*t16 - c2*t17 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a3_x = c23*t18 + s23*t19;
    const puma560_real a3_y = s23*t18 - c23*t19;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_x = w3_z*w3_y;
    const puma560_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_xy = w3_x*w3_y;
    const puma560_real ww3_xx = w3_x*w3_x;
    const puma560_real ww3_yy = w3_y*w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_z = 0.0203*ww3_xy - 0.4331*neg_lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_real t20 = a3_z + (0.0406*alpha3_y - 0.8662*alpha3_x);
    const puma560_real t21 = neg_a3_x + (0.4331*ww3_xy - 0.0203*neg_lam3_11);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_x = s4*t20 - c4*t21;
    const puma560_real a4_y = s4*t21 + c4*t20;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real ww4_zx = w4_x*w4_z;
    const puma560_real ww4_xy = w4_x*w4_y;
    /* link 5: angular velocity [rad/s] */
    const puma560_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_real w5_y = -c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = c5*a4_x - s5*a4_z;
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
    const puma560_real lam5_32 = w5_y*(qd[4] + w5_z) - (-s5*alpha3_y - c5*alpha4_x);
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
    const puma560_real nc2_x = -0.01567044*ww1_zz - (0.1462528*neg_alpha2_x -
        0.00808056*(neg_lam2_22 - neg_lam2_33) + (0.0141984*alpha2_y + 0.12059664*ww2_xy));
    const puma560_real nc2_y = 3.349975204*alpha2_y - 0.12059664*(neg_lam2_11 - neg_lam2_33) +
        (0.00808056*ww2_xy + 0.0141984*neg_alpha2_x) + 0.569718059*ww1_zz;
    const puma560_real nc2_z = 1.601861202*ww2_xy + 0.0070992*(neg_lam2_11 - neg_lam2_22) -
        (37.196782*c2 - 1.02312*s2);
    /* link 3: force that moves the link [N] */
    const puma560_real fc3_x = 0.025375*neg_lam3_11 - 0.861795*ww3_xy;
    const puma560_real fc3_y = 0.861795*neg_lam3_22 - 0.025375*ww3_xy;
    const puma560_real fc3_z = 0.05075*alpha3_y - 1.72359*alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_x = -0.861795*a3_z - (0.004704*(neg_lam3_22 - neg_lam3_33) -
        0.632680273*alpha3_x + 0.021347277*alpha3_y);
    const puma560_real nc3_y = 0.033530225*alpha3_y - (0.004704*ww3_xy + 0.021347277*alpha3_x) +
        0.025375*a3_z;
    const puma560_real neg_nc3_z = 0.299575024*ww3_xy - 0.0106736385*(neg_lam3_11 - neg_lam3_22) +
        (0.025375*a3_y + 0.861795*neg_a3_x);
    /* link 4: moment that turns the link [N m] */
    const puma560_real neg_nc4_y = 0.0013*ww4_zx;
    const puma560_real nc4_x = 0.0014*ww4_yz + 0.0001*alpha4_x;
    const puma560_real nc4_z = -0.0001*ww4_xy - 0.0014*alpha3_y;
    /* link 5: force that moves the link [N] */
    const puma560_real fc5_x = -0.00288*lam5_12;
    const puma560_real fc5_y = 0.00288*neg_lam5_22;
    const puma560_real fc5_z = -0.00288*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_real neg_nc5_y = 0.0002*lam5_31;
    const puma560_real nc5_x = 0.00044216*lam5_32 - 0.00288*a4_y;
    const puma560_real nc5_z = 0.0002*lam5_21 - 0.00044216*lam5_12 + 0.00288*a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_real nc6_x = 4e-05*ww6_yz;
    const puma560_real nc6_y = -4e-05*ww6_zx;
    const puma560_real neg_nc6_z = 4e-05*alpha5_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_x = nc5_x + n06_x;
    const puma560_real n5_y = neg_nc6_z - neg_nc5_y;
    const puma560_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f05_x = c5*fc5_x - s5*fc5_y;
    const puma560_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = nc4_x + n05_x;
    const puma560_real n4_y = n5_z - neg_nc4_y;
    const puma560_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f04_x = c4*f05_x - s4*fc5_z;
    const puma560_real f04_y = s4*f05_x + c4*fc5_z;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = n04_x - (0.4331*f04_y - nc3_x);
    const puma560_real n3_y = nc3_y + 0.0203*f04_y - n4_z;
    const puma560_real n3_z = n04_y - (neg_nc3_z + (0.0203*f05_y - 0.4331*f04_x));
    /* link 3: force through the joint [N] */
    const puma560_real f3_x = fc3_x + f04_x;
    const puma560_real f3_y = fc3_y + f05_y;
    const puma560_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n03_y = s23*n3_x + c23*n3_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + t2*f3_z);
    const puma560_real n02_z = n3_z + (nc2_z + (t2*f03_y - t3*f03_x));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_real f02_x = f03_x - (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n1_z = n02_y + 0.1501*f02_x;
    /* link 1: forward substitution */
    const puma560_real y1 = tau[0] + neg_n1_z;
    /* factorisation M = L D L^T */
    const puma560_real ipivot1 = 1.0 / m1_1;
    const puma560_real l2_1 = m1_2*ipivot1;
    const puma560_real l3_1 = m1_3*ipivot1;
    const puma560_real l4_1 = m1_4*ipivot1;
    const puma560_real l5_1 = m1_5*ipivot1;
    const puma560_real l6_1 = -nu3_y*ipivot1;
    const puma560_real pivot2 = m2_2 - m1_2*l2_1;
    const puma560_real ipivot2 = 1.0 / pivot2;
    const puma560_real ld3_2 = m2_3 - m1_2*l3_1;
    const puma560_real l3_2 = ipivot2*ld3_2;
    const puma560_real ld4_2 = m2_4 - m1_2*l4_1;
    const puma560_real l4_2 = ipivot2*ld4_2;
    const puma560_real ld5_2 = m2_5 - m1_2*l5_1;
    const puma560_real l5_2 = ipivot2*ld5_2;
    const puma560_real ld6_2 = nu4_y - m1_2*l6_1;
    const puma560_real l6_2 = ipivot2*ld6_2;
    const puma560_real pivot3 = -ld3_2*l3_2 - (m1_3*l3_1 - m3_3);
    const puma560_real ipivot3 = 1.0 / pivot3;
    const puma560_real ld4_3 = m3_4 - m1_3*l4_1 - ld3_2*l4_2;
    const puma560_real l4_3 = ipivot3*ld4_3;
    const puma560_real ld5_3 = m3_5 - m1_3*l5_1 - ld3_2*l5_2;
    const puma560_real l5_3 = ipivot3*ld5_3;
    const puma560_real ld6_3 = nu4_y - m1_3*l6_1 - ld3_2*l6_2;
    const puma560_real l6_3 = ipivot3*ld6_3;
    const puma560_real t22 = -ld4_2;
    const puma560_real pivot4 = t22*l4_2 - (m1_4*l4_1 - m4_4) - ld4_3*l4_3;
    const puma560_real ipivot4 = 1.0 / pivot4;
    const puma560_real ld5_4 = -ld4_3*l5_3 - (m1_4*l5_1 + ld4_2*l5_2);
    const puma560_real l5_4 = ipivot4*ld5_4;
    const puma560_real ld6_4 = t22*l6_2 - (nu5_y + m1_4*l6_1) - ld4_3*l6_3;
    const puma560_real l6_4 = ipivot4*ld6_4;
    const puma560_real pivot5 = -(m1_5*l5_1 - 0.17964216 + ld5_2*l5_2 + ld5_3*l5_3) - ld5_4*l5_4;
    const puma560_real ipivot5 = 1.0 / pivot5;
    const puma560_real ld6_5 = -ld5_2*l6_2 - m1_5*l6_1 - ld5_3*l6_3 - ld5_4*l6_4;
    const puma560_real l6_5 = ipivot5*ld6_5;
    const puma560_real pivot6 = -(ld6_2*l6_2 - (nu3_y*l6_1 + 0.19304) + ld6_3*l6_3 + ld6_4*l6_4) -
        ld6_5*l6_5;
    const puma560_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const puma560_real y2 = tau[1] - n02_z - y1*l2_1;
    /* link 3: forward substitution */
    const puma560_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const puma560_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const puma560_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const puma560_real y6 = tau[5] + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4);
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3 - l4_1*qdd4 - l5_1*qdd5 -
        l6_1*qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
