"""Arctangents, choices, inverse kinematics and functions that repeat a step: the same bits in every language,
and no more steps than are allowed."""

from __future__ import annotations

import dataclasses
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.angles import FUNCTION, NAME, TYPES, of_program, program
from emit.every_language import LANGUAGES, outcome
from emit.kernels import write
from robodyn.certify import eva
from robodyn.certify.plan import run
from robodyn.counts import count
from robodyn.effects.scalars import choose, magnitude
from robodyn.emit.render import environment
from robodyn.errors import InputError
from robodyn.firmware.digest import kernel_sine, outputs
from robodyn.ir import Graph, Input, Program
from robodyn.ir.evaluate import evaluate
from robodyn.ir.fingerprint import digest
from robodyn.ir.lowering import lower
from robodyn.ir.program import STATE, Iteration
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.passes.order import arctangents_together
from robodyn.robot import load
from robodyn_testing import require_tool

IK = ("inverse_kinematics", "nearest_inverse_kinematics")
#: Of the square roots by Newton's method.
TOLERANCE = Fraction(1, 10**3)


@cache
def roots(most: int = 20, rows: int = 3) -> Program:
    """Of q [3] the roots of |q| + 1 times q, from a state (argument, root, done) for each of ``rows``."""
    graph = Graph()
    squares = [magnitude(graph.input("q", i)) + 1 for i in range(rows)]
    start = lower(graph, [(STATE, [x for a in squares for x in (a, a, Fraction(0))])])
    graph = Graph()
    a, y, _ = (graph.input(STATE, i) for i in range(3))
    better: Any = (y + a / y) / 2
    done = choose(magnitude(better - y) - TOLERANCE, 0, 1)
    step = lower(graph, [(STATE, [a, better, done])])
    graph = Graph()
    parts = [graph.input(STATE, 3 * (i % rows) + 1) for i in range(3)]
    finish = lower(graph, [("tau", [graph.input("q", i) * root for i, root in enumerate(parts)])])
    return dataclasses.replace(finish, iteration=Iteration(start, step, most))


def states() -> NDArray[Any]:
    """Random states, of all sizes, and those of which numbers are 0 or on the edge of a choice."""
    random = np.random.default_rng(4)
    edges = np.array(np.meshgrid(*[[0.0, -0.0, 1.0, -1.5]] * 3)).reshape(3, -1).T
    sizes = random.uniform(-1, 1, (50, 3)) * [0.1, 30.0, 1e4]
    return np.concatenate([random.uniform(-3, 3, (200, 3)), sizes, edges])


def poses(joints: int) -> dict[str, NDArray[Any]]:
    random = np.random.default_rng(1)
    turns = np.linalg.qr(random.normal(size=(200, 3, 3)))[0]
    turns *= np.linalg.det(turns)[:, None, None]
    T = np.concatenate([turns, random.uniform(-0.6, 0.6, (200, 3, 1))], axis=2).reshape(200, 12)
    return {"T": T, "q_near": random.uniform(-3, 3, (200, joints))}


def case(name: str, scalar: str) -> tuple[Generated, dict[str, NDArray[Any]]]:
    """Kernels, and inputs for all of their functions."""
    own = {"arctangents": program(), "roots": roots(), "one root": roots(20, 1)}
    if name in own:
        return of_program(own[name], scalar), {"q": states()}
    options = Options(trig="builtin", scalar=scalar, functions=IK)  # type: ignore[arg-type]
    robot = load(name, warn=lambda _: None)
    return generate(robot, options), poses(robot.n)


THOROUGH, SLOW = pytest.mark.thorough, pytest.mark.slow
CASES = [
    ("arctangents", "double"),
    ("roots", "double"),
    pytest.param("arctangents", "float", marks=SLOW),
    pytest.param("one root", "double", marks=THOROUGH),
    pytest.param("roots", "float", marks=SLOW),
    pytest.param("puma560", "double", marks=SLOW),
    pytest.param("ur5", "float", marks=THOROUGH),
    pytest.param("iiwa", "double", marks=SLOW),
]


@pytest.mark.parametrize("language", [*LANGUAGES[:-1], pytest.param("rust", marks=THOROUGH)])
@pytest.mark.parametrize(("name", "scalar"), CASES)
def test_every_language_gives_the_bits_of_the_program(
    name: str, scalar: str, language: str, tmp_path: Path
) -> None:
    """The program in numpy, whose arctangent is written down a second time."""
    if (language, scalar) == ("javascript", "float") or (language == "batch" and "root" in name):
        return  # there is no such thing
    generated, inputs = case(name, scalar)
    inputs = {array: x.astype(TYPES[scalar]) for array, x in inputs.items()}
    for signature, emitted in generated.unit.functions:
        given = {array: inputs[array] for array, _ in signature.inputs}
        expected = outputs(emitted, given, {}, scalar, kernel_sine(scalar))  # type: ignore[arg-type]
        assert np.isfinite(expected).all()
        found = outcome(language, generated, signature.function, given, tmp_path)
        assert found.tobytes() == expected.tobytes(), signature.function


def test_arctangents_that_do_not_need_each_other_stand_together() -> None:
    joined = arctangents_together(program())
    ops = [op.op for op in joined.operations]
    runs = [len(run) for run in "".join("a" if op == "atan2" else " " for op in ops).split()]
    assert sum(runs) == ops.count("atan2") == [op.op for op in program().operations].count("atan2")
    assert runs == [5, 3, 1]  # two of the five have constant coordinates
    q = {Input("q", i): x for i, x in enumerate((0.3, -0.8, 1.7))}
    assert evaluate(joined, q) == evaluate(program(), q)


def test_a_choice_for_misra_has_its_condition_in_parentheses() -> None:
    generated = of_program(program(), "double")
    unit = dataclasses.replace(generated.unit, misra=True)
    files = dataclasses.replace(generated, unit=unit).files(("c",))
    assert "((q[1] > 0.0) ? 3.0 :" in files[f"{NAME}.c"]


@pytest.mark.thorough
def test_eva_looks_at_every_turn_of_the_loop(tmp_path: Path) -> None:
    """Of twenty arctangents, which are written one by one before they are read."""
    generated = generate(load("puma560", warn=lambda _: None), Options(trig="builtin", functions=IK[:1]))
    write(tmp_path, generated.files(("c",)))
    context = eva.driver_context("puma560", generated.signatures)
    driver = environment().get_template("prove/eva_driver.c.j2").render(context)
    (tmp_path / "driver.c").write_text(driver, encoding="utf-8")
    command = [require_tool("frama-c"), *eva.OPTIONS, "puma560.c", "driver.c"]
    analysis = eva.read(run(command, tmp_path, 300), 300)
    assert analysis.proved, analysis.reason


# --- a step that is repeated ------------------------------------------------------------------------------


def test_each_row_is_stepped_until_it_is_done_and_no_more_often_than_is_allowed() -> None:
    q = states()
    inputs = {Input("q", i): q[:, i] for i in range(3)}
    together = np.stack(evaluate(roots(), inputs, functions={"abs": np.abs})["tau"], axis=1)
    np.testing.assert_allclose(together, q * np.sqrt(1 + np.abs(q)), rtol=1e-6)
    alone = [evaluate(roots(), {Input("q", i): float(x) for i, x in enumerate(row)})["tau"] for row in q]
    assert np.array_equal(together, alone)
    row = (0.1, 30.0, 1e4)
    once = [x * ((1 + x) + 1) / 2 for x in row]
    assert evaluate(roots(1), {Input("q", i): x for i, x in enumerate(row)})["tau"] == pytest.approx(once)


def test_what_it_reads_and_counts_and_what_tells_it_from_others() -> None:
    whole = roots()
    assert set(whole.inputs()) == {Input("q", i) for i in range(3)}
    start, step, finish = map(count, whole.parts())
    assert count(whole).total == start.total + 3 * 20 * step.total + finish.total
    assert len({digest(each) for each in (whole, roots(19), roots(20, 2), whole.parts()[2])}) == 4
    with pytest.raises(InputError, match=r"tasks are only of straight-line code; found .* 20 times at most"):
        whole.straight("tasks are")
    with pytest.raises(InputError, match="batches on vectors are only of straight-line code"):
        of_program(whole, "double").files(("c",), batch=True)


def test_the_header_says_how_many_steps_and_stages_are_nobodys_business() -> None:
    files = of_program(roots(), "double").files(("c", "fortran", "rust", "javascript"))
    header = files[f"{NAME}.h"]
    assert "60 steps at most, each of 1 multiplication, 3 additions, 1 division" in " ".join(header.split())
    assert header.count(f"void {FUNCTION}") == 1
    assert f"static void {FUNCTION}_step_(const {NAME}_real x[3], {NAME}_real next[3])" in files[f"{NAME}.c"]
    for file, public in ((f"{NAME}.f90", "public :: "), (f"{NAME}.mjs", "export function ")):
        assert f"{public}{FUNCTION}_" not in files[file]
    assert "pub fn gravity_" not in files["src/lib.rs"]
