"""A worker reads the log that is meant, wherever it stands, or the run ends."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import pytest

from fleet.small_fleet import files_of, quick_diagnosis, small_fleet, write_log
from robodyn.cluster import Done, Failed
from robodyn.cluster.cluster import ThisProcess
from robodyn.errors import ToolError
from robodyn.fleet import run as run_module
from robodyn.fleet.result import FleetResult
from robodyn.fleet.run import run_fleet
from robodyn.fleet.sources.fleet import Fleet
from robodyn.logs.content import signature

Outcomes = Iterator[tuple[Any, Done | Failed]]


@dataclass
class Elsewhere:
    """A worker that was started in another ``folder``, and to which paths with ``logs`` lead ``to`` others in
    the work called ``names`` (none: in none)."""

    folder: Path
    to: str = "logs"
    names: tuple[str, ...] = ()
    count: int = 1

    def each(self, function: Callable[..., Any], tasks: Iterable[tuple[Any, tuple[Any, ...]]]) -> Outcomes:
        for key, arguments in tasks:
            if function.__name__ in self.names:
                arguments = tuple(map(self._led, arguments))
            before = Path.cwd()
            os.chdir(self.folder)
            try:
                outcomes = list(ThisProcess().each(function, [(key, arguments)]))
            finally:
                os.chdir(before)
            yield from outcomes

    def _led(self, value: Any) -> Any:
        if isinstance(value, (list, tuple)):
            return type(value)(map(self._led, value))
        return value.replace("/logs/", f"/{self.to}/") if isinstance(value, str) else value


@pytest.fixture
def fleet(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Fleet:
    """Logs by relative paths; in another folder are others by the same paths."""
    (tmp_path / "here").mkdir()
    monkeypatch.chdir(tmp_path / "here")
    fleet = small_fleet(Path("logs"), units=2, logs=2, seconds=4.0)
    (tmp_path / "there" / "logs").mkdir(parents=True)
    for log in fleet.logs:
        write_log(tmp_path / "there" / log.source, seed=1000, friction=50.0, seconds=4.0)
    shutil.copytree("logs", "others")
    for path in Path("others").iterdir():
        write_log(path, seed=2000, friction=50.0, seconds=4.0)
    return fleet


def run(fleet: Fleet, worker: Any, monkeypatch: pytest.MonkeyPatch, out: str = "out") -> FleetResult:
    @contextmanager
    def opened(on: str, **_: Any) -> Iterator[Any]:
        yield worker

    monkeypatch.setattr("robodyn.diagnose.run.diagnose", quick_diagnosis)
    monkeypatch.setattr(run_module, "open_cluster", opened)
    return run_fleet(fleet, Path(out), "here", diagnose="all", files_of=files_of)


def test_relative_paths_are_those_of_who_asks(
    fleet: Fleet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    expected = run(fleet, ThisProcess(), monkeypatch, "expected")
    assert run(fleet, Elsewhere(tmp_path / "there"), monkeypatch) == expected
    assert fleet.logs[0].source == "logs/0-0.csv"  # no path of this machine is in a result


@pytest.mark.parametrize("names", [("digest_log",), ("diagnose_unit",)])
@pytest.mark.parametrize("to", ["others", "nowhere"])
def test_a_worker_that_sees_another_file_or_none(
    names: tuple[str, ...], to: str, fleet: Fleet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(ToolError, match="a worker does not see the same file") as caught:
        run(fleet, Elsewhere(tmp_path, to, names), monkeypatch)
    assert "shared" in str(caught.value.remedy) or "share" in str(caught.value.remedy)
    assert caught.value.exit_code == 3
    assert run(fleet, ThisProcess(), monkeypatch) == run(fleet, ThisProcess(), monkeypatch, "expected")


def test_what_nobody_can_read_is_named(fleet: Fleet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A path that leads nowhere, a pipe (which nobody opens), a folder without a recording."""
    os.mkfifo("logs/pipe")
    Path("logs/folder").mkdir()
    wrong = [replace(fleet.logs[0], source=f"logs/{name}") for name in ("folder", "gone.csv", "pipe")]
    wrong[1] = replace(wrong[1], named="m.csv:3")
    logs = tuple(sorted((*wrong, *fleet.logs[1:]), key=lambda log: log.order))
    result = run(replace(fleet, logs=logs), ThisProcess(), monkeypatch)
    reasons = {log.source: log.why for log in result.unused}
    assert reasons.keys() == {log.source for log in wrong}
    assert reasons["logs/gone.csv"] == (
        "the file cannot be read: no such file or directory; m.csv:3 names it"
    )
    assert "neither a file nor a folder" in reasons["logs/pipe"]


def test_a_log_that_was_written_and_whose_time_was_set_back_is_another(tmp_path: Path) -> None:
    log = tmp_path / "log.csv"
    log.write_text("12345")
    state = log.stat()
    before = signature(str(log))[0]
    log.write_text("54321")
    os.utime(log, ns=(state.st_atime_ns, state.st_mtime_ns))
    assert signature(str(log))[0] != before
