"""The angle of a point, of our own: the constants, and the words about range and accuracy.

One reduction and one polynomial, written down once for each language (``templates/*/atan2.*.j2``) for double
and float alike:

- ``(x, y)`` is mirrored at the axes and at the diagonal until it is ``(a, b)`` with ``0 <= b <= a``; this
  changes the angle by its sign and by whole quarters of a turn.
- Beyond 35/64, ``atan(b/a) = pi/4 + atan((b - a)/(b + a))``, where ``b - a`` is exact.
- ``atan t = t - t z P(z)``, ``z = t^2``, with minimax coefficients among the numbers of the type on
  |t| <= 35/64 (Brisebarre and Chevillard). In Sollya, with ``[|D...|]`` and 12 for double, ``[|SG...|]`` and
  5 for float: ``prec = 165; fpminimax((1 - atan(sqrt(x))/sqrt(x))/x, 12, [|D...|], [2^-20; (35/64)^2],
  absolute, floating);``. Relative error of the arctangent 8.9e-18 (float 3.1e-9).
- ``k`` quarters of a turn are added in two pieces, the products of ``k`` with the first of which are exact.

What is left of the error is that of the quotient, one rounding, and that of the last sum.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.emit.syntax import Syntax
from robodyn.emit.trig import polynomial_text


@dataclass(frozen=True, slots=True)
class Arctangent:
    """Numbers of the arctangent of a type; all are numbers of that type.

    ``first`` and ``second`` add up to pi/2. Errors are below ``ulps`` units in the last place where |x| and
    |y| are below ``largest`` and the greater of them is above ``smallest``. ``one`` and ``half`` are the bits
    of 1 and 1/2.
    """

    bits: int
    first: float
    second: float
    coefficients: tuple[float, ...]
    one: int
    half: int
    smallest: float
    largest: float
    ulps: float = 1.7


#: Where the polynomial's range ends.
WIDE = 35 / 64

DOUBLE = Arctangent(
    bits=64,
    first=float.fromhex("0x1.921fb54442d18p+0"),
    second=float.fromhex("0x1.1a62633145c07p-54"),
    coefficients=(
        0.3333333333333333,
        0.1999999999999719,
        0.14285714285151443,
        0.11111111067979555,
        0.09090907385214822,
        0.07692267575602507,
        0.06666059273770279,
        0.05876150642820255,
        0.05219310299910152,
        0.04544826936703032,
        0.03595603621039435,
        0.021931193230332536,
        0.007254783075865788,
    ),
    one=0x3FF0000000000000,
    half=0x3FE0000000000000,
    smallest=2.0**-1022,
    largest=2.0**1023,
)

FLOAT = Arctangent(
    bits=32,
    first=float.fromhex("0x1.921fbp+0"),
    second=float.fromhex("0x1.5110b4p-22"),
    coefficients=(
        0.333333313465118408203125,
        0.1999967992305755615234375,
        0.14274106919765472412109375,
        0.109449647367000579833984375,
        0.079560525715351104736328125,
        0.03782379627227783203125,
    ),
    one=0x3F800000,
    half=0x3F000000,
    smallest=2.0**-126,
    largest=2.0**127,
)


def arctangent_context(syntax: Syntax) -> dict[str, Any]:
    """What the templates of the arctangent are told: every number spelt in the language."""
    spelling = syntax.spelling
    of = FLOAT if spelling.single else DOUBLE

    def number(value: float) -> str:
        return spelling.number(Fraction(value))

    terms = polynomial_text([number(c) for c in of.coefficients])
    return {
        "bits": of.bits,
        "sign": f"0x8{'0' * (of.bits // 4 - 1)}u",
        "size": f"0x7{'f' * (of.bits // 4 - 1)}u",
        "one_bits": f"{of.one:#x}u",
        "half_bits": f"{of.half:#x}u",
        "zero": number(0.0),
        "half": number(0.5),
        "one": number(1.0),
        "wide": number(WIDE),
        "first": number(of.first),
        "second": number(of.second),
        "polynomial": syntax.line(syntax.declare("p", terms)),
        "told": arctangent_notes(single=spelling.single),
    }


def arctangent_notes(*, single: bool) -> tuple[str, ...]:
    """Range and accuracy, in lines for a comment."""
    sizes = "1.2e-38 to 1.7e38" if single else "2.3e-308 to 8.9e307"
    return (
        f"Error below 1.7 ulp (the largest found is 1.61) where |x| + |y| is of {sizes}; 0 of",
        "(0, 0), signs of zeros count as in C; NaN where |x| + |y| is infinite, and for NaN.",
    )
