"""A file in another format to a tree: which format it is, and what is read by which reader."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final

from robodyn.errors import InputError
from robodyn.files import label
from robodyn.formats import elements
from robodyn.formats.elements import Document, tag_shown
from robodyn.formats.tree import PHYSICS, Tree, physics_text
from robodyn.robot.masses import massless, unknown_masses
from robodyn.robot.model import Robot

_EXPECTED: Final = "URDF, MJCF, SDF or xacro"


@dataclass(frozen=True, slots=True)
class _Reading:
    """What the command line says of how files are read: arguments of xacro files, a model of SDF files, what
    of their physics is left out, whether masses that nobody knows are 0."""

    arguments: Mapping[str, str] = field(default_factory=dict)
    model: str = ""
    without: frozenset[str] = frozenset()
    massless: bool = False


_READING: Final[ContextVar[_Reading]] = ContextVar("reading")


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
    if not joints or not (on_purpose or _READING.get(_Reading()).massless):
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
    context = _READING.get(_Reading())
    stated = {**context.arguments, **(arguments or {})}
    if name.lower().endswith(".xacro"):
        from robodyn.formats.xacro import expanded

        document = expanded(file, stated)
    else:
        document = elements.read(os.fspath(path), _EXPECTED, name)
        if arguments and (document.root.tag != "mujoco" or len(_folders(arguments)) < len(arguments)):
            raise InputError("arguments are for xacro files", found=name, remedy="leave --arg out")
    if model and document.root.tag != "sdf":
        raise no_model_to_choose(name)
    tree = _by_root(document, file, _folders(stated), model or context.model)
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
    return _READING.get(_Reading()).arguments


def no_model_to_choose(name: str) -> InputError:
    """The error that a model is chosen in the file or robot of that ``name``, which is no SDF."""
    return InputError("a model is chosen in SDF files", found=name, remedy="leave --model out")


def _by_root(document: Document, path: Path, folders: Sequence[str], model: str) -> Tree:
    tag = document.root.tag
    if tag == "robot":
        from robodyn.formats.urdf import read_tree
    elif tag == "sdf":
        from robodyn.formats import sdf

        return sdf.read_tree(document, model)
    elif tag == "mujoco":
        from robodyn.formats import mjcf

        return mjcf.read_tree(document, path, folders)
    else:
        raise InputError(
            "the format is unknown",
            where=document.place(document.root),
            found=tag_shown(document.root),
            expected="<robot> (URDF), <mujoco> (MJCF) or <sdf>",
        )
    return read_tree(document)
