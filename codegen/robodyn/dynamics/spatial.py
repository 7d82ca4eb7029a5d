"""Symmetric 6x6 matrices (inertias and responses of links) and moving composite bodies, over any scalar.

An inertia maps the accelerations ``(alpha, a)``, angular and of the frame's origin, to the moment and force
that they need. The response of a link maps the force and moment at its origin to ``(a, alpha)``. With the
vectors in these orders, :meth:`Spatial.moved` moves both to another origin by the same formula.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from robodyn.dynamics.arm import Arm, Symmetric, about_x, about_z
from robodyn.dynamics.lump import NO_LUMP, Lump
from robodyn.dynamics.regroup import about_axis_x, about_axis_z, merged, shifted
from robodyn.dynamics.vectors import AXES, ZERO, Mark, Pair, Vector, cross, dot, named, plus, scaled

Rows = tuple[Vector, Vector, Vector]


class Spatial(NamedTuple):
    """The symmetric 6x6 matrix ``[[A, B], [B^T, M]]``: ``A`` and ``M`` are symmetric, ``B`` is by rows."""

    A: Symmetric
    B: Rows
    M: Symmetric

    def with_(self, other: Spatial) -> Spatial:
        """The sum of both."""
        one, two, three = (plus(u, v) for u, v in zip(self.B, other.B, strict=True))
        return Spatial(self.A.plus(other.A), (one, two, three), self.M.plus(other.M))

    def times(self, u: Vector, v: Vector) -> Pair:
        """The product with two vectors: ``(A u + B v, B^T u + M v)``."""
        columns = zip(*self.B, strict=True)
        bx, by, bz = (dot((x, y, z), u) for x, y, z in columns)
        mx, my, mz = (dot(row, v) for row in self.B)
        return plus(self.A.times(u), (mx, my, mz)), plus((bx, by, bz), self.M.times(v))

    def about_x(self, c: Any, s: Any) -> Spatial:
        """The same rotated about x by the angle of cosine ``c`` and sine ``s``."""
        return Spatial(self.A.about_x(c, s), rows_about_x(c, s, self.B), self.M.about_x(c, s))

    def about_z(self, c: Any, s: Any) -> Spatial:
        """The same rotated about z by the angle of cosine ``c`` and sine ``s``."""
        return Spatial(self.A.about_z(c, s), rows_about_z(c, s, self.B), self.M.about_z(c, s))

    def moved(self, r: Vector) -> Spatial:
        """The same, inertia or response, at a new origin. ``r`` points from the new origin to the old one."""
        # With R u = r x u, the new blocks are B' = B + R M and A' = A - B R + R B'^T.
        A, B, M = self.A, self.B, self.M
        columns = [cross(r, u) for u in ((M.xx, M.xy, M.xz), (M.xy, M.yy, M.yz), (M.xz, M.yz, M.zz))]
        new_B = [plus(row, increment) for row, increment in zip(B, zip(*columns, strict=True), strict=True)]
        B_R = [cross(row, r) for row in B]
        R_new_B = list(zip(*(cross(r, row) for row in new_B), strict=True))

        def entry(old: Any, row: int, column: int) -> Any:
            return old - B_R[row][column] + R_new_B[row][column]

        new_A = Symmetric(
            entry(A.xx, 0, 0), entry(A.yy, 1, 1), entry(A.zz, 2, 2),
            entry(A.xy, 0, 1), entry(A.xz, 0, 2), entry(A.yz, 1, 2),
        )  # fmt: skip
        return Spatial(new_A, (new_B[0], new_B[1], new_B[2]), M)

    def named(self, link: int, quantity: str, mark: Mark) -> Spatial:
        """The same with each entry marked as ``quantity`` of ``link``."""
        x, y, z = (
            named(mark, row, link, f"{quantity}b{axis}") for row, axis in zip(self.B, AXES, strict=True)
        )
        A, M = (part.named(mark, link, quantity + of) for part, of in ((self.A, "a"), (self.M, "m")))
        return Spatial(A, (x, y, z), M)


def inertia_of(lump: Lump) -> Spatial:
    """The inertia of a link alone."""
    m, (x, y, z) = lump.mass, lump.first
    return Spatial(lump.inertia(), ((0, -z, y), (z, 0, -x), (-y, x, 0)), Symmetric(m, m, m, 0, 0, 0))


def less(k: Symmetric, u: Vector, v: Vector) -> Symmetric:
    """``k - u v^T``, which is symmetric."""
    return Symmetric(
        k.xx - u[0] * v[0], k.yy - u[1] * v[1], k.zz - u[2] * v[2],
        k.xy - u[0] * v[1], k.xz - u[0] * v[2], k.yz - u[1] * v[2],
    )  # fmt: skip


class Composite(NamedTuple):
    """All bodies that a joint carries, about an origin: mass moments ``lump``, force ``f`` and moment ``n``.
    With ``u`` a velocity relative to the link, ``p = integral of u dm`` and ``N = integral of u r^T dm`` by
    rows."""

    lump: Lump
    p: Vector
    N: Rows
    f: Vector
    n: Vector

    def turned_x(self, c: Any, s: Any) -> Composite:
        """The same rotated about x by the angle of cosine ``c`` and sine ``s``."""
        p, f, n = (about_x(c, s, u) for u in (self.p, self.f, self.n))
        return Composite(about_axis_x(self.lump, c, s), p, rows_about_x(c, s, self.N), f, n)

    def turned_z(self, c: Any, s: Any) -> Composite:
        """The same rotated about z by the angle of cosine ``c`` and sine ``s``."""
        p, f, n = (about_z(c, s, u) for u in (self.p, self.f, self.n))
        return Composite(about_axis_z(self.lump, c, s), p, rows_about_z(c, s, self.N), f, n)

    def about(self, r: Vector) -> Composite:
        """The same about a new origin. ``r`` points from the new origin to the old one."""
        x, y, z = (plus(row, scaled(u, r)) for row, u in zip(self.N, self.p, strict=True))
        n = plus(self.n, cross(r, self.f))
        return Composite(shifted(self.lump, r), self.p, (x, y, z), self.f, n)

    def with_(self, other: Composite) -> Composite:
        """Both bodies as one."""
        x, y, z = map(plus, self.N, other.N)
        lump, p = merged(self.lump, other.lump), plus(self.p, other.p)
        return Composite(lump, p, (x, y, z), plus(self.f, other.f), plus(self.n, other.n))

    def named(self, link: int, mark: Mark) -> Composite:
        """The same, of ``link``, with each component marked."""
        lump = self.lump.named(mark, link)
        x, y, z = (named(mark, row, link, f"u{axis}") for row, axis in zip(self.N, AXES, strict=True))
        p, f, n = (named(mark, u, link, name) for u, name in ((self.p, "p"), (self.f, "f"), (self.n, "n")))
        return Composite(lump, p, (x, y, z), f, n)

    def moving(self, arm: Arm, i: int, rate: Any) -> Composite:
        """The same with momenta relative to the link before joint ``i``; the joint moves at ``rate``."""
        lump, k = self.lump, self.lump.second
        h = lump.first
        if arm.bodies[i].revolute:
            p = plus(self.p, (-(rate * h[1]), rate * h[0], 0))
            increments: Rows = (
                (-(rate * k.xy), -(rate * k.yy), -(rate * k.yz)),
                (rate * k.xx, rate * k.xy, rate * k.xz),
                ZERO,
            )
        else:
            p = plus(self.p, (0, 0, rate * lump.mass))
            increments = (ZERO, ZERO, scaled(rate, h))
        x, y, z = (plus(row, increment) for row, increment in zip(self.N, increments, strict=True))
        return Composite(lump, p, (x, y, z), self.f, self.n)


NO_COMPOSITE = Composite(NO_LUMP, ZERO, (ZERO, ZERO, ZERO), ZERO, ZERO)


def rows_about_x(c: Any, s: Any, N: Rows) -> Rows:
    """``R N R^T`` for a rotation ``R`` about x."""
    columns = [about_x(c, s, (N[0][k], N[1][k], N[2][k])) for k in range(3)]
    rows = [about_x(c, s, (columns[0][k], columns[1][k], columns[2][k])) for k in range(3)]
    return rows[0], rows[1], rows[2]


def rows_about_z(c: Any, s: Any, N: Rows) -> Rows:
    """``R N R^T`` for a rotation ``R`` about z. Entries of the upper 2x2 block share their products."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = N
    cc, cs = c * c, c * s
    diagonal = cc * (xx - yy) - cs * (xy + yx)
    off_diagonal = cs * (xx - yy) + cc * (xy + yx)
    return (
        (yy + diagonal, off_diagonal - yx, c * xz - s * yz),
        (off_diagonal - xy, xx - diagonal, s * xz + c * yz),
        (c * zx - s * zy, s * zx + c * zy, zz),
    )
