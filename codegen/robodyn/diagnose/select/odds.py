"""How often a name is right that leads its rivals by so much, where so much is explained."""

from __future__ import annotations

from collections.abc import Iterable
from statistics import NormalDist

import numpy as np

from robodyn.diagnose.select.limits import ODDS


def odds(rivals: Iterable[tuple[float, float]], explained: float) -> float:
    """The share of right names among those with such ``rivals``, at whose joint all names together have
    ``explained`` such a share of the RMS: that it is this name of all that explain as much, times that it is
    one of the catalogue at all.

    Each rival foretells less by so many standard errors, and has so many more numbers (a nat for each, Akaike
    1974): the odds that it is no worse, and these. One that is ahead by less than what is worth a name, or
    simpler, counts as level: the choice has weighed that. The other factor is calibrated (:data:`ODDS`)."""
    beside = 0.0
    for behind, more in rivals:
        chance = NormalDist().cdf(-max(behind, 0.0))
        beside += chance / (1 - chance) * float(np.exp(-max(more, 0.0)))
    share = min(max(explained, 0.01), 0.99)
    first, by_share, most = ODDS
    return float(most / (1 + beside) / (1 + np.exp(-first - by_share * np.log(share / (1 - share)))))
