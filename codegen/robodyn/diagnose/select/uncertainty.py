"""How well the logs tell the numbers of all findings: standard errors, and intervals by profile likelihood.

Standard errors are those of :mod:`robodyn.diagnose.select.local_fit`. A number in which an effect is not
linear (a width of backlash, a velocity, a stiffness) need not have a misfit that is a parabola. Its interval
is where the misfit along it, all other numbers refitted, is larger by no more than chance would have it; the
misfit is scaled so that near its minimum it agrees with the standard error (Chandler and Bate 2007). A side
on which it never grows so much is open.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.diagnose.limits import HALF_WIDTH
from robodyn.diagnose.select.about import fitted_about
from robodyn.diagnose.select.fit import Problem
from robodyn.diagnose.select.library import Context
from robodyn.diagnose.select.limits import (
    BETTER_FIT,
    FARTHEST_BOUND,
    NEAR_BOUND,
    PROFILE_RESTARTS,
    PROFILE_STEPS,
    PROFILE_TRIES,
    STRIKE_ACCURACY,
)
from robodyn.diagnose.select.local_fit import LocalFit, inverse_of
from robodyn.diagnose.select.motion_noise import unbiased
from robodyn.diagnose.select.own_numbers import feels_loads
from robodyn.diagnose.select.refine import Freed, fitted
from robodyn.effects.catalogue import CATALOGUE
from robodyn.effects.effect import Coupler
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
    under_load = feels_loads(amended(robot, amendments))
    if freed.sticking or under_load or freed.amendments != tuple(amendments):
        x = fitted(freed)
    if under_load and freed.places:
        freed, x = fitted_about(freed, x)
    if freed.places:
        for restarts in range(PROFILE_RESTARTS, -1, -1):
            fit = LocalFit.of(freed, x)
            if fit is None:
                break
            known, better = _all(fit, may_move=restarts > 0)
            if better is None:
                x, known = _without_bias(fit, known)
                break
            x = better
    sure: list[dict[str, Uncertainty]] = [{} for _ in amendments]
    for (k, name), one in zip(freed.places, known, strict=False):
        if one is not None:
            sure[k][name] = one
    return freed.changed(x), sure


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


def _without_bias(fit: LocalFit, known: list[Uncertainty | None]) -> tuple[Floats, list[Uncertainty | None]]:
    """The values [P] of a ``fit``, and what is ``known`` of them, without what the encoders' noise does."""
    other, moved = unbiased(fit), list[Uncertainty | None]()
    for i, one in enumerate(known):
        value, before, wider = float(other.x[i]), float(fit.x[i]), float(other.wider[i])
        if one is None or value == before:
            moved.append(one)
            continue
        ends = [None if end is None else value + wider * (end - before) for end in (one.low, one.high)]
        if fit.freed.sizes[i]:  # an end beyond zero says that the logs leave that side open
            ends = [None if end is None or end * value <= 0 else end for end in ends]
        moved.append(Uncertainty(None if one.stderr is None else wider * one.stderr, *ends))
    return other.x, moved


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
        own = inverse_of(fit.curvature)
        self.error = float(fit.errors[i])
        #: The misfit is larger by this, one standard error away.
        self.unit = max(self.error**2 / max(own[i, i], 1e-300), 1e-300)
        #: How the others go along.
        self.way = own[:, i] / own[i, i]
        self.others = np.delete(np.arange(len(fit.x)), i)
        self.inverse = inverse_of(fit.curvature[np.ix_(self.others, self.others)])
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
