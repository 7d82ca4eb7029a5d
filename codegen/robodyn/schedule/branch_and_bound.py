"""One processor a joint: which of its tasks each does in every level, by branch and bound.

Source: Luh and Lin 1982, who give every joint of an arm its own processor and search for the shortest order
with a variable branch and bound. Levels here, as in the thesis: tasks of equal length. Branches are ordered
by the longest remaining chain; a branch is left where its bound, the longest chain or the busiest
processor's own (Jackson's, heads and tails kept), is no shorter than the best schedule known. The search is
variable in that it goes through the levels with ever more states of each, twice as many every time.
"""

from __future__ import annotations

import heapq
import itertools
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from robodyn.schedule.graph import TaskGraph, TaskId
from robodyn.schedule.machine import Schedule


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
