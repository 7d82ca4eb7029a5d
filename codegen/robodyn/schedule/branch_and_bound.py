"""Branch and bound with one processor a joint: which of its tasks each does in every level. Source: Luh and
Lin 1982, who give every joint of an arm its own processor and search for the shortest order with a variable
branch and bound. Levels here, as in the thesis: tasks of equal length. Branches are ordered by the longest
remaining chain; a branch is left where its bound, the longest chain or the busiest processor's own
(Jackson's, heads and tails kept), is no shorter than the best schedule known. The search is variable in that
it goes through the levels with ever more states of each, twice as many every time.
"""

from __future__ import annotations

import heapq
import itertools
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from robodyn.schedule.graph import TaskGraph, TaskId
from robodyn.schedule.machine import Schedule


@dataclass(frozen=True, slots=True)
class Bounded:
    """The best schedule found, whether nothing shorter exists, and what nothing can beat."""

    schedule: Schedule
    lower_bound: int
    proven: bool


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
    deadline, search = clock() + seconds, _Search(graph)
    root = search.root()
    if not root.ready:
        return Bounded(Schedule(max(1, search.joints), ()), 0, True)

    def is_late() -> bool:
        return search.best is not None and clock() > deadline

    bound, width, whole = search.left(root), 1, False
    while not whole and not is_late() and (search.best is None or len(search.best) > bound):
        whole = search.widened(root, width, is_late)
        width *= 2
    assert search.best is not None
    rows: list[tuple[TaskId | None, ...]] = []
    for level in search.best:
        doing = {search.owner[task]: task for task in level}
        rows.append(tuple(map(doing.get, range(search.joints))))
    proven = whole or len(rows) == bound
    return Bounded(Schedule(search.joints, tuple(rows)), len(rows) if proven else bound, proven)


class _Search:
    """The levels of ``graph``, each joint's tasks on a processor of its own; ``best``: the best so far."""

    def __init__(self, graph: TaskGraph) -> None:
        self.graph, self.tail, self.later = graph, graph.remaining(), graph.before()
        links = sorted({graph.link(task) for task in graph.tasks})
        self.owner = {task: links.index(graph.link(task)) for task in graph.tasks}
        self.joints = len(links)
        self.best: list[tuple[TaskId, ...]] | None = None

    def root(self) -> _State:
        """Before anything is done."""
        waiting = {task: len(needed) for task, needed in self.graph.after.items()}
        return _State(waiting, tuple(task for task in self.graph.tasks if not waiting[task]), (), None)

    def widened(self, root: _State, width: int, is_late: Callable[[], bool]) -> bool:
        """Go through the levels with the ``width`` most promising states of each; whether no other state was
        left out that could have led to a shorter schedule."""
        whole = True
        states, done = [root], 0
        while states:
            done += 1
            successors: dict[frozenset[TaskId], tuple[tuple[int, int], _State]] = {}
            for state in states:
                branches = self._branches(state.ready)
                for taken in itertools.islice(branches, 4 * width):
                    after = self._after(state, taken)
                    if not after.ready:
                        if self.best is None or done < len(self.best):
                            self.best = after.path()
                        continue
                    # What is left decides all that follows.
                    left = frozenset(task for task, count in after.waiting.items() if count >= 0)
                    if left in successors:
                        continue
                    bound = done + self.left(after)
                    if self.best is None or bound < len(self.best):
                        successors[left] = ((bound, sum(self.tail[task] for task in left)), after)
                whole = whole and next(branches, None) is None
                if is_late():
                    return False
            ranked = sorted(successors.values(), key=lambda one: one[0])
            whole = whole and len(ranked) <= width
            states = [state for _, state in ranked[:width]]
        return whole

    def _after(self, state: _State, taken: tuple[TaskId, ...]) -> _State:
        waiting = dict(state.waiting)
        ready = [task for task in state.ready if task not in taken]
        for task in taken:
            waiting[task] = -1  # done
            for follower in self.later[task]:
                waiting[follower] -= 1
                if not waiting[follower]:
                    ready.append(follower)
        return _State(waiting, tuple(ready), taken, state)

    def _branches(self, ready: Sequence[TaskId]) -> Iterator[tuple[TaskId, ...]]:
        """What may be done in the next level, best first: for each processor one of its ready tasks. A
        processor that has a ready task never idles: no schedule of unit tasks gets longer by that."""
        groups: dict[int, list[TaskId]] = {}
        for task in sorted(ready, key=lambda task: (-self.tail[task], -len(self.later[task]), task)):
            groups.setdefault(self.owner[task], []).append(task)
        return itertools.product(*groups.values())

    def left(self, state: _State) -> int:
        """Levels that are still needed at least, every task that is ready being able to begin now."""
        heads: dict[TaskId, int] = dict.fromkeys(state.ready, 0)
        queue, need = list(state.ready), dict(state.waiting)
        jobs: list[list[tuple[int, int]]] = [[] for _ in range(self.joints)]
        for task in queue:  # grows while it is read: in an order of evaluation
            jobs[self.owner[task]].append((heads[task], self.tail[task] - 1))
            for follower in self.later[task]:
                heads[follower] = max(heads.get(follower, 0), heads[task] + 1)
                need[follower] -= 1
                if not need[follower]:
                    queue.append(follower)
        longest = max(self.tail[task] for task in state.ready)
        return max(longest, *(_jackson(tasks) for tasks in jobs if tasks))


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
