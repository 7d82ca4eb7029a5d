"""Manifests: tables of logs with what is known of each, as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Final

from robodyn.errors import InputError, Place, did_you_mean
from robodyn.files import label, read_text
from robodyn.fleet.limits import LARGEST_MANIFEST
from robodyn.robot.names import shown

#: What a column may say of a log, beside conditions.
COLUMNS: Final = ("source", "type", "unit", "date")
_MARKS: Final = (",", ";", "\t", "|")


def read_manifest(
    path: Path, columns: Mapping[str, str], conditions: Mapping[str, str] | None
) -> Iterator[tuple[Place, str, dict[str, str]]]:
    """Of each log of the manifest at ``path`` the place, its path and what is said of it by name.
    ``columns``: what they are called by what they say; which ``conditions`` are in which columns (None: all
    others).

    Raises
    ------
    InputError: it cannot be read; with file and line.
    """
    stated = [columns["source"], *(conditions or {}).values()]
    stated += [column for key, column in columns.items() if column != key]
    for where, row in _rows(path, stated):
        others = {column: column for column in row if column not in columns.values()}
        names = {**(others if conditions is None else conditions), **columns}
        texts = {name: row[column] for name, column in names.items() if row.get(column)}
        source = texts.pop("source", None)
        if source is None:
            raise InputError(
                "the line names no log",
                where=where,
                found=f"nothing as {columns['source']}",
                expected="the path of a log, as seen from the manifest's folder",
            )
        yield where, source, texts


def _rows(path: Path, stated: Sequence[str]) -> Iterator[tuple[Place, dict[str, str]]]:
    """The rows by the names in the first line, with at least the ``stated`` ones; commas, semicolons, tabs or
    bars between cells."""
    name = label(path)
    text = read_text(path, LARGEST_MANIFEST, "a manifest of logs, such as manifest.csv", name)
    mark = max(_MARKS, key=text.partition("\n")[0].count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=mark, strict=True)
    try:
        if "\0" in text:
            raise csv.Error("a character of the number 0")
        header = [cell.strip() for cell in next(reader, [])]
        _check_header(header, Place(name, 1), stated)
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


def _check_header(header: list[str], where: Place, stated: Sequence[str]) -> None:
    """Refuse a table without the columns that are needed, or with two of one name."""
    for column in stated:
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
