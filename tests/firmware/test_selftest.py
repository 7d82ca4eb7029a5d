"""The self-test passes where the kernel is right, and says so where it is not."""

from __future__ import annotations

import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from firmware.folders import (
    SCALARS,
    digests,
    folder,
    fortran,
    host,
    made,
    robot,
    run,
    write,
)  # fmt: skip
from robodyn.firmware.digest import draw, ranges, vector_states
from robodyn.firmware.vectors import Unconfirmed, vectors
from robodyn.ir.program import Program
from robodyn_testing import representative, require_machine, require_module, require_tool

ALL = ("inverse_dynamics", "gravity", "bias", "mass_matrix", "forward_dynamics")
#: With several results, and with one.
KINEMATIC = ("forward_kinematics", "link_poses", "tool_jacobian")
VECTOR, DIGEST, GUARD = 1, 2, 4


@pytest.mark.parametrize(
    ("name", "functions", "scalar"),
    representative(
        [
            (*arm, scalar)
            for arm in (("puma560", ()), ("stanford", ALL), ("tool", ALL), ("tool", KINEMATIC))
            for scalar in SCALARS
        ],
        ("tool", ALL, "double"),
        rest="slow",
    ),
)
def test_c_and_fortran_pass_with_the_digest_of_numpy(
    name: str, functions: tuple[str, ...], scalar: str, tmp_path: Path
) -> None:
    write(tmp_path, folder(name, scalar, functions).files)
    code, said = host(require_tool("gcc"), name, tmp_path)
    assert (code, said.splitlines()[-1]) == (0, f"{name} {scalar} self-test passed")
    shares = [float(x) for x in re.findall(r"worst (\S+) of its", said)]
    assert all(0.03 < share < 1 for share in shares), "tolerances are neither too tight nor idle"
    code, also = fortran(require_tool("gfortran"), name, tmp_path)
    assert code == 0, also
    assert digests(said) == digests(also)
    assert len(digests(said)) == len(functions or (1,))


@pytest.mark.parametrize("level", ["-O0", pytest.param("-O3", marks=pytest.mark.thorough)])
def test_levels_of_optimisation_give_the_same_bits(level: str, tmp_path: Path) -> None:
    write(tmp_path, folder("puma560", "float").files)
    assert host(require_tool("gcc"), "puma560", tmp_path, level)[0] == 0


def kernel_constants(source: str) -> list[re.Match[str]]:
    """The robot's numbers in the kernel of inverse dynamics."""
    start = source.index("void puma560_inverse_dynamics")
    return [
        found for found in re.finditer(r"(?<![\w.])\d+\.\d+(?:e-?\d+)?f?\b", source) if found.start() > start
    ]


def altered(source: str, found: re.Match[str], factor: float) -> str:
    number = float(found[0].rstrip("f"))
    suffix = "f" if found[0].endswith("f") else ""
    return source[: found.start()] + repr(number * factor) + suffix + source[found.end() :]


@pytest.mark.thorough
def test_a_single_last_digit_is_noticed(tmp_path: Path) -> None:
    """But where a term is so small beside its sum that the digit is rounded away at all 1,000 states."""
    files = folder("puma560", "double").files
    write(tmp_path, files)
    noticed = []
    for found in kernel_constants(files["puma560.c"])[::8]:
        wrong = altered(files["puma560.c"], found, 1 + 2**-52)
        assert wrong != files["puma560.c"]
        (tmp_path / "puma560.c").write_text(wrong, encoding="utf-8")
        code, _ = host(require_tool("gcc"), "puma560", tmp_path, "-O0")
        noticed.append(bool(code & DIGEST))
    assert len(noticed) > 5
    assert sum(noticed) >= len(noticed) - 1


def test_contraction_changes_bits_and_no_more(tmp_path: Path) -> None:
    gcc = require_tool("gcc")
    write(tmp_path, folder("puma560", "float").files)
    fused = "__FMA__" in run([gcc, "-march=native", "-dM", "-E", "-"], tmp_path)[1]
    require_machine(fused, "a processor that fuses products and sums")
    assert host(gcc, "puma560", tmp_path, "-march=native", "-ffp-contract=fast")[0] == DIGEST


def test_a_sine_that_takes_infinity_for_a_number_is_noticed(tmp_path: Path) -> None:
    files = folder("puma560", "float").files
    body = re.compile(r"(void puma560_sincos_\(puma560_real) x(,[^)]*\)\n\{\n)")
    wrong = body.sub(
        r"\1 given\2    const puma560_real x = given - given == 0 ? given : 0;\n", files["puma560.c"]
    )
    assert wrong != files["puma560.c"]
    write(tmp_path, {**files, "puma560.c": wrong})
    assert host(require_tool("gcc"), "puma560", tmp_path)[0] == GUARD


@pytest.mark.parametrize("name", representative(["puma560", "stanford", "panda"], "stanford", rest="slow"))
def test_the_results_are_pinocchios(name: str) -> None:
    require_module("pinocchio")
    from peers.pinocchio_peer import pinocchio_model, torques

    generated = made(name, "double")
    ((interface, program),) = generated.unit.functions
    states = vector_states(ranges(robot(name), ("q", "qd", "qdd"), "double"), "double")
    found = vectors(robot(name), interface.function, program, states, {}, "double")
    expected = torques(pinocchio_model(robot(name)), robot(name), *states.values())
    mine = np.array([[float(x) for x in row] for row in found.expected])
    assert found.confirmed
    assert np.abs(mine - expected).max() < 1e-12 * np.abs(expected).max()


def test_a_program_that_is_wrong_is_not_confirmed() -> None:
    ((interface, program),) = made("puma560", "double").unit.functions
    operations = list(program.operations)
    for i, (op, args, _) in enumerate(operations):
        if op == "mul" and isinstance(args[0], Fraction):
            operations[i] = operations[i]._replace(args=(args[0] * (1 + Fraction(1, 10**15)), args[1]))
            break
    wrong = Program(tuple(operations), program.outputs)
    states = vector_states(ranges(robot("puma560"), ("q", "qd", "qdd"), "double"), "double")
    with pytest.raises(Unconfirmed):
        vectors(robot("puma560"), interface.function, wrong, states, {}, "double")


@pytest.mark.parametrize("scalar", SCALARS)
def test_states_lie_within_the_limits(scalar: Any) -> None:
    spans = ranges(robot("tool"), ("q", "qd", "qdd"), scalar)
    for states in (draw(spans, 1000, 1, scalar), vector_states(spans, scalar)):
        q, qd, qdd = (states[a][:, 1] for a in ("q", "qd", "qdd"))
        assert -0.5 <= q[:26].min() < -0.3
        assert 1.0 < q[:20].max() <= q[:26].max() <= 1.25
        assert np.abs(qd).max() <= 2
        assert np.abs(qdd).max() <= 7
