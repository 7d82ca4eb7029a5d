"""Frames whose z axes are a chain's joint axes, and the turn from one to the next in three angles."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from robodyn.formats.chain import ChainJoint, Rotation, Vector, cross, dot, scaled, transposed
from robodyn.formats.exact import (
    SAME,
    about_x,
    about_z,
    applied,
    direction,
    near_quarter,
    product,
    rows,
    vector,
)
from robodyn.formats.exact import transposed as exact_transposed
from robodyn.formats.limits import QUARTER_TURN
from robodyn.robot.parts import Exact, Rows
from robodyn.robot.values import Angle, quarter_turns


@dataclass(frozen=True, slots=True)
class Step:
    """From the aligned frame of a joint (of the base, for the first) to that of the next, at q = 0.

    ``rotation`` and ``offset`` [m] place the frame in the one before; ``into`` takes vectors of the joint's
    own frame, as the chain has it, into the aligned one.
    """

    rotation: Rows
    offset: Exact
    into: Rows


@dataclass(frozen=True, slots=True)
class Twist:
    """A rotation as ``Rz(phi) Rx(alpha) Rz(theta)``; with ``parallel`` z axes phi is 0, and may be any other
    angle that theta makes up for."""

    phi: Angle
    alpha: Angle
    theta: Angle
    parallel: bool


def aligned(joints: Iterable[ChainJoint]) -> list[Step]:
    """The steps of ``joints``, base to tip."""
    steps = []
    before = SAME
    for joint in joints:
        into = exact_transposed(rows(_onto(joint.axis)))
        turn = product(product(before, rows(joint.pose.rotation)), exact_transposed(into))
        steps.append(Step(turn, applied(before, vector(joint.pose.xyz)), into))
        before = into
    return steps


def twist_of(R: Rows, within: float) -> Twist:
    """The angles of ``R``, multiples of pi/2 where they are ``within`` [rad] of them.

    Each is taken from what the ones before leave of ``R``: where z axes are nearly parallel, phi alone means
    little, and theta makes up for it.
    """
    sine = math.hypot(R[0][2], R[1][2])
    if sine <= within:
        alpha = quarter_turns(0 if R[2][2] > 0 else 2)
        phi = quarter_turns(0)
    else:
        alpha = near_quarter(math.atan2(sine, R[2][2]), within)
        phi = direction(-R[1][2], R[0][2], within)
    left = product(about_x(-alpha), product(about_z(-phi), R))
    return Twist(phi, alpha, direction(left[0][0], left[1][0], within), sine <= within)


def _onto(axis: Vector) -> Rotation:
    """A rotation that takes z to the unit vector ``axis``, as few axes turned as can be."""
    largest = max(range(3), key=lambda k: abs(axis[k]))
    way = math.copysign(1.0, axis[largest])
    if math.hypot(*(axis[k] for k in range(3) if k != largest)) <= QUARTER_TURN:
        z = tuple(way if k == largest else 0.0 for k in range(3))
        x = (1.0, 0.0, 0.0) if largest else (0.0, 0.0, -way)
    else:
        z = scaled(1 / math.hypot(*axis), axis)
        least = min(range(3), key=lambda k: abs(axis[k]))
        unit: Vector = (float(least == 0), float(least == 1), float(least == 2))
        across = tuple(u - dot(unit, z) * v for u, v in zip(unit, z, strict=True))
        x = scaled(1 / math.hypot(*across), across)  # type: ignore[arg-type]
    return transposed((x, cross(z, x), z))  # type: ignore[arg-type]
