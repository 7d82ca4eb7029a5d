"""Recursive Newton-Euler inverse dynamics in the base's frame, over any scalar.

The form before Luh, Walker and Paul: every vector is written along the axes of the base. Positions, rates,
forces and moments then simply add up from link to link, but a link's inertia changes with its pose and has to
be turned into the base in every state, ``E I E^T``. That is what a link's own frame saves.

Source: Stepanenko and Vukobratovic 1976, Dynamics of Articulated Open-Chain Active Mechanisms, Mathematical
Biosciences 28; as Luh, Walker and Paul 1980 and Featherstone and Orin 2000 describe it. The paper was not at
hand: the equations are Newton's and Euler's, the arrangement is ours, in the frames of the other recursions.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Motion, Symmetric
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import Matrix, inner, product
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked
from robodyn.thesis.formulations.base_frame import along, motion_in_base, turned


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
        torques[i] = joint_torque(arm, i, motion, along(body, at.axis, f, moment), mark)
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
