"""Least squares over a log beside a nuisance, judged on parts of the log that were left out.

Rows are samples of filtered torques, weighted by joint. The rigid arm's own numbers may be off by what the
description says (``confidence``): they are a nuisance with a Gaussian prior, fitted along and never named
here. Samples are read once, for Gram matrices by part and joint; all that is fitted and judged is worked out
from those.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.limits import BLOCKS, FEW_PARTS, FREE_PRECISION, UNPULLED, UNSEEN_NUISANCE

Floats = NDArray[np.float64]
Columns = Floats | NDArray[np.float32]


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """What is to be explained, in parts of the log [BLOCKS].

    ``rest`` [N, n] and known columns ``A`` [N, n, p], both in standard deviations ``sigma`` [n] of the
    noise, times ``weight`` [N, n]: 1, less where joints rest, 0 where a row does not count; ``prior`` [p]
    precisions; ``parts`` their slices; by part and joint the products of the columns
    ``gram`` [BLOCKS, n, p, p], with the rest ``right`` [BLOCKS, n, p], and of the rest ``square``
    [BLOCKS, n]; ``thin``: how many neighbouring samples are correlated; ``nuisance``: how many of the columns
    are nuisance; ``basis`` [all, nuisance] the directions that they are of the arm's own numbers, which are
    known to ``sizes`` [all], in their own units; ``encoder_noise`` [n]: the part of ``sigma`` that comes from
    the encoders."""

    rest: Floats
    A: Floats
    prior: Floats
    sigma: Floats
    weight: Floats
    parts: tuple[slice, ...]
    gram: Floats
    right: Floats
    square: Floats
    thin: float
    nuisance: int
    basis: Floats
    sizes: Floats
    encoder_noise: Floats

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.rest.shape[1])

    @property
    def independent(self) -> float:
        """Number of independent samples."""
        return len(self.rest) / self.thin

    @property
    def counted(self) -> NDArray[np.bool_]:
        """Which of the samples count [N]."""
        return np.asarray(np.any(self.weight > 0, axis=1))

    def usual(self, left: Floats) -> Floats:
        """The median size [n] of what is left [N, n], where joints do not rest: of a normal distribution its
        standard deviation. A median, so that short bursts of joints that stick at reversals do not count."""
        whole = self.weight >= 1
        sizes = (np.abs(left[whole[:, j], j]) for j in range(self.n))
        return np.array([1.4826 * float(np.median(size)) if len(size) else 0.0 for size in sizes])

    @property
    def grams(self) -> Floats:
        """Products [BLOCKS, p, p] of the columns over all joints."""
        return np.asarray(self.gram.sum(axis=1))

    @property
    def rights(self) -> Floats:
        """Products [BLOCKS, p] of the columns and the rest over all joints."""
        return np.asarray(self.right.sum(axis=1))

    def with_columns(self, rows: tuple[int, ...], columns: Columns, scale: Floats | None = None) -> Problem:
        """The problem with more known columns [N, rows, c], in N m or N, fitted freely, or with a prior of
        standard deviations ``scale`` [c]."""
        p, c = self.A.shape[2], columns.shape[2]
        A = np.concatenate([self.A, np.zeros((*self.rest.shape, c))], axis=2)
        gram, right = np.zeros((*self.square.shape, p + c, p + c)), np.zeros((*self.square.shape, p + c))
        gram[:, :, :p, :p], right[:, :, :p] = self.gram, self.right
        for i, j in enumerate(rows):
            A[:, j, p:] = columns[:, i] * (self.weight[:, j, None] / self.sigma[j])
            for k, part in enumerate(self.parts):
                new = A[part, j, p:]
                gram[k, j, :, p:] = A[part, j].T @ new
                right[k, j, p:] = new.T @ self.rest[part, j]
        gram[:, :, p:, :p] = np.swapaxes(gram[:, :, :p, p:], 2, 3)
        prior = np.concatenate([self.prior, precisions(c, scale, self.thin)])
        return replace(self, A=A, prior=prior, gram=gram, right=right)

    def without_column(self, at: int) -> Problem:
        """The problem without one of its known columns."""
        gram, right = _without(self.gram, at, 2, 3), _without(self.right, at, 2)
        return replace(
            self, A=_without(self.A, at, 2), prior=_without(self.prior, at, 0), gram=gram, right=right
        )


def _without(x: Floats, at: int, *axes: int) -> Floats:
    """An array without what is ``at`` that place along some axes."""
    for axis in axes:
        x = np.delete(x, at, axis=axis)
    return x


def precisions(c: int, scale: Floats | None, thin: float) -> Floats:
    """The precisions [c] of coefficients that are free, or have standard deviations ``scale`` [c]."""
    return np.full(c, FREE_PRECISION) if scale is None else thin / scale**2


def without(p: Problem, mask: NDArray[np.bool_]) -> Problem:
    """The problem without the rows of ``mask`` [N], which no longer count."""
    kept = ~mask[:, None]
    return _summed(replace(p, rest=p.rest * kept, A=p.A * kept[:, :, None], weight=p.weight * kept))


def less(p: Problem, rows: tuple[int, ...], column: Columns) -> Problem:
    """The problem with a column [N, rows] taken off, in N m or N."""
    at = list(rows)
    rest = p.rest.copy()
    rest[:, at] -= column / p.sigma[at] * p.weight[:, at]
    return _summed(replace(p, rest=rest))


def coarser(p: Problem, factor: Floats) -> Problem:
    """The problem with noise that is larger by a ``factor`` [n]."""
    return _summed(replace(p, rest=p.rest / factor, A=p.A / factor[:, None], sigma=p.sigma * factor))


def tighter(p: Problem, share: float) -> Problem:
    """The problem with a nuisance that is known better: its standard deviations are a ``share``. What it is
    known to (``sizes``) stays: logs speak for the numbers that show in them, not for the others."""
    prior = p.prior.copy()
    prior[: p.nuisance] /= share**2
    return replace(p, prior=prior)


def share_taken(p: Problem) -> float:
    """As what share of what is said of them the arm's own numbers are taken to be wrong."""
    return float(np.sqrt(p.thin / p.prior[: p.nuisance].min())) if p.nuisance else 1.0


def wider(p: Problem, fresh: Problem) -> Problem:
    """The problem with the nuisance of ``fresh``, which is of the same log: its columns in the weights and
    without the rows that no longer count."""
    A = fresh.A * (fresh.sigma / p.sigma)[:, None] * p.counted[:, None, None]
    return _summed(
        replace(p, A=A, prior=fresh.prior, nuisance=fresh.nuisance, basis=fresh.basis, sizes=fresh.sizes)
    )


def problem(
    rest: Floats,
    Y: Floats,
    sigma: Floats,
    thin: float,
    encoder_noise: Floats | None = None,
    weight: Floats | None = None,
    sizes: Floats | None = None,
) -> Problem:
    """The problem of the residual ``rest`` [N, n] and the nuisance ``Y`` [N, n, p], a unit of each column
    being a standard deviation of its prior, ``sizes`` [p] in its own unit (1); ``encoder_noise`` [n] is the
    part of ``sigma`` that comes from the encoders; ``weight`` [N, n]: what the rows count (1).

    All units being alike, the columns may be turned: those that do not show along the log are left out, which
    changes no fit."""
    edges = np.linspace(0, len(rest), BLOCKS + 1).astype(int)
    parts = tuple(slice(int(a), int(b)) for a, b in pairwise(edges))
    weight = np.ones_like(rest) if weight is None else weight
    A, b = Y * (weight / sigma)[:, :, None], rest * (weight / sigma)
    basis = directions(A)
    sizes = np.ones(Y.shape[2]) if sizes is None else sizes
    A, p = A @ basis, basis.shape[1]
    by_encoders = np.zeros_like(sigma) if encoder_noise is None else encoder_noise
    none = np.zeros((BLOCKS, len(sigma), 0))
    return _summed(
        Problem(
            b, A, np.full(p, thin), sigma, weight, parts, none[..., None], none, none, thin, p, basis, sizes,
            by_encoders,
        )
    )  # fmt: skip


def directions(A: Floats) -> Floats:
    """The principal directions [all, p] of columns [N, n, all], without those that show nothing."""
    gram = sum((a.T @ a for a in np.swapaxes(A, 0, 1)), np.zeros((A.shape[2], A.shape[2])))
    sizes, ways = np.linalg.eigh(gram)
    return np.asarray(ways[:, sizes > UNSEEN_NUISANCE])


def _summed(p: Problem) -> Problem:
    """The problem with its products by part and joint."""
    rows = np.ascontiguousarray(np.swapaxes(np.concatenate([p.A, p.rest[:, :, None]], axis=2), 0, 1))
    sums = np.stack([np.swapaxes(rows[:, part], 1, 2) @ rows[:, part] for part in p.parts])
    return replace(p, gram=sums[:, :, :-1, :-1], right=sums[:, :, :-1, -1], square=sums[:, :, -1, -1])


@dataclass(frozen=True, slots=True, eq=False)
class Folds:
    """The fits to all parts but one, and to all [BLOCKS + 1]: ``known`` [BLOCKS + 1, p]; ``root``
    [BLOCKS + 1, p, p], which times its transpose is the inverse of the system; ``slope`` [BLOCKS, n, p]: half
    of what the squares held out change by, with the coefficients."""

    known: Floats
    root: Floats
    slope: Floats


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """``x`` [c]: coefficients of the columns tried, ``cov`` [c, c]; ``known`` [p] those of the problem's own;
    ``held_out`` [BLOCKS, n]: mean square errors on the parts that were held out, in units of the noise;
    ``prior_penalty`` of the nuisance, in units of log-likelihood; ``folds``: of a fit that candidates are
    tried beside."""

    x: Floats
    cov: Floats
    known: Floats
    held_out: Floats
    prior_penalty: float
    folds: Folds | None = None


def excluded(by_part: Floats) -> Floats:
    """Sums [BLOCKS + 1, ...] over all parts but one, and over all, of sums [BLOCKS, ...] by part."""
    whole = by_part.sum(axis=0)
    return np.concatenate([whole - by_part, whole[None]])


def fitted(p: Problem) -> Fit:
    """The problem fitted by what is known."""
    systems = excluded(p.grams) + np.diag(p.prior)
    scale = np.sqrt(np.diagonal(systems, axis1=1, axis2=2))
    sizes, directions = np.linalg.eigh(systems / scale[:, :, None] / scale[:, None, :])
    least = np.finfo(np.float64).eps * sizes[:, -1:]
    root = directions / np.sqrt(np.maximum(sizes, least))[:, None, :] / scale[:, :, None]
    known = (root @ (np.swapaxes(root, 1, 2) @ excluded(p.rights)[:, :, None]))[:, :, 0]
    through = (p.gram @ known[:-1, None, :, None])[..., 0]
    slope = through - p.right
    squares = p.square + np.sum((slope - p.right) * known[:-1, None], axis=2)
    held_out = np.maximum(squares, 0.0) / counts(p)[:, None]
    penalty = float(np.sum(p.prior[: p.nuisance] * known[-1, : p.nuisance] ** 2)) / p.thin / 2
    return Fit(np.zeros(0), np.zeros((0, 0)), known[-1], held_out, penalty, Folds(known, root, slope))


def covariance(now: Problem, last: Fit) -> Floats:
    """The covariance [p, p] of the coefficients, by how much the parts of the log pull at them (White 1980,
    with parts as clusters: what is left is correlated over time), no less than of as many independent
    samples."""
    inverse = _inverse(now)
    pulls = now.rights - now.grams @ last.known - now.prior * last.known / BLOCKS
    clustered = inverse @ (pulls.T @ pulls) @ inverse * (BLOCKS / (BLOCKS - 1)) * FEW_PARTS**2
    independent = now.thin * inverse * max(float(last.held_out.mean()), 1e-300)
    least, own = np.diag(independent), np.diag(clustered)
    scale = np.sqrt(np.maximum(1.0, least / np.maximum(own, UNPULLED * least + 1e-300)))
    spread = clustered * np.outer(scale, scale)
    alone = own < UNPULLED * least  # no part of the log pulls at these
    spread[alone], spread[:, alone] = independent[alone], independent[:, alone]
    return np.asarray(spread)


def by_prior(now: Problem, part: slice) -> Floats:
    """What of the errors of the coefficients in ``part`` [c, c] comes from their own prior:
    columns whose outer products add up to their covariance."""
    return np.asarray(_inverse(now)[part, part] * np.sqrt(now.thin * now.prior[part]))


def _inverse(now: Problem) -> Floats:
    """The inverse of the system [p, p] of all parts."""
    return np.asarray(np.linalg.pinv(now.grams.sum(axis=0) + np.diag(now.prior), hermitian=True))


def counts(p: Problem) -> Floats:
    """How many samples each part has [BLOCKS]."""
    return np.array([max(1, part.stop - part.start) for part in p.parts], dtype=np.float64)
