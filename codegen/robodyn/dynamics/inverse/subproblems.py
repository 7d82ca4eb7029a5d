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

from robodyn.dynamics.inverse.limits import EDGE, FOLD, LEVER
from robodyn.dynamics.inverse.screws import Circle, across
from robodyn.dynamics.vectors import Vector, cross, dot
from robodyn.effects.scalars import choose, is_zero, magnitude, root


@dataclass(frozen=True, slots=True)
class Scale:
    """How large the levers of an equation may be, and how exactly they are known.

    They are products of vectors of which ``lengths`` are no longer than ``size`` [m] and the others unit
    vectors. ``unit``: the rounding unit.
    """

    unit: Fraction
    size: Fraction
    lengths: int

    @property
    def edge(self) -> Fraction:
        """See :data:`~robodyn.dynamics.inverse.limits.EDGE`."""
        return EDGE * self.unit

    @property
    def floor(self) -> Fraction:
        """The square of a lever that is nothing but rounding."""
        own = LEVER * self.unit * (self.size if self.lengths else 1)
        return own ** (2 * max(1, self.lengths))

    @property
    def short(self) -> Fraction:
        """The square of a lever so short that what it turns is singular."""
        return self.edge ** max(1, self.lengths) * self.size ** (2 * self.lengths)


@dataclass(frozen=True, slots=True)
class Two:
    """Two answers, whether there are any (1 or 0), and whether they meet or are free (1 or 0).

    ``beyond``: how far what was wanted is beyond what is reached; ``side``: how far ``R v`` is across that
    and the axis, ``along . (R v x axis)``, the first answer having it on the positive side.
    """

    answers: tuple[Any, Any]
    exist: Any
    meet: Any
    beyond: Any = 0
    side: Any = 0


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


def chosen(condition: Any, one: Circle, other: Circle) -> Circle:
    """The angle ``one`` where ``condition`` is more than 0, else the ``other``."""
    return choose(condition, one[0], other[0]), choose(condition, one[1], other[1])


def turning_onto(
    v: Vector,
    onto: Vector,
    axis: Vector,
    near: Callable[[], Circle] | None,
    scale: Scale,
) -> One:
    """The angle about ``axis`` that turns ``v`` onto ``onto``, or nearest to it; ``near`` where that is the
    same for every angle, which for None does not occur where there is an answer."""
    c, s = dot(across(axis, v), onto), dot(cross(axis, v), onto)
    square = c * c + s * s
    floor = scale.floor
    if near is None:
        length = 1 / real_root(square + floor)
        return One((c * length, s * length), 0)
    free = choose(square - floor, 0, 1)
    length = 1 / real_root(choose(free, 1, square))
    meet = choose(square - scale.short, 0, 1)
    return One(chosen(free, near(), (c * length, s * length)), meet)


def reaching(
    v: Vector,
    along: Vector,
    distance: Any,
    axis: Vector,
    near: Callable[[], Circle],
    scale: Scale,
    margins: tuple[Any, Any, Any] | None = None,
) -> Two:
    """The two angles about ``axis`` at which ``v``, turned, is ``distance`` along the vector ``along``:
    ``along . R v = distance``. Where none is, the nearest, twice; ``near``, and for two that are always half
    a turn apart the other side of it, where all are. ``margins``: how far what turns of
    ``distance`` is from its lowest and highest values, where that is known better, and how exactly."""
    base = across(axis, v)
    x, y = dot(along, base), dot(along, cross(axis, v))
    square = x * x + y * y
    if margins is None:
        b = distance - dot(along, axis) * dot(axis, v)
    else:
        b = (margins[0] - margins[1]) / 2
    known = is_number(square) and square != 0
    floor = Fraction(0) if known else scale.floor
    free = 0 if known else choose(square - floor, 0, 1)
    blunt = 0 if known else choose(square - scale.short, 0, 1)
    if is_zero(b):  # whatever the lever is, its two perpendiculars
        most = real_root(square)
        share = 1 / choose(free, 1, most)
        c, s = -(y * share), x * share
        c, s = (c, s) if known else chosen(free, near(), (c, s))
        return Two(((c, s), (-c, -s)), 1, blunt, side=most)
    rest = square - b * b if margins is None else margins[0] * margins[1]
    most = real_root(square)
    slack = scale.edge * (most if known else scale.size**scale.lengths)
    exist = choose(rest + slack * (2 * most + slack), 1, 0)
    meet = either(blunt, choose(scale.edge * square - rest, 1, 0))
    if margins is None:
        side = real_root(choose(rest, rest, 0))
    else:  # folded or stretched to within rounding is folded or stretched: the two answers are one
        low, high, noise = margins
        side = real_root(choose(low - noise, choose(high - noise, rest, 0), 0))
    # Beyond reach, x^2 + y^2 < b^2: the root is 0, and what is left is brought back onto the circle.
    share = 1 / choose(free, 1, choose(rest, square, most * magnitude(b)))
    answers = (
        ((x * b - y * side) * share, (y * b + x * side) * share),
        ((x * b + y * side) * share, (y * b - x * side) * share),
    )
    if not known:
        one, other = answers
        answers = chosen(free, near(), one), chosen(free, near(), other)
    return Two(answers, exist, meet, choose(rest, 0, choose(b, b - most, b + most)), side)


def folding(b: Vector, c: Vector, square: Any, axis: Vector, near: Callable[[], Circle], scale: Scale) -> Two:
    """The two angles about ``axis`` at which ``b + R c`` has the length of which ``square`` is given, see
    :func:`reaching`. Lengths that are known before a program runs tell how far that is from being folded and
    stretched; worked out from there, the angles are right even where the length is almost nothing."""
    along = dot(axis, b) + dot(axis, c)
    fixed = along * along
    one, other = across(axis, b), across(axis, c)
    squares = dot(one, one), dot(other, other)
    margins = None
    if all(map(is_number, squares)):
        short, long = (real_root(x) for x in squares)
        margins = (
            (square - (fixed + (long - short) ** 2)) / 2,
            ((fixed + (long + short) ** 2) - square) / 2,
            FOLD * scale.unit * square,
        )
    bend = (square - (fixed + squares[0] + squares[1])) / 2
    return reaching(other, one, bend, axis, near, scale, margins)


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


def slides(p: Any, q: Any, scale: Scale) -> Two:
    """The two lengths ``d`` with ``d^2 + 2 p d + q = 0``; ``-p`` where none is."""
    rest = p * p - q
    edge = scale.edge * scale.size * scale.size
    side = real_root(choose(rest, rest, 0))
    return Two((side - p, -side - p), choose(rest + edge, 1, 0), choose(edge - rest, 1, 0))
