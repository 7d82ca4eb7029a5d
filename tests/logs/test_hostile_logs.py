"""Logs that claim more than they have, or unpack to more than anybody has: refused at no cost."""

from __future__ import annotations

import contextlib
import io
import itertools
import os
import random
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from logs.parquet_parts import BINARY, I32, STRUCT, Page, Parts, Struct, put, taken_apart, written
from robodyn.errors import InputError, Place
from robodyn.logs import columns, csv_file, parquet_file, parquet_pages
from robodyn.logs.columns import LARGEST, layout_of
from robodyn.logs.log import read_log
from robodyn.simulate.torque_file import read_torques
from robodyn.simulate.trajectories import from_file
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


@pytest.fixture
def refusal(tmp_path: Path) -> Callable[[Parts | bytes], str]:
    """What is said of a Parquet log, which must be refused before pyarrow unpacks anything."""

    def read(log: Parts | bytes) -> str:
        path = tmp_path / "log.parquet"
        path.write_bytes(log if isinstance(log, bytes) else log.data())
        with pytest.raises(InputError) as caught:
            read_log(path)
        assert caught.value.exit_code == 2
        return str(caught.value)

    return read


@pytest.fixture
def packs_nothing_out(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: Any, **__: Any) -> Any:
        pytest.fail("the columns are unpacked")

    monkeypatch.setattr(parquet_file, "_batches", never)


# --- Parquet: what is claimed -----------------------------------------------------------------------------


@pytest.mark.parametrize("how", [{}, {"use_dictionary": True}, {"data_page_version": "2.0"}], ids=str)
def test_what_is_put_together_again_is_a_log(tmp_path: Path, how: dict[str, Any]) -> None:
    path = tmp_path / "log.parquet"
    path.write_bytes(taken_apart(packed(row_group_size=30, **how)).data())
    log = read_log(path)
    np.testing.assert_array_equal(log.t, TIMES)
    np.testing.assert_array_equal(log.tau[:, 0], np.cos(TIMES))


CLAIMS = [
    dict(zip(("file", "groups", "columns"), each, strict=True))
    for each in itertools.product((False, True), repeat=3)
    if any(each)
]


@pytest.mark.usefixtures("packs_nothing_out")
@pytest.mark.parametrize("rows", [-1, 0, ROWS - 1, ROWS + 1, 10**6, 10**12, 2**63 - 1])
@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: "+".join(k for k, v in claim.items() if v))
def test_rows_that_are_not_there(refusal: Callable[[Parts], str], claim: dict[str, bool], rows: int) -> None:
    parts = taken_apart(packed())
    parts.claim(rows, **claim)
    said = refusal(parts)
    if rows == 0 and claim["file"] and claim["groups"]:
        assert "the log has no samples" in said
    elif rows > LARGEST and claim["file"] and claim["groups"]:
        assert "the log is too long; found more than 89478485 samples of 3 columns" in said
    else:
        assert "the file is not Parquet, or damaged; found " in said
        assert str(rows) in said


@pytest.mark.parametrize("rows", [ROWS + 1, 5000])
@pytest.mark.parametrize("version", ["1.0", "2.0"])
@pytest.mark.parametrize("dictionary", [False, True])
def test_rows_that_even_the_pages_claim(
    refusal: Callable[[Parts], str], rows: int, version: str, dictionary: bool
) -> None:
    """Everything agrees but what is in the pages."""
    parts = taken_apart(packed(data_page_version=version, use_dictionary=dictionary))
    parts.claim(rows, file=True, groups=True, columns=True)

    def more(page: Page) -> None:
        for number in (5, 8):
            if number in page.head:
                put(page.head[number][1], 1, rows)
                if number == 8:
                    put(page.head[number][1], 3, rows)

    parts.each_page(more)
    assert "the file is not Parquet, or damaged" in refusal(parts)


@pytest.mark.usefixtures("packs_nothing_out")
def test_one_column_of_one_group_is_enough(refusal: Callable[[Parts], str]) -> None:
    parts = taken_apart(packed(row_group_size=30))
    put(parts.columns(2)[1], 5, 31)
    assert "'q1' has 31 values in 30 rows" in refusal(parts)
    parts = taken_apart(packed(row_group_size=30))
    put(parts.groups[3], 3, 11)
    assert "100 rows, and 101 in its groups of rows" in refusal(parts)
    parts = taken_apart(packed(row_group_size=30))
    put(parts.groups[0], 3, -70)
    put(parts.groups[1], 3, 130)
    assert "100 rows, and 100 in its groups" in refusal(parts)
    parts = taken_apart(packed())
    del parts.pages[0][2][0]
    assert "not Parquet" in refusal(parts)


@pytest.mark.usefixtures("packs_nothing_out")
def test_pages_that_are_bombs(refusal: Callable[[Parts], str]) -> None:
    body = zlib.compress(bytes(1 << 24), 9)
    for size in (-1, 1 << 24, 2**31 - 1):
        for dictionary in (False, True):
            parts = taken_apart(packed(compression="gzip", use_dictionary=dictionary))
            page = parts.pages[0][1][0]
            page.body = body
            put(page.head, 2, size)
            assert f"a page of 'q1' unpacks to {size} bytes, for 100 values" in refusal(parts)
    parts = taken_apart(packed(use_dictionary=True))
    put(parts.pages[0][1][0].head[7][1], 1, 10**9)
    assert "a page of 'q1' has 1000000000 values, of 100 in all" in refusal(parts)


@pytest.mark.usefixtures("packs_nothing_out")
def test_places_outside_of_the_file(refusal: Callable[[bytes], str]) -> None:
    data = packed()
    for number, value in ((9, 10**9), (9, 0), (9, -5), (7, 10**12), (7, -1), (7, 3), (7, 20)):
        parts = taken_apart(data)
        put(parts.columns(0)[1], number, value)
        whole = parts.data()
        length = int.from_bytes(whole[-8:-4], "little")
        edited = taken_apart(whole)  # with the places put right again: once more, in the footer alone
        put(edited.columns(0)[1], number, value)
        end = written(STRUCT, edited.footer)
        said = refusal(whole[: -8 - length] + end + len(end).to_bytes(4, "little") + b"PAR1")
        assert "the file is not Parquet, or damaged" in said


# --- Parquet: the footer ----------------------------------------------------------------------------------


def nested(levels: int) -> bytes:
    """A log with one more column, which is nested so deeply."""
    parts = taken_apart(packed())
    parts.footer.pop(5, None)
    columns: list[Struct] = parts.footer[2][1][1]
    put(columns[0], 5, 4)
    for _ in range(levels):
        columns.append({3: (I32, 0), 4: (BINARY, b"deep"), 5: (I32, 1)})
    columns.append({1: (I32, 5), 3: (I32, 0), 4: (BINARY, b"leaf")})
    return parts.data()


@pytest.mark.usefixtures("packs_nothing_out")
def test_columns_that_are_nested(refusal: Callable[[bytes], str]) -> None:
    assert "nested more than 64 deep" in refusal(nested(100))
    assert "nested more than 64 deep" in refusal(nested(30_000))
    assert "a list of 100005" in refusal(nested(100_000))


def footer(*fields: bytes) -> bytes:
    end = b"".join(fields)
    return b"PAR1" + end + len(end).to_bytes(4, "little") + b"PAR1"


@pytest.mark.usefixtures("packs_nothing_out")
@pytest.mark.parametrize(
    "end",
    [
        b"",
        b"\0",
        b"\x19\xfc\xff\xff\xff\xff\x0f" + bytes(50),  # a list of 2^32
        b"\x29\xfc\xa0\x8d\x06" + bytes(100_000),  # 100,000 columns of nothing
        b"\x1c" * 200_000,  # a struct in a struct in a struct
        b"\x19\x19" * 100_000,  # lists likewise
        b"\x16" + b"\xff" * 10_000,  # a number without an end
        b"\x18\xff\xff\xff\xff\x0f",  # a word of 2^32
        b"\x15\x02" + b"\x05\x02\x02" * 1000,  # a field again and again
    ],
    ids=["empty", "nothing", "list", "columns", "structs", "lists", "number", "word", "fields"],
)
def test_footers_that_are_none(refusal: Callable[[bytes], str], end: bytes) -> None:
    require_module("pyarrow")
    assert "the file is not Parquet, or damaged" in refusal(footer(end))


@pytest.mark.usefixtures("packs_nothing_out")
def test_footers_out_of_size(refusal: Callable[[bytes], str], monkeypatch: pytest.MonkeyPatch) -> None:
    data = packed()
    length = len(data) - 12
    for claimed in (length + 1, 2**31, 2**32 - 1):
        assert "a footer of" in refusal(data[:-8] + claimed.to_bytes(4, "little") + b"PAR1")
    for size in range(13):
        assert "not Parquet" in refusal(data[-size:] if size else b"")
    monkeypatch.setattr(parquet_pages, "FOOTER", 100)
    assert "a footer of" in refusal(data)


def test_whatever_is_changed_in_a_file_it_is_read_or_refused(tmp_path: Path) -> None:
    """pyarrow's own view of the footer ends the process at some of these."""
    path = tmp_path / "log.parquet"
    chance = random.Random(1)
    logs = [packed(compression="zstd", row_group_size=40, use_dictionary=each) for each in (False, True)]
    for _ in range(400):
        data = bytearray(chance.choice(logs))
        length = int.from_bytes(data[-8:-4], "little")
        for _ in range(chance.choice((1, 2, 4))):
            data[chance.randrange(len(data) - 8 - length, len(data) - 8)] = chance.randrange(256)
        path.write_bytes(data)
        with contextlib.suppress(InputError):
            assert read_log(path).samples == ROWS


def test_all_that_pyarrow_writes_is_read(tmp_path: Path) -> None:
    pyarrow, parquet = require_module("pyarrow"), require_module("pyarrow.parquet")
    path = tmp_path / "log.parquet"
    steps = np.arange(ROWS)
    columns = {"t": TIMES, "q1": np.zeros(ROWS), "tau1": steps.astype("i1"), "on": ["x"] * ROWS}
    for compression, version, dictionary, page, group in itertools.product(
        ("none", "snappy", "zstd"), ("1.0", "2.0"), (True, False), (None, 64), (None, 7)
    ):
        parquet.write_table(
            pyarrow.table(columns), path, compression=compression, data_page_version=version,
            use_dictionary=dictionary, data_page_size=page, row_group_size=group,
        )  # fmt: skip
        assert read_log(path).tau[:, 0].tolist() == steps.tolist()
    for encoding in ("DELTA_BINARY_PACKED", "BYTE_STREAM_SPLIT", "PLAIN"):
        for rows in (1, 2, 33, ROWS):
            table = pyarrow.table(dict.fromkeys(("t", "q1", "tau1"), steps[:rows]))
            parquet.write_table(table, path, use_dictionary=False, column_encoding=encoding)
            assert read_log(path).samples == rows


# --- text -------------------------------------------------------------------------------------------------


class Names(list[str]):
    """Names of columns that do not let themselves be searched once for each of them."""

    def count(self, _: object) -> int:
        pytest.fail("every name is counted in all others")


def test_names_of_columns_are_gone_through_once() -> None:
    layout = layout_of(Names(["t", "q1", "tau1", *["x"] * 1000]), None, Place("log.csv"))
    assert len(layout.ignored) == 1000
    with pytest.raises(InputError, match="columns with the same name; found q1"):
        layout_of(Names(["t", "q1", "tau1", "q1", "x", "x"]), None, Place("log.csv"))


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
    monkeypatch.setattr(columns, "LARGEST", 300)
    monkeypatch.setattr(csv_file, "LARGEST", 300)
    monkeypatch.setattr(csv_file, "BLOCK", 200)
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
