"""The search for fewer operations: formulation variants, then any algebra that holds.

``structured`` goes through gauges, forms, frames and origins; ``climb`` walks on from the best of them.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from robodyn.counts.objective import Objective
    from robodyn.search.improve import improved

_HOMES = {"Objective": "robodyn.counts.objective", "improved": "robodyn.search.improve"}

__all__ = ["Objective", "improved"]


def __getattr__(name: str) -> Any:
    if name in _HOMES:
        value = getattr(importlib.import_module(_HOMES[name]), name)
        globals()[name] = value
        return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
