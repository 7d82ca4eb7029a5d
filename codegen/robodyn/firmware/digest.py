"""What the kernel's bits must be: the program, run in numpy with the roundings of the kernel's type, and its
own sine, cosine and arctangent.

numpy adds, multiplies, divides and takes roots of float32 and float64 as IEEE 754 says, one rounding an
operation, as the emitted C does where nothing is contracted and nothing reordered. The trigonometry is what
``templates/c/trig.c.j2`` and ``templates/c/atan2.c.j2`` say, once more: the numbers are those of
:mod:`robodyn.emit.trig` and :mod:`robodyn.emit.arctangent`, the steps are written out here a second time, so
that neither can change without the self-test noticing.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.emit import arctangent
from robodyn.emit.spelling import nearest_float
from robodyn.emit.trig import DOUBLE, FLOAT, Trigonometric
from robodyn.firmware.states import DTYPE, program_inputs
from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Program
from robodyn.ir.signature import ScalarType

#: FNV-1a with 32 bits (G. Fowler, L. C. Noll, K.-P. Vo).
FNV_BASIS, FNV_PRIME = 2166136261, 16777619

Sine = Callable[[NDArray[Any]], NDArray[Any]]


def outputs(
    program: Program,
    states: Mapping[str, NDArray[Any]],
    parameters: Mapping[str, float],
    scalar: ScalarType,
    trigonometry: Mapping[str, Sine],
) -> NDArray[Any]:
    """The outputs of ``program`` one after another, ``[N, size]`` in the kernel's type, to the bit;
    ``trigonometry`` has the kernel's own ``sin``, ``cos`` and ``atan2``."""
    real = DTYPE[scalar]
    count = len(next(iter(states.values())))
    inputs = program_inputs(states, parameters, real)

    def number(value: Fraction) -> Any:
        return np.full(count, nearest_float(value) if scalar == "float" else float(value), real)

    def sign(x: NDArray[Any]) -> NDArray[Any]:
        return np.asarray(np.where(x > 0, real(1), np.where(x < 0, real(-1), real(0))))

    functions: dict[str, Callable[..., Any]] = {**trigonometry, "sqrt": np.sqrt, "abs": np.abs, "sign": sign}
    arrays = evaluate(program, inputs, constant=number, functions=functions).values()
    return np.stack([np.asarray(x, real) for elements in arrays for x in elements], axis=1)


def fnv1a(numbers: NDArray[Any]) -> int:
    """The digest of the bytes of ``numbers``, row by row, the lowest byte of each first."""
    digest = FNV_BASIS
    for byte in np.ascontiguousarray(numbers, numbers.dtype.newbyteorder("<")).tobytes():
        digest = (digest ^ byte) * FNV_PRIME & 0xFFFFFFFF
    return digest


Array = NDArray[Any]


def kernel_sine(scalar: ScalarType) -> dict[str, Callable[..., Array]]:
    """``sin`` and ``cos`` of arrays [rad], and ``atan2`` of two, in float32 (``float``) or float64."""
    of = FLOAT if scalar == "float" else DOUBLE
    angle_of = arctangent.FLOAT if scalar == "float" else arctangent.DOUBLE
    return {
        "sin": lambda x: _sincos(x, of)[0],
        "cos": lambda x: _sincos(x, of)[1],
        "atan2": lambda y, x: _atan2(y, x, angle_of),
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
def _atan2(y: Array, x: Array, of: arctangent.Arctangent) -> Array:
    real: Any = np.float32 if of.bits == 32 else np.float64
    zero, half, one = real(0), real(0.5), real(1)
    steep = np.abs(y) > np.abs(x)
    a, b = np.where(steep, np.abs(y), np.abs(x)), np.where(steep, np.abs(x), np.abs(y))
    side = np.copysign(one, np.where(steep, -x, x))
    wide = b > a * real(arctangent.WIDE)
    over = a + np.where(wide, b, zero)
    t = side * ((b - np.where(wide, a, zero)) / np.where(over == 0, one, over))
    k = ((one - np.where(steep, zero, side)) + side * np.where(wide, half, zero)) + zero * over
    z = t * t
    p = _polynomial([real(c) for c in of.coefficients], z, z * z)
    q = k * real(of.first)
    h = q + t
    n = (q - h) + t
    return np.asarray(np.copysign(h + (n + (k * real(of.second) - (t * z) * p)), y))


def _polynomial(coefficients: Sequence[Any], z: Array, zz: Array) -> Array:
    """a - b z + c z^2 - d z^3 ..., in pairs."""
    pairs = [a - z * b for a, b in zip(coefficients[::2], coefficients[1::2], strict=False)]
    total = coefficients[-1] if len(coefficients) % 2 else pairs.pop()
    for pair in reversed(pairs):
        total = pair + zz * total
    return np.asarray(total)
