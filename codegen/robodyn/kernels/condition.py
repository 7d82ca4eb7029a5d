"""A program against the condition on its function, at 60 digits and more: for arms whose drives have effects.

What a function is equal to by another formula is compared in a finite field. Where there is no other formula,
as of derivatives and of what is solved for, the condition on the function says what is right, and it asks for
derivatives of torques, which the random functions of a field do not have. So it is evaluated here with
numbers of many digits, at a state drawn from a hash of robot and program: torques are those of plain
Newton-Euler with the drives on it, and their derivatives differences of these, right to more digits than are
compared.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any

from robodyn.drives.drive import Layer, layer_of, rigid_part
from robodyn.dynamics.arm import JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.base_set import BaseParameter
from robodyn.dynamics.functions import INPUTS, Rotor, function_named
from robodyn.dynamics.limits import PROVEN_DIGITS
from robodyn.dynamics.reference import PlainDynamics
from robodyn.dynamics.state import with_rotors
from robodyn.ir.digits import evaluate_to_digits, to_digits
from robodyn.ir.evaluate import turn
from robodyn.ir.fingerprint import digest
from robodyn.ir.program import Input, Program
from robodyn.kernels.with_effects import steady_torques
from robodyn.optimize.programs import base_set_of
from robodyn.robot.coupling import transmission_of
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot

#: Digits that are worked with, one after another: what cancels down to rounding with few of them, as numbers
#: of very different size do, is equal with more if it is right, and with none if it is wrong.
_WORKED_WITH = (PROVEN_DIGITS, 8 * PROVEN_DIGITS, 64 * PROVEN_DIGITS)
#: Inputs are drawn from so many numbers, up to 1; run-time parameters from half as far, as efficiencies are.
_RANGE = 1 << 32


def meets_condition(robot: Robot, function: str, program: Program) -> bool:
    """Whether ``program`` is ``function`` of ``robot``, by the condition on it.

    Raises
    ------
    ZeroDivisionError: what is solved for has no solution.
    """
    return any(_meets_condition(robot, function, program, digits) for digits in _WORKED_WITH)


def _meets_condition(robot: Robot, function: str, program: Program, digits: int) -> bool:
    """The same with numbers of so many ``digits``. A central difference loses as many of them to rounding as
    its step has, and is right to twice as many: with a third of them two thirds are right, of which half are
    compared; the rest is for numbers that cancel."""
    import mpmath

    chance = random.Random(f"{digest(program).hex()} {identity(robot)} {function}")

    def drawn() -> Any:
        return mpmath.mpf(chance.randint(_RANGE // 2, _RANGE)) / _RANGE

    with mpmath.workdps(digits):
        inputs = {
            Input(array.name, i): drawn() * chance.choice((-1, 1))
            for array in INPUTS
            for i in range(array.size_at(len(robot.commanded)))
        }
        inputs |= {Input(name, None): drawn() for name in robot.parameters}
        results = evaluate_to_digits(program, inputs)
        elements = [x for row in results.values() for x in row]
        anywhere = [drawn() for _ in robot.commanded]
        share = mpmath.mpf(10) ** -(digits // 3)
        reference = _ToDigits(robot, inputs, share)
        one, other = function_named(function).compared(reference, elements, anywhere)
        # Where all is 0 but for rounding, as Coriolis torques of one joint are, torques say what is small.
        torques = reference.torques(reference.inputs["qd"], reference.inputs["qdd"])
        size = max(abs(x) for x in (*one, *other, *torques, share))
        return all(abs(x - y) <= share * size for x, y in zip(one, other, strict=True))


class _ToDigits(PlainDynamics):
    """Newton-Euler with the drives on it over numbers of mpmath, effects that remember in their steady form;
    see :class:`robodyn.dynamics.state.ReferenceDynamics`. ``step``: that of differences."""

    def __init__(self, robot: Robot, inputs: dict[Input, Any], step: Any) -> None:
        self._robot, self._values, self._step = robot, inputs, step
        self.inputs = {
            array.name: [x for key, x in inputs.items() if key.is_of(array.name)] for array in INPUTS
        }
        self.rest = [0] * len(robot.commanded)
        self.transmission, self.number = transmission_of(robot) if robot.couplings else None, to_digits
        self._torques = steady_torques(robot.free)
        self._parameters = {key: x for key, x in inputs.items() if key.index is None}
        self.arm = build_arm(rigid_part(robot.free), to_digits, self._parameter)

    def _parameter(self, name: str) -> Any:
        return self._values[Input(name, None)]

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""
        import mpmath

        q, qd, qdd = self.joint_positions(), self.spread(qd), self.spread(qdd)

        def trigonometry(angle: JointAngle) -> tuple[Any, Any]:
            point = (to_digits(angle.offset.cos), to_digits(angle.offset.sin))
            for joint, sign in angle.terms:
                point = turn(point, (mpmath.cos(q[joint]), sign * mpmath.sin(q[joint])))
            return point

        return build_motion(self.arm, q, qd, qdd, trigonometry, to_digits)

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Motor torques [n]."""
        return self._torques_at(self.joint_positions(), self.spread(qd), self.spread(qdd))

    def _torques_at(self, q: Sequence[Any], qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        arrays = {"q": q, "qd": qd, "qdd": qdd}
        state = {Input(name, i): x for name, array in arrays.items() for i, x in enumerate(array)}
        return self.folded(evaluate_to_digits(self._torques, {**self._parameters, **state})["tau"])

    def torque_slopes(self, qdd: Sequence[Any], dq: Sequence[Any], dqd: Sequence[Any]) -> list[Any]:
        """Central differences, right to more digits than are compared."""

        def torques(way: Any) -> list[Any]:
            q, qd = (
                [x + way * dx for x, dx in zip(start, self.spread(direction), strict=True)]
                for start, direction in (
                    (self.joint_positions(), dq),
                    (self.spread(self.inputs["qd"]), dqd),
                )
            )
            return self._torques_at(q, qd, self.spread(qdd))

        ends = zip(torques(self._step), torques(-self._step), strict=True)
        return [(x - y) / (2 * self._step) for x, y in ends]

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Torques [n] of links and rotors, without gravity and what drives do besides."""
        rotors = self.rotors_in_coordinates(self._layer().rotors())
        return with_rotors(super().inertial_torques(qd, qdd), rotors, qdd)

    def rotors(self) -> list[Rotor]:
        """The rotors of the drives."""
        return [*super().rotors(), *self.rotors_in_coordinates(self._layer().rotors())]

    def base_set(self) -> tuple[BaseParameter, ...]:
        """There are none: torques are not linear in any."""
        return base_set_of(self._robot)

    def _layer(self) -> Layer:
        constant: Callable[[Fraction], Any] = to_digits
        return layer_of(self._robot, constant, self._parameter)
