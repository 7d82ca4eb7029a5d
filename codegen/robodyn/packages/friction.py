"""What the friction of an arm depends on, for formats that have a place for friction of velocities alone."""

from __future__ import annotations

import random
from typing import Literal

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.packages.format import Package
from robodyn.packages.limits import FRICTION_STATES, FRICTION_VELOCITY, SAME_FRICTION

#: None there is, of the velocities alone, or of more, as of the load that a bearing carries.
Dependence = Literal["none", "velocities", "positions"]
#: What friction is worked out of: the bias less the other two.
FUNCTIONS = ("bias", "coriolis", "gravity")


def friction_of(package: Package) -> Dependence:
    """What the friction in the torques of ``package`` depends on, which has :data:`FUNCTIONS`: it is compared
    at random states, with random run-time parameters, between each position and zero."""
    draw = random.Random(0)
    n = package.robot.n
    answer: Dependence = "none"
    for _ in range(FRICTION_STATES):
        qd = [draw.uniform(-FRICTION_VELOCITY, FRICTION_VELOCITY) for _ in range(n)]
        parameters = {name: draw.uniform(0.5, 1.5) for name in package.parameters}
        here, scale = _friction(package, [draw.uniform(-1, 1) for _ in range(n)], qd, parameters)
        at_zero, other = _friction(package, [0.0] * n, qd, parameters)
        rounding = SAME_FRICTION * max(scale, other)
        if any(abs(x - y) > rounding for x, y in zip(here, at_zero, strict=True)):
            return "positions"
        if any(abs(x) > rounding for x in at_zero):
            answer = "velocities"
    return answer


def _friction(
    package: Package, q: list[float], qd: list[float], parameters: dict[str, float]
) -> tuple[list[float], float]:
    """The friction [N m, N] at a state, and the largest torque there."""
    inputs = {Input(name, None): value for name, value in parameters.items()}
    for name, values in (("q", q), ("qd", qd)):
        inputs |= {Input(name, i): value for i, value in enumerate(values)}
    programs = {signature.function: program for signature, program in package.generated.unit.functions}
    (bias, rest, still) = (
        next(iter(evaluate(programs[function], inputs).values())) for function in FUNCTIONS
    )
    friction = [float(h - c - g) for h, c, g in zip(bias, rest, still, strict=True)]
    return friction, max(abs(float(torque)) for torque in (*bias, *rest, *still))
