"""An arm whose joints follow others at the command line: what counts, compares, writes and refuses it."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.command import Capture, run, run_json
from robodyn_testing.coupled_files import PALLETIZER


@pytest.fixture
def arm(elsewhere: Path) -> str:
    (elsewhere / "arm.yaml").write_text(PALLETIZER)
    return "arm.yaml"


def test_what_it_is_of_is_said(arm: str, capsys: Capture) -> None:
    out, _ = run(capsys, "flops", arm)
    assert "Coordinates, which arrays have an element for: waist, lower, upper, hand" in out
    row = run_json(capsys, "flops", arm)
    assert row["coordinates"] == ["waist", "lower", "upper", "hand"]
    assert "coordinates" not in run_json(capsys, "flops", "stanford_3dof")


def test_another_ratio_is_a_difference(arm: str, elsewhere: Path, capsys: Capture) -> None:
    other = elsewhere / "other.yaml"
    other.write_text(PALLETIZER.replace("of: upper, ratio: -1", "of: upper, ratio: -2"))
    assert run_json(capsys, "diff", arm, arm)["differences"] == []
    (row,) = run_json(capsys, "diff", arm, str(other), code=1)["differences"]
    assert (row["group"], row["where"]) == ("couplings", "level")


@pytest.mark.parametrize(
    "line",
    [
        "simulate arm.yaml",
        "identify arm.yaml log.csv -o out",
        "diagnose arm.yaml log.csv --out out",
        "schedule arm.yaml -p 2",
        "ik arm.yaml --pose 0,0,0,0,0,0",
        "bench arm.yaml",
        "report arm.yaml -o arm.html",
        "prove arm.yaml",
        "excite arm.yaml -o out",
        "flops arm.yaml --optimize search",
        "package arm.yaml --as ros2 -o out",
        "package arm.yaml --as fmu -o out",
        "export arm.yaml --to urdf -o arm.urdf",
        "gen arm.yaml --functions inverse_kinematics",
    ],
)
def test_what_does_not_know_of_it_says_so_and_writes_nothing(
    arm: str, elsewhere: Path, capsys: Capture, line: str
) -> None:
    (elsewhere / "log.csv").write_text("t,q1\n0,0\n")
    before = sorted(elsewhere.iterdir())
    _, err = run(capsys, line, code=2)
    assert "follow" in err
    assert sorted(elsewhere.iterdir()) == before
