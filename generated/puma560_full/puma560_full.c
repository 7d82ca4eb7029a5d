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
 *   inverse_dynamics: 262 multiplications, 243 additions = 505; 7 unary minus; 10 sine/cosine
 *   gravity: 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
 *   bias: 244 multiplications, 211 additions = 455; 7 unary minus; 10 sine/cosine
 *   mass_matrix: 161 multiplications, 139 additions = 300; 6 unary minus; 10 sine/cosine
 *   forward_dynamics: 491 multiplications, 421 additions, 6 divisions = 918; 14 unary minus; 12
 *       sine/cosine
 */
#include "puma560_full.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 262 multiplications, 243 additions = 505; 7 unary minus; 10 sine/cosine */
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
    const puma560_full_real a2_z = -0.1501*ww1_zz;
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
    const puma560_full_real a3_z = a2_z + 0.4318*lam2_31;
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
    const puma560_full_real neg_ww3_zz = -w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_11 = neg_ww3_zz - ww3_yy;
    const puma560_full_real lam3_12 = ww3_xy - alpha3_z;
    const puma560_full_real lam3_13 = ww3_zx - neg_alpha3_y;
    const puma560_full_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_full_real lam3_22 = neg_ww3_zz - ww3_xx;
    const puma560_full_real lam3_23 = ww3_yz - alpha3_x;
    const puma560_full_real lam3_31 = ww3_zx + neg_alpha3_y;
    const puma560_full_real lam3_32 = ww3_yz + alpha3_x;
    const puma560_full_real lam3_33 = -ww3_xx - ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*lam3_21 + 0.4331*lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t7 = neg_a3_x + (0.0203*lam3_11 + 0.4331*lam3_12);
    const puma560_full_real t8 = 0.0203*lam3_31 + 0.4331*lam3_32 - a3_z;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a4_x = c4*t7 + s4*t8;
    const puma560_full_real a4_y = s4*t7 - c4*t8;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = qd[3]*w4_y - (-c4*alpha3_x - s4*alpha3_z);
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
    const puma560_full_real t9 = -s5;
    const puma560_full_real w5_y = t9*w4_x - c5*w4_z;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = -c5*neg_a4_x - s5*a4_z;
    const puma560_full_real a5_y = s5*neg_a4_x - c5*a4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (s5*alpha4_z - c5*alpha4_x);
    const puma560_full_real alpha5_y = t9*alpha4_x - c5*alpha4_z - qd[4]*w5_x;
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
    const puma560_full_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*alpha5_z);
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
    const puma560_full_real lam6_31 = ww6_zx - alpha6_y;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 1: moment that turns the link [N m] */
    const puma560_full_real nc1_z = 2.629303206180387*qdd[0];
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*lam2_12 - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*lam2_21 - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real neg_nc2_x = -0.20730445403579364*lam2_32 -
        0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.017097472943757824*lam2_21 -
        0.1174059800416141*lam2_31) + 0.024117256252913073*ww1_zz;
    const puma560_full_real nc2_y = -3.522577799201274*lam2_31 - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) - (0.1174059800416141*lam2_32 - 0.0507946745483177*lam2_12) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real t10 = 3.522577799201274*lam2_21 - 0.20730445403579364*lam2_12 +
        0.1174059800416141*(neg_lam2_11 - neg_lam2_22) - (0.0507946745483177*lam2_13 -
        0.017097472943757824*lam2_23);
    const puma560_full_real nc2_z = t10 + (7.6631781603519995*a2_y + 0.1606745919581151*neg_a2_x);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = 1.046378600789203*lam3_11 - 5.729293810689829*lam3_12;
    const puma560_full_real fc3_y = 1.046378600789203*lam3_21 - 5.729293810689829*lam3_22;
    const puma560_full_real fc3_z = 1.046378600789203*lam3_31 - 5.729293810689829*lam3_32;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-3.4805327967608957*lam3_32 -
        0.060845712710754084*(lam3_33 - lam3_22) + (0.01894848286257894*lam3_21 -
        0.28615890025504537*lam3_31));
    const puma560_full_real nc3_y = -0.47176417886368593*lam3_31 - 0.01894848286257894*(lam3_33 -
        lam3_11) - (0.28615890025504537*lam3_32 - 0.060845712710754084*lam3_12) -
        1.046378600789203*a3_z;
    const puma560_full_real t11 = 0.47176417886368593*lam3_21 - 3.4805327967608957*lam3_12 +
        0.28615890025504537*(lam3_22 - lam3_11) - (0.060845712710754084*lam3_13 -
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
    const puma560_full_real nc4_z = t12 + (0.7777930398944852*a4_y + 0.8719880516308344*neg_a4_x);
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = -0.47660058733283606*lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (-0.08058935149735619*lam5_31 - 0.1558184212675505*lam5_21) +
        0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1558184212675505*(neg_lam5_11 - neg_lam5_33) -
        0.1513642331069161*lam5_31 + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t13 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 +
        0.08058935149735619*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t13 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.2975168001325401*lam6_32 - 1.1185374890947408*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (-0.4019452224328564*lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = -0.4714480390546099*lam6_31 - 0.1902613160848803*(neg_lam6_11 -
        neg_lam6_33) + (0.4019452224328564*lam6_32 - 0.2519035474197792*lam6_12) -
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
    const puma560_full_real neg_f04_x = s4*f4_y - c4*f4_x;
    const puma560_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_x = n04_x + (nc3_x - 0.4331*f04_y);
    const puma560_full_real n3_y = nc3_y + 0.0203*f04_y - n4_z;
    const puma560_full_real n3_z = n04_y + (nc3_z - (0.4331*neg_f04_x - 0.0203*f4_z));
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x - neg_f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    const puma560_full_real t15 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t15);
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
 * 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine */
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
    const puma560_full_real a3_x = -9.8*s23;
    const puma560_full_real a3_y = -9.8*c23;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_x = c4*a3_x;
    const puma560_full_real a4_y = -s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = c5*a4_x + s5*a3_y;
    const puma560_full_real a5_y = c5*a3_y - s5*a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real nc2_z = 1.5746110011895278*s2 - 75.09914597144959*c2;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real neg_nc3_z = 10.254510287734192*c23 + 56.14707934476033*s23;
    /* link 4: moment that turns the link [N m] */
    const puma560_full_real nc4_x = 8.545482905982176*c23;
    const puma560_full_real nc4_y = -7.622371790965955*c23;
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y - 0.8719880516308344*a4_x;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real nc5_x = -0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.47660058733283606*a4_y;
    const puma560_full_real nc5_z = 0.15165250821211493*a5_x - 0.47660058733283606*a5_y;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y;
    const puma560_full_real nc6_y = -1.1185374890947408*a5_y;
    const puma560_full_real nc6_z = -1.2975168001325401*a6_x - 1.1185374890947408*a6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n06_x = c6*nc6_x - s6*nc6_y;
    const puma560_full_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n5_x = nc5_x + n06_x;
    const puma560_full_real n5_y = nc5_y - nc6_z;
    const puma560_full_real n5_z = nc5_z + n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n05_x = c5*n5_x - s5*n5_y;
    const puma560_full_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n4_x = nc4_x + n05_x;
    const puma560_full_real n4_y = nc4_y + n5_z;
    const puma560_full_real n4_z = nc4_z - n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
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
 * 244 multiplications, 211 additions = 455; 7 unary minus; 10 sine/cosine */
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
    const puma560_full_real t6 = -w3_z;
    const puma560_full_real alpha3_y = t6*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_xy = w3_x*w3_y;
    const puma560_full_real ww3_xx = w3_x*w3_x;
    const puma560_full_real ww3_yy = w3_y*w3_y;
    const puma560_full_real neg_ww3_zz = t6*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_11 = neg_ww3_zz - ww3_yy;
    const puma560_full_real lam3_22 = neg_ww3_zz - ww3_xx;
    const puma560_full_real lam3_33 = -ww3_xx - ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*ww3_xy + 0.4331*lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t7 = neg_a3_x + (0.0203*lam3_11 + 0.4331*ww3_xy);
    const puma560_full_real t8 = 0.8662*alpha3_x - 0.0406*alpha3_y - a3_z;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a4_x = c4*t7 + s4*t8;
    const puma560_full_real a4_y = s4*t7 - c4*t8;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_full_real alpha4_y = -s4*alpha3_x - qd[3]*w4_x;
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
    const puma560_full_real w5_y = -s5*w4_x - c5*w4_z;
    const puma560_full_real t9 = -c5;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = t9*neg_a4_x - s5*a4_z;
    const puma560_full_real a5_y = s5*neg_a4_x - c5*a4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (t9*alpha4_x - s5*alpha3_y);
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
    const puma560_full_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*alpha4_y);
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
    const puma560_full_real lam6_31 = ww6_zx - alpha6_y;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*ww2_xy - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*ww2_xy - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real neg_nc2_x = 0.4146089080715873*neg_alpha2_x -
        0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282*alpha2_y +
        0.017097472943757824*ww2_xy) + 0.024117256252913073*ww1_zz;
    const puma560_full_real nc2_y = 7.045155598402548*alpha2_y - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) + (0.0507946745483177*ww2_xy + 0.2348119600832282*neg_alpha2_x) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real nc2_z = 3.31527334516548*ww2_xy + 0.1174059800416141*(neg_lam2_11 -
        neg_lam2_22) - (75.09914597144959*c2 - 1.5746110011895278*s2);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = 1.046378600789203*lam3_11 - 5.729293810689829*ww3_xy;
    const puma560_full_real fc3_y = 1.046378600789203*ww3_xy - 5.729293810689829*lam3_22;
    const puma560_full_real fc3_z = -11.458587621379658*alpha3_x - 2.092757201578406*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-6.961065593521791*alpha3_x -
        0.060845712710754084*(lam3_33 - lam3_22) + (0.5723178005100907*alpha3_y +
        0.01894848286257894*ww3_xy));
    const puma560_full_real nc3_y = 0.9435283577273719*alpha3_y - 0.01894848286257894*(lam3_33 -
        lam3_11) + (0.060845712710754084*ww3_xy - 0.5723178005100907*alpha3_x) -
        1.046378600789203*a3_z;
    const puma560_full_real nc3_z = 1.046378600789203*a3_y - 5.729293810689829*neg_a3_x -
        (3.0087686178972097*ww3_xy - 0.28615890025504537*(lam3_22 - lam3_11));
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
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y + 0.8719880516308344*neg_a4_x - t10;
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = -0.47660058733283606*lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (-0.08058935149735619*lam5_31 - 0.1558184212675505*lam5_21) +
        0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1558184212675505*(neg_lam5_11 - neg_lam5_33) -
        0.1513642331069161*lam5_31 + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t11 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 +
        0.08058935149735619*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t11 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.2975168001325401*lam6_32 - 1.1185374890947408*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (-0.4019452224328564*lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = -0.4714480390546099*lam6_31 - 0.1902613160848803*(neg_lam6_11 -
        neg_lam6_33) - (0.2519035474197792*lam6_12 - 0.4019452224328564*lam6_32) -
        1.1185374890947408*a5_y;
    const puma560_full_real t12 = 0.43637196239865417*lam6_12 - 0.4714480390546099*lam6_21 +
        0.4019452224328564*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803*lam6_23 +
        0.2519035474197792*lam6_13);
    const puma560_full_real nc6_z = -1.2975168001325401*a6_x - 1.1185374890947408*a6_y - t12;
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
    const puma560_full_real n3_z = n04_y - (-0.0203*f4_z - 0.4331*f04_x - nc3_z);
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x + f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    const puma560_full_real t13 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t13);
    const puma560_full_real n02_z = n3_z + (nc2_z - (f03_x*(0.4318*s2) - f03_y*t13));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f02_x = f03_x - (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = -0.1501*f02_x - n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 161 multiplications, 139 additions = 300; 6 unary minus; 10 sine/cosine */
void puma560_full_mass_matrix(const puma560_full_real q[6], puma560_full_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_full_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_full_real c2 = cos(q[1]);
    const puma560_full_real s2 = sin(again[1]);
    const puma560_full_real c3 = cos(q[2]);
    const puma560_full_real s3 = sin(again[2]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = 1.1185374890947408*s6 - 1.2975168001325401*c6;
    const puma560_full_real fu5_z = -1.1185374890947408*c6 - 1.2975168001325401*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu5_x = -0.2519035474197792*s6 - 0.1902613160848803*c6;
    const puma560_full_real nu5_z = 0.2519035474197792*c6 - 0.1902613160848803*s6;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c5*fu5_x;
    const puma560_full_real fu4_z = -s5*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu4_x = c5*nu5_x + 0.907820001453264*s5;
    const puma560_full_real nu4_z = 0.907820001453264*c5 - s5*nu5_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c4*fu4_x - s4*fu5_z;
    const puma560_full_real t1 = -s4;
    const puma560_full_real neg_fu3_z = t1*fu4_x - c4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_x = 0.4331*neg_fu3_z - (s4*nu5_z - c4*nu4_x);
    const puma560_full_real nu3_y = -0.0203*neg_fu3_z - nu4_z;
    const puma560_full_real nu3_z = 0.0203*fu4_z + 0.4331*fu3_x - (t1*nu4_x - c4*nu5_z);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x = c3*fu3_x + s3*fu4_z;
    const puma560_full_real fu2_y = s3*fu3_x - c3*fu4_z;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x = s3*nu3_y - c3*nu3_x;
    const puma560_full_real nu2_y = 0.4318*neg_fu3_z - (-s3*nu3_x - c3*nu3_y);
    const puma560_full_real nu2_z = nu3_z + 0.4318*fu2_y;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x = c2*fu2_x - s2*fu2_y;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z = s2*neg_nu2_x - c2*nu2_y - 0.1501*fu1_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = fu5_z - 0.47660058733283606;
    const puma560_full_real t2 = c6*c6;
    const puma560_full_real t3 = c6*s6;
    const puma560_full_real t4 = 0.03507607665595572*t2 + 0.8038904448657128*t3;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real k5_xx = t4 + 0.5877361955055702;
    const puma560_full_real k5_xy = nu5_x + 0.08058935149735619;
    const puma560_full_real k5_xz = 0.03507607665595572*t3 - 0.4019452224328564*(2.0*t2 - 1.0) -
        0.1558184212675505;
    const puma560_full_real k5_yz = nu5_z - 0.18116108322165295;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t4 + 0.9778489729032964;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x_2 = 0.15165250821211493*c5 - s5*h5_x;
    const puma560_full_real fu4_z_2 = -c5*h5_x - 0.15165250821211493*s5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu4_x = c5*k5_xz - s5*k5_yz;
    const puma560_full_real nu4_z_2 = s5*k5_xz + c5*k5_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_2 = c4*fu4_x_2;
    const puma560_full_real fu3_z = s4*fu4_x_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu3_x = c4*neg_nu4_x + s4*m5_5 + 0.4331*fu3_z;
    const puma560_full_real nu3_y_2 = 0.0203*fu3_z - nu4_z_2;
    const puma560_full_real nu3_z_2 = 0.0203*fu4_z_2 + 0.4331*fu3_x_2 - (s4*neg_nu4_x - c4*m5_5);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const puma560_full_real fu2_y_2 = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2;
    const puma560_full_real nu2_y_2 = -0.4318*fu3_z - (s3*neg_nu3_x - c3*nu3_y_2);
    const puma560_full_real nu2_z_2 = nu3_z_2 + 0.4318*fu2_y_2;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_2 = s2*neg_nu2_x_2 - c2*nu2_y_2 - 0.1501*fu1_x_2;
    const puma560_full_real t5 = c5*c5;
    const puma560_full_real t6 = t4 + 0.1976234181078441;
    const puma560_full_real t7 = c5*s5;
    const puma560_full_real t8 = t5*t6 - k5_xy*(2.0*t7);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_zz = k5_xx - t8;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = 0.7777930398944852 - fu4_z_2;
    const puma560_full_real h4_y = 0.8719880516308344 - fu5_x;
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_xx = t8 + 0.7374388019750071;
    const puma560_full_real k4_yy = 0.7502906175782786 - t4;
    const puma560_full_real k4_xy = neg_nu4_x + 0.05337162017689789;
    const puma560_full_real k4_xz = 0.2837491060266096 - (t6*t7 - k5_xy*(1.0 - 2.0*t5));
    const puma560_full_real k4_yz = 0.10734691974802549 - nu4_z_2;
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = 1.4877294195532857 - (t4 - t8);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_3 = -(c4*h4_y) - s4*h4_x;
    const puma560_full_real fu3_z_2 = c4*h4_x - s4*h4_y;
    const puma560_full_real t9 = s4*k4_yz - c4*k4_xz;
    const puma560_full_real t10 = 0.4331*fu3_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_x_2 = t9 - t10;
    const puma560_full_real nu3_y_3 = 0.0203*fu3_z_2 - m4_4;
    const puma560_full_real nu3_z_3 = t1*k4_xz - c4*k4_yz + 0.4331*fu3_x_3;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_3 = c3*fu3_x_3;
    const puma560_full_real fu2_y_3 = s3*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_x = c3*nu3_x_2 - s3*nu3_y_3;
    const puma560_full_real nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_3 - 0.4318*fu3_z_2;
    const puma560_full_real nu2_z_3 = nu3_z_3 + 0.4318*fu2_y_3;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_3 = -0.1501*fu1_x_3 - (s2*nu2_x + c2*nu2_y_3);
    const puma560_full_real t11 = c4*c4;
    const puma560_full_real t12 = t4 + t8 - 0.012851815603271595;
    const puma560_full_real t13 = c4*s4;
    const puma560_full_real t14 = t11*t12 - k4_xy*(2.0*t13);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_zz = k4_xx - t14;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_x = fu3_z_2 + 1.046378600789203;
    const puma560_full_real neg_h3_y = fu4_x_2 + 5.729293810689829;
    const puma560_full_real t15 = 0.0406*fu3_z_2 - (k4_yy + t14);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_xx = 0.47176417886368593 - t15;
    const puma560_full_real t16 = k4_zz + 0.8662*fu4_x_2;
    const puma560_full_real k3_yy = t16 + 3.4805327967608957;
    const puma560_full_real k3_xy = t9 + 0.0203*fu4_x_2 - t10 + 0.28615890025504537;
    const puma560_full_real k3_xz = t12*t13 - k4_xy*(1.0 - 2.0*t11) + 0.0203*fu3_x_3 +
        0.01894848286257894;
    const puma560_full_real k3_yz = nu3_z_3 + 0.060845712710754084;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_3 = 3.9522969756245816 - (t15 - t16);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_4 = c3*neg_h3_y - s3*h3_x;
    const puma560_full_real fu2_y_4 = s3*neg_h3_y + c3*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x_3 = c3*k3_xz - s3*k3_yz;
    const puma560_full_real nu2_y_4 = -(s3*k3_xz) - c3*k3_yz;
    const puma560_full_real nu2_z_4 = m3_3 + 0.4318*fu2_y_4;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_4 = c2*fu2_x_4 - s2*fu2_y_4;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_4 = s2*neg_nu2_x_3 - c2*nu2_y_4 - 0.1501*fu1_x_4;
    const puma560_full_real t17 = c3*c3;
    const puma560_full_real t18 = t15 + t16 + 3.0087686178972097;
    const puma560_full_real t19 = c3*s3;
    const puma560_full_real t20 = t17*t18 + k3_xy*(2.0*t19);
    const puma560_full_real t21 = k3_xx + t20;
    const puma560_full_real t22 = k3_zz - t21;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_zz = t21 + t22;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h2_x = fu2_y_4 + 7.6631781603519995;
    const puma560_full_real neg_h2_y = fu2_x_4 - 0.1606745919581151;
    const puma560_full_real t23 = k3_zz - t22;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_yy = t23 + 0.20730445403579364;
    const puma560_full_real k2_xy = 0.1174059800416141 - (t18*t19 + k3_xy*(1.0 - 2.0*t17) +
        0.4318*fu2_x_4);
    const puma560_full_real k2_xz = neg_nu2_x_3 - 0.4318*fu3_x_3 + 0.017097472943757824;
    const puma560_full_real k2_yz = 0.0507946745483177 - nu2_y_4;
    const puma560_full_real t24 = k3_yy - t20 + 0.8636*fu2_y_4;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_2 = t23 + t24 + 3.7298822532370677;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_5 = c2*neg_h2_y - s2*h2_x;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_5 = s2*k2_xz + c2*k2_yz - 0.1501*fu1_x_5;
    const puma560_full_real t25 = k2_yy - (c2*c2*(t23 - t24 - 3.31527334516548) +
        k2_xy*(2.0*(c2*s2))) + (k2_zz - 0.3002*fu3_x_3);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_1 = t25 + 2.629303206180387;
    M[0] = m1_1;
    M[1] = nu1_z_5;
    M[2] = nu1_z_4;
    M[3] = nu1_z_3;
    M[4] = nu1_z_2;
    M[5] = nu1_z;
    M[6] = nu1_z_5;
    M[7] = m2_2;
    M[8] = nu2_z_4;
    M[9] = nu2_z_3;
    M[10] = nu2_z_2;
    M[11] = nu2_z;
    M[12] = nu1_z_4;
    M[13] = nu2_z_4;
    M[14] = m3_3;
    M[15] = nu3_z_3;
    M[16] = nu3_z_2;
    M[17] = nu3_z;
    M[18] = nu1_z_3;
    M[19] = nu2_z_3;
    M[20] = nu3_z_3;
    M[21] = m4_4;
    M[22] = nu4_z_2;
    M[23] = nu4_z;
    M[24] = nu1_z_2;
    M[25] = nu2_z_2;
    M[26] = nu3_z_2;
    M[27] = nu4_z_2;
    M[28] = m5_5;
    M[29] = nu5_z;
    M[30] = nu1_z;
    M[31] = nu2_z;
    M[32] = nu3_z;
    M[33] = nu4_z;
    M[34] = nu5_z;
    M[35] = 0.907820001453264;
}

/* accelerations that the torques tau give
 * 491 multiplications, 421 additions, 6 divisions = 918; 14 unary minus; 12 sine/cosine */
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
    const puma560_full_real c3 = cos(q[2]);
    const puma560_full_real s3 = sin(again[2]);
    const puma560_full_real c4 = cos(q[3]);
    const puma560_full_real s4 = sin(again[3]);
    const puma560_full_real c5 = cos(q[4]);
    const puma560_full_real s5 = sin(again[4]);
    const puma560_full_real c6 = cos(q[5]);
    const puma560_full_real s6 = sin(again[5]);
    /* link 5: force for a unit acceleration of a joint further out */
    const puma560_full_real fu5_x = 1.1185374890947408*s6 - 1.2975168001325401*c6;
    const puma560_full_real fu5_z = -1.1185374890947408*c6 - 1.2975168001325401*s6;
    /* link 5: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu5_x = -0.2519035474197792*s6 - 0.1902613160848803*c6;
    const puma560_full_real nu5_z = 0.2519035474197792*c6 - 0.1902613160848803*s6;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x = c5*fu5_x;
    const puma560_full_real t1 = -s5;
    const puma560_full_real fu4_z = t1*fu5_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu4_x = c5*nu5_x + 0.907820001453264*s5;
    const puma560_full_real nu4_z = 0.907820001453264*c5 - s5*nu5_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x = c4*fu4_x - s4*fu5_z;
    const puma560_full_real t2 = -s4;
    const puma560_full_real neg_fu3_z = t2*fu4_x - c4*fu5_z;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_x = 0.4331*neg_fu3_z - (s4*nu5_z - c4*nu4_x);
    const puma560_full_real nu3_y = -0.0203*neg_fu3_z - nu4_z;
    const puma560_full_real nu3_z = 0.0203*fu4_z + 0.4331*fu3_x - (t2*nu4_x - c4*nu5_z);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x = c3*fu3_x + s3*fu4_z;
    const puma560_full_real fu2_y = s3*fu3_x - c3*fu4_z;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x = s3*nu3_y - c3*nu3_x;
    const puma560_full_real nu2_y = 0.4318*neg_fu3_z - (-s3*nu3_x - c3*nu3_y);
    const puma560_full_real nu2_z = nu3_z + 0.4318*fu2_y;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x = c2*fu2_x - s2*fu2_y;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z = s2*neg_nu2_x - c2*nu2_y - 0.1501*fu1_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h5_x = fu5_z - 0.47660058733283606;
    const puma560_full_real t3 = c6*c6;
    const puma560_full_real t4 = c6*s6;
    const puma560_full_real t5 = 0.03507607665595572*t3 + 0.8038904448657128*t4;
    /* link 5: second moment of the composite body [kg m^2] */
    const puma560_full_real k5_xx = t5 + 0.5877361955055702;
    const puma560_full_real k5_xy = nu5_x + 0.08058935149735619;
    const puma560_full_real k5_xz = 0.03507607665595572*t4 - 0.4019452224328564*(2.0*t3 - 1.0) -
        0.1558184212675505;
    const puma560_full_real k5_yz = nu5_z - 0.18116108322165295;
    /* link 5: mass matrix, its row of this joint */
    const puma560_full_real m5_5 = t5 + 0.9778489729032964;
    /* link 4: force for a unit acceleration of a joint further out */
    const puma560_full_real fu4_x_2 = 0.15165250821211493*c5 - s5*h5_x;
    const puma560_full_real t6 = -c5;
    const puma560_full_real fu4_z_2 = t6*h5_x - 0.15165250821211493*s5;
    /* link 4: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu4_x = c5*k5_xz - s5*k5_yz;
    const puma560_full_real nu4_z_2 = s5*k5_xz + c5*k5_yz;
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_2 = c4*fu4_x_2;
    const puma560_full_real fu3_z = s4*fu4_x_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu3_x = c4*neg_nu4_x + s4*m5_5 + 0.4331*fu3_z;
    const puma560_full_real nu3_y_2 = 0.0203*fu3_z - nu4_z_2;
    const puma560_full_real nu3_z_2 = 0.0203*fu4_z_2 + 0.4331*fu3_x_2 - (s4*neg_nu4_x - c4*m5_5);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_2 = c3*fu3_x_2 + s3*fu4_z_2;
    const puma560_full_real fu2_y_2 = s3*fu3_x_2 - c3*fu4_z_2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x_2 = c3*neg_nu3_x + s3*nu3_y_2;
    const puma560_full_real nu2_y_2 = -0.4318*fu3_z - (s3*neg_nu3_x - c3*nu3_y_2);
    const puma560_full_real nu2_z_2 = nu3_z_2 + 0.4318*fu2_y_2;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_2 = c2*fu2_x_2 - s2*fu2_y_2;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_2 = s2*neg_nu2_x_2 - c2*nu2_y_2 - 0.1501*fu1_x_2;
    const puma560_full_real t7 = c5*c5;
    const puma560_full_real t8 = t5 + 0.1976234181078441;
    const puma560_full_real t9 = c5*s5;
    const puma560_full_real t10 = t7*t8 - k5_xy*(2.0*t9);
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_zz = k5_xx - t10;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h4_x = 0.7777930398944852 - fu4_z_2;
    const puma560_full_real h4_y = 0.8719880516308344 - fu5_x;
    /* link 4: second moment of the composite body [kg m^2] */
    const puma560_full_real k4_xx = t10 + 0.7374388019750071;
    const puma560_full_real k4_yy = 0.7502906175782786 - t5;
    const puma560_full_real k4_xy = neg_nu4_x + 0.05337162017689789;
    const puma560_full_real k4_xz = 0.2837491060266096 - (t8*t9 - k5_xy*(1.0 - 2.0*t7));
    const puma560_full_real k4_yz = 0.10734691974802549 - nu4_z_2;
    /* link 4: mass matrix, its row of this joint */
    const puma560_full_real m4_4 = 1.4877294195532857 - (t5 - t10);
    /* link 3: force for a unit acceleration of a joint further out */
    const puma560_full_real fu3_x_3 = -(c4*h4_y) - s4*h4_x;
    const puma560_full_real fu3_z_2 = c4*h4_x - s4*h4_y;
    const puma560_full_real t11 = s4*k4_yz - c4*k4_xz;
    const puma560_full_real t12 = 0.4331*fu3_z_2;
    /* link 3: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu3_x_2 = t11 - t12;
    const puma560_full_real nu3_y_3 = 0.0203*fu3_z_2 - m4_4;
    const puma560_full_real nu3_z_3 = t2*k4_xz - c4*k4_yz + 0.4331*fu3_x_3;
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_3 = c3*fu3_x_3;
    const puma560_full_real fu2_y_3 = s3*fu3_x_3;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu2_x = c3*nu3_x_2 - s3*nu3_y_3;
    const puma560_full_real nu2_y_3 = s3*nu3_x_2 + c3*nu3_y_3 - 0.4318*fu3_z_2;
    const puma560_full_real nu2_z_3 = nu3_z_3 + 0.4318*fu2_y_3;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_3 = c2*fu2_x_3 - s2*fu2_y_3;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_3 = -0.1501*fu1_x_3 - (s2*nu2_x + c2*nu2_y_3);
    const puma560_full_real t13 = c4*c4;
    const puma560_full_real t14 = t5 + t10 - 0.012851815603271595;
    const puma560_full_real t15 = c4*s4;
    const puma560_full_real t16 = t13*t14 - k4_xy*(2.0*t15);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_zz = k4_xx - t16;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h3_x = fu3_z_2 + 1.046378600789203;
    const puma560_full_real neg_h3_y = fu4_x_2 + 5.729293810689829;
    const puma560_full_real t17 = 0.0406*fu3_z_2 - (k4_yy + t16);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_full_real k3_xx = 0.47176417886368593 - t17;
    const puma560_full_real t18 = k4_zz + 0.8662*fu4_x_2;
    const puma560_full_real k3_yy = t18 + 3.4805327967608957;
    const puma560_full_real k3_xy = t11 + 0.0203*fu4_x_2 - t12 + 0.28615890025504537;
    const puma560_full_real k3_xz = t14*t15 - k4_xy*(1.0 - 2.0*t13) + 0.0203*fu3_x_3 +
        0.01894848286257894;
    const puma560_full_real k3_yz = nu3_z_3 + 0.060845712710754084;
    /* link 3: mass matrix, its row of this joint */
    const puma560_full_real m3_3 = 3.9522969756245816 - (t17 - t18);
    /* link 2: force for a unit acceleration of a joint further out */
    const puma560_full_real fu2_x_4 = c3*neg_h3_y - s3*h3_x;
    const puma560_full_real fu2_y_4 = s3*neg_h3_y + c3*h3_x;
    /* link 2: moment for a unit acceleration of a joint further out */
    const puma560_full_real neg_nu2_x_3 = c3*k3_xz - s3*k3_yz;
    const puma560_full_real nu2_y_4 = -(s3*k3_xz) - c3*k3_yz;
    const puma560_full_real nu2_z_4 = m3_3 + 0.4318*fu2_y_4;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_4 = c2*fu2_x_4 - s2*fu2_y_4;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_4 = s2*neg_nu2_x_3 - c2*nu2_y_4 - 0.1501*fu1_x_4;
    const puma560_full_real t19 = c3*c3;
    const puma560_full_real t20 = t17 + t18 + 3.0087686178972097;
    const puma560_full_real t21 = c3*s3;
    const puma560_full_real t22 = t19*t20 + k3_xy*(2.0*t21);
    const puma560_full_real t23 = k3_xx + t22;
    const puma560_full_real t24 = k3_zz - t23;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_zz = t23 + t24;
    /* link 2: first moment of the composite body, about the frame's origin [kg m] */
    const puma560_full_real h2_x = fu2_y_4 + 7.6631781603519995;
    const puma560_full_real neg_h2_y = fu2_x_4 - 0.1606745919581151;
    const puma560_full_real t25 = k3_zz - t24;
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_full_real k2_yy = t25 + 0.20730445403579364;
    const puma560_full_real k2_xy = 0.1174059800416141 - (t20*t21 + k3_xy*(1.0 - 2.0*t19) +
        0.4318*fu2_x_4);
    const puma560_full_real k2_xz = neg_nu2_x_3 - 0.4318*fu3_x_3 + 0.017097472943757824;
    const puma560_full_real k2_yz = 0.0507946745483177 - nu2_y_4;
    const puma560_full_real t26 = k3_yy - t22 + 0.8636*fu2_y_4;
    /* link 2: mass matrix, its row of this joint */
    const puma560_full_real m2_2 = t25 + t26 + 3.7298822532370677;
    /* link 1: force for a unit acceleration of a joint further out */
    const puma560_full_real fu1_x_5 = c2*neg_h2_y - s2*h2_x;
    /* link 1: moment for a unit acceleration of a joint further out */
    const puma560_full_real nu1_z_5 = s2*k2_xz + c2*k2_yz - 0.1501*fu1_x_5;
    const puma560_full_real t27 = k2_yy - (c2*c2*(t25 - t26 - 3.31527334516548) +
        k2_xy*(2.0*(c2*s2))) + (k2_zz - 0.3002*fu3_x_3);
    /* link 1: mass matrix, its row of this joint */
    const puma560_full_real m1_1 = t27 + 2.629303206180387;
    /* sines and cosines of the joint angles */
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
    const puma560_full_real t28 = -qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_full_real w3_x = t28*s23;
    const puma560_full_real w3_y = t28*c23;
    const puma560_full_real t29 = 0.4318*neg_lam2_11;
    const puma560_full_real t30 = 0.4318*ww2_xy;
    const puma560_full_real t31 = c2*t29 + s2*t30;
    const puma560_full_real t32 = s2*t29 - c2*t30 + 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a3_x = c23*t31 + s23*t32;
    const puma560_full_real a3_y = s23*t31 - c23*t32;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_full_real alpha3_x = w3_z*w3_y;
    const puma560_full_real t33 = -w3_z;
    const puma560_full_real alpha3_y = t33*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_full_real ww3_xy = w3_x*w3_y;
    const puma560_full_real ww3_xx = w3_x*w3_x;
    const puma560_full_real ww3_yy = w3_y*w3_y;
    const puma560_full_real neg_ww3_zz = t33*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_full_real lam3_11 = neg_ww3_zz - ww3_yy;
    const puma560_full_real lam3_22 = neg_ww3_zz - ww3_xx;
    const puma560_full_real lam3_33 = -ww3_xx - ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a4_z = 0.0203*ww3_xy + 0.4331*lam3_22 - a3_y;
    /* link 4: angular velocity [rad/s] */
    const puma560_full_real w4_x = c4*w3_x + s4*w3_z;
    const puma560_full_real w4_y = c4*w3_z - s4*w3_x;
    const puma560_full_real t34 = neg_a3_x + (0.0203*lam3_11 + 0.4331*ww3_xy);
    const puma560_full_real t35 = 0.8662*alpha3_x - 0.0406*alpha3_y - a3_z;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real neg_a4_x = c4*t34 + s4*t35;
    const puma560_full_real a4_y = s4*t34 - c4*t35;
    /* link 4: angular acceleration [rad/s^2] */
    const puma560_full_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const puma560_full_real alpha4_y = t2*alpha3_x - qd[3]*w4_x;
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
    const puma560_full_real w5_y = t1*w4_x - c5*w4_z;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a5_x = t6*neg_a4_x - s5*a4_z;
    const puma560_full_real a5_y = s5*neg_a4_x - c5*a4_z;
    /* link 5: angular acceleration [rad/s^2] */
    const puma560_full_real alpha5_x = qd[4]*w5_y - (t6*alpha4_x - s5*alpha3_y);
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
    const puma560_full_real lam5_31 = ww5_zx - alpha5_y;
    const puma560_full_real lam5_32 = alpha5_x + ww5_yz;
    const puma560_full_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const puma560_full_real w6_x = c6*w5_x + s6*w5_z;
    const puma560_full_real w6_y = c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const puma560_full_real a6_x = c6*a5_x + s6*a4_y;
    const puma560_full_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const puma560_full_real alpha6_x = qd[5]*w6_y - (-c6*alpha5_x - s6*alpha4_y);
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
    const puma560_full_real lam6_31 = ww6_zx - alpha6_y;
    const puma560_full_real lam6_32 = alpha6_x + ww6_yz;
    const puma560_full_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: force that moves the link [N] */
    const puma560_full_real fc2_x = 0.1606745919581151*ww2_xy - 7.6631781603519995*neg_lam2_11;
    const puma560_full_real fc2_y = 7.6631781603519995*ww2_xy - 0.1606745919581151*neg_lam2_22;
    /* link 2: moment that turns the link [N m] */
    const puma560_full_real neg_nc2_x = 0.4146089080715873*neg_alpha2_x -
        0.0507946745483177*(neg_lam2_22 - neg_lam2_33) + (0.2348119600832282*alpha2_y +
        0.017097472943757824*ww2_xy) + 0.024117256252913073*ww1_zz;
    const puma560_full_real nc2_y = 7.045155598402548*alpha2_y - 0.017097472943757824*(neg_lam2_11 -
        neg_lam2_33) + (0.0507946745483177*ww2_xy + 0.2348119600832282*neg_alpha2_x) +
        1.1502430418688352*ww1_zz;
    const puma560_full_real nc2_z = 3.31527334516548*ww2_xy + 0.1174059800416141*(neg_lam2_11 -
        neg_lam2_22) - (75.09914597144959*c2 - 1.5746110011895278*s2);
    /* link 3: force that moves the link [N] */
    const puma560_full_real fc3_x = 1.046378600789203*lam3_11 - 5.729293810689829*ww3_xy;
    const puma560_full_real fc3_y = 1.046378600789203*ww3_xy - 5.729293810689829*lam3_22;
    const puma560_full_real fc3_z = -11.458587621379658*alpha3_x - 2.092757201578406*alpha3_y;
    /* link 3: moment that turns the link [N m] */
    const puma560_full_real nc3_x = -5.729293810689829*a3_z - (-6.961065593521791*alpha3_x -
        0.060845712710754084*(lam3_33 - lam3_22) + (0.5723178005100907*alpha3_y +
        0.01894848286257894*ww3_xy));
    const puma560_full_real nc3_y = 0.9435283577273719*alpha3_y - 0.01894848286257894*(lam3_33 -
        lam3_11) + (0.060845712710754084*ww3_xy - 0.5723178005100907*alpha3_x) -
        1.046378600789203*a3_z;
    const puma560_full_real nc3_z = 1.046378600789203*a3_y - 5.729293810689829*neg_a3_x -
        (3.0087686178972097*ww3_xy - 0.28615890025504537*(lam3_22 - lam3_11));
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
    const puma560_full_real t36 = 0.2788425785236688*lam4_12 - 0.3473260245772809*lam4_21 -
        0.05337162017689789*(neg_lam4_11 - neg_lam4_22) - (0.2837491060266096*lam4_23 -
        0.10734691974802549*lam4_13);
    const puma560_full_real nc4_z = 0.7777930398944852*a4_y + 0.8719880516308344*neg_a4_x - t36;
    /* link 5: force that moves the link [N] */
    const puma560_full_real fc5_x = 0.47660058733283606*neg_lam5_11 - 0.15165250821211493*lam5_12;
    const puma560_full_real fc5_y = 0.15165250821211493*neg_lam5_22 - 0.47660058733283606*lam5_21;
    const puma560_full_real fc5_z = -0.47660058733283606*lam5_31 - 0.15165250821211493*lam5_32;
    /* link 5: moment that turns the link [N m] */
    const puma560_full_real neg_nc5_x = 0.18116108322165295*(neg_lam5_22 - neg_lam5_33) -
        0.3901127773977262*lam5_32 + (-0.08058935149735619*lam5_31 - 0.1558184212675505*lam5_21) +
        0.15165250821211493*a4_y;
    const puma560_full_real nc5_y = 0.1558184212675505*(neg_lam5_11 - neg_lam5_33) -
        0.1513642331069161*lam5_31 + (-0.18116108322165295*lam5_12 - 0.08058935149735619*lam5_32) +
        0.47660058733283606*a4_y;
    const puma560_full_real t37 = 0.1513642331069161*lam5_21 - 0.3901127773977262*lam5_12 +
        0.08058935149735619*(neg_lam5_11 - neg_lam5_22) - (0.1558184212675505*lam5_23 -
        0.18116108322165295*lam5_13);
    const puma560_full_real nc5_z = t37 - (0.47660058733283606*a5_y - 0.15165250821211493*a5_x);
    /* link 6: force that moves the link [N] */
    const puma560_full_real fc6_x = 1.1185374890947408*neg_lam6_11 + 1.2975168001325401*lam6_12;
    const puma560_full_real fc6_y = -1.2975168001325401*neg_lam6_22 - 1.1185374890947408*lam6_21;
    const puma560_full_real fc6_z = 1.2975168001325401*lam6_32 - 1.1185374890947408*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const puma560_full_real nc6_x = -1.2975168001325401*a5_y - (0.2519035474197792*(neg_lam6_22 -
        neg_lam6_33) - 0.43637196239865417*lam6_32 - (-0.4019452224328564*lam6_31 -
        0.1902613160848803*lam6_21));
    const puma560_full_real nc6_y = -0.4714480390546099*lam6_31 - 0.1902613160848803*(neg_lam6_11 -
        neg_lam6_33) - (0.2519035474197792*lam6_12 - 0.4019452224328564*lam6_32) -
        1.1185374890947408*a5_y;
    const puma560_full_real t38 = 0.43637196239865417*lam6_12 - 0.4714480390546099*lam6_21 +
        0.4019452224328564*(neg_lam6_11 - neg_lam6_22) - (0.1902613160848803*lam6_23 +
        0.2519035474197792*lam6_13);
    const puma560_full_real neg_nc6_z = t38 + (1.1185374890947408*a6_y + 1.2975168001325401*a6_x);
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
    const puma560_full_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n04_x = c4*n4_x - s4*n4_y;
    const puma560_full_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n3_x = n04_x + (nc3_x - 0.4331*f04_y);
    const puma560_full_real n3_y = nc3_y + 0.0203*f04_y - n4_z;
    const puma560_full_real n3_z = n04_y - (-0.0203*f4_z - 0.4331*f04_x - nc3_z);
    /* link 3: force through the joint [N] */
    const puma560_full_real f3_x = fc3_x + f04_x;
    const puma560_full_real f3_y = fc3_y - f4_z;
    const puma560_full_real f3_z = fc3_z + f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f03_x = c23*f3_x - s23*f3_y;
    const puma560_full_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n03_y = s23*n3_x + c23*n3_y;
    const puma560_full_real t39 = 0.4318*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_full_real n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + f3_z*t39);
    const puma560_full_real n02_z = n3_z + (nc2_z - (f03_x*(0.4318*s2) - f03_y*t39));
    /* link 2: force through the joint, along the axes that its turn starts from [N] */
    const puma560_full_real f02_x = f03_x - (s2*fc2_y - c2*fc2_x);
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_full_real n1_z = -0.1501*f02_x - n02_y;
    /* link 1: forward substitution */
    const puma560_full_real y1 = tau[0] - n1_z;
    /* factorisation M = L D L^T */
    const puma560_full_real ipivot1 = 1.0 / m1_1;
    const puma560_full_real l2_1 = nu1_z_5*ipivot1;
    const puma560_full_real l3_1 = nu1_z_4*ipivot1;
    const puma560_full_real l4_1 = nu1_z_3*ipivot1;
    const puma560_full_real l5_1 = nu1_z_2*ipivot1;
    const puma560_full_real l6_1 = nu1_z*ipivot1;
    const puma560_full_real pivot2 = m2_2 - nu1_z_5*l2_1;
    const puma560_full_real ipivot2 = 1.0 / pivot2;
    const puma560_full_real ld3_2 = nu2_z_4 - nu1_z_5*l3_1;
    const puma560_full_real l3_2 = ipivot2*ld3_2;
    const puma560_full_real ld4_2 = nu2_z_3 - nu1_z_5*l4_1;
    const puma560_full_real l4_2 = ipivot2*ld4_2;
    const puma560_full_real ld5_2 = nu2_z_2 - nu1_z_5*l5_1;
    const puma560_full_real l5_2 = ipivot2*ld5_2;
    const puma560_full_real ld6_2 = nu2_z - nu1_z_5*l6_1;
    const puma560_full_real l6_2 = ipivot2*ld6_2;
    const puma560_full_real pivot3 = m3_3 - nu1_z_4*l3_1 - ld3_2*l3_2;
    const puma560_full_real ipivot3 = 1.0 / pivot3;
    const puma560_full_real ld4_3 = nu3_z_3 - nu1_z_4*l4_1 - ld3_2*l4_2;
    const puma560_full_real l4_3 = ipivot3*ld4_3;
    const puma560_full_real ld5_3 = nu3_z_2 - nu1_z_4*l5_1 - ld3_2*l5_2;
    const puma560_full_real l5_3 = ipivot3*ld5_3;
    const puma560_full_real ld6_3 = nu3_z - nu1_z_4*l6_1 - ld3_2*l6_2;
    const puma560_full_real l6_3 = ipivot3*ld6_3;
    const puma560_full_real pivot4 = -ld4_3*l4_3 - (nu1_z_3*l4_1 - m4_4 + ld4_2*l4_2);
    const puma560_full_real ipivot4 = 1.0 / pivot4;
    const puma560_full_real ld5_4 = nu4_z_2 - nu1_z_3*l5_1 - ld4_2*l5_2 - ld4_3*l5_3;
    const puma560_full_real l5_4 = ipivot4*ld5_4;
    const puma560_full_real ld6_4 = nu4_z - nu1_z_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3;
    const puma560_full_real l6_4 = ipivot4*ld6_4;
    const puma560_full_real pivot5 = m5_5 - nu1_z_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const puma560_full_real ipivot5 = 1.0 / pivot5;
    const puma560_full_real ld6_5 = -ld5_4*l6_4 - (nu1_z_2*l6_1 - nu5_z + ld5_2*l6_2 + ld5_3*l6_3);
    const puma560_full_real l6_5 = ipivot5*ld6_5;
    const puma560_full_real pivot6 = -ld6_4*l6_4 - (nu1_z*l6_1 - 0.907820001453264 + ld6_2*l6_2 +
        ld6_3*l6_3) - ld6_5*l6_5;
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
    const puma560_full_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_full_real qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5);
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
