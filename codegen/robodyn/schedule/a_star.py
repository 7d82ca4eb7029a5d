"""A*: of all schedules begun, the one that promises the shortest end is continued.

What it promises is a bound that no way through it can beat, so that the first schedule which is complete is a
shortest one, and where a limit ends the search, the least promise that is open bounds all schedules. Among
equal promises the one that has got furthest goes first. A node hands over its branches a few at a time, most
urgent first, and waits with its own promise meanwhile: there may be thousands.

Source: Chen, Lee and Hou 1988, Efficient Scheduling Algorithms for Robot Inverse Dynamics Computation on a
Multiprocessor System, IEEE Trans. SMC 18(5), who search by an improved A*. The paper was not at hand:
promise, order and memory are ours.
"""

from __future__ import annotations

import heapq
import itertools
from collections.abc import Iterator, Mapping
from typing import Final

from robodyn.schedule.graph import TaskId
from robodyn.schedule.tree import Ended, Limits, Node, Searched, Tree

#: Branches that a node hands over at a time.
_AT_A_TIME: Final = 8


def a_star(tree: Tree, known: Mapping[TaskId, int], span: int, limits: Limits) -> Searched:
    """The best schedule within ``limits``; not longer than the one that is ``known`` (starts of tasks, and
    its ``span``)."""
    best, starts = span, known
    root = tree.root()
    seen: dict[object, int] = {}
    age = itertools.count()
    # (promise, less the number of tasks that have begun, age, node, its branches that are left)
    waiting: list[tuple[int, int, int, Node, Iterator[Node]]] = []
    if root.ready:
        waiting.append((tree.bound_of_all, 0, next(age), root, tree.branches(root)))
    nodes, ended = 0, None
    while waiting and waiting[0][0] < best and ended is None:
        promise, depth, order, node, branches = heapq.heappop(waiting)
        some = list(itertools.islice(branches, _AT_A_TIME))
        if len(some) == _AT_A_TIME:
            heapq.heappush(waiting, (promise, depth, order, node, branches))
        for child in some:
            nodes += 1
            ended = ended or limits.reached(nodes)
            if tree.complete(child):
                if child.time < best:
                    best, starts = child.time, tree.starts(child)
                continue
            state = tree.same(child)
            if seen.get(state, best) <= child.time:
                continue
            bound = max(promise, tree.bound(child))
            if bound < best:
                seen[state] = child.time
                begun = child.begun.bit_count()
                heapq.heappush(waiting, (bound, -begun, next(age), child, tree.branches(child)))
    least = min(waiting[0][0], best) if waiting else best
    proven: Ended = "proven"
    return Searched(starts, best, least, nodes, proven if least == best else ended or proven)
