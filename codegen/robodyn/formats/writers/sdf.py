"""SDF out of a robot, version 1.9 of http://sdformat.org/spec: a world, since gravity is one's."""

from __future__ import annotations

from typing import Final

from robodyn.formats.writers.markup import Tag, decimal, decimals, leaf, tag
from robodyn.formats.writers.parts import Cylinder, Frame, PartJoint, Parts, cylinders

_VERSION: Final = "1.9"


def root(parts: Parts) -> tuple[Tag, list[str]]:
    """The element ``<sdf>``, and what it does not say of ``parts``."""
    pictures = cylinders(parts)
    missing = []
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
    if any(joint.motor_inertia for joint in parts.joints):
        missing.append("rotor inertias")
    if any(joint.gear for joint in parts.joints):
        missing.append("gear ratios")
    if any(joint.limits.acceleration is not None for joint in parts.joints):
        missing.append("limits of acceleration")
    return tag("sdf", world, version=_VERSION), missing


def _joint(joint: PartJoint, parent: str) -> Tag:
    limits = joint.limits
    position = limits.position or (None, None)
    stated = zip(
        ("lower", "upper", "effort", "velocity"), (*position, limits.torque, limits.velocity), strict=True
    )
    ends = [leaf(name, decimal(float(value))) for name, value in stated if value is not None]
    sits: tuple[tuple[str, float], ...] = (("damping", joint.viscous), ("friction", joint.coulomb))
    if joint.spring:
        sits += (("spring_reference", joint.spring.rest), ("spring_stiffness", joint.spring.stiffness))
    dynamics = [leaf(name, decimal(value)) for name, value in sits if value]
    axis = tag(
        "axis",
        leaf("xyz", "0 0 1"),
        tag("limit", *ends) if ends else None,
        tag("dynamics", *dynamics) if dynamics else None,
    )
    pose = _pose(joint.frame, parent)
    ends_of = leaf("parent", parent), leaf("child", joint.link)
    free = limits.position is None and joint.kind == "revolute"
    return tag("joint", pose, *ends_of, axis, name=joint.name, type="continuous" if free else joint.kind)


def _link(joint: PartJoint, picture: tuple[Cylinder, ...]) -> Tag:
    body = joint.body
    keys = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
    entries = [leaf(key, decimal(entry)) for key, entry in zip(keys, body.inertia, strict=True)]
    inertial = tag(
        "inertial",
        _pose(Frame(body.com)) if any(body.com) else None,
        leaf("mass", decimal(body.mass)),
        tag("inertia", *entries),
    )
    return tag("link", tag("pose", relative_to=joint.name), inertial, *_visuals(picture), name=joint.link)


def _visuals(picture: tuple[Cylinder, ...]) -> list[Tag]:
    return [
        tag(
            "visual",
            _pose(each.frame) if each.frame != Frame() else None,
            tag(
                "geometry",
                tag("cylinder", leaf("radius", decimal(each.radius)), leaf("length", decimal(each.length))),
            ),
            name=f"cylinder_{index}",
        )
        for index, each in enumerate(picture, 1)
    ]


def _pose(frame: Frame, relative_to: str = "") -> Tag:
    attributes = {"relative_to": relative_to} if relative_to else {}
    return leaf("pose", decimals((*frame.xyz, *frame.rpy)), **attributes)
