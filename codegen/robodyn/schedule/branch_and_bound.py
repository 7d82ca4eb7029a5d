"""Searches through trees of schedules: branch and bound, DF/IHS, and A*.

**Branch and bound.** One processor a joint: which of its tasks each does in every level. Source: Luh and Lin
1982, who give every joint of an arm its own processor and search for the shortest order with a variable
branch and bound. Levels here, as in the thesis: tasks of equal length. Branches are ordered by the longest
remaining chain; a branch is left where its bound, the longest chain or the busiest processor's own
(Jackson's, heads and tails kept), is no shorter than the best schedule known. The search is variable in that
it goes through the levels with ever more states of each, twice as many every time.

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
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from robodyn.schedule.graph import TaskGraph, TaskId
from robodyn.schedule.machine import Schedule
from robodyn.schedule.tree import Ended, Limits, Node, Searched, Tree


@dataclass(frozen=True, slots=True)
class Bounded:
    """The best schedule found, whether nothing shorter exists, and what nothing can beat."""

    schedule: Schedule
    lower_bound: int
    proven: bool


@dataclass(slots=True)
class _Search:
    graph: TaskGraph
    owner: Mapping[TaskId, int]
    joints: int
    deadline: float
    clock: Callable[[], float]
    tail: Mapping[TaskId, int] = field(init=False)
    later: Mapping[TaskId, frozenset[TaskId]] = field(init=False)
    best: list[tuple[TaskId, ...]] | None = None

    def __post_init__(self) -> None:
        self.tail, self.later = self.graph.remaining(), self.graph.before()

    @property
    def late(self) -> bool:
        """Whether time is up; not before there is a schedule."""
        return self.best is not None and self.clock() > self.deadline


@dataclass(frozen=True, slots=True)
class _State:
    """After some levels: what waits for how much, what may be done next, and what was done."""

    waiting: dict[TaskId, int]
    ready: tuple[TaskId, ...]
    level: tuple[TaskId, ...]
    before: _State | None

    def path(self) -> list[tuple[TaskId, ...]]:
        """The levels that led here."""
        path, state = [], self
        while state.before is not None:
            path.append(state.level)
            state = state.before
        return path[::-1]


def one_processor_a_joint(
    graph: TaskGraph, *, seconds: float = 5.0, clock: Callable[[], float] = time.monotonic
) -> Bounded:
    """The shortest schedule that does the tasks of a link on the processor of that link, or the best found
    within ``seconds`` (the first schedule is found whatever they are)."""
    links = sorted({graph.link(task) for task in graph.tasks})
    owner = {task: links.index(graph.link(task)) for task in graph.tasks}
    search = _Search(graph, owner, len(links), clock() + seconds, clock)
    waiting = {task: len(needed) for task, needed in graph.after.items()}
    root = _State(waiting, tuple(task for task in graph.tasks if not waiting[task]), (), None)
    if not root.ready:
        return Bounded(Schedule(max(1, len(links)), ()), 0, True)
    bound = _left(search, root)
    width, whole = 1, False
    while not whole and not search.late and (search.best is None or len(search.best) > bound):
        whole = _widened(search, root, width)
        width *= 2
    assert search.best is not None
    rows: list[tuple[TaskId | None, ...]] = []
    for level in search.best:
        row: list[TaskId | None] = [None] * len(links)
        for task in level:
            row[owner[task]] = task
        rows.append(tuple(row))
    proven = whole or len(rows) == bound
    return Bounded(Schedule(len(links), tuple(rows)), len(rows) if proven else bound, proven)


def _widened(search: _Search, root: _State, width: int) -> bool:
    """Go through the levels with the ``width`` most promising states of each; whether no other state was
    left out that could have led to a shorter schedule."""
    whole = True
    states, done = [root], 0
    while states:
        done += 1
        successors: dict[frozenset[TaskId], tuple[tuple[int, int], _State]] = {}
        for state in states:
            branches = _branches(search, state.ready)
            for taken in itertools.islice(branches, 4 * width):
                after = _after(search, state, taken)
                if not after.ready:
                    if search.best is None or done < len(search.best):
                        search.best = after.path()
                    continue
                # What is left decides all that follows.
                left = frozenset(task for task, count in after.waiting.items() if count >= 0)
                if left in successors:
                    continue
                bound = done + _left(search, after)
                if search.best is not None and bound >= len(search.best):
                    continue
                successors[left] = ((bound, sum(search.tail[task] for task in left)), after)
            whole = whole and next(branches, None) is None
            if search.late:
                return False
        ranked = sorted(successors.values(), key=lambda one: one[0])
        whole = whole and len(ranked) <= width
        states = [state for _, state in ranked[:width]]
    return whole


def _after(search: _Search, state: _State, taken: tuple[TaskId, ...]) -> _State:
    waiting = dict(state.waiting)
    gone = set(taken)
    ready = [task for task in state.ready if task not in gone]
    for task in taken:
        waiting[task] = -1  # done
        for follower in search.later[task]:
            waiting[follower] -= 1
            if not waiting[follower]:
                ready.append(follower)
    return _State(waiting, tuple(ready), taken, state)


def _jackson(tasks: Sequence[tuple[int, int]]) -> int:
    """The shortest time in which one processor does unit tasks ``(head, tail)``: of those whose head has
    passed, the one with the longest tail first."""
    left = sorted(tasks)
    ready: list[int] = []
    now = end = k = 0
    while k < len(left) or ready:
        if not ready:
            now = max(now, left[k][0])
        while k < len(left) and left[k][0] <= now:
            heapq.heappush(ready, -left[k][1])
            k += 1
        now += 1
        end = max(end, now - heapq.heappop(ready))
    return end


def _branches(search: _Search, ready: Sequence[TaskId]) -> Iterator[tuple[TaskId, ...]]:
    """What may be done in the next level, best first: for each processor one of its ready tasks. A
    processor that has a ready task never idles: no schedule of unit tasks gets longer by that."""
    groups: dict[int, list[TaskId]] = {}
    for task in sorted(ready, key=lambda task: (-search.tail[task], -len(search.later[task]), task)):
        groups.setdefault(search.owner[task], []).append(task)
    return itertools.product(*groups.values())


def _left(search: _Search, state: _State) -> int:
    """Levels that are still needed at least, every task that is ready being able to begin now."""
    longest = max(search.tail[task] for task in state.ready)
    heads: dict[TaskId, int] = dict.fromkeys(state.ready, 0)
    queue = list(state.ready)
    need = dict(state.waiting)
    jobs: list[list[tuple[int, int]]] = [[] for _ in range(search.joints)]
    for task in queue:  # grows while it is read: in an order of evaluation
        jobs[search.owner[task]].append((heads[task], search.tail[task] - 1))
        for follower in search.later[task]:
            heads[follower] = max(heads.get(follower, 0), heads[task] + 1)
            need[follower] -= 1
            if not need[follower]:
                queue.append(follower)
    return max([longest, *(_jackson(tasks) for tasks in jobs if tasks)])


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
