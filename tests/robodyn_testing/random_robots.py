"""Random arms that are physical, awkward and the same for the same seed, and states to try them in.

Every number of a robot drawn here is a short decimal, held exactly, as if read from a file. A link's
inertia is that of a real set of point masses, so it is positive and obeys the triangle inequality; what the
arms are rich in is what breaks generators of code: parallel and antiparallel axes, quarter turns, zero
lengths, centres of mass on an axis, links without mass or without extent, tilted gravity.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Final, Literal, TypeVar

import numpy as np
from numpy.typing import NDArray

from robodyn.robot.model import Inertia, Joint, JointKind, Link, Robot
from robodyn.robot.values import PI, Angle, angle

__all__ = ["LinkKind", "States", "random_robot", "random_states"]

LinkKind = Literal["full", "diagonal", "rod", "point", "inertia_only", "massless"]
States = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
T = TypeVar("T")
Triple = tuple[Fraction, Fraction, Fraction]

MAX_JOINTS: Final = 9
ZERO: Final = Fraction(0)


def random_robot(
    seed: int,
    *,
    joints: int | None = None,
    full: bool = True,
    prismatic: float = 0.25,
    generic_angles: float = 0.3,
    parallel: float = 0.35,
    zeros: float = 0.25,
    degenerate: float = 0.2,
    motors: float = 0.5,
    friction: float = 0.4,
    exotic: float = 0.15,
    aside: float = 0.0,
) -> Robot:
    """Return the random arm number ``seed``: equal arguments give an equal robot, on any machine.

    ``joints`` is the number of joints, drawn from 1 to 9 where it is None. With ``full`` false no inertia
    tensor has products. The rest are probabilities: of a ``prismatic`` joint; of an angle that is no multiple
    of pi/2 (``generic_angles``); of a consecutive axis that is ``parallel`` to the one before it (alpha 0 or
    pi); of a length or a coordinate of a centre of mass that is zero (``zeros``); of a link that is a thin
    rod, a point, an inertia without mass, or nothing at all (``degenerate``); of a joint with rotor inertia
    (``motors``); of one with ``friction``; and of each of smoothed friction at rest, torque on the link's
    side and gravity switched off (``exotic``); of an offset ``b`` that no row of DH numbers has (``aside``,
    which leaves the other draws as they are). At least one link is always a solid body.
    """
    rng = random.Random(seed)
    n = joints if joints is not None else rng.randint(1, MAX_JOINTS)
    if n < 1:
        raise ValueError(f"joints: found {n}, expected at least 1")
    kinds = [_link_kind(rng, full, degenerate) for _ in range(n)]
    kinds[rng.randrange(n)] = "full" if full else "diagonal"
    links = []
    for i, kind in enumerate(kinds):
        joint_kind: JointKind = "prismatic" if rng.random() < prismatic else "revolute"
        joint = Joint(
            kind=joint_kind,
            alpha=_twist(rng, parallel, generic_angles),
            a=_length(rng, zeros),
            d=_length(rng, zeros),
            theta=_angle(rng, generic_angles),
        )
        motor_inertia, viscous, coulomb = _drive(rng, joint_kind, motors, friction)
        joint = replace(joint, motor_inertia=motor_inertia, viscous=viscous, coulomb=coulomb)
        mass, inertia = _mass_distribution(rng, kind)
        com = _com(rng, zeros) if mass else (ZERO, ZERO, ZERO)
        links.append(Link(name=f"link_{i + 1}", joint=joint, mass=mass, com=com, inertia=inertia))
    return Robot(
        name=f"random_{seed}",
        links=tuple(_aside(links, random.Random(~seed), aside)),
        title=f"random arm {seed}, {n} joint{'s' if n > 1 else ''}",
        gravity=(ZERO, ZERO, ZERO) if rng.random() < exotic / 3 else _gravity(rng),
        torque_side="link" if rng.random() < exotic else "motor",
        rest_velocity=_pick(rng, (Fraction(1, 100), Fraction(1, 10))) if rng.random() < exotic else None,
    )


def _aside(links: Sequence[Link], rng: random.Random, share: float) -> list[Link]:
    """``links`` with offsets ``b`` at a ``share`` of their joints."""
    offsets = [_length(rng, 0.0) if rng.random() < share else ZERO for _ in links]
    return [replace(one, joint=replace(one.joint, b=b)) for one, b in zip(links, offsets, strict=True)]


def random_states(robot: Robot, N: int, seed: int) -> States:
    """Return ``N`` states: ``q`` [rad or m], ``qd`` and ``qdd`` (per s, per s^2), each [N, n].

    The first is all zero, the second at rest, the third moves one joint in two, as far as N allows. Every
    number is a single-precision one, so that a float kernel is given the same state as the double.
    """
    rng = np.random.Generator(np.random.PCG64(seed))
    revolute = np.array([link.joint.kind == "revolute" for link in robot.links])
    q = rng.uniform(-1, 1, (N, robot.n)) * np.where(revolute, math.pi, 1.0)
    qd = rng.uniform(-1, 1, (N, robot.n)) * np.where(revolute, 4.0, 1.5)
    qdd = rng.uniform(-1, 1, (N, robot.n)) * np.where(revolute, 15.0, 8.0)
    q[:1] = qd[:1] = qdd[:1] = 0.0
    qd[1:2] = 0.0
    qd[2:3, ::2] = 0.0
    q, qd, qdd = (x.astype(np.float32).astype(np.float64) for x in (q, qd, qdd))
    return q, qd, qdd


def _pick(rng: random.Random, choices: Sequence[T]) -> T:
    """One of ``choices``, all equally likely."""
    return choices[rng.randrange(len(choices))]


def _decimal(rng: random.Random, low: float, high: float, places: int) -> Fraction:
    """A decimal fraction in [low, high] with so many places after the point."""
    scale = 10**places
    return Fraction(rng.randint(math.ceil(low * scale), math.floor(high * scale)), scale)


def _angle(rng: random.Random, generic: float) -> Angle:
    """A multiple of pi/2, or (with probability ``generic``) any decimal number of radians."""
    if rng.random() < generic:
        return angle(_decimal(rng, -3.1, 3.1, 3))
    return angle(_pick(rng, (0, 0, 0, 1, -1, 2)) * PI / 2)


def _twist(rng: random.Random, parallel: float, generic: float) -> Angle:
    """alpha: parallel axes, else a right angle or a generic one."""
    if rng.random() < parallel:
        return angle(_pick(rng, (0, 0, 2)) * PI / 2)
    if rng.random() < generic:
        return angle(_decimal(rng, -3.1, 3.1, 3))
    return angle(_pick(rng, (1, -1)) * PI / 2)


def _length(rng: random.Random, zeros: float) -> Fraction:
    """a or d [m]."""
    return ZERO if rng.random() < zeros else _decimal(rng, -0.8, 0.8, 4)


def _com(rng: random.Random, zeros: float) -> Triple:
    """A centre of mass [m], each coordinate zero with probability ``zeros``."""
    x, y, z = (ZERO if rng.random() < zeros else _decimal(rng, -0.3, 0.3, 3) for _ in range(3))
    return x, y, z


def _gravity(rng: random.Random) -> Triple:
    """Gravity [m/s^2] along an axis of the base, or in any direction."""
    if rng.random() < 0.3:
        axis, g = rng.randrange(3), _pick(rng, (Fraction(-981, 100), Fraction(-98, 10), Fraction(981, 100)))
        return (g if axis == 0 else ZERO, g if axis == 1 else ZERO, g if axis == 2 else ZERO)
    height, turn = rng.uniform(-1, 1), rng.uniform(-math.pi, math.pi)
    flat = math.sqrt(1 - height * height)
    x, y, z = (Fraction(round(981 * u), 100) for u in (flat * math.cos(turn), flat * math.sin(turn), height))
    return x, y, z


def _drive(rng: random.Random, kind: JointKind, motors: float, friction: float) -> Triple:
    """Rotor inertia, viscous and Coulomb friction of a joint."""
    motor_inertia = viscous = coulomb = ZERO
    if rng.random() < motors:
        motor_inertia = _decimal(rng, 0.01, 5.0 if kind == "revolute" else 20.0, 2)
    if rng.random() < friction:
        which = _pick(rng, ("viscous", "coulomb", "both"))
        if which != "coulomb":
            viscous = _decimal(rng, 0.01, 5.0, 2)
        if which != "viscous":
            coulomb = _decimal(rng, 0.01, 8.0, 2)
    return motor_inertia, viscous, coulomb


def _link_kind(rng: random.Random, full: bool, degenerate: float) -> LinkKind:
    """What sort of body a link is."""
    if rng.random() < degenerate:
        odd: tuple[LinkKind, ...] = ("rod", "point", "inertia_only", "massless")
        return _pick(rng, odd)
    return "full" if full and rng.random() < 0.8 else "diagonal"


def _mass_distribution(rng: random.Random, kind: LinkKind) -> tuple[Fraction, Inertia]:
    """Mass [kg] and inertia about the centre of mass [kg m^2] of pairs of points opposite one another.

    A pair of masses w/2 at u and -u leaves the centre of mass where it is and adds w (u.u E - u u^T).
    """
    if kind == "massless":
        return ZERO, Inertia()
    if kind == "inertia_only":  # like link 1 of the thesis's PUMA
        return ZERO, Inertia(zz=_decimal(rng, 0.05, 0.9, 2))
    weights = [_decimal(rng, 0.2, _pick(rng, (0.8, 2.0, 6.0)), 2) for _ in range(1 if kind == "rod" else 4)]
    if kind == "point":
        return sum(weights, ZERO), Inertia()
    xx = yy = zz = xy = xz = yz = ZERO
    for k, w in enumerate(weights):
        x, y, z = (_decimal(rng, 0.02, 0.3, 2) * _pick(rng, (1, -1)) for _ in range(3))
        if kind != "full":  # along one axis of the link
            axis = (k + rng.randrange(3) * (kind == "rod")) % 3
            x, y, z = (u if axis == i else ZERO for i, u in enumerate((x, y, z)))
        xx, yy, zz = xx + w * (y * y + z * z), yy + w * (x * x + z * z), zz + w * (x * x + y * y)
        xy, xz, yz = xy - w * x * y, xz - w * x * z, yz - w * y * z
    return sum(weights, ZERO), Inertia(xx=xx, yy=yy, zz=zz, xy=xy, xz=xz, yz=yz)
