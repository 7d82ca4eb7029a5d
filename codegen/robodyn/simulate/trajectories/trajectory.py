"""A motion of the joints, sampled and in between."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError

#: Positions, velocities and accelerations [K, n] at times [K] (s).
Law = Callable[[Floats], tuple[Floats, Floats, Floats]]

#: Time from sample to sample [s] unless another is asked for.
PERIOD = 1e-3
_UNEVEN = 1e-2  # share of a period that a sample may be off its place
_LONGEST = 50_000_000  # samples times joints


@dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """Joint positions ``q``, velocities ``qd`` and accelerations ``qdd`` [K, n] at even times ``t`` [K].

    Rad or m, per second and per second squared, and s; ``t`` starts at 0. Arrays are copied and read-only.
    ``law`` gives the motion at any time from 0 to the end; by default polynomials of degree five between
    the samples. ``provenance`` says how the motion was made. Where the acceleration jumps, a sample has
    the value after the jump.

    Raises
    ------
    InputError: arrays that do not fit each other, fewer than two samples, uneven times, numbers that are not
        finite.
    """

    t: Floats
    q: Floats
    qd: Floats
    qdd: Floats
    provenance: Mapping[str, Any] = field(default_factory=dict)
    law: Law | None = field(default=None, repr=False)

    def __post_init__(self) -> None:
        arrays = {name: np.array(getattr(self, name), dtype=np.float64) for name in ("t", "q", "qd", "qdd")}
        t, q = arrays["t"], arrays["q"]
        if t.ndim != 1 or q.ndim != 2 or len(t) < 2 or q.shape[1] < 1:
            raise InputError(
                "this is no trajectory",
                found=", ".join(f"{name} {list(array.shape)}" for name, array in arrays.items()),
                expected="t [K] and q, qd, qdd [K, n], K at least 2",
            )
        for name, array in arrays.items():
            if array.shape != (t.shape if name == "t" else (len(t), q.shape[1])):
                raise InputError(
                    f"{name} of a trajectory has the wrong shape",
                    found=str(list(array.shape)),
                    expected=str([len(t)] if name == "t" else [len(t), q.shape[1]]),
                )
            if not np.isfinite(array).all():
                sample = int(np.argwhere(~np.isfinite(array))[0][0])
                raise InputError(f"{name} of a trajectory is not finite", found=f"sample {sample + 1}")
        uneven = uneven_sample(t)
        if t[0] != 0 or uneven is not None:
            raise InputError(
                "the times of a trajectory are not even",
                found=f"t = {t[uneven or 0]!r} at sample {(uneven or 0) + 1}",
                expected="0, h, 2 h, ... s",
            )
        for name, array in arrays.items():
            array.setflags(write=False)
            object.__setattr__(self, name, array)

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.q.shape[1])

    @property
    def period(self) -> float:
        """Time from sample to sample [s]."""
        return self.duration / (len(self.t) - 1)

    @property
    def duration(self) -> float:
        """Time of the last sample [s]."""
        return float(self.t[-1])

    def __len__(self) -> int:
        return len(self.t)

    def at(self, t: Floats) -> tuple[Floats, Floats, Floats]:
        """``q, qd, qdd`` [K, n] at any times ``t`` [K] (s) from 0 to the end."""
        times = np.atleast_1d(np.asarray(t, dtype=np.float64))
        if not ((times >= 0) & (times <= self.duration * (1 + 1e-12))).all():
            raise InputError(
                "a time outside the trajectory",
                found=f"{times.min():.6g} to {times.max():.6g} s",
                expected=f"0 to {self.duration:.6g} s",
            )
        law = self.law or partial(hermite, self.t, self.q, self.qd, self.qdd)
        return law(times)

    def sampled(self, period: float) -> Trajectory:
        """The same motion at another period [s], up to the last sample that lies within it."""
        t = sample_times(self.duration, period, beyond=False)
        return Trajectory(t, *self.at(t), self.provenance, self.law)

    def describe(self) -> dict[str, Any]:
        """What the motion is, for the provenance of a log: plain numbers, lists and words."""
        return {**self.provenance, "period": self.period, "samples": len(self), "duration": self.duration}


def sample_times(duration: float, period: float, *, beyond: bool) -> Floats:
    """Times [K] (s) from 0 to ``duration`` every ``period``; where that does not divide it, the last is after
    the end (``beyond``: the arm stands there) or before it.

    Raises
    ------
    InputError: a duration or period that is not positive, or too many samples.
    """
    if not (0 < period < np.inf and 0 < duration < np.inf):
        raise InputError(
            "a trajectory takes time", found=f"{duration!r} s every {period!r} s", expected="positive numbers"
        )
    steps = duration / period
    if steps > _LONGEST:
        raise InputError(
            "a trajectory of too many samples", found=f"{steps:.3g}", expected=f"at most {_LONGEST}"
        )
    slack = 1e-9 * max(1.0, steps)
    whole = int(np.ceil(steps - slack) if beyond else np.floor(steps + slack))
    if whole < 1:
        raise InputError(
            "a trajectory of fewer than two samples",
            found=f"{duration:.6g} s",
            expected=f"{period:.6g} s or more",
        )
    if abs(steps - whole) <= slack:
        return np.asarray(np.arange(whole + 1) * (duration / whole), dtype=np.float64)
    return np.asarray(np.arange(whole + 1) * period, dtype=np.float64)


def uneven_sample(t: Floats) -> int | None:
    """The first sample of ``t`` [K] that is off even spacing; None where there is none."""
    step = (t[-1] - t[0]) / (len(t) - 1)
    if not step > 0:
        return len(t) - 1
    off = np.flatnonzero(~(np.abs(t - t[0] - step * np.arange(len(t))) <= _UNEVEN * step))
    return int(off[0]) if len(off) else None


def joint_vector(what: str, values: Any, n: int | None = None) -> Floats:
    """``values`` as finite numbers [n].

    Raises
    ------
    InputError: they are not.
    """
    array = np.atleast_1d(np.asarray(values, dtype=np.float64))
    if array.ndim != 1 or not np.isfinite(array).all() or (n is not None and len(array) != n):
        raise InputError(
            f"{what} is not a number a joint",
            found=str(np.asarray(values).tolist()),
            expected=f"[{'n' if n is None else n}], finite",
        )
    return array


# --- polynomials of degree five between knots ---------------------------------------------------------------


def hermite(knots: Floats, x: Floats, v: Floats, a: Floats, t: Floats) -> tuple[Floats, Floats, Floats]:
    """Values, first and second derivatives [K, n] at ``t`` [K] of the pieces of degree five that have the
    values ``x``, derivatives ``v`` and second derivatives ``a`` [m, n] at ``knots`` [m]."""
    i = np.clip(np.searchsorted(knots, t, side="right") - 1, 0, len(knots) - 2)
    h = (knots[i + 1] - knots[i])[:, None]
    s = (t - knots[i])[:, None] / h
    v0, v1, a0, a1 = v[i] * h, v[i + 1] * h, a[i] * h * h, a[i + 1] * h * h
    rest, slope, bend = x[i + 1] - x[i] - v0 - a0 / 2, v1 - v0 - a0, a1 - a0
    c3 = 10 * rest - 4 * slope + bend / 2
    c4 = -15 * rest + 7 * slope - bend
    c5 = 6 * rest - 3 * slope + bend / 2
    value = x[i] + s * (v0 + s * (a0 / 2 + s * (c3 + s * (c4 + s * c5))))
    first = (v0 + s * (a0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h
    second = (a0 + s * (6 * c3 + s * (12 * c4 + s * 20 * c5))) / (h * h)
    return value, first, second


def least_jerk(knots: Floats, x: Floats, first: Floats, last: Floats) -> tuple[Floats, Floats]:
    """First and second derivatives [m, n] at ``knots`` [m] of the spline of least jerk through ``x`` [m, n].
    It has four continuous derivatives, and the least integral of squared jerk.

    ``first`` and ``last`` [2, n] are derivative and second derivative at the ends.
    """
    from scipy.interpolate import make_interp_spline  # not at the top: it is slow to load

    # In the mean step as the unit of time the equations' coefficients are of like size.
    unit = (knots[-1] - knots[0]) / (len(knots) - 1)
    t = (knots - knots[0]) / unit
    ends = tuple([(1, rates[0] * unit), (2, rates[1] * unit**2)] for rates in (first, last))
    spline = make_interp_spline(t, x, k=5, bc_type=ends)
    v, a = spline(t, 1) / unit, spline(t, 2) / unit**2
    v[0], a[0], v[-1], a[-1] = first[0], first[1], last[0], last[1]
    return v, a


def end_rates(t: Floats, x: Floats) -> tuple[Floats, Floats]:
    """Derivative and second derivative [2, n] at both ends, of the polynomial through the seven samples there
    (fewer where there are fewer)."""
    k = min(7, len(t))
    rates = []
    for times, values in ((t[:k], x[:k]), (t[::-1][:k], x[::-1][:k])):
        scale = abs(times[-1] - times[0])
        powers = np.vander((times - times[0]) / scale, k, increasing=True)
        c = np.linalg.solve(powers, values - values[0])
        none = np.zeros_like(values[0])
        rates.append(np.stack([c[1] / scale, 2 * c[2] / scale**2 if k > 2 else none]))
    return rates[0], rates[1]
