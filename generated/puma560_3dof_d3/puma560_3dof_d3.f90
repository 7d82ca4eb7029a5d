! puma560_3dof_d3: PUMA 560, first three joints, the set of the thesis's listing D.3.3
! Numbers: the 1990 thesis, program D.2, first three links (listing D.3.3)
! Written by robodyn; do not edit, generate again.
!
! Joints, base to tip: 1 revolute, 2 revolute, 3 revolute
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
!   inverse_dynamics: 75 multiplications, 58 additions = 133; 5 unary minus; 4 sine/cosine
!   gravity: 6 multiplications, 2 additions = 8; 0 unary minus; 4 sine/cosine
!   bias: 64 multiplications, 39 additions = 103; 4 unary minus; 4 sine/cosine
!   mass_matrix: 24 multiplications, 20 additions = 44; 1 unary minus; 4 sine/cosine
!   forward_dynamics: 104 multiplications, 72 additions, 3 divisions = 179; 5 unary minus; 4
!       sine/cosine
module puma560_3dof_d3_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_d3_inverse_dynamics
  public :: puma560_3dof_d3_gravity
  public :: puma560_3dof_d3_bias
  public :: puma560_3dof_d3_mass_matrix
  public :: puma560_3dof_d3_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 75 multiplications, 58 additions = 133; 5 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d3_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, c3, s3, ww1_zz, t1, w2_x, w2_y
    real(rk) :: ww2_yz, ww2_zx, alpha2_x, alpha2_y, ww2_xy, ww2_xx, neg_ww2_yy, ww2_zz
    real(rk) :: lam2_11, lam2_12, lam2_13, lam2_21, lam2_23, lam2_31, lam2_32, lam2_33
    real(rk) :: a2_z, t2, neg_a2_x, a2_y, w3_x, w3_y, alpha3_z, w3_z
    real(rk) :: ww3_xy, ww3_xx, ww3_zz, lam3_12, lam3_21, neg_lam3_22, t3, neg_lam3_31
    real(rk) :: lam3_32, a3_z, a3_x, nc1_z, fc2_x, fc2_y, nc2_x, nc2_y
    real(rk) :: nc2_z, fc3_x, fc3_y, nc3_y, nc3_x, nc3_z, t4, neg_n2_x
    real(rk) :: t5, n2_y, n2_z, f2_x, f2_y, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_yz = qd(2)*w2_y
    ww2_zx = qd(2)*w2_x
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = ww2_yz - qdd(1)*s2
    alpha2_y = -(qdd(1)*c2) - ww2_zx
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    neg_ww2_yy = -w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_11 = neg_ww2_yy - ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_13 = ww2_zx + alpha2_y
    lam2_21 = qdd(2) + ww2_xy
    lam2_23 = ww2_yz - alpha2_x
    lam2_31 = ww2_zx - alpha2_y
    lam2_32 = ww2_yz + alpha2_x
    lam2_33 = neg_ww2_yy - ww2_xx
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.2435_rk*ww1_zz
    t2 = 0.2435_rk*qdd(1)
    neg_a2_x = c2*t2 + 9.8_rk*s2
    a2_y = s2*t2 - 9.8_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    lam3_12 = ww3_xy - alpha3_z
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    t3 = qd(3) + w3_z
    neg_lam3_31 = c3*alpha2_y - s3*alpha2_x - w3_x*t3
    lam3_32 = w3_y*t3 - (-c3*alpha2_x - s3*alpha2_y)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (0.0934_rk*lam2_33 - 0.4318_rk*lam2_31)
    a3_x = s3*(a2_y + (0.4318_rk*lam2_21 - 0.0934_rk*lam2_23)) - c3*(neg_a2_x + (0.0934_rk*lam2_13 &
        - 0.4318_rk*lam2_11))
    ! link 1: moment that turns the link [N m]
    nc1_z = -0.093270802_rk*qdd(1)
    ! link 2: force that moves the link [N]
    fc2_x = 0.88944_rk*lam2_11
    fc2_y = 0.88944_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    nc2_x = 2.42815_rk*lam2_32 + 0.193584576_rk*lam2_21
    nc2_y = 0.193584576_rk*(lam2_33 - lam2_11) - 3.877373552_rk*lam2_31 + 0.21657864_rk*ww1_zz
    nc2_z = 3.877373552_rk*lam2_21 - 2.42815_rk*lam2_12 - 0.193584576_rk*lam2_23 + 0.88944_rk*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = -0.336_rk*lam3_12
    fc3_y = 0.336_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_y = 0.44345_rk*neg_lam3_31
    nc3_x = 0.51957_rk*lam3_32 - 0.336_rk*a3_z
    nc3_z = 0.44345_rk*lam3_21 - 0.51957_rk*lam3_12 + 0.336_rk*a3_x
    t4 = s3*fc3_x + c3*fc3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = s3*nc3_y - c3*nc3_x - (nc2_x + 0.0934_rk*t4)
    t5 = c3*fc3_x - s3*fc3_y
    n2_y = nc2_y - (0.0934_rk*t5 - 0.1450848_rk*lam3_32) - (-s3*nc3_x - c3*nc3_y)
    n2_z = nc3_z + (nc2_z + 0.4318_rk*t4)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + t5
    f2_y = fc2_y + t4
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + (nc1_z + 0.2435_rk*(s2*f2_y - c2*f2_x))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = nc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 6 multiplications, 2 additions = 8; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_gravity(q, tau) &
      bind(c, name="puma560_3dof_d3_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, c3, s3, a2_x, a2_y, a3_x, nc2_z
    real(rk) :: nc3_z, n2_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    a2_y = -9.8_rk*c2
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_x = c3*a2_x + s3*a2_y
    ! link 2: moment that turns the link [N m]
    nc2_z = -8.716512_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.336_rk*a3_x
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = nc2_z + nc3_z
    tau(1) = 0.0_rk
    tau(2) = n2_z
    tau(3) = nc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 64 multiplications, 39 additions = 103; 4 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d3_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, c3, s3, ww1_zz, t1, w2_x, w2_y
    real(rk) :: alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33
    real(rk) :: a2_z, a2_x, a2_y, w3_x, w3_y, w3_z, ww3_xy, ww3_xx
    real(rk) :: ww3_zz, neg_lam3_22, t2, neg_lam3_31, lam3_32, a3_z, neg_a3_x, fc2_x
    real(rk) :: fc2_y, nc2_x, nc2_y, nc2_z, fc3_x, fc3_y, nc3_y, nc3_x
    real(rk) :: nc3_z, t3, neg_n2_x, t4, n2_y, n2_z, f2_x, f2_y
    real(rk) :: neg_f1_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t1 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t1*s2
    w2_y = t1*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.2435_rk*ww1_zz
    a2_x = -9.8_rk*s2
    a2_y = -9.8_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_xx + ww3_zz
    t2 = qd(3) + w3_z
    neg_lam3_31 = c3*alpha2_y - s3*alpha2_x - w3_x*t2
    lam3_32 = w3_y*t2 - (-c3*alpha2_x - s3*alpha2_y)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (0.8636_rk*alpha2_y - 0.0934_rk*neg_lam2_33)
    neg_a3_x = c3*(0.4318_rk*neg_lam2_11 - a2_x) + s3*(-0.4318_rk*ww2_xy - a2_y)
    ! link 2: force that moves the link [N]
    fc2_x = -0.88944_rk*neg_lam2_11
    fc2_y = 0.88944_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 4.8563_rk*alpha2_x + 0.193584576_rk*ww2_xy
    nc2_y = 7.754747104_rk*alpha2_y + 0.193584576_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.21657864_rk*ww1_zz
    nc2_z = 1.449223552_rk*ww2_xy - 8.716512_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -0.336_rk*ww3_xy
    fc3_y = 0.336_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_y = 0.44345_rk*neg_lam3_31
    nc3_x = 0.51957_rk*lam3_32 - 0.336_rk*a3_z
    nc3_z = -0.336_rk*neg_a3_x - 0.07612_rk*ww3_xy
    t3 = s3*fc3_x + c3*fc3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = s3*nc3_y - c3*nc3_x - (nc2_x + 0.0934_rk*t3)
    t4 = c3*fc3_x - s3*fc3_y
    n2_y = nc2_y - (0.0934_rk*t4 - 0.1450848_rk*lam3_32) - (-s3*nc3_x - c3*nc3_y)
    n2_z = nc3_z + (nc2_z + 0.4318_rk*t3)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + t4
    f2_y = fc2_y + t3
    ! link 1: force through the joint [N]
    neg_f1_x = s2*f2_y - c2*f2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + 0.2435_rk*neg_f1_x
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 24 multiplications, 20 additions = 44; 1 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d3_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, c3, s3, fu2_x, fu2_y, nu2_x, nu2_y
    real(rk) :: nu2_z, t1, fu1_x, t2, nu1_z, k2_xy, h2_x, t3
    real(rk) :: k2_yy, k2_xz, t4, m2_2, fu1_x_2, nu1_z_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = 0.336_rk*c3
    fu2_y = 0.336_rk*s3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = 0.0313824_rk*s3
    nu2_y = -0.0313824_rk*c3
    nu2_z = 0.1450848_rk*s3 + 0.96302_rk
    t1 = c2*fu2_x
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = t1 - s2*fu2_y
    t2 = c2*nu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -0.2435_rk*fu1_x - (s2*nu2_x + t2)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xy = -0.1450848_rk*c3 - 0.07612_rk*(c3*s3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y + 0.88944_rk
    t3 = 0.07612_rk*(c3*c3)
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t3 + 2.8716_rk
    k2_xz = -nu2_x - 0.193584576_rk
    t4 = t3 - 0.51957_rk - 0.2901696_rk*s3
    ! link 2: mass matrix, its row of this joint
    m2_2 = t3 - t4 + 6.748973552_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = t1 - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*k2_xz - t2 - 0.2435_rk*fu1_x_2
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_yy - (c2*c2*(t3 + t4 - 1.005773552_rk) + k2_xy*(2.0_rk*(c2*s2))) - 0.093270802_rk
    M(1) = m1_1
    M(2) = nu1_z_2
    M(3) = nu1_z
    M(4) = nu1_z_2
    M(5) = m2_2
    M(6) = nu2_z
    M(7) = nu1_z
    M(8) = nu2_z
    M(9) = 0.96302_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 104 multiplications, 72 additions, 3 divisions = 179; 5 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_d3_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, c3, s3, fu2_x, fu2_y, nu2_x, nu2_y
    real(rk) :: nu2_z, t1, fu1_x, t2, nu1_z, k2_xy, h2_x, t3
    real(rk) :: k2_yy, k2_xz, t4, m2_2, fu1_x_2, nu1_z_2, m1_1, ww1_zz
    real(rk) :: t5, w2_x, w2_y, alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy
    real(rk) :: ww2_zz, neg_lam2_11, neg_lam2_33, a2_z, a2_x, a2_y, w3_x, w3_y
    real(rk) :: w3_z, ww3_xy, ww3_xx, ww3_zz, neg_lam3_22, t6, neg_lam3_31, lam3_32
    real(rk) :: a3_z, neg_a3_x, fc2_x, fc2_y, nc2_x, nc2_y, nc2_z, fc3_x
    real(rk) :: fc3_y, nc3_y, nc3_x, nc3_z, t7, neg_n2_x, t8, n2_y
    real(rk) :: n2_z, f2_x, f2_y, neg_f1_x, n1_z, y1, ipivot1, l2_1
    real(rk) :: l3_1, pivot2, ipivot2, ld3_2, l3_2, pivot3, ipivot3, y2
    real(rk) :: y3, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    c3 = cos(q(3))
    s3 = sin(q(3))
    ! link 2: force for a unit acceleration of a joint further out
    fu2_x = 0.336_rk*c3
    fu2_y = 0.336_rk*s3
    ! link 2: moment for a unit acceleration of a joint further out
    nu2_x = 0.0313824_rk*s3
    nu2_y = -0.0313824_rk*c3
    nu2_z = 0.1450848_rk*s3 + 0.96302_rk
    t1 = c2*fu2_x
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x = t1 - s2*fu2_y
    t2 = c2*nu2_y
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z = -0.2435_rk*fu1_x - (s2*nu2_x + t2)
    ! link 2: second moment of the composite body [kg m^2]
    k2_xy = -0.1450848_rk*c3 - 0.07612_rk*(c3*s3)
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_x = fu2_y + 0.88944_rk
    t3 = 0.07612_rk*(c3*c3)
    ! link 2: second moment of the composite body [kg m^2]
    k2_yy = t3 + 2.8716_rk
    k2_xz = -nu2_x - 0.193584576_rk
    t4 = t3 - 0.51957_rk - 0.2901696_rk*s3
    ! link 2: mass matrix, its row of this joint
    m2_2 = t3 - t4 + 6.748973552_rk
    ! link 1: force for a unit acceleration of a joint further out
    fu1_x_2 = t1 - s2*h2_x
    ! link 1: moment for a unit acceleration of a joint further out
    nu1_z_2 = s2*k2_xz - t2 - 0.2435_rk*fu1_x_2
    ! link 1: mass matrix, its row of this joint
    m1_1 = k2_yy - (c2*c2*(t3 + t4 - 1.005773552_rk) + k2_xy*(2.0_rk*(c2*s2))) - 0.093270802_rk
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    t5 = -qd(1)
    ! link 2: angular velocity [rad/s]
    w2_x = t5*s2
    w2_y = t5*c2
    ! link 2: angular acceleration [rad/s^2]
    alpha2_x = qd(2)*w2_y
    alpha2_y = -qd(2)*w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = w2_x*w2_y
    ww2_xx = w2_x*w2_x
    ww2_yy = w2_y*w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.2435_rk*ww1_zz
    a2_x = -9.8_rk*s2
    a2_y = -9.8_rk*c2
    ! link 3: angular velocity [rad/s]
    w3_x = c3*w2_x + s3*w2_y
    w3_y = c3*w2_y - s3*w2_x
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = w3_x*w3_y
    ww3_xx = w3_x*w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_xx + ww3_zz
    t6 = qd(3) + w3_z
    neg_lam3_31 = c3*alpha2_y - s3*alpha2_x - w3_x*t6
    lam3_32 = w3_y*t6 - (-c3*alpha2_x - s3*alpha2_y)
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - (0.8636_rk*alpha2_y - 0.0934_rk*neg_lam2_33)
    neg_a3_x = c3*(0.4318_rk*neg_lam2_11 - a2_x) + s3*(-0.4318_rk*ww2_xy - a2_y)
    ! link 2: force that moves the link [N]
    fc2_x = -0.88944_rk*neg_lam2_11
    fc2_y = 0.88944_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    nc2_x = 4.8563_rk*alpha2_x + 0.193584576_rk*ww2_xy
    nc2_y = 7.754747104_rk*alpha2_y + 0.193584576_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.21657864_rk*ww1_zz
    nc2_z = 1.449223552_rk*ww2_xy - 8.716512_rk*c2
    ! link 3: force that moves the link [N]
    fc3_x = -0.336_rk*ww3_xy
    fc3_y = 0.336_rk*neg_lam3_22
    ! link 3: moment that turns the link [N m]
    nc3_y = 0.44345_rk*neg_lam3_31
    nc3_x = 0.51957_rk*lam3_32 - 0.336_rk*a3_z
    nc3_z = -0.336_rk*neg_a3_x - 0.07612_rk*ww3_xy
    t7 = s3*fc3_x + c3*fc3_y
    ! link 2: moment through the joint, about the frame's origin [N m]
    neg_n2_x = s3*nc3_y - c3*nc3_x - (nc2_x + 0.0934_rk*t7)
    t8 = c3*fc3_x - s3*fc3_y
    n2_y = nc2_y - (0.0934_rk*t8 - 0.1450848_rk*lam3_32) - (-s3*nc3_x - c3*nc3_y)
    n2_z = nc3_z + (nc2_z + 0.4318_rk*t7)
    ! link 2: force through the joint [N]
    f2_x = fc2_x + t8
    f2_y = fc2_y + t7
    ! link 1: force through the joint [N]
    neg_f1_x = s2*f2_y - c2*f2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = s2*neg_n2_x - c2*n2_y + 0.2435_rk*neg_f1_x
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    ipivot1 = 1.0_rk / m1_1
    l2_1 = nu1_z_2*ipivot1
    l3_1 = nu1_z*ipivot1
    pivot2 = m2_2 - nu1_z_2*l2_1
    ipivot2 = 1.0_rk / pivot2
    ld3_2 = nu2_z - nu1_z_2*l3_1
    l3_2 = ipivot2*ld3_2
    pivot3 = 0.96302_rk - nu1_z*l3_1 - ld3_2*l3_2
    ipivot3 = 1.0_rk / pivot3
    ! link 2: forward substitution
    y2 = tau(2) - n2_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) - nc3_z - y1*l3_1 - l3_2*y2
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
