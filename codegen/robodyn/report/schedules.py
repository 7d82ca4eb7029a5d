"""Schedules as text and JSON."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from robodyn.errors import InputError
from robodyn.report.figures import aligned
from robodyn.report.schedule_sources import BY_RULE, Source
from robodyn.schedule import FLOPS_PER_TASK, Solved
from robodyn.schedule.methods import TITLES
from robodyn.schedule.tree import Searched
from robodyn.schedule.validate import faults_of_times


def to_dict(source: Source, solved: Solved) -> dict[str, Any]:
    """A schedule as ``schedule --json`` prints it."""
    table, graph = solved.timetable, source.graph
    machine = table.machine
    beside = source.printed.get(machine.processors)
    return {
        "robot": source.name,
        "method": solved.method,
        "processors": machine.processors,
        "tasks": len(graph),
        "levels": table.levels,
        "critical_path": graph.critical_path if machine.synchronised else graph.critical_time,
        "lower_bound": solved.lower_bound,
        "optimal": solved.optimal,
        "speedup": solved.speedup,
        "efficiency": solved.efficiency,
        "slots": [list(row) for row in table.slots],
        "times": list(table.times),
        "thesis": None if beside is None else {"levels": beside[0], "table": beside[1]},
        "tasks_of": source.tasks,
        "work": graph.work,
        "time": table.span,
        "gap": solved.gap,
        "own_bound": solved.own_bound,
        "nodes": None if solved.search is None else solved.search.nodes,
        "ended": None if solved.search is None else solved.search.ended,
        "synchronised": machine.synchronised,
        "communication": machine.communication,
        "faults": _faults(solved),
        "without_friction": None
        if source.plain is None
        else {"tasks": len(source.plain), "critical_path": source.plain.critical_path},
        "printed": None if source.figures is None else dict(source.figures),
        "notes": list(source.notes),
    }


def _faults(solved: Solved) -> list[str]:
    """The validator's word on the schedule once more, for the reader."""
    table, graph = solved.timetable, solved.graph
    machine = table.machine
    faults = faults_of_times(
        graph.after,
        graph.lengths,
        machine.processors,
        machine.communication,
        table.placements,
        levels=table.slots if machine.synchronised else None,
    )
    return [str(fault) for fault in faults]


def to_text(source: Source, solved: Solved) -> str:
    """A schedule for a person: what it is, its figures, and the table itself."""
    return "\n".join([*_head(source, solved), "", *_grid(solved), *_wrapped(source.notes)]) + "\n"


def _head(source: Source, solved: Solved) -> list[str]:
    table, graph = solved.timetable, source.graph
    machine = table.machine
    p = machine.processors
    unit = "levels" if machine.synchronised else "units of time"
    chain = graph.critical_path if machine.synchronised else graph.critical_time
    distance = (
        "which is the optimum" if solved.optimal else f"at most {100 * solved.gap:.1f} % above the optimum"
    )
    lines = [
        f"{source.name}: {len(graph)} {source.tasks}, critical path {chain} {unit}",
        f"{p} processor{'s' if p > 1 else ''}, {TITLES[solved.method]}",
        f"{table.levels} {unit}, {distance} (none below {solved.lower_bound}); speed-up "
        f"{solved.speedup:.3f}, "
        f"efficiency {100 * solved.efficiency:.2f} %",
    ]
    if machine.communication or table.span != table.levels:
        what = "meeting" if machine.synchronised else "passing a value"
        lines.append(f"time {table.span} for work of {graph.work}; {what} takes {machine.communication}")
    if solved.own_bound is not None:
        lines.append(f"with one processor a joint none below {solved.own_bound}")
    if solved.search is not None:
        lines.append(_effort(solved.search))
    beside = source.printed.get(p)
    if beside is not None:
        lines.append(f"thesis: {beside[0]} levels (Table {beside[1]}; robodyn schedule --thesis {beside[1]})")
    if source.tasks == BY_RULE or "Table" in source.tasks:
        lines.append(
            f"a task is {FLOPS_PER_TASK} operations: {FLOPS_PER_TASK * table.levels} one after another"
        )
    return lines


def _effort(search: Searched) -> str:
    why = {
        "proven": "nothing shorter exists",
        "nodes": "gave up there: --nodes for more",
        "seconds": "gave up when its time was over: --budget-seconds for more",
    }
    if not search.nodes:
        return "the heuristic that the search begins with meets the bound: nothing was left to search"
    return f"the search looked at {search.nodes} nodes; {why[search.ended]}"


def _grid(solved: Solved) -> list[str]:
    table = solved.timetable
    width = max((len(str(task)) for row in table.slots for task in row if task is not None), default=1)
    width = max(width, len(str(table.machine.processors)) + 1)
    first = len(str(table.levels))
    head = "  ".join(f"P{k}".rjust(width) for k in range(1, table.machine.processors + 1))
    rows = [f"{' ' * first}  {head}"]
    numbers = range(1, len(table.slots) + 1) if table.machine.synchronised else table.times
    for level, row in zip(numbers, table.slots, strict=True):
        cells = "  ".join(("-" if task is None else str(task)).rjust(width) for task in row)
        rows.append(f"{str(level).rjust(first)}  {cells}")
    return rows


def _wrapped(notes: Sequence[str]) -> list[str]:
    import textwrap

    lines = [line for note in notes for line in textwrap.wrap(note, 110, subsequent_indent="  ")]
    return ["", *lines] if lines else []


def sweep_text(source: Source, solutions: Sequence[Solved]) -> str:
    """Schedules on several machines, one a row."""
    heads = ("p", "levels", "time", "speed-up", "efficiency", "none below", "above optimum", "thesis")
    rows: list[tuple[str, ...]] = [heads]
    for solved in solutions:
        table = solved.timetable
        beside = source.printed.get(table.machine.processors)
        rows.append(
            (
                str(table.machine.processors),
                str(table.levels),
                str(table.span),
                f"{solved.speedup:.3f}",
                f"{100 * solved.efficiency:.2f} %",
                str(solved.lower_bound),
                "0, proven" if solved.optimal else f"at most {100 * solved.gap:.1f} %",
                "-" if beside is None else f"{beside[0]} ({beside[1]})",
            )
        )
    graph = source.graph
    lines = [
        f"{source.name}: {len(graph)} {source.tasks}, critical path {graph.critical_path}",
        TITLES[solutions[0].method] if solutions else "",
        "",
        *aligned(rows),
        *_wrapped(source.notes),
    ]
    return "\n".join(lines) + "\n"


def processors_of(text: str, parse: Callable[[str], int] = int) -> tuple[int, ...]:
    """``4``, ``2,4,8`` or ``2..13`` as numbers.

    Raises
    ------
    InputError: not of that form, or so many that no sweep is meant.
    """
    counts: list[int] = []
    for part in text.split(","):
        first, dots, last = part.strip().partition("..")
        try:
            begin, end = parse(first), parse(last if dots else first)
        except ValueError:
            raise InputError(
                "processors cannot be read", found=repr(text), expected="4, 2,4,8 or 2..13"
            ) from None
        if not 1 <= begin <= end or end - begin > 255:
            raise InputError(
                "processors cannot be read", found=repr(text), expected="4, 2,4,8 or 2..13, from 1"
            )
        counts += range(begin, end + 1)
    return tuple(dict.fromkeys(counts))
