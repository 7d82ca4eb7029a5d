"""Tables as programs and people write them: separators, decimal commas, comments, units, lines above."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.logs.dialect import dialect_of
from robodyn.logs.formats import text as text_format
from robodyn.logs.log import read_log
from robodyn.logs.mapping import map_of_columns

ROWS = [[0.0, 1.5, -2.25], [0.1, 1.625, 1e-3], [0.2, -7.0, 3.0]]


def text_of(mark: str, comma: bool) -> str:
    cells = [[repr(x).replace(".", ",") if comma else repr(x) for x in row] for row in ROWS]
    return "".join(mark.join(row) + "\n" for row in cells)


@pytest.mark.parametrize(
    "content",
    [
        "t;q1;tau1\n" + text_of(";", False),
        "t;q1;tau1\n" + text_of(";", True),
        "t\tq1\ttau1\n" + text_of("\t", False),
        "t\tq1\ttau1\n" + text_of("\t", True),
        "t q1  tau1\n" + text_of("  ", False),
        " t|q1|tau1\n" + text_of("|", False),
        "# recorded by X\n# t,q1,tau1\n" + text_of(",", False),
        "% t q1 tau1\n" + text_of(" ", False),
        "Program: 3.1;;\nRate;100;Hz\n\nt;q1;tau1\n" + text_of(";", True),
        "t,q1,tau1\n[s],[rad],[Nm]\n" + text_of(",", False),
        "t;q1;tau1\ns;rad;N m\n" + text_of(";", True),
        "t (s),q1 (rad),tau1 (N m)\n" + text_of(",", False),
        '"t";"q1";"tau1"\n' + text_of(";", True).replace("1,5", '"1,5"'),
        "t, q1, tau1\r\n" + text_of(", ", False).replace("\n", "\r\n"),
        "\ufefft;q1;tau1\n" + text_of(";", False),
        "t;q1;tau1\n# a pause\n" + text_of(";", False) + "# the end\n",
    ],
)  # fmt: skip
def test_the_same_numbers(content: str, tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_bytes(content.encode())
    log = read_log(path)
    np.testing.assert_array_equal(np.column_stack([log.t, log.q, log.tau]), ROWS)


def test_columns_without_names_have_numbers(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text(text_of(" ", False))
    log = read_log(path, mapping=map_of_columns("t=column1,q=column2,tau=column3"))
    assert log.tau[:, 0].tolist() == [row[2] for row in ROWS]
    with pytest.raises(InputError, match="write a first line with the names of the columns"):
        read_log(path)


def test_empty_cells_are_nan_where_a_map_is_given(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("t,q1,tau1,x\n0,,2,\n1,2,,\n2,3,4,5\n")
    log = read_log(path, mapping=map_of_columns("q=q1,tau=tau1"))
    np.testing.assert_array_equal(log.q[:, 0], [np.nan, 2, 3])
    np.testing.assert_array_equal(log.tau[:, 0], [2, np.nan, 4])
    with pytest.raises(InputError, match=r"log\.csv:2:3: the cell is not a number; found nothing"):
        read_log(path)


def test_words_may_stand_in_columns_that_are_not_read(tmp_path: Path) -> None:
    path = tmp_path / "log.csv"
    path.write_text("date;t;q1;tau1;note\n2024-01-01 10:00;0;1,5;2;a, b\n2024-01-01 10:01;1;2,5;2;\n")
    log = read_log(path, mapping=map_of_columns("q=q1,tau=tau1"))
    assert log.q[:, 0].tolist() == [1.5, 2.5]


def test_dialects_hold_beyond_the_first_block(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text_format, "BLOCK", 64)
    path = tmp_path / "log.csv"
    rows = "".join(f"{k};{k},5;{k},25\n" + ("# x\n" if k % 7 == 0 else "") for k in range(100))
    path.write_text("t;q1;tau1\n" + rows)
    log = read_log(path)
    np.testing.assert_array_equal(log.q[:, 0], np.arange(100) + 0.5)
    np.testing.assert_array_equal(log.tau[:, 0], np.arange(100) + 0.25)


def test_what_is_no_table_has_no_dialect() -> None:
    for text in ("", "one word\n", "a,b\nc,d\n", "\n\n\n", "x" * 1000):
        assert dialect_of(text) is None
