"""Sine and cosine of our own: the constants, and the words about range and accuracy.

One reduction and one pair of polynomials, written down once for each language (``templates/*/trig.*.j2``)
for double and float alike:

- ``k`` quarter turns are taken off in three pieces (Cody and Waite, Software Manual for the Elementary
  Functions, 1980, chapter 8): products of ``k`` with the first two are exact, the rest is ``h - n`` with
  ``n`` far below ``h`` (Dekker's fast two-sum).
- ``sin h = h - h z P(z)``, ``cos h = 1 - z/2 + z^2 R(z)``, ``z = h^2``, with minimax coefficients among the
  numbers of the type (Brisebarre and Chevillard, ``fpminimax`` of Sollya) on |h| <= pi/4 and a little more.
  Relative error of the sine 3.8e-18 (float 4.3e-9), error of the cosine 4.8e-20 (1.1e-10).
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.emit.syntax import Syntax


@dataclass(frozen=True, slots=True)
class Trigonometric:
    """Numbers of the sine and cosine of a type; all are numbers of that type.

    ``first``, ``second``, ``third`` add up to pi/2. ``k*over`` is finite below ``turns`` quarter turns.
    Up to ``exact`` [rad] errors are below one unit in the last place, up to ``limit`` [rad] below
    ``error`` at least, beyond it results are NaN.
    """

    bits: int
    magic: float
    per_quarter: float
    over: float
    first: float
    second: float
    third: float
    sine: tuple[float, ...]
    cosine: tuple[float, ...]
    exact: float
    limit: float


DOUBLE = Trigonometric(
    bits=64,
    magic=1.5 * 2.0**52,
    per_quarter=0.6366197723675814,
    over=2.0**1006,
    first=float.fromhex("0x1.921fb5444p+0"),
    second=float.fromhex("0x1.68c234c4cp-39"),
    third=float.fromhex("0x1.98a2e03707345p-77"),
    sine=(
        0.1666666666666663,
        0.008333333333321924,
        0.0001984126982946497,
        2.7557313585030056e-06,
        2.505074281422434e-08,
        1.5895975029828002e-10,
    ),
    cosine=(
        0.0416666666666666,
        0.0013888888888874483,
        2.4801587289679692e-05,
        2.75573144038047e-07,
        2.0875729688424388e-09,
        1.1359956108737493e-11,
    ),
    exact=411773.0,
    limit=411773.0,
)

FLOAT = Trigonometric(
    bits=32,
    magic=1.5 * 2.0**23,
    per_quarter=float.fromhex("0x1.45f306p-1"),
    over=2.0**116,
    first=float.fromhex("0x1.922p+0"),
    second=float.fromhex("-0x1.2aefp-18"),
    third=float.fromhex("0x1.68c234p-39"),
    sine=(
        0.1666665375232696533203125,
        8.33211839199066162109375e-3,
        1.9510401762090623378753662109375e-4,
    ),
    cosine=(
        4.16666455566883087158203125e-2,
        1.388731063343584537506103515625e-3,
        2.4432500140392221510410308837890625e-5,
    ),
    exact=201.0,
    limit=6433.0,
)


def trig_context(syntax: Syntax) -> dict[str, Any]:
    """What the templates of the sine and cosine are told: every number spelt in the language."""
    spelling = syntax.spelling
    of = FLOAT if spelling.single else DOUBLE

    def number(value: float) -> str:
        return spelling.number(Fraction(value))

    def polynomial(name: str, coefficients: tuple[float, ...]) -> list[str]:
        terms = polynomial_text([number(c) for c in coefficients])
        return syntax.line(syntax.declare(name, terms))

    # For x = -0 the sine is -0: w must be +0 for k = +0, whatever the sign of the second piece.
    second = number(abs(of.second))
    return {
        "bits": of.bits,
        "magic": number(of.magic),
        "per_quarter": number(of.per_quarter),
        "over": number(of.over),
        "first": number(of.first / of.over),
        "second": f"({number(0.0)} - k)*{second}" if of.second < 0 else f"k*{second}",
        "third": number(of.third),
        "polynomials": [*polynomial("p", of.sine), *polynomial("r", of.cosine)],
        "half": number(0.5),
        "quarter": number(0.25),
        "three_quarters": number(0.75),
        "sign": f"0x8{'0' * (of.bits // 4 - 1)}u",
        "told": accuracy_notes(single=spelling.single),
    }


def polynomial_text(terms: list[str]) -> str:
    """``a - b z + c zz - d z zz ...`` in pairs: as few operations as Horner's, half as deep."""
    pairs = [f"({a} - (z*{b}))" for a, b in zip(terms[::2], terms[1::2], strict=False)]
    text = terms[-1] if len(terms) % 2 else pairs.pop()
    for pair in reversed(pairs):
        text = f"({pair} + (zz*{text}))"
    return text[1:-1]


def accuracy_notes(*, single: bool) -> tuple[str, ...]:
    """Range and accuracy, in lines for a comment."""
    if single:
        return (
            "Error below 0.94 ulp for |x| < 201 rad (32 turns), below 5.7e-8 for |x| < 6433 rad (1023",
            "turns), of all floats; NaN beyond 6434 rad and for infinite x and NaN.",
        )
    return (
        "Error below 1 ulp (the largest found is 0.95) for |x| < 411773 rad (65535 turns); NaN beyond",
        "411775 rad and for infinite x and NaN.",
    )
