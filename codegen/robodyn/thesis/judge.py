"""The printed schedules, and what the validator finds in them against the tasks of the rules and what each
task reads; and the tasks of the others in Table 4.8."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Final, Literal

from robodyn.errors import InputError
from robodyn.schedule.elimination import eliminated
from robodyn.schedule.graph import TaskGraph, TaskId, arm_graph, link_and_number, task_id
from robodyn.schedule.tasks import TASKS
from robodyn.schedule.validate import Fault, faults_of_levels
from robodyn.thesis.printed import RIVAL_TASKS, TABLE_4_4, data

ArmName = Literal["six-link", "stanford"]

JOINTS: Final = 6
#: The Stanford arm's prismatic joint.
_PRISMATIC: Final[dict[ArmName, frozenset[int]]] = {"six-link": frozenset(), "stanford": frozenset({3})}
_SCHEDULES: Final[dict[str, dict[str, Any]]] = data("schedules")
#: The printed tables by name.
SCHEDULES: Final = tuple(_SCHEDULES)


@dataclass(frozen=True, slots=True)
class PrintedSchedule:
    """A printed table: tasks level by level, idle slots left out."""

    table: str
    arm: ArmName
    processors: int
    levels: tuple[tuple[TaskId, ...], ...]

    @property
    def entries(self) -> int:
        """Tasks that are printed, repetitions counted."""
        return sum(map(len, self.levels))

    @property
    def tasks(self) -> frozenset[TaskId]:
        """The tasks that are printed."""
        return frozenset(task for level in self.levels for task in level)


def printed_schedule(table: str) -> PrintedSchedule:
    """The table of that name, ``4.3`` or ``C.1``, as printed.

    Raises
    ------
    InputError: there is no such table.
    """
    name = next((name for name in SCHEDULES if name.casefold() == table.strip().casefold()), None)
    if name is None:
        raise InputError(f"no printed schedule {table!r}", expected=f"one of {', '.join(SCHEDULES)}")
    found = _SCHEDULES[name]
    levels = tuple(tuple(map(int, level.split())) for level in found["levels"].split(";"))
    return PrintedSchedule(name, found["arm"], found["processors"], levels)


def rule_graph(arm: ArmName) -> TaskGraph:
    """The graph that the rules of Tables 4.2, 4.4 and 4.5 give for ``arm``, zeros as printed."""
    pattern = None if arm == "six-link" else TABLE_4_4
    return arm_graph(JOINTS, eliminated(JOINTS, _PRISMATIC[arm], pattern, "own"), _PRISMATIC[arm])


def printed_graph(arm: ArmName) -> TaskGraph:
    """The tasks whose number the thesis prints and schedules: of any six-joint arm the 231 by rule, of the
    Stanford arm the 156 of Table 4.7, which are not those by rule."""
    return rule_graph(arm) if arm == "six-link" else graph_of(arm, printed_schedule("4.7").tasks)


def graph_of(arm: ArmName, tasks: Iterable[TaskId], *, own_products: bool = False) -> TaskGraph:
    """The graph of just these ``tasks`` of ``arm``, those between them passing their inputs through."""
    every = {task_id(link, task.row) for link in range(1, JOINTS + 1) for task in TASKS}
    return arm_graph(JOINTS, every - set(tasks), _PRISMATIC[arm], own_products=own_products)


#: Milliseconds a unit of the lengths of :func:`rival_graph`.
UNIT_MS: Final = 0.01


def rival_graph() -> TaskGraph:
    """The graph of the tasks that the other columns of Table 4.8 are of; all of them belong to link 1, as far
    as is known."""
    after, lengths = {}, {}
    for task, entry in enumerate(RIVAL_TASKS.split(), 1):
        length, _, needed = entry.partition(":")
        lengths[task] = int(length)
        after[task] = frozenset(map(int, filter(None, needed.split(","))))
    return TaskGraph(after, dict.fromkeys(after, 1), lengths, dict.fromkeys(after, 1))


@dataclass(frozen=True, slots=True)
class Misprint:
    """A task that is printed in a ``level``, and the one that was probably meant; of several levels with that
    task the first in which the other one would do."""

    printed: TaskId
    meant: TaskId
    level: int

    def __str__(self) -> str:
        return f"{self.printed} for {self.meant} (level {self.level})"


@dataclass(frozen=True, slots=True)
class Judgement:
    """What the validator finds.

    ``faults``: tasks missing of, and not in, the rules' set; tasks done twice; too many in a level; tasks
    beside or before what they read. ``shared``: of the latter those of T20 to T22 beside T10 of link 1,
    which all tables share. ``misprints``: where a task that is missing would do in the place of one that is
    no task or is done twice, a digit apart, and nothing else would.
    """

    printed: PrintedSchedule
    faults: tuple[Fault, ...]
    shared: tuple[Fault, ...]
    misprints: tuple[Misprint, ...]

    def of(self, kind: str) -> tuple[Fault, ...]:
        """The faults of a kind."""
        return tuple(fault for fault in self.faults if fault.kind == kind)


def judge(printed: PrintedSchedule) -> Judgement:
    """What is wrong with a printed schedule.

    Precedence is that of the tasks which are printed, misprints that name no task of the arm left out, and
    only by what a task reads: a sum of products waits for those of its own component.
    """
    tasks = dict.fromkeys(rule_graph(printed.arm).tasks, ())
    in_set = faults_of_levels(tasks, printed.processors, printed.levels)
    own: list[Fault] = []
    shared: list[Fault] = []
    for fault in _out_of_order(printed, printed.levels):
        every_table = fault.other == task_id(1, 10) and fault.task in {task_id(1, k) for k in (20, 21, 22)}
        (shared if every_table else own).append(fault)
    return Judgement(printed, (*in_set, *own), tuple(shared), tuple(_misprints(printed, in_set)))


def _out_of_order(printed: PrintedSchedule, levels: Iterable[Iterable[TaskId]]) -> list[Fault]:
    """Tasks of ``levels`` beside or before what they read."""
    rows = [tuple(level) for level in levels]
    tasks = {task for level in rows for task in level if _is_task(task)}
    after = graph_of(printed.arm, tasks, own_products=True).after
    return [
        fault for fault in faults_of_levels(after, printed.processors, rows) if fault.kind == "precedence"
    ]


#: Tasks done twice beyond which no single digits are looked for.
_HANDFUL: Final = 6


def _misprints(printed: PrintedSchedule, faults: Iterable[Fault]) -> Iterator[Misprint]:
    missing = [fault.task for fault in faults if fault.kind == "missing"]
    twice = {fault.task for fault in faults if fault.kind == "twice"}
    if len(twice) > _HANDFUL:  # a column is set wrongly, and not a digit
        return
    wrong = twice | {task for task in printed.tasks if not _is_task(task)}
    places = [
        Misprint(task, meant, k)
        for k, level in enumerate(printed.levels, 1)
        for task in level
        if task in wrong
        for meant in missing
        if _digits_apart(task, meant) == 1 and _fits(printed, task, meant, k)
    ]
    near = {place.printed for place in places if _same_link(place)}
    places = [place for place in places if _same_link(place) or place.printed not in near]
    reported: set[tuple[TaskId, TaskId]] = set()
    for place in places:
        pair = (place.printed, place.meant)
        alone = all(
            (other.printed, other.meant) == pair
            for other in places
            if place.meant == other.meant or place.printed == other.printed
        )
        if alone and pair not in reported:
            reported.add(pair)
            yield place


def _same_link(place: Misprint) -> bool:
    return link_and_number(place.printed)[0] == link_and_number(place.meant)[0]


def _digits_apart(a: TaskId, b: TaskId) -> int:
    return sum(x != y for x, y in zip(str(a), str(b), strict=True)) if len(str(a)) == len(str(b)) else 9


def _fits(printed: PrintedSchedule, task: TaskId, meant: TaskId, where: int) -> bool:
    """Whether ``meant`` in the place of ``task`` in level ``where`` breaks no order."""
    levels = [
        tuple(meant if k == where and one == task else one for one in level)
        for k, level in enumerate(printed.levels, 1)
    ]
    return not any(meant in (fault.task, fault.other) for fault in _out_of_order(printed, levels))


def _is_task(task: TaskId) -> bool:
    link, task_number = link_and_number(task)
    return 1 <= link <= JOINTS and 1 <= task_number <= len(TASKS)
