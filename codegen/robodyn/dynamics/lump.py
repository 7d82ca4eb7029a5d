"""The moments of a link's mass."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.vectors import Mark, Vector, named

#: How the moment of a link about its origin is written.
#:
#: ``inertia``: ``I alpha + D k``, Euler's equation; ``second_moment``: from ``lambda K``;
#: ``isotropic_x`` (y, z): ``2 k alpha`` for as much of ``K`` as is ``k`` times the identity, ``k`` being the
#: second moment along that axis, and ``lambda K`` for the rest; ``point_x`` (y, z): an isotropic body and a
#: point mass on the axis; ``spin``: a body without mass that only resists to turn about its own axis z;
#: ``wrist``: the last link but one, isotropic with a point mass on its y axis, which is the last joint's,
#: together with the last link, a spin.
MomentForm = Literal[
    "inertia", "second_moment", "isotropic_x", "isotropic_y", "isotropic_z", "point_x", "point_y", "point_z",
    "spin", "wrist",
]  # fmt: skip


@dataclass(frozen=True, slots=True)
class Lump:
    """A link's mass [kg], first moment [kg m] and second moment [kg m^2] about its frame's origin.

    ``second`` is the integral of ``r r^T`` over the mass; the inertia tensor is its trace times the
    identity less itself.
    """

    mass: Any
    first: Vector
    second: Symmetric

    def inertia(self) -> Symmetric:
        """Inertia tensor about the frame's origin [kg m^2]."""
        k = self.second
        return Symmetric(k.yy + k.zz, k.xx + k.zz, k.xx + k.yy, -k.xy, -k.xz, -k.yz)

    def named(self, mark: Mark, link: int) -> Lump:
        """The same, of ``link``, with each component marked."""
        first = named(mark, self.first, link, "h")
        return Lump(self.mass, first, self.second.named(mark, link, "k"))


#: Nothing at all.
NO_LUMP = Lump(0, (0, 0, 0), Symmetric(0, 0, 0, 0, 0, 0))
