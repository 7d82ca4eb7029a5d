"""Names of robots: what is emitted does not collide with what else is there, whatever the robot is called."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from emit.names import (
    CLEAN,
    INCLUDED,
    STANDARD,
    WAYS,
    arm,
    complaints,
    including,
    usable,
    words,
    written,
)
from robodyn.errors import InputError
from robodyn.robot.names import robot_name_fault
from robodyn_testing import require_tool, sampled

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


@pytest.mark.parametrize("way", WAYS)
def test_no_robot_has_files_that_are_there_already(way: str) -> None:
    files = [file.lower() for file in WAYS[way](arm(NAME))]
    own = {file.rpartition(".")[2] for file in files if file.startswith(NAME)}
    others = [file for file in files if not file.startswith(NAME)]
    assert len(set(files)) == len(files), "where capitals do not count"
    assert [f for f in others if f.rpartition(".")[2] in own and f.partition(".")[0].isidentifier()] == []


#: Names of files, functions, macros, variables and targets of ours and of the tools that build them.
ROBOTS = ("main", "startup", "Semihosting", "test", "found", "gravity", "LANES", "every", "robodyn_batch",
          "Python", "INFINITY", "M_PI", "linux")  # fmt: skip


@pytest.mark.parametrize("name", sampled(ROBOTS, every=7))
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


def test_robots_that_a_program_made_are_looked_at_too() -> None:
    """A description was looked at when it was read."""
    from robodyn import Options, generate

    for name in ("two words", "math", "x" * 41, "double"):
        made = generate(replace(arm(), name=name), Options(("gravity",), optimize="none"))
        with pytest.raises(InputError, match="the robot's name"):
            made.files()


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
