"""From a log to signals that a model can be held to: filtered positions, their rates, and one filter for all.

Source: Gautier 1997 (parallel filtering: what is compared goes through the same zero-phase filter).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from robodyn.arrays import Floats
from robodyn.logs.limits import (
    CONTINUED,
    ENOUGH_CUTOFF,
    FILTER_ORDER,
    HIGHEST_CUTOFF,
    LEAST_RATE,
    LOWEST_CUTOFF,
    MOTION_ABOVE,
    MOTION_OVER_NOISE,
)
from robodyn.logs.log import Log


@dataclass(frozen=True, slots=True, eq=False)
class Signals:
    """A log's motion and torque: ``t`` [K] in s, even; ``q, qd, qdd`` [K, n] of filtered positions; ``tau``
    [K, n] as logged; ``cutoff`` [Hz] of the filter of :meth:`filtered`; ``every``: what :meth:`thinned`
    keeps, but for ``edge`` samples at either end; ``acceleration_noise`` [n]: standard deviations of
    the noise that the accelerations have from the encoders, after :meth:`filtered`; ``torque_noise`` [n]:
    those of the torque channel's noise, unfiltered; ``motion`` [Hz]: the cutoff of the filter that positions
    went through, None where they did not; ``position_noise`` [n]: standard deviations of the encoders'
    noise before that."""

    t: Floats
    q: Floats
    qd: Floats
    qdd: Floats
    tau: Floats
    cutoff: float
    every: int
    edge: int
    acceleration_noise: Floats | None = None
    torque_noise: Floats | None = None
    motion: float | None = None
    position_noise: Floats | None = None

    @property
    def period(self) -> float:
        """Time between samples [s]."""
        return float(self.t[1] - self.t[0])

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q.shape[1])

    @property
    def speed_noise(self) -> Floats:
        """Standard deviations [n] of the encoders' noise in the speeds."""
        if self.position_noise is None or self.motion is None:
            return np.zeros(self.n)
        f = np.linspace(0.0, min(3 * self.motion, 0.5 / self.period), 500)
        passed = 2 * np.pi * f / (1 + (f / self.motion) ** (2 * FILTER_ORDER))
        share = np.sqrt(2 * self.period * np.sum(passed**2) * (f[1] - f[0]))
        return np.asarray(self.position_noise * share)

    def filtered(self, x: Floats) -> Floats:
        """``x`` [K, ...] through the zero-phase low-pass."""
        return low_pass(x, 1 / self.period, self.cutoff)

    def thinned(self, x: Floats) -> Floats:
        """Of ``x`` [K, ...], filtered, as many samples as its band needs, without the filter's ends."""
        return x[self.used]

    @property
    def used(self) -> slice:
        """The samples of a filtered signal that are used."""
        return slice(self.edge, len(self.t) - self.edge, self.every)

    def coarse(self) -> Signals:
        """The same at a rate that still carries what the filter passes: for columns that are smooth."""
        step = max(1, self.every // 2)
        if step == 1:
            return self
        arrays = (self.t, self.q, self.qd, self.qdd, self.filtered(self.tau))
        t, q, qd, qdd, tau = (x[::step] for x in arrays)
        return Signals(
            t, q, qd, qdd, tau, self.cutoff, self.every // step, self.edge // step,
            self.acceleration_noise, self.torque_noise, self.motion,
        )  # fmt: skip


def signals_of(log: Log, *, cutoff: float | None = None, wider: float = 1.0) -> Signals:
    """Signals of an evenly sampled log. What moves above the cutoff is kept as well, up to ``wider`` times
    it, as far as it stands out of the encoders' noise: torques of a motion that was low-passed would be so
    twice, and those that were measured once."""
    t = log.t
    period = float((t[-1] - t[0]) / (len(t) - 1))
    rate = 1 / period
    chosen = cutoff or knee(log.q, rate)
    motion = motion_cutoff(log.q, rate, chosen, wider)
    smooth, qd, qdd = _moving(log.q, period, motion)
    every = thinning(rate, chosen)
    edge = every * max(1, round(min(1.5 / chosen * rate, len(t) / 20) / every))
    # So many samples that coarse signals have the same places.
    count = (len(t) - 1) // every * every + 1
    position_noise = 1.4826 * np.median(np.abs(log.q - smooth), axis=0)
    t, smooth, qd, qdd, tau = (x[:count] for x in (t, smooth, qd, qdd, log.tau))
    return Signals(
        t, smooth, qd, qdd, tau, chosen, every, edge,
        position_noise * _acceleration_noise(chosen, motion, rate), _raw_noise(tau), motion, position_noise,
    )  # fmt: skip


def _moving(q: Floats, period: float, cutoff: float) -> tuple[Floats, Floats, Floats]:
    """Positions [K, n] through their filter, and their rates."""
    smooth = smoothed_motion(q, 1 / period, cutoff)
    qd = rates(smooth, period)
    return smooth, qd, rates(qd, period)


def rates(x: Floats, period: float) -> Floats:
    """Rates of a smooth signal [K, ...] by central differences of fourth order: those of second order make
    accelerations of a motion of 3 Hz that is sampled at 200 Hz too small by a third of a percent."""
    if len(x) < 2:
        return np.zeros_like(x)
    rate = np.asarray(np.gradient(x, period, axis=0, edge_order=2 if len(x) > 2 else 1))
    if len(x) > 4:
        rate[2:-2] = (8 * (x[3:-1] - x[1:-3]) - (x[4:] - x[:-4])) / (12 * period)
    return rate


def thinning(rate: float, cutoff: float = ENOUGH_CUTOFF) -> int:
    """Every how many samples, which come at a ``rate`` [Hz], carry what a filter with the ``cutoff`` [Hz]
    passes: an even number, for coarse signals have half of it."""
    cutoff = min(cutoff, HIGHEST_CUTOFF * rate)
    return max(2 * int(rate / (8 * cutoff)), 2 if rate > LEAST_RATE * cutoff else 1)


def _raw_noise(tau: Floats) -> Floats:
    """Standard deviations [n] of the noise of torques [K, n], from second differences."""
    second = np.diff(tau, 2, axis=0)
    deviation: Floats = 1.4826 * np.median(np.abs(second - np.median(second, axis=0)), axis=0) / np.sqrt(6)
    return deviation


def _acceleration_noise(cutoff: float, motion: float, rate: float) -> float:
    """The acceleration [1/s^2] by white noise of size 1 in positions, as passes of :func:`low_pass` at the
    cutoffs of the ``motion`` and of what is compared leave it."""
    f = np.linspace(0.0, min(3 * cutoff, rate / 2), 500)
    passed = 1 / (1 + (f / cutoff) ** (2 * FILTER_ORDER)) / (1 + (f / motion) ** (2 * FILTER_ORDER))
    return float(np.sqrt(2 / rate * np.sum(((2 * np.pi * f) ** 2 * passed) ** 2) * (f[1] - f[0])))


def smoothed_motion(q: Floats, rate: float, cutoff: float) -> Floats:
    """Positions [K, n] through the low-pass, both ends continued by the cubic that fits them best: mirrored,
    as filters do it, an end turns its acceleration round."""
    reach = round(CONTINUED * rate / cutoff)
    if reach < 8 or len(q) < 2 * reach:
        return low_pass(q, rate, cutoff)
    ends = []
    for part, way in ((q[:reach], -1), (q[-reach:], 1)):
        at = np.linspace(-1, 1, reach)
        beyond = (1 + (1 + np.arange(reach)) * (at[1] - at[0])) * way
        fit = np.polynomial.polynomial.polyfit(at, part, 3)
        ends.append(np.polynomial.polynomial.polyval(np.sort(beyond), fit).T)
    whole = np.concatenate([ends[0], q, ends[1]])
    return low_pass(whole, rate, cutoff)[reach : reach + len(q)]


def low_pass(x: Floats, rate: float, cutoff: float) -> Floats:
    """A Butterworth filter of order 4, run forth and back over the first axis; no filter above the band."""
    from scipy.signal import sosfiltfilt

    if cutoff >= 0.45 * rate or len(x) < 30:
        return x
    filtered: Floats = sosfiltfilt(_sections(rate, cutoff), x, axis=0)
    return filtered


@lru_cache(maxsize=32)
def _sections(rate: float, cutoff: float) -> Floats:
    from scipy.signal import butter

    return np.asarray(butter(FILTER_ORDER, cutoff, fs=rate, output="sos"))


def motion_cutoff(q: Floats, rate: float, cutoff: float, wider: float) -> float:
    """The cutoff [Hz] that leaves positions [K, n] what stands out of the noise: from ``cutoff`` to ``wider``
    times that."""
    return min(max(cutoff, MOTION_ABOVE * highest_motion(q, rate)), wider * cutoff)


def highest_motion(q: Floats, rate: float) -> float:
    """The highest frequency [Hz] at which positions [K, n] stand out of the noise."""
    frequencies = np.fft.rfftfreq(len(q), 1 / rate)
    above = np.zeros(len(frequencies), dtype=bool)
    for power, floor in _spectra(q):
        above |= power > MOTION_OVER_NOISE * floor
    return float(frequencies[above].max(initial=0.0))


def _spectra(q: Floats) -> Iterator[tuple[Floats, float]]:
    """Of each joint's positions [K, n] less a straight line: power by frequency, and that of the noise."""
    window = np.hanning(len(q))
    for x in q.T:
        line = np.linspace(x[0], x[-1], len(x))
        power = np.abs(np.fft.rfft((x - line) * window)) ** 2
        yield power, float(np.median(power[len(power) // 2 :])) + 1e-30 * float(power.max())


def knee(q: Floats, rate: float) -> float:
    """Cutoff [Hz] above what moves: three times the highest frequency that stands out of the noise."""
    highest = LOWEST_CUTOFF
    frequencies = np.fft.rfftfreq(len(q), 1 / rate)
    for power, floor in _spectra(q):
        above = np.nonzero(power > 1e3 * floor)[0]
        if len(above):
            # What carries the motion, not the last line that peeps out.
            share = np.cumsum(power[1:] * frequencies[1:] ** 4)
            if share[-1] > 0:
                carried = frequencies[1:][np.searchsorted(share, 0.99 * share[-1])]
                highest = max(highest, min(float(frequencies[above[-1]]), 3 * float(carried)))
    return float(min(max(LOWEST_CUTOFF, 2.5 * highest), ENOUGH_CUTOFF, HIGHEST_CUTOFF * rate))
