"""All numbers of the findings near where they fit best: slopes, curvature, standard errors.

Standard errors are those of the joint fit with the arm's own numbers left free within their confidence:
curvature of the misfit, with residuals that are correlated over time (Liang and Zeger 1986: scores by parts
of the log; and no less than their autocorrelation has it). What the filter of positions takes from the
motion is in no residual: about as much as a second pass of it moves the numbers by.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.select.about import moved, shown_numbers
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.limits import LEAST_CURVATURE, LEAST_SPREAD, SCORE_PARTS
from robodyn.diagnose.select.refine import Freed, weights
from robodyn.identify.intervals import correlations

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class LocalFit:
    """The fit at values ``x`` [P]: what is ``left`` [N n], weighted by ``weight`` [N n]; weighted slopes
    ``J`` [N n, P] and the arm's own numbers ``A`` [N n, p] with the inverse of their normal matrix, prior
    included, ``inverse`` [p, p]; how these numbers go ``along`` with x [p, P] and, where the fit is about an
    arm of other numbers than described, their ``ways`` [count, p]; the ``misfit``, the normal matrix
    ``curvature`` [P, P] of x with the arm's own numbers eliminated, and the standard ``errors`` [P] of x."""

    freed: Freed
    x: Floats
    weight: Floats
    J: Floats
    A: Floats
    inverse: Floats
    ways: Floats | None
    along: Floats
    misfit: float
    curvature: Floats
    errors: Floats

    @classmethod
    def of(cls, freed: Freed, x: Floats) -> LocalFit | None:
        """None where there is no such robot."""
        left = freed.missed(x)
        if left is None:
            return None
        start = freed.start
        nuisance, prior = freed.own_numbers(x)
        weight, _ = weights(left.reshape(-1, start.n), nuisance, prior)
        J, A = weight[:, None] * freed.slopes(x, left), weight[:, None] * nuisance
        inverse = inverse_of(A.T @ A + prior.T @ prior)
        cross = A.T @ J
        curvature = J.T @ J - cross.T @ inverse @ cross
        left = weight * left
        z = inverse @ (A.T @ left)
        misfit = float(left @ left - (A.T @ left) @ z)
        # What the arm's own numbers make up for of the columns is taken off first: two numbers that only
        # their ratio shows would be lost among many columns.
        others = -inverse @ cross @ (own := inverse_of(curvature))
        influence = J @ own + A @ others
        errors = _errors(start, influence, others, np.diag(own), left - A @ z, prior)
        smoother = freed.smoother().missed(x)
        if smoother is not None:
            errors = np.hypot(errors, influence.T @ (weight * smoother - left))
        ways = None if freed.about is None else shown_numbers(freed, x)
        return cls(freed, x, weight, J, A, inverse, ways, -inverse @ cross, misfit, curvature, errors)

    def misfit_at(self, x: Floats) -> tuple[float, Floats] | None:
        """The misfit at values ``x`` [P], the arm's own numbers refitted, and half its slopes [P] by the
        values, columns taken to be those of :attr:`x`."""
        freed, explained = self.freed, np.zeros(len(self.weight))
        if self.ways is not None:
            p = self.ways.shape[1]
            numbers = (self.along @ (x - self.x))[:p]
            freed, explained = moved(freed, self.ways @ numbers), self.A[:, :p] @ numbers
        left = freed.missed(x)
        if left is None:
            return None
        left = self.weight * left + explained
        pull = self.A.T @ left
        z = self.inverse @ pull
        return float(left @ left - pull @ z), self.J.T @ (left - self.A @ z)


def inverse_of(H: Floats) -> Floats:
    """The inverse of a positive matrix [P, P]; what has next to no curvature is left nearly free."""
    scale = np.sqrt(np.where(np.diag(H) > 1e-200, np.diag(H), 1.0))
    sizes, directions = np.linalg.eigh(H / np.outer(scale, scale))
    return np.asarray(
        (directions / np.maximum(sizes, LEAST_CURVATURE)) @ directions.T / np.outer(scale, scale)
    )


def _errors(
    start: Problem, influence: Floats, others: Floats, least: Floats, left: Floats, prior: Floats
) -> Floats:
    """Standard errors [P] of numbers that change by the ``influence`` [N n, P] of each residual, of which
    ``left`` [N n] are left, both weighted, and by ``others`` [p, P] with the arm's own numbers, which have a
    prior (its root ``prior`` [p, p]); ``least`` [P]: their variances if each residual were of size 1.

    The wider one of two counts: by how residuals are correlated over time, as seen through the
    columns; and by how much the parts of the log pull. A direction in which nothing shows (its curvature was
    raised) has no influence: there residuals like those of the quietest joint count."""
    n, own = start.n, influence.shape[1]
    by_joint, influence = left.reshape(-1, n), influence.reshape(-1, n, own)
    of_prior = start.thin * others.T @ prior.T @ prior @ others
    counted = np.maximum(np.mean(start.weight**2, axis=0), 1e-9)
    plain = of_prior.copy()
    squares = np.mean(by_joint**2, axis=0) / counted
    for j, square in enumerate(squares):
        U = influence[:, j]
        for lag, share in enumerate(correlations(by_joint[:, j])):
            together = U[: len(U) - lag].T @ U[lag:]
            plain += square * share * (together + together.T if lag else together)
    pulls = influence * by_joint[:, :, None]
    scores = np.stack([part.sum(axis=(0, 1)) for part in np.array_split(pulls, SCORE_PARTS)])
    scores = scores - scores.mean(axis=0)
    wide = scores.T @ scores * SCORE_PARTS / (SCORE_PARTS - 1) + of_prior
    quiet = max(LEAST_SPREAD, float(squares.min()))
    widest = np.max([np.diag(plain), np.diag(wide), np.diag(of_prior), quiet * least], axis=0)
    return np.asarray(np.sqrt(widest))
