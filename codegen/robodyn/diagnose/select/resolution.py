"""Below which speed the direction of a joint is not resolved: the likeliest, near what rates and encoders
let expect."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from robodyn.arrays import Floats
from robodyn.diagnose.select.limits import RANGE, RESOLUTION
from robodyn.diagnose.select.members import Fit, solve
from robodyn.diagnose.select.noise import rest_of
from robodyn.diagnose.select.rows import Rows, with_speeds
from robodyn.diagnose.select.score import Trial, likelihood_of_any_noise, log_likelihood
from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify.prior import number_of
from robodyn.identify.rest import half_decades
from robodyn.robot.model import Robot


def likelier_speeds(fit: Fit, expected: Floats, threshold: float, best: Trial | None) -> Floats | None:
    """Speeds [n] of joints with dry friction that foretell more than those of the rows by the ``threshold``
    [nats], and no less than the ``best`` candidate does at that joint; None where none do."""
    rows = fit.model.rows
    dry = {(one.key[1] or 0) - 1 for one in fit.model.exact if CATALOGUE[one.key[0]].dissipative}
    dry |= {j for j, link in enumerate(rows.robot.links) if number_of(link.joint.coulomb) > 0}
    speeds = rows.speeds.copy()
    for j in sorted(dry - {-1}):
        rival = 0.0 if best is None else best.at[j] - best.error
        speed, gain = _likeliest(fit, speeds, expected, j)
        if gain > max(threshold, rival):
            speeds[j] = speed
    return None if np.array_equal(speeds, rows.speeds) else speeds


def rest_speeds(robot: Robot, rows: Rows) -> Floats:
    """Speeds [n] below which friction of ``robot`` in proportion to the speed leaves least, of half
    decades below the usual speeds: :func:`robodyn.identify.rest.rest_speeds` has them before anything is
    named."""
    rms = np.sqrt(np.mean(rows.seen("qd") ** 2, axis=0))
    _, *grid = half_decades(rms, np.max([c.signals.speed_noise for c in rows.contexts], axis=0))
    squares = [(rest_of(robot, with_speeds(rows, speeds)) ** 2).sum(axis=0) for speeds in grid]
    return np.asarray(np.array(grid)[np.argmin(squares, axis=0), np.arange(rows.n)])


def foretold(fit: Fit, expected: Floats, threshold: float) -> tuple[Floats, float]:
    """The likelier speeds [n] of a fit, or its own, and its held-out log-likelihood with them [nats]."""
    speeds = likelier_speeds(fit, expected, threshold, None)
    if speeds is None:
        return fit.model.rows.speeds, float(log_likelihood(fit).sum())
    other = _in_rows(fit, with_speeds(fit.model.rows, speeds))
    return speeds, -np.inf if other is None else float(log_likelihood(other).sum())


def _likeliest(fit: Fit, speeds: Floats, expected: Floats, j: int) -> tuple[float, float]:
    """The likeliest speed of joint ``j`` (from 0), and what it foretells more [nats]."""
    before = likelihood_of_any_noise(fit)
    best, most = float(speeds[j]), 0.0
    for factor in (RESOLUTION, 1 / RESOLUTION):
        speed = best if most else float(speeds[j])
        while expected[j] / RANGE < speed * factor < expected[j] * RANGE:
            speed *= factor
            tried = speeds.copy()
            tried[j] = speed
            other = _in_rows(fit, with_speeds(fit.model.rows, tried))
            gain = 0.0 if other is None else likelihood_of_any_noise(other) - before
            if gain <= most:
                break
            best, most = speed, gain
    return best, most


def _in_rows(fit: Fit, rows: Rows) -> Fit | None:
    """The fit in other rows, its slopes as they are."""
    model = replace(fit.model, rows=rows)
    left = model.left()
    if left is None:
        return None
    x, cost = solve(fit.columns, fit.held, left, rows.weight)
    return Fit(model, left, fit.columns, fit.held, x, cost)
