"""``robodyn schedule``: figures, JSON, sweeps, pictures, emission, and what is refused."""

from __future__ import annotations

import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest

from robodyn.schedule import METHODS, faults_of_levels, general_graph
from robodyn_cli import schedule_options
from robodyn_cli.main import main
from robodyn_testing import representative, require_module, require_tool

Capture = pytest.CaptureFixture[str]
#: What CONTRACT promises.
KEYS = {
    "robot", "method", "processors", "tasks", "levels", "critical_path", "lower_bound", "optimal", "speedup",
    "efficiency", "slots", "thesis",
}  # fmt: skip


def run(capsys: Capture, *arguments: str, code: int = 0) -> tuple[str, str]:
    assert main(["schedule", *arguments]) == code
    out, err = capsys.readouterr()
    assert "Traceback" not in err
    return out, err


def made(capsys: Capture, *arguments: str) -> Any:
    return json.loads(run(capsys, *arguments, "--json")[0])


def test_the_json_that_others_rely_on(capsys: Capture) -> None:
    found = made(capsys, "--links", "6", "-p", "8", "--method", "thesis")
    assert found.keys() >= KEYS
    figures = {key: found[key] for key in KEYS - {"slots", "speedup", "efficiency"}}
    assert figures == {
        "robot": "6 links", "method": "thesis", "processors": 8, "tasks": 231, "levels": 32,
        "critical_path": 27, "lower_bound": 30, "optimal": False, "thesis": {"levels": 31, "table": "C.7"},
    }  # fmt: skip
    assert found["speedup"] == pytest.approx(231 / 32)
    assert found["efficiency"] == pytest.approx(231 / 256)
    assert len(found["slots"]) == 32
    assert {len(row) for row in found["slots"]} == {8}
    assert faults_of_levels(general_graph(6).after, 8, found["slots"]) == found["faults"] == []


@pytest.mark.parametrize("n", range(2, 13))
def test_tasks_and_layers_of_any_arm(n: int, capsys: Capture) -> None:
    found = made(capsys, "--links", str(n), "-p", "4")
    assert (found["tasks"], found["critical_path"]) == (43 * n - 27, 4 * n + 3)


def test_the_stanford_arm_by_rule_and_as_printed(capsys: Capture) -> None:
    by_rule = made(capsys, "stanford", "-p", "8")
    assert (by_rule["tasks"], by_rule["critical_path"], by_rule["levels"]) == (154, 25, 25)
    assert (by_rule["printed"]["tasks"], by_rule["printed"]["layers"]) == (156, 27)
    assert by_rule["thesis"] == {"levels": 27, "table": "C.15"}
    text = run(capsys, "stanford", "-p", "8")[0]
    for words in ("156 tasks in 27 layers", "154", "subtotal 10", "25"):
        assert words in text
    printed = made(capsys, "stanford", "-p", "8", "--as-printed")
    assert (printed["tasks"], printed["levels"]) == (156, 25)


def test_the_methods_that_the_command_offers() -> None:
    assert schedule_options.METHODS == METHODS


@pytest.mark.parametrize("method", ["df-ihs", "a-star"])
def test_searches_say_what_they_looked_at(method: str, capsys: Capture) -> None:
    asked = ("stanford", "-p", "4", "--as-printed", "--method", method)
    found = made(capsys, *asked)
    assert (found["levels"], found["optimal"], found["ended"]) == (39, True, "proven")
    assert f"looked at {found['nodes']} nodes; nothing shorter exists" in run(capsys, *asked)[0]
    short = made(capsys, *asked, "--nodes", "1")
    assert (short["levels"], short["optimal"], short["ended"]) == (40, False, "nodes")
    text = run(capsys, *asked, "--nodes", "1")[0]
    assert "gave up there: --nodes for more" in text
    assert "at most 2.6 % above the optimum (none below 39)" in text
    assert "nothing was left to search" in run(capsys, "stanford", "-p", "8", "--method", method)[0]


def test_friction_as_tasks(capsys: Capture, tmp_path: Path) -> None:
    found = made(capsys, "--links", "6", "-p", "6", "--friction", "both")
    assert (found["tasks"], found["critical_path"], found["levels"]) == (280, 32, 47)
    assert found["without_friction"] == {"tasks": 231, "critical_path": 27}
    assert found["faults"] == []
    assert made(capsys, "--links", "6", "-p", "6", "--friction", "none")["without_friction"] is None
    picture = tmp_path / "sweep.svg"
    text, _ = run(capsys, "puma560_3dof_d12", "-p", "2..5", "--friction", "joint", "--picture", str(picture))
    assert "19 tasks more, and 3 levels more" in text
    assert {"with friction", "without friction"} <= {
        "".join(one.itertext()).strip() for one in ET.parse(picture).iter()
    }
    out, err = run(capsys, "puma560", "-p", "2", "--friction", "both", "--cut", "3", code=2)
    assert out == ""
    assert "leave out --cut" in err


def test_optimal_needs_or_tools(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ortools.sat.python", None)
    out, err = run(capsys, "stanford", "-p", "4", "--as-printed", "--method", "optimal", code=3)
    assert out == ""
    assert "pip install" in err


def test_the_optimum(capsys: Capture) -> None:
    require_module("ortools")
    found = made(capsys, "stanford", "-p", "4", "--as-printed", "--method", "optimal")
    assert (found["levels"], found["optimal"], found["lower_bound"]) == (39, True, 39)


def test_a_sweep(capsys: Capture, tmp_path: Path) -> None:
    found = made(capsys, "--links", "6", "-p", "2..4,13")
    assert [one["processors"] for one in found] == [2, 3, 4, 13]
    picture = tmp_path / "sweep.svg"
    text = run(capsys, "stanford", "-p", "2..8", "--method", "thesis", "--picture", str(picture))[0]
    assert "27 (C.15)" in text
    titles = "".join(ET.parse(picture).getroot().itertext())
    for words in (
        "Speed-up",
        "Efficiency",
        "Table 4.8",
        "Kasahara and Narita 1985",
        "printed",
        "critical-path",
    ):
        assert words in titles


def test_pictures(capsys: Capture, tmp_path: Path) -> None:
    gantt, layers = tmp_path / "gantt.svg", tmp_path / "layers.svg"
    run(capsys, "stanford", "-p", "4", "--picture", str(gantt), "--layers", str(layers))
    for picture in (gantt, layers):
        root = ET.parse(picture).getroot()
        boxes = list(root.iter("{http://www.w3.org/2000/svg}rect"))
        assert len(boxes) == 154  # tasks
    again = gantt.read_bytes()
    run(capsys, "stanford", "-p", "4", "--picture", str(gantt))
    assert gantt.read_bytes() == again


def test_a_kernel_cut(capsys: Capture) -> None:
    found = made(capsys, "puma560", "-p", "10", "--cut", "1")
    assert (found["tasks"], found["critical_path"], found["levels"]) == (262, 28, 28)
    fewest = made(capsys, "puma560", "--cut", "1", "--fewest")
    assert (fewest["processors"], fewest["at_least"], fewest["proven"]) == (10, 10, True)
    assert "10 processors" in run(capsys, "puma560", "--cut", "1", "--fewest")[0]
    fast = made(capsys, "puma560", "-p", "2", "--cut", "3", "--optimize", "fast", "--functions", "gravity")
    assert fast["tasks"] < 30
    slow = made(capsys, "puma560", "-p", "4", "--cut", "1", "--cost", "mul=3,sincos=40", "--no-levels",
                "--communication", "5")  # fmt: skip
    assert slow["work"] > 600
    assert not slow["synchronised"]
    assert slow["levels"] == slow["time"] > slow["times"][-1]
    assert len(slow["slots"]) == len(slow["times"])


def test_costs_of_the_thesis_s_tasks(capsys: Capture) -> None:
    """A multiplication three times as long as an addition: a task of products 9, one of sums 3."""
    found = made(capsys, "--links", "6", "-p", "4", "--cost", "mul=3,add=1")
    even = made(capsys, "--links", "6", "-p", "4", "--cost", "mul=1,add=1")
    assert even["work"] == 3 * 231
    assert 3 * 231 < found["work"] < 9 * 231
    assert found["time"] >= found["lower_bound"] > even["lower_bound"]


def test_logarithmic_forms(capsys: Capture) -> None:
    found = made(capsys, "--forms", "--links", "6")
    assert found["shorter_from"]["lee-chang"] == {
        "newton-euler": 3,
        "modified newton-euler": 3,
        "thesis_tasks": 2,
    }
    assert "lathrop" in run(capsys, "--forms", "--links", "4")[0]
    one = made(capsys, "--links", "6", "--form", "lathrop", "-p", "64")
    assert one["levels"] == one["critical_path"] == found["rows"][-1]["lathrop"]["chain"]


@pytest.mark.parametrize("table", representative(["4.3", "C.4", "c.4", "4.8", "all"], "4.3", "c.4"))
def test_printed_tables(table: str, capsys: Capture) -> None:
    text = run(capsys, "--thesis", table)[0]
    found = made(capsys, "--thesis", table)
    assert found["title"] in text
    if table in ("C.4", "c.4"):
        assert "401 in level 6" in text
        assert found["id"] == table


def test_emission(capsys: Capture, tmp_path: Path) -> None:
    folder = tmp_path / "out"
    _, err = run(capsys, "puma560_3dof", "-p", "2", "-o", str(folder), "--packed", "4")
    names = {path.name for path in folder.iterdir()}
    stem = "puma560_3dof"
    assert names == {f"{stem}.h", f"{stem}.c", *(f"{stem}_{what}" for what in (
        "parallel.h", "parallel.c", "parallel_check.c", "packed.h", "packed.c"))}  # fmt: skip
    assert err.count("wrote") == 7
    # The serial kernel is that of gen, bit for bit, save the notes at its head.
    assert (
        main(["gen", stem, "-o", str(tmp_path / "gen"), "--functions", "inverse_dynamics", "--lang", "c"])
        == 0
    )
    body = [(tmp_path / place / f"{stem}.c").read_text().partition("#include")[2] for place in ("gen", "out")]
    assert body[0] == body[1]
    sources = [f"{stem}{what}.c" for what in ("", "_parallel", "_packed", "_parallel_check")]
    command = [require_tool("gcc"), "-std=c11", "-O2", "-pthread", "-ffp-contract=off", *sources, "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    done = subprocess.run(["./a.out", "200"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("states 200 differing 0")
    assert "packed_ns" in done.stdout


def test_the_thesis_s_own_tasks_emitted(capsys: Capture, tmp_path: Path) -> None:
    run(capsys, "stanford", "-p", "3", "--cut", "thesis", "-o", str(tmp_path), "--method", "thesis")
    assert "T12_" in (tmp_path / "stanford_parallel.c").read_text()
