/*
 * puma560: PUMA 560, six joints
 * Numbers: the 1990 thesis, Tables 2.1, 2.5, 2.6; inertias of links 5 and 6 divided by ten
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: rotor inertia; inertia (joints 1 to 3); mass, centre of mass (joints 2, 3):
 *     measured on the arm
 * Origin of numbers: limits; mass, centre of mass, inertia (joints 4 to 6): assumed
 * Origin of numbers: friction; mass, centre of mass (joint 1): absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: b422b6e98684ac1e67f70c9b558f78f5 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   2  revolute  alpha -pi/2  a 0        d 0.2435   theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   3  revolute  alpha 0      a 0.4318   d -0.0934  theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   4  revolute  alpha pi/2   a -0.0203  d 0.4331   theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   5  revolute  alpha -pi/2  a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 *   6  revolute  alpha pi/2   a 0        d 0        theta q
 *       limits: -3.141592653589793 to 3.141592653589793 rad, 3 rad/s, 10 rad/s^2
 * Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 1.14 kg m^2, joint 2 4.71 kg m^2, joint 3 0.83 kg m^2, joint 4 0.2 kg
 *     m^2, joint 5 0.179 kg m^2, joint 6 0.193 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 145 multiplications, 117 additions = 262; 0 unary minus; 8 sine/cosine
 *   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
 *   bias: 128 multiplications, 92 additions = 220; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 55 multiplications, 55 additions = 110; 1 unary minus; 8 sine/cosine
 *   forward_dynamics: 246 multiplications, 204 additions, 4 divisions = 454; 9 unary minus; 8
 *       sine/cosine
 */
#ifndef PUMA560_H
#define PUMA560_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_real;

/* torques that give the accelerations qdd
 * with rotor inertia */
void puma560_inverse_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real qdd[6],
    puma560_real tau[6]);

/* torques that hold the arm at rest */
void puma560_gravity(const puma560_real q[6], puma560_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_bias(const puma560_real q[6], const puma560_real qd[6], puma560_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_mass_matrix(const puma560_real q[6], puma560_real M[36]);

/* accelerations that the torques tau give
 * with rotor inertia */
void puma560_forward_dynamics(
    const puma560_real q[6],
    const puma560_real qd[6],
    const puma560_real tau[6],
    puma560_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
