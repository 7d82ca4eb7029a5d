"""Which units of a fleet get a name: chance as permutations of dates show it, over the whole fleet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import log
from typing import Final

import numpy as np
from scipy.stats import false_discovery_control, t

from robodyn.arrays import Floats
from robodyn.fleet.limits import ALWAYS, CALM, CHANGES, SIBLINGS
from robodyn.fleet.pool.features import Kind
from robodyn.fleet.pool.scan import Course, calendar_of, course_of
from robodyn.fleet.pool.type_model import TypeModel

#: Kinds of features that are no harm where they fall, and those in which a unit may always have been another.
_HARM_BY_GROWTH: Final = ("play", "unexplained")
LASTING: Final = ("friction", "body")
#: Readings of a unit by which it is compared with its siblings, at least: the least whose median one odd
#: reading does not move beyond the others.
_FEWEST: Final = 3
#: A type, a unit and a feature of it, by their places.
Key = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Name:
    """What stands out in a unit: its feature (``key``), how often chance does as much in a unit (``p``), and
    the share ``q`` of false names among the units that stand out no less; ``is_change``: from what it was, or
    from its siblings."""

    key: Key
    p: float
    q: float
    is_change: bool


def courses_of(models: Sequence[TypeModel]) -> dict[Key, Course]:
    """The courses of all features of all units that show enough."""
    courses = {}
    for k, model in enumerate(models):
        for u in range(len(model.units)):
            logs = model.logs_of(u)
            calendar = calendar_of(logs, model.dates[logs], model.group[logs], 1000 * k + u)
            for c, one in enumerate(model.features):
                course = course_of(calendar, model.population[c], rises=one.kind in _HARM_BY_GROWTH)
                if course is not None:
                    courses[k, u, c] = course
    return courses


def names_of(
    models: Sequence[TypeModel], courses: Mapping[Key, Course], false_names: float
) -> dict[tuple[int, int], Name]:
    """The names of units, by type and unit: of those that have a name the share ``false_names`` is false at
    most, in the mean. A unit that has changed is named by that, others by what was always so."""
    candidates = [*_changed(models, courses, false_names), *_always(models)]
    if not candidates:
        return {}
    # Two questions a unit, each with a part of the false names (Genovese, Roeder and Wasserman 2006).
    parts = [2 * (CHANGES if one.is_change else 1 - CHANGES) for one in candidates]
    shares = false_discovery_control(
        [min(one.p / part, 1.0) for one, part in zip(candidates, parts, strict=True)]
    )
    names: dict[tuple[int, int], Name] = {}
    for one, q in zip(candidates, shares.tolist(), strict=True):
        if q <= false_names:
            names.setdefault(one.key[:2], Name(one.key, one.p, q, one.is_change))
    return names


def _changed(models: Sequence[TypeModel], courses: Mapping[Key, Course], false_names: float) -> list[Name]:
    """How sure it is of each unit that any of its features has changed.

    Features of a kind are measured by what chance does to the middle one of them once in a hundred times.
    Chance is what other dates make of the unit itself, and of units whose own dates stand out so little that
    there is no change in them. Where no unit of the fleet has changed, dates as they are and others are as
    likely as each other to have the largest feature of all: where that is not rare, none is named.
    """
    kinds = {key: models[key[0]].features[key[2]].kind for key in courses}
    tails: dict[Kind, list[float]] = {}
    for key, course in courses.items():
        tails.setdefault(kinds[key], []).append(float(np.quantile(course.orbit, 0.99)))
    scale = {kind: max(float(np.median(several)), 1e-9) for kind, several in tails.items()}
    units: dict[tuple[int, int], dict[Key, Floats]] = {}
    for key, course in courses.items():
        units.setdefault(key[:2], {})[key] = course.orbit / scale[kinds[key]]
    if not units:
        return []
    largest = np.array([np.max(list(own.values()), axis=0) for own in units.values()])
    observed = largest[:, :1] - 1e-12
    calm = (largest >= observed).mean(axis=1) > CALM
    chance = np.sort(largest[calm].ravel())
    above = len(chance) - np.searchsorted(chance, observed[:, 0]) + ~calm * (largest >= observed).sum(axis=1)
    p = np.maximum(above, 1) / (len(chance) + ~calm * largest.shape[1])
    of_fleet = largest.max(axis=0)
    if (of_fleet >= of_fleet[0]).sum() > max(1.0, CHANGES * false_names * len(of_fleet)):
        p = np.ones_like(p)
    return [
        Name(_likeliest({key: float(orbit[0]) for key, orbit in own.items()}, kinds), one, 1.0, True)
        for own, one in zip(units.values(), p.tolist(), strict=True)
    ]


def _likeliest(sizes: Mapping[Key, float], kinds: Mapping[Key, Kind]) -> Key:
    """The feature that has changed: the one that is rarest by chance. A joint with play shakes others, and
    leaves what nothing explains at them: where it is rare by itself that more is left after the load of a
    joint has changed sign, it is play, at the joint where that is rarest."""
    best = max(sizes, key=lambda key: sizes[key])
    plays = {key: size for key, size in sizes.items() if kinds[key] == "play" and size >= 1}
    if kinds[best] in _HARM_BY_GROWTH and plays:
        return max(plays, key=lambda key: plays[key])
    return best


def _always(models: Sequence[TypeModel]) -> list[Name]:
    """How sure it is of each unit that it differs from its siblings: in the load that it carries, or in
    friction by a large factor."""
    names = []
    for k, model in enumerate(models):
        features = [c for c, one in enumerate(model.features) if one.kind in LASTING]
        for u in range(len(model.units)) if len(model.units) >= SIBLINGS else ():
            chances = [(_chance(model, u, c), c) for c in features]
            chance, c = min(chances)
            names.append(Name((k, u, c), min(chance * len(features), 1.0), 1.0, False))
    return names


def _chance(model: TypeModel, unit: int, c: int) -> float:
    """How often a sibling is as far from the others in a feature, by a median and its deviation, which count
    0.37 of as many units as a mean would (Hampel and others 1986, ch. 2)."""
    population = model.population[c]
    off, spread = population.off(unit), population.between_units
    readings = np.isfinite(population.value[model.logs_of(unit)]).sum()
    is_far = model.features[c].kind == "body" or abs(off) > log(ALWAYS)
    if readings < _FEWEST or not spread > 0 or not is_far:
        return 1.0
    return 2 * float(t.sf(abs(off) / spread, 0.37 * (len(model.units) - 1)))
