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
!   inverse_dynamics: 70 multiplications, 49 additions = 119; 0 unary minus; 4 sine/cosine
!   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
!   bias: 59 multiplications, 29 additions = 88; 0 unary minus; 4 sine/cosine
!   mass_matrix: 18 multiplications, 14 additions = 32; 0 unary minus; 4 sine/cosine
!   forward_dynamics: 91 multiplications, 55 additions, 3 divisions = 149; 1 unary minus; 4
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
  ! 70 multiplications, 49 additions = 119; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d3_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, w3_z, alpha3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y, t1
    real(rk) :: a2_y, neg_ww2_yz, neg_ww2_zx, neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy
    real(rk) :: ww2_zz, neg_lam2_11, lam2_12, lam2_21, lam2_23, neg_lam2_31, neg_lam2_32
    real(rk) :: neg_lam2_33, a3_z, neg_w3_x, neg_w3_y, t2, t3, neg_a3_x, neg_ww3_yz, neg_ww3_zx
    real(rk) :: neg_alpha3_x, neg_alpha3_y, ww3_xy, ww3_xx, ww3_zz, neg_lam3_12, lam3_21
    real(rk) :: neg_lam3_22, lam3_31, neg_lam3_32, nc1_z, neg_fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z
    real(rk) :: fc3_x, fc3_y, fc3_z, nc3_y, neg_nc3_x, nc3_z, f03_x, f03_y, n03_y, t4, neg_n02_y
    real(rk) :: n02_z, f02_x, n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1501_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    t1 = 0.1501_rk*qdd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_y = s2*t1 - 9.8_rk*c2
    ! link 2: products of the angular velocity [1/s^2]
    neg_ww2_yz = qd(2)*neg_w2_y
    neg_ww2_zx = qd(2)*neg_w2_x
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qdd(1)*s2 + neg_ww2_yz
    alpha2_y = neg_ww2_zx - qdd(1)*c2
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    lam2_12 = ww2_xy - qdd(2)
    lam2_21 = qdd(2) + ww2_xy
    lam2_23 = neg_alpha2_x - neg_ww2_yz
    neg_lam2_31 = neg_ww2_zx + alpha2_y
    neg_lam2_32 = neg_ww2_yz + neg_alpha2_x
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.4318_rk*neg_lam2_31
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t2 = 0.4318_rk*neg_lam2_11
    t3 = 0.4318_rk*lam2_21
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*(t1 + (c2*t2 + s2*t3)) + s23*(s2*t2 - c2*t3 + 9.8_rk)
    ! link 3: products of the angular velocity [1/s^2]
    neg_ww3_yz = w3_z*neg_w3_y
    neg_ww3_zx = w3_z*neg_w3_x
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = qdd(1)*s23 + neg_ww3_yz
    neg_alpha3_y = qdd(1)*c23 - neg_ww3_zx
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_12 = alpha3_z - ww3_xy
    lam3_21 = alpha3_z + ww3_xy
    neg_lam3_22 = ww3_xx + ww3_zz
    lam3_31 = neg_alpha3_y - neg_ww3_zx
    neg_lam3_32 = neg_ww3_yz + neg_alpha3_x
    ! link 1: moment that turns the link [N m]
    nc1_z = -0.093270802_rk*qdd(1)
    ! link 2: force that moves the link [N]
    neg_fc2_x = 0.88944_rk*neg_lam2_11
    fc2_y = 0.88944_rk*lam2_21
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 2.42815_rk*neg_lam2_32 - 0.11051088_rk*lam2_21
    nc2_y = 3.877373552_rk*neg_lam2_31 + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.133504944_rk*ww1_zz
    nc2_z = 3.877373552_rk*lam2_21 - 2.42815_rk*lam2_12 - 0.11051088_rk*lam2_23 + 0.88944_rk*a2_y
    ! link 3: force that moves the link [N]
    fc3_x = 0.336_rk*neg_lam3_12
    fc3_y = 0.336_rk*neg_lam3_22
    fc3_z = 0.336_rk*neg_lam3_32
    ! link 3: moment that turns the link [N m]
    nc3_y = -0.44345_rk*lam3_31
    neg_nc3_x = 0.51957_rk*neg_lam3_32 + 0.336_rk*a3_z
    nc3_z = 0.44345_rk*lam3_21 + 0.51957_rk*neg_lam3_12 - 0.336_rk*neg_a3_x
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    f03_x = c23*fc3_x - s23*fc3_y
    f03_y = s23*fc3_x + c23*fc3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = c23*nc3_y - s23*neg_nc3_x
    t4 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    neg_n02_y = s2*neg_nc2_x - c2*nc2_y + fc3_z*t4 - n03_y
    n02_z = nc3_z + (nc2_z + (f03_y*t4 - f03_x*(0.4318_rk*s2)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    f02_x = f03_x - (c2*neg_fc2_x + s2*fc2_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = neg_n02_y - (0.1501_rk*f02_x - nc1_z)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
  pure subroutine puma560_3dof_d3_gravity(q, tau) &
      bind(c, name="puma560_3dof_d3_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, angle23, s23, neg_nc2_z, nc3_z, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 8.716512_rk*c2
    ! link 3: moment that turns the link [N m]
    nc3_z = -3.2928_rk*s23
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z - neg_nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 59 multiplications, 29 additions = 88; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d3_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, w3_z, ww1_zz, a2_z, neg_w2_x, neg_w2_y, neg_alpha2_x
    real(rk) :: alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz, neg_lam2_11, neg_lam2_33, a3_z, neg_w3_x
    real(rk) :: neg_w3_y, t1, t2, neg_a3_x, neg_alpha3_x, alpha3_y, ww3_xy, ww3_xx, ww3_zz
    real(rk) :: neg_lam3_22, neg_fc2_x, fc2_y, neg_nc2_x, nc2_y, nc2_z, neg_fc3_x, fc3_y, fc3_z
    real(rk) :: nc3_y, neg_nc3_x, nc3_z, neg_f03_x, neg_f03_y, n03_y, t3, n02_y, n02_z, neg_f02_x
    real(rk) :: n1_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1501_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qd(2)*neg_w2_y
    alpha2_y = qd(2)*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.8636_rk*alpha2_y
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t1 = 0.4318_rk*neg_lam2_11
    t2 = 0.4318_rk*ww2_xy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*(c2*t1 + s2*t2) + s23*(s2*t1 - c2*t2 + 9.8_rk)
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = w3_z*neg_w3_y
    alpha3_y = w3_z*neg_w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_xx + ww3_zz
    ! link 2: force that moves the link [N]
    neg_fc2_x = 0.88944_rk*neg_lam2_11
    fc2_y = 0.88944_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 7.754747104_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.133504944_rk*ww1_zz
    nc2_z = 1.449223552_rk*ww2_xy - 8.716512_rk*c2
    ! link 3: force that moves the link [N]
    neg_fc3_x = 0.336_rk*ww3_xy
    fc3_y = 0.336_rk*neg_lam3_22
    fc3_z = 0.672_rk*neg_alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_y = 0.8869_rk*alpha3_y
    neg_nc3_x = 1.03914_rk*neg_alpha3_x + 0.336_rk*a3_z
    nc3_z = -0.336_rk*neg_a3_x - 0.07612_rk*ww3_xy
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    neg_f03_x = c23*neg_fc3_x + s23*fc3_y
    neg_f03_y = s23*neg_fc3_x - c23*fc3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = c23*nc3_y - s23*neg_nc3_x
    t3 = 0.4318_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + fc3_z*t3)
    n02_z = nc3_z + (nc2_z - (neg_f03_y*t3 - neg_f03_x*(0.4318_rk*s2)))
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = neg_f03_x + (c2*neg_fc2_x + s2*fc2_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1501_rk*neg_f02_x - n02_y
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 18 multiplications, 14 additions = 32; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d3_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, angle23, c23, s23, h3_x, h3_y, t1, k3_xx, k3_yy, t2, t3, m2_3, m1_3, t4
    real(rk) :: m2_2, neg_k2_yz, h2_y, k2_xx, m1_2, m1_1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = 0.336_rk*s23
    h3_y = -0.336_rk*c23
    t1 = 0.07612_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    k3_xx = 0.51957_rk - t1
    k3_yy = t1 + 0.44345_rk
    t2 = 0.4318_rk*c2
    t3 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_3 = t2*h3_x + t3*h3_y + 0.96302_rk
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.0504336_rk*c23
    t4 = k3_xx + t2*(0.672_rk*s23)
    ! link 2: mass matrix, its row of this joint
    m2_2 = 6.305523552_rk - (t3*(0.672_rk*c23) - k3_yy - t4)
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_yz = 0.11051088_rk*s2
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = h3_y + 0.88944_rk*s2
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = t4 + (1.449223552_rk*(c2*c2) + 2.42815_rk)
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.1501_rk*h2_y - neg_k2_yz
    m1_1 = k2_xx - 0.093270802_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = m2_3
    M(7) = m1_3
    M(8) = m2_3
    M(9) = 0.96302_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 91 multiplications, 55 additions, 3 divisions = 149; 1 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d3_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_d3_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, angle23, c23, s23, h3_x, neg_h3_y, t1, neg_k3_xx, k3_yy, t2, t3, m2_3
    real(rk) :: neg_m1_3, t4, neg_m2_2, neg_k2_yz, h2_y, k2_xx, neg_m1_2, neg_m1_1, w3_z, ww1_zz
    real(rk) :: a2_z, neg_w2_x, neg_w2_y, neg_alpha2_x, alpha2_y, ww2_xy, ww2_xx, ww2_yy, ww2_zz
    real(rk) :: neg_lam2_11, neg_lam2_33, a3_z, neg_w3_x, neg_w3_y, t5, t6, neg_a3_x, neg_alpha3_x
    real(rk) :: alpha3_y, ww3_xy, ww3_xx, ww3_zz, neg_lam3_22, neg_fc2_x, fc2_y, neg_nc2_x, nc2_y
    real(rk) :: nc2_z, neg_fc3_x, fc3_y, fc3_z, nc3_y, neg_nc3_x, neg_nc3_z, neg_f03_x, neg_f03_y
    real(rk) :: n03_y, n02_y, n02_z, neg_f02_x, n1_z, y1, neg_ipivot1, l2_1, l3_1, neg_pivot2
    real(rk) :: neg_ipivot2, ld3_2, neg_l3_2, pivot3, ipivot3, y2, y3, qdd3, qdd2, qdd1

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: first moment of the composite body, about the frame's origin [kg m]
    h3_x = 0.336_rk*s23
    neg_h3_y = 0.336_rk*c23
    t1 = 0.07612_rk*(c23*c23)
    ! link 3: second moment of the composite body [kg m^2]
    neg_k3_xx = t1 - 0.51957_rk
    k3_yy = t1 + 0.44345_rk
    t2 = 0.4318_rk*c2
    t3 = 0.4318_rk*s2
    ! link 2: mass matrix, its row of this joint
    m2_3 = t2*h3_x - t3*neg_h3_y + 0.96302_rk
    ! link 1: mass matrix, its row of this joint
    neg_m1_3 = 0.0504336_rk*c23
    t4 = neg_k3_xx - t2*(0.672_rk*s23)
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t4 - (k3_yy - t3*(0.672_rk*c23)) - 6.305523552_rk
    ! link 2: second moment of the composite body [kg m^2]
    neg_k2_yz = 0.11051088_rk*s2
    ! link 2: first moment of the composite body, about the frame's origin [kg m]
    h2_y = 0.88944_rk*s2 - neg_h3_y
    ! link 2: second moment of the composite body [kg m^2]
    k2_xx = 1.449223552_rk*(c2*c2) + 2.42815_rk - t4
    ! link 1: mass matrix, its row of this joint
    neg_m1_2 = neg_k2_yz - 0.1501_rk*h2_y
    neg_m1_1 = 0.093270802_rk - k2_xx
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 1: products of the angular velocity [1/s^2]
    ww1_zz = qd(1)*qd(1)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_z = -0.1501_rk*ww1_zz
    ! link 2: angular velocity [rad/s]
    neg_w2_x = qd(1)*s2
    neg_w2_y = qd(1)*c2
    ! link 2: angular acceleration [rad/s^2]
    neg_alpha2_x = qd(2)*neg_w2_y
    alpha2_y = qd(2)*neg_w2_x
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xy = neg_w2_x*neg_w2_y
    ww2_xx = neg_w2_x*neg_w2_x
    ww2_yy = neg_w2_y*neg_w2_y
    ww2_zz = qd(2)*qd(2)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_11 = ww2_yy + ww2_zz
    neg_lam2_33 = ww2_xx + ww2_yy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    a3_z = a2_z - 0.8636_rk*alpha2_y
    ! link 3: angular velocity [rad/s]
    neg_w3_x = qd(1)*s23
    neg_w3_y = qd(1)*c23
    t5 = 0.4318_rk*neg_lam2_11
    t6 = 0.4318_rk*ww2_xy
    ! link 3: acceleration of the frame's origin, gravity taken off [m/s^2]
    neg_a3_x = c23*(c2*t5 + s2*t6) + s23*(s2*t5 - c2*t6 + 9.8_rk)
    ! link 3: angular acceleration [rad/s^2]
    neg_alpha3_x = w3_z*neg_w3_y
    alpha3_y = w3_z*neg_w3_x
    ! link 3: products of the angular velocity [1/s^2]
    ww3_xy = neg_w3_x*neg_w3_y
    ww3_xx = neg_w3_x*neg_w3_x
    ww3_zz = w3_z*w3_z
    ! link 3: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam3_22 = ww3_xx + ww3_zz
    ! link 2: force that moves the link [N]
    neg_fc2_x = 0.88944_rk*neg_lam2_11
    fc2_y = 0.88944_rk*ww2_xy
    ! link 2: moment that turns the link [N m]
    neg_nc2_x = 4.8563_rk*neg_alpha2_x - 0.11051088_rk*ww2_xy
    nc2_y = 7.754747104_rk*alpha2_y + 0.11051088_rk*(neg_lam2_11 - neg_lam2_33) + &
        0.133504944_rk*ww1_zz
    nc2_z = 1.449223552_rk*ww2_xy - 8.716512_rk*c2
    ! link 3: force that moves the link [N]
    neg_fc3_x = 0.336_rk*ww3_xy
    fc3_y = 0.336_rk*neg_lam3_22
    fc3_z = 0.672_rk*neg_alpha3_x
    ! link 3: moment that turns the link [N m]
    nc3_y = 0.8869_rk*alpha3_y
    neg_nc3_x = 1.03914_rk*neg_alpha3_x + 0.336_rk*a3_z
    neg_nc3_z = 0.07612_rk*ww3_xy + 0.336_rk*neg_a3_x
    ! link 3: force through the joint, along the axes that its turn starts from [N]
    neg_f03_x = c23*neg_fc3_x + s23*fc3_y
    neg_f03_y = s23*neg_fc3_x - c23*fc3_y
    ! link 3: moment through the joint, along the axes that its turn starts from [N m]
    n03_y = c23*nc3_y - s23*neg_nc3_x
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_y = n03_y - (s2*neg_nc2_x - c2*nc2_y + t2*fc3_z)
    n02_z = nc2_z - (t2*neg_f03_y - t3*neg_f03_x) - neg_nc3_z
    ! link 2: force through the joint, along the axes that its turn starts from [N]
    neg_f02_x = neg_f03_x + (c2*neg_fc2_x + s2*fc2_y)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.1501_rk*neg_f02_x - n02_y
    ! link 1: forward substitution
    y1 = tau(1) - n1_z
    ! factorisation M = L D L^T
    neg_ipivot1 = 1.0_rk / neg_m1_1
    l2_1 = neg_m1_2*neg_ipivot1
    l3_1 = neg_m1_3*neg_ipivot1
    neg_pivot2 = neg_m2_2 - neg_m1_2*l2_1
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ld3_2 = m2_3 + neg_m1_2*l3_1
    neg_l3_2 = neg_ipivot2*ld3_2
    pivot3 = 0.96302_rk + neg_m1_3*l3_1 + ld3_2*neg_l3_2
    ipivot3 = 1.0_rk / pivot3
    ! link 2: forward substitution
    y2 = tau(2) - n02_z - y1*l2_1
    ! link 3: forward substitution
    y3 = tau(3) + neg_nc3_z - y1*l3_1 + neg_l3_2*y2
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = ipivot3*y3
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_l3_2*qdd3 - neg_ipivot2*y2
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = -l3_1*qdd3 - (y1*neg_ipivot1 + l2_1*qdd2)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
