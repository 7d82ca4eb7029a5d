"""Joint torques of a wrench on the tool, over any scalar: force and moment carried from the tool to the base.

Source: Craig, Introduction to Robotics, 5.9 (static forces); ``J^T w`` without the Jacobian.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, about_x, about_z, origin
from robodyn.dynamics.parallel import Turns
from robodyn.dynamics.vectors import Mark, Vector, cross, named, plus, unmarked


def torques_of_wrench(
    arm: Arm, motion: Motion, turns: Turns, wrench: Sequence[Any], mark: Mark = unmarked
) -> list[Any]:
    """Torques [n] (N m; N at prismatic joints) that ``wrench`` does work with: force [N] and moment [N m] on
    the tool, at and about its origin, along its axes."""
    fx, fy, fz, nx, ny, nz = wrench
    f: Vector = arm.tool.turned((fx, fy, fz))
    moment = plus(arm.tool.turned((nx, ny, nz)), cross(arm.tool.origin, f))
    n = len(arm.bodies)
    torques: list[Any] = [0] * n
    for i in reversed(range(n)):
        c, s = turns.c[i], turns.s[i]
        follows = False
        if i + 1 < n:
            child = arm.bodies[i + 1]
            f, moment = (about_x(child.cos_alpha, child.sin_alpha, u) for u in (f, moment))
            p = origin(child, motion.d[i + 1])
            follows = turns.follows[i + 1]
            moment = plus(moment, cross(about_z(c, s, p) if follows else p, f))
        if not follows:  # else they are along the axes in which the chain begins to turn
            f, moment = about_z(c, s, f), about_z(c, s, moment)
        f, moment = named(mark, f, i + 1, "fw"), named(mark, moment, i + 1, "nw")
        torques[i] = moment[2] if arm.bodies[i].revolute else f[2]
    return torques
