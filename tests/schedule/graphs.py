"""Graphs of random tasks, and what their schedules are compared with."""

from __future__ import annotations

import itertools
import random

from robodyn.schedule import TaskGraph


def some_graph(seed: int, tasks: int = 24, longest: int = 1) -> TaskGraph:
    """A graph of tasks, each of which may need any that stand before it."""
    rng = random.Random(seed)
    after = {
        t: frozenset(other for other in range(1, t) if rng.random() < 2.2 / tasks)
        for t in range(1, tasks + 1)
    }
    return TaskGraph(
        after,
        dict.fromkeys(after, 1),
        {t: rng.randint(1, longest) for t in after} if longest > 1 else {},
        {t: 1 + t % 3 for t in after},
    )


def shortest(graph: TaskGraph, p: int) -> int:
    """The length of a shortest schedule on ``p`` processors without communication: among all orders of the
    tasks, each begun as soon as it can be, there is one."""
    least = graph.work
    for order in itertools.permutations(graph.tasks):
        free, done = [0] * p, dict[int, int]()
        for task in order:
            if not graph.after[task] <= done.keys():
                break
            k = free.index(min(free))
            start = max([free[k], *(done[other] for other in graph.after[task])])
            free[k] = done[task] = start + graph.length(task)
        else:
            least = min(least, max(free))
    return least
