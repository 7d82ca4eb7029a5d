"""Robots whose names are those of files, targets and variables of a firmware folder's builds."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from emit.names import arm, for_firmware, of_firmware
from firmware.folders import run, write
from robodyn.firmware import firmware, measure, targets_named
from robodyn_testing import require_tool, sampled


@pytest.mark.parametrize(
    "name", sampled(["main", "Startup", "semihosting", "Makefile", "CMakeLists", "readme", "link"], every=7)
)
def test_every_file_is_there_with_what_belongs_into_it(name: str) -> None:
    plain, files = of_firmware(arm("zq")), of_firmware(arm(name))
    assert sorted(files) == sorted(file.replace("zq", name) for file in plain)
    for file, text in plain.items():  # lines may be wrapped elsewhere
        expected = text.replace("zq", name).replace("ZQ", name.upper())
        assert "".join(files[file.replace("zq", name)].split()) == "".join(expected.split())
    assert len({file.lower() for file in [*files, "README.md"]}) == len(files) + 1


@pytest.mark.thorough
def test_images_run(tmp_path: Path) -> None:
    for tool in ("arm-none-eabi-gcc", "arm-none-eabi-nm", "arm-none-eabi-size", "qemu-system-arm"):
        require_tool(tool)
    for name in ("main", "semihosting"):
        whole = firmware(for_firmware(arm(name)), targets_named(("cortex-m4f",)))
        figures = measure(
            name, whole.files, ("inverse_dynamics", "gravity"), targets_named(("cortex-m4f",))[0]
        )
        assert all(cost.digest for cost in figures.costs)


def test_make_does_not_make_its_makefile(tmp_path: Path) -> None:
    """Of a Makefile.c that is younger, by the rule that makes programs of C."""
    require_tool("gfortran")
    write(tmp_path, of_firmware(arm("Makefile")))
    os.utime(tmp_path / "Makefile", (1, 1))
    code, said = run([require_tool("make"), "check", f"CC={require_tool('gcc')}"], tmp_path)
    assert code == 0, said
    assert "-o Makefile" not in said
    assert said.count("self-test passed") + said.count("Fortran kernel passed") == 2


@pytest.mark.parametrize("name", [pytest.param("cmake_c", marks=pytest.mark.thorough), "test"])
def test_cmake_keeps_its_own_variables_and_targets(name: str, tmp_path: Path) -> None:
    """CMAKE_C_FLAGS is a variable of CMake's; ``test``, ``all`` and ``install`` are targets."""
    cmake = require_tool("cmake")
    write(tmp_path, firmware(for_firmware(arm(name)), targets_named(()), ("c",)).files)
    said = ""
    for command in ([cmake, "-B", "b"], [cmake, "--build", "b"], ["ctest", "--test-dir", "b"]):
        code, said = run(command, tmp_path)
        assert code == 0, said
    assert "100% tests passed" in said
