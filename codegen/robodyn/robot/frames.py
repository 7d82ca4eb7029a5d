"""Frames that a description states: of the base and the tool, rows of standard DH, and poses of links in
place of rows. What a robot has are modified (Craig) Denavit-Hartenberg rows.

Standard row i holds a_i and alpha_i of the link itself: frame i, in which the link's centre of mass and
inertia are given, lies at the link's far end, ``Rot(z, theta) Trans(z, d) Trans(x, a) Rot(x, alpha)``
from frame i-1. Modified frame i is the one reached after ``Rot(z, theta) Trans(z, d)`` already, so each
row hands its a and alpha to the next (Craig, Introduction to Robotics, section 3.4).

Of effects a payload moves along with the last link. What a bearing carries (load-dependent friction) and
where a contact acts are meant in the modified frames, whose z is the joint's axis, with the origin on it.

A pose places the frame of a joint in the one before, at q = 0; its z axis is the joint's. It is a turn about
the z axis before, a twist about x, and a turn about its own z axis. The first of the three is taken into the
frame before, which turns about its z axis with all that stands in it (of the first joint: into the base), so
that a row is left, with an offset ``b`` where the origin is not on the common normal. Origins stay.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from fractions import Fraction

from robodyn.robot.document import describe
from robodyn.robot.fields import Section
from robodyn.robot.keys import ROW
from robodyn.robot.parts import EffectEntry, Inertia, Link, Placement, Setting, Vector
from robodyn.robot.rotations import (
    QUARTER_TURN,
    SAME,
    about_x,
    about_z,
    applied,
    placement,
    product,
    summed,
    tidy,
    turned_inertia,
    turned_vector,
    twist_of,
)  # fmt: skip
from robodyn.robot.values import ZERO, Angle, Value, angle, quarter_turns


def placement_at(section: Section, key: str) -> Placement | None:
    """The frame at ``key``; None where it is left out."""
    frame = section.section(key)
    if frame is None:
        return None
    x, y, z = (value for value in frame.vector("xyz") or (ZERO,) * 3 if isinstance(value, Fraction))
    return Placement((x, y, z), frame.angles("rpy"))


def standard_end_of(section: Section, sections: list[Section], last: Link) -> Placement:
    """Where the frame of ``last``, the last standard row, stands in the modified frame."""
    for part in sections:
        if "b" in part.values:
            what = f"{part.path('b')} is an offset of modified DH rows"
            remedy = "delete it, or state modified rows (convention: mdh)"
            part.source.fail(part.values["b"], what, found="convention: sdh", remedy=remedy)
    if "standard_end" in section.values:
        what, remedy = "standard_end is of rows that were converted", "delete it: the last row says it"
        section.source.fail(section.values["standard_end"], what, found="convention: sdh", remedy=remedy)
    if not isinstance(last.joint.a, Fraction):
        part = sections[-1]
        part.source.fail(
            part.values["a"],
            f"{part.path('a')} cannot be a run-time parameter: it places the tool's frame",
            found=describe(part.values["a"]),
            expected="a number",
            remedy="state a number, or modified rows (convention: mdh)",
        )
    return Placement((last.joint.a, ZERO, ZERO), (last.joint.alpha, quarter_turns(0), quarter_turns(0)))


def pose_at(section: Section, convention: str) -> Placement | None:
    """The pose of a link's frame that stands in place of its row; None where the row is stated."""
    pose = placement_at(section, "pose")
    beside = [key for key in ROW if key in section.values]
    if pose is not None and (beside or convention == "sdh"):
        section.source.fail(
            section.values["pose"],
            f"{section.path('pose')} stands in place of DH numbers",
            found=", ".join(beside) + " beside it" if beside else "convention: sdh",
            expected=f"pose, or {', '.join(ROW)}",
            remedy="delete the one or the other"
            if beside
            else "convention: mdh: a pose is that of the joint",
        )
    return pose


def from_poses(
    links: Sequence[Link], poses: Sequence[Placement | None], base: Placement | None
) -> tuple[tuple[Link, ...], Placement | None]:
    """``links`` by their rows, those with a pose turned into one; and where the base frame then stands.

    Right angles keep every number exact; at other angles what is turned is rounded to double.

    Raises
    ------
    OverflowError: a number grows beyond double.
    """
    converted = list(links)
    for i, pose in enumerate(poses):
        if pose is None:
            continue
        phi, alpha, theta = _angles(pose)
        row = applied(about_x(-alpha), applied(about_z(-phi), pose.xyz))
        size = math.hypot(*pose.xyz)
        a, b, d = (
            row if alpha.quarter is not None and phi.quarter is not None else (tidy(x, size) for x in row)
        )
        joint = replace(converted[i].joint, alpha=alpha, a=a, b=b, d=d, theta=theta)
        converted[i] = replace(converted[i], joint=joint)
        if phi.quarter == 0:
            continue
        if i:
            converted[i - 1] = _turned(converted[i - 1], phi)
        else:
            rotation, origin = (SAME, (ZERO,) * 3) if base is None else (base.rotation, base.xyz)
            base = placement(product(rotation, about_z(phi)), origin, 0.0)
    return tuple(converted), base


def _angles(pose: Placement) -> tuple[Angle, Angle, Angle]:
    """Turn before, twist and turn behind; of both ways to say it that which turns the frame before less."""
    twist = twist_of(pose.rotation, QUARTER_TURN)
    half = quarter_turns(2)
    other = summed(twist.phi, half)
    if abs(other.radians) < abs(twist.phi.radians):
        return other, -twist.alpha, summed(twist.theta, half)
    return twist.phi, twist.alpha, twist.theta


def _turned(link: Link, phi: Angle) -> Link:
    """``link`` with its frame turned by ``phi`` about its z axis."""
    back, exact = about_z(-phi), phi.quarter is not None
    x, y, _ = turned_vector(back, link.com, exact=exact)
    inertia = replace(turned_inertia(back, link.inertia, exact=exact), zz=link.inertia.zz)
    joint = replace(link.joint, theta=summed(link.joint.theta, phi))
    return replace(link, joint=joint, com=(x, y, link.com[2]), inertia=inertia)


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
                inertia=_tensor(link.inertia, own_alpha),
            )
        )
        a, alpha = own_a, own_alpha
    return tuple(converted)


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
        moved["inertia"] = _tensor(entry["inertia"], alpha)
    return replace(entry, settings=tuple(moved.items()))


def _centre(mass: Value, com: Vector, a: Value, alpha: Angle) -> Vector:
    """Centre of mass seen from the modified frame: (a, 0, 0) + Rot(x, alpha) com."""
    if mass == 0 and com == (ZERO, ZERO, ZERO):
        return com  # a link without mass has no centre: do not invent one
    _, y, z = turned_vector(about_x(alpha), com, exact=alpha.quarter is not None)
    return a + com[0], y, z


def _tensor(inertia: Inertia, alpha: Angle) -> Inertia:
    """Rot(x, alpha) I Rot(x, alpha)^T."""
    turned = turned_inertia(about_x(alpha), inertia, exact=alpha.quarter is not None)
    return replace(turned, xx=inertia.xx)
