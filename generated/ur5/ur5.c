/*
 * ur5: Universal Robots UR5
 * Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: a034a79d0d30f898e9c7fa14f11711e6 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0        d 0.089159  theta q + -pi
 *   2  revolute  alpha pi/2  a 0        d 0.13585   theta q + pi
 *   3  revolute  alpha 0     a 0.425    d -0.1197   theta q
 *   4  revolute  alpha 0     a 0.39225  d 0.093     theta q + -pi
 *   5  revolute  alpha pi/2  a 0        d 0.09465   theta q + -pi
 *   6  revolute  alpha pi/2  a 0        d 0         theta q
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine
 *   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
 *   bias: 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine
 *   mass_matrix: 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 171 multiplications, 146 additions, 5 divisions = 322; 3 unary minus; 10
 *       sine/cosine
 */
#include "ur5.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine */
void ur5_inverse_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real qdd[6],
    ur5_real tau[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real lam2_33 = -qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur5_real angle23 = q[1] + q[2];
    const ur5_real angle2to4 = angle23 + q[3];
    const ur5_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_y = qd[0]*c2to4;
    /* sines and cosines of the joint angles */
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    /* link 3: angular acceleration [rad/s^2] */
    const ur5_real alpha3_z = qdd[1] + qdd[2];
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_z = alpha3_z + qdd[3];
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_yz = w4_z*w4_y;
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_x = s2to4*qdd[0] + ww4_yz;
    /* sines and cosines of the joint angles */
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_x = -w4_z*s5 - w4_x*c5;
    const ur5_real w5_z = qd[4] - w4_y;
    const ur5_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real ww5_yz = w5_z*w5_y;
    /* sines and cosines of the joint angles */
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_x = w5_x*c6 + w5_z*s6;
    const ur5_real w6_y = w5_z*c6 - w5_x*s6;
    const ur5_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(q[1]);
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_y = alpha4_x*s5 - (alpha4_z*c5 + w5_x*qd[4]);
    /* link 6: angular acceleration [rad/s^2] */
    const ur5_real alpha6_z = qdd[5] - alpha5_y;
    const ur5_real t1 = 0.0004509462908*w6_y;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_z = 37.00114003598763*(w6_x*t1 + 0.0004631336528748281*alpha6_z);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_x = qd[4]*w5_y - alpha4_x*c5 - alpha4_z*s5;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zx = w4_z*w4_x;
    /* link 4: angular acceleration [rad/s^2] */
    const ur5_real alpha4_y = c2to4*qdd[0] - ww4_zx;
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_z = qdd[4] - alpha4_y;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_zz = w3_z*w3_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real lam4_32 = ww4_yz + alpha4_x;
    const ur5_real t2 = w6_z*t1;
    const ur5_real t3 = 0.0166855268546*(c6*alpha5_z - w6_x*(qd[5] + 1.0270261943017807*w6_z) -
        s6*alpha5_x);
    const ur5_real t4 = -0.21481116377025*w5_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_z = s6*t2 + (c6*t3 + 0.0797745929244544*(w5_y*t4 + 2.9653109401563*alpha5_z));
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zz = w4_z*w4_z;
    const ur5_real t5 = 0.00460883622975*alpha5_y - (nc6_z - w5_z*t4);
    const ur5_real t6 = c6*t2 - (s6*t3 - 0.23194763691565*ww5_yz - 0.02174530937515*alpha5_x);
    const ur5_real t7 = 3.8937242327072834*s2;
    const ur5_real t8 = 3.8937242327072834*c2;
    const ur5_real t9 = qdd[1]*t7 + t8*ww2_zz;
    const ur5_real t10 = 0.00989414459142792*c23;
    const ur5_real t11 = 3.5936784241868986*s23;
    const ur5_real t12 = 2.0*qd[0];
    const ur5_real t13 = t11*(w3_z*t12);
    const ur5_real t14 = 3.5936784241868986*c23;
    const ur5_real t15 = alpha3_z*t11 + t14*ww3_zz;
    const ur5_real t16 = 0.00194120382525*s2to4;
    const ur5_real t17 = t12*(qd[1]*t7);
    const ur5_real t18 = t8 + t14;
    const ur5_real t19 = t13 + t17 - (lam2_33 + qdd[0]*t18);
    const ur5_real t20 = 0.05635344670717668*t9 + t10*t13 - (0.027092562065296363*t15 - (t16*t19 -
        (t19 + 0.03997638634458061*lam4_32)*(0.04855876187801449*t18)));
    const ur5_real t21 = 0.26165588420637464*c2;
    const ur5_real t22 = s2to4*(s5*t5 - c5*t6) + (t20 - (t17*t21 + qdd[0]*(t10*t14 - (t8*t21 +
        0.3692910505647355))));
    const ur5_real t23 = 0.00194120382525*c2to4;
    const ur5_real t24 = qdd[0] + (t9 + t15 - lam2_33*t18);
    const ur5_real t25 = t16*(ww4_zz - lam2_33) - (alpha4_z*t23 + 0.04855876187801449*t24);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = t22 - (c2to4*n5_z + t25);
    const ur5_real t26 = t7*ww2_zz - (alpha3_z*t14 - (t11*ww3_zz - (qdd[1]*t8 -
        89.87631699496106)));
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_z = 0.21942*alpha4_z + (t16*t26 + t23*t24) - (s5*t6 + c5*t5);
    const ur5_real t27 = 0.04855876187801449*t26 + ww4_zz*t23 + alpha4_z*t16;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_z = n4_z - (0.03146137394400002*alpha3_z + t11*(t25 +
        0.027092562065296363*qdd[0] - lam2_33*t10)) - t14*t27;
    const ur5_real t28 = 1.033923256964812*qdd[1] + (t7*(0.05635344670717668*qdd[0] - t25 -
        lam2_33*t21) - t8*(t27 + 6.804194372765798));
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_z = n03_z + t28;
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
    const ur5_real angle23 = q[1] + q[2];
    const ur5_real angle2to4 = q[3] + angle23;
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: moment that turns the link [N m] */
    const ur5_real nc4_z = 0.17446825035*s2to4;
    /* sines and cosines of the joint angles */
    const ur5_real c23 = cos(angle23);
    /* link 3: moment that turns the link [N m] */
    const ur5_real neg_nc3_z = 15.683828487749999*c23;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_z = nc4_z - neg_nc3_z;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    /* link 2: moment that turns the link [N m] */
    const ur5_real neg_nc2_z = 43.486969725*c2;
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
 * 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine */
void ur5_bias(const ur5_real q[6], const ur5_real qd[6], ur5_real tau[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real lam2_33 = -qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur5_real angle23 = q[1] + q[2];
    const ur5_real angle2to4 = angle23 + q[3];
    const ur5_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_y = qd[0]*c2to4;
    /* sines and cosines of the joint angles */
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_yz = w4_z*w4_y;
    /* sines and cosines of the joint angles */
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur5_real w5_x = -w4_z*s5 - w4_x*c5;
    const ur5_real w5_z = qd[4] - w4_y;
    const ur5_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real ww5_yz = w5_z*w5_y;
    /* sines and cosines of the joint angles */
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur5_real w6_x = w5_x*c6 + w5_z*s6;
    const ur5_real w6_y = w5_z*c6 - w5_x*s6;
    const ur5_real w6_z = qd[5] - w5_y;
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(q[1]);
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_y = ww4_yz*s5 - w5_x*qd[4];
    const ur5_real t1 = 0.0004509462908*w6_y;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_z = 37.00114003598763*(w6_x*t1 - 0.0004631336528748281*alpha5_y);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_x = qd[4]*w5_y - ww4_yz*c5;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zx = w4_z*w4_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_zz = w3_z*w3_z;
    const ur5_real t2 = w6_z*t1;
    const ur5_real t3 = 0.0166855268546*(s6*alpha5_x - (c6*ww4_zx - w6_x*(qd[5] +
        1.0270261943017807*w6_z)));
    const ur5_real t4 = -0.21481116377025*w5_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_z = s6*t2 - (c6*t3 - 0.0797745929244544*(w5_y*t4 + 2.9653109401563*ww4_zx));
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zz = w4_z*w4_z;
    const ur5_real t5 = 0.00460883622975*alpha5_y - (nc6_z - w5_z*t4);
    const ur5_real t6 = c6*t2 + (0.02174530937515*alpha5_x + (s6*t3 + 0.23194763691565*ww5_yz));
    const ur5_real t7 = 3.8937242327072834*c2;
    const ur5_real t8 = t7*ww2_zz;
    const ur5_real t9 = 0.00989414459142792*c23;
    const ur5_real t10 = 3.5936784241868986*s23;
    const ur5_real t11 = 2.0*qd[0];
    const ur5_real t12 = t10*(w3_z*t11);
    const ur5_real t13 = 3.5936784241868986*c23;
    const ur5_real t14 = t13*ww3_zz;
    const ur5_real t15 = 0.00194120382525*s2to4;
    const ur5_real t16 = 3.8937242327072834*s2;
    const ur5_real t17 = t11*(qd[1]*t16);
    const ur5_real t18 = t12 + t17 - lam2_33;
    const ur5_real t19 = t7 + t13;
    const ur5_real t20 = 0.05635344670717668*t8 + t9*t12 - (0.027092562065296363*t14 - (t15*t18 -
        (t18 + 0.07995277268916122*ww4_yz)*(0.04855876187801449*t19)));
    const ur5_real t21 = 0.26165588420637464*c2;
    const ur5_real t22 = t8 + t14 - lam2_33*t19;
    const ur5_real t23 = t15*(ww4_zz - lam2_33) - 0.04855876187801449*t22;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = s2to4*(s5*t5 - c5*t6) + (t20 - t17*t21) - (c2to4*n5_z + t23);
    const ur5_real t24 = t16*ww2_zz + (t10*ww3_zz + 89.87631699496106);
    const ur5_real t25 = 0.00194120382525*c2to4;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_z = t15*t24 + t25*t22 - (s5*t6 + c5*t5);
    const ur5_real t26 = 0.04855876187801449*t24 + ww4_zz*t25;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_z = n4_z - t10*(t23 - lam2_33*t9) - t13*t26;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_z = n03_z - (t16*(t23 + lam2_33*t21) + t7*(t26 + 6.804194372765798));
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n03_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine */
void ur5_mass_matrix(const ur5_real q[6], ur5_real M[36])
{
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(q[1]);
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(q[4]);
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(q[5]);
    const ur5_real angle23 = q[1] + q[2];
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    const ur5_real angle2to4 = angle23 + q[3];
    const ur5_real c2to4 = cos(angle2to4);
    const ur5_real s2to4 = sin(angle2to4);
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur5_real nu5_y = 0.0171364731454*c5;
    const ur5_real t1 = 0.0166855268546*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const ur5_real k6_xy = c6*t1;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real neg_k5_xz = c5*k6_xy;
    const ur5_real t2 = s6*t1;
    /* link 5: mass matrix, its row of this joint */
    const ur5_real m5_5 = 0.253242 - t2;
    const ur5_real t3 = s2to4*neg_k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y = t3 - c2to4*m5_5;
    const ur5_real t4 = 0.6794726918749999*c2;
    const ur5_real t5 = 0.011124085581927274*s2to4;
    const ur5_real t6 = 0.62711332561875*(c23*t5);
    const ur5_real t7 = c23*t4;
    const ur5_real t8 = t4*t5;
    const ur5_real t9 = t6 - (t7 - t8);
    const ur5_real t10 = c5*t2;
    const ur5_real t11 = c5*t10;
    const ur5_real t12 = 3.801350732012182*(t4*t4) - (t9 + (t9 - t11 - 0.4395951218179)) -
        c2to4*(c2to4*(t11 + 0.02174530937515) + (t3 + nu4_y));
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_1 = 0.59155695167475*(c23*c23) + t12;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real neg_k5_yz = s5*k6_xy;
    const ur5_real t13 = s5*s2to4;
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_4 = t10*t13 - c2to4*(neg_k5_yz - 0.00194120382525);
    const ur5_real t14 = 0.07714261911624999*s23;
    const ur5_real m1_3 = m1_4 + t14;
    const ur5_real m1_2 = m1_3 + 0.408499208875*s2;
    /* link 4: mass matrix, its row of this joint */
    const ur5_real m4_4 = t2 - t11 + 0.24116530937515;
    const ur5_real t15 = t6 - 0.09043071629752977*(c2to4*t14);
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_4 = m4_4 - t15;
    const ur5_real m3_3 = m3_4 - (t15 - 0.5956519516747499);
    const ur5_real t16 = t8 - 0.007558512375*(s2*c2to4);
    const ur5_real t17 = s23*(0.6794726918749999*s2) + (t7 - t16);
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_3 = t17 + m3_3;
    const ur5_real m2_2 = t17 + (m2_3 + 1.77012693841);
    const ur5_real m2_4 = m3_4 - t16;
    const ur5_real t18 = -0.0171364731454*t13;
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
    M[35] = 0.0171364731454;
}

/* accelerations that the torques tau give
 * 171 multiplications, 146 additions, 5 divisions = 322; 3 unary minus; 10 sine/cosine */
void ur5_forward_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real tau[6],
    ur5_real qdd[6])
{
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const ur5_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const ur5_real w3_z = qd[1] + qd[2];
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_z = w3_z + qd[3];
    /* sines and cosines of the joint angles */
    const ur5_real angle23 = q[1] + q[2];
    const ur5_real angle2to4 = angle23 + q[3];
    const ur5_real c2to4 = cos(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_y = qd[0]*c2to4;
    /* sines and cosines of the joint angles */
    const ur5_real s2to4 = sin(angle2to4);
    /* link 4: angular velocity [rad/s] */
    const ur5_real w4_x = qd[0]*s2to4;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_yz = w4_z*w4_y;
    /* sines and cosines of the joint angles */
    const ur5_real c5 = cos(q[4]);
    const ur5_real s5 = sin(q[4]);
    /* link 5: angular velocity [rad/s] */
    const ur5_real neg_w5_x = w4_z*s5 + w4_x*c5;
    const ur5_real neg_w5_z = w4_y - qd[4];
    const ur5_real w5_y = w4_x*s5 - w4_z*c5;
    /* link 5: products of the angular velocity [1/s^2] */
    const ur5_real neg_ww5_yz = neg_w5_z*w5_y;
    /* sines and cosines of the joint angles */
    const ur5_real c6 = cos(q[5]);
    const ur5_real s6 = sin(q[5]);
    /* link 6: angular velocity [rad/s] */
    const ur5_real neg_w6_x = neg_w5_x*c6 + neg_w5_z*s6;
    const ur5_real w6_y = neg_w5_x*s6 - neg_w5_z*c6;
    const ur5_real neg_w6_z = w5_y - qd[5];
    /* sines and cosines of the joint angles */
    const ur5_real c2 = cos(q[1]);
    const ur5_real s2 = sin(q[1]);
    const ur5_real c23 = cos(angle23);
    const ur5_real s23 = sin(angle23);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_y = ww4_yz*s5 + neg_w5_x*qd[4];
    const ur5_real t1 = -0.0004509462908*w6_y;
    /* link 6: moment that turns the link [N m] */
    const ur5_real nc6_z = 37.00114003598763*(neg_w6_x*t1 - 0.0004631336528748281*alpha5_y);
    /* link 5: angular acceleration [rad/s^2] */
    const ur5_real alpha5_x = qd[4]*w5_y - ww4_yz*c5;
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zx = w4_z*w4_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const ur5_real ww2_zz = qd[1]*qd[1];
    /* link 3: products of the angular velocity [1/s^2] */
    const ur5_real ww3_zz = w3_z*w3_z;
    const ur5_real t2 = neg_w6_z*t1;
    const ur5_real t3 = 0.0166855268546*(s6*alpha5_x - (c6*ww4_zx + neg_w6_x*(qd[5] -
        1.0270261943017807*neg_w6_z)));
    const ur5_real t4 = 0.21481116377025*neg_w5_x;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const ur5_real n5_z = s6*t2 - (c6*t3 - 0.0797745929244544*(w5_y*t4 + 2.9653109401563*ww4_zx));
    /* link 4: products of the angular velocity [1/s^2] */
    const ur5_real ww4_zz = w4_z*w4_z;
    const ur5_real t5 = 0.00460883622975*alpha5_y - (nc6_z + neg_w5_z*t4);
    const ur5_real t6 = c6*t2 + (0.02174530937515*alpha5_x + (s6*t3 - 0.23194763691565*neg_ww5_yz));
    const ur5_real t7 = 3.8937242327072834*c2;
    const ur5_real t8 = ww2_zz*t7;
    const ur5_real t9 = 0.00989414459142792*c23;
    const ur5_real t10 = 3.5936784241868986*s23;
    const ur5_real t11 = 2.0*qd[0];
    const ur5_real t12 = t10*(w3_z*t11);
    const ur5_real t13 = 3.5936784241868986*c23;
    const ur5_real t14 = ww3_zz*t13;
    const ur5_real t15 = 0.00194120382525*s2to4;
    const ur5_real t16 = 3.8937242327072834*s2;
    const ur5_real t17 = t11*(qd[1]*t16);
    const ur5_real t18 = neg_lam2_33 + (t12 + t17);
    const ur5_real t19 = t7 + t13;
    const ur5_real t20 = 0.05635344670717668*t8 + t9*t12 - (0.027092562065296363*t14 - (t15*t18 -
        (t18 + 0.07995277268916122*ww4_yz)*(0.04855876187801449*t19)));
    const ur5_real t21 = 0.26165588420637464*c2;
    const ur5_real t22 = t8 + t14 + neg_lam2_33*t19;
    const ur5_real t23 = t15*(neg_lam2_33 + ww4_zz) - 0.04855876187801449*t22;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const ur5_real n1_z = s2to4*(s5*t5 - c5*t6) + (t20 - t17*t21) - (c2to4*n5_z + t23);
    const ur5_real t24 = ww2_zz*t16 + (ww3_zz*t10 + 89.87631699496106);
    const ur5_real t25 = 0.00194120382525*c2to4;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const ur5_real n4_z = t15*t24 + t22*t25 - (s5*t6 + c5*t5);
    const ur5_real t26 = 0.04855876187801449*t24 + ww4_zz*t25;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n03_z = n4_z - t10*(t23 + neg_lam2_33*t9) - t13*t26;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const ur5_real n02_z = n03_z - (t16*(t23 - neg_lam2_33*t21) + t7*(t26 + 6.804194372765798));
    /* link 5: moment for a unit acceleration of a joint further out */
    const ur5_real nu5_y = 0.0171364731454*c5;
    const ur5_real t27 = 0.0166855268546*s6;
    /* link 6: second moment of the composite body [kg m^2] */
    const ur5_real k6_xy = c6*t27;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real neg_k5_xz = c5*k6_xy;
    const ur5_real t28 = s6*t27;
    /* link 5: mass matrix, its row of this joint */
    const ur5_real neg_m5_5 = t28 - 0.253242;
    const ur5_real t29 = s2to4*neg_k5_xz;
    /* link 4: moment for a unit acceleration of a joint further out */
    const ur5_real nu4_y = t29 + c2to4*neg_m5_5;
    const ur5_real t30 = 0.6794726918749999*c2;
    const ur5_real t31 = 0.011124085581927274*s2to4;
    const ur5_real t32 = 0.62711332561875*(c23*t31);
    const ur5_real t33 = c23*t30;
    const ur5_real t34 = t30*t31;
    const ur5_real t35 = t32 - (t33 - t34);
    const ur5_real t36 = c5*t28;
    const ur5_real t37 = c5*t36;
    const ur5_real t38 = 3.801350732012182*(t30*t30) - (t35 + (t35 - t37 - 0.4395951218179)) -
        c2to4*(c2to4*(t37 + 0.02174530937515) + (t29 + nu4_y));
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_1 = 0.59155695167475*(c23*c23) + t38;
    /* link 5: second moment of the composite body [kg m^2] */
    const ur5_real neg_k5_yz = s5*k6_xy;
    /* factorisation M = U D U^T */
    const ur5_real neg_u1_6 = s2to4*s5;
    /* link 1: mass matrix, its row of this joint */
    const ur5_real m1_4 = t36*neg_u1_6 - c2to4*(neg_k5_yz - 0.00194120382525);
    const ur5_real t39 = 0.07714261911624999*s23;
    const ur5_real m1_3 = m1_4 + t39;
    const ur5_real m1_2 = m1_3 + 0.408499208875*s2;
    /* link 4: mass matrix, its row of this joint */
    const ur5_real m4_4 = t28 - t37 + 0.24116530937515;
    const ur5_real t40 = t32 - 0.09043071629752977*(c2to4*t39);
    /* link 3: mass matrix, its row of this joint */
    const ur5_real m3_4 = m4_4 - t40;
    const ur5_real m3_3 = m3_4 - (t40 - 0.5956519516747499);
    const ur5_real t41 = t34 - 0.007558512375*(c2to4*s2);
    const ur5_real t42 = s23*(0.6794726918749999*s2) + (t33 - t41);
    /* link 2: mass matrix, its row of this joint */
    const ur5_real m2_3 = m3_3 + t42;
    const ur5_real m2_2 = t42 + (m2_3 + 1.77012693841);
    const ur5_real m2_4 = m3_4 - t41;
    /* factorisation M = U D U^T */
    const ur5_real neg_ud1_6 = 0.0171364731454*neg_u1_6;
    /* link 5: forward substitution */
    const ur5_real neg_y5 = n5_z - tau[4];
    /* link 6: forward substitution */
    const ur5_real neg_y6 = nc6_z - tau[5];
    /* factorisation M = U D U^T */
    const ur5_real neg_ipivot5 = 1.0 / neg_m5_5;
    const ur5_real neg_u4_5 = neg_k5_yz*neg_ipivot5;
    const ur5_real neg_u1_5 = nu4_y*neg_ipivot5;
    const ur5_real t43 = c5*nu5_y;
    const ur5_real t44 = neg_k5_yz*neg_u4_5;
    const ur5_real pivot4 = m4_4 - t43 + t44;
    const ur5_real ipivot4 = 1.0 / pivot4;
    const ur5_real ud3_4 = t44 + (m3_4 - t43);
    const ur5_real u3_4 = ipivot4*ud3_4;
    const ur5_real ud2_4 = t44 + (m2_4 - t43);
    const ur5_real u2_4 = ipivot4*ud2_4;
    const ur5_real t45 = nu5_y*neg_u1_6;
    const ur5_real t46 = neg_k5_yz*neg_u1_5;
    const ur5_real ud1_4 = m1_4 + t45 + t46;
    const ur5_real u1_4 = ipivot4*ud1_4;
    const ur5_real pivot3 = t44 + (m3_3 - t43) - ud3_4*u3_4;
    const ur5_real ipivot3 = 1.0 / pivot3;
    const ur5_real ud2_3 = t44 + (m2_3 - t43) - ud3_4*u2_4;
    const ur5_real u2_3 = ipivot3*ud2_3;
    const ur5_real ud1_3 = t46 + (m1_3 + t45) - ud3_4*u1_4;
    const ur5_real u1_3 = ipivot3*ud1_3;
    const ur5_real pivot2 = t44 + (m2_2 - t43) - ud2_4*u2_4 - ud2_3*u2_3;
    const ur5_real ipivot2 = 1.0 / pivot2;
    const ur5_real ud1_2 = t46 + (m1_2 + t45) - ud2_4*u1_4 - ud2_3*u1_3;
    const ur5_real u1_2 = ipivot2*ud1_2;
    const ur5_real pivot1 = m1_1 - neg_u1_6*neg_ud1_6 + nu4_y*neg_u1_5 - ud1_4*u1_4 - ud1_3*u1_3 -
        ud1_2*u1_2;
    const ur5_real ipivot1 = 1.0 / pivot1;
    const ur5_real t47 = c5*neg_y6;
    const ur5_real t48 = neg_y5*neg_u4_5;
    /* link 4: forward substitution */
    const ur5_real neg_y4 = n4_z - tau[3] - t47 + t48;
    /* link 3: forward substitution */
    const ur5_real neg_y3 = t48 + (n03_z - tau[2] - t47) - u3_4*neg_y4;
    /* link 2: forward substitution */
    const ur5_real neg_y2 = t48 + (n02_z - tau[1] - t47) - u2_4*neg_y4 - u2_3*neg_y3;
    /* link 1: forward substitution */
    const ur5_real neg_y1 = n1_z - tau[0] + neg_u1_6*neg_y6 + neg_y5*neg_u1_5 - u1_4*neg_y4 -
        u1_3*neg_y3 - u1_2*neg_y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real neg_qdd1 = ipivot1*neg_y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real neg_qdd2 = ipivot2*neg_y2 - u1_2*neg_qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real neg_qdd3 = ipivot3*neg_y3 - u2_3*neg_qdd2 - u1_3*neg_qdd1;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd4 = u1_4*neg_qdd1 - (ipivot4*neg_y4 - u3_4*neg_qdd3 - u2_4*neg_qdd2);
    const ur5_real t49 = neg_qdd2 + (neg_qdd3 - qdd4);
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd5 = neg_y5*neg_ipivot5 - neg_u1_5*neg_qdd1 - neg_u4_5*t49;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const ur5_real qdd6 = c5*t49 - (58.355064750790525*neg_y6 + neg_u1_6*neg_qdd1);
    const ur5_real t50 = -neg_qdd1;
    const ur5_real t51 = -neg_qdd2;
    const ur5_real t52 = -neg_qdd3;
    qdd[0] = t50;
    qdd[1] = t51;
    qdd[2] = t52;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
