"""The same numbers, byte for byte, wherever a fleet is worked out.

What goes wrong on the way is tried in tests/cluster/test_losses.py, test_store.py and test_run.py.
"""

from __future__ import annotations

import json
import random
from dataclasses import replace
from pathlib import Path

import pytest

from fleet.small_fleet import small_fleet
from robodyn.fleet.as_json import document
from robodyn.fleet.result import FleetResult
from robodyn.fleet.run import run_fleet
from robodyn.fleet.sources.fleet import Fleet
from robodyn_testing import require_module

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
