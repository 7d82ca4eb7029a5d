"""Names, limits and what sits in a joint, from a tree's terms to those of a description."""

from __future__ import annotations

import re
from pathlib import PurePath

from robodyn.errors import InputError, Place
from robodyn.formats.chain import ChainJoint
from robodyn.formats.limits import GREATEST
from robodyn.formats.tree import MOVING, TURNING, JointLimits, Tree, TreeJoint
from robodyn.robot.account import Origins
from robodyn.robot.names import ROBOT_NAME_LENGTH, TEXT_LENGTH, robot_name_fault, shown
from robodyn.robot.numbers import shortest
from robodyn.robot.parts import Gear, JointKind, Limits
from robodyn.robot.rotations import limits_doubt


def robot_name(tree: Tree, preferred: str = "") -> str:
    """A C identifier out of the name that the file has for the robot, else out of the file's own name.

    Raises
    ------
    InputError: it is a keyword, or the ``preferred`` name is no identifier.
    """
    name = (
        preferred or identifier(tree.name) or identifier(PurePath(tree.file).name.partition(".")[0]) or "arm"
    )
    fault = robot_name_fault(name)
    if fault:
        raise InputError(
            f"the robot's name {fault}",
            where=Place(tree.file),
            found=shown(name),
            expected="a C identifier that no language reserves",
            remedy="choose another: robodyn import FILE --name NAME -o NAME.yaml",
        )
    return name


def identifier(text: str) -> str:
    """``text`` with underscores for what cannot stand in an identifier; "" where nothing is left."""
    words = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")
    return (words if words[:1].isalpha() or not words else f"arm_{words}")[:ROBOT_NAME_LENGTH].rstrip("_")


def title_of(tree: Tree, base: str = "", tip: str = "") -> str:
    """What a description says of where it comes from: the file, or the robot with both ends of the chain."""
    text = (
        f"{tree.name or 'robot'}, {base} to {tip}" if tip else f"{PurePath(tree.file).name} ({tree.format})"
    )
    return printable(text)[:TEXT_LENGTH]


def printable(text: str) -> str:
    """``text`` with blanks for what does not print."""
    return "".join(c if c.isprintable() else " " for c in text)


def joint_of(joint: TreeJoint) -> tuple[ChainJoint, list[str]]:
    """The joint of a chain without its pose and body; and what of its limits was not taken as it stands."""
    assert joint.kind in MOVING
    kind: JointKind = "revolute" if joint.kind in TURNING else "prismatic"
    limits, remarks = limits_of(joint.limits, kind)
    gear = None
    if joint.ratio is not None:
        constant = None if joint.torque_constant is None else shortest(joint.torque_constant)
        gear = Gear(shortest(joint.ratio), constant)
    stated = {
        "friction": [value is not None for value in (joint.damping, joint.friction)],
        "motor_inertia": [joint.armature is not None],
    }
    converted = ChainJoint(
        joint.name,
        joint.child,
        kind,
        axis=joint.axis,
        limits=limits,
        viscous=joint.damping or 0.0,
        coulomb=joint.friction or 0.0,
        motor_inertia=joint.armature or 0.0,
        gear=gear,
        spring=joint.spring,
        origins=Origins().with_stated(name for name, values in stated.items() if any(values)),
    )
    return converted, remarks


def limits_of(limits: JointLimits, kind: JointKind) -> tuple[Limits, list[str]]:
    """Limits that say something, and what was left out."""
    remarks = []
    lower, upper = limits.lower, limits.upper
    position = None
    if lower is not None and upper is not None and lower < upper:
        position = (shortest(lower), shortest(upper))
        doubt = limits_doubt(Limits(position), kind)
        if doubt:
            remarks.append(f"limits of {doubt}: were degrees meant?")
    elif (lower, upper) not in ((None, None), (0.0, 0.0)):
        ends = ["none" if end is None else f"{end:g}" for end in (lower, upper)]
        remarks.append(f"no limits of position: lower {ends[0]}, upper {ends[1]}")
    speeds = {}
    for name, value in (
        ("velocity", limits.velocity),
        ("acceleration", limits.acceleration),
        ("torque", limits.effort),
    ):
        if value is not None and 0 < value < GREATEST:
            speeds[name] = shortest(value)
        elif value is not None:
            remarks.append(f"no limit of {name}: {value:g}")
    return (
        Limits(position, speeds.get("velocity"), speeds.get("acceleration"), speeds.get("torque")),
        remarks,
    )
