/*
 * puma560_3dof: PUMA 560, first three joints
 * Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; first three links
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: inertia, rotor inertia; mass, centre of mass (joints 2, 3): measured on the
 *     arm
 * Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: a3748b578bcf07f13e7166c4520ffff7 (a hash of its numbers)
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
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 45 multiplications, 35 additions = 80; 0 unary minus; 4 sine/cosine
 *   gravity: 3 multiplications, 3 additions = 6; 0 unary minus; 3 sine/cosine
 *   bias: 29 multiplications, 18 additions = 47; 1 unary minus; 4 sine/cosine
 *   mass_matrix: 12 multiplications, 12 additions = 24; 0 unary minus; 4 sine/cosine
 *   forward_dynamics: 55 multiplications, 42 additions, 2 divisions = 99; 2 unary minus; 4
 *       sine/cosine
 */
#ifndef PUMA560_3DOF_H
#define PUMA560_3DOF_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_3dof_real;

/* torques that give the accelerations qdd
 * with rotor inertia */
void puma560_3dof_inverse_dynamics(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    const puma560_3dof_real qdd[3],
    puma560_3dof_real tau[3]);

/* torques that hold the arm at rest */
void puma560_3dof_gravity(const puma560_3dof_real q[3], puma560_3dof_real tau[3]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_3dof_bias(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    puma560_3dof_real tau[3]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_3dof_mass_matrix(const puma560_3dof_real q[3], puma560_3dof_real M[9]);

/* accelerations that the torques tau give
 * with rotor inertia */
void puma560_3dof_forward_dynamics(
    const puma560_3dof_real q[3],
    const puma560_3dof_real qd[3],
    const puma560_3dof_real tau[3],
    puma560_3dof_real qdd[3]);

#ifdef __cplusplus
}
#endif

#endif
