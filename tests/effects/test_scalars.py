"""Functions of scalars of any kind: the same value whatever the scalar is."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy

from robodyn.effects.scalars import arctangent, choose, root, sine
from robodyn.ir import Graph, Input
from robodyn.ir.evaluate import evaluate
from robodyn.ir.lowering import lower

POINTS = [(1.5, 2.0), (-1.5, 2.0), (0.5, -2.0), (-0.5, -2.0), (0.0, -1.0), (0.0, 1.0), (0.0, 0.0), (2.0, 0.0)]


def of_graph(y: float, x: float, function: Any) -> float:
    graph = Graph()
    program = lower(graph, [("t", [function(graph.input("y"), graph.input("x"))])])
    return float(evaluate(program, {Input("y", None): y, Input("x", None): x})["t"][0])


@pytest.mark.parametrize(("y", "x"), POINTS)
def test_arctangents_of_all_scalars(y: float, x: float) -> None:
    expected = math.atan2(y, x)
    kinds = [
        Fraction,
        mpmath.mpf,
        sympy.Rational,
        np.float64,
        lambda z: np.array([z, z]),
    ]
    for kind in kinds:
        for of_y, of_x in ((kind(y), kind(x)), (kind(y), Fraction(x)), (Fraction(y), kind(x))):
            angle = arctangent(of_y, of_x)
            assert np.ravel(np.asarray(angle, dtype=float))[0] == pytest.approx(expected)
    assert of_graph(y, x, arctangent) == expected
    assert of_graph(-y, x, lambda a, b: arctangent(-a, b)) == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize(
    ("condition", "expected"), [(2.0, 5.0), (1e-9, 5.0), (0.0, 7.0), (-0.0, 7.0), (-3.0, 7.0)]
)
def test_choices_of_all_scalars(condition: float, expected: float) -> None:
    for kind in (Fraction, mpmath.mpf, sympy.Rational, float, np.float64):
        assert float(choose(kind(condition), 5, 7)) == expected
        assert float(choose(kind(condition), kind(5), kind(7))) == expected
    assert of_graph(condition, 0.0, lambda c, _: choose(c, 5, 7)) == expected


def test_no_number_is_not_more_than_zero() -> None:
    assert choose(math.nan, 5, 7) == 7
    assert choose(mpmath.mpf("nan"), 5, 7) == 7
    assert choose(np.array([math.nan, 1.0, -1.0]), 5, np.array([7, 8, 9])).tolist() == [7, 5, 9]
    assert of_graph(math.nan, 0.0, lambda c, _: choose(c, 5, 7)) == 7


def test_numbers_of_many_digits_keep_them() -> None:
    with mpmath.workdps(50):
        two = mpmath.mpf(2)
        assert abs(root(two) ** 2 - 2) < mpmath.mpf(10) ** -48
        assert abs(mpmath.tan(arctangent(two, Fraction(3))) - two / 3) < mpmath.mpf(10) ** -48
        assert abs(sine(mpmath.pi / 6) - mpmath.mpf(1) / 2) < mpmath.mpf(10) ** -48
