/*
 * tx40: Staubli TX40 (CAD parameters; friction, rotor inertia and the wrist coupling are not in
 *   it)
 * Numbers: figaroh-plus examples/staubli_TX40, Apache-2.0
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: ca869e1c35fe24e800334b2c139779ed (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0      d 0.32   theta q
 *   2  revolute  alpha -pi/2  a 0      d 0      theta q
 *   3  revolute  alpha 0      a 0.225  d 0.035  theta q
 *   4  revolute  alpha pi/2   a 0      d 0.225  theta q
 *   5  revolute  alpha -pi/2  a 0      d 0      theta q
 *   6  revolute  alpha pi/2   a 0      d 0      theta q + pi
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
 * Of inverse_dynamics, bias the best program known for these parameters, equal to the recursion
 *   without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 161 multiplications, 152 additions = 313; 0 unary minus; 8 sine/cosine
 *   gravity: 16 multiplications, 12 additions = 28; 0 unary minus; 8 sine/cosine
 *   bias: 145 multiplications, 129 additions = 274; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 72 multiplications, 67 additions = 139; 0 unary minus; 8 sine/cosine
 */
#include "tx40.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 161 multiplications, 152 additions = 313; 0 unary minus; 8 sine/cosine */
void tx40_inverse_dynamics(
    const tx40_real q[6],
    const tx40_real qd[6],
    const tx40_real qdd[6],
    tx40_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const tx40_real angle23 = q[1] + q[2];
    const tx40_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const tx40_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam3_23 = s23*qdd[0];
    const tx40_real neg_lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real alpha3_y = neg_ww3_zx - neg_lam3_13;
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real ww3_xy = neg_w3_x*neg_w3_y;
    const tx40_real ww3_zz = w3_z*w3_z;
    const tx40_real ww3_yy = neg_w3_y*neg_w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_12 = alpha3_z - ww3_xy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam3_21 = alpha3_z + ww3_xy;
    const tx40_real neg_lam3_11 = ww3_zz + ww3_yy;
    const tx40_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    /* sines and cosines of the joint angles */
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const tx40_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const tx40_real w4_z = neg_w3_y + qd[3];
    const tx40_real w4_y = w3_z*c4 + neg_w3_x*s4;
    /* link 4: angular acceleration [rad/s^2] */
    const tx40_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const tx40_real ww4_xx = neg_w4_x*neg_w4_x;
    const tx40_real ww4_zz = w4_z*w4_z;
    const tx40_real neg_ww4_xy = neg_w4_x*w4_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam4_12 = alpha4_z + neg_ww4_xy;
    const tx40_real lam4_21 = alpha4_z - neg_ww4_xy;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_z = w4_y + qd[4];
    /* sines and cosines of the joint angles */
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(q[4]);
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(q[1]);
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real neg_ww3_yz = w3_z*neg_w3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const tx40_real neg_alpha3_x = lam3_23 + neg_ww3_yz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam4_23 = neg_lam3_12*s4 - c4*neg_lam3_32;
    const tx40_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* link 5: products of the angular velocity [1/s^2] */
    const tx40_real ww5_zz = w5_z*w5_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam4_13 = neg_lam3_12*c4 + s4*neg_lam3_32;
    const tx40_real t1 = 2.0*w4_z;
    const tx40_real t2 = neg_w4_x*t1;
    const tx40_real neg_lam4_31 = lam4_13 + t2;
    const tx40_real t3 = ww3_zz - ww3_yy;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_22 = neg_lam2_33 + t3;
    const tx40_real t4 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam4_11 = t4 - neg_lam3_22;
    const tx40_real lam4_32 = neg_lam4_23 + w4_y*t1;
    /* link 2: products of the angular velocity [1/s^2] */
    const tx40_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam2_13 = qdd[0]*c2;
    const tx40_real t5 = s2*ww2_zz - (qdd[1]*c2 - 43.6);
    const tx40_real t6 = qdd[1]*s2 + (c2*(neg_lam2_33 + ww2_zz) + 0.15555555555555556*qdd[0]);
    const tx40_real t7 = neg_lam3_12 - s23*t5 - c23*t6;
    const tx40_real t8 = 2.0*(qd[1]*qd[0]);
    const tx40_real t9 = s2*t8 - (neg_lam2_13 - 0.15555555555555556*neg_lam2_33);
    const tx40_real t10 = neg_lam3_32 - t9;
    const tx40_real t11 = c4*t7 + s4*t10;
    const tx40_real t12 = neg_lam4_12 - 2.0*(neg_w4_x*w5_z);
    const tx40_real t13 = 0.0025785*s5;
    const tx40_real t14 = 0.00949389179755672*c5;
    const tx40_real t15 = t13*t14;
    const tx40_real t16 = 0.0025785*c5;
    const tx40_real t17 = t16*t14;
    const tx40_real t18 = t15 + (14.120098039215685*t17 + 0.00051632);
    const tx40_real t19 = t18 - 0.0013783;
    const tx40_real t20 = neg_lam4_23 - qd[4]*t1;
    const tx40_real t21 = t17 - (14.120098039215685*t15 + 1.224e-05);
    const tx40_real t22 = neg_lam4_22 + lam4_11;
    const tx40_real t23 = 0.000918*c5 - t13;
    const tx40_real t24 = s4*t7 - c4*t10;
    const tx40_real t25 = ww4_xx - ww5_zz;
    const tx40_real t26 = 4.08e-06*c5 - 3.06e-06*s5;
    const tx40_real t27 = neg_lam4_31 + qdd[4];
    const tx40_real t28 = t2 - t27;
    const tx40_real t29 = 3.06e-06*c5 + 4.08e-06*s5;
    const tx40_real t30 = 0.00155792*lam4_21 + t20*t21 + 0.00077468*lam4_13 + (2.896e-05*t22 + (t23
        + 0.003258)*t24 - (t25*t26 + t28*t29));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const tx40_real n4_z = 0.0030155*neg_lam4_12 - 0.00254936*neg_lam4_23 - (0.0013995*t11 +
        (t12*t19 - t30));
    const tx40_real t31 = neg_lam3_11 - neg_lam3_22;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real neg_n3_y = 0.00200122*(neg_lam3_12 - 1.1295509739059173*neg_lam3_31) -
        0.00019536*neg_lam3_32 - (0.007326*t9 - n4_z - 0.00233496*(t3 + t31));
    const tx40_real t32 = 0.000918*s5 + t16;
    const tx40_real t33 = neg_lam3_22 - c23*t5 + s23*t6;
    const tx40_real t34 = t28*t18 + t23*t33 + (lam4_32*t26 - neg_lam4_12*t29) + (t4*t21 + t27*t19);
    /* link 5: moment that turns the link [N m] */
    const tx40_real nc5_z = t32*t11 - t34;
    const tx40_real t35 = 0.011359713810524995*lam4_32;
    const tx40_real t36 = t4 + t35;
    const tx40_real t37 = 0.0013995*t33 - t20*t18 + (t29*(ww4_zz - ww5_zz) - t24*(t32 + 0.152379) -
        t12*t21);
    const tx40_real t38 = 0.00254936*lam4_21 + t27*t26 - (2.896e-05*neg_lam4_31 - 0.00077468*(t22 -
        (3.8812152848986194*lam4_32 + t36)) - t37);
    const tx40_real t39 = 0.152379*neg_lam4_23 + (t23*t12 + (0.003258*lam4_21 +
        0.0013995*neg_lam4_22) + t32*t20);
    const tx40_real t40 = 0.0013995*neg_lam4_12 - (t23*(neg_lam4_22 - t25) + (0.152379*lam4_13 -
        t32*t28) - 0.003258*lam4_11);
    const tx40_real t41 = c4*t39 + (0.007326*neg_lam3_31 + s4*t40);
    const tx40_real t42 = 0.00155792*neg_lam4_31 + (0.00077468*neg_lam4_12 + (0.00254936*t36 +
        nc5_z) + 0.152379*t11) - 0.003258*t33;
    const tx40_real t43 = c4*t38 - (t41 + 0.00200122*t3 - (s4*t42 + 0.00752136*neg_lam3_31 -
        0.1789441*neg_lam3_32));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real neg_n3_x = 0.00233496*lam3_21 + t43;
    const tx40_real t44 = 0.46482595*c2;
    const tx40_real t45 = c2*t44;
    const tx40_real t46 = s2*t44;
    const tx40_real t47 = 0.003376747791296936*t45 - 0.0007848 - t46;
    const tx40_real t48 = 0.1602936*s2 + 0.0010352*c2;
    const tx40_real t49 = 0.007326*neg_lam3_11 - s4*t39 + c4*t40;
    const tx40_real t50 = 0.12319852624309392*(0.026445121539614456*neg_lam4_31 + t35) -
        (t32*(ww4_xx + ww5_zz) + (0.007326*lam3_21 + 0.152379*neg_lam3_22) - t23*t27);
    const tx40_real t51 = c23*t49 - s23*t50;
    const tx40_real t52 = qdd[0]*(t45 + (0.003376747791296936*t46 + 0.18129332)) +
        0.15555555555555556*t51 + (ww2_zz*(0.1602936*c2 - 0.0010352*s2) - c2*t41);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const tx40_real n1_z = t47*t8 + (qdd[1]*t48 + t52 + c23*neg_n3_y + s23*neg_n3_x);
    const tx40_real t53 = t49 - (0.00226048*lam3_21 + c4*t42) + (s4*t38 - 0.00752136*(t31 +
        0.974025974025974*t33));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_z = 0.00233496*lam3_23 + (0.00200122*(neg_lam3_13 -
        89.41750532175374*neg_lam3_12) - t53);
    const tx40_real t54 = qdd[0]*t48 - c2*(s23*t49 + (c23*t50 + 23.5160415)) + (s2*(t51 - 0.070632)
        + (0.53385475*qdd[1] + n3_z));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n02_z = t54 - neg_lam2_33*t47;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques that hold the arm at rest
 * 16 multiplications, 12 additions = 28; 0 unary minus; 8 sine/cosine */
void tx40_gravity(const tx40_real q[6], tx40_real tau[6])
{
    /* sines and cosines of the joint angles */
    const tx40_real s5 = sin(q[4]);
    const tx40_real c5 = cos(q[4]);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real hw5_y = -0.1124226*c5 - 0.0400248*s5;
    /* sines and cosines of the joint angles */
    const tx40_real c4 = cos(q[3]);
    const tx40_real angle23 = q[1] + q[2];
    const tx40_real s23 = sin(angle23);
    const tx40_real c23 = cos(angle23);
    /* link 5: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real hw5_x = 0.1124226*s5 - 0.0400248*c5;
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const tx40_real tau5 = hw5_y*(c4*s23) - c23*hw5_x;
    /* sines and cosines of the joint angles */
    const tx40_real s4 = sin(q[3]);
    const tx40_real t1 = 0.1420488 - hw5_x;
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real hw4_y = 0.0610182*c4 - s4*t1;
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const tx40_real tau4 = s23*hw4_y;
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(q[1]);
    /* link 4: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real neg_hw4_x = c4*t1 + 0.0610182*s4;
    /* link 3: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real neg_hw3_x = s23*(hw5_y - 6.6437244) - c23*(0.3194136 - neg_hw4_x);
    /* link 2: first moment of all that the joint carries, before its turn, times gravity [N m] */
    const tx40_real neg_hw2_x = neg_hw3_x - (23.5160415*c2 + 0.070632*s2);
    tau[0] = 0.0;
    tau[1] = neg_hw2_x;
    tau[2] = neg_hw3_x;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 145 multiplications, 129 additions = 274; 0 unary minus; 8 sine/cosine */
void tx40_bias(const tx40_real q[6], const tx40_real qd[6], tx40_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const tx40_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const tx40_real angle23 = q[1] + q[2];
    const tx40_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const tx40_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const tx40_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real neg_ww3_zx = w3_z*neg_w3_x;
    const tx40_real ww3_xy = neg_w3_x*neg_w3_y;
    const tx40_real ww3_zz = w3_z*w3_z;
    const tx40_real ww3_yy = neg_w3_y*neg_w3_y;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_11 = ww3_zz + ww3_yy;
    /* sines and cosines of the joint angles */
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(q[3]);
    /* link 4: angular velocity [rad/s] */
    const tx40_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    const tx40_real w4_z = neg_w3_y + qd[3];
    const tx40_real w4_y = w3_z*c4 + neg_w3_x*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const tx40_real ww4_xx = neg_w4_x*neg_w4_x;
    const tx40_real ww4_zz = w4_z*w4_z;
    const tx40_real neg_ww4_xy = neg_w4_x*w4_y;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam4_12 = neg_ww3_zx - neg_ww4_xy;
    const tx40_real neg_lam4_21 = neg_ww3_zx + neg_ww4_xy;
    /* link 5: angular velocity [rad/s] */
    const tx40_real w5_z = w4_y + qd[4];
    /* sines and cosines of the joint angles */
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(q[4]);
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(q[1]);
    /* link 3: products of the angular velocity [1/s^2] */
    const tx40_real neg_ww3_yz = w3_z*neg_w3_y;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_32 = 2.0*neg_ww3_yz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam4_23 = ww3_xy*s4 + c4*neg_lam3_32;
    const tx40_real neg_lam4_22 = ww4_xx + ww4_zz;
    /* link 5: products of the angular velocity [1/s^2] */
    const tx40_real ww5_zz = w5_z*w5_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam4_13 = ww3_xy*c4 - s4*neg_lam3_32;
    const tx40_real t1 = 2.0*w4_z;
    const tx40_real t2 = neg_w4_x*t1;
    const tx40_real lam4_31 = neg_lam4_13 - t2;
    const tx40_real t3 = ww3_zz - ww3_yy;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real neg_lam3_22 = neg_lam2_33 + t3;
    const tx40_real t4 = ww4_xx - ww4_zz;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const tx40_real lam4_11 = t4 - neg_lam3_22;
    const tx40_real neg_lam4_32 = lam4_23 - w4_y*t1;
    /* link 2: products of the angular velocity [1/s^2] */
    const tx40_real ww2_zz = qd[1]*qd[1];
    const tx40_real t5 = s2*ww2_zz + 43.6;
    const tx40_real t6 = c2*(neg_lam2_33 + ww2_zz);
    const tx40_real t7 = ww3_xy + s23*t5 + c23*t6;
    const tx40_real t8 = 2.0*(qd[1]*qd[0]);
    const tx40_real t9 = s2*t8 + 0.15555555555555556*neg_lam2_33;
    const tx40_real t10 = neg_lam3_32 - t9;
    const tx40_real t11 = c4*t7 - s4*t10;
    const tx40_real t12 = lam4_12 + 2.0*(neg_w4_x*w5_z);
    const tx40_real t13 = 0.0025785*s5;
    const tx40_real t14 = 0.00949389179755672*c5;
    const tx40_real t15 = t13*t14;
    const tx40_real t16 = 0.0025785*c5;
    const tx40_real t17 = t16*t14;
    const tx40_real t18 = t15 + (14.120098039215685*t17 + 0.00051632);
    const tx40_real t19 = t18 - 0.0013783;
    const tx40_real t20 = lam4_23 + qd[4]*t1;
    const tx40_real t21 = t17 - (14.120098039215685*t15 + 1.224e-05);
    const tx40_real t22 = neg_lam4_22 + lam4_11;
    const tx40_real t23 = 0.000918*c5 - t13;
    const tx40_real t24 = s4*t7 + c4*t10;
    const tx40_real t25 = ww4_xx - ww5_zz;
    const tx40_real t26 = 4.08e-06*c5 - 3.06e-06*s5;
    const tx40_real t27 = t2 + lam4_31;
    const tx40_real t28 = 3.06e-06*c5 + 4.08e-06*s5;
    const tx40_real t29 = 0.00155792*neg_lam4_21 + t20*t21 + 0.00077468*neg_lam4_13 - (2.896e-05*t22
        - (t23 + 0.003258)*t24 - (t25*t26 + t27*t28));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const tx40_real n4_z = 0.0013995*t11 + (t12*t19 - t29) - (0.0030155*lam4_12 -
        0.00254936*lam4_23);
    const tx40_real t30 = neg_lam3_11 - neg_lam3_22;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_y = 0.00200122*(ww3_xy + 2.2591019478118346*neg_ww3_zx) +
        0.00039072*neg_ww3_yz + (0.007326*t9 - n4_z - 0.00233496*(t3 + t30));
    const tx40_real t31 = neg_lam3_22 - c23*t5 + s23*t6;
    const tx40_real t32 = lam4_31*t19 - t4*t21 - (t27*t18 + t23*t31 - (neg_lam4_32*t26 -
        lam4_12*t28));
    const tx40_real t33 = 0.000918*s5 + t16;
    /* link 5: moment that turns the link [N m] */
    const tx40_real nc5_z = t32 - t33*t11;
    const tx40_real t34 = 0.011359713810524995*neg_lam4_32;
    const tx40_real t35 = t4 - t34;
    const tx40_real t36 = t20*t18 + (0.0013995*t31 - (0.00254936*neg_lam4_21 - 0.00077468*(t22 +
        (3.8812152848986194*neg_lam4_32 - t35))));
    const tx40_real t37 = t12*t21 + (t24*(t33 + 0.152379) + (t28*(ww4_zz - ww5_zz) + t36)) -
        lam4_31*(t26 - 2.896e-05);
    const tx40_real t38 = 0.152379*lam4_23 + (t23*t12 + (0.003258*neg_lam4_21 -
        0.0013995*neg_lam4_22) + t33*t20);
    const tx40_real t39 = 0.0013995*lam4_12 + (t23*(neg_lam4_22 - t25) - (0.152379*neg_lam4_13 +
        t33*t27) - 0.003258*lam4_11);
    const tx40_real t40 = c4*t38 - (0.014652*neg_ww3_zx - s4*t39);
    const tx40_real t41 = 0.00155792*lam4_31 + (0.00077468*lam4_12 - (0.00254936*t35 + nc5_z) +
        0.152379*t11) + 0.003258*t31;
    const tx40_real t42 = c4*t37 + (t40 - 0.00200122*t3 - (s4*t41 - 0.01504272*neg_ww3_zx +
        0.3578882*neg_ww3_yz));
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real neg_n3_x = 0.00233496*ww3_xy + t42;
    const tx40_real t43 = 0.007326*neg_lam3_11 + s4*t38 - c4*t39;
    const tx40_real t44 = 0.12319852624309392*(0.026445121539614456*lam4_31 + t34) + (t33*(ww4_xx +
        ww5_zz) + (0.007326*ww3_xy + 0.152379*neg_lam3_22) + t23*lam4_31);
    const tx40_real t45 = c23*t43 + s23*t44;
    const tx40_real t46 = 0.15555555555555556*t45 + (ww2_zz*(0.1602936*c2 - 0.0010352*s2) + c2*t40)
        - c23*n3_y;
    const tx40_real t47 = 0.46482595*c2;
    const tx40_real t48 = s2*t47 - (0.003376747791296936*(c2*t47) - 0.0007848);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const tx40_real n1_z = t46 + s23*neg_n3_x - t48*t8;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const tx40_real n3_z = 0.00752136*(t30 + 0.974025974025974*t31) - (s4*t37 + (t43 + c4*t41)) +
        0.18120458*ww3_xy;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const tx40_real n02_z = neg_lam2_33*t48 - (c2*(s23*t43 - (c23*t44 - 23.5160415)) - (s2*(t45 -
        0.070632) + n3_z));
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* mass matrix, rotor inertias on its diagonal
 * 72 multiplications, 67 additions = 139; 0 unary minus; 8 sine/cosine */
void tx40_mass_matrix(const tx40_real q[6], tx40_real M[36])
{
    /* sines and cosines of the joint angles */
    const tx40_real c2 = cos(q[1]);
    const tx40_real s2 = sin(q[1]);
    const tx40_real c4 = cos(q[3]);
    const tx40_real s4 = sin(q[3]);
    const tx40_real c5 = cos(q[4]);
    const tx40_real s5 = sin(q[4]);
    const tx40_real angle23 = q[1] + q[2];
    const tx40_real c23 = cos(angle23);
    const tx40_real s23 = sin(angle23);
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real h5_x = 0.01146*s5 - 0.00408*c5;
    const tx40_real t1 = 3.06e-06*s5;
    /* link 5: second moment of the composite body [kg m^2] */
    const tx40_real k5_xz = 4.08e-06*c5 - t1;
    const tx40_real t2 = h5_x - 0.01448;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real h4_x = c4*t2 - 0.00622*s4;
    const tx40_real h4_y = s4*t2 + 0.00622*c4;
    /* link 5: second moment of the composite body [kg m^2] */
    const tx40_real k5_yz = 1.3333333333333333*(t1 + 2.295e-06*c5);
    const tx40_real t3 = 2.448e-05*c5;
    const tx40_real t4 = s5*t3;
    const tx40_real t5 = c5*t3;
    const tx40_real t6 = t4 + 0.1781184 + 14.120098039215685*t5;
    /* link 4: mass matrix, its row of this joint */
    const tx40_real m4_4 = 0.1835538 - t6;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real neg_h5_y = 1988.235294117647*(k5_yz + 0.6627218934911243*k5_xz);
    const tx40_real t7 = t5 - (14.120098039215685*t4 + 0.0025616);
    const tx40_real t8 = 0.225*h4_x;
    const tx40_real t9 = k5_yz + 0.00077468;
    const tx40_real t10 = c4*t7 - (t8 + s4*t9);
    const tx40_real t11 = 0.035*h4_y;
    const tx40_real t12 = t11 + m4_4;
    const tx40_real t13 = 0.225*c2;
    const tx40_real t14 = s23*t13;
    const tx40_real t15 = neg_h5_y + 0.67724;
    const tx40_real t16 = h4_x + 0.03256;
    const tx40_real t17 = c23*t13;
    const tx40_real t18 = t14*t15 + t16*t17;
    const tx40_real t19 = c23*s23*(t10 + 0.00019536) - (0.0007848*(c2*(s2 + 296.14293450560655*c2))
        + (t12 + t18));
    const tx40_real t20 = c4*k5_xz;
    const tx40_real t21 = s4*(t6 - 0.1775228) - (t20 + (t20 - 5.792e-05*c4));
    const tx40_real t22 = t6 - 0.18279878 - s4*t21;
    const tx40_real t23 = 0.45*t15 + (t6 - 0.35654618);
    /* link 1: mass matrix, its row of this joint */
    const tx40_real m1_1 = t6 - t19 - (t19 - s23*(s23*(t22 + t23)));
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_4 = c4*t9 - (0.225*h4_y - s4*t7);
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const tx40_real h3_y = s23*t16 - c23*t15;
    const tx40_real t24 = 0.035*h3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const tx40_real neg_nu2_y = c23*(m3_4 + 0.00200122) + (t24 - s23*(k5_xz + (c4*t21 -
        0.00236392)));
    const tx40_real t25 = 6.428571428571429*s2;
    const tx40_real t26 = t11*t25;
    /* link 2: second moment of the composite body [kg m^2] */
    const tx40_real k2_yz = 0.1602936*s2 + t26 + (0.0010352*c2 + neg_nu2_y);
    /* link 4: force for a unit acceleration of a joint further out */
    const tx40_real fu4_x = c4*neg_h5_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const tx40_real fu3_x = c23*fu4_x - s23*h5_x;
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_3 = t23 - t22;
    const tx40_real t27 = t18 + t25*t24;
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_3 = m3_3 + t27;
    const tx40_real m2_2 = m2_3 + (t27 + 0.53385475);
    const tx40_real m2_4 = m3_4 + c23*t26 - h4_y*t14;
    const tx40_real t28 = 0.225*t15 - 0.1510007;
    /* link 3: mass matrix, its row of this joint */
    const tx40_real m3_5 = c4*t28 - s4*k5_xz;
    const tx40_real t29 = -0.035*fu3_x;
    /* link 2: mass matrix, its row of this joint */
    const tx40_real m2_5 = t14*fu4_x + m3_5 + h5_x*t17 + t25*t29;
    const tx40_real t30 = c23*t12 - s23*t10 + c2*t8;
    const tx40_real t31 = c23*k5_yz + (neg_h5_y*(s4*t13) + (t29 + s23*(t20 + s4*t28)));
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y;
    M[3] = t30;
    M[4] = t31;
    M[5] = 0.0;
    M[6] = k2_yz;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = 0.0;
    M[12] = neg_nu2_y;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = 0.0;
    M[18] = t30;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = 0.0;
    M[24] = t31;
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
