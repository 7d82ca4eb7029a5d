"""Manifests: tables of logs with what is known of each, as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.files import label, read_text
from robodyn.fleet.limits import LARGEST_MANIFEST
from robodyn.fleet.sources.dates import DateFormat
from robodyn.fleet.sources.gathering import Facts, Gathering, source_of
from robodyn.fleet.sources.pattern import Pattern
from robodyn.robot.names import shown

#: What a column may say of a log, beside conditions.
COLUMNS: Final = ("source", "type", "unit", "date")
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
    """Add the logs of ``manifest`` to ``gathering``; ``fixed``: what holds for all of them. Whether they are
    there is seen when they are read.

    Raises
    ------
    InputError: it cannot be read; with file and line.
    """
    folder, conditions = manifest.path.parent, manifest.conditions
    for where, row in _rows(manifest):
        if conditions is None:
            conditions = {column: column for column in row if column not in manifest.columns.values()}
        columns = {**conditions, **manifest.columns}
        texts = {name: row[column] for name, column in columns.items() if row.get(column)}
        source = texts.pop("source", None)
        if source is None:
            raise InputError(
                "the line names no log",
                where=where,
                found=f"nothing as {manifest.columns['source']}",
                expected="the path of a log, as seen from the manifest's folder",
            )
        if not any(each.covers(source) for each in manifest.exclude):
            gathering.take(source_of(folder, source), where, texts, fixed, manifest.dates)


def _rows(manifest: Manifest) -> Iterator[tuple[Place, dict[str, str]]]:
    """The rows by the names in the first line; commas, semicolons, tabs or bars between cells."""
    name = label(manifest.path)
    text = read_text(manifest.path, LARGEST_MANIFEST, "a manifest of logs, such as manifest.csv", name)
    mark = max(_MARKS, key=text.partition("\n")[0].count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=mark, strict=True)
    try:
        if "\0" in text:
            raise csv.Error("a character of the number 0")
        header = [cell.strip() for cell in next(reader, [])]
        _check_header(header, name, manifest)
        line = reader.line_num
        for row in reader:
            cells, where, line = [cell.strip() for cell in row], Place(name, line + 1), reader.line_num
            if any(cells) and len(cells) != len(header):
                raise InputError(
                    "the line has another number of cells than the header",
                    where=where,
                    found=str(len(cells)),
                    expected=str(len(header)),
                    remedy="put texts with the separating mark in them in quotes",
                )
            if any(cells):
                yield where, dict(zip(header, cells, strict=True))
    except csv.Error as error:
        raise InputError(
            "the manifest is not CSV", where=Place(name, reader.line_num), found=str(error)
        ) from None


def _check_header(header: list[str], name: str, manifest: Manifest) -> None:
    """Refuse a table without the columns that are needed, or with two of one name."""
    stated = [column for key, column in manifest.columns.items() if column != key]
    for column in (manifest.columns["source"], *(manifest.conditions or {}).values(), *stated):
        if column not in header:
            raise InputError(
                f"the manifest has no column {shown(column)}",
                where=Place(name, 1),
                found=", ".join(map(shown, header[:12])) or "nothing",
                remedy=did_you_mean(column, header) or "say how it is called: columns = {source = 'file'}",
            )
    twice = sorted({column for column in header if column and header.count(column) > 1})
    if twice:
        raise InputError(
            "the manifest has two columns with the same name",
            where=Place(name, 1),
            found=", ".join(twice[:8]),
        )
