"""``robodyn hide`` and ``robodyn excite``: what they write and print, and files that somebody has changed."""

from __future__ import annotations

import base64
import copy
import itertools
import json
import os
import random
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from cli.command import Capture, run, run_json
from robodyn.diagnose.blind.seal import seal
from robodyn.logs.log import read_log
from robodyn.simulate.trajectories import from_file
from robodyn_cli.main import main

PENDULUM = """\
# A comment that stays.
name: pendulum
gravity: [0, -9.81, 0]
links:
  - {joint: revolute, mass: 2, com: [0.5, 0, 0], inertia: {zz: 0.1}, motor_inertia: 0.05,
     limits: {position: [-2, 2], velocity: 3, acceleration: 12}}
"""
SHORT = "--duration 2 --rate 200"


@pytest.fixture(autouse=True)
def folder(elsewhere: Path) -> Path:
    (elsewhere / "pendulum.yaml").write_text(PENDULUM)
    return elsewhere


def test_hide_and_open(capsys: Capture) -> None:
    """What the score of it says: golden/hide.txt."""
    _, err = run(capsys, f"hide pendulum.yaml --effect viscous_friction@1:coefficient=pi/4 {SHORT} -o d")
    assert not err
    assert Path("d/given.yaml").read_text() == PENDULUM
    assert read_log("d/train.csv", 1).samples == 401
    answer = json.loads(run(capsys, "hide --open d/answer.sealed")[0])
    truth = {"effect": "viscous_friction", "joint": 1, "parameters": {"coefficient": 0.785398}}
    assert answer["effects"] == [truth]
    assert json.loads(run(capsys, "hide --open d")[0]) == answer
    Path("other.json").write_text(json.dumps({"verdict": "consistent", "findings": []}))
    assert "viscous" not in run(capsys, "hide --score d other.json", code=1)[0]


def test_hide_draws_one_by_default_and_says_nothing_of_it(capsys: Capture) -> None:
    out, err = run(capsys, f"hide pendulum.yaml --seed 5 {SHORT} -o d --json")
    assert json.loads(out)["hidden"] == 1
    (one,) = json.loads(run(capsys, "hide --open d/answer.sealed")[0])["effects"]
    assert one["effect"] not in out + err
    _, err = run(capsys, f"hide pendulum.yaml --effect coulomb_friction@1:level=1e-3 {SHORT} -o f")
    assert "times the noise" in err  # nobody can find it


def test_a_trajectory_is_not_written_over(capsys: Capture) -> None:
    run(capsys, "excite pendulum.yaml --tries 1 --duration 2 -o d/train.csv")
    before = Path("d/train.csv").read_bytes()
    _, err = run(capsys, "hide pendulum.yaml -o d --trajectory d/train.csv", code=2)
    assert "would be overwritten" in err
    assert Path("d/train.csv").read_bytes() == before
    run(capsys, "hide pendulum.yaml -o e --random 0 --duration 2 --trajectory d/train.csv")
    moved, wanted = read_log("e/train.csv", 1), from_file("d/train.csv", 1)
    assert np.abs(moved.q[::10] - wanted.q).max() < 2e-3


@pytest.mark.thorough
def test_excite(capsys: Capture) -> None:
    command = "excite pendulum.yaml --tell coulomb_friction,viscous_friction@1 --tries 4 --duration 4"
    first, second, third, *_ = run(capsys, f"{command} -o t.csv")[0].splitlines()
    assert first == "t.csv: 4 s, 401 samples"
    assert second.startswith("coulomb_friction at joint 1 and viscous_friction at joint 1: ")
    assert third == "to identify coulomb_friction: reversals, slow and fast segments, and more than one pose"
    assert from_file("t.csv", 1).provenance["columns"] == ["q", "qd", "qdd"]
    told = run_json(capsys, f"{command} -o t2.csv")
    assert told["separation"] >= told["typical"] > 0
    assert Path("t2.csv").read_bytes() == Path("t.csv").read_bytes()
    assert [one["effect"] for one in told["tell"]] == ["coulomb_friction", "viscous_friction"]
    out, err = run(capsys, "excite pendulum.yaml --tries 1 --duration 2 -o -")
    assert out.startswith("t,q1,qd1,qdd1\n0.0,")
    assert "independence of the catalogue" in err
    _, err = run(capsys, "excite pendulum.yaml --tell payload,inertial_error --tries 2 --duration 4 -o t.csv")
    assert "no motion distinguishes payload and inertial_error at joint 1" in err


# --- files that somebody has changed: refused, never a traceback ------------------------------------------

ANSWER = {
    "robot": "arm",
    "effects": [
        {"effect": "spring", "joint": 2, "parameters": {"stiffness": 3.5, "rest": 0.1}},
        {"effect": "motor_coupling", "joint": 6, "parameters": {"with": 5.0, "encoder": "motor"}},
    ],
    "noise": [0.1, 0.2],
    "logs": {"train.csv": "a" * 64},
}
FINDING = {
    "effect": "spring", "joint": 2, "confidence": 0.9, "confounded_with": ["torque_bias"],
    "parameters": {"stiffness": {"value": 3.4, "stderr": 0.1, "unit": "N*m/rad"}},
}  # fmt: skip
COUPLING = {
    **FINDING, "effect": "motor_coupling", "joint": 5,
    "parameters": {"with": {"value": 6.0, "stderr": None, "unit": ""}, "encoder": {"value": "motor"}},
}  # fmt: skip
DIAGNOSIS = {
    "verdict": "missing_effect",
    "findings": [FINDING, COUPLING],
    "gap": {"validate": {"before": [1.0, 2.0], "after": [0.1, 0.2]}},
    "logs": [{"name": "train.csv", "sha256": "a" * 64}],
}
GONE = object()
ODD: list[Any] = [
    GONE, None, True, False, 0, -1, 1.5, 10**200, -(10**200), 1e300, 5e-324, "", "spring", "\x1b[31m",
    "\u0000", "x" * 5000, [], [[]], [None], ["spring"], {}, {"value": None}, {"": 1}, {"with": "x"},
    {"with": {"value": 1e300}}, [{"effect": "spring"}],
]  # fmt: skip
CLAIM = b'{"verdict":"consistent","findings":[],"x":%s}'
WHOLE = json.dumps(DIAGNOSIS)
TEXTS = [
    b"", b"\0" * 1000, b"\xff\xfe{\0}\0", b"\xef\xbb\xbf", b"\x80", b"{", b"{}", b"[]", b"null", b"NaN",
    b"1e999", b"9" * 5000, b"[" * 100_000, b'{"a":' * 50_000, CLAIM % (b"[" * 400 + b"]" * 400),
    CLAIM % b'"\\ud800"', CLAIM % b"NaN", CLAIM % b"-Infinity", CLAIM % b"1e999", CLAIM % (b"7" * 4000),
    WHOLE.encode()[:-20], WHOLE.encode("utf-16"), WHOLE.encode() + b"}",
]  # fmt: skip


@pytest.fixture
def sealed() -> Path:
    """The answer in the folder ``d``, beside a diagnosis of it."""
    Path("d").mkdir()
    Path("d/answer.sealed").write_text(seal(ANSWER))
    Path("diagnosis.json").write_text(WHOLE)
    return Path("d/answer.sealed")


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where something stands in JSON."""
    yield path
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, each in inner:
        yield from places(each, (*path, key))


def with_other(whole: Any, path: tuple[Any, ...], value: Any) -> Any:
    """``whole`` with ``value`` at ``path``; without what stands there, if it is :data:`GONE`."""
    if not path:
        return None if value is GONE else value
    last = whole = copy.deepcopy(whole)
    for key in path[:-1]:
        last = last[key]
    if value is GONE:
        del last[path[-1]]
    else:
        last[path[-1]] = value
    return whole


def answered(capsys: Capture, command: str) -> tuple[int, str]:
    """Exit code, one that is promised, and stderr, which has one line if something is refused."""
    code = main(command.split())
    out, err = capsys.readouterr()
    assert code in (0, 1, 2), (command, err)
    if code == 2:
        assert list(json.loads(out)) == ["error"] if "--json" in command else not out
        assert err.startswith("robodyn: error: ")
        assert err.count("\n") == 1
    assert "\x1b" not in out + err
    return code, err


@pytest.mark.parametrize("every", [23, pytest.param(1, marks=pytest.mark.slow)])
def test_anything_anywhere(every: int, sealed: Path, capsys: Capture) -> None:
    """In a diagnosis, and in an answer: what cannot be opened cannot be scored with, and nothing else."""
    for path, value in itertools.islice(itertools.product(places(DIAGNOSIS), ODD), 0, None, every):
        Path("diagnosis.json").write_text(json.dumps(with_other(DIAGNOSIS, path, value)))
        for more in ("", " --json"):
            answered(capsys, f"hide --score d diagnosis.json{more}")
    Path("diagnosis.json").write_text(WHOLE)
    for path, value in itertools.islice(itertools.product(places(ANSWER), ODD), 0, None, every):
        sealed.write_text(seal(with_other(ANSWER, path, value)))
        code, _ = answered(capsys, "hide --score d diagnosis.json")
        opened, _ = answered(capsys, f"hide --open {sealed}")
        assert (code == 2) is (opened == 2), (path, value)


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (("verdict",), "maybe", "verdict; found 'maybe'; expected one of missing_effect, consistent, unexp"),
        (("findings", 1, "joint"), "two", "findings[1].joint; found 'two'; expected the number of a joint"),
        (("findings", 0, "confidence"), True, "findings[0].confidence; found true; expected a number"),
        (("findings", 0, "effect"), GONE, "findings[0].effect; found nothing; expected the name of"),
        (("findings", 1, "parameters", "with", "value"), 2.5, "with.value; found 2.5; expected the number"),
        (("gap", "validate", "before"), [1, -1], "gap.validate.before[1]; found -1; expected a number, 0 or"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(
    path: tuple[Any, ...], value: Any, message: str, sealed: Path, capsys: Capture
) -> None:
    Path("diagnosis.json").write_text(json.dumps(with_other(DIAGNOSIS, path, value)))
    code, err = answered(capsys, "hide --score d diagnosis.json")
    assert code == 2
    assert err.startswith("robodyn: error: diagnosis.json: this is not a diagnosis: ")
    assert message in err


def test_gaps_that_cannot_be_known_are_null(sealed: Path, capsys: Capture) -> None:
    assert "gap on the validation log is closed" in run(capsys, "hide --score d diagnosis.json")[0]
    unknown = with_other(DIAGNOSIS, ("gap", "validate"), {"before": [None, None], "after": [None, None]})
    Path("diagnosis.json").write_text(json.dumps(unknown))
    assert run_json(capsys, "hide --score d diagnosis.json")["gap_closed"] is None


HEAD = b"robodyn sealed answer 1\n"


def test_files_that_are_something_else(sealed: Path, capsys: Capture) -> None:
    for data in TEXTS:
        Path("other").write_bytes(data)
        code, err = answered(capsys, "hide --score d other")
        assert (code, "other" in err) == (2, True), data[:12]
    answers = [HEAD + base64.b64encode(zlib.compress(data)) + b"\n" for data in (*TEXTS, b" " * (1 << 26))]
    for data in (*TEXTS, *answers, HEAD + b" " * (1 << 25)):
        sealed.write_bytes(data)
        code, err = answered(capsys, f"hide --open {sealed}")
        assert (code, str(sealed) in err) == (2, True), data[:12]
        assert answered(capsys, "hide --score d diagnosis.json")[0] == 2


def test_answers_that_are_cut_off_and_bytes_changed_at_random(sealed: Path, capsys: Capture) -> None:
    text = sealed.read_text()
    for broken in (text + text.split("\n", 1)[1], *(text[:k] for k in range(0, len(text) - 2, 17))):
        sealed.write_text(broken)
        assert answered(capsys, f"hide --open {sealed}")[0] == 2
    sealed.write_text(text)
    chance = random.Random(2)
    for path, command in (
        (sealed, f"hide --open {sealed}"),
        (Path("diagnosis.json"), "hide --score d diagnosis.json"),
    ):
        data = path.read_bytes()
        for _ in range(60):
            changed = bytearray(data)
            for _ in range(chance.randrange(1, 4)):
                changed[chance.randrange(len(data))] = chance.choice((chance.randrange(256), *b'{}[],"9e-.'))
            path.write_bytes(changed)
            answered(capsys, command)
        path.write_bytes(data)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
def test_files_that_cannot_be_read(sealed: Path, capsys: Capture) -> None:
    os.mkfifo("pipe")
    Path("empty").mkdir()
    Path("loop").symlink_to("loop")
    cases = {"pipe": "not a regular file", "/dev/zero": "not a regular file", "empty": "no such file",
             "loop": "too many levels of symbolic links", "none": "no such file"}  # fmt: skip
    for name, message in cases.items():
        for command in (f"hide --open {name}", f"hide --score d {name}"):
            code, err = answered(capsys, command)
            assert (code, message in err) == (2, True), err
    for folder in ("none", "loop", "pipe", "diagnosis.json"):
        assert answered(capsys, f"hide --score {folder} diagnosis.json")[0] == 2
