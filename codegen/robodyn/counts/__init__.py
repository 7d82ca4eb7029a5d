"""Operation counts by the thesis's convention, budgets on them, and the thesis's figures beside ours.

The thesis's figures are imported when they are first asked for: a check of budgets does not need them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from robodyn.counts.count import Budget, Count, count, parse_budget

if TYPE_CHECKING:
    from robodyn.counts.thesis import Beside, beside

__all__ = ["Beside", "Budget", "Count", "beside", "count", "parse_budget"]


def __getattr__(name: str) -> Any:
    if name not in ("Beside", "beside"):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from robodyn.counts import thesis

    return getattr(thesis, name)
