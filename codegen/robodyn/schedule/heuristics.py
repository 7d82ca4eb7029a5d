"""List scheduling: in every level, as many ready tasks as there are processors, by an order of preference.

Source of the thesis's order: Dhanaraj 1990, section 4.3.3. Critical path first is the highest-level-first
rule of Hu 1961, which for tasks of equal length Kasahara and Narita 1985 start from.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from robodyn.errors import InputError
from robodyn.schedule.graph import TaskGraph, TaskId, link_and_number

#: The smaller, the sooner a ready task is taken.
Preference = Callable[[TaskId], tuple[int, ...]]


@dataclass(frozen=True, slots=True)
class Schedule:
    """What is done in each level, on at most ``processors`` processors."""

    processors: int
    slots: tuple[tuple[TaskId, ...], ...]

    @property
    def levels(self) -> int:
        """Levels, each as long as one task."""
        return len(self.slots)

    @property
    def speedup(self) -> float:
        """Tasks a level, which is what one processor's time is to this one's."""
        return sum(map(len, self.slots)) / self.levels if self.slots else 1.0

    @property
    def efficiency(self) -> float:
        """Speed-up a processor: the share of slots that hold a task."""
        return self.speedup / self.processors


def thesis_order(graph: TaskGraph) -> Preference:
    """Layer, link, task number: the order of section 4.3.3."""
    return lambda task: (graph.layer[task], *link_and_number(task))


def critical_path_order(graph: TaskGraph) -> Preference:
    """The longest remaining chain first; among equals the thesis's order."""
    tails, otherwise = graph.tails(), thesis_order(graph)
    return lambda task: (-tails[task], *otherwise(task))


def list_schedule(graph: TaskGraph, processors: int, preference: Preference | None = None) -> Schedule:
    """The schedule that takes, level by level, the first ``processors`` ready tasks by ``preference`` (the
    thesis's order if None).

    Raises
    ------
    InputError: fewer than one processor.
    """
    if processors < 1:
        raise InputError("a schedule needs a processor", found=f"{processors}", expected="1 or more")
    preferred = preference or thesis_order(graph)
    waiting = {task: len(needed) for task, needed in graph.after.items()}
    later = graph.before()
    ready = sorted((task for task, count in waiting.items() if not count), key=preferred)
    slots: list[tuple[TaskId, ...]] = []
    while ready:
        taken, ready = ready[:processors], ready[processors:]
        slots.append(tuple(taken))
        for task in taken:
            for follower in later[task]:
                waiting[follower] -= 1
                if not waiting[follower]:
                    ready.append(follower)
        ready.sort(key=preferred)
    return Schedule(processors, tuple(slots))
