/*
 * tx40: Staubli TX40 (CAD parameters; friction, rotor inertia and the wrist coupling are not in
 *   it)
 * Numbers: figaroh-plus examples/staubli_TX40, Apache-2.0
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: ca869e1c35fe24e800334b2c139779ed (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0      d 0.32   theta q
 *   2  revolute  alpha -pi/2  a 0      d 0      theta q
 *   3  revolute  alpha 0      a 0.225  d 0.035  theta q
 *   4  revolute  alpha pi/2   a 0      d 0.225  theta q
 *   5  revolute  alpha -pi/2  a 0      d 0      theta q
 *   6  revolute  alpha pi/2   a 0      d 0      theta q + pi
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
 * Of inverse_dynamics, bias the best program known for these parameters, equal to the recursion
 *   without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 161 multiplications, 152 additions = 313; 0 unary minus; 8 sine/cosine
 *   gravity: 16 multiplications, 12 additions = 28; 0 unary minus; 8 sine/cosine
 *   bias: 145 multiplications, 129 additions = 274; 0 unary minus; 8 sine/cosine
 *   mass_matrix: 72 multiplications, 67 additions = 139; 0 unary minus; 8 sine/cosine
 */
#ifndef TX40_H
#define TX40_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double tx40_real;

/* torques that give the accelerations qdd */
void tx40_inverse_dynamics(
    const tx40_real q[6],
    const tx40_real qd[6],
    const tx40_real qdd[6],
    tx40_real tau[6]);

/* torques that hold the arm at rest */
void tx40_gravity(const tx40_real q[6], tx40_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void tx40_bias(const tx40_real q[6], const tx40_real qd[6], tx40_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void tx40_mass_matrix(const tx40_real q[6], tx40_real M[36]);

#ifdef __cplusplus
}
#endif

#endif
