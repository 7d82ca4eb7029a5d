"""Rates from samples, as a controller takes them: looking only back."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError

Floats = NDArray[np.float64]

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

    By the bilinear transform with the cutoff prewarped, in the transposed direct form II.

    Raises
    ------
    InputError: the samples are not evenly spaced, or the cutoff is not below half their rate.
    """
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
    w = math.tan(math.pi * cutoff * step)
    if order == 1:
        b0 = b1 = w / (1 + w)
        b2, a1, a2 = 0.0, (w - 1) / (1 + w), 0.0
    else:
        scale = 1 / (1 + math.sqrt(2) * w + w * w)
        b0 = b2 = w * w * scale
        b1, a1, a2 = 2 * b0, 2 * (w * w - 1) * scale, (1 - math.sqrt(2) * w + w * w) * scale
    result = np.empty_like(x)
    for j in range(x.shape[1]):
        values = x[:, j].tolist()
        z1, z2 = (1 - b0) * values[0], (b2 - a2) * values[0]
        out = []
        for value in values:
            y = b0 * value + z1
            z1 = b1 * value - a1 * y + z2
            z2 = b2 * value - a2 * y
            out.append(y)
        result[:, j] = out
    return result
