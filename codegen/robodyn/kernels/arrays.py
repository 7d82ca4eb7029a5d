"""What a kernel accepts from Python, checked: arrays of states, run-time parameters, arrays to write to."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.errors import InputError

Array = NDArray[Any]
Shape = tuple[int, ...]

_REAL = frozenset("iuf")
#: A frame ``[R p]``, the same with the row 0 0 0 1, and by how much that may be off: it takes no part.
_FRAME, _WITH_LAST_ROW = (3, 4), (4, 4)
_LAST_ROW, _LAST_ROW_OFF = np.array([0.0, 0.0, 0.0, 1.0]), 1e-9
_KINDS = {"b": "booleans", "c": "complex numbers", "O": "Python objects", "S": "bytes", "U": "text"}


def shape_text(shape: Sequence[int | str]) -> str:
    """A shape as it is written in the documentation: ``[N, 6]``."""
    return f"[{', '.join(str(k) for k in shape)}]"


def read_input(where: str, name: str, shape: Shape, value: object, dtype: np.dtype[Any]) -> Array:
    """``value``, one state or N of them, of this ``shape`` each or flat, as a contiguous, aligned array of
    ``dtype``, ``[length]`` or ``[N, length]``.

    Real numbers of any other type are rounded to ``dtype``; where that is single precision a double is
    rounded too (and one beyond its range becomes infinite), for that is what the kernel computes in.
    An array that already fits is not copied. A frame ``[3, 4]`` may have the row 0 0 0 1 beneath.

    Raises
    ------
    InputError: not an array of real numbers, or of another shape.
    """
    array = _real_array(where, name, shape, value, dtype)
    length = math.prod(shape)
    if not 1 <= array.ndim <= 2 or array.shape[-1] != length:
        array = _flattened(where, name, shape, array)
    return laid_out(array, dtype, columns=False)


def read_states(where: str, name: str, shape: Shape, value: object, dtype: np.dtype[Any]) -> Array:
    """``value``, N states of this ``shape`` each or flat, as an array of real numbers ``[N, length]``, of any
    type and layout.

    Raises
    ------
    InputError: not an array of real numbers, or of another shape.
    """
    array = _real_array(where, name, shape, value, dtype)
    length = math.prod(shape)
    if array.ndim != 2 or array.shape[1] != length:
        one = array.shape in _shapes_of_one(shape)
        if not one and array.ndim == len(shape) + 1 and len(shape) > 1:
            return _flattened(where, name, shape, array)
        raise InputError(
            f"{where}: {name} is not a batch of states",
            found=shape_text(array.shape),
            expected=shape_text(["N", *shape]),
            remedy=f"for a single state call kernel.{where.partition('.')[2]}" if one else None,
        )
    return array


def _shapes_of_one(shape: Shape) -> list[Shape]:
    """The shapes that one state's array may have."""
    shapes = [(math.prod(shape),), shape, *([_WITH_LAST_ROW] if shape == _FRAME else [])]
    return shapes if len(shape) > 1 else shapes[:1]


def _flattened(where: str, name: str, shape: Shape, array: Array) -> Array:
    """Matrices of one state or N of them as rows of numbers."""
    for inner in _shapes_of_one(shape):
        lead = array.shape[: -len(inner)]
        if len(lead) > 1 or array.shape[len(lead) :] != inner:
            continue
        if inner == _WITH_LAST_ROW:
            last = array[..., 3, :]
            if not (np.abs(last - _LAST_ROW) <= _LAST_ROW_OFF).all():
                raise InputError(
                    f"{where}: {name} is no frame",
                    found=f"the last row {last.reshape(-1, 4)[0].tolist()}",
                    expected="0 0 0 1, or the first three rows alone",
                )
            array = array[..., :3, :]
        return array.reshape((*lead, math.prod(shape)))
    raise InputError(
        f"{where}: {name} has the wrong shape", found=shape_text(array.shape), expected=_either(shape)
    )


def laid_out(array: Array, dtype: np.dtype[Any], *, columns: bool) -> Array:
    """``array`` in the kernel's type, row by row, or column by column; itself where it is so already."""
    fits = array.flags.f_contiguous if columns else array.flags.c_contiguous
    if array.dtype == dtype and fits and array.flags.aligned:
        return array
    with np.errstate(over="ignore"):
        return np.array(array, dtype=dtype, order="F" if columns else "C", copy=True, subok=False)


def _real_array(where: str, name: str, shape: Shape, value: object, dtype: np.dtype[Any]) -> Array:
    if isinstance(value, np.ma.MaskedArray):
        raise InputError(f"{where}: {name} is a masked array", remedy="fill or drop what is masked")
    try:
        array = np.asarray(value)
    except (ValueError, TypeError, OverflowError) as error:
        raise InputError(
            f"{where}: {name} is not an array of numbers", found=str(error), expected=_either(shape)
        ) from None
    if array.dtype.kind not in _REAL:
        kind = _KINDS.get(array.dtype.kind, f"{array.dtype}")
        raise InputError(
            f"{where}: {name} is not an array of real numbers",
            found=f"{kind} of shape {shape_text(array.shape)}",
            expected=f"{dtype}, or real numbers that can be converted to it",
        )
    return array


def _either(shape: Shape) -> str:
    return f"{shape_text(shape)} or {shape_text(['N', *shape])}"


def common_lead(where: str, names: Sequence[str], arrays: Sequence[Array]) -> Shape:
    """What stands before a state's own shape: ``(N,)`` in a batch, ``()`` for a single state.

    Raises
    ------
    InputError: the arrays do not agree.
    """
    lead = arrays[0].shape[:-1]
    for array in arrays:
        if array.shape[:-1] != lead:
            raise InputError(
                f"{where}: the arrays do not hold the same number of states",
                found=", ".join(f"{n} {shape_text(a.shape)}" for n, a in zip(names, arrays, strict=True)),
                expected="one state in each, or N in each",
            )
    return lead


def check_output(
    where: str,
    name: str,
    shape: Shape,
    value: object,
    dtype: np.dtype[Any],
    inputs: Mapping[str, object],
    *,
    columns: bool = False,
) -> Array:
    """``value`` if the kernel can write its result straight into it; ``columns``: it may also hold the values
    of each element of the result one after another.

    Raises
    ------
    InputError: another shape or type, not contiguous, read-only, or in memory that an input lies in.
    """
    expected = f"{dtype} {shape_text(shape)}, contiguous and writable"
    if not isinstance(value, np.ndarray):
        found, expected = type(value).__name__, f"an array, {expected}"
    elif value.shape != shape or value.dtype != dtype:
        found = f"{value.dtype} {shape_text(value.shape)}"
    elif not value.flags.aligned or not (
        value.flags.c_contiguous or (columns and states_last(value).flags.c_contiguous)
    ):
        found = "an array with gaps or out of line (a slice?)"
    elif not value.flags.writeable:
        found = "a read-only array"
    else:
        given = ((name, x) for name, x in inputs.items() if isinstance(x, np.ndarray))
        other = next((name for name, x in given if np.shares_memory(value, x)), None)
        if other is None:
            return value
        found, expected = f"memory that {other} lies in", "memory of its own"
    raise InputError(f"{where}: out cannot take {name}", found=found, expected=expected)


def states_last(array: Array) -> Array:
    """A view of ``array`` ``[N, ...]`` with its first axis last; contiguous where the states' index runs
    fastest in memory."""
    return array.T if array.ndim == 2 else array.transpose(*range(1, array.ndim), 0)


def read_parameters(
    where: str, names: Sequence[str], params: Mapping[str, float] | None, dtype: np.dtype[Any]
) -> Array:
    """The values of all run-time parameters, in the order of ``names``; NaN and infinity pass.

    Raises
    ------
    InputError: one is missing, unknown, or not a real number.
    """
    entries: Mapping[str, float] = {} if params is None else params
    if not isinstance(entries, Mapping):
        raise InputError(
            f"{where}: params is not a mapping", found=type(params).__name__, expected="{name: number}"
        )
    missing = [name for name in names if name not in entries]
    unknown = [str(name) for name in entries if name not in names]
    if missing or unknown:
        problems = [f"missing: {', '.join(missing)}"] if missing else []
        problems += [f"unknown: {', '.join(unknown)}"] if unknown else []
        raise InputError(
            f"{where}: params do not fit",
            found="; ".join(problems),
            expected=f"numbers for {', '.join(names)}" if names else "none: there are no run-time parameters",
        )
    values = [_real(where, name, entries[name]) for name in names]
    with np.errstate(over="ignore"):
        return np.array(values, dtype=np.float64).astype(dtype)


def _real(where: str, name: str, value: object) -> float:
    if isinstance(value, (int, float, Fraction, np.integer, np.floating)) and not isinstance(value, bool):
        try:
            return float(value)
        except OverflowError:
            return math.inf if value > 0 else -math.inf
    raise InputError(f"{where}: parameter {name} is not a number", found=repr(value), expected="a number")
