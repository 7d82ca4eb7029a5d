"""The arrays of a log, piece by piece, in memory that does not grow with its length.

What is done with rows is what :mod:`~robodyn.logs.assemble` does with all of them. Where streams have times
of their own, they are gone through before: for where they begin and end, and whether they are of the same
samples. What is usual between the times of a stream is taken from its first
:data:`~robodyn.logs.windows.WINDOW` rows, where ``assemble`` has all of them; rows that are late by more are
refused.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.logs import windows
from robodyn.logs.assemble import (
    Arrays,
    are_same,
    check_count,
    groups_of,
    median,
    nothing_common,
    put,
    rate_note,
    timed_parts,
    to_si,
)
from robodyn.logs.conditions import Mean
from robodyn.logs.mapping import LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.streams import Clock, Opener, Part, TimedPart, conditions_apart, readings_of, sources_of
from robodyn.logs.windows import Interpolation, Rows, of_length
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


def assemble_pieces(
    recording: Recording, mapping: LogMap, n: int | None, robot: Robot | None, opener: Opener
) -> Iterator[Arrays]:
    """As :func:`~robodyn.logs.assemble.assemble`, block by block; a block may have no rows, but notes.

    Raises
    ------
    InputError: as there, once what is wrong is reached; rows are too far out of order.
    """
    sources = sources_of(recording, mapping, n, opener)
    first, *others = timed_parts(sources)
    beside = _Beside(first, others, recording.file)
    clock = first.clock()
    notes = [*recording.notes, *beside.notes]
    apart: Mapping[str, Mean] = conditions_apart(sources)
    arrays: Arrays | None = None
    count = skipped = 0
    for table in first.blocks():
        t = clock.seconds(table)
        skipped += table.skipped
        groups = groups_of(sources, table.groups, table.rows)
        for part, columns in beside.columns(t):
            put(groups, part, columns)
        to_si(groups, sources, robot)
        readings = readings_of(first.part, table.groups, mapping)
        arrays = Arrays(t, groups, tuple(notes), clock.began, readings, apart)
        yield arrays.part(beside.inside(count, count + table.rows))
        notes, apart = [], {}
        count += table.rows
    if skipped and arrays is not None:
        yield replace(arrays.part(slice(0, 0)), notes=tuple(first.note(skipped, count)), apart={})


class _Beside:
    """The parts of a log beside the ``first``."""

    def __init__(self, first: TimedPart, others: Sequence[TimedPart], file: str) -> None:
        self._readers: list[tuple[Part, _Aligned | Interpolation]] = []
        self._first, self._end = 0, None  # type: int, int | None
        self.notes: list[str] = []
        if not others:
            return
        own = _Survey(first, None)
        low, high = -np.inf, np.inf
        for other in others:
            survey = _Survey(other, own.clock.origin or 0)
            self.notes += other.note(survey.skipped, survey.rows)
            reader: _Aligned | Interpolation
            if not other.timed:
                check_count(other, survey.rows, own.rows)
                reader = _Aligned(other)
            elif survey.rows == own.rows and _are_same(first, other, own):
                reader = _Aligned(other)
            else:
                low, high = max(low, survey.first), min(high, survey.last)
                self.notes.append(rate_note(other, survey.step))
                reader = Interpolation(
                    _timed_columns(other, own), survey.rising_step, len(other.part.columns), file
                )
            self._readers.append((other.part, reader))
        if np.isfinite(low) or np.isfinite(high):
            self._first, self._end = _common(first, low, high)
            if self._end <= self._first:
                raise nothing_common(file, own.first, own.last, low, high)

    def columns(self, t: Floats) -> Iterator[tuple[Part, Floats]]:
        """The columns [k, m] of each part at the next rows, whose times are ``t`` [k]."""
        for part, reader in self._readers:
            yield part, reader.at(t)

    def inside(self, start: int, end: int) -> slice:
        """Which of the rows from ``start`` to ``end`` lie where all parts have rows."""
        last = end if self._end is None else min(end, self._end)
        return slice(max(self._first - start, 0), max(last - start, 0))


class _Aligned:
    """The columns of a part that has the same samples as the first."""

    def __init__(self, part: TimedPart) -> None:
        self._blocks = (part.part.stacked(table.groups) for table in part.blocks())
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
    the usual ``step`` between those at its beginning as they stand, and as they rise; the ``clock`` that
    they went by."""

    def __init__(self, part: TimedPart, origin: int | None) -> None:
        self.clock = part.clock(origin)
        self.rows = self.skipped = 0
        self.first = self.last = np.nan
        beginning: list[Floats] = []
        for table in part.blocks():
            times = self.clock.seconds(table)
            if len(times):
                self.first = self.first if self.rows else float(times[0])
                self.last = float(times[-1])
                if self.rows < windows.WINDOW:
                    beginning.append(times[: windows.WINDOW - self.rows])
            self.rows += table.rows
            self.skipped += table.skipped
        times = np.concatenate(beginning) if beginning else np.empty(0)
        self.step = median(np.diff(times))
        self.rising_step = median(np.diff(np.sort(times[np.isfinite(times)])))


def _times(part: TimedPart, clock: Clock) -> Iterator[Rows]:
    return ({"times": clock.seconds(table)} for table in part.blocks())


def _timed_columns(part: TimedPart, first: _Survey) -> Iterator[Rows]:
    """The columns of a part with their times, by the clock of the ``first``."""
    clock = part.clock(first.clock.origin or 0)
    for table in part.blocks():
        yield {"times": clock.seconds(table), "columns": part.part.stacked(table.groups)}


def _are_same(first: TimedPart, other: TimedPart, survey: _Survey) -> bool:
    """Whether two parts of as many rows have the same samples."""
    pairs = zip(
        of_length(_times(first, first.clock()), windows.WINDOW),
        of_length(_times(other, other.clock(survey.clock.origin or 0)), windows.WINDOW),
        strict=True,
    )
    return all(are_same(times["times"], t["times"], survey.step) for t, times in pairs)


def _common(first: TimedPart, low: float, high: float) -> tuple[int, int]:
    """The first row, and the one behind the last, of a time from ``low`` to ``high``."""
    start, end, count = 0, 0, 0
    for rows in _times(first, first.clock()):
        t = rows["times"]
        inside = np.flatnonzero((t >= low) & (t <= high))
        if len(inside):
            start = start if end else count + int(inside[0])
            end = count + int(inside[-1]) + 1
        count += len(t)
    return start, end
