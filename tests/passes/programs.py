"""What the tests of the passes share: programs, and ways to look at them."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from typing import Any

from hypothesis import reject

from dynamics.direct import exact_arm
from ir.programs import Point, results
from robodyn import load
from robodyn.dynamics.functions import by_default
from robodyn.ir import Program
from robodyn.kernels.generate import SingularArm
from robodyn.optimize.programs import Choice, build

CHOICES = (Choice(), Choice(regroup=False, chains=False), Choice("newton_euler", regroup=False, chains=False))


def name_of(value: Any) -> str:
    return getattr(value, "__name__", str(value))


def real_programs() -> list[Program]:
    """Programs as the recursions leave them."""
    found = []
    robots = [load("stanford_3dof"), exact_arm(3, joints=4), exact_arm(5, joints=3, prismatic=0.7)]
    for robot in robots:
        for choice in CHOICES:
            for function in by_default():
                try:
                    found.append(build(robot, function, choice))
                except (SingularArm, ZeroDivisionError):
                    assert function == "forward_dynamics"
    return found


REAL = real_programs()


def ops(made: Program) -> Counter[str]:
    return Counter(op.op for op in made.operations)


def check_straight(made: Program) -> None:
    """Each operation uses only what stands before it."""
    for i, operation in enumerate(made.operations):
        assert all(0 <= arg < i for arg in operation.args if isinstance(arg, int))
    assert all(0 <= x < len(made.operations) for x in made.results() if isinstance(x, int))


def results_or_reject(made: Program, at: Point) -> list[Fraction]:
    try:
        return results(made, at)
    except ZeroDivisionError:
        reject()
