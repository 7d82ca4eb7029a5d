! stanford: Stanford arm, six joints
! Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; Izz of link 3 assumed
! Origin of numbers: geometry, mass, centre of mass, inertia, rotor inertia: stated by the
!     description
! Origin of numbers: friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: de26546409d6162d87592b49cbe31f58 (a hash of its numbers)
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
! Torques are the motors', reflected to the joints; what lies between is in them.
! Effects in this model:
!   rotor inertia: joint 1 0.953 kg m^2, joint 2 2.193 kg m^2, joint 3 0.782 kg, joint 4 0.106 kg
!     m^2, joint 5 0.097 kg m^2, joint 6 0.02 kg m^2
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 6.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 114 multiplications, 87 additions = 201; 6 unary minus; 6 sine/cosine
!   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
!   bias: 104 multiplications, 70 additions = 174; 0 unary minus; 6 sine/cosine
!   mass_matrix: 41 multiplications, 32 additions = 73; 2 unary minus; 6 sine/cosine
!   forward_dynamics: 201 multiplications, 149 additions, 4 divisions = 354; 2 unary minus; 6
!       sine/cosine
module stanford_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_inverse_dynamics
  public :: stanford_gravity
  public :: stanford_bias
  public :: stanford_mass_matrix
  public :: stanford_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! with rotor inertia
  ! 114 multiplications, 87 additions = 201; 6 unary minus; 6 sine/cosine
  pure subroutine stanford_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_inverse_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: qdd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s2, w2_x, c2, w2_y, lam2_13, ww2_zx, alpha2_y, ww2_yz, lam2_23, ww2_xy, neg_a2_x
    real(rk) :: neg_a2_y, lam2_12, c4, s4, w4_x, w4_y, w4_z, ww4_yz, ww4_xy, ww4_zz, c5, s5, w5_x
    real(rk) :: w5_z, neg_w5_y, ww5_zx, ww5_xy, ww5_xx, ww5_zz, lam5_22, w6_z, t1, neg_n06_y, n06_x
    real(rk) :: lam2_32, nc2_x, lam4_12, lam4_32, t2, t3, neg_lam5_32, neg_lam4_22, f4_y
    real(rk) :: neg_lam4_13, alpha5_z, lam5_12, neg_fc4_x, t4, t5, f4_x, neg_lam2_33, t6, a3_y
    real(rk) :: fc3_y, f3_y, t7, lam2_22, a3_z, neg_fc4_z, f3_z, a3_x, a4_y, alpha5_y, neg_n06_z
    real(rk) :: t8, t9, n4_x, nc4_y, a4_x, n5_z, n4_y, n2_x, n4_z, lam2_31, neg_nc2_y, f3_x, n2_y
    real(rk) :: tau1, nc3_y, tau2, tau3, tau4, tau5, tau6

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    w2_x = -s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    w2_y = -qd(1)*c2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_13 = -c2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zx = w2_x*qd(2)
    ! link 2: angular acceleration [rad/s^2]
    alpha2_y = lam2_13 - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = w2_y*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_12 = ww2_xy - qdd(2)
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    w4_x = w2_x*c4 + qd(2)*s4
    w4_y = qd(2)*c4 - w2_x*s4
    w4_z = qd(4) - w2_y
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    ww4_xy = w4_x*w4_y
    ww4_zz = w4_z*w4_z
    ! sines and cosines of the joint angles
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: angular velocity [rad/s]
    w5_x = w4_x*c5 - w4_z*s5
    w5_z = w4_y + qd(5)
    neg_w5_y = w4_z*c5 + w4_x*s5
    ! link 5: products of the angular velocity [1/s^2]
    ww5_zx = w5_x*w5_z
    ww5_xy = -w5_x*neg_w5_y
    ww5_xx = w5_x*w5_x
    ww5_zz = w5_z*w5_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_22 = -ww5_xx - ww5_zz
    ! link 6: angular velocity [rad/s]
    w6_z = neg_w5_y + qd(6)
    t1 = 0.0003_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    neg_n06_y = w5_x*t1
    n06_x = w5_z*t1
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_32 = 2.0_rk*ww2_yz - lam2_23
    ! link 2: moment that turns the link [N m]
    nc2_x = 4.2875532937_rk*lam2_32
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = alpha2_y + ww4_xy - qdd(4)
    lam4_32 = ww4_yz + c4*lam2_32 + (ww4_yz - lam2_12*s4)
    t2 = w5_z*neg_w5_y
    t3 = t2 - s5*lam4_12 - c5*lam4_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = t2 + t3
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    ! link 4: force through the joint [N]
    f4_y = 0.005832_rk*(neg_lam4_22 + 19.703703703703702_rk*neg_lam5_32)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_13 = lam2_12*c4 + s4*lam2_32
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = qdd(5) - neg_lam4_13 - w4_x*w4_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: force that moves the link [N]
    neg_fc4_x = 0.005832_rk*lam4_12
    t4 = 0.114912_rk*s5
    t5 = 0.114912_rk*c5
    ! link 4: force through the joint [N]
    f4_x = lam5_22*t4 - neg_fc4_x - lam5_12*t5
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    t6 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = -lam2_32*q(3) - w2_x*t6 - 0.1524_rk*neg_lam2_33
    ! link 3: force that moves the link [N]
    fc3_y = 6.47_rk*(a3_y - 0.4219534775888717_rk*lam2_32)
    ! link 3: force through the joint [N]
    f3_y = c4*f4_y + (fc3_y + s4*f4_x)
    t7 = ww4_zz - w4_y*w4_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_22 = t7 - neg_lam4_22
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y + (q(3)*lam2_22 - (0.1524_rk*lam2_23 - qdd(3)))
    ! link 4: force that moves the link [N]
    neg_fc4_z = 0.005832_rk*lam4_32
    ! link 3: force through the joint [N]
    f3_z = 6.47_rk*a3_z + lam5_12*t4 - (neg_fc4_z + (-2.730039_rk*lam2_22 - lam5_22*t5))
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = 0.1524_rk*lam2_13 + (qd(2)*t6 - lam2_12*q(3) - neg_a2_x)
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = c4*a3_y - s4*a3_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = c5*lam4_12 - s5*lam4_32 - ww5_zx
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    neg_n06_z = 0.0003_rk*(alpha5_y - qdd(6))
    t8 = n06_x - (0.0289028216_rk*t2 + 0.114912_rk*a4_y + 0.0313658072_rk*t3)
    t9 = -0.0010314928_rk*ww5_zx - (neg_n06_z + 0.0014314928_rk*alpha5_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 5.36544e-05_rk*t7 - (0.005832_rk*a3_z - c5*t8) + s5*t9
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_x = c4*a3_x + s4*a3_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = t5*a4_x - neg_n06_y - (t4*a3_z + 0.0299343144_rk*(lam5_12 - &
        0.013362590993565565_rk*alpha5_z))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = nc4_y + n5_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = nc2_x - q(3)*f3_y - (2.730039_rk*(a3_y - 0.055823378347342294_rk*f3_z) - c4*n4_x + &
        s4*n4_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = 5.36544e-05_rk*neg_lam4_13 + 0.005832_rk*a4_x + c5*t9 - s5*t8
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_31 = ww2_zx - alpha2_y
    ! link 2: moment that turns the link [N m]
    neg_nc2_y = 0.008_rk*lam2_31
    ! link 3: force through the joint [N]
    f3_x = c4*f4_x + 6.47_rk*a3_x - s4*f4_y - 2.730039_rk*lam2_12
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_y = 0.1524_rk*f3_x - neg_nc2_y - n4_z
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 1.4431532925_rk*qdd(1) - s2*n2_x - c2*n2_y
    ! link 3: moment that turns the link [N m]
    nc3_y = 2.730039_rk*a3_x
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = s4*n4_x + (6.4885532937_rk*qdd(2) + c4*n4_y) - (4.2795532937_rk*ww2_xy - q(3)*f3_x - &
        nc3_y)
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = f3_z + 0.782_rk*qdd(3)
    ! link 4: joint torque [N m], at a prismatic joint force [N]
    tau4 = n4_z + 0.106_rk*qdd(4)
    ! link 5: joint torque [N m], at a prismatic joint force [N]
    tau5 = n5_z + 0.097_rk*qdd(5)
    ! link 6: joint torque [N m], at a prismatic joint force [N]
    tau6 = 0.02_rk*qdd(6) - neg_n06_z
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = tau6
  end subroutine

  ! torques that hold the arm at rest
  ! 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
  pure subroutine stanford_gravity(q, tau) &
      bind(c, name="stanford_gravity_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: c5, hw5_y, s2, c4, c2, s5, hw5_x, tau5, s4, hw4_y, tau4, tau3, hw4_x, hw3_z, hw2_x
    real(rk) :: t1

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
    hw3_z = 26.7543822_rk - hw5_y
    ! link 2: first moment of all that the joint carries, before its turn, times gravity [N m]
    hw2_x = c2*hw4_x + s2*(hw3_z + 63.406_rk*q(3))
    t1 = -hw2_x
    tau(1) = 0.0_rk
    tau(2) = t1
    tau(3) = tau3
    tau(4) = tau4
    tau(5) = tau5
    tau(6) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 104 multiplications, 70 additions = 174; 0 unary minus; 6 sine/cosine
  pure subroutine stanford_bias(q, qd, tau) &
      bind(c, name="stanford_bias_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(out) :: tau(6)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_zx, neg_ww2_yz, ww2_xy, neg_a2_x, neg_a2_y, c4
    real(rk) :: s4, neg_w4_x, w4_y, w4_z, ww4_yz, neg_ww4_xy, ww4_zz, c5, s5, neg_w5_x, w5_z
    real(rk) :: neg_w5_y, neg_ww5_zx, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1, n06_y, n06_x
    real(rk) :: neg_lam2_32, nc2_x, lam4_12, lam4_32, t2, t3, neg_lam5_32, neg_lam4_22, f4_y
    real(rk) :: lam4_13, alpha5_z, lam5_12, fc4_x, t4, t5, neg_f4_x, neg_lam2_33, t6, a3_y, fc3_y
    real(rk) :: f3_y, t7, neg_lam2_22, a3_z, fc4_z, f3_z, neg_a3_x, a4_y, alpha5_y, n06_z, t8, t9
    real(rk) :: n4_x, nc4_y, neg_a4_x, n5_z, n4_y, neg_n2_x, n4_z, nc2_y, neg_f3_x, neg_n2_y, tau1
    real(rk) :: nc3_y, tau2

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    neg_ww2_yz = neg_w2_y*qd(2)
    ww2_xy = neg_w2_x*neg_w2_y
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_y = qd(2)*c4 + neg_w2_x*s4
    w4_z = neg_w2_y + qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_zz = w4_z*w4_z
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
    t1 = 0.0003_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    n06_x = w5_z*t1
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_32 = 2.0_rk*neg_ww2_yz
    ! link 2: moment that turns the link [N m]
    nc2_x = -8.5751065874_rk*neg_ww2_yz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = neg_ww2_zx - neg_ww4_xy
    lam4_32 = ww4_yz - c4*neg_lam2_32 + (ww4_yz - ww2_xy*s4)
    t2 = w5_z*neg_w5_y
    t3 = t2 - s5*lam4_12 - c5*lam4_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = t2 + t3
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    ! link 4: force through the joint [N]
    f4_y = 0.005832_rk*(neg_lam4_22 + 19.703703703703702_rk*neg_lam5_32)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = s4*neg_lam2_32 - ww2_xy*c4
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = lam4_13 + neg_w4_x*w4_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: force that moves the link [N]
    fc4_x = -0.005832_rk*lam4_12
    t4 = 0.114912_rk*c5
    t5 = 0.114912_rk*s5
    ! link 4: force through the joint [N]
    neg_f4_x = lam5_12*t4 + (neg_lam5_22*t5 - fc4_x)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    t6 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = neg_w2_x*t6 + neg_lam2_32*q(3) - 0.1524_rk*neg_lam2_33
    ! link 3: force that moves the link [N]
    fc3_y = 6.47_rk*(a3_y + 0.8439069551777434_rk*neg_ww2_yz)
    ! link 3: force through the joint [N]
    f3_y = c4*f4_y + (fc3_y - s4*neg_f4_x)
    t7 = ww4_zz - w4_y*w4_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = neg_lam4_22 - t7
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - q(3)*neg_lam2_22
    ! link 4: force that moves the link [N]
    fc4_z = -0.005832_rk*lam4_32
    ! link 3: force through the joint [N]
    f3_z = 6.47_rk*a3_z + lam5_12*t5 - (2.730039_rk*neg_lam2_22 + neg_lam5_22*t4 - fc4_z)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = neg_a2_x - (qd(2)*t6 - ww2_xy*q(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = c4*a3_y + s4*neg_a3_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww5_zx + (c5*lam4_12 - s5*lam4_32)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.0003_rk*alpha5_y
    t8 = n06_x - (0.0289028216_rk*t2 + 0.114912_rk*a4_y + 0.0313658072_rk*t3)
    t9 = 0.0010314928_rk*neg_ww5_zx - 0.0017314928_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 5.36544e-05_rk*t7 - (0.005832_rk*a3_z - c5*t8) + s5*t9
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x - s4*a3_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = n06_y - t4*neg_a4_x - (t5*a3_z + 0.0299343144_rk*(lam5_12 - &
        0.013362590993565565_rk*alpha5_z))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = nc4_y + n5_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = q(3)*f3_y - nc2_x + (2.730039_rk*(a3_y - 0.055823378347342294_rk*f3_z) - c4*n4_x + &
        s4*n4_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_z = -5.36544e-05_rk*lam4_13 - 0.005832_rk*neg_a4_x + c5*t9 - s5*t8
    ! link 2: moment that turns the link [N m]
    nc2_y = 0.016_rk*neg_ww2_zx
    ! link 3: force through the joint [N]
    neg_f3_x = 2.730039_rk*ww2_xy + (s4*f4_y + (c4*neg_f4_x + 6.47_rk*neg_a3_x))
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_y = n4_z - (nc2_y - 0.1524_rk*neg_f3_x)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = s2*neg_n2_x + c2*neg_n2_y
    ! link 3: moment that turns the link [N m]
    nc3_y = -2.730039_rk*neg_a3_x
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = s4*n4_x + c4*n4_y - (4.2795532937_rk*ww2_xy + q(3)*neg_f3_x - nc3_y)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = f3_z
    tau(4) = n4_z
    tau(5) = n5_z
    tau(6) = n06_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 41 multiplications, 32 additions = 73; 2 unary minus; 6 sine/cosine
  pure subroutine stanford_mass_matrix(q, M) &
      bind(c, name="stanford_mass_matrix_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(out) :: M(36)
    real(rk) :: c2, s2, c4, s4, c5, s5, neg_nu5_y, h5_x, neg_h5_y, t1, h4_x, t2, neg_h4_y, h3_z, t3
    real(rk) :: m1_3, t4, t5, h2_y, t6, t7, t8, t9, t10, t11, t12, t13, t14, t15, t16, m1_1, k4_yz
    real(rk) :: m2_4, m1_2, m1_4, t17, neg_nu2_y, t18, neg_fu2_x, m1_5, m2_2, m2_5, nu4_y, m4_4
    real(rk) :: t19, t20, t21

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c4 = cos(q(4))
    s4 = sin(q(4))
    c5 = cos(q(5))
    s5 = sin(q(5))
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.0003_rk*c5
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    h5_x = 0.114912_rk*s5
    neg_h5_y = 0.114912_rk*c5
    t1 = c4*h5_x
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = t1 + 0.005832_rk*s4
    t2 = s4*h5_x
    neg_h4_y = 0.005832_rk*c4 - t2
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y + 2.730039_rk
    t3 = neg_h4_y - 0.986028_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*t3
    t4 = s2*h4_x
    t5 = h3_z + 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = t4 - c2*t5
    t6 = 0.257887030075188_rk*c5
    t7 = neg_h5_y*t6
    t8 = t7 + 4.2785218009_rk + q(3)*(h3_z + t5)
    t9 = c4*(t7 - 0.0286028216_rk)
    t10 = c4*t9
    t11 = 0.1524_rk*t3
    t12 = s2*s4
    t13 = s2*t1
    t14 = t4*q(3) - (5.36544e-05_rk*t12 - t6*t13)
    t15 = c2*t14
    t16 = t11 + (t7 + 0.11890486_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = (t8 + t10)*(s2*s2) - (t11 - (t15 + (t15 + 1.4511532925_rk))) - t16
    ! link 4: second moment of the composite body [kg m^2]
    k4_yz = 5.36544e-05_rk*c4 + t2*t6
    ! link 2: mass matrix, its row of this joint
    m2_4 = neg_h4_y*q(3) - k4_yz
    ! link 1: mass matrix, its row of this joint
    m1_2 = c2*m2_4 + (0.1524_rk*h2_y - t9*t12)
    m1_4 = t14 - c2*t16
    t17 = neg_h5_y*q(3) + 0.0303343144_rk
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = t12*t17
    t18 = t13 - c2*neg_h5_y
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = c4*t18 + t2*t12
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y + 0.1524_rk*neg_fu2_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t8 + 2.2117629856_rk - t10
    m2_5 = c4*t17
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.0026106934001670842_rk*t2
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t7
    t19 = -0.0026106934001670842_rk*t18
    t20 = -h4_x
    t21 = -h5_x
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_4
    M(5) = m1_5
    M(6) = t19
    M(7) = m1_2
    M(8) = m2_2
    M(9) = t20
    M(10) = m2_4
    M(11) = m2_5
    M(12) = nu4_y
    M(13) = m1_3
    M(14) = t20
    M(15) = 7.252_rk
    M(16) = 0.0_rk
    M(17) = t21
    M(18) = 0.0_rk
    M(19) = m1_4
    M(20) = m2_4
    M(21) = 0.0_rk
    M(22) = m4_4
    M(23) = 0.0_rk
    M(24) = neg_nu5_y
    M(25) = m1_5
    M(26) = m2_5
    M(27) = t21
    M(28) = 0.0_rk
    M(29) = 0.1273343144_rk
    M(30) = 0.0_rk
    M(31) = t19
    M(32) = nu4_y
    M(33) = 0.0_rk
    M(34) = neg_nu5_y
    M(35) = 0.0_rk
    M(36) = 0.0203_rk
  end subroutine

  ! accelerations that the torques tau give
  ! with rotor inertia
  ! 201 multiplications, 149 additions, 4 divisions = 354; 2 unary minus; 6 sine/cosine
  pure subroutine stanford_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_forward_dynamics_f")
    real(rk), intent(in) :: q(6)
    real(rk), intent(in) :: qd(6)
    real(rk), intent(in) :: tau(6)
    real(rk), intent(out) :: qdd(6)
    real(rk) :: s2, neg_w2_x, c2, neg_w2_y, neg_ww2_zx, neg_ww2_yz, ww2_xy, neg_a2_x, neg_a2_y, c4
    real(rk) :: s4, neg_w4_x, w4_y, w4_z, ww4_yz, neg_ww4_xy, ww4_zz, c5, s5, neg_w5_x, w5_z
    real(rk) :: neg_w5_y, neg_ww5_zx, ww5_xy, ww5_xx, ww5_zz, neg_lam5_22, w6_z, t1, n06_y, n06_x
    real(rk) :: neg_lam2_32, nc2_x, lam4_12, lam4_32, t2, t3, neg_lam5_32, neg_lam4_22, f4_y
    real(rk) :: lam4_13, alpha5_z, lam5_12, fc4_x, neg_h5_y, h5_x, neg_f4_x, neg_lam2_33, t4, a3_y
    real(rk) :: fc3_y, f3_y, t5, neg_lam2_22, a3_z, fc4_z, f3_z, neg_a3_x, a4_y, alpha5_y, n06_z
    real(rk) :: t6, t7, n4_x, nc4_y, neg_a4_x, n5_z, n4_y, neg_n2_x, neg_n4_z, nc2_y, neg_f3_x
    real(rk) :: n2_y, tau1, nc3_y, tau2, neg_nu5_y, t8, h4_x, t9, neg_h4_y, h3_z, t10, m1_3, t11
    real(rk) :: t12, h2_y, t13, t14, t15, t16, t17, t18, t19, t20, t21, t22, t23, m1_1, k4_yz
    real(rk) :: neg_m2_4, neg_m1_2, m1_4, t24, neg_nu2_y, t25, neg_fu2_x, m1_5, m2_2, m2_5, nu4_y
    real(rk) :: m4_4, neg_ud1_6, neg_y5, y6, u4_6, u2_6, neg_u1_6, neg_u3_5, u2_5, u1_5, neg_pivot4
    real(rk) :: neg_ipivot4, neg_ud2_4, u2_4, ud1_4, neg_u1_4, neg_pivot3, neg_ipivot3, neg_ud2_3
    real(rk) :: u2_3, ud1_3, neg_u1_3, neg_pivot2, neg_ipivot2, neg_ud1_2, u1_2, pivot1, ipivot1
    real(rk) :: y4, neg_y3, neg_y2, neg_y1, neg_qdd1, qdd2, qdd3, neg_qdd4, qdd5, qdd6, t26, t27

    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_y = qd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_zx = neg_w2_x*qd(2)
    neg_ww2_yz = neg_w2_y*qd(2)
    ww2_xy = neg_w2_x*neg_w2_y
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! sines and cosines of the joint angles
    c4 = cos(q(4))
    s4 = sin(q(4))
    ! link 4: angular velocity [rad/s]
    neg_w4_x = neg_w2_x*c4 - qd(2)*s4
    w4_y = qd(2)*c4 + neg_w2_x*s4
    w4_z = neg_w2_y + qd(4)
    ! link 4: products of the angular velocity [1/s^2]
    ww4_yz = w4_y*w4_z
    neg_ww4_xy = neg_w4_x*w4_y
    ww4_zz = w4_z*w4_z
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
    t1 = 0.0003_rk*w6_z
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_y = neg_w5_x*t1
    n06_x = w5_z*t1
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_32 = 2.0_rk*neg_ww2_yz
    ! link 2: moment that turns the link [N m]
    nc2_x = -8.5751065874_rk*neg_ww2_yz
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_12 = neg_ww2_zx - neg_ww4_xy
    lam4_32 = ww4_yz - c4*neg_lam2_32 + (ww4_yz - ww2_xy*s4)
    t2 = w5_z*neg_w5_y
    t3 = t2 - s5*lam4_12 - c5*lam4_32
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam5_32 = t2 + t3
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam4_22 = ww5_xx + neg_w5_y*neg_w5_y
    ! link 4: force through the joint [N]
    f4_y = 0.005832_rk*(neg_lam4_22 + 19.703703703703702_rk*neg_lam5_32)
    ! link 4: lambda matrix: takes a position to its acceleration [1/s^2]
    lam4_13 = s4*neg_lam2_32 - ww2_xy*c4
    ! link 5: angular acceleration [rad/s^2]
    alpha5_z = lam4_13 + neg_w4_x*w4_z
    ! link 5: lambda matrix: takes a position to its acceleration [1/s^2]
    lam5_12 = ww5_xy - alpha5_z
    ! link 4: force that moves the link [N]
    fc4_x = -0.005832_rk*lam4_12
    ! link 5: first moment of the composite body, about the frame's origin [kg m]
    neg_h5_y = 0.114912_rk*c5
    h5_x = 0.114912_rk*s5
    ! link 4: force through the joint [N]
    neg_f4_x = lam5_12*neg_h5_y + (neg_lam5_22*h5_x - fc4_x)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    t4 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_y = neg_w2_x*t4 + neg_lam2_32*q(3) - 0.1524_rk*neg_lam2_33
    ! link 3: force that moves the link [N]
    fc3_y = 6.47_rk*(a3_y + 0.8439069551777434_rk*neg_ww2_yz)
    ! link 3: force through the joint [N]
    f3_y = c4*f4_y + (fc3_y - s4*neg_f4_x)
    t5 = ww4_zz - w4_y*w4_y
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = neg_lam4_22 - t5
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - q(3)*neg_lam2_22
    ! link 4: force that moves the link [N]
    fc4_z = -0.005832_rk*lam4_32
    ! link 3: force through the joint [N]
    f3_z = 6.47_rk*a3_z + lam5_12*h5_x - (2.730039_rk*neg_lam2_22 + neg_lam5_22*neg_h5_y - fc4_z)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = neg_a2_x - (qd(2)*t4 - ww2_xy*q(3))
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    a4_y = c4*a3_y + s4*neg_a3_x
    ! link 5: angular acceleration [rad/s^2]
    alpha5_y = neg_ww5_zx + (c5*lam4_12 - s5*lam4_32)
    ! link 6: moment through the joint, along the axes that its turn starts from [N m]
    n06_z = -0.0003_rk*alpha5_y
    t6 = n06_x - (0.0289028216_rk*t2 + 0.114912_rk*a4_y + 0.0313658072_rk*t3)
    t7 = 0.0010314928_rk*neg_ww5_zx - 0.0017314928_rk*alpha5_y
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_x = 5.36544e-05_rk*t5 - (0.005832_rk*a3_z - c5*t6) + s5*t7
    ! link 4: moment that turns the link [N m]
    nc4_y = 5.36544e-05_rk*lam4_12
    ! link 4: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a4_x = c4*neg_a3_x - s4*a3_y
    ! link 5: moment through the joint, about the frame's origin [N m]
    n5_z = n06_y - neg_h5_y*neg_a4_x - (h5_x*a3_z + 0.0299343144_rk*(lam5_12 - &
        0.013362590993565565_rk*alpha5_z))
    ! link 4: moment through the joint, about the frame's origin [N m]
    n4_y = nc4_y + n5_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = q(3)*f3_y - nc2_x + (2.730039_rk*(a3_y - 0.055823378347342294_rk*f3_z) - c4*n4_x + &
        s4*n4_y)
    ! link 4: moment through the joint, about the frame's origin [N m]
    neg_n4_z = 5.36544e-05_rk*lam4_13 + 0.005832_rk*neg_a4_x - c5*t7 + s5*t6
    ! link 2: moment that turns the link [N m]
    nc2_y = 0.016_rk*neg_ww2_zx
    ! link 3: force through the joint [N]
    neg_f3_x = 2.730039_rk*ww2_xy + (s4*f4_y + (c4*neg_f4_x + 6.47_rk*neg_a3_x))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_y = neg_n4_z + (nc2_y - 0.1524_rk*neg_f3_x)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = s2*neg_n2_x - c2*n2_y
    ! link 3: moment that turns the link [N m]
    nc3_y = -2.730039_rk*neg_a3_x
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = s4*n4_x + c4*n4_y - (4.2795532937_rk*ww2_xy + q(3)*neg_f3_x - nc3_y)
    ! link 5: moment for a unit acceleration of a joint further out
    neg_nu5_y = 0.0003_rk*c5
    t8 = c4*h5_x
    ! link 4: first moment of the composite body, about the frame's origin [kg m]
    h4_x = t8 + 0.005832_rk*s4
    t9 = s4*h5_x
    neg_h4_y = 0.005832_rk*c4 - t9
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_z = neg_h5_y + 2.730039_rk
    t10 = neg_h4_y - 0.986028_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = s2*t10
    t11 = s2*h4_x
    t12 = h3_z + 6.47_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = t11 - c2*t12
    t13 = 0.257887030075188_rk*c5
    t14 = neg_h5_y*t13
    t15 = t14 + 4.2785218009_rk + q(3)*(h3_z + t12)
    t16 = c4*(t14 - 0.0286028216_rk)
    t17 = c4*t16
    t18 = 0.1524_rk*t10
    t19 = s2*s4
    t20 = s2*t8
    t21 = q(3)*t11 - (5.36544e-05_rk*t19 - t13*t20)
    t22 = c2*t21
    t23 = t18 + (t14 + 0.11890486_rk)
    ! link 1: mass matrix, its row of this joint
    m1_1 = (t15 + t17)*(s2*s2) - (t18 - (t22 + (t22 + 1.4511532925_rk))) - t23
    ! link 4: second moment of the composite body [kg m^2]
    k4_yz = 5.36544e-05_rk*c4 + t9*t13
    ! link 2: mass matrix, its row of this joint
    neg_m2_4 = k4_yz - q(3)*neg_h4_y
    ! link 1: mass matrix, its row of this joint
    neg_m1_2 = c2*neg_m2_4 - (0.1524_rk*h2_y - t16*t19)
    m1_4 = t21 - c2*t23
    t24 = neg_h5_y*q(3) + 0.0303343144_rk
    ! link 2: moment for a unit acceleration of a joint further out
    neg_nu2_y = t19*t24
    t25 = t20 - c2*neg_h5_y
    ! link 2: force for a unit acceleration of a joint further out
    neg_fu2_x = c4*t25 + t9*t19
    ! link 1: mass matrix, its row of this joint
    m1_5 = neg_nu2_y + 0.1524_rk*neg_fu2_x
    ! link 2: mass matrix, its row of this joint
    m2_2 = t15 + 2.2117629856_rk - t17
    m2_5 = c4*t24
    ! link 4: moment for a unit acceleration of a joint further out
    nu4_y = 0.0026106934001670842_rk*t9
    ! link 4: mass matrix, its row of this joint
    m4_4 = 0.1373658072_rk - t14
    ! factorisation M = U D U^T
    neg_ud1_6 = 0.0026106934001670842_rk*t25
    ! link 5: forward substitution
    neg_y5 = n5_z - tau(5)
    ! link 6: forward substitution
    y6 = tau(6) - n06_z
    ! factorisation M = U D U^T
    u4_6 = 0.014778325123152709_rk*c5
    u2_6 = 0.1286055862151273_rk*t9
    neg_u1_6 = 0.1286055862151273_rk*t25
    neg_u3_5 = 0.9024433087142769_rk*s5
    u2_5 = 7.853342633617698_rk*m2_5
    u1_5 = 7.853342633617698_rk*m1_5
    neg_pivot4 = neg_nu5_y*u4_6 - m4_4
    neg_ipivot4 = 1.0_rk / neg_pivot4
    neg_ud2_4 = neg_m2_4 + neg_nu5_y*u2_6
    u2_4 = neg_ipivot4*neg_ud2_4
    ud1_4 = m1_4 + neg_nu5_y*neg_u1_6
    neg_u1_4 = neg_ipivot4*ud1_4
    neg_pivot3 = h5_x*neg_u3_5 - 7.252_rk
    neg_ipivot3 = 1.0_rk / neg_pivot3
    neg_ud2_3 = h4_x - h5_x*u2_5
    u2_3 = neg_ipivot3*neg_ud2_3
    ud1_3 = m1_3 + h5_x*u1_5
    neg_u1_3 = neg_ipivot3*ud1_3
    neg_pivot2 = nu4_y*u2_6 - m2_2 + m2_5*u2_5 - neg_ud2_4*u2_4 - neg_ud2_3*u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    neg_ud1_2 = neg_m1_2 - nu4_y*neg_u1_6 + m2_5*u1_5 + neg_ud2_4*neg_u1_4 + neg_ud2_3*neg_u1_3
    u1_2 = neg_ipivot2*neg_ud1_2
    pivot1 = m1_1 - neg_ud1_6*neg_u1_6 - m1_5*u1_5 + ud1_4*neg_u1_4 + ud1_3*neg_u1_3 + &
        neg_ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 4: forward substitution
    y4 = neg_n4_z + tau(4) - y6*u4_6
    ! link 3: forward substitution
    neg_y3 = f3_z - tau(3) + neg_y5*neg_u3_5
    ! link 2: forward substitution
    neg_y2 = tau2 - tau(2) + y6*u2_6 - neg_y5*u2_5 + u2_4*y4 - u2_3*neg_y3
    ! link 1: forward substitution
    neg_y1 = tau1 - tau(1) - y6*neg_u1_6 - neg_y5*u1_5 - neg_u1_4*y4 + neg_u1_3*neg_y3 - &
        u1_2*neg_y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd1 = ipivot1*neg_y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_ipivot2*neg_y2 + u1_2*neg_qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_ipivot3*neg_y3 - u2_3*qdd2 - neg_u1_3*neg_qdd1
    ! link 4: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    neg_qdd4 = neg_ipivot4*y4 + u2_4*qdd2 + neg_u1_4*neg_qdd1
    ! link 5: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd5 = u1_5*neg_qdd1 - (7.853342633617698_rk*neg_y5 - neg_u3_5*qdd3 + u2_5*qdd2)
    ! link 6: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd6 = 49.26108374384236_rk*y6 + u4_6*neg_qdd4 - u2_6*qdd2 - neg_u1_6*neg_qdd1
    t26 = -neg_qdd1
    t27 = -neg_qdd4
    qdd(1) = t26
    qdd(2) = qdd2
    qdd(3) = qdd3
    qdd(4) = t27
    qdd(5) = qdd5
    qdd(6) = qdd6
  end subroutine
end module
