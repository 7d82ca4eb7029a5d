"""Which link a force acts on in a window of time, and the force: the most likely of all links, or none.

Torques are compared in units of their spread. A force on link k shows at joints 1 to k; the point of
contact is unknown: it may be anywhere between the link's joints, or near its centre, and a moment of a small
lever goes with it. The evidence for a place is the likelihood of the window's torques, the force
integrated out (a Gaussian prior whose size is the most likely one). What a joint's friction keeps from
its motor is an error that lasts for the whole window, and so are errors of the model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.dynamics.kinematics import frames
from robodyn.identify.contact.limits import (
    ALL_ERROR,
    ARM_OF_FORCE,
    CORRELATED,
    FORCE_MOST,
    LEAST_FORCE,
    LEAST_LEVER,
    MOST_COURSE,
    OWN_ERROR,
    PLACES,
    SHIFT_ERROR,
    TURNED,
)
from robodyn.kernels.array_dynamics import Model


@dataclass(frozen=True, slots=True, eq=False)
class Push:
    """A force on the arm from outside: on ``link`` (from 1), ``force`` [3] along the base's axes (N),
    the mean over its window, with standard errors; within ``cone`` [degrees] of its direction the true one
    lies with 95 %; ``explained``: share of the window's squares; ``evidence``: how much more
    likely (log) it is than one joint alone; ``alone``: that joint (from 1)."""

    link: int
    force: Floats
    stderr: Floats
    cone: float
    explained: float
    evidence: float
    alone: int


#: No force at all.
_NOTHING = Push(1, np.zeros(3), np.zeros(3), 180.0, 0.0, 0.0, 1)


@dataclass(frozen=True, slots=True, eq=False)
class Window:
    """A residual ``torque`` [K, n] in a window, each ``step`` [s], at poses ``q`` [K, n]. ``spread`` [K, n]:
    standard deviation of what it is without a force; ``shift`` [n]: by how much its level is another one
    afterwards; ``held`` [n]: what friction may keep from the motors."""

    q: Floats
    torque: Floats
    spread: Floats
    shift: Floats
    held: Floats
    step: float


@dataclass(frozen=True, slots=True, eq=False)
class _Places:
    """Where a force may act: ``link`` [H] (from 1), at a ``share`` of the way to the next joint (None: its
    centre); and the torques ``columns`` [H, P, n, 6] that the joints have less by a force and a moment of
    the lever of 1 m there, in P poses."""

    link: NDArray[np.intp]
    share: list[float | None]
    columns: Floats


def push_in(model: Model, window: Window) -> Push:
    """The force behind the residual of a ``window``."""
    torque = window.torque
    own = np.sqrt((torque**2).mean(axis=0))
    model_error = np.hypot(OWN_ERROR * own, ALL_ERROR * own.max())
    usual = np.hypot(model_error, window.held)
    lasting = np.hypot(usual, SHIFT_ERROR * window.shift)
    spread = np.hypot(window.spread, usual)
    z = torque / spread
    pieces = np.array_split(np.arange(len(z)), _count(model, window.q))
    places = _places(model, np.stack([window.q[rows].mean(axis=0) for rows in pieces]))
    if len(pieces) == 1:
        profile = np.sqrt((z**2).sum(axis=1))
    else:
        # In motion the same force makes other torques in other poses: its own course comes of a first fit.
        profile = np.ones(len(z))
        first = _fitted(window, lasting, model_error, places, pieces, profile)
        if first is None:
            return _NOTHING
        unit = np.einsum("kjc,c->kj", _columns_at(model, window.q, places, first.best), first.w[first.at])
        unit = unit / spread
        profile = np.clip((z * unit).sum(axis=1) / np.maximum((unit**2).sum(axis=1), 1e-12), 0.0, MOST_COURSE)
    profile = profile / max(float(profile.mean()), 1e-300)
    fit = _fitted(window, lasting, model_error, places, pieces, profile)
    seen = _fitted(window, usual, model_error, places, pieces, profile)
    if fit is None or seen is None:
        return _NOTHING
    # Where it acts may be open: the force is the mean over all places, as likely as their evidence says.
    weights = np.exp(fit.evidence - fit.evidence.max())
    weights /= weights.sum()
    link = int(np.argmax(np.bincount(fit.link, weights)))
    force = weights @ fit.w[:, :3]
    variance = weights @ (np.diagonal(fit.cov, axis1=1, axis2=2)[:, :3] + (fit.w[:, :3] - force) ** 2)
    # How much of the window a force explains, sample by sample, in units of the spread of each, whatever
    # friction holds of it afterwards; and a joint alone, whatever it does.
    shape = profile[:, None] * (_columns_at(model, window.q, places, seen.best) @ seen.w[seen.at])
    # The prior makes the force too small where the torques say little of it: it is what makes them.
    power = float(((shape / spread) ** 2).sum())
    size = float((shape * torque / spread**2).sum()) / max(power, 1e-300)
    by_force = float((((torque - size * shape) / spread) ** 2).sum())
    squares = (z**2).sum(axis=0)
    joint = int(squares.argmax()) + 1
    explained = 1 - by_force / max(float(squares.sum()), 1e-300)
    many = max(1.0, len(z) * window.step / CORRELATED) / len(z)
    ahead = 0.5 * many * (float(np.delete(squares, joint - 1).sum()) - by_force)
    scale = max(1.0, fit.left / max(fit.b.size - 3, 1))
    cone = _cone(weights, fit.w[:, :3], fit.cov[:, :3, :3] * scale, force)
    # A force on link 1 shows at one joint only, whatever acts there.
    ahead = ahead if joint > 1 else max(ahead, 0.0)
    return Push(link, force, np.sqrt(variance * scale), cone, explained, ahead, joint)


@dataclass(frozen=True, slots=True, eq=False)
class _Fit:
    """What forces explain of ``b`` [P, n], white, at H places on the links ``link`` [H]: their ``evidence``
    [H]; force and moment ``w`` [H, 6], their covariances ``cov`` [H, 6, 6]; the best is ``at`` (of these)
    and ``best`` (of all places); it leaves ``left``, squared."""

    b: Floats
    link: NDArray[np.intp]
    evidence: Floats
    w: Floats
    cov: Floats
    at: int
    best: int
    left: float


def _fitted(
    window: Window, lasting: Floats, model_error: Floats, places: _Places, pieces: list[NDArray[np.intp]],
    profile: Floats,
) -> _Fit | None:  # fmt: skip
    """Forces of the course ``profile`` [K] at all ``places`` where one shows; None: at none."""
    # The mean of each piece weighted by how strong the push is then.
    total = np.array([max(float((profile[rows] ** 2).sum()), 1e-12) for rows in pieces])
    strength = np.sqrt(total / np.array([len(rows) for rows in pieces]))
    mean = np.stack([profile[rows] @ window.torque[rows] for rows in pieces]) / total[:, None]
    lengths = np.array([max(1.0, len(rows) * window.step / CORRELATED) for rows in pieces])
    random = np.stack([window.spread[rows].mean(axis=0) for rows in pieces]) / np.sqrt(lengths)[:, None]
    white = _whitening(strength, np.hypot(random, model_error), lasting)
    A = np.einsum("jab,hbjc->hajc", white, places.columns * strength[:, None, None])
    b = np.einsum("jab,bj->aj", white, mean * strength[:, None])
    # Nobody pushes at an axis: there no force shows.
    shown = np.abs(A[..., :3]).max(axis=(1, 2, 3)) * ARM_OF_FORCE
    kept = np.flatnonzero(shown >= LEAST_LEVER * np.abs(A[..., 3:]).max(axis=(1, 2, 3)))
    if not len(kept):
        return None
    A = A[kept]
    evidence, w, cov = _evidence(A.reshape(len(A), -1, 6), b.ravel())
    at = int(evidence.argmax())
    left = float(((b - A[at] @ w[at]) ** 2).sum())
    return _Fit(b, places.link[kept], evidence, w, cov, at, int(kept[at]), left)


def _count(model: Model, q: Floats) -> int:
    """In how many pieces the pose may be taken as constant."""
    turned = np.ptp(q, axis=0)[[body.revolute for body in model.arm.bodies]]
    return int(np.clip(np.ceil(float(turned.max(initial=0.0)) / TURNED), 1, min(8, len(q))))


def _whitening(strength: Floats, random: Floats, lasting: Floats) -> Floats:
    """For each joint [n, P, P] what makes its errors in the pieces independent and of size 1: what is
    ``random`` [P, n] in each, and what is ``lasting`` [n] in all, while the push has its ``strength`` [P]."""
    P, n = random.shape
    result = np.empty((n, P, P))
    for j in range(n):
        cov = np.diag(random[:, j] ** 2) + lasting[j] ** 2 * np.outer(strength, strength)
        result[j] = np.linalg.inv(np.linalg.cholesky(cov))
    return result


def _places(model: Model, q: Floats) -> _Places:
    """Where a force may act on the arm in the poses ``q`` [P, n]."""
    n, reach = q.shape[1], _Reach(model, q)
    links, shares, columns = [], [], []
    # What only joint 1 feels is taken to act on link 2, whose frame tells on which side of the axis.
    for link in range(min(n, 2), n + 1):
        kept: list[Floats] = []
        for share in (*PLACES, None):
            point = reach.point(link, share)
            if any(float(np.abs(point - other).max()) < 0.02 for other in kept):
                continue
            kept.append(point)
            links.append(link)
            shares.append(share)
            columns.append(reach.columns(link, point))
    return _Places(np.array(links), shares, np.stack(columns))


def _columns_at(model: Model, q: Floats, places: _Places, which: int) -> Floats:
    """The columns [K, n, 6] of one of the ``places`` in the poses ``q`` [K, n]."""
    reach, link = _Reach(model, q), int(places.link[which])
    return reach.columns(link, reach.point(link, places.share[which]))


class _Reach:
    """Points of the arm's links in poses ``q`` [P, n], and what forces there do."""

    def __init__(self, model: Model, q: Floats) -> None:
        zeros = np.zeros_like(q)
        self._flat = zeros[:, 0]
        self._bodies = model.arm.bodies
        self._frames = frames(model.arm, model.motion(q, zeros, zeros))
        self._origins = [self._array(frame.origin) for frame in self._frames]
        self._axes = [self._array(frame.z) for frame in self._frames]

    def _array(self, vector: Sequence[object]) -> Floats:
        return np.stack([np.asarray(x, dtype=np.float64) + self._flat for x in vector], axis=1)

    def point(self, link: int, share: float | None) -> Floats:
        """A point [P, 3] at a ``share`` of the way to the next joint; None: the link's centre."""
        k = link - 1
        x, y, z = (float(c) for c in self._bodies[k].com)
        centre = self._array(self._frames[k].place((x, y, z)))
        if share is None:
            return centre
        end = self._origins[link] if link < len(self._bodies) else 2 * centre - self._origins[k]
        return np.asarray(self._origins[k] + share * (end - self._origins[k]))

    def columns(self, link: int, point: Floats) -> Floats:
        """Torques [P, n, 6] that the joints have less by a force and a moment of the lever of 1 m at a
        ``point`` [P, 3]."""
        J = np.zeros((len(point), len(self._bodies), 6))
        for j in range(link):
            axis = self._axes[j]
            if self._bodies[j].revolute:
                J[:, j, :3] = np.cross(axis, point - self._origins[j])
                J[:, j, 3:] = ARM_OF_FORCE * axis
            else:
                J[:, j, :3] = axis
        return -J


def _evidence(A: Floats, b: Floats) -> tuple[Floats, Floats, Floats]:
    """For each of H: the log-likelihood [H] of ``b`` [m] = ``A`` [H, m, c] w + noise of size 1, with w of the
    most likely size; w [H, c]; its covariance [H, c, c]."""
    u, size, vt = np.linalg.svd(A, full_matrices=False)
    inside = np.einsum("hmr,m->hr", u, b)
    outside = float(b @ b) - (inside**2).sum(axis=1)
    top = np.maximum(size.max(axis=1), 1e-300)
    # No larger than what shows: a force whose torques nearly cancel is not what acts.
    most = np.maximum(FORCE_MOST * np.abs(inside).max(axis=1) / top, 1e-300)
    wide = most[:, None] * np.geomspace(LEAST_FORCE, 1.0, 15)
    total = 1 + (size[:, None, :] * wide[:, :, None]) ** 2
    likely = -0.5 * (
        outside[:, None] + (inside[:, None, :] ** 2 / total).sum(axis=2) + np.log(total).sum(axis=2)
    )
    at = likely.argmax(axis=1)
    rows = np.arange(len(A))
    own = wide[rows, at][:, None]
    gain = size * own**2 / (1 + (size * own) ** 2)
    w = np.einsum("hrc,hr->hc", vt, gain * inside)
    # What the torques do not show keeps the size of the prior.
    cov = own[:, :, None] ** 2 * np.eye(A.shape[2]) - np.einsum(
        "hrc,hr,hrd->hcd", vt, own**2 * size * gain, vt
    )
    return likely[rows, at], w, cov


def _cone(weights: Floats, means: Floats, covariances: Floats, force: Floats, count: int = 200) -> float:
    """Half the angle [degrees] of the cone about ``force`` [3] that holds 95 % of what is
    likely: of Gaussians with ``weights`` [H], ``means`` [H, 3] and ``covariances`` [H, 3, 3]."""
    length = float(np.linalg.norm(force))
    if not length:
        return 180.0
    draws = np.random.default_rng(1).standard_normal((count, 3))
    angles, shares = [], []
    for k in np.flatnonzero(weights > 1e-3):
        size, axes = np.linalg.eigh(covariances[k])
        x = means[k] + draws * np.sqrt(np.maximum(size, 0.0)) @ axes.T
        cosine = x @ force / np.maximum(np.linalg.norm(x, axis=1) * length, 1e-300)
        angles.append(np.degrees(np.arccos(np.clip(cosine, -1, 1))))
        shares.append(np.full(count, weights[k]))
    angle, share = np.concatenate(angles), np.concatenate(shares)
    order = np.argsort(angle)
    below = np.cumsum(share[order]) / share.sum()
    return float(angle[order][int(np.searchsorted(below, 0.95))])
