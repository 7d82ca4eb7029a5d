"""The yardsticks of benchmarks/inverse_kinematics: arms as axes, sets of solutions, positions, searches."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from benchmarks.inverse_kinematics import positions
from benchmarks.inverse_kinematics.chain import Chain, Floats, chain_of
from benchmarks.inverse_kinematics.sets import Answers, compared
from benchmarks.inverse_kinematics.tables import written

from robodyn.formats.loading import load

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "examples" / "kinematics"
RESULTS = json.loads((ROOT / "benchmarks/results/inverse_kinematics.json").read_text(encoding="utf-8"))
ARMS = sorted(FOLDER.glob("*.yaml"))


def _chain(name: str) -> Chain:
    return chain_of(load(name if (FOLDER / name).suffix == "" else FOLDER / name, warn=lambda _: None))


def _row(q: Floats) -> Answers:
    """One solution a pose."""
    return Answers(q[:, None], np.ones((len(q), 1), dtype=bool))


def test_every_arm_is_listed_with_its_source_and_licence() -> None:
    rows = re.findall(
        r"(?m)^\| `(\w+)\.yaml` \|.*\| (BSD 3-Clause|Apache 2\.0), .+ \|$", (FOLDER / "README.md").read_text()
    )
    assert sorted(name for name, _ in rows) == [path.stem for path in ARMS]
    for path, (_, licence) in zip(ARMS, sorted(rows), strict=True):
        robot = load(path, strict=True)
        assert robot.name == path.stem
        assert licence.partition(" ")[0] in robot.source


def test_sets_are_compared_modulo_turns_and_say_what_each_side_lacks() -> None:
    chain = _chain("puma560")
    q = positions.drawn(chain, 4)
    poses = chain.poses(q)
    turned = q.copy()
    turned[:, 4] += 2 * np.pi
    same = compared(chain, poses, _row(turned), _row(q))
    assert (same.missing, same.only_ours, same.invented, same.twice) == (0, 0, 0, 0)
    assert same.closes < 1e-14
    other = q.copy()
    other[1, 2] += 1e-3
    wrong = compared(chain, poses, _row(other), _row(q))
    assert (wrong.missing, wrong.invented, wrong.only_ours) == (1, 1, 0)
    double = Answers(np.repeat(q[:, None], 2, axis=1), np.ones((4, 2), dtype=bool))
    assert compared(chain, poses, double, _row(q)).twice == 4
    none = Answers(double.q, np.zeros((4, 2), dtype=bool))
    assert compared(chain, poses, none, _row(q)).missing == 4
    assert compared(chain, poses, _row(q), none).only_ours == 4


def test_the_tables_are_those_of_the_results() -> None:
    page = (ROOT / "docs" / "inverse-kinematics-benchmark.md").read_text(encoding="utf-8")
    assert written(page, RESULTS) == page, "run python -m benchmarks.inverse_kinematics --render"


@pytest.mark.parametrize("name", RESULTS["arms"])
def test_results_show_what_the_document_says(name: str) -> None:
    arm = RESULTS["arms"][name]
    beside = [one for one in arm["sets"] if not isinstance(one["missing"], str)]
    assert beside
    for one in beside:
        assert (one["missing"], one["invented"], one["twice"]) == (0, 0, 0), one["peer"]
        assert one["closes"] < 1e-12
    for one in arm["hard"]:
        assert (one["not_finite"], one["no_flags"], one["miscounted"]) == (0, 0, 0), one["kind"]
    for one in arm["race"]["rows"][1:]:
        assert one["ratio"][0] > 3
