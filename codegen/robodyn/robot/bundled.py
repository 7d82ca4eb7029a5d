"""The robots that come with robodyn, and loading by path or by name."""

from __future__ import annotations

import difflib
import os
from dataclasses import replace
from pathlib import Path

from robodyn.errors import InputError, Place
from robodyn.files import label as label_of
from robodyn.files import read_start
from robodyn.resources import bundled_robot, data_dir
from robodyn.robot.document import FILE_SIZE
from robodyn.robot.model import Robot
from robodyn.robot.reader import Warn, read_bytes

_SUFFIX = ".yaml"


def bundled_names() -> tuple[str, ...]:
    """Names of the bundled robots, sorted.

    Raises
    ------
    ToolError: the folder of the robots is missing from the installation.
    """
    return tuple(sorted(path.stem for path in data_dir("robots").glob("*" + _SUFFIX)))


def bundled_text(name: str) -> str:
    """The YAML of the bundled robot ``name`` (``puma560`` or ``puma560.yaml``).

    Raises
    ------
    InputError: there is no such robot.
    """
    path = bundled_robot(name)
    if path is None:
        raise _not_there(name, name)
    return path.read_text(encoding="utf-8")


def load(spec: str | os.PathLike[str], *, strict: bool = False, warn: Warn | None = None) -> Robot:
    """The robot in the file ``spec``, or the bundled robot of that name.

    An existing file wins over a bundled name. Physically doubtful numbers are told to ``warn``, one line
    of text each (by default they become a warning); ``strict`` refuses them.

    Raises
    ------
    InputError: no such file or name, an unreadable file, or one that is not a robot description.
    """
    name = os.fspath(spec)
    path, label = Path(name), label_of(name)
    try:
        data = _start_of(path, label)
    except (FileNotFoundError, NotADirectoryError, IsADirectoryError, ValueError):
        bundled = bundled_robot(name)  # a folder of that name does not hide the robot
        if bundled is None:
            raise _not_there(name, label) from None
        path, label = bundled, bundled.name
        data = _start_of(path, label)
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise InputError("the file cannot be read", where=Place(label), found=reason) from None
    return replace(read_bytes(data, label, strict=strict, warn=warn), file=path.absolute())


def text_of(spec: str | os.PathLike[str]) -> str:
    """The text of the description that :func:`load` reads for ``spec``.

    Raises
    ------
    InputError: there is no such file or robot.
    """
    path = Path(spec)
    return path.read_bytes().decode("utf-8-sig") if path.is_file() else bundled_text(os.fspath(spec))


def _start_of(path: Path, label: str) -> bytes:
    """The file's bytes, one more than are allowed at most. Nothing is waited for."""
    if path.is_dir():
        raise IsADirectoryError
    return read_start(path, FILE_SIZE + 1, "a robot description, such as arm.yaml", label)


def _not_there(name: str, label: str) -> InputError:
    where = Place(label) if name else None
    if name and Path(name.replace("\0", "")).is_dir():
        return InputError("this is a folder", where=where, expected="a robot description, such as arm.yaml")
    names = bundled_names()
    stem = Path(name).name.lower().removesuffix(_SUFFIX).removesuffix(".yml")
    near = [stem] if stem in names else difflib.get_close_matches(stem, names, 3, 0.5)
    return InputError(
        "there is neither a file nor a bundled robot of this name",
        where=where,
        expected=f"a path, or one of {', '.join(names)}",
        remedy=f"did you mean {' or '.join(near)}?" if near else None,
    )
