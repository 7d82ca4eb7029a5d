"""Composite bodies in motion: all that a joint carries, as one body, over any scalar."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Arm, Symmetric, about_x, about_z
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.regroup import about_axis_x, about_axis_z, merged, shifted
from robodyn.dynamics.vectors import ZERO, Mark, Vector, cross, named, plus, scaled
from robodyn.ir.program import Label

Rows = tuple[Vector, Vector, Vector]


@dataclass(frozen=True, slots=True)
class Composite:
    """All that is carried by a joint, about an origin: the masses, momentum ``p`` and ``N`` (by rows)
    relative to the link, force ``f`` and moment ``n``."""

    lump: Lump
    p: Vector
    N: Rows
    f: Vector
    n: Vector

    def turned_x(self, c: Any, s: Any) -> Composite:
        """The same along axes turned back about x."""
        p, f, n = (about_x(c, s, u) for u in (self.p, self.f, self.n))
        return Composite(about_axis_x(self.lump, c, s), p, rows_about_x(c, s, self.N), f, n)

    def turned_z(self, c: Any, s: Any) -> Composite:
        """The same along axes turned back about z."""
        p, f, n = (about_z(c, s, u) for u in (self.p, self.f, self.n))
        return Composite(about_axis_z(self.lump, c, s), p, rows_about_z(c, s, self.N), f, n)

    def about(self, r: Vector) -> Composite:
        """The same about a point from which the origin lies at ``r``."""
        rows = [plus(row, scaled(u, r)) for row, u in zip(self.N, self.p, strict=True)]
        n = plus(self.n, cross(r, self.f))
        return Composite(shifted(self.lump, r), self.p, (rows[0], rows[1], rows[2]), self.f, n)

    def with_(self, other: Composite) -> Composite:
        """Both."""
        rows = [plus(row, more) for row, more in zip(self.N, other.N, strict=True)]
        return Composite(
            merged(self.lump, other.lump),
            plus(self.p, other.p),
            (rows[0], rows[1], rows[2]),
            plus(self.f, other.f),
            plus(self.n, other.n),
        )


NOTHING = Composite(Lump(0, ZERO, Symmetric(0, 0, 0, 0, 0, 0)), ZERO, (ZERO, ZERO, ZERO), ZERO, ZERO)


def named_composite(composite: Composite, link: int, mark: Mark) -> Composite:
    """``composite`` of ``link`` with each component marked."""
    lump = composite.lump
    entries = zip(lump.second.entries(), ("xx", "yy", "zz", "xy", "xz", "yz"), strict=True)
    second = type(lump.second)(*(mark(value, Label(link, "k", axes)) for value, axes in entries))
    x, y, z = (named(mark, row, link, f"u{axis}") for row, axis in zip(composite.N, "xyz", strict=True))
    return Composite(
        Lump(lump.mass, named(mark, lump.first, link, "h"), second),
        named(mark, composite.p, link, "p"),
        (x, y, z),
        named(mark, composite.f, link, "f"),
        named(mark, composite.n, link, "n"),
    )


def moving(composite: Composite, arm: Arm, i: int, rate: Any) -> Composite:
    """``composite`` with its momenta relative to what carries joint ``i``, which moves at ``rate``."""
    lump, k = composite.lump, composite.lump.second
    h = lump.first
    if arm.bodies[i].revolute:
        p = plus(composite.p, (-(rate * h[1]), rate * h[0], 0))
        more: Rows = (
            (-(rate * k.xy), -(rate * k.yy), -(rate * k.yz)),
            (rate * k.xx, rate * k.xy, rate * k.xz),
            ZERO,
        )
    else:
        p = plus(composite.p, (0, 0, rate * lump.mass))
        more = (ZERO, ZERO, scaled(rate, h))
    x, y, z = (plus(row, added) for row, added in zip(composite.N, more, strict=True))
    return Composite(lump, p, (x, y, z), composite.f, composite.n)


def rows_about_x(c: Any, s: Any, N: Rows) -> Rows:
    """``R N R^T``, R turning about x."""
    columns = [about_x(c, s, (N[0][k], N[1][k], N[2][k])) for k in range(3)]
    rows = [about_x(c, s, (columns[0][k], columns[1][k], columns[2][k])) for k in range(3)]
    return rows[0], rows[1], rows[2]


def rows_about_z(c: Any, s: Any, N: Rows) -> Rows:
    """``R N R^T``, R turning about z: what of the upper block changes with the angle is formed once."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = N
    cc, cs = c * c, c * s
    turned = cc * (xx - yy) - cs * (xy + yx)
    across = cs * (xx - yy) + cc * (xy + yx)
    return (
        (yy + turned, across - yx, c * xz - s * yz),
        (across - xy, xx - turned, s * xz + c * yz),
        (c * zx - s * zy, s * zx + c * zy, zz),
    )
