"""``robodyn hide`` and ``robodyn excite``: what they write, print and refuse."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from robodyn.logs.log import read_log
from robodyn.simulate.trajectories import from_file
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]

PENDULUM = """\
# A comment that stays.
name: pendulum
gravity: [0, -9.81, 0]
links:
  - joint: revolute
    mass: 2
    com: [0.5, 0, 0]
    inertia: {zz: 0.1}
    motor_inertia: 0.05
    limits: {position: [-2, 2], velocity: 3, acceleration: 12}
"""
SHORT = "--duration 2 --rate 200"


@pytest.fixture(autouse=True)
def elsewhere(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> Path:
    (tmp_path / "pendulum.yaml").write_text(PENDULUM)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("ROBODYN_CACHE", str(tmp_path_factory.getbasetemp() / "robodyn-cache"))
    return tmp_path


def run(capsys: Capture, command: str, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error."""
    assert main(command.split()) == code, capsys.readouterr().err
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def test_hide_open_and_score(capsys: Capture) -> None:
    out, err = run(capsys, f"hide pendulum.yaml --effect viscous_friction@1:coefficient=pi/4 {SHORT} -o d")
    assert out.splitlines() == [
        "pendulum: 1 effect is hidden in d: given.yaml, train.csv, train.csv.json, validate.csv, "
        "validate.csv.json, answer.sealed",
        "robodyn diagnose d/given.yaml d/train.csv --validate d/validate.csv -o d/found",
        "robodyn hide --score d d/found/diagnosis.json",
    ]
    assert not err
    assert Path("d/given.yaml").read_text() == PENDULUM
    assert read_log("d/train.csv", 1).samples == 401
    answer = json.loads(run(capsys, "hide --open d/answer.sealed")[0])
    truth = {"effect": "viscous_friction", "joint": 1, "parameters": {"coefficient": 0.785398}}
    assert answer["effects"] == [truth]

    told = {"value": 0.79, "stderr": 0.004, "unit": "N m s/rad"}
    finding = {
        "effect": "viscous_friction", "joint": 1, "parameters": {"coefficient": told}, "confidence": 0.9,
        "confounded_with": [],
    }  # fmt: skip
    Path("right.json").write_text(json.dumps({"verdict": "missing_effect", "findings": [finding]}))
    assert run(capsys, "hide --score d right.json")[0].splitlines() == [
        "viscous_friction at joint 1: right",
        "  coefficient: 0.79 +- 0.004 N m s/rad, true value 0.7854",
        "overall: right",
    ]
    assert json.loads(run(capsys, "hide --score d right.json --json")[0])["result"] == "right"
    Path("wrong.json").write_text(
        json.dumps({"verdict": "missing_effect", "findings": [{**finding, "effect": "spring"}]})
    )
    out, _ = run(capsys, "hide --score d wrong.json", 1)
    assert out.splitlines() == [
        "spring at joint 1: wrong",
        "1 of 1 hidden missed (robodyn hide --open d/answer.sealed shows them)",
        "overall: wrong",
    ]
    other = {"verdict": "consistent", "findings": [], "logs": [{"sha256": "0" * 64}]}
    Path("other.json").write_text(json.dumps(other))
    out, err = run(capsys, "hide --score d other.json", 1)
    assert "other logs" in err
    assert "viscous" not in out


def test_folders_and_files_are_taken_alike(capsys: Capture) -> None:
    run(capsys, f"hide pendulum.yaml --effect viscous_friction@1:coefficient=1 {SHORT} -o d")
    assert run(capsys, "hide --open d") == run(capsys, "hide --open d/answer.sealed")
    Path("found").mkdir()
    Path("found/diagnosis.json").write_text(json.dumps({"verdict": "consistent", "findings": []}))
    scores = {
        run(capsys, f"hide --score {test} {diagnosis} --json", 1)[0]
        for test in ("d", "d/answer.sealed")
        for diagnosis in ("found", "found/diagnosis.json")
    }
    assert len(scores) == 1
    lines = run(capsys, "hide --score d/answer.sealed found", 1)[0]
    assert "robodyn hide --open d/answer.sealed shows them" in lines
    assert "swap the two arguments" in run(capsys, "hide --score found/diagnosis.json d", 2)[1]


def test_hide_draws_one_by_default_and_says_nothing_of_it(capsys: Capture) -> None:
    out, err = run(capsys, f"hide pendulum.yaml --seed 5 {SHORT} -o d --json")
    told = json.loads(out)
    assert told["hidden"] == 1
    (one,) = json.loads(run(capsys, "hide --open d/answer.sealed")[0])["effects"]
    assert one["effect"] not in out + err
    out, _ = run(capsys, f"hide pendulum.yaml --random 0 {SHORT} -o e")
    assert out.startswith("pendulum: nothing is hidden in e")
    Path("clean.json").write_text(json.dumps({"verdict": "consistent", "findings": []}))
    out, _ = run(capsys, "hide --score e clean.json")
    assert out == "right: nothing was hidden, and nothing is claimed\n"


def test_hide_warns_of_what_nobody_can_find(capsys: Capture) -> None:
    _, err = run(capsys, f"hide pendulum.yaml --effect coulomb_friction@1:level=1e-3 {SHORT} -o d")
    assert "times the noise" in err


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("hide", "no robot is named"),
        ("hide pendulum.yaml", "no output folder"),
        ("hide pendulum.yaml --open d", "--open cannot be combined with other options"),
        ("hide --open d --score d e", "--open cannot be combined with other options"),
        ("hide --score d e --random 2", "--score cannot be combined with other options"),
        ("hide --open d", "cannot be read"),
        ("hide --open pendulum.yaml", "not a sealed answer"),
        ("hide pendulum.yaml -o d --effect spring@x", "has no valid joint"),
        ("hide pendulum.yaml -o d --effect sprung@1", "did you mean 'spring'"),
        ("hide pendulum.yaml -o d --effect spring@1:stiffness", "not a new key=value"),
        ("hide pendulum.yaml -o d --effect spring@1:stiffness=1,stiffness=2", "not a new key=value"),
        ("hide pendulum.yaml -o d --effect spring@2", "no such joint"),
        ("hide pendulum.yaml -o d --duration 1e9", "too long or too short"),
        ("hide pendulum.yaml -o d --encoder-bits 3.5", "encoder bits must be an integer"),
        ("excite pendulum.yaml -o t.csv --tell spring@1", "one effect alone"),
        ("excite pendulum.yaml -o t.csv --tell spring,torque@1", "unknown effect"),
        ("excite pendulum.yaml -o t.csv --duration 0.01", "too few or too many"),
        ("excite pendulum.yaml -o - --json", "both write to stdout"),
    ],
)
def test_what_is_refused(capsys: Capture, command: str, words: str) -> None:
    out, err = run(capsys, command, 2)
    assert words in err
    assert list(json.loads(out)) == ["error"] if "--json" in command else not out
    assert not Path("d").exists()


def test_a_trajectory_is_not_written_over(capsys: Capture) -> None:
    run(capsys, "excite pendulum.yaml --tries 1 --duration 2 -o d/train.csv")
    before = Path("d/train.csv").read_bytes()
    _, err = run(capsys, "hide pendulum.yaml -o d --trajectory d/train.csv", 2)
    assert "would be overwritten" in err
    assert Path("d/train.csv").read_bytes() == before
    run(capsys, "hide pendulum.yaml -o e --random 0 --duration 2 --trajectory d/train.csv")
    moved, wanted = read_log("e/train.csv", 1), from_file("d/train.csv", 1)
    assert np.abs(moved.q[::10] - wanted.q).max() < 2e-3


@pytest.mark.thorough
def test_excite(capsys: Capture) -> None:
    command = "excite pendulum.yaml --tell coulomb_friction,viscous_friction@1 --tries 4 --duration 4"
    out, _ = run(capsys, f"{command} -o t.csv")
    first, second, *rest = out.splitlines()
    assert first == "t.csv: 4 s, 401 samples"
    assert second.startswith("coulomb_friction at joint 1 and viscous_friction at joint 1: ")
    assert (
        rest[0] == "to identify coulomb_friction: reversals, slow and fast segments, and more than one pose"
    )
    motion = from_file("t.csv", 1)
    assert motion.provenance["columns"] == ["q", "qd", "qdd"]
    told = json.loads(run(capsys, f"{command} -o t2.csv --json")[0])
    assert told["separation"] >= told["typical"] > 0
    assert Path("t2.csv").read_bytes() == Path("t.csv").read_bytes()
    assert told["tell"] == [
        {"effect": "coulomb_friction", "joint": 1},
        {"effect": "viscous_friction", "joint": 1},
    ]
    out, err = run(capsys, "excite pendulum.yaml --tries 1 --duration 2 -o -")
    assert out.startswith("t,q1,qd1,qdd1\n0.0,")
    assert "independence of the catalogue" in err


def test_excite_says_where_no_motion_helps(capsys: Capture) -> None:
    _, err = run(capsys, "excite pendulum.yaml --tell payload,inertial_error --tries 2 --duration 4 -o t.csv")
    assert "no motion distinguishes payload and inertial_error at joint 1" in err
