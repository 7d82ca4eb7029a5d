"""Least squares over a log: candidates beside a nuisance, judged on parts of the log that were left out.

Rows are samples of filtered torques, weighted by joint. The rigid arm's own numbers may be off by what the
description says (``confidence``): they are a nuisance with a Gaussian prior, fitted along and never named
here."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.limits import BLOCKS, FREE_PRECISION

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """What is to be explained, in parts of the log [BLOCKS].

    ``rest`` [N, n] and known columns ``A`` [N, n, p], both in standard deviations ``sigma`` [n] of the
    noise; ``prior`` [p] precisions; ``parts`` their slices; ``grams`` [BLOCKS, p, p], ``rights`` [BLOCKS,
    p]; ``thin``: how many neighbouring samples are correlated; ``nuisance``: how many of the columns are
    nuisance; ``encoder_noise`` [n]: the part of ``sigma`` that comes from the encoders."""

    rest: Floats
    A: Floats
    prior: Floats
    sigma: Floats
    parts: tuple[slice, ...]
    grams: Floats
    rights: Floats
    thin: float
    nuisance: int
    encoder_noise: Floats

    @property
    def n(self) -> int:
        """Number of joints."""
        return int(self.rest.shape[1])

    @property
    def independent(self) -> float:
        """Number of independent samples."""
        return len(self.rest) / self.thin

    def with_columns(self, rows: tuple[int, ...], columns: Floats, scale: Floats | None = None) -> Problem:
        """The problem with more known columns [N, rows, c], in N m or N, fitted freely, or with a prior of
        standard deviations ``scale`` [c]."""
        wide = np.zeros((*self.rest.shape, columns.shape[2]))
        wide[:, list(rows)] = columns / self.sigma[list(rows)][None, :, None]
        A = np.concatenate([self.A, wide], axis=2)
        grams, rights = _grams(A, self.rest, self.parts)
        prior = np.concatenate([self.prior, _precisions(columns.shape[2], scale, self.thin)])
        return replace(self, A=A, prior=prior, grams=grams, rights=rights)


def _precisions(c: int, scale: Floats | None, thin: float) -> Floats:
    """The precisions [c] of coefficients that are free, or have standard deviations ``scale`` [c]."""
    return np.full(c, FREE_PRECISION) if scale is None else thin / scale**2


def without(p: Problem, mask: NDArray[np.bool_]) -> Problem:
    """The problem without the rows of ``mask`` [N], which no longer count."""
    kept = ~mask
    rest, A = p.rest * kept[:, None], p.A * kept[:, None, None]
    grams, rights = _grams(A, rest, p.parts)
    return replace(p, rest=rest, A=A, grams=grams, rights=rights)


def less(p: Problem, rows: tuple[int, ...], column: Floats) -> Problem:
    """The problem with a column [N, rows] taken off, in N m or N."""
    at = list(rows)
    rest = p.rest.copy()
    rest[:, at] -= column / p.sigma[at]
    return replace(p, rest=rest, rights=_rights(p.A, rest, p.parts))


def coarser(p: Problem, factor: Floats) -> Problem:
    """The problem with noise that is larger by a ``factor`` [n]."""
    rest, A = p.rest / factor, p.A / factor[:, None]
    grams, rights = _grams(A, rest, p.parts)
    return replace(p, rest=rest, A=A, sigma=p.sigma * factor, grams=grams, rights=rights)


def tighter(p: Problem, share: float) -> Problem:
    """The problem with a nuisance that is known better: its standard deviations are a ``share``."""
    prior = p.prior.copy()
    prior[: p.nuisance] /= share**2
    return replace(p, prior=prior)


def wider(p: Problem, fresh: Problem) -> Problem:
    """The problem with the nuisance of ``fresh``, which is of the same log: its columns in the weights and
    without the rows that no longer count."""
    A = fresh.A * (fresh.sigma / p.sigma)[:, None] * np.any(p.rest != 0, axis=1)[:, None, None]
    grams, rights = _grams(A, p.rest, p.parts)
    return replace(p, A=A, prior=fresh.prior, grams=grams, rights=rights, nuisance=fresh.nuisance)


def problem(
    rest: Floats, Y: Floats, sigma: Floats, thin: float, encoder_noise: Floats | None = None
) -> Problem:
    """The problem of the residual ``rest`` [N, n] and the nuisance ``Y`` [N, n, p], a unit of each column
    being a standard deviation of its prior; ``encoder_noise`` [n] is the part of
    ``sigma`` that comes from the encoders."""
    edges = np.linspace(0, len(rest), BLOCKS + 1).astype(int)
    parts = tuple(slice(int(a), int(b)) for a, b in pairwise(edges))
    A, b = Y / sigma[None, :, None], rest / sigma
    grams, rights = _grams(A, b, parts)
    prior = np.full(Y.shape[2], thin)
    by_encoders = np.zeros_like(sigma) if encoder_noise is None else encoder_noise
    return Problem(b, A, prior, sigma, parts, grams, rights, thin, Y.shape[2], by_encoders)


def _grams(A: Floats, b: Floats, parts: tuple[slice, ...]) -> tuple[Floats, Floats]:
    flat = [A[part].reshape(-1, A.shape[2]) for part in parts]
    return np.stack([a.T @ a for a in flat]), _rights(A, b, parts)


def _rights(A: Floats, b: Floats, parts: tuple[slice, ...]) -> Floats:
    return np.stack([A[part].reshape(-1, A.shape[2]).T @ b[part].reshape(-1) for part in parts])


@dataclass(frozen=True, slots=True, eq=False)
class Fit:
    """``x`` [c]: coefficients of the columns tried, ``cov`` [c, c]; ``known`` [p] those of the problem's own;
    ``held_out`` [BLOCKS, n]: mean square errors on the parts that were held out, in units of the noise;
    ``prior_penalty`` of the nuisance, in units of log-likelihood."""

    x: Floats
    cov: Floats
    known: Floats
    held_out: Floats
    prior_penalty: float


def fitted(
    p: Problem,
    rows: tuple[int, ...] = (),
    columns: Floats | None = None,
    signs: tuple[int, ...] = (),
    scale: Floats | None = None,
) -> Fit:
    """The problem with the columns [N, rows, c] tried; ``signs`` +1 keeps a coefficient from being
    negative; ``scale`` [c]: standard deviations of a prior about 0, where they have one."""
    at = list(rows)
    c = 0 if columns is None else columns.shape[2]
    X = np.zeros((len(p.rest), 0, 0)) if columns is None else columns / p.sigma[at][None, :, None]
    size = np.sqrt(np.mean(X**2, axis=(0, 1))) if c else np.zeros(0)
    size = np.where(size > 0, size, 1.0)
    X = X / size if c else X
    P = p.A.shape[2]
    grams = np.zeros((BLOCKS, P + c, P + c))
    rights = np.zeros((BLOCKS, P + c))
    grams[:, :P, :P], rights[:, :P] = p.grams, p.rights
    if c:
        for k, part in enumerate(p.parts):
            x = X[part].reshape(-1, c)
            y = p.A[part][:, at].reshape(-1, P)
            grams[k, P:, P:] = x.T @ x
            grams[k, P:, :P] = x.T @ y
            grams[k, :P, P:] = grams[k, P:, :P].T
            rights[k, P:] = x.T @ p.rest[part][:, at].reshape(-1)
    prior = np.concatenate([p.prior, _precisions(c, None if scale is None else scale * size, p.thin)])
    G, g = grams.sum(axis=0), rights.sum(axis=0)
    systems = np.concatenate([(G - grams) + np.diag(prior), (G + np.diag(prior))[None]])
    right = np.concatenate([g - rights, g[None]])
    solutions = np.linalg.solve(systems, right[:, :, None])[:, :, 0]
    for k in range(BLOCKS + 1):
        solutions[k] = _signed(systems[k], right[k], solutions[k], P, signs)
    held_out = np.empty((BLOCKS, p.n))
    for k, part in enumerate(p.parts):
        left = p.rest[part] - p.A[part] @ solutions[k, :P]
        if c:
            left[:, at] -= X[part] @ solutions[k, P:]
        held_out[k] = np.mean(left**2, axis=0)
    whole = solutions[-1]
    spread = p.thin * np.linalg.inv(systems[-1])[P:, P:] * max(float(held_out.mean()), 1e-300)
    prior_penalty = float(np.sum(p.prior[: p.nuisance] * whole[: p.nuisance] ** 2)) / p.thin / 2
    return Fit(
        whole[P:] / size, spread / np.outer(size, size) if c else spread, whole[:P], held_out, prior_penalty
    )


def _signed(system: Floats, right: Floats, x: Floats, P: int, signs: tuple[int, ...]) -> Floats:
    """The solution without the columns that come out negative and may not."""
    free = np.ones(len(x), bool)
    for _ in range(len(signs)):
        wrong = [P + i for i, sign in enumerate(signs) if sign > 0 and x[P + i] < 0]
        if not wrong:
            break
        free[min(wrong, key=lambda i: x[i])] = False
        x = np.zeros(len(x))
        x[free] = np.linalg.solve(system[np.ix_(free, free)], right[free])
    return x
