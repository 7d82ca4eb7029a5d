! ur5: Universal Robots UR5
! Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
! Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: a034a79d0d30f898e9c7fa14f11711e6 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0     a 0        d 0.089159  theta q + -pi
!   2  revolute  alpha pi/2  a 0        d 0.13585   theta q + pi
!   3  revolute  alpha 0     a 0.425    d -0.1197   theta q
!   4  revolute  alpha 0     a 0.39225  d 0.093     theta q + -pi
!   5  revolute  alpha pi/2  a 0        d 0.09465   theta q + -pi
!   6  revolute  alpha pi/2  a 0        d 0         theta q
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
!   to the recursion without being written like it: robodyn --optimize full, seed 3.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine
!   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
!   bias: 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine
!   mass_matrix: 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
!   forward_dynamics: 171 multiplications, 146 additions, 5 divisions = 322; 3 unary minus; 10
!       sine/cosine
module ur5_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: ur5_inverse_dynamics
  public :: ur5_gravity
  public :: ur5_bias
  public :: ur5_mass_matrix
  public :: ur5_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine
  pure subroutine ur5_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="ur5_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: lam2_33, w3_z, w4_z, angle23, angle2to4, c2to4, w4_y, s2to4, w4_x, alpha3_z
    real(rk) :: alpha4_z, ww4_yz, alpha4_x, c5, s5, w5_x, w5_z, w5_y, ww5_yz, c6, s6, w6_x, w6_y
    real(rk) :: w6_z, c2, s2, c23, s23, alpha5_y, alpha6_z, t1, nc6_z, alpha5_x, ww4_zx, alpha4_y
    real(rk) :: alpha5_z, ww2_zz, ww3_zz, lam4_32, t2, t3, t4, n5_z, ww4_zz, t5, t6, t7, t8, t9
    real(rk) :: t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25
    real(rk) :: n1_z, t26, n4_z, t27, n03_z, t28, n02_z

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 4: angular velocity [rad/s]
    w4_z = w3_z + qd(4)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    angle2to4 = angle23 + q(4)
    c2to4 = cos(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_y = qd(1)*c2to4
    ! sines and cosines of the joint angles
    s2to4 = sin(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = alpha3_z + qdd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_z*w4_y
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = s2to4*qdd(1) + ww4_yz
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = -w4_z*s5 - w4_x*c5
    w5_z = qd(5) - w4_y
    w5_y = w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_yz = w5_z*w5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 + w5_z*s6
    w6_y = w5_z*c6 - w5_x*s6
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = alpha4_x*s5 - (alpha4_z*c5 + w5_x*qd(5))
    ! link 6: angular acceleration [rad/s^2]
    alpha6_z = qdd(6) - alpha5_y
    t1 = 0.0004509462908_rk*w6_y
    ! link 6: moment that turns the link [N m]
    nc6_z = 37.00114003598763_rk*(w6_x*t1 + 0.0004631336528748281_rk*alpha6_z)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - alpha4_x*c5 - alpha4_z*s5
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zx = w4_z*w4_x
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = c2to4*qdd(1) - ww4_zx
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = qdd(5) - alpha4_y
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_32 = ww4_yz + alpha4_x
    t2 = w6_z*t1
    t3 = 0.0166855268546_rk*(c6*alpha5_z - w6_x*(qd(6) + 1.0270261943017807_rk*w6_z) - &
        s6*alpha5_x)
    t4 = -0.21481116377025_rk*w5_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = s6*t2 + (c6*t3 + 0.0797745929244544_rk*(w5_y*t4 + 2.9653109401563_rk*alpha5_z))
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = w4_z*w4_z
    t5 = 0.00460883622975_rk*alpha5_y - (nc6_z - w5_z*t4)
    t6 = c6*t2 - (s6*t3 - 0.23194763691565_rk*ww5_yz - 0.02174530937515_rk*alpha5_x)
    t7 = 3.8937242327072834_rk*s2
    t8 = 3.8937242327072834_rk*c2
    t9 = qdd(2)*t7 + t8*ww2_zz
    t10 = 0.00989414459142792_rk*c23
    t11 = 3.5936784241868986_rk*s23
    t12 = 2.0_rk*qd(1)
    t13 = t11*(w3_z*t12)
    t14 = 3.5936784241868986_rk*c23
    t15 = alpha3_z*t11 + t14*ww3_zz
    t16 = 0.00194120382525_rk*s2to4
    t17 = t12*(qd(2)*t7)
    t18 = t8 + t14
    t19 = t13 + t17 - (lam2_33 + qdd(1)*t18)
    t20 = 0.05635344670717668_rk*t9 + t10*t13 - (0.027092562065296363_rk*t15 - (t16*t19 - (t19 + &
        0.03997638634458061_rk*lam4_32)*(0.04855876187801449_rk*t18)))
    t21 = 0.26165588420637464_rk*c2
    t22 = s2to4*(s5*t5 - c5*t6) + (t20 - (t17*t21 + qdd(1)*(t10*t14 - (t8*t21 + &
        0.3692910505647355_rk))))
    t23 = 0.00194120382525_rk*c2to4
    t24 = qdd(1) + (t9 + t15 - lam2_33*t18)
    t25 = t16*(ww4_zz - lam2_33) - (alpha4_z*t23 + 0.04855876187801449_rk*t24)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t22 - (c2to4*n5_z + t25)
    t26 = t7*ww2_zz - (alpha3_z*t14 - (t11*ww3_zz - (qdd(2)*t8 - 89.87631699496106_rk)))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.21942_rk*alpha4_z + (t16*t26 + t23*t24) - (s5*t6 + c5*t5)
    t27 = 0.04855876187801449_rk*t26 + ww4_zz*t23 + alpha4_z*t16
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_z = n4_z - (0.03146137394400002_rk*alpha3_z + t11*(t25 + 0.027092562065296363_rk*qdd(1) - &
        lam2_33*t10)) - t14*t27
    t28 = 1.033923256964812_rk*qdd(2) + (t7*(0.05635344670717668_rk*qdd(1) - t25 - lam2_33*t21) - &
        t8*(t27 + 6.804194372765798_rk))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n03_z + t28
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! torques that hold the arm at rest
  ! 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
  pure subroutine ur5_gravity(q, tau) &
      bind(c, name="ur5_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: angle23, angle2to4, s2to4, nc4_z, c23, neg_nc3_z, n03_z, c2, neg_nc2_z, n02_z

    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    angle2to4 = q(4) + angle23
    s2to4 = sin(angle2to4)
    ! link 4: moment that turns the link [N m]
    nc4_z = 0.17446825035_rk*s2to4
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 15.683828487749999_rk*c23
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_z = nc4_z - neg_nc3_z
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 43.486969725_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n03_z - neg_nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = nc4_z
    tau(5) = 0.0_rk
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine
  pure subroutine ur5_bias(q, qd, tau) &
      bind(c, name="ur5_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: lam2_33, w3_z, w4_z, angle23, angle2to4, c2to4, w4_y, s2to4, w4_x, ww4_yz, c5, s5
    real(rk) :: w5_x, w5_z, w5_y, ww5_yz, c6, s6, w6_x, w6_y, w6_z, c2, s2, c23, s23, alpha5_y, t1
    real(rk) :: nc6_z, alpha5_x, ww4_zx, ww2_zz, ww3_zz, t2, t3, t4, n5_z, ww4_zz, t5, t6, t7, t8
    real(rk) :: t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, n1_z, t24
    real(rk) :: t25, n4_z, t26, n03_z, n02_z

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 4: angular velocity [rad/s]
    w4_z = w3_z + qd(4)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    angle2to4 = angle23 + q(4)
    c2to4 = cos(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_y = qd(1)*c2to4
    ! sines and cosines of the joint angles
    s2to4 = sin(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    ! link 4: products of the angular velocity [1/s^2]
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
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    w6_x = w5_x*c6 + w5_z*s6
    w6_y = w5_z*c6 - w5_x*s6
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = ww4_yz*s5 - w5_x*qd(5)
    t1 = 0.0004509462908_rk*w6_y
    ! link 6: moment that turns the link [N m]
    nc6_z = 37.00114003598763_rk*(w6_x*t1 - 0.0004631336528748281_rk*alpha5_y)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - ww4_yz*c5
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zx = w4_z*w4_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t2 = w6_z*t1
    t3 = 0.0166855268546_rk*(s6*alpha5_x - (c6*ww4_zx - w6_x*(qd(6) + &
        1.0270261943017807_rk*w6_z)))
    t4 = -0.21481116377025_rk*w5_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = s6*t2 - (c6*t3 - 0.0797745929244544_rk*(w5_y*t4 + 2.9653109401563_rk*ww4_zx))
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = w4_z*w4_z
    t5 = 0.00460883622975_rk*alpha5_y - (nc6_z - w5_z*t4)
    t6 = c6*t2 + (0.02174530937515_rk*alpha5_x + (s6*t3 + 0.23194763691565_rk*ww5_yz))
    t7 = 3.8937242327072834_rk*c2
    t8 = t7*ww2_zz
    t9 = 0.00989414459142792_rk*c23
    t10 = 3.5936784241868986_rk*s23
    t11 = 2.0_rk*qd(1)
    t12 = t10*(w3_z*t11)
    t13 = 3.5936784241868986_rk*c23
    t14 = t13*ww3_zz
    t15 = 0.00194120382525_rk*s2to4
    t16 = 3.8937242327072834_rk*s2
    t17 = t11*(qd(2)*t16)
    t18 = t12 + t17 - lam2_33
    t19 = t7 + t13
    t20 = 0.05635344670717668_rk*t8 + t9*t12 - (0.027092562065296363_rk*t14 - (t15*t18 - (t18 + &
        0.07995277268916122_rk*ww4_yz)*(0.04855876187801449_rk*t19)))
    t21 = 0.26165588420637464_rk*c2
    t22 = t8 + t14 - lam2_33*t19
    t23 = t15*(ww4_zz - lam2_33) - 0.04855876187801449_rk*t22
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2to4*(s5*t5 - c5*t6) + (t20 - t17*t21) - (c2to4*n5_z + t23)
    t24 = t16*ww2_zz + (t10*ww3_zz + 89.87631699496106_rk)
    t25 = 0.00194120382525_rk*c2to4
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t15*t24 + t25*t22 - (s5*t6 + c5*t5)
    t26 = 0.04855876187801449_rk*t24 + ww4_zz*t25
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_z = n4_z - t10*(t23 - lam2_33*t9) - t13*t26
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n03_z - (t16*(t23 + lam2_33*t21) + t7*(t26 + 6.804194372765798_rk))
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n03_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = nc6_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
  pure subroutine ur5_mass_matrix(q, M) &
      bind(c, name="ur5_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, angle2to4, c2to4, s2to4, nu5_y, t1
    real(rk) :: k6_xy, neg_k5_xz, t2, m5_5, t3, nu4_y, t4, t5, t6, t7, t8, t9, t10, t11, t12, m1_1
    real(rk) :: neg_k5_yz, t13, m1_4, t14, m1_3, m1_2, m4_4, t15, m3_4, m3_3, t16, t17, m2_3, m2_2
    real(rk) :: m2_4, t18

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c5 = cos(q(5))
    s5 = sin(q(5))
    c6 = cos(q(6))
    s6 = sin(q(6))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    angle2to4 = angle23 + q(4)
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = 0.0171364731454_rk*c5
    t1 = 0.0166855268546_rk*s6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = c6*t1
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*k6_xy
    t2 = s6*t1
    ! link 5: mass matrix, its row of this joint
    m5_5 = 0.253242_rk - t2
    t3 = s2to4*neg_k5_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = t3 - c2to4*m5_5
    t4 = 0.6794726918749999_rk*c2
    t5 = 0.011124085581927274_rk*s2to4
    t6 = 0.62711332561875_rk*(c23*t5)
    t7 = c23*t4
    t8 = t4*t5
    t9 = t6 - (t7 - t8)
    t10 = c5*t2
    t11 = c5*t10
    t12 = 3.801350732012182_rk*(t4*t4) - (t9 + (t9 - t11 - 0.4395951218179_rk)) - &
        c2to4*(c2to4*(t11 + 0.02174530937515_rk) + (t3 + nu4_y))
    ! link 1: mass matrix, its row of this joint
    m1_1 = 0.59155695167475_rk*(c23*c23) + t12
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = s5*k6_xy
    t13 = s5*s2to4
    ! link 1: mass matrix, its row of this joint
    m1_4 = t10*t13 - c2to4*(neg_k5_yz - 0.00194120382525_rk)
    t14 = 0.07714261911624999_rk*s23
    m1_3 = m1_4 + t14
    m1_2 = m1_3 + 0.408499208875_rk*s2
    ! link 4: mass matrix, its row of this joint
    m4_4 = t2 - t11 + 0.24116530937515_rk
    t15 = t6 - 0.09043071629752977_rk*(c2to4*t14)
    ! link 3: mass matrix, its row of this joint
    m3_4 = m4_4 - t15
    m3_3 = m3_4 - (t15 - 0.5956519516747499_rk)
    t16 = t8 - 0.007558512375_rk*(s2*c2to4)
    t17 = s23*(0.6794726918749999_rk*s2) + (t7 - t16)
    ! link 2: mass matrix, its row of this joint
    m2_3 = t17 + m3_3
    m2_2 = t17 + (m2_3 + 1.77012693841_rk)
    m2_4 = m3_4 - t16
    t18 = -0.0171364731454_rk*t13
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = nu4_y
    M(6) = t18
    M(7) = m1_2
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = neg_k5_yz
    M(12) = nu5_y
    M(13) = m1_3
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = neg_k5_yz
    M(18) = nu5_y
    M(19) = m1_4
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = neg_k5_yz
    M(24) = nu5_y
    M(25) = nu4_y
    M(26) = neg_k5_yz
    M(27) = neg_k5_yz
    M(28) = neg_k5_yz
    M(29) = m5_5
    M(30) = 0.0_rk
    M(31) = t18
    M(32) = nu5_y
    M(33) = nu5_y
    M(34) = nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0171364731454_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 171 multiplications, 146 additions, 5 divisions = 322; 3 unary minus; 10 sine/cosine
  pure subroutine ur5_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="ur5_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: neg_lam2_33, w3_z, w4_z, angle23, angle2to4, c2to4, w4_y, s2to4, w4_x, ww4_yz, c5
    real(rk) :: s5, neg_w5_x, neg_w5_z, w5_y, neg_ww5_yz, c6, s6, neg_w6_x, w6_y, neg_w6_z, c2, s2
    real(rk) :: c23, s23, alpha5_y, t1, nc6_z, alpha5_x, ww4_zx, ww2_zz, ww3_zz, t2, t3, t4, n5_z
    real(rk) :: ww4_zz, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20
    real(rk) :: t21, t22, t23, n1_z, t24, t25, n4_z, t26, n03_z, n02_z, nu5_y, t27, k6_xy
    real(rk) :: neg_k5_xz, t28, neg_m5_5, t29, nu4_y, t30, t31, t32, t33, t34, t35, t36, t37, t38
    real(rk) :: m1_1, neg_k5_yz, neg_u1_6, m1_4, t39, m1_3, m1_2, m4_4, t40, m3_4, m3_3, t41, t42
    real(rk) :: m2_3, m2_2, m2_4, neg_ud1_6, neg_y5, neg_y6, neg_ipivot5, neg_u4_5, neg_u1_5, t43
    real(rk) :: t44, pivot4, ipivot4, ud3_4, u3_4, ud2_4, u2_4, t45, t46, ud1_4, u1_4, pivot3
    real(rk) :: ipivot3, ud2_3, u2_3, ud1_3, u1_3, pivot2, ipivot2, ud1_2, u1_2, pivot1, ipivot1
    real(rk) :: t47, t48, neg_y4, neg_y3, neg_y2, neg_y1, neg_qdd1, neg_qdd2, neg_qdd3, qdd4, t49
    real(rk) :: qdd5, qdd6, t50, t51, t52

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 4: angular velocity [rad/s]
    w4_z = w3_z + qd(4)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    angle2to4 = angle23 + q(4)
    c2to4 = cos(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_y = qd(1)*c2to4
    ! sines and cosines of the joint angles
    s2to4 = sin(angle2to4)
    ! link 4: angular velocity [rad/s]
    w4_x = qd(1)*s2to4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_z*w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = w4_z*s5 + w4_x*c5
    neg_w5_z = w4_y - qd(5)
    w5_y = w4_x*s5 - w4_z*c5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_yz = neg_w5_z*w5_y
    ! sines and cosines of the joint angles
    c6 = cos(q(6))
    s6 = sin(q(6))
    ! link 6: angular velocity [rad/s]
    neg_w6_x = neg_w5_x*c6 + neg_w5_z*s6
    w6_y = neg_w5_x*s6 - neg_w5_z*c6
    neg_w6_z = w5_y - qd(6)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = ww4_yz*s5 + neg_w5_x*qd(5)
    t1 = -0.0004509462908_rk*w6_y
    ! link 6: moment that turns the link [N m]
    nc6_z = 37.00114003598763_rk*(neg_w6_x*t1 - 0.0004631336528748281_rk*alpha5_y)
    ! link 5: angular acceleration [rad/s^2]
    alpha5_x = qd(5)*w5_y - ww4_yz*c5
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zx = w4_z*w4_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t2 = neg_w6_z*t1
    t3 = 0.0166855268546_rk*(s6*alpha5_x - (c6*ww4_zx + neg_w6_x*(qd(6) - &
        1.0270261943017807_rk*neg_w6_z)))
    t4 = 0.21481116377025_rk*neg_w5_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = s6*t2 - (c6*t3 - 0.0797745929244544_rk*(w5_y*t4 + 2.9653109401563_rk*ww4_zx))
    ! link 4: products of the angular velocity [1/s^2]
    ww4_zz = w4_z*w4_z
    t5 = 0.00460883622975_rk*alpha5_y - (nc6_z + neg_w5_z*t4)
    t6 = c6*t2 + (0.02174530937515_rk*alpha5_x + (s6*t3 - 0.23194763691565_rk*neg_ww5_yz))
    t7 = 3.8937242327072834_rk*c2
    t8 = ww2_zz*t7
    t9 = 0.00989414459142792_rk*c23
    t10 = 3.5936784241868986_rk*s23
    t11 = 2.0_rk*qd(1)
    t12 = t10*(w3_z*t11)
    t13 = 3.5936784241868986_rk*c23
    t14 = ww3_zz*t13
    t15 = 0.00194120382525_rk*s2to4
    t16 = 3.8937242327072834_rk*s2
    t17 = t11*(qd(2)*t16)
    t18 = neg_lam2_33 + (t12 + t17)
    t19 = t7 + t13
    t20 = 0.05635344670717668_rk*t8 + t9*t12 - (0.027092562065296363_rk*t14 - (t15*t18 - (t18 + &
        0.07995277268916122_rk*ww4_yz)*(0.04855876187801449_rk*t19)))
    t21 = 0.26165588420637464_rk*c2
    t22 = t8 + t14 + neg_lam2_33*t19
    t23 = t15*(neg_lam2_33 + ww4_zz) - 0.04855876187801449_rk*t22
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2to4*(s5*t5 - c5*t6) + (t20 - t17*t21) - (c2to4*n5_z + t23)
    t24 = ww2_zz*t16 + (ww3_zz*t10 + 89.87631699496106_rk)
    t25 = 0.00194120382525_rk*c2to4
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = t15*t24 + t22*t25 - (s5*t6 + c5*t5)
    t26 = 0.04855876187801449_rk*t24 + ww4_zz*t25
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_z = n4_z - t10*(t23 + neg_lam2_33*t9) - t13*t26
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n03_z - (t16*(t23 - neg_lam2_33*t21) + t7*(t26 + 6.804194372765798_rk))
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = 0.0171364731454_rk*c5
    t27 = 0.0166855268546_rk*s6
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = c6*t27
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_xz = c5*k6_xy
    t28 = s6*t27
    ! link 5: mass matrix, its row of this joint
    neg_m5_5 = t28 - 0.253242_rk
    t29 = s2to4*neg_k5_xz
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = t29 + c2to4*neg_m5_5
    t30 = 0.6794726918749999_rk*c2
    t31 = 0.011124085581927274_rk*s2to4
    t32 = 0.62711332561875_rk*(c23*t31)
    t33 = c23*t30
    t34 = t30*t31
    t35 = t32 - (t33 - t34)
    t36 = c5*t28
    t37 = c5*t36
    t38 = 3.801350732012182_rk*(t30*t30) - (t35 + (t35 - t37 - 0.4395951218179_rk)) - &
        c2to4*(c2to4*(t37 + 0.02174530937515_rk) + (t29 + nu4_y))
    ! link 1: mass matrix, its row of this joint
    m1_1 = 0.59155695167475_rk*(c23*c23) + t38
    ! link 5: second moment of the composite body [kg m^2]
    neg_k5_yz = s5*k6_xy
    ! factorisation M = U D U^T
    neg_u1_6 = s2to4*s5
    ! link 1: mass matrix, its row of this joint
    m1_4 = t36*neg_u1_6 - c2to4*(neg_k5_yz - 0.00194120382525_rk)
    t39 = 0.07714261911624999_rk*s23
    m1_3 = m1_4 + t39
    m1_2 = m1_3 + 0.408499208875_rk*s2
    ! link 4: mass matrix, its row of this joint
    m4_4 = t28 - t37 + 0.24116530937515_rk
    t40 = t32 - 0.09043071629752977_rk*(c2to4*t39)
    ! link 3: mass matrix, its row of this joint
    m3_4 = m4_4 - t40
    m3_3 = m3_4 - (t40 - 0.5956519516747499_rk)
    t41 = t34 - 0.007558512375_rk*(c2to4*s2)
    t42 = s23*(0.6794726918749999_rk*s2) + (t33 - t41)
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + t42
    m2_2 = t42 + (m2_3 + 1.77012693841_rk)
    m2_4 = m3_4 - t41
    ! factorisation M = U D U^T
    neg_ud1_6 = 0.0171364731454_rk*neg_u1_6
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    neg_y6 = nc6_z - tau(6)
    ! factorisation M = U D U^T
    neg_ipivot5 = 1.0_rk / neg_m5_5
    neg_u4_5 = neg_k5_yz*neg_ipivot5
    neg_u1_5 = nu4_y*neg_ipivot5
    t43 = c5*nu5_y
    t44 = neg_k5_yz*neg_u4_5
    pivot4 = m4_4 - t43 + t44
    ipivot4 = 1.0_rk / pivot4
    ud3_4 = t44 + (m3_4 - t43)
    u3_4 = ipivot4*ud3_4
    ud2_4 = t44 + (m2_4 - t43)
    u2_4 = ipivot4*ud2_4
    t45 = nu5_y*neg_u1_6
    t46 = neg_k5_yz*neg_u1_5
    ud1_4 = m1_4 + t45 + t46
    u1_4 = ipivot4*ud1_4
    pivot3 = t44 + (m3_3 - t43) - ud3_4*u3_4
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = t44 + (m2_3 - t43) - ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    ud1_3 = t46 + (m1_3 + t45) - ud3_4*u1_4
    u1_3 = ipivot3*ud1_3
    pivot2 = t44 + (m2_2 - t43) - ud2_4*u2_4 - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = t46 + (m1_2 + t45) - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - neg_u1_6*neg_ud1_6 + nu4_y*neg_u1_5 - ud1_4*u1_4 - ud1_3*u1_3 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    t47 = c5*neg_y6
    t48 = neg_y5*neg_u4_5
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) - t47 + t48
    ! link 3: forward substitution
    neg_y3 = t48 + (n03_z - tau(3) - t47) - u3_4*neg_y4
    ! link 2: forward substitution
    neg_y2 = t48 + (n02_z - tau(2) - t47) - u2_4*neg_y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1) + neg_u1_6*neg_y6 + neg_y5*neg_u1_5 - u1_4*neg_y4 - u1_3*neg_y3 - &
        u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd2 = ipivot2*neg_y2 - u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd3 = ipivot3*neg_y3 - u2_3*neg_qdd2 - u1_3*neg_qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = u1_4*neg_qdd1 - (ipivot4*neg_y4 - u3_4*neg_qdd3 - u2_4*neg_qdd2)
    t49 = neg_qdd2 + (neg_qdd3 - qdd4)
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = neg_y5*neg_ipivot5 - neg_u1_5*neg_qdd1 - neg_u4_5*t49
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = c5*t49 - (58.355064750790525_rk*neg_y6 + neg_u1_6*neg_qdd1)
    t50 = -neg_qdd1
    t51 = -neg_qdd2
    t52 = -neg_qdd3
    qdd(1) = t50
    qdd(2) = t51
    qdd(3) = t52
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
