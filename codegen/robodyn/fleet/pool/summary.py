"""What is said of types and units beside the claims, and which units to look at first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from robodyn.effects.catalogue import CATALOGUE
from robodyn.fleet.as_json import day
from robodyn.fleet.limits import FIRST
from robodyn.fleet.pool.features import Watched
from robodyn.fleet.pool.type_model import TypeModel
from robodyn.fleet.pool.unit import Unit
from robodyn.fleet.result import Claim, Feature, Look, Reading, TypeResult, UnitResult
from robodyn.robot.account import account_lines

Floats = NDArray[np.float64]


def type_result(model: TypeModel) -> TypeResult:
    """What units of a type have in common."""
    features = []
    for feature in model.features:
        common, slopes = _common_of(model, feature)
        features.append(
            Feature(
                feature.name, feature.effects, feature.joint, feature.unit, common[0], common[1], common[2],
                slopes, len(model.logs),
            )
        )  # fmt: skip
    robot = model.robot
    return TypeResult(
        model.name, robot.n, len(model.units), len(model.logs), tuple(features), tuple(account_lines(robot))
    )


def _common_of(model: TypeModel, feature: Watched) -> tuple[tuple[float, float, float], dict[str, float]]:
    """Mean and scatters of a feature, and what conditions do to it."""
    if not feature.directions:
        one = model.sizes[feature.kind].common[(feature.joint or 1) - 1]
        return (one.mean, one.between_units, one.between_logs), {}
    place = feature.directions[0].places[0]
    one, names = model.numbers[place], model.condition_names
    slopes = dict(zip(names, one.slopes.tolist(), strict=False))
    if feature.kind != "friction":
        return (one.mean, one.between_units, one.between_logs), slopes
    j = (feature.joint or 1) - 1
    level, dry = model.levels[j], model.numbers[model.places.coulomb(j)]
    turning = float(model.speed[j]) * one.mean
    slopes = {
        name: turning * a + dry.mean * b for name, a, b in zip(names, one.slopes, dry.slopes, strict=False)
    }
    return (level.mean, level.between_units, level.between_logs), slopes


def readings(unit: Unit, feature: Watched) -> tuple[Reading, ...]:
    """What each log of a unit shows of a feature."""
    model, result = unit.model, []
    for k in unit.logs:
        if not feature.directions:
            sizes, j = model.sizes[feature.kind], (feature.joint or 1) - 1
            value, variance = float(sizes.value[k, j]), float(sizes.variance[k, j])
            if not np.isfinite(value):
                continue
        else:
            weight = np.zeros(model.places.size)
            places = feature.directions[0].places
            if feature.kind == "friction":
                weight[list(places)] = float(model.speed[(feature.joint or 1) - 1]), 1.0
            else:
                weight[places[0]] = 1.0
            value = float(weight @ model.value[k])
            variance = float(weight @ model.covariance[k] @ weight)
        result.append(Reading(float(model.dates[k]), value, float(np.sqrt(max(variance, 0.0)))))
    return tuple(result)


def unit_result(unit: Unit, claims: tuple[Claim, ...], unusual: Mapping[str, float]) -> UnitResult:
    """All that is said of a unit."""
    model = unit.model
    every = {feature.name: readings(unit, feature) for feature in model.features}
    series = {name: values for name, values in every.items() if values}
    return UnitResult(
        model.name, model.units[unit.unit], len(unit.logs), float(unit.dates[0]), float(unit.dates[-1]),
        claims, series, {name: _now(values, claims, name) for name, values in series.items()}, unusual,
    )  # fmt: skip


def _now(values: Sequence[Reading], claims: Sequence[Claim], name: str) -> tuple[float, float]:
    """What a feature comes to now: the mean of readings since it changed."""
    since = max(
        (claim.since for claim in claims if claim.feature == name and claim.since is not None), default=None
    )
    late = [one for one in values if since is None or one.date >= since] or list(values[-1:])
    weight = np.array([1 / max(one.stderr, 1e-9) ** 2 for one in late])
    value = np.array([one.value for one in late])
    return float(weight @ value / weight.sum()), float(1 / np.sqrt(weight.sum()))


def first_to_look_at(types: Sequence[TypeResult], units: Sequence[UnitResult]) -> tuple[Look, ...]:
    """The units to look at first, the surest first."""
    named = sorted(
        (one for one in units if one.claims), key=lambda one: (one.claims[0].p, one.type, one.unit)
    )
    return tuple(Look(one.type, one.unit, why(one.claims[0]), record(one.claims[0])) for one in named[:FIRST])


def why(claim: Claim) -> str:
    """A claim in a sentence."""
    what = " and ".join(CATALOGUE[id].title.lower() for id in claim.effects) or "what no effect explains"
    where = f" at joint {claim.joint}" if claim.joint else ""
    amount = "" if claim.share is None else f", {claim.share:+.0%}"
    if claim.share is None and claim.unit != "-":
        amount = f", {claim.size:+.3g} {claim.unit}"
    if claim.since is None:
        return f"{what}{where}{amount} beside its siblings, in all its logs"
    return f"{what}{where}{amount} since {day(claim.since)[:10]}"


def record(claim: Claim) -> str:
    """What to record next, in words."""
    sought = [CATALOGUE[id].separates for id in claim.effects if CATALOGUE[id].separates]
    return sought[0] if sought else "a motion of all joints, slow and fast, with and without load"
