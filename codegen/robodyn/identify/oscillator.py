"""The loops of ``c/oscillator.c``, compiled at first use: a link on its spring, a Dahl contact."""

from __future__ import annotations

from functools import lru_cache
from importlib.resources import files as resources
from pathlib import Path
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.toolchain.cache import Cache, content_key
from robodyn.toolchain.compiler import C_FLAGS, find_c

_PROTOTYPES = """
typedef struct {
    const double *load, *mass, *rub, *stiff;
    double step;
    const double *force;
    size_t places;
    double low, width, damping;
} link_on_spring;
size_t oscillator(const link_on_spring *s, size_t count, double x, double v, double *out);
size_t oscillator_misfit(const link_on_spring *s, size_t count, double x, double v, const double *passed,
                         double *left);
void dahl(const double *q, size_t count, double limit, double *z);
"""


@lru_cache(maxsize=1)
def _library() -> tuple[Any, Any]:
    """cffi and the compiled loops.

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
    ffi.cdef(_PROTOTYPES)
    return ffi, ffi.dlopen(str(Cache().fetch(key, build)))


class Oscillator:
    """A link on its spring, for any beginning.

    ``inputs`` [K]: load, and its derivatives by acceleration, velocity and place; ``spring``: forces at even
    places, the first place, their distance.

    Raises
    ------
    ToolError: no C compiler.
    """

    def __init__(
        self,
        inputs: tuple[Floats, Floats, Floats, Floats],
        step: float,
        spring: tuple[Floats, float, float],
        damping: float,
    ) -> None:
        self._ffi, self._library = _library()
        arrays = [np.ascontiguousarray(x, np.float64) for x in (*inputs, spring[0])]
        self._views = [self._ffi.from_buffer("double[]", x) for x in arrays]
        self.samples = len(arrays[0])
        self._link = self._ffi.new("link_on_spring *")
        link, views = self._link, self._views
        link.load, link.mass, link.rub, link.stiff, link.force = views
        link.step, link.places, link.damping = step, len(arrays[4]), damping
        link.low, link.width = spring[1], spring[2]

    def motion(self, begin: tuple[float, float]) -> Floats:
        """Place, rate and acceleration [K, 3] of a link that begins at a place with a rate. Not finite (nan)
        from where it diverges."""
        states = np.empty((self.samples, 3))
        out = self._ffi.from_buffer("double[]", states)
        states[self._library.oscillator(self._link, self.samples, *begin, out) :] = np.nan
        return states

    def misfit(self, begin: tuple[float, float], passed: Floats) -> Floats:
        """What the spring passes on over the first samples less what was measured to, ``passed`` [L]; not
        finite (nan) from where it diverges."""
        left = np.empty(len(passed))
        measured = self._ffi.from_buffer("double[]", np.ascontiguousarray(passed, np.float64))
        out = self._ffi.from_buffer("double[]", left)
        rows = self._library.oscillator_misfit(self._link, len(left), *begin, measured, out)
        left[rows:] = np.nan
        return left


def dahl_deflection(q: Floats, limit: float) -> Floats:
    """Deflection of a Dahl contact [K] as a share of ``limit``, at which it slides, along positions ``q``;
    exact between samples.

    Raises
    ------
    ToolError: no C compiler.
    """
    ffi, library = _library()
    places, z = np.ascontiguousarray(q, np.float64), np.empty(len(q))
    library.dahl(ffi.from_buffer("double[]", places), len(z), limit, ffi.from_buffer("double[]", z))
    return z
