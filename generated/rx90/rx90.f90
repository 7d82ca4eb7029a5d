! rx90: Staubli RX90 geometry, random full inertias
! Numbers: published RX90 geometry; inertial parameters drawn at random
! Origin of numbers: geometry: stated by the description
! Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 585cc70ab770fd33a78850636aafb009 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0     d 0     theta q
!   2  revolute  alpha pi/2   a 0     d 0     theta q
!   3  revolute  alpha 0      a 0.45  d 0     theta q
!   4  revolute  alpha -pi/2  a 0     d 0.45  theta q
!   5  revolute  alpha pi/2   a 0     d 0     theta q
!   6  revolute  alpha -pi/2  a 0     d 0     theta q
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
! Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
!   parameters, equal to the recursion without being written like it: robodyn --optimize full,
!   seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 212 multiplications, 201 additions = 413; 3 unary minus; 10 sine/cosine
!   gravity: 24 multiplications, 18 additions = 42; 0 unary minus; 10 sine/cosine
!   bias: 191 multiplications, 173 additions = 364; 0 unary minus; 10 sine/cosine
!   mass_matrix: 105 multiplications, 94 additions = 199; 1 unary minus; 10 sine/cosine
!   forward_dynamics: 376 multiplications, 336 additions, 5 divisions = 717; 14 unary minus; 10
!       sine/cosine
module rx90_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: rx90_inverse_dynamics
  public :: rx90_gravity
  public :: rx90_bias
  public :: rx90_mass_matrix
  public :: rx90_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 212 multiplications, 201 additions = 413; 3 unary minus; 10 sine/cosine
  pure subroutine rx90_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="rx90_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, w3_x, c23, w3_y, alpha3_z, neg_lam3_23, ww3_yz, alpha3_x
    real(rk) :: lam3_13, ww3_zx, alpha3_y, ww3_xy, ww3_zz, lam3_12, lam3_32, lam3_21, lam3_31, c4
    real(rk) :: s4, w4_x, w4_z, w4_y, alpha4_z, ww4_xy, ww4_xx, ww4_zz, ww4_yz, ww4_zx, lam4_21
    real(rk) :: lam4_12, neg_lam4_22, c5, s5, w5_x, w5_z, w5_y, ww5_zx, ww5_xx, ww5_zz, ww5_yz
    real(rk) :: ww5_xy, w6_z, c6, s6, c2, s2, alpha4_x, alpha5_y, lam5_31, alpha5_x, lam5_32
    real(rk) :: ww6_zz, lam2_13, t1, lam2_31, ww2_zz, lam2_33, neg_alpha4_y, alpha5_z, lam5_21
    real(rk) :: ww3_xx, lam3_22, lam5_12, neg_lam5_22, lam4_31, lam4_32, lam5_13, t2, t3, t4, t5
    real(rk) :: t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22
    real(rk) :: t23, t24, nc6_z, lam5_11, lam5_23, t25, lam4_11, lam4_13, lam4_23, t26, t27, t28
    real(rk) :: t29, t30, t31, t32, n5_z, t33, t34, t35, t36, t37, t38, t39, t40, t41, t42, t43
    real(rk) :: t44, t45, t46, n3_x, t47, n4_z, t48, n3_y, n03_y, t49, t50, t51, t52, t53, t54, t55
    real(rk) :: t56, t57, n1_z, t58, t59, n3_z, lam3_11, t60, t61, t62, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    w3_y = qd(1)*c23
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_23 = s23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_z*w3_y
    ! link 3: angular acceleration [rad/s^2]
    alpha3_x = neg_lam3_23 + ww3_yz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_13 = c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zx = w3_z*w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = lam3_13 - ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - alpha3_z
    lam3_32 = ww3_yz + alpha3_x
    lam3_21 = alpha3_z + ww3_xy
    lam3_31 = ww3_zx - alpha3_y
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 - w3_z*s4
    w4_z = w3_y + qd(4)
    w4_y = -w3_z*c4 - w3_x*s4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = alpha3_y + qdd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ww4_yz = w4_z*w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = alpha4_z + ww4_xy
    lam4_12 = ww4_xy - alpha4_z
    neg_lam4_22 = ww4_xx + ww4_zz
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 + w4_z*s5
    w5_z = qd(5) - w4_y
    w5_y = w4_z*c5 - w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    ww5_xy = w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = qd(4)*w4_y - (alpha3_z*s4 - alpha3_x*c4)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = alpha4_z*c5 - (w5_x*qd(5) + s5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx - alpha5_y
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x + (alpha4_z*s5 + qd(5)*w5_y)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz + alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_13 = qdd(1)*c2
    t1 = 2.0_rk*(qd(2)*qd(1))
    lam2_31 = s2*t1 - lam2_13
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_y = alpha3_z*c4 + (alpha3_x*s4 + w4_x*qd(4))
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = neg_alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + alpha5_z
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = w3_x*w3_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = -ww3_zz - ww3_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx + neg_alpha4_y
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx + alpha5_y
    t2 = 0.706845523804052_rk*c6 + 0.2821950289584464_rk*s6
    t3 = lam3_32 + lam2_31
    t4 = qdd(2)*s2 + c2*(ww2_zz - lam2_33)
    t5 = qdd(2)*c2 - (s2*ww2_zz - 21.77777777777778_rk)
    t6 = c23*t4 - s23*t5 - lam3_12
    t7 = c4*t3 - s4*t6
    t8 = 0.47205526469446013_rk*c6 - 0.5674357966404597_rk*t2
    t9 = 0.706845523804052_rk*s6 - 0.2821950289584464_rk*c6
    t10 = s4*t3 + c4*t6
    t11 = s23*t4 + c23*t5
    t12 = t11 + lam3_22
    t13 = c5*t10 - s5*t12
    t14 = 0.1601275610650136_rk*c6 + 0.07096581179296485_rk*s6
    t15 = lam5_31 - qdd(6)
    t16 = 0.31005692653217237_rk*c6
    t17 = c6*t16
    t18 = s6*t16
    t19 = t17 + (0.8915767942352734_rk*t18 + 0.13354610634435332_rk)
    t20 = t19 - 0.5771491392208791_rk
    t21 = qdd(6) + lam5_13
    t22 = t2*t7 - t8*lam5_12 - (t9*t13 - t14*lam5_32 + t15*t19) - t20*t21
    t23 = t18 - 0.13821978029399798_rk*(6.450428385422554_rk*t17 - 1.0_rk)
    t24 = ww5_xx - ww5_zz
    ! link 6: moment that turns the link [N m]
    nc6_z = t22 - t23*t24
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t24 - neg_lam4_22
    lam5_23 = ww5_yz - alpha5_x
    t25 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = lam3_22 + t25
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_23 = ww4_yz - alpha4_x
    t26 = s5*t10 + c5*t12
    t27 = 2.0_rk*w6_z
    t28 = lam5_32 - w5_z*t27
    t29 = w5_x*t27 - lam5_12
    t30 = ww5_zz - ww6_zz
    t31 = t30 + t24
    t32 = t26*(t2 + 0.40383849355176565_rk) - (t28*t23 - (0.09969734753381411_rk*lam5_12 - &
        t19*t29) + t8*t21 + t14*t31)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = 0.4973859781056681_rk*lam5_21 + (0.3630349860955984_rk*t13 - &
        (0.06545842652927093_rk*lam5_13 - 0.022422989561630666_rk*lam5_23 + t32 - &
        0.04994749004669093_rk*(neg_lam5_22 + lam5_11)))
    t33 = t28*t20 - (0.3630349860955984_rk*t7 - 0.022422989561630666_rk*lam5_21) + ((t9 - &
        0.48442678791853194_rk)*t26 - t29*t23)
    t34 = 0.04994749004669093_rk*lam5_31 + t14*t15 - (0.09969734753381411_rk*lam5_32 - t30*t8) + &
        t33 + 0.06545842652927093_rk*(neg_lam4_22 - neg_lam5_22)
    t35 = neg_lam4_22 + lam3_22
    t36 = 0.40383849355176565_rk*t7 + 0.06545842652927093_rk*lam5_12 + &
        (0.04994749004669093_rk*lam5_32 + 0.48442678791853194_rk*t13) + (nc6_z + &
        (0.022422989561630666_rk*t24 - 0.4973859781056681_rk*lam5_31))
    t37 = c5*t34 - (4.226760246817004_rk*t7 + 0.09181695932507075_rk*lam4_31) + &
        (-0.7570061710726514_rk*lam4_32 - (0.02981305527252843_rk*t35 - s5*t36))
    t38 = 0.1094831940191231_rk*lam4_21 + t37
    t39 = t9*t21 - t2*(t31 - neg_lam5_22) - 0.40383849355176565_rk*lam5_11 + &
        (0.3630349860955984_rk*lam5_12 - 0.48442678791853194_rk*lam5_13)
    t40 = 0.48442678791853194_rk*lam5_23 + (t2*t29 + (0.3630349860955984_rk*neg_lam5_22 + &
        0.40383849355176565_rk*lam5_21) + t28*t9)
    t41 = c5*t39 + (s5*t40 + 0.09791727023389989_rk*lam4_11 + 4.226760246817004_rk*lam4_13)
    t42 = t9*(t30 - neg_lam5_22) + (0.3630349860955984_rk*lam5_32 - 4.226760246817004_rk*lam4_23 - &
        (0.09791727023389989_rk*lam4_21 - 0.48442678791853194_rk*neg_lam4_22) - t15*t2)
    t43 = t42 - 0.40383849355176565_rk*lam5_31
    t44 = s4*t41 - (0.06558551272001446_rk*lam3_31 + c4*t43)
    t45 = 4.226760246817004_rk*t10 - 0.02981305527252843_rk*lam4_12 + (n5_z + &
        0.09791727023389989_rk*t12) - (0.1094831940191231_rk*t25 - 0.09181695932507075_rk*lam4_32 &
        - 0.1886810537096668_rk*lam4_31)
    t46 = lam3_22 - lam2_33
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = -0.1093030288471206_rk*lam3_21 - (c4*t38 + 3.0574321390485957_rk*lam3_32 + (t44 - &
        s4*t45 + 0.0672049454639226_rk*t46))
    t47 = 0.1886810537096668_rk*lam4_21 - (s5*t34 - 0.1094831940191231_rk*lam4_23 + &
        0.09181695932507075_rk*(t35 + t25)) - 0.02981305527252843_rk*lam4_13
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t47 + (-0.7570061710726514_rk*lam4_12 - (0.09791727023389989_rk*t7 - c5*t36))
    t48 = ww3_zz - ww3_xx
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.1800707921647878_rk*lam2_31 - 0.06558551272001446_rk*lam3_32 - &
        0.19252101484679798_rk*lam3_31 - (0.1093030288471206_rk*t48 - &
        0.0672049454639226_rk*lam3_12 - n4_z)
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t49 = 0.09496171507178643_rk*c2
    t50 = 0.017315109477737248_rk*s2 + t49
    t51 = 0.09496171507178643_rk*s2
    t52 = 0.017315109477737248_rk*c2 - t51
    t53 = 7.0674063888484_rk*c2
    t54 = t51*t53
    t55 = t49*t53
    t56 = 6.104207957983257_rk*t54 + (t55 - 0.3355665158971724_rk)
    t57 = qdd(2)*t50 + (ww2_zz*t52 + t1*t56) + qdd(1)*(t54 - (6.104207957983257_rk*t55 + &
        1.1871933280055555_rk))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n03_y - (t57 - c2*(t44 + 0.24565630488480228_rk*lam3_31))
    t58 = t46 + t48
    t59 = c4*t41 + s4*t43
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = c4*t45 - (0.1800707921647878_rk*t11 - 0.06558551272001446_rk*t58) - &
        0.1093030288471206_rk*neg_lam3_23 - (-3.0574321390485957_rk*lam3_12 - &
        (0.19252101484679798_rk*lam3_21 - (0.0672049454639226_rk*lam3_13 + t59)) - s4*t38)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_11 = lam3_22 - t58
    t60 = t59 - 0.1800707921647878_rk*lam3_11
    t61 = c5*t40 - s5*t39 - 0.09791727023389989_rk*lam4_31 + (0.1800707921647878_rk*lam3_21 - &
        4.226760246817004_rk*lam3_22)
    t62 = 5.195184633739834_rk*qdd(2) + c2*(s23*t60 - c23*t61) - (qdd(1)*t50 - n3_z) - lam2_33*t56
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = 4681.18660659102_rk*(t52 + 0.09865834996998242_rk*s2) + (t62 - s2*(c23*t60 + s23*t61))
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 24 multiplications, 18 additions = 42; 0 unary minus; 10 sine/cosine
  pure subroutine rx90_gravity(q, tau) &
      bind(c, name="rx90_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s6, c6, neg_hw6_y, c5, c4, angle23, s23, s5, c23, neg_hw6_x, s4, t1, t2, tau6, t3
    real(rk) :: neg_hw5_y, neg_hw5_x, tau5, t4, t5, tau4, c2, s2, hw4_x, hw3_x, hw2_x

    ! sines and cosines of the joint angles
    s6 = sin(q(6))
    c6 = cos(q(6))
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw6_y = 15.393524740621578_rk*s6 - 6.14558063065061_rk*c6
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    c4 = cos(q(4))
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    s5 = sin(q(5))
    c23 = cos(angle23)
    ! link 6: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw6_x = 15.393524740621578_rk*c6 + 6.14558063065061_rk*s6
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    t1 = c4*s23
    t2 = s23*s4
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = neg_hw6_y*(c5*t1 + s5*c23) + neg_hw6_x*t2
    t3 = neg_hw6_x + 8.794704970682897_rk
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw5_y = s5*t3 - 7.906095252748588_rk*c5
    neg_hw5_x = c5*t3 + 7.906095252748588_rk*s5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = t1*neg_hw5_y - c23*neg_hw5_x
    t4 = neg_hw6_y - 10.549738936892474_rk
    t5 = neg_hw5_x - 2.1324205517604864_rk
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = t1*t4 + t2*t5
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = s4*t4 - c4*t5
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = s23*(neg_hw5_y - 92.04944537512587_rk) - c23*(3.921541696033157_rk - hw4_x)
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = hw3_x + (81.05525857884084_rk*c2 + 17.30463777489202_rk*s2)
    tau(1) = 0.0_rk
    tau(2) = hw2_x
    tau(3) = hw3_x
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 191 multiplications, 173 additions = 364; 0 unary minus; 10 sine/cosine
  pure subroutine rx90_bias(q, qd, tau) &
      bind(c, name="rx90_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, w3_x, c23, w3_y, ww3_yz, ww3_zx, ww3_xy, ww3_zz, lam3_32, c4
    real(rk) :: s4, w4_x, w4_z, neg_w4_y, neg_ww4_xy, ww4_xx, ww4_zz, neg_ww4_yz, ww4_zx
    real(rk) :: neg_lam4_21, lam4_12, neg_lam4_22, c5, s5, w5_x, w5_z, w5_y, ww5_zx, ww5_xx, ww5_zz
    real(rk) :: ww5_yz, ww5_xy, w6_z, c6, s6, c2, s2, alpha4_x, neg_alpha5_y, lam5_31, alpha5_x
    real(rk) :: lam5_32, ww6_zz, t1, lam2_31, ww2_zz, neg_lam2_33, neg_alpha4_y, lam5_21, ww3_xx
    real(rk) :: neg_lam3_22, lam5_12, neg_lam5_22, lam4_31, neg_lam4_32, lam5_13, t2, t3, t4, t5
    real(rk) :: t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22
    real(rk) :: nc6_z, lam5_11, lam5_23, t23, lam4_11, lam4_13, neg_lam4_23, t24, t25, t26, t27
    real(rk) :: t28, t29, t30, t31, n5_z, t32, t33, t34, t35, t36, t37, t38, t39, t40, t41, t42
    real(rk) :: t43, t44, t45, t46, n3_x, t47, n4_z, t48, n3_y, n03_y, t49, t50, n1_z, t51, t52
    real(rk) :: n3_z, neg_lam3_11, t53, t54, t55, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_z*w3_y
    ww3_zx = w3_z*w3_x
    ww3_xy = w3_x*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = 2.0_rk*ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 - w3_z*s4
    w4_z = w3_y + qd(4)
    neg_w4_y = w3_x*s4 + w3_z*c4
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_xy = w4_x*neg_w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    neg_ww4_yz = w4_z*neg_w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_21 = ww3_zx + neg_ww4_xy
    lam4_12 = ww3_zx - neg_ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 + w4_z*s5
    w5_z = neg_w4_y + qd(5)
    w5_y = w4_z*c5 - w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    ww5_xy = w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww3_yz*c4 - qd(4)*neg_w4_y
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_y = ww3_zx*c5 + (w5_x*qd(5) + s5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx + neg_alpha5_y
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x - (ww3_zx*s5 - qd(5)*w5_y)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz + alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    t1 = 2.0_rk*(qd(2)*qd(1))
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_31 = s2*t1
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_y = ww3_yz*s4 + w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + neg_alpha4_y
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = w3_x*w3_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_zz + ww3_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - neg_alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx + neg_alpha4_y
    neg_lam4_32 = neg_ww4_yz - alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx - neg_alpha5_y
    t2 = 0.706845523804052_rk*c6 + 0.2821950289584464_rk*s6
    t3 = lam3_32 + lam2_31
    t4 = c2*(ww2_zz + neg_lam2_33)
    t5 = s2*ww2_zz - 21.77777777777778_rk
    t6 = ww3_xy - (c23*t4 + s23*t5)
    t7 = c4*t3 + s4*t6
    t8 = 0.47205526469446013_rk*c6 - 0.5674357966404597_rk*t2
    t9 = 0.706845523804052_rk*s6 - 0.2821950289584464_rk*c6
    t10 = s4*t3 - c4*t6
    t11 = s23*t4 - c23*t5
    t12 = t11 - neg_lam3_22
    t13 = c5*t10 - s5*t12
    t14 = 0.1601275610650136_rk*c6 + 0.07096581179296485_rk*s6
    t15 = 0.31005692653217237_rk*c6
    t16 = c6*t15
    t17 = s6*t15
    t18 = t16 + 0.8915767942352734_rk*(t17 + 0.1497864314188426_rk)
    t19 = t18 - 0.5771491392208791_rk
    t20 = t2*t7 - t8*lam5_12 - (t9*t13 - t14*lam5_32 + lam5_31*t18) - t19*lam5_13
    t21 = t17 - 0.8915767942352734_rk*(t16 - 0.15502846326608619_rk)
    t22 = ww5_xx - ww5_zz
    ! link 6: moment that turns the link [N m]
    nc6_z = t20 - t21*t22
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_11 = t22 - neg_lam4_22
    lam5_23 = ww5_yz - alpha5_x
    t23 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t23 - neg_lam3_22
    lam4_13 = ww4_zx - neg_alpha4_y
    neg_lam4_23 = neg_ww4_yz + alpha4_x
    t24 = ww5_zz - ww6_zz
    t25 = t24 + t22
    t26 = 2.0_rk*w6_z
    t27 = w5_x*t26 - lam5_12
    t28 = lam5_32 - w5_z*t26
    t29 = s5*t10 + c5*t12
    t30 = t2 + 0.40383849355176565_rk
    t31 = t28*t21 - (t29*t30 - 0.3630349860955984_rk*(t13 + 1.3700772574428703_rk*lam5_21 + &
        0.06176536813376437_rk*lam5_23)) - 0.09969734753381411_rk*lam5_12
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t14*t25 + (t18*t27 + t31) + 0.04994749004669093_rk*(neg_lam5_22 + lam5_11) + &
        lam5_13*(t8 - 0.06545842652927093_rk)
    t32 = t9 - 0.48442678791853194_rk
    t33 = t32*t29 + (t28*t19 + (t24*t8 - 0.09969734753381411_rk*lam5_32) - &
        0.3630349860955984_rk*t7 + 0.022422989561630666_rk*lam5_21)
    t34 = t27*t21 - t33 - 0.06545842652927093_rk*(neg_lam4_22 - neg_lam5_22) - lam5_31*(t14 + &
        0.04994749004669093_rk)
    t35 = nc6_z + 0.022422989561630666_rk*(t22 - 22.18196537703319_rk*lam5_31) + &
        0.40383849355176565_rk*(t7 + 0.16209060694923627_rk*lam5_12 + 1.1995557522463771_rk*(t13 + &
        0.10310637498248922_rk*lam5_32))
    t36 = neg_lam4_22 - neg_lam3_22
    t37 = c5*t34 + 4.226760246817004_rk*(t7 + 0.02172277440959994_rk*lam4_31) - (s5*t35 - &
        0.02981305527252843_rk*t36 + 0.7570061710726514_rk*neg_lam4_32)
    t38 = t37 + 0.1094831940191231_rk*neg_lam4_21
    t39 = t2*(neg_lam5_22 - t25) - 0.40383849355176565_rk*lam5_11 + 0.3630349860955984_rk*lam5_12 &
        + t32*lam5_13
    t40 = t2*t27 + 0.3630349860955984_rk*(neg_lam5_22 + 1.1123955238997885_rk*lam5_21) + t28*t9 + &
        0.48442678791853194_rk*lam5_23
    t41 = c5*t39 + (s5*t40 + 0.09791727023389989_rk*lam4_11 + 4.226760246817004_rk*lam4_13)
    t42 = t9*(t24 - neg_lam5_22) + 0.3630349860955984_rk*lam5_32 + &
        4.226760246817004_rk*neg_lam4_23 + 0.09791727023389989_rk*neg_lam4_21 + &
        0.48442678791853194_rk*neg_lam4_22
    t43 = t42 - lam5_31*t30
    t44 = s4*t41 - (c4*t43 + 0.13117102544002893_rk*ww3_zx)
    t45 = n5_z + 0.09791727023389989_rk*t12 + 4.226760246817004_rk*(t10 - &
        0.007053405807670163_rk*lam4_12) - 0.1094831940191231_rk*(t23 + &
        0.838639757888625_rk*neg_lam4_32 - 1.7233791487368413_rk*lam4_31)
    t46 = neg_lam2_33 - neg_lam3_22
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = c4*t38 - 6.114864278097191_rk*ww3_yz - (t44 - s4*t45 + 0.0672049454639226_rk*t46) - &
        0.1093030288471206_rk*ww3_xy
    t47 = s5*t34 - 0.1094831940191231_rk*neg_lam4_23 - 0.09181695932507075_rk*(t36 + t23) - &
        0.1886810537096668_rk*neg_lam4_21 - 0.02981305527252843_rk*lam4_13
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t47 + (c5*t35 - 0.09791727023389989_rk*t7 - 0.7570061710726514_rk*lam4_12)
    t48 = ww3_zz - ww3_xx
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = n4_z - 0.1093030288471206_rk*(t48 - 0.6148498003465253_rk*ww3_xy) + &
        0.1800707921647878_rk*(lam2_31 - 0.7284414305235613_rk*ww3_yz - &
        2.138281422904128_rk*ww3_zx)
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t49 = 0.6711330317943448_rk*(c2*c2) - 0.3355665158971724_rk + 4.09673559354447_rk*(c2*s2)
    t50 = s2 - 0.18233779228447872_rk*c2
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n03_y - (t1*t49 - 0.09496171507178643_rk*(ww2_zz*t50) - c2*(t44 + &
        0.49131260976960456_rk*ww3_zx))
    t51 = c4*t41 + s4*t43
    t52 = t46 + t48
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 3.249953153895394_rk*ww3_xy - (s4*t38 + (t51 - (c4*t45 - 0.1800707921647878_rk*t11 + &
        0.06558551272001446_rk*t52)))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = neg_lam3_22 + t52
    t53 = c5*t40 - s5*t39 - 0.09791727023389989_rk*lam4_31 + 4.226760246817004_rk*(neg_lam3_22 + &
        0.04260255648528718_rk*ww3_xy)
    t54 = t51 + 0.1800707921647878_rk*neg_lam3_11
    t55 = neg_lam2_33*t49 - (c2*(c23*t53 - s23*t54) - n3_z) - s2*(c23*t54 + s23*t53)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t55 + 461.83814650785126_rk*(s2 - 0.962530947463436_rk*t50)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 105 multiplications, 94 additions = 199; 1 unary minus; 10 sine/cosine
  pure subroutine rx90_mass_matrix(q, M) &
      bind(c, name="rx90_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, c6, s6, angle23, c23, s23, k6_xz, t1, t2, neg_h6_y, t3
    real(rk) :: h6_x, t4, neg_h5_x, t5, t6, h4_x, h5_y, k6_yz, t7, t8, t9, t10, t11, neg_k5_yz, t12
    real(rk) :: t13, t14, t15, t16, t17, t18, neg_k4_xz, k5_xz, m5_5, t19, m4_4, t20, t21, t22, t23
    real(rk) :: t24, t25, t26, t27, t28, t29, t30, t31, t32, t33, t34, t35, t36, t37, m1_1
    real(rk) :: neg_h4_y, t38, m3_4, neg_k3_yz, neg_k2_yz, nu2_y, nu3_y, fu5_x, fu4_y, nu5_y, nu5_x
    real(rk) :: nu4_x, h3_y, m3_3, t39, t40, m2_3, m2_2, t41, m2_4, m3_5, neg_fu4_x, m2_5, fu5_y
    real(rk) :: t42, m3_6, fu3_x, m2_6, t43, t44, t45

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
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = -0.07096581179296485_rk*s6 - 0.1601275610650136_rk*c6
    t1 = 0.3992315427559742_rk*k6_xz
    t2 = 0.1884593515900491_rk*s6 + t1
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_y = 9.809478269877111_rk*t2
    t3 = 0.007037838551227997_rk*c6
    h6_x = 22.13414869766047_rk*(t1 - t3)
    t4 = 0.8974188745594792_rk - h6_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_x = 0.8067444135457743_rk*s5 + c5*t4
    t5 = neg_h6_y - 1.0765039731522932_rk
    t6 = neg_h5_x - 0.21759393385311085_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t5 - c4*t6
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_y = 0.8067444135457743_rk*c5 - s5*t4
    ! link 6: second moment of the composite body [kg m^2]
    k6_yz = t3 - t2
    t7 = 0.31005692653217237_rk*c6
    t8 = s6*t7 + 0.1157967907323673_rk
    t9 = c6*t7
    t10 = t8 - 0.8915767942352734_rk*t9
    t11 = k6_yz - 0.06545842652927093_rk
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = s5*t10 + c5*t11
    t12 = neg_k5_yz + 0.02981305527252843_rk
    t13 = c5*s5
    t14 = t9 + (0.8915767942352734_rk*t8 - 1.303850935413074_rk)
    t15 = t14 + 1.7318439408653845_rk
    t16 = c5*c5
    t17 = 0.09989498009338187_rk - k6_xz - k6_xz
    t18 = t13*t15 - ((t16 - 0.5_rk)*t17 - 0.1094831940191231_rk)
    ! link 4: second moment of the composite body [kg m^2]
    neg_k4_xz = s4*t12 - c4*t18
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = s5*t11 - c5*t10
    ! link 5: mass matrix, its row of this joint
    m5_5 = t14 + 1.9312386359330127_rk
    t19 = t13*t17 + (t15*t16 + 0.2883784012434809_rk)
    ! link 4: mass matrix, its row of this joint
    m4_4 = t19 - t14
    t20 = 0.45_rk*c2
    t21 = c23*t20
    t22 = h4_x - 0.4001573159217507_rk
    t23 = s23*t20
    t24 = h5_y + 9.392800548482231_rk
    t25 = t21*t22 - t23*t24
    t26 = 0.45_rk*h4_x
    t27 = neg_k4_xz - t26
    t28 = t25 + (t27 - 0.06558551272001446_rk)*(c23*s23)
    t29 = 0.09496171507178643_rk*c2
    t30 = c4*s4
    t31 = 0.1836339186501415_rk - 2.0_rk*k5_xz
    t32 = c4*c4
    t33 = t14 + t19
    t34 = t14 - 0.19252101484679798_rk + t30*t31 - t32*t33
    t35 = 0.45_rk*h5_y
    t36 = t35 + m5_5
    t37 = t35 + 5.584769408295079_rk + t36 - t19
    ! link 1: mass matrix, its row of this joint
    m1_1 = t28 + (t29*(43.140918321110114_rk*c2 - 7.0674063888484_rk*s2) + (t28 + &
        1.3797143428523535_rk)) + ((t34 + t37)*(s23*s23) + m4_4)
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    neg_h4_y = c4*t5 + s4*t6
    t38 = 0.45_rk*neg_h4_y
    ! link 3: mass matrix, its row of this joint
    m3_4 = c4*t12 - (t38 - s4*t18)
    ! link 3: second moment of the composite body [kg m^2]
    neg_k3_yz = s23*(t30*t33 + (k5_xz + (t31*t32 - 0.20111998817219134_rk))) + c23*(m3_4 - &
        0.0672049454639226_rk)
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_yz = neg_k3_yz - t29 - s2*(t38 + 0.017315109477737248_rk)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s23*t27 + c2*t26 + c23*m4_4
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*neg_k5_yz + s23*(s4*t36 - c4*k5_xz)
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = 0.5771491392208791_rk*c5 - s5*k6_xz
    nu5_x = -0.5771491392208791_rk*s5 - c5*k6_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = s4*k6_yz + c4*nu5_x
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = c23*t24 + s23*t22
    ! link 3: mass matrix, its row of this joint
    m3_3 = t37 - t34
    t39 = 0.45_rk*s2
    t40 = t25 + t39*h3_y
    ! link 2: mass matrix, its row of this joint
    m2_3 = t40 + m3_3
    m2_2 = t40 + (m2_3 + 5.195184633739834_rk)
    t41 = c23*t39 - t23
    m2_4 = m3_4 - neg_h4_y*t41
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t36 + s4*k5_xz
    ! link 4: force for a unit acceleration of a joint further out
    neg_fu4_x = c4*h5_y
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + neg_h5_x*(-s23*t39 - t21) + t41*neg_fu4_x
    ! link 5: force for a unit acceleration of a joint further out
    fu5_y = s5*neg_h6_y
    t42 = c4*fu5_x - s4*h6_x
    ! link 3: mass matrix, its row of this joint
    m3_6 = c4*k6_yz - 0.45_rk*t42 - s4*nu5_x
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*t42 - s23*fu5_y
    ! link 2: mass matrix, its row of this joint
    m2_6 = t21*fu5_y + m3_6 + (t23*t42 - t39*fu3_x)
    t43 = nu3_y - s4*(c2*t35)
    t44 = 0.45_rk*fu4_y
    t45 = c2*t44 + (c23*nu5_y - s23*(t44 - nu4_x))
    M(1) = m1_1
    M(2) = neg_k2_yz
    M(3) = neg_k3_yz
    M(4) = nu2_y
    M(5) = t43
    M(6) = t45
    M(7) = neg_k2_yz
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = m2_6
    M(13) = neg_k3_yz
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = m3_6
    M(19) = nu2_y
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = neg_k5_yz
    M(24) = nu5_y
    M(25) = t43
    M(26) = m2_5
    M(27) = m3_5
    M(28) = neg_k5_yz
    M(29) = m5_5
    M(30) = k6_yz
    M(31) = t45
    M(32) = m2_6
    M(33) = m3_6
    M(34) = nu5_y
    M(35) = k6_yz
    M(36) = 0.5771491392208791_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 376 multiplications, 336 additions, 5 divisions = 717; 14 unary minus; 10 sine/cosine
  pure subroutine rx90_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="rx90_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: w3_z, angle23, s23, w3_x, c23, w3_y, ww3_yz, ww3_zx, ww3_xy, ww3_zz, lam3_32, c4
    real(rk) :: s4, w4_x, w4_z, w4_y, ww4_xy, ww4_xx, ww4_zz, ww4_yz, ww4_zx, lam4_21, lam4_12
    real(rk) :: neg_lam4_22, c5, s5, w5_x, w5_z, w5_y, ww5_zx, ww5_xx, ww5_zz, ww5_yz, ww5_xy, w6_z
    real(rk) :: c6, s6, c2, s2, alpha4_x, neg_alpha5_y, lam5_31, alpha5_x, lam5_32, ww6_zz, t1
    real(rk) :: lam2_31, ww2_zz, lam2_33, neg_alpha4_y, lam5_21, ww3_xx, lam3_22, lam5_12
    real(rk) :: neg_lam5_22, lam4_31, lam4_32, lam5_13, k6_xz, t2, t3, t4, t5, t6, t7, t8, t9, t10
    real(rk) :: t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, nc6_z, neg_lam5_11
    real(rk) :: lam5_23, t23, lam4_11, lam4_13, lam4_23, t24, t25, t26, t27, t28, t29, t30, t31
    real(rk) :: n5_z, t32, t33, t34, t35, t36, t37, t38, t39, t40, t41, t42, t43, t44, t45, t46
    real(rk) :: n3_x, t47, n4_z, t48, n3_y, n03_y, t49, t50, n1_z, t51, t52, n3_z, lam3_11, t53
    real(rk) :: t54, t55, n02_z, t56, t57, neg_h6_y, t58, h6_x, t59, h5_x, t60, t61, h4_x, neg_h5_y
    real(rk) :: k6_yz, t62, t63, k5_yz, t64, t65, t66, t67, t68, t69, t70, k4_xz, k5_xz, m5_5, t71
    real(rk) :: m4_4, t72, t73, t74, t75, t76, t77, t78, t79, t80, t81, t82, t83, t84, t85, t86
    real(rk) :: t87, t88, m1_1, h4_y, t89, m3_4, k3_yz, k2_yz, nu2_y, nu3_y, fu5_x, fu4_y, nu5_y
    real(rk) :: nu5_x, nu4_x, h3_y, neg_m3_3, t90, t91, m2_3, m2_2, t92, m2_4, m3_5, fu4_x, m2_5
    real(rk) :: fu5_y, t93, m3_6, fu3_x, m2_6, t94, ud1_6, y6, u5_6, u4_6, u3_6, u2_6, u1_6, pivot5
    real(rk) :: ipivot5, ud4_5, u4_5, neg_ud3_5, u3_5, ud2_5, u2_5, ud1_5, u1_5, t95, pivot4
    real(rk) :: ipivot4, ud3_4, u3_4, ud2_4, u2_4, ud1_4, u1_4, pivot3, ipivot3, ud2_3, u2_3, ud1_3
    real(rk) :: u1_3, pivot2, ipivot2, ud1_2, u1_2, pivot1, ipivot1, y5, y4, y3, y2, y1, qdd1, qdd2
    real(rk) :: qdd3, qdd4, qdd5, qdd6

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yz = w3_z*w3_y
    ww3_zx = w3_z*w3_x
    ww3_xy = w3_x*w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = 2.0_rk*ww3_yz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w3_x*c4 - w3_z*s4
    w4_z = w3_y + qd(4)
    w4_y = -w3_z*c4 - w3_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xy = w4_x*w4_y
    ww4_xx = w4_x*w4_x
    ww4_zz = w4_z*w4_z
    ww4_yz = w4_z*w4_y
    ww4_zx = w4_x*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_21 = ww4_xy - ww3_zx
    lam4_12 = ww3_zx + ww4_xy
    neg_lam4_22 = ww4_xx + ww4_zz
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 + w4_z*s5
    w5_z = qd(5) - w4_y
    w5_y = w4_z*c5 - w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ww5_yz = w5_z*w5_y
    ww5_xy = w5_x*w5_y
    ! link 6: angular velocity [rad/s]
    w6_z = w5_y + qd(6)
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww3_yz*c4 + qd(4)*w4_y
    ! link 5: angular acceleration [rad/s^2]
    neg_alpha5_y = ww3_zx*c5 + (w5_x*qd(5) + s5*alpha4_x)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_31 = ww5_zx + neg_alpha5_y
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = c5*alpha4_x - (ww3_zx*s5 - qd(5)*w5_y)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = ww5_yz + alpha5_x
    ! link 6: products of the angular velocity [1/s^2]
    ww6_zz = w6_z*w6_z
    t1 = 2.0_rk*(qd(2)*qd(1))
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_31 = s2*t1
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 4: angular acceleration [rad/s^2]
    neg_alpha4_y = ww3_yz*s4 + w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_21 = ww5_xy + neg_alpha4_y
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = w3_x*w3_x
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = -ww3_zz - ww3_xx
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - neg_alpha4_y
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_31 = ww4_zx + neg_alpha4_y
    lam4_32 = ww4_yz + alpha4_x
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_13 = ww5_zx - neg_alpha5_y
    ! link 6: second moment of the composite body [kg m^2]
    k6_xz = -0.07096581179296485_rk*s6 - 0.1601275610650136_rk*c6
    t2 = 0.706845523804052_rk*c6 + 0.2821950289584464_rk*s6
    t3 = lam3_32 + lam2_31
    t4 = c2*(ww2_zz - lam2_33)
    t5 = s2*ww2_zz - 21.77777777777778_rk
    t6 = ww3_xy - (c23*t4 + s23*t5)
    t7 = c4*t3 + s4*t6
    t8 = 0.47205526469446013_rk*c6 - 0.5674357966404597_rk*t2
    t9 = 0.706845523804052_rk*s6 - 0.2821950289584464_rk*c6
    t10 = s4*t3 - c4*t6
    t11 = c23*t5 - s23*t4
    t12 = t11 - lam3_22
    t13 = c5*t10 + s5*t12
    t14 = 0.31005692653217237_rk*c6
    t15 = c6*t14
    t16 = s6*t14
    t17 = t15 + 0.8915767942352734_rk*(t16 + 0.1497864314188426_rk)
    t18 = t17 - 0.5771491392208791_rk
    t19 = t2*t7 - lam5_12*t8 - (t9*t13 + lam5_32*k6_xz + lam5_31*t17) - lam5_13*t18
    t20 = 0.8915767942352734_rk*t15
    t21 = t16 - (t20 - 0.13821978029399798_rk)
    t22 = ww5_xx - ww5_zz
    ! link 6: moment that turns the link [N m]
    nc6_z = t19 - t21*t22
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_11 = neg_lam4_22 - t22
    lam5_23 = ww5_yz - alpha5_x
    t23 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = lam3_22 + t23
    lam4_13 = ww4_zx - neg_alpha4_y
    lam4_23 = ww4_yz - alpha4_x
    t24 = 2.0_rk*w6_z
    t25 = lam5_32 - w5_z*t24
    t26 = s5*t10 - c5*t12
    t27 = t2 + 0.40383849355176565_rk
    t28 = t21*t25 - (t26*t27 - 0.022422989561630666_rk*(lam5_23 + 22.18196537703319_rk*(lam5_21 + &
        0.7298858473619311_rk*t13))) - 0.09969734753381411_rk*lam5_12
    t29 = lam5_12 - w5_x*t24
    t30 = ww5_zz - ww6_zz
    t31 = t22 + t30
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t28 - t17*t29 - k6_xz*t31 + 0.04994749004669093_rk*(neg_lam5_22 - neg_lam5_11) + &
        lam5_13*(t8 - 0.06545842652927093_rk)
    t32 = t9 - 0.48442678791853194_rk
    t33 = t26*t32 + (t18*t25 + (t8*t30 - 0.09969734753381411_rk*lam5_32) - &
        0.3630349860955984_rk*t7 + 0.022422989561630666_rk*lam5_21)
    t34 = t21*t29 + t33 + 0.06545842652927093_rk*(neg_lam4_22 - neg_lam5_22) + &
        lam5_31*(0.04994749004669093_rk - k6_xz)
    t35 = nc6_z - 0.4973859781056681_rk*(lam5_31 - 0.04508166805793422_rk*t22) + &
        0.48442678791853194_rk*(t13 + 0.10310637498248922_rk*lam5_32 + &
        0.13512553013538_rk*(lam5_12 + 6.169388953631232_rk*t7))
    t36 = neg_lam4_22 + lam3_22
    t37 = c5*t34 - 0.09181695932507075_rk*(lam4_31 + 46.034635408176506_rk*t7) + (s5*t35 - &
        0.02981305527252843_rk*t36 - 0.7570061710726514_rk*lam4_32)
    t38 = t37 + 0.1094831940191231_rk*lam4_21
    t39 = 0.40383849355176565_rk*neg_lam5_11 - t2*(t31 - neg_lam5_22) + &
        0.3630349860955984_rk*lam5_12 + lam5_13*t32
    t40 = t2*t29 - 0.40383849355176565_rk*(lam5_21 + 0.8989608268956737_rk*neg_lam5_22) - t9*t25 - &
        0.48442678791853194_rk*lam5_23
    t41 = c5*t39 - (s5*t40 - 0.09791727023389989_rk*lam4_11 - 4.226760246817004_rk*lam4_13)
    t42 = -0.3630349860955984_rk*lam5_32 - t9*(t30 - neg_lam5_22) + 4.226760246817004_rk*lam4_23 + &
        0.09791727023389989_rk*lam4_21 - 0.48442678791853194_rk*neg_lam4_22
    t43 = t42 + lam5_31*t27
    t44 = s4*t41 + (c4*t43 - 0.13117102544002893_rk*ww3_zx)
    t45 = n5_z - 0.09791727023389989_rk*t12 - 0.02981305527252843_rk*(lam4_12 - &
        141.7754808482108_rk*t10) + 0.1886810537096668_rk*(lam4_31 - &
        0.4866252202849906_rk*(1.1924070980341053_rk*t23 - lam4_32))
    t46 = lam3_22 - lam2_33
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = -0.1093030288471206_rk*ww3_xy - (c4*t38 + 6.114864278097191_rk*ww3_yz + (t44 - s4*t45 + &
        0.0672049454639226_rk*t46))
    t47 = s5*t34 - 0.1094831940191231_rk*lam4_23 + 0.09181695932507075_rk*(t23 + t36) - &
        0.1886810537096668_rk*lam4_21 + 0.02981305527252843_rk*lam4_13
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = c5*t35 - 0.09791727023389989_rk*t7 - 0.7570061710726514_rk*lam4_12 - t47
    t48 = ww3_zz - ww3_xx
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = n4_z + 0.0672049454639226_rk*(ww3_xy - 1.6264134743744028_rk*t48) - &
        0.38504202969359597_rk*(ww3_zx + 0.3406667722596689_rk*(ww3_yz - &
        1.3727939654410626_rk*lam2_31))
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = s23*n3_x + c23*n3_y
    t49 = 0.6711330317943448_rk*(c2*c2 - 0.5_rk) + 4.09673559354447_rk*(c2*s2)
    t50 = s2 - 0.18233779228447872_rk*c2
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = n03_y - (t1*t49 - 0.09496171507178643_rk*(ww2_zz*t50) - c2*(t44 + &
        0.49131260976960456_rk*ww3_zx))
    t51 = c4*t41 - s4*t43
    t52 = t46 + t48
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = s4*t38 - (t51 - (c4*t45 + 0.1800707921647878_rk*t11 + 0.06558551272001446_rk*t52)) + &
        3.249953153895394_rk*ww3_xy
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_11 = lam3_22 - t52
    t53 = c5*t40 + s5*t39 + 0.09791727023389989_rk*lam4_31 - 0.1800707921647878_rk*(ww3_xy - &
        23.472769770174487_rk*lam3_22)
    t54 = t51 - 0.1800707921647878_rk*lam3_11
    t55 = n3_z + c2*(c23*t53 + s23*t54) - lam2_33*t49 - s2*(c23*t54 - s23*t53)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t55 - 444.53350873295926_rk*(t50 - 1.0389276341039282_rk*s2)
    t56 = 0.3992315427559742_rk*k6_xz
    t57 = 0.1884593515900491_rk*s6 + t56
    ! link 6: first moment of the composite body, about the frame's origin [kg m]
    neg_h6_y = 9.809478269877111_rk*t57
    t58 = 0.007037838551227997_rk*c6
    h6_x = 22.13414869766047_rk*(t56 - t58)
    t59 = 0.8974188745594792_rk - h6_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = -0.8067444135457743_rk*s5 - c5*t59
    t60 = neg_h6_y - 1.0765039731522932_rk
    t61 = h5_x + 0.21759393385311085_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = s4*t60 + c4*t61
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_y = s5*t59 - 0.8067444135457743_rk*c5
    ! link 6: second moment of the composite body [kg m^2]
    k6_yz = t58 - t57
    t62 = t20 - (t16 + 0.1157967907323673_rk)
    t63 = 0.06545842652927093_rk - k6_yz
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = s5*t62 + c5*t63
    t64 = k5_yz - 0.02981305527252843_rk
    t65 = c5*s5
    t66 = t15 + 0.8915767942352734_rk*(t16 - 1.346613339099935_rk)
    t67 = t66 + 1.7318439408653845_rk
    t68 = c5*c5
    t69 = 0.09989498009338187_rk - k6_xz - k6_xz
    t70 = t65*t67 + ((0.5_rk - t68)*t69 + 0.1094831940191231_rk)
    ! link 4: second moment of the composite body [kg m^2]
    k4_xz = s4*t64 + c4*t70
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = c5*t62 - s5*t63
    ! link 5: mass matrix, its row of this joint
    m5_5 = t66 + 1.9312386359330127_rk
    t71 = t65*t69 + (t67*t68 + 0.2883784012434809_rk)
    ! link 4: mass matrix, its row of this joint
    m4_4 = t71 - t66
    t72 = 0.45_rk*c2
    t73 = c23*t72
    t74 = h4_x - 0.4001573159217507_rk
    t75 = s23*t72
    t76 = neg_h5_y - 9.392800548482231_rk
    t77 = t73*t74 + t75*t76
    t78 = 0.45_rk*h4_x
    t79 = k4_xz + t78
    t80 = t77 - (t79 + 0.06558551272001446_rk)*(s23*c23)
    t81 = c4*s4
    t82 = 0.1836339186501415_rk - 2.0_rk*k5_xz
    t83 = c4*c4
    t84 = t66 + t71
    t85 = t66 - 0.19252101484679798_rk + t81*t82 - t83*t84
    t86 = 0.45_rk*neg_h5_y
    t87 = m5_5 - t86
    t88 = t71 + (t86 - 5.584769408295079_rk - t87)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t80 + (t80 + 1.3797143428523535_rk + 4.09673559354447_rk*(c2*(c2 - &
        0.1638214174358479_rk*s2))) + (m4_4 + (t85 - t88)*(s23*s23))
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_y = s4*t61 - c4*t60
    t89 = 0.45_rk*h4_y
    ! link 3: mass matrix, its row of this joint
    m3_4 = s4*t70 + t89 - c4*t64
    ! link 3: second moment of the composite body [kg m^2]
    k3_yz = c23*(0.0672049454639226_rk - m3_4) - s23*(t81*t84 + (k5_xz + (t82*t83 - &
        0.20111998817219134_rk)))
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = k3_yz + 0.09496171507178643_rk*c2 + s2*(0.017315109477737248_rk - t89)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = c23*m4_4 - (s23*t79 - c2*t78)
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = s23*(s4*t87 - c4*k5_xz) - c23*k5_yz
    ! link 5: force for a unit acceleration of a joint further out
    fu5_x = c5*neg_h6_y
    ! link 4: force for a unit acceleration of a joint further out
    fu4_y = s4*fu5_x + c4*h6_x
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = 0.5771491392208791_rk*c5 - s5*k6_xz
    nu5_x = -0.5771491392208791_rk*s5 - c5*k6_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = s4*k6_yz + c4*nu5_x
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t74 - c23*t76
    ! link 3: mass matrix, its row of this joint
    neg_m3_3 = t85 + t88
    t90 = 0.45_rk*s2
    t91 = t77 + h3_y*t90
    ! link 2: mass matrix, its row of this joint
    m2_3 = t91 - neg_m3_3
    m2_2 = t91 + (m2_3 + 5.195184633739834_rk)
    t92 = t75 - c23*t90
    m2_4 = m3_4 - h4_y*t92
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t87 + s4*k5_xz
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + h5_x*(t73 + s23*t90) + t92*fu4_x
    ! link 5: force for a unit acceleration of a joint further out
    fu5_y = s5*neg_h6_y
    t93 = c4*fu5_x - s4*h6_x
    ! link 3: mass matrix, its row of this joint
    m3_6 = -s4*nu5_x - (0.45_rk*t93 - c4*k6_yz)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*t93 - s23*fu5_y
    ! link 2: mass matrix, its row of this joint
    m2_6 = m3_6 + t73*fu5_y + (t75*t93 - t90*fu3_x)
    t94 = 0.45_rk*fu4_y
    ! factorisation M = U D U^T
    ud1_6 = c2*t94 + (c23*nu5_y - s23*(t94 - nu4_x))
    ! link 6: forward substitution
    y6 = tau(6) - nc6_z
    ! factorisation M = U D U^T
    u5_6 = 1.7326544077496977_rk*k6_yz
    u4_6 = 1.7326544077496977_rk*nu5_y
    u3_6 = 1.7326544077496977_rk*m3_6
    u2_6 = 1.7326544077496977_rk*m2_6
    u1_6 = 1.7326544077496977_rk*ud1_6
    pivot5 = m5_5 - k6_yz*u5_6
    ipivot5 = 1.0_rk / pivot5
    ud4_5 = -k5_yz - k6_yz*u4_6
    u4_5 = ipivot5*ud4_5
    neg_ud3_5 = k6_yz*u3_6 - m3_5
    u3_5 = -ipivot5*neg_ud3_5
    ud2_5 = m2_5 - k6_yz*u2_6
    u2_5 = ipivot5*ud2_5
    ud1_5 = nu3_y + s4*(c2*t86) - k6_yz*u1_6
    u1_5 = ipivot5*ud1_5
    t95 = -ud4_5
    pivot4 = t95*u4_5 - (nu5_y*u4_6 - m4_4)
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = m3_4 - nu5_y*u3_6 - ud4_5*u3_5
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 - nu5_y*u2_6 - ud4_5*u2_5
    u2_4 = ipivot4*ud2_4
    ud1_4 = t95*u1_5 - (nu5_y*u1_6 - nu2_y)
    u1_4 = ipivot4*ud1_4
    pivot3 = neg_ud3_5*u3_5 - (neg_m3_3 + m3_6*u3_6) - ud3_4*u3_4
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = neg_ud3_5*u2_5 - (m3_6*u2_6 - m2_3) - ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    ud1_3 = neg_ud3_5*u1_5 - (k3_yz + m3_6*u1_6) - ud3_4*u1_4
    u1_3 = ipivot3*ud1_3
    pivot2 = m2_2 - m2_6*u2_6 - ud2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = -ud2_5*u1_5 - (k2_yz + m2_6*u1_6) - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - ud1_6*u1_6 - ud1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 5: forward substitution
    y5 = -y6*u5_6 - (n5_z - tau(5))
    ! link 4: forward substitution
    y4 = tau(4) - n4_z - y6*u4_6 - u4_5*y5
    ! link 3: forward substitution
    y3 = -u3_4*y4 - (n3_z - tau(3) + y6*u3_6 + u3_5*y5)
    ! link 2: forward substitution
    y2 = -u2_4*y4 - (n02_z - tau(2) + y6*u2_6 + u2_5*y5) - u2_3*y3
    ! link 1: forward substitution
    y1 = tau(1) - n1_z - y6*u1_6 - u1_5*y5 - u1_4*y4 - u1_3*y3 - u1_2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -u1_4*qdd1 - (u3_4*qdd3 - ipivot4*y4 + u2_4*qdd2)
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = -(u4_5*qdd4 - ipivot5*y5 + u3_5*qdd3 + u2_5*qdd2) - u1_5*qdd1
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = -u1_6*qdd1 - (u5_6*qdd5 - 1.7326544077496977_rk*y6 + u4_6*qdd4 + u3_6*qdd3 + u2_6*qdd2)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
