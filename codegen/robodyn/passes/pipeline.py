"""Running passes, each checked: after every one the program must mean exactly what it meant before."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from robodyn.ir.evaluate import fingerprint
from robodyn.ir.program import Program
from robodyn.robot.values import circle_point

Pass = Callable[[Program], Program]


class PassError(AssertionError):
    """A pass changed what a program computes: a defect of robodyn, never of its input."""


def run(program: Program, passes: Sequence[Pass], *, seed: int = 1) -> Program:
    """``program`` after ``passes``, compared exactly (over GF(2^61 - 1)) after each."""
    if not passes:
        return program
    meaning = fingerprint(program, seed, circle_point)
    for step in passes:
        program = step(program)
        if fingerprint(program, seed, circle_point) != meaning:
            raise PassError(f"pass {step.__module__} changed the program; please report the robot file")
    return program
