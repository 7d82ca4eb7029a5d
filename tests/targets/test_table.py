"""The table of targets: what its files promise, and who is in which list."""

from __future__ import annotations

import subprocess
import sys
from collections import Counter
from pathlib import Path

import pytest

import robodyn.targets.processors
from robodyn.errors import InputError
from robodyn.resources import data_dir
from robodyn.targets import (
    TARGETS,
    Target,
    all_targets,
    compiled_targets,
    firmware_targets,
    planned_targets,
    target_named,
)  # fmt: skip


def test_every_file_is_a_target_of_its_name() -> None:
    folder = Path(robodyn.targets.processors.__file__).parent
    files = {path.stem.replace("_", "-") for path in folder.glob("*.py") if path.stem != "__init__"}
    assert set(TARGETS) == files
    assert [target.name for target in all_targets()] == sorted(files)
    assert "pdp-11" not in TARGETS
    with pytest.raises(KeyError):
        TARGETS["pdp-11"]


def test_no_spelling_means_two_targets_and_each_finds_its_own() -> None:
    spellings = Counter(name for target in all_targets() for name in (target.name, *target.aliases))
    assert max(spellings.values()) == 1
    for target in all_targets():
        assert all(target_named(name) is target for name in (target.name, *target.aliases))
    assert target_named("cortex-m4") is TARGETS["cortex-m4f"]
    assert target_named("cortex-m4", firmware_targets()) is TARGETS["cortex-m4f"]
    with pytest.raises(InputError, match=r"unknown target 'cortex-m5'; expected one of .*did you mean"):
        target_named("cortex-m5")


@pytest.mark.parametrize("target", all_targets(), ids=lambda target: target.name)
def test_what_a_target_says_fits_together(target: Target) -> None:
    assert (target in compiled_targets()) == (target.flags is not None)
    assert (target in planned_targets()) == (target.chip is not None)
    assert min(target.costs.mul, target.costs.add, target.costs.div, target.costs.sqrt) > 0
    if target.flags is not None:
        assert target.why
        assert target.compiled("off").endswith("-ffp-contract=off -fno-math-errno")
        assert "-ffp-contract=fast" in target.compiled("on")
    if target.costs_as:
        assert TARGETS[target.costs_as].costs == target.costs
    if target in firmware_targets():
        assert target in compiled_targets()
        assert target.board is not None
        templates = data_dir("templates") / "firmware" / target.board.architecture.name
        assert {path.name for path in templates.iterdir()} == {"startup.c.j2", "semihosting.h.j2"}
        assert target.board.ticks > 0


def test_the_names_cost_no_import_of_the_targets() -> None:
    code = (
        "import sys; from robodyn.targets import TARGETS, target_named; assert 'aarch64' in list(TARGETS); "
        "target_named('cortex-m7'); print(*sorted(m for m in sys.modules if '.processors.' in m))"
    )
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert said.split() == ["robodyn.targets.processors.cortex_m7"]
