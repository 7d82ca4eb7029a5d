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
from robodyn.fleet.pool.names import false_shares, inflation, tail
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


def judge(
    fleet: Fleet,
    digests: Mapping[str, Digest],
    *,
    unused: Sequence[Unused] = (),
    false_names: float = FALSE_NAMES,
    progress: Callable[[str], object] | None = None,
) -> FleetResult:
    """What the ``digests`` of a fleet's logs (by source) say of its types and units. Logs without a digest do
    not count; ``unused`` says why. At most the share ``false_names`` of names is false, in the mean."""
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
    inflations = _inflations(judged)
    claims = _claims(judged, inflations, false_names)
    types = tuple(type_result(model) for model in models)
    units = tuple(
        unit_result(one.unit, tuple(own), _unusual(one, inflations))
        for one, own in zip(judged, claims, strict=True)
    )
    return FleetResult(fleet.name, types, units, tuple(unused), first_to_look_at(types, units), false_names)


def _kind(one: Suspicion) -> _Kind:
    return one.feature.kind, one.always, one.numbers


def _inflations(judged: Sequence[_Judged]) -> dict[_Kind, float]:
    """By kind how much larger log-likelihood ratios are in this fleet than they should be, by the units in
    the middle: most of a fleet is healthy."""
    worth = dict[_Kind, list[float]]()
    for one in judged:
        for each in one.suspicions:
            if each.always:
                worth.setdefault(_kind(each), []).append(each.worth)
    factors = {kind: inflation(np.array(values), kind[2]) for kind, values in worth.items()}
    p = dict[_Kind, list[float]]()
    for one in judged:
        for each in one.suspicions:
            if not each.always:
                p.setdefault(_kind(each), []).append(
                    tail(each.worth, each.numbers, each.tests, freedom=each.freedom)
                )
    for kind, values in p.items():
        # Half of all p-values are below 0.5: what the middle one lacks, ratios are too large by.
        factors[kind] = _inflation_of_maxima(judged, kind, values)
    return factors


def _inflation_of_maxima(judged: Sequence[_Judged], kind: _Kind, p: Sequence[float]) -> float:
    if np.median(p) >= 0.5:
        return 1.0
    several = [each for one in judged for each in one.suspicions if _kind(each) == kind]
    low, high = 1.0, 100.0
    for _ in range(30):
        middle = (low * high) ** 0.5
        centre = np.median(
            [
                tail(each.worth, each.numbers, each.tests, freedom=each.freedom, inflation=middle)
                for each in several
            ]
        )
        low, high = (middle, high) if centre < 0.5 else (low, middle)
    return high


def _p(one: Suspicion, inflations: Mapping[_Kind, float]) -> float:
    return tail(
        one.worth, one.numbers, one.tests, freedom=one.freedom, inflation=inflations.get(_kind(one), 1.0)
    )


def _claims(
    judged: Sequence[_Judged], inflations: Mapping[_Kind, float], false_names: float
) -> list[list[Claim]]:
    """Of each unit what is claimed: what is sure over the whole fleet, one after the other."""
    flat = [(k, each, _p(each, inflations)) for k, one in enumerate(judged) for each in one.suspicions]
    best = dict[tuple[int, str, bool], tuple[float, Suspicion]]()
    for k, each, p in flat:
        key = (k, each.feature.name, each.always)
        if key not in best or p < best[key][0]:
            best[key] = (p, each)
    keys = list(best)
    q = false_shares(np.array([best[key][0] for key in keys]))
    threshold = max(
        (best[key][0] for key, share in zip(keys, q, strict=True) if share <= false_names), default=-1.0
    )
    share_at = sorted((best[key][0], float(share)) for key, share in zip(keys, q, strict=True))

    def q_of(p: float) -> float:
        return min((share for other, share in share_at if other >= p), default=1.0)

    claims = []
    for one in judged:
        claims.append(_of_unit(one.unit, one.suspicions, inflations, threshold, q_of))
        one.unit.forget()
    return claims


def _of_unit(
    unit: Unit,
    suspicions: Sequence[Suspicion],
    inflations: Mapping[_Kind, float],
    threshold: float,
    q_of: Callable[[float], float],
) -> list[Claim]:
    """The surest first, play before all; what is left once a change is taken out is looked at again."""
    claims, history = list[Claim](), unit.history
    while len(claims) < MOST_CLAIMS:
        sure = [(p, each) for each in suspicions if (p := _p(each, inflations)) <= threshold]
        ordered = sorted(sure, key=lambda pair: (_rank(pair[1]), pair[0], -pair[1].worth))
        best = next(_sure_claims(unit, ordered, suspicions, q_of), None)
        if best is None:
            break
        one, claim = best
        claims.append(claim)
        if one.direction is None or one.always:
            break
        history = history.without(one.share, one.direction @ one.change.amplitudes)
        again = unit.suspicions(history)
        suspicions = [
            each for each in again if each.direction is not None and each.feature.name != one.feature.name
        ]
    return claims


def _sure_claims(
    unit: Unit,
    ordered: Sequence[tuple[float, Suspicion]],
    suspicions: Sequence[Suspicion],
    q_of: Callable[[float], float],
) -> Iterator[tuple[Suspicion, Claim]]:
    """Claims of suspicions that hold, in their order."""
    for p, one in ordered:
        if is_worth_a_name(unit, one) and unit.stands_alone(one):
            best = likeliest_way(largest_rise(one, suspicions), suspicions)
            claim = claim_of(unit, best, p, q_of(p))
            if holds(best, claim):
                yield best, claim


def _rank(one: Suspicion) -> int:
    """Play before all else: it disturbs the numbers of a log."""
    return 0 if one.direction is None and one.effects else 1


def _unusual(one: _Judged, inflations: Mapping[_Kind, float]) -> dict[str, float]:
    """By feature how far it is from what is usual, in standard deviations that are as rare."""
    from scipy.stats import norm

    unusual = dict[str, float]()
    for each in one.suspicions:
        size = float(norm.isf(max(_p(each, inflations), 1e-300) / 2))
        way = 1.0 if each.change.amplitudes[0] >= 0 else -1.0
        if size > abs(unusual.get(each.feature.name, 0.0)):
            unusual[each.feature.name] = way * size
    return unusual
