"""The streams that a log's columns are in, the times of their rows, and the conditions that they tell."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs import windows
from robodyn.logs.formats import open_recording
from robodyn.logs.limits import EARLIEST, LATEST
from robodyn.logs.mapping import GROUPS, Channel, LogMap
from robodyn.logs.recording import Recording, Stream, Table
from robodyn.logs.resolve import Source, channel_of, joints_of, sources, stamp_of
from robodyn.logs.units import date_of, of_stamps, seconds
from robodyn.robot.names import shown

#: What stands before the name of a condition where columns are listed by groups.
CONDITION = "condition "
#: Temperatures, which become degC: by what a reading is multiplied, and what is added then.
_TEMPERATURES: Final = {
    "degC": (1.0, 0.0), "C": (1.0, 0.0), "°C": (1.0, 0.0), "K": (1.0, -273.15),
    "degF": (5 / 9, -160 / 9), "°F": (5 / 9, -160 / 9),
}  # fmt: skip
#: What names a column a joint.
_PATTERN: Final = re.compile(r"%(0[1-9])?d|%s|[0-9]\.\.")


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
    def wanted(self) -> dict[str, list[str]]:
        """Names of its columns by group."""
        names: dict[str, list[str]] = {}
        for group, source in self.columns:
            names.setdefault(group, []).append(source.column)
        return names

    def stacked(self, tables: Mapping[str, Floats]) -> Floats:
        """The columns of its ``tables`` beside each other, group by group."""
        return np.column_stack([tables[group] for group in self.wanted])

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


def sources_of(recording: Recording, mapping: LogMap, n: int | None) -> Sources:
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
    apart: list[Part] = []

    def add(source: Recording, group: str, column: Source, known: list[Part], new: list[Part]) -> None:
        """Put a ``column`` to that of the ``known`` parts which it is of, else to a ``new`` one."""
        for part in known:
            if part.recording.file == source.file and part.stream.name == column.stream.name:
                part.columns.append((group, column))
                return
        new.append(Part(source, column.stream, [(group, column)]))

    for group, channel in channels.items():
        source = recording
        if channel.file:
            source = open_recording(channel.file.replace("%s", str(Path(recording.file).with_suffix(""))))
        for column in sources(source, mapping, group, channel, n):
            add(source, group, column, parts, parts)
    for name, channel in mapping.conditions.items():
        is_one_a_joint = len(channel.columns) == 1 and _PATTERN.search(channel.columns[0])
        count = n if is_one_a_joint else len(channel.columns)
        for column in sources(recording, mapping, name, channel, count):
            add(recording, CONDITION + name, column, [parts[0], *apart], apart)
    return Sources(mapping, n, channels, parts, apart)


# --- times ------------------------------------------------------------------------------------------------


class TimedPart:
    """A part of a log whose rows have times: a column's, stamps, those of an even rate; or none, where it is
    not the first and has as many rows. It is read block by block, or ``whole`` and once.

    Raises
    ------
    InputError: the times are not to be found.
    """

    def __init__(self, part: Part, mapping: LogMap, *, first: bool, whole: bool) -> None:
        self.part = part
        self.window = sys.maxsize if whole else windows.WINDOW
        self._table: Table | None = None
        channel = mapping.groups.get("t")
        where = Place(part.recording.file) if channel is None else channel.place
        self.stamp = stamp_of(channel, part.stream, where)
        self.rate = None if channel is None or self.stamp is not None else channel.rate
        self.column: Source | None = None
        self._wanted = part.wanted
        if self.stamp is None and self.rate is None:
            self.column = _times(part, mapping, optional=not first)
            if self.column is not None:
                self._wanted["t"] = [self.column.column]
                self.channel = channel or Channel((self.column.column,), where)
                self.unit = part.stream.units.get(self.column.column, "")

    @property
    def is_timed(self) -> bool:
        """Whether its rows have times of their own."""
        return self.stamp is not None or self.rate is not None or self.column is not None

    def tables(self) -> Iterator[Table]:
        """All of its rows, in one table if it is read whole.

        Raises
        ------
        InputError: the file is damaged, too long, or there are no rows.
        """
        recording, stream = self.part.recording, self.part.stream
        if self.window == sys.maxsize and self._table is None:
            self._table = recording.read(stream, self._wanted, self.stamp)
        is_empty = True
        tables = [self._table] if self._table else recording.blocks(stream, self._wanted, self.stamp)
        for table in tables:
            is_empty = is_empty and not table.rows
            if not is_empty:
                yield table
        if is_empty:
            raise InputError("the log has no samples", where=Place(recording.file), expected="a row a sample")

    def note(self, skipped: int, rows: int) -> list[str]:
        """What to say of ``skipped`` rows beside ``rows`` that were read."""
        if not skipped:
            return []
        return [f"{self.part.name}: {skipped} of {skipped + rows} rows lack these columns, left out"]


class Clock:
    """Makes seconds of the times of a ``part``, in one pass over its tables. ``origin`` [ns] is that of
    stamps, the first one's where it is None."""

    def __init__(self, part: TimedPart, origin: int | None = None) -> None:
        self._part, self.origin = part, origin
        self._first: float | None = None  # reading of a column that dates count from

    def tables(self) -> Iterator[tuple[Floats, Table]]:
        """The tables of the part, and the times [k] of their rows; none where it has none."""
        part, count = self._part, 0
        for table in part.tables():
            t = np.empty(0)
            if table.stamps is not None and part.stamp is not None:
                if self.origin is None and table.rows:
                    self.origin = int(table.stamps[0])
                t = of_stamps(table.stamps, self.origin or 0)
            elif part.column is not None:
                t = np.array(table.groups["t"][:, 0])
                self._first = seconds(t, part.channel, part.unit, self._first)
            elif part.rate is not None:
                k = np.arange(count, count + table.rows, dtype=np.float64)
                t = k / float(part.rate) if part.rate.denominator == 1 else k * float(1 / part.rate)
            count += table.rows
            yield t, table

    @property
    def began(self) -> float | None:
        """When its seconds are 0 [s since 1970, UTC]; None where times are no dates."""
        part, began = self._part, 0.0
        if part.stamp is not None:
            began = (self.origin or 0) / 1e9
        elif part.column is not None:
            began = date_of(self._first or 0.0, part.channel, part.unit)
        return began if EARLIEST <= began < LATEST else None


def _times(part: Part, mapping: LogMap, *, optional: bool) -> Source | None:
    """The column with the times of ``part``; None if it is ``optional`` and not there."""
    narrowed = LogMap(mapping.groups, mapping.joints, part.stream.name or mapping.topic)
    try:
        channel = channel_of(part.recording, narrowed, "t")
        source = sources(part.recording, narrowed, "t", channel, 1)[0]
        if source.stream.name != part.stream.name:
            times, position = source.stream.full(source.column), part.columns[0][1].column
            raise InputError(
                "times and positions are of different streams",
                where=channel.place,
                found=f"{times}, and {part.stream.full(position)}",
                expected="a column of times beside the positions",
            )
    except InputError:
        if optional:
            return None
        raise
    return source


# --- conditions -------------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Mean:
    """A mean that can be taken piece by piece: the ``total`` of ``count`` finite readings."""

    total: float = 0.0
    count: int = 0

    @property
    def value(self) -> float:
        """The mean; NaN of no readings."""
        return self.total / self.count if self.count else math.nan

    def __add__(self, other: Mean) -> Mean:
        return Mean(self.total + other.total, self.count + other.count)


def together(pieces: Iterable[Mapping[str, Mean]]) -> dict[str, Mean]:
    """The means of a whole log from those of its ``pieces``."""
    means: dict[str, Mean] = {}
    for piece in pieces:
        for name, mean in piece.items():
            means[name] = means[name] + mean if name in means else mean
    return means


def mean_of(readings: Floats) -> Mean:
    """The mean of ``readings`` [K, m]."""
    finite = readings[np.isfinite(readings)]
    return Mean(float(np.sum(finite)), len(finite))


def readings_of(part: Part, tables: Mapping[str, Floats], mapping: LogMap) -> dict[str, Floats]:
    """The readings [k, m] of conditions in the ``tables`` of a ``part``, by :data:`CONDITION` and name:
    temperatures in degC, all else as it is logged.

    Raises
    ------
    InputError: the map names a unit that is not known.
    """
    readings = {}
    for group in (name for name in tables if name.startswith(CONDITION)):
        channel = mapping.conditions[group.removeprefix(CONDITION)]
        if channel.unit and channel.unit not in _TEMPERATURES:
            raise InputError(
                "the unit of a condition is unknown",
                where=channel.place,
                found=shown(channel.unit),
                expected="degC, degF or K",
                remedy="leave the unit out: all but temperatures counts as it is logged",
            )
        units = [s.stream.units.get(s.column, "") for own, s in part.columns if own == group]
        scales = [_TEMPERATURES.get(channel.unit or unit, (1.0, 0.0)) for unit in units]
        factor, offset = np.array(scales).T
        readings[group] = tables[group] * factor + offset
    return readings


def means_apart(sources: Sources) -> dict[str, Mean]:
    """The means of conditions in other streams than the positions: over all of their rows."""
    means: dict[str, Mean] = {}
    for part in sources.apart:
        stamp = part.stream.stamps[0] if part.stream.stamps else None
        for table in part.recording.blocks(part.stream, part.wanted, stamp):
            for group, readings in readings_of(part, table.groups, sources.mapping).items():
                name = group.removeprefix(CONDITION)
                means[name] = means.get(name, Mean()) + mean_of(readings)
    return means
