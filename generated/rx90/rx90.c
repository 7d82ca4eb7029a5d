/*
 * rx90: Staubli RX90 geometry, random full inertias
 * Numbers: published RX90 geometry; inertial parameters drawn at random
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
 *   inverse_dynamics: 240 multiplications, 227 additions = 467; 3 unary minus; 10 sine/cosine
 *   gravity: 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine
 *   bias: 227 multiplications, 198 additions = 425; 6 unary minus; 10 sine/cosine
 *   mass_matrix: 125 multiplications, 108 additions = 233; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 436 multiplications, 376 additions, 6 divisions = 818; 12 unary minus; 10
 *       sine/cosine
 */
#include "rx90.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 240 multiplications, 227 additions = 467; 3 unary minus; 10 sine/cosine */
void rx90_inverse_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real qdd[6],
    rx90_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile rx90_real *const again = q;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(again[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(again[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(again[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(again[5]);
    const volatile rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_z = qdd[1] + qdd[2];
    /* link 2: angular velocity [rad/s] */
    const rx90_real w2_x = qd[0]*s2;
    const rx90_real w2_y = qd[0]*c2;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_yz = qd[1]*w2_y;
    const rx90_real ww2_zx = qd[1]*w2_x;
    /* link 2: angular acceleration [rad/s^2] */
    const rx90_real alpha2_x = qdd[0]*s2 + ww2_yz;
    const rx90_real alpha2_y = qdd[0]*c2 - ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_xy = w2_x*w2_y;
    const rx90_real ww2_xx = w2_x*w2_x;
    const rx90_real ww2_yy = w2_y*w2_y;
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam2_11 = ww2_yy + ww2_zz;
    const rx90_real lam2_12 = ww2_xy - qdd[1];
    const rx90_real lam2_13 = ww2_zx + alpha2_y;
    const rx90_real lam2_21 = qdd[1] + ww2_xy;
    const rx90_real neg_lam2_22 = ww2_xx + ww2_zz;
    const rx90_real lam2_23 = ww2_yz - alpha2_x;
    const rx90_real lam2_31 = ww2_zx - alpha2_y;
    const rx90_real lam2_32 = ww2_yz + alpha2_x;
    const rx90_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = qd[0]*s23;
    const rx90_real w3_y = qd[0]*c23;
    const rx90_real t1 = 0.45*neg_lam2_11;
    const rx90_real t2 = 0.45*lam2_21;
    const rx90_real t3 = c2*t1 + s2*t2;
    const rx90_real t4 = s2*t1 - c2*t2 - 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real neg_a3_x = c23*t3 + s23*t4;
    const rx90_real a3_y = s23*t3 - c23*t4;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_yz = w3_z*w3_y;
    const rx90_real ww3_zx = w3_z*w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_x = qdd[0]*s23 + ww3_yz;
    const rx90_real alpha3_y = qdd[0]*c23 - ww3_zx;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_xx = w3_x*w3_x;
    const rx90_real ww3_yy = w3_y*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_11 = ww3_yy + ww3_zz;
    const rx90_real lam3_12 = ww3_xy - alpha3_z;
    const rx90_real lam3_13 = ww3_zx + alpha3_y;
    const rx90_real lam3_21 = alpha3_z + ww3_xy;
    const rx90_real neg_lam3_22 = ww3_xx + ww3_zz;
    const rx90_real lam3_23 = ww3_yz - alpha3_x;
    const rx90_real lam3_31 = ww3_zx - alpha3_y;
    const rx90_real lam3_32 = ww3_yz + alpha3_x;
    const rx90_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_z = a3_y - 0.45*neg_lam3_22;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = c4*w3_x - s4*w3_z;
    const rx90_real w4_y = -c4*w3_z - s4*w3_x;
    const rx90_real t5 = 0.45*(lam2_31 + lam3_32);
    const rx90_real t6 = neg_a3_x - 0.45*lam3_12;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_x = -s4*t5 - c4*t6;
    const rx90_real a4_y = s4*t6 - c4*t5;
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = c4*alpha3_x - s4*alpha3_z + qd[3]*w4_y;
    const rx90_real neg_alpha4_y = s4*alpha3_x + c4*alpha3_z + qd[3]*w4_x;
    const rx90_real alpha4_z = qdd[3] + alpha3_y;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_z = qd[3] + w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real ww4_yz = w4_y*w4_z;
    const rx90_real ww4_zx = w4_x*w4_z;
    const rx90_real ww4_xy = w4_x*w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_yy = w4_y*w4_y;
    const rx90_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam4_11 = ww4_yy + ww4_zz;
    const rx90_real lam4_12 = ww4_xy - alpha4_z;
    const rx90_real lam4_13 = ww4_zx - neg_alpha4_y;
    const rx90_real lam4_21 = alpha4_z + ww4_xy;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    const rx90_real lam4_23 = ww4_yz - alpha4_x;
    const rx90_real lam4_31 = neg_alpha4_y + ww4_zx;
    const rx90_real lam4_32 = alpha4_x + ww4_yz;
    const rx90_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = c5*w4_x + s5*w4_z;
    const rx90_real w5_y = c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a5_x = c5*a4_x + s5*a4_z;
    const rx90_real a5_y = c5*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x + s5*alpha4_z + qd[4]*w5_y;
    const rx90_real neg_alpha5_y = s5*alpha4_x - c5*alpha4_z + qd[4]*w5_x;
    const rx90_real alpha5_z = qdd[4] + neg_alpha4_y;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_yz = w5_y*w5_z;
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xy = w5_x*w5_y;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_yy = w5_y*w5_y;
    const rx90_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam5_11 = ww5_yy + ww5_zz;
    const rx90_real lam5_12 = ww5_xy - alpha5_z;
    const rx90_real lam5_13 = ww5_zx - neg_alpha5_y;
    const rx90_real lam5_21 = alpha5_z + ww5_xy;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real lam5_31 = neg_alpha5_y + ww5_zx;
    const rx90_real lam5_32 = alpha5_x + ww5_yz;
    const rx90_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_x = c6*w5_x - s6*w5_z;
    const rx90_real w6_y = -c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a6_x = c6*a5_x + s6*a4_y;
    const rx90_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const rx90_real alpha6_x = c6*alpha5_x - s6*alpha5_z + qd[5]*w6_y;
    const rx90_real neg_alpha6_y = s6*alpha5_x + c6*alpha5_z + qd[5]*w6_x;
    const rx90_real alpha6_z = qdd[5] - neg_alpha5_y;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_yz = w6_y*w6_z;
    const rx90_real ww6_zx = w6_x*w6_z;
    const rx90_real ww6_xy = w6_x*w6_y;
    const rx90_real ww6_xx = w6_x*w6_x;
    const rx90_real ww6_yy = w6_y*w6_y;
    const rx90_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam6_11 = ww6_yy + ww6_zz;
    const rx90_real lam6_12 = ww6_xy - alpha6_z;
    const rx90_real lam6_13 = ww6_zx - neg_alpha6_y;
    const rx90_real lam6_21 = alpha6_z + ww6_xy;
    const rx90_real neg_lam6_22 = ww6_xx + ww6_zz;
    const rx90_real neg_lam6_23 = alpha6_x - ww6_yz;
    const rx90_real lam6_31 = neg_alpha6_y + ww6_zx;
    const rx90_real lam6_32 = alpha6_x + ww6_yz;
    const rx90_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 1: moment that turns the link [N m] */
    const rx90_real nc1_z = 0.6379688079078735*qdd[0];
    /* link 2: moment that turns the link [N m] */
    const rx90_real nc2_x = 0.5492245200976821*lam2_32 + 0.09496171507178643*(neg_lam2_22 -
        neg_lam2_33) + (0.3355665158971724*lam2_31 - 0.017315109477737248*lam2_21);
    const rx90_real nc2_y = 0.09496171507178643*lam2_12 - 0.3355665158971724*lam2_32 -
        (4.645960113642152*lam2_31 + 0.017315109477737248*(neg_lam2_11 - neg_lam2_33));
    const rx90_real t7 = 4.645960113642152*lam2_21 - 0.5492245200976821*lam2_12 +
        0.3355665158971724*(neg_lam2_11 - neg_lam2_22) + (0.017315109477737248*lam2_23 -
        0.09496171507178643*lam2_13);
    const rx90_real nc2_z = t7 + (81.05525857884084*c2 + 17.30463777489202*s2);
    /* link 3: force that moves the link [N] */
    const rx90_real fc3_x = 0.4001573159217507*neg_lam3_11 + 9.392800548482231*lam3_12;
    const rx90_real fc3_y = -9.392800548482231*neg_lam3_22 - 0.4001573159217507*lam3_21;
    const rx90_real fc3_z = 9.392800548482231*lam3_32 - 0.4001573159217507*lam3_31;
    /* link 3: moment that turns the link [N m] */
    const rx90_real nc3_x = 5.396088354585412*lam3_32 + 0.0672049454639226*(neg_lam3_22 -
        neg_lam3_33) + (0.06558551272001446*lam3_31 - 0.1093030288471206*lam3_21) +
        4.226760246817004*lam2_31;
    const rx90_real nc3_y = 0.1800707921647878*lam2_31 - (0.19252101484679798*lam3_31 +
        0.1093030288471206*(neg_lam3_11 - neg_lam3_33) + (0.06558551272001446*lam3_32 -
        0.0672049454639226*lam3_12));
    const rx90_real t8 = 0.19252101484679798*lam3_21 - 5.396088354585412*lam3_12 +
        0.06558551272001446*(neg_lam3_11 - neg_lam3_22) + (0.1093030288471206*lam3_23 -
        0.0672049454639226*lam3_13);
    const rx90_real nc3_z = t8 - (0.4001573159217507*a3_y - 9.392800548482231*neg_a3_x);
    /* link 4: force that moves the link [N] */
    const rx90_real fc4_x = 1.0765039731522932*lam4_12 - 0.21759393385311085*neg_lam4_11;
    const rx90_real fc4_y = 0.21759393385311085*lam4_21 - 1.0765039731522932*neg_lam4_22;
    const rx90_real fc4_z = 0.21759393385311085*lam4_31 + 1.0765039731522932*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const rx90_real nc4_x = 0.7570061710726514*lam4_32 + 0.02981305527252843*(neg_lam4_22 -
        neg_lam4_33) + (0.09181695932507075*lam4_31 - 0.1094831940191231*lam4_21) +
        1.0765039731522932*a4_z;
    const rx90_real nc4_y = -0.21759393385311085*a4_z - (0.1886810537096668*lam4_31 +
        0.1094831940191231*(neg_lam4_11 - neg_lam4_33) + (0.09181695932507075*lam4_32 -
        0.02981305527252843*lam4_12));
    const rx90_real t9 = 0.1886810537096668*lam4_21 - 0.7570061710726514*lam4_12 +
        0.09181695932507075*(neg_lam4_11 - neg_lam4_22) - (0.02981305527252843*lam4_13 -
        0.1094831940191231*lam4_23);
    const rx90_real nc4_z = t9 + (0.21759393385311085*a4_y - 1.0765039731522932*a4_x);
    /* link 5: force that moves the link [N] */
    const rx90_real fc5_x = 0.8974188745594792*neg_lam5_11 + 0.8067444135457743*lam5_12;
    const rx90_real fc5_y = -0.8067444135457743*neg_lam5_22 - 0.8974188745594792*lam5_21;
    const rx90_real fc5_z = 0.8067444135457743*lam5_32 - 0.8974188745594792*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const rx90_real nc5_x = 0.09969734753381411*lam5_32 + 0.06545842652927093*(neg_lam5_22 -
        neg_lam5_33) - (0.04994749004669093*lam5_31 + 0.022422989561630666*lam5_21) -
        0.8067444135457743*a4_y;
    const rx90_real neg_nc5_y = 0.4973859781056681*lam5_31 + 0.022422989561630666*(neg_lam5_11 -
        neg_lam5_33) + (-0.06545842652927093*lam5_12 - 0.04994749004669093*lam5_32) +
        0.8974188745594792*a4_y;
    const rx90_real t10 = 0.4973859781056681*lam5_21 - 0.09969734753381411*lam5_12 -
        0.04994749004669093*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093*lam5_13 -
        0.022422989561630666*lam5_23);
    const rx90_real nc5_z = t10 - (0.8974188745594792*a5_y + 0.8067444135457743*a5_x);
    /* link 6: force that moves the link [N] */
    const rx90_real fc6_x = 1.5707678306756712*neg_lam6_11 + 0.6271000643521031*lam6_12;
    const rx90_real fc6_y = -0.6271000643521031*neg_lam6_22 - 1.5707678306756712*lam6_21;
    const rx90_real fc6_z = 0.6271000643521031*lam6_32 - 1.5707678306756712*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_x = 0.13354610634435332*lam6_32 + 0.07096581179296485*(neg_lam6_22 -
        neg_lam6_33) - (0.13821978029399798*lam6_31 - 0.1601275610650136*lam6_21) +
        0.6271000643521031*a5_y;
    const rx90_real nc6_y = 1.5707678306756712*a5_y - (0.4436030328765257*lam6_31 -
        0.1601275610650136*(neg_lam6_11 - neg_lam6_33) + (-0.07096581179296485*lam6_12 -
        0.13821978029399798*lam6_32));
    const rx90_real t11 = 0.4436030328765257*lam6_21 - 0.13354610634435332*lam6_12 -
        0.13821978029399798*(neg_lam6_11 - neg_lam6_22) + (0.1601275610650136*neg_lam6_23 -
        0.07096581179296485*lam6_13);
    const rx90_real nc6_z = t11 - (1.5707678306756712*a6_y + 0.6271000643521031*a6_x);
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f06_x = c6*fc6_x - s6*fc6_y;
    const rx90_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n06_x = c6*nc6_x - s6*nc6_y;
    const rx90_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_x = nc5_x + n06_x;
    const rx90_real n5_y = nc6_z - neg_nc5_y;
    const rx90_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const rx90_real f5_x = fc5_x + f06_x;
    const rx90_real f5_y = fc5_y + fc6_z;
    const rx90_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f05_x = c5*f5_x - s5*f5_y;
    const rx90_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n05_x = c5*n5_x - s5*n5_y;
    const rx90_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_x = nc4_x + n05_x;
    const rx90_real n4_y = nc4_y - n5_z;
    const rx90_real n4_z = nc4_z + n05_y;
    /* link 4: force through the joint [N] */
    const rx90_real f4_x = fc4_x + f05_x;
    const rx90_real f4_y = fc4_y - f5_z;
    const rx90_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f04_x = c4*f4_x - s4*f4_y;
    const rx90_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n04_x = c4*n4_x - s4*n4_y;
    const rx90_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = n04_x + (nc3_x - 0.45*f04_y);
    const rx90_real n3_y = nc3_y + n4_z;
    const rx90_real n3_z = nc3_z - 0.45*f04_x - n04_y;
    /* link 3: force through the joint [N] */
    const rx90_real f3_x = fc3_x + f04_x;
    const rx90_real f3_y = fc3_y + f4_z;
    const rx90_real f3_z = fc3_z - f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f03_x = c23*f3_x - s23*f3_y;
    const rx90_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    const rx90_real t12 = 0.45*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_y = n03_y + (s2*nc2_x + c2*nc2_y - f3_z*t12);
    const rx90_real n02_z = n3_z + (nc2_z + (f03_y*t12 - f03_x*(0.45*s2)));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const rx90_real n1_z = nc1_z + n02_y;
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques that hold the arm at rest
 * 42 multiplications, 25 additions = 67; 1 unary minus; 10 sine/cosine */
void rx90_gravity(const rx90_real q[6], rx90_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile rx90_real *const again = q;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(again[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(again[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(again[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(again[5]);
    const volatile rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a3_x = 9.8*s23;
    const rx90_real a3_y = 9.8*c23;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_x = c4*a3_x;
    const rx90_real a4_y = -s4*a3_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a5_x = c5*a4_x + s5*a3_y;
    const rx90_real a5_y = c5*a3_y - s5*a4_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a6_x = c6*a5_x + s6*a4_y;
    const rx90_real a6_y = c6*a4_y - s6*a5_x;
    /* link 2: moment that turns the link [N m] */
    const rx90_real nc2_z = 81.05525857884084*c2 + 17.30463777489202*s2;
    /* link 3: moment that turns the link [N m] */
    const rx90_real nc3_z = -92.04944537512587*s23 - 3.921541696033157*c23;
    /* link 4: moment that turns the link [N m] */
    const rx90_real nc4_x = 10.549738936892474*c23;
    const rx90_real nc4_y = -2.1324205517604864*c23;
    const rx90_real nc4_z = 0.21759393385311085*a4_y - 1.0765039731522932*a4_x;
    /* link 5: moment that turns the link [N m] */
    const rx90_real neg_nc5_x = 0.8067444135457743*a4_y;
    const rx90_real neg_nc5_y = 0.8974188745594792*a4_y;
    const rx90_real nc5_z = -0.8974188745594792*a5_y - 0.8067444135457743*a5_x;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_x = 0.6271000643521031*a5_y;
    const rx90_real nc6_y = 1.5707678306756712*a5_y;
    const rx90_real nc6_z = -1.5707678306756712*a6_y - 0.6271000643521031*a6_x;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n06_x = c6*nc6_x - s6*nc6_y;
    const rx90_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_x = n06_x - neg_nc5_x;
    const rx90_real n5_y = nc6_z - neg_nc5_y;
    const rx90_real n5_z = nc5_z - n06_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n05_x = c5*n5_x - s5*n5_y;
    const rx90_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_x = nc4_x + n05_x;
    const rx90_real n4_y = nc4_y - n5_z;
    const rx90_real n4_z = nc4_z + n05_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n04_x = c4*n4_x - s4*n4_y;
    const rx90_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_z = nc3_z - n04_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n04_x + c23*n4_z;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_z = nc2_z + n3_z;
    tau[0] = n03_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 227 multiplications, 198 additions = 425; 6 unary minus; 10 sine/cosine */
void rx90_bias(const rx90_real q[6], const rx90_real qd[6], rx90_real tau[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile rx90_real *const again = q;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(again[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(again[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(again[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(again[5]);
    const volatile rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* link 2: angular velocity [rad/s] */
    const rx90_real w2_x = qd[0]*s2;
    const rx90_real w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const rx90_real alpha2_x = qd[1]*w2_y;
    const rx90_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_xy = w2_x*w2_y;
    const rx90_real ww2_xx = w2_x*w2_x;
    const rx90_real ww2_yy = w2_y*w2_y;
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam2_11 = ww2_yy + ww2_zz;
    const rx90_real neg_lam2_22 = ww2_xx + ww2_zz;
    const rx90_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = qd[0]*s23;
    const rx90_real w3_y = qd[0]*c23;
    const rx90_real t1 = 0.45*neg_lam2_11;
    const rx90_real t2 = 0.45*ww2_xy;
    const rx90_real t3 = c2*t1 + s2*t2;
    const rx90_real t4 = s2*t1 - c2*t2 - 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real neg_a3_x = c23*t3 + s23*t4;
    const rx90_real a3_y = s23*t3 - c23*t4;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_x = w3_z*w3_y;
    const rx90_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_xx = w3_x*w3_x;
    const rx90_real ww3_yy = w3_y*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_11 = ww3_yy + ww3_zz;
    const rx90_real neg_lam3_22 = ww3_xx + ww3_zz;
    const rx90_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_z = a3_y - 0.45*neg_lam3_22;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = c4*w3_x - s4*w3_z;
    const rx90_real w4_y = -c4*w3_z - s4*w3_x;
    const rx90_real t5 = 0.9*(neg_alpha2_y + alpha3_x);
    const rx90_real t6 = neg_a3_x - 0.45*ww3_xy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_x = -s4*t5 - c4*t6;
    const rx90_real a4_y = s4*t6 - c4*t5;
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const rx90_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_z = qd[3] + w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real ww4_yz = w4_y*w4_z;
    const rx90_real ww4_zx = w4_x*w4_z;
    const rx90_real ww4_xy = w4_x*w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_yy = w4_y*w4_y;
    const rx90_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam4_11 = ww4_yy + ww4_zz;
    const rx90_real lam4_12 = ww4_xy - alpha3_y;
    const rx90_real lam4_13 = alpha4_y + ww4_zx;
    const rx90_real lam4_21 = alpha3_y + ww4_xy;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    const rx90_real lam4_23 = ww4_yz - alpha4_x;
    const rx90_real lam4_31 = ww4_zx - alpha4_y;
    const rx90_real lam4_32 = alpha4_x + ww4_yz;
    const rx90_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = c5*w4_x + s5*w4_z;
    const rx90_real w5_y = c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a5_x = c5*a4_x + s5*a4_z;
    const rx90_real a5_y = c5*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x + s5*alpha3_y + qd[4]*w5_y;
    const rx90_real neg_alpha5_y = s5*alpha4_x - c5*alpha3_y + qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_yz = w5_y*w5_z;
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xy = w5_x*w5_y;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_yy = w5_y*w5_y;
    const rx90_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam5_11 = ww5_yy + ww5_zz;
    const rx90_real lam5_12 = alpha4_y + ww5_xy;
    const rx90_real lam5_13 = ww5_zx - neg_alpha5_y;
    const rx90_real lam5_21 = ww5_xy - alpha4_y;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real lam5_31 = neg_alpha5_y + ww5_zx;
    const rx90_real lam5_32 = alpha5_x + ww5_yz;
    const rx90_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_x = c6*w5_x - s6*w5_z;
    const rx90_real w6_y = -c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real neg_a6_x = -s6*a4_y - c6*a5_x;
    const rx90_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const rx90_real alpha6_x = c6*alpha5_x + s6*alpha4_y + qd[5]*w6_y;
    const rx90_real neg_alpha6_y = s6*alpha5_x - c6*alpha4_y + qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_yz = w6_y*w6_z;
    const rx90_real ww6_zx = w6_x*w6_z;
    const rx90_real ww6_xy = w6_x*w6_y;
    const rx90_real ww6_xx = w6_x*w6_x;
    const rx90_real ww6_yy = w6_y*w6_y;
    const rx90_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam6_11 = ww6_yy + ww6_zz;
    const rx90_real lam6_12 = neg_alpha5_y + ww6_xy;
    const rx90_real lam6_13 = ww6_zx - neg_alpha6_y;
    const rx90_real lam6_21 = ww6_xy - neg_alpha5_y;
    const rx90_real neg_lam6_22 = ww6_xx + ww6_zz;
    const rx90_real neg_lam6_23 = alpha6_x - ww6_yz;
    const rx90_real lam6_31 = neg_alpha6_y + ww6_zx;
    const rx90_real lam6_32 = alpha6_x + ww6_yz;
    const rx90_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: moment that turns the link [N m] */
    const rx90_real nc2_x = 1.0984490401953642*alpha2_x + 0.09496171507178643*(neg_lam2_22 -
        neg_lam2_33) + (0.6711330317943448*neg_alpha2_y - 0.017315109477737248*ww2_xy);
    const rx90_real nc2_y = 0.09496171507178643*ww2_xy - 0.6711330317943448*alpha2_x -
        (9.291920227284304*neg_alpha2_y + 0.017315109477737248*(neg_lam2_11 - neg_lam2_33));
    const rx90_real nc2_z = 4.09673559354447*ww2_xy + 0.3355665158971724*(neg_lam2_11 - neg_lam2_22)
        + (81.05525857884084*c2 + 17.30463777489202*s2);
    /* link 3: force that moves the link [N] */
    const rx90_real fc3_x = 0.4001573159217507*neg_lam3_11 + 9.392800548482231*ww3_xy;
    const rx90_real fc3_y = -9.392800548482231*neg_lam3_22 - 0.4001573159217507*ww3_xy;
    const rx90_real fc3_z = 0.8003146318435014*alpha3_y + 18.785601096964463*alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const rx90_real nc3_x = 10.792176709170825*alpha3_x + 0.0672049454639226*(neg_lam3_22 -
        neg_lam3_33) + (-0.13117102544002893*alpha3_y - 0.1093030288471206*ww3_xy) +
        8.453520493634008*neg_alpha2_y;
    const rx90_real nc3_y = 0.3601415843295756*neg_alpha2_y - (0.1093030288471206*(neg_lam3_11 -
        neg_lam3_33) - 0.38504202969359597*alpha3_y - (0.0672049454639226*ww3_xy -
        0.13117102544002893*alpha3_x));
    const rx90_real nc3_z = 9.392800548482231*neg_a3_x - 0.4001573159217507*a3_y -
        (5.203567339738615*ww3_xy - 0.06558551272001446*(neg_lam3_11 - neg_lam3_22));
    /* link 4: force that moves the link [N] */
    const rx90_real fc4_x = 1.0765039731522932*lam4_12 - 0.21759393385311085*neg_lam4_11;
    const rx90_real fc4_y = 0.21759393385311085*lam4_21 - 1.0765039731522932*neg_lam4_22;
    const rx90_real fc4_z = 0.21759393385311085*lam4_31 + 1.0765039731522932*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const rx90_real nc4_x = 0.7570061710726514*lam4_32 + 0.02981305527252843*(neg_lam4_22 -
        neg_lam4_33) + (0.09181695932507075*lam4_31 - 0.1094831940191231*lam4_21) +
        1.0765039731522932*a4_z;
    const rx90_real nc4_y = -0.21759393385311085*a4_z - (0.1886810537096668*lam4_31 +
        0.1094831940191231*(neg_lam4_11 - neg_lam4_33) - (0.02981305527252843*lam4_12 -
        0.09181695932507075*lam4_32));
    const rx90_real t7 = 0.7570061710726514*lam4_12 - 0.1886810537096668*lam4_21 -
        0.09181695932507075*(neg_lam4_11 - neg_lam4_22) + (0.02981305527252843*lam4_13 -
        0.1094831940191231*lam4_23);
    const rx90_real nc4_z = 0.21759393385311085*a4_y - 1.0765039731522932*a4_x - t7;
    /* link 5: force that moves the link [N] */
    const rx90_real fc5_x = 0.8974188745594792*neg_lam5_11 + 0.8067444135457743*lam5_12;
    const rx90_real fc5_y = -0.8067444135457743*neg_lam5_22 - 0.8974188745594792*lam5_21;
    const rx90_real fc5_z = 0.8067444135457743*lam5_32 - 0.8974188745594792*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const rx90_real nc5_x = 0.09969734753381411*lam5_32 + 0.06545842652927093*(neg_lam5_22 -
        neg_lam5_33) - (0.04994749004669093*lam5_31 + 0.022422989561630666*lam5_21) -
        0.8067444135457743*a4_y;
    const rx90_real neg_nc5_y = 0.4973859781056681*lam5_31 + 0.022422989561630666*(neg_lam5_11 -
        neg_lam5_33) + (-0.06545842652927093*lam5_12 - 0.04994749004669093*lam5_32) +
        0.8974188745594792*a4_y;
    const rx90_real t8 = 0.4973859781056681*lam5_21 - 0.09969734753381411*lam5_12 -
        0.04994749004669093*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093*lam5_13 -
        0.022422989561630666*lam5_23);
    const rx90_real nc5_z = t8 - (0.8974188745594792*a5_y + 0.8067444135457743*a5_x);
    /* link 6: force that moves the link [N] */
    const rx90_real fc6_x = 1.5707678306756712*neg_lam6_11 + 0.6271000643521031*lam6_12;
    const rx90_real fc6_y = -0.6271000643521031*neg_lam6_22 - 1.5707678306756712*lam6_21;
    const rx90_real fc6_z = 0.6271000643521031*lam6_32 - 1.5707678306756712*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_x = 0.13354610634435332*lam6_32 + 0.07096581179296485*(neg_lam6_22 -
        neg_lam6_33) - (0.13821978029399798*lam6_31 - 0.1601275610650136*lam6_21) +
        0.6271000643521031*a5_y;
    const rx90_real nc6_y = 1.5707678306756712*a5_y - (0.4436030328765257*lam6_31 -
        0.1601275610650136*(neg_lam6_11 - neg_lam6_33) - (0.07096581179296485*lam6_12 +
        0.13821978029399798*lam6_32));
    const rx90_real t9 = 0.13354610634435332*lam6_12 - 0.4436030328765257*lam6_21 +
        0.13821978029399798*(neg_lam6_11 - neg_lam6_22) - (0.1601275610650136*neg_lam6_23 -
        0.07096581179296485*lam6_13);
    const rx90_real nc6_z = 0.6271000643521031*neg_a6_x - 1.5707678306756712*a6_y - t9;
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f06_x = c6*fc6_x - s6*fc6_y;
    const rx90_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n06_x = c6*nc6_x - s6*nc6_y;
    const rx90_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_x = nc5_x + n06_x;
    const rx90_real n5_y = nc6_z - neg_nc5_y;
    const rx90_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const rx90_real f5_x = fc5_x + f06_x;
    const rx90_real f5_y = fc5_y + fc6_z;
    const rx90_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f05_x = c5*f5_x - s5*f5_y;
    const rx90_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n05_x = c5*n5_x - s5*n5_y;
    const rx90_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_x = nc4_x + n05_x;
    const rx90_real n4_y = nc4_y - n5_z;
    const rx90_real n4_z = nc4_z + n05_y;
    /* link 4: force through the joint [N] */
    const rx90_real f4_x = fc4_x + f05_x;
    const rx90_real f4_y = fc4_y - f5_z;
    const rx90_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f04_x = c4*f4_x - s4*f4_y;
    const rx90_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n04_x = c4*n4_x - s4*n4_y;
    const rx90_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = n04_x + (nc3_x - 0.45*f04_y);
    const rx90_real n3_y = nc3_y + n4_z;
    const rx90_real n3_z = nc3_z - 0.45*f04_x - n04_y;
    /* link 3: force through the joint [N] */
    const rx90_real f3_x = fc3_x + f04_x;
    const rx90_real f3_y = fc3_y + f4_z;
    const rx90_real f3_z = fc3_z - f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f03_x = c23*f3_x - s23*f3_y;
    const rx90_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    const rx90_real t10 = 0.45*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_y = n03_y + (s2*nc2_x + c2*nc2_y - f3_z*t10);
    const rx90_real n02_z = n3_z + (nc2_z + (f03_y*t10 - f03_x*(0.45*s2)));
    tau[0] = n02_y;
    tau[1] = n02_z;
    tau[2] = n3_z;
    tau[3] = n4_z;
    tau[4] = n5_z;
    tau[5] = nc6_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 125 multiplications, 108 additions = 233; 0 unary minus; 10 sine/cosine */
void rx90_mass_matrix(const rx90_real q[6], rx90_real M[36])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile rx90_real *const again = q;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(again[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(again[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(again[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(again[5]);
    const volatile rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h6_x = 1.5707678306756712*c6 + 0.6271000643521031*s6;
    const rx90_real neg_h6_y = 1.5707678306756712*s6 - 0.6271000643521031*c6;
    const rx90_real t1 = c6*s6;
    const rx90_real t2 = c6*c6;
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_xy = 0.31005692653217237*t1 - 0.13821978029399798*(2.0*t2 - 1.0);
    const rx90_real neg_k6_xz = 0.1601275610650136*c6 + 0.07096581179296485*s6;
    const rx90_real k6_yz = 0.07096581179296485*c6 - 0.1601275610650136*s6;
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_x = c5*neg_h6_y;
    const rx90_real fu5_y = s5*neg_h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const rx90_real nu5_x = c5*neg_k6_xz - 0.5771491392208791*s5;
    const rx90_real nu5_y = s5*neg_k6_xz + 0.5771491392208791*c5;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_x = c4*fu5_x + s4*neg_h6_x;
    const rx90_real fu4_y = s4*fu5_x - c4*neg_h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x = c4*nu5_x + s4*k6_yz;
    const rx90_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_6 = -0.45*fu4_x - nu4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x = c23*fu4_x - s23*fu5_y;
    const rx90_real fu3_y = s23*fu4_x + c23*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y = s23*(nu4_x - 0.45*fu4_y) + c23*nu5_y;
    const rx90_real t3 = 0.45*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y = nu3_y + t3*fu4_y;
    const rx90_real t4 = 0.45*s2;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_6 = m3_6 + (t3*fu3_y - t4*fu3_x);
    const rx90_real t5 = 0.31005692653217237*t2 + 0.27643956058799596*t1;
    /* link 5: mass matrix, its row of this joint */
    const rx90_real m5_5 = t5 + 0.7306294319838356;
    const rx90_real t6 = neg_h6_x + 0.8974188745594792;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h5_x = c5*t6 + 0.8067444135457743*s5;
    const rx90_real neg_h5_y = s5*t6 - 0.8067444135457743*c5;
    const rx90_real t7 = c5*c5;
    const rx90_real t8 = t5 + 0.5312347369162073;
    const rx90_real t9 = neg_k6_xz + 0.04994749004669093;
    const rx90_real t10 = c5*s5;
    const rx90_real t11 = t7*t8 + t9*(2.0*t10);
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real k5_yy = t5 + 0.6309320844500215 - t11;
    const rx90_real k5_xy = t8*t10 + t9*(1.0 - 2.0*t7);
    const rx90_real t12 = k6_xy - 0.022422989561630666;
    const rx90_real t13 = 0.06545842652927093 - k6_yz;
    const rx90_real neg_k5_xz = c5*t12 + s5*t13;
    const rx90_real neg_k5_yz = s5*t12 - c5*t13;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_x_2 = c4*neg_h5_y;
    const rx90_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x_2 = c4*neg_k5_xz + s4*m5_5;
    const rx90_real nu4_y_2 = s4*neg_k5_xz - c4*m5_5;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_5 = -0.45*fu4_x_2 - nu4_y_2;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x_2 = c23*fu4_x_2 + s23*neg_h5_x;
    const rx90_real fu3_y_2 = s23*fu4_x_2 - c23*neg_h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y_2 = s23*(nu4_x_2 - 0.45*fu4_y_2) + c23*neg_k5_yz;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y_2 = nu3_y_2 + t3*fu4_y_2;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_5 = m3_5 + (t3*fu3_y_2 - t4*fu3_x_2);
    /* link 4: mass matrix, its row of this joint */
    const rx90_real m4_4 = 1.488987605192658 - (t5 - t11);
    const rx90_real t14 = neg_h6_y - 1.0765039731522932;
    const rx90_real t15 = neg_h5_x - 0.21759393385311085;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h4_x = s4*t14 - c4*t15;
    const rx90_real neg_h4_y = s4*t15 + c4*t14;
    const rx90_real t16 = c4*c4;
    const rx90_real t17 = t5 + t11 - 0.9122308027056962;
    const rx90_real t18 = neg_k5_xz + 0.09181695932507075;
    const rx90_real t19 = c4*s4;
    const rx90_real t20 = t16*t17 - t18*(2.0*t19);
    /* link 4: second moment of the composite body [kg m^2] */
    const rx90_real neg_k4_xx = t5 - 1.2006092039491771 - t20;
    const rx90_real k4_yy = t11 + 0.2883784012434809 - t20;
    const rx90_real k4_xy = t17*t19 - t18*(1.0 - 2.0*t16);
    const rx90_real t21 = k5_xy + 0.1094831940191231;
    const rx90_real t22 = neg_k5_yz + 0.02981305527252843;
    const rx90_real k4_xz = c4*t21 - s4*t22;
    const rx90_real k4_yz = s4*t21 + c4*t22;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_4 = k4_yz - 0.45*neg_h4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x_3 = c23*neg_h4_y;
    const rx90_real fu3_y_3 = s23*neg_h4_y;
    const rx90_real t23 = k4_xz + 0.45*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y_3 = c23*m4_4 - s23*t23;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y_3 = nu3_y_3 + t3*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_4 = m3_4 + (t3*fu3_y_3 - t4*fu3_x_3);
    const rx90_real t24 = k5_yy - 0.9*neg_h5_y;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_3 = 5.588609369432211 - (neg_k4_xx - t24);
    const rx90_real t25 = 0.4001573159217507 - h4_x;
    const rx90_real t26 = 9.392800548482231 - neg_h5_y;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real neg_h3_x = c23*t25 + s23*t26;
    const rx90_real h3_y = c23*t26 - s23*t25;
    const rx90_real t27 = c23*c23*(neg_k4_xx + t24 + 5.203567339738615) + (t23 +
        0.06558551272001446)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const rx90_real k3_xx = t24 + 5.396088354585412 - t27;
    const rx90_real neg_k3_yy = neg_k4_xx - 0.19252101484679798 - t27;
    const rx90_real neg_k3_yz = s23*(k4_xy - 0.1093030288471206) + c23*(m3_4 - 0.0672049454639226);
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_3 = m3_3 + (t4*h3_y - t3*neg_h3_x);
    const rx90_real t28 = k4_yy + neg_k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real neg_k2_zz = neg_k3_yy - t28;
    const rx90_real t29 = k3_xx - t3*(2.0*neg_h3_x);
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_2 = t29 + (k4_yy - t28 - t4*(-2.0*h3_y)) + 5.195184633739834;
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real k2_xx = t29 + (4.09673559354447*(c2*c2) - 0.6711330317943448*(c2*s2) +
        0.5492245200976821);
    const rx90_real neg_k2_yz = neg_k3_yz - t4*neg_h4_y - (0.017315109477737248*s2 +
        0.09496171507178643*c2);
    /* link 1: mass matrix, its row of this joint */
    const rx90_real m1_1 = 0.6379688079078735 - (neg_k2_zz - k2_xx);
    M[0] = m1_1;
    M[1] = neg_k2_yz;
    M[2] = neg_k3_yz;
    M[3] = nu2_y_3;
    M[4] = nu2_y_2;
    M[5] = nu2_y;
    M[6] = neg_k2_yz;
    M[7] = m2_2;
    M[8] = m2_3;
    M[9] = m2_4;
    M[10] = m2_5;
    M[11] = m2_6;
    M[12] = neg_k3_yz;
    M[13] = m2_3;
    M[14] = m3_3;
    M[15] = m3_4;
    M[16] = m3_5;
    M[17] = m3_6;
    M[18] = nu2_y_3;
    M[19] = m2_4;
    M[20] = m3_4;
    M[21] = m4_4;
    M[22] = neg_k5_yz;
    M[23] = nu5_y;
    M[24] = nu2_y_2;
    M[25] = m2_5;
    M[26] = m3_5;
    M[27] = neg_k5_yz;
    M[28] = m5_5;
    M[29] = k6_yz;
    M[30] = nu2_y;
    M[31] = m2_6;
    M[32] = m3_6;
    M[33] = nu5_y;
    M[34] = k6_yz;
    M[35] = 0.5771491392208791;
}

/* accelerations that the torques tau give
 * 436 multiplications, 376 additions, 6 divisions = 818; 12 unary minus; 10 sine/cosine */
void rx90_forward_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real tau[6],
    rx90_real qdd[6])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile rx90_real *const again = q;
    /* sines and cosines of the joint angles */
    const rx90_real c2 = cos(q[1]);
    const rx90_real s2 = sin(again[1]);
    const rx90_real c4 = cos(q[3]);
    const rx90_real s4 = sin(again[3]);
    const rx90_real c5 = cos(q[4]);
    const rx90_real s5 = sin(again[4]);
    const rx90_real c6 = cos(q[5]);
    const rx90_real s6 = sin(again[5]);
    const volatile rx90_real angle23 = q[1] + q[2];
    const rx90_real c23 = cos(angle23);
    const rx90_real s23 = sin(angle23);
    /* link 6: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h6_x = -0.6271000643521031*s6 - 1.5707678306756712*c6;
    const rx90_real neg_h6_y = 1.5707678306756712*s6 - 0.6271000643521031*c6;
    const rx90_real t1 = c6*s6;
    const rx90_real t2 = c6*c6;
    /* link 6: second moment of the composite body [kg m^2] */
    const rx90_real k6_xy = 0.31005692653217237*t1 - 0.13821978029399798*(2.0*t2 - 1.0);
    const rx90_real k6_xz = -0.07096581179296485*s6 - 0.1601275610650136*c6;
    const rx90_real k6_yz = 0.07096581179296485*c6 - 0.1601275610650136*s6;
    /* link 5: force for a unit acceleration of a joint further out */
    const rx90_real fu5_x = c5*neg_h6_y;
    const rx90_real fu5_y = s5*neg_h6_y;
    /* link 5: moment for a unit acceleration of a joint further out */
    const rx90_real nu5_x = -0.5771491392208791*s5 - c5*k6_xz;
    const rx90_real nu5_y = 0.5771491392208791*c5 - s5*k6_xz;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_x = c4*fu5_x - s4*h6_x;
    const rx90_real fu4_y = s4*fu5_x + c4*h6_x;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x = c4*nu5_x + s4*k6_yz;
    const rx90_real nu4_y = s4*nu5_x - c4*k6_yz;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real neg_m3_6 = nu4_y + 0.45*fu4_x;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x = c23*fu4_x - s23*fu5_y;
    const rx90_real fu3_y = s23*fu4_x + c23*fu5_y;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y = s23*(nu4_x - 0.45*fu4_y) + c23*nu5_y;
    const rx90_real t3 = 0.45*c2;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y = nu3_y + t3*fu4_y;
    const rx90_real t4 = 0.45*s2;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_6 = t3*fu3_y - t4*fu3_x - neg_m3_6;
    const rx90_real t5 = 0.31005692653217237*t2 + 0.27643956058799596*t1;
    /* link 5: mass matrix, its row of this joint */
    const rx90_real m5_5 = t5 + 0.7306294319838356;
    const rx90_real t6 = 0.8974188745594792 - h6_x;
    /* link 5: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h5_x = -0.8067444135457743*s5 - c5*t6;
    const rx90_real neg_h5_y = s5*t6 - 0.8067444135457743*c5;
    const rx90_real t7 = c5*c5;
    const rx90_real t8 = t5 + 0.5312347369162073;
    const rx90_real t9 = 0.04994749004669093 - k6_xz;
    const rx90_real t10 = c5*s5;
    const rx90_real t11 = t7*t8 + t9*(2.0*t10);
    /* link 5: second moment of the composite body [kg m^2] */
    const rx90_real k5_yy = t5 + 0.6309320844500215 - t11;
    const rx90_real k5_xy = t8*t10 + t9*(1.0 - 2.0*t7);
    const rx90_real t12 = 0.022422989561630666 - k6_xy;
    const rx90_real t13 = k6_yz - 0.06545842652927093;
    const rx90_real k5_xz = c5*t12 + s5*t13;
    const rx90_real k5_yz = s5*t12 - c5*t13;
    /* link 4: force for a unit acceleration of a joint further out */
    const rx90_real fu4_x_2 = c4*neg_h5_y;
    const rx90_real fu4_y_2 = s4*neg_h5_y;
    /* link 4: moment for a unit acceleration of a joint further out */
    const rx90_real nu4_x_2 = s4*m5_5 - c4*k5_xz;
    const rx90_real t14 = -c4;
    const rx90_real nu4_y_2 = t14*m5_5 - s4*k5_xz;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real neg_m3_5 = nu4_y_2 + 0.45*fu4_x_2;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x_2 = c23*fu4_x_2 - s23*h5_x;
    const rx90_real fu3_y_2 = s23*fu4_x_2 + c23*h5_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y_2 = s23*(nu4_x_2 - 0.45*fu4_y_2) - c23*k5_yz;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y_2 = nu3_y_2 + t3*fu4_y_2;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_5 = t3*fu3_y_2 - t4*fu3_x_2 - neg_m3_5;
    /* link 4: mass matrix, its row of this joint */
    const rx90_real m4_4 = 1.488987605192658 - (t5 - t11);
    const rx90_real t15 = neg_h6_y - 1.0765039731522932;
    const rx90_real t16 = -h5_x - 0.21759393385311085;
    /* link 4: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h4_x = s4*t15 - c4*t16;
    const rx90_real neg_h4_y = s4*t16 + c4*t15;
    const rx90_real t17 = c4*c4;
    const rx90_real t18 = t5 + t11 - 0.9122308027056962;
    const rx90_real t19 = 0.09181695932507075 - k5_xz;
    const rx90_real t20 = c4*s4;
    const rx90_real t21 = t17*t18 - t19*(2.0*t20);
    /* link 4: second moment of the composite body [kg m^2] */
    const rx90_real k4_xx = t21 - (t5 - 1.2006092039491771);
    const rx90_real k4_yy = t11 + 0.2883784012434809 - t21;
    const rx90_real k4_xy = t18*t20 - t19*(1.0 - 2.0*t17);
    const rx90_real t22 = k5_xy + 0.1094831940191231;
    const rx90_real t23 = 0.02981305527252843 - k5_yz;
    const rx90_real k4_xz = c4*t22 - s4*t23;
    const rx90_real k4_yz = s4*t22 + c4*t23;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_4 = k4_yz - 0.45*neg_h4_y;
    /* link 3: force for a unit acceleration of a joint further out */
    const rx90_real fu3_x_3 = c23*neg_h4_y;
    const rx90_real fu3_y_3 = s23*neg_h4_y;
    const rx90_real t24 = k4_xz + 0.45*h4_x;
    /* link 3: moment for a unit acceleration of a joint further out */
    const rx90_real nu3_y_3 = c23*m4_4 - s23*t24;
    /* link 2: moment for a unit acceleration of a joint further out */
    const rx90_real nu2_y_3 = nu3_y_3 + t3*h4_x;
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_4 = m3_4 + (t3*fu3_y_3 - t4*fu3_x_3);
    const rx90_real t25 = k5_yy - 0.9*neg_h5_y;
    /* link 3: mass matrix, its row of this joint */
    const rx90_real m3_3 = k4_xx + t25 + 5.588609369432211;
    const rx90_real t26 = neg_h5_y - 9.392800548482231;
    const rx90_real t27 = 0.4001573159217507 - h4_x;
    /* link 3: first moment of the composite body, about the frame's origin [kg m] */
    const rx90_real h3_x = s23*t26 - c23*t27;
    const rx90_real neg_h3_y = s23*t27 + c23*t26;
    const rx90_real t28 = c23*c23*(t25 - k4_xx + 5.203567339738615) + (t24 +
        0.06558551272001446)*(2.0*(c23*s23));
    /* link 3: second moment of the composite body [kg m^2] */
    const rx90_real k3_xx = t25 + 5.396088354585412 - t28;
    const rx90_real k3_yy = k4_xx + 0.19252101484679798 + t28;
    const rx90_real k3_yz = c23*(0.0672049454639226 - m3_4) - s23*(k4_xy - 0.1093030288471206);
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_3 = m3_3 - (t4*neg_h3_y - t3*h3_x);
    const rx90_real t29 = k4_yy - k3_yy;
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real k2_zz = k3_yy + t29;
    const rx90_real t30 = k3_xx - t3*(-2.0*h3_x);
    /* link 2: mass matrix, its row of this joint */
    const rx90_real m2_2 = t30 + (k4_yy - t29 - t4*(2.0*neg_h3_y)) + 5.195184633739834;
    /* link 2: second moment of the composite body [kg m^2] */
    const rx90_real k2_xx = t30 + (4.09673559354447*(c2*c2) - 0.6711330317943448*(c2*s2) +
        0.5492245200976821);
    const rx90_real k2_yz = k3_yz + t4*neg_h4_y + (0.017315109477737248*s2 +
        0.09496171507178643*c2);
    /* link 1: mass matrix, its row of this joint */
    const rx90_real m1_1 = k2_zz + k2_xx + 0.6379688079078735;
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_z = qd[1] + qd[2];
    /* link 2: angular velocity [rad/s] */
    const rx90_real w2_x = qd[0]*s2;
    const rx90_real w2_y = qd[0]*c2;
    /* link 2: angular acceleration [rad/s^2] */
    const rx90_real alpha2_x = qd[1]*w2_y;
    const rx90_real neg_alpha2_y = qd[1]*w2_x;
    /* link 2: products of the angular velocity [1/s^2] */
    const rx90_real ww2_xy = w2_x*w2_y;
    const rx90_real ww2_xx = w2_x*w2_x;
    const rx90_real ww2_yy = w2_y*w2_y;
    const rx90_real ww2_zz = qd[1]*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam2_11 = ww2_yy + ww2_zz;
    const rx90_real neg_lam2_22 = ww2_xx + ww2_zz;
    const rx90_real neg_lam2_33 = ww2_xx + ww2_yy;
    /* link 3: angular velocity [rad/s] */
    const rx90_real w3_x = qd[0]*s23;
    const rx90_real w3_y = qd[0]*c23;
    const rx90_real t31 = 0.45*neg_lam2_11;
    const rx90_real t32 = 0.45*ww2_xy;
    const rx90_real t33 = c2*t31 + s2*t32;
    const rx90_real t34 = s2*t31 - c2*t32 - 9.8;
    /* link 3: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real neg_a3_x = c23*t33 + s23*t34;
    const rx90_real a3_y = s23*t33 - c23*t34;
    /* link 3: angular acceleration [rad/s^2] */
    const rx90_real alpha3_x = w3_z*w3_y;
    const rx90_real alpha3_y = -w3_z*w3_x;
    /* link 3: products of the angular velocity [1/s^2] */
    const rx90_real ww3_xy = w3_x*w3_y;
    const rx90_real ww3_xx = w3_x*w3_x;
    const rx90_real ww3_yy = w3_y*w3_y;
    const rx90_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam3_11 = ww3_yy + ww3_zz;
    const rx90_real neg_lam3_22 = ww3_xx + ww3_zz;
    const rx90_real neg_lam3_33 = ww3_xx + ww3_yy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_z = a3_y - 0.45*neg_lam3_22;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_x = c4*w3_x - s4*w3_z;
    const rx90_real w4_y = t14*w3_z - s4*w3_x;
    const rx90_real t35 = 0.9*(neg_alpha2_y + alpha3_x);
    const rx90_real t36 = neg_a3_x - 0.45*ww3_xy;
    /* link 4: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a4_x = -s4*t35 - c4*t36;
    const rx90_real a4_y = s4*t36 - c4*t35;
    /* link 4: angular acceleration [rad/s^2] */
    const rx90_real alpha4_x = c4*alpha3_x + qd[3]*w4_y;
    const rx90_real alpha4_y = -qd[3]*w4_x - s4*alpha3_x;
    /* link 4: angular velocity [rad/s] */
    const rx90_real w4_z = qd[3] + w3_y;
    /* link 4: products of the angular velocity [1/s^2] */
    const rx90_real ww4_yz = w4_y*w4_z;
    const rx90_real ww4_zx = w4_x*w4_z;
    const rx90_real ww4_xy = w4_x*w4_y;
    const rx90_real ww4_xx = w4_x*w4_x;
    const rx90_real ww4_yy = w4_y*w4_y;
    const rx90_real ww4_zz = w4_z*w4_z;
    /* link 4: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam4_11 = ww4_yy + ww4_zz;
    const rx90_real lam4_12 = ww4_xy - alpha3_y;
    const rx90_real lam4_13 = alpha4_y + ww4_zx;
    const rx90_real lam4_21 = alpha3_y + ww4_xy;
    const rx90_real neg_lam4_22 = ww4_xx + ww4_zz;
    const rx90_real lam4_23 = ww4_yz - alpha4_x;
    const rx90_real lam4_31 = ww4_zx - alpha4_y;
    const rx90_real lam4_32 = alpha4_x + ww4_yz;
    const rx90_real neg_lam4_33 = ww4_xx + ww4_yy;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_x = c5*w4_x + s5*w4_z;
    const rx90_real w5_y = c5*w4_z - s5*w4_x;
    /* link 5: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a5_x = c5*a4_x + s5*a4_z;
    const rx90_real a5_y = c5*a4_z - s5*a4_x;
    /* link 5: angular acceleration [rad/s^2] */
    const rx90_real alpha5_x = c5*alpha4_x + s5*alpha3_y + qd[4]*w5_y;
    const rx90_real neg_alpha5_y = s5*alpha4_x - c5*alpha3_y + qd[4]*w5_x;
    /* link 5: angular velocity [rad/s] */
    const rx90_real w5_z = qd[4] - w4_y;
    /* link 5: products of the angular velocity [1/s^2] */
    const rx90_real ww5_yz = w5_y*w5_z;
    const rx90_real ww5_zx = w5_x*w5_z;
    const rx90_real ww5_xy = w5_x*w5_y;
    const rx90_real ww5_xx = w5_x*w5_x;
    const rx90_real ww5_yy = w5_y*w5_y;
    const rx90_real ww5_zz = w5_z*w5_z;
    /* link 5: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam5_11 = ww5_yy + ww5_zz;
    const rx90_real lam5_12 = alpha4_y + ww5_xy;
    const rx90_real lam5_13 = ww5_zx - neg_alpha5_y;
    const rx90_real lam5_21 = ww5_xy - alpha4_y;
    const rx90_real neg_lam5_22 = ww5_xx + ww5_zz;
    const rx90_real lam5_23 = ww5_yz - alpha5_x;
    const rx90_real lam5_31 = neg_alpha5_y + ww5_zx;
    const rx90_real lam5_32 = alpha5_x + ww5_yz;
    const rx90_real neg_lam5_33 = ww5_xx + ww5_yy;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_x = c6*w5_x - s6*w5_z;
    const rx90_real w6_y = -c6*w5_z - s6*w5_x;
    /* link 6: acceleration of the frame's origin, gravity taken off [m/s^2] */
    const rx90_real a6_x = c6*a5_x + s6*a4_y;
    const rx90_real a6_y = c6*a4_y - s6*a5_x;
    /* link 6: angular acceleration [rad/s^2] */
    const rx90_real alpha6_x = c6*alpha5_x + s6*alpha4_y + qd[5]*w6_y;
    const rx90_real neg_alpha6_y = s6*alpha5_x - c6*alpha4_y + qd[5]*w6_x;
    /* link 6: angular velocity [rad/s] */
    const rx90_real w6_z = qd[5] + w5_y;
    /* link 6: products of the angular velocity [1/s^2] */
    const rx90_real ww6_yz = w6_y*w6_z;
    const rx90_real ww6_zx = w6_x*w6_z;
    const rx90_real ww6_xy = w6_x*w6_y;
    const rx90_real ww6_xx = w6_x*w6_x;
    const rx90_real ww6_yy = w6_y*w6_y;
    const rx90_real ww6_zz = w6_z*w6_z;
    /* link 6: lambda matrix: takes a position to its acceleration [1/s^2] */
    const rx90_real neg_lam6_11 = ww6_yy + ww6_zz;
    const rx90_real lam6_12 = neg_alpha5_y + ww6_xy;
    const rx90_real lam6_13 = ww6_zx - neg_alpha6_y;
    const rx90_real lam6_21 = ww6_xy - neg_alpha5_y;
    const rx90_real neg_lam6_22 = ww6_xx + ww6_zz;
    const rx90_real neg_lam6_23 = alpha6_x - ww6_yz;
    const rx90_real lam6_31 = neg_alpha6_y + ww6_zx;
    const rx90_real lam6_32 = alpha6_x + ww6_yz;
    const rx90_real neg_lam6_33 = ww6_xx + ww6_yy;
    /* link 2: moment that turns the link [N m] */
    const rx90_real nc2_x = 1.0984490401953642*alpha2_x + 0.09496171507178643*(neg_lam2_22 -
        neg_lam2_33) + (0.6711330317943448*neg_alpha2_y - 0.017315109477737248*ww2_xy);
    const rx90_real nc2_y = 0.09496171507178643*ww2_xy - 0.6711330317943448*alpha2_x -
        (9.291920227284304*neg_alpha2_y + 0.017315109477737248*(neg_lam2_11 - neg_lam2_33));
    const rx90_real nc2_z = 4.09673559354447*ww2_xy + 0.3355665158971724*(neg_lam2_11 - neg_lam2_22)
        + (81.05525857884084*c2 + 17.30463777489202*s2);
    /* link 3: force that moves the link [N] */
    const rx90_real fc3_x = 0.4001573159217507*neg_lam3_11 + 9.392800548482231*ww3_xy;
    const rx90_real fc3_y = -9.392800548482231*neg_lam3_22 - 0.4001573159217507*ww3_xy;
    const rx90_real fc3_z = 0.8003146318435014*alpha3_y + 18.785601096964463*alpha3_x;
    /* link 3: moment that turns the link [N m] */
    const rx90_real nc3_x = 10.792176709170825*alpha3_x + 0.0672049454639226*(neg_lam3_22 -
        neg_lam3_33) + (-0.13117102544002893*alpha3_y - 0.1093030288471206*ww3_xy) +
        8.453520493634008*neg_alpha2_y;
    const rx90_real nc3_y = 0.3601415843295756*neg_alpha2_y - (0.1093030288471206*(neg_lam3_11 -
        neg_lam3_33) - 0.38504202969359597*alpha3_y - (0.0672049454639226*ww3_xy -
        0.13117102544002893*alpha3_x));
    const rx90_real nc3_z = 9.392800548482231*neg_a3_x - 0.4001573159217507*a3_y -
        (5.203567339738615*ww3_xy - 0.06558551272001446*(neg_lam3_11 - neg_lam3_22));
    /* link 4: force that moves the link [N] */
    const rx90_real fc4_x = 1.0765039731522932*lam4_12 - 0.21759393385311085*neg_lam4_11;
    const rx90_real fc4_y = 0.21759393385311085*lam4_21 - 1.0765039731522932*neg_lam4_22;
    const rx90_real fc4_z = 0.21759393385311085*lam4_31 + 1.0765039731522932*lam4_32;
    /* link 4: moment that turns the link [N m] */
    const rx90_real nc4_x = 0.7570061710726514*lam4_32 + 0.02981305527252843*(neg_lam4_22 -
        neg_lam4_33) + (0.09181695932507075*lam4_31 - 0.1094831940191231*lam4_21) +
        1.0765039731522932*a4_z;
    const rx90_real nc4_y = -0.21759393385311085*a4_z - (0.1886810537096668*lam4_31 +
        0.1094831940191231*(neg_lam4_11 - neg_lam4_33) - (0.02981305527252843*lam4_12 -
        0.09181695932507075*lam4_32));
    const rx90_real t37 = 0.7570061710726514*lam4_12 - 0.1886810537096668*lam4_21 -
        0.09181695932507075*(neg_lam4_11 - neg_lam4_22) + (0.02981305527252843*lam4_13 -
        0.1094831940191231*lam4_23);
    const rx90_real nc4_z = 0.21759393385311085*a4_y - 1.0765039731522932*a4_x - t37;
    /* link 5: force that moves the link [N] */
    const rx90_real fc5_x = 0.8974188745594792*neg_lam5_11 + 0.8067444135457743*lam5_12;
    const rx90_real fc5_y = -0.8067444135457743*neg_lam5_22 - 0.8974188745594792*lam5_21;
    const rx90_real fc5_z = 0.8067444135457743*lam5_32 - 0.8974188745594792*lam5_31;
    /* link 5: moment that turns the link [N m] */
    const rx90_real nc5_x = 0.09969734753381411*lam5_32 + 0.06545842652927093*(neg_lam5_22 -
        neg_lam5_33) - (0.04994749004669093*lam5_31 + 0.022422989561630666*lam5_21) -
        0.8067444135457743*a4_y;
    const rx90_real nc5_y = -0.8974188745594792*a4_y - (0.4973859781056681*lam5_31 +
        0.022422989561630666*(neg_lam5_11 - neg_lam5_33) + (-0.06545842652927093*lam5_12 -
        0.04994749004669093*lam5_32));
    const rx90_real t38 = 0.4973859781056681*lam5_21 - 0.09969734753381411*lam5_12 -
        0.04994749004669093*(neg_lam5_11 - neg_lam5_22) - (0.06545842652927093*lam5_13 -
        0.022422989561630666*lam5_23);
    const rx90_real nc5_z = t38 - (0.8974188745594792*a5_y + 0.8067444135457743*a5_x);
    /* link 6: force that moves the link [N] */
    const rx90_real fc6_x = 1.5707678306756712*neg_lam6_11 + 0.6271000643521031*lam6_12;
    const rx90_real fc6_y = -0.6271000643521031*neg_lam6_22 - 1.5707678306756712*lam6_21;
    const rx90_real fc6_z = 0.6271000643521031*lam6_32 - 1.5707678306756712*lam6_31;
    /* link 6: moment that turns the link [N m] */
    const rx90_real nc6_x = 0.13354610634435332*lam6_32 + 0.07096581179296485*(neg_lam6_22 -
        neg_lam6_33) - (0.13821978029399798*lam6_31 - 0.1601275610650136*lam6_21) +
        0.6271000643521031*a5_y;
    const rx90_real nc6_y = 1.5707678306756712*a5_y - (0.4436030328765257*lam6_31 -
        0.1601275610650136*(neg_lam6_11 - neg_lam6_33) - (0.07096581179296485*lam6_12 +
        0.13821978029399798*lam6_32));
    const rx90_real t39 = 0.13354610634435332*lam6_12 - 0.4436030328765257*lam6_21 +
        0.13821978029399798*(neg_lam6_11 - neg_lam6_22) - (0.1601275610650136*neg_lam6_23 -
        0.07096581179296485*lam6_13);
    const rx90_real neg_nc6_z = t39 + (1.5707678306756712*a6_y + 0.6271000643521031*a6_x);
    /* link 6: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f06_x = c6*fc6_x - s6*fc6_y;
    const rx90_real f06_y = s6*fc6_x + c6*fc6_y;
    /* link 6: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n06_x = c6*nc6_x - s6*nc6_y;
    const rx90_real n06_y = s6*nc6_x + c6*nc6_y;
    /* link 5: moment through the joint, about the frame's origin [N m] */
    const rx90_real n5_x = nc5_x + n06_x;
    const rx90_real n5_y = nc5_y - neg_nc6_z;
    const rx90_real n5_z = nc5_z - n06_y;
    /* link 5: force through the joint [N] */
    const rx90_real f5_x = fc5_x + f06_x;
    const rx90_real f5_y = fc5_y + fc6_z;
    const rx90_real f5_z = fc5_z - f06_y;
    /* link 5: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f05_x = c5*f5_x - s5*f5_y;
    const rx90_real f05_y = s5*f5_x + c5*f5_y;
    /* link 5: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n05_x = c5*n5_x - s5*n5_y;
    const rx90_real n05_y = s5*n5_x + c5*n5_y;
    /* link 4: moment through the joint, about the frame's origin [N m] */
    const rx90_real n4_x = nc4_x + n05_x;
    const rx90_real n4_y = nc4_y - n5_z;
    const rx90_real n4_z = nc4_z + n05_y;
    /* link 4: force through the joint [N] */
    const rx90_real f4_x = fc4_x + f05_x;
    const rx90_real f4_y = fc4_y - f5_z;
    const rx90_real f4_z = fc4_z + f05_y;
    /* link 4: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f04_x = c4*f4_x - s4*f4_y;
    const rx90_real f04_y = s4*f4_x + c4*f4_y;
    /* link 4: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n04_x = c4*n4_x - s4*n4_y;
    const rx90_real n04_y = s4*n4_x + c4*n4_y;
    /* link 3: moment through the joint, about the frame's origin [N m] */
    const rx90_real n3_x = n04_x + (nc3_x - 0.45*f04_y);
    const rx90_real n3_y = nc3_y + n4_z;
    const rx90_real n3_z = nc3_z - 0.45*f04_x - n04_y;
    /* link 3: force through the joint [N] */
    const rx90_real f3_x = fc3_x + f04_x;
    const rx90_real f3_y = fc3_y + f4_z;
    const rx90_real f3_z = fc3_z - f04_y;
    /* link 3: force through the joint, along the axes that its turn starts from [N] */
    const rx90_real f03_x = c23*f3_x - s23*f3_y;
    const rx90_real f03_y = s23*f3_x + c23*f3_y;
    /* link 3: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n03_y = s23*n3_x + c23*n3_y;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const rx90_real n02_y = n03_y + (s2*nc2_x + c2*nc2_y - t3*f3_z);
    const rx90_real n02_z = n3_z + (nc2_z + (t3*f03_y - t4*f03_x));
    /* link 1: forward substitution */
    const rx90_real y1 = tau[0] - n02_y;
    /* factorisation M = L D L^T */
    const rx90_real ipivot1 = 1.0 / m1_1;
    const rx90_real l2_1 = -k2_yz*ipivot1;
    const rx90_real l3_1 = -k3_yz*ipivot1;
    const rx90_real l4_1 = nu2_y_3*ipivot1;
    const rx90_real l5_1 = nu2_y_2*ipivot1;
    const rx90_real l6_1 = nu2_y*ipivot1;
    const rx90_real pivot2 = m2_2 + k2_yz*l2_1;
    const rx90_real ipivot2 = 1.0 / pivot2;
    const rx90_real ld3_2 = m2_3 + k2_yz*l3_1;
    const rx90_real l3_2 = ipivot2*ld3_2;
    const rx90_real ld4_2 = m2_4 + k2_yz*l4_1;
    const rx90_real l4_2 = ipivot2*ld4_2;
    const rx90_real ld5_2 = m2_5 + k2_yz*l5_1;
    const rx90_real l5_2 = ipivot2*ld5_2;
    const rx90_real ld6_2 = m2_6 + k2_yz*l6_1;
    const rx90_real l6_2 = ipivot2*ld6_2;
    const rx90_real pivot3 = m3_3 + k3_yz*l3_1 - ld3_2*l3_2;
    const rx90_real ipivot3 = 1.0 / pivot3;
    const rx90_real ld4_3 = m3_4 + k3_yz*l4_1 - ld3_2*l4_2;
    const rx90_real l4_3 = ipivot3*ld4_3;
    const rx90_real ld5_3 = k3_yz*l5_1 - neg_m3_5 - ld3_2*l5_2;
    const rx90_real l5_3 = ipivot3*ld5_3;
    const rx90_real ld6_3 = k3_yz*l6_1 - neg_m3_6 - ld3_2*l6_2;
    const rx90_real l6_3 = ipivot3*ld6_3;
    const rx90_real pivot4 = m4_4 - nu2_y_3*l4_1 - ld4_2*l4_2 - ld4_3*l4_3;
    const rx90_real ipivot4 = 1.0 / pivot4;
    const rx90_real ld5_4 = -ld4_2*l5_2 - (k5_yz + nu2_y_3*l5_1) - ld4_3*l5_3;
    const rx90_real l5_4 = ipivot4*ld5_4;
    const rx90_real ld6_4 = nu5_y - nu2_y_3*l6_1 - ld4_2*l6_2 - ld4_3*l6_3;
    const rx90_real l6_4 = ipivot4*ld6_4;
    const rx90_real pivot5 = m5_5 - nu2_y_2*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 - ld5_4*l5_4;
    const rx90_real ipivot5 = 1.0 / pivot5;
    const rx90_real ld6_5 = -(ld5_2*l6_2 - (k6_yz - nu2_y_2*l6_1) + ld5_3*l6_3) - ld5_4*l6_4;
    const rx90_real l6_5 = ipivot5*ld6_5;
    const rx90_real pivot6 = 0.5771491392208791 - nu2_y*l6_1 - ld6_2*l6_2 - ld6_3*l6_3 - ld6_4*l6_4
        - ld6_5*l6_5;
    const rx90_real ipivot6 = 1.0 / pivot6;
    /* link 2: forward substitution */
    const rx90_real y2 = tau[1] - n02_z - y1*l2_1;
    /* link 3: forward substitution */
    const rx90_real y3 = tau[2] - n3_z - y1*l3_1 - l3_2*y2;
    /* link 4: forward substitution */
    const rx90_real y4 = tau[3] - n4_z - y1*l4_1 - l4_2*y2 - l4_3*y3;
    /* link 5: forward substitution */
    const rx90_real y5 = tau[4] - n5_z - y1*l5_1 - l5_2*y2 - l5_3*y3 - l5_4*y4;
    /* link 6: forward substitution */
    const rx90_real y6 = tau[5] + neg_nc6_z - y1*l6_1 - l6_2*y2 - l6_3*y3 - l6_4*y4 - l6_5*y5;
    /* link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd6 = ipivot6*y6;
    /* link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd5 = ipivot5*y5 - l6_5*qdd6;
    /* link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd4 = ipivot4*y4 - l5_4*qdd5 - l6_4*qdd6;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd3 = -l6_3*qdd6 - (l4_3*qdd4 - ipivot3*y3 + l5_3*qdd5);
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd2 = ipivot2*y2 - l3_2*qdd3 - l4_2*qdd4 - l5_2*qdd5 - l6_2*qdd6;
    const rx90_real t40 = -(l2_1*qdd2 - y1*ipivot1 + l3_1*qdd3 + l4_1*qdd4 + l5_1*qdd5);
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const rx90_real qdd1 = t40 - l6_1*qdd6;
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
    qdd[3] = qdd4;
    qdd[4] = qdd5;
    qdd[5] = qdd6;
}
