"""Polynomials in the number of joints, in exact fractions: coefficients from the highest power down."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

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
    coefficients: list[Fraction] = [Fraction(0)]
    basis: list[Fraction] = [Fraction(1)]  # Newton's form: the product of (n - n_k) so far
    for n, y in points[: degree + 1]:
        slope = (y - value(coefficients, n)) / value(basis, n)
        coefficients = _plus(coefficients, [slope * b for b in basis])
        basis = _plus([*basis, Fraction(0)], [-n * b for b in basis])
    if any(value(coefficients, n) != y for n, y in points[degree + 1 :]):
        return None
    while len(coefficients) > 1 and not coefficients[0]:
        coefficients.pop(0)
    return tuple(coefficients)


def difference(a: Sequence[Fraction], b: Sequence[Fraction]) -> Polynomial:
    """``a - b``."""
    remainder = _plus(list(a), [-x for x in b])
    while len(remainder) > 1 and not remainder[0]:
        remainder.pop(0)
    return tuple(remainder)


def _plus(a: list[Fraction], b: list[Fraction]) -> list[Fraction]:
    size = max(len(a), len(b))
    padded = [[Fraction(0)] * (size - len(x)) + x for x in (a, b)]
    return [x + y for x, y in zip(*padded, strict=True)]


def polynomial_text(coefficients: Sequence[Fraction]) -> str:
    """``25 n^4 + 199/3 n^3 - 96``."""
    degree = len(coefficients) - 1
    text = ""
    for power, coefficient in zip(range(degree, -1, -1), coefficients, strict=True):
        if not coefficient:
            continue
        sign = "-" if coefficient < 0 else "+"
        size = abs(coefficient)
        factor = "" if size == 1 and power else str(size)
        variable = "" if not power else "n" if power == 1 else f"n^{power}"
        term = " ".join(part for part in (factor, variable) if part)
        text += f" {sign} {term}" if text else (f"-{term}" if sign == "-" else term)
    return text or "0"
