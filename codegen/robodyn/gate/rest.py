"""Where joints stand still: stiction holds them there with any torque within its level."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.flag import Floats
from robodyn.gate.limits import (
    REST_NOISE,
    REST_SPEED,
    REST_TIME,
    REST_WAY,
    SMOOTHING_LEAST,
    SMOOTHING_REACH,
    STILL_SPEED,
)

Mask = NDArray[np.bool_]


def resting(
    q: Floats,
    segments: Sequence[slice],
    period: float,
    *,
    noise: Floats,
    steps: Floats,
    revolute: Sequence[bool],
) -> Mask:
    """Where [K, n] joints with positions ``q`` [K, n] stand still, for :data:`REST_TIME` at least, so that a
    reversal is no rest.

    ``noise``, ``steps`` [n]: the standard deviation of the positions' noise, and the step of their encoders.
    """
    reach = max(SMOOTHING_LEAST // 2, round(SMOOTHING_REACH / (2 * period)))
    least = max(3, round(REST_TIME / period))
    speed = np.zeros_like(q)
    for part in segments:
        x = q[part]
        places = np.arange(len(x))
        before, after = np.maximum(places - reach, 0), np.minimum(places + reach, len(x) - 1)
        speed[part] = np.abs(x[after] - x[before]) / (np.maximum(after - before, 1)[:, None] * period)
    top = np.quantile(speed[:: max(1, len(speed) // 20_000)], 0.99, axis=0)
    slow = np.where(revolute, REST_SPEED, REST_WAY)
    # A step of the encoder in the window looks like a speed, and so does noise at both of its ends.
    unsure = (1.01 * steps + REST_NOISE * np.sqrt(2) * noise) / (2 * reach * period)
    still = speed < np.maximum(np.maximum(STILL_SPEED * top, slow), unsure)
    result: Mask = np.zeros(q.shape, dtype=bool)
    for part in segments:
        for j in range(q.shape[1]):
            result[part, j] = _long(still[part, j], least)
    return result


def _long(still: Mask, least: int) -> Mask:
    """Runs of ``still`` [K] of ``least`` samples or more."""
    edges = np.flatnonzero(np.diff(np.r_[0, still.astype(np.int8), 0]))
    result: Mask = np.zeros(len(still), dtype=bool)
    for a, b in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        result[a:b] = b - a >= least
    return result
