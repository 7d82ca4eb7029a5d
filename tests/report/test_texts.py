"""The page of effects is what the definitions say; the lines of an identification."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from robodyn.effects.catalogue import CATALOGUE
from robodyn.report import effects as report
from robodyn.report.figures import with_error
from robodyn_cli.effects import command

PAGE = Path(__file__).parents[2] / "docs" / "effects.md"


def test_the_committed_page_is_up_to_date() -> None:
    assert PAGE.read_text(encoding="utf-8") == report.page(), "robodyn effects --markdown > docs/effects.md"


def test_every_effect_and_key_stands_in_it() -> None:
    text = report.page()
    for effect in CATALOGUE.values():
        section = text.partition(f"\n## {effect.id}\n")[2].partition("\n## ")[0]
        assert effect.latex in section
        for parameter in effect.parameters:
            assert f"| `{parameter.name}` |" in section
        for rival in effect.rivals:
            assert rival in CATALOGUE


def test_one_effect_as_text_json_and_latex() -> None:
    run = CliRunner()
    one = run.invoke(command, ["spring"])
    assert one.output == report.page(["spring"])
    found = json.loads(run.invoke(command, ["spring", "--json"]).output)
    assert found["parameters"][0]["unit"] == "N m/rad"
    assert found["parameters"][0]["prismatic_unit"] == "N/m"
    every = json.loads(run.invoke(command, ["--json"]).output)
    assert [each["effect"] for each in every] == list(CATALOGUE)
    assert run.invoke(command, ["spring", "--latex"]).output.count("\\[") == 1
    listed = run.invoke(command, []).output.splitlines()
    assert [line.split()[0] for line in listed] == list(CATALOGUE)


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (1874.55, 97.6, "1870 +- 100"),
        (12.6958, 0.404, "12.7 +- 0.4"),
        (0.28431, 0.0521, "0.28 +- 0.05"),
        (-9e-9, 0.05, "0.00 +- 0.05"),
        (2.9239, 1.21, "2.9 +- 1.2"),
        (243.7, 33.0, "240 +- 30"),
        (1.5e-9, 2e-10, "1.5e-09 +- 2e-10"),
        (5.0, 0.0, "5"),
    ],
)
def test_numbers_have_the_digits_that_their_errors_allow(value: float, error: float, text: str) -> None:
    assert with_error(value, error) == text
