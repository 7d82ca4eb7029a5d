"""The methods: published level figures, bounds, machines with costs, and what each refuses."""

from __future__ import annotations

import sys
from functools import partial

import pytest

from robodyn import InputError
from robodyn.errors import ToolError
from robodyn.schedule import METHODS, Machine, TaskGraph, faults_of_times, general_graph, lower_bound, solve
from robodyn.schedule.bounds import fewest_processors
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.schedule.methods import Method, check
from robodyn.schedule.optimum import fewest_for_critical_path, optimum
from robodyn.thesis.judge import printed_graph
from robodyn_testing import require_module
from robodyn_testing.clocks import Ticking, calls_of
from schedule.graphs import shortest, some_graph

SIX = general_graph(6)
STANFORD = printed_graph("stanford")
BEST = [116, 77, 58, 47, 39, 34, 30, 28, 27, 27, 27, 27]
LISTS: tuple[Method, ...] = ("thesis", "critical-path", "dhlf")


@pytest.mark.parametrize("p", range(2, 14))
def test_critical_path_first_is_optimal_for_six_joints_and_bounds_prove_it(p: int) -> None:
    assert lower_bound(SIX, p) == BEST[p - 2]
    for method in ("critical-path", "dhlf", "optimal"):
        solved = solve(SIX, Machine(p), method)
        assert (solved.timetable.levels, solved.optimal, solved.gap) == (BEST[p - 2], True, 0)


def test_the_stanford_arms_optima() -> None:
    require_module("ortools")
    solved = [solve(STANFORD, Machine(p), "optimal", seconds=60) for p in range(2, 9)]
    assert [one.timetable.levels for one in solved] == [78, 52, 39, 32, 27, 25, 25]
    assert all(one.optimal for one in solved)
    assert solve(STANFORD, Machine(4), "critical-path").timetable.levels == 40  # so that a solver is needed


@pytest.mark.parametrize("method", LISTS)
@pytest.mark.parametrize(
    "machine", [Machine(1), Machine(3), Machine(3, 2), Machine(3, 2, False), Machine(4, 0, False)]
)
def test_every_machine_gets_a_valid_schedule_no_shorter_than_the_bound(
    method: Method, machine: Machine
) -> None:
    for seed in range(12):
        graph = some_graph(seed, longest=1 if seed % 2 else 4)
        solved = solve(graph, machine, method)  # judged by the validator inside
        assert lower_bound(graph, machine.processors) <= solved.lower_bound <= solved.timetable.span
        if machine.processors == 1:
            assert solved.timetable.span >= graph.work
            assert machine.communication or solved.timetable.span == graph.work
        assert 0 < solved.efficiency <= 1


def test_levels_last_as_long_as_their_longest_task_and_meeting_takes_time() -> None:
    graph = TaskGraph(
        {1: frozenset(), 2: frozenset(), 3: frozenset({1})}, dict.fromkeys((1, 2, 3), 1), {1: 5, 2: 2, 3: 1}
    )
    solved = solve(graph, Machine(2, communication=3))
    assert [(one.task, one.start, one.finish) for one in solved.timetable.placements] == [
        (1, 0, 5), (2, 0, 2), (3, 8, 9),
    ]  # fmt: skip
    assert solved.timetable.span == 9
    assert solve(graph, Machine(2, 3, synchronised=False)).timetable.span == 6  # on the processor of 1


def test_a_value_that_changes_processors_comes_later() -> None:
    graph = TaskGraph({t: frozenset() for t in (1, 2)} | {3: frozenset({1, 2})}, dict.fromkeys((1, 2, 3), 1))
    spans = [solve(graph, Machine(2, c, False), "critical-path").timetable.span for c in (0, 1, 2, 9)]
    assert spans[:2] == [2, 3]
    require_module("ortools")
    best = [solve(graph, Machine(2, c, False), "optimal").timetable.span for c in (0, 1, 2, 9)]
    assert best == [2, 3, 3, 3]  # all on one processor


@pytest.mark.parametrize("seed", range(8))
def test_the_optimum_is_never_longer_and_its_bound_never_beaten(seed: int) -> None:
    require_module("ortools")
    graph = some_graph(seed, tasks=14)
    for machine in (Machine(2), Machine(3), Machine(2, 1, False)):
        best = optimum(graph, machine, seconds=20)
        check(graph, best.timetable)
        assert best.proven
        for method in LISTS:
            assert solve(graph, machine, method).timetable.span >= best.timetable.span == best.lower_bound


def brute(graph: TaskGraph, p: int) -> int:
    """Fewest levels of unit tasks, by going through all sets of tasks that can be done."""
    from itertools import combinations

    states, levels = {frozenset[int]()}, 0
    while True:
        if any(len(state) == len(graph) for state in states):
            return levels
        levels += 1
        found = set()
        for state in states:
            ready = [t for t in graph.tasks if t not in state and graph.after[t] <= state]
            for some in combinations(ready, min(p, len(ready))):
                found.add(state | frozenset(some))
        states = found


@pytest.mark.parametrize("seed", range(10))
def test_bounds_hold_against_a_search_through_everything(seed: int) -> None:
    graph = some_graph(seed + 50, tasks=10)
    for p in (2, 3):
        least = brute(graph, p)
        assert lower_bound(graph, p) <= least <= solve(graph, Machine(p)).timetable.levels
    span = graph.critical_path
    needed = next(p for p in range(1, 11) if brute(graph, p) == span)
    assert fewest_processors(graph, span) <= needed


@pytest.mark.parametrize("seed", range(6))
def test_bounds_hold_for_tasks_of_any_length(seed: int) -> None:
    """Against all orders of seven tasks."""
    graph = some_graph(seed + 80, tasks=7, longest=4)
    for p in (2, 3):
        least = shortest(graph, p)
        assert lower_bound(graph, p) <= least
        assert solve(graph, Machine(p, 0, False)).timetable.span >= least
        assert fewest_processors(graph, least) <= p


def test_a_bound_in_levels_is_a_bound_in_time() -> None:
    """Where the optimum is not reached, meetings of levels that need not be there are not in the bound."""
    require_module("ortools")
    graph = some_graph(3, tasks=14)
    best = solve(graph, Machine(2), "optimal").timetable.levels
    solved = solve(graph, Machine(2, 4), "optimal")
    assert solved.lower_bound == solved.timetable.span == best + 4 * (best - 1)
    found = solve(SIX, Machine(6, 10), "branch-and-bound", seconds=0.01)
    assert found.own_bound is not None
    assert found.own_bound <= 74 + 10 * 73


def test_one_processor_a_joint() -> None:
    for n, levels in ((2, 40), (3, 48)):  # CP-SAT proves both
        found = one_processor_a_joint(general_graph(n), seconds=2, clock=Ticking(2e-2).monotonic)
        assert found.schedule.levels == levels
        assert found.lower_bound <= levels
        for slot in found.schedule.slots:
            assert all(task is None or task // 100 == place + 1 for place, task in enumerate(slot))
    solved = solve(SIX, Machine(6), "branch-and-bound", seconds=1)
    assert 57 <= solved.timetable.levels <= 81  # thesis, any processor: 39
    assert solved.own_bound is not None
    assert solved.lower_bound <= solved.own_bound <= solved.timetable.levels


def test_branch_and_bound_proves_where_it_can() -> None:
    chain = TaskGraph({101: frozenset(), 201: frozenset({101}), 102: frozenset({101})}, {})
    found = one_processor_a_joint(chain)
    assert (found.schedule.slots, found.proven) == (((101, None), (102, 201)), True)
    assert one_processor_a_joint(TaskGraph({}, {})).proven


def test_twelve_joints_on_sixteen_processors_take_no_search() -> None:
    graph = general_graph(12)
    assert len(graph) == 489
    for method in LISTS:
        solved = calls_of(partial(solve, graph, Machine(16), method), most=500_000)
        assert solved.timetable.levels == 51


def test_the_optimiser_stops_with_a_valid_schedule_and_a_gap() -> None:
    """A machine whose optimum is out of reach: values take long to pass."""
    require_module("ortools")
    graph = general_graph(6)
    solved = solve(graph, Machine(5, 3, False), "optimal", seconds=1)
    check(graph, solved.timetable)
    assert not solved.optimal
    assert solved.gap > 0
    assert solved.lower_bound >= lower_bound(graph, 5)


def test_the_fewest_processors_for_the_critical_path() -> None:
    found = fewest_for_critical_path(SIX)
    assert (found.span, found.at_least, found.processors, found.proven) == (27, 10, 10, True)
    assert found.timetable.levels == 27


def test_without_or_tools_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ortools.sat.python", None)
    assert solve(SIX, Machine(5), "optimal").optimal  # bounds and heuristics settle it
    with pytest.raises(ToolError, match="pip install") as told:
        solve(STANFORD, Machine(4), "optimal")
    assert told.value.exit_code == 3


def test_what_is_refused() -> None:
    with pytest.raises(InputError, match="needs a processor"):
        Machine(0)
    with pytest.raises(InputError, match="not meant"):
        Machine(10**9)
    with pytest.raises(InputError, match="before it is sent"):
        Machine(2, -1)
    with pytest.raises(InputError, match="does not take so long"):
        Machine(2, 10**12)
    with pytest.raises(InputError, match="unknown method"):
        solve(SIX, Machine(2), "best")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="-p 6"):
        solve(SIX, Machine(5), "branch-and-bound")
    with pytest.raises(InputError, match="in levels"):
        solve(SIX, Machine(6, 0, False), "branch-and-bound")
    with pytest.raises(InputError, match="equal length"):
        solve(some_graph(1, longest=3), Machine(2), "optimal")


def test_an_empty_graph() -> None:
    nothing = TaskGraph({}, {})
    for method in METHODS:
        if method != "branch-and-bound":
            solved = solve(nothing, Machine(2), method)
            assert (solved.timetable.span, solved.speedup, solved.optimal) == (0, 1, True)


def test_a_scheduler_at_fault_is_caught() -> None:
    solved = solve(SIX, Machine(3))
    moved = [
        one._replace(start=0, finish=1) if one.task == 143 else one for one in solved.timetable.placements
    ]
    kinds = {fault.kind for fault in faults_of_times(SIX.after, {}, 3, 0, moved)}
    assert "early" in kinds
    assert faults_of_times(SIX.after, {}, 3, 0, solved.timetable.placements) == []
