"""The README shows what the commands print, and the commands that it names exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from robodyn_cli.main import COMMANDS, main

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")


def test_the_counts_are_those_that_gen_prints(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["gen", "puma560"]) == 0
    assert capsys.readouterr().out in README


def test_the_names_and_the_count_of_the_python_example_are_right() -> None:
    import robodyn

    example = re.findall(r"```python\n(.*?)```", README, flags=re.DOTALL)[0]
    assert {"compile", "count", "diagnose", "excite", "simulate"} <= set(
        re.findall(r"robodyn\.(\w+)\(", example)
    )
    assert set(re.findall(r"robodyn\.(\w+)\(", example)) <= set(robodyn.__all__)
    assert f"# {robodyn.count('puma560').total} operations" in example


def test_every_command_named_exists_and_every_command_is_named() -> None:
    shell = "".join(re.findall(r"```sh\n(.*?)```", README, flags=re.DOTALL))
    named = set(re.findall(r"^robodyn ([\w-]+)", shell, flags=re.MULTILINE))
    assert named == set(COMMANDS)


def test_the_example_is_a_robot() -> None:
    from robodyn.robot import read_text

    (example,) = re.findall(r"```yaml\n(.*?)```", README, flags=re.DOTALL)
    robot = read_text(example)
    assert robot.parameters == ("m_load",)


def test_the_tables_of_counts_are_those_of_the_record() -> None:
    import csv

    from robodyn.optimize.records import bundled_records

    with (bundled_records() / "counts.csv").open(encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["function"] == "inverse_dynamics"]
    fast = {row["robot"]: row["total"] for row in rows if row["level"] == "fast"}
    shipped = {
        row["robot"]: f"{row['mul']}+{row['add']} = {row['total']}"
        for row in rows
        if row["level"] == "record"
    }
    few = (Path(__file__).parents[1] / "docs" / "fewest-operations.md").read_text(encoding="utf-8")
    for text in (README, few):
        (table,) = re.findall(r"<!-- counts -->\n(.*?)<!-- end -->", text, flags=re.DOTALL)
        cells = [line.strip("| ").split(" | ") for line in table.splitlines()[2:]]
        assert {row[0].strip("`"): row[3] for row in cells} == fast
        assert {row[0].strip("`"): row[4] for row in cells} == shipped
