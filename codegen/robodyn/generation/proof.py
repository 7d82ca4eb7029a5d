"""No program leaves that does not equal plain Newton-Euler: looked at each time, on exact fractions."""

from __future__ import annotations

from robodyn.dynamics.equality import equals_recursion
from robodyn.dynamics.functions import Choice, build
from robodyn.ir.evaluate import fingerprint
from robodyn.ir.program import Program
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

#: Fractions of longer arms have thousands of digits; these are compared in GF(2^61 - 1).
_SHORT = 12


class Unequal(AssertionError):
    """A program does not compute what it should: a defect of robodyn, never of its input."""


def prove(robot: Robot, function: str, program: Program) -> None:
    """Compare ``program`` with the plain recursion at a random rational point.

    Friction smoothed at rest has no exact value; then, and on long arms, the finite field is used.

    Raises
    ------
    Unequal: they differ.
    """
    if not _equal(robot, function, program):
        raise Unequal(
            f"{function} of {robot.name} differs from plain Newton-Euler; please report the robot file"
        )


def _equal(robot: Robot, function: str, program: Program) -> bool:
    if robot.n <= _SHORT:
        try:
            return equals_recursion(robot, function, program, points=1)
        except ValueError:  # tanh
            pass
    plain = build(robot, function, Choice("newton_euler", regroup=False, chains=False))
    return all(
        fingerprint(program, seed, circle_point) == fingerprint(plain, seed, circle_point) for seed in (3, 4)
    )
