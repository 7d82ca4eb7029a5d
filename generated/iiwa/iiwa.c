/*
 * iiwa: KUKA iiwa 14 geometry, random full inertias
 * Numbers: published iiwa geometry; inertial parameters drawn at random
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute, 7
 *   revolute
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
 *   inverse_dynamics: 296 multiplications, 281 additions = 577; 6 unary minus; 12 sine/cosine
 *   gravity: 64 multiplications, 38 additions = 102; 2 unary minus; 12 sine/cosine
 *   bias: 288 multiplications, 262 additions = 550; 8 unary minus; 12 sine/cosine
 *   mass_matrix: 183 multiplications, 150 additions = 333; 5 unary minus; 12 sine/cosine
 *   forward_dynamics: 597 multiplications, 517 additions, 7 divisions = 1121; 17 unary minus; 12
 *       sine/cosine
 */
#include "iiwa.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 296 multiplications, 281 additions = 577; 6 unary minus; 12 sine/cosine */
void iiwa_inverse_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real qdd[7],
    iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    const iiwa_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = t1*s2;
    const iiwa_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a2_x = 9.81*s2;
    const iiwa_real neg_a2_y = 9.81*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_yz = qd[1]*w2_y;
    const iiwa_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = ww2_yz - qdd[0]*s2;
    const iiwa_real neg_alpha2_y = qdd[0]*c2 + ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_xy = w2_x*w2_y;
    const iiwa_real ww2_xx = w2_x*w2_x;
    const iiwa_real ww2_yy = w2_y*w2_y;
    const iiwa_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam2_11 = ww2_yy + ww2_zz;
    const iiwa_real lam2_12 = ww2_xy - qdd[1];
    const iiwa_real lam2_13 = ww2_zx - neg_alpha2_y;
    const iiwa_real lam2_21 = qdd[1] + ww2_xy;
    const iiwa_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa_real neg_lam2_23 = alpha2_x - ww2_yz;
    const iiwa_real lam2_31 = ww2_zx + neg_alpha2_y;
    const iiwa_real lam2_32 = ww2_yz + alpha2_x;
    const iiwa_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_z = neg_a2_y - 0.4*neg_lam2_22;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t2 = -0.4*lam2_32;
    const iiwa_real t3 = neg_a2_x + 0.4*lam2_12;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t2 - c3*t3;
    const iiwa_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y - (-qdd[1]*s3 - c3*alpha2_x);
    const iiwa_real alpha3_y = qdd[1]*c3 - s3*alpha2_x - qd[2]*w3_x;
    const iiwa_real alpha3_z = qdd[2] + neg_alpha2_y;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_yz = w3_y*w3_z;
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_xy = w3_x*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam3_11 = ww3_yy + ww3_zz;
    const iiwa_real lam3_12 = ww3_xy - alpha3_z;
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_21 = alpha3_z + ww3_xy;
    const iiwa_real neg_lam3_22 = ww3_xx + ww3_zz;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = c4*w3_x + s4*w3_z;
    const iiwa_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a4_x = c4*a3_x + s4*a3_z;
    const iiwa_real a4_y = c4*a3_z - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = qd[3]*w4_y - (-s4*alpha3_z - c4*alpha3_x);
    const iiwa_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const iiwa_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_xx = w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = ww4_xy - alpha4_z;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = alpha4_z + ww4_xy;
    const iiwa_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y - 0.4*neg_lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real t4 = -c5;
    const iiwa_real w5_y = t4*w4_z - s5*w4_x;
    const iiwa_real t5 = a3_y - 0.4*lam4_32;
    const iiwa_real t6 = -0.4*lam4_12 - a4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t5 - c5*t6;
    const iiwa_real a5_y = s5*t6 + c5*t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const iiwa_real alpha5_y = t4*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
    const iiwa_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_yz = w5_y*w5_z;
    const iiwa_real ww5_zx = w5_x*w5_z;
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_yy + ww5_zz;
    const iiwa_real lam5_12 = ww5_xy - alpha5_z;
    const iiwa_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa_real lam5_21 = alpha5_z + ww5_xy;
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = c6*w5_x - s6*w5_z;
    const iiwa_real t7 = -c6;
    const iiwa_real w6_y = t7*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a6_x = c6*a5_x - s6*a5_z;
    const iiwa_real a6_y = t7*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha5_z - c6*alpha5_x);
    const iiwa_real alpha6_y = t7*alpha5_z - s6*alpha5_x - qd[5]*w6_x;
    const iiwa_real alpha6_z = qdd[5] + alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_yz = w6_y*w6_z;
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_xx = w6_x*w6_x;
    const iiwa_real ww6_yy = w6_y*w6_y;
    const iiwa_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_yy + ww6_zz;
    const iiwa_real lam6_12 = ww6_xy - alpha6_z;
    const iiwa_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa_real lam6_21 = alpha6_z + ww6_xy;
    const iiwa_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real lam6_31 = ww6_zx - alpha6_y;
    const iiwa_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_z = -0.126*neg_lam6_22 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_x = c7*w6_x + s7*w6_z;
    const iiwa_real w7_y = c7*w6_z - s7*w6_x;
    const iiwa_real t8 = a5_y - 0.126*lam6_32;
    const iiwa_real t9 = 0.126*lam6_12 - a6_x;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t8 - c7*t9;
    const iiwa_real a7_y = s7*t9 + c7*t8;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-s7*alpha6_z - c7*alpha6_x);
    const iiwa_real alpha7_y = c7*alpha6_z - s7*alpha6_x - qd[6]*w7_x;
    const iiwa_real alpha7_z = qdd[6] - alpha6_y;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_yz = w7_y*w7_z;
    const iiwa_real ww7_zx = w7_x*w7_z;
    const iiwa_real ww7_xy = w7_x*w7_y;
    const iiwa_real ww7_xx = w7_x*w7_x;
    const iiwa_real ww7_yy = w7_y*w7_y;
    const iiwa_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam7_11 = ww7_yy + ww7_zz;
    const iiwa_real lam7_12 = ww7_xy - alpha7_z;
    const iiwa_real lam7_13 = alpha7_y + ww7_zx;
    const iiwa_real lam7_21 = alpha7_z + ww7_xy;
    const iiwa_real neg_lam7_22 = ww7_xx + ww7_zz;
    const iiwa_real lam7_23 = ww7_yz - alpha7_x;
    const iiwa_real lam7_31 = ww7_zx - alpha7_y;
    const iiwa_real lam7_32 = alpha7_x + ww7_yz;
    const iiwa_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 1: moment that turns the link [N m] */
    const iiwa_real nc1_z = 0.8058116303302202*qdd[0];
    /* link 2: moment that turns the link [N m] */
    const iiwa_real nc2_x = 0.20091837135316784*lam2_21 - 0.5218524991029152*lam2_31 -
        (-4.238401785575742*lam2_32 - 0.26458063578324464*(neg_lam2_22 - neg_lam2_33));
    const iiwa_real nc2_y = 0.20091837135316784*(neg_lam2_11 - neg_lam2_33) -
        0.5265869353045646*lam2_31 - (-0.26458063578324464*lam2_12 - 0.5218524991029152*lam2_32);
    const iiwa_real t10 = 0.5265869353045646*lam2_21 - 4.238401785575742*lam2_12 -
        0.5218524991029152*(neg_lam2_11 - neg_lam2_22) + (0.20091837135316784*neg_lam2_23 -
        0.26458063578324464*lam2_13);
    const iiwa_real nc2_z = t10 + (13.292379489096295*c2 - 76.6738398539524*s2);
    /* link 3: force that moves the link [N] */
    const iiwa_real fc3_x = 1.0168650139155704*neg_lam3_11 - 0.04389618410240257*lam3_12;
    const iiwa_real fc3_y = 0.04389618410240257*neg_lam3_22 - 1.0168650139155704*lam3_21;
    /* link 3: moment that turns the link [N m] */
    const iiwa_real neg_nc3_x = 0.06405373385272267*(neg_lam3_22 - neg_lam3_33) -
        0.45257769458388303*lam3_32 - (0.1005265342798281*neg_lam3_31 - 0.16230144331072144*lam3_21)
        + 0.04389618410240257*a3_z;
    const iiwa_real nc3_y = 0.20191091047133833*neg_lam3_31 - 0.16230144331072144*(neg_lam3_11 -
        neg_lam3_33) + (0.1005265342798281*lam3_32 - 0.06405373385272267*lam3_12) +
        1.0168650139155704*a3_z;
    const iiwa_real t11 = 0.20191091047133833*lam3_21 - 0.45257769458388303*lam3_12 +
        0.1005265342798281*(neg_lam3_22 - neg_lam3_11) + (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real nc3_z = t11 - (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = -8.054835434921454*neg_lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(neg_lam4_22 -
        neg_lam4_33) - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) +
        8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 - neg_lam4_33) -
        0.24852411424661205*lam4_31 - (-0.09675036990607108*lam4_12 - 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t12 = 0.24852411424661205*lam4_21 - 3.569490999313376*lam4_12 -
        0.20921122087079386*(neg_lam4_11 - neg_lam4_22) - (0.013124222729483126*lam4_23 +
        0.09675036990607108*lam4_13);
    const iiwa_real nc4_z = t12 - (0.5168019281781282*a4_y + 8.054835434921454*a4_x);
    /* link 5: force that moves the link [N] */
    const iiwa_real fc5_x = 0.25252954507510866*neg_lam5_11 + 0.4193059538543958*lam5_12;
    const iiwa_real fc5_y = -0.4193059538543958*neg_lam5_22 - 0.25252954507510866*lam5_21;
    const iiwa_real fc5_z = 0.4193059538543958*lam5_32 - 0.25252954507510866*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const iiwa_real nc5_x = 0.4193059538543958*a5_z - (0.05680835589544868*(neg_lam5_22 -
        neg_lam5_33) - 0.20655564034097101*lam5_32 - (0.041147842218669614*lam5_21 -
        0.03284626166448073*lam5_31));
    const iiwa_real nc5_y = 0.041147842218669614*(neg_lam5_11 - neg_lam5_33) -
        0.09474888781047501*lam5_31 + (0.03284626166448073*lam5_32 - 0.05680835589544868*lam5_12) +
        0.25252954507510866*a5_z;
    const iiwa_real t13 = 0.09474888781047501*lam5_21 - 0.20655564034097101*lam5_12 -
        0.03284626166448073*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614*lam5_23 -
        0.05680835589544868*lam5_13);
    const iiwa_real nc5_z = t13 - (0.25252954507510866*a5_y + 0.4193059538543958*a5_x);
    /* link 6: force that moves the link [N] */
    const iiwa_real fc6_x = 1.5656307599463828*neg_lam6_11 - 1.291128497815195*lam6_12;
    const iiwa_real fc6_y = 1.291128497815195*neg_lam6_22 - 1.5656307599463828*lam6_21;
    const iiwa_real fc6_z = -1.5656307599463828*lam6_31 - 1.291128497815195*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real nc6_x = -1.291128497815195*a5_y - (-2.0289563933923875*lam6_32 -
        0.0870114460092663*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574*lam6_21 -
        0.36144292274665746*lam6_31));
    const iiwa_real nc6_y = 0.042925575293549574*(neg_lam6_11 - neg_lam6_33) -
        0.4239952187044951*lam6_31 - (-0.0870114460092663*lam6_12 - 0.36144292274665746*lam6_32) +
        1.5656307599463828*a5_y;
    const iiwa_real t14 = 0.4239952187044951*lam6_21 - 2.0289563933923875*lam6_12 -
        0.36144292274665746*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574*lam6_23 +
        0.0870114460092663*lam6_13);
    const iiwa_real nc6_z = t14 - (1.5656307599463828*a6_y - 1.291128497815195*a6_x);
    /* link 7: force that moves the link [N] */
    const iiwa_real fc7_x = 0.708306797966195*lam7_12 - 0.9999503996366931*neg_lam7_11;
    const iiwa_real fc7_y = 0.9999503996366931*lam7_21 - 0.708306797966195*neg_lam7_22;
    const iiwa_real fc7_z = 0.9999503996366931*lam7_31 + 0.708306797966195*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_x = 0.708306797966195*a7_z - (-0.2922782720134952*lam7_32 -
        0.061680050398747424*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357*lam7_21 -
        0.2114247825686032*lam7_31));
    const iiwa_real nc7_y = -0.19090892097190032*lam7_31 - 0.2024621683128357*(neg_lam7_11 -
        neg_lam7_33) - (0.2114247825686032*lam7_32 - 0.061680050398747424*lam7_12) -
        0.9999503996366931*a7_z;
    const iiwa_real t15 = 0.19090892097190032*lam7_21 - 0.2922782720134952*lam7_12 +
        0.2114247825686032*(neg_lam7_11 - neg_lam7_22) + (0.2024621683128357*lam7_23 -
        0.061680050398747424*lam7_13);
    const iiwa_real nc7_z = t15 + (0.9999503996366931*a7_y - 0.708306797966195*a7_x);
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f07_x = c7*fc7_x - s7*fc7_y;
    const iiwa_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (nc6_x - 0.126*f07_y);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z + 0.126*f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x + f07_x;
    const iiwa_real f6_y = fc6_y - fc7_z;
    const iiwa_real f6_z = fc6_z + f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f06_x = c6*f6_x - s6*f6_y;
    const iiwa_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = nc5_x + n06_x;
    const iiwa_real n5_y = nc5_y + n6_z;
    const iiwa_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const iiwa_real f5_x = fc5_x + f06_x;
    const iiwa_real f5_y = fc5_y + f6_z;
    const iiwa_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f05_x = c5*f5_x - s5*f5_y;
    const iiwa_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n05_x = c5*n5_x - s5*n5_y;
    const iiwa_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_x = n05_x - (neg_nc4_x + 0.4*f05_y);
    const iiwa_real n4_y = nc4_y + n5_z;
    const iiwa_real n4_z = nc4_z - 0.4*f05_x - n05_y;
    /* link 4: force through the joint [N] */
    const iiwa_real f4_x = fc4_x + f05_x;
    const iiwa_real f4_y = fc4_y + f5_z;
    const iiwa_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f04_x = c4*f4_x - s4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n04_x = c4*n4_x - s4*n4_y;
    const iiwa_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_x = n04_x - neg_nc3_x;
    const iiwa_real n3_y = nc3_y - n4_z;
    const iiwa_real n3_z = nc3_z + n04_y;
    /* link 3: force through the joint [N] */
    const iiwa_real f3_x = fc3_x + f04_x;
    const iiwa_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f03_x = c3*f3_x - s3*f3_y;
    const iiwa_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n03_x = c3*n3_x - s3*n3_y;
    const iiwa_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_x = n03_x - (0.4*f03_y - nc2_x);
    const iiwa_real n2_y = nc2_y - n3_z;
    const iiwa_real n2_z = n03_y + (nc2_z + 0.4*f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n1_z = nc1_z - n02_y;
    tau[0] = n1_z;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques that hold the arm at rest
 * 64 multiplications, 38 additions = 102; 2 unary minus; 12 sine/cosine */
void iiwa_gravity(const iiwa_real q[7], iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a2_x = 9.81*s2;
    const iiwa_real neg_a2_y = 9.81*c2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = -c3*neg_a2_x;
    const iiwa_real a3_y = s3*neg_a2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a4_x = c4*a3_x + s4*neg_a2_y;
    const iiwa_real a4_y = c4*neg_a2_y - s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = c5*a4_x + s5*a3_y;
    const iiwa_real a5_y = c5*a3_y - s5*a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a6_x = c6*a5_x - s6*a4_y;
    const iiwa_real a6_y = -c6*a4_y - s6*a5_x;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = c7*a6_x + s7*a5_y;
    const iiwa_real a7_y = c7*a5_y - s7*a6_x;
    /* link 2: moment that turns the link [N m] */
    const iiwa_real nc2_z = 13.292379489096295*c2 - 76.6738398539524*s2;
    /* link 3: moment that turns the link [N m] */
    const iiwa_real neg_nc3_x = 0.43062156604456925*c2;
    const iiwa_real nc3_y = 9.975445786511747*c2;
    const iiwa_real nc3_z = 0.04389618410240257*a3_x - 1.0168650139155704*a3_y;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = 8.054835434921454*a3_y;
    const iiwa_real neg_nc4_y = 0.5168019281781282*a3_y;
    const iiwa_real nc4_z = -8.054835434921454*a4_x - 0.5168019281781282*a4_y;
    /* link 5: moment that turns the link [N m] */
    const iiwa_real nc5_x = 0.4193059538543958*a4_y;
    const iiwa_real nc5_y = 0.25252954507510866*a4_y;
    const iiwa_real nc5_z = -0.4193059538543958*a5_x - 0.25252954507510866*a5_y;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real neg_nc6_x = 1.291128497815195*a5_y;
    const iiwa_real nc6_y = 1.5656307599463828*a5_y;
    const iiwa_real nc6_z = 1.291128497815195*a6_x - 1.5656307599463828*a6_y;
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_x = -0.708306797966195*a6_y;
    const iiwa_real nc7_y = 0.9999503996366931*a6_y;
    const iiwa_real nc7_z = 0.9999503996366931*a7_y - 0.708306797966195*a7_x;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x - neg_nc6_x;
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = nc6_z + n07_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = nc5_x + n06_x;
    const iiwa_real n5_y = nc5_y + n6_z;
    const iiwa_real n5_z = nc5_z - n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n05_x = c5*n5_x - s5*n5_y;
    const iiwa_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_x = n05_x - neg_nc4_x;
    const iiwa_real n4_y = n5_z - neg_nc4_y;
    const iiwa_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n04_x = c4*n4_x - s4*n4_y;
    const iiwa_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_x = n04_x - neg_nc3_x;
    const iiwa_real n3_y = nc3_y - n4_z;
    const iiwa_real n3_z = nc3_z + n04_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n03_x = c3*n3_x - s3*n3_y;
    const iiwa_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_z = nc2_z + n03_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real neg_n02_y = c2*n3_z - s2*n03_x;
    tau[0] = neg_n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 288 multiplications, 262 additions = 550; 8 unary minus; 12 sine/cosine */
void iiwa_bias(const iiwa_real q[7], const iiwa_real qd[7], iiwa_real tau[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    const iiwa_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = t1*s2;
    const iiwa_real w2_y = t1*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a2_x = 9.81*s2;
    const iiwa_real neg_a2_y = 9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = qd[1]*w2_y;
    const iiwa_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_xy = w2_x*w2_y;
    const iiwa_real ww2_xx = w2_x*w2_x;
    const iiwa_real ww2_yy = w2_y*w2_y;
    const iiwa_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam2_11 = ww2_yy + ww2_zz;
    const iiwa_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a3_z = 0.4*neg_lam2_22 - neg_a2_y;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t2 = -0.8*alpha2_x;
    const iiwa_real t3 = neg_a2_x + 0.4*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t2 - c3*t3;
    const iiwa_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const iiwa_real alpha3_y = -qd[2]*w3_x - s3*alpha2_x;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_yz = w3_y*w3_z;
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_xy = w3_x*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam3_11 = ww3_yy + ww3_zz;
    const iiwa_real lam3_12 = ww3_xy - neg_alpha2_y;
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_21 = neg_alpha2_y + ww3_xy;
    const iiwa_real neg_lam3_22 = ww3_xx + ww3_zz;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = c4*w3_x + s4*w3_z;
    const iiwa_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a4_x = s4*neg_a3_z - c4*a3_x;
    const iiwa_real a4_y = -s4*a3_x - c4*neg_a3_z;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = qd[3]*w4_y - (-c4*alpha3_x - s4*neg_alpha2_y);
    const iiwa_real alpha4_y = c4*neg_alpha2_y - s4*alpha3_x - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_xx = w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y - 0.4*neg_lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real w5_y = -c5*w4_z - s5*w4_x;
    const iiwa_real t4 = a3_y - 0.4*lam4_32;
    const iiwa_real t5 = neg_a4_x - 0.4*lam4_12;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t4 - c5*t5;
    const iiwa_real a5_y = s5*t5 + c5*t4;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (-s5*alpha3_y - c5*alpha4_x);
    const iiwa_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_yz = w5_y*w5_z;
    const iiwa_real ww5_zx = w5_x*w5_z;
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_yy + ww5_zz;
    const iiwa_real lam5_12 = ww5_xy - alpha4_y;
    const iiwa_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa_real lam5_21 = alpha4_y + ww5_xy;
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = c6*w5_x - s6*w5_z;
    const iiwa_real t6 = -c6;
    const iiwa_real w6_y = t6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a6_x = c6*a5_x - s6*a5_z;
    const iiwa_real a6_y = t6*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const iiwa_real alpha6_y = t6*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_yz = w6_y*w6_z;
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_xx = w6_x*w6_x;
    const iiwa_real ww6_yy = w6_y*w6_y;
    const iiwa_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_yy + ww6_zz;
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa_real lam6_21 = alpha5_y + ww6_xy;
    const iiwa_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real lam6_31 = ww6_zx - alpha6_y;
    const iiwa_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_z = -0.126*neg_lam6_22 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_x = c7*w6_x + s7*w6_z;
    const iiwa_real w7_y = c7*w6_z - s7*w6_x;
    const iiwa_real t7 = a5_y - 0.126*lam6_32;
    const iiwa_real t8 = 0.126*lam6_12 - a6_x;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t7 - c7*t8;
    const iiwa_real a7_y = s7*t8 + c7*t7;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-s7*alpha5_y - c7*alpha6_x);
    const iiwa_real alpha7_y = c7*alpha5_y - s7*alpha6_x - qd[6]*w7_x;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_yz = w7_y*w7_z;
    const iiwa_real ww7_zx = w7_x*w7_z;
    const iiwa_real ww7_xy = w7_x*w7_y;
    const iiwa_real ww7_xx = w7_x*w7_x;
    const iiwa_real ww7_yy = w7_y*w7_y;
    const iiwa_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam7_11 = ww7_yy + ww7_zz;
    const iiwa_real lam7_12 = alpha6_y + ww7_xy;
    const iiwa_real lam7_13 = alpha7_y + ww7_zx;
    const iiwa_real lam7_21 = ww7_xy - alpha6_y;
    const iiwa_real neg_lam7_22 = ww7_xx + ww7_zz;
    const iiwa_real lam7_23 = ww7_yz - alpha7_x;
    const iiwa_real lam7_31 = ww7_zx - alpha7_y;
    const iiwa_real lam7_32 = alpha7_x + ww7_yz;
    const iiwa_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 2: moment that turns the link [N m] */
    const iiwa_real nc2_x = 0.20091837135316784*ww2_xy - 1.0437049982058304*neg_alpha2_y -
        (-8.476803571151484*alpha2_x - 0.26458063578324464*(neg_lam2_22 - neg_lam2_33));
    const iiwa_real nc2_y = 0.20091837135316784*(neg_lam2_11 - neg_lam2_33) -
        1.0531738706091291*neg_alpha2_y + (0.26458063578324464*ww2_xy +
        1.0437049982058304*alpha2_x);
    const iiwa_real nc2_z = 13.292379489096295*c2 - 76.6738398539524*s2 - (3.711814850271177*ww2_xy
        + 0.5218524991029152*(neg_lam2_11 - neg_lam2_22));
    /* link 3: force that moves the link [N] */
    const iiwa_real fc3_x = 1.0168650139155704*neg_lam3_11 - 0.04389618410240257*lam3_12;
    const iiwa_real fc3_y = 0.04389618410240257*neg_lam3_22 - 1.0168650139155704*lam3_21;
    /* link 3: moment that turns the link [N m] */
    const iiwa_real nc3_x = 0.04389618410240257*neg_a3_z - (0.06405373385272267*(neg_lam3_22 -
        neg_lam3_33) - 0.45257769458388303*lam3_32 - (0.1005265342798281*neg_lam3_31 -
        0.16230144331072144*lam3_21));
    const iiwa_real nc3_y = 0.20191091047133833*neg_lam3_31 - 0.16230144331072144*(neg_lam3_11 -
        neg_lam3_33) - (0.06405373385272267*lam3_12 - 0.1005265342798281*lam3_32) -
        1.0168650139155704*neg_a3_z;
    const iiwa_real t9 = 0.45257769458388303*lam3_12 - 0.20191091047133833*lam3_21 +
        0.1005265342798281*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real neg_nc3_z = t9 + (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = -8.054835434921454*neg_lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(neg_lam4_22 -
        neg_lam4_33) - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) +
        8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 - neg_lam4_33) -
        0.24852411424661205*lam4_31 + (0.09675036990607108*lam4_12 + 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t10 = 3.569490999313376*lam4_12 - 0.24852411424661205*lam4_21 +
        0.20921122087079386*(neg_lam4_11 - neg_lam4_22) + (0.013124222729483126*lam4_23 +
        0.09675036990607108*lam4_13);
    const iiwa_real nc4_z = 8.054835434921454*neg_a4_x - 0.5168019281781282*a4_y - t10;
    /* link 5: force that moves the link [N] */
    const iiwa_real fc5_x = 0.25252954507510866*neg_lam5_11 + 0.4193059538543958*lam5_12;
    const iiwa_real fc5_y = -0.4193059538543958*neg_lam5_22 - 0.25252954507510866*lam5_21;
    const iiwa_real fc5_z = 0.4193059538543958*lam5_32 - 0.25252954507510866*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const iiwa_real nc5_x = 0.4193059538543958*a5_z - (0.05680835589544868*(neg_lam5_22 -
        neg_lam5_33) - 0.20655564034097101*lam5_32 - (0.041147842218669614*lam5_21 -
        0.03284626166448073*lam5_31));
    const iiwa_real nc5_y = 0.041147842218669614*(neg_lam5_11 - neg_lam5_33) -
        0.09474888781047501*lam5_31 + (0.03284626166448073*lam5_32 - 0.05680835589544868*lam5_12) +
        0.25252954507510866*a5_z;
    const iiwa_real t11 = 0.09474888781047501*lam5_21 - 0.20655564034097101*lam5_12 -
        0.03284626166448073*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614*lam5_23 -
        0.05680835589544868*lam5_13);
    const iiwa_real nc5_z = t11 - (0.25252954507510866*a5_y + 0.4193059538543958*a5_x);
    /* link 6: force that moves the link [N] */
    const iiwa_real fc6_x = 1.5656307599463828*neg_lam6_11 - 1.291128497815195*lam6_12;
    const iiwa_real fc6_y = 1.291128497815195*neg_lam6_22 - 1.5656307599463828*lam6_21;
    const iiwa_real fc6_z = -1.5656307599463828*lam6_31 - 1.291128497815195*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real nc6_x = -1.291128497815195*a5_y - (-2.0289563933923875*lam6_32 -
        0.0870114460092663*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574*lam6_21 -
        0.36144292274665746*lam6_31));
    const iiwa_real nc6_y = 0.042925575293549574*(neg_lam6_11 - neg_lam6_33) -
        0.4239952187044951*lam6_31 - (-0.0870114460092663*lam6_12 - 0.36144292274665746*lam6_32) +
        1.5656307599463828*a5_y;
    const iiwa_real t12 = 0.4239952187044951*lam6_21 - 2.0289563933923875*lam6_12 -
        0.36144292274665746*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574*lam6_23 +
        0.0870114460092663*lam6_13);
    const iiwa_real nc6_z = t12 - (1.5656307599463828*a6_y - 1.291128497815195*a6_x);
    /* link 7: force that moves the link [N] */
    const iiwa_real fc7_x = 0.708306797966195*lam7_12 - 0.9999503996366931*neg_lam7_11;
    const iiwa_real fc7_y = 0.9999503996366931*lam7_21 - 0.708306797966195*neg_lam7_22;
    const iiwa_real fc7_z = 0.9999503996366931*lam7_31 + 0.708306797966195*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_x = 0.708306797966195*a7_z - (-0.2922782720134952*lam7_32 -
        0.061680050398747424*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357*lam7_21 -
        0.2114247825686032*lam7_31));
    const iiwa_real nc7_y = -0.19090892097190032*lam7_31 - 0.2024621683128357*(neg_lam7_11 -
        neg_lam7_33) + (0.061680050398747424*lam7_12 - 0.2114247825686032*lam7_32) -
        0.9999503996366931*a7_z;
    const iiwa_real t13 = 0.2922782720134952*lam7_12 - 0.19090892097190032*lam7_21 -
        0.2114247825686032*(neg_lam7_11 - neg_lam7_22) - (0.2024621683128357*lam7_23 -
        0.061680050398747424*lam7_13);
    const iiwa_real nc7_z = 0.9999503996366931*a7_y - 0.708306797966195*a7_x - t13;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f07_x = c7*fc7_x - s7*fc7_y;
    const iiwa_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (nc6_x - 0.126*f07_y);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z + 0.126*f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x + f07_x;
    const iiwa_real f6_y = fc6_y - fc7_z;
    const iiwa_real f6_z = fc6_z + f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f06_x = c6*f6_x - s6*f6_y;
    const iiwa_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = nc5_x + n06_x;
    const iiwa_real n5_y = nc5_y + n6_z;
    const iiwa_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const iiwa_real f5_x = fc5_x + f06_x;
    const iiwa_real f5_y = fc5_y + f6_z;
    const iiwa_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f05_x = c5*f5_x - s5*f5_y;
    const iiwa_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n05_x = c5*n5_x - s5*n5_y;
    const iiwa_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_x = n05_x - (neg_nc4_x + 0.4*f05_y);
    const iiwa_real n4_y = nc4_y + n5_z;
    const iiwa_real n4_z = nc4_z - 0.4*f05_x - n05_y;
    /* link 4: force through the joint [N] */
    const iiwa_real f4_x = fc4_x + f05_x;
    const iiwa_real f4_y = fc4_y + f5_z;
    const iiwa_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f04_x = c4*f4_x - s4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n04_x = c4*n4_x - s4*n4_y;
    const iiwa_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_x = nc3_x + n04_x;
    const iiwa_real n3_y = nc3_y - n4_z;
    const iiwa_real n3_z = n04_y - neg_nc3_z;
    /* link 3: force through the joint [N] */
    const iiwa_real f3_x = fc3_x + f04_x;
    const iiwa_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f03_x = c3*f3_x - s3*f3_y;
    const iiwa_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n03_x = c3*n3_x - s3*n3_y;
    const iiwa_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_x = n03_x - (0.4*f03_y - nc2_x);
    const iiwa_real neg_n2_y = n3_z - nc2_y;
    const iiwa_real n2_z = n03_y + (nc2_z + 0.4*f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real neg_n02_y = c2*neg_n2_y - s2*n2_x;
    tau[0] = neg_n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 183 multiplications, 150 additions = 333; 5 unary minus; 12 sine/cosine */
void iiwa_mass_matrix(const iiwa_real q[7], iiwa_real M[49])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_x = 0.9999503996366931*c7 - 0.708306797966195*s7;
    const iiwa_real neg_h7_y = -0.708306797966195*c7 - 0.9999503996366931*s7;
    const iiwa_real t1 = c7*c7;
    const iiwa_real t2 = c7*s7;
    /* link 7: second moment of the composite body [kg m^2] */
    const iiwa_real k7_xy = 0.2114247825686032*(2.0*t1 - 1.0) - 0.10136935104159488*t2;
    const iiwa_real k7_xz = 0.2024621683128357*c7 - 0.061680050398747424*s7;
    const iiwa_real k7_yz = 0.2024621683128357*s7 + 0.061680050398747424*c7;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_7 = 0.126*neg_h7_y - k7_yz;
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real fu6_x = c6*neg_h7_y;
    const iiwa_real fu6_y = s6*neg_h7_y;
    const iiwa_real t3 = k7_xz + 0.126*h7_x;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = 0.48318719298539553*s6 - c6*t3;
    const iiwa_real neg_nu6_y = s6*t3 + 0.48318719298539553*c6;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real fu5_x = c5*fu6_x - s5*h7_x;
    const iiwa_real fu5_y = s5*fu6_x + c5*h7_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c5*nu6_x - s5*m6_7;
    const iiwa_real neg_nu5_y = -c5*m6_7 - s5*nu6_x;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = neg_nu5_y - 0.4*fu5_x;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x = c4*fu5_x + s4*fu6_y;
    const iiwa_real t4 = nu5_x - 0.4*fu5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x = c4*t4 - s4*neg_nu6_y;
    const iiwa_real nu4_y = s4*t4 + c4*neg_nu6_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = c3*fu4_x - s3*fu5_y;
    const iiwa_real fu3_y = s3*fu4_x + c3*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c3*nu4_x + s3*m4_7;
    const iiwa_real nu3_y = s3*nu4_x - c3*m4_7;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_7 = nu3_y + 0.4*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y = c2*nu4_y - s2*(nu3_x - 0.4*fu3_y);
    const iiwa_real t5 = 0.10136935104159488*t1 + 0.4228495651372064*t2;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 2.745229884110378 - t5;
    const iiwa_real t6 = h7_x - 1.5656307599463828;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = c6*t6 + 1.291128497815195*s6;
    const iiwa_real h6_y = s6*t6 - 1.291128497815195*c6;
    const iiwa_real t7 = c6*c6;
    const iiwa_real t8 = t5 + 1.3126829026743974;
    const iiwa_real t9 = t3 + 0.36144292274665746;
    const iiwa_real t10 = c6*s6;
    const iiwa_real t11 = t7*t8 - t9*(2.0*t10);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_yy = t11 - (t5 - 0.7162734907179903);
    const iiwa_real neg_k6_xy = t8*t10 - t9*(1.0 - 2.0*t7);
    const iiwa_real t12 = k7_xy - 0.042925575293549574;
    const iiwa_real t13 = m6_7 + 0.0870114460092663;
    const iiwa_real k6_xz = c6*t12 - s6*t13;
    const iiwa_real k6_yz = s6*t12 + c6*t13;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = c5*h6_y;
    const iiwa_real t14 = -s5;
    const iiwa_real fu5_y_2 = t14*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x_2 = t14*m6_6 - c5*k6_xz;
    const iiwa_real nu5_y = c5*m6_6 - s5*k6_xz;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = 0.4*neg_fu5_x - nu5_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_2 = s4*h6_x - c4*neg_fu5_x;
    const iiwa_real t15 = nu5_x_2 - 0.4*fu5_y_2;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_2 = c4*t15 - s4*k6_yz;
    const iiwa_real nu4_y_2 = s4*t15 + c4*k6_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_2 = c3*fu4_x_2 - s3*fu5_y_2;
    const iiwa_real fu3_y_2 = s3*fu4_x_2 + c3*fu5_y_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_2 = c3*nu4_x_2 + s3*m4_6;
    const iiwa_real nu3_y_2 = s3*nu4_x_2 - c3*m4_6;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_6 = nu3_y_2 + 0.4*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y_2 = c2*nu4_y_2 - s2*(nu3_x_2 - 0.4*fu3_y_2);
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t5 - t11 + 2.521169842515734;
    const iiwa_real t16 = h6_x - 0.25252954507510866;
    const iiwa_real t17 = 0.4193059538543958 - neg_h7_y;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_x = c5*t16 - s5*t17;
    const iiwa_real h5_y = s5*t16 + c5*t17;
    const iiwa_real t18 = c5*c5;
    const iiwa_real t19 = t5 + t11 - 1.7262407198899914;
    const iiwa_real t20 = 0.03284626166448073 - k6_xz;
    const iiwa_real t21 = c5*s5;
    const iiwa_real t22 = t18*t19 - t20*(2.0*t21);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_xx = t5 + 0.39746456131287133 - t22;
    const iiwa_real k5_yy = t22 - (t11 - 2.1237052812028625);
    const iiwa_real neg_k5_xy = t19*t21 - t20*(1.0 - 2.0*t18);
    const iiwa_real t23 = neg_k6_xy - 0.041147842218669614;
    const iiwa_real t24 = -k6_yz - 0.05680835589544868;
    const iiwa_real k5_xz = c5*t23 - s5*t24;
    const iiwa_real k5_yz = s5*t23 + c5*t24;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = k5_yz + 0.4*h5_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_3 = -c4*h5_y;
    const iiwa_real t25 = k5_xz + 0.4*h5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_3 = -s4*m5_5 - c4*t25;
    const iiwa_real nu4_y_3 = c4*m5_5 - s4*t25;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_3 = c3*fu4_x_3 - s3*h5_x;
    const iiwa_real fu3_y_3 = s3*fu4_x_3 + c3*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_3 = c3*nu4_x_3 + s3*m4_5;
    const iiwa_real nu3_y_3 = s3*nu4_x_3 - c3*m4_5;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_5 = nu3_y_3 + 0.4*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y_3 = c2*nu4_y_3 - s2*(nu3_x_3 - 0.4*fu3_y_3);
    const iiwa_real t26 = 0.8*h6_y - k6_yy;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = k5_xx - t26 + 3.818015113559988;
    const iiwa_real t27 = h5_x - 0.5168019281781282;
    const iiwa_real t28 = h6_y - 8.054835434921454;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h4_x = c4*t27 + s4*t28;
    const iiwa_real h4_y = s4*t27 - c4*t28;
    const iiwa_real t29 = c4*c4;
    const iiwa_real t30 = k5_xx + t26 - 3.3209668850667637;
    const iiwa_real t31 = t25 - 0.20921122087079386;
    const iiwa_real t32 = c4*s4;
    const iiwa_real t33 = t29*t30 - t31*(2.0*t32);
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xx = t33 - (t26 - 3.569490999313376);
    const iiwa_real k4_yy = k5_xx + 0.24852411424661205 - t33;
    const iiwa_real k4_xy = t30*t32 - t31*(1.0 - 2.0*t29);
    const iiwa_real t34 = neg_k5_xy - 0.013124222729483126;
    const iiwa_real t35 = m4_5 - 0.09675036990607108;
    const iiwa_real k4_xz = c4*t34 + s4*t35;
    const iiwa_real neg_k4_yz = c4*t35 - s4*t34;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu3_x = c3*h4_y;
    const iiwa_real neg_fu3_y = s3*h4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_4 = s3*m4_4 - c3*k4_xz;
    const iiwa_real neg_nu3_y = s3*k4_xz + c3*m4_4;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_4 = -0.4*neg_fu3_x - neg_nu3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y_4 = c2*neg_k4_yz - s2*(nu3_x_4 + 0.4*neg_fu3_y);
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = k5_yy + k4_xx + 0.6544886050552213;
    const iiwa_real t36 = h4_x - 1.0168650139155704;
    const iiwa_real t37 = h5_y - 0.04389618410240257;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h3_x = c3*t36 - s3*t37;
    const iiwa_real h3_y = s3*t36 + c3*t37;
    const iiwa_real t38 = c3*c3;
    const iiwa_real t39 = k4_xx - k5_yy - 0.2506667841125447;
    const iiwa_real t40 = k4_xz + 0.1005265342798281;
    const iiwa_real t41 = c3*s3;
    const iiwa_real t42 = t38*t39 + t40*(2.0*t41);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_xx = k5_yy + 0.45257769458388303 + t42;
    const iiwa_real k3_yy = k4_xx + 0.20191091047133833 - t42;
    const iiwa_real k3_xy = t39*t41 + t40*(1.0 - 2.0*t38);
    const iiwa_real t43 = k4_xy + 0.16230144331072144;
    const iiwa_real t44 = 0.06405373385272267 - neg_k4_yz;
    const iiwa_real k3_xz = c3*t43 + s3*t44;
    const iiwa_real k3_yz = s3*t43 - c3*t44;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = -0.4*h3_y - k3_yz;
    const iiwa_real t45 = k3_xz + 0.4*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu2_y_5 = s2*t45 + c2*m3_3;
    const iiwa_real t46 = k4_yy + 0.8*h4_y;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = k3_xx + t46 + 4.764988720880306;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_xx = t46 + 4.238401785575742 - (c2*c2*(t46 - k3_xx + 3.711814850271177) -
        (t45 + 0.5218524991029152)*(2.0*(c2*s2)));
    const iiwa_real k2_yz = s2*(k3_xy - 0.20091837135316784) + c2*(m2_3 + 0.26458063578324464);
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = k3_yy + k2_xx + 0.8058116303302202;
    M[0] = m1_1;
    M[1] = k2_yz;
    M[2] = neg_nu2_y_5;
    M[3] = neg_nu2_y_4;
    M[4] = neg_nu2_y_3;
    M[5] = neg_nu2_y_2;
    M[6] = neg_nu2_y;
    M[7] = k2_yz;
    M[8] = m2_2;
    M[9] = m2_3;
    M[10] = m2_4;
    M[11] = m2_5;
    M[12] = m2_6;
    M[13] = m2_7;
    M[14] = neg_nu2_y_5;
    M[15] = m2_3;
    M[16] = m3_3;
    M[17] = neg_k4_yz;
    M[18] = nu4_y_3;
    M[19] = nu4_y_2;
    M[20] = nu4_y;
    M[21] = neg_nu2_y_4;
    M[22] = m2_4;
    M[23] = neg_k4_yz;
    M[24] = m4_4;
    M[25] = m4_5;
    M[26] = m4_6;
    M[27] = m4_7;
    M[28] = neg_nu2_y_3;
    M[29] = m2_5;
    M[30] = nu4_y_3;
    M[31] = m4_5;
    M[32] = m5_5;
    M[33] = k6_yz;
    M[34] = neg_nu6_y;
    M[35] = neg_nu2_y_2;
    M[36] = m2_6;
    M[37] = nu4_y_2;
    M[38] = m4_6;
    M[39] = k6_yz;
    M[40] = m6_6;
    M[41] = m6_7;
    M[42] = neg_nu2_y;
    M[43] = m2_7;
    M[44] = nu4_y;
    M[45] = m4_7;
    M[46] = neg_nu6_y;
    M[47] = m6_7;
    M[48] = 0.48318719298539553;
}

/* accelerations that the torques tau give
 * 597 multiplications, 517 additions, 7 divisions = 1121; 17 unary minus; 12 sine/cosine */
void iiwa_forward_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real tau[7],
    iiwa_real qdd[7])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile iiwa_real *const again = q;
    /* sines and cosines of the joint angles */
    const iiwa_real c2 = cos(q[1]);
    const iiwa_real s2 = sin(again[1]);
    const iiwa_real c3 = cos(q[2]);
    const iiwa_real s3 = sin(again[2]);
    const iiwa_real c4 = cos(q[3]);
    const iiwa_real s4 = sin(again[3]);
    const iiwa_real c5 = cos(q[4]);
    const iiwa_real s5 = sin(again[4]);
    const iiwa_real c6 = cos(q[5]);
    const iiwa_real s6 = sin(again[5]);
    const iiwa_real c7 = cos(q[6]);
    const iiwa_real s7 = sin(again[6]);
    /* link 7: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h7_x = 0.9999503996366931*c7 - 0.708306797966195*s7;
    const iiwa_real neg_h7_y = -0.708306797966195*c7 - 0.9999503996366931*s7;
    const iiwa_real t1 = c7*c7;
    const iiwa_real t2 = c7*s7;
    /* link 7: second moment of the composite body [kg m^2] */
    const iiwa_real k7_xy = 0.2114247825686032*(2.0*t1 - 1.0) - 0.10136935104159488*t2;
    const iiwa_real k7_xz = 0.2024621683128357*c7 - 0.061680050398747424*s7;
    const iiwa_real k7_yz = 0.2024621683128357*s7 + 0.061680050398747424*c7;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real neg_m6_7 = k7_yz - 0.126*neg_h7_y;
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real fu6_x = c6*neg_h7_y;
    const iiwa_real fu6_y = s6*neg_h7_y;
    const iiwa_real t3 = k7_xz + 0.126*h7_x;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = 0.48318719298539553*s6 - c6*t3;
    const iiwa_real nu6_y = -0.48318719298539553*c6 - s6*t3;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real fu5_x = c5*fu6_x - s5*h7_x;
    const iiwa_real fu5_y = s5*fu6_x + c5*h7_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c5*nu6_x + s5*neg_m6_7;
    const iiwa_real neg_nu5_y = c5*neg_m6_7 - s5*nu6_x;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_7 = neg_nu5_y - 0.4*fu5_x;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x = c4*fu5_x + s4*fu6_y;
    const iiwa_real t4 = nu5_x - 0.4*fu5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x = c4*t4 + s4*nu6_y;
    const iiwa_real nu4_y = s4*t4 - c4*nu6_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = c3*fu4_x - s3*fu5_y;
    const iiwa_real fu3_y = s3*fu4_x + c3*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c3*nu4_x + s3*m4_7;
    const iiwa_real nu3_y = s3*nu4_x - c3*m4_7;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_7 = nu3_y + 0.4*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y = s2*(nu3_x - 0.4*fu3_y) - c2*nu4_y;
    const iiwa_real t5 = 0.10136935104159488*t1 + 0.4228495651372064*t2;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 2.745229884110378 - t5;
    const iiwa_real t6 = h7_x - 1.5656307599463828;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = c6*t6 + 1.291128497815195*s6;
    const iiwa_real h6_y = s6*t6 - 1.291128497815195*c6;
    const iiwa_real t7 = c6*c6;
    const iiwa_real t8 = t5 + 1.3126829026743974;
    const iiwa_real t9 = t3 + 0.36144292274665746;
    const iiwa_real t10 = c6*s6;
    const iiwa_real t11 = t7*t8 - t9*(2.0*t10);
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_yy = t11 - (t5 - 0.7162734907179903);
    const iiwa_real neg_k6_xy = t8*t10 - t9*(1.0 - 2.0*t7);
    const iiwa_real t12 = k7_xy - 0.042925575293549574;
    const iiwa_real t13 = 0.0870114460092663 - neg_m6_7;
    const iiwa_real k6_xz = c6*t12 - s6*t13;
    const iiwa_real k6_yz = s6*t12 + c6*t13;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = c5*h6_y;
    const iiwa_real t14 = -s5;
    const iiwa_real fu5_y_2 = t14*h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x_2 = t14*m6_6 - c5*k6_xz;
    const iiwa_real nu5_y = c5*m6_6 - s5*k6_xz;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_6 = 0.4*neg_fu5_x - nu5_y;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_2 = s4*h6_x - c4*neg_fu5_x;
    const iiwa_real t15 = nu5_x_2 - 0.4*fu5_y_2;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_2 = c4*t15 - s4*k6_yz;
    const iiwa_real nu4_y_2 = s4*t15 + c4*k6_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_2 = c3*fu4_x_2 - s3*fu5_y_2;
    const iiwa_real fu3_y_2 = s3*fu4_x_2 + c3*fu5_y_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_2 = c3*nu4_x_2 + s3*m4_6;
    const iiwa_real nu3_y_2 = s3*nu4_x_2 - c3*m4_6;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_6 = nu3_y_2 + 0.4*fu3_x_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y_2 = s2*(nu3_x_2 - 0.4*fu3_y_2) - c2*nu4_y_2;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t5 - t11 + 2.521169842515734;
    const iiwa_real t16 = h6_x - 0.25252954507510866;
    const iiwa_real t17 = 0.4193059538543958 - neg_h7_y;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_x = c5*t16 - s5*t17;
    const iiwa_real h5_y = s5*t16 + c5*t17;
    const iiwa_real t18 = c5*c5;
    const iiwa_real t19 = t5 + t11 - 1.7262407198899914;
    const iiwa_real t20 = 0.03284626166448073 - k6_xz;
    const iiwa_real t21 = c5*s5;
    const iiwa_real t22 = t18*t19 - t20*(2.0*t21);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_xx = t5 + 0.39746456131287133 - t22;
    const iiwa_real k5_yy = t22 - (t11 - 2.1237052812028625);
    const iiwa_real neg_k5_xy = t19*t21 - t20*(1.0 - 2.0*t18);
    const iiwa_real t23 = neg_k6_xy - 0.041147842218669614;
    const iiwa_real t24 = -k6_yz - 0.05680835589544868;
    const iiwa_real k5_xz = c5*t23 - s5*t24;
    const iiwa_real k5_yz = s5*t23 + c5*t24;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_5 = k5_yz + 0.4*h5_y;
    const iiwa_real t25 = -c4;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_3 = t25*h5_y;
    const iiwa_real t26 = k5_xz + 0.4*h5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_3 = -s4*m5_5 - c4*t26;
    const iiwa_real nu4_y_3 = c4*m5_5 - s4*t26;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_3 = c3*fu4_x_3 - s3*h5_x;
    const iiwa_real fu3_y_3 = s3*fu4_x_3 + c3*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_3 = c3*nu4_x_3 + s3*m4_5;
    const iiwa_real nu3_y_3 = s3*nu4_x_3 - c3*m4_5;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_5 = nu3_y_3 + 0.4*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y_3 = s2*(nu3_x_3 - 0.4*fu3_y_3) - c2*nu4_y_3;
    const iiwa_real t27 = 0.8*h6_y - k6_yy;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = k5_xx - t27 + 3.818015113559988;
    const iiwa_real t28 = h5_x - 0.5168019281781282;
    const iiwa_real t29 = h6_y - 8.054835434921454;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h4_x = c4*t28 + s4*t29;
    const iiwa_real h4_y = s4*t28 - c4*t29;
    const iiwa_real t30 = c4*c4;
    const iiwa_real t31 = k5_xx + t27 - 3.3209668850667637;
    const iiwa_real t32 = t26 - 0.20921122087079386;
    const iiwa_real t33 = c4*s4;
    const iiwa_real t34 = t30*t31 - t32*(2.0*t33);
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xx = t34 - (t27 - 3.569490999313376);
    const iiwa_real k4_yy = k5_xx + 0.24852411424661205 - t34;
    const iiwa_real k4_xy = t31*t33 - t32*(1.0 - 2.0*t30);
    const iiwa_real t35 = neg_k5_xy - 0.013124222729483126;
    const iiwa_real t36 = m4_5 - 0.09675036990607108;
    const iiwa_real k4_xz = c4*t35 + s4*t36;
    const iiwa_real k4_yz = s4*t35 - c4*t36;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu3_x = c3*h4_y;
    const iiwa_real neg_fu3_y = s3*h4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_4 = s3*m4_4 - c3*k4_xz;
    const iiwa_real neg_nu3_y = s3*k4_xz + c3*m4_4;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_4 = -0.4*neg_fu3_x - neg_nu3_y;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y_4 = s2*(nu3_x_4 + 0.4*neg_fu3_y) + c2*k4_yz;
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = k5_yy + k4_xx + 0.6544886050552213;
    const iiwa_real t37 = h5_y - 0.04389618410240257;
    const iiwa_real t38 = h4_x - 1.0168650139155704;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h3_x = s3*t37 - c3*t38;
    const iiwa_real h3_y = s3*t38 + c3*t37;
    const iiwa_real t39 = c3*c3;
    const iiwa_real t40 = k4_xx - k5_yy - 0.2506667841125447;
    const iiwa_real t41 = k4_xz + 0.1005265342798281;
    const iiwa_real t42 = c3*s3;
    const iiwa_real t43 = t39*t40 + t41*(2.0*t42);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_xx = k5_yy + 0.45257769458388303 + t43;
    const iiwa_real k3_yy = k4_xx + 0.20191091047133833 - t43;
    const iiwa_real k3_xy = t40*t42 + t41*(1.0 - 2.0*t39);
    const iiwa_real t44 = k4_xy + 0.16230144331072144;
    const iiwa_real t45 = k4_yz + 0.06405373385272267;
    const iiwa_real k3_xz = c3*t44 + s3*t45;
    const iiwa_real k3_yz = s3*t44 - c3*t45;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_3 = -0.4*h3_y - k3_yz;
    const iiwa_real t46 = 0.4*neg_h3_x - k3_xz;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_y_5 = s2*t46 - c2*m3_3;
    const iiwa_real t47 = k4_yy + 0.8*h4_y;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = k3_xx + t47 + 4.764988720880306;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_xx = t47 + 4.238401785575742 - (c2*c2*(t47 - k3_xx + 3.711814850271177) -
        (0.5218524991029152 - t46)*(2.0*(c2*s2)));
    const iiwa_real k2_yz = s2*(k3_xy - 0.20091837135316784) + c2*(m2_3 + 0.26458063578324464);
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = k3_yy + k2_xx + 0.8058116303302202;
    const iiwa_real t48 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = t48*s2;
    const iiwa_real w2_y = t48*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a2_x = 9.81*s2;
    const iiwa_real neg_a2_y = 9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = qd[1]*w2_y;
    const iiwa_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const iiwa_real ww2_xy = w2_x*w2_y;
    const iiwa_real ww2_xx = w2_x*w2_x;
    const iiwa_real ww2_yy = w2_y*w2_y;
    const iiwa_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam2_11 = ww2_yy + ww2_zz;
    const iiwa_real neg_lam2_22 = ww2_xx + ww2_zz;
    const iiwa_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_z = neg_a2_y - 0.4*neg_lam2_22;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t49 = -0.8*alpha2_x;
    const iiwa_real t50 = neg_a2_x + 0.4*ww2_xy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t49 - c3*t50;
    const iiwa_real a3_y = s3*t50 + c3*t49;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const iiwa_real alpha3_y = -qd[2]*w3_x - s3*alpha2_x;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_z = qd[2] - w2_y;
    /* link 3: products of the angular velocity [1/s^2] */
    const iiwa_real ww3_yz = w3_y*w3_z;
    const iiwa_real ww3_zx = w3_x*w3_z;
    const iiwa_real ww3_xy = w3_x*w3_y;
    const iiwa_real ww3_xx = w3_x*w3_x;
    const iiwa_real ww3_yy = w3_y*w3_y;
    const iiwa_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam3_11 = ww3_yy + ww3_zz;
    const iiwa_real lam3_12 = ww3_xy - neg_alpha2_y;
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_21 = neg_alpha2_y + ww3_xy;
    const iiwa_real neg_lam3_22 = ww3_xx + ww3_zz;
    const iiwa_real lam3_23 = ww3_yz - alpha3_x;
    const iiwa_real neg_lam3_31 = alpha3_y - ww3_zx;
    const iiwa_real lam3_32 = alpha3_x + ww3_yz;
    const iiwa_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_x = c4*w3_x + s4*w3_z;
    const iiwa_real w4_y = c4*w3_z - s4*w3_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a4_x = c4*a3_x + s4*a3_z;
    const iiwa_real a4_y = c4*a3_z - s4*a3_x;
    /* link 4: angular acceleration [rad/s^2] */
    const iiwa_real alpha4_x = qd[3]*w4_y - (t25*alpha3_x - s4*neg_alpha2_y);
    const iiwa_real alpha4_y = c4*neg_alpha2_y - s4*alpha3_x - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real ww4_xx = w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real neg_lam4_22 = ww4_xx + ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y - 0.4*neg_lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real w5_y = -c5*w4_z - s5*w4_x;
    const iiwa_real t51 = a3_y - 0.4*lam4_32;
    const iiwa_real t52 = -0.4*lam4_12 - a4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t51 - c5*t52;
    const iiwa_real a5_y = s5*t52 + c5*t51;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (t14*alpha3_y - c5*alpha4_x);
    const iiwa_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const iiwa_real ww5_yz = w5_y*w5_z;
    const iiwa_real ww5_zx = w5_x*w5_z;
    const iiwa_real ww5_xy = w5_x*w5_y;
    const iiwa_real ww5_xx = w5_x*w5_x;
    const iiwa_real ww5_yy = w5_y*w5_y;
    const iiwa_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam5_11 = ww5_yy + ww5_zz;
    const iiwa_real lam5_12 = ww5_xy - alpha4_y;
    const iiwa_real lam5_13 = alpha5_y + ww5_zx;
    const iiwa_real lam5_21 = alpha4_y + ww5_xy;
    const iiwa_real neg_lam5_22 = ww5_xx + ww5_zz;
    const iiwa_real lam5_23 = ww5_yz - alpha5_x;
    const iiwa_real lam5_31 = ww5_zx - alpha5_y;
    const iiwa_real lam5_32 = alpha5_x + ww5_yz;
    const iiwa_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_x = c6*w5_x - s6*w5_z;
    const iiwa_real t53 = -c6;
    const iiwa_real w6_y = t53*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a6_x = c6*a5_x - s6*a5_z;
    const iiwa_real a6_y = t53*a5_z - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const iiwa_real alpha6_y = t53*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const iiwa_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const iiwa_real ww6_yz = w6_y*w6_z;
    const iiwa_real ww6_zx = w6_x*w6_z;
    const iiwa_real ww6_xy = w6_x*w6_y;
    const iiwa_real ww6_xx = w6_x*w6_x;
    const iiwa_real ww6_yy = w6_y*w6_y;
    const iiwa_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam6_11 = ww6_yy + ww6_zz;
    const iiwa_real lam6_12 = ww6_xy - alpha5_y;
    const iiwa_real lam6_13 = alpha6_y + ww6_zx;
    const iiwa_real lam6_21 = alpha5_y + ww6_xy;
    const iiwa_real neg_lam6_22 = ww6_xx + ww6_zz;
    const iiwa_real lam6_23 = ww6_yz - alpha6_x;
    const iiwa_real lam6_31 = ww6_zx - alpha6_y;
    const iiwa_real lam6_32 = alpha6_x + ww6_yz;
    const iiwa_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_z = -0.126*neg_lam6_22 - a6_y;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_x = c7*w6_x + s7*w6_z;
    const iiwa_real w7_y = c7*w6_z - s7*w6_x;
    const iiwa_real t54 = a5_y - 0.126*lam6_32;
    const iiwa_real t55 = 0.126*lam6_12 - a6_x;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t54 - c7*t55;
    const iiwa_real a7_y = s7*t55 + c7*t54;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-s7*alpha5_y - c7*alpha6_x);
    const iiwa_real alpha7_y = c7*alpha5_y - s7*alpha6_x - qd[6]*w7_x;
    /* link 7: angular velocity [rad/s] */
    const iiwa_real w7_z = qd[6] - w6_y;
    /* link 7: products of the angular velocity [1/s^2] */
    const iiwa_real ww7_yz = w7_y*w7_z;
    const iiwa_real ww7_zx = w7_x*w7_z;
    const iiwa_real ww7_xy = w7_x*w7_y;
    const iiwa_real ww7_xx = w7_x*w7_x;
    const iiwa_real ww7_yy = w7_y*w7_y;
    const iiwa_real ww7_zz = w7_z*w7_z;
    /* link 7: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam7_11 = ww7_yy + ww7_zz;
    const iiwa_real lam7_12 = alpha6_y + ww7_xy;
    const iiwa_real lam7_13 = alpha7_y + ww7_zx;
    const iiwa_real lam7_21 = ww7_xy - alpha6_y;
    const iiwa_real neg_lam7_22 = ww7_xx + ww7_zz;
    const iiwa_real lam7_23 = ww7_yz - alpha7_x;
    const iiwa_real lam7_31 = ww7_zx - alpha7_y;
    const iiwa_real lam7_32 = alpha7_x + ww7_yz;
    const iiwa_real neg_lam7_33 = ww7_xx + ww7_yy;
    /* link 2: moment that turns the link [N m] */
    const iiwa_real nc2_x = 0.20091837135316784*ww2_xy - 1.0437049982058304*neg_alpha2_y -
        (-8.476803571151484*alpha2_x - 0.26458063578324464*(neg_lam2_22 - neg_lam2_33));
    const iiwa_real nc2_y = 0.20091837135316784*(neg_lam2_11 - neg_lam2_33) -
        1.0531738706091291*neg_alpha2_y + (0.26458063578324464*ww2_xy +
        1.0437049982058304*alpha2_x);
    const iiwa_real nc2_z = 13.292379489096295*c2 - 76.6738398539524*s2 - (3.711814850271177*ww2_xy
        + 0.5218524991029152*(neg_lam2_11 - neg_lam2_22));
    /* link 3: force that moves the link [N] */
    const iiwa_real fc3_x = 1.0168650139155704*neg_lam3_11 - 0.04389618410240257*lam3_12;
    const iiwa_real fc3_y = 0.04389618410240257*neg_lam3_22 - 1.0168650139155704*lam3_21;
    /* link 3: moment that turns the link [N m] */
    const iiwa_real neg_nc3_x = 0.06405373385272267*(neg_lam3_22 - neg_lam3_33) -
        0.45257769458388303*lam3_32 - (0.1005265342798281*neg_lam3_31 - 0.16230144331072144*lam3_21)
        + 0.04389618410240257*a3_z;
    const iiwa_real nc3_y = 0.20191091047133833*neg_lam3_31 - 0.16230144331072144*(neg_lam3_11 -
        neg_lam3_33) - (0.06405373385272267*lam3_12 - 0.1005265342798281*lam3_32) +
        1.0168650139155704*a3_z;
    const iiwa_real t56 = 0.45257769458388303*lam3_12 - 0.20191091047133833*lam3_21 +
        0.1005265342798281*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real neg_nc3_z = t56 + (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = -8.054835434921454*neg_lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(neg_lam4_22 -
        neg_lam4_33) - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) +
        8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 - neg_lam4_33) -
        0.24852411424661205*lam4_31 + (0.09675036990607108*lam4_12 + 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t57 = 3.569490999313376*lam4_12 - 0.24852411424661205*lam4_21 +
        0.20921122087079386*(neg_lam4_11 - neg_lam4_22) + (0.013124222729483126*lam4_23 +
        0.09675036990607108*lam4_13);
    const iiwa_real neg_nc4_z = t57 + (0.5168019281781282*a4_y + 8.054835434921454*a4_x);
    /* link 5: force that moves the link [N] */
    const iiwa_real fc5_x = 0.25252954507510866*neg_lam5_11 + 0.4193059538543958*lam5_12;
    const iiwa_real fc5_y = -0.4193059538543958*neg_lam5_22 - 0.25252954507510866*lam5_21;
    const iiwa_real fc5_z = 0.4193059538543958*lam5_32 - 0.25252954507510866*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const iiwa_real nc5_x = 0.4193059538543958*a5_z - (0.05680835589544868*(neg_lam5_22 -
        neg_lam5_33) - 0.20655564034097101*lam5_32 - (0.041147842218669614*lam5_21 -
        0.03284626166448073*lam5_31));
    const iiwa_real nc5_y = 0.041147842218669614*(neg_lam5_11 - neg_lam5_33) -
        0.09474888781047501*lam5_31 + (0.03284626166448073*lam5_32 - 0.05680835589544868*lam5_12) +
        0.25252954507510866*a5_z;
    const iiwa_real t58 = 0.09474888781047501*lam5_21 - 0.20655564034097101*lam5_12 -
        0.03284626166448073*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614*lam5_23 -
        0.05680835589544868*lam5_13);
    const iiwa_real nc5_z = t58 - (0.25252954507510866*a5_y + 0.4193059538543958*a5_x);
    /* link 6: force that moves the link [N] */
    const iiwa_real fc6_x = 1.5656307599463828*neg_lam6_11 - 1.291128497815195*lam6_12;
    const iiwa_real fc6_y = 1.291128497815195*neg_lam6_22 - 1.5656307599463828*lam6_21;
    const iiwa_real fc6_z = -1.5656307599463828*lam6_31 - 1.291128497815195*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real nc6_x = -1.291128497815195*a5_y - (-2.0289563933923875*lam6_32 -
        0.0870114460092663*(neg_lam6_22 - neg_lam6_33) - (0.042925575293549574*lam6_21 -
        0.36144292274665746*lam6_31));
    const iiwa_real nc6_y = 0.042925575293549574*(neg_lam6_11 - neg_lam6_33) -
        0.4239952187044951*lam6_31 - (-0.0870114460092663*lam6_12 - 0.36144292274665746*lam6_32) +
        1.5656307599463828*a5_y;
    const iiwa_real t59 = 0.4239952187044951*lam6_21 - 2.0289563933923875*lam6_12 -
        0.36144292274665746*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574*lam6_23 +
        0.0870114460092663*lam6_13);
    const iiwa_real nc6_z = t59 - (1.5656307599463828*a6_y - 1.291128497815195*a6_x);
    /* link 7: force that moves the link [N] */
    const iiwa_real fc7_x = 0.708306797966195*lam7_12 - 0.9999503996366931*neg_lam7_11;
    const iiwa_real fc7_y = 0.9999503996366931*lam7_21 - 0.708306797966195*neg_lam7_22;
    const iiwa_real fc7_z = 0.9999503996366931*lam7_31 + 0.708306797966195*lam7_32;
    /* link 7: moment that turns the link [N m] */
    const iiwa_real nc7_x = 0.708306797966195*a7_z - (-0.2922782720134952*lam7_32 -
        0.061680050398747424*(neg_lam7_22 - neg_lam7_33) + (0.2024621683128357*lam7_21 -
        0.2114247825686032*lam7_31));
    const iiwa_real nc7_y = -0.19090892097190032*lam7_31 - 0.2024621683128357*(neg_lam7_11 -
        neg_lam7_33) + (0.061680050398747424*lam7_12 - 0.2114247825686032*lam7_32) -
        0.9999503996366931*a7_z;
    const iiwa_real t60 = 0.2922782720134952*lam7_12 - 0.19090892097190032*lam7_21 -
        0.2114247825686032*(neg_lam7_11 - neg_lam7_22) - (0.2024621683128357*lam7_23 -
        0.061680050398747424*lam7_13);
    const iiwa_real nc7_z = 0.9999503996366931*a7_y - 0.708306797966195*a7_x - t60;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f07_x = c7*fc7_x - s7*fc7_y;
    const iiwa_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (nc6_x - 0.126*f07_y);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z + 0.126*f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x + f07_x;
    const iiwa_real f6_y = fc6_y - fc7_z;
    const iiwa_real f6_z = fc6_z + f07_y;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f06_x = c6*f6_x - s6*f6_y;
    const iiwa_real f06_y = s6*f6_x + c6*f6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n06_x = c6*n6_x - s6*n6_y;
    const iiwa_real n06_y = s6*n6_x + c6*n6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n5_x = nc5_x + n06_x;
    const iiwa_real n5_y = nc5_y + n6_z;
    const iiwa_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const iiwa_real f5_x = fc5_x + f06_x;
    const iiwa_real f5_y = fc5_y + f6_z;
    const iiwa_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f05_x = c5*f5_x - s5*f5_y;
    const iiwa_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n05_x = c5*n5_x - s5*n5_y;
    const iiwa_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n4_x = n05_x - (neg_nc4_x + 0.4*f05_y);
    const iiwa_real n4_y = nc4_y + n5_z;
    const iiwa_real neg_n4_z = n05_y + (neg_nc4_z + 0.4*f05_x);
    /* link 4: force through the joint [N] */
    const iiwa_real f4_x = fc4_x + f05_x;
    const iiwa_real f4_y = fc4_y + f5_z;
    const iiwa_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f04_x = c4*f4_x - s4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n04_x = c4*n4_x - s4*n4_y;
    const iiwa_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_x = n04_x - neg_nc3_x;
    const iiwa_real n3_y = nc3_y + neg_n4_z;
    const iiwa_real n3_z = n04_y - neg_nc3_z;
    /* link 3: force through the joint [N] */
    const iiwa_real f3_x = fc3_x + f04_x;
    const iiwa_real f3_y = fc3_y - f4_z;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f03_x = c3*f3_x - s3*f3_y;
    const iiwa_real f03_y = s3*f3_x + c3*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n03_x = c3*n3_x - s3*n3_y;
    const iiwa_real n03_y = s3*n3_x + c3*n3_y;
    /* link 2: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n2_x = n03_x - (0.4*f03_y - nc2_x);
    const iiwa_real n2_y = nc2_y - n3_z;
    const iiwa_real n2_z = n03_y + (nc2_z + 0.4*f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n02_y = s2*n2_x + c2*n2_y;
    /* link 1: forward substitution */
    const iiwa_real y1 = tau[0] + n02_y;
    /* factorisation M = L D L^T */
    const iiwa_real neg_ipivot1 = -1.0 / m1_1;
    const iiwa_real l2_1 = -k2_yz*neg_ipivot1;
    const iiwa_real l3_1 = nu2_y_5*neg_ipivot1;
    const iiwa_real l4_1 = nu2_y_4*neg_ipivot1;
    const iiwa_real l5_1 = nu2_y_3*neg_ipivot1;
    const iiwa_real l6_1 = nu2_y_2*neg_ipivot1;
    const iiwa_real l7_1 = nu2_y*neg_ipivot1;
    const iiwa_real pivot2 = m2_2 - k2_yz*l2_1;
    const iiwa_real ipivot2 = 1.0 / pivot2;
    const iiwa_real ld3_2 = m2_3 - k2_yz*l3_1;
    const iiwa_real l3_2 = ipivot2*ld3_2;
    const iiwa_real ld4_2 = m2_4 - k2_yz*l4_1;
    const iiwa_real l4_2 = ipivot2*ld4_2;
    const iiwa_real ld5_2 = m2_5 - k2_yz*l5_1;
    const iiwa_real l5_2 = ipivot2*ld5_2;
    const iiwa_real ld6_2 = m2_6 - k2_yz*l6_1;
    const iiwa_real l6_2 = ipivot2*ld6_2;
    const iiwa_real ld7_2 = m2_7 - k2_yz*l7_1;
    const iiwa_real l7_2 = ipivot2*ld7_2;
    const iiwa_real pivot3 = m3_3 + nu2_y_5*l3_1 - ld3_2*l3_2;
    const iiwa_real ipivot3 = 1.0 / pivot3;
    const iiwa_real ld4_3 = nu2_y_5*l4_1 - k4_yz - ld3_2*l4_2;
    const iiwa_real l4_3 = ipivot3*ld4_3;
    const iiwa_real ld5_3 = nu4_y_3 + nu2_y_5*l5_1 - ld3_2*l5_2;
    const iiwa_real l5_3 = ipivot3*ld5_3;
    const iiwa_real ld6_3 = nu4_y_2 + nu2_y_5*l6_1 - ld3_2*l6_2;
    const iiwa_real l6_3 = ipivot3*ld6_3;
    const iiwa_real ld7_3 = nu4_y + nu2_y_5*l7_1 - ld3_2*l7_2;
    const iiwa_real l7_3 = ipivot3*ld7_3;
    const iiwa_real pivot4 = m4_4 + nu2_y_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const iiwa_real ipivot4 = 1.0 / pivot4;
    const iiwa_real ld5_4 = m4_5 + nu2_y_4*l5_1 - ld4_2*l5_2 - ld4_3*l5_3;
    const iiwa_real l5_4 = ipivot4*ld5_4;
    const iiwa_real ld6_4 = -ld4_3*l6_3 - (ld4_2*l6_2 - (m4_6 + nu2_y_4*l6_1));
    const iiwa_real l6_4 = ipivot4*ld6_4;
    const iiwa_real ld7_4 = m4_7 + nu2_y_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3;
    const iiwa_real l7_4 = ipivot4*ld7_4;
    const iiwa_real pivot5 = m5_5 + nu2_y_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const iiwa_real ipivot5 = 1.0 / pivot5;
    const iiwa_real ld6_5 = -ld5_3*l6_3 - (ld5_2*l6_2 - (k6_yz + nu2_y_3*l6_1)) - ld5_4*l6_4;
    const iiwa_real l6_5 = ipivot5*ld6_5;
    const iiwa_real ld7_5 = nu2_y_3*l7_1 - nu6_y - ld5_2*l7_2 - ld5_3*l7_3 - ld5_4*l7_4;
    const iiwa_real l7_5 = ipivot5*ld7_5;
    const iiwa_real pivot6 = -ld6_5*l6_5 - (ld6_2*l6_2 - (m6_6 + nu2_y_2*l6_1) + ld6_3*l6_3 +
        ld6_4*l6_4);
    const iiwa_real ipivot6 = 1.0 / pivot6;
    const iiwa_real ld7_6 = -(ld6_2*l7_2 - (nu2_y_2*l7_1 - neg_m6_7) + ld6_3*l7_3 + ld6_4*l7_4) -
        ld6_5*l7_5;
    const iiwa_real l7_6 = ipivot6*ld7_6;
    const iiwa_real t61 = nu2_y*l7_1 + 0.48318719298539553 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4 -
        ld7_5*l7_5;
    const iiwa_real pivot7 = t61 - ld7_6*l7_6;
    const iiwa_real ipivot7 = 1.0 / pivot7;
    /* link 2: forward substitution */
    const iiwa_real y2 = tau[1] - n2_z - y1*l2_1;
    /* link 3: forward substitution */
    const iiwa_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const iiwa_real y4 = tau[3] + neg_n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const iiwa_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const iiwa_real y6 = tau[5] - n6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    const iiwa_real t62 = tau[6] - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5;
    /* link 7: forward substitution */
    const iiwa_real y7 = t62 - l7_6*y6;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd7 = ipivot7*y7;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd6 = ipivot6*y6 - l7_6*qdd7;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd3 = -l7_3*qdd7 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd2 = -l7_2*qdd7 - (l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 +
        l6_2*qdd6);
    const iiwa_real t63 = y1*neg_ipivot1 + l2_1*qdd2 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 +
        l6_1*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd1 = -t63 - l7_1*qdd7;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
