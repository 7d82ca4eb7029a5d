"""A file in another format to a robot, and its description as text with what was decided on the way; which
angles of it a file may have meant as right ones, for a report before they are snapped."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.formats.chain import Vector
from robodyn.formats.conversion import printable, robot_name
from robodyn.formats.frames import description_of
from robodyn.formats.limits import NAMES_SHOWN, NEAR_RIGHT_ANGLE
from robodyn.formats.reading import read_tree, taken_as_massless
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.tree import Tree, Unused
from robodyn.robot.account import PARTS, Account
from robodyn.robot.masses import inertia_doubt, only_about_base_axis
from robodyn.robot.model import Robot
from robodyn.robot.names import TEXT_LENGTH
from robodyn.robot.values import Angle


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
    massless: bool = False,
    gravity: Vector | None = None,
    strict: bool = False,
) -> Imported:
    """The serial arm from the link ``base`` to the link ``tip`` of a URDF, MJCF, SDF or xacro file.

    ``locks``: positions [rad or m] of joints that do not move; ``snap``: angles of axes within it [rad] of a
    multiple of pi/2 become it; ``name``: of the robot, by default the file's; ``arguments``: those of a xacro
    file; ``model``: the one that is read of an SDF file; ``gravity`` [m/s^2], in the root's frame, takes the
    place of the file's, which a URDF does not have. What is named ``without`` in
    :data:`~robodyn.formats.tree.PHYSICS` is left out, although it changes torques. With ``massless`` masses
    and inertias that nobody knows are 0 (:mod:`robodyn.robot.masses`). ``strict`` refuses inertias that no
    body has.

    Raises
    ------
    InputError: the file cannot be read, or no serial chain can be taken out of it; with the place.
    ToolError: the package that reads the format is not installed.
    """
    tree = read_tree(path, arguments, model, without)
    assumed = tree.format == "URDF" and gravity is None
    if gravity is not None:
        tree = replace(tree, gravity=gravity)
    serial = serial_chain(tree, robot_name(tree, name), base, tip, locks)
    described = replace(description_of(serial.chain, snap), account=_account(tree, serial, assumed))
    robot = replace(taken_as_massless(described, massless), file=Path(path).absolute())
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


def _account(tree: Tree, serial: Serial, assumed: bool) -> Account:
    """What is to be known of the arm beyond its numbers, whose gravity may be ``assumed``; files by their
    names alone, wherever they lie."""
    x, y, z = tree.gravity
    gravity = (
        f"gravity is assumed to be {x:g}, {y:g}, {z:g} m/s^2 in the root's frame: {tree.format} has none"
    )
    file = Path(tree.file).name
    unused = [replace(part, file=Path(part.file).name).text(file) for part in tree.unused]
    more = len(unused) - NAMES_SHOWN
    parts = {
        "warnings": [f"{_place(at, tree)}: {words}" for at, words in tree.warnings],
        "left_out": tree.left_out,
        "decided": [*serial.remarks, *[gravity] * assumed],
        "not_used": unused[:NAMES_SHOWN] + ([f"and {more} more"] if more > 0 else []),
    }
    lines = {part: tuple(map(printable, parts[part])) for part in PARTS}
    return Account(printable(file)[:TEXT_LENGTH], tree.format, **lines)


def _place(at: Place, tree: Tree) -> str:
    """Where that is in the file of ``tree``, or in one that it takes in."""
    line = f"line {at.line}, column {at.column}"
    return line if at.file == tree.file else f"{Path(at.file).name}, {line}"


def description_text(imported: Imported) -> str:
    """The YAML of an imported robot; what of the file is not in it stands under ``imported``."""
    from robodyn.robot.writer import to_yaml

    return to_yaml(imported.robot)


@dataclass(frozen=True, slots=True)
class NearRightAngle:
    """An angle of a description that is nearly a multiple of pi/2: whose it is, what it is [rad], and the
    multiple."""

    where: str
    radians: float
    quarter: int

    @property
    def error(self) -> float:
        """By how much the multiple is missed [rad]."""
        return self.radians - self.quarter * math.pi / 2


def near_right_angles(robot: Robot, within: float = NEAR_RIGHT_ANGLE) -> tuple[NearRightAngle, ...]:
    """The angles of ``robot``, base to tip, that are ``within`` [rad] of a multiple of pi/2 and not it."""
    angles: list[tuple[str, Angle]] = []
    if robot.base is not None:
        angles += [(f"base: {word}", turn) for word, turn in _named(robot.base.rpy)]
    for link in robot.links:
        angles += [(f"{link.name}: alpha", link.joint.alpha), (f"{link.name}: theta", link.joint.theta)]
    if robot.tool is not None:
        angles += [(f"tool: {word}", turn) for word, turn in _named(robot.tool.rpy)]
    near = []
    for where, turn in angles:
        quarter = round(turn.radians / (math.pi / 2))
        if turn.quarter is None and abs(turn.radians - quarter * (math.pi / 2)) <= within:
            near.append(NearRightAngle(where, turn.radians, quarter))
    return tuple(near)


def _named(rpy: tuple[Angle, Angle, Angle]) -> list[tuple[str, Angle]]:
    return list(zip(("roll", "pitch", "yaw"), rpy, strict=True))
