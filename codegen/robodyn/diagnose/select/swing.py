"""The loop of ``c/swing.c``, compiled when it is first used: a link on its spring."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files as resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.toolchain.cache import Cache, content_key
from robodyn.toolchain.compiler import C_FLAGS, find_c

Floats = NDArray[np.float64]

_PROTOTYPE = """
size_t swing(const double *load, const double *mass, const double *rub, const double *stiff, size_t count,
             double step, const double *force, size_t places, double low, double width, double damping,
             double x, double v, double *out);
"""


@lru_cache(maxsize=1)
def _library() -> tuple[Any, Any]:
    """cffi and the compiled loop.

    Raises
    ------
    ToolError: no C compiler.
    """
    import cffi

    text = resources("robodyn.diagnose.select").joinpath("c/swing.c").read_text(encoding="utf-8")
    compiler = find_c(None)

    def build(folder: Path) -> str:
        (folder / "swing.c").write_text(text, encoding="utf-8", newline="\n")
        library = compiler.compile("swing.c", flags=C_FLAGS, folder=folder)
        compiler.link([library], "swing.so", flags=C_FLAGS, folder=folder, extension=False)
        return "swing.so"

    key = content_key(["swing", text, compiler.command, compiler.identity, *C_FLAGS])
    ffi = cffi.FFI()
    ffi.cdef(_PROTOTYPE)
    return ffi, ffi.dlopen(str(Cache().fetch(key, build)))


def swung(
    inputs: tuple[Floats, Floats, Floats, Floats],
    step: float,
    spring: tuple[Floats, float, float],
    damping: float,
    begin: tuple[float, float],
) -> Floats:
    """Place, rate and acceleration [K, 3] of a link on its spring; ``inputs`` [K]: load, and what it changes
    by over acceleration, velocity and place; ``spring``: forces at even places, the first place, their
    distance; ``begin``: place and rate at first. Not finite (nan) from where it flies off.

    Raises
    ------
    ToolError: no C compiler.
    """
    ffi, library = _library()
    arrays = [np.ascontiguousarray(x, np.float64) for x in (*inputs, spring[0])]
    states = np.empty((len(arrays[0]), 3))
    view = [ffi.from_buffer("double[]", x) for x in arrays]
    rows = library.swing(
        *view[:4], len(states), step, view[4], len(arrays[4]), spring[1], spring[2], damping, *begin,
        ffi.from_buffer("double[]", states),
    )  # fmt: skip
    states[rows:] = np.nan
    return states
