"""Programs as data, and what evaluating them over one scalar or another gives."""

from __future__ import annotations

import gc
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.programs import EXACT, Point, interpreted, points, programs
from robodyn.ir import Graph, Input, Label, Operation, Program
from robodyn.ir.evaluate import angle_form, evaluate, evaluate_exact, selected
from robodyn.ir.lowering import lower
from robodyn.ir.program import RARELY, rarely_collected
from robodyn.robot.values import circle_point

X, Q1, Q2 = Input("x", None), Input("q", 0), Input("q", 1)


def small() -> Program:
    """``tau = [x q2 - 1/2 sin(q1), x]`` and a constant."""
    return Program(
        (
            Operation("sin", (Q1,), Label(1, "s", "")),
            Operation("mul", (X, Q2)),
            Operation("mul", (Fraction(1, 2), 0)),
            Operation("sub", (1, 2), Label(1, "tau", "", negative=True)),
        ),
        (("tau", (3, X)), ("M", (Fraction(-3, 4), 0))),
    )


def sign(x: float) -> float:
    return float((x > 0) - (x < 0))


REAL: dict[str, Callable[..., Any]] = {
    "sin": math.sin,
    "cos": math.cos,
    "tanh": math.tanh,
    "sign": sign,
    "select": selected,
}


def test_a_dump_can_be_read() -> None:
    assert small().dump() == (
        "%0 = sin q1   # s1\n"
        "%1 = mul x, q2\n"
        "%2 = mul 1/2, %0\n"
        "%3 = sub %1, %2   # neg_tau1\n"
        "tau = [%3, x]\n"
        "M = [-3/4, %0]"
    )


# --- evaluation over any scalar ---------------------------------------------------------------------------


@settings(deadline=None, max_examples=70)
@given(programs(EXACT), points)
def test_evaluate_does_what_the_operators_do(made: Program, at: Point) -> None:
    numbers = {x: float(at.number(x)) for x in made.inputs()}
    try:
        direct = interpreted(made, lambda x: numbers[x], REAL, float)
        found = evaluate(made, numbers)
    except (ZeroDivisionError, OverflowError):
        reject()
    flat = [x for elements in found.values() for x in elements]
    assert [repr(float(x)) for x in flat] == [repr(float(x)) for x in direct]  # nan and -0.0 too
    assert {name: len(elements) for name, elements in found.items()} == {
        name: len(elements) for name, elements in made.outputs
    }


@settings(deadline=None, max_examples=70)
@given(st.integers(-3, 3), st.integers(-3, 3), st.fractions(-7, 7, max_denominator=30))
def test_angle_forms(m: int, n: int, constant: Fraction) -> None:
    graph = Graph(fold=False)
    angle: Any = graph.constant(constant)
    for node, multiple in ((graph.input("q", 0), m), (graph.input("q", 1), n)):
        for _ in range(abs(multiple)):
            angle = angle + node if multiple > 0 else angle - node
    made = lower(graph, [("t", [graph.sin(angle)])])
    outer = -1 if made.operations[-1].op == "neg" else 1  # the sine is odd: of which of the two angles it is
    argument = next(op.args[0] for op in made.operations if op.op == "sin")
    terms, rest = angle_form(made, argument)
    assert (dict(terms), rest) == (
        {x: outer * k for x, k in ((Q1, m), (Q2, n)) if k},
        outer * constant,
    )


def test_the_argument_of_a_sine_must_be_an_angle() -> None:
    made = Program((Operation("mul", (X, Q1)), Operation("sin", (0,))), (("t", (1,)),))
    with pytest.raises(ValueError, match="mul in the argument of a sine"):
        angle_form(made, 0)


# --- sines of sums ----------------------------------------------------------------------------------------


def test_a_constant_angle_has_its_own_point() -> None:
    made = Program(
        (Operation("cos", (Fraction(1, 2),)), Operation("sin", (Fraction(1, 2),))), (("t", (0, 1)),)
    )
    found = evaluate_exact(made, {}, {}, circle_point)["t"]
    assert tuple(found) == circle_point(Fraction(1, 2))
    assert [float(x) for x in found] == [math.cos(0.5), math.sin(0.5)]


# While programs are built Python looks for garbage rarely, and afterwards as often as before.


@pytest.fixture(params=[(700, 10, 10), (0, 10, 10), (RARELY[0] + 1, 3, 3)])
def thresholds(request: pytest.FixtureRequest) -> Iterator[tuple[int, int, int]]:
    before = gc.get_threshold()
    gc.set_threshold(*request.param)
    yield request.param
    gc.set_threshold(*before)


def test_it_is_rare_within_and_as_before_behind(thresholds: tuple[int, int, int]) -> None:
    rare = RARELY if thresholds == (700, 10, 10) else thresholds  # who looks more rarely is left alone
    with rarely_collected():
        assert gc.get_threshold() == rare
        with rarely_collected():
            assert gc.get_threshold() == rare
        assert gc.get_threshold() == rare
    assert gc.get_threshold() == thresholds
    with pytest.raises(ValueError, match="here"), rarely_collected():
        raise ValueError("here")
    assert gc.get_threshold() == thresholds
