"""Algebra modulo a large prime: linear systems, and rational numbers and functions out of their images.

Source: von zur Gathen and Gerhard, Modern Computer Algebra, sections 5.7 (Pade), 5.10 (rational numbers).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

#: So many bits of a prime are left over where a fraction is recognised: chance leaves none.
_SPARE = 64


class Elimination:
    """A linear system modulo ``prime``, its rows eliminated once: columns that come first are solved for, and
    those that depend on them stay 0."""

    def __init__(self, rows: Sequence[Sequence[int]], prime: int) -> None:
        self._prime = prime
        self._columns: list[int] = []
        self._steps: list[tuple[int, int, int]] = []  # row, of which so many times another row is taken off
        self._pivots: list[tuple[int, int]] = []  # row, and the inverse of its leading entry
        left = [list(row) for row in rows]
        free = list(range(len(left)))
        self._width = len(left[0]) if left else 0
        for column in range(self._width):
            pivot = next((i for i in free if left[i][column]), None)
            if pivot is None:
                continue
            free.remove(pivot)
            first = left[pivot]
            inverse = pow(first[column], -1, prime)
            entries = [k for k in range(column, self._width) if first[k]]
            for i in free:
                row = left[i]
                if row[column]:
                    factor = row[column] * inverse % prime
                    for k in entries:
                        row[k] = (row[k] - factor * first[k]) % prime
                    self._steps.append((i, pivot, factor))
            self._columns.append(column)
            self._pivots.append((pivot, inverse))
        self._rest = free
        self._rows = left

    def solve(self, right: Sequence[int]) -> list[int] | None:
        """The solution for the right-hand side; None: there is none."""
        p, b = self._prime, list(right)
        for i, j, factor in self._steps:
            if b[j]:
                b[i] = (b[i] - factor * b[j]) % p
        if any(b[i] for i in self._rest):
            return None
        solution = [0] * self._width
        for column, (i, inverse) in zip(reversed(self._columns), reversed(self._pivots), strict=True):
            row = self._rows[i]
            known = sum(row[k] * solution[k] for k in self._columns if k > column)
            solution[column] = (b[i] - known) * inverse % p
        return solution


def fraction_of(image: int, prime: int) -> Fraction | None:
    """The fraction of few digits that has this image modulo ``prime``; None where none stands out."""
    bound = math.isqrt(prime >> 1)
    r, next_r, s, next_s = prime, image % prime, 0, 1
    while next_r > bound:
        q = r // next_r
        r, next_r, s, next_s = next_r, r - q * next_r, next_s, s - q * next_s
    if not next_s or next_r * abs(next_s) > prime >> _SPARE:
        return None
    return Fraction(next_r if next_s > 0 else -next_r, abs(next_s))


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
