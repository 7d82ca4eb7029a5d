"""The tasks that an arm does not need: the thesis's rules, and the sparsity that they ask about.

``s_i`` is the centre of mass of link i, ``p_i`` the origin of the next frame, both in link i's frame. Source:
Dhanaraj 1990, Tables 4.2, 4.4 and 4.5 and sections 4.3.1 and 4.3.2.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final, Literal

from robodyn.dynamics.arm import build_arm, origin
from robodyn.dynamics.vectors import AXES, Vector
from robodyn.optimize.programs import exact
from robodyn.robot.model import Robot
from robodyn.schedule.friction_tasks import Friction, friction_of, friction_tasks
from robodyn.schedule.graph import TaskGraph, TaskId, arm_graph, task_id

#: Table 4.2: what is not done for the first link, for the last one, behind a prismatic joint.
FIRST_LINK: Final = frozenset((*range(1, 10), *range(11, 19), 26, 27))
_FORCE: Final = frozenset({26})
LAST_LINK: Final = frozenset((*range(30, 36), 39, 40))
PRISMATIC: Final = frozenset((1, 2, 4, 5, *range(7, 12)))

STEP_3: Final = (12, 13, 14, 15, 16, 17)
STEP_4: Final = (20, 21, 22, 23, 24, 25)
P_CROSS_F: Final = (33, 34, 35)
S_CROSS_F: Final = (36, 37, 38)

#: Table 4.5: of a step's tasks so many at the front are not done where the vector has 0, 1, 2, 3 zeros.
_LEFT_OUT: Final = {6: (0, 2, 4, 6), 3: (0, 1, 2, 3)}

#: Whose ``p`` decides on step 3 of link i, which computes ``lambda_{i-1} p_{i-1}``: ``"own"`` is p_i, as
#: Table 4.6 has it, ``"before"`` is p_{i-1}, as the step reads.
StepThree = Literal["before", "own"]


def left_out(tasks: tuple[int, ...], zeros: int) -> tuple[int, ...]:
    """Of a step's ``tasks`` those that Table 4.5 leaves out where its vector has so many ``zeros``."""
    return tasks[: _LEFT_OUT[len(tasks)][zeros]]


@dataclass(frozen=True, slots=True)
class Sparsity:
    """Which components are there, ``"yz"`` or ``""``: ``s[i]`` and ``p[i]`` of link i + 1."""

    s: tuple[str, ...]
    p: tuple[str, ...]

    @property
    def zeros(self) -> int:
        """Components that are zero, of ``6 n``."""
        return sum(3 - len(axes) for axes in (*self.s, *self.p))


class _Some:
    """A number that is not zero, or need not be."""

    def __mul__(self, other: Any) -> Any:
        return 0 if other == 0 else self

    def __neg__(self) -> _Some:
        return self

    def __add__(self, other: Any) -> _Some:
        return self

    __rmul__ = __mul__
    __radd__ = __add__


def sparsity(robot: Robot) -> Sparsity:
    """Which components of the arm's position vectors are there; the last link has no next origin, and a
    number that is given at run time is taken for one that is there."""
    arm = build_arm(robot, exact, lambda _: _Some())
    beyond: list[Vector] = [origin(body, body.d if body.revolute else _Some()) for body in arm.bodies[1:]] + [
        (0, 0, 0)
    ]
    return Sparsity(tuple(_there(body.com) for body in arm.bodies), tuple(map(_there, beyond)))


def _there(u: Vector) -> str:
    return "".join(axis for axis, x in zip(AXES, u, strict=True) if x != 0)


def sparse_tasks(pattern: Sparsity, link: int, step_3: StepThree = "before") -> frozenset[int]:
    """The tasks of ``link`` (from 1) that zeros of its position vectors spare (Table 4.5)."""
    s_zeros = 3 - len(pattern.s[link - 1])
    p_zeros = 3 - len(pattern.p[link - 1])
    if step_3 == "own":
        step_3_zeros = p_zeros
    else:
        step_3_zeros = 3 if link == 1 else 3 - len(pattern.p[link - 2])
    return frozenset(
        left_out(STEP_3, step_3_zeros)
        + left_out(STEP_4, s_zeros)
        + left_out(P_CROSS_F, p_zeros)
        + left_out(S_CROSS_F, s_zeros)
    )


def eliminated(
    n: int,
    prismatic: frozenset[int] = frozenset(),
    pattern: Sparsity | None = None,
    step_3: StepThree = "before",
    *,
    loaded: bool = False,
) -> frozenset[TaskId]:
    """The tasks that an arm of ``n`` joints does not need: ``prismatic`` ones numbered from 1, position
    vectors with the zeros of ``pattern`` (None: without any). ``loaded``: the first joint's bearing feels the
    force through it, of which F of the first link (T26) is part."""
    out: set[TaskId] = set()
    for link in range(1, n + 1):
        numbers: set[int] = set()
        if link == 1:
            numbers |= FIRST_LINK - _FORCE if loaded else FIRST_LINK
        if link == n:
            numbers |= LAST_LINK
        if link in prismatic:
            numbers |= PRISMATIC
        if pattern is not None:
            numbers |= sparse_tasks(pattern, link, step_3)
        out |= {task_id(link, task_number) for task_number in numbers}
    return frozenset(out)


def prismatic_joints(robot: Robot) -> frozenset[int]:
    """The numbers (from 1) of the robot's prismatic joints."""
    return frozenset(i for i, link in enumerate(robot.links, 1) if link.joint.kind == "prismatic")


def general_graph(n: int, friction: Friction | None = None) -> TaskGraph:
    """The graph of any revolute arm of ``n`` joints: ``43 n - 27`` tasks from two joints on, and those of
    ``friction`` where all joints have it."""
    if friction is None:
        return arm_graph(n, eliminated(n))
    tasks = friction_tasks(friction)
    out = eliminated(n, loaded=friction.loaded)
    return arm_graph(n, out, besides=dict.fromkeys(range(1, n + 1), tasks))


def robot_graph(
    robot: Robot,
    pattern: Sparsity | None = None,
    step_3: StepThree = "before",
    friction: Mapping[int, Friction] | None = None,
) -> TaskGraph:
    """The graph of ``robot``, customised by its joints and by the zeros of its position vectors, or of
    ``pattern`` in their place; with the tasks of ``friction`` by joint from 1, of what its description has
    where that is None."""
    prismatic = prismatic_joints(robot)
    rubbing = friction_of(robot) if friction is None else friction
    out = eliminated(
        robot.n,
        prismatic,
        sparsity(robot) if pattern is None else pattern,
        step_3,
        loaded=1 in rubbing and rubbing[1].loaded,
    )
    besides = {joint: friction_tasks(one, revolute=joint not in prismatic) for joint, one in rubbing.items()}
    return arm_graph(robot.n, out, prismatic, besides=besides)
