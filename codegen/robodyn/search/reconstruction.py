"""Fractions out of their residues."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction


class NoWalk(Exception):
    """The program has nothing that the walk could rewrite, or what it cannot read."""


def fraction(parts: Sequence[int], moduli: Sequence[int]) -> Fraction:
    """The fraction with these residues (P. S. Wang 1981: rational reconstruction by Euclid's algorithm).

    Raises
    ------
    NoWalk: there is none of the size that the moduli allow.
    """
    x, m = 0, 1
    for part, p in zip(parts, moduli, strict=True):
        x += m * ((part - x) * pow(m, -1, p) % p)
        m *= p
    # With 60 bits to spare a wrong fraction is out of the question.
    bound_bits = (m.bit_length() - 60) // 2
    (r0, s0), (r1, s1) = (m, 0), (x, 1)
    while r1.bit_length() > bound_bits:
        quotient = r0 // r1
        (r0, s0), (r1, s1) = (r1, s1), (r0 - quotient * r1, s0 - quotient * s1)
    if not s1 or s1.bit_length() > bound_bits:
        raise NoWalk("a constant is too large to recover")
    return Fraction(r1, s1)
