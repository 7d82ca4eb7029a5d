"""The methods by their names, each handing over a timetable with what is known of its distance from the best.

Every timetable is judged by :mod:`robodyn.schedule.validate` before it is handed over.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Final, Literal, get_args

from robodyn.errors import InputError
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.schedule.graph import TaskGraph, lower_bound
from robodyn.schedule.heuristics import critical_path_order, planned, thesis_order
from robodyn.schedule.machine import Machine, Timetable, in_levels
from robodyn.schedule.optimum import optimum, placed
from robodyn.schedule.tree import MOST_NODES, Limits, Searched, Tree, searched
from robodyn.schedule.validate import faults_of_times

Method = Literal["thesis", "critical-path", "dhlf", "df-ihs", "a-star", "branch-and-bound", "optimal"]
METHODS: Final[tuple[Method, ...]] = get_args(Method)

TITLES: Final[dict[Method, str]] = {
    "thesis": "list heuristic of the thesis, section 4.3.3: layer, link, task",
    "critical-path": "critical path, most immediate successors first (Kasahara and Narita 1985)",
    "dhlf": "dynamic highest level first (Chen, Lee and Hou 1988)",
    "df-ihs": "depth first with implicit heuristic search (Kasahara and Narita 1985)",
    "a-star": "A*, the best promise first (Chen, Lee and Hou 1988)",
    "branch-and-bound": "one processor a joint, branch and bound (Luh and Lin 1982)",
    "optimal": "optimum by constraint programming",
}

#: Methods that search, and stop after some time.
SEARCHES: Final[tuple[Method, ...]] = ("df-ihs", "a-star", "branch-and-bound", "optimal")


@dataclass(frozen=True, slots=True)
class Solved:
    """A valid timetable of ``graph``.

    ``lower_bound``: what no schedule of this machine can beat, in the timetable's units, by proof.
    ``optimal``: whether this one meets it. ``own_bound``: what the method itself cannot beat, where it
    restricts the machine (one processor a joint). ``search``: of DF/IHS and A*, what was looked at.
    """

    graph: TaskGraph
    method: Method
    timetable: Timetable
    lower_bound: int
    own_bound: int | None = None
    search: Searched | None = None

    @property
    def optimal(self) -> bool:
        """Whether nothing shorter exists, as far as is proven."""
        return self.timetable.span <= self.lower_bound

    @property
    def gap(self) -> float:
        """How much longer than the lower bound, as a share of it."""
        return self.timetable.span / self.lower_bound - 1 if self.lower_bound else 0.0

    @property
    def speedup(self) -> float:
        """One processor's time to this machine's."""
        return self.timetable.speedup(self.graph.work)

    @property
    def efficiency(self) -> float:
        """Speed-up a processor."""
        return self.speedup / self.timetable.machine.processors


def solve(
    graph: TaskGraph,
    machine: Machine,
    method: Method = "critical-path",
    *,
    seconds: float = 60.0,
    seed: int = 0,
    nodes: int = MOST_NODES,
) -> Solved:
    """A schedule of ``graph`` on ``machine`` by ``method``; a search stops after ``seconds``, DF/IHS and A*
    after so many ``nodes`` too.

    Raises
    ------
    InputError: an unknown method, or one that this machine does not suit.
    ToolError: the optimum needs OR-Tools, and it is not installed.
    """
    if method not in METHODS:
        raise InputError(f"unknown method {method!r}", expected=f"one of {', '.join(METHODS)}")
    bound, own, search = _bound(graph, machine), None, None
    if method == "optimal":
        result = optimum(graph, machine, seconds=seconds, seed=seed)
        timetable = result.timetable
        bound = max(bound, _with_meetings(result.lower_bound, machine))
    elif method in ("df-ihs", "a-star"):
        timetable, search = _searched(graph, machine, method, seconds, nodes)
        bound = max(bound, _with_meetings(search.lower_bound, machine))
    elif method == "branch-and-bound":
        timetable, own = _a_joint(graph, machine, seconds)
    else:
        order = thesis_order(graph) if method == "thesis" else critical_path_order(graph)
        timetable = planned(graph, machine, order, dynamic=method == "dhlf")
    check(graph, timetable)
    return Solved(graph, method, timetable, bound, own, search)


def _searched(
    graph: TaskGraph, machine: Machine, method: Method, seconds: float, nodes: int
) -> tuple[Timetable, Searched]:
    if machine.synchronised and not graph.uniform:
        raise InputError(
            f"{method} in levels is for tasks of equal length", remedy="add --no-levels, or leave out --cost"
        )
    if machine.communication and not machine.synchronised:
        raise InputError(
            f"{method} knows no time to pass a value",
            found=f"{machine.communication}",
            remedy="leave out --communication or --no-levels, or take another method",
        )
    best_first = method == "a-star"
    free = Machine(machine.processors, synchronised=machine.synchronised)
    ways = (False, True) if best_first else (False,)
    plans = [planned(graph, free, critical_path_order(graph), dynamic=dynamic) for dynamic in ways]
    first = min(plans, key=lambda plan: plan.span)
    known = {one.task: one.start for one in first.placements}
    limits = Limits(nodes, time.monotonic() + seconds)
    tree = Tree(graph, machine.processors)
    solution = searched(tree, known, first.span, limits, best_first=best_first)
    return placed(graph, machine, dict(solution.starts), None), solution


def check(graph: TaskGraph, timetable: Timetable) -> None:
    """:class:`AssertionError` where ``timetable`` may not be carried out: a scheduler is at fault."""
    machine = timetable.machine
    faults = faults_of_times(
        graph.after,
        graph.lengths,
        machine.processors,
        machine.communication,
        timetable.placements,
        levels=timetable.slots if machine.synchronised else None,
    )
    if faults:
        raise AssertionError("; ".join(map(str, faults[:5])))


def _with_meetings(levels: int, machine: Machine) -> int:
    """The time of so many levels of unit tasks, or of so much time without levels."""
    return levels + max(0, levels - 1) * machine.communication if machine.synchronised else levels


def _bound(graph: TaskGraph, machine: Machine) -> int:
    bound = lower_bound(graph, machine.processors)
    if machine.synchronised and machine.communication and len(graph):
        levels = max(graph.critical_path, -(-len(graph) // machine.processors))
        bound += (levels - 1) * machine.communication
    return bound


def _a_joint(graph: TaskGraph, machine: Machine, seconds: float) -> tuple[Timetable, int]:
    joints = len({graph.link(task) for task in graph.tasks})
    if not machine.synchronised or not graph.uniform:
        raise InputError(
            "branch and bound with one processor a joint works in levels, with tasks of equal length",
            remedy="leave out --no-levels and --cost, or take another method",
        )
    if machine.processors != joints:
        raise InputError(
            "branch and bound gives every joint a processor of its own",
            found=f"{machine.processors} processors, {joints} links with tasks",
            remedy=f"ask for -p {joints}",
        )
    solution = one_processor_a_joint(graph, seconds=seconds)
    timetable = in_levels(graph, machine, solution.schedule)
    return timetable, _with_meetings(solution.lower_bound, machine)
