"""A kernel in each language, run on states from Python."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from emit.angles import TYPES
from emit.crates import Crate
from emit.kernels import STRICT, STRICT_FORTRAN, write
from emit.modules import Module
from robodyn.emit.batch import batch_files
from robodyn.emit.languages.fortran import LANGUAGE as FORTRAN
from robodyn.kernels.generate import Generated
from robodyn_testing import require_tool

#: The languages, and batches of C.
LANGUAGES: Final = ("c", "batch", "fortran", "javascript", "rust")


def library(folder: Path, source: str, *command: str) -> ctypes.CDLL:
    """``source`` as a library, compiled with ``command``, which must have nothing to say."""
    done = subprocess.run(
        [*command, "-shared", "-fPIC", source, "-o", f"{source}.so", "-lm"],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    return ctypes.CDLL(str(folder / f"{source}.so"))


def called(function: Any, *arrays: NDArray[Any]) -> None:
    """Call a C function on ``arrays``."""
    function(*(a.ctypes.data_as(ctypes.c_void_p) for a in arrays))


def outcome(
    language: str, generated: Generated, function: str, inputs: Mapping[str, NDArray[Any]], folder: Path
) -> NDArray[Any]:
    """The results ``[N, size]`` of ``function`` at ``inputs`` ``[N, ...]`` by name, without parameters."""
    if language in ("javascript", "rust"):
        runner = Module(generated, folder) if language == "javascript" else Crate(generated, folder)
        return runner.run(function, dict(inputs), {}, 0.0)
    (signature,) = (s for s in generated.signatures if s.function == function)
    real = TYPES[signature.scalar]
    given = [np.ascontiguousarray(inputs[array], real) for array, _ in signature.inputs]
    results = [np.empty((len(given[0]), size), real) for _, size in signature.outputs]
    compiler, strict = ("gfortran", STRICT_FORTRAN) if language == "fortran" else ("gcc", STRICT)
    command = (require_tool(compiler), *strict, "-O2", "-ffp-contract=off")
    write(folder, generated.files(("fortran",) if language == "fortran" else ("c",)))
    name, symbol = signature.robot, signature.symbol
    if language == "batch":
        write(folder, batch_files(generated.unit))
        rows = getattr(library(folder, f"{name}_batch.c", *command), f"{symbol}_batch_rows")
        rows.argtypes = [ctypes.c_size_t, *[ctypes.c_void_p] * (len(given) + len(results))]
        rows(len(given[0]), *(a.ctypes.data for a in (*given, *results)))
    else:
        if language == "fortran":
            assert FORTRAN.compiled is not None
            symbol = FORTRAN.compiled.symbol(signature)
        built = library(folder, f"{name}.{'f90' if language == 'fortran' else 'c'}", *command)
        for k in range(len(given[0])):
            called(getattr(built, symbol), *(array[k] for array in (*given, *results)))
    return np.concatenate(results, axis=1)
