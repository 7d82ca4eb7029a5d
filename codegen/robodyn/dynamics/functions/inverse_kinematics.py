"""Inverse kinematics: the joint positions that bring the tool to a pose, all branches or the nearest.

How they are solved for is in :mod:`robodyn.dynamics.inverse`. Flags are numbers, 0 or 1: all that a kernel
takes and gives is of one type (docs/decisions/0034).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.functions.record import NEAR, POSE, Answers, Array, Function
from robodyn.dynamics.state import Dynamics
from robodyn.dynamics.vectors import flat

if TYPE_CHECKING:
    from robodyn.dynamics.arm import Arm
    from robodyn.dynamics.inverse import Inverse, Nearest, Numerical, Solved
    from robodyn.dynamics.state import Iterative

SOLUTIONS = Array("solutions", "joint positions, a row for each branch", "rad", "m", shape=("b", "n"))
EXISTS = Array(
    "exists",
    "1 for a branch that reaches the pose; 0 where its row is the nearest that it comes",
    "", shape=("b",), says="truth",
)  # fmt: skip
WITHIN = Array("within", "1 for a row within the joints' limits, else 0", "", shape=("b",), says="truth")
SINGULAR = Array(
    "singular", "1 for a branch that meets another or leaves a joint free", "", shape=("b",), says="truth"
)
COUNT = Array("solution_count", "how many branches reach the pose", "", shape=(), says="count")
PLACED = Array(
    "placed", "1 for a branch that reaches the tool's place, if not its rotation", "", shape=("t",),
    says="truth",
)  # fmt: skip
OFF = Array("off", "by what angle a branch misses the tool's rotation", "rad", shape=("t",))

SOLUTION = Array("solution", "joint positions", "rad", "m")
REACHED = Array(
    "solution_exists", "1 where they reach the pose, 0 where they are the nearest to it", "", shape=(),
    says="truth",
)  # fmt: skip
ALLOWED = Array(
    "solution_within", "1 where they are within the joints' limits, else 0", "", shape=(), says="truth"
)
MEETING = Array(
    "solution_singular", "1 where two branches meet or a joint is free, else 0", "", shape=(), says="truth"
)
BRANCH = Array("branch", "which branch it is, from 0", "", shape=(), says="count")


def _closed_form(at: Dynamics) -> Inverse:
    from robodyn.dynamics.inverse import inverse_of

    return inverse_of(at.arm, [body.limits for body in at.arm.bodies])


def _numerical(arm: Arm) -> Numerical | None:
    from robodyn.dynamics.inverse import Numerical, solver_of

    solver = solver_of(arm)
    return solver if isinstance(solver, Numerical) else None


def _rows(solved: Solved) -> Sequence[Any]:
    flags = (*solved.exists, *solved.within, *solved.singular)
    return [*flat(solved.solutions), *flags, sum(solved.exists), *solved.placed, *solved.off]


def _all_branches(at: Dynamics) -> Sequence[Any]:
    return _rows(_closed_form(at).solve(at.inputs["T"], at.inputs["q_near"], at.rounding))


def _approached(arm: Arm) -> Iterative | None:
    solver = _numerical(arm)
    return None if solver is None else solver.approach(lambda at, solved: _rows(solved))


def _one(nearest: Nearest) -> Sequence[Any]:
    return [*nearest.solution, *nearest[1:]]


def _nearest(at: Dynamics) -> Sequence[Any]:
    return _one(_closed_form(at).nearest(at.inputs["T"], at.inputs["q_near"], at.rounding))


def _nearest_approached(arm: Arm) -> Iterative | None:
    solver = _numerical(arm)
    if solver is None:
        return None
    return solver.approach(lambda at, solved: _one(solver.nearest(solved, at.inputs["q_near"], at.rounding)))


FUNCTIONS = (
    Function(
        "inverse_kinematics",
        "joint positions that bring the tool to a pose, in all branches",
        (POSE, NEAR),
        (SOLUTIONS, EXISTS, WITHIN, SINGULAR, COUNT, PLACED, OFF),
        _all_branches,
        geometric=True,
        iterative=_approached,
        answers=Answers("solutions", "exists", "within", "singular"),
        emitted="inverse_kinematics_branches",
    ),
    Function(
        "nearest_inverse_kinematics",
        "joint positions that bring the tool to a pose, of the branch nearest to a reference",
        (POSE, NEAR),
        (SOLUTION, REACHED, ALLOWED, MEETING, BRANCH),
        _nearest,
        geometric=True,
        iterative=_nearest_approached,
        answers=Answers("solution", "solution_exists", "solution_within", "solution_singular", "branch"),
    ),
)
