! puma560: PUMA 560, six joints
! Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
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
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
!   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
!   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
!   mass_matrix: 58 multiplications, 55 additions = 113; 1 unary minus; 8 sine/cosine
!   forward_dynamics: 249 multiplications, 204 additions, 4 divisions = 457; 2 unary minus; 8
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
  ! 58 multiplications, 55 additions = 113; 1 unary minus; 8 sine/cosine
  pure subroutine puma560_mass_matrix(q, M) &
      bind(c, name="puma560_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, neg_nu5_y, t1, t2, t3, m3_5, t4, h4_x
    real(rk) :: t5, t6, t7, h3_x, t8, t9, t10, m4_4, t11, t12, t13, t14, t15, t16, t17, t18, t19
    real(rk) :: t20, t21, m1_1, m3_4, h3_y, t22, t23, m1_3, t24, t25, m1_2, t26, m1_4, t27, t28
    real(rk) :: nu2_y, t29, m1_5, neg_nu3_y, t30, t31, m2_3, m2_2, t32, m2_4, m2_5, nu4_y, m3_3

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
    t1 = 0.001247328_rk*c5
    t2 = t1 + 0.00064216_rk
    t3 = 5.8464e-05_rk*s5
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t2 - t3
    t4 = c4*t3
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 49.26108374384236_rk*t4
    t5 = h4_x - 0.025375_rk
    t6 = 3.4578544061302683_rk*c5 + 21.334975369458128_rk
    t7 = 0.0008328864265927978_rk*t6 + 0.8440253886030866_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t5 + s23*t7
    t8 = 5.8464e-05_rk*c5
    t9 = t8*t6
    t10 = t1 - t9
    ! link 4: mass matrix, its row of this joint
    m4_4 = t10 + 0.20184216_rk
    t11 = t1 + t9
    t12 = c4*(t9 + 0.00034_rk) - m3_5
    t13 = c4*t12 + t4
    t14 = 0.4318_rk*c2*h3_x
    t15 = s4*t3
    t16 = 7.394088669950739_rk*t15
    t17 = t16 - (t4 - (t10 + 0.00184216_rk))
    t18 = s23*t4
    t19 = t6*t18
    t20 = t14 + 4.45115636_rk + (t17 + c23*(t19 - s23*(t8 + 0.0106736385_rk)))
    t21 = s23*(s23*(t11 + 0.298375024_rk + t13)) + t20 + (t20 + (c2*(1.601861202_rk*c2 - &
        0.0141984_rk*s2) - 6.010691657_rk))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t21 - m4_4
    ! link 3: mass matrix, its row of this joint
    m3_4 = -t6*t15
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t5 - c23*t7
    t22 = 0.1501_rk*h3_y
    t23 = s4*s23
    ! link 1: mass matrix, its row of this joint
    m1_3 = t22 - t12*t23 - c23*(0.004704_rk - m3_4)
    t24 = 2.876748834110593_rk*s2
    t25 = t16*t24
    m1_2 = 0.690314699_rk*s2 + (0.023751_rk*c2 + m1_3 + t25)
    t26 = 21.27093596059113_rk*c2
    m1_4 = t19 + (t4*t26 + c23*t17)
    t27 = c23*t8
    t28 = t8*t26
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s4*(t27 - t28) - t2*t23
    t29 = 7.394088669950739_rk*(s23*t3 - c4*t27)
    ! link 1: mass matrix, its row of this joint
    m1_5 = t29 - nu2_y
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = 0.6841817186644773_rk*(t27 - t18)
    t30 = t14 + 6.458114002_rk + t22*t24
    t31 = t13 - (t11 - 6.124668753_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = t30 - t31
    m2_2 = t30 + m2_3
    t32 = t3*t26
    m2_4 = m3_4 + (c23*t25 - t23*t32)
    m2_5 = t24*t29 + (m3_5 + (c4*(s23*t28) + c23*t32))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.6841817186644773_rk*t15
    ! link 3: mass matrix, its row of this joint
    m3_3 = 7.288114002_rk - t31
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
  ! 249 multiplications, 204 additions, 4 divisions = 457; 2 unary minus; 8 sine/cosine
  pure subroutine puma560_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_zx, ww3_xy, ww3_yy, ww3_zz
    real(rk) :: neg_lam2_33, neg_lam3_11, s4, c4, w4_y, w4_z, neg_w4_x, ww4_yz, neg_ww4_zx, c5, s5
    real(rk) :: neg_w5_x, w5_y, w5_z, neg_ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, c2, s2, ww2_zz
    real(rk) :: neg_lam3_32, t1, neg_lam5_12, t2, alpha4_x, neg_ww5_zx, alpha5_y, n06_z, t3, t4, t5
    real(rk) :: t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, n4_z, t21
    real(rk) :: t22, t23, t24, t25, t26, t27, neg_n3_y, n4_x, t28, lam3_22, t29, t30, n5_z, nc4_y
    real(rk) :: t31, t32, n3_x, t33, t34, t35, t36, t37, t38, t39, tau1, n3_z, tau2, neg_nu5_y, t40
    real(rk) :: t41, t42, m3_5, t43, h4_x, t44, t45, t46, h3_x, t47, t48, t49, m4_4, t50, t51, t52
    real(rk) :: t53, t54, t55, t56, t57, t58, t59, t60, m1_1, neg_m3_4, h3_y, t61, t62, m1_3, t63
    real(rk) :: m1_2, t64, m1_4, t65, t66, nu2_y, t67, neg_m1_5, t68, nu3_y, t69, t70, m2_3, m2_2
    real(rk) :: t71, m2_4, m2_5, nu4_y, m3_3, neg_y5, y6, u4_6, u3_6, neg_u1_6, u3_5, u2_5
    real(rk) :: neg_u1_5, pivot4, ipivot4, t72, neg_ud3_4, neg_u3_4, neg_ud2_4, neg_u2_4, ud1_4
    real(rk) :: u1_4, t73, neg_pivot3, neg_ipivot3, ud2_3, neg_u2_3, t74, ud1_3, neg_u1_3, pivot2
    real(rk) :: ipivot2, ud1_2, u1_2, neg_pivot1, neg_ipivot1, neg_y4, t75, neg_y3, neg_y2, neg_y1
    real(rk) :: qdd1, neg_qdd2, qdd3, neg_qdd4, qdd5, qdd6, t76, t77

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
    t7 = 0.000432288_rk*(w5_y*(qd(5) + w5_z)) + (neg_ww3_zx*t5 + alpha4_x*t6)
    t8 = 2.876748834110593_rk*c2
    t9 = t8*(neg_lam2_33 + ww2_zz)
    t10 = 2.876748834110593_rk*s2
    t11 = ww2_zz*t10
    t12 = t11 + 65.28980679546969_rk
    t13 = 0.13524317121918722_rk*neg_lam3_11 - (c23*t9 + s23*t12)
    t14 = 2.0_rk*(qd(2)*qd(1))
    t15 = neg_lam2_33 - 0.27048634243837444_rk*neg_ww3_zx + t10*t14
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
    t24 = neg_lam5_22*t5 - neg_lam5_12*t6
    t25 = 0.0281625125_rk*t23 - (t24 + 0.1293554295_rk*t1)
    t26 = t18 + 0.01666835789471254_rk*t16
    t27 = s4*t25 + c4*t26
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = 0.13524317121918722_rk*(0.0007499511665665606_rk*(t21 + t22) - t27) + (n4_z - &
        0.0325_rk*neg_ww3_zx)
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
    t31 = n4_x + 2.8854097268487675_rk*t17
    t32 = n5_z - 2.8854097268487675_rk*t24 + (nc4_y + 0.1293554295_rk*t23)
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_x = c4*t31 - 0.004704_rk*(t22 - t28) + (0.0136416_rk*neg_ww3_zx - s4*t32)
    t33 = 0.0141984_rk*c2
    t34 = t33 - 0.0004552781954887218_rk*s2
    t35 = 96.40502817218841_rk*(s2*t33 - 7.363931254000739e-05_rk) + c2*t33
    t36 = ww2_zz*(42.91316091954023_rk*t34) - t14*t35 + (c23*neg_n3_y + t8*t27) - s23*n3_x
    t37 = c4*t25 - s4*t26
    t38 = 0.01666835789471254_rk*(t29 + 2.689579302165907_rk*t30) + (neg_lam5_22*t6 + &
        neg_lam5_12*t5)
    t39 = c23*t37 - s23*t38
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t36 - t39 - 0.0014646998319327732_rk*t11
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = s4*t31 + c4*t32 - 0.0068208_rk*(t21 + (neg_lam3_11 + lam3_22 - &
        (2.382418484635233_rk*ww3_xy - 19.8280511405095_rk*t38)))
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = neg_lam2_33*t35 + (n3_z - (2247.2413793103447_rk*t34 - t8*(s23*t37 + c23*t38))) - &
        t10*t39
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 4e-05_rk*c5
    t40 = 0.001247328_rk*c5
    t41 = t40 + 0.00064216_rk
    t42 = 5.8464e-05_rk*s5
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t41 - t42
    t43 = c4*t42
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = 49.26108374384236_rk*t43
    t44 = h4_x - 0.025375_rk
    t45 = 3.4578544061302683_rk*c5 + 21.334975369458128_rk
    t46 = 0.0008328864265927978_rk*t45 + 0.8440253886030866_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t44 + s23*t46
    t47 = 5.8464e-05_rk*c5
    t48 = t45*t47
    t49 = t40 - t48
    ! link 4: mass matrix, its row of this joint
    m4_4 = t49 + 0.20184216_rk
    t50 = t40 + t48
    t51 = m3_5 - c4*(t48 + 0.00034_rk)
    t52 = t43 - c4*t51
    t53 = h3_x*(0.4318_rk*c2)
    t54 = s4*t42
    t55 = 7.394088669950739_rk*t54
    t56 = t55 - (t43 - (t49 + 0.00184216_rk))
    t57 = s23*t43
    t58 = t45*t57
    t59 = t53 + 4.45115636_rk + (t56 + c23*(t58 - s23*(t47 + 0.0106736385_rk)))
    t60 = s23*(s23*(t50 + 0.298375024_rk + t52)) + t59 + (t59 + (c2*(1.601861202_rk*c2 - &
        0.0141984_rk*s2) - 6.010691657_rk))
    ! link 1: mass matrix, its row of this joint
    m1_1 = t60 - m4_4
    ! link 3: mass matrix, its row of this joint
    neg_m3_4 = t45*t54
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t44 - c23*t46
    t61 = 0.1501_rk*h3_y
    t62 = s23*s4
    ! link 1: mass matrix, its row of this joint
    m1_3 = t61 + t51*t62 - c23*(neg_m3_4 + 0.004704_rk)
    t63 = t10*t55
    m1_2 = 0.690314699_rk*s2 + (m1_3 + 0.023751_rk*c2 + t63)
    t64 = 21.27093596059113_rk*c2
    m1_4 = t58 + (t43*t64 + c23*t56)
    t65 = c23*t47
    t66 = t47*t64
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = s4*(t65 - t66) - t41*t62
    t67 = 7.394088669950739_rk*(s23*t42 - c4*t65)
    ! link 1: mass matrix, its row of this joint
    neg_m1_5 = nu2_y - t67
    t68 = t57 - t65
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = 0.6841817186644773_rk*t68
    t69 = t53 + 6.458114002_rk + t10*t61
    t70 = t52 - (t50 - 6.124668753_rk)
    ! link 2: mass matrix, its row of this joint
    m2_3 = t69 - t70
    m2_2 = t69 + m2_3
    t71 = t42*t64
    m2_4 = c23*t63 - t62*t71 - neg_m3_4
    m2_5 = t10*t67 + (m3_5 + (c4*(s23*t66) + c23*t71))
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.6841817186644773_rk*t54
    ! link 3: mass matrix, its row of this joint
    m3_3 = 7.288114002_rk - t70
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    y6 = tau(6) - n06_z
    ! factorisation M = U D U^T
    u4_6 = 0.00020721094073767094_rk*c5
    u3_6 = 3.5442484389995714_rk*t54
    neg_u1_6 = 3.5442484389995714_rk*t68
    u3_5 = 5.566622000091738_rk*m3_5
    u2_5 = 5.566622000091738_rk*m2_5
    neg_u1_5 = 5.566622000091738_rk*neg_m1_5
    pivot4 = m4_4 - neg_nu5_y*u4_6
    ipivot4 = 1.0_rk / pivot4
    t72 = neg_nu5_y*u3_6
    neg_ud3_4 = neg_m3_4 + t72
    neg_u3_4 = ipivot4*neg_ud3_4
    neg_ud2_4 = t72 - m2_4
    neg_u2_4 = ipivot4*neg_ud2_4
    ud1_4 = m1_4 + neg_nu5_y*neg_u1_6
    u1_4 = ipivot4*ud1_4
    t73 = nu4_y*u3_6
    neg_pivot3 = t73 - m3_3 + m3_5*u3_5 + neg_ud3_4*neg_u3_4
    neg_ipivot3 = 1.0_rk / neg_pivot3
    ud2_3 = m2_3 - t73 - m3_5*u2_5 - neg_ud3_4*neg_u2_4
    neg_u2_3 = neg_ipivot3*ud2_3
    t74 = nu4_y*neg_u1_6
    ud1_3 = m1_3 + t74 + m3_5*neg_u1_5 + neg_ud3_4*u1_4
    neg_u1_3 = neg_ipivot3*ud1_3
    pivot2 = m2_2 - t73 - m2_5*u2_5 - neg_ud2_4*neg_u2_4 + ud2_3*neg_u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 + t74 + m2_5*neg_u1_5 + neg_ud2_4*u1_4 + ud2_3*neg_u1_3
    u1_2 = ipivot2*ud1_2
    neg_pivot1 = nu3_y*neg_u1_6 - m1_1 + neg_m1_5*neg_u1_5 + ud1_4*u1_4 - ud1_3*neg_u1_3 + &
        ud1_2*u1_2
    neg_ipivot1 = 1.0_rk / neg_pivot1
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) + y6*u4_6
    t75 = y6*u3_6
    ! link 3: forward substitution
    neg_y3 = n3_z - tau(3) + t75 - neg_y5*u3_5 + neg_u3_4*neg_y4
    ! link 2: forward substitution
    neg_y2 = tau2 - tau(2) + t75 - neg_y5*u2_5 + neg_u2_4*neg_y4 + neg_u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = tau1 - tau(1) - y6*neg_u1_6 + neg_y5*neg_u1_5 - u1_4*neg_y4 + neg_u1_3*neg_y3 - &
        u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = neg_ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd2 = ipivot2*neg_y2 + u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 - neg_u2_3*neg_qdd2 + neg_u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd4 = ipivot4*neg_y4 - neg_u3_4*qdd3 + neg_u2_4*neg_qdd2 + u1_4*qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = neg_u1_5*qdd1 - (5.566622000091738_rk*neg_y5 + u3_5*qdd3 - u2_5*neg_qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = neg_u1_6*qdd1 + (5.180273518441774_rk*y6 + u4_6*neg_qdd4) + u3_6*(neg_qdd2 - qdd3)
    t76 = -neg_qdd2
    t77 = -neg_qdd4
    qdd(1) = qdd1
    qdd(2) = t76
    qdd(3) = qdd3
    qdd(4) = t77
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
