"""How sure the numbers of a fit are, residuals of a stretch of a log being alike.

Two figures of the same thing: the curvature of the posterior, with samples that say the
same counted as one, and the sandwich of scores by blocks (Liang and Zeger 1986). The wider one counts.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from robodyn.arrays import Floats
from robodyn.identify.consistent import to_unit_diagonal
from robodyn.identify.normal import Block
from robodyn.identify.problem import Solution, Unknowns, normal, scores


def likeness(residuals: Sequence[Floats], n: int) -> Floats:
    """How many samples [n] say what one says: 1 + 2 sums of autocorrelations of the ``residuals`` [M, n] of
    each piece, up to the first that is not positive (Geyer's initial sequence, by pairs)."""
    result = np.ones(n)
    for j in range(n):
        pieces = [left[:, j] for left in residuals]
        longest = max(len(piece) for piece in pieces) // 4
        power = sum(float(piece @ piece) for piece in pieces)
        if not power > 0:
            continue
        total, lag = -1.0, 0
        while lag + 1 < longest:
            pair = sum(
                float(piece[: len(piece) - k] @ piece[k:])
                for piece in pieces
                for k in (lag, lag + 1)
                if k < len(piece)
            )
            if pair <= 0:
                break
            total += 2 * pair / power
            lag += 2
        result[j] = max(1.0, total)
    return result


def covariance(unknowns: Unknowns, blocks: Sequence[Block], solution: Solution, likeness: Floats) -> Floats:
    """Covariance [p, p] of z: zero at what is held. ``likeness`` [n]: how many times wider than the weights
    say the residuals' sums of a joint spread."""
    free = np.flatnonzero(unknowns.free)
    at = np.ix_(free, free)
    H = (solution.curvature + np.diag(solution.prior))[at]
    scaled, unit = to_unit_diagonal(H)
    inverse, units = np.linalg.inv(scaled), np.outer(unit, unit)

    def sandwich(scatter: Floats) -> Floats:
        """The covariance by that of the score, as a product with itself: no variance is less than 0."""
        values, vectors = np.linalg.eigh(scatter * units)
        root = inverse @ (vectors * np.sqrt(np.maximum(values, 0.0)))
        return np.asarray(root @ root.T * units)

    S = scores(unknowns, blocks, solution.weights, solution.z)[:, free]
    S = S - S.mean(axis=0)
    meat = S.T @ S * len(blocks) / max(len(blocks) - 1, 1)
    # Data and prior speak apart: the prior's part of the score varies by its own precision.
    data = normal(unknowns, blocks, solution.weights * likeness, solution.z)[0][at]
    prior = np.diag(solution.prior[free])
    plain, spread = sandwich(data + prior), np.diag(sandwich(meat + prior))
    variances = np.diag(plain)
    wider = np.divide(spread, variances, out=np.ones_like(spread), where=variances > 0)
    ratio = np.sqrt(np.maximum(1.0, wider))
    whole = np.zeros((unknowns.size, unknowns.size))
    whole[at] = plain * np.outer(ratio, ratio)
    return whole
