/*
 * iiwa: KUKA iiwa 14 geometry, random full inertias
 * Numbers: published iiwa geometry; inertial parameters drawn at random
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia: synthetic (invented, not those of a real arm)
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 470f3a2263cc6972820aa958e2c80090 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0  d 0.34   theta q
 *   2  revolute  alpha -pi/2  a 0  d 0      theta q
 *   3  revolute  alpha pi/2   a 0  d 0.4    theta q
 *   4  revolute  alpha pi/2   a 0  d 0      theta q
 *   5  revolute  alpha -pi/2  a 0  d 0.4    theta q
 *   6  revolute  alpha -pi/2  a 0  d 0      theta q
 *   7  revolute  alpha pi/2   a 0  d 0.126  theta q
 * Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
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
 *   inverse_dynamics: 258 multiplications, 247 additions = 505; 6 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 243 multiplications, 227 additions = 470; 7 unary minus; 12 sine/cosine
 *   mass_matrix: 133 multiplications, 125 additions = 258; 6 unary minus; 12 sine/cosine
 *   forward_dynamics: 500 multiplications, 455 additions, 6 divisions = 961; 18 unary minus; 12
 *       sine/cosine
 */
#ifndef IIWA_H
#define IIWA_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double iiwa_real;

/* torques that give the accelerations qdd */
void iiwa_inverse_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real qdd[7],
    iiwa_real tau[7]);

/* torques that hold the arm at rest */
void iiwa_gravity(const iiwa_real q[7], iiwa_real tau[7]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void iiwa_bias(const iiwa_real q[7], const iiwa_real qd[7], iiwa_real tau[7]);

/* mass matrix, rotor inertias on its diagonal */
void iiwa_mass_matrix(const iiwa_real q[7], iiwa_real M[49]);

/* accelerations that the torques tau give */
void iiwa_forward_dynamics(
    const iiwa_real q[7],
    const iiwa_real qd[7],
    const iiwa_real tau[7],
    iiwa_real qdd[7]);

#ifdef __cplusplus
}
#endif

#endif
