"""``robodyn hide --score`` and ``--open`` on files that somebody has changed: refused, never a traceback."""

from __future__ import annotations

import base64
import copy
import json
import os
import random
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from robodyn.diagnose.blind.seal import seal
from robodyn_cli.main import main

Capture = pytest.CaptureFixture[str]

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
    "effect": "spring",
    "joint": 2,
    "parameters": {"stiffness": {"value": 3.4, "stderr": 0.1, "unit": "N*m/rad"}},
    "confidence": 0.9,
    "confounded_with": ["torque_bias"],
}
COUPLING = {
    **FINDING,
    "effect": "motor_coupling",
    "joint": 5,
    "parameters": {"with": {"value": 6.0, "stderr": None, "unit": ""}, "encoder": {"value": "motor"}},
}
DIAGNOSIS = {
    "verdict": "missing_effect",
    "findings": [FINDING, COUPLING],
    "gap": {"validate": {"before": [1.0, 2.0], "after": [0.1, 0.2]}},
    "logs": [{"name": "train.csv", "sha256": "a" * 64}],
}
ODD: list[Any] = [
    None, True, False, 0, -1, 1.5, 10**200, -(10**200), 1e300, 5e-324, "", "spring", "\x1b[31m", "\u0000",
    "x" * 5000, [], [[]], [None], ["spring"], {}, {"value": None}, {"": 1}, {"with": "x"},
    {"with": {"value": 1e300}}, [{"effect": "spring"}],
]  # fmt: skip


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("d").mkdir()
    Path("d/answer.sealed").write_text(seal(ANSWER))
    Path("diagnosis.json").write_text(json.dumps(DIAGNOSIS))


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where something stands in JSON."""
    yield path
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, each in inner:
        yield from places(each, (*path, key))


def with_other(whole: Any, path: tuple[Any, ...], value: Any) -> Any:
    """``whole`` with ``value`` at ``path``; without what stands there, if it is :data:`GONE`."""
    if not path:
        return value
    whole = copy.deepcopy(whole)
    last = whole
    for key in path[:-1]:
        last = last[key]
    if value is GONE:
        del last[path[-1]]
    else:
        last[path[-1]] = value
    return whole


GONE = object()


def assert_answered(capsys: Capture, command: str) -> tuple[int, str]:
    """Assert that the exit code is one that is promised, and a refusal one line on stderr; return both."""
    code = main(command.split())
    out, err = capsys.readouterr()
    assert code in (0, 1, 2), (command, err)
    if code == 2:
        assert list(json.loads(out)) == ["error"] if "--json" in command else not out
        assert err.startswith("robodyn: error: ")
        assert err.count("\n") == 1
    assert "\x1b" not in out + err
    return code, err


def test_what_is_whole_is_scored(capsys: Capture) -> None:
    assert main(["hide", "--score", "d", "diagnosis.json"]) == 0
    out = capsys.readouterr().out
    assert "stiffness: 3.4 +- 0.1 N*m/rad, true value 3.5" in out
    assert "overall: right" in out
    assert "90% of the gap" in out or "% of the gap on the validation log is closed" in out


def spoilt(whole: Any) -> Iterator[Any]:
    """``whole`` with anything anywhere, or without a part."""
    for path in places(whole):
        for value in [*ODD, *([GONE] if path else [])]:
            yield with_other(whole, path, value)


def test_a_diagnosis_with_anything_anywhere(capsys: Capture) -> None:
    for diagnosis in spoilt(DIAGNOSIS):
        Path("diagnosis.json").write_text(json.dumps(diagnosis))
        for more in ("", " --json"):
            assert_answered(capsys, f"hide --score d diagnosis.json{more}")


def test_an_answer_with_anything_anywhere(capsys: Capture) -> None:
    for answer in spoilt(ANSWER):
        Path("d/answer.sealed").write_text(seal(answer))
        code, _ = assert_answered(capsys, "hide --score d diagnosis.json")
        opened, _ = assert_answered(capsys, "hide --open d/answer.sealed")
        assert (code == 2) is (opened == 2), answer


@pytest.mark.parametrize(
    ("path", "value", "message"),
    [
        (("verdict",), "maybe", "verdict; found 'maybe'; expected one of missing_effect, consistent, unexp"),
        (("findings",), {}, "findings; found an empty object; expected a list"),
        (("findings", 1, "joint"), "two", "findings[1].joint; found 'two'; expected the number of a joint"),
        (("findings", 0, "confidence"), 3, "findings[0].confidence; found 3; expected a number from 0 to 1"),
        (("findings", 0, "confidence"), True, "findings[0].confidence; found true; expected a number"),
        (("findings", 0, "effect"), GONE, "findings[0].effect; found nothing; expected the name of"),
        (("findings", 0, "parameters", "stiffness"), 3.4, "parameters.stiffness; found 3.4; expected a JSON"),
        (("findings", 1, "parameters", "with", "value"), 2.5, "with.value; found 2.5; expected the number"),
        (("findings", 0, "confounded_with"), "spring", "confounded_with; found 'spring'; expected a list"),
        (("gap", "validate", "before"), [1, -1], "gap.validate.before[1]; found -1; expected a number, 0 or"),
        (("logs", 0, "sha256"), 5, "logs[0].sha256; found 5; expected a short text"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(capsys: Capture, path: tuple[Any, ...], value: Any, message: str) -> None:
    Path("diagnosis.json").write_text(json.dumps(with_other(DIAGNOSIS, path, value)))
    code, err = assert_answered(capsys, "hide --score d diagnosis.json")
    assert code == 2
    assert err.startswith("robodyn: error: diagnosis.json: this is not a diagnosis: ")
    assert message in err
    assert err.endswith("take the diagnosis.json that robodyn diagnose has written\n")


def test_gaps_that_cannot_be_known_are_null(capsys: Capture) -> None:
    unknown = with_other(DIAGNOSIS, ("gap", "validate"), {"before": [None, None], "after": [None, None]})
    Path("diagnosis.json").write_text(json.dumps(unknown))
    assert main(["hide", "--score", "d", "diagnosis.json", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["gap_closed"] is None


DEEP = "[" * 100_000
TEXTS = [
    b"",
    b"\0" * 1000,
    b"\xff\xfe{\0}\0",
    b"\xef\xbb\xbf",
    b"\x80",
    b"{",
    b"{}",
    b"[]",
    b"null",
    b"NaN",
    b"1e999",
    b"9" * 5000,
    DEEP.encode(),
    b'{"a":' * 50_000,
    b'{"verdict":"consistent","findings":[],"x":' + b"[" * 400 + b"]" * 400 + b"}",
    b'{"verdict":"consistent","findings":[],"x":"\\ud800"}',
    b'{"verdict":"consistent","findings":[],"x":NaN}',
    b'{"verdict":"consistent","findings":[],"x":-Infinity}',
    b'{"verdict":"consistent","findings":[],"x":1e999}',
    b'{"verdict":"consistent","findings":[],"x":' + b"7" * 4000 + b"}",
    json.dumps(DIAGNOSIS).encode()[:-20],
    json.dumps(DIAGNOSIS).encode("utf-16"),
    json.dumps(DIAGNOSIS).encode() + b"}",
]


def sealed(data: bytes) -> bytes:
    return b"robodyn sealed answer 1\n" + base64.b64encode(zlib.compress(data)) + b"\n"


@pytest.mark.parametrize("data", TEXTS, ids=lambda data: repr(data[:12] + data[-4:]))
def test_files_that_are_something_else(capsys: Capture, data: bytes) -> None:
    Path("other").write_bytes(data)
    code, err = assert_answered(capsys, "hide --score d other")
    assert code == 2
    assert "other" in err
    for answer in (data, sealed(data)):
        Path("d/answer.sealed").write_bytes(answer)
        code, err = assert_answered(capsys, "hide --open d/answer.sealed")
        assert code == 2
        assert "d/answer.sealed" in err
        assert assert_answered(capsys, "hide --score d diagnosis.json")[0] == 2


def test_answers_that_are_bombs_or_cut_off(capsys: Capture) -> None:
    path = Path("d/answer.sealed")
    text = seal(ANSWER)
    path.write_bytes(sealed(b" " * (1 << 26)))
    assert "a part of one" in assert_answered(capsys, "hide --open d/answer.sealed")[1]
    path.write_text(text + text.split("\n", 1)[1])
    assert assert_answered(capsys, "hide --open d/answer.sealed")[0] == 2
    for length in range(0, len(text) - 2, 7):
        path.write_text(text[:length])
        assert assert_answered(capsys, "hide --open d/answer.sealed")[0] == 2
    path.write_text("robodyn sealed answer 1\n" + " " * (1 << 25))
    assert "the file is too large" in assert_answered(capsys, "hide --open d/answer.sealed")[1]


def test_bytes_changed_at_random(capsys: Capture) -> None:
    chance = random.Random(2)
    commands = {
        "d/answer.sealed": "hide --open d/answer.sealed",
        "diagnosis.json": "hide --score d diagnosis.json",
    }
    for name, command in commands.items():
        data = Path(name).read_bytes()
        for _ in range(200):
            broken = bytearray(data)
            for _ in range(chance.randrange(1, 4)):
                broken[chance.randrange(len(broken))] = chance.choice((chance.randrange(256), *b'{}[],"9e-.'))
            Path(name).write_bytes(broken)
            assert_answered(capsys, command)
        Path(name).write_bytes(data)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
def test_files_that_cannot_be_read(capsys: Capture) -> None:
    os.mkfifo("pipe")
    Path("empty").mkdir()
    Path("loop").symlink_to("loop")
    Path("secret").write_text("{}")
    Path("secret").chmod(0)
    cases = {"pipe": "not a regular file", "/dev/zero": "not a regular file", "empty": "no such file",
             "loop": "too many levels of symbolic links", "none": "no such file"}  # fmt: skip
    if os.geteuid() != 0:
        cases["secret"] = "permission denied"
    for name, message in cases.items():
        for command in (f"hide --open {name}", f"hide --score d {name}"):
            code, err = assert_answered(capsys, command)
            assert (code, message in err) == (2, True), err
    for folder in ("none", "loop", "pipe", "diagnosis.json"):
        assert assert_answered(capsys, f"hide --score {folder} diagnosis.json")[0] == 2
    assert "swap the two arguments" in assert_answered(capsys, "hide --score diagnosis.json d")[1]
