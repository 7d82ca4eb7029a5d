"""The whole judgement of a fleet: types, units, names, what to look at first."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.digest.digest import Digest
from robodyn.fleet.pool.claims import claim_of, holds, is_worth_a_name, largest_rise, likeliest_way
from robodyn.fleet.pool.limits import FALSE_NAMES, MOST_CLAIMS
from robodyn.fleet.pool.names import Chance, Odds, chance_of, false_shares, of_several
from robodyn.fleet.pool.summary import first_to_look_at, type_result, unit_result
from robodyn.fleet.pool.type_model import TypeModel, type_model
from robodyn.fleet.pool.unit import Suspicion, Unit
from robodyn.fleet.result import Claim, FleetResult, Unused
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
