"""SDF out of a robot, as http://sdformat.org/spec has it: a world, since gravity is one's. The version is
1.9, or that which knows joints that follow others where there are any."""

from __future__ import annotations

from robodyn.formats.tree import Mimic
from robodyn.formats.writers import Tag, decimal, decimals, leaf, tag
from robodyn.formats.writers.parts import TENSOR, Cylinder, Frame, PartJoint, Parts, cylinders


def root(parts: Parts) -> Tag:
    """The element ``<sdf>``."""
    pictures = cylinders(parts)
    elements = [_pose(parts.base)] if parts.base is not None else []
    elements += [
        tag("joint", leaf("parent", "world"), leaf("child", "base"), name="base_joint", type="fixed"),
        tag("link", *_visuals(pictures[0]), name="base"),
    ]
    parent = "base"
    for joint, picture in zip(parts.joints, pictures[1:], strict=True):
        elements += [_joint(joint, parent), _link(joint, picture)]
        parent = joint.link
    if parts.tool is not None:
        elements.append(tag("frame", _pose(parts.tool), name="tool", attached_to=parent))
    model = tag("model", *elements, name=parts.name)
    world = tag("world", leaf("gravity", decimals(parts.gravity)), model, name=f"{parts.name}_world")
    follows = any(joint.mimic for joint in parts.joints)
    return tag("sdf", world, version="1.11" if follows else "1.9")


def _joint(joint: PartJoint, parent: str) -> Tag:
    limits = joint.limits
    lower, upper = limits.position or (None, None)
    ends = {"lower": lower, "upper": upper, "effort": limits.torque, "velocity": limits.velocity}
    limit = [leaf(name, decimal(float(value))) for name, value in ends.items() if value is not None]
    passive = {"damping": joint.viscous, "friction": joint.coulomb}
    if joint.spring:
        passive |= {"spring_reference": joint.spring.rest, "spring_stiffness": joint.spring.stiffness}
    dynamics = [leaf(name, decimal(value)) for name, value in passive.items() if value]
    axis = tag(
        "axis",
        leaf("xyz", "0 0 1"),
        tag("limit", *limit) if limit else None,
        tag("dynamics", *dynamics) if dynamics else None,
        _mimic(joint.mimic) if joint.mimic else None,
    )
    links = leaf("parent", parent), leaf("child", joint.link)
    return tag("joint", _pose(joint.frame, parent), *links, axis, name=joint.name, type=joint.word)


def _mimic(mimic: Mimic) -> Tag:
    numbers = {"multiplier": mimic.multiplier, "offset": mimic.offset, "reference": 0.0}
    return tag("mimic", *(leaf(name, decimal(value)) for name, value in numbers.items()), joint=mimic.leader)


def _link(joint: PartJoint, picture: tuple[Cylinder, ...]) -> Tag:
    body = joint.body
    entries = [leaf(key, decimal(entry)) for key, entry in zip(TENSOR, body.inertia, strict=True)]
    inertial = tag(
        "inertial",
        _pose(Frame(body.com)) if any(body.com) else None,
        leaf("mass", decimal(body.mass)),
        tag("inertia", *entries),
    )
    return tag("link", tag("pose", relative_to=joint.name), inertial, *_visuals(picture), name=joint.link)


def _visuals(picture: tuple[Cylinder, ...]) -> list[Tag]:
    visuals = []
    for index, each in enumerate(picture, 1):
        sizes = leaf("radius", decimal(each.radius)), leaf("length", decimal(each.length))
        pose = _pose(each.frame) if each.frame != Frame() else None
        visuals.append(
            tag("visual", pose, tag("geometry", tag("cylinder", *sizes)), name=f"cylinder_{index}")
        )
    return visuals


def _pose(frame: Frame, relative_to: str = "") -> Tag:
    attributes = {"relative_to": relative_to} if relative_to else {}
    return leaf("pose", decimals((*frame.xyz, *frame.rpy)), **attributes)
