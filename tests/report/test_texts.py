"""The page of effects is what the definitions say; figures with their errors and intervals."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from robodyn.diagnose.result import Estimate, gap_closed
from robodyn.effects.catalogue import CATALOGUE
from robodyn.report import effects as report
from robodyn.report.diagnosis_text import with_interval
from robodyn.report.figures import with_error
from robodyn_cli.main import cli
from robodyn_cli.output import Document

PAGE = Path(__file__).parents[2] / "docs" / "effects.md"


def test_the_committed_page_is_up_to_date() -> None:
    assert PAGE.read_text(encoding="utf-8") == report.page(), "robodyn effects --markdown > docs/effects.md"


def test_one_effect_as_text_json_and_latex() -> None:
    def run(*words: str) -> str:
        return CliRunner().invoke(cli, ["effects", *words], obj=Document("--json" in words)).output

    assert run("spring") == report.page(["spring"])
    found = json.loads(run("spring", "--json"))
    assert found["parameters"][0]["unit"] == "N m/rad"
    assert found["parameters"][0]["prismatic_unit"] == "N/m"
    every = json.loads(run("--json"))
    assert [each["effect"] for each in every] == list(CATALOGUE)
    assert run("spring", "--latex").count("\\[") == 1
    listed = run().splitlines()
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


@pytest.mark.parametrize(
    ("value", "stderr", "expected"),
    [
        (2.9012, 0.0531, "2.901 N m (2.797 to 3.005)"),
        (1234.56, 31.0, "1235 N m (1174 to 1295)"),
        (0.0, 0.5, "0 N m (-0.98 to 0.98)"),
        (-3.21e-9, 4e-11, "-3.21e-09 N m (-3.288e-09 to -3.132e-09)"),
        (3.14159, None, "3.142 N m"),
        (3.14159, np.inf, "not identifiable"),
        (np.nan, 0.1, "n/a"),
        ("motor", None, "motor"),
        (0.04899, 0.0, "0.04899 N m"),
        (-9.1, 3.2e7, "not identifiable"),
        (4839.6, 795.0, "4840 N m (3280 to 6400)"),
        (5.1e7, 4e6, "5.1e+07 N m (4.32e+07 to 5.88e+07)"),
        (0.0, 58684.0, "0 N m (-115000 to 115000)"),
        (-0.042, 7.2e-9, "-0.042 N m (-0.04200001 to -0.04199999)"),
    ],
)  # fmt: skip
def test_figures_with_intervals(value: float | str, stderr: float | None, expected: str) -> None:
    assert with_interval(Estimate(value, stderr, "N m")) == expected


def test_of_a_size_nothing_is_known_where_its_error_is_as_large() -> None:
    assert with_interval(Estimate(2.0, 3.0, "N m"), "coulomb_friction", "level") == "not identifiable"
    assert with_interval(Estimate(2.0, 0.5, "N m"), "coulomb_friction", "level") != "not identifiable"
    # A position may well be nothing within its error.
    assert with_interval(Estimate(0.01, 0.05, "rad"), "spring", "rest") == "0.01 rad (-0.088 to 0.11)"


def test_share_of_the_gap_that_is_closed() -> None:
    floor = np.array([1.0, 2.0])
    assert gap_closed(np.array([5.0, 2.0]), np.array([1.0, 2.0]), floor) == 1
    assert gap_closed(np.array([5.0, 2.0]), np.array([5.0, 2.0]), floor) == 0
    assert gap_closed(floor, floor, floor) is None
    # What exceeds the noise falls from a mean square of 24 to 6.
    assert gap_closed(np.array([5.0, 2.0]), np.array([7.0**0.5, 2.0]), floor) == pytest.approx(0.5)
    # A floor that is far too low at one joint does not let that joint speak for all.
    both = gap_closed(np.array([5.0, 50.0]), np.array([1.0, 25.0]), np.array([1.0, 1e-3]))
    assert both == pytest.approx(1 - (0.25 / 1.96) ** 0.5, rel=1e-3)
    # A joint within its noise does not count, unless it has left it.
    quiet = np.array([5.0, 2.1])
    assert gap_closed(quiet, np.array([1.0, 2.2]), floor) == 1
    grown = gap_closed(quiet, np.array([1.0, 8.0]), floor)
    assert grown is not None
    assert grown < 0
