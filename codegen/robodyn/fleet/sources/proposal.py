"""A proposal for ``fleet.toml``, from the names of files in a folder."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.sources.dates import date_in
from robodyn.fleet.sources.pattern import matches, pattern_of
from robodyn.formats.loading import SUFFIXES
from robodyn.logs.formats import is_log
from robodyn.resources import bundled_robot
from robodyn.robot.names import shown

#: The map of a type's logs, in its folder; ends of the names of descriptions.
_MAP: Final = "map.yaml"
_DESCRIPTIONS: Final = (".yaml", ".yml", *SUFFIXES)
#: The field of a pattern that is a type.
_TYPE: Final = "{type}"
#: Marks of a pattern; what of a name is one of them may be any character.
_MARKS: Final = re.compile(r"[{}*?\\]")


@dataclass(frozen=True, slots=True)
class Proposal:
    """The ``text`` of a ``fleet.toml``, and ``remarks`` on what is to be seen to in it."""

    text: str
    remarks: tuple[str, ...]


def propose_fleet(folder: Path, *, bare: bool = False) -> Proposal:
    """What a ``fleet.toml`` in ``folder`` could say: which part of the names of its logs is the unit, the
    date and the type, and which description its arms have. Of a ``bare`` folder only logs as TYPE/UNIT/LOG
    are looked at, and none may lack a date.

    Raises
    ------
    InputError: the folder has no log whose name has a date, or a name is no text.
    """
    logs = list(_logs(folder, "*/*/*" if bare else "**/*"))
    plain = _only_type(folder)
    fitting = [(log, pattern) for log in logs if (pattern := _pattern(log))]
    undated = [log for log in logs if _pattern(log) is None]
    if not fitting or (bare and undated):
        raise InputError(
            f"{'a' if fitting else 'no'} log of the folder has {'no' if fitting else 'a'} date in its name",
            where=Place(label(folder)),
            found=shown(str(undated[0])) if undated else "no logs",
            expected="TYPE/UNIT/2026-05-03.csv"
            if bare
            else "a name such as ARM_2026-05-03.csv or ARM/2026-05-03.csv",
            remedy="write a fleet.toml and a manifest with dates: [[logs]], manifest = 'manifest.csv'",
        )
    remarks = (
        [f"without a date in its name, and left out: {len(undated)} of {len(logs)} logs"] if undated else []
    )
    types = sorted({log.parts[0] if _TYPE in pattern else plain for log, pattern in fitting})
    lines = [f"name = {_quoted(folder.resolve().name or 'fleet')}", ""]
    for name in types:
        places = [place / f"{name}{ending}" for place in (folder / name, folder) for ending in _DESCRIPTIONS]
        path = next((path for path in places if path.is_file()), None)
        robot = str(path.relative_to(folder)) if path else name if bundled_robot(name) else f"{name}.yaml"
        if path is None and robot != name:
            remarks.append(
                f"{robot} is not there: write the description of the arms, or the name of a bundled one"
            )
        lines += [f"[types.{_quoted(name)}]", f"robot = {_quoted(robot)}"]
        lines += [f"map = {_quoted(f'{name}/{_MAP}')}"] if (folder / name / _MAP).is_file() else []
        lines.append("")
    for pattern in sorted({pattern for _, pattern in fitting}):
        lines += ["[[logs]]", f"files = {_quoted(pattern)}"]
        suffix = Path(pattern).suffix
        if suffix in ("", ".json"):  # no file is a recording, and LOG.csv.json is no log
            lines.append(f"exclude = {_quoted('*/' * pattern.count('/') + '*.*' + suffix)}")
        lines += [*([f"type = {_quoted(plain)}"] if len(types) > 1 and _TYPE not in pattern else []), ""]
    return Proposal("\n".join(lines), tuple(remarks))


def _quoted(text: str) -> str:
    """The text as a string of TOML, what cannot be seen of it by its number."""
    marks = {"\\": r"\\", '"': r"\""}
    return '"' + "".join(marks.get(c, c if c.isprintable() else rf"\U{ord(c):08x}") for c in text) + '"'


def _logs(folder: Path, pattern: str) -> Iterator[Path]:
    """The logs in ``folder`` of a pattern, relative to it, but for those in recordings' folders."""
    recordings: set[Path] = set()
    for path in (Path(path) for path, _ in matches(pattern_of(pattern), folder)):
        if path.parent in recordings or not is_log(folder / path):
            continue
        if (folder / path).is_dir():
            recordings.add(path)
        if re.search("[\ud800-\udfff]", str(path)):
            raise InputError("the name of a log is no text", where=Place(label(path)), remedy="rename it")
        yield path


def _pattern(path: Path) -> str | None:
    """The pattern of a log's ``path``, relative to its fleet's folder; None without a date in its name. The
    unit is the folder of a log that lies in two or more, the first of which is the type; else it is what its
    name has beside the date, or the folder."""
    date = date_in(path.stem)
    if date is None:
        return None
    above, units = list(path.parts[:-1]), list[str]()
    before, after = (_MARKS.sub("?", part) for part in (path.stem[: date.start()], path.stem[date.end() :]))
    own = "{date}"
    if len(above) < 2 and before.strip("_- ."):
        own = "{unit}" + before[len(before.rstrip("_- .")) :] + own + after
    elif len(above) < 2 and after.strip("_- ."):
        own = before + own + after[: len(after) - len(after.lstrip("_- ."))] + "{unit}"
    elif above:
        own, above, units = before + own + after, above[:-1], ["{unit}"]
    else:
        return None
    return "/".join([*([_TYPE, *["*"] * (len(above) - 1)] if above else []), *units, own + path.suffix])


def _only_type(folder: Path) -> str:
    """What the one type of a fleet is called: as its description, or the folder."""
    files = sorted(path for path in folder.iterdir() if path.name.lower().endswith(_DESCRIPTIONS))
    return files[0].name.split(".")[0] if len(files) == 1 else folder.resolve().name or "arm"
