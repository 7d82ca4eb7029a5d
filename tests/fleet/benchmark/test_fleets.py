"""Whole simulated fleets: their files, the same bytes however they come about, and their recipes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from benchmarks.fleet.hide import main
from benchmarks.fleet.plant import Planted, finish, plant_fleet
from benchmarks.fleet.recipe import Recipe, read_recipe

from robodyn.cluster import open_cluster
from robodyn.diagnose.blind.seal import unsealed
from robodyn.errors import InputError
from robodyn.fleet.sources.reading import read_fleet
from robodyn.robot import load

Capture = pytest.CaptureFixture[str]
SMALL = Recipe(units=3, seed=2, logs=(5, 5), duration=(1.0, 1.0), friction_units=0.34)
TEXT = "logs = [5, 5]\nduration = [1, 1]\nfriction_units = 0.34\n"


def planted(folder: Path, recipe: Recipe = SMALL, on: str = "here") -> Planted:
    robots = [load("puma560_3dof"), load("stanford_3dof")]
    with open_cluster(on) as cluster:
        return plant_fleet(robots, recipe, folder, format="csv", cluster=cluster)


def bytes_of(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*.csv")}


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Planted]:
    folder = tmp_path_factory.mktemp("fleet")
    return folder, planted(folder)


def test_the_files_are_a_fleet(fleet: tuple[Path, Planted], tmp_path: Path) -> None:
    folder, result = fleet
    finish(folder, result)
    read = read_fleet(folder)
    assert list(read.types) == ["puma560_3dof", "stanford_3dof"]
    assert (result.units, result.logs, result.changes, len(read.logs)) == (3, 15, 1, 15)
    assert set(bytes_of(folder / "logs")) == {
        str(Path(log.source).relative_to(folder / "logs")) for log in read.logs
    }
    assert all(0 < log.conditions["temperature"] < 60 for log in read.logs)
    assert {log.unit for log in read.logs} == {
        unit for units in result.answer["fleet"].values() for unit in units
    }
    (change,) = result.answer["planted"]
    dates = sorted(log.date for log in read.logs if log.unit == change["unit"])
    assert len(dates) == 5
    json.dumps(result.answer, allow_nan=False)


def test_what_cannot_be_planted(tmp_path: Path) -> None:
    arm = load("puma560_3dof")
    with pytest.raises(InputError, match="one name"):
        plant_fleet([arm, arm], SMALL, tmp_path)
    with pytest.raises(InputError, match="more is planted"):
        plant_fleet([arm], Recipe(units=3, friction_units=1.0, play_units=1.0), tmp_path)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("frictoin_units = 0.1", "did you mean 'friction_units'"),
        ("\nfriction_units = 1.5", "recipe.toml:2:1: friction.*from 0 to 1"),
        ("growth = [200, 30]", r"\[least, most\]"),
        ("logs = [2, 9]", "5 logs of a unit"),
        ("temperature = 1", "true or false"),
        ("encoder_bits = 1.5", "a whole number"),
        ("[effects]\nrust = 0.1", "rust"),
        ("noise = 0", "more than 0"),
    ],
)
def test_recipes_that_are_wrong(text: str, what: str, tmp_path: Path) -> None:
    (tmp_path / "recipe.toml").write_text(text)
    with pytest.raises(InputError, match=what):
        read_recipe(tmp_path / "recipe.toml")


def test_at_the_shell(tmp_path: Path, capsys: Capture) -> None:
    """Where the shares of the recipe come to nothing, a note says so."""
    (tmp_path / "recipe.toml").write_text(TEXT)
    words = ["puma560_3dof", "--recipe", str(tmp_path / "recipe.toml"), "--format", "csv", "--on", "here"]
    for units, hidden in ((1, 0), (3, 1)):
        folder = tmp_path / str(units)
        assert main([*words, "--units", str(units), "-o", str(folder)]) == 0
        shown = capsys.readouterr()
        assert shown.out == f"{units} units, {5 * units} logs, {hidden} changes are hidden in {folder}\n"
        assert ("hide nothing" in shown.err) is (hidden == 0)
    answer = unsealed((tmp_path / "3" / "answer.sealed").read_text())
    assert len(answer.need("planted", "changes").each()) == 1
    assert main([*words, "-o", str(tmp_path / "3")]) == 2
    assert "not empty" in capsys.readouterr().err
