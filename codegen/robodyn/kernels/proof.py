"""No program leaves that does not equal plain Newton-Euler: looked at each time, without rounding."""

from __future__ import annotations

from robodyn.dynamics.equality import same_in_field
from robodyn.ir.program import Program
from robodyn.robot.model import Robot


class Unequal(AssertionError):
    """A program does not compute what it should: a defect of robodyn, never of its input."""


def prove(robot: Robot, function: str, program: Program) -> None:
    """Compare ``program`` with the plain recursion at a point of a field that is drawn from both.

    Raises
    ------
    Unequal: they differ.
    """
    if not same_in_field(robot, function, program):
        raise Unequal(
            f"{function} of {robot.name} differs from plain Newton-Euler; please report the robot file"
        )
