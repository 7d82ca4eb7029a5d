! puma560_3dof_d11: PUMA 560, first three joints, the set of the thesis's program D.1.1
! Numbers: the 1990 thesis, program D.1.1 (Lagrange); pseudo-inertias as tensors about the centres
!   of mass
! Origin of numbers: geometry, inertia; mass, centre of mass (joints 2, 3): stated by the
!     description
! Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: e4acb3fa395de91cc0422790bfa2c096 (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0       d 0        theta q
!   2  revolute  alpha -pi/2  a 0       d 0.2435   theta q
!   3  revolute  alpha 0      a 0.4318  d -0.0934  theta q
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
! Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
!   parameters, equal to the recursion without being written like it: robodyn --optimize full,
!   seed 0.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 36 multiplications, 26 additions = 62; 0 unary minus; 4 sine/cosine
!   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
!   bias: 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
!   mass_matrix: 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
!   forward_dynamics: 49 multiplications, 34 additions, 2 divisions = 85; 0 unary minus; 4
!       sine/cosine
module puma560_3dof_d11_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_d11_inverse_dynamics
  public :: puma560_3dof_d11_gravity
  public :: puma560_3dof_d11_bias
  public :: puma560_3dof_d11_mass_matrix
  public :: puma560_3dof_d11_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 36 multiplications, 26 additions = 62; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d11_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, w3_z, alpha3_z, ww3_zz, t1, t2, t3, t4, t5, t6
    real(rk) :: t7, t8, t9, n1_z, neg_lam2_33, nc3_z, t10, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = s2*qdd(2) + c2*ww2_zz
    t2 = c2 + 0.1618660088490397_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = t5 + 1.792430002_rk*c2
    t7 = s2*t6
    t8 = alpha3_z*t3 - ww3_zz*t5
    t9 = 0.3476146364057434_rk*(5.753497668221186_rk*((t2*t4 - qd(2)*t7)*qd(1)) - t8) + (t2*t5 + &
        (c2*t6 + 1.6022917105_rk))*qdd(1)
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*t1 + t9
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: moment that turns the link [N m]
    nc3_z = 0.0374_rk*alpha3_z + t5*(c2*qdd(2) - (s2*ww2_zz + 22.69569245020843_rk)) - t3*(t1 + &
        (0.3476146364057434_rk*qdd(1) + t2*neg_lam2_33))
    t10 = nc3_z - (s2*(t8 - 0.104010539_rk*qdd(1)) - c2*(w3_z*t4 + (alpha3_z*t5 - 14.006062_rk)))
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = 1.860430002_rk*qdd(2) + t7*neg_lam2_33 + t10
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
  pure subroutine puma560_3dof_d11_gravity(q, tau) &
      bind(c, name="puma560_3dof_d11_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: angle23, s23, nc3_z, c2, neg_nc2_z, n02_z

    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: moment that turns the link [N m]
    nc3_z = -4.1503_rk*s23
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 2: moment that turns the link [N m]
    neg_nc2_z = 14.006062_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z - neg_nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d11_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, w3_z, ww3_zz, t1, t2, t3, t4, t5, t6, t7, n1_z
    real(rk) :: lam2_33, nc3_z, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = c2*ww2_zz
    t2 = c2 + 0.1618660088490397_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = s2*(t5 + 1.792430002_rk*c2)
    t7 = ww3_zz*t5
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*t1 + 0.3476146364057434_rk*(5.753497668221186_rk*((t2*t4 - &
        qd(2)*t6)*qd(1)) + t7)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 3: moment that turns the link [N m]
    nc3_z = t3*(t2*lam2_33 - t1) - t5*(s2*ww2_zz + 22.69569245020843_rk)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z + (s2*t7 + c2*(w3_z*t4 - 14.006062_rk)) - t6*lam2_33
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d11_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, angle23, c23, s23, m1_3, m1_1, m1_2, t1, m2_2, m2_3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.06356735_rk*c23
    m1_1 = 1.792430002_rk*(c2*(c2 + 0.20404400706968304_rk*s23)) + 1.6318917105_rk + &
        m1_3*(0.46564785223860994_rk*c23)
    m1_2 = m1_3 + 0.104010539_rk*s2
    t1 = 0.1828673_rk*(s2*c23 - c2*s23)
    ! link 2: mass matrix, its row of this joint
    m2_2 = 1.897830002_rk - t1 - t1
    m2_3 = 0.0374_rk - t1
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = m2_3
    M(7) = m1_3
    M(8) = m2_3
    M(9) = 0.0374_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 49 multiplications, 34 additions, 2 divisions = 85; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d11_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_d11_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, w3_z, ww3_zz, t1, t2, t3, t4, t5, t6, t7, t8
    real(rk) :: n1_z, neg_lam2_33, neg_nc3_z, n02_z, m1_2, t9, neg_m2_2, neg_m2_3, y3, neg_u2_3
    real(rk) :: neg_u1_3, neg_pivot2, neg_ipivot2, ud1_2, neg_u1_2, pivot1, ipivot1, y2, y1, qdd1
    real(rk) :: qdd2, qdd3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = c2*ww2_zz
    t2 = c2 + 0.1618660088490397_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = 1.792430002_rk*c2
    t7 = s2*(t5 + t6)
    t8 = ww3_zz*t5
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*(t1 + 19.228820648646_rk*((t2*t4 - qd(2)*t7)*qd(1) + &
        0.1738073182028717_rk*t8))
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = t3*(t1 + t2*neg_lam2_33) + t5*(s2*ww2_zz + 22.69569245020843_rk)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = t7*neg_lam2_33 - (neg_nc3_z - (s2*t8 + c2*(w3_z*t4 - 14.006062_rk)))
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.104010539_rk*(s2 - 0.6111625861298536_rk*c23)
    t9 = 0.1828673_rk*(s2*c23 - c2*s23)
    ! link 2: mass matrix, its row of this joint
    neg_m2_2 = t9 + (t9 - 1.897830002_rk)
    neg_m2_3 = t9 - 0.0374_rk
    ! link 3: forward substitution
    y3 = neg_nc3_z + tau(3)
    ! factorisation M = U D U^T
    neg_u2_3 = 26.737967914438503_rk*neg_m2_3
    neg_u1_3 = 1.6996617647058823_rk*c23
    neg_pivot2 = neg_m2_2 + neg_m2_3*neg_u2_3
    neg_ipivot2 = 1.0_rk / neg_pivot2
    ud1_2 = m1_2 - neg_m2_3*neg_u1_3
    neg_u1_2 = neg_ipivot2*ud1_2
    pivot1 = ud1_2*neg_u1_2 + (c2*(t6 + 0.3657346_rk*s23) + 1.6318917105_rk) - &
        0.13764299427867646_rk*(c23*c23)
    ipivot1 = 1.0_rk / pivot1
    ! link 2: forward substitution
    y2 = tau(2) - n02_z + y3*neg_u2_3
    ! link 1: forward substitution
    y1 = neg_u1_2*y2 - (n1_z - tau(1) - y3*neg_u1_3)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = neg_u1_2*qdd1 - neg_ipivot2*y2
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_u1_3*qdd1 - (-26.737967914438503_rk*y3 - neg_u2_3*qdd2)
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
