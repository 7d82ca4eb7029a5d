"""``make benchmarks``: a peer with other torques does not race, one that is missing is named, and the
Markdown is made of the figures."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.peers import __main__ as race_main
from benchmarks.peers import candidates, ours
from benchmarks.peers.building import STRICT, Lacking, Source, library
from benchmarks.peers.candidates import Candidate, Missing
from benchmarks.peers.race import Race, harness, paired
from benchmarks.peers.tables import markdown

from robodyn.bench.peers.numbers import numbers_of
from robodyn.robot import load
from robodyn_testing import require_tool


def perturbed(folder: Path, target: Path) -> Candidate:
    """Our own kernel with one number changed in its sixth digit, as if it were a peer."""
    text = (folder / "libm" / "puma560_3dof.c").read_text()
    at = text.index("17.4") if "17.4" in text else text.rindex("0.")
    changed = folder / "changed.c"
    end = at
    while text[end] in "0123456789.":
        end += 1
    changed.write_text(f"{text[:at]}({text[at:end]} * 1.00001){text[end:]}")
    names = ("HEADER", '"puma560_3dof.h"'), ("REAL", "double"), ("KERNEL", "puma560_3dof_inverse_dynamics")
    source = Source(("robodyn.c", changed), (f"-I{folder / 'libm'}",), defines=names)
    built = library(target, source, STRICT)
    return Candidate("other", "a peer with another arm", "", built, None)


@pytest.mark.thorough
def test_a_peer_with_other_torques_does_not_race(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    require_tool("gcc")

    def peers(arm: Any, folder: Path, asked: Any) -> Iterator[Candidate | Missing]:
        yield perturbed(folder, folder / "other.so")
        yield Missing("absent", "a peer that is absent", "it is on holiday")

    monkeypatch.setattr(race_main, "peers", peers)
    monkeypatch.setattr(race_main, "batches", lambda robot, folder: [])
    monkeypatch.setattr(ours, "BUILDS", dict.fromkeys(ours.BUILDS, ("-O1",)))
    monkeypatch.setattr(Race, "instructions", lambda *_: None)
    found, pinocchio = race_main.native("puma560_3dof", tmp_path, harness(tmp_path), (), 4)
    assert pinocchio is None
    rows = {row["key"]: row for row in found["native"]["rows"]}
    assert set(rows) == {
        f"robodyn-{t}{b}" for t in ("builtin", "libm", "given") for b in ("", "-scheduled", "-v3", "-default")
    }
    assert all(row["ns"] > 0 and row["worst"] < 1e-12 for row in rows.values())
    assert rows["robodyn-builtin"]["ratio"] == [1, 1, 1]
    said = {one["title"]: one["why"] for one in found["native"]["missing"]}
    assert said["a peer with another arm"].startswith("refused: ")
    assert "another torque in state" in said["a peer with another arm"]
    assert said["a peer that is absent"] == "it is on holiday"


def test_what_cannot_be_had_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def lacking(arm: Any, folder: Path) -> Candidate:
        raise Lacking("not installed: pip install something")

    monkeypatch.setitem(candidates.MAKERS, "kdl", ("KDL", lacking))
    arm = numbers_of(load("puma560_3dof", warn=lambda _: None))
    assert list(candidates.peers(arm, tmp_path, ("kdl",))) == [
        Missing("kdl", "KDL", "not installed: pip install something")
    ]


def test_ratios_are_taken_round_by_round() -> None:
    noise = np.array([1.0, 5.0, 2.0, 9.0, 1.5] * 40)
    found = paired(3 * noise, noise)
    assert (found.median, found.low, found.high) == (3, 3, 3)
    random = np.random.default_rng(0)
    inside = 0
    for _ in range(200):
        found = paired(random.lognormal(0, 0.5, 101), np.ones(101))
        assert found.low <= found.median <= found.high
        inside += found.low <= 1 <= found.high
    assert 180 <= inside <= 199  # 95 of 100 intervals have the true median


RESULTS = Path(__file__).parents[2] / "benchmarks" / "results"


@pytest.fixture
def figures() -> Any:
    return json.loads((RESULTS / "peers.json").read_text(encoding="utf-8"))


def test_the_committed_markdown_is_made_of_the_committed_figures(figures: Any) -> None:
    assert (RESULTS / "peers.md").read_text(encoding="utf-8") == markdown(figures)


def test_every_peer_of_the_list_raced_or_is_named(figures: Any) -> None:
    keys = {row["key"] for row in figures["native"]["rows"]}
    titles = " ".join(one["title"] for one in figures["native"]["missing"])
    for key, (title, _) in candidates.MAKERS.items():
        assert key in keys or title in titles
