/*
 * puma560_full: PUMA 560 geometry, random full inertias
 * Numbers: Table 2.1 geometry; masses, centres and inertias drawn at random: a test of generic
 *   parameters
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 4ba5f6ba4580930ac3ece4f91e671e11 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0        d 0        theta q
 *   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
 *   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
 *   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
 *   5  revolute  alpha -pi/2  a 0        d 0        theta q
 *   6  revolute  alpha pi/2   a 0        d 0        theta q
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 1.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 218 multiplications, 209 additions = 427; 0 unary minus; 10 sine/cosine
 *   gravity: 24 multiplications, 18 additions = 42; 1 unary minus; 10 sine/cosine
 *   bias: 198 multiplications, 181 additions = 379; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 116 multiplications, 110 additions = 226; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 400 multiplications, 359 additions, 5 divisions = 764; 4 unary minus; 10
 *       sine/cosine
 */
#ifndef PUMA560_FULL_H
#define PUMA560_FULL_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_full_real;

/* torques that give the accelerations qdd */
void puma560_full_inverse_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real qdd[6],
    puma560_full_real tau[6]);

/* torques that hold the arm at rest */
void puma560_full_gravity(const puma560_full_real q[6], puma560_full_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_full_bias(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    puma560_full_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_full_mass_matrix(const puma560_full_real q[6], puma560_full_real M[36]);

/* accelerations that the torques tau give */
void puma560_full_forward_dynamics(
    const puma560_full_real q[6],
    const puma560_full_real qd[6],
    const puma560_full_real tau[6],
    puma560_full_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
