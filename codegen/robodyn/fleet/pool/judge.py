"""The whole judgement of a fleet: types, units, names, what was not observed, what to look at first."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby

import numpy as np
from scipy.stats import false_discovery_control, t

from robodyn.arrays import Floats
from robodyn.fleet.digest import Digest
from robodyn.fleet.limits import FALSE_NAMES
from robodyn.fleet.pool.events import clock_event, lost_dates, program_changes
from robodyn.fleet.pool.names import LASTING, Key, Name, courses_of, names_of
from robodyn.fleet.pool.scan import Course
from robodyn.fleet.pool.summary import first_to_look_at, not_observed, type_result, unit_result
from robodyn.fleet.pool.type_model import TypeModel, type_model
from robodyn.fleet.result import Claim, FleetResult, OddLog, Unused
from robodyn.fleet.sources.fleet import Fleet


def judge(
    fleet: Fleet,
    digest: Callable[[str], Digest],
    *,
    unused: Sequence[Unused] = (),
    false_names: float = FALSE_NAMES,
    progress: Callable[[str], object] | None = None,
) -> FleetResult:
    """What the digests of a fleet's logs (``digest`` of a log's source, asked for several times) say of its
    types and units; ``unused``: logs that are none of these, and why. At most the share ``false_names`` of
    the units with a name is false, in the mean."""
    tell = progress or (lambda _: None)
    lost, dateless = lost_dates(fleet.logs)
    without = {one.source for one in dateless}
    logs = [log for log in fleet.logs if log.source not in without]
    models = []
    for name, own in groupby(logs, key=lambda log: log.type):
        tell(f"pooling logs of {name}")
        models.append(type_model(fleet.types[name], list(own), digest))
    tell("comparing units")
    courses = courses_of(models)
    names = names_of(models, courses, false_names)
    events = program_changes(models, len(names), false_names)
    units, unnamed = [], set[tuple[int, int]]()
    for k, model in enumerate(models):
        for u, unit in enumerate(model.units):
            name = names.get((k, u))
            change = claim_of(model, name, courses) if name else None
            others = (events.get((k, u)), clock_event(model, u), *lost.get((model.name, unit), ()))
            claims = [one for one in (change, *others) if one is not None]
            if not claims:
                unnamed.add((k, u))
            units.append(unit_result(model, u, tuple(claims), _unusual(model, (k, u), courses)))
    return FleetResult(
        fleet.name, tuple(map(type_result, models)), tuple(units), (*unused, *dateless),
        tuple(not_observed(models, courses)), odd_logs(models, courses, unnamed),
        first_to_look_at(models, units), false_names,
    )  # fmt: skip


def claim_of(model: TypeModel, name: Name, courses: Mapping[Key, Course]) -> Claim | None:
    """What is claimed of a unit with a name; None where it does not hold in the logs that it speaks of."""
    if name.is_change:
        return _change(model, name, courses[name.key])
    _, u, c = name.key
    population, feature = model.population[c], model.features[c]
    size = _stated(model, c, population.off(u), population.between_units, np.array([population.level]))
    return Claim(
        feature.effects, feature.joint, feature.name, "always", None, None, None, *size, name.p, name.q
    )


def _change(model: TypeModel, name: Name, course: Course) -> Claim | None:
    """Of all shapes of a change that the logs allow the simplest, and when."""
    feature, calendar = model.features[name.key[2]], course.calendar
    gains = course.gains(course.share)
    best = int(np.argmax(gains))
    variance = float(course.variance(gains[best]))
    allowed = gains >= gains[best] - float(t.ppf(0.975, course.freedom)) ** 2 * variance
    is_step = calendar.start == calendar.end
    if (allowed & is_step).any():  # of two shapes that both hold the simpler one
        allowed &= is_step
        best = int(np.argmax(np.where(allowed, gains, -np.inf)))
    share = course.share[best]
    size, error = course.amount(share)
    if not course.holds(share, size):
        return None
    days, start = np.sort(calendar.days[np.isin(calendar.logs, course.logs)]), calendar.start[allowed]
    low = days[days <= start.min()].max(initial=days[0])
    high = days[days >= start.max()].min(initial=days[-1])
    weight = np.exp(-0.5 * (gains[allowed].max() - gains[allowed]) / variance)
    since = float(weight @ start / weight.sum())
    end = float(calendar.end[best])
    until = None if is_step[best] or end >= days[-1] else max(end, since)
    return Claim(
        feature.effects, feature.joint, feature.name, "step" if is_step[best] else "drift", since,
        (float(low), float(high)), until,
        *_stated(model, name.key[2], size, error, course.value[share < 0.5]), name.p, name.q,
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


def odd_logs(
    models: Sequence[TypeModel], courses: Mapping[Key, Course], unnamed: set[tuple[int, int]]
) -> tuple[OddLog, ...]:
    """Single logs that are off from all others of their unit, of which nothing is claimed: a fault of one
    recording, and no name."""
    rows = [
        (float(p), key, int(place))
        for key, course in courses.items()
        if key[:2] in unnamed
        for p, place in zip(2 * t.sf(course.odd, course.freedom), course.logs, strict=True)
    ]
    if not rows:
        return ()
    shares = false_discovery_control([p for p, *_ in rows])
    odd = [row for row, q in zip(rows, shares.tolist(), strict=True) if q <= FALSE_NAMES]
    several = Counter(key for _, key, _ in odd)
    listed: dict[str, OddLog] = {}
    for _, (k, u, c), place in sorted(row for row in odd if several[row[1]] == 1):  # the oddest first
        model = models[k]
        log, name = model.logs[place], model.features[c].name
        listed.setdefault(log.source, OddLog(model.name, model.units[u], log.source, log.date, name))
    return tuple(sorted(listed.values(), key=lambda one: (one.type, one.unit, one.date)))


def _unusual(model: TypeModel, unit: tuple[int, int], courses: Mapping[Key, Course]) -> dict[str, float]:
    """By feature how far it is from what it was or from its siblings, in standard deviations."""
    unusual = {}
    for c, feature in enumerate(model.features):
        course, population = courses.get((*unit, c)), model.population[c]
        beside = changed = 0.0
        if feature.kind in LASTING and population.between_units > 0:
            beside = population.off(unit[1]) / population.between_units
        if course is not None and course.orbit[0] > 0:
            size, _ = course.amount(course.share[int(np.argmax(course.gains(course.share)))])
            changed = math.copysign(math.sqrt(course.orbit[0]), size)
        if np.isfinite(population.off(unit[1])):
            unusual[feature.name] = max(beside, changed, key=abs)
    return unusual
