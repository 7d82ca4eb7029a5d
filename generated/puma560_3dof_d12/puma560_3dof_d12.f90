! puma560_3dof_d12: PUMA 560, first three joints, the set of the thesis's program D.1.2
! Numbers: the 1990 thesis, program D.1.2 (Newton-Euler), payload 0
! Origin of numbers: geometry, inertia; mass, centre of mass (joints 2, 3): stated by the
!     description
! Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 16c8c8cbba57926adbdacd5fb2c4cd18 (a hash of its numbers)
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
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 5.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 38 multiplications, 26 additions = 64; 0 unary minus; 4 sine/cosine
!   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
!   bias: 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
!   mass_matrix: 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
!   forward_dynamics: 49 multiplications, 34 additions, 2 divisions = 85; 2 unary minus; 4
!       sine/cosine
module puma560_3dof_d12_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_d12_inverse_dynamics
  public :: puma560_3dof_d12_gravity
  public :: puma560_3dof_d12_bias
  public :: puma560_3dof_d12_mass_matrix
  public :: puma560_3dof_d12_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 38 multiplications, 26 additions = 64; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d12_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d12_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, w3_z, alpha3_z, neg_lam2_33, ww2_zz, ww3_zz, t1, t2, t3
    real(rk) :: t4, t5, t6, t7, t8, t9, n1_z, nc3_z, t10, n02_z

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
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = s2*qdd(2) + c2*ww2_zz
    t2 = c2 + 1.1278396957793986_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = 1.602487602_rk*c2
    t7 = t5 + t6
    t8 = 0.104010539_rk*qdd(1)
    t9 = alpha3_z*t3 - t5*ww3_zz
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*t1 + 2.0_rk*(qd(1)*(t2*t4 - t7*(s2*qd(2)))) + &
        (t8*(1.558875134188362_rk*(t2*t2 + 3.459309734072025_rk*(t6*t6)) + 26.952958204552715_rk) &
        - 0.3476146364057434_rk*t9)
    ! link 3: moment that turns the link [N m]
    nc3_z = t5*(c2*qdd(2) - 22.69569245020843_rk - s2*ww2_zz) + (1.071645_rk*alpha3_z - &
        t3*(neg_lam2_33*t2 + (t1 + 0.3476146364057434_rk*qdd(1))))
    t10 = c2*(alpha3_z*t5 + (w3_z*t4 - 14.006062_rk)) + (s2*(neg_lam2_33*t7 + (t8 - t9)) + nc3_z)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = 6.457487602_rk*qdd(2) + t10
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
  pure subroutine puma560_3dof_d12_gravity(q, tau) &
      bind(c, name="puma560_3dof_d12_gravity_f")
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
  pure subroutine puma560_3dof_d12_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d12_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, w3_z, lam2_33, ww2_zz, ww3_zz, t1, t2, t3, t4, t5, t6
    real(rk) :: t7, n1_z, nc3_z, n02_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = c2*ww2_zz
    t2 = c2 + 1.1278396957793986_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = t5 + 1.602487602_rk*c2
    t7 = t5*ww3_zz
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*t1 + 2.0_rk*(qd(1)*(t2*t4 - t6*(s2*qd(2)))) + 0.3476146364057434_rk*t7
    ! link 3: moment that turns the link [N m]
    nc3_z = t3*(lam2_33*t2 - t1) - t5*(s2*ww2_zz + 22.69569245020843_rk)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = c2*(w3_z*t4 - 14.006062_rk) + (s2*(t7 - lam2_33*t6) + nc3_z)
    tau(1) = n1_z
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d12_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d12_mass_matrix_f")
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
    m1_1 = 1.602487602_rk*(c2*(c2 + 0.22822928523349661_rk*s23)) + 3.0096367105_rk + &
        m1_3*(3.2445115298970304_rk*c23)
    m1_2 = m1_3 + 0.104010539_rk*s2
    t1 = 0.1828673_rk*(s2*c23 - c2*s23)
    ! link 2: mass matrix, its row of this joint
    m2_2 = 7.529132602_rk - t1 - t1
    m2_3 = 1.071645_rk - t1
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = m2_3
    M(7) = m1_3
    M(8) = m2_3
    M(9) = 1.071645_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 49 multiplications, 34 additions, 2 divisions = 85; 2 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_d12_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_d12_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, angle23, c23, s23, w3_z, lam2_33, ww2_zz, ww3_zz, t1, t2, t3, t4, t5, t6
    real(rk) :: t7, t8, n1_z, neg_nc3_z, n02_z, m1_2, t9, m2_2, m2_3, y3, u2_3, u1_3, pivot2
    real(rk) :: ipivot2, ud1_2, u1_2, pivot1, ipivot1, neg_y2, y1, qdd1, qdd2, qdd3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = c2*ww2_zz
    t2 = c2 + 1.1278396957793986_rk*s23
    t3 = 0.1828673_rk*c23
    t4 = w3_z*t3
    t5 = 0.1828673_rk*s23
    t6 = 1.602487602_rk*c2
    t7 = t5 + t6
    t8 = ww3_zz*t5
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.104010539_rk*(t1 + 19.228820648646_rk*(qd(1)*(t2*t4 - t7*(s2*qd(2)))) + &
        3.342109749145165_rk*t8)
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = t3*(t1 - lam2_33*t2) + t5*(s2*ww2_zz + 22.69569245020843_rk)
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = c2*(w3_z*t4 - 14.006062_rk) + (s2*(t8 - lam2_33*t7) - neg_nc3_z)
    ! link 1: mass matrix, its row of this joint
    m1_2 = 0.104010539_rk*(s2 - 0.6111625861298536_rk*c23)
    t9 = 0.1828673_rk*(s2*c23 - c2*s23)
    ! link 2: mass matrix, its row of this joint
    m2_2 = 7.529132602_rk - t9 - t9
    m2_3 = 1.071645_rk - t9
    ! link 3: forward substitution
    y3 = neg_nc3_z + tau(3)
    ! factorisation M = U D U^T
    u2_3 = 0.933144838076042_rk*m2_3
    u1_3 = -0.059317544522673085_rk*c23
    pivot2 = m2_2 - m2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 - m2_3*u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = c2*(t6 + 0.3657346_rk*s23) + 3.0096367105_rk - ud1_2*u1_2 - &
        0.21001565911381334_rk*(c23*c23)
    ipivot1 = 1.0_rk / pivot1
    ! link 2: forward substitution
    neg_y2 = n02_z - tau(2) + y3*u2_3
    ! link 1: forward substitution
    y1 = u1_2*neg_y2 - (n1_z - tau(1) + y3*u1_3)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = -u1_2*qdd1 - ipivot2*neg_y2
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = 0.933144838076042_rk*y3 - u2_3*qdd2 - u1_3*qdd1
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
