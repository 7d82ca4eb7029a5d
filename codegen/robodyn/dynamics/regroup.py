"""Base-parameter regrouping: moving mass that makes no difference from each link to its parent.

Mass on the axis of a revolute joint belongs as well to the parent, and so does the whole second
moment of a link on a prismatic joint. Moved to the base it vanishes; what is left are base parameters,
in which many products with zero fall away. Source: Gautier and Khalil 1990; in terms of the
pseudo-inertia matrix (second moment, first moment, mass), where a move is a congruence.

Regrouped masses may be zero or negative: right in inverse dynamics, meaningless as physics. The base
must be fixed.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Symmetric, about_x, about_z, origin
from robodyn.dynamics.lump import NO_LUMP, Lump, MomentForm
from robodyn.dynamics.vectors import Vector, plus
from robodyn.effects.scalars import is_zero


def lumps_of(arm: Arm) -> list[Lump]:
    """Mass, first and second moments of the links as they are described."""
    lumps = []
    for body in arm.bodies:
        m, (x, y, z), i = body.mass, body.com, body.inertia
        half = Fraction(1, 2) * (i.xx + i.yy + i.zz)
        hx, hy, hz = m * x, m * y, m * z
        second = Symmetric(
            half - i.xx + hx * x,
            half - i.yy + hy * y,
            half - i.zz + hz * z,
            hx * y - i.xy,
            hx * z - i.xz,
            hy * z - i.yz,
        )
        lumps.append(Lump(m, (hx, hy, hz), second))
    return lumps


def regrouped(arm: Arm, forms: Sequence[MomentForm]) -> list[Lump]:
    """The lumps with all that may move moved to the parent, tip to base.

    A revolute joint's link gives up its mass, the first moment along its axis and one inertia: for the
    form ``second_moment`` the second moment along the axis, for ``inertia`` as much of it as makes Iyy
    zero (the choice of the literature). A prismatic joint's link gives up its second moment.
    """
    return regrouped_with_ground(arm, forms)[0]


def regrouped_with_ground(arm: Arm, forms: Sequence[MomentForm]) -> tuple[list[Lump], Lump]:
    """The same, and what moved to the base, in its frame."""
    lumps, ground = lumps_of(arm), NO_LUMP
    for i in reversed(range(len(lumps))):
        body, lump = arm.bodies[i], lumps[i]
        k = lump.second
        if body.revolute:
            along = k.zz if forms[i] == "second_moment" else k.zz + k.xx
            moved = Lump(lump.mass, (0, 0, lump.first[2]), Symmetric(0, 0, along, 0, 0, 0))
            lumps[i] = Lump(
                0, (lump.first[0], lump.first[1], 0), Symmetric(k.xx, k.yy, k.zz - along, k.xy, k.xz, k.yz)
            )
            moved = in_parent(moved, arm, i, body.d)
        else:
            moved = Lump(0, (0, 0, 0), k)
            lumps[i] = Lump(lump.mass, lump.first, Symmetric(0, 0, 0, 0, 0, 0))
            moved = in_parent(about_axis_z(moved, body.theta.cos, body.theta.sin), arm, i, body.d)
        if i:
            lumps[i - 1] = merged(lumps[i - 1], moved)
        else:
            ground = moved
    return lumps, ground


def suited_forms(arm: Arm) -> tuple[MomentForm, ...]:
    """For each link the moment form that costs less.

    ``lambda K`` takes four entries of lambda where ``I alpha + D k`` takes none; it is the shorter one
    where those entries are needed anyway, for the link's first moment or the next frame's origin.
    """
    n = len(arm.bodies)
    lumps = regrouped(arm, ["second_moment"] * n)
    forms: list[MomentForm] = []
    for i, lump in enumerate(lumps):
        uses = any(not is_zero(h) for h in lump.first)
        if i + 1 < n:
            child = arm.bodies[i + 1]
            uses = uses or not child.revolute or any(not is_zero(p) for p in origin(child, child.d))
        forms.append("second_moment" if uses and i > 0 else "inertia")
    return tuple(forms)


def merged(one: Lump, other: Lump) -> Lump:
    """Both lumps, in one frame."""
    return Lump(one.mass + other.mass, plus(one.first, other.first), one.second.plus(other.second))


def about_axis_z(lump: Lump, c: Any, s: Any) -> Lump:
    """``lump`` turned about z by the angle of cosine ``c`` and sine ``s``."""
    return Lump(lump.mass, about_z(c, s, lump.first), lump.second.about_z(c, s))


def about_axis_x(lump: Lump, c: Any, s: Any) -> Lump:
    """``lump`` turned about x by the angle of cosine ``c`` and sine ``s``."""
    return Lump(lump.mass, about_x(c, s, lump.first), lump.second.about_x(c, s))


def shifted(lump: Lump, p: Vector) -> Lump:
    """``lump`` about a point from which its own origin lies at ``p`` [m]."""
    m, (x, y, z), k = lump.mass, lump.first, lump.second
    hx, hy, hz = m * p[0], m * p[1], m * p[2]
    return Lump(
        m,
        (x + hx, y + hy, z + hz),
        Symmetric(
            k.xx + p[0] * (2 * x + hx),
            k.yy + p[1] * (2 * y + hy),
            k.zz + p[2] * (2 * z + hz),
            k.xy + p[0] * y + (x + hx) * p[1],
            k.xz + p[0] * z + (x + hx) * p[2],
            k.yz + p[1] * z + (y + hy) * p[2],
        ),
    )


def in_parent(lump: Lump, arm: Arm, i: int, d: Any) -> Lump:
    """``lump``, given along the axes of frame i before its turn about z, in the parent's frame."""
    body = arm.bodies[i]
    return moved_into(lump, body.cos_alpha, body.sin_alpha, origin(body, d))


def moved_into(lump: Lump, c: Any, s: Any, p: Vector) -> Lump:
    """``lump`` turned about x by the angle of cosine ``c`` and sine ``s``, and then about a point from which
    its own origin lies at ``p`` [m]."""
    numbers = (lump.mass, *lump.first, *lump.second.entries(), c, s, *p)
    if all(isinstance(x, (int, Fraction)) for x in numbers):
        return _moved_exactly(lump, c, s, p)
    return shifted(about_axis_x(lump, c, s), p)


@functools.lru_cache(maxsize=1024)
def _moved_exactly(lump: Lump, c: int | Fraction, s: int | Fraction, p: Vector) -> Lump:
    """The same in whole numbers.

    Exact numbers gain digits with every frame that they are carried through, and the sums of a move in
    fractions take a greatest common divisor each, which costs the square of the digits: on long arms that is
    most of a generation. Here all ten numbers share one denominator, and each is reduced once, at the end.
    Remembered: writings of an arm that are weighed against each other share most of their moves.
    """
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
