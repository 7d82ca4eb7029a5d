"""The 43 tasks of Table 4.1 as a program: what each of them computes on a robot, operation by operation.

The tasks are those that do any arithmetic on that robot, and wait for those whose values they read. The rules
of Tables 4.2 and 4.5 say almost the same: they keep a few tasks that have nothing to do, count products with
zeros and their sums as fewer, fuller tasks, and know nothing of rotors and friction, which are part of a
joint's last task here.
"""

from __future__ import annotations

from itertools import count
from typing import Any, Final

from robodyn.drives.drive import has_drive_effects
from robodyn.dynamics.arm import JointAngle, build_arm, build_motion
from robodyn.dynamics.joints import joint_torque
from robodyn.dynamics.vectors import unmarked
from robodyn.errors import InputError
from robodyn.ir.fingerprint import agree
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Label, Program
from robodyn.optimize.programs import Choice, build, exact, turned
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point
from robodyn.schedule.arithmetic import run_tasks
from robodyn.schedule.cutting import Cut
from robodyn.schedule.graph import TaskGraph, TaskId, link_and_number, stacked_layer, task_id

#: The tasks that make the force and the moment of a link, along the joint's axis.
_MOMENT, _FORCE = 43, 32

_REMEDY: Final = "cut the kernel itself: --cut 3"


def task_program(robot: Robot) -> Cut:
    """The tasks of ``robot`` and the program that they are together.

    Raises
    ------
    InputError: the tasks are not cut for this robot, which has other than right angles between its axes,
        products of inertia, or effects in its joints.
    """
    if has_drive_effects(robot):
        raise InputError(
            f"{robot.name} has effects in its joints, and Table 4.1 knows of none", remedy=_REMEDY
        )
    graph = Graph()
    inputs = {name: [graph.input(name, i) for i in range(robot.n)] for name in ("q", "qd", "qdd")}
    arm = build_arm(robot, exact, graph.input)

    def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
        return turned(graph, inputs["q"], angle)

    motion = build_motion(arm, inputs["q"], inputs["qd"], inputs["qdd"], trigonometry, exact)
    graph.labels.clear()
    begun: list[tuple[int, TaskId]] = []
    links = run_tasks(arm, motion, lambda task: begun.append((len(graph.keys), task)))
    torques = []
    for i, (body, link) in enumerate(zip(arm.bodies, links, strict=True)):
        begun.append((len(graph.keys), task_id(i + 1, _MOMENT if body.revolute else _FORCE)))
        axial = link.n[2] if body.revolute else link.f[2]
        torques.append(joint_torque(arm, i, motion, axial, unmarked))
    _label(graph, begun)
    program = lower(graph, [("tau", torques)])
    _check(robot, program)
    return _cut(robot.n, program)


def _label(graph: Graph, begun: list[tuple[int, TaskId]]) -> None:
    """Every position is labelled with the task during which it was made."""
    ends = [position for position, _ in begun[1:]] + [len(graph.keys)]
    serial: dict[TaskId, count[int]] = {}
    for (start, task), end in zip(begun, ends, strict=True):
        link, task_number = link_and_number(task)
        for position in range(start, end):
            if graph.keys[position][0] not in ("input", "const"):
                which = next(serial.setdefault(task, count(1)))
                graph.labels[position] = Label(link, f"T{task_number}_", str(which))


def _check(robot: Robot, program: Program) -> None:
    """The program is the robot's inverse dynamics, seen in a finite field."""
    plain = build(robot, "inverse_dynamics", Choice("newton_euler", regroup=False, chains=False))
    if not agree(program, plain, circle_point):
        raise InputError(
            f"the tasks of Table 4.1 are not cut for {robot.name}",
            expected="angles alpha of multiples of 90 degrees and tensors of inertia without products",
            remedy=_REMEDY,
        )


def _cut(n: int, program: Program) -> Cut:
    task_of: list[TaskId] = []
    for operation in program.operations:
        if operation.label is not None:
            task_of.append(_task(operation.label))
        else:  # a sine of before all tasks, or a change of sign, which goes with what it changes
            predecessors = [task_of[arg] for arg in operation.args if isinstance(arg, int)]
            task_of.append(predecessors[0] if predecessors else 0)
    after: dict[TaskId, set[TaskId]] = {task: set() for task in sorted(set(task_of) - {0})}
    for own, operation in zip(task_of, program.operations, strict=True):
        if own:
            after[own] |= {task_of[arg] for arg in operation.args if isinstance(arg, int)} - {0, own}
    graph = TaskGraph(
        {task: frozenset(needed) for task, needed in after.items()},
        {task: stacked_layer(n, task) for task in after},
    )
    return Cut(program, graph, tuple(task_of))


def _task(label: Label) -> TaskId:
    return task_id(label.link, int(label.quantity.strip("T_")))
