! stanford_3dof: Stanford arm, first three joints
! Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; first three links, Izz of link 3
!   assumed
! Origin of numbers: geometry, mass, centre of mass, inertia, rotor inertia: stated by the
!     description
! Origin of numbers: friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: eb451b6920f3abb15f88e11742e4d38d (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute   alpha 0      a 0  d 0       theta q
!   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
!   3  prismatic  alpha pi/2   a 0  d q       theta 0
! Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
! Arguments, in SI units, joint 1 first:
!   q    joint positions [rad, prismatic m]
!   qd   joint velocities [rad/s, prismatic m/s]
!   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
!   tau  joint torques [N m, prismatic N]
!   M    mass matrix, row by row [kg m^2, kg m, kg]
! Torques are the motors', reflected to the joints; what lies between is in them.
! Effects in this model:
!   rotor inertia: joint 1 0.953 kg m^2, joint 2 2.193 kg m^2, joint 3 0.782 kg
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 5.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 30 multiplications, 17 additions = 47; 0 unary minus; 2 sine/cosine
!   gravity: 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
!   bias: 21 multiplications, 9 additions = 30; 0 unary minus; 2 sine/cosine
!   mass_matrix: 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
!   forward_dynamics: 39 multiplications, 23 additions, 2 divisions = 64; 0 unary minus; 2
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
  ! with rotor inertia
  ! 30 multiplications, 17 additions = 47; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_3dof_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, neg_w2_x, ww2_zz, t1, t2, t3, t4, t5, t6, t7, t8, t9, tau1, a2_x, tau2
    real(rk) :: ww2_xx, neg_lam2_22, tau3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = 2.0_rk*qd(2)
    t2 = q(3) + 0.6447_rk
    t3 = 4.25_rk*t2
    t4 = t2*t3 + 2.512_rk
    t5 = c2*(neg_w2_x*t4)
    t6 = t2*qdd(2) + t1*qd(3)
    t7 = 0.015551020408163266_rk*qdd(1)
    t8 = s2*t7
    t9 = c2*t6 - s2*(t4*(99.28124431412262_rk*t8) + t2*(ww2_zz + &
        neg_w2_x*(13.123359580052494_rk*qd(3))) - qdd(3))
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t1*t5 + 0.6477_rk*(2.3928713486181876_rk*qdd(1) - t9)
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*(s2 + c2*t7)
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = 4.721_rk*qdd(2) + t3*(t6 + a2_x) - qd(1)*t5
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = neg_w2_x*neg_w2_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 5.032_rk*qdd(3) + (41.65_rk*(c2 - t8) - t3*neg_lam2_22)
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
  end subroutine

  ! torques that hold the arm at rest
  ! 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_gravity(q, tau) &
      bind(c, name="stanford_3dof_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, fc3_z, s2, n2_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 3: force that moves the link [N]
    fc3_z = 41.65_rk*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = -41.65_rk*(s2*(q(3) + 0.6447_rk))
    tau(1) = 0.0_rk
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 21 multiplications, 9 additions = 30; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_bias(q, qd, tau) &
      bind(c, name="stanford_3dof_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, neg_w2_x, ww2_zz, t1, t2, t3, t4, t5, tau1, a2_x, tau2, ww2_xx, neg_lam2_22
    real(rk) :: tau3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = 2.0_rk*qd(2)
    t2 = q(3) + 0.6447_rk
    t3 = 4.25_rk*t2
    t4 = c2*(neg_w2_x*(t2*t3 + 2.512_rk))
    t5 = t1*qd(3)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t1*t4 - 0.6477_rk*(c2*t5 - s2*(t2*(ww2_zz + neg_w2_x*(13.123359580052494_rk*qd(3)))))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = t3*(t5 + a2_x) - qd(1)*t4
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = neg_w2_x*neg_w2_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 41.65_rk*c2 - t3*neg_lam2_22
    tau(1) = tau1
    tau(2) = tau2
    tau(3) = tau3
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_mass_matrix(q, M) &
      bind(c, name="stanford_3dof_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, m1_3, t1, t2, m1_1, m1_2, m2_2

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.6477_rk*s2
    t1 = q(3) + 1.2894_rk
    t2 = 4.25_rk*(q(3)*t1)
    m1_1 = (t2 + 4.2784618825_rk)*(s2*s2) + 1.5498627725_rk
    m1_2 = -0.32385_rk*(c2*(q(3) + t1))
    ! link 2: mass matrix, its row of this joint
    m2_2 = t2 + 6.4874618825_rk
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
  ! with rotor inertia
  ! 39 multiplications, 23 additions, 2 divisions = 64; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_3dof_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, neg_w2_x, ww2_zz, t1, t2, t3, t4, t5, tau1, a2_x, tau2, ww2_xx, neg_lam2_22
    real(rk) :: tau3, neg_m1_3, t6, t7, m1_1, neg_m1_2, m2_2, y2, neg_y3, neg_u1_3, ipivot2
    real(rk) :: neg_u1_2, pivot1, ipivot1, y1, qdd1, qdd2, qdd3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! link 2: products of the angular velocity [1/s^2]
    ww2_zz = qd(2)*qd(2)
    t1 = 2.0_rk*qd(2)
    t2 = q(3) + 0.6447_rk
    t3 = 4.25_rk*t2
    t4 = c2*(neg_w2_x*(t2*t3 + 2.512_rk))
    t5 = t1*qd(3)
    ! link 1: joint torque [N m], at a prismatic joint force [N]
    tau1 = t1*t4 - 0.6477_rk*(c2*t5 - s2*(t2*(ww2_zz + neg_w2_x*(13.123359580052494_rk*qd(3)))))
    ! link 2: acceleration of the frame's origin, gravity taken off [m/s^2]
    a2_x = -9.8_rk*s2
    ! link 2: joint torque [N m], at a prismatic joint force [N]
    tau2 = t3*(t5 + a2_x) - qd(1)*t4
    ! link 2: products of the angular velocity [1/s^2]
    ww2_xx = neg_w2_x*neg_w2_x
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_22 = ww2_zz + ww2_xx
    ! link 3: joint torque [N m], at a prismatic joint force [N]
    tau3 = 41.65_rk*c2 - t3*neg_lam2_22
    ! link 1: mass matrix, its row of this joint
    neg_m1_3 = 0.6477_rk*s2
    t6 = q(3) + 1.2894_rk
    t7 = 4.25_rk*(q(3)*t6)
    m1_1 = (t7 + 4.2784618825_rk)*(s2*s2) + 1.5498627725_rk
    neg_m1_2 = 0.32385_rk*(c2*(q(3) + t6))
    ! link 2: mass matrix, its row of this joint
    m2_2 = t7 + 6.4874618825_rk
    ! link 2: forward substitution
    y2 = tau(2) - tau2
    ! link 3: forward substitution
    neg_y3 = tau3 - tau(3)
    ! factorisation M = U D U^T
    neg_u1_3 = 0.1287162162162162_rk*s2
    ipivot2 = 1.0_rk / m2_2
    neg_u1_2 = neg_m1_2*ipivot2
    pivot1 = m1_1 - neg_m1_3*neg_u1_3 - neg_m1_2*neg_u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 1: forward substitution
    y1 = y2*neg_u1_2 - (tau1 - tau(1) + neg_y3*neg_u1_3)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = y2*ipivot2 + neg_u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_u1_3*qdd1 - 0.1987281399046105_rk*neg_y3
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
