"""How the recursion on base parameters is written: every freedom that changes its cost and not its value.

A revolute link's mass, its first moment along the joint's axis and its second moment along it belong as well
to the parent (:mod:`robodyn.dynamics.regroup`): three numbers a link are free, a *gauge*, and zero is only
the textbook's choice. The moment of a link can be written in several forms, in several frames; lambda's
third row and column and the accelerations of origins in several ways; origins may slide along their axes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal, get_args, get_type_hints

from robodyn.dynamics.lump import MomentForm

#: What a revolute link keeps of its mass: nothing; all; what makes it, with its moments, isotropic and one
#: point mass on an axis and nothing else; what makes the parent's first moment (or second) along x zero.
MassRule = Literal["zero", "keep", "point_x", "point_y", "parent_first", "parent_second"]
#: The same of its first moment along the axis.
FirstRule = Literal["zero", "keep", "parent_first"]
#: The same of its second moment along the axis: as much as its own along x or y, or that much negative
#: (no inertia about the other of the two), or what makes the parent's second moment along y zero, or as
#: much as that along x, or that much negative.
SecondRule = Literal[
    "zero", "keep", "xx", "yy", "-xx", "-yy", "parent_zero", "parent_xx", "parent_-xx"
]  # fmt: skip

#: The axes along which a link's force and moment are written: its own; those in which its joint (or chain
#: of parallel joints) begins to turn; those in which the joint before begins to turn (a last link, a spin).
Frame = Literal["own", "start", "before"]
#: Third row or third column of lambda: from the link's own angular acceleration, or from that of what carries
#: it, turned along; the column also as the parent's lambda, turned along.
Row = Literal["own", "carried", "column"]
Column = Literal["own", "carried", "turned"]
#: The angular acceleration across the axis: the carrier's and what the link's own rate adds, or from lambda's
#: third column less the products of ``w`` (where the column is not made of the angular acceleration).
Alpha = Literal["carried", "column"]
#: Where ``lambda p`` of the next origin is formed: along the parent's own axes, or along those in which it
#: begins to turn.
Carry = Literal["own", "start"]
#: Where the origin goes along the joint's axis: it stays; to where the link's own offset ``d`` is zero; to
#: where the next origin's offset along this axis is zero; to where the lump's first moment along it is zero;
#: to where its product of second moments xz, or yz, is zero.
Slide = Literal["none", "own", "next", "com", "xz", "yz"]
#: The unit of length: metres, or a length that becomes 1: the distance of a link's point mass, its ``a``,
#: its ``d``.
UnitRule = Literal["metre", "point", "a", "d"]


@dataclass(frozen=True, slots=True)
class LinkVariant:
    """How one link is written; see the names above."""

    mass: MassRule = "zero"
    first: FirstRule = "zero"
    second: SecondRule = "zero"
    form: MomentForm = "second_moment"
    frame: Frame = "own"
    row: Row = "own"
    column: Column = "own"
    alpha: Alpha = "carried"
    carry: Carry = "own"
    lever: Carry = "own"
    slide: Slide = "none"
    chained: bool = True


#: The names that each field of a link may have.
LINK_VALUES: dict[str, tuple[Any, ...]] = {
    name: get_args(kind) or (True, False) for name, kind in get_type_hints(LinkVariant).items()
}


@dataclass(frozen=True, slots=True)
class Variant:
    """How the whole recursion is written: its links from base to tip, and the unit of length, which
    ``unit_link`` (from 1) gives."""

    links: tuple[LinkVariant, ...]
    unit: UnitRule = "metre"
    unit_link: int = 0

    def with_link(self, i: int, **changes: Any) -> Variant:
        """The same with ``changes`` in link ``i`` (from 0)."""
        links = list(self.links)
        links[i] = replace(links[i], **changes)
        return replace(self, links=tuple(links))
