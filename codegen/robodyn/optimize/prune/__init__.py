"""Pruning: terms that cannot matter within a robot's limits are dropped, and the error is proven.

Luh and Lin 1981 dropped what is small of the PUMA's equations, Armstrong, Khatib and Burdick 1986 came to 305
operations so; neither bounded the error over all states.
"""

from robodyn.optimize.prune.pruning import (
    PRUNED,
    PruneError,
    Pruning,
    check_asked,
    notes_of,
    parse_tolerance,
    peaks_of,
    prune,
)

__all__ = [
    "PRUNED", "PruneError", "Pruning", "check_asked", "notes_of", "parse_tolerance", "peaks_of", "prune",
]  # fmt: skip
