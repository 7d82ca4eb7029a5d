"""Arms with effects whose numbers are chosen against finite fields: no kernel is wrong.

Each program is evaluated in many digits and set beside the plain recursion, in which nothing is merged.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import pytest

from robodyn import Options, generate
from robodyn.effects.catalogue import CATALOGUE
from robodyn.ir import Input, Program
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import Generated, Level
from robodyn.robot import Robot, read_text
from robodyn.robot.folding import folded
from robodyn.robot.values import Value, parameter
from robodyn_testing import sampled
from robodyn_testing.hostile_effects import REST, hostile_drives, near_copy, primes_drawn
from robodyn_testing.hostile_numbers import KNOWN


def power(x: Any, exponent: Any) -> Any:
    """``x^exponent``, of a negative ``x`` where the exponent is whole."""
    return x ** int(exponent) if mpmath.isint(exponent) and abs(exponent) < 99 else mpmath.power(x, exponent)


#: Numbers of the arms range over hundreds of powers of ten, and cancel.
DIGITS = 600
#: So small that nothing hides behind a term that is a hundred powers of ten larger.
TOLERANCE = mpmath.mpf(10) ** -200
FUNCTIONS: dict[str, Any] = {
    "sin": mpmath.sin, "cos": mpmath.cos, "tanh": mpmath.tanh, "sign": mpmath.sign, "sqrt": mpmath.sqrt,
    "exp": mpmath.exp, "abs": abs, "pow": power,
}  # fmt: skip
#: No finite field has a part in what is written so.
PLAIN = Options(formulation="newton_euler", regroup=False, optimize="none")
QUICK = range(30)
LEVELS: tuple[Level, ...] = ("fast", "record")


def arm(seed: int, joints: int) -> Robot:
    """Of three arms one plays against primes that are known, two against those drawn for a near copy."""
    robot = hostile_drives(seed, joints=joints)
    if seed // 3 % 3 == 0:
        return robot
    function = random.Random(seed).choice(("inverse_dynamics", "gravity", "bias", "mass_matrix"))
    with primes_drawn() as primes:
        generate(folded(robot), Options((function,), optimize="fast"))
    return near_copy(seed, robot, primes, effects=seed // 3 % 3 == 1)


def check(robot: Robot, states: Sequence[int] = (0, 1, 2), options: Options | None = None) -> Generated:
    """Compare every function of ``robot`` at some of the states of :func:`rows`."""
    read = folded(robot)
    made, plain = generate(read, options or Options(optimize="fast")), generate(read, PLAIN)
    rng = random.Random(robot.name)
    with mpmath.workdps(DIGITS):
        named = {Input(name, None): mpmath.mpf(rng.uniform(0.1, 3)) for name in read.parameters}
        for k in states:
            inputs = named | rows(rng, read, k)
            for (signature, found), (_, expected) in zip(
                made.unit.functions, plain.unit.functions, strict=True
            ):
                for dt in ("0", "0.05") if signature.states else ("0",):
                    inputs[Input("dt", 0)] = mpmath.mpf(dt)
                    close(run(found, inputs), run(expected, inputs))
    assert made.left_out == plain.left_out
    assert len(made.unit.functions) + len(made.left_out) == 5
    return made


def rows(rng: random.Random, robot: Robot, k: int) -> dict[Input, Any]:
    """State 0: anywhere; 1: some joints at rest or at the edge of the band, the others moving; 2: at rest."""
    n = robot.n
    found = {a: [mpmath.mpf(rng.uniform(-3, 3)) for _ in range(n)] for a in ("q", "qd", "qdd", "tau")}
    found["state"] = [x / 100 for x in found["tau"] * 20]
    if k == 1:
        found["qd"] = [-x for x in found["qd"]]
        edge = number(robot.dead_band or robot.rest_velocity or rng.choice(robot.gravity))
        for i in range(0, n, 3):
            found["qd"][i] = edge * rng.choice((-1, 0, 1))
    if k == 2:
        found["qd"] = [mpmath.mpf(0)] * n
    return {Input(a, i): x for a, row in found.items() for i, x in enumerate(row)}


def number(x: Value) -> Any:
    assert isinstance(x, Fraction)
    return mpmath.mpf(x.numerator) / x.denominator


def run(program: Program, inputs: dict[Input, Any]) -> list[Any]:
    found = evaluate(program, inputs, constant=number, functions=FUNCTIONS)
    return [x for row in found.values() for x in row]


def close(found: Sequence[Any], expected: Sequence[Any]) -> None:
    """Equal but for the rounding of hundreds of digits, torque by torque."""
    for a, b in zip(found, expected, strict=True):
        assert abs(a - b) <= TOLERANCE * abs(b) + mpmath.mpf(10) ** (-DIGITS // 2)


@pytest.mark.parametrize("seed", sampled(QUICK, every=6, rest="slow"))
def test_hostile_effects(seed: int) -> None:
    check(arm(seed, seed % 3 + 1), (0, 1 + seed // 3 % 2), Options(optimize=LEVELS[seed % 2]))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(len(QUICK), 530))
def test_many_hostile_effects(seed: int) -> None:
    check(
        arm(seed, seed // 5 % 30 + 1 if seed % 5 == 0 else seed % 6 + 1),
        options=Options(optimize=LEVELS[seed % 2]),
    )


def test_every_effect_is_among_the_quick_ones() -> None:
    robots = [hostile_drives(seed, joints=seed % 3 + 1) for seed in QUICK]
    assert {e.effect for robot in robots for e in robot.effects} == set(CATALOGUE)
    bearings = {e["bearing"] for robot in robots for e in robot.effects if "bearing" in e}
    assert bearings == {"journal", "linear", "thrust", "radial", "torque"}
    kinds = {(robot.rest_velocity is None, robot.dead_band is None) for robot in robots}
    assert len(kinds) == len(REST)


@pytest.mark.parametrize("effects", [True, False])
def test_masses_that_are_equal_in_a_known_field(effects: bool) -> None:
    """In the field of the passes the first of two slides has no mass, and the second pivot is 0: it was
    said to be a joint that moves without inertia."""
    text = "name: slides\nlinks: [{joint: prismatic, mass: m}, {joint: prismatic, mass: m}]\n"
    robot = read_text(
        text.replace("m}, ", "m, effects: [{effect: spring, stiffness: 2}]}, ") if effects else text
    )
    one, two = robot.links
    heavy = replace(one, mass=parameter("m") * Fraction(KNOWN, 10**36))
    assert not check(replace(robot, links=(heavy, two))).left_out
