"""A diagnosis in words: figures with their errors, the share that is closed, and the ten lines."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from report.made_up import made
from robodyn.diagnose.result import Estimate, Finding, Verdict
from robodyn.report.diagnosis_text import LINES, closed, summary, with_error
from robodyn.robot import Robot, load


@pytest.fixture(scope="module")
def robot() -> Robot:
    return load("puma560_3dof", warn=lambda _: None)


@pytest.mark.parametrize(
    ("value", "stderr", "expected"),
    [
        (2.9012, 0.0531, "2.901 +- 0.053 N m"),
        (1234.56, 31.0, "1235 +- 31 N m"),
        (0.0, 0.5, "0.00 +- 0.50 N m"),
        (-3.21e-9, 4e-11, "-3.210e-09 +- 4.0e-11 N m"),
        (3.14159, None, "3.142 N m"),
        (3.14159, np.inf, "3.14 +- n/a N m"),
        (np.nan, 0.1, "n/a +- 0.1 N m"),
        ("motor", None, "motor"),
    ],
)  # fmt: skip
def test_figures_with_errors(value: float | str, stderr: float | None, expected: str) -> None:
    assert with_error(Estimate(value, stderr, "N m")) == expected


def test_share_of_the_gap_that_is_closed() -> None:
    floor = np.array([1.0, 2.0])
    assert closed(np.array([5.0, 2.0]), np.array([1.0, 2.0]), floor) == 1
    assert closed(np.array([5.0, 2.0]), np.array([5.0, 2.0]), floor) == 0
    assert closed(floor, floor, floor) is None
    # What exceeds the noise falls from a mean square of 24 to 6.
    assert closed(np.array([5.0, 2.0]), np.array([7.0**0.5, 2.0]), floor) == pytest.approx(0.5)


def findings(count: int) -> tuple[Finding, ...]:
    numbers: Mapping[str, Estimate] = {f"delta_{k}": Estimate(1.0, 0.1, "kg") for k in range(10)}
    return tuple(
        Finding("inertial_error", k + 1, numbers, 0.4, (), "where", f"experiment {k}", 1.0, 1.0)
        for k in range(count)
    )


@pytest.mark.parametrize("count", [0, 1, 3, 9])
@pytest.mark.parametrize("verdict", ["missing_effect", "consistent", "unexplained"])
def test_ten_lines_at_most(robot: Robot, count: int, verdict: Verdict) -> None:
    found = made(robot, findings=findings(count), verdict=verdict)
    lines = summary(found, "out/report.html", validated=True)
    assert len(lines) <= LINES
    assert lines[-1].startswith("report: out/report.html")
    assert any(line.split()[:2] == ["noise", "floor"] for line in lines)
    if count:
        assert "6 more; a suspicion, 40 % sure" in lines[1]


def test_the_lines_say_what_the_page_says(robot: Robot) -> None:
    assert summary(made(robot), "r.html", validated=True) == [
        "missing effect: puma560_3dof lacks Coulomb friction (joint 3).",
        "1. coulomb_friction, joint 3: level 2.901 +- 0.053 N m; 97 % sure; or stribeck_friction",
        "joint           1    2     3  (N m, RMS, validation log)",
        "gap before      5   10    15",
        "gap after    1.25  2.5  3.75",
        "noise floor     1    2     3",
        "85 % of the removable gap closed; inverse dynamics 80 -> 83 operations (+3)",
        "record next: slow reversals of joint 3",
        "report: r.html; one remark on the data there",
    ]
    fitted = summary(made(robot), "r.html", validated=False)
    assert fitted[3].split() == ["gap", "before", "4", "8", "12"]
    assert "fitted" in fitted[2]
