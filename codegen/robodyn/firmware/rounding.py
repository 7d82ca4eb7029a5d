"""How far rounding can take a program's results from their exact values, at given states.

Running error analysis (J. H. Wilkinson; N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2nd
ed., 3.3): beside every value goes a bound of its error, and every operation passes the bounds of its operands
on and adds its own rounding. Terms of second order are kept, so the bound is one and no estimate.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from robodyn.arrays import Floats
from robodyn.emit.spelling import nearest_float
from robodyn.emit.trig import ARCTANGENT_ULPS, DOUBLE, FLOAT
from robodyn.ir.program import Input, Operand, Program
from robodyn.ir.signature import ScalarType

#: What one rounding changes at most, as a share, and by how much more below the smallest normal number.
UNIT: Mapping[ScalarType, float] = {"float": 2.0**-24, "double": 2.0**-53}
TINY: Mapping[ScalarType, float] = {"float": 2.0**-149, "double": 2.0**-1074}

#: Up to which angle [rad] the kernel's sine and cosine are right to an ulp (robodyn.emit.trig), and what they
#: are off beyond.
ACCURATE: Mapping[ScalarType, float] = {"float": FLOAT.exact, "double": DOUBLE.exact}
FAR: Mapping[ScalarType, float] = {"float": 5.5e-8, "double": 0.0}

#: Functions of a mathematical library, and how many ulps they are off at most. C's libraries and Rust's libm
#: promise nothing; glibc's manual lists 2 at most, and what they share with fdlibm has been measured below 3.
_LIBRARY, _LIBRARY_ULPS = ("exp", "tanh", "pow"), 3

#: How many ulps the kernel's arctangent is off at most; glibc's is better.
_ANGLE_ULPS = ARCTANGENT_ULPS

#: Whole numbers up to this are exact in float and double.
_WHOLE = 2.0**24

#: The values are doubles, and so are the bounds: what that loses is far below this share of them.
_SPARE = 1.01


@dataclass(frozen=True, slots=True)
class _Bounded:
    """Values ``[N]`` and bounds ``[N]`` of their errors."""

    value: Floats
    error: Floats


@np.errstate(all="ignore")
def rounding_bounds(
    program: Program, inputs: Mapping[Input, Floats], scalar: ScalarType
) -> dict[str, Floats]:
    """Bounds ``[N, size]`` of the rounding errors of each output, at ``N`` states given exactly;
    infinite where a divisor may be zero.

    Raises
    ------
    ValueError: the program has an operation whose error is unknown.
    """
    unit, tiny = UNIT[scalar], TINY[scalar]
    states = len(next(iter(inputs.values()))) if inputs else 1
    bounded: list[_Bounded] = []

    def at(operand: Operand) -> _Bounded:
        if isinstance(operand, int):
            return bounded[operand]
        if isinstance(operand, Input):
            return _Bounded(inputs[operand], np.zeros(states))
        return _constant(operand, scalar, states)

    for op, args, _ in program.operations:
        if op not in _RULES:
            raise ValueError(f"no bound is known for the rounding of {op}")
        operands = [at(arg) for arg in args]
        value, error = _RULES[op](*operands)
        if op == "atan2":
            error = error + 2 * _ANGLE_ULPS * unit * (np.abs(value) + error) + tiny
        elif op in ("sin", "cos"):  # an ulp is two units at most
            error = error + 2 * unit * (np.abs(value) + error) + tiny
            far = np.abs(at(args[0]).value) + at(args[0]).error > ACCURATE[scalar]
            error = np.where(far, error + FAR[scalar], error)
        elif op in _LIBRARY:
            error = error + 2 * _LIBRARY_ULPS * unit * (np.abs(value) + error) + tiny
        elif op not in ("neg", "abs", "sign", "select"):
            rounded = error + unit * (np.abs(value) + error) + tiny
            error = np.where(_exact(op, value, *operands), error, rounded)
        bounded.append(_Bounded(value, error))
    return {
        name: np.stack([at(operand).error * _SPARE for operand in elements], axis=1)
        for name, elements in program.outputs
    }


def _exact(op: str, value: Floats, *operands: _Bounded) -> NDArray[np.bool_]:
    """Where an operation rounds nothing: a zero is added, or a factor is 0, 1 or -1, or all are small whole
    numbers, and known to be that. What guards a division or a memory is built of such, and what counts flags.
    """
    if op not in ("add", "sub", "mul"):
        return np.zeros(len(value), bool)
    sure = [x.error == 0 for x in operands]
    whole = [known & (x.value == np.rint(x.value)) for known, x in zip(sure, operands, strict=True)]
    small = np.all(whole, axis=0) & (np.abs(value) <= _WHOLE)
    neutral = (-1, 0, 1) if op == "mul" else (0,)
    idle = [known & np.isin(x.value, neutral) for known, x in zip(sure, operands, strict=True)]
    exact: NDArray[np.bool_] = small | np.any(idle, axis=0)
    return exact if op == "mul" else exact | (np.all(sure, axis=0) & (value == 0))


def _constant(value: Fraction, scalar: ScalarType, states: int) -> _Bounded:
    rounded = nearest_float(value) if scalar == "float" else float(value)
    off = abs(float(Fraction(rounded) - value))
    return _Bounded(np.full(states, float(value)), np.full(states, off))


def _product(x: _Bounded, y: _Bounded) -> tuple[Floats, Floats]:
    error = np.abs(x.value) * y.error + np.abs(y.value) * x.error + x.error * y.error
    return x.value * y.value, error


def _quotient(x: _Bounded, y: _Bounded) -> tuple[Floats, Floats]:
    value, least = x.value / y.value, np.abs(y.value) - y.error
    return value, np.where(least > 0, (x.error + np.abs(value) * y.error) / least, np.inf)


def _root(x: _Bounded) -> tuple[Floats, Floats]:
    value = np.sqrt(x.value)
    return value, np.where(value > 0, x.error / np.where(value > 0, value, 1.0), np.sqrt(x.error))


def _sign(x: _Bounded) -> tuple[Floats, Floats]:
    certain = (np.abs(x.value) > x.error) | (x.error == 0)
    return np.sign(x.value), np.where(certain, 0.0, 2.0)


def _rising(function: Callable[[Floats], Floats]) -> Callable[[_Bounded], tuple[Floats, Floats]]:
    """The rule of a function that rises: it is farthest off at an end."""

    def rule(x: _Bounded) -> tuple[Floats, Floats]:
        value = function(x.value)
        ends = (function(x.value - x.error), function(x.value + x.error))
        return value, _farthest(value, ends)

    return rule


def _angle(y: _Bounded, x: _Bounded) -> tuple[Floats, Floats]:
    """Of a point that may lie anywhere in a circle: the angle of a tangent to it; any angle where the origin
    may lie in it, or the half line on which the angle jumps."""
    value, away, radius = np.arctan2(y.value, x.value), np.hypot(x.value, y.value), np.hypot(x.error, y.error)
    inside = radius < away
    turned = np.arcsin(np.where(inside, radius / np.where(inside, away, 1.0), 0.0))
    sure = (radius == 0) | (inside & ((np.abs(y.value) > y.error) | (x.value > x.error)))
    return value, np.where(sure, turned, 2 * math.pi)


def _choice(condition: _Bounded, x: _Bounded, y: _Bounded) -> tuple[Floats, Floats]:
    """The other one where the condition's sign is not certain."""
    first = condition.value > 0
    value = np.where(first, x.value, y.value)
    other = np.abs(x.value - y.value) + np.where(first, y.error, x.error)
    own = np.where(first, x.error, y.error)
    certain = (np.abs(condition.value) > condition.error) | (condition.error == 0)
    return value, np.where(certain, own, np.maximum(own, other))


def _power(x: _Bounded, y: _Bounded) -> tuple[Floats, Floats]:
    """Farthest off at a corner. What is raised to anything but a whole number is never negative."""
    value = x.value**y.value
    whole = (y.value == np.rint(y.value)) & (y.error == 0)
    low = np.where(whole, x.value - x.error, np.maximum(x.value - x.error, 0.0))
    corners = [
        base**power for base in (low, x.value + x.error) for power in (y.value - y.error, y.value + y.error)
    ]
    return value, _farthest(value, corners)


def _farthest(value: Floats, others: Sequence[Floats]) -> Floats:
    """Infinite where one of them is no number."""
    distance = np.max([np.abs(other - value) for other in others], axis=0)
    return np.where(np.isnan(distance), np.inf, distance)


_RULES: Mapping[str, Callable[..., tuple[Floats, Floats]]] = {
    "add": lambda x, y: (x.value + y.value, x.error + y.error),
    "sub": lambda x, y: (x.value - y.value, x.error + y.error),
    "mul": _product,
    "div": _quotient,
    "neg": lambda x: (-x.value, x.error),
    "abs": lambda x: (np.abs(x.value), x.error),
    "sqrt": _root,
    "sign": _sign,
    "sin": lambda x: (np.sin(x.value), x.error),
    "cos": lambda x: (np.cos(x.value), x.error),
    "exp": _rising(np.exp),
    "tanh": _rising(np.tanh),
    "pow": _power,
    "atan2": _angle,
    "select": _choice,
}
