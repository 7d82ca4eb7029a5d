"""Tests in C that go with kernels of inverse kinematics: poses, results of 40 digits, bounds of rounding."""

from __future__ import annotations

from pathlib import Path

import pytest

from firmware.folders import run, write
from robodyn.firmware.language_tests import language_tests
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn_testing import require_tool

pytestmark = pytest.mark.thorough

FLAGS = ("-std=c99", "-O1", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", "-ffp-contract=off")


@pytest.mark.parametrize("scalar", ["double", "float"])
@pytest.mark.parametrize("trig", ["libm", "builtin"])
def test_the_kernel_is_within_its_bounds_and_another_is_not(tmp_path: Path, scalar: str, trig: str) -> None:
    options = Options(("inverse_kinematics", "nearest_inverse_kinematics"), scalar=scalar, trig=trig)  # type: ignore[arg-type]
    generated = generate(load("ur5"), options)
    files = {**generated.files(("c",)), **language_tests(generated, ("c",), packaged=True)}
    kernel = files["ur5.c"]
    assert kernel.count("solutions[5] = ") == 1
    wrong = kernel.replace("solutions[5] = ", "solutions[5] = 2 * ")
    for place, source in (("right", kernel), ("wrong", wrong)):
        (tmp_path / place).mkdir()
        folder = write(tmp_path / place, {**files, "ur5.c": source})
        sources = sorted(name for name in files if name.endswith(".c"))
        code, said = run([require_tool("cc"), *FLAGS, *sources, "-lm", "-o", "test"], folder)
        assert code == 0, said
        code, said = run(["./test"], folder)
        assert code == (place == "wrong"), said
