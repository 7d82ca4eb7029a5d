"""Tables of chapters 3 and 4, the claims, and all robots."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.effects import thesis_friction
from robodyn.robot import bundled_names
from robodyn.robot.model import EffectEntry
from robodyn.schedule import arithmetic, elimination, graph
from robodyn.schedule.tasks import TASKS
from robodyn.thesis import method_steps as steps
from robodyn.thesis import printed_counts as data
from robodyn.thesis.case_arm import D4_START, led
from robodyn.thesis.printed_counts import TABLE_2_9, TABLE_3_3
from robodyn.thesis.tables import (
    Table,
    claims,
    operating_point,
    robots,
    table_3_3,
    table_3_5,
    table_4_2,
    table_4_4,
    table_4_5,
    table_4_6,
    to_text,
)
from robodyn.verify.reference import Reference
from thesis.recomputed import Patch, bundled, changed, verdicts

# --- 3.3 ----------------------------------------------------------------------------------------------------


def test_table_3_3(tables: dict[str, Table]) -> None:
    table = tables["3.3"]
    different = {name for name, verdict in verdicts(table).items() if verdict == "differs"}
    assert different == {
        "frictionless, revolute", "joint, revolute", "total_cubic, revolute", "total_linear, revolute",
    }  # fmt: skip
    assert table.row("joint, revolute").ours["operations"] == {
        "mul": 15, "add": 7, "total": 22, "div": 1, "sqrt": 2,
    }  # fmt: skip
    assert len(table.rows) == sum(map(len, TABLE_3_3.values()))


def test_table_3_3_follows_the_equations(monkeypatch: Patch) -> None:
    monkeypatch.setattr(thesis_friction, "linear_bearing", lambda mu, d, f, n, direction: mu * f[0])
    monkeypatch.setattr(thesis_friction, "driving", lambda tau, e, b, sign: tau / e)
    table = table_3_3.table()
    assert table.row("joint, prismatic").ours["operations"]["total"] == 1
    assert table.row("joint, prismatic").verdict == "differs"
    assert table.row("transmission, linear").ours["operations"]["total"] == 2
    assert table.row("total_linear, prismatic").ours["operations"]["total"] == 113 + 1 + 2


# --- 3.5 ----------------------------------------------------------------------------------------------------


def test_table_3_5(tables: dict[str, Table]) -> None:
    table = tables["3.5"]
    lost = [name for name, verdict in verdicts(table).items() if verdict == "not recoverable"]
    assert lost == [
        "dynamic", "link 1, joint friction", "link 2, joint friction", "link 3, joint friction",
        "velocity profile", "efficiency curve", "Figures 3.6 to 3.13",
    ]  # fmt: skip
    assert set(verdicts(table).values()) == {"reproduced", "not recoverable"}
    found = [table.row(f"link {k}, efficiency").ours for k in (1, 2, 3)]
    assert [row["efficiency"] for row in found] == [0.4543, 0.5619, 0.3458]
    assert [row["load_fraction"] for row in found] == [0.0307, 0.0856, 0.0076]
    assert [row["case"] for row in found] == ["drives", "drives", "brakes"]
    assert table.row("link 2, sign rule").ours["by_eq_3_7"] == pytest.approx(-15.3083)
    assert "-15.3083" in table.row("link 2, sign rule").reason
    dynamic = table.row("dynamic").ours
    assert (dynamic["off"], dynamic["at_z"], dynamic["highest_z_with_these_signs"]) == (2.31, -0.53, -0.23)
    for link, least in ((2, 1.61), (3, 0.26)):
        row = table.row(f"link {link}, joint friction")
        assert row.ours["bound"] == least > 2 * abs(row.printed["torque"])
        assert len(row.ours["bound_by_parameters"]) == 4


def test_table_3_5_would_say_so_if_a_sum_were_wrong(monkeypatch: Patch) -> None:
    first = replace(data.TABLE_3_5[0], joint_friction=Fraction("1.7805"), transmission=Fraction("8.9"))
    monkeypatch.setattr(table_3_5, "TABLE_3_5", (first, *data.TABLE_3_5[1:]))
    table = table_3_5.table()
    assert table.row("link 1, joint total").verdict == "differs"
    assert table.row("link 1, input").verdict == "differs"
    assert table.row("link 2, input").verdict == "reproduced"
    monkeypatch.setattr(thesis_friction, "driving", lambda tau, e, b, sign: tau * e + b * sign)
    assert table_3_5.table().row("link 2, efficiency").verdict == "differs"


def test_the_bounds_of_table_3_5_rest_on_eq_3_3_and_newton_euler() -> None:
    """Eq 3.3, as printed and corrected, is never below the bound; the forces are the reference's."""
    rng = np.random.default_rng(5)
    at = operating_point.on_the_path_of_d4()
    at = at.where(rng.random(len(at.z)) < 0.1)
    robot = bundled("puma560_3dof_d12")
    a, w = 1.7, 0.6
    qd, qdd = np.sqrt(w) * at.qd, a * at.qd + w * at.qdd
    tau, f = (still + a * ahead + w * fast for still, ahead, fast in (
        getattr(operating_point.affine(robot.name, at), name) for name in ("tau", "f")
    ))  # fmt: skip
    np.testing.assert_allclose(tau, Reference(robot).inverse_dynamics(at.q, qd, qdd), atol=1e-9)
    for k, drive in enumerate(data.TABLE_3_4):
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
    kinematics = led("programs").kinematics
    np.testing.assert_allclose(kinematics.position(at.q)[:, 0], 0.4, atol=1e-12)
    np.testing.assert_allclose(kinematics.position(at.q)[:, 1:], np.stack([at.z, at.z], 1), atol=1e-12)
    begin = int(np.abs(at.z - 0.1).argmin())
    turned = at.q[begin] - np.array(D4_START)
    np.testing.assert_allclose(turned - 2 * np.pi * np.round(turned / (2 * np.pi)), 0, atol=0.01)
    assert not at.fitting[begin:].any()
    fits = at.where(at.fitting)
    off, z = operating_point.closest("puma560_3dof_d12", at)
    assert z in fits.z
    k = int(np.nonzero(at.z == z)[0][0])
    still, ahead, fast = (part[k] for part in operating_point.affine("puma560_3dof_d12", at).tau)
    tried = [
        np.linalg.norm(still + a * ahead + w * fast - operating_point.printed_torques())
        for a in np.linspace(-20, 20, 201)
        for w in np.linspace(0, 8, 81)
    ]
    assert off <= min(tried) <= off + 0.5  # no grid comes nearer


# --- 4.2 to 4.6 ---------------------------------------------------------------------------------------------


def test_table_4_2(tables: dict[str, Table]) -> None:
    table = tables["4.2"]
    assert verdicts(table) == {
        "prismatic_joint": "differs", "first_link": "differs", "last_link": "reproduced",
    }  # fmt: skip
    assert "idle besides: 18 19" in table.row("prismatic_joint").reason
    assert "not idle: 8 26" in table.row("first_link").reason


def test_table_4_2_follows_the_tasks(monkeypatch: Patch) -> None:
    nine = arithmetic._DO[9]

    def heavier(at: arithmetic.Place) -> None:
        nine(at)
        at.now.lam[0][0] = at.now.lam[0][0] * at.joint.qd

    monkeypatch.setitem(arithmetic._DO, 9, heavier)
    table = table_4_2.table()
    assert 9 not in table.row("prismatic_joint").ours["tasks"]
    assert "42 of 43" in table.notes[0]


def test_table_4_4(tables: dict[str, Table]) -> None:
    different = [name for name, verdict in verdicts(tables["4.4"]).items() if verdict == "differs"]
    assert different == ["link 5", "zeros"]
    assert tables["4.4"].row("zeros").ours == {"zeros": 26, "of": 36}


def test_tables_4_4_and_4_6_follow_the_robot(tables: dict[str, Table]) -> None:
    other = changed("stanford", 4, com=(Fraction(1), Fraction(1), Fraction(1)))
    sparse = table_4_4.table(load_robot=other)
    assert sparse.row("link 4").ours["s"] == ["x", "y", "z"]
    assert sparse.row("link 4").verdict == "differs"
    assert sparse.row("zeros").ours["zeros"] == 25
    rule = table_4_6.table(load_robot=other)
    assert rule.row("link 4").ours["total"] == tables["4.6"].row("link 4").ours["total"] - 3
    assert "s_4 has 0 zeros" in rule.row("link 4").reason


def test_table_4_5(tables: dict[str, Table]) -> None:
    assert set(verdicts(tables["4.5"]).values()) == {"reproduced"}
    assert [row.ours["flops"] for row in tables["4.5"].rows] == [12, 6, 0, 12, 6, 0, 5, 2, 0, 5, 2, 0]


def test_table_4_5_follows_the_tasks(monkeypatch: Patch) -> None:
    monkeypatch.setattr(arithmetic, "_cross", lambda axis, u, v: u[axis] * v[axis] + u[axis] * v[axis - 1])
    table = table_4_5.table()
    assert table.row("step 8, p x f, 1 zero").ours["flops"] == 6
    assert table.row("step 8, p x f, 2 zeros").ours["tasks"] == 1
    assert table.row("step 4, a + lambda s, 1 zero").verdict == "reproduced"


def test_table_4_6(tables: dict[str, Table]) -> None:
    different = {name for name, verdict in verdicts(tables["4.6"]).items() if verdict == "differs"}
    assert different == {"link 2", "link 5", "sum"}
    assert "12 tasks and not 10" in tables["4.6"].row("link 2").reason
    assert tables["4.6"].row("link 3").beside[0]["total"] == 13


# --- claims -------------------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_claims_follow_the_graphs_edges(monkeypatch: Patch) -> None:
    """Nothing handed back from the tip: the chain grows shorter. a besides waiting for lambda: longer."""
    fewer = tuple(replace(task, after=()) if task.row in (30, 31, 39, 40) else task for task in TASKS)
    monkeypatch.setattr(graph, "TASKS", fewer)
    loose = claims.table().row("parallel cost")
    more = tuple(
        replace(task, after=(*task.after, (0, 11))) if task.row == 1 + 17 else task for task in TASKS
    )
    more = tuple(replace(task, after=(*task.after, (-1, 18))) if task.row == 4 else task for task in more)
    monkeypatch.setattr(graph, "TASKS", more)
    tight = claims.table()
    assert loose.verdict == tight.row("parallel cost").verdict == "differs"
    assert loose.ours["layers"] < 27 < tight.row("parallel cost").ours["layers"]
    assert tight.row("speed-up").verdict == "differs"
    assert tight.row("six-link load").verdict == "reproduced"
    assert tight.row("least Stanford time").ours["levels"] > 25


@pytest.mark.thorough
def test_claims_follow_the_rules_of_elimination(tables: dict[str, Table], monkeypatch: Patch) -> None:
    """Nothing spared for the first and the last link: more tasks, wider layers, another share saved."""
    monkeypatch.setattr(elimination, "FIRST_LINK", frozenset())
    monkeypatch.setattr(elimination, "LAST_LINK", frozenset())
    found, before = claims.table(), tables["claims"]
    assert found.row("six-link load").ours["subtasks"] == 43 * 6
    assert found.row("six-link load").verdict == "differs"
    for name in ("Stanford load", "six-link efficiency", "task reduction"):
        assert found.row(name).ours != before.row(name).ours
    printed = "maximum concurrency"  # of the tasks of Table 4.7, which no rule gives
    assert found.row(printed).ours == before.row(printed).ours


def test_claims_follow_the_steps(tables: dict[str, Table], monkeypatch: Patch) -> None:
    monkeypatch.setattr(steps, "moment", lambda N, s, F, p_next, f_next, n_next: n_next)
    found = claims.table().row("lambda form").ours
    assert found["revolute"] > tables["claims"].row("lambda form").ours["revolute"]


def test_claims_follow_the_robot_and_the_counts(tables: dict[str, Table], monkeypatch: Patch) -> None:
    solid = changed("stanford", 2, com=(Fraction(1), Fraction(1), Fraction(1)))
    monkeypatch.setattr(thesis_friction, "driving", lambda tau, e, b, sign: tau / e)
    found = claims.table(load_robot=solid)
    before = tables["claims"]
    extra = found.row("Stanford load").ours
    assert (
        extra["subtasks_step_3_corrected"]
        == before.row("Stanford load").ours["subtasks_step_3_corrected"] + 6
    )
    assert found.row("small friction").ours["without_joint_friction"] == 2
    assert found.row("friction").ours["flops"] == 24  # by accident as printed, but the other is not
    assert found.row("small friction").verdict == "differs"


# --- all robots -------------------------------------------------------------------------------------------


def test_the_table_of_all_robots(monkeypatch: Patch) -> None:
    some = ("puma560_3dof", "stanford_3dof_d3", "ur10")
    assert set(some) <= set(bundled_names())
    monkeypatch.setattr(robots, "bundled_names", lambda: some)
    told: list[str] = []
    table = robots.table(told.append)
    assert tuple(told) == some == tuple(row.name for row in table.rows)
    ur10 = table.row("ur10")
    assert (ur10.verdict, ur10.printed, ur10.ours["opensymoro"]) == (None, {}, 318)
    stanford = table.row("stanford_3dof_d3")
    assert stanford.printed == {"mul": 48, "add": 33, "total": 81}
    assert stanford.ours["joints"] == "RRP"
    assert (
        stanford.ours["default"]["total"] <= stanford.ours["fast"]["total"] < stanford.ours["none"]["total"]
    )
    assert max(map(len, to_text(table).splitlines())) <= 110
    other = robots.table(load_robot=changed("ur10", 6, com=(Fraction(1), Fraction(1), Fraction(1))))
    assert other.row("ur10").ours["none"] != ur10.ours["none"]


def test_printed_columns_are_not_ours() -> None:
    """What is printed is data, and the sums that the thesis got wrong are wrong in it."""
    for heading, column in TABLE_2_9.items():
        total = tuple(sum(pair[k] for step, pair in column.items() if step != "total") for k in (0, 1))
        assert (total == column["total"]) == (heading != "revolute_II")
