"""A file in another format to a tree: which format it is, and what is read by which reader."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import replace
from pathlib import Path
from typing import Final

from robodyn.errors import InputError
from robodyn.files import label
from robodyn.formats import elements
from robodyn.formats.elements import Document, tag_shown
from robodyn.formats.tree import Tree

_EXPECTED: Final = "URDF, MJCF, SDF or xacro"
_STATED: Final[ContextVar[Mapping[str, str]]] = ContextVar("xacro_arguments")


@contextmanager
def xacro_arguments(arguments: Mapping[str, str]) -> Iterator[None]:
    """A context in which ``arguments`` are those of every xacro file that is read, by whatever reads it."""
    token = _STATED.set(arguments)
    try:
        yield
    finally:
        _STATED.reset(token)


def read_tree(path: str | os.PathLike[str], arguments: Mapping[str, str] | None = None) -> Tree:
    """The tree in the file at ``path``; ``arguments`` are those of a xacro file, and of an MJCF file folders
    that it may read (``find NAME``).

    What is in a file is told from its root element, but for xacro, whose name ends in ``.xacro``.

    Raises
    ------
    InputError: it cannot be read, is too large, not XML, or not what its format allows; with the place.
    ToolError: the package that reads the format is not installed.
    """
    file = Path(path)
    name = label(path)
    stated = {**_STATED.get({}), **(arguments or {})}
    if name.lower().endswith(".xacro"):
        from robodyn.formats.xacro import expanded

        document = expanded(file, stated)
    else:
        document = elements.read(os.fspath(path), _EXPECTED, name)
        if arguments and (document.root.tag != "mujoco" or len(_folders(arguments)) < len(arguments)):
            raise InputError("arguments are for xacro files", found=name, remedy="leave --arg out")
    tree = _by_root(document, file, _folders(stated))
    return replace(tree, file=name, warnings=(*document.warnings, *tree.warnings))


def _folders(arguments: Mapping[str, str]) -> list[str]:
    """The folders that arguments ``find NAME`` state."""
    return [folder for name, folder in arguments.items() if name.split(None, 1)[:1] == ["find"]]


def _by_root(document: Document, path: Path, folders: Sequence[str]) -> Tree:
    tag = document.root.tag
    if tag == "robot":
        from robodyn.formats.urdf import read_tree
    elif tag == "sdf":
        from robodyn.formats.sdf import read_tree
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
