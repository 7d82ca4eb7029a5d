"""States that C, Fortran and Python make alike, to the bit, and the bits of a kernel's results at them.

The generator is x <- 1664525 x + 1013904223 modulo 2^32 (W. H. Press et al., Numerical Recipes); the upper 24
bits of x, less 2^23 and times 2^-23, are a number in [-1, 1) that a float has exactly. An element of a state
is then ``middle + half*number``, rounded twice.

A kernel's bits are those of its program, run in numpy with the roundings of the kernel's type, and its own
sine, cosine and arctangent. numpy adds, multiplies, divides and takes roots of float32 and float64 as IEEE
754 says, one rounding an operation, as the emitted C does where nothing is contracted and nothing reordered.
The trigonometry is what ``templates/c/trig.c.j2`` and ``templates/c/atan2.c.j2`` say, once more: the numbers
are those of :mod:`robodyn.emit.trig`, the steps are written out here a second time, so that neither can
change without the self-test noticing.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.dynamics.functions.record import NEAR, POSE
from robodyn.emit.spelling import nearest_float
from robodyn.emit.trig import DOUBLE, FLOAT, WIDE, Trigonometric
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input, Program
from robodyn.ir.signature import ScalarType
from robodyn.robot.model import Robot
from robodyn.verify.numbers import exact_value
from robodyn.verify.sample import bounds_of

Array = NDArray[Any]
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
    links = [robot.links[joint] for joint in robot.commanded]
    bounds = [bounds_of(link.joint) for link in links]
    for joint, link in zip(bounds, links, strict=True):
        if link.joint.kind == "revolute":  # of many turns those around zero, where sines are best
            low, high = joint[0]
            joint[0] = max(low, min(high, -_TURNS)), min(high, max(low, _TURNS))
    reach = _reach(robot)
    result = []
    for array in arrays:
        if array == "tau":
            limits = [link.joint.limits.torque for link in links]
            spans = [(-t, t) for t in (_TORQUE if x is None else float(x) for x in limits)]
        elif array == POSE.name:
            base = (0, 0, 0) if robot.base is None else robot.base.xyz
            places = [(float(x) - reach, float(x) + reach) for x in base]
            spans = [span for place in places for span in (*[(-1.0, 1.0)] * 3, place)]
        elif array == NEAR.name:
            spans = [joint[0] for joint in bounds]
        else:
            spans = [joint[("q", "qd", "qdd").index(array)] for joint in bounds]
        pairs = [_inside(low, high, scalar) for low, high in spans]
        result.append(Range(array, tuple(m for m, _ in pairs), tuple(h for _, h in pairs)))
    return tuple(result)


def _reach(robot: Robot) -> float:
    """How far turning joints bring the tool from the base at most [m], and a bit more; parameters are 1."""
    values = dict.fromkeys(robot.parameters, 1.0)
    lengths = [x for link in robot.links for x in (link.joint.a, link.joint.b, link.joint.d)]
    lengths += [] if robot.tool is None else robot.tool.xyz
    return float(sum((abs(exact_value(x, values)) for x in lengths), Fraction(1, 10)))


def _inside(low: float, high: float, scalar: ScalarType) -> tuple[float, float]:
    """Middle and half width of a range in ``low .. high``, in few digits."""
    middle = float(DTYPE[scalar](f"{(low + high) / 2:.{_DIGITS}g}"))
    room = Fraction(min(high - middle, middle - low)) * (1 - Fraction(1, 10**_DIGITS))
    if room <= 0:
        return middle, 0.0
    step = Fraction(10) ** (math.floor(math.log10(room)) - _DIGITS + 1)
    return middle, float(DTYPE[scalar](float(math.floor(room / step) * step)))


def draw(spans: Sequence[Range], states: int, seed: int, scalar: ScalarType) -> dict[str, Array]:
    """``states`` states, array by array ``[states, n]`` in the kernel's type; each draws array after array,
    joint 1 first."""
    real = DTYPE[scalar]
    ends = np.cumsum([len(span.middle) for span in spans], dtype=int)
    numbers, x = [], seed
    for _ in range(states * sum(ends[-1:])):
        x = (MULTIPLIER * x + INCREMENT) % 2**32
        numbers.append(x >> 8)
    unit = (np.array(numbers, np.int64) - 2**23).astype(real) * real(2.0**-23)
    parts = np.split(unit.reshape(states, -1), ends[:-1], axis=1)
    return {
        span.array: np.array(span.middle, real) + np.array(span.half, real) * part
        for span, part in zip(spans, parts, strict=True)
    }


def program_inputs(
    states: Mapping[str, Array], parameters: Mapping[str, float], real: Any = np.float64
) -> dict[Input, Array]:
    """What a program is evaluated at, ``[N]`` each and of type ``real``: the elements of ``states``
    ``[N, size]`` by array, and run-time ``parameters``, the same in all."""
    count = len(next(iter(states.values())))
    inputs = {Input(array, i): x.astype(real) for array, rows in states.items() for i, x in enumerate(rows.T)}
    return inputs | {Input(name, None): np.full(count, value, real) for name, value in parameters.items()}


def vector_states(spans: Sequence[Range], scalar: ScalarType) -> dict[str, Array]:
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


# --- the bits of the results --------------------------------------------------------------------------------

#: FNV-1a with 32 bits (G. Fowler, L. C. Noll, K.-P. Vo).
FNV_BASIS, FNV_PRIME = 2166136261, 16777619

Sine = Callable[[Array], Array]


def outputs(
    program: Program,
    states: Mapping[str, Array],
    parameters: Mapping[str, float],
    scalar: ScalarType,
    trigonometry: Mapping[str, Sine],
) -> Array:
    """The outputs of ``program`` one after another, ``[N, size]`` in the kernel's type, to the bit;
    ``trigonometry`` has the kernel's own ``sin``, ``cos`` and ``atan2``."""
    real = DTYPE[scalar]
    count = len(next(iter(states.values())))
    inputs = program_inputs(states, parameters, real)

    def number(value: Fraction) -> Any:
        return np.full(count, nearest_float(value) if scalar == "float" else float(value), real)

    def sign(x: Array) -> Array:
        return np.asarray(np.where(x > 0, real(1), np.where(x < 0, real(-1), real(0))))

    functions: dict[str, Callable[..., Any]] = {**trigonometry, "sqrt": np.sqrt, "abs": np.abs, "sign": sign}
    arrays = evaluate(program, inputs, constant=number, functions=functions).values()
    return np.stack([np.asarray(x, real) for elements in arrays for x in elements], axis=1)


def fnv1a(numbers: Array) -> int:
    """The digest of the bytes of ``numbers``, row by row, the lowest byte of each first."""
    digest = FNV_BASIS
    for byte in np.ascontiguousarray(numbers, numbers.dtype.newbyteorder("<")).tobytes():
        digest = (digest ^ byte) * FNV_PRIME & 0xFFFFFFFF
    return digest


def kernel_sine(scalar: ScalarType) -> dict[str, Callable[..., Array]]:
    """``sin`` and ``cos`` of arrays [rad], and ``atan2`` of two, in float32 (``float``) or float64."""
    of = FLOAT if scalar == "float" else DOUBLE
    return {
        "sin": lambda x: _sincos(x, of)[0],
        "cos": lambda x: _sincos(x, of)[1],
        "atan2": lambda y, x: _atan2(y, x, of),
    }


@np.errstate(all="ignore")  # angles that are too large end in NaN
def _sincos(x: Array, of: Trigonometric) -> tuple[Array, Array]:
    real: Any = np.float32 if of.bits == 32 else np.float64
    unsigned: Any = np.uint32 if of.bits == 32 else np.uint64
    last = of.bits - 1
    magic, over = real(of.magic), real(of.over)
    turns = x * real(of.per_quarter) + magic
    k = turns - magic
    y = x - (k * over) * real(of.first / of.over)
    w = k * real(of.second) if of.second >= 0 else (real(0) - k) * real(-of.second)
    h = y - w
    n = (w - (y - h)) + k * real(of.third)
    z = h * h
    zz = z * z
    p = _polynomial([real(a) for a in of.sine], z, zz)
    r = _polynomial([real(a) for a in of.cosine], z, zz)
    s = h - ((h * z) * p + n)
    c = real(0.75) + ((real(0.25) - real(0.5) * z) + (zz * r + h * n))
    quarter = turns.view(unsigned)
    odd = quarter << unsigned(last)
    half = ((quarter >> unsigned(1)) & unsigned(1)) << unsigned(last)
    sine, cosine = np.where(odd != 0, c, s), np.where(odd != 0, s, c)
    return (sine.view(unsigned) ^ half).view(real), (cosine.view(unsigned) ^ odd ^ half).view(real)


@np.errstate(all="ignore")  # points that are too far end in NaN
def _atan2(y: Array, x: Array, of: Trigonometric) -> Array:
    real: Any = np.float32 if of.bits == 32 else np.float64
    zero, half, one = real(0), real(0.5), real(1)
    steep = np.abs(y) > np.abs(x)
    a, b = np.where(steep, np.abs(y), np.abs(x)), np.where(steep, np.abs(x), np.abs(y))
    side = np.copysign(one, np.where(steep, -x, x))
    wide = b > a * real(WIDE)
    over = a + np.where(wide, b, zero)
    t = side * ((b - np.where(wide, a, zero)) / np.where(over == 0, one, over))
    k = ((one - np.where(steep, zero, side)) + side * np.where(wide, half, zero)) + zero * over
    z = t * t
    p = _polynomial([real(c) for c in of.arctangent], z, z * z)
    q = k * real(of.quarter[0])
    h = q + t
    n = (q - h) + t
    return np.asarray(np.copysign(h + (n + (k * real(of.quarter[1]) - (t * z) * p)), y))


def _polynomial(coefficients: Sequence[Any], z: Array, zz: Array) -> Array:
    """a - b z + c z^2 - d z^3 ..., in pairs."""
    pairs = [a - z * b for a, b in zip(coefficients[::2], coefficients[1::2], strict=False)]
    total = coefficients[-1] if len(coefficients) % 2 else pairs.pop()
    for pair in reversed(pairs):
        total = pair + zz * total
    return np.asarray(total)
