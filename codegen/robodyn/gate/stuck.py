"""Positions that stay on one number while the joint goes on: of a frozen sensor, or beyond its range."""

from __future__ import annotations

import numpy as np

from robodyn.gate.flag import Flag, Floats, Rows, refuse
from robodyn.gate.grid import Grid
from robodyn.gate.limits import BEFORE_STAY, STAY_ROWS, STAY_TIME, STUCK_LEAST, STUCK_SHARE, STUCK_SPEED


def check_stuck(grid: Grid, source: str | None, flags: list[Flag]) -> None:
    """Flags on positions that stop dead; a joint that comes to rest slows down before.

    Raises
    ------
    InputError: they do so in too many samples.
    """
    log = grid.log
    stay = max(STAY_ROWS, round(STAY_TIME / grid.period))
    for j in range(log.n):
        rows = [
            part.start + row for part in grid.segments for row in _stuck(log.q[part, j], stay, grid.period)
        ]
        if not rows:
            continue
        spans = grid.spans(np.array(rows, dtype=np.intp))
        share = len(rows) / log.samples
        if share > STUCK_SHARE:
            refuse(
                source,
                f"q{j + 1} stops dead and stays on one number while the joint moves",
                found=f"{log.q[rows[0], j]:.6g} in {spans[0]}, {share:.0%} of the samples in all",
                expected="positions that follow the motion",
                remedy="see whether the sensor freezes, or its range ends there; leave such rows out",
            )
        text = f"stops dead and stays on one number in {share:.1%} of the samples: frozen?"
        flags.append(Flag("stuck", f"q{j + 1}", spans, text, (j + 1,)))


def _stuck(q: Floats, stay: int, period: float) -> list[int]:
    """The samples at which ``q`` [K] has stopped dead for ``stay`` samples or more."""
    if len(q) < stay + BEFORE_STAY + 1:
        return []
    step = np.diff(q)
    top = float(np.quantile(np.abs(q[BEFORE_STAY:] - q[:-BEFORE_STAY]), 0.99)) / BEFORE_STAY
    # A hand at an arm that rests, or a step of its encoder, is no motion that stops.
    least = max(STUCK_SPEED * top, STUCK_LEAST * period) * BEFORE_STAY
    edges: Rows = np.flatnonzero(np.diff(np.r_[0, (step == 0).astype(np.int8), 0]))
    rows: list[int] = []
    for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if b - a < stay or a < BEFORE_STAY:
            continue
        if abs(float(q[a] - q[a - BEFORE_STAY])) > least:
            rows += range(a + 1, b + 1)
    return rows
