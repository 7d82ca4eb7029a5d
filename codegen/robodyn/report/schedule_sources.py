"""What is scheduled: task graphs by their sources, with what the thesis prints of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Final

from robodyn.errors import InputError
from robodyn.robot.masses import require_masses
from robodyn.robot.model import Robot
from robodyn.schedule import TaskGraph, general_graph, robot_graph
from robodyn.schedule.cutting import Cut
from robodyn.schedule.elimination import StepThree
from robodyn.schedule.friction_tasks import Friction, friction_of, is_friction
from robodyn.schedule.graph import link_and_number, task_id
from robodyn.schedule.task_counts import operations_of_tasks
from robodyn.thesis.judge import graph_of, printed_schedule, rule_graph
from robodyn.thesis.printed_tasks import LEVELS_SIX_LINK, LEVELS_STANFORD, TABLE_4_4

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
        return with_friction(f"{n} links", general_graph(n, friction), general_graph(n))
    printed = _printed(LEVELS_SIX_LINK, _TABLES_SIX) if n == SIX else {}
    rule = _long(general_graph(n), n, costs)
    if not as_printed:
        return Source(f"{n} links", BY_RULE, rule, printed)
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


BY_RULE: Final = "tasks of Table 4.1 by the thesis's rules"


def with_friction(name: str, graph: TaskGraph, plain: TaskGraph, notes: tuple[str, ...] = ()) -> Source:
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
    if rubbing:
        if as_printed:
            raise InputError(
                "the thesis prints no tasks of friction", remedy="leave out --as-printed or --friction"
            )
        pattern = TABLE_4_4 if robot.name == STANFORD else None
        step_3: StepThree = "own" if robot.name == STANFORD else "before"
        own, plain = (robot_graph(robot, pattern, step_3, one) for one in (rubbing, {}))
        return with_friction(robot.name, own, plain, _unsuited(robot))
    stanford = robot.name == STANFORD
    if as_printed and not stanford:
        raise InputError(
            f"the thesis prints no tasks of {robot.name}",
            remedy=f"leave out --as-printed, or take {STANFORD} or --links {SIX}",
        )
    if not stanford:
        return Source(robot.name, BY_RULE, robot_graph(robot, friction={}), notes=_unsuited(robot))
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
    graph, what = (printed, "tasks of Table 4.7") if as_printed else (by_rule, BY_RULE)
    return Source(robot.name, what, graph, levels, (note,), figures)


def _printed(levels: Mapping[int, int], tables: Mapping[int, str]) -> dict[int, tuple[int, str]]:
    return {p: (levels[p], tables[p]) for p in tables}


def _more(graph: TaskGraph, than: TaskGraph) -> str:
    """The tasks of one graph that another has not, spelled."""
    differing = sorted(set(graph.tasks) - set(than.tasks))
    return (
        ", ".join(map(str, differing[:-1])) + f" and {differing[-1]}"
        if len(differing) > 1
        else str(differing[0])
    )


def _unsuited(robot: Robot) -> tuple[str, ...]:
    """What of the robot the tasks of Table 4.1 are not cut for."""
    lines = []
    if any(link.joint.alpha.quarter is None for link in robot.links):
        lines.append("angles alpha that are no multiples of 90 degrees")
    if any(value != 0 for link in robot.links for value in _products(link.inertia)):
        lines.append("products of inertia")
    if any(not (entry.definition.traits.body or is_friction(entry)) for entry in robot.effects):
        lines.append("effects in its joints that have no tasks")
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
