! puma560_d2: PUMA 560, the set of the thesis's program D.2
! Numbers: the 1990 thesis, program D.2 (reduce_puma6), with z4 = -0.019 as listing D.3.4 uses it
! Origin of numbers: geometry, inertia; mass, centre of mass (joints 2 to 6): stated by the
!     description
! Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: b8f01132844a21fecaa07c198852efc3 (a hash of its numbers)
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
!   to the recursion without being written like it: robodyn --optimize full, seed 6.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 128 multiplications, 101 additions = 229; 0 unary minus; 8 sine/cosine
!   gravity: 11 multiplications, 6 additions = 17; 2 unary minus; 7 sine/cosine
!   bias: 119 multiplications, 83 additions = 202; 0 unary minus; 8 sine/cosine
!   mass_matrix: 53 multiplications, 49 additions = 102; 0 unary minus; 8 sine/cosine
!   forward_dynamics: 232 multiplications, 189 additions, 4 divisions = 425; 2 unary minus; 8
!       sine/cosine
module puma560_d2_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_d2_inverse_dynamics
  public :: puma560_d2_gravity
  public :: puma560_d2_bias
  public :: puma560_d2_mass_matrix
  public :: puma560_d2_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 128 multiplications, 101 additions = 229; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_d2_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, alpha3_z, neg_ww3_yz, neg_ww3_zx
    real(rk) :: alpha3_y, ww3_xy, ww3_zz, neg_lam3_12, neg_lam3_31, lam3_21, s4, c4, w4_y, w4_z
    real(rk) :: neg_w4_x, ww4_yz, alpha4_z, neg_ww4_zx, c5, s5, neg_w5_x, neg_w5_y, w5_z, ww5_xy
    real(rk) :: ww5_xx, ww5_zz, neg_lam5_22, c2, s2, ww2_zz, neg_lam3_32, t1, alpha4_x, alpha5_y
    real(rk) :: n06_z, neg_lam5_32, neg_lam2_33, neg_w2_x, ww3_xx, ww3_yy, neg_lam3_11, t2, t3, t4
    real(rk) :: t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, n4_z, t18, alpha4_y
    real(rk) :: alpha5_z, lam5_12, t19, t20, t21, t22, t23, t24, t25, n3_y, neg_lam3_22, t26, n5_z
    real(rk) :: t27, t28, n3_x, t29, t30, t31, n1_z, n3_z, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww3_zx - c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_12 = alpha3_z - ww3_xy
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    lam3_21 = alpha3_z + ww3_xy
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    w4_z = neg_w3_y + qd(4)
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_zx = w4_z*neg_w4_x
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = s23*qdd(1) + 2.0_rk*neg_ww3_yz
    t1 = neg_lam3_12*s4 - c4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz + t1
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) - (alpha4_z*c5 + s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = 0.193_rk*(qdd(6) - alpha5_y)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = alpha4_z*s5 + (neg_w5_y*(qd(5) + w5_z) - c5*alpha4_x)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_lam2_33 - ww3_xx
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_zz + ww3_yy
    t2 = 0.1794_rk*alpha5_y - n06_z
    t3 = 0.193_rk*(1.9295336787564767_rk*neg_w5_y + qd(6))
    t4 = 21.27093596059113_rk*c2
    t5 = neg_w2_x*(42.54187192118226_rk*qd(2))
    t6 = neg_lam3_31 - 7.394088669950739_rk*neg_lam2_33 + (qdd(1)*t4 - t5)
    t7 = neg_lam5_32 - 299.234375_rk*t1
    t8 = 21.27093596059113_rk*s2
    t9 = qdd(2)*t8 + t4*ww2_zz
    t10 = 0.06813163062899491_rk*c2
    t11 = t10*neg_lam2_33
    t12 = t9 + 312.203535482957_rk*(t11 + 0.023683552008828473_rk*qdd(1))
    t13 = qdd(2)*t4 - (t8*ww2_zz + 482.7586206896552_rk)
    t14 = c23*t12 - (neg_lam3_11 + s23*t13)
    t15 = c4*t6 + (0.07129854439169339_rk*t7 + s4*t14)
    t16 = 0.0174944385_rk*t15
    t17 = w5_z*t3 - 0.003341862043757506_rk*(53.781451552625_rk*neg_lam5_32 + t16)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.0222_rk*alpha4_z - (c5*t2 + s5*t17) - w4_y*(0.1791_rk*neg_w4_x)
    t18 = neg_lam3_12*c4 + s4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx + t18
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    t19 = 0.0005151125_rk*(t15 + 0.042198992554119415_rk*t7)
    t20 = 5.8464e-05_rk*s5
    t21 = 5.8464e-05_rk*c5
    t22 = neg_lam5_22*t20 + t21*lam5_12
    t23 = s4*t6 - c4*t14
    t24 = t22 - 0.0174944385_rk*(t18 + 0.029444357416787054_rk*t23)
    t25 = c4*t19 - s4*t24
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.44345_rk*neg_lam3_31 - (0.0068208_rk*neg_lam3_32 + (n4_z - t25))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_zz + ww3_xx
    t26 = lam3_21 - (21.334975369458128_rk*neg_lam3_22 + (s23*t12 + c23*t13))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t21*(t23 + 21.334975369458128_rk*t18) + (neg_w5_x*t3 - (t20*t26 + &
        0.17973436_rk*lam5_12))
    t27 = n5_z + (0.7429401365_rk*alpha4_y - (0.5416401365_rk*neg_ww4_zx + &
        21.334975369458128_rk*(t22 - 0.0008199886897945047_rk*t23)))
    t28 = t16 + (0.1569_rk*ww4_yz - (0.190596722_rk*t1 - s5*t2) - c5*t17)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = 0.0068208_rk*neg_lam3_31 - s4*t27 - c4*t28
    t29 = c4*t24 + s4*t19
    t30 = neg_lam5_22*t21 + (0.006504526_rk*neg_lam3_22 - (t20*lam5_12 + 0.0005151125_rk*t26))
    t31 = c23*t29 + s23*t30
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.001081008566929134_rk*t9 + qdd(1)*(t4*t10 + 2.334879198_rk) - (c23*n3_y - (t4*t25 - &
        (t10*t5 - 7.394088669950739_rk*t31)) + s23*n3_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.44345_rk*lam3_21 + c4*t27 - (t30 + (0.0068208_rk*(neg_lam3_11 - neg_lam3_22) + &
        s4*t28))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t8*(0.001081008566929134_rk*qdd(1) + (t11 + t31)) + (6.305523552_rk*qdd(2) + &
        t4*(c23*t30 - (s23*t29 + 0.40978507086614174_rk)) + n3_z)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! torques that hold the arm at rest
  ! 11 multiplications, 6 additions = 17; 2 unary minus; 7 sine/cosine
  pure subroutine puma560_d2_gravity(q, tau) &
      bind(c, name="puma560_d2_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c5, hw5_y, c4, angle23, s23, c23, s5, hw5_x, tau5, s4, hw4_y, tau4, c2, hw4_x
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
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = c4*hw5_x
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw3_x = c23*(hw4_x - 0.248675_rk) + s23*(8.445591_rk - hw5_y)
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = hw3_x + 14.006062_rk*c2
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
  ! 119 multiplications, 83 additions = 202; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_bias(q, qd, tau) &
      bind(c, name="puma560_d2_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_yz, neg_ww3_zx, ww3_xy, ww3_zz
    real(rk) :: neg_lam3_31, s4, c4, w4_y, w4_z, neg_w4_x, ww4_yz, neg_ww4_zx, c5, s5, neg_w5_x
    real(rk) :: neg_w5_y, w5_z, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, c2, s2, ww2_zz, neg_lam3_32
    real(rk) :: t1, alpha4_x, alpha5_y, n06_z, lam5_32, neg_lam2_33, neg_w2_x, ww3_xx, ww3_yy
    real(rk) :: neg_lam3_11, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17
    real(rk) :: n4_z, t18, alpha4_y, lam5_12, t19, t20, t21, t22, t23, t24, t25, n3_y, neg_lam3_22
    real(rk) :: t26, n5_z, t27, t28, n3_x, t29, t30, t31, n1_z, n3_z, n02_z

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_31 = 2.0_rk*neg_ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    w4_z = neg_w3_y + qd(4)
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_zx = w4_z*neg_w4_x
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = 2.0_rk*neg_ww3_yz
    t1 = ww3_xy*s4 + c4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz - t1
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) + (neg_ww3_zx*c5 - s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.193_rk*alpha5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = neg_ww3_zx*s5 - (neg_w5_y*(qd(5) + w5_z) - c5*alpha4_x)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_lam2_33 - ww3_xx
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_zz + ww3_yy
    t2 = 0.3724_rk*alpha5_y
    t3 = 0.193_rk*(1.9295336787564767_rk*neg_w5_y + qd(6))
    t4 = neg_w2_x*(42.54187192118226_rk*qd(2))
    t5 = neg_lam3_31 - 7.394088669950739_rk*neg_lam2_33 - t4
    t6 = lam5_32 - 299.234375_rk*t1
    t7 = 21.27093596059113_rk*c2
    t8 = t7*ww2_zz
    t9 = 0.06813163062899491_rk*c2
    t10 = t9*neg_lam2_33
    t11 = t8 + 312.203535482957_rk*t10
    t12 = 21.27093596059113_rk*s2
    t13 = t12*ww2_zz + 482.7586206896552_rk
    t14 = c23*t11 - (neg_lam3_11 - s23*t13)
    t15 = c4*t5 - (0.07129854439169339_rk*t6 - s4*t14)
    t16 = 0.0174944385_rk*t15
    t17 = w5_z*t3 + 0.003341862043757506_rk*(53.781451552625_rk*lam5_32 - t16)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = w4_y*(-0.1791_rk*neg_w4_x) - (0.0222_rk*neg_ww3_zx + (c5*t2 + s5*t17))
    t18 = ww3_xy*c4 - s4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx - t18
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    t19 = 0.0005151125_rk*(t15 - 0.042198992554119415_rk*t6)
    t20 = 5.8464e-05_rk*s5
    t21 = 5.8464e-05_rk*c5
    t22 = neg_lam5_22*t20 + t21*lam5_12
    t23 = s4*t5 - c4*t14
    t24 = t22 + 0.0174944385_rk*(t18 - 0.029444357416787054_rk*t23)
    t25 = c4*t19 - s4*t24
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.8869_rk*neg_ww3_zx - (0.0136416_rk*neg_ww3_yz - (t25 - n4_z))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_zz + ww3_xx
    t26 = ww3_xy - (21.334975369458128_rk*neg_lam3_22 + (s23*t11 - c23*t13))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t21*(t23 - 21.334975369458128_rk*t18) + (neg_w5_x*t3 - (t20*t26 + &
        0.17973436_rk*lam5_12))
    t27 = n5_z + (0.7429401365_rk*alpha4_y - (0.5416401365_rk*neg_ww4_zx + &
        21.334975369458128_rk*(t22 - 0.0008199886897945047_rk*t23)))
    t28 = t16 + (0.1569_rk*ww4_yz + (0.190596722_rk*t1 + s5*t2) - c5*t17)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = 0.0136416_rk*neg_ww3_zx - s4*t27 - c4*t28
    t29 = c4*t24 + s4*t19
    t30 = neg_lam5_22*t21 + (0.006504526_rk*neg_lam3_22 - (t20*lam5_12 + 0.0005151125_rk*t26))
    t31 = c23*t29 + s23*t30
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.001081008566929134_rk*t8 - (c23*n3_y - (t7*t25 - (t9*t4 - 7.394088669950739_rk*t31)) &
        + s23*n3_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.44345_rk*ww3_xy + c4*t27 - (t30 + (0.0068208_rk*(neg_lam3_11 - neg_lam3_22) + &
        s4*t28))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t12*(t10 + t31) + (t7*(c23*t30 - (s23*t29 + 0.40978507086614174_rk)) + n3_z)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 53 multiplications, 49 additions = 102; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_mass_matrix(q, M) &
      bind(c, name="puma560_d2_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, nu5_x, nu4_y, t1, t2, m3_4, neg_nu5_y
    real(rk) :: t3, t4, t5, t6, t7, t8, m4_4, t9, m3_5, t10, t11, t12, t13, t14, t15, t16, t17, t18
    real(rk) :: t19, t20, t21, t22, t23, t24, m1_1, t25, t26, m1_3, t27, t28, m1_2, t29, m1_4, t30
    real(rk) :: t31, t32, m1_5, neg_nu3_y, m3_3, t33, m2_3, m2_2, m2_4, m2_5

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
    nu5_x = 0.193_rk*s5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s4*nu5_x
    t1 = 0.9982675647668394_rk*c5
    t2 = t1 - 0.006462839378238342_rk
    ! link 3: mass matrix, its row of this joint
    m3_4 = nu4_y*t2
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.19333494026231143_rk*t1
    t3 = 5.856546086785376e-05_rk*t1
    t4 = t3 + 0.0174944385_rk
    t5 = 21.334975369458128_rk*t4 - 0.1935090545_rk
    t6 = t5 + 0.2155_rk
    t7 = t2*neg_nu5_y
    t8 = 0.1933_rk - t7
    ! link 4: mass matrix, its row of this joint
    m4_4 = t6 - t8
    t9 = 0.0003029222797927461_rk*nu5_x
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t5 - t9
    t10 = 21.27093596059113_rk*c2
    t11 = c4*s23
    t12 = nu5_x*t11
    t13 = t2*t12
    t14 = s23*t4
    t15 = c4*t9
    t16 = t15 - 0.0005151125_rk
    t17 = t10*(t14 + c23*t16)
    t18 = c23*(t13 - (0.0068208_rk*s23 - t14)) - t17
    t19 = 0.0022398341968911917_rk*nu4_y
    t20 = t15 - t19
    t21 = t20 - m4_4
    t22 = m3_5 - c4*t8
    t23 = c4*(t9 - t22)
    t24 = t6 + 0.984970889_rk - t7
    ! link 1: mass matrix, its row of this joint
    m1_1 = t10*(0.0037181511794085144_rk*t10) - (t18 + t20 + t21) - (t18 - (s23*(s23*(t23 - &
        1.103430225_rk + t24)) + 2.807006823_rk))
    t25 = 7.394088669950739_rk*(s23*t16 - c23*t4)
    t26 = s4*s23
    m1_3 = c23*m3_4 + t25 + t22*t26
    t27 = 2.876748834110593_rk*s2
    t28 = t19*t27
    m1_2 = 0.036155585696850394_rk*t27 + (t28 + m1_3)
    t29 = t10*t9
    m1_4 = c4*t29 - c23*t21 - t13
    t30 = c23*t3
    t31 = t10*t3
    t32 = 7.394088669950739_rk*(s23*t9 - c4*t30)
    m1_5 = t5*t26 - (s4*(t30 - t31) - t32)
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = 3301.176792556103_rk*t30 - t12
    ! link 3: mass matrix, its row of this joint
    m3_3 = t24 - t23
    t33 = t17 + t27*t25
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + t33
    m2_2 = m2_3 + (t33 + 6.538587602_rk)
    m2_4 = m3_4 + (c23*t28 - t26*t29)
    m2_5 = t11*t31 + (m3_5 + (c23*t29 + t27*t32))
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = neg_nu3_y
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
    M(29) = 0.17973436_rk
    M(30) = 0.0_rk
    M(31) = neg_nu3_y
    M(32) = nu4_y
    M(33) = nu4_y
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.193_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 232 multiplications, 189 additions, 4 divisions = 425; 2 unary minus; 8 sine/cosine
  pure subroutine puma560_d2_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_d2_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_yz, neg_ww3_zx, ww3_xy, ww3_zz
    real(rk) :: neg_lam3_31, s4, c4, w4_y, w4_z, neg_w4_x, ww4_yz, neg_ww4_zx, c5, s5, neg_w5_x
    real(rk) :: neg_w5_y, w5_z, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, c2, s2, ww2_zz, neg_lam3_32
    real(rk) :: t1, alpha4_x, alpha5_y, n06_z, lam5_32, neg_lam2_33, neg_w2_x, ww3_xx, ww3_yy
    real(rk) :: neg_lam3_11, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17
    real(rk) :: neg_n4_z, t18, alpha4_y, lam5_12, t19, t20, t21, t22, t23, t24, t25, n3_y
    real(rk) :: neg_lam3_22, t26, n5_z, t27, t28, n3_x, t29, t30, t31, n1_z, n3_z, n02_z, nu5_x
    real(rk) :: nu4_y, t32, m3_4, neg_nu5_y, t33, t34, t35, m4_4, t36, neg_m3_5, t37, t38, t39, t40
    real(rk) :: t41, t42, t43, t44, t45, t46, t47, t48, t49, t50, m1_1, t51, t52, m1_3, t53, t54
    real(rk) :: m1_2, t55, neg_m1_4, t56, t57, t58, m1_5, nu3_y, neg_m3_3, t59, m2_3, m2_2, m2_4
    real(rk) :: m2_5, neg_y5, y6, u3_6, neg_u1_6, neg_u3_5, u2_5, u1_5, pivot4, ipivot4, t60, ud3_4
    real(rk) :: u3_4, ud2_4, u2_4, neg_ud1_4, neg_u1_4, t61, neg_pivot3, neg_ipivot3, neg_ud2_3
    real(rk) :: u2_3, t62, ud1_3, neg_u1_3, neg_pivot2, neg_ipivot2, ud1_2, neg_u1_2, pivot1
    real(rk) :: ipivot1, y4, t63, neg_y3, neg_y2, neg_y1, neg_qdd1, qdd2, qdd3, qdd4, qdd5, qdd6
    real(rk) :: t64

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_x = s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: angular velocity [rad/s]
    neg_w3_y = qd(1)*c23
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_31 = 2.0_rk*neg_ww3_zx
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 + neg_w3_x*s4
    w4_z = neg_w3_y + qd(4)
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_zx = w4_z*neg_w4_x
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = 2.0_rk*neg_ww3_yz
    t1 = ww3_xy*s4 + c4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz - t1
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) + (neg_ww3_zx*c5 - s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.193_rk*alpha5_y
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_32 = neg_ww3_zx*s5 - (neg_w5_y*(qd(5) + w5_z) - c5*alpha4_x)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_yy = neg_lam2_33 - ww3_xx
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_zz + ww3_yy
    t2 = 0.3724_rk*alpha5_y
    t3 = 0.193_rk*(1.9295336787564767_rk*neg_w5_y + qd(6))
    t4 = neg_w2_x*(42.54187192118226_rk*qd(2))
    t5 = neg_lam3_31 - 7.394088669950739_rk*neg_lam2_33 - t4
    t6 = lam5_32 - 299.234375_rk*t1
    t7 = 21.27093596059113_rk*c2
    t8 = ww2_zz*t7
    t9 = 0.06813163062899491_rk*c2
    t10 = neg_lam2_33*t9
    t11 = t8 + 312.203535482957_rk*t10
    t12 = 21.27093596059113_rk*s2
    t13 = ww2_zz*t12 + 482.7586206896552_rk
    t14 = c23*t11 - (neg_lam3_11 - s23*t13)
    t15 = c4*t5 - (0.07129854439169339_rk*t6 - s4*t14)
    t16 = 0.0174944385_rk*t15
    t17 = w5_z*t3 + 0.003341862043757506_rk*(53.781451552625_rk*lam5_32 - t16)
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_z = w4_y*(0.1791_rk*neg_w4_x) + (0.0222_rk*neg_ww3_zx + (c5*t2 + s5*t17))
    t18 = ww3_xy*c4 - s4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx - t18
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    t19 = 0.0005151125_rk*(t15 - 0.042198992554119415_rk*t6)
    t20 = 5.8464e-05_rk*s5
    t21 = 5.8464e-05_rk*c5
    t22 = neg_lam5_22*t20 + lam5_12*t21
    t23 = s4*t5 - c4*t14
    t24 = t22 + 0.0174944385_rk*(t18 - 0.029444357416787054_rk*t23)
    t25 = c4*t19 - s4*t24
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.8869_rk*neg_ww3_zx - (0.0136416_rk*neg_ww3_yz - (neg_n4_z + t25))
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_zz + ww3_xx
    t26 = ww3_xy - (21.334975369458128_rk*neg_lam3_22 + (s23*t11 - c23*t13))
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t21*(t23 - 21.334975369458128_rk*t18) + (neg_w5_x*t3 - (t20*t26 + &
        0.17973436_rk*lam5_12))
    t27 = n5_z + (0.7429401365_rk*alpha4_y - (0.5416401365_rk*neg_ww4_zx + &
        21.334975369458128_rk*(t22 - 0.0008199886897945047_rk*t23)))
    t28 = t16 + (0.1569_rk*ww4_yz + (0.190596722_rk*t1 + s5*t2) - c5*t17)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = 0.0136416_rk*neg_ww3_zx - s4*t27 - c4*t28
    t29 = c4*t24 + s4*t19
    t30 = neg_lam5_22*t21 + (0.006504526_rk*neg_lam3_22 - (lam5_12*t20 + 0.0005151125_rk*t26))
    t31 = c23*t29 + s23*t30
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.001081008566929134_rk*t8 - (c23*n3_y - (t7*t25 - (t4*t9 - 7.394088669950739_rk*t31)) &
        + s23*n3_x)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.44345_rk*ww3_xy + c4*t27 - (t30 + (0.0068208_rk*(neg_lam3_11 - neg_lam3_22) + &
        s4*t28))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t12*(t10 + t31) + (n3_z + t7*(c23*t30 - (s23*t29 + 0.40978507086614174_rk)))
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_x = 0.193_rk*s5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = s4*nu5_x
    t32 = 0.9982675647668394_rk*c5 - 0.006462839378238342_rk
    ! link 3: mass matrix, its row of this joint
    m3_4 = nu4_y*t32
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.193_rk*c5
    t33 = t21 + 0.0174944385_rk
    t34 = 21.334975369458128_rk*t33
    t35 = t32*neg_nu5_y
    ! link 4: mass matrix, its row of this joint
    m4_4 = t34 + t35 - 0.1713090545_rk
    t36 = t34 - 0.1935090545_rk
    ! link 3: mass matrix, its row of this joint
    neg_m3_5 = t20 - c4*t36
    t37 = s23*c4
    t38 = nu5_x*t37
    t39 = t32*t38
    t40 = s23*t33
    t41 = c4*t20
    t42 = t41 - 0.0005151125_rk
    t43 = t7*(t40 + c23*t42)
    t44 = c23*(t39 - (0.0068208_rk*s23 - t40)) - t43
    t45 = 0.0022398341968911917_rk*nu4_y
    t46 = t41 - t45
    t47 = m4_4 - t46
    t48 = neg_m3_5 - c4*(t35 - 0.1933_rk)
    t49 = c4*(t20 + t48)
    t50 = t35 - (t34 + 1.0069618345_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t7*(0.0790885556289949_rk*c2) - (t44 + t46 - t47) - (t44 - (s23*(s23*(t49 - &
        1.103430225_rk - t50)) + 2.807006823_rk))
    t51 = 7.394088669950739_rk*(s23*t42 - c23*t33)
    t52 = s23*s4
    m1_3 = c23*m3_4 + t51 - t48*t52
    t53 = 2.876748834110593_rk*s2
    t54 = t45*t53
    m1_2 = 0.104010539_rk*s2 + (m1_3 + t54)
    t55 = t7*t20
    neg_m1_4 = t39 - (c4*t55 + c23*t47)
    t56 = c23*t21
    t57 = t7*t21
    t58 = 7.394088669950739_rk*(s23*t20 - c4*t56)
    m1_5 = t36*t52 - (s4*(t56 - t57) - t58)
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = t38 - 3301.176792556103_rk*t56
    ! link 3: mass matrix, its row of this joint
    neg_m3_3 = t49 + t50
    t59 = t43 + t51*t53
    ! link 2: mass matrix, its row of this joint
    m2_3 = t59 - neg_m3_3
    m2_2 = m2_3 + (t59 + 6.538587602_rk)
    m2_4 = m3_4 + (c23*t54 - t52*t55)
    m2_5 = t37*t57 - (neg_m3_5 - (c23*t55 + t53*t58))
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    y6 = tau(6) - n06_z
    ! factorisation M = U D U^T
    u3_6 = 5.181347150259067_rk*nu4_y
    neg_u1_6 = 5.181347150259067_rk*nu3_y
    neg_u3_5 = 5.56376643842613_rk*neg_m3_5
    u2_5 = 5.56376643842613_rk*m2_5
    u1_5 = 5.56376643842613_rk*m1_5
    pivot4 = m4_4 - c5*neg_nu5_y
    ipivot4 = 1.0_rk / pivot4
    t60 = neg_nu5_y*u3_6
    ud3_4 = m3_4 - t60
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 - t60
    u2_4 = ipivot4*ud2_4
    neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6
    neg_u1_4 = ipivot4*neg_ud1_4
    t61 = nu4_y*u3_6
    neg_pivot3 = neg_m3_3 + t61 + neg_m3_5*neg_u3_5 + ud3_4*u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = t61 - m2_3 - neg_m3_5*u2_5 + ud3_4*u2_4
    u2_3 = neg_ipivot3*neg_ud2_3
    t62 = nu4_y*neg_u1_6
    ud1_3 = m1_3 + t62 + neg_m3_5*u1_5 + ud3_4*neg_u1_4
    neg_u1_3 = neg_ipivot3*ud1_3
    neg_pivot2 = t61 - m2_2 + m2_5*u2_5 + ud2_4*u2_4 - neg_ud2_3*u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ud1_2 = m1_2 + t62 - m2_5*u1_5 + ud2_4*neg_u1_4 - neg_ud2_3*neg_u1_3
    neg_u1_2 = neg_ipivot2*ud1_2
    pivot1 = m1_1 - nu3_y*neg_u1_6 - m1_5*u1_5 - neg_ud1_4*neg_u1_4 + ud1_3*neg_u1_3 + &
        ud1_2*neg_u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 4: forward substitution
    y4 = neg_n4_z + tau(4) - c5*y6
    t63 = y6*u3_6
    ! link 3: forward substitution
    neg_y3 = n3_z - tau(3) + t63 + neg_y5*neg_u3_5 + u3_4*y4
    ! link 2: forward substitution
    neg_y2 = n02_z - tau(2) + t63 - neg_y5*u2_5 + u2_4*y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1) - y6*neg_u1_6 - neg_y5*u1_5 - neg_u1_4*y4 + neg_u1_3*neg_y3 + &
        neg_u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_ipivot2*neg_y2 - neg_u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 - neg_u1_3*neg_qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = ipivot4*y4 - u3_4*qdd3 - u2_4*qdd2 - neg_u1_4*neg_qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = u1_5*neg_qdd1 - (5.56376643842613_rk*neg_y5 - neg_u3_5*qdd3 + u2_5*qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = u3_6*(-qdd2 - qdd3) - (neg_u1_6*neg_qdd1 - (5.181347150259067_rk*y6 - c5*qdd4))
    t64 = -neg_qdd1
    qdd(1) = t64
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
