"""Results of real logs: each tool is measured on the same samples, tables are made of the figures alone."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn_testing import require_module

require_module("pinocchio")

from benchmarks.gap import __main__ as gap  # noqa: E402
from benchmarks.gap.robots import ARMS  # noqa: E402
from benchmarks.gap.tables import markdown, table  # noqa: E402
from benchmarks.gap.tools import Tool, _inside, measured  # noqa: E402


def test_a_run_measures_what_is_asked_for_and_keeps_the_rest(tmp_path: Path) -> None:
    gap.main(["panda_bag", "--tools", "before", "--out", str(tmp_path)])
    gap.main(["panda_bag", "--tools", "least_squares", "--out", str(tmp_path)])
    results = json.loads((tmp_path / "gap.json").read_text())
    rows = results["arms"]["panda_bag"]["rows"]
    assert [row["tool"] for row in rows] == ["before", "least_squares"]
    assert rows[1]["held_out"]["percent"][1] == pytest.approx(1.61, abs=0.01)
    assert rows[0]["held_out"]["percent"][1] > rows[1]["held_out"]["percent"][1]
    text = (tmp_path / "gap.md").read_text()
    line = "| `panda_bag` | plain least squares | 78.2 | 1.6 | 3.3 | 2.5 | 14.4 | 12.2 | 23.6 |"
    assert f"{line} {rows[1]['cpu']:.0f} |  |  |" in text
    picture = (tmp_path / "gap.svg").read_text()
    gap.main(["--render", "--out", str(tmp_path)])
    assert (tmp_path / "gap.md").read_text() == text
    assert (tmp_path / "gap.svg").read_text() == picture


def test_shares_are_of_the_samples_that_they_say(tmp_path: Path) -> None:
    arm = ARMS["panda_bag"]
    motions = arm.motions()
    tool = Tool(
        "half", "half", _inside(lambda arm, ms: [m.tau * np.where(m.held_out, 0.5, 0.1)[:, None] for m in ms])
    )
    row = gap.row(tool, arm, motions)
    assert row["held_out"]["percent"] == pytest.approx([50] * 7)
    assert row["fitted"]["percent"] == pytest.approx([10] * 7)


def test_who_is_missing_is_said() -> None:
    def absent(*_: Any) -> Any:
        raise ImportError("no module named nowhere")

    arm = ARMS["panda_bag"]
    row = gap.row(Tool("absent", "absent", _inside(absent)), arm, arm.motions())
    assert row["missing"] == "ImportError: no module named nowhere"
    results = {"arms": {"panda_bag": {"rows": [row, {**row, "held_out": {"percent": [1.0]}, "cpu": 1.0}]}}}
    assert "- absent, `panda_bag`: ImportError: no module named nowhere" in markdown(results)
    assert table(results).count("absent") == 1


def test_time_and_memory_are_those_of_the_command() -> None:
    work = "x = bytearray(200_000_000)\nimport time\nwhile time.process_time() < 0.3: pass"
    cpu, memory = measured([sys.executable, "-c", work])
    assert cpu >= 0.3
    assert 190 < memory < 260
    with pytest.raises(RuntimeError, match="exit code 2: wrong"):
        measured([sys.executable, "-c", "import sys; print('wrong', file=sys.stderr); sys.exit(2)"])
    measured([sys.executable, "-c", "import sys; sys.exit(4)"])
