/*
 * puma560_full: PUMA 560 geometry, random full inertias
 * Numbers: Table 2.1 geometry; masses, centres and inertias drawn at random: a test of generic
 *   parameters
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
 *   inverse_dynamics: 262 multiplications, 243 additions = 505; 5 unary minus; 10 sine/cosine
 *   gravity: 42 multiplications, 25 additions = 67; 0 unary minus; 10 sine/cosine
 *   bias: 244 multiplications, 211 additions = 455; 8 unary minus; 10 sine/cosine
 *   mass_matrix: 141 multiplications, 125 additions = 266; 3 unary minus; 10 sine/cosine
 *   forward_dynamics: 469 multiplications, 406 additions, 6 divisions = 881; 15 unary minus; 10
 *       sine/cosine
 */
#include "puma560_full.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 262 multiplications, 243 additions = 505; 5 unary minus; 10 sine/cosine */
void puma560_full_inverse_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real qdd[6],
    puma560_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    const volatile puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_z = qdd[1] + qdd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a2_z = 0.1501*ww1_zz;
    const puma560_full_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_full_real w2_x = t1*s2;
    const puma560_full_real w2_y = t1*c2;
    const puma560_full_real t2 = 0.1501*qdd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a2_x = c2*t2 + 9.8*s2;
    const puma560_full_real a2_y = s2*t2 - 9.8*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_yz = qd[1]*w2_y;
    const puma560_full_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_full_real alpha2_x = ww2_yz - qdd[0]*s2;
    const puma560_full_real neg_alpha2_y = qdd[0]*c2 + ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_xy = w2_x*w2_y;
    const puma560_full_real ww2_xx = w2_x*w2_x;
    const puma560_full_real ww2_yy = w2_y*w2_y;
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_full_real lam2_12 = ww2_xy - qdd[1];
    const puma560_full_real lam2_13 = ww2_zx - neg_alpha2_y;
    const puma560_full_real lam2_21 = qdd[1] + ww2_xy;
    const puma560_full_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_full_real lam2_23 = ww2_yz - alpha2_x;
    const puma560_full_real lam2_31 = ww2_zx + neg_alpha2_y;
    const puma560_full_real lam2_32 = ww2_yz + alpha2_x;
    const puma560_full_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a3_z = 0.4318*lam2_31 - neg_a2_z;
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_x = t1*s23;
    const puma560_full_real w3_y = t1*c23;
    const puma560_full_real t3 = 0.4318*neg_lam2_11;
    const puma560_full_real t4 = 0.4318*lam2_21;
    const puma560_full_real t5 = t2 + (c2*t3 + s2*t4);
    const puma560_full_real t6 = s2*t3 - c2*t4 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a3_x = c23*t5 + s23*t6;
    const puma560_full_real a3_y = s23*t5 - c23*t6;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_yz = w3_z*w3_y;
    const puma560_full_real ww3_zx = w3_z*w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_x = ww3_yz - qdd[0]*s23;
    const puma560_full_real neg_alpha3_y = qdd[0]*c23 + ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_xy = w3_x*w3_y;
    const puma560_full_real ww3_xx = w3_x*w3_x;
    const puma560_full_real ww3_yy = w3_y*w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real lam3_12 = ww3_xy - alpha3_z;
    const puma560_full_real lam3_13 = ww3_zx - neg_alpha3_y;
    const puma560_full_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_full_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_full_real lam3_23 = ww3_yz - alpha3_x;
    const puma560_full_real lam3_31 = ww3_zx + neg_alpha3_y;
    const puma560_full_real lam3_32 = ww3_yz + alpha3_x;
    const puma560_full_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*lam3_21 - 0.4331*neg_lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t7 = a3_z + (-0.0203*lam3_31 - 0.4331*lam3_32);
    const puma560_full_real t8 = neg_a3_x + (0.4331*lam3_12 - 0.0203*neg_lam3_11);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_x = s4*t7 - c4*t8;
    const puma560_full_real a4_y = s4*t8 + c4*t7;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = qd[3]*w4_y - (-s4*alpha3_z - c4*alpha3_x);
    const puma560_full_real alpha4_y = c4*alpha3_z - s4*alpha3_x - qd[3]*w4_x;
    const puma560_full_real alpha4_z = qdd[3] + neg_alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real ww4_yz = w4_y*w4_z;
    const puma560_full_real ww4_zx = w4_x*w4_z;
    const puma560_full_real ww4_xy = w4_x*w4_y;
    const puma560_full_real ww4_xx = w4_x*w4_x;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const puma560_full_real lam4_12 = ww4_xy - alpha4_z;
    const puma560_full_real lam4_13 = alpha4_y + ww4_zx;
    const puma560_full_real lam4_21 = alpha4_z + ww4_xy;
    const puma560_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const puma560_full_real lam4_23 = ww4_yz - alpha4_x;
    const puma560_full_real lam4_31 = ww4_zx - alpha4_y;
    const puma560_full_real lam4_32 = alpha4_x + ww4_yz;
    const puma560_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_full_real t9 = -c5;
    const puma560_full_real w5_y = t9*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = c5*a4_x - s5*a4_z;
    const puma560_full_real a5_y = t9*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const puma560_full_real alpha5_y = t9*alpha4_z - s5*alpha4_x - qd[4]*w5_x;
    const puma560_full_real alpha5_z = qdd[4] + alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real ww5_yz = w5_y*w5_z;
    const puma560_full_real ww5_zx = w5_x*w5_z;
    const puma560_full_real ww5_xy = w5_x*w5_y;
    const puma560_full_real ww5_xx = w5_x*w5_x;
    const puma560_full_real ww5_yy = w5_y*w5_y;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const puma560_full_real lam5_12 = ww5_xy - alpha5_z;
    const puma560_full_real lam5_13 = alpha5_y + ww5_zx;
    const puma560_full_real lam5_21 = alpha5_z + ww5_xy;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real lam5_23 = ww5_yz - alpha5_x;
    const puma560_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (-s6*alpha5_z - c6*alpha5_x);
    const puma560_full_real alpha6_y = c6*alpha5_z - s6*alpha5_x - qd[5]*w6_x;
    const puma560_full_real alpha6_z = qdd[5] - alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_yz = w6_y*w6_z;
    const puma560_full_real ww6_zx = w6_x*w6_z;
    const puma560_full_real ww6_xy = w6_x*w6_y;
    const puma560_full_real ww6_xx = w6_x*w6_x;
    const puma560_full_real ww6_yy = w6_y*w6_y;
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const puma560_full_real lam6_12 = ww6_xy - alpha6_z;
    const puma560_full_real lam6_13 = alpha6_y + ww6_zx;
    const puma560_full_real lam6_21 = alpha6_z + ww6_xy;
    const puma560_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const puma560_full_real lam6_23 = ww6_yz - alpha6_x;
    const puma560_full_real neg_lam6_31 = alpha6_y - ww6_zx;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 1: moment that turns the link [N m] */
    const puma560_full_real nc1_z = 2.629303206180387*qdd[0];
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*lam2_12 - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*lam2_21 - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real nc2_x = -0.024117256252913073*ww1_zz - (-0.20730445403579364*lam2_32 -
        0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.017097472943757824*lam2_21 -
        0.1174059800416141*lam2_31));
    const puma560_full_real nc2_y = -3.522577799201274*lam2_31 - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) - (0.1174059800416141*lam2_32 - 0.0507946745483177*lam2_12) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real t10 = 3.522577799201274*lam2_21 - 0.20730445403579364*lam2_12 +
        0.1174059800416141*(neg_lam2_11 - neg_lam2_22) - (0.0507946745483177*lam2_13 -
        0.017097472943757824*lam2_23);
    const puma560_full_real nc2_z = t10 + (7.6631781603519995*a2_y + 0.1606745919581151*neg_a2_x);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = -1.046378600789203*neg_lam3_11 - 5.729293810689829*lam3_12;
    const puma560_full_real fc3_y = 1.046378600789203*lam3_21 + 5.729293810689829*neg_lam3_22;
    const puma560_full_real fc3_z = 1.046378600789203*lam3_31 - 5.729293810689829*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-3.4805327967608957*lam3_32 -
        0.060845712710754084*(neg_lam3_22 - neg_lam3_33) + (0.01894848286257894*lam3_21 -
        0.28615890025504537*lam3_31));
    const puma560_full_real nc3_y = -0.47176417886368593*lam3_31 - 0.01894848286257894*(neg_lam3_11
        - neg_lam3_33) - (0.28615890025504537*lam3_32 - 0.060845712710754084*lam3_12) -
        1.046378600789203*a3_z;
    const puma560_full_real t11 = 0.47176417886368593*lam3_21 - 3.4805327967608957*lam3_12 +
        0.28615890025504537*(neg_lam3_11 - neg_lam3_22) - (0.060845712710754084*lam3_13 -
        0.01894848286257894*lam3_23);
    const puma560_full_real nc3_z = t11 + (1.046378600789203*a3_y - 5.729293810689829*neg_a3_x);
    /* link 4: force that moves the link [N] */
    const puma560_full_real fc4_x = 0.8719880516308344*lam4_12 - 0.7777930398944852*neg_lam4_11;
    const puma560_full_real fc4_y = 0.7777930398944852*lam4_21 - 0.8719880516308344*neg_lam4_22;
    const puma560_full_real fc4_z = 0.7777930398944852*lam4_31 + 0.8719880516308344*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const puma560_full_real nc4_x = 0.8719880516308344*a4_z - (-0.2788425785236688*lam4_32 -
        0.10734691974802549*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096*lam4_21 -
        0.05337162017689789*lam4_31));
    const puma560_full_real nc4_y = -0.3473260245772809*lam4_31 - 0.2837491060266096*(neg_lam4_11 -
        neg_lam4_33) - (0.05337162017689789*lam4_32 - 0.10734691974802549*lam4_12) -
        0.7777930398944852*a4_z;
    const puma560_full_real t12 = 0.3473260245772809*lam4_21 - 0.2788425785236688*lam4_12 +
        0.05337162017689789*(neg_lam4_11 - neg_lam4_22) + (0.2837491060266096*lam4_23 -
        0.10734691974802549*lam4_13);
    const puma560_full_real nc4_z = t12 + (0.7777930398944852*a4_y - 0.8719880516308344*a4_x);
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = 0.47660058733283606*neg_lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (0.08058935149735619*neg_lam5_31 - 0.1558184212675505*lam5_21)
        + 0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1513642331069161*neg_lam5_31 + 0.1558184212675505*(neg_lam5_11
        - neg_lam5_33) + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t13 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 -
        0.08058935149735619*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t13 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.1185374890947408*neg_lam6_31 + 1.2975168001325401*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (0.4019452224328564*neg_lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = 0.4714480390546099*neg_lam6_31 - 0.1902613160848803*(neg_lam6_11
        - neg_lam6_33) + (0.4019452224328564*lam6_32 - 0.2519035474197792*lam6_12) -
        1.1185374890947408*a5_y;
    const puma560_full_real t14 = 0.4714480390546099*lam6_21 - 0.43637196239865417*lam6_12 -
        0.4019452224328564*(neg_lam6_11 - neg_lam6_22) + (0.1902613160848803*lam6_23 +
        0.2519035474197792*lam6_13);
    const puma560_full_real nc6_z = t14 - (1.1185374890947408*a6_y + 1.2975168001325401*a6_x);
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const puma560_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_x = n06_x - neg_nc5_x;
    const puma560_full_real n5_y = nc5_y - nc6_z;
    const puma560_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const puma560_full_real f5_x = fc5_x + f06_x;
    const puma560_full_real f5_y = fc5_y - fc6_z;
    const puma560_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f05_x = c5*f5_x - s5*f5_y;
    const puma560_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_x = nc4_x + n05_x;
    const puma560_full_real n4_y = nc4_y + n5_z;
    const puma560_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const puma560_full_real f4_x = fc4_x + f05_x;
    const puma560_full_real f4_y = fc4_y + f5_z;
    const puma560_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f04_x = c4*f4_x - s4*f4_y;
    const puma560_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_x = n04_x + (nc3_x - 0.4331*f04_y);
    const puma560_full_real n3_y = nc3_y + 0.0203*f04_y - n4_z;
    const puma560_full_real n3_z = n04_y + (nc3_z - (-0.4331*f04_x - 0.0203*f4_z));
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x + f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    const puma560_full_real t15 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + f3_z*t15);
    const puma560_full_real n02_z = n3_z + (nc2_z - (f03_x*(0.4318*s2) - f03_y*t15));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f02_x = f03_x - (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = nc1_z - 0.1501*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 42 multiplications, 25 additions = 67; 0 unary minus; 10 sine/cosine */
void puma560_full_gravity(const puma560_full_real q[6], puma560_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    const volatile puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a3_x = 9.8*s23;
    const puma560_full_real neg_a3_y = 9.8*c23;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a4_x = c4*neg_a3_x;
    const puma560_full_real a4_y = s4*neg_a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a5_x = c5*neg_a4_x + s5*neg_a3_y;
    const puma560_full_real neg_a5_y = c5*neg_a3_y - s5*neg_a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = s6*a4_y - c6*neg_a5_x;
    const puma560_full_real a6_y = s6*neg_a5_x + c6*a4_y;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real nc2_z = 1.5746110011895278*s2 - 75.09914597144959*c2;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real neg_nc3_z = 10.254510287734192*c23 + 56.14707934476033*s23;
    /* link 4: moment that turns the link [N m] */
    const puma560_full_real nc4_x = 8.545482905982176*c23;
    const puma560_full_real neg_nc4_y = 7.622371790965955*c23;
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y + 0.8719880516308344*neg_a4_x;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.47660058733283606*a4_y;
    const puma560_full_real nc5_z = 0.47660058733283606*neg_a5_y - 0.15165250821211493*neg_a5_x;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = 1.2975168001325401*neg_a5_y;
    const puma560_full_real nc6_y = 1.1185374890947408*neg_a5_y;
    const puma560_full_real nc6_z = -1.2975168001325401*a6_x - 1.1185374890947408*a6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real neg_n5_x = neg_nc5_x - n06_x;
    const puma560_full_real n5_y = nc5_y - nc6_z;
    const puma560_full_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real neg_n05_x = c5*neg_n5_x + s5*n5_y;
    const puma560_full_real n05_y = c5*n5_y - s5*neg_n5_x;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_x = nc4_x - neg_n05_x;
    const puma560_full_real neg_n4_y = neg_nc4_y - n5_z;
    const puma560_full_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x + s4*neg_n4_y;
    const puma560_full_real n04_y = s4*n4_x - c4*neg_n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_z = n04_y - neg_nc3_z;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real neg_n03_y = c23*n4_z - s23*n04_x;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_z = nc2_z + n3_z;
    tau[0] = neg_n03_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 244 multiplications, 211 additions = 455; 8 unary minus; 10 sine/cosine */
void puma560_full_bias(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    puma560_full_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    const volatile puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_full_real neg_w2_x = qd[0]*s2;
    const puma560_full_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha2_x = qd[1]*neg_w2_y;
    const puma560_full_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_full_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_full_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_full_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_full_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a3_z = a2_z - 0.8636*alpha2_y;
    const puma560_full_real t1 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_x = t1*s23;
    const puma560_full_real w3_y = t1*c23;
    const puma560_full_real t2 = 0.4318*neg_lam2_11;
    const puma560_full_real t3 = 0.4318*ww2_xy;
    const puma560_full_real t4 = c2*t2 + s2*t3;
    const puma560_full_real t5 = s2*t2 - c2*t3 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a3_x = c23*t4 + s23*t5;
    const puma560_full_real a3_y = s23*t4 - c23*t5;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_x = w3_z*w3_y;
    const puma560_full_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_xy = w3_x*w3_y;
    const puma560_full_real ww3_xx = w3_x*w3_x;
    const puma560_full_real ww3_yy = w3_y*w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_full_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*ww3_xy - 0.4331*neg_lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t6 = a3_z + (0.0406*alpha3_y - 0.8662*alpha3_x);
    const puma560_full_real t7 = neg_a3_x + (0.4331*ww3_xy - 0.0203*neg_lam3_11);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_x = s4*t6 - c4*t7;
    const puma560_full_real a4_y = s4*t7 + c4*t6;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_full_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real ww4_yz = w4_y*w4_z;
    const puma560_full_real ww4_zx = w4_x*w4_z;
    const puma560_full_real ww4_xy = w4_x*w4_y;
    const puma560_full_real ww4_xx = w4_x*w4_x;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const puma560_full_real lam4_12 = alpha3_y + ww4_xy;
    const puma560_full_real lam4_13 = alpha4_y + ww4_zx;
    const puma560_full_real lam4_21 = ww4_xy - alpha3_y;
    const puma560_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const puma560_full_real lam4_23 = ww4_yz - alpha4_x;
    const puma560_full_real lam4_31 = ww4_zx - alpha4_y;
    const puma560_full_real lam4_32 = alpha4_x + ww4_yz;
    const puma560_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_full_real t8 = -c5;
    const puma560_full_real w5_y = t8*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = c5*a4_x - s5*a4_z;
    const puma560_full_real a5_y = t8*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (-s5*alpha3_y - c5*alpha4_x);
    const puma560_full_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real ww5_yz = w5_y*w5_z;
    const puma560_full_real ww5_zx = w5_x*w5_z;
    const puma560_full_real ww5_xy = w5_x*w5_y;
    const puma560_full_real ww5_xx = w5_x*w5_x;
    const puma560_full_real ww5_yy = w5_y*w5_y;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const puma560_full_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_full_real lam5_13 = alpha5_y + ww5_zx;
    const puma560_full_real lam5_21 = alpha4_y + ww5_xy;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real lam5_23 = ww5_yz - alpha5_x;
    const puma560_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    const puma560_full_real t9 = -s6;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a6_x = t9*a4_y - c6*a5_x;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (t9*alpha4_y - c6*alpha5_x);
    const puma560_full_real alpha6_y = c6*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_yz = w6_y*w6_z;
    const puma560_full_real ww6_zx = w6_x*w6_z;
    const puma560_full_real ww6_xy = w6_x*w6_y;
    const puma560_full_real ww6_xx = w6_x*w6_x;
    const puma560_full_real ww6_yy = w6_y*w6_y;
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const puma560_full_real lam6_12 = alpha5_y + ww6_xy;
    const puma560_full_real lam6_13 = alpha6_y + ww6_zx;
    const puma560_full_real lam6_21 = ww6_xy - alpha5_y;
    const puma560_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const puma560_full_real lam6_23 = ww6_yz - alpha6_x;
    const puma560_full_real neg_lam6_31 = alpha6_y - ww6_zx;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*ww2_xy - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*ww2_xy - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real nc2_x = -0.024117256252913073*ww1_zz - (0.4146089080715873*neg_alpha2_x
        - 0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282*alpha2_y +
        0.017097472943757824*ww2_xy));
    const puma560_full_real nc2_y = 7.045155598402548*alpha2_y - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) + (0.0507946745483177*ww2_xy + 0.2348119600832282*neg_alpha2_x) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real nc2_z = 3.31527334516548*ww2_xy + 0.1174059800416141*(neg_lam2_11 -
        neg_lam2_22) - (75.09914597144959*c2 - 1.5746110011895278*s2);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = -1.046378600789203*neg_lam3_11 - 5.729293810689829*ww3_xy;
    const puma560_full_real fc3_y = 1.046378600789203*ww3_xy + 5.729293810689829*neg_lam3_22;
    const puma560_full_real fc3_z = -11.458587621379658*alpha3_x - 2.092757201578406*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-6.961065593521791*alpha3_x -
        0.060845712710754084*(neg_lam3_22 - neg_lam3_33) + (0.5723178005100907*alpha3_y +
        0.01894848286257894*ww3_xy));
    const puma560_full_real nc3_y = 0.9435283577273719*alpha3_y - 0.01894848286257894*(neg_lam3_11 -
        neg_lam3_33) + (0.060845712710754084*ww3_xy - 0.5723178005100907*alpha3_x) -
        1.046378600789203*a3_z;
    const puma560_full_real nc3_z = 1.046378600789203*a3_y - 5.729293810689829*neg_a3_x -
        (3.0087686178972097*ww3_xy - 0.28615890025504537*(neg_lam3_11 - neg_lam3_22));
    /* link 4: force that moves the link [N] */
    const puma560_full_real fc4_x = 0.8719880516308344*lam4_12 - 0.7777930398944852*neg_lam4_11;
    const puma560_full_real fc4_y = 0.7777930398944852*lam4_21 - 0.8719880516308344*neg_lam4_22;
    const puma560_full_real fc4_z = 0.7777930398944852*lam4_31 + 0.8719880516308344*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const puma560_full_real nc4_x = 0.8719880516308344*a4_z - (-0.2788425785236688*lam4_32 -
        0.10734691974802549*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096*lam4_21 -
        0.05337162017689789*lam4_31));
    const puma560_full_real nc4_y = -0.3473260245772809*lam4_31 - 0.2837491060266096*(neg_lam4_11 -
        neg_lam4_33) + (0.10734691974802549*lam4_12 - 0.05337162017689789*lam4_32) -
        0.7777930398944852*a4_z;
    const puma560_full_real t10 = 0.2788425785236688*lam4_12 - 0.3473260245772809*lam4_21 -
        0.05337162017689789*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096*lam4_23 -
        0.10734691974802549*lam4_13);
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y - 0.8719880516308344*a4_x - t10;
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = 0.47660058733283606*neg_lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (0.08058935149735619*neg_lam5_31 - 0.1558184212675505*lam5_21)
        + 0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1513642331069161*neg_lam5_31 + 0.1558184212675505*(neg_lam5_11
        - neg_lam5_33) + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t11 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 -
        0.08058935149735619*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t11 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.1185374890947408*neg_lam6_31 + 1.2975168001325401*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (0.4019452224328564*neg_lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = 0.4714480390546099*neg_lam6_31 - 0.1902613160848803*(neg_lam6_11
        - neg_lam6_33) - (0.2519035474197792*lam6_12 - 0.4019452224328564*lam6_32) -
        1.1185374890947408*a5_y;
    const puma560_full_real t12 = 0.43637196239865417*lam6_12 - 0.4714480390546099*lam6_21 +
        0.4019452224328564*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803*lam6_23 +
        0.2519035474197792*lam6_13);
    const puma560_full_real nc6_z = 1.2975168001325401*neg_a6_x - 1.1185374890947408*a6_y - t12;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const puma560_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_x = n06_x - neg_nc5_x;
    const puma560_full_real n5_y = nc5_y - nc6_z;
    const puma560_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const puma560_full_real f5_x = fc5_x + f06_x;
    const puma560_full_real f5_y = fc5_y - fc6_z;
    const puma560_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f05_x = c5*f5_x - s5*f5_y;
    const puma560_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_x = nc4_x + n05_x;
    const puma560_full_real n4_y = nc4_y + n5_z;
    const puma560_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const puma560_full_real f4_x = fc4_x + f05_x;
    const puma560_full_real f4_y = fc4_y + f5_z;
    const puma560_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f04_x = c4*f4_x - s4*f4_y;
    const puma560_full_real neg_f04_y = -c4*f4_y - s4*f4_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_x = n04_x + (nc3_x + 0.4331*neg_f04_y);
    const puma560_full_real n3_y = nc3_y - 0.0203*neg_f04_y - n4_z;
    const puma560_full_real n3_z = n04_y - (-0.4331*f04_x - 0.0203*f4_z - nc3_z);
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x + f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z - neg_f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    const puma560_full_real t13 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + f3_z*t13);
    const puma560_full_real n02_z = n3_z + (nc2_z - (f03_x*(0.4318*s2) - f03_y*t13));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real neg_f02_x = s2*fc2_y - c2*fc2_x - f03_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = 0.1501*neg_f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 141 multiplications, 125 additions = 266; 3 unary minus; 10 sine/cosine */
void puma560_full_mass_matrix(const puma560_full_real q[6], puma560_full_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    const volatile puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h6_x = -1.2975168001325401*s6 - 1.1185374890947408*c6;
    const puma560_full_real neg_h6_y = 1.1185374890947408*s6 - 1.2975168001325401*c6;
    const puma560_full_real t1 = c6*s6;
    const puma560_full_real t2 = c6*c6;
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real k6_xy = 0.03507607665595572*t1 - 0.4019452224328564*(2.0*t2 - 1.0);
    const puma560_full_real k6_xz = 0.1902613160848803*c6 + 0.2519035474197792*s6;
    const puma560_full_real k6_yz = 0.1902613160848803*s6 - 0.2519035474197792*c6;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = c5*neg_h6_y;
    const puma560_full_real fu5_y = s5*neg_h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu5_x = 0.907820001453264*s5 - c5*k6_xz;
    const puma560_full_real neg_nu5_y = s5*k6_xz + 0.907820001453264*c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c4*fu5_x - s4*h6_x;
    const puma560_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu4_x = c4*nu5_x + s4*k6_yz;
    const puma560_full_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_6 = nu4_y - (0.0203*fu5_y - 0.4331*fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c23*fu4_x - s23*fu5_y;
    const puma560_full_real fu3_y = s23*fu4_x + c23*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y = c23*(0.0203*fu4_y - neg_nu5_y) - s23*(0.4331*fu4_y - nu4_x);
    const puma560_full_real t3 = 0.4318*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y = nu3_y - t3*fu4_y;
    const puma560_full_real t4 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_6 = -0.1501*fu3_x - nu2_y;
    const puma560_full_real t5 = 0.03507607665595572*t2 + 0.8038904448657128*t1;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t5 + 0.9778489729032964;
    const puma560_full_real t6 = 0.47660058733283606 - h6_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = 0.15165250821211493*s5 - c5*t6;
    const puma560_full_real neg_h5_y = s5*t6 + 0.15165250821211493*c5;
    const puma560_full_real t7 = c5*c5;
    const puma560_full_real t8 = t5 + 0.1976234181078441;
    const puma560_full_real t9 = k6_xz - 0.08058935149735619;
    const puma560_full_real t10 = c5*s5;
    const puma560_full_real t11 = t7*t8 + t9*(2.0*t10);
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real k5_yy = t5 + 0.5877361955055702 - t11;
    const puma560_full_real k5_xy = t8*t10 + t9*(1.0 - 2.0*t7);
    const puma560_full_real t12 = k6_xy - 0.1558184212675505;
    const puma560_full_real t13 = k6_yz + 0.18116108322165295;
    const puma560_full_real k5_xz = c5*t12 + s5*t13;
    const puma560_full_real k5_yz = s5*t12 - c5*t13;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x_2 = c4*neg_h5_y;
    const puma560_full_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu4_x = c4*k5_xz + s4*m5_5;
    const puma560_full_real nu4_y_2 = c4*m5_5 - s4*k5_xz;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_5 = nu4_y_2 + (0.4331*fu4_x_2 - 0.0203*h5_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_2 = c23*fu4_x_2 - s23*h5_x;
    const puma560_full_real fu3_y_2 = s23*fu4_x_2 + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y_2 = c23*(0.0203*fu4_y_2 - k5_yz) - s23*(neg_nu4_x +
        0.4331*fu4_y_2);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y_2 = nu3_y_2 - t3*fu4_y_2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_5 = -0.1501*fu3_x_2 - nu2_y_2;
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = 1.4877294195532857 - (t5 - t11);
    const puma560_full_real t14 = h5_x + 0.7777930398944852;
    const puma560_full_real t15 = 0.8719880516308344 - neg_h6_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = c4*t14 - s4*t15;
    const puma560_full_real h4_y = s4*t14 + c4*t15;
    const puma560_full_real t16 = c4*c4;
    const puma560_full_real t17 = t5 + t11 - 0.012851815603271595;
    const puma560_full_real t18 = k5_xz + 0.05337162017689789;
    const puma560_full_real t19 = c4*s4;
    const puma560_full_real t20 = t16*t17 - t18*(2.0*t19);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_xx = t20 - (t5 - 0.7502906175782786);
    const puma560_full_real k4_yy = t11 + 0.7374388019750071 - t20;
    const puma560_full_real k4_xy = t17*t19 - t18*(1.0 - 2.0*t16);
    const puma560_full_real t21 = k5_yz - 0.10734691974802549;
    const puma560_full_real t22 = k5_xy - 0.2837491060266096;
    const puma560_full_real k4_xz = s4*t21 - c4*t22;
    const puma560_full_real neg_k4_yz = s4*t22 + c4*t21;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_4 = neg_k4_yz - 0.4331*h4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real neg_fu3_x = c23*h4_y;
    const puma560_full_real fu3_y_3 = -s23*h4_y;
    const puma560_full_real t23 = -0.4331*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y_3 = s23*(t23 - k4_xz) - c23*(m4_4 - 0.0203*h4_x);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y_3 = nu3_y_3 - t3*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_4 = m3_4 + (t3*fu3_y_3 + t4*neg_fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_4 = 0.1501*neg_fu3_x - nu2_y_3;
    const puma560_full_real t24 = 0.0406*h4_x - k4_xx;
    const puma560_full_real t25 = k5_yy + 0.8662*neg_h5_y;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_3 = 3.9522969756245816 - (t24 - t25);
    const puma560_full_real t26 = neg_h5_y + 5.729293810689829;
    const puma560_full_real t27 = -h4_x - 1.046378600789203;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_x = s23*t26 - c23*t27;
    const puma560_full_real neg_h3_y = s23*t27 + c23*t26;
    const puma560_full_real t28 = c23*c23*(t24 + t25 + 3.0087686178972097) + (t23 + (0.0203*neg_h5_y
        - k4_xz) + 0.28615890025504537)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_xx = t25 + 3.4805327967608957 - t28;
    const puma560_full_real k3_yy = t28 - (t24 - 0.47176417886368593);
    const puma560_full_real k3_yz = s23*(k4_xy - 0.0203*h4_y + 0.01894848286257894) + c23*(m3_4 +
        0.060845712710754084);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_3 = k3_yz - 0.1501*neg_h3_y;
    const puma560_full_real t29 = k4_yy - k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_zz = k3_yy + t29;
    const puma560_full_real t30 = k3_xx - t3*(-2.0*h3_x);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_2 = t30 + (k4_yy - t29 - t4*(2.0*neg_h3_y)) + 3.7298822532370677;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h2_y = 7.6631781603519995*s2 + 0.1606745919581151*c2 - neg_h3_y;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_xx = t30 + (3.31527334516548*(c2*c2) - 0.2348119600832282*(c2*s2) +
        0.20730445403579364);
    const puma560_full_real k2_yz = k3_yz + t4*h4_y + (0.017097472943757824*s2 +
        0.0507946745483177*c2);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_2 = k2_yz + 0.1501*h2_y;
    const puma560_full_real m1_1 = k2_xx - (-0.3002*h4_y - k2_zz) + 2.629303206180387;
    const puma560_full_real t31 = -k6_yz;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_4;
    M[4] = m1_5;
    M[5] = m1_6;
    M[6] = m1_2;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = m1_3;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = m3_6;
    M[18] = m1_4;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = k5_yz;
    M[23] = neg_nu5_y;
    M[24] = m1_5;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = k5_yz;
    M[28] = m5_5;
    M[29] = t31;
    M[30] = m1_6;
    M[31] = m2_6;
    M[32] = m3_6;
    M[33] = neg_nu5_y;
    M[34] = t31;
    M[35] = 0.907820001453264;
}

/* accelerations that the torques tau give
 * 469 multiplications, 406 additions, 6 divisions = 881; 15 unary minus; 10 sine/cosine */
void puma560_full_forward_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real tau[6],
    puma560_full_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    const volatile puma560_full_real angle23 = q[1] + q[2];
    const puma560_full_real c23 = cos(angle23);
    const puma560_full_real s23 = sin(angle23);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h6_x = -1.2975168001325401*s6 - 1.1185374890947408*c6;
    const puma560_full_real neg_h6_y = 1.1185374890947408*s6 - 1.2975168001325401*c6;
    const puma560_full_real t1 = c6*s6;
    const puma560_full_real t2 = c6*c6;
    /* link 6: second moment of the composite body [kg m^2] */
    const puma560_full_real k6_xy = 0.03507607665595572*t1 - 0.4019452224328564*(2.0*t2 - 1.0);
    const puma560_full_real k6_xz = 0.1902613160848803*c6 + 0.2519035474197792*s6;
    const puma560_full_real k6_yz = 0.1902613160848803*s6 - 0.2519035474197792*c6;
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = c5*neg_h6_y;
    const puma560_full_real fu5_y = s5*neg_h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu5_x = 0.907820001453264*s5 - c5*k6_xz;
    const puma560_full_real neg_nu5_y = s5*k6_xz + 0.907820001453264*c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c4*fu5_x - s4*h6_x;
    const puma560_full_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu4_x = c4*nu5_x + s4*k6_yz;
    const puma560_full_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_6 = nu4_y - (0.0203*fu5_y - 0.4331*fu4_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c23*fu4_x - s23*fu5_y;
    const puma560_full_real fu3_y = s23*fu4_x + c23*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y = c23*(0.0203*fu4_y - neg_nu5_y) - s23*(0.4331*fu4_y - nu4_x);
    const puma560_full_real t3 = 0.4318*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y = nu3_y - t3*fu4_y;
    const puma560_full_real t4 = 0.4318*s2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_6 = -0.1501*fu3_x - nu2_y;
    const puma560_full_real t5 = 0.03507607665595572*t2 + 0.8038904448657128*t1;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t5 + 0.9778489729032964;
    const puma560_full_real t6 = 0.47660058733283606 - h6_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = 0.15165250821211493*s5 - c5*t6;
    const puma560_full_real neg_h5_y = s5*t6 + 0.15165250821211493*c5;
    const puma560_full_real t7 = c5*c5;
    const puma560_full_real t8 = t5 + 0.1976234181078441;
    const puma560_full_real t9 = k6_xz - 0.08058935149735619;
    const puma560_full_real t10 = c5*s5;
    const puma560_full_real t11 = t7*t8 + t9*(2.0*t10);
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real k5_yy = t5 + 0.5877361955055702 - t11;
    const puma560_full_real k5_xy = t8*t10 + t9*(1.0 - 2.0*t7);
    const puma560_full_real t12 = k6_xy - 0.1558184212675505;
    const puma560_full_real t13 = k6_yz + 0.18116108322165295;
    const puma560_full_real k5_xz = c5*t12 + s5*t13;
    const puma560_full_real k5_yz = s5*t12 - c5*t13;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x_2 = c4*neg_h5_y;
    const puma560_full_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu4_x = c4*k5_xz + s4*m5_5;
    const puma560_full_real nu4_y_2 = c4*m5_5 - s4*k5_xz;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_5 = nu4_y_2 + (0.4331*fu4_x_2 - 0.0203*h5_x);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_2 = c23*fu4_x_2 - s23*h5_x;
    const puma560_full_real fu3_y_2 = s23*fu4_x_2 + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y_2 = c23*(0.0203*fu4_y_2 - k5_yz) - s23*(neg_nu4_x +
        0.4331*fu4_y_2);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y_2 = nu3_y_2 - t3*fu4_y_2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_5 = -0.1501*fu3_x_2 - nu2_y_2;
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = 1.4877294195532857 - (t5 - t11);
    const puma560_full_real t14 = h5_x + 0.7777930398944852;
    const puma560_full_real t15 = 0.8719880516308344 - neg_h6_y;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = c4*t14 - s4*t15;
    const puma560_full_real h4_y = s4*t14 + c4*t15;
    const puma560_full_real t16 = c4*c4;
    const puma560_full_real t17 = t5 + t11 - 0.012851815603271595;
    const puma560_full_real t18 = k5_xz + 0.05337162017689789;
    const puma560_full_real t19 = c4*s4;
    const puma560_full_real t20 = t16*t17 - t18*(2.0*t19);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_xx = t20 - (t5 - 0.7502906175782786);
    const puma560_full_real k4_yy = t11 + 0.7374388019750071 - t20;
    const puma560_full_real k4_xy = t17*t19 - t18*(1.0 - 2.0*t16);
    const puma560_full_real t21 = k5_yz - 0.10734691974802549;
    const puma560_full_real t22 = k5_xy - 0.2837491060266096;
    const puma560_full_real k4_xz = s4*t21 - c4*t22;
    const puma560_full_real neg_k4_yz = s4*t22 + c4*t21;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_4 = neg_k4_yz - 0.4331*h4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real neg_fu3_x = c23*h4_y;
    const puma560_full_real fu3_y_3 = -s23*h4_y;
    const puma560_full_real t23 = -0.4331*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_y_3 = s23*(t23 - k4_xz) - c23*(m4_4 - 0.0203*h4_x);
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_y_3 = nu3_y_3 - t3*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_4 = m3_4 + (t3*fu3_y_3 + t4*neg_fu3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_4 = 0.1501*neg_fu3_x - nu2_y_3;
    const puma560_full_real t24 = 0.0406*h4_x - k4_xx;
    const puma560_full_real t25 = k5_yy + 0.8662*neg_h5_y;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_3 = 3.9522969756245816 - (t24 - t25);
    const puma560_full_real t26 = neg_h5_y + 5.729293810689829;
    const puma560_full_real t27 = -h4_x - 1.046378600789203;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_x = s23*t26 - c23*t27;
    const puma560_full_real neg_h3_y = s23*t27 + c23*t26;
    const puma560_full_real t28 = c23*c23*(t24 + t25 + 3.0087686178972097) + (t23 + (0.0203*neg_h5_y
        - k4_xz) + 0.28615890025504537)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_xx = t25 + 3.4805327967608957 - t28;
    const puma560_full_real k3_yy = t28 - (t24 - 0.47176417886368593);
    const puma560_full_real k3_yz = s23*(k4_xy - 0.0203*h4_y + 0.01894848286257894) + c23*(m3_4 +
        0.060845712710754084);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_3 = k3_yz - 0.1501*neg_h3_y;
    const puma560_full_real t29 = k4_yy - k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_zz = k3_yy + t29;
    const puma560_full_real t30 = k3_xx - t3*(-2.0*h3_x);
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_2 = t30 + (k4_yy - t29 - t4*(2.0*neg_h3_y)) + 3.7298822532370677;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h2_y = 7.6631781603519995*s2 + 0.1606745919581151*c2 - neg_h3_y;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_xx = t30 + (3.31527334516548*(c2*c2) - 0.2348119600832282*(c2*s2) +
        0.20730445403579364);
    const puma560_full_real k2_yz = k3_yz + t4*h4_y + (0.017097472943757824*s2 +
        0.0507946745483177*c2);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_2 = k2_yz + 0.1501*h2_y;
    const puma560_full_real m1_1 = k2_xx - (-0.3002*h4_y - k2_zz) + 2.629303206180387;
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_z = qd[1] + qd[2];
    /* link 1: products of the angular velocity [1/s^2] */
    const puma560_full_real ww1_zz = qd[0]*qd[0];
    /* link 2: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a2_z = -0.1501*ww1_zz;
    /* link 2: angular velocity [rad/s] */
    const puma560_full_real neg_w2_x = qd[0]*s2;
    const puma560_full_real neg_w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_full_real neg_alpha2_x = qd[1]*neg_w2_y;
    const puma560_full_real alpha2_y = qd[1]*neg_w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_full_real ww2_xy = neg_w2_x*neg_w2_y;
    const puma560_full_real ww2_xx = neg_w2_x*neg_w2_x;
    const puma560_full_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_full_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_full_real neg_lam2_22 = ww2_xx + ww2_zz;
    const puma560_full_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a3_z = a2_z - 0.8636*alpha2_y;
    const puma560_full_real t31 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_x = t31*s23;
    const puma560_full_real w3_y = t31*c23;
    const puma560_full_real t32 = 0.4318*neg_lam2_11;
    const puma560_full_real t33 = 0.4318*ww2_xy;
    const puma560_full_real t34 = c2*t32 + s2*t33;
    const puma560_full_real t35 = s2*t32 - c2*t33 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a3_x = c23*t34 + s23*t35;
    const puma560_full_real a3_y = s23*t34 - c23*t35;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_x = w3_z*w3_y;
    const puma560_full_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_xy = w3_x*w3_y;
    const puma560_full_real ww3_xx = w3_x*w3_x;
    const puma560_full_real ww3_yy = w3_y*w3_y;
    const puma560_full_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam3_11 = ww3_yy + ww3_zz;
    const puma560_full_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_full_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*ww3_xy - 0.4331*neg_lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t36 = a3_z + (0.0406*alpha3_y - 0.8662*alpha3_x);
    const puma560_full_real t37 = neg_a3_x + (0.4331*ww3_xy - 0.0203*neg_lam3_11);
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_x = s4*t36 - c4*t37;
    const puma560_full_real a4_y = s4*t37 + c4*t36;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_full_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_z = qd[3] - w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const puma560_full_real ww4_yz = w4_y*w4_z;
    const puma560_full_real ww4_zx = w4_x*w4_z;
    const puma560_full_real ww4_xy = w4_x*w4_y;
    const puma560_full_real ww4_xx = w4_x*w4_x;
    const puma560_full_real ww4_yy = w4_y*w4_y;
    const puma560_full_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam4_11 = ww4_yy + ww4_zz;
    const puma560_full_real lam4_12 = alpha3_y + ww4_xy;
    const puma560_full_real lam4_13 = alpha4_y + ww4_zx;
    const puma560_full_real lam4_21 = ww4_xy - alpha3_y;
    const puma560_full_real neg_lam4_22 = ww4_xx + ww4_zz;
    const puma560_full_real lam4_23 = ww4_yz - alpha4_x;
    const puma560_full_real lam4_31 = ww4_zx - alpha4_y;
    const puma560_full_real lam4_32 = alpha4_x + ww4_yz;
    const puma560_full_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_x = c5*w4_x - s5*w4_z;
    const puma560_full_real t38 = -c5;
    const puma560_full_real w5_y = t38*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = c5*a4_x - s5*a4_z;
    const puma560_full_real a5_y = t38*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (-s5*alpha3_y - c5*alpha4_x);
    const puma560_full_real alpha5_y = c5*alpha3_y - s5*alpha4_x - qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const puma560_full_real w5_z = qd[4] + w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const puma560_full_real ww5_yz = w5_y*w5_z;
    const puma560_full_real ww5_zx = w5_x*w5_z;
    const puma560_full_real ww5_xy = w5_x*w5_y;
    const puma560_full_real ww5_xx = w5_x*w5_x;
    const puma560_full_real ww5_yy = w5_y*w5_y;
    const puma560_full_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam5_11 = ww5_yy + ww5_zz;
    const puma560_full_real lam5_12 = ww5_xy - alpha4_y;
    const puma560_full_real lam5_13 = alpha5_y + ww5_zx;
    const puma560_full_real lam5_21 = alpha4_y + ww5_xy;
    const puma560_full_real neg_lam5_22 = ww5_xx + ww5_zz;
    const puma560_full_real lam5_23 = ww5_yz - alpha5_x;
    const puma560_full_real neg_lam5_31 = alpha5_y - ww5_zx;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (-s6*alpha4_y - c6*alpha5_x);
    const puma560_full_real alpha6_y = c6*alpha4_y - s6*alpha5_x - qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_z = qd[5] - w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const puma560_full_real ww6_yz = w6_y*w6_z;
    const puma560_full_real ww6_zx = w6_x*w6_z;
    const puma560_full_real ww6_xy = w6_x*w6_y;
    const puma560_full_real ww6_xx = w6_x*w6_x;
    const puma560_full_real ww6_yy = w6_y*w6_y;
    const puma560_full_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real neg_lam6_11 = ww6_yy + ww6_zz;
    const puma560_full_real lam6_12 = alpha5_y + ww6_xy;
    const puma560_full_real lam6_13 = alpha6_y + ww6_zx;
    const puma560_full_real lam6_21 = ww6_xy - alpha5_y;
    const puma560_full_real neg_lam6_22 = ww6_xx + ww6_zz;
    const puma560_full_real lam6_23 = ww6_yz - alpha6_x;
    const puma560_full_real neg_lam6_31 = alpha6_y - ww6_zx;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*ww2_xy - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*ww2_xy - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real nc2_x = -0.024117256252913073*ww1_zz - (0.4146089080715873*neg_alpha2_x
        - 0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282*alpha2_y +
        0.017097472943757824*ww2_xy));
    const puma560_full_real nc2_y = 7.045155598402548*alpha2_y - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) + (0.0507946745483177*ww2_xy + 0.2348119600832282*neg_alpha2_x) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real nc2_z = 3.31527334516548*ww2_xy + 0.1174059800416141*(neg_lam2_11 -
        neg_lam2_22) - (75.09914597144959*c2 - 1.5746110011895278*s2);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = -1.046378600789203*neg_lam3_11 - 5.729293810689829*ww3_xy;
    const puma560_full_real fc3_y = 1.046378600789203*ww3_xy + 5.729293810689829*neg_lam3_22;
    const puma560_full_real fc3_z = -11.458587621379658*alpha3_x - 2.092757201578406*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-6.961065593521791*alpha3_x -
        0.060845712710754084*(neg_lam3_22 - neg_lam3_33) + (0.5723178005100907*alpha3_y +
        0.01894848286257894*ww3_xy));
    const puma560_full_real nc3_y = 0.9435283577273719*alpha3_y - 0.01894848286257894*(neg_lam3_11 -
        neg_lam3_33) + (0.060845712710754084*ww3_xy - 0.5723178005100907*alpha3_x) -
        1.046378600789203*a3_z;
    const puma560_full_real nc3_z = 1.046378600789203*a3_y - 5.729293810689829*neg_a3_x -
        (3.0087686178972097*ww3_xy - 0.28615890025504537*(neg_lam3_11 - neg_lam3_22));
    /* link 4: force that moves the link [N] */
    const puma560_full_real fc4_x = 0.8719880516308344*lam4_12 - 0.7777930398944852*neg_lam4_11;
    const puma560_full_real fc4_y = 0.7777930398944852*lam4_21 - 0.8719880516308344*neg_lam4_22;
    const puma560_full_real fc4_z = 0.7777930398944852*lam4_31 + 0.8719880516308344*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const puma560_full_real nc4_x = 0.8719880516308344*a4_z - (-0.2788425785236688*lam4_32 -
        0.10734691974802549*(neg_lam4_22 - neg_lam4_33) + (0.2837491060266096*lam4_21 -
        0.05337162017689789*lam4_31));
    const puma560_full_real nc4_y = -0.3473260245772809*lam4_31 - 0.2837491060266096*(neg_lam4_11 -
        neg_lam4_33) + (0.10734691974802549*lam4_12 - 0.05337162017689789*lam4_32) -
        0.7777930398944852*a4_z;
    const puma560_full_real t39 = 0.2788425785236688*lam4_12 - 0.3473260245772809*lam4_21 -
        0.05337162017689789*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096*lam4_23 -
        0.10734691974802549*lam4_13);
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y - 0.8719880516308344*a4_x - t39;
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = 0.47660058733283606*neg_lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (0.08058935149735619*neg_lam5_31 - 0.1558184212675505*lam5_21)
        + 0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1513642331069161*neg_lam5_31 + 0.1558184212675505*(neg_lam5_11
        - neg_lam5_33) + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t40 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 -
        0.08058935149735619*(neg_lam5_22 - neg_lam5_11) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t40 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.1185374890947408*neg_lam6_31 + 1.2975168001325401*lam6_32;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (0.4019452224328564*neg_lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = 0.4714480390546099*neg_lam6_31 - 0.1902613160848803*(neg_lam6_11
        - neg_lam6_33) - (0.2519035474197792*lam6_12 - 0.4019452224328564*lam6_32) -
        1.1185374890947408*a5_y;
    const puma560_full_real t41 = 0.43637196239865417*lam6_12 - 0.4714480390546099*lam6_21 +
        0.4019452224328564*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803*lam6_23 +
        0.2519035474197792*lam6_13);
    const puma560_full_real neg_nc6_z = t41 + (1.1185374890947408*a6_y + 1.2975168001325401*a6_x);
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f06_x = c6*fc6_x - s6*fc6_y;
    const puma560_full_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_x = n06_x - neg_nc5_x;
    const puma560_full_real n5_y = nc5_y + neg_nc6_z;
    const puma560_full_real n5_z = nc5_z + n06_y;
    /* link 5: force through the joint [N] */
    const puma560_full_real f5_x = fc5_x + f06_x;
    const puma560_full_real f5_y = fc5_y - fc6_z;
    const puma560_full_real f5_z = fc5_z + f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f05_x = c5*f5_x - s5*f5_y;
    const puma560_full_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_x = nc4_x + n05_x;
    const puma560_full_real n4_y = nc4_y + n5_z;
    const puma560_full_real n4_z = nc4_z - n05_y;
    /* link 4: force through the joint [N] */
    const puma560_full_real f4_x = fc4_x + f05_x;
    const puma560_full_real f4_y = fc4_y + f5_z;
    const puma560_full_real f4_z = fc4_z - f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f04_x = c4*f4_x - s4*f4_y;
    const puma560_full_real neg_f04_y = -c4*f4_y - s4*f4_x;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_x = n04_x + (nc3_x + 0.4331*neg_f04_y);
    const puma560_full_real n3_y = nc3_y - 0.0203*neg_f04_y - n4_z;
    const puma560_full_real n3_z = n04_y - (-0.4331*f04_x - 0.0203*f4_z - nc3_z);
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x + f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z - neg_f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (-c2*nc2_y - s2*nc2_x + t3*f3_z);
    const puma560_full_real n02_z = n3_z + (nc2_z - (t4*f03_x - t3*f03_y));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real neg_f02_x = s2*fc2_y - c2*fc2_x - f03_x;
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = 0.1501*neg_f02_x - n02_y;
    /* link 1: forward substitution */
    const puma560_full_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const puma560_full_real ipivot1 = 1.0 / m1_1;
    const puma560_full_real l2_1 = m1_2*ipivot1;
    const puma560_full_real l3_1 = m1_3*ipivot1;
    const puma560_full_real l4_1 = m1_4*ipivot1;
    const puma560_full_real l5_1 = m1_5*ipivot1;
    const puma560_full_real l6_1 = m1_6*ipivot1;
    const puma560_full_real pivot2 = m2_2 - m1_2*l2_1;
    const puma560_full_real ipivot2 = 1.0 / pivot2;
    const puma560_full_real neg_ld3_2 = m1_2*l3_1 - m2_3;
    const puma560_full_real l3_2 = -ipivot2*neg_ld3_2;
    const puma560_full_real ld4_2 = m2_4 - m1_2*l4_1;
    const puma560_full_real l4_2 = ipivot2*ld4_2;
    const puma560_full_real ld5_2 = m2_5 - m1_2*l5_1;
    const puma560_full_real l5_2 = ipivot2*ld5_2;
    const puma560_full_real ld6_2 = m2_6 - m1_2*l6_1;
    const puma560_full_real l6_2 = ipivot2*ld6_2;
    const puma560_full_real pivot3 = neg_ld3_2*l3_2 - (m1_3*l3_1 - m3_3);
    const puma560_full_real ipivot3 = 1.0 / pivot3;
    const puma560_full_real ld4_3 = m3_4 - m1_3*l4_1 + neg_ld3_2*l4_2;
    const puma560_full_real l4_3 = ipivot3*ld4_3;
    const puma560_full_real ld5_3 = neg_ld3_2*l5_2 - (m1_3*l5_1 - m3_5);
    const puma560_full_real l5_3 = ipivot3*ld5_3;
    const puma560_full_real ld6_3 = neg_ld3_2*l6_2 - (m1_3*l6_1 - m3_6);
    const puma560_full_real l6_3 = ipivot3*ld6_3;
    const puma560_full_real t42 = -ld4_2;
    const puma560_full_real pivot4 = t42*l4_2 - (m1_4*l4_1 - m4_4) - ld4_3*l4_3;
    const puma560_full_real ipivot4 = 1.0 / pivot4;
    const puma560_full_real ld5_4 = k5_yz - m1_4*l5_1 - ld4_2*l5_2 - ld4_3*l5_3;
    const puma560_full_real l5_4 = ipivot4*ld5_4;
    const puma560_full_real ld6_4 = t42*l6_2 - (m1_4*l6_1 - neg_nu5_y) - ld4_3*l6_3;
    const puma560_full_real l6_4 = ipivot4*ld6_4;
    const puma560_full_real pivot5 = m5_5 - m1_5*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const puma560_full_real ipivot5 = 1.0 / pivot5;
    const puma560_full_real neg_ld6_5 = k6_yz + m1_5*l6_1 + ld5_2*l6_2 + ld5_3*l6_3 + ld5_4*l6_4;
    const puma560_full_real l6_5 = -ipivot5*neg_ld6_5;
    const puma560_full_real pivot6 = neg_ld6_5*l6_5 - (m1_6*l6_1 - 0.907820001453264 + ld6_2*l6_2 +
        ld6_3*l6_3 + ld6_4*l6_4);
    const puma560_full_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const puma560_full_real y2 = tau[1] - n02_z - y1*l2_1;
    /* link 3: forward substitution */
    const puma560_full_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const puma560_full_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const puma560_full_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const puma560_full_real y6 = tau[5] + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 -
        l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd4 = -l6_4*qdd6 - (l5_4*qdd5 - ipivot4*y4);
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd3 = -l5_3*qdd5 - (l4_3*qdd4 - ipivot3*y3) - l6_3*qdd6;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3 - l4_1*qdd4 - l5_1*qdd5 -
        l6_1*qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
