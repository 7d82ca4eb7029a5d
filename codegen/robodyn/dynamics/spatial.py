"""Symmetric 6x6 forms of two vectors, about an origin: inertias of bodies that joints let move, over any
scalar, and what such bodies answer with.

An inertia takes the accelerations ``(alpha, a)``, angular and of the frame's origin, to the moment and force
that they take. What a link answers with takes the force and moment at its origin to ``(a, alpha)``, in this
order: moved to another origin, the two are alike, one outward and the other inward.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.composite import Rows, rows_about_x, rows_about_z
from robodyn.dynamics.lump import Lump
from robodyn.dynamics.regroup import tensor_about_x, tensor_about_z
from robodyn.dynamics.vectors import AXES, Mark, Vector, cross, dot, named, plus
from robodyn.ir.program import Label

#: Two vectors, as a form takes and gives them.
Pair = tuple[Vector, Vector]


@dataclass(frozen=True, slots=True)
class Spatial:
    """``(u, v)`` to ``(A u + B v, B^T u + M v)``: ``A`` and ``M`` symmetric, ``B`` by rows."""

    A: Symmetric
    B: Rows
    M: Symmetric

    def with_(self, other: Spatial) -> Spatial:
        """The sum of both."""
        one, two, three = (plus(u, v) for u, v in zip(self.B, other.B, strict=True))
        return Spatial(_sum(self.A, other.A), (one, two, three), _sum(self.M, other.M))

    def times(self, u: Vector, v: Vector) -> Pair:
        """What the form makes of two vectors."""
        columns = zip(*self.B, strict=True)
        bx, by, bz = (dot((x, y, z), u) for x, y, z in columns)
        mx, my, mz = (dot(row, v) for row in self.B)
        return plus(self.A.times(u), (mx, my, mz)), plus((bx, by, bz), self.M.times(v))

    def about_x(self, c: Any, s: Any) -> Spatial:
        """The same along axes turned back about x."""
        return Spatial(tensor_about_x(self.A, c, s), rows_about_x(c, s, self.B), tensor_about_x(self.M, c, s))

    def about_z(self, c: Any, s: Any) -> Spatial:
        """The same along axes turned back about z."""
        return Spatial(tensor_about_z(self.A, c, s), rows_about_z(c, s, self.B), tensor_about_z(self.M, c, s))

    def moved(self, r: Vector) -> Spatial:
        """Of an inertia the same about a point from which its origin lies at ``r``; of an answer, at a point
        that lies at ``-r`` from its own."""
        # With R u = r x u: B + R M, and A - B R + R (B + R M)^T.
        A, B, M = self.A, self.B, self.M
        columns = [cross(r, u) for u in ((M.xx, M.xy, M.xz), (M.xy, M.yy, M.yz), (M.xz, M.yz, M.zz))]
        moved = [plus(row, more) for row, more in zip(B, zip(*columns, strict=True), strict=True)]
        right = [cross(row, r) for row in B]
        left = list(zip(*(cross(r, row) for row in moved), strict=True))

        def entry(own: Any, row: int, column: int) -> Any:
            return own - right[row][column] + left[row][column]

        shifted = Symmetric(
            entry(A.xx, 0, 0), entry(A.yy, 1, 1), entry(A.zz, 2, 2),
            entry(A.xy, 0, 1), entry(A.xz, 0, 2), entry(A.yz, 1, 2),
        )  # fmt: skip
        return Spatial(shifted, (moved[0], moved[1], moved[2]), M)

    def named(self, link: int, quantity: str, mark: Mark) -> Spatial:
        """The same with each entry marked as ``quantity`` of ``link``."""

        def tensor(k: Symmetric, part: str) -> Symmetric:
            entries = zip(k.entries(), ("xx", "yy", "zz", "xy", "xz", "yz"), strict=True)
            return Symmetric(*(mark(value, Label(link, quantity + part, axes)) for value, axes in entries))

        x, y, z = (
            named(mark, row, link, f"{quantity}b{axis}") for row, axis in zip(self.B, AXES, strict=True)
        )
        return Spatial(tensor(self.A, "a"), (x, y, z), tensor(self.M, "m"))


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


def _sum(one: Symmetric, other: Symmetric) -> Symmetric:
    return Symmetric(*(u + v for u, v in zip(one.entries(), other.entries(), strict=True)))
