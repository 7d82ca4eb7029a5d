"""Frames whose z axes are a chain's joint axes."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from robodyn.formats.chain import ChainJoint, Rotation, Vector, cross, dot, scaled, transposed
from robodyn.formats.exact import rows, vector
from robodyn.robot.limits import QUARTER_TURN
from robodyn.robot.parts import Exact, Rows
from robodyn.robot.rotations import SAME, applied, product
from robodyn.robot.rotations import transposed as exact_transposed


@dataclass(frozen=True, slots=True)
class Step:
    """From the aligned frame of a joint (of the base, for the first) to that of the next, at q = 0.

    ``rotation`` and ``offset`` [m] place the frame in the one before; ``into`` takes vectors of the joint's
    own frame, as the chain has it, into the aligned one.
    """

    rotation: Rows
    offset: Exact
    into: Rows


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
