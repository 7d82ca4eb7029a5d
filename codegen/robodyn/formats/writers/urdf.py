"""URDF out of a robot, as http://wiki.ros.org/urdf/XML has it."""

from __future__ import annotations

from typing import Final

from robodyn.formats.chain import Body
from robodyn.formats.writers.markup import Tag, decimal, decimals, leaf, tag
from robodyn.formats.writers.parts import Cylinder, Frame, PartJoint, Parts, cylinders

#: What stands for a limit that is not stated where the format demands one: beyond every arm's.
_NO_LIMIT: Final = "1e+15"
_USUAL: Final = (0.0, 0.0, -9.81)


def root(parts: Parts) -> tuple[Tag, list[str]]:
    """The element ``<robot>``, and what it does not say of ``parts``."""
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
    elements += [_transmission(joint) for joint in parts.joints if joint.gear]
    return tag("robot", *elements, name=parts.name), _missing(parts)


def _missing(parts: Parts) -> list[str]:
    missing = []
    if springs := [joint.name for joint in parts.joints if joint.spring]:
        missing.append(f"springs: {', '.join(springs)}")
    if parts.gravity != _USUAL:
        missing.append(f"gravity, {decimals(parts.gravity)} m/s^2: set it in the program that reads the file")
    if any(joint.motor_inertia for joint in parts.joints):
        missing.append(
            "rotor inertias, but for the attribute 'armature' of <dynamics>, which few readers know"
        )
    if any(joint.limits.acceleration is not None for joint in parts.joints):
        missing.append(
            "limits of acceleration, but for an attribute 'acceleration' of <limit>, which few readers know"
        )
    return missing


def _link(name: str, body: Body | None, picture: tuple[Cylinder, ...]) -> Tag:
    inertial = None
    if body is not None:
        keys = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
        entries = {key: decimal(entry) for key, entry in zip(keys, body.inertia, strict=True)}
        inertial = tag(
            "inertial",
            _origin(Frame(body.com)),
            tag("mass", value=decimal(body.mass)),
            tag("inertia", **{key: entries[key] for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")}),
        )
    shapes = [tag("visual", _origin(each.frame), tag("geometry", _shape(each))) for each in picture]
    return tag("link", inertial, *shapes, name=name)


def _shape(cylinder: Cylinder) -> Tag:
    return tag("cylinder", radius=decimal(cylinder.radius), length=decimal(cylinder.length))


def _joint(joint: PartJoint, parent: str) -> Tag:
    limits = joint.limits
    free = limits.position is None
    kind = "continuous" if free and joint.kind == "revolute" else joint.kind
    attributes: dict[str, str] = {}
    if limits.position is not None:
        attributes |= {
            "lower": decimal(float(limits.position[0])),
            "upper": decimal(float(limits.position[1])),
        }
    elif kind == "prismatic":
        attributes |= {"lower": f"-{_NO_LIMIT}", "upper": _NO_LIMIT}
    stated = {"effort": limits.torque, "velocity": limits.velocity}
    if attributes or any(value is not None for value in stated.values()):
        attributes |= {key: _NO_LIMIT if x is None else decimal(float(x)) for key, x in stated.items()}
    if limits.acceleration is not None:
        attributes["acceleration"] = decimal(float(limits.acceleration))
    sits = {"damping": joint.viscous, "friction": joint.coulomb, "armature": joint.motor_inertia}
    # urdfdom refuses the element without damping and friction
    dynamics = {key: decimal(x) for key, x in sits.items() if x or key == "damping"}
    return tag(
        "joint",
        _origin(joint.frame),
        tag("parent", link=parent),
        tag("child", link=joint.link),
        tag("axis", xyz="0 0 1"),
        tag("limit", **attributes) if attributes else None,
        tag("dynamics", **dynamics) if any(sits.values()) else None,
        name=joint.name,
        type=kind,
    )


def _fixed(name: str, parent: str, child: str, frame: Frame) -> Tag:
    ends = tag("parent", link=parent), tag("child", link=child)
    return tag("joint", _origin(frame), *ends, name=name, type="fixed")


def _origin(frame: Frame) -> Tag | None:
    if frame == Frame():
        return None
    return tag("origin", xyz=decimals(frame.xyz), rpy=decimals(frame.rpy) if any(frame.rpy) else None)


def _transmission(joint: PartJoint) -> Tag:
    assert joint.gear is not None
    interface = leaf("hardwareInterface", "hardware_interface/EffortJointInterface")
    return tag(
        "transmission",
        leaf("type", "transmission_interface/SimpleTransmission"),
        tag("joint", interface, name=joint.name),
        tag(
            "actuator",
            leaf("mechanicalReduction", decimal(float(joint.gear.ratio))),
            name=f"{joint.name}_motor",
        ),
        name=f"{joint.name}_transmission",
    )
