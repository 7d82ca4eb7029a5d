"""Compilers have nothing to say about the emitted files, and find nothing missing but sine and cosine."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from emit.kernels import (
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
from robodyn.kernels.generate import Options, generate
from robodyn.robot import bundled_names
from robodyn_testing import covering, representative, require_tool

GENERATED = Path(__file__).parents[2] / "generated"
#: A choice for what every robot need not be tried in.
SOME = (*ODD, "puma560", "stanford", *RANDOM[3:7])
LINKED = (
    "stanford_3dof", "puma560_3dof", "ur5", "smooth", "tool", "ghosts", "lift", "tilted", "rubbing",
    "effects_sliding", "effects_remembering",
)  # fmt: skip
#: Of these robots the committed kernels are compiled.
COMMITTED = set(bundled_names()) - {*SOME, *LINKED}


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Folders with the files of robots in ``double``, of some in float (``single``), of some that read
    ``given`` sines or have their own (``builtin``: the committed ones too); every other of these in float."""
    folders = {kind: tmp_path_factory.mktemp(kind) for kind in ("double", "single", "given", "builtin")}
    for name in robots():
        if name in COMMITTED:
            shutil.copytree(GENERATED / name, folders["builtin"], dirs_exist_ok=True)
        else:
            write(folders["double"], made(name).files())
    for k, name in enumerate(SOME):
        fits = name != "huge_and_tiny"
        if fits:
            write(folders["single"], in_single(made(name)).files())
        for kind in ("given", "builtin"):
            generated = made(name, kind)
            if generated.unit.sc or kind == "builtin":
                write(folders[kind], (in_single(generated) if k % 2 and fits else generated).files())
    return folders


_IN_C = ("-x", "c", *STRICT, "-O0")
#: There ``y1`` and ``linux`` mean something.
_DIALECT = ("-x", "c", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Werror", "-fsyntax-only")
THOROUGH, SLOW = pytest.mark.thorough, pytest.mark.slow


@pytest.mark.parametrize(
    ("tool", "flags", "kinds"),
    [
        ("gcc", _IN_C, "double builtin"),
        ("clang++", (*STRICT_CPP, "-fsyntax-only"), "single"),
        ("gcc", (*_DIALECT, "-std=gnu17"), "double"),
        ("gfortran", (*STRICT_FORTRAN, "-fsyntax-only"), "double builtin"),
        pytest.param("gcc", _IN_C, "single given", marks=THOROUGH),
        pytest.param("clang", _IN_C, "double single given builtin", marks=SLOW),
        pytest.param("clang", (*_DIALECT, "-std=gnu99"), "double", marks=THOROUGH),
        pytest.param("g++", (*STRICT_CPP, "-O0"), "double single builtin", marks=SLOW),
        pytest.param("gcc", (*STRICT, "-O2"), "double", marks=SLOW),
        pytest.param("gfortran", (*STRICT_FORTRAN, "-O2"), "double", marks=SLOW),
        pytest.param("gfortran", (*STRICT_FORTRAN, "-fsyntax-only"), "single given", marks=THOROUGH),
    ],
)
def test_compilers_are_content(
    tool: str, flags: tuple[str, ...], kinds: str, folders: dict[str, Path]
) -> None:
    """Without optimisation, all robots are in one program: no two kernels get in each other's way."""
    for folder in map(folders.__getitem__, kinds.split()):
        names = sorted(path.name for path in folder.glob("*.f90" if tool == "gfortran" else "*.c"))
        if "-O2" in flags:
            names = [name for name in names if Path(name).stem in SOME]
        assert names
        if "-x" in flags:
            names = [together(names, folder, f"together_{tool}.h")]
        assert complaints(require_tool(tool), flags, names, folder) == ""


@pytest.mark.parametrize("name", ["lift", "ghost"])
def test_given_sines_where_none_are_needed(name: str, tmp_path: Path) -> None:
    """An array of no elements is none in C."""
    generated = made(name, "given")
    assert generated.unit.sc == ()
    write(tmp_path, generated.files())
    assert complaints(require_tool("gcc"), STRICT, [f"{name}.c"], tmp_path) == ""
    assert complaints(require_tool("gfortran"), STRICT_FORTRAN, [f"{name}.f90"], tmp_path) == ""


@pytest.mark.parametrize(
    ("options", "compiler", "flags"),
    covering(
        [{"trig": "builtin"}, {"contraction": "off"}],
        representative(["gcc", "clang"], "gcc"),
        ["-mfma", "-march=x86-64-v4"],
    ),
)
def test_no_instruction_fuses_products_and_sums(
    options: dict[str, str], compiler: str, flags: str, tmp_path: Path
) -> None:
    """On processors that this machine does not have, too."""
    generated = generate(robots()["puma560_3dof"], Options(optimize="none", **options))  # type: ignore[arg-type]
    write(tmp_path, generated.files(("c",), batch=True))
    for file in ("puma560_3dof.c", "puma560_3dof_batch.c"):
        command = [require_tool(compiler), "-O3", "-ffp-contract=off", flags, "-S", file, "-o", "-"]
        done = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True)
        assert "vmul" in done.stdout
        assert "vfm" not in done.stdout
        assert "vfnm" not in done.stdout


# --- what is left for the linker --------------------------------------------------------------------------


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


def apart(found: set[str]) -> set[str]:
    """``found`` with sine and cosine for the call into which gcc joins them where the library has it."""
    joined = found & {"sincos", "sincosf"}
    tails = {name.removeprefix("sincos") for name in joined}
    return (found - joined) | {name + tail for name in ("sin", "cos") for tail in tails}


@pytest.mark.parametrize(
    ("compiler", "level"),
    covering(
        representative(["gcc", "clang"], "gcc"),
        representative(["-O0", "-O1", "-O2", "-Os", "-O3"], "-O2", rest="slow"),
    ),
)
def test_nothing_is_missing_but_sine_and_cosine(
    compiler: str, level: str, folders: dict[str, Path], tmp_path: Path
) -> None:
    """At no level of optimisation."""
    tool = require_tool(compiler)
    for kind in ("double", "single"):
        folder = folders[kind]
        names = [
            name for name in LINKED if (folder / f"{name}.c").exists() and (level == "-O2" or name != "ur5")
        ]
        files = [str(folder / f"{name}.c") for name in names]
        assert complaints(tool, ("-std=c99", level), files, tmp_path) == ""
        for name in names:
            assert apart(undefined(tmp_path / f"{name}.o")) == expected(name, kind == "single"), name


def test_gcc_joins_sine_and_cosine_of_an_angle_where_the_library_can(
    folders: dict[str, Path], tmp_path: Path
) -> None:
    """With glibc, in one call of the same bits (``test_bits.py``); with newlib two calls stay."""
    file, flags = folders["double"] / "stanford_3dof.c", ("-std=c99", "-O2")
    for compiler, found in (("gcc", {"sincos"}), ("arm-none-eabi-gcc", {"sin", "cos"})):
        assert complaints(require_tool(compiler), flags, [str(file)], tmp_path) == ""
        calls = {name for name in undefined(tmp_path / "stanford_3dof.o") if not name.startswith("__aeabi_")}
        assert calls == found


def test_nothing_but_code_is_in_the_objects(folders: dict[str, Path], tmp_path: Path) -> None:
    """No globals: the symbols are the functions, and no section holds data that can be written."""
    names = [str(folders["double"] / f"{name}.c") for name in LINKED]
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


def test_c_and_fortran_of_one_robot_stand_in_one_program(folders: dict[str, Path], tmp_path: Path) -> None:
    """From C++, too."""
    main = """
#include "puma560.h"
extern "C" void puma560_gravity_f(const double *, double *);
int main() {
    double q[6] = {}, a[6], b[6];
    puma560_gravity(q, a);
    puma560_gravity_f(q, b);
    for (int i = 0; i < 6; ++i)
        if (a[i] != b[i]) return 1;
    return a[1] == 0.0;
}
"""
    double = folders["double"]
    write(tmp_path, {"main.cpp": main})
    for tool, flags, file in (
        ("gcc", ("-std=c99", "-O2", "-ffp-contract=off"), str(double / "puma560.c")),
        ("gfortran", ("-std=f2018", "-O2", "-ffp-contract=off"), str(double / "puma560.f90")),
        ("g++", ("-std=c++17", "-Wall", "-Werror", "-I", str(double)), "main.cpp"),
    ):
        command = [require_tool(tool), *flags, "-c", file, "-o", f"{Path(file).suffix[1:]}.o"]
        subprocess.run(command, cwd=tmp_path, check=True)
    link = [require_tool("g++"), "c.o", "f90.o", "cpp.o", "-lgfortran", "-lm", "-o", "main"]
    subprocess.run(link, cwd=tmp_path, check=True)
    assert subprocess.run([tmp_path / "main"], check=False).returncode == 0
