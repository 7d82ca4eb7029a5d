"""List scheduling: again and again the ready task that an order of preference puts first.

Sources: the thesis's order, Dhanaraj 1990, section 4.3.3. Critical path, most immediate successors first
(CP/MISF): Kasahara and Narita 1985, from the highest-level-first rule of Hu 1961. Dynamic highest level
first (DHLF/MISF): Chen, Lee and Hou 1988, whose paper is not at hand; of it are taken that levels and
numbers of successors are judged anew at every choice. On a machine without levels that is the level less the
time at which the task could begin there, as Sih and Lee 1993 have it; in levels, where all begin together,
the successors that a task would set free now.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from functools import partial
from typing import NamedTuple

from robodyn.errors import InputError
from robodyn.schedule.graph import TaskGraph, TaskId
from robodyn.schedule.machine import Machine, Placement, Schedule, Timetable, in_levels, in_time

#: The smaller, the sooner a ready task is taken.
Preference = Callable[[TaskId], tuple[int, ...]]


def thesis_order(graph: TaskGraph) -> Preference:
    """Layer, link, task number: the order of section 4.3.3."""
    return lambda task: (graph.layer[task], task)


def critical_path_order(graph: TaskGraph) -> Preference:
    """The longest remaining chain first, then most immediate successors; among equals the thesis's order."""
    remaining, later, otherwise = graph.remaining(), graph.before(), thesis_order(graph)
    return lambda task: (-remaining[task], -len(later[task]), *otherwise(task))


def list_schedule(graph: TaskGraph, processors: int, preference: Preference | None = None) -> Schedule:
    """The schedule that takes, level by level, the first ``processors`` ready tasks by ``preference`` (the
    thesis's order if None).

    Raises
    ------
    InputError: fewer than one processor.
    """
    preferred = preference or thesis_order(graph)
    return _in_levels(graph, processors, lambda ready, _: sorted(ready, key=preferred)[:processors])


def dynamic_schedule(graph: TaskGraph, processors: int) -> Schedule:
    """As :func:`list_schedule`, the longest remaining chain first, then most successors that nothing else
    holds up any more: judged anew after every task that is taken."""
    remaining, later, otherwise = graph.remaining(), graph.before(), thesis_order(graph)

    def judged(task: TaskId, done: set[TaskId]) -> tuple[int, ...]:
        freed = sum(graph.after[follower] - done == {task} for follower in later[task])
        return (-remaining[task], -freed, -len(later[task]), *otherwise(task))

    def chosen(ready: list[TaskId], done: set[TaskId]) -> list[TaskId]:
        taken: list[TaskId] = []
        while len(taken) < min(processors, len(ready)):
            judge = partial(judged, done=done.union(taken))
            taken.append(min(set(ready).difference(taken), key=judge))
        return taken

    return _in_levels(graph, processors, chosen)


def _in_levels(
    graph: TaskGraph, processors: int, choose: Callable[[list[TaskId], set[TaskId]], list[TaskId]]
) -> Schedule:
    if processors < 1:
        raise InputError("a schedule needs a processor", found=f"{processors}", expected="1 or more")
    waiting = {task: len(needed) for task, needed in graph.after.items()}
    later = graph.before()
    ready = [task for task, count in waiting.items() if not count]
    done: set[TaskId] = set()
    slots: list[tuple[TaskId | None, ...]] = []
    while ready:
        taken = choose(ready, done)
        slots.append(tuple(taken))
        gone = set(taken)
        ready = [task for task in ready if task not in gone]
        done |= gone
        for task in taken:
            for follower in later[task]:
                waiting[follower] -= 1
                if not waiting[follower]:
                    ready.append(follower)
    return Schedule(processors, tuple(slots))


def list_times(
    graph: TaskGraph, machine: Machine, preference: Preference, *, levels_count: bool = False
) -> Timetable:
    """List scheduling without levels: of all ready tasks and processors the pair that can begin first, among
    equals by ``preference``; with ``levels_count`` the pair of the highest dynamic level, which is the
    longest remaining chain less the time at which it can begin."""
    remaining = graph.remaining()
    waiting = {task: len(needed) for task, needed in graph.after.items()}
    later = graph.before()
    free = [0] * machine.processors
    done: dict[TaskId, Placement] = {}
    arrival: dict[TaskId, _Arrival] = {task: _Arrival(0, {}) for task, count in waiting.items() if not count}
    rank = {task: preference(task) for task in graph.tasks}
    while arrival:
        idle = free.index(min(free))
        best: tuple[tuple[int, ...], TaskId, int, int] | None = None
        for task, values in arrival.items():
            # Where none of its values was made one processor is like another: only the first that is free.
            for place in {idle, *values.sooner}:
                start = max(values.sooner.get(place, values.anywhere), free[place])
                first = start - remaining[task] if levels_count else start
                key = (first, *rank[task], start, place)
                if best is None or key < best[0]:
                    best = (key, task, place, start)
        assert best is not None
        _, task, place, start = best
        del arrival[task]
        placed = Placement(task, place, start, start + graph.length(task))
        done[task] = placed
        free[place] = placed.finish
        for follower in later[task]:
            waiting[follower] -= 1
            if not waiting[follower]:
                placements = [done[needed] for needed in graph.after[follower]]
                arrival[follower] = _arrival(machine.communication, placements)
    return in_time(machine, done.values())


def planned(
    graph: TaskGraph, machine: Machine, preference: Preference, *, dynamic: bool = False
) -> Timetable:
    """The list schedule on ``machine``, by ``preference``; if ``dynamic``, judged anew at every choice."""
    if not machine.synchronised:
        return list_times(graph, machine, preference, levels_count=dynamic)
    if dynamic:
        return in_levels(graph, machine, dynamic_schedule(graph, machine.processors))
    return in_levels(graph, machine, list_schedule(graph, machine.processors, preference))


class _Arrival(NamedTuple):
    """When all values that a task needs are at a processor; ``sooner`` at those that made some of them."""

    anywhere: int
    sooner: dict[int, int]


def _arrival(communication: int, placements: Collection[Placement]) -> _Arrival:
    anywhere = max(one.finish for one in placements) + communication
    sooner = {
        place: max(one.finish + (communication if one.processor != place else 0) for one in placements)
        for place in {one.processor for one in placements}
    }
    return _Arrival(anywhere, sooner if communication else {})
