"""A diagnosis in words: figures with their errors, the share that is closed, and the ten lines."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

from report.made_up import made
from robodyn.diagnose.result import Estimate, Finding, Gap, Verdict
from robodyn.report.diagnosis_text import LINES, closed, summary, with_error
from robodyn.robot import Robot, load, read_text


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
        (0.04899, 0.0, "0.04899 N m"),
        (-9.1, 3.2e7, "not seen by this motion"),
        (-0.042, 7.2e-9, "-0.042 +- 7.2e-09 N m"),
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
        "missing effect: puma560_3dof: Coulomb friction at joint 3 is missing.",
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


def test_nothing_changed_and_contact(robot: Robot) -> None:
    lines = summary(made(robot, verdict="consistent", findings=()), "r.html", validated=True)
    assert [line.split("  ")[0] for line in lines[1:4]] == ["joint", "gap", "noise floor"]
    assert not any("closed" in line for line in lines)
    parameters = {
        "start": Estimate(5.8, 0.0, "s"), "end": Estimate(6.3, 0.0, "s"), "link": Estimate(2.0, 0.0, "1"),
    }  # fmt: skip
    contact = Finding("external_contact", None, parameters, 0.9, (), "a burst", None, 9.0, 9.0)
    lines = summary(made(robot, findings=(contact,)), "r.html", validated=True)
    assert lines[0].endswith("no effect is missing, but something touched link 2 from 5.80 to 6.30 s.")
    assert "contact is left out of the fit and not added to the model" in lines
    rubbing = made(robot).findings
    lines = summary(made(robot, findings=(*rubbing, contact)), "r.html", validated=True)
    assert lines[0].endswith(
        "Coulomb friction at joint 3 is missing; something touched link 2 from 5.80 to 6.30 s."
    )


def test_of_long_arms_the_joints_where_most_is_there() -> None:
    n = 12
    snake = read_text("name: snake\nlinks:\n" + "  - {joint: revolute, a: 1, mass: 1}\n" * n)
    size = np.ones(n)
    before = np.array([1, 9, 1, 8, 7, 6, 5, 1, 4, 3, 1, 2.0])
    found = made(snake, gap=Gap(before, size, before, size, size), findings=findings(9))
    lines = summary(found, "r.html", validated=True)
    assert len(lines) <= LINES
    (joints,) = (line for line in lines if line.startswith("joint "))
    assert joints.split("(")[0].split()[1:] == ["2", "4", "5", "6", "7", "9", "10", "12"]
    assert joints.endswith("8 of 12 joints)")
    assert all(len(line) < 120 for line in lines if not line[0].isdigit())
