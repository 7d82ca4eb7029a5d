"""Which rows of a log can be used: numbers that are none, rows out of order, repeated or missing, spikes.

Memory stays a small share of the log's own: what is large is read in pieces.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np

from robodyn.arrays import Floats, Mask
from robodyn.gate import limits
from robodyn.gate.flag import Flag, Rows, chunks, count, named, refuse, span, spans_of
from robodyn.gate.links import links_garbage
from robodyn.gate.spikes import without_held, without_spikes
from robodyn.logs.limits import FASTEST_RATE
from robodyn.logs.log import Log


@dataclass(frozen=True, slots=True, eq=False)
class Usable:
    """Rows that can be used: their numbers ``index`` [K] in the log, their common ``period`` [s], and the
    ``parts`` of the index that lie between gaps; ``even`` where the rows themselves are evenly spaced."""

    index: Rows
    period: float
    parts: tuple[tuple[int, int], ...]
    even: bool
    rates: bool
    accelerations: bool


def usable(log: Log, flags: list[Flag], repeats: Mask | None = None) -> Usable:
    """The rows of ``log`` that can be used, but for the ``repeats`` [K]; what is wrong with others goes to
    ``flags``.

    Raises
    ------
    InputError: too many rows are garbage, times run backwards or repeat, or too few samples are left.
    """
    if log.samples < limits.FEWEST_ROWS:
        refuse(
            "the log is too short to diagnose",
            found=f"{log.samples} rows",
            expected=f"{limits.FEWEST_ROWS} rows or more, some seconds of motion",
            remedy="record a longer motion",
        )
    bad, rates, accelerations = _garbage(log, flags)
    index = np.flatnonzero(~bad if repeats is None else ~(bad | repeats))
    index = _ordered(log, index, flags)
    index = without_spikes(log, index, flags)
    index = without_held(log, index, flags)
    return _parts(log, index, flags, rates=rates, accelerations=accelerations)


# --- numbers that are none --------------------------------------------------------------------------------


def _garbage(log: Log, flags: list[Flag]) -> tuple[Mask, bool, bool]:
    """Rows with a number that is none or absurd, and whether each of the rates can be used."""
    bad = np.zeros(log.samples, dtype=bool)
    usable_rates = {"qd": log.qd is not None, "qdd": log.qdd is not None}
    for name in ("t", "q", "tau", "qd", "qdd"):
        array = getattr(log, name)
        if array is None:
            continue
        table = array if array.ndim == 2 else array[:, None]
        garbage = np.zeros(log.samples, dtype=bool)
        counts = np.zeros(table.shape[1], dtype=np.int64)
        for rows in chunks(log.samples):
            wrong = ~(np.abs(table[rows]) <= limits.BOUNDS[name])
            counts += wrong.sum(axis=0)
            garbage[rows] = wrong.any(axis=1)
        share = counts.max() / log.samples
        if share > limits.BROKEN_SHARE:
            j = int(counts.argmax())
            column = name if name == "t" else f"{name}{j + 1}"
            if name in usable_rates:
                usable_rates[name] = False
                text = (
                    f"no number, or one beyond {limits.BOUNDS[name]:g}, in {share:.0%} of the rows: not used"
                )
                flags.append(Flag("rates_unusable", column, spans_of(np.flatnonzero(garbage), log.t), text))
                continue
            first = int(np.argmax(~(np.abs(table[:, j]) <= limits.BOUNDS[name])))
            value = f"{table[first, j]:g}" if np.isfinite(table[first, j]) else "none"
            unit = {"t": "s", "q": "rad or m", "tau": "N m or N"}[name]
            refuse(
                f"{column} cannot be used",
                found=f"no number or one beyond {limits.BOUNDS[name]:g} in {share:.1%} of the rows, first "
                f"{value} in {span(first, first, log.t)}",
                expected=f"numbers in {unit}, at most {limits.BROKEN_SHARE:.0%} of the rows broken",
                remedy="record it again, or convert its unit",
            )
        if garbage.any():
            joints = () if name == "t" else tuple(j + 1 for j in np.flatnonzero(counts).tolist())
            where = named(name, joints) or name
            text = (
                f"no number, or one beyond {limits.BOUNDS[name]:g}, in {count(int(garbage.sum()))}, left out"
            )
            flags.append(Flag("garbage", where, spans_of(np.flatnonzero(garbage), log.t), text, joints))
        bad |= garbage
    bad |= links_garbage(log, flags)
    if bad.mean() > limits.BROKEN_SHARE:
        first = int(np.argmax(bad))
        refuse(
            "too many rows are garbage",
            found=f"{bad.mean():.1%} of the rows, first {span(first, first, log.t)}",
            expected=f"at most {limits.BROKEN_SHARE:.0%}",
            remedy="record it again, or take a part that is sound",
        )
    return bad, usable_rates["qd"], usable_rates["qdd"]


# --- order of the rows ------------------------------------------------------------------------------------


def _ordered(log: Log, index: Rows, flags: list[Flag]) -> Rows:
    """``index`` without rows that repeat a time, or whose time stands alone out of order."""
    index = _without_strays(log, index, flags)
    again = np.flatnonzero(np.diff(log.t[index]) == 0) + 1
    if not len(again):
        return index
    rows, before = index[again], index[again - 1]
    same = (log.q[rows] == log.q[before]).all(axis=1) & (log.tau[rows] == log.tau[before]).all(axis=1)
    other = rows[~same]
    if len(other) > limits.REPEATED_SHARE * len(index):
        first = int(other[0])
        refuse(
            "times repeat with other values",
            found=f"{len(other)} of {len(index)} rows, first {span(first, first, log.t)}",
            expected="times that increase",
            remedy="write t with more digits",
        )
    if same.any():
        text = f"{count(int(same.sum()))} standing twice, left out once"
        flags.append(Flag("duplicated", "t", spans_of(rows[same], log.t), text))
    if len(other):
        text = f"{count(len(other))} with the time of the row before and other values, left out"
        flags.append(Flag("repeated_time", "t", spans_of(other, log.t), text))
    return np.delete(index, again)


def _without_strays(log: Log, index: Rows, flags: list[Flag]) -> Rows:
    """``index`` without rows whose time is out of order between others that are in order."""
    strays: list[int] = []
    most = limits.BROKEN_SHARE * len(index)
    while True:
        t = log.t[index]
        back = np.flatnonzero(np.diff(t) < 0) + 1
        if not len(back):
            break
        if len(strays) + len(back) > most:
            _backwards(log, index, back)
        drop = []
        for k in back.tolist():
            late = k < 2 or t[k - 2] < t[k]
            early = k + 1 >= len(t) or t[k + 1] > t[k - 1]
            if not late and not early:
                # A burst of strays: the way out of it lies a few rows on, or back.
                late = k >= 2 and any(t[k - m] < t[k] for m in range(3, min(k, 6) + 1))
                early = any(t[k + m] > t[k - 1] for m in range(2, min(len(t) - k, 6)))
            if not late and not early:
                _backwards(log, index, back)
            drop.append(k if early else k - 1)
        strays += index[drop].tolist()
        index = np.delete(index, drop)
    if strays:
        rows = sorted(strays)
        text = f"{count(len(rows))} with a time out of order, left out"
        flags.append(Flag("stray_time", "t", spans_of(rows, log.t), text))
    return index


def _backwards(log: Log, index: Rows, back: Rows) -> None:
    k = int(back[0])
    refuse(
        "time runs backwards",
        found=f"t = {log.t[index[k]]:.6g} s in row {index[k] + 1} after {log.t[index[k - 1]]:.6g} s"
        + (f", and {len(back) - 1} times more" if len(back) > 1 else ""),
        expected="times that increase",
        remedy="sort the rows, or make each run a log of its own",
    )


# --- period and gaps --------------------------------------------------------------------------------------


def _parts(log: Log, index: Rows, flags: list[Flag], *, rates: bool, accelerations: bool) -> Usable:
    t = log.t[index]
    steps = np.diff(t)
    middle = float(np.median(steps)) if len(steps) else np.inf
    if not middle <= limits.SLOWEST_PERIOD:
        refuse(
            "the samples are too far apart to show dynamics",
            found=f"{middle:.6g} s from row to row",
            expected=f"t in s, a row each {limits.SLOWEST_PERIOD:g} s or oftener",
            remedy="write t in seconds, or record faster",
        )
    if middle < 1 / FASTEST_RATE:
        refuse(
            "the samples are too close together for a time in seconds",
            found=f"{middle:.6g} s from row to row",
            expected=f"t in s, {FASTEST_RATE:g} rows a second at most",
            remedy="write t in seconds",
        )
    regular = np.abs(steps / middle - 1) < 0.5
    steady = bool(regular.mean() > 0.6)
    near = regular if steady else steps < 5 * middle
    period = float(steps[near].mean())
    missing = (
        np.rint(steps / period - limits.LOST_SHARE)
        if steady
        else np.where(steps > 10 * period, steps / period, 0)
    )
    gaps = np.flatnonzero(missing >= 1)
    filled = (missing[gaps] <= limits.FILLED_ROWS) | (steps[gaps] <= limits.FILLED_TIME)
    for kind, places, text in (
        ("missing", gaps[filled], "{} missing in all, filled in"),
        ("gap", gaps[~filled], "{} missing in all: the log is cut there"),
    ):
        if len(places):
            spans = tuple(span(int(index[k]), int(index[k + 1]), log.t) for k in places[:100].tolist())
            flags.append(Flag(kind, "t", spans, text.format(count(int(missing[places].sum())))))
    # A cut at every jump of a position too, for nothing can be filled in across it.
    jumps = {s.first - 1 for flag in flags if flag.kind == "jump" for s in flag.spans}
    cuts = sorted({*(gaps[~filled] + 1).tolist(), *np.searchsorted(index, sorted(jumps)).tolist()})
    edges = [0, *cuts, len(index)]
    all_parts = [(a, b) for a, b in itertools.pairwise(edges) if b > a]
    parts = tuple((a, b) for a, b in all_parts if b - a >= limits.FRAGMENT_ROWS)
    short = [
        span(int(index[a]), int(index[b - 1]), log.t) for a, b in all_parts if b - a < limits.FRAGMENT_ROWS
    ]
    if short:
        flags.append(Flag("fragment", "t", tuple(short[:100]), "too short between gaps, left out"))
    left = sum(b - a for a, b in parts)
    if left < limits.FEWEST_ROWS:
        refuse(
            "too little of the log can be used",
            found=f"{left} of {log.samples} rows in pieces of {limits.FRAGMENT_ROWS} or more",
            expected=f"{limits.FEWEST_ROWS} rows or more",
            remedy="record a longer motion, without gaps",
        )
    even = not (len(gaps) and filled.any()) and _even(t, period, parts)
    if not even:
        off = np.abs(steps[steps < (limits.LOST_SHARE + 0.5) * period] / period - 1)
        worst = float(np.quantile(off, 0.99)) if len(off) else 1.0
        if worst > 0.02 or not steady:
            rows = np.flatnonzero(np.abs(steps / period - 1) > 0.5 * worst)[:100] + 1
            text = f"uneven: one interval in a hundred is off by {worst:.0%} of {period:.6g} s or more"
            text += "; resampled evenly"
            flags.append(Flag("jitter", "t", spans_of(index[rows], log.t), text))
    return Usable(index, period, parts, even, rates, accelerations)


def _even(t: Floats, period: float, parts: tuple[tuple[int, int], ...]) -> bool:
    """Whether the rows lie on an even grid, but for the digits with which their times are written."""
    near = 0.02 * period
    some = t[:: max(1, len(t) // 10_000)]
    for digits in range(1, 7):
        if np.abs(some * 10**digits - np.rint(some * 10**digits)).max() < 1e-5:
            near = max(near, 0.6 * 10.0**-digits)
            break
    # Digits that are coarser than the samples say nothing of the spaces between them.
    near = min(near, 0.5 * period)
    for a, b in parts:
        own = (t[b - 1] - t[a]) / (b - 1 - a)
        if abs(own / period - 1) * (b - a) > 1 and abs(own / period - 1) > 1e-4:
            return False
        for rows in chunks(b - a):
            grid = t[a] + own * np.arange(rows.start, rows.stop)
            if np.abs(t[a + rows.start : a + rows.stop] - grid).max() > near:
                return False
    return True
