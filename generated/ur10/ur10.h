/*
 * ur10: Universal Robots UR10
 * Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH; last link
 *   carries the fixed tool
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 0dacbf6be1c6f14933c88bb9a0ce558d (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0       d 0.1273    theta q + -pi
 *   2  revolute  alpha pi/2  a 0       d 0.220941  theta q + pi
 *   3  revolute  alpha 0     a 0.612   d -0.1719   theta q
 *   4  revolute  alpha 0     a 0.5723  d 0.1149    theta q + -pi
 *   5  revolute  alpha pi/2  a 0       d 0.1157    theta q + -pi
 *   6  revolute  alpha pi/2  a 0       d 0         theta q
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
 *   seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 104 multiplications, 81 additions = 185; 3 unary minus; 10 sine/cosine
 *   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
 *   bias: 84 multiplications, 57 additions = 141; 0 unary minus; 10 sine/cosine
 *   mass_matrix: 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 168 multiplications, 149 additions, 5 divisions = 322; 3 unary minus; 10
 *       sine/cosine
 */
#ifndef UR10_H
#define UR10_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double ur10_real;

/* torques that give the accelerations qdd */
void ur10_inverse_dynamics(
    const ur10_real q[6],
    const ur10_real qd[6],
    const ur10_real qdd[6],
    ur10_real tau[6]);

/* torques that hold the arm at rest */
void ur10_gravity(const ur10_real q[6], ur10_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void ur10_bias(const ur10_real q[6], const ur10_real qd[6], ur10_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void ur10_mass_matrix(const ur10_real q[6], ur10_real M[36]);

/* accelerations that the torques tau give */
void ur10_forward_dynamics(
    const ur10_real q[6],
    const ur10_real qd[6],
    const ur10_real tau[6],
    ur10_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
