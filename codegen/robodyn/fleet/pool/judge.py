"""The whole judgement of a fleet: types, units, names, what was not observed, what to look at first."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import groupby

import numpy as np
from scipy.stats import false_discovery_control, t

from robodyn.arrays import Floats
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import ALWAYS, FALSE_NAMES
from robodyn.fleet.pool.events import lost_dates, unit_events
from robodyn.fleet.pool.names import Key, Sureness, courses_of, permuted_of, sureness_of
from robodyn.fleet.pool.scan import Course
from robodyn.fleet.pool.summary import first_to_look_at, not_observed, type_result, unit_result
from robodyn.fleet.pool.type_model import TypeModel, type_model
from robodyn.fleet.result import Claim, FleetResult, OddLog, Unused
from robodyn.fleet.sources.fleet import Fleet

_Claims = dict[tuple[int, int], list[Claim]]


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
    logs = [log for log in fleet.logs if log.source in digests]
    lost, dateless = lost_dates(logs)
    logs = [log for log in logs if log.source not in {one.source for one in dateless}]
    models = []
    for name, own in groupby(logs, key=lambda log: log.type):
        tell(f"pooling logs of {name}")
        models.append(type_model(fleet.types[name], list(own), digests))
    tell("comparing units")
    courses = courses_of(models)
    sureness = sureness_of(models, courses, permuted_of(models, courses))
    claims = _claims(models, courses, sureness, false_names)
    for t_, model in enumerate(models):
        for u, unit in enumerate(model.units):
            claims.setdefault((t_, u), []).extend([*unit_events(model, u), *lost.get((model.name, unit), ())])
    types = tuple(map(type_result, models))
    odd = odd_logs(models, courses, claims)
    units = tuple(
        unit_result(model, u, tuple(claims[t_, u]), _unusual(model, (t_, u), courses))
        for t_, model in enumerate(models)
        for u in range(len(model.units))
    )
    return FleetResult(
        fleet.name, types, units, (*unused, *dateless), tuple(not_observed(models, courses)), odd,
        first_to_look_at(models, units), false_names,
    )  # fmt: skip


def _claims(
    models: Sequence[TypeModel],
    courses: Mapping[Key, Course],
    sureness: Mapping[tuple[int, int], Sureness],
    false_names: float,
) -> _Claims:
    """What is claimed of the arms of units, by type and unit: changes, and of units that have not changed
    what was always so."""
    claims: _Claims = {}
    for unit, sure in sureness.items():
        if sure.q <= false_names:
            claim = claim_of(models[sure.best[0]], sure, courses[sure.best])
            if claim is not None:
                claims[unit] = [claim]
    for unit, claim in _always(models, false_names):
        claims.setdefault(unit, [claim])
    return claims


def claim_of(model: TypeModel, sure: Sureness, course: Course) -> Claim | None:
    """The change of a unit's feature: of all shapes that the logs allow the simplest, and when; None where it
    does not hold in the logs that it speaks of."""
    feature, shapes = model.features[sure.best[2]], course.shapes
    gains = course.gains(shapes.share)
    best = int(np.argmax(gains))
    variance = float(course.variance(gains[best]))
    within = float(t.ppf(0.975, course.freedom + course.own_freedom)) ** 2 * variance
    allowed = gains >= gains[best] - within
    if (allowed & shapes.steps).any():  # of two shapes that both hold the simpler one
        allowed &= shapes.steps
        best = int(np.argmax(np.where(allowed, gains, -np.inf)))
    size, error = course.amount(shapes.share[best])
    if not course.holds(shapes.share[best], size):
        return None
    days, start = np.sort(course.days), shapes.start[allowed]
    low, high = (
        days[days <= start.min()].max(initial=days[0]),
        days[days >= start.max()].min(initial=days[-1]),
    )
    weight = np.exp(-0.5 * (gains[allowed].max() - gains[allowed]) / variance)
    since = float(weight @ start / weight.sum())
    is_step = bool(shapes.steps[best])
    end = float(shapes.end[best])
    until = None if is_step or end >= days[-1] else max(end, since)
    return Claim(
        feature.effects, feature.joint, feature.name, "step" if is_step else "drift", since,
        (float(low), float(high)), until,
        *_stated(model, sure.best[2], size, error, course.value[shapes.share[best] < 0.5]), sure.p, sure.q,
    )  # fmt: skip


def _stated(
    model: TypeModel, c: int, size: float, error: float, before: Floats
) -> tuple[float, float, str, float | None]:
    """Size, standard error, unit and share of a change by ``size`` of readings that were ``before``."""
    feature = model.features[c]
    if feature.kind == "friction":
        level = float(np.exp(np.median(before)))
        return level * math.expm1(size), level * math.exp(size) * error, feature.unit, math.expm1(size)
    if feature.kind in ("play", "unexplained"):
        return size, error, feature.unit, math.expm1(size)
    return size, error, feature.unit, size if feature.kind == "gain" else None


def _always(models: Sequence[TypeModel], false_names: float) -> Iterator[tuple[tuple[int, int], Claim]]:
    """Units that were always different: in the load that they carry, or in friction by a large factor."""
    found: list[tuple[tuple[int, int], int, float, float, float]] = []
    for t_, model in enumerate(models):
        for c, feature in enumerate(model.features):
            population = model.population[c]
            if (
                feature.kind not in ("friction", "body")
                or len(model.units) < 8
                or not population.between_units > 0
            ):
                continue
            for u in range(len(model.units)):
                own = population.value[model.logs_of(u)]
                own = own[np.isfinite(own)]
                if len(own) >= 3:
                    off = float(np.median(own)) - population.level
                    error = population.between_units
                    chance = 2 * float(t.sf(abs(off) / error, 0.37 * (len(model.units) - 1)))  # of a median
                    found.append(((t_, u), c, off, error, chance))
    if not found:
        return
    shares = false_discovery_control([min(one[-1], 1.0) for one in found])
    for (unit, c, off, error, chance), q in zip(found, shares.tolist(), strict=True):
        model, feature = models[unit[0]], models[unit[0]].features[c]
        if q <= false_names and (feature.kind == "body" or abs(off) > math.log(ALWAYS)):
            size = _stated(model, c, off, error, np.array([model.population[c].level]))
            yield unit, Claim(
                feature.effects, feature.joint, feature.name, "always", None, None, None, *size, chance, q
            )  # fmt: skip


def odd_logs(
    models: Sequence[TypeModel], courses: Mapping[Key, Course], claims: _Claims
) -> tuple[OddLog, ...]:
    """Single logs that are off from all others of their unit, of which nothing is claimed: a fault of one
    recording, and no name."""
    rows: list[tuple[float, Key, int]] = []
    for key, course in courses.items():
        if not claims.get(key[:2]):
            chance = 2 * t.sf(course.odd, course.freedom + course.own_freedom)
            rows += [(float(p), key, k) for k, p in enumerate(chance.tolist())]
    if not rows:
        return ()
    shares = false_discovery_control([row[0] for row in rows])
    odd = [row for row, q in zip(rows, shares.tolist(), strict=True) if q <= FALSE_NAMES]
    several = Counter(key for _, key, _ in odd)
    listed: dict[str, OddLog] = {}
    for _, (t_, u, c), k in sorted(row for row in odd if several[row[1]] == 1):  # the oddest first
        model = models[t_]
        log = model.logs[int(courses[t_, u, c].logs[k])]
        listed.setdefault(
            log.source, OddLog(model.name, model.units[u], log.source, log.date, model.features[c].name)
        )
    return tuple(sorted(listed.values(), key=lambda one: (one.type, one.unit, one.date)))


def _unusual(model: TypeModel, unit: tuple[int, int], courses: Mapping[Key, Course]) -> dict[str, float]:
    """By feature how far it is from what it was or from its siblings, in standard deviations."""
    unusual = {}
    for c, feature in enumerate(model.features):
        course, population = courses.get((*unit, c)), model.population[c]
        own = population.value[model.logs_of(unit[1])]
        own = own[np.isfinite(own)]
        beside = (
            (float(np.median(own)) - population.level) / population.between_units
            if (len(own) and population.between_units > 0)
            else 0.0
        )
        changed = 0.0
        if course is not None:
            gains = course.gains(course.shapes.share)
            size, _ = course.amount(course.shapes.share[int(np.argmax(gains))]) if gains.any() else (0.0, 0.0)
            changed = math.copysign(math.sqrt(course.observed), size)
        if len(own):
            unusual[feature.name] = max(
                beside if feature.kind in ("friction", "body") else 0.0, changed, key=abs
            )
    return unusual
