"""Names of run-time parameters and of robots: those that do not compile, or collide with what else is there,
are refused, and those that are accepted do compile."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from emit.names import CLEAN, INCLUDED, STANDARD, WAYS, arm, complaints, including, usable, words, written
from robodyn.errors import InputError
from robodyn.robot import read_text
from robodyn.robot.names import parameter_clash, parameter_name_fault, robot_name_fault
from robodyn_testing import representative, require_tool, sampled

DIALECTS = [
    ("gcc", "-std=c99"),
    ("gcc", "-std=gnu17"),
    ("gcc", "-std=gnu17", "-D_GNU_SOURCE"),  # as NAME_parallel.c is
    ("clang", "-std=c99"),
    ("clang", "-std=gnu17", "-D_GNU_SOURCE"),
    ("g++", "-xc++", "-std=c++17"),
    ("g++", "-xc++", "-std=gnu++20"),
    ("clang++", "-xc++", "-std=gnu++17"),
    ("arm-none-eabi-gcc", "-std=c99", "-mcpu=cortex-m3"),
    ("arm-none-eabi-gcc", "-std=gnu17", "-mcpu=cortex-m4", "-mfloat-abi=hard"),
    ("riscv64-unknown-elf-gcc", "-std=gnu17", "-march=rv32imafc", "-mabi=ilp32f", "-ffreestanding"),
]
#: What may be a name as far as its letters go.
LEGAL = re.compile(r"[A-Za-z]\w{0,30}\Z", re.A)


def macros(folder: Path, dialect: tuple[str, ...], headers: set[str]) -> dict[str, bool]:
    """Every macro that could be a name: whether it is called like a function."""
    tool, *flags = dialect
    headers = usable(headers, folder, require_tool(tool), *flags)
    (folder / "all.c").write_text(including(headers, cpp="-xc++" in flags), encoding="utf-8")
    said = complaints(folder, require_tool(tool), *flags, "-dM", "-E", "all.c")
    found = re.findall(r"^#define (\w+)(\(?)", said, re.M)
    assert len(found) > 100, said
    return {name: called == "(" for name, called in found if LEGAL.match(name)}


@pytest.mark.parametrize("dialect", sampled(map(pytest.param, DIALECTS), every=2), ids="-".join)
def test_macros_are_no_parameters(dialect: tuple[str, ...], tmp_path: Path) -> None:
    """All of the headers that the emitted files include; of the standard's those that stand for themselves
    (a parameter is never followed by a parenthesis)."""
    ours = macros(tmp_path, dialect, INCLUDED)
    others = {name for name, called in macros(tmp_path, dialect, {*STANDARD}).items() if not called}
    assert "DBL_MAX" in ours
    assert sorted(name for name in {*ours, *others} if parameter_name_fault(name) is None) == []


def test_macros_of_frama_c_are_no_parameters(tmp_path: Path) -> None:
    share = complaints(tmp_path, require_tool("frama-c"), "-print-share-path").strip()
    flags = ("-std=c99", "-nostdinc", f"-I{share}/libc", "-D__FC_MACHDEP_X86_64")
    found = macros(tmp_path, ("gcc", *flags), INCLUDED - {"stdatomic"})
    assert "FRAMA_C_PTR" in found
    assert sorted(name for name in found if parameter_name_fault(name) is None) == []


@pytest.mark.parametrize("way", WAYS)
def test_macros_of_our_own_are_no_parameters(way: str) -> None:
    """What our files define, and what they ask for."""
    found: set[str] = set()
    for text in WAYS[way](arm("zq")).values():
        found |= set(re.findall(r"^ *# *(?:define|undef|ifdef|ifndef) (\w+)", text, re.M))
        for line in re.findall(r"^ *# *(?:if|elif) (.*)", text, re.M):
            found |= set(re.findall(r"[A-Za-z_]\w*", line))
        found |= set(re.findall(r"-D([A-Za-z]\w*)=", text))
    assert "ZQ_H" in found
    free = {name for name in found if not (parameter_name_fault(name) or parameter_clash(name, "zq"))}
    assert sorted(name for name in free - {"defined"} if LEGAL.match(name)) == []


#: Of other machines and other libraries, or with a meaning of another kind.
BAD = """
linux unix i386 arm sun mips near far WIN32 errno I NULL M_PI M_PIl M_TWOPI HUGE DOMAIN OVERFLOW E2BIG ENOTSUP
EFTYPE INT8_C NAN INFINITY INT128_MAX DBL_MAX DBL_NORM_MAX FLT16_MAX DEC64_MAX PRIb32 isnan signbit assert
complex bool LANES_BYTES WITH_AVX2 CHUNK stdin offsetof noreturn SIGINT
""".split()  # noqa: SIM905 (they read as the lists that they are)
#: Names that look as if they might collide and do not: functions, types, intrinsic procedures, our own local
#: names, names that only begin like a macro.
GOOD = """
y0 y1 yn j0 j1 jn sin cos tan abs fabs exp pow sqrt tanh log gamma index time signal main malloc printf
size_t int8_t uint32_t double_t float_t div remainder isalpha kernel p q qd qdd tau M_1 state dt sc rk ik
team base again unused1 s_ c_ x s c turns odd half k count stride states vec bits name arguments any seed
digest BATCH JOINTS expected tolerance failed worst MEASURED stack handler values i j e L R T S_1 M1 E1
SIGMA SIGMA_0 MOD_1 m__1 a__b m_ override id self kind len size merge transfer c_double iso_c_binding huge
lanes zq_dynamics zq_gravity zq_inverse_dynamics zq zq_lanes zq_team zq_sincos_ zq_bits_ zq_selftest
zq_processor pi_2 t1 w1_x sines cosines angles x123456789012345678901234567890 ELBOW F_1 LANE nan_1 vector
sc1 lanes_1 chunk
""".split()  # noqa: SIM905


def test_macros_from_elsewhere_are_refused_at_their_place() -> None:
    for name in BAD:
        text = f"name: zq\nlinks:\n  - joint: revolute\n    mass: 2*{name}\n"
        with pytest.raises(InputError, match=r"\Aarm\.yaml:4:13: .*(a macro of|a keyword|nor free to)"):
            read_text(text, "arm.yaml")


@pytest.mark.parametrize("way", representative(WAYS, "schedule"))
def test_names_that_are_accepted_compile(way: str, tmp_path: Path) -> None:
    """With every header of the standard before the emitted ones."""
    files = WAYS[way](arm("zq", GOOD))
    assert all(f" {name};" in files["zq.h"] for name in GOOD)
    elsewhere = ("_image.c", "_startup.c", "_eva.c")  # for another processor, for another C library
    sources = [name for name in written(tmp_path, files) if not name.endswith(elsewhere)]
    for name, cpp in (("before.h", False), ("before.hpp", True)):
        (tmp_path / name).write_text(including(STANDARD, cpp=cpp), encoding="utf-8")
    standard = "-std=c11" if way == "schedule" else "-std=c99"
    for tool, *flags in (
        ("gcc", standard),
        ("gcc", "-std=gnu17", "-D_GNU_SOURCE", "-include", "before.h"),
        ("clang", standard),
        ("clang", "-std=gnu17", "-D_GNU_SOURCE", "-include", "before.h"),
        ("g++", "-x", "c++", "-std=c++17", "-include", "before.hpp"),
        ("clang++", "-x", "c++", "-std=gnu++20", "-include", "before.hpp"),
    ):
        if "++" not in tool:
            assert complaints(tmp_path, require_tool(tool), *flags, *CLEAN, *sources) == ""
        elif way != "schedule":  # C11's atomics are not C++, nor are Python's calls
            some = [name for name in sources if not name.startswith("robodyn-")]
            warnings = [flag for flag in CLEAN if flag != "-Wshadow"]
            assert complaints(tmp_path, require_tool(tool), *flags, *warnings, *some) == ""
    modules = [name for name in files if name.endswith(".f90")]
    if modules:
        flags = ["-std=f2018", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
        assert complaints(tmp_path, require_tool("gfortran"), *flags, *modules) == ""


def test_names_in_robots_that_a_program_made_are_looked_at_too() -> None:
    """Those in a description were looked at when it was read."""
    from robodyn import Options, generate
    from robodyn.robot.values import parameter

    robot = arm()
    for name in ("two words", "math", "x" * 41, "double"):
        made = generate(replace(robot, name=name), Options(("gravity",), optimize="none"))
        with pytest.raises(InputError, match="the robot's name"):
            made.files()
    for name in ("M_PI", "arm_real", "ARM_H", "two words", "double"):
        links = (replace(robot.links[0], mass=parameter(name)), *robot.links[1:])
        made = generate(replace(robot, links=links), Options(("inverse_dynamics",), optimize="none"))
        with pytest.raises(InputError, match="the run-time parameter"):
            made.files()


# --- names of robots ----------------------------------------------------------------------

NAME = "zq"


def stems(way: str) -> Iterator[tuple[str, str]]:
    """Words in what ``way`` emits for the robot ``zq`` that are not its own but would be another robot's: the
    word, and that robot's name."""
    for fortran in (False, True):
        files = {f: text for f, text in WAYS[way](arm(NAME)).items() if f.endswith(".f90") == fortran}
        found = {word.lower() for file, text in files.items() for word in words(file, text)}
        own = {word.removeprefix(f"{NAME}_") for word in found if word.startswith(f"{NAME}_")} - {""}
        for word in sorted(word for word in found if not word.startswith(f"{NAME}_")):
            for k in [k for k, c in enumerate(word) if c == "_"]:
                if word[k + 1 :] in own and robot_name_fault(word[:k]) is None:
                    yield word, word[:k]


@pytest.mark.parametrize("way", WAYS)
def test_no_robot_has_names_that_the_files_have_for_something_else(way: str) -> None:
    """For every robot at once: a name of ours that begins otherwise must not go on as a robot's do."""
    assert list(stems(way)) == []


#: Names of files, functions, macros, variables and targets of ours and of the tools that build them.
ROBOTS = ("main", "startup", "Semihosting", "test", "found", "gravity", "LANES", "every", "robodyn_batch",
          "Python", "INFINITY", "M_PI", "linux")  # fmt: skip


@pytest.mark.parametrize("name", sampled(ROBOTS, every=7, rest="slow"))
def test_robots_of_any_name_compile(name: str, tmp_path: Path) -> None:
    for way, standard in (("kernels", "-std=c99"), ("firmware", "-std=gnu17"), ("schedule", "-std=gnu17")):
        files = WAYS[way](arm(name))
        sources = written(tmp_path / way, files)
        if way == "firmware":  # the rest is for another processor
            sources = [f"{name}.c", f"{name}_selftest.c", f"{name}_selftest_main.c"]
        assert complaints(tmp_path / way, require_tool("gcc"), standard, *CLEAN, *sources) == ""
        modules = [file for file in files if file.endswith(".f90")]
        if modules:
            flags = ("-std=f2018", "-Wall", "-Wextra", "-Werror", "-fsyntax-only")
            assert complaints(tmp_path / way, require_tool("gfortran"), *flags, *modules) == ""


@pytest.mark.parametrize(
    "command",
    [
        ("gcc", "-xc", "-D_GNU_SOURCE"),
        ("clang", "-xc", "-D_GNU_SOURCE"),
        ("g++", "-xc++"),
        ("arm-none-eabi-gcc", "-xc"),
        ("riscv64-unknown-elf-gcc", "-xc", "--specs=picolibc.specs"),
    ],
    ids="-".join,
)
def test_headers_of_the_system_are_no_robots(command: tuple[str, ...], tmp_path: Path) -> None:
    """With -I and the folder of the emitted files, <features.h> of the C library would be a robot's."""
    compiler = (require_tool(command[0]), *command[1:])
    text = including(usable({*INCLUDED, *STANDARD}, tmp_path, *compiler), cpp="-xc++" in command)
    (tmp_path / "all.c").write_text(text, encoding="utf-8")
    said = complaints(tmp_path, *compiler, "-v", "-E", "all.c")
    folders = {Path(folder).resolve() for folder in re.findall(r"^ (/\S+)$", said, re.M)}
    paths = {Path(file).resolve() for file in re.findall(r'^# \d+ "(/[^"]+)"', said, re.M)}
    found = {path.stem for path in paths if path.parent in folders and path.suffix == ".h"}
    assert {"stddef", "stdint"} <= found
    assert sorted(name for name in found if name[0].isalpha() and robot_name_fault(name) is None) == []
