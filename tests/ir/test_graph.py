"""Nodes behave like numbers, equal ones are one, and what is written out means what was built."""

from __future__ import annotations

import operator
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.programs import EXACT, Point, interpreted, points, programs, results
from robodyn.ir import Graph, Input, Label, Node, Program
from robodyn.ir.lowering import lower
from robodyn.passes.negate import negate

SIGNED = {"add", "scale", "mul", "div", "atan2", "select"}


def leaf(graph: Graph) -> Callable[[Input], Node]:
    return lambda x: graph.input(*x)


def functions_of(graph: Graph) -> dict[str, Callable[[Any], Any]]:
    return {op: getattr(graph, op) for op in ("sin", "cos", "sqrt", "tanh", "sign", "select")}


def built(program: Program, graph: Graph) -> list[Any]:
    """The results of ``program`` as values of ``graph``; a division by 0 rejects the example."""
    try:
        return interpreted(program, leaf(graph), functions_of(graph))
    except ZeroDivisionError:
        reject()


def exact_or_reject(program: Program, at: Point) -> list[Fraction]:
    try:
        return results(program, at)
    except ZeroDivisionError:
        reject()


# --- arithmetic -------------------------------------------------------------------------------------------


@settings(deadline=None, max_examples=70)
@given(programs(EXACT), points, st.booleans())
def test_replay_and_operators_build_the_same_nodes(program: Program, at: Point, fold: bool) -> None:
    expected = exact_or_reject(program, at)
    graph = Graph(fold=fold)
    by_operators = built(program, graph)
    size = len(graph.keys)
    assert graph.replay(program) == by_operators
    assert len(graph.keys) == size
    assert results(lower(graph, [("all", by_operators)]), at) == expected


@settings(deadline=None, max_examples=70)
@given(programs(EXACT), points, st.booleans(), st.data())
def test_any_choice_of_stored_signs_means_the_same(
    program: Program, at: Point, fold: bool, data: st.DataObject
) -> None:
    expected = exact_or_reject(program, at)  # first: it rejects divisions by zero
    graph = Graph(fold=fold)
    values = built(program, graph)
    free = [p for p, key in enumerate(graph.keys) if key[0] in SIGNED]
    stored = {p: -1 for p in free if data.draw(st.booleans())}
    program_out = lower(graph, [("all", values)], stored)
    assert results(program_out, at) == expected
    by_place = dict(enumerate(program_out.operations))
    for i, (_, args, _) in by_place.items():
        assert all(arg < i for arg in args if isinstance(arg, int))


def test_a_minus_is_written_once_where_signs_do_not_fit() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    product = x * y
    plain = lower(graph, [("t", [-product, -product, product])])
    assert [op.op for op in plain.operations] == ["mul", "neg"]
    assert plain.results() == (1, 1, 0)
    assert isinstance(product, Node)
    stored = lower(graph, [("t", [-product, -product, product])], {product.position: -1})
    assert [op.op for op in stored.operations] == ["neg", "mul", "neg"]
    assert stored.results() == (1, 1, 2)


def test_stored_signs_flip_labels() -> None:
    graph = Graph()
    product = graph.label(graph.input("x") * graph.input("y"), Label(2, "w", "x"))
    (_, operation) = lower(graph, [("t", [-product])], {product.position: -1}).operations
    assert operation.op == "mul"
    assert operation.label == Label(2, "w", "x", negative=True)


@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul, operator.truediv])
def test_a_float_is_not_taken_for_an_exact_number(operation: Callable[[Any, Any], Any]) -> None:
    x = Graph().input("x")
    with pytest.raises(TypeError):
        operation(x, 0.5)
    with pytest.raises(TypeError):
        operation(0.5, x)


def test_division_by_nothing() -> None:
    graph = Graph()
    x = graph.input("x")
    for divisor in (0, Fraction(0), x - x):
        with pytest.raises(ZeroDivisionError):
            x / divisor
        with pytest.raises(ZeroDivisionError):
            graph.div(1, divisor)


# --- equal nodes are one ----------------------------------------------------------------------------------


@pytest.mark.parametrize("fold", [True, False])
def test_order_and_sign_of_operands_do_not_matter(fold: bool) -> None:
    graph = Graph(fold=fold)
    x, y = graph.input("q", 0), graph.input("q", 1)
    pairs = [
        (x + y, y + x),
        (x - y, -(y - x)),
        (-x - y, -(x + y)),
        (x * y, y * x),
        (-x * y, -(x * y)),
        (-x * -y, x * y),
        (-x / y, -(x / y)),
        (x / -y, -(x / y)),
        (3 * x, x * 3),
        (-3 * x, -(3 * x)),
        (x / 4, x * Fraction(1, 4)),
        (graph.sin(-x), -graph.sin(x)),
        (graph.cos(-x), graph.cos(x)),
        (graph.tanh(-x), -graph.tanh(x)),
        (graph.sign(-x), -graph.sign(x)),
        (graph.input("q", 0), x),
        (1 - x, -(x - 1)),
        (2 + x, x + Fraction(2)),
    ]
    for one, other in pairs:
        assert one == other
        assert hash(one) == hash(other)
    size = len(graph.keys)
    assert (x + y, x * y, 3 * x, graph.sin(y - y + x)) == (y + x, y * x, x * 3, graph.sin(x)) or not fold
    assert len(graph.keys) == size or not fold


def test_what_differs_stays_apart() -> None:
    graph = Graph()
    x, y = graph.input("q", 0), graph.input("q", 1)
    values = [
        x, -x, y, x + y, x - y, y - x, x * y, x / y, y / x, 2 * x, 3 * x, x + 1, x - 1, x * x,
        graph.sin(x), graph.cos(x), graph.sin(y), graph.sqrt(x), graph.sqrt(-x), graph.tanh(x), graph.sign(x),
        graph.input("qd", 0), graph.input("q"), graph.constant(1), graph.constant(-1),
    ]  # fmt: skip
    assert len(set(values)) == len(values)
    assert all(a != b for i, a in enumerate(values) for b in values[:i])
    assert Graph().input("q", 0) != Graph().input("q", 0)
    assert x != 1
    assert x != 0


# --- folding ----------------------------------------------------------------------------------------------


def test_identities_fold() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    half = Fraction(1, 2)
    table: list[tuple[Any, Any]] = [
        (x * 0, 0),
        (0 * x, 0),
        (0 / x, 0),
        (x * 1, x),
        (x / 1, x),
        (x * -1, -x),
        (x + 0, x),
        (x - 0, x),
        (0 + x, x),
        (0 - x, -x),
        (x - x, 0),
        (x + x, 2 * x),
        (x / x, 1),
        (-x / x, -1),
        (2 * (3 * x), 6 * x),
        (2 * (half * x), x),
        (-2 * (half * x), -x),
        ((x / 3) * 3, x),
        (2 * x + 3 * x, 5 * x),
        (2 * x - 3 * x, -x),
        (x - half * x, half * x),
        (2 * x - 2 * x, 0),
        (x * y - y * x, 0),
        ((x + 1) + 2, x + 3),
        ((x + 1) - 1, x),
        ((x + 1) + (y + 2), (x + y) + 3),
        ((x - 1) - (y - 1), x - y),
        (graph.constant(2) * 3, 6),
        (graph.constant(-2) + 3, 1),
        (graph.sin(0), 0),
        (graph.tanh(0), 0),
        (graph.sign(0), 0),
        (graph.cos(0), 1),
    ]
    for found, expected in table:
        assert found == expected
        assert isinstance(found, Node) is isinstance(expected, Node)


# --- labels, order, what is needed ------------------------------------------------------------------------


def test_the_first_label_stays_and_leaves_have_none() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    value = x - y
    assert graph.label(value, Label(1, "w", "x")) is value
    graph.label(value, Label(2, "w", "x"))
    graph.label(-(x * y), Label(3, "n", "z"))
    graph.label(x, Label(1, "n", "x"))
    graph.label(Fraction(1), Label(1, "n", "x"))
    graph.label(graph.constant(2), Label(1, "n", "x"))
    program = lower(graph, [("t", [value, x * y])])
    assert [op.label for op in program.operations] == [Label(1, "w", "x"), Label(3, "n", "z", negative=True)]


# --- angles of points, choices ----------------------------------------------------------------------------


def test_choices_that_are_none() -> None:
    graph = Graph()
    x, y = graph.input("x"), graph.input("y")
    assert [graph.select(c, x, y) for c in (Fraction(1, 9), 0, -1)] == [x, y, y]
    assert graph.select(x, y, y) == y
    assert graph.select(x, Fraction(1, 2), Fraction(1, 2)) == Fraction(1, 2)


def test_a_choice_changes_its_sign_with_both_sides() -> None:
    graph = Graph()
    x, y, z = (graph.input(name) for name in "xyz")
    assert graph.select(z, -x, -y) == -graph.select(z, x, y)
    assert graph.select(z, x, -y) == -graph.select(z, -x, y) != graph.select(z, x, y)
    assert graph.select(z, 0, -y) == -graph.select(z, 0, y)
    assert graph.select(z, -x, 0) == -graph.select(z, x, 0)
    assert graph.select(-z, x, y) not in (graph.select(z, x, y), graph.select(z, y, x))
    plain = lower(graph, [("t", [graph.select(z, y - x, 0)])])
    assert [op.op for op in plain.operations] == ["sub", "select", "neg"]
    assert [op.op for op in negate(plain).operations] == ["sub", "select"]
