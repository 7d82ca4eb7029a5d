"""Table 4.1: its tasks carried out in an order that the printed predecessors allow and the right ones do not.

The order of :func:`robodyn.schedule.arithmetic.one_after_another` respects the right predecessors.
Source: Dhanaraj 1990, Table 4.1.
"""

from __future__ import annotations

from typing import Any

from robodyn.schedule.arithmetic import one_after_another, run_tasks
from robodyn.schedule.graph import TaskId, task_id
from robodyn.thesis.slips.comparison import Comparison, compared
from robodyn.thesis.slips.recursion import bundled, newton_euler, scalars, stacked, states

ROBOT = "puma560_d2"


def _torques(order: list[TaskId] | None) -> Any:
    robot = bundled(ROBOT)
    links = run_tasks(*scalars(robot, states(robot)), order=order)
    return stacked([link.n[2] for link in links])


def _in_order(order: list[TaskId]) -> Comparison:
    against = f"torques by Newton-Euler of {ROBOT}, 1000 states"
    return compared(_torques(order), _torques(None), newton_euler(ROBOT), "N m", against)


def _moved(tasks: list[int], anchor: int, place: int) -> list[TaskId]:
    """The usual order with ``tasks`` of every link right before the task ``anchor`` of the link at
    ``place`` (-1 the one before, 0 its own)."""
    robot = bundled(ROBOT)
    arm, _ = scalars(robot, states(robot))
    order = one_after_another(arm)
    for link in range(1 - place, robot.n + 1):
        for task_number in tasks:
            order.remove(task_id(link, task_number))
        at = order.index(task_id(link + place, anchor))
        order[at:at] = [task_id(link, task_number) for task_number in tasks]
    return order


def before_alpha() -> Comparison:
    """T4 and T5 after a task T_0 that there is not: before T6 of the link before."""
    return _in_order(_moved([4, 5], 6, -1))


def moments_before_products() -> Comparison:
    """T41 to T43 after T40 "to T40" only: before the products T33 to T38 and T39."""
    return _in_order(_moved([40, 41, 42, 43], 33, 0))
