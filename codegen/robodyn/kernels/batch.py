"""One function on many states in one call, with the processor's vectors and, where asked for, in threads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from robodyn.errors import InputError
from robodyn.kernels.arrays import (
    Array,
    common_lead,
    laid_out,
    read_parameters,
    read_states,
    states_last,
)
from robodyn.kernels.function import Function
from robodyn.kernels.solutions import handed_back
from robodyn.kernels.threads import run_all
from robodyn.toolchain.library import Library

#: Fewer states than this are not worth another thread: it takes longer to wake it.
LEAST_FOR_A_THREAD = 2048

#: Threads take multiples of this many states, so that no vector is filled up in the middle.
_GRAIN = 64


class Batch:
    """A batch kernel, to be called on arrays; see :meth:`robodyn.kernels.kernel.Kernel.batch`."""

    def __init__(self, function: Function, library: Library) -> None:
        self.function, self.library = function, library
        name = function.name
        self._columns = getattr(library.lib, f"{name}_robodyn_columns")
        self._rows = getattr(library.lib, f"{name}_robodyn_rows")
        self._pointer = f"{function.signature.scalar}[]"

    def __call__(
        self,
        arrays: Sequence[object],
        *,
        params: Mapping[str, float] | None,
        out: Array | Sequence[Array] | None,
        threads: int,
    ) -> Any:
        function, where, dtype = self.function, self.function.where, self.function.dtype
        value: object = threads  # nobody checks what is passed from Python
        if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or value < 1:
            raise InputError(
                f"{where}: threads is not a number of threads", found=repr(value), expected="1 or more"
            )
        names = [name for name, _ in function.inputs]
        passed = function.read(arrays, read_states)
        (count,) = common_lead(where, names, passed)
        results, columns = self._results(count, out, passed, arrays)
        inputs = [laid_out(array, dtype, columns=columns) for array in passed]
        values: Any = self.library.ffi.NULL
        if function.parameters or params:
            values = self._view(read_parameters(where, function.parameters, params, dtype))
        if count:
            self._run(count, int(threads), [*inputs, *results], values, columns=columns)
        return handed_back(tuple(name for name, _ in function.results), results)

    def _results(
        self,
        count: int,
        out: Array | Sequence[Array] | None,
        passed: Sequence[Array],
        arrays: Sequence[object],
    ) -> tuple[list[Array], bool]:
        """The arrays to write to, and whether all arrays go column by column."""
        function = self.function
        columns = all(array.flags.f_contiguous and not array.flags.c_contiguous for array in passed)
        if out is None and columns:
            empty = (np.empty((*shape, count), function.dtype) for _, shape in function.results)
            return [np.moveaxis(array, -1, 0) for array in empty], True
        results = function.arrays_to_write((count,), out, arrays, columns=True)
        columns = not all(array.flags.c_contiguous for array in results)
        if columns and not all(states_last(array).flags.c_contiguous for array in results):
            raise InputError(
                f"{function.where}: out does not fit",
                found="arrays row by row and column by column",
                expected="one order for all",
            )
        return results, columns

    def _run(
        self,
        count: int,
        threads: int,
        arrays: Sequence[Array],
        values: Any,
        *,
        columns: bool,
    ) -> None:
        if columns:
            pointers = [self._view(states_last(array)) for array in arrays]
            call, steps = partial(self._columns_of, count), [1] * len(arrays)
        else:
            pointers = [self._view(array) for array in arrays]
            call, steps = self._rows, [array[0].size for array in arrays]
        parts = max(1, min(threads, count // LEAST_FOR_A_THREAD))
        size = -(-count // (parts * _GRAIN)) * _GRAIN
        run_all(
            [
                partial(
                    call,
                    min(size, count - first),
                    *(pointer + step * first for pointer, step in zip(pointers, steps, strict=True)),
                    values,
                )
                for first in range(0, count, size)
            ]
        )

    def _columns_of(self, stride: int, count: int, *arguments: Any) -> None:
        self._columns(count, stride, *arguments)

    def _view(self, array: Array) -> Any:
        return self.library.ffi.from_buffer(self._pointer, array)
