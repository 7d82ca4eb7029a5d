"""A diagnosis in words: figures with their errors, the share that is closed, a screen at most."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from report.made_up import made
from robodyn.diagnose.result import Estimate, Finding, Verdict, gap_closed
from robodyn.report.diagnosis_summary import LINES, summary
from robodyn.report.diagnosis_text import with_interval
from robodyn.robot import Robot, load


@pytest.fixture(scope="module")
def robot() -> Robot:
    return load("puma560_3dof", warn=lambda _: None)


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


def findings(count: int) -> tuple[Finding, ...]:
    numbers: Mapping[str, Estimate] = {f"delta_{k}": Estimate(1.0, 0.1, "kg") for k in range(10)}
    return tuple(
        Finding("inertial_error", k + 1, numbers, 0.4, (), "where", f"experiment {k}", 1.0, 1.0)
        for k in range(count)
    )


@pytest.mark.parametrize("count", [0, 1, 3, 9])
@pytest.mark.parametrize("verdict", ["missing_effect", "consistent", "unexplained"])
def test_a_screen_at_most(robot: Robot, count: int, verdict: Verdict) -> None:
    found = made(robot, findings=findings(count), verdict=verdict)
    lines = summary(found, "out/report.html", validated=True)
    assert len(lines) <= LINES
    assert lines[-1].startswith("report: out/report.html")
    assert any(line.split()[:2] == ["noise", "floor"] for line in lines)
    if count:
        assert f"{7 if count == 1 else 9} more; a suspicion, 40 % sure" in lines[1]
        assert ("joint 1:" if count == 1 else f"joints 1 to {count}:") in lines[1]
