"""A bound call for control loops: memory for one state, and no argument to check."""

from __future__ import annotations

import functools
from collections.abc import Mapping
from typing import Any, NoReturn

import numpy as np

from robodyn.kernels.arrays import Array, read_parameters
from robodyn.kernels.function import Function
from robodyn.kernels.wrapper import layout


class Workspace(functools.partial[None]):
    """Memory for one state and the call that runs on it: ``ws.q[:] = ...; ws(); ws.tau``.

    The arrays are the attributes of their names, views of one aligned block that the kernel reads and writes
    in place. Inputs start at zero, outputs at NaN. ``ws.q = values`` copies into the array. Where there
    are run-time parameters, ``ws.params["m_tool"] = 2.8`` sets one; they start at ``params``, or at NaN.

    Where effects remember there are ``ws.state`` and ``ws.dt``: begin with a call at ``dt`` 0.

    A call takes no argument and returns None. It is the C call itself (a ``functools.partial`` of it), so
    that it costs what cffi costs. It is not for two threads at once.
    """

    def __new__(cls, function: Function, params: Mapping[str, float] | None = None) -> Workspace:
        signature, dtype, ffi = function.signature, function.dtype, function.library.ffi
        block = layout(signature, function.block_parameters)
        size = block.length * dtype.itemsize
        raw = np.zeros(size + 64, np.uint8)
        start = -raw.ctypes.data % 64
        memory = raw[start : start + size].view(dtype)
        views: dict[str, Array] = {}
        shapes = dict((*function.inputs, *function.results))
        outputs = dict(function.results)
        for name, offset, length in block.places:
            view = memory[offset : offset + length]
            views[name] = view.reshape(shapes[name])
            if name in outputs:
                view[:] = np.nan
        if function.parameters:
            values = memory[block.parameters : block.states]
            values[:] = np.nan
            if params is not None:
                values[:] = read_parameters(function.where, function.parameters, params, dtype)
            record = np.dtype([(name, dtype) for name in function.parameters])
            views["params"] = values.view(record).reshape(())
        elif params:
            read_parameters(function.where, (), params, dtype)
        if signature.states:
            views["state"] = memory[block.states : block.states + len(signature.states)]
            views["dt"] = memory[block.states + len(signature.states) : block.length]
        call = getattr(function.library.lib, f"{signature.function}_robodyn_work")
        pointer = ffi.from_buffer(f"{signature.scalar} *", memory, True)
        self = super().__new__(cls, call, pointer)
        self.__dict__.update(views, _function=function)
        return self

    def __getattr__(self, name: str) -> Array:
        raise AttributeError(f"this workspace has no {name!r}; it has {', '.join(self._names())}")

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._names():
            raise AttributeError(f"this workspace has no {name!r}; it has {', '.join(self._names())}")
        array: Array = self.__dict__[name]
        if name == "params" and isinstance(value, Mapping):
            function: Function = self.__dict__["_function"]
            values = read_parameters(function.where, function.parameters, value, function.dtype)
            value = tuple(values.tolist())
        array[...] = value

    def _names(self) -> list[str]:
        return [name for name in self.__dict__ if not name.startswith("_")]

    def __reduce__(self) -> NoReturn:
        raise TypeError("a workspace is memory of this process; make another with kernel.workspace()")

    def __repr__(self) -> str:
        function: Function = self.__dict__["_function"]
        return f"<Workspace of {function.where}: {', '.join(self._names())}>"
