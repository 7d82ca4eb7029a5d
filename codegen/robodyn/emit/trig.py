"""Sine, cosine and arctangent of our own: the constants, and the words about range and accuracy.

One reduction and one polynomial each, written down once for each language (``templates/*/trig.*.j2``,
``atan2.*.j2``), for double and float alike. Coefficients are minimax among the numbers of the type
(Brisebarre and Chevillard, ``fpminimax`` of Sollya). Sine and cosine:

- ``k`` quarter turns are taken off in three pieces (Cody and Waite, Software Manual for the Elementary
  Functions, 1980, chapter 8): products of ``k`` with the first two are exact, the rest is ``h - n`` with
  ``n`` far below ``h`` (Dekker's fast two-sum).
- ``sin h = h - h z P(z)``, ``cos h = 1 - z/2 + z^2 R(z)``, ``z = h^2``, on |h| <= pi/4 and a little more.
  Relative error of the sine 3.8e-18 (float 4.3e-9), error of the cosine 4.8e-20 (1.1e-10).

The angle of a point:

- ``(x, y)`` is mirrored at the axes and at the diagonal until it is ``(a, b)`` with ``0 <= b <= a``; this
  changes the angle by its sign and by whole quarters of a turn.
- Beyond 35/64, ``atan(b/a) = pi/4 + atan((b - a)/(b + a))``, where ``b - a`` is exact.
- ``atan t = t - t z P(z)``, ``z = t^2``, on |t| <= 35/64. In Sollya, with ``[|D...|]`` and 12 for double,
  ``[|SG...|]`` and 5 for float: ``prec = 165; fpminimax((1 - atan(sqrt(x))/sqrt(x))/x, 12, [|D...|],
  [2^-20; (35/64)^2], absolute, floating);``. Relative error of the arctangent 8.9e-18 (float 3.1e-9).
- ``k`` quarters of a turn are added in two pieces, the products of ``k`` with the first of which are exact.

What is left of the error is that of the quotient, one rounding, and that of the last sum.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.emit.spelling import Syntax

#: Where the polynomial of the arctangent ends, and units in the last place that it is off at most.
WIDE, ARCTANGENT_ULPS = 35 / 64, 1.7


@dataclass(frozen=True, slots=True)
class Trigonometric:
    """Numbers of the functions of a type; all are numbers of that type.

    ``first``, ``second``, ``third`` add up to pi/2, and so do the two of ``quarter``, which are the
    arctangent's. ``k*over`` is infinite for a ``k`` that is too large. Up to ``exact`` [rad] errors of sine
    and cosine are below one unit in the last place, beyond ``limit`` [rad] results are NaN. ``sines_told``
    and ``arctangent_told`` are range and accuracy in lines for a comment.
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
    quarter: tuple[float, float]
    arctangent: tuple[float, ...]
    sines_told: tuple[str, str]
    arctangent_told: tuple[str, str]


_ARCTANGENT_TOLD = (
    "Error below 1.7 ulp (the largest found is 1.61) where |x| + |y| is of {}; 0 of",
    "(0, 0), signs of zeros count as in C; NaN where |x| + |y| is infinite, and for NaN.",
)

DOUBLE = Trigonometric(
    bits=64,
    magic=1.5 * 2.0**52,
    per_quarter=0.6366197723675814,
    over=2.0**1006,
    first=float.fromhex("0x1.921fb5444p+0"),
    second=float.fromhex("0x1.68c234c4cp-39"),
    third=float.fromhex("0x1.98a2e03707345p-77"),
    sine=(
        0.1666666666666663, 0.008333333333321924, 0.0001984126982946497, 2.7557313585030056e-06,
        2.505074281422434e-08, 1.5895975029828002e-10,
    ),
    cosine=(
        0.0416666666666666, 0.0013888888888874483, 2.4801587289679692e-05, 2.75573144038047e-07,
        2.0875729688424388e-09, 1.1359956108737493e-11,
    ),
    exact=411773.0,
    limit=411773.0,
    quarter=(float.fromhex("0x1.921fb54442d18p+0"), float.fromhex("0x1.1a62633145c07p-54")),
    arctangent=(
        0.3333333333333333, 0.1999999999999719, 0.14285714285151443, 0.11111111067979555,
        0.09090907385214822, 0.07692267575602507, 0.06666059273770279, 0.05876150642820255,
        0.05219310299910152, 0.04544826936703032, 0.03595603621039435, 0.021931193230332536,
        0.007254783075865788,
    ),
    sines_told=(
        "Error below 1 ulp (the largest found is 0.95) for |x| < 411773 rad (65535 turns); NaN beyond",
        "411775 rad and for infinite x and NaN.",
    ),
    arctangent_told=(_ARCTANGENT_TOLD[0].format("2.3e-308 to 8.9e307"), _ARCTANGENT_TOLD[1]),
)  # fmt: skip

FLOAT = Trigonometric(
    bits=32,
    magic=1.5 * 2.0**23,
    per_quarter=float.fromhex("0x1.45f306p-1"),
    over=2.0**116,
    first=float.fromhex("0x1.922p+0"),
    second=float.fromhex("-0x1.2aefp-18"),
    third=float.fromhex("0x1.68c234p-39"),
    sine=(0.1666665375232696533203125, 8.33211839199066162109375e-3, 1.9510401762090623378753662109375e-4),
    cosine=(
        4.16666455566883087158203125e-2, 1.388731063343584537506103515625e-3,
        2.4432500140392221510410308837890625e-5,
    ),
    exact=201.0,
    limit=6433.0,
    quarter=(float.fromhex("0x1.921fbp+0"), float.fromhex("0x1.5110b4p-22")),
    arctangent=(
        0.333333313465118408203125, 0.1999967992305755615234375, 0.14274106919765472412109375,
        0.109449647367000579833984375, 0.079560525715351104736328125, 0.03782379627227783203125,
    ),
    sines_told=(
        "Error below 0.94 ulp for |x| < 201 rad (32 turns), below 5.7e-8 for |x| < 6433 rad (1023",
        "turns), of all floats; NaN beyond 6434 rad and for infinite x and NaN.",
    ),
    arctangent_told=(_ARCTANGENT_TOLD[0].format("1.2e-38 to 1.7e38"), _ARCTANGENT_TOLD[1]),
)  # fmt: skip


def builtin_context(syntax: Syntax, *, sines: bool, arctangents: bool) -> dict[str, Any]:
    """What the templates of our own functions are told, every number spelt in the language: ``trig`` and
    ``arctangent``, None of what a file does not have, and ``bits`` of a number."""
    of = FLOAT if syntax.spelling.single else DOUBLE

    def number(value: float) -> str:
        return syntax.spelling.number(Fraction(value))

    def polynomial(name: str, coefficients: tuple[float, ...]) -> list[str]:
        return syntax.line(syntax.declare(name, _in_pairs([number(c) for c in coefficients])))

    sign = f"0x8{'0' * (of.bits // 4 - 1)}u"
    # For x = -0 the sine is -0: w must be +0 for k = +0, whatever the sign of the second piece.
    second = number(abs(of.second))
    trig = {
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
        "sign": sign,
        "told": of.sines_told,
    }
    exponent = 23 if of.bits == 32 else 52  # where it stands in the bits of a number
    ones = (1 << (of.bits - 2 - exponent)) - 1
    arctangent = {
        "sign": sign,
        "size": f"0x7{'f' * (of.bits // 4 - 1)}u",
        "one_bits": f"{ones << exponent:#x}u",
        "half_bits": f"{(ones - 1) << exponent:#x}u",
        "zero": number(0.0),
        "half": number(0.5),
        "one": number(1.0),
        "wide": number(WIDE),
        "first": number(of.quarter[0]),
        "second": number(of.quarter[1]),
        "polynomial": polynomial("p", of.arctangent),
        "told": of.arctangent_told,
    }
    return {
        "bits": of.bits,
        "trig": trig if sines else None,
        "arctangent": arctangent if arctangents else None,
    }


def _in_pairs(terms: list[str]) -> str:
    """``a - b z + c zz - d z zz ...`` in pairs: as few operations as Horner's, half as deep."""
    pairs = [f"({a} - (z*{b}))" for a, b in zip(terms[::2], terms[1::2], strict=False)]
    text = terms[-1] if len(terms) % 2 else pairs.pop()
    for pair in reversed(pairs):
        text = f"({pair} + (zz*{text}))"
    return text[1:-1]
