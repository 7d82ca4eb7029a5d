"""The streams that a log's columns are in, and the times of their rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.conditions import Mean, condition_sources, mean_of, readings_in
from robodyn.logs.conversion import date_of, of_stamps, seconds
from robodyn.logs.limits import EARLIEST, LATEST
from robodyn.logs.mapping import GROUPS, Channel, LogMap
from robodyn.logs.recording import Recording, Stream, Table
from robodyn.logs.resolve import Source, channel_of, joints_of, sources, stamp_of

Floats = NDArray[np.float64]
Opener = Callable[[str], Recording]

#: What stands before the name of a condition where columns are listed by groups.
CONDITION = "condition "


@dataclass(frozen=True, slots=True)
class Part:
    """Columns of one stream of one file, with their groups."""

    recording: Recording
    stream: Stream
    columns: list[tuple[str, Source]]

    @property
    def name(self) -> str:
        """What notes call it."""
        return self.stream.name or self.recording.file

    @property
    def groups(self) -> tuple[str, ...]:
        """The groups of its columns, in their order."""
        return tuple(dict.fromkeys(group for group, _ in self.columns))

    @property
    def wanted(self) -> dict[str, list[str]]:
        """Names of its columns by group."""
        names: dict[str, list[str]] = {}
        for group, source in self.columns:
            names.setdefault(group, []).append(source.column)
        return names

    def stacked(self, tables: Mapping[str, Floats]) -> Floats:
        """The columns of its ``tables`` beside each other, group by group."""
        return np.column_stack([tables[group] for group in self.groups])

    def joints(self, group: str) -> list[int]:
        """The joints (from 0) of its columns of ``group``."""
        return [source.joint for name, source in self.columns if name == group]


@dataclass(frozen=True, slots=True)
class Sources:
    """Where the columns of a log of ``n`` joints are: ``channels`` by group; ``parts``, first that of the
    first joint's position; ``apart``: conditions in other streams than that."""

    mapping: LogMap
    n: int
    channels: Mapping[str, Channel]
    parts: Sequence[Part]
    apart: Sequence[Part]


def sources_of(recording: Recording, mapping: LogMap, n: int | None, opener: Opener) -> Sources:
    """Where ``mapping`` has the columns; ``n`` joints, None: as many as q has columns.

    Raises
    ------
    InputError: columns are missing or not to be told apart.
    """
    n = joints_of(recording, mapping) if n is None else n
    channels = {
        group: channel_of(recording, mapping, group)
        for group in GROUPS
        if group != "t" and (group in mapping.groups or group in ("q", "tau"))
    }
    parts: list[Part] = []
    for group, channel in channels.items():
        source = recording
        if channel.file:
            stem = str(Path(recording.file).with_suffix(""))
            source = opener(channel.file.replace("%s", stem))
        for one in sources(source, mapping, group, channel, n):
            _add(parts, source, group, one)
    conditions: list[Part] = []
    for name, channel in mapping.conditions.items():
        for one in condition_sources(recording, mapping, name, channel, n):
            _add([parts[0], *conditions], recording, CONDITION + name, one, conditions)
    return Sources(mapping, n, channels, parts, conditions)


def _add(
    parts: list[Part], recording: Recording, group: str, source: Source, new: list[Part] | None = None
) -> None:
    """Put a column to the one of ``parts`` that it is of, else to a ``new`` one."""
    for part in parts:
        if part.recording.file == recording.file and part.stream.name == source.stream.name:
            part.columns.append((group, source))
            return
    (parts if new is None else new).append(Part(recording, source.stream, [(group, source)]))


class TimedPart:
    """A part of a log whose rows have times: a column's, stamps, those of an even rate; or none, where it is
    not the first and has as many rows.

    Raises
    ------
    InputError: the times are not to be found.
    """

    def __init__(self, part: Part, mapping: LogMap, *, first: bool) -> None:
        self.part = part
        channel = mapping.groups.get("t")
        self._where = Place(part.recording.file) if channel is None else channel.place
        self._stamp = stamp_of(channel, part.stream, self._where)
        self._column: Source | None = None
        self._rate = None if channel is None or self._stamp is not None else channel.rate
        self._wanted = part.wanted
        if self._stamp is None and self._rate is None:
            self._column = _times(part, mapping, optional=not first)
            if self._column is not None:
                self._wanted["t"] = [self._column.column]
                self._channel = channel or Channel((self._column.column,), self._where)
                self._stated = part.stream.units.get(self._column.column, "")

    @property
    def timed(self) -> bool:
        """Whether its rows have times of their own."""
        return self._stamp is not None or self._rate is not None or self._column is not None

    def read(self) -> Table:
        """All of its rows.

        Raises
        ------
        InputError: the file is damaged, too long, or there are none.
        """
        table = self.part.recording.read(self.part.stream, self._wanted, self._stamp)
        if not table.rows:
            raise self._empty()
        return table

    def blocks(self) -> Iterator[Table]:
        """The same block by block."""
        empty = True
        for table in self.part.recording.blocks(self.part.stream, self._wanted, self._stamp):
            empty = empty and not table.rows
            yield table
        if empty:
            raise self._empty()

    def clock(self, origin: int | None = None) -> Clock:
        """What makes seconds of its times; ``origin`` [ns]: of stamps, the first one's where it is None."""
        return Clock(self, origin)

    def note(self, skipped: int, rows: int) -> list[str]:
        """What to say of ``skipped`` rows beside ``rows`` that were read."""
        if not skipped:
            return []
        return [f"{self.part.name}: {skipped} of {skipped + rows} rows lack these columns, left out"]

    def _empty(self) -> InputError:
        return InputError(
            "the log has no samples", where=Place(self.part.recording.file), expected="a row a sample"
        )


class Clock:
    """Makes seconds of the times of a ``part``, whose tables it sees in their order. ``origin`` [ns] is that
    of stamps; ``began``: when its seconds are 0 [s since 1970, UTC], None where times are no dates."""

    def __init__(self, part: TimedPart, origin: int | None) -> None:
        self._part, self.origin = part, origin
        self._first: float | None = None  # reading of a column that dates count from
        self._rows = 0

    def seconds(self, table: Table) -> Floats:
        """Times [k] of the rows of ``table``; none where the part has none."""
        part = self._part
        count = table.rows
        self._rows += count
        if table.stamps is not None and part._stamp is not None:
            if self.origin is None and count:
                self.origin = int(table.stamps[0])
            return of_stamps(table.stamps, self.origin or 0)
        if part._column is not None:
            t = np.array(table.groups["t"][:, 0])
            self._first = seconds(t, part._channel, part._stated, self._first)
            return t
        if part._rate is not None:
            return _even(self._rows - count, count, part._rate)
        return np.empty(0)

    @property
    def began(self) -> float | None:
        part, began = self._part, 0.0
        if part._stamp is not None:
            began = (self.origin or 0) / 1e9
        elif part._column is not None:
            began = date_of(self._first or 0.0, part._channel, part._stated)
        return began if EARLIEST <= began < LATEST else None


def readings_of(part: Part, tables: Mapping[str, Floats], mapping: LogMap) -> dict[str, Floats]:
    """The readings [k, m] of conditions in the ``tables`` of a ``part``, by name."""
    return {
        group.removeprefix(CONDITION): readings_in(
            columns,
            mapping.conditions[group.removeprefix(CONDITION)],
            [source for own, source in part.columns if own == group],
        )
        for group, columns in tables.items()
        if group.startswith(CONDITION)
    }


def conditions_apart(sources: Sources) -> dict[str, Mean]:
    """The means of conditions in other streams than the positions: over all of their rows."""
    means: dict[str, Mean] = {}
    for part in sources.apart:
        stamp = part.stream.stamps[0] if part.stream.stamps else None
        for table in part.recording.blocks(part.stream, part.wanted, stamp):
            for name, readings in readings_of(part, table.groups, sources.mapping).items():
                means[name] = means.get(name, Mean()) + mean_of(readings)
    return means


def _times(part: Part, mapping: LogMap, *, optional: bool) -> Source | None:
    """The column with the times of ``part``; None if it is ``optional`` and not there."""
    narrowed = LogMap(mapping.groups, mapping.joints, part.stream.name or mapping.topic)
    try:
        channel = channel_of(part.recording, narrowed, "t")
        source = sources(part.recording, narrowed, "t", channel, 1)[0]
    except InputError:
        if optional:
            return None
        raise
    if source.stream.name != part.stream.name:
        if optional:
            return None
        raise InputError(
            "times and positions are of different streams",
            where=channel.place,
            found=f"{source.stream.full(source.column)}, and {part.stream.full(part.columns[0][1].column)}",
            expected="a column of times beside the positions",
        )
    return source


def _even(first: int, rows: int, rate: Fraction) -> Floats:
    """Times of so many ``rows`` from the ``first`` (from 0) on at an even ``rate`` [Hz]."""
    k = np.arange(first, first + rows, dtype=np.float64)
    if rate.denominator == 1:
        return k / float(rate)
    return k * float(1 / rate)
