"""Compiled kernels on numpy arrays.

    >>> kernel = load(signatures, files)                            # doctest: +SKIP
    >>> tau = kernel.inverse_dynamics(q, qd, qdd)                   # one state [6], or N of them [N, 6]
    >>> M = kernel.mass_matrix(q)                                   # [6, 6], or [N, 6, 6]
    >>> ws = kernel.workspace("inverse_dynamics")                   # for a control loop
    >>> ws.q[:] = q; ws(); ws.tau
    >>> tau = kernel.batch(q, qd, qdd, threads=4)                   # [N, 6], with the processor's vectors

Threads: a kernel has no state. Any number of threads may call it at once, and they run in parallel, because
Python's lock (the GIL) is released while a kernel runs; an array must not be written by one thread
while another uses it. A :class:`Workspace` is memory, and belongs to one thread at a time.
"""

from __future__ import annotations

import functools
import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from robodyn.errors import InputError
from robodyn.ir.signature import Signature
from robodyn.kernels.arrays import Array, read_parameters
from robodyn.kernels.batch import Batch, batch_calls
from robodyn.kernels.direct import direct_calls
from robodyn.kernels.function import Function, function_of
from robodyn.kernels.wrapper import layout, parameters_of, prototypes, wrapper
from robodyn.toolchain.library import Calls, Library, Mode, open_library

#: Emitted C files of a function's batch, ``{path: text}``, by the function's name.
BatchFiles = Callable[[str], Mapping[str, str]]


def load(
    signatures: Sequence[Signature],
    files: Mapping[str, str],
    *,
    cc: str | None = None,
    fc: str | None = None,
    flags: str | Sequence[str] | None = None,
    language: str = "c",
    mode: Mode = "auto",
    cache: Path | str | None = None,
    batch: BatchFiles | None = None,
) -> Kernel:
    """Compile the emitted files with the system's compiler and load them.

    Parameters
    ----------
    signatures: the functions to offer, all of one robot and one scalar type.
    files: emitted files, ``{path: text}``; with ``ROBOT.h`` for C. Files of other languages are ignored.
    cc, fc: the C and the Fortran compiler, maybe with arguments (default: ``CC``, ``FC``, the usual names).
        Fortran needs a C compiler too, for the calls from Python.
    flags: compiler flags of the emitted language in place of the default
        (:class:`~robodyn.emit.language.Compiled`);
        what makes a shared library is added.
    language: which of the emitted files to compile, ``c`` or ``fortran``.
    mode: ``api`` for the cheapest calls (needs Python's headers, compiles longer), ``abi`` for the least
        needs; ``auto`` is ``api`` where that works.
    cache: the folder of compiled kernels (default: ``$ROBODYN_CACHE``, ``$XDG_CACHE_HOME/robodyn``,
        ``~/.cache/robodyn``).
    batch: what hands over the C files of a function's batch, by the function's name; asked when
        :meth:`Kernel.batch` first needs them.

    Raises
    ------
    ToolError: no compiler, or it refuses the files, or the result does not load.
    InputError: the files are not those of the signatures.
    """
    signatures = tuple(signatures)
    _check(signatures)
    library = open_library(
        Calls(prototypes(signatures), wrapper(signatures, files, language), direct_calls(signatures)),
        files,
        language=language,
        mode=mode,
        cc=cc,
        fc=fc,
        flags=flags,
        cache=None if cache is None else Path(cache),
    )
    again = functools.partial(
        load, signatures, dict(files), cc=cc, fc=fc, flags=flags, language=language, mode=mode, cache=cache,
        batch=batch,
    )  # fmt: skip
    return Kernel(signatures, library, language, again)


def _check(signatures: Sequence[Signature]) -> None:
    if not signatures:
        raise InputError("there is no function to load", expected="one signature at least")
    for what in ("robot", "scalar"):
        values = sorted({str(getattr(s, what)) for s in signatures})
        if len(values) > 1:
            raise InputError(f"the functions of a kernel have one {what}", found=", ".join(values))
    names = [s.function for s in signatures]
    if len(set(names)) < len(names):
        raise InputError("a function is there twice", found=", ".join(names))


class Kernel:
    """The functions of one robot, compiled; each is a method of its name (see :class:`Function`).

    Attributes
    ----------
    robot, scalar, language: name of the robot; ``double`` or ``float``; ``c`` or ``fortran``.
    dtype: numpy's float64 or float32.
    functions: names of the functions.
    signatures: ``{name: Signature}``.
    parameters: names of the run-time parameters.
    base_parameters: what each column of a regressor is, in numbers of the links; ``()`` without one.
    mode, path, compiler, flags: how it was built, and where it lies.
    """

    def __init__(
        self,
        signatures: Sequence[Signature],
        library: Library,
        language: str,
        again: functools.partial[Kernel],
    ) -> None:
        self.robot = signatures[0].robot
        self.scalar = signatures[0].scalar
        self.language = language
        self.dtype: np.dtype[Any] = np.dtype(np.float64 if self.scalar == "double" else np.float32)
        self.signatures = {s.function: s for s in signatures}
        self.functions = tuple(self.signatures)
        self.parameters = parameters_of(signatures)
        self.base_parameters = next((s.columns for s in signatures if s.columns), ())
        self.mode, self.path = library.mode, library.path
        self.compiler, self.flags = library.compiler, library.flags
        self._again = again
        self._functions = {s.function: function_of(s, library, self.parameters) for s in signatures}
        self.__dict__.update(self._functions)
        self._batches: dict[str, Batch] = {}
        self._lock = threading.Lock()

    def __getattr__(self, name: str) -> Function:
        raise AttributeError(
            f"this kernel has no {name!r}; it has {', '.join(self.__dict__.get('functions', ()))}"
        )

    def workspace(
        self, function: str = "inverse_dynamics", params: Mapping[str, float] | None = None
    ) -> Workspace:
        """Memory and a bound call of ``function`` for one state, for control loops.

        Raises
        ------
        InputError: there is no such function, or ``params`` do not fit.
        """
        return Workspace(self._function(function), params)

    def batch(
        self,
        *arrays: object,
        out: Array | Sequence[Array] | None = None,
        threads: int = 1,
        params: Mapping[str, float] | None = None,
        function: str = "inverse_dynamics",
        **named: object,
    ) -> Any:
        """``function`` on N states in one call, with the vectors that this processor has.

        The C for it is compiled when it is first asked for, and kept like the kernels. It uses sine and
        cosine of its own: a batch gives the bits of a kernel that was compiled with ``trig="builtin"``, which
        may differ by some units in the last place from one with those of libm.

        Parameters
        ----------
        arrays, named: the inputs of the function, ``[N, n]`` each. Where all are of the kernel's type and row
            by row (C order), or all column by column (Fortran order: ``[n, N]`` transposed),
            they are read in place; else they are copied.
        out: array to write to, ``[N, ...]``, of the kernel's type, in C order or with N running fastest; a
            tuple of them, all in one order, if there is more than one result. Without it there are new ones
            in the order of the inputs.
        threads: how many threads at most share the work; few states are not shared.
        params: run-time parameters, the same for all states.

        Raises
        ------
        InputError: there is no such function, it remembers between calls, or an argument does not fit.
        ToolError: no compiler, or it refuses the files.
        """
        entry = self._function(function)
        if named or len(arrays) != len(entry.signature.inputs):
            arrays = entry.bind(arrays, named)
        with self._lock:
            batch = self._batches.get(function) or self._make_batch(entry)
            self._batches[function] = batch
        return batch(arrays, params=params, out=out, threads=threads)

    def _make_batch(self, function: Function) -> Batch:
        if function.signature.states:
            raise InputError(
                f"{function.where} remembers between calls: its states come one after another in time",
                expected="a function without memory",
                remedy=f"call kernel.{function.name} with dt",
            )
        options = self._again.keywords
        files = options["batch"]
        if files is None:
            raise InputError(
                f"{self.robot}: this kernel was loaded from files that hold no batch",
                remedy="make it with robodyn.compile",
            )
        library = open_library(
            batch_calls(function.signature, function.parameters),
            files(function.name),
            language="c",
            flags=options["flags"] if self.language == "c" else None,
            cache=None if options["cache"] is None else Path(options["cache"]),
            **{name: options[name] for name in ("cc", "fc", "mode")},
        )
        return Batch(function, library)

    def _function(self, name: str) -> Function:
        entry = self._functions.get(name)
        if entry is None:
            raise InputError(
                f"{self.robot}: there is no function {name!r}", expected=" or ".join(self.functions)
            )
        return entry

    def __reduce__(self) -> tuple[Any, ...]:
        return self._again, ()  # in another process: found in the cache there, as a rule

    def __repr__(self) -> str:
        return (
            f"<Kernel {self.robot}: {', '.join(self.functions)}; {self.scalar}, {self.language}, {self.mode}>"
        )


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
