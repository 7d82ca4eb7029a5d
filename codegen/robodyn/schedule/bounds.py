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
