"""Which link a force acts on in a window of time, and the force: the most likely of all links and places.

A force on link k shows at joints 1 to k; the point of contact is unknown: it may be anywhere between the
link's joints, or near its centre, and a moment of a small lever goes with it. The evidence for a place is the
likelihood of the window's torques, the force integrated out (a Gaussian prior whose size is the most likely
one). What a joint's friction keeps from its motor lasts for the whole window, and so do errors of the model.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.kinematics import frames
from robodyn.identify.contact.limits import LEVER, MODEL_ERROR, PLACES
from robodyn.kernels.array_dynamics import Model

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Push:
    """A force on the arm from outside: on ``link`` (from 1), ``force`` [3] along the base's axes (N),
    the mean over its window, with standard errors; within ``cone`` [degrees] of its direction the true one
    lies with 95 %; ``explained``: share of the window's squares; ``alone``: share that the joint where it
    shows most has of them."""

    link: int
    force: Floats
    stderr: Floats
    cone: float
    explained: float
    alone: float


def push_in(model: Model, q: Floats, torque: Floats, spread: Floats, held: Floats) -> Push | None:
    """The force that leaves ``torque`` [K, n] at poses ``q`` [K, n]; ``spread`` [n]: standard deviations of
    its mean without one; ``held`` [n]: of what friction keeps from the motors. None: it shows nowhere."""
    links, columns = _places(model, q)
    own = np.sqrt((torque**2).mean(axis=0))
    error = MODEL_ERROR * np.hypot(own, 0.3 * own.max())
    turned = float(np.ptp(q, axis=0)[[body.revolute for body in model.arm.bodies]].max(initial=0.0))
    pieces = np.array_split(np.arange(len(q)), int(np.clip(np.ceil(turned / 0.1), 1, min(8, len(q)))))
    noise, total = np.hypot(spread, error), np.hypot(np.hypot(spread, error), held)
    weights = np.stack([np.isin(np.arange(len(q)), rows) / len(rows) for rows in pieces])

    def fitted(course: Floats) -> tuple[Floats, Floats, Floats, float, Floats]:
        """With a ``course`` [K] of the force in time: evidence, forces and moments, their covariances at all
        places; of the best one what it leaves, squared, and the torques of its steady force [K, n]."""
        strength = np.sqrt(weights @ course**2)
        own = weights * course / strength[:, None]
        b, A = own @ torque, np.einsum("pk,k,hkjc->hpjc", own, course, columns, optimize=True)
        white = _whitening(strength, np.sqrt(len(pieces)) * noise, np.hypot(held, error))
        A, b = np.einsum("jab,hbjc->hajc", white, A), np.einsum("jab,bj->aj", white, b)
        evidence, w, cov = _evidence(A.reshape(len(A), -1, 6), b.ravel())
        # Nobody pushes at an axis: there no force shows.
        shows = np.abs(A[..., :3]).max(axis=(1, 2, 3)) >= np.abs(A[..., 3:]).max(axis=(1, 2, 3))
        evidence = np.where(shows, evidence, -np.inf)
        at = int(evidence.argmax())
        return evidence, w, cov, float(((b - A[at] @ w[at]) ** 2).sum()), columns[at] @ w[at] / total

    def course_of(steady: Floats) -> Floats:
        power = np.maximum((steady**2).sum(axis=1), 1e-300)
        course = np.clip((torque / total * steady).sum(axis=1) / power, 1e-3, 2.0)
        return np.asarray(course / course.mean())

    evidence, w, cov, left, steady = fitted(course_of(fitted(np.ones(len(q)))[4]))
    if not np.isfinite(evidence.max()):
        return None
    # Where it acts may be open: the force is the mean over all places, as likely as their evidence says.
    odds = np.exp(evidence - evidence.max())
    odds /= odds.sum()
    force = odds @ w[:, :3]
    variance = odds @ (np.diagonal(cov, axis1=1, axis2=2)[:, :3] + (w[:, :3] - force) ** 2)
    scale = max(1.0, left / max(len(pieces) * len(own) - 3, 1))
    cone = _cone(odds, w[:, :3], cov[:, :3, :3] * scale, force)
    # How much of the window it explains, sample by sample, of the size that does so best.
    shape, z = course_of(steady)[:, None] * steady, torque / total
    size = float((shape * z).sum()) / max(float((shape**2).sum()), 1e-300)
    squares = (z**2).sum(axis=0)
    explained = 1 - float(((z - size * shape) ** 2).sum()) / max(float(squares.sum()), 1e-300)
    link = int(np.argmax(np.bincount(links, odds)))
    alone = float(squares.max() / max(squares.sum(), 1e-300))
    return Push(link, force, np.sqrt(variance * scale), cone, explained, alone)


def _whitening(strength: Floats, random: Floats, lasting: Floats) -> Floats:
    """For each joint [n, P, P] what makes its errors in the pieces independent and of size 1: what is
    ``random`` [n] in each, and what is ``lasting`` [n] in all, while the push has its ``strength`` [P]."""
    both = np.outer(strength, strength)
    cov = [r**2 * np.eye(len(strength)) + each**2 * both for r, each in zip(random, lasting, strict=True)]
    return np.linalg.inv(np.linalg.cholesky(np.stack(cov)))


def _places(model: Model, q: Floats) -> tuple[NDArray[np.intp], Floats]:
    """Where a force may act on the arm in the poses ``q`` [K, n]: the links [H] (from 1), and the torques
    [H, K, n, 6] that joints have less by a force there and by a moment of :data:`LEVER`."""
    zeros, bodies = np.zeros_like(q), model.arm.bodies

    def array(vector: Sequence[object]) -> Floats:
        return np.stack([np.asarray(x, dtype=np.float64) + zeros[:, 0] for x in vector], axis=1)

    placed = frames(model.arm, model.motion(q, zeros, zeros))
    origins, axes = [array(f.origin) for f in placed], [array(f.z) for f in placed]
    links: list[int] = []
    columns = []
    # What only joint 1 feels is taken to act on link 2, whose frame tells on which side of the axis.
    for k in range(min(len(bodies), 2) - 1, len(bodies)):
        x, y, z = (float(c) for c in bodies[k].com)
        centre = array(placed[k].place((x, y, z)))
        end = origins[k + 1] if k + 1 < len(bodies) else 2 * centre - origins[k]
        points = [origins[k] + share * (end - origins[k]) for share in PLACES]
        for point in [*points, centre]:
            J = np.zeros((*q.shape, 6))
            for j in range(k + 1):
                if bodies[j].revolute:
                    J[:, j, :3] = np.cross(axes[j], point - origins[j])
                    J[:, j, 3:] = LEVER * axes[j]
                else:
                    J[:, j, :3] = axes[j]
            links.append(k + 1)
            columns.append(-J)
    return np.array(links), np.stack(columns)


def _evidence(A: Floats, b: Floats) -> tuple[Floats, Floats, Floats]:
    """For each of H: the log-likelihood [H] of ``b`` [m] = ``A`` [H, m, c] w + noise of size 1, with w of the
    most likely size; w [H, c]; its covariance [H, c, c]."""
    u, size, vt = np.linalg.svd(A, full_matrices=False)
    inside = np.einsum("hmr,m->hr", u, b)
    outside = float(b @ b) - (inside**2).sum(axis=1)
    # From a tenth of thrice what shows to that: a force whose torques nearly cancel is not what acts.
    most = np.maximum(3 * np.abs(inside).max(axis=1) / np.maximum(size.max(axis=1), 1e-300), 1e-300)
    wide = most[:, None] * np.geomspace(0.1, 1.0, 15)
    total = 1 + (size[:, None, :] * wide[:, :, None]) ** 2
    likely = -0.5 * (outside[:, None] + (inside[:, None, :] ** 2 / total + np.log(total)).sum(axis=2))
    at, rows = likely.argmax(axis=1), np.arange(len(A))
    own = wide[rows, at][:, None]
    gain = size * own**2 / (1 + (size * own) ** 2)
    w = np.einsum("hrc,hr->hc", vt, gain * inside)
    # What the torques do not show keeps the size of the prior.
    shown = np.einsum("hrc,hr,hrd->hcd", vt, own**2 * size * gain, vt)
    return likely[rows, at], w, own[:, :, None] ** 2 * np.eye(A.shape[2]) - shown


def _cone(weights: Floats, means: Floats, covariances: Floats, force: Floats, count: int = 200) -> float:
    """Half the angle [degrees] of the cone about ``force`` [3] that holds 95 % of what is likely: of
    Gaussians with ``weights`` [H], ``means`` [H, 3] and ``covariances`` [H, 3, 3]."""
    draws = np.random.default_rng(1).standard_normal((count, 3))
    some = np.flatnonzero(weights > 1e-3)
    sizes, axes = np.linalg.eigh(covariances[some])
    x = means[some, None] + np.einsum("sr,hr,hcr->hsc", draws, np.sqrt(np.maximum(sizes, 0.0)), axes)
    lengths = np.linalg.norm(x, axis=2) * np.linalg.norm(force)
    angle = np.degrees(np.arccos(np.clip(x @ force / np.maximum(lengths, 1e-300), -1, 1))).ravel()
    order = np.argsort(angle)
    below = np.cumsum(np.repeat(weights[some], count)[order])
    return float(angle[order][int(np.searchsorted(below, 0.95 * below[-1]))])
