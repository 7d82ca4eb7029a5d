"""The files of a firmware folder: the same bytes everywhere, clean for compilers, no library; refusals."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from firmware.folders import STRICT, STRICT_FORTRAN, folder, made, run, write
from robodyn.firmware import firmware, firmware_options, measure, targets_named
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn.targets import TARGETS
from robodyn_testing import require_tool

ALL = ("inverse_dynamics", "gravity", "bias", "mass_matrix", "forward_dynamics")
_PRINT = """
import hashlib
from robodyn.firmware import firmware, firmware_options, targets_named
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
made = generate(load("puma560", warn=lambda _: None), firmware_options(Options(), (), scalar="float"))
files = firmware(made, targets_named(())).files
print(hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest())
"""


@pytest.mark.thorough
def test_the_same_bytes_in_another_process() -> None:
    files = folder("puma560", "float").files
    environment = {**os.environ, "PYTHONHASHSEED": "7", "TZ": "Asia/Tokyo", "LC_ALL": "C"}
    said = subprocess.run(
        [sys.executable, "-c", _PRINT], capture_output=True, text=True, check=True, env=environment
    ).stdout
    assert said.strip() == hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest()


def test_the_kernel_is_the_one_that_gen_writes() -> None:
    files = folder("puma560", "double").files
    plain = generate(
        load("puma560", warn=lambda _: None), Options(functions=("inverse_dynamics",), trig="builtin")
    ).files()
    assert {name: files[name] for name in plain} == plain


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "functions", "scalar"), [("puma560", (), "double"), ("tool", ALL, "float")])
def test_compilers_are_content(name: str, functions: tuple[str, ...], scalar: str, tmp_path: Path) -> None:
    write(tmp_path, folder(name, scalar, functions).files)
    selftest = [f"{name}.c", f"{name}_selftest.c"]
    host = [*selftest, f"{name}_selftest_main.c"]
    cross = [*selftest, f"{name}_image.c", f"{name}_startup.c"]
    arm = [require_tool("arm-none-eabi-gcc"), *(TARGETS["cortex-m4f"].flags or ())]
    riscv = [require_tool("riscv64-unknown-elf-gcc"), *(TARGETS["rv32imafc"].flags or ())]
    jobs = [
        ([require_tool("gcc"), *STRICT, "-O2", "-c"], host),
        ([require_tool("clang"), *STRICT, "-O2", "-c"], host),
        ([require_tool("gfortran"), *STRICT_FORTRAN, "-c"], [f"{name}.f90", f"{name}_selftest.f90"]),
        ([*arm, *STRICT, "-O2", "-c"], cross),
        ([*riscv, *STRICT, "-O2", "-ffreestanding", "-c"], cross),
    ]
    for command, sources in jobs:
        assert run([*command, *sources], tmp_path) == (0, "")


def test_nothing_but_the_compilers_own_headers() -> None:
    files = folder("puma560", "float").files
    sources = [name for name in files if name.endswith((".c", ".h")) and not name.endswith("_main.c")]
    assert len(sources) == 7
    found = {header for name in sources for header in re.findall(r"#include <(.*)>", files[name])}
    assert found == {"stdint.h", "float.h"}


def test_without_tools_the_readme_says_what_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    whole = folder("puma560", "float")
    figures = [measure("puma560", whole.files, ["inverse_dynamics"], t) for t in targets_named(())]
    text = whole.readme(figures)
    assert text.count("Not measured: needs arm-none-eabi-gcc (Debian, Ubuntu: apt install") == 3
    assert text.count("Not measured: needs riscv64-unknown-elf-gcc (Debian, Ubuntu: apt install") == 1
    assert all(target.title in text for target in targets_named(()))


def test_a_missing_emulator_is_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for tool in ("arm-none-eabi-gcc", "arm-none-eabi-nm", "arm-none-eabi-size"):
        (tmp_path / tool).symlink_to(require_tool(tool))
    whole = folder("puma560", "float")
    monkeypatch.setenv("PATH", str(tmp_path))
    figures = measure("puma560", whole.files, ["inverse_dynamics"], TARGETS["cortex-m4f"])
    assert figures.not_run == "qemu-system-arm (Debian, Ubuntu: apt install qemu-system-arm)"
    assert figures.sections["text"] > 0
    assert "instructions a call | not measured: needs qemu-system-arm" in whole.readme([figures])


def test_the_type_follows_the_targets() -> None:
    assert firmware_options(Options(), ()).scalar == "float"
    assert firmware_options(Options(), ("cortex-m4f", "cortex-m7")).scalar == "float"
    assert firmware_options(Options(), ("cortex-m7",)).scalar == "double"
    assert firmware_options(Options(), ("cortex-m7",), scalar="float").scalar == "float"
    assert firmware_options(Options(), ()).functions == ("inverse_dynamics",)


def test_without_fortran_there_is_none() -> None:
    files = firmware(made("puma560", "float"), targets_named(()), ("c",)).files
    assert not [name for name in files if name.endswith(".f90")]
    assert "ortran" not in files["CMakeLists.txt"] + files["Makefile"]
