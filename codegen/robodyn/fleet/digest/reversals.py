"""What is left of a torque while its joint moves on, and whether it comes in bursts where the load changes
sign.

Where a joint turns round, its friction does what no column says. Elsewhere little is left, and a joint with
play shows: it passes its load from one flank of the teeth to the other where the load changes sign, and the
link strikes (Nordin and Gutman 2002); friction, springs and sensors know nothing of the load's sign.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.library.context import context_of
from robodyn.fleet.digest.limits import BURST, LEAST_BURSTS, SLOW_SHARE, TURNING
from robodyn.identify.rows import Rows
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import Signals

Floats = NDArray[np.float64]


def squares_on_the_way(model: Model, signals: Signals, rows: Rows, left: list[Floats | None]) -> Floats:
    """Of what is ``left`` [M] of each joint's torque (None: nothing was fitted) the sum of squares and the
    number of samples, shortly after the load of the joint has changed its sign and otherwise, where the joint
    does not turn round: [n, 2, 2]."""
    context = context_of(model, signals)
    loads = signals.thinned(signals.filtered(context.at.passed))
    sums = np.zeros((model.robot.n, 2, 2))
    for j, each in enumerate(left):
        if each is None:
            continue
        speed = np.abs(rows.qd[:, j])
        turns = np.diff(np.signbit(rows.qd[:, j]))
        moves_on = speed > SLOW_SHARE * np.sqrt(np.mean(speed**2))
        reach = round(TURNING / rows.step)
        moves_on &= ~_near(turns, reach, reach)
        struck = _near(np.diff(np.signbit(loads[:, j])), 0, max(1, round(BURST / rows.step)))
        for k, which in enumerate((moves_on & struck, moves_on & ~struck)):
            sums[j, k] = float(each[which] @ each[which]), float(which.sum())
    return sums


def _near(events: NDArray[np.bool_], before: int, after: int) -> NDArray[np.bool_]:
    """Which samples [M] are within so many of an event between two of them [M - 1]."""
    near = np.zeros(len(events) + 1, dtype=bool)
    for k in np.flatnonzero(events).tolist():
        near[max(0, k - before) : k + after + 1] = True
    return near


def left_of(sums: Floats) -> Floats:
    """By joint [n] the RMS of what is left; nan where there were too few samples."""
    squares, count = sums[:, :, 0].sum(axis=1), sums[:, :, 1].sum(axis=1)
    return np.where(count >= LEAST_BURSTS, np.sqrt(squares / np.maximum(count, 1)), np.nan)


def excess(sums: Floats) -> Floats:
    """By joint [n] how many times larger, as a logarithm, the RMS is after reversals of the load than
    otherwise; nan where there were too few of either."""
    with np.errstate(all="ignore"):
        squares = sums[:, :, 0] / sums[:, :, 1]
        ratio = 0.5 * np.log(squares[:, 0] / squares[:, 1])
    return np.where(np.isfinite(ratio) & (sums[:, :, 1].min(axis=1) >= LEAST_BURSTS), ratio, np.nan)
