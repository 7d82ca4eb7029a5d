"""``hide --campaign``: many blind tests, wherever they run; a second run does what is new."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from robodyn import cluster as cluster_module
from robodyn.cluster import Cluster, Done, Failed
from robodyn.diagnose.blind.campaign import Tally, tallies
from robodyn.errors import InputError
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]


def outcome(seed: int) -> dict[str, Any]:
    """Of every third trial nothing is found, and of seed 4 something else."""
    status = "missed" if seed % 3 == 0 else "right"
    wrong = [{"effect": "backlash", "joint": 1}] if seed == 4 else []
    hidden = [{"effect": "coulomb_friction", "joint": 2, "status": status}]
    return {
        "seed": seed, "result": "wrong" if wrong else status, "verdict": "missing_effect", "hidden": hidden,
        "wrong": wrong, "gap_closed": 0.9,
    }  # fmt: skip


class Scripted:
    """A place where work comes to :func:`outcome`, the last piece first; seed 2 fails."""

    count = 1

    def __init__(self) -> None:
        self.seeds: list[int] = []

    def each(self, _: Any, tasks: Iterable[tuple[Any, tuple[Any, ...]]]) -> Iterator[tuple[Any, Any]]:
        for key, (*_, setup) in reversed(list(tasks)):
            self.seeds.append(setup.seed)
            failed = Failed(InputError("too large"))
            yield key, failed if setup.seed == 2 else Done(json.dumps(outcome(setup.seed)).encode())


@pytest.fixture
def scripted(monkeypatch: pytest.MonkeyPatch) -> Scripted:
    own = Scripted()

    @contextmanager
    def opened(on: str) -> Iterator[Cluster]:
        assert on == "local:3"
        yield own

    monkeypatch.setattr(cluster_module, "open_cluster", opened)
    return own


def test_a_campaign_is_resumed_and_counted(tmp_path: Path, scripted: Scripted, capsys: Capture) -> None:
    out = str(tmp_path / "out")
    words = ["hide", "stanford_3dof", "--on", "local:3", "-o", out, "--campaign"]
    assert main([*words, "4"]) == 0
    assert scripted.seeds == [3, 2, 1, 0]
    capsys.readouterr()
    assert main([*words, "6"]) == 0
    assert scripted.seeds[4:] == [5, 4, 2]  # what failed, and what is new
    text, messages = capsys.readouterr()
    assert "stanford_3dof: 5 trials: 2 right, 0 in the declared set, 2 missed, 1 wrong;" in text
    assert [line.split() for line in text.splitlines()[1:3]] == [
        ["backlash", "0", "0", "0", "1"],
        ["coulomb_friction", "3", "0", "2", "0"],
    ]
    assert "seed 2: too large" in messages
    document = json.loads((tmp_path / "out" / "campaign.json").read_text())
    assert (document["failed"], [one["seed"] for one in document["all"]]) == ([2], [0, 1, 3, 4, 5])
    assert main([*words, "6", "--noise", "0.02", "--json"]) == 0  # other tests
    assert len(scripted.seeds) == 13
    assert json.loads(capsys.readouterr().out)["results"] == document["results"]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--fleet", "3", "--campaign", "3"], "--campaign is an option of one arm"),
        (["--campaign", "3", "--format", "csv"], "--format is an option of a fleet"),
        (["--campaign", "3", "--trajectory", "m.csv"], "--trajectory is an option of one test"),
        (["--campaign", "3"], "no output folder"),
        (["--on", "here", "-o", "out"], "--on is an option of a fleet"),
    ],
)
def test_what_does_not_go_together(options: list[str], message: str, capsys: Capture) -> None:
    assert main(["hide", "stanford_3dof", *options]) == 2
    assert message in capsys.readouterr().err


def test_effects_are_counted_where_they_were_hidden() -> None:
    assert tallies([outcome(seed) for seed in range(6)]) == [
        Tally("backlash", wrong=1),
        Tally("coulomb_friction", right=4, missed=2),
    ]


@pytest.mark.thorough
def test_a_trial_is_a_blind_test_with_its_score(tmp_path: Path, capsys: Capture) -> None:
    words = ["hide", "stanford_3dof", "--campaign", "1", "--effect", "coulomb_friction@2", "--on", "here"]
    assert main([*words, "--rate", "200", "-o", str(tmp_path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["results"]["right"] == 1
    assert document["all"][0]["hidden"] == [{"effect": "coulomb_friction", "joint": 2, "status": "right"}]
