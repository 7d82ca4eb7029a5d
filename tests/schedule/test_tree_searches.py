"""DF/IHS and A*: optima proven, bounds never beaten, limits kept and told."""

from __future__ import annotations

import random

import pytest

from robodyn import InputError
from robodyn.schedule import Machine, TaskGraph, general_graph, list_schedule, lower_bound, solve
from robodyn.schedule.heuristics import critical_path_order
from robodyn.schedule.methods import Method
from robodyn.schedule.tree import Limits, Tree
from robodyn.thesis.judge import printed_graph, rule_graph
from schedule.graphs import shortest, some_graph

BOTH: tuple[Method, ...] = ("df-ihs", "a-star")
#: Limits that no clock has a part in.
FOR_EVER = 1e9

both = pytest.mark.parametrize("method", BOTH)


@both
@pytest.mark.parametrize("n", range(2, 7))
def test_general_arms_are_done_in_proven_optima(method: Method, n: int) -> None:
    graph = general_graph(n)
    for p in range(2, 14):
        solved = solve(graph, Machine(p), method, seconds=FOR_EVER, nodes=20_000)
        assert solved.optimal, p
        assert solved.timetable.levels == solved.lower_bound >= lower_bound(graph, p)
        if n == 6:
            assert solved.timetable.levels == [116, 77, 58, 47, 39, 34, 30, 28, 27, 27, 27, 27][p - 2]


@both
def test_the_stanford_arm_on_four_processors_needs_a_search_and_gets_its_proof(method: Method) -> None:
    """Critical path first takes 40 levels; 39, which the bound says, CP-SAT had to be asked for before."""
    graph = printed_graph("stanford")
    assert list_schedule(graph, 4, critical_path_order(graph)).levels == 40
    solved = solve(graph, Machine(4), method, seconds=FOR_EVER)
    assert (solved.timetable.levels, solved.lower_bound, solved.optimal) == (39, 39, True)
    assert solved.search is not None
    assert 0 < solved.search.nodes < 5000
    assert solved.search.ended == "proven"
    meeting = solve(graph, Machine(4, 3), method, seconds=FOR_EVER)  # the same levels, whatever meeting costs
    assert meeting.timetable.span == meeting.lower_bound == 39 + 3 * 38


@both
def test_the_stanford_arm_by_rule(method: Method) -> None:
    found = [solve(rule_graph("stanford"), Machine(p), method, seconds=FOR_EVER) for p in range(2, 10)]
    assert [one.timetable.levels for one in found] == [77, 52, 39, 31, 27, 25, 25, 25]
    assert all(one.optimal for one in found)


@both
@pytest.mark.parametrize("seed", range(10))
def test_the_optimum_of_small_graphs_is_that_of_all_orders(method: Method, seed: int) -> None:
    """Tasks of one length in levels, and of several without."""
    for longest, machine in ((1, Machine(2)), (1, Machine(3)), (5, Machine(2, 0, False))):
        graph = some_graph(seed, 7, longest)
        solved = solve(graph, machine, method, seconds=FOR_EVER)
        assert solved.timetable.span == solved.lower_bound == shortest(graph, machine.processors)


@both
def test_waiting_for_a_task_may_be_the_shortest(method: Method) -> None:
    """A processor that is free had better wait for the long chain's next task than begin a long one."""
    graph = TaskGraph(
        {1: frozenset(), 2: frozenset(), 3: frozenset({1}), 4: frozenset(), 5: frozenset({3})},
        dict.fromkeys(range(1, 6), 1),
        {1: 2, 2: 1, 3: 6, 4: 7, 5: 1},
    )
    machine = Machine(2, 0, False)
    assert solve(graph, machine, method, seconds=FOR_EVER).timetable.span == shortest(graph, 2)


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
        assert max(promised) <= node.time
        assert promised[-1] == node.time


@both
def test_a_limit_ends_the_search_and_is_told(method: Method) -> None:
    """From 40 levels on, one node is not enough; the bound stays a bound, the schedule the heuristic's."""
    graph = printed_graph("stanford")
    solved = solve(graph, Machine(4), method, seconds=FOR_EVER, nodes=1)
    assert solved.search is not None
    assert solved.search.ended == "nodes"
    assert (solved.timetable.levels, solved.lower_bound, solved.optimal) == (40, 39, False)
    assert solved.gap == pytest.approx(1 / 39)


def test_a_search_whose_time_is_over_stops() -> None:
    assert Limits(10**9, 5.0, lambda: 6.0).reached(256) == "seconds"
    assert Limits(10**9, 5.0, lambda: 4.0).reached(256) is None
    assert Limits(300, 5.0, lambda: 4.0).reached(300) == "nodes"


@both
def test_the_way_a_search_goes_is_always_the_same(method: Method) -> None:
    graph = some_graph(5, 40)
    first, second = (solve(graph, Machine(3), method, seconds=FOR_EVER, nodes=2000) for _ in range(2))
    assert first.timetable == second.timetable
    assert first.search == second.search


@both
def test_what_the_searches_refuse(method: Method) -> None:
    with pytest.raises(InputError, match="equal length"):
        solve(some_graph(1, 9, 3), Machine(2), method)
    with pytest.raises(InputError, match="no time to pass a value"):
        solve(some_graph(1, 9), Machine(2, 1, False), method)
