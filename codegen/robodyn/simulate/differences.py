"""Rates from samples, as a controller takes them: looking only back."""

from __future__ import annotations

import math

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError

#: Samples are evenly spaced if no interval differs from the mean by more than this share of it.
EVEN = 1e-6


def difference(t: Floats, x: Floats) -> Floats:
    """Backward differences of ``x`` [K, n] by the times ``t`` [K] (s); the first stands twice.

    Raises
    ------
    InputError: less than two samples, or times that do not increase.
    """
    steps = np.diff(t)
    if not len(steps) or not (steps > 0).all():
        raise InputError("a difference needs two samples or more, at increasing times")
    slope = np.empty_like(x)
    slope[1:] = np.diff(x, axis=0) / steps[:, None]
    slope[0] = slope[1]
    return slope


def low_pass(t: Floats, x: Floats, cutoff: float, order: int = 2) -> Floats:
    """``x`` [K, n] through a causal Butterworth low-pass, -3 dB at ``cutoff`` [Hz]; it starts settled.

    Raises
    ------
    InputError: the samples are not evenly spaced, or the cutoff is not below half their rate.
    """
    from scipy.signal import butter, lfilter

    steps = np.diff(t)
    step = float(steps.mean()) if len(steps) else math.nan
    if not (step > 0 and (np.abs(steps - step) <= EVEN * step).all()):
        raise InputError("a low-pass needs evenly spaced samples", remedy="sample at a steady period")
    if not 0 < cutoff < 0.5 / step:
        raise InputError(
            "the cutoff of the low-pass does not fit the samples",
            found=f"{cutoff:g} Hz",
            expected=f"between 0 and half their rate, {0.5 / step:g} Hz",
        )
    b, a = butter(order, cutoff, fs=1 / step)
    return np.asarray(x[:1] + lfilter(b, a, x - x[:1], axis=0))
