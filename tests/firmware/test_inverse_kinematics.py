"""Inverse kinematics on microcontrollers: what it costs, and the same bits everywhere, at edges too."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from firmware.folders import digests, fortran, host, require_firmware_tools, run, write
from robodyn.dynamics.functions import function_named
from robodyn.firmware import Folder, firmware, firmware_options, measure, targets_named
from robodyn.firmware.digest import kernel_sine, outputs, program_inputs
from robodyn.firmware.language_tests import language_tests
from robodyn.firmware.rounding import rounding_bounds
from robodyn.firmware.vectors import evaluated, missed_poses, well_conditioned
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn.verify.reference import Reference
from robodyn.verify.sample import draw as draw_sample
from robodyn_testing import require_tool

ALL = ("inverse_kinematics", "nearest_inverse_kinematics")
#: Bytes of code and of stack, and instructions a pose, that all branches may take.
CEILINGS = {
    ("puma560", "cortex-m4f", "float"): (7000, 520, 3300),
    ("ur5", "cortex-m7", "double"): (8500, 1150, 4700),
}


@cache
def kernel_of(name: str, scalar: Any, functions: tuple[str, ...] = ALL) -> Generated:
    options = firmware_options(Options(functions=functions), (), scalar=scalar)
    return generate(load(name, warn=lambda _: None), options)


def folder(name: str, scalar: str, *targets: str, functions: tuple[str, ...] = ALL) -> Folder:
    return firmware(kernel_of(name, scalar, functions), targets_named(targets))


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "target", "scalar"), CEILINGS)
def test_all_branches_on_a_microcontroller(name: str, target: str, scalar: str) -> None:
    (processor,) = targets_named((target,))
    require_firmware_tools(processor)
    files = folder(name, scalar, target, functions=ALL[:1]).files
    figures = measure(name, files, ALL[:1], processor)
    (cost,) = figures.costs
    code, stack, instructions = CEILINGS[name, target, scalar]
    assert figures.sections["text"] + figures.sections["rodata"] <= code
    assert figures.sections["data"] == figures.sections["bss"] == 0
    assert set(figures.undefined) <= {"memset"}  # of what lists solutions, which no image here calls
    assert cost.stack is not None
    assert cost.stack_used is not None
    assert cost.instructions is not None
    # Arguments beyond the fourth are on the caller's stack.
    assert cost.stack - 16 <= cost.stack_used <= cost.stack + 32
    assert cost.stack <= stack
    assert cost.instructions <= instructions


# --- bits -------------------------------------------------------------------------------------------------


def test_in_floats_too_what_exists_reaches_its_pose_and_no_pose_is_lost() -> None:
    """Of 10,000 poses some are nearly out of reach of elbow and wrist both: one of two equations is blind to
    what is missing then, and an elbow moved by more than a rounding error leaves the wrist out of reach."""
    arm = str(Path(__file__).parents[2] / "examples" / "kinematics" / "fr3.yaml")
    robot = load(arm, warn=lambda _: None)
    ((_, program),) = kernel_of(arm, "float", ALL[:1]).unit.functions
    q = draw_sample(robot, 10_000, 1, np.dtype(np.float32)).q
    T = Reference(robot).tool_pose(q).reshape(-1, 12).astype(np.float32)
    states = {"T": T, "q_near": q.astype(np.float32)}
    rows = outputs(program, states, {}, "float", kernel_sine("float"))
    solutions, exists = rows[:, : 8 * 7].astype(float).reshape(-1, 8, 7), rows[:, 8 * 7 : 8 * 8] == 1
    missed = np.abs(Reference(robot).tool_pose(solutions.reshape(-1, 7)).reshape(-1, 8, 12) - T[:, None])
    assert missed.max(axis=2)[exists].max() < 1e-4
    assert exists.any(axis=1).all()


# --- the self-test ----------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_c_and_fortran_pass_with_the_digest_of_numpy(tmp_path: Path) -> None:
    write(tmp_path, folder("ur5", "float", "cortex-m4f").files)
    code, said = host(require_tool("gcc"), "ur5", tmp_path)
    assert (code, said.splitlines()[-1]) == (0, "ur5 float self-test passed")
    code, also = fortran(require_tool("gfortran"), "ur5", tmp_path)
    assert code == 0, also
    assert digests(said) == digests(also)
    assert list(digests(said)) == list(ALL)
    wrong = (
        (tmp_path / "ur5.c").read_text(encoding="utf-8").replace("solutions[7] = ", "solutions[7] = 1e-2f + ")
    )
    (tmp_path / "ur5.c").write_text(wrong, encoding="utf-8")
    assert host(require_tool("gcc"), "ur5", tmp_path)[0] == 3


def test_poses_of_the_self_test_have_bounds_and_positions_that_lead_back() -> None:
    robot = load("puma560", warn=lambda _: None)
    ((interface, program),) = kernel_of("puma560", "float", ALL[1:]).unit.functions
    states = well_conditioned(robot, program, {}, 8, 2, "float")
    inputs = program_inputs(states, {})
    bounds = rounding_bounds(program, inputs, "float")
    assert 0 < max(x.max() for x in bounds.values()) < 1e-2
    assert bounds["branch"].max() == 0
    function = function_named(interface.function)
    expected = [[y for x in evaluated(program, inputs, k).values() for y in x] for k in range(8)]
    assert missed_poses(robot, function, states, {}, expected) == []
    expected[5][2] += Fraction(1, 1000)
    assert missed_poses(robot, function, states, {}, expected) == [5]


FLAGS = ("-std=c99", "-O1", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", "-ffp-contract=off")


@pytest.mark.thorough
@pytest.mark.parametrize(("scalar", "trig"), [("double", "libm"), ("float", "builtin")])
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
