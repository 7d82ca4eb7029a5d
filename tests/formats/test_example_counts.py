"""The table of operations in examples/arms/README.md is what benchmarks/arms.py makes, row by row."""

from __future__ import annotations

from pathlib import Path

import pytest
from benchmarks.arms import FOLDER, MARK, row
from benchmarks.marked import part

from robodyn_testing import representative

TABLE = part((FOLDER / "README.md").read_text(encoding="utf-8"), MARK)
ROWS = TABLE.splitlines()[2:]
ARMS = sorted(FOLDER.glob("*.yaml"))


def test_every_arm_has_a_row() -> None:
    assert [line.split("|")[1].strip() for line in ROWS] == [path.stem for path in ARMS]


@pytest.mark.parametrize("name", representative([path.stem for path in ARMS], "ur3", "xarm7"))
def test_a_row_is_what_is_counted(name: str) -> None:
    assert row(Path(FOLDER / f"{name}.yaml")) in ROWS
