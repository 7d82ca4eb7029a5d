"""Results are there or not there, whatever happens to the run that keeps them."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest

from robodyn.errors import InputError
from robodyn.fleet import store as store_module
from robodyn.fleet.store import Refused, key_of, open_store
from robodyn_testing import require_module


def test_what_is_kept_is_there_in_the_next_run(tmp_path: Path) -> None:
    path = tmp_path / "results" / "store.sqlite"
    with open_store(path) as store:
        assert store.result("a") is None
        store.keep("a", b"\0bytes")
        store.keep("b", Refused("too short: 3 samples"))
    with open_store(path) as store:
        assert (store.result("a"), store.result("b")) == (b"\0bytes", Refused("too short: 3 samples"))
        assert (store.refusal("a"), store.refusal("b")) == (None, "too short: 3 samples")
        assert [store.has(key) for key in "abc"] == [True, True, False]
    assert [file.name for file in path.parent.iterdir()] == ["store.sqlite"]  # no log left over


def test_a_file_is_known_by_size_and_time_unless_it_is_young(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("time.time_ns", lambda: 10_000_000_000)
    with open_store(tmp_path / "store") as store:
        store.saw("/logs/\udc80.csv", "12@7", 7_000_000_000, "hash")
        assert store.content("/logs/\udc80.csv", "12@7") == "hash"
        assert store.content("/logs/\udc80.csv", "12@8") is None
        store.saw("young.csv", "12@9", 9_000_000_000, "hash")
        assert store.content("young.csv", "12@9") is None


def test_two_runs_do_not_share_a_folder(tmp_path: Path) -> None:
    with (
        open_store(tmp_path / "store") as store,
        pytest.raises(InputError, match=r"another run holds the results; .*wait for its end"),
        open_store(tmp_path / "store"),
    ):
        store.keep("never", b"")


def test_results_of_another_version_are_dropped(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with open_store(tmp_path / "store") as store:
        store.keep("a", b"old")
    monkeypatch.setattr(store_module, "VERSION", "another")
    with open_store(tmp_path / "store") as store:
        assert store.result("a") is None


#: What a file may be in place of a store, by a program of SQL (of a store: where it begins with a store's
#: own words), and what is said of it.
NO_STORES = {
    "store;drop table results; create table notes (a)": "store of results is damaged; found no such table",
    "create table notes (text)": "this is no store of results; found another program's data",
    "store;pragma user_version = 999": "this is no store of results; found the layout of another robodyn",
    "bytes": "the store of results is damaged",
}


@pytest.mark.parametrize("kind", NO_STORES)
def test_what_is_no_store_is_left_alone(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "store"
    if kind.startswith("store;"):
        with open_store(path):
            pass
    if kind == "bytes":
        path.write_bytes(b"SQLite format 3\0" + bytes(range(256)) * 40)
    else:
        with sqlite3.connect(path) as connection:
            connection.executescript(kind.removeprefix("store;"))
        connection.close()
    before = path.read_bytes()
    with pytest.raises(InputError, match=NO_STORES[kind]) as error, open_store(path):
        pass
    assert "delete" in str(error.value)
    assert path.read_bytes() == before


#: Changes of rows, by another program, that leave the pages of SQLite whole; and what is read then.
CHANGES = [
    ("update results set value = x'0011' where key = 'a'", "a"),
    ("update results set value = null where key = 'a'", "a"),
    ("update results set value = 'text' where key = 'a'", "a"),
    ("delete from results where key = 'a'; update results set key = 'a' where key = 'c'", "a"),
    ("update results set value = (select value from results where key = 'c') where key = 'a'", "a"),
    ("update results set (value, seal) = (select value, seal from results where key = 'c')", "a"),
    ("update results set refused = 1 - refused where key = 'a'", "a"),
    ("update results set value = x'0011' where key = 'b'", "b"),
    ("update results set value = x'68' where value = cast('hash of one' as blob)", "one.csv 12@7"),
]


@pytest.mark.parametrize(("change", "read"), CHANGES)
def test_what_was_kept_of_another_log_is_not_used(
    change: str, read: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """SQLite notices damaged pages; what is in them it does not check."""
    monkeypatch.setattr("time.time_ns", lambda: 10_000_000_000)
    path = tmp_path / "store"
    with open_store(path) as store:
        for key, value in (("a", b"one"), ("b", Refused("no motion")), ("c", b"another")):
            store.keep(key, value)
        store.saw("one.csv", "12@7", 0, "hash of one")
        store.saw("two.csv", "12@8", 0, "hash of two")
    with sqlite3.connect(path) as connection:
        connection.executescript(change)
    connection.close()
    with open_store(path) as store:
        reads = store.refusal if read == "b" else store.result if read == "a" else store.content
        with pytest.raises(InputError, match="found a row that differs from its checksum; delete it"):
            reads(*read.split())
        assert "seal" in change or store.content("two.csv", "12@8") == "hash of two"
        assert read in "ab" or store.refusal("b") == "no motion"


def test_a_store_is_not_written_through_a_link(tmp_path: Path) -> None:
    (tmp_path / "precious").touch()
    (tmp_path / "store").symlink_to("precious")
    with pytest.raises(InputError, match="symbolic link"), open_store(tmp_path / "store"):
        pass
    assert (tmp_path / "precious").read_bytes() == b""


KEEPS = """
import sys
from collections.abc import Callable
from pathlib import Path
from robodyn.fleet.store import open_store
{before}
with open_store(Path(sys.argv[1])) as store:
    for k in range(100000):
        store.keep(str(k), bytes([k % 251]) * 5000)
        print(k, flush=True)
"""


def keeping(path: Path, before: str = "") -> subprocess.Popen[str]:
    """A process that keeps one result after the other, and says which it has kept."""
    return subprocess.Popen(
        [sys.executable, "-c", KEEPS.format(before=before), path],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    )


def check(path: Path, last: int) -> None:
    """All results up to the ``last`` are there, and right."""
    with open_store(path) as store:
        for k in range(last + 1):
            assert store.result(str(k)) == bytes([k % 251]) * 5000


def test_a_run_that_is_killed_has_kept_what_it_had(tmp_path: Path) -> None:
    path = tmp_path / "store"
    with keeping(path) as process:
        assert process.stdout is not None
        for _ in range(500):
            last = int(process.stdout.readline())
        process.send_signal(signal.SIGKILL)
        last = max([last, *map(int, process.stdout.read().split()[:-1])])
    check(path, last)


def test_a_disk_without_room_costs_nothing_that_was_kept(tmp_path: Path) -> None:
    require_module("resource")
    path = tmp_path / "store"
    limit = "import resource; resource.setrlimit(resource.RLIMIT_FSIZE, (2_000_000, 2_000_000))"
    with keeping(path, limit) as process:
        lines, errors = process.communicate()
    assert "OutputError" in errors
    assert "free some space and run it again: what is done is kept" in errors
    last = int(lines.split()[-1])
    assert last > 100
    check(path, last)


def test_keys_differ_wherever_their_parts_do() -> None:
    several = [("a", "b"), ("ab", ""), ("", "ab"), ("a", "b", ""), ("b", "a"), ("a\udc80", "b")]
    assert len({key_of(*parts) for parts in several}) == len(several)
    assert key_of("a", "b") == key_of("a", "b")
