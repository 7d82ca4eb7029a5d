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
 *   inverse_dynamics: 296 multiplications, 281 additions = 577; 7 unary minus; 12 sine/cosine
 *   gravity: 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine
 *   bias: 288 multiplications, 262 additions = 550; 10 unary minus; 12 sine/cosine
 *   mass_matrix: 183 multiplications, 150 additions = 333; 10 unary minus; 12 sine/cosine
 *   forward_dynamics: 597 multiplications, 517 additions, 7 divisions = 1121; 24 unary minus; 12
 *       sine/cosine
 */
#include "iiwa.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 296 multiplications, 281 additions = 577; 7 unary minus; 12 sine/cosine */
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
    const iiwa_real a2_x = -9.81*s2;
    const iiwa_real a2_y = -9.81*c2;
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
    const iiwa_real lam2_23 = ww2_yz - alpha2_x;
    const iiwa_real lam2_31 = ww2_zx + neg_alpha2_y;
    const iiwa_real lam2_32 = ww2_yz + alpha2_x;
    const iiwa_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_z = -0.4*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t2 = -0.4*lam2_32;
    const iiwa_real t3 = 0.4*lam2_12 - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t2 - c3*t3;
    const iiwa_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = qd[2]*w3_y - (-c3*alpha2_x - qdd[1]*s3);
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
    const iiwa_real alpha4_x = qd[3]*w4_y - (-c4*alpha3_x - s4*alpha3_z);
    const iiwa_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const iiwa_real alpha4_z = qdd[3] - alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real neg_ww4_xx = -w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = ww4_xy - alpha4_z;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = alpha4_z + ww4_xy;
    const iiwa_real lam4_22 = neg_ww4_xx - ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real lam4_33 = neg_ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y + 0.4*lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real t4 = -s5;
    const iiwa_real w5_y = t4*w4_x - c5*w4_z;
    const iiwa_real t5 = a3_y - 0.4*lam4_32;
    const iiwa_real t6 = -0.4*lam4_12 - a4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t5 - c5*t6;
    const iiwa_real a5_y = s5*t6 + c5*t5;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const iiwa_real alpha5_y = t4*alpha4_x - c5*alpha4_z - qd[4]*w5_x;
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
    const iiwa_real t7 = -s6;
    const iiwa_real w6_y = t7*w5_x - c6*w5_z;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a6_x = s6*a5_z - c6*a5_x;
    const iiwa_real a6_y = t7*a5_x - c6*a5_z;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha5_z - c6*alpha5_x);
    const iiwa_real alpha6_y = t7*alpha5_x - c6*alpha5_z - qd[5]*w6_x;
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
    const iiwa_real t9 = neg_a6_x + 0.126*lam6_12;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t8 - c7*t9;
    const iiwa_real a7_y = s7*t9 + c7*t8;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-c7*alpha6_x - s7*alpha6_z);
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
        0.5218524991029152*(neg_lam2_11 - neg_lam2_22) + (-0.20091837135316784*lam2_23 -
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
    const iiwa_real t11 = 0.20191091047133833*lam3_21 - 0.45257769458388303*lam3_12 -
        0.1005265342798281*(neg_lam3_11 - neg_lam3_22) + (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real nc3_z = t11 - (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = 8.054835434921454*lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(lam4_33 - lam4_22)
        - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) + 8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 + lam4_33) -
        0.24852411424661205*lam4_31 - (-0.09675036990607108*lam4_12 - 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t12 = 0.24852411424661205*lam4_21 - 3.569490999313376*lam4_12 -
        0.20921122087079386*(neg_lam4_11 + lam4_22) - (0.013124222729483126*lam4_23 +
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
    const iiwa_real nc6_z = t14 - (1.5656307599463828*a6_y + 1.291128497815195*neg_a6_x);
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
    const iiwa_real neg_f07_x = s7*fc7_y - c7*fc7_x;
    const iiwa_real f07_y = s7*fc7_x + c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (nc6_x - 0.126*f07_y);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z - 0.126*neg_f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x - neg_f07_x;
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
 * 64 multiplications, 38 additions = 102; 3 unary minus; 12 sine/cosine */
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
    const iiwa_real a2_x = -9.81*s2;
    const iiwa_real a2_y = -9.81*c2;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = c3*a2_x;
    const iiwa_real a3_y = -s3*a2_x;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a4_x = c4*a3_x - s4*a2_y;
    const iiwa_real a4_y = -s4*a3_x - c4*a2_y;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = c5*a4_x + s5*a3_y;
    const iiwa_real a5_y = c5*a3_y - s5*a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a6_x = c6*a5_x - s6*a4_y;
    const iiwa_real a6_y = -s6*a5_x - c6*a4_y;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = c7*a6_x + s7*a5_y;
    const iiwa_real a7_y = c7*a5_y - s7*a6_x;
    /* link 2: moment that turns the link [N m] */
    const iiwa_real nc2_z = 13.292379489096295*c2 - 76.6738398539524*s2;
    /* link 3: moment that turns the link [N m] */
    const iiwa_real nc3_x = -0.43062156604456925*c2;
    const iiwa_real nc3_y = 9.975445786511747*c2;
    const iiwa_real nc3_z = 0.04389618410240257*a3_x - 1.0168650139155704*a3_y;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real nc4_x = -8.054835434921454*a3_y;
    const iiwa_real nc4_y = -0.5168019281781282*a3_y;
    const iiwa_real nc4_z = -8.054835434921454*a4_x - 0.5168019281781282*a4_y;
    /* link 5: moment that turns the link [N m] */
    const iiwa_real nc5_x = 0.4193059538543958*a4_y;
    const iiwa_real nc5_y = 0.25252954507510866*a4_y;
    const iiwa_real nc5_z = -0.4193059538543958*a5_x - 0.25252954507510866*a5_y;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real nc6_x = -1.291128497815195*a5_y;
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
    const iiwa_real n6_x = nc6_x + n07_x;
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
    const iiwa_real n4_x = nc4_x + n05_x;
    const iiwa_real n4_y = nc4_y + n5_z;
    const iiwa_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n04_x = c4*n4_x - s4*n4_y;
    const iiwa_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n3_x = nc3_x + n04_x;
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
 * 288 multiplications, 262 additions = 550; 10 unary minus; 12 sine/cosine */
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
    const iiwa_real a2_x = -9.81*s2;
    const iiwa_real a2_y = -9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = qd[1]*w2_y;
    const iiwa_real alpha2_y = -qd[1]*w2_x;
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
    const iiwa_real a3_z = -0.4*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t2 = -0.8*alpha2_x;
    const iiwa_real t3 = 0.4*ww2_xy - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t2 - c3*t3;
    const iiwa_real a3_y = s3*t3 + c3*t2;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const iiwa_real alpha3_y = -s3*alpha2_x - qd[2]*w3_x;
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
    const iiwa_real lam3_12 = alpha2_y + ww3_xy;
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_21 = ww3_xy - alpha2_y;
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
    const iiwa_real alpha4_x = qd[3]*w4_y - (s4*alpha2_y - c4*alpha3_x);
    const iiwa_real alpha4_y = -s4*alpha3_x - c4*alpha2_y - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real neg_ww4_xx = -w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real lam4_22 = neg_ww4_xx - ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real lam4_33 = neg_ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y + 0.4*lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real w5_y = -s5*w4_x - c5*w4_z;
    const iiwa_real t4 = a3_y - 0.4*lam4_32;
    const iiwa_real t5 = -0.4*lam4_12 - a4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t4 - c5*t5;
    const iiwa_real a5_y = s5*t5 + c5*t4;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (-c5*alpha4_x - s5*alpha3_y);
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
    const iiwa_real t6 = -s6;
    const iiwa_real w6_y = t6*w5_x - c6*w5_z;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a6_x = s6*a5_z - c6*a5_x;
    const iiwa_real a6_y = t6*a5_x - c6*a5_z;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const iiwa_real alpha6_y = t6*alpha5_x - c6*alpha4_y - qd[5]*w6_x;
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
    const iiwa_real t8 = neg_a6_x + 0.126*lam6_12;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t7 - c7*t8;
    const iiwa_real a7_y = s7*t8 + c7*t7;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-c7*alpha6_x - s7*alpha5_y);
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
    const iiwa_real nc2_x = 1.0437049982058304*alpha2_y + 0.20091837135316784*ww2_xy -
        (-8.476803571151484*alpha2_x - 0.26458063578324464*(neg_lam2_22 - neg_lam2_33));
    const iiwa_real nc2_y = 1.0531738706091291*alpha2_y + 0.20091837135316784*(neg_lam2_11 -
        neg_lam2_33) + (0.26458063578324464*ww2_xy + 1.0437049982058304*alpha2_x);
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
    const iiwa_real t9 = 0.45257769458388303*lam3_12 - 0.20191091047133833*lam3_21 +
        0.1005265342798281*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real neg_nc3_z = t9 + (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = 8.054835434921454*lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(lam4_33 - lam4_22)
        - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) + 8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 + lam4_33) -
        0.24852411424661205*lam4_31 + (0.09675036990607108*lam4_12 + 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t10 = 3.569490999313376*lam4_12 - 0.24852411424661205*lam4_21 +
        0.20921122087079386*(neg_lam4_11 + lam4_22) + (0.013124222729483126*lam4_23 +
        0.09675036990607108*lam4_13);
    const iiwa_real nc4_z = -8.054835434921454*a4_x - 0.5168019281781282*a4_y - t10;
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
    const iiwa_real neg_nc6_x = -2.0289563933923875*lam6_32 - 0.0870114460092663*(neg_lam6_22 -
        neg_lam6_33) - (0.042925575293549574*lam6_21 - 0.36144292274665746*lam6_31) +
        1.291128497815195*a5_y;
    const iiwa_real nc6_y = 0.042925575293549574*(neg_lam6_11 - neg_lam6_33) -
        0.4239952187044951*lam6_31 - (-0.0870114460092663*lam6_12 - 0.36144292274665746*lam6_32) +
        1.5656307599463828*a5_y;
    const iiwa_real t12 = 0.4239952187044951*lam6_21 - 2.0289563933923875*lam6_12 -
        0.36144292274665746*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574*lam6_23 +
        0.0870114460092663*lam6_13);
    const iiwa_real nc6_z = t12 - (1.5656307599463828*a6_y + 1.291128497815195*neg_a6_x);
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
    const iiwa_real neg_f07_y = -s7*fc7_x - c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (0.126*neg_f07_y - neg_nc6_x);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z + 0.126*f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x + f07_x;
    const iiwa_real f6_y = fc6_y - fc7_z;
    const iiwa_real f6_z = fc6_z - neg_f07_y;
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
    const iiwa_real neg_n2_x = 0.4*f03_y - nc2_x - n03_x;
    const iiwa_real n2_y = nc2_y - n3_z;
    const iiwa_real n2_z = n03_y + (nc2_z + 0.4*f03_x);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real neg_n02_y = s2*neg_n2_x - c2*n2_y;
    tau[0] = neg_n02_y;
    tau[1] = n2_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = n6_z;
    tau[6] = nc7_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 183 multiplications, 150 additions = 333; 10 unary minus; 12 sine/cosine */
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
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu6_x = 0.708306797966195*c7 + 0.9999503996366931*s7;
    const iiwa_real fu6_z = 0.9999503996366931*c7 - 0.708306797966195*s7;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = -0.126*fu6_z - (0.2024621683128357*c7 - 0.061680050398747424*s7);
    const iiwa_real nu6_z = -0.126*neg_fu6_x - (0.2024621683128357*s7 + 0.061680050398747424*c7);
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = c6*neg_fu6_x;
    const iiwa_real fu5_z = s6*neg_fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c6*nu6_x + 0.48318719298539553*s6;
    const iiwa_real nu5_z = 0.48318719298539553*c6 - s6*nu6_x;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x = -c5*neg_fu5_x - s5*fu6_z;
    const iiwa_real fu4_z = s5*neg_fu5_x - c5*fu6_z;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x = 0.4*fu4_z - (s5*nu6_z - c5*nu5_x);
    const iiwa_real t1 = -s5;
    const iiwa_real nu4_z = t1*nu5_x - c5*nu6_z - 0.4*fu4_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = c4*fu4_x - s4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu3_x = s4*nu5_z - c4*nu4_x;
    const iiwa_real nu3_z = s4*nu4_x + c4*nu5_z;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x = c3*fu3_x + s3*fu4_z;
    const iiwa_real neg_fu2_z = c3*fu4_z - s3*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x = 0.4*neg_fu2_z - (c3*neg_nu3_x - s3*nu4_z);
    const iiwa_real nu2_z = 0.4*fu2_x - (s3*neg_nu3_x + c3*nu4_z);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z = c2*nu3_z - s2*nu2_x;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = fu6_z - 1.5656307599463828;
    const iiwa_real t2 = c7*c7;
    const iiwa_real t3 = c7*s7;
    const iiwa_real t4 = 0.10136935104159488*t2 + 0.4228495651372064*t3;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xx = 0.7162734907179903 - t4;
    const iiwa_real k6_xy = nu6_x - 0.36144292274665746;
    const iiwa_real k6_xz = 0.2114247825686032*(2.0*t2 - 1.0) - 0.10136935104159488*t3 -
        0.042925575293549574;
    const iiwa_real k6_yz = nu6_z + 0.0870114460092663;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 2.745229884110378 - t4;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real fu5_x = 1.291128497815195*c6 - s6*h6_x;
    const iiwa_real fu5_z_2 = -c6*h6_x - 1.291128497815195*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x_2 = s6*k6_yz - c6*k6_xz;
    const iiwa_real nu5_z_2 = s6*k6_xz + c6*k6_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_2 = c5*fu5_x;
    const iiwa_real fu4_z_2 = t1*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_2 = c5*nu5_x_2 - s5*m6_6 + 0.4*fu4_z_2;
    const iiwa_real nu4_z_2 = -0.4*fu4_x_2 - (s5*nu5_x_2 + c5*m6_6);
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_2 = c4*fu4_x_2 - s4*fu5_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c4*nu4_x_2 - s4*nu5_z_2;
    const iiwa_real nu3_z_2 = s4*nu4_x_2 + c4*nu5_z_2;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const iiwa_real fu2_z = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_2 = c3*nu3_x + s3*nu4_z_2 - 0.4*fu2_z;
    const iiwa_real nu2_z_2 = s3*nu3_x - c3*nu4_z_2 + 0.4*fu2_x_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2;
    const iiwa_real t5 = c6*c6;
    const iiwa_real t6 = t4 + 1.3126829026743974;
    const iiwa_real t7 = c6*s6;
    const iiwa_real t8 = t5*t6 + k6_xy*(2.0*t7);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_zz = k6_xx + t8;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_x = -fu5_z_2 - 0.25252954507510866;
    const iiwa_real h5_y = neg_fu6_x + 0.4193059538543958;
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_xx = 2.1237052812028625 - t8;
    const iiwa_real k5_yy = t4 + 0.39746456131287133;
    const iiwa_real k5_xy = -nu5_x_2 - 0.03284626166448073;
    const iiwa_real k5_xz = t6*t7 + k6_xy*(1.0 - 2.0*t5) - 0.041147842218669614;
    const iiwa_real k5_yz = -nu5_z_2 - 0.05680835589544868;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t4 - t8 + 2.521169842515734;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu4_x = c5*h5_y + s5*h5_x;
    const iiwa_real fu4_z_3 = s5*h5_y - c5*h5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_3 = 0.4*fu4_z_3 - (c5*k5_xz - s5*k5_yz);
    const iiwa_real nu4_z_3 = s5*k5_xz + c5*k5_yz + 0.4*neg_fu4_x;
    const iiwa_real t9 = -c4;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_3 = t9*neg_fu4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu3_x_2 = s4*m5_5 - c4*nu4_x_3;
    const iiwa_real nu3_z_3 = s4*nu4_x_3 + c4*m5_5;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3;
    const iiwa_real neg_fu2_z_2 = c3*fu4_z_3 - s3*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_3 = 0.4*neg_fu2_z_2 - (c3*neg_nu3_x_2 - s3*nu4_z_3);
    const iiwa_real nu2_z_3 = 0.4*fu2_x_3 - (s3*neg_nu3_x_2 + c3*nu4_z_3);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3;
    const iiwa_real t10 = c5*c5;
    const iiwa_real t11 = t4 + t8 - 1.7262407198899914;
    const iiwa_real t12 = c5*s5;
    const iiwa_real t13 = t10*t11 + k5_xy*(2.0*t12);
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_zz = k5_xx + t13;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h4_x = fu4_z_3 + 0.5168019281781282;
    const iiwa_real h4_y = fu5_x + 8.054835434921454;
    const iiwa_real t14 = k5_yy - t13;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xx = t14 + 0.24852411424661205;
    const iiwa_real t15 = k5_zz + 0.8*fu5_x;
    const iiwa_real k4_yy = t15 + 3.569490999313376;
    const iiwa_real k4_xy = -nu4_x_3 - 0.20921122087079386;
    const iiwa_real k4_xz = t11*t12 + k5_xy*(1.0 - 2.0*t10) - 0.013124222729483126;
    const iiwa_real k4_yz = 0.09675036990607108 - nu4_z_3;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t14 + t15 + 3.818015113559988;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_4 = s4*neg_h4_x - c4*h4_y;
    const iiwa_real fu3_z = t9*neg_h4_x - s4*h4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_2 = s4*k4_yz - c4*k4_xz;
    const iiwa_real nu3_z_4 = t9*k4_yz - s4*k4_xz;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_4 = c3*fu3_x_4;
    const iiwa_real fu2_z_2 = s3*fu3_x_4;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_4 = -0.4*fu2_z_2 - (-c3*nu3_x_2 - s3*m4_4);
    const iiwa_real nu2_z_4 = 0.4*fu2_x_4 - (c3*m4_4 - s3*nu3_x_2);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4;
    const iiwa_real t16 = c4*c4;
    const iiwa_real t17 = t14 - t15 - 3.3209668850667637;
    const iiwa_real t18 = c4*s4;
    const iiwa_real t19 = t16*t17 - k4_xy*(2.0*t18);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_zz = k4_xx - t19;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h3_x = fu3_z - 1.0168650139155704;
    const iiwa_real h3_y = neg_fu4_x - 0.04389618410240257;
    const iiwa_real t20 = k4_yy + t19;
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_xx = t20 + 0.20191091047133833;
    const iiwa_real k3_yy = k4_zz + 0.45257769458388303;
    const iiwa_real k3_xy = nu3_x_2 - 0.1005265342798281;
    const iiwa_real k3_xz = t17*t18 - k4_xy*(1.0 - 2.0*t16) + 0.16230144331072144;
    const iiwa_real k3_yz = nu3_z_4 - 0.06405373385272267;
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = k4_zz + t20 + 0.6544886050552213;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_5 = -s3*h3_x - c3*h3_y;
    const iiwa_real neg_fu2_z_3 = s3*h3_y - c3*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_5 = 0.4*neg_fu2_z_3 - (c3*k3_xz - s3*k3_yz);
    const iiwa_real nu2_z_5 = 0.4*fu2_x_5 - (s3*k3_xz + c3*k3_yz);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_5 = c2*m3_3 - s2*nu2_x_5;
    const iiwa_real t21 = c3*s3;
    const iiwa_real t22 = c3*c3;
    const iiwa_real t23 = t20 - k4_zz - 0.2506667841125447;
    const iiwa_real t24 = k3_xy*(2.0*t21) - t22*t23;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_zz = k3_xx + t24;
    const iiwa_real t25 = k3_zz - 0.8*fu3_x_4;
    const iiwa_real k2_yy = t25 + 4.238401785575742;
    const iiwa_real k2_xy = nu2_x_5 - 0.5218524991029152;
    const iiwa_real k2_xz = t23*t21 - k3_xy*(1.0 - 2.0*t22) - 0.20091837135316784;
    const iiwa_real k2_yz = nu2_z_5 + 0.26458063578324464;
    const iiwa_real t26 = t24 - k3_yy;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = 4.764988720880306 - (t26 - t25);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_6 = s2*k2_xz + c2*k2_yz;
    const iiwa_real t27 = k2_zz + (k2_yy - (c2*c2*(t26 + t25 + 3.711814850271177) +
        k2_xy*(2.0*(c2*s2))));
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = t27 + 0.8058116303302202;
    M[0] = m1_1;
    M[1] = nu1_z_6;
    M[2] = nu1_z_5;
    M[3] = nu1_z_4;
    M[4] = nu1_z_3;
    M[5] = nu1_z_2;
    M[6] = nu1_z;
    M[7] = nu1_z_6;
    M[8] = m2_2;
    M[9] = nu2_z_5;
    M[10] = nu2_z_4;
    M[11] = nu2_z_3;
    M[12] = nu2_z_2;
    M[13] = nu2_z;
    M[14] = nu1_z_5;
    M[15] = nu2_z_5;
    M[16] = m3_3;
    M[17] = nu3_z_4;
    M[18] = nu3_z_3;
    M[19] = nu3_z_2;
    M[20] = nu3_z;
    M[21] = nu1_z_4;
    M[22] = nu2_z_4;
    M[23] = nu3_z_4;
    M[24] = m4_4;
    M[25] = nu4_z_3;
    M[26] = nu4_z_2;
    M[27] = nu4_z;
    M[28] = nu1_z_3;
    M[29] = nu2_z_3;
    M[30] = nu3_z_3;
    M[31] = nu4_z_3;
    M[32] = m5_5;
    M[33] = nu5_z_2;
    M[34] = nu5_z;
    M[35] = nu1_z_2;
    M[36] = nu2_z_2;
    M[37] = nu3_z_2;
    M[38] = nu4_z_2;
    M[39] = nu5_z_2;
    M[40] = m6_6;
    M[41] = nu6_z;
    M[42] = nu1_z;
    M[43] = nu2_z;
    M[44] = nu3_z;
    M[45] = nu4_z;
    M[46] = nu5_z;
    M[47] = nu6_z;
    M[48] = 0.48318719298539553;
}

/* accelerations that the torques tau give
 * 597 multiplications, 517 additions, 7 divisions = 1121; 24 unary minus; 12 sine/cosine */
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
    /* link 6: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu6_x = 0.708306797966195*c7 + 0.9999503996366931*s7;
    const iiwa_real fu6_z = 0.9999503996366931*c7 - 0.708306797966195*s7;
    /* link 6: moment for a unit acceleration of a joint further out */
    const iiwa_real nu6_x = -0.126*fu6_z - (0.2024621683128357*c7 - 0.061680050398747424*s7);
    const iiwa_real nu6_z = -0.126*neg_fu6_x - (0.2024621683128357*s7 + 0.061680050398747424*c7);
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu5_x = c6*neg_fu6_x;
    const iiwa_real fu5_z = s6*neg_fu6_x;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x = c6*nu6_x + 0.48318719298539553*s6;
    const iiwa_real nu5_z = 0.48318719298539553*c6 - s6*nu6_x;
    const iiwa_real t1 = -c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x = t1*neg_fu5_x - s5*fu6_z;
    const iiwa_real fu4_z = s5*neg_fu5_x - c5*fu6_z;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x = 0.4*fu4_z - (s5*nu6_z - c5*nu5_x);
    const iiwa_real t2 = -s5;
    const iiwa_real nu4_z = t2*nu5_x - c5*nu6_z - 0.4*fu4_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x = c4*fu4_x - s4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu3_x = s4*nu5_z - c4*nu4_x;
    const iiwa_real nu3_z = s4*nu4_x + c4*nu5_z;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x = c3*fu3_x + s3*fu4_z;
    const iiwa_real neg_fu2_z = c3*fu4_z - s3*fu3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x = 0.4*neg_fu2_z - (c3*neg_nu3_x - s3*nu4_z);
    const iiwa_real nu2_z = 0.4*fu2_x - (s3*neg_nu3_x + c3*nu4_z);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z = c2*nu3_z - s2*nu2_x;
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h6_x = fu6_z - 1.5656307599463828;
    const iiwa_real t3 = c7*c7;
    const iiwa_real t4 = c7*s7;
    const iiwa_real t5 = 0.10136935104159488*t3 + 0.4228495651372064*t4;
    /* link 6: second moment of the composite body [kg m^2] */
    const iiwa_real k6_xx = 0.7162734907179903 - t5;
    const iiwa_real k6_xy = nu6_x - 0.36144292274665746;
    const iiwa_real k6_xz = 0.2114247825686032*(2.0*t3 - 1.0) - 0.10136935104159488*t4 -
        0.042925575293549574;
    const iiwa_real k6_yz = nu6_z + 0.0870114460092663;
    /* link 6: mass matrix, its row of this joint */
    const iiwa_real m6_6 = 2.745229884110378 - t5;
    /* link 5: force for a unit acceleration of a joint further out */
    const iiwa_real fu5_x = 1.291128497815195*c6 - s6*h6_x;
    const iiwa_real fu5_z_2 = -c6*h6_x - 1.291128497815195*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const iiwa_real nu5_x_2 = s6*k6_yz - c6*k6_xz;
    const iiwa_real nu5_z_2 = s6*k6_xz + c6*k6_yz;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real fu4_x_2 = c5*fu5_x;
    const iiwa_real fu4_z_2 = t2*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_2 = c5*nu5_x_2 - s5*m6_6 + 0.4*fu4_z_2;
    const iiwa_real nu4_z_2 = -0.4*fu4_x_2 - (s5*nu5_x_2 + c5*m6_6);
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_2 = c4*fu4_x_2 - s4*fu5_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x = c4*nu4_x_2 - s4*nu5_z_2;
    const iiwa_real nu3_z_2 = s4*nu4_x_2 + c4*nu5_z_2;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const iiwa_real fu2_z = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_2 = c3*nu3_x + s3*nu4_z_2 - 0.4*fu2_z;
    const iiwa_real nu2_z_2 = s3*nu3_x - c3*nu4_z_2 + 0.4*fu2_x_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_2 = c2*nu3_z_2 - s2*nu2_x_2;
    const iiwa_real t6 = c6*c6;
    const iiwa_real t7 = t5 + 1.3126829026743974;
    const iiwa_real t8 = c6*s6;
    const iiwa_real t9 = t6*t7 + k6_xy*(2.0*t8);
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_zz = k6_xx + t9;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h5_x = -fu5_z_2 - 0.25252954507510866;
    const iiwa_real h5_y = neg_fu6_x + 0.4193059538543958;
    /* link 5: second moment of the composite body [kg m^2] */
    const iiwa_real k5_xx = 2.1237052812028625 - t9;
    const iiwa_real k5_yy = t5 + 0.39746456131287133;
    const iiwa_real k5_xy = -nu5_x_2 - 0.03284626166448073;
    const iiwa_real k5_xz = t7*t8 + k6_xy*(1.0 - 2.0*t6) - 0.041147842218669614;
    const iiwa_real k5_yz = -nu5_z_2 - 0.05680835589544868;
    /* link 5: mass matrix, its row of this joint */
    const iiwa_real m5_5 = t5 - t9 + 2.521169842515734;
    /* link 4: force for a unit acceleration of a joint further out */
    const iiwa_real neg_fu4_x = c5*h5_y + s5*h5_x;
    const iiwa_real fu4_z_3 = s5*h5_y - c5*h5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const iiwa_real nu4_x_3 = 0.4*fu4_z_3 - (c5*k5_xz - s5*k5_yz);
    const iiwa_real nu4_z_3 = s5*k5_xz + c5*k5_yz + 0.4*neg_fu4_x;
    const iiwa_real t10 = -c4;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_3 = t10*neg_fu4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real neg_nu3_x_2 = s4*m5_5 - c4*nu4_x_3;
    const iiwa_real nu3_z_3 = s4*nu4_x_3 + c4*m5_5;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_3 = c3*fu3_x_3 + s3*fu4_z_3;
    const iiwa_real neg_fu2_z_2 = c3*fu4_z_3 - s3*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_3 = 0.4*neg_fu2_z_2 - (c3*neg_nu3_x_2 - s3*nu4_z_3);
    const iiwa_real nu2_z_3 = 0.4*fu2_x_3 - (s3*neg_nu3_x_2 + c3*nu4_z_3);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_3 = c2*nu3_z_3 - s2*nu2_x_3;
    const iiwa_real t11 = c5*c5;
    const iiwa_real t12 = t5 + t9 - 1.7262407198899914;
    const iiwa_real t13 = c5*s5;
    const iiwa_real t14 = t11*t12 + k5_xy*(2.0*t13);
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_zz = k5_xx + t14;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real neg_h4_x = fu4_z_3 + 0.5168019281781282;
    const iiwa_real h4_y = fu5_x + 8.054835434921454;
    const iiwa_real t15 = k5_yy - t14;
    /* link 4: second moment of the composite body [kg m^2] */
    const iiwa_real k4_xx = t15 + 0.24852411424661205;
    const iiwa_real t16 = k5_zz + 0.8*fu5_x;
    const iiwa_real k4_yy = t16 + 3.569490999313376;
    const iiwa_real k4_xy = -nu4_x_3 - 0.20921122087079386;
    const iiwa_real k4_xz = t12*t13 + k5_xy*(1.0 - 2.0*t11) - 0.013124222729483126;
    const iiwa_real k4_yz = 0.09675036990607108 - nu4_z_3;
    /* link 4: mass matrix, its row of this joint */
    const iiwa_real m4_4 = t15 + t16 + 3.818015113559988;
    /* link 3: force for a unit acceleration of a joint further out */
    const iiwa_real fu3_x_4 = s4*neg_h4_x - c4*h4_y;
    const iiwa_real fu3_z = t10*neg_h4_x - s4*h4_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const iiwa_real nu3_x_2 = s4*k4_yz - c4*k4_xz;
    const iiwa_real nu3_z_4 = t10*k4_yz - s4*k4_xz;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_4 = c3*fu3_x_4;
    const iiwa_real fu2_z_2 = s3*fu3_x_4;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_4 = -0.4*fu2_z_2 - (-c3*nu3_x_2 - s3*m4_4);
    const iiwa_real nu2_z_4 = 0.4*fu2_x_4 - (c3*m4_4 - s3*nu3_x_2);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_4 = c2*nu3_z_4 - s2*nu2_x_4;
    const iiwa_real t17 = c4*c4;
    const iiwa_real t18 = t15 - t16 - 3.3209668850667637;
    const iiwa_real t19 = c4*s4;
    const iiwa_real t20 = t17*t18 - k4_xy*(2.0*t19);
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_zz = k4_xx - t20;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const iiwa_real h3_x = fu3_z - 1.0168650139155704;
    const iiwa_real h3_y = neg_fu4_x - 0.04389618410240257;
    const iiwa_real t21 = k4_yy + t20;
    /* link 3: second moment of the composite body [kg m^2] */
    const iiwa_real k3_xx = t21 + 0.20191091047133833;
    const iiwa_real k3_yy = k4_zz + 0.45257769458388303;
    const iiwa_real k3_xy = nu3_x_2 - 0.1005265342798281;
    const iiwa_real k3_xz = t18*t19 - k4_xy*(1.0 - 2.0*t17) + 0.16230144331072144;
    const iiwa_real k3_yz = nu3_z_4 - 0.06405373385272267;
    /* link 3: mass matrix, its row of this joint */
    const iiwa_real m3_3 = k4_zz + t21 + 0.6544886050552213;
    const iiwa_real t22 = -s3;
    /* link 2: force for a unit acceleration of a joint further out */
    const iiwa_real fu2_x_5 = t22*h3_x - c3*h3_y;
    const iiwa_real neg_fu2_z_3 = s3*h3_y - c3*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const iiwa_real nu2_x_5 = 0.4*neg_fu2_z_3 - (c3*k3_xz - s3*k3_yz);
    const iiwa_real nu2_z_5 = 0.4*fu2_x_5 - (s3*k3_xz + c3*k3_yz);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_5 = c2*m3_3 - s2*nu2_x_5;
    const iiwa_real t23 = c3*s3;
    const iiwa_real t24 = c3*c3;
    const iiwa_real t25 = t21 - k4_zz - 0.2506667841125447;
    const iiwa_real t26 = k3_xy*(2.0*t23) - t24*t25;
    /* link 2: second moment of the composite body [kg m^2] */
    const iiwa_real k2_zz = k3_xx + t26;
    const iiwa_real t27 = k3_zz - 0.8*fu3_x_4;
    const iiwa_real k2_yy = t27 + 4.238401785575742;
    const iiwa_real k2_xy = nu2_x_5 - 0.5218524991029152;
    const iiwa_real k2_xz = t25*t23 - k3_xy*(1.0 - 2.0*t24) - 0.20091837135316784;
    const iiwa_real k2_yz = nu2_z_5 + 0.26458063578324464;
    const iiwa_real t28 = t26 - k3_yy;
    /* link 2: mass matrix, its row of this joint */
    const iiwa_real m2_2 = 4.764988720880306 - (t28 - t27);
    /* link 1: moment for a unit acceleration of a joint further out */
    const iiwa_real nu1_z_6 = s2*k2_xz + c2*k2_yz;
    const iiwa_real t29 = k2_zz + (k2_yy - (c2*c2*(t28 + t27 + 3.711814850271177) +
        k2_xy*(2.0*(c2*s2))));
    /* link 1: mass matrix, its row of this joint */
    const iiwa_real m1_1 = t29 + 0.8058116303302202;
    const iiwa_real t30 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const iiwa_real w2_x = t30*s2;
    const iiwa_real w2_y = t30*c2;
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a2_x = -9.81*s2;
    const iiwa_real a2_y = -9.81*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const iiwa_real alpha2_x = qd[1]*w2_y;
    const iiwa_real alpha2_y = -qd[1]*w2_x;
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
    const iiwa_real a3_z = -0.4*neg_lam2_22 - a2_y;
    /* link 3: angular velocity [rad/s] */
    const iiwa_real w3_x = c3*w2_x + qd[1]*s3;
    const iiwa_real w3_y = qd[1]*c3 - s3*w2_x;
    const iiwa_real t31 = -0.8*alpha2_x;
    const iiwa_real t32 = 0.4*ww2_xy - a2_x;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a3_x = s3*t31 - c3*t32;
    const iiwa_real a3_y = s3*t32 + c3*t31;
    /* link 3: angular acceleration [rad/s^2] */
    const iiwa_real alpha3_x = c3*alpha2_x + qd[2]*w3_y;
    const iiwa_real alpha3_y = t22*alpha2_x - qd[2]*w3_x;
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
    const iiwa_real lam3_12 = alpha2_y + ww3_xy;
    const iiwa_real lam3_13 = alpha3_y + ww3_zx;
    const iiwa_real lam3_21 = ww3_xy - alpha2_y;
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
    const iiwa_real alpha4_x = qd[3]*w4_y - (s4*alpha2_y - c4*alpha3_x);
    const iiwa_real alpha4_y = -s4*alpha3_x - c4*alpha2_y - qd[3]*w4_x;
    /* link 4: angular velocity [rad/s] */
    const iiwa_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const iiwa_real ww4_yz = w4_y*w4_z;
    const iiwa_real ww4_zx = w4_x*w4_z;
    const iiwa_real ww4_xy = w4_x*w4_y;
    const iiwa_real neg_ww4_xx = -w4_x*w4_x;
    const iiwa_real ww4_yy = w4_y*w4_y;
    const iiwa_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const iiwa_real neg_lam4_11 = ww4_yy + ww4_zz;
    const iiwa_real lam4_12 = alpha3_y + ww4_xy;
    const iiwa_real lam4_13 = alpha4_y + ww4_zx;
    const iiwa_real lam4_21 = ww4_xy - alpha3_y;
    const iiwa_real lam4_22 = neg_ww4_xx - ww4_zz;
    const iiwa_real lam4_23 = ww4_yz - alpha4_x;
    const iiwa_real lam4_31 = ww4_zx - alpha4_y;
    const iiwa_real lam4_32 = alpha4_x + ww4_yz;
    const iiwa_real lam4_33 = neg_ww4_xx - ww4_yy;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_z = a4_y + 0.4*lam4_22;
    /* link 5: angular velocity [rad/s] */
    const iiwa_real w5_x = c5*w4_x - s5*w4_z;
    const iiwa_real w5_y = t2*w4_x - c5*w4_z;
    const iiwa_real t33 = a3_y - 0.4*lam4_32;
    const iiwa_real t34 = -0.4*lam4_12 - a4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a5_x = s5*t33 - c5*t34;
    const iiwa_real a5_y = s5*t34 + c5*t33;
    /* link 5: angular acceleration [rad/s^2] */
    const iiwa_real alpha5_x = qd[4]*w5_y - (t1*alpha4_x - s5*alpha3_y);
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
    const iiwa_real t35 = -s6;
    const iiwa_real w6_y = t35*w5_x - c6*w5_z;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real neg_a6_x = s6*a5_z - c6*a5_x;
    const iiwa_real a6_y = t35*a5_x - c6*a5_z;
    /* link 6: angular acceleration [rad/s^2] */
    const iiwa_real alpha6_x = qd[5]*w6_y - (s6*alpha4_y - c6*alpha5_x);
    const iiwa_real alpha6_y = t35*alpha5_x - c6*alpha4_y - qd[5]*w6_x;
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
    const iiwa_real t36 = a5_y - 0.126*lam6_32;
    const iiwa_real t37 = neg_a6_x + 0.126*lam6_12;
    /* link 7: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const iiwa_real a7_x = s7*t36 - c7*t37;
    const iiwa_real a7_y = s7*t37 + c7*t36;
    /* link 7: angular acceleration [rad/s^2] */
    const iiwa_real alpha7_x = qd[6]*w7_y - (-c7*alpha6_x - s7*alpha5_y);
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
    const iiwa_real nc2_x = 1.0437049982058304*alpha2_y + 0.20091837135316784*ww2_xy -
        (-8.476803571151484*alpha2_x - 0.26458063578324464*(neg_lam2_22 - neg_lam2_33));
    const iiwa_real nc2_y = 1.0531738706091291*alpha2_y + 0.20091837135316784*(neg_lam2_11 -
        neg_lam2_33) + (0.26458063578324464*ww2_xy + 1.0437049982058304*alpha2_x);
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
    const iiwa_real t38 = 0.45257769458388303*lam3_12 - 0.20191091047133833*lam3_21 +
        0.1005265342798281*(neg_lam3_11 - neg_lam3_22) - (0.16230144331072144*lam3_23 +
        0.06405373385272267*lam3_13);
    const iiwa_real neg_nc3_z = t38 + (1.0168650139155704*a3_y - 0.04389618410240257*a3_x);
    /* link 4: force that moves the link [N] */
    const iiwa_real fc4_x = 0.5168019281781282*neg_lam4_11 + 8.054835434921454*lam4_12;
    const iiwa_real fc4_y = 8.054835434921454*lam4_22 - 0.5168019281781282*lam4_21;
    const iiwa_real fc4_z = 8.054835434921454*lam4_32 - 0.5168019281781282*lam4_31;
    /* link 4: moment that turns the link [N m] */
    const iiwa_real neg_nc4_x = -3.569490999313376*lam4_32 - 0.09675036990607108*(lam4_33 - lam4_22)
        - (0.013124222729483126*lam4_21 - 0.20921122087079386*lam4_31) + 8.054835434921454*a3_y;
    const iiwa_real nc4_y = 0.013124222729483126*(neg_lam4_11 + lam4_33) -
        0.24852411424661205*lam4_31 + (0.09675036990607108*lam4_12 + 0.20921122087079386*lam4_32) -
        0.5168019281781282*a3_y;
    const iiwa_real t39 = 3.569490999313376*lam4_12 - 0.24852411424661205*lam4_21 +
        0.20921122087079386*(neg_lam4_11 + lam4_22) + (0.013124222729483126*lam4_23 +
        0.09675036990607108*lam4_13);
    const iiwa_real neg_nc4_z = t39 + (0.5168019281781282*a4_y + 8.054835434921454*a4_x);
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
    const iiwa_real t40 = 0.09474888781047501*lam5_21 - 0.20655564034097101*lam5_12 -
        0.03284626166448073*(neg_lam5_11 - neg_lam5_22) - (0.041147842218669614*lam5_23 -
        0.05680835589544868*lam5_13);
    const iiwa_real nc5_z = t40 - (0.25252954507510866*a5_y + 0.4193059538543958*a5_x);
    /* link 6: force that moves the link [N] */
    const iiwa_real fc6_x = 1.5656307599463828*neg_lam6_11 - 1.291128497815195*lam6_12;
    const iiwa_real fc6_y = 1.291128497815195*neg_lam6_22 - 1.5656307599463828*lam6_21;
    const iiwa_real fc6_z = -1.5656307599463828*lam6_31 - 1.291128497815195*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const iiwa_real neg_nc6_x = -2.0289563933923875*lam6_32 - 0.0870114460092663*(neg_lam6_22 -
        neg_lam6_33) - (0.042925575293549574*lam6_21 - 0.36144292274665746*lam6_31) +
        1.291128497815195*a5_y;
    const iiwa_real nc6_y = 0.042925575293549574*(neg_lam6_11 - neg_lam6_33) -
        0.4239952187044951*lam6_31 - (-0.0870114460092663*lam6_12 - 0.36144292274665746*lam6_32) +
        1.5656307599463828*a5_y;
    const iiwa_real t41 = 0.4239952187044951*lam6_21 - 2.0289563933923875*lam6_12 -
        0.36144292274665746*(neg_lam6_11 - neg_lam6_22) - (0.042925575293549574*lam6_23 +
        0.0870114460092663*lam6_13);
    const iiwa_real nc6_z = t41 - (1.5656307599463828*a6_y + 1.291128497815195*neg_a6_x);
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
    const iiwa_real t42 = 0.2922782720134952*lam7_12 - 0.19090892097190032*lam7_21 -
        0.2114247825686032*(neg_lam7_11 - neg_lam7_22) - (0.2024621683128357*lam7_23 -
        0.061680050398747424*lam7_13);
    const iiwa_real nc7_z = 0.9999503996366931*a7_y - 0.708306797966195*a7_x - t42;
    /* link 7: force through the joint, along the axes that its turn starts from [N] */
    const iiwa_real f07_x = c7*fc7_x - s7*fc7_y;
    const iiwa_real neg_f07_y = -s7*fc7_x - c7*fc7_y;
    /* link 7: moment through the joint, along the axes that its turn starts from [N m] */
    const iiwa_real n07_x = c7*nc7_x - s7*nc7_y;
    const iiwa_real n07_y = s7*nc7_x + c7*nc7_y;
    /* link 6: moment through the joint, about the frame's origin [N m] */
    const iiwa_real n6_x = n07_x + (0.126*neg_f07_y - neg_nc6_x);
    const iiwa_real n6_y = nc6_y - nc7_z;
    const iiwa_real n6_z = n07_y + (nc6_z + 0.126*f07_x);
    /* link 6: force through the joint [N] */
    const iiwa_real f6_x = fc6_x + f07_x;
    const iiwa_real f6_y = fc6_y - fc7_z;
    const iiwa_real f6_z = fc6_z - neg_f07_y;
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
    const iiwa_real ipivot1 = 1.0 / m1_1;
    const iiwa_real l2_1 = nu1_z_6*ipivot1;
    const iiwa_real l3_1 = nu1_z_5*ipivot1;
    const iiwa_real l4_1 = nu1_z_4*ipivot1;
    const iiwa_real l5_1 = nu1_z_3*ipivot1;
    const iiwa_real l6_1 = nu1_z_2*ipivot1;
    const iiwa_real l7_1 = nu1_z*ipivot1;
    const iiwa_real pivot2 = m2_2 - nu1_z_6*l2_1;
    const iiwa_real ipivot2 = 1.0 / pivot2;
    const iiwa_real ld3_2 = nu2_z_5 - nu1_z_6*l3_1;
    const iiwa_real l3_2 = ipivot2*ld3_2;
    const iiwa_real ld4_2 = nu2_z_4 - nu1_z_6*l4_1;
    const iiwa_real l4_2 = ipivot2*ld4_2;
    const iiwa_real ld5_2 = nu2_z_3 - nu1_z_6*l5_1;
    const iiwa_real l5_2 = ipivot2*ld5_2;
    const iiwa_real ld6_2 = nu2_z_2 - nu1_z_6*l6_1;
    const iiwa_real l6_2 = ipivot2*ld6_2;
    const iiwa_real ld7_2 = nu2_z - nu1_z_6*l7_1;
    const iiwa_real l7_2 = ipivot2*ld7_2;
    const iiwa_real pivot3 = m3_3 - nu1_z_5*l3_1 - ld3_2*l3_2;
    const iiwa_real ipivot3 = 1.0 / pivot3;
    const iiwa_real ld4_3 = nu3_z_4 - nu1_z_5*l4_1 - ld3_2*l4_2;
    const iiwa_real l4_3 = ipivot3*ld4_3;
    const iiwa_real ld5_3 = nu3_z_3 - nu1_z_5*l5_1 - ld3_2*l5_2;
    const iiwa_real l5_3 = ipivot3*ld5_3;
    const iiwa_real ld6_3 = nu3_z_2 - nu1_z_5*l6_1 - ld3_2*l6_2;
    const iiwa_real l6_3 = ipivot3*ld6_3;
    const iiwa_real ld7_3 = nu3_z - nu1_z_5*l7_1 - ld3_2*l7_2;
    const iiwa_real l7_3 = ipivot3*ld7_3;
    const iiwa_real pivot4 = m4_4 - nu1_z_4*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const iiwa_real ipivot4 = 1.0 / pivot4;
    const iiwa_real ld5_4 = nu4_z_3 - nu1_z_4*l5_1 - ld4_2*l5_2 - ld4_3*l5_3;
    const iiwa_real l5_4 = ipivot4*ld5_4;
    const iiwa_real ld6_4 = -(nu1_z_4*l6_1 - nu4_z_2 + ld4_2*l6_2) - ld4_3*l6_3;
    const iiwa_real l6_4 = ipivot4*ld6_4;
    const iiwa_real ld7_4 = nu4_z - nu1_z_4*l7_1 - ld4_2*l7_2 - ld4_3*l7_3;
    const iiwa_real l7_4 = ipivot4*ld7_4;
    const iiwa_real pivot5 = m5_5 - nu1_z_3*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const iiwa_real ipivot5 = 1.0 / pivot5;
    const iiwa_real ld6_5 = -ld5_4*l6_4 - (nu1_z_3*l6_1 - nu5_z_2 + ld5_2*l6_2 + ld5_3*l6_3);
    const iiwa_real l6_5 = ipivot5*ld6_5;
    const iiwa_real ld7_5 = nu5_z - nu1_z_3*l7_1 - ld5_2*l7_2 - ld5_3*l7_3 - ld5_4*l7_4;
    const iiwa_real l7_5 = ipivot5*ld7_5;
    const iiwa_real pivot6 = -(ld6_2*l6_2 - (m6_6 - nu1_z_2*l6_1) + ld6_3*l6_3 + ld6_4*l6_4) -
        ld6_5*l6_5;
    const iiwa_real ipivot6 = 1.0 / pivot6;
    const iiwa_real ld7_6 = -ld6_5*l7_5 - (nu1_z_2*l7_1 - nu6_z + ld6_2*l7_2 + ld6_3*l7_3 +
        ld6_4*l7_4);
    const iiwa_real l7_6 = ipivot6*ld7_6;
    const iiwa_real t43 = 0.48318719298539553 - nu1_z*l7_1 - ld7_2*l7_2 - ld7_3*l7_3 - ld7_4*l7_4 -
        ld7_5*l7_5;
    const iiwa_real pivot7 = t43 - ld7_6*l7_6;
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
    const iiwa_real t44 = tau[6] - nc7_z - y1*l7_1 - l7_2*y2 - l7_3*y3 - l7_4*y4 - l7_5*y5;
    /* link 7: forward substitution */
    const iiwa_real y7 = t44 - l7_6*y6;
    /* link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd7 = ipivot7*y7;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd6 = ipivot6*y6 - l7_6*qdd7;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd5 = ipivot5*y5 - l6_5*qdd6 - l7_5*qdd7;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6 - l7_4*qdd7;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd3 = -(l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5 + l6_3*qdd6) - l7_3*qdd7;
    const iiwa_real t45 = -(l3_2*qdd3 - ipivot2*y2 + l4_2*qdd4 + l5_2*qdd5 + l6_2*qdd6);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd2 = t45 - l7_2*qdd7;
    const iiwa_real t46 = l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5 + l6_1*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const iiwa_real qdd1 = -l7_1*qdd7 - t46;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
    qdd[6] = qdd7;
}
