"""Conventional recursive Newton-Euler inverse dynamics, over any scalar.

Source: Luh, Walker and Paul 1980, in modified DH frames (Craig, Introduction to Robotics, 6.45 to
6.53); the thesis's Table 2.3.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Motion, into_child, into_parent, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked


def newton_euler(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    n = len(arm.bodies)
    w: Vector = ZERO
    alpha: Vector = ZERO
    gx, gy, gz = arm.gravity
    a: Vector = (-gx, -gy, -gz)  # gravity as an acceleration of the base
    origins, forces, moments = [], [], []
    for i, body in enumerate(arm.bodies):
        c, s, qd, qdd = motion.c[i], motion.s[i], motion.qd[i], motion.qdd[i]
        p = origin(body, motion.d[i])
        a = into_child(body, c, s, plus(a, cross(alpha, p), cross(w, cross(w, p))))
        w = into_child(body, c, s, w)
        alpha = into_child(body, c, s, alpha)
        if body.revolute:
            alpha = plus(alpha, cross(w, (0, 0, qd)), (0, 0, qdd))
            w = plus(w, (0, 0, qd))
        else:
            a = plus(a, scaled(2, cross(w, (0, 0, qd))), (0, 0, qdd))
        w = named(mark, w, i + 1, "w")
        alpha = named(mark, alpha, i + 1, "alpha")
        a = named(mark, a, i + 1, "a")
        r = body.com
        a_com = named(mark, plus(a, cross(alpha, r), cross(w, cross(w, r))), i + 1, "ac")
        origins.append(p)
        forces.append(named(mark, scaled(body.mass, a_com), i + 1, "fc"))
        momentum = body.inertia.times(w)
        moments.append(named(mark, plus(body.inertia.times(alpha), cross(w, momentum)), i + 1, "nc"))

    f: Vector = ZERO
    moment: Vector = ZERO
    torques: list[Any] = [None] * n
    for i in reversed(range(n)):
        body = arm.bodies[i]
        moment = plus(moments[i], moment, cross(body.com, forces[i]))
        if i + 1 < n:
            moment = plus(moment, cross(origins[i + 1], f))
        f = named(mark, plus(forces[i], f), i + 1, "f")
        moment = named(mark, moment, i + 1, "n")
        torques[i] = joint_torque(arm, i, motion, moment[2] if body.revolute else f[2], mark)
        f = into_parent(body, motion.c[i], motion.s[i], f)
        moment = into_parent(body, motion.c[i], motion.s[i], moment)
    return torques
