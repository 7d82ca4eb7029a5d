"""Through which filter a log's motion is seen where models are set beside raw torques.

Too low a cutoff smooths what accelerations do at reversals, too high a one carries the encoders' noise
through two derivatives and the arm's inertias (rotors that no description has included) into the model's
torque. Both are errors of the same torque: what plain least squares leave of it is least where their sum is.
Nothing needs to be believed of how noisy signals are, which those that were smoothed before they were logged
do not say. The same figure tells whether steps of dry friction are to go through the filter: under stiff
control the torque has them, under soft control the acceleration.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.gate import Gate
from robodyn.identify.limits import BAND_LOST, BAND_WORTH, HIGHER_STEPS, LOWER_STEPS
from robodyn.identify.normal import Layout, blocks_of, layout_of
from robodyn.identify.plain import plain
from robodyn.identify.predict import cutoff_of
from robodyn.identify.residual import Squares, squares_of
from robodyn.identify.rows import bare, rows_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.limits import HIGHEST_CUTOFF, LOWEST_CUTOFF
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


def banded(robot: Robot, gates: Sequence[Gate]) -> list[Gate]:
    """The logs with a cutoff above which nothing more of ``robot`` shows in their torques."""
    layout = layout_of(robot.n, rotors=robot.torque_side == "motor", offsets=False)
    pieces = [piece for k, gate in enumerate(gates) for piece in rows_of(robot, gate, k)]
    if not pieces or all(gate.stands for gate in gates):
        return list(gates)
    blocks, _ = blocks_of(Model(bare(robot)).arm, layout, pieces)
    return with_cutoff(robot, layout, gates, plain(layout, blocks)[0])


def with_cutoff(robot: Robot, layout: Layout, gates: Sequence[Gate], x: Floats) -> list[Gate]:
    """The logs seen through the filter with which parameters ``x`` [p] in the ``layout`` leave least of them,
    the mean over the joints. From the cutoff above what moves: lower where noise asks for it, then with
    friction that jumps or not, then higher."""
    usual = max(cutoff_of(gate, max(gate.segments, key=lambda p: p.stop - p.start)) for gate in gates)
    best = _seen(gates, usual, False)
    first = _left(robot, layout, best, x)
    least = 1.0

    def share(trial: Sequence[Gate]) -> float:
        return float(np.mean(_left(robot, layout, trial, x) / np.maximum(first, 1e-300)))

    lowered = False
    for step in LOWER_STEPS:
        trial = _seen(gates, max(usual * step, LOWEST_CUTOFF), False)
        less = share(trial)
        if less > least - BAND_WORTH:
            break
        best, least, lowered = trial, less, True
    trial = [replace(gate, blurred=True) for gate in best]
    less = share(trial)
    if less < least - BAND_WORTH:
        best, least = trial, less
    blurred = best[0].blurred
    for step in () if lowered else HIGHER_STEPS:
        before, trial = trial, _seen(gates, usual * step, blurred)
        if [gate.cutoff for gate in trial] == [gate.cutoff for gate in before]:
            break  # the sampling rate carries no more
        less = share(trial)
        if less < least - BAND_WORTH:
            best, least = trial, less
        elif less > least + BAND_LOST:
            break
    return best


def _seen(gates: Sequence[Gate], cutoff: float, blurred: bool) -> list[Gate]:
    return [
        replace(gate, cutoff=min(cutoff, HIGHEST_CUTOFF / gate.period), blurred=blurred) for gate in gates
    ]


def _left(robot: Robot, layout: Layout, gates: Sequence[Gate], x: Floats) -> Floats:
    """The RMS [n] of what parameters ``x`` [p] leave of the logs' torques."""
    sums: list[Squares] = [squares_of(robot, layout, gate, x[None]) for gate in gates]
    whole = sums[0]
    for other in sums[1:]:
        whole = whole + other
    return np.asarray(whole.rms()[0])
