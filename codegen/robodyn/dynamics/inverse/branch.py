"""Positions of some of an arm's joints, and what is known of them: a branch as it grows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from functools import partial
from typing import Any

from robodyn.dynamics.inverse.limits import TOLERANCE
from robodyn.dynamics.inverse.screws import Axis, Circle, opposite, sum_of, turned
from robodyn.dynamics.inverse.subproblems import (
    One,
    Scale,
    Two,
    both,
    either,
    folding,
    is_number,
    reaching,
    slides,
    turning_onto,
)
from robodyn.dynamics.vectors import Vector


@dataclass(frozen=True, slots=True)
class Branch:
    """``positions`` by joint (from 0): angles as (cos, sin), lengths [m].

    ``exists``: whether all equations had an answer; ``singular``: whether two met, or one was free;
    ``signs``: which of two answers was taken, by joint.
    """

    positions: Mapping[int, Any] = field(default_factory=dict)
    exists: Any = 1
    singular: Any = 0
    signs: tuple[tuple[int, int], ...] = ()

    def each(self, joint: int, two: Two) -> Iterator[Branch]:
        """With the two positions of ``joint``, one after the other."""
        for sign, answer in zip((1, -1), two.answers, strict=True):
            yield self.sided(joint, sign, answer, two.exist, two.meet)

    def sided(self, joint: int, sign: int, answer: Any, exist: Any, meet: Any) -> Branch:
        """With that of the two positions of ``joint``."""
        return Branch(
            {**self.positions, joint: answer},
            both(self.exists, exist),
            either(self.singular, meet),
            (*self.signs, (joint, sign)),
        )

    def one(self, joint: int, one: One) -> Branch:
        """With the position of ``joint``."""
        return Branch(
            {**self.positions, joint: one.answer},
            self.exists,
            either(self.singular, one.meet),
            self.signs,
        )

    def known(self, joint: int, position: Any) -> Branch:
        """With a ``position`` of ``joint`` that follows from the others."""
        return Branch({**self.positions, joint: position}, self.exists, self.singular, self.signs)

    def inward_of(self, axes: Sequence[Axis], v: Vector) -> Vector:
        """A vector before some axes, from base to tip, seen from behind them; turns about axes that are
        parallel and follow each other are one."""
        k = 0
        while k < len(axes):
            axis, angle = axes[k], self.positions[axes[k].joint]
            k += 1
            if not axis.revolute:
                continue
            while k < len(axes) and axes[k].revolute and axes[k].direction == axis.direction:
                angle = sum_of(angle, self.positions[axes[k].joint])
                k += 1
            v = turned(axis.direction, opposite(angle), v)
        return v

    def outward(self, axis: Axis, v: Vector) -> Vector:
        """A vector behind a revolute ``axis``, seen from before it."""
        return turned(axis.direction, self.positions[axis.joint], v)

    def inward(self, axis: Axis, v: Vector) -> Vector:
        """A vector before a revolute ``axis``, seen from behind it."""
        return turned(axis.direction, opposite(self.positions[axis.joint]), v)


@dataclass(frozen=True, slots=True)
class Setting:
    """What the equations of an arm share: where free joints are taken to be, ``near`` by joint; the arm's
    ``size``, no shorter than any lever [m]; the rounding ``unit``."""

    near: Callable[[int], Circle]
    size: Fraction
    unit: Fraction

    def onto(self, axis: Axis, v: Vector, onto: Vector, lengths: int = 0, *, lever: Any = 0) -> One:
        """See :func:`turning_onto`; ``lengths``: how many of the two vectors are not unit vectors. ``lever``:
        a number that is not 0 where ``v`` is never along the axis."""
        sure = is_number(lever) and abs(lever) > TOLERANCE * self.size
        near = None if sure else partial(self.near, axis.joint)
        return turning_onto(v, onto, axis.direction, near, self.scale(lengths))

    def reach(self, axis: Axis, v: Vector, along: Vector, distance: Any, lengths: int = 0) -> Two:
        """See :func:`reaching`."""
        near = partial(self.near, axis.joint)
        return reaching(v, along, distance, axis.direction, near, self.scale(lengths))

    def fold(self, axis: Axis, b: Vector, c: Vector, square: Any) -> Two:
        """See :func:`folding`."""
        near = partial(self.near, axis.joint)
        return folding(b, c, square, axis.direction, near, self.scale(2))

    def slide(self, p: Any, q: Any) -> Two:
        """See :func:`slides`."""
        return slides(p, q, self.scale(1))

    def scale(self, lengths: int) -> Scale:
        """That of products of so many lengths and unit vectors."""
        return Scale(self.unit, self.size, lengths)


@dataclass(frozen=True, slots=True)
class Sum:
    """The position of a joint as an angle less those of others, ``minus``: joints with +1, or -1 where the
    axis points the other way."""

    angle: Circle
    minus: tuple[tuple[int, int], ...]
