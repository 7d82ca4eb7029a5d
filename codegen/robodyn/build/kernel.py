"""Compiled kernels on numpy arrays.

    >>> kernel = load(signatures, files)                            # doctest: +SKIP
    >>> tau = kernel.inverse_dynamics(q, qd, qdd)                   # one state [6], or N of them [N, 6]
    >>> M = kernel.mass_matrix(q)                                   # [6, 6], or [N, 6, 6]
    >>> ws = kernel.workspace("inverse_dynamics")                   # for a control loop
    >>> ws.q[:] = q; ws(); ws.tau

Threads: a kernel has no state. Any number of threads may call it at once, and they run in parallel, because
Python's lock (the GIL) is released while a kernel runs; an array must not be written by one thread
while another uses it. A :class:`Workspace` is memory, and belongs to one thread at a time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from robodyn.build.compiler import Language
from robodyn.build.function import Function
from robodyn.build.library import Library, Mode, open_library
from robodyn.build.workspace import Workspace
from robodyn.build.wrapper import parameters_of
from robodyn.errors import InputError
from robodyn.ir.signature import Signature


def load(
    signatures: Sequence[Signature],
    files: Mapping[str, str],
    *,
    cc: str | None = None,
    fc: str | None = None,
    flags: str | Sequence[str] | None = None,
    language: Language = "c",
    mode: Mode = "auto",
    cache: Path | str | None = None,
) -> Kernel:
    """Compile the emitted files with the system's compiler and load them.

    Parameters
    ----------
    signatures: the functions to offer, all of one robot and one scalar type.
    files: emitted files, ``{path: text}``; with ``ROBOT.h`` for C. Files of other languages are ignored.
    cc, fc: the C and the Fortran compiler, maybe with arguments (default: ``CC``, ``FC``, the usual names).
        Fortran needs a C compiler too, for the calls from Python.
    flags: compiler flags of the emitted language in place of the default
        (:data:`~robodyn.build.compiler.C_FLAGS`, :data:`~robodyn.build.compiler.FORTRAN_FLAGS`);
        what makes a shared library is added.
    language: which of the emitted files to compile, ``c`` or ``fortran``.
    mode: ``api`` for the cheapest calls (needs Python's headers, compiles longer), ``abi`` for the least
        needs; ``auto`` is ``api`` where that works.
    cache: the folder of compiled kernels (default: ``$ROBODYN_CACHE``, ``$XDG_CACHE_HOME/robodyn``,
        ``~/.cache/robodyn``).

    Raises
    ------
    ToolError: no compiler, or it refuses the files, or the result does not load.
    InputError: the files are not those of the signatures.
    """
    signatures = tuple(signatures)
    _check(signatures)
    library = open_library(
        signatures,
        files,
        language=language,
        mode=mode,
        cc=cc,
        fc=fc,
        flags=flags,
        cache=None if cache is None else Path(cache),
    )
    again = {"cc": cc, "fc": fc, "flags": flags, "language": language, "mode": mode, "cache": cache}
    return Kernel(signatures, library, language, (signatures, dict(files), again))


def _check(signatures: Sequence[Signature]) -> None:
    if not signatures:
        raise InputError("there is no function to load", expected="one signature at least")
    for what in ("robot", "scalar"):
        found = sorted({str(getattr(s, what)) for s in signatures})
        if len(found) > 1:
            raise InputError(f"the functions of a kernel have one {what}", found=", ".join(found))
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
    mode, path, compiler, flags: how it was built, and where it lies.
    """

    def __init__(
        self, signatures: Sequence[Signature], library: Library, language: Language, recipe: tuple[Any, ...]
    ) -> None:
        self.robot = signatures[0].robot
        self.scalar = signatures[0].scalar
        self.language = language
        self.dtype: np.dtype[Any] = np.dtype(np.float64 if self.scalar == "double" else np.float32)
        self.signatures = {s.function: s for s in signatures}
        self.functions = tuple(self.signatures)
        self.parameters = parameters_of(signatures)
        self.mode, self.path = library.mode, library.path
        self.compiler, self.flags = library.compiler, library.flags
        self._recipe = recipe
        self._functions = {s.function: Function(s, library, self.parameters) for s in signatures}
        self.__dict__.update(self._functions)

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
        found = self._functions.get(function)
        if found is None:
            raise InputError(
                f"{self.robot}: there is no function {function!r}", expected=" or ".join(self.functions)
            )
        return Workspace(found, params)

    def __reduce__(self) -> tuple[Any, ...]:
        return _load_again, self._recipe

    def __repr__(self) -> str:
        return (
            f"<Kernel {self.robot}: {', '.join(self.functions)}; {self.scalar}, {self.language}, {self.mode}>"
        )


def _load_again(signatures: Sequence[Signature], files: Mapping[str, str], options: dict[str, Any]) -> Kernel:
    """A kernel that travelled to another process: found in the cache there, as a rule."""
    return load(signatures, files, **options)
