"""Algebra modulo a large prime: linear systems, and rational numbers and functions out of their images.

Source: von zur Gathen and Gerhard, Modern Computer Algebra, sections 5.7 (Pade), 5.10 (rational numbers).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

#: So many bits of a modulus are left over where a fraction is recognised: chance leaves none.
_SPARE = 60


class Elimination:
    """A linear system modulo ``prime`` of so many unknowns, eliminated row by row as they come. Each row is
    solved for its first unknown that is left; unknowns that no row is solved for are 0."""

    def __init__(self, width: int, prime: int) -> None:
        self._width, self._prime = width, prime
        #: Of each row: which other rows were taken off, how often; its unknown, None where nothing is left.
        self._taken: list[list[tuple[int, int]]] = []
        self._unknowns: list[int | None] = []
        #: Of the rows with an unknown: place, unknown, what is left, and the inverse of what stands there.
        self._pivots: list[tuple[int, int, list[int], int]] = []

    def add(self, row: Sequence[int]) -> bool:
        """Whether ``row`` says something that the rows before do not."""
        p, left = self._prime, list(row)
        taken = []
        for place, unknown, other, inverse in self._pivots:
            if left[unknown]:
                factor = left[unknown] * inverse % p
                left = [(x - factor * y) % p if y else x for x, y in zip(left, other, strict=True)]
                taken.append((place, factor))
        unknown_left = next((k for k, x in enumerate(left) if x), None)
        if unknown_left is not None:
            inverse = pow(left[unknown_left], -1, p)
            self._pivots.append((len(self._taken), unknown_left, left, inverse))
        self._taken.append(taken)
        self._unknowns.append(unknown_left)
        return unknown_left is not None

    def solve(self, right: Sequence[int]) -> list[int] | None:
        """The solution for the right-hand sides of all rows; None: there is none."""
        p, b = self._prime, list(right)
        for i, taken in enumerate(self._taken):
            b[i] = (b[i] - sum([factor * b[j] for j, factor in taken])) % p
            if b[i] and self._unknowns[i] is None:
                return None
        solution = [0] * self._width
        for place, unknown, row, inverse in reversed(self._pivots):
            known = sum([x * y for x, y in zip(row, solution, strict=True) if y])
            solution[unknown] = (b[place] - known) * inverse % p
        return solution


def fraction_of(image: int, modulus: int) -> Fraction | None:
    """The fraction of few digits that has this image (P. S. Wang 1981); None where none stands out."""
    bound = math.isqrt(modulus >> 1)
    r, next_r, s, next_s = modulus, image % modulus, 0, 1
    while next_r > bound:
        q = r // next_r
        r, next_r, s, next_s = next_r, r - q * next_r, next_s, s - q * next_s
    if not next_s or next_r * abs(next_s) > modulus >> _SPARE:
        return None
    return Fraction(next_r, next_s)


def fraction_of_residues(parts: Sequence[int], moduli: Sequence[int]) -> Fraction | None:
    """The fraction of few digits with these residues; None where none stands out."""
    x, m = 0, 1
    for part, p in zip(parts, moduli, strict=True):
        x += m * ((part - x) * pow(m, -1, p) % p)
        m *= p
    return fraction_of(x, m)


def value_at_one(series: Sequence[int], prime: int) -> int | None:
    """What the rational function with this power series is at 1; None where the series is too short to tell
    (one more coefficient must be foreseen), or where it has a pole."""
    if not any(series[1:]):
        return series[0]
    most = (len(series) - 2) // 2
    a, b = [0] * len(series) + [1], _trimmed(list(series))
    s: list[int] = []
    next_s = [1]
    while len(b) - 1 > most:
        quotient, rest = _divided(a, b, prime)
        a, b = b, rest
        s, next_s = next_s, _less(s, quotient, next_s, prime)
    if len(next_s) - 1 > most or len(series) < len(b) + len(next_s):
        return None
    denominator = sum(next_s) % prime
    return sum(b) * pow(denominator, -1, prime) % prime if denominator else None


def _trimmed(polynomial: list[int]) -> list[int]:
    while polynomial and not polynomial[-1]:
        polynomial.pop()
    return polynomial


def _divided(a: list[int], b: list[int], prime: int) -> tuple[list[int], list[int]]:
    """Quotient and remainder of polynomials, lowest coefficient first."""
    rest, inverse = a[:], pow(b[-1], -1, prime)
    quotient = [0] * (len(a) - len(b) + 1)
    for k in reversed(range(len(quotient))):
        factor = quotient[k] = rest[k + len(b) - 1] * inverse % prime
        for i, x in enumerate(b):
            rest[k + i] = (rest[k + i] - factor * x) % prime
    return quotient, _trimmed(rest[: len(b) - 1])


def _less(s: list[int], quotient: list[int], t: list[int], prime: int) -> list[int]:
    """``s - quotient * t``."""
    result = s + [0] * max(0, len(quotient) + len(t) - 1 - len(s))
    for i, x in enumerate(quotient):
        for j, y in enumerate(t):
            result[i + j] = (result[i + j] - x * y) % prime
    return _trimmed(result)
