"""What a link gives, carried into its parent's frame, in whole numbers.

Exact numbers gain digits with every frame that they are carried through, and the sums of a move in fractions
take a greatest common divisor each, which costs the square of the digits: on long arms that is most of a
generation. Here all ten numbers share one denominator, and each is reduced once, at the end.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.vectors import Vector


def carried(lump: Lump, c: Any, s: Any, p: Vector) -> Lump | None:
    """``lump`` turned about x by the angle of cosine ``c`` and sine ``s``, then about a point from which its
    own origin lies at ``p`` [m]; None where a number is neither an integer nor a fraction.

    The same as :func:`~robodyn.dynamics.regroup.shifted` of
    :func:`~robodyn.dynamics.regroup.about_axis_x`, number for number.
    """
    numbers = (lump.mass, *lump.first, *lump.second.entries())
    if not all(isinstance(x, (int, Fraction)) for x in (*numbers, c, s, *p)):
        return None
    return _carried(lump, c, s, p)


@functools.lru_cache(maxsize=1024)
def _carried(lump: Lump, c: int | Fraction, s: int | Fraction, p: Vector) -> Lump:
    """Remembered: writings of an arm that are weighed against each other share most of their moves."""
    numbers = (lump.mass, *lump.first, *lump.second.entries())
    (m, x, y, z, xx, yy, zz, xy, xz, yz), below = _over_one(numbers)
    (C, S), e = _over_one((c, s))
    (p0, p1, p2), f = _over_one(p)
    # Turned, everything over below * e^2.
    m, ee = m * e * e, e * e
    x, y, z = x * ee, (C * y - S * z) * e, (S * y + C * z) * e
    turned = C * C * (yy - zz) - 2 * C * S * yz
    xx, yy, zz, xy, xz, yz = (
        xx * ee,
        zz * ee + turned,
        yy * ee - turned,
        (C * xy - S * xz) * e,
        (S * xy + C * xz) * e,
        C * S * (yy - zz) + (2 * C * C - ee) * yz,
    )
    # Shifted, moments of order k over that times f^k.
    hx, hy, hz = m * p0, m * p1, m * p2
    x, y, z, ff = x * f, y * f, z * f, f * f
    second = (
        xx * ff + p0 * (2 * x + hx),
        yy * ff + p1 * (2 * y + hy),
        zz * ff + p2 * (2 * z + hz),
        xy * ff + p0 * y + (x + hx) * p1,
        xz * ff + p0 * z + (x + hx) * p2,
        yz * ff + p1 * z + (y + hy) * p2,
    )
    below *= ee
    first = (_reduced(x + hx, below * f), _reduced(y + hy, below * f), _reduced(z + hz, below * f))
    return Lump(_reduced(m, below), first, Symmetric(*(_reduced(k, below * ff) for k in second)))


def _over_one(numbers: Sequence[int | Fraction]) -> tuple[list[int], int]:
    """``numbers`` as numerators over one denominator."""
    below = math.lcm(*(x.denominator for x in numbers))
    return [x.numerator * (below // x.denominator) for x in numbers], below


def _reduced(numerator: int, denominator: int) -> int | Fraction:
    """The quotient, an integer where it is one."""
    if not numerator:
        return 0
    fraction = Fraction(numerator, denominator)
    return fraction.numerator if fraction.denominator == 1 else fraction
