"""A robot as the text of a URDF, MJCF or SDF file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Final

from robodyn.errors import InputError
from robodyn.formats.writers import mjcf, sdf, urdf
from robodyn.formats.writers.markup import Tag, document
from robodyn.formats.writers.parts import Parts, parts_of
from robodyn.formats.writers.physical import physical
from robodyn.robot.model import Robot
from robodyn.robot.names import shown

_WRITERS: Final[dict[str, Callable[[Parts], tuple[Tag, list[str]]]]] = {
    "urdf": urdf.root,
    "mjcf": mjcf.root,
    "sdf": sdf.root,
}
#: Formats whose readers refuse links without mass.
_PHYSICAL: Final = frozenset({"mjcf", "sdf"})
#: Formats that are written, and the ending of their files.
TARGETS: Final = {"urdf": ".urdf", "mjcf": ".xml", "sdf": ".sdf"}


@dataclass(frozen=True, slots=True)
class Exported:
    """The text of a file in another format; ``names``: those of the joints in it, base to tip; ``remarks``:
    what it says in other numbers or words; ``missing``: what it does not say of the robot."""

    format: str
    text: str
    names: tuple[str, ...]
    remarks: tuple[str, ...]
    missing: tuple[str, ...]


def export_arm(robot: Robot, to: str) -> Exported:
    """``robot`` in the format ``to``: urdf, mjcf or sdf.

    Torques, poses and joint coordinates are those of the robot; frames of links are those of the description,
    with the z axis along the joint's. Geometry is for pictures only.

    Raises
    ------
    InputError: the format is unknown, or the robot has run-time parameters (:meth:`Robot.at` gives them
        values).
    """
    if to not in _WRITERS:
        raise InputError("the format is unknown", found=shown(to), expected=", ".join(_WRITERS))
    parts = parts_of(robot)
    renamed = tuple(
        f"{shown(link.name)} is called {shown(joint.name)}"
        for link, joint in zip(robot.links, parts.joints, strict=True)
        if link.name != joint.name
    )
    loads = [entry.effect for entry in robot.effects if entry.definition.traits.body]
    notes = [f"in the last link: {', '.join(loads)}"] if loads else []
    if to in _PHYSICAL:
        joints, changed = physical(parts.joints)
        parts = replace(parts, joints=joints)
        notes += changed
    root, missing = _WRITERS[to](parts)
    return Exported(
        to,
        document(root, parts.comments),
        tuple(joint.name for joint in parts.joints),
        (*renamed, *notes),
        (*parts.left_out, *missing),
    )
