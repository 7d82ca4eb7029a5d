"""Bounds of rounding errors: above what happens, near what Gappa finds, and made of the C that is emitted."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from robodyn.certify.forward import Forward
from robodyn.certify.gappa import Proven, Scripts, prove, read
from robodyn.certify.readback import check_read_back
from robodyn.errors import CheckError, InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import Robot, load, read_text
from robodyn.toolchain.running import Finished
from robodyn_testing import covering, require_tool
from robodyn_testing.waiting import eventually, runs

TWO = read_text(
    """
name: two
links:
  - {joint: revolute, mass: 3, com: [0.1, 0, 0.2], inertia: {xx: 0.1, yy: 0.2, zz: 0.25}, motor_inertia: 1.1}
  - joint: revolute
    alpha: 0.3
    a: 0.5
    mass: 2
    com: [0.2, 0.1, 0.1]
    inertia: {xx: 1, yy: 1, zz: 1.1}
    friction: {viscous: 0.3, coulomb: 1.7}
"""
)
RANGES = {"q": Fraction(3), "qd": Fraction(2), "qdd": Fraction(7)}


def inverse_dynamics(robot: Robot, scalar: str, trig: str = "builtin") -> Generated:
    options = Options(functions=("inverse_dynamics",), scalar=scalar, trig=trig)  # type: ignore[arg-type]
    return generate(robot, options)


def ranges(robot: Robot) -> dict[Input, tuple[Fraction, Fraction]]:
    return {Input(a, i): (-limit, limit) for a, limit in RANGES.items() for i in range(robot.n)}


def proven(folder: Path, robot: Robot, scalar: str) -> tuple[list[Proven], Forward]:
    gappa = require_tool("gappa")
    _, program = inverse_dynamics(robot, scalar).unit.functions[0]
    bounds = Forward(program, ranges(robot), scalar, 1.0)
    scripts = Scripts(program, bounds)
    names = []
    for i, element in enumerate(scripts.body.outputs[0][1], 1):
        names.append(f"{i}.g")
        (folder / names[-1]).write_text(scripts.of(element, "a test"))
    return prove(gappa, folder, names, seconds=200, workers=2, progress=lambda _: None), bounds


@pytest.mark.parametrize("scalar", [pytest.param("float", marks=pytest.mark.thorough), "double"])
def test_gappa_and_we_agree_and_nothing_worse_is_found(tmp_path: Path, scalar: str) -> None:
    found, bounds = proven(tmp_path, TWO, scalar)
    _, program = inverse_dynamics(TWO, scalar).unit.functions[0]
    real = np.float32 if scalar == "float" else np.float64
    random = np.random.default_rng(1)
    given = {x: random.uniform(-1, 1, 20_000) * float(limit[1]) for x, limit in ranges(TWO).items()}
    rounded = {x: row.astype(real) for x, row in given.items()}
    wide = {x: row.astype(np.longdouble) for x, row in rounded.items()}

    def exactly(value: Fraction) -> np.longdouble:
        return np.longdouble(value.numerator) / np.longdouble(value.denominator)

    functions = {"sin": np.sin, "cos": np.cos, "sign": np.sign}
    # numpy's sine of float32 is good to 1 ulp or so, its double's to less.
    computed = evaluate(program, rounded, constant=lambda v: real(float(v)), functions=functions)["tau"]
    true = evaluate(program, wide, constant=exactly, functions=functions)["tau"]
    for row, near, far, operand in zip(found, computed, true, program.outputs[0][1], strict=True):
        own = bounds.of(operand).error
        worst = float(np.abs(near - far).max())
        assert near.dtype == real
        assert row.error is not None, row.reason
        assert 0 < worst <= row.error <= own * 1.01
        assert own <= 3 * row.error
        assert row.low is not None
        assert row.high is not None
        assert row.low <= near.min() <= near.max() <= row.high


def test_an_interrupted_proof_leaves_nothing_behind(tmp_path: Path) -> None:
    sleeper = tmp_path / "sleeper"
    ids = tmp_path / "ids"
    wait = f"until [ -s {ids} ]; do sleep 0.01; done"  # until the other sleeps
    sleeper.write_text(
        f"#!/bin/sh\nif [ $1 = quick ]; then {wait}; exit 0; fi\necho $$ > {ids}; sleep 1000\n"
    )
    sleeper.chmod(0o755)

    def interrupted(done: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        prove(str(sleeper), tmp_path, ["slow", "quick"], seconds=900, workers=2, progress=interrupted)
    assert eventually(lambda: not runs(int(ids.read_text())))


@pytest.mark.parametrize(
    ("robot", "trig"), covering(["puma560", "stanford", "two"], ["libm", "given", "builtin"])
)
def test_the_emitted_c_reads_back(robot: str, trig: str) -> None:
    described = TWO if robot == "two" else load(robot, warn=lambda _: None)
    made = generate(described, Options(scalar="float", trig=trig))  # type: ignore[arg-type]
    text = made.files(("c",))[f"{robot}.c"]
    for interface, program in made.unit.functions:
        check_read_back(text, interface, program)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        (r"= (\w+) \+ (\w+);", r"= \2 + \1;"),
        (r"qdd\[1\] \+ qdd\[2\]", "qdd[1] - qdd[2]"),
        (r"0\.0013f", "0.0013001f"),
        (r"\*\((\w+) - (\w+)\)", r"*\1 - \2"),
        (r"angles\[4\] = \{(\w+), (\S+),", r"angles[4] = {\2, \1,"),
        (r"tau\[1\] = tau2;", "tau[1] = tau1;"),
        (r"tau\[5\] = tau6;", ""),
        (r"= qd\[1\] \+ qd\[2\]", "= sqrtf(qd[1])"),
        (r"given_\(sines, cosines", "given_(cosines, sines"),
    ],
)
def test_any_change_of_the_c_is_seen(old: str, new: str) -> None:
    made = inverse_dynamics(load("puma560", warn=lambda _: None), "float")
    ((interface, program),) = made.unit.functions
    text = made.files(("c",))["puma560.c"]
    head, kernel = text.split("void puma560_inverse_dynamics_given_", 1)
    changed, count = re.subn(old, new, kernel, count=1)
    assert count == 1
    kernel = "void puma560_inverse_dynamics_given_" + changed
    with pytest.raises(CheckError):
        check_read_back(head + kernel, interface, program)


def test_programs_without_a_bound_are_told() -> None:
    limit = (Fraction(-1), Fraction(1))
    smooth = read_text(
        "name: s\nfriction_at_rest: {smooth: {velocity: 0.1}}\n"
        "links: [{joint: revolute, inertia: {zz: 1}, friction: {coulomb: 1}}]"
    )
    _, program = inverse_dynamics(smooth, "float").unit.functions[0]
    with pytest.raises(InputError, match="the operation tanh"):
        Forward(program, dict.fromkeys(program.inputs(), limit), "float", 1.0)
    _, program = inverse_dynamics(TWO, "float").unit.functions[0]
    with pytest.raises(InputError, match="no range is known"):
        Forward(program, {}, "float", 1.0)
    with pytest.raises(InputError, match="may not fit into a float"):
        Forward(program, {x: (Fraction(-(10**30)), Fraction(10**30)) for x in program.inputs()}, "float", 1.0)
    with pytest.raises(InputError, match="beyond what the sine"):
        Forward(program, dict.fromkeys(program.inputs(), limit), "float", 1.0, 0.5)


@pytest.mark.parametrize(
    ("code", "said", "reason"),
    [
        (None, "", "not finished after 5 s"),
        (1, "Error: syntax error", "no bound found: Error: syntax error"),
        (0, "Results:\n  result in [-1, 1]\nWarning: no path was found", "no bound found"),
    ],
)
def test_what_is_no_bound_is_none(code: int | None, said: str, reason: str) -> None:
    found = read(Finished(code, said), 5)
    assert found.error is None
    assert found.reason.startswith(reason)


def test_gappa_answers_are_read_outwards() -> None:
    said = (
        "Results:\n  result in [-3b-1 {-1.5, -2^(0.58)}, 1b70]\n"
        "  result - E_result in [-1b-80, 36893488147419103233b-90]"
    )
    found = read(Finished(0, said), 5)
    assert (found.low, found.high) == (-1.5, 2.0**70)
    assert found.error is not None
    assert Fraction(found.error) > Fraction(36893488147419103233, 2**90)
