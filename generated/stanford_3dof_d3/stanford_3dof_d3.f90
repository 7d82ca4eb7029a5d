! stanford_3dof_d3: Stanford arm, first three joints, the set of the thesis's listing D.3.1
! Numbers: the 1990 thesis, listing D.3.1 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
!   tables
! Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
! Origin of numbers: rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: bcd66090e2e722726ca6b04337b104f9 (a hash of its numbers)
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
! Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
!   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
!   makes no difference is moved to its parent.
! Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
!   to the recursion without being written like it: robodyn --optimize full, seed 5.
! Of mass_matrix the best program known for these parameters, equal to the recursion without being
!   written like it: robodyn --optimize full, seed 1.
!
! Operations (every binary * is a multiplication, every binary + or - an addition):
!   inverse_dynamics: 30 multiplications, 16 additions = 46; 0 unary minus; 2 sine/cosine
!   gravity: 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
!   bias: 23 multiplications, 9 additions = 32; 0 unary minus; 2 sine/cosine
!   mass_matrix: 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
!   forward_dynamics: 41 multiplications, 23 additions, 2 divisions = 66; 0 unary minus; 2
!       sine/cosine
module stanford_3dof_d3_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: stanford_3dof_d3_inverse_dynamics
  public :: stanford_3dof_d3_gravity
  public :: stanford_3dof_d3_bias
  public :: stanford_3dof_d3_mass_matrix
  public :: stanford_3dof_d3_forward_dynamics

contains

  ! torques that give the accelerations qdd
  ! 30 multiplications, 16 additions = 46; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_d3_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="stanford_3dof_d3_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, neg_w2_x, lam2_23, t1, t2, t3, t4, t5, t6, t7, t8, n1_z, neg_lam2_13, n2_z
    real(rk) :: fc3_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    lam2_23 = s2*qdd(1)
    t1 = 6.561679790026247_rk*(q(3) - 0.6447_rk)
    t2 = t1*t1 + 16.756430559057236_rk
    t3 = c2*(t2*neg_w2_x)
    t4 = 13.123359580052494_rk*qd(3)
    t5 = t1*qdd(2) + qd(2)*t4
    t6 = 6.561679790026247_rk*qdd(3) - qd(2)*(t1*qd(2))
    t7 = t1*neg_w2_x
    t8 = 5.308500951741299_rk*qdd(1) + t3*qd(2) - 0.5_rk*(c2*t5 + s2*(t6 - (t4*t7 + t2*lam2_23)))
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.3005413344_rk*t8
    ! link 2: lambda matrix: takes a position to its acceleration [1/s^2]
    neg_lam2_13 = c2*qdd(1)
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 4.721_rk*(qdd(2) + 0.03183026206312222_rk*(t1*(t5 - (neg_lam2_13 + &
        64.30446194225722_rk*s2)) - qd(1)*t3))
    ! link 3: force that moves the link [N]
    fc3_z = 0.986028_rk*(t6 - neg_w2_x*t7 - (lam2_23 - 64.30446194225722_rk*c2))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! torques that hold the arm at rest
  ! 3 multiplications, 1 addition = 4; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_d3_gravity(q, tau) &
      bind(c, name="stanford_3dof_d3_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, fc3_z, s2, n2_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    ! link 3: force that moves the link [N]
    fc3_z = 63.406_rk*c2
    ! sines and cosines of the joint angles
    s2 = sin(q(2))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = -63.406_rk*(s2*(q(3) - 0.6447_rk))
    tau(1) = 0.0_rk
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 23 multiplications, 9 additions = 32; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_d3_bias(q, qd, tau) &
      bind(c, name="stanford_3dof_d3_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    real(rk) :: c2, s2, neg_w2_x, t1, t2, t3, t4, t5, t6, n1_z, n2_z, fc3_z

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    t1 = 6.561679790026247_rk*(q(3) - 0.6447_rk)
    t2 = c2*((t1*t1 + 16.756430559057236_rk)*neg_w2_x)
    t3 = 13.123359580052494_rk*qd(3)
    t4 = qd(2)*t3
    t5 = qd(2)*(t1*qd(2))
    t6 = t1*neg_w2_x
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.3005413344_rk*(t2*qd(2) - 0.5_rk*(c2*t4 - s2*(t5 + t3*t6)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 0.1502706672_rk*(t1*(t4 - 64.30446194225722_rk*s2) - qd(1)*t2)
    ! link 3: force that moves the link [N]
    fc3_z = 0.986028_rk*(64.30446194225722_rk*c2 - (t5 + neg_w2_x*t6))
    tau(1) = n1_z
    tau(2) = n2_z
    tau(3) = fc3_z
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 7 multiplications, 5 additions = 12; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_d3_mass_matrix(q, M) &
      bind(c, name="stanford_3dof_d3_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    real(rk) :: c2, s2, m1_3, t1, t2, m1_1, m1_2, m2_2

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 1: mass matrix, its row of this joint
    m1_3 = -0.986028_rk*s2
    t1 = q(3) - 1.2894_rk
    t2 = 6.47_rk*(q(3)*t1)
    m1_1 = (t2 + 5.2071784423_rk)*(s2*s2) + 1.5954239597_rk
    m1_2 = -0.493014_rk*(c2*(q(3) + t1))
    ! link 2: mass matrix, its row of this joint
    m2_2 = t2 + 7.4101784423_rk
    M(1) = m1_1
    M(2) = m1_2
    M(3) = m1_3
    M(4) = m1_2
    M(5) = m2_2
    M(6) = 0.0_rk
    M(7) = m1_3
    M(8) = 0.0_rk
    M(9) = 6.47_rk
  end subroutine

  ! accelerations that the torques tau give
  ! 41 multiplications, 23 additions, 2 divisions = 66; 0 unary minus; 2 sine/cosine
  pure subroutine stanford_3dof_d3_forward_dynamics(q, qd, tau, qdd) &
      bind(c, name="stanford_3dof_d3_forward_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: tau(3)
    real(rk), intent(out) :: qdd(3)
    real(rk) :: c2, s2, neg_w2_x, t1, t2, t3, t4, t5, t6, n1_z, n2_z, fc3_z, neg_m1_3, t7, t8, m1_1
    real(rk) :: neg_m1_2, m2_2, y2, neg_y3, neg_u1_3, ipivot2, neg_u1_2, pivot1, ipivot1, y1, qdd1
    real(rk) :: qdd2, qdd3

    ! sines and cosines of the joint angles
    c2 = cos(q(2))
    s2 = sin(q(2))
    ! link 2: angular velocity [rad/s]
    neg_w2_x = s2*qd(1)
    t1 = 6.561679790026247_rk*(q(3) - 0.6447_rk)
    t2 = c2*(neg_w2_x*(t1*t1 + 16.756430559057236_rk))
    t3 = 13.123359580052494_rk*qd(3)
    t4 = qd(2)*t3
    t5 = qd(2)*(t1*qd(2))
    t6 = neg_w2_x*t1
    ! link 1: moment through the joint, about the frame's origin [N m]
    n1_z = 0.3005413344_rk*(t2*qd(2) - 0.5_rk*(c2*t4 - s2*(t5 + t3*t6)))
    ! link 2: moment through the joint, about the frame's origin [N m]
    n2_z = 0.1502706672_rk*(t1*(t4 - 64.30446194225722_rk*s2) - qd(1)*t2)
    ! link 3: force that moves the link [N]
    fc3_z = 0.986028_rk*(64.30446194225722_rk*c2 - (t5 + neg_w2_x*t6))
    ! link 1: mass matrix, its row of this joint
    neg_m1_3 = 0.986028_rk*s2
    t7 = q(3) - 1.2894_rk
    t8 = 6.47_rk*(q(3)*t7)
    m1_1 = (t8 + 5.2071784423_rk)*(s2*s2) + 1.5954239597_rk
    neg_m1_2 = 0.493014_rk*(c2*(q(3) + t7))
    ! link 2: mass matrix, its row of this joint
    m2_2 = t8 + 7.4101784423_rk
    ! link 2: forward substitution
    y2 = tau(2) - n2_z
    ! link 3: forward substitution
    neg_y3 = fc3_z - tau(3)
    ! factorisation M = U D U^T
    neg_u1_3 = 0.1524_rk*s2
    ipivot2 = 1.0_rk / m2_2
    neg_u1_2 = neg_m1_2*ipivot2
    pivot1 = m1_1 - neg_m1_3*neg_u1_3 - neg_m1_2*neg_u1_2
    ipivot1 = 1.0_rk / pivot1
    ! link 1: forward substitution
    y1 = y2*neg_u1_2 - (n1_z - tau(1) + neg_y3*neg_u1_3)
    ! link 1: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd1 = ipivot1*y1
    ! link 2: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd2 = y2*ipivot2 + neg_u1_2*qdd1
    ! link 3: joint acceleration [rad/s^2], at a prismatic joint [m/s^2]
    qdd3 = neg_u1_3*qdd1 - 0.1545595054095827_rk*neg_y3
    qdd(1) = qdd1
    qdd(2) = qdd2
    qdd(3) = qdd3
  end subroutine
end module
