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

from ir.programs import EXACT, Point, interpreted, points, programs, results
from robodyn.ir import Graph, Input, Label, Operation, Program
from robodyn.ir.evaluate import angle_form, evaluate, evaluate_exact, selected
from robodyn.ir.fingerprint import fingerprint
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


def test_inputs_uses_and_results() -> None:
    assert small().inputs() == (Q1, X, Q2)
    assert small().uses() == [2, 1, 1, 1]
    assert small().results() == (3, X, Fraction(-3, 4), 0)


def test_names_of_inputs_and_labels() -> None:
    assert [str(x) for x in (Q1, Input("qdd", 11), X)] == ["q1", "qdd12", "x"]
    label = Label(3, "w", "x")
    assert [str(label), str(label.flipped()), str(Label(2, "tau", ""))] == ["w3_x", "neg_w3_x", "tau2"]
    assert label.flipped().flipped() == label


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


THIRD = circle_point(Fraction(1, 3))
#: Of the angles a and b: what is, and is not, equal.
THEOREMS: dict[str, Callable[[Graph, Any, Any], tuple[Any, Any]]] = {
    "sine of a sum": lambda g, a, b: (g.sin(a + b), g.sin(a) * g.cos(b) + g.cos(a) * g.sin(b)),
    "cosine of a sum": lambda g, a, b: (g.cos(a + b), g.cos(a) * g.cos(b) - g.sin(a) * g.sin(b)),
    "difference": lambda g, a, b: (g.cos(b - a), g.cos(a) * g.cos(b) + g.sin(a) * g.sin(b)),
    "double angle": lambda g, a, b: (g.cos(a + a), 1 - 2 * (g.sin(a) * g.sin(a))),
    "constant": lambda g, a, b: (g.sin(a + Fraction(1, 3)), g.sin(a) * THIRD[0] + g.cos(a) * THIRD[1]),
    "circle": lambda g, a, b: (g.sin(a) * g.sin(a) + g.cos(a) * g.cos(a), Fraction(1)),
    "not of a sum": lambda g, a, b: (g.sin(a + b), g.sin(a) + g.sin(b)),
    "not even": lambda g, a, b: (g.sin(a + b), g.sin(a - b)),
    "not of another angle": lambda g, a, b: (g.cos(a), g.cos(b)),
    "not of another function": lambda g, a, b: (g.cos(a), g.sin(a)),
}


@pytest.mark.parametrize("theorem", THEOREMS)
def test_addition_theorems(theorem: str) -> None:
    graph = Graph(fold=False)
    sides = THEOREMS[theorem](graph, graph.input("q", 0), graph.input("q", 1))
    left, right = (lower(graph, [("t", [side])]) for side in sides)
    for seed in range(5):
        holds = not theorem.startswith("not")
        assert (results(left, Point(seed)) == results(right, Point(seed))) is holds
        prints = [fingerprint(side, seed, circle_point) for side in (left, right)]
        assert (prints[0] == prints[1]) is holds


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
