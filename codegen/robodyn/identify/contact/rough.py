"""What an arm of uncertain numbers and unknown friction leaves of a log: the residual of a quick, robust fit.

Bursts that the motion does not explain bias it little, for large residuals count less (Cauchy weights, by
joint and by sample)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Mask
from robodyn.gate.gate import Gate
from robodyn.identify.contact.limits import (
    CONTACT_BAND,
    CONTACT_CUTOFF,
    FIT_KNEE,
    LEAST_SIZE,
    LOOSE,
    REST_WEIGHT,
    SLOWEST,
)
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import Signals, signals_of


@dataclass(frozen=True, slots=True, eq=False)
class Rough:
    """Signals of the segments of a log, thinned: times ``t`` [N] (s), ``part`` [N] the segment of each
    sample, ``q``, ``qd``, ``tau`` [N, n]; columns ``A`` [N, n, p] of what is fitted with precisions ``prior``
    [p], and what the description leaves, ``rest`` [N, n]; ``resting``, ``saturated`` [N, n];
    ``floor`` [n]: noise of the torques after the filter; ``size`` [n]: RMS torques; ``step`` [s];
    ``ways`` [n]: the column of each joint's direction, -1 where it has none; ``stands``: the arm stands
    throughout, but for what a hand moves it."""

    t: Floats
    part: NDArray[np.intp]
    q: Floats
    qd: Floats
    tau: Floats
    A: Floats
    prior: Floats
    rest: Floats
    resting: Mask
    saturated: Mask
    floor: Floats
    size: Floats
    step: float
    ways: NDArray[np.intp]
    stands: bool


def rough_signals(model: Model, gate: Gate, left: Floats | None = None) -> Rough | None:
    """The log of ``gate`` along the ``model``, which leaves ``left`` [K, n] of its torques (None: what it
    leaves by its equations); None: its pieces are too short for the filter."""
    cutoff = min(CONTACT_CUTOFF, CONTACT_BAND / gate.period)
    parts = []
    for k, part in enumerate(gate.segments):
        if (part.stop - part.start) * gate.period > 4 / cutoff and part.stop - part.start >= 20:
            s = signals_of(_piece(gate.log, part), cutoff=cutoff)
            parts.append((k, part, s))
    if not parts:
        return None
    size = np.sqrt(np.mean(gate.log.tau**2, axis=0))
    size = np.maximum(size, LEAST_SIZE * size.max() + 1e-12)
    rests, columns, times, owners, places, rates, loads = [], [], [], [], [], [], []
    still, cut = [], []
    for k, part, s in parts:
        coarse = s.coarse()
        rest = s.tau - model.torque(s.q, s.qd, s.qdd) if left is None else left[part][: len(s.t)]
        rests.append(s.thinned(s.filtered(rest)))
        columns.append(_columns(model, s, coarse))
        times.append(s.thinned(s.t))
        owners.append(np.full(len(times[-1]), k))
        places.append(s.thinned(s.q))
        rates.append(s.thinned(s.qd))
        loads.append(s.thinned(s.filtered(s.tau)))
        still.append(_thinned(s, gate.resting[part]))
        cut.append(_thinned(s, gate.saturated[part]))
    A, prior, ways = _scaled(model, np.concatenate(columns), size, np.concatenate(rates))
    step = parts[0][2].period * parts[0][2].every
    passed = np.sqrt(min(1.0, 2 * cutoff * gate.period))
    return Rough(
        np.concatenate(times), np.concatenate(owners), np.concatenate(places), np.concatenate(rates),
        np.concatenate(loads), A, prior, np.concatenate(rests), np.concatenate(still), np.concatenate(cut),
        _noise(gate) * passed, size, step, ways, gate.stands,
    )  # fmt: skip


def _thinned(s: Signals, mask: Mask) -> Mask:
    return mask[: len(s.t)][s.edge : len(s.t) - s.edge : s.every]


def _noise(gate: Gate) -> Floats:
    """Standard deviations [n] of the torques' noise and of their steps."""
    steps = np.array([one.torque_step for one in gate.joints])
    return np.asarray(np.hypot(gate.torque_noise, steps / np.sqrt(12)))


def _piece(log: Log, part: slice) -> Log:
    return Log(log.t[part], log.q[part], None, None, log.tau[part])


def _columns(model: Model, s: Signals, coarse: Signals) -> Floats:
    """Unscaled columns [N, n, 10 n + 5 n]: the inertial numbers, and of each joint direction, speed, 1,
    position, acceleration."""
    Y = model.regressor(coarse.q, coarse.qd, coarse.qdd)
    inertial = coarse.thinned(coarse.filtered(Y.reshape(len(Y), model.n, -1)))
    way = s.thinned(s.filtered(model.direction(s.qd)))
    q, qd, qdd = s.thinned(s.q), s.thinned(s.filtered(s.qd)), s.thinned(s.filtered(s.qdd))
    count = min(len(inertial), len(way))
    own = np.zeros((count, model.n, 5 * model.n))
    for j in range(model.n):
        x = (way[:, j], qd[:, j], np.ones(len(q)), q[:, j], qdd[:, j])
        own[:, j, 5 * j : 5 * j + 5] = np.stack([c[:count] for c in x], axis=1)
    return np.concatenate([inertial[:count], own], axis=2)


def _scaled(model: Model, A: Floats, size: Floats, qd: Floats) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Columns in standard deviations of their priors, those of no effect left out; precisions; the columns of
    the joints' directions."""
    phi = model.standard_parameters()
    scale = np.zeros_like(phi)
    for k, row in enumerate(phi):
        mass, spread = abs(row[0]), max(float(np.abs(row[4:7]).max()), 1e-9)
        floor = np.concatenate([[0.1 * mass], np.full(3, 0.1 * mass), np.full(6, 0.2 * spread)])
        scale[k] = LOOSE * np.maximum(np.abs(row), floor)
    n = model.n
    sizes = [scale.ravel()]
    for j in range(n):
        fast = max(float(np.sqrt(np.mean(qd[:, j] ** 2))), SLOWEST)
        change = max(float(np.sqrt(np.mean(A[:, j, 10 * n + 5 * j + 4] ** 2))), 10 * SLOWEST)
        sizes.append(size[j] * np.array([1.0, 1 / fast, 1.0, 1.0, 1 / change]))
    A = A * np.concatenate(sizes)
    shown = np.abs(A).max(axis=(0, 1)) > 1e-9 * size.max()
    of_way = 10 * n + 5 * np.arange(n)
    ways = np.where(shown[of_way], np.cumsum(shown)[of_way] - 1, -1)
    return A[:, :, shown], np.ones(int(shown.sum())), ways


def fitted_rest(rough: Rough, without: Mask | None = None) -> tuple[Floats, Floats, Floats]:
    """What the robust fit leaves [N, n], its robust standard deviations [n] where joints move, and the level
    [n] of dry friction; samples of the mask ``without`` [N] do not count."""
    A, b = rough.A, rough.rest
    n = b.shape[1]
    if rough.stands:  # what a push moves it by would pass for a spring
        return b, np.maximum(rough.floor, 1e-4 * rough.size), np.zeros(n)
    base = np.where(rough.resting, REST_WEIGHT, 1.0) * ~rough.saturated
    if without is not None:
        base = base * ~without[:, None]
    x: Floats = np.zeros(A.shape[2])
    left = b
    weights = base
    for round_ in range(12):
        sigma = _scale(left, base, rough)
        z = left / sigma
        if round_:
            own = 1 / (1 + (z / FIT_KNEE) ** 2)
            of_all = 1 / (1 + np.mean(np.minimum(z, 1e3) ** 2, axis=1) / FIT_KNEE**2)
            weights = base * own * of_all[:, None]
        W = weights / sigma**2
        G, g = np.zeros((A.shape[2], A.shape[2])), np.zeros(A.shape[2])
        for j in range(n):
            a = A[:, j] * np.sqrt(W[:, j])[:, None]
            G += a.T @ a
            g += a.T @ (np.sqrt(W[:, j]) * b[:, j])
        new = np.linalg.solve(G + np.diag(rough.prior), g)
        left = np.asarray(b - A @ new)
        if np.abs(new - x).max() < 1e-3 * max(1.0, np.abs(new).max()):
            break
        x = np.asarray(new)
    level = np.where(rough.ways >= 0, np.abs(x[rough.ways]) * np.abs(_unit(rough)), 0.0)
    return left, _scale(left, base, rough), level


def _unit(rough: Rough) -> Floats:
    """The torque [n] of each joint's column of direction at full speed."""
    joints = range(rough.rest.shape[1])
    return np.array([np.abs(rough.A[:, j, rough.ways[j]]).max() for j in joints])


def _scale(left: Floats, base: Floats, rough: Rough) -> Floats:
    """Robust standard deviations [n] where joints count."""
    result = np.empty(left.shape[1])
    for j in range(len(result)):
        counts = base[:, j] > 0.5
        if counts.sum() < 20:
            counts = base[:, j] > 0
        x = left[counts, j] if counts.any() else left[:, j]
        result[j] = 1.4826 * float(np.median(np.abs(x)))
    return np.asarray(np.maximum(result, np.maximum(rough.floor, 1e-4 * rough.size)))
