"""The tree of schedules, with what no branch can beat, and the searches DF/IHS and A* that walk through it.

A node is a moment at which a processor is free: what has begun, what still runs, what is ready. A branch
gives some ready tasks to free processors, the most urgent first (longest remaining chain, then most immediate
successors), and time goes on to the next end of a task. Fewer tasks than could begin are only tried where
tasks differ in length: of equal ones none is gained by waiting. Every schedule in which each task begins when
another ends is in the tree, and so is a shortest one. Passing values costs nothing.

Source of the bound: Hu 1961, and Fernandez and Bussell 1973 for tasks of any length: what has to be done
``j`` before the end at the latest needs processors until then.

**DF/IHS**: depth first with implicit heuristic search, which begins where CP/MISF ends. In every node the
branch that critical path and most immediate successors would take comes first: the first way down is the
list schedule CP/MISF, whatever comes later can only be shorter. A branch is left where its bound is no
better than the best schedule, or where the same tasks had begun no later before. Source: Kasahara and Narita
1984, Practical Multiprocessor Scheduling Algorithms for Efficient Parallel Processing, IEEE Trans. Computers
C-33; 1985, Parallel Processing of Robot-Arm Control Computation on a Multimicroprocessor System, IEEE J.
Robotics and Automation 1. Neither was at hand; the bound is that of Fernandez and Bussell which they are
known to use.

**A***: of all schedules begun, the one that promises the shortest end is continued. What it promises is a
bound that no way through it can beat, so that the first schedule which is complete is a shortest one, and
where a limit ends the search, the least promise that is open bounds all schedules. Among equal promises the
one that has got furthest goes first. A node hands over its branches a few at a time, most urgent first, and
waits with its own promise meanwhile: there may be thousands. Source: Chen, Lee and Hou 1988, Efficient
Scheduling Algorithms for Robot Inverse Dynamics Computation on a Multiprocessor System, IEEE Trans. SMC
18(5), who search by an improved A*. The paper was not at hand: promise, order and memory are ours.
"""

from __future__ import annotations

import heapq
import itertools
import time
from bisect import insort
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final, Literal, NamedTuple

from robodyn.schedule.graph import TaskGraph, TaskId, lower_bound
from robodyn.schedule.heuristics import critical_path_order

#: Nodes that a search looks at unless it is told otherwise: seconds, and at most some 100 MB.
MOST_NODES: Final = 200_000

#: Why a search ended: nothing shorter exists, or a limit was reached.
Ended = Literal["proven", "nodes", "seconds"]


class Node(NamedTuple):
    """A moment: bits of the tasks that have ``begun`` and ``done``, ``(end, task)`` of those that run, tasks
    that are ready, and the way here. Tasks are numbered by urgency."""

    time: int
    begun: int
    done: int
    running: tuple[tuple[int, int], ...]
    ready: tuple[int, ...]
    taken: tuple[int, ...]
    before: Node | None


@dataclass(frozen=True, slots=True)
class Limits:
    """When a search gives up: after so many ``nodes``, or when ``clock`` passes ``deadline``."""

    nodes: int
    deadline: float
    clock: Callable[[], float] = time.monotonic

    def reached(self, nodes: int) -> Ended | None:
        """The limit that is reached after so many nodes."""
        if nodes >= self.nodes:
            return "nodes"
        if not nodes % 256 and self.clock() > self.deadline:
            return "seconds"
        return None


@dataclass(frozen=True, slots=True)
class Searched:
    """The best starts of tasks that a search knows, its ``span``, what nothing can beat, the nodes it looked
    at, and why it ended."""

    starts: Mapping[TaskId, int]
    span: int
    lower_bound: int
    nodes: int
    ended: Ended


class Tree:
    """The tree of schedules of ``graph`` on ``processors``."""

    def __init__(self, graph: TaskGraph, processors: int) -> None:
        self.graph, self.processors = graph, processors
        self.tasks = sorted(graph.tasks, key=critical_path_order(graph))
        index = {task: i for i, task in enumerate(self.tasks)}
        remaining, later = graph.remaining(), graph.before()
        self.length = [graph.length(task) for task in self.tasks]
        self.tail = [remaining[task] for task in self.tasks]
        self.needs = [sum(1 << index[other] for other in graph.after[task]) for task in self.tasks]
        self.later = [sorted(index[other] for other in later[task]) for task in self.tasks]
        self.uniform = graph.uniform
        self.bound_of_all = lower_bound(graph, processors)
        self._all = (1 << len(self.tasks)) - 1
        # Of tasks of length 1: those that must be done j and more before the end.
        longest = max(self.tail, default=0)
        self._urgent = [sum(1 << i for i, tail in enumerate(self.tail) if tail > j) for j in range(longest)]

    def root(self) -> Node:
        """Before anything has begun."""
        ready = tuple(i for i, needs in enumerate(self.needs) if not needs)
        return Node(0, 0, 0, (), ready, (), None)

    def branches(self, node: Node) -> Iterator[Node]:
        """The next moments, the most urgent choice of tasks first."""
        most = min(self.processors - len(node.running), len(node.ready))
        fewest = most if self.uniform else (0 if node.running else 1)
        for size in range(most, fewest - 1, -1):
            for taken in itertools.combinations(node.ready, size):
                yield self._after(node, taken)

    def _after(self, node: Node, taken: tuple[int, ...]) -> Node:
        running = list(node.running)
        begun, done = node.begun, node.done
        for i in taken:
            insort(running, (node.time + self.length[i], i))
            begun |= 1 << i
        now = running[0][0]
        ended = [i for end, i in running if end == now]
        for i in ended:
            done |= 1 << i
        chosen = set(taken)
        ready = [i for i in node.ready if i not in chosen]
        freed = {other for i in ended for other in self.later[i] if not self.needs[other] & ~done}
        return Node(
            now, begun, done, tuple(running[len(ended) :]), tuple(sorted([*ready, *freed])), taken, node
        )

    def complete(self, node: Node) -> bool:
        """Whether all is done."""
        return node.done == self._all

    def same(self, node: Node) -> tuple[int, tuple[tuple[int, int], ...]]:
        """What decides all that follows, but for the time: of two such nodes the earlier one will do."""
        return node.begun, tuple((end - node.time, i) for end, i in node.running)

    def bound(self, node: Node) -> int:
        """The end of the shortest schedule through ``node`` at the earliest."""
        if self.uniform:
            left = self._all & ~node.begun
            return node.time + max(
                (j + -(-(left & urgent).bit_count() // self.processors) for j, urgent in self._still(left)),
                default=0,
            )
        return node.time + self._bound_of_lengths(node)

    def _still(self, left: int) -> Iterator[tuple[int, int]]:
        for j, urgent in enumerate(self._urgent):
            if not left & urgent:
                return
            yield j, urgent

    def _bound_of_lengths(self, node: Node) -> int:
        """As :meth:`bound`, from now on: of a task with ``tail`` until the end so much as lies beyond ``j``
        must be done ``j`` before the end, ``min(length, tail - j)``; the sum is linear between its bends."""
        work = [(end - node.time, end - node.time + self.tail[i] - self.length[i]) for end, i in node.running]
        left = self._all & ~node.begun
        while left:
            lowest = left & -left
            i = lowest.bit_length() - 1
            work.append((self.length[i], self.tail[i]))
            left ^= lowest
        slope: dict[int, int] = {}
        for length, tail in work:  # read from the end back: nothing before its tail, then one more a unit
            slope[tail] = slope.get(tail, 0) + 1
            slope[tail - length] = slope.get(tail - length, 0) - 1
        best = rate = total = 0
        now = max(slope, default=0)
        for j in sorted(slope, reverse=True):
            total += rate * (now - j)
            rate += slope[j]
            now = j
            best = max(best, j + -(-total // self.processors))
        return max([best, *(tail for _, tail in work)])

    def starts(self, node: Node) -> dict[TaskId, int]:
        """When each task began on the way to ``node``."""
        starts: dict[TaskId, int] = {}
        while node.before is not None:
            starts.update((self.tasks[i], node.before.time) for i in node.taken)
            node = node.before
        return starts


#: Branches that a node of A* hands over at a time.
_AT_A_TIME: Final = 8


def searched(
    tree: Tree, known: Mapping[TaskId, int], span: int, limits: Limits, *, best_first: bool
) -> Searched:
    """The best schedule within ``limits``, by A* if ``best_first`` and else by DF/IHS; not longer than
    the one that is ``known`` (starts of tasks, and its ``span``), for DF/IHS that of CP/MISF."""
    best, starts = span, known
    root, bound_of_all = tree.root(), tree.bound_of_all
    seen: dict[object, int] = {}
    ages = itertools.count()
    #: Promise, order among equal ones, age, node, and its branches that are left.
    waiting: list[tuple[int, int, int, Node, Iterator[Node]]] = []
    if root.ready:
        waiting.append((bound_of_all, 0, next(ages), root, tree.branches(root)))
    at_a_time = _AT_A_TIME if best_first else 1
    nodes, ended = 0, None
    while waiting and waiting[0][0] < best and ended is None:
        promise, order, age, node, branches = heapq.heappop(waiting)
        some = list(itertools.islice(branches, at_a_time))
        if len(some) == at_a_time:
            heapq.heappush(waiting, (promise, order, age, node, branches))
        for child in some:
            nodes += 1
            ended = ended or limits.reached(nodes)
            if tree.complete(child):
                if child.time < best:
                    best, starts = child.time, tree.starts(child)
                continue
            state, bound = tree.same(child), max(promise, tree.bound(child))
            if bound >= best or seen.get(state, best) <= child.time:
                continue
            seen[state], age = child.time, next(ages)
            # DF/IHS goes down from the youngest node, A* from that of the least promise which got furthest.
            rank = (bound, -child.begun.bit_count()) if best_first else (bound_of_all, -age)
            heapq.heappush(waiting, (*rank, age, child, tree.branches(child)))
    least = min(waiting[0][0], best) if waiting else best
    proven: Ended = "proven"
    return Searched(starts, best, least, nodes, proven if least == best else ended or proven)
