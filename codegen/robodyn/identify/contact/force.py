"""Which link a force acts on in a window of time, and the force: the most likely of all links, or none.

Torques are compared in units of their spread. A force on link k shows at joints 1 to k; the point of
contact is unknown, so that a moment about it of a small lever goes with it. The evidence for a link is
the likelihood of the window's torques, the force integrated out (a Gaussian prior whose size is the most
likely one)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.kinematics import frames, jacobian
from robodyn.identify.contact.limits import (
    ALL_ERROR,
    ARM_OF_FORCE,
    FORCE_MOST,
    LEAST_LEVER,
    OWN_ERROR,
    PIECES,
    SHIFT_ERROR,
)
from robodyn.identify.rigid import Model

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Push:
    """A force on the arm from outside: on ``link`` (from 1), ``force`` [3] along the base's axes (N),
    the mean over its window, with standard errors; ``explained``: share of the window's squares;
    ``evidence``: how much more likely (log) it is than one joint alone; ``alone``: that joint (from
    1)."""

    link: int
    force: Floats
    stderr: Floats
    explained: float
    evidence: float
    alone: int


def push_in(model: Model, q: Floats, torque: Floats, spread: Floats, shift: Floats) -> Push:
    """The force behind the residual ``torque`` [K, n] at poses ``q`` [K, n]; ``spread`` [K, n]: standard
    deviation of what it is without a force; ``shift`` [n]: by how much its level is another one
    afterwards."""
    n = torque.shape[1]
    own = np.sqrt((torque**2).mean(axis=0))
    error = np.hypot(OWN_ERROR * own, SHIFT_ERROR * shift) + ALL_ERROR * own.max()
    spread = np.hypot(spread, error)
    z = torque / spread
    count = min(PIECES, len(z))
    pieces = np.array_split(np.arange(len(z)), count)
    profile = np.sqrt((z**2).sum(axis=1))
    profile = profile / max(float(profile.mean()), 1e-300)
    poses = np.stack([q[rows].mean(axis=0) for rows in pieces])
    # The mean of each piece weighted by how strong the push is then; spreads are those of neighbours too.
    mean = np.stack(
        [(z[rows] * profile[rows, None]).sum(axis=0) / (profile[rows] ** 2).sum() for rows in pieces]
    )
    strength = np.array([float(np.sqrt((profile[rows] ** 2).mean())) for rows in pieces])
    b = (mean * strength[:, None]).ravel()
    wide = np.stack([spread[rows].mean(axis=0) for rows in pieces])
    tried: list[tuple[float, int, Floats, Floats, Floats]] = []
    # What only joint 1 feels is taken to act on link 2, whose frame tells on which side of the axis.
    for link in range(min(n, 2), n + 1):
        for place in _points(model, link):
            columns = _columns(model, poses, link, place) / wide[:, :, None] * strength[:, None, None]
            A = columns.reshape(-1, 6)
            # Nobody pushes at an axis: there no force shows.
            if np.abs(A[:, :3]).max() * ARM_OF_FORCE < LEAST_LEVER * np.abs(A[:, 3:]).max():
                continue
            evidence, w, cov = _evidence(A, b)
            tried.append((evidence, link, w, cov, place))
    if not tried:
        return Push(1, np.zeros(3), np.zeros(3), 0.0, 0.0, 1)
    best = max(tried, key=lambda one: one[0])
    # Where it acts may be open: the force is the mean over all places, as likely as their evidence says.
    weights = np.exp(np.array([one[0] for one in tried]) - best[0])
    weights /= weights.sum()
    link = int(np.argmax(np.bincount([one[1] for one in tried], weights)))
    force = np.sum([x * one[2][:3] for x, one in zip(weights, tried, strict=True)], axis=0)
    spreads = [np.diag(one[3])[:3] + (one[2][:3] - force) ** 2 for one in tried]
    variance = np.sum([x * own for x, own in zip(weights, spreads, strict=True)], axis=0)
    evidence, at, w, _, place = best
    alone, joint = max((_alone(n, count, j, strength, b), j + 1) for j in range(n))
    fit = (_columns(model, q, at, place) / spread[:, :, None] * profile[:, None, None]) @ w
    left = z - fit
    explained = 1 - float((left**2).sum() / max((z**2).sum(), 1e-300))
    scale = max(1.0, float((left**2).mean()))
    # A force on link 1 shows at one joint only, whatever acts there.
    ahead = evidence - alone if joint > 1 else max(evidence - alone, 0.0)
    return Push(link, force, np.sqrt(variance * scale), explained, ahead, joint)


def _points(model: Model, link: int) -> list[Floats]:
    """Points of a link [m, in its frame] near which it is touched: its frame's origin, centre, and far
    end."""
    bodies = model.arm.bodies
    points = [np.zeros(3), np.array([float(c) for c in bodies[link - 1].com])]
    if link < len(bodies):
        points.append(np.array([float(bodies[link].a), 0.0, 0.0]))
    return [p for k, p in enumerate(points) if not any(np.linalg.norm(p - o) < 0.02 for o in points[:k])]


def _columns(model: Model, q: Floats, link: int, place: Floats) -> Floats:
    """Torques [K, n, 6] that the joints have less by a force and a moment of the lever of 1 m at a point of a
    link."""
    zeros = np.zeros_like(q)
    placed = frames(model.arm, model.motion(q, zeros, zeros))
    rows = jacobian(model.arm, placed, link=link)
    flat = np.zeros(len(q))
    J = np.stack([np.stack([entry + flat for entry in row], axis=1) for row in rows], axis=2)  # [K, n, 6]
    frame = placed[link - 1]
    point = np.stack([x + flat for x in frame.turned(tuple(place))], axis=1)
    # v at the point = v at the origin + w x point.
    linear = J[:, :, :3] + np.cross(J[:, :, 3:], point[:, None, :])
    return -np.concatenate([linear, ARM_OF_FORCE * J[:, :, 3:]], axis=2)


def _evidence(A: Floats, b: Floats) -> tuple[float, Floats, Floats]:
    """Log-likelihood of ``b`` [m] = ``A`` [m, c] w + noise of size 1, with w of the most likely size; w; its
    covariance [c, c]."""
    u, size, vt = np.linalg.svd(A, full_matrices=False)
    inside = u.T @ b
    outside = float(b @ b - inside @ inside)
    best = (-np.inf, 1.0)
    top = max(float(size.max()), 1e-300)
    # No larger than what shows: a force whose torques nearly cancel is not what acts.
    most = FORCE_MOST * float(np.abs(inside).max()) / top
    for wide in np.geomspace(1e-3 * most, most, 31) if most > 0 else (1.0,):
        total = 1 + (size * wide) ** 2
        likely = -0.5 * (outside + float((inside**2 / total).sum()) + float(np.log(total).sum()))
        best = max(best, (likely, float(wide)))
    likely, wide = best
    gain = size * wide**2 / (1 + (size * wide) ** 2)
    w = vt.T @ (gain * inside)
    # What the torques do not show keeps the size of the prior.
    cov = wide**2 * np.eye(A.shape[1]) - (vt.T * (wide**2 * size * gain)) @ vt
    return likely, w, cov


def _alone(n: int, count: int, j: int, strength: Floats, b: Floats) -> float:
    """The evidence for a torque at joint ``j`` (from 0) alone."""
    A = np.zeros((count, n, 1))
    A[:, j, 0] = strength
    return _evidence(A.reshape(-1, 1), b)[0]
