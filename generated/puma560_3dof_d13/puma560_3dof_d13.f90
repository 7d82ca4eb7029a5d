! puma560_3dof_d13: PUMA 560, first three joints with the tool at the wrist, as in the thesis's
!   D.1.3
! Numbers: the 1990 thesis, program D.1.3 (inverse kinematics); no masses
! Origin of numbers: geometry: stated by the description
! Origin of numbers: mass, centre of mass, inertia, rotor inertia, friction: absent, taken as 0
! Origin of numbers: limits: absent, so without bounds
! Written by robodyn 0.1.0; do not edit, generate again.
! Description: 2cfb44495e01bcb86afbc938f4d4ee8e (a hash of its numbers)
! Options: --optimize record --scalar double --trig libm
!
! Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
!   1  revolute  alpha 0      a 0       d 0      theta q
!   2  revolute  alpha -pi/2  a 0       d 0.127  theta q
!   3  revolute  alpha 0      a 0.4318  d 0      theta q
! Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
! Tool frame in the last link: [0, 0.4318, 0] m, roll, pitch, yaw 0, 0, 0 rad
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
!   inverse_dynamics: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
!   gravity: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
!   bias: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
!   mass_matrix: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
module puma560_3dof_d13_dynamics
  use, intrinsic :: iso_c_binding, only: rk => c_double
  implicit none
  private

  public :: puma560_3dof_d13_inverse_dynamics
  public :: puma560_3dof_d13_gravity
  public :: puma560_3dof_d13_bias
  public :: puma560_3dof_d13_mass_matrix

contains

  ! torques that give the accelerations qdd
  ! 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
  pure subroutine puma560_3dof_d13_inverse_dynamics(q, qd, qdd, tau) &
      bind(c, name="puma560_3dof_d13_inverse_dynamics_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(in) :: qdd(3)
    real(rk), intent(out) :: tau(3)
    associate (unused1 => q, unused2 => qd, unused3 => qdd)
    end associate

    tau(1) = 0.0_rk
    tau(2) = 0.0_rk
    tau(3) = 0.0_rk
  end subroutine

  ! torques that hold the arm at rest
  ! 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
  pure subroutine puma560_3dof_d13_gravity(q, tau) &
      bind(c, name="puma560_3dof_d13_gravity_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: tau(3)
    associate (unused1 => q)
    end associate

    tau(1) = 0.0_rk
    tau(2) = 0.0_rk
    tau(3) = 0.0_rk
  end subroutine

  ! torques at zero acceleration: Coriolis, centrifugal, gravity, friction
  ! 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
  pure subroutine puma560_3dof_d13_bias(q, qd, tau) &
      bind(c, name="puma560_3dof_d13_bias_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(in) :: qd(3)
    real(rk), intent(out) :: tau(3)
    associate (unused1 => q, unused2 => qd)
    end associate

    tau(1) = 0.0_rk
    tau(2) = 0.0_rk
    tau(3) = 0.0_rk
  end subroutine

  ! mass matrix, rotor inertias on its diagonal
  ! 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
  pure subroutine puma560_3dof_d13_mass_matrix(q, M) &
      bind(c, name="puma560_3dof_d13_mass_matrix_f")
    real(rk), intent(in) :: q(3)
    real(rk), intent(out) :: M(9)
    associate (unused1 => q)
    end associate

    M(1) = 0.0_rk
    M(2) = 0.0_rk
    M(3) = 0.0_rk
    M(4) = 0.0_rk
    M(5) = 0.0_rk
    M(6) = 0.0_rk
    M(7) = 0.0_rk
    M(8) = 0.0_rk
    M(9) = 0.0_rk
  end subroutine
end module
