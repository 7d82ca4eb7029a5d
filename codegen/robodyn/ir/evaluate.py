"""Evaluation of a program over any scalar: floats, arrays, exact rationals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from robodyn.ir.program import STATE, Input, Iteration, Operand, Program

#: Functions on floats. Other scalars need functions of their own (see :func:`evaluate`).
REAL_FUNCTIONS: dict[str, Callable[..., Any]] = {
    "sin": math.sin,
    "cos": math.cos,
    "sqrt": math.sqrt,
    "tanh": math.tanh,
    "sign": lambda x: float((x > 0) - (x < 0)),
    "abs": abs,
    "exp": math.exp,
    "pow": math.pow,
    "atan2": math.atan2,
}


def selected(condition: Any, a: Any, b: Any) -> Any:
    """``a`` if ``condition`` is positive, else ``b``; elementwise if ``condition`` is a numpy array."""
    if hasattr(condition, "dtype"):
        import numpy as np

        return np.where(condition > 0, a, b)[()]  # a scalar instead of a 0-d array
    return a if condition > 0 else b


def evaluate(
    program: Program,
    inputs: Mapping[Input, Any],
    *,
    constant: Callable[[Fraction], Any] = float,
    functions: Mapping[str, Callable[..., Any]] = REAL_FUNCTIONS,
) -> dict[str, list[Any]]:
    """Run ``program`` on ``inputs`` and return its outputs by name.

    ``constant`` turns a constant into the scalar in use (``float``, ``Fraction``, ``sympy.Rational``...);
    ``functions`` implements, for that scalar, those of ``sin cos sqrt tanh sign abs exp pow atan2`` that the
    program uses. It also needs ``select`` if :func:`selected` does not work for the scalar.
    """
    values: list[Any] = []
    implementations = {"select": selected, **functions}
    if program.iteration is not None:

        def run(part: Program, inputs: Mapping[Input, Any]) -> list[Any]:
            return evaluate(part, inputs, constant=constant, functions=functions)[STATE]

        inputs = {**inputs, **_run_iteration(program.iteration, inputs, run, implementations["select"])}

    def value(operand: Operand) -> Any:
        if isinstance(operand, int):
            return values[operand]
        if isinstance(operand, Input):
            return inputs[operand]
        return constant(operand)

    for op, args, _ in program.operations:
        x = value(args[0])
        if op == "add":
            values.append(x + value(args[1]))
        elif op == "sub":
            values.append(x - value(args[1]))
        elif op == "mul":
            values.append(x * value(args[1]))
        elif op == "div":
            values.append(x / value(args[1]))
        elif op == "neg":
            values.append(-x)
        else:
            values.append(implementations[op](x, *[value(arg) for arg in args[1:]]))
    return {name: [value(operand) for operand in elements] for name, elements in program.outputs}


def _run_iteration(
    iteration: Iteration,
    inputs: Mapping[Input, Any],
    run: Callable[[Program, Mapping[Input, Any]], list[Any]],
    select: Callable[..., Any],
) -> dict[Input, Any]:
    """Run ``iteration`` and return the final values of its array.

    If the values are numpy arrays of samples, a sample keeps its values once it has converged.
    """
    size = iteration.size
    numbers = run(iteration.start, inputs)
    for first in range(0, len(numbers), size):
        row = numbers[first : first + size]
        for _ in range(iteration.most):
            converged = row[-1] > 0
            if converged.all() if hasattr(converged, "dtype") else converged:
                break
            state = {Input(STATE, k): x for k, x in enumerate(row)}
            new = run(iteration.step, {**inputs, **state})
            row = [select(row[-1], x, y) for x, y in zip(row, new, strict=True)]
        numbers[first : first + size] = row
    return {Input(STATE, k): x for k, x in enumerate(numbers)}


AngleForm = tuple[tuple[tuple[Input, int | Fraction], ...], Fraction]


def angle_form(program: Program, operand: Operand, cache: dict[int, AngleForm] | None = None) -> AngleForm:
    """The argument of a sine or cosine as multiples of inputs plus a constant [rad].

    ``cache`` keeps the forms of operations between calls.
    """
    if isinstance(operand, Fraction):
        return (), operand
    if isinstance(operand, Input):
        return ((operand, 1),), Fraction(0)
    if cache is not None and operand in cache:
        return cache[operand]
    op, args, _ = program.operations[operand]
    factors: tuple[int | Fraction, ...]
    if op == "mul" and isinstance(args[0], Fraction):
        factors, args = (_whole(args[0]),), args[1:]
    elif op in ("add", "sub", "neg"):
        factors = {"add": (1, 1), "sub": (1, -1), "neg": (-1,)}[op]
    else:
        raise ValueError(f"{op} in the argument of a sine")
    total: dict[Input, int | Fraction] = {}
    constant = Fraction(0)
    for factor, arg in zip(factors, args, strict=True):
        terms, rest = angle_form(program, arg, cache)
        constant += factor * rest
        for name, multiple in terms:
            total[name] = _whole(total.get(name, 0) + factor * multiple)
    form = tuple(sorted((name, m) for name, m in total.items() if m)), constant
    if cache is not None:
        cache[operand] = form
    return form


def is_angle(program: Program, operand: Operand, cache: dict[int, AngleForm] | None = None) -> bool:
    """Whether ``operand`` has an :func:`angle_form`."""
    try:
        angle_form(program, operand, cache)
    except ValueError:
        return False
    return True


def _whole(x: int | Fraction) -> int | Fraction:
    """``x`` as an integer if it is one."""
    return x.numerator if isinstance(x, Fraction) and x.denominator == 1 else x


Circle = tuple[Any, Any]


def turn(first: Circle, second: Circle) -> Circle:
    """The sum of two angles, all as points (cos, sin) of the unit circle."""
    (c, s), (e, f) = first, second
    return c * e - s * f, s * e + c * f


def evaluate_exact(
    program: Program,
    inputs: Mapping[Input, Fraction],
    points: Mapping[Input, Circle],
    constant_point: Callable[[Fraction], Circle],
) -> dict[str, list[Fraction]]:
    """Run ``program`` on rationals, without rounding.

    ``points`` has a rational point (cos, sin) of the unit circle for each joint angle. ``constant_point``
    returns such a point for a constant angle. Sums of angles are then exact as well.
    """
    cache: dict[int, AngleForm] = {}
    arguments = [op.args[0] for op in program.operations if op.op in ("sin", "cos")]
    forms = iter([angle_form(program, argument, cache) for argument in arguments])

    def point() -> Circle:
        terms, constant = next(forms)
        total: Circle = constant_point(constant) if constant else (Fraction(1), Fraction(0))
        for name, multiple in terms:
            if isinstance(multiple, Fraction):
                raise ValueError(f"the sine of {multiple} {name} has no exact value")
            c, s = points[name]
            for _ in range(abs(multiple)):
                total = turn(total, (c, s if multiple > 0 else -s))
        return total

    def sign(x: Fraction) -> Fraction:
        return Fraction((x > 0) - (x < 0))

    functions: dict[str, Callable[[Any], Any]] = {
        "sin": lambda _: point()[1],
        "cos": lambda _: point()[0],
        "sign": sign,
        "abs": abs,
    }
    return evaluate(program, inputs, constant=lambda x: x, functions=functions)
