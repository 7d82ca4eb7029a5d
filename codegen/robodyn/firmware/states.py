"""States that C, Fortran and Python make alike, to the bit: an integer generator, one product, one sum.

The generator is x <- 1664525 x + 1013904223 modulo 2^32 (W. H. Press et al., Numerical Recipes); the upper 24
bits of x, less 2^23 and times 2^-23, are a number in [-1, 1) that a float has exactly. An element of a state
is then ``middle + half*number``, rounded twice.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.arguments import NEAR, POSE
from robodyn.ir.program import Input
from robodyn.ir.signature import ScalarType
from robodyn.robot.model import Robot
from robodyn.verify.numbers import exact_value
from robodyn.verify.sample import bounds_of

MULTIPLIER, INCREMENT = 1664525, 1013904223
#: Where the generator starts: for the digest and for the vectors.
DIGEST_SEED, VECTOR_SEED = 1, 2
#: How many states the digest is taken over, and how many vectors are drawn beside the special ones.
DIGEST_STATES, DRAWN_VECTORS = 1000, 26
#: How many vectors there are of each function.
VECTORS = DRAWN_VECTORS + 6
#: Torques that forward dynamics is given where a joint has no torque limit [N m or N].
_TORQUE = 10.0
#: How far a revolute joint goes at most [rad].
_TURNS = 32.0
#: Digits of the half ranges; and of the middles of ranges that are not symmetric.
_DIGITS = 6

#: Inputs of which it is known where they may be.
DRAWN = frozenset({"q", "qd", "qdd", "tau", POSE.name, NEAR.name})

DTYPE: Mapping[ScalarType, Any] = {"float": np.float32, "double": np.float64}


@dataclass(frozen=True, slots=True)
class Range:
    """Of one array of a state the middles and half widths of its elements, numbers of the kernel's type."""

    array: str
    middle: tuple[float, ...]
    half: tuple[float, ...]


def ranges(robot: Robot, arrays: Sequence[str], scalar: ScalarType) -> tuple[Range, ...]:
    """The ranges of ``arrays`` (of q, qd, qdd, tau, q_near, T), within the joints' limits; where there is
    none, those of :func:`robodyn.verify.sample.draw`. T is any numbers, about as far as the arm reaches: no
    rotation, which bits do not ask for."""
    bounds = [bounds_of(link.joint) for link in robot.links]
    for joint, link in zip(bounds, robot.links, strict=True):
        if link.joint.kind == "revolute":
            joint[0] = _near(joint[0])
    reach = _reach(robot)
    result = []
    for array in arrays:
        if array == "tau":
            limits = [link.joint.limits.torque for link in robot.links]
            spans = [(-t, t) for t in (_TORQUE if x is None else float(x) for x in limits)]
        elif array == POSE.name:
            places = [(x - reach, x + reach) for x in _origin(robot)]
            spans = [span for place in places for span in (*[(-1.0, 1.0)] * 3, place)]
        elif array == NEAR.name:
            spans = [joint[0] for joint in bounds]
        else:
            spans = [joint[("q", "qd", "qdd").index(array)] for joint in bounds]
        pairs = [_inside(low, high, scalar) for low, high in spans]
        result.append(Range(array, tuple(m for m, _ in pairs), tuple(h for _, h in pairs)))
    return tuple(result)


def _origin(robot: Robot) -> tuple[float, float, float]:
    """Of the base, in the world [m]."""
    x, y, z = (0, 0, 0) if robot.base is None else robot.base.xyz
    return float(x), float(y), float(z)


def _reach(robot: Robot) -> float:
    """How far turning joints bring the tool from the base at most [m], and a bit more; parameters are 1."""
    values = dict.fromkeys(robot.parameters, 1.0)
    lengths = [x for link in robot.links for x in (link.joint.a, link.joint.b, link.joint.d)]
    lengths += [] if robot.tool is None else robot.tool.xyz
    return float(sum((abs(exact_value(x, values)) for x in lengths), Fraction(1, 10)))


def _near(span: tuple[float, float]) -> tuple[float, float]:
    """Of the positions of a joint that makes many turns those around zero, where sines are best."""
    low, high = span
    return max(low, min(high, -_TURNS)), min(high, max(low, _TURNS))


def _inside(low: float, high: float, scalar: ScalarType) -> tuple[float, float]:
    """Middle and half width of a range in ``low .. high``, in few digits."""
    middle = float(DTYPE[scalar](f"{(low + high) / 2:.{_DIGITS}g}"))
    room = Fraction(min(high - middle, middle - low)) * (1 - Fraction(1, 10**_DIGITS))
    if room <= 0:
        return middle, 0.0
    step = Fraction(10) ** (math.floor(math.log10(room)) - _DIGITS + 1)
    return middle, float(DTYPE[scalar](float(math.floor(room / step) * step)))


def draw(spans: Sequence[Range], states: int, seed: int, scalar: ScalarType) -> dict[str, NDArray[Any]]:
    """``states`` states, array by array ``[states, n]`` in the kernel's type; each draws array after array,
    joint 1 first."""
    real = DTYPE[scalar]
    ends = np.cumsum([len(span.middle) for span in spans], dtype=int)
    numbers = np.array(_numbers(states * sum(ends[-1:]), seed), np.int64)
    unit = (numbers - 2**23).astype(real) * real(2.0**-23)
    parts = np.split(unit.reshape(states, -1), ends[:-1], axis=1)
    return {
        span.array: np.array(span.middle, real) + np.array(span.half, real) * part
        for span, part in zip(spans, parts, strict=True)
    }


def _numbers(count: int, seed: int) -> list[int]:
    values, x = [], seed
    for _ in range(count):
        x = (MULTIPLIER * x + INCREMENT) % 2**32
        values.append(x >> 8)
    return values


def program_inputs(
    states: Mapping[str, NDArray[Any]], parameters: Mapping[str, float], real: Any = np.float64
) -> dict[Input, NDArray[Any]]:
    """What a program is evaluated at, ``[N]`` each and of type ``real``: the elements of ``states``
    ``[N, size]`` by array, and run-time ``parameters``, the same in all."""
    count = len(next(iter(states.values())))
    inputs = {Input(array, i): x.astype(real) for array, rows in states.items() for i, x in enumerate(rows.T)}
    return inputs | {Input(name, None): np.full(count, value, real) for name, value in parameters.items()}


def vector_states(spans: Sequence[Range], scalar: ScalarType) -> dict[str, NDArray[Any]]:
    """The states of the test vectors ``[32, n]``: drawn ones, then both ends of all ranges, nothing moves,
    steady motion, from rest, and all zero."""
    states = draw(spans, DRAWN_VECTORS, VECTOR_SEED, scalar)
    first = {array: x[0] for array, x in states.items()}
    ends = [
        {s.array: np.array([m + sign * h for m, h in zip(s.middle, s.half, strict=True)]) for s in spans}
        for sign in (1.0, -1.0)
    ]
    zeros = [("qd", "qdd"), ("qdd",), ("qd",), ("q", "qd", "qdd", "tau")]
    special = ends + [{a: x * 0 if a in still else x for a, x in first.items()} for still in zeros]
    return {
        array: np.concatenate([x, np.array([state[array] for state in special]).astype(DTYPE[scalar])])
        for array, x in states.items()
    }
