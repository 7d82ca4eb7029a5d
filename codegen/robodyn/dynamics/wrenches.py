"""Joint torques of a wrench on the tool, over any scalar: ``J^T w``, in few operations.

Source: Craig, Introduction to Robotics, 5.9 (static forces).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, into_child, origin
from robodyn.dynamics.jacobians import columns
from robodyn.dynamics.poses import placed, tool_place
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import Vector, cross, dot, named, plus, scaled


def by_jacobian(at: Dynamics) -> list[Any]:
    """Torques [n] (N m; N at prismatic joints): each column of the Jacobian times the wrench."""
    f, moment = _wrench(at)
    return [dot(v, f) + dot(w, moment) for v, w in columns(at)]


def carried_outward(at: Dynamics) -> list[Any]:
    """The same, force and moment about each origin turned from link to link, base to tip."""
    arm, (f, moment) = at.arm, _wrench(at)
    motion = at.motion(at.rest, at.rest)
    base = arm.base
    # About the base frame's origin, along its axes.
    lever = plus(tool_place(at, placed(at)), scaled(-1, base.origin))
    moment = base.back(plus(moment, cross(lever, f)))
    f = base.back(f)
    torques = []
    for i, body in enumerate(arm.bodies):
        c, s = motion.c[i], motion.s[i]
        moment = into_child(body, c, s, plus(moment, cross(f, origin(body, motion.d[i]))))
        f = into_child(body, c, s, f)
        f, moment = named(at.mark, f, i + 1, "fw"), named(at.mark, moment, i + 1, "nw")
        torques.append(moment[2] if body.revolute else f[2])
    return torques


def beyond_the_last_link(arm: Arm, motion: Motion, w: Sequence[Any]) -> tuple[Vector, Vector]:
    """Force and moment of the last link on what pushes the tool with ``w`` [6], in that link's frame."""
    f, moment = (scaled(-1, arm.base.back(u)) for u in ((w[0], w[1], w[2]), (w[3], w[4], w[5])))
    for body, c, s in zip(arm.bodies, motion.c, motion.s, strict=True):
        f, moment = into_child(body, c, s, f), into_child(body, c, s, moment)
    return f, plus(moment, cross(arm.tool.origin, f))


def _wrench(at: Dynamics) -> tuple[Vector, Vector]:
    """Force and moment at the tool's origin, along the world's axes."""
    fx, fy, fz, nx, ny, nz = at.inputs["w"]
    return (fx, fy, fz), (nx, ny, nz)
