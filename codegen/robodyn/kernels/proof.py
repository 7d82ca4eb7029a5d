"""No program leaves that differs from plain Newton-Euler, looked at each time without rounding, or from plain
forward kinematics, to 60 digits."""

from __future__ import annotations

from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import function_named
from robodyn.dynamics.state import NoSuchFunction
from robodyn.ir.program import Program
from robodyn.ir.signature import ScalarType
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot.model import Robot


class Unequal(AssertionError):
    """A program does not compute what it should: a defect of robodyn, never of its input."""


def prove(robot: Robot, function: str, program: Program, scalar: ScalarType = "double") -> None:
    """Compare ``program`` with the plain recursion at a point of a field that is drawn from both; what is of
    a pose with plain forward kinematics, at positions that are drawn so; ``scalar`` is what that is for.

    Raises
    ------
    Unequal: they differ.
    NoSuchFunction: ``program`` repeats a step, and no pose that it was tried at is reached.
    """
    wrong: str | None = "from plain Newton-Euler"
    if function_named(function).of_pose:
        from robodyn.dynamics.closure import UNREACHED

        flaw = _flaw(robot, function, program, scalar)
        if flaw == UNREACHED and program.iteration is not None:
            why = "; ".join(inverse_kinematics_of(robot).conditions)
            raise NoSuchFunction(
                f"{robot.name} has no {function} that could be checked",
                found=f"steps that lead to none of the poses they were tried at: {why}",
                expected="axes that move the tool in all directions, not only by how they miss each other",
            )
        wrong = None if flaw is None else f"from plain forward kinematics {flaw}"
    elif same_in_field(robot, function, program):
        wrong = None
    if wrong is not None:
        raise Unequal(f"{function} of {robot.name} differs {wrong}; please report the robot file")


def closes(robot: Robot, function: str, program: Program, scalar: ScalarType = "double") -> bool:
    """Whether ``program``, of poses, leads back to them in plain forward kinematics."""
    return _flaw(robot, function, program, scalar) is None


def _flaw(robot: Robot, function: str, program: Program, scalar: ScalarType) -> str | None:
    from robodyn.dynamics.closure import BESIDE, flaw
    from robodyn.dynamics.inverse import Numerical
    from robodyn.dynamics.inverse.limits import WEAK_NEAR

    solver = inverse_kinematics_of(robot)
    beside = WEAK_NEAR if isinstance(solver, Numerical) and solver.weak else BESIDE
    return flaw(robot, function, program, scalar, place_only=solver.place_only, beside=beside)
