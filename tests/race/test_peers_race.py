"""``make benchmarks``: a peer with other torques does not race, one that is missing is named, and the
Markdown is made of the figures."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.peers import candidates
from benchmarks.peers.building import Lacking
from benchmarks.peers.candidates import Candidate, Missing
from benchmarks.peers.race import paired
from benchmarks.peers.tables import markdown

from robodyn.bench.peers.numbers import numbers_of
from robodyn.robot import load


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
