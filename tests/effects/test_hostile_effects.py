"""Arms with effects whose numbers are chosen against finite fields: no kernel is wrong.

Each program is evaluated in many digits and set beside :mod:`robodyn_testing.world_drives`: torques that are
balanced in the world's frame, and the equations of the effects as they are typeset.
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
from robodyn.robot.values import parameter
from robodyn_testing import sampled
from robodyn_testing.hostile_effects import REST, hostile_drives, near_copy, primes_drawn
from robodyn_testing.hostile_numbers import KNOWN
from robodyn_testing.world_drives import WorldArm, power
from robodyn_testing.world_dynamics import number

#: Numbers of the arms range over hundreds of powers of ten, and cancel.
DIGITS = 600
#: So small that nothing hides behind a term that is a hundred powers of ten larger.
TOLERANCE = mpmath.mpf(10) ** -200
FUNCTIONS: dict[str, Any] = {
    "sin": mpmath.sin, "cos": mpmath.cos, "tanh": mpmath.tanh, "sign": mpmath.sign, "sqrt": mpmath.sqrt,
    "exp": mpmath.exp, "abs": abs, "pow": power,
}  # fmt: skip
#: Rates that the functions are given.
MOVED: dict[str, Sequence[str]] = {"inverse_dynamics": ("qd", "qdd"), "bias": ("qd",), "gravity": ()}
QUICK = range(30)
LEVELS: tuple[Level, ...] = ("fast", "record", "none")


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
    made = generate(read, options or Options(optimize="fast"))
    rng = random.Random(robot.name)
    with mpmath.workdps(DIGITS):
        parameters = {name: mpmath.mpf(rng.uniform(0.1, 3)) for name in read.parameters}
        tilted(robot, read)
        world = WorldArm(replace(robot, gravity=read.gravity), parameters)
        for k in states:
            compare(world, made, rows(rng, read, k))
        for function, reason in made.left_out.items():
            assert function == "forward_dynamics"
            if world.feels_load:
                assert reason.startswith("friction that depends on the load")
            else:
                singular(world, [mpmath.mpf(rng.uniform(-3, 3)) for _ in range(robot.n)])
    assert len(made.unit.functions) + len(made.left_out) == 5
    return made


def rows(rng: random.Random, robot: Robot, k: int) -> dict[str, list[Any]]:
    """State 0: anywhere; 1: some joints at rest or at the edge of the band, the others moving; 2: at rest."""
    n = robot.n
    found = {a: [mpmath.mpf(rng.uniform(-3, 3)) for _ in range(n)] for a in ("q", "qd", "qdd", "tau")}
    if k == 1:
        found["qd"] = [-x for x in found["qd"]]
        edge = number(robot.dead_band or robot.rest_velocity or rng.choice(robot.gravity), {})
        for i in range(0, n, 3):
            found["qd"][i] = edge * rng.choice((-1, 0, 1))
    if k == 2:
        found["qd"] = [mpmath.mpf(0)] * n
    return found


def compare(world: WorldArm, made: Generated, at: dict[str, list[Any]]) -> None:
    """Every function at one state; what remembers at two lengths of a step."""
    n = world.robot.n
    q, qd, qdd = at["q"], at["qd"], at["qdd"]
    zero = [mpmath.mpf(0)] * n
    named = {Input(name, None): x for name, x in world.parameters.items()}
    inputs = named | {Input(a, i): x for a, row in at.items() for i, x in enumerate(row)}
    for signature, program in made.unit.functions:
        if signature.states:
            for dt in (mpmath.mpf(0), mpmath.mpf("0.05")):
                state = [x / 100 for x in (at["tau"] * 20)[: len(signature.states)]]
                given = {Input("state", i): x for i, x in enumerate(state)} | {Input("dt", 0): dt}
                tau, after = world.torques(q, qd, qdd, state, dt)
                close(run(program, inputs | given), [*tau, *after])
            continue
        values = run(program, inputs)
        if signature.function == "mass_matrix":
            product = [mpmath.fdot(values[n * i : n * i + n], qdd) for i in range(n)]
            still = zip(world.rigid(q, zero, qdd), world.rigid(q, zero, zero), strict=True)
            close(product, [x - y for x, y in still])
        elif signature.function == "forward_dynamics":
            close(world.torques(q, qd, values)[0], at["tau"])
        else:
            moved = MOVED[signature.function]
            close(values, world.torques(q, *(at[a] if a in moved else zero for a in ("qd", "qdd")))[0])


def run(program: Program, inputs: dict[Input, Any]) -> list[Any]:
    found = evaluate(program, inputs, constant=lambda x: number(x, {}), functions=FUNCTIONS)
    return [x for row in found.values() for x in row]


def close(found: Sequence[Any], expected: Sequence[Any]) -> None:
    """Equal but for the rounding of hundreds of digits, torque by torque."""
    for a, b in zip(found, expected, strict=True):
        assert abs(a - b) <= TOLERANCE * abs(b) + mpmath.mpf(10) ** (-DIGITS // 2)


def tilted(robot: Robot, read: Robot) -> None:
    """Gravity as it was read is that of the tilted base, to the digits of a double."""
    x, y, z = (number(g, {}) for g in robot.gravity)
    for entry in robot.effects:
        if entry.effect == "base_tilt":
            (c, s), (e, f) = (
                (mpmath.cos(t), mpmath.sin(t))
                for t in (number(entry[name], {}) for name in ("tilt_x", "tilt_y"))
            )
            y, z = c * y - s * z, s * y + c * z
            x, z = e * x + f * z, e * z - f * x
    size = sum(abs(number(g, {})) for g in robot.gravity)
    for found, expected in zip(read.gravity, (x, y, z), strict=True):
        assert abs(number(found, {}) - expected) <= 1e-14 * size


def singular(world: WorldArm, q: Sequence[Any]) -> None:
    """Some leading minor of the mass matrix is zero: scaled to a diagonal of ones, but for rounding."""
    n, zero = world.robot.n, [mpmath.mpf(0)] * world.robot.n
    still = world.rigid(q, zero, zero)
    M = mpmath.matrix(n, n)
    for j in range(n):
        unit = [mpmath.mpf(i == j) for i in range(n)]
        for i, (x, y) in enumerate(zip(world.rigid(q, zero, unit), still, strict=True)):
            M[i, j] = x - y
    size = max(abs(x) for x in M)
    tiny = mpmath.mpf(10) ** (-DIGITS // 2)
    for k in range(n):
        if abs(M[k, k]) <= tiny * size:
            return
        for i in range(k + 1, n):
            factor = M[i, k] / M[k, k]
            for j in range(k, n):
                M[i, j] -= factor * M[k, j]
    raise AssertionError("forward dynamics is refused, and the mass matrix is regular")


@pytest.mark.parametrize("seed", sampled(QUICK, every=4))
def test_hostile_effects(seed: int) -> None:
    check(arm(seed, seed % 3 + 1), (0, 1 + seed // 3 % 2), Options(optimize=LEVELS[seed % 2]))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(len(QUICK), 530))
def test_many_hostile_effects(seed: int) -> None:
    check(
        arm(seed, seed // 5 % 30 + 1 if seed % 5 == 0 else seed % 6 + 1),
        options=Options(optimize=LEVELS[seed % 3]),
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
