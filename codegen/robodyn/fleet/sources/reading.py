"""``fleet.toml``: the types of a fleet, and where the logs of its units are."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from datetime import UTC, date, datetime, tzinfo
from functools import partial
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place
from robodyn.files import label, read_text
from robodyn.fleet.limits import LARGEST_FILE
from robodyn.fleet.sources.dates import DateFormat, NotADate, check_format, checked_zone
from robodyn.fleet.sources.fleet import ArmType, Fleet, arm_type
from robodyn.fleet.sources.folder import fleet_of_folder
from robodyn.fleet.sources.gathering import Facts, Gathering, check_name
from robodyn.fleet.sources.manifest import COLUMNS, Manifest, read_manifest
from robodyn.fleet.sources.pattern import DATE, TEXTS, Match, Pattern, matches, pattern_of
from robodyn.project.tables import Key, Tables, shown

#: What the file is called in a folder, in small letters or large ones.
FILE: Final = "fleet.toml"
#: The word for dates and times that stand in the logs themselves.
IN_LOG_WORD: Final = "log"
#: Keys of the file, of a type, and of an entry of logs.
TOP: Final = ("name", "timezone", "types", "logs")
OF_TYPE: Final = ("robot", "map", "columns", "parameters")
OF_LOGS: Final = (
    "files", "manifest", "exclude", "type", "unit", "date", "timezone", "conditions", "columns",
)  # fmt: skip


def read_fleet(path: str | Path) -> Fleet:
    """The fleet that the file ``path`` describes, or that is in the folder ``path``.

    A folder has a ``fleet.toml``, or a folder for each type with a folder for each unit. Logs are listed,
    and nothing of them is read.

    Raises
    ------
    InputError: there is none, it is wrong, or a log lacks its type, its unit or its date; with its place.
    """
    path = Path(path)
    try:
        return _read(path, label(path))
    except OSError as error:
        raise InputError(
            "a file or folder of the fleet cannot be read",
            where=Place(label(error.filename or path)),
            found=(error.strerror or str(error)).lower(),
        ) from None


def _read(path: Path, name: str) -> Fleet:
    if path.is_dir():
        files = sorted(each for each in path.iterdir() if each.name.lower() == FILE)
        if len(files) > 1:
            raise InputError(
                "the folder has two descriptions of a fleet",
                where=Place(name),
                found=", ".join(each.name for each in files),
                remedy="name one of them",
            )
        if not files:
            return fleet_of_folder(path)
        path, name = files[0], label(files[0])
    elif not path.exists():
        raise InputError(
            "there is no fleet of this name",
            where=Place(name),
            expected="a file such as fleet.toml, or a folder with one",
        )
    text = read_text(path, LARGEST_FILE, "a description of a fleet, such as fleet.toml", name)
    return _Reader(Tables(text, name), path.parent).fleet()


class _Reader:
    """Reads the tables of one file; relative paths in it start in ``folder``."""

    def __init__(self, tables: Tables, folder: Path) -> None:
        self.tables, self.folder = tables, folder
        self.file = Place(tables.places.file)

    def fleet(self) -> Fleet:
        self.tables.check_keys((), TOP)
        top = self.tables.table()
        name = self._name(("name",), top.get("name", self.folder.resolve().name or "fleet"))
        zone = self._zone(("timezone",), top, UTC)
        types = dict(self._types())
        gathering = Gathering()
        entries = top.get("logs", [])
        if not isinstance(entries, list) or not entries or not all(isinstance(e, dict) for e in entries):
            raise InputError(
                "nothing says where the logs are",
                where=self.tables.places.of("logs"),
                found=shown(entries) if "logs" in top else None,
                expected='[[logs]], and below it files = "logs/{type}/{unit}/{date}.csv"',
            )
        for k, entry in enumerate(entries):
            self.tables.check_keys(("logs", k), OF_LOGS)
            self._entry(("logs", k), entry, zone, gathering)
        return gathering.fleet(name, types, self.file)

    def _types(self) -> Iterator[tuple[str, ArmType]]:
        types = self.tables.table("types")
        if not types:
            raise InputError(
                "the fleet has no types",
                where=self.tables.places.of("types"),
                expected="a table for each",
                remedy="write [types.NAME], and below it robot = 'arms/arm.yaml', or a bundled robot",
            )
        for name in types:
            at: tuple[Key, ...] = ("types", name)
            with self._stated(*at):
                check_name(name, "a type")
            table = self.tables.table(*at)
            self.tables.check_keys(at, OF_TYPE)
            stated = (*at, "robot") if "robot" in table else at
            spec = self.tables.description(stated, table.get("robot", name), self.folder)
            map_path, columns = (
                self.tables.text((*at, key), table[key]) if key in table else None
                for key in ("map", "columns")
            )
            if map_path and columns:
                raise InputError(
                    f"the type {shown(name)} has both a map and columns",
                    where=self.tables.places.of(*at, "columns"),
                    remedy="delete one of them",
                )
            yield (
                name,
                arm_type(
                    name,
                    spec,
                    None if map_path is None else self.folder / map_path,
                    columns,
                    self._numbers((*at, "parameters")),
                    partial(self._place, at),
                ),
            )

    def _entry(
        self, at: tuple[Key, ...], entry: Mapping[str, Any], above: tzinfo, gathering: Gathering
    ) -> None:
        """Add the logs that one ``[[logs]]`` names."""
        if ("files" in entry) == ("manifest" in entry):
            raise InputError(
                "an entry of logs has both files and a manifest"
                if "files" in entry
                else "an entry of logs names none",
                where=self.tables.places.of(*at),
                expected='files = "logs/{type}/{unit}/{date}.csv", or manifest = "manifest.csv"',
            )
        kind, unit = (self._name((*at, key), entry[key]) if key in entry else None for key in TEXTS)
        fixed = Facts(self.file, kind, unit)
        dates = self._dates(at, entry, self._zone((*at, "timezone"), entry, above), fixed)
        exclude = tuple(self._exclude(at, entry))
        if "manifest" in entry:
            self._manifest(at, entry, fixed, dates, exclude, gathering)
            return
        if "columns" in entry:
            raise InputError(
                "columns are those of a manifest", where=self.tables.places.of(*at, "columns"),
                remedy="the columns of logs stand at their type: [types.NAME], columns = 't=time[ms],...'",
            )  # fmt: skip
        fixed.conditions = self._numbers((*at, "conditions"))
        with self._stated(*at, "files"):
            text = self.tables.text((*at, "files"), entry["files"], "a pattern of paths")
            pattern = pattern_of(text, dates.format if dates else "")
            if dates:
                dates = DateFormat(pattern.format, dates.zone)
            for match in matches(pattern, self.folder, exclude):
                self._take(match, fixed, dates, gathering)

    def _take(self, match: Match, fixed: Facts, dates: DateFormat | None, gathering: Gathering) -> None:
        """Add the log of one path."""
        path = self.folder / match.path
        where = Place(label(path))
        fields = dict(match.fields)
        written = fields.pop(DATE, None)
        try:
            moment = fixed.date if written is None or dates is None else dates.seconds(written)
            kind, unit = (fields.pop(key, None) or getattr(fixed, key) for key in TEXTS)
            conditions = {key: float(text) for key, text in fields.items()}
            if not all(map(math.isfinite, conditions.values())):
                raise ValueError(conditions)
        except ValueError as error:
            what, text = ("date", written) if isinstance(error, NotADate) else ("condition", fields)
            gathering.fault(
                InputError(
                    f"the {what} of a log cannot be read from its path",
                    where=where,
                    found=shown(text),
                    expected=str(error) if what == "date" else "numbers",
                    remedy="rename it, leave it out with exclude, or say how it is written: date = '%Y%m%d'",
                )
            )
            return
        gathering.add(
            str(path), Facts(where, kind, unit, moment, fixed.in_log, {**fixed.conditions, **conditions})
        )

    def _manifest(
        self, at: tuple[Key, ...], entry: Mapping[str, Any], fixed: Facts, dates: DateFormat | None,
        exclude: tuple[Pattern, ...], gathering: Gathering,
    ) -> None:  # fmt: skip
        path = self.folder / self.tables.text((*at, "manifest"), entry["manifest"])
        if not path.is_file():
            raise InputError(
                "there is no such manifest", where=self.tables.places.of(*at, "manifest"), found=label(path),
                expected="a path, as seen from this file's folder",
            )  # fmt: skip
        self.tables.check_keys((*at, "columns"), COLUMNS)
        stated = self.tables.table(*at, "columns")
        columns = {
            key: self.tables.text((*at, "columns", key), stated.get(key, key), "the name of a column")
            for key in COLUMNS
        }
        conditions = entry.get("conditions")
        if isinstance(conditions, list) and all(isinstance(name, str) for name in conditions):
            conditions = dict(zip(conditions, conditions, strict=True))
        if conditions is not None and not (
            isinstance(conditions, dict) and all(isinstance(each, str) for each in conditions.values())
        ):
            raise InputError(
                "conditions of a manifest are columns", where=self.tables.places.of(*at, "conditions"),
                found=shown(entry["conditions"]), expected="['temperature'], or {temperature = 'COLUMN'}",
            )  # fmt: skip
        read_manifest(Manifest(path, columns, conditions, dates, exclude), fixed, gathering)

    def _dates(
        self, at: tuple[Key, ...], entry: Mapping[str, Any], zone: tzinfo, fixed: Facts
    ) -> DateFormat | None:
        """How the dates of an entry are written, None if they stand in the logs; one that holds for all logs
        goes to ``fixed``."""
        value = entry.get("date", "")
        if isinstance(value, date):
            moment = value if isinstance(value, datetime) else datetime(value.year, value.month, value.day)
            try:
                fixed.date = DateFormat("", zone).seconds(moment.isoformat())
            except NotADate as error:
                raise InputError(
                    "no log has this date",
                    where=self.tables.places.of(*at, "date"),
                    found=shown(str(value)),
                    expected=str(error),
                ) from None
            return DateFormat("", zone)
        if value == IN_LOG_WORD:
            fixed.in_log = True
            return None
        if not isinstance(value, str):
            raise InputError(
                "this is no format of dates", where=self.tables.places.of(*at, "date"), found=shown(value),
                expected="a text such as '%Y-%m-%dT%H%M', 'unix' or 'log', or a date for all of the logs",
            )  # fmt: skip
        with self._stated(*at, "date"):
            return DateFormat(check_format(value), zone)

    def _exclude(self, at: tuple[Key, ...], entry: Mapping[str, Any]) -> Iterator[Pattern]:
        patterns = entry.get("exclude", [])
        for text in patterns if isinstance(patterns, list) else [patterns]:
            stated = (*at, "exclude")
            checked = self.tables.text(stated, text, "a pattern of paths, or a list of them")
            with self._stated(*stated):
                pattern = pattern_of(checked, "")
            yield pattern

    def _zone(self, at: tuple[Key, ...], table: Mapping[str, Any], default: tzinfo) -> tzinfo:
        if at[-1] not in table:
            return default
        with self._stated(*at):
            return checked_zone(self.tables.text(at, table["timezone"], "a time zone"))

    @contextmanager
    def _stated(self, *at: Key) -> Iterator[None]:
        """What is said of the key ``at`` has its place: looking it up takes longer than reading the file."""
        try:
            yield
        except InputError as error:
            raise (error if error.where is not None else error.at(self.tables.places.of(*at))) from None

    def _place(self, at: tuple[Key, ...], key: str) -> Place:
        """Where the table ``at`` states ``key``, or begins."""
        return self.tables.places.of(*at, *([key] if key in self.tables.table(*at) else []))

    def _name(self, at: tuple[Key, ...], value: Any) -> str:
        text = self.tables.text(at, value, "a name")
        with self._stated(*at):
            check_name(text, f"the {at[-1]}")
        return text

    def _numbers(self, at: tuple[Key, ...]) -> dict[str, float]:
        """Numbers by name."""
        table = self.tables.table(*at)
        for name, value in table.items():
            if isinstance(value, bool) or not isinstance(value, int | float) or not _is_finite(value):
                raise InputError(
                    f"{name} is not a number", where=self.tables.places.of(*at, name), found=shown(value)
                )
        return {name: float(value) for name, value in table.items()}


def _is_finite(value: float) -> bool:
    """Whether ``value``, which may be a whole number of any size, is a double."""
    try:
        return math.isfinite(float(value))
    except OverflowError:
        return False
