"""Our own sine, cosine and arctangent: as accurate as is said, guarded, the same bits everywhere."""

from __future__ import annotations

import ctypes
import math
import re
import subprocess
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from emit.angles import NAME, SCALARS, TYPES, of_program, program
from emit.kernels import write
from robodyn.emit.trig import ARCTANGENT_ULPS, DOUBLE, FLOAT, WIDE, Trigonometric
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import covering, representative, require_machine, require_tool

OF = {"double": DOUBLE, "float": FLOAT}
#: Sines and cosines of x [n], and angles of the points (x, y).
Compiled = Callable[[Any, Any], tuple[Any, Any, Any]]

_ALL = f"""
#include "{NAME}.c"
typedef {NAME}_real real;
void all(long n, const real *y, const real *x, real *s, real *c, real *angle);
void all(long n, const real *y, const real *x, real *s, real *c, real *angle)
{{
    for (long i = 0; i < n; ++i) {{
        {NAME}_sincos_(x[i], &s[i], &c[i]);
        angle[i] = {NAME}_atan2_(y[i], x[i]);
    }}
}}
"""


def compiled(folder: Path, scalar: str, *flags: str, cc: str = "gcc") -> Compiled:
    """The functions, compiled with ``flags``."""
    write(folder, of_program(program(), scalar).files(("c",)))
    (folder / "all.c").write_text(_ALL, encoding="ascii")
    library = f"all{abs(hash((scalar, flags, cc)))}.so"
    command = [require_tool(cc), "-std=c99", *flags, "-shared", "-fPIC", "all.c", "-o", library]
    subprocess.run(command, cwd=folder, check=True)
    function = ctypes.CDLL(str(folder / library)).all

    def each(y: Any, x: Any) -> tuple[Any, Any, Any]:
        y, x = (np.ascontiguousarray(array, TYPES[scalar]) for array in np.broadcast_arrays(y, x))
        s, c, angle = (np.empty_like(x) for _ in range(3))
        function(ctypes.c_long(x.size), *(a.ctypes.data_as(ctypes.c_void_p) for a in (y, x, s, c, angle)))
        return s, c, angle

    return each


@pytest.fixture(scope="module", params=SCALARS)
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Compiled]:
    return request.param, compiled(tmp_path_factory.mktemp("trig"), request.param, "-O2")


def errors(found: Any, exact: list[Any]) -> Any:
    """Errors in units in the last place of the exact values."""
    unit = np.spacing(np.abs(np.array([float(x) for x in exact], found.dtype))).astype(float)
    return np.array([abs(float(mpmath.mpf(float(f)) - x)) for f, x in zip(found, exact, strict=True)]) / unit


def points(scalar: str, count: int) -> tuple[Any, Any]:
    """Points all around, near the axes, where errors are largest, and of all sizes."""
    random = np.random.default_rng(9)
    angles = [random.uniform(-math.pi, math.pi, count)]
    for low, high in ((0.4636, 0.5), (0.124, 0.1257), (0.249, 0.256)):
        angles.append(random.uniform(low, high, count))
    angles += [k * math.pi / 4 + 1e-3 * random.uniform(-1, 1, count) for k in range(-4, 5)]
    angle = np.concatenate(angles)
    size = 10.0 ** random.uniform(-30, 30, angle.size)
    return (size * np.sin(angle)).astype(TYPES[scalar]), (size * np.cos(angle)).astype(TYPES[scalar])


# --- the constants ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("of", [DOUBLE, FLOAT])
def test_pieces_of_a_quarter_turn_and_a_polynomial(of: Trigonometric) -> None:
    digits = 53 if of.bits == 64 else 24
    real: Any = np.float64 if digits == 53 else np.float32

    def length(x: float) -> int:
        return Fraction(abs(x)).numerator.bit_length()

    with mpmath.workprec(300):
        for pieces in ((of.first, of.second, of.third), of.quarter):
            rest = mpmath.pi / 2 - sum(map(mpmath.mpf, pieces))
            assert abs(rest) < abs(pieces[-1]) * mpmath.mpf(2) ** -digits
        assert of.per_quarter == float(real(2 / mpmath.pi))
        for k in range(401):
            t = mpmath.mpf(k or 1) / 400 * mpmath.mpf(WIDE)
            p = sum((-1) ** i * mpmath.mpf(c) * t ** (2 * i) for i, c in enumerate(of.arctangent))
            assert abs((t - t**3 * p) / mpmath.atan(t) - 1) < (8.92e-18 if digits == 53 else 3.1e-9)
    largest = Fraction(2) ** (1024 if digits == 53 else 128) / Fraction(of.over)  # of k
    assert of.limit < largest * Fraction(math.pi / 2) < of.limit + 3
    assert length(of.first) + int(largest).bit_length() - 1 <= digits  # k*first is exact
    assert length(of.second) + int(of.exact / (math.pi / 2)).bit_length() <= digits  # so is k*second
    # Halves of it are added: products with k = 0, 1/2 ... 2 are exact.
    assert length(of.quarter[0]) + 2 <= digits
    assert all(float(real(c)) == c for c in (*of.quarter, *of.arctangent))


# --- accuracy ---------------------------------------------------------------------------------------------


def test_sines_stay_within_a_unit_in_the_last_place(case: tuple[str, Compiled]) -> None:
    """Near multiples of a quarter turn too: 29 come nearest to a double, 3 to a float; then all, or evenly
    spread ones."""
    scalar, each = case
    of, random = OF[scalar], np.random.default_rng(7)
    last = int(of.exact / (math.pi / 2))
    with mpmath.workprec(300):
        several = sorted({*range(1, min(last, 500)), *range(1, last, max(1, last // 2000)), 29, 3, last})
        near = np.array([float(k * mpmath.pi / 2) for k in several]).astype(TYPES[scalar])
        wide = [random.uniform(-size, size, 3000) for size in (4, of.exact)]
        small = 10.0 ** random.uniform(-40 if scalar == "float" else -320, 0, 500)
        x = np.concatenate([near, np.nextafter(near, 0), np.nextafter(near, np.inf), -near, *wide, small])
        x = x.astype(TYPES[scalar])[np.abs(x) < of.exact]
        exact = [mpmath.mpf(float(v)) for v in x]
        for found, function in zip(each(x, x), (mpmath.sin, mpmath.cos), strict=False):
            assert errors(found, [function(v) for v in exact]).max() < 0.95


def test_arctangents_stay_within_what_is_said(case: tuple[str, Compiled]) -> None:
    require_machine(np.finfo(np.longdouble).nmant >= 60, "extended precision in numpy")
    scalar, each = case
    y, x = points(scalar, 20_000)
    angles = each(y, x)[2]
    exact = np.arctan2(y.astype(np.longdouble), x.astype(np.longdouble))
    unit = np.ldexp(1.0, np.frexp(exact)[1] - np.finfo(angles.dtype).nmant - 1)
    ulps = np.abs(angles - exact) / unit
    assert 0.5 < ulps.max() < ARCTANGENT_ULPS
    assert ulps[np.abs(exact) > 0.5].max() < 1.05


# --- the ends of the range --------------------------------------------------------------------------------


def test_tiny_angles_are_their_sines_and_huge_ones_give_nan(case: tuple[str, Compiled]) -> None:
    scalar, each = case
    of, info = OF[scalar], np.finfo(TYPES[scalar])
    x = np.array([0.0, -0.0, info.smallest_subnormal, -info.smallest_subnormal, info.tiny, -info.tiny])
    s, c, _ = each(x, x)
    assert np.array_equal(s, x.astype(s.dtype))
    assert np.array_equal(np.signbit(s), np.signbit(x))
    assert (c == 1).all()
    beyond = of.limit + 2
    huge = np.array(
        [beyond, 2 * beyond, 1e7, 1e15, 2.0**31, 2.0**52, 2.0**63, 1e30, info.max, np.inf, np.nan]
    )
    for x in (huge, -huge):
        assert all(np.isnan(found).all() for found in each(x, x)[:2])
    within = np.linspace(-of.limit, of.limit, 100_001)
    assert all((np.abs(found) <= 1).all() for found in each(within, within)[:2])


def test_angles_of_zeros_and_axes_are_as_in_c_and_those_of_no_point_nan(case: tuple[str, Compiled]) -> None:
    scalar, each = case
    info = np.finfo(TYPES[scalar])
    numbers = np.array([0.0, -0.0, 1.0, -1.0, info.tiny, -info.tiny, info.max / 4, -info.max / 4])
    y, x = (a.ravel().astype(TYPES[scalar]) for a in np.meshgrid(numbers, numbers))
    own, expected = each(y, x)[2], np.arctan2(y.astype(float), x.astype(float)).astype(TYPES[scalar])
    assert np.array_equal(np.signbit(own), np.signbit(expected))
    assert (np.abs(own - expected) <= 2 * np.spacing(np.abs(expected))).all()
    numbers = np.array([0.0, 1.0, -1.0, info.max, np.inf, -np.inf, np.nan, -np.nan])
    y, x = (a.ravel().astype(TYPES[scalar]) for a in np.meshgrid(numbers, numbers))
    with np.errstate(all="ignore"):
        lost = ~np.isfinite(np.abs(x) + np.abs(y))
    assert np.array_equal(np.isnan(each(y, x)[2]), lost)


# --- bits -------------------------------------------------------------------------------------------------

_FLAGS = ["-O0", "-O3 -ffp-contract=off", "-O2 -march=x86-64-v3", "-O2 -march=x86-64-v4"]


@pytest.mark.parametrize(
    ("scalar", "flags", "cc"), covering(SCALARS, representative(_FLAGS, *_FLAGS[1:3]), ["clang", "gcc"])
)
def test_bits_do_not_depend_on_the_compiler(scalar: str, flags: str, cc: str, tmp_path: Path) -> None:
    if "v4" in flags:
        require_machine("avx512vl" in Path("/proc/cpuinfo").read_text(), "a processor with AVX-512")
    x = np.random.default_rng(1).uniform(-OF[scalar].limit, OF[scalar].limit, 20_001)
    plain, other = compiled(tmp_path, scalar, "-O2"), compiled(tmp_path, scalar, *flags.split(), cc=cc)
    for given in (points(scalar, 500), (x, x)):
        for one, two in zip(plain(*given), other(*given), strict=True):
            assert one.tobytes() == two.tobytes()


@pytest.mark.parametrize(("method", "refused"), [(0, False), (16, False), (1, True), (2, True), (-1, True)])
def test_arithmetic_in_a_wider_type_is_refused(method: int, refused: bool, tmp_path: Path) -> None:
    """16 is what gcc says with -march=native on processors that compute in half precision."""
    write(tmp_path, of_program(program(), "double").files(("c",)))
    says = ["-U__FLT_EVAL_METHOD__", f"-D__FLT_EVAL_METHOD__={method}"]
    command = [require_tool("gcc"), "-w", *says, "-fsyntax-only", f"{NAME}.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode != 0) == refused, done.stderr
    assert ("no x87" in done.stderr) == refused


@pytest.mark.parametrize(
    ("robot", "function", "wanted"),
    [("panda", "forward_kinematics", 8), ("stanford", "forward_kinematics", 6), ("puma560", "jacobian", 6)],
)
def test_sines_are_taken_of_an_even_number_of_angles(robot: str, function: str, wanted: int) -> None:
    """And of nothing but angles: constants beside them cost more than the sines."""
    text = generate(load(robot), Options((function,), trig="builtin")).files(("c",))[f"{robot}.c"]
    ((size, listed),) = re.findall(r"angles\[(\d+)\] = \{(.*?)\};", text, flags=re.DOTALL)
    angles = [angle.strip() for angle in listed.split(",")]
    assert (int(size), len(angles)) == (wanted, wanted)
    assert all(re.fullmatch(r"q\[\d\]|[a-z]\w*", angle) for angle in angles)


def test_loops_become_vector_code(tmp_path: Path) -> None:
    write(tmp_path, of_program(program(), "double").files(("c",)))
    command = [require_tool("gcc"), "-std=c99", "-O3", "-fopt-info-vec-optimized", "-c", f"{NAME}.c"]
    done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
    assert done.stderr.count("loop vectorized") == 2  # of four angles each


@pytest.mark.parametrize("scalar", SCALARS)
def test_objects_need_no_library(scalar: str, tmp_path: Path) -> None:
    options = Options(("gravity",), trig="builtin", scalar=scalar)  # type: ignore[arg-type]
    write(tmp_path, generate(load(NAME), options).files())
    for compiler, file in (("gcc", f"{NAME}.c"), ("gfortran", f"{NAME}.f90")):
        subprocess.run([require_tool(compiler), "-O2", "-c", file, "-o", "x.o"], cwd=tmp_path, check=True)
        command = [require_tool("nm"), "-u", "x.o"]
        assert subprocess.run(command, cwd=tmp_path, check=True, capture_output=True).stdout == b""


# --- all floats -------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_every_float(tmp_path: Path) -> None:
    each = compiled(tmp_path, "float", "-O3", "-march=native")
    for first in range(0, 1 << 31, 1 << 22):
        x = np.arange(first, first + (1 << 22), dtype=np.uint32).view(np.float32)
        wide, size = x.astype(float), np.abs(x)
        for place, exact in enumerate((np.sin(wide), np.cos(wide))):
            for sign in (1, -1):
                found = each(x, sign * x)[place] * (1 if place else sign)
                unit = np.spacing(np.maximum(np.abs(exact), 2.0**-126)) * 2.0**29
                near, within = size < FLOAT.exact, size < FLOAT.limit
                assert (np.abs(found - exact) / unit)[near].max(initial=0) < 0.94
                assert np.abs(found - exact)[within].max(initial=0) < 5.7e-8
                assert np.isnan(found[~(size < FLOAT.limit + 1)]).all()
        for across in (1.0, -3.0):
            y = x[np.isfinite(x)]
            exact = np.arctan2(y.astype(float), across)
            normal = np.abs(exact) > 2.0**-125
            ulps = np.abs(each(y, np.float32(across))[2] - exact) / (np.spacing(np.abs(exact)) * 2.0**29)
            assert ulps[normal].max(initial=0) < ARCTANGENT_ULPS
