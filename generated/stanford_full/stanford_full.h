/*
 * stanford_full: Stanford geometry, random full inertias
 * Numbers: geometry of Table 2.2 (corrected); inertial parameters drawn at random
 * Written by robodyn; do not edit, generate again.
 *
 * Joints, base to tip: 1 revolute, 2 revolute, 3 prismatic, 4 revolute, 5 revolute, 6 revolute
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
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 223 multiplications, 208 additions = 431; 6 unary minus; 8 sine/cosine
 *   gravity: 48 multiplications, 27 additions = 75; 1 unary minus; 8 sine/cosine
 *   bias: 211 multiplications, 186 additions = 397; 7 unary minus; 8 sine/cosine
 *   mass_matrix: 105 multiplications, 98 additions = 203; 9 unary minus; 8 sine/cosine
 *   forward_dynamics: 402 multiplications, 354 additions, 6 divisions = 762; 20 unary minus; 8
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
