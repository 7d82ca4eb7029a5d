/*
 * puma560_d2: PUMA 560, the set of the thesis's program D.2
 * Numbers: the 1990 thesis, program D.2 (reduce_puma6), with z4 = -0.019 as listing D.3.4 uses it
 * Origin of numbers: geometry, inertia; mass, centre of mass (joints 2 to 6): stated by the
 *     description
 * Origin of numbers: rotor inertia, friction; mass, centre of mass (joint 1): absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: b8f01132844a21fecaa07c198852efc3 (a hash of its numbers)
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 128 multiplications, 101 additions = 229; 0 unary minus; 8 sine/cosine
 *   gravity: 11 multiplications, 6 additions = 17; 2 unary minus; 7 sine/cosine
 *   bias: 119 multiplications, 83 additions = 202; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 53 multiplications, 49 additions = 102; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 232 multiplications, 189 additions, 4 divisions = 425; 2 unary minus; 8
 *       sine/cosine
 */
#ifndef PUMA560_D2_H
#define PUMA560_D2_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_d2_real;

/* torques that give the accelerations qdd */
void puma560_d2_inverse_dynamics(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    const puma560_d2_real qdd[6],
    puma560_d2_real tau[6]);

/* torques that hold the arm at rest */
void puma560_d2_gravity(const puma560_d2_real q[6], puma560_d2_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_d2_bias(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    puma560_d2_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_d2_mass_matrix(const puma560_d2_real q[6], puma560_d2_real M[36]);

/* accelerations that the torques tau give */
void puma560_d2_forward_dynamics(
    const puma560_d2_real q[6],
    const puma560_d2_real qd[6],
    const puma560_d2_real tau[6],
    puma560_d2_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
