"""Our own arctangent: as accurate as is said, the same bits everywhere; choices in every language."""

from __future__ import annotations

import ctypes
import dataclasses
import math
import subprocess
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

from emit.angles import FUNCTION, NAME, SCALARS, TYPES, of_program, program
from emit.crates import Crate
from emit.kernels import STRICT, STRICT_FORTRAN, write
from emit.modules import Module
from robodyn.effects.scalars import arctangent, choose, magnitude
from robodyn.emit.batch import batch_files
from robodyn.emit.trig import ARCTANGENT_ULPS, DOUBLE, FLOAT, WIDE, Trigonometric
from robodyn.firmware.digest import kernel_sine, outputs
from robodyn.ir import Graph, Input
from robodyn.ir.evaluate import evaluate
from robodyn.ir.lowering import lower
from robodyn.passes.arctangents import arctangents_together
from robodyn_testing import require_machine, require_tool

Angle = Callable[[Any, Any], Any]


def library(folder: Path, sources: list[str], *command: str) -> ctypes.CDLL:
    shared = f"{sources[0]}.so"
    subprocess.run([*command, "-shared", "-fPIC", *sources, "-o", shared, "-lm"], cwd=folder, check=True)
    return ctypes.CDLL(str(folder / shared))


_PLAIN = ("-O2", "-ffp-contract=off")

_ALL = f"""
#include "{NAME}.c"
void all(long n, const {NAME}_real *y, const {NAME}_real *x, {NAME}_real *angle);
void all(long n, const {NAME}_real *y, const {NAME}_real *x, {NAME}_real *angle)
{{
    for (long i = 0; i < n; ++i) angle[i] = {NAME}_atan2_(y[i], x[i]);
}}
"""


def compiled(folder: Path, scalar: str, *flags: str, cc: str = "gcc") -> Angle:
    """The function of y and x [n] that gives angles [n], compiled with ``flags``."""
    write(folder, of_program(program(), scalar).files(("c",)))
    (folder / "all.c").write_text(_ALL, encoding="ascii")
    function = library(folder, ["all.c"], require_tool(cc), "-std=c99", *flags).all

    def angle(y: Any, x: Any) -> Any:
        y, x = (np.ascontiguousarray(each, TYPES[scalar]) for each in np.broadcast_arrays(y, x))
        angles = np.empty_like(y)
        function(ctypes.c_long(y.size), *(a.ctypes.data_as(ctypes.c_void_p) for a in (y, x, angles)))
        return angles

    return angle


@pytest.fixture(scope="module", params=SCALARS)
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Angle]:
    return request.param, compiled(tmp_path_factory.mktemp("atan2"), request.param, "-O2")


def points(scalar: str, count: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Points all around, near the axes, where errors are largest, and of all sizes."""
    random = np.random.default_rng(9)
    angles = [random.uniform(-math.pi, math.pi, count)]
    for low, high in ((0.4636, 0.5), (0.124, 0.1257), (0.249, 0.256)):
        angles.append(random.uniform(low, high, count))
    angles += [k * math.pi / 4 + 1e-3 * random.uniform(-1, 1, count) for k in range(-4, 5)]
    angle = np.concatenate(angles)
    size = 10.0 ** random.uniform(-30, 30, angle.size)
    return tuple(  # type: ignore[return-value]
        (size * f(angle)).astype(TYPES[scalar]) for f in (np.sin, np.cos)
    )


# --- the constants ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("of", [DOUBLE, FLOAT])
def test_two_pieces_of_a_quarter_turn_and_a_polynomial(of: Trigonometric) -> None:
    digits = 53 if of.bits == 64 else 24
    real: Any = np.float64 if digits == 53 else np.float32
    with mpmath.workprec(200):
        rest = mpmath.pi / 2 - mpmath.mpf(of.quarter[0]) - mpmath.mpf(of.quarter[1])
        assert abs(rest) < abs(of.quarter[1]) * mpmath.mpf(2) ** -digits
        for k in range(401):
            t = mpmath.mpf(k or 1) / 400 * mpmath.mpf(WIDE)
            p = sum((-1) ** i * mpmath.mpf(c) * t ** (2 * i) for i, c in enumerate(of.arctangent))
            assert abs((t - t**3 * p) / mpmath.atan(t) - 1) < (8.92e-18 if digits == 53 else 3.1e-9)
    # Halves of it are added: products with k = 0, 1/2 ... 2 are exact.
    assert Fraction(of.quarter[0]).numerator.bit_length() + 2 <= digits
    assert all(float(real(c)) == c for c in (*of.quarter, *of.arctangent))


# --- accuracy ---------------------------------------------------------------------------------------------


def ulps(angles: Any, y: Any, x: Any) -> Any:
    """Errors in units in the last place of the exact values."""
    require_machine(np.finfo(np.longdouble).nmant >= 60, "extended precision in numpy")
    exact = np.arctan2(y.astype(np.longdouble), x.astype(np.longdouble))
    _, exponent = np.frexp(exact)
    unit = np.ldexp(1.0, exponent - np.finfo(angles.dtype).nmant - 1)
    return np.abs(angles - exact) / unit


def test_errors_stay_below_what_is_said(case: tuple[str, Angle]) -> None:
    scalar, angle = case
    y, x = points(scalar, 20_000)
    errors = ulps(angle(y, x), y, x)
    assert errors.max() < ARCTANGENT_ULPS
    assert errors.max() > 0.5
    assert errors[np.abs(np.arctan2(y, x)) > 0.5].max() < 1.05


@pytest.mark.slow
def test_every_float(tmp_path: Path) -> None:
    angle = compiled(tmp_path, "float", "-O3", "-march=native")
    worst = 0.0
    for x in (1.0, -3.0):
        for first in range(0, 0x7F800000, 1 << 22):
            y = np.arange(first, min(first + (1 << 22), 0x7F800000), dtype=np.uint32).view(np.float32)
            exact = np.arctan2(y.astype(float), x)
            unit = np.spacing(np.abs(exact)) * 2.0**29
            own = angle(y, np.float32(x)).astype(float)
            normal = np.abs(exact) > 2.0**-125
            if normal.any():
                worst = max(worst, float((np.abs(own - exact) / unit)[normal].max()))
    assert worst < ARCTANGENT_ULPS


# --- special points ---------------------------------------------------------------------------------------


def test_zeros_and_axes_are_as_in_c(case: tuple[str, Angle]) -> None:
    scalar, angle = case
    info = np.finfo(TYPES[scalar])
    numbers = np.array([0.0, -0.0, 1.0, -1.0, info.tiny, -info.tiny, info.max / 4, -info.max / 4])
    y, x = (a.ravel().astype(TYPES[scalar]) for a in np.meshgrid(numbers, numbers))
    own, expected = angle(y, x), np.arctan2(y.astype(float), x.astype(float)).astype(TYPES[scalar])
    assert np.array_equal(np.signbit(own), np.signbit(expected))
    assert (np.abs(own - expected) <= 2 * np.spacing(np.abs(expected))).all()
    assert angle(0.0, 0.0) == 0


def test_what_is_no_point_gives_nan(case: tuple[str, Angle]) -> None:
    scalar, angle = case
    numbers = np.array([0.0, 1.0, -1.0, np.finfo(TYPES[scalar]).max, np.inf, -np.inf, np.nan, -np.nan])
    y, x = (a.ravel().astype(TYPES[scalar]) for a in np.meshgrid(numbers, numbers))
    with np.errstate(all="ignore"):
        lost = ~np.isfinite(np.abs(x) + np.abs(y))
    assert np.array_equal(np.isnan(angle(y, x)), lost)


# --- bits -------------------------------------------------------------------------------------------------

_FLAGS = [("-O0",), ("-O3", "-ffp-contract=off"), ("-O2", "-march=x86-64-v3"), ("-O2", "-march=x86-64-v4")]


@pytest.mark.thorough
@pytest.mark.parametrize("cc", ["gcc", "clang"])
@pytest.mark.parametrize("flags", _FLAGS, ids=" ".join)
def test_bits_do_not_depend_on_the_compiler(
    flags: tuple[str, ...], cc: str, case: tuple[str, Angle], tmp_path: Path
) -> None:
    if "-march=x86-64-v4" in flags:
        require_machine("avx512vl" in Path("/proc/cpuinfo").read_text(), "a processor with AVX-512")
    scalar, angle = case
    y, x = points(scalar, 500)
    assert angle(y, x).tobytes() == compiled(tmp_path, scalar, *flags, cc=cc)(y, x).tobytes()


def test_loops_become_vector_code(tmp_path: Path) -> None:
    write(tmp_path, of_program(program(), "double").files(("c",)))
    command = [require_tool("gcc"), "-std=c99", "-O3", "-fopt-info-vec-optimized", "-c", f"{NAME}.c"]
    done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert done.stderr.count("loop vectorized") == 2  # of four angles each


def states(scalar: str) -> NDArray[Any]:
    """Random states, and those of which numbers are 0 or on the edge of a choice."""
    random = np.random.default_rng(4)
    edges = np.array(np.meshgrid(*[[0.0, -0.0, 1.0, -1.5]] * 3)).reshape(3, -1).T
    return np.concatenate([random.uniform(-3, 3, (400, 3)), edges]).astype(TYPES[scalar])


def rows(library_: ctypes.CDLL, symbol: str, q: NDArray[Any]) -> NDArray[Any]:
    tau = np.empty_like(q)
    for one, result in zip(q, tau, strict=True):
        getattr(library_, symbol)(*(a.ctypes.data_as(ctypes.c_void_p) for a in (one, result)))
    return tau


@pytest.mark.parametrize("scalar", ["double", pytest.param("float", marks=pytest.mark.thorough)])
def test_every_language_gives_the_bits_of_the_program(scalar: str, tmp_path: Path) -> None:
    """The program in numpy, whose arctangent is written down a second time."""
    generated, q = of_program(program(), scalar), states(scalar)
    ((_, emitted),) = generated.unit.functions
    expected = outputs(emitted, {"q": q}, {}, scalar, kernel_sine(scalar))  # type: ignore[arg-type]
    assert np.isfinite(expected).all()
    c = write(tmp_path, generated.files(("c",)))
    torques = {"c": rows(library(tmp_path, c, require_tool("gcc"), *STRICT, *_PLAIN), FUNCTION, q)}
    fortran = write(tmp_path, generated.files(("fortran",)))
    torques["fortran"] = rows(
        library(tmp_path, fortran, require_tool("gfortran"), *STRICT_FORTRAN, *_PLAIN), f"{FUNCTION}_f", q
    )
    write(tmp_path, batch_files(generated.unit))
    batch = library(tmp_path, [f"{NAME}_batch.c"], require_tool("gcc"), *STRICT, *_PLAIN)
    tau = np.empty_like(q)
    getattr(batch, f"{FUNCTION}_batch_rows")(
        ctypes.c_size_t(len(q)), *(a.ctypes.data_as(ctypes.c_void_p) for a in (q, tau))
    )
    torques["batch"] = tau
    if scalar == "double":
        torques["javascript"] = Module(generated, tmp_path).run("gravity", {"q": q}, {}, 0.0)
    for language, results in torques.items():
        assert results.tobytes() == expected.tobytes(), language


@pytest.mark.thorough
@pytest.mark.parametrize("scalar", SCALARS)
def test_rust_gives_the_bits_of_the_program(scalar: str, tmp_path: Path) -> None:
    """Without the root, which would be the crate libm's."""
    graph = Graph()
    q = [graph.input("q", i) for i in range(3)]
    angles = [arctangent(q[i], q[(i + 1) % 3]) for i in range(3)]
    results = [choose(a, arctangent(a, q[i] - 1), magnitude(a)) for i, a in enumerate(angles)]
    generated, states_ = of_program(lower(graph, [("tau", results)]), scalar), states(scalar)
    ((_, emitted),) = generated.unit.functions
    expected = outputs(emitted, {"q": states_}, {}, scalar, kernel_sine(scalar))  # type: ignore[arg-type]
    assert Crate(generated, tmp_path).run("gravity", {"q": states_}, {}, 0.0).tobytes() == expected.tobytes()


# --- the library's arctangent -----------------------------------------------------------------------------


@pytest.mark.thorough
def test_with_libm_c_and_fortran_give_the_same_bits(tmp_path: Path) -> None:
    generated, q = of_program(program(), "double", "libm"), states("double")
    c = write(tmp_path, generated.files(("c",)))
    one = rows(library(tmp_path, c, require_tool("gcc"), *STRICT, *_PLAIN), FUNCTION, q)
    fortran = write(tmp_path, generated.files(("fortran",)))
    other = rows(
        library(tmp_path, fortran, require_tool("gfortran"), *STRICT_FORTRAN, *_PLAIN), f"{FUNCTION}_f", q
    )
    assert one.tobytes() == other.tobytes()
    inputs = {Input("q", i): q[:, i] for i in range(3)}
    functions = {"sin": np.sin, "sqrt": np.sqrt, "abs": np.abs, "atan2": np.arctan2}
    exact = np.stack(evaluate(program(), inputs, functions=functions)["tau"], axis=1)
    np.testing.assert_allclose(one, exact, rtol=1e-13, atol=1e-14)


def test_a_choice_for_misra_has_its_condition_in_parentheses() -> None:
    generated = of_program(program(), "double")
    unit = dataclasses.replace(generated.unit, misra=True)
    files = dataclasses.replace(generated, unit=unit).files(("c",))
    assert "((q[1] > 0.0) ? 3.0 :" in files[f"{NAME}.c"]


# --- order ------------------------------------------------------------------------------------------------


def test_arctangents_that_do_not_need_each_other_stand_together() -> None:
    joined = arctangents_together(program())
    ops = [op.op for op in joined.operations]
    runs = [len(run) for run in "".join("a" if op == "atan2" else " " for op in ops).split()]
    assert sum(runs) == ops.count("atan2") == [op.op for op in program().operations].count("atan2")
    assert runs == [5, 3, 1]  # two of the five have constant coordinates
    for i, (_, args, _) in enumerate(joined.operations):
        assert all(arg < i for arg in args if isinstance(arg, int))
    q = {Input("q", i): x for i, x in enumerate((0.3, -0.8, 1.7))}
    assert evaluate(joined, q) == evaluate(program(), q)
