"""Exact polynomials that behave like numbers, with ``c^2 + s^2 = 1``: a small trigonometric algebra.

A recursion of this room that is run on them gives its torques as polynomials in sines, cosines,
displacements, rates and accelerations: no fitting, no symbolic engine.
"""

from __future__ import annotations

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
