"""One compiled function on arrays: one state or a batch, checked."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from robodyn.dynamics.functions import Array as Described
from robodyn.dynamics.functions import arrays
from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.arrays import (
    Array,
    Shape,
    check_output,
    common_lead,
    read_input,
    read_parameters,
    shape_text,
)
from robodyn.kernels.results import CONVERTED, handed_back, named_results
from robodyn.toolchain.library import Library

#: What checks an input: ``(where, name, shape, value, dtype)``.
Reader = Callable[[str, str, Shape, object, np.dtype[Any]], Array]


class Function:
    """One function of a kernel, to be called on arrays; its ``__doc__`` says on which.

    Every input is one state or ``[N, ...]`` states; all agree. Lists, tuples and arrays of any real type
    are accepted and converted to the kernel's type (rounded, if it is wider); arrays of that type that are
    contiguous are used in place. NaN and infinity are not refused: what depends on them is NaN. A frame is
    ``[3, 4]`` or ``[4, 4]``. What is optional may be left out, and one may go with N states.

    ``params`` gives every run-time parameter by name. ``out`` is an array (a tuple of them, if there is more
    than one result) of the result's shape and the kernel's type, which is written to and returned. Without
    it, what is true or not is of bools, and what counts of integers.

    A function of a robot whose effects remember (``signature.states``) takes its states as one after another
    in time, ``dt`` [s] apart. It begins at rest, or with ``state`` [k], which it moves on in place.

    Raises
    ------
    InputError: says which argument is wrong, what was found, what was expected.
    """

    def __init__(self, signature: Signature, library: Library, parameters: Sequence[str]) -> None:
        self.signature = signature
        self.name = signature.function
        self.parameters = tuple(parameters) if signature.parameters else ()
        self.block_parameters = tuple(parameters)
        self.dtype: np.dtype[Any] = np.dtype(np.float64 if signature.scalar == "double" else np.float32)
        self.library = library
        self._inputs, self._names = (
            tuple(name for name, _ in arrays) for arrays in (signature.inputs, signature.outputs)
        )
        self.inputs, self.results = shapes_of(signature)
        self.says = tuple(array_of(name, size).says for name, size in signature.outputs)
        self.optional = optional_of(signature)
        self.where = f"{signature.robot}.{signature.function}"
        self._call = getattr(library.lib, f"{signature.function}_robodyn_batch")
        self._pointer = f"{signature.scalar}[]"
        self._view, self._null = library.ffi.from_buffer, library.ffi.NULL
        self.__doc__ = _document(self)

    def __call__(
        self,
        *arrays: object,
        params: Mapping[str, float] | None = None,
        out: Array | Sequence[Array] | None = None,
        state: Array | None = None,
        dt: float | None = None,
        **named: object,
    ) -> Any:
        if named or len(arrays) != len(self._inputs):
            arrays = self.bind(arrays, named)
        where = self.where
        inputs = self.read(arrays, read_input)
        lead = common_lead(where, self._inputs, inputs)
        if (state is not None or dt is not None) and not self.signature.states:
            raise InputError(f"{where} remembers nothing", found="state or dt", expected="neither")
        results = self.arrays_to_write(lead, out, arrays)
        values = self._null
        pointer, view = self._pointer, self._view
        if self.parameters or params:
            values = view(pointer, read_parameters(where, self.parameters, params, self.dtype))
        count = lead[0] if lead else 1
        if count:
            ins = [view(pointer, array) for array in inputs]
            outs = [view(pointer, array) for array in results]
            if self.signature.states:
                memory = view(pointer, self._state(state, dt), True)
                if state is None:
                    self._call(1, *ins, *outs, values, memory, 0.0)  # at rest before the first state
                self._call(count, *ins, *outs, values, memory, dt)
            else:
                self._call(count, *ins, *outs, values)
        return self.hand_back(results, are_new=out is None)

    def hand_back(self, results: Sequence[Array], *, are_new: bool) -> Any:
        """The ``results``, one as it is, several as a tuple with names. Where they ``are_new`` and no arrays
        of the caller's, what is true or counts is of bools and integers; what is NaN is not true."""
        if are_new:
            results = [CONVERTED[says](x) for x, says in zip(results, self.says, strict=True)]
        return handed_back(self._names, results)

    def read(self, arrays: Sequence[object], read: Reader) -> list[Array]:
        """The inputs, checked by ``read``; vectors that are optional, and come last, are zero where they are
        left out (None), and that of one state goes with all."""
        where, dtype = self.where, self.dtype
        lead: Shape = ()
        inputs: list[Array] = []
        for (name, shape), value in zip(self.inputs, arrays, strict=True):
            if name not in self.optional:
                array = read(where, name, shape, value, dtype)
                lead = array.shape[:-1]
            elif value is None:
                array = np.zeros((*lead, *shape), dtype)
            else:
                array = read_input(where, name, shape, value, dtype)
                if array.ndim == 1:
                    array = np.ascontiguousarray(np.broadcast_to(array, (*lead, *shape)))
            inputs.append(array)
        return inputs

    def _state(self, state: Array | None, dt: float | None) -> Array:
        """The memory of the effects: a new one, or ``state`` itself."""
        names = self.signature.states
        if dt is None or not 0 <= dt < math.inf:
            raise InputError(
                f"{self.where} remembers, and needs the time between states",
                found=f"dt = {dt}",
                expected="dt in s, 0 or more",
            )
        if state is None:
            return np.zeros(len(names), self.dtype)
        if state.shape != (len(names),) or state.dtype != self.dtype or not state.flags.c_contiguous:
            raise InputError(
                f"{self.where}: state does not fit",
                found=f"{list(state.shape)} of {state.dtype}",
                expected=f"an array [{len(names)}] of {self.dtype}: {', '.join(names)}",
            )
        return state

    def bind(self, arrays: tuple[object, ...], named: dict[str, object]) -> tuple[object, ...]:
        """Positional and named arguments in the order of the signature."""
        names = self._inputs
        bound = dict(zip(names, arrays, strict=False))
        wrong = [f"{name} twice" for name in named if name in bound]
        wrong += [f"unknown {name}" for name in named if name not in names]
        named = {**dict.fromkeys(self.optional - bound.keys()), **named}
        wrong += [f"no {name}" for name in names if name not in bound and name not in named]
        if len(arrays) > len(names):
            wrong.append(f"{len(arrays)} arrays")
        if wrong:
            raise InputError(
                f"{self.where}: the arguments do not fit", found=", ".join(wrong), expected=", ".join(names)
            )
        return tuple({**bound, **named}[name] for name in names)

    def arrays_to_write(
        self, lead: Shape, out: object, arrays: Sequence[object], *, columns: bool = False
    ) -> list[Array]:
        """Arrays to write to: new ones, or those of ``out``; ``columns``: those may also hold the values of
        each element one after another."""
        if out is None:
            return [np.empty(lead + shape, self.dtype) for _, shape in self.results]
        shapes = [lead + shape for _, shape in self.results]
        outputs = [out] if len(shapes) == 1 else list(out) if isinstance(out, (tuple, list)) else []
        if len(outputs) != len(shapes):
            raise InputError(
                f"{self.where}: out does not fit", expected=f"{len(shapes)} arrays: {self._output_text()}"
            )
        busy = dict(zip(self._inputs, arrays, strict=True))
        checked: list[Array] = []
        for (name, _), shape, array in zip(self.results, shapes, outputs, strict=True):
            checked.append(check_output(self.where, name, shape, array, self.dtype, busy, columns=columns))
            busy[name] = array
        return checked

    def _output_text(self) -> str:
        return ", ".join(f"{name} {shape_text(shape)}" for name, shape in self.results)

    def __copy__(self) -> Function:
        return self  # the memory of one that C answers cannot be copied, and nothing in it changes

    def __repr__(self) -> str:
        return f"<{self.where}({', '.join(self._inputs)}) -> {self._output_text()}>"


def function_of(signature: Signature, library: Library, parameters: Sequence[str]) -> Function:
    """The function ``signature`` of ``library``; one whose calls with arrays that need no conversion are
    answered by the library's own C, where it has such."""
    if library.direct is None:
        return Function(signature, library, parameters)
    shown = inspect.signature(Function.__call__)
    shown = shown.replace(parameters=list(shown.parameters.values())[1:])  # without self
    kind: Any = type("Function", (library.direct.Call, Function), {"__signature__": shown})
    made = kind(signature, library, parameters)
    made.of(made.name, named_results(made._names), Function.__call__)
    function: Function = made
    return function


def optional_of(signature: Signature) -> frozenset[str]:
    """The inputs of ``signature`` that may be left out; they come last."""
    return frozenset(name for name, length in signature.inputs if array_of(name, length).optional)


def shapes_of(signature: Signature) -> tuple[tuple[tuple[str, Shape], ...], tuple[tuple[str, Shape], ...]]:
    """Names and shapes of the inputs of ``signature``, and of its results."""
    inputs, results = (
        tuple((name, array_of(name, size).shape_of(size, signature.joints)) for name, size in arrays)
        for arrays in (signature.inputs, signature.outputs)
    )
    return inputs, results


def array_of(name: str, length: int) -> Described:
    """What the array ``name`` is; one of a function by other makers is a vector."""
    return arrays().get(name) or Described(name, "SI units", "", shape=(length,))


def _document(function: Function) -> str:
    """The docstring of a function: every array with its shape and unit."""
    s = function.signature

    def line(name: str, shape: Shape) -> str:
        both = f"{shape_text(shape)} or {shape_text(['N', *shape])}"
        return f"{name}: {both}, {s.scalar}; {array_of(name, 1).words}"

    lines = [
        f"{s.function.replace('_', ' ').capitalize()} of {s.robot}, compiled.",
        "",
        "Parameters",
        "----------",
    ]
    lines += [
        line(name, shape) + ("; zeros if left out" if name in function.optional else "")
        for name, shape in function.inputs
    ]
    if function.parameters:
        lines.append(f"params: run-time parameters, SI units: {', '.join(function.parameters)}")
    lines += ["out: array to write to, of the shape and type of the result", "", "Returns", "-------"]
    lines += [line(name, shape) for name, shape in function.results]
    return "\n".join(lines)
