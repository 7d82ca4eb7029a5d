"""What no schedule can beat.

Source: Fernandez and Bussell 1973: between any two times so much of every task must be done, however late or
early it is put, that processors are lacking where the density is greatest. Of tasks of equal length these
are the window bounds.
"""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.schedule.graph import TaskGraph


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
    """For every width of window ``(width, work)``: the most work that falls into any such window whatever
    the schedule, all being done within ``span``."""
    early, late = graph.earliest(), graph.remaining()
    # [start as early as can be, end as late as can be, length]
    tasks = [
        (early[t] - graph.length(t), span - late[t] + graph.length(t), graph.length(t)) for t in graph.tasks
    ]
    best = [0] * (span + 1)
    for begin in range(span):
        ends = _work_after(tasks, begin, span)
        for end in range(begin + 1, span + 1):
            best[end - begin] = max(best[end - begin], ends[end])
    return [(width, work) for width, work in enumerate(best) if width]


def _work_after(tasks: Sequence[tuple[int, int, int]], begin: int, span: int) -> list[int]:
    """``[end]``: work that cannot leave the window from ``begin`` to ``end``.

    A task done as early as can be has ``x`` units of it after ``begin``; as late as can be, none of it
    before ``last``, whence on one unit more with every unit of ``end``, at most as many as there are and as
    the window is wide: min(x, end - last, end - begin).
    """
    slope = [0] * (span + 2)
    for first, deadline, length in tasks:
        after = min(length, first + length - begin)
        if after > 0:
            start = max(begin, deadline - length)
            slope[start + 1] += 1
            slope[min(span + 1, start + after + 1)] -= 1
    found, rate, total = [0] * (span + 1), 0, 0
    for end in range(span + 1):
        rate += slope[end]
        total += rate
        found[end] = total
    return found
