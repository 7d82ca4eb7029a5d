/*
 * iiwa7: KUKA LBR iiwa 7 R800
 * Numbers: MJCF of robosuite 1.5.2 (MIT), turned into modified DH; the damping that it simulates
 *   with is left out
 * Origin of numbers: geometry, mass, centre of mass, inertia, limits: stated by the description
 * Origin of numbers: rotor inertia, friction: absent, taken as 0
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 17d842b0070c2c20fc4a1a2bf9c43b77 (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  joint_1  revolute  alpha 0      a 0  d 0.34  theta q
 *       limits: -2.96706 to 2.96706 rad, 176 N m
 *   2  joint_2  revolute  alpha -pi/2  a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 176 N m
 *   3  joint_3  revolute  alpha pi/2   a 0  d 0.4   theta q
 *       limits: -2.96706 to 2.96706 rad, 110 N m
 *   4  joint_4  revolute  alpha pi/2   a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 110 N m
 *   5  joint_5  revolute  alpha -pi/2  a 0  d 0.4   theta q
 *       limits: -2.96706 to 2.96706 rad, 110 N m
 *   6  joint_6  revolute  alpha -pi/2  a 0  d 0     theta q
 *       limits: -2.0944 to 2.0944 rad, 40 N m
 *   7  joint_7  revolute  alpha pi/2   a 0  d 0     theta q
 *       limits: -3.05433 to 3.05433 rad, 40 N m
 * Gravity in the base frame: 0.0, 0.0, -9.81 m/s^2
 * Tool frame in the last link: [0, 0, 0.125] m, roll, pitch, yaw 0, 0, pi rad
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 * Of mass_matrix, forward_dynamics the best program known for these parameters, equal to the
 *   recursion without being written like it: robodyn --optimize full, seed 0.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 216 multiplications, 194 additions = 410; 9 unary minus; 12 sine/cosine
 *   gravity: 30 multiplications, 18 additions = 48; 2 unary minus; 10 sine/cosine
 *   bias: 209 multiplications, 177 additions = 386; 8 unary minus; 12 sine/cosine
 *   mass_matrix: 103 multiplications, 94 additions = 197; 2 unary minus; 12 sine/cosine
 *   forward_dynamics: 428 multiplications, 368 additions, 6 divisions = 802; 16 unary minus; 12
 *       sine/cosine
 */
#ifndef IIWA7_H
#define IIWA7_H

#ifdef __cplusplus
extern "C" {
#endif

typedef double iiwa7_real;

/* torques that give the accelerations qdd */
void iiwa7_inverse_dynamics(
    const iiwa7_real q[7],
    const iiwa7_real qd[7],
    const iiwa7_real qdd[7],
    iiwa7_real tau[7]);

/* torques that hold the arm at rest */
void iiwa7_gravity(const iiwa7_real q[7], iiwa7_real tau[7]);

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction */
void iiwa7_bias(const iiwa7_real q[7], const iiwa7_real qd[7], iiwa7_real tau[7]);

/* mass matrix, rotor inertias on its diagonal */
void iiwa7_mass_matrix(const iiwa7_real q[7], iiwa7_real M[49]);

/* accelerations that the torques tau give */
void iiwa7_forward_dynamics(
    const iiwa7_real q[7],
    const iiwa7_real qd[7],
    const iiwa7_real tau[7],
    iiwa7_real qdd[7]);

#ifdef __cplusplus
}
#endif

#endif
