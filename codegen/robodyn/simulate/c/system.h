/* The mechanical system, which engine_glue.h gives: sizes as macros, functions as static C.
 *
 *   force(y, v, a, s, z) = torque(t) + external(t, y)
 *
 * holds for coordinates y [n], velocities v [n], accelerations a [n], internal states z [k] with their own
 * rates, and directions s [elements] of the dry-friction elements: the sign of u = w . v, 0 at rest. p is the
 * block of run-time parameters that the run was started with.
 *
 *   SYSTEM_N, SYSTEM_ELEMENTS (0), SYSTEM_STATES (0), SYSTEM_PARAMETERS (0)   sizes
 *   SYSTEM_AFFINE (1)       force = mass a + bias; 0: force depends on a in another way, piecewise smooth
 *   SYSTEM_CONSERVED (0)    1: conserved and mass are given, and work and loss are integrated
 *   SYSTEM_EXTERNAL (0)     1: external is given
 *   SYSTEM_MODEL (0)        1: model is given, for computed torque
 *
 *   system_w[SYSTEM_ELEMENTS][SYSTEM_N]
 *   system_mass(y, M, p)                    [n*n] symmetric, positive definite
 *   system_bias(y, v, s, z, h, p)           affine only: force at a = 0
 *   system_force(y, v, a, s, z, f, p)       not affine only
 *   system_jacobian(y, v, a, s, z, J, p)    not affine only: J[i*n + j] = d f_i / d a_j
 *   system_rates(y, v, z, zdot, p)          with states only
 *   system_conserved(y, v, h, p)            the bias of the same system without any loss
 *   system_external(t, y, f, p)             smooth but at the times given as breaks; there it is right-continuous
 *   system_model(q, qd, qdd, tau, p)        [motors]
 *
 * The friction of an element acts along its own row: force(s) - force(s with s_e = 0) is along w_e.
 */
#ifndef SYSTEM_H
#define SYSTEM_H
#include "engine_glue.h"

#ifndef SYSTEM_ELEMENTS
#define SYSTEM_ELEMENTS 0
#endif
#ifndef SYSTEM_STATES
#define SYSTEM_STATES 0
#endif
#ifndef SYSTEM_PARAMETERS
#define SYSTEM_PARAMETERS 0
#endif
#ifndef SYSTEM_AFFINE
#define SYSTEM_AFFINE 1
#endif
#ifndef SYSTEM_CONSERVED
#define SYSTEM_CONSERVED 0
#endif
#ifndef SYSTEM_EXTERNAL
#define SYSTEM_EXTERNAL 0
#endif
#ifndef SYSTEM_MODEL
#define SYSTEM_MODEL 0
#endif

/* The integrated vector: y, v, z, and the quadratures work and loss. E1: no array is without members. */
enum { N = SYSTEM_N, E = SYSTEM_ELEMENTS, K = SYSTEM_STATES, E1 = E > 1 ? E : 2 };
enum { V = N, Z = 2 * N, MOVING = 2 * N + K, WORK = MOVING, LOSS, SIZE };

#if SYSTEM_ELEMENTS == 0
static const double system_w[E1][N] = {{0}};
#endif
#endif
