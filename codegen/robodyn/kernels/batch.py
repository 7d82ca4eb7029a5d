"""One function on many states in one call, with the processor's vectors and, where asked for, in threads.

``F_robodyn_columns(count, stride, inputs..., outputs..., parameters)``
    runs F on ``count`` states, element j of state k at ``[j*stride + k]``;
``F_robodyn_rows(count, inputs..., outputs..., parameters)``
    runs F on states that stand one after another.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Any

import numpy as np

from robodyn.errors import InputError
from robodyn.ir.signature import Signature
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
from robodyn.toolchain.library import Calls, Library

_lock = threading.Lock()
_pool: ThreadPoolExecutor | None = None
_size = 0


def run_all(jobs: Sequence[Callable[[], object]]) -> None:
    """Run all ``jobs``, the first in this thread and the others in threads of the pool, and wait for them.

    They run in parallel as far as they release Python's lock.
    """
    if len(jobs) > 1:
        pool = _pool_of(len(jobs) - 1)
        waiting = [pool.submit(job) for job in jobs[1:]]
        jobs[0]()
        for future in waiting:
            future.result()
    elif jobs:
        jobs[0]()


def _pool_of(size: int) -> ThreadPoolExecutor:
    """The pool, with ``size`` threads at least. A smaller one ends when its work is done."""
    global _pool, _size
    with _lock:
        if _pool is None or _size < size:
            if _pool is not None:
                _pool.shutdown(wait=False)
            _pool, _size = ThreadPoolExecutor(size, thread_name_prefix="robodyn"), size
        return _pool


def _forget() -> None:
    """In a forked child there are no threads: the next batch makes new ones."""
    global _pool, _size, _lock
    _pool, _size, _lock = None, 0, threading.Lock()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget)


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
    columns = f"void {s.function}_robodyn_columns(size_t count, size_t stride{arrays})"
    rows = f"void {s.function}_robodyn_rows(size_t count{arrays})"
    lines = [f"/* Calls from Python into the batches of {s.robot}. */", f'#include "{s.robot}_batch.h"']
    lines += [f"{columns};", f"{rows};"]
    for head, call in (
        (columns, f"{s.symbol}_batch(count, stride{passed});"),
        (rows, f"{s.symbol}_batch_rows(count{passed});"),
    ):
        lines += [head, "{", *fill, "    (void)parameters;", f"    {call}", "}"]
    return Calls(f"{columns};\n{rows};\n", "\n".join(lines) + "\n")
