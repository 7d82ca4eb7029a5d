"""Frames whose z axes are a chain's joint axes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from robodyn.formats.chain import ChainJoint, Rotation, Vector, cross, dot, scaled, transposed
from robodyn.formats.exact import rows, vector
from robodyn.robot.parts import Exact, JointKind, Rows
from robodyn.robot.rotations import QUARTER_TURN, SAME, applied, product
from robodyn.robot.rotations import transposed as exact_transposed
from robodyn.robot.values import ZERO


@dataclass(frozen=True, slots=True)
class Step:
    """From the aligned frame of a joint (of the base, for the first) to that of the next, at q = 0.

    ``rotation`` and ``offset`` [m] place the frame in the one before; ``into`` takes vectors of the joint's
    own frame, as the chain has it, into the aligned one, whose origin is ``shift`` [m] away from the chain's.
    """

    rotation: Rows
    offset: Exact
    into: Rows
    shift: Exact = (ZERO, ZERO, ZERO)

    def seen(self, point: Exact) -> Exact:
        """A point of the joint's own frame in the aligned one [m]."""
        return minus(applied(self.into, point), self.shift)


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


def with_free_lines(steps: Sequence[Step], kinds: Sequence[JointKind]) -> list[Step]:
    """``steps`` with the lines of prismatic joints put where they save offsets; any parallel line serves.

    A line goes through the next origin, so that the next row has no offset across it; behind the last joint
    that turns there is none to go through, and lines go through the origin before.
    """
    moved = list(steps)
    last = max((i for i, kind in enumerate(kinds) if kind == "revolute"), default=-1)
    for i in reversed(range(last)):
        if kinds[i] == "prismatic":
            x, y, _ = moved[i + 1].offset
            _shift(moved, i, (x, y, ZERO))
    for i in range(max(last + 1, 1), len(moved)):
        x, y, z = applied(exact_transposed(moved[i].rotation), moved[i].offset)
        _shift(moved, i, (-x, -y, -z))
    return moved


def _shift(steps: list[Step], i: int, by: Exact) -> None:
    """Move the origin of frame ``i`` by a vector in it."""
    step = steps[i]
    x, y, z = applied(step.rotation, by)
    offset = (step.offset[0] + x, step.offset[1] + y, step.offset[2] + z)
    steps[i] = replace(step, offset=offset, shift=by)
    if i + 1 < len(steps):
        steps[i + 1] = replace(steps[i + 1], offset=minus(steps[i + 1].offset, by))


def minus(u: Exact, v: Exact) -> Exact:
    """``u - v``."""
    return u[0] - v[0], u[1] - v[1], u[2] - v[2]


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
