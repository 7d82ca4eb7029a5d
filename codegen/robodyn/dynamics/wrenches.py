"""Joint torques of a wrench on the tool, over any scalar: ``J^T w``, in few operations.

Source: Craig, Introduction to Robotics, 5.9 (static forces).
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import into_child, origin
from robodyn.dynamics.functions.record import Dynamics
from robodyn.dynamics.jacobians import columns
from robodyn.dynamics.poses import placed, tool_place
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


def _wrench(at: Dynamics) -> tuple[Vector, Vector]:
    """Force and moment at the tool's origin, along the world's axes."""
    fx, fy, fz, nx, ny, nz = at.inputs["w"]
    return (fx, fy, fz), (nx, ny, nz)
