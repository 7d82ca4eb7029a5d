"""How often a name is right that leads its rivals by so much."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from robodyn.diagnose.select.limits import TEMPER


def odds(rivals: Iterable[tuple[float, float]]) -> float:
    """The share of right names among those with such ``rivals``: each foretells less by so many standard
    errors, and has so many more numbers (a nat for each, Akaike 1974). A softmax of both; its slope is of
    blind trials (docs/diagnose.md)."""
    weights = [np.exp(-TEMPER * max(behind, 0.0) - max(more, 0.0)) for behind, more in rivals]
    return float(1 / (1 + sum(weights)))
