"""A schedule of a cut program as lanes: what each processor computes in which order, which values pass
between processors, and where they have to wait for each other.

And a program for one core whose lanes all do the same: a schedule on a machine of as many processors as there
are lanes, on which all processors of a level must do the same kind of operation. List scheduling, the
operation with the longest remaining chain first, and as many of its kind beside it as are ready.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal

from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.schedule.cutting import Cut
from robodyn.schedule.graph import TaskId
from robodyn.schedule.machine import Timetable

Waiting = Literal["barrier", "counters"]


@dataclass(frozen=True, slots=True)
class Step:
    """Operations that a processor computes without a stop: a task (0: before all tasks), its level or time,
    and what it waits for: ``(processor, steps that must be done there)``; ``publishes`` after it, for others.
    """

    task: TaskId
    level: int
    operations: tuple[int, ...]
    waits: tuple[tuple[int, int], ...] = ()
    publishes: bool = False


@dataclass(frozen=True, slots=True)
class Lanes:
    """``steps[k]`` of processor k in their order; ``shared`` operations whose values other processors read;
    ``barriers`` levels before which all processors meet (none where they wait for counters)."""

    steps: tuple[tuple[Step, ...], ...]
    shared: tuple[int, ...]
    barriers: tuple[int, ...]
    processor_of: tuple[int, ...]


def lanes(cut: Cut, timetable: Timetable, waiting: Waiting = "barrier") -> Lanes:
    """Who does what. In levels (``barrier``) processors may be exchanged within a level, so that fewer values
    pass between them; barriers stand only where a value passes.

    Raises
    ------
    InputError: barriers, and a timetable without levels.
    """
    if waiting == "barrier" and not timetable.machine.synchronised:
        raise InputError("without levels there is nowhere to meet", remedy="take --sync counters")
    p = timetable.machine.processors
    by_task = cut.operations()
    if timetable.machine.synchronised:
        place, level = _near(cut, timetable)
    else:
        place = {one.task: one.processor for one in timetable.placements}
        level = {one.task: one.start + 1 for one in timetable.placements}
    before = _spread(cut, by_task[0], p)
    processor_of = tuple(before[i] if task == 0 else place[task] for i, task in enumerate(cut.task_of))
    steps: list[tuple[Step, ...]] = []
    for k in range(p):
        own = tuple(i for i in by_task[0] if before[i] == k)
        todo = sorted((task for task in place if place[task] == k), key=lambda task: (level[task], task))
        lane = [Step(task, level[task], tuple(by_task[task])) for task in todo]
        steps.append((*([Step(0, 0, own)] if own else []), *lane))
    passing = [
        (arg, i)
        for i, operation in enumerate(cut.program.operations)
        for arg in operation.args
        if isinstance(arg, int) and processor_of[arg] != processor_of[i]
    ]
    shared = tuple(sorted({producer for producer, _ in passing}))
    if waiting == "barrier":
        of_level = [0 if task == 0 else level[task] for task in cut.task_of]
        barriers = _barriers([(of_level[producer], of_level[used]) for producer, used in passing])
        return Lanes(tuple(steps), shared, barriers, processor_of)
    return Lanes(_counted(steps, passing, processor_of), shared, (), processor_of)


def _near(cut: Cut, timetable: Timetable) -> tuple[dict[TaskId, int], dict[TaskId, int]]:
    """Processors for the tasks of each level, each near what it reads if it can be."""
    place: dict[TaskId, int] = {}
    level: dict[TaskId, int] = {}
    p = timetable.machine.processors
    for level_index, row in enumerate(timetable.slots, 1):
        tasks = [task for task in row if task is not None]
        wishes = sorted(
            (-sum(place[other] == k for other in cut.graph.after[task]), row.index(task), k, task)
            for task in tasks
            for k in range(p)
        )
        taken: set[int] = set()
        for _, _, k, task in wishes:
            if task not in place and k not in taken:
                place[task], level[task] = k, level_index
                taken.add(k)
    return place, level


def _spread(cut: Cut, operations: Sequence[int], p: int) -> dict[int, int]:
    """Processors for what is done before all tasks: what hangs together stays together."""
    root: dict[int, int] = {}

    def top(i: int) -> int:
        while root[i] != i:
            i = root[i]
        return i

    for i in operations:
        root[i] = i
        for arg in cut.program.operations[i].args:
            if isinstance(arg, int):
                root[top(arg)] = i
    load = [0] * p
    chosen: dict[int, int] = {}
    for i in operations:
        if top(i) not in chosen:
            chosen[top(i)] = load.index(min(load))
        load[chosen[top(i)]] += 1
    return {i: chosen[top(i)] for i in operations}


def _barriers(needs: Sequence[tuple[int, int]]) -> tuple[int, ...]:
    """Levels before which to meet, as few as there can be, so that each pair (made in, used in) has one
    between: in the order of use, as late as can be."""
    barriers: list[int] = []
    for produced, used in sorted(needs, key=lambda pair: pair[1]):
        if not barriers or barriers[-1] <= produced:
            barriers.append(used)
    return tuple(barriers)


def _counted(
    lanes: Sequence[Sequence[Step]], passing: Sequence[tuple[int, int]], processor_of: Sequence[int]
) -> tuple[tuple[Step, ...], ...]:
    """Steps that wait for the counters of others, each of which tells how many steps are done there; waits
    that an earlier one of the same processor has made needless are left out."""
    order = {i: k for lane in lanes for k, step in enumerate(lane, 1) for i in step.operations}
    needed: dict[tuple[int, int], dict[int, int]] = {}
    for producer, used in passing:
        here = needed.setdefault((processor_of[used], order[used]), {})
        here[processor_of[producer]] = max(here.get(processor_of[producer], 0), order[producer])
    waits: dict[tuple[int, int], tuple[tuple[int, int], ...]] = {}
    for k, lane in enumerate(lanes):
        seen: dict[int, int] = {}
        for number in range(1, len(lane) + 1):
            others = sorted(needed.get((k, number), {}).items())
            waits[k, number] = tuple((j, s) for j, s in others if s > seen.get(j, 0))
            seen.update(waits[k, number])
    published = {wait for new in waits.values() for wait in new}
    return tuple(
        tuple(
            replace(step, waits=waits[k, number], publishes=(k, number) in published)
            for number, step in enumerate(lane, 1)
        )
        for k, lane in enumerate(lanes)
    )


#: Kinds that there are vector operations for, with the same rounding as one by one.
VECTOR: Final = frozenset(("add", "sub", "mul", "div"))
LANES: Final = (2, 4, 8)


@dataclass(frozen=True, slots=True)
class Packing:
    """``groups`` of operations of one kind, in an order in which each uses only what stands before."""

    program: Program
    lanes: int
    groups: tuple[tuple[int, ...], ...]

    @property
    def vectors(self) -> int:
        """Groups that are one vector operation."""
        return sum(len(group) > 1 for group in self.groups)

    @property
    def filling(self) -> float:
        """The share of lanes that vector operations fill."""
        packed = [len(group) for group in self.groups if len(group) > 1]
        return sum(packed) / (self.lanes * len(packed)) if packed else 0.0


def pack(program: Program, lanes: int = 4) -> Packing:
    """``program`` in groups of at most ``lanes`` operations.

    Raises
    ------
    InputError: vectors have 2, 4 or 8 lanes.
    """
    if lanes not in LANES:
        raise InputError("vectors have 2, 4 or 8 lanes", found=f"{lanes}")
    operations = program.operations
    needs = [{arg for arg in operation.args if isinstance(arg, int)} for operation in operations]
    later: list[list[int]] = [[] for _ in operations]
    for i, needed in enumerate(needs):
        for other in needed:
            later[other].append(i)
    tail = [1] * len(operations)
    for i in reversed(range(len(operations))):
        tail[i] = 1 + max((tail[j] for j in later[i]), default=0)
    waiting = [len(needed) for needed in needs]
    ready = [i for i, count in enumerate(waiting) if not count]
    groups: list[tuple[int, ...]] = []
    while ready:
        ready.sort(key=lambda i: (-tail[i], i))
        kind = operations[ready[0]].op
        most = lanes if kind in VECTOR else 1
        group = [i for i in ready if operations[i].op == kind][:most]
        groups.append(tuple(sorted(group)))
        ready = [i for i in ready if i not in group]
        for i in group:
            for follower in later[i]:
                waiting[follower] -= 1
                if not waiting[follower]:
                    ready.append(follower)
    return Packing(program, lanes, tuple(groups))
