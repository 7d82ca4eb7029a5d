/*
 * stanford: Stanford arm, six joints
 * Numbers: the 1990 thesis, Tables 2.2 (corrected), 2.7, 2.8; Izz of link 3 assumed
 * Origin of numbers: geometry, mass, centre of mass, inertia, rotor inertia: stated by the
 *     description
 * Origin of numbers: friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: de26546409d6162d87592b49cbe31f58 (a hash of its numbers)
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
 * Torques are the motors', reflected to the joints; what lies between is in them.
 * Effects in this model:
 *   rotor inertia: joint 1 0.953 kg m^2, joint 2 2.193 kg m^2, joint 3 0.782 kg, joint 4 0.106 kg
 *     m^2, joint 5 0.097 kg m^2, joint 6 0.02 kg m^2
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of inverse_dynamics, bias, forward_dynamics the best program known for these parameters, equal
 *   to the recursion without being written like it: robodyn --optimize full, seed 6.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 114 multiplications, 87 additions = 201; 6 unary minus; 6 sine/cosine
 *   gravity: 14 multiplications, 6 additions = 20; 1 unary minus; 6 sine/cosine
 *   bias: 104 multiplications, 70 additions = 174; 0 unary minus; 6 sine/cosine
 *   mass_matrix: 41 multiplications, 32 additions = 73; 2 unary minus; 6 sine/cosine
 *   forward_dynamics: 201 multiplications, 149 additions, 4 divisions = 354; 2 unary minus; 6
 *       sine/cosine
 */
#ifndef STANFORD_H
#define STANFORD_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double stanford_real;

/* torques that give the accelerations qdd
 * with rotor inertia */
void stanford_inverse_dynamics(
    const stanford_real q[6],
    const stanford_real qd[6],
    const stanford_real qdd[6],
    stanford_real tau[6]);

/* torques that hold the arm at rest */
void stanford_gravity(const stanford_real q[6], stanford_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void stanford_bias(const stanford_real q[6], const stanford_real qd[6], stanford_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void stanford_mass_matrix(const stanford_real q[6], stanford_real M[36]);

/* accelerations that the torques tau give
 * with rotor inertia */
void stanford_forward_dynamics(
    const stanford_real q[6],
    const stanford_real qd[6],
    const stanford_real tau[6],
    stanford_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
