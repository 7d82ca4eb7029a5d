"""Signals of a log for judging it: smoothed alike, with the positions' rates; nothing is fitted to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.gate import limits
from robodyn.logs.log import Log


@dataclass(frozen=True, slots=True, eq=False)
class Smooth:
    """``q, qd, qdd, tau`` [K, n] from the positions and torques, the directions of motion ``way``, and the
    logged rates, smoothed alike (None where there are none); ``inside`` [K] are the samples away from the
    ends of the segments and from what is stuck."""

    q: Floats
    qd: Floats
    qdd: Floats
    tau: Floats
    way: Floats
    inside: NDArray[np.bool_]
    logged_qd: Floats | None = None
    logged_qdd: Floats | None = None


def smoothed(log: Log, segments: Sequence[slice], period: float, stuck: NDArray[np.bool_]) -> Smooth:
    """The signals of ``log``, through the same local parabola over :data:`.limits.SMOOTHING_REACH`, but for
    where a position is ``stuck`` [K]."""
    from scipy.ndimage import maximum_filter1d

    window = max(limits.SMOOTHING_LEAST, 2 * round(limits.SMOOTHING_REACH / (2 * period)) + 1)
    kinds: dict[str, Any] = {
        "q": (log.q, 0), "qd": (log.q, 1), "qdd": (log.q, 2), "tau": (log.tau, 0), "way": (log.q, 1),
        "logged_qd": (log.qd, 0), "logged_qdd": (log.qdd, 0),
    }  # fmt: skip
    signals = {name: np.zeros_like(x) for name, (x, _) in kinds.items() if x is not None}
    inside = np.zeros(log.samples, dtype=bool)
    for part in segments:
        if part.stop - part.start < window:
            continue
        for name, smooth in signals.items():
            x, derivative = kinds[name]
            smooth[part] = _parabola(x[part], window, period, derivative)
        # A longer piece loses more at its ends, where filters of other people reach in.
        edge = min(window, (part.stop - part.start) // 4)
        inside[part.start + edge : part.stop - edge] = True
    inside &= maximum_filter1d(stuck.astype(np.int8), 2 * window + 1) == 0
    speed = signals["way"]
    slow = limits.RESOLVED_SHARE * np.sqrt((speed[inside] ** 2).sum(axis=0) / max(inside.sum(), 1))
    for part in segments:
        if part.stop - part.start >= window:
            speed[part] = _parabola(np.clip(speed[part] / (slow + 1e-12), -1, 1), window, period, 0)
    return Smooth(**signals, inside=inside)


def _parabola(x: Floats, window: int, period: float, derivative: int) -> Floats:
    """Savitzky-Golay smoothing of second order, or a derivative of it."""
    from scipy.signal import savgol_filter

    smooth = savgol_filter(x, window, 2, deriv=derivative, delta=period, axis=0, mode="nearest")
    return np.asarray(smooth)


def noise_of(x: Floats, segments: Sequence[slice]) -> Floats:
    """Standard deviation [n] of what is white in ``x`` [K, n], from differences of second to fifth order: the
    least of them, for the signal itself is in all and the less the higher they are."""
    best = np.full(x.shape[1], np.inf)
    pieces = [x[part] for part in segments if part.stop - part.start > 10]
    for order in range(2, 6):
        # The squares of binomial coefficients add up to the middle one of twice the order.
        gain = float(np.sqrt(np.prod([(order + k) / k for k in range(1, order + 1)])))
        for j in range(x.shape[1] if pieces else 0):  # one by one: logs are long
            differences = np.concatenate([np.diff(piece[:, j], order) for piece in pieces])
            best[j] = min(best[j], 1.4826 * float(np.median(np.abs(differences))) / gain)
    return np.where(np.isfinite(best), best, 0.0)
