"""A file as its format has it: streams of rows with named columns of numbers. What they mean, a map says."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs import windows
from robodyn.logs.windows import Rows, length_of
from robodyn.robot.names import shown

#: Largest log [numbers in the columns that are read]: 2 GiB of doubles, more than any simulation writes.
LARGEST = 1 << 28
#: The column of a stream that has the times at which its rows were recorded.
RECEIVED = "received"
#: Beside groups of columns: the stamps of their rows.
STAMPS = "stamps"
#: What stands between the name of a stream and that of its column.
BETWEEN = ":"


@dataclass(frozen=True, slots=True)
class Stream:
    """Rows of the same ``columns``: a table, a topic, arrays of one length. ``rows``: how many, None if that
    is not known without reading; ``kind``: what it is called in its format. ``units``: what the file says of
    columns. ``stamps``: columns of whole nanoseconds, the first of them the times of the rows."""

    name: str
    kind: str
    rows: int | None
    columns: tuple[str, ...]
    units: Mapping[str, str] = field(default_factory=dict)
    stamps: tuple[str, ...] = ()

    def full(self, column: str) -> str:
        """``column`` with the name of the stream."""
        return f"{self.name}{BETWEEN}{column}" if self.name else column


@dataclass(frozen=True, slots=True)
class Table:
    """What was read of a stream: ``groups`` of columns [K, m]; ``stamps`` [K] in ns, if it has any;
    ``skipped`` rows that lack some of the columns."""

    groups: Mapping[str, Floats]
    stamps: NDArray[np.int64] | None = None
    skipped: int = 0

    @property
    def rows(self) -> int:
        """How many were read."""
        return len(next(iter(self.groups.values())))


#: Columns by group.
Groups = Mapping[str, Sequence[str]]
#: Reads groups of columns of a stream, and one of its stamps, as they stand in the file, some rows at a time:
#: the groups [k, m], :data:`STAMPS` [k] in ns of a stream that has stamps, and :data:`RECEIVED` [k] where the
#: rows may be out of their order.
Parts = Callable[[Stream, Groups, str | None], Iterator[Rows]]


@dataclass(frozen=True, slots=True, eq=False)
class Recording:
    """A file that has been looked into: ``file`` is what messages call it, ``parts`` reads its streams,
    ``notes`` are on its state. Of a table: the ``names`` of all its columns as they stand there, on which
    ``line``, whether the file names them itself (``named``), and about how many rows it has."""

    file: str
    format: str
    streams: tuple[Stream, ...]
    parts: Parts
    notes: tuple[str, ...] = ()
    names: tuple[str, ...] = ()
    line: int | None = None
    named: bool = True
    rough_rows: int | None = None

    def read(self, stream: Stream, groups: Groups, stamp: str | None) -> Table:
        """Columns of ``stream``, group by group; ``stamp``: which of its stamps to read.

        Raises
        ------
        InputError: the file is damaged, or too long.
        """
        width = sum(map(len, groups.values()))
        most = LARGEST // max(1, width)
        too_long = InputError(
            "the log is too long",
            where=Place(self.file),
            found=f"more than {most} samples of {width} columns",
            expected=f"at most {LARGEST} numbers",
            remedy="take a part of it, or fewer samples a second",
        )
        arrays: dict[str, NDArray[Any]] = {}
        count = 0
        if stream.rows is not None and stream.rows > most:
            raise too_long
        for rows in self.parts(stream, groups, stamp):
            start, count = count, count + length_of(rows)
            if count > most:
                raise too_long
            for name, part in rows.items():
                array = arrays.setdefault(name, np.empty((stream.rows or 0, *part.shape[1:]), part.dtype))
                if count > len(array):
                    room = min(max(count, 5 * len(array) // 4), most)
                    array.resize((room, *part.shape[1:]), refcheck=False)
                array[start:count] = part
        for array in arrays.values():
            array.resize((count, *array.shape[1:]), refcheck=False)
        received = arrays.pop(RECEIVED, None)
        if received is not None and (np.diff(received) < 0).any():  # several writers: as they were recorded
            order = np.argsort(received, kind="stable")
            arrays = {name: array[order] for name, array in arrays.items()}
        return _table(arrays, 0 if stream.rows is None else stream.rows - count)

    def blocks(self, stream: Stream, groups: Groups, stamp: str | None) -> Iterator[Table]:
        """As :meth:`read`, in order, block by block, however long the file is: none of them is large, and
        any may be empty.

        Raises
        ------
        InputError: the file is damaged, or its rows are too far out of order.
        """
        left = stream.rows or 0
        parts = self.parts(stream, groups, stamp)
        if stream.stamps:
            parts = windows.in_order(parts, RECEIVED, windows.WINDOW, self.file)
        for rows in parts:
            left -= length_of(rows)
            yield _table(rows, 0)
        if stream.rows is not None and left:
            nothing: Rows = {group: np.empty((0, len(names))) for group, names in groups.items()}
            yield _table({**nothing, STAMPS: np.empty(0, np.int64)}, left)


def _table(rows: Rows, skipped: int) -> Table:
    groups = {name: part for name, part in rows.items() if name not in (RECEIVED, STAMPS)}
    return Table(groups, rows.get(STAMPS), skipped)


def candidates(recording: Recording, name: str, topic: str) -> list[tuple[Stream, str]]:
    """All columns that ``name`` may mean."""
    fits = []
    for stream in recording.streams:
        column = name
        if stream.name and name.startswith(stream.name + BETWEEN):
            column = name[len(stream.name) + 1 :]
        elif topic and stream.name != topic:
            continue
        if column in stream.columns or column in stream.stamps:
            fits.append((stream, column))
    return fits


def find(recording: Recording, name: str, topic: str, where: Place) -> tuple[Stream, str]:
    """The stream that has the column ``name``, and how the column is called there.

    ``name`` may have its stream before it; one that it lacks is ``topic``, or the only one that has such a
    column.

    Raises
    ------
    InputError: there is none, or there are several.
    """
    fits = candidates(recording, name, topic)
    if len(fits) == 1:
        return fits[0]
    if fits:
        raise InputError(
            "several streams have such a column",
            where=where,
            found=", ".join(shown(stream.full(column)) for stream, column in fits[:6]),
            expected="one",
            remedy="write the stream before it: " + fits[0][0].full(fits[0][1]),
        )
    listed = [stream.full(column) for stream in recording.streams for column in stream.columns]
    close = difflib.get_close_matches(name, listed, n=4, cutoff=0.5) or listed[:6]
    raise InputError(
        "the file has no such column",
        where=where,
        found=shown(name),
        expected=", ".join(map(shown, close)) + (", ..." if len(listed) > len(close) else ""),
        remedy=f"robodyn logs {recording.file} lists what there is",
    )


def damaged(file: str, kind: str, reason: object, remedy: str | None = None) -> InputError:
    """What to say of a file that is not what its name says."""
    text = " ".join(str(reason).split())[:200] or type(reason).__name__
    text = text if text.isprintable() else ascii(text)[1:-1]
    return InputError(
        f"the file is not {kind}, or damaged", where=Place(file), found=text.rstrip("."), remedy=remedy
    )
