"""The methods: published level figures, bounds, machines with costs, searches, and what each refuses."""

from __future__ import annotations

import random
import sys
from functools import partial
from itertools import combinations, count

import pytest

from robodyn import InputError
from robodyn.errors import ToolError
from robodyn.schedule import METHODS, Machine, TaskGraph, faults_of_times, general_graph, lower_bound, solve
from robodyn.schedule.branch_and_bound import one_processor_a_joint
from robodyn.schedule.graph import fewest_processors
from robodyn.schedule.methods import Method, check
from robodyn.schedule.optimum import fewest_for_critical_path, optimum
from robodyn.schedule.tree import Limits, Tree
from robodyn.thesis.judge import printed_graph, rule_graph
from robodyn_testing import representative, require_module
from robodyn_testing.clocks import Ticking, calls_of
from schedule.graphs import shortest, some_graph

SIX, PRINTED, EMPTY = general_graph(6), printed_graph("stanford"), TaskGraph({}, {})
#: Levels at 2, 3, ... processors, as the thesis and its review have them.
FIGURES = {
    ("six", "thesis"): [116, 77, 58, 47, 39, 34, 32, 31, 30, 29, 28, 27],
    ("six", "critical-path"): [116, 77, 58, 47, 39, 34, 30, 28, 27, 27, 27, 27],
    ("printed", "thesis"): [79, 52, 40, 32, 28, 27, 26, 25],
    ("printed", "critical-path"): [78, 52, 40, 32, 27, 25, 25, 25],
    ("printed", "best"): [78, 52, 39, 32, 27, 25, 25],
    ("by rule", "best"): [77, 52, 39, 31, 27, 25, 25, 25],
}
LISTS: tuple[Method, ...] = ("thesis", "critical-path", "dhlf")
SEARCHES: tuple[Method, ...] = ("df-ihs", "a-star")
#: A limit that no clock has a part in.
FOR_EVER = 1e9

both = pytest.mark.parametrize("method", SEARCHES)


# --- figures ------------------------------------------------------------------------------------------------


def test_list_schedules_have_the_published_levels() -> None:
    for name, graph in (("six", SIX), ("printed", PRINTED)):
        for method in ("thesis", "critical-path"):
            for p, levels in enumerate(FIGURES[name, method], 2):
                solved = solve(graph, Machine(p), method)
                assert solved.timetable.levels == levels
                assert solved.speedup == len(graph) / levels
                assert solved.efficiency == pytest.approx(len(graph) / levels / p)
    assert solve(SIX, Machine(1000)).timetable.levels == SIX.critical_path == 27


@pytest.mark.parametrize("p", representative(range(2, 14), 2, 8, rest="slow"))
def test_critical_path_first_is_optimal_for_six_joints_and_bounds_prove_it(p: int) -> None:
    best = FIGURES["six", "critical-path"][p - 2]
    assert lower_bound(SIX, p) == best
    for method in ("critical-path", "dhlf", "optimal"):
        solved = solve(SIX, Machine(p), method)
        assert (solved.timetable.levels, solved.optimal, solved.gap) == (best, True, 0)


@both
@pytest.mark.parametrize("n", representative(range(2, 7), 6, rest="slow"))
def test_general_arms_are_done_in_proven_optima(method: Method, n: int) -> None:
    graph = general_graph(n)
    for p in range(2, 14):
        solved = solve(graph, Machine(p), method, seconds=FOR_EVER, nodes=20_000)
        assert solved.timetable.levels == solved.lower_bound == lower_bound(graph, p), p


@both
def test_the_stanford_arm_needs_a_search_and_gets_its_proof(method: Method) -> None:
    """On four processors critical path first takes 40 levels."""
    solved = solve(PRINTED, Machine(4), method, seconds=FOR_EVER)
    assert (solved.timetable.levels, solved.lower_bound, solved.optimal) == (39, 39, True)
    assert solved.search is not None
    assert solved.search.ended == "proven"
    assert 0 < solved.search.nodes < 5000
    meeting = solve(
        PRINTED, Machine(4, 3), method, seconds=FOR_EVER
    )  # the same levels, whatever meeting costs
    assert meeting.timetable.span == meeting.lower_bound == 39 + 3 * 38
    by_rule = [solve(rule_graph("stanford"), Machine(p), method, seconds=FOR_EVER) for p in range(2, 10)]
    assert [one.timetable.levels for one in by_rule] == FIGURES["by rule", "best"]
    assert all(one.optimal for one in by_rule)


def test_the_stanford_arms_optima() -> None:
    require_module("ortools")
    solved = [solve(PRINTED, Machine(p), "optimal", seconds=60) for p in range(2, 9)]
    assert [one.timetable.levels for one in solved] == FIGURES["printed", "best"]
    assert all(one.optimal for one in solved)


# --- what holds of every graph ------------------------------------------------------------------------------


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


def fewest_levels(graph: TaskGraph, p: int) -> int:
    """Fewest levels of unit tasks, by going through all sets of tasks that can be done."""
    states = {frozenset[int]()}
    for level in count():
        if any(len(state) == len(graph) for state in states):
            return level
        after = set()
        for state in states:
            ready = [t for t in graph.tasks if t not in state and graph.after[t] <= state]
            after |= {state.union(some) for some in combinations(ready, min(p, len(ready)))}
        states = after
    raise AssertionError


@pytest.mark.parametrize("seed", range(5))
def test_bounds_hold_against_a_search_through_everything(seed: int) -> None:
    graph = some_graph(seed + 50, tasks=10)
    for p in (2, 3):
        assert lower_bound(graph, p) <= fewest_levels(graph, p) <= solve(graph, Machine(p)).timetable.levels
    span = graph.critical_path
    assert fewest_processors(graph, span) <= next(p for p in count(1) if fewest_levels(graph, p) == span)
    graph = some_graph(seed + 80, tasks=7, longest=4)  # against all orders of seven tasks
    for p in (2, 3):
        least = shortest(graph, p)
        assert lower_bound(graph, p) <= least <= solve(graph, Machine(p, 0, False)).timetable.span
        assert fewest_processors(graph, least) <= p


@both
@pytest.mark.parametrize("seed", range(5))
def test_the_optimum_of_small_graphs_is_that_of_all_orders(method: Method, seed: int) -> None:
    """Tasks of one length in levels, and of several without."""
    for longest, machine in ((1, Machine(2)), (1, Machine(3)), (5, Machine(2, 0, False))):
        graph = some_graph(seed, 7, longest)
        solved = solve(graph, machine, method, seconds=FOR_EVER)
        assert solved.timetable.span == solved.lower_bound == shortest(graph, machine.processors)


@pytest.mark.parametrize("seed", range(4))
def test_the_optimum_is_never_longer_and_its_bound_never_beaten(seed: int) -> None:
    require_module("ortools")
    graph = some_graph(seed, tasks=14)
    for machine in (Machine(2), Machine(3), Machine(2, 1, False)):
        best = optimum(graph, machine, seconds=20)
        check(graph, best.timetable)
        assert best.proven
        for method in LISTS:
            assert solve(graph, machine, method).timetable.span >= best.timetable.span == best.lower_bound


@pytest.mark.parametrize("longest", [1, 4])
def test_no_way_through_a_node_ends_before_its_bound(longest: int) -> None:
    """Down random ways to the end: what a node promised is never beaten below it."""
    rng = random.Random(3)
    for seed in range(30):
        tree = Tree(some_graph(seed, 14, longest), 2 + seed % 2)
        node, promised = tree.root(), [tree.bound(tree.root())]
        while not tree.complete(node):
            node = rng.choice(list(tree.branches(node)))
            promised.append(tree.bound(node))
        assert max(promised) == promised[-1] == node.time


# --- single cases -------------------------------------------------------------------------------------------


@both
def test_waiting_for_a_task_may_be_the_shortest(method: Method) -> None:
    """A processor that is free had better wait for the long chain's next task than begin a long one."""
    needs = {1: (), 2: (), 3: (1,), 4: (), 5: (3,)}
    lengths = {1: 2, 2: 1, 3: 6, 4: 7, 5: 1}
    graph = TaskGraph(
        {task: frozenset(some) for task, some in needs.items()}, dict.fromkeys(needs, 1), lengths
    )
    assert solve(graph, Machine(2, 0, False), method, seconds=FOR_EVER).timetable.span == shortest(graph, 2)


def test_levels_last_as_long_as_their_longest_task_and_meeting_takes_time() -> None:
    graph = TaskGraph(
        {1: frozenset(), 2: frozenset(), 3: frozenset({1})}, dict.fromkeys((1, 2, 3), 1), {1: 5, 2: 2, 3: 1}
    )
    solved = solve(graph, Machine(2, communication=3))
    assert [one[::2] + one[3:] for one in solved.timetable.placements] == [(1, 0, 5), (2, 0, 2), (3, 8, 9)]
    assert solved.timetable.span == 9
    assert solve(graph, Machine(2, 3, synchronised=False)).timetable.span == 6  # on the processor of 1


def test_a_value_that_changes_processors_comes_later() -> None:
    graph = TaskGraph({t: frozenset() for t in (1, 2)} | {3: frozenset({1, 2})}, dict.fromkeys((1, 2, 3), 1))
    spans = [solve(graph, Machine(2, c, False), "critical-path").timetable.span for c in (0, 1)]
    assert spans == [2, 3]
    require_module("ortools")
    best = [solve(graph, Machine(2, c, False), "optimal").timetable.span for c in (0, 1, 2, 9)]
    assert best == [2, 3, 3, 3]  # all on one processor


def test_a_bound_in_levels_is_a_bound_in_time() -> None:
    """Where the optimum is not reached, meetings of levels that need not be there are not in the bound."""
    require_module("ortools")
    graph = some_graph(3, tasks=14)
    best = solve(graph, Machine(2), "optimal").timetable.levels
    solved = solve(graph, Machine(2, 4), "optimal")
    assert solved.lower_bound == solved.timetable.span == best + 4 * (best - 1)
    own = solve(SIX, Machine(6, 10), "branch-and-bound", seconds=0.01).own_bound
    assert own is not None
    assert own <= 74 + 10 * 73


def test_one_processor_a_joint() -> None:
    for n, levels in ((2, 40), (3, 48)):  # CP-SAT proves both
        bounded = one_processor_a_joint(general_graph(n), seconds=2, clock=Ticking(2e-2).monotonic)
        assert bounded.lower_bound <= bounded.schedule.levels == levels
        for slot in bounded.schedule.slots:
            assert all(task is None or task // 100 == place + 1 for place, task in enumerate(slot))
    solved = solve(SIX, Machine(6), "branch-and-bound", seconds=1)
    assert solved.own_bound is not None
    assert solved.lower_bound <= solved.own_bound <= solved.timetable.levels
    assert 57 <= solved.timetable.levels <= 81  # thesis, any processor: 39
    chain = TaskGraph({101: frozenset(), 201: frozenset({101}), 102: frozenset({101})}, {})
    bounded = one_processor_a_joint(chain)
    assert (bounded.schedule.slots, bounded.proven) == (((101, None), (102, 201)), True)
    assert one_processor_a_joint(EMPTY).proven


def test_twelve_joints_on_sixteen_processors_take_no_search() -> None:
    graph = general_graph(12)
    for method in LISTS:
        solved = calls_of(partial(solve, graph, Machine(16), method), most=500_000)
        assert solved.timetable.levels == 51


def test_the_optimiser_stops_with_a_valid_schedule_and_a_gap() -> None:
    """A machine whose optimum is out of reach: values take long to pass."""
    require_module("ortools")
    solved = solve(SIX, Machine(5, 3, False), "optimal", seconds=1)
    check(SIX, solved.timetable)
    assert solved.gap > 0
    assert not solved.optimal
    assert solved.lower_bound >= lower_bound(SIX, 5)


@both
def test_a_limit_ends_the_search_and_is_told(method: Method) -> None:
    """From 40 levels on, one node is not enough; the bound stays a bound, the schedule the heuristic's."""
    solved = solve(PRINTED, Machine(4), method, seconds=FOR_EVER, nodes=1)
    assert solved.search is not None
    assert solved.search.ended == "nodes"
    assert (solved.timetable.levels, solved.lower_bound, solved.optimal) == (40, 39, False)
    assert solved.gap == pytest.approx(1 / 39)
    assert Limits(10**9, 5.0, lambda: 6.0).reached(256) == "seconds"
    assert Limits(10**9, 5.0, lambda: 4.0).reached(256) is None


@both
def test_the_way_a_search_goes_is_always_the_same(method: Method) -> None:
    graph = some_graph(5, 40)
    first, second = (solve(graph, Machine(3), method, seconds=FOR_EVER, nodes=2000) for _ in range(2))
    assert (first.timetable, first.search) == (second.timetable, second.search)


def test_the_fewest_processors_for_the_critical_path() -> None:
    fewest = fewest_for_critical_path(SIX)
    assert (fewest.span, fewest.at_least, fewest.processors, fewest.proven) == (27, 10, 10, True)
    assert fewest.timetable.levels == 27


def test_without_or_tools_the_remedy_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ortools.sat.python", None)
    assert solve(SIX, Machine(5), "optimal").optimal  # bounds and heuristics settle it
    with pytest.raises(ToolError, match="pip install") as told:
        solve(PRINTED, Machine(4), "optimal")
    assert told.value.exit_code == 3


def test_machines_that_cannot_be_are_refused() -> None:
    for processors, communication, words in (
        (0, 0, "needs a processor"), (10**9, 0, "not meant"), (2, -1, "before it is"), (2, 10**12, "so long"),
    ):  # fmt: skip
        with pytest.raises(InputError, match=words):
            Machine(processors, communication)


@pytest.mark.parametrize(
    ("graph", "machine", "method", "words"),
    [
        (SIX, Machine(2), "best", "unknown method"),
        (SIX, Machine(5), "branch-and-bound", "-p 6"),
        (SIX, Machine(6, 0, False), "branch-and-bound", "in levels"),
        *(
            (some_graph(1, longest=3), Machine(2), method, "equal length")
            for method in ("optimal", *SEARCHES)
        ),
        *((SIX, Machine(2, 1, False), method, "no time to pass a value") for method in SEARCHES),
    ],
)
def test_what_methods_refuse(graph: TaskGraph, machine: Machine, method: Method, words: str) -> None:
    with pytest.raises(InputError, match=words):
        solve(graph, machine, method)


def test_an_empty_graph() -> None:
    for method in METHODS:
        if method != "branch-and-bound":
            solved = solve(EMPTY, Machine(2), method)
            assert (solved.timetable.span, solved.speedup, solved.optimal) == (0, 1, True)


def test_a_scheduler_at_fault_is_caught() -> None:
    solved = solve(SIX, Machine(3))
    moved = [
        one._replace(start=0, finish=1) if one.task == 143 else one for one in solved.timetable.placements
    ]
    assert "early" in {fault.kind for fault in faults_of_times(SIX.after, {}, 3, 0, moved)}
