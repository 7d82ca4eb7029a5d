! ur5: Universal Robots UR5
! Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
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
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine
!   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
!   bias: 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine
!   mass_matrix: 54 multiplications, 47 additions = 101; 0 unary minus; 10 sine/cosine
!   forward_dynamics: 226 multiplications, 169 additions, 6 divisions = 401; 3 unary minus; 10
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
  ! 54 multiplications, 47 additions = 101; 0 unary minus; 10 sine/cosine
  pure subroutine ur5_mass_matrix(q, M) &
      bind(c, name="ur5_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c5, s5, c6, s6, angle23, c23, s23, angle2to4, c2to4, s2to4, k6_xy, nu5_x
    real(rk) :: nu5_y, nu4_y, t1, m5_5, t2, t3, k5_yy, k5_xy, neg_k5_xz, neg_k5_yz, nu4_y_2, m4_4
    real(rk) :: h4_x, neg_h4_y, t4, k4_xx, k4_yy, k4_yz, t5, t6, m3_4, t7, t8, m2_4, m1_4, t9, t10
    real(rk) :: m3_3, h3_x, neg_h3_y, t11, k3_xx, k3_yy, k3_yz, m2_3, m1_3, t12, m2_2, neg_h2_y
    real(rk) :: k2_xx, k2_yz, m1_2, m1_1

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
    angle2to4 = q(4) + angle23
    c2to4 = cos(angle2to4)
    s2to4 = sin(angle2to4)
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.0166855268546_rk*(c6*s6)
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = -0.0171364731454_rk*s5
    nu5_y = 0.0171364731454_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s2to4*nu5_x
    t1 = 0.0166855268546_rk*(c6*c6)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t1 + 0.2365564731454_rk
    t2 = t1 - 0.0166855268546_rk
    t3 = c5*c5*t2
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t1 + 0.1099354731454_rk - t3
    k5_xy = t2*(c5*s5)
    neg_k5_xz = c5*k6_xy
    neg_k5_yz = s5*k6_xy
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y_2 = s2to4*neg_k5_xz - c2to4*m5_5
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.25785083622975_rk - (t1 - t3)
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.017784735_rk*s2to4
    neg_h4_y = 0.017784735_rk*c2to4
    t4 = c2to4*c2to4*(t1 + t3 + 0.21481116377025_rk) - neg_k5_xz*(2.0_rk*(c2to4*s2to4))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t4 - (t1 - 0.02151983622975_rk)
    k4_yy = t3 + 0.236331_rk - t4
    k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz
    t5 = 0.39225_rk*s23
    t6 = 0.39225_rk*c23
    ! link 3: mass matrix, its row of this joint
    m3_4 = m4_4 + (t5*neg_h4_y - t6*h4_x)
    t7 = 0.425_rk*s2
    t8 = 0.425_rk*c2
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 + (t7*neg_h4_y - t8*h4_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.00194120382525_rk*c2to4 - k4_yz
    t9 = t6*(0.03556947_rk*s2to4) - k4_xx
    t10 = k4_yy + t5*(0.03556947_rk*c2to4)
    ! link 3: mass matrix, its row of this joint
    m3_3 = 0.5956519516747499_rk - (t9 - t10)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x - 1.598759275_rk*c23
    neg_h3_y = neg_h4_y + 1.598759275_rk*s23
    t11 = 0.59155695167475_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t11 + 0.0020475_rk - t9
    k3_yy = t10 - (t11 - 0.59360445167475_rk)
    k3_yz = k4_yz + 0.09736195574999999_rk*s23
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t7*neg_h3_y - t8*h3_x)
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.10915_rk*neg_h3_y - k3_yz
    t12 = t8*(2.0_rk*h3_x) - k3_xx
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.77012693841_rk - (t12 - (k3_yy + t7*(2.0_rk*neg_h3_y)))
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = neg_h3_y + 4.4329225_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = 1.75501953841_rk*(c2*c2) + 0.0075537_rk - t12
    k2_yz = k3_yz + 0.075354282_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.10915_rk*neg_h2_y - k2_yz
    m1_1 = k5_yy + k2_xx + 0.29853861244275_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = nu4_y_2
    M(6) = nu4_y
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
    M(25) = nu4_y_2
    M(26) = neg_k5_yz
    M(27) = neg_k5_yz
    M(28) = neg_k5_yz
    M(29) = m5_5
    M(30) = 0.0_rk
    M(31) = nu4_y
    M(32) = nu5_y
    M(33) = nu5_y
    M(34) = nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0171364731454_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 226 multiplications, 169 additions, 6 divisions = 401; 3 unary minus; 10 sine/cosine
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
    real(rk) :: t21, t22, t23, n1_z, t24, t25, n4_z, t26, n03_z, n02_z, k6_xy, neg_nu5_x, nu5_y
    real(rk) :: neg_nu4_y, t27, m5_5, t28, t29, k5_yy, k5_xy, neg_k5_xz, neg_k5_yz, nu4_y, neg_m4_4
    real(rk) :: h4_x, neg_h4_y, t30, k4_xx, neg_k4_yy, k4_yz, t31, t32, neg_m3_4, t33, t34
    real(rk) :: neg_m2_4, m1_4, t35, t36, m3_3, h3_x, neg_h3_y, t37, k3_xx, neg_k3_yy, k3_yz, m2_3
    real(rk) :: neg_m1_3, t38, m2_2, neg_h2_y, k2_xx, k2_yz, neg_m1_2, m1_1, neg_y1, ipivot1
    real(rk) :: neg_l2_1, neg_l3_1, l4_1, l5_1, neg_l6_1, pivot2, ipivot2, ld3_2, l3_2, neg_ld4_2
    real(rk) :: neg_l4_2, ld5_2, l5_2, ld6_2, l6_2, pivot3, ipivot3, neg_ld4_3, neg_l4_3, ld5_3
    real(rk) :: l5_3, ld6_3, l6_3, neg_pivot4, neg_ipivot4, ld5_4, neg_l5_4, ld6_4, neg_l6_4
    real(rk) :: pivot5, ipivot5, ld6_5, l6_5, neg_pivot6, neg_ipivot6, neg_y2, neg_y3, neg_y4
    real(rk) :: neg_y5, neg_y6, qdd6, neg_qdd5, qdd4, neg_qdd3, neg_qdd2, qdd1, t39, t40, t41

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
    ! link 6: second moment of the composite body [kg m^2]
    k6_xy = 0.0166855268546_rk*(c6*s6)
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_x = 0.0171364731454_rk*s5
    nu5_y = 0.0171364731454_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_y = s2to4*neg_nu5_x
    t27 = 0.0166855268546_rk*(c6*c6)
    ! link 5: mass matrix, its row of this joint
    m5_5 = t27 + 0.2365564731454_rk
    t28 = t27 - 0.0166855268546_rk
    t29 = c5*c5*t28
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t27 + 0.1099354731454_rk - t29
    k5_xy = t28*(c5*s5)
    neg_k5_xz = c5*k6_xy
    neg_k5_yz = s5*k6_xy
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s2to4*neg_k5_xz - c2to4*m5_5
    ! link 4: mass matrix, its row of this joint
    neg_m4_4 = t27 - t29 - 0.25785083622975_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 0.017784735_rk*s2to4
    neg_h4_y = 0.017784735_rk*c2to4
    t30 = c2to4*c2to4*(t27 + t29 + 0.21481116377025_rk) - neg_k5_xz*(2.0_rk*(c2to4*s2to4))
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = t30 - (t27 - 0.02151983622975_rk)
    neg_k4_yy = t30 - (t29 + 0.236331_rk)
    k4_yz = s2to4*k5_xy + c2to4*neg_k5_yz
    t31 = 0.39225_rk*s23
    t32 = 0.39225_rk*c23
    ! link 3: mass matrix, its row of this joint
    neg_m3_4 = neg_m4_4 - (neg_h4_y*t31 - h4_x*t32)
    t33 = 0.425_rk*s2
    t34 = 0.425_rk*c2
    ! link 2: mass matrix, its row of this joint
    neg_m2_4 = neg_m3_4 - (neg_h4_y*t33 - h4_x*t34)
    ! link 1: mass matrix, its row of this joint
    m1_4 = t25 - k4_yz
    t35 = k4_xx - t32*(0.03556947_rk*s2to4)
    t36 = neg_k4_yy - t31*(0.03556947_rk*c2to4)
    ! link 3: mass matrix, its row of this joint
    m3_3 = t35 - t36 + 0.5956519516747499_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = h4_x - 1.598759275_rk*c23
    neg_h3_y = neg_h4_y + 1.598759275_rk*s23
    t37 = 0.59155695167475_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t35 + (t37 + 0.0020475_rk)
    neg_k3_yy = t36 + (t37 - 0.59360445167475_rk)
    k3_yz = k4_yz + 0.09736195574999999_rk*s23
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + (t33*neg_h3_y - t34*h3_x)
    ! link 1: mass matrix, its row of this joint
    neg_m1_3 = k3_yz - 0.10915_rk*neg_h3_y
    t38 = k3_xx - t34*(2.0_rk*h3_x)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t38 - (neg_k3_yy - t33*(2.0_rk*neg_h3_y)) + 1.77012693841_rk
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = neg_h3_y + 4.4329225_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t38 + (1.75501953841_rk*(c2*c2) + 0.0075537_rk)
    k2_yz = k3_yz + 0.075354282_rk*s2
    ! link 1: mass matrix, its row of this joint
    neg_m1_2 = k2_yz - 0.10915_rk*neg_h2_y
    m1_1 = k5_yy + k2_xx + 0.29853861244275_rk
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1)
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    neg_l2_1 = neg_m1_2*ipivot1
    neg_l3_1 = neg_m1_3*ipivot1
    l4_1 = m1_4*ipivot1
    l5_1 = nu4_y*ipivot1
    neg_l6_1 = neg_nu4_y*ipivot1
    pivot2 = m2_2 - neg_m1_2*neg_l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = m2_3 - neg_m1_2*neg_l3_1
    l3_2 = ipivot2*ld3_2
    neg_ld4_2 = neg_m2_4 - neg_m1_2*l4_1
    neg_l4_2 = ipivot2*neg_ld4_2
    ld5_2 = neg_k5_yz + neg_m1_2*l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu5_y - neg_m1_2*neg_l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - neg_m1_3*neg_l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    neg_ld4_3 = neg_m3_4 - neg_m1_3*l4_1 - ld3_2*neg_l4_2
    neg_l4_3 = ipivot3*neg_ld4_3
    ld5_3 = neg_k5_yz + neg_m1_3*l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu5_y - neg_m1_3*neg_l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    neg_pivot4 = neg_m4_4 + m1_4*l4_1 + neg_ld4_2*neg_l4_2 + neg_ld4_3*neg_l4_3
    neg_ipivot4 = 1.0_rk / neg_pivot4
    ld5_4 = neg_k5_yz - m1_4*l5_1 + neg_ld4_2*l5_2 + neg_ld4_3*l5_3
    neg_l5_4 = neg_ipivot4*ld5_4
    ld6_4 = nu5_y + m1_4*neg_l6_1 + neg_ld4_2*l6_2 + neg_ld4_3*l6_3
    neg_l6_4 = neg_ipivot4*ld6_4
    pivot5 = m5_5 - nu4_y*l5_1 - ld5_2*l5_2 - ld5_3*l5_3 + ld5_4*neg_l5_4
    ipivot5 = 1.0_rk / pivot5
    ld6_5 = nu4_y*neg_l6_1 - ld5_2*l6_2 - ld5_3*l6_3 + ld5_4*neg_l6_4
    l6_5 = ipivot5*ld6_5
    neg_pivot6 = neg_nu4_y*neg_l6_1 - 0.0171364731454_rk + ld6_2*l6_2 + ld6_3*l6_3 - &
        ld6_4*neg_l6_4 + ld6_5*l6_5
    neg_ipivot6 = 1.0_rk / neg_pivot6
    ! link 2: forward substitution
    neg_y2 = n02_z - tau(2) + neg_y1*neg_l2_1
    ! link 3: forward substitution
    neg_y3 = n03_z - tau(3) + neg_y1*neg_l3_1 - l3_2*neg_y2
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) - neg_y1*l4_1 + neg_l4_2*neg_y2 + neg_l4_3*neg_y3
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5) - neg_y1*l5_1 - l5_2*neg_y2 - l5_3*neg_y3 + neg_l5_4*neg_y4
    ! link 6: forward substitution
    neg_y6 = nc6_z - tau(6) + neg_y1*neg_l6_1 - l6_2*neg_y2 - l6_3*neg_y3 + neg_l6_4*neg_y4 - &
        l6_5*neg_y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = neg_ipivot6*neg_y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd5 = ipivot5*neg_y5 + l6_5*qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = neg_ipivot4*neg_y4 - neg_l5_4*neg_qdd5 + neg_l6_4*qdd6
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd3 = ipivot3*neg_y3 - neg_l4_3*qdd4 - l5_3*neg_qdd5 + l6_3*qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd2 = ipivot2*neg_y2 - l3_2*neg_qdd3 - neg_l4_2*qdd4 - l5_2*neg_qdd5 + l6_2*qdd6
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = neg_l6_1*qdd6 - (neg_y1*ipivot1 + neg_l2_1*neg_qdd2 + neg_l3_1*neg_qdd3 + l4_1*qdd4 - &
        l5_1*neg_qdd5)
    t39 = -neg_qdd2
    t40 = -neg_qdd3
    t41 = -neg_qdd5
    qdd(1) = qdd1
    qdd(2) = t39
    qdd(3) = t40
    qdd(4) = qdd4
    qdd(5) = t41
    qdd(6) = qdd6
  end subroutine
end module
