"""A program against the plain recursion, without rounding: equal, not close.

Both run on ``Fraction`` at random rational points, the sines and cosines of joint angles among them being
rational points of the unit circle. The plain recursion is conventional Newton-Euler on the numbers of the
description; graph, passes and regrouping have no part in it.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.dynamics.arm import Arm, JointAngle, Motion, build_arm, build_motion
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.ir.evaluate import evaluate_exact, turn
from robodyn.ir.program import Input, Program
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

Point = tuple[Fraction, Fraction]


def equals_recursion(
    robot: Robot, function: str, program: Program, *, points: int = 2, seed: int = 0
) -> bool:
    """Whether ``program`` gives, at ``points`` random rational points, exactly what the plain recursion
    gives. ``program`` computes ``function`` from ``q`` (not from given sines).

    :class:`ValueError` where friction is smooth at rest, its tanh has no exact value, and where drives have
    effects.
    """
    if robot.rest_velocity is not None and any(link.joint.coulomb for link in robot.links):
        raise ValueError("tanh has no exact value")
    if any(entry.effect != "payload" for entry in robot.effects):
        raise ValueError("the plain recursion is that of the rigid arm")
    chance = random.Random(f"{robot.name} {function} {seed}")
    return all(_equal_at(robot, function, program, chance) for _ in range(points))


def _equal_at(robot: Robot, function: str, program: Program, chance: random.Random) -> bool:
    n = robot.n

    def number() -> Fraction:
        return Fraction(chance.randint(-40, 40), chance.randint(1, 9))

    inputs: dict[Input, Fraction] = {}
    circle: dict[Input, Point] = {}
    for i in range(n):
        t = Fraction(chance.randint(-20, 20), chance.randint(1, 20))
        circle[Input("q", i)] = ((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t))
        for array in ("q", "qd", "qdd", "tau"):
            inputs[Input(array, i)] = number()
    parameters = {name: abs(number()) + 1 for name in robot.parameters}
    inputs.update({Input(name, None): value for name, value in parameters.items()})
    arm = build_arm(robot, lambda x: x, parameters.__getitem__)

    def row(array: str) -> list[Fraction]:
        return [inputs[Input(array, i)] for i in range(n)]

    zeros = [Fraction(0)] * n

    def torques(qd: Sequence[Any], qdd: Sequence[Any]) -> list[Fraction]:
        return newton_euler(arm, _motion(arm, row("q"), qd, qdd, circle))

    ((_, found),) = evaluate_exact(program, inputs, circle, circle_point).items()
    if function == "inverse_dynamics":
        return found == torques(row("qd"), row("qdd"))
    if function == "gravity":
        return found == torques(zeros, zeros)
    if function == "bias":
        return found == torques(row("qd"), zeros)
    if function == "forward_dynamics":
        return torques(row("qd"), found) == row("tau")
    # M x for a random x: as telling as all columns of M, at a fraction of the cost.
    x = row("qdd")
    product = [sum((found[n * i + j] * x[j] for j in range(n)), Fraction(0)) for i in range(n)]
    return product == [t - g for t, g in zip(torques(zeros, x), torques(zeros, zeros), strict=True)]


def _motion(
    arm: Arm, q: Sequence[Any], qd: Sequence[Any], qdd: Sequence[Any], circle: dict[Input, Point]
) -> Motion:
    def trigonometry(angle: JointAngle) -> Point:
        total = (angle.offset.cos, angle.offset.sin)
        for joint, sign in angle.terms:
            c, s = circle[Input("q", joint)]
            total = turn(total, (c, sign * s))
        return total

    return build_motion(arm, q, qd, qdd, trigonometry, lambda x: x)
