"""The graph of Table 4.1's tasks: how many, the longest chain, what is taken out, the layers."""

from __future__ import annotations

import pytest

from dynamics.direct import with_named_numbers
from robodyn import InputError
from robodyn.robot import Robot, load
from robodyn.schedule import TASKS, Sparsity, TaskGraph, arm_graph, general_graph, robot_graph, sparsity
from robodyn.schedule.elimination import eliminated, left_out, sparse_tasks
from robodyn.schedule.graph import task_id
from robodyn.thesis.printed import TABLE_4_4

#: What the rules of Tables 4.2, 4.4 (as printed) and 4.5 leave of the Stanford arm's tasks, transcribed.
STANFORD = {
    1: "10 19 22-25 28-32 35 37-43",
    2: "1-11 16-19 24-32 35 38-43",
    3: "3 6 18 19 24-32 38-43",
    4: "1-11 18 19 22-32 37-43",
    5: "1-11 18 19 22-32 37-43",
    6: "1-11 18 19 24-29 38 41-43",
}


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def spread(text: str) -> set[int]:
    found: set[int] = set()
    for part in text.split():
        first, _, last = part.partition("-")
        found |= set(range(int(first), int(last or first) + 1))
    return found


def test_tasks_are_numbered_in_order_and_wait_for_earlier_layers() -> None:
    assert [task.row for task in TASKS] == list(range(1, 44))
    assert [task.forward for task in TASKS] == [True] * 25 + [False] * 18
    for task in TASKS:
        for place, number in task.after:
            other = TASKS[number - 1]
            if place == 0 and other.forward == task.forward:
                assert other.layer < task.layer
            assert (place == -1) <= task.forward
            assert (place == 1) <= (not task.forward)


@pytest.mark.parametrize("n", [2, 3, 6, 12])
def test_43_n_less_27_tasks_and_4_n_and_3_layers(n: int) -> None:
    graph = general_graph(n)
    assert len(graph) == 43 * n - 27
    assert graph.critical_path == 4 * n + 3
    assert len(graph.layers()) == 4 * n + 3
    assert sum(map(len, graph.layers())) == len(graph)


def test_what_a_task_waits_for_where_nothing_is_taken_out() -> None:
    graph = arm_graph(3)
    assert len(graph) == 129
    assert graph.after[201] == {101, 102, 103}
    assert graph.after[120] == {109, 110, 111}
    assert graph.after[230] == {332}
    assert graph.after[330] == graph.after[101] == frozenset()
    assert graph.before()[206] >= {304, 305, 210, 227}


def test_what_waited_for_a_task_taken_out_waits_for_what_it_waited_for() -> None:
    graph = arm_graph(2, without={106, 103, 104})
    assert 106 not in graph.after
    assert graph.after[110] == {101, 102, 105, 107}
    graph = arm_graph(3, without={209, 210, 211}, prismatic={2})
    assert graph.after[312] == {109, 110, 111}  # lambda is handed on
    assert arm_graph(3, without={209, 210, 211}).after[312] == {206, 207, 208}
    assert arm_graph(2, without={109, 110, 111}, prismatic={1}).after[212] == frozenset()


def test_a_graph_of_nothing() -> None:
    empty = TaskGraph({}, {})
    assert (len(empty), empty.critical_path, empty.width(), empty.layers()) == (0, 0, 0, [])
    with pytest.raises(InputError, match="without joints"):
        arm_graph(0)


# --- the Stanford arm ---------------------------------------------------------------------------------------


def test_the_stanford_arms_tasks_by_the_printed_rules() -> None:
    graph = robot_graph(bundled("stanford"), TABLE_4_4, "own")
    expected = {task_id(link, number) for link, text in STANFORD.items() for number in spread(text)}
    assert set(graph.tasks) == expected
    assert (len(graph), graph.critical_path, graph.width()) == (154, 25, 9)


def test_the_stanford_arms_tasks_by_its_own_zeros() -> None:
    robot = bundled("stanford")
    named = with_named_numbers(robot, lambda name: name.startswith("com_x"))
    assert sparsity(named).s[1] == "xz"  # what is known at run time only counts as there
    pattern = sparsity(robot)
    assert pattern == Sparsity(("yz", "z", "z", "yz", "y", "z"), ("y", "y", "", "", "", ""))
    assert pattern.zeros == 26
    graph = robot_graph(robot)
    assert (len(graph), graph.critical_path) == (153, 25)
    assert {316, 317} <= set(graph.tasks)  # step 3 of link 3 reads p_2
    assert not {316, 317} & set(robot_graph(robot, step_3="own").tasks)


@pytest.mark.parametrize("name", ["puma560", "panda"])
def test_an_arm_has_no_more_tasks_than_the_general_one(name: str) -> None:
    robot = bundled(name)
    graph = robot_graph(robot)
    assert set(graph.tasks) < set(general_graph(robot.n).tasks)
    assert graph.critical_path <= 4 * robot.n + 3


def test_the_sparsity_rule() -> None:
    assert left_out((12, 13, 14, 15, 16, 17), 1) == (12, 13)
    assert left_out((33, 34, 35), 2) == (33, 34)
    assert left_out((33, 34, 35), 0) == ()
    pattern = Sparsity(("x", "xyz"), ("xz", ""))
    assert sparse_tasks(pattern, 1) == {12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 33, 36, 37}
    assert sparse_tasks(pattern, 2) == {12, 13, 33, 34, 35}
    assert sparse_tasks(pattern, 2, "own") == {12, 13, 14, 15, 16, 17, 33, 34, 35}
    assert eliminated(1) >= {101, 130}
