"""Logs as Parquet, and what the file beside a log says of its run."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.errors import InputError, ToolError
from robodyn.logs.log import Log, read_log
from robodyn.logs.provenance import provenance, provenance_text
from robodyn.robot import bundled_text, load
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import Affine
from robodyn_testing import require_module


def made(samples: int = 50) -> Log:
    q, tau = np.random.default_rng(0).normal(size=(2, samples, 2))
    return Log(np.asarray(np.arange(samples) * 1e-3, dtype=np.float64), q, None, 3 * q, tau)


def complaint(path: str) -> str:
    with pytest.raises(InputError) as caught:
        read_log(path)
    return str(caught.value)


def test_parquet_is_the_same_log(tmp_path: Path) -> None:
    require_module("pyarrow")
    log = made()
    path = tmp_path / "log.parquet"
    data = log.files("log.parquet")["log.parquet"]
    assert isinstance(data, bytes)
    assert data == log.parquet()
    path.write_bytes(data)
    read = read_log(path)
    assert read.columns == log.columns
    assert all(a.tobytes() == b.tobytes() for a, b in zip(read.arrays(), log.arrays(), strict=True))


def test_parquet_of_others(tmp_path: Path) -> None:
    pyarrow, parquet = require_module("pyarrow"), require_module("pyarrow.parquet")
    path = tmp_path / "log.parquet"

    def write(**columns: Any) -> str:
        parquet.write_table(pyarrow.table(columns), path)
        return str(path)

    numbers = [1.0, 2.0, 3.0]
    read = read_log(write(word=["a", "b", "c"], tau1=[1, 2, 3], q1=np.array(numbers, np.float32), t=numbers))
    assert (read.q.tolist(), read.tau.tolist()) == ([[1.0], [2.0], [3.0]],) * 2
    assert read.ignored == ("word",)
    assert "found no tau1" in complaint(write(t=numbers, q1=numbers))
    assert "'q1' is not of numbers; found string" in complaint(write(t=numbers, q1=["a"] * 3, tau1=numbers))
    assert "null in row 3" in complaint(write(t=numbers, q1=[1.0, 2.0, None], tau1=numbers))
    assert "no samples" in complaint(write(t=np.zeros(0), q1=np.zeros(0), tau1=np.zeros(0)))
    path.write_text("t,q1,tau1\n0,1,2\n")
    assert "the file is not Parquet" in complaint(str(path))


def test_parquet_without_pyarrow(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    (tmp_path / "log.pq").write_bytes(b"PAR1")
    for call in (made(3).parquet, lambda: read_log(tmp_path / "log.pq")):
        with pytest.raises(ToolError, match=r"pip install 'robodyn\[all\]'"):
            call()


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
