"""Small mechanical systems in C, written by hand, for the engine to be tested on.

What can vary is a run-time parameter, so that each of them is compiled once.
"""

from __future__ import annotations

import functools
from typing import Any

from robodyn.simulate.engine import Engine, build_engine

#: Nothing in the engine is to be warned of.
STRICT = (
    "-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Wconversion", "-Werror",
    "-Wno-unused-parameter",
)  # fmt: skip


def _head(name: str, inputs: str, output: str) -> str:
    """The head of a function of the glue: arrays that it reads, and the one that it fills."""
    arrays = [f"const double *{each}" for each in inputs.split()]
    return f"static void system_{name}({', '.join([*arrays, f'double *{output}', 'const double *p'])})"


_BIAS, _FORCE = _head("bias", "y v s z", "h"), _head("force", "y v a s z", "f")
_JACOBIAN, _MASS = _head("jacobian", "y v a s z", "J"), _head("mass", "y", "M")
_CONSERVED, _RATES = _head("conserved", "y v", "h"), _head("rates", "y v z", "zdot")
_MODEL = _head("model", "q qd qdd", "tau")
_EXTERNAL = "static void system_external(double t, const double *y, double *f, const double *p)"

#: Two unit masses on unit rods, both angles from the vertical; p: gravity, viscous friction.
PENDULUM = f"""
#include <math.h>
#define SYSTEM_N 2
#define SYSTEM_PARAMETERS 2
#define SYSTEM_CONSERVED 1
#define SYSTEM_MODEL 1
{_MASS} {{ M[0] = 2; M[1] = M[2] = cos(y[0] - y[1]); M[3] = 1; }}
{_CONSERVED} {{
    double sine = sin(y[0] - y[1]);
    h[0] = sine * v[1] * v[1] + 2 * p[0] * sin(y[0]);
    h[1] = -sine * v[0] * v[0] + p[0] * sin(y[1]);
}}
{_BIAS} {{ system_conserved(y, v, h, p); h[0] += p[1] * v[0]; h[1] += p[1] * v[1]; }}
{_MODEL} {{
    double M[4], s[1], z[1];
    system_mass(q, M, p);
    system_bias(q, qd, s, z, tau, p);
    tau[0] += M[0] * qdd[0] + M[1] * qdd[1];
    tau[1] += M[2] * qdd[0] + M[3] * qdd[1];
}}
"""

#: A unit mass on a belt that moves back at speed p[0], y measured on the belt, a spring of stiffness p[1] to
#: the ground; friction falls from p[2] at rest to p[3] within about the speed p[4]; a force grows by p[5] a
#: second and jumps by p[6] at t = 1.
BLOCK = f"""
#include <math.h>
#define SYSTEM_N 1
#define SYSTEM_ELEMENTS 1
#define SYSTEM_PARAMETERS 7
#define SYSTEM_CONSERVED 1
#define SYSTEM_EXTERNAL 1
static const double system_w[1][1] = {{{{1}}}};
{_MASS} {{ M[0] = 1; }}
{_CONSERVED} {{ h[0] = 0; }}
{_BIAS} {{ h[0] = s[0] * (p[3] + (p[2] - p[3]) * exp(-(v[0] / p[4]) * (v[0] / p[4]))); }}
{_EXTERNAL} {{ f[0] = p[1] * (p[0] * t - y[0]) + p[5] * t + (t >= 1 ? p[6] : 0); }}
"""

#: Three coordinates with friction and a fourth element that couples the first two; p: mass [9], levels [4],
#: loads [3], so that everything about it but the solution is plain.
COUPLED = f"""
#define SYSTEM_N 3
#define SYSTEM_ELEMENTS 4
#define SYSTEM_PARAMETERS 16
#define SYSTEM_CONSERVED 1
static const double system_w[4][3] = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, -0.5, 0}}}};
{_MASS} {{ for (int i = 0; i < 9; i++) M[i] = p[i]; }}
{_CONSERVED} {{ for (int i = 0; i < 3; i++) h[i] = -p[13 + i]; }}
{_BIAS} {{
    for (int i = 0; i < 3; i++) {{
        h[i] = -p[13 + i];
        for (int e = 0; e < 4; e++) h[i] += system_w[e][i] * p[9 + e] * s[e];
    }}
}}
"""

#: A unit mass that slides on a lift, friction p[0] times its weight on the lift; the lift, of mass 2 and not
#: feeling what slides on it, is raised through a gear of efficiency p[1] by a motor of inertia p[2]; gravity
#: 9.81.
LIFT = f"""
#include <math.h>
#define SYSTEM_N 2
#define SYSTEM_ELEMENTS 2
#define SYSTEM_PARAMETERS 3
#define SYSTEM_AFFINE 0
#define SYSTEM_CONSERVED 1
static const double system_w[2][2] = {{{{1, 0}}, {{0, 1}}}};
static double gear(double s, double load, const double *p) {{
    return s == 0 ? 1 : s * load > 0 ? 1 / p[1] : p[1];
}}
{_MASS} {{ M[0] = 1; M[1] = M[2] = 0; M[3] = 2 + p[2]; }}
{_CONSERVED} {{ h[0] = 0; h[1] = 2 * 9.81; }}
{_FORCE} {{
    double load = 2 * (a[1] + 9.81);
    f[0] = a[0] + p[0] * s[0] * fabs(a[1] + 9.81);
    f[1] = p[2] * a[1] + load * gear(s[1], load, p);
}}
{_JACOBIAN} {{
    double load = 2 * (a[1] + 9.81);
    J[0] = 1;
    J[1] = p[0] * s[0] * (load < 0 ? -1 : 1);
    J[2] = 0;
    J[3] = p[2] + 2 * gear(s[1], load, p);
}}
"""

#: Two coordinates behind gears that lose by their load; p: mass [4], weight [2], motor inertia [2],
#: efficiency [2].
GEARS = f"""
#define SYSTEM_N 2
#define SYSTEM_ELEMENTS 2
#define SYSTEM_PARAMETERS 10
#define SYSTEM_AFFINE 0
static const double system_w[2][2] = {{{{1, 0}}, {{0, 1}}}};
static double load(int i, const double *a, const double *p) {{
    return p[2 * i] * a[0] + p[2 * i + 1] * a[1] + p[4 + i];
}}
static double gear(int i, const double *a, const double *s, const double *p) {{
    return s[i] == 0 ? 1 : s[i] * load(i, a, p) > 0 ? 1 / p[8 + i] : p[8 + i];
}}
{_FORCE} {{
    for (int i = 0; i < 2; i++) f[i] = p[6 + i] * a[i] + load(i, a, p) * gear(i, a, s, p);
}}
{_JACOBIAN} {{
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            J[2 * i + j] = p[2 * i + j] * gear(i, a, s, p) + (i == j ? p[6 + i] : 0);
}}
"""

#: A unit mass on a spring of stiffness 4 with Dahl's friction: z is the bristles' force, p: stiffness, level.
BRISTLE = f"""
#include <math.h>
#define SYSTEM_N 1
#define SYSTEM_STATES 1
#define SYSTEM_PARAMETERS 2
{_MASS} {{ M[0] = 1; }}
{_BIAS} {{ h[0] = 4 * y[0] + z[0]; }}
{_RATES} {{ zdot[0] = p[0] * (v[0] - fabs(v[0]) * z[0] / p[1]); }}
"""


@functools.cache
def engine(glue: str) -> Engine:
    """``glue`` compiled, once."""
    return build_engine(glue, flags=STRICT)


def energy(y: Any, v: Any, gravity: float) -> Any:
    """Of the states [S, 2] of the pendulum."""
    import numpy as np

    moving = v[:, 0] ** 2 + 0.5 * v[:, 1] ** 2 + v[:, 0] * v[:, 1] * np.cos(y[:, 0] - y[:, 1])
    return moving - gravity * (2 * np.cos(y[:, 0]) + np.cos(y[:, 1]))
