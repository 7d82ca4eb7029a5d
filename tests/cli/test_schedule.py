"""``robodyn schedule``: figures, JSON, sweeps, pictures, emission."""

from __future__ import annotations

import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path
from typing import Any

import pytest

from cli.command import Capture, run, run_json
from robodyn.schedule import METHODS, faults_of_levels, general_graph
from robodyn.thesis.logarithmic import FORMS
from robodyn_cli import schedule_options
from robodyn_testing import representative, require_module, require_tool

pytestmark = pytest.mark.usefixtures("elsewhere")


def text(capsys: Capture, words: str) -> str:
    return run(capsys, f"schedule {words}")[0]


def made(capsys: Capture, words: str) -> Any:
    return run_json(capsys, f"schedule {words}")


def test_the_json_that_others_rely_on(capsys: Capture) -> None:
    found = made(capsys, "--links 6 -p 8 --method thesis")
    # What CONTRACT promises.
    assert {
        "robot": "6 links", "method": "thesis", "processors": 8, "tasks": 231, "levels": 32,
        "critical_path": 27, "lower_bound": 30, "optimal": False, "thesis": {"levels": 31, "table": "C.7"},
        "speedup": pytest.approx(231 / 32), "efficiency": pytest.approx(231 / 256), "slots": found["slots"],
    }.items() <= found.items()  # fmt: skip
    assert len(found["slots"]) == 32
    assert {len(row) for row in found["slots"]} == {8}
    assert faults_of_levels(general_graph(6).after, 8, found["slots"]) == found["faults"] == []


def test_the_stanford_arm_by_rule_and_as_printed(capsys: Capture) -> None:
    by_rule = made(capsys, "stanford -p 8")
    assert (by_rule["tasks"], by_rule["critical_path"], by_rule["levels"]) == (154, 25, 25)
    assert (by_rule["printed"]["tasks"], by_rule["printed"]["layers"]) == (156, 27)
    assert by_rule["thesis"] == {"levels": 27, "table": "C.15"}
    for words in ("156 tasks in 27 layers", "154", "subtotal 10", "25"):
        assert words in text(capsys, "stanford -p 8")
    printed = made(capsys, "stanford -p 8 --as-printed")
    assert (printed["tasks"], printed["levels"]) == (156, 25)


@pytest.mark.parametrize("method", ["df-ihs", "a-star"])
def test_searches_say_what_they_looked_at(method: str, capsys: Capture) -> None:
    asked = f"stanford -p 4 --as-printed --method {method}"
    found = made(capsys, asked)
    assert (found["levels"], found["optimal"], found["ended"]) == (39, True, "proven")
    assert f"looked at {found['nodes']} nodes; nothing shorter exists" in text(capsys, asked)
    short = made(capsys, f"{asked} --nodes 1")
    assert (short["levels"], short["optimal"], short["ended"]) == (40, False, "nodes")
    said = text(capsys, f"{asked} --nodes 1")
    assert "gave up there: --nodes for more" in said
    assert "at most 2.6 % above the optimum (none below 39)" in said
    assert "nothing was left to search" in text(capsys, f"stanford -p 8 --method {method}")


def test_friction_as_tasks(capsys: Capture) -> None:
    found = made(capsys, "--links 6 -p 6 --friction both")
    assert (found["tasks"], found["critical_path"], found["levels"]) == (280, 32, 47)
    assert found["without_friction"] == {"tasks": 231, "critical_path": 27}
    assert found["faults"] == []
    said = text(capsys, "puma560_3dof_d12 -p 2..5 --friction joint --picture sweep.svg")
    assert "19 tasks more, and 3 levels more" in said
    titles = {"".join(one.itertext()).strip() for one in ET.parse("sweep.svg").iter()}
    assert {"with friction", "without friction"} <= titles
    assert "leave out --cut" in run(capsys, "schedule puma560 -p 2 --friction both --cut 3", code=2)[1]


def test_the_optimum(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    assert schedule_options.METHODS == METHODS
    assert set(schedule_options.FORMS) == set(FORMS)
    require_module("ortools")
    asked = "stanford -p 4 --as-printed --method optimal"
    found = made(capsys, asked)
    assert (found["levels"], found["optimal"], found["lower_bound"]) == (39, True, 39)
    monkeypatch.setitem(sys.modules, "ortools.sat.python", None)
    out, err = run(capsys, f"schedule {asked}", code=3)
    assert out == ""
    assert "pip install" in err


def test_a_sweep_and_pictures(capsys: Capture) -> None:
    found = made(capsys, "--links 6 -p 2..4,13")
    assert [one["processors"] for one in found] == [2, 3, 4, 13]
    assert "27 (C.15)" in text(capsys, "stanford -p 2..8 --method thesis --picture sweep.svg")
    titles = "".join(ET.parse("sweep.svg").getroot().itertext())
    for words in ("Speed-up", "Efficiency", "Table 4.8", "Kasahara and Narita 1985", "critical-path"):
        assert words in titles
    text(capsys, "stanford -p 4 --picture gantt.svg --layers layers.svg")
    for picture in ("gantt.svg", "layers.svg"):
        boxes = ET.parse(picture).getroot().iter("{http://www.w3.org/2000/svg}rect")
        assert len(list(boxes)) == 154  # tasks
    text(capsys, "stanford -p 4 --picture again.svg")
    assert Path("gantt.svg").read_bytes() == Path("again.svg").read_bytes()


def test_a_kernel_cut(capsys: Capture) -> None:
    found = made(capsys, "puma560 -p 10 --cut 1")
    assert (found["tasks"], found["critical_path"], found["levels"]) == (262, 28, 28)
    fewest = made(capsys, "puma560 --cut 1 --fewest")
    assert (fewest["processors"], fewest["at_least"], fewest["proven"]) == (10, 10, True)
    assert "10 processors" in text(capsys, "puma560 --cut 1 --fewest")
    assert made(capsys, "puma560 -p 2 --cut 3 --optimize fast --functions gravity")["tasks"] < 30
    slow = made(capsys, "puma560 -p 4 --cut 1 --cost mul=3,sincos=40 --no-levels --communication 5")
    assert slow["work"] > 600
    assert not slow["synchronised"]
    assert slow["levels"] == slow["time"] > slow["times"][-1]
    assert len(slow["slots"]) == len(slow["times"])


def test_logarithmic_forms(capsys: Capture) -> None:
    found = made(capsys, "--forms --links 6")
    shorter = {"newton-euler": 3, "modified-newton-euler": 3, "thesis_tasks": 2}
    assert found["shorter_from"]["lee-chang"] == shorter
    assert "lathrop" in text(capsys, "--forms --links 4")
    one = made(capsys, "--links 6 --form lathrop -p 64")
    assert one["levels"] == one["critical_path"] == found["rows"][-1]["lathrop"]["chain"]


@pytest.mark.parametrize("table", representative(["4.3", "C.4", "c.4", "4.8", "all"], "4.3", "c.4"))
def test_printed_tables(table: str, capsys: Capture) -> None:
    found = made(capsys, f"--thesis {table}")
    said = text(capsys, f"--thesis {table}")
    assert found["title"] in said
    if table in ("C.4", "c.4"):
        assert "401 in level 6" in said
        assert found["id"] == table


def test_emission(elsewhere: Path, capsys: Capture) -> None:
    stem, folder = "puma560_3dof", elsewhere / "out"
    _, err = run(capsys, f"schedule {stem} -p 2 -o out --packed 4")
    assert {path.name for path in folder.iterdir()} == {f"{stem}{end}" for end in (
        ".h", ".c", "_parallel.h", "_parallel.c", "_parallel_check.c", "_packed.h", "_packed.c")}  # fmt: skip
    assert err.count("wrote") == 7
    # The serial kernel is that of gen, bit for bit, save the notes at its head.
    run(capsys, f"gen {stem} -o gen --functions inverse_dynamics --lang c")
    gen, out = (Path(place, f"{stem}.c").read_text().partition("#include")[2] for place in ("gen", "out"))
    assert gen == out
    sources = [f"{stem}{end}.c" for end in ("", "_parallel", "_packed", "_parallel_check")]
    command = [require_tool("gcc"), "-std=c11", "-O2", "-pthread", "-ffp-contract=off", *sources, "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    done = subprocess.run(["./a.out", "200"], cwd=folder, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("states 200 differing 0")
    assert "packed_ns" in done.stdout
    text(capsys, "stanford -p 3 --cut thesis -o own --method thesis")
    assert "T12_" in Path("own/stanford_parallel.c").read_text()
