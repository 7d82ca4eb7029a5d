"""Operation counts by the thesis's convention, budgets on them, and the thesis's figures beside ours.

The thesis's figures are in :mod:`robodyn.counts.thesis`: a check of budgets does not need them.
"""

from robodyn.counts.count import Budget, Count, count, parse_budget

__all__ = ["Budget", "Count", "count", "parse_budget"]
