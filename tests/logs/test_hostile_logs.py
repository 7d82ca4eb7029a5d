"""Logs that claim more than they have, or unpack to more than anybody has: refused at no cost."""

from __future__ import annotations

import contextlib
import io
import os
import random
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from logs.test_log import complaint, made
from robodyn.errors import InputError, ToolError
from robodyn.logs import recording
from robodyn.logs.formats import text as text_format
from robodyn.logs.log import read_log
from robodyn.simulate.trajectories import from_file
from robodyn.simulate.trajectories.file import read_torques
from robodyn_testing import require_module

ROWS = 100
TIMES = np.arange(ROWS) * 1e-3


def packed(**how: Any) -> bytes:
    """A log of one joint; ``how`` it is written as Parquet."""
    pyarrow, parquet = require_module("pyarrow"), require_module("pyarrow.parquet")
    stream = io.BytesIO()
    columns = {"t": TIMES, "q1": np.sin(TIMES), "tau1": np.cos(TIMES)}
    parquet.write_table(pyarrow.table(columns), stream, **{"use_dictionary": False, **how})
    return stream.getvalue()


# --- Parquet ----------------------------------------------------------------------------------------------


def test_whatever_is_changed_in_a_file_it_is_read_or_refused(tmp_path: Path) -> None:
    """pyarrow ends its process at some of these."""
    path = tmp_path / "log.parquet"
    chance = random.Random(1)
    logs = [packed(compression="zstd", row_group_size=40, use_dictionary=each) for each in (False, True)]
    for _ in range(40):
        data = bytearray(chance.choice(logs))
        length = int.from_bytes(data[-8:-4], "little")
        for _ in range(chance.choice((1, 2, 4))):
            data[chance.randrange(len(data) - 8 - length, len(data) - 8)] = chance.randrange(256)
        path.write_bytes(data)
        with contextlib.suppress(InputError):
            assert read_log(path).samples == ROWS


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


# --- text -------------------------------------------------------------------------------------------------


def test_half_a_million_columns(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("t,q1,tau1" + "," * 500_000 + "\n" + "1,2,3" + ",4" * 500_000 + "\n")
    assert read_log(path).tau.tolist() == [[3.0]]
    path.write_text("t,q1,q1" + "," * 500_000 + "\n")
    for read in (read_log, lambda path: read_torques(path, 1), from_file):
        with pytest.raises(InputError):
            read(path)


@pytest.mark.parametrize("shorter", [False, True])
def test_a_text_of_more_samples_than_are_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shorter: bool
) -> None:
    monkeypatch.setattr(recording, "LARGEST", 300)
    monkeypatch.setattr(text_format, "BLOCK", 200)
    path = tmp_path / "log.csv"
    long = "0.000000,0.000000,0.000000\n" if shorter else "0,0,0\n"
    path.write_text("t,q1,tau1\n" + long + "0,0,0\n" * 99)
    assert read_log(path).samples == 100
    path.write_text("t,q1,tau1\n" + long + "0,0,0\n" * 100)
    with pytest.raises(InputError, match="the log is too long; found more than 100 samples of 3 columns"):
        read_log(path)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="missing: os.mkfifo; only POSIX has it")
@pytest.mark.parametrize("name", ["pipe", "/dev/zero", "folder"])
def test_what_is_no_file_is_not_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    os.mkfifo("pipe")
    for link in ("log.csv", "log.parquet"):
        Path(link).symlink_to(name)
        refused = "no recording in the folder" if name == "folder" else "this is not a regular file"
        with pytest.raises(InputError, match=refused):
            read_log(link)
        for read in (lambda path: read_torques(path, 1), from_file):
            with pytest.raises(InputError, match="this is not a regular file"):
                read(link)


def test_a_file_that_never_has_anything_to_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As /proc/kmsg does, which calls itself regular."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("robodyn.files.S_ISREG", lambda _: True)
    os.mkfifo("log.csv")
    held = os.open("log.csv", os.O_RDWR)
    try:
        for read in (read_log, lambda path: read_torques(path, 1), from_file):
            with pytest.raises(InputError):
                read("log.csv")
    finally:
        os.close(held)


def test_a_motion_takes_no_more_than_its_text(tmp_path: Path) -> None:
    """Columns times lines of an untrue header would be 10^11 numbers."""
    path = tmp_path / "motion.csv"
    path.write_text("t,q1" + "".join(f",x{k}" for k in range(100_000)) + "\n" + "0\n" * 1_000_000)
    with pytest.raises(InputError, match=r"motion\.csv:2: a line of the wrong length; found 1 cells"):
        from_file(path)
