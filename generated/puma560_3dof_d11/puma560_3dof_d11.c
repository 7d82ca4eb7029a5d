/*
 * puma560_3dof_d11: PUMA 560, first three joints, the set of the thesis's program D.1.1
 * Numbers: the 1990 thesis, program D.1.1 (Lagrange); pseudo-inertias as tensors about the centres
 *   of mass
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: e4acb3fa395de91cc0422790bfa2c096 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0       d 0        theta q
 *   2  revolute  alpha -pi/2  a 0       d 0.2435   theta q
 *   3  revolute  alpha 0      a 0.4318  d -0.0934  theta q
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
 *   inverse_dynamics: 56 multiplications, 44 additions = 100; 0 unary minus; 4 sine/cosine
 *   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
 *   bias: 46 multiplications, 25 additions = 71; 0 unary minus; 4 sine/cosine
 *   mass_matrix: 13 multiplications, 14 additions = 27; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 75 multiplications, 50 additions, 2 divisions = 127; 4 unary minus; 4
 *       sine/cosine
 */
#include "puma560_3dof_d11.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 56 multiplications, 44 additions = 100; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d11_inverse_dynamics(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    const puma560_3dof_d11_real qdd[3],
    puma560_3dof_d11_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d11_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w2_y = qd[0]*c2;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w2_x = qd[0]*s2;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real lam2_23 = s2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real neg_ww2_yz = neg_w2_y*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_3dof_d11_real neg_alpha2_x = lam2_23 + neg_ww2_yz;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real neg_lam2_13 = c2*qdd[0];
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real neg_ww2_zx = neg_w2_x*qd[1];
    /* link 2: angular acceleration [rad/s^2] */
    const puma560_3dof_d11_real neg_alpha2_y = neg_lam2_13 - neg_ww2_zx;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_3dof_d11_real ww2_zz = qd[1]*qd[1];
    const puma560_3dof_d11_real ww2_xy = neg_w2_y*neg_w2_x;
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_3dof_d11_real lam2_21 = ww2_xy + qdd[1];
    const puma560_3dof_d11_real lam2_12 = ww2_xy - qdd[1];
    const puma560_3dof_d11_real neg_lam2_32 = neg_ww2_yz + neg_alpha2_x;
    const puma560_3dof_d11_real lam2_31 = neg_alpha2_y - neg_ww2_zx;
    const puma560_3dof_d11_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_3dof_d11_real angle23 = q[1] + q[2];
    const puma560_3dof_d11_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w3_x = qd[0]*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w3_y = qd[0]*c23;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d11_real alpha3_z = qdd[1] + qdd[2];
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real neg_ww3_yz = w3_z*neg_w3_y;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d11_real neg_alpha3_x = neg_ww3_yz + qdd[0]*s23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: angular acceleration [rad/s^2] */
    const puma560_3dof_d11_real alpha3_y = neg_ww3_zx - qdd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_3dof_d11_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_3dof_d11_real ww3_zz = w3_z*w3_z;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real lam3_21 = alpha3_z + ww3_xy;
    const puma560_3dof_d11_real neg_lam3_12 = alpha3_z - ww3_xy;
    const puma560_3dof_d11_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_3dof_d11_real neg_lam3_32 = neg_ww3_yz + neg_alpha3_x;
    const puma560_3dof_d11_real neg_lam3_31 = neg_ww3_zx + alpha3_y;
    const puma560_3dof_d11_real t1 = neg_lam2_11 + 0.3476146364057434*neg_lam2_13;
    const puma560_3dof_d11_real t2 = lam2_21 + 0.3476146364057434*lam2_23;
    const puma560_3dof_d11_real t3 = c23*(c2*t1 + s2*t2) + s23*(s2*t1 - c2*t2 + 22.69569245020843);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d11_real nc3_z = 0.1828673*(0.02132694035510996*(lam3_21 +
        8.58974358974359*neg_lam3_12) - t3);
    const puma560_3dof_d11_real t4 = c23*neg_lam3_12 - s23*neg_lam3_22;
    const puma560_3dof_d11_real t5 = lam2_23 + 17.560047467882075*(lam2_21 -
        0.01861555053452303*lam2_12) - 134.66002709590805*c2 +
        1.7581612571010712*(c2*(s23*neg_lam3_12 + c23*neg_lam3_22) - s2*t4);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d11_real n02_z = nc3_z + 0.104010539*t5;
    const puma560_3dof_d11_real t6 = s2*(lam2_21 + 0.326889951026982*neg_lam2_32) + c2*(neg_lam2_11
        - neg_lam2_33 + 17.560047467882075*lam2_31) - 0.6111625861298536*(t4 -
        2.876748834110593*(c2*neg_lam3_32));
    const puma560_3dof_d11_real t7 = t6 - 0.0374962002648597*(c23*neg_lam3_31 +
        46.889051282051284*(s23*(0.3476146364057434*neg_lam2_33 - lam2_31 -
        0.18319294920414966*neg_lam3_32)));
    /* link 1: moment through the joint, about the frame's origin [N m] */
    const puma560_3dof_d11_real n1_z = 0.104010539*(t7 + 15.040703812716517*qdd[0]);
    tau[0] = n1_z;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques that hold the arm at rest
 * 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine */
void puma560_3dof_d11_gravity(const puma560_3dof_d11_real q[3], puma560_3dof_d11_real tau[3])
{
    /* sines and cosines of the joint angles */
    const volatile puma560_3dof_d11_real angle23 = q[1] + q[2];
    const puma560_3dof_d11_real s23 = sin(angle23);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d11_real nc3_z = -4.1503*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c2 = cos(q[1]);
    /* link 2: moment that turns the link [N m] */
    const puma560_3dof_d11_real neg_nc2_z = 14.006062*c2;
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d11_real n02_z = nc3_z - neg_nc2_z;
    tau[0] = 0.0;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 46 multiplications, 25 additions = 71; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d11_bias(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    puma560_3dof_d11_real tau[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d11_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c2 = cos(q[1]);
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w2_y = qd[0]*c2;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w2_x = qd[0]*s2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww2_yy = neg_w2_y*neg_w2_y;
    const puma560_3dof_d11_real ww2_zz = qd[1]*qd[1];
    const puma560_3dof_d11_real ww2_xy = neg_w2_y*neg_w2_x;
    const puma560_3dof_d11_real neg_ww2_yz = neg_w2_y*qd[1];
    const puma560_3dof_d11_real neg_ww2_zx = neg_w2_x*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real neg_lam2_11 = ww2_yy + ww2_zz;
    const puma560_3dof_d11_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_3dof_d11_real angle23 = q[1] + q[2];
    const puma560_3dof_d11_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w3_x = qd[0]*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real neg_w3_y = qd[0]*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww3_xy = neg_w3_x*neg_w3_y;
    const puma560_3dof_d11_real ww3_xx = neg_w3_x*neg_w3_x;
    const puma560_3dof_d11_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d11_real neg_ww3_yz = w3_z*neg_w3_y;
    const puma560_3dof_d11_real neg_ww3_zx = w3_z*neg_w3_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real neg_lam3_22 = ww3_xx + ww3_zz;
    const puma560_3dof_d11_real t1 = c23*(c2*neg_lam2_11 + s2*ww2_xy) + s23*(s2*neg_lam2_11 -
        c2*ww2_xy + 22.69569245020843);
    /* link 3: moment that turns the link [N m] */
    const puma560_3dof_d11_real nc3_z = -0.1828673*(t1 + 0.1618660088490397*ww3_xy);
    const puma560_3dof_d11_real t2 = c23*ww3_xy + s23*neg_lam3_22;
    const puma560_3dof_d11_real t3 = ww2_xy - 7.814007790748863*c2 -
        0.10202200353484152*(c2*(s23*ww3_xy - c23*neg_lam3_22) - s2*t2);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d11_real n02_z = nc3_z + 1.792430002*t3;
    const puma560_3dof_d11_real t4 = s2*(ww2_xy + 0.653779902053964*neg_ww2_yz) + c2*(neg_lam2_11 -
        neg_lam2_33 - 35.12009493576415*neg_ww2_zx) + 0.6111625861298536*(t2 +
        5.753497668221186*(c2*neg_ww3_yz));
    const puma560_3dof_d11_real t5 = t4 - 0.0749924005297194*(c23*neg_ww3_zx +
        8.149660256410256*(s23*(neg_lam2_33 + 5.753497668221186*neg_ww2_zx -
        1.0540002060806373*neg_ww3_yz)));
    const puma560_3dof_d11_real neg_n02_y = 0.104010539*t5;
    tau[0] = neg_n02_y;
    tau[1] = n02_z;
    tau[2] = nc3_z;
}

/* mass matrix, rotor inertias on its diagonal
 * 13 multiplications, 14 additions = 27; 0 unary minus; 4 sine/cosine */
void puma560_3dof_d11_mass_matrix(const puma560_3dof_d11_real q[3], puma560_3dof_d11_real M[9])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d11_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c2 = cos(q[1]);
    const puma560_3dof_d11_real s2 = sin(again[1]);
    const volatile puma560_3dof_d11_real angle23 = q[1] + q[2];
    const puma560_3dof_d11_real c23 = cos(angle23);
    const puma560_3dof_d11_real s23 = sin(angle23);
    const puma560_3dof_d11_real t1 = 0.0296*(c23*c23);
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_3dof_d11_real k3_xx = 0.0335 - t1;
    const puma560_3dof_d11_real k3_yy = t1 + 0.0039;
    const puma560_3dof_d11_real t2 = c2*s23;
    const puma560_3dof_d11_real t3 = s2*c23;
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m2_3 = 0.1828673*(t2 - t3) + 0.0374;
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m1_3 = -0.06356735*c23;
    const puma560_3dof_d11_real t4 = k3_xx + 0.3657346*t2;
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m2_2 = 1.860430002 - (0.3657346*t3 - k3_yy - t4);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d11_real k2_xx = t4 + 1.792430002*(c2*c2 + 0.01896866263232744);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m1_2 = 0.11051088*(1.9411791762041892*(s2 - 0.2963216927070578*c23)
        - s2);
    const puma560_3dof_d11_real m1_1 = k2_xx + 1.5643917105;
    M[0] = m1_1;
    M[1] = m1_2;
    M[2] = m1_3;
    M[3] = m1_2;
    M[4] = m2_2;
    M[5] = m2_3;
    M[6] = m1_3;
    M[7] = m2_3;
    M[8] = 0.0374;
}

/* accelerations that the torques tau give
 * 75 multiplications, 50 additions, 2 divisions = 127; 4 unary minus; 4 sine/cosine */
void puma560_3dof_d11_forward_dynamics(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    const puma560_3dof_d11_real tau[3],
    puma560_3dof_d11_real qdd[3])
{
    /* A second read of the angles: without it gcc joins sine and cosine into sincos, which not
     * every libm has. */
    const volatile puma560_3dof_d11_real *const again = q;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c2 = cos(q[1]);
    const puma560_3dof_d11_real t1 = -qd[0];
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real w2_y = t1*c2;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real s2 = sin(again[1]);
    /* link 2: angular velocity [rad/s] */
    const puma560_3dof_d11_real w2_x = t1*s2;
    /* link 2: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww2_yy = w2_y*w2_y;
    const puma560_3dof_d11_real ww2_zz = qd[1]*qd[1];
    const puma560_3dof_d11_real ww2_xy = w2_y*w2_x;
    const puma560_3dof_d11_real ww2_yz = w2_y*qd[1];
    const puma560_3dof_d11_real ww2_zx = w2_x*qd[1];
    /* link 2: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real lam2_11 = -ww2_yy - ww2_zz;
    const puma560_3dof_d11_real neg_lam2_33 = qd[0]*qd[0];
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real w3_z = qd[1] + qd[2];
    /* sines and cosines of the joint angles */
    const volatile puma560_3dof_d11_real angle23 = q[1] + q[2];
    const puma560_3dof_d11_real s23 = sin(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real w3_x = t1*s23;
    /* sines and cosines of the joint angles */
    const puma560_3dof_d11_real c23 = cos(angle23);
    /* link 3: angular velocity [rad/s] */
    const puma560_3dof_d11_real w3_y = t1*c23;
    /* link 3: products of the angular velocity [1/s^2] */
    const puma560_3dof_d11_real ww3_xy = w3_x*w3_y;
    const puma560_3dof_d11_real ww3_xx = w3_x*w3_x;
    const puma560_3dof_d11_real ww3_zz = w3_z*w3_z;
    const puma560_3dof_d11_real ww3_yz = w3_z*w3_y;
    const puma560_3dof_d11_real ww3_zx = w3_z*w3_x;
    /* link 3: lambda matrix: takes a position to its acceleration [1/s^2] */
    const puma560_3dof_d11_real lam3_22 = -ww3_xx - ww3_zz;
    const puma560_3dof_d11_real t2 = c23*(s2*ww2_xy - c2*lam2_11) + s23*(-c2*ww2_xy - s2*lam2_11 +
        22.69569245020843);
    const puma560_3dof_d11_real t3 = t2 + 0.1618660088490397*ww3_xy;
    const puma560_3dof_d11_real t4 = c23*ww3_xy - s23*lam3_22;
    const puma560_3dof_d11_real t5 = c2*(s23*ww3_xy + c23*lam3_22) - s2*t4 + 76.59139714973645*(c2 -
        0.1279753011231851*ww2_xy);
    /* link 2: moment through the joint, along the axes that its turn starts from [N m] */
    const puma560_3dof_d11_real neg_n02_z = 0.1828673*(t3 + t5);
    const puma560_3dof_d11_real t6 = t4 - 5.753497668221186*(c2*ww3_yz) +
        1.6362258140381816*(s2*(ww2_xy - 0.653779902053964*ww2_yz) + c2*(35.12009493576415*ww2_zx -
        (lam2_11 + neg_lam2_33)));
    const puma560_3dof_d11_real t7 = 8.58974358974359*(s23*(ww3_yz +
        5.458725373134328*(0.1738073182028717*neg_lam2_33 - ww2_zx))) - c23*ww3_zx -
        8.149660256410256*t6;
    const puma560_3dof_d11_real n02_y = 0.0078*t7;
    const puma560_3dof_d11_real t8 = c23*c23;
    const puma560_3dof_d11_real t9 = 0.0296*t8;
    /* link 3: second moment of the composite body [kg m^2] */
    const puma560_3dof_d11_real k3_xx = 0.0335 - t9;
    const puma560_3dof_d11_real k3_yy = t9 + 0.0039;
    const puma560_3dof_d11_real t10 = s2*c23;
    const puma560_3dof_d11_real t11 = c2*s23;
    const puma560_3dof_d11_real t12 = k3_xx + 0.3657346*t11;
    /* link 2: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m2_2 = 1.860430002 - (0.3657346*t10 - k3_yy - t12);
    /* link 2: second moment of the composite body [kg m^2] */
    const puma560_3dof_d11_real k2_xx = t12 + 1.792430002*(c2*c2 + 0.01896866263232744);
    /* link 1: mass matrix, its row of this joint */
    const puma560_3dof_d11_real m1_2 = 0.104010539*(s2 - 0.6111625861298536*c23);
    const puma560_3dof_d11_real m1_1 = k2_xx + 1.5643917105;
    const puma560_3dof_d11_real t13 = t11 - t10 + 0.20451988955925965;
    /* factorisation M = U D U^T */
    const puma560_3dof_d11_real pivot2 = m2_2 - 0.89412966335*(t13*t13);
    const puma560_3dof_d11_real ipivot2 = 1.0 / pivot2;
    const puma560_3dof_d11_real ud1_2 = m1_2 + 0.310812557825*(c23*t13);
    const puma560_3dof_d11_real u1_2 = ipivot2*ud1_2;
    const puma560_3dof_d11_real pivot1 = m1_1 - 0.10804299427867647*t8 - ud1_2*u1_2;
    const puma560_3dof_d11_real ipivot1 = 1.0 / pivot1;
    const puma560_3dof_d11_real t14 = t3 + 5.46844624489999*tau[2];
    /* link 2: forward substitution */
    const puma560_3dof_d11_real y2 = neg_n02_z + tau[1] - 0.89412966335*(t13*t14);
    /* link 1: forward substitution */
    const puma560_3dof_d11_real y1 = n02_y + tau[0] + 0.310812557825*(c23*t14) - u1_2*y2;
    /* link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d11_real qdd1 = ipivot1*y1;
    /* link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d11_real qdd2 = ipivot2*y2 - u1_2*qdd1;
    /* link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2] */
    const puma560_3dof_d11_real qdd3 = 1.6996617647058823*(c23*qdd1 + 2.876748834110593*(t14 -
        t13*qdd2));
    qdd[0] = qdd1;
    qdd[1] = qdd2;
    qdd[2] = qdd3;
}
