"""Evaluation of a program to many digits, with mpmath."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program


def to_digits(x: Fraction) -> Any:
    """``x`` as a number of mpmath, to the digits that it works with."""
    import mpmath

    return mpmath.mpf(x.numerator) / x.denominator


def evaluate_to_digits(program: Program, inputs: Mapping[Input, Any]) -> dict[str, list[Any]]:
    """The outputs of ``program`` by name at ``inputs``, numbers of mpmath, to the digits that it works with.
    The root of what is negative is no number, as in the languages that programs are emitted in."""
    import mpmath

    known: dict[Fraction, Any] = {}

    def constant(x: Fraction) -> Any:
        if x not in known:
            known[x] = to_digits(x)
        return known[x]

    def root(x: Any) -> Any:
        return mpmath.nan if x < 0 else mpmath.sqrt(x)

    functions: dict[str, Callable[..., Any]] = {
        "sin": mpmath.sin,
        "cos": mpmath.cos,
        "sqrt": root,
        "abs": abs,
        "sign": mpmath.sign,
        "exp": mpmath.exp,
        "tanh": mpmath.tanh,
        "pow": mpmath.power,
        "atan2": mpmath.atan2,
    }
    results = evaluate(program, inputs, constant=constant, functions=functions)
    return {name: [mpmath.mpf(x) for x in row] for name, row in results.items()}
