/*
 * stanford_d3: Stanford arm, the set of the thesis's listing D.3.2
 * Numbers: the 1990 thesis, listing D.3.2 with Tables 2.2 (corrected), 2.7, 2.8; link 1 as in the
 *   tables
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 0e9c705765a81730942efe1f695fcd86 (a hash of its numbers)
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
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 117 multiplications, 84 additions = 201; 0 unary minus; 6 sine/cosine
 *   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
 *   bias: 110 multiplications, 71 additions = 181; 0 unary minus; 6 sine/cosine
 *   mass_matrix: 40 multiplications, 32 additions = 72; 2 unary minus; 6 sine/cosine
 *   forward_dynamics: 207 multiplications, 150 additions, 4 divisions = 361; 1 unary minus; 6
 *       sine/cosine
 */
#ifndef STANFORD_D3_H
#define STANFORD_D3_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double stanford_d3_real;

/* torques that give the accelerations qdd */
void stanford_d3_inverse_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real qdd[6],
    stanford_d3_real tau[6]);

/* torques that hold the arm at rest */
void stanford_d3_gravity(const stanford_d3_real q[6], stanford_d3_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void stanford_d3_bias(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    stanford_d3_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void stanford_d3_mass_matrix(const stanford_d3_real q[6], stanford_d3_real M[36]);

/* accelerations that the torques tau give */
void stanford_d3_forward_dynamics(
    const stanford_d3_real q[6],
    const stanford_d3_real qd[6],
    const stanford_d3_real tau[6],
    stanford_d3_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
