"""Processes that help: they work, and whatever ends them or the one that asks, nothing is said twice."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import InputError, ToolError
from robodyn.toolchain import workers
from robodyn.toolchain.workers import Workers
from robodyn_testing import covering
from robodyn_testing.waiting import eventually, runs

pytestmark = pytest.mark.skipif(not hasattr(os, "killpg"), reason="missing: os.killpg; only POSIX has it")


def processes(helpers: Workers) -> list[Any]:
    return helpers._processes


def test_work_is_shared_out() -> None:
    for count in (1, 2):
        with Workers(count) as helpers:
            assert helpers.run(divmod, [(7, 2), (9, 4)]) == [(3, 1), (2, 1)]
            assert helpers.run(len, [("abc",)]) == [3]
            with pytest.raises(ZeroDivisionError):
                helpers.run(divmod, [(7, 0)])
        assert all(process.returncode is not None for process in processes(helpers))


def test_more_tasks_than_processes_are_done_as_these_become_free() -> None:
    for count in (1, 3):
        begun: list[int] = []
        with Workers(count) as helpers:
            done = dict(helpers.each(divmod, [(k, 3) for k in range(7)], begun.append))
            with pytest.raises(ZeroDivisionError):
                dict(helpers.each(divmod, [(7, 1), (7, 0)]))
        assert done == {k: divmod(k, 3) for k in range(7)}
        assert begun == list(range(7))


def test_one_that_ends_among_many_tasks() -> None:
    with Workers(2) as helpers:
        victim = processes(helpers)[0].pid
        work = helpers.each(os.kill, [(victim, 0), (victim, 0), (victim, signal.SIGKILL)] * 2)
        with pytest.raises(ToolError, match="found signal 9"):
            list(work)


@pytest.mark.parametrize(
    ("number", "when"), covering([signal.SIGKILL, signal.SIGTERM], ["before", "between", "at work"])
)
def test_a_process_that_is_killed(
    number: signal.Signals, when: str, capfd: pytest.CaptureFixture[str]
) -> None:
    with Workers(2) as helpers:
        if when == "between":
            helpers.run(len, [("a",), ("b",)])
        victim = processes(helpers)[1]
        tasks: list[tuple[Any, ...]] = [("a",), ("b",)]
        if when == "at work":
            tasks = [(victim.pid, 0), (victim.pid, number)]
        else:
            victim.send_signal(number)
            victim.wait()
        with pytest.raises(
            ToolError, match=rf"ended before its work was done; found signal {number:d};"
        ) as e:
            helpers.run(os.kill if when == "at work" else len, tasks)
    assert e.value.exit_code == 3
    assert all(process.returncode is not None for process in processes(helpers))
    assert capfd.readouterr() == ("", "")


def test_a_process_that_cannot_begin(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(workers, "_SERVE", workers._SERVE.format("robodyn.nothing"))
    with pytest.raises(ToolError, match="found exit status 1"), Workers(2) as helpers:
        helpers.run(len, [("a",), ("b",)])
    assert capfd.readouterr() == ("", "")


def test_one_of_two_that_cannot_be_started(monkeypatch: pytest.MonkeyPatch) -> None:
    started: list[Any] = []
    start = subprocess.Popen

    def second(*command: Any, **how: Any) -> Any:
        if started:
            raise OSError(24, "Too many open files")
        started.append(start(*command, **how))
        return started[0]

    monkeypatch.setattr(subprocess, "Popen", second)
    with pytest.raises(OSError, match="Too many"), Workers(2):
        pytest.fail("one is missing")
    assert started[0].returncode is not None


ASKS = """
import os, sys, time
from robodyn.toolchain.workers import Workers
with Workers(2) as helpers:
    print(*(process.pid for process in helpers._processes), flush=True)
    helpers.run(time.sleep, [(0,), (0,)])
    print("ready", flush=True)
    helpers.run({work})
"""


@pytest.mark.parametrize(
    ("number", "work"),
    covering(
        [signal.SIGINT, signal.SIGTERM, signal.SIGKILL],
        ["time.sleep, [(0.5,), (0.5,)]", "bytes, [(1 << 24,), (1 << 24,)]"],
    ),
)
def test_one_that_asks_and_goes(number: signal.Signals, work: str, tmp_path: Path) -> None:
    """Nothing of the processes that help is on stderr, and none of them stays."""
    script = tmp_path / "asks.py"
    script.write_text(ASKS.format(work=work))
    asks = subprocess.Popen(
        [sys.executable, str(script)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
        start_new_session=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    assert asks.stdout is not None
    helpers = [int(text) for text in asks.stdout.readline().split()]
    asks.stdout.readline()
    os.killpg(asks.pid, number)
    _, err = asks.communicate()  # ends when the last of them has
    assert err.count("Traceback") == (1 if number == signal.SIGINT else 0)  # that of the script itself
    assert eventually(lambda: not any(map(runs, helpers)))


def test_an_error_of_the_work_is_that_of_the_work() -> None:
    with Workers(2) as helpers, pytest.raises(InputError, match="wrong"):
        helpers.run(fails, [(), ()])


def fails() -> None:
    raise InputError("wrong")
