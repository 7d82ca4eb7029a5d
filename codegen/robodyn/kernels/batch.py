"""One function on many states in one call, with the processor's vectors and, where asked for, in threads.

``F_robodyn_many(count, block, inputs..., outputs..., parameters)``
    runs F on ``count`` states in blocks of ``block``: of one, where they stand one after another, or of all,
    where the values of each element do.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cache, partial
from typing import Any

import numpy as np

from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.arrays import Array, common_lead, laid_out, read_parameters, read_states, states_last
from robodyn.kernels.function import Function
from robodyn.toolchain.library import Calls, Library


@cache
def _pool() -> ThreadPoolExecutor:
    """Threads beside the caller's, which start as they are needed."""
    return ThreadPoolExecutor(os.cpu_count(), thread_name_prefix="robodyn")


if hasattr(os, "register_at_fork"):  # in a forked child there are no threads
    os.register_at_fork(after_in_child=_pool.cache_clear)


#: Fewer states than this are not worth another thread: it takes longer to wake it.
LEAST_FOR_A_THREAD = 2048

#: Threads take multiples of this many states, so that no vector is filled up in the middle.
_GRAIN = 64


class Batch:
    """A batch kernel, to be called on arrays; see :meth:`robodyn.kernels.kernel.Kernel.batch`."""

    def __init__(self, function: Function, library: Library) -> None:
        self.function = function
        name, pointer = function.name, f"{function.signature.scalar}[]"
        self._many = getattr(library.lib, f"{name}_robodyn_many")
        self._view, self._null = partial(library.ffi.from_buffer, pointer), library.ffi.NULL

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
        passed = function.read(arrays, read_states)
        (count,) = common_lead(where, [name for name, _ in function.inputs], passed)
        results, columns = self._results(count, out, passed, arrays)
        inputs = [laid_out(array, dtype, columns=columns) for array in passed]
        values: Any = self._null
        if function.parameters or params:
            values = self._view(read_parameters(where, function.parameters, params, dtype))
        if count:
            self._run(count, int(threads), [*inputs, *results], values, columns=columns)
        return function.hand_back(results, are_new=out is None)

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

    def _run(self, count: int, threads: int, arrays: Sequence[Array], values: Any, *, columns: bool) -> None:
        """In parts, the first in this thread and the others in threads of the pool. They run in parallel
        because Python's lock is released."""
        pointers = [self._view(states_last(array) if columns else array) for array in arrays]
        steps = [1 if columns else array[0].size for array in arrays]
        parts = max(1, min(threads, count // LEAST_FOR_A_THREAD))
        size = -(-count // (parts * _GRAIN)) * _GRAIN

        def run(first: int) -> None:
            part = [pointer + step * first for pointer, step in zip(pointers, steps, strict=True)]
            states = min(size, count - first)
            self._many(states, count if columns else 1, *part, values)

        waiting = [_pool().submit(run, first) for first in range(size, count, size)]
        run(0)
        for future in waiting:
            future.result()


def batch_calls(signature: Signature, parameters: Sequence[str]) -> Calls:
    """The calls of ``signature``; run-time ``parameters`` are an array, in that order."""
    s = signature
    arrays = "".join(f", const {s.scalar} *i{k}" for k in range(len(s.inputs)))
    arrays += "".join(f", {s.scalar} *o{k}" for k in range(len(s.outputs)))
    arrays += f", const {s.scalar} *parameters"
    passed = "".join(f", i{k}" for k in range(len(s.inputs)))
    passed += "".join(f", o{k}" for k in range(len(s.outputs)))
    passed += ", &p" if s.parameters else ""
    fill = [f"    {s.robot}_params p = {{0}};"] if s.parameters else []
    fill += [f"    p.{name} = parameters[{k}];" for k, name in enumerate(parameters) if name in s.parameters]
    head = f"void {s.function}_robodyn_many(size_t count, size_t block{arrays})"
    lines = [f"/* Calls from Python into the batches of {s.robot}. */", f'#include "{s.robot}_batch.h"']
    lines += [f"{head};", head, "{", *fill, "    (void)parameters;"]
    lines += [f"    {s.symbol}_batch(count, block{passed});", "}"]
    return Calls(f"{head};\n", "\n".join(lines) + "\n")
