/*
 * ur5: Universal Robots UR5
 * Numbers: URDF of example-robot-data (ur_description, BSD), turned into modified DH
 * Origin of numbers: geometry, mass, centre of mass, inertia: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: a034a79d0d30f898e9c7fa14f11711e6 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0     a 0        d 0.089159  theta q + -pi
 *   2  revolute  alpha pi/2  a 0        d 0.13585   theta q + pi
 *   3  revolute  alpha 0     a 0.425    d -0.1197   theta q
 *   4  revolute  alpha 0     a 0.39225  d 0.093     theta q + -pi
 *   5  revolute  alpha pi/2  a 0        d 0.09465   theta q + -pi
 *   6  revolute  alpha pi/2  a 0        d 0         theta q
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
 *   to the recursion without being written like it: robodyn --optimize full, seed 3.
 * Of mass_matrix the best program known for these parameters, equal to the recursion without being
 *   written like it: robodyn --optimize full, seed 1.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 106 multiplications, 79 additions = 185; 2 unary minus; 10 sine/cosine
 *   gravity: 3 multiplications, 4 additions = 7; 0 unary minus; 3 sine/cosine
 *   bias: 87 multiplications, 54 additions = 141; 2 unary minus; 10 sine/cosine
 *   mass_matrix: 34 multiplications, 32 additions = 66; 0 unary minus; 10 sine/cosine
 *   forward_dynamics: 171 multiplications, 146 additions, 5 divisions = 322; 3 unary minus; 10
 *       sine/cosine
 */
#ifndef UR5_H
#define UR5_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double ur5_real;

/* torques that give the accelerations qdd */
void ur5_inverse_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real qdd[6],
    ur5_real tau[6]);

/* torques that hold the arm at rest */
void ur5_gravity(const ur5_real q[6], ur5_real tau[6]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void ur5_bias(const ur5_real q[6], const ur5_real qd[6], ur5_real tau[6]);

/* mass matrix, rotor inertias on its diagonal */
void ur5_mass_matrix(const ur5_real q[6], ur5_real M[36]);

/* accelerations that the torques tau give */
void ur5_forward_dynamics(
    const ur5_real q[6],
    const ur5_real qd[6],
    const ur5_real tau[6],
    ur5_real qdd[6]);

#ifdef __cplusplus
}
#endif

#endif
