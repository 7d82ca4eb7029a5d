"""Running passes, checked: the program must mean exactly what it meant before them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from robodyn.ir.fingerprint import agree
from robodyn.ir.program import Program
from robodyn.robot.values import circle_point

Pass = Callable[[Program], Program]


#: What passes do is compared modulo one prime, at points drawn from the programs: a program that is made
#: against the prime could hide a mistake of ours, which the comparison with the recursion finds.
_PRIME = b"passes"


class PassError(AssertionError):
    """A pass changed what a program computes: a defect of robodyn, never of its input."""


def unchecked(program: Program, passes: Sequence[Pass]) -> Program:
    """``program`` after ``passes``, for those who compare the result themselves."""
    for step in passes:
        program = step(program)
    return program


def run(program: Program, passes: Sequence[Pass]) -> Program:
    """``program`` after ``passes``, which must mean exactly what it meant (at a point drawn from both).

    The end is compared with the beginning; where they differ, the passes run again one by one to name
    the one that went wrong.

    Raises
    ------
    ZeroDivisionError: a divisor is zero as a function.
    """
    result = unchecked(program, passes)
    if agree(result, program, circle_point, prime_of=_PRIME):
        return result
    before = program
    for step in passes:
        after = step(before)
        if not agree(after, before, circle_point, prime_of=_PRIME):
            raise PassError(f"pass {step.__module__} changed the program; please report the robot file")
        before = after
    raise PassError("the passes do not give the same program twice; please report the robot file")
