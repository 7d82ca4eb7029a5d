"""Exact numbers of a robot description: rationals, named parameters, angles.

A number of the file is kept as the exact rational that its text says (``0.4318`` is 4318/10000), so
that zeros, ones and equalities are found exactly and nothing is rounded before it is emitted.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction


@dataclass(frozen=True, slots=True)
class Affine:
    """``constant + sum(coefficient * parameter)``: a value that is known only at run time.

    ``terms`` is sorted by name and has no zero coefficient.
    """

    constant: Fraction
    terms: tuple[tuple[str, Fraction], ...]

    def __add__(self, other: Value | int) -> Value:
        if isinstance(other, (int, Fraction)):
            return Affine(self.constant + other, self.terms)
        total = dict(self.terms)
        for name, coefficient in other.terms:
            total[name] = total.get(name, Fraction(0)) + coefficient
        return _affine(self.constant + other.constant, total)

    __radd__ = __add__

    def __neg__(self) -> Value:
        return self * Fraction(-1)

    def __sub__(self, other: Value | int) -> Value:
        return self + (-other)

    def __rsub__(self, other: Value | int) -> Value:
        return (-self) + other

    def __mul__(self, factor: Fraction | int) -> Value:
        return _affine(self.constant * factor, {name: c * factor for name, c in self.terms})

    __rmul__ = __mul__


Value = Fraction | Affine
ZERO = Fraction(0)


def _affine(constant: Fraction, terms: dict[str, Fraction]) -> Value:
    kept = tuple(sorted((name, c) for name, c in terms.items() if c))
    return Affine(constant, kept) if kept else constant


def parameter(name: str) -> Affine:
    """The run-time parameter ``name`` as a value."""
    return Affine(ZERO, ((name, Fraction(1)),))


def parameters_of(value: Value) -> tuple[str, ...]:
    """Names of the run-time parameters in ``value``."""
    return tuple(name for name, _ in value.terms) if isinstance(value, Affine) else ()


@dataclass(frozen=True, slots=True)
class Angle:
    """A constant angle with its cosine and sine as exact rationals on the unit circle.

    ``radians`` is the angle rounded to double. For a multiple of pi/2 cosine and sine are 0 or +-1
    and ``quarter`` is the multiple; any other angle is replaced by a rational point of the circle
    within 1e-30 of ``radians``, so that every identity of rotations holds exactly.
    """

    radians: float
    cos: Fraction
    sin: Fraction
    quarter: int | None

    def __neg__(self) -> Angle:
        return Angle(-self.radians, self.cos, -self.sin, None if self.quarter is None else -self.quarter)


def _arctangent_inverse(k: int, one: int) -> int:
    """arctan(1/k) in fixed point."""
    total = term = one // k
    n, sign = 3, -1
    while term:
        term //= k * k
        total += sign * (term // n)
        n, sign = n + 2, -sign
    return total


_BITS = 256
_ONE = 1 << _BITS
#: pi to 75 digits (Machin), as a rational.
PI = Fraction(4 * (4 * _arctangent_inverse(5, _ONE) - _arctangent_inverse(239, _ONE)), _ONE)


def circle_point(angle: Fraction) -> tuple[Fraction, Fraction]:
    """Cosine and sine of ``angle`` [rad] as a rational point of the unit circle, within 1e-30.

    Rational arithmetic only: the same on every machine.
    """
    turn = round(angle / (2 * PI))
    half = (angle - 2 * PI * turn) / 2  # -pi/2 .. pi/2
    x = half.numerator * _ONE // half.denominator
    sine, cosine, term, n = 0, 0, _ONE, 0
    while term:
        if n % 2:
            sine += term if n % 4 == 1 else -term
        else:
            cosine += term if n % 4 == 0 else -term
        n += 1
        term = term * x // (_ONE * n) if term * x >= 0 else -(-term * x // (_ONE * n))
    # The point with parameter t = tan(angle/2), or its mirror image where t would be large.
    small = abs(sine) <= abs(cosine)
    t = Fraction(sine, cosine) if small else Fraction(cosine, sine)
    t = Fraction(round(t * (1 << 110)), 1 << 110)
    c = (1 - t * t) / (1 + t * t)
    s = 2 * t / (1 + t * t)
    return (c, s) if small else (-c, s)


def quarter_turns(quarter: int) -> Angle:
    """The angle of ``quarter`` times pi/2."""
    cos, sin = ((1, 0), (0, 1), (-1, 0), (0, -1))[quarter % 4]
    return Angle(float(quarter * PI / 2), Fraction(cos), Fraction(sin), quarter)


def angle(radians: Fraction) -> Angle:
    """The angle of ``radians``; within 1e-12 of a multiple of pi/2 it is exactly that.

    Whole turns are taken off first, exactly: a kernel adds the angle to a joint's, and a large one would
    cost the joint's digits.
    """
    if abs(radians) > 2 * PI:
        radians -= 2 * PI * round(radians / (2 * PI))
    quarter = round(radians / (PI / 2))
    if abs(radians - quarter * PI / 2) <= Fraction(1, 10**12):
        return quarter_turns(quarter)
    # The point of the rounded angle: the same that a kernel's sin(q + offset) means.
    cosine, sine = circle_point(Fraction(float(radians)))
    return Angle(float(radians), cosine, sine, None)
