"""A file in another format to a robot, and its description as text with what was decided on the way."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Vector
from robodyn.formats.conversion import robot_name
from robodyn.formats.frames import description_of
from robodyn.formats.reading import read_tree
from robodyn.formats.serial import serial_chain
from robodyn.formats.snapping import NearRightAngle, near_right_angles
from robodyn.formats.tree import Unused
from robodyn.robot.model import Robot
from robodyn.robot.plausibility import inertia_doubt, only_about_base_axis


@dataclass(frozen=True, slots=True)
class Imported:
    """A robot and what is to be known of where it comes from.

    ``remarks``: what was decided (joints that are locked, limits left out); ``unused``: what the file says
    beyond; ``implausible``: numbers, with the places of their links; ``near``: angles that are nearly
    multiples of pi/2 and cost operations; ``warnings``: what the format does not allow, with the places.
    """

    robot: Robot
    file: str
    format: str
    remarks: tuple[str, ...]
    unused: tuple[Unused, ...]
    implausible: tuple[tuple[Place, str], ...]
    near: tuple[NearRightAngle, ...]
    warnings: tuple[tuple[Place, str], ...] = ()


def import_arm(
    path: str | os.PathLike[str],
    *,
    base: str = "",
    tip: str = "",
    locks: Mapping[str, float] | None = None,
    snap: float = 0.0,
    name: str = "",
    arguments: Mapping[str, str] | None = None,
    model: str = "",
    without: Iterable[str] = (),
    gravity: Vector | None = None,
    strict: bool = False,
) -> Imported:
    """The serial arm from the link ``base`` to the link ``tip`` of a URDF, MJCF, SDF or xacro file.

    ``locks``: positions [rad or m] of joints that do not move; ``snap``: angles of axes within it [rad] of a
    multiple of pi/2 become it; ``name``: of the robot, by default the file's; ``arguments``: those of a xacro
    file; ``model``: the one that is read of an SDF file; ``gravity`` [m/s^2], in the root's frame, takes the
    place of the file's, which a URDF does not have. What is named ``without`` in
    :data:`~robodyn.formats.tree.PHYSICS` is left out, although it changes torques. ``strict`` refuses
    inertias that no body has.

    Raises
    ------
    InputError: the file cannot be read, or no serial chain can be taken out of it; with the place.
    ToolError: the package that reads the format is not installed.
    """
    tree = read_tree(path, arguments, model, without)
    if gravity is not None:
        tree = replace(tree, gravity=gravity)
    serial = serial_chain(tree, robot_name(tree, name), base, tip, locks)
    robot = replace(description_of(serial.chain, snap), file=Path(path).absolute())
    implausible = []
    for index, (link, where) in enumerate(zip(robot.links, serial.places, strict=True)):
        reason = inertia_doubt(link.inertia)
        if reason and not (index == 0 and only_about_base_axis(link.joint, link.inertia)):
            implausible.append((where, f"joint {link.name}: the inertia behind it is not physical: {reason}"))
    if strict and implausible:
        where, words = implausible[0]
        raise InputError(words, where=where, remedy="check the numbers of the links that it carries")
    near = near_right_angles(robot) if not snap else ()
    return Imported(
        robot,
        tree.file,
        tree.format,
        serial.remarks,
        tree.unused,
        tuple(implausible),
        near,
        tree.warnings,
    )


def description_text(imported: Imported) -> str:
    """The YAML of an imported robot: remarks, and what is not used, as comments at its head."""
    from robodyn.robot.writer import to_yaml

    notes = [f"from {Path(imported.file).name} ({imported.format})", *imported.remarks]
    notes += [f"not used: {part.text(imported.file)}" for part in imported.unused]
    return "".join(f"# {_printable(note)}\n" for note in notes) + to_yaml(imported.robot)


def _printable(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)
