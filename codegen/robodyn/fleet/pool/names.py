"""Which of all that was looked at gets a name: false names are a stated share of names over the whole
fleet."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def tail(
    worth: float, numbers: int, tests: float, *, freedom: float = np.inf, inflation: float = 1.0
) -> float:
    """How often chance alone makes the largest of so many independent ``tests`` worth as much (log-likelihood
    ratio, of changes of ``numbers`` amplitudes). ``freedom``: of the scatter that it is held against, which
    few units or logs tell less well; ``inflation``: by how much ratios of this kind are larger in this fleet
    than they should be."""
    from scipy.stats import chi2, f

    square = 2 * max(worth, 0.0) / inflation
    one = float(chi2.sf(square, numbers) if np.isinf(freedom) else f.sf(square / numbers, numbers, freedom))
    return float(-np.expm1(tests * np.log1p(-min(one, 1 - 1e-16))))


def inflation(worth: Floats, numbers: int) -> float:
    """By how much the middle one of log-likelihood ratios [K] is larger than that of chance (Devlin and
    Roeder 1999); at least 1."""
    from scipy.stats import chi2

    if len(worth) == 0:
        return 1.0
    return max(1.0, float(np.median(2 * np.maximum(worth, 0))) / float(chi2.ppf(0.5, numbers)))


def false_shares(p: Floats) -> Floats:
    """The share [K] of false names among all that are no less sure, by Benjamini and Hochberg (1995)."""
    count = len(p)
    order = np.argsort(p, kind="stable")
    shares = p[order] * count / np.arange(1, count + 1)
    shares = np.minimum(np.minimum.accumulate(shares[::-1])[::-1], 1.0)
    result = np.empty(count)
    result[order] = shares
    return result
