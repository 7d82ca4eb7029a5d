"""The race of every function: all results are checked, and the tables and bounds are those of the figures."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.peers import every_function, limits, ours
from benchmarks.peers.candidates import Candidate
from benchmarks.peers.race import Race, harness

from robodyn.bench.peers.numbers import Disagreement
from robodyn_testing import require_tool

RESULTS = Path(__file__).parents[2] / "benchmarks" / "results"
FUNCTION = "jacobian_and_forward_kinematics"


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    require_tool("gcc")
    monkeypatch.setattr(every_function, "BUILDS", dict.fromkeys(ours.BUILDS, ("-O1",)))
    monkeypatch.setattr(every_function, "WANTED", {FUNCTION: 8.0})
    monkeypatch.setattr(Race, "instructions", lambda *_: None)


@pytest.mark.usefixtures("quick")
def test_all_results_of_a_function_are_checked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def peers(function: str, folder: Path, size: int) -> list[Candidate]:
        return [Candidate("pinocchio-ours", "ours again", "", folder / "robodyn-native.so", None)]

    monkeypatch.setattr(every_function, "_peers", peers)
    (race,) = every_function.measured("stanford_3dof", tmp_path, harness(tmp_path), 4)
    assert [row["key"] for row in race["rows"]] == ["robodyn", "robodyn-scheduled", "pinocchio-ours"]
    assert all(row["worst"] < 1e-12 for row in race["rows"])
    assert [(demand["peer"], demand["wanted"]) for demand in race["demands"]] == [("pinocchio-ours", 8.0)] * 2
    plain = ours.values_of

    def off(*arguments: Any) -> Any:
        values = plain(*arguments).copy()
        values[5, -1] += 1e-6  # the last entry of the last result of one state
        return values

    monkeypatch.setattr(every_function, "values_of", off)
    with pytest.raises(Disagreement, match="state 5"):
        list(every_function.measured("stanford_3dof", tmp_path, harness(tmp_path), 4))


def test_a_chain_is_longer_than_its_units() -> None:
    require_tool("llvm-mca")
    chain = limits.bound_of(["vaddsd %xmm0,%xmm1,%xmm1"] * 20)
    apart = limits.bound_of([f"vaddsd %xmm0,%xmm0,%xmm{k}" for k in range(1, 15)])
    assert (chain.instructions, chain.operations) == (20, 20)
    assert chain.latency >= 80  # four cycles each
    assert chain.units <= 20
    assert apart.steady < 14 < chain.steady


def test_the_committed_table_is_made_of_the_committed_figures() -> None:
    figures = json.loads((RESULTS / "limits.json").read_text(encoding="utf-8"))
    assert (RESULTS / "limits.md").read_text(encoding="utf-8") == limits.markdown(figures)
    races = json.loads((RESULTS / "peers.json").read_text(encoding="utf-8"))["functions"]["races"]
    assert [(row["robot"], row["function"]) for row in figures["rows"]] == [
        (race["robot"], race["function"]) for race in races
    ]


def test_every_function_raced_on_an_arm_of_six_joints_and_one_of_seven() -> None:
    found = json.loads((RESULTS / "peers.json").read_text(encoding="utf-8"))["functions"]
    raced = {(race["robot"], race["function"]) for race in found["races"]}
    assert raced == {
        (robot, function) for robot in ("puma560", "panda") for function in every_function.WANTED
    }
    for race in found["races"]:
        assert all(np.isfinite(row["ratio"]).all() for row in race["rows"])
