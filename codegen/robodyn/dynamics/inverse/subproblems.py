"""Equations of one angle that inverse kinematics is put together from, over any scalar, and a branch of it as
it grows with their answers.

After Paden (1986) and Kahan, as Elias and Wen have them (IK-Geo, 2022), with three differences. Angles stay
pairs of cosine and sine until the last. Every equation has an answer for whatever it is given, in least
squares where there is none, from a reference where there are too many, with 0 or 1 for what was the case.
And they are asked in an order in which each takes up what the ones before rounded: poses close to rounding
error even where single angles are ill-determined.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

from robodyn.dynamics.inverse.limits import EDGE, FOLD, LEVER, TOLERANCE
from robodyn.dynamics.inverse.screws import Axis, across, opposite, turned
from robodyn.dynamics.vectors import Vector, cross, dot
from robodyn.effects.scalars import choose, is_zero, magnitude, root
from robodyn.ir.evaluate import Circle, turn


class Two(NamedTuple):
    """Two answers, whether there are any (1 or 0), and whether they meet or are free (1 or 0).

    ``beyond``: how far what was wanted is beyond what is reached; ``side``: how far ``R v`` is across that
    and the axis, ``along . (R v x axis)``, the first answer having it on the positive side; ``lever``: the
    square of how long the lever is, lengths as shares of the arm's size; a number where that is known.
    """

    answers: tuple[Any, Any]
    exist: Any
    meet: Any
    beyond: Any = 0
    side: Any = 0
    lever: Any = 1


class One(NamedTuple):
    """An answer, whether it is free (1 or 0), and the square of its ``lever``, as of two."""

    answer: Any
    meet: Any
    lever: Any = 1


class Sum(NamedTuple):
    """The position of a joint as an angle less those of others, ``minus``: joints with +1, or -1 where the
    axis points the other way."""

    angle: Circle
    minus: tuple[tuple[int, int], ...]


@dataclass(frozen=True, slots=True)
class Branch:
    """Positions of some of an arm's joints: ``positions`` by joint (from 0), angles as (cos, sin), lengths
    [m].

    ``exists``: whether all equations had an answer; ``singular``: whether two met, or one was free;
    ``signs``: which of two answers was taken, by joint. Of an arm of four or five joints ``placed``: whether
    the tool's place is reached, and ``off``: by what angle its rotation is not [rad].
    """

    positions: Mapping[int, Any] = field(default_factory=dict)
    exists: Any = 1
    singular: Any = 0
    signs: tuple[tuple[int, int], ...] = ()
    placed: Any = 0
    off: Any = 0

    def with_each(self, joint: int, two: Two) -> Iterator[Branch]:
        """With the two positions of ``joint``, one after the other."""
        for sign, answer in zip((1, -1), two.answers, strict=True):
            yield self.with_side(joint, sign, answer, two.exist, two.meet)

    def with_side(self, joint: int, sign: int, answer: Any, exist: Any, meet: Any) -> Branch:
        """With that of the two positions of ``joint``."""
        positions, signs = {**self.positions, joint: answer}, (*self.signs, (joint, sign))
        return Branch(positions, both(self.exists, exist), either(self.singular, meet), signs)

    def with_answer(self, joint: int, one: One) -> Branch:
        """With the position of ``joint``."""
        positions = {**self.positions, joint: one.answer}
        return Branch(positions, self.exists, either(self.singular, one.meet), self.signs)

    def with_position(self, joint: int, position: Any) -> Branch:
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
                angle = turn(angle, self.positions[axes[k].joint])
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
    ``size``, no shorter than any lever [m]; the rounding ``unit``.

    How large levers may be, and how exactly they are known, depends on how many ``lengths``, no longer than
    ``size``, they are products of; other vectors are unit vectors.
    """

    near: Callable[[int], Circle]
    size: Fraction
    unit: Fraction

    @property
    def edge(self) -> Fraction:
        """See :data:`~robodyn.dynamics.inverse.limits.EDGE`."""
        return EDGE * self.unit

    def _floor(self, lengths: int) -> Fraction:
        """The square of a lever that is nothing but rounding."""
        own = LEVER * self.unit * (self.size if lengths else 1)
        return own ** (2 * max(1, lengths))

    def _short(self, lengths: int) -> Fraction:
        """The square of a lever so short that what it turns is singular."""
        return self.edge ** max(1, lengths) * self.size ** (2 * lengths)

    def onto(self, axis: Axis, v: Vector, onto: Vector, lengths: int = 0, *, lever: Any = 0) -> One:
        """The angle about ``axis`` that turns ``v`` onto ``onto``, or nearest to it, that of the reference
        where it is the same for every angle. ``lever``: a number that is not 0 where ``v`` is never along the
        axis, and that does not occur where there is an answer."""
        c, s = dot(across(axis.direction, v), onto), dot(cross(axis.direction, v), onto)
        square, floor = c * c + s * s, self._floor(lengths)
        if is_number(lever) and abs(lever) > TOLERANCE * self.size:
            length = 1 / real_root(square + floor)
            return One((c * length, s * length), 0)
        free = choose(square - floor, 0, 1)
        length = 1 / real_root(choose(free, 1, square))
        meet = choose(square - self._short(lengths), 0, 1)
        answer = chosen(free, self.near(axis.joint), (c * length, s * length))
        return One(answer, meet, square / self.size ** (2 * lengths))

    def reach(
        self,
        axis: Axis,
        v: Vector,
        along: Vector,
        distance: Any,
        lengths: int = 0,
        margins: tuple[Any, Any, Any] | None = None,
    ) -> Two:
        """The two angles about ``axis`` at which ``v``, turned, is ``distance`` along the vector ``along``:
        ``along . R v = distance``. Where none is, the nearest, twice; that of the reference, and for two that
        are always half a turn apart the other side of it, where all are. ``margins``: how far what turns of
        ``distance`` is from its lowest and highest values, where that is known better, and how exactly."""
        base = across(axis.direction, v)
        x, y = dot(along, base), dot(along, cross(axis.direction, v))
        square = x * x + y * y
        if margins is None:
            b = distance - dot(along, axis.direction) * dot(axis.direction, v)
        else:
            b = (margins[0] - margins[1]) / 2
        known = is_number(square) and square != 0
        floor = Fraction(0) if known else self._floor(lengths)
        free = 0 if known else choose(square - floor, 0, 1)
        blunt = 0 if known else choose(square - self._short(lengths), 0, 1)
        if is_zero(b):  # whatever the lever is, its two perpendiculars
            most = real_root(square)
            share = 1 / choose(free, 1, most)
            c, s = -(y * share), x * share
            c, s = (c, s) if known else chosen(free, self.near(axis.joint), (c, s))
            return Two(((c, s), (-c, -s)), 1, blunt, side=most, lever=square / self.size ** (2 * lengths))
        rest = square - b * b if margins is None else margins[0] * margins[1]
        most = real_root(square)
        slack = self.edge * (most if known else self.size**lengths)
        exist = choose(rest + slack * (2 * most + slack), 1, 0)
        meet = either(blunt, choose(self.edge * square - rest, 1, 0))
        if margins is None:
            side = real_root(choose(rest, rest, 0))
        else:  # folded or stretched to within rounding is folded or stretched: the two answers are one
            low, high, noise = margins
            side = real_root(choose(low - noise, choose(high - noise, rest, 0), 0))
        # Beyond reach, x^2 + y^2 < b^2: the root is 0, and what is left is brought back onto the circle.
        share = 1 / choose(free, 1, choose(rest, square, most * magnitude(b)))
        one = ((x * b - y * side) * share, (y * b + x * side) * share)
        other = ((x * b + y * side) * share, (y * b - x * side) * share)
        if not known:
            one = chosen(free, self.near(axis.joint), one)
            other = chosen(free, self.near(axis.joint), other)
        beyond = choose(rest, 0, choose(b, b - most, b + most))
        return Two((one, other), exist, meet, beyond, side, square / self.size ** (2 * lengths))

    def fold(self, axis: Axis, b: Vector, c: Vector, square: Any) -> Two:
        """The two angles about ``axis`` at which ``b + R c`` has the length of which ``square`` is given, see
        :meth:`reach`. Lengths that are known before a program runs tell how far that is from being folded and
        stretched; worked out from there, the angles are right even where the length is almost nothing."""
        along = dot(axis.direction, b) + dot(axis.direction, c)
        fixed = along * along
        one, other = across(axis.direction, b), across(axis.direction, c)
        squares = dot(one, one), dot(other, other)
        margins = None
        if all(map(is_number, squares)):
            short, long = (real_root(x) for x in squares)
            margins = (
                (square - (fixed + (long - short) ** 2)) / 2,
                ((fixed + (long + short) ** 2) - square) / 2,
                FOLD * self.unit * square,
            )
        bend = (square - (fixed + squares[0] + squares[1])) / 2
        return self.reach(axis, other, one, bend, 2, margins)

    def along(self, share: Any, distance: Any) -> One:
        """The length of which ``share`` is ``distance``; 0 where nothing of it is."""
        if is_number(share):
            return One(distance / share, 0)
        free = choose(share * share - self._floor(0), 0, 1)
        meet = choose(share * share - self._short(0), 0, 1)
        return One(choose(free, 0, distance / choose(free, 1, share)), meet, share * share)

    def slide(self, p: Any, q: Any) -> Two:
        """The two lengths ``d`` with ``d^2 + 2 p d + q = 0``; ``-p`` where none is."""
        rest = p * p - q
        edge = self.edge * self.size * self.size
        side = real_root(choose(rest, rest, 0))
        return Two((side - p, -side - p), choose(rest + edge, 1, 0), choose(edge - rest, 1, 0))


def both(*conditions: Any) -> Any:
    """1 where all ``conditions`` are 1, else 0."""
    total: Any = 1
    for condition in conditions:
        total = condition if total == 1 else total if condition == 1 else choose(total, condition, 0)
    return total


def either(*conditions: Any) -> Any:
    """1 where any of ``conditions`` is 1, else 0."""
    total: Any = 0
    for condition in conditions:
        total = condition if is_zero(total) else total if is_zero(condition) else choose(total, 1, condition)
    return total


def chosen(condition: Any, one: Circle, other: Circle) -> Circle:
    """The angle ``one`` where ``condition`` is more than 0, else the ``other``."""
    return choose(condition, one[0], other[0]), choose(condition, one[1], other[1])


def preferred(condition: Any, one: One | Two, other: One | Two) -> One | Two:
    """``one`` where ``condition`` is more than 0, else the ``other``, of as many answers."""

    def either_of(a: Any, b: Any) -> Any:
        return chosen(condition, a, b) if isinstance(a, tuple) else choose(condition, a, b)

    meet, lever = choose(condition, one.meet, other.meet), choose(condition, one.lever, other.lever)
    if isinstance(one, Two) and isinstance(other, Two):
        first, second = map(either_of, one.answers, other.answers)
        return Two((first, second), choose(condition, one.exist, other.exist), meet, lever=lever)
    assert isinstance(one, One)
    assert isinstance(other, One)
    return One(either_of(one.answer, other.answer), meet, lever)


def is_number(x: Any) -> bool:
    """Whether ``x`` is known before a program runs."""
    return isinstance(x, (int, Fraction))


def lever_of(axis: Vector, v: Vector) -> Any:
    """How far ``v`` is from the line along ``axis``, where that is known; else 0."""
    u = across(axis, v)
    square = dot(u, u)
    return real_root(square) if is_number(square) else 0


def real_root(x: Any) -> Any:
    """Square root; of a fraction a fraction, within 1e-40 of it as a share."""
    if not is_number(x):
        return root(x)
    if not x:
        return Fraction(0)
    scale = 1 << (300 + max(0, Fraction(x).denominator.bit_length() - Fraction(x).numerator.bit_length()))
    return Fraction(isqrt(int(Fraction(x) * scale * scale)), scale)
