"""The page of effects is what the definitions say."""

from __future__ import annotations

import json
from pathlib import Path

from click.testing import CliRunner

from robodyn.effects.catalogue import CATALOGUE
from robodyn.report import effects as report
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
    assert one.output == report.section(CATALOGUE["spring"])
    found = json.loads(run.invoke(command, ["spring", "--json"]).output)
    assert found["parameters"][0]["unit"] == "N m/rad"
    assert found["parameters"][0]["prismatic_unit"] == "N/m"
    every = json.loads(run.invoke(command, ["--json"]).output)
    assert [each["effect"] for each in every] == list(CATALOGUE)
    assert run.invoke(command, ["spring", "--latex"]).output.count("\\[") == 1
    listed = run.invoke(command, []).output.splitlines()
    assert [line.split()[0] for line in listed] == list(CATALOGUE)
