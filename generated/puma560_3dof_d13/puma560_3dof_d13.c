/*
 * puma560_3dof_d13: PUMA 560, first three joints with the tool at the wrist, as in the thesis's
 *   D.1.3
 * Numbers: the 1990 thesis, program D.1.3 (inverse kinematics); no masses
 * Origin of numbers: geometry: stated by the description
 * Origin of numbers: mass, centre of mass, inertia, rotor inertia, friction: absent, taken as 0
 * Origin of numbers: limits: absent, so without bounds
 * Written by robodyn 0.1.0; do not edit, generate again.
 * Description: 2cfb44495e01bcb86afbc938f4d4ee8e (a hash of its numbers)
 * Options: --optimize record --scalar double --trig libm
 *
 * Joints, base to tip, in modified Denavit-Hartenberg frames [rad, m]:
 *   1  revolute  alpha 0      a 0       d 0      theta q
 *   2  revolute  alpha -pi/2  a 0       d 0.127  theta q
 *   3  revolute  alpha 0      a 0.4318  d 0      theta q
 * Gravity in the base frame: 0.0, 0.0, -9.8 m/s^2
 * Tool frame in the last link: [0, 0.4318, 0] m, roll, pitch, yaw 0, 0, 0 rad
 * Arguments, in SI units, joint 1 first:
 *   q    joint positions [rad, prismatic m]
 *   qd   joint velocities [rad/s, prismatic m/s]
 *   qdd  joint accelerations [rad/s^2, prismatic m/s^2]
 *   tau  joint torques [N m, prismatic N]
 *   M    mass matrix, row by row [kg m^2, kg m, kg]
 * Formulation: modified Newton-Euler (lambda matrix) in modified Denavit-Hartenberg frames, on
 *   base parameters: fc and nc act at and about the frame's origin, and what of a link's mass
 *   makes no difference is moved to its parent.
 *
 * Operations (every binary * is a multiplication, every binary + or - an addition):
 *   inverse_dynamics: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
 *   gravity: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
 *   bias: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
 *   mass_matrix: 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine
 */
#include "puma560_3dof_d13.h"

#include <math.h>

/* torques that give the accelerations qdd
 * 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine */
void puma560_3dof_d13_inverse_dynamics(
    const puma560_3dof_d13_real q[3],
    const puma560_3dof_d13_real qd[3],
    const puma560_3dof_d13_real qdd[3],
    puma560_3dof_d13_real tau[3])
{
    tau[0] = 0.0;
    tau[1] = 0.0;
    tau[2] = 0.0;
    (void)q;
    (void)qd;
    (void)qdd;
}

/* torques that hold the arm at rest
 * 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine */
void puma560_3dof_d13_gravity(const puma560_3dof_d13_real q[3], puma560_3dof_d13_real tau[3])
{
    tau[0] = 0.0;
    tau[1] = 0.0;
    tau[2] = 0.0;
    (void)q;
}

/* torques at zero acceleration: Coriolis, centrifugal, gravity, friction
 * 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine */
void puma560_3dof_d13_bias(
    const puma560_3dof_d13_real q[3],
    const puma560_3dof_d13_real qd[3],
    puma560_3dof_d13_real tau[3])
{
    tau[0] = 0.0;
    tau[1] = 0.0;
    tau[2] = 0.0;
    (void)q;
    (void)qd;
}

/* mass matrix, rotor inertias on its diagonal
 * 0 multiplications, 0 additions = 0; 0 unary minus; 0 sine/cosine */
void puma560_3dof_d13_mass_matrix(const puma560_3dof_d13_real q[3], puma560_3dof_d13_real M[9])
{
    M[0] = 0.0;
    M[1] = 0.0;
    M[2] = 0.0;
    M[3] = 0.0;
    M[4] = 0.0;
    M[5] = 0.0;
    M[6] = 0.0;
    M[7] = 0.0;
    M[8] = 0.0;
    (void)q;
}
