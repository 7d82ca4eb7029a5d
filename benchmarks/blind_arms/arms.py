"""The arms of the blind tests, with the motors and limits that their files leave out."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import numpy as np
from benchmarks.blind_arms.random_arms import random_arm

from peers.numbers import inertia_tensor, number
from robodyn.robot import load, read_text
from robodyn.robot.model import Inertia, Joint, Limits, Link, Robot
from robodyn.robot.values import Value

ARMS = ("puma560", "puma560_3dof", "stanford", "ur10")
#: Arms that the tool was not looked at with while it was written.
FURTHER_ARMS = ("ur5", "panda", "rx90")
#: Arms that are only pushed, and with signs flipped.
LATER_ARMS = ("iiwa", "tx40")

#: Names of drawn arms: this and a seed.
RANDOM = "random_"

#: Rotor inertias [kg m^2] of a UR-like arm, reflected to the joint.
_UR_ROTORS = ("3.2", "3.2", "1.6", "0.35", "0.35", "0.35")
_ROTORS = {
    "ur10": _UR_ROTORS,
    "ur5": ("1.4", "1.4", "0.8", "0.12", "0.12", "0.12"),
    "panda": ("0.6", "0.6", "0.5", "0.5", "0.2", "0.2", "0.2"),
    "rx90": ("2.5", "2.5", "1.2", "0.4", "0.3", "0.2"),
    "iiwa": ("1.2", "1.2", "0.8", "0.8", "0.4", "0.3", "0.3"),
    "tx40": ("0.6", "0.6", "0.3", "0.1", "0.08", "0.04"),
}
_UR = Limits((Fraction("-2.6"), Fraction("2.6")), Fraction("2.1"), Fraction(8))
_STANFORD = Limits((Fraction("-2.6"), Fraction("2.6")), Fraction("2.5"), Fraction(8))
_SLIDE = Limits((Fraction("0.15"), Fraction("0.95")), Fraction("0.7"), Fraction(3))

#: Friction of the joints as shares of the rotor inertia: a rate [1/s] and an acceleration [rad/s^2].
_VISCOUS, _COULOMB = Fraction("0.8"), Fraction("1.6")


def index_of(arm: str) -> int:
    """A number of the arm's own, for seeds."""
    if arm.startswith(RANDOM):
        return int(arm.removeprefix(RANDOM))
    return (*ARMS, *FURTHER_ARMS, *LATER_ARMS).index(arm)


@cache
def bare(name: str) -> Robot:
    """The arm with motors and limits at every joint: a bundled one, or ``random_SEED``."""
    if name.startswith(RANDOM):
        return read_text(random_arm(index_of(name)))
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
        limits = _UR if name in _ROTORS else _SLIDE if link.joint.kind == "prismatic" else _STANFORD
        joint = replace(link.joint, limits=limits)
        if name in _ROTORS:
            joint = replace(joint, motor_inertia=Fraction(_ROTORS[name][i]))
        links.append(replace(link, joint=joint))
    return replace(robot, links=tuple(links))


def rubbing(robot: Robot) -> Robot:
    """With viscous and Coulomb friction at every joint, in the plain keys; a random arm's is its own."""
    rng = np.random.default_rng(index_of(robot.name)) if robot.name.startswith(RANDOM) else None

    def rubbed(joint: Joint) -> Joint:
        if rng is not None:
            viscous, coulomb = number(joint.motor_inertia) * np.exp(rng.normal(0, 0.5, 2))
            return replace(joint, viscous=_VISCOUS * _exact(viscous), coulomb=_COULOMB * _exact(coulomb))
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


def misjudged(robot: Robot, share: float, seed: int) -> Robot:
    """Masses, centres and inertias off by about ``share``, as of bodies that could be: the mass by its own
    share, and all of the body stretched along three axes. ``confidence`` is left as it is."""
    rng = np.random.default_rng((seed, 78))

    def off(link: Link) -> Link:
        stretch = np.exp(share / 2 * rng.standard_normal(3))
        heavier = float(np.exp(share * rng.standard_normal()))
        i = link.inertia
        # Second moments of the mass about its centre, which a stretch changes by its factors.
        tensor = inertia_tensor(i)
        spread = (np.trace(tensor) / 2 * np.eye(3) - tensor) * np.outer(stretch, stretch) * heavier
        wrong = np.trace(spread) * np.eye(3) - spread
        x, y, z = (_exact(number(c) * stretch[k]) for k, c in enumerate(link.com))
        return replace(
            link,
            mass=_exact(number(link.mass) * heavier),
            com=(x, y, z),
            inertia=Inertia(*(_exact(wrong[k]) for k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))),
        )

    return replace(robot, links=tuple(map(off, robot.links)))


def _exact(value: float) -> Fraction:
    return Fraction(f"{value:.9g}")
