! puma560: PUMA 560, six joints
! Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute, 4 revolute, 5 revolute, 6 revolute
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
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
!   gravity: 16 multiplications, 7 additions = 23; 1 unary minus; 8 sine/cosine
!   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
!   mass_matrix: 84 multiplications, 68 additions = 152; 0 unary minus; 8 sine/cosine
!   forward_dynamics: 298 multiplications, 228 additions, 6 divisions = 532; 2 unary minus; 8
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
  ! 16 multiplications, 7 additions = 23; 1 unary minus; 8 sine/cosine
  pure subroutine puma560_gravity(q, tau) &
      bind(c, name="puma560_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: angle23, s23, a3_x, c23, a3_y, c4, a4_x, s4, neg_a4_y, c5, s5, a5_x, nc5_z, nc5_x
    real(rk) :: n05_y, n05_x, n04_y, nc3_z, n3_z, c2, s2, nc2_z, n02_z, t1

    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = -9.8_rk*s23
    ! sines and cosines of the joint angles
    c23 = cos(angle23)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = -9.8_rk*c23
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = a3_x*c4
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_y = a3_x*s4
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = a4_x*c5 + a3_y*s5
    ! link 5: moment that turns the link [N m]
    nc5_z = 0.00288_rk*a5_x
    nc5_x = 0.00288_rk*neg_a4_y
    ! link 5: moment through the joint, along the axes that its turn starts from [N m]
    n05_y = s5*nc5_x
    n05_x = c5*nc5_x
    ! link 4: moment through the joint, along the axes that its turn starts from [N m]
    n04_y = s4*n05_x + c4*nc5_z
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.248675_rk*c23 - 8.445591_rk*s23
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = n04_y + nc3_z
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: moment that turns the link [N m]
    nc2_z = 1.02312_rk*s2 - 37.196782_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = n3_z + nc2_z
    t1 = -n05_y
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = t1
    tau(5) = nc5_z
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
  ! 84 multiplications, 68 additions = 152; 0 unary minus; 8 sine/cosine
  pure subroutine puma560_mass_matrix(q, M) &
      bind(c, name="puma560_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, nu5_x, neg_nu5_y, nu4_x, nu4_y
    real(rk) :: neg_nu3_y, h5_x, neg_h5_y, t1, k5_yy, neg_k5_xy, fu4_x, fu4_y, neg_nu4_x, nu4_y_2
    real(rk) :: m3_5, fu3_x, fu3_y, nu3_y, t2, nu2_y, t3, m2_5, m1_5, h4_x, h4_y, t4, t5, k4_xx
    real(rk) :: k4_yy, neg_k4_xy, k4_xz, k4_yz, m4_4, m3_4, neg_fu3_x, neg_fu3_y, t6, nu3_y_2
    real(rk) :: nu2_y_2, m2_4, m1_4, t7, t8, h3_x, h3_y, t9, t10, t11, k3_xx, k3_yy, neg_k3_yz, t12
    real(rk) :: m3_3, m2_3, m1_3, h2_y, t13, k2_xx, k2_yz, m2_2, m1_2, m1_1

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
    nu5_x = 4e-05_rk*s5
    neg_nu5_y = 4e-05_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = c23*neg_nu5_y - s23*nu4_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    t1 = 0.00020216_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t1 + 0.00022_rk
    neg_k5_xy = 0.00020216_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    neg_nu4_x = 0.00064216_rk*s4
    nu4_y_2 = 0.00064216_rk*c4
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 - (5.8464e-05_rk*s5 - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    fu3_y = s23*fu4_x + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*(0.0203_rk*fu4_y) - s23*(neg_nu4_x + 0.4331_rk*fu4_y)
    t2 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - t2*fu4_y
    t3 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (t2*fu3_y - t3*fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_5 = -0.1501_rk*fu3_x - nu2_y
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t4 = t1 - 0.00030216_rk
    t5 = c4*c4*t4
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = 0.00077_rk - t5
    k4_yy = t5 - (t1 - 0.00107216_rk)
    neg_k4_xy = t4*(c4*s4)
    k4_xz = c4*neg_k5_xy
    k4_yz = s4*neg_k5_xy
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.20184216_rk - t1
    ! link 3: mass matrix, its row of this joint
    m3_4 = -0.4331_rk*h4_y - k4_yz
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    neg_fu3_y = s23*h4_y
    t6 = 0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(t1 - 0.00184216_rk + 0.0203_rk*h4_x) - s23*(k4_xz + t6)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 - t2*h4_x
    ! link 2: mass matrix, its row of this joint
    m2_4 = m3_4 - (t2*neg_fu3_y - t3*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    m1_4 = 0.1501_rk*neg_fu3_x - nu2_y_2
    t7 = h4_x - 0.025375_rk
    t8 = neg_h5_y + 0.861795_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t7 + s23*t8
    h3_y = s23*t7 - c23*t8
    t9 = k5_yy + 0.002494656_rk*c5
    t10 = 0.0406_rk*h4_x - k4_xx
    t11 = c23*c23*(t10 + t9 + 0.298925024_rk) - (t6 + (k4_xz - 5.8464e-05_rk*c5) - &
        0.0106736385_rk)*(2.0_rk*(c23*s23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t9 + 0.3156901365_rk - t11
    k3_yy = t11 - (t10 - 0.0167651125_rk)
    neg_k3_yz = s23*(neg_k4_xy + 0.0203_rk*h4_y) + c23*(0.004704_rk - m3_4)
    t12 = t10 - t9
    ! link 3: mass matrix, its row of this joint
    m3_3 = 1.162455249_rk - t12
    ! link 2: mass matrix, its row of this joint
    m2_3 = t2*h3_x + t3*h3_y - (t12 - 0.332455249_rk)
    ! link 1: mass matrix, its row of this joint
    m1_3 = 0.1501_rk*h3_y - neg_k3_yz
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = h3_y + (3.79559_rk*s2 + 0.1044_rk*c2)
    t13 = k3_xx + t2*(2.0_rk*h3_x)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t13 + (1.601861202_rk*(c2*c2) - 0.0141984_rk*(c2*s2) + 0.0731264_rk)
    k2_yz = t3*h4_y - neg_k3_yz + (0.12059664_rk*s2 + 0.00808056_rk*c2)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t13 + (k3_yy + t3*(2.0_rk*h3_y)) + 6.458114002_rk
    ! link 1: mass matrix, its row of this joint
    m1_2 = k2_yz + 0.1501_rk*h2_y
    m1_1 = k2_xx + (k4_yy + 0.3002_rk*h4_y) + 2.6017295505_rk
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
  ! 298 multiplications, 228 additions, 6 divisions = 532; 2 unary minus; 8 sine/cosine
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
    real(rk) :: t31, t32, n3_x, t33, t34, t35, t36, t37, t38, t39, tau1, n3_z, tau2, nu5_x
    real(rk) :: neg_nu5_y, nu4_x, nu4_y, neg_nu3_y, h5_x, neg_h5_y, t40, k5_yy, neg_k5_xy, fu4_x
    real(rk) :: fu4_y, nu4_x_2, nu4_y_2, m3_5, fu3_x, fu3_y, nu3_y, t41, nu2_y, t42, m2_5, neg_m1_5
    real(rk) :: h4_x, h4_y, t43, t44, k4_xx, k4_yy, neg_k4_xy, k4_xz, k4_yz, m4_4, neg_m3_4
    real(rk) :: neg_fu3_x, neg_fu3_y, t45, nu3_y_2, nu2_y_2, neg_m2_4, neg_m1_4, t46, t47, h3_x
    real(rk) :: h3_y, t48, t49, t50, k3_xx, k3_yy, neg_k3_yz, t51, m3_3, m2_3, neg_m1_3, h2_y, t52
    real(rk) :: k2_xx, neg_k2_yz, m2_2, neg_m1_2, m1_1, neg_y1, ipivot1, neg_l2_1, neg_l3_1
    real(rk) :: neg_l4_1, neg_l5_1, l6_1, pivot2, ipivot2, ld3_2, l3_2, neg_ld4_2, neg_l4_2, ld5_2
    real(rk) :: l5_2, ld6_2, l6_2, pivot3, ipivot3, neg_ld4_3, neg_l4_3, ld5_3, l5_3, ld6_3, l6_3
    real(rk) :: neg_pivot4, neg_ipivot4, neg_ld5_4, l5_4, ld6_4, neg_l6_4, neg_pivot5, neg_ipivot5
    real(rk) :: ld6_5, neg_l6_5, neg_pivot6, neg_ipivot6, neg_y2, neg_y3, neg_y4, neg_y5, y6
    real(rk) :: neg_qdd6, qdd5, qdd4, neg_qdd3, qdd2, qdd1, t53, t54

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
    nu5_x = 4e-05_rk*s5
    neg_nu5_y = 4e-05_rk*c5
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x = c4*nu5_x
    nu4_y = s4*nu5_x
    ! link 3: moment for a unit acceleration of a joint further out
    neg_nu3_y = c23*neg_nu5_y - s23*nu4_x
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.00288_rk*s5
    neg_h5_y = 0.00288_rk*c5
    t40 = 0.00020216_rk*(c5*c5)
    ! link 5: second moment of the composite body [kg m^2]
    k5_yy = t40 + 0.00022_rk
    neg_k5_xy = 0.00020216_rk*(c5*s5)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    fu4_y = s4*neg_h5_y
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_x_2 = -0.00064216_rk*s4
    nu4_y_2 = 0.00064216_rk*c4
    ! link 3: mass matrix, its row of this joint
    m3_5 = nu4_y_2 - (5.8464e-05_rk*s5 - 0.4331_rk*fu4_x)
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    fu3_y = s23*fu4_x + c23*h5_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y = c23*(0.0203_rk*fu4_y) - s23*(0.4331_rk*fu4_y - nu4_x_2)
    t41 = 0.4318_rk*c2
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y = nu3_y - fu4_y*t41
    t42 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_5 = m3_5 + (fu3_y*t41 - fu3_x*t42)
    ! link 1: mass matrix, its row of this joint
    neg_m1_5 = nu2_y + 0.1501_rk*fu3_x
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x
    h4_y = s4*h5_x
    t43 = t40 - 0.00030216_rk
    t44 = c4*c4*t43
    ! link 4: second moment of the composite body [kg m^2]
    k4_xx = 0.00077_rk - t44
    k4_yy = t44 - (t40 - 0.00107216_rk)
    neg_k4_xy = t43*(s4*c4)
    k4_xz = c4*neg_k5_xy
    k4_yz = s4*neg_k5_xy
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.20184216_rk - t40
    ! link 3: mass matrix, its row of this joint
    neg_m3_4 = k4_yz + 0.4331_rk*h4_y
    ! link 3: force for a unit acceleration of a joint further out
    neg_fu3_x = c23*h4_y
    neg_fu3_y = s23*h4_y
    t45 = 0.4331_rk*h4_x
    ! link 3: moment for a unit acceleration of a joint further out
    nu3_y_2 = c23*(t40 - 0.00184216_rk + 0.0203_rk*h4_x) - s23*(k4_xz + t45)
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_y_2 = nu3_y_2 - t41*h4_x
    ! link 2: mass matrix, its row of this joint
    neg_m2_4 = neg_m3_4 + (t41*neg_fu3_y - t42*neg_fu3_x)
    ! link 1: mass matrix, its row of this joint
    neg_m1_4 = nu2_y_2 - 0.1501_rk*neg_fu3_x
    t46 = h4_x - 0.025375_rk
    t47 = neg_h5_y + 0.861795_rk
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = c23*t46 + s23*t47
    h3_y = s23*t46 - c23*t47
    t48 = k5_yy + 0.002494656_rk*c5
    t49 = 0.0406_rk*h4_x - k4_xx
    t50 = c23*c23*(t48 + t49 + 0.298925024_rk) - (t45 + (k4_xz - 5.8464e-05_rk*c5) - &
        0.0106736385_rk)*(2.0_rk*(s23*c23))
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = t48 + 0.3156901365_rk - t50
    k3_yy = t50 - (t49 - 0.0167651125_rk)
    neg_k3_yz = s23*(neg_k4_xy + 0.0203_rk*h4_y) + c23*(neg_m3_4 + 0.004704_rk)
    t51 = t48 - t49
    ! link 3: mass matrix, its row of this joint
    m3_3 = t51 + 1.162455249_rk
    ! link 2: mass matrix, its row of this joint
    m2_3 = t41*h3_x + t42*h3_y + (t51 + 0.332455249_rk)
    ! link 1: mass matrix, its row of this joint
    neg_m1_3 = neg_k3_yz - 0.1501_rk*h3_y
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = h3_y + (3.79559_rk*s2 + 0.1044_rk*c2)
    t52 = k3_xx + t41*(2.0_rk*h3_x)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t52 + (1.601861202_rk*(c2*c2) - 0.0141984_rk*(c2*s2) + 0.0731264_rk)
    neg_k2_yz = neg_k3_yz - t42*h4_y - (0.12059664_rk*s2 + 0.00808056_rk*c2)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t52 + (k3_yy + t42*(2.0_rk*h3_y)) + 6.458114002_rk
    ! link 1: mass matrix, its row of this joint
    neg_m1_2 = neg_k2_yz - 0.1501_rk*h2_y
    m1_1 = k2_xx + (k4_yy + 0.3002_rk*h4_y) + 2.6017295505_rk
    ! link 1: forward substitution
    neg_y1 = tau1 - tau(1)
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    neg_l2_1 = neg_m1_2*ipivot1
    neg_l3_1 = neg_m1_3*ipivot1
    neg_l4_1 = neg_m1_4*ipivot1
    neg_l5_1 = neg_m1_5*ipivot1
    l6_1 = neg_nu3_y*ipivot1
    pivot2 = m2_2 - neg_m1_2*neg_l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = m2_3 - neg_m1_2*neg_l3_1
    l3_2 = ipivot2*ld3_2
    neg_ld4_2 = neg_m2_4 + neg_m1_2*neg_l4_1
    neg_l4_2 = ipivot2*neg_ld4_2
    ld5_2 = m2_5 - neg_m1_2*neg_l5_1
    l5_2 = ipivot2*ld5_2
    ld6_2 = nu4_y + neg_m1_2*l6_1
    l6_2 = ipivot2*ld6_2
    pivot3 = m3_3 - neg_m1_3*neg_l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    neg_ld4_3 = neg_m3_4 + neg_m1_3*neg_l4_1 - ld3_2*neg_l4_2
    neg_l4_3 = ipivot3*neg_ld4_3
    ld5_3 = m3_5 - neg_m1_3*neg_l5_1 - ld3_2*l5_2
    l5_3 = ipivot3*ld5_3
    ld6_3 = nu4_y + neg_m1_3*l6_1 - ld3_2*l6_2
    l6_3 = ipivot3*ld6_3
    neg_pivot4 = neg_m1_4*neg_l4_1 - m4_4 + neg_ld4_2*neg_l4_2 + neg_ld4_3*neg_l4_3
    neg_ipivot4 = 1.0_rk / neg_pivot4
    neg_ld5_4 = neg_m1_4*neg_l5_1 - neg_ld4_2*l5_2 - neg_ld4_3*l5_3
    l5_4 = neg_ipivot4*neg_ld5_4
    ld6_4 = neg_nu5_y + neg_m1_4*l6_1 + neg_ld4_2*l6_2 + neg_ld4_3*l6_3
    neg_l6_4 = neg_ipivot4*ld6_4
    neg_pivot5 = neg_m1_5*neg_l5_1 - 0.17964216_rk + ld5_2*l5_2 + ld5_3*l5_3 - neg_ld5_4*l5_4
    neg_ipivot5 = 1.0_rk / neg_pivot5
    ld6_5 = neg_m1_5*l6_1 - ld5_2*l6_2 - ld5_3*l6_3 - neg_ld5_4*neg_l6_4
    neg_l6_5 = neg_ipivot5*ld6_5
    neg_pivot6 = neg_nu3_y*l6_1 - 0.19304_rk + ld6_2*l6_2 + ld6_3*l6_3 - ld6_4*neg_l6_4 - &
        ld6_5*neg_l6_5
    neg_ipivot6 = 1.0_rk / neg_pivot6
    ! link 2: forward substitution
    neg_y2 = tau2 - tau(2) + neg_y1*neg_l2_1
    ! link 3: forward substitution
    neg_y3 = n3_z - tau(3) + neg_y1*neg_l3_1 - l3_2*neg_y2
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) + neg_y1*neg_l4_1 + neg_l4_2*neg_y2 + neg_l4_3*neg_y3
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5) + neg_y1*neg_l5_1 - l5_2*neg_y2 - l5_3*neg_y3 - l5_4*neg_y4
    ! link 6: forward substitution
    y6 = tau(6) - n06_z + neg_y1*l6_1 + l6_2*neg_y2 + l6_3*neg_y3 - neg_l6_4*neg_y4 - &
        neg_l6_5*neg_y5
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd6 = neg_ipivot6*y6
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = neg_ipivot5*neg_y5 - neg_l6_5*neg_qdd6
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = neg_ipivot4*neg_y4 - l5_4*qdd5 - neg_l6_4*neg_qdd6
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd3 = ipivot3*neg_y3 - neg_l4_3*qdd4 + l5_3*qdd5 - l6_3*neg_qdd6
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = l6_2*neg_qdd6 - (ipivot2*neg_y2 - l3_2*neg_qdd3 - neg_l4_2*qdd4 + l5_2*qdd5)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = l6_1*neg_qdd6 - (neg_y1*ipivot1 - neg_l2_1*qdd2 + neg_l3_1*neg_qdd3 - neg_l4_1*qdd4 - &
        neg_l5_1*qdd5)
    t53 = -neg_qdd3
    t54 = -neg_qdd6
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = t53
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = t54
  end subroutine
end module
