"""Graphs of tasks: what must be done before what, the longest chain, the layers.

The arm's graph is made from the 43 tasks a link of Table 4.1: task T of link i is ``100 i + T``. A task that
an arm does not need is taken out, and what waited for it waits for what it waited for. What no schedule can
beat stands here too. Source: Fernandez and Bussell 1973: between any two times so much of every task must be
done, however late or early it is put, that processors are lacking where the density is greatest. Of tasks of
equal length these are the window bounds.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field
from graphlib import TopologicalSorter
from typing import Final

from robodyn.errors import InputError
from robodyn.schedule.tasks import TASKS, Task

#: ``100 link + number`` for tasks of Table 4.1.
TaskId = int

_ID = 100


def task_id(link: int, task_number: int) -> TaskId:
    """The task ``task_number`` of Table 4.1 at ``link`` (both from 1)."""
    return _ID * link + task_number


def link_and_number(task: TaskId) -> tuple[int, int]:
    """The reverse of :func:`task_id`."""
    return divmod(task, _ID)


@dataclass(frozen=True, slots=True)
class TaskGraph:
    """Tasks and what each of them waits for.

    ``after[task]``: the tasks that must be done before it, all of them in the graph. ``layer[task]``: its
    place in the layered graph that the tasks were cut from (a preference, not a constraint). The order of
    ``after`` is that of the tasks. ``lengths[task]``: how long it takes, 1 where nothing is said;
    ``links[task]``: the link (from 1) that it belongs to, that of its number where nothing is said.
    """

    after: Mapping[TaskId, frozenset[TaskId]]
    layer: Mapping[TaskId, int]
    lengths: Mapping[TaskId, int] = field(default_factory=dict)
    links: Mapping[TaskId, int] = field(default_factory=dict)

    @property
    def tasks(self) -> tuple[TaskId, ...]:
        """All tasks."""
        return tuple(self.after)

    def __len__(self) -> int:
        return len(self.after)

    def length(self, task: TaskId) -> int:
        """How long ``task`` takes, in units of time."""
        return self.lengths.get(task, 1)

    def link(self, task: TaskId) -> int:
        """The link that ``task`` belongs to, from 1."""
        return self.links.get(task, link_and_number(task)[0])

    @property
    def work(self) -> int:
        """How long all tasks take one after another."""
        return sum(map(self.length, self.after))

    @property
    def uniform(self) -> bool:
        """Whether all tasks take one unit of time."""
        return all(length == 1 for length in self.lengths.values())

    def before(self) -> dict[TaskId, frozenset[TaskId]]:
        """``before()[task]``: the tasks that wait for it."""
        waiting: dict[TaskId, set[TaskId]] = {task: set() for task in self.after}
        for task, needed in self.after.items():
            for earlier in needed:
                waiting[earlier].add(task)
        return {task: frozenset(later) for task, later in waiting.items()}

    def levels(self) -> dict[TaskId, int]:
        """The earliest level (from 1) of each task, processors being plenty."""
        return _depths(self.after)

    def earliest(self) -> dict[TaskId, int]:
        """The earliest time at which each task can be done, processors being plenty."""
        return _depths(self.after, self.length)

    def remaining(self) -> dict[TaskId, int]:
        """Time on the longest chain from each task on, itself included."""
        return _depths(self.before(), self.length)

    @property
    def critical_path(self) -> int:
        """Tasks on the longest chain: no schedule has fewer levels."""
        return max(self.levels().values(), default=0)

    @property
    def critical_time(self) -> int:
        """Time on the longest chain: no schedule is shorter."""
        return max(self.earliest().values(), default=0)

    def layers(self) -> list[tuple[TaskId, ...]]:
        """The layered graph: tasks by layer, in order; layers may be empty."""
        layers: list[list[TaskId]] = [[] for _ in range(max(self.layer.values(), default=0))]
        for task in self.after:
            layers[self.layer[task] - 1].append(task)
        return [tuple(layer) for layer in layers]

    def width(self) -> int:
        """Tasks of the widest layer: the processors that the layered graph asks for."""
        return max(map(len, self.layers()), default=0)


def _depths(
    needed: Mapping[TaskId, Collection[TaskId]], length: Callable[[TaskId], int] = lambda _: 1
) -> dict[TaskId, int]:
    depth: dict[TaskId, int] = {}
    for task in TopologicalSorter(needed).static_order():
        depth[task] = length(task) + max((depth[earlier] for earlier in needed[task]), default=0)
    return depth


#: Sums of Table 4.1 (T15 to T17, T23 to T25) and the products that each adds up; the table has each wait for
#: those of the other components too.
OWN_PRODUCT: Final = {15: 12, 16: 13, 17: 14, 23: 20, 24: 21, 25: 22}


def arm_graph(
    n: int,
    without: Collection[TaskId] = (),
    prismatic: Collection[int] = (),
    *,
    own_products: bool = False,
    besides: Mapping[int, Sequence[Task]] | None = None,
) -> TaskGraph:
    """The graph of an arm of ``n`` joints, tasks ``without`` taken out; ``besides``: tasks of a link (from 1)
    that Table 4.1 does not have, friction for instance.

    ``own_products``: a component's sum waits for the products of its own component only, which is all that
    it reads.

    The lambda of a link behind a ``prismatic`` joint (numbered from 1) is that of the link before: tasks 9 to
    11, where taken out, wait for the same tasks there.

    Raises
    ------
    InputError: no joints, or more than can be numbered in ids.
    """
    if n < 1:
        raise InputError("an arm without joints has no tasks", found=f"{n} joints", expected="1 or more")
    out, more = frozenset(without), besides or {}
    layers: dict[TaskId, int] = {}
    waits: dict[TaskId, set[TaskId]] = {}
    for link in range(1, n + 1):
        for task in (*TASKS, *more.get(link, ())):
            predecessors = {
                task_id(link + place, task_number)
                for place, task_number in task.after
                if 1 <= link + place <= n
            }
            if own_products and task.row in OWN_PRODUCT:
                other = set(OWN_PRODUCT.values()) - {OWN_PRODUCT[task.row]}
                predecessors -= {task_id(link, task_number) for task_number in other}
            if link in prismatic and task.row in (9, 10, 11) and task_id(link, task.row) in out:
                predecessors = {task_id(link - 1, task.row)} if link > 1 else set()
            waits[task_id(link, task.row)] = predecessors
            layers[task_id(link, task.row)] = _stacked(n, link, task)
    for one in TopologicalSorter(waits).static_order():  # earlier ones first: theirs is settled when read
        earlier = waits[one]
        waits[one] = (earlier - out).union(*(waits[gone] for gone in earlier & out))
    kept = [one for one in waits if one not in out]
    return TaskGraph({one: frozenset(waits[one]) for one in kept}, {one: layers[one] for one in kept})


def stacked_layer(n: int, task: TaskId) -> int:
    """The layer of a task of Table 4.1 in the thesis's layered graph (section 4.3): a link begins two layers
    after the one before it, link 1 beside link 2, the backward pass after the forward one; 4 n + 3 layers."""
    link, task_number = link_and_number(task)
    return _stacked(n, link, TASKS[task_number - 1])


def _stacked(n: int, link: int, own: Task) -> int:
    if not own.forward:
        return 2 * n + 2 + own.layer + 2 * (n - link)
    return max(1, own.layer + 2 * (link - 2)) if link > 1 else max(1, own.layer - 4)


def lower_bound(graph: TaskGraph, processors: int) -> int:
    """Units of time (levels, of tasks of equal length) that every schedule on ``processors`` takes."""
    span = graph.critical_time
    if not span:
        return 0
    extra = 0
    for width, forced in _densest(graph, span):
        extra = max(extra, -(-forced // processors) - width)
    return max(span + extra, -(-graph.work // processors))


def fewest_processors(graph: TaskGraph, span: int) -> int:
    """Processors that any schedule needs that is done within ``span``, ``graph.critical_time`` or more."""
    return max((-(-forced // width) for width, forced in _densest(graph, span)), default=1)


def _densest(graph: TaskGraph, span: int) -> list[tuple[int, int]]:
    """For widths of windows ``(width, work)``: the most work that falls into such a window whatever the
    schedule, all being done within ``span``.

    Windows begin where a task may begin or end at the earliest or must begin at the latest: between these
    times nothing new can be the densest of its kind.
    """
    early, late = graph.earliest(), graph.remaining()
    # (begin as early as can be, begin as late as can be, length)
    tasks = [(early[t] - graph.length(t), span - late[t], graph.length(t)) for t in graph.tasks]
    begins = {time for first, last, length in tasks for time in (first, first + length, last)}
    best: dict[int, int] = {}
    for begin in sorted(begins):
        for end, work in _work_after(tasks, begin):
            width = end - begin
            if work > best.get(width, 0):
                best[width] = work
    return sorted(best.items())


def _work_after(tasks: Sequence[tuple[int, int, int]], begin: int) -> list[tuple[int, int]]:
    """``(end, work)``: work that cannot leave the window from ``begin`` to ``end``, at the ends where its
    growth changes.

    A task done as early as can be has so many units of it after ``begin``; done as late as can be, none
    before its last start. Whence one unit more with every unit of ``end``, from the later of ``begin`` and
    the last start on, at most as many as there are.
    """
    slope: dict[int, int] = {}
    for first, last, length in tasks:
        after = min(length, first + length - begin)
        if after > 0:
            start = last if last > begin else begin
            slope[start] = slope.get(start, 0) + 1
            slope[start + after] = slope.get(start + after, 0) - 1
    work: list[tuple[int, int]] = []
    rate = total = now = 0
    for end in sorted(slope):
        total += rate * (end - now)
        if end > begin:
            work.append((end, total))
        rate += slope[end]
        now = end
    return work
