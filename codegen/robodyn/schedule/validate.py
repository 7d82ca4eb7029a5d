"""Whether a schedule may be carried out: written apart from all that makes schedules.

It knows tasks, what each needs, and rows of what is done together; it asks no scheduler and shares no code
with one. Printed tables are read by it as they stand.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from typing import Any, Literal, NamedTuple

Kind = Literal["missing", "unknown", "twice", "precedence", "crowded", "early", "overlap", "levels", "length"]


class Fault(NamedTuple):
    """What is wrong: the ``task``, the ``level`` (from 1; a time where there are no levels), and for
    ``precedence`` the ``other`` task that it needs."""

    kind: Kind
    task: int
    level: int
    other: int | None = None

    def __str__(self) -> str:
        if self.kind == "precedence":
            return f"{self.task} in level {self.level} needs {self.other}, which is not done before"
        if self.kind == "early":
            return f"{self.task} at {self.level} needs a value of {self.other} that is not there yet"
        words = {
            "missing": f"{self.task} is missing",
            "unknown": f"{self.task} in level {self.level} is not in the graph",
            "twice": f"{self.task} is done again in level {self.level}",
            "crowded": f"{self.task} in level {self.level} has no processor",
            "overlap": f"{self.task} at {self.level} runs beside {self.other} on one processor",
            "levels": f"{self.task} in level {self.level} does not begin with its level",
            "length": f"{self.task} at {self.level} does not take its time",
        }
        return words[self.kind]


def faults_of_levels(
    after: Mapping[int, Collection[int]], processors: int, levels: Sequence[Sequence[int | None]]
) -> list[Fault]:
    """What is wrong with ``levels`` of tasks for a graph in which ``after[task]`` must be done before.

    A task done twice is judged where it is done first. What needs a task that is missing is not blamed.
    """
    faults: list[Fault] = []
    first: dict[int, int] = {}
    for k, level in enumerate(levels, 1):
        doing = [task for task in level if task is not None]
        faults += [Fault("crowded", task, k) for task in doing[processors:]]
        for task in doing:
            if task in first:
                faults.append(Fault("twice", task, k))
            else:
                first[task] = k
                if task not in after:
                    faults.append(Fault("unknown", task, k))
    for task, needed in after.items():
        if task not in first:
            faults.append(Fault("missing", task, 0))
            continue
        late = sorted(other for other in needed if other in first and first[other] >= first[task])
        faults += [Fault("precedence", task, first[task], other) for other in late]
    return faults


def faults_of_times(
    after: Mapping[int, Collection[int]],
    lengths: Mapping[int, int],
    processors: int,
    communication: int,
    placements: Sequence[Any],
    *,
    levels: Sequence[Sequence[int | None]] | None = None,
) -> list[Fault]:
    """What is wrong with ``placements`` (task, processor, start, finish); lengths are 1 where none is given.

    With ``levels`` (of a synchronised machine) they too are judged, and each task must begin when all of the
    level before have ended and met, ``communication`` later.
    """
    faults: list[Fault] = []
    when: dict[int, tuple[int, int, int]] = {}
    for task, processor, start, finish in placements:
        if task not in after:
            faults.append(Fault("unknown", task, start))
        if task in when:
            faults.append(Fault("twice", task, start))
            continue
        when[task] = (processor, start, finish)
        if finish - start != lengths.get(task, 1):
            faults.append(Fault("length", task, start))
        if not 0 <= processor < processors or start < 0:
            faults.append(Fault("crowded", task, start))
    faults += [Fault("missing", task, 0) for task in after if task not in when]
    for task, (processor, start, _) in when.items():
        for other in sorted(after.get(task, ())):
            if other not in when:
                continue
            there, _, done = when[other]
            wait = communication if levels is None and there != processor else 0
            if start < done + wait:
                faults.append(Fault("early", task, start, other))
    busy: dict[int, tuple[int, int]] = {}
    for task, (processor, start, finish) in sorted(when.items(), key=lambda one: one[1][1:]):
        if processor in busy and busy[processor][1] > start:
            faults.append(Fault("overlap", task, start, busy[processor][0]))
        busy[processor] = (task, finish)
    if levels is not None:
        faults += faults_of_levels(after, processors, levels)
        faults += _uneven(levels, when, communication)
    return faults


def _uneven(
    levels: Sequence[Sequence[int | None]], when: Mapping[int, tuple[int, int, int]], communication: int
) -> list[Fault]:
    faults: list[Fault] = []
    begin = 0
    for k, level in enumerate(levels, 1):
        doing = [task for task in level if task is not None and task in when]
        faults += [Fault("levels", task, k) for task in doing if when[task][1] != begin]
        begin = max((when[task][2] for task in doing), default=begin + 1) + communication
    return faults


def summary(faults: Sequence[Fault]) -> dict[str, int]:
    """How many faults of each kind, kinds without any left out."""
    return dict(Counter(fault.kind for fault in faults))
