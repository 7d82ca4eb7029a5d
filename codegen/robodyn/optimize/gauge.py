"""Regrouping with a choice: how much of each link's moments of mass moves to its parent, and where its
frame's origin stands.

From tip to base each link takes in what its child gave up, slides its origin along the joint's axis, and
gives up what its rules say. All numbers are exact; a rule that would divide by a run-time parameter, or ask
whether it is zero, does not suit the arm (:class:`Unsuited`).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, Body, Symmetric, origin
from robodyn.dynamics.lump import NO_LUMP, Lump
from robodyn.dynamics.regroup import about_axis_z, lumps_of, merged, moved_into, shifted
from robodyn.errors import InputError
from robodyn.optimize.variant import LinkVariant, Variant


class Unsuited(InputError):
    """A variant that does not suit the arm."""

    def __init__(self, link: int, why: str) -> None:
        super().__init__(f"the variant does not suit link {link}", found=why, remedy="search again")


@dataclass(frozen=True, slots=True)
class Point:
    """An isotropic body and a point mass: ``second`` the body's second moment along any axis [kg m^2],
    ``mass`` [kg] at ``distance`` [m] from the origin, ``rest`` [kg] at the origin."""

    second: Any
    mass: Any
    distance: Any
    rest: Any


@dataclass(frozen=True, slots=True)
class Regrouped:
    """A link after regrouping: its lump; its frame's origin in the parent's, ``(x, 0, lift)``, the
    displacement ``d`` along its own axis, and ``side``, along y behind the twist; ``point`` where its form
    asks for one."""

    lump: Lump
    x: Any
    lift: Any
    d: Any
    point: Point | None
    side: Any = 0


@dataclass(frozen=True, slots=True)
class Handed:
    """What a link gives to its parent: ``moved``, in the parent's frame, and by how far the link's origin
    slid along its axis. ``own`` is the link's lump, ``d`` its displacement; ``x`` is the parent's."""

    own: Lump
    moved: Lump
    d: Any
    slid: Any


AT_TIP = Handed(NO_LUMP, NO_LUMP, 0, 0)


def check_size(arm: Arm, variant: Variant) -> None:
    """:class:`InputError` where ``variant`` has not as many links as ``arm``."""
    if len(variant.links) != len(arm.bodies):
        raise InputError(
            "a variant of another arm", found=f"{len(variant.links)} links", expected=f"{len(arm.bodies)}"
        )


def regrouped_as(arm: Arm, variant: Variant) -> tuple[list[Regrouped], Any]:
    """The links of ``arm`` as ``variant`` has them, and the unit of length [m]."""
    check_size(arm, variant)
    lumps = lumps_of(arm)
    gauges = [AT_TIP] * (len(lumps) + 1)
    for i in reversed(range(len(lumps))):
        gauges[i] = give(arm, lumps, i, variant.links[i], gauges[i + 1])
    return assembled(arm, variant, gauges)


def in_scalars(link: Regrouped, constant: Callable[[Any], Any]) -> Regrouped:
    """``link`` with ``constant`` applied to its numbers."""
    lump, point = link.lump, link.point
    x, y, z = map(constant, lump.first)
    if point is not None:
        point = Point(*map(constant, (point.second, point.mass, point.distance, point.rest)))
    second = Symmetric(*map(constant, lump.second.entries()))
    lump = Lump(constant(lump.mass), (x, y, z), second)
    x, lift, d, side = map(constant, (link.x, link.lift, link.d, link.side))
    return Regrouped(lump, x, lift, d, point, side)


def with_displacements(arm: Arm, links: Sequence[Regrouped], unit: Any) -> Arm:
    """``arm`` with the displacements ``d`` [m] of the origins that its regrouped links have."""
    bodies = zip(arm.bodies, links, strict=True)
    return replace(arm, bodies=tuple(replace(body, d=link.d * unit) for body, link in bodies))


def assembled(arm: Arm, variant: Variant, gauges: Sequence[Handed]) -> tuple[list[Regrouped], Any]:
    """The links, from what each gave, lengths in the unit of ``variant``; and that unit [m]."""
    links = []
    for i, body in enumerate(arm.bodies):
        point = point_of(i, gauges[i].own, variant.links[i])
        lift = -gauges[i - 1].slid if i else 0
        links.append(Regrouped(gauges[i].own, body.a, lift, gauges[i].d, point, body.b))
    if variant.unit == "metre":
        return links, 1
    chosen = links[variant.unit_link - 1]
    length = chosen.x if variant.unit == "a" else chosen.d
    if variant.unit == "point":
        length = chosen.point.distance if chosen.point else 0
    if not _known(length) or not length:
        raise Unsuited(variant.unit_link, "no length that could be the unit")
    length = _ratio(length, 1)
    return [_in_unit(link, length) for link in links], length


def give(arm: Arm, lumps: Sequence[Lump], i: int, rules: LinkVariant, child: Handed) -> Handed:
    """What link ``i`` (from 0) has and gives, its child having given."""
    body = arm.bodies[i]
    lump = merged(lumps[i], child.moved) if child is not AT_TIP else lumps[i]
    slid = _slide(arm, i, rules, lump, child)
    if slid:
        lump = shifted(lump, (0, 0, -slid))
    d = body.d + slid
    parent = lumps[i - 1] if i else NO_LUMP
    if body.revolute:
        moved = _moved(i, body, d, lump, rules, parent)
        kept = _less(lump, moved)
    else:
        if rules.mass != "zero" or rules.first != "zero" or rules.second not in ("zero", "keep"):
            raise Unsuited(i + 1, "a prismatic joint, whose link can give up its second moment only")
        moved = NO_LUMP if rules.second == "keep" else Lump(0, (0, 0, 0), lump.second)
        kept = _less(lump, moved)
        moved = about_axis_z(moved, body.theta.cos, body.theta.sin)
    return Handed(kept, in_parent(moved, body, d) if i else NO_LUMP, d, slid)


def in_parent(lump: Lump, body: Body, d: Any) -> Lump:
    """``lump``, given along the axes of a body's frame before its turn about z, in the parent's frame."""
    return moved_into(lump, body.cos_alpha, body.sin_alpha, origin(body, d))


def _known(*values: Any) -> bool:
    """Whether values are numbers; what is known only at run time is not tested nor divided by."""
    return all(isinstance(value, (int, Fraction)) or getattr(value, "is_Rational", False) for value in values)


def _ratio(a: Any, b: Any) -> Any:
    """``a / b``, exact among integers too."""
    return (Fraction(a) if isinstance(a, int) else a) / b


def _slide(arm: Arm, i: int, rules: LinkVariant, lump: Lump, child: Handed) -> Any:
    """How far the origin of link ``i`` moves along its axis [m]."""
    if rules.slide == "none":
        return 0
    if rules.slide == "own":
        return -arm.bodies[i].d
    if rules.slide == "next":
        if i + 1 == len(arm.bodies):
            raise Unsuited(i + 1, "no next origin to slide to")
        return arm.bodies[i + 1].cos_alpha * child.d
    if rules.slide in ("xz", "yz"):
        k = lump.second
        h, product = (lump.first[0], k.xz) if rules.slide == "xz" else (lump.first[1], k.yz)
        if not _known(h) or not h:
            raise Unsuited(i + 1, "no first moment across the axis and so no product to slide away")
        return _ratio(product, h)
    if not _known(lump.mass) or not lump.mass:
        raise Unsuited(i + 1, "no mass and so no centre of mass to slide to")
    return _ratio(lump.first[2], lump.mass)


def _moved(i: int, body: Body, d: Any, lump: Lump, rules: LinkVariant, parent: Lump) -> Lump:
    """What the link of a revolute joint gives up, in its own frame."""
    k = lump.second

    def from_here(mass: Any, first: Any, second: Any) -> Lump:
        return Lump(mass, (0, 0, first), Symmetric(0, 0, second, 0, 0, 0))

    def parent_with(mass: Any, first: Any, second: Any) -> Lump:
        return merged(parent, in_parent(from_here(mass, first, second), body, d))

    mass, first, second = lump.mass, lump.first[2], k.zz
    if i == 0 and (rules.mass, rules.first, rules.second) != ("zero", "zero", "zero"):
        raise Unsuited(1, "a base that takes everything")
    if rules.second in _OWN_SECOND:
        second = k.zz - _OWN_SECOND[rules.second](k)
    elif rules.second != "zero":
        sine = body.sin_alpha
        if not sine or not _known(sine):
            raise Unsuited(i + 1, "an axis parallel to the parent's")
        at = parent_with(mass, first, 0).second
        second = _ratio(_PARENT_SECOND[rules.second](at) - at.yy, sine * sine)
    if rules.first == "keep":
        first = 0
    elif rules.first == "parent_first":
        if not body.sin_alpha:
            raise Unsuited(i + 1, "an axis parallel to the parent's")
        first = _ratio(parent_with(mass, 0, 0).first[1], body.sin_alpha)
    if rules.mass == "keep":
        mass = 0
    elif rules.mass in ("point_x", "point_y"):
        on_x = rules.mass == "point_x"
        h, along, across = (lump.first[0], k.xx, k.yy) if on_x else (lump.first[1], k.yy, k.xx)
        if not _known(h, along, across) or along == across:
            raise Unsuited(i + 1, "no point mass to be seen")
        mass = lump.mass - _ratio(h * h, along - across)
    elif rules.mass != "zero":
        if not _known(body.a) or not body.a:
            raise Unsuited(i + 1, "no lever on the parent's x axis")
        at_zero = parent_with(0, first, second)
        if rules.mass == "parent_first":
            mass = -_ratio(at_zero.first[0], body.a)
        else:
            mass = -_ratio(at_zero.second.xx, body.a * body.a)
    return from_here(mass, first, second)


_OWN_SECOND: dict[str, Callable[[Symmetric], Any]] = {
    "keep": lambda k: k.zz,
    "xx": lambda k: k.xx,
    "yy": lambda k: k.yy,
    "-xx": lambda k: -k.xx,
    "-yy": lambda k: -k.yy,
}
_PARENT_SECOND: dict[str, Callable[[Symmetric], Any]] = {
    "parent_zero": lambda k: 0,
    "parent_xx": lambda k: k.xx,
    "parent_-xx": lambda k: -k.xx,
}


def _less(lump: Lump, moved: Lump) -> Lump:
    """``lump`` without ``moved``."""
    x, y, z = moved.first
    entries = (u - v for u, v in zip(lump.second.entries(), moved.second.entries(), strict=True))
    hx, hy, hz = lump.first
    return Lump(lump.mass - moved.mass, (hx - x, hy - y, hz - z), Symmetric(*entries))


def point_of(i: int, lump: Lump, rules: LinkVariant) -> Point | None:
    """The point mass that the form of link ``i`` asks for."""
    form = rules.form
    if form == "spin":
        k = lump.second
        still = (*lump.first, lump.mass, k.xy, k.xz, k.yz, k.xx - k.yy, k.xx + k.zz)
        if not _known(*still, k.xx) or any(still) or not k.xx:
            raise Unsuited(i + 1, "more than a body that resists to turn about its axis")
        return None
    if form != "wrist" and not form.startswith("point_"):
        return None
    axis = 1 if form == "wrist" else "xyz".index(form[-1])
    k, h = lump.second, lump.first
    along, one, other = ((k.xx, k.yy, k.zz)[(axis + j) % 3] for j in range(3))
    nothing = (k.xy, k.xz, k.yz, one - other, h[(axis + 1) % 3], h[(axis + 2) % 3])
    if not _known(*nothing, along, h[axis]) or any(nothing) or not h[axis] or along == one:
        raise Unsuited(i + 1, "more than an isotropic body and a point mass on the axis")
    distance = _ratio(along - one, h[axis])
    mass = _ratio(h[axis], distance)
    return Point(one, mass, distance, lump.mass - mass)


def _in_unit(link: Regrouped, length: Any) -> Regrouped:
    """``link`` with lengths as multiples of ``length``; moments [kg m^2] stay what they are."""
    lump, point = link.lump, link.point
    x, y, z = lump.first
    if point is not None:
        square = length * length
        point = Point(point.second, point.mass * square, _ratio(point.distance, length), point.rest * square)
    lump = Lump(lump.mass * length * length, (x * length, y * length, z * length), lump.second)
    x, lift, d, side = (_ratio(u, length) for u in (link.x, link.lift, link.d, link.side))
    return Regrouped(lump, x, lift, d, point, side)
