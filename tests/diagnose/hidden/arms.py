"""The arms of the blind tests, with the motors and limits that their files leave out."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np

from peers.numbers import number
from robodyn.robot import load
from robodyn.robot.model import Inertia, Joint, Limits, Link, Robot
from robodyn.robot.values import Value

ARMS = ("puma560", "puma560_3dof", "stanford", "ur10")

#: Rotor inertias [kg m^2] of a UR-like arm, reflected to the joint.
_UR_ROTORS = ("3.2", "3.2", "1.6", "0.35", "0.35", "0.35")
_UR = Limits((Fraction("-2.6"), Fraction("2.6")), Fraction("2.1"), Fraction(8))
_STANFORD = Limits((Fraction("-2.6"), Fraction("2.6")), Fraction("2.5"), Fraction(8))
_SLIDE = Limits((Fraction("0.15"), Fraction("0.95")), Fraction("0.7"), Fraction(3))

#: Friction of the joints as shares of the rotor inertia: a rate [1/s] and an acceleration [rad/s^2].
_VISCOUS, _COULOMB = Fraction("0.8"), Fraction("1.6")


def bare(name: str) -> Robot:
    """The bundled arm with motors and limits at every joint."""
    robot = load(name, warn=lambda _: None)
    if name == "puma560":
        return robot
    if name == "puma560_3dof":
        whole = load("puma560", warn=lambda _: None).links
        pairs = zip(robot.links, whole, strict=False)
        kept = [replace(a, joint=replace(a.joint, limits=b.joint.limits)) for a, b in pairs]
        return replace(robot, links=tuple(kept))
    links = []
    for i, link in enumerate(robot.links):
        limits = _UR if name == "ur10" else _SLIDE if link.joint.kind == "prismatic" else _STANFORD
        joint = replace(link.joint, limits=limits)
        if name == "ur10":
            joint = replace(joint, motor_inertia=Fraction(_UR_ROTORS[i]))
        links.append(replace(link, joint=joint))
    return replace(robot, links=tuple(links))


def rubbing(robot: Robot) -> Robot:
    """With viscous and Coulomb friction at every joint, in the plain keys."""

    def rubbed(joint: Joint) -> Joint:
        rotor = Fraction(round(number(joint.motor_inertia) * 100), 100)
        return replace(joint, viscous=_VISCOUS * rotor, coulomb=_COULOMB * rotor)

    return replace(robot, links=tuple(replace(link, joint=rubbed(link.joint)) for link in robot.links))


def perturbed(robot: Robot, share: float, seed: int) -> Robot:
    """Masses, centres and inertias off by about ``share`` (standard deviation), and confidence saying so."""
    rng = np.random.default_rng((seed, 77))

    def off(link: Link) -> Link:
        def near(value: Value) -> Fraction:
            return Fraction(f"{number(value) * (1 + share * rng.standard_normal()):.9g}")

        i = link.inertia
        x, y, z = (near(c) for c in link.com)
        return replace(
            link,
            mass=near(link.mass),
            com=(x, y, z),
            inertia=Inertia(*(near(v) for v in (i.xx, i.yy, i.zz, i.xy, i.xz, i.yz))),
            confidence=Fraction(str(share)),
        )

    return replace(robot, links=tuple(map(off, robot.links)))
