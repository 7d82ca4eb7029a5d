! puma560: PUMA 560, six joints
! Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
! Origin of numbers: geometry: stated by the description
! Origin of numbers: rotor inertia; inertia (joints 1 to 3); mass, centre of mass (joints 2, 3):
!     measured on the arm
! Origin of numbers: limits; mass, centre of mass, inertia (joints 4 to 6): assumed
! Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: b422b6e98684ac1e67f70c9b558f78f5 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0        d 0        theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
!   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
!   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
!   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
!   5  revolute  alpha -pi/2  a 0        d 0        theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
!   6  revolute  alpha pi/2   a 0        d 0        theta q
!       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
! Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
! Arguments, in SI units, joint 1 first:
!   q    joint positions [rad, prismatic m]
!   qd   joint velocities [rad/s, prismatic m/s]
!   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
!   tau  joint torques [N m, prismatic N]
!   M    mass matrix, row by row [kg m^2, kg m, kg]
! Torques are the motors', reflected to the joints; what lies between is in them.
! Effects in this model:
!   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2, joint 4 0.2 kg
!     m^2, joint 5 0.179 kg m^2, joint 6 0.193 kg m^2
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 6.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
!   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
!   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
!   mass_matrix: 55 multiplications, 55 additions = 110; 1 unary minus; 8 sine/cosine
!   forward_dynamics: 246 multiplications, 204 additions, 4 divisions = 454; 9 unary minus; 8
!       sine/cosine
module puma560_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_inverse_dynamics
  public :: puma560_gravity
  public :: puma560_bias
  public :: puma560_mass_matrix
  public :: puma560_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! with rotor inertia
  ! 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, alpha3_z, neg_lam3_13, neg_ww3_zx
    real(rk) :: alpha3_y, ww3_xy, ww3_yy, ww3_zz, neg_lam3_12, neg_lam2_33, neg_lam3_11
    real(rk) :: neg_lam3_31, lam3_21, s4, c4, w4_y, w4_z, neg_w4_x, ww4_yz, alpha4_z, neg_ww4_zx
    real(rk) :: c5, s5, neg_w5_x, w5_y, w5_z, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, c2, s2
    real(rk) :: ww2_zz, neg_lam3_32, t1, neg_lam5_12, t2, alpha4_x, neg_ww5_zx, alpha5_y, n06_z, t3
    real(rk) :: t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, n4_z
    real(rk) :: t21, t22, t23, t24, t25, t26, t27, n3_y, n4_x, t28, lam3_22, t29, t30, n5_z, nc4_y
    real(rk) :: t31, t32, n3_x, t33, t34, t35, t36, t37, t38, t39, t40, t41, t42, t43, tau1, n3_z
    real(rk) :: t44, tau2, tau3, tau4, tau5, tau6

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
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_13 = c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww3_zx - neg_lam3_13
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_12 = alpha3_z - ww3_xy
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    lam3_21 = alpha3_z + ww3_xy
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = neg_w3_x*s4 + w3_z*c4
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
    w5_y = neg_w4_x*s5 - w4_z*c5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_xy = neg_w5_x*w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = s23*qdd(1) + w3_z*(2.0_rk*neg_w3_y)
    t1 = neg_lam3_12*c4 + s4*neg_lam3_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy + t1) + qdd(5)
    t2 = neg_lam3_12*s4 - c4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz + t2
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_w5_x*qd(5) - s5*alpha4_x - alpha4_z*c5
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = 4e-05_rk*(qdd(6) - alpha5_y)
    t3 = 0.0002_rk*w5_y
    t4 = t3 - 4e-05_rk*w6_z
    t5 = 0.000432288_rk*s5
    t6 = 0.000432288_rk*c5
    t7 = 0.000432288_rk*(w5_y*(qd(5) + w5_z)) - (alpha4_z*t5 - t6*alpha4_x)
    t8 = 2.876748834110593_rk*s2
    t9 = 2.876748834110593_rk*c2
    t10 = qdd(2)*t8 + (qdd(1) + t9*(neg_lam2_33 + ww2_zz))
    t11 = ww2_zz*t8
    t12 = t11 - (qdd(2)*t9 - 65.28980679546969_rk)
    t13 = 0.13524317121918722_rk*neg_lam3_11 - (c23*t10 + s23*t12)
    t14 = 2.0_rk*(qd(2)*qd(1))
    t15 = 0.13524317121918722_rk*neg_lam3_31 - (neg_lam2_33 - qdd(1)*t9) - t14*t8
    t16 = s4*t13 - c4*t15
    t17 = t7 + 0.044830870394712535_rk*t16
    t18 = 0.1293554295_rk*t2 + t17
    t19 = w5_z*t4 - 0.00964264124684461_rk*(t18 + 129.06435256003232_rk*t7)
    t20 = 0.0001_rk*neg_ww5_zx - n06_z + 0.0003_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.0013_rk*alpha4_z + s5*t19 - c5*t20
    t21 = 46.378743915669716_rk*neg_lam3_12
    t22 = 67.24917867772109_rk*neg_lam3_32
    t23 = c4*t13 + s4*t15
    t24 = neg_lam5_22*t5 - t6*neg_lam5_12
    t25 = 0.0281625125_rk*t23 - (t24 - 0.1293554295_rk*t1)
    t26 = 0.01666835789471254_rk*t16 - t18
    t27 = s4*t25 + c4*t26
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.13524317121918722_rk*(0.0007499511665665606_rk*(t21 - t22) + t27) + &
        (0.01625_rk*neg_lam3_31 - n4_z)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.0013_rk*ww4_yz - s5*t20 - c5*t19
    t28 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t28 - neg_lam2_33
    t29 = c23*t12 + (0.13524317121918722_rk*lam3_21 - s23*t10)
    t30 = -2.8854097268487675_rk*lam3_22 - t29
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t5*t30 + (0.00064216_rk*neg_lam5_12 + t6*(t23 + 2.8854097268487675_rk*t1) - &
        neg_w5_x*(t3 + t4))
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.0013_rk*neg_ww4_zx
    t31 = 2.8854097268487675_rk*t17 + n4_x
    t32 = 2.8854097268487675_rk*t24 - n5_z - (nc4_y + 0.1293554295_rk*t23)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = c4*t31 - 0.004704_rk*(t22 - t28) + (0.0068208_rk*neg_lam3_31 + s4*t32)
    t33 = 0.0141984_rk*c2
    t34 = t33 + 0.3642398174241758_rk*s2
    t35 = t34 - 0.36469509561966457_rk*s2
    t36 = 1.6727941176470589_rk*t34
    t37 = s2*t33
    t38 = c2*t33
    t39 = 96.40502817218841_rk*(t37 - 7.363931254000739e-05_rk) + t38
    t40 = ww2_zz*(42.91316091954023_rk*t35) + (qdd(2)*t36 - t39*t14) + &
        (qdd(1)*(96.40502817218841_rk*t38 - (t37 - 2.646693438_rk)) - (c23*n3_y - t9*t27))
    t41 = c4*t25 - s4*t26
    t42 = 0.01666835789471254_rk*(t29 + 2.689579302165907_rk*t30) + (neg_lam5_22*t6 + &
        t5*neg_lam5_12)
    t43 = c23*t41 - s23*t42
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t40 - s23*n3_x - t43 - 0.0014646998319327732_rk*t11
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.0068208_rk*(t21 - (neg_lam3_11 + lam3_22 - (2.382418484635233_rk*lam3_21 - &
        19.8280511405095_rk*t42))) - 0.004704_rk*neg_lam3_13 + (s4*t31 - c4*t32)
    t44 = 6.225049952_rk*qdd(2) + neg_lam2_33*t39 + (n3_z - (2247.2413793103447_rk*t35 - &
        t9*(s23*t41 + c23*t42)))
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = t44 - (t8*t43 - qdd(1)*t36)
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = n3_z + 0.83_rk*qdd(3)
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = n4_z + 0.2_rk*qdd(4)
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = n5_z + 0.179_rk*qdd(5)
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = n06_z + 0.193_rk*qdd(6)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques that hold the arm at rest
  ! 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
  pure subroutine puma560_gravity(q, tau) &
      bind(c, name="puma560_gravity_f")
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
  ! 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_bias(q, qd, tau) &
      bind(c, name="puma560_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_zx, ww3_xy, ww3_yy, ww3_zz
    real(rk) :: neg_lam2_33, neg_lam3_11, s4, c4, w4_y, w4_z, neg_w4_x, ww4_yz, neg_ww4_zx, c5, s5
    real(rk) :: neg_w5_x, w5_y, w5_z, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, c2, s2, ww2_zz
    real(rk) :: neg_lam3_32, t1, neg_lam5_12, t2, alpha4_x, neg_ww5_zx, alpha5_y, n06_z, t3, t4, t5
    real(rk) :: t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, n4_z, t21
    real(rk) :: t22, t23, t24, t25, t26, t27, neg_n3_y, n4_x, t28, lam3_22, t29, t30, n5_z, nc4_y
    real(rk) :: t31, t32, n3_x, t33, t34, t35, t36, t37, t38, t39, tau1, n3_z, tau2

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
    neg_ww3_zx = w3_z*neg_w3_x
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_yy = neg_w3_y*neg_w3_y
    ww3_zz = w3_z*w3_z
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = neg_w3_x*s4 + w3_z*c4
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
    w5_y = neg_w4_x*s5 - w4_z*c5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_xy = neg_w5_x*w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = w3_z*(2.0_rk*neg_w3_y)
    t1 = ww3_xy*c4 - s4*neg_lam3_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_12 = neg_ww4_zx + (neg_ww5_xy - t1)
    t2 = ww3_xy*s4 + c4*neg_lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz - t2
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww3_zx*c5 + (neg_w5_x*qd(5) - s5*alpha4_x)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -4e-05_rk*alpha5_y
    t3 = 0.0002_rk*w5_y
    t4 = t3 - 4e-05_rk*w6_z
    t5 = 0.000432288_rk*s5
    t6 = 0.000432288_rk*c5
    t7 = 0.000432288_rk*(w5_y*(qd(5) + w5_z)) + (neg_ww3_zx*t5 + t6*alpha4_x)
    t8 = 2.876748834110593_rk*c2
    t9 = t8*(neg_lam2_33 + ww2_zz)
    t10 = 2.876748834110593_rk*s2
    t11 = ww2_zz*t10
    t12 = t11 + 65.28980679546969_rk
    t13 = 0.13524317121918722_rk*neg_lam3_11 - (c23*t9 + s23*t12)
    t14 = 2.0_rk*(qd(2)*qd(1))
    t15 = neg_lam2_33 - 0.27048634243837444_rk*neg_ww3_zx + t14*t10
    t16 = s4*t13 + c4*t15
    t17 = t7 + 0.044830870394712535_rk*t16
    t18 = 0.1293554295_rk*t2 - t17
    t19 = w5_z*t4 + 0.00964264124684461_rk*(t18 - 129.06435256003232_rk*t7)
    t20 = 0.0001_rk*neg_ww5_zx - n06_z + 0.0003_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = s5*t19 - 0.0013_rk*neg_ww3_zx - c5*t20
    t21 = 46.378743915669716_rk*ww3_xy
    t22 = 67.24917867772109_rk*neg_lam3_32
    t23 = c4*t13 - s4*t15
    t24 = neg_lam5_22*t5 - t6*neg_lam5_12
    t25 = 0.0281625125_rk*t23 - (t24 + 0.1293554295_rk*t1)
    t26 = 0.01666835789471254_rk*t16 + t18
    t27 = s4*t25 + c4*t26
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = 0.13524317121918722_rk*(0.0007499511665665606_rk*(t21 + t22) - t27) - &
        (0.0325_rk*neg_ww3_zx - n4_z)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.0013_rk*ww4_yz - s5*t20 - c5*t19
    t28 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = t28 - neg_lam2_33
    t29 = c23*t12 + (0.13524317121918722_rk*ww3_xy - s23*t9)
    t30 = -2.8854097268487675_rk*lam3_22 - t29
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t5*t30 + (0.00064216_rk*neg_lam5_12 + t6*(t23 - 2.8854097268487675_rk*t1) - &
        neg_w5_x*(t3 + t4))
    ! link 4: moment that turns the link [N m]
    nc4_y = 0.0013_rk*neg_ww4_zx
    t31 = 2.8854097268487675_rk*t17 + n4_x
    t32 = 2.8854097268487675_rk*t24 - n5_z - (nc4_y + 0.1293554295_rk*t23)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = c4*t31 - 0.004704_rk*(t22 - t28) + (0.0136416_rk*neg_ww3_zx + s4*t32)
    t33 = 0.0141984_rk*c2
    t34 = t33 - 0.0004552781954887218_rk*s2
    t35 = 96.40502817218841_rk*(s2*t33 - 7.363931254000739e-05_rk) + c2*t33
    t36 = ww2_zz*(42.91316091954023_rk*t34) - t35*t14 + (c23*neg_n3_y + t8*t27) - s23*n3_x
    t37 = c4*t25 - s4*t26
    t38 = 0.01666835789471254_rk*(t29 + 2.689579302165907_rk*t30) + (neg_lam5_22*t6 + &
        t5*neg_lam5_12)
    t39 = c23*t37 - s23*t38
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t36 - t39 - 0.0014646998319327732_rk*t11
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = s4*t31 - c4*t32 - 0.0068208_rk*(t21 + (neg_lam3_11 + lam3_22 - &
        (2.382418484635233_rk*ww3_xy - 19.8280511405095_rk*t38)))
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = neg_lam2_33*t35 - (2247.2413793103447_rk*t34 - t8*(s23*t37 + c23*t38) - n3_z) - t10*t39
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 55 multiplications, 55 additions = 110; 1 unary minus; 8 sine/cosine
  pure subroutine puma560_mass_matrix(q, M) &
      bind(c, name="puma560_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, neg_nu5_y, t1, t2, nu4_y, t3, t4, m3_5
    real(rk) :: t5, t6, t7, t8, m4_4, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20
    real(rk) :: t21, t22, t23, m1_1, m3_4, t24, t25, m1_3, t26, t27, m1_2, t28, m1_4, t29, t30, t31
    real(rk) :: m1_5, neg_nu3_y, t32, t33, m2_3, m2_2, m2_4, m2_5, m3_3

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
    neg_nu5_y = 4e-05_rk*c5
    t1 = 5.8464e-05_rk*s5
    t2 = s4*t1
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.6841817186644773_rk*t2
    t3 = 31.1832_rk*neg_nu5_y
    t4 = t3 + 0.00064216_rk
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t4 - t1
    t5 = 1.4616_rk*neg_nu5_y
    t6 = 59145.01926194356_rk*t5 + 21.334975369458128_rk
    t7 = t5*t6
    t8 = t3 - t7
    ! link 4: mass matrix, its row of this joint
    m4_4 = t8 + 0.20184216_rk
    t9 = t7 + 0.00034_rk
    t10 = t3 + (t9 - 6.125008753_rk)
    t11 = c4*t9 - m3_5
    t12 = c4*(t1 + t11)
    t13 = 21.27093596059113_rk*c2
    t14 = c4*t1
    t15 = t14 - 0.0005151125_rk
    t16 = t5 + 0.0174944385_rk
    t17 = t13*(c23*t15 + s23*t16)
    t18 = 7.394088669950739_rk*t2
    t19 = t18 - (t14 - (t8 + 0.00184216_rk))
    t20 = s23*t14
    t21 = t6*t20
    t22 = t17 + 4.45115636_rk + (t19 + c23*(t21 - s23*(t16 - 0.0068208_rk)))
    t23 = 0.008863689302339443_rk*s2
    ! link 1: mass matrix, its row of this joint
    m1_1 = s23*(s23*(t10 + 6.423043777_rk + t12)) + t22 - (m4_4 - (t22 + 1.601861202_rk*(c2*(c2 - &
        t23) - 3.7523173977217037_rk)))
    ! link 3: mass matrix, its row of this joint
    m3_4 = -t2*t6
    t24 = 7.394088669950739_rk*(s23*t15 - c23*t16)
    t25 = s4*s23
    ! link 1: mass matrix, its row of this joint
    m1_3 = t24 - t11*t25 - c23*(0.004704_rk - m3_4)
    t26 = 324.55434029612445_rk*t23
    t27 = t18*t26
    m1_2 = 0.023751_rk*c2 + m1_3 + t27 + 0.23996349309842518_rk*t26
    t28 = t1*t13
    m1_4 = t21 + (c4*t28 + c23*t19)
    t29 = c23*t5
    t30 = 7.394088669950739_rk*(s23*t1 - c4*t29)
    t31 = t5*t13
    m1_5 = t4*t25 + t30 - s4*(t29 - t31)
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = 0.6841817186644773_rk*(t29 - t20)
    t32 = t17 + 6.458114002_rk + t24*t26
    t33 = t10 - t12
    ! link 2: mass matrix, its row of this joint
    m2_3 = t32 + t33
    m2_2 = t32 + m2_3
    m2_4 = m3_4 + c23*t27 - t25*t28
    m2_5 = t26*t30 + (c4*(s23*t31) + (m3_5 + c23*t28))
    ! link 3: mass matrix, its row of this joint
    m3_3 = t33 + 7.288114002_rk
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
    M(29) = 0.17964216_rk
    M(30) = 0.0_rk
    M(31) = neg_nu3_y
    M(32) = nu4_y
    M(33) = nu4_y
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.19304_rk
  end subroutine

  ! accelerations that the torques tau give
  ! with rotor inertia
  ! 246 multiplications, 204 additions, 4 divisions = 454; 9 unary minus; 8 sine/cosine
  pure subroutine puma560_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: w3_z, angle23, s23, w3_x, c23, t1, w3_y, ww3_zx, ww3_xy, ww3_yy, ww3_zz, lam2_33
    real(rk) :: neg_lam3_11, s4, c4, w4_y, w4_z, w4_x, ww4_yz, ww4_zx, c5, s5, w5_x, w5_y, w5_z
    real(rk) :: ww5_xy, ww5_xx, ww5_zz, lam5_22, w6_z, c2, s2, ww2_zz, lam3_32, t2, lam5_12, t3
    real(rk) :: alpha4_x, ww5_zx, alpha5_y, neg_n06_z, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13
    real(rk) :: t14, t15, t16, t17, t18, t19, t20, t21, n4_z, t22, t23, t24, t25, t26, t27, t28
    real(rk) :: n3_y, n4_x, t29, lam3_22, t30, t31, n5_z, neg_nc4_y, t32, t33, n3_x, t34, t35, t36
    real(rk) :: t37, t38, t39, t40, tau1, n3_z, tau2, nu5_y, t41, t42, nu4_y, t43, t44, m3_5, t45
    real(rk) :: t46, t47, t48, m4_4, t49, t50, t51, t52, t53, t54, t55, t56, t57, t58, t59, t60
    real(rk) :: t61, m1_1, neg_m3_4, t62, t63, m1_3, t64, m1_2, t65, m1_4, t66, t67, t68, m1_5, t69
    real(rk) :: nu3_y, t70, t71, m2_3, m2_2, m2_4, m2_5, m3_3, y5, y6, u4_6, u3_6, u1_6, u3_5, u2_5
    real(rk) :: u1_5, pivot4, ipivot4, t72, ud3_4, u3_4, ud2_4, u2_4, ud1_4, u1_4, t73, pivot3
    real(rk) :: ipivot3, ud2_3, u2_3, t74, ud1_3, u1_3, pivot2, ipivot2, ud1_2, u1_2, pivot1
    real(rk) :: ipivot1, neg_y4, t75, y3, y2, t76, y1, qdd1, qdd2, qdd3, qdd4, qdd5, qdd6

    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_x = -s23*qd(1)
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    t1 = -qd(1)
    ! link 3: angular velocity [rad/s]
    w3_y = t1*c23
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zx = w3_z*w3_x
    ww3_xy = w3_x*w3_y
    ww3_yy = w3_y*w3_y
    ww3_zz = w3_z*w3_z
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = t1*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_yy + ww3_zz
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    c4 = cos(q(4))
    ! link 4: angular velocity [rad/s]
    w4_y = w3_z*c4 - w3_x*s4
    w4_z = qd(4) - w3_y
    w4_x = w3_x*c4 + w3_z*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_zx = w4_z*w4_x
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 - w4_z*s5
    w5_y = -w4_z*c5 - w4_x*s5
    w5_z = w4_y + qd(5)
    ! link 5: products of the angular velocity [1/s^2]
    ww5_xy = w5_x*w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_22 = -ww5_xx - ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = qd(6) - w5_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_32 = w3_z*(2.0_rk*w3_y)
    t2 = ww3_xy*c4 + s4*lam3_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww4_zx + (ww5_xy + t2)
    t3 = ww3_xy*s4 - c4*lam3_32
    ! link 4: angular acceleration [rad/s^2]
    alpha4_x = ww4_yz - t3
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = -s5*alpha4_x - w5_x*qd(5) - ww3_zx*c5
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    neg_n06_z = 4e-05_rk*alpha5_y
    t4 = 0.0002_rk*w5_y
    t5 = t4 - 4e-05_rk*w6_z
    t6 = 0.000432288_rk*c5
    t7 = 0.000432288_rk*s5
    t8 = 0.000432288_rk*(w5_y*(qd(5) + w5_z)) + (alpha4_x*t6 - ww3_zx*t7)
    t9 = 2.876748834110593_rk*c2
    t10 = t9*(ww2_zz - lam2_33)
    t11 = 2.876748834110593_rk*s2
    t12 = ww2_zz*t11
    t13 = t12 + 65.28980679546969_rk
    t14 = 0.13524317121918722_rk*neg_lam3_11 - (c23*t10 + s23*t13)
    t15 = 2.0_rk*(qd(2)*qd(1))
    t16 = t11*t15 - (lam2_33 - 0.27048634243837444_rk*ww3_zx)
    t17 = s4*t14 + c4*t16
    t18 = t8 + 0.044830870394712535_rk*t17
    t19 = 0.1293554295_rk*t3 - t18
    t20 = w5_z*t5 + 0.00964264124684461_rk*(t19 - 129.06435256003232_rk*t8)
    t21 = neg_n06_z - 0.0001_rk*ww5_zx + 0.0003_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = s5*t20 + 0.0013_rk*ww3_zx - c5*t21
    t22 = 46.378743915669716_rk*ww3_xy
    t23 = -67.24917867772109_rk*lam3_32
    t24 = c4*t14 - s4*t16
    t25 = lam5_12*t6 - lam5_22*t7
    t26 = 0.0281625125_rk*t24 - (t25 + 0.1293554295_rk*t2)
    t27 = t19 + 0.01666835789471254_rk*t17
    t28 = s4*t26 + c4*t27
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = -0.0325_rk*ww3_zx - n4_z - 0.13524317121918722_rk*(0.0007499511665665606_rk*(t22 + t23) &
        - t28)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 0.0013_rk*ww4_yz - s5*t21 - c5*t20
    t29 = ww3_yy - ww3_zz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_22 = lam2_33 + t29
    t30 = c23*t13 + (0.13524317121918722_rk*ww3_xy - s23*t10)
    t31 = -2.8854097268487675_rk*lam3_22 - t30
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t7*t31 + (t6*(t24 - 2.8854097268487675_rk*t2) - 0.00064216_rk*lam5_12 + w5_x*(t4 + t5))
    ! link 4: moment that turns the link [N m]
    neg_nc4_y = 0.0013_rk*ww4_zx
    t32 = n4_x + 2.8854097268487675_rk*t18
    t33 = n5_z - 2.8854097268487675_rk*t25 + (0.1293554295_rk*t24 - neg_nc4_y)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = c4*t32 - 0.004704_rk*(t23 - t29) + (-0.0136416_rk*ww3_zx - s4*t33)
    t34 = 0.0141984_rk*c2
    t35 = t34 - 0.0004552781954887218_rk*s2
    t36 = 96.40502817218841_rk*(s2*t34 - 7.363931254000739e-05_rk) + c2*t34
    t37 = ww2_zz*(42.91316091954023_rk*t35) - t15*t36 + (t9*t28 - c23*n3_y) - s23*n3_x
    t38 = c4*t26 - s4*t27
    t39 = 0.01666835789471254_rk*(t30 + 2.689579302165907_rk*t31) + (-lam5_12*t7 - lam5_22*t6)
    t40 = c23*t38 - s23*t39
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t37 - t40 - 0.0014646998319327732_rk*t12
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = s4*t32 + c4*t33 - 0.0068208_rk*(t22 + (neg_lam3_11 + lam3_22 - &
        (2.382418484635233_rk*ww3_xy - 19.8280511405095_rk*t39)))
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = n3_z - (2247.2413793103447_rk*t35 - t9*(s23*t38 + c23*t39)) - lam2_33*t36 - t11*t40
    ! link 5: moment for a unit acceleration of a joint further out
    nu5_y = -4e-05_rk*c5
    t41 = 5.8464e-05_rk*s5
    t42 = s4*t41
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.6841817186644773_rk*t42
    t43 = 0.001247328_rk*c5
    t44 = t43 + 0.00064216_rk
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t44 - t41
    t45 = 5.8464e-05_rk*c5
    t46 = 3.4578544061302683_rk*c5 + 21.334975369458128_rk
    t47 = t45*t46
    t48 = t43 - t47
    ! link 4: mass matrix, its row of this joint
    m4_4 = t48 + 0.20184216_rk
    t49 = t43 + (t47 - 6.124668753_rk)
    t50 = c4*(t47 + 0.00034_rk) - m3_5
    t51 = c4*(t41 + t50)
    t52 = 21.27093596059113_rk*c2
    t53 = c4*t41
    t54 = t53 - 0.0005151125_rk
    t55 = t45 + 0.0174944385_rk
    t56 = t52*(c23*t54 + s23*t55)
    t57 = 7.394088669950739_rk*t42
    t58 = t57 - (t53 - (t48 + 0.00184216_rk))
    t59 = s23*t53
    t60 = t46*t59
    t61 = t56 + 4.45115636_rk + (t58 + c23*(t60 - s23*(t45 + 0.0106736385_rk)))
    ! link 1: mass matrix, its row of this joint
    m1_1 = s23*(s23*(t49 + 6.423043777_rk + t51)) + t61 - (m4_4 - (t61 + 1.601861202_rk*(c2*(c2 - &
        0.008863689302339443_rk*s2) - 3.7523173977217037_rk)))
    ! link 3: mass matrix, its row of this joint
    neg_m3_4 = t42*t46
    t62 = 7.394088669950739_rk*(s23*t54 - c23*t55)
    t63 = s23*s4
    ! link 1: mass matrix, its row of this joint
    m1_3 = t62 - t50*t63 - c23*(neg_m3_4 + 0.004704_rk)
    t64 = t11*t57
    m1_2 = m1_3 + 0.023751_rk*c2 + t64 + 0.690314699_rk*s2
    t65 = t41*t52
    m1_4 = t60 + (c4*t65 + c23*t58)
    t66 = c23*t45
    t67 = 7.394088669950739_rk*(s23*t41 - c4*t66)
    t68 = t45*t52
    m1_5 = t44*t63 + t67 - s4*(t66 - t68)
    t69 = t66 - t59
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = -0.6841817186644773_rk*t69
    t70 = t56 + 6.458114002_rk + t11*t62
    t71 = t49 - t51
    ! link 2: mass matrix, its row of this joint
    m2_3 = t70 + t71
    m2_2 = t70 + m2_3
    m2_4 = c23*t64 - neg_m3_4 - t63*t65
    m2_5 = t11*t67 + (c4*(s23*t68) + (m3_5 + c23*t65))
    ! link 3: mass matrix, its row of this joint
    m3_3 = t71 + 7.288114002_rk
    ! link 5: forward substitution
    y5 = tau(5) - n5_z
    ! link 6: forward substitution
    y6 = neg_n06_z + tau(6)
    ! factorisation M = U D U^T
    u4_6 = 0.00020721094073767094_rk*c5
    u3_6 = 3.5442484389995714_rk*t42
    u1_6 = 3.5442484389995714_rk*t69
    u3_5 = 5.566622000091738_rk*m3_5
    u2_5 = 5.566622000091738_rk*m2_5
    u1_5 = 5.566622000091738_rk*m1_5
    pivot4 = m4_4 + nu5_y*u4_6
    ipivot4 = 1.0_rk / pivot4
    t72 = nu5_y*u3_6
    ud3_4 = t72 - neg_m3_4
    u3_4 = ipivot4*ud3_4
    ud2_4 = m2_4 + t72
    u2_4 = ipivot4*ud2_4
    ud1_4 = m1_4 + nu5_y*u1_6
    u1_4 = ipivot4*ud1_4
    t73 = nu4_y*u3_6
    pivot3 = m3_3 - t73 - m3_5*u3_5 - ud3_4*u3_4
    ipivot3 = 1.0_rk / pivot3
    ud2_3 = m2_3 - t73 - m3_5*u2_5 - ud3_4*u2_4
    u2_3 = ipivot3*ud2_3
    t74 = nu4_y*u1_6
    ud1_3 = m1_3 - t74 - m3_5*u1_5 - ud3_4*u1_4
    u1_3 = ipivot3*ud1_3
    pivot2 = m2_2 - t73 - m2_5*u2_5 - ud2_4*u2_4 - ud2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 - t74 - m2_5*u1_5 - ud2_4*u1_4 - ud2_3*u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 + nu3_y*u1_6 - m1_5*u1_5 - ud1_4*u1_4 - ud1_3*u1_3 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) + y6*u4_6
    t75 = y6*u3_6
    ! link 3: forward substitution
    y3 = u3_4*neg_y4 - (n3_z - tau(3) + t75 + y5*u3_5)
    ! link 2: forward substitution
    y2 = u2_4*neg_y4 - (tau2 - tau(2) + t75 + y5*u2_5) - u2_3*y3
    t76 = -(tau1 - tau(1) + y6*u1_6 + y5*u1_5 - u1_4*neg_y4 + u1_3*y3)
    ! link 1: forward substitution
    y1 = t76 - u1_2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3 - u2_3*qdd2 - u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = -u2_4*qdd2 - (ipivot4*neg_y4 + u3_4*qdd3) - u1_4*qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = -(u3_5*qdd3 - 5.566622000091738_rk*y5 + u2_5*qdd2) - u1_5*qdd1
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = 5.180273518441774_rk*y6 - u4_6*qdd4 - u1_6*qdd1 - u3_6*(qdd2 + qdd3)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
