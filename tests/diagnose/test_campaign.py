"""Many blind tests of one arm (``benchmarks.campaign``): a second run does what is new."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from benchmarks import campaign
from benchmarks.campaign import Tally, main, tallies

from robodyn.cluster import Cluster, Done, Failed
from robodyn.errors import InputError

Capture = pytest.CaptureFixture[str]


def outcome(seed: int) -> dict[str, Any]:
    """Of every third trial nothing is found, and of seed 4 something else."""
    status = "missed" if seed % 3 == 0 else "right"
    wrong = [{"effect": "backlash", "joint": 1}] if seed == 4 else []
    hidden = [{"effect": "coulomb_friction", "joint": 2, "status": status}]
    return {"seed": seed, "result": "wrong" if wrong else status, "hidden": hidden, "wrong": wrong}


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


def test_a_campaign_is_resumed_and_counted(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    scripted = Scripted()

    @contextmanager
    def opened(_: str) -> Iterator[Cluster]:
        yield scripted

    monkeypatch.setattr(campaign, "open_cluster", opened)
    words = ["stanford_3dof", "-o", str(tmp_path / "out"), "--trials"]
    assert main([*words, "4"]) == 0
    assert scripted.seeds == [3, 2, 1, 0]
    capsys.readouterr()
    assert main([*words, "6"]) == 0
    assert scripted.seeds[4:] == [5, 4, 2]  # what failed, and what is new
    text, messages = capsys.readouterr()
    assert [line.split() for line in text.splitlines()[1:3]] == [
        ["backlash", "0", "0", "0", "1"],
        ["coulomb_friction", "3", "0", "2", "0"],
    ]
    assert text.endswith("5 trials: 2 right, 0 in the declared set, 2 missed, 1 wrong\n")
    assert "seed 2: too large" in messages
    document = json.loads((tmp_path / "out" / "campaign.json").read_text())
    assert [one["seed"] for one in document] == [0, 1, 3, 4, 5]


def test_effects_are_counted_where_they_were_hidden() -> None:
    assert tallies([outcome(seed) for seed in range(6)]) == [
        Tally("backlash", wrong=1),
        Tally("coulomb_friction", right=4, missed=2),
    ]


@pytest.mark.thorough
def test_a_trial_is_a_blind_test_with_its_score(tmp_path: Path) -> None:
    words = ["stanford_3dof", "--trials", "1", "--effect", "coulomb_friction@2", "--on", "here"]
    assert main([*words, "-o", str(tmp_path)]) == 0
    (trial,) = json.loads((tmp_path / "campaign.json").read_text())
    assert trial["result"] == "right"
    assert trial["hidden"] == [{"effect": "coulomb_friction", "joint": 2, "status": "right"}]
