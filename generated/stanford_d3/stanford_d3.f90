! stanford_d3: Stanford arm, the set of the thesis's listing D.3.2
! Numbers: the 1990 thesis, listing D.3.2 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
!   tables
! Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 0e9c705765a81730942efe1f695fcd86 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute   alpha 0      a 0  d 0       theta q
!   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
!   3  prismatic  alpha pi/2   a 0  d q       theta 0
!   4  revolute   alpha 0      a 0  d 0       theta q
!   5  revolute   alpha -pi/2  a 0  d 0       theta q
!   6  revolute   alpha pi/2   a 0  d 0       theta q
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
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 117 multiplications, 84 additions = 201; 0 unary minus; 6 sine/cosine
!   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
!   bias: 110 multiplications, 71 additions = 181; 0 unary minus; 6 sine/cosine
!   mass_matrix: 40 multiplications, 32 additions = 72; 2 unary minus; 6 sine/cosine
!   forward_dynamics: 207 multiplications, 150 additions, 4 divisions = 361; 1 unary minus; 6
!       sine/cosine
module stanford_d3_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_d3_inverse_dynamics
  public :: stanford_d3_gravity
  public :: stanford_d3_bias
  public :: stanford_d3_mass_matrix
  public :: stanford_d3_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 117 multiplications, 84 additions = 201; 0 unary minus; 6 sine/cosine
  pure subroutine stanford_d3_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_d3_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: neg_lam2_33, s2, neg_w2_x, c2, neg_w2_y, neg_ww2_zx, ww2_xy, ww2_xx, ww2_zz
    real(rk) :: neg_lam2_22, lam2_12, c4, s4, neg_w4_x, w4_y, w4_z, neg_ww4_zx, neg_ww4_xy, c5, s5
    real(rk) :: neg_w5_x, w5_z, neg_w5_y, neg_ww5_zx, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1
    real(rk) :: n06_y, n06_x, fc5_y, lam2_23, t2, neg_lam2_32, neg_a3_y, nc3_x, neg_lam4_22
    real(rk) :: neg_lam2_13, alpha2_y, lam4_12, ww4_yz, neg_lam4_32, t3, alpha5_y, n06_z, neg_a3_z
    real(rk) :: a2_x, neg_a3_x, a4_y, lam4_13, alpha4_y, alpha5_z, lam5_12, neg_a4_x, a5_x, n5_z
    real(rk) :: neg_fc5_x, fc3_z, fc4_z, f3_z, neg_fc3_y, fc4_x, neg_f05_x, neg_f4_x, fc4_y, t4, t5
    real(rk) :: fc5_z, f4_y, f04_y, neg_f3_y, fc3_x, f3_x, t6, t7, n4_z, t8, t9, t10, n1_z, nc3_y
    real(rk) :: n2_z

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_y = qd(2)*c4 + neg_w2_x*s4
    w4_z = neg_w2_y + qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_zx = neg_w4_x*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.0203_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    n06_x = w5_z*t1
    ! link 5: force that moves the link [N]
    fc5_y = 0.114912_rk*neg_lam5_22
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    t2 = 2.0_rk*qd(2)
    neg_lam2_32 = lam2_23 + neg_w2_y*t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = 0.1524_rk*neg_lam2_33 - (neg_lam2_32*q(3) + 2.0_rk*(neg_w2_x*qd(3)))
    ! link 3: moment that turns the link [N m]
    nc3_x = -2.749911_rk*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_y = neg_ww2_zx - neg_lam2_13
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha2_y - (neg_ww4_xy + qdd(4))
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_32 = c4*neg_lam2_32 + (lam2_12*s4 - 2.0_rk*ww4_yz)
    t3 = c5*lam4_12 + s5*neg_lam4_32
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww5_zx + t3
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = 0.0203_rk*(qdd(6) - alpha5_y)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_z = neg_lam2_22*q(3) - 9.8_rk*(c2 - 0.015551020408163266_rk*lam2_23) - qdd(3)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = lam2_12*q(3) - a2_x + (0.1524_rk*neg_lam2_13 - t2*qd(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = s4*neg_a3_x - c4*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = s4*neg_lam2_32 - lam2_12*c4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx + lam4_13
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = alpha4_y + qdd(5)
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = s4*neg_a3_y + c4*neg_a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*neg_a3_z - c5*neg_a4_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = n06_y - (0.0299343144_rk*lam5_12 - 0.0974_rk*alpha5_z) + 0.114912_rk*a5_x
    ! link 5: force that moves the link [N]
    neg_fc5_x = 0.114912_rk*lam5_12
    ! link 3: force that moves the link [N]
    fc3_z = 2.749911_rk*neg_lam2_22 - 6.47_rk*neg_a3_z
    ! link 4: force that moves the link [N]
    fc4_z = 0.005832_rk*neg_lam4_32
    ! link 3: force through the joint [N]
    f3_z = s5*neg_fc5_x + fc3_z + fc4_z - c5*fc5_y
    ! link 3: force that moves the link [N]
    neg_fc3_y = 6.47_rk*(neg_a3_y + 0.4250248840803709_rk*neg_lam2_32)
    ! link 4: force that moves the link [N]
    fc4_x = -0.005832_rk*lam4_12
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    neg_f05_x = s5*fc5_y + c5*neg_fc5_x
    ! link 4: force through the joint [N]
    neg_f4_x = neg_f05_x - fc4_x
    ! link 4: force that moves the link [N]
    fc4_y = 0.005832_rk*neg_lam4_22
    t4 = c5*neg_lam4_32 - s5*lam4_12
    t5 = 0.1572686288_rk*(w5_z*neg_w5_y) + 0.0786343144_rk*t4
    ! link 5: force that moves the link [N]
    fc5_z = 1.4613467527097814_rk*t5
    ! link 4: force through the joint [N]
    f4_y = fc4_y + fc5_z
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_y = c4*f4_y - s4*neg_f4_x
    ! link 3: force through the joint [N]
    neg_f3_y = neg_fc3_y - f04_y
    ! link 3: force that moves the link [N]
    fc3_x = 2.749911_rk*lam2_12 - 6.47_rk*neg_a3_x
    ! link 3: force through the joint [N]
    f3_x = fc3_x - c4*neg_f4_x - s4*f4_y
    t6 = 0.114912_rk*a4_y + (0.0587314928_rk*t4 - (n06_x - t5))
    t7 = 0.0100314928_rk*t3 + (0.0974_rk*alpha5_y - n06_z)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = s5*t6 - c5*t7 - (0.005832_rk*neg_a4_x + 5.36544e-05_rk*lam4_13) - 0.106_rk*neg_ww4_xy
    t8 = 5.36544e-05_rk*(neg_lam2_22 - neg_lam4_22) + (s5*t7 - 0.005832_rk*neg_a3_z) + (c5*t6 + &
        0.106_rk*ww4_yz)
    t9 = 0.106_rk*alpha4_y + (5.36544e-05_rk*lam4_12 + n5_z)
    t10 = 0.3436532925_rk*lam2_23 - nc3_x + c4*t8 + 5.2810532937_rk*neg_lam2_32 + (s4*t9 - &
        0.1524_rk*f3_z - q(3)*neg_f3_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*t10 - c2*(0.1524_rk*f3_x + (2.203_rk*(alpha2_y + 0.344006676123468_rk*neg_lam2_13) - &
        n4_z))
    ! link 3: moment that turns the link [N m]
    nc3_y = 2.749911_rk*neg_a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = c4*t9 - (s4*t8 - (nc3_y - (6.3825532937_rk*lam2_12 - (2.203_rk*ww2_xy + q(3)*f3_x))))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! torques that hold the arm at rest
  ! 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
  pure subroutine stanford_d3_gravity(q, tau) &
      bind(c, name="stanford_d3_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c5, hw5_y, s2, c4, c2, s5, hw5_x, tau5, s4, hw4_y, tau4, tau3, hw4_x, neg_hw3_z
    real(rk) :: hw2_x, t1

    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_y = -1.1261376_rk*c5
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    c4 = cos(q(4))
    c2 = cos(q(2))
    s5 = sin(q(5))
    ! link 5: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw5_x = 1.1261376_rk*s5
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = hw5_y*(s2*c4) - c2*hw5_x
    ! sines and cosines of the joint angles
    s4 = sin(q(4))
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_y = hw5_x*s4 - 0.0571536_rk*c4
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = s2*hw4_y
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 63.406_rk*c2
    ! link 4: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw4_x = c4*hw5_x + 0.0571536_rk*s4
    ! link 3: first moment of all that the joint carries, before its turn, times gravity [N m]
    neg_hw3_z = hw5_y + 26.9491278_rk
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = c2*hw4_x + s2*(63.406_rk*q(3) - neg_hw3_z)
    t1 = -hw2_x
    tau(1) = 0.0_rk
    tau(2) = t1
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 110 multiplications, 71 additions = 181; 0 unary minus; 6 sine/cosine
  pure subroutine stanford_d3_bias(q, qd, tau) &
      bind(c, name="stanford_d3_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: neg_lam2_33, s2, neg_w2_x, c2, neg_w2_y, neg_ww2_zx, ww2_xy, ww2_xx, ww2_zz
    real(rk) :: neg_lam2_22, c4, s4, neg_w4_x, w4_y, w4_z, neg_ww4_zx, neg_ww4_xy, c5, s5, neg_w5_x
    real(rk) :: w5_z, neg_w5_y, neg_ww5_zx, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1, n06_y
    real(rk) :: n06_x, fc5_y, t2, neg_lam2_32, neg_a3_y, nc3_x, neg_lam4_22, lam4_12, ww4_yz
    real(rk) :: neg_lam4_32, t3, alpha5_y, n06_z, neg_a3_z, a2_x, neg_a3_x, a4_y, lam4_13, alpha4_y
    real(rk) :: lam5_12, neg_a4_x, a5_x, n5_z, neg_fc5_x, fc3_z, fc4_z, f3_z, neg_fc3_y, fc4_x
    real(rk) :: neg_f05_x, neg_f4_x, fc4_y, t4, t5, fc5_z, f4_y, f04_y, neg_f3_y, fc3_x, f3_x, t6
    real(rk) :: t7, n4_z, t8, t9, t10, n1_z, nc3_y, n2_z

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_y = qd(2)*c4 + neg_w2_x*s4
    w4_z = neg_w2_y + qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_zx = neg_w4_x*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.0203_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    n06_x = w5_z*t1
    ! link 5: force that moves the link [N]
    fc5_y = 0.114912_rk*neg_lam5_22
    t2 = 2.0_rk*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_32 = neg_w2_y*t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = 0.1524_rk*neg_lam2_33 - (neg_lam2_32*q(3) + 2.0_rk*(neg_w2_x*qd(3)))
    ! link 3: moment that turns the link [N m]
    nc3_x = -2.749911_rk*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    lam4_12 = neg_ww2_zx - neg_ww4_xy
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_32 = c4*neg_lam2_32 + (ww2_xy*s4 - 2.0_rk*ww4_yz)
    t3 = c5*lam4_12 + s5*neg_lam4_32
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww5_zx + t3
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.0203_rk*alpha5_y
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_z = neg_lam2_22*q(3) - 9.8_rk*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = ww2_xy*q(3) - a2_x - t2*qd(3)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = s4*neg_a3_x - c4*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = s4*neg_lam2_32 - ww2_xy*c4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx + lam4_13
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = s4*neg_a3_y + c4*neg_a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*neg_a3_z - c5*neg_a4_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = n06_y - (0.0299343144_rk*lam5_12 - 0.0974_rk*alpha4_y) + 0.114912_rk*a5_x
    ! link 5: force that moves the link [N]
    neg_fc5_x = 0.114912_rk*lam5_12
    ! link 3: force that moves the link [N]
    fc3_z = 2.749911_rk*neg_lam2_22 - 6.47_rk*neg_a3_z
    ! link 4: force that moves the link [N]
    fc4_z = 0.005832_rk*neg_lam4_32
    ! link 3: force through the joint [N]
    f3_z = s5*neg_fc5_x + fc3_z + fc4_z - c5*fc5_y
    ! link 3: force that moves the link [N]
    neg_fc3_y = 6.47_rk*(neg_a3_y + 0.4250248840803709_rk*neg_lam2_32)
    ! link 4: force that moves the link [N]
    fc4_x = -0.005832_rk*lam4_12
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    neg_f05_x = s5*fc5_y + c5*neg_fc5_x
    ! link 4: force through the joint [N]
    neg_f4_x = neg_f05_x - fc4_x
    ! link 4: force that moves the link [N]
    fc4_y = 0.005832_rk*neg_lam4_22
    t4 = c5*neg_lam4_32 - s5*lam4_12
    t5 = 0.1572686288_rk*(w5_z*neg_w5_y) + 0.0786343144_rk*t4
    ! link 5: force that moves the link [N]
    fc5_z = 1.4613467527097814_rk*t5
    ! link 4: force through the joint [N]
    f4_y = fc4_y + fc5_z
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_y = c4*f4_y - s4*neg_f4_x
    ! link 3: force through the joint [N]
    neg_f3_y = neg_fc3_y - f04_y
    ! link 3: force that moves the link [N]
    fc3_x = 2.749911_rk*ww2_xy - 6.47_rk*neg_a3_x
    ! link 3: force through the joint [N]
    f3_x = fc3_x - c4*neg_f4_x - s4*f4_y
    t6 = 0.114912_rk*a4_y + (0.0587314928_rk*t4 - (n06_x - t5))
    t7 = 0.0100314928_rk*t3 + 0.1177_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = s5*t6 - c5*t7 - (0.005832_rk*neg_a4_x + 5.36544e-05_rk*lam4_13) - 0.106_rk*neg_ww4_xy
    t8 = 5.36544e-05_rk*(neg_lam2_22 - neg_lam4_22) + (s5*t7 - 0.005832_rk*neg_a3_z) + (c5*t6 + &
        0.106_rk*ww4_yz)
    t9 = 0.106_rk*alpha4_y + (5.36544e-05_rk*lam4_12 + n5_z)
    t10 = c4*t8 - nc3_x + 5.2810532937_rk*neg_lam2_32 + (s4*t9 - 0.1524_rk*f3_z - q(3)*neg_f3_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*t10 - c2*(0.1524_rk*f3_x + (2.203_rk*neg_ww2_zx - n4_z))
    ! link 3: moment that turns the link [N m]
    nc3_y = 2.749911_rk*neg_a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = q(3)*f3_x + (nc3_y + (c4*t9 - s4*t8)) - 4.1795532937_rk*ww2_xy
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 40 multiplications, 32 additions = 72; 2 unary minus; 6 sine/cosine
  pure subroutine stanford_d3_mass_matrix(q, M) &
      bind(c, name="stanford_d3_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, neg_nu5_y, h5_x, neg_h5_y, h4_x, t1, neg_h4_y, h3_z, m1_3
    real(rk) :: t2, t3, h2_y, t4, t5, m4_4, t6, t7, t8, t9, t10, t11, m1_4, t12, t13, t14, t15
    real(rk) :: m1_1, m2_4, m1_2, t16, neg_nu2_y, t17, fu2_x, m1_5, m2_2, m2_5, nu4_y, t18, t19, t20

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.0203_rk*c5
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.114912_rk*s5
    neg_h5_y = 0.114912_rk*c5
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x + 0.005832_rk*s4
    t1 = s4*h5_x
    neg_h4_y = 0.005832_rk*c4 - t1
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y - 2.749911_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(neg_h4_y - 0.986028_rk)
    t2 = s2*h4_x
    t3 = h3_z + 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = t2 - c2*t3
    t4 = 0.08384080339738234_rk*c5
    t5 = neg_h5_y*t4
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t5
    t6 = 0.1524_rk*neg_h4_y
    t7 = m4_4 - t6
    t8 = s2*s4
    t9 = s2*h5_x
    t10 = c4*t9
    t11 = 5.36544e-05_rk*t8 - (t4*t10 + t2*q(3))
    ! link 1: mass matrix, its row of this joint
    m1_4 = c2*t7 - t11
    t12 = c4*(t5 - 0.1056028216_rk)
    t13 = 1.1173814928_rk - c4*t12
    t14 = q(3)*(h3_z + t3) + (t5 + 5.3929032937_rk)
    t15 = t13 - t14 - t7
    m1_1 = 1.5954239597_rk - c2*(t11 - (c2*t15 + m1_4)) - (t6 + t15)
    ! link 2: mass matrix, its row of this joint
    m2_4 = neg_h4_y*q(3) - 5.36544e-05_rk*c4 - t1*t4
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.1524_rk*h2_y + c2*m2_4 - t12*t8
    t16 = neg_h5_y*q(3) + 0.1273343144_rk
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = t8*t16
    t17 = c2*neg_h5_y
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c4*t17 - t9
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y - 0.1524_rk*fu2_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t13 + t14
    m2_5 = c4*t16
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.1766569200779727_rk*t1
    t18 = 0.1766569200779727_rk*(t17 - t10)
    t19 = -h4_x
    t20 = -h5_x
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = t18
    M(7) = m1_2
    M(8) = m2_2
    M(9) = t19
    M(10) = m2_4
    M(11) = m2_5
    M(12) = nu4_y
    M(13) = m1_3
    M(14) = t19
    M(15) = 6.47_rk
    M(16) = 0.0_rk
    M(17) = t20
    M(18) = 0.0_rk
    M(19) = m1_4
    M(20) = m2_4
    M(21) = 0.0_rk
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = t20
    M(28) = 0.0_rk
    M(29) = 0.1273343144_rk
    M(30) = 0.0_rk
    M(31) = t18
    M(32) = nu4_y
    M(33) = 0.0_rk
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0203_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 207 multiplications, 150 additions, 4 divisions = 361; 1 unary minus; 6 sine/cosine
  pure subroutine stanford_d3_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_d3_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: neg_lam2_33, s2, neg_w2_x, c2, neg_w2_y, neg_ww2_zx, ww2_xy, ww2_xx, ww2_zz
    real(rk) :: neg_lam2_22, c4, s4, neg_w4_x, w4_y, w4_z, neg_ww4_zx, neg_ww4_xy, c5, s5, neg_w5_x
    real(rk) :: w5_z, neg_w5_y, neg_ww5_zx, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1, n06_y
    real(rk) :: n06_x, fc5_y, t2, neg_lam2_32, neg_a3_y, nc3_x, neg_lam4_22, lam4_12, ww4_yz
    real(rk) :: neg_lam4_32, t3, alpha5_y, n06_z, neg_a3_z, a2_x, neg_a3_x, a4_y, lam4_13, alpha4_y
    real(rk) :: lam5_12, neg_a4_x, a5_x, n5_z, neg_fc5_x, fc3_z, fc4_z, f3_z, neg_fc3_y, fc4_x
    real(rk) :: neg_f05_x, neg_f4_x, fc4_y, t4, t5, fc5_z, f4_y, f04_y, neg_f3_y, fc3_x, f3_x, t6
    real(rk) :: t7, n4_z, t8, t9, t10, n1_z, nc3_y, n2_z, neg_nu5_y, h5_x, neg_h5_y, h4_x, t11
    real(rk) :: neg_h4_y, h3_z, m1_3, t12, t13, h2_y, t14, t15, m4_4, t16, t17, t18, t19, t20, t21
    real(rk) :: neg_m1_4, t22, t23, t24, t25, neg_m1_1, m2_4, m1_2, t26, neg_nu2_y, t27, fu2_x
    real(rk) :: m1_5, m2_2, m2_5, nu4_y, t28, neg_ud1_6, neg_y5, y6, u2_6, neg_u1_6, neg_u3_5, u2_5
    real(rk) :: u1_5, neg_pivot4, neg_ipivot4, ud2_4, neg_u2_4, neg_ud1_4, u1_4, neg_pivot3
    real(rk) :: neg_ipivot3, neg_ud2_3, u2_3, ud1_3, neg_u1_3, neg_pivot2, neg_ipivot2, ud1_2
    real(rk) :: neg_u1_2, neg_pivot1, neg_ipivot1, neg_y4, neg_y3, neg_y2, neg_y1, qdd1, qdd2, qdd3
    real(rk) :: qdd4, qdd5, qdd6

    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_y = qd(2)*c4 + neg_w2_x*s4
    w4_z = neg_w2_y + qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    neg_ww4_zx = neg_w4_x*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    neg_w5_x = neg_w4_x*c5 + w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 - neg_w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    neg_ww5_zx = neg_w5_x*w5_z
    ww5_xy = neg_w5_x*neg_w5_y
    ww5_xx = neg_w5_x*neg_w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_22 = ww5_xx + ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.0203_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    n06_x = w5_z*t1
    ! link 5: force that moves the link [N]
    fc5_y = 0.114912_rk*neg_lam5_22
    t2 = 2.0_rk*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_32 = neg_w2_y*t2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_y = 0.1524_rk*neg_lam2_33 - (neg_lam2_32*q(3) + 2.0_rk*(neg_w2_x*qd(3)))
    ! link 3: moment that turns the link [N m]
    nc3_x = -2.749911_rk*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    lam4_12 = neg_ww2_zx - neg_ww4_xy
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_32 = c4*neg_lam2_32 + (ww2_xy*s4 - 2.0_rk*ww4_yz)
    t3 = c5*lam4_12 + s5*neg_lam4_32
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww5_zx + t3
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.0203_rk*alpha5_y
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_z = neg_lam2_22*q(3) - 9.8_rk*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = ww2_xy*q(3) - a2_x - t2*qd(3)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = s4*neg_a3_x - c4*neg_a3_y
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = s4*neg_lam2_32 - ww2_xy*c4
    ! link 4: angular acceleration [rad/s^2]
    alpha4_y = neg_ww4_zx + lam4_13
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha4_y
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = s4*neg_a3_y + c4*neg_a3_x
    ! link 5: acceleration of the frame's origin, gravity taken off [m/s^2]
    a5_x = s5*neg_a3_z - c5*neg_a4_x
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = n06_y - (0.0299343144_rk*lam5_12 - 0.0974_rk*alpha4_y) + 0.114912_rk*a5_x
    ! link 5: force that moves the link [N]
    neg_fc5_x = 0.114912_rk*lam5_12
    ! link 3: force that moves the link [N]
    fc3_z = 2.749911_rk*neg_lam2_22 - 6.47_rk*neg_a3_z
    ! link 4: force that moves the link [N]
    fc4_z = 0.005832_rk*neg_lam4_32
    ! link 3: force through the joint [N]
    f3_z = fc4_z + (fc3_z + s5*neg_fc5_x) - c5*fc5_y
    ! link 3: force that moves the link [N]
    neg_fc3_y = 6.47_rk*(neg_a3_y + 0.4250248840803709_rk*neg_lam2_32)
    ! link 4: force that moves the link [N]
    fc4_x = -0.005832_rk*lam4_12
    ! link 5: force through the joint, along the axes that its turn starts from [N]
    neg_f05_x = s5*fc5_y + c5*neg_fc5_x
    ! link 4: force through the joint [N]
    neg_f4_x = neg_f05_x - fc4_x
    ! link 4: force that moves the link [N]
    fc4_y = 0.005832_rk*neg_lam4_22
    t4 = c5*neg_lam4_32 - s5*lam4_12
    t5 = 0.1572686288_rk*(w5_z*neg_w5_y) + 0.0786343144_rk*t4
    ! link 5: force that moves the link [N]
    fc5_z = 1.4613467527097814_rk*t5
    ! link 4: force through the joint [N]
    f4_y = fc4_y + fc5_z
    ! link 4: force through the joint, along the axes that its turn starts from [N]
    f04_y = c4*f4_y - s4*neg_f4_x
    ! link 3: force through the joint [N]
    neg_f3_y = neg_fc3_y - f04_y
    ! link 3: force that moves the link [N]
    fc3_x = 2.749911_rk*ww2_xy - 6.47_rk*neg_a3_x
    ! link 3: force through the joint [N]
    f3_x = fc3_x - c4*neg_f4_x - s4*f4_y
    t6 = 0.114912_rk*a4_y + (0.0587314928_rk*t4 - (n06_x - t5))
    t7 = 0.0100314928_rk*t3 + 0.1177_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = s5*t6 - c5*t7 - (0.005832_rk*neg_a4_x + 5.36544e-05_rk*lam4_13) - 0.106_rk*neg_ww4_xy
    t8 = 5.36544e-05_rk*(neg_lam2_22 - neg_lam4_22) + (s5*t7 - 0.005832_rk*neg_a3_z) + (c5*t6 + &
        0.106_rk*ww4_yz)
    t9 = 0.106_rk*alpha4_y + (n5_z + 5.36544e-05_rk*lam4_12)
    t10 = c4*t8 - nc3_x + 5.2810532937_rk*neg_lam2_32 + (s4*t9 - 0.1524_rk*f3_z - q(3)*neg_f3_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*t10 - c2*(0.1524_rk*f3_x - (n4_z - 2.203_rk*neg_ww2_zx))
    ! link 3: moment that turns the link [N m]
    nc3_y = 2.749911_rk*neg_a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = q(3)*f3_x + (nc3_y + (c4*t9 - s4*t8)) - 4.1795532937_rk*ww2_xy
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.0203_rk*c5
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.114912_rk*s5
    neg_h5_y = 0.114912_rk*c5
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = c4*h5_x + 0.005832_rk*s4
    t11 = s4*h5_x
    neg_h4_y = 0.005832_rk*c4 - t11
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y - 2.749911_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*(neg_h4_y - 0.986028_rk)
    t12 = s2*h4_x
    t13 = h3_z + 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = t12 - c2*t13
    t14 = 0.08384080339738234_rk*c5
    t15 = neg_h5_y*t14
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t15
    t16 = 0.1524_rk*neg_h4_y
    t17 = t16 - m4_4
    t18 = s2*s4
    t19 = s2*h5_x
    t20 = c4*t19
    t21 = 5.36544e-05_rk*t18 - (t14*t20 + q(3)*t12)
    ! link 1: mass matrix, its row of this joint
    neg_m1_4 = c2*t17 + t21
    t22 = c4*(t15 - 0.1056028216_rk)
    t23 = c4*t22 - 1.1173814928_rk
    t24 = q(3)*(h3_z + t13) + (t15 + 5.3929032937_rk)
    t25 = t17 - (t23 + t24)
    neg_m1_1 = c2*(t21 + (neg_m1_4 - c2*t25)) - 1.5954239597_rk + (t16 + t25)
    ! link 2: mass matrix, its row of this joint
    m2_4 = q(3)*neg_h4_y - 5.36544e-05_rk*c4 - t11*t14
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.1524_rk*h2_y + c2*m2_4 - t18*t22
    t26 = q(3)*neg_h5_y + 0.1273343144_rk
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = t18*t26
    t27 = c2*neg_h5_y
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = c4*t27 - t19
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y - 0.1524_rk*fu2_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t24 - t23
    m2_5 = c4*t26
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.1766569200779727_rk*t11
    t28 = t20 - t27
    ! factorisation M = U D U^T
    neg_ud1_6 = 0.1766569200779727_rk*t28
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    y6 = tau(6) - n06_z
    ! factorisation M = U D U^T
    u2_6 = 8.70231133389028_rk*t11
    neg_u1_6 = 8.70231133389028_rk*t28
    neg_u3_5 = 0.9024433087142769_rk*s5
    u2_5 = 7.853342633617698_rk*m2_5
    u1_5 = 7.853342633617698_rk*m1_5
    neg_pivot4 = c5*neg_nu5_y - m4_4
    neg_ipivot4 = 1.0_rk / neg_pivot4
    ud2_4 = m2_4 - neg_nu5_y*u2_6
    neg_u2_4 = neg_ipivot4*ud2_4
    neg_ud1_4 = neg_m1_4 - neg_nu5_y*neg_u1_6
    u1_4 = neg_ipivot4*neg_ud1_4
    neg_pivot3 = h5_x*neg_u3_5 - 6.47_rk
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = h4_x - h5_x*u2_5
    u2_3 = neg_ipivot3*neg_ud2_3
    ud1_3 = m1_3 + h5_x*u1_5
    neg_u1_3 = neg_ipivot3*ud1_3
    neg_pivot2 = nu4_y*u2_6 - m2_2 + m2_5*u2_5 - ud2_4*neg_u2_4 - neg_ud2_3*u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ud1_2 = m1_2 + nu4_y*neg_u1_6 - m2_5*u1_5 - ud2_4*u1_4 - neg_ud2_3*neg_u1_3
    neg_u1_2 = neg_ipivot2*ud1_2
    neg_pivot1 = neg_m1_1 + neg_ud1_6*neg_u1_6 + m1_5*u1_5 - neg_ud1_4*u1_4 - ud1_3*neg_u1_3 - &
        ud1_2*neg_u1_2
    neg_ipivot1 = 1.0_rk / neg_pivot1
    ! link 4: forward substitution
    neg_y4 = n4_z - tau(4) + c5*y6
    ! link 3: forward substitution
    neg_y3 = f3_z - tau(3) + neg_y5*neg_u3_5
    ! link 2: forward substitution
    neg_y2 = n2_z - tau(2) + y6*u2_6 - neg_y5*u2_5 + neg_u2_4*neg_y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = n1_z - tau(1) - y6*neg_u1_6 - neg_y5*u1_5 - u1_4*neg_y4 + neg_u1_3*neg_y3 + &
        neg_u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = neg_ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_ipivot2*neg_y2 + neg_u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 + neg_u1_3*qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd4 = neg_ipivot4*neg_y4 + neg_u2_4*qdd2 - u1_4*qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = -u1_5*qdd1 - (7.853342633617698_rk*neg_y5 - neg_u3_5*qdd3 + u2_5*qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = 49.26108374384236_rk*y6 - c5*qdd4 - u2_6*qdd2 + neg_u1_6*qdd1
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = qdd4
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
