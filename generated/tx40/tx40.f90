! tx40: Staubli TX40 (CAD parameters; friction, rotor inertia and the wrist coupling are not in
!   it)
! Numbers: figaroh-plus examples/staubli_TX40, Apache-2.0
! Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: ca869e1c35fe24e800334b2c139779ed (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0      d 0.32   theta q
!   2  revolute  alpha -pi/2  a 0      d 0      theta q
!   3  revolute  alpha 0      a 0.225  d 0.035  theta q
!   4  revolute  alpha pi/2   a 0      d 0.225  theta q
!   5  revolute  alpha -pi/2  a 0      d 0      theta q
!   6  revolute  alpha pi/2   a 0      d 0      theta q + pi
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
! Of inverse_dynamics, bias the best program known for these parameters, equal to the recursion
!   without being written like it: robodyn --optimize full, seed 3.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 161 multiplications, 152 additions = 313; 0 unary minus; 8 sine/cosine
!   gravity: 16 multiplications, 12 additions = 28; 0 unary minus; 8 sine/cosine
!   bias: 145 multiplications, 129 additions = 274; 0 unary minus; 8 sine/cosine
!   mass_matrix: 72 multiplications, 67 additions = 139; 0 unary minus; 8 sine/cosine
module tx40_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: tx40_inverse_dynamics
  public :: tx40_gravity
  public :: tx40_bias
  public :: tx40_mass_matrix

contains

  ! torques that give the accelerations qdd
  ! 161 multiplications, 152 additions = 313; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="tx40_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, alpha3_z, lam3_23, neg_lam3_13
    real(rk) :: neg_ww3_zx, alpha3_y, ww3_xy, ww3_zz, ww3_yy, neg_lam3_12, neg_lam2_33, lam3_21
    real(rk) :: neg_lam3_11, neg_lam3_31, c4, s4, neg_w4_x, w4_z, w4_y, alpha4_z, ww4_xx, ww4_zz
    real(rk) :: neg_ww4_xy, neg_lam4_12, lam4_21, w5_z, c5, s5, c2, s2, neg_ww3_yz, neg_alpha3_x
    real(rk) :: neg_lam3_32, neg_lam4_23, neg_lam4_22, ww5_zz, lam4_13, t1, t2, neg_lam4_31, t3
    real(rk) :: neg_lam3_22, t4, lam4_11, lam4_32, ww2_zz, neg_lam2_13, t5, t6, t7, t8, t9, t10
    real(rk) :: t11, t12, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, t24, t25, t26, t27
    real(rk) :: t28, t29, t30, n4_z, t31, neg_n3_y, t32, t33, t34, nc5_z, t35, t36, t37, t38, t39
    real(rk) :: t40, t41, t42, t43, neg_n3_x, t44, t45, t46, t47, t48, t49, t50, t51, t52, n1_z
    real(rk) :: t53, n3_z, t54, n02_z

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
    lam3_23 = s23*qdd(1)
    neg_lam3_13 = c23*qdd(1)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_y = neg_ww3_zx - neg_lam3_13
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_zz = w3_z*w3_z
    ww3_yy = neg_w3_y*neg_w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_12 = alpha3_z - ww3_xy
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_11 = ww3_zz + ww3_yy
    neg_lam3_31 = neg_ww3_zx + alpha3_y
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    w4_y = w3_z*c4 + neg_w3_x*s4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_z = qdd(4) - alpha3_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_zz = w4_z*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_12 = alpha4_z + neg_ww4_xy
    lam4_21 = alpha4_z - neg_ww4_xy
    ! link 5: angular velocity [rad/s]
    w5_z = w4_y + qd(5)
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = lam3_23 + neg_ww3_yz
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_23 = neg_lam3_12*s4 - c4*neg_lam3_32
    neg_lam4_22 = ww4_xx + ww4_zz
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zz = w5_z*w5_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = neg_lam3_12*c4 + s4*neg_lam3_32
    t1 = 2.0_rk*w4_z
    t2 = neg_w4_x*t1
    neg_lam4_31 = lam4_13 + t2
    t3 = ww3_zz - ww3_yy
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam2_33 + t3
    t4 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t4 - neg_lam3_22
    lam4_32 = neg_lam4_23 + w4_y*t1
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = qdd(1)*c2
    t5 = s2*ww2_zz - (qdd(2)*c2 - 43.6_rk)
    t6 = qdd(2)*s2 + (c2*(neg_lam2_33 + ww2_zz) + 0.15555555555555556_rk*qdd(1))
    t7 = neg_lam3_12 - s23*t5 - c23*t6
    t8 = 2.0_rk*(qd(2)*qd(1))
    t9 = s2*t8 - (neg_lam2_13 - 0.15555555555555556_rk*neg_lam2_33)
    t10 = neg_lam3_32 - t9
    t11 = c4*t7 + s4*t10
    t12 = neg_lam4_12 - 2.0_rk*(neg_w4_x*w5_z)
    t13 = 0.0025785_rk*s5
    t14 = 0.00949389179755672_rk*c5
    t15 = t13*t14
    t16 = 0.0025785_rk*c5
    t17 = t16*t14
    t18 = t15 + (14.120098039215685_rk*t17 + 0.00051632_rk)
    t19 = t18 - 0.0013783_rk
    t20 = neg_lam4_23 - qd(5)*t1
    t21 = t17 - (14.120098039215685_rk*t15 + 1.224e-05_rk)
    t22 = neg_lam4_22 + lam4_11
    t23 = 0.000918_rk*c5 - t13
    t24 = s4*t7 - c4*t10
    t25 = ww4_xx - ww5_zz
    t26 = 4.08e-06_rk*c5 - 3.06e-06_rk*s5
    t27 = neg_lam4_31 + qdd(5)
    t28 = t2 - t27
    t29 = 3.06e-06_rk*c5 + 4.08e-06_rk*s5
    t30 = 0.00155792_rk*lam4_21 + t20*t21 + 0.00077468_rk*lam4_13 + (2.896e-05_rk*t22 + (t23 + &
        0.003258_rk)*t24 - (t25*t26 + t28*t29))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.0030155_rk*neg_lam4_12 - 0.00254936_rk*neg_lam4_23 - (0.0013995_rk*t11 + (t12*t19 - &
        t30))
    t31 = neg_lam3_11 - neg_lam3_22
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_y = 0.00200122_rk*(neg_lam3_12 - 1.1295509739059173_rk*neg_lam3_31) - &
        0.00019536_rk*neg_lam3_32 - (0.007326_rk*t9 - n4_z - 0.00233496_rk*(t3 + t31))
    t32 = 0.000918_rk*s5 + t16
    t33 = neg_lam3_22 - c23*t5 + s23*t6
    t34 = t28*t18 + t23*t33 + (lam4_32*t26 - neg_lam4_12*t29) + (t4*t21 + t27*t19)
    ! link 5: moment that turns the link [N m]
    nc5_z = t32*t11 - t34
    t35 = 0.011359713810524995_rk*lam4_32
    t36 = t4 + t35
    t37 = 0.0013995_rk*t33 - t20*t18 + (t29*(ww4_zz - ww5_zz) - t24*(t32 + 0.152379_rk) - t12*t21)
    t38 = 0.00254936_rk*lam4_21 + t27*t26 - (2.896e-05_rk*neg_lam4_31 - 0.00077468_rk*(t22 - &
        (3.8812152848986194_rk*lam4_32 + t36)) - t37)
    t39 = 0.152379_rk*neg_lam4_23 + (t23*t12 + (0.003258_rk*lam4_21 + 0.0013995_rk*neg_lam4_22) + &
        t32*t20)
    t40 = 0.0013995_rk*neg_lam4_12 - (t23*(neg_lam4_22 - t25) + (0.152379_rk*lam4_13 - t32*t28) - &
        0.003258_rk*lam4_11)
    t41 = c4*t39 + (0.007326_rk*neg_lam3_31 + s4*t40)
    t42 = 0.00155792_rk*neg_lam4_31 + (0.00077468_rk*neg_lam4_12 + (0.00254936_rk*t36 + nc5_z) + &
        0.152379_rk*t11) - 0.003258_rk*t33
    t43 = c4*t38 - (t41 + 0.00200122_rk*t3 - (s4*t42 + 0.00752136_rk*neg_lam3_31 - &
        0.1789441_rk*neg_lam3_32))
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.00233496_rk*lam3_21 + t43
    t44 = 0.46482595_rk*c2
    t45 = c2*t44
    t46 = s2*t44
    t47 = 0.003376747791296936_rk*t45 - 0.0007848_rk - t46
    t48 = 0.1602936_rk*s2 + 0.0010352_rk*c2
    t49 = 0.007326_rk*neg_lam3_11 - s4*t39 + c4*t40
    t50 = 0.12319852624309392_rk*(0.026445121539614456_rk*neg_lam4_31 + t35) - (t32*(ww4_xx + &
        ww5_zz) + (0.007326_rk*lam3_21 + 0.152379_rk*neg_lam3_22) - t23*t27)
    t51 = c23*t49 - s23*t50
    t52 = qdd(1)*(t45 + (0.003376747791296936_rk*t46 + 0.18129332_rk)) + &
        0.15555555555555556_rk*t51 + (ww2_zz*(0.1602936_rk*c2 - 0.0010352_rk*s2) - c2*t41)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t47*t8 + (qdd(2)*t48 + t52 + c23*neg_n3_y + s23*neg_n3_x)
    t53 = t49 - (0.00226048_rk*lam3_21 + c4*t42) + (s4*t38 - 0.00752136_rk*(t31 + &
        0.974025974025974_rk*t33))
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.00233496_rk*lam3_23 + (0.00200122_rk*(neg_lam3_13 - 89.41750532175374_rk*neg_lam3_12) &
        - t53)
    t54 = qdd(1)*t48 - c2*(s23*t49 + (c23*t50 + 23.5160415_rk)) + (s2*(t51 - 0.070632_rk) + &
        (0.53385475_rk*qdd(2) + n3_z))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t54 - neg_lam2_33*t47
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! torques that hold the arm at rest
  ! 16 multiplications, 12 additions = 28; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_gravity(q, tau) &
      bind(c, name="tx40_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s5, c5, hw5_y, c4, angle23, s23, c23, hw5_x, tau5, s4, t1, hw4_y, tau4, c2, s2
    real(rk) :: neg_hw4_x, neg_hw3_x, neg_hw2_x

    ! sines and cosines of the joint angles
    s5 = sin(q(5))
    c5 = cos(q(5))
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = -0.1124226_rk*c5 - 0.0400248_rk*s5
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    c23 = cos(angle23)
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_x = 0.1124226_rk*s5 - 0.0400248_rk*c5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = hw5_y*(c4*s23) - c23*hw5_x
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    t1 = 0.1420488_rk - hw5_x
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = 0.0610182_rk*c4 - s4*t1
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = s23*hw4_y
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw4_x = c4*t1 + 0.0610182_rk*s4
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw3_x = s23*(hw5_y - 6.6437244_rk) - c23*(0.3194136_rk - neg_hw4_x)
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw2_x = neg_hw3_x - (23.5160415_rk*c2 + 0.070632_rk*s2)
    tau(1) = 0.0_rk
    tau(2) = neg_hw2_x
    tau(3) = neg_hw3_x
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 145 multiplications, 129 additions = 274; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_bias(q, qd, tau) &
      bind(c, name="tx40_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: w3_z, angle23, s23, neg_w3_x, c23, neg_w3_y, neg_ww3_zx, ww3_xy, ww3_zz, ww3_yy
    real(rk) :: neg_lam2_33, neg_lam3_11, c4, s4, neg_w4_x, w4_z, w4_y, ww4_xx, ww4_zz, neg_ww4_xy
    real(rk) :: lam4_12, neg_lam4_21, w5_z, c5, s5, c2, s2, neg_ww3_yz, neg_lam3_32, lam4_23
    real(rk) :: neg_lam4_22, ww5_zz, neg_lam4_13, t1, t2, lam4_31, t3, neg_lam3_22, t4, lam4_11
    real(rk) :: neg_lam4_32, ww2_zz, t5, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17
    real(rk) :: t18, t19, t20, t21, t22, t23, t24, t25, t26, t27, t28, t29, n4_z, t30, n3_y, t31
    real(rk) :: t32, t33, nc5_z, t34, t35, t36, t37, t38, t39, t40, t41, t42, neg_n3_x, t43, t44
    real(rk) :: t45, t46, t47, t48, n1_z, n3_z, n02_z

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
    ww3_zz = w3_z*w3_z
    ww3_yy = neg_w3_y*neg_w3_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_11 = ww3_zz + ww3_yy
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w3_x*c4 - w3_z*s4
    w4_z = neg_w3_y + qd(4)
    w4_y = w3_z*c4 + neg_w3_x*s4
    ! link 4: products of the angular velocity [1/s^2]
    ww4_xx = neg_w4_x*neg_w4_x
    ww4_zz = w4_z*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = neg_ww3_zx - neg_ww4_xy
    neg_lam4_21 = neg_ww3_zx + neg_ww4_xy
    ! link 5: angular velocity [rad/s]
    w5_z = w4_y + qd(5)
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_32 = 2.0_rk*neg_ww3_yz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_23 = ww3_xy*s4 + c4*neg_lam3_32
    neg_lam4_22 = ww4_xx + ww4_zz
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zz = w5_z*w5_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_13 = ww3_xy*c4 - s4*neg_lam3_32
    t1 = 2.0_rk*w4_z
    t2 = neg_w4_x*t1
    lam4_31 = neg_lam4_13 - t2
    t3 = ww3_zz - ww3_yy
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = neg_lam2_33 + t3
    t4 = ww4_xx - ww4_zz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_11 = t4 - neg_lam3_22
    neg_lam4_32 = lam4_23 - w4_y*t1
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t5 = s2*ww2_zz + 43.6_rk
    t6 = c2*(neg_lam2_33 + ww2_zz)
    t7 = ww3_xy + s23*t5 + c23*t6
    t8 = 2.0_rk*(qd(2)*qd(1))
    t9 = s2*t8 + 0.15555555555555556_rk*neg_lam2_33
    t10 = neg_lam3_32 - t9
    t11 = c4*t7 - s4*t10
    t12 = lam4_12 + 2.0_rk*(neg_w4_x*w5_z)
    t13 = 0.0025785_rk*s5
    t14 = 0.00949389179755672_rk*c5
    t15 = t13*t14
    t16 = 0.0025785_rk*c5
    t17 = t16*t14
    t18 = t15 + (14.120098039215685_rk*t17 + 0.00051632_rk)
    t19 = t18 - 0.0013783_rk
    t20 = lam4_23 + qd(5)*t1
    t21 = t17 - (14.120098039215685_rk*t15 + 1.224e-05_rk)
    t22 = neg_lam4_22 + lam4_11
    t23 = 0.000918_rk*c5 - t13
    t24 = s4*t7 + c4*t10
    t25 = ww4_xx - ww5_zz
    t26 = 4.08e-06_rk*c5 - 3.06e-06_rk*s5
    t27 = t2 + lam4_31
    t28 = 3.06e-06_rk*c5 + 4.08e-06_rk*s5
    t29 = 0.00155792_rk*neg_lam4_21 + t20*t21 + 0.00077468_rk*neg_lam4_13 - (2.896e-05_rk*t22 - &
        (t23 + 0.003258_rk)*t24 - (t25*t26 + t27*t28))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 0.0013995_rk*t11 + (t12*t19 - t29) - (0.0030155_rk*lam4_12 - 0.00254936_rk*lam4_23)
    t30 = neg_lam3_11 - neg_lam3_22
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_y = 0.00200122_rk*(ww3_xy + 2.2591019478118346_rk*neg_ww3_zx) + 0.00039072_rk*neg_ww3_yz + &
        (0.007326_rk*t9 - n4_z - 0.00233496_rk*(t3 + t30))
    t31 = neg_lam3_22 - c23*t5 + s23*t6
    t32 = lam4_31*t19 - t4*t21 - (t27*t18 + t23*t31 - (neg_lam4_32*t26 - lam4_12*t28))
    t33 = 0.000918_rk*s5 + t16
    ! link 5: moment that turns the link [N m]
    nc5_z = t32 - t33*t11
    t34 = 0.011359713810524995_rk*neg_lam4_32
    t35 = t4 - t34
    t36 = t20*t18 + (0.0013995_rk*t31 - (0.00254936_rk*neg_lam4_21 - 0.00077468_rk*(t22 + &
        (3.8812152848986194_rk*neg_lam4_32 - t35))))
    t37 = t12*t21 + (t24*(t33 + 0.152379_rk) + (t28*(ww4_zz - ww5_zz) + t36)) - lam4_31*(t26 - &
        2.896e-05_rk)
    t38 = 0.152379_rk*lam4_23 + (t23*t12 + (0.003258_rk*neg_lam4_21 - 0.0013995_rk*neg_lam4_22) + &
        t33*t20)
    t39 = 0.0013995_rk*lam4_12 + (t23*(neg_lam4_22 - t25) - (0.152379_rk*neg_lam4_13 + t33*t27) - &
        0.003258_rk*lam4_11)
    t40 = c4*t38 - (0.014652_rk*neg_ww3_zx - s4*t39)
    t41 = 0.00155792_rk*lam4_31 + (0.00077468_rk*lam4_12 - (0.00254936_rk*t35 + nc5_z) + &
        0.152379_rk*t11) + 0.003258_rk*t31
    t42 = c4*t37 + (t40 - 0.00200122_rk*t3 - (s4*t41 - 0.01504272_rk*neg_ww3_zx + &
        0.3578882_rk*neg_ww3_yz))
    ! link 3: moment through the joint, about the frame's origin [N m]
    neg_n3_x = 0.00233496_rk*ww3_xy + t42
    t43 = 0.007326_rk*neg_lam3_11 + s4*t38 - c4*t39
    t44 = 0.12319852624309392_rk*(0.026445121539614456_rk*lam4_31 + t34) + (t33*(ww4_xx + ww5_zz) &
        + (0.007326_rk*ww3_xy + 0.152379_rk*neg_lam3_22) + t23*lam4_31)
    t45 = c23*t43 + s23*t44
    t46 = 0.15555555555555556_rk*t45 + (ww2_zz*(0.1602936_rk*c2 - 0.0010352_rk*s2) + c2*t40) - &
        c23*n3_y
    t47 = 0.46482595_rk*c2
    t48 = s2*t47 - (0.003376747791296936_rk*(c2*t47) - 0.0007848_rk)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = t46 + s23*neg_n3_x - t48*t8
    ! link 3: moment through the joint, about the frame's origin [N m]
    n3_z = 0.00752136_rk*(t30 + 0.974025974025974_rk*t31) - (s4*t37 + (t43 + c4*t41)) + &
        0.18120458_rk*ww3_xy
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = neg_lam2_33*t48 - (c2*(s23*t43 - (c23*t44 - 23.5160415_rk)) - (s2*(t45 - 0.070632_rk) &
        + n3_z))
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = n3_z
    tau(4) = n4_z
    tau(5) = nc5_z
    tau(6) = 0.0_rk
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 72 multiplications, 67 additions = 139; 0 unary minus; 8 sine/cosine
  pure subroutine tx40_mass_matrix(q, M) &
      bind(c, name="tx40_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, angle23, c23, s23, h5_x, t1, k5_xz, t2, h4_x, h4_y, k5_yz
    real(rk) :: t3, t4, t5, t6, m4_4, neg_h5_y, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, t17
    real(rk) :: t18, t19, t20, t21, t22, t23, m1_1, m3_4, h3_y, t24, neg_nu2_y, t25, t26, k2_yz
    real(rk) :: fu4_x, fu3_x, m3_3, t27, m2_3, m2_2, m2_4, t28, m3_5, t29, m2_5, t30, t31

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
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.01146_rk*s5 - 0.00408_rk*c5
    t1 = 3.06e-06_rk*s5
    ! link 5: second moment of the composite body [kg m^2]
    k5_xz = 4.08e-06_rk*c5 - t1
    t2 = h5_x - 0.01448_rk
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*t2 - 0.00622_rk*s4
    h4_y = s4*t2 + 0.00622_rk*c4
    ! link 5: second moment of the composite body [kg m^2]
    k5_yz = 1.3333333333333333_rk*(t1 + 2.295e-06_rk*c5)
    t3 = 2.448e-05_rk*c5
    t4 = s5*t3
    t5 = c5*t3
    t6 = t4 + 0.1781184_rk + 14.120098039215685_rk*t5
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1835538_rk - t6
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_y = 1988.235294117647_rk*(k5_yz + 0.6627218934911243_rk*k5_xz)
    t7 = t5 - (14.120098039215685_rk*t4 + 0.0025616_rk)
    t8 = 0.225_rk*h4_x
    t9 = k5_yz + 0.00077468_rk
    t10 = c4*t7 - (t8 + s4*t9)
    t11 = 0.035_rk*h4_y
    t12 = t11 + m4_4
    t13 = 0.225_rk*c2
    t14 = s23*t13
    t15 = neg_h5_y + 0.67724_rk
    t16 = h4_x + 0.03256_rk
    t17 = c23*t13
    t18 = t14*t15 + t16*t17
    t19 = c23*s23*(t10 + 0.00019536_rk) - (0.0007848_rk*(c2*(s2 + 296.14293450560655_rk*c2)) + &
        (t12 + t18))
    t20 = c4*k5_xz
    t21 = s4*(t6 - 0.1775228_rk) - (t20 + (t20 - 5.792e-05_rk*c4))
    t22 = t6 - 0.18279878_rk - s4*t21
    t23 = 0.45_rk*t15 + (t6 - 0.35654618_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = t6 - t19 - (t19 - s23*(s23*(t22 + t23)))
    ! link 3: mass matrix, its row of this joint
    m3_4 = c4*t9 - (0.225_rk*h4_y - s4*t7)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_y = s23*t16 - c23*t15
    t24 = 0.035_rk*h3_y
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = c23*(m3_4 + 0.00200122_rk) + (t24 - s23*(k5_xz + (c4*t21 - 0.00236392_rk)))
    t25 = 6.428571428571429_rk*s2
    t26 = t11*t25
    ! link 2: second moment of the composite body [kg m^2]
    k2_yz = 0.1602936_rk*s2 + t26 + (0.0010352_rk*c2 + neg_nu2_y)
    ! link 4: force for a unit acceleration of a joint further out
    fu4_x = c4*neg_h5_y
    ! link 3: force for a unit acceleration of a joint further out
    fu3_x = c23*fu4_x - s23*h5_x
    ! link 3: mass matrix, its row of this joint
    m3_3 = t23 - t22
    t27 = t18 + t25*t24
    ! link 2: mass matrix, its row of this joint
    m2_3 = m3_3 + t27
    m2_2 = m2_3 + (t27 + 0.53385475_rk)
    m2_4 = m3_4 + c23*t26 - h4_y*t14
    t28 = 0.225_rk*t15 - 0.1510007_rk
    ! link 3: mass matrix, its row of this joint
    m3_5 = c4*t28 - s4*k5_xz
    t29 = -0.035_rk*fu3_x
    ! link 2: mass matrix, its row of this joint
    m2_5 = t14*fu4_x + m3_5 + h5_x*t17 + t25*t29
    t30 = c23*t12 - s23*t10 + c2*t8
    t31 = c23*k5_yz + (neg_h5_y*(s4*t13) + (t29 + s23*(t20 + s4*t28)))
    M(1) = m1_1
    M(2) = k2_yz
    M(3) = neg_nu2_y
    M(4) = t30
    M(5) = t31
    M(6) = 0.0_rk
    M(7) = k2_yz
    M(8) = m2_2
    M(9) = m2_3
    M(10) = m2_4
    M(11) = m2_5
    M(12) = 0.0_rk
    M(13) = neg_nu2_y
    M(14) = m2_3
    M(15) = m3_3
    M(16) = m3_4
    M(17) = m3_5
    M(18) = 0.0_rk
    M(19) = t30
    M(20) = m2_4
    M(21) = m3_4
    M(22) = m4_4
    M(23) = k5_yz
    M(24) = 0.0_rk
    M(25) = t31
    M(26) = m2_5
    M(27) = m3_5
    M(28) = k5_yz
    M(29) = 0.0013783_rk
    M(30) = 0.0_rk
    M(31) = 0.0_rk
    M(32) = 0.0_rk
    M(33) = 0.0_rk
    M(34) = 0.0_rk
    M(35) = 0.0_rk
    M(36) = 0.0_rk
  end subroutine
end module
