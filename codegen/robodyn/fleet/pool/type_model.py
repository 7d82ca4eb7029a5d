"""A type of arm: its logs reduced to numbers, and the population of these."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import EFFICIENCY, FIRST_BODY, FIRST_SCATTER, LEAST_LEFT, OTHER_UNIT
from robodyn.fleet.pool.changes import History
from robodyn.fleet.pool.features import (
    BODY,
    Kind,
    Numbers,
    Reduced,
    Rigid,
    Watched,
    beside_unit,
    reduced,
    rigid_of,
    solved,
    watched,
    with_scatter,
)
from robodyn.fleet.pool.population import Common, Series, common_of, spread_of, standardised
from robodyn.fleet.sources.fleet import ArmType, LogFile
from robodyn.identify.prior import Usual
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Sizes:
    """A size of each joint that logs show as it would be in a usual motion: its logarithm ``value`` [K, n]
    (nan: a log does not show it) with ``variance`` [K, n], and its population by joint (``common`` [n])."""

    value: Floats
    variance: Floats
    common: tuple[Common, ...]


@dataclass(frozen=True, eq=False)
class TypeModel:
    """A type's ``robot`` and ``features``; its ``logs`` in order, the unit of each (``unit`` [K], from 0, of
    ``units``), their dates [K] and conditions beyond the usual ones [K, c] (``condition_names``); what its
    arms have in common (``rigid``), and the ``digests`` of logs by source, which need not be in memory; of
    the numbers y of each log, without what conditions do, marginal values [K, s] and covariances [K, s, s];
    populations of the numbers y (``numbers`` [s]) and of the level of friction (``levels`` [n], at the speeds
    ``speed`` [n]); what is no such number, by kind of feature (``sizes``)."""

    name: str
    robot: Robot
    features: tuple[Watched, ...]
    logs: tuple[LogFile, ...]
    units: tuple[str, ...]
    unit: NDArray[np.intp]
    dates: Floats
    condition_names: tuple[str, ...]
    conditions: Floats
    rigid: Rigid
    digests: Mapping[str, Digest]
    value: Floats
    covariance: tuple[Floats, ...]
    speed: Floats
    numbers: tuple[Common, ...]
    levels: tuple[Common, ...]
    sizes: Mapping[Kind, Sizes]

    @property
    def places(self) -> Numbers:
        """Which of the numbers y is what."""
        return Numbers(self.robot.n)

    @property
    def freedom_of_units(self) -> float:
        """Of scatters between units: medians tell as much as so many normal numbers would."""
        return max(1.0, EFFICIENCY * (len(self.units) - 1))

    @property
    def freedom_of_logs(self) -> float:
        """Of scatters between logs of a unit."""
        return max(1.0, EFFICIENCY * (len(self.logs) - len(self.units)))

    def scatter(self) -> Floats:
        """Covariance [s, s] of the numbers y from log to log: friction of a joint goes up and down as a
        whole."""
        own = np.array([one.between_logs for one in self.numbers])
        D = np.diag(own**2)
        for j, level in enumerate(self.levels):
            v, c, w = self.places.viscous(j), self.places.coulomb(j), float(self.speed[j])
            both = 2 * w * own[v] * own[c]
            shared = (level.between_logs**2 - own[c] ** 2 - (w * own[v]) ** 2) / both if both > 0 else 0.0
            D[v, c] = D[c, v] = float(np.clip(shared, -0.95, 0.95)) * own[v] * own[c]
        return D

    def between_units(self) -> tuple[Floats, Floats]:
        """Means and variances [s] of units."""
        means = np.array([one.mean for one in self.numbers])
        return means, np.array([one.between_units for one in self.numbers]) ** 2

    def history(self, which: Sequence[int]) -> History:
        """The logs ``which`` of a unit."""
        scatter = self.scatter()
        several = []
        for k in which:
            one = reduced(self.rigid, self.digests[self.logs[k].source])
            several.append(with_scatter(_settled(one, self.numbers, self.conditions[k]), scatter))
        means, variances = self.between_units()
        own = OTHER_UNIT**2 * variances
        precision = np.concatenate([1 / own, 1 / self.rigid.scatter**2])
        weighted = np.concatenate([means / own, np.zeros(len(self.rigid.scatter))])
        return History(
            self.dates[list(which)], np.array([one.information for one in several]),
            np.array([one.weighted for one in several]), (np.diag(precision), weighted), len(means),
        )  # fmt: skip

    def mean_of(self, unit: int, place: int) -> tuple[float, float]:
        """The mean of a number of the logs of a ``unit``, and its variance."""
        logs = self.logs_of(unit)
        variance = np.array([self.covariance[k][place, place] for k in logs])
        weight = 1 / (variance + self.numbers[place].between_logs ** 2)
        return float(weight @ self.value[logs, place] / weight.sum()), 1 / float(weight.sum())

    @cached_property
    def body_spread(self) -> Floats:
        """Covariance [4, 4] of a body at the tip from unit to unit."""
        places = self.places.body
        means = np.array([[self.mean_of(k, place)[0] for place in places] for k in range(len(self.units))])
        return spread_of(means, np.array([self.numbers[place].between_units for place in places]))

    def logs_of(self, unit: int) -> list[int]:
        """The logs of a unit, by date."""
        return np.flatnonzero(self.unit == unit).tolist()


def type_model(arm: ArmType, logs: Sequence[LogFile], digests: Mapping[str, Digest]) -> TypeModel:
    """The model of a type from the ``digests`` of its ``logs`` (by source; sorted by unit and date), which
    are asked for one after the other."""
    robot = read_text(arm.text, arm.spec, warn=lambda _: None)
    several = [replace(digests[log.source], roots=()) for log in logs]
    n, places = robot.n, Numbers(robot.n)
    units = tuple(dict.fromkeys(log.unit for log in logs))
    of_unit = {name: k for k, name in enumerate(units)}
    unit = np.array([of_unit[log.unit] for log in logs])
    usual = _usual(several)
    speed = usual.speed
    rigid = rigid_of(robot, usual, lambda: (digests[log.source] for log in logs))
    first = _first_scatter(rigid, usual)
    own = list[Reduced]()
    for name in units:
        raw = [reduced(rigid, digests[log.source]) for log in logs if log.unit == name]
        d = _beside(raw, rigid, first)
        own += [beside_unit(one, d) for one in raw]
    names, _, conditions = standardised(
        [{**log.conditions, **one.conditions} for log, one in zip(logs, several, strict=True)]
    )
    values, covariances = [], []
    for one in own:
        covariance = solved(one.information + np.diag(rigid.unseen), np.eye(places.size))
        covariances.append(covariance)
        values.append(covariance @ one.weighted)
    value, covariance = np.array(values), np.array(covariances)
    variance = np.einsum("kss->ks", covariance)
    typical = np.median(np.abs(value), axis=0) + np.median(np.sqrt(variance), axis=0)
    frictions = set(range(2 * n))
    none = np.zeros((len(logs), 0))
    numbers = tuple(
        common_of(
            Series(value[:, s], variance[:, s], unit, none if s in places.body else conditions),
            relative=s in frictions, usual=float(typical[s]),
        )
        for s in range(places.size)
    )  # fmt: skip
    factors = np.array([_factors(numbers, conditions[k]) for k in range(len(logs))])
    shifts = np.array([_shifts(numbers, conditions[k]) for k in range(len(logs))])
    value = (value - shifts) / factors
    covariance = covariance / (factors[:, :, None] * factors[:, None, :])
    levels = []
    for j in range(n):
        pair, w = [places.viscous(j), places.coulomb(j)], np.array([speed[j], 1.0])
        series = Series(
            value[:, pair] @ w, np.einsum("a,kab,b->k", w, covariance[:, pair][:, :, pair], w), unit, none
        )
        levels.append(common_of(series, relative=False, usual=float(w @ typical[pair])))
    sizes: dict[Kind, Sizes] = {
        "play": _sizes(several, unit, "bursts", ()),
        "unexplained": _sizes(several, unit, "left", ("speed", "acceleration", "torque", "cutoff")),
    }
    return TypeModel(
        arm.name, robot, watched(robot), tuple(logs), units, unit, np.array([log.date for log in logs]),
        names, conditions, rigid, digests, value, tuple(covariance), speed,
        numbers, tuple(levels), sizes,
    )  # fmt: skip


def _first_scatter(rigid: Rigid, usual: Usual) -> Floats:
    """Covariance [s, s] of the numbers y from log to log before logs speak: what is usual of drives."""
    torque = FIRST_SCATTER * usual.torque
    own = np.concatenate([torque / usual.speed, torque, torque, np.full(BODY, FIRST_BODY * rigid.mass)])
    return np.diag(own**2)


def _beside(raw: Sequence[Reduced], rigid: Rigid, scatter: Floats) -> Floats:
    """The numbers d [r] of a unit by all its logs, which scatter as is usual."""
    prior = np.concatenate([rigid.unseen, 1 / rigid.scatter**2])
    several = [with_scatter(one, scatter) for one in raw]
    H = np.sum([one.information for one in several], axis=0) + np.diag(prior)
    d = solved(H, np.sum([one.weighted for one in several], axis=0))
    return d[len(rigid.unseen) :]


def _sizes(several: Sequence[Digest], unit: NDArray[np.intp], name: str, motion: Sequence[str]) -> Sizes:
    """A size by its ``name`` (of :class:`Digest`) as it would be in a usual ``motion`` (further names)."""
    n, size = len(several[0].left), np.array([getattr(one, name) for one in several])
    is_ratio = name == "bursts"
    with np.errstate(all="ignore"):
        size = size if is_ratio else np.log(size)
    counts = np.array([one.struck if is_ratio else one.count for one in several])
    variance = np.maximum(1 / np.maximum(counts, 1.0), LEAST_LEFT**2)
    value, commons = np.full(size.shape, np.nan), list[Common]()
    for j in range(n):
        known = np.isfinite(size[:, j]) & (counts[:, j] > 0)
        if not known.any():
            commons.append(Common(0.0, 1.0, 1.0, np.zeros(0), relative=False))
            continue
        logs = [one for one, is_known in zip(several, known, strict=True) if is_known]
        _, _, beyond = standardised([{each: _log_of(one, each, j) for each in motion} for one in logs])
        _, own = np.unique(unit[known], return_inverse=True)
        series = Series(size[known, j], variance[known, j], own, beyond)
        common = common_of(series, relative=False, usual=1.0)
        value[known, j] = size[known, j] - common.shifts(beyond)
        commons.append(common)
    return Sizes(value, variance, tuple(commons))


def _log_of(one: Digest, name: str, j: int) -> float:
    """The logarithm of what a digest says of a log, or of joint ``j`` (from 0) of it."""
    value = np.broadcast_to(getattr(one, name), (len(one.left),))[j]
    return float(np.log(max(float(value), 1e-12)))


def _usual(several: Sequence[Digest]) -> Usual:
    """What is usual of torque, speed and acceleration."""

    def rms(name: str) -> Floats:
        squares = np.array([getattr(one, name) for one in several]) ** 2
        return np.asarray(np.maximum(np.sqrt(squares.mean(axis=0)), 1e-9))

    return Usual(rms("torque"), rms("speed"), rms("acceleration"))


def _factors(numbers: Sequence[Common], conditions: Floats) -> Floats:
    return np.array([float(one.factors(conditions[None, : len(one.slopes)])[0]) for one in numbers])


def _shifts(numbers: Sequence[Common], conditions: Floats) -> Floats:
    return np.array([float(one.shifts(conditions[None, : len(one.slopes)])[0]) for one in numbers])


def _settled(one: Reduced, numbers: Sequence[Common], conditions: Floats) -> Reduced:
    """What a log says of the numbers as they would be under usual conditions."""
    rest = len(one.weighted) - len(numbers)
    factors = np.concatenate([_factors(numbers, conditions), np.ones(rest)])
    shifts = np.concatenate([_shifts(numbers, conditions), np.zeros(rest)])
    weighted = one.weighted - one.information @ shifts
    return Reduced(one.information * np.outer(factors, factors), weighted * factors)
