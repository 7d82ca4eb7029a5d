"""Of several drafts of a program the one that costs the least after the passes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from robodyn.counts import count
from robodyn.ir.program import Program
from robodyn.passes import SPELLING, Pass, unchecked

#: Of two drafts the passes take much the same share away; what is further below need not wait for them.
CLEARLY = 0.9
#: The passes take less than a sixth of a draft away: a record that is further below need not wait for them.
OF_PASSES = 5 / 6
#: Joints of an arm at most of which a function that is put together from its parts in any case is written
#: anew as well: that saves an operation in a hundred on one arm in thirty, and takes long on long arms. Of
#: longer ones a way over the parts is not built where these alone take clearly more than another way.
ANEW_JOINTS = 12
#: Where less of a matrix is numbers, known beforehand, than what this leaves, its factors take about as many
#: operations as those of one without any.
DENSE = 0.9
#: Of so few operations, and of gravity's, they may save more.
SMALL = 100


def total(program: Program) -> float:
    """How many operations ``program`` takes."""
    return count(program).total


def least(
    drafts: Sequence[Program], saving: Sequence[Pass], cost: Callable[[Program], float] = total
) -> tuple[int, Program]:
    """Which of ``drafts`` costs the least after the passes, the first of equals, and what they make of it.

    No ``cost`` depends on signs and order, so only the best draft is spelled; and ``saving`` passes are not
    run on one that takes so many more operations that they cannot bring it down to another.
    """
    if len(drafts) == 1:
        return 0, unchecked(drafts[0], (*saving, *SPELLING))
    costs = list(map(cost, drafts))
    passed: dict[int, Program] = {}
    best = min(costs)
    for k in sorted(range(len(drafts)), key=costs.__getitem__):
        if cost is total and costs[k] > SMALL and CLEARLY * costs[k] >= best:
            continue
        passed[k] = unchecked(drafts[k], saving)
        costs[k] = cost(passed[k])
        best = min(best, costs[k])
    k = min(passed, key=lambda k: (costs[k], k))
    return k, unchecked(passed[k], SPELLING)
