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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
 *   gravity: 16 multiplications, 7 additions = 23; 1 unary minus; 8 sine/cosine
 *   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 84 multiplications, 68 additions = 152; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 298 multiplications, 228 additions, 6 divisions = 532; 2 unary minus; 8
 *       sine/cosine
 */
#include "puma560.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine */
void puma560_inverse_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real qdd[6],
    puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_13 = c23*qdd[0];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_real alpha3_y = neg_ww3_zx - neg_lam3_13;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_12 = alpha3_z - ww3_xy;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const puma560_real lam3_21 = alpha3_z + ww3_xy;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(again[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = neg_w3_x*s4 + w3_z*c4;
    const puma560_real w4_z = neg_w3_y + qd[3];
    const puma560_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_real w5_y = neg_w4_x*s5 - w4_z*c5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_32 = s23*qdd[0] + w3_z*(2.0*neg_w3_y);
    const puma560_real t1 = neg_lam3_12*c4 + s4*neg_lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy + t1) + qdd[4];
    const puma560_real t2 = neg_lam3_12*s4 - c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz + t2;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = neg_w5_x*qd[4] - s5*alpha4_x - alpha4_z*c5;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_z = 4e-05*(qdd[5] - alpha5_y);
    const puma560_real t3 = 0.0002*w5_y;
    const puma560_real t4 = t3 - 4e-05*w6_z;
    const puma560_real t5 = 0.000432288*s5;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*(w5_y*(qd[4] + w5_z)) - (alpha4_z*t5 - t6*alpha4_x);
    const puma560_real t8 = 2.876748834110593*s2;
    const puma560_real t9 = 2.876748834110593*c2;
    const puma560_real t10 = qdd[1]*t8 + (qdd[0] + t9*(neg_lam2_33 + ww2_zz));
    const puma560_real t11 = ww2_zz*t8;
    const puma560_real t12 = t11 - (qdd[1]*t9 - 65.28980679546969);
    const puma560_real t13 = 0.13524317121918722*neg_lam3_11 - (c23*t10 + s23*t12);
    const puma560_real t14 = 2.0*(qd[1]*qd[0]);
    const puma560_real t15 = 0.13524317121918722*neg_lam3_31 - (neg_lam2_33 - qdd[0]*t9) - t14*t8;
    const puma560_real t16 = s4*t13 - c4*t15;
    const puma560_real t17 = t7 + 0.044830870394712535*t16;
    const puma560_real t18 = 0.1293554295*t2 + t17;
    const puma560_real t19 = w5_z*t4 - 0.00964264124684461*(t18 + 129.06435256003232*t7);
    const puma560_real t20 = 0.0001*neg_ww5_zx - n06_z + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = 0.0013*alpha4_z + s5*t19 - c5*t20;
    const puma560_real t21 = 46.378743915669716*neg_lam3_12;
    const puma560_real t22 = 67.24917867772109*neg_lam3_32;
    const puma560_real t23 = c4*t13 + s4*t15;
    const puma560_real t24 = neg_lam5_22*t5 - t6*neg_lam5_12;
    const puma560_real t25 = 0.0281625125*t23 - (t24 - 0.1293554295*t1);
    const puma560_real t26 = 0.01666835789471254*t16 - t18;
    const puma560_real t27 = s4*t25 + c4*t26;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_y = 0.13524317121918722*(0.0007499511665665606*(t21 - t22) + t27) +
        (0.01625*neg_lam3_31 - n4_z);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t20 - c5*t19;
    const puma560_real t28 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = t28 - neg_lam2_33;
    const puma560_real t29 = c23*t12 + (0.13524317121918722*lam3_21 - s23*t10);
    const puma560_real t30 = -2.8854097268487675*lam3_22 - t29;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t5*t30 + (0.00064216*neg_lam5_12 + t6*(t23 + 2.8854097268487675*t1) -
        neg_w5_x*(t3 + t4));
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real t31 = 2.8854097268487675*t17 + n4_x;
    const puma560_real t32 = 2.8854097268487675*t24 - n5_z - (nc4_y + 0.1293554295*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t31 - 0.004704*(t22 - t28) + (0.0068208*neg_lam3_31 + s4*t32);
    const puma560_real t33 = 0.0141984*c2;
    const puma560_real t34 = t33 + 0.3642398174241758*s2;
    const puma560_real t35 = t34 - 0.36469509561966457*s2;
    const puma560_real t36 = 1.6727941176470589*t34;
    const puma560_real t37 = s2*t33;
    const puma560_real t38 = c2*t33;
    const puma560_real t39 = 96.40502817218841*(t37 - 7.363931254000739e-05) + t38;
    const puma560_real t40 = ww2_zz*(42.91316091954023*t35) + (qdd[1]*t36 - t39*t14) +
        (qdd[0]*(96.40502817218841*t38 - (t37 - 2.646693438)) - (c23*n3_y - t9*t27));
    const puma560_real t41 = c4*t25 - s4*t26;
    const puma560_real t42 = 0.01666835789471254*(t29 + 2.689579302165907*t30) + (neg_lam5_22*t6 +
        t5*neg_lam5_12);
    const puma560_real t43 = c23*t41 - s23*t42;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t40 - s23*n3_x - t43 - 0.0014646998319327732*t11;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = 0.0068208*(t21 - (neg_lam3_11 + lam3_22 - (2.382418484635233*lam3_21 -
        19.8280511405095*t42))) - 0.004704*neg_lam3_13 + (s4*t31 - c4*t32);
    const puma560_real t44 = 6.225049952*qdd[1] + neg_lam2_33*t39 + (n3_z - (2247.2413793103447*t35
        - t9*(s23*t41 + c23*t42)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = t44 - (t8*t43 - qdd[0]*t36);
    /* link 3: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau3 = n3_z + 0.83*qdd[2];
    /* link 4: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau4 = n4_z + 0.2*qdd[3];
    /* link 5: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau5 = n5_z + 0.179*qdd[4];
    /* link 6: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau6 = n06_z + 0.193*qdd[5];
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = tau3;
    tau[3] = tau4;
    tau[4] = tau5;
    tau[5] = tau6;
}

/* torques that hold the arm at rest
 * 16 multiplications, 7 additions = 23; 1 unary minus; 8 sine/cosine */
void puma560_gravity(const puma560_real q[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* sines and cosines of the joint angles */
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_x = -9.8*s23;
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a3_y = -9.8*c23;
    /* sines and cosines of the joint angles */
    const puma560_real c4 = cos(q[3]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a4_x = a3_x*c4;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(again[3]);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real neg_a4_y = a3_x*s4;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_real a5_x = a4_x*c5 + a3_y*s5;
    /* link 5: moment that turns the link [N m] */
    const puma560_real nc5_z = 0.00288*a5_x;
    const puma560_real nc5_x = 0.00288*neg_a4_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n05_y = s5*nc5_x;
    const puma560_real n05_x = c5*nc5_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n04_y = s4*n05_x + c4*nc5_z;
    /* link 3: moment that turns the link [N m] */
    const puma560_real nc3_z = 0.248675*c23 - 8.445591*s23;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = n04_y + nc3_z;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    /* link 2: moment that turns the link [N m] */
    const puma560_real nc2_z = 1.02312*s2 - 37.196782*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n02_z = n3_z + nc2_z;
    const puma560_real t1 = -n05_y;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = t1;
    tau[4] = nc5_z;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine */
void puma560_bias(const puma560_real q[6], const puma560_real qd[6], puma560_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(again[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = neg_w3_x*s4 + w3_z*c4;
    const puma560_real w4_z = neg_w3_y + qd[3];
    const puma560_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_real w5_y = neg_w4_x*s5 - w4_z*c5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_32 = w3_z*(2.0*neg_w3_y);
    const puma560_real t1 = ww3_xy*c4 - s4*neg_lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy - t1);
    const puma560_real t2 = ww3_xy*s4 + c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz - t2;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_z = -4e-05*alpha5_y;
    const puma560_real t3 = 0.0002*w5_y;
    const puma560_real t4 = t3 - 4e-05*w6_z;
    const puma560_real t5 = 0.000432288*s5;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*(w5_y*(qd[4] + w5_z)) + (neg_ww3_zx*t5 + t6*alpha4_x);
    const puma560_real t8 = 2.876748834110593*c2;
    const puma560_real t9 = t8*(neg_lam2_33 + ww2_zz);
    const puma560_real t10 = 2.876748834110593*s2;
    const puma560_real t11 = ww2_zz*t10;
    const puma560_real t12 = t11 + 65.28980679546969;
    const puma560_real t13 = 0.13524317121918722*neg_lam3_11 - (c23*t9 + s23*t12);
    const puma560_real t14 = 2.0*(qd[1]*qd[0]);
    const puma560_real t15 = neg_lam2_33 - 0.27048634243837444*neg_ww3_zx + t14*t10;
    const puma560_real t16 = s4*t13 + c4*t15;
    const puma560_real t17 = t7 + 0.044830870394712535*t16;
    const puma560_real t18 = 0.1293554295*t2 - t17;
    const puma560_real t19 = w5_z*t4 + 0.00964264124684461*(t18 - 129.06435256003232*t7);
    const puma560_real t20 = 0.0001*neg_ww5_zx - n06_z + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = s5*t19 - 0.0013*neg_ww3_zx - c5*t20;
    const puma560_real t21 = 46.378743915669716*ww3_xy;
    const puma560_real t22 = 67.24917867772109*neg_lam3_32;
    const puma560_real t23 = c4*t13 - s4*t15;
    const puma560_real t24 = neg_lam5_22*t5 - t6*neg_lam5_12;
    const puma560_real t25 = 0.0281625125*t23 - (t24 + 0.1293554295*t1);
    const puma560_real t26 = 0.01666835789471254*t16 + t18;
    const puma560_real t27 = s4*t25 + c4*t26;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n3_y = 0.13524317121918722*(0.0007499511665665606*(t21 + t22) - t27) -
        (0.0325*neg_ww3_zx - n4_z);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t20 - c5*t19;
    const puma560_real t28 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = t28 - neg_lam2_33;
    const puma560_real t29 = c23*t12 + (0.13524317121918722*ww3_xy - s23*t9);
    const puma560_real t30 = -2.8854097268487675*lam3_22 - t29;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t5*t30 + (0.00064216*neg_lam5_12 + t6*(t23 - 2.8854097268487675*t1) -
        neg_w5_x*(t3 + t4));
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real t31 = 2.8854097268487675*t17 + n4_x;
    const puma560_real t32 = 2.8854097268487675*t24 - n5_z - (nc4_y + 0.1293554295*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t31 - 0.004704*(t22 - t28) + (0.0136416*neg_ww3_zx + s4*t32);
    const puma560_real t33 = 0.0141984*c2;
    const puma560_real t34 = t33 - 0.0004552781954887218*s2;
    const puma560_real t35 = 96.40502817218841*(s2*t33 - 7.363931254000739e-05) + c2*t33;
    const puma560_real t36 = ww2_zz*(42.91316091954023*t34) - t35*t14 + (c23*neg_n3_y + t8*t27) -
        s23*n3_x;
    const puma560_real t37 = c4*t25 - s4*t26;
    const puma560_real t38 = 0.01666835789471254*(t29 + 2.689579302165907*t30) + (neg_lam5_22*t6 +
        t5*neg_lam5_12);
    const puma560_real t39 = c23*t37 - s23*t38;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t36 - t39 - 0.0014646998319327732*t11;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = s4*t31 - c4*t32 - 0.0068208*(t21 + (neg_lam3_11 + lam3_22 -
        (2.382418484635233*ww3_xy - 19.8280511405095*t38)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = neg_lam2_33*t35 - (2247.2413793103447*t34 - t8*(s23*t37 + c23*t38) -
        n3_z) - t10*t39;
    tau[0] = tau1;
    tau[1] = tau2;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n06_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 84 multiplications, 68 additions = 152; 0 unary minus; 8 sine/cosine */
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
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_y = h3_y + (3.79559*s2 + 0.1044*c2);
    const puma560_real t13 = k3_xx + t2*(2.0*h3_x);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xx = t13 + (1.601861202*(c2*c2) - 0.0141984*(c2*s2) + 0.0731264);
    const puma560_real k2_yz = t3*h4_y - neg_k3_yz + (0.12059664*s2 + 0.00808056*c2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = t13 + (k3_yy + t3*(2.0*h3_y)) + 6.458114002;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real m1_2 = k2_yz + 0.1501*h2_y;
    const puma560_real m1_1 = k2_xx + (k4_yy + 0.3002*h4_y) + 2.6017295505;
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
 * 298 multiplications, 228 additions, 6 divisions = 532; 2 unary minus; 8 sine/cosine */
void puma560_forward_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real tau[6],
    puma560_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_real *const again = q;
    /* link 3: angular velocity [rad/s] */
    const puma560_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_real angle23 = q[1] + q[2];
    const puma560_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_x = s23*qd[0];
    /* sines and cosines of the joint angles */
    const puma560_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww3_zx = w3_z*neg_w3_x;
    const puma560_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_real ww3_yy = neg_w3_y*neg_w3_y;
    const puma560_real ww3_zz = w3_z*w3_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_11 = ww3_yy + ww3_zz;
    /* sines and cosines of the joint angles */
    const puma560_real s4 = sin(again[3]);
    const puma560_real c4 = cos(q[3]);
    /* link 4: angular velocity [rad/s] */
    const puma560_real w4_y = neg_w3_x*s4 + w3_z*c4;
    const puma560_real w4_z = neg_w3_y + qd[3];
    const puma560_real neg_w4_x = neg_w3_x*c4 - w3_z*s4;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_real ww4_yz = w4_y*w4_z;
    const puma560_real neg_ww4_zx = w4_z*neg_w4_x;
    /* sines and cosines of the joint angles */
    const puma560_real c5 = cos(q[4]);
    const puma560_real s5 = sin(again[4]);
    /* link 5: angular velocity [rad/s] */
    const puma560_real neg_w5_x = neg_w4_x*c5 + w4_z*s5;
    const puma560_real w5_y = neg_w4_x*s5 - w4_z*c5;
    const puma560_real w5_z = w4_y + qd[4];
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_xy = neg_w5_x*w5_y;
    const puma560_real ww5_xx = neg_w5_x*neg_w5_x;
    const puma560_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_22 = ww5_xx + ww5_zz;
    /* link 6: angular velocity [rad/s] */
    const puma560_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const puma560_real c2 = cos(q[1]);
    const puma560_real s2 = sin(again[1]);
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_real ww2_zz = qd[1]*qd[1];
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam3_32 = w3_z*(2.0*neg_w3_y);
    const puma560_real t1 = ww3_xy*c4 - s4*neg_lam3_32;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy - t1);
    const puma560_real t2 = ww3_xy*s4 + c4*neg_lam3_32;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_real alpha4_x = ww4_yz - t2;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_real neg_ww5_zx = neg_w5_x*w5_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_real alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd[4] - s5*alpha4_x);
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_real n06_z = -4e-05*alpha5_y;
    const puma560_real t3 = 0.0002*w5_y;
    const puma560_real t4 = t3 - 4e-05*w6_z;
    const puma560_real t5 = 0.000432288*s5;
    const puma560_real t6 = 0.000432288*c5;
    const puma560_real t7 = 0.000432288*(w5_y*(qd[4] + w5_z)) + (neg_ww3_zx*t5 + alpha4_x*t6);
    const puma560_real t8 = 2.876748834110593*c2;
    const puma560_real t9 = t8*(neg_lam2_33 + ww2_zz);
    const puma560_real t10 = 2.876748834110593*s2;
    const puma560_real t11 = ww2_zz*t10;
    const puma560_real t12 = t11 + 65.28980679546969;
    const puma560_real t13 = 0.13524317121918722*neg_lam3_11 - (c23*t9 + s23*t12);
    const puma560_real t14 = 2.0*(qd[1]*qd[0]);
    const puma560_real t15 = neg_lam2_33 - 0.27048634243837444*neg_ww3_zx + t10*t14;
    const puma560_real t16 = s4*t13 + c4*t15;
    const puma560_real t17 = t7 + 0.044830870394712535*t16;
    const puma560_real t18 = 0.1293554295*t2 - t17;
    const puma560_real t19 = w5_z*t4 + 0.00964264124684461*(t18 - 129.06435256003232*t7);
    const puma560_real t20 = 0.0001*neg_ww5_zx - n06_z + 0.0003*alpha5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_z = s5*t19 - 0.0013*neg_ww3_zx - c5*t20;
    const puma560_real t21 = 46.378743915669716*ww3_xy;
    const puma560_real t22 = 67.24917867772109*neg_lam3_32;
    const puma560_real t23 = c4*t13 - s4*t15;
    const puma560_real t24 = neg_lam5_22*t5 - neg_lam5_12*t6;
    const puma560_real t25 = 0.0281625125*t23 - (t24 + 0.1293554295*t1);
    const puma560_real t26 = t18 + 0.01666835789471254*t16;
    const puma560_real t27 = s4*t25 + c4*t26;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real neg_n3_y = 0.13524317121918722*(0.0007499511665665606*(t21 + t22) - t27) +
        (n4_z - 0.0325*neg_ww3_zx);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_real n4_x = 0.0013*ww4_yz - s5*t20 - c5*t19;
    const puma560_real t28 = ww3_yy - ww3_zz;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_real lam3_22 = t28 - neg_lam2_33;
    const puma560_real t29 = c23*t12 + (0.13524317121918722*ww3_xy - s23*t9);
    const puma560_real t30 = -2.8854097268487675*lam3_22 - t29;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_real n5_z = t5*t30 + (0.00064216*neg_lam5_12 + t6*(t23 - 2.8854097268487675*t1) -
        neg_w5_x*(t3 + t4));
    /* link 4: moment that turns the link [N m] */
    const puma560_real nc4_y = 0.0013*neg_ww4_zx;
    const puma560_real t31 = n4_x + 2.8854097268487675*t17;
    const puma560_real t32 = n5_z - 2.8854097268487675*t24 + (nc4_y + 0.1293554295*t23);
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_x = c4*t31 - 0.004704*(t22 - t28) + (0.0136416*neg_ww3_zx - s4*t32);
    const puma560_real t33 = 0.0141984*c2;
    const puma560_real t34 = t33 - 0.0004552781954887218*s2;
    const puma560_real t35 = 96.40502817218841*(s2*t33 - 7.363931254000739e-05) + c2*t33;
    const puma560_real t36 = ww2_zz*(42.91316091954023*t34) - t14*t35 + (c23*neg_n3_y + t8*t27) -
        s23*n3_x;
    const puma560_real t37 = c4*t25 - s4*t26;
    const puma560_real t38 = 0.01666835789471254*(t29 + 2.689579302165907*t30) + (neg_lam5_22*t6 +
        neg_lam5_12*t5);
    const puma560_real t39 = c23*t37 - s23*t38;
    /* link 1: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau1 = t36 - t39 - 0.0014646998319327732*t11;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_real n3_z = s4*t31 + c4*t32 - 0.0068208*(t21 + (neg_lam3_11 + lam3_22 -
        (2.382418484635233*ww3_xy - 19.8280511405095*t38)));
    /* link 2: joint torque [N m], at a prismatic joint force [N] */
    const puma560_real tau2 = neg_lam2_33*t35 + (n3_z - (2247.2413793103447*t34 - t8*(s23*t37 +
        c23*t38))) - t10*t39;
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
    const puma560_real t40 = 0.00020216*(c5*c5);
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_real k5_yy = t40 + 0.00022;
    const puma560_real neg_k5_xy = 0.00020216*(c5*s5);
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_real fu4_x = c4*neg_h5_y;
    const puma560_real fu4_y = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_real nu4_x_2 = -0.00064216*s4;
    const puma560_real nu4_y_2 = 0.00064216*c4;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_5 = nu4_y_2 - (5.8464e-05*s5 - 0.4331*fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real fu3_x = c23*fu4_x - s23*h5_x;
    const puma560_real fu3_y = s23*fu4_x + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y = c23*(0.0203*fu4_y) - s23*(0.4331*fu4_y - nu4_x_2);
    const puma560_real t41 = 0.4318*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y = nu3_y - fu4_y*t41;
    const puma560_real t42 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_5 = m3_5 + (fu3_y*t41 - fu3_x*t42);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real neg_m1_5 = nu2_y + 0.1501*fu3_x;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h4_x = c4*h5_x;
    const puma560_real h4_y = s4*h5_x;
    const puma560_real t43 = t40 - 0.00030216;
    const puma560_real t44 = c4*c4*t43;
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_real k4_xx = 0.00077 - t44;
    const puma560_real k4_yy = t44 - (t40 - 0.00107216);
    const puma560_real neg_k4_xy = t43*(s4*c4);
    const puma560_real k4_xz = c4*neg_k5_xy;
    const puma560_real k4_yz = s4*neg_k5_xy;
    /* link 4: mass matrix, its row of this joint */
    const puma560_real m4_4 = 0.20184216 - t40;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real neg_m3_4 = k4_yz + 0.4331*h4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_real neg_fu3_x = c23*h4_y;
    const puma560_real neg_fu3_y = s23*h4_y;
    const puma560_real t45 = 0.4331*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_real nu3_y_2 = c23*(t40 - 0.00184216 + 0.0203*h4_x) - s23*(k4_xz + t45);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_real nu2_y_2 = nu3_y_2 - t41*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real neg_m2_4 = neg_m3_4 + (t41*neg_fu3_y - t42*neg_fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real neg_m1_4 = nu2_y_2 - 0.1501*neg_fu3_x;
    const puma560_real t46 = h4_x - 0.025375;
    const puma560_real t47 = neg_h5_y + 0.861795;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h3_x = c23*t46 + s23*t47;
    const puma560_real h3_y = s23*t46 - c23*t47;
    const puma560_real t48 = k5_yy + 0.002494656*c5;
    const puma560_real t49 = 0.0406*h4_x - k4_xx;
    const puma560_real t50 = c23*c23*(t48 + t49 + 0.298925024) - (t45 + (k4_xz - 5.8464e-05*c5) -
        0.0106736385)*(2.0*(s23*c23));
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_real k3_xx = t48 + 0.3156901365 - t50;
    const puma560_real k3_yy = t50 - (t49 - 0.0167651125);
    const puma560_real neg_k3_yz = s23*(neg_k4_xy + 0.0203*h4_y) + c23*(neg_m3_4 + 0.004704);
    const puma560_real t51 = t48 - t49;
    /* link 3: mass matrix, its row of this joint */
    const puma560_real m3_3 = t51 + 1.162455249;
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_3 = t41*h3_x + t42*h3_y + (t51 + 0.332455249);
    /* link 1: mass matrix, its row of this joint */
    const puma560_real neg_m1_3 = neg_k3_yz - 0.1501*h3_y;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_real h2_y = h3_y + (3.79559*s2 + 0.1044*c2);
    const puma560_real t52 = k3_xx + t41*(2.0*h3_x);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_real k2_xx = t52 + (1.601861202*(c2*c2) - 0.0141984*(c2*s2) + 0.0731264);
    const puma560_real neg_k2_yz = neg_k3_yz - t42*h4_y - (0.12059664*s2 + 0.00808056*c2);
    /* link 2: mass matrix, its row of this joint */
    const puma560_real m2_2 = t52 + (k3_yy + t42*(2.0*h3_y)) + 6.458114002;
    /* link 1: mass matrix, its row of this joint */
    const puma560_real neg_m1_2 = neg_k2_yz - 0.1501*h2_y;
    const puma560_real m1_1 = k2_xx + (k4_yy + 0.3002*h4_y) + 2.6017295505;
    /* link 1: forward substitution */
    const puma560_real neg_y1 = tau1 - tau[0];
    /* factorisation M = L D L^T */
    const puma560_real ipivot1 = 1.0 / m1_1;
    const puma560_real neg_l2_1 = neg_m1_2*ipivot1;
    const puma560_real neg_l3_1 = neg_m1_3*ipivot1;
    const puma560_real neg_l4_1 = neg_m1_4*ipivot1;
    const puma560_real neg_l5_1 = neg_m1_5*ipivot1;
    const puma560_real l6_1 = neg_nu3_y*ipivot1;
    const puma560_real pivot2 = m2_2 - neg_m1_2*neg_l2_1;
    const puma560_real ipivot2 = 1.0 / pivot2;
    const puma560_real ld3_2 = m2_3 - neg_m1_2*neg_l3_1;
    const puma560_real l3_2 = ipivot2*ld3_2;
    const puma560_real neg_ld4_2 = neg_m2_4 + neg_m1_2*neg_l4_1;
    const puma560_real neg_l4_2 = ipivot2*neg_ld4_2;
    const puma560_real ld5_2 = m2_5 - neg_m1_2*neg_l5_1;
    const puma560_real l5_2 = ipivot2*ld5_2;
    const puma560_real ld6_2 = nu4_y + neg_m1_2*l6_1;
    const puma560_real l6_2 = ipivot2*ld6_2;
    const puma560_real pivot3 = m3_3 - neg_m1_3*neg_l3_1 - ld3_2*l3_2;
    const puma560_real ipivot3 = 1.0 / pivot3;
    const puma560_real neg_ld4_3 = neg_m3_4 + neg_m1_3*neg_l4_1 - ld3_2*neg_l4_2;
    const puma560_real neg_l4_3 = ipivot3*neg_ld4_3;
    const puma560_real ld5_3 = m3_5 - neg_m1_3*neg_l5_1 - ld3_2*l5_2;
    const puma560_real l5_3 = ipivot3*ld5_3;
    const puma560_real ld6_3 = nu4_y + neg_m1_3*l6_1 - ld3_2*l6_2;
    const puma560_real l6_3 = ipivot3*ld6_3;
    const puma560_real neg_pivot4 = neg_m1_4*neg_l4_1 - m4_4 + neg_ld4_2*neg_l4_2 +
        neg_ld4_3*neg_l4_3;
    const puma560_real neg_ipivot4 = 1.0 / neg_pivot4;
    const puma560_real neg_ld5_4 = neg_m1_4*neg_l5_1 - neg_ld4_2*l5_2 - neg_ld4_3*l5_3;
    const puma560_real l5_4 = neg_ipivot4*neg_ld5_4;
    const puma560_real ld6_4 = neg_nu5_y + neg_m1_4*l6_1 + neg_ld4_2*l6_2 + neg_ld4_3*l6_3;
    const puma560_real neg_l6_4 = neg_ipivot4*ld6_4;
    const puma560_real neg_pivot5 = neg_m1_5*neg_l5_1 - 0.17964216 + ld5_2*l5_2 + ld5_3*l5_3 -
        neg_ld5_4*l5_4;
    const puma560_real neg_ipivot5 = 1.0 / neg_pivot5;
    const puma560_real ld6_5 = neg_m1_5*l6_1 - ld5_2*l6_2 - ld5_3*l6_3 - neg_ld5_4*neg_l6_4;
    const puma560_real neg_l6_5 = neg_ipivot5*ld6_5;
    const puma560_real neg_pivot6 = neg_nu3_y*l6_1 - 0.19304 + ld6_2*l6_2 + ld6_3*l6_3 -
        ld6_4*neg_l6_4 - ld6_5*neg_l6_5;
    const puma560_real neg_ipivot6 = 1.0 / neg_pivot6;
    /* link 2: forward substitution */
    const puma560_real neg_y2 = tau2 - tau[1] + neg_y1*neg_l2_1;
    /* link 3: forward substitution */
    const puma560_real neg_y3 = n3_z - tau[2] + neg_y1*neg_l3_1 - l3_2*neg_y2;
    /* link 4: forward substitution */
    const puma560_real neg_y4 = n4_z - tau[3] + neg_y1*neg_l4_1 + neg_l4_2*neg_y2 + neg_l4_3*neg_y3;
    /* link 5: forward substitution */
    const puma560_real neg_y5 = n5_z - tau[4] + neg_y1*neg_l5_1 - l5_2*neg_y2 - l5_3*neg_y3 -
        l5_4*neg_y4;
    /* link 6: forward substitution */
    const puma560_real y6 = tau[5] - n06_z + neg_y1*l6_1 + l6_2*neg_y2 + l6_3*neg_y3 -
        neg_l6_4*neg_y4 - neg_l6_5*neg_y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real neg_qdd6 = neg_ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd5 = neg_ipivot5*neg_y5 - neg_l6_5*neg_qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd4 = neg_ipivot4*neg_y4 - l5_4*qdd5 - neg_l6_4*neg_qdd6;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real neg_qdd3 = ipivot3*neg_y3 - neg_l4_3*qdd4 + l5_3*qdd5 - l6_3*neg_qdd6;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd2 = l6_2*neg_qdd6 - (ipivot2*neg_y2 - l3_2*neg_qdd3 - neg_l4_2*qdd4 +
        l5_2*qdd5);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_real qdd1 = l6_1*neg_qdd6 - (neg_y1*ipivot1 - neg_l2_1*qdd2 + neg_l3_1*neg_qdd3 -
        neg_l4_1*qdd4 - neg_l5_1*qdd5);
    const puma560_real t53 = -neg_qdd3;
    const puma560_real t54 = -neg_qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = t53;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = t54;
}
