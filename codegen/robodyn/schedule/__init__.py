"""Parallel dynamics: tasks, what must be done before what, which tasks an arm spares, schedules."""

from robodyn.schedule.elimination import Sparsity, general_graph, robot_graph, sparsity
from robodyn.schedule.graph import TaskGraph, arm_graph
from robodyn.schedule.heuristics import Schedule, critical_path_order, list_schedule, thesis_order
from robodyn.schedule.tasks import FLOPS_PER_TASK, TASKS, Task

__all__ = [
    "FLOPS_PER_TASK",
    "TASKS",
    "Schedule",
    "Sparsity",
    "Task",
    "TaskGraph",
    "arm_graph",
    "critical_path_order",
    "general_graph",
    "list_schedule",
    "robot_graph",
    "sparsity",
    "thesis_order",
]
