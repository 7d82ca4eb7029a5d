"""What is scheduled and what comes out of it: graphs by their sources, schedules as text and JSON."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

from robodyn.errors import InputError
from robodyn.robot.model import Robot
from robodyn.schedule import FLOPS_PER_TASK, Solved, TaskGraph, general_graph, robot_graph
from robodyn.schedule.cutting import Cut
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.schedule.methods import TITLES
from robodyn.schedule.task_counts import operations_of_tasks
from robodyn.schedule.tree import Searched
from robodyn.schedule.validate import faults_of_times
from robodyn.thesis.judge import graph_of, printed_schedule, rule_graph
from robodyn.thesis.printed_tasks import LEVELS_SIX_LINK, LEVELS_STANFORD

#: The printed tables by processors.
_TABLES_SIX: Final = {13: "4.3"} | {p: f"C.{p - 1}" for p in range(2, 10)}
_TABLES_STANFORD: Final = {9: "4.7"} | {p: f"C.{p + 7}" for p in range(2, 9)}

#: The bundled arm that chapter 4 customises the tasks for, and the one of appendix C.
STANFORD: Final = "stanford"
SIX: Final = 6
MOST_LINKS: Final = 99


@dataclass(frozen=True, slots=True)
class Source:
    """A graph to schedule: whose it is, what its tasks are, what the thesis prints of it.

    ``printed``: levels by processors, and the tables that have them; ``notes`` explain; ``cut`` is there
    where the tasks are those of a program.
    """

    name: str
    tasks: str
    graph: TaskGraph
    printed: Mapping[int, tuple[int, str]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    figures: Mapping[str, Any] | None = None
    cut: Cut | None = None


def links_source(n: int, *, as_printed: bool = False, costs: Mapping[str, int] | None = None) -> Source:
    """The tasks of any revolute arm of ``n`` joints; with ``costs`` of operations a task is as long as those
    of which Table 4.1 makes it up, else one unit.

    Raises
    ------
    InputError: no joints or too many, or ``as_printed`` and not the six of the thesis.
    """
    if not 1 <= n <= MOST_LINKS:
        raise InputError("an arm has joints", found=f"{n}", expected=f"1 to {MOST_LINKS}")
    if as_printed and n != SIX:
        raise InputError("the thesis prints tasks of six links", found=f"{n} links", expected="--links 6")
    printed = _printed(LEVELS_SIX_LINK, _TABLES_SIX) if n == SIX else {}
    rule = _long(general_graph(n), n, costs)
    if not as_printed:
        return Source(f"{n} links", _BY_RULE, rule, printed)
    graph = _long(graph_of("six-link", printed_schedule("4.3").tasks), n, costs)
    note = (
        f"as printed: the {len(graph)} tasks of Table 4.3; the thesis speaks of {len(rule)}, which is "
        f"what its rules "
        f"leave (43 n - 27): the table holds {_more(graph, rule)}, which they eliminate, and not "
        f"{_more(rule, graph)}"
    )
    return Source(f"{n} links", "tasks of Table 4.3", graph, printed, (note,))


def _long(graph: TaskGraph, n: int, costs: Mapping[str, int] | None) -> TaskGraph:
    """``graph`` with lengths by what a task of a link amid the arm does: the rules count no less for the
    first and the last link."""
    if costs is None:
        return graph
    amid = operations_of_tasks(4)
    lengths = {
        task: sum(costs[kind] * amount for kind, amount in amid[task_id(3, link_and_number(task)[1])].items())
        for task in graph.tasks
    }
    return replace(graph, lengths=lengths)


_BY_RULE: Final = "tasks of Table 4.1 by the thesis's rules"


def robot_source(robot: Robot, *, as_printed: bool = False) -> Source:
    """The tasks of ``robot`` by the thesis's rules; of the Stanford arm with the zeros of Table 4.4.

    Raises
    ------
    InputError: ``as_printed``, and the thesis prints no tasks of this robot.
    """
    stanford = robot.name == STANFORD
    if as_printed and not stanford:
        raise InputError(
            f"the thesis prints no tasks of {robot.name}",
            remedy=f"leave out --as-printed, or take {STANFORD} or --links {SIX}",
        )
    if not stanford:
        return Source(robot.name, _BY_RULE, robot_graph(robot), notes=_doubts(robot))
    printed, by_rule = graph_of(STANFORD, printed_schedule("4.7").tasks), rule_graph(STANFORD)
    own = robot_graph(robot)
    layers = len(printed_schedule("4.7").levels)
    note = (
        f"the thesis prints {len(printed)} tasks in {layers} layers (Table 4.7), and its rules leave "
        f"{len(by_rule)}: of subtotal 10 in Table 4.6 the list has 12, and Table 4.7 holds "
        f"{_more(printed, by_rule)}, which the rules eliminate, and not {_more(by_rule, printed)}; the "
        f"longest "
        f"chain is {by_rule.critical_path} in both, because links that are prismatic or sparse do not "
        f"need two layers "
        f"each. By the robot's own zeros, step 3 with p of the link before, there are {len(own)} tasks"
    )
    figures = {
        "tasks": len(printed),
        "layers": layers,
        "table": "4.7",
        "by_rule": len(by_rule),
        "critical_path": by_rule.critical_path,
        "by_the_robots_zeros": len(own),
    }
    levels = _printed(LEVELS_STANFORD, _TABLES_STANFORD)
    graph, what = (printed, "tasks of Table 4.7") if as_printed else (by_rule, _BY_RULE)
    return Source(robot.name, what, graph, levels, (note,), figures)


def _printed(levels: Mapping[int, int], tables: Mapping[int, str]) -> dict[int, tuple[int, str]]:
    return {p: (levels[p], tables[p]) for p in tables}


def _more(graph: TaskGraph, than: TaskGraph) -> str:
    """The tasks of one graph that another has not, spelled."""
    additional = sorted(set(graph.tasks) - set(than.tasks))
    return (
        ", ".join(map(str, additional[:-1])) + f" and {additional[-1]}"
        if len(additional) > 1
        else str(additional[0])
    )


def _doubts(robot: Robot) -> tuple[str, ...]:
    """What of the robot the tasks of Table 4.1 are not cut for."""
    lines = []
    if any(link.joint.alpha.quarter is None for link in robot.links):
        lines.append("angles alpha that are no multiples of 90 degrees")
    if any(value != 0 for link in robot.links for value in _products(link.inertia)):
        lines.append("products of inertia")
    if robot.effects:
        lines.append("effects in its joints")
    if not lines:
        return ()
    return (
        f"{robot.name} has {' and '.join(lines)}, which the tasks of Table 4.1 are not cut for: --cut 3 "
        f"takes the "
        "operations of its kernel",
    )


def _products(inertia: Any) -> tuple[Any, ...]:
    return inertia.xy, inertia.xz, inertia.yz


def cut_source(name: str, cut: Cut, k: int) -> Source:
    """The tasks of a kernel's program."""
    operations = "single operations" if k == 1 else f"tasks of at most {k} operations"
    return Source(name, f"{operations} of the kernel", cut.graph, cut=cut)


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
    return "\n".join([*_head(source, solved), "", *_grid(solved), *_told(source.notes)]) + "\n"


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
    if source.tasks == _BY_RULE or "Table" in source.tasks:
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


def _told(notes: Sequence[str]) -> list[str]:
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
    widths = [max(len(row[k]) for row in rows) for k in range(len(heads))]
    graph = source.graph
    lines = [
        f"{source.name}: {len(graph)} {source.tasks}, critical path {graph.critical_path}",
        TITLES[solutions[0].method] if solutions else "",
        "",
        *("  ".join(cell.rjust(width) for cell, width in zip(row, widths, strict=True)) for row in rows),
        *_told(source.notes),
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
