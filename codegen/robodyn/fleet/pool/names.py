"""Which of all units get a name: false names are a stated share of names over the whole fleet, and how rare
something is, is measured by the fleet itself."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robodyn.fleet.limits import FREEDOMS, MIDDLE, RARE

Floats = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Chance:
    """What chance does to log-likelihood ratios of one kind in a fleet: they are larger by ``inflation`` than
    they should be, and large ones are as frequent as beside a scatter of so much ``freedom``."""

    inflation: float = 1.0
    freedom: float = np.inf


@dataclass(frozen=True, slots=True, eq=False)
class Odds:
    """Of one kind all log-likelihood ratios of a fleet (``worth`` [K]), of changes of ``numbers`` amplitudes:
    each the best of so many independent ``tests`` [K], beside a scatter of so much ``freedom`` [K], which few
    units or logs tell less well."""

    worth: Floats
    numbers: int
    tests: Floats
    freedom: Floats

    def tails(self, chance: Chance) -> Floats:
        """How often chance alone makes each as large [K]."""
        from scipy.stats import chi2, f

        square = 2 * np.maximum(self.worth, 0.0) / chance.inflation
        freedom = np.minimum(self.freedom, chance.freedom)
        known = np.isinf(freedom)
        one = f.sf(square / self.numbers, self.numbers, np.where(known, 1.0, freedom))
        one = np.where(known, chi2.sf(square, self.numbers), one)
        return of_several(one, self.tests)

    def sizes(self, p: float, freedom: float) -> Floats:
        """What twice a ratio must come to that chance alone makes it so large as often as ``p`` [K], beside a
        scatter of so much ``freedom`` at most."""
        from scipy.stats import chi2, f

        every = np.stack([self.tests, np.minimum(self.freedom, freedom)])
        several, of = np.unique(every, axis=1, return_inverse=True)
        one = -np.expm1(np.log1p(-p) / several[0])
        known = np.isinf(several[1])
        sizes = self.numbers * f.isf(one, self.numbers, np.where(known, 1.0, several[1]))
        return np.asarray(np.where(known, chi2.isf(one, self.numbers), sizes)[of.ravel()])


def of_several(p: Floats, tests: Floats | float) -> Floats:
    """How often the rarest of so many independent ``tests`` is as rare as ``p`` (Sidak 1967)."""
    return np.asarray(-np.expm1(tests * np.log1p(-np.minimum(p, 1 - 1e-16))))


def chance_of(odds: Odds) -> Chance:
    """What chance does to ratios of a kind, by the units in the middle and not far from it: most of a fleet
    is healthy (Devlin and Roeder 1999; Efron 2004). With few of them that it does more than it should is not
    believed."""
    count = len(odds.worth)
    if not count:
        return Chance()
    most = RARE * count + np.sqrt(RARE * (1 - RARE) * count)
    chance, size = Chance(), 2 * np.maximum(odds.worth, 0.0)
    for freedom in FREEDOMS:
        inflation = max(1.0, float(np.median(size / odds.sizes(MIDDLE, freedom))))
        chance = Chance(inflation, freedom)
        if (size > inflation * odds.sizes(RARE, freedom)).sum() <= most:
            break
    return chance


def false_shares(p: Sequence[float] | Floats) -> Floats:
    """The share [K] of false names among all that are no less sure, by Benjamini and Hochberg (1995)."""
    rarity = np.asarray(p, dtype=np.float64)
    count = len(rarity)
    order = np.argsort(rarity, kind="stable")
    shares = rarity[order] * count / np.arange(1, count + 1)
    shares = np.minimum(np.minimum.accumulate(shares[::-1])[::-1], 1.0)
    result = np.empty(count)
    result[order] = shares
    return result
