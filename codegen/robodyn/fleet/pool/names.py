"""Which units of a fleet get a name: chance as permutations of dates show it, over the whole fleet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import false_discovery_control

from robodyn.arrays import Floats
from robodyn.fleet.limits import CALM
from robodyn.fleet.pool.features import Kind
from robodyn.fleet.pool.population import freedom_of
from robodyn.fleet.pool.scan import Course, course_of, keys_of
from robodyn.fleet.pool.type_model import TypeModel

#: Kinds of features that are no harm where they fall.
_HARM_BY_GROWTH: tuple[Kind, ...] = ("play", "unexplained")
#: A type, a unit and a feature of it, by their places.
Key = tuple[int, int, int]


@dataclass(frozen=True, slots=True, eq=False)
class Sureness:
    """Of a unit its ``best`` feature, the share ``p`` of chance in which any is as odd, and the share ``q``
    of false names among the units that are no less sure."""

    best: Key
    p: float
    q: float


def courses_of(models: Sequence[TypeModel]) -> dict[Key, Course]:
    """The courses of all features of all units that show enough."""
    courses = {}
    for t, model in enumerate(models):
        freedom: dict[Kind, list[tuple[float, int]]] = {}
        for one, population in zip(model.features, model.population, strict=True):
            freedom.setdefault(one.kind, []).extend(population.ratios)
        degrees = {kind: freedom_of(ratios) for kind, ratios in freedom.items()}
        for u in range(len(model.units)):
            logs = model.logs_of(u)
            for c, one in enumerate(model.features):
                course = course_of(
                    logs,
                    model.dates[logs],
                    model.group[logs],
                    model.population[c],
                    degrees[one.kind],
                    rises=one.kind in _HARM_BY_GROWTH,
                )
                if course is not None:
                    courses[t, u, c] = course
    return courses


def permuted_of(models: Sequence[TypeModel], courses: Mapping[Key, Course]) -> dict[Key, Floats]:
    """The statistics [P] of each course with its dates permuted: they do not depend on how the dates are."""
    result, keys = {}, dict[tuple[int, int], Floats]()
    for (t, u, c), course in courses.items():
        logs = models[t].logs_of(u)
        if (t, u) not in keys:
            keys[t, u] = keys_of(len(logs), 1000 * t + u)
        result[t, u, c] = course.permuted(keys[t, u][:, np.searchsorted(logs, course.logs)])
    return result


def sureness_of(
    models: Sequence[TypeModel], courses: Mapping[Key, Course], permuted: Mapping[Key, Floats]
) -> dict[tuple[int, int], Sureness]:
    """How sure it is of each unit that any of its features has changed.

    Chance is what permutations come to of the unit itself, and of those units and features whose own dates
    stand out so little among their permutations that there is no change in them.
    """
    kinds = {key: models[key[0]].features[key[2]].kind for key in courses}
    pools: dict[Kind, list[Floats]] = {}
    for key, values in permuted.items():
        rank = (1 + float((values >= courses[key].observed - 1e-12).sum())) / (1 + len(values))
        if rank > CALM:
            pools.setdefault(kinds[key], []).append(values)
    far = {
        kind: max(float(np.quantile(np.concatenate(several), 0.99)), 1e-9) for kind, several in pools.items()
    }
    ratios: dict[tuple[int, int], dict[Key, float]] = {}
    orbits: dict[tuple[int, int], Floats] = {}
    for key, course in courses.items():
        unit, scale = key[:2], far.get(kinds[key], np.inf)
        ratios.setdefault(unit, {})[key] = course.observed / scale
        own = permuted[key] / scale
        orbits[unit] = np.maximum(orbits[unit], own) if unit in orbits else own
    largest = {unit: max(own.values()) for unit, own in ratios.items()}
    calm = {unit for unit, own in orbits.items() if float((own >= largest[unit] - 1e-12).mean()) > CALM}
    reference = np.sort(np.concatenate([*(orbits[unit] for unit in calm), np.zeros(0)]))
    p = []
    for unit, own in orbits.items():
        above = len(reference) - int(np.searchsorted(reference, largest[unit] - 1e-12)), len(reference)
        if unit not in calm:
            above = above[0] + int((own >= largest[unit] - 1e-12).sum()), above[1] + len(own)
        p.append((1 + above[0]) / (1 + above[1]))
    q = false_discovery_control(np.array(p)) if p else np.zeros(0)
    return {
        unit: Sureness(_likeliest(ratios[unit], kinds), one, float(other))
        for unit, one, other in zip(orbits, p, q, strict=True)
    }


def _likeliest(ratios: Mapping[Key, float], kinds: Mapping[Key, Kind]) -> Key:
    """The feature that has changed: the one that is rarest by chance. A joint with play shakes others, and
    leaves what nothing explains at them: where it is rare by itself that more is left after the load of a
    joint has changed sign, it is play, at the joint where that is rarest."""
    best = max(ratios, key=lambda key: ratios[key])
    plays = {key: ratio for key, ratio in ratios.items() if kinds[key] == "play" and ratio >= 1}
    if kinds[best] in ("unexplained", "play") and plays:
        return max(plays, key=lambda key: plays[key])
    return best
