"""A program against the plain recursion, without rounding: equal, not close.

Both run at a random point: on elements of a finite field (:func:`same_in_field`), or on ``Fraction``
(:func:`equals_recursion`), the sines and cosines of joint angles being points of the unit circle there. The
plain recursion is conventional Newton-Euler on the numbers of the description; graph, passes and regrouping
have no part in it.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from robodyn.dynamics.arm import JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.functions import INPUTS, function_named
from robodyn.dynamics.reference import PlainDynamics
from robodyn.ir.evaluate import Circle, evaluate_exact, turn
from robodyn.ir.field import FINAL_BITS, Field, Residue
from robodyn.ir.fingerprint import digest, fingerprint, in_drawn_field
from robodyn.ir.graph import Graph
from robodyn.ir.program import Input, Program
from robodyn.robot.coupling import transmission_of
from robodyn.robot.identity import identity
from robodyn.robot.model import Robot
from robodyn.robot.values import angle, circle_point

if TYPE_CHECKING:
    from robodyn.dynamics.base_set import BaseParameter

#: Numbers that stay integers: a recursion over them asks which are 0.
_FEW = (0, 1, -1)

#: Rational points are drawn from so many numbers.
_RANGE = 1 << 32


def same_in_field(robot: Robot, function: str, program: Program) -> bool:
    """Whether ``program`` is ``function`` of ``robot``: equal to the plain recursion at a random point of a
    field that is drawn from a hash of the robot's numbers and of the program.

    Smooth friction is compared as well: its tanh is a random function. Effects of drives are not part of
    the plain recursion (:class:`ValueError`).
    """
    inputs = _inputs(robot, function)

    def same(field: Field) -> bool:
        def number(x: Fraction) -> int | Residue:
            return int(x) if x in _FEW else Residue(field, field.number(x))

        circle = [(Residue(field, c), Residue(field, s)) for c, s in _angles(robot, field)]
        plain = _Plain(robot, number, {x: Residue(field, field.variable(x)) for x in inputs}, circle)
        results = [Residue(field, value) for value in fingerprint(program, field, circle_point)]
        return plain.gives(function, results)

    hashed = (identity(robot).encode(), function.encode(), digest(program))
    return bool(in_drawn_field(same, *hashed, bits=FINAL_BITS))


def equals_recursion(robot: Robot, function: str, program: Program, *, points: int = 2) -> bool:
    """Whether ``program`` gives, at ``points`` rational points that are drawn from a hash of it, exactly what
    the plain recursion gives. ``program`` computes ``function`` from ``q`` (not from given sines).

    :class:`ValueError` where friction is smooth at rest, its tanh has no exact value, where drives have
    effects, and where joints follow others.
    """
    if robot.couplings:
        raise ValueError("sines of parts of an angle have no exact value")
    if robot.rest_velocity is not None and any(link.joint.coulomb for link in robot.links):
        raise ValueError("tanh has no exact value")
    chance = random.Random(f"{digest(program).hex()} {identity(robot)} {function}")
    inputs = _inputs(robot, function)

    def drawn() -> Fraction:
        return Fraction(chance.randint(-_RANGE, _RANGE), chance.randint(1, 99))

    def same() -> bool:
        values = {x: drawn() if x.index is not None else abs(drawn()) + 1 for x in inputs}
        circle = []
        for _ in range(robot.n):
            t = Fraction(chance.randint(-_RANGE, _RANGE), chance.randint(1, _RANGE))
            circle.append(((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)))
        places = {Input("q", i): point for i, point in enumerate(circle)}
        results = evaluate_exact(program, values, places, circle_point)
        plain = _Plain(robot, lambda x: x, values, circle)
        return plain.gives(function, [x for row in results.values() for x in row])

    return all(same() for _ in range(points))


def _angles(robot: Robot, field: Field) -> list[tuple[int, int]]:
    """The points of the circle that stand for the joints' angles: of joints that follow others multiples of
    those of the coordinates, which are divided as far as that takes."""
    if not robot.couplings:
        return [field.angle(Input("q", i)) for i in range(robot.n)]
    transmission = transmission_of(robot)
    for k, column in enumerate(transmission.columns()):
        field.divide(Input("q", k), math.lcm(*(g.denominator for _, g in column)))
    points = []
    for row, offset in zip(transmission.rows, transmission.offsets, strict=True):
        start = angle(offset)
        point = field.number(start.cos), field.number(start.sin)
        for k, g in row.items():
            part = field.multiple(field.angle(Input("q", k), g.denominator), g.numerator)
            point = field.turn(point, part)
        points.append(point)
    return points


def _inputs(robot: Robot, function: str) -> list[Input]:
    """All that ``function`` of ``robot`` may depend on."""
    if not all(entry.definition.traits.body for entry in robot.effects):
        raise ValueError("the plain recursion is that of the rigid arm")
    p = len(_base_set(robot)) if function_named(function).has_parameters else 0
    n = len(robot.commanded)
    arrays = [Input(array.name, i) for array in INPUTS for i in range(array.size_at(n, p))]
    return arrays + [Input(name, None) for name in robot.parameters]


def _base_set(robot: Robot) -> tuple[BaseParameter, ...]:
    from robodyn.dynamics.base_set import base_set

    return base_set(build_arm(robot.free, lambda x: x, Graph().input))


class _Plain(PlainDynamics):
    """Conventional Newton-Euler of ``robot`` at ``values`` of its inputs, ``constant`` applied to its
    constants; ``circle`` [n] (cos, sin) of the joints' angles."""

    def __init__(
        self,
        robot: Robot,
        constant: Callable[[Fraction], Any],
        values: Mapping[Input, Any],
        circle: Sequence[Circle],
    ) -> None:
        self.arm = build_arm(robot.free, constant, lambda name: values[Input(name, None)])
        self.transmission, self.number = transmission_of(robot) if robot.couplings else None, constant
        self.inputs = {
            array.name: [value for x, value in values.items() if x.is_of(array.name)] for array in INPUTS
        }
        self.rest = [0] * len(robot.commanded)
        self._robot, self._constant, self._circle = robot, constant, circle

    def gives(self, function: str, results: Sequence[Any]) -> bool:
        """Whether ``results`` are the elements of ``function`` here."""
        one, other = function_named(function).compared(self, results, self.inputs["qdd"])
        return list(one) == list(other)

    def motion(self, qd: Sequence[Any], qdd: Sequence[Any]) -> Motion:
        """The arm at ``q``, with these rates and accelerations."""

        def trigonometry(angle: JointAngle) -> Circle:
            total: Circle = (self._constant(angle.offset.cos), self._constant(angle.offset.sin))
            for joint, sign in angle.terms:
                c, s = self._circle[joint]
                total = turn(total, (c, sign * s))
            return total

        q, qd, qdd = self.joint_positions(), self.spread(qd), self.spread(qdd)
        return build_motion(self.arm, q, qd, qdd, trigonometry, self._constant)

    def base_set(self) -> tuple[BaseParameter, ...]:
        """The base parameters, by the exact numbers of the robot."""
        return _base_set(self._robot)
