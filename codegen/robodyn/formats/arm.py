"""A file in another format to a tree, by the reader of its format, and to a robot; and its description with
what was decided on the way. Which angles of it a file may have meant as right ones, for a report."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.formats import elements
from robodyn.formats.chain import Vector
from robodyn.formats.conversion import printable, robot_name
from robodyn.formats.elements import tag_shown
from robodyn.formats.frames import description_of
from robodyn.formats.limits import NAMES_SHOWN, NEAR_RIGHT_ANGLE
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.tree import PHYSICS, Tree, Unused, physics_text
from robodyn.robot.account import PARTS, Account
from robodyn.robot.masses import inertia_doubt, massless, only_about_base_axis, unknown_masses
from robodyn.robot.model import Robot
from robodyn.robot.names import TEXT_LENGTH

_EXPECTED: Final = "URDF, MJCF, SDF or xacro"


@dataclass(frozen=True, slots=True)
class _Reading:
    """What the command line says of how files are read: arguments of xacro files, a model of SDF files, what
    of their physics is left out, whether masses that nobody knows are 0."""

    arguments: Mapping[str, str] = field(default_factory=dict)
    model: str = ""
    without: frozenset[str] = frozenset()
    massless: bool = False


_READING: Final[ContextVar[_Reading]] = ContextVar("reading", default=_Reading())  # noqa: B039 (frozen)


@contextmanager
def how_files_are_read(
    arguments: Mapping[str, str], model: str = "", without: Iterable[str] = (), massless: bool = False
) -> Iterator[None]:
    """A context for what reads files: ``arguments`` are those of every xacro file, ``model`` is the one of
    every SDF file, what is named ``without`` in :data:`~robodyn.formats.tree.PHYSICS` is left out, and with
    ``massless`` masses that nobody knows are 0."""
    token = _READING.set(_Reading(arguments, model, frozenset(without), massless))
    try:
        yield
    finally:
        _READING.reset(token)


def taken_as_massless(robot: Robot, on_purpose: bool) -> Robot:
    """``robot`` with masses of 0 where nobody knows them, if that is ``on_purpose`` here or by the command
    line, which its account says; else as it is."""
    joints = unknown_masses(robot)
    if not joints or not (on_purpose or _READING.get().massless):
        return robot
    account = robot.account
    if account is not None:
        words = "unknown masses and inertias are taken as 0 on purpose: joint "
        account = replace(account, decided=(*account.decided, words + ", ".join(map(str, joints))))
    return replace(massless(robot), account=account)


def is_sdf(path: str) -> bool:
    """Whether the file at ``path``, if it is one, is SDF; one that cannot be read is, so that its reader says
    what is wrong with it."""
    ending = Path(path).suffix.lower()
    if ending != ".xml" or not Path(path).exists():
        return ending == ".sdf"
    try:
        return elements.read(path, _EXPECTED, label(path)).root.tag == "sdf"
    except InputError:
        return True


def read_tree(
    path: str | os.PathLike[str],
    arguments: Mapping[str, str] | None = None,
    model: str = "",
    without: Iterable[str] = (),
) -> Tree:
    """The tree in the file at ``path``; ``arguments`` are those of a xacro file, and of an MJCF file folders
    that it may read (``find NAME``); ``model`` is the one of an SDF file that has several. What is named
    ``without`` in :data:`~robodyn.formats.tree.PHYSICS` is left out, which the tree says.

    What is in a file is told from its root element, but for xacro, whose name ends in ``.xacro``.

    Raises
    ------
    InputError: it cannot be read, is too large, not XML, or not what its format allows, or it states what
        changes torques and is not modelled; with the place.
    ToolError: the package that reads the format is not installed.
    """
    file = Path(path)
    name = label(path)
    context = _READING.get()
    stated = {**context.arguments, **(arguments or {})}
    if name.lower().endswith(".xacro"):
        from robodyn.formats.xacro import expanded

        document = expanded(file, stated)
    else:
        document = elements.read(os.fspath(path), _EXPECTED, name)
        if arguments and (document.root.tag != "mujoco" or len(_folders(arguments)) < len(arguments)):
            raise InputError("arguments are for xacro files", found=name, remedy="leave --arg out")
    tag = document.root.tag
    if model and tag != "sdf":
        raise no_model_to_choose(name)
    match tag:
        case "robot":
            from robodyn.formats import urdf

            tree = urdf.read_tree(document)
        case "sdf":
            from robodyn.formats import sdf

            tree = sdf.read_tree(document, model or context.model)
        case "mujoco":
            from robodyn.formats import mjcf

            tree = mjcf.read_tree(document, file, _folders(stated))
        case _:
            where, found = document.place(document.root), tag_shown(document.root)
            expected = "<robot> (URDF), <mujoco> (MJCF) or <sdf>"
            raise InputError("the format is unknown", where=where, found=found, expected=expected)
    tree = _without(tree, context.without.union(without))
    return replace(tree, file=name, warnings=(*document.warnings, *tree.warnings))


def _without(tree: Tree, names: frozenset[str]) -> Tree:
    """``tree`` without the physics of those ``names``, which it says."""
    unknown = sorted(names - PHYSICS.keys())
    if unknown:
        raise InputError("nothing of this name is left out", found=unknown[0], expected=", ".join(PHYSICS))
    left_out: dict[str, list[str]] = {}
    for physics in tree.physics:
        if physics.name not in names:
            raise InputError(
                f"this changes torques, and is not modelled: {physics_text(physics.name, [physics.of])}",
                where=physics.where,
                remedy=f"leave it out: --without {physics.name}",
            )
        left_out.setdefault(physics.name, []).append(physics.of)
    return replace(tree, left_out=tuple(physics_text(name, of) for name, of in left_out.items()))


def _folders(arguments: Mapping[str, str]) -> list[str]:
    """The folders that arguments ``find NAME`` state."""
    return [folder for name, folder in arguments.items() if name.split(None, 1)[:1] == ["find"]]


def stated_arguments() -> Mapping[str, str]:
    """The arguments of xacro files in this context."""
    return _READING.get().arguments


def no_model_to_choose(name: str) -> InputError:
    """The error that a model is chosen in the file or robot of that ``name``, which is no SDF."""
    return InputError("a model is chosen in SDF files", found=name, remedy="leave --model out")


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
    for index, link in enumerate(robot.links):
        reason, where = inertia_doubt(link.inertia), link.origins.where or Place(tree.file)
        if reason and not (index == 0 and only_about_base_axis(link.joint, link.inertia)):
            implausible.append((where, f"joint {link.name}: the inertia behind it is not physical: {reason}"))
    if strict and implausible:
        where, words = implausible[0]
        raise InputError(words, where=where, remedy="check the numbers of the links that it carries")
    near = () if snap else near_right_angles(robot)
    of_tree = (tree.file, tree.format, serial.remarks, tree.unused)
    return Imported(robot, *of_tree, tuple(implausible), near, tree.warnings)


def _account(tree: Tree, serial: Serial, assumed: bool) -> Account:
    """What is to be known of the arm beyond its numbers, whose gravity may be ``assumed``; files by their
    names alone, wherever they lie."""
    x, y, z = tree.gravity
    where = f"{x:g}, {y:g}, {z:g} m/s^2 in the root's frame"
    gravity = f"gravity is assumed to be {where}: {tree.format} has none"
    file = Path(tree.file).name
    unused = [replace(part, file=Path(part.file).name).text(file) for part in tree.unused]
    more = len(unused) - NAMES_SHOWN
    warnings = []
    for at, words in tree.warnings:
        other = "" if at.file == tree.file else f"{Path(at.file).name}, "
        warnings.append(f"{other}line {at.line}, column {at.column}: {words}")
    parts = {
        "warnings": warnings,
        "left_out": tree.left_out,
        "decided": [*serial.remarks, *[gravity] * assumed],
        "not_used": unused[:NAMES_SHOWN] + ([f"and {more} more"] if more > 0 else []),
    }
    lines = {part: tuple(map(printable, parts[part])) for part in PARTS}
    return Account(printable(file)[:TEXT_LENGTH], tree.format, **lines)


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
    angles = [
        (f"{link.name}: {word}", getattr(link.joint, word))
        for link in robot.links
        for word in ("alpha", "theta")
    ]
    base, tool = (
        [(f"{name}: {word}", turn) for word, turn in zip(("roll", "pitch", "yaw"), frame.rpy, strict=True)]
        if frame
        else []
        for name, frame in (("base", robot.base), ("tool", robot.tool))
    )
    near = []
    for where, turn in (*base, *angles, *tool):
        quarter = round(turn.radians / (math.pi / 2))
        if turn.quarter is None and abs(turn.radians - quarter * (math.pi / 2)) <= within:
            near.append(NearRightAngle(where, turn.radians, quarter))
    return tuple(near)
