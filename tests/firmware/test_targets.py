"""On the processors, in qemu: the digest of x86 and Fortran, and what the kernel costs there."""

from __future__ import annotations

from pathlib import Path

import pytest

from firmware.folders import (
    SCALARS,
    digests,
    folder,
    fortran,
    host,
    require_firmware_tools,
    robot,
    run,
    write,
)  # fmt: skip
from robodyn.errors import CheckError
from robodyn.firmware import Figures, measure, targets_named
from robodyn.verify.exact import exact_torque
from robodyn_testing import representative, require_tool

TARGETS = {target.name: target for target in targets_named(())}

#: Bytes of code and of stack, and instructions a call, that puma560's inverse dynamics may take.
CEILINGS = {
    ("cortex-m4f", "float"): (2600, 320, 800),
    ("cortex-m7", "float"): (2600, 320, 800),
    ("cortex-m7", "double"): (3200, 560, 900),
    ("cortex-m3", "float"): (4000, 400, 22_000),
    ("cortex-m3", "double"): (6500, 700, 35_000),
    ("cortex-m4f", "double"): (6500, 700, 35_000),
    ("rv32imafc", "float"): (3000, 320, 900),
    ("rv32imafc", "double"): (9500, 900, 95_000),
}
#: What the compilers call their own arithmetic.
HELPERS = {"arm": "__aeabi_", "riscv": "__"}


@pytest.fixture(scope="module")
def tools() -> None:
    for target in TARGETS.values():
        require_firmware_tools(target)


def measured(target: str, scalar: str) -> Figures:
    return measure("puma560", folder("puma560", scalar).files, ["inverse_dynamics"], TARGETS[target])


@pytest.mark.parametrize("scalar", representative(SCALARS, "float"))
def test_all_processors_x86_and_fortran_give_the_same_bits(scalar: str, tools: None, tmp_path: Path) -> None:
    write(tmp_path, folder("puma560", scalar).files)
    found = {
        "x86": digests(host(require_tool("gcc"), "puma560", tmp_path)[1])["inverse_dynamics"][0],
        "fortran": digests(fortran(require_tool("gfortran"), "puma560", tmp_path)[1])["inverse_dynamics"][0],
    }
    for target in TARGETS:
        figures = measured(target, scalar)
        (cost,) = figures.costs
        found[target] = cost.digest or 0
        code, stack, instructions = CEILINGS[target, scalar]
        assert figures.sections["text"] + figures.sections["rodata"] <= code
        assert figures.sections["data"] == figures.sections["bss"] == 0
        assert cost.stack is not None
        assert cost.stack_used is not None
        assert cost.stack <= stack
        assert cost.instructions is not None
        assert cost.instructions <= instructions
        if scalar in TARGETS[target].hardware:
            assert figures.undefined == ()
            assert cost.stack - 16 <= cost.stack_used <= cost.stack
        else:
            board = TARGETS[target].board
            assert board is not None
            helper = HELPERS[board.architecture.name]
            assert all(name.startswith(helper) for name in figures.undefined)
            assert figures.undefined
    assert len(set(found.values())) == 1, found


@pytest.mark.parametrize(
    ("target", "wrong", "said"),
    [
        ("cortex-m4f", "tau[0] = 1.0f + ", r"self-test of puma560 fails on cortex-m4f in qemu.*failed 3"),
        ("rv32imafc", "*(volatile int *)0xF0000000 = 0;\n    tau[0] = ", "found fault"),
    ],
)
def test_a_processor_that_fails_is_an_error(target: str, wrong: str, said: str, tools: None) -> None:
    files = folder("puma560", "float").files
    source = files["puma560.c"].replace("tau[0] = ", wrong, 1)
    with pytest.raises(CheckError, match=said):
        measure("puma560", {**files, "puma560.c": source}, ["inverse_dynamics"], TARGETS[target])


@pytest.mark.parametrize("target", representative(TARGETS, "cortex-m3", rest="slow"))
def test_make_runs_the_image(target: str, tools: None, tmp_path: Path) -> None:
    write(tmp_path, folder("puma560", "float").files)
    code, said = run([require_tool("make"), "run", "size", f"TARGET={target}"], tmp_path)
    assert code == 0, said
    assert "puma560 float self-test passed" in said
    assert "warning" not in said
    code, said = run(["make", "run", "TARGET=avr"], tmp_path)
    assert code != 0
    assert f"expected {', '.join(TARGETS)}" in said


@pytest.mark.parametrize("target", [pytest.param("cortex-m4f", marks=pytest.mark.thorough), "rv32imafc"])
def test_cmake_builds_the_image_and_runs_it(target: str, tools: None, tmp_path: Path) -> None:
    write(tmp_path, folder("puma560", "float").files)
    cmake = require_tool("cmake")
    board = TARGETS[target].board
    assert board is not None
    toolchain = f"{board.architecture.toolchain}.cmake"
    configure = [cmake, "-B", "b", "--toolchain", toolchain, f"-DTARGET={target}"]
    assert run(configure, tmp_path)[0] == 0
    code, said = run([cmake, "--build", "b", "--target", "run"], tmp_path)
    assert code == 0, said
    assert "puma560 float self-test passed" in said


def test_a_larger_project_takes_the_library_alone(tmp_path: Path) -> None:
    still = exact_torque(robot("puma560"), [0] * 6, [0] * 6, [0] * 6)[1]
    assert abs(still) > 1
    (tmp_path / "arm").mkdir()
    write(tmp_path / "arm", folder("puma560", "double").files)
    (tmp_path / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.16)\nproject(all C)\nadd_subdirectory(arm)\n"
        "add_executable(whole main.c)\ntarget_link_libraries(whole PRIVATE puma560_dynamics)\n",
        encoding="utf-8",
    )
    (tmp_path / "main.c").write_text(
        '#include "puma560.h"\nint main(void)\n{\n    double q[6] = {0}, tau[6];\n'
        "    puma560_inverse_dynamics(q, q, q, tau);\n"
        f"    const double off = tau[1] - ({float(still)!r});\n    return off*off > 1e-20;\n}}\n",
        encoding="utf-8",
    )
    said = ""
    for command in ([require_tool("cmake"), "-B", "b"], ["cmake", "--build", "b"]):
        code, said = run(command, tmp_path)
        assert code == 0, said
    assert "selftest" not in said
    assert run([str(tmp_path / "b" / "whole")], tmp_path)[0] == 0
