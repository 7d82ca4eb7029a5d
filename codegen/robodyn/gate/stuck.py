"""Positions that stay on one number while the joint goes on: of a frozen sensor, or beyond its range."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from robodyn.gate.flag import Flag, Floats, Rows, refuse
from robodyn.gate.grid import Grid
from robodyn.gate.limits import (
    BEFORE_STAY,
    BRAKING_TORQUES,
    STAY_ROWS,
    STAY_TIME,
    STUCK_LEAST,
    STUCK_SHARE,
    STUCK_SPEED,
)
from robodyn.kernels.array_dynamics import Model
from robodyn.robot.model import Robot


@dataclass(frozen=True, slots=True)
class _Stay:
    """Samples ``first`` to ``last`` in which a position does not change; ``speed`` before [rad/s or m/s]."""

    first: int
    last: int
    speed: float


def check_stuck(
    grid: Grid,
    robot: Robot,
    parameters: Mapping[str, float] | None,
    source: str | None,
    flags: list[Flag],
) -> None:
    """Flags on positions that stop dead; a joint that comes to rest slows down before, unless friction and
    drive can stop it within a sample.

    Raises
    ------
    InputError: they do so in too many samples.
    """
    log = grid.log
    fewest = max(STAY_ROWS, round(STAY_TIME / grid.period))
    for j in range(log.n):
        stays = [
            _Stay(part.start + stay.first, part.start + stay.last, stay.speed)
            for part in grid.segments
            for stay in _stays(log.q[part, j], fewest, grid.period)
        ]
        if not stays:
            continue
        inertia = _felt_inertia(Model(robot, parameters), log.q[[stay.first for stay in stays]], j)
        shed = BRAKING_TORQUES * float(np.abs(log.tau[:, j]).max()) * grid.period
        rows = [
            row
            for stay, own in zip(stays, inertia.tolist(), strict=True)
            if stay.speed * own > shed
            for row in range(stay.first + 1, stay.last + 1)
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


def _stays(q: Floats, fewest: int, period: float) -> list[_Stay]:
    """Where ``q`` [K] moves and then stays on one number for ``fewest`` samples or more."""
    if len(q) < fewest + BEFORE_STAY + 1:
        return []
    step = np.diff(q)
    top = float(np.quantile(np.abs(q[BEFORE_STAY:] - q[:-BEFORE_STAY]), 0.99)) / BEFORE_STAY
    # A hand at an arm that rests, or a step of its encoder, is no motion that stops.
    least = max(STUCK_SPEED * top, STUCK_LEAST * period) * BEFORE_STAY
    edges: Rows = np.flatnonzero(np.diff(np.r_[0, (step == 0).astype(np.int8), 0]))
    stays = []
    for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        if b - a < fewest or a < BEFORE_STAY:
            continue
        way = abs(float(q[a] - q[a - BEFORE_STAY]))
        if way > least:
            stays.append(_Stay(a, b, way / (BEFORE_STAY * period)))
    return stays


def _felt_inertia(model: Model, q: Floats, j: int) -> Floats:
    """What a torque at joint ``j`` accelerates while the other joints are free, at poses ``q`` [K, n]:
    [K] in kg m^2 or kg; 0 where the description gives it none."""
    matrices = model.mass_matrix(q)
    others = [i for i in range(q.shape[1]) if i != j]
    inner = np.linalg.pinv(matrices[:, others][:, :, others], hermitian=True)
    beside = matrices[:, others, j]
    return np.asarray(matrices[:, j, j] - np.einsum("ka,kab,kb->k", beside, inner, beside))
