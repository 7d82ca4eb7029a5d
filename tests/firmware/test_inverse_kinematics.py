"""Inverse kinematics on microcontrollers: what it costs, and the same bits everywhere, at edges too."""

from __future__ import annotations

import ctypes
import re
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from emit.crates import Crate
from firmware.folders import digests, fortran, host, require_firmware_tools, run, write
from robodyn.dynamics.functions import function_named
from robodyn.emit.languages import compiled_language
from robodyn.firmware import Folder, firmware, firmware_options, measure, targets_named
from robodyn.firmware.digest import DTYPE, draw, fnv1a, kernel_sine, outputs, program_inputs, ranges
from robodyn.firmware.language_tests import language_tests
from robodyn.firmware.rounding import rounding_bounds
from robodyn.firmware.vectors import evaluated, missed_poses, well_conditioned
from robodyn.kernels.generate import Generated, Options, generate
from robodyn.robot import load
from robodyn.verify.reference import Reference
from robodyn.verify.sample import draw as draw_sample
from robodyn_testing import require_tool

ALL = ("inverse_kinematics", "nearest_inverse_kinematics")
PROCESSORS = ("cortex-m3", "cortex-m4f", "cortex-m7")
POSES = 300
#: Bytes of code and of stack, and instructions a pose, that all branches may take.
CEILINGS = {
    ("puma560", "cortex-m4f", "float"): (7000, 520, 3300),
    ("ur5", "cortex-m4f", "float"): (7000, 520, 3300),
    ("puma560", "cortex-m7", "double"): (8500, 1150, 4700),
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


def edge_poses(name: str, scalar: str) -> dict[str, NDArray[Any]]:
    """Poses ``T`` of positions within the limits, of quarter turns, where branches meet and joints are free,
    and of poses beyond reach; and positions ``q_near``."""
    robot, real = load(name, warn=lambda _: None), DTYPE[scalar]  # type: ignore[index]
    q = draw(ranges(robot, ("q",), scalar), POSES, 5, scalar)["q"].astype(float)  # type: ignore[arg-type]
    quarters = slice(POSES // 4, POSES // 2)
    q[quarters] = np.rint(q[quarters] / (np.pi / 2)) * (np.pi / 2)
    T = Reference(robot).tool_pose(q).reshape(POSES, 12)
    T[POSES // 2 : 3 * POSES // 4, 3::4] *= 0.1  # the axis of the first joint, and within what is reached
    T[3 * POSES // 4 :, 3::4] *= 10
    T[-2:] = 0
    return {"T": T.astype(real), "q_near": q.astype(real)}


def c_table(name: str, states: dict[str, NDArray[Any]], of: Generated) -> str:
    """Poses and a function that gives the digest of all results at them, in C."""
    rows = ",\n".join(
        "{" + ", ".join(float(x).hex() for x in row) + "}" for row in np.hstack(list(states.values()))
    )
    lines = []
    for signature in of.signatures:
        size = sum(length for _, length in signature.outputs)
        starts = np.cumsum([0, *(length for _, length in signature.outputs)])
        results = ", ".join(f"x + {start}" for start in starts[:-1])
        lines += [
            f"        {signature.symbol}(poses[k], poses[k] + 12, {results});",
            f"        for (unsigned i = 0; i < sizeof(x[0])*{size}u; ++i)",
            "            digest = (digest ^ ((const unsigned char *)x)[i])*16777619u;",
        ]
    body = "\n".join(lines)
    return f"""#include <stdint.h>
#include "{name}.h"
static const {name}_real poses[{POSES}][{12 + states["q_near"].shape[1]}] = {{
{rows}
}};
uint32_t digest_of_poses(void);
uint32_t digest_of_poses(void)
{{
    static {name}_real x[100];
    uint32_t digest = 2166136261u;
    for (int k = 0; k < {POSES}; ++k) {{
{body}
    }}
    return digest;
}}
"""


_MAIN = """#include <stdio.h>
#include "table.c"
int main(void) { printf("poses digest %08x\\n", (unsigned)digest_of_poses()); return 0; }
"""
_IMAGE = """#include "NAME_semihosting.h"
#include "table.c"
int main(void)
{
    const uint32_t digest = digest_of_poses();
    char text[9] = {0};
    for (int k = 0; k < 8; ++k) text[k] = "0123456789abcdef"[digest >> (28 - 4*k) & 15u];
    semihosting_write("poses digest ");
    semihosting_write(text);
    semihosting_write("\\n");
    return 0;
}
"""


def digest_in(said: str) -> int:
    match = re.search(r"^poses digest ([0-9a-f]+)", said, re.M)
    assert match, said
    return int(match[1], 16)


def in_fortran(of: Generated, states: dict[str, NDArray[Any]], where: Path) -> NDArray[Any]:
    """The results of all functions at ``states``, one after another: ``[POSES, size]``."""
    command = [require_tool("gfortran"), *compiled_language("fortran")[1].flags, "-shared", "-fPIC"]
    source = f"{of.unit.robot.name}.f90"
    assert run([*command, source, "-o", "fortran.so"], where)[0] == 0
    library, results = ctypes.CDLL(str(where / "fortran.so")), []
    for k in range(POSES):
        for signature in of.signatures:
            parts = [np.empty(size, states["T"].dtype) for _, size in signature.outputs]
            arrays = [*(np.ascontiguousarray(x[k]) for x in states.values()), *parts]
            getattr(library, f"{signature.symbol}_f")(*(a.ctypes.data_as(ctypes.c_void_p) for a in arrays))
            results += parts
    return np.concatenate(results).reshape(POSES, -1)


def named(of: Generated, rows: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """Results of all functions by name."""
    sizes = [length for signature in of.signatures for _, length in signature.outputs]
    names = [array for signature in of.signatures for array, _ in signature.outputs]
    return dict(zip(names, np.split(rows, np.cumsum(sizes)[:-1], axis=1), strict=True))


@pytest.mark.slow
@pytest.mark.parametrize("scalar", ["float", "double"])
@pytest.mark.parametrize("name", ["puma560", "ur5", "panda"])
def test_the_same_bits_where_branches_meet_and_beyond_reach(name: str, scalar: str, tmp_path: Path) -> None:
    of, states = kernel_of(name, scalar), edge_poses(name, scalar)
    sines = kernel_sine(scalar)  # type: ignore[arg-type]
    rows = [outputs(program, states, {}, scalar, sines) for _, program in of.unit.functions]  # type: ignore[arg-type]
    expected = np.hstack(rows)
    assert np.isfinite(expected).all()
    results = named(of, expected)
    assert (results["singular"] == 1).any(axis=1).sum() > 20
    assert (results["exists"] == 0).all(axis=1).sum() > 50

    files = folder(name, scalar, *PROCESSORS).files
    table = {"table.c": c_table(name, states, of), f"{name}_image.c": _IMAGE.replace("NAME", name)}
    write(tmp_path, {**files, **table, "main.c": _MAIN})
    by_processor = {}
    for cc in ("gcc", "clang"):
        command = [require_tool(cc), "-std=c99", "-O2", "-ffp-contract=off", f"{name}.c", "main.c"]
        assert run([*command, "-lm", "-o", cc], tmp_path)[0] == 0
        by_processor[cc] = digest_in(run([str(tmp_path / cc)], tmp_path)[1])
    for target in targets_named(PROCESSORS):
        require_firmware_tools(target)
        command = [require_tool("make"), "run", f"TARGET={target.name}"]
        by_processor[target.name] = digest_in(run(command, tmp_path)[1])
    by_processor["fortran"] = fnv1a(in_fortran(of, states, tmp_path))
    crate = Crate(of, tmp_path)
    by_processor["rust"] = fnv1a(np.hstack([crate.run(s.function, states, {}, 0.0) for s in of.signatures]))
    assert set(by_processor.values()) == {fnv1a(expected)}, by_processor


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
