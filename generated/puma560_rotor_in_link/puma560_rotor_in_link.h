/*
 * puma560_rotor_in_link: PUMA 560, Tables 2.1, 2.5, 2.6, rotor folded into Izz as the thesis does
 * Numbers: Tables 2.1, 2.5, 2.6 with links 5 and 6 corrected
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 3944b9c8df3efa29ca11b7e595201cb9 (a hash of its numbers)
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 139 multiplications, 115 additions = 254; 0 unary minus; 8 sine/cosine
 *   gravity: 12 multiplications, 7 additions = 19; 2 unary minus; 8 sine/cosine
 *   bias: 125 multiplications, 90 additions = 215; 1 unary minus; 8 sine/cosine
 *   mass_matrix: 60 multiplications, 54 additions = 114; 0 unary minus; 8 sine/cosine
 *   forward_dynamics: 247 multiplications, 201 additions, 4 divisions = 452; 3 unary minus; 8
 *       sine/cosine
 */
#ifndef PUMA560_ROTOR_IN_LINK_H
#define PUMA560_ROTOR_IN_LINK_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double puma560_rotor_in_link_real;

/* torques that give the accelerations qdd */
void puma560_rotor_in_link_inverse_dynamics(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    const puma560_rotor_in_link_real qdd[6],
    puma560_rotor_in_link_real tau[6]);

/* torques that hold the arm at rest */
void puma560_rotor_in_link_gravity(
    const puma560_rotor_in_link_real q[6],
    puma560_rotor_in_link_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void puma560_rotor_in_link_bias(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    puma560_rotor_in_link_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void puma560_rotor_in_link_mass_matrix(
    const puma560_rotor_in_link_real q[6],
    puma560_rotor_in_link_real M[36]);

/* accelerations that the torques tau give */
void puma560_rotor_in_link_forward_dynamics(
    const puma560_rotor_in_link_real q[6],
    const puma560_rotor_in_link_real qd[6],
    const puma560_rotor_in_link_real tau[6],
    puma560_rotor_in_link_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
