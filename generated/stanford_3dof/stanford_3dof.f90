! stanford_3dof: Stanford arm, first three joints
! Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; first three links, Izz of link 3
!   assumed
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 prismatic
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
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 44 multiplications, 29 additions = 73; 2 unary minus; 2 sine/cosine
!   gravity: 7 multiplications, 2 additions = 9; 0 unary minus; 2 sine/cosine
!   bias: 36 multiplications, 16 additions = 52; 0 unary minus; 2 sine/cosine
!   mass_matrix: 7 multiplications, 7 additions = 14; 0 unary minus; 2 sine/cosine
!   forward_dynamics: 59 multiplications, 35 additions, 3 divisions = 97; 3 unary minus; 2
!       sine/cosine
module stanford_3dof_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_3dof_inverse_dynamics
  public :: stanford_3dof_gravity
  public :: stanford_3dof_bias
  public :: stanford_3dof_mass_matrix
  public :: stanford_3dof_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 44 multiplications, 29 additions = 73; 2 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_3dof_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, ww1_zz, a2_z, t1, w2_x, w2_y, t2, a2_x, a2_y, ww2_yz, ww2_zx, alpha2_x
    real(rk) :: alpha2_y, ww2_xy, ww2_xx, ww2_zz, lam2_12, lam2_21, neg_lam2_22, neg_lam2_31
    real(rk) :: lam2_32, t3, a3_x, a3_y, a3_z, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, neg_fc3_z, nc3_x
    real(rk) :: nc3_y, tau3, n2_x, n2_z, neg_f02_x, tau2, tau1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    t2 = 0.1524_rk*qdd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2 - c2*t2
    a2_y = s2*t2 - 9.8_rk*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    alpha2_y = -qdd(1)*c2 - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_12 = ww2_xy - qdd(2)
    lam2_21 = qdd(2) + ww2_xy
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_31 = alpha2_y - ww2_zx
    lam2_32 = ww2_yz + alpha2_x
    t3 = 2.0_rk*qd(3)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = a2_x - q(3)*lam2_12 + qd(2)*t3
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t3
    a3_z = qdd(3) - (a2_y + q(3)*neg_lam2_22)
    ! link 2: moment that turns the link [N m]
    nc2_x = 4.2864618825_rk*lam2_32
    nc2_y = 0.008_rk*neg_lam2_31
    nc2_z = 0.008_rk*lam2_21 - 4.2864618825_rk*lam2_12
    ! link 3: force that moves the link [N]
    fc3_x = 4.25_rk*a3_x - 2.739975_rk*lam2_12
    fc3_y = 4.25_rk*a3_y - 2.739975_rk*lam2_32
    neg_fc3_z = 2.739975_rk*neg_lam2_22 - 4.25_rk*a3_z
    ! link 3: moment that turns the link [N m]
    nc3_x = -2.739975_rk*a3_y
    nc3_y = 2.739975_rk*a3_x
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 0.782_rk*qdd(3) - neg_fc3_z
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = nc3_x + (nc2_x - q(3)*fc3_y)
    n2_z = nc3_y + (nc2_z + q(3)*fc3_x)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = s2*neg_fc3_z - c2*fc3_x
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = n2_z + 2.193_rk*qdd(2)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 0.1524_rk*neg_f02_x - (s2*n2_x + c2*nc2_y) + 1.4431532925_rk*qdd(1)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
  end subroutine

  ! torques that hold the arm at rest
  ! 7 multiplications, 2 additions = 9; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_gravity(q, tau) &
      bind(c, name="stanford_3dof_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, neg_fc3_x, fc3_z, nc3_y, n2_z, f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 3: force that moves the link [N]
    neg_fc3_x = 41.65_rk*s2
    fc3_z = 41.65_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_y = -26.851755_rk*s2
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = nc3_y - q(3)*neg_fc3_x
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = s2*fc3_z - c2*neg_fc3_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1524_rk*f02_x
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 36 multiplications, 16 additions = 52; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_bias(q, qd, tau) &
      bind(c, name="stanford_3dof_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, ww1_zz, neg_a2_z, neg_w2_x, neg_w2_y, a2_x, neg_a2_y, neg_alpha2_x
    real(rk) :: alpha2_y, ww2_xy, ww2_xx, ww2_zz, neg_lam2_22, neg_lam2_32, a3_z, t1, a3_x
    real(rk) :: neg_a3_y, neg_nc2_x, nc2_y, nc2_z, neg_fc3_x, neg_fc3_y, fc3_z, nc3_x, nc3_y, n2_x
    real(rk) :: n2_z, f02_x, n02_y, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_z = 0.1524_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qd(2)*neg_w2_y
    alpha2_y = qd(2)*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_xx + ww2_zz
    neg_lam2_32 = 2.0_rk*neg_alpha2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y - q(3)*neg_lam2_22
    t1 = 2.0_rk*qd(3)
    a3_x = qd(2)*t1 - (q(3)*ww2_xy - a2_x)
    neg_a3_y = neg_a2_z - q(3)*neg_lam2_32 - neg_w2_x*t1
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 8.572923765_rk*neg_alpha2_x
    nc2_y = 0.016_rk*alpha2_y
    nc2_z = -4.2784618825_rk*ww2_xy
    ! link 3: force that moves the link [N]
    neg_fc3_x = 2.739975_rk*ww2_xy - 4.25_rk*a3_x
    neg_fc3_y = 4.25_rk*neg_a3_y - 5.47995_rk*neg_alpha2_x
    fc3_z = 4.25_rk*a3_z - 2.739975_rk*neg_lam2_22
    ! link 3: moment that turns the link [N m]
    nc3_x = 2.739975_rk*neg_a3_y
    nc3_y = 2.739975_rk*a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = nc3_x - (neg_nc2_x - q(3)*neg_fc3_y)
    n2_z = nc3_y + (nc2_z - q(3)*neg_fc3_x)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = s2*fc3_z - c2*neg_fc3_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*nc2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = -0.1524_rk*f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 7 multiplications, 7 additions = 14; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_mass_matrix(q, M) &
      bind(c, name="stanford_3dof_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, m1_3, t1, neg_h2_y, t2, k2_xx, m2_2, m1_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.6477_rk*s2
    t1 = 4.25_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = c2*(t1 + 2.739975_rk)
    t2 = q(3)*(t1 + 5.47995_rk)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t2 + 4.2864618825_rk - c2*c2*(t2 + 4.2784618825_rk)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t2 + 6.4874618825_rk
    ! link 1: mass matrix, its row of this joint
    m1_2 = -0.1524_rk*neg_h2_y
    m1_1 = k2_xx + 1.5418627725_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = 0.0_rk
    M(7) = m1_3
    M(8) = 0.0_rk
    M(9) = 5.032_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 59 multiplications, 35 additions, 3 divisions = 97; 3 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_3dof_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, m1_3, t1, neg_h2_y, t2, k2_xx, m2_2, m1_2, m1_1, ww1_zz, a2_z, t3, w2_x
    real(rk) :: w2_y, neg_a2_x, neg_a2_y, alpha2_x, neg_alpha2_y, ww2_xy, ww2_xx, ww2_zz, lam2_22
    real(rk) :: lam2_32, a3_z, t4, a3_x, a3_y, nc2_x, nc2_y, neg_nc2_z, fc3_x, fc3_y, neg_fc3_z
    real(rk) :: nc3_x, nc3_y, n2_x, n2_z, neg_f02_x, n02_y, n1_z, y1, ipivot1, l2_1, l3_1, pivot2
    real(rk) :: ipivot2, neg_ld3_2, l3_2, pivot3, ipivot3, y2, y3, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.6477_rk*s2
    t1 = 4.25_rk*q(3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    neg_h2_y = c2*(t1 + 2.739975_rk)
    t2 = q(3)*(t1 + 5.47995_rk)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t2 + 4.2864618825_rk - c2*c2*(t2 + 4.2784618825_rk)
    ! link 2: mass matrix, its row of this joint
    m2_2 = t2 + 6.4874618825_rk
    ! link 1: mass matrix, its row of this joint
    m1_2 = -0.1524_rk*neg_h2_y
    m1_1 = k2_xx + 1.5418627725_rk
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1524_rk*ww1_zz
    t3 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t3*s2
    w2_y = t3*c2
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a2_x = 9.8_rk*s2
    neg_a2_y = 9.8_rk*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    neg_alpha2_y = qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_22 = -ww2_xx - ww2_zz
    lam2_32 = 2.0_rk*alpha2_x
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = neg_a2_y + q(3)*lam2_22
    t4 = 2.0_rk*qd(3)
    a3_x = qd(2)*t4 - (neg_a2_x + q(3)*ww2_xy)
    a3_y = a2_z - q(3)*lam2_32 - w2_x*t4
    ! link 2: moment that turns the link [N m]
    nc2_x = 8.572923765_rk*alpha2_x
    nc2_y = -0.016_rk*neg_alpha2_y
    neg_nc2_z = 4.2784618825_rk*ww2_xy
    ! link 3: force that moves the link [N]
    fc3_x = 4.25_rk*a3_x - 2.739975_rk*ww2_xy
    fc3_y = 4.25_rk*a3_y - 5.47995_rk*alpha2_x
    neg_fc3_z = -4.25_rk*a3_z - 2.739975_rk*lam2_22
    ! link 3: moment that turns the link [N m]
    nc3_x = -2.739975_rk*a3_y
    nc3_y = 2.739975_rk*a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_x = nc3_x + (nc2_x - q(3)*fc3_y)
    n2_z = nc3_y + (q(3)*fc3_x - neg_nc2_z)
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = s2*neg_fc3_z - c2*fc3_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = s2*n2_x + c2*nc2_y
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1524_rk*neg_f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = m1_2*ipivot1
    l3_1 = m1_3*ipivot1
    pivot2 = m2_2 - m1_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    neg_ld3_2 = m1_2*l3_1
    l3_2 = -ipivot2*neg_ld3_2
    pivot3 = neg_ld3_2*l3_2 - (m1_3*l3_1 - 5.032_rk)
    ipivot3 = 1.0_rk / pivot3
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) + neg_fc3_z - y1*l3_1 - l3_2*y2
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = ipivot2*y2 - l3_2*qdd3
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = y1*ipivot1 - l2_1*qdd2 - l3_1*qdd3
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
