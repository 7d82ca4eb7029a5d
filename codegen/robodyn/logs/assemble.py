"""The arrays of a log out of a recording and a map: columns found, brought to one time, to SI units.

They come block by block, in memory that does not grow with the log's length, or whole. Where streams have
times of their own, they are gone through before: for where they begin and end, and whether they are of the
same samples. The step between the times of a stream is the median of its first
:data:`~robodyn.logs.windows.WINDOW` rows, and rows that are late by more are refused; read whole, a log has
a window that takes all of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError, Place
from robodyn.logs.limits import SAME_TIME
from robodyn.logs.mapping import LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.streams import Clock, Mean, Part, Sources, TimedPart, means_apart, readings_of, sources_of
from robodyn.logs.units import convert
from robodyn.logs.windows import Interpolation, Rows, cut, of_length
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class Block:
    """Some ``rows`` of a log in SI units: the times ``t`` [K], groups [K, n], and readings [K, m] of
    conditions, called :data:`~robodyn.logs.streams.CONDITION` and their name. ``notes`` on what was left out
    or brought to one time; ``began``: when t = 0 was [s since 1970, UTC], None where times are no dates;
    means of conditions in streams ``apart`` from the positions'; columns of the file that are ``ignored``."""

    rows: Rows
    notes: tuple[str, ...] = ()
    began: float | None = None
    apart: Mapping[str, Mean] = field(default_factory=dict)
    ignored: tuple[str, ...] = ()


def assemble(
    recording: Recording, mapping: LogMap, n: int | None, robot: Robot | None, *, whole: bool
) -> Iterator[Block]:
    """The log ``recording``, block by block, or as one if ``whole``; ``n`` joints, None: as many as q has
    columns. A block may have no rows, but notes.

    Columns that are recorded at other times than q are interpolated at the times of q.

    Raises
    ------
    InputError: columns are missing or not to be told apart, units are unknown, files damaged, or, once what
        is wrong is reached, rows too far out of order.
    """
    sources = sources_of(recording, mapping, n)
    first, *others = (
        TimedPart(part, mapping, first=not k, whole=whole) for k, part in enumerate(sources.parts)
    )
    beside = _Beside(first, others, recording.file)
    clock = Clock(first)
    notes = [*recording.notes, *beside.notes]
    apart = means_apart(sources)
    count = 0
    for t, table in clock.tables():
        notes += first.note(table.skipped, count + table.rows)
        groups = _groups(sources, table.groups, table.rows)
        for part, columns in beside.columns(t):
            start = 0
            for group in part.wanted:
                joints = part.joints(group)
                groups[group][:, joints] = columns[:, start : start + len(joints)]
                start += len(joints)
        for group, source in (pair for part in sources.parts for pair in part.columns):
            if group in groups:
                stated = source.stream.units.get(source.column, "")
                column = groups[group][:, source.joint]
                convert(column, sources.channels[group], group, source.joint, stated, robot)
        rows = {"t": t, **groups, **readings_of(first.part, table.groups, mapping)}
        start, end = beside.common
        inside = cut(rows, max(start - count, 0), max(min(end - count, len(t)), 0))
        yield Block(inside, tuple(notes), clock.began, apart)
        notes, apart = [], {}
        count += table.rows


def _groups(sources: Sources, tables: Mapping[str, Floats], rows: int) -> dict[str, Floats]:
    """The groups [rows, n] with the columns of the first part; all others are NaN."""
    groups: dict[str, Floats] = {}
    for group in sources.channels:
        joints = sources.parts[0].joints(group)
        if joints == list(range(sources.n)):
            groups[group] = tables[group]
            continue
        groups[group] = np.full((rows, sources.n), np.nan)
        if joints:
            groups[group][:, joints] = tables[group]
    return groups


class _Beside:
    """The parts of a log beside the ``first``; ``common``: from which row of the first to before which all
    have rows."""

    def __init__(self, first: TimedPart, others: Sequence[TimedPart], file: str) -> None:
        self._readers: list[tuple[Part, _Aligned | Interpolation]] = []
        self.common = 0, 1 << 62
        self.notes: list[str] = []
        if not others:
            return
        own = _Survey(first, None)
        low, high = -np.inf, np.inf
        for other in others:
            part, survey = other.part, _Survey(other, own.clock.origin or 0)
            self.notes += other.note(survey.skipped, survey.rows)
            reader: _Aligned | Interpolation
            if not other.is_timed and survey.rows != own.rows:
                raise InputError(
                    "the rows of a second file have no times, and are not as many",
                    where=Place(part.recording.file),
                    found=str(survey.rows),
                    expected=str(own.rows),
                    remedy="it needs the column of times that the map says",
                )
            if not other.is_timed or (survey.rows == own.rows and _are_same(first, other, own)):
                reader = _Aligned(other)
            else:
                low, high = max(low, survey.first), min(high, survey.last)
                rate = 1 / max(survey.step, 1e-12)
                self.notes.append(f"{part.name}: {rate:.4g} Hz, interpolated at q's times")
                columns = _timed_columns(other, own.clock.origin or 0)
                reader = Interpolation(columns, survey.rising_step, len(part.columns), other.window, file)
            self._readers.append((part, reader))
        if np.isfinite(low) or np.isfinite(high):
            self.common = _common(first, low, high)
            if self.common[1] <= self.common[0]:
                raise InputError(
                    "the streams have no time in common",
                    where=Place(file),
                    found=f"{own.first:.6g} to {own.last:.6g} s, and {low:.6g} to {high:.6g} s",
                    expected="recordings of the same time",
                )

    def columns(self, t: Floats) -> Iterator[tuple[Part, Floats]]:
        """The columns [k, m] of each part at the next rows, whose times are ``t`` [k]."""
        for part, reader in self._readers:
            yield part, reader.at(t)


def _timed_columns(part: TimedPart, origin: int) -> Iterator[Rows]:
    """The columns of a part with their times, by a clock of that ``origin``."""
    for times, table in Clock(part, origin).tables():
        yield {"times": times, "columns": part.part.stacked(table.groups)}


class _Aligned:
    """The columns of a part that has the same samples as the first."""

    def __init__(self, part: TimedPart) -> None:
        self._blocks = (part.part.stacked(table.groups) for table in part.tables())
        self._waiting = np.empty((0, len(part.part.columns)))

    def at(self, t: Floats) -> Floats:
        """The next rows, as many as ``t`` has."""
        waiting = [self._waiting]
        count = len(self._waiting)
        while count < len(t) and (block := next(self._blocks, None)) is not None:
            waiting.append(block)
            count += len(block)
        columns = np.concatenate(waiting)
        self._waiting = columns[len(t) :]
        return columns[: len(t)]


class _Survey:
    """What the times of a ``part`` are like: how many ``rows``, the ``first`` time and the ``last`` one [s],
    the median ``step`` between those at its beginning as they stand, and as they rise; the ``clock`` that
    they went by."""

    def __init__(self, part: TimedPart, origin: int | None) -> None:
        self.clock = Clock(part, origin)
        self.rows = self.skipped = 0
        self.first = self.last = np.nan
        beginning = [np.empty(0)]
        for times, table in self.clock.tables():
            if len(times):
                self.first = self.first if self.rows else float(times[0])
                self.last = float(times[-1])
                if self.rows < part.window:
                    beginning.append(times[: part.window - self.rows])
            self.rows += table.rows
            self.skipped += table.skipped
        times = np.concatenate(beginning)
        self.step = _median(np.diff(times))
        self.rising_step = _median(np.diff(np.sort(times[np.isfinite(times)])))


def _median(steps: Floats) -> float:
    """The median of some ``steps`` between times; 1 of none."""
    return float(np.median(steps)) if len(steps) else 1.0


def _are_same(first: TimedPart, other: TimedPart, survey: _Survey) -> bool:
    """Whether two parts of as many rows have the same samples."""
    clocks = Clock(first), Clock(other, survey.clock.origin or 0)
    passes = (of_length(({"t": t} for t, _ in clock.tables()), first.window) for clock in clocks)
    near = SAME_TIME * abs(survey.step)
    return all((np.abs(b["t"] - a["t"]) <= near).all() for a, b in zip(*passes, strict=True))


def _common(first: TimedPart, low: float, high: float) -> tuple[int, int]:
    """The first row, and the one behind the last, of a time from ``low`` to ``high``."""
    start, end, count = 0, 0, 0
    for t, _ in Clock(first).tables():
        inside = np.flatnonzero((t >= low) & (t <= high))
        if len(inside):
            start = start if end else count + int(inside[0])
            end = count + int(inside[-1]) + 1
        count += len(t)
    return start, end
