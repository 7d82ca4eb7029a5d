"""The 43 tasks carried out: Newton-Euler's torques, in any order that the graph allows, three flops each."""

from __future__ import annotations

import random

import pytest

from dynamics.direct import State, exact_arm
from ir.programs import Point
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.robot import Robot
from robodyn.schedule import FLOPS_PER_TASK, TASKS, arm_graph
from robodyn.schedule.arithmetic import flops_of_tasks, one_after_another, run_tasks
from robodyn.schedule.graph import TaskGraph, TaskId, link_and_number


def right_angled(seed: int, prismatic: float, **more: float) -> Robot:
    """An arm as the tasks are cut for: right angles, diagonal tensors, nothing in the joints."""
    return exact_arm(
        seed, joints=2 + seed % 4, full=False, generic_angles=0, motors=0, friction=0, exotic=0,
        prismatic=prismatic, **{"degenerate": 0.1, **more},
    )  # fmt: skip


MIXED = [right_angled(seed, 0.4) for seed in range(300, 306)]
REVOLUTE = [right_angled(seed, 0) for seed in range(320, 326)]
SOLID = right_angled(7, 0, degenerate=0, zeros=0)


def torques(robot: Robot, order: list[TaskId] | None = None) -> list[object]:
    state = State(robot, Point(5))
    links = run_tasks(state.arm, state.motion(), order=order)
    return [
        link.n[2] if body.revolute else link.f[2] for body, link in zip(state.arm.bodies, links, strict=True)
    ]


def expected(robot: Robot) -> list[object]:
    state = State(robot, Point(5))
    return newton_euler(state.arm, state.motion())


@pytest.mark.parametrize("robot", MIXED + REVOLUTE, ids=lambda robot: robot.name)
def test_the_tasks_add_up_to_newton_eulers_torques(robot: Robot) -> None:
    assert torques(robot) == expected(robot)


def shuffled(graph: TaskGraph, seed: int) -> list[TaskId]:
    """Some order of the tasks in which each comes after what it waits for."""
    rng = random.Random(seed)
    left, done, order = list(graph.tasks), set[TaskId](), list[TaskId]()
    while left:
        ready = [task for task in left if graph.after[task] <= done]
        task = rng.choice(ready)
        left.remove(task)
        done.add(task)
        order.append(task)
    return order


@pytest.mark.parametrize("robot", REVOLUTE, ids=lambda robot: robot.name)
def test_any_order_that_the_graph_allows_gives_the_same_torques(robot: Robot) -> None:
    """No predecessor is missing: what a task reads is there whenever its turn may come."""
    graph = arm_graph(robot.n)
    for seed in range(4):
        assert torques(robot, shuffled(graph, seed)) == expected(robot)


@pytest.mark.parametrize("number", [task.row for task in TASKS])
def test_a_task_that_is_carried_out_too_early_spoils_the_torques(number: int) -> None:
    moved = 300 + number
    order = one_after_another(State(SOLID, Point(5)).arm)
    assert torques(SOLID, order) == expected(SOLID)
    order.remove(moved)
    assert torques(SOLID, [moved, *order]) != expected(SOLID)


def test_every_task_of_a_link_between_takes_three_operations() -> None:
    flops = flops_of_tasks(6)
    for link in (3, 4, 5):
        assert {flops[100 * link + task.row] for task in TASKS} == {FLOPS_PER_TASK}


def test_zeros_are_seen() -> None:
    flops = flops_of_tasks(4, s="y", p="")
    own = {number: flops[300 + number] for number in (*range(12, 18), *range(20, 26), *range(33, 39))}
    assert sum(own[number] for number in (*range(12, 18), 33, 34, 35)) == 0
    assert sum(own[number] for number in range(20, 26)) == 6
    assert [own[number] for number in (36, 37, 38)] == [1, 0, 1]
    assert {link_and_number(task)[0] for task in flops} == {1, 2, 3, 4}
