"""The loop of ``c/oscillator.c``, compiled when it is first used: a link on its spring."""

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
size_t oscillator(const double *load, const double *mass, const double *rub, const double *stiff,
                  size_t count, double step, const double *force, size_t places, double low, double width,
                  double damping, double x, double v, double *out);
"""


@lru_cache(maxsize=1)
def _library() -> tuple[Any, Any]:
    """cffi and the compiled loop.

    Raises
    ------
    ToolError: no C compiler.
    """
    import cffi

    text = resources("robodyn.identify").joinpath("c/oscillator.c").read_text(encoding="utf-8")
    compiler = find_c(None)

    def build(folder: Path) -> str:
        (folder / "oscillator.c").write_text(text, encoding="utf-8", newline="\n")
        library = compiler.compile("oscillator.c", flags=C_FLAGS, folder=folder)
        compiler.link([library], "oscillator.so", flags=C_FLAGS, folder=folder, extension=False)
        return "oscillator.so"

    key = content_key(["oscillator", text, compiler.command, compiler.identity, *C_FLAGS])
    ffi = cffi.FFI()
    ffi.cdef(_PROTOTYPE)
    return ffi, ffi.dlopen(str(Cache().fetch(key, build)))


def oscillation(
    inputs: tuple[Floats, Floats, Floats, Floats],
    step: float,
    spring: tuple[Floats, float, float],
    damping: float,
    begin: tuple[float, float],
) -> Floats:
    """Place, rate and acceleration [K, 3] of a link on its spring; ``inputs`` [K]: load, and its
    derivatives by acceleration, velocity and place; ``spring``: forces at even places, the first place, their
    distance; ``begin``: place and rate at first. Not finite (nan) from where it diverges.

    Raises
    ------
    ToolError: no C compiler.
    """
    ffi, library = _library()
    arrays = [np.ascontiguousarray(x, np.float64) for x in (*inputs, spring[0])]
    states = np.empty((len(arrays[0]), 3))
    view = [ffi.from_buffer("double[]", x) for x in arrays]
    rows = library.oscillator(
        *view[:4], len(states), step, view[4], len(arrays[4]), spring[1], spring[2], damping, *begin,
        ffi.from_buffer("double[]", states),
    )  # fmt: skip
    states[rows:] = np.nan
    return states
