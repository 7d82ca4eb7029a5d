/*
 * puma560_3dof_d11: PUMA 560, first three joints, the set of the thesis's program D.1.1
 * Numbers: the 1990 thesis, program D.1.1 (Lagrange); pseudo-inertias as tensors about the centres
 *   of mass
 * Origin of numbers: geometry, inertia; mass, centre of mass (joints 2, 3): stated by the
 *     description
 * Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: e4acb3fa395de91cc0422790bfa2c096 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0       d 0        theta q
 *   2  revolute  alpha -pi/2  a 0       d 0.2435   theta q
 *   3  revolute  alpha 0      a 0.4318  d -0.0934  theta q
 * Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, mass_matrix, forward_dynamics the best program known for these
 *   parameters, equal to the recursion without being written like it: robodyn --optimize full,
 *   seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 36 multiplications, 26 additions = 62; 0 unary minus; 4 sine/cosine
 *   gravity: 2 multiplications, 2 additions = 4; 0 unary minus; 2 sine/cosine
 *   bias: 25 multiplications, 14 additions = 39; 1 unary minus; 4 sine/cosine
 *   mass_matrix: 10 multiplications, 9 additions = 19; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 49 multiplications, 34 additions, 2 divisions = 85; 0 unary minus; 4
 *       sine/cosine
 */
#ifndef PUMA560_3DOF_D11_H
#define PUMA560_3DOF_D11_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_3dof_d11_real;

/* torques that give the accelerations qdd */
void puma560_3dof_d11_inverse_dynamics(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    const puma560_3dof_d11_real qdd[3],
    puma560_3dof_d11_real tau[3]);

/* torques that hold the arm at rest */
void puma560_3dof_d11_gravity(const puma560_3dof_d11_real q[3], puma560_3dof_d11_real tau[3]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_3dof_d11_bias(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    puma560_3dof_d11_real tau[3]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_3dof_d11_mass_matrix(const puma560_3dof_d11_real q[3], puma560_3dof_d11_real M[9]);

/* accelerations that the torques tau give */
void puma560_3dof_d11_forward_dynamics(
    const puma560_3dof_d11_real q[3],
    const puma560_3dof_d11_real qd[3],
    const puma560_3dof_d11_real tau[3],
    puma560_3dof_d11_real qdd[3]);

#ifdef __cplusplus
}
#endif

#endif
