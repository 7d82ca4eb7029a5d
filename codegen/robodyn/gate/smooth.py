"""Signals of a log for judging it: smoothed alike, with the positions' rates; nothing is fitted to them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.flag import Floats
from robodyn.gate.limits import SMOOTHING_LEAST, SMOOTHING_REACH
from robodyn.logs.log import Log


@dataclass(frozen=True, slots=True, eq=False)
class Smooth:
    """``q, qd, qdd, tau`` [K, n] from the positions and torques, and the logged rates smoothed alike (None
    where there are none); ``inside`` [K] are the samples away from the ends of the segments."""

    q: Floats
    qd: Floats
    qdd: Floats
    tau: Floats
    logged_qd: Floats | None
    logged_qdd: Floats | None
    inside: NDArray[np.bool_]


def smoothed(log: Log, segments: Sequence[slice], period: float) -> Smooth:
    """The signals of ``log``, through the same local parabola over :data:`SMOOTHING_REACH`."""
    window = max(SMOOTHING_LEAST, 2 * round(SMOOTHING_REACH / (2 * period)) + 1)
    q, qd, qdd, tau = (np.zeros_like(log.q) for _ in range(4))
    rate = None if log.qd is None else np.zeros_like(log.q)
    second = None if log.qdd is None else np.zeros_like(log.q)
    inside = np.zeros(log.samples, dtype=bool)
    for part in segments:
        if part.stop - part.start < window:
            continue
        q[part] = _parabola(log.q[part], window, period, 0)
        qd[part] = _parabola(log.q[part], window, period, 1)
        qdd[part] = _parabola(log.q[part], window, period, 2)
        tau[part] = _parabola(log.tau[part], window, period, 0)
        if rate is not None and log.qd is not None:
            rate[part] = _parabola(log.qd[part], window, period, 0)
        if second is not None and log.qdd is not None:
            second[part] = _parabola(log.qdd[part], window, period, 0)
        # A longer piece loses more at its ends, where filters of other people reach in.
        edge = min(window, (part.stop - part.start) // 4)
        inside[part.start + edge : part.stop - edge] = True
    return Smooth(q, qd, qdd, tau, rate, second, inside)


def _parabola(x: Floats, window: int, period: float, derivative: int) -> Floats:
    """Savitzky-Golay smoothing of second order, or a derivative of it."""
    from scipy.signal import savgol_filter

    smooth: Floats = savgol_filter(x, window, 2, deriv=derivative, delta=period, axis=0, mode="nearest")
    return smooth


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
