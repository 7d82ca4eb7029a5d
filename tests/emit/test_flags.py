"""Our own sine, cosine and arctangent under the flags of other people's builds: as accurate as is said, or
refused by the compiler with a reason."""

from __future__ import annotations

import ctypes
import math
import subprocess
from pathlib import Path
from typing import Any, Final

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.angles import FUNCTION, NAME, SCALARS, TYPES, of_program
from emit.kernels import write
from robodyn.effects.scalars import arctangent, cosine, sine
from robodyn.emit.batch import batch_files
from robodyn.emit.trig import ARCTANGENT_ULPS, DOUBLE, FLOAT
from robodyn.ir import Graph, Program
from robodyn.ir.lowering import lower
from robodyn_testing import representative, require_machine, require_tool

OF: Final = {"double": DOUBLE, "float": FLOAT}
#: What the errors stay below [ulp], sine, cosine, arctangent.
BOUNDS: Final = np.array([1, 1, ARCTANGENT_ULPS])

FLAGS: Final = (
    "",
    "-ffast-math",
    "-Ofast",
    "-funsafe-math-optimizations",
    "-fassociative-math -fno-signed-zeros -fno-trapping-math",
    "-freciprocal-math",
    "-ffinite-math-only",
    "-fno-signed-zeros",
    "-fno-trapping-math",
    "-mfma -ffp-contract=fast",
    "-mfma -ffp-contract=off",
)

_ALL: Final = f"""
#include "{NAME}.c"
#include <stddef.h>
void all(size_t n, const {NAME}_real *q, {NAME}_real *tau);
void all(size_t n, const {NAME}_real *q, {NAME}_real *tau)
{{
    for (size_t i = 0; i < n; ++i) {FUNCTION}(&q[3 * i], &tau[3 * i]);
}}
"""


def program() -> Program:
    """``sin q[0]``, ``cos q[1]``, ``atan2(q[2], q[0])``."""
    graph = Graph()
    q = [graph.input("q", i) for i in range(3)]
    return lower(graph, [("tau", [sine(q[0]), cosine(q[1]), arctangent(q[2], q[0])])])


def states(scalar: str) -> NDArray[Any]:
    """Angles of all sizes up to the end of the range, in numbers that fill no vector."""
    random, of = np.random.default_rng(5), OF[scalar]
    q = np.concatenate(
        [random.uniform(-size, size, (2001, 3)) for size in (1e-5, 1, 4, 100, of.exact)]
        + [random.uniform(1, 1.1, (500, 3)) * [1, 1, x] for x in (0.4636, 0.125, 0.25)]
    )
    return q.astype(TYPES[scalar])


def errors(tau: NDArray[Any], q: NDArray[Any]) -> NDArray[np.float64]:
    """The largest error of each result [ulp]."""
    require_machine(np.finfo(np.longdouble).nmant >= 60, "extended precision in numpy")
    wide = q.astype(np.longdouble)
    exact = np.stack([np.sin(wide[:, 0]), np.cos(wide[:, 1]), np.arctan2(wide[:, 2], wide[:, 0])], axis=1)
    unit = np.spacing(np.abs(exact).astype(tau.dtype))
    largest: NDArray[np.float64] = (np.abs(tau - exact) / unit).max(axis=0).astype(float)
    return largest


def evaluated(function: Any, q: NDArray[Any]) -> NDArray[Any]:
    tau = np.empty_like(q)
    function(ctypes.c_size_t(len(q)), *(a.ctypes.data_as(ctypes.c_void_p) for a in (q, tau)))
    return tau


def check(function: Any, scalar: str, signed_zeros: bool) -> None:
    """Errors below what is said, signs of zeros unless the flags take them away, NaN where it is said."""
    q = states(scalar)
    assert (errors(evaluated(function, q), q) < BOUNDS).all()
    zeros = np.array([[-0.0, 0, -0.0], [0.0, 0, -0.0]], TYPES[scalar])
    tau = evaluated(function, zeros)
    if signed_zeros:
        assert np.array_equal(np.signbit(tau), [[True, False, True], [False, False, True]])
    assert np.array_equal(tau == 0, [[True, False, False], [True, False, True]])
    huge = 2 * OF[scalar].limit
    for x in (huge, -huge, 1e30, np.inf, -np.inf, np.nan):
        assert np.isnan(evaluated(function, np.full((3, 3), x, TYPES[scalar]))[:, :2]).all(), x
    assert np.isnan(evaluated(function, np.full((3, 3), np.nan, TYPES[scalar]))).all()


def build(folder: Path, file: str, cc: str, *flags: str) -> ctypes.CDLL | str:
    """The library of a ``file``, or what the compiler says of it."""
    if "-mfma" in flags:
        require_machine(" fma " in Path("/proc/cpuinfo").read_text(), "a processor that fuses")
    command = [require_tool(cc), *flags, "-c", "-fPIC", file, "-o", f"{file}.o"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        return done.stderr
    # Linked without the flags: with some of them, a library that is loaded flushes subnormal numbers to 0 in
    # the process from then on (crtfastmath.o), in these tests and in all that run after them.
    subprocess.run([cc, "-shared", f"{file}.o", "-o", f"{file}.so", "-lm"], cwd=folder, check=True)
    assert math.ulp(0.0) > 0
    built = ctypes.CDLL(str(folder / f"{file}.so"))
    assert math.ulp(0.0) > 0, "subnormal numbers are 0 from here on"
    return built


COMPILERS: Final = ("gcc", "clang")
QUICK: Final = [
    ("double", cc, "-O2", flags) for cc in COMPILERS for flags in ("-funsafe-math-optimizations", FLAGS[4])
]
LEVELS: Final = ("-O0", "-O2", "-O3", "-Os")
#: In CI all flags with each compiler, types and levels in turn.
IN_CI: Final = [
    (SCALARS[(k + c) % 2], cc, LEVELS[(k // 2 + c) % 4], flags)
    for k, flags in enumerate(FLAGS)
    for c, cc in enumerate(COMPILERS)
]


@pytest.mark.parametrize(
    ("scalar", "cc", "level", "flags"),
    representative([*QUICK, *IN_CI], *QUICK),
)
def test_c_is_right_under_all_flags_or_refuses(
    scalar: str, cc: str, level: str, flags: str, tmp_path: Path
) -> None:
    generated = of_program(program(), scalar)
    write(tmp_path, generated.files(("c",)))
    write(tmp_path, batch_files(generated.unit))
    (tmp_path / "all.c").write_text(_ALL, encoding="ascii")
    for file, symbol in (("all.c", "all"), (f"{NAME}_batch.c", f"{FUNCTION}_batch_rows")):
        built = build(tmp_path, file, cc, level, *flags.split())
        if isinstance(built, str):
            assert "math" in flags or flags == "-Ofast", built
            assert "#error" in built
            assert "are for a" in built
            continue
        unsigned = {"-fno-signed-zeros", "-funsafe-math-optimizations"} & {*flags.split()}
        check(getattr(built, symbol), scalar, not unsigned)
