"""Kinetic and potential energy of the rigid arm, link by link, over any scalar.

Source: Craig, Introduction to Robotics, 6.69 to 6.74.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Motion, into_child, origin
from robodyn.dynamics.vectors import ZERO, Vector, cross, dot, plus
from robodyn.effects.scalars import quotient


def energies(arm: Arm, motion: Motion) -> tuple[Any, Any]:
    """Kinetic (rotors included) and potential energy [J] of ``arm`` at the positions and rates of ``motion``;
    the potential of the base's origin is 0."""
    kinetic: Any = 0
    potential: Any = 0
    w: Vector = ZERO
    v: Vector = ZERO
    g: Vector = arm.gravity
    height: Any = 0  # of the frame's origin: -g . position
    for i, body in enumerate(arm.bodies):
        c, s, qd = motion.c[i], motion.s[i], motion.qd[i]
        p = origin(body, motion.d[i])
        height = height - dot(g, p)
        v = into_child(body, c, s, plus(v, cross(w, p)))
        w = into_child(body, c, s, w)
        g = into_child(body, c, s, g)
        if body.revolute:
            w = plus(w, (0, 0, qd))
        else:
            v = plus(v, (0, 0, qd))
        v_com = plus(v, cross(w, body.com))
        spin = dot(w, body.inertia.times(w))
        twice = body.mass * dot(v_com, v_com) + spin + body.motor_inertia * (qd * qd)
        kinetic = kinetic + quotient(twice, 2)
        potential = potential + body.mass * (height - dot(g, body.com))
    return kinetic, potential
