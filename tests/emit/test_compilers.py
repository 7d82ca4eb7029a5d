"""Compilers have nothing to say about the emitted files, and find nothing missing but sine and cosine."""

from __future__ import annotations

import re
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from emit.kernels import (
    EFFECTS,
    ODD,
    RANDOM,
    STRICT,
    STRICT_CPP,
    STRICT_FORTRAN,
    complaints,
    in_single,
    made,
    robots,
    together,
    write,
)
from robodyn_testing import covering, representative, require_tool

#: A choice for what every robot need not be tried in.
SOME = (*ODD, "puma560", "stanford", *RANDOM[3:7])


@pytest.fixture(scope="module")
def double(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files of every robot, in double."""
    folder = tmp_path_factory.mktemp("double")
    for name in robots():
        write(folder, made(name).files())
    return folder


@pytest.fixture(scope="module")
def single(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files of some robots, in float."""
    folder = tmp_path_factory.mktemp("single")
    for name in SOME:
        if name != "huge_and_tiny":
            write(folder, in_single(made(name)).files())
    return folder


@pytest.fixture(scope="module")
def given(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the files of some robots, reading given sines; every other one in float."""
    folder = tmp_path_factory.mktemp("given")
    for k, name in enumerate(SOME):
        generated = made(name, "given")
        if not generated.unit.sc:
            continue
        write(folder, (in_single(generated) if k % 2 and name != "huge_and_tiny" else generated).files())
    return folder


def sources(folder: Path, suffix: str, names: tuple[str, ...] | None = None) -> list[str]:
    found = sorted(path.name for path in folder.glob(f"*{suffix}"))
    return [name for name in found if names is None or Path(name).stem in names]


def check(tool: str, flags: tuple[str, ...], names: list[str], folder: Path) -> None:
    assert names
    assert complaints(require_tool(tool), flags, names, folder) == ""


def check_together(tool: str, flags: tuple[str, ...], names: list[str], folder: Path) -> None:
    check(tool, flags, [together(names, folder, f"together_{tool}.h")], folder)


@pytest.mark.thorough
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_c_is_clean(compiler: str, double: Path) -> None:
    check(compiler, (*STRICT, "-O2"), sources(double, ".c"), double)


@pytest.mark.parametrize("compiler", representative(["gcc", "clang"], "gcc"))
def test_c_is_clean_without_optimisation(compiler: str, double: Path) -> None:
    """Here, too, all robots in one program: no two kernels get in each other's way."""
    check_together(compiler, ("-x", "c", *STRICT, "-O0"), sources(double, ".c"), double)


@pytest.mark.thorough
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_c_is_clean_in_float_and_with_given_sines(compiler: str, single: Path, given: Path) -> None:
    for folder in (single, given):
        check_together(compiler, ("-x", "c", *STRICT, "-O0"), sources(folder, ".c"), folder)


@pytest.mark.parametrize("dialect", representative(["-std=gnu99", "-std=gnu17"], "-std=gnu99"))
def test_c_is_clean_in_the_dialects_of_others(dialect: str, double: Path) -> None:
    """There ``y1`` and ``linux`` mean something."""
    flags = ("-x", "c", dialect, "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-fsyntax-only")
    for compiler in ("gcc", "clang"):
        check_together(compiler, flags, sources(double, ".c"), double)


@pytest.mark.parametrize("compiler", representative(["g++", "clang++"], "clang++"))
def test_c_is_clean_as_cpp(compiler: str, double: Path, single: Path) -> None:
    for folder in (double, single):
        check_together(compiler, (*STRICT_CPP, "-O0"), sources(folder, ".c"), folder)


def test_fortran_is_clean(double: Path) -> None:
    check("gfortran", STRICT_FORTRAN, sources(double, ".f90"), double)


@pytest.mark.thorough
def test_fortran_is_clean_optimised_in_float_and_with_given_sines(
    double: Path, single: Path, given: Path
) -> None:
    check("gfortran", (*STRICT_FORTRAN, "-O2"), sources(double, ".f90", SOME), double)
    for folder in (single, given):
        check("gfortran", (*STRICT_FORTRAN, "-fsyntax-only"), sources(folder, ".f90"), folder)


def test_a_complaint_is_a_complaint(tmp_path: Path) -> None:
    """Each of the flags that matter would speak up."""
    wrong = {
        "conversion": "float f(double x); float f(double x) { return x; }",
        "shadow": "double f(double x); double f(double x) { { double x = 1.0; (void)x; } return x; }",
        "promotion": "float f(float x); float f(float x) { return (float)(x * 2.0); }",
        "unused": "void f(const double q[2]); void f(const double q[2]) { }",
        "variable": "double f(void); double f(void) { double x = 1.0; return 2.0; }",
        "pedantic": "double f(double x); double f(double x) { return 0b1 * x; }",
    }
    for name, text in wrong.items():
        write(tmp_path, {f"{name}.c": text + "\n"})
        for compiler in ("gcc", "clang"):
            assert "error" in complaints(require_tool(compiler), STRICT, [f"{name}.c"], tmp_path), name
    write(tmp_path, {"unused.f90": "subroutine f(x)\n  real :: x, y\nend subroutine\n"})
    assert "rror" in complaints(require_tool("gfortran"), STRICT_FORTRAN, ["unused.f90"], tmp_path)


@pytest.mark.parametrize("name", ["lift", "ghost"])
def test_given_sines_where_none_are_needed(name: str, tmp_path: Path) -> None:
    """An array of no elements is none in C."""
    generated = made(name, "given")
    assert generated.unit.sc == ()
    write(tmp_path, generated.files())
    check("gcc", STRICT, [f"{name}.c"], tmp_path)
    check("gfortran", STRICT_FORTRAN, [f"{name}.f90"], tmp_path)


# --- what is left for the linker --------------------------------------------------------------------------

LINKED = (
    "stanford_3dof", "puma560_3dof", "ur5", "smooth", "tool", "ghosts", "lift", "tilted", "rubbing",
    "effects_sliding", "effects_remembering",
)  # fmt: skip


def undefined(object_file: Path) -> set[str]:
    done = subprocess.run(
        [require_tool("nm"), "-u", object_file.name],
        cwd=object_file.parent,
        capture_output=True,
        text=True,
        check=True,
    )
    return set(re.findall(r"\bU (\w+)", done.stdout))


def expected(name: str, float_: bool) -> set[str]:
    ops = {op.op for _, program in made(name).unit.functions for op in program.operations}
    return {f + "f" * float_ for f in ops & {"sin", "cos", "tanh", "sqrt", "exp", "pow"}}


@pytest.mark.parametrize(
    ("compiler", "level"),
    covering(
        representative(["gcc", "clang"], "gcc"), representative(["-O0", "-O1", "-O2", "-Os", "-O3"], "-O2")
    ),
)
def test_nothing_is_missing_but_sine_and_cosine(
    compiler: str, level: str, double: Path, single: Path, tmp_path: Path
) -> None:
    """At no level of optimisation: not sincos either, which not every libm has."""
    tool = require_tool(compiler)
    for folder in (double, single):
        names = [
            name for name in LINKED if (folder / f"{name}.c").exists() and (level == "-O2" or name != "ur5")
        ]
        files = [str(folder / f"{name}.c") for name in names]
        assert complaints(tool, ("-std=c99", level), files, tmp_path) == ""
        for name in names:
            assert undefined(tmp_path / f"{name}.o") == expected(name, folder == single), name


def test_smooth_friction_alone_asks_for_tanh() -> None:
    assert expected("smooth", False) == {"sin", "cos", "tanh"}
    assert expected("rubbing", False) == set()
    assert all(
        expected(name, False) <= {"sin", "cos"}
        for name in robots()
        if robots()[name].rest_velocity is None and name not in EFFECTS
    )


@pytest.mark.thorough
def test_given_sines_need_no_library_at_all(given: Path, tmp_path: Path) -> None:
    files = [str(given / f"{name}.c") for name in ("puma560", "stanford", "tool")]
    assert complaints(require_tool("gcc"), ("-std=c99", "-O2"), files, tmp_path) == ""
    for file in files:
        assert undefined(tmp_path / Path(file).with_suffix(".o").name) == set()


def test_nothing_but_code_is_in_the_objects(double: Path, tmp_path: Path) -> None:
    """No globals: the symbols are the functions, and no section holds data that can be written."""
    names = [str(double / f"{name}.c") for name in LINKED]
    assert complaints(require_tool("gcc"), ("-std=c99", "-O2"), names, tmp_path) == ""
    for name in LINKED:
        done = subprocess.run(
            [require_tool("nm"), "--defined-only", f"{name}.o"],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=True,
        )
        symbols = {(line.split()[1], line.split()[2]) for line in done.stdout.splitlines()}
        assert {kind for kind, _ in symbols} <= {"T", "r"}
        assert {text for kind, text in symbols if kind == "T"} == {s.symbol for s in made(name).signatures}


def test_c_and_fortran_of_one_robot_stand_in_one_program(double: Path, tmp_path: Path) -> None:
    """And two robots, in float and double, beside them; from C++, too."""
    gcc, gfortran = require_tool("gcc"), require_tool("gfortran")
    other = made("stanford_3dof")
    named = replace(robots()["stanford_3dof"], name="other")
    functions = tuple((replace(s, robot="other"), p) for s, p in other.unit.functions)
    write(
        tmp_path,
        in_single(replace(other, unit=replace(other.unit, robot=named, functions=functions))).files(("c",)),
    )
    write(
        tmp_path,
        {
            "main.cpp": """
#include "puma560.h"
#include "other.h"
extern "C" void puma560_gravity_f(const double *, double *);
int main() {
    double q[6] = {}, a[6], b[6];
    float s[3] = {}, t[3];
    puma560_gravity(q, a);
    puma560_gravity_f(q, b);
    other_gravity(s, t);
    for (int i = 0; i < 6; ++i)
        if (a[i] != b[i]) return 1;
    return a[1] == 0.0 || t[2] == 0.0f;
}
"""
        },
    )
    for tool, flags, file in (
        (gcc, ("-std=c99", "-O2", "-ffp-contract=off"), str(double / "puma560.c")),
        (gcc, ("-std=c99", "-O2"), "other.c"),
        (gfortran, ("-std=f2018", "-O2", "-ffp-contract=off"), str(double / "puma560.f90")),
        (require_tool("g++"), ("-std=c++17", "-Wall", "-Werror", "-I", str(double)), "main.cpp"),
    ):
        target = f"{Path(file).suffix[1:]}_{Path(file).stem}.o"
        done = subprocess.run(
            [tool, *flags, "-c", file, "-o", target],
            cwd=tmp_path,
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == 0, done.stderr
    objects = [path.name for path in tmp_path.glob("*.o")]
    assert len(objects) == 4
    subprocess.run(
        [require_tool("g++"), *objects, "-lgfortran", "-lm", "-o", "main"],
        cwd=tmp_path,
        check=True,
        capture_output=True,
    )
    assert subprocess.run([tmp_path / "main"], check=False).returncode == 0
