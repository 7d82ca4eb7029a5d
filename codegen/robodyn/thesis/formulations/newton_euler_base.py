"""Recursive Newton-Euler inverse dynamics in the base's frame, over any scalar.

The form before Luh, Walker and Paul: every vector is written along the axes of the base. Positions, rates,
forces and moments then simply add up from link to link, but a link's inertia changes with its pose and has to
be turned into the base in every state, ``E I E^T``. That is what a link's own frame saves.

Source: Stepanenko and Vukobratovic 1976, Dynamics of Articulated Open-Chain Active Mechanisms, Mathematical
Biosciences 28; as Luh, Walker and Paul 1980 and Featherstone and Orin 2000 describe it. The paper was not at
hand: the equations are Newton's and Euler's, the arrangement is ours, in the frames of the other recursions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import IDENTITY_3, Matrix, inner, marked, product, rotation, turned
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, dot, named, plus, scaled, unmarked


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


def newton_euler_base(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    links = motion_in_base(arm, motion, mark)
    f: Vector = ZERO
    moment: Vector = ZERO
    torques: list[Any] = [None] * len(links)
    for i in reversed(range(len(links))):
        body, at = arm.bodies[i], links[i]
        r = named(mark, turned(at.E, body.com), i + 1, "rb")
        a_com = plus(at.a, cross(at.alpha, r), cross(at.w, cross(at.w, r)))
        force = named(mark, scaled(body.mass, a_com), i + 1, "fcb")
        inertia = inertia_in_base(at.E, body.inertia)
        euler = plus(inertia.times(at.alpha), cross(at.w, inertia.times(at.w)))
        moment = plus(named(mark, euler, i + 1, "ncb"), moment, cross(r, force))
        if i + 1 < len(links):
            moment = plus(moment, cross(links[i + 1].p, f))
        f = named(mark, plus(force, f), i + 1, "fb")
        moment = named(mark, moment, i + 1, "nb")
        torques[i] = joint_torque(arm, i, motion, dot(at.axis, moment if body.revolute else f), mark)
    return torques


def inertia_in_base(E: Matrix, inertia: Symmetric) -> Symmetric:
    """``E I E^T`` [kg m^2], of which six entries are formed."""
    rows: Matrix = (
        (inertia.xx, inertia.xy, inertia.xz),
        (inertia.xy, inertia.yy, inertia.yz),
        (inertia.xz, inertia.yz, inertia.zz),
    )
    half = product(E, rows)
    xx, yy, zz, xy, xz, yz = (
        inner(half[i], E[j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    )
    return Symmetric(xx, yy, zz, xy, xz, yz)
