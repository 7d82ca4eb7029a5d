"""Equations of one angle that inverse kinematics is put together from, over any scalar.

After Paden (1986) and Kahan, as Elias and Wen have them (IK-Geo, 2022), with three differences. Angles stay
pairs of cosine and sine until the last. Every equation has an answer for whatever it is given, in least
squares where there is none, from a reference where there are too many, with 0 or 1 for what was the case.
And they are asked in an order in which each takes up what the ones before rounded: poses close to rounding
error even where single angles are ill-determined.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from math import isqrt
from typing import Any

from robodyn.dynamics.inverse.limits import EDGE, LEVER
from robodyn.dynamics.inverse.screws import Circle, across
from robodyn.dynamics.vectors import Vector, cross, dot
from robodyn.effects.scalars import choose, is_zero, magnitude, root


@dataclass(frozen=True, slots=True)
class Precision:
    """The rounding unit of the arithmetic that a program is for."""

    unit: Fraction

    @property
    def edge(self) -> Fraction:
        """See :data:`~robodyn.dynamics.inverse.limits.EDGE`."""
        return EDGE * self.unit

    def floor(self, size: Fraction) -> Fraction:
        """The square of a lever that is nothing but rounding, where levers are up to ``size``."""
        return (LEVER * self.unit * size) ** 2


@dataclass(frozen=True, slots=True)
class Two:
    """Two answers, whether there are any (1 or 0), and whether they meet or are free (1 or 0).

    ``beyond``: how far what was wanted is beyond what is reached.
    """

    answers: tuple[Any, Any]
    exist: Any
    meet: Any
    beyond: Any = 0


@dataclass(frozen=True, slots=True)
class One:
    """An answer, and whether it is free (1 or 0)."""

    answer: Any
    meet: Any


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


def facing(near: Circle, free: Any, angle: Circle) -> Circle:
    """``angle``, or ``near`` where it is ``free``."""
    return choose(free, near[0], angle[0]), choose(free, near[1], angle[1])


def turning_onto(
    v: Vector,
    onto: Vector,
    axis: Vector,
    near: Callable[[], Circle] | None,
    size: Fraction,
    precision: Precision,
) -> One:
    """The angle about ``axis`` that turns ``v`` onto ``onto``, or nearest to it; ``near`` where that is the
    same for every angle, which for None does not occur where there is an answer. ``size``: the largest
    ``|v| |onto|``."""
    c, s = dot(across(axis, v), onto), dot(cross(axis, v), onto)
    square = c * c + s * s
    floor = precision.floor(size)
    if near is None:
        length = 1 / real_root(square + floor)
        return One((c * length, s * length), 0)
    free = choose(square - floor, 0, 1)
    length = 1 / real_root(choose(free, 1, square))
    meet = choose(square - precision.edge * size * size, 0, 1)
    return One(facing(near(), free, (c * length, s * length)), meet)


def reaching(
    v: Vector,
    along: Vector,
    distance: Any,
    axis: Vector,
    near: Callable[[], Circle],
    size: Fraction,
    precision: Precision,
) -> Two:
    """The two angles about ``axis`` at which ``v``, turned, is ``distance`` along the vector ``along``:
    ``along . R v = distance``. Where none is, the nearest, twice; ``near``, and for two that are always half
    a turn apart the other side of it, where all are. ``size``: the largest ``|v| |along|``."""
    base = across(axis, v)
    x, y = dot(along, base), dot(along, cross(axis, v))
    b = distance - dot(along, axis) * dot(axis, v)
    square = x * x + y * y
    edge = precision.edge * square
    known = is_number(square)
    floor = Fraction(0) if known else precision.floor(size)
    free = 0 if known else choose(square - floor, 0, 1)
    if is_zero(b):  # whatever the lever is, its two perpendiculars
        share = 1 / real_root(choose(free, 1, square))
        c, s = -(y * share), x * share
        c, s = (c, s) if known else facing(near(), free, (c, s))
        meet = 0 if known else choose(square - precision.edge * size * size, 0, 1)
        return Two(((c, s), (-c, -s)), 1, meet)
    rest = square - b * b
    exist = choose(rest + (edge + floor), 1, 0)
    meet = either(free, choose(edge - rest, 1, 0))
    side = real_root(choose(rest, rest, 0))
    # Beyond reach, x^2 + y^2 < b^2: the root is 0, and what is left is brought back onto the circle.
    most = real_root(square)
    share = 1 / choose(free, 1, choose(rest, square, most * magnitude(b)))
    answers = (
        ((x * b - y * side) * share, (y * b + x * side) * share),
        ((x * b + y * side) * share, (y * b - x * side) * share),
    )
    if not known:
        one, other = answers
        answers = facing(near(), free, one), facing(near(), free, other)
    return Two(answers, exist, meet, choose(rest, 0, choose(b, b - most, b + most)))


def is_number(x: Any) -> bool:
    """Whether ``x`` is known before a program runs."""
    return isinstance(x, (int, Fraction))


def lever_of(axis: Vector, v: Vector) -> Any:
    """How far ``v`` is from the line along ``axis``, where that is known; else 0."""
    flat = across(axis, v)
    square = dot(flat, flat)
    return real_root(square) if is_number(square) else 0


def real_root(x: Any) -> Any:
    """Square root; of a fraction a fraction, within 1e-40 of it as a share."""
    if not is_number(x):
        return root(x)
    if not x:
        return Fraction(0)
    scale = 1 << (300 + max(0, Fraction(x).denominator.bit_length() - Fraction(x).numerator.bit_length()))
    return Fraction(isqrt(int(Fraction(x) * scale * scale)), scale)


def slides(p: Any, q: Any, size: Fraction, precision: Precision) -> Two:
    """The two lengths ``d`` with ``d^2 + 2 p d + q = 0``; ``-p`` where none is. ``size``: the largest
    length."""
    rest = p * p - q
    edge = precision.edge * size * size
    side = real_root(choose(rest, rest, 0))
    return Two((side - p, -side - p), choose(rest + edge, 1, 0), choose(edge - rest, 1, 0))
