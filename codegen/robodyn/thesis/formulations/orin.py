"""Orin's recursive Newton-Euler inverse dynamics in mixed frames, over any scalar.

Motion is followed along the axes of the base, as before him; forces and moments are formed and handed down
along the axes of each link, where its inertia is constant. What a link's force needs of the motion is turned
into the link once: the acceleration of its origin, its angular velocity and acceleration.

Source: Orin, McGhee, Vukobratovic and Hartoch 1979, Kinematic and Kinetic Analysis of Open-Chain Linkages
Utilizing Newton-Euler Methods, Mathematical Biosciences 43, as Luh, Walker and Paul 1980 and Featherstone and
Orin 2000 describe it. The paper was not at hand: which vector it keeps in which frame beyond that, and its
counts, could not be checked; the arrangement is ours.
"""

from __future__ import annotations

from typing import Any

from robodyn.dynamics.arm import Arm, Motion, into_parent, origin
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.transforms import transposed, turned
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled, unmarked
from robodyn.thesis.formulations.newton_euler_base import motion_in_base


def orin(arm: Arm, motion: Motion, mark: Mark = unmarked) -> list[Any]:
    """Joint torques [n] (N m; N at prismatic joints) of ``arm`` in ``motion``."""
    links = motion_in_base(arm, motion, mark)
    f: Vector = ZERO
    moment: Vector = ZERO
    torques: list[Any] = [None] * len(links)
    for i in reversed(range(len(links))):
        body, at, r = arm.bodies[i], links[i], arm.bodies[i].com
        into_link = transposed(at.E)
        w = named(mark, turned(into_link, at.w), i + 1, "w")
        alpha = named(mark, turned(into_link, at.alpha), i + 1, "alpha")
        a = named(mark, turned(into_link, at.a), i + 1, "a")
        a_com = named(mark, plus(a, cross(alpha, r), cross(w, cross(w, r))), i + 1, "ac")
        force = named(mark, scaled(body.mass, a_com), i + 1, "fc")
        euler = plus(body.inertia.times(alpha), cross(w, body.inertia.times(w)))
        moment = plus(named(mark, euler, i + 1, "nc"), moment, cross(r, force))
        if i + 1 < len(links):
            moment = plus(moment, cross(origin(arm.bodies[i + 1], motion.d[i + 1]), f))
        f = named(mark, plus(force, f), i + 1, "f")
        moment = named(mark, moment, i + 1, "n")
        torques[i] = joint_torque(arm, i, motion, moment[2] if body.revolute else f[2], mark)
        f = into_parent(body, motion.c[i], motion.s[i], f)
        moment = into_parent(body, motion.c[i], motion.s[i], moment)
    return torques
