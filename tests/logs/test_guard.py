"""A reader that ends its process, takes all memory or never comes back is a file that is refused."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.logs import guard
from robodyn.logs.arrays import recording_of_arrays
from robodyn.logs.formats import LogFormat, readable
from robodyn.logs.recording import Recording


def end(path: Path, file: str, gaps: bool) -> Recording:
    os.kill(os.getpid(), signal.SIGSEGV)
    raise AssertionError


def fill(path: Path, file: str, gaps: bool) -> Recording:
    np.ones(1 << 40)
    raise AssertionError


def wait(path: Path, file: str, gaps: bool) -> Recording:
    time.sleep(60)
    raise AssertionError


def stumble(path: Path, file: str, gaps: bool) -> Recording:
    print("a library that prints", flush=True)
    raise KeyError("a bug of a library")


def count(path: Path, file: str, gaps: bool) -> Recording:
    rows = np.arange(10.0)
    return recording_of_arrays(file, "counting", {"x": rows.shape}, {"x": rows}.__getitem__)


def opened(open: Callable[[Path, str, bool], Recording], path: Path) -> Recording:
    path.write_bytes(b"")
    with readable(path.name):
        return guard.open_guarded(LogFormat("strange", (".x",), "strange", open), path, path.name, True)


@pytest.mark.parametrize(
    ("reader", "words"),
    [
        (end, "ended the process that read it; found signal 11"),
        (fill, "does not fit into memory"),
        (wait, "took too long to read; found more than 1 s"),
        (stumble, "not strange, or damaged; found 'a bug of a library'"),
    ],
)
def test_whatever_a_reader_does_the_file_is_refused(
    reader: Callable[[Path, str, bool], Recording],
    words: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    path = tmp_path / "log.x"
    # The process has the time that it needs to begin.
    first = opened(count, path)
    monkeypatch.setattr(guard, "SECONDS", 1.0)
    del first
    with pytest.raises(InputError) as caught:
        opened(reader, path)
    assert str(caught.value).startswith("log.x: ")
    assert words in str(caught.value)
    monkeypatch.undo()
    recording = opened(count, path)
    table = recording.read(recording.streams[0], {"q": ["x"]}, None)
    np.testing.assert_array_equal(table.groups["q"][:, 0], np.arange(10.0))


def test_files_are_read_beside_each_other_and_one_process_after_the_other(tmp_path: Path) -> None:
    one, other = opened(count, tmp_path / "one.x"), opened(count, tmp_path / "other.x")
    blocks = [each.blocks(each.streams[0], {"q": ["x"]}, None) for each in (one, one, other)]
    assert [next(each).rows for each in blocks] == [10, 10, 10]
    del one, other, blocks
    waiting = [each.process.pid for each in guard._waiting]
    third = opened(count, tmp_path / "third.x")
    assert len(guard._waiting) == len(waiting) - 1
    assert third.format == "counting"
