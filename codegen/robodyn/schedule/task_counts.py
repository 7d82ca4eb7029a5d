"""What each of the 43 tasks costs: they are carried out over numbers that count what is done to them."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from robodyn.counts.general import Tally
from robodyn.dynamics.arm import Arm, Body, Motion, Symmetric
from robodyn.dynamics.vectors import AXES, Vector
from robodyn.robot.values import quarter_turns
from robodyn.schedule.arithmetic import run_tasks
from robodyn.schedule.graph import TaskId


def flops_of_tasks(
    n: int, prismatic: Collection[int] = (), *, s: str = "xyz", p: str = "xyz"
) -> dict[TaskId, int]:
    """Multiplications and additions of each task, together; see :func:`operations_of_tasks`."""
    by_task = operations_of_tasks(n, prismatic, s=s, p=p)
    return {task: sum(kinds.values()) for task, kinds in by_task.items()}


def operations_of_tasks(
    n: int, prismatic: Collection[int] = (), *, s: str = "xyz", p: str = "xyz"
) -> dict[TaskId, dict[str, int]]:
    """Operations of each task by kind, ``{"mul": 2, "add": 1}``, on an arm of ``n`` joints (``prismatic``
    ones numbered from 1), the base at rest, the first axis upright and nothing carried.

    All numbers of the model are some number that is not zero, but for the components of the centres of mass
    and of the origins that ``s`` and ``p`` do not name.
    """
    ledger: dict[str, int] = {}
    by_task: dict[TaskId, dict[str, int]] = {}

    def fixed() -> Any:
        return Tally(ledger, True)

    def vector(axes: str) -> Vector:
        x, y, z = (fixed() if axis in axes else 0 for axis in AXES)
        return x, y, z

    def body(joint: int) -> Body:
        cos_alpha, sin_alpha = (1, 0) if joint == 1 else (0, 1)
        return Body(
            joint not in prismatic, cos_alpha, sin_alpha, fixed(), fixed(), quarter_turns(0), fixed(),
            vector(s), Symmetric(fixed(), fixed(), fixed(), 0, 0, 0), motor_inertia=0, viscous=0, coulomb=0,
        )  # fmt: skip

    bodies = tuple(map(body, range(1, n + 1)))
    c, sine, d, qd, qdd = (tuple(Tally(ledger) for _ in bodies) for _ in range(5))
    motion = Motion(
        tuple(x if body.revolute else 1 for x, body in zip(c, bodies, strict=True)),
        tuple(x if body.revolute else 0 for x, body in zip(sine, bodies, strict=True)),
        d, qd, qdd,
    )  # fmt: skip
    current: list[TaskId] = []

    def book(task: TaskId) -> None:
        if current:
            by_task[current.pop()] = dict(ledger)
        ledger.clear()
        current.append(task)

    arm = Arm(bodies, (0, 0, fixed()), rest_velocity=None)
    run_tasks(arm, motion, book, origins=[vector(p) for _ in bodies])
    book(0)
    return dict(sorted(by_task.items()))
