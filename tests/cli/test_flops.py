"""``robodyn flops``: tables, JSON, budgets, and what is refused."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from robodyn.dynamics.functions import by_default
from robodyn.kernels.generate import Options, generate
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


def test_formulations_and_rotors(capsys: Capture) -> None:
    both = flops_json(capsys, "stanford_3dof", "--formulation", "all")
    assert [record["formulation"] for record in both] == list(FORMULATIONS)
    assert set(FORMULATIONS) >= {"modified_newton_euler", "newton_euler"}
    every = flops_json(capsys, "stanford_3dof", "--formulation", "all", "--functions", USUAL)
    assert len(every) == 5 * len(FORMULATIONS)
    folded = flops_json(capsys, "puma560", "--fold-rotor")
    assert folded["total"] < flops_json(capsys, "puma560")["total"]
    through = flops_json(capsys, "stanford_3dof", "--engine", "sympy")
    assert through["total"] >= flops_json(capsys, "stanford_3dof")["total"]


def test_sympy_takes_no_record_and_says_so(capsys: Capture) -> None:
    out, err = flops(capsys, "stanford_3dof", "--engine", "sympy")
    assert "note: --engine sympy takes no record" in err
    assert flops(capsys, "stanford_3dof", "--engine", "sympy", "--optimize", "fast") == (out, "")
    for level in ("record", "search", "full"):
        assert main(["flops", "stanford_3dof", "--engine", "sympy", "--optimize", level]) == 2
        assert f"--optimize {level} needs the graph engine" in capsys.readouterr().err
    assert Options(engine="sympy").text.startswith("--optimize fast ")


def test_a_table_for_people(capsys: Capture) -> None:
    out, err = flops(capsys, "stanford_3dof_d3", "--functions", USUAL)
    assert err == ""
    lines = out.splitlines()
    assert lines[0].startswith("stanford_3dof_d3: ")
    assert lines[1].split() == ["mul", "add", "div", "total", "minus", "sin/cos", "thesis", "verdict"]
    assert [line.split()[0] for line in lines[2:7]] == list(generate(load("stanford_3dof")).counts)
    assert "48+33 = 81" in lines[2]
    assert "fewer" in lines[2]
    assert lines[7].startswith("thesis: Table 2.10, stanford_3: ")
    mul, add, div, total = (int(word) for word in lines[6].split()[1:5])
    assert mul + add + div == total


# --- budgets ----------------------------------------------------------------------------------------------


def test_a_budget_that_holds_says_nothing_more(capsys: Capture) -> None:
    assert flops(capsys, "stanford_3dof", "--budget", "mul=999,total=9999")[1] == ""


def test_a_budget_that_does_not_hold_is_a_failed_check(capsys: Capture) -> None:
    out, err = flops(capsys, "stanford_3dof", "--budget", "mul=10,add=999", code=1)
    assert "inverse_dynamics" in out
    assert err.startswith("robodyn: error: stanford_3dof inverse_dynamics: mul ")
    assert "over the budget of 10" in err
    assert len(err.splitlines()) == 1
    found = flops_json(capsys, "stanford_3dof", "--budget", "total=1", code=1)
    assert found["total"] > 1


def test_a_budget_holds_every_function_that_is_counted(capsys: Capture) -> None:
    _, err = flops(capsys, "stanford_3dof", "--functions", USUAL, "--budget", "div=0", code=1)
    assert "forward_dynamics: div 2 is 2 over the budget of 0" in err
    assert "gravity" not in err


@pytest.mark.parametrize("budget", ["many", "mul", "mul=", "mul=-1", "flops=3", "mul=1,mul=2", ""])
def test_what_is_no_budget_is_bad_input(budget: str, capsys: Capture) -> None:
    out, err = flops(capsys, "puma560", "--budget", budget, code=2)
    assert out == ""
    assert "budget" in err


# --- what is refused --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "hint"),
    [
        (["stanford", "--functions", "inverse_dynamic"], "did you mean 'inverse_dynamics'?"),
        (["stanford", "--functions", "mass"], "one of inverse_dynamics, gravity, bias, mass_matrix"),
        (["stanford", "--formulation", "newton_eular"], "did you mean 'newton_euler'?"),
        (["stanford", "--optimize", "fas"], "did you mean 'fast'?"),
        (["stanford", "--engine", "simpy"], "did you mean 'sympy'?"),
        (["stanford", "--functoin", "gravity"], "--functions"),
        (["stanfrod"], "stanford"),
        (["nowhere.yaml"], "nowhere.yaml"),
        ([], "ROBOT"),
        (["stanford", "ur5"], "ur5"),
    ],
)
def test_what_is_unknown_gets_a_hint(arguments: list[str], hint: str, capsys: Capture) -> None:
    out, err = flops(capsys, *arguments, code=2)
    assert out == ""
    assert hint in err


@pytest.mark.thorough
def test_an_arm_without_forward_dynamics(capsys: Capture) -> None:
    found = flops_json(capsys, "tx40", "--functions", "all")
    functions = [record["function"] for record in found]
    assert functions[:4] == ["inverse_dynamics", "gravity", "bias", "mass_matrix"]
    assert not {"forward_dynamics", "inverse_mass_matrix"} & set(functions)
    _, err = flops(capsys, "tx40", "--functions", "forward_dynamics", code=2)
    assert "tx40 has no forward dynamics" in err


def test_strict_refuses_what_is_doubtful(capsys: Capture) -> None:
    flops(capsys, "puma560")
    assert "not physical" in flops(capsys, "puma560", "--strict", code=2)[1]


def test_a_robot_of_ones_own(tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "rod.yaml"
    file.write_text("name: rod\nlinks: [{joint: revolute, mass: m, com: [0.5, 0, 0], inertia: {zz: 2}}]\n")
    found = flops_json(capsys, str(file), "--functions", "mass_matrix")
    assert (found["robot"], found["mul"], found["add"]) == ("rod", 1, 1)


def test_roots_and_other_operations_of_poses(capsys: pytest.CaptureFixture[str]) -> None:
    """They are in the total, or beside it; functions of states have no such columns."""
    assert main(["flops", "stanford", "--functions", "inverse_kinematics"]) == 0
    head, row = (line.split() for line in capsys.readouterr().out.splitlines()[1:3])
    numbers = dict(zip(head, map(int, row[1:9]), strict=False))
    assert numbers["mul"] + numbers["add"] + numbers["div"] + numbers["sqrt"] == numbers["total"]
    assert numbers["sqrt"] > 0 < numbers["other"]
    assert main(["flops", "stanford", "--functions", "gravity"]) == 0
    assert "sqrt" not in capsys.readouterr().out
