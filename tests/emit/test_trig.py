"""Our own sine and cosine: as accurate as is said, guarded, the same bits everywhere."""

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

from robodyn.emit.trig import DOUBLE, FLOAT, Trigonometric
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn_testing import require_machine, require_tool

SCALARS = ("double", "float")
TYPES: dict[str, type[np.floating[Any]]] = {"double": np.float64, "float": np.float32}
OF = {"double": DOUBLE, "float": FLOAT}
NAME = "stanford_3dof"

Pair = Callable[[Any], tuple[Any, Any]]

_ALL = f"""
#include "{NAME}.c"
void all(long n, const {NAME}_real *x, {NAME}_real *s, {NAME}_real *c);
void all(long n, const {NAME}_real *x, {NAME}_real *s, {NAME}_real *c)
{{
    for (long i = 0; i < n; ++i) {NAME}_sincos_(x[i], &s[i], &c[i]);
}}
"""


def made(scalar: str) -> Generated:
    options = Options(trig="builtin", scalar=scalar, functions=("gravity",))  # type: ignore[arg-type]
    return generate(load(NAME, warn=lambda _: None), options)


def compiled(folder: Path, scalar: str, *flags: str, cc: str = "gcc") -> Pair:
    """The function of x [n] that gives sines and cosines [n], compiled with ``flags``."""
    for name, text in made(scalar).files(("c",)).items():
        (folder / name).write_text(text, encoding="ascii")
    (folder / "all.c").write_text(_ALL, encoding="ascii")
    library = folder / f"all{abs(hash((scalar, flags, cc)))}.so"
    command = [require_tool(cc), "-std=c99", *flags, "-shared", "-fPIC", "all.c", "-o", library.name]
    subprocess.run(command, cwd=folder, check=True)
    function = ctypes.CDLL(str(library)).all

    def pair(x: Any) -> tuple[Any, Any]:
        x = np.ascontiguousarray(x, TYPES[scalar])
        s, c = np.empty_like(x), np.empty_like(x)
        function(ctypes.c_long(x.size), *(a.ctypes.data_as(ctypes.c_void_p) for a in (x, s, c)))
        return s, c

    return pair


@pytest.fixture(scope="module", params=SCALARS)
def case(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Pair]:
    return request.param, compiled(tmp_path_factory.mktemp("trig"), request.param, "-O2")


def errors(found: Any, exact: list[Any]) -> Any:
    """Errors in units in the last place of the exact values."""
    unit = np.spacing(np.abs(np.array([float(x) for x in exact], found.dtype))).astype(float)
    return np.array([abs(float(mpmath.mpf(float(f)) - x)) for f, x in zip(found, exact, strict=True)]) / unit


# --- the constants ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("of", [DOUBLE, FLOAT])
def test_the_pieces_add_up_to_a_quarter_turn(of: Trigonometric) -> None:
    digits = 53 if of.bits == 64 else 24
    with mpmath.workprec(300):
        pieces = sum(mpmath.mpf(x) for x in (of.first, of.second, of.third))
        assert abs(pieces - mpmath.pi / 2) < abs(of.third) * mpmath.mpf(2) ** -digits
        assert of.per_quarter == float(TYPES["double" if digits == 53 else "float"](2 / mpmath.pi))

    def length(x: float) -> int:
        return Fraction(abs(x)).numerator.bit_length()

    largest = Fraction(2) ** (1024 if digits == 53 else 128) / Fraction(of.over)  # of k
    assert of.limit < largest * Fraction(math.pi / 2) < of.limit + 3
    assert length(of.first) + int(largest).bit_length() - 1 <= digits  # k*first is exact
    within = int(of.exact / (math.pi / 2))
    assert length(of.second) + within.bit_length() <= digits  # so is k*second


# --- accuracy ---------------------------------------------------------------------------------------------


def test_errors_stay_below_a_unit_in_the_last_place(case: tuple[str, Pair]) -> None:
    scalar, pair = case
    of, random = OF[scalar], np.random.default_rng(7)
    x = np.concatenate(
        [
            random.uniform(-4, 4, 4000),
            random.uniform(0.7, 0.9, 4000),
            random.uniform(-of.exact, of.exact, 4000),
            10.0 ** random.uniform(-40 if scalar == "float" else -320, 0, 500),
        ]
    ).astype(TYPES[scalar])
    with mpmath.workprec(120):
        exact = [mpmath.mpf(float(v)) for v in x]
        for found, function in zip(pair(x), (mpmath.sin, mpmath.cos), strict=True):
            assert errors(found, [function(v) for v in exact]).max() < (0.94 if scalar == "float" else 0.95)


def test_they_do_near_multiples_of_a_quarter_turn(case: tuple[str, Pair]) -> None:
    scalar, pair = case
    of = OF[scalar]
    last = int(of.exact / (math.pi / 2))
    with mpmath.workprec(300):
        # 29 quarter turns come nearest to a double, 3 to a float; then all, or evenly spread ones.
        several = sorted({*range(1, min(last, 500)), *range(1, last, max(1, last // 2000)), 29, 3, last})
        near = np.array([float(k * mpmath.pi / 2) for k in several]).astype(TYPES[scalar])
        x = np.concatenate([near, np.nextafter(near, 0), np.nextafter(near, np.inf), -near])
        x = x[np.abs(x) < of.exact]
        exact = [mpmath.mpf(float(v)) for v in x]
        for found, function in zip(pair(x), (mpmath.sin, mpmath.cos), strict=True):
            assert errors(found, [function(v) for v in exact]).max() < 0.95


def test_errors_beyond_the_exact_range_of_floats(tmp_path: Path) -> None:
    x = np.random.default_rng(3).uniform(FLOAT.exact, FLOAT.limit, 200_000).astype(np.float32)
    for found, exact in zip(
        compiled(tmp_path, "float", "-O2")(x), (np.sin(x.astype(float)), np.cos(x.astype(float))), strict=True
    ):
        assert np.abs(found - exact).max() < 5.7e-8


# --- the ends of the range --------------------------------------------------------------------------------


def test_zero_keeps_its_sign_and_tiny_angles_are_their_sines(case: tuple[str, Pair]) -> None:
    scalar, pair = case
    info = np.finfo(TYPES[scalar])
    x = np.array([0.0, -0.0, info.smallest_subnormal, -info.smallest_subnormal, info.tiny, -info.tiny])
    s, c = pair(x)
    assert np.array_equal(s, x.astype(s.dtype))
    assert np.array_equal(np.signbit(s), np.signbit(x))
    assert (c == 1).all()


def test_huge_angles_give_nan_and_none_within_the_range_does(case: tuple[str, Pair]) -> None:
    scalar, pair = case
    of, info = OF[scalar], np.finfo(TYPES[scalar])
    beyond = of.limit + 2
    huge = np.array(
        [beyond, 2 * beyond, 1e7, 1e15, 2.0**31, 2.0**52, 2.0**63, 1e30, info.max, np.inf, np.nan]
    )
    for x in (huge, -huge):
        assert all(np.isnan(found).all() for found in pair(x))
    within = np.linspace(-of.limit, of.limit, 100_001)
    for found in pair(within):
        assert (np.abs(found) <= 1).all()


# --- bits -------------------------------------------------------------------------------------------------

_FLAGS = [("-O0",), ("-O3", "-ffp-contract=off"), ("-O2", "-march=x86-64-v3"), ("-O2", "-march=x86-64-v4")]


@pytest.mark.parametrize("cc", ["gcc", "clang"])
@pytest.mark.parametrize("flags", _FLAGS, ids=" ".join)
def test_bits_do_not_depend_on_the_compiler(
    flags: tuple[str, ...], cc: str, case: tuple[str, Pair], tmp_path: Path
) -> None:
    if "-march=x86-64-v4" in flags:
        require_machine("avx512vl" in Path("/proc/cpuinfo").read_text(), "a processor with AVX-512")
    scalar, pair = case
    x = np.random.default_rng(1).uniform(-OF[scalar].limit, OF[scalar].limit, 20_001)
    for one, other in zip(pair(x), compiled(tmp_path, scalar, *flags, cc=cc)(x), strict=True):
        assert one.tobytes() == other.tobytes()


def test_fused_products_stay_as_accurate(tmp_path: Path) -> None:
    require_machine(" fma " in Path("/proc/cpuinfo").read_text(), "a processor that fuses products and sums")
    pair = compiled(tmp_path, "double", "-O2", "-march=x86-64-v3", "-ffp-contract=fast")
    x = np.random.default_rng(2).uniform(-DOUBLE.exact, DOUBLE.exact, 5000)
    with mpmath.workprec(120):
        for found, function in zip(pair(x), (mpmath.sin, mpmath.cos), strict=True):
            assert errors(found, [function(mpmath.mpf(float(v))) for v in x]).max() < 1


@pytest.mark.parametrize("scalar", SCALARS)
def test_arithmetic_that_is_not_as_written_is_refused(scalar: str, tmp_path: Path) -> None:
    for name, text in made(scalar).files(("c",)).items():
        (tmp_path / name).write_text(text, encoding="ascii")
    command = [require_tool("gcc"), "-ffast-math", "-c", f"{NAME}.c"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "no -ffast-math" in done.stderr


@pytest.mark.parametrize(("method", "refused"), [(0, False), (16, False), (1, True), (2, True), (-1, True)])
def test_arithmetic_in_a_wider_type_is_refused(method: int, refused: bool, tmp_path: Path) -> None:
    """16 is what gcc says with -march=native on processors that compute in half precision."""
    for name, text in made("double").files(("c",)).items():
        (tmp_path / name).write_text(text, encoding="ascii")
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
    text = generate(robot, Options((function,), trig="builtin")).files(("c",))[f"{robot}.c"]
    ((size, listed),) = re.findall(r"angles\[(\d+)\] = \{(.*?)\};", text, flags=re.DOTALL)
    angles = [angle.strip() for angle in listed.split(",")]
    assert (int(size), len(angles)) == (wanted, wanted)
    assert all(re.fullmatch(r"q\[\d\]|[a-z]\w*", angle) for angle in angles)


@pytest.mark.parametrize("scalar", SCALARS)
def test_objects_need_no_library(scalar: str, tmp_path: Path) -> None:
    files = made(scalar).files()
    for name, text in files.items():
        (tmp_path / name).write_text(text, encoding="ascii")
    nm = require_tool("nm")
    for compiler, file in (("gcc", f"{NAME}.c"), ("gfortran", f"{NAME}.f90")):
        subprocess.run([require_tool(compiler), "-O2", "-c", file, "-o", "x.o"], cwd=tmp_path, check=True)
        listed = subprocess.run([nm, "-u", "x.o"], cwd=tmp_path, check=True, capture_output=True, text=True)
        assert listed.stdout == ""


# --- all floats -------------------------------------------------------------------------------------------

_EVERY = f"""
#include "{NAME}.c"
#include <math.h>
#include <stdio.h>
#include <string.h>
static double unit(double v)
{{
    int e;
    (void)frexp(fabs(v) < 1.2e-38 ? 1.2e-38 : v, &e);
    return ldexp(1.0, e - 24);
}}
int main(void)
{{
    double one = 0.0, beyond = 0.0;
    unsigned long wrong = 0;
    for (unsigned long u = 0; u < 0x100000000ul; ++u) {{
        const unsigned bits = (unsigned)u;
        float x, s, c;
        memcpy(&x, &bits, sizeof x);
        {NAME}_sincos_(x, &s, &c);
        if (fabsf(x) < {FLOAT.limit}f) {{
            const double es = fabs((double)s - sin((double)x)), ec = fabs((double)c - cos((double)x));
            if (fabsf(x) < {FLOAT.exact}f) {{
                one = fmax(one, fmax(es/unit(sin((double)x)), ec/unit(cos((double)x))));
            }} else {{
                beyond = fmax(beyond, fmax(es, ec));
            }}
            wrong += isnan(s) || isnan(c);
        }} else if (!(fabsf(x) < {FLOAT.limit + 1}f)) {{
            wrong += !isnan(s) || !isnan(c);
        }}
    }}
    printf("%.17g %.17g %lu\\n", one, beyond, wrong);
    return 0;
}}
"""


@pytest.mark.slow
def test_every_float(tmp_path: Path) -> None:
    for name, text in made("float").files(("c",)).items():
        (tmp_path / name).write_text(text, encoding="ascii")
    (tmp_path / "every.c").write_text(_EVERY, encoding="ascii")
    command = [require_tool("gcc"), "-std=c99", "-O2", "every.c", "-o", "every", "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    said = subprocess.run([tmp_path / "every"], check=True, capture_output=True, text=True).stdout
    one, beyond, wrong = said.split()
    assert float(one) < 0.94
    assert float(beyond) < 5.7e-8
    assert int(wrong) == 0
