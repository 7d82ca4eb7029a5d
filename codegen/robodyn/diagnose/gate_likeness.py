"""How a logged torque agrees with a model's, whatever friction there is."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from robodyn.diagnose.gate_flag import Floats

#: What multiple of the model's torque a log's is taken to be at most and at least.
LEAST, MOST = 0.4, 2.5
#: Less than this share of the variance is not told apart.
_FLOOR = 0.01


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

    The share ``unexplained`` with the model's torque taken :data:`LEAST` to :data:`MOST` times; the best
    ``factor`` of any size and the ``correlation`` with it; ``twisted``: the correlation beside a spring too;
    ``driving``: the share that only friction which drives would explain. NaN: it tells nothing.
    """

    unexplained: Floats
    factor: Floats
    correlation: Floats
    twisted: Floats
    driving: Floats


def likeness(trial: Trial, torque: Floats) -> Likeness:
    """How the torques of ``trial`` agree with the frictionless model's ``torque`` [K, n]."""
    n = trial.q.shape[1]
    unexplained, factor, correlation, twisted, driving = (np.full(n, np.nan) for _ in range(5))
    for j in range(n):
        v, tau, predicted = trial.qd[:, j], trial.tau[:, j], torque[:, j]
        slow = 0.1 * math.sqrt(float(v @ v) / len(v)) or 1.0
        columns = np.stack([np.ones_like(v), v, np.tanh(v / slow)], axis=1)
        rest, own = _beside(columns, tau), _beside(columns, predicted)
        power = float(own @ own)
        whole = float(np.sum((tau - tau.mean()) ** 2))
        # A torque that does not change tells nothing.
        if whole <= 1e-12 * float(tau @ tau) or power <= 1e-12 * float(predicted @ predicted):
            continue
        factor[j] = float(own @ rest) / power
        correlation[j] = factor[j] * math.sqrt(power / max(float(rest @ rest), 1e-300))
        left, freely = _left(columns, predicted, tau)
        unexplained[j], driving[j] = left / whole, (left - freely) / whole
        q = trial.q[:, j] - trial.q[:, j].mean()
        more = np.column_stack([columns, q])
        rest, own = _beside(more, tau), _beside(more, predicted)
        sizes = math.sqrt(float(rest @ rest) * float(own @ own))
        twisted[j] = float(own @ rest) / sizes if sizes > 0 else 0.0
    return Likeness(unexplained, factor, correlation, twisted, driving)


def _left(columns: Floats, predicted: Floats, tau: Floats) -> tuple[float, float]:
    """What is left of ``tau`` [K], squared, beside a bias, friction that does not drive, and the
    ``predicted`` torque taken :data:`LEAST` to :data:`MOST` times; and with friction of any sign.

    ``columns``: 1, viscous and dry friction [K, 3]."""
    best, freely = math.inf, math.inf
    for used in ([0, 1, 2], [0, 1], [0, 2], [0]):
        basis = columns[:, used]
        rest, own = _beside(basis, tau), _beside(basis, predicted)
        power = float(own @ own)
        factor = min(max(float(own @ rest) / power, LEAST), MOST) if power > 0 else 1.0
        levels = np.linalg.lstsq(basis, tau - factor * predicted, rcond=1e-9)[0]
        left = rest - factor * own
        freely = min(freely, float(left @ left))
        if (levels[1:] >= 0).all():
            best = min(best, float(left @ left))
    return best, freely


def _beside(columns: Floats, x: Floats) -> Floats:
    """What of ``x`` [K] is not in the span of the ``columns`` [K, m]."""
    size = np.sqrt((columns * columns).sum(axis=0))
    scaled = columns / np.where(size > 0, size, 1)
    solution = np.linalg.lstsq(scaled, x, rcond=1e-9)[0]
    left: Floats = x - scaled @ solution
    return left


def gain_of(before: Likeness, after: Likeness) -> float:
    """By which factor less is left unexplained, the joints' factors multiplied."""
    ratio = np.maximum(before.unexplained, _FLOOR) / np.maximum(after.unexplained, _FLOOR)
    ratio = ratio[np.isfinite(ratio)]
    return float(np.exp(np.log(np.clip(ratio, 1e-3, 1e3)).sum()))
