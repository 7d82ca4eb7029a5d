"""Operation counts by the thesis's convention, budgets on them, and the thesis's figures beside ours."""

from robodyn.counts.budget import Budget, parse_budget
from robodyn.counts.count import Count, count
from robodyn.counts.thesis import Beside, beside

__all__ = ["Beside", "Budget", "Count", "beside", "count", "parse_budget"]
