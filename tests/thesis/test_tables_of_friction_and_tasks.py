"""Tables of chapters 3 and 4 beside a transcription of the thesis."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.robot.model import EffectEntry
from robodyn.schedule.tasks import TASKS
from robodyn.thesis.case_arm import D4_START, led
from robodyn.thesis.printed import TABLE_3_3, TABLE_3_4, TABLE_4_1_MISPRINTS, bundled
from robodyn.thesis.tables import operating_point, programs
from robodyn.verify.reference import Reference
from thesis.recomputed import named, table

# Table 3.4: mu, radius, breakaway, largest.
FRICTION = ("0.1 0.10 6.3 97.6", "0.1 0.08 5.5 186.4", "0.1 0.07 2.6 89.4")

# --- 3.1 and 3.3 --------------------------------------------------------------------------------------------


def test_table_3_1() -> None:
    assert [row.verdict for row in table("3.1").rows] == ["reproduced", "differs", "reproduced", "reproduced"]
    assert table("3.1").row("revolute, two journals (Eq 3.3)").ours["printed_off"] > 1


def test_table_3_3() -> None:
    found = table("3.3")
    assert named(found) == {
        "frictionless, revolute", "joint, revolute", "total_cubic, revolute", "total_linear, revolute",
    }  # fmt: skip
    operations = {"mul": 15, "add": 7, "total": 22, "div": 1, "sqrt": 2}
    assert found.row("joint, revolute").ours["operations"] == operations
    assert len(found.rows) == sum(map(len, TABLE_3_3.values()))


# --- 3.4 and 3.5 --------------------------------------------------------------------------------------------


def test_table_3_4() -> None:
    found = table("3.4")
    names = ("mu", "radius [m]", "breakaway [N m]", "largest torque [N m]")
    transcribed = {
        f"link {link}, {name}": float(value)
        for link, text in enumerate(FRICTION, 1)
        for name, value in zip(names, text.split(), strict=True)
    }
    assert {row.name: row.printed["value"] for row in found.rows} == transcribed
    assert named(found) == {"link 2, mu", "link 2, radius [m]", "link 3, mu", "link 3, radius [m]"}
    assert named(found, "not recoverable") == {"link 1, mu", "link 1, radius [m]"}
    # by hand, from Table 3.5: link 3 brakes with 2.3648 N m in and -0.6801 N m out
    third = found.row("link 3, breakaway [N m]").ours
    assert third["least"] == pytest.approx(2.3648, abs=0.01)
    assert third["most"] == pytest.approx(2.3648 + 0.6801, abs=0.01)
    first = found.row("link 1, largest torque [N m]").ours
    assert first["least"] == pytest.approx(2.9943 / (15.9646 / 186.4), abs=0.1)
    assert first["most"] == pytest.approx(2.9943 / (0.6801 / 89.4), abs=1)
    # the least friction of link 2 is in Table 3.5's own row
    bound = table("3.5").row("link 2, joint friction").ours["bound"]
    assert found.row("link 2, mu").ours["most"] == pytest.approx(0.1 * 0.3281 / bound, rel=0.01)


def test_table_3_5() -> None:
    found = table("3.5")
    assert named(found, "not recoverable") == {
        "dynamic", "link 1, joint friction", "link 2, joint friction", "link 3, joint friction",
        "velocity profile", "efficiency curve", "Figures 3.6 to 3.13",
    }  # fmt: skip
    assert not named(found)
    points = [found.row(f"link {k}, efficiency").ours for k in (1, 2, 3)]
    assert [row["efficiency"] for row in points] == [0.4543, 0.5619, 0.3458]
    assert [row["load_fraction"] for row in points] == [0.0307, 0.0856, 0.0076]
    assert [row["case"] for row in points] == ["drives", "drives", "brakes"]
    assert found.row("link 2, sign rule").ours["by_eq_3_7"] == pytest.approx(-15.3083)
    dynamic = found.row("dynamic").ours
    assert (dynamic["off"], dynamic["at_z"], dynamic["highest_z_with_these_signs"]) == (2.31, -0.53, -0.23)
    for link, least in ((2, 1.61), (3, 0.26)):
        row = found.row(f"link {link}, joint friction")
        assert row.ours["bound"] == least > 2 * abs(row.printed["torque"])
        assert len(row.ours["bound_by_parameters"]) == 4


def test_the_bounds_of_table_3_5_rest_on_eq_3_3_and_newton_euler() -> None:
    """Eq 3.3, as printed and corrected, is never below the bound; the forces are the reference's."""
    at = operating_point.on_the_path_of_d4()
    at = at.where(np.random.default_rng(5).random(len(at.z)) < 0.1)
    robot = bundled("puma560_3dof_d12")
    a, w = 1.7, 0.6
    qd, qdd = np.sqrt(w) * at.qd, a * at.qd + w * at.qdd
    terms = operating_point.affine(robot.name, at)
    tau, f = (still + a * ahead + w * fast for still, ahead, fast in terms)
    np.testing.assert_allclose(tau, Reference(robot).inverse_dynamics(at.q, qd, qdd), atol=1e-9)
    for k, drive in enumerate(TABLE_3_4):
        for d in (0.01, 0.2, 5.0):
            for variant in ("corrected", "printed"):
                setting = (
                    ("bearing", "journal"), ("mu", drive.mu), ("radius", drive.radius),
                    ("span", Fraction(str(d))), ("variant", variant),
                )  # fmt: skip
                entry = EffectEntry("load_dependent_friction", k + 1, setting)
                taken = Reference(replace(robot, effects=(entry,))).inverse_dynamics(at.q, qd, qdd) - tau
                bound = float(drive.mu * drive.radius) * np.hypot(f[:, k, 0], f[:, k, 1])
                assert (np.abs(taken[:, k]) >= bound * (1 - 1e-9)).all()


def test_joints_turn_as_printed_up_or_down_the_line() -> None:
    rates = np.array([[1.0, -2.0, 0.5], [-1.0, 2.0, -0.5], [1.0, 2.0, -0.5], [1.0, 2.0, 0.5]])
    none = np.zeros_like(rates)
    at = operating_point.Places(np.arange(4.0), none, rates, none)
    assert at.fitting.tolist() == [True, True, False, False]
    assert at.where(at.fitting).z.tolist() == [0, 1]


def test_places_of_table_3_5_lie_on_the_line() -> None:
    at = operating_point.on_the_path_of_d4()
    place = led("programs").kinematics.position(at.q)
    np.testing.assert_allclose(place, np.stack([np.full_like(at.z, 0.4), at.z, at.z], 1), atol=1e-12)
    begin = int(np.abs(at.z - 0.1).argmin())
    turned = at.q[begin] - np.array(D4_START)
    np.testing.assert_allclose(turned - 2 * np.pi * np.round(turned / (2 * np.pi)), 0, atol=0.01)
    assert not at.fitting[begin:].any()
    off, z = operating_point.closest("puma560_3dof_d12", at)
    k = int(np.nonzero(at.z == z)[0][0])
    assert at.fitting[k]
    still, ahead, fast = (part[k] for part in operating_point.affine("puma560_3dof_d12", at)[0])
    tried = [
        np.linalg.norm(still + a * ahead + w * fast - operating_point.printed_torques())
        for a in np.linspace(-20, 20, 201)
        for w in np.linspace(0, 8, 81)
    ]
    assert off <= min(tried) <= off + 0.5  # no grid comes nearer


# --- program D.1.3 ------------------------------------------------------------------------------------------

# The lengths of the program, written down for this test: shoulder's offset, upper arm, forearm [m].
G, A, F = 0.127, 0.4318, 0.4318


def by_hand(point: list[float], shoulder: int, elbow: int) -> list[float]:
    """A branch [3] (rad) by the law of cosines: the point in the plane of the arm, then two triangles."""
    x, y, z = point
    u = shoulder * math.sqrt(x * x + y * y - G * G)
    q1 = math.atan2(y, x) - math.atan2(G, u)
    bend = elbow * math.acos((u * u + z * z - A * A - F * F) / (2 * A * F))
    q2 = math.atan2(-z, u) - math.atan2(F * math.sin(bend), A + F * math.cos(bend))
    return [q1, q2, bend - math.pi / 2]  # the forearm is along y of frame 3


def test_the_table_of_branches() -> None:
    found = table("inverse")
    assert (found.row("operations").ours["value"], found.row("operations").verdict) == ("77", None)
    branches = [row for row in found.rows if row.name.startswith("q1 by")]
    assert len(branches) == 4
    assert all(float(row.beside[0]["largest"]) < 1e-12 for row in branches)
    assert named(found, "reproduced") == {"q1 by minus root, q3 by plus root"}


@pytest.mark.parametrize("point", [("0.4", "0.1", "0.1"), ("-0.3", "0.2", "0.5"), ("0.2", "-0.6", "-0.1")])
def test_the_bundled_arm_has_the_four_branches_of_the_program(point: tuple[str, str, str]) -> None:
    robot = bundled("puma560_3dof_d13")
    solutions = programs.generated_branches(robot, list(map(Fraction, point)))
    place = list(map(float, point))
    np.testing.assert_allclose(
        Reference(robot).tool_pose(np.array(solutions))[:, :, 3], [place] * 4, atol=1e-14
    )
    for shoulder in (1, -1):
        for elbow in (1, -1):
            off = np.array(solutions) - by_hand(place, shoulder, elbow)
            turned = np.abs(off - 2 * np.pi * np.round(off / (2 * np.pi))).max(axis=1)
            assert turned.min() < 1e-12, (shoulder, elbow)


# --- 4.1 to 4.6 ---------------------------------------------------------------------------------------------


def test_table_4_1() -> None:
    found = table("4.1")
    assert [row.name for row in found.rows] == [f"T{k}" for k in range(1, 44)]
    assert named(found) == {f"T{k}" for k in (3, 4, 5, 10, 20, 21, 22, 41, 42, 43)}
    assert found.row("T41").ours["after"] == "T27 to T29, T33 to T40"
    assert found.row("T17").ours["after"] == "T18 to T19 before, T12 to T14"
    assert found.row("T10").printed["does"].startswith("lambda_21 = k_x")
    assert all(1 <= row.ours["operations"] <= 3 for row in found.rows)
    for task in TASKS:  # what is called misprinted is not what we have
        slip = TABLE_4_1_MISPRINTS.get(task.row)
        if slip is not None:
            assert slip.printed != found.row(f"T{task.row}").ours[slip.what]


def test_table_4_2() -> None:
    found = table("4.2")
    assert named(found) == {"prismatic_joint", "first_link"}
    assert "idle besides: 18 19" in found.row("prismatic_joint").reason
    assert "not idle: 8 26" in found.row("first_link").reason


def test_tables_4_4_and_4_6() -> None:
    sparse, rule = table("4.4"), table("4.6")
    assert named(sparse) == {"link 5", "zeros"}
    assert sparse.row("zeros").ours == {"zeros": 26, "of": 36}
    assert named(rule) == {"link 2", "link 5", "sum"}
    assert "12 tasks and not 10" in rule.row("link 2").reason
    assert rule.row("link 3").beside[0]["total"] == 13


def test_table_4_5() -> None:
    assert named(table("4.5"), "reproduced") == {row.name for row in table("4.5").rows}
    assert [row.ours["flops"] for row in table("4.5").rows] == [12, 6, 0, 12, 6, 0, 5, 2, 0, 5, 2, 0]
