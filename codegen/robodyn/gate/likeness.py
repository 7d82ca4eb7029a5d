"""How a logged torque agrees with a model's, whatever friction there is."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from robodyn.gate.flag import Floats
from robodyn.gate.limits import EXACT_FLOOR, LEAST, LIKENESS_FLOOR, MOST


@dataclass(frozen=True, slots=True, eq=False)
class Trial:
    """A reading of the log: states and torques [K, n]."""

    q: Floats
    qd: Floats
    qdd: Floats
    tau: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Likeness:
    """How a torque agrees with a model, by joint [n], beside friction and a bias.

    The share ``unexplained`` with the model's torque taken :data:`LEAST` to :data:`MOST` times, and ``apart``
    with it as it is; the best
    ``factor`` of any size and the ``correlation`` with it; ``twisted``: the correlation beside a spring too;
    ``sprung``: the share left beside it; ``driving``: the share that only friction which drives would
    explain. NaN: it tells nothing.
    """

    unexplained: Floats
    apart: Floats
    factor: Floats
    correlation: Floats
    twisted: Floats
    sprung: Floats
    driving: Floats


def likeness(trial: Trial, torque: Floats) -> Likeness:
    """How the torques of ``trial`` agree with the frictionless model's ``torque`` [K, n]."""
    n = trial.q.shape[1]
    unexplained, apart, factor, correlation, twisted, sprung, driving = (np.full(n, np.nan) for _ in range(7))
    for j in range(n):
        v, tau, predicted = trial.qd[:, j], trial.tau[:, j], torque[:, j]
        slow = 0.1 * math.sqrt(float(v @ v) / len(v)) or 1.0
        q = trial.q[:, j] - trial.q[:, j].mean()
        whole = float(np.sum((tau - tau.mean()) ** 2))
        # All that follows is of lengths and angles, which the triangle of a QR decomposition keeps.
        table = np.stack([np.ones_like(v), v, np.tanh(v / slow), q, predicted, tau], axis=1)
        size = np.sqrt((table * table).sum(axis=0))
        triangle = np.linalg.qr(table / np.where(size > 0, size, 1), mode="r") * size
        columns, more, predicted, tau = triangle[:, :3], triangle[:, :4], triangle[:, 4], triangle[:, 5]
        rest, own = _beside(columns, tau), _beside(columns, predicted)
        power = float(own @ own)
        # A torque that does not change tells nothing.
        if whole <= 1e-12 * float(tau @ tau) or power <= 1e-12 * float(predicted @ predicted):
            continue
        factor[j] = float(own @ rest) / power
        correlation[j] = factor[j] * math.sqrt(power / max(float(rest @ rest), 1e-300))
        left, freely = _left(columns, predicted, tau)
        unexplained[j], driving[j] = left / whole, (left - freely) / whole
        apart[j] = _left(columns, predicted, tau, 1.0)[0] / whole
        rest, own = _beside(more, tau), _beside(more, predicted)
        sizes = math.sqrt(float(rest @ rest) * float(own @ own))
        twisted[j] = float(own @ rest) / sizes if sizes > 0 else 0.0
        rest = rest - _multiple(own, rest) * own
        sprung[j] = float(rest @ rest) / whole
    return Likeness(unexplained, apart, factor, correlation, twisted, sprung, driving)


def _left(columns: Floats, predicted: Floats, tau: Floats, times: float | None = None) -> tuple[float, float]:
    """What is left of ``tau`` [K], squared, beside a bias, friction that does not drive, and the
    ``predicted`` torque taken :data:`LEAST` to :data:`MOST` times; and with friction of any sign.

    ``columns``: 1, viscous and dry friction [K, 3]; ``times``: as often as this, not as often as fits."""
    best, freely = math.inf, math.inf
    for used in ([0, 1, 2], [0, 1], [0, 2], [0]):
        basis = columns[:, used]
        rest, own = _beside(basis, tau), _beside(basis, predicted)
        factor = _multiple(own, rest) if times is None else times
        levels = np.linalg.lstsq(basis, tau - factor * predicted, rcond=1e-9)[0]
        left = rest - factor * own
        freely = min(freely, float(left @ left))
        if (levels[1:] >= 0).all():
            best = min(best, float(left @ left))
    return best, freely


def _multiple(own: Floats, rest: Floats) -> float:
    """How many times ``own`` [K] is in ``rest`` [K], :data:`LEAST` to :data:`MOST`."""
    power = float(own @ own)
    return min(max(float(own @ rest) / power, LEAST), MOST) if power > 0 else 1.0


def _beside(columns: Floats, x: Floats) -> Floats:
    """What of ``x`` [K] is not in the span of the ``columns`` [K, m]."""
    size = np.sqrt((columns * columns).sum(axis=0))
    scaled = columns / np.where(size > 0, size, 1)
    solution = np.linalg.lstsq(scaled, x, rcond=1e-9)[0]
    left: Floats = x - scaled @ solution
    return left


def gain_of(before: Likeness, after: Likeness) -> float:
    """By which factor less is left unexplained, the joints' factors multiplied; with the model's torque taken
    as often as fits or as it is, whichever gains more."""
    best = 0.0
    for was, now, floor in (
        (before.unexplained, after.unexplained, LIKENESS_FLOOR),
        (before.apart, after.apart, EXACT_FLOOR),
    ):
        ratio = np.maximum(was, floor) / np.maximum(now, floor)
        ratio = ratio[np.isfinite(ratio)]
        best = max(best, float(np.exp(np.log(np.clip(ratio, 1e-3, 1e3)).sum())))
    return best
