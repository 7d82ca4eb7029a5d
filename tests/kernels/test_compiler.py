"""Finding and running compilers: what is missing is named, with how to get it."""

from __future__ import annotations

import shutil
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import ToolError
from robodyn.kernels.kernel import load
from robodyn.toolchain.compiler import find_c, find_compiler
from robodyn_testing import require_tool


def script(folder: Path, name: str, text: str) -> Path:
    """An executable shell script."""
    path = folder / name
    path.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    path.chmod(path.stat().st_mode | stat.S_IXUSR)
    return path


@pytest.mark.parametrize(
    ("language", "variables", "message"),
    [
        ("c", {"PATH": ""}, r"no C compiler was found.*cc, gcc, clang.*CC is not set.*apt install gcc"),
        ("fortran", {"PATH": ""}, r"no Fortran compiler.*gfortran.*FC is not set.*apt install gfortran"),
        (
            "c",
            {"CC": "/nonexistent/cc -m64"},
            r"no C compiler '/nonexistent/cc' \(CC names it\); install one",
        ),
        ("fortran", {"FC": "f77-of-old"}, r"no Fortran compiler 'f77-of-old' \(FC names it\)"),
        ("c", {"CC": 'gcc "'}, "cannot be read"),
    ],
)
def test_a_compiler_that_is_not_there(
    language: str, variables: dict[str, str], message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("CC", "FC"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    with pytest.raises(ToolError, match=message) as caught:
        find_c() if language == "c" else find_compiler(language)
    assert caught.value.exit_code == 3


def test_empty_cc_is_no_cc(monkeypatch: pytest.MonkeyPatch) -> None:
    require_tool("cc")
    monkeypatch.setenv("CC", " ")
    assert find_c().command == (shutil.which("cc"),)


def test_cc_with_arguments_compiles(toy: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    require_tool("gcc")
    monkeypatch.setenv("CC", "gcc -DUNUSED='a b'")
    arm = toy()
    kernel = load(arm.signatures, arm.files)
    assert kernel.gravity([0.0, 0.0]).tolist() == [0.0, 0.0]


def test_a_compiler_that_does_not_work(tmp_path: Path) -> None:
    broken = script(tmp_path, "cc", "echo no licence >&2; exit 69")
    with pytest.raises(
        ToolError, match=r"does not work; found no licence; expected its version; .* --version"
    ):
        find_c(str(broken))


def test_a_compiler_that_cannot_be_started(tmp_path: Path) -> None:
    broken = tmp_path / "cc"
    broken.write_bytes(b"\x7fELF no program at all")
    broken.chmod(0o755)
    with pytest.raises(ToolError, match="cannot be started"):
        find_c(str(broken))


@pytest.mark.parametrize("until", ["toy.c", "_robodyn_"])
def test_a_compiler_that_writes_nothing(until: str, toy: Callable[..., Any], tmp_path: Path) -> None:
    """As /bin/true: it has a version, is content with everything, and there is no file."""
    gcc = require_tool("gcc")
    idle = script(
        tmp_path, "idle", f'case "$*" in --version) echo idle 1;; *{until}*) ;; *) exec {gcc} "$@";; esac'
    )
    arm = toy()
    with pytest.raises(ToolError, match=rf"compiler {idle} wrote no file at {until}.*expected {until}") as e:
        load(arm.signatures, arm.files, cc=str(idle), mode="abi")
    assert e.value.exit_code == 3
    assert "\n" not in str(e.value)


def test_broken_c_is_reported_with_place_and_reason(toy: Callable[..., Any]) -> None:
    arm = toy()
    arm.files["toy.c"] = arm.files["toy.c"].replace("tau[1] =", "tau[1] = nosuch *", 1)
    with pytest.raises(
        ToolError, match=r"the C compiler failed at toy\.c; found toy\.c:\d+:.*nosuch.*command"
    ) as e:
        load(arm.signatures, arm.files)
    assert "\n" not in str(e.value)


@pytest.mark.parametrize("name", ["robodyn_calls", "Python"])
def test_robots_with_names_of_the_files_and_calls_around_them(toy: Callable[..., Any], name: str) -> None:
    arm = toy(name=name, parameters=True)
    kernel = load(arm.signatures, arm.files)
    assert list(kernel.gravity([0.0, 0.0], params={"inertia": 2.0, "bend": 3.0})) == [0.0, 0.0]


@pytest.mark.parametrize(
    ("files", "options", "message"),
    [
        ({"toy.c": ("void toy_gravity", "void toy_levity")}, {}, "toy_gravity"),
        ({"toy.h": ("double", "float")}, {}, "robodyn-calls"),
        ({}, {"flags": "-std=c99 -fno-such-thing"}, "-fno-such-thing"),
        ({"toy.f90": ("", "subroutine gravity(q)\nreal :: q\nq = = 1\nend subroutine\n")},
         {"language": "fortran"}, r"Fortran compiler failed at toy\.f90; found toy\.f90:\d+.*Error"),
    ],
)  # fmt: skip
def test_what_does_not_compile_is_told(
    files: dict[str, tuple[str, str]], options: dict[str, Any], message: str, toy: Callable[..., Any]
) -> None:
    if "language" in options:
        require_tool("gfortran")
    arm = toy()
    for name, (old, new) in files.items():
        arm.files[name] = arm.files[name].replace(old, new) if old else new
    with pytest.raises(ToolError, match=message):
        load(arm.signatures, arm.files, **options)


def test_fortran_needs_a_fortran_compiler(toy: Callable[..., Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("FC", "/nonexistent/gfortran")
    arm = toy()
    arm.files["toy.f90"] = "end\n"
    with pytest.raises(ToolError, match="Fortran compiler '/nonexistent/gfortran'"):
        load(arm.signatures, arm.files, language="fortran")
