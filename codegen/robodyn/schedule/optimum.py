"""The shortest schedule, with a proof or a bound, by constraint programming (OR-Tools, CP-SAT).

A heuristic's schedule and the window bounds often settle it alone; then no solver is asked, and none is
needed. Otherwise every task gets a level inside its window, chains keep their order, and at most ``p``
tasks share a level; without levels it gets a start, and where passing a value costs something, a processor.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from robodyn.errors import InputError
from robodyn.schedule.graph import TaskGraph, TaskId, fewest_processors, lower_bound
from robodyn.schedule.heuristics import critical_path_order, planned, thesis_order
from robodyn.schedule.machine import Machine, Placement, Schedule, Timetable, in_levels, in_time
from robodyn.tools.libraries import ORTOOLS


@dataclass(frozen=True, slots=True)
class Optimum:
    """The best timetable known, what nothing can beat, and whether the two meet."""

    timetable: Timetable
    lower_bound: int
    proven: bool


def solver() -> Any:
    """CP-SAT's module.

    Raises
    ------
    ToolError: OR-Tools is not installed.
    """
    import warnings

    try:
        with warnings.catch_warnings():  # of its own bindings
            warnings.simplefilter("ignore")
            from ortools.sat.python import cp_model
    except ImportError:
        raise ORTOOLS.missing(otherwise="take --method critical-path") from None
    return cp_model


def optimum(graph: TaskGraph, machine: Machine, *, seconds: float = 60.0, seed: int = 0) -> Optimum:
    """The shortest schedule of ``graph`` on ``machine``, or the best found within ``seconds``; with
    enough time always the same one.

    Raises
    ------
    ToolError: a solver is needed, and OR-Tools is not installed.
    InputError: levels, and tasks of different lengths.
    """
    if machine.synchronised and not graph.uniform:
        raise InputError(
            "the optimum in levels is for tasks of equal length",
            remedy="add --no-levels, or leave out --cost and --communication",
        )
    best, bound = _best_list(graph, machine), lower_bound(graph, machine.processors)
    if best.levels <= bound:
        return Optimum(best, bound, True)
    cp = solver()
    model = cp.CpModel()
    horizon = best.levels if machine.synchronised else best.span
    early, late = graph.earliest(), graph.remaining()
    starts = {
        task: model.new_int_var(early[task] - graph.length(task), horizon - late[task], f"t{task}")
        for task in graph.tasks
    }
    places = None
    if not machine.synchronised and machine.communication:
        places = _processors(model, graph, machine, starts)
    else:
        boxes = [model.new_fixed_size_interval_var(starts[t], graph.length(t), "") for t in graph.tasks]
        model.add_cumulative(boxes, [1] * len(boxes), machine.processors)
        for task, needed in graph.after.items():
            for other in needed:
                model.add(starts[task] >= starts[other] + graph.length(other))
    span = model.new_int_var(bound, horizon, "span")
    for task in graph.tasks:
        model.add(span >= starts[task] + graph.length(task))
    model.minimize(span)
    for one in best.placements:
        at = one.start
        if machine.synchronised:  # levels, whatever meeting costs
            at = next(k for k, row in enumerate(best.slots) if one.task in row)
        model.add_hint(starts[one.task], at)
    run = cp.CpSolver()
    run.parameters.max_time_in_seconds = max(seconds, 0.01)
    run.parameters.random_seed = seed
    run.parameters.num_workers = 1
    status = run.solve(model)
    if status in (cp.OPTIMAL, cp.FEASIBLE) and run.objective_value < horizon:
        when = {task: int(run.value(start)) for task, start in starts.items()}
        where = None
        if places is not None:
            where = {t: next(k for k, x in enumerate(row) if run.value(x)) for t, row in places.items()}
        best = placed(graph, machine, when, where)
    if status == cp.OPTIMAL:
        return Optimum(best, best.levels, True)
    if status != cp.UNKNOWN:
        bound = max(bound, -int(-run.best_objective_bound // 1))
    return Optimum(best, min(bound, best.levels), False)


def _best_list(graph: TaskGraph, machine: Machine) -> Timetable:
    """The shortest of the list schedules."""
    orders = [(critical_path_order, False), (critical_path_order, True)]
    if machine.synchronised:
        orders.insert(1, (thesis_order, False))
    plans = [planned(graph, machine, order(graph), dynamic=dynamic) for order, dynamic in orders]
    return min(plans, key=lambda plan: plan.span)


def _processors(
    model: Any, graph: TaskGraph, machine: Machine, starts: dict[TaskId, Any]
) -> dict[TaskId, Any]:
    """A processor for every task, and delays where a value changes processors."""
    here = {t: [model.new_bool_var("") for _ in range(machine.processors)] for t in graph.tasks}
    boxes: list[list[Any]] = [[] for _ in range(machine.processors)]
    for task, row in here.items():
        model.add_exactly_one(row)
        length = graph.length(task)
        for k, there in enumerate(row):
            boxes[k].append(model.new_optional_fixed_size_interval_var(starts[task], length, there, ""))
    for lane in boxes:
        model.add_no_overlap(lane)
    for task, needed in graph.after.items():
        for other in needed:
            done = starts[other] + graph.length(other)
            model.add(starts[task] >= done)
            for k in range(machine.processors):
                apart = model.add(starts[task] >= done + machine.communication)
                apart.only_enforce_if(here[task][k], here[other][k].negated())
    return here


def placed(
    graph: TaskGraph, machine: Machine, when: dict[TaskId, int], where: dict[TaskId, int] | None
) -> Timetable:
    """The timetable in which every task begins when ``when`` says (in levels: its level, from 0), on the
    processor that ``where`` says or on any that is free."""
    if machine.synchronised:
        slots: list[list[TaskId]] = [[] for _ in range(max(when.values(), default=-1) + 1)]
        for task in sorted(when, key=critical_path_order(graph)):
            slots[when[task]].append(task)
        return in_levels(graph, machine, Schedule(machine.processors, tuple(map(tuple, slots))))
    if where is None:
        free, where = [0] * machine.processors, {}
        for task in sorted(when, key=lambda task: (when[task], task)):  # whichever is free
            where[task] = next(k for k, end in enumerate(free) if end <= when[task])
            free[where[task]] = when[task] + graph.length(task)
    return in_time(
        machine, [Placement(t, where[t], start, start + graph.length(t)) for t, start in when.items()]
    )


@dataclass(frozen=True, slots=True)
class Fewest:
    """Processors on which ``graph`` is done within ``span``: ``processors`` by a schedule, ``at_least``
    proven."""

    span: int
    at_least: int
    processors: int
    timetable: Timetable

    @property
    def proven(self) -> bool:
        """Whether nothing is left between the two."""
        return self.at_least == self.processors


def fewest_for_critical_path(
    graph: TaskGraph, *, seconds: float = 60.0, tell: Callable[[str], None] = lambda _: None
) -> Fewest:
    """The fewest processors on which ``graph``, of unit tasks, is no longer than its critical path.

    Raises
    ------
    InputError: tasks of different lengths.
    ToolError: heuristics and bounds leave a gap, and OR-Tools is not installed.
    """
    if not graph.uniform:
        raise InputError(
            "the fewest processors are found for tasks of equal length", remedy="leave out --cost"
        )
    span = graph.critical_path
    at_least = most = fewest_processors(graph, span)
    while (best := _best_list(graph, Machine(most))).levels > span:
        most += 1
    for p in range(at_least, most):
        tell(f"{p} processors")
        result = optimum(graph, Machine(p), seconds=seconds)
        if result.timetable.levels == span:
            return Fewest(span, at_least, p, result.timetable)
        if at_least == p and result.lower_bound > span:
            at_least = p + 1
    return Fewest(span, at_least, most, best)
