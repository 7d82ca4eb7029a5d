"""``fleet.toml``: the types of a fleet, and where the logs of its units are."""

from __future__ import annotations

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
from robodyn.fleet.sources.fleet import IN_LOG, ArmType, Fleet, arm_type
from robodyn.fleet.sources.gathering import Gathering, check_name, source_of
from robodyn.fleet.sources.manifest import COLUMNS, read_manifest
from robodyn.fleet.sources.pattern import DATE, matches, pattern_of
from robodyn.fleet.sources.proposal import propose_fleet
from robodyn.fleet.sources.schema import OF_FILES, OF_MANIFEST, OF_TYPE, TOP, check_table
from robodyn.logs.map_text import map_text
from robodyn.logs.mapping import map_of_columns
from robodyn.project.tables import Key, Tables

#: What a file must state, and how.
_NEEDED: Final = {
    "types": "[types.NAME], and below it robot = 'arms/arm.yaml', or a bundled robot",
    "logs": '[[logs]], and below it files = "logs/{type}/{unit}/{date}.csv", or manifest = "manifest.csv"',
}
#: What the file is called in a folder, and in messages where a folder has none.
FILE: Final = "fleet.toml"
_PROPOSED: Final = "the fleet.toml that robodyn fleet init proposes"
#: The date of logs whose own times are dates.
_IN_LOG: Final = "log"


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
            return _Reader(Tables(propose_fleet(path, bare=True).text, _PROPOSED), path).fleet()
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

    def fleet(self) -> Fleet:
        check_table(self.tables, (), TOP)
        top = self.tables.data
        for key, way in _NEEDED.items():
            if not top.get(key):
                raise InputError(f"the fleet has no {key}", where=self.tables.places.of(key), expected=way)
        zone = self._zone((), top, UTC)
        types = {name: self._type(("types", name), table) for name, table in top["types"].items()}
        for k, entry in enumerate(top["logs"]):
            self._entry(("logs", k), entry, zone)
        name = top.get("name", self.folder.resolve().name or "fleet")
        return self.gathering.fleet(name, types, Place(self.tables.places.file))

    def _type(self, at: tuple[Key, ...], table: Mapping[str, Any]) -> ArmType:
        check_table(self.tables, at, OF_TYPE)
        name = str(at[-1])
        with self._stated(*at):
            check_name(name, "a type")
        spec = self.tables.description(
            (*at, "robot") if "robot" in table else at, table.get("robot", name), self.folder
        )
        mapping = self._file((*at, "map"), table["map"]) if "map" in table else None
        parameters = table.get("parameters", {})
        with self._stated(*at, *(["parameters"] if parameters else [])):
            arm = arm_type(name, spec, mapping, parameters)
        if "columns" not in table:
            return arm
        try:
            if mapping is not None:
                raise InputError(f"the type {name} has both a map and columns", remedy="delete one")
            return replace(arm, mapping=map_text(map_of_columns(table["columns"]), {}))
        except InputError as error:
            raise error.at(self.tables.places.of(*at, "columns")) from None

    def _entry(self, at: tuple[Key, ...], entry: Mapping[str, Any], above: tzinfo) -> None:
        """Add the logs that one ``[[logs]]`` names."""
        check_table(self.tables, at, OF_MANIFEST if "manifest" in entry else OF_FILES)
        if "manifest" not in entry and "files" not in entry:
            where = self.tables.places.of(*at)
            raise InputError("an entry of logs names none", where=where, expected=_NEEDED["logs"])
        zone = self._zone(at, entry, above)
        fixed: dict[str, Any] = {key: entry[key] for key in ("type", "unit") if key in entry}
        with self._stated(*at, "date"):
            dates = self._dates(entry.get("date", ""), zone, fixed)
        excluded = entry.get("exclude", [])
        with self._stated(*at, "exclude"):
            exclude = [pattern_of(one) for one in ([excluded] if isinstance(excluded, str) else excluded)]
        conditions = entry.get("conditions")
        if "manifest" in entry:
            table = self._file((*at, "manifest"), entry["manifest"])
            columns = {key: entry.get("columns", {}).get(key, key) for key in COLUMNS}
            named = {name: name for name in conditions} if isinstance(conditions, list) else conditions
            for where, source, texts in read_manifest(table, columns, named):
                if not any(each.covers(source) for each in exclude):
                    self.gathering.take(source_of(table.parent, source), where, texts, fixed, dates)
            return
        fixed |= {name: float(value) for name, value in (conditions or {}).items()}
        with self._stated(*at, "files"):
            pattern = pattern_of(entry["files"], dates.format if dates else "")
            in_names = dates and replace(dates, format=pattern.format)
            for path, fields in matches(pattern, self.folder, exclude):
                log = str(self.folder / path)
                self.gathering.take(log, Place(label(log)), fields, fixed, in_names)

    def _dates(self, value: Any, zone: tzinfo, fixed: dict[str, Any]) -> DateFormat | None:
        """How the dates of an entry are written, None if they stand in the logs; one that holds for all logs
        goes to ``fixed``."""
        if value == _IN_LOG:
            fixed[DATE] = IN_LOG
            return None
        if isinstance(value, date):
            fixed[DATE] = DateFormat("", zone).seconds(value.isoformat())
            value = ""
        return DateFormat(check_format(value), zone)

    def _zone(self, at: tuple[Key, ...], table: Mapping[str, Any], default: tzinfo) -> tzinfo:
        with self._stated(*at, "timezone"):
            return zone_of(table["timezone"]) if "timezone" in table else default

    def _file(self, at: tuple[Key, ...], value: str) -> Path:
        """The file that the key ``at`` names."""
        path = self.folder / value
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
