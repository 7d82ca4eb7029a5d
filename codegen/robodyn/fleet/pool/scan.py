"""Shapes of change compete in the logs of a unit, and permutations of dates say what chance does.

A feature of a unit is a level, programs that scatter about it, a change with the dates, and noise. Changes
are steps and ramps from one date to another, and beside them stands that one log alone is odd: the statistic
is by how much more squares the best change takes away than the best odd log does, over a variance that is
moderated over the fleet (Smyth 2004). Under no change all orders of dates of one program of a unit are as
likely as each other.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Indices
from robodyn.fleet.limits import DATES, LEAST_LOGS, ONE_LOG, PERMUTATIONS
from robodyn.fleet.pool.population import Population

#: Entries of arrays that are worked on together.
_TOGETHER = 4_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Shapes:
    """Changes [S, K] in logs of ``days`` [K] (s): how much of each is there, from 0 to 1; ``start`` and
    ``end`` [S] (s), the same of a step."""

    share: Floats
    start: Floats
    end: Floats

    @property
    def steps(self) -> NDArray[np.bool_]:
        """Which of them are steps [S]."""
        return np.asarray(self.start == self.end)


def shapes_of(days: Floats) -> Shapes:
    """All steps between two logs, and ramps between dates of a grid."""
    every = np.unique(days)
    middle = (every[1:] + every[:-1]) / 2
    if len(middle) > 4 * DATES:
        middle = middle[:: len(middle) // (4 * DATES)]
    grid = np.linspace(every[0], every[-1], DATES + 1)
    pairs = [(a, b) for i, a in enumerate(grid[:-1]) for b in grid[i + 1 :]] if len(every) > 1 else []
    start, end = np.array([*((m, m) for m in middle), *pairs]).reshape(-1, 2).T
    width = np.maximum(end - start, 1e-9)
    share = np.clip((days - start[:, None]) / width[:, None], 0.0, 1.0)
    return Shapes(share, start, end)


class Course:
    """A feature in the logs of a unit: ``logs`` [K] (places among those of the type) that show it, ``days``
    [K] (s), ``groups`` [K] of logs that are compared, and the ``population`` that it is of; ``freedom`` of
    that one's variance. Of what only harms where it grows, no fall is a change (``rises``)."""

    def __init__(
        self,
        logs: Indices,
        days: Floats,
        group: Indices,
        population: Population,
        freedom: float,
        *,
        rises: bool = False,
    ) -> None:
        self.logs, self.days, self.freedom, self._rises = logs, days, freedom, rises
        names, inverse, count = np.unique(group, return_inverse=True, return_counts=True)
        alone = (count == 1)[inverse]
        self.groups = np.where(alone, len(names), inverse)
        self.value = population.value[logs]
        usual, known = population.between_logs, population.between_programs
        # Programs of this unit may differ by more than those of others: no change is seen between them then.
        means = [float(np.mean(self.value[inverse == g])) for g in range(len(names)) if count[g] > 1]
        own = float(np.var(means, ddof=1)) if len(means) > 1 else 0.0
        programs = 1e6 * usual if known is None else max(known, own)
        of_alone = 0.0 if known is None else programs
        same = (self.groups[:, None] == self.groups) & ~(alone[:, None] & (of_alone > 0))
        V = np.diag(usual + population.stderr[logs] ** 2 + of_alone * alone) + programs * same
        whiten = np.linalg.inv(np.linalg.cholesky(V))
        one = whiten.sum(axis=1)
        self._M = whiten - np.outer(one, one @ whiten) / float(one @ one)
        self._z = self._M @ self.value
        self._a = self._M.T @ self._z
        precision = np.maximum(np.einsum("ij,ij->j", self._M, self._M), 1e-12)
        self.odd = np.abs(self._a) / np.sqrt(precision)  # by how many errors each log is off
        self.own_freedom = max(len(logs) - len(np.unique(self.groups)) - 2, 0)

    @cached_property
    def shapes(self) -> Shapes:
        """The changes that compete."""
        return shapes_of(self.days)

    def gains(self, share: Floats) -> Floats:
        """Squares that changes [..., S, K] take away [..., S]: none where a change lies on one log."""
        Z = share @ self._M.T
        squares = Z**2
        whole = squares.sum(axis=-1)
        along = share @ self._a
        spread = (
            (whole > 1e-9) & (squares.max(axis=-1) <= ONE_LOG * whole) & ((along > 0) | (not self._rises))
        )
        return np.where(spread, along**2 / np.where(whole > 1e-9, whole, 1.0), 0.0)

    def statistic(self, top: Any) -> Any:
        """By how much more the best changes take away (``top`` [...]) than the oddest log does."""
        return np.maximum(top - float(self.odd.max()) ** 2, 0) / self.variance(top)

    def variance(self, top: Any) -> Any:
        """What the best changes leave, moderated, beside what is usual."""
        left = np.maximum(float(self._z @ self._z) - top, 0)
        return (self.freedom + left) / (self.freedom + self.own_freedom)

    @cached_property
    def observed(self) -> float:
        """The statistic of the dates as they are."""
        return float(self.statistic(np.max(self.gains(self.shapes.share), initial=0.0)))

    def permuted(self, keys: Floats) -> Floats:
        """The same [P] of dates that are permuted within groups, in the order of ``keys`` [P, K] from 0
        to 1."""
        rank = np.argsort(keys + 2 * self.groups, axis=1)
        order = np.empty_like(rank)
        order[:, np.argsort(self.groups, kind="stable")] = rank
        share = self.shapes.share
        step = max(1, _TOGETHER // max(share.size, 1))
        parts = [order[k : k + step] for k in range(0, len(order), step)]
        tops = [self.gains(np.moveaxis(share[:, part], 1, 0)).max(axis=-1, initial=0.0) for part in parts]
        return np.asarray(self.statistic(np.concatenate(tops)))

    def amount(self, share: Floats) -> tuple[float, float]:
        """How large a change [K] is, and its standard error."""
        Z = self._M @ share
        whole = float(Z @ Z)
        gain = np.array(float(Z @ self._z) ** 2 / whole)
        error = np.sqrt(float(self.variance(gain)) / whole)
        return float(Z @ self._z) / whole, float(error)

    def holds(self, share: Floats, size: float) -> bool:
        """Whether the change is there in the logs that it speaks of: the middle one of those after it differs
        from the middle one of those before it, each beside its program's, by half of it or more."""
        late = share >= 0.5
        middles = [np.median(self.value[part]) for part in (late, ~late) if part.any()]
        within = []
        for g in np.unique(self.groups):
            own = self.groups == g
            if (own & late).any() and (own & ~late).any():
                within.append(np.median(self.value[own & late]) - np.median(self.value[own & ~late]))
        if not within and len(middles) == 2:
            within = [middles[0] - middles[1]]
        return bool(within) and float(np.median(within)) * np.sign(size) >= 0.5 * abs(size) * _typical(
            share, late
        )


def _typical(share: Floats, late: NDArray[np.bool_]) -> float:
    """How much more of a change there is in the middle log after it than before."""
    return float(np.median(share[late]) - np.median(share[~late])) if late.any() and (~late).any() else 1.0


def course_of(
    logs: Indices, days: Floats, group: Indices, population: Population, freedom: float, *, rises: bool
) -> Course | None:
    """The :class:`Course` of a feature in the ``logs`` [K] of a unit with ``days`` [K] and ``group`` [K];
    None where too few show it to tell a change."""
    if not np.isfinite(population.between_logs):
        return None
    seen = np.isfinite(population.value[logs])
    names, inverse, count = np.unique(group[seen], return_inverse=True, return_counts=True)
    alone = (count == 1)[inverse]
    if alone.sum() == 1:  # nothing to compare it with
        seen[np.flatnonzero(seen)[alone]] = False
    groups = len(names) - int((count == 1).sum()) + int(alone.sum() > 1)
    if seen.sum() < LEAST_LOGS or seen.sum() - groups < LEAST_LOGS - 1:
        return None
    return Course(logs[seen], days[seen], group[seen], population, freedom, rises=rises)


def keys_of(logs: int, seed: int) -> Floats:
    """Random numbers [P, K] that order the dates of a unit's logs, the same for all its features."""
    return np.random.default_rng(seed).random((PERMUTATIONS, logs))
