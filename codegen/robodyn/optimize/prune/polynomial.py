"""Trigonometric polynomials with a remainder: an exact expansion as far as floats go, and what is left.

A value of a recursion is a polynomial in the sines and cosines of the joint angles and in the other
inputs. Here it is a sum of terms ``c e^(i k.q) x^m`` with every ``x`` scaled into [-1, 1], so that no term
is larger than ``|c|``: the sum of the sizes bounds the value on the whole box. What rounding has taken away
and what was too small to keep stands in ``rest``, a bound of the difference (a Taylor model; Makino and
Berz 1996, with Fourier terms where theirs has powers).
"""

from __future__ import annotations

import math
from fractions import Fraction

#: Bits of an exponent in a key: a key is the sum of exponents times powers of 2^_BITS, so that the key
#: of a product of terms is the sum of their keys.
BITS = 6
#: Exponents stay below half of what the bits hold: keys are then unique.
MOST = (1 << (BITS - 1)) - 1

#: Twice the rounding of one operation.
_ROUND = 2.0**-52
#: Covers the rounding of the bounds themselves (sums of less than 10^5 numbers, all of one sign).
_UP = 1.0 + 1e-10
#: Terms this much smaller than the polynomial go into the remainder.
_TINY = 1e-13


class Polynomial:
    """``sum(terms[key] * monomial(key))``, wrong by ``rest`` at most; ``degree`` bounds the exponents."""

    __slots__ = ("degree", "rest", "size", "terms")

    def __init__(self, terms: dict[int, complex], rest: float, degree: int) -> None:
        self.terms = terms
        self.rest = rest
        self.degree = degree
        #: Bound of the sum of the terms.
        self.size = math.fsum(map(abs, terms.values())) * _UP

    @property
    def bound(self) -> float:
        """Bound of the value on the whole box."""
        return (self.size + self.rest) * _UP

    def plus(self, other: Polynomial, sign: int = 1) -> Polynomial:
        """``self + sign * other``."""
        long, short = (self.terms, other.terms)
        if sign > 0 and len(long) < len(short):
            long, short = short, long
        total = dict(long)
        get = total.get
        if sign > 0:
            for key, c in short.items():
                total[key] = get(key, 0) + c
        else:
            for key, c in short.items():
                total[key] = get(key, 0) - c
        rest = self.rest + other.rest + _ROUND * (self.size + other.size)
        return _swept(total, rest, max(self.degree, other.degree))

    def scaled(self, factor: Fraction) -> Polynomial:
        """``factor * self``."""
        f = float(factor)
        rest = abs(f) * (self.rest + 2 * _ROUND * self.size)
        return Polynomial({key: c * f for key, c in self.terms.items()}, rest * _UP, self.degree)

    def times(self, other: Polynomial) -> Polynomial:
        """``self * other``."""
        a, b = self, other
        if len(a.terms) > len(b.terms):
            a, b = b, a
        total: dict[int, complex] = {}
        get = total.get
        many = list(b.terms.items())
        for key, c in a.terms.items():
            for other_key, d in many:
                both = key + other_key
                total[both] = get(both, 0) + c * d
        rest = a.rest * (b.size + b.rest) + b.rest * a.size + _ROUND * (len(a.terms) + 4) * a.size * b.size
        return _swept(total, rest, a.degree + b.degree)


def constant(value: Fraction) -> Polynomial:
    """The constant ``value``."""
    c = float(value)
    return Polynomial({0: complex(c)} if c else {}, 2 * _ROUND * abs(c), 0)


def _swept(terms: dict[int, complex], rest: float, degree: int) -> Polynomial:
    if degree > MOST:
        raise OverflowError("a product of more factors than a key can tell apart")
    sizes = [abs(c) for c in terms.values()]
    least = math.fsum(sizes) * _TINY
    if min(sizes, default=0.0) <= least:
        dropped = [c for c in sizes if c <= least]
        terms = {key: c for key, c in terms.items() if abs(c) > least}
        rest += math.fsum(dropped)
    return Polynomial(terms, rest * _UP, degree)
