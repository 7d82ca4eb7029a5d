"""The moments of a link's mass."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from robodyn.dynamics.arm import Symmetric
from robodyn.dynamics.vectors import Vector


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
