"""What units of a type have in common: means, scatters from unit to unit and from log to log, and what
conditions do.

Each number by itself, with robust scatters (medians), as a few units are odd: they are what is looked for.
Partial pooling (Gelman and Hill 2007, ch. 12): what a log or a unit says counts by how sure it is beside how
much logs and units scatter.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.limits import (
    COLLINEAR,
    LEAST_APART,
    LEAST_SPREAD,
    MEDIAN,
    OUTLIER,
    ROUNDS,
    SLOPE_LOGS,
    SLOPE_T,
    VARIES,
)

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Series:
    """Readings [K] of one number with their ``variance`` [K], by unit (``unit`` [K], from 0) and with
    conditions (``conditions`` [K, c], 0 where they are as usual)."""

    value: Floats
    variance: Floats
    unit: NDArray[np.intp]
    conditions: Floats

    @property
    def units(self) -> int:
        """How many there are."""
        return int(self.unit.max()) + 1


@dataclass(frozen=True, slots=True, eq=False)
class Common:
    """Of a number: the ``mean`` of units, standard deviations ``between_units`` and ``between_logs``, and
    ``slopes`` [c] over conditions: of the number's logarithm where it is ``relative``, else of itself."""

    mean: float
    between_units: float
    between_logs: float
    slopes: Floats
    relative: bool

    def factors(self, conditions: Floats) -> Floats:
        """What conditions [K, c] multiply the number by [K]."""
        shift = conditions @ self.slopes
        return np.exp(shift) if self.relative else np.ones(len(conditions))

    def shifts(self, conditions: Floats) -> Floats:
        """What they add to it [K]."""
        return np.zeros(len(conditions)) if self.relative else conditions @ self.slopes


def common_of(series: Series, *, relative: bool, usual: float) -> Common:
    """The population of a number, ``usual``: its usual size. It changes with conditions by a factor if it is
    ``relative``, else by a sum."""
    c = series.conditions.shape[1]
    common = Common(usual, LEAST_SPREAD * usual, LEAST_SPREAD * usual, np.zeros(c), relative)
    is_sought = np.ones(c, dtype=bool) if len(series.value) >= SLOPE_LOGS else np.zeros(c, dtype=bool)
    for k in range(ROUNDS):
        value = (series.value - common.shifts(series.conditions)) / common.factors(series.conditions)
        variance = series.variance / common.factors(series.conditions) ** 2
        means, left = _units(value, variance + common.between_logs**2, series.unit)
        log_scatter = _scatter(*_shrunk(left, variance + common.between_logs**2, series.unit), variance)
        of_means = _variances(variance + log_scatter**2, series.unit)
        mean = _median(means, 1 / (of_means + common.between_units**2))
        spread = _scatter(means - mean, np.ones_like(means), of_means)
        slopes, errors = _slopes(series, common, means, is_sought)
        if k == ROUNDS // 2:
            is_sought &= (np.abs(slopes) > SLOPE_T * errors) & (errors > 0)
        least = LEAST_SPREAD * max(abs(mean), usual)
        common = Common(
            mean, max(spread, least), max(log_scatter, least), np.where(is_sought, slopes, 0), relative
        )
    return common


def _units(value: Floats, variance: Floats, unit: NDArray[np.intp]) -> tuple[Floats, Floats]:
    """Means [units] with weights 1 / variance, and what they leave of each reading [K]."""
    weight = 1 / variance
    total = np.bincount(unit, weight)
    means = np.bincount(unit, weight * value) / np.maximum(total, 1e-300)
    return means, value - means[unit]


def _variances(variance: Floats, unit: NDArray[np.intp]) -> Floats:
    """Of the means of units [units]."""
    return np.asarray(1 / np.maximum(np.bincount(unit, 1 / variance), 1e-300))


def _shrunk(left: Floats, variance: Floats, unit: NDArray[np.intp]) -> tuple[Floats, Floats]:
    """What is left of readings, and the share [K] of their variance that their unit's mean left them."""
    share = 1 - (1 / variance) / np.maximum(np.bincount(unit, 1 / variance), 1e-300)[unit]
    return left, np.maximum(share, 0.0)


def _scatter(left: Floats, share: Floats, variance: Floats) -> float:
    """The standard deviation beside ``variance`` with which half of what is ``left`` is as near as half of
    normal numbers are; 0 where it is nearer without."""
    use = share > 0.2
    if not use.any():
        return 0.0
    left, share, variance = np.abs(left[use]), share[use], variance[use]

    def median(scatter: float) -> float:
        return float(np.median(left / np.sqrt(share * (variance + scatter**2) + 1e-300)))

    low, high = 0.0, 10 * float(left.max()) + 1e-300
    if median(low) <= MEDIAN:
        return 0.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if median(middle) > MEDIAN else (low, middle)
    return high


def spread_of(values: Floats, scatters: Floats) -> Floats:
    """The covariance [k, k] of numbers of units, ``values`` [U, k] that scatter by ``scatters`` [k]: with
    robust correlations (Gnanadesikan and Kettenring 1972), as far as there are such."""
    far = (values - np.median(values, axis=0)) / np.maximum(scatters, 1e-300)
    count = far.shape[1]
    correlation = np.eye(count)
    for a in range(count):
        for b in range(a):
            along, across = (np.median(np.abs(far[:, a] + way * far[:, b])) ** 2 for way in (1, -1))
            if along + across > 0:
                correlation[a, b] = correlation[b, a] = (along - across) / (along + across)
    size, vectors = np.linalg.eigh(correlation)
    correlation = (vectors * np.maximum(size, LEAST_APART)) @ vectors.T
    return np.asarray(correlation * np.outer(scatters, scatters))


def _median(values: Floats, weights: Floats) -> float:
    """The weighted median."""
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, total[-1] / 2)])


def _slopes(
    series: Series, common: Common, means: Floats, is_sought: NDArray[np.bool_]
) -> tuple[Floats, Floats]:
    """Slopes [c] over the conditions and their standard errors, a step of Gauss and Newton from those of
    ``common``: within units, as the conditions of units differ and they do too."""
    c = len(common.slopes)
    slopes, errors = np.zeros(c), np.full(c, np.inf)
    if not is_sought.any():
        return slopes, errors
    factors, shifts = common.factors(series.conditions), common.shifts(series.conditions)
    by = means[series.unit] * factors if common.relative else np.ones_like(factors)
    left = series.value - means[series.unit] * factors - shifts
    size = np.sqrt(series.variance + (common.between_logs * factors) ** 2)
    weight = np.minimum(1.0, OUTLIER * size / np.maximum(np.abs(left), 1e-300)) / size**2
    columns = [factors * 1.0, *(by * x for x in series.conditions[:, is_sought].T)]
    total = np.bincount(series.unit, weight * columns[0] ** 2)

    def within(x: Floats) -> Floats:
        mean = np.bincount(series.unit, weight * columns[0] * x) / np.maximum(total, 1e-300)
        return np.asarray(x - mean[series.unit] * columns[0])

    A, b = np.stack([within(x) for x in columns[1:]]), within(left)
    whole = np.array([float(weight @ x**2) for x in columns[1:]])
    gram = (A * weight) @ A.T
    use = np.diag(gram) > VARIES * whole  # within units
    size_of = np.sqrt(np.diag(gram)[use])
    inverse = np.linalg.pinv(gram[np.ix_(use, use)] / np.outer(size_of, size_of), rcond=COLLINEAR)
    inverse /= np.outer(size_of, size_of)
    at = np.flatnonzero(is_sought)[use]
    slopes[at] = common.slopes[at] + inverse @ (A[use] @ (weight * b))
    errors[at] = np.sqrt(np.maximum(np.diag(inverse), 0))
    return slopes, errors


def standardised(
    several: Sequence[Mapping[str, float]],
) -> tuple[tuple[str, ...], Floats, Floats]:
    """Names of the conditions of logs, their means [c], and conditions less these [K, c]; 0 where a log has
    none of a name."""
    names = tuple(sorted({name for one in several for name in one}))
    values = np.array([[one.get(name, np.nan) for name in names] for one in several], dtype=np.float64)
    values = values.reshape(len(several), len(names))
    with np.errstate(all="ignore"):
        means = np.array([np.mean(x[np.isfinite(x)]) if np.isfinite(x).any() else 0.0 for x in values.T])
    return names, means, np.nan_to_num(values - means) if len(names) else values
