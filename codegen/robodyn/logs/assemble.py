"""The arrays of a log out of a recording and a map: columns found, brought to one time, to SI units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.conversion import convert, of_stamps, seconds
from robodyn.logs.limits import APART, SAME_TIME
from robodyn.logs.mapping import GROUPS, Channel, LogMap
from robodyn.logs.recording import Recording, Stream, Table
from robodyn.logs.resolve import Source, channel_of, joints_of, sources, stamp_of
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]
Opener = Callable[[str], Recording]


@dataclass(frozen=True, slots=True)
class Arrays:
    """``t`` [K], ``groups`` [K, n] in SI units, and ``notes`` on what was left out or brought to one time."""

    t: Floats
    groups: Mapping[str, Floats]
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Part:
    """Columns of one stream of one file, with their groups."""

    recording: Recording
    stream: Stream
    columns: list[tuple[str, Source]]


def assemble(
    recording: Recording, mapping: LogMap, n: int | None, robot: Robot | None, opener: Opener
) -> Arrays:
    """The arrays of the log ``recording``; ``n`` joints, None: as many as q has columns.

    Columns that are recorded at other times than q are interpolated at the times of q. ``opener`` opens
    second files.

    Raises
    ------
    InputError: columns are missing or not to be told apart, units are unknown, files damaged.
    """
    n = joints_of(recording, mapping) if n is None else n
    channels = {
        group: channel_of(recording, mapping, group)
        for group in GROUPS
        if group in mapping.groups or group in ("q", "tau")
    }
    channels.pop("t", None)
    parts = _parts(recording, mapping, channels, n, opener)
    first = parts[0]
    t, own, stamps, more = _read(first, mapping, channels)
    notes = [*recording.notes, *more]
    origin = 0 if stamps is None or not len(stamps) else int(stamps[0])
    t = of_stamps(stamps, origin) if stamps is not None else t
    groups: dict[str, Floats] = {}
    for group in channels:
        joints = [source.joint for name, source in first.columns if name == group]
        table = own.get(group)
        if table is not None and joints == list(range(n)):
            groups[group] = table
            continue
        groups[group] = np.full((len(t), n), np.nan)
        if table is not None:
            groups[group][:, joints] = table
        own.pop(group, None)
    low, high = -np.inf, np.inf
    for part in parts[1:]:
        times, tables, other, more = _read(part, mapping, channels, beside=len(t))
        times = of_stamps(other, origin) if other is not None else times
        notes += more
        same = len(times) == len(t) and _same(times, t)
        if not same and len(times):
            low, high = max(low, float(times[0])), min(high, float(times[-1]))
            rate = 1 / max(float(np.median(np.diff(times))) if len(times) > 1 else 1.0, 1e-12)
            notes.append(
                f"{part.stream.name or part.recording.file}: {rate:.4g} Hz, interpolated at q's times"
            )
        for group, table in tables.items():
            joints = [source.joint for name, source in part.columns if name == group]
            for k, joint in enumerate(joints):
                groups[group][:, joint] = table[:, k] if same else _at(times, table[:, k], t)
    for group, channel in channels.items():
        for _, source in (pair for part in parts for pair in part.columns if pair[0] == group):
            stated = source.stream.units.get(source.column, "")
            convert(groups[group][:, source.joint], channel, group, source.joint, stated, robot)
    inside = slice(None)
    if np.isfinite(low) or np.isfinite(high):
        inside = _common(t, low, high, recording.file)
    return Arrays(t[inside], {name: array[inside] for name, array in groups.items()}, tuple(notes))


def _parts(
    recording: Recording, mapping: LogMap, channels: Mapping[str, Channel], n: int, opener: Opener
) -> list[_Part]:
    """What is to be read of each stream; first that of the first joint's position."""
    parts: list[_Part] = []
    for group, channel in channels.items():
        source = recording
        if channel.file:
            stem = str(Path(recording.file).with_suffix(""))
            source = opener(channel.file.replace("%s", stem))
        for one in sources(source, mapping, group, channel, n):
            for part in parts:
                if part.recording.file == source.file and part.stream.name == one.stream.name:
                    part.columns.append((group, one))
                    break
            else:
                parts.append(_Part(source, one.stream, [(group, one)]))
    return parts


def _read(
    part: _Part, mapping: LogMap, channels: Mapping[str, Channel], beside: int | None = None
) -> tuple[Floats, dict[str, Floats], NDArray[np.int64] | None, list[str]]:
    """Times [s], columns by group [K, m], stamps [ns] in place of times, and notes; ``beside`` so many rows
    of the first part, whose times hold where this one has none of its own and as many rows."""
    channel = mapping.groups.get("t")
    where = Place(part.recording.file) if channel is None else channel.place
    stamp = stamp_of(channel, part.stream, where)
    wanted: dict[str, list[str]] = {}
    column: Source | None = None
    if stamp is None and (channel is None or channel.rate is None):
        column = _times(part, mapping, optional=beside is not None)
        if column is not None:
            wanted["t"] = [column.column]
    for group, source in part.columns:
        wanted.setdefault(group, []).append(source.column)
    table: Table = part.recording.read(part.stream, wanted, stamp)
    rows = len(next(iter(table.groups.values())))
    if not rows:
        raise InputError(
            "the log has no samples", where=Place(part.recording.file), expected="a row a sample"
        )
    notes = []
    if table.skipped:
        name = part.stream.name or part.recording.file
        notes.append(f"{name}: {table.skipped} of {table.skipped + rows} rows lack these columns, left out")
    tables = dict(table.groups)
    if table.stamps is not None:
        return np.empty(0), tables, table.stamps, notes
    if column is not None:
        t = tables.pop("t")[:, 0]
        t = np.ascontiguousarray(t)
        seconds(t, channel or Channel((column.column,), where), part.stream.units.get(column.column, ""))
        return t, tables, None, notes
    if channel is not None and channel.rate is not None:
        return _even(rows, channel.rate), tables, None, notes
    if rows != beside:
        raise InputError(
            "the rows of a second file have no times, and are not as many",
            where=Place(part.recording.file),
            found=str(rows),
            expected=str(beside),
            remedy="it needs the column of times that the map says",
        )
    return np.empty(0), tables, None, notes


def _times(part: _Part, mapping: LogMap, *, optional: bool) -> Source | None:
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


def _even(rows: int, rate: Fraction) -> Floats:
    """Times of so many ``rows`` at an even ``rate`` [Hz]."""
    k = np.arange(rows, dtype=np.float64)
    if rate.denominator == 1:
        return k / float(rate)
    return k * float(1 / rate)


def _same(times: Floats, t: Floats) -> bool:
    """Whether two series of as many times are those of the same samples."""
    if not len(times):
        return True
    steps = np.diff(t)
    step = float(np.median(steps)) if len(steps) else 1.0
    return bool((np.abs(times - t) <= SAME_TIME * abs(step)).all())


def _at(times: Floats, x: Floats, t: Floats) -> Floats:
    """``x`` at ``t``, interpolated between its ``times``; NaN where these are far apart."""
    steps = np.diff(times)
    if not len(steps) or not (steps >= 0).all():
        order = np.argsort(times, kind="stable")
        times, x = times[order], x[order]
        steps = np.diff(times)
    result: Floats = np.interp(t, times, x, left=np.nan, right=np.nan)
    if len(steps):
        after = np.clip(np.searchsorted(times, t), 1, len(times) - 1)
        result[steps[after - 1] > APART * float(np.median(steps))] = np.nan
    return result


def _common(t: Floats, low: float, high: float, file: str) -> slice:
    """The rows of ``t`` from ``low`` to ``high``, between which all streams have samples."""
    inside = np.flatnonzero((t >= low) & (t <= high))
    if not len(inside):
        raise InputError(
            "the streams have no time in common",
            where=Place(file),
            found=f"{t[0]:.6g} to {t[-1]:.6g} s, and {low:.6g} to {high:.6g} s",
            expected="recordings of the same time",
        )
    return slice(int(inside[0]), int(inside[-1]) + 1)
