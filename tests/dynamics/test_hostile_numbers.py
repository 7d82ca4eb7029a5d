"""Numbers chosen against the finite fields in which programs are merged and compared: no kernel is wrong.

Each program is evaluated in many digits and set beside the plain recursion's, in which nothing is merged.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from robodyn import Options, generate
from robodyn.errors import InputError
from robodyn.ir import Input, Program
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import NoForwardDynamics
from robodyn.optimize.programs import Choice, build
from robodyn.robot import Robot, read_text
from robodyn_testing import covering, sampled
from robodyn_testing.hostile_numbers import hostile

FUNCTIONS: dict[str, Any] = {"sin": mpmath.sin, "cos": mpmath.cos, "tanh": mpmath.tanh, "sign": mpmath.sign}
#: Numbers of the arms range over hundreds of powers of ten, and cancel.
DIGITS = 800
TOLERANCE = mpmath.mpf(10) ** -25
#: No finite field has a part in what is built so.
PLAIN = Choice("newton_euler", regroup=False, chains=False)


def check(robot: Robot, options: Options | None = None) -> int:
    """Compare every function of ``robot`` at a random state; how many there are."""
    made = generate(robot, options or Options(optimize="fast"))
    rng = random.Random(robot.name)
    with mpmath.workdps(DIGITS):
        inputs = {
            Input(array, i): mpmath.mpf(rng.uniform(-3, 3))
            for array in ("q", "qd", "qdd", "tau")
            for i in range(robot.n)
        }
        for signature, found in made.unit.functions:
            close(run(found, inputs), run(build(robot, signature.function, PLAIN), inputs))
    return len(made.unit.functions)


def run(made: Program, inputs: dict[Input, Any]) -> list[Any]:
    found = evaluate(made, inputs, constant=number, functions=FUNCTIONS)
    return [x for row in found.values() for x in row]


def number(x: Fraction) -> Any:
    return mpmath.mpf(x.numerator) / x.denominator


def close(found: Sequence[Any], expected: Sequence[Any]) -> None:
    """Equal but for the rounding of hundreds of digits, torque by torque."""
    for a, b in zip(found, expected, strict=True):
        assert abs(a - b) <= TOLERANCE * abs(b) + mpmath.mpf(10) ** (-DIGITS // 2)


MASS = "2.305843009213693951"


@pytest.mark.parametrize(
    ("mass", "joints", "rest"),
    covering(
        [MASS, "2305843009213693951", "1/2305843009213693951", f"{MASS}*{MASS}"],
        [(1, ""), (2, "friction_at_rest: smooth\n"), (13, "")],
    ),
)
def test_a_mass_that_is_zero_in_a_field(mass: str, joints: int, rest: str) -> None:
    """2^61 - 1 was the prime, and fixed: the mass was gone from every function."""
    link = f"  - {{joint: revolute, alpha: pi/2, mass: {mass}, com: [0.5, 0, 0], friction: {{coulomb: 2}},\n"
    text = f"name: heavy\n{rest}links:\n" + joints * f"{link}     motor_inertia: 0.1}}\n"
    robot = read_text(text)
    made = generate(robot, Options(optimize="fast"))
    gravity = next(p for s, p in made.unit.functions if s.function == "gravity")
    assert Input("q", joints - 1) in gravity.inputs()
    assert check(robot) == 5


@pytest.mark.parametrize("seed", sampled(range(24), every=8, rest="slow"))
def test_hostile_arms(seed: int) -> None:
    assert_right_or_refused(hostile(seed))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(24, 1000))
def test_many_hostile_arms(seed: int) -> None:
    assert_right_or_refused(hostile(seed, joints=seed % 30 + 1))


def assert_right_or_refused(robot: Robot) -> None:
    try:
        assert check(robot) >= 4
    except NoForwardDynamics:  # said of an arm in which something moves without inertia
        check(robot, Options(("inverse_dynamics", "gravity", "bias", "mass_matrix"), optimize="fast"))
    except InputError as error:
        assert "does not fit" in str(error)  # noqa: PT017
