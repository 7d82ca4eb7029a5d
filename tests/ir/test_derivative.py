"""Derivatives of nodes against sympy's."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy

from robodyn.ir.derivative import jacobian
from robodyn.ir.evaluate import evaluate
from robodyn.ir.graph import Graph
from robodyn.ir.lowering import lower
from robodyn.ir.program import Input

INPUTS = [Input("x", 0), Input("x", 1), Input("p", None)]


def made(graph: Graph, x: Any, y: Any, p: Any) -> list[Any]:
    """Values that use every operation."""
    return [
        x * y + 3 * x - y,
        (x - y) * (x - y) * p,
        graph.div(x, y + 4),
        graph.sin(x + 2 * y) * graph.cos(x - y),
        -graph.sqrt(x * x + y * y + 1),
        graph.tanh(x * y),
        graph.abs(x * y) * x,
        graph.exp(-(x * x)) + graph.exp(y),
        graph.pow(graph.abs(x), Fraction(7, 5)),
        graph.pow(x * x, p),
        graph.sign(x) * y,
        graph.atan2(-x * y, x - p),
        graph.select(x - y, x * x, -y),
        -(x - x * 2) * 5,
        7,
    ]


def expected(x: Any, y: Any, p: Any) -> list[Any]:
    return [
        x * y + 3 * x - y,
        (x - y) ** 2 * p,
        x / (y + 4),
        sympy.sin(x + 2 * y) * sympy.cos(x - y),
        -sympy.sqrt(x * x + y * y + 1),
        sympy.tanh(x * y),
        sympy.Abs(x * y) * x,
        sympy.exp(-x * x) + sympy.exp(y),
        sympy.Abs(x) ** sympy.Rational(7, 5),
        (x * x) ** p,
        sympy.sign(x) * y,
        sympy.atan2(-x * y, x - p),
        sympy.Piecewise((x * x, x > y), (-y, True)),
        5 * x,
        sympy.Integer(7),
    ]


@pytest.mark.parametrize("point", [(0.7, -1.3, 1.5), (-0.4, 0.9, 2.25), (1.1, 2.0, 0.5)])
def test_all_operations_against_sympy(point: tuple[float, float, float]) -> None:
    graph = Graph()
    x, y, p = (graph.input(*each) for each in INPUTS)
    rows = jacobian(graph, made(graph, x, y, p), INPUTS[:2])
    program = lower(graph, [("J", [entry for row in rows for entry in row])])
    found = evaluate(program, dict(zip(INPUTS, point, strict=True)))["J"]
    symbols = sympy.symbols("x y", real=True)
    values = dict(zip(symbols, point, strict=False))
    truth = [
        float(sympy.diff(each, symbol).subs(values).replace(sympy.DiracDelta, lambda *_: 0))
        for each in expected(symbols[0], symbols[1], sympy.Float(point[2], 17))
        for symbol in symbols
    ]
    assert found == pytest.approx(truth, rel=1e-12, abs=1e-14)


def test_an_exponent_that_depends_on_the_input_is_refused() -> None:
    graph = Graph()
    x = graph.input("x", 0)
    with pytest.raises(ValueError, match="exponent"):
        jacobian(graph, [graph.pow(x, x)], INPUTS[:1])


def test_the_root_of_a_sum_of_squares_has_a_derivative_at_zero() -> None:
    graph = Graph()
    x, y = graph.input("x", 0), graph.input("x", 1)
    rows = jacobian(graph, [graph.sqrt(x * x + y * y)], INPUTS[:2])
    program = lower(graph, [("J", [entry for row in rows for entry in row])])
    assert evaluate(program, {INPUTS[0]: 0.0, INPUTS[1]: 0.0})["J"] == [0.0, 0.0]
