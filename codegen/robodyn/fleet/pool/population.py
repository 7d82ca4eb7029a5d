"""What units of a type have in common: what conditions do, and how much logs, programs and units scatter.

Each feature by itself and within a unit and program only, by medians, as a few units are odd: they are what
is looked for.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy import optimize, special

from robodyn.arrays import Floats, Indices
from robodyn.fleet.limits import SURE_SLOPE, TRIMMED

#: The median of the square of a normal number, and one over that of its size.
_MEDIAN_SQUARE, _MAD = 0.455, 1.4826
#: Sets of logs from which a scatter is learned, at least.
_FEWEST = 5


@dataclass(frozen=True, slots=True, eq=False)
class Population:
    """Of a feature: its ``value`` [K] as it would be in usual conditions, with standard errors ``stderr``
    [K]; ``slopes`` [c] of the conditions; variances ``between_logs`` (of a unit and program) and
    ``between_programs`` (of a unit; None: not known, any difference is believed); ``level`` and
    ``between_units``: median of units and standard deviation; ``ratios``: of each set of logs the logarithm
    of its variance beside the usual one, and its degrees of freedom."""

    value: Floats
    stderr: Floats
    slopes: Floats
    between_logs: float
    between_programs: float | None
    level: float
    between_units: float
    ratios: tuple[tuple[float, int], ...]


def population_of(
    value: Floats, stderr: Floats, unit: Indices, group: Indices, conditions: Floats
) -> Population:
    """The population of a feature with readings ``value`` [K] (nan: none) and ``stderr`` [K]; ``group`` [K]:
    which unit and program each log is of; ``conditions`` [K, c], 0 where they are usual."""
    slopes = _slopes(value, group, conditions)
    value = value - conditions @ slopes
    sets = [
        own for g in np.unique(group) if len(own := np.flatnonzero((group == g) & np.isfinite(value))) > 2
    ]
    by_unit = (_known(value, unit == u) for u in np.unique(unit))
    means = np.array([np.median(readings) for readings in by_unit if len(readings)])
    level = float(np.median(means)) if len(means) else np.nan
    between_units = _MAD * float(np.median(np.abs(means - level))) if len(means) else np.nan
    if not sets:
        return Population(value, stderr, slopes, np.nan, None, level, between_units, ())
    off = np.concatenate(
        [np.asarray(value[own] - np.median(value[own])) * np.sqrt(len(own) / (len(own) - 1)) for own in sets]
    )
    total = float(np.median(off**2)) / _MEDIAN_SQUARE
    between_logs = max(total - float(np.nanmedian(stderr)) ** 2, 0.1 * total, 1e-18)
    ratios = []
    for own in sets:
        weight = between_logs / (between_logs + stderr[own] ** 2)
        beside = value[own] - np.average(value[own], weights=weight)
        ratio = float((weight * beside**2).sum()) / (len(own) - 1) / between_logs
        ratios.append((float(np.log(ratio + 1e-12)), len(own) - 1))
    programs = _between_programs(value, unit, group, between_logs + float(np.nanmedian(stderr)) ** 2)
    return Population(value, stderr, slopes, between_logs, programs, level, between_units, tuple(ratios))


def known_median(values: Floats) -> Floats:
    """The median [n] of what is known of columns [K, n]; nan where nothing is."""
    some = np.isfinite(values).any(axis=0)
    medians = np.full(values.shape[1], np.nan)
    medians[some] = np.nanmedian(values[:, some], axis=0)
    return medians


def _known(value: Floats, which: NDArray[np.bool_]) -> Floats:
    return value[which & np.isfinite(value)]


def _slopes(value: Floats, group: Indices, conditions: Floats) -> Floats:
    """What a feature changes by with each condition [c], within groups and without the readings that are far
    off; 0 where that is not sure."""
    known, x, y = np.isfinite(value), np.zeros_like(conditions), np.zeros(len(value))
    for g in np.unique(group[known]):
        own = known & (group == g)
        x[own], y[own] = conditions[own] - conditions[own].mean(axis=0), value[own] - np.median(value[own])
    slopes, used = np.zeros(conditions.shape[1]), np.abs(x).max(axis=0, initial=0) > 1e-9
    left = y
    for _ in range(2):  # the second time with those that are sure
        keep, least = known, 10 + 5 * int(used.sum())
        for _ in range(5):
            if keep.sum() < least or not used.any():
                return np.zeros(conditions.shape[1])
            slopes = np.zeros(conditions.shape[1])
            slopes[used] = np.linalg.lstsq(x[keep][:, used], y[keep], rcond=1e-6)[0]
            left = y - x @ slopes
            size = _MAD * float(np.median(np.abs(left[known])))
            keep = known & (np.abs(left) <= TRIMMED * max(size, 1e-12))
        gram = x[keep][:, used].T @ x[keep][:, used]
        error = np.sqrt(np.maximum(np.diag(np.linalg.pinv(gram)), 0) * float(np.mean(left[keep] ** 2)))
        used[used] = np.abs(slopes[used]) > SURE_SLOPE * error
        slopes = np.where(used, slopes, 0.0)
    return slopes


def _between_programs(value: Floats, unit: Indices, group: Indices, between_logs: float) -> float | None:
    """The variance between programs of a unit."""
    squares, noise = [], []
    for u in np.unique(unit):
        groups = [_known(value, (unit == u) & (group == g)) for g in np.unique(group[unit == u])]
        for a, b in pairwise([one for one in groups if len(one) >= 2]):
            squares.append((np.median(a) - np.median(b)) ** 2 / 2)
            noise.append(between_logs * (1 / len(a) + 1 / len(b)) / 2)
    if len(squares) < _FEWEST:
        return None
    return max(float(np.median(squares)) / _MEDIAN_SQUARE - float(np.median(noise)), 0.0)


def freedom_of(ratios: Sequence[tuple[float, int]]) -> float:
    """How many degrees of freedom the usual variance counts beside a unit's own (Smyth 2004), by how much
    variances of sets of logs scatter."""
    if len(ratios) < 2 * _FEWEST:
        return 3.0
    logarithm, freedom = np.array(ratios).T
    scatter = (_MAD * float(np.median(np.abs(logarithm - np.median(logarithm))))) ** 2
    beyond = max(scatter - float(np.mean(special.polygamma(1, freedom / 2))), 0.05)
    root = optimize.brentq(lambda x: float(special.polygamma(1, x)) - beyond, 0.05, 1e3)
    return float(np.clip(2 * root, 1, 40))
