"""What the kernel's bits must be: the program, run in numpy with the roundings of the kernel's type.

numpy adds, multiplies, divides and takes roots of float32 and float64 as IEEE 754 says, one rounding an
operation, as the emitted C does where nothing is contracted and nothing reordered.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.emit.spelling import nearest_float
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
