/*
 * rx90: Staubli RX90 geometry, random full inertias
 * Numbers: published RX90 geometry; inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 585cc70ab770fd33a78850636aafb009 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0     d 0     theta q
 *   2  revolute  alpha pi/2   a 0     d 0     theta q
 *   3  revolute  alpha 0      a 0.45  d 0     theta q
 *   4  revolute  alpha -pi/2  a 0     d 0.45  theta q
 *   5  revolute  alpha pi/2   a 0     d 0     theta q
 *   6  revolute  alpha -pi/2  a 0     d 0     theta q
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
 *   inverse_dynamics: 212 multiplications, 201 additions = 413; 3 unary minus; 10 sine/cosine
 *   gravity: 24 multiplications, 18 additions = 42; 0 unary minus; 10 sine/cosine
 *   bias: 191 multiplications, 173 additions = 364; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 105 multiplications, 94 additions = 199; 1 unary minus; 10 sine/cosine
 *   forward_dynamics: 376 multiplications, 336 additions, 5 divisions = 717; 14 unary minus; 10
 *       sine/cosine
 */
#ifndef RX90_H
#define RX90_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double rx90_real;

/* torques that give the accelerations qdd */
void rx90_inverse_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real qdd[6],
    rx90_real tau[6]);

/* torques that hold the arm at rest */
void rx90_gravity(const rx90_real q[6], rx90_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void rx90_bias(const rx90_real q[6], const rx90_real qd[6], rx90_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void rx90_mass_matrix(const rx90_real q[6], rx90_real M[36]);

/* accelerations that the torques tau give */
void rx90_forward_dynamics(
    const rx90_real q[6],
    const rx90_real qd[6],
    const rx90_real tau[6],
    rx90_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
