"""Manifests: lists of logs with what is known of each, as CSV or as lines of JSON."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.files import label, parsed_json, read_text
from robodyn.fleet.limits import LARGEST_MANIFEST
from robodyn.fleet.sources.dates import DateFormat, NotADate
from robodyn.fleet.sources.gathering import Facts, Gathering, source_of
from robodyn.fleet.sources.pattern import Pattern, excluded, kind_of
from robodyn.logs.content import files_of
from robodyn.robot.names import shown

JSON_LINES: Final = (".jsonl", ".ndjson")
#: What a column may say of a log, beside conditions.
COLUMNS: Final = ("source", "type", "unit", "date")
#: [characters] Longer paths are not repeated in messages.
_LONGEST_SHOWN: Final = 200
_MARKS: Final = (",", ";", "\t", "|")


@dataclass(frozen=True, slots=True)
class Manifest:
    """A manifest at ``path``: what its ``columns`` are called, by what they say; which ``conditions`` are in
    which columns (None: all others); how dates are written (None: they are in the logs); what of it to leave
    out."""

    path: Path
    columns: Mapping[str, str]
    conditions: Mapping[str, str] | None
    dates: DateFormat | None
    exclude: tuple[Pattern, ...] = ()


def read_manifest(manifest: Manifest, fixed: Facts, gathering: Gathering) -> None:
    """Add the logs of ``manifest`` to ``gathering``; ``fixed``: what holds for all of them.

    Raises
    ------
    InputError: it cannot be read; a log is not there; with file and line.
    """
    name = label(manifest.path)
    text = read_text(manifest.path, LARGEST_MANIFEST, "a manifest of logs, such as manifest.csv", name)
    lines = manifest.path.suffix.lower() in JSON_LINES
    for where, row in _json_lines(text, name) if lines else _rows(text, name, manifest):
        _take(manifest, where, row, fixed, gathering)


def _take(
    manifest: Manifest, where: Place, row: Mapping[str, Any], fixed: Facts, gathering: Gathering
) -> None:
    """Add the log of one row."""
    texts = {key: _text(row.get(column), column, where) for key, column in manifest.columns.items()}
    source = texts["source"]
    if source is None:
        raise InputError(
            "the line names no log",
            where=where,
            found=f"nothing as {manifest.columns['source']}",
            expected="the path of a log, as seen from the manifest's folder",
        )
    if any(excluded(each, source) for each in manifest.exclude):
        return
    path = source_of(manifest.path.parent, source)
    _check_files(path, source, where)
    date = fixed.date
    if texts["date"] is not None and manifest.dates is not None:
        try:
            date = manifest.dates.seconds(texts["date"])
        except NotADate as error:
            gathering.fault(
                InputError(
                    "the date of a log cannot be read",
                    where=where,
                    found=shown(texts["date"]),
                    expected=str(error),
                    remedy="correct it, or say how dates are written: date = '%d.%m.%Y', or 'unix'",
                )
            )
            return
    own = dict(_conditions(manifest, row, where))
    gathering.add(
        path,
        Facts(
            where,
            texts["type"] or fixed.type,
            texts["unit"] or fixed.unit,
            date,
            fixed.in_log,
            {**fixed.conditions, **own},
        ),
    )


def _check_files(path: str, source: str, where: Place) -> None:
    for part in files_of(path):
        try:
            kind = kind_of(Path(part))
        except (OSError, ValueError) as error:
            kind = f"not to be read: {(getattr(error, 'strerror', None) or str(error)).lower()}"
        if kind is not None:
            raise InputError(
                f"the log {shown(source, 80)} is {kind}",
                where=where,
                found=label(part) if len(part) <= _LONGEST_SHOWN else None,
                expected="the path of a log, as seen from the manifest's folder",
                remedy="correct the path, or delete the line",
            )


def _conditions(manifest: Manifest, row: Mapping[str, Any], where: Place) -> Iterator[tuple[str, float]]:
    """The conditions in a row: numbers; where nothing stands, none."""
    listed = dict(row)
    if isinstance(row.get("conditions"), dict):
        del listed["conditions"]
        listed = {**row["conditions"], **listed}
    columns = manifest.conditions
    if columns is None:
        columns = {key: key for key in listed if key not in manifest.columns.values()}
    for name, column in columns.items():
        value = listed.get(column)
        if value is None or (isinstance(value, str) and not value.strip()):
            continue
        try:
            if isinstance(value, bool | list | dict):
                raise ValueError(value)
            quantity = float(value)
            if not math.isfinite(quantity):
                raise ValueError(value)
        except ValueError:
            raise InputError(
                f"the condition {shown(name)} is not a number",
                where=where,
                found=shown(str(value)),
                expected="a number, decimals with a point, or nothing",
                remedy="say which columns are conditions: conditions = ['temperature']",
            ) from None
        yield name, quantity


def _text(value: Any, column: str, where: Place) -> str | None:
    """A cell as text; None where nothing stands in it."""
    if value is None or value == "":
        return None
    if isinstance(value, int | float) and not isinstance(value, bool):
        return str(value)
    if not isinstance(value, str) or "\0" in value:
        raise InputError(f"{shown(column)} is not a text", where=where, found=shown(str(value)))
    return value


def _json_lines(text: str, name: str) -> Iterator[tuple[Place, Mapping[str, Any]]]:
    """The objects of JSON, one a line."""
    for line, data in enumerate(text.split("\n"), 1):
        if not data.strip():
            continue
        try:
            row = parsed_json(data)
        except ValueError as error:
            raise InputError("the line is not JSON", where=Place(name, line), found=str(error)[:80]) from None
        if not isinstance(row, dict):
            raise InputError(
                "the line is no object",
                where=Place(name, line),
                found=shown(data),
                expected='{"source": "logs/a.csv", "unit": "7", "date": "2026-05-03"}',
            )
        yield Place(name, line), row


def _rows(text: str, name: str, manifest: Manifest) -> Iterator[tuple[Place, Mapping[str, Any]]]:
    """The rows of CSV by the names in its first line; commas, semicolons, tabs or bars between cells."""
    first = text.partition("\n")[0]
    mark = max(_MARKS, key=first.count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=mark, strict=True)
    try:
        header = [cell.strip() for cell in next(reader, [])]
        _check_header(header, name, manifest)
        line = reader.line_num
        for cells in reader:
            where, line = Place(name, line + 1), reader.line_num
            if not any(cell.strip() for cell in cells):
                continue
            if len(cells) != len(header):
                raise InputError(
                    "the line has another number of cells than the header",
                    where=where,
                    found=str(len(cells)),
                    expected=str(len(header)),
                    remedy="put texts with the separating mark in them in quotes",
                )
            yield where, dict(zip(header, (cell.strip() for cell in cells), strict=True))
    except csv.Error as error:
        raise InputError(
            "the manifest is not CSV", where=Place(name, reader.line_num), found=str(error)
        ) from None


def _check_header(header: list[str], name: str, manifest: Manifest) -> None:
    """Refuse a table without the columns that are needed, or with two of one name."""
    where = Place(name, 1)
    wanted = [manifest.columns["source"], *(manifest.conditions or {}).values()]
    stated = [column for key, column in manifest.columns.items() if column != key]
    for column in (*wanted, *stated):
        if column not in header:
            raise InputError(
                f"the manifest has no column {shown(column)}",
                where=where,
                found=", ".join(map(shown, header[:12])) or "nothing",
                remedy=did_you_mean(column, header) or "say how it is called: columns = {source = 'file'}",
            )
    twice = sorted({column for column in header if column and header.count(column) > 1})
    if twice:
        raise InputError(
            "the manifest has two columns with the same name", where=where, found=", ".join(twice[:8])
        )
