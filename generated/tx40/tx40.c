/*
 * tx40: Staubli TX40 (CAD parameters; friction, rotor inertia and the wrist coupling are not in
 *   it)
 * Numbers: figaroh-plus examples/staubli_TX40, Apache-2.0
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
 *   inverse_dynamics: 194 multiplications, 182 additions = 376; 4 unary minus; 8 sine/cosine
 *   gravity: 30 multiplications, 17 additions = 47; 0 unary minus; 8 sine/cosine
 *   bias: 179 multiplications, 152 additions = 331; 6 unary minus; 8 sine/cosine
 *   mass_matrix: 88 multiplications, 80 additions = 168; 0 unary minus; 8 sine/cosine
 */
#include "tx40.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 194 multiplications, 182 additions = 376; 4 unary minus; 8 sine/cosine */
void tx40_inverse_dynamics(
    const tx40_real q[6],
    const tx40_real qd[6],
    const tx40_real qdd[6],
    tx40_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile tx40_real *const again = q;
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(again[1]);
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(again[3]);
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(again[4]);
    const volatile tx40_real angle23 = q[1] + q[2];
    const tx40_real c23 = cos(angle23);
    const tx40_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real alpha3_z = qdd[1] + qdd[2];
    const tx40_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const tx40_real w2_x = t1*s2;
    const tx40_real w2_y = t1*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const tx40_real ww2_yz = qd[1]*w2_y;
    const tx40_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const tx40_real alpha2_x = ww2_yz - qdd[0]*s2;
    const tx40_real alpha2_y = -qdd[0]*c2 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const tx40_real ww2_xy = w2_x*w2_y;
    const tx40_real ww2_xx = w2_x*w2_x;
    const tx40_real ww2_yy = w2_y*w2_y;
    const tx40_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam2_11 = ww2_yy + ww2_zz;
    const tx40_real lam2_12 = ww2_xy - qdd[1];
    const tx40_real lam2_13 = ww2_zx + alpha2_y;
    const tx40_real lam2_21 = qdd[1] + ww2_xy;
    const tx40_real neg_lam2_22 = ww2_xx + ww2_zz;
    const tx40_real lam2_23 = ww2_yz - alpha2_x;
    const tx40_real neg_lam2_31 = alpha2_y - ww2_zx;
    const tx40_real lam2_32 = ww2_yz + alpha2_x;
    const tx40_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a3_z = -0.035*neg_lam2_33 - 0.225*neg_lam2_31;
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_x = t1*s23;
    const tx40_real w3_y = t1*c23;
    const tx40_real t2 = 0.225*neg_lam2_11 - 0.035*lam2_13;
    const tx40_real t3 = 0.225*lam2_21 + 0.035*lam2_23;
    const tx40_real t4 = c2*t2 + s2*t3;
    const tx40_real t5 = s2*t2 - c2*t3 + 9.81;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real neg_a3_x = c23*t4 + s23*t5;
    const tx40_real a3_y = s23*t4 - c23*t5;
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real ww3_yz = w3_z*w3_y;
    const tx40_real ww3_zx = w3_z*w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real alpha3_x = ww3_yz - qdd[0]*s23;
    const tx40_real neg_alpha3_y = qdd[0]*c23 + ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real ww3_xy = w3_x*w3_y;
    const tx40_real ww3_xx = w3_x*w3_x;
    const tx40_real ww3_yy = w3_y*w3_y;
    const tx40_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_11 = ww3_yy + ww3_zz;
    const tx40_real lam3_12 = ww3_xy - alpha3_z;
    const tx40_real lam3_13 = ww3_zx - neg_alpha3_y;
    const tx40_real lam3_21 = alpha3_z + ww3_xy;
    const tx40_real neg_lam3_22 = ww3_xx + ww3_zz;
    const tx40_real lam3_23 = ww3_yz - alpha3_x;
    const tx40_real lam3_31 = ww3_zx + neg_alpha3_y;
    const tx40_real lam3_32 = ww3_yz + alpha3_x;
    const tx40_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real neg_a4_z = a3_y + 0.225*neg_lam3_22;
    /* link 4: angular velocity [rad/s] */
    const tx40_real w4_x = c4*w3_x + s4*w3_z;
    const tx40_real w4_y = c4*w3_z - s4*w3_x;
    const tx40_real t6 = a3_z - 0.225*lam3_32;
    const tx40_real t7 = neg_a3_x + 0.225*lam3_12;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a4_x = s4*t6 - c4*t7;
    const tx40_real a4_y = s4*t7 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const tx40_real alpha4_x = qd[3]*w4_y - (-s4*alpha3_z - c4*alpha3_x);
    const tx40_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const tx40_real alpha4_z = qdd[3] + neg_alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const tx40_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const tx40_real ww4_yz = w4_y*w4_z;
    const tx40_real ww4_zx = w4_x*w4_z;
    const tx40_real ww4_xy = w4_x*w4_y;
    const tx40_real ww4_xx = w4_x*w4_x;
    const tx40_real ww4_yy = w4_y*w4_y;
    const tx40_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam4_11 = ww4_yy + ww4_zz;
    const tx40_real lam4_12 = ww4_xy - alpha4_z;
    const tx40_real lam4_13 = alpha4_y + ww4_zx;
    const tx40_real lam4_21 = alpha4_z + ww4_xy;
    const tx40_real neg_lam4_22 = ww4_xx + ww4_zz;
    const tx40_real lam4_23 = ww4_yz - alpha4_x;
    const tx40_real neg_lam4_31 = alpha4_y - ww4_zx;
    const tx40_real lam4_32 = alpha4_x + ww4_yz;
    const tx40_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_x = c5*w4_x - s5*w4_z;
    const tx40_real t8 = -c5;
    const tx40_real w5_y = t8*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a5_x = c5*a4_x + s5*neg_a4_z;
    const tx40_real a5_y = c5*neg_a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const tx40_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const tx40_real alpha5_y = t8*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
    const tx40_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const tx40_real ww5_yz = w5_y*w5_z;
    const tx40_real ww5_zx = w5_x*w5_z;
    const tx40_real ww5_xy = w5_x*w5_y;
    const tx40_real ww5_xx = w5_x*w5_x;
    const tx40_real ww5_yy = w5_y*w5_y;
    const tx40_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam5_11 = ww5_yy + ww5_zz;
    const tx40_real lam5_12 = ww5_xy - alpha5_z;
    const tx40_real lam5_13 = alpha5_y + ww5_zx;
    const tx40_real lam5_21 = alpha5_z + ww5_xy;
    const tx40_real neg_lam5_22 = ww5_xx + ww5_zz;
    const tx40_real lam5_23 = ww5_yz - alpha5_x;
    const tx40_real neg_lam5_31 = alpha5_y - ww5_zx;
    const tx40_real lam5_32 = alpha5_x + ww5_yz;
    const tx40_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 1: moment that turns the link [N m] */
    const tx40_real nc1_z = 0.14677892*qdd[0];
    /* link 2: moment that turns the link [N m] */
    const tx40_real nc2_x = 0.0007848*neg_lam2_31 - 0.1602936*lam2_21 - (-0.0345144*lam2_32 -
        0.0010352*(neg_lam2_22 - neg_lam2_33));
    const tx40_real neg_nc2_y = -0.0010352*lam2_12 - 0.0007848*lam2_32 - (0.49934035*neg_lam2_31 -
        0.1602936*(neg_lam2_11 - neg_lam2_33));
    const tx40_real t9 = 0.49934035*lam2_21 - 0.0345144*lam2_12 - 0.0007848*(neg_lam2_11 -
        neg_lam2_22) - (0.0010352*lam2_13 - 0.1602936*lam2_23);
    const tx40_real nc2_z = t9 - (23.5160415*c2 + 0.070632*s2);
    /* link 3: force that moves the link [N] */
    const tx40_real fc3_x = -0.03256*neg_lam3_11 - 0.67724*lam3_12;
    const tx40_real fc3_y = 0.03256*lam3_21 + 0.67724*neg_lam3_22;
    const tx40_real fc3_z = 0.03256*lam3_31 - 0.67724*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const tx40_real nc3_x = -0.67724*a3_z - (-0.1258139*lam3_32 - 0.00200122*(neg_lam3_22 -
        neg_lam3_33) + (0.00233496*lam3_21 - 0.00019536*lam3_31));
    const tx40_real nc3_y = -0.00226048*lam3_31 - 0.00233496*(neg_lam3_11 - neg_lam3_33) -
        (0.00019536*lam3_32 - 0.00200122*lam3_12) - 0.03256*a3_z;
    const tx40_real t10 = 0.00226048*lam3_21 - 0.1258139*lam3_12 + 0.00019536*(neg_lam3_11 -
        neg_lam3_22) - (0.00200122*lam3_13 - 0.00233496*lam3_23);
    const tx40_real nc3_z = t10 + (0.03256*a3_y - 0.67724*neg_a3_x);
    /* link 4: force that moves the link [N] */
    const tx40_real fc4_x = 0.01448*neg_lam4_11 + 0.00622*lam4_12;
    const tx40_real fc4_y = -0.00622*neg_lam4_22 - 0.01448*lam4_21;
    const tx40_real fc4_z = 0.01448*neg_lam4_31 + 0.00622*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const tx40_real nc4_x = -0.00622*neg_a4_z - (0.00077468*(neg_lam4_22 - neg_lam4_33) -
        0.0030155*lam4_32 - (2.896e-05*neg_lam4_31 - 0.00254936*lam4_21));
    const tx40_real nc4_y = 0.00155792*neg_lam4_31 - 0.00254936*(neg_lam4_11 - neg_lam4_33) +
        (2.896e-05*lam4_32 - 0.00077468*lam4_12) - 0.01448*neg_a4_z;
    const tx40_real t11 = 0.00155792*lam4_21 - 0.0030155*lam4_12 - 2.896e-05*(neg_lam4_11 -
        neg_lam4_22) + (0.00254936*lam4_23 + 0.00077468*lam4_13);
    const tx40_real nc4_z = t11 - (0.01448*a4_y + 0.00622*a4_x);
    /* link 5: force that moves the link [N] */
    const tx40_real fc5_x = 0.00408*neg_lam5_11 - 0.01146*lam5_12;
    const tx40_real fc5_y = 0.01146*neg_lam5_22 - 0.00408*lam5_21;
    const tx40_real fc5_z = 0.00408*neg_lam5_31 - 0.01146*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const tx40_real nc5_x = -0.01146*a4_y - (-0.00086198*lam5_32 - 3.06e-06*(neg_lam5_22 -
        neg_lam5_33) + (1.224e-05*neg_lam5_31 + 4.08e-06*lam5_21));
    const tx40_real nc5_y = 0.00051632*neg_lam5_31 - 4.08e-06*(neg_lam5_11 - neg_lam5_33) -
        (1.224e-05*lam5_32 - 3.06e-06*lam5_12) + 0.00408*a4_y;
    const tx40_real t12 = 0.00051632*lam5_21 - 0.00086198*lam5_12 - 1.224e-05*(neg_lam5_22 -
        neg_lam5_11) + (4.08e-06*lam5_23 - 3.06e-06*lam5_13);
    const tx40_real nc5_z = t12 - (0.00408*a5_y - 0.01146*a5_x);
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f05_x = c5*fc5_x - s5*fc5_y;
    const tx40_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n05_x = c5*nc5_x - s5*nc5_y;
    const tx40_real n05_y = s5*nc5_x + c5*nc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const tx40_real n4_x = nc4_x + n05_x;
    const tx40_real n4_y = nc4_y + nc5_z;
    const tx40_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const tx40_real f4_x = fc4_x + f05_x;
    const tx40_real f4_y = fc4_y + fc5_z;
    const tx40_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f04_x = c4*f4_x - s4*f4_y;
    const tx40_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n04_x = c4*n4_x - s4*n4_y;
    const tx40_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_x = n04_x - (0.225*f04_y - nc3_x);
    const tx40_real n3_y = nc3_y - n4_z;
    const tx40_real n3_z = n04_y + (nc3_z + 0.225*f04_x);
    /* link 3: force through the joint [N] */
    const tx40_real f3_x = fc3_x + f04_x;
    const tx40_real f3_y = fc3_y - f4_z;
    const tx40_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f03_x = c23*f3_x - s23*f3_y;
    const tx40_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n03_y = s23*n3_x + c23*n3_y;
    const tx40_real t13 = 0.225*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n02_y = n03_y - (c2*neg_nc2_y - s2*nc2_x + (f3_z*t13 - 0.035*f03_x));
    const tx40_real n02_z = n3_z + (nc2_z - (f03_x*(0.225*s2) - f03_y*t13));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const tx40_real n1_z = nc1_z - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques that hold the arm at rest
 * 30 multiplications, 17 additions = 47; 0 unary minus; 8 sine/cosine */
void tx40_gravity(const tx40_real q[6], tx40_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile tx40_real *const again = q;
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(again[1]);
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(again[3]);
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(again[4]);
    const volatile tx40_real angle23 = q[1] + q[2];
    const tx40_real c23 = cos(angle23);
    const tx40_real s23 = sin(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a3_x = -9.81*s23;
    const tx40_real a3_y = -9.81*c23;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a4_x = c4*a3_x;
    const tx40_real neg_a4_y = s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a5_x = c5*a4_x + s5*a3_y;
    const tx40_real a5_y = c5*a3_y - s5*a4_x;
    /* link 2: moment that turns the link [N m] */
    const tx40_real neg_nc2_z = 23.5160415*c2 + 0.070632*s2;
    /* link 3: moment that turns the link [N m] */
    const tx40_real neg_nc3_z = 0.3194136*c23 + 6.6437244*s23;
    /* link 4: moment that turns the link [N m] */
    const tx40_real nc4_x = 0.0610182*c23;
    const tx40_real nc4_y = 0.1420488*c23;
    const tx40_real nc4_z = 0.01448*neg_a4_y - 0.00622*a4_x;
    /* link 5: moment that turns the link [N m] */
    const tx40_real nc5_x = 0.01146*neg_a4_y;
    const tx40_real nc5_y = -0.00408*neg_a4_y;
    const tx40_real nc5_z = 0.01146*a5_x - 0.00408*a5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n05_x = c5*nc5_x - s5*nc5_y;
    const tx40_real n05_y = s5*nc5_x + c5*nc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const tx40_real n4_x = nc4_x + n05_x;
    const tx40_real n4_y = nc4_y + nc5_z;
    const tx40_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n04_x = c4*n4_x - s4*n4_y;
    const tx40_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_z = n04_y - neg_nc3_z;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real neg_n03_y = c23*n4_z - s23*n04_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n02_z = n3_z - neg_nc2_z;
    tau[0] = neg_n03_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 179 multiplications, 152 additions = 331; 6 unary minus; 8 sine/cosine */
void tx40_bias(const tx40_real q[6], const tx40_real qd[6], tx40_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile tx40_real *const again = q;
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(again[1]);
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(again[3]);
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(again[4]);
    const volatile tx40_real angle23 = q[1] + q[2];
    const tx40_real c23 = cos(angle23);
    const tx40_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_z = qd[1] + qd[2];
    /* link 2: angular velocity [rad/s] */
    const tx40_real neg_w2_x = qd[0]*s2;
    const tx40_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const tx40_real neg_alpha2_x = qd[1]*neg_w2_y;
    const tx40_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const tx40_real ww2_xy = neg_w2_x*neg_w2_y;
    const tx40_real ww2_xx = neg_w2_x*neg_w2_x;
    const tx40_real ww2_yy = neg_w2_y*neg_w2_y;
    const tx40_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam2_11 = ww2_yy + ww2_zz;
    const tx40_real neg_lam2_22 = ww2_xx + ww2_zz;
    const tx40_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a3_z = -0.035*neg_lam2_33 - 0.45*alpha2_y;
    const tx40_real t1 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_x = t1*s23;
    const tx40_real w3_y = t1*c23;
    const tx40_real t2 = 0.225*neg_lam2_11;
    const tx40_real t3 = 0.225*ww2_xy;
    const tx40_real t4 = c2*t2 + s2*t3;
    const tx40_real t5 = s2*t2 - c2*t3 + 9.81;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real neg_a3_x = c23*t4 + s23*t5;
    const tx40_real a3_y = s23*t4 - c23*t5;
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real alpha3_x = w3_z*w3_y;
    const tx40_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real ww3_xy = w3_x*w3_y;
    const tx40_real ww3_xx = w3_x*w3_x;
    const tx40_real ww3_yy = w3_y*w3_y;
    const tx40_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_11 = ww3_yy + ww3_zz;
    const tx40_real neg_lam3_22 = ww3_xx + ww3_zz;
    const tx40_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real neg_a4_z = a3_y + 0.225*neg_lam3_22;
    /* link 4: angular velocity [rad/s] */
    const tx40_real w4_x = c4*w3_x + s4*w3_z;
    const tx40_real w4_y = c4*w3_z - s4*w3_x;
    const tx40_real t6 = a3_z - 0.45*alpha3_x;
    const tx40_real t7 = neg_a3_x + 0.225*ww3_xy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a4_x = s4*t6 - c4*t7;
    const tx40_real a4_y = s4*t7 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const tx40_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const tx40_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const tx40_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const tx40_real ww4_yz = w4_y*w4_z;
    const tx40_real ww4_zx = w4_x*w4_z;
    const tx40_real ww4_xy = w4_x*w4_y;
    const tx40_real ww4_xx = w4_x*w4_x;
    const tx40_real ww4_yy = w4_y*w4_y;
    const tx40_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam4_11 = ww4_yy + ww4_zz;
    const tx40_real lam4_12 = alpha3_y + ww4_xy;
    const tx40_real lam4_13 = alpha4_y + ww4_zx;
    const tx40_real lam4_21 = ww4_xy - alpha3_y;
    const tx40_real neg_lam4_22 = ww4_xx + ww4_zz;
    const tx40_real lam4_23 = ww4_yz - alpha4_x;
    const tx40_real neg_lam4_31 = alpha4_y - ww4_zx;
    const tx40_real lam4_32 = alpha4_x + ww4_yz;
    const tx40_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_x = c5*w4_x - s5*w4_z;
    const tx40_real w5_y = -c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const tx40_real a5_x = c5*a4_x + s5*neg_a4_z;
    const tx40_real a5_y = c5*neg_a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const tx40_real alpha5_x = qd[4]*w5_y - (-s5*alpha3_y - c5*alpha4_x);
    const tx40_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const tx40_real ww5_yz = w5_y*w5_z;
    const tx40_real ww5_zx = w5_x*w5_z;
    const tx40_real ww5_xy = w5_x*w5_y;
    const tx40_real ww5_xx = w5_x*w5_x;
    const tx40_real ww5_yy = w5_y*w5_y;
    const tx40_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam5_11 = ww5_yy + ww5_zz;
    const tx40_real lam5_12 = ww5_xy - alpha4_y;
    const tx40_real lam5_13 = alpha5_y + ww5_zx;
    const tx40_real lam5_21 = alpha4_y + ww5_xy;
    const tx40_real neg_lam5_22 = ww5_xx + ww5_zz;
    const tx40_real lam5_23 = ww5_yz - alpha5_x;
    const tx40_real neg_lam5_31 = alpha5_y - ww5_zx;
    const tx40_real lam5_32 = alpha5_x + ww5_yz;
    const tx40_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 2: moment that turns the link [N m] */
    const tx40_real nc2_x = 0.0015696*alpha2_y - 0.1602936*ww2_xy - (0.0690288*neg_alpha2_x -
        0.0010352*(neg_lam2_22 - neg_lam2_33));
    const tx40_real nc2_y = 0.9986807*alpha2_y - 0.1602936*(neg_lam2_11 - neg_lam2_33) +
        (0.0010352*ww2_xy - 0.0015696*neg_alpha2_x);
    const tx40_real nc2_z = 0.46482595*ww2_xy - 0.0007848*(neg_lam2_11 - neg_lam2_22) -
        (23.5160415*c2 + 0.070632*s2);
    /* link 3: force that moves the link [N] */
    const tx40_real fc3_x = -0.03256*neg_lam3_11 - 0.67724*ww3_xy;
    const tx40_real fc3_y = 0.03256*ww3_xy + 0.67724*neg_lam3_22;
    const tx40_real fc3_z = -1.35448*alpha3_x - 0.06512*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const tx40_real nc3_x = -0.67724*a3_z - (-0.2516278*alpha3_x - 0.00200122*(neg_lam3_22 -
        neg_lam3_33) + (0.00039072*alpha3_y + 0.00233496*ww3_xy));
    const tx40_real nc3_y = 0.00452096*alpha3_y - 0.00233496*(neg_lam3_11 - neg_lam3_33) +
        (0.00200122*ww3_xy - 0.00039072*alpha3_x) - 0.03256*a3_z;
    const tx40_real nc3_z = 0.03256*a3_y - 0.67724*neg_a3_x - (0.12355342*ww3_xy -
        0.00019536*(neg_lam3_11 - neg_lam3_22));
    /* link 4: force that moves the link [N] */
    const tx40_real fc4_x = 0.01448*neg_lam4_11 + 0.00622*lam4_12;
    const tx40_real fc4_y = -0.00622*neg_lam4_22 - 0.01448*lam4_21;
    const tx40_real fc4_z = 0.01448*neg_lam4_31 + 0.00622*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const tx40_real nc4_x = -0.00622*neg_a4_z - (0.00077468*(neg_lam4_22 - neg_lam4_33) -
        0.0030155*lam4_32 - (2.896e-05*neg_lam4_31 - 0.00254936*lam4_21));
    const tx40_real nc4_y = 0.00155792*neg_lam4_31 - 0.00254936*(neg_lam4_11 - neg_lam4_33) -
        (0.00077468*lam4_12 - 2.896e-05*lam4_32) - 0.01448*neg_a4_z;
    const tx40_real t8 = 0.0030155*lam4_12 - 0.00155792*lam4_21 + 2.896e-05*(neg_lam4_11 -
        neg_lam4_22) - (0.00254936*lam4_23 + 0.00077468*lam4_13);
    const tx40_real nc4_z = -0.00622*a4_x - 0.01448*a4_y - t8;
    /* link 5: force that moves the link [N] */
    const tx40_real fc5_x = 0.00408*neg_lam5_11 - 0.01146*lam5_12;
    const tx40_real fc5_y = 0.01146*neg_lam5_22 - 0.00408*lam5_21;
    const tx40_real fc5_z = 0.00408*neg_lam5_31 - 0.01146*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const tx40_real nc5_x = -0.01146*a4_y - (-0.00086198*lam5_32 - 3.06e-06*(neg_lam5_22 -
        neg_lam5_33) + (1.224e-05*neg_lam5_31 + 4.08e-06*lam5_21));
    const tx40_real nc5_y = 0.00051632*neg_lam5_31 - 4.08e-06*(neg_lam5_11 - neg_lam5_33) -
        (1.224e-05*lam5_32 - 3.06e-06*lam5_12) + 0.00408*a4_y;
    const tx40_real t9 = 0.00051632*lam5_21 - 0.00086198*lam5_12 - 1.224e-05*(neg_lam5_22 -
        neg_lam5_11) + (4.08e-06*lam5_23 - 3.06e-06*lam5_13);
    const tx40_real nc5_z = t9 - (0.00408*a5_y - 0.01146*a5_x);
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f05_x = c5*fc5_x - s5*fc5_y;
    const tx40_real f05_y = s5*fc5_x + c5*fc5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n05_x = c5*nc5_x - s5*nc5_y;
    const tx40_real n05_y = s5*nc5_x + c5*nc5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const tx40_real n4_x = nc4_x + n05_x;
    const tx40_real n4_y = nc4_y + nc5_z;
    const tx40_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const tx40_real f4_x = fc4_x + f05_x;
    const tx40_real f4_y = fc4_y + fc5_z;
    const tx40_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f04_x = c4*f4_x - s4*f4_y;
    const tx40_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n04_x = c4*n4_x - s4*n4_y;
    const tx40_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_x = n04_x - (0.225*f04_y - nc3_x);
    const tx40_real n3_y = nc3_y - n4_z;
    const tx40_real n3_z = n04_y + (nc3_z + 0.225*f04_x);
    /* link 3: force through the joint [N] */
    const tx40_real f3_x = fc3_x + f04_x;
    const tx40_real f3_y = fc3_y - f4_z;
    const tx40_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const tx40_real f03_x = c23*f3_x - s23*f3_y;
    const tx40_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n03_y = s23*n3_x + c23*n3_y;
    const tx40_real t10 = 0.225*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real neg_n02_y = -c2*nc2_y - s2*nc2_x + (f3_z*t10 - 0.035*f03_x) - n03_y;
    const tx40_real n02_z = n3_z + (nc2_z - (f03_x*(0.225*s2) - f03_y*t10));
    tau[0] = neg_n02_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* mass matrix, rotor inertias on its diagonal
 * 88 multiplications, 80 additions = 168; 0 unary minus; 8 sine/cosine */
void tx40_mass_matrix(const tx40_real q[6], tx40_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile tx40_real *const again = q;
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(again[1]);
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(again[3]);
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(again[4]);
    const volatile tx40_real angle23 = q[1] + q[2];
    const tx40_real c23 = cos(angle23);
    const tx40_real s23 = sin(angle23);
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real h5_x = 0.01146*s5 - 0.00408*c5;
    const tx40_real neg_h5_y = 0.00408*s5 + 0.01146*c5;
    const tx40_real t1 = c5*c5;
    const tx40_real t2 = c5*s5;
    const tx40_real t3 = 0.00034566*t1 + 2.448e-05*t2;
    /* link 5: second moment of the composite body [kg m^2] */
    const tx40_real k5_yy = t3 + 0.00051632;
    const tx40_real neg_k5_xy = 0.00034566*t2 + 1.224e-05*(1.0 - 2.0*t1);
    const tx40_real k5_xz = 4.08e-06*c5 - 3.06e-06*s5;
    const tx40_real k5_yz = 4.08e-06*s5 + 3.06e-06*c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const tx40_real fu4_x = c4*neg_h5_y;
    const tx40_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu4_x = c4*k5_xz + 0.0013783*s4;
    const tx40_real nu4_y = 0.0013783*c4 - s4*k5_xz;
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_5 = nu4_y + 0.225*fu4_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const tx40_real fu3_x = c23*fu4_x - s23*h5_x;
    const tx40_real fu3_y = s23*fu4_x + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu3_y = s23*(neg_nu4_x + 0.225*fu4_y) + c23*k5_yz;
    const tx40_real t4 = 0.225*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu2_y = neg_nu3_y + (t4*fu4_y - 0.035*fu3_x);
    const tx40_real t5 = 0.225*s2;
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_5 = m3_5 + (t4*fu3_y - t5*fu3_x);
    /* link 4: mass matrix, its row of this joint */
    const tx40_real m4_4 = 0.0054354 - t3;
    const tx40_real t6 = 0.01448 - h5_x;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real neg_h4_x = c4*t6 + 0.00622*s4;
    const tx40_real neg_h4_y = s4*t6 - 0.00622*c4;
    const tx40_real t7 = c4*c4;
    const tx40_real t8 = t3 + 0.0005956;
    const tx40_real t9 = k5_xz - 2.896e-05;
    const tx40_real t10 = c4*s4;
    const tx40_real t11 = t7*t8 + t9*(2.0*t10);
    /* link 4: second moment of the composite body [kg m^2] */
    const tx40_real k4_yy = t11 - (t3 - 0.0024199);
    const tx40_real neg_k4_xy = t8*t10 + t9*(1.0 - 2.0*t7);
    const tx40_real t12 = neg_k5_xy + 0.00254936;
    const tx40_real t13 = k5_yz + 0.00077468;
    const tx40_real k4_xz = c4*t12 + s4*t13;
    const tx40_real k4_yz = s4*t12 - c4*t13;
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_4 = 0.225*neg_h4_y - k4_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const tx40_real fu3_x_2 = c23*neg_h4_y;
    const tx40_real fu3_y_2 = s23*neg_h4_y;
    const tx40_real t14 = k4_xz - 0.225*neg_h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu3_y_2 = s23*t14 + c23*m4_4;
    /* link 2: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu2_y_2 = neg_nu3_y_2 + (-0.035*fu3_x_2 - t4*neg_h4_x);
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_4 = m3_4 + (t4*fu3_y_2 - t5*fu3_x_2);
    const tx40_real t15 = k5_yy + 0.45*neg_h5_y;
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_3 = 0.13108988 - (t11 - t15);
    const tx40_real t16 = neg_h5_y + 0.67724;
    const tx40_real t17 = neg_h4_x - 0.03256;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real h3_x = s23*t16 - c23*t17;
    const tx40_real neg_h3_y = s23*t17 + c23*t16;
    const tx40_real t18 = c23*c23*(t11 + t15 + 0.12053792) - (t14 - 0.00019536)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const tx40_real k3_xx = t15 + 0.1258139 - t18;
    const tx40_real k3_yy = t18 - (t11 - 0.00527598);
    const tx40_real k3_yz = s23*(0.00233496 - neg_k4_xy) + c23*(m3_4 + 0.00200122);
    const tx40_real t19 = 0.035*neg_h3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu2_y_3 = k3_yz - t19;
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_3 = m3_3 - (t5*neg_h3_y - t4*h3_x);
    const tx40_real t20 = k3_yy - k4_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const tx40_real k2_zz = -0.07*neg_h4_y - (t20 - k3_yy);
    const tx40_real t21 = k3_xx - t4*(-2.0*h3_x);
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_2 = t21 - (t5*(2.0*neg_h3_y) - (k4_yy + t20)) + 0.53385475;
    /* link 2: second moment of the composite body [kg m^2] */
    const tx40_real k2_xx = t21 + (0.46482595*(c2*c2) + 0.0015696*(c2*s2) + 0.0345144);
    const tx40_real k2_yz = 0.1602936*s2 + 0.0010352*c2 - (t19 - (k3_yz - t5*neg_h4_y));
    /* link 1: mass matrix, its row of this joint */
    const tx40_real m1_1 = k2_zz + k2_xx + 0.14677892;
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y_3;
    M[3] = neg_nu2_y_2;
    M[4] = neg_nu2_y;
    M[5] = 0.0;
    M[6] = k2_yz;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = 0.0;
    M[12] = neg_nu2_y_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = 0.0;
    M[18] = neg_nu2_y_2;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = 0.0;
    M[24] = neg_nu2_y;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = k5_yz;
    M[28] = 0.0013783;
    M[29] = 0.0;
    M[30] = 0.0;
    M[31] = 0.0;
    M[32] = 0.0;
    M[33] = 0.0;
    M[34] = 0.0;
    M[35] = 0.0;
}
