"""A fleet that nothing describes: a folder for each type, in it a folder for each unit, in it logs."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place
from robodyn.files import label
from robodyn.fleet.sources.dates import DateFormat, date_in
from robodyn.fleet.sources.fleet import ArmType, Fleet, arm_type
from robodyn.fleet.sources.gathering import Facts, Gathering
from robodyn.formats.loading import SUFFIXES
from robodyn.logs.formats import is_log
from robodyn.resources import bundled_robot
from robodyn.robot.names import shown

#: The map of a type's logs, in its folder.
MAP: Final = "map.yaml"
#: Ends of the names of descriptions.
DESCRIPTIONS: Final = (".yaml", ".yml", *SUFFIXES)
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
        logs = [(unit.name, log) for unit in _folders(kind) for log in _logs(unit)]
        place, spec = Place(label(kind)), description_of(folder, kind.name)
        if spec is not None:
            mapping = kind / MAP
            try:
                types[kind.name] = arm_type(kind.name, str(spec), mapping if mapping.is_file() else None)
            except InputError as error:
                raise (error if error.where is not None else error.at(place)) from None
        elif logs:
            raise InputError(
                f"the arms of the type {shown(kind.name)} have no description",
                where=place,
                expected=f"{kind.name}.yaml or .urdf, beside the folder or in it",
                remedy="write it, or a fleet.toml that says where it is",
            )
        for unit, log in logs:
            date = date_in(log.stem)
            texts = {"type": kind.name, "unit": unit, "date": date[0] if date else log.stem}
            gathering.take(str(log), Place(label(log)), texts, Facts(place), DateFormat(""))
    if not types:
        raise InputError(
            "no fleet is recognised in the folder",
            where=Place(label(folder)),
            found=", ".join(shown(each.name) for each in sorted(folder.iterdir())[:6]) or "nothing",
            expected=_EXPECTED,
        )
    return gathering.fleet(folder.resolve().name or "fleet", types, Place(label(folder)))


def _folders(folder: Path) -> Iterator[Path]:
    for path in sorted(folder.iterdir()):
        if path.is_dir() and not path.name.startswith("."):
            yield path


def _logs(unit: Path) -> list[Path]:
    """The logs in the folder of a unit, by their suffixes; others, such as notes and pictures, are passed
    over."""
    return [path for path in sorted(unit.iterdir()) if not path.name.startswith(".") and is_log(path)]


def description_of(folder: Path, name: str) -> Path | None:
    """The description of the type ``name`` in a fleet's ``folder``: a file of its name there, or in the
    type's folder, else a bundled robot."""
    paths = [place / f"{name}{ending}" for place in (folder / name, folder) for ending in DESCRIPTIONS]
    return next((path for path in paths if path.is_file()), bundled_robot(name))
