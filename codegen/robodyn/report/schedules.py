"""Schedules as text and JSON; and what is scheduled: task graphs, with what the thesis prints of them."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Final

from robodyn.draw.tables import aligned
from robodyn.errors import InputError
from robodyn.robot.masses import require_masses
from robodyn.robot.model import Robot
from robodyn.schedule import FLOPS_PER_TASK, Solved, TaskGraph, general_graph, robot_graph
from robodyn.schedule.arithmetic import operations_of_tasks
from robodyn.schedule.cutting import Cut
from robodyn.schedule.friction_tasks import Friction, friction_of, is_friction
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.schedule.methods import TITLES
from robodyn.thesis.judge import graph_of, printed_schedule, rule_graph
from robodyn.thesis.printed import LEVELS_SIX_LINK, LEVELS_STANFORD, TABLE_4_4

#: The printed levels by processors, and the tables that have them.
_SIX_LINK: Final = {p: (LEVELS_SIX_LINK[p], "4.3" if p == 13 else f"C.{p - 1}") for p in (13, *range(2, 10))}
_STANFORD: Final = {p: (LEVELS_STANFORD[p], "4.7" if p == 9 else f"C.{p + 7}") for p in (9, *range(2, 9))}
#: The bundled arm that chapter 4 customises the tasks for, and the joints of the one of appendix C.
STANFORD: Final = "stanford"
SIX, MOST_LINKS = 6, 99
BY_RULE: Final = "tasks of Table 4.1 by the thesis's rules"


@dataclass(frozen=True, slots=True)
class Source:
    """A graph to schedule: whose it is, what its tasks are, what the thesis prints of it.

    ``printed``: levels by processors, and the tables that have them; ``notes`` explain; ``cut`` is there
    where the tasks are those of a program; ``plain`` is the graph without friction, of one that has it.
    """

    name: str
    tasks: str
    graph: TaskGraph
    printed: Mapping[int, tuple[int, str]] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    figures: Mapping[str, Any] | None = None
    cut: Cut | None = None
    plain: TaskGraph | None = None


def links_source(
    n: int,
    *,
    as_printed: bool = False,
    costs: Mapping[str, int] | None = None,
    friction: Friction | None = None,
) -> Source:
    """The tasks of any revolute arm of ``n`` joints; with ``costs`` of operations a task is as long as those
    of which Table 4.1 makes it up, else one unit. ``friction``: what all its joints have of it.

    Raises
    ------
    InputError: no joints or too many, ``as_printed`` and not the six of the thesis, or friction with costs or
        ``as_printed``.
    """
    if not 1 <= n <= MOST_LINKS:
        raise InputError("an arm has joints", found=f"{n}", expected=f"1 to {MOST_LINKS}")
    if as_printed and n != SIX:
        raise InputError("the thesis prints tasks of six links", found=f"{n} links", expected="--links 6")
    if friction is not None:
        if as_printed or costs is not None:
            raise InputError(
                "friction goes with tasks of equal length by the thesis's rules",
                remedy=f"leave out {'--as-printed' if as_printed else '--cost'}",
            )
        return _with_friction(f"{n} links", general_graph(n, friction), general_graph(n))
    rule = _with_lengths(general_graph(n), costs)
    if not as_printed:
        return Source(f"{n} links", BY_RULE, rule, _SIX_LINK if n == SIX else {})
    graph = _with_lengths(graph_of("six-link", printed_schedule("4.3").tasks), costs)
    note = (
        f"as printed: the {len(graph)} tasks of Table 4.3; the thesis speaks of {len(rule)}, which is what "
        f"its rules leave (43 n - 27): the table holds {_difference(graph, rule)}, which they eliminate, and "
        f"not {_difference(rule, graph)}"
    )
    return Source(f"{n} links", "tasks of Table 4.3", graph, _SIX_LINK, (note,))


def _with_lengths(graph: TaskGraph, costs: Mapping[str, int] | None) -> TaskGraph:
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


def _with_friction(name: str, graph: TaskGraph, plain: TaskGraph, notes: tuple[str, ...] = ()) -> Source:
    """The source of a ``graph`` with friction, and what friction makes of the ``plain`` one without it."""
    chain = graph.critical_path - plain.critical_path
    note = (
        f"friction takes {len(graph) - len(plain)} tasks more, and {chain} level{'s' * (chain != 1)} more on "
        f"the longest chain: without it there are {len(plain)} tasks and a chain of {plain.critical_path} "
        "(--friction none). Its tasks follow those of their own link, and no link waits for them; they are "
        "cut by us (schedule/friction_tasks.py), the thesis prints none"
    )
    return Source(name, f"{BY_RULE}, with friction", graph, notes=(note, *notes), plain=plain)


def robot_source(
    robot: Robot, *, as_printed: bool = False, friction: Mapping[int, Friction] | None = None
) -> Source:
    """The tasks of ``robot`` by the thesis's rules; of the Stanford arm with the zeros of Table 4.4. With
    ``friction`` by joint from 1, that of its description where that is None.

    Raises
    ------
    InputError: ``as_printed``, and the thesis prints no tasks of this robot, or none with friction; or
        torques would rest on masses that nobody knows.
    """
    require_masses(robot)
    rubbing = friction_of(robot) if friction is None else friction
    is_stanford = robot.name == STANFORD
    if as_printed and (rubbing or not is_stanford):
        other = "--friction" if rubbing else f"take {STANFORD} or --links {SIX}"
        raise InputError(
            f"the thesis prints no tasks of {'friction' if rubbing else robot.name}",
            remedy=f"leave out --as-printed{' or' if rubbing else ', or'} {other}",
        )
    if rubbing:
        zeros: tuple[Any, Any] = (TABLE_4_4, "own") if is_stanford else (None, "before")
        graph, plain = (robot_graph(robot, *zeros, friction=one) for one in (rubbing, {}))
        return _with_friction(robot.name, graph, plain, _unsuited(robot))
    if not is_stanford:
        return Source(robot.name, BY_RULE, robot_graph(robot, friction={}), notes=_unsuited(robot))
    table = printed_schedule("4.7")
    printed, by_rule, own = graph_of(STANFORD, table.tasks), rule_graph(STANFORD), robot_graph(robot)
    note = (
        f"the thesis prints {len(printed)} tasks in {len(table.levels)} layers (Table 4.7), and its rules "
        f"leave {len(by_rule)}: of subtotal 10 in Table 4.6 the list has 12, and Table 4.7 holds "
        f"{_difference(printed, by_rule)}, which the rules eliminate, and not "
        f"{_difference(by_rule, printed)}; the longest chain is {by_rule.critical_path} in both, because "
        "links that are prismatic or sparse do not need two layers each. By the robot's own zeros, step 3 "
        f"with p of the link before, there are {len(own)} tasks"
    )
    figures = {
        "tasks": len(printed),
        "layers": len(table.levels),
        "table": "4.7",
        "by_rule": len(by_rule),
        "critical_path": by_rule.critical_path,
        "by_the_robots_zeros": len(own),
    }
    graph, what = (printed, "tasks of Table 4.7") if as_printed else (by_rule, BY_RULE)
    return Source(robot.name, what, graph, _STANFORD, (note,), figures)


def _difference(graph: TaskGraph, other: TaskGraph) -> str:
    """The tasks of one graph that another has not, spelled."""
    *most, last = map(str, sorted(set(graph.tasks) - set(other.tasks)))
    return f"{', '.join(most)} and {last}" if most else last


def _unsuited(robot: Robot) -> tuple[str, ...]:
    """What of the robot the tasks of Table 4.1 are not cut for."""
    inertias = [link.inertia for link in robot.links]
    reasons = {
        "angles alpha that are no multiples of 90 degrees": any(
            link.joint.alpha.quarter is None for link in robot.links
        ),
        "products of inertia": any(
            x != 0 for inertia in inertias for x in (inertia.xy, inertia.xz, inertia.yz)
        ),
        "effects in its joints that have no tasks": any(
            not (entry.definition.traits.body or is_friction(entry)) for entry in robot.effects
        ),
    }
    lines = [reason for reason, applies in reasons.items() if applies]
    if not lines:
        return ()
    return (
        f"{robot.name} has {' and '.join(lines)}, which the tasks of Table 4.1 are not cut for: --cut 3 "
        "takes the operations of its kernel",
    )


def cut_source(name: str, cut: Cut, k: int) -> Source:
    """The tasks of a kernel's program."""
    operations = "single operations" if k == 1 else f"tasks of at most {k} operations"
    return Source(name, f"{operations} of the kernel", cut.graph, cut=cut)


# --- JSON and text ----------------------------------------------------------------------------------------


def to_dict(source: Source, solved: Solved) -> dict[str, Any]:
    """A schedule as ``schedule --json`` prints it."""
    table, graph, plain = solved.timetable, source.graph, source.plain
    machine = table.machine
    printed = source.printed.get(machine.processors)
    return {
        "robot": source.name,
        "method": solved.method,
        "processors": machine.processors,
        "tasks": len(graph),
        "levels": table.levels,
        "critical_path": graph.critical_path if machine.synchronised else graph.critical_time,
        **{key: getattr(solved, key) for key in ("lower_bound", "optimal", "speedup", "efficiency")},
        "slots": [list(row) for row in table.slots],
        "times": list(table.times),
        "thesis": None if printed is None else {"levels": printed[0], "table": printed[1]},
        "tasks_of": source.tasks,
        "work": graph.work,
        "time": table.span,
        "gap": solved.gap,
        "own_bound": solved.own_bound,
        "nodes": None if solved.search is None else solved.search.nodes,
        "ended": None if solved.search is None else solved.search.ended,
        "synchronised": machine.synchronised,
        "communication": machine.communication,
        "faults": [],  # schedule.methods.check lets no other timetable pass
        "without_friction": plain and {"tasks": len(plain), "critical_path": plain.critical_path},
        "printed": source.figures and dict(source.figures),
        "notes": list(source.notes),
    }


def to_text(source: Source, solved: Solved) -> str:
    """A schedule for a person: what it is, its figures, and the table itself."""
    return "\n".join([*_head(source, solved), "", *_grid(solved), *_wrapped(source.notes)]) + "\n"


#: Why a search ended, by its own word for it.
_ENDS: Final = {
    "proven": "nothing shorter exists",
    "nodes": "gave up there: --nodes for more",
    "seconds": "gave up when its time was over: --budget-seconds for more",
}


def _head(source: Source, solved: Solved) -> list[str]:
    table, graph, search = solved.timetable, source.graph, solved.search
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
        f"{solved.speedup:.3f}, efficiency {100 * solved.efficiency:.2f} %",
    ]
    if machine.communication or table.span != table.levels:
        what = "meeting" if machine.synchronised else "passing a value"
        lines.append(f"time {table.span} for work of {graph.work}; {what} takes {machine.communication}")
    if solved.own_bound is not None:
        lines.append(f"with one processor a joint none below {solved.own_bound}")
    if search is not None and search.nodes:
        lines.append(f"the search looked at {search.nodes} nodes; {_ENDS[search.ended]}")
    elif search is not None:
        lines.append("the heuristic that the search begins with meets the bound: nothing was left to search")
    if p in source.printed:
        levels, name = source.printed[p]
        lines.append(f"thesis: {levels} levels (Table {name}; robodyn schedule --thesis {name})")
    if source.tasks == BY_RULE or "Table" in source.tasks:
        lines.append(
            f"a task is {FLOPS_PER_TASK} operations: {FLOPS_PER_TASK * table.levels} one after another"
        )
    return lines


def _grid(solved: Solved) -> list[str]:
    table = solved.timetable
    p, numbers = table.machine.processors, range(1, len(table.slots) + 1)
    cells = [["-" if task is None else str(task) for task in row] for row in table.slots]
    width = max([len(str(p)) + 1, *(len(cell) for row in cells for cell in row)])
    first = len(str(table.levels))
    rows = [("", [f"P{k}" for k in range(1, p + 1)])]
    rows += zip(map(str, numbers if table.machine.synchronised else table.times), cells, strict=True)
    return [f"{name.rjust(first)}  {'  '.join(cell.rjust(width) for cell in row)}" for name, row in rows]


def _wrapped(notes: Sequence[str]) -> list[str]:
    lines = [line for note in notes for line in textwrap.wrap(note, 110, subsequent_indent="  ")]
    return ["", *lines] if lines else []


def sweep_text(source: Source, solutions: Sequence[Solved]) -> str:
    """Schedules on several machines, one a row."""
    rows = [["p", "levels", "time", "speed-up", "efficiency", "none below", "above optimum", "thesis"]]
    for solved in solutions:
        table = solved.timetable
        p = table.machine.processors
        figures = [str(p), str(table.levels), str(table.span), f"{solved.speedup:.3f}"]
        figures += [f"{100 * solved.efficiency:.2f} %", str(solved.lower_bound)]
        above = "0, proven" if solved.optimal else f"at most {100 * solved.gap:.1f} %"
        printed = "{} ({})".format(*source.printed[p]) if p in source.printed else "-"
        rows.append([*figures, above, printed])
    head = f"{source.name}: {len(source.graph)} {source.tasks}, critical path {source.graph.critical_path}"
    title = TITLES[solutions[0].method]
    return "\n".join([head, title, "", *aligned(rows), *_wrapped(source.notes)]) + "\n"


def processors_of(text: str) -> tuple[int, ...]:
    """``4``, ``2,4,8`` or ``2..13`` as numbers.

    Raises
    ------
    InputError: not of that form, or so many that no sweep is meant.
    """
    counts: list[int] = []
    for part in text.split(","):
        first, dots, last = part.strip().partition("..")
        try:
            begin, end = int(first), int(last if dots else first)
        except ValueError:
            begin = end = 0
        if not 1 <= begin <= end or end - begin > 255:
            raise InputError(
                "processors cannot be read", found=repr(text), expected="4, 2,4,8 or 2..13, from 1"
            )
        counts += range(begin, end + 1)
    return tuple(dict.fromkeys(counts))
