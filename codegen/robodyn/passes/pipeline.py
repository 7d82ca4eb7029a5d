"""Running passes, checked: the program must mean exactly what it meant before them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from robodyn.ir.fingerprint import agree
from robodyn.ir.program import Program
from robodyn.robot.values import circle_point

Pass = Callable[[Program], Program]


class PassError(AssertionError):
    """A pass changed what a program computes: a defect of robodyn, never of its input."""


def run(program: Program, passes: Sequence[Pass]) -> Program:
    """``program`` after ``passes``, which must mean exactly what it meant (in a field drawn from both).

    The end is compared with the beginning; where they differ, the passes run again one by one to name
    the one that went wrong.

    Raises
    ------
    ZeroDivisionError: a divisor is zero as a function.
    """
    result = program
    for step in passes:
        result = step(result)
    if agree(result, program, circle_point):
        return result
    before = program
    for step in passes:
        after = step(before)
        if not agree(after, before, circle_point):
            raise PassError(f"pass {step.__module__} changed the program; please report the robot file")
        before = after
    raise PassError("the passes do not give the same program twice; please report the robot file")
