"""Processes that end in the middle of the work, and whole machines: nothing is lost, nothing comes twice."""

from __future__ import annotations

import logging
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from cluster.functions import deadly, note
from robodyn.cluster import Done, Failed, open_cluster
from robodyn.errors import ToolError
from robodyn_testing import require_module
from robodyn_testing.dask_machines import Machines, kill
from robodyn_testing.waiting import eventually, runs

require_module("distributed")
pytestmark = pytest.mark.thorough


@pytest.fixture
def notes(tmp_path: Path) -> Path:
    folder = tmp_path / "notes"
    folder.mkdir()
    return folder


def worked(notes: Path, x: int) -> list[int]:
    """The processes that have worked on ``x``."""
    return [int(line) for line in (notes / str(x)).read_text().split()]


def test_a_piece_that_ends_its_process_is_named_and_no_other_is() -> None:
    with open_cluster("local:2") as cluster:
        results = dict(cluster.each(deadly, ((k, (k,)) for k in range(12))))
    failed = results.pop(3)
    assert results == {k: Done(k) for k in range(12) if k != 3}
    assert isinstance(failed, Failed)
    assert isinstance(failed.error, ToolError)
    assert "ends, time and again; found 8 processes lost" in str(failed.error)


@pytest.mark.parametrize(
    "lost",
    ["worker", "scheduler", *(pytest.param(lost, marks=pytest.mark.slow) for lost in ("nanny", "all"))],
)
def test_what_is_lost_is_done_again(
    lost: str, tmp_path: Path, notes: Path, caplog: pytest.LogCaptureFixture
) -> None:
    caplog.set_level(logging.WARNING)
    keys: list[int] = []
    with Machines(tmp_path) as machines:
        scheduler, workers = machines.scheduler(), [machines.worker(), machines.worker()]
        with open_cluster(f"dask://{machines.address}") as cluster:
            for key, result in cluster.each(note, ((k, (str(notes), k, 0.02)) for k in range(100))):
                assert result == Done(key)
                keys.append(key)
                if len(keys) != 30:
                    continue
                if lost == "worker":  # one that is in the middle of another piece by now
                    os.kill(worked(notes, key)[-1], signal.SIGKILL)
                if lost == "nanny":
                    kill(workers[0])
                if lost in ("scheduler", "all"):
                    kill(scheduler)
                    if lost == "all":
                        for worker in workers:
                            kill(worker)
                    machines.scheduler()
                    for _ in workers:  # the others end with their scheduler
                        machines.worker()
    assert sorted(keys) == list(range(100))
    warnings = [record for record in caplog.records if record.name == "robodyn.cluster"]
    assert bool(warnings) == (lost in ("scheduler", "all"))


def test_one_that_is_told_to_end_ends_with_its_processes(tmp_path: Path, notes: Path) -> None:
    script = tmp_path / "script.py"
    script.write_text(
        "from cluster.functions import note\n"
        "from robodyn.cluster import open_cluster\n"
        "if __name__ == '__main__':\n"
        "    try:\n"
        "        with open_cluster('local:2') as cluster:\n"
        f"            tasks = ((k, ({str(notes)!r}, k, 0.05)) for k in range(9999))\n"
        "            for key, _ in cluster.each(note, tasks):\n"
        "                print(f'{key}\\n', end='', flush=True)  # in one piece\n"
        "    except KeyboardInterrupt:\n"
        "        print('end', flush=True)\n",
        encoding="utf-8",
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    with subprocess.Popen(
        [sys.executable, script], stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment,
        start_new_session=True, text=True,
    ) as process:  # fmt: skip
        assert process.stdout is not None
        lines = [process.stdout.readline() for _ in range(5)]
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all of them
        rest, errors = process.communicate(timeout=60)
    assert errors == ""
    assert rest.splitlines()[-1] == "end"
    done = {int(line) for line in [*lines, *rest.splitlines()[:-1]]}
    processes = {pid for k in done for pid in worked(notes, k)}
    assert len(processes) == 2
    assert eventually(lambda: not any(runs(pid) for pid in processes))
