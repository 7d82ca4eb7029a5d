"""The arrays of a log out of a recording and a map: columns found, brought to one time, to SI units."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError, Place
from robodyn.logs.conditions import Mean
from robodyn.logs.conversion import convert
from robodyn.logs.limits import SAME_TIME
from robodyn.logs.mapping import LogMap
from robodyn.logs.recording import Recording
from robodyn.logs.streams import Opener, Part, Sources, TimedPart, conditions_apart, readings_of, sources_of
from robodyn.logs.windows import interpolated
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Arrays:
    """``t`` [K], ``groups`` [K, n] in SI units, and ``notes`` on what was left out or brought to one time.
    ``began``: when t = 0 was [s since 1970, UTC], None where times are no dates. ``readings`` [K, m] of
    conditions by name, and means of those in streams ``apart`` from the positions'."""

    t: Floats
    groups: Mapping[str, Floats]
    notes: tuple[str, ...]
    began: float | None = None
    readings: Mapping[str, Floats] = field(default_factory=dict)
    apart: Mapping[str, Mean] = field(default_factory=dict)

    def part(self, rows: slice) -> Arrays:
        """Some ``rows`` of it."""
        groups, readings = (
            {name: array[rows] for name, array in each.items()} for each in (self.groups, self.readings)
        )
        return replace(self, t=self.t[rows], groups=groups, readings=readings)


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
    sources = sources_of(recording, mapping, n, opener)
    first, *others = timed_parts(sources)
    table = first.read()
    clock = first.clock()
    t = clock.seconds(table)
    notes = [*recording.notes, *first.note(table.skipped, table.rows)]
    groups = groups_of(sources, table.groups, table.rows)
    low, high = -np.inf, np.inf
    for other in others:
        more = other.read()
        times = other.clock(clock.origin or 0).seconds(more)
        notes += other.note(more.skipped, more.rows)
        columns = other.part.stacked(more.groups)
        if not other.timed:
            check_count(other, more.rows, len(t))
        elif more.rows != len(t) or not are_same(times, t, median(np.diff(t))):
            low, high = max(low, float(times[0])), min(high, float(times[-1]))
            notes.append(rate_note(other, median(np.diff(times))))
            columns = _at(times, columns, t)
        put(groups, other.part, columns)
    to_si(groups, sources, robot)
    inside = slice(None)
    if np.isfinite(low) or np.isfinite(high):
        rows = np.flatnonzero((t >= low) & (t <= high))
        if not len(rows):
            raise nothing_common(recording.file, float(t[0]), float(t[-1]), low, high)
        inside = slice(int(rows[0]), int(rows[-1]) + 1)
    readings = readings_of(first.part, table.groups, mapping)
    return Arrays(t, groups, tuple(notes), clock.began, readings, conditions_apart(sources)).part(inside)


def timed_parts(sources: Sources) -> list[TimedPart]:
    """The parts with their times; those beside the first may have none."""
    return [TimedPart(part, sources.mapping, first=not k) for k, part in enumerate(sources.parts)]


def groups_of(sources: Sources, tables: Mapping[str, Floats], rows: int) -> dict[str, Floats]:
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


def put(groups: Mapping[str, Floats], part: Part, columns: Floats) -> None:
    """Put the ``columns`` [k, m] of ``part`` into ``groups``, in place."""
    start = 0
    for group in part.groups:
        joints = part.joints(group)
        groups[group][:, joints] = columns[:, start : start + len(joints)]
        start += len(joints)


def to_si(groups: Mapping[str, Floats], sources: Sources, robot: Robot | None) -> None:
    """Bring all columns of ``groups`` to SI units, in place."""
    for group, channel in sources.channels.items():
        for _, source in (pair for part in sources.parts for pair in part.columns if pair[0] == group):
            stated = source.stream.units.get(source.column, "")
            convert(groups[group][:, source.joint], channel, group, source.joint, stated, robot)


def median(steps: Floats) -> float:
    """The usual one of some ``steps`` between times; 1 of none."""
    return float(np.median(steps)) if len(steps) else 1.0


def are_same(times: Floats, t: Floats, step: float) -> bool:
    """Whether two series of as many times are those of the same samples, ``step`` apart."""
    return bool((np.abs(times - t) <= SAME_TIME * abs(step)).all())


def check_count(part: TimedPart, rows: int, beside: int) -> None:
    """Refuse a ``part`` without times that has other ``rows`` than the first has."""
    if rows != beside:
        raise InputError(
            "the rows of a second file have no times, and are not as many",
            where=Place(part.part.recording.file),
            found=str(rows),
            expected=str(beside),
            remedy="it needs the column of times that the map says",
        )


def rate_note(part: TimedPart, step: float) -> str:
    """That the columns of ``part``, whose times are a ``step`` apart, were interpolated."""
    return f"{part.part.name}: {1 / max(step, 1e-12):.4g} Hz, interpolated at q's times"


def nothing_common(file: str, first: float, last: float, low: float, high: float) -> InputError:
    """What to say of streams of different times."""
    return InputError(
        "the streams have no time in common",
        where=Place(file),
        found=f"{first:.6g} to {last:.6g} s, and {low:.6g} to {high:.6g} s",
        expected="recordings of the same time",
    )


def _at(times: Floats, columns: Floats, t: Floats) -> Floats:
    """``columns`` [K, m] at ``t``, interpolated between their ``times``; NaN where these are far apart."""
    sound = np.isfinite(times)
    if not sound.all():
        times, columns = times[sound], columns[sound]
    if not (np.diff(times) >= 0).all():
        order = np.argsort(times, kind="stable")
        times, columns = times[order], columns[order]
    return interpolated(times, columns, t, median(np.diff(times)))
