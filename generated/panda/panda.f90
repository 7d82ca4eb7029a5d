! panda: Franka Emika Panda, hand locked
! Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
!   fingers locked at the neutral pose
! Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 4ff65a695f92e93333f180c48f97cb00 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0     a 0       d 0.333  theta q + -pi
!       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 15 rad/s^2, 87 N m
!   2  revolute  alpha pi/2  a 0       d 0      theta q + -pi
!       limits: -1.7628 to 1.7628 rad, 2.175 rad/s, 7.5 rad/s^2, 87 N m
!   3  revolute  alpha pi/2  a 0       d 0.316  theta q
!       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 10 rad/s^2, 87 N m
!   4  revolute  alpha pi/2  a 0.0825  d 0      theta q + -pi
!       limits: -3.0718 to -0.0698 rad, 2.175 rad/s, 12.5 rad/s^2, 87 N m
!   5  revolute  alpha pi/2  a 0.0825  d 0.384  theta q + -pi
!       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 15 rad/s^2, 12 N m
!   6  revolute  alpha pi/2  a 0       d 0      theta q
!       limits: -0.0175 to 3.7525 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
!   7  revolute  alpha pi/2  a 0.088   d 0      theta q
!       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
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
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 1.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize search, from the record of an arm that is built alike.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine
!   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
!   bias: 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine
!   mass_matrix: 170 multiplications, 163 additions = 333; 2 unary minus; 12 sine/cosine
!   forward_dynamics: 553 multiplications, 511 additions, 6 divisions = 1070; 1 unary minus; 12
!       sine/cosine
module panda_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: panda_inverse_dynamics
  public :: panda_gravity
  public :: panda_bias
  public :: panda_mass_matrix
  public :: panda_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine
  pure subroutine panda_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="panda_inverse_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: qdd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, t1, w2_x, c2, w2_y, ww2_yz, lam2_23, alpha2_x, c3, s3, w3_x, w3_z, w3_y, ww3_yy
    real(rk) :: ww3_zz, ww3_zx, ww3_xy, ww3_yz, neg_lam3_11, c4, s4, w4_x, w4_z, w4_y, ww4_zz
    real(rk) :: ww4_zx, ww4_xy, ww4_xx, ww4_yz, c5, s5, w5_x, w5_z, w5_y, ww5_yz, ww5_zx, ww5_xy
    real(rk) :: ww5_xx, ww5_zz, neg_lam4_22, neg_lam5_22, c6, s6, w6_x, w6_z, w6_y, ww6_zz, ww6_xy
    real(rk) :: ww6_yy, neg_w7_z, c7, s7, ww2_zz, alpha3_y, lam3_13, alpha4_z, lam4_21, alpha3_x
    real(rk) :: ww2_zx, neg_lam2_13, alpha3_z, alpha4_y, alpha5_z, lam5_21, alpha4_x, neg_alpha5_x
    real(rk) :: lam5_32, lam3_31, t2, ww2_xx, neg_lam2_22, t3, lam3_22, t4, lam4_11, lam4_31
    real(rk) :: lam3_23, lam3_21, alpha5_y, lam5_13, alpha6_z, lam6_21, t5, t6, lam6_31, ww7_zz
    real(rk) :: lam5_23, t7, lam6_32, lam6_12, lam5_31, t8, lam5_11, t9, neg_lam6_22, t10, t11, t12
    real(rk) :: t13, neg_lam6_11, neg_lam6_13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23
    real(rk) :: t24, t25, t26, t27, t28, t29, t30, t31, t32, t33, t34, t35, t36, t37, t38, t39, t40
    real(rk) :: t41, t42, t43, t44, t45, nc7_z, lam6_23, lam5_12, t46, t47, t48, t49, t50, t51, t52
    real(rk) :: n6_z, lam4_32, t53, t54, t55, t56, t57, t58, t59, t60, t61, t62, t63, t64, t65, t66
    real(rk) :: t67, t68, n4_x, lam4_23, lam4_13, lam4_12, t69, n5_z, t70, t71, t72, t73, t74, t75
    real(rk) :: t76, n3_z, lam3_12, t77, t78, n4_z, lam3_32, t79, t80, t81, t82, t83, t84, t85, t86
    real(rk) :: t87, t88, n1_z, t89, n2_z

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    t1 = -s2
    ! link 2: angular velocity [rad/s]
    w2_x = t1*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - lam2_23
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    w3_x = w2_x*c3 + qd(2)*s3
    w3_z = qd(3) - w2_y
    w3_y = qd(2)*c3 - w2_x*s3
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ww3_zx = w3_x*w3_z
    ww3_xy = w3_x*w3_y
    ww3_yz = w3_z*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = -w3_z*s4 - w3_x*c4
    w4_z = qd(4) - w3_y
    w4_y = w3_x*s4 - w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = w4_z*w4_z
    ww4_zx = w4_x*w4_z
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_yz = w4_z*w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = -w4_z*s5 - w4_x*c5
    w5_z = qd(5) - w4_y
    w5_y = w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_z*w5_y
    ww5_zx = w5_x*w5_z
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_zz + ww4_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 + w5_z*s6
    w6_z = qd(6) - w5_y
    w6_y = w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 7: angular velocity [rad/s]
    neg_w7_z = w6_y - qd(7)
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = c3*qdd(2) - w3_x*qd(3) - alpha2_x*s3
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_13 = ww3_zx + alpha3_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = ww4_xy + alpha4_z
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y + (s3*qdd(2) + alpha2_x*c3)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = ww2_zx + (neg_lam2_13 + qdd(3))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = s4*alpha3_x + (-c4*alpha3_z - w4_x*qd(4))
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = qdd(5) - alpha4_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + alpha5_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (c4*alpha3_x + s4*alpha3_z)
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = s5*alpha4_z - qd(5)*w5_y + c5*alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz - neg_alpha5_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_31 = ww3_zx - alpha3_y
    t2 = t1*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = qd(1)*t2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    t3 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t3 - neg_lam2_22
    t4 = ww4_zz - ww4_xx
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = lam3_22 - t4
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_23 = ww3_yz - alpha3_x
    lam3_21 = ww3_xy + alpha3_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = s5*alpha4_x - w5_x*qd(5) - c5*alpha4_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx + alpha5_y
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = qdd(6) - alpha5_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy + alpha6_z
    t5 = qd(6) + w6_z
    t6 = -c6*alpha5_z - s6*neg_alpha5_x
    lam6_31 = w6_x*t5 + t6
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = neg_w7_z*neg_w7_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz + neg_alpha5_x
    t7 = c6*neg_alpha5_x - s6*alpha5_z
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_32 = w6_y*t5 - t7
    lam6_12 = ww6_xy - alpha6_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    t8 = ww5_xx - ww5_zz
    lam5_11 = t8 - neg_lam4_22
    t9 = ww6_zz - ww6_yy
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_22 = neg_lam5_22 + t9
    t10 = ww6_zz - ww7_zz
    t11 = ww6_zz + ww7_zz
    t12 = t11 - neg_lam6_22
    t13 = t10 + t12
    neg_lam6_11 = neg_lam5_22 + t13
    neg_lam6_13 = t6 + w5_y*w6_x
    t14 = 0.0002123224431354016_rk*s7
    t15 = t14 + 0.00016784129658960374_rk*c7
    t16 = 118.9090909090909_rk*c2 + lam3_31 - 3.83030303030303_rk*neg_lam2_22
    t17 = 118.9090909090909_rk*s2
    t18 = c3*t17
    t19 = neg_lam3_11 + t18 - 3.83030303030303_rk*lam3_13
    t20 = s4*t16 - c4*t19
    t21 = t20 - lam4_11
    t22 = 3.83030303030303_rk*lam3_23 + (s3*t17 + lam3_21)
    t23 = lam4_31 - t22
    t24 = c5*t21 - s5*t23
    t25 = t24 + 4.654545454545454_rk*lam5_13
    t26 = s4*t19 + c4*t16
    t27 = lam4_21 - t26
    t28 = 4.654545454545454_rk*neg_lam4_22 + t27
    t29 = c6*t25 - s6*t28
    t30 = 1.0666666666666667_rk*neg_lam6_11 - t29
    t31 = 11.402203849817942_rk*c7
    t32 = t14*t31
    t33 = 0.0002123224431354016_rk*c7
    t34 = t31*t33
    t35 = 0.32333777029991095_rk*t32 - (t34 + 0.00213160409441986_rk)
    t36 = qdd(7) + neg_lam6_13
    t37 = 0.0009653051699191118_rk*s7 + 0.0012555365982729084_rk*c7
    t38 = t32 + (0.32333777029991095_rk*t34 - 0.0003913912816842475_rk)
    t39 = lam6_31 + qdd(7)
    t40 = t35 + 0.006684151967360947_rk
    t41 = s5*t21 + c5*t23
    t42 = t41 + (1.0666666666666667_rk*lam6_31 - 4.654545454545454_rk*lam5_23)
    t43 = t33 - 0.00016784129658960374_rk*s7
    t44 = t15*t30 - (t35*t36 - (t37*lam6_12 - (t38*t13 - t39*t40))) + t42*t43
    t45 = 0.0009653051699191118_rk*c7 - 0.0012555365982729084_rk*s7
    ! link 7: moment that turns the link [N m]
    nc7_z = t44 - lam6_32*t45
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_23 = t7 - w5_y*w6_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    t46 = 2.0_rk*neg_w7_z
    t47 = w6_x*t46 - lam6_12
    t48 = 0.0011196707334275547_rk*lam6_21 - 0.028934422545659907_rk*lam6_12 - (t37*t36 + &
        0.0005462437073966822_rk*(neg_lam6_22 - neg_lam6_11)) - &
        (9.35690973146064e-05_rk*neg_lam6_13 - t47*t40)
    t49 = lam6_32 - w6_z*t46
    t50 = s6*t25 + c6*t28
    t51 = t50 - 1.0666666666666667_rk*lam6_21
    t52 = t15*t49 - (0.014338888209442497_rk*neg_lam6_22 - 0.017931959153753906_rk*t51 + t47*t43)
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t48 - (t45*t12 - 0.0001037589172186853_rk*lam6_23) - (1.0666666666666667_rk*t52 + &
        0.014338888209442497_rk*t30 - t38*t49 + t51*t43)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t53 = t37*t10 + 0.014338888209442497_rk*t42 - 0.028934422545659907_rk*lam6_32 - (t15*t51 + &
        t38*t47 - (t35*t49 + t45*t39))
    t54 = 0.0055993270925625_rk*t50 + 0.0001037589172186853_rk*lam6_21 + &
        (9.35690973146064e-05_rk*t9 - 0.0005462437073966822_rk*lam6_31 + t53)
    t55 = neg_lam5_22 + lam5_11
    t56 = 0.017931959153753906_rk*t42 + (t39*t43 - (0.014338888209442497_rk*lam6_32 + t15*(t11 - &
        t13)))
    t57 = 0.0055993270925625_rk*neg_lam5_22 + t56
    t58 = 0.0005462437073966822_rk*lam6_32 + nc7_z + (9.35690973146064e-05_rk*lam6_12 + &
        0.0001037589172186853_rk*t13 + 1.0666666666666667_rk*(t56 + 0.005249369149277343_rk*t29))
    t59 = t58 + 0.0011196707334275547_rk*lam6_31
    t60 = c6*t54 - 0.010045187828321245_rk*lam5_32 - 0.00151524447332703_rk*lam5_31 - &
        0.0021640520520981327_rk*(t8 - t55) - (4.654545454545454_rk*t57 + s6*t59)
    t61 = t60 - 0.0010267877770288932_rk*lam5_21
    t62 = 0.014338888209442497_rk*lam6_12 + (t43*t11 + 0.017931959153753906_rk*t30 - &
        (0.0055993270925625_rk*neg_lam6_13 - t15*t36))
    t63 = t52 + 0.0055993270925625_rk*lam6_23
    t64 = c6*t62 - s6*t63
    t65 = 0.0010267877770288932_rk*t8 + (0.001208932934385_rk*t27 + 4.654545454545454_rk*t64 - &
        (-0.0021640520520981327_rk*lam5_12 - n6_z - 0.00151524447332703_rk*lam5_32))
    t66 = 0.001451156065026714_rk*lam5_31 + t65
    t67 = neg_lam4_22 + lam3_22
    t68 = 0.0039053550262761055_rk*lam4_21 - c5*t61 + 0.07937575371526083_rk*lam4_31 + (s5*t66 - &
        (0.08256807420204747_rk*t22 - 0.00164448757736928_rk*t67))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.30879988491513166_rk*lam4_32 - t68
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    lam4_12 = ww4_xy - alpha4_z
    t69 = 0.0021640520520981327_rk*lam5_13 - 0.0010267877770288932_rk*lam5_23 - (c6*t59 + s6*t54) &
        - (0.010045187828321245_rk*lam5_12 - 0.001451156065026714_rk*lam5_21)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t69 - (0.00151524447332703_rk*t55 - 0.001208932934385_rk*t41)
    t70 = 0.022178148964878252_rk*lam4_23 - n4_x
    t71 = t64 - (0.02767241350487109_rk*t24 - 0.001208932934385_rk*lam5_11)
    t72 = t57 - (-0.001208932934385_rk*lam5_21 - 0.02767241350487109_rk*t41)
    t73 = s5*t71 + c5*t72
    t74 = 0.02759391246306875_rk*lam4_13 - 0.00164448757736928_rk*lam4_12 - t73 - n5_z - &
        (0.010831526996380998_rk*ww4_zx + (0.0039053550262761055_rk*t4 - &
        0.07937575371526083_rk*lam4_32))
    t75 = t73 - (0.08256807420204747_rk*lam4_32 + 0.016011409030815008_rk*t22)
    t76 = c4*t74 - 0.0001219124209507298_rk*(neg_lam3_11 + lam3_22) - &
        (0.005487648106562251_rk*lam3_23 + (0.002328735327434986_rk*t18 - &
        1.3360662912304e-05_rk*lam3_21 - t75))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = s4*t70 - t76 - 0.013297019103287523_rk*lam3_13
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - alpha3_z
    t77 = 0.001208932934385_rk*lam5_31 + (s6*t62 + 0.02767241350487109_rk*t27 + c6*t63)
    t78 = 0.0039053550262761055_rk*lam4_23 + c5*t66 - (0.30879988491513166_rk*lam4_12 - &
        (0.00164448757736928_rk*lam4_13 - 0.07937575371526083_rk*(t4 - t67) + &
        0.005415763498190499_rk*lam4_21))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t77 + (s5*t61 - 0.08256807420204747_rk*t20) + t78
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = ww3_yz + alpha3_x
    t79 = t2 - (qd(1) - t2)
    t80 = 0.0007689361029464017_rk*s2
    t81 = 0.0007689361029464017_rk*(c2 + 13.344544210747523_rk*s2)
    t82 = 0.27690780075317833_rk*c2
    t83 = ww2_zz*(0.010261101821008168_rk*c2 - t80) + (t81*qdd(2) + &
        (qdd(1)*(37.41570986608598_rk*(t80*t82) - 0.03733744848940618_rk) - c2*n3_z))
    t84 = 3.83030303030303_rk*t75 + (s4*t74 + c4*t70) - (0.10510540975539216_rk*lam3_23 - (t82 - &
        (0.013297019103287523_rk*t3 + 0.005487648106562251_rk*lam3_21 - &
        0.0001219124209507298_rk*lam3_31)))
    t85 = 0.016011409030815008_rk*t20 + 0.08256807420204747_rk*lam4_12 - (c5*t71 - s5*t72)
    t86 = 0.08256807420204747_rk*neg_lam4_22 + (t77 - 0.016011409030815008_rk*t26)
    t87 = s4*t85 - c4*t86 - 3.83030303030303_rk*(c4*t85 + s4*t86) - &
        0.013297019103287523_rk*lam3_12
    t88 = t87 + (n4_z + (0.005487648106562251_rk*(neg_lam3_11 - neg_lam2_22 - &
        0.0024346792383292625_rk*lam3_31) + (0.0001219124209507298_rk*lam3_32 - &
        0.10510540975539216_rk*lam3_13)))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.007966717767871044_rk*qd(2)*t79 - (t83 + s2*(c3*t84 + s3*t88))
    t89 = 0.04615576498986361_rk*qdd(2) - t79*(0.003983358883935522_rk*qd(1)) + s3*t84 - &
        (4.746153896127808_rk*s2 - 0.01993386669246_rk*c2)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = t89 - qdd(1)*t81 - c3*t88
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
  pure subroutine panda_gravity(q, tau) &
      bind(c, name="panda_gravity_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s7, c7, hw7_y, c6, c5, c4, s2, c3, c2, s4, s5, s3, s6, hw7_x, t1, t2, t3, t4, t5
    real(rk) :: tau7, t6, hw6_y, hw6_x, tau6, t7, t8, hw5_y, neg_hw5_x, tau5, t9, t10, hw4_y, hw4_x
    real(rk) :: tau4, t11, t12, tau3, hw3_x, hw2_x

    ! sines and cosines of the joint angles
    s7 = sin(q(7))
    c7 = cos(q(7))
    ! link 7: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw7_y = 0.02524706869282775_rk*s7 + 0.019957855994472883_rk*c7
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
    hw7_x = 0.02524706869282775_rk*c7 - 0.019957855994472883_rk*s7
    t1 = s2*c3
    t2 = c4*t1 - c2*s4
    t3 = s2*s3
    t4 = c5*t2 - s5*t3
    t5 = t1*s4 + c4*c2
    ! link 7: joint torque [N m], at a prismatic joint force [N]
    tau7 = hw7_y*(c6*t4 - s6*t5) - hw7_x*(t2*s5 + c5*t3)
    t6 = hw7_x + 2.2744244919379497_rk
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_y = s6*t6 - 1.7050241616318897_rk*c6
    hw6_x = c6*t6 + 1.7050241616318897_rk*s6
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = t4*hw6_y + t5*hw6_x
    t7 = hw7_y - 0.66581089427925_rk
    t8 = hw6_x - 0.14375311619778_rk
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = c5*t7 - s5*t8
    neg_hw5_x = c5*t8 + s5*t7
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t3*neg_hw5_x - t2*hw5_y
    t9 = neg_hw5_x - 5.422774494316499_rk
    t10 = hw6_y + 19.742856060845426_rk
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = s4*t9 + c4*t10
    hw4_x = c4*t9 - s4*t10
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t1*hw4_y + c2*hw4_x
    t11 = 0.27690780075317833_rk - hw5_y
    t12 = hw4_x + 7.32667658634432_rk
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = t1*t11 + t3*t12
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = c3*t12 - s3*t11
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = s2*(-hw4_y - 32.809545426852715_rk) - c2*(hw3_x - 0.01993386669246_rk)
    tau(1) = 0.0_rk
    tau(2) = hw2_x
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
    tau(7) = tau7
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine
  pure subroutine panda_bias(q, qd, tau) &
      bind(c, name="panda_bias_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(out) :: tau(7)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_yz, c3, s3, neg_w3_x, w3_z, w3_y, ww3_yy
    real(rk) :: ww3_zz, neg_ww3_zx, neg_ww3_xy, ww3_yz, neg_lam3_11, c4, s4, neg_w4_x, neg_w4_z
    real(rk) :: neg_w4_y, ww4_zz, ww4_zx, ww4_xy, ww4_xx, ww4_yz, c5, s5, w5_x, w5_z, neg_w5_y
    real(rk) :: neg_ww5_yz, ww5_zx, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam4_22, neg_lam5_22, c6, s6
    real(rk) :: w6_x, w6_z, w6_y, ww6_zz, ww6_xy, ww6_yy, w7_z, c7, s7, ww2_zz, alpha3_y
    real(rk) :: neg_lam3_13, lam4_21, alpha3_x, neg_ww2_zx, alpha4_y, neg_lam5_21, neg_alpha4_x
    real(rk) :: neg_alpha5_x, neg_lam5_32, neg_lam3_31, t1, ww2_xx, neg_lam2_22, t2, lam3_22, t3
    real(rk) :: lam4_11, lam4_31, lam3_23, neg_lam3_21, alpha5_y, lam5_13, lam6_21, t4, t5, lam6_31
    real(rk) :: ww7_zz, neg_lam5_23, t6, lam6_32, lam6_12, lam5_31, t7, lam5_11, t8, neg_lam6_22
    real(rk) :: t9, t10, t11, t12, neg_lam6_11, neg_lam6_13, t13, t14, t15, t16, t17, t18, t19, t20
    real(rk) :: t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, t31, t32, t33, t34, t35, t36, t37
    real(rk) :: t38, t39, t40, t41, t42, nc7_z, lam6_23, neg_lam5_12, t43, t44, t45, t46, t47, t48
    real(rk) :: t49, n6_z, lam4_32, t50, t51, t52, t53, t54, t55, t56, t57, t58, t59, t60, t61, t62
    real(rk) :: t63, t64, t65, n4_x, lam4_23, lam4_13, lam4_12, t66, n5_z, t67, t68, t69, t70, t71
    real(rk) :: t72, t73, n3_z, lam3_12, t74, t75, n4_z, lam3_32, t76, t77, t78, t79, t80, t81, t82
    real(rk) :: n1_z, n2_z

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    neg_w3_x = neg_w2_x*c3 - qd(2)*s3
    w3_z = neg_w2_y + qd(3)
    w3_y = qd(2)*c3 + neg_w2_x*s3
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    neg_ww3_zx = neg_w3_x*w3_z
    neg_ww3_xy = neg_w3_x*w3_y
    ww3_yz = w3_z*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = w3_z*s4 - neg_w3_x*c4
    neg_w4_z = w3_y - qd(4)
    neg_w4_y = neg_w3_x*s4 + w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = neg_w4_z*neg_w4_z
    ww4_zx = neg_w4_x*neg_w4_z
    ww4_xy = neg_w4_x*neg_w4_y
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_yz = neg_w4_z*neg_w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = neg_w4_x*c5 + neg_w4_z*s5
    w5_z = neg_w4_y + qd(5)
    neg_w5_y = neg_w4_x*s5 - neg_w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_yz = w5_z*neg_w5_y
    ww5_zx = w5_x*w5_z
    neg_ww5_xy = w5_x*neg_w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_zz + ww4_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 + w5_z*s6
    w6_z = neg_w5_y + qd(6)
    w6_y = w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww2_yz*s3 + neg_w3_x*qd(3)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_13 = neg_ww3_zx - alpha3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = ww4_xy - alpha3_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - neg_ww2_yz*c3
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = s4*alpha3_x + (neg_w4_x*qd(4) + c4*neg_ww2_zx)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_21 = neg_ww5_xy + alpha4_y
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = qd(4)*neg_w4_y + (c4*alpha3_x - s4*neg_ww2_zx)
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = qd(5)*neg_w5_y - s5*alpha3_y - c5*neg_alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = neg_ww5_yz + neg_alpha5_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    t1 = s2*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = qd(1)*t1
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    t2 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t2 - neg_lam2_22
    t3 = ww4_zz - ww4_xx
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = lam3_22 - t3
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_23 = ww3_yz - alpha3_x
    neg_lam3_21 = neg_ww3_xy + neg_ww2_zx
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = c5*alpha3_y - (w5_x*qd(5) + s5*neg_alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx + alpha5_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy - alpha5_y
    t4 = qd(6) + w6_z
    t5 = c6*alpha4_y - s6*neg_alpha5_x
    lam6_31 = w6_x*t4 + t5
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = w7_z*w7_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_23 = neg_ww5_yz - neg_alpha5_x
    t6 = s6*alpha4_y + c6*neg_alpha5_x
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_32 = w6_y*t4 - t6
    lam6_12 = ww6_xy + alpha5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    t7 = ww5_xx - ww5_zz
    lam5_11 = t7 - neg_lam4_22
    t8 = ww6_zz - ww6_yy
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_22 = neg_lam5_22 + t8
    t9 = ww6_zz - ww7_zz
    t10 = ww6_zz + ww7_zz
    t11 = t10 - neg_lam6_22
    t12 = t9 + t11
    neg_lam6_11 = neg_lam5_22 + t12
    neg_lam6_13 = t5 - neg_w5_y*w6_x
    t13 = 0.0002123224431354016_rk*s7
    t14 = t13 + 0.00016784129658960374_rk*c7
    t15 = 118.9090909090909_rk*c2 - neg_lam3_31 - 3.83030303030303_rk*neg_lam2_22
    t16 = 118.9090909090909_rk*s2
    t17 = c3*t16
    t18 = neg_lam3_11 + t17 + 3.83030303030303_rk*neg_lam3_13
    t19 = s4*t15 - c4*t18
    t20 = t19 - lam4_11
    t21 = 3.83030303030303_rk*lam3_23 + (s3*t16 - neg_lam3_21)
    t22 = lam4_31 - t21
    t23 = c5*t20 - s5*t22
    t24 = t23 + 4.654545454545454_rk*lam5_13
    t25 = s4*t18 + c4*t15
    t26 = lam4_21 - t25
    t27 = 4.654545454545454_rk*neg_lam4_22 + t26
    t28 = c6*t24 - s6*t27
    t29 = 1.0666666666666667_rk*neg_lam6_11 - t28
    t30 = 11.402203849817942_rk*c7
    t31 = t13*t30
    t32 = 0.0002123224431354016_rk*c7
    t33 = t30*t32
    t34 = 0.32333777029991095_rk*t31 - (t33 + 0.00213160409441986_rk)
    t35 = 0.0009653051699191118_rk*s7 + 0.0012555365982729084_rk*c7
    t36 = t31 + (0.32333777029991095_rk*t33 - 0.0003913912816842475_rk)
    t37 = t34 + 0.006684151967360947_rk
    t38 = s5*t20 + c5*t22
    t39 = t38 + (4.654545454545454_rk*neg_lam5_23 + 1.0666666666666667_rk*lam6_31)
    t40 = t32 - 0.00016784129658960374_rk*s7
    t41 = t14*t29 - (t34*neg_lam6_13 - (t35*lam6_12 - (t36*t12 - lam6_31*t37))) + t39*t40
    t42 = 0.0009653051699191118_rk*c7 - 0.0012555365982729084_rk*s7
    ! link 7: moment that turns the link [N m]
    nc7_z = t41 - lam6_32*t42
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_23 = t6 + neg_w5_y*w6_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww5_xy - alpha4_y
    t43 = -2.0_rk*w7_z
    t44 = w6_x*t43 - lam6_12
    t45 = s6*t24 + c6*t27
    t46 = t45 - 1.0666666666666667_rk*lam6_21
    t47 = lam6_32 - w6_z*t43
    t48 = t14*t47 - (0.014338888209442497_rk*neg_lam6_22 - 0.017931959153753906_rk*t46 + t44*t40)
    t49 = 0.0001037589172186853_rk*lam6_23 - (t42*t11 + (t46*t40 - (t36*t47 - &
        (1.0666666666666667_rk*t48 + 0.014338888209442497_rk*t29))))
    ! link 6: moment through the joint, about the frame's origin [N m]
    n6_z = t44*t37 - (0.0005462437073966822_rk*(neg_lam6_22 - neg_lam6_11) + &
        (0.028934422545659907_rk*lam6_12 - (0.0011196707334275547_rk*lam6_21 + t49))) - &
        neg_lam6_13*(t35 + 9.35690973146064e-05_rk)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz - neg_alpha4_x
    t50 = 0.028934422545659907_rk*lam6_32 - (0.014338888209442497_rk*t39 + (t35*t9 + &
        (9.35690973146064e-05_rk*t8 + (0.0055993270925625_rk*t45 + &
        0.0001037589172186853_rk*lam6_21))))
    t51 = t34*t47 - (t36*t44 + (t14*t46 + t50)) + lam6_31*(t42 - 0.0005462437073966822_rk)
    t52 = neg_lam5_22 + lam5_11
    t53 = 0.017931959153753906_rk*t39 + (lam6_31*t40 - (0.014338888209442497_rk*lam6_32 + t14*(t10 &
        - t12)))
    t54 = 0.0055993270925625_rk*neg_lam5_22 + t53
    t55 = 0.0005462437073966822_rk*lam6_32 + nc7_z + (9.35690973146064e-05_rk*lam6_12 + &
        0.0001037589172186853_rk*t12 + 1.0666666666666667_rk*(t53 + 0.005249369149277343_rk*t28))
    t56 = t55 + 0.0011196707334275547_rk*lam6_31
    t57 = 0.010045187828321245_rk*neg_lam5_32 + c6*t51 - 0.00151524447332703_rk*lam5_31 - &
        0.0021640520520981327_rk*(t7 - t52) - (4.654545454545454_rk*t54 + s6*t56)
    t58 = 0.0010267877770288932_rk*neg_lam5_21 + t57
    t59 = 0.017931959153753906_rk*t29 + (0.014338888209442497_rk*lam6_12 + t40*t10) + &
        neg_lam6_13*(t14 - 0.0055993270925625_rk)
    t60 = t48 + 0.0055993270925625_rk*lam6_23
    t61 = c6*t59 - s6*t60
    t62 = 0.0010267877770288932_rk*t7 + (0.001208932934385_rk*t26 + 4.654545454545454_rk*t61 - &
        (0.00151524447332703_rk*neg_lam5_32 + (0.0021640520520981327_rk*neg_lam5_12 - n6_z)))
    t63 = 0.001451156065026714_rk*lam5_31 + t62
    t64 = neg_lam4_22 + lam3_22
    t65 = 0.0039053550262761055_rk*lam4_21 - c5*t58 + 0.07937575371526083_rk*lam4_31 + (s5*t63 - &
        (0.08256807420204747_rk*t21 - 0.00164448757736928_rk*t64))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.30879988491513166_rk*lam4_32 - t65
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz + neg_alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    lam4_12 = ww4_xy + alpha3_y
    t66 = 0.0010267877770288932_rk*neg_lam5_23 + 0.0021640520520981327_rk*lam5_13 - (c6*t56 + &
        s6*t51) - (0.001451156065026714_rk*neg_lam5_21 - 0.010045187828321245_rk*neg_lam5_12)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t66 - (0.00151524447332703_rk*t52 - 0.001208932934385_rk*t38)
    t67 = 0.022178148964878252_rk*lam4_23 - n4_x
    t68 = t61 - (0.02767241350487109_rk*t23 - 0.001208932934385_rk*lam5_11)
    t69 = t54 - (0.001208932934385_rk*neg_lam5_21 - 0.02767241350487109_rk*t38)
    t70 = s5*t68 + c5*t69
    t71 = 0.02759391246306875_rk*lam4_13 - 0.00164448757736928_rk*lam4_12 - t70 - n5_z - &
        (0.010831526996380998_rk*ww4_zx + (0.0039053550262761055_rk*t3 - &
        0.07937575371526083_rk*lam4_32))
    t72 = t70 - (0.08256807420204747_rk*lam4_32 + 0.016011409030815008_rk*t21)
    t73 = c4*t71 - 0.0001219124209507298_rk*(neg_lam3_11 + lam3_22) - &
        (0.005487648106562251_rk*lam3_23 + (0.002328735327434986_rk*t17 + &
        1.3360662912304e-05_rk*neg_lam3_21 - t72))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.013297019103287523_rk*neg_lam3_13 + (s4*t67 - t73)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = neg_ww2_zx - neg_ww3_xy
    t74 = 0.001208932934385_rk*lam5_31 + (s6*t59 + 0.02767241350487109_rk*t26 + c6*t60)
    t75 = 0.0039053550262761055_rk*lam4_23 + c5*t63 - (0.30879988491513166_rk*lam4_12 - &
        (0.00164448757736928_rk*lam4_13 - 0.07937575371526083_rk*(t3 - t64) + &
        0.005415763498190499_rk*lam4_21))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t74 + (s5*t58 - 0.08256807420204747_rk*t19) + t75
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = ww3_yz + alpha3_x
    t76 = t1 - (qd(1) - t1)
    t77 = 3.83030303030303_rk*t72 + (s4*t71 + c4*t67) - (0.10510540975539216_rk*lam3_23 - &
        (0.27690780075317833_rk*c2 - (0.013297019103287523_rk*t2 - &
        0.005487648106562251_rk*neg_lam3_21 + 0.0001219124209507298_rk*neg_lam3_31)))
    t78 = 0.016011409030815008_rk*t19 + 0.08256807420204747_rk*lam4_12 - (c5*t68 - s5*t69)
    t79 = 0.08256807420204747_rk*neg_lam4_22 + (t74 - 0.016011409030815008_rk*t25)
    t80 = s4*t78 - c4*t79 - 3.83030303030303_rk*(c4*t78 + s4*t79) - &
        0.013297019103287523_rk*lam3_12
    t81 = t80 + (n4_z + (0.005487648106562251_rk*(0.0024346792383292625_rk*neg_lam3_31 + &
        (neg_lam3_11 - neg_lam2_22)) + (0.0001219124209507298_rk*lam3_32 + &
        0.10510540975539216_rk*neg_lam3_13)))
    t82 = ww2_zz*(0.010261101821008168_rk*c2 - 0.0007689361029464017_rk*s2) - c2*n3_z + s2*(c3*t77 &
        + s3*t81)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.007966717767871044_rk*qd(2)*t76 - t82
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = -c3*t81 - (t76*(0.003983358883935522_rk*qd(1)) - s3*t77 + (4.746153896127808_rk*s2 - &
        0.01993386669246_rk*c2))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n6_z
    tau(7) = nc7_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 170 multiplications, 163 additions = 333; 2 unary minus; 12 sine/cosine
  pure subroutine panda_mass_matrix(q, M) &
      bind(c, name="panda_mass_matrix_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(out) :: M(49)
    real(rk) :: c2, s2, c3, s3, c4, s4, c5, s5, c6, s6, c7, s7, t1, t2, t3, k7_yz, t4, t5, t6, t7
    real(rk) :: t8, t9, neg_k6_yz, neg_k7_xz, t10, t11, t12, t13, t14, t15, t16, t17, k5_xz, k6_xz
    real(rk) :: t18, t19, t20, t21, t22, t23, t24, neg_k5_yy, m5_5, m6_6, neg_k5_yz, t25, t26, t27
    real(rk) :: t28, t29, t30, m4_5, t31, t32, k4_xz, t33, t34, t35, t36, t37, t38, t39, m4_4
    real(rk) :: neg_k4_yz, t40, t41, t42, t43, t44, t45, t46, t47, t48, t49, t50, t51, t52, t53
    real(rk) :: t54, t55, t56, m3_3, t57, t58, t59, t60, t61, t62, t63, t64, t65, t66, m1_1, m2_3
    real(rk) :: neg_k2_yz, nu2_y, m3_5, nu4_x, t67, t68, t69, m3_6, m4_6, t70, t71, t72, nu3_x
    real(rk) :: nu6_x, nu6_y, t73, t74, t75, t76, nu4_y, m3_7, t77, t78, m4_7, m2_2, m2_4, t79
    real(rk) :: nu3_y, t80, m2_5, t81, m2_6, t82, t83, t84, m2_7, t85, t86, t87, t88, t89

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
    t1 = 0.000179030716362244_rk*(s7 - 1.2650190832031087_rk*c7)
    t2 = 5.270530539521458_rk*t1
    t3 = 0.002420943778521227_rk*c7
    ! link 7: second moment of the composite body [kg m^2]
    k7_yz = 1.0230167595416089_rk*(t2 + t3)
    t4 = k7_yz + 9.35690973146064e-05_rk
    t5 = t2 + 0.0006089563838965577_rk*s7
    t6 = 0.1367578289558041_rk*(t3 + t5)
    t7 = c7*t3
    t8 = s7*t3
    t9 = 1.0666666666666667_rk*t6 - (0.32333777029991095_rk*t7 - 0.0004951501989029328_rk + t8)
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = c6*t4 - s6*t9
    ! link 7: second moment of the composite body [kg m^2]
    neg_k7_xz = 0.8086967012001633_rk*t5
    t10 = neg_k6_yz - 0.0021640520520981327_rk
    t11 = c6*c6
    t12 = neg_k7_xz - (0.029497140765350628_rk - neg_k7_xz)
    t13 = c6*s6
    t14 = 0.32333777029991095_rk*t8 - (t7 + 0.009543771269492213_rk)
    t15 = 0.006684151967360947_rk - t1
    t16 = t1 - t14 - t15
    t17 = (t11 - 0.5_rk)*t12 - (t13*t16 - 0.004600245517563107_rk)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = s5*t10 - c5*t17
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = c6*t9 + s6*t4
    t18 = c5*s5
    t19 = k6_xz + (k6_xz - 0.00303048894665406_rk)
    t20 = c5*c5
    t21 = t14 - 0.0026330206532488923_rk
    t22 = t12*t13 + 0.6173375163284962_rk + t11*t16
    t23 = 0.6477230949391829_rk - t22
    t24 = t21 + t23
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yy = t18*t19 + (t20*t24 - t23)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t23 - t21
    ! link 6: mass matrix, its row of this joint
    m6_6 = 0.057868845091319815_rk - t16
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = c5*t10 + s5*t17
    t25 = 0.9375_rk*t1
    t26 = t25 - 0.0191274230973375_rk
    t27 = 0.014338888209442497_rk*s6 - c6*t26
    t28 = t27 - 0.001208932934385_rk
    t29 = t6 - 0.0055993270925625_rk
    t30 = s5*t28 - c5*t29
    ! link 4: mass matrix, its row of this joint
    m4_5 = neg_k5_yz + 4.654545454545454_rk*t30
    t31 = m4_5 - 0.00164448757736928_rk
    t32 = t18*t24 - (t30 - (t19*(0.5_rk - t20) + 0.0039053550262761055_rk))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = s4*t31 - c4*t32
    t33 = 0.014338888209442497_rk*c6 + s6*t26
    t34 = 4.654545454545454_rk*t33
    t35 = t34 - m6_6
    t36 = t34 - (t22 - t35)
    t37 = s5*t29 + c5*t28
    t38 = t37 - m5_5
    t39 = t37 + (t38 - neg_k5_yy)
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.10204027231363098_rk - t36 - t39
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*t32 + c4*t31
    t40 = 0.022178148964878252_rk - neg_k5_yy
    t41 = t33 - 0.16284087268546082_rk
    t42 = t41 - 0.0031923204867866503_rk
    t43 = t37 - 0.04560437265862499_rk
    t44 = c4*t42 - s4*t43
    t45 = 3.83030303030303_rk*t44
    t46 = c4*s4
    t47 = 4.654545454545454_rk*t37 - k5_xz
    t48 = t41 + t47
    t49 = t45 - t46*t48
    t50 = c4*c4
    t51 = t36 - t39
    t52 = t49 - 1.0831821973886961_rk + (t39 + (t49 + t50*t51))
    t53 = s4*t42 + c4*t43
    t54 = t45 - t53
    t55 = t54 - m4_4
    t56 = t52 - (t54 - 1.0937644822584085_rk + t55)
    ! link 3: mass matrix, its row of this joint
    m3_3 = t40 + t56
    t57 = t30 + 0.0023287353274349695_rk
    t58 = k4_xz - (t57 - 0.00220682290648424_rk)
    t59 = 2.0_rk*(s3*t58) + c3*(t56 - t40)
    t60 = c3*t59 + 0.04525603145981006_rk - neg_k5_yy
    t61 = t52 + t60
    t62 = t53 + 0.06161578168943999_rk
    t63 = t44 + (t48 - 0.005487648106562261_rk) - (t46*t51 + t50*(2.0_rk*t48))
    t64 = neg_k4_yz + 0.004377257121839638_rk
    t65 = s2*(3.83030303030303_rk*(c3*t62 - s3*t57) - (c3*t63 + s3*t64))
    t66 = c2*(0.003983358883935522_rk*s2 - t65)
    ! link 1: mass matrix, its row of this joint
    m1_1 = c2*(c2*t61) + 0.03733744848940618_rk - (t66 + (t66 - m3_3)) - t61
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t63 - c3*t64 - 3.83030303030303_rk*(s3*t62 + c3*t57)
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_yz = s2*(s3*t59 - (t58 + 0.010261101821008168_rk)) - c2*(0.0007689361029464017_rk - &
        m2_3)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = t65 + c2*m3_3
    ! link 3: mass matrix, its row of this joint
    m3_5 = t37 - c4*t38 - s4*t47
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = s4*t38 - c4*t47
    t67 = s5*t33
    t68 = c5*k6_xz + s5*t35
    t69 = neg_k6_yz - t67
    ! link 3: mass matrix, its row of this joint
    m3_6 = t67 - s4*t68 + c4*t69
    ! link 4: mass matrix, its row of this joint
    m4_6 = s5*k6_xz - t27 - c5*t35
    t70 = c5*t33
    t71 = c4*t27 + (m4_6 + s4*t70)
    t72 = c4*t68 + s4*t69
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = s3*t71 - c3*t72
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = s6*t15 + c6*neg_k7_xz
    nu6_y = s6*neg_k7_xz - c6*t15
    t73 = c6*t6
    t74 = c5*t25 - s5*t73
    t75 = nu6_y - t74
    t76 = s5*k7_yz + (4.654545454545454_rk*t74 - c5*nu6_x)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = c4*t75 - s4*t76
    ! link 3: mass matrix, its row of this joint
    m3_7 = t74 + nu4_y
    t77 = s6*t6
    t78 = s5*t25 + c5*t73
    ! link 4: mass matrix, its row of this joint
    m4_7 = t77 - c5*k7_yz + 4.654545454545454_rk*t78 - s5*nu6_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t60 - t52
    m2_4 = c3*t55 - s3*k4_xz
    t79 = m4_5 - s4*t30
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s3*nu4_x - c3*t79
    t80 = c4*t30
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y - 3.83030303030303_rk*(c3*t80 + s3*t37)
    t81 = s4*t27 - c4*t70
    m2_6 = -s3*t72 - c3*t71 - 3.83030303030303_rk*(c3*t81 + s3*t67)
    t82 = s4*t78 - (m4_7 - c4*t77)
    t83 = c4*t76 + s4*t75
    t84 = c4*t78 - s4*t77
    m2_7 = c3*t82 - (s3*t83 + 3.83030303030303_rk*(c3*t84 + s3*t74))
    t85 = c2*neg_k4_yz + s2*(c3*k4_xz + s3*t55)
    t86 = c2*m3_5 + s2*(3.83030303030303_rk*(c3*t37 - s3*t80) - c3*nu4_x - s3*t79)
    t87 = c2*m3_6 - s2*(nu3_x + 3.83030303030303_rk*(s3*t81 - c3*t67))
    t88 = c2*m3_7 + s2*(s3*t82 + (c3*t83 + 3.83030303030303_rk*(c3*t74 - s3*t84)))
    t89 = -k7_yz
    M(1) = m1_1
    M(2) = neg_k2_yz
    M(3) = nu2_y
    M(4) = t85
    M(5) = t86
    M(6) = t87
    M(7) = t88
    M(8) = neg_k2_yz
    M(9) = m2_2
    M(10) = m2_3
    M(11) = m2_4
    M(12) = m2_5
    M(13) = m2_6
    M(14) = m2_7
    M(15) = nu2_y
    M(16) = m2_3
    M(17) = m3_3
    M(18) = neg_k4_yz
    M(19) = m3_5
    M(20) = m3_6
    M(21) = m3_7
    M(22) = t85
    M(23) = m2_4
    M(24) = neg_k4_yz
    M(25) = m4_4
    M(26) = m4_5
    M(27) = m4_6
    M(28) = m4_7
    M(29) = t86
    M(30) = m2_5
    M(31) = m3_5
    M(32) = m4_5
    M(33) = m5_5
    M(34) = neg_k6_yz
    M(35) = nu6_y
    M(36) = t87
    M(37) = m2_6
    M(38) = m3_6
    M(39) = m4_6
    M(40) = neg_k6_yz
    M(41) = m6_6
    M(42) = t89
    M(43) = t88
    M(44) = m2_7
    M(45) = m3_7
    M(46) = m4_7
    M(47) = nu6_y
    M(48) = t89
    M(49) = 0.006684151967360947_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 553 multiplications, 511 additions, 6 divisions = 1070; 1 unary minus; 12 sine/cosine
  pure subroutine panda_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="panda_forward_dynamics_f")
    real(rk), intent(in) :: q(7)
    real(rk), intent(in) :: qd(7)
    real(rk), intent(in) :: tau(7)
    real(rk), intent(out) :: qdd(7)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_yz, c3, s3, neg_w3_x, w3_z, w3_y, ww3_yy
    real(rk) :: ww3_zz, neg_ww3_zx, neg_ww3_xy, ww3_yz, neg_lam3_11, c4, s4, neg_w4_x, neg_w4_z
    real(rk) :: neg_w4_y, ww4_zz, ww4_zx, ww4_xy, ww4_xx, ww4_yz, c5, s5, w5_x, w5_z, neg_w5_y
    real(rk) :: neg_ww5_yz, ww5_zx, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam4_22, neg_lam5_22, c6, s6
    real(rk) :: w6_x, w6_z, w6_y, ww6_zz, ww6_xy, ww6_yy, w7_z, c7, s7, ww2_zz, alpha3_y
    real(rk) :: neg_lam3_13, lam4_21, alpha3_x, neg_ww2_zx, alpha4_y, neg_lam5_21, neg_alpha4_x
    real(rk) :: neg_alpha5_x, neg_lam5_32, neg_lam3_31, t1, ww2_xx, neg_lam2_22, t2, lam3_22, t3
    real(rk) :: neg_lam4_11, lam4_31, lam3_23, neg_lam3_21, alpha5_y, lam5_13, lam6_21, t4, t5
    real(rk) :: lam6_31, ww7_zz, neg_lam5_23, t6, lam6_32, lam6_12, lam5_31, t7, lam5_11, t8
    real(rk) :: neg_lam6_22, t9, t10, t11, t12, neg_lam6_11, neg_lam6_13, t13, t14, t15, t16, t17
    real(rk) :: t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, t31, t32, t33, t34
    real(rk) :: t35, t36, t37, t38, t39, t40, t41, t42, nc7_z, lam6_23, neg_lam5_12, t43, t44, t45
    real(rk) :: t46, t47, t48, t49, neg_n6_z, lam4_32, t50, t51, t52, t53, t54, t55, t56, t57, t58
    real(rk) :: t59, t60, t61, t62, t63, t64, t65, n4_x, lam4_23, lam4_13, lam4_12, t66, n5_z, t67
    real(rk) :: t68, t69, t70, t71, t72, t73, n3_z, lam3_12, t74, t75, n4_z, lam3_32, t76, t77, t78
    real(rk) :: t79, t80, t81, t82, n1_z, n2_z, t83, t84, t85, t86, k7_yz, t87, t88, t89, t90, t91
    real(rk) :: t92, neg_k6_yz, neg_k7_xz, t93, t94, t95, t96, t97, t98, t99, t100, t101, k5_xz
    real(rk) :: k6_xz, t102, t103, t104, t105, t106, neg_k5_yy, neg_m5_5, m6_6, neg_k5_yz, t107
    real(rk) :: t108, t109, t110, t111, t112, t113, m4_5, t114, t115, k4_xz, t116, t117, t118, t119
    real(rk) :: t120, t121, t122, m4_4, neg_k4_yz, t123, t124, t125, t126, t127, t128, t129, t130
    real(rk) :: t131, t132, t133, t134, t135, t136, t137, t138, neg_m3_3, t139, t140, t141, t142
    real(rk) :: t143, t144, t145, t146, t147, t148, m1_1, m2_3, neg_k2_yz, nu2_y, neg_m3_5, nu4_x
    real(rk) :: t149, t150, t151, m3_6, neg_m4_6, t152, t153, t154, nu3_x, nu6_x, nu6_y, t155, t156
    real(rk) :: t157, t158, nu4_y, m3_7, t159, t160, m4_7, neg_m2_2, m2_4, t161, nu3_y, t162, m2_5
    real(rk) :: t163, neg_m2_6, t164, t165, t166, m2_7, ud1_7, neg_y7, neg_u6_7, u5_7, u4_7, u3_7
    real(rk) :: u2_7, u1_7, neg_pivot6, neg_ipivot6, ud5_6, neg_u5_6, neg_ud4_6, u4_6, ud3_6
    real(rk) :: neg_u3_6, neg_ud2_6, u2_6, ud1_6, neg_u1_6, neg_pivot5, neg_ipivot5, ud4_5
    real(rk) :: neg_u4_5, neg_ud3_5, u3_5, ud2_5, neg_u2_5, t167, neg_ud1_5, u1_5, neg_pivot4
    real(rk) :: neg_ipivot4, ud3_4, neg_u3_4, ud2_4, neg_u2_4, t168, ud1_4, neg_u1_4, neg_pivot3
    real(rk) :: neg_ipivot3, ud2_3, neg_u2_3, ud1_3, neg_u1_3, neg_pivot2, neg_ipivot2, ud1_2
    real(rk) :: neg_u1_2, t169, neg_pivot1, neg_ipivot1, y6, neg_y5, neg_y4, neg_y3, neg_y2, t170
    real(rk) :: neg_y1, qdd1, qdd2, qdd3, qdd4, qdd5, qdd6, t171, qdd7

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = neg_w2_y*qd(2)
    ! sines and cosines of the joint angles
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 3: angular velocity [rad/s]
    neg_w3_x = neg_w2_x*c3 - qd(2)*s3
    w3_z = neg_w2_y + qd(3)
    w3_y = qd(2)*c3 + neg_w2_x*s3
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    neg_ww3_zx = neg_w3_x*w3_z
    neg_ww3_xy = neg_w3_x*w3_y
    ww3_yz = w3_z*w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = w3_z*s4 - neg_w3_x*c4
    neg_w4_z = w3_y - qd(4)
    neg_w4_y = neg_w3_x*s4 + w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = neg_w4_z*neg_w4_z
    ww4_zx = neg_w4_x*neg_w4_z
    ww4_xy = neg_w4_x*neg_w4_y
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_yz = neg_w4_z*neg_w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = neg_w4_x*c5 + neg_w4_z*s5
    w5_z = neg_w4_y + qd(5)
    neg_w5_y = neg_w4_x*s5 - neg_w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_yz = w5_z*neg_w5_y
    ww5_zx = w5_x*w5_z
    neg_ww5_xy = w5_x*neg_w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww4_zz + ww4_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 + w5_z*s6
    w6_z = neg_w5_y + qd(6)
    w6_y = w5_z*c6 - w5_x*s6
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ww6_xy = w6_x*w6_y
    ww6_yy = w6_y*w6_y
    ! link 7: angular velocity [rad/s]
    w7_z = qd(7) - w6_y
    ! sines and cosines of the joint angles
    c7 = cos(q(7))
    s7 = sin(q(7))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww2_yz*s3 + neg_w3_x*qd(3)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_13 = neg_ww3_zx - alpha3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = ww4_xy - alpha3_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = qd(3)*w3_y - neg_ww2_yz*c3
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = s4*alpha3_x + (neg_w4_x*qd(4) + c4*neg_ww2_zx)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_21 = neg_ww5_xy + alpha4_y
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = qd(4)*neg_w4_y + (c4*alpha3_x - s4*neg_ww2_zx)
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = qd(5)*neg_w5_y - s5*alpha3_y - c5*neg_alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = neg_ww5_yz + neg_alpha5_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    t1 = s2*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = qd(1)*t1
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    t2 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t2 - neg_lam2_22
    t3 = ww4_zz - ww4_xx
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_11 = t3 - lam3_22
    lam4_31 = ww4_zx - alpha4_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_23 = ww3_yz - alpha3_x
    neg_lam3_21 = neg_ww3_xy + neg_ww2_zx
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = c5*alpha3_y - (w5_x*qd(5) + s5*neg_alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx + alpha5_y
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_21 = ww6_xy - alpha5_y
    t4 = qd(6) + w6_z
    t5 = c6*alpha4_y - s6*neg_alpha5_x
    lam6_31 = w6_x*t4 + t5
    ! link 7: products of the angular velocity [1/s^2]
    ww7_zz = w7_z*w7_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_23 = neg_ww5_yz - neg_alpha5_x
    t6 = s6*alpha4_y + c6*neg_alpha5_x
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_32 = w6_y*t4 - t6
    lam6_12 = ww6_xy + alpha5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    t7 = ww5_xx - ww5_zz
    lam5_11 = t7 - neg_lam4_22
    t8 = ww6_zz - ww6_yy
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam6_22 = neg_lam5_22 + t8
    t9 = ww6_zz - ww7_zz
    t10 = ww6_zz + ww7_zz
    t11 = neg_lam6_22 - t10
    t12 = t9 - t11
    neg_lam6_11 = neg_lam5_22 + t12
    neg_lam6_13 = t5 - neg_w5_y*w6_x
    t13 = 0.0002123224431354016_rk*s7
    t14 = t13 + 0.00016784129658960374_rk*c7
    t15 = neg_lam3_31 - 118.9090909090909_rk*c2 + 3.83030303030303_rk*neg_lam2_22
    t16 = 118.9090909090909_rk*s2
    t17 = c3*t16
    t18 = neg_lam3_11 + t17 + 3.83030303030303_rk*neg_lam3_13
    t19 = s4*t15 + c4*t18
    t20 = neg_lam4_11 - t19
    t21 = 3.83030303030303_rk*lam3_23 - (neg_lam3_21 - s3*t16)
    t22 = lam4_31 - t21
    t23 = c5*t20 - s5*t22
    t24 = t23 + 4.654545454545454_rk*lam5_13
    t25 = s4*t18 - c4*t15
    t26 = lam4_21 - t25
    t27 = 4.654545454545454_rk*neg_lam4_22 + t26
    t28 = c6*t24 - s6*t27
    t29 = 1.0666666666666667_rk*neg_lam6_11 - t28
    t30 = 11.402203849817942_rk*c7
    t31 = t13*t30
    t32 = 0.0002123224431354016_rk*c7
    t33 = t30*t32
    t34 = 0.32333777029991095_rk*t31 - (t33 + 0.00213160409441986_rk)
    t35 = 0.0009653051699191118_rk*s7 + 0.0012555365982729084_rk*c7
    t36 = t31 + (0.32333777029991095_rk*t33 - 0.0003913912816842475_rk)
    t37 = t34 + 0.006684151967360947_rk
    t38 = s5*t20 + c5*t22
    t39 = t38 + (4.654545454545454_rk*neg_lam5_23 + 1.0666666666666667_rk*lam6_31)
    t40 = t32 - 0.00016784129658960374_rk*s7
    t41 = t14*t29 - (neg_lam6_13*t34 - (lam6_12*t35 - (t12*t36 - lam6_31*t37))) + t39*t40
    t42 = 0.0009653051699191118_rk*c7 - 0.0012555365982729084_rk*s7
    ! link 7: moment that turns the link [N m]
    nc7_z = t41 - lam6_32*t42
    ! link 6: lambda matrix: takes a position to its acceleration [1/s^2]
    lam6_23 = t6 + neg_w5_y*w6_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww5_xy - alpha4_y
    t43 = -2.0_rk*w7_z
    t44 = lam6_12 - w6_x*t43
    t45 = s6*t24 + c6*t27
    t46 = t45 - 1.0666666666666667_rk*lam6_21
    t47 = lam6_32 - w6_z*t43
    t48 = t14*t47 - (0.014338888209442497_rk*neg_lam6_22 - 0.017931959153753906_rk*t46 - t40*t44)
    t49 = 0.0001037589172186853_rk*lam6_23 + (t11*t42 - (t40*t46 - (t36*t47 - &
        (1.0666666666666667_rk*t48 + 0.014338888209442497_rk*t29))))
    ! link 6: moment through the joint, about the frame's origin [N m]
    neg_n6_z = t37*t44 + (0.0005462437073966822_rk*(neg_lam6_22 - neg_lam6_11) + &
        (0.028934422545659907_rk*lam6_12 - (0.0011196707334275547_rk*lam6_21 + t49))) + &
        neg_lam6_13*(t35 + 9.35690973146064e-05_rk)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz - neg_alpha4_x
    t50 = 0.028934422545659907_rk*lam6_32 - (0.014338888209442497_rk*t39 + (t9*t35 + &
        (9.35690973146064e-05_rk*t8 + (0.0055993270925625_rk*t45 + &
        0.0001037589172186853_rk*lam6_21))))
    t51 = t34*t47 + (t36*t44 - (t14*t46 + t50)) + lam6_31*(t42 - 0.0005462437073966822_rk)
    t52 = neg_lam5_22 + lam5_11
    t53 = 0.017931959153753906_rk*t39 + (lam6_31*t40 - (0.014338888209442497_rk*lam6_32 + t14*(t10 &
        - t12)))
    t54 = 0.0055993270925625_rk*neg_lam5_22 + t53
    t55 = nc7_z + 0.0005462437073966822_rk*lam6_32 + (9.35690973146064e-05_rk*lam6_12 + &
        0.0001037589172186853_rk*t12 + 1.0666666666666667_rk*(t53 + 0.005249369149277343_rk*t28))
    t56 = t55 + 0.0011196707334275547_rk*lam6_31
    t57 = 0.010045187828321245_rk*neg_lam5_32 + c6*t51 - 0.00151524447332703_rk*lam5_31 - &
        0.0021640520520981327_rk*(t7 - t52) - (4.654545454545454_rk*t54 + s6*t56)
    t58 = 0.0010267877770288932_rk*neg_lam5_21 + t57
    t59 = 0.017931959153753906_rk*t29 + (0.014338888209442497_rk*lam6_12 + t10*t40) + &
        neg_lam6_13*(t14 - 0.0055993270925625_rk)
    t60 = t48 + 0.0055993270925625_rk*lam6_23
    t61 = c6*t59 - s6*t60
    t62 = 0.0010267877770288932_rk*t7 + (0.001208932934385_rk*t26 + 4.654545454545454_rk*t61 - &
        (0.00151524447332703_rk*neg_lam5_32 + (neg_n6_z + 0.0021640520520981327_rk*neg_lam5_12)))
    t63 = 0.001451156065026714_rk*lam5_31 + t62
    t64 = neg_lam4_22 + lam3_22
    t65 = 0.0039053550262761055_rk*lam4_21 - c5*t58 + 0.07937575371526083_rk*lam4_31 + (s5*t63 - &
        (0.08256807420204747_rk*t21 - 0.00164448757736928_rk*t64))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.30879988491513166_rk*lam4_32 - t65
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz + neg_alpha4_x
    lam4_13 = ww4_zx + alpha4_y
    lam4_12 = ww4_xy + alpha3_y
    t66 = 0.0010267877770288932_rk*neg_lam5_23 + 0.0021640520520981327_rk*lam5_13 - (c6*t56 + &
        s6*t51) - (0.001451156065026714_rk*neg_lam5_21 - 0.010045187828321245_rk*neg_lam5_12)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t66 - (0.00151524447332703_rk*t52 - 0.001208932934385_rk*t38)
    t67 = n4_x - 0.022178148964878252_rk*lam4_23
    t68 = t61 - (0.02767241350487109_rk*t23 - 0.001208932934385_rk*lam5_11)
    t69 = t54 - (0.001208932934385_rk*neg_lam5_21 - 0.02767241350487109_rk*t38)
    t70 = s5*t68 + c5*t69
    t71 = n5_z - (0.02759391246306875_rk*lam4_13 - 0.00164448757736928_rk*lam4_12 - t70) + &
        (0.010831526996380998_rk*ww4_zx + (0.0039053550262761055_rk*t3 - &
        0.07937575371526083_rk*lam4_32))
    t72 = t70 - (0.08256807420204747_rk*lam4_32 + 0.016011409030815008_rk*t21)
    t73 = c4*t71 + 0.0001219124209507298_rk*(neg_lam3_11 + lam3_22) + &
        (0.005487648106562251_rk*lam3_23 + (0.002328735327434986_rk*t17 + &
        1.3360662912304e-05_rk*neg_lam3_21 - t72))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.013297019103287523_rk*neg_lam3_13 - (s4*t67 - t73)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = neg_ww2_zx - neg_ww3_xy
    t74 = 0.001208932934385_rk*lam5_31 + (s6*t59 + 0.02767241350487109_rk*t26 + c6*t60)
    t75 = 0.0039053550262761055_rk*lam4_23 + c5*t63 - (0.30879988491513166_rk*lam4_12 - &
        (0.00164448757736928_rk*lam4_13 - 0.07937575371526083_rk*(t3 - t64) + &
        0.005415763498190499_rk*lam4_21))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t74 + (s5*t58 + 0.08256807420204747_rk*t19) + t75
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = ww3_yz + alpha3_x
    t76 = t1 - (qd(1) - t1)
    t77 = 3.83030303030303_rk*t72 - (s4*t71 + c4*t67) - (0.10510540975539216_rk*lam3_23 - &
        (0.27690780075317833_rk*c2 - (0.013297019103287523_rk*t2 - &
        0.005487648106562251_rk*neg_lam3_21 + 0.0001219124209507298_rk*neg_lam3_31)))
    t78 = 0.016011409030815008_rk*t19 - 0.08256807420204747_rk*lam4_12 + (c5*t68 - s5*t69)
    t79 = 0.08256807420204747_rk*neg_lam4_22 + (t74 - 0.016011409030815008_rk*t25)
    t80 = s4*t78 + c4*t79 - 3.83030303030303_rk*(c4*t78 - s4*t79) + &
        0.013297019103287523_rk*lam3_12
    t81 = t80 - (n4_z + (0.005487648106562251_rk*(0.0024346792383292625_rk*neg_lam3_31 + &
        (neg_lam3_11 - neg_lam2_22)) + (0.0001219124209507298_rk*lam3_32 + &
        0.10510540975539216_rk*neg_lam3_13)))
    t82 = ww2_zz*(0.010261101821008168_rk*c2 - 0.0007689361029464017_rk*s2) - c2*n3_z + s2*(c3*t77 &
        - s3*t81)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.007966717767871044_rk*qd(2)*t76 - t82
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = c3*t81 - (t76*(0.003983358883935522_rk*qd(1)) - s3*t77 + (4.746153896127808_rk*s2 - &
        0.01993386669246_rk*c2))
    t83 = s7 - 1.2650190832031087_rk*c7
    t84 = 0.0009435868580996108_rk*t83
    t85 = 0.002420943778521227_rk*c7
    t86 = t84 + t85
    ! link 7: second moment of the composite body [kg m^2]
    k7_yz = 1.0230167595416089_rk*t86
    t87 = 9.35690973146064e-05_rk + k7_yz
    t88 = t84 + 0.0006089563838965577_rk*s7
    t89 = t85 + t88
    t90 = c7*t85
    t91 = s7*t85
    t92 = 0.1458750175528577_rk*t89 - (0.32333777029991095_rk*t90 - 0.0004951501989029328_rk + &
        t91)
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = c6*t87 - s6*t92
    ! link 7: second moment of the composite body [kg m^2]
    neg_k7_xz = 0.8086967012001633_rk*t88
    t93 = neg_k6_yz - 0.0021640520520981327_rk
    t94 = c6*c6
    t95 = neg_k7_xz + (neg_k7_xz - 0.029497140765350628_rk)
    t96 = c6*s6
    t97 = 0.000179030716362244_rk*t83
    t98 = 0.32333777029991095_rk*t91 - (t90 + 0.009543771269492213_rk)
    t99 = 0.006684151967360947_rk - t97
    t100 = t97 - t98 - t99
    t101 = (t94 - 0.5_rk)*t95 - (t96*t100 - 0.004600245517563107_rk)
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = s5*t93 - c5*t101
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = c6*t92 + s6*t87
    t102 = c5*s5
    t103 = k6_xz + (k6_xz - 0.00303048894665406_rk)
    t104 = t95*t96 + 0.6173375163284962_rk + t94*t100
    t105 = c5*c5
    t106 = t98 - t104 + 0.645090074285934_rk
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yy = t102*t103 + (t104 - 0.6477230949391829_rk + t105*t106)
    ! link 5: mass matrix, its row of this joint
    neg_m5_5 = t98 + t104 - 0.6503561155924318_rk
    ! link 6: mass matrix, its row of this joint
    m6_6 = 0.057868845091319815_rk - t100
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = c5*t93 + s5*t101
    t107 = 0.00016784129658960374_rk*t83
    t108 = t107 - 0.0191274230973375_rk
    t109 = 0.014338888209442497_rk*s6 - c6*t108
    t110 = t109 - 0.001208932934385_rk
    t111 = 0.1367578289558041_rk*t89
    t112 = 0.0055993270925625_rk - t111
    t113 = s5*t110 + c5*t112
    ! link 4: mass matrix, its row of this joint
    m4_5 = neg_k5_yz + 4.654545454545454_rk*t113
    t114 = m4_5 - 0.00164448757736928_rk
    t115 = t102*t106 - (t113 - (t103*(0.5_rk - t105) + 0.0039053550262761055_rk))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = s4*t114 - c4*t115
    t116 = s5*t112 - c5*t110
    t117 = neg_m5_5 - t116
    t118 = t116 + (neg_k5_yy - t117)
    t119 = 0.014338888209442497_rk*c6 + s6*t108
    t120 = 4.654545454545454_rk*t119
    t121 = t120 - m6_6
    t122 = t120 - (t104 - t121)
    ! link 4: mass matrix, its row of this joint
    m4_4 = t118 - (t122 - 0.10204027231363098_rk)
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_yz = s4*t115 + c4*t114
    t123 = neg_k5_yy - 0.022178148964878252_rk
    t124 = t119 - 0.16603319317224746_rk
    t125 = t116 + 0.04560437265862499_rk
    t126 = c4*t124 + s4*t125
    t127 = 3.83030303030303_rk*t126
    t128 = c4*s4
    t129 = k5_xz + 4.654545454545454_rk*t116
    t130 = t119 - 0.16284087268546082_rk - t129
    t131 = t127 - t128*t130
    t132 = c4*c4
    t133 = t122 + t118
    t134 = t131 - 1.0831821973886961_rk - (t118 - (t131 + t132*t133))
    t135 = s4*t124 - c4*t125
    t136 = t127 - t135
    t137 = t136 - m4_4
    t138 = t134 - (t136 - 1.0937644822584085_rk + t137)
    ! link 3: mass matrix, its row of this joint
    neg_m3_3 = t123 - t138
    t139 = k4_xz - (t113 + 0.0001219124209507298_rk)
    t140 = 2.0_rk*(s3*t139) + c3*(t123 + t138)
    t141 = neg_k5_yy - (c3*t140 + 0.04525603145981006_rk)
    t142 = t134 - t141
    t143 = t135 + 0.06161578168943999_rk
    t144 = t113 + 0.0023287353274349695_rk
    t145 = t126 + (t130 - 0.005487648106562261_rk) - (t128*t133 + t132*(2.0_rk*t130))
    t146 = neg_k4_yz + 0.004377257121839638_rk
    t147 = s2*(3.83030303030303_rk*(c3*t143 - s3*t144) - (c3*t145 + s3*t146))
    t148 = c2*(0.003983358883935522_rk*s2 - t147)
    ! link 1: mass matrix, its row of this joint
    m1_1 = c2*(c2*t142) + 0.03733744848940618_rk - (t148 + (neg_m3_3 + t148)) - t142
    ! link 2: mass matrix, its row of this joint
    m2_3 = s3*t145 - c3*t146 - 3.83030303030303_rk*(s3*t143 + c3*t144)
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_yz = s2*(s3*t140 - (t139 + 0.010261101821008168_rk)) + c2*(m2_3 - &
        0.0007689361029464017_rk)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = t147 - c2*neg_m3_3
    ! link 3: mass matrix, its row of this joint
    neg_m3_5 = t116 + c4*t117 - s4*t129
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = s4*t117 + c4*t129
    t149 = s5*t119
    t150 = c5*k6_xz + s5*t121
    t151 = neg_k6_yz - t149
    ! link 3: mass matrix, its row of this joint
    m3_6 = t149 - s4*t150 + c4*t151
    ! link 4: mass matrix, its row of this joint
    neg_m4_6 = t109 - s5*k6_xz + c5*t121
    t152 = c5*t119
    t153 = c4*t109 - (neg_m4_6 - s4*t152)
    t154 = c4*t150 + s4*t151
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_x = s3*t153 - c3*t154
    ! link 6: moment for a unit acceleration of a joint further out
    nu6_x = s6*t99 + c6*neg_k7_xz
    nu6_y = s6*neg_k7_xz - c6*t99
    t155 = c6*t111
    t156 = c5*t107 - s5*t155
    t157 = nu6_y - t156
    t158 = s5*k7_yz + (4.654545454545454_rk*t156 - c5*nu6_x)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = c4*t157 - s4*t158
    ! link 3: mass matrix, its row of this joint
    m3_7 = t156 + nu4_y
    t159 = s6*t111
    t160 = s5*t107 + c5*t155
    ! link 4: mass matrix, its row of this joint
    m4_7 = t159 - c5*k7_yz + 4.654545454545454_rk*t160 - s5*nu6_x
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t134 + t141
    m2_4 = c3*t137 - s3*k4_xz
    t161 = m4_5 - s4*t113
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s3*nu4_x - c3*t161
    t162 = c4*t113
    ! link 2: mass matrix, its row of this joint
    m2_5 = nu3_y - 3.83030303030303_rk*(c3*t162 - s3*t116)
    t163 = s4*t109 - c4*t152
    neg_m2_6 = s3*t154 + c3*t153 + 3.83030303030303_rk*(c3*t163 + s3*t149)
    t164 = s4*t160 - (m4_7 - c4*t159)
    t165 = c4*t158 + s4*t157
    t166 = c4*t160 - s4*t159
    m2_7 = c3*t164 - (s3*t165 + 3.83030303030303_rk*(c3*t166 + s3*t156))
    ! factorisation M = U D U^T
    ud1_7 = c2*m3_7 + s2*(s3*t164 + (c3*t165 + 3.83030303030303_rk*(c3*t156 - s3*t166)))
    ! link 7: forward substitution
    neg_y7 = nc7_z - tau(7)
    ! factorisation M = U D U^T
    neg_u6_7 = 153.05109227573695_rk*t86
    u5_7 = 149.60760989322964_rk*nu6_y
    u4_7 = 149.60760989322964_rk*m4_7
    u3_7 = 149.60760989322964_rk*m3_7
    u2_7 = 149.60760989322964_rk*m2_7
    u1_7 = 149.60760989322964_rk*ud1_7
    neg_pivot6 = k7_yz*neg_u6_7 - m6_6
    neg_ipivot6 = 1.0_rk / neg_pivot6
    ud5_6 = neg_k6_yz + k7_yz*u5_7
    neg_u5_6 = neg_ipivot6*ud5_6
    neg_ud4_6 = neg_m4_6 - k7_yz*u4_7
    u4_6 = neg_ipivot6*neg_ud4_6
    ud3_6 = m3_6 + k7_yz*u3_7
    neg_u3_6 = neg_ipivot6*ud3_6
    neg_ud2_6 = neg_m2_6 - k7_yz*u2_7
    u2_6 = neg_ipivot6*neg_ud2_6
    ud1_6 = c2*m3_6 - s2*(nu3_x + 3.83030303030303_rk*(s3*t163 - c3*t149)) + k7_yz*u1_7
    neg_u1_6 = neg_ipivot6*ud1_6
    neg_pivot5 = neg_m5_5 + nu6_y*u5_7 - ud5_6*neg_u5_6
    neg_ipivot5 = 1.0_rk / neg_pivot5
    ud4_5 = m4_5 - nu6_y*u4_7 - ud5_6*u4_6
    neg_u4_5 = neg_ipivot5*ud4_5
    neg_ud3_5 = neg_m3_5 + nu6_y*u3_7 - ud5_6*neg_u3_6
    u3_5 = neg_ipivot5*neg_ud3_5
    ud2_5 = m2_5 - nu6_y*u2_7 - ud5_6*u2_6
    neg_u2_5 = neg_ipivot5*ud2_5
    t167 = c2*neg_m3_5 + s2*(3.83030303030303_rk*(c3*t116 + s3*t162) + c3*nu4_x + s3*t161)
    neg_ud1_5 = t167 + nu6_y*u1_7 - ud5_6*neg_u1_6
    u1_5 = neg_ipivot5*neg_ud1_5
    neg_pivot4 = m4_7*u4_7 - m4_4 - neg_ud4_6*u4_6 - ud4_5*neg_u4_5
    neg_ipivot4 = 1.0_rk / neg_pivot4
    ud3_4 = neg_k4_yz - m4_7*u3_7 - neg_ud4_6*neg_u3_6 - ud4_5*u3_5
    neg_u3_4 = neg_ipivot4*ud3_4
    ud2_4 = m2_4 - m4_7*u2_7 + neg_ud4_6*u2_6 + ud4_5*neg_u2_5
    neg_u2_4 = neg_ipivot4*ud2_4
    t168 = c2*neg_k4_yz + s2*(c3*k4_xz + s3*t137) - m4_7*u1_7 - neg_ud4_6*neg_u1_6
    ud1_4 = t168 - ud4_5*u1_5
    neg_u1_4 = neg_ipivot4*ud1_4
    neg_pivot3 = neg_m3_3 + m3_7*u3_7 - ud3_6*neg_u3_6 - neg_ud3_5*u3_5 - ud3_4*neg_u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    ud2_3 = m2_3 - m3_7*u2_7 - ud3_6*u2_6 - neg_ud3_5*neg_u2_5 + ud3_4*neg_u2_4
    neg_u2_3 = neg_ipivot3*ud2_3
    ud1_3 = nu2_y - m3_7*u1_7 + ud3_6*neg_u1_6 + neg_ud3_5*u1_5 + ud3_4*neg_u1_4
    neg_u1_3 = neg_ipivot3*ud1_3
    neg_pivot2 = neg_m2_2 + m2_7*u2_7 - neg_ud2_6*u2_6 - ud2_5*neg_u2_5 - ud2_4*neg_u2_4 - &
        ud2_3*neg_u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ud1_2 = neg_k2_yz - m2_7*u1_7 - neg_ud2_6*neg_u1_6 - ud2_5*u1_5 + ud2_4*neg_u1_4 + &
        ud2_3*neg_u1_3
    neg_u1_2 = neg_ipivot2*ud1_2
    t169 = ud1_7*u1_7 - m1_1 - ud1_6*neg_u1_6 - neg_ud1_5*u1_5 - ud1_4*neg_u1_4 - ud1_3*neg_u1_3
    neg_pivot1 = t169 - ud1_2*neg_u1_2
    neg_ipivot1 = 1.0_rk / neg_pivot1
    ! link 6: forward substitution
    y6 = neg_n6_z + tau(6) - neg_y7*neg_u6_7
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5) - neg_y7*u5_7 - neg_u5_6*y6
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) - neg_y7*u4_7 + u4_6*y6 + neg_u4_5*neg_y5
    ! link 3: forward substitution
    neg_y3 = n3_z - tau(3) - neg_y7*u3_7 - neg_u3_6*y6 - u3_5*neg_y5 + neg_u3_4*neg_y4
    ! link 2: forward substitution
    neg_y2 = n2_z - tau(2) - neg_y7*u2_7 + u2_6*y6 + neg_u2_5*neg_y5 + neg_u2_4*neg_y4 + &
        neg_u2_3*neg_y3
    t170 = n1_z - tau(1) - neg_y7*u1_7 - neg_u1_6*y6 - u1_5*neg_y5 + neg_u1_4*neg_y4 + &
        neg_u1_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = t170 + neg_u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = neg_ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_ipivot2*neg_y2 + neg_u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 + neg_u2_3*qdd2 + neg_u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = neg_ipivot4*neg_y4 + neg_u3_4*qdd3 + neg_u2_4*qdd2 + neg_u1_4*qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = neg_ipivot5*neg_y5 + neg_u4_5*qdd4 - u3_5*qdd3 + neg_u2_5*qdd2 - u1_5*qdd1
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = neg_u1_6*qdd1 - (neg_ipivot6*y6 - neg_u5_6*qdd5 + u4_6*qdd4 - neg_u3_6*qdd3 + &
        u2_6*qdd2)
    t171 = 149.60760989322964_rk*neg_y7 - neg_u6_7*qdd6 + u5_7*qdd5 + u4_7*qdd4 + u3_7*qdd3 + &
        u2_7*qdd2
    ! link 7: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd7 = -u1_7*qdd1 - t171
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
    qdd(7) = qdd7
  end subroutine
end module
