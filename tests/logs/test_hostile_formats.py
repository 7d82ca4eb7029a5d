"""Files of every format that are cut off, changed, or made to do harm: refused, or read as far as they go."""

from __future__ import annotations

import contextlib
import io
import pickle
import random
import sqlite3
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import numpy as np
import pytest

from logs.files_of_logs import bag, matlab, write
from logs.test_formats import JOINTS, motion
from robodyn.errors import InputError
from robodyn.logs.formats import json
from robodyn.logs.log import read_log
from robodyn.logs.mapping import map_of_text
from robodyn.logs.wizard import examine
from robodyn.report.logs import data, lines
from robodyn_testing import representative, require_module

T = TypeVar("T")

KINDS = (".csv", ".npz", ".mat", ".h5", ".json", ".mcap", ".db3")


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """A short log in each format."""
    folder, log = tmp_path_factory.mktemp("formats"), motion(25)
    whole = {kind: write(log, folder, kind).read_bytes() for kind in KINDS}
    whole["packed.mcap"] = bag(log, folder / "packed", ".mcap", packed=True).read_bytes()
    whole["plain.mat"] = matlab({"log": {"q": log.q, "t": log.t, "tau": log.tau}}, do_compression=False)
    return whole


def assert_read_or_refused(path: Path) -> None:
    """Assert that all that reads a log hands it over whole, or refuses it by its name."""
    joints = path.suffix in (".mcap", ".db3")
    mapping = map_of_text(JOINTS if joints else "q: q\ntau: tau\n")
    log = read_or_none(path, lambda: read_log(path, mapping=mapping))
    assert log is None or len(log.q) == len(log.tau) == len(log.t) > 0
    result = read_or_none(path, lambda: examine(path))
    assert result is None or (lines(result) and data(result))


def read_or_none(path: Path, read: Callable[[], T]) -> T | None:
    """What ``read`` returns; None where it refuses, for a reason in which the file has its name."""
    refusal = ""
    try:
        return read()
    except InputError as error:
        refusal = str(error)
    assert path.name in refusal
    return None


@pytest.mark.parametrize("kind", [*KINDS, "packed.mcap", "plain.mat"])
def test_files_that_are_cut_off_or_changed(kind: str, files: dict[str, bytes], tmp_path: Path) -> None:
    rng = random.Random(kind)
    path = tmp_path / f"log{kind}"
    for _ in range(6):
        content = bytearray(files[kind])
        if rng.random() < 0.4:
            del content[rng.randrange(len(content)) :]
        for _ in range(rng.choice((1, 3, 10)) if content else 0):
            at = rng.randrange(min(len(content), rng.choice((200, 10**9))))
            content[at : at + rng.choice((1, 4, 8))] = rng.choice(
                (b"\xff" * 8, b"\0" * 4, b"\x80", rng.randbytes(3))
            )
        path.write_bytes(content)
        assert_read_or_refused(path)


def refused(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        examine(path)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_arrays_that_claim_more_than_they_have(tmp_path: Path) -> None:
    path = tmp_path / "log.npz"
    header = b"{'descr': '<f8', 'fortran_order': False, 'shape': (1000000000000,), }"
    head = b"\x93NUMPY\x01\x00" + struct.pack("<H", 118) + header.ljust(117) + b"\n"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("q.npy", head + b"\0" * 80)
    assert "the log is too long" in refused(path)


def test_nothing_is_unpickled(tmp_path: Path) -> None:
    path = tmp_path / "log.npz"
    np.savez(path, q=np.array([{"a": 1}, None], dtype=object))
    assert "Python objects" in refused(path)
    stream = io.BytesIO()
    np.save(stream, np.array([print, None], dtype=object), allow_pickle=True)
    single = tmp_path / "log.npy"
    single.write_bytes(stream.getvalue())
    assert "Python objects" in refused(single)
    single.write_bytes(pickle.dumps("an object"))  # numpy would advise to load it all the same
    assert "magic string is not correct" in refused(single)


def record(kind: int, content: bytes) -> bytes:
    return struct.pack("<BQ", kind, len(content)) + content


def text(word: str) -> bytes:
    return struct.pack("<I", len(word)) + word.encode()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (lambda zstd: _chunk(zstd.compress(bytes(99)), 1000, "zstd"), "no messages"),
        (lambda zstd: _chunk(b"", 1 << 40, "zstd"), "damaged"),
        (lambda zstd: _chunk(b"x" * 20, 20, "zstd"), "damaged"),
        (lambda zstd: _chunk(struct.pack("<BQ", 5, 1 << 60), 9, ""), "damaged"),
        (lambda zstd: record(3, struct.pack("<HI", 1, 1 << 31)), "there are no messages"),
        (lambda zstd: b"", "there are no messages"),
        (lambda zstd: struct.pack("<BQ", 6, 1 << 60), "damaged"),
    ],
)  # fmt: skip
def test_recordings_that_claim_more_than_they_have(
    content: Callable[..., bytes], words: str, tmp_path: Path
) -> None:
    zstd = require_module("backports.zstd")
    path = tmp_path / "log.mcap"
    end = record(15, bytes(4)) + record(2, bytes(20))
    path.write_bytes(b"\x89MCAP0\r\n" + record(1, text("ros2") + text("x")) + content(zstd) + end)
    assert words in refused(path)


def _chunk(packed: bytes, size: int, compression: str) -> bytes:
    head = struct.pack("<QQQI", 0, 0, size, 0) + text(compression) + struct.pack("<Q", len(packed))
    return record(6, head + packed)


def test_a_database_whose_tables_are_queries(tmp_path: Path) -> None:
    """A view could run for ever."""
    path = tmp_path / "log.db3"
    with contextlib.closing(sqlite3.connect(path)) as base:
        base.execute("CREATE TABLE topics (id INTEGER, name TEXT, type TEXT, serialization_format TEXT)")
        base.execute("INSERT INTO topics VALUES (1, '/a', 'sensor_msgs/msg/JointState', 'cdr')")
        base.execute(
            "CREATE VIEW messages AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x FROM c) "
            "SELECT x AS id, 1 AS topic_id, x AS timestamp, x AS data FROM c"
        )
        base.commit()
    assert "no tables topics and messages: this is no recording of ROS 2" in refused(path)


def test_messages_that_are_not_of_their_type(tmp_path: Path) -> None:
    path = tmp_path / "log.db3"
    with contextlib.closing(sqlite3.connect(path)) as base:
        base.execute("CREATE TABLE topics (id INTEGER, name TEXT, type TEXT, serialization_format TEXT)")
        base.execute("CREATE TABLE messages (id INTEGER, topic_id INTEGER, timestamp INTEGER, data BLOB)")
        kinds = ("sensor_msgs/msg/JointState", "unknown/msg/Type", "sensor_msgs/msg/Image")
        for k, kind in enumerate(kinds):
            base.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr')", (k, f"/topic{k}", kind))
            for m in range(5):
                message = b"\0\1\0\0" + struct.pack("<IIII", m, m, 0, (1 << 32) - 1) + b"x" * 20
                base.execute("INSERT INTO messages VALUES (?, ?, ?, ?)", (10 * k + m, k, m, message))
        base.commit()
    result = examine(path)
    assert [one.stream.columns for one in result.streams] == []
    assert set(result.missing) == {"t", "q", "tau"}


def test_hdf5_that_points_elsewhere_is_not_followed(tmp_path: Path) -> None:
    h5py = require_module("h5py")
    secret = tmp_path / "secret.bin"
    secret.write_bytes(np.arange(50.0).tobytes())
    with h5py.File(tmp_path / "other.h5", "w") as other:
        other["q"] = np.arange(50.0)
    with h5py.File(tmp_path / "log.h5", "w") as file:
        file["link"] = h5py.ExternalLink("other.h5", "/q")
        file["soft"] = h5py.SoftLink("/own")
        file["own"] = np.arange(50.0)
        file.create_dataset("outside", (50,), "f8", external=[(str(secret), 0, 400)])
    assert examine(tmp_path / "log.h5").recording.streams[0].columns == ("own",)


@pytest.mark.usefixtures("uncollected")
def test_json_beyond_bounds(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "log.json"
    for content in ("[" * 5000, '{"a": [1, 2, 1e999]}', "{}", '["a", "b"]', "[[], []]"):
        path.write_text(content)
        refused(path)
    monkeypatch.setattr(json, "SIZE", 100)
    path.write_text("[" + "1," * 100 + "1]")
    assert "the file is too large" in refused(path)


@pytest.mark.parametrize(
    "kind",
    representative(
        (".npz", ".npy", ".mat", ".mcap", ".db3", ".json", ".h5", ".parquet", ".csv"), ".npz", ".mcap", ".csv"
    ),
)
def test_files_of_another_kind(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"log{kind}"
    for content in (b"", b"\0" * 600, b"hello\n", b"PK\x03\x04" + b"x" * 50):
        path.write_bytes(content)
        assert path.name in refused(path) or kind == ".csv"
