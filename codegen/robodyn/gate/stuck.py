"""Positions that stay on one number while the joint goes on: of a frozen sensor, or beyond its range."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.gate.flag import Flag, Rows, refuse
from robodyn.gate.grid import Grid
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot


def check_stuck(grid: Grid, robot: Robot, flags: list[Flag]) -> NDArray[np.bool_]:
    """Flags on positions that stop dead, and at which samples [K] one does; a joint that comes to rest slows
    down before, unless friction and drive can stop it within a sample.

    Raises
    ------
    InputError: they do so in too many samples.
    """
    log = grid.log
    stuck = np.zeros(log.samples, dtype=bool)
    fewest = max(limits.STAY_ROWS, round(limits.STAY_TIME / grid.period))
    for j in range(log.n):
        stays = [
            (part.start + first, part.start + last, speed)
            for part in grid.segments
            for first, last, speed in _stays(log.q[part, j], fewest, grid.period)
        ]
        if not stays:
            continue
        inertia = _felt_inertia(Model(robot), log.q[[first for first, _, _ in stays]], j)
        shed = limits.BRAKING_TORQUES * float(np.abs(log.tau[:, j]).max()) * grid.period
        rows = [
            row
            for (first, last, speed), own in zip(stays, inertia.tolist(), strict=True)
            if speed * own > shed
            for row in range(first + 1, last + 1)
        ]
        if not rows:
            continue
        stuck[rows] = True
        spans = grid.spans(np.array(rows, dtype=np.intp))
        share = len(rows) / log.samples
        if share > limits.BROKEN_SHARE:
            refuse(
                f"q{j + 1} stops dead and stays on one number while the joint moves",
                found=f"{log.q[rows[0], j]:.6g} in {spans[0]}, {share:.0%} of the samples in all",
                expected="positions that follow the motion",
                remedy="see whether the sensor freezes, or its range ends there; leave such rows out",
            )
        text = f"stops dead and stays on one number in {share:.1%} of the samples: frozen?"
        flags.append(Flag("stuck", f"q{j + 1}", spans, text, (j + 1,)))
    return stuck


def _stays(q: Floats, fewest: int, period: float) -> list[tuple[int, int, float]]:
    """Where ``q`` [K] moves and then stays on one number for ``fewest`` samples or more: the first and the
    last sample, and the speed before."""
    if len(q) < fewest + limits.BEFORE_STAY + 1:
        return []
    step = np.diff(q)
    top = (
        float(np.quantile(np.abs(q[limits.BEFORE_STAY :] - q[: -limits.BEFORE_STAY]), 0.99))
        / limits.BEFORE_STAY
    )
    # A hand at an arm that rests, or a step of its encoder, is no motion that stops.
    least = max(limits.STUCK_SPEED * top, limits.STUCK_LEAST * period) * limits.BEFORE_STAY
    edges: Rows = np.flatnonzero(np.diff(np.r_[0, (step == 0).astype(np.int8), 0]))
    stays = []
    for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if b - a < fewest or a < limits.BEFORE_STAY:
            continue
        way = abs(float(q[a] - q[a - limits.BEFORE_STAY]))
        if way > least:
            stays.append((a, b, way / (limits.BEFORE_STAY * period)))
    return stays


def _felt_inertia(model: Model, q: Floats, j: int) -> Floats:
    """What a torque at joint ``j`` accelerates while the other joints are free, at poses ``q`` [K, n]:
    [K] in kg m^2 or kg; 0 where the description gives it none."""
    matrices = model.mass_matrix(q)
    others = [i for i in range(q.shape[1]) if i != j]
    inner = np.linalg.pinv(matrices[:, others][:, :, others], hermitian=True)
    beside = matrices[:, others, j]
    return np.asarray(matrices[:, j, j] - np.einsum("ka,kab,kb->k", beside, inner, beside))
