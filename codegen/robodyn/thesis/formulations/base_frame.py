"""The motion of every link along the axes of the base: what the first recursive Newton-Euler methods share.

Rotations are multiplied up from the base, joint axes and offsets turned into it, and velocities and
accelerations added there, where nothing has to be turned on from link to link.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Arm, Body, Motion, origin
from robodyn.dynamics.transforms import IDENTITY_3, Matrix, applied, marked, product, rotation
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled


@dataclass(frozen=True, slots=True)
class InBase:
    """A link in motion, all along the base's axes: ``E`` [3, 3] turns its own axes into the base's, ``p`` [m]
    leads from the origin of the frame before to its own, ``w`` [rad/s], ``alpha`` [rad/s^2], and ``a``
    [m/s^2] of its origin, gravity being an acceleration of the base."""

    E: Matrix
    p: Vector
    w: Vector
    alpha: Vector
    a: Vector

    @property
    def axis(self) -> Vector:
        """Its joint's axis, a unit vector."""
        x, y, z = (row[2] for row in self.E)
        return x, y, z


def motion_in_base(arm: Arm, motion: Motion, mark: Mark) -> list[InBase]:
    """The links of ``arm`` [n] in ``motion``, from base to tip."""
    E, w, alpha = IDENTITY_3, ZERO, ZERO
    gx, gy, gz = arm.gravity
    a: Vector = (-gx, -gy, -gz)
    links = []
    for i, body in enumerate(arm.bodies):
        qd, qdd = motion.qd[i], motion.qdd[i]
        p = named(mark, turned(E, origin(body, motion.d[i])), i + 1, "pb")
        a = plus(a, cross(alpha, p), cross(w, cross(w, p)))
        E = marked(mark, product(E, rotation(body, motion.c[i], motion.s[i])), i + 1, "E")
        z = (E[0][2], E[1][2], E[2][2])
        rate = scaled(qd, z)
        if body.revolute:
            alpha = plus(alpha, cross(w, rate), scaled(qdd, z))
            w = plus(w, rate)
        else:
            a = plus(a, scaled(2, cross(w, rate)), scaled(qdd, z))
        w, alpha = named(mark, w, i + 1, "wb"), named(mark, alpha, i + 1, "alphab")
        a = named(mark, a, i + 1, "ab")
        links.append(InBase(E, p, w, alpha, a))
    return links


def turned(E: Matrix, u: Vector) -> Vector:
    """``E u``."""
    x, y, z = applied(E, u)
    return x, y, z


def along(body: Body, axis: Vector, force: Vector, moment: Vector) -> Any:
    """What of ``moment`` [N m], or of ``force`` [N] at a prismatic joint, is along the joint's ``axis``."""
    x, y, z = moment if body.revolute else force
    return axis[0] * x + axis[1] * y + axis[2] * z
