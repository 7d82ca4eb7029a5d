"""Second encoders, on the links: columns ql1.. of a log, or of a file beside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.logs.log import Log, read_log

K = 40


def log_with(linked: tuple[int, ...], n: int = 3) -> Log:
    """A log of ``n`` joints of which those ``linked`` (from 0) have a second encoder."""
    rng = np.random.default_rng(1)
    q = rng.normal(size=(K, n))
    ql = np.full((K, n), np.nan)
    ql[:, list(linked)] = q[:, list(linked)] + 1e-3
    return Log(np.linspace(0.0, 0.2, K), q, None, None, rng.normal(size=(K, n)), ql=ql)


def parts(log: Log, folder: Path) -> str:
    """The log as two files, and what they are called together."""
    links = [f"ql{j + 1}" for j in log.linked]
    first = Log(log.t, log.q, log.qd, log.qdd, log.tau)
    (folder / "a.csv").write_text(first.csv(), encoding="utf-8")
    assert log.ql is not None
    rows = np.column_stack([log.t, log.ql[:, list(log.linked)]])
    lines = [",".join(["t", *links]), *(",".join(map(repr, row)) for row in rows.tolist())]
    (folder / "a_secondary.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return f"{folder / 'a.csv'}+{folder / 'a_secondary.csv'}"


@pytest.mark.parametrize("name", ["log.csv", "log.parquet"])
def test_columns_of_some_joints_read_back(name: str, tmp_path: Path) -> None:
    log = log_with((0, 2))
    content = log.files(name)[name]
    (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
    read = read_log(tmp_path / name)
    assert (read.columns, read.linked) == (log.columns, (0, 2))
    assert read.columns[-2:] == ("ql1", "ql3")
    assert read.ql is not None
    np.testing.assert_array_equal(read.ql, log.ql)
    assert read_log(tmp_path / name, 1).linked == (0,)


def test_they_may_stand_in_a_second_file(tmp_path: Path) -> None:
    log = log_with((1,))
    read = read_log(parts(log, tmp_path), 3)
    assert read.ql is not None
    np.testing.assert_array_equal(read.ql, log.ql)
    np.testing.assert_array_equal(read.q, log.q)


def test_a_plus_may_be_part_of_a_name(tmp_path: Path) -> None:
    whole = tmp_path / "a+b.csv"
    whole.write_text(log_with((0,)).csv(), encoding="utf-8")
    assert read_log(whole).linked == (0,)
    first = tmp_path / "c+d.csv"
    first.write_text("t,q1,tau1\n0,1,2\n1,2,3\n", encoding="utf-8")
    (tmp_path / "e+f.csv").write_text("t,ql1\n0,1\n1,2\n", encoding="utf-8")
    assert read_log(f"{first}+{tmp_path / 'e+f.csv'}").linked == (0,)


def test_the_columns_may_be_in_both_files_for_other_joints(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("t,q1,q2,tau1,tau2,ql1\n0,1,2,0,0,1\n1,2,3,0,0,2\n", encoding="utf-8")
    (tmp_path / "b.csv").write_text("t,ql2\n0,3\n1,4\n", encoding="utf-8")
    read = read_log(f"{tmp_path / 'a.csv'}+{tmp_path / 'b.csv'}")
    np.testing.assert_array_equal(read.ql, np.array([[1.0, 3.0], [2.0, 4.0]]))


def test_a_joint_with_two_columns_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("t,q1,tau1,ql1\n0,1,2,1\n1,2,3,2\n", encoding="utf-8")
    (tmp_path / "b.csv").write_text("t,ql1\n0,1\n1,2\n", encoding="utf-8")
    with pytest.raises(InputError, match="ql1 in both files"):
        read_log(f"{tmp_path / 'a.csv'}+{tmp_path / 'b.csv'}")


def test_a_second_file_that_is_not_there(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text("t,q1,tau1\n0,1,2\n1,2,3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"b\.csv: the log cannot be read; found no such file"):
        read_log(f"{tmp_path / 'a.csv'}+{tmp_path / 'b.csv'}")
