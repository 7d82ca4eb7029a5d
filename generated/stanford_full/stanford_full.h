/*
 * stanford_full: Stanford geometry, random full inertias
 * Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 84b51ffbe87f1ac4bb6e33f59e330781 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute   alpha 0      a 0  d 0       theta q
 *   2  revolute   alpha -pi/2  a 0  d 0.1524  theta q
 *   3  prismatic  alpha pi/2   a 0  d q       theta 0
 *   4  revolute   alpha 0      a 0  d 0       theta q
 *   5  revolute   alpha -pi/2  a 0  d 0       theta q
 *   6  revolute   alpha pi/2   a 0  d 0       theta q
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
 *   seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 200 multiplications, 188 additions = 388; 1 unary minus; 8 sine/cosine
 *   gravity: 24 multiplications, 16 additions = 40; 1 unary minus; 8 sine/cosine
 *   bias: 184 multiplications, 164 additions = 348; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 90 multiplications, 84 additions = 174; 3 unary minus; 8 sine/cosine
 *   forward_dynamics: 358 multiplications, 316 additions, 5 divisions = 679; 2 unary minus; 8
 *       sine/cosine
 */
#ifndef STANFORD_FULL_H
#define STANFORD_FULL_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double stanford_full_real;

/* torques that give the accelerations qdd */
void stanford_full_inverse_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real qdd[6],
    stanford_full_real tau[6]);

/* torques that hold the arm at rest */
void stanford_full_gravity(const stanford_full_real q[6], stanford_full_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void stanford_full_bias(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    stanford_full_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void stanford_full_mass_matrix(const stanford_full_real q[6], stanford_full_real M[36]);

/* accelerations that the torques tau give */
void stanford_full_forward_dynamics(
    const stanford_full_real q[6],
    const stanford_full_real qd[6],
    const stanford_full_real tau[6],
    stanford_full_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
