"""The whole judgement of a fleet: types, units, names, what to look at first."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import (
    FALSE_NAMES,
    LEAST_ALWAYS,
    LEAST_BODY,
    LEAST_OF_ALL,
    LEAST_SHARE,
    LEFT_RISE,
    MOST_CLAIMS,
    OTHER_WAY,
    PLAY_RISE,
    SURE_BODY,
    SURE_SIZE,
)
from robodyn.fleet.pool.changes import change_at, changes, dated
from robodyn.fleet.pool.names import Chance, Odds, chance_of, false_shares, of_several
from robodyn.fleet.pool.summary import first_to_look_at, type_result, unit_result
from robodyn.fleet.pool.type_model import TypeModel, type_model
from robodyn.fleet.pool.unit import Suspicion, Unit
from robodyn.fleet.result import Claim, FleetResult, Shape, Unused
from robodyn.fleet.sources.fleet import Fleet

Floats = NDArray[np.float64]
#: What suspicions of one kind have in common: the feature's kind, whether it was always so, and the effects.
_Kind = tuple[str, bool, int]


@dataclass(frozen=True, slots=True, eq=False)
class _Judged:
    """A unit with what speaks for each of its features being odd, the likeliest of chance last."""

    unit: Unit
    suspicions: tuple[Suspicion, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Sure:
    """A suspicion, how often chance alone makes a unit as odd (``p``), and the share of false names among all
    that are no less sure (``q``)."""

    suspicion: Suspicion
    p: float
    q: float


def judge(
    fleet: Fleet,
    digests: Mapping[str, Digest],
    *,
    unused: Sequence[Unused] = (),
    false_names: float = FALSE_NAMES,
    progress: Callable[[str], object] | None = None,
) -> FleetResult:
    """What the ``digests`` of a fleet's logs (by source) say of its types and units. Logs without a digest do
    not count; ``unused`` says why. At most the share ``false_names`` of the units
    with a name is false, in the mean."""
    tell = progress or (lambda _: None)
    models, judged = list[TypeModel](), list[_Judged]()
    logs = [log for log in fleet.logs if log.source in digests]
    for name, own in groupby(logs, key=lambda log: log.type):
        tell(f"pooling logs of {name}")
        model = type_model(fleet.types[name], list(own), digests)
        models.append(model)
        for k in range(len(model.units)):
            unit = Unit(model, k)
            judged.append(_Judged(unit, (*unit.suspicions(), *unit.deviations())))
            unit.forget()
    tell("comparing units")
    chances = _chances(judged)
    claims = _claims(judged, chances, false_names)
    types = tuple(type_result(model) for model in models)
    units = tuple(
        unit_result(one.unit, tuple(own), _unusual(one, chances))
        for one, own in zip(judged, claims, strict=True)
    )
    return FleetResult(fleet.name, types, units, tuple(unused), first_to_look_at(types, units), false_names)


def _kind(one: Suspicion) -> _Kind:
    return one.feature.kind, one.always, one.numbers


def _odds(several: Sequence[Suspicion]) -> Odds:
    return Odds(
        np.array([one.worth for one in several]), several[0].numbers,
        np.array([one.tests for one in several]), np.array([one.freedom for one in several]),
    )  # fmt: skip


def _chances(judged: Sequence[_Judged]) -> dict[_Kind, Chance]:
    """By kind what chance does in this fleet."""
    kinds = dict[_Kind, list[Suspicion]]()
    for one in judged:
        for each in one.suspicions:
            kinds.setdefault(_kind(each), []).append(each)
    return {kind: chance_of(_odds(several)) for kind, several in kinds.items()}


def _p(one: Suspicion, chances: Mapping[_Kind, Chance]) -> float:
    """How often chance alone makes a feature look as odd."""
    return float(_odds([one]).tails(chances.get(_kind(one), Chance()))[0])


def _claims(
    judged: Sequence[_Judged], chances: Mapping[_Kind, Chance], false_names: float
) -> list[list[Claim]]:
    """Of each unit what is claimed: what is sure over the whole fleet, one after the other. A unit is one
    name, however many of its features are odd: what shakes a joint shows in all of them."""
    rarest = [
        _unit_p(one, min((_p(each, chances) for each in one.suspicions), default=1.0)) for one in judged
    ]
    shares = false_shares(rarest)
    share_at = sorted(zip(rarest, shares.tolist(), strict=True))

    def share_of(p: float) -> float:
        return min((share for other, share in share_at if other >= p), default=1.0)

    claims = []
    for one in judged:
        sureness = _Sureness(one, chances, share_of, false_names)
        claims.append(_of_unit(one.unit, one.suspicions, sureness))
        one.unit.forget()
    return claims


def _unit_p(one: _Judged, p: float) -> float:
    """How often chance alone makes the oddest feature of a unit as odd as ``p``."""
    features = {(each.feature.name, each.always) for each in one.suspicions}
    return float(of_several(np.array([p]), len(features))[0])


@dataclass(frozen=True, slots=True, eq=False)
class _Sureness:
    """How sure suspicions of a unit are beside all of its fleet."""

    judged: _Judged
    chances: Mapping[_Kind, Chance]
    share_of: Callable[[float], float]
    false_names: float

    def sure(self, suspicions: Sequence[Suspicion]) -> list[_Sure]:
        """Those that are sure, the surest first, play before all."""
        sure = list[_Sure]()
        for each in suspicions:
            p = _unit_p(self.judged, _p(each, self.chances))
            if (q := self.share_of(p)) <= self.false_names:
                sure.append(_Sure(each, p, q))
        return sorted(sure, key=lambda one: (_rank(one.suspicion), one.p, -one.suspicion.worth))


def _of_unit(unit: Unit, suspicions: Sequence[Suspicion], sureness: _Sureness) -> list[Claim]:
    """The surest first; what is left once a change is taken out is looked at again."""
    claims, history = list[Claim](), None
    while len(claims) < MOST_CLAIMS:
        best = next(_sure_claims(unit, sureness.sure(suspicions), suspicions), None)
        if best is None:
            break
        one, claim = best
        claims.append(claim)
        if one.direction is None or one.always:
            break
        history = (history or unit.history).without(one.share, one.direction @ one.change.amplitudes)
        again = unit.suspicions(history)
        suspicions = [
            each for each in again if each.direction is not None and each.feature.name != one.feature.name
        ]
    return claims


def _sure_claims(
    unit: Unit, ordered: Sequence[_Sure], suspicions: Sequence[Suspicion]
) -> Iterator[tuple[Suspicion, Claim]]:
    """Claims of suspicions that hold, in their order."""
    for sure in ordered:
        one = sure.suspicion
        if is_worth_a_name(unit, one) and unit.stands_alone(one):
            best = likeliest_way(largest_rise(one, suspicions), suspicions)
            claim = claim_of(unit, best, sure.p, sure.q)
            if holds(best, claim):
                yield best, claim


def _rank(one: Suspicion) -> int:
    """Play before all else: it disturbs the numbers of a log."""
    return 0 if one.direction is None and one.effects else 1


def _unusual(one: _Judged, chances: Mapping[_Kind, Chance]) -> dict[str, float]:
    """By feature how far it is from what is usual, in standard deviations that are as rare."""
    from scipy.stats import norm

    unusual = dict[str, float]()
    for each in one.suspicions:
        size = float(norm.isf(max(_p(each, chances), 1e-300) / 2))
        way = 1.0 if each.change.amplitudes[0] >= 0 else -1.0
        if size > abs(unusual.get(each.feature.name, 0.0)):
            unusual[each.feature.name] = way * size
    return unusual


# --- claims -----------------------------------------------------------------------------------------------


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
