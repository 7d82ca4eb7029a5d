"""CSV and any other text: a table, a line a sample, read in bounded memory.

Reading goes by blocks of whole lines. A block is parsed at once by numpy; only where that fails is it gone
through cell by cell, for the place of what is wrong.
"""

from __future__ import annotations

import io
import math
import os
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import BinaryIO

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.files import open_regular
from robodyn.logs.dialect import (
    HEAD,
    Dialect,
    are_units,
    canonical,
    cells_of,
    dialect_of,
    filled,
    is_known,
    number_of,
)
from robodyn.logs.formats import LogFormat
from robodyn.logs.recording import Groups, Recording, Stream
from robodyn.logs.windows import Rows
from robodyn.robot.names import shown

#: Largest header, and largest line of a log [bytes].
LINE = 1 << 20
#: How much is read at once [bytes].
BLOCK = 1 << 21

_COMMA, _NEWLINE = b",\n"
#: How files begin that are no text; what they are, and what to do.
_NO_TEXT = [
    (b"\xff\xfe", "the file is not UTF-8 text", "UTF-16", "save it as UTF-8"),
    (b"\xfe\xff", "the file is not UTF-8 text", "UTF-16", "save it as UTF-8"),
    (b"PAR1", "the file is not text", "Parquet", "give it the ending .parquet"),
    *(
        (mark, "the file is packed", kind, "unpack it, and give what was in it")
        for mark, kind in (
            (b"\x1f\x8b", "gzip"), (b"PK\x03\x04", "zip"), (b"BZh", "bzip2"), (b"\xfd7zXZ", "xz"),
            (b"\x28\xb5\x2f\xfd", "zstd"),
        )
    ),
]  # fmt: skip


def open_text(path: Path, file: str, gaps: bool) -> Recording:
    """The table in the text at ``path``.

    Raises
    ------
    InputError: it is not text.
    OSError: the file cannot be read.
    """
    with io.BufferedReader(open_regular(path, "a log, such as log.csv", file)) as source:
        header = tuple(_header(source, file))
        below = cells_of(source.readline(LINE + 1).decode("utf-8", "replace").rstrip("\r\n"), ",")
        source.seek(0)
        size, head = os.fstat(source.fileno()).st_size, source.read(HEAD)
    dialect = Dialect(header)
    if not any(map(is_known, header)) or are_units(below):
        dialect = dialect_of(head.decode("utf-8", "replace").removeprefix("\ufeff")) or dialect
    dialect = replace(dialect, empty=gaps)
    names, line = dialect.names, max(1, dialect.line - 1)

    def parts(stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Rows]:
        """Rows block by block; blank lines are skipped, NaN and infinity are numbers."""
        wanted = [name for group in groups.values() for name in group]
        twice = sorted(name for name in set(wanted) if names.count(name) > 1)
        if twice:
            raise InputError(
                "the log has two columns with the same name",
                where=Place(file, line),
                found=", ".join(twice[:8]),
                remedy="delete or rename all but one",
            )
        at = {name: k for k, name in enumerate(names)}
        places = [at[name] for name in wanted]
        ends = np.cumsum([len(group) for group in groups.values()])[:-1]
        with io.BufferedReader(open_regular(path, "a log, such as log.csv", file)) as source:
            for number in range(1, dialect.line):
                if len(source.readline(LINE + 1)) > LINE:
                    raise _too_long(Place(file, number))
            number, is_empty = dialect.line, True
            for block in _blocks(source, file, number):
                rows = _parse(block, places, Place(file, number), dialect)
                number += block.count(b"\n")
                is_empty = is_empty and not len(rows)
                yield dict(zip(groups, np.split(rows, ends, axis=1), strict=True))
        if is_empty:
            what, found = "the log has no samples", "the header only"
            raise InputError(what, where=Place(file), found=found, expected="a line a sample")

    stream = Stream("", "table", None, tuple(dict.fromkeys(names)), dialect.units)
    rough_rows = round(size * head.count(b"\n") / len(head)) if head else None
    return Recording(file, "text", (stream,), parts, (), names, line, dialect.named, rough_rows)


def _header(source: BinaryIO, file: str) -> list[str]:
    data = source.readline(LINE + 1)
    where = Place(file, 1)
    if not data:
        raise InputError("the file is empty", where=Place(file), expected="a log: t,q1..qn,tau1..taun")
    for mark, what, found, remedy in _NO_TEXT:
        if data.startswith(mark):
            raise InputError(what, where=Place(file), found=found, remedy=remedy)
    if b"\0" in data:
        raise InputError("the file is not text", where=where, found="a zero byte", expected="a log")
    if b"\r" in data.rstrip(b"\r\n"):
        raise InputError(
            "lines end in carriage returns alone",
            where=where,
            expected="newlines",
            remedy="write it with line ends of Unix or Windows",
        )
    if len(data) > LINE:
        raise _too_long(where)
    return cells_of(_decode(data, where).removeprefix("\ufeff").rstrip("\r\n"), ",")


def _too_long(where: Place) -> InputError:
    what, found = "the line is too long", "more than 1 MiB"
    return InputError(what, where=where, found=found, expected="a log: a line a sample")


def _decode(data: bytes, where: Place) -> str:
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        column = len(data[: error.start].decode("utf-8", "replace")) + (where.column or 1)
        found = f"byte 0x{data[error.start]:02x}"
        where = Place(where.file, where.line, column)
        what = "the file is not UTF-8 text"
        raise InputError(what, where=where, found=found, remedy="save it as UTF-8") from None


def _blocks(source: BinaryIO, file: str, line: int) -> Iterator[bytes]:
    """The rest of the file, from ``line`` on, in pieces of whole lines; the last line may lack its end."""
    rest = b""
    while piece := source.read(BLOCK):
        cut = piece.rfind(b"\n") + 1
        if cut:
            block = rest + piece[:cut]
            yield block
            line += block.count(b"\n")
            rest = piece[cut:]
        else:
            rest += piece
        if len(rest) > LINE:
            raise _too_long(Place(file, line))
    if rest:
        yield rest


def _parse(block: bytes, places: list[int], where: Place, dialect: Dialect) -> Floats:
    """The cells at ``places`` of the lines of ``block``, ``[rows, columns]``; ``where`` is its first line."""
    width = len(dialect.names)
    block = block if dialect.plain else canonical(block, dialect)
    text = block.replace(b"\r\n", b"\n") if b"\r" in block else block
    text = text if text.endswith(b"\n") else text + b"\n"
    if text.startswith(b"\n") or b"\n\n" in text:
        text = b"".join(line + b"\n" for line in text.split(b"\n") if line)
    text = filled(text) if dialect.empty else text
    marks = np.frombuffer(text, np.uint8)
    marks = marks[(marks == _COMMA) | (marks == _NEWLINE)]
    if marks.size and marks.size % width == 0:
        grid = marks.reshape(-1, width)
        if (grid[:, :-1] == _COMMA).all() and (grid[:, -1] == _NEWLINE).all():
            columns = None if places == list(range(width)) else places
            stream = io.StringIO(text.decode("ascii", "replace"))
            try:
                rows: Floats = np.loadtxt(stream, delimiter=",", comments=None, usecols=columns, ndmin=2)
                return rows
            except ValueError:
                pass  # the search below says where
    return _search(block, places, where, dialect)


def _search(block: bytes, places: list[int], where: Place, dialect: Dialect) -> Floats:
    """As :func:`_parse`, cell by cell; stops at the first that is wrong."""
    assert where.line is not None
    width, lines = len(dialect.names), block.split(b"\n")
    rows = []
    for line, data in enumerate(lines, where.line):
        if not data.strip():
            continue
        cells = data.split(b",")
        if len(cells) != width:
            remedies = [
                (line == where.line + len(lines) - 1, "the file was cut off there: delete its last line"),
                (
                    b";" in data,
                    "separate the columns by commas, not semicolons (and write decimals with a point)",
                ),
                (b'"' in data, "an extra column must not have commas in it"),
                (data.rstrip().endswith(b","), "delete the comma at the end of the line"),
            ]
            raise InputError(
                "the line has another number of cells than the header",
                where=Place(where.file, line),
                found=str(len(cells)),
                expected=str(width),
                remedy=next((text for holds, text in remedies if holds), "delete the line, or mend it"),
            )
        row = []
        for position in places:
            value = math.nan if dialect.empty and not cells[position].strip() else number_of(cells[position])
            if value is None:
                raise _wrong_cell(cells, position, Place(where.file, line))
            row.append(value)
        rows.append(row)
    return np.array(rows, dtype=np.float64).reshape(len(rows), len(places))


def _wrong_cell(cells: Sequence[bytes], position: int, line: Place) -> InputError:
    """What to say of a cell that is not a number."""
    cell = cells[position]
    text = cell.strip()
    column = sum(len(each.decode("utf-8", "replace")) + 1 for each in cells[:position]) + 1
    where = Place(line.file, line.line, column + (len(cell) - len(cell.lstrip()) if text else 0))
    remedy = "where there is no value, write nan"
    if not any(number_of(each) is not None for each in cells):
        is_quoted = text.startswith(b'"')
        remedy = "write numbers without quotes" if is_quoted else "delete the line: nothing in it is a number"
    elif not position and (b":" in cell or cell.count(b"-") > 1):
        remedy = "write times in seconds"
    return InputError(
        "the cell is not a number",
        where=where,
        found=shown(_decode(text, where)) if text else "nothing",
        expected="a number such as -0.125 or 1e-3",
        remedy=remedy,
    )


FORMAT = LogFormat("text", (".csv", ".txt", ".tsv"), "text", open_text, is_guarded=False, is_table=True)
