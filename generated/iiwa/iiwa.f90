! iiwa: KUKA iiwa 14 geometry, random full inertias
! Numbers: published iiwa geometry; inertial parameters drawn at random
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
!   seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 259 multiplications, 247 additions = 506; 8 unary minus; 12 sine/cosine
!   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
!   bias: 244 multiplications, 227 additions = 471; 6 unary minus; 12 sine/cosine
!   mass_matrix: 161 multiplications, 137 additions = 298; 2 unary minus; 12 sine/cosine
!   forward_dynamics: 531 multiplications, 469 additions, 6 divisions = 1006; 20 unary minus; 12
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
  ! 259 multiplications, 247 additions = 506; 8 unary minus; 12 sine/cosine
  pure subroutine iiwa_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="iiwa_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, w2_x, c2, w2_y, lam2_23, ww2_yz, alpha2_x, c3, s3, w3_x, w3_z, w3_y, alpha3_x
    real(rk) :: alpha3_y, ww3_zx, ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23
    real(rk) :: neg_lam3_31, lam3_32, c4, s4, w4_x, w4_z, w4_y, alpha4_z, ww4_xy, ww4_yz, ww4_zz
    real(rk) :: ww4_yy, ww4_zx, lam4_12, lam4_21, neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy
    real(rk) :: ww5_xx, ww5_zz, ww5_yy, ww5_yz, ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y
    real(rk) :: ww6_zx, ww6_zz, ww6_yz, ww6_xy, ww6_yy, neg_lam6_11, w7_z, c7, s7, neg_lam2_13
    real(rk) :: ww2_zx, alpha3_z, alpha4_y, lam4_31, lam3_21, alpha4_x, lam4_32, t1, neg_lam4_22
    real(rk) :: alpha5_z, lam5_12, ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x, alpha7_z, t6, lam6_13
    real(rk) :: alpha5_y, alpha6_z, lam6_21, alpha6_x, lam6_12, lam6_23, t7, t8, t9, t10, t11, t12
    real(rk) :: t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29
    real(rk) :: t30, t31, t32, t33, t34, t35, t36, n6_z, lam5_31, lam5_32, t37, n5_y, neg_lam5_11
    real(rk) :: lam5_21, t38, neg_lam6_31, lam6_32, t39, t40, t41, nc7_z, t42, t43, t44, n5_x
    real(rk) :: lam4_23, lam4_13, lam5_23, lam5_13, t45, n5_z, t46, t47, t48, t49, t50, t51, n4_z
    real(rk) :: lam3_12, ww2_zz, t52, t53, t54, t55, t56, t57, t58, t59, t60, n3_z, t61, t62, t63
    real(rk) :: t64, t65, t66, t67, t68, t69, t70, t71, t72, n1_z, t73, n2_z

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
    alpha3_x = qd(3)*w3_y - (-s3*qdd(2) - alpha2_x*c3)
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
    neg_lam3_31 = alpha3_y - ww3_zx
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
    alpha4_x = s4*alpha3_z - (-qd(4)*w4_y - alpha3_x*c4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t1 = ww5_zz - ww5_yy
    neg_lam4_22 = neg_lam5_22 - t1
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
    alpha5_y = -s5*alpha4_x - w5_x*qd(5) - alpha4_z*c5
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = alpha5_y + qdd(6)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha6_z
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x + (qd(6)*w6_y - s6*alpha5_z)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha6_z
    lam6_23 = ww6_yz - alpha6_x
    t7 = neg_lam5_22 + lam6_22
    t8 = 0.150926706942488_rk*s7
    t9 = 0.3999801598546772_rk*c7
    t10 = t8*t9
    t11 = c7*c7
    t12 = 1.6791988194353373_rk*t10 - 0.2114247825686032_rk*(t11 + (t11 - 1.0_rk))
    t13 = qd(7) + w7_z
    t14 = w6_z*t13 + alpha6_x
    t15 = alpha6_z - w6_x*t13
    t16 = 0.10136935104159488_rk*t11 + (7.004567783863868_rk*t10 + 0.19090892097190032_rk)
    t17 = t16 - 0.48318719298539553_rk
    t18 = 24.525_rk*s2
    t19 = c3*t18
    t20 = lam3_13 - t19
    t21 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t22 = c4*t20 - s4*t21
    t23 = lam4_12 + t22
    t24 = s3*t18
    t25 = lam3_23 + t24
    t26 = t25 - lam4_32
    t27 = c5*t23 + s5*t26
    t28 = s4*t20 + c4*t21
    t29 = t28 + neg_lam4_22
    t30 = c6*t27 + s6*t29
    t31 = t9 - 0.283322719186478_rk*s7
    t32 = 1.1592996128590562_rk*(t31 - 0.5301679950513729_rk*c7)
    t33 = -0.4239952187044951_rk*lam6_21 - (t12*t14 - t15*t17 + (0.516451399126078_rk*t30 - &
        2.0289563933923875_rk*lam6_12 + t6*t32))
    t34 = s6*t27 - c6*t29
    t35 = t8 - 0.32845591866705903_rk*c7
    t36 = 0.36144292274665746_rk*(t3 - t7) - (0.0870114460092663_rk*lam6_13 + (t33 + ((t31 - &
        0.6262523039785531_rk)*t34 - t35*(t4 + lam6_22))))
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t36 - 0.042925575293549574_rk*lam6_23
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t37 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = 0.03284626166448073_rk*lam5_32 - (0.10101181803004346_rk*t29 - &
        0.041147842218669614_rk*(t1 - t37) + 0.05680835589544868_rk*lam5_12 - n6_z + &
        0.09474888781047501_rk*lam5_31)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy + alpha5_z
    t38 = -ww6_zx - alpha7_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_31 = qdd(7) + t38
    lam6_32 = ww6_yz + alpha6_x
    t39 = 1.8772205723301225_rk*(t32 + 0.11538550714999525_rk*s7)
    t40 = s5*t23 - c5*t26
    t41 = t17*t38 - lam6_12*t32 + (t3*t12 + t30*t39 + (t35*lam6_32 - t31*t40))
    ! link 7: moment that turns the link [N m]
    nc7_z = t41 + t6*t16
    t42 = 0.042925575293549574_rk*t3 - (0.36144292274665746_rk*lam6_32 + &
        0.16772238154175834_rk*t30) - (0.4239952187044951_rk*neg_lam6_31 + &
        0.0870114460092663_rk*lam6_12 - (0.6262523039785531_rk*t40 + nc7_z) + &
        0.20655564034097101_rk*lam6_13)
    t43 = t12*t15 - 0.20655564034097101_rk*lam6_23 + 0.36144292274665746_rk*neg_lam6_31 - (t35*t38 &
        + 0.0870114460092663_rk*t7 - t14*t16)
    t44 = -0.042925575293549574_rk*lam6_21 - (t43 + (2.0289563933923875_rk*lam6_32 - t2*t32) - &
        t34*(t39 - 0.16772238154175834_rk)) - 0.516451399126078_rk*t40
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = s6*t42 - c6*t44 - (0.05680835589544868_rk*t1 + (0.03284626166448073_rk*lam5_31 - &
        0.041147842218669614_rk*lam5_21))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx + alpha5_y
    t45 = 0.03284626166448073_rk*t37 - 0.041147842218669614_rk*lam5_23 - &
        (-0.05680835589544868_rk*lam5_13 - s6*t44) + 0.09474888781047501_rk*lam5_21 + c6*t42
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t45 + 0.10101181803004346_rk*t40
    t46 = neg_lam4_11 - neg_lam4_22
    t47 = -0.10101181803004346_rk*lam5_21 - (t31*t38 + (0.16772238154175834_rk*neg_lam5_22 - &
        (0.6262523039785531_rk*neg_lam6_31 - (0.516451399126078_rk*lam6_32 - t5*t39))))
    t48 = t14*t39 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 + t15*t31
    t49 = 0.16772238154175834_rk*lam6_13 + (0.6262523039785531_rk*neg_lam6_11 - (t4*t31 - t6*t39)) &
        - 0.516451399126078_rk*lam6_12
    t50 = 0.10101181803004346_rk*neg_lam5_11 - (s6*t48 - c6*t49)
    t51 = s5*t47 - c5*t50
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = -0.013124222729483126_rk*lam4_23 - (3.569490999313376_rk*lam4_12 + &
        3.221934173968582_rk*t22 + 0.09675036990607108_rk*lam4_13 - &
        0.24852411424661205_rk*lam4_21) - (0.20921122087079386_rk*t46 + s5*n5_x - (t51 + &
        (0.2067207712712513_rk*t28 - c5*n5_y)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - alpha3_z
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t52 = ww3_zz - ww3_yy
    t53 = ww3_xx - ww3_zz
    t54 = 0.2067207712712513_rk*t25 - 0.2506667841125447_rk*lam4_13 + &
        0.24852411424661205_rk*lam4_31 - (0.09675036990607108_rk*lam4_12 + n5_z) - &
        0.20921122087079386_rk*lam4_32
    t55 = ww4_zz - ww4_yy
    t56 = t54 - 0.013124222729483126_rk*(t55 + t46)
    t57 = s5*t50 + c5*t47
    t58 = 0.013124222729483126_rk*(lam4_21 - 15.940846569207324_rk*lam4_31) - s5*n5_y + &
        (0.09675036990607108_rk*t55 - t57 + c5*n5_x)
    t59 = 3.221934173968582_rk*t25 - (t58 - 0.2506667841125447_rk*lam4_23) - &
        3.569490999313376_rk*lam4_32
    t60 = 0.1005265342798281_rk*(t52 + t53) + (0.0816122074936837_rk*lam3_13 - &
        0.4067460055662282_rk*t24 - (c4*t56 - 0.40382182094267666_rk*alpha3_z + s4*t59))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t60 - 0.01755847364096103_rk*(t19 + 13.921743270739537_rk*lam3_23)
    t61 = c4*t59 - (0.1005265342798281_rk*neg_lam3_31 - (t57 + (-0.40382182094267666_rk*alpha3_x - &
        s4*t56) - 3.221934173968582_rk*lam4_32))
    t62 = 0.0816122074936837_rk*t52 + (0.2067207712712513_rk*lam4_31 + (0.43062156604456925_rk*c2 &
        + t61 - 0.24444456225550676_rk*lam3_21))
    t63 = s4*(3.221934173968582_rk*neg_lam4_22 - (-0.2067207712712513_rk*lam4_21 - s6*t49 - &
        c6*t48) + 0.10101181803004346_rk*lam5_31)
    t64 = -0.1005265342798281_rk*lam3_32 - (t63 - n4_z + (9.975445786511747_rk*c2 + &
        (0.40382182094267666_rk*alpha3_y - 0.24444456225550676_rk*t53))) + &
        0.0816122074936837_rk*lam3_12
    t65 = c4*(0.2067207712712513_rk*neg_lam4_11 + (3.221934173968582_rk*lam4_12 - t51)) - t64
    t66 = 0.20091837135316784_rk*c2 + 0.26458063578324464_rk*s2
    t67 = 0.41715488532235584_rk*c2 - 0.7593842639253783_rk*t66
    t68 = 3.509903939799839_rk*c2
    t69 = c2*t68
    t70 = s2*t68
    t71 = qd(1)*(t70 + (0.29735998936351243_rk*t69 - 0.5218524991029152_rk))
    t72 = t66*ww2_zz + (qdd(1)*(t69 - 4.842302505434623_rk - 0.29735998936351243_rk*t70) - &
        (2.0_rk*(qd(2)*t71) + c2*n3_z))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t62 + s3*t65) + qdd(2)*t67 - t72
    t73 = 24.525_rk*(0.186058218569173_rk*qdd(2) + (0.5419930474657001_rk*c2 - &
        3.126354326358915_rk*s2)) + (c3*t65 - s3*t62)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = qdd(1)*t67 - (qd(1)*t71 - t73)
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
  ! 244 multiplications, 227 additions = 471; 6 unary minus; 12 sine/cosine
  pure subroutine iiwa_bias(q, qd, tau) &
      bind(c, name="iiwa_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, w2_x, c2, w2_y, ww2_yz, c3, s3, w3_x, w3_z, w3_y, alpha3_x, alpha3_y, ww3_zx
    real(rk) :: ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23, neg_lam3_31, lam3_32, c4
    real(rk) :: s4, w4_x, w4_z, w4_y, ww4_xy, ww4_yz, ww4_zz, ww4_yy, ww4_zx, lam4_12, lam4_21
    real(rk) :: neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy, ww5_xx, ww5_zz, ww5_yy, ww5_yz
    real(rk) :: ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zx, ww6_zz, ww6_yz, ww6_xy
    real(rk) :: ww6_yy, neg_lam6_11, w7_z, c7, s7, ww2_zx, alpha4_y, lam4_31, lam3_21, neg_alpha4_x
    real(rk) :: lam4_32, t1, neg_lam4_22, lam5_12, ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x
    real(rk) :: alpha7_z, lam6_13, alpha5_y, lam6_21, alpha6_x, lam6_12, lam6_23, t6, t7, t8, t9
    real(rk) :: t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26
    real(rk) :: t27, t28, t29, t30, t31, t32, t33, t34, t35, n6_z, lam5_31, lam5_32, t36, n5_y
    real(rk) :: neg_lam5_11, lam5_21, lam6_31, lam6_32, t37, t38, t39, nc7_z, t40, t41, t42, t43
    real(rk) :: n5_x, lam4_23, lam4_13, lam5_23, lam5_13, t44, n5_z, t45, t46, t47, t48, t49, t50
    real(rk) :: n4_z, lam3_12, ww2_zz, t51, t52, t53, t54, t55, t56, t57, t58, t59, n3_z, t60, t61
    real(rk) :: t62, t63, t64, t65, t66, n1_z, n2_z

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
    alpha3_x = ww2_yz*c3 + qd(3)*w3_y
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
    neg_lam3_31 = alpha3_y - ww3_zx
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
    alpha4_y = c4*ww2_zx - alpha3_x*s4 - w4_x*qd(4)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = ww3_xy + ww2_zx
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = -qd(4)*w4_y - alpha3_x*c4 - s4*ww2_zx
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz - neg_alpha4_x
    t1 = ww5_zz - ww5_yy
    neg_lam4_22 = neg_lam5_22 - t1
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
    alpha5_x = alpha3_y*s5 + qd(5)*w5_y - c5*neg_alpha4_x
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = s6*alpha5_x + (c6*alpha4_y + w6_x*qd(6))
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_13 = ww6_zx - alpha7_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = alpha3_y*c5 + (s5*neg_alpha4_x - w5_x*qd(5))
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha5_y
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x + (qd(6)*w6_y - s6*alpha4_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha5_y
    lam6_23 = ww6_yz - alpha6_x
    t6 = 0.150926706942488_rk*s7
    t7 = t6 - 0.32845591866705903_rk*c7
    t8 = 0.3999801598546772_rk*c7
    t9 = t8 - 0.283322719186478_rk*s7
    t10 = t9 - 0.6262523039785531_rk
    t11 = 24.525_rk*s2
    t12 = c3*t11
    t13 = lam3_13 - t12
    t14 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t15 = c4*t13 - s4*t14
    t16 = lam4_12 + t15
    t17 = s3*t11
    t18 = lam3_23 + t17
    t19 = t18 - lam4_32
    t20 = c5*t16 + s5*t19
    t21 = s4*t13 + c4*t14
    t22 = t21 + neg_lam4_22
    t23 = s6*t20 - c6*t22
    t24 = c6*t20 + s6*t22
    t25 = neg_lam5_22 + lam6_22
    t26 = t6*t8
    t27 = c7*c7
    t28 = 1.6791988194353373_rk*t26 - 0.2114247825686032_rk*(t27 + (t27 - 1.0_rk))
    t29 = qd(7) + w7_z
    t30 = w6_z*t29 + alpha6_x
    t31 = alpha5_y - w6_x*t29
    t32 = 0.10136935104159488_rk*t27 + (7.004567783863868_rk*t26 + 0.19090892097190032_rk)
    t33 = 0.48318719298539553_rk - t32
    t34 = 0.516451399126078_rk*t24 - (-0.4239952187044951_rk*lam6_21 - 0.36144292274665746_rk*(t3 &
        - t25) - t28*t30 - t31*t33)
    t35 = 1.1592996128590562_rk*(t9 - 0.5301679950513729_rk*c7)
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t7*(t4 + lam6_22) - (t10*t23 - (t34 - 2.0289563933923875_rk*lam6_12)) - &
        0.042925575293549574_rk*lam6_23 - lam6_13*(t35 + 0.0870114460092663_rk)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t36 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = 0.03284626166448073_rk*lam5_32 - (0.10101181803004346_rk*t22 - &
        0.041147842218669614_rk*(t1 - t36) + 0.05680835589544868_rk*lam5_12 - n6_z + &
        0.09474888781047501_rk*lam5_31)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy + alpha4_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_31 = ww6_zx + alpha7_z
    lam6_32 = ww6_yz + alpha6_x
    t37 = 1.8772205723301225_rk*(t35 + 0.11538550714999525_rk*s7)
    t38 = s5*t16 - c5*t19
    t39 = t33*lam6_31 - lam6_12*t35 + (t3*t28 + t24*t37 + (t7*lam6_32 - t9*t38))
    ! link 7: moment that turns the link [N m]
    nc7_z = t39 - lam6_13*t32
    t40 = 0.042925575293549574_rk*t3 - (0.36144292274665746_rk*lam6_32 + &
        0.16772238154175834_rk*t24) - (0.0870114460092663_rk*lam6_12 - &
        0.4239952187044951_rk*lam6_31 - (0.6262523039785531_rk*t38 + nc7_z) + &
        0.20655564034097101_rk*lam6_13)
    t41 = t37 - 0.16772238154175834_rk
    t42 = t30*t32 - (0.0870114460092663_rk*t25 + (0.20655564034097101_rk*lam6_23 + &
        (-0.042925575293549574_rk*lam6_21 - t28*t31))) - t2*t35
    t43 = 0.516451399126078_rk*t38 - (t23*t41 - (2.0289563933923875_rk*lam6_32 + t42)) + &
        lam6_31*(t7 - 0.36144292274665746_rk)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = s6*t40 + c6*t43 - (0.05680835589544868_rk*t1 + (0.03284626166448073_rk*lam5_31 - &
        0.041147842218669614_rk*lam5_21))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz + neg_alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx + alpha5_y
    t44 = 0.03284626166448073_rk*t36 - 0.041147842218669614_rk*lam5_23 - (s6*t43 - &
        0.05680835589544868_rk*lam5_13) + 0.09474888781047501_rk*lam5_21 + c6*t40
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t44 + 0.10101181803004346_rk*t38
    t45 = neg_lam4_11 - neg_lam4_22
    t46 = t5*t37 - (0.516451399126078_rk*lam6_32 - (-0.16772238154175834_rk*neg_lam5_22 - &
        0.10101181803004346_rk*lam5_21)) + t10*lam6_31
    t47 = t30*t37 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 + t31*t9
    t48 = t4*t9 - (0.6262523039785531_rk*neg_lam6_11 - 0.516451399126078_rk*lam6_12) + lam6_13*t41
    t49 = 0.10101181803004346_rk*neg_lam5_11 - (s6*t47 + c6*t48)
    t50 = s5*t46 - c5*t49
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = -0.013124222729483126_rk*lam4_23 - (3.569490999313376_rk*lam4_12 + &
        3.221934173968582_rk*t15 + 0.09675036990607108_rk*lam4_13 - &
        0.24852411424661205_rk*lam4_21) - (0.20921122087079386_rk*t45 + s5*n5_x - (t50 + &
        (0.2067207712712513_rk*t21 - c5*n5_y)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t51 = ww3_zz - ww3_yy
    t52 = ww3_xx - ww3_zz
    t53 = 0.2067207712712513_rk*t18 - 0.2506667841125447_rk*lam4_13 + &
        0.24852411424661205_rk*lam4_31 - (0.09675036990607108_rk*lam4_12 + n5_z) - &
        0.20921122087079386_rk*lam4_32
    t54 = ww4_zz - ww4_yy
    t55 = t53 - 0.013124222729483126_rk*(t54 + t45)
    t56 = s5*t49 + c5*t46
    t57 = 0.013124222729483126_rk*(lam4_21 - 15.940846569207324_rk*lam4_31) - s5*n5_y + &
        (0.09675036990607108_rk*t54 - t56 + c5*n5_x)
    t58 = 3.221934173968582_rk*t18 - (t57 - 0.2506667841125447_rk*lam4_23) - &
        3.569490999313376_rk*lam4_32
    t59 = 0.1005265342798281_rk*(t51 + t52) + (0.0816122074936837_rk*lam3_13 - &
        0.4067460055662282_rk*t17 - (c4*t55 - 0.40382182094267666_rk*ww2_zx + s4*t58))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t59 - 0.01755847364096103_rk*(t12 + 13.921743270739537_rk*lam3_23)
    t60 = c4*t58 - (0.1005265342798281_rk*neg_lam3_31 - (t56 + (-0.40382182094267666_rk*alpha3_x - &
        s4*t55) - 3.221934173968582_rk*lam4_32))
    t61 = 0.0816122074936837_rk*t51 + (0.2067207712712513_rk*lam4_31 + (0.43062156604456925_rk*c2 &
        + t60 - 0.24444456225550676_rk*lam3_21))
    t62 = s4*(3.221934173968582_rk*neg_lam4_22 - (s6*t48 - 0.2067207712712513_rk*lam4_21 - c6*t47) &
        + 0.10101181803004346_rk*lam5_31)
    t63 = -0.1005265342798281_rk*lam3_32 - (t62 - n4_z + (9.975445786511747_rk*c2 + &
        (0.40382182094267666_rk*alpha3_y - 0.24444456225550676_rk*t52))) + &
        0.0816122074936837_rk*lam3_12
    t64 = c4*(0.2067207712712513_rk*neg_lam4_11 + (3.221934173968582_rk*lam4_12 - t50)) - t63
    t65 = 3.509903939799839_rk*c2
    t66 = qd(1)*(s2*t65 + (0.29735998936351243_rk*(c2*t65) - 0.5218524991029152_rk))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t61 + s3*t64) - ((0.20091837135316784_rk*c2 + 0.26458063578324464_rk*s2)*ww2_zz &
        - (2.0_rk*(qd(2)*t66) + c2*n3_z))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 24.525_rk*(0.5419930474657001_rk*c2 - 3.126354326358915_rk*s2) + (c3*t64 - s3*t61) - &
        qd(1)*t66
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 161 multiplications, 137 additions = 298; 2 unary minus; 12 sine/cosine
  pure subroutine iiwa_mass_matrix(q, M) &
      bind(c, name="iiwa_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, h7_y, neg_fu6_x, h7_x, t2, h6_x
    real(rk) :: t3, t4, neg_h5_x, neg_h6_y, h5_y, t5, t6, t7, t8, neg_h3_x, neg_m6_7, t9, t10, t11
    real(rk) :: t12, t13, k6_xz, k6_yz, t14, t15, t16, t17, t18, t19, t20, m4_5, t21, t22, t23, t24
    real(rk) :: t25, t26, t27, neg_k4_yz, neg_m5_5, t28, t29, t30, t31, t32, t33, t34, t35, t36
    real(rk) :: t37, neg_k3_xz, t38, m3_3, t39, neg_nu2_y, neg_k4_xz, m4_4, h4_y, t40, t41, t42
    real(rk) :: t43, t44, t45, t46, t47, t48, m1_1, h3_y, m2_3, k2_yz, nu4_y, nu4_x, nu3_x
    real(rk) :: neg_fu4_x, neg_fu3_y, m6_6, t49, t50, m4_6, nu6_x, nu5_x, neg_fu5_y, neg_nu6_y
    real(rk) :: neg_fu5_x, nu5_y, m4_7, m2_2, m2_4, nu3_y, fu3_x, m2_5, t51, t52, t53, m2_6, t54
    real(rk) :: t55, t56, m2_7, t57, t58, t59, t60, t61, t62, t63, t64

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
    t1 = 0.9999503996366931_rk*s7
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_y = 0.708306797966195_rk*c7 + t1
    ! link 6: force for a unit acceleration of a joint further out
    neg_fu6_x = c6*h7_y
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_x = 1.4117475682965523_rk*h7_y - 2.119984343070462_rk*s7
    t2 = h7_x - 1.5656307599463828_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.291128497815195_rk*s6 + c6*t2
    t3 = h7_y + 0.4193059538543958_rk
    t4 = h6_x - 0.25252954507510866_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_x = s5*t3 - c5*t4
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_y = 1.291128497815195_rk*c6 - s6*t2
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_y = c5*t3 + s5*t4
    t5 = neg_h5_x + 0.5168019281781282_rk
    t6 = neg_h6_y + 8.054835434921454_rk
    t7 = c4*t5 + (s4*t6 + 1.0168650139155704_rk)
    t8 = h5_y - 0.04389618410240257_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    neg_h3_x = c3*t7 + s3*t8
    ! link 6: mass matrix, its row of this joint
    neg_m6_7 = 0.11539123059695529_rk*(t1 + 1.846595961484861_rk*h7_y)
    t9 = neg_m6_7 - 0.0870114460092663_rk
    t10 = 0.4228495651372064_rk*c7
    t11 = c7*t10
    t12 = s7*t10
    t13 = t11 - (0.23972911266611452_rk*t12 + 0.25435035786215276_rk)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = s6*t9 + c6*t13
    k6_yz = s6*t13 - c6*t9
    t14 = c6*c6
    t15 = 0.15093419333331276_rk*h7_y - 0.4353636338505884_rk*c7
    t16 = 2.0_rk*t15 - 0.7228858454933149_rk
    t17 = t12 + (0.23972911266611452_rk*t11 + 1.3126829026743974_rk)
    t18 = c6*s6
    t19 = t14*t16 - (t15 - 0.4025907649653271_rk + t17*t18)
    t20 = k6_yz + 0.05680835589544868_rk
    ! link 4: mass matrix, its row of this joint
    m4_5 = 0.4_rk*h5_y - s5*t19 - c5*t20
    t21 = c5*c5
    t22 = k6_xz + (k6_xz - 0.06569252332896146_rk)
    t23 = c5*s5
    t24 = t14*t17 + t18*t16
    t25 = t24 + (t17 - 3.0389236225643885_rk)
    t26 = t21*t22 - (k6_xz + (t23*t25 - 0.045970484393963854_rk))
    t27 = m4_5 - 0.09675036990607108_rk
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*t26 + c4*t27
    ! link 5: mass matrix, its row of this joint
    neg_m5_5 = t24 - (t17 + 1.2084869398413365_rk)
    t28 = neg_k4_yz - 0.06405373385272267_rk
    t29 = c4*s4
    t30 = t24 - (t21*t25 + 7.016595671833826_rk + t22*t23)
    t31 = t30 - 4.4699270629915056_rk + 0.8_rk*neg_h6_y
    t32 = 2.0_rk*(t30 - 3.067723445330515_rk - neg_m5_5)
    t33 = t31 - t32
    t34 = 0.4_rk*neg_h5_x + c5*t19 - s5*t20
    t35 = t34 + (t34 + 0.4184224417415877_rk)
    t36 = s4*s4
    t37 = t29*t33 + 0.04690977756007243_rk + (t34 - t35*t36)
    ! link 3: second moment of the composite body [kg m^2]
    neg_k3_xz = s3*t28 + c3*t37
    t38 = t29*t35 + (t33*t36 + 0.9030127193018334_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = t38 - neg_m5_5
    t39 = s2*(0.4_rk*neg_h3_x + neg_k3_xz)
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*m3_3 - t39
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_xz = c4*t26 - s4*t27
    ! link 4: mass matrix, its row of this joint
    m4_4 = t31 + 16.41827590041618_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_y = c4*t6 - s4*t5
    t40 = c3*c3
    t41 = t32 + (t38 + (neg_m5_5 + 15.016072282755191_rk))
    t42 = c3*s3
    t43 = neg_k4_xz + (neg_k4_xz - 0.2010530685596562_rk)
    t44 = t40*t41 - (t42*t43 + 3.9137257607425155_rk)
    t45 = 0.4_rk*h4_y
    t46 = m4_4 + t45
    t47 = t45 + t46
    t48 = t44 - t47
    ! link 1: mass matrix, its row of this joint
    m1_1 = 1.3323985656347848_rk - c2*(t39 - neg_nu2_y - (c2*t48 + 1.0437049982058304_rk*s2)) - &
        t48
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = c3*t8 - s3*t7
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t37 - 0.4_rk*h3_y - c3*t28
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 + 0.26458063578324464_rk) + s2*(t41*t42 + (t40*t43 - 0.10039183707333973_rk) &
        - neg_k4_xz)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s4*t34 - c4*neg_m5_5
    nu4_x = s4*neg_m5_5 + c4*t34
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*m4_5
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = c4*h5_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_y = s3*neg_fu4_x + c3*neg_h5_x
    ! link 6: mass matrix, its row of this joint
    m6_6 = 4.057912786784775_rk - t17
    t49 = 0.4_rk*neg_h6_y
    t50 = t49 + m6_6
    ! link 4: mass matrix, its row of this joint
    m4_6 = s5*k6_xz - c5*t50
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.48318719298539553_rk*s6 + c6*t15
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x + s5*neg_m6_7
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_y = s5*neg_fu6_x - c5*h7_x
    ! link 6: moment for a unit acceleration of a joint further out
    neg_nu6_y = 0.48318719298539553_rk*c6 - s6*t15
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = c5*neg_fu6_x + s5*h7_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = s5*nu6_x - c5*neg_m6_7
    ! link 4: mass matrix, its row of this joint
    m4_7 = 0.4_rk*neg_fu5_x - nu5_y
    ! link 2: mass matrix, its row of this joint
    m2_2 = t44 + (t47 - t30 - m3_3) - t30
    m2_4 = s3*neg_k4_xz - c3*t46
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s3*nu4_x - c3*m4_5
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = s3*neg_h5_x - c3*neg_fu4_x
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y + 0.4_rk*fu3_x
    t51 = 0.4_rk*(s4*h6_x + neg_h6_y*(c4*c5)) - m4_6
    t52 = s5*t50 + c5*k6_xz
    t53 = c4*t52 + (s5*t49 + s4*k6_yz)
    m2_6 = c3*t51 - s3*t53
    t54 = c4*neg_fu5_x + h7_y*(s4*s6)
    t55 = nu5_x + 0.4_rk*neg_fu5_y
    t56 = c4*t55 - s4*neg_nu6_y
    m2_7 = 0.4_rk*(s3*neg_fu5_y - c3*t54) - (c3*m4_7 - s3*t56)
    t57 = c2*neg_k4_yz - s2*(c3*neg_k4_xz + s3*t46)
    t58 = c2*nu4_y - s2*(nu3_x + 0.4_rk*neg_fu3_y)
    t59 = c4*k6_yz - s4*t52
    t60 = c2*t59 + s2*(c3*t53 + s3*t51)
    t61 = s4*t55 + c4*neg_nu6_y
    t62 = c2*t61 - s2*(c3*t56 + (0.4_rk*(c3*neg_fu5_y + s3*t54) + s3*m4_7))
    t63 = -neg_m5_5
    t64 = -neg_m6_7
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y
    M(4) = t57
    M(5) = t58
    M(6) = t60
    M(7) = t62
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
    M(20) = t59
    M(21) = t61
    M(22) = t57
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = m4_7
    M(29) = t58
    M(30) = m2_5
    M(31) = nu4_y
    M(32) = m4_5
    M(33) = t63
    M(34) = k6_yz
    M(35) = neg_nu6_y
    M(36) = t60
    M(37) = m2_6
    M(38) = t59
    M(39) = m4_6
    M(40) = k6_yz
    M(41) = m6_6
    M(42) = t64
    M(43) = t62
    M(44) = m2_7
    M(45) = t61
    M(46) = m4_7
    M(47) = neg_nu6_y
    M(48) = t64
    M(49) = 0.48318719298539553_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 531 multiplications, 469 additions, 6 divisions = 1006; 20 unary minus; 12 sine/cosine
  pure subroutine iiwa_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="iiwa_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: s2, w2_x, c2, w2_y, ww2_yz, c3, s3, w3_x, w3_z, w3_y, alpha3_x, alpha3_y, ww3_zx
    real(rk) :: ww3_yz, ww3_xx, ww3_zz, ww3_yy, ww3_xy, lam3_13, lam3_23, neg_lam3_31, lam3_32, c4
    real(rk) :: s4, w4_x, w4_z, w4_y, ww4_xy, ww4_yz, ww4_zz, ww4_yy, ww4_zx, lam4_12, lam4_21
    real(rk) :: neg_lam4_11, c5, s5, w5_x, w5_z, w5_y, ww5_xy, ww5_xx, ww5_zz, ww5_yy, ww5_yz
    real(rk) :: ww5_zx, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zx, ww6_zz, ww6_yz, ww6_xy
    real(rk) :: ww6_yy, neg_lam6_11, w7_z, c7, s7, ww2_zx, alpha4_y, lam4_31, lam3_21, alpha4_x
    real(rk) :: lam4_32, t1, neg_lam4_22, lam5_12, ww7_zz, t2, t3, t4, t5, lam6_22, alpha5_x
    real(rk) :: alpha7_z, lam6_13, alpha5_y, lam6_21, alpha6_x, lam6_12, lam6_23, t6, t7, t8, t9
    real(rk) :: t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26
    real(rk) :: t27, t28, t29, t30, t31, t32, t33, t34, t35, n6_z, lam5_31, lam5_32, t36, n5_y
    real(rk) :: neg_lam5_11, lam5_21, lam6_31, lam6_32, t37, t38, t39, nc7_z, t40, t41, t42, t43
    real(rk) :: n5_x, lam4_23, lam4_13, lam5_23, lam5_13, t44, n5_z, t45, t46, t47, t48, t49, t50
    real(rk) :: n4_z, lam3_12, ww2_zz, t51, t52, t53, t54, t55, t56, t57, t58, t59, n3_z, t60, t61
    real(rk) :: t62, t63, t64, t65, t66, n1_z, n2_z, t67, h7_y, fu6_x, h7_x, t68, h6_x, t69, t70
    real(rk) :: h5_x, h6_y, h5_y, t71, t72, t73, t74, neg_h3_x, t75, m6_7, t76, t77, t78, t79, t80
    real(rk) :: k6_xz, k6_yz, t81, t82, t83, t84, t85, t86, t87, m4_5, t88, t89, t90, t91, t92, t93
    real(rk) :: t94, k4_yz, m5_5, t95, t96, t97, t98, t99, t100, t101, t102, t103, t104, k3_xz
    real(rk) :: t105, m3_3, t106, neg_nu2_y, k4_xz, m4_4, h4_y, t107, t108, t109, t110, t111, t112
    real(rk) :: t113, t114, t115, m1_1, h3_y, m2_3, k2_yz, nu4_y, nu4_x, nu3_x, fu4_x, fu3_y, m6_6
    real(rk) :: t116, t117, m4_6, nu6_x, nu5_x, fu5_y, nu6_y, neg_fu5_x, nu5_y, m4_7, neg_m2_2
    real(rk) :: t118, m2_4, nu3_y, fu3_x, m2_5, t119, t120, t121, m2_6, t122, t123, t124, m2_7
    real(rk) :: ud3_7, ud1_7, y7, u6_7, u5_7, u4_7, u3_7, u2_7, u1_7, pivot6, ipivot6, ud5_6, u5_6
    real(rk) :: ud4_6, u4_6, t125, ud3_6, u3_6, ud2_6, u2_6, ud1_6, u1_6, pivot5, ipivot5, ud4_5
    real(rk) :: u4_5, ud3_5, u3_5, ud2_5, u2_5, ud1_5, u1_5, pivot4, ipivot4, neg_ud3_4, u3_4
    real(rk) :: ud2_4, u2_4, t126, ud1_4, u1_4, pivot3, ipivot3, ud2_3, u2_3, ud1_3, u1_3, pivot2
    real(rk) :: ipivot2, ud1_2, u1_2, t127, pivot1, ipivot1, y6, y5, y4, y3, neg_y2, t128, y1, qdd1
    real(rk) :: qdd2, qdd3, qdd4, qdd5, qdd6, t129, qdd7

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
    alpha3_x = ww2_yz*c3 + qd(3)*w3_y
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
    neg_lam3_31 = alpha3_y - ww3_zx
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
    alpha4_x = qd(4)*w4_y + alpha3_x*c4 + s4*ww2_zx
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t1 = ww5_zz - ww5_yy
    neg_lam4_22 = neg_lam5_22 - t1
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
    alpha5_x = alpha3_y*s5 + qd(5)*w5_y + c5*alpha4_x
    ! link 7: angular acceleration [rad/s^2]
    alpha7_z = s6*alpha5_x - (-w6_x*qd(6) - c6*alpha4_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_13 = ww6_zx - alpha7_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = alpha3_y*c5 - (s5*alpha4_x + w5_x*qd(5))
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha5_y
    ! link 6: angular acceleration [rad/s^2]
    alpha6_x = c6*alpha5_x - (s6*alpha4_y - qd(6)*w6_y)
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_12 = ww6_xy - alpha5_y
    lam6_23 = ww6_yz - alpha6_x
    t6 = 0.150926706942488_rk*s7
    t7 = t6 - 0.32845591866705903_rk*c7
    t8 = 0.3999801598546772_rk*c7
    t9 = t8 - 0.283322719186478_rk*s7
    t10 = t9 - 0.6262523039785531_rk
    t11 = 24.525_rk*s2
    t12 = c3*t11
    t13 = lam3_13 - t12
    t14 = ww3_yy + (ww3_xx - 24.525_rk*c2)
    t15 = c4*t13 - s4*t14
    t16 = lam4_12 + t15
    t17 = s3*t11
    t18 = lam3_23 + t17
    t19 = t18 - lam4_32
    t20 = c5*t16 + s5*t19
    t21 = s4*t13 + c4*t14
    t22 = neg_lam4_22 + t21
    t23 = s6*t20 - c6*t22
    t24 = c6*t20 + s6*t22
    t25 = neg_lam5_22 + lam6_22
    t26 = t6*t8
    t27 = c7*c7
    t28 = 1.6791988194353373_rk*t26 - 0.2114247825686032_rk*(t27 + (t27 - 1.0_rk))
    t29 = qd(7) + w7_z
    t30 = alpha6_x + w6_z*t29
    t31 = alpha5_y - w6_x*t29
    t32 = 0.10136935104159488_rk*t27 + (7.004567783863868_rk*t26 + 0.19090892097190032_rk)
    t33 = t32 - 0.48318719298539553_rk
    t34 = 0.516451399126078_rk*t24 + (0.4239952187044951_rk*lam6_21 + 0.36144292274665746_rk*(t3 - &
        t25) + t28*t30 - t31*t33)
    t35 = 1.1592996128590562_rk*(0.5301679950513729_rk*c7 - t9)
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t7*(t4 + lam6_22) - (t10*t23 - (t34 - 2.0289563933923875_rk*lam6_12)) - &
        0.042925575293549574_rk*lam6_23 - lam6_13*(0.0870114460092663_rk - t35)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    lam5_32 = ww5_yz + alpha5_x
    t36 = ww5_xx - ww5_yy
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_y = 0.03284626166448073_rk*lam5_32 + (n6_z - (0.10101181803004346_rk*t22 - &
        0.041147842218669614_rk*(t1 - t36) + 0.05680835589544868_rk*lam5_12) - &
        0.09474888781047501_rk*lam5_31)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = ww5_zz + ww5_yy
    lam5_21 = ww5_xy + alpha4_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_31 = ww6_zx + alpha7_z
    lam6_32 = ww6_yz + alpha6_x
    t37 = 1.8772205723301225_rk*(0.11538550714999525_rk*s7 - t35)
    t38 = s5*t16 - c5*t19
    t39 = lam6_12*t35 - t33*lam6_31 + (t3*t28 + t24*t37 - (t9*t38 - t7*lam6_32))
    ! link 7: moment that turns the link [N m]
    nc7_z = t39 - lam6_13*t32
    t40 = 0.042925575293549574_rk*t3 + (-0.36144292274665746_rk*lam6_32 - &
        0.16772238154175834_rk*t24) - (0.0870114460092663_rk*lam6_12 - &
        0.4239952187044951_rk*lam6_31 - (nc7_z + 0.6262523039785531_rk*t38) + &
        0.20655564034097101_rk*lam6_13)
    t41 = t37 - 0.16772238154175834_rk
    t42 = t30*t32 - (0.0870114460092663_rk*t25 - (0.042925575293549574_rk*lam6_21 + t28*t31 - &
        0.20655564034097101_rk*lam6_23)) + t2*t35
    t43 = 0.516451399126078_rk*t38 - (t23*t41 + (-2.0289563933923875_rk*lam6_32 - t42)) + &
        lam6_31*(t7 - 0.36144292274665746_rk)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_x = s6*t40 + c6*t43 - (0.05680835589544868_rk*t1 - (0.041147842218669614_rk*lam5_21 - &
        0.03284626166448073_rk*lam5_31))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    lam5_13 = ww5_zx + alpha5_y
    t44 = 0.03284626166448073_rk*t36 - 0.041147842218669614_rk*lam5_23 - (s6*t43 - &
        0.05680835589544868_rk*lam5_13) + 0.09474888781047501_rk*lam5_21 + c6*t40
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t44 + 0.10101181803004346_rk*t38
    t45 = neg_lam4_11 - neg_lam4_22
    t46 = t5*t37 + (-0.516451399126078_rk*lam6_32 - (0.16772238154175834_rk*neg_lam5_22 + &
        0.10101181803004346_rk*lam5_21)) + t10*lam6_31
    t47 = t30*t37 + 0.16772238154175834_rk*lam6_23 - 0.6262523039785531_rk*lam6_21 - &
        0.516451399126078_rk*lam6_22 + t9*t31
    t48 = t4*t9 - (0.6262523039785531_rk*neg_lam6_11 - 0.516451399126078_rk*lam6_12) + lam6_13*t41
    t49 = 0.10101181803004346_rk*neg_lam5_11 - (s6*t47 + c6*t48)
    t50 = s5*t46 - c5*t49
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = -0.013124222729483126_rk*lam4_23 - (3.569490999313376_rk*lam4_12 + &
        3.221934173968582_rk*t15 + 0.09675036990607108_rk*lam4_13 - &
        0.24852411424661205_rk*lam4_21) - (0.20921122087079386_rk*t45 + s5*n5_x - (t50 + &
        (0.2067207712712513_rk*t21 - c5*n5_y)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t51 = ww3_zz - ww3_yy
    t52 = ww3_xx - ww3_zz
    t53 = 0.2067207712712513_rk*t18 - 0.2506667841125447_rk*lam4_13 + &
        0.24852411424661205_rk*lam4_31 - (n5_z + 0.09675036990607108_rk*lam4_12) - &
        0.20921122087079386_rk*lam4_32
    t54 = ww4_zz - ww4_yy
    t55 = t53 - 0.013124222729483126_rk*(t45 + t54)
    t56 = s5*t49 + c5*t46
    t57 = 0.013124222729483126_rk*(15.940846569207324_rk*lam4_31 - lam4_21) + s5*n5_y - &
        (0.09675036990607108_rk*t54 - t56 + c5*n5_x)
    t58 = 3.221934173968582_rk*t18 + (t57 + 0.2506667841125447_rk*lam4_23) - &
        3.569490999313376_rk*lam4_32
    t59 = 0.1005265342798281_rk*(t51 + t52) + (0.0816122074936837_rk*lam3_13 - &
        0.4067460055662282_rk*t17 - (c4*t55 - 0.40382182094267666_rk*ww2_zx + s4*t58))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = t59 - 0.01755847364096103_rk*(t12 + 13.921743270739537_rk*lam3_23)
    t60 = c4*t58 - (0.1005265342798281_rk*neg_lam3_31 - (t56 + (-0.40382182094267666_rk*alpha3_x - &
        s4*t55) - 3.221934173968582_rk*lam4_32))
    t61 = 0.0816122074936837_rk*t51 + (0.2067207712712513_rk*lam4_31 + (0.43062156604456925_rk*c2 &
        + t60 - 0.24444456225550676_rk*lam3_21))
    t62 = s4*(3.221934173968582_rk*neg_lam4_22 - (s6*t48 - 0.2067207712712513_rk*lam4_21 - c6*t47) &
        + 0.10101181803004346_rk*lam5_31)
    t63 = n4_z - t62 - (9.975445786511747_rk*c2 + (0.40382182094267666_rk*alpha3_y - &
        0.24444456225550676_rk*t52)) - 0.1005265342798281_rk*lam3_32 + &
        0.0816122074936837_rk*lam3_12
    t64 = c4*(0.2067207712712513_rk*neg_lam4_11 - (t50 - 3.221934173968582_rk*lam4_12)) - t63
    t65 = 3.509903939799839_rk*c2
    t66 = qd(1)*(s2*t65 + (0.29735998936351243_rk*(c2*t65) - 0.5218524991029152_rk))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*(c3*t61 + s3*t64) - (ww2_zz*(0.20091837135316784_rk*c2 + 0.26458063578324464_rk*s2) &
        - (2.0_rk*(qd(2)*t66) + c2*n3_z))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 24.525_rk*(0.5419930474657001_rk*c2 - 3.126354326358915_rk*s2) + (c3*t64 - s3*t61) - &
        qd(1)*t66
    t67 = 0.9999503996366931_rk*s7
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_y = 0.708306797966195_rk*c7 + t67
    ! link 6: force for a unit acceleration of a joint further out
    fu6_x = -c6*h7_y
    ! link 7: first moment of the composite body, about the frame's origin [kg m]
    h7_x = 1.4117475682965523_rk*h7_y - 2.119984343070462_rk*s7
    t68 = h7_x - 1.5656307599463828_rk
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_x = 1.291128497815195_rk*s6 + c6*t68
    t69 = h6_x - 0.25252954507510866_rk
    t70 = h7_y + 0.4193059538543958_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = c5*t69 - s5*t70
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    h6_y = s6*t68 - 1.291128497815195_rk*c6
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_y = c5*t70 + s5*t69
    t71 = 0.5168019281781282_rk - h5_x
    t72 = 8.054835434921454_rk - h6_y
    t73 = c4*t71 + (s4*t72 + 1.0168650139155704_rk)
    t74 = h5_y - 0.04389618410240257_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    neg_h3_x = c3*t73 + s3*t74
    t75 = t67 + 1.846595961484861_rk*h7_y
    ! link 6: mass matrix, its row of this joint
    m6_7 = -0.11539123059695529_rk*t75
    t76 = 0.4228495651372064_rk*c7
    t77 = c7*t76
    t78 = s7*t76
    t79 = t77 - (0.23972911266611452_rk*t78 + 0.25435035786215276_rk)
    t80 = 0.0870114460092663_rk + m6_7
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = c6*t79 - s6*t80
    k6_yz = s6*t79 + c6*t80
    t81 = c6*c6
    t82 = 0.15093419333331276_rk*h7_y - 0.4353636338505884_rk*c7
    t83 = 2.0_rk*t82 - 0.7228858454933149_rk
    t84 = t78 + (0.23972911266611452_rk*t77 + 1.3126829026743974_rk)
    t85 = c6*s6
    t86 = t81*t83 - (t82 - 0.4025907649653271_rk + t84*t85)
    t87 = k6_yz + 0.05680835589544868_rk
    ! link 4: mass matrix, its row of this joint
    m4_5 = 0.4_rk*h5_y - s5*t86 - c5*t87
    t88 = c5*c5
    t89 = 0.06569252332896146_rk - k6_xz - k6_xz
    t90 = c5*s5
    t91 = t81*t84 + t83*t85
    t92 = t91 + (t84 - 3.0389236225643885_rk)
    t93 = t88*t89 + (k6_xz + (t90*t92 - 0.045970484393963854_rk))
    t94 = m4_5 - 0.09675036990607108_rk
    ! link 4: second moment of the composite body [kg m^2]
    k4_yz = s4*t93 - c4*t94
    ! link 5: mass matrix, its row of this joint
    m5_5 = t84 + 1.2084869398413365_rk - t91
    t95 = k4_yz + 0.06405373385272267_rk
    t96 = c4*s4
    t97 = t91 - (t88*t92 + 7.016595671833826_rk - t89*t90)
    t98 = t97 - 4.4699270629915056_rk - 0.8_rk*h6_y
    t99 = -2.0_rk*(m5_5 + (t97 - 3.067723445330515_rk))
    t100 = t98 + t99
    t101 = c5*t86 - 0.4_rk*h5_x - s5*t87
    t102 = t101 + (t101 + 0.4184224417415877_rk)
    t103 = s4*s4
    t104 = t96*t100 + 0.04690977756007243_rk + (t101 - t102*t103)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xz = s3*t95 - c3*t104
    t105 = t96*t102 + (t100*t103 + 0.9030127193018334_rk)
    ! link 3: mass matrix, its row of this joint
    m3_3 = m5_5 + t105
    t106 = s2*(k3_xz - 0.4_rk*neg_h3_x)
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c2*m3_3 + t106
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = c4*t93 + s4*t94
    ! link 4: mass matrix, its row of this joint
    m4_4 = t98 + 16.41827590041618_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_y = c4*t72 - s4*t71
    t107 = c3*c3
    t108 = t99 - (t105 + (15.016072282755191_rk - m5_5))
    t109 = c3*s3
    t110 = k4_xz + (k4_xz + 0.2010530685596562_rk)
    t111 = t107*t108 - (t109*t110 - 3.9137257607425155_rk)
    t112 = 0.4_rk*h4_y
    t113 = m4_4 + t112
    t114 = t112 + t113
    t115 = t111 + t114
    ! link 1: mass matrix, its row of this joint
    m1_1 = t115 + (c2*(t106 + neg_nu2_y - (c2*t115 - 1.0437049982058304_rk*s2)) + &
        1.3323985656347848_rk)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = c3*t74 - s3*t73
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t104 - 0.4_rk*h3_y + c3*t95
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = c2*(m2_3 + 0.26458063578324464_rk) + s2*(k4_xz - (t108*t109 + (t107*t110 + &
        0.10039183707333973_rk)))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s4*t101 + c4*m5_5
    nu4_x = c4*t101 - s4*m5_5
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = c3*nu4_x + s3*m4_5
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = -c4*h5_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_y = s3*fu4_x + c3*h5_x
    ! link 6: mass matrix, its row of this joint
    m6_6 = 4.057912786784775_rk - t84
    t116 = 0.4_rk*h6_y
    t117 = t116 - m6_6
    ! link 4: mass matrix, its row of this joint
    m4_6 = s5*k6_xz + c5*t117
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = 0.48318719298539553_rk*s6 + c6*t82
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = c5*nu6_x - s5*m6_7
    ! link 5: force for a unit acceleration of a joint further out
    fu5_y = s5*fu6_x + c5*h7_x
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_y = s6*t82 - 0.48318719298539553_rk*c6
    ! link 5: force for a unit acceleration of a joint further out
    neg_fu5_x = s5*h7_x - c5*fu6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = s5*nu6_x + c5*m6_7
    ! link 4: mass matrix, its row of this joint
    m4_7 = 0.4_rk*neg_fu5_x - nu5_y
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t97 + (t111 + (m3_3 + (t97 - t114)))
    t118 = -c3
    m2_4 = t118*t113 - s3*k4_xz
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s3*nu4_x - c3*m4_5
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c3*fu4_x - s3*h5_x
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y + 0.4_rk*fu3_x
    t119 = 0.4_rk*(s4*h6_x - h6_y*(c4*c5)) - m4_6
    t120 = s5*t117 - c5*k6_xz
    t121 = c4*t120 - (s4*k6_yz - s5*t116)
    m2_6 = c3*t119 + s3*t121
    t122 = h7_y*(-s4*s6) - c4*neg_fu5_x
    t123 = nu5_x - 0.4_rk*fu5_y
    t124 = c4*t123 + s4*nu6_y
    m2_7 = 0.4_rk*(c3*t122 - s3*fu5_y) + (s3*t124 - c3*m4_7)
    ! factorisation M = U D U^T
    ud3_7 = s4*t123 - c4*nu6_y
    ud1_7 = c2*ud3_7 - s2*(c3*t124 + (0.4_rk*(t118*fu5_y - s3*t122) + s3*m4_7))
    ! link 7: forward substitution
    y7 = tau(7) - nc7_z
    ! factorisation M = U D U^T
    u6_7 = -0.2388126843429044_rk*t75
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
    t125 = c4*k6_yz + s4*t120
    ud3_6 = t125 - m6_7*u3_7
    u3_6 = ipivot6*ud3_6
    ud2_6 = m2_6 - m6_7*u2_7
    u2_6 = ipivot6*ud2_6
    ud1_6 = c2*t125 - s2*(c3*t121 - s3*t119) - m6_7*u1_7
    u1_6 = ipivot6*ud1_6
    pivot5 = m5_5 + nu6_y*u5_7 - ud5_6*u5_6
    ipivot5 = 1.0_rk / pivot5
    ud4_5 = m4_5 + nu6_y*u4_7 - ud5_6*u4_6
    u4_5 = ipivot5*ud4_5
    ud3_5 = nu4_y + nu6_y*u3_7 - ud5_6*u3_6
    u3_5 = ipivot5*ud3_5
    ud2_5 = m2_5 + nu6_y*u2_7 - ud5_6*u2_6
    u2_5 = ipivot5*ud2_5
    ud1_5 = c2*nu4_y - s2*(nu3_x - 0.4_rk*fu3_y) + nu6_y*u1_7 - ud5_6*u1_6
    u1_5 = ipivot5*ud1_5
    pivot4 = m4_4 - m4_7*u4_7 - ud4_6*u4_6 - ud4_5*u4_5
    ipivot4 = 1.0_rk / pivot4
    neg_ud3_4 = k4_yz + m4_7*u3_7 + ud4_6*u3_6 + ud4_5*u3_5
    u3_4 = -ipivot4*neg_ud3_4
    ud2_4 = m2_4 - m4_7*u2_7 - ud4_6*u2_6 - ud4_5*u2_5
    u2_4 = ipivot4*ud2_4
    t126 = -ud4_6*u1_6 - (c2*k4_yz - s2*(c3*k4_xz - s3*t113) + m4_7*u1_7)
    ud1_4 = t126 - ud4_5*u1_5
    u1_4 = ipivot4*ud1_4
    pivot3 = neg_ud3_4*u3_4 - (ud3_7*u3_7 - m3_3 + ud3_6*u3_6 + ud3_5*u3_5)
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = m2_3 - ud3_7*u2_7 - ud3_6*u2_6 - ud3_5*u2_5 + neg_ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    ud1_3 = neg_ud3_4*u1_4 - (ud3_7*u1_7 - neg_nu2_y + ud3_6*u1_6 + ud3_5*u1_5)
    u1_3 = ipivot3*ud1_3
    pivot2 = -ud2_4*u2_4 - (neg_m2_2 + m2_7*u2_7 + ud2_6*u2_6 + ud2_5*u2_5) - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = k2_yz - m2_7*u1_7 - ud2_6*u1_6 - ud2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    t127 = m1_1 - ud1_7*u1_7 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3
    pivot1 = t127 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 6: forward substitution
    y6 = -y7*u6_7 - (n6_z - tau(6))
    ! link 5: forward substitution
    y5 = -u5_6*y6 - (n5_z - tau(5) + y7*u5_7)
    ! link 4: forward substitution
    y4 = -u4_5*y5 - (n4_z - tau(4) + y7*u4_7 + u4_6*y6)
    ! link 3: forward substitution
    y3 = -u3_4*y4 - (n3_z - tau(3) + y7*u3_7 + u3_6*y6 + u3_5*y5)
    ! link 2: forward substitution
    neg_y2 = n2_z - tau(2) + y7*u2_7 + u2_6*y6 + u2_5*y5 + u2_4*y4 + u2_3*y3
    t128 = n1_z - tau(1) + y7*u1_7 + u1_6*y6 + u1_5*y5 + u1_4*y4 + u1_3*y3
    ! link 1: forward substitution
    y1 = u1_2*neg_y2 - t128
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = -u1_2*qdd1 - ipivot2*neg_y2
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2)
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = ipivot5*y5 - u4_5*qdd4 - u3_5*qdd3 - u2_5*qdd2 - u1_5*qdd1
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = ipivot6*y6 - u5_6*qdd5 - u4_6*qdd4 - u3_6*qdd3 - u2_6*qdd2 - u1_6*qdd1
    t129 = -u2_7*qdd2 - (u6_7*qdd6 - 2.069591277495274_rk*y7 + u5_7*qdd5 + u4_7*qdd4 + u3_7*qdd3)
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = t129 - u1_7*qdd1
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
