"""What an arm of uncertain numbers and unknown friction leaves of a log: the residual of a quick, robust fit.

What the motion does not explain biases it little, for large residuals count less (Cauchy's weights)."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.gate.gate import Gate
from robodyn.identify.contact.limits import CUTOFF, KNEE, LOOSE, SLOWEST
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.limits import HIGHEST_CUTOFF
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, eq=False)
class Loose:
    """A log, filtered and thinned to N samples, each ``step`` [s]: times ``t`` [N] (s), ``part`` [N] the
    segment of each, ``q`` [N, n]; ``rest`` [N, n]: what the description leaves of the torques;
    ``A`` [N, n, p]: columns of what is fitted, in standard deviations of their prior, of which a joint
    has those ``shown`` [n, p]; ``dry`` [n]: those of directions, -1 where a joint has none; ``known`` [n]:
    the level of friction that the description has; ``resting``, ``saturated`` [N, n]; ``floor`` [n]: noise
    of torques after the filter; ``size`` [n]: RMS torques; ``stands``: the arm stands throughout."""

    t: Floats
    part: NDArray[np.intp]
    q: Floats
    rest: Floats
    A: Floats
    shown: Mask
    dry: NDArray[np.intp]
    known: Floats
    resting: Mask
    saturated: Mask
    floor: Floats
    size: Floats
    step: float
    stands: bool


def loose(model: Model, gate: Gate, left: Floats | None = None) -> Loose | None:
    """The log of ``gate`` along the ``model``, which leaves ``left`` [K, n] of its torques (None: what it
    leaves by its equations); None: its pieces are too short for the filter."""
    cutoff = min(CUTOFF, HIGHEST_CUTOFF / gate.period)
    rows: list[tuple[NDArray[Any], ...]] = []
    step = gate.period
    for k, part in enumerate(gate.segments):
        if part.stop - part.start <= max(4 / (cutoff * gate.period), 20):
            continue
        log = gate.log
        s = signals_of(Log(log.t[part], log.q[part], None, None, log.tau[part]), cutoff=cutoff)
        # What stiction holds knows no direction, nor jitter of encoders.
        moves = ~gate.resting[part][: len(s.t)]
        s = replace(s, qd=s.qd * moves, qdd=s.qdd * moves)
        own = s.tau - model.torque(s.q, s.qd, s.qdd) if left is None else left[part][: len(s.t)]
        A, t = _columns(model, s), s.thinned(s.t)
        still, cut = (x[part][: len(s.t)][s.used] for x in (gate.resting, gate.saturated))
        each = t, np.full(len(t), k), s.thinned(s.q), s.thinned(s.filtered(own)), A, still, cut
        rows.append(tuple(x[: len(A)] for x in each))
        step = s.period * s.every
    if not rows:
        return None
    t, part_of, q, rest, A, still, cut = (np.concatenate(each) for each in zip(*rows, strict=True))
    size = np.sqrt(np.mean(gate.log.tau**2, axis=0))
    size = np.maximum(size, 0.01 * size.max() + 1e-12)
    A, dry = _scaled(model, A, size)
    steps = np.array([one.torque_step for one in gate.joints]) / np.sqrt(12)
    floor = np.hypot(gate.torque_noise, steps) * np.sqrt(min(1.0, 2 * cutoff * gate.period))
    shown = np.abs(A).max(axis=0) > 0
    ways = np.array([[SLOWEST], [-SLOWEST]]) * np.ones(
        model.n
    )  # of the description's own friction half the jump
    known = 0.5 * np.abs(np.diff(model.torque(0 * ways, ways, 0 * ways), axis=0)[0])
    return Loose(t, part_of, q, rest, A, shown, dry, known, still, cut, floor, size, step, gate.stands)


def _columns(model: Model, s: Signals) -> Floats:
    """Unscaled columns [N, n, 10 n + 5 n]: the inertial numbers, and of each joint direction, speed, 1,
    position, acceleration."""
    coarse = s.coarse()
    Y = model.regressor(coarse.q, coarse.qd, coarse.qdd)
    inertial = coarse.thinned(coarse.filtered(Y.reshape(len(Y), model.n, -1)))
    ways, qd, qdd = (s.thinned(s.filtered(x)) for x in (model.direction(s.qd), s.qd, s.qdd))
    q = s.thinned(s.q)
    each = np.stack([ways, qd, np.ones_like(q), q, qdd], axis=2)[: len(inertial)]
    own = each[:, :, None, :] * np.eye(model.n)[:, :, None]
    inertial = inertial[: len(own)]
    return np.concatenate([inertial, own.reshape(len(own), model.n, -1)], axis=2)


def _scaled(model: Model, A: Floats, size: Floats) -> tuple[Floats, NDArray[np.intp]]:
    """Columns in standard deviations of their priors, those of no effect left out, and the columns of the
    joints' directions: inertial numbers are off by :data:`LOOSE`, what a joint does by itself is as large as
    its torque."""
    phi, n = model.standard_parameters(), model.n
    mass, spread = np.abs(phi[:, :1]), np.maximum(np.abs(phi[:, 4:7]).max(axis=1, keepdims=True), 1e-9)
    least = np.concatenate([np.repeat(0.1 * mass, 4, axis=1), np.repeat(0.2 * spread, 6, axis=1)], axis=1)
    inertial = LOOSE * np.maximum(np.abs(phi), least)
    own = A[:, :, 10 * n :].reshape(len(A), n, n, 5)[:, range(n), range(n)]
    usual = np.sqrt(np.mean(own**2, axis=0))
    usual = np.maximum(usual, SLOWEST * np.array([0.0, 1.0, 0.0, 0.0, 10.0]))
    usual[:, [0, 2, 3]] = 1.0
    A = A * np.concatenate([inertial.ravel(), (size[:, None] / usual).ravel()])
    shown = np.abs(A).max(axis=(0, 1)) > 1e-9 * size.max()
    of_way = 10 * n + 5 * np.arange(n)
    return A[:, :, shown], np.where(shown[of_way], np.cumsum(shown)[of_way] - 1, -1)


def left_of(one: Loose, without: Mask, start: Floats | None = None) -> tuple[Floats, Floats, Floats]:
    """What the robust fit leaves [N, n], the level [n] of dry friction, and the fitted numbers [p], which
    come from near ``start`` [p]; samples of the mask ``without`` [N] do not count, and those at rest as their
    set says: any torque within the level."""
    n, p = one.rest.shape[1], one.A.shape[2]
    if one.stands:  # what a push moves it by would pass for a spring
        return one.rest, one.known, np.zeros(p)
    A, b, resting = one.A[::2], one.rest[::2], one.resting[::2]  # no less than the filter passes
    used = ~one.saturated[::2] & ~without[::2, None]
    unit = np.array([np.abs(A[:, j, one.dry[j]]).max() for j in range(n)])
    x = np.zeros(p) if start is None else start
    for round_ in range(12):
        left = b - A @ x
        level = _level(one, x, unit) if x.any() else one.size
        moving = used & ~resting
        count = np.where(moving.sum(axis=0) < 20, used, moving)
        sigma = np.sqrt(
            [np.median(left[count[:, j], j] ** 2) if count[:, j].any() else 0.0 for j in range(n)]
        )
        sigma = np.maximum(1.4826 * sigma, np.maximum(one.floor, 1e-4 * one.size))
        z = left / sigma
        weights = used / (1 + resting * (level / sigma) ** 2)
        if round_ or start is not None:
            of_all = 1 + np.mean(np.minimum(z, 1e3) ** 2, axis=1) / KNEE**2
            weights = weights / (1 + (z / KNEE) ** 2) / of_all[:, None]
        W = np.sqrt(weights) / sigma
        G, g = np.eye(p), np.zeros(p)
        for j in range(n):
            own = np.flatnonzero(one.shown[j])
            white = A[:, j, own] * W[:, j, None]
            G[np.ix_(own, own)] += white.T @ white
            g[own] += white.T @ (W[:, j] * b[:, j])
        last, x = x, np.asarray(np.linalg.solve(G, g))
        if np.abs(x - last).max() < 1e-3 * max(1.0, np.abs(x).max()):
            break
    return one.rest - one.A @ x, _level(one, x, unit), x


def _level(one: Loose, x: Floats, unit: Floats) -> Floats:
    """The level [n] of dry friction by the fitted numbers ``x`` [p] and what the description has."""
    return np.abs(np.where(one.dry >= 0, x[one.dry] * unit, 0.0) + one.known)
