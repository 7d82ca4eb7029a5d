"""DF/IHS: depth first with implicit heuristic search, which begins where CP/MISF ends.

The tree is gone through depth first, and in every node the branch that critical path and most immediate
successors would take comes first: the first way down is the list schedule CP/MISF, whatever comes later can
only be shorter. A branch is left where its bound is no better than the best schedule, or where the same tasks
had begun no later before.

Source: Kasahara and Narita 1984, Practical Multiprocessor Scheduling Algorithms for Efficient Parallel
Processing, IEEE Trans. Computers C-33; 1985, Parallel Processing of Robot-Arm Control Computation on a
Multimicroprocessor System, IEEE J. Robotics and Automation 1. Neither was at hand; the bound is that of
Fernandez and Bussell which they are known to use.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from robodyn.schedule.graph import TaskId
from robodyn.schedule.tree import Ended, Limits, Node, Searched, Tree


def df_ihs(tree: Tree, known: Mapping[TaskId, int], span: int, limits: Limits) -> Searched:
    """The best schedule within ``limits``; not longer than the one that is ``known`` (starts of tasks, and
    its ``span``), which is that of CP/MISF."""
    best, starts = span, known
    root = tree.root()
    ways: list[Iterator[Node]] = [tree.branches(root)] if root.ready else []
    seen: dict[object, int] = {}
    nodes, ended = 0, None
    while ways and best > tree.bound_of_all and ended is None:
        node = next(ways[-1], None)
        if node is None:
            ways.pop()
            continue
        nodes += 1
        ended = limits.reached(nodes)
        if tree.complete(node):
            if node.time < best:
                best, starts = node.time, tree.starts(node)
            continue
        if tree.bound(node) >= best:
            continue
        state = tree.same(node)
        if seen.get(state, best) <= node.time:
            continue
        seen[state] = node.time
        ways.append(tree.branches(node))
    proven: Ended = "proven"
    whole = not ways or best <= tree.bound_of_all
    return Searched(
        starts, best, best if whole else tree.bound_of_all, nodes, proven if whole else ended or proven
    )
