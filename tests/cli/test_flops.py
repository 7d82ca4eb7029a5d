"""``robodyn flops``: tables, JSON, budgets, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from robodyn.dynamics.functions import by_default
from robodyn.kernels.generate import generate
from robodyn.optimize.programs import FORMULATIONS
from robodyn.robot import bundled_names, load
from robodyn_cli.main import main
from robodyn_testing import representative

KEYS = {
    "robot", "function", "formulation", "mul", "add", "div", "sqrt", "neg", "sincos", "total", "thesis",
}  # fmt: skip
Capture = pytest.CaptureFixture[str]


def flops(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    """Standard output and the lines on standard error that are not doubts about the robot."""
    assert main(["flops", *arguments]) == code
    out, err = capsys.readouterr()
    lines = [line for line in err.splitlines() if not line.startswith("robodyn: warning: ")]
    assert "Traceback" not in err
    return out, "\n".join(lines)


def flops_json(capsys: Capture, *arguments: str, code: int = 0) -> Any:
    return json.loads(flops(capsys, *arguments, "--json", code=code)[0])


#: The functions that are written unless others are named.
USUAL = ",".join(by_default())

# --- figures ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("robot", representative(bundled_names(), "puma560_3dof_d3", "rx90"))
def test_the_counts_are_those_of_what_gen_writes(robot: str, capsys: Capture) -> None:
    made = generate(load(robot, warn=lambda _: None))
    found = flops_json(capsys, robot, "--functions", ",".join(made.counts))
    assert [record["function"] for record in found] == list(made.counts)
    for record in found:
        expected = made.counts[record["function"]].to_dict()
        assert {key: record[key] for key in expected} == expected
        assert record.keys() >= KEYS
        assert record["total"] == record["mul"] + record["add"] + record["div"] + record["sqrt"]
        assert (record["robot"], record["formulation"]) == (robot, "modified_newton_euler")


def test_json_has_the_keys_of_the_contract(capsys: Capture) -> None:
    found = flops_json(capsys, "puma560_d2")
    assert found.keys() >= KEYS
    thesis = found["thesis"]
    assert (thesis["mul"], thesis["add"]) == (208, 152)
    assert isinstance(thesis["note"], str)
    assert thesis["note"]
    assert flops_json(capsys, "ur5")["thesis"] is None
    assert flops_json(capsys, "puma560_d2", "--functions", "gravity")["thesis"] is None
    assert all(isinstance(found[kind], int) for kind in KEYS - {"robot", "function", "formulation", "thesis"})


@pytest.mark.parametrize(
    ("robot", "total", "mul"),
    [
        ("puma560_d2", 341, 208),
        ("stanford_d3", 248, 183),
        ("puma560_3dof_d3", 142, 10**9),
        ("stanford_3dof_d3", 72, 10**9),
    ],
)
def test_what_must_be_shown(robot: str, total: int, mul: int, capsys: Capture) -> None:
    found = flops_json(capsys, robot)
    assert found["total"] <= total
    assert found["mul"] <= mul
    flops(capsys, robot, "--budget", f"total={total},mul={min(mul, 999999)}")


def test_without_regrouping_there_is_more_to_do(capsys: Capture) -> None:
    for robot in ("puma560", "stanford", "ur5"):
        regrouped, plain = (flops_json(capsys, robot, *more) for more in ((), ("--no-regroup",)))
        book = flops_json(capsys, robot, "--optimize", "none")
        assert regrouped["total"] < plain["total"] <= book["total"]


def test_formulations(capsys: Capture) -> None:
    both = flops_json(capsys, "stanford_3dof", "--formulation", "all")
    assert [record["formulation"] for record in both] == list(FORMULATIONS)
    assert set(FORMULATIONS) >= {"modified_newton_euler", "newton_euler"}
    every = flops_json(capsys, "stanford_3dof", "--formulation", "all", "--functions", USUAL)
    assert len(every) == 5 * len(FORMULATIONS)
    through = flops_json(capsys, "stanford_3dof", "--engine", "sympy")
    assert through["total"] >= flops_json(capsys, "stanford_3dof")["total"]


# --- budgets ----------------------------------------------------------------------------------------------


# --- what is refused --------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_an_arm_without_forward_dynamics(capsys: Capture) -> None:
    found = flops_json(capsys, "tx40", "--functions", "all")
    functions = [record["function"] for record in found]
    assert functions[:4] == ["inverse_dynamics", "gravity", "bias", "mass_matrix"]
    assert not {"forward_dynamics", "inverse_mass_matrix"} & set(functions)
    _, err = flops(capsys, "tx40", "--functions", "forward_dynamics", code=2)
    assert "tx40 has no forward dynamics" in err


def test_a_robot_of_ones_own(tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "rod.yaml"
    file.write_text("name: rod\nlinks: [{joint: revolute, mass: m, com: [0.5, 0, 0], inertia: {zz: 2}}]\n")
    found = flops_json(capsys, str(file), "--functions", "mass_matrix")
    assert (found["robot"], found["mul"], found["add"]) == ("rod", 1, 1)
