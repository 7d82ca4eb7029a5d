"""Least squares without prior and without physics: the yardstick, and what a group of columns is worth."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Indices
from robodyn.identify.consistent import solve_definite
from robodyn.identify.limits import LEAST_NOISE, RANK, ROUNDS
from robodyn.identify.normal import Block, Layout


def sums(layout: Layout, blocks: Sequence[Block], weights: Floats) -> tuple[Floats, Floats]:
    """Gram matrix [p, p] and right-hand side [p] of all joints."""
    H, h = np.zeros((layout.size, layout.size)), np.zeros(layout.size)
    for j in range(layout.n):
        at = layout.columns(j)
        H[np.ix_(at, at)] += weights[j] * np.sum([block.gram[j] for block in blocks], axis=0)
        h[at] += weights[j] * np.sum([block.right[j] for block in blocks], axis=0)
    return H, h


def plain(layout: Layout, blocks: Sequence[Block]) -> tuple[Floats, Floats]:
    """Parameters [p] of least length among those that fit best, joints weighted by what they leave, and these
    weights [n]. Offsets are none."""
    weights = np.ones(layout.n)
    count = np.maximum(np.sum([block.weight for block in blocks], axis=0), 1e-300)
    x = np.zeros(layout.size)
    for _ in range(ROUNDS):
        x = shortest(*sums(layout, blocks, weights), without(layout, "offset"))
        squares = np.sum([block.misfit(layout, x) for block in blocks], axis=0)
        torque = np.sum([block.square for block in blocks], axis=0)
        weights = count / np.maximum(np.maximum(squares, RANK * torque), count * LEAST_NOISE**2)
    return x, weights


def without(layout: Layout, *names: str) -> NDArray[np.bool_]:
    """All parameters [p] save those of joints that are called so."""
    mask = np.ones(layout.size, dtype=bool)
    for name in names:
        if name in layout.own:
            mask[layout.joint(name)] = False
    return mask


def shortest(H: Floats, h: Floats, mask: NDArray[np.bool_]) -> Floats:
    """The shortest solution of ``H x = h`` in the parameters of the ``mask``, columns scaled alike."""
    use = np.flatnonzero(mask & (np.diag(H) > RANK * np.diag(H).max(initial=0.0)))
    unit = 1 / np.sqrt(np.diag(H)[use])
    values, vectors = np.linalg.eigh(H[np.ix_(use, use)] * np.outer(unit, unit))
    seen = values > RANK * values.max(initial=0.0)
    x = np.zeros(len(H))
    x[use] = unit * ((vectors[:, seen] / values[seen]) @ (vectors[:, seen].T @ (unit * h[use])))
    return x


def basis_of(H: Floats, mask: NDArray[np.bool_]) -> tuple[Indices, Indices, Floats]:
    """Places [r] of the columns of the ``mask`` that stand out most from each other, of which ``H`` [p, p] is
    the Gram matrix; places [d] of those that are sums of these, and their factors [r, d] in them."""
    from scipy.linalg import qr, solve_triangular

    use = np.flatnonzero(mask & (np.diag(H) > RANK * np.diag(H).max(initial=0.0)))
    if not len(use):
        return use, use, np.zeros((0, 0))
    unit = 1 / np.sqrt(np.diag(H)[use])
    values, vectors = np.linalg.eigh(H[np.ix_(use, use)] * np.outer(unit, unit))
    root = np.sqrt(np.maximum(values, 0))[:, None] * vectors.T
    _, R, order = qr(root, mode="economic", pivoting=True)
    diagonal, least = np.abs(np.diag(R)), np.sqrt(RANK)
    rank = int((diagonal > least * diagonal.max(initial=0.0)).sum())
    factors = solve_triangular(R[:rank, :rank], R[:rank, rank:])
    factors[np.abs(factors) < least] = 0.0
    basis, others = order[:rank], order[rank:]
    return use[basis], use[others], factors * unit[basis][:, None] / unit[others]


def condition(layout: Layout, blocks: Sequence[Block], weights: Floats) -> float:
    """The condition number of the base regressor, columns scaled to one length; NaN where none shows."""
    H, _ = sums(layout, blocks, weights)
    basis, _, _ = basis_of(H, without(layout, "offset"))
    if not len(basis):
        return float("nan")
    own = H[np.ix_(basis, basis)]
    unit = 1 / np.sqrt(np.diag(own))
    values = np.linalg.eigvalsh(own * np.outer(unit, unit))
    return float(np.sqrt(values[-1] / max(float(values[0]), np.finfo(float).eps)))


def held_out_gains(
    layout: Layout, blocks: Sequence[Block], weights: Floats, prior: tuple[Floats, Floats], name: str
) -> Floats:
    """By joint and block that is held out [n, held], how much less is left of it where the parameters
    ``name`` of that joint are fitted to the other blocks than where they are not, as weighted squares.

    ``prior``: mean and precision [p] of all parameters.
    """
    train = [block for block in blocks if not block.held_out]
    test = [block for block in blocks if block.held_out]
    mean, precision = prior
    H, h = sums(layout, train, weights)
    H, h = H + np.diag(precision), h + precision * mean
    whole = solve_definite(H, h)

    def left(x: Floats) -> Floats:
        return np.array([block.misfit(layout, x) for block in test]) @ weights

    full = left(whole)
    gains = []
    for at in layout.joint(name).tolist():
        kept = np.delete(np.arange(layout.size), at)
        x = mean.copy()
        x[kept] = solve_definite(H[np.ix_(kept, kept)], h[kept] - H[kept, at] * mean[at])
        gains.append(left(x) - full)
    return np.array(gains)
