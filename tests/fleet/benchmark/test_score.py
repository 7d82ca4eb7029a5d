"""The score of an answer about a simulated fleet."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from benchmarks.fleet.score import FleetScore, main, score_fleet

from robodyn.diagnose.blind.json_part import Part
from robodyn.diagnose.blind.seal import seal
from robodyn.effects.friction import COULOMB, VISCOUS
from robodyn.effects.rigid import PAYLOAD
from robodyn.errors import InputError


def planted(unit: str, kind: str, effects: list[str], joint: int | None, since: str | None) -> dict[str, Any]:
    return {"type": "a", "unit": unit, "kind": kind, "effects": effects, "joint": joint, "since": since}


ANSWER = {
    "fleet": {"a": [f"u{k}" for k in range(100)]},
    "planted": [
        planted("u1", "friction", [COULOMB.id, VISCOUS.id], 3, "2025-05-01T00:00:00Z"),
        planted("u2", "payload", [PAYLOAD.id], None, None),
    ],
}


def claim(effects: list[str], joint: int | None, since: str | None = None, days: int = 10) -> dict[str, Any]:
    interval = [f"2025-05-{10 - days + 1:02d}T00:00:00Z", "2025-05-31T00:00:00Z"]
    return {
        "effects": effects, "joint": joint, "since": since, "since_interval": interval if since else None,
    }  # fmt: skip


def scored(named: dict[str, list[dict[str, Any]]]) -> FleetScore:
    units = [{"type": "a", "unit": f"u{k}", "claims": named.get(f"u{k}", [])} for k in range(100)]
    return score_fleet(Part(ANSWER, "answer.sealed", "an answer", "look"), {"units": units})


RIGHT = {"u1": [claim([VISCOUS.id], 3, "2025-05-11T00:00:00Z")], "u2": [claim([PAYLOAD.id], None)]}


def test_all_right() -> None:
    score = scored(RIGHT)
    assert score.result == "right"
    assert (score.units, score.healthy, score.planted, score.named, score.false) == (100, 98, 2, 2, 0)
    assert (score.claims, score.right) == (2, 2)
    assert (score.days_off, score.near, score.interval_holds) == (10.0, 1.0, 1.0)
    assert score.to_dict()["kinds"]["friction"] == {"planted": 1, "named": 1, "right": 1}


@pytest.mark.parametrize(
    ("named", "result"),
    [
        ({}, "missed"),
        ({"u1": RIGHT["u1"]}, "missed"),
        ({**RIGHT, "u2": [claim([VISCOUS.id], 3)]}, "wrong"),
        ({**RIGHT, "u1": [claim([VISCOUS.id], 2)]}, "wrong"),
        ({**RIGHT, "u5": [claim([VISCOUS.id], 2)]}, "wrong"),
    ],
    ids=["nothing", "one", "effect", "joint", "one healthy, of three named"],
)
def test_what_is_wrong_or_missed(named: dict[str, list[dict[str, Any]]], result: str) -> None:
    assert scored(named).result == result


def test_at_the_shell(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "answer.sealed").write_text(seal(ANSWER))
    file = tmp_path / "fleet.json"
    for claims, code in ((RIGHT, 0), ({**RIGHT, "u2": [claim([VISCOUS.id], 3)]}, 1)):
        units = [{"type": "a", "unit": unit, "claims": named} for unit, named in claims.items()]
        file.write_text(json.dumps({"units": units}))
        assert main([str(tmp_path), str(file)]) == code
    right, wrong = capsys.readouterr().out.split("overall: right\n")
    assert "friction: 1 of 1 units are named, 1 with effect and joint right" in right
    assert f"u2: {PAYLOAD.id} is planted, {VISCOUS.id} at joint 3 is named" in wrong


@pytest.mark.parametrize(
    ("result", "part"),
    [
        ([], "a JSON object"),
        ({}, "units"),
        ({"units": [{"type": "a", "claims": []}]}, r"units\[0\].unit"),
        ({"units": [{"type": "a", "unit": "u1", "claims": [{"effects": 3}]}]}, r"claims\[0\].effects"),
        (
            {"units": [{"type": "a", "unit": "u1", "claims": [claim([VISCOUS.id], 3, "yesterday")]}]},
            r"claims\[0\].since",
        ),
    ],
)
def test_no_answer_about_a_fleet(result: Any, part: str) -> None:
    with pytest.raises(InputError, match=part):
        score_fleet(Part(ANSWER, "answer.sealed", "an answer", "look"), result)
