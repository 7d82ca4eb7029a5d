"""Functions that repeat a step: the same bits in every language, and no more steps than are allowed."""

from __future__ import annotations

import dataclasses
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.angles import FUNCTION, NAME, TYPES
from emit.crates import Crate
from emit.kernels import STRICT, STRICT_FORTRAN, write
from emit.modules import Module
from emit.test_arctangent import library, rows
from robodyn.counts import count
from robodyn.effects.scalars import choose, magnitude
from robodyn.errors import InputError
from robodyn.ir import Graph, Input, Program
from robodyn.ir.evaluate import evaluate
from robodyn.ir.fingerprint import digest
from robodyn.ir.lowering import lower
from robodyn.ir.program import STATE, Iteration
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

#: Square roots of |q| + 1 by Newton's method, at 1e-3, times q.
TOLERANCE = Fraction(1, 10**3)


@cache
def program(most: int = 20, rows: int = 3) -> Program:
    """Of q [3] the roots of the first ``rows``, each from a state (argument, root, done)."""
    graph = Graph()
    squares = [magnitude(graph.input("q", i)) + 1 for i in range(rows)]
    start = lower(graph, [(STATE, [x for a in squares for x in (a, a, Fraction(0))])])
    graph = Graph()
    a, y, _ = (graph.input(STATE, i) for i in range(3))
    better: Any = (y + a / y) / 2
    done = choose(magnitude(better - y) - TOLERANCE, 0, 1)
    step = lower(graph, [(STATE, [a, better, done])])
    graph = Graph()
    roots = [graph.input(STATE, 3 * (i % rows) + 1) for i in range(3)]
    finish = lower(graph, [("tau", [graph.input("q", i) * root for i, root in enumerate(roots)])])
    return dataclasses.replace(finish, iteration=Iteration(start, step, most))


def states() -> NDArray[Any]:
    q: NDArray[Any] = np.random.default_rng(7).uniform(-1, 1, (50, 3)) * np.array([0.1, 30.0, 1e4])
    return q


def expected(whole: Program, q: NDArray[np.float64]) -> NDArray[Any]:
    inputs = ({Input("q", i): float(x) for i, x in enumerate(row)} for row in q)
    return np.array([evaluate(whole, each)["tau"] for each in inputs])


def generated_of(whole: Program, scalar: str = "double") -> Generated:
    options = Options(trig="builtin", scalar=scalar, functions=("gravity",))  # type: ignore[arg-type]
    generated = generate(load(NAME, warn=lambda _: None), options)
    ((signature, _),) = generated.unit.functions
    return dataclasses.replace(
        generated, unit=dataclasses.replace(generated.unit, functions=((signature, whole),))
    )


# --- as data ------------------------------------------------------------------------------------------------


def test_each_row_is_stepped_until_it_is_done() -> None:
    q = states()
    np.testing.assert_allclose(expected(program(), q), q * np.sqrt(1 + np.abs(q)), rtol=1e-6)


def test_no_more_steps_than_are_allowed() -> None:
    a, b, c = (1 + abs(x) for x in (0.1, 30.0, 1e4))
    once = [x * (y + y / y) / 2 for x, y in zip((0.1, 30.0, 1e4), (a, b, c), strict=True)]
    assert expected(program(1), np.array([[0.1, 30.0, 1e4]])).tolist() == [once]


def test_arrays_of_states_stop_each_for_itself() -> None:
    q = states()
    inputs = {Input("q", i): q[:, i] for i in range(3)}
    together = evaluate(program(), inputs, functions={"abs": np.abs})["tau"]
    assert np.array_equal(np.stack(together, axis=1), expected(program(), q))


def test_what_it_reads_and_counts_and_what_tells_it_from_others() -> None:
    whole = program()
    assert set(whole.inputs()) == {Input("q", i) for i in range(3)}
    start, step, finish = map(count, whole.parts())
    assert count(whole).total == start.total + 3 * 20 * step.total + finish.total
    assert len({digest(each) for each in (whole, program(19), program(20, 2), whole.parts()[2])}) == 4
    assert whole.changed(lambda part: part) == whole
    with pytest.raises(InputError, match=r"tasks are only of straight-line code; found .* 20 times at most"):
        whole.straight("tasks are")


# --- as text ------------------------------------------------------------------------------------------------

_PLAIN = ("-O2", "-ffp-contract=off")


@pytest.mark.parametrize("count_of_rows", [3, pytest.param(1, marks=pytest.mark.thorough)])
def test_every_language_gives_the_bits_of_the_program(count_of_rows: int, tmp_path: Path) -> None:
    whole, q = program(20, count_of_rows), states()
    generated = generated_of(whole)
    c = write(tmp_path, generated.files(("c",)))
    torques = {"c": rows(library(tmp_path, c, require_tool("gcc"), *STRICT, *_PLAIN), FUNCTION, q)}
    fortran = write(tmp_path, generated.files(("fortran",)))
    torques["fortran"] = rows(
        library(tmp_path, fortran, require_tool("gfortran"), *STRICT_FORTRAN, *_PLAIN), f"{FUNCTION}_f", q
    )
    torques["javascript"] = Module(generated, tmp_path).run("gravity", {"q": q}, {}, 0.0)
    for language, results in torques.items():
        assert results.tobytes() == expected(whole, q).tobytes(), language


@pytest.mark.thorough
@pytest.mark.parametrize("count_of_rows", [1, 3])
@pytest.mark.parametrize("scalar", ["double", "float"])
def test_rust_gives_the_bits_of_the_c(scalar: str, count_of_rows: int, tmp_path: Path) -> None:
    generated, q = generated_of(program(20, count_of_rows), scalar), states().astype(TYPES[scalar])
    c = write(tmp_path, generated.files(("c",)))
    one = rows(library(tmp_path, c, require_tool("clang"), *STRICT, *_PLAIN), FUNCTION, q)
    assert Crate(generated, tmp_path).run("gravity", {"q": q}, {}, 0.0).tobytes() == one.tobytes()


def test_the_header_says_how_many_steps_and_stages_are_nobodys_business() -> None:
    files = generated_of(program()).files(("c", "fortran", "rust", "javascript"))
    header = files[f"{NAME}.h"]
    assert "60 steps at most, each of 1 multiplication, 3 additions, 1 division" in " ".join(header.split())
    assert header.count(f"void {FUNCTION}") == 1
    for text in files.values():
        assert "step_" not in text or "public :: " + FUNCTION + "_" not in text
    assert f"static void {FUNCTION}_step_(const {NAME}_real x[3], {NAME}_real next[3])" in files[f"{NAME}.c"]
    assert "export function " + FUNCTION + "_" not in files[f"{NAME}.mjs"]
    assert "pub fn gravity_" not in files["src/lib.rs"]


def test_vectors_and_tasks_are_of_straight_line_code() -> None:
    with pytest.raises(InputError, match="batches on vectors are only of straight-line code"):
        generated_of(program()).files(("c",), batch=True)
