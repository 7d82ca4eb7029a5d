"""Machines, and what is done when and where on them.

A machine is ``p`` equal processors. *Synchronised*, it works in levels: in every level each processor does
one task, and all of them meet before the next; a level lasts as long as its longest task, and meeting costs
``communication``. Not synchronised, a task begins as soon as its values are there and its processor is free;
a value that another processor has made comes ``communication`` later. Sending occupies no processor.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

from robodyn.errors import InputError
from robodyn.schedule.graph import TaskGraph, TaskId

#: More is refused: a sweep over processors, a table with a column for each.
MOST_PROCESSORS = 1024

#: The longest that passing a value may take: a solver's numbers have an end.
LONGEST = 10**9


@dataclass(frozen=True, slots=True)
class Machine:
    """``processors`` equal processors; times in the unit of the tasks' lengths.

    Raises
    ------
    InputError: fewer than one processor, more than can be meant, or a negative time.
    """

    processors: int
    communication: int = 0
    synchronised: bool = True

    def __post_init__(self) -> None:
        if not 1 <= self.processors <= MOST_PROCESSORS:
            raise InputError(
                "a schedule needs a processor" if self.processors < 1 else "so many processors are not meant",
                found=f"{self.processors}",
                expected=f"1 to {MOST_PROCESSORS}",
            )
        if not 0 <= self.communication <= LONGEST:
            early = self.communication < 0
            raise InputError(
                "a value cannot come before it is sent" if early else "a value does not take so long",
                found=f"{self.communication}",
                expected=f"0 to {LONGEST}",
            )


class Placement(NamedTuple):
    """A task on a processor (from 0), from ``start`` to ``finish``."""

    task: TaskId
    processor: int
    start: int
    finish: int


@dataclass(frozen=True, slots=True)
class Schedule:
    """What is done in each level: a task a processor, None where it idles (processors at the end that idle
    may be left out)."""

    processors: int
    slots: tuple[tuple[TaskId | None, ...], ...]

    @property
    def levels(self) -> int:
        """Levels, each as long as its longest task."""
        return len(self.slots)

    @property
    def speedup(self) -> float:
        """Tasks a level, which, of tasks of equal length, is one processor's time to this one's."""
        done = sum(task is not None for slot in self.slots for task in slot)
        return done / self.levels if self.slots else 1.0

    @property
    def efficiency(self) -> float:
        """Speed-up a processor: the share of slots that hold a task."""
        return self.speedup / self.processors


@dataclass(frozen=True, slots=True)
class Timetable:
    """Every task with its processor and its time; ``span`` is when all is done.

    ``slots``: of a synchronised machine its levels, else what each processor does at each of ``times``, which
    are those at which a task begins.
    """

    machine: Machine
    placements: tuple[Placement, ...]
    span: int
    slots: tuple[tuple[TaskId | None, ...], ...]
    times: tuple[int, ...]

    @property
    def levels(self) -> int:
        """Levels, or units of time where there are none."""
        return len(self.slots) if self.machine.synchronised else self.span

    def speedup(self, work: int) -> float:
        """One processor's time for ``work`` to this one's."""
        return work / self.span if self.span else 1.0

    def lanes(self) -> list[list[Placement]]:
        """The placements of each processor by time."""
        lanes: list[list[Placement]] = [[] for _ in range(self.machine.processors)]
        for placement in sorted(self.placements, key=lambda one: one.start):
            lanes[placement.processor].append(placement)
        return lanes


def in_levels(graph: TaskGraph, machine: Machine, schedule: Schedule) -> Timetable:
    """The times of a ``schedule`` in levels: everything of a level begins together."""
    placements: list[Placement] = []
    now = 0
    rows: list[tuple[TaskId | None, ...]] = []
    times: list[int] = []
    for k, slot in enumerate(schedule.slots):
        if k:
            now += machine.communication
        doing = [(place, task) for place, task in enumerate(slot) if task is not None]
        times.append(now)
        placements += [Placement(task, place, now, now + graph.length(task)) for place, task in doing]
        now += max((graph.length(task) for _, task in doing), default=1)
        rows.append((*slot, *(None,) * (machine.processors - len(slot))))
    return Timetable(machine, tuple(placements), now, tuple(rows), tuple(times))


def in_time(machine: Machine, placements: Iterable[Placement]) -> Timetable:
    """A timetable without levels; of a machine with them see :func:`in_levels`."""
    ordered = tuple(sorted(placements, key=lambda one: (one.start, one.processor)))
    span = max((one.finish for one in ordered), default=0)
    times = sorted({one.start for one in ordered})
    rows: list[list[TaskId | None]] = [[None] * machine.processors for _ in times]
    for one in ordered:
        for k in range(bisect_left(times, one.start), bisect_left(times, one.finish)):
            rows[k][one.processor] = one.task
    return Timetable(machine, ordered, span, tuple(map(tuple, rows)), tuple(times))
