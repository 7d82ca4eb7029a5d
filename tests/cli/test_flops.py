"""``robodyn flops``: figures and JSON; what is refused and budgets stand in the golden file."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.command import Capture, run, run_json
from robodyn.dynamics.functions import by_default
from robodyn.kernels.generate import generate
from robodyn.optimize.programs import FORMULATIONS
from robodyn.robot import load

KEYS = {
    "robot", "function", "formulation", "mul", "add", "div", "sqrt", "neg", "sincos", "total", "thesis",
}  # fmt: skip


@pytest.mark.parametrize("robot", ["puma560_3dof_d3", "rx90"])
def test_the_counts_are_those_of_what_gen_writes(robot: str, capsys: Capture) -> None:
    made = generate(load(robot, warn=lambda _: None))
    found = run_json(capsys, f"flops {robot} --functions {','.join(made.counts)}")
    assert [record["function"] for record in found] == list(made.counts)
    for record in found:
        assert made.counts[record["function"]].to_dict().items() <= record.items()
        assert record.keys() >= KEYS
        assert record["total"] == record["mul"] + record["add"] + record["div"] + record["sqrt"]
        assert (record["robot"], record["formulation"]) == (robot, "modified_newton_euler")


def test_what_the_thesis_has(capsys: Capture) -> None:
    thesis = run_json(capsys, "flops puma560_d2")["thesis"]
    assert (thesis["mul"], thesis["add"]) == (208, 152)
    assert isinstance(thesis["note"], str)
    assert thesis["note"]
    for words in ("ur5", "puma560_d2 --functions gravity"):
        assert run_json(capsys, f"flops {words}")["thesis"] is None


def test_without_regrouping_there_is_more_to_do(capsys: Capture) -> None:
    regrouped, plain, book = (
        run_json(capsys, f"flops ur5{more}")["total"] for more in ("", " --no-regroup", " --optimize none")
    )
    assert regrouped < plain <= book


def test_formulations(capsys: Capture) -> None:
    both = run_json(capsys, "flops stanford_3dof --formulation all")
    assert [record["formulation"] for record in both] == list(FORMULATIONS)
    assert set(FORMULATIONS) >= {"modified_newton_euler", "newton_euler"}
    every = run_json(capsys, f"flops stanford_3dof --formulation all --functions {','.join(by_default())}")
    assert len(every) == 5 * len(FORMULATIONS)
    through = run_json(capsys, "flops stanford_3dof --engine sympy")
    assert through["total"] >= run_json(capsys, "flops stanford_3dof")["total"]


@pytest.mark.thorough
def test_an_arm_without_forward_dynamics(capsys: Capture) -> None:
    functions = [record["function"] for record in run_json(capsys, "flops tx40 --functions all")]
    assert functions[:4] == ["inverse_dynamics", "gravity", "bias", "mass_matrix"]
    assert not {"forward_dynamics", "inverse_mass_matrix"} & set(functions)


@pytest.mark.usefixtures("elsewhere")
def test_a_robot_of_ones_own(capsys: Capture) -> None:
    Path("rod.yaml").write_text(
        "name: rod\nlinks: [{joint: revolute, mass: m, com: [0.5, 0, 0], inertia: {zz: 2}}]\n"
    )
    found = run_json(capsys, "flops rod.yaml --functions mass_matrix")
    assert (found["robot"], found["mul"], found["add"]) == ("rod", 1, 1)
    assert "rod" in run(capsys, "flops rod.yaml")[0]
