"""A proposal for ``fleet.toml``, from the names of files in a folder and the header of one log."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.sources.dates import date_in
from robodyn.fleet.sources.folder import DESCRIPTIONS, description_of
from robodyn.formats.loading import load
from robodyn.logs.formats import is_log
from robodyn.logs.log import read_log
from robodyn.robot.names import shown

#: The field of a pattern that is a type.
_TYPE: Final = "{type}"
#: Marks of a pattern; what of a name is one of them may be any character.
_MARKS: Final = re.compile(r"[{}*?\\]")


@dataclass(frozen=True, slots=True)
class Proposal:
    """The ``text`` of a ``fleet.toml``, and ``remarks`` on what is to be seen to in it."""

    text: str
    remarks: tuple[str, ...]


def propose_fleet(folder: Path) -> Proposal:
    """What a ``fleet.toml`` in ``folder`` could say: which part of the names of its logs is the unit, the
    date and the type, and which description its arms have.

    Raises
    ------
    InputError: the folder has no log whose name has a date.
    """
    logs = sorted(_logs(folder))
    plain = _only_type(folder)
    fitting = [(log, pattern) for log in logs if (pattern := _pattern(log.relative_to(folder)))]
    if not fitting:
        raise InputError(
            "no log of the folder has a date in its name",
            where=Place(label(folder)),
            found=shown(str(logs[0].relative_to(folder))) if logs else "no logs",
            expected="a name such as ARM_2026-05-03.csv or ARM/2026-05-03.csv",
            remedy='write a manifest with a column date: [[logs]], manifest = "manifest.csv"',
        )
    undated = len(logs) - len(fitting)
    remarks = [f"without a date in its name, and left out: {undated} of {len(logs)} logs"] if undated else []
    types: dict[str, Path] = {}  # and a log of each
    for log, pattern in fitting:
        types.setdefault(log.relative_to(folder).parts[0] if _TYPE in pattern else plain, log)
    lines = [f"name = {_quoted(folder.resolve().name or 'fleet')}", ""]
    for name, log in sorted(types.items()):
        path = description_of(folder, name)
        robot = name if path is None or folder not in path.parents else str(path.relative_to(folder))
        if path is None:
            robot = f"{name}.yaml"
            remarks.append(
                f"{robot} is not there: write the description of the arms, or the name of a bundled one"
            )
        else:
            remarks += _columns_remark(path, log)
        lines += [f"[types.{_quoted(name)}]", f"robot = {_quoted(robot)}", ""]
    patterns = Counter(pattern for _, pattern in fitting)
    for pattern, count in sorted(patterns.items(), key=lambda item: (-item[1], item[0])):
        several = "log" if count == 1 else "logs"
        lines += ["[[logs]]", f"files = {_quoted(pattern)}          # {count} {several}"]
        lines += [*([f"type = {_quoted(plain)}"] if len(types) > 1 and _TYPE not in pattern else []), ""]
    return Proposal("\n".join(lines), tuple(remarks))


def _quoted(text: str) -> str:
    """The text as a string of TOML, what cannot be seen of it by its number."""
    marks = {"\\": r"\\", '"': r"\""}
    return '"' + "".join(marks.get(c, c if c.isprintable() else rf"\U{ord(c):08x}") for c in text) + '"'


def _logs(folder: Path) -> Iterator[Path]:
    for path in folder.rglob("*"):
        parts = path.relative_to(folder).parts
        if is_log(path) and path.is_file() and not any(part.startswith(".") for part in parts):
            try:
                os.fspath(path).encode()
            except UnicodeEncodeError:
                raise InputError(
                    "the name of a log is no text", where=Place(label(path)), remedy="rename it"
                ) from None
            yield path


def _pattern(path: Path) -> str | None:
    """The pattern of a log's ``path``, relative to its fleet's folder; None without a date in its name. What
    its name has beside the date is the unit, else the folder that it is in; one folder above is the type."""
    date = date_in(path.stem)
    if date is None:
        return None
    folders, units = list(path.parts[:-1]), list[str]()
    before, after = (_MARKS.sub("?", part) for part in (path.stem[: date.start()], path.stem[date.end() :]))
    if before.strip("_- ."):
        mark = before[len(before.rstrip("_- .")) :]
        stem = "{unit}" + mark + "{date}" + after
    elif after.strip("_- ."):
        mark = after[: len(after) - len(after.lstrip("_- ."))]
        stem = before + "{date}" + mark + "{unit}"
    elif folders:
        stem = before + "{date}" + after
        folders, units = folders[:-1], ["{unit}"]
    else:
        return None
    above = [_TYPE, *["*"] * (len(folders) - 1)] if folders else []
    return "/".join([*above, *units, stem + path.suffix])


def _only_type(folder: Path) -> str:
    """What the one type of a fleet is called: as its description, or the folder."""
    files = sorted(path for path in folder.iterdir() if path.name.lower().endswith(DESCRIPTIONS))
    return files[0].name.split(".")[0] if len(files) == 1 else folder.resolve().name or "arm"


def _columns_remark(robot: Path, log: Path) -> Iterator[str]:
    """What there is to say of the columns of a type's ``log``."""
    try:
        arm = load(str(robot), warn=lambda _: None)
        read_log(str(log), arm.n, robot=arm)
    except InputError as error:
        yield f"{log.name} is not read as it is ({error.what}): write a map of its columns, see robodyn logs"
