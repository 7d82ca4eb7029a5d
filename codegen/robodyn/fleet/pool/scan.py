"""Shapes of change compete in the logs of a unit, and permutations of dates say what chance does.

A feature of a unit is a level, programs that scatter about it, a change with the dates, and noise. Changes
are steps and ramps from one date to another, and beside them stands that one log alone is odd: the statistic
is by how much more squares the best change takes away than the best odd log does, over a variance of which
the fleet and the unit say a part each.

Under no change all orders of dates within a program of a unit are as likely as each other, and nothing but
the statistic itself depends on the dates: it is worked out for the dates as they are and for others in the
same way, so that each of them is as likely to be the largest.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats, Indices
from robodyn.fleet.limits import DATES, FREEDOM, LEAST_LOGS, ONE_LOG, PERMUTATIONS
from robodyn.fleet.pool.population import Population

#: Entries of arrays that are worked on together: 32 MB of doubles, a choice; results are the same with any.
_TOGETHER: Final = 4_000_000


@dataclass(frozen=True, slots=True, eq=False)
class Calendar:
    """The logs of a unit that have others of their program: their places ``logs`` [K] among those of the
    type, ``days`` [K] (s) and ``group`` [K] (unit and program). Changes that compete: how much of each is
    there on each day (``share`` [S, K], from 0 to 1), from its ``start`` to its ``end`` [S] (s; the same of a
    step). ``orders`` [1 + P, K]: the log whose day each log has, first its own, then permuted."""

    logs: Indices
    days: Floats
    group: Indices
    share: Floats
    start: Floats
    end: Floats
    orders: Indices


def calendar_of(logs: Indices, days: Floats, group: Indices, seed: int) -> Calendar:
    """The calendar of a unit: steps between two of its logs, and ramps between dates of a grid."""
    _, place, count = np.unique(group, return_inverse=True, return_counts=True)
    several = count[place] > 1
    logs, days, group, place = logs[several], days[several], group[several], place[several]
    every = np.unique(days)
    middle = (every[1:] + every[:-1]) / 2
    middle = middle[:: max(1, len(middle) // (4 * DATES))]
    grid = np.linspace(every[0], every[-1], DATES + 1) if len(every) > 1 else every
    pairs = [(a, b) for i, a in enumerate(grid) for b in grid[i + 1 :]]
    start, end = np.array([*((m, m) for m in middle), *pairs]).reshape(-1, 2).T
    share = np.clip((days - start[:, None]) / np.maximum(end - start, 1e-9)[:, None], 0.0, 1.0)
    keys = place + np.random.default_rng(seed).random((PERMUTATIONS, len(logs)))
    orders = np.tile(np.arange(len(logs)), (1 + PERMUTATIONS, 1))
    orders[1:, np.argsort(place, kind="stable")] = np.argsort(keys, axis=1)
    return Calendar(logs, days, group, share, start, end, orders)


class Course:
    """A feature in the logs of a unit's ``calendar``, of which ``shown`` [K] show it, with the ``population``
    that it is of. ``orbit`` [1 + P]: its statistic with the dates as they are, then with others. Of what only
    harms where it grows, no fall is a change (``rises``)."""

    def __init__(
        self, calendar: Calendar, shown: NDArray[np.bool_], population: Population, *, rises: bool = False
    ) -> None:
        self.calendar, self._rises = calendar, rises
        self.logs, self.group = calendar.logs[shown], calendar.group[shown]
        self.value, self.share = population.value[self.logs], calendar.share[:, shown]
        usual, known = population.between_logs, population.between_programs
        # Programs of this unit may differ by more than those of others: no change is seen between them then.
        means = [float(np.mean(self.value[self.group == g])) for g in np.unique(self.group)]
        own = float(np.var(means, ddof=1)) if len(means) > 1 else 0.0
        programs = 1e6 * usual if known is None else max(known, own)
        same = self.group[:, None] == self.group
        V = np.diag(usual + population.stderr[self.logs] ** 2) + programs * same
        whiten = np.linalg.inv(np.linalg.cholesky(V))
        one = whiten.sum(axis=1)
        self._M = whiten - np.outer(one, one @ whiten) / float(one @ one)
        self._z = self._M @ self.value
        self._a = self._M.T @ self._z
        precision = np.maximum(np.einsum("ij,ij->j", self._M, self._M), 1e-12)
        self.odd = np.abs(self._a) / np.sqrt(precision)  # by how many errors each log is off
        self.freedom = FREEDOM + max(len(self.logs) - len(means) - 2, 0)
        shares, orders = calendar.share.T, calendar.orders[:, shown]
        step = max(1, _TOGETHER // max(self.share.size, 1))
        parts = [shares[orders[k : k + step]].swapaxes(1, 2) for k in range(0, len(orders), step)]
        best = np.concatenate([self.gains(part).max(axis=-1, initial=0.0) for part in parts])
        self.orbit = np.maximum(best - float(self.odd.max()) ** 2, 0) / self.variance(best)

    def gains(self, share: Floats) -> Floats:
        """Squares that changes [..., S, K] take away [..., S]: none where a change lies on one log."""
        squares = (share @ self._M.T) ** 2
        whole = squares.sum(axis=-1)
        along = share @ self._a
        spread = (
            (whole > 1e-9) & (squares.max(axis=-1) <= ONE_LOG * whole) & ((along > 0) | (not self._rises))
        )
        return np.where(spread, along**2 / np.where(whole > 1e-9, whole, 1.0), 0.0)

    def variance(self, gain: Floats) -> Floats:
        """The variance of logs, beside what is usual, where changes take away so much (``gain`` [...])."""
        left = np.maximum(float(self._z @ self._z) - gain, 0)
        return np.asarray((FREEDOM + left) / self.freedom)

    def amount(self, share: Floats) -> tuple[float, float]:
        """How large a change [K] is, and its standard error."""
        Z = self._M @ share
        whole, along = float(Z @ Z), float(Z @ self._z)
        return along / whole, float(np.sqrt(self.variance(np.array(along**2 / whole)) / whole))

    def holds(self, share: Floats, size: float) -> bool:
        """Whether the change is there in the logs that it speaks of: the middle one of those after it differs
        from the middle one of those before it, each beside its program's, by half of it or more."""
        late = share >= 0.5
        programs = [self.group == g for g in np.unique(self.group)]
        both = [own for own in programs if (own & late).any() and (own & ~late).any()]
        differences = [
            [np.median(each[own & late]) - np.median(each[own & ~late]) for each in (self.value, share)]
            for own in both or [np.ones_like(late)]
            if late.any() and not late.all()
        ]
        if not differences:
            return False
        value, part = np.median(differences, axis=0)
        return bool(value * np.sign(size) >= 0.5 * abs(size) * part)


def course_of(calendar: Calendar, population: Population, *, rises: bool) -> Course | None:
    """The :class:`Course` of a feature in the logs of a unit; None where too few show it to tell a change."""
    shown = np.isfinite(population.value[calendar.logs])
    programs = len(np.unique(calendar.group[shown]))
    if not np.isfinite(population.between_logs) or shown.sum() < max(LEAST_LOGS, LEAST_LOGS - 1 + programs):
        return None
    return Course(calendar, shown, population, rises=rises)
