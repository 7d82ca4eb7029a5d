"""What is long: graphs and exact constants, which may grow so far before nobody waits for them, and the
digits of a program's value, as many as one likes, with mpmath."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from robodyn.errors import InputError
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program

#: Positions of a graph at most: building and comparing it takes some 2 GB and a minute or two, and its C has
#: 25 MB, more than compilers take.
MOST_POSITIONS = 1_500_000


class TooLarge(InputError):
    """A function of so many operations that no compiler takes it."""


def too_large() -> TooLarge:
    """The error of a graph that has grown beyond all use."""
    return TooLarge(
        "a function is larger than compilers take",
        found=f"more than {MOST_POSITIONS:,} operations",
        remedy="take fewer joints",
    )


#: Bits of a constant at most, some 20,000 digits: products and sums of larger ones take for ever.
_MOST_BITS = 1 << 16


class TooManyDigits(InputError):
    """Constants that are exact, and so long that nobody waits for their products."""


def check_digits(constant: Fraction | int) -> None:
    """Refuse a ``constant`` whose products would take for ever.

    Raises
    ------
    TooManyDigits: numerator and denominator have more than some 20,000 digits together.
    """
    if constant.denominator.bit_length() + constant.numerator.bit_length() > _MOST_BITS:
        raise TooManyDigits(
            "the products of constants have more than 20,000 digits",
            remedy="give the numbers fewer digits, or the arm fewer joints",
        )


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
