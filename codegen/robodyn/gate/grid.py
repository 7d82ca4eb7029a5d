"""The usable rows of a log on an even grid, and no more of them than a fit needs."""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.flag import Flag, Rows, Span, span, spans_of
from robodyn.gate.rows import Usable
from robodyn.logs.log import Log
from robodyn.logs.signals import thinning


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """``log`` on an even grid, where ``segments`` are unbroken; ``parts`` are the rows (from 0) of the raw
    log that each of them comes of, ``times`` [rows] (s) the raw log's. One sample is ``stride`` rows there.
    The raw log itself, which may be long, is let go."""

    log: Log
    times: Floats
    segments: tuple[slice, ...]
    parts: tuple[Rows, ...]
    period: float
    stride: int

    def rows(self) -> Rows:
        """About which row (from 0) of the raw log each sample is [K]."""
        rows = []
        for segment, part in zip(self.segments, self.parts, strict=True):
            if self.stride > 1:
                rows.append(part[:: self.stride][: segment.stop - segment.start])
                continue
            near = np.searchsorted(self.times[part], self.log.t[segment] - 0.5 * self.period)
            rows.append(part[np.minimum(near, len(part) - 1)])
        return np.concatenate(rows)

    def spans(self, samples: Rows) -> tuple[Span, ...]:
        """Where the ``samples`` (rising) are in the raw log, runs of them as one span."""
        return spans_of(self.rows()[samples], self.times)


def on_grid(
    log: Log,
    rows: Usable,
    most: int,
    flags: list[Flag],
    windows: int = limits.WINDOWS,
    thinned: int | None = None,
) -> Grid:
    """The rows of ``log`` that are used: all, or ``most`` of them in ``windows`` spread over the motion, of
    which no more than ``thinned`` are left where they are filtered and thinned."""
    index, period, stride = rows.index, rows.period, 1
    if thinned is not None:
        most = min(most, thinned * thinning(1 / period))
    parts = rows.parts
    total = sum(b - a for a, b in parts)
    if total > most:
        if rows.even and 1 / period > limits.FAST_RATE:
            stride = min(int(2 / (limits.FAST_RATE * period)), total // most)
        parts = _windows(log, rows, most * stride, windows)
        kept = sum(b - a for a, b in parts)
        spans = tuple(span(int(index[a]), int(index[b - 1]), log.t) for a, b in parts)
        text = f"{kept} of {total} usable rows, in {len(parts)} windows spread over the motion, are used"
        text += f", {stride} averaged to one" if stride > 1 else ""
        flags.append(Flag("cut_down", "all", spans, text))
    whole = rows.even and stride == 1 and len(index) == log.samples and parts == ((0, log.samples),)
    log = replace(log, qd=log.qd if rows.rates else None, qdd=log.qdd if rows.accelerations else None)
    origins = tuple(index[a:b] for a, b in parts)
    if whole:
        result = replace(log, t=log.t[0] + period * np.arange(log.samples))
        return Grid(result, log.t, (slice(0, log.samples),), origins, period, 1)
    groups = {name: getattr(log, name) for name in ("q", "qd", "qdd", "tau", "ql")}
    resampled: dict[str, list[Floats]] = {name: [] for name, array in groups.items() if array is not None}
    times, segments, start = [], [], 0
    for a, b in parts:
        own = index[a:b]
        t = log.t[own]
        length = b - a if rows.even else int(np.floor((t[-1] - t[0]) / period + 1e-6)) + 1
        grid = t[0] + period * np.arange(length)
        for name, pieces in resampled.items():
            values = groups[name][own]
            values = values if rows.even else _interpolated(t, values, grid)
            pieces.append(_averaged(values, stride))
        times.append(_averaged(grid, stride))
        segments.append(slice(start, start + len(times[-1])))
        start = segments[-1].stop
    arrays = {name: np.concatenate(pieces) for name, pieces in resampled.items()}
    result = replace(log, t=np.concatenate(times), **arrays)  # type: ignore[arg-type]
    return Grid(result, log.t, tuple(segments), origins, period * stride, stride)


def _windows(log: Log, rows: Usable, most: int, count: int) -> tuple[tuple[int, int], ...]:
    """``count`` windows of the parts, evenly among those that move."""
    length = most // count
    windows = []
    for a, b in rows.parts:
        count = max(1, (b - a) // length)
        edges = np.linspace(a, b, count + 1).astype(int).tolist()
        windows += [(u, min(v, u + length)) for u, v in itertools.pairwise(edges)]
    reach = []
    for a, b in windows:
        some = log.q[rows.index[a : b : max(1, (b - a) // 100)]]
        reach.append(some.max(axis=0) - some.min(axis=0))
    largest = np.max(reach, axis=0)
    share = (np.array(reach) / np.where(largest > 0, largest, 1)).max(axis=1)
    moving = [
        w for w, s in zip(windows, share.tolist(), strict=True) if s >= limits.MOVING_SHARE * share.max()
    ]
    lengths = [b - a for a, b in moving]
    if sum(lengths) <= most:
        return tuple(moving)
    # As many as fit, at even distances.
    count = max(1, min(len(moving), int(most / (sum(lengths) / len(moving)))))
    chosen = np.unique(np.linspace(0, len(moving) - 1, count).astype(int)).tolist()
    intervals, left = [], most
    for k in chosen:
        a, b = moving[k]
        intervals.append((a, min(b, a + left)))
        left -= intervals[-1][1] - a
        if left <= 0:
            break
    return tuple(intervals)


def _averaged(x: Floats, stride: int) -> Floats:
    whole = len(x) // stride * stride
    mean: Floats = x[:whole].reshape(whole // stride, stride, *x.shape[1:]).mean(axis=1)
    return mean


def _interpolated(t: Floats, x: Floats, grid: Floats) -> Floats:
    """``x`` [K, n] at the times ``t`` [K] on ``grid`` [L], by the cubic through the four samples around."""
    k = np.clip(np.searchsorted(t, grid, side="right") - 2, 0, len(t) - 4)
    nodes = [t[k + i] for i in range(4)]
    result = np.zeros((len(grid), x.shape[1]))
    for i in range(4):
        weight = np.ones(len(grid))
        for m in range(4):
            if m != i:
                weight *= (grid - nodes[m]) / (nodes[i] - nodes[m])
        result += weight[:, None] * x[k + i]
    return result
