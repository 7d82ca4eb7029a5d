"""An arm in motion with the masses of its links, where they take the fewest operations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm, Motion
    from robodyn.dynamics.lump import Lump
    from robodyn.dynamics.parallel import Turns


@dataclass(frozen=True, slots=True)
class Moving:
    """An arm in motion, its joints' ``turns``, and the mass, first and second moments of each link about its
    frame's origin: those described, or others that move alike (then a mass may be 0 or less), what they lack
    of mass and first moment being that of ``ground``, at rest, about the base's origin. Where they are
    ``weighed``, masses are times the largest component of gravity, and the arm's gravity in units of that."""

    arm: Arm
    motion: Motion
    turns: Turns
    lumps: Sequence[Lump]
    ground: Lump
    weighed: bool = False
