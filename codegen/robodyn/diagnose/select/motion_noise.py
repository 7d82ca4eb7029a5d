"""What the encoders' noise in the motion does to the numbers of links that lag behind their motors.

A link on its spring passes on the less of that noise, the more its spring is damped: so least squares prefer
a damping that is too large, on a stiff spring by half and more. By how much is what as much noise once more
does to the slopes of the squares, of which it is in both factors. The numbers are those from which the noise
leads to what was fitted (MacKinnon and Smith 1998: a bias that is itself a function of what is estimated).
Of other effects it changes next to nothing but what is left.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import amended
from robodyn.diagnose.select.limits import (
    BIAS_NEARER,
    BIAS_ROUNDS,
    BIAS_SETTLED,
    NOISE_DRAWS,
)
from robodyn.diagnose.select.local_fit import LocalFit, inverse_of
from robodyn.diagnose.select.refine import Freed
from robodyn.kernels.array_dynamics import Model

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Unbiased:
    """Values ``x`` [P] without what the encoders' noise makes of them, and how many times ``wider`` [P] the
    intervals are about them."""

    x: Floats
    wider: Floats


def unbiased(fit: LocalFit) -> Unbiased:
    """The values of a ``fit`` without what the encoders' noise does to them."""
    freed, begun = fit.freed, fit.x
    x, wider = begun, np.ones(len(begun))
    if not Model(amended(freed.robot, freed.changed(begun))).couplers:
        return Unbiased(x, wider)
    draws = [freed.noisier(draw) for draw in range(NOISE_DRAWS)]
    first = bias = _bias(fit, draws)
    if first is None or bias is None:
        return Unbiased(x, wider)
    for _ in range(BIAS_ROUNDS):
        before, x = x, _near(begun, begun - bias)
        if np.all(np.abs(x - before) < BIAS_SETTLED * fit.errors):
            break
        there = LocalFit.of(freed, x)
        other = None if there is None else _bias(there, draws)
        if other is None:
            break
        bias = other
    # What was fitted moves by 1 + slope where the number moves by 1.
    moved = np.abs(x - begun) > BIAS_SETTLED * fit.errors
    slope = np.where(moved, (bias - first) / np.where(moved, x - begun, 1.0), 0.0)
    return Unbiased(x, np.asarray(1 / np.clip(1 + slope, BIAS_NEARER, 1.0)))


def _near(begun: Floats, x: Floats) -> Floats:
    """Values ``x`` [P] of the sign of those that were ``begun`` with, and not much nearer to zero."""
    return np.asarray(np.where(x / begun < BIAS_NEARER, BIAS_NEARER * begun, x))


def _bias(fit: LocalFit, draws: list[Freed]) -> Floats | None:
    """How far [P] noise of the encoders leads a fit from values that are those of ``fit``; None where links
    diverge with it."""
    left = fit.freed.missed(fit.x)
    if left is None:
        return None
    pull = np.zeros(len(fit.x))
    for draw in draws:
        noisy = draw.missed(fit.x)
        if noisy is None:
            return None
        slopes = fit.weight[:, None] * draw.slopes(fit.x, noisy) - fit.J
        pull -= slopes.T @ (fit.weight * (noisy - left)) / len(draws)
    return inverse_of(fit.curvature) @ pull
