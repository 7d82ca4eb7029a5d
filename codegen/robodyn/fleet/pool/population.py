"""What units of a type have in common: what conditions do, and how much logs, programs and units scatter.

Each feature by itself and within a unit and program only, by medians, as a few units are odd: they are what
is looked for.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

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
    ``between_programs`` (of a unit; None: not known, any difference is believed); ``middle`` [U] of each
    unit, and of these median ``level`` and standard deviation ``between_units``."""

    value: Floats
    stderr: Floats
    slopes: Floats
    between_logs: float
    between_programs: float | None
    middle: Floats
    level: float
    between_units: float

    def off(self, unit: int) -> float:
        """How far a unit (from 0) is from the middle one."""
        return float(self.middle[unit] - self.level)


def population_of(
    value: Floats, stderr: Floats, unit: Indices, group: Indices, conditions: Floats
) -> Population:
    """The population of a feature with readings ``value`` [K] (nan: none) and ``stderr`` [K] in logs of units
    ``unit`` [K] (from 0); ``group`` [K]: which unit and program each log is of; ``conditions`` [K, c], 0
    where they are usual."""
    slopes = _slopes(value, group, conditions)
    value = value - conditions @ slopes
    known = np.isfinite(value)
    middle = np.full(int(unit.max()) + 1, np.nan)
    for u in np.unique(unit[known]):
        middle[u] = np.median(value[known & (unit == u)])
    level, between_units = np.nan, np.nan
    if known.any():
        level = float(np.nanmedian(middle))
        between_units = _MAD * float(np.nanmedian(np.abs(middle - level)))
    sets = [own for g in np.unique(group) if len(own := value[known & (group == g)]) > 2]
    if not sets:
        return Population(value, stderr, slopes, np.nan, None, middle, level, between_units)
    off = np.concatenate([(own - np.median(own)) * np.sqrt(len(own) / (len(own) - 1)) for own in sets])
    total = float(np.median(off**2)) / _MEDIAN_SQUARE
    noise = float(np.nanmedian(stderr)) ** 2
    between_logs = max(total - noise, 0.1 * total, 1e-18)
    programs = _between_programs(value, unit, group, between_logs + noise)
    return Population(value, stderr, slopes, between_logs, programs, middle, level, between_units)


def known_median(values: Floats) -> Floats:
    """The median [n] of what is known of columns [K, n]; nan where nothing is."""
    some = np.isfinite(values).any(axis=0)
    medians = np.full(values.shape[1], np.nan)
    medians[some] = np.nanmedian(values[:, some], axis=0)
    return medians


def _slopes(value: Floats, group: Indices, conditions: Floats) -> Floats:
    """What a feature changes by with each condition [c], within groups and without the readings that are far
    off; 0 where that is not sure."""
    known, x, y = np.isfinite(value), np.zeros_like(conditions), np.zeros(len(value))
    for g in np.unique(group[known]):
        own = known & (group == g)
        x[own], y[own] = conditions[own] - conditions[own].mean(axis=0), value[own] - np.median(value[own])
    slopes = np.zeros(conditions.shape[1])
    used, keep = np.flatnonzero(np.abs(x).max(axis=0, initial=0) > 1e-9), known
    if not len(used) or known.sum() < 10 + 5 * len(used):
        return slopes
    left: Floats = y
    fitted: Floats = np.zeros(len(used))
    for _ in range(5):
        fitted = np.asarray(np.linalg.lstsq(x[keep][:, used], y[keep], rcond=1e-6)[0])
        left = y - x[:, used] @ fitted
        size = _MAD * float(np.median(np.abs(left[known])))
        keep = known & (np.abs(left) <= TRIMMED * max(size, 1e-12))
    gram = np.linalg.pinv(x[keep][:, used].T @ x[keep][:, used])
    error = np.sqrt(np.maximum(np.diag(gram), 0) * float(np.mean(left[keep] ** 2)))
    slopes[used] = np.where(np.abs(fitted) > SURE_SLOPE * error, fitted, 0.0)
    return slopes


def _between_programs(value: Floats, unit: Indices, group: Indices, between_logs: float) -> float | None:
    """The variance between programs of a unit."""
    squares, noise = [], []
    for u in np.unique(unit):
        own = (unit == u) & np.isfinite(value)
        groups = [value[own & (group == g)] for g in np.unique(group[own])]
        for a, b in pairwise([one for one in groups if len(one) >= 2]):
            squares.append((np.median(a) - np.median(b)) ** 2 / 2)
            noise.append(between_logs * (1 / len(a) + 1 / len(b)) / 2)
    if len(squares) < _FEWEST:
        return None
    return max(float(np.median(squares)) / _MEDIAN_SQUARE - float(np.median(noise)), 0.0)
