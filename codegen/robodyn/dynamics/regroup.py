"""Base-parameter regrouping: moving mass that makes no difference from each link to its parent.

Mass on the axis of a revolute joint belongs as well to the parent, and so does the whole second
moment of a link on a prismatic joint. Moved to the base it vanishes; what is left are base parameters,
in which many products with zero fall away. Source: Gautier and Khalil 1990; in terms of the
pseudo-inertia matrix (second moment, first moment, mass), where a move is a congruence.

Regrouped masses may be zero or negative: right in inverse dynamics, meaningless as physics. The base
must be fixed.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Symmetric, origin
from robodyn.dynamics.carried import carried
from robodyn.dynamics.lump import NO_LUMP, Lump, MomentForm
from robodyn.dynamics.vectors import Vector
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
    return Lump(
        one.mass + other.mass,
        (one.first[0] + other.first[0], one.first[1] + other.first[1], one.first[2] + other.first[2]),
        Symmetric(*(u + v for u, v in zip(one.second.entries(), other.second.entries(), strict=True))),
    )


def about_axis_z(lump: Lump, c: Any, s: Any) -> Lump:
    """``lump`` turned about z by the angle of cosine ``c`` and sine ``s``."""
    x, y, z = lump.first
    return Lump(lump.mass, (c * x - s * y, s * x + c * y, z), tensor_about_z(lump.second, c, s))


def tensor_about_z(k: Symmetric, c: Any, s: Any) -> Symmetric:
    """``k`` turned about z by the angle of cosine ``c`` and sine ``s``."""
    turned = c * c * (k.xx - k.yy) - 2 * (c * s) * k.xy  # the part of xx that comes and goes with the angle
    return Symmetric(
        k.yy + turned,
        k.xx - turned,
        k.zz,
        c * s * (k.xx - k.yy) + (2 * (c * c) - 1) * k.xy,
        c * k.xz - s * k.yz,
        s * k.xz + c * k.yz,
    )


def about_axis_x(lump: Lump, c: Any, s: Any) -> Lump:
    """``lump`` turned about x by the angle of cosine ``c`` and sine ``s``."""
    x, y, z = lump.first
    return Lump(lump.mass, (x, c * y - s * z, s * y + c * z), tensor_about_x(lump.second, c, s))


def tensor_about_x(k: Symmetric, c: Any, s: Any) -> Symmetric:
    """``k`` turned about x by the angle of cosine ``c`` and sine ``s``."""
    turned = c * c * (k.yy - k.zz) - 2 * (c * s) * k.yz
    return Symmetric(
        k.xx,
        k.zz + turned,
        k.yy - turned,
        c * k.xy - s * k.xz,
        s * k.xy + c * k.xz,
        c * s * (k.yy - k.zz) + (2 * (c * c) - 1) * k.yz,
    )


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
    """``lump`` turned about x, and then about a point from which its own origin lies at ``p`` [m]."""
    moved = carried(lump, c, s, p)
    return shifted(about_axis_x(lump, c, s), p) if moved is None else moved
