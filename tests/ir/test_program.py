"""Programs as data, and what evaluating them over one scalar or another gives."""

from __future__ import annotations

import gc
import math
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, reject, settings
from hypothesis import strategies as st

from ir.printed import Q1, Q2, X, small
from ir.programs import EXACT, Point, exactly, interpreted, points, programs, results
from robodyn import load, program
from robodyn.ir import Graph, Input, Label, Operation, Program, Signature
from robodyn.ir.evaluate import angle_form, evaluate, evaluate_exact, selected, turn
from robodyn.ir.fingerprint import fingerprint
from robodyn.ir.lowering import lower
from robodyn.ir.program import RARELY, rarely_collected
from robodyn.kernels.generate import Options, generate
from robodyn.robot.values import circle_point


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
    other = small().with_results((0, 1, 2, 3))
    assert other.outputs == (("tau", (0, 1)), ("M", (2, 3)))
    assert other.operations == small().operations


def test_where_a_program_came_from_makes_no_difference() -> None:
    graph = Graph()
    made = lower(graph, [("t", [graph.input("x") * 2])])
    assert made.origin is not None
    assert made == Program(made.operations, made.outputs)
    assert made.with_results((X,)).origin is None


def test_names_of_inputs_and_labels() -> None:
    assert [str(x) for x in (Q1, Input("qdd", 11), X)] == ["q1", "qdd12", "x"]
    label = Label(3, "w", "x")
    assert [str(label), str(label.flipped()), str(Label(2, "tau", ""))] == ["w3_x", "neg_w3_x", "tau2"]
    assert label.flipped().flipped() == label


def test_symbols_of_a_signature() -> None:
    interface = Signature("puma560", "bias", (("q", 6),), (("tau", 6),))
    assert interface.symbol == "puma560_bias"


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


def test_evaluate_over_numpy_is_evaluate_over_floats_state_by_state() -> None:
    made = program(load("stanford_3dof"), "inverse_dynamics")
    rng = np.random.default_rng(1)
    arrays = {x: rng.uniform(-2, 2, 20) for x in made.inputs()}
    over_arrays = evaluate(made, arrays, functions={"sin": np.sin, "cos": np.cos})["tau"]
    for k in range(20):
        one = evaluate(made, {x: float(values[k]) for x, values in arrays.items()})["tau"]
        for element, whole in zip(one, over_arrays, strict=True):
            assert math.isclose(element, float(whole[k]), rel_tol=1e-13, abs_tol=1e-13)


def test_evaluate_over_sympy_gives_expressions() -> None:
    import sympy

    made = program(load("stanford_3dof"), "inverse_dynamics")
    symbols = {x: sympy.Symbol(str(x), real=True) for x in made.inputs()}
    over_sympy = evaluate(
        made,
        symbols,
        constant=lambda x: sympy.Rational(x.numerator, x.denominator),
        functions={"sin": sympy.sin, "cos": sympy.cos},
    )["tau"]
    at = Point(5)
    replaced = {symbols[x]: sympy.Rational(*at.number(x).as_integer_ratio()) for x in symbols}
    for x in made.inputs():
        if x.array == "q":
            cosine, sine = (sympy.Rational(*v.as_integer_ratio()) for v in at.circle(x))
            replaced |= {sympy.cos(symbols[x]): cosine, sympy.sin(symbols[x]): sine}
    found = [Fraction(int(e.p), int(e.q)) for e in (t.xreplace(replaced) for t in over_sympy)]
    assert found == exactly(made, at)["tau"]


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


Build = Callable[[Graph, Any, Any], list[Any]]


def trigonometric(build: Build) -> Program:
    graph = Graph(fold=False)
    return lower(graph, [("t", build(graph, graph.input("q", 0), graph.input("q", 1)))])


THEOREMS: dict[str, tuple[Build, Build]] = {
    "sum": (
        lambda g, a, b: [g.sin(a + b), g.cos(a + b)],
        lambda g, a, b: [
            g.sin(a) * g.cos(b) + g.cos(a) * g.sin(b),
            g.cos(a) * g.cos(b) - g.sin(a) * g.sin(b),
        ],
    ),
    "difference": (
        lambda g, a, b: [g.sin(a - b), g.cos(b - a)],
        lambda g, a, b: [
            g.sin(a) * g.cos(b) - g.cos(a) * g.sin(b),
            g.cos(a) * g.cos(b) + g.sin(a) * g.sin(b),
        ],
    ),
    "double angle": (
        lambda g, a, b: [g.sin(a + a), g.cos(a + a)],
        lambda g, a, b: [2 * (g.sin(a) * g.cos(a)), 1 - 2 * (g.sin(a) * g.sin(a))],
    ),
    "constant": (
        lambda g, a, b: [g.sin(a + Fraction(1, 3)), g.cos(Fraction(1, 3) - a)],
        lambda g, a, b: [
            g.sin(a) * circle_point(Fraction(1, 3))[0] + g.cos(a) * circle_point(Fraction(1, 3))[1],
            g.cos(a) * circle_point(Fraction(1, 3))[0] + g.sin(a) * circle_point(Fraction(1, 3))[1],
        ],
    ),
    "circle": (lambda g, a, b: [g.sin(a) * g.sin(a) + g.cos(a) * g.cos(a)], lambda g, a, b: [Fraction(1)]),
    "parity": (lambda g, a, b: [g.sin(b - a), g.cos(b - a)], lambda g, a, b: [-g.sin(a - b), g.cos(a - b)]),
}  # fmt: skip


@pytest.mark.parametrize("theorem", THEOREMS)
def test_addition_theorems(theorem: str) -> None:
    left, right = (trigonometric(side) for side in THEOREMS[theorem])
    for seed in range(5):
        assert results(left, Point(seed)) == results(right, Point(seed))
        assert fingerprint(left, seed, circle_point) == fingerprint(right, seed, circle_point)


def test_no_other_theorem_holds() -> None:
    wrong = [
        (lambda g, a, b: [g.sin(a + b)], lambda g, a, b: [g.sin(a) + g.sin(b)]),
        (lambda g, a, b: [g.sin(a + b)], lambda g, a, b: [g.sin(a - b)]),
        (lambda g, a, b: [g.cos(a)], lambda g, a, b: [g.cos(b)]),
        (lambda g, a, b: [g.cos(a)], lambda g, a, b: [g.sin(a)]),
        (lambda g, a, b: [g.sin(a + Fraction(1, 3))], lambda g, a, b: [g.sin(a - Fraction(1, 3))]),
    ]
    for one, other in wrong:
        left, right = trigonometric(one), trigonometric(other)
        assert results(left, Point(1)) != results(right, Point(1))
        assert fingerprint(left, 1, circle_point) != fingerprint(right, 1, circle_point)


def test_turning() -> None:
    right, straight = (Fraction(0), Fraction(1)), (Fraction(-1), Fraction(0))
    assert turn(right, right) == straight
    assert turn(straight, right) == (0, -1)
    point = (Fraction(3, 5), Fraction(4, 5))
    assert turn(point, (point[0], -point[1])) == (1, 0)


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


def test_generating_is_such_a_time(thresholds: tuple[int, int, int]) -> None:
    within: list[tuple[int, int, int]] = []
    options = Options(("potential_energy",))
    generate("puma560_3dof", options, progress=lambda _: within.append(gc.get_threshold()))
    assert within == [RARELY if thresholds == (700, 10, 10) else thresholds]
    assert gc.get_threshold() == thresholds
