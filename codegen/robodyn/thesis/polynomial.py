"""Polynomials in the number of joints, in exact fractions: coefficients from the highest power down."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from itertools import dropwhile

Polynomial = tuple[Fraction, ...]


def value(coefficients: Sequence[Fraction], n: int) -> Fraction:
    """The polynomial at ``n``."""
    total = Fraction(0)
    for coefficient in coefficients:
        total = total * n + coefficient
    return total


def fit(values: Mapping[int, int | Fraction], degree: int) -> Polynomial | None:
    """The polynomial of at most ``degree`` through all ``values`` (n to value), or None if there is none.

    The first ``degree + 1`` values determine it; the others are checked, so there must be some.
    """
    points = sorted(values.items())
    if len(points) < degree + 2:
        raise ValueError(f"{len(points)} values cannot check a polynomial of degree {degree}")
    coefficients: Polynomial = (Fraction(0),)
    basis = [Fraction(1)]  # Newton's form: the product of (n - n_k) so far
    for n, y in points[: degree + 1]:
        slope = (y - value(coefficients, n)) / value(basis, n)
        coefficients = _sum(coefficients, [slope * b for b in basis])
        basis = [*_sum([*basis, Fraction(0)], [-n * b for b in basis])]
    return coefficients if all(value(coefficients, n) == y for n, y in points) else None


def difference(a: Sequence[Fraction], b: Iterable[Fraction]) -> Polynomial:
    """``a - b``."""
    return _sum(a, [-x for x in b])


def _sum(a: Sequence[Fraction], b: Sequence[Fraction]) -> Polynomial:
    size, none = max(len(a), len(b)), Fraction(0)
    padded = ([none] * (size - len(x)) + [*x] for x in (a, b))
    sums = (x + y for x, y in zip(*padded, strict=True))
    return tuple(dropwhile(lambda x: not x, sums)) or (none,)


def polynomial_text(coefficients: Sequence[Fraction]) -> str:
    """``25 n^4 + 199/3 n^3 - 96``."""
    text = ""
    for power, coefficient in zip(reversed(range(len(coefficients))), coefficients, strict=True):
        if coefficient:
            size = "" if abs(coefficient) == 1 and power else str(abs(coefficient))
            variable = {0: "", 1: "n"}.get(power, f"n^{power}")
            sign = "-" if coefficient < 0 else "+"
            text += f" {sign} " if text else sign.strip("+")
            text += f"{size} {variable}".strip()
    return text or "0"
