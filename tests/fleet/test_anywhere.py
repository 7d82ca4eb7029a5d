"""The same numbers, byte for byte, wherever a fleet is worked out, and whatever goes wrong on the way."""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from fleet.small_fleet import small_fleet
from robodyn.fleet.as_json import document
from robodyn.fleet.result import FleetResult
from robodyn.fleet.run import DIGESTING, STORE, run_fleet
from robodyn.fleet.sources.fleet import Fleet
from robodyn.fleet.store import open_store
from robodyn_testing import require_module
from robodyn_testing.dask_machines import Machines, kill

require_module("distributed")
pytestmark = pytest.mark.thorough


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Fleet:
    """Sixteen logs, one of which is corrupt."""
    fleet = small_fleet(tmp_path_factory.mktemp("fleet") / "logs", units=4, logs=4, seconds=3.0)
    bad = Path(fleet.logs[7].source)
    bad.write_bytes(bad.read_bytes()[:2000] + b"\0")
    return fleet


def text(result: FleetResult) -> str:
    return json.dumps(document(result))


@pytest.fixture(scope="module")
def expected(fleet: Fleet, tmp_path_factory: pytest.TempPathFactory) -> str:
    """What this process says of them, one after the other."""
    result = text(run_fleet(fleet, tmp_path_factory.mktemp("expected"), "here"))
    unused = json.loads(result)["unused"]
    assert [log["source"] for log in unused] == [fleet.logs[7].source]
    return result


@pytest.mark.parametrize("on", ["local:2", pytest.param("local:4", marks=pytest.mark.slow)])
def test_any_number_of_processes_in_any_order(on: str, fleet: Fleet, expected: str, tmp_path: Path) -> None:
    """A quarter of the logs was worked out before, and came in another order."""
    shuffled = random.Random(1).sample(fleet.logs, len(fleet.logs) // 4)
    run_fleet(replace(fleet, logs=tuple(sorted(shuffled, key=lambda log: log.order))), tmp_path, "here")
    assert text(run_fleet(fleet, tmp_path, on)) == expected


@pytest.fixture
def machines(tmp_path: Path) -> Iterator[Machines]:
    folder = tmp_path / "machines"
    folder.mkdir()
    with Machines(folder) as started:
        yield started


@pytest.mark.parametrize("lost", ["worker", pytest.param("scheduler", marks=pytest.mark.slow)])
def test_what_dies_in_the_middle(
    lost: str, machines: Machines, fleet: Fleet, expected: str, tmp_path: Path
) -> None:
    scheduler, workers = machines.scheduler(), [machines.worker(), machines.worker()]
    reported = threading.Event()

    def progress(stage: str, done: int, _: int) -> None:
        if stage == DIGESTING and done >= 4 and not reported.is_set():
            reported.set()
            if lost == "worker":
                kill(workers[0])
            else:
                kill(scheduler)
                machines.scheduler()
                machines.worker()

    result = run_fleet(fleet, tmp_path / "out", f"dask://{machines.address}", progress=progress)
    assert reported.is_set()
    assert text(result) == expected


RUN = """
import pickle, sys
from pathlib import Path
from robodyn.fleet.run import run_fleet
if __name__ == "__main__":
    fleet = pickle.loads(Path(sys.argv[1]).read_bytes())
    run_fleet(fleet, Path(sys.argv[2]), "local:1", progress=lambda *stage: print(*stage, flush=True))
"""


def test_a_run_that_is_killed_goes_on(fleet: Fleet, expected: str, tmp_path: Path) -> None:
    import pickle

    (tmp_path / "run.py").write_text(RUN)
    (tmp_path / "fleet").write_bytes(pickle.dumps(fleet))
    with subprocess.Popen(
        [sys.executable, "run.py", "fleet", "out"], cwd=tmp_path, stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
    ) as process:  # fmt: skip
        assert process.stdout is not None
        for line in process.stdout:
            if line.startswith(f"{DIGESTING} 5 "):
                process.send_signal(signal.SIGKILL)
                break
    assert process.returncode == -signal.SIGKILL
    counts: list[int] = []
    result = run_fleet(
        fleet, tmp_path / "out", "here",
        progress=lambda stage, _, of: counts.append(of) if stage == DIGESTING else None,
    )  # fmt: skip
    assert max(counts) <= len(fleet.logs) - 5  # what was done then was not done again
    assert text(result) == expected
    with open_store(tmp_path / "out" / STORE) as store:
        rows = store._connection.execute("select count(*), count(distinct key) from results").fetchone()
    assert rows == (len(fleet.logs), len(fleet.logs))
