"""Figures and commands in README.md and docs/*.md are those of the code, not typed from memory."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from benchmarks import counts
from benchmarks.batch.__main__ import tables as batch_tables
from benchmarks.blind_arms.cases import INSIDE
from benchmarks.cuda.__main__ import SHOWN as CUDA_SHOWN
from benchmarks.cuda.__main__ import table as cuda_table
from benchmarks.gap.documents import tables
from benchmarks.marked import part, with_part

from robodyn import errors
from robodyn.effects.catalogue import CATALOGUE
from robodyn.kernels.generate import Options, generate
from robodyn.robot import load
from robodyn.thesis.tables import make
from robodyn.thesis.tables.pictures import robots_svg
from robodyn_testing import require_machine, require_tool

ROOT = Path(__file__).parents[1]
DOCUMENTS = {
    path.name: path.read_text(encoding="utf-8")
    for path in (ROOT / "README.md", *(ROOT / "docs").glob("*.md"))
}


def cells(text: str) -> list[list[str]]:
    """The cells of a table in Markdown, row by row, without its head."""
    rows = [line for line in text.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in row.split("|")[1:-1]] for row in rows[2:]]


def test_the_effects_of_later_days_are_named() -> None:
    later = [f"`{id}`" for id in CATALOGUE if id not in INSIDE]
    assert f"catalogue but {' and '.join(later)}" in DOCUMENTS["diagnose.md"]


@pytest.mark.thorough
def test_the_operations_of_all_robots_are_recomputed() -> None:
    page, table = DOCUMENTS["operation-counts.md"], make("robots")
    assert with_part(page, counts.MARK, counts.markdown(table)) == page, "run python -m benchmarks.counts"
    assert counts.PICTURE.read_text(encoding="utf-8") == robots_svg(table)


TABLES = [
    *tables(),
    ("docs/batch.md", "batch speed", "batch.json", lambda it: batch_tables(it)[0]),
    ("docs/cuda.md", "cuda kernels", "cuda.json", lambda it: cuda_table(it, CUDA_SHOWN)),
]


@pytest.mark.parametrize(("document", "mark", "results", "made"), TABLES, ids=lambda x: str(x)[:20])
def test_tables_of_benchmarks_are_those_of_the_results(
    document: str, mark: str, results: str, made: Callable[[Any], str]
) -> None:
    figures = json.loads((ROOT / "benchmarks" / "results" / results).read_text(encoding="utf-8"))
    assert part((ROOT / document).read_text(encoding="utf-8"), mark).strip() == made(figures).strip()
    assert made(figures).count("\n") > 2


def test_the_exit_codes_are_those_of_the_errors() -> None:
    section = DOCUMENTS["tour.md"].partition("## Exit codes")[2].partition("\n## ")[0]
    codes = {int(code) for row in cells(section) for code in row[0].split(",")}
    raised = {
        one.exit_code
        for one in vars(errors).values()
        if isinstance(one, type) and issubclass(one, errors.RobodynError)
    }
    assert raised <= codes
    assert codes - raised == {4, 70, 129, 130, 143}


def test_the_readable_lines_in_kernels_are_emitted() -> None:
    section = DOCUMENTS["kernels.md"].partition("## Every line named")[2]
    (shown,) = re.findall(r"```c\n(.*?)```", section.partition("\n## ")[0], flags=re.DOTALL)
    options = Options(functions=("inverse_dynamics",), readable=True)
    assert shown in generate(load("puma560", warn=lambda _: None), options).files(("c",))["puma560.c"]


@pytest.mark.parametrize(
    ("functions", "flags", "called"),
    [
        (None, (), set()),
        (("inverse_kinematics",), (), {"sqrt"}),
        (("inverse_kinematics",), ("-fno-math-errno",), set()),
    ],
)
def test_what_kernels_with_built_in_sines_call(
    functions: tuple[str, ...] | None, flags: tuple[str, ...], called: set[str], tmp_path: Path
) -> None:
    """As docs/kernels.md says."""
    gcc, nm = require_tool("gcc"), require_tool("nm")
    for name, text in generate(load("ur5"), Options(functions, trig="builtin")).files(("c",)).items():
        (tmp_path / name).write_text(text, encoding="ascii")
    subprocess.run([gcc, "-std=c99", "-O2", *flags, "-c", "ur5.c"], cwd=tmp_path, check=True)
    listed = subprocess.run([nm, "-u", "ur5.o"], cwd=tmp_path, check=True, capture_output=True, text=True)
    assert set(re.findall(r"\bU (\w+)", listed.stdout)) - {"memset"} == called


@pytest.mark.thorough
@pytest.mark.parametrize(("trig", "options"), [("builtin", ()), ("given", ()), ("libm", ())])
def test_the_instructions_are_measured(trig: str, options: tuple[str, ...]) -> None:
    require_tool("valgrind")
    gcc = require_tool("gcc")
    version = subprocess.run([gcc, "-dumpversion"], capture_output=True, text=True, check=True).stdout
    require_machine(version.partition(".")[0].strip() == "12", "gcc 12, whose figures docs/kernels.md has")
    from benchmarks.instructions import measure

    text = part(DOCUMENTS["kernels.md"], "instructions")
    row = re.search(rf"^\| `{trig}`[^|]*\| (\d+) \| (\d+) \|$", text, flags=re.MULTILINE)
    assert row is not None
    for scalar, figure in zip(("double", "float"), row.groups(), strict=True):
        counted = measure("puma560", trig, scalar, "x86-64-v3")
        assert counted.call == int(figure)
