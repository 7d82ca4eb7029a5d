! puma560_3dof: PUMA 560, first three joints
! Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; first three links
! Origin of numbers: geometry: stated by the description
! Origin of numbers: inertia, rotor inertia; mass, centre of mass (joints 2, 3): measured on the
!     arm
! Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: a3748b578bcf07f13e7166c4520ffff7 (a hash of its numbers)
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
! Torques are the motors', reflected to the joints; what lies between is in them.
! Effects in this model:
!   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 3.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 45 multiplications, 35 additions = 80; 0 unary minus; 4 sine/cosine
!   gravity: 3 multiplications, 3 additions = 6; 0 unary minus; 3 sine/cosine
!   bias: 29 multiplications, 18 additions = 47; 1 unary minus; 4 sine/cosine
!   mass_matrix: 12 multiplications, 12 additions = 24; 0 unary minus; 4 sine/cosine
!   forward_dynamics: 55 multiplications, 42 additions, 2 divisions = 99; 2 unary minus; 4
!       sine/cosine
module puma560_3dof_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_inverse_dynamics
  public :: puma560_3dof_gravity
  public :: puma560_3dof_bias
  public :: puma560_3dof_mass_matrix
  public :: puma560_3dof_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! with rotor inertia
  ! 45 multiplications, 35 additions = 80; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, alpha3_z, w3_z, ww3_zz, t1, t2, t3, t4, t5, t6
    real(rk) :: t7, t8, t9, t10, t11, t12, tau1, neg_lam2_33, t13, t14, t15, nc3_z, t16, tau2, tau3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    ! link 3: angular acceleration [rad/s^2]
    alpha3_z = qdd(2) + qdd(3)
    ! link 3: angular velocity [rad/s]
    w3_z = qd(2) + qd(3)
    ! link 3: products of the angular velocity [1/s^2]
    ww3_zz = w3_z*w3_z
    t1 = 0.0015049505482314155_rk*c2
    t2 = t1 - 5.866434376976675e-05_rk*s2
    t3 = 0.03851_rk*s23
    t4 = 0.1450848_rk*c2
    t5 = t3 + t4
    t6 = t3 + t5
    t7 = 0.1450848_rk*s2
    t8 = 0.0041505871655958945_rk*c2
    t9 = t7*(s23 + 1668.1814005825509_rk*(t2 + t8)) + 0.0070992_rk
    t10 = t1 + t7
    t11 = (c23*(w3_z*t6) - qd(2)*t9)*qd(1) - (32.51361556999726_rk*(t7*t10) - (s23*t5 + &
        2.015870295_rk))*qdd(1)
    t12 = 4.199600674915636_rk*(t8 + t10)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 404.8626213771833_rk*(ww2_zz*t2) - (0.0551376_rk*(c23*alpha3_z - s23*ww3_zz) - (t11 + &
        (t11 + qdd(2)*t12)))
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_33 = qd(1)*qd(1)
    t13 = s23*t4 - c23*t7
    t14 = c23*t4 + s23*t7
    t15 = 0.10952_rk*alpha3_z - (ww2_zz*t14 + (3.2928_rk*s23 + c23*(0.0551376_rk*qdd(1) + &
        t6*neg_lam2_33)))
    ! link 3: moment that turns the link [N m]
    nc3_z = qdd(2)*t13 + t15
    t16 = 1.02312_rk*s2 + nc3_z + t9*neg_lam2_33 + (alpha3_z*t13 - (31.907232_rk*c2 - ww3_zz*t14))
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = qdd(1)*t12 + (6.225049952_rk*qdd(2) + t16)
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = nc3_z + 0.83_rk*qdd(3)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
  end subroutine

  ! torques that hold the arm at rest
  ! 3 multiplications, 3 additions = 6; 0 unary minus; 3 sine/cosine
  pure subroutine puma560_3dof_gravity(q, tau) &
      bind(c, name="puma560_3dof_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: angle23, s23, nc3_z, c2, s2, nc2_z, n02_z

    ! sines and cosines of the joint angles
    angle23 = q(2) + q(3)
    s23 = sin(angle23)
    ! link 3: moment that turns the link [N m]
    nc3_z = -3.2928_rk*s23
    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: moment that turns the link [N m]
    nc2_z = 1.02312_rk*s2 - 31.907232_rk*c2
    ! link 2: moment through the joint, along the axes that its turn starts from [N m]
    n02_z = nc3_z + nc2_z
    tau(1) = 0.0_rk
    tau(2) = n02_z
    tau(3) = nc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 29 multiplications, 18 additions = 47; 1 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, w3_z, ww3_zz, t1, t2, t3, t4, t5, t6, t7, tau1
    real(rk) :: lam2_33, t8, nc3_z, tau2

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
    t1 = 0.03851_rk*s23
    t2 = 0.1450848_rk*c2
    t3 = t1 + (t2 + t1)
    t4 = 0.1450848_rk*s2
    t5 = c2 - 0.03898091125898309_rk*s2
    t6 = t4*(s23 + 6.9239323111437185_rk*(c2 + 0.36258738539595314_rk*t5)) + 0.0070992_rk
    t7 = s23*ww3_zz + 36.272888192449436_rk*((c23*(w3_z*t3) - qd(2)*t6)*qd(1)) + &
        11.050503177505005_rk*(ww2_zz*t5)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 0.0551376_rk*t7
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    t8 = c23*t2 + s23*t4
    ! link 3: moment that turns the link [N m]
    nc3_z = c23*(t3*lam2_33) - 3.2928_rk*s23 - ww2_zz*t8
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = ww3_zz*t8 - 31.907232_rk*c2 - (t6*lam2_33 - (nc3_z + 1.02312_rk*s2))
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = nc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 12 multiplications, 12 additions = 24; 0 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, angle23, c23, s23, m1_3, t1, t2, t3, t4, m1_1, m1_2, m2_3, m2_2

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    angle23 = q(2) + q(3)
    c23 = cos(angle23)
    s23 = sin(angle23)
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.0551376_rk*c23
    t1 = 0.1450848_rk*c2
    t2 = s23*t1
    t3 = t2 + 0.10952_rk
    t4 = 0.09786276715410573_rk*s2
    m1_1 = t3 + (t1*(9.434462824499878_rk*c2 - t4) + (t2 + 2.630443438_rk + &
        1.3968689242912278_rk*(c23*m1_3)))
    m1_2 = m1_3 + (0.023751_rk*c2 + 0.609298224_rk*s2)
    ! link 2: mass matrix, its row of this joint
    m2_3 = t3 - t4*(1.4825331862068964_rk*c23)
    m2_2 = m2_3 + (m2_3 + 6.115529952_rk)
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = m2_3
    M(7) = m1_3
    M(8) = m2_3
    M(9) = 0.93952_rk
  end subroutine

  ! accelerations that the torques tau give
  ! with rotor inertia
  ! 55 multiplications, 42 additions, 2 divisions = 99; 2 unary minus; 4 sine/cosine
  pure subroutine puma560_3dof_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="puma560_3dof_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, angle23, c23, s23, ww2_zz, w3_z, ww3_zz, t1, t2, t3, t4, t5, t6, t7, tau1
    real(rk) :: lam2_33, t8, neg_nc3_z, tau2, m1_3, t9, t10, m1_1, m1_2, m2_3, m2_2, y3, u2_3, u1_3
    real(rk) :: pivot2, ipivot2, ud1_2, u1_2, pivot1, ipivot1, neg_y2, y1, qdd1, qdd2, qdd3

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
    t1 = c2 - 0.03898091125898309_rk*s2
    t2 = 0.03851_rk*s23
    t3 = 0.1450848_rk*c2
    t4 = t2 + (t3 + t2)
    t5 = 0.1450848_rk*s2
    t6 = t5*(s23 + 2.51053051335616_rk*(t1 + 2.7579558480998414_rk*c2)) + 0.0070992_rk
    t7 = ww2_zz*t1 + 3.282464844341972_rk*((c23*(w3_z*t4) - qd(2)*t6)*qd(1) + &
        0.0275688_rk*(s23*ww3_zz))
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = 0.609298224_rk*t7
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_33 = -qd(1)*qd(1)
    t8 = c23*t3 + s23*t5
    ! link 3: moment that turns the link [N m]
    neg_nc3_z = 3.2928_rk*s23 - c23*(t4*lam2_33) + ww2_zz*t8
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = ww3_zz*t8 - 31.907232_rk*c2 + (1.02312_rk*s2 - neg_nc3_z - t6*lam2_33)
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.0551376_rk*c23
    t9 = s23*t3
    t10 = t9 + 0.10952_rk
    m1_1 = t10 + (t9 + 2.630443438_rk + 1.3968689242912278_rk*(c23*m1_3) + &
        9.434462824499878_rk*(t3*(c2 - 0.010372902938360292_rk*s2)))
    m1_2 = m1_3 + 0.023751_rk*(c2 + 25.653581912340535_rk*s2)
    ! link 2: mass matrix, its row of this joint
    m2_3 = t10 - c23*t5
    m2_2 = m2_3 + (m2_3 + 6.115529952_rk)
    ! link 3: forward substitution
    y3 = neg_nc3_z + tau(3)
    ! factorisation M = U D U^T
    u2_3 = 1.0643732970027249_rk*m2_3
    u1_3 = -0.05868698910081744_rk*c23
    pivot2 = m2_2 - m2_3*u2_3
    ipivot2 = 1.0_rk / pivot2
    ud1_2 = m1_2 - m2_3*u1_3
    u1_2 = ipivot2*ud1_2
    pivot1 = m1_1 - m1_3*u1_3 - ud1_2*u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 2: forward substitution
    neg_y2 = tau2 - tau(2) + y3*u2_3
    ! link 1: forward substitution
    y1 = u1_2*neg_y2 - (tau1 - tau(1) + y3*u1_3)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = -(ipivot2*neg_y2) - u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = 1.0643732970027249_rk*y3 - u2_3*qdd2 - u1_3*qdd1
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
