"""A proposal for ``fleet.toml``, from the names of files in a folder and the header of one log."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.sources.dates import ISO
from robodyn.formats.loading import SUFFIXES, load
from robodyn.logs.formats import is_log
from robodyn.logs.log import read_log
from robodyn.resources import bundled_robot
from robodyn.robot.names import shown

_DATE: Final = re.compile(rf"(?<!\d){ISO}(?!\d)", re.ASCII)
_DESCRIPTIONS: Final = (".yaml", ".yml", *SUFFIXES)


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
    InputError: the folder has no logs, or none whose name has a date.
    """
    logs = sorted(_logs(folder))
    if not logs:
        raise InputError(
            "the folder has no logs",
            where=Place(label(folder)),
            expected="files such as ARM_2026-05-03.csv or ARM/2026-05-03.csv",
        )
    patterns = Counter(pattern for log in logs if (pattern := _pattern(log.relative_to(folder))))
    if not patterns:
        raise InputError(
            "no log of the folder has a date in its name",
            where=Place(label(folder)),
            found=shown(str(logs[0].relative_to(folder))),
            expected="a name such as ARM_2026-05-03.csv",
            remedy='write a manifest with a column date: [[logs]], manifest = "manifest.csv"',
        )
    undated = len(logs) - sum(patterns.values())
    remarks = [f"without a date in its name, and left out: {undated} of {len(logs)} logs"] if undated else []
    top = (
        {log.relative_to(folder).parts[0] for log in logs} if any("{type}" in p for p in patterns) else set()
    )
    lines = [f'name = "{_quoted(folder.resolve().name or "fleet")}"', ""]
    for name in sorted(top) or [_only_type(folder)]:
        robot = _description(folder, name)
        if robot is None:
            robot = f"{name}.yaml"
            remarks.append(
                f"{robot} is not there: write the description of the arms, or the name of a bundled one"
            )
        else:
            remarks += _columns_remark(
                folder, robot, next(log for log in logs if not top or name in log.parts)
            )
        lines += [f'[types."{_quoted(name)}"]', f'robot = "{_quoted(robot)}"', ""]
    for pattern, count in sorted(patterns.items(), key=lambda item: (-item[1], item[0])):
        lines += ["[[logs]]", f'files = "{_quoted(pattern)}"          # {count} logs', ""]
    return Proposal("\n".join(lines), tuple(remarks))


def _quoted(text: str) -> str:
    return text.replace("\\", "\\\\").replace('"', '\\"')


def _logs(folder: Path) -> Iterator[Path]:
    for path in folder.rglob("*"):
        parts = path.relative_to(folder).parts
        if path.is_file() and is_log(path) and not any(part.startswith(".") for part in parts):
            yield path


def _pattern(path: Path) -> str | None:
    """The pattern of a log's ``path``, relative to its fleet's folder; None without a date in its name. What
    its name has beside the date is the unit, else the folder that it is in; one folder above is the type."""
    found = _DATE.search(path.stem)
    if found is None:
        return None
    folders, before, after = list(path.parts[:-1]), path.stem[: found.start()], path.stem[found.end() :]
    if before.strip("_- ."):
        mark = before[len(before.rstrip("_- .")) :]
        stem = "{unit}" + mark + "{date}" + after
    elif after.strip("_- ."):
        mark = after[: len(after) - len(after.lstrip("_- ."))]
        stem = before + "{date}" + mark + "{unit}"
    elif folders:
        stem = before + "{date}" + after
        folders[-1] = "{unit}"
    else:
        return None
    fixed = [part for part in folders if part != "{unit}"]
    above = ["{type}", *["*"] * (len(fixed) - 1)] if fixed else []
    units = ["{unit}"] if "{unit}" in folders else []
    return "/".join([*above, *units, stem + path.suffix])


def _only_type(folder: Path) -> str:
    """What the one type of a fleet is called: as its description, or the folder."""
    files = sorted(path for path in folder.iterdir() if path.name.lower().endswith(_DESCRIPTIONS))
    return files[0].name.split(".")[0] if len(files) == 1 else folder.resolve().name or "arm"


def _description(folder: Path, name: str) -> str | None:
    """The description of a type: a file of its name, or a bundled robot."""
    for place in (folder, folder / name):
        for ending in _DESCRIPTIONS:
            if (place / f"{name}{ending}").is_file():
                return str((place / f"{name}{ending}").relative_to(folder))
    return name if bundled_robot(name) is not None else None


def _columns_remark(folder: Path, robot: str, log: Path) -> Iterator[str]:
    """What there is to say of the columns of a type's ``log``."""
    own = folder / robot
    try:
        arm = load(str(own) if own.is_file() else robot, warn=lambda _: None)
        read_log(str(log), arm.n, robot=arm)
    except InputError as error:
        yield f"{log.name} is not read as it is ({error.what}): write a map of its columns, see robodyn logs"
