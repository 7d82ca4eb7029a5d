"""URDF out of a robot, as http://wiki.ros.org/urdf/XML has it."""

from __future__ import annotations

from fractions import Fraction
from typing import Final

from robodyn.formats.chain import Body
from robodyn.formats.tree import Mimic
from robodyn.formats.writers import Tag, decimal, decimals, leaf, tag
from robodyn.formats.writers.parts import TENSOR, Cylinder, Frame, PartJoint, Parts, cylinders

#: What stands for a limit that is not stated where the format demands one: beyond every arm's.
_NO_LIMIT: Final = "1e+15"


def root(parts: Parts) -> Tag:
    """The element ``<robot>``."""
    pictures = cylinders(parts)
    elements = []
    if parts.base is not None:
        elements += [tag("link", name="world"), _fixed("base_joint", "world", "base", parts.base)]
    elements.append(_link("base", None, pictures[0]))
    parent = "base"
    for joint, picture in zip(parts.joints, pictures[1:], strict=True):
        body = joint.body if joint.mass_is_known or joint.body != Body() else None
        elements += [_joint(joint, parent), _link(joint.link, body, picture)]
        parent = joint.link
    if parts.tool is not None:
        elements += [_fixed("tool_joint", parent, "tool", parts.tool), tag("link", name="tool")]
    elements += [_transmission(joint.name, joint.gear.ratio) for joint in parts.joints if joint.gear]
    return tag("robot", *elements, name=parts.name)


def _link(name: str, body: Body | None, picture: tuple[Cylinder, ...]) -> Tag:
    inertial = None
    if body is not None:
        entries = {key: decimal(entry) for key, entry in zip(TENSOR, body.inertia, strict=True)}
        inertial = tag(
            "inertial",
            _origin(Frame(body.com)),
            tag("mass", value=decimal(body.mass)),
            tag("inertia", **dict(sorted(entries.items()))),
        )
    shapes = []
    for each in picture:
        shape = tag("cylinder", radius=decimal(each.radius), length=decimal(each.length))
        shapes.append(tag("visual", _origin(each.frame), tag("geometry", shape)))
    return tag("link", inertial, *shapes, name=name)


def _joint(joint: PartJoint, parent: str) -> Tag:
    limits = joint.limits
    attributes: dict[str, str] = {}
    if limits.position is not None:
        lower, upper = map(float, limits.position)
        attributes = {"lower": decimal(lower), "upper": decimal(upper)}
    elif joint.kind == "prismatic":
        attributes = {"lower": f"-{_NO_LIMIT}", "upper": _NO_LIMIT}
    stated = {"effort": limits.torque, "velocity": limits.velocity}
    if attributes or any(value is not None for value in stated.values()):
        attributes |= {key: _NO_LIMIT if x is None else decimal(float(x)) for key, x in stated.items()}
    if limits.acceleration is not None:
        attributes["acceleration"] = decimal(float(limits.acceleration))
    passive = {"damping": joint.viscous, "friction": joint.coulomb, "armature": joint.motor_inertia}
    # urdfdom refuses the element without damping and friction
    dynamics = {key: decimal(x) for key, x in passive.items() if x or key == "damping"}
    return tag(
        "joint",
        _origin(joint.frame),
        tag("parent", link=parent),
        tag("child", link=joint.link),
        tag("axis", xyz="0 0 1"),
        tag("limit", **attributes) if attributes else None,
        tag("dynamics", **dynamics) if any(passive.values()) else None,
        _mimic(joint.mimic) if joint.mimic else None,
        name=joint.name,
        type=joint.word,
    )


def _mimic(mimic: Mimic) -> Tag:
    multiplier, offset = decimal(mimic.multiplier), decimal(mimic.offset)
    return tag("mimic", joint=mimic.leader, multiplier=multiplier, offset=offset)


def _fixed(name: str, parent: str, child: str, frame: Frame) -> Tag:
    ends = tag("parent", link=parent), tag("child", link=child)
    return tag("joint", _origin(frame), *ends, name=name, type="fixed")


def _origin(frame: Frame) -> Tag | None:
    if frame == Frame():
        return None
    return tag("origin", xyz=decimals(frame.xyz), rpy=decimals(frame.rpy) if any(frame.rpy) else None)


def _transmission(joint: str, ratio: Fraction) -> Tag:
    interface = leaf("hardwareInterface", "hardware_interface/EffortJointInterface")
    reduction = leaf("mechanicalReduction", decimal(float(ratio)))
    return tag(
        "transmission",
        leaf("type", "transmission_interface/SimpleTransmission"),
        tag("joint", interface, name=joint),
        tag("actuator", reduction, name=f"{joint}_motor"),
        name=f"{joint}_transmission",
    )
