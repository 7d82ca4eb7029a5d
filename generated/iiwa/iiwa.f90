! iiwa: KUKA iiwa 14 geometry, random full inertias
! Numbers: published iiwa geometry; inertial parameters drawn at random
! Origin of numbers: geometry: stated by the description
! Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 470f3a2263cc6972820aa958e2c80090 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0  d 0.34   theta q
!   2  revolute  alpha -pi/2  a 0  d 0      theta q
!   3  revolute  alpha pi/2   a 0  d 0.4    theta q
!   4  revolute  alpha pi/2   a 0  d 0      theta q
!   5  revolute  alpha -pi/2  a 0  d 0.4    theta q
!   6  revolute  alpha -pi/2  a 0  d 0      theta q
!   7  revolute  alpha pi/2   a 0  d 0.126  theta q
! Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
! Arguments, in SI units, joint 1 first:
!   q    joint positions [rad, prismatic m]
!   qd   joint velocities [rad/s, prismatic m/s]
!   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
!   tau  joint torques [N m, prismatic N]
!   M    mass matrix, row by row [kg m^2, kg m, kg]
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
!   parameters, equal to the recursion without being written like it: robodyn --optimize full,
!   seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 258 multiplications, 247 additions = 505; 6 unary minus; 12 sine/cosine
!   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
!   bias: 243 multiplications, 227 additions = 470; 7 unary minus; 12 sine/cosine
!   mass_matrix: 133 multiplications, 125 additions = 258; 6 unary minus; 12 sine/cosine
!   forward_dynamics: 500 multiplications, 455 additions, 6 divisions = 961; 18 unary minus; 12
!       sine/cosine
module iiwa_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: iiwa_inverse_dynamics
  public :: iiwa_gravity
  public :: iiwa_bias
  public :: iiwa_mass_matrix
  public :: iiwa_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 258 multiplications, 247 additions = 505; 6 unary minus; 12 sine/cosine
  pure subroutine iiwa_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="iiwa_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, w2_x, c2, w2_y, lam2_23, ww2_yz, alpha2_x, c3, s3, w3_x, w3_z, w3_y, alpha3_x
    real(rk) :: alpha3_y, ww3_zx, ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23, lam3_31
    real(rk) :: lam3_32, c4, s4, w4_x, w4_z, w4_y, alpha4_z, ww4_xy, ww4_yz, ww4_zz, ww4_yy, ww4_zx
    real(rk) :: lam4_12, lam4_21, neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy, ww5_xx, ww5_zz
    real(rk) :: ww5_yy, ww5_yz, ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zx, ww6_zz
    real(rk) :: ww6_yz, ww6_xy, ww6_yy, neg_lam6_11, w7_z, c7, s7, neg_lam2_13, ww2_zx, alpha3_z
    real(rk) :: alpha4_y, lam4_31, lam3_21, alpha4_x, lam4_32, t1, lam4_22, alpha5_z, lam5_12
    real(rk) :: ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x, alpha7_z, t6, lam6_13, neg_alpha5_y
    real(rk) :: alpha6_z, lam6_21, alpha6_x, lam6_12, lam6_23, t7, t8, t9, t10, t11, t12, t13, t14
    real(rk) :: t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, t31
    real(rk) :: t32, t33, t34, t35, t36, t37, n6_z, lam5_31, lam5_32, t38, n5_y, neg_lam5_11
    real(rk) :: lam5_21, t39, lam6_31, lam6_32, t40, t41, t42, nc7_z, t43, t44, t45, n5_x, lam4_23
    real(rk) :: lam4_13, lam5_23, lam5_13, t46, n5_z, t47, t48, t49, t50, t51, t52, n4_z, lam3_12
    real(rk) :: ww2_zz, t53, t54, t55, t56, t57, t58, t59, t60, t61, n3_z, t62, t63, t64, t65, t66
    real(rk) :: t67, t68, t69, t70, t71, t72, t73, n1_z, t74, n2_z

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = -s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -qd(1)*c2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - lam2_23
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    w3_y = qd(2)*c3 - w2_x*s3
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y + (s3*qdd(2) + alpha2_x*c3)
    alpha3_y = c3*qdd(2) - alpha2_x*s3 - w3_x*qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zx = w3_x*w3_z
    ww3_yz = w3_z*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yy = w3_y*w3_y
    ww3_xy = w3_x*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_13 = alpha3_y + ww3_zx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    w4_y = w3_z*c4 - w3_x*s4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_yz = w4_z*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = ww4_xy - alpha4_z
    lam4_21 = alpha4_z + ww4_xy
    neg_lam4_11 = ww4_zz + ww4_yy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = -w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_z*w5_y
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = -w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zx = w6_x*w6_z
    ww6_zz = w6_z*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_zz + ww6_yy
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = neg_lam2_13 + (ww2_zx + qdd(3))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = c4*alpha3_z - alpha3_x*s4 - w4_x*qd(4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = ww3_xy + alpha3_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s4*alpha3_z + (qd(4)*w4_y + alpha3_x*c4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t1 = ww5_zz - ww5_yy
    lam4_22 = t1 - neg_lam5_22
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = w7_z*w7_z
    t2 = ww7_zz - ww6_zz
    t3 = neg_lam5_22 - neg_lam6_11
    t4 = ww6_zz + ww7_zz
    t5 = t3 + t4
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_22 = t2 - t5
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - alpha4_z*s5 + c5*alpha4_x
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = s6*alpha5_x + (c6*alpha5_z + (w6_x*qd(6) + qdd(7)))
    t6 = alpha7_z - ww6_zx
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_13 = qdd(7) - t6
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_y = s5*alpha4_x + w5_x*qd(5) + alpha4_z*c5
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = qdd(6) - neg_alpha5_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha6_z
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x - (s6*alpha5_z - qd(6)*w6_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha6_z
    lam6_23 = ww6_yz - alpha6_x
    t7 = 0.150926706942488_rk*s7
    t8 = 0.3999801598546772_rk*c7
    t9 = t7*t8
    t10 = c7*c7
    t11 = 1.6791988194353373_rk*t9 - 0.2114247825686032_rk*(t10 + (t10 - 1.0_rk))
    t12 = qd(7) + w7_z
    t13 = alpha6_x + w6_z*t12
    t14 = w6_x*t12 - alpha6_z
    t15 = 0.10136935104159488_rk*t10 + 7.004567783863868_rk*(t9 + 0.027254918056712832_rk)
    t16 = t15 - 0.48318719298539553_rk
    t17 = t8 - 0.283322719186478_rk*s7
    t18 = c7 - 1.886194582347621_rk*t17
    t19 = 0.6146235514133187_rk*t18
    t20 = 24.525_rk*s2
    t21 = c3*t20
    t22 = lam3_13 - t21
    t23 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t24 = c4*t22 - s4*t23
    t25 = lam4_12 + t24
    t26 = s3*t20
    t27 = lam3_23 + t26
    t28 = t27 - lam4_32
    t29 = c5*t25 + s5*t28
    t30 = s4*t22 + c4*t23
    t31 = t30 - lam4_22
    t32 = c6*t29 + s6*t31
    t33 = t11*t13 + t14*t16 - (t6*t19 - 0.516451399126078_rk*(t32 - &
        3.9286492336466137_rk*lam6_12)) + 0.4239952187044951_rk*lam6_21
    t34 = s6*t29 - c6*t31
    t35 = t7 - 0.32845591866705903_rk*c7
    t36 = neg_lam5_22 + lam6_22
    t37 = t33 - ((t17 - 0.6262523039785531_rk)*t34 - t35*(t4 + lam6_22)) - &
        0.0870114460092663_rk*lam6_13 + 0.36144292274665746_rk*(t3 - t36)
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t37 - 0.042925575293549574_rk*lam6_23
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx + neg_alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t38 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = n6_z - 0.10101181803004346_rk*(t31 - 0.40735671351278135_rk*(t1 - t38) + &
        0.562393163526197_rk*lam5_12) - 0.09474888781047501_rk*lam5_31 + &
        0.03284626166448073_rk*lam5_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy + alpha5_z
    t39 = -ww6_zx - alpha7_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_31 = -qdd(7) - t39
    lam6_32 = ww6_yz + alpha6_x
    t40 = 0.2166040477707155_rk*(s7 - 5.3266962774999085_rk*t18)
    t41 = s5*t25 - c5*t28
    t42 = t16*t39 + lam6_12*t19 + (t3*t11 + t32*t40 - (t17*t41 - t35*lam6_32))
    ! link 7: moment that turns the link [N m]
    nc7_z = t6*t15 + t42
    t43 = t11*t14 + 0.20655564034097101_rk*lam6_23 + 0.36144292274665746_rk*lam6_31 + &
        (0.0870114460092663_rk*t36 + t35*t39 - t13*t15)
    t44 = 0.516451399126078_rk*t41 - (t43 + (-2.0289563933923875_rk*lam6_32 - t2*t19) + t34*(t40 - &
        0.16772238154175834_rk) - 0.042925575293549574_rk*lam6_21)
    t45 = 0.0870114460092663_rk*(lam6_12 - 4.872867170364478_rk*lam6_31) - (nc7_z + &
        0.6262523039785531_rk*t41) + 0.20655564034097101_rk*lam6_13 + 0.16772238154175834_rk*(t32 &
        + 2.155007098183065_rk*lam6_32 - 0.25593230252852256_rk*t3)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = c6*t44 - s6*t45 - 0.05680835589544868_rk*(t1 - 0.7243272854859414_rk*(lam5_21 - &
        0.7982499176974512_rk*lam5_31))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx - neg_alpha5_y
    t46 = 0.05680835589544868_rk*lam5_13 - s6*t44 + 0.03284626166448073_rk*(t38 - &
        1.2527404987206214_rk*lam5_23) + 0.09474888781047501_rk*lam5_21 - c6*t45
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = 0.10101181803004346_rk*t41 + t46
    t47 = neg_lam4_11 + lam4_22
    t48 = 0.16772238154175834_rk*neg_lam5_22 - (t5*t40 - 0.516451399126078_rk*lam6_32 - &
        0.6262523039785531_rk*lam6_31) + t17*t39 + 0.10101181803004346_rk*lam5_21
    t49 = t13*t40 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 - t14*t17
    t50 = t4*t17 - t6*t40 - 0.6262523039785531_rk*neg_lam6_11 - 0.16772238154175834_rk*lam6_13 + &
        0.516451399126078_rk*lam6_12
    t51 = s6*t49 + c6*t50 - 0.10101181803004346_rk*neg_lam5_11
    t52 = s5*t48 - c5*t51
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 3.221934173968582_rk*(-0.00407339877875826_rk*lam4_23 - (t24 + &
        1.1078721061879098_rk*lam4_12 + 0.03002866125812244_rk*lam4_13 - &
        0.07713506882125255_rk*lam4_21)) - (0.20921122087079386_rk*t47 + s5*n5_x + (t52 + (c5*n5_y &
        - 0.2067207712712513_rk*t30)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - alpha3_z
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t53 = 0.2067207712712513_rk*(1.2125863432641177_rk*lam4_13 - t27 - &
        1.2022212993802541_rk*lam4_31) + (n5_z + 0.09675036990607108_rk*lam4_12) + &
        0.20921122087079386_rk*lam4_32
    t54 = ww4_zz - ww4_yy
    t55 = t53 + 0.013124222729483126_rk*(t47 + t54)
    t56 = s5*t51 + c5*t48
    t57 = s5*n5_y + 0.20921122087079386_rk*(lam4_31 - 0.06273192553848952_rk*lam4_21) - (t56 + &
        0.09675036990607108_rk*t54 + c5*n5_x)
    t58 = t57 + 0.2506667841125447_rk*lam4_23 + 3.221934173968582_rk*t27 - &
        3.569490999313376_rk*lam4_32
    t59 = ww3_zz - ww3_yy
    t60 = ww3_xx - ww3_zz
    t61 = c4*t55 + 0.40382182094267666_rk*alpha3_z - s4*t58 + 0.0816122074936837_rk*(lam3_13 - &
        4.983886823520953_rk*t26) + 0.1005265342798281_rk*(t59 + t60)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t61 - 0.24444456225550676_rk*(lam3_23 + 0.07183008482147359_rk*t21)
    t62 = c4*t58 - (t56 - (s4*t55 - 0.40382182094267666_rk*alpha3_x) + &
        3.221934173968582_rk*lam4_32 - 0.1005265342798281_rk*lam3_31)
    t63 = t62 + 0.43062156604456925_rk*c2 - 0.24444456225550676_rk*lam3_21 + &
        0.2067207712712513_rk*lam4_31 + 0.0816122074936837_rk*t59
    t64 = s4*(s6*t50 - 0.2067207712712513_rk*lam4_21 - c6*t49 + 3.221934173968582_rk*lam4_22 - &
        0.10101181803004346_rk*lam5_31)
    t65 = 0.40382182094267666_rk*(alpha3_y - 0.6053277697695444_rk*t60 + 24.70259225523076_rk*c2) &
        - (n4_z + t64) + 0.1005265342798281_rk*lam3_32 - 0.0816122074936837_rk*lam3_12
    t66 = c4*(t52 + 3.221934173968582_rk*lam4_12 + 0.2067207712712513_rk*neg_lam4_11) + t65
    t67 = c2 + 1.3168563631156125_rk*s2
    t68 = 0.41715488532235584_rk*c2 - 0.15257424953911117_rk*t67
    t69 = 3.509903939799839_rk*c2
    t70 = c2*t69
    t71 = s2*t69
    t72 = qd(1)*(t71 + 0.29735998936351243_rk*(t70 - 1.7549519698999194_rk))
    t73 = qdd(1)*(t70 - 4.842302505434623_rk - 0.29735998936351243_rk*t71) - (2.0_rk*(qd(2)*t72) + &
        c2*n3_z) + 0.20091837135316784_rk*(ww2_zz*t67)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t63 + s3*t66) + qdd(2)*t68 - t73
    t74 = qd(1)*t72 - (c3*t66 - s3*t63 + 4.563077810408968_rk*(qdd(2) + 2.9130293283131543_rk*(c2 &
        - 5.768255406554391_rk*s2)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = qdd(1)*t68 - t74
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! torques that hold the arm at rest
  ! 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
  pure subroutine iiwa_gravity(q, tau) &
      bind(c, name="iiwa_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s7, c7, hw7_y, c6, c5, c4, s2, c3, c2, s4, s5, s3, s6, hw7_x, t1, t2, t3, t4, t5
    real(rk) :: tau7, t6, hw6_y, hw6_x, tau6, t7, t8, hw5_y, hw5_x, tau5, t9, t10, hw4_y, hw4_x
    real(rk) :: tau4, t11, t12, tau3, hw3_x, hw2_x, t13

    ! sines and cosines of the joint angles
    s7 = sin(q(7))
    c7 = cos(q(7))
    ! link 7: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw7_y = 9.809513420435959_rk*s7 + 6.948489688048372_rk*c7
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    c5 = cos(q(5))
    c4 = cos(q(4))
    s2 = sin(q(2))
    c3 = cos(q(3))
    c2 = cos(q(2))
    s4 = sin(q(4))
    s5 = sin(q(5))
    s3 = sin(q(3))
    s6 = sin(q(6))
    ! link 7: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw7_x = 9.809513420435959_rk*c7 - 6.948489688048372_rk*s7
    t1 = s2*c3
    t2 = c4*t1 - c2*s4
    t3 = s2*s3
    t4 = c5*t2 - s5*t3
    t5 = t1*s4 + c4*c2
    ! link 7: joint torque [N m], at a prismatic joint force [N]
    tau7 = hw7_y*(c6*t4 + s6*t5) + hw7_x*(t2*s5 + c5*t3)
    t6 = hw7_x - 15.358837755074015_rk
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_y = s6*t6 - 12.665970563567063_rk*c6
    hw6_x = c6*t6 + 12.665970563567063_rk*s6
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = t4*hw6_y - t5*hw6_x
    t7 = hw6_x - 2.4773148371868157_rk
    t8 = hw7_y + 4.113391407311623_rk
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = s5*t7 + c5*t8
    hw5_x = c5*t7 - s5*t8
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t2*hw5_y + t3*hw5_x
    t9 = hw5_x - 5.069826915427438_rk
    t10 = hw6_y - 79.01793561657948_rk
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = s4*t9 - c4*t10
    hw4_x = c4*t9 + s4*t10
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t1*hw4_y + c2*hw4_x
    t11 = hw5_y - 0.43062156604456925_rk
    t12 = hw4_x - 9.975445786511747_rk
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = t1*t11 + t3*t12
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = c3*t12 - s3*t11
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = c2*(hw3_x - 13.292379489096295_rk) + s2*(hw4_y + 76.6738398539524_rk)
    t13 = -hw2_x
    tau(1) = 0.0_rk
    tau(2) = t13
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
    tau(7) = tau7
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 243 multiplications, 227 additions = 470; 7 unary minus; 12 sine/cosine
  pure subroutine iiwa_bias(q, qd, tau) &
      bind(c, name="iiwa_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, w2_x, c2, w2_y, ww2_yz, c3, s3, w3_x, w3_z, w3_y, alpha3_x, alpha3_y, ww3_zx
    real(rk) :: ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23, lam3_31, lam3_32, c4, s4
    real(rk) :: w4_x, w4_z, w4_y, ww4_xy, ww4_yz, ww4_zz, ww4_yy, ww4_zx, lam4_12, lam4_21
    real(rk) :: neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy, ww5_xx, ww5_zz, ww5_yy, ww5_yz
    real(rk) :: ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zx, ww6_zz, ww6_yz, ww6_xy
    real(rk) :: ww6_yy, neg_lam6_11, w7_z, c7, s7, ww2_zx, alpha4_y, lam4_31, lam3_21, alpha4_x
    real(rk) :: lam4_32, t1, lam4_22, lam5_12, ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x, alpha7_z
    real(rk) :: lam6_13, alpha5_y, lam6_21, alpha6_x, lam6_12, lam6_23, t6, t7, t8, t9, t10, t11
    real(rk) :: t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28
    real(rk) :: t29, t30, t31, t32, t33, t34, t35, t36, n6_z, lam5_31, lam5_32, t37, n5_y
    real(rk) :: neg_lam5_11, lam5_21, lam6_31, lam6_32, t38, t39, t40, nc7_z, t41, t42, t43, t44
    real(rk) :: n5_x, lam4_23, lam4_13, lam5_23, lam5_13, t45, n5_z, t46, t47, t48, t49, t50, t51
    real(rk) :: n4_z, lam3_12, ww2_zz, t52, t53, t54, t55, t56, t57, t58, t59, t60, n3_z, t61, t62
    real(rk) :: t63, t64, t65, t66, t67, n1_z, n2_z

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = -s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    w3_y = qd(2)*c3 - w2_x*s3
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y + ww2_yz*c3
    alpha3_y = -w3_x*qd(3) - ww2_yz*s3
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zx = w3_x*w3_z
    ww3_yz = w3_z*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yy = w3_y*w3_y
    ww3_xy = w3_x*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_13 = alpha3_y + ww3_zx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    w4_y = w3_z*c4 - w3_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_yz = w4_z*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha3_y + ww4_xy
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_11 = ww4_zz + ww4_yy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = -w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_z*w5_y
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = -w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zx = w6_x*w6_z
    ww6_zz = w6_z*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_zz + ww6_yy
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = c4*ww2_zx - alpha3_x*s4 - w4_x*qd(4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = ww3_xy + ww2_zx
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s4*ww2_zx + (qd(4)*w4_y + alpha3_x*c4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t1 = ww5_zz - ww5_yy
    lam4_22 = t1 - neg_lam5_22
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = w7_z*w7_z
    t2 = ww7_zz - ww6_zz
    t3 = neg_lam5_22 - neg_lam6_11
    t4 = ww6_zz + ww7_zz
    t5 = t3 + t4
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_22 = t2 - t5
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y + alpha3_y*s5 + c5*alpha4_x
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = s6*alpha5_x - (-w6_x*qd(6) - c6*alpha4_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_13 = ww6_zx - alpha7_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = -w5_x*qd(5) - s5*alpha4_x + alpha3_y*c5
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha5_y
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x - (s6*alpha4_y - qd(6)*w6_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha5_y
    lam6_23 = ww6_yz - alpha6_x
    t6 = neg_lam5_22 + lam6_22
    t7 = 0.150926706942488_rk*s7
    t8 = t7 - 0.32845591866705903_rk*c7
    t9 = 0.3999801598546772_rk*c7
    t10 = t9 - 0.283322719186478_rk*s7
    t11 = t10 - 0.6262523039785531_rk
    t12 = 24.525_rk*s2
    t13 = c3*t12
    t14 = lam3_13 - t13
    t15 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t16 = c4*t14 - s4*t15
    t17 = lam4_12 + t16
    t18 = s3*t12
    t19 = lam3_23 + t18
    t20 = t19 - lam4_32
    t21 = c5*t17 + s5*t20
    t22 = s4*t14 + c4*t15
    t23 = t22 - lam4_22
    t24 = s6*t21 - c6*t23
    t25 = c6*t21 + s6*t23
    t26 = t7*t9
    t27 = c7*c7
    t28 = 1.6791988194353373_rk*t26 - 0.2114247825686032_rk*(t27 + (t27 - 1.0_rk))
    t29 = qd(7) + w7_z
    t30 = alpha6_x + w6_z*t29
    t31 = alpha5_y - w6_x*t29
    t32 = 0.10136935104159488_rk*t27 + 7.004567783863868_rk*(t26 + 0.027254918056712832_rk)
    t33 = t32 - 0.48318719298539553_rk
    t34 = t11*t24 - (0.4239952187044951_rk*lam6_21 + (0.516451399126078_rk*(t25 - &
        3.9286492336466137_rk*lam6_12) + (t28*t30 - t31*t33)))
    t35 = c7 - 1.886194582347621_rk*t10
    t36 = 0.6146235514133187_rk*t35
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = 0.36144292274665746_rk*(t3 - t6) + (t8*(t4 + lam6_22) - t34) - &
        0.042925575293549574_rk*lam6_23 + lam6_13*(t36 - 0.0870114460092663_rk)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t37 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = n6_z - 0.10101181803004346_rk*(t23 - 0.40735671351278135_rk*(t1 - t37) + &
        0.562393163526197_rk*lam5_12) - 0.09474888781047501_rk*lam5_31 + &
        0.03284626166448073_rk*lam5_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy + alpha4_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_31 = ww6_zx + alpha7_z
    lam6_32 = ww6_yz + alpha6_x
    t38 = 0.2166040477707155_rk*(s7 - 5.3266962774999085_rk*t35)
    t39 = s5*t17 - c5*t20
    t40 = lam6_12*t36 - t33*lam6_31 + (t3*t28 + t25*t38 - (t10*t39 - t8*lam6_32))
    ! link 7: moment that turns the link [N m]
    nc7_z = t40 - lam6_13*t32
    t41 = t38 - 0.16772238154175834_rk
    t42 = -2.0289563933923875_rk*lam6_32 - (t30*t32 - (0.0870114460092663_rk*t6 - (t28*t31 - &
        0.20655564034097101_rk*lam6_23))) - t2*t36
    t43 = 0.516451399126078_rk*t39 + (0.042925575293549574_rk*lam6_21 - (t24*t41 + t42)) + &
        lam6_31*(t8 - 0.36144292274665746_rk)
    t44 = 0.0870114460092663_rk*(lam6_12 - 4.872867170364478_rk*lam6_31) - (nc7_z + &
        0.6262523039785531_rk*t39) + 0.20655564034097101_rk*lam6_13 + 0.16772238154175834_rk*(t25 &
        + 2.155007098183065_rk*lam6_32 - 0.25593230252852256_rk*t3)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = c6*t43 - s6*t44 - 0.05680835589544868_rk*(t1 - 0.7243272854859414_rk*(lam5_21 - &
        0.7982499176974512_rk*lam5_31))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx + alpha5_y
    t45 = s6*t43 - 0.05680835589544868_rk*lam5_13 - 0.03284626166448073_rk*(t37 - &
        1.2527404987206214_rk*lam5_23) - 0.09474888781047501_rk*lam5_21 + c6*t44
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = 0.10101181803004346_rk*t39 - t45
    t46 = neg_lam4_11 + lam4_22
    t47 = -0.516451399126078_rk*lam6_32 - (0.16772238154175834_rk*neg_lam5_22 - t5*t38) - &
        0.10101181803004346_rk*lam5_21 + t11*lam6_31
    t48 = t30*t38 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 + t31*t10
    t49 = 0.516451399126078_rk*lam6_12 + (t4*t10 - 0.6262523039785531_rk*neg_lam6_11) + &
        lam6_13*t41
    t50 = s6*t48 + c6*t49 - 0.10101181803004346_rk*neg_lam5_11
    t51 = s5*t47 + c5*t50
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 3.221934173968582_rk*(-0.00407339877875826_rk*lam4_23 - (t16 + &
        1.1078721061879098_rk*lam4_12 + 0.03002866125812244_rk*lam4_13 - &
        0.07713506882125255_rk*lam4_21)) - (0.20921122087079386_rk*t46 + s5*n5_x - (t51 - (c5*n5_y &
        - 0.2067207712712513_rk*t22)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t52 = 0.2067207712712513_rk*(1.2125863432641177_rk*lam4_13 - t19 - &
        1.2022212993802541_rk*lam4_31) + (n5_z + 0.09675036990607108_rk*lam4_12) + &
        0.20921122087079386_rk*lam4_32
    t53 = ww4_zz - ww4_yy
    t54 = t52 + 0.013124222729483126_rk*(t46 + t53)
    t55 = s5*t50 - c5*t47
    t56 = s5*n5_y + 0.20921122087079386_rk*(lam4_31 - 0.06273192553848952_rk*lam4_21) - (t55 + &
        0.09675036990607108_rk*t53 + c5*n5_x)
    t57 = t56 + 0.2506667841125447_rk*lam4_23 + 3.221934173968582_rk*t19 - &
        3.569490999313376_rk*lam4_32
    t58 = ww3_zz - ww3_yy
    t59 = ww3_xx - ww3_zz
    t60 = c4*t54 + 0.40382182094267666_rk*ww2_zx - s4*t57 + 0.0816122074936837_rk*(lam3_13 - &
        4.983886823520953_rk*t18) + 0.1005265342798281_rk*(t58 + t59)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t60 - 0.24444456225550676_rk*(lam3_23 + 0.07183008482147359_rk*t13)
    t61 = c4*t57 - (t55 - (s4*t54 - 0.40382182094267666_rk*alpha3_x) + &
        3.221934173968582_rk*lam4_32 - 0.1005265342798281_rk*lam3_31)
    t62 = t61 + 0.43062156604456925_rk*c2 - 0.24444456225550676_rk*lam3_21 + &
        0.2067207712712513_rk*lam4_31 + 0.0816122074936837_rk*t58
    t63 = s4*(s6*t49 - 0.2067207712712513_rk*lam4_21 - c6*t48 + 3.221934173968582_rk*lam4_22 - &
        0.10101181803004346_rk*lam5_31)
    t64 = 0.40382182094267666_rk*(alpha3_y - 0.6053277697695444_rk*t59 + 24.70259225523076_rk*c2) &
        - (n4_z + t63) + 0.1005265342798281_rk*lam3_32 - 0.0816122074936837_rk*lam3_12
    t65 = c4*(t51 - 3.221934173968582_rk*lam4_12 - 0.2067207712712513_rk*neg_lam4_11) - t64
    t66 = 3.509903939799839_rk*c2
    t67 = qd(1)*(s2*t66 + 0.29735998936351243_rk*(c2*t66 - 1.7549519698999194_rk))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t62 - s3*t65) + (2.0_rk*(qd(2)*t67) + c2*n3_z - &
        0.20091837135316784_rk*(ww2_zz*(c2 + 1.3168563631156125_rk*s2)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 13.292379489096295_rk*(c2 - 5.768255406554391_rk*s2) - (c3*t65 + s3*t62) - qd(1)*t67
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 133 multiplications, 125 additions = 258; 6 unary minus; 12 sine/cosine
  pure subroutine iiwa_mass_matrix(q, M) &
      bind(c, name="iiwa_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, t2, t3, t4, t5, m6_7, t6, t7
    real(rk) :: t8, t9, t10, k6_xz, k6_yz, t11, neg_m6_6, t12, t13, t14, t15, m5_5, t16, t17, k5_yz
    real(rk) :: t18, t19, t20, t21, t22, t23, t24, t25, m4_5, t26, t27, t28, t29, t30, t31, t32
    real(rk) :: k4_xz, t33, t34, t35, t36, t37, t38, m4_4, neg_k4_yz, t39, t40, t41, t42, t43, t44
    real(rk) :: m3_3, t45, t46, t47, t48, neg_nu2_y, t49, t50, t51, t52, t53, t54, t55, t56, t57
    real(rk) :: m1_1, m2_3, k2_yz, nu4_y, t58, nu4_x, m4_6, nu6_y, nu6_x, t59, t60, m4_7, m2_2
    real(rk) :: m2_4, t61, t62, m2_5, t63, t64, m2_6, t65, t66, t67, t68, m2_7, t69, t70, t71, t72
    real(rk) :: t73, t74, t75, t76

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    c7 = cos(q(7))
    s7 = sin(q(7))
    t1 = 0.150926706942488_rk*s7
    t2 = 0.32845591866705903_rk*c7
    t3 = t1 - t2
    t4 = c7 + 8.666599685695806_rk*t3
    t5 = t4 - 35.29326509144399_rk*t1
    ! link 6: mass matrix, its row of this joint
    m6_7 = 0.08173239305750822_rk*t5
    t6 = -m6_7 - 0.0870114460092663_rk
    t7 = 1.2873860421003098_rk*t2
    t8 = c7*t7 - 0.25435035786215276_rk
    t9 = s7*t7
    t10 = t8 - 0.23972911266611452_rk*t9
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = s6*t6 + c6*t10
    k6_yz = s6*t10 - c6*t6
    t11 = t9 + (0.23972911266611452_rk*t8 + 1.3736580882709999_rk)
    ! link 6: mass matrix, its row of this joint
    neg_m6_6 = t11 - 4.057912786784775_rk
    t12 = c6*t11
    t13 = 0.48318719298539553_rk*c6
    t14 = 4.139182554990548_rk*(t13*(t3 - 0.36144292274665746_rk))
    t15 = c6*t12 + (s6*t14 - 5.266399726626112_rk)
    ! link 5: mass matrix, its row of this joint
    m5_5 = neg_m6_6 - t15
    t16 = t3 - (c6*t14 + 0.4025907649653271_rk) + s6*t12
    t17 = -k6_yz - 0.05680835589544868_rk
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = s5*t16 + c5*t17
    t18 = 0.09953035942575048_rk*(c7 - t5)
    t19 = t18 + 0.16772238154175834_rk
    t20 = 0.2166040477707155_rk*t4
    t21 = t20 + 0.6262523039785531_rk
    t22 = 0.516451399126078_rk*s6
    t23 = c6*t21 - t22
    t24 = t23 + 0.10101181803004346_rk
    t25 = c5*t19 - s5*t24
    ! link 4: mass matrix, its row of this joint
    m4_5 = k5_yz + t25
    t26 = c5*s5
    t27 = t15 + (t11 + 2.227476104061723_rk)
    t28 = k6_xz - 0.06569252332896146_rk
    t29 = k6_xz + t28
    t30 = c5*c5
    t31 = t26*t27 + 0.019722038934997604_rk + (t28 - t29*t30)
    t32 = m4_5 - 0.09675036990607108_rk
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = c4*t31 + s4*t32
    t33 = s6*t21 + 1.0688433108815611_rk*t13
    t34 = t33 + 3.221934173968582_rk
    t35 = neg_m6_6 - t33
    t36 = t34 - t35
    t37 = t26*t29 + (t30*t27 + 0.19378159890865698_rk)
    t38 = t37 - (t27 + 0.884611426310538_rk)
    ! link 4: mass matrix, its row of this joint
    m4_4 = t36 - t38
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = c4*t32 - s4*t31
    t39 = s5*t19 + c5*t24
    t40 = t39 - c5*t16 + s5*t17
    t41 = s4*t40
    t42 = 0.4184224417415877_rk*(s4 + 4.7798583452538_rk*t41)
    t43 = s4*(t37 + t36 - m5_5)
    t44 = c4*t42 + (s4*t43 + 0.9030127193018334_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = m5_5 + t44
    t45 = t39 + 0.2067207712712513_rk
    t46 = t40 + (c4*(t43 + t45) + 0.4536557831263006_rk - s4*(t42 - t34))
    t47 = t25 - (0.0816122074936837_rk - neg_k4_yz)
    t48 = c3*t46 + s3*t47
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*m3_3 - s2*t48
    t49 = t37 + (t38 + 1.4022036176609902_rk) - t44
    t50 = c3*t49
    t51 = c3*k4_xz
    t52 = 0.2010530685596562_rk*c3 + 2.0_rk*t51
    t53 = c3*t50 + 3.9137257607425155_rk - s3*t52
    t54 = c4*t34 - s4*t45
    t55 = t54 + m4_4
    t56 = t54 + t55
    t57 = t53 + t56
    ! link 1: mass matrix, its row of this joint
    m1_1 = t57 - (c2*(c2*t57 + (s2*(t48 - 1.0437049982058304_rk) - neg_nu2_y)) - &
        1.3323985656347848_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t46 - c3*t47
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 + 0.26458063578324464_rk) + s2*(k4_xz - (c3*t52 + (s3*t50 + &
        0.10039183707333973_rk)))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = t41 + c4*m5_5
    t58 = s5*t35 - c5*k6_xz
    nu4_x = c4*t58 - s4*k6_yz
    ! link 4: mass matrix, its row of this joint
    m4_6 = c5*t35 + s5*k6_xz
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_y = s6*t3 - t13
    nu6_x = c6*t3 + 0.9355908296560508_rk*t22
    t59 = c6*t18
    t60 = s5*t20 - c5*t59
    ! link 4: mass matrix, its row of this joint
    m4_7 = -s5*nu6_x - (t60 + c5*m6_7)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t49 + t56 + 8.88062539209416_rk - t53
    m2_4 = -s3*k4_xz - c3*t55
    t61 = t39 + c4*t40 - s4*m5_5
    t62 = m4_5 + c4*t25
    m2_5 = s3*t61 - c3*t62
    t63 = c4*(c5*t33) - s4*t23 - m4_6
    t64 = s5*t33 - nu4_x
    m2_6 = c3*t63 - s3*t64
    t65 = c5*t20 + s5*t59
    t66 = c5*nu6_x + t65 - s5*m6_7
    t67 = c4*t66 + (t65 + s4*nu6_y)
    t68 = t18*(s4*s6) - (c4*t60 - m4_7)
    m2_7 = s3*t67 - c3*t68
    t69 = c2*neg_k4_yz + s2*(t51 - s3*t55)
    t70 = c2*nu4_y - s2*(c3*t61 + s3*t62)
    t71 = s4*t58 + c4*k6_yz
    t72 = c2*t71 + s2*(c3*t64 + s3*t63)
    t73 = s4*t66 - c4*nu6_y
    t74 = c2*t73 - s2*(c3*t67 + s3*t68)
    t75 = -nu6_y
    t76 = -neg_m6_6
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y
    M(4) = t69
    M(5) = t70
    M(6) = t72
    M(7) = t74
    M(8) = k2_yz
    M(9) = m2_2
    M(10) = m2_3
    M(11) = m2_4
    M(12) = m2_5
    M(13) = m2_6
    M(14) = m2_7
    M(15) = neg_nu2_y
    M(16) = m2_3
    M(17) = m3_3
    M(18) = neg_k4_yz
    M(19) = nu4_y
    M(20) = t71
    M(21) = t73
    M(22) = t69
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = m4_7
    M(29) = t70
    M(30) = m2_5
    M(31) = nu4_y
    M(32) = m4_5
    M(33) = m5_5
    M(34) = k6_yz
    M(35) = t75
    M(36) = t72
    M(37) = m2_6
    M(38) = t71
    M(39) = m4_6
    M(40) = k6_yz
    M(41) = t76
    M(42) = m6_7
    M(43) = t74
    M(44) = m2_7
    M(45) = t73
    M(46) = m4_7
    M(47) = t75
    M(48) = m6_7
    M(49) = 0.48318719298539553_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 500 multiplications, 455 additions, 6 divisions = 961; 18 unary minus; 12 sine/cosine
  pure subroutine iiwa_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="iiwa_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: s2, w2_x, c2, w2_y, ww2_yz, c3, s3, w3_x, w3_z, w3_y, alpha3_x, alpha3_y, ww3_zx
    real(rk) :: ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23, lam3_31, lam3_32, c4, s4
    real(rk) :: w4_x, w4_z, w4_y, ww4_xy, ww4_yz, ww4_zz, ww4_yy, ww4_zx, lam4_12, lam4_21
    real(rk) :: neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy, ww5_xx, ww5_zz, ww5_yy, ww5_yz
    real(rk) :: ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zx, ww6_zz, ww6_yz, ww6_xy
    real(rk) :: ww6_yy, neg_lam6_11, w7_z, c7, s7, ww2_zx, neg_alpha4_y, lam4_31, lam3_21, alpha4_x
    real(rk) :: lam4_32, t1, lam4_22, lam5_12, ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x, alpha7_z
    real(rk) :: lam6_13, alpha5_y, lam6_21, alpha6_x, lam6_12, lam6_23, t6, t7, t8, t9, t10, t11
    real(rk) :: t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28
    real(rk) :: t29, t30, t31, t32, t33, t34, t35, t36, n6_z, lam5_31, lam5_32, t37, n5_y
    real(rk) :: neg_lam5_11, lam5_21, lam6_31, lam6_32, t38, t39, t40, nc7_z, t41, t42, t43, t44
    real(rk) :: t45, n5_x, lam4_23, lam4_13, lam5_23, lam5_13, t46, n5_z, t47, t48, t49, t50, t51
    real(rk) :: t52, n4_z, lam3_12, ww2_zz, t53, t54, t55, t56, t57, t58, t59, t60, t61, n3_z, t62
    real(rk) :: t63, t64, t65, t66, t67, t68, n1_z, n2_z, t69, t70, m6_7, t71, t72, t73, t74, t75
    real(rk) :: k6_xz, k6_yz, t76, m6_6, t77, t78, t79, t80, m5_5, t81, t82, k5_yz, t83, t84, t85
    real(rk) :: t86, t87, t88, t89, m4_5, t90, t91, t92, t93, t94, t95, t96, k4_xz, t97, t98, t99
    real(rk) :: t100, t101, t102, m4_4, k4_yz, t103, t104, t105, t106, t107, t108, m3_3, t109, t110
    real(rk) :: t111, t112, nu2_y, t113, t114, t115, t116, t117, t118, t119, t120, t121, m1_1, m2_3
    real(rk) :: k2_yz, nu4_y, t122, nu4_x, m4_6, nu6_y, nu6_x, t123, t124, m4_7, m2_2, m2_4, t125
    real(rk) :: t126, m2_5, t127, t128, m2_6, t129, t130, t131, t132, m2_7, ud3_7, ud1_7, y7, u6_7
    real(rk) :: u5_7, u4_7, u3_7, u2_7, u1_7, pivot6, ipivot6, ud5_6, u5_6, ud4_6, u4_6, t133
    real(rk) :: ud3_6, u3_6, ud2_6, u2_6, ud1_6, u1_6, pivot5, ipivot5, ud4_5, u4_5, ud3_5, u3_5
    real(rk) :: ud2_5, u2_5, ud1_5, u1_5, pivot4, ipivot4, ud3_4, u3_4, ud2_4, u2_4, ud1_4, u1_4
    real(rk) :: pivot3, ipivot3, ud2_3, u2_3, ud1_3, u1_3, pivot2, ipivot2, ud1_2, u1_2, t134
    real(rk) :: pivot1, ipivot1, y6, y5, y4, y3, t135, y2, t136, neg_y1, neg_qdd1, qdd2, qdd3, qdd4
    real(rk) :: qdd5, qdd6, t137, qdd7, t138

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = -s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    w3_y = qd(2)*c3 - w2_x*s3
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y + ww2_yz*c3
    alpha3_y = -ww2_yz*s3 - w3_x*qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zx = w3_x*w3_z
    ww3_yz = w3_z*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ww3_yy = w3_y*w3_y
    ww3_xy = w3_x*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_13 = alpha3_y + ww3_zx
    lam3_23 = ww3_yz - alpha3_x
    lam3_31 = ww3_zx - alpha3_y
    lam3_32 = alpha3_x + ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 + w3_z*s4
    w4_z = qd(4) - w3_y
    w4_y = w3_z*c4 - w3_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_yz = w4_z*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha3_y + ww4_xy
    lam4_21 = ww4_xy - alpha3_y
    neg_lam4_11 = ww4_zz + ww4_yy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = -w4_z*c5 - w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yy = w5_y*w5_y
    ww5_yz = w5_z*w5_y
    ww5_zx = w5_x*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 - w5_z*s6
    w6_z = w5_y + qd(6)
    w6_y = -w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zx = w6_x*w6_z
    ww6_zz = w6_z*w6_z
    ww6_yz = w6_z*w6_y
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_11 = ww6_zz + ww6_yy
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_y = alpha3_x*s4 - c4*ww2_zx + w4_x*qd(4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx + neg_alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = ww3_xy + ww2_zx
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s4*ww2_zx + (qd(4)*w4_y + alpha3_x*c4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t1 = ww5_zz - ww5_yy
    lam4_22 = t1 - neg_lam5_22
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy + neg_alpha4_y
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = w7_z*w7_z
    t2 = ww7_zz - ww6_zz
    t3 = neg_lam5_22 - neg_lam6_11
    t4 = ww6_zz + ww7_zz
    t5 = t3 + t4
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_22 = t2 - t5
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y + alpha3_y*s5 + c5*alpha4_x
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = s6*alpha5_x - (c6*neg_alpha4_y - w6_x*qd(6))
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_13 = ww6_zx - alpha7_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = -s5*alpha4_x - w5_x*qd(5) + alpha3_y*c5
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha5_y
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x + (s6*neg_alpha4_y + qd(6)*w6_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha5_y
    lam6_23 = ww6_yz - alpha6_x
    t6 = neg_lam5_22 + lam6_22
    t7 = 0.150926706942488_rk*s7
    t8 = t7 - 0.32845591866705903_rk*c7
    t9 = 0.3999801598546772_rk*c7
    t10 = t9 - 0.283322719186478_rk*s7
    t11 = t10 - 0.6262523039785531_rk
    t12 = 24.525_rk*s2
    t13 = c3*t12
    t14 = lam3_13 - t13
    t15 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t16 = c4*t14 - s4*t15
    t17 = lam4_12 + t16
    t18 = s3*t12
    t19 = lam3_23 + t18
    t20 = t19 - lam4_32
    t21 = c5*t17 + s5*t20
    t22 = s4*t14 + c4*t15
    t23 = t22 - lam4_22
    t24 = s6*t21 - c6*t23
    t25 = c6*t21 + s6*t23
    t26 = t7*t9
    t27 = c7*c7
    t28 = 1.6791988194353373_rk*t26 - 0.2114247825686032_rk*(t27 + (t27 - 1.0_rk))
    t29 = qd(7) + w7_z
    t30 = alpha6_x + w6_z*t29
    t31 = alpha5_y - w6_x*t29
    t32 = 0.10136935104159488_rk*t27 + 7.004567783863868_rk*(t26 + 0.027254918056712832_rk)
    t33 = t32 - 0.48318719298539553_rk
    t34 = t11*t24 - (0.4239952187044951_rk*lam6_21 + (0.516451399126078_rk*(t25 - &
        3.9286492336466137_rk*lam6_12) + (t28*t30 - t31*t33)))
    t35 = c7 - 1.886194582347621_rk*t10
    t36 = 0.6146235514133187_rk*t35
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = 0.36144292274665746_rk*(t3 - t6) + (t8*(t4 + lam6_22) - t34) - &
        0.042925575293549574_rk*lam6_23 + lam6_13*(t36 - 0.0870114460092663_rk)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t37 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = n6_z - 0.10101181803004346_rk*(t23 - 0.40735671351278135_rk*(t1 - t37) + &
        0.562393163526197_rk*lam5_12) - 0.09474888781047501_rk*lam5_31 + &
        0.03284626166448073_rk*lam5_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy - neg_alpha4_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_31 = ww6_zx + alpha7_z
    lam6_32 = ww6_yz + alpha6_x
    t38 = 0.2166040477707155_rk*(s7 - 5.3266962774999085_rk*t35)
    t39 = s5*t17 - c5*t20
    t40 = lam6_12*t36 - t33*lam6_31 + (t3*t28 + t25*t38 - (t10*t39 - t8*lam6_32))
    ! link 7: moment that turns the link [N m]
    nc7_z = t40 - lam6_13*t32
    t41 = t38 - 0.16772238154175834_rk
    t42 = -2.0289563933923875_rk*lam6_32 - (t30*t32 - (0.0870114460092663_rk*t6 - (t28*t31 - &
        0.20655564034097101_rk*lam6_23))) - t2*t36
    t43 = t8 - 0.36144292274665746_rk
    t44 = 0.516451399126078_rk*t39 + (0.042925575293549574_rk*lam6_21 - (t24*t41 + t42)) + &
        lam6_31*t43
    t45 = 0.0870114460092663_rk*(lam6_12 - 4.872867170364478_rk*lam6_31) - (nc7_z + &
        0.6262523039785531_rk*t39) + 0.20655564034097101_rk*lam6_13 + 0.16772238154175834_rk*(t25 &
        + 2.155007098183065_rk*lam6_32 - 0.25593230252852256_rk*t3)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = c6*t44 - s6*t45 - 0.05680835589544868_rk*(t1 - 0.7243272854859414_rk*(lam5_21 - &
        0.7982499176974512_rk*lam5_31))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx - neg_alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx + alpha5_y
    t46 = s6*t44 - 0.05680835589544868_rk*lam5_13 - 0.03284626166448073_rk*(t37 - &
        1.2527404987206214_rk*lam5_23) - 0.09474888781047501_rk*lam5_21 + c6*t45
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = 0.10101181803004346_rk*t39 - t46
    t47 = neg_lam4_11 + lam4_22
    t48 = -0.516451399126078_rk*lam6_32 - (0.16772238154175834_rk*neg_lam5_22 - t5*t38) - &
        0.10101181803004346_rk*lam5_21 + t11*lam6_31
    t49 = t30*t38 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 + t10*t31
    t50 = 0.516451399126078_rk*lam6_12 + (t4*t10 - 0.6262523039785531_rk*neg_lam6_11) + &
        lam6_13*t41
    t51 = s6*t49 + c6*t50 - 0.10101181803004346_rk*neg_lam5_11
    t52 = s5*t48 + c5*t51
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 3.221934173968582_rk*(-0.00407339877875826_rk*lam4_23 - (t16 + &
        1.1078721061879098_rk*lam4_12 + 0.03002866125812244_rk*lam4_13 - &
        0.07713506882125255_rk*lam4_21)) - (0.20921122087079386_rk*t47 + s5*n5_x - (t52 - (c5*n5_y &
        - 0.2067207712712513_rk*t22)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t53 = 0.2067207712712513_rk*(1.2125863432641177_rk*lam4_13 - t19 - &
        1.2022212993802541_rk*lam4_31) + (n5_z + 0.09675036990607108_rk*lam4_12) + &
        0.20921122087079386_rk*lam4_32
    t54 = ww4_zz - ww4_yy
    t55 = t53 + 0.013124222729483126_rk*(t47 + t54)
    t56 = s5*t51 - c5*t48
    t57 = s5*n5_y + 0.20921122087079386_rk*(lam4_31 - 0.06273192553848952_rk*lam4_21) - (t56 + &
        0.09675036990607108_rk*t54 + c5*n5_x)
    t58 = t57 + 0.2506667841125447_rk*lam4_23 + 3.221934173968582_rk*t19 - &
        3.569490999313376_rk*lam4_32
    t59 = ww3_zz - ww3_yy
    t60 = ww3_xx - ww3_zz
    t61 = c4*t55 + 0.40382182094267666_rk*ww2_zx - s4*t58 + 0.0816122074936837_rk*(lam3_13 - &
        4.983886823520953_rk*t18) + 0.1005265342798281_rk*(t59 + t60)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t61 - 0.24444456225550676_rk*(lam3_23 + 0.07183008482147359_rk*t13)
    t62 = c4*t58 - (t56 - (s4*t55 - 0.40382182094267666_rk*alpha3_x) + &
        3.221934173968582_rk*lam4_32 - 0.1005265342798281_rk*lam3_31)
    t63 = t62 + 0.43062156604456925_rk*c2 - 0.24444456225550676_rk*lam3_21 + &
        0.2067207712712513_rk*lam4_31 + 0.0816122074936837_rk*t59
    t64 = s4*(s6*t50 - 0.2067207712712513_rk*lam4_21 - c6*t49 + 3.221934173968582_rk*lam4_22 - &
        0.10101181803004346_rk*lam5_31)
    t65 = 0.40382182094267666_rk*(alpha3_y - 0.6053277697695444_rk*t60 + 24.70259225523076_rk*c2) &
        - (n4_z + t64) + 0.1005265342798281_rk*lam3_32 - 0.0816122074936837_rk*lam3_12
    t66 = c4*(t52 - 3.221934173968582_rk*lam4_12 - 0.2067207712712513_rk*neg_lam4_11) - t65
    t67 = 3.509903939799839_rk*c2
    t68 = qd(1)*(s2*t67 + 0.29735998936351243_rk*(c2*t67 - 1.7549519698999194_rk))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t63 - s3*t66) + (2.0_rk*(qd(2)*t68) + c2*n3_z - &
        0.20091837135316784_rk*(ww2_zz*(c2 + 1.3168563631156125_rk*s2)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 13.292379489096295_rk*(c2 - 5.768255406554391_rk*s2) - (c3*t66 + s3*t63) - qd(1)*t68
    t69 = c7 + 8.666599685695806_rk*t8
    t70 = t69 - 5.3266962774999085_rk*s7
    ! link 6: mass matrix, its row of this joint
    m6_7 = 0.08173239305750822_rk*t70
    t71 = 0.4228495651372064_rk*c7
    t72 = c7*t71 - 0.25435035786215276_rk
    t73 = s7*t71
    t74 = t72 - 0.23972911266611452_rk*t73
    t75 = 0.0870114460092663_rk + m6_7
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = c6*t74 - s6*t75
    k6_yz = s6*t74 + c6*t75
    t76 = t73 + (0.23972911266611452_rk*t72 + 1.3736580882709999_rk)
    ! link 6: mass matrix, its row of this joint
    m6_6 = 4.057912786784775_rk - t76
    t77 = 0.48318719298539553_rk*c6
    t78 = 4.139182554990548_rk*(t43*t77)
    t79 = c6*t76
    t80 = 5.266399726626112_rk - s6*t78 - c6*t79
    ! link 5: mass matrix, its row of this joint
    m5_5 = t80 - m6_6
    t81 = t8 - (c6*t78 + 0.4025907649653271_rk) + s6*t79
    t82 = k6_yz + 0.05680835589544868_rk
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = s5*t81 - c5*t82
    t83 = 0.09953035942575048_rk*(c7 - t70)
    t84 = 0.16772238154175834_rk + t83
    t85 = 0.2166040477707155_rk*t69
    t86 = 0.6262523039785531_rk + t85
    t87 = c6*t86 - 0.516451399126078_rk*s6
    t88 = t87 + 0.10101181803004346_rk
    t89 = c5*t84 - s5*t88
    ! link 4: mass matrix, its row of this joint
    m4_5 = k5_yz + t89
    t90 = c5*s5
    t91 = t76 + 2.227476104061723_rk - t80
    t92 = 0.06569252332896146_rk - k6_xz
    t93 = t92 - k6_xz
    t94 = c5*c5
    t95 = t90*t91 + 0.019722038934997604_rk - (t92 - t93*t94)
    t96 = m4_5 - 0.09675036990607108_rk
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = c4*t95 + s4*t96
    t97 = s6*t86 + 0.516451399126078_rk*c6
    t98 = t97 + 3.221934173968582_rk
    t99 = -m6_6 - t97
    t100 = t98 - t99
    t101 = t90*t93 - (t91*t94 + 0.19378159890865698_rk)
    t102 = t101 + (t91 + 0.884611426310538_rk)
    ! link 4: mass matrix, its row of this joint
    m4_4 = t100 + t102
    ! link 4: second moment of the composite body [kg m^2]
    k4_yz = s4*t95 - c4*t96
    t103 = s5*t84 + c5*t88
    t104 = t103 - c5*t81 - s5*t82
    t105 = s4*t104
    t106 = 0.4184224417415877_rk*(s4 + 4.7798583452538_rk*t105)
    t107 = s4*(m5_5 - (t100 - t101))
    t108 = c4*t106 - (s4*t107 - 0.9030127193018334_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = m5_5 + t108
    t109 = t103 + 0.2067207712712513_rk
    t110 = t104 - (c4*(t107 - t109) - 0.4536557831263006_rk - s4*(t98 - t106))
    t111 = t89 - (k4_yz + 0.0816122074936837_rk)
    t112 = c3*t110 + s3*t111
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s2*t112 - c2*m3_3
    t113 = t108 + (t101 + (t102 - 1.4022036176609902_rk))
    t114 = c3*t113
    t115 = c3*k4_xz
    t116 = 0.2010530685596562_rk*c3 + 2.0_rk*t115
    t117 = c3*t114 - 3.9137257607425155_rk + s3*t116
    t118 = c4*t98 - s4*t109
    t119 = m4_4 + t118
    t120 = t118 + t119
    t121 = t117 - t120
    ! link 1: mass matrix, its row of this joint
    m1_1 = c2*(c2*t121 - (nu2_y + s2*(t112 - 1.0437049982058304_rk))) + 1.3323985656347848_rk - &
        t121
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t110 - c3*t111
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 + 0.26458063578324464_rk) + s2*(k4_xz - (c3*t116 - (s3*t114 - &
        0.10039183707333973_rk)))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = t105 + c4*m5_5
    t122 = s5*t99 - c5*k6_xz
    nu4_x = c4*t122 - s4*k6_yz
    ! link 4: mass matrix, its row of this joint
    m4_6 = c5*t99 + s5*k6_xz
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_y = s6*t8 - t77
    nu6_x = c6*t8 + 0.48318719298539553_rk*s6
    t123 = c6*t83
    t124 = s5*t85 - c5*t123
    ! link 4: mass matrix, its row of this joint
    m4_7 = -c5*m6_7 - t124 - s5*nu6_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t117 - (t113 - t120 - 8.88062539209416_rk)
    m2_4 = -c3*t119 - s3*k4_xz
    t125 = t103 + c4*t104 - s4*m5_5
    t126 = m4_5 + c4*t89
    m2_5 = s3*t125 - c3*t126
    t127 = nu4_x - s5*t97
    t128 = m4_6 - (c4*(c5*t97) - s4*t87)
    m2_6 = s3*t127 - c3*t128
    t129 = c5*t85 + s5*t123
    t130 = c5*nu6_x + t129 - s5*m6_7
    t131 = c4*t130 + (t129 + s4*nu6_y)
    t132 = t83*(s4*s6) - (c4*t124 - m4_7)
    m2_7 = s3*t131 - c3*t132
    ! factorisation M = U D U^T
    ud3_7 = s4*t130 - c4*nu6_y
    ud1_7 = c2*ud3_7 - s2*(c3*t131 + s3*t132)
    ! link 7: forward substitution
    y7 = tau(7) - nc7_z
    ! factorisation M = U D U^T
    u6_7 = 0.16915264776063427_rk*t70
    u5_7 = -2.069591277495274_rk*nu6_y
    u4_7 = 2.069591277495274_rk*m4_7
    u3_7 = 2.069591277495274_rk*ud3_7
    u2_7 = 2.069591277495274_rk*m2_7
    u1_7 = 2.069591277495274_rk*ud1_7
    pivot6 = m6_6 - m6_7*u6_7
    ipivot6 = 1.0_rk / pivot6
    ud5_6 = k6_yz - m6_7*u5_7
    u5_6 = ipivot6*ud5_6
    ud4_6 = m4_6 - m6_7*u4_7
    u4_6 = ipivot6*ud4_6
    t133 = s4*t122 + c4*k6_yz
    ud3_6 = t133 - m6_7*u3_7
    u3_6 = ipivot6*ud3_6
    ud2_6 = m2_6 - m6_7*u2_7
    u2_6 = ipivot6*ud2_6
    ud1_6 = c2*t133 - s2*(c3*t127 + s3*t128) - m6_7*u1_7
    u1_6 = ipivot6*ud1_6
    pivot5 = m5_5 + nu6_y*u5_7 - ud5_6*u5_6
    ipivot5 = 1.0_rk / pivot5
    ud4_5 = m4_5 + nu6_y*u4_7 - ud5_6*u4_6
    u4_5 = ipivot5*ud4_5
    ud3_5 = nu4_y + nu6_y*u3_7 - ud5_6*u3_6
    u3_5 = ipivot5*ud3_5
    ud2_5 = m2_5 + nu6_y*u2_7 - ud5_6*u2_6
    u2_5 = ipivot5*ud2_5
    ud1_5 = c2*nu4_y - s2*(c3*t125 + s3*t126) + nu6_y*u1_7 - ud5_6*u1_6
    u1_5 = ipivot5*ud1_5
    pivot4 = m4_4 - m4_7*u4_7 - ud4_6*u4_6 - ud4_5*u4_5
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = -ud4_6*u3_6 - (k4_yz + m4_7*u3_7) - ud4_5*u3_5
    u3_4 = ipivot4*ud3_4
    ud2_4 = -ud4_5*u2_5 - (ud4_6*u2_6 - (m2_4 - m4_7*u2_7))
    u2_4 = ipivot4*ud2_4
    ud1_4 = s2*(t115 - s3*t119) - c2*k4_yz - m4_7*u1_7 - ud4_6*u1_6 - ud4_5*u1_5
    u1_4 = ipivot4*ud1_4
    pivot3 = m3_3 - ud3_7*u3_7 - ud3_6*u3_6 - ud3_5*u3_5 - ud3_4*u3_4
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 - ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    ud1_3 = -ud3_6*u1_6 - (nu2_y + ud3_7*u1_7) - ud3_5*u1_5 - ud3_4*u1_4
    u1_3 = ipivot3*ud1_3
    pivot2 = m2_2 - m2_7*u2_7 - ud2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = k2_yz - m2_7*u1_7 - ud2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    t134 = ud1_7*u1_7 - m1_1 + ud1_6*u1_6 + ud1_5*u1_5 + ud1_4*u1_4 + ud1_3*u1_3
    pivot1 = -ud1_2*u1_2 - t134
    ipivot1 = 1.0_rk / pivot1
    ! link 6: forward substitution
    y6 = tau(6) - n6_z - y7*u6_7
    ! link 5: forward substitution
    y5 = -u5_6*y6 - (n5_z - tau(5) + y7*u5_7)
    ! link 4: forward substitution
    y4 = -u4_6*y6 - (n4_z - tau(4) + y7*u4_7) - u4_5*y5
    ! link 3: forward substitution
    y3 = -(n3_z - tau(3) + y7*u3_7 + u3_6*y6 + u3_5*y5) - u3_4*y4
    t135 = -u2_4*y4 - (n2_z - tau(2) + y7*u2_7 + u2_6*y6 + u2_5*y5)
    ! link 2: forward substitution
    y2 = t135 - u2_3*y3
    t136 = n1_z - tau(1) + y7*u1_7 + u1_6*y6 + u1_5*y5 + u1_4*y4 + u1_3*y3
    ! link 1: forward substitution
    neg_y1 = t136 + u1_2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 + u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = u1_3*neg_qdd1 - (u2_3*qdd2 - ipivot3*y3)
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = u1_4*neg_qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2)
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = u1_5*neg_qdd1 - (u4_5*qdd4 - ipivot5*y5 + u3_5*qdd3 + u2_5*qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6 - u5_6*qdd5 - u4_6*qdd4 - u3_6*qdd3 - u2_6*qdd2 + u1_6*neg_qdd1
    t137 = u6_7*qdd6 - 2.069591277495274_rk*y7 + u5_7*qdd5 + u4_7*qdd4 + u3_7*qdd3 + u2_7*qdd2
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = u1_7*neg_qdd1 - t137
    t138 = -neg_qdd1
    qdd(1) = t138
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
