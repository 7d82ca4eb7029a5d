"""A diagnosis in words: figures with their errors, the share that is closed, and the lines on a terminal."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np
import pytest

from report.made_up import made, many
from robodyn.diagnose.result import Estimate, Finding, Gap, Verdict, gap_closed
from robodyn.report.diagnosis_summary import LINES, summary
from robodyn.report.diagnosis_text import with_interval
from robodyn.robot import Robot, load, read_text


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


def test_the_lines_say_what_the_page_says(robot: Robot) -> None:
    assert summary(made(robot), "r.html", validated=True) == [
        "missing effect: puma560_3dof: Coulomb friction at joint 3 is missing; 12 % of the torque stays "
        "unexplained.",
        "1. coulomb_friction, joint 3: level 2.901 N m (2.797 to 3.005); 97 % sure; or stribeck_friction",
        "joint           1    2     3  (N m, RMS, validation log); brackets: 95 % intervals",
        "gap before      5   10    15",
        "gap after    1.25  2.5  3.75",
        "noise floor     1    2     3",
        "85 % of the gap closed; inverse dynamics 80 -> 83 operations (+3)",
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
    assert lines[:2] == [
        "missing effect: puma560_3dof: Coulomb friction at joint 3 is missing",
        "Something touched link 2 from 5.80 to 6.30 s; 12 % of the torque stays unexplained.",
    ]


def test_many_findings_take_a_line_a_kind() -> None:
    arm = load("puma560", warn=lambda _: None)
    lines = summary(made(arm, findings=many(6)), "r.html", validated=True)
    assert lines[0] == (
        "missing effect: puma560: friction, rotor inertia, a payload, a coupled wrist and torque ripple are "
        "missing"
    )
    assert lines[1].startswith("A payload, friction and rotor inertia at all joints, a coupled wrist (5, 6) ")
    assert [line.split(":")[0] for line in lines if re.match(r"\d+\. ", line)] == [
        "1. coulomb_friction, joints 1 to 6", "2. viscous_friction, joints 1 to 6",
        "3. rotor_inertia, joints 1 to 6", "4. motor_coupling, joint 6", "5. torque_ripple, joint 4",
        "6. payload, the whole robot", "7. spring, joint 4",
    ]  # fmt: skip
    assert len(lines) <= LINES


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
