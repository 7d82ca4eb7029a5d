"""Logs as text, and everything that a file can have wrong."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from robodyn.errors import InputError
from robodyn.logs.formats import text as text_format
from robodyn.logs.log import Log, read_log
from robodyn.logs.provenance import provenance, provenance_text
from robodyn.robot import bundled_text, load
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import Affine

HEADER = "t,q1,q2,tau1,tau2\n"
GOOD = HEADER + "0.0,1.0,2.0,3.0,4.0\n0.1,1.5,2.5,3.5,4.5\n"


def made(samples: int = 50, n: int = 2, *, rates: bool = True, seed: int = 0) -> Log:
    rng = np.random.default_rng(seed)

    def array() -> Any:
        return rng.normal(size=(samples, n)) * 10.0 ** rng.integers(-30, 30, size=(samples, n))

    q, tau = array(), array()
    return Log(times(samples), q, array() if rates else None, array() if rates else None, tau)


def times(samples: int) -> NDArray[np.float64]:
    """A thousand samples a second."""
    return np.asarray(np.arange(samples) * 1e-3, dtype=np.float64)


def same(one: Log, other: Log) -> bool:
    pairs = zip(one.arrays(), other.arrays(), strict=True)
    return one.columns == other.columns and all(a.tobytes() == b.tobytes() for a, b in pairs)


@pytest.fixture
def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str | bytes], str]:
    monkeypatch.chdir(tmp_path)

    def write(content: str | bytes) -> str:
        Path("log.csv").write_bytes(content.encode() if isinstance(content, str) else content)
        return "log.csv"

    return write


def complaint(path: str, n: int | None = None) -> str:
    with pytest.raises(InputError) as caught:
        read_log(path, n)
    return str(caught.value)


# --- writing ----------------------------------------------------------------------------------------------


def test_the_text_is_the_format() -> None:
    t: Any = [0, 0.1]  # lists do too
    q: Any = [[1, -0.0], [1e-300, np.nan]]
    qdd: Any = [[1, 2], [3, 4]]
    tau: Any = [[np.inf, -np.inf], [0.1, 1 / 3]]
    log = Log(t, q, None, qdd, tau)
    assert log.csv() == (
        "t,q1,q2,qdd1,qdd2,tau1,tau2\n"
        "0.0,1.0,-0.0,1.0,2.0,inf,-inf\n"
        "0.1,1e-300,nan,3.0,4.0,0.1,0.3333333333333333\n"
    )
    full = made(1, 3)
    assert full.csv().split("\n")[0] == "t,q1,q2,q3,qd1,qd2,qd3,qdd1,qdd2,qdd3,tau1,tau2,tau3"
    assert (full.n, full.samples) == (3, 1)


def test_arrays_that_do_not_fit_are_no_log() -> None:
    log = made(5)
    for wrong in (
        {"t": np.zeros(4)},
        {"tau": np.zeros((5, 3))},
        {"qd": np.zeros(5)},
        {"q": np.zeros((5, 0))},
    ):
        with pytest.raises(InputError, match="do not fit together; found t "):
            replace(log, **wrong)


# --- reading back -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("rates", [True, False])
def test_a_log_reads_back_bit_for_bit(written: Callable[[str | bytes], str], rates: bool) -> None:
    log = made(rates=rates)
    read = read_log(written(log.csv()))
    assert same(read, log)
    assert (read.ignored, read.provenance) == ((), {})
    assert read.q.flags.c_contiguous


@pytest.mark.parametrize("block", [64, 100, 333, 1 << 21])
@pytest.mark.parametrize("end", ["\n", "\r\n"])
def test_blocks_do_not_show(
    written: Callable[[str | bytes], str], monkeypatch: pytest.MonkeyPatch, block: int, end: str
) -> None:
    monkeypatch.setattr(text_format, "BLOCK", block)
    # Lines grow shorter on the way, so that the first estimate of their number is too low.
    ones = np.ones((300, 2))
    long, short = made(40, 2), Log(np.arange(300.0), ones, ones, ones, ones)
    parts = [np.concatenate(pair) for pair in zip(long.arrays(), short.arrays(), strict=True)]
    q, qd, qdd, tau = (np.stack(parts[i : i + 2], axis=1) for i in (1, 3, 5, 7))
    both = Log(parts[0], q, qd, qdd, tau)
    text = both.csv().replace("\n", end)
    assert same(read_log(written(text)), both)
    wrong = text.splitlines(keepends=True)
    wrong[200] = wrong[200].replace("1.0", "one", 1)
    assert complaint(written("".join(wrong))).startswith(
        "log.csv:201:7: the cell is not a number; found 'one'"
    )


def test_columns_are_found_by_name(written: Callable[[str | bytes], str]) -> None:
    text = 'mode,tau2,q1,"t",tau1,q2,mötor\nRUN,4,1,0,3,2,x y\nRUN,8,5,1,7,6,"ü"\n'
    read = read_log(written(text))
    assert read.ignored == ("mode", "mötor")
    assert read.t.tolist() == [0.0, 1.0]
    assert (read.q.tolist(), read.tau.tolist()) == ([[1.0, 2.0], [5.0, 6.0]], [[3.0, 4.0], [7.0, 8.0]])
    assert (read.qd, read.qdd) == (None, None)
    first = read_log(written(text), 1)
    assert (first.n, first.ignored) == (1, ("mode", "tau2", "q2", "mötor"))
    latin = read_log(written(text.replace("ü", "u").encode() + b"RUN,4,1,2,3,2,\xff\n"))
    assert latin.t.tolist() == [0.0, 1.0, 2.0]


@pytest.mark.parametrize(
    "text",
    [
        "\ufeff" + GOOD,
        GOOD.replace("\n", "\r\n"),
        GOOD.rstrip("\n"),
        GOOD + "\n\n",
        GOOD.replace("\n0.1", "\n\n \n0.1"),
        GOOD.replace(",", " , "),
        GOOD.replace("0.0", "+0E5").replace("2.0", " 2").replace("4.5", "45e-1"),
    ],
    ids=["mark", "crlf", "no end", "blank at the end", "blank", "spaces", "spellings"],
)
def test_what_is_let_pass(written: Callable[[str | bytes], str], text: str) -> None:
    want = Log([0, 0.1], [[1, 2], [1.5, 2.5]], None, None, [[3, 4], [3.5, 4.5]])  # type: ignore[arg-type]
    assert same(read_log(written(text)), want)


def test_nan_and_infinity_are_values(written: Callable[[str | bytes], str]) -> None:
    read = read_log(written(HEADER + "0,nan,inf,-Infinity,NaN\nnan,1e999,-1e-999,0,0\n"))
    np.testing.assert_array_equal(read.q, [[np.nan, np.inf], [np.inf, -0.0]])
    np.testing.assert_array_equal(read.tau, [[-np.inf, np.nan], [0.0, 0.0]])
    assert np.isnan(read.t[1])


# --- what is wrong ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (GOOD.encode() + b"0.2,1,\xff2,3,4\n", "log.csv:4:7: the file is not UTF-8 text; found byte 0xff"),
        (GOOD.encode() + b"0.2,1,\x002,3,4\n", "log.csv:4:7: the cell is not a number; found '\\x002'"),
        (b"t,q\xe91,tau1\n", "log.csv:1:4: the file is not UTF-8 text; found byte 0xe9"),
        (GOOD.encode("utf-16"), "log.csv: the file is not UTF-8 text; found UTF-16"),
    ],
)
def test_bytes_that_are_no_text(
    written: Callable[[str | bytes], str], content: str | bytes, message: str
) -> None:
    """What is wrong with texts, tests/refusals/log.yaml says."""
    assert message in complaint(written(content))


def test_too_few_joints(written: Callable[[str | bytes], str]) -> None:
    assert "found no q3; expected t,q1..q3,tau1..tau3" in complaint(written(GOOD), 3)
    assert "one joint or more" in complaint(written(GOOD), 0)


def test_a_line_without_end_is_not_read_for_ever(
    written: Callable[[str | bytes], str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(text_format, "LINE", 1000)
    monkeypatch.setattr(text_format, "BLOCK", 400)
    assert complaint(written("t" * 2000)).startswith("log.csv:1: the line is too long")
    assert complaint(written(GOOD + "7" * 2000)).startswith("log.csv:4: the line is too long")


def test_what_cannot_be_read(tmp_path: Path) -> None:
    assert "no such file" in complaint(str(tmp_path / "none.csv"))
    assert "there is no recording in the folder" in complaint(str(tmp_path))
    assert "null" in complaint("a\0b")
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    assert "not a regular file" in complaint(str(pipe))
    odd = tmp_path / "a\nb.csv"
    odd.write_text("")
    assert "a\\nb.csv: the file is empty" in complaint(str(odd))


@given(st.binary(max_size=60), st.integers(0, len(GOOD)))
def test_nothing_but_input_errors(tmp_path_factory: pytest.TempPathFactory, piece: bytes, place: int) -> None:
    path = tmp_path_factory.getbasetemp() / "fuzzed.csv"
    path.write_bytes(GOOD.encode()[:place] + piece + GOOD.encode()[place:])
    with contextlib.suppress(InputError):
        assert read_log(path).samples >= 1


@pytest.mark.slow
def test_a_long_log_takes_little_more_memory_than_its_numbers(tmp_path: Path) -> None:
    import resource

    line = ",".join(["0.12345678901234567"] * 13) + "\n"
    path = tmp_path / "long.csv"
    names = ["t", *(f"{name}{i}" for name in ("q", "tau") for i in range(1, 7))]
    with path.open("w") as file:
        file.write(",".join(names) + "\n")
        for _ in range(100):
            file.write(line * 10_000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    log = read_log(path)
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024
    assert log.samples == 1_000_000
    assert grown < 13 * 8 * log.samples + 64e6


# --- where a log comes from -------------------------------------------------------------------------------


def test_provenance_tells_the_run_and_nothing_else(tmp_path: Path) -> None:
    robot = load("stanford")
    weight = Affine(Fraction(1, 2), (("m_tool", Fraction(2)),))
    entry = EffectEntry("torque_bias", 3, (("bias", Fraction(1, 4)), ("other", weight)))
    robot = replace(robot, effects=(entry,))
    found = provenance(
        robot,
        yaml=bundled_text("stanford"),
        options={
            "motion": tmp_path / "a.csv",
            "log": str(tmp_path / "b.csv"),
            "q0": np.zeros(2),
            "far": np.inf,
        },
        seed=7,
        solver="rk4",
        step=1e-3,
        energy={"start": 1.0},
    )
    assert found["options"] == {"motion": "a.csv", "log": "b.csv", "q0": [0.0, 0.0], "far": "inf"}
    bias = {"effect": "torque_bias", "joint": 3, "bias": 0.25, "other": "0.5 + 2.0*m_tool"}
    assert found["effects"] == [bias]
    assert found["units"]["q"] == ["rad", "rad", "m", "rad", "rad", "rad"]
    assert found["units"]["tau"][2:4] == ["N", "N m"]
    assert (found["robot"], found["seed"], found["solver"], found["step"]) == ("stanford", 7, "rk4", 1e-3)
    assert len(found["sha256"]) == 64
    files = replace(made(3), provenance=found).files("log.csv")
    assert list(files) == ["log.csv", "log.csv.json"]
    assert str(tmp_path) not in str(files["log.csv.json"])
    assert json.loads(files["log.csv.json"]) == found


def test_provenance_is_json_whatever_it_holds() -> None:
    text = provenance_text({"x": [np.float64(np.nan), Fraction(1, 3)], "é": r"C:\Users\me\arm.yaml"})
    assert json.loads(text) == {"x": ["nan", 1 / 3], "é": "arm.yaml"}
