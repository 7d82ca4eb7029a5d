"""Running passes, checked: the program must mean exactly what it meant before them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from robodyn.ir.evaluate import fingerprint
from robodyn.ir.program import Program
from robodyn.robot.values import circle_point

Pass = Callable[[Program], Program]


class PassError(AssertionError):
    """A pass changed what a program computes: a defect of robodyn, never of its input."""


def run(program: Program, passes: Sequence[Pass], *, seed: int = 1) -> Program:
    """``program`` after ``passes``, which must mean exactly what it meant (over GF(2^61 - 1)).

    The end is compared with the beginning; where they differ, the passes run again one by one to name
    the one that went wrong.
    """
    meaning = fingerprint(program, seed, circle_point)
    result = program
    for step in passes:
        result = step(result)
    if fingerprint(result, seed, circle_point) == meaning:
        return result
    for step in passes:
        program = step(program)
        if fingerprint(program, seed, circle_point) != meaning:
            raise PassError(f"pass {step.__module__} changed the program; please report the robot file")
    raise PassError("the passes do not give the same program twice; please report the robot file")
