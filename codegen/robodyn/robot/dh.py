"""Standard Denavit-Hartenberg rows to modified (Craig) ones.

Standard row i holds a_i and alpha_i of the link itself: frame i, in which the link's centre of mass and
inertia are given, lies at the link's far end, ``Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha)``
from frame i-1. Modified frame i is the one reached after ``Rot(z, theta) Trans(z, d)`` already, so each
row hands its a and alpha to the next (Craig, Introduction to Robotics, section 3.4).

Of effects a payload moves along with the last link. What a bearing carries (load-dependent friction) and
where a contact acts are meant in the modified frames, whose z is the joint's axis, with the origin on it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from robodyn.robot.model import EffectEntry, Inertia, Link, Placement, Setting, Vector
from robodyn.robot.rotations import about_x, applied, placement, product, turned_inertia, turned_vector
from robodyn.robot.values import ZERO, Angle, Value, angle, quarter_turns


def from_standard(links: Iterable[Link]) -> tuple[Link, ...]:
    """The same arm with modified rows; ``links`` hold alpha_i, a_i and inertials of standard frames.

    What stands in the last link's frame moves with it: its centre and inertia, a payload, the tool. Right
    angles keep every number exact; at other twists centres and inertias are rounded to double.

    Raises
    ------
    OverflowError: a number grows beyond double.
    """
    converted = []
    a: Value = ZERO
    alpha = angle(ZERO)
    for link in links:
        own_a, own_alpha = link.joint.a, link.joint.alpha
        converted.append(
            replace(
                link,
                joint=replace(link.joint, a=a, alpha=alpha),
                com=_centre(link.mass, link.com, own_a, own_alpha),
                inertia=_turned(link.inertia, own_alpha),
            )
        )
        a, alpha = own_a, own_alpha
    return tuple(converted)


def standard_end(last: Link) -> Placement:
    """The last standard frame in the last modified one, by ``last``, the last standard row, whose length is a
    number."""
    a, alpha = last.joint.a, last.joint.alpha
    assert isinstance(a, Fraction)
    return Placement((a, ZERO, ZERO), (alpha, quarter_turns(0), quarter_turns(0)))


def tool_from_standard(tool: Placement | None, end: Placement) -> Placement | None:
    """``tool`` of the last standard frame, which stands at ``end``, in the last modified frame."""
    if tool is None:
        return placement(end.rotation, end.xyz, 0.0)
    x, y, z = applied(end.rotation, tool.xyz)
    return placement(product(end.rotation, tool.rotation), (end.xyz[0] + x, y, z), 0.0)


def effect_from_standard(entry: EffectEntry, last: Link) -> EffectEntry:
    """``entry`` for the modified frames: a payload stands in the frame of ``last``, the last standard row.

    Raises
    ------
    OverflowError: a number grows beyond double.
    """
    if not entry.definition.traits.body:
        return entry
    a, alpha = last.joint.a, last.joint.alpha
    moved: dict[str, Setting] = dict(entry.settings)
    moved["com"] = _centre(entry["mass"], entry["com"], a, alpha)
    if "inertia" in entry:
        moved["inertia"] = _turned(entry["inertia"], alpha)
    return replace(entry, settings=tuple(moved.items()))


def _centre(mass: Value, com: Vector, a: Value, alpha: Angle) -> Vector:
    """Centre of mass seen from the modified frame: (a, 0, 0) + Rot(x, alpha) com."""
    if mass == 0 and com == (ZERO, ZERO, ZERO):
        return com  # a link without mass has no centre: do not invent one
    _, y, z = turned_vector(about_x(alpha), com, exact=alpha.quarter is not None)
    return a + com[0], y, z


def _turned(inertia: Inertia, alpha: Angle) -> Inertia:
    """Rot(x, alpha) I Rot(x, alpha)^T."""
    turned = turned_inertia(about_x(alpha), inertia, exact=alpha.quarter is not None)
    return replace(turned, xx=inertia.xx)
