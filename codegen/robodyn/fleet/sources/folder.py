"""A fleet that nothing describes: a folder for each type, in it a folder for each unit, in it logs."""

from __future__ import annotations

import re
from collections.abc import Iterator
from datetime import UTC
from functools import partial
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.sources.dates import ISO, DateFormat, NotADate
from robodyn.fleet.sources.fleet import ArmType, Fleet, arm_type
from robodyn.fleet.sources.gathering import Facts, Gathering, check_name
from robodyn.formats.loading import SUFFIXES
from robodyn.logs.formats import is_log
from robodyn.resources import bundled_robot
from robodyn.robot.names import shown

#: The map of a type's logs, in its folder.
MAP: Final = "map.yaml"
#: Ends of the names of descriptions.
DESCRIPTIONS: Final = (".yaml", ".yml", *SUFFIXES)
#: A date in the name of a log.
DATE: Final = re.compile(rf"(?<!\d){ISO}(?!\d)", re.ASCII)
_EXPECTED: Final = "TYPE/UNIT/2026-05-03T1200.csv and TYPE.yaml (or TYPE of a bundled robot), or a fleet.toml"


def fleet_of_folder(folder: Path) -> Fleet:
    """The fleet in ``folder``: its types are folders with a description in them or beside them, or called as
    a bundled robot.

    Raises
    ------
    InputError: it is arranged otherwise, or the name of a log has no date.
    """
    types: dict[str, ArmType] = {}
    gathering = Gathering()
    for kind in _folders(folder):
        units = list(_folders(kind))
        spec = _description(kind)
        if spec is None:
            if any(_logs(unit) for unit in units):
                raise InputError(
                    f"the arms of the type {shown(kind.name)} have no description",
                    where=Place(label(kind)),
                    expected=f"{kind.name}.yaml or .urdf, beside the folder or in it",
                    remedy="write it, or a fleet.toml that says where it is",
                )
            continue
        place = Place(label(kind))
        check_name(kind.name, "a type", place)
        map_path = kind / MAP
        types[kind.name] = arm_type(
            kind.name, spec, map_path if map_path.is_file() else None, None, {}, partial(_anywhere, place)
        )
        for unit in units:
            for log in _logs(unit):
                _take(log, kind.name, unit.name, gathering)
    if not types:
        raise InputError(
            "no fleet is recognised in the folder",
            where=Place(label(folder)),
            found=", ".join(shown(name) for name in sorted(each.name for each in folder.iterdir())[:6])
            or "nothing",
            expected=_EXPECTED,
        )
    return gathering.fleet(folder.resolve().name or "fleet", types, Place(label(folder)))


def _anywhere(place: Place, _: str) -> Place:
    """The ``place`` of a type of which no line says anything."""
    return place


def _take(log: Path, kind: str, unit: str, gathering: Gathering) -> None:
    where = Place(label(log))
    match = DATE.search(log.stem)
    try:
        if match is None:
            raise NotADate("a name with its date, such as 2026-05-03T1200.csv")
        date = DateFormat("", UTC).seconds(match[0])
    except NotADate as error:
        gathering.fault(
            InputError(
                "the name of a log has no date",
                where=where,
                expected=str(error),
                remedy="rename it, or write a fleet.toml that says where its date stands",
            )
        )
        return
    gathering.add(str(log), Facts(where, kind, unit, date))


def _folders(folder: Path) -> Iterator[Path]:
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.name.startswith("."):
            yield path


def _logs(unit: Path) -> list[Path]:
    """The logs in the folder of a unit, by their suffixes; others, such as notes and pictures, are passed
    over."""
    return [path for path in sorted(unit.iterdir()) if not path.name.startswith(".") and is_log(path)]


def _description(kind: Path) -> str | None:
    """The description of the type whose folder ``kind`` is."""
    inside = [
        path
        for path in sorted(kind.iterdir())
        if path.is_file() and path.name.lower().endswith(DESCRIPTIONS) and path.name != MAP
    ]
    if len(inside) > 1:
        raise InputError(
            "the folder of a type has several descriptions",
            where=Place(label(kind)),
            found=", ".join(shown(path.name) for path in inside[:6]),
            expected="one",
            remedy="delete the others, or write a fleet.toml that says which",
        )
    beside = [kind.with_name(kind.name + ending) for ending in DESCRIPTIONS]
    for path in (*inside, *beside):
        if path.is_file():
            return str(path)
    bundled = bundled_robot(kind.name)
    return None if bundled is None else str(bundled)
