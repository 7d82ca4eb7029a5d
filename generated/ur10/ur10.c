/*
 * ur10: Universal Robots UR10
 * Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH; last link
 *   carries the fixed tool
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 0dacbf6be1c6f14933c88bb9a0ce558d (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0       d 0.1273    theta q + -pi
 *   2  revolute  alpha pi/2  a 0       d 0.220941  theta q + pi
 *   3  revolute  alpha 0     a 0.612   d -0.1719   theta q
 *   4  revolute  alpha 0     a 0.5723  d 0.1149    theta q + -pi
 *   5  revolute  alpha pi/2  a 0       d 0.1157    theta q + -pi
 *   6  revolute  alpha pi/2  a 0       d 0         theta q
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
 * Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
 *   parameters, equal to the recursion without being written like it: robodyn --optimize full,
 *   seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 104 multiplications, 81 additions = 185; 3 unary minus; 10 sine/cosine
 *   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
 *   bias: 84 multiplications, 57 additions = 141; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 168 multiplications, 149 additions, 5 divisions = 322; 3 unary minus; 10
 *       sine/cosine
 */
#include "ur10.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 104 multiplications, 81 additions = 185; 3 unary minus; 10 sine/cosine */
void ur10_inverse_dynamics(
    const ur10_real q[6],
    const ur10_real qd[6],
    const ur10_real qdd[6],
    ur10_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const ur10_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const ur10_real alpha3_z = qdd[1] + qdd[2];
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur10_real angle23 = q[1] + q[2];
    const ur10_real angle2to4 = angle23 + q[3];
    const ur10_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_y = c2to4*qd[0];
    /* sines and cosines of the joint angles */
    const ur10_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_x = qd[0]*s2to4;
    /* link 4: angular acceleration [rad/s^2] */
    const ur10_real alpha4_z = alpha3_z + qdd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_yz = w4_z*w4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const ur10_real alpha4_x = s2to4*qdd[0] + ww4_yz;
    /* sines and cosines of the joint angles */
    const ur10_real c5 = cos(q[4]);
    const ur10_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur10_real w5_x = -w4_x*c5 - w4_z*s5;
    const ur10_real w5_z = qd[4] - w4_y;
    const ur10_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real alpha5_y = alpha4_x*s5 - alpha4_z*c5 - w5_x*qd[4];
    /* sines and cosines of the joint angles */
    const ur10_real c6 = cos(q[5]);
    const ur10_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur10_real w6_x = w5_x*c6 + w5_z*s6;
    const ur10_real neg_w6_y = w5_x*s6 - w5_z*c6;
    const ur10_real w6_z = qd[5] - w5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const ur10_real alpha6_z = qdd[5] - alpha5_y;
    /* sines and cosines of the joint angles */
    const ur10_real c2 = cos(q[1]);
    const ur10_real s2 = sin(q[1]);
    const ur10_real c23 = cos(angle23);
    const ur10_real s23 = sin(angle23);
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zx = w4_z*w4_x;
    /* link 4: angular acceleration [rad/s^2] */
    const ur10_real alpha4_y = c2to4*qdd[0] - ww4_zx;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real alpha5_z = qdd[4] - alpha4_y;
    const ur10_real alpha5_x = qd[4]*w5_y - alpha4_z*s5 - alpha4_x*c5;
    /* link 6: angular acceleration [rad/s^2] */
    const ur10_real alpha6_x = c6*alpha5_x - (neg_w6_y*qd[5] - s6*alpha5_z);
    const ur10_real t1 = 0.000568125*(c6*alpha5_z - w6_x*qd[5] - s6*alpha5_x);
    const ur10_real t2 = 4.1662710585e-05*neg_w6_y;
    const ur10_real t3 = -0.000526462289415*alpha6_x - w6_z*t2;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur10_real n5_z = 0.0055125*alpha5_z + (c6*t1 - s6*t3);
    /* link 2: products of the angular velocity [1/s^2] */
    const ur10_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur10_real ww3_zz = w3_z*w3_z;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zz = w4_z*w4_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur10_real lam2_33 = -qd[0]*qd[0];
    /* link 6: moment that turns the link [N m] */
    const ur10_real nc6_z = 0.000526462289415*alpha6_z - w6_x*t2;
    const ur10_real t4 = 0.30757353909747764*c2;
    const ur10_real t5 = 7.5456565789375905*s2;
    const ur10_real t6 = 2.0*qd[0];
    const ur10_real t7 = qd[1]*(-t5*t6);
    const ur10_real t8 = 7.056175261643763*c23;
    const ur10_real t9 = 0.03071031060636092*c23;
    const ur10_real t10 = 7.5456565789375905*c2;
    const ur10_real t11 = 7.056175261643763*s23;
    const ur10_real t12 = alpha3_z*t11 + t8*ww3_zz;
    const ur10_real t13 = qdd[1]*t5 + (t10*ww2_zz + t12);
    const ur10_real t14 = t8 + t10;
    const ur10_real t15 = t13 + 2.021311250339228*qdd[0] - lam2_33*t14;
    const ur10_real t16 = 0.0018955668934*(s2to4*(ww4_zz - lam2_33) - (c2to4*alpha4_z + t15));
    const ur10_real t17 = t16 - 0.03794874645838701*t15;
    const ur10_real t18 = t6*(w3_z*t11);
    const ur10_real t19 = qdd[0]*t14 - (t18 - t7 - 2.021311250339228*lam2_33);
    const ur10_real t20 = 0.0018955668934*(alpha4_x + (ww4_yz - t19));
    const ur10_real t21 = 0.0055125*alpha5_y - nc6_z;
    const ur10_real t22 = c6*t3 + (s6*t1 - 0.0055125*alpha5_x);
    const ur10_real t23 = t9*t18 - 0.12354737656656752*t12 - (t14*(t20 - 0.03794874645838701*t19) -
        s2to4*(s5*t21 + (t20 + c5*t22)));
    const ur10_real t24 = qdd[0]*(t8*t9 - 0.615151818691065 - t10*t4) -
        2.021311250339228*(0.04316477484712015*t13 - t17) - t23;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur10_real n1_z = t4*t7 - t24 - c2to4*n5_z;
    const ur10_real t25 = t5*ww2_zz - (qdd[1]*t10 - 120.95243633885255 + (alpha3_z*t8 -
        t11*ww3_zz));
    const ur10_real t26 = 0.0018955668934*(c2to4*ww4_zz + (s2to4*alpha4_z + t25));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur10_real n4_z = 0.0055125*alpha4_z + s2to4*t26 - (c5*t21 + c2to4*t16) + s5*t22;
    const ur10_real t27 = t26 + 0.03794874645838701*t25;
    const ur10_real t28 = 0.08724944501684367*qdd[0] - t17;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n03_z = n4_z - t8*t27 - (0.205812958978*alpha3_z +
        t11*(0.12354737656656752*qdd[0] - t28 - t9*lam2_33));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n02_z = 2.3572099237980004*qdd[1] + (t5*(t28 - t4*lam2_33) + (n03_z - t10*(t27 +
        6.6834804198179665)));
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine */
void ur10_gravity(const ur10_real q[6], ur10_real tau[6])
{
    /* sines and cosines of the joint angles */
    const ur10_real angle23 = q[1] + q[2];
    const ur10_real angle2to4 = q[3] + angle23;
    const ur10_real s2to4 = sin(angle2to4);
    /* link 4: moment that turns the link [N m] */
    const ur10_real nc4_z = 0.229273434*s2to4;
    /* sines and cosines of the joint angles */
    const ur10_real c23 = cos(angle23);
    /* link 3: moment that turns the link [N m] */
    const ur10_real neg_nc3_z = 34.005590991*c23;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n03_z = nc4_z - neg_nc3_z;
    /* sines and cosines of the joint angles */
    const ur10_real c2 = cos(q[1]);
    /* link 2: moment that turns the link [N m] */
    const ur10_real neg_nc2_z = 86.79578004*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n02_z = n03_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = nc4_z;
    tau[4] = 0.0;
    tau[5] = 0.0;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 84 multiplications, 57 additions = 141; 0 unary minus; 10 sine/cosine */
void ur10_bias(const ur10_real q[6], const ur10_real qd[6], ur10_real tau[6])
{
    /* link 3: angular velocity [rad/s] */
    const ur10_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur10_real angle23 = q[1] + q[2];
    const ur10_real angle2to4 = angle23 + q[3];
    const ur10_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_y = c2to4*qd[0];
    /* sines and cosines of the joint angles */
    const ur10_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_x = qd[0]*s2to4;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_yz = w4_z*w4_y;
    /* sines and cosines of the joint angles */
    const ur10_real c5 = cos(q[4]);
    const ur10_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur10_real neg_w5_x = w4_z*s5 + w4_x*c5;
    const ur10_real neg_w5_z = w4_y - qd[4];
    const ur10_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real alpha5_y = ww4_yz*s5 + neg_w5_x*qd[4];
    /* sines and cosines of the joint angles */
    const ur10_real c6 = cos(q[5]);
    const ur10_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur10_real neg_w6_x = neg_w5_x*c6 + neg_w5_z*s6;
    const ur10_real neg_w6_y = neg_w5_z*c6 - neg_w5_x*s6;
    const ur10_real neg_w6_z = w5_y - qd[5];
    /* sines and cosines of the joint angles */
    const ur10_real c2 = cos(q[1]);
    const ur10_real s2 = sin(q[1]);
    const ur10_real c23 = cos(angle23);
    const ur10_real s23 = sin(angle23);
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zx = w4_z*w4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real neg_alpha5_x = ww4_yz*c5 - qd[4]*w5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const ur10_real neg_alpha6_x = c6*neg_alpha5_x + (neg_w6_y*qd[5] - s6*ww4_zx);
    const ur10_real t1 = 4.1662710585e-05*neg_w6_y;
    const ur10_real t2 = neg_w6_z*t1 + 0.000526462289415*neg_alpha6_x;
    const ur10_real t3 = 0.000568125*(s6*neg_alpha5_x + (neg_w6_x*qd[5] + c6*ww4_zx));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur10_real n5_z = 0.0055125*ww4_zx - (s6*t2 - c6*t3);
    /* link 2: products of the angular velocity [1/s^2] */
    const ur10_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur10_real ww3_zz = w3_z*w3_z;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zz = w4_z*w4_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur10_real neg_lam2_33 = qd[0]*qd[0];
    /* link 6: moment that turns the link [N m] */
    const ur10_real nc6_z = neg_w6_x*t1 - 0.000526462289415*alpha5_y;
    const ur10_real t4 = 7.5456565789375905*c2;
    const ur10_real t5 = 7.056175261643763*c23;
    const ur10_real t6 = t5*ww3_zz;
    const ur10_real t7 = t4*ww2_zz + t6;
    const ur10_real t8 = t5 + t4;
    const ur10_real t9 = t7 + neg_lam2_33*t8;
    const ur10_real t10 = 0.0018955668934*(s2to4*(ww4_zz + neg_lam2_33) - t9);
    const ur10_real t11 = t10 - 0.03794874645838701*t9;
    const ur10_real t12 = 0.03071031060636092*c23;
    const ur10_real t13 = 2.0*qd[0];
    const ur10_real t14 = 7.056175261643763*s23;
    const ur10_real t15 = t13*(w3_z*t14);
    const ur10_real t16 = 7.5456565789375905*s2;
    const ur10_real t17 = qd[1]*(t16*t13);
    const ur10_real t18 = 2.021311250339228*neg_lam2_33 + (t15 + t17);
    const ur10_real t19 = 0.0018955668934*(ww4_yz + (ww4_yz + t18));
    const ur10_real t20 = 0.0055125*alpha5_y - nc6_z;
    const ur10_real t21 = c6*t2 + (s6*t3 + 0.0055125*neg_alpha5_x);
    const ur10_real t22 = t12*t15 - 0.12354737656656752*t6 - (t8*(t19 + 0.03794874645838701*t18) -
        s2to4*(s5*t20 + (t19 + c5*t21)));
    const ur10_real t23 = 0.30757353909747764*c2;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur10_real n1_z = 2.021311250339228*(0.04316477484712015*t7 - t11) + t22 - t23*t17 -
        c2to4*n5_z;
    const ur10_real t24 = t16*ww2_zz + (t14*ww3_zz + 120.95243633885255);
    const ur10_real t25 = 0.0018955668934*(c2to4*ww4_zz + t24);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur10_real n4_z = s2to4*t25 - (c5*t20 + c2to4*t10) + s5*t21;
    const ur10_real t26 = t25 + 0.03794874645838701*t24;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n03_z = n4_z - t5*t26 - t14*(t11 + t12*neg_lam2_33);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n02_z = n03_z - t4*(t26 + 6.6834804198179665) - t16*(t11 - t23*neg_lam2_33);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine */
void ur10_mass_matrix(const ur10_real q[6], ur10_real M[36])
{
    /* sines and cosines of the joint angles */
    const ur10_real c2 = cos(q[1]);
    const ur10_real s2 = sin(q[1]);
    const ur10_real c5 = cos(q[4]);
    const ur10_real s5 = sin(q[4]);
    const ur10_real c6 = cos(q[5]);
    const ur10_real s6 = sin(q[5]);
    const ur10_real angle23 = q[1] + q[2];
    const ur10_real c23 = cos(angle23);
    const ur10_real s23 = sin(angle23);
    const ur10_real angle2to4 = angle23 + q[3];
    const ur10_real c2to4 = cos(angle2to4);
    const ur10_real s2to4 = sin(angle2to4);
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur10_real nu5_y = 0.000526462289415*c5;
    const ur10_real t1 = 4.1662710585e-05*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const ur10_real k6_xy = c6*t1;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur10_real neg_k5_xz = c5*k6_xy;
    const ur10_real t2 = s6*t1;
    /* link 5: mass matrix, its row of this joint */
    const ur10_real m5_5 = 0.006080625 - t2;
    const ur10_real t3 = s2to4*neg_k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur10_real nu4_y = t3 - c2to4*m5_5;
    const ur10_real t4 = 2.1214497131999996*c2;
    const ur10_real t5 = 0.006742227596064426*s2to4;
    const ur10_real t6 = 1.9838327955299997*(c23*t5);
    const ur10_real t7 = c23*t4;
    const ur10_real t8 = t4*t5;
    const ur10_real t9 = t6 - (t7 - t8);
    const ur10_real t10 = c5*t2;
    const ur10_real t11 = c5*t10;
    const ur10_real t12 = 1.019755017314753*(t4*t4) - (t9 + (t9 - t11 - 0.785878225894297)) -
        c2to4*(c2to4*(t11 + 0.007934529182815) + (t3 + nu4_y));
    /* link 1: mass matrix, its row of this joint */
    const ur10_real m1_1 = 1.7671354615519999*(c23*c23) + t12;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur10_real neg_k5_yz = s5*k6_xy;
    const ur10_real t13 = s5*s2to4;
    /* link 1: mass matrix, its row of this joint */
    const ur10_real m1_4 = t10*t13 - c2to4*(neg_k5_yz - 0.0038315306874);
    const ur10_real t14 = 0.3121639749051*s23;
    const ur10_real m1_3 = m1_4 + t14;
    const ur10_real m1_2 = m1_3 + 1.266064618644*s2;
    /* link 4: mass matrix, its row of this joint */
    const ur10_real m4_4 = t2 - t11 + 0.013447029182815;
    const ur10_real t15 = t6 - 0.04284752019853101*(c2to4*t14);
    /* link 3: mass matrix, its row of this joint */
    const ur10_real m3_4 = m4_4 - t15;
    const ur10_real m3_3 = m3_4 - (t15 - 1.7780198365519997);
    const ur10_real t16 = t8 - 0.0143032968*(s2*c2to4);
    const ur10_real t17 = s23*(2.1214497131999996*s2) + (t7 - t16);
    /* link 2: mass matrix, its row of this joint */
    const ur10_real m2_3 = t17 + m3_3;
    const ur10_real m2_2 = t17 + (m2_3 + 4.625822931798);
    const ur10_real m2_4 = m3_4 - t16;
    const ur10_real t18 = -0.000526462289415*t13;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = nu4_y;
    M[5] = t18;
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
    M[24] = nu4_y;
    M[25] = neg_k5_yz;
    M[26] = neg_k5_yz;
    M[27] = neg_k5_yz;
    M[28] = m5_5;
    M[29] = 0.0;
    M[30] = t18;
    M[31] = nu5_y;
    M[32] = nu5_y;
    M[33] = nu5_y;
    M[34] = 0.0;
    M[35] = 0.000526462289415;
}

/* accelerations that the torques tau give
 * 168 multiplications, 149 additions, 5 divisions = 322; 3 unary minus; 10 sine/cosine */
void ur10_forward_dynamics(
    const ur10_real q[6],
    const ur10_real qd[6],
    const ur10_real tau[6],
    ur10_real qdd[6])
{
    /* link 3: angular velocity [rad/s] */
    const ur10_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur10_real angle23 = q[1] + q[2];
    const ur10_real angle2to4 = angle23 + q[3];
    const ur10_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_y = c2to4*qd[0];
    /* sines and cosines of the joint angles */
    const ur10_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur10_real w4_x = qd[0]*s2to4;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_yz = w4_z*w4_y;
    /* sines and cosines of the joint angles */
    const ur10_real c5 = cos(q[4]);
    const ur10_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur10_real neg_w5_x = w4_z*s5 + w4_x*c5;
    const ur10_real neg_w5_z = w4_y - qd[4];
    const ur10_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real alpha5_y = ww4_yz*s5 + neg_w5_x*qd[4];
    /* sines and cosines of the joint angles */
    const ur10_real c6 = cos(q[5]);
    const ur10_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur10_real neg_w6_x = neg_w5_x*c6 + neg_w5_z*s6;
    const ur10_real neg_w6_y = neg_w5_z*c6 - neg_w5_x*s6;
    const ur10_real neg_w6_z = w5_y - qd[5];
    /* sines and cosines of the joint angles */
    const ur10_real c2 = cos(q[1]);
    const ur10_real s2 = sin(q[1]);
    const ur10_real c23 = cos(angle23);
    const ur10_real s23 = sin(angle23);
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zx = w4_z*w4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const ur10_real neg_alpha5_x = ww4_yz*c5 - qd[4]*w5_y;
    /* link 6: angular acceleration [rad/s^2] */
    const ur10_real neg_alpha6_x = c6*neg_alpha5_x + (neg_w6_y*qd[5] - s6*ww4_zx);
    const ur10_real t1 = 4.1662710585e-05*neg_w6_y;
    const ur10_real t2 = neg_w6_z*t1 + 0.000526462289415*neg_alpha6_x;
    const ur10_real t3 = 0.000568125*(s6*neg_alpha5_x + (neg_w6_x*qd[5] + c6*ww4_zx));
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur10_real n5_z = 0.0055125*ww4_zx - (s6*t2 - c6*t3);
    /* link 2: products of the angular velocity [1/s^2] */
    const ur10_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur10_real ww3_zz = w3_z*w3_z;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur10_real ww4_zz = w4_z*w4_z;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur10_real neg_lam2_33 = qd[0]*qd[0];
    /* link 6: moment that turns the link [N m] */
    const ur10_real nc6_z = neg_w6_x*t1 - 0.000526462289415*alpha5_y;
    const ur10_real t4 = 7.5456565789375905*c2;
    const ur10_real t5 = 7.056175261643763*c23;
    const ur10_real t6 = ww3_zz*t5;
    const ur10_real t7 = ww2_zz*t4 + t6;
    const ur10_real t8 = t4 + t5;
    const ur10_real t9 = t7 + neg_lam2_33*t8;
    const ur10_real t10 = 0.0018955668934*(s2to4*(ww4_zz + neg_lam2_33) - t9);
    const ur10_real t11 = t10 - 0.03794874645838701*t9;
    const ur10_real t12 = 0.03071031060636092*c23;
    const ur10_real t13 = 2.0*qd[0];
    const ur10_real t14 = 7.056175261643763*s23;
    const ur10_real t15 = t13*(w3_z*t14);
    const ur10_real t16 = 7.5456565789375905*s2;
    const ur10_real t17 = qd[1]*(t13*t16);
    const ur10_real t18 = 2.021311250339228*neg_lam2_33 + (t15 + t17);
    const ur10_real t19 = 0.0018955668934*(ww4_yz + (ww4_yz + t18));
    const ur10_real t20 = nc6_z - 0.0055125*alpha5_y;
    const ur10_real t21 = c6*t2 + (s6*t3 + 0.0055125*neg_alpha5_x);
    const ur10_real t22 = t12*t15 - 0.12354737656656752*t6 - (t8*(t19 + 0.03794874645838701*t18) +
        s2to4*(s5*t20 - (t19 + c5*t21)));
    const ur10_real t23 = 0.30757353909747764*c2;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur10_real n1_z = 2.021311250339228*(0.04316477484712015*t7 - t11) + t22 - t17*t23 -
        c2to4*n5_z;
    const ur10_real t24 = ww2_zz*t16 + (ww3_zz*t14 + 120.95243633885255);
    const ur10_real t25 = 0.0018955668934*(c2to4*ww4_zz + t24);
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur10_real n4_z = s2to4*t25 + (c5*t20 - c2to4*t10) + s5*t21;
    const ur10_real t26 = t25 + 0.03794874645838701*t24;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n03_z = n4_z - t5*t26 - t14*(t11 + neg_lam2_33*t12);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur10_real n02_z = n03_z - t4*(t26 + 6.6834804198179665) - t16*(t11 - neg_lam2_33*t23);
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur10_real nu5_y = 0.000526462289415*c5;
    const ur10_real t27 = 4.1662710585e-05*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const ur10_real k6_xy = c6*t27;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur10_real neg_k5_xz = c5*k6_xy;
    const ur10_real t28 = s6*t27;
    /* link 5: mass matrix, its row of this joint */
    const ur10_real neg_m5_5 = t28 - 0.006080625;
    const ur10_real t29 = s2to4*neg_k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur10_real nu4_y = t29 + c2to4*neg_m5_5;
    const ur10_real t30 = 2.1214497131999996*c2;
    const ur10_real t31 = 0.006742227596064426*s2to4;
    const ur10_real t32 = 1.9838327955299997*(c23*t31);
    const ur10_real t33 = c23*t30;
    const ur10_real t34 = t30*t31;
    const ur10_real t35 = t32 - (t33 - t34);
    const ur10_real t36 = c5*t28;
    const ur10_real t37 = c5*t36;
    const ur10_real t38 = 1.019755017314753*(t30*t30) - (t35 + (t35 - t37 - 0.785878225894297)) -
        c2to4*(c2to4*(t37 + 0.007934529182815) + (t29 + nu4_y));
    /* link 1: mass matrix, its row of this joint */
    const ur10_real m1_1 = 1.7671354615519999*(c23*c23) + t38;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur10_real neg_k5_yz = s5*k6_xy;
    /* factorisation M = U D U^T */
    const ur10_real neg_u1_6 = s2to4*s5;
    /* link 1: mass matrix, its row of this joint */
    const ur10_real m1_4 = t36*neg_u1_6 - c2to4*(neg_k5_yz - 0.0038315306874);
    const ur10_real t39 = 0.3121639749051*s23;
    const ur10_real m1_3 = m1_4 + t39;
    const ur10_real m1_2 = m1_3 + 1.266064618644*s2;
    /* link 4: mass matrix, its row of this joint */
    const ur10_real m4_4 = t28 - t37 + 0.013447029182815;
    const ur10_real t40 = t32 - 0.04284752019853101*(c2to4*t39);
    /* link 3: mass matrix, its row of this joint */
    const ur10_real m3_4 = m4_4 - t40;
    const ur10_real m3_3 = m3_4 - (t40 - 1.7780198365519997);
    const ur10_real t41 = t34 - 0.0143032968*(c2to4*s2);
    const ur10_real t42 = s23*(2.1214497131999996*s2) + (t33 - t41);
    /* link 2: mass matrix, its row of this joint */
    const ur10_real m2_3 = m3_3 + t42;
    const ur10_real m2_2 = t42 + (m2_3 + 4.625822931798);
    const ur10_real m2_4 = m3_4 - t41;
    /* factorisation M = U D U^T */
    const ur10_real neg_ud1_6 = 0.000526462289415*neg_u1_6;
    /* link 5: forward substitution */
    const ur10_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const ur10_real neg_y6 = nc6_z - tau[5];
    /* factorisation M = U D U^T */
    const ur10_real neg_ipivot5 = 1.0 / neg_m5_5;
    const ur10_real neg_u4_5 = neg_k5_yz*neg_ipivot5;
    const ur10_real neg_u1_5 = nu4_y*neg_ipivot5;
    const ur10_real t43 = c5*nu5_y;
    const ur10_real t44 = neg_k5_yz*neg_u4_5;
    const ur10_real pivot4 = m4_4 - t43 + t44;
    const ur10_real ipivot4 = 1.0 / pivot4;
    const ur10_real ud3_4 = t44 + (m3_4 - t43);
    const ur10_real u3_4 = ipivot4*ud3_4;
    const ur10_real ud2_4 = t44 + (m2_4 - t43);
    const ur10_real u2_4 = ipivot4*ud2_4;
    const ur10_real t45 = nu5_y*neg_u1_6;
    const ur10_real t46 = neg_k5_yz*neg_u1_5;
    const ur10_real ud1_4 = m1_4 + t45 + t46;
    const ur10_real u1_4 = ipivot4*ud1_4;
    const ur10_real pivot3 = t44 + (m3_3 - t43) - ud3_4*u3_4;
    const ur10_real ipivot3 = 1.0 / pivot3;
    const ur10_real ud2_3 = t44 + (m2_3 - t43) - ud3_4*u2_4;
    const ur10_real u2_3 = ipivot3*ud2_3;
    const ur10_real ud1_3 = t46 + (m1_3 + t45) - ud3_4*u1_4;
    const ur10_real u1_3 = ipivot3*ud1_3;
    const ur10_real pivot2 = t44 + (m2_2 - t43) - ud2_4*u2_4 - ud2_3*u2_3;
    const ur10_real ipivot2 = 1.0 / pivot2;
    const ur10_real ud1_2 = t46 + (m1_2 + t45) - ud2_4*u1_4 - ud2_3*u1_3;
    const ur10_real u1_2 = ipivot2*ud1_2;
    const ur10_real pivot1 = m1_1 - neg_u1_6*neg_ud1_6 + nu4_y*neg_u1_5 - ud1_4*u1_4 - ud1_3*u1_3 -
        ud1_2*u1_2;
    const ur10_real ipivot1 = 1.0 / pivot1;
    const ur10_real t47 = c5*neg_y6;
    const ur10_real t48 = neg_y5*neg_u4_5;
    /* link 4: forward substitution */
    const ur10_real neg_y4 = n4_z - tau[3] - t47 + t48;
    /* link 3: forward substitution */
    const ur10_real neg_y3 = t48 + (n03_z - tau[2] - t47) - u3_4*neg_y4;
    /* link 2: forward substitution */
    const ur10_real neg_y2 = t48 + (n02_z - tau[1] - t47) - u2_4*neg_y4 - u2_3*neg_y3;
    /* link 1: forward substitution */
    const ur10_real neg_y1 = n1_z - tau[0] + neg_u1_6*neg_y6 + neg_y5*neg_u1_5 - u1_4*neg_y4 -
        u1_3*neg_y3 - u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real neg_qdd2 = ipivot2*neg_y2 - u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real neg_qdd3 = ipivot3*neg_y3 - u2_3*neg_qdd2 - u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real qdd4 = u1_4*neg_qdd1 - (ipivot4*neg_y4 - u3_4*neg_qdd3 - u2_4*neg_qdd2);
    const ur10_real t49 = neg_qdd2 + (neg_qdd3 - qdd4);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real qdd5 = neg_y5*neg_ipivot5 - neg_u1_5*neg_qdd1 - neg_u4_5*t49;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur10_real qdd6 = c5*t49 - (1899.4712823803404*neg_y6 + neg_u1_6*neg_qdd1);
    const ur10_real t50 = -neg_qdd1;
    const ur10_real t51 = -neg_qdd2;
    const ur10_real t52 = -neg_qdd3;
    qdd[0] = t50;
    qdd[1] = t51;
    qdd[2] = t52;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
