"""How well the logs tell the numbers of all findings: standard errors, and intervals by profile likelihood.

Standard errors are those of the joint fit with the arm's own numbers left free within their confidence:
curvature of the misfit, with residuals that are correlated over time (Liang and Zeger 1986: scores by parts
of the log; and no less than their autocorrelation has it). What the filter of positions takes from the
motion is in no residual: about as much as a second pass of it moves the numbers by.

A number in which an effect is not linear (a width of backlash, a velocity, a stiffness) need not have a
misfit that is a parabola. Its interval is where the misfit along it, all other numbers refitted, is larger by
no more than chance would have it; the misfit is scaled so that near its minimum it agrees with the standard
error (Chandler and Bate 2007). A side on which it never grows so much is open.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.limits import HALF_WIDTH
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.library import Context
from robodyn.diagnose.select.limits import (
    BETTER_FIT,
    FARTHEST_BOUND,
    LEAST_CURVATURE,
    LEAST_SPREAD,
    NEAR_BOUND,
    PROFILE_RESTARTS,
    PROFILE_STEPS,
    PROFILE_TRIES,
    SCORE_PARTS,
    STRIKE_ACCURACY,
)
from robodyn.diagnose.select.own_numbers import feels_loads
from robodyn.diagnose.select.refine import Freed, fitted, weights
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Coupler
from robodyn.identify.intervals import correlations
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Uncertainty:
    """Of a number: the standard error, None where the logs do not bound the number on both sides; where its
    95 % interval ends, None where it is open."""

    stderr: float | None
    low: float | None
    high: float | None


def uncertainties(
    robot: Robot, amendments: Sequence[Amendment], contexts: Sequence[Context], start: Problem
) -> tuple[list[Amendment], list[dict[str, Uncertainty]]]:
    """The ``amendments``, with better numbers where a profile comes across such, and by name how well the
    logs tell the numbers of each; of choices, and of numbers that nothing was fitted to, nothing."""
    freed = Freed.of(robot, amendments, contexts, start, by_drives=True).with_sticking()
    x, known = freed.x, list[Uncertainty | None]()
    if freed.sticking or feels_loads(amended(robot, amendments)):
        x = fitted(freed)
    if freed.places:
        for restarts in range(PROFILE_RESTARTS, -1, -1):
            fit = LocalFit.of(freed, x)
            if fit is None:
                break
            known, better = _all(fit, may_move=restarts > 0)
            if better is None:
                break
            x = better
    sure: list[dict[str, Uncertainty]] = [{} for _ in amendments]
    for (k, name), one in zip(freed.places, known, strict=False):
        if one is not None:
            sure[k][name] = one
    return freed.changed(x), sure


@dataclass(frozen=True, slots=True, eq=False)
class LocalFit:
    """The fit at values ``x`` [P]: what is ``left`` [N n], weighted by ``weight`` [N n]; weighted slopes
    ``J`` [N n, P] and the arm's own numbers ``A`` [N n, p] with the inverse of their normal matrix, prior
    included, ``inverse`` [p, p]; the ``misfit``, the normal matrix ``curvature`` [P, P] of x with the arm's
    own numbers eliminated, and the standard ``errors`` [P] of x."""

    freed: Freed
    x: Floats
    weight: Floats
    J: Floats
    A: Floats
    inverse: Floats
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
        inverse = _inverse(A.T @ A + prior.T @ prior)
        cross = A.T @ J
        curvature = J.T @ J - cross.T @ inverse @ cross
        left = weight * left
        z = inverse @ (A.T @ left)
        misfit = float(left @ left - (A.T @ left) @ z)
        # What the arm's own numbers make up for of the columns is taken off first: two numbers that only
        # their ratio shows would be lost among many columns.
        others = -inverse @ cross @ (own := _inverse(curvature))
        influence = J @ own + A @ others
        errors = _errors(start, influence, others, np.diag(own), left - A @ z, prior)
        smoother = freed.smoother().missed(x)
        if smoother is not None:
            errors = np.hypot(errors, influence.T @ (weight * smoother - left))
        return cls(freed, x, weight, J, A, inverse, misfit, curvature, errors)

    def misfit_at(self, x: Floats) -> tuple[float, Floats] | None:
        """The misfit at values ``x`` [P], the arm's own numbers refitted, and half its slopes [P] by the
        values, columns taken to be those of :attr:`x`."""
        left = self.freed.missed(x)
        if left is None:
            return None
        left = self.weight * left
        pull = self.A.T @ left
        z = self.inverse @ pull
        return float(left @ left - pull @ z), self.J.T @ (left - self.A @ z)


def _all(fit: LocalFit, *, may_move: bool) -> tuple[list[Uncertainty | None], Floats | None]:
    """Of each value; or better values [P] if a profile comes across such, and they may be taken."""
    known: list[Uncertainty | None] = []
    for i, (k, name) in enumerate(fit.freed.places):
        definition = CATALOGUE[fit.freed.amendments[k].effect]
        error, value = float(fit.errors[i]), float(fit.x[i])
        if name in definition.linear:
            half = HALF_WIDTH * error
            known.append(Uncertainty(error, value - half, value + half))
            continue
        profile = Profile(fit, i)
        bounds: list[float | None] = []
        for side in (-1, 1):
            bound, better = profile.bound(side, may_move=may_move)
            if better is not None:
                return known, better
            bounds.append(bound)
        if _strikes(definition.coupler, fit.freed.amendments[k].parameters):
            bounds = [None if end is None else value + _wider(end - value, value) for end in bounds]
        low, high = bounds
        stderr = None if low is None or high is None else (high - low) / 2 / HALF_WIDTH
        known.append(Uncertainty(stderr, low, high))
    return known, None


def _strikes(coupler: Coupler | None, values: Mapping[str, float | str]) -> bool:
    """Whether a link strikes what passes torque on to it: the twist between is not in proportion to that."""
    if coupler is None:
        return False
    return not np.isclose(coupler.twist(values, 2.0), 2 * coupler.twist(values, 1.0))


def _wider(half: float, value: float) -> float:
    """The signed distance ``half`` of an interval's end from a ``value``, with what the model of a link that
    strikes is off by."""
    return float(np.copysign(np.hypot(half, HALF_WIDTH * STRIKE_ACCURACY * value), half))


class Profile:
    """The misfit along value ``i`` of a fit, all others refitted. A size keeps its sign, and is varied by
    factors."""

    def __init__(self, fit: LocalFit, i: int) -> None:
        self.fit, self.i = fit, i
        own = _inverse(fit.curvature)
        self.error = float(fit.errors[i])
        #: The misfit is larger by this, one standard error away.
        self.unit = max(self.error**2 / max(own[i, i], 1e-300), 1e-300)
        #: How the others go along.
        self.way = own[:, i] / own[i, i]
        self.others = np.delete(np.arange(len(fit.x)), i)
        self.inverse = _inverse(fit.curvature[np.ix_(self.others, self.others)])
        self.sizes = fit.freed.sizes
        self.is_size = bool(self.sizes[i])

    def value(self, distance: float) -> float:
        """The value at a ``distance``, in logarithms or standard errors."""
        own = float(self.fit.x[self.i])
        return own * float(np.exp(distance)) if self.is_size else own + distance * self.error

    def larger(self, distance: float) -> tuple[float, Floats] | None:
        """By how much the misfit is larger there, as a square of standard errors, and all values; None where
        there is no robot."""
        fit, i = self.fit, self.i
        value = self.value(distance)
        x = self._kept(fit.x + (value - fit.x[i]) * self.way)
        x[i] = value
        best: tuple[float, Floats] | None = None
        for _ in range(PROFILE_STEPS):
            outcome = fit.misfit_at(x)
            if outcome is None:
                break
            misfit, pull = outcome
            if best is not None and not misfit < best[0]:
                break
            best = misfit, x
            if not len(self.others):
                break
            x = x.copy()
            x[self.others] -= self.inverse @ pull[self.others]
            x = self._kept(x)
        if best is None:
            return None
        return (best[0] - fit.misfit) / self.unit, best[1]

    def bound(self, side: Literal[-1, 1], *, may_move: bool) -> tuple[float | None, Floats | None]:
        """Where the interval ends on one side, None where it is open; or values [P] that fit better, if it
        ``may_move`` to such."""
        farthest = FARTHEST_BOUND if self.is_size else FARTHEST_BOUND * HALF_WIDTH
        scale = self.error / abs(float(self.fit.x[self.i])) if self.is_size else 1.0
        distance = min(HALF_WIDTH * scale, farthest)
        inner, outer = (0.0, 0.0), (np.inf, np.inf)
        for _ in range(PROFILE_TRIES):
            outcome = self.larger(side * distance)
            if may_move and outcome is not None and outcome[0] < -BETTER_FIT:
                return None, outcome[1]
            errors = np.inf if outcome is None else float(np.sqrt(max(outcome[0], 0.0)))
            if errors < HALF_WIDTH:
                inner = distance, errors
                if distance >= farthest:
                    return None, None
            else:
                outer = distance, errors
            if abs(errors - HALF_WIDTH) < NEAR_BOUND * HALF_WIDTH:
                break
            if np.isfinite(outer[1]):
                share = (HALF_WIDTH - inner[1]) / (outer[1] - inner[1])
                distance = inner[0] + min(max(share, 0.1), 0.9) * (outer[0] - inner[0])
            elif np.isfinite(outer[0]):
                distance = (inner[0] + outer[0]) / 2
            else:
                distance = min(distance * min(max(HALF_WIDTH / max(errors, 1e-9), 1.1), 3.0), farthest)
        return self.value(side * distance), None

    def _kept(self, x: Floats) -> Floats:
        """Values [P] of which sizes keep their signs."""
        own = self.fit.x
        return np.asarray(np.where(self.sizes & (x * own <= 0), own / 10, x))


def _inverse(H: Floats) -> Floats:
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
