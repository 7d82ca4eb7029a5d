"""Random straight-line programs for hypothesis, rational points to run them at, and a second interpreter.

The interpreter uses nothing but Python's operators, so that the same few lines run on ``Fraction``s, on the
nodes of a graph, and on whatever else behaves like a number.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, Final

from hypothesis import strategies as st

from robodyn.ir import Input, Label, Operand, Operation, Program
from robodyn.ir.evaluate import evaluate_exact
from robodyn.ir.program import ARITY
from robodyn.robot.values import circle_point

INPUTS: Final = (*(Input("q", i) for i in range(3)), Input("qd", 0), Input("qd", 1), Input("m_tool", None))
ANGLES: Final = INPUTS[:3]
ARITHMETIC: Final = ("add", "sub", "mul", "div", "neg")
#: What can be evaluated without rounding.
EXACT: Final = (*ARITHMETIC, "add", "sub", "mul", "mul", "sin", "cos", "angle", "sign", "select")
EVERYTHING: Final = (*EXACT, "sqrt", "tanh")

Linear = dict[Input, int]


class Point:
    """A rational value for every input, and for every angle a rational point (cos, sin) of the circle."""

    def __init__(self, seed: int) -> None:
        self.seed = seed

    def number(self, x: Input) -> Fraction:
        """The value of ``x``, never 0."""
        rng = random.Random(f"number {self.seed} {x}")
        return Fraction(rng.choice((1, -1)) * rng.randint(1, 9999), rng.randint(1, 99))

    def circle(self, x: Input) -> tuple[Fraction, Fraction]:
        """Cosine and sine of ``x``."""
        rng = random.Random(f"circle {self.seed} {x}")
        t = Fraction(rng.choice((1, -1)) * rng.randint(1, 199), rng.randint(1, 99))
        return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def exactly(
    program: Program, at: Point, numbers: Mapping[Input, Fraction] | None = None
) -> dict[str, list[Fraction]]:
    """``program`` run at a rational point without rounding; ``numbers`` come before the point's own."""
    own = numbers or {}
    inputs = {x: own.get(x, at.number(x)) for x in program.inputs()}
    points = {x: at.circle(x) for x in program.inputs()}
    return evaluate_exact(program, inputs, points, circle_point)


def results(program: Program, at: Point) -> list[Fraction]:
    """All results of :func:`exactly`, one after another."""
    return [x for elements in exactly(program, at).values() for x in elements]


def every_value(program: Program, at: Point) -> list[Fraction]:
    """The value of every single operation."""
    whole = Program(program.operations, (("all", tuple(range(len(program.operations)))),))
    return exactly(whole, at)["all"]


def interpreted(
    program: Program,
    leaf: Callable[[Input], Any],
    functions: Mapping[str, Callable[..., Any]],
    constant: Callable[[Fraction], Any] = lambda x: x,
) -> list[Any]:
    """The results of ``program`` by Python's own operators."""
    values: list[Any] = []

    def value(operand: Operand) -> Any:
        if isinstance(operand, int):
            return values[operand]
        return leaf(operand) if isinstance(operand, Input) else constant(operand)

    for op, args, _ in program.operations:
        x, *rest = map(value, args)
        if op == "add":
            values.append(x + rest[0])
        elif op == "sub":
            values.append(x - rest[0])
        elif op == "mul":
            values.append(x * rest[0])
        elif op == "div":
            values.append(x / rest[0])
        elif op == "neg":
            values.append(-x)
        else:
            values.append(functions[op](x, *rest))
    return [value(operand) for operand in program.results()]


_CONSTANTS = st.one_of(
    st.sampled_from([Fraction(x) for x in (0, 1, -1, 2, -2)] + [Fraction(1, 2), Fraction(-1, 2)]),
    st.fractions(min_value=-5, max_value=5, max_denominator=20),
)


@st.composite
def programs(draw: st.DrawFn, ops: tuple[str, ...] = EXACT, most: int = 14, labels: bool = True) -> Program:
    """Straight-line programs: with dead code, repeated and trivial operations, constants among themselves.

    The argument of a sine is a sum of joint angles, each once, and constants, as it is in a recursion.
    Divisors may be zero: reject those.
    """
    size = draw(st.integers(1, most))
    operations: list[Operation] = []
    linear: dict[int, Linear] = {}  # operations that may be the argument of a sine

    def operand() -> Operand:
        kind = draw(st.integers(0, 9))
        if kind == 0:
            return draw(_CONSTANTS)
        if kind < 4 or not operations:
            return draw(st.sampled_from(INPUTS))
        return draw(st.integers(0, len(operations) - 1))

    def form(x: Operand) -> Linear:
        if isinstance(x, int):
            return linear[x]
        return {x: 1} if isinstance(x, Input) else {}

    def angle() -> Operand:
        leaf: st.SearchStrategy[Operand] = st.one_of(st.sampled_from(ANGLES), _CONSTANTS)
        return draw(st.one_of(st.sampled_from(list(linear)), leaf) if linear else leaf)

    for i in range(size):
        op = draw(st.sampled_from(ops))
        label = None
        if labels and draw(st.integers(0, 3)) == 0:
            label = Label(draw(st.integers(1, 3)), "w", draw(st.sampled_from("xyz")), draw(st.booleans()))
        if op == "angle":
            op = draw(st.sampled_from(("add", "sub", "neg")))
            args: tuple[Operand, ...] = (angle(),) if op == "neg" else (angle(), angle())
            sign = -1 if op in ("sub", "neg") else 1
            if len(args) == 2 and form(args[0]).keys() & form(args[1]).keys():
                args = (args[0], draw(_CONSTANTS))
            linear[i] = {
                x: (sign if k == len(args) - 1 else 1) * m
                for k, a in enumerate(args)
                for x, m in form(a).items()
            }
        elif op in ("sin", "cos"):
            args = (angle(),)
        elif op in ("tanh", "sign"):
            args = (draw(st.sampled_from(INPUTS)),)
        elif op in ("neg", "sqrt"):
            args = (operand(),)
        else:
            args = tuple(operand() for _ in range(ARITY[op]))
        operations.append(Operation(op, args, label))
    outputs = [("tau", tuple(operand() for _ in range(draw(st.integers(1, 3)))))]
    if draw(st.booleans()):
        outputs.append(("M", (operand(),)))
    return Program(tuple(operations), tuple(outputs))


points = st.integers(0, 10**6).map(Point)
