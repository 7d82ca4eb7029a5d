"""Polynomials that behave like numbers: exact ones, and those of floats with a bound of what is left out.

**Exact**, with ``c^2 + s^2 = 1``: a small trigonometric algebra. A recursion that is run on them gives its
torques as polynomials in sines, cosines, displacements, rates and accelerations: no fitting, no symbolic
engine.

**Bounded**: a value is a sum of terms ``c e^(i k.q) x^m`` with every ``x`` scaled into [-1, 1], so that no
term is larger than ``|c|``: the sum of the sizes bounds the value on the whole box. What rounding has taken
away and what was too small to keep stands in ``rest``, a bound of the difference (a Taylor model; Makino and
Berz 1996, with Fourier terms where theirs has powers).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

#: A product of variables, by their numbers, sorted; a square stands twice.
Monomial = tuple[int, ...]
Number = Fraction | int
Terms = dict[Monomial, Number]


@dataclass(frozen=True, slots=True)
class Ring:
    """Where polynomials live: ``partner[v]`` is the other one of sine and cosine for each variable ``v`` of
    which no square is kept, since ``v^2 = 1 - partner^2``."""

    partner: Mapping[int, int] = field(default_factory=dict)

    def variable(self, v: int) -> Polynomial:
        """The variable ``v``."""
        return Polynomial(self, {(v,): 1})

    def product(self, a: Terms, b: Terms) -> Terms:
        """``a b`` in normal form."""
        total: Terms = {}
        for m, k in a.items():
            for n, l in b.items():
                self._add(total, tuple(sorted(m + n)), k * l)
        return {m: k for m, k in total.items() if k}

    def _add(self, total: Terms, m: Monomial, k: Number) -> None:
        before = -1
        for i, v in enumerate(m):
            if v == before and v in self.partner:
                rest = m[: i - 1] + m[i + 1 :]
                self._add(total, rest, k)
                self._add(total, tuple(sorted((*rest, self.partner[v], self.partner[v]))), -k)
                return
            before = v
        total[m] = total.get(m, 0) + k


class Polynomial:
    """A polynomial of a ring; ``+ - *`` with polynomials, integers and fractions. Constant ones become plain
    numbers, so that zeros are known as zeros."""

    __slots__ = ("ring", "terms")

    def __init__(self, ring: Ring, terms: Terms) -> None:
        self.ring = ring
        self.terms = terms

    def __add__(self, other: Any) -> Any:
        total = dict(self.terms)
        for m, k in terms_of(other).items():
            total[m] = total.get(m, 0) + k
        return _value(self.ring, {m: k for m, k in total.items() if k})

    __radd__ = __add__

    def __neg__(self) -> Polynomial:
        return Polynomial(self.ring, {m: -k for m, k in self.terms.items()})

    def __sub__(self, other: Any) -> Any:
        return self + (-other)

    def __rsub__(self, other: Any) -> Any:
        return (-self) + other

    def __mul__(self, other: Any) -> Any:
        if isinstance(other, Polynomial):
            return _value(self.ring, self.ring.product(self.terms, other.terms))
        if not other:
            return 0
        return Polynomial(self.ring, {m: k * other for m, k in self.terms.items()})

    __rmul__ = __mul__

    def __repr__(self) -> str:
        return " + ".join(f"{k}*{list(m)}" for m, k in self.terms.items())


def terms_of(value: Any) -> Terms:
    """The terms of a polynomial or of a number."""
    if isinstance(value, Polynomial):
        return value.terms
    return {(): value} if value else {}


def _value(ring: Ring, terms: Terms) -> Any:
    if not terms:
        return 0
    if len(terms) == 1 and () in terms:
        return terms[()]
    return Polynomial(ring, terms)


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


class Bounded:
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

    def plus(self, other: Bounded, sign: int = 1) -> Bounded:
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

    def scaled(self, factor: Fraction) -> Bounded:
        """``factor * self``."""
        f = float(factor)
        rest = abs(f) * (self.rest + 2 * _ROUND * self.size)
        return Bounded({key: c * f for key, c in self.terms.items()}, rest * _UP, self.degree)

    def times(self, other: Bounded) -> Bounded:
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


def constant(value: Fraction) -> Bounded:
    """The constant ``value``."""
    c = float(value)
    return Bounded({0: complex(c)} if c else {}, 2 * _ROUND * abs(c), 0)


def _swept(terms: dict[int, complex], rest: float, degree: int) -> Bounded:
    if degree > MOST:
        raise OverflowError("a product of more factors than a key can tell apart")
    sizes = [abs(c) for c in terms.values()]
    least = math.fsum(sizes) * _TINY
    if min(sizes, default=0.0) <= least:
        dropped = [c for c in sizes if c <= least]
        terms = {key: c for key, c in terms.items() if abs(c) > least}
        rest += math.fsum(dropped)
    return Bounded(terms, rest * _UP, degree)
