"""A unit beside its type: how likely it is that any of its features has changed, or was always another."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.limits import (
    HALF,
    INFORMED,
    LEAST_AFTER,
    LEAST_BEFORE,
    NOT_YET,
    OTHER_UNIT,
    STANDS_ALONE,
    UNKNOWN,
)
from robodyn.fleet.pool.changes import (
    Change,
    Courses,
    History,
    change_at,
    changes,
    courses,
    directions_of,
)
from robodyn.fleet.pool.features import Direction, Watched
from robodyn.fleet.pool.type_model import TypeModel

Floats = NDArray[np.float64]
#: The logs of a unit that are looked for a change at least.
LEAST_LOGS: Final = LEAST_AFTER + LEAST_BEFORE


@dataclass(frozen=True, slots=True, eq=False)
class Suspicion:
    """What speaks most for a feature of a unit being odd: ``worth``, a log-likelihood ratio of ``numbers``
    amplitudes, the best of so many independent ``tests``. A change has a course (``share`` [L] at the unit's
    logs), else it was so ``always``; ``direction`` [s, k] of the numbers that differ by the amplitudes of
    ``change``, or, of what is no number y, None. ``freedom``: of the scatter beside which it is odd."""

    feature: Watched
    effects: tuple[str, ...]
    always: bool
    worth: float
    numbers: int
    tests: float
    change: Change
    share: Floats
    direction: Floats | None
    freedom: float


class Unit:
    """A unit (from 0) of a type: its histories, and suspicions."""

    def __init__(self, model: TypeModel, unit: int) -> None:
        self.model, self.unit = model, unit
        self.logs = model.logs_of(unit)
        self.dates = model.dates[self.logs]
        self._history: History | None = None
        has_logs = len(self.logs) >= LEAST_LOGS
        self.courses = courses(self.dates) if has_logs else _no_courses(len(self.logs))
        self.steps = courses(self.dates, steps_only=True) if has_logs else _no_courses(len(self.logs))

    @property
    def history(self) -> History:
        """What its logs say of the numbers y: a megabyte."""
        if self._history is None:
            self._history = self.model.history(self.logs)
        return self._history

    def forget(self) -> None:
        """Let go of the history, until it is asked for again."""
        self._history = None

    def history_of(self, feature: Watched) -> History:
        """That of the numbers y, or of one number, where the feature is no such number."""
        if feature.directions or feature.joint is None:
            return self.history
        sizes, j = self.model.sizes[feature.kind], feature.joint - 1
        common, value = sizes.common[j], sizes.value[self.logs, j]
        known = np.isfinite(value)
        variance = np.where(known, common.between_logs**2 + sizes.variance[self.logs, j], UNKNOWN)
        value = np.where(known, value, common.mean)
        wide = (OTHER_UNIT * common.between_units) ** 2
        prior = (np.array([[1 / wide]]), np.array([common.mean / wide]))
        return History(self.dates, (1 / variance)[:, None, None], (value / variance)[:, None], prior, 1)

    def courses_of(self, feature: Watched, *, fine: bool = False) -> Courses:
        """Those that a feature may take: a body is there or not."""
        if fine:
            return courses(self.dates, steps_only=feature.kind == "body", fine=True)
        return self.steps if feature.kind == "body" else self.courses

    def direction(self, one: Direction) -> Floats:
        """A way to change, of the numbers of this unit."""
        means = np.maximum(self.history.mean[list(one.places)], 0.0) if one.in_proportion else None
        if means is not None and not means.any():
            means = np.ones(len(one.places))
        return directions_of(one.places, self.model.places.size, means)

    def suspicions(self, history: History | None = None) -> Iterator[Suspicion]:
        """Of each feature and way the change that is worth most, of its numbers in ``history`` (None:
        all)."""
        history = history or self.history
        scored: dict[int, tuple[Floats, Floats]] = {}
        for feature in self.model.features:
            several = self.courses_of(feature)
            if not len(several.shares):
                continue
            if not feature.directions:
                own = self.history_of(feature)
                best = self._best(own, own.scores(several.shares), several, np.ones((1, 1)))
                yield Suspicion(feature, feature.effects, False, *best, None, self.model.freedom_of_logs)
                continue
            if id(several) not in scored:
                scored[id(several)] = history.scores(several.shares)
            for way in feature.directions:
                direction = self.direction(way)
                best = self._best(history, scored[id(several)], several, direction, len(feature.directions))
                yield Suspicion(feature, way.effects, False, *best, direction, self.model.freedom_of_logs)

    def _best(
        self,
        history: History,
        scores: tuple[Floats, Floats],
        several: Courses,
        direction: Floats,
        ways: int = 1,
    ) -> tuple[float, int, float, Change, Floats]:
        """Of the courses that which is worth most in a direction: its worth, the number of amplitudes and of
        tests, the change, its shares. A unit whose logs scatter more than others' is believed less."""
        A, b = scores
        worth, _ = changes(A, b, direction)
        says = history.says(direction)
        informed = (says > INFORMED * np.median(says[says > 0])) if (says > 0).any() else says > 0
        shown = (several.shares[:, informed] >= HALF).sum(axis=1) >= LEAST_AFTER
        shown &= (several.shares[:, informed] <= NOT_YET).sum(axis=1) >= LEAST_BEFORE
        worth = np.where(shown, worth, 0.0)
        m = int(np.argmax(worth))
        change, share = change_at(A[m], b[m], direction), several.shares[m]
        sure = change.worth / history.excess(share, direction)
        return sure, direction.shape[1], several.worth * ways, change, share

    def deviations(self) -> Iterator[Suspicion]:
        """Of each feature how far the unit's own mean is from its siblings'. What of it is the unit's links
        is in the scatter of units."""
        for feature in self.model.features:
            if not feature.directions:
                continue  # programs of motion differ from unit to unit, and with them what is left
            way = feature.directions[0]
            off, spread = self._level_off(way) if way.in_proportion else self._numbers_off(way)
            worth = float(off @ np.linalg.solve(spread, off)) / 2
            yield Suspicion(
                feature, way.effects, True, worth, len(off), 1.0, Change(worth, off, spread),
                np.ones(len(self.logs)), self.direction(way), self.model.freedom_of_units,
            )  # fmt: skip

    def _numbers_off(self, way: Direction) -> tuple[Floats, Floats]:
        """How far the body of the unit is from its siblings' [k], and the variance of that [k, k]."""
        means, _ = self.model.between_units()
        own = [self.model.mean_of(self.unit, place) for place in way.places]
        off = np.array([value - means[place] for place, (value, _) in zip(way.places, own, strict=True)])
        return off, self.model.body_spread + np.diag([variance for _, variance in own])

    def _level_off(self, way: Direction) -> tuple[Floats, Floats]:
        """How far the level of a joint's friction is from its siblings' [1], and the variance of that [1, 1]:
        as it would be if its logarithm scattered as it does, for units differ by factors."""
        places, j = list(way.places), way.places[0]
        level, weights = self.model.levels[j], np.array([float(self.model.speed[j]), 1.0])
        values = self.model.value[self.logs][:, places] @ weights
        variance = [weights @ self.model.covariance[k][np.ix_(places, places)] @ weights for k in self.logs]
        sure = 1 / (np.array(variance) + level.between_logs**2)
        own, variance_of = float(sure @ values / sure.sum()), 1 / float(sure.sum())
        off = own - level.mean
        if level.mean <= 0 or own <= 0 or off == 0:
            return np.array([off]), np.array([[variance_of + level.between_units**2]])
        far, usual = float(np.log(own / level.mean)), level.between_units / level.mean
        sigma = np.sqrt(usual**2 + variance_of / own**2)
        return np.array([off]), np.array([[(off * sigma / far) ** 2]])

    def stands_alone(self, one: Suspicion) -> bool:
        """Whether a change is there without any one of the logs: a single odd log is none."""
        if one.always:
            return True
        feature = one.feature
        history = self.history_of(feature)
        direction = one.direction if one.direction is not None else np.ones((1, 1))
        for k in range(len(self.logs)):
            share = np.delete(one.share, k)
            if share.max() == share.min():
                return False
            A, b = history.leaving_out(k).scores(share[None])
            if changes(A, b, direction)[0][0] < STANDS_ALONE * one.worth:
                return False
        return True


def _no_courses(logs: int) -> Courses:
    return Courses(np.zeros((0, logs)), np.zeros(0), np.zeros(0))
