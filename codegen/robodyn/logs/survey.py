"""What is in a file: streams, columns, ranges, how often rows come, what is missing, what stands still."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.logs.limits import APART, STANDSTILL, STILL_TIME
from robodyn.logs.log import Log
from robodyn.logs.recording import Recording, Stream, Table
from robodyn.logs.resolve import joints_in

#: Numbers that are read at once, columns of a stream that are looked at, and rows that are kept of each.
AT_ONCE, COLUMNS, KEPT = 1 << 25, 512, 20_000
#: Parts of messages that are not all alike, that are looked at one by one.
PARTS = 24


@dataclass(frozen=True, slots=True, eq=False)
class ColumnFacts:
    """A column: the smallest and largest of its numbers, in its own unit, the share of its rows that have
    one, whether all are whole, and ``window``, unbroken rows from its middle."""

    name: str
    low: float
    high: float
    share: float
    whole: bool
    window: Floats

    @property
    def constant(self) -> bool:
        """Whether it never changes."""
        return not self.low < self.high


@dataclass(frozen=True, slots=True, eq=False)
class StreamFacts:
    """A stream, its columns by name, and ``seconds`` [K] of the window's rows, if it has stamps."""

    stream: Stream
    rows: int
    columns: Mapping[str, ColumnFacts]
    seconds: Floats | None


def look(recording: Recording) -> tuple[StreamFacts, ...]:
    """The streams of ``recording``, those with most rows first.

    Raises
    ------
    InputError: the file is damaged.
    """
    facts = [_stream(recording, stream) for stream in recording.streams if stream.columns]
    return tuple(sorted(facts, key=lambda one: -one.rows))


def _stream(recording: Recording, stream: Stream) -> StreamFacts:
    names = [name for name in stream.columns if name][:COLUMNS]
    rows = stream.rows
    if rows is None:
        rows = recording.rough_rows or 1
    width = max(1, AT_ONCE // max(1, rows))
    stamp = stream.stamps[0] if stream.stamps else None
    columns: dict[str, ColumnFacts] = {}
    seconds: Floats | None = None
    for start in range(0, len(names), width):
        for listed, table in _tables(recording, stream, names[start : start + width], stamp):
            numbers = table.groups["all"]
            for k, name in enumerate(listed):
                columns[name] = _column(name, numbers[:, k])
            if seconds is None and table.stamps is not None and len(numbers):
                seconds = (table.stamps[_window(len(numbers))] - table.stamps[0]) / 1e9
            rows = len(numbers) if stream.rows is None else rows
    return StreamFacts(stream, rows, {name: columns[name] for name in names if name in columns}, seconds)


def _tables(
    recording: Recording, stream: Stream, names: list[str], stamp: str | None
) -> Iterator[tuple[list[str], Table]]:
    """The columns ``names``, together if all rows have them all. Joints of several publishers are not in the
    same messages: then those of one joint, or one part of a message, at a time."""
    table = recording.read(stream, {"all": names}, stamp)
    if not table.skipped:
        yield names, table
        return
    groups: dict[str, list[str]] = {}
    for name in names:
        part = name.rpartition(".")[2] if joints_in(stream) else name.partition(".")[0]
        groups.setdefault(part, []).append(name)
    for listed in list(groups.values())[:PARTS]:
        yield listed, recording.read(stream, {"all": listed}, stamp)


def _window(rows: int) -> slice:
    start = max(0, (rows - KEPT) // 2)
    return slice(start, start + KEPT)


def _column(name: str, x: Floats) -> ColumnFacts:
    finite = x[np.isfinite(x)]
    if not len(finite):
        return ColumnFacts(name, np.nan, np.nan, 0.0, False, np.full_like(x[_window(len(x))], np.nan))
    whole = bool((finite[:KEPT] == np.rint(finite[:KEPT])).all())
    window = np.where(np.isfinite(x[_window(len(x))]), x[_window(len(x))], np.nan)
    share = len(finite) / len(x)
    return ColumnFacts(name, float(finite.min()), float(finite.max()), share, whole, window)


# --- of a log in SI units -------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class LogFacts:
    """A log: ``samples``, ``joints``, ``duration`` [s], ``rate`` [Hz], ``jitter`` (the share of the period
    by which one interval in a hundred is off; NaN without two different times), ``gaps`` (start and length
    [s]), times that go ``backwards``, rows that are ``repeated`` in every digit or have a number ``missing``,
    the share of time at ``standstill`` (NaN where no two positions can be compared), and the joints (from 1)
    that ``move``."""

    samples: int
    joints: int
    duration: float
    rate: float
    jitter: float
    gaps: tuple[tuple[float, float], ...]
    backwards: int
    repeated: int
    missing: int
    standstill: float
    move: tuple[int, ...]


def facts_of(log: Log) -> LogFacts:
    """What there is to know of ``log`` before it is used; of its times, those that are numbers."""
    t = log.t[np.isfinite(log.t)]
    steps = np.diff(t)
    forward = steps[steps > 0]
    period = float(np.median(forward)) if len(forward) else np.nan
    gaps = np.flatnonzero(steps > APART * period) if len(forward) else np.empty(0, int)
    near: Floats = np.abs(forward[forward <= APART * period] / period - 1)
    same = (np.diff(log.q, axis=0) == 0).all(axis=1) & (np.diff(log.tau, axis=0) == 0).all(axis=1)
    usual = np.where(np.isfinite(log.q), log.q, np.inf).min(axis=0, initial=np.inf)
    reach = np.ptp(np.where(np.isfinite(log.q), log.q, usual), axis=0)
    stride = max(1, min(round(STILL_TIME / period), log.samples // 4)) if len(forward) else 1
    moved = np.abs(log.q[stride:] - log.q[:-stride])
    speed = np.nanmax(moved, axis=0, initial=0.0)
    compared = np.isfinite(moved).all(axis=1)
    still: NDArray[np.bool_] = np.all(moved[compared] <= STANDSTILL * np.where(speed > 0, speed, 1), axis=1)
    broken = ~np.isfinite(np.column_stack([log.t, log.q, log.tau])).all(axis=1)
    return LogFacts(
        samples=log.samples,
        joints=log.n,
        duration=float(t[-1] - t[0]) if len(t) else float("nan"),
        rate=1 / period if period > 0 else float("nan"),
        jitter=float(np.quantile(near, 0.99)) if len(near) else float("nan"),
        gaps=tuple((float(t[k]), float(steps[k])) for k in gaps[:20]),
        backwards=int((steps < 0).sum()),
        repeated=int(same.sum()),
        missing=int(broken.sum()),
        standstill=float(still.mean()) if len(still) else float("nan"),
        move=tuple(j + 1 for j in range(log.n) if reach[j] > 1e-3),
    )
