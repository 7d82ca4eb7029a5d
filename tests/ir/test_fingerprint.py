"""Fingerprints: alike for equal functions, different for others."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.programs import EVERYTHING, EXACT, Point, points, programs, results
from robodyn.ir import Graph, Input, Operation, Program
from robodyn.ir.field import Field
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.lowering import lower
from robodyn.robot.values import circle_point

X, Q1 = Input("x", None), Input("q", 0)

# --- fingerprints -----------------------------------------------------------------------------------------


def print_or_reject(made: Program, seed: int = 1) -> tuple[int, ...]:
    try:
        return fingerprint(made, seed, circle_point)
    except ZeroDivisionError:
        reject()


@settings(deadline=None, max_examples=70)
@given(programs(EVERYTHING), st.integers(0, 99), st.booleans())
def test_the_same_function_has_the_same_fingerprint(made: Program, seed: int, fold: bool) -> None:
    expected = print_or_reject(made, seed)
    graph = Graph(fold=fold)
    again = lower(graph, [("all", graph.replay(made))])
    assert fingerprint(again, seed, circle_point) == expected
    assert len(expected) == len(made.results())
    assert all(0 <= x < Field(f"seed {seed}").prime for x in expected)


@settings(deadline=None, max_examples=70)
@given(programs(EXACT), points, st.integers(0, 99))
def test_fingerprints_differ_exactly_where_values_do(made: Program, at: Point, seed: int) -> None:
    """Pairs of results, each with each: equal in the field, equal as fractions, and the other way round.

    ``sign`` is a random function in the field, and the point is only one point: both are allowed for.
    """
    prints = print_or_reject(made, seed)
    try:
        exact = results(made, at)
    except ZeroDivisionError:
        reject()
    signs = any(op.op in ("sign", "select") for op in made.operations)
    for i, (one, a) in enumerate(zip(prints, exact, strict=True)):
        for other, b in zip(prints[:i], exact[:i], strict=True):
            if a != b:
                assert one != other
            elif one != other and not signs:
                assert any(
                    results(made, Point(k))[i] != results(made, Point(k))[exact.index(b)] for k in range(5)
                )


def test_fingerprints_of_functions_without_theorems() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    values = [
        graph.tanh(x - y),
        graph.tanh(y - x),
        graph.sign(x - y),
        graph.sign(y - x),
        graph.sqrt(x),
        graph.sqrt(y),
    ]
    field = Field("here")
    a, minus_a, b, minus_b, c, d = fingerprint(lower(graph, [("t", values)]), field, circle_point)
    assert (a + minus_a) % field.prime == 0
    assert (b + minus_b) % field.prime == 0
    assert len({a, minus_a, b, minus_b, c, d}) == 6


@pytest.mark.parametrize("op", ["tanh", "sign", "abs", "sqrt", "exp", "pow"])
def test_a_function_has_its_own_value_at_zero(op: str) -> None:
    """``fold`` may find that its argument is 0, and must then not be taken for a wrong pass."""
    args = (0, Fraction(3, 2)) if op == "pow" else (0,)
    made = Program((Operation("sub", (X, X)), Operation(op, args)), (("t", (1,)),))
    assert fingerprint(made, 1, circle_point) == (int(op == "exp"),)


def test_the_angle_of_a_point_is_odd_and_of_both_coordinates() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    values = [graph.atan2(y - x, x), graph.atan2(x - y, x), graph.atan2(y - x, y), graph.atan2(0, x)]
    field = Field("here")
    a, minus_a, b, half_turn = fingerprint(lower(graph, [("t", values)]), field, circle_point)
    assert (a + minus_a) % field.prime == 0
    assert len({a, minus_a, b, half_turn, 0}) == 5  # the last is pi where x is negative


def test_a_choice_is_looked_at_on_both_sides() -> None:
    """Linear in what is chosen from, so that what holds for either choice holds; else for neither alone."""
    graph = Graph()
    x, y, z = (graph.input(name) for name in "xyz")
    chosen = graph.select(x, y, z)
    pairs = [
        (3 * chosen, graph.select(x, 3 * y, 3 * z), True),
        (graph.select(x, y, z) - z, graph.select(x, y - z, 0), True),
        (chosen, graph.select(x, y, z + 1), False),
        (chosen, graph.select(x, y + 1, z), False),
        (chosen, graph.select(-x, z, y), False),  # not where x is 0
        (chosen, graph.select(y, y, z), False),
    ]
    for one, other, same in pairs:
        a, b = fingerprint(lower(graph, [("t", [one, other])]), 1, circle_point)
        assert (a == b) == same


def test_division_by_what_is_zero_as_a_function() -> None:
    graph = Graph(fold=False)
    q = graph.input("q", 0)
    nothing = graph.sin(q) * graph.sin(q) + graph.cos(q) * graph.cos(q) - 1
    with pytest.raises(ZeroDivisionError):
        fingerprint(lower(graph, [("t", [graph.div(1, nothing)])]), 1, circle_point)
