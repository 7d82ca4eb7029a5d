"""Parallel dynamics: tasks, what must be done before what, which tasks an arm spares, machines, schedules."""

from robodyn.schedule.elimination import Sparsity, general_graph, robot_graph, sparsity
from robodyn.schedule.graph import TaskGraph, arm_graph, fewest_processors, lower_bound
from robodyn.schedule.heuristics import critical_path_order, list_schedule, thesis_order
from robodyn.schedule.machine import Machine, Placement, Schedule, Timetable
from robodyn.schedule.methods import METHODS, Method, Solved, solve
from robodyn.schedule.tasks import FLOPS_PER_TASK, TASKS, Task
from robodyn.schedule.validate import Fault, faults_of_levels, faults_of_times

__all__ = [
    "FLOPS_PER_TASK", "METHODS", "TASKS", "Fault", "Machine", "Method", "Placement", "Schedule", "Solved",
    "Sparsity", "Task", "TaskGraph", "Timetable", "arm_graph", "critical_path_order", "faults_of_levels",
    "faults_of_times", "fewest_processors", "general_graph", "list_schedule", "lower_bound", "robot_graph",
    "solve", "sparsity", "thesis_order",
]  # fmt: skip
