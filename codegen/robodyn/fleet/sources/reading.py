"""``fleet.toml``: the types of a fleet, and where the logs of its units are."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from datetime import UTC, date, tzinfo
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.fleet.limits import LARGEST_FILE
from robodyn.fleet.sources.dates import DateFormat, check_format, zone_of
from robodyn.fleet.sources.fleet import ArmType, Fleet, arm_type
from robodyn.fleet.sources.folder import fleet_of_folder
from robodyn.fleet.sources.gathering import IN_LOG_WORD, Facts, Gathering, check_name
from robodyn.fleet.sources.manifest import COLUMNS, Manifest, read_manifest
from robodyn.fleet.sources.pattern import DATE, TEXTS, matches, pattern_of
from robodyn.fleet.sources.schema import OF_FILES, OF_MANIFEST, OF_TYPE, TOP
from robodyn.logs.map_text import map_text
from robodyn.logs.mapping import map_of_columns
from robodyn.project.tables import Key, Tables, shown

#: What the file is called in a folder.
FILE: Final = "fleet.toml"


def read_fleet(path: str | Path) -> Fleet:
    """The fleet that the file ``path`` describes, or that is in the folder ``path``.

    A folder has a ``fleet.toml``, or a folder for each type with a folder for each unit. Logs are listed,
    and nothing of them is read.

    Raises
    ------
    InputError: there is none, it is wrong, or a log lacks its type, its unit or its date; with its place.
    """
    path = Path(path)
    file = path / FILE if path.is_dir() else path
    try:
        if path.is_dir() and not file.is_file():
            return fleet_of_folder(path)
        text = read_text(
            file, LARGEST_FILE, "a description of a fleet, such as fleet.toml, or a folder with one"
        )
        return _Reader(Tables(text, label(file)), file.parent).fleet()
    except OSError as error:
        raise InputError(
            "a file or folder of the fleet cannot be read",
            where=Place(label(error.filename or path)),
            found=(error.strerror or str(error)).lower(),
        ) from None


class _Reader:
    """Reads the tables of one file; relative paths in it start in ``folder``."""

    def __init__(self, tables: Tables, folder: Path) -> None:
        self.tables, self.folder, self.gathering = tables, folder, Gathering()
        self.file = Place(tables.places.file)

    def fleet(self) -> Fleet:
        self.tables.check_keys((), TOP)
        top = self.tables.table()
        name = self._name(("name",), top.get("name", self.folder.resolve().name or "fleet"))
        zone = self._zone(("timezone",), top, UTC)
        types = {name: self._type(name) for name in self.tables.table("types")}
        if not types:
            raise InputError(
                "the fleet has no types",
                where=self.tables.places.of("types"),
                expected="a table for each",
                remedy="write [types.NAME], and below it robot = 'arms/arm.yaml', or a bundled robot",
            )
        entries = top.get("logs", [])
        if not isinstance(entries, list) or not entries or not all(isinstance(e, dict) for e in entries):
            raise InputError(
                "nothing says where the logs are",
                where=self.tables.places.of("logs"),
                found=shown(entries) if "logs" in top else None,
                expected='[[logs]], and below it files = "logs/{type}/{unit}/{date}.csv"',
            )
        for k, entry in enumerate(entries):
            self._entry(("logs", k), entry, zone)
        return self.gathering.fleet(name, types, self.file)

    def _type(self, name: str) -> ArmType:
        at: tuple[Key, ...] = ("types", name)
        self._name(at, name)
        table = self.tables.table(*at)
        self.tables.check_keys(at, OF_TYPE)
        stated = {key: (*at, key) if key in table else at for key in OF_TYPE}
        spec = self.tables.description(stated["robot"], table.get("robot", name), self.folder)
        mapping = self._file((*at, "map"), table["map"]) if "map" in table else None
        with self._stated(*stated["parameters"]):
            arm = arm_type(name, spec, mapping, self._numbers((*at, "parameters")))
        if "columns" not in table:
            return arm
        try:
            if mapping is not None:
                raise InputError(f"the type {shown(name)} has both a map and columns", remedy="delete one")
            columns = self.tables.text((*at, "columns"), table["columns"])
            return replace(arm, mapping=map_text(map_of_columns(columns), {}))
        except InputError as error:
            raise error.at(self.tables.places.of(*at, "columns")) from None

    def _entry(self, at: tuple[Key, ...], entry: Mapping[str, Any], above: tzinfo) -> None:
        """Add the logs that one ``[[logs]]`` names."""
        self.tables.check_keys(at, OF_FILES | OF_MANIFEST)
        if ("files" in entry) == ("manifest" in entry):
            raise InputError(
                f"an entry of logs {'has both files and a manifest' if 'files' in entry else 'names none'}",
                where=self.tables.places.of(*at),
                expected='files = "logs/{type}/{unit}/{date}.csv", or manifest = "manifest.csv"',
            )
        self.tables.check_keys(at, OF_FILES if "files" in entry else OF_MANIFEST)
        fixed = Facts(self.file, {key: self._name((*at, key), entry[key]) for key in TEXTS if key in entry})
        dates = self._dates((*at, "date"), entry, self._zone((*at, "timezone"), entry, above), fixed)
        excluded = entry.get("exclude", [])
        with self._stated(*at, "exclude"):
            exclude = tuple(
                pattern_of(self.tables.text((*at, "exclude"), text, "a pattern of paths, or a list of them"))
                for text in (excluded if isinstance(excluded, list) else [excluded])
            )
        if "manifest" in entry:
            table = self._file((*at, "manifest"), entry["manifest"])
            read_manifest(Manifest(table, *self._columns(at, entry), dates, exclude), fixed, self.gathering)
            return
        fixed.conditions.update(self._numbers((*at, "conditions")))
        with self._stated(*at, "files"):
            text = self.tables.text((*at, "files"), entry["files"], "a pattern of paths")
            pattern = pattern_of(text, dates.format if dates else "")
            in_names = dates and replace(dates, format=pattern.format)
            for path, fields in matches(pattern, self.folder, exclude):
                log = str(self.folder / path)
                self.gathering.take(log, Place(label(log)), fields, fixed, in_names)

    def _columns(
        self, at: tuple[Key, ...], entry: Mapping[str, Any]
    ) -> tuple[dict[str, str], dict[str, str] | None]:
        """What columns of a manifest are called, and those of conditions; None: all others."""
        self.tables.check_keys((*at, "columns"), COLUMNS)
        stated = self.tables.table(*at, "columns")
        columns = {
            key: self.tables.text((*at, "columns", key), stated.get(key, key), "the name of a column")
            for key in COLUMNS
        }
        at = (*at, "conditions")
        conditions = entry.get("conditions")
        if isinstance(conditions, list):
            conditions = {str(name): name for name in conditions}
        elif conditions is not None:
            conditions = self.tables.table(*at)
        for column in (conditions or {}).values():
            self.tables.text(at, column, "a column of the manifest, a list or a table of them")
        return columns, conditions

    def _dates(
        self, at: tuple[Key, ...], entry: Mapping[str, Any], zone: tzinfo, fixed: Facts
    ) -> DateFormat | None:
        """How the dates of an entry are written, None if they stand in the logs; one that holds for all logs
        goes to ``fixed``."""
        value = entry.get("date", "")
        if value == IN_LOG_WORD:
            fixed.stated[IN_LOG_WORD] = True
            return None
        with self._stated(*at):
            if isinstance(value, date):
                fixed.stated[DATE] = DateFormat("", zone).seconds(value.isoformat())
                value = ""
            if not isinstance(value, str):
                expected = "a text such as '%Y-%m-%dT%H%M', 'unix' or 'log', or a date for all of the logs"
                self.tables.text(at, value, "a format of dates", expected)
            return DateFormat(check_format(value), zone)

    def _zone(self, at: tuple[Key, ...], table: Mapping[str, Any], default: tzinfo) -> tzinfo:
        if at[-1] not in table:
            return default
        with self._stated(*at):
            return zone_of(self.tables.text(at, table["timezone"], "a time zone"))

    def _file(self, at: tuple[Key, ...], value: Any) -> Path:
        """The file that the key ``at`` names."""
        path = self.folder / self.tables.text(at, value)
        if not path.is_file():
            raise InputError(
                f"there is no such {at[-1]}",
                where=self.tables.places.of(*at),
                found=label(path),
                expected="a path, as seen from this file's folder",
            )
        return path

    @contextmanager
    def _stated(self, *at: Key) -> Iterator[None]:
        """What is said of the key ``at`` has its place: looking it up takes longer than reading the file."""
        try:
            yield
        except InputError as error:
            raise (error if error.where is not None else error.at(self.tables.places.of(*at))) from None

    def _name(self, at: tuple[Key, ...], value: Any) -> str:
        text = self.tables.text(at, value, "a name")
        with self._stated(*at):
            check_name(text, "a type" if at[0] == "types" else f"the {at[-1]}")
        return text

    def _numbers(self, at: tuple[Key, ...]) -> dict[str, float]:
        """Numbers by name."""
        table = self.tables.table(*at)
        for name, value in table.items():
            # A whole number may have any size.
            if type(value) not in (int, float) or not abs(value) < sys.float_info.max:
                raise InputError(
                    f"{name} is not a number", where=self.tables.places.of(*at, name), found=shown(value)
                )
        return {name: float(value) for name, value in table.items()}
