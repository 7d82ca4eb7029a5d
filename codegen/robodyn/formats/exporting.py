"""Export of a robot to URDF, MJCF or SDF."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from robodyn.errors import InputError
from robodyn.formats.writers import Tag, decimals, document, mjcf, sdf, urdf
from robodyn.formats.writers.parts import Parts, parts_of
from robodyn.robot.model import Robot
from robodyn.robot.names import shown

#: The export formats and their file extensions.
TARGETS: Final = {"urdf": ".urdf", "mjcf": ".xml", "sdf": ".sdf"}
_WRITERS: Final[dict[str, Callable[[Parts], Tag]]] = {"urdf": urdf.root, "mjcf": mjcf.root, "sdf": sdf.root}
_RARE: Final = ", which few programs read"
#: Quantities without a standard element in a format, and the non-standard attribute that has it, if any.
_MISSING: Final = {
    "urdf": {
        "rotor inertias": f", except as the attribute 'armature' of <dynamics>{_RARE}",
        "limits of acceleration": f", except as the attribute 'acceleration' of <limit>{_RARE}",
    },
    "mjcf": {"limits of velocity": "", "limits of acceleration": ""},
    "sdf": {"rotor inertias": "", "gear ratios": "", "limits of acceleration": ""},
}


@dataclass(frozen=True, slots=True)
class Exported:
    """The ``text`` of a file in another ``format``.

    ``names``: names of the joints in the file, base to tip. ``remarks``: names and values that differ from
    those of the robot. ``missing``: properties of the robot that the file does not contain.
    """

    format: str
    text: str
    names: tuple[str, ...]
    remarks: tuple[str, ...]
    missing: tuple[str, ...]


def export_arm(robot: Robot, to: str) -> Exported:
    """``robot`` in the format ``to``: urdf, mjcf or sdf.

    The exported model has the torques, poses and joint coordinates of the robot. Link frames are those of the
    description: the z axis is the joint's axis. Geometry is for pictures only.

    Raises
    ------
    InputError: the format is unknown, or the robot has run-time parameters (set them with
        :meth:`Robot.at`).
    """
    if to not in _WRITERS:
        raise InputError("the format is unknown", found=shown(to), expected=", ".join(_WRITERS))
    parts = parts_of(robot)
    notes = [
        f"{shown(link.name)} is called {shown(joint.name)}"
        for link, joint in zip(robot.links, parts.joints, strict=True)
        if link.name != joint.name
    ]
    loads = [entry.effect for entry in robot.effects if entry.definition.traits.body]
    notes += [f"in the last link: {', '.join(loads)}"] if loads else []
    if to != "urdf":  # readers of MJCF and SDF refuse links without mass
        from robodyn.formats.writers.physical import physical

        joints, changed = physical(parts.joints)
        parts = replace(parts, joints=joints)
        notes += changed
    text = document(_WRITERS[to](parts), parts.comments)
    names = tuple(joint.name for joint in parts.joints)
    return Exported(to, text, names, tuple(notes), (*parts.left_out, *_missing(parts, to)))


def _missing(parts: Parts, to: str) -> list[str]:
    """The properties of ``parts`` that a file of the format ``to`` does not contain."""
    missing = []
    if to == "urdf":
        springs = ", ".join(joint.name for joint in parts.joints if joint.spring)
        missing += [f"springs: {springs}"] if springs else []
        if parts.gravity != (0.0, 0.0, -9.81):
            gravity = f"gravity, {decimals(parts.gravity)} m/s^2"
            missing.append(f"{gravity}: set it in the program that reads the file")
    has_value = {
        "rotor inertias": any(joint.motor_inertia for joint in parts.joints),
        "gear ratios": any(joint.gear for joint in parts.joints),
        "limits of velocity": any(joint.limits.velocity is not None for joint in parts.joints),
        "limits of acceleration": any(joint.limits.acceleration is not None for joint in parts.joints),
    }
    return missing + [what + words for what, words in _MISSING[to].items() if has_value[what]]
