! puma560_full: PUMA 560 geometry, random full inertias
! Numbers: Table 2.1 geometry; masses, centres and inertias drawn at random: a test of generic
!   parameters
! Origin of numbers: geometry: stated by the description
! Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 4ba5f6ba4580930ac3ece4f91e671e11 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0        d 0        theta q
!   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
!   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
!   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
!   5  revolute  alpha -pi/2  a 0        d 0        theta q
!   6  revolute  alpha pi/2   a 0        d 0        theta q
! Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
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
!   written like it: robodyn --optimize full, seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 218 multiplications, 209 additions = 427; 0 unary minus; 10 sine/cosine
!   gravity: 24 multiplications, 18 additions = 42; 1 unary minus; 10 sine/cosine
!   bias: 198 multiplications, 181 additions = 379; 0 unary minus; 10 sine/cosine
!   mass_matrix: 116 multiplications, 110 additions = 226; 0 unary minus; 10 sine/cosine
!   forward_dynamics: 400 multiplications, 359 additions, 5 divisions = 764; 4 unary minus; 10
!       sine/cosine
module puma560_full_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_full_inverse_dynamics
  public :: puma560_full_gravity
  public :: puma560_full_bias
  public :: puma560_full_mass_matrix
  public :: puma560_full_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 218 multiplications, 209 additions = 427; 0 unary minus; 10 sine/cosine
  pure subroutine puma560_full_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_full_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: ww1_zz, w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, alpha3_z, lam3_23, neg_ww3_yz
    real(rk) :: neg_alpha3_x, neg_lam3_13, neg_ww3_zx, alpha3_y, ww3_yy, ww3_zz, ww3_xy
    real(rk) :: neg_lam3_11, neg_lam3_12, neg_lam3_31, neg_lam3_32, lam3_21, c4, s4, neg_w4_x, w4_z
    real(rk) :: w4_y, alpha4_z, neg_ww4_xy, ww4_zz, ww4_yy, ww4_yz, neg_ww4_zx, lam4_21
    real(rk) :: neg_lam4_11, neg_lam4_12, c5, s5, neg_w5_x, w5_z, w5_y, neg_ww5_zx, ww5_xx, ww5_zz
    real(rk) :: ww5_yz, neg_ww5_xy, w6_z, c6, s6, c2, s2, alpha4_x, lam4_23, neg_lam5_13, alpha4_y
    real(rk) :: alpha5_z, neg_lam5_12, neg_alpha5_x, lam5_32, ww6_zz, ww2_zz, t1, t2, t3, lam3_22
    real(rk) :: t4, alpha6_z, t5, neg_lam5_31, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16
    real(rk) :: t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, t30, t31, t32, t33
    real(rk) :: t34, nc6_z, lam4_13, neg_lam5_21, neg_lam5_22, t35, lam4_22, lam5_23, t36, t37, t38
    real(rk) :: t39, t40, t41, t42, t43, t44, t45, t46, t47, t48, n4_z, t49, lam5_11, t50, t51, t52
    real(rk) :: t53, t54, t55, neg_n3_y, neg_lam4_31, neg_n4_x, t56, n5_z, lam4_32, neg_n4_y, t57
    real(rk) :: neg_n3_x, t58, t59, t60, t61, t62, t63, t64, t65, t66, t67, t68, t69, n1_z, t70
    real(rk) :: n3_z, t71, n02_z

    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_23 = s23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = lam3_23 + neg_ww3_yz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_13 = c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww3_zx - neg_lam3_13
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_x*neg_w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_12 = alpha3_z - ww3_xy
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    lam3_21 = alpha3_z + ww3_xy
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    w4_y = neg_w3_x*s4 + w3_z*c4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = alpha4_z - neg_ww4_xy
    neg_lam4_11 = ww4_zz + ww4_yy
    neg_lam4_12 = alpha4_z + neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = neg_w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    neg_ww5_xy = neg_w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = alpha3_z*s4 - (neg_alpha3_x*c4 - qd(4)*w4_y)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz - alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_13 = w4_y*neg_w5_x + (alpha4_z*c5 + s5*alpha4_x)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_alpha3_x*s4 + (alpha3_z*c4 + neg_w4_x*qd(4))
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww5_xy + alpha5_z
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_x = alpha4_z*s5 - (qd(5)*w5_y + c5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz - neg_alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = ww3_yy - ww3_zz
    t2 = ww1_zz - neg_lam3_11
    t3 = t1 - t2
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t3 - neg_lam3_11
    t4 = neg_lam5_13 + qdd(6)
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = t4 - neg_ww5_zx
    t5 = neg_ww5_zx - alpha6_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = qdd(6) + t5
    t6 = 0.2519035474197792_rk*c6 - 0.1902613160848803_rk*s6
    t7 = 0.1902613160848803_rk*c6 + 0.2519035474197792_rk*s6
    t8 = 0.561954526137403_rk*c6
    t9 = 0.062417998297925076_rk*c6
    t10 = t8*t9 + 0.43637196239865417_rk
    t11 = 0.561954526137403_rk*s6
    t12 = t9*t11
    t13 = t10 + 22.918482381900507_rk*t12
    t14 = t13 - 0.907820001453264_rk
    t15 = 0.9969983837450935_rk*c2
    t16 = 0.9969983837450935_rk*s2
    t17 = qdd(2)*t15 - (ww2_zz*t16 + 22.627568690833527_rk)
    t18 = 0.3465712306626645_rk*qdd(1) + (t15*(ww1_zz + ww2_zz) + qdd(2)*t16)
    t19 = s23*t17 - c23*t18
    t20 = 0.04687139228815516_rk*neg_lam3_11 + (neg_lam3_12 + t19)
    t21 = qd(1)*qd(2)
    t22 = 0.07491193080123078_rk*s2
    t23 = qdd(1)*t15 - 0.3465712306626645_rk*ww1_zz - 26.617879771127544_rk*(t21*t22)
    t24 = neg_lam3_32 + (0.04687139228815516_rk*neg_lam3_31 + t23)
    t25 = s4*t20 - c4*t24
    t26 = t11 + 0.4844385865269322_rk*c6
    t27 = 0.04687139228815516_rk*lam3_21 - s23*t18 - (c23*t17 - lam3_22)
    t28 = c4*t20 + s4*t24
    t29 = s5*t27 - c5*t28
    t30 = t8 - 0.4844385865269322_rk*s6
    t31 = ww5_xx + ww6_zz
    t32 = ww5_zz + ww6_zz
    t33 = t31 - t32
    t34 = t12 - (22.918482381900507_rk*t10 - 10.402928354621762_rk)
    ! link 6: moment that turns the link [N m]
    nc6_z = neg_lam5_12*t6 - lam5_32*t7 - (t4*t14 + t5*t13 - t25*t26) + (t29*t30 - t33*t34)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_21 = neg_ww5_xy - alpha5_z
    neg_lam5_22 = ww5_xx + ww5_zz
    t35 = ww4_zz - ww4_yy
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_22 = lam3_22 - t35
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz + neg_alpha5_x
    t36 = 0.08058935149735619_rk*lam5_32
    t37 = 0.37765802516131436_rk*t29
    t38 = 0.18116108322165295_rk*neg_lam5_12 - t36 - (0.1558184212675505_rk*t33 + t37 - &
        0.1513642331069161_rk*neg_lam5_31 + 0.2064157143738513_rk*t25 + nc6_z)
    t39 = 0.2788425785236688_rk*neg_lam5_13 - t38
    t40 = neg_lam4_11 + lam3_22
    t41 = qd(6) + w6_z
    t42 = alpha5_z + neg_w5_x*t41
    t43 = s5*t28 + c5*t27
    t44 = neg_lam5_22 + lam4_22
    t45 = neg_alpha5_x - w5_z*t41
    t46 = 0.06568070130666698_rk*t25 - (t34*t42 - (t30 + 0.37765802516131436_rk)*t43) + (t5*t7 - &
        (0.18116108322165295_rk*t44 + t6*(t31 - neg_lam5_22)) + t14*t45)
    t47 = 0.08058935149735619_rk*neg_lam5_31 + (0.1558184212675505_rk*neg_lam5_21 - (t46 + &
        0.3901127773977262_rk*lam5_32) + 0.2788425785236688_rk*lam5_23)
    t48 = 0.3473260245772809_rk*lam4_21 + (c5*t39 - 0.10734691974802549_rk*lam4_13 - &
        0.05337162017689789_rk*(t35 - t40)) + s5*t47
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.2837491060266096_rk*lam4_23 + (t48 - 0.33686216557830156_rk*t25)
    t49 = t33 + t44
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t49 - neg_lam5_22
    t50 = t26*t42 - (0.06568070130666698_rk*neg_lam5_22 + (0.37765802516131436_rk*lam5_23 + &
        0.2064157143738513_rk*neg_lam5_21)) - t30*t45
    t51 = -0.2064157143738513_rk*lam5_11 - (t4*t30 - t32*t26) + &
        (0.06568070130666698_rk*neg_lam5_12 - 0.37765802516131436_rk*neg_lam5_13)
    t52 = 0.33686216557830156_rk*neg_lam4_11 + (9.668724351427649_rk*t28 - s5*t50 - c5*t51)
    t53 = t31*t30 - (9.668724351427649_rk*t25 + t5*t26 - 0.8150047132321409_rk*(t36 - &
        0.2532693504989058_rk*neg_lam5_31)) - 0.37765802516131436_rk*lam4_22
    t54 = 0.33686216557830156_rk*lam4_21 - t53
    t55 = s4*t52 - c4*t54
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = 0.060845712710754084_rk*neg_lam3_12 + n4_z - (0.4930056644597067_rk*neg_lam3_31 + &
        (0.7393454722568493_rk*neg_lam3_32 - (0.04687139228815516_rk*t55 - &
        0.01894848286257894_rk*t2)))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_x = c5*t47 - (s5*t39 - 0.05337162017689789_rk*neg_lam4_31 - &
        (0.2837491060266096_rk*lam4_21 - 0.10734691974802549_rk*t35))
    t56 = 0.1513642331069161_rk*neg_lam5_21 - t13*t42 + 0.17391580988809086_rk*(t37 + &
        0.8959416706728075_rk*lam5_23) - t43*(t26 + 0.2064157143738513_rk)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t7*(ww5_xx - ww6_zz) - t56 + (t34*t45 + 0.3901127773977262_rk*neg_lam5_12 + t4*t6) - &
        (0.18116108322165295_rk*neg_lam5_13 + 0.08058935149735619_rk*t49)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_y = 0.10734691974802549_rk*neg_lam4_12 - n5_z + 0.2837491060266096_rk*t40 - &
        0.3473260245772809_rk*neg_lam4_31 + (0.05337162017689789_rk*lam4_32 + &
        0.33686216557830156_rk*t27)
    t57 = t55 + s4*neg_n4_y - (0.7393454722568493_rk*neg_lam3_31 + 0.060845712710754084_rk*(t1 + &
        216.1081950128016_rk*neg_lam3_32) + 12.150081500837414_rk*t23)
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.01894848286257894_rk*lam3_21 + c4*neg_n4_x - t57
    t58 = 4.508184091221399_rk*s2 + 0.07491193080123078_rk*c2
    t59 = 0.2348119600832282_rk*c2
    t60 = s2*t59
    t61 = c2*t59
    t62 = 55.04847880816545_rk*t60 + (t61 - 0.1174059800416141_rk)
    t63 = t21*t62
    t64 = c4*t52 + s4*t54
    t65 = 12.150081500837414_rk*neg_lam3_12 - t64
    t66 = 0.33686216557830156_rk*neg_lam4_31 + (s5*t51 - c5*t50 + 9.668724351427649_rk*t27)
    t67 = t66 - 12.150081500837414_rk*lam3_22
    t68 = c23*t65 - s23*t67
    t69 = ww2_zz*(t22 - 4.508184091221399_rk*c2) + qdd(1)*(t60 - (55.04847880816545_rk*t61 + &
        3.9979337853179913_rk)) + (t63 - s23*neg_n3_x)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = c23*neg_n3_y + (qdd(2)*t58 - (t63 + 0.3465712306626645_rk*t68 + (t69 + t15*(t55 - &
        12.150081500837414_rk*neg_lam3_32))))
    t70 = c4*neg_n4_y - 12.150081500837414_rk*t19 - (0.01894848286257894_rk*lam3_23 + &
        (0.4930056644597067_rk*lam3_21 + 0.7393454722568493_rk*t3) - 0.04687139228815516_rk*t66)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.060845712710754084_rk*neg_lam3_13 - (t64 - (13.149257148188545_rk*neg_lam3_12 - &
        s4*neg_n4_x)) - t70
    t71 = n3_z + t15*(s23*t65 + c23*t67) + (qdd(1)*t58 - 293.22217760906653_rk*(c2 - &
        0.005370026967362786_rk*s2) - t16*t68)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = 13.340650116616965_rk*qdd(2) + ww1_zz*t62 + t71
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 24 multiplications, 18 additions = 42; 1 unary minus; 10 sine/cosine
  pure subroutine puma560_full_gravity(q, tau) &
      bind(c, name="puma560_full_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s6, c6, hw6_y, c5, c4, angle23, s23, s5, c23, hw6_x, s4, t1, t2, tau6, t3, hw5_y
    real(rk) :: hw5_x, tau5, t4, t5, tau4, c2, s2, hw4_x, neg_hw3_x, neg_hw2_x

    ! sines and cosines of the joint angles
    s6 = sin(q(6))
    c6 = cos(q(6))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_y = 12.715664641298892_rk*c6 - 10.96166739312846_rk*s6
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    c4 = cos(q(4))
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    s5 = sin(q(5))
    c23 = cos(angle23)
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw6_x = -12.715664641298892_rk*s6 - 10.96166739312846_rk*c6
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    t1 = c4*s23
    t2 = s23*s4
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = hw6_y*(c5*t1 + s5*c23) + hw6_x*t2
    t3 = 4.670685755861793_rk - hw6_x
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = -1.4861945804787264_rk*c5 - s5*t3
    hw5_x = 1.4861945804787264_rk*s5 - c5*t3
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t1*hw5_y - c23*hw5_x
    t4 = hw5_x + 7.622371790965955_rk
    t5 = -hw6_y - 8.545482905982176_rk
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t2*t4 - t1*t5
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = c4*t4 + s4*t5
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw3_x = s23*(hw5_y - 56.14707934476033_rk) - c23*(hw4_x + 10.254510287734192_rk)
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw2_x = neg_hw3_x - (75.09914597144959_rk*c2 - 1.5746110011895278_rk*s2)
    tau(1) = 0.0_rk
    tau(2) = neg_hw2_x
    tau(3) = neg_hw3_x
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 198 multiplications, 181 additions = 379; 0 unary minus; 10 sine/cosine
  pure subroutine puma560_full_bias(q, qd, tau) &
      bind(c, name="puma560_full_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: ww1_zz, w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_yz, neg_ww3_zx, ww3_yy
    real(rk) :: ww3_zz, ww3_xy, neg_lam3_11, lam3_32, c4, s4, neg_w4_x, w4_z, w4_y, neg_ww4_xy
    real(rk) :: ww4_zz, ww4_yy, ww4_yz, neg_ww4_zx, neg_lam4_21, neg_lam4_11, lam4_12, c5, s5
    real(rk) :: neg_w5_x, w5_z, w5_y, neg_ww5_zx, ww5_xx, ww5_zz, ww5_yz, neg_ww5_xy, w6_z, c6, s6
    real(rk) :: c2, s2, neg_alpha4_x, lam4_23, neg_lam5_13, alpha4_y, neg_lam5_12, alpha5_x
    real(rk) :: lam5_32, ww6_zz, ww2_zz, t1, t2, t3, lam3_22, alpha6_z, neg_lam5_31, t4, t5, t6, t7
    real(rk) :: t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24
    real(rk) :: t25, t26, t27, t28, t29, t30, t31, t32, nc6_z, lam4_13, neg_lam5_21, neg_lam5_22
    real(rk) :: t33, lam4_22, lam5_23, t34, t35, t36, t37, t38, t39, t40, t41, t42, t43, t44, t45
    real(rk) :: t46, t47, n4_z, t48, lam5_11, t49, t50, t51, t52, t53, t54, n3_y, neg_lam4_31
    real(rk) :: neg_n4_x, t55, n5_z, lam4_32, n4_y, t56, neg_n3_x, t57, t58, t59, t60, t61, t62
    real(rk) :: t63, t64, t65, n1_z, t66, n3_z, t67, n02_z

    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_x*neg_w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_32 = -2.0_rk*neg_ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    w4_y = neg_w3_x*s4 + w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_21 = neg_ww3_zx + neg_ww4_xy
    neg_lam4_11 = ww4_zz + ww4_yy
    lam4_12 = neg_ww3_zx - neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = neg_w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    neg_ww5_xy = neg_w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = neg_ww3_yz*c4 - qd(4)*w4_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz + neg_alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_13 = w4_y*neg_w5_x - (neg_ww3_zx*c5 + s5*neg_alpha4_x)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww5_xy + alpha4_y
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = neg_ww3_zx*s5 + (qd(5)*w5_y - c5*neg_alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz + alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = ww3_yy - ww3_zz
    t2 = ww1_zz - neg_lam3_11
    t3 = t1 - t2
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t3 - neg_lam3_11
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = neg_lam5_13 - neg_ww5_zx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = neg_ww5_zx - alpha6_z
    t4 = 0.2519035474197792_rk*c6 - 0.1902613160848803_rk*s6
    t5 = 0.1902613160848803_rk*c6 + 0.2519035474197792_rk*s6
    t6 = 0.561954526137403_rk*c6
    t7 = 0.062417998297925076_rk*c6
    t8 = t6*t7 + 0.43637196239865417_rk
    t9 = 0.561954526137403_rk*s6
    t10 = t7*t9
    t11 = t8 + 22.918482381900507_rk*t10
    t12 = t11 - 0.907820001453264_rk
    t13 = 0.9969983837450935_rk*s2
    t14 = ww2_zz*t13 + 22.627568690833527_rk
    t15 = 0.9969983837450935_rk*c2
    t16 = t15*(ww1_zz + ww2_zz)
    t17 = s23*t14 + c23*t16
    t18 = 0.04687139228815516_rk*neg_lam3_11 - (ww3_xy + t17)
    t19 = qd(1)*qd(2)
    t20 = 0.07491193080123078_rk*s2
    t21 = 0.3465712306626645_rk*ww1_zz + 26.617879771127544_rk*(t19*t20)
    t22 = 0.09374278457631031_rk*neg_ww3_zx - t21 - lam3_32
    t23 = s4*t18 - c4*t22
    t24 = t9 + 0.4844385865269322_rk*c6
    t25 = 0.04687139228815516_rk*ww3_xy - s23*t16 + (c23*t14 + lam3_22)
    t26 = c4*t18 + s4*t22
    t27 = s5*t25 - c5*t26
    t28 = t6 - 0.4844385865269322_rk*s6
    t29 = ww5_xx + ww6_zz
    t30 = ww5_zz + ww6_zz
    t31 = t29 - t30
    t32 = t10 - (22.918482381900507_rk*t8 - 10.402928354621762_rk)
    ! link 6: moment that turns the link [N m]
    nc6_z = neg_lam5_12*t4 - lam5_32*t5 - (neg_lam5_13*t12 + neg_lam5_31*t11 - t23*t24) + (t27*t28 &
        - t31*t32)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_21 = neg_ww5_xy - alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    t33 = ww4_zz - ww4_yy
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_22 = lam3_22 - t33
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    t34 = 0.08058935149735619_rk*lam5_32
    t35 = 0.37765802516131436_rk*t27
    t36 = 0.18116108322165295_rk*neg_lam5_12 - t34 - (0.1558184212675505_rk*t31 + t35 - &
        0.1513642331069161_rk*neg_lam5_31 + 0.2064157143738513_rk*t23 + nc6_z)
    t37 = 0.2788425785236688_rk*neg_lam5_13 - t36
    t38 = neg_lam4_11 + lam3_22
    t39 = qd(6) + w6_z
    t40 = alpha5_x + w5_z*t39
    t41 = neg_lam5_22 + lam4_22
    t42 = t28 + 0.37765802516131436_rk
    t43 = s5*t26 + c5*t25
    t44 = alpha4_y + neg_w5_x*t39
    t45 = t4*(t29 - neg_lam5_22) + (0.18116108322165295_rk*t41 - (t42*t43 - (t32*t44 + &
        (0.1558184212675505_rk*neg_lam5_21 - 0.06568070130666698_rk*t23))))
    t46 = 0.2788425785236688_rk*lam5_23 - (0.3901127773977262_rk*lam5_32 - (t12*t40 + t45)) - &
        neg_lam5_31*(t5 - 0.08058935149735619_rk)
    t47 = 0.3473260245772809_rk*neg_lam4_21 - (c5*t37 - 0.10734691974802549_rk*lam4_13 - &
        0.05337162017689789_rk*(t33 - t38)) - s5*t46
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.2837491060266096_rk*lam4_23 - (t47 + 0.33686216557830156_rk*t23)
    t48 = t31 + t41
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t48 - neg_lam5_22
    t49 = t24*t44 - (0.06568070130666698_rk*neg_lam5_22 + (0.37765802516131436_rk*lam5_23 + &
        0.2064157143738513_rk*neg_lam5_21)) + t28*t40
    t50 = 0.06568070130666698_rk*neg_lam5_12 + (t30*t24 - 0.2064157143738513_rk*lam5_11) - &
        neg_lam5_13*t42
    t51 = 0.33686216557830156_rk*neg_lam4_11 + (9.668724351427649_rk*t26 - s5*t49 - c5*t50)
    t52 = t29*t28 - (9.668724351427649_rk*t23 + neg_lam5_31*t24 - 0.8150047132321409_rk*(t34 - &
        0.2532693504989058_rk*neg_lam5_31)) - 0.37765802516131436_rk*lam4_22
    t53 = 0.33686216557830156_rk*neg_lam4_21 + t52
    t54 = s4*t51 + c4*t53
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.060845712710754084_rk*ww3_xy - n4_z + (0.9860113289194135_rk*neg_ww3_zx + &
        (1.4786909445136986_rk*neg_ww3_yz - (0.04687139228815516_rk*t54 - &
        0.01894848286257894_rk*t2)))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_x = c5*t46 - (s5*t37 - 0.05337162017689789_rk*neg_lam4_31 + &
        (0.2837491060266096_rk*neg_lam4_21 + 0.10734691974802549_rk*t33))
    t55 = 0.17391580988809086_rk*(t35 + 0.8959416706728075_rk*lam5_23) - (t11*t44 + (t5*(ww5_xx - &
        ww6_zz) - 0.1513642331069161_rk*neg_lam5_21))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = neg_lam5_13*(t4 - 0.18116108322165295_rk) - (0.08058935149735619_rk*t48 - &
        (0.3901127773977262_rk*neg_lam5_12 - (t32*t40 - (t43*(t24 + 0.2064157143738513_rk) - &
        t55))))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz - neg_alpha4_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = 0.10734691974802549_rk*lam4_12 + n5_z - 0.2837491060266096_rk*t38 + &
        0.3473260245772809_rk*neg_lam4_31 - (0.05337162017689789_rk*lam4_32 + &
        0.33686216557830156_rk*t25)
    t56 = t54 - s4*n4_y - (1.4786909445136986_rk*neg_ww3_zx + 0.060845712710754084_rk*(t1 + &
        432.2163900256032_rk*neg_ww3_yz) - 12.150081500837414_rk*t21)
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.01894848286257894_rk*ww3_xy + c4*neg_n4_x - t56
    t57 = 0.2348119600832282_rk*c2
    t58 = 55.04847880816545_rk*(s2*t57) + (c2*t57 - 0.1174059800416141_rk)
    t59 = t19*t58
    t60 = t15*(24.30016300167483_rk*neg_ww3_yz - t54) - (ww2_zz*(t20 - 4.508184091221399_rk*c2) + &
        (t59 - s23*neg_n3_x))
    t61 = c4*t51 - s4*t53
    t62 = 12.150081500837414_rk*ww3_xy + t61
    t63 = 0.33686216557830156_rk*neg_lam4_31 + (s5*t50 - c5*t49 + 9.668724351427649_rk*t25)
    t64 = t63 - 12.150081500837414_rk*lam3_22
    t65 = c23*t62 + s23*t64
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t60 - (t59 - 0.3465712306626645_rk*t65) - c23*n3_y
    t66 = 0.04687139228815516_rk*t63 - (0.7393454722568493_rk*t3 - (12.150081500837414_rk*t17 - &
        (c4*n4_y - (t61 + s4*neg_n4_x))))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = -12.656251483728838_rk*ww3_xy - t66
    t67 = t15*(s23*t62 - c23*t64) - n3_z + (293.22217760906653_rk*(c2 - &
        0.005370026967362786_rk*s2) - t13*t65)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = ww1_zz*t58 - t67
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 116 multiplications, 110 additions = 226; 0 unary minus; 10 sine/cosine
  pure subroutine puma560_full_mass_matrix(q, M) &
      bind(c, name="puma560_full_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, t1, t2, t3, neg_h6_y, t4, t5
    real(rk) :: h6_x, t6, h5_x, t7, t8, h4_x, k6_xz, t9, t10, t11, t12, t13, t14, t15, m4_4
    real(rk) :: neg_k6_yz, t16, t17, neg_k5_xz, neg_h5_y, neg_h4_y, k5_yz, t18, t19, t20, t21, t22
    real(rk) :: t23, t24, t25, t26, t27, t28, t29, t30, t31, t32, t33, t34, t35, t36, t37, t38, t39
    real(rk) :: t40, t41, t42, t43, m1_1, h3_y, m3_4, m1_3, t44, m1_2, m1_4, fu4_x, fu3_x, m5_5
    real(rk) :: t45, t46, nu3_y, m1_5, neg_nu5_y, fu5_x, fu4_y, neg_nu5_x, fu5_y, t47, t48, t49
    real(rk) :: m1_6, m3_3, t50, m2_3, m2_2, m2_4, m3_5, m2_5, m3_6, m2_6

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    t1 = 1.1185374890947408_rk*s6
    t2 = 0.8038904448657128_rk*c6
    t3 = 1.6140468000577937_rk*t2
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_y = t1 - t3
    t4 = 8.074308788029867_rk*neg_h6_y
    t5 = t4 + 13.331564749028798_rk*t3
    h6_x = 0.1639752994550661_rk*(t1 - t5)
    t6 = h6_x - 0.47660058733283606_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.15165250821211493_rk*s5 + c5*t6
    t7 = neg_h6_y - 0.8719880516308344_rk
    t8 = h5_x + 0.7777930398944852_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t7 + c4*t8
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = 0.02789191831646398_rk*t5
    t9 = c5*k6_xz
    t10 = t9 - 0.08058935149735619_rk*c5
    t11 = s6*t2 - 0.7502906175782786_rk
    t12 = c6*t2
    t13 = t11 + 0.04363290654837309_rk*t12
    t14 = t13 + 0.9479140356861228_rk
    t15 = s5*t14 - t10
    ! link 4: mass matrix, its row of this joint
    m4_4 = s5*t10 - (s5*t15 - 1.6853528376611298_rk)
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = 0.02404451046533376_rk*(t1 - t4)
    t16 = t12 - (0.04363290654837309_rk*t11 + 0.27886416156622007_rk)
    t17 = neg_k6_yz - 0.18116108322165295_rk
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*t16 + s5*t17
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_y = 0.15165250821211493_rk*c5 - s5*t6
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    neg_h4_y = c4*t7 - s4*t8
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = c5*t17 - s5*t16
    t18 = 0.0203_rk*h4_x
    t19 = c4*c4
    t20 = t13 + (t13 + m4_4)
    t21 = c4*s4
    t22 = neg_k5_xz - 0.034423137314318945_rk
    t23 = t22 + (neg_k5_xz - 0.07232010303947682_rk)
    t24 = t18 - t19*t20 + (t18 + (t13 - (t21*t23 + 0.47176417886368593_rk)))
    t25 = 0.4331_rk*neg_h5_y
    t26 = t25 + 5.555998411819751_rk + (t25 - m4_4)
    t27 = 0.4331_rk*neg_h4_y
    t28 = t18 + 0.3465712306626645_rk*t27
    t29 = 0.07491193080123078_rk*c2
    t30 = 5.764101864437669_rk*t29
    t31 = c23*t30
    t32 = h4_x + 1.046378600789203_rk
    t33 = s23*t30
    t34 = neg_h5_y + 5.729293810689829_rk
    t35 = t31*t32 + t33*t34
    t36 = 0.04687139228815516_rk*t25
    t37 = k5_yz - 0.10734691974802549_rk
    t38 = k6_xz + (c5*(t15 - t10) - 0.36433845752396576_rk)
    t39 = s4*t37 + (21.334975369458128_rk*t18 - c4*t38)
    t40 = t35 - s23*(c23*(t36 + 0.28615890025504537_rk - t39))
    t41 = 0.005305812062437387_rk*s2
    t42 = t29 - t41
    t43 = t28 - m4_4
    ! link 1: mass matrix, its row of this joint
    m1_1 = s23*s23*(t24 + t26) - (t28 - (t40 + 3.3083718390798666_rk + &
        102.49099587639564_rk*(t30*t42))) + (t40 - t43)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t32 - c23*t34
    ! link 3: mass matrix, its row of this joint
    m3_4 = s4*t38 + (t27 + c4*t37)
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.1501_rk*h3_y + c23*(m3_4 + 0.060845712710754084_rk) + s23*(t20*t21 + (t22 - (t19*t23 &
        - 0.04687139228815516_rk*t27)))
    t44 = 81.3824528495718_rk*t41
    m1_2 = m1_3 + (t42 - t44*(neg_h4_y - 2.7157163660839054_rk))
    m1_4 = h4_x*t30 + (s23*t39 - c23*t43)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    ! link 5: mass matrix, its row of this joint
    m5_5 = t14 + 0.7802255547954524_rk
    t45 = t25 + m5_5
    t46 = s4*t36
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*(c4*neg_k5_xz - s4*t45) - c23*(k5_yz - t46)
    ! link 1: mass matrix, its row of this joint
    m1_5 = 0.1501_rk*(141.7117652271228_rk*(c2*t46) - fu3_x) - nu3_y
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.907820001453264_rk*c5 + s5*k6_xz
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_x = t9 - 0.907820001453264_rk*s5
    ! link 5: force for a unit acceleration of a joint further out
    fu5_y = s5*neg_h6_y
    t47 = 0.4331_rk*fu4_y
    t48 = c4*fu5_x - s4*h6_x
    t49 = s23*fu5_y - c23*t48
    ! link 1: mass matrix, its row of this joint
    m1_6 = c23*(neg_nu5_y - 0.04687139228815516_rk*t47) + (s23*(t47 + s4*neg_k6_yz + c4*neg_nu5_x) &
        + (t30*fu4_y + 0.1501_rk*t49))
    ! link 3: mass matrix, its row of this joint
    m3_3 = t26 - t24
    t50 = t35 + h3_y*t44
    ! link 2: mass matrix, its row of this joint
    m2_3 = t50 + m3_3
    m2_2 = t50 + (m2_3 + 3.7298822532370677_rk)
    m2_4 = m3_4 + neg_h4_y*(t33 - c23*t44)
    ! link 3: mass matrix, its row of this joint
    m3_5 = s4*neg_k5_xz - (0.0203_rk*h5_x - c4*t45)
    ! link 2: mass matrix, its row of this joint
    m2_5 = t33*fu4_x + h5_x*t31 - (t44*fu3_x - m3_5)
    ! link 3: mass matrix, its row of this joint
    m3_6 = c4*neg_k6_yz + 0.4331_rk*t48 - (0.0203_rk*fu5_y + s4*neg_nu5_x)
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + (t44*t49 + (t31*fu5_y + t33*t48))
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = m1_6
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = m3_6
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = m3_5
    M(28) = k5_yz
    M(29) = m5_5
    M(30) = neg_k6_yz
    M(31) = m1_6
    M(32) = m2_6
    M(33) = m3_6
    M(34) = neg_nu5_y
    M(35) = neg_k6_yz
    M(36) = 0.907820001453264_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 400 multiplications, 359 additions, 5 divisions = 764; 4 unary minus; 10 sine/cosine
  pure subroutine puma560_full_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_full_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: ww1_zz, w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_yz, neg_ww3_zx, ww3_yy
    real(rk) :: ww3_zz, ww3_xy, neg_lam3_11, lam3_32, c4, s4, neg_w4_x, w4_z, w4_y, neg_ww4_xy
    real(rk) :: ww4_zz, ww4_yy, ww4_yz, neg_ww4_zx, neg_lam4_21, neg_lam4_11, lam4_12, c5, s5
    real(rk) :: neg_w5_x, w5_z, w5_y, neg_ww5_zx, ww5_xx, ww5_zz, ww5_yz, neg_ww5_xy, w6_z, c6, s6
    real(rk) :: c2, s2, neg_alpha4_x, lam4_23, neg_lam5_13, alpha4_y, neg_lam5_12, alpha5_x
    real(rk) :: lam5_32, ww6_zz, ww2_zz, t1, t2, t3, neg_lam3_22, alpha6_z, neg_lam5_31, t4, t5, t6
    real(rk) :: t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23
    real(rk) :: t24, t25, t26, t27, t28, t29, t30, t31, t32, nc6_z, lam4_13, neg_lam5_21
    real(rk) :: neg_lam5_22, t33, neg_lam4_22, lam5_23, t34, t35, t36, t37, t38, t39, t40, t41, t42
    real(rk) :: t43, t44, t45, t46, t47, n4_z, t48, lam5_11, t49, t50, t51, t52, t53, t54, neg_n3_y
    real(rk) :: neg_lam4_31, neg_n4_x, t55, n5_z, lam4_32, n4_y, t56, neg_n3_x, t57, t58, t59, t60
    real(rk) :: t61, t62, t63, t64, t65, n1_z, t66, neg_n3_z, t67, n02_z, t68, neg_h6_y, t69, t70
    real(rk) :: h6_x, t71, h5_x, t72, t73, h4_x, k6_xz, t74, t75, t76, t77, t78, t79, t80, m4_4
    real(rk) :: t81, neg_k6_yz, t82, t83, neg_k5_xz, neg_h5_y, neg_h4_y, neg_k5_yz, t84, t85, t86
    real(rk) :: t87, t88, t89, t90, t91, t92, t93, t94, t95, t96, t97, t98, t99, t100, t101, t102
    real(rk) :: t103, t104, t105, m1_1, h3_y, m3_4, m1_3, t106, m1_2, m1_4, fu4_x, fu3_x, m5_5
    real(rk) :: t107, t108, nu3_y, neg_m1_5, neg_nu5_y, fu5_x, fu4_y, neg_nu5_x, fu5_y, t109, t110
    real(rk) :: t111, m1_6, neg_m3_3, t112, neg_m2_3, m2_2, m2_4, m3_5, m2_5, m3_6, m2_6, neg_y6
    real(rk) :: u5_6, u4_6, u3_6, u2_6, u1_6, pivot5, ipivot5, neg_ud4_5, neg_u4_5, ud3_5, u3_5
    real(rk) :: ud2_5, u2_5, neg_ud1_5, neg_u1_5, pivot4, ipivot4, ud3_4, u3_4, ud2_4, u2_4, ud1_4
    real(rk) :: u1_4, neg_pivot3, neg_ipivot3, neg_ud2_3, u2_3, ud1_3, neg_u1_3, pivot2, ipivot2
    real(rk) :: ud1_2, u1_2, pivot1, ipivot1, neg_y5, neg_y4, y3, neg_y2, y1, qdd1, neg_qdd2
    real(rk) :: neg_qdd3, neg_qdd4, qdd5, qdd6, t113, t114, t115

    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_x*neg_w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_32 = -2.0_rk*neg_ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    w4_y = neg_w3_x*s4 + w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_zz = w4_z*w4_z
    ww4_yy = w4_y*w4_y
    ww4_yz = w4_z*w4_y
    neg_ww4_zx = neg_w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_21 = neg_ww3_zx + neg_ww4_xy
    neg_lam4_11 = ww4_zz + ww4_yy
    lam4_12 = neg_ww3_zx - neg_ww4_xy
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    w5_y = neg_w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    neg_ww5_xy = neg_w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_x = neg_ww3_yz*c4 - qd(4)*w4_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww4_yz + neg_alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_13 = w4_y*neg_w5_x - (neg_ww3_zx*c5 + s5*neg_alpha4_x)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww5_xy + alpha4_y
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = neg_ww3_zx*s5 + (qd(5)*w5_y - c5*neg_alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz + alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = ww3_yy - ww3_zz
    t2 = ww1_zz - neg_lam3_11
    t3 = t1 - t2
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam3_11 - t3
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = neg_lam5_13 - neg_ww5_zx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_31 = neg_ww5_zx - alpha6_z
    t4 = 0.2519035474197792_rk*c6 - 0.1902613160848803_rk*s6
    t5 = 0.1902613160848803_rk*c6 + 0.2519035474197792_rk*s6
    t6 = 0.561954526137403_rk*c6
    t7 = 0.062417998297925076_rk*c6
    t8 = t6*t7 + 0.43637196239865417_rk
    t9 = 0.561954526137403_rk*s6
    t10 = t7*t9
    t11 = t8 + 22.918482381900507_rk*t10
    t12 = t11 - 0.907820001453264_rk
    t13 = 0.9969983837450935_rk*s2
    t14 = ww2_zz*t13 + 22.627568690833527_rk
    t15 = 0.9969983837450935_rk*c2
    t16 = t15*(ww1_zz + ww2_zz)
    t17 = s23*t14 + c23*t16
    t18 = 0.04687139228815516_rk*neg_lam3_11 - (ww3_xy + t17)
    t19 = qd(1)*qd(2)
    t20 = 0.07491193080123078_rk*s2
    t21 = 0.3465712306626645_rk*ww1_zz + 26.617879771127544_rk*(t19*t20)
    t22 = 0.09374278457631031_rk*neg_ww3_zx - t21 - lam3_32
    t23 = s4*t18 - c4*t22
    t24 = t9 + 0.4844385865269322_rk*c6
    t25 = 0.04687139228815516_rk*ww3_xy - s23*t16 - (neg_lam3_22 - c23*t14)
    t26 = c4*t18 + s4*t22
    t27 = s5*t25 - c5*t26
    t28 = t6 - 0.4844385865269322_rk*s6
    t29 = ww5_xx + ww6_zz
    t30 = ww5_zz + ww6_zz
    t31 = t29 - t30
    t32 = t10 - (22.918482381900507_rk*t8 - 10.402928354621762_rk)
    ! link 6: moment that turns the link [N m]
    nc6_z = neg_lam5_12*t4 - lam5_32*t5 - (neg_lam5_13*t12 + neg_lam5_31*t11 - t23*t24) + (t27*t28 &
        - t31*t32)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = alpha4_y - neg_ww4_zx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_21 = neg_ww5_xy - alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    t33 = ww4_zz - ww4_yy
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = neg_lam3_22 + t33
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_23 = ww5_yz - alpha5_x
    t34 = 0.08058935149735619_rk*lam5_32
    t35 = 0.37765802516131436_rk*t27
    t36 = 0.18116108322165295_rk*neg_lam5_12 - t34 - (nc6_z + (0.1558184212675505_rk*t31 + t35 - &
        0.1513642331069161_rk*neg_lam5_31 + 0.2064157143738513_rk*t23))
    t37 = 0.2788425785236688_rk*neg_lam5_13 - t36
    t38 = neg_lam4_11 - neg_lam3_22
    t39 = qd(6) + w6_z
    t40 = alpha5_x + w5_z*t39
    t41 = neg_lam5_22 - neg_lam4_22
    t42 = t28 + 0.37765802516131436_rk
    t43 = s5*t26 + c5*t25
    t44 = alpha4_y + neg_w5_x*t39
    t45 = t4*(t29 - neg_lam5_22) + (0.18116108322165295_rk*t41 - (t42*t43 - (t32*t44 + &
        (0.1558184212675505_rk*neg_lam5_21 - 0.06568070130666698_rk*t23))))
    t46 = 0.2788425785236688_rk*lam5_23 - (0.3901127773977262_rk*lam5_32 - (t12*t40 + t45)) - &
        neg_lam5_31*(t5 - 0.08058935149735619_rk)
    t47 = 0.3473260245772809_rk*neg_lam4_21 - (c5*t37 - 0.10734691974802549_rk*lam4_13 - &
        0.05337162017689789_rk*(t33 - t38)) - s5*t46
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.2837491060266096_rk*lam4_23 - (t47 + 0.33686216557830156_rk*t23)
    t48 = t31 + t41
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t48 - neg_lam5_22
    t49 = t24*t44 - (0.06568070130666698_rk*neg_lam5_22 + (0.37765802516131436_rk*lam5_23 + &
        0.2064157143738513_rk*neg_lam5_21)) + t28*t40
    t50 = 0.06568070130666698_rk*neg_lam5_12 + (t24*t30 - 0.2064157143738513_rk*lam5_11) - &
        neg_lam5_13*t42
    t51 = 0.33686216557830156_rk*neg_lam4_11 + (9.668724351427649_rk*t26 - s5*t49 - c5*t50)
    t52 = t28*t29 - (9.668724351427649_rk*t23 + neg_lam5_31*t24 - 0.8150047132321409_rk*(t34 - &
        0.2532693504989058_rk*neg_lam5_31)) + 0.37765802516131436_rk*neg_lam4_22
    t53 = 0.33686216557830156_rk*neg_lam4_21 + t52
    t54 = s4*t51 + c4*t53
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = n4_z - 0.060845712710754084_rk*ww3_xy - (0.9860113289194135_rk*neg_ww3_zx + &
        (1.4786909445136986_rk*neg_ww3_yz - (0.04687139228815516_rk*t54 - &
        0.01894848286257894_rk*t2)))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_31 = neg_ww4_zx + alpha4_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_x = c5*t46 - (s5*t37 - 0.05337162017689789_rk*neg_lam4_31 + &
        (0.2837491060266096_rk*neg_lam4_21 + 0.10734691974802549_rk*t33))
    t55 = 0.17391580988809086_rk*(t35 + 0.8959416706728075_rk*lam5_23) - (t11*t44 + (t5*(ww5_xx - &
        ww6_zz) - 0.1513642331069161_rk*neg_lam5_21))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = neg_lam5_13*(t4 - 0.18116108322165295_rk) - (0.08058935149735619_rk*t48 - &
        (0.3901127773977262_rk*neg_lam5_12 - (t32*t40 - (t43*(t24 + 0.2064157143738513_rk) - &
        t55))))
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz - neg_alpha4_x
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = n5_z + 0.10734691974802549_rk*lam4_12 - 0.2837491060266096_rk*t38 + &
        0.3473260245772809_rk*neg_lam4_31 - (0.05337162017689789_rk*lam4_32 + &
        0.33686216557830156_rk*t25)
    t56 = t54 - s4*n4_y - (1.4786909445136986_rk*neg_ww3_zx + 0.060845712710754084_rk*(t1 + &
        432.2163900256032_rk*neg_ww3_yz) - 12.150081500837414_rk*t21)
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.01894848286257894_rk*ww3_xy + c4*neg_n4_x - t56
    t57 = 0.2348119600832282_rk*c2
    t58 = 55.04847880816545_rk*(s2*t57) + (c2*t57 - 0.1174059800416141_rk)
    t59 = t19*t58
    t60 = t15*(t54 - 24.30016300167483_rk*neg_ww3_yz) + (ww2_zz*(t20 - 4.508184091221399_rk*c2) + &
        (t59 - s23*neg_n3_x))
    t61 = c4*t51 - s4*t53
    t62 = 12.150081500837414_rk*ww3_xy + t61
    t63 = 0.33686216557830156_rk*neg_lam4_31 + (s5*t50 - c5*t49 + 9.668724351427649_rk*t25)
    t64 = t63 + 12.150081500837414_rk*neg_lam3_22
    t65 = c23*t62 + s23*t64
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = c23*neg_n3_y - (t60 + (t59 - 0.3465712306626645_rk*t65))
    t66 = 0.04687139228815516_rk*t63 - (0.7393454722568493_rk*t3 - (12.150081500837414_rk*t17 - &
        (c4*n4_y - (t61 + s4*neg_n4_x))))
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_z = 12.656251483728838_rk*ww3_xy + t66
    t67 = neg_n3_z + t15*(s23*t62 - c23*t64) + (293.22217760906653_rk*(c2 - &
        0.005370026967362786_rk*s2) - t13*t65)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = ww1_zz*t58 - t67
    t68 = 1.1185374890947408_rk*s6
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_y = t68 - 1.2975168001325401_rk*c6
    t69 = 8.074308788029867_rk*neg_h6_y
    t70 = t69 + 17.297929233919618_rk*c6
    h6_x = 0.1639752994550661_rk*(t68 - t70)
    t71 = h6_x - 0.47660058733283606_rk
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.15165250821211493_rk*s5 + c5*t71
    t72 = neg_h6_y - 0.8719880516308344_rk
    t73 = h5_x + 0.7777930398944852_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t72 + c4*t73
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = 0.02789191831646398_rk*t70
    t74 = c5*k6_xz
    t75 = t74 - 0.08058935149735619_rk*c5
    t76 = 0.8038904448657128_rk*c6
    t77 = s6*t76 - 0.7502906175782786_rk
    t78 = c6*t76
    t79 = t77 + 0.04363290654837309_rk*t78
    t80 = t75 + (t75 - s5*(t79 + 0.9479140356861228_rk))
    ! link 4: mass matrix, its row of this joint
    m4_4 = s5*t80 + 1.6853528376611298_rk
    t81 = t68 - t69
    ! link 6: second moment of the composite body [kg m^2]
    neg_k6_yz = 0.02404451046533376_rk*t81
    t82 = t78 - (0.04363290654837309_rk*t77 + 0.27886416156622007_rk)
    t83 = 0.18116108322165295_rk - neg_k6_yz
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*t82 - s5*t83
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_y = 0.15165250821211493_rk*c5 - s5*t71
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    neg_h4_y = c4*t72 - s4*t73
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = c5*t83 + s5*t82
    t84 = 0.0203_rk*h4_x
    t85 = c4*c4
    t86 = t79 + (t79 + m4_4)
    t87 = c4*s4
    t88 = 2.0_rk*neg_k5_xz - 0.10674324035379577_rk
    t89 = t84 - t85*t86 + (t84 + (t79 - (t87*t88 + 0.47176417886368593_rk)))
    t90 = 0.4331_rk*neg_h5_y
    t91 = t90 + 5.555998411819751_rk - (m4_4 - t90)
    t92 = t84 + 0.1501_rk*neg_h4_y
    t93 = 0.4318_rk*c2
    t94 = c23*t93
    t95 = h4_x + 1.046378600789203_rk
    t96 = s23*t93
    t97 = neg_h5_y + 5.729293810689829_rk
    t98 = t94*t95 + t96*t97
    t99 = 0.0203_rk*neg_h5_y
    t100 = neg_k5_yz + 0.10734691974802549_rk
    t101 = k6_xz - (c5*t80 + 0.36433845752396576_rk)
    t102 = s4*t100 - (0.4331_rk*h4_x - c4*t101)
    t103 = t98 - s23*(c23*(t99 + 0.28615890025504537_rk + t102))
    t104 = 0.07491193080123078_rk*c2 - 0.005305812062437387_rk*s2
    t105 = m4_4 - t92
    ! link 1: mass matrix, its row of this joint
    m1_1 = s23*s23*(t89 + t91) - (t92 - (t103 + 3.3083718390798666_rk + &
        102.49099587639564_rk*(t93*t104))) + (t103 + t105)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t95 - c23*t97
    ! link 3: mass matrix, its row of this joint
    m3_4 = s4*t101 + (0.4331_rk*neg_h4_y - c4*t100)
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.1501_rk*h3_y + c23*(m3_4 + 0.060845712710754084_rk) + s23*(t86*t87 + (neg_k5_xz - &
        0.034423137314318945_rk - (t85*t88 - 0.0203_rk*neg_h4_y)))
    t106 = 0.4318_rk*s2
    m1_2 = m1_3 + (t104 - t106*(neg_h4_y - 2.7157163660839054_rk))
    m1_4 = h4_x*t93 - (s23*t102 - c23*t105)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    ! link 5: mass matrix, its row of this joint
    m5_5 = t79 + 1.728139590481575_rk
    t107 = t90 + m5_5
    t108 = s4*t99
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*(c4*neg_k5_xz - s4*t107) + c23*(neg_k5_yz + t108)
    ! link 1: mass matrix, its row of this joint
    neg_m1_5 = nu3_y + 0.1501_rk*(fu3_x - 141.7117652271228_rk*(c2*t108))
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.907820001453264_rk*c5 + s5*k6_xz
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_x = t74 - 0.907820001453264_rk*s5
    ! link 5: force for a unit acceleration of a joint further out
    fu5_y = s5*neg_h6_y
    t109 = c4*fu5_x - s4*h6_x
    t110 = s23*fu5_y - c23*t109
    t111 = s23*(0.4331_rk*fu4_y + s4*neg_k6_yz + c4*neg_nu5_x) + (t93*fu4_y + 0.1501_rk*t110)
    ! link 1: mass matrix, its row of this joint
    m1_6 = c23*(neg_nu5_y - 0.0203_rk*fu4_y) + t111
    ! link 3: mass matrix, its row of this joint
    neg_m3_3 = t89 - t91
    t112 = t98 + h3_y*t106
    ! link 2: mass matrix, its row of this joint
    neg_m2_3 = neg_m3_3 - t112
    m2_2 = t112 - (neg_m2_3 - 3.7298822532370677_rk)
    m2_4 = m3_4 + neg_h4_y*(t96 - c23*t106)
    ! link 3: mass matrix, its row of this joint
    m3_5 = s4*neg_k5_xz - (0.0203_rk*h5_x - c4*t107)
    ! link 2: mass matrix, its row of this joint
    m2_5 = t96*fu4_x + h5_x*t94 + (m3_5 - t106*fu3_x)
    ! link 3: mass matrix, its row of this joint
    m3_6 = c4*neg_k6_yz + 0.4331_rk*t109 - (0.0203_rk*fu5_y + s4*neg_nu5_x)
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + (t106*t110 + (t94*fu5_y + t96*t109))
    ! link 6: forward substitution
    neg_y6 = nc6_z - tau(6)
    ! factorisation M = U D U^T
    u5_6 = 0.026485988881983898_rk*t81
    u4_6 = 1.1015399510907136_rk*neg_nu5_y
    u3_6 = 1.1015399510907136_rk*m3_6
    u2_6 = 1.1015399510907136_rk*m2_6
    u1_6 = 1.1015399510907136_rk*m1_6
    pivot5 = m5_5 - neg_k6_yz*u5_6
    ipivot5 = 1.0_rk / pivot5
    neg_ud4_5 = neg_k5_yz + neg_k6_yz*u4_6
    neg_u4_5 = ipivot5*neg_ud4_5
    ud3_5 = m3_5 - neg_k6_yz*u3_6
    u3_5 = ipivot5*ud3_5
    ud2_5 = m2_5 - neg_k6_yz*u2_6
    u2_5 = ipivot5*ud2_5
    neg_ud1_5 = neg_m1_5 + neg_k6_yz*u1_6
    neg_u1_5 = ipivot5*neg_ud1_5
    pivot4 = m4_4 - neg_nu5_y*u4_6 - neg_ud4_5*neg_u4_5
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = m3_4 - neg_nu5_y*u3_6 + neg_ud4_5*u3_5
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 - neg_nu5_y*u2_6 + neg_ud4_5*u2_5
    u2_4 = ipivot4*ud2_4
    ud1_4 = m1_4 - neg_nu5_y*u1_6 - neg_ud4_5*neg_u1_5
    u1_4 = ipivot4*ud1_4
    neg_pivot3 = neg_m3_3 + m3_6*u3_6 + ud3_5*u3_5 + ud3_4*u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = neg_m2_3 + m3_6*u2_6 + ud3_5*u2_5 + ud3_4*u2_4
    u2_3 = neg_ipivot3*neg_ud2_3
    ud1_3 = m1_3 - m3_6*u1_6 + ud3_5*neg_u1_5 - ud3_4*u1_4
    neg_u1_3 = neg_ipivot3*ud1_3
    pivot2 = m2_2 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 + neg_ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 - m2_6*u1_6 + ud2_5*neg_u1_5 - ud2_4*u1_4 - neg_ud2_3*neg_u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - m1_6*u1_6 - neg_ud1_5*neg_u1_5 - ud1_4*u1_4 + ud1_3*neg_u1_3 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5) - neg_y6*u5_6
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) - neg_y6*u4_6 + neg_u4_5*neg_y5
    ! link 3: forward substitution
    y3 = neg_n3_z + tau(3) + neg_y6*u3_6 + u3_5*neg_y5 + u3_4*neg_y4
    ! link 2: forward substitution
    neg_y2 = n02_z - tau(2) - neg_y6*u2_6 - u2_5*neg_y5 - u2_4*neg_y4 + u2_3*y3
    ! link 1: forward substitution
    y1 = tau(1) - n1_z + neg_y6*u1_6 - neg_u1_5*neg_y5 + u1_4*neg_y4 + neg_u1_3*y3 + u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd2 = ipivot2*neg_y2 + u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd3 = neg_ipivot3*y3 - u2_3*neg_qdd2 - neg_u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd4 = ipivot4*neg_y4 - u3_4*neg_qdd3 - u2_4*neg_qdd2 + u1_4*qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = neg_u1_5*qdd1 - (ipivot5*neg_y5 + neg_u4_5*neg_qdd4 - u3_5*neg_qdd3 - u2_5*neg_qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = -u1_6*qdd1 - (1.1015399510907136_rk*neg_y6 + u5_6*qdd5 - u4_6*neg_qdd4 - u3_6*neg_qdd3 &
        - u2_6*neg_qdd2)
    t113 = -neg_qdd2
    t114 = -neg_qdd3
    t115 = -neg_qdd4
    qdd(1) = qdd1
    qdd(2) = t113
    qdd(3) = t114
    qdd(4) = t115
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
