"""docs/functions.md: every function stands there; its figures are the code's and the last comparison's."""

from __future__ import annotations

import json
import re
from types import ModuleType

import pytest
from benchmarks import dynamics, kinematics
from benchmarks.kinematics import PAGE, SHOWN, functions_table, ours

from robodyn.dynamics.functions import FUNCTIONS
from robodyn.robot import bundled_names

TEXT = PAGE.read_text(encoding="utf-8")


def table(mark: str) -> list[list[str]]:
    """The cells of a table, without its head."""
    (text,) = re.findall(rf"<!-- {mark} -->\n(.*?)<!-- end -->", TEXT, flags=re.DOTALL)
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines()[2:]]


def test_every_function_stands_there_as_it_is() -> None:
    rows = {row[0]: row[1] for row in table("functions")}
    written = functions_table({robot: {} for robot in SHOWN}).splitlines()[2:]
    expected = [[cell.strip() for cell in line.split("|")[1:-1]] for line in written]
    assert {row[0]: row[1] for row in expected} == rows, "run python -m benchmarks.kinematics"


@pytest.mark.thorough
@pytest.mark.parametrize("robot", SHOWN)
def test_operations(robot: str) -> None:
    column = 2 + SHOWN.index(robot)
    shown = {row[0].partition("(")[0].strip("`"): row[column] for row in table("functions") if row[column]}
    assert shown == {name: f"{x:,}" for name, x in ours(robot, tuple(FUNCTIONS)).items()}


@pytest.mark.parametrize(
    ("mark", "of"),
    [
        ("casadi", kinematics),
        pytest.param("casadi dynamics", dynamics, marks=pytest.mark.thorough),
    ],
)
def test_casadis_figures_are_those_of_the_last_comparison(mark: str, of: ModuleType) -> None:
    results = json.loads(of.RESULTS.read_text(encoding="utf-8"))
    counted = json.loads(of.RESULTS.with_name("functions.json").read_text(encoding="utf-8"))["robots"]
    rows = {row[0]: row[1:] for row in table(mark)}
    assert list(rows) == list(bundled_names()) == list(results)
    for robot, cells in rows.items():
        for name, cell in zip(of.NAMES, cells, strict=True):
            if name not in results[robot]:
                assert cell == ""
                continue
            mine, theirs = (int(x.replace(",", "")) for x in cell.split(" / "))
            row = counted.get(robot, {}).get(name)
            expected = row["record"]["total"] if row else ours(robot, [name])[name]
            assert (mine, theirs) == (expected, results[robot][name]), (robot, name)
            assert mine <= theirs, (robot, name)


def test_functions_of_the_text_exist() -> None:
    known = {*FUNCTIONS, "all"}
    for listed in re.findall(r"--(?:functions|fuse) ([\w,]+)", TEXT):
        assert set(listed.split(",")) <= known
