"""From a suspicion to a claim: is it worth a name, which, since when, how much."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.pool.changes import change_at, changes, dated
from robodyn.fleet.pool.limits import (
    LEAST_ALWAYS,
    LEAST_BODY,
    LEAST_OF_ALL,
    LEAST_SHARE,
    LEFT_RISE,
    OTHER_WAY,
    PLAY_RISE,
    SURE_BODY,
    SURE_SIZE,
)
from robodyn.fleet.pool.unit import Suspicion, Unit
from robodyn.fleet.result import Claim, Shape

Floats = NDArray[np.float64]


def is_worth_a_name(unit: Unit, one: Suspicion) -> bool:
    """Whether it matters in practice."""
    size, stderr, share = size_of(unit, one)
    if one.feature.kind == "body":
        mass = float(unit.model.rigid.mass)
        return size > max(LEAST_BODY * mass, SURE_BODY * stderr)
    if not one.feature.directions:
        return size > (PLAY_RISE if one.effects else LEFT_RISE)
    if share is None or not one.always:
        return share is None or abs(share) > LEAST_SHARE
    return share > LEAST_ALWAYS or share < 1 / (1 + LEAST_ALWAYS) - 1


def largest_rise(one: Suspicion, others: Sequence[Suspicion]) -> Suspicion:
    """Where sizes have grown at several joints, the joint at which all of them have grown most: what shakes
    one joint shakes all."""
    if one.feature.directions:
        return one
    sizes = [each for each in others if not each.feature.directions]

    def risen(joint: int | None) -> float:
        return sum(
            max(float(each.change.amplitudes[0]), 0.0) for each in sizes if each.feature.joint == joint
        )

    same = [each for each in sizes if each.feature.kind == one.feature.kind]
    return max([one, *same], key=lambda each: (each.change.amplitudes[0] > 0, risen(each.feature.joint)))


def likeliest_way(one: Suspicion, others: Sequence[Suspicion]) -> Suspicion:
    """Of the ways in which a feature may have changed the first, unless another explains clearly more."""
    ways = [each for each in others if each.feature.name == one.feature.name and each.always == one.always]
    first = next((each for each in ways if each.effects == one.feature.effects), one)
    best = max([first, *ways], key=lambda each: each.change.worth)
    return best if best.change.worth > first.change.worth + OTHER_WAY else first


def size_of(unit: Unit, one: Suspicion) -> tuple[float, float, float | None]:
    """How much more of the feature there is, with its standard error, and as a share of what was."""
    model, feature, change = unit.model, one.feature, one.change
    error: Floats = np.sqrt(np.maximum(np.diag(change.covariance), 0))
    if feature.kind != "friction":
        size = float(change.amplitudes[0])
        share = None if feature.directions else math.expm1(size)
        return size, float(error[0]), share
    assert feature.joint is not None
    assert one.direction is not None
    j = feature.joint - 1
    level = np.zeros(model.places.size)
    level[[model.places.viscous(j), model.places.coulomb(j)]] = float(model.speed[j]), 1.0
    own = float(level @ unit.history.mean[: model.places.size])
    if one.always:  # its amplitude is the level's
        usual = model.levels[j].mean
        size = float(change.amplitudes[0])
        return size, float(error[0]), size / usual if usual > 0 else None
    by = level @ one.direction
    size, variance = float(by @ change.amplitudes), float(by @ change.covariance @ by)
    stderr = math.sqrt(max(variance, 0.0))
    before = own - size * float(_weighted_share(unit, one))
    return size, stderr, size / before if before > 0 else None


def _weighted_share(unit: Unit, one: Suspicion) -> float:
    """How much of a change the unit's mean has in it."""
    assert one.direction is not None
    weight = unit.history.says(one.direction)
    return float(weight @ one.share / max(weight.sum(), 1e-300))


def holds(one: Suspicion, claim: Claim) -> bool:
    """Whether a claim is still worth a name as it has come to be dated and measured."""
    least = SURE_BODY if one.feature.kind == "body" else SURE_SIZE
    if abs(claim.size) < least * claim.stderr:
        return False
    return one.feature.kind != "friction" or claim.share is None or abs(claim.share) > LEAST_OF_ALL


def claim_of(unit: Unit, one: Suspicion, p: float, q: float) -> Claim:
    """What is said of it."""
    feature, days = one.feature, None
    if not one.always:
        several = unit.courses_of(feature, fine=True)
        history = unit.history_of(feature)
        direction = one.direction if one.direction is not None else np.ones((1, 1))
        A, b = history.scores(several.shares)
        worth, _ = changes(A, b, direction)
        days = dated(several, worth)
        m = int(np.argmax(worth))
        one = replace(one, change=change_at(A[m], b[m], direction), share=several.shares[m])
    size, stderr, share = size_of(unit, one)
    shape: Shape = "always" if days is None else "step" if days.is_step else "drift"
    until = days.until if days is not None and shape == "drift" else None
    return Claim(
        one.effects, feature.joint, feature.name, shape,
        days.since if days else None, days.interval if days else None,
        until if until is None or until < float(unit.dates[-1]) else None,
        size, stderr, feature.unit, share, p, q,
    )  # fmt: skip
