/*
 * panda: Franka Emika Panda, hand locked
 * Numbers: URDF of example-robot-data (franka_description, Apache-2.0), turned into modified DH;
 *   fingers locked at the neutral pose
 * Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 4ff65a695f92e93333f180c48f97cb00 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0       d 0.333  theta q + -pi
 *       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 15 rad/s^2, 87 N m
 *   2  revolute  alpha pi/2  a 0       d 0      theta q + -pi
 *       limits: -1.7628 to 1.7628 rad, 2.175 rad/s, 7.5 rad/s^2, 87 N m
 *   3  revolute  alpha pi/2  a 0       d 0.316  theta q
 *       limits: -2.8973 to 2.8973 rad, 2.175 rad/s, 10 rad/s^2, 87 N m
 *   4  revolute  alpha pi/2  a 0.0825  d 0      theta q + -pi
 *       limits: -3.0718 to -0.0698 rad, 2.175 rad/s, 12.5 rad/s^2, 87 N m
 *   5  revolute  alpha pi/2  a 0.0825  d 0.384  theta q + -pi
 *       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 15 rad/s^2, 12 N m
 *   6  revolute  alpha pi/2  a 0       d 0      theta q
 *       limits: -0.0175 to 3.7525 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
 *   7  revolute  alpha pi/2  a 0.088   d 0      theta q
 *       limits: -2.8973 to 2.8973 rad, 2.61 rad/s, 20 rad/s^2, 12 N m
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 1.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize search, from the record of an arm that is built alike.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 272 multiplications, 258 additions = 530; 6 unary minus; 12 sine/cosine
 *   gravity: 42 multiplications, 29 additions = 71; 1 unary minus; 12 sine/cosine
 *   bias: 257 multiplications, 242 additions = 499; 1 unary minus; 12 sine/cosine
 *   mass_matrix: 170 multiplications, 163 additions = 333; 2 unary minus; 12 sine/cosine
 *   forward_dynamics: 553 multiplications, 511 additions, 6 divisions = 1070; 1 unary minus; 12
 *       sine/cosine
 */
#ifndef PANDA_H
#define PANDA_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double panda_real;

/* torques that give the accelerations qdd */
void panda_inverse_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real qdd[7],
    panda_real tau[7]);

/* torques that hold the arm at rest */
void panda_gravity(const panda_real q[7], panda_real tau[7]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void panda_bias(const panda_real q[7], const panda_real qd[7], panda_real tau[7]);

/* mass matrix, rotor inertias on its diagonal */
void panda_mass_matrix(const panda_real q[7], panda_real M[49]);

/* accelerations that the torques tau give */
void panda_forward_dynamics(
    const panda_real q[7],
    const panda_real qd[7],
    const panda_real tau[7],
    panda_real qdd[7]);

#ifdef __cplusplus
}
#endif

#endif
