! puma560_rotor_in_link: PUMA 560, Tables 2.1, 2.5, 2.6, rotor folded into Izz as the thesis does
! Numbers: Tables 2.1, 2.5, 2.6 with links 5 and 6 corrected
! Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 3944b9c8df3efa29ca11b7e595201cb9 (a hash of its numbers)
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
!   to the recursion without being written like it: robodyn --optimize full, seed 3.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 139 multiplications, 115 additions = 254; 0 unary minus; 8 sine/cosine
!   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
!   bias: 125 multiplications, 90 additions = 215; 1 unary minus; 8 sine/cosine
!   mass_matrix: 60 multiplications, 54 additions = 114; 0 unary minus; 8 sine/cosine
!   forward_dynamics: 247 multiplications, 201 additions, 4 divisions = 452; 3 unary minus; 8
!       sine/cosine
module puma560_rotor_in_link_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_rotor_in_link_inverse_dynamics
  public :: puma560_rotor_in_link_gravity
  public :: puma560_rotor_in_link_bias
  public :: puma560_rotor_in_link_mass_matrix
  public :: puma560_rotor_in_link_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 139 multiplications, 115 additions = 254; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_rotor_in_link_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_rotor_in_link_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, c23, neg_w3_y, s23, neg_w3_x, alpha3_z, neg_ww3_yz, neg_alpha3_x
    real(rk) :: neg_lam3_13, neg_ww3_zx, neg_alpha3_y, ww3_yy, ww3_zz, ww3_xy, neg_lam2_33
    real(rk) :: neg_lam3_11, neg_lam3_12, lam3_31, neg_lam3_32, lam3_21, s4, c4, w4_y, neg_w4_x
    real(rk) :: w4_z, alpha4_z, c5, s5, neg_w5_x, neg_w5_y, w5_z, ww5_xy, neg_ww5_zx, ww5_xx
    real(rk) :: ww5_zz, neg_lam5_22, w6_z, t1, n06_y, c2, s2, ww2_zz, alpha4_y, alpha5_z, lam5_12
    real(rk) :: alpha4_x, lam5_32, t2, neg_lam3_22, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13
    real(rk) :: t14, t15, t16, t17, n5_z, alpha5_y, n06_z, t18, t19, t20, t21, t22, t23, t24, t25
    real(rk) :: t26, t27, neg_n3_x, n4_z, n3_y, t28, t29, t30, t31, t32, t33, t34, t35, t36, t37
    real(rk) :: t38, n1_z, t39, n3_z, t40, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = c23*qd(1)
    ! sines and cosines of the joint angles
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = neg_ww3_yz + s23*qdd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_13 = c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_y = neg_lam3_13 - neg_ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_y*neg_w3_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_12 = alpha3_z - ww3_xy
    lam3_31 = neg_alpha3_y - neg_ww3_zx
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    lam3_21 = alpha3_z + ww3_xy
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = neg_alpha3_y + qdd(4)
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.19304_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = alpha3_z*c4 + (neg_alpha3_x*s4 + neg_w4_x*qd(4))
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = alpha3_z*s4 + (w4_y*qd(4) - neg_alpha3_x*c4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = c5*alpha4_x - (alpha4_z*s5 + neg_w5_y*(qd(5) + w5_z))
    t2 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam2_33 - t2
    t3 = 21.27093596059113_rk*c2
    t4 = 21.27093596059113_rk*s2
    t5 = t3*(neg_lam2_33 + ww2_zz) + qdd(2)*t4 + 7.394088669950739_rk*qdd(1)
    t6 = t4*ww2_zz - (qdd(2)*t3 - 482.7586206896552_rk)
    t7 = c23*t5 + s23*t6
    t8 = neg_lam3_11 + 21.334975369458128_rk*neg_lam3_12 - t7
    t9 = 2.0_rk*(qd(2)*qd(1))
    t10 = qdd(1)*t3 - 7.394088669950739_rk*neg_lam2_33 - t4*t9
    t11 = 21.334975369458128_rk*neg_lam3_32
    t12 = t11 - lam3_31
    t13 = t10 + t12
    t14 = c4*t8 + s4*t13
    t15 = 5.8464e-05_rk*c5
    t16 = 5.8464e-05_rk*s5
    t17 = lam3_21 - 21.334975369458128_rk*neg_lam3_22 - (s23*t5 - c23*t6)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t14*t15 + (n06_y + 0.17964216_rk*(alpha5_z - 0.0013480131835422152_rk*ww5_xy)) - &
        t16*t17
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) - s5*alpha4_x - alpha4_z*c5
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = 0.19304_rk*(qdd(6) - alpha5_y)
    t18 = 0.0005151125_rk*t14 - (neg_lam5_22*t16 + lam5_12*t15)
    t19 = s4*t8 - c4*t13
    t20 = -0.00054216_rk*lam5_32 - 0.00477684375_rk*t19
    t21 = 0.10783532536520585_rk*t20
    t22 = s4*t18 + c4*t21
    t23 = 3280.019999836749_rk*t22
    t24 = 0.2013_rk*alpha4_y + n5_z
    t25 = 0.1791_rk*neg_ww5_zx - (n06_z - 0.0003_rk*alpha5_y)
    t26 = t20 - (w5_z*(t1 - 0.1788_rk*neg_w5_y) - 0.00471837975_rk*t19)
    t27 = s5*t25 + (c5*t26 - 0.2013_rk*alpha4_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.006504526_rk*(t10 + t23) + s4*t24 - (0.004704_rk*t2 + &
        (-0.014170080666358808_rk*lam3_31 - (0.013853806666358808_rk*t12 + c4*t27)))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.2013_rk*alpha4_z + s5*t26 - c5*t25
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.004704_rk*neg_lam3_12 - n4_z + (t22 - 9.201024402078819_rk*neg_lam3_32 + &
        0.43125_rk*t12)
    t28 = 0.0011165940250115794_rk*(t3 + 545.6756980171745_rk*s2)
    t29 = c4*t18 - s4*t21
    t30 = t29 + 0.006504526_rk*neg_lam3_12
    t31 = t16*lam5_12 - neg_lam5_22*t15 + 0.0005151125_rk*t17
    t32 = 0.006504526_rk*neg_lam3_22 - t31
    t33 = c23*t30 - s23*t32
    t34 = 0.06435058403334877_rk*c2
    t35 = t3*t34
    t36 = t4*t34
    t37 = 7.394088669950739_rk*t33 - (ww2_zz*(0.609298224_rk*c2 - 0.023751_rk*s2) - c23*n3_y) - &
        qdd(1)*(t35 + 2.231693438_rk - 0.010372902938360292_rk*t36)
    t38 = 0.010372902938360292_rk*t35 + (t36 - 0.0070992_rk)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s23*neg_n3_x + qdd(2)*t28 - (t37 + (t9*t38 - 0.006485001909027938_rk*c2*(t11 + t23)))
    t39 = 21.334975369458128_rk*(t29 - 0.00030487618979450475_rk*t7) + (t31 + c4*t24) - (s4*t27 + &
        0.004704_rk*neg_lam3_13)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.8625_rk*(ww3_xy + 0.8426905785507246_rk*neg_lam3_12) - (0.000316274_rk*(neg_lam3_11 - &
        neg_lam3_22) - t39)
    t40 = n3_z + (neg_lam2_33*t38 + 6.225049952_rk*qdd(2) + t3*(s23*t30 + (c23*t32 - &
        1.5019138889382213_rk)))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t40 + (t28*(qdd(1) + 1.6791777157715793_rk) - t4*t33)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! torques that hold the arm at rest
  ! 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
  pure subroutine puma560_rotor_in_link_gravity(q, tau) &
      bind(c, name="puma560_rotor_in_link_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c5, hw5_y, c4, angle23, s23, c23, s5, hw5_x, tau5, s4, hw4_y, tau4, c2, s2, hw4_x
    real(rk) :: hw3_x, hw2_x, t1, t2

    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = -0.028224_rk*c5
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    c23 = cos(angle23)
    s5 = sin(q(5))
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_x = 0.028224_rk*s5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = hw5_y*(c4*s23) - c23*hw5_x
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = hw5_x*s4
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = s23*hw4_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = c4*hw5_x
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = c23*(hw4_x - 0.248675_rk) + s23*(8.445591_rk - hw5_y)
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = hw3_x + (37.196782_rk*c2 - 1.02312_rk*s2)
    t1 = -hw2_x
    t2 = -hw3_x
    tau(1) = 0.0_rk
    tau(2) = t1
    tau(3) = t2
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 125 multiplications, 90 additions = 215; 1 unary minus; 8 sine/cosine
  pure subroutine puma560_rotor_in_link_bias(q, qd, tau) &
      bind(c, name="puma560_rotor_in_link_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, c23, neg_w3_y, s23, neg_w3_x, neg_ww3_yz, neg_ww3_zx, ww3_yy, ww3_zz
    real(rk) :: ww3_xy, neg_lam2_33, neg_lam3_11, lam3_31, s4, c4, w4_y, neg_w4_x, w4_z, c5, s5
    real(rk) :: neg_w5_x, neg_w5_y, w5_z, ww5_xy, neg_ww5_zx, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1
    real(rk) :: n06_y, c2, s2, ww2_zz, alpha4_y, lam5_12, alpha4_x, lam5_32, t2, neg_lam3_22, t3
    real(rk) :: t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, n5_z, alpha5_y
    real(rk) :: n06_z, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, n3_x, n4_z, neg_n3_y, t28
    real(rk) :: t29, t30, t31, t32, t33, t34, t35, n1_z, t36, n3_z, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = c23*qd(1)
    ! sines and cosines of the joint angles
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_y*neg_w3_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_31 = -2.0_rk*neg_ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.19304_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_y*qd(4) - neg_ww3_yz*c4
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = neg_ww3_zx*s5 - neg_w5_y*(qd(5) + w5_z) + c5*alpha4_x
    t2 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam2_33 - t2
    t3 = 21.27093596059113_rk*c2
    t4 = t3*(neg_lam2_33 + ww2_zz)
    t5 = 21.27093596059113_rk*s2
    t6 = t5*ww2_zz + 482.7586206896552_rk
    t7 = c23*t4 + s23*t6
    t8 = neg_lam3_11 - 21.334975369458128_rk*ww3_xy - t7
    t9 = 2.0_rk*(qd(2)*qd(1))
    t10 = 7.394088669950739_rk*neg_lam2_33 + t5*t9
    t11 = 42.669950738916256_rk*neg_ww3_yz
    t12 = t11 - lam3_31
    t13 = t10 - t12
    t14 = c4*t8 - s4*t13
    t15 = 5.8464e-05_rk*c5
    t16 = 5.8464e-05_rk*s5
    t17 = ww3_xy - 21.334975369458128_rk*neg_lam3_22 - (s23*t4 - c23*t6)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t14*t15 + (n06_y + 0.17964216_rk*(alpha4_y - 0.0013480131835422152_rk*ww5_xy)) - &
        t16*t17
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd(5) - s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.19304_rk*alpha5_y
    t18 = 0.0005151125_rk*t14 - (neg_lam5_22*t16 + lam5_12*t15)
    t19 = s4*t8 + c4*t13
    t20 = 0.00054216_rk*lam5_32 + 0.00477684375_rk*t19
    t21 = 0.10783532536520585_rk*t20
    t22 = s4*t18 - c4*t21
    t23 = 3280.019999836749_rk*t22
    t24 = 0.2013_rk*alpha4_y + n5_z
    t25 = 0.1791_rk*neg_ww5_zx + 0.19334_rk*alpha5_y
    t26 = t20 + (w5_z*(t1 - 0.1788_rk*neg_w5_y) - 0.00471837975_rk*t19)
    t27 = s5*t25 - (c5*t26 + 0.2013_rk*alpha4_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = 0.006504526_rk*(t10 - t23) - s4*t24 + (0.004704_rk*t2 + &
        (0.028340161332717616_rk*neg_ww3_zx - (0.013853806666358808_rk*t12 + c4*t27)))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = -c5*t25 - (0.2013_rk*neg_ww3_zx + s5*t26)
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = 0.004704_rk*ww3_xy + n4_z - (t22 - 18.402048804157637_rk*neg_ww3_yz + &
        0.43125_rk*t12)
    t28 = 0.06435058403334877_rk*c2
    t29 = 0.010372902938360292_rk*(t3*t28) + (t5*t28 - 0.0070992_rk)
    t30 = c4*t18 + s4*t21
    t31 = t30 - 0.006504526_rk*ww3_xy
    t32 = t16*lam5_12 - neg_lam5_22*t15 + 0.0005151125_rk*t17
    t33 = 0.006504526_rk*neg_lam3_22 - t32
    t34 = c23*t31 - s23*t33
    t35 = 0.006485001909027938_rk*c2*(t11 + t23) - t9*t29 - (7.394088669950739_rk*t34 - &
        (ww2_zz*(0.609298224_rk*c2 - 0.023751_rk*s2) + c23*neg_n3_y))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t35 - s23*n3_x
    t36 = 0.000316274_rk*(neg_lam3_11 - neg_lam3_22) - (21.334975369458128_rk*(t30 - &
        0.00030487618979450475_rk*t7) + (t32 + c4*t24) - s4*t27)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.135679376_rk*ww3_xy - t36
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n3_z + (neg_lam2_33*t29 + t3*(s23*t31 + (c23*t33 - 1.5019138889382213_rk))) + &
        (0.0018749598043631376_rk*(t3 + 545.6756980171745_rk*s2) - t5*t34)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 60 multiplications, 54 additions = 114; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_rotor_in_link_mass_matrix(q, M) &
      bind(c, name="puma560_rotor_in_link_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, neg_nu5_y, h5_x, neg_h5_y, h4_x, h4_y
    real(rk) :: t1, t2, t3, h3_x, h3_y, t4, t5, m4_4, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15
    real(rk) :: t16, t17, t18, t19, t20, m1_1, m3_4, t21, k3_yz, m1_3, t22, t23, m1_2, m1_4, t24
    real(rk) :: neg_fu3_x, t25, nu3_y, t26, nu2_y, m1_5, m3_3, t27, m2_3, m2_2, m2_4, m3_5, fu3_y
    real(rk) :: m2_5, nu4_y, t28

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.19304_rk*c5
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t1 = h4_x - 0.025375_rk
    t2 = neg_h5_y + 0.861795_rk
    t3 = s23*t2
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t1 + t3
    h3_y = s23*t1 - c23*t2
    t4 = 66.94369444444445_rk*c5
    t5 = neg_h5_y*t4
    ! link 4: mass matrix, its row of this joint
    m4_4 = t5 + 0.20184216_rk
    t6 = 0.4318_rk*c2
    t7 = 5.8464e-05_rk*s5
    t8 = t7 - c4*(t5 - 0.01369784_rk)
    t9 = c4*t7
    t10 = c4*t8 + (t9 - 0.5395351125_rk)
    t11 = 0.001247328_rk*c5
    t12 = t5 - t11
    t13 = t11 - (t12 - 0.8169101365_rk)
    t14 = t4 - 0.4331_rk
    t15 = s23*h5_x
    t16 = c4*t15
    t17 = t14*t16
    t18 = h3_x*t6
    t19 = t9 - (0.1501_rk*h4_y + m4_4)
    t20 = c23*(t17 - 0.0068208_rk*(s23 - 2.9761904761904763_rk*t3)) - (t18 - (t12 - &
        0.540869687_rk) - t19)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t6*(3.709729509031959_rk*c2 - 0.03288188976377953_rk*s2) - (c23*(c23*(t10 + t13)) - &
        (t10 - (t20 + (t20 - 2.2249496655_rk))))
    ! link 3: mass matrix, its row of this joint
    m3_4 = h4_y*t14
    t21 = s4*s23
    ! link 3: second moment of the composite body [kg m^2]
    k3_yz = c23*(m3_4 - 0.004704_rk) - t8*t21
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.1501_rk*h3_y + k3_yz
    t22 = 0.4318_rk*s2
    t23 = h4_y*t22
    m1_2 = 0.690314699_rk*s2 + (t23 + 0.023751_rk*c2 + m1_3)
    m1_4 = h4_x*t6 - c23*t19 - t17
    t24 = c23*neg_h5_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = t15 - c4*t24
    t25 = t11 + 0.17964216_rk
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = 0.0203_rk*(s4*t24) - t21*t25
    t26 = s4*t6
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - neg_h5_y*t26
    ! link 1: mass matrix, its row of this joint
    m1_5 = 0.1501_rk*neg_fu3_x - nu2_y
    ! link 3: mass matrix, its row of this joint
    m3_3 = t13 - t10
    t27 = t18 + h3_y*t22
    ! link 2: mass matrix, its row of this joint
    m2_3 = t27 + m3_3
    m2_2 = t27 + (m2_3 + 6.458114002_rk)
    m2_4 = m3_4 + c23*t23 - t15*t26
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t25 - t7
    ! link 3: force for a unit acceleration of a joint further out
    fu3_y = c23*h5_x + neg_h5_y*(c4*s23)
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t22*neg_fu3_x + t6*fu3_y)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 67.02777777777777_rk*h4_y
    t28 = 67.02777777777777_rk*(t24 - t16)
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = t28
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = nu4_y
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = nu4_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = m3_5
    M(28) = 0.0_rk
    M(29) = 0.17964216_rk
    M(30) = 0.0_rk
    M(31) = t28
    M(32) = nu4_y
    M(33) = nu4_y
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.19304_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 247 multiplications, 201 additions, 4 divisions = 452; 3 unary minus; 8 sine/cosine
  pure subroutine puma560_rotor_in_link_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_rotor_in_link_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: w3_z, angle23, c23, neg_w3_y, s23, neg_w3_x, neg_ww3_yz, neg_ww3_zx, ww3_yy, ww3_zz
    real(rk) :: ww3_xy, neg_lam2_33, neg_lam3_11, lam3_31, s4, c4, w4_y, neg_w4_x, w4_z, c5, s5
    real(rk) :: neg_w5_x, neg_w5_y, w5_z, ww5_xy, neg_ww5_zx, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1
    real(rk) :: n06_y, c2, s2, ww2_zz, alpha4_y, lam5_12, alpha4_x, lam5_32, t2, neg_lam3_22, t3
    real(rk) :: t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, n5_z, alpha5_y
    real(rk) :: n06_z, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, n3_x, neg_n4_z, n3_y, t28
    real(rk) :: t29, t30, t31, t32, t33, t34, t35, n1_z, t36, n3_z, n02_z, neg_nu5_y, h5_x
    real(rk) :: neg_h5_y, h4_x, h4_y, t37, t38, t39, h3_x, h3_y, t40, t41, m4_4, t42, t43, t44, t45
    real(rk) :: t46, t47, t48, t49, t50, t51, t52, t53, t54, t55, m1_1, m3_4, t56, k3_yz, m1_3, t57
    real(rk) :: t58, m1_2, neg_m1_4, t59, neg_fu3_x, t60, nu3_y, t61, nu2_y, neg_m1_5, neg_m3_3
    real(rk) :: t62, neg_m2_3, m2_2, m2_4, neg_m3_5, fu3_y, neg_m2_5, nu4_y, t63, neg_ud1_6, neg_y5
    real(rk) :: y6, u3_6, neg_u1_6, neg_u3_5, neg_u2_5, neg_u1_5, pivot4, ipivot4, t64, ud3_4, u3_4
    real(rk) :: ud2_4, u2_4, neg_ud1_4, neg_u1_4, t65, neg_pivot3, neg_ipivot3, neg_ud2_3, u2_3
    real(rk) :: t66, ud1_3, neg_u1_3, pivot2, ipivot2, ud1_2, u1_2, pivot1, ipivot1, y4, t67
    real(rk) :: neg_y3, neg_y2, neg_y1, neg_qdd1, neg_qdd2, qdd3, qdd4, qdd5, qdd6, t68, t69

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = c23*qd(1)
    ! sines and cosines of the joint angles
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_xy = neg_w3_y*neg_w3_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    lam3_31 = -2.0_rk*neg_ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.19304_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww3_yz*s4 + neg_w4_x*qd(4)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = w4_y*qd(4) - neg_ww3_yz*c4
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = neg_ww3_zx*s5 - neg_w5_y*(qd(5) + w5_z) + c5*alpha4_x
    t2 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam2_33 - t2
    t3 = 21.27093596059113_rk*c2
    t4 = t3*(neg_lam2_33 + ww2_zz)
    t5 = 21.27093596059113_rk*s2
    t6 = ww2_zz*t5 + 482.7586206896552_rk
    t7 = c23*t4 + s23*t6
    t8 = neg_lam3_11 - 21.334975369458128_rk*ww3_xy - t7
    t9 = 2.0_rk*(qd(2)*qd(1))
    t10 = 7.394088669950739_rk*neg_lam2_33 + t5*t9
    t11 = 42.669950738916256_rk*neg_ww3_yz
    t12 = t11 - lam3_31
    t13 = t10 - t12
    t14 = c4*t8 - s4*t13
    t15 = 5.8464e-05_rk*c5
    t16 = 5.8464e-05_rk*s5
    t17 = ww3_xy - 21.334975369458128_rk*neg_lam3_22 - (s23*t4 - c23*t6)
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t14*t15 + (n06_y + 0.17964216_rk*(alpha4_y - 0.0013480131835422152_rk*ww5_xy)) - &
        t16*t17
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd(5) - s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.19304_rk*alpha5_y
    t18 = 0.0005151125_rk*t14 - (neg_lam5_22*t16 + lam5_12*t15)
    t19 = s4*t8 + c4*t13
    t20 = 0.00054216_rk*lam5_32 + 0.00477684375_rk*t19
    t21 = 0.10783532536520585_rk*t20
    t22 = s4*t18 - c4*t21
    t23 = 3280.019999836749_rk*t22
    t24 = n5_z + 0.2013_rk*alpha4_y
    t25 = 0.1791_rk*neg_ww5_zx + 0.19334_rk*alpha5_y
    t26 = t20 + (w5_z*(t1 - 0.1788_rk*neg_w5_y) - 0.00471837975_rk*t19)
    t27 = s5*t25 - (c5*t26 + 0.2013_rk*alpha4_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = 0.006504526_rk*(t10 - t23) - s4*t24 + (0.004704_rk*t2 + &
        (0.028340161332717616_rk*neg_ww3_zx - (0.013853806666358808_rk*t12 + c4*t27)))
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_z = c5*t25 + (0.2013_rk*neg_ww3_zx + s5*t26)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = neg_n4_z - 0.004704_rk*ww3_xy + (t22 - 18.402048804157637_rk*neg_ww3_yz + &
        0.43125_rk*t12)
    t28 = 0.06435058403334877_rk*c2
    t29 = 0.010372902938360292_rk*(t3*t28) + (t5*t28 - 0.0070992_rk)
    t30 = c4*t18 + s4*t21
    t31 = t30 - 0.006504526_rk*ww3_xy
    t32 = lam5_12*t16 - neg_lam5_22*t15 + 0.0005151125_rk*t17
    t33 = 0.006504526_rk*neg_lam3_22 - t32
    t34 = c23*t31 - s23*t33
    t35 = 0.006485001909027938_rk*c2*(t11 + t23) - t9*t29 - (7.394088669950739_rk*t34 - &
        (ww2_zz*(0.609298224_rk*c2 - 0.023751_rk*s2) - c23*n3_y))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t35 - s23*n3_x
    t36 = 0.000316274_rk*(neg_lam3_11 - neg_lam3_22) - (21.334975369458128_rk*(t30 - &
        0.00030487618979450475_rk*t7) + (t32 + c4*t24) - s4*t27)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.135679376_rk*ww3_xy - t36
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n3_z + (neg_lam2_33*t29 + t3*(s23*t31 + (c23*t33 - 1.5019138889382213_rk))) + &
        (0.0018749598043631376_rk*(t3 + 545.6756980171745_rk*s2) - t5*t34)
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.19304_rk*c5
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t37 = h4_x - 0.025375_rk
    t38 = neg_h5_y + 0.861795_rk
    t39 = s23*t38
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t37 + t39
    h3_y = s23*t37 - c23*t38
    t40 = 66.94369444444445_rk*c5
    t41 = neg_h5_y*t40
    ! link 4: mass matrix, its row of this joint
    m4_4 = t41 + 0.20184216_rk
    t42 = 0.4318_rk*c2
    t43 = t16 - c4*(t41 - 0.01369784_rk)
    t44 = c4*t16
    t45 = c4*t43 + (t44 - 0.5395351125_rk)
    t46 = 0.001247328_rk*c5
    t47 = t41 - t46
    t48 = t46 - (t47 - 0.8169101365_rk)
    t49 = t40 - 0.4331_rk
    t50 = s23*h5_x
    t51 = c4*t50
    t52 = t49*t51
    t53 = h3_x*t42
    t54 = t44 - (m4_4 + 0.1501_rk*h4_y)
    t55 = c23*(t52 - 0.0068208_rk*(s23 - 2.9761904761904763_rk*t39)) - (t53 - (t47 - &
        0.540869687_rk) - t54)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t42*(3.709729509031959_rk*c2 - 0.03288188976377953_rk*s2) - (c23*(c23*(t45 + t48)) - &
        (t45 - (t55 + (t55 - 2.2249496655_rk))))
    ! link 3: mass matrix, its row of this joint
    m3_4 = h4_y*t49
    t56 = s23*s4
    ! link 3: second moment of the composite body [kg m^2]
    k3_yz = c23*(m3_4 - 0.004704_rk) - t43*t56
    ! link 1: mass matrix, its row of this joint
    m1_3 = k3_yz + 0.1501_rk*h3_y
    t57 = 0.4318_rk*s2
    t58 = h4_y*t57
    m1_2 = 0.690314699_rk*s2 + (m1_3 + (t58 + 0.023751_rk*c2))
    neg_m1_4 = t52 - (h4_x*t42 - c23*t54)
    t59 = c23*neg_h5_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = t50 - c4*t59
    t60 = t46 + 0.17964216_rk
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = 0.0203_rk*(s4*t59) - t56*t60
    t61 = s4*t42
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - neg_h5_y*t61
    ! link 1: mass matrix, its row of this joint
    neg_m1_5 = nu2_y - 0.1501_rk*neg_fu3_x
    ! link 3: mass matrix, its row of this joint
    neg_m3_3 = t45 - t48
    t62 = t53 + h3_y*t57
    ! link 2: mass matrix, its row of this joint
    neg_m2_3 = neg_m3_3 - t62
    m2_2 = t62 - (neg_m2_3 - 6.458114002_rk)
    m2_4 = m3_4 + c23*t58 - t50*t61
    ! link 3: mass matrix, its row of this joint
    neg_m3_5 = t16 - c4*t60
    ! link 3: force for a unit acceleration of a joint further out
    fu3_y = c23*h5_x + neg_h5_y*(s23*c4)
    ! link 2: mass matrix, its row of this joint
    neg_m2_5 = neg_m3_5 - (t57*neg_fu3_x + t42*fu3_y)
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 67.02777777777777_rk*h4_y
    t63 = t51 - t59
    ! factorisation M = U D U^T
    neg_ud1_6 = 67.02777777777777_rk*t63
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    y6 = tau(6) - n06_z
    ! factorisation M = U D U^T
    u3_6 = 347.22222222222223_rk*h4_y
    neg_u1_6 = 347.22222222222223_rk*t63
    neg_u3_5 = 5.566622000091738_rk*neg_m3_5
    neg_u2_5 = 5.566622000091738_rk*neg_m2_5
    neg_u1_5 = 5.566622000091738_rk*neg_m1_5
    pivot4 = m4_4 - c5*neg_nu5_y
    ipivot4 = 1.0_rk / pivot4
    t64 = neg_nu5_y*u3_6
    ud3_4 = m3_4 - t64
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 - t64
    u2_4 = ipivot4*ud2_4
    neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6
    neg_u1_4 = ipivot4*neg_ud1_4
    t65 = nu4_y*u3_6
    neg_pivot3 = neg_m3_3 + t65 + neg_m3_5*neg_u3_5 + ud3_4*u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = neg_m2_3 + t65 + neg_m3_5*neg_u2_5 + ud3_4*u2_4
    u2_3 = neg_ipivot3*neg_ud2_3
    t66 = nu4_y*neg_u1_6
    ud1_3 = m1_3 + t66 - neg_m3_5*neg_u1_5 + ud3_4*neg_u1_4
    neg_u1_3 = neg_ipivot3*ud1_3
    pivot2 = m2_2 - t65 - neg_m2_5*neg_u2_5 - ud2_4*u2_4 + neg_ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 + t66 - neg_m2_5*neg_u1_5 + ud2_4*neg_u1_4 - neg_ud2_3*neg_u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - neg_ud1_6*neg_u1_6 - neg_m1_5*neg_u1_5 - neg_ud1_4*neg_u1_4 + ud1_3*neg_u1_3 - &
        ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 4: forward substitution
    y4 = neg_n4_z + tau(4) - c5*y6
    t67 = y6*u3_6
    ! link 3: forward substitution
    neg_y3 = n3_z - tau(3) + t67 + neg_y5*neg_u3_5 + u3_4*y4
    ! link 2: forward substitution
    neg_y2 = n02_z - tau(2) + t67 + neg_y5*neg_u2_5 + u2_4*y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1) - y6*neg_u1_6 + neg_y5*neg_u1_5 - neg_u1_4*y4 + neg_u1_3*neg_y3 - &
        u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd2 = ipivot2*neg_y2 - u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 + u2_3*neg_qdd2 - neg_u1_3*neg_qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 - u3_4*qdd3 + u2_4*neg_qdd2 - neg_u1_4*neg_qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = -neg_u1_5*neg_qdd1 - (5.566622000091738_rk*neg_y5 - neg_u3_5*qdd3 + neg_u2_5*neg_qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = u3_6*(neg_qdd2 - qdd3) - (neg_u1_6*neg_qdd1 - (5.180273518441774_rk*y6 - c5*qdd4))
    t68 = -neg_qdd1
    t69 = -neg_qdd2
    qdd(1) = t68
    qdd(2) = t69
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
