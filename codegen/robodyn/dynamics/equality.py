"""A program against the plain recursion, without rounding: equal, not close.

Both run at a random point: on elements of a finite field (:func:`same_in_field`), or on ``Fraction``
(:func:`equals_recursion`), the sines and cosines of joint angles being points of the unit circle there. The
plain recursion is conventional Newton-Euler on the numbers of the description; graph, passes and regrouping
have no part in it.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, JointAngle, Motion, build_arm, build_motion, inertial
from robodyn.dynamics.base_parameter import BaseParameter
from robodyn.dynamics.base_set import base_set
from robodyn.dynamics.described import AsDescribed
from robodyn.dynamics.functions import INPUTS, Rotor, function_named
from robodyn.dynamics.joints import rotors_of
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir.evaluate import evaluate_exact, turn
from robodyn.ir.field import FINAL_BITS, Field
from robodyn.ir.fingerprint import digest, fingerprint, in_drawn_field
from robodyn.ir.graph import Graph
from robodyn.ir.program import Input, Program
from robodyn.ir.residue import Residue
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

Point = tuple[Any, Any]

#: Numbers that stay integers: a recursion over them asks which are 0.
_FEW = (0, 1, -1)

#: Rational points are drawn from so many numbers.
_RANGE = 1 << 32


@dataclass(frozen=True, slots=True)
class _State:
    """Where an arm is, in scalars of one kind: ``inputs`` by name; ``circle`` (cos, sin) by joint."""

    constant: Callable[[Fraction], Any]
    inputs: Mapping[Input, Any]
    circle: Sequence[Point]
    run: Callable[[Program], Sequence[Any]]


def same_in_field(robot: Robot, function: str, program: Program) -> bool:
    """Whether ``program`` is ``function`` of ``robot``: equal to the plain recursion at a random point of a
    field that is drawn from a hash of the robot's numbers and of the program.

    Smooth friction is compared as well: its tanh is a random function. Effects of drives are not part of
    the plain recursion (:class:`ValueError`).
    """
    _check_rigid(robot)
    p = _parameters_of(robot, function)
    same: bool = in_drawn_field(
        lambda field: _equal(robot, function, program, _field_state(robot, field, p)),
        identity(robot).encode(),
        function.encode(),
        digest(program),
        bits=FINAL_BITS,
    )
    return same


def equals_recursion(
    robot: Robot, function: str, program: Program, *, points: int = 2, seed: int = 0
) -> bool:
    """Whether ``program`` gives, at ``points`` rational points that are drawn from a hash of it, exactly what
    the plain recursion gives. ``program`` computes ``function`` from ``q`` (not from given sines).

    :class:`ValueError` where friction is smooth at rest, its tanh has no exact value, and where drives have
    effects.
    """
    if robot.rest_velocity is not None and any(link.joint.coulomb for link in robot.links):
        raise ValueError("tanh has no exact value")
    _check_rigid(robot)
    chance = random.Random(f"{digest(program).hex()} {identity(robot)} {function} {seed}")
    p = _parameters_of(robot, function)
    return all(_equal(robot, function, program, _rational_state(robot, chance, p)) for _ in range(points))


def _check_rigid(robot: Robot) -> None:
    if not all(entry.definition.traits.body for entry in robot.effects):
        raise ValueError("the plain recursion is that of the rigid arm")


def _inputs(robot: Robot, p: int) -> list[Input]:
    arrays = [Input(array.name, i) for array in INPUTS for i in range(array.size_at(robot.n, p))]
    return arrays + [Input(name, None) for name in robot.parameters]


def _parameters_of(robot: Robot, function: str) -> int:
    """How many base parameters ``function`` depends on."""
    if not function_named(function).has_parameters:
        return 0
    return len(base_set(build_arm(robot, lambda x: x, Graph().input)))


def _field_state(robot: Robot, field: Field, p: int) -> _State:
    def element(value: int) -> Residue:
        return Residue(field, value)

    def number(x: Fraction) -> int | Residue:
        return int(x) if x in _FEW else element(field.number(x))

    points = [field.angle(Input("q", i)) for i in range(robot.n)]
    return _State(
        number,
        {x: element(field.variable(x)) for x in _inputs(robot, p)},
        [(element(c), element(s)) for c, s in points],
        lambda program: [element(value) for value in fingerprint(program, field, circle_point)],
    )


def _rational_state(robot: Robot, chance: random.Random, p: int) -> _State:
    def number() -> Fraction:
        return Fraction(chance.randint(-_RANGE, _RANGE), chance.randint(1, 99))

    inputs = {x: number() if x.index is not None else abs(number()) + 1 for x in _inputs(robot, p)}
    circle = []
    for _ in range(robot.n):
        t = Fraction(chance.randint(-_RANGE, _RANGE), chance.randint(1, _RANGE))
        circle.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
    points = {Input("q", i): point for i, point in enumerate(circle)}

    def run(program: Program) -> list[Fraction]:
        return [x for row in evaluate_exact(program, inputs, points, circle_point).values() for x in row]

    return _State(lambda x: x, inputs, circle, run)


def _equal(robot: Robot, function: str, program: Program, state: _State) -> bool:
    record = function_named(function)
    arm = build_arm(robot, state.constant, lambda name: state.inputs[Input(name, None)])
    plain = _Plain(robot, arm, state)
    one, other = record.compared(plain, list(state.run(program)), plain.inputs["qdd"])
    return list(one) == list(other)


class _Plain(AsDescribed):
    """Conventional Newton-Euler at a state, see :class:`robodyn.dynamics.functions.Dynamics`."""

    def __init__(self, robot: Robot, arm: Arm, state: _State) -> None:
        n = len(arm.bodies)
        self.inputs = {
            array.name: [value for x, value in state.inputs.items() if x.is_of(array.name)]
            for array in INPUTS
        }
        self.rest = [0] * n
        self.arm, self._state, self._robot = arm, state, robot

    def torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n]."""
        return newton_euler(self.arm, self.motion(qd, qdd))

    def inertial_torques(self, qd: Sequence[Any], qdd: Sequence[Any]) -> list[Any]:
        """Joint torques [n] without gravity and friction."""
        return newton_euler(inertial(self.arm), self.motion(qd, qdd))

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""
        return _motion(self.arm, self.inputs["q"], qd, qdd, self._state)

    def base_set(self) -> tuple[BaseParameter, ...]:
        """The base parameters, by the exact numbers of the robot."""
        return base_set(build_arm(self._robot, lambda x: x, Graph().input))

    def rotors(self) -> list[Rotor]:
        """The rotors of the joints."""
        return rotors_of(self.arm)

    def mass_matrix(self) -> list[list[Any]]:
        """Mass matrix [n][n]: torques of unit accelerations, without gravity, of the arm at rest."""
        n = len(self.rest)
        columns = [self.inertial_torques(self.rest, [int(i == j) for i in range(n)]) for j in range(n)]
        return [list(row) for row in zip(*columns, strict=True)]


def _motion(arm: Arm, q: Sequence[Any], qd: Sequence[Any], qdd: Sequence[Any], state: _State) -> Motion:
    def trigonometry(angle: JointAngle) -> Point:
        total: Point = (state.constant(angle.offset.cos), state.constant(angle.offset.sin))
        for joint, sign in angle.terms:
            c, s = state.circle[joint]
            total = turn(total, (c, sign * s))
        return total

    return build_motion(arm, q, qd, qdd, trigonometry, state.constant)
