"""Rows that stand out of the course of the motion, and rows that only repeat the one before."""

from __future__ import annotations

import numpy as np

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.flag import Flag, Rows, chunks, count, span, spans_of
from robodyn.logs.log import Log


def without_spikes(log: Log, index: Rows, flags: list[Flag]) -> Rows:
    """``index`` without rows in which a position or a torque jumps away, to come back soon after."""
    some = np.diff(log.t[index[: min(len(index), 100_000)]])
    period = float(np.median(some)) if len(some) else 0.0
    drop: dict[int, None] = {}
    for name, longest in (("q", limits.LONGEST_DROPOUT), ("tau", limits.FILLED_ROWS)):
        array: Floats = getattr(log, name)
        for j in range(log.n):
            spikes, jumps = _jumps(array[:, j], log.t, index, period, longest, position=name == "q")
            where = f"{name}{j + 1}"
            if spikes:
                text = f"jumps away and back in {count(len(spikes))}, left out"
                flags.append(Flag("spike", where, spans_of(index[spikes], log.t), text, (j + 1,)))
                drop.update(dict.fromkeys(spikes))
            if jumps and name == "q":
                text = f"jumps faster than an arm can move, {count(len(jumps), 'time')}: the log is cut there"
                flags.append(Flag("jump", where, spans_of(index[jumps], log.t), text, (j + 1,)))
    return np.delete(index, sorted(drop)) if drop else index


def _jumps(
    x: Floats, t: Floats, index: Rows, period: float, longest: int, *, position: bool
) -> tuple[list[int], list[int]]:
    """Places in ``index`` where ``x`` is away from its course for ``longest`` rows at most, and where it
    leaves its course for good."""
    stride = max(1, len(index) // 50_000)
    pairs = index[:-1][::stride], index[1:][::stride]
    usual = np.quantile(np.abs(x[pairs[1]] - x[pairs[0]]), 0.99)
    least = limits.LARGEST_ACCELERATION * period**2
    if not position:
        low, high = np.quantile(x[pairs[0]], [0.01, 0.99])
        least = float(high - low)
    limit = max(limits.JUMP_FACTOR * float(usual), least)
    if position:
        limit = min(limit, max(limits.FASTEST * period, least))
    if limit <= 0:
        return [], []
    kept: list[int] = []
    for rows in chunks(len(index) - 1):
        own = index[rows.start : rows.stop + 1]
        # Across missing rows any distance may be covered.
        far = (np.abs(np.diff(x[own])) > limit) & (np.diff(t[own]) < 1.5 * period)
        kept += (np.flatnonzero(far) + rows.start).tolist()
        if len(kept) > 2 * limits.BROKEN_SHARE * len(index):
            return [], []  # not jumps: this is how the signal is
    spikes: list[int] = []
    jumps: list[int] = []
    k = 0
    while k < len(kept):
        a = kept[k]
        step = x[index[a + 1]] - x[index[a]]
        # The way back: the course is met again where it was left.
        home = next(
            (
                m
                for m in range(k + 1, len(kept))
                if kept[m] - a <= longest and abs(x[index[kept[m] + 1]] - x[index[a]]) < 0.3 * abs(step)
            ),
            None,
        ) if k + 1 < len(kept) and kept[k + 1] - a <= longest else None  # fmt: skip
        if home is not None:
            spikes += range(a + 1, kept[home] + 1)
            k = home + 1
            continue
        # A torque may well jump where the arm starts and stops.
        if position and a + 1 > len(index) - 1 - limits.FILLED_ROWS:
            spikes += range(a + 1, len(index))
        elif position and a < limits.FILLED_ROWS:
            spikes += range(a + 1)
        else:
            jumps.append(a + 1)
        k += 1
    return spikes, jumps


def without_held(log: Log, index: Rows, flags: list[Flag]) -> Rows:
    """``index`` with one row of each set that a slower source has left the same."""
    some = index[:50_000]
    same = (np.diff(log.q[some], axis=0) == 0).all(axis=1) & (np.diff(log.tau[some], axis=0) == 0).all(axis=1)
    changes = np.flatnonzero(~same) + 1
    if len(changes) < limits.FEWEST_ROWS or same.mean() < 0.3:
        return index
    runs = np.diff(changes)
    m = int(np.median(runs))
    if m < 2 or (runs % m == 0).mean() < 0.95:
        return index
    phase = int(np.bincount(changes % m, minlength=m).argmax())
    text = f"each sample stands {m} times in a row: the source is {m} times slower than the log"
    flags.append(Flag("held", "q, tau", (span(int(index[0]), int(index[-1]), log.t),), text))
    return index[phase::m]
