"""A diagnosis joint by joint: many findings as a table and as cards; where a residual shows, at which joint,
and over which quantity."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from report.made_up import made, many, series
from report.test_diagnosis_report import Page, points
from robodyn.diagnose.result import Gap, Series
from robodyn.report.chart_frames import HIGH
from robodyn.report.diagnosis import FEW, by_joint, page, table_of_kinds
from robodyn.report.diagnosis_residual import best_of, localised, shown_over, torques, travelled
from robodyn.report.diagnosis_summary import advice
from robodyn.robot import Robot, load


@pytest.fixture(scope="module")
def robot() -> Robot:
    return load("puma560", warn=lambda _: None)


def test_a_table_has_each_finding_once_in_its_row_and_column(robot: Robot) -> None:
    table = table_of_kinds(made(robot, findings=many(6)))
    assert table is not None
    assert [(kind["title"], len(kind["effects"])) for kind in table["kinds"]][:2] == [
        ("friction", 2), ("Rotor inertia", 0)
    ]  # fmt: skip
    assert [row["place"] for row in table["rows"]] == [
        *(f"Joint {j}" for j in range(1, 7)),
        "The whole robot",
    ]
    cells = {
        (row["place"], cell["label"]): [entry["text"] for entry in cell["entries"]]
        for row in table["rows"]
        for cell in row["cells"]
    }
    assert cells["Joint 3", "Coulomb friction"] == ["4 N m"]
    assert cells["Joint 2", "Rotor inertia"] == ["0.2 kg m²"]
    assert cells["The whole robot", "Payload"] == ["2 kg"]
    assert cells["Joint 1", "Torque ripple"] == []
    assert sum(map(len, cells.values())) == len(many(6))
    claims = [e["is_claim"] for row in table["rows"] for cell in row["cells"] for e in cell["entries"]]
    assert claims.count(False) == 1


def test_cards_of_a_joint_stand_together(robot: Robot) -> None:
    diagnosis = made(robot, findings=many(6))
    cards = [{"joint": f.joint, "effect": f.effect} for f in diagnosis.findings]
    groups = by_joint(diagnosis, cards, validated=True)
    assert [group["id"] for group in groups] == [*(f"joint-{j}" for j in range(1, 7)), "robot"]
    assert [card["effect"] for card in groups[3]["cards"]] == [
        "coulomb_friction", "viscous_friction", "rotor_inertia", "torque_ripple", "spring",
    ]  # fmt: skip
    assert groups[3]["remark"] == "5 findings; RMS of the residual 20 → 5 N m"
    assert groups[-1]["remark"] == "1 finding"


def test_a_few_findings_are_neither_tabled_nor_folded(robot: Robot) -> None:
    few = made(robot, findings=many(6)[:FEW])
    assert table_of_kinds(few) is None
    assert by_joint(few, [], validated=True) == []
    seen = Page(page(few, validated=True))
    assert len(seen.all("article", **{"class": "card"})) == FEW


def test_many_findings_are_folded_and_linked(robot: Robot) -> None:
    seen = Page(page(made(robot, findings=many(6)), validated=True))
    assert len(seen.all("details", **{"class": "card"})) == len(many(6)) - 1
    assert len(seen.all("details", **{"class": "card suspicion"})) == 1
    targets = {a["href"][1:] for a in seen.all("a")}
    assert {"joint-1", "joint-6", "robot"} <= targets
    assert targets <= {a["id"] for _, a in seen.elements if "id" in a}
    assert seen.all("td", **{"data-label": "Torque ripple"})


def test_the_model_is_drawn_beside_what_was_logged() -> None:
    """Friction of 1 N m is missing: the model as given is off by it, with the findings it is not."""
    one = series("train", 1)
    chart = torques(one, 0, "N m")
    logged, before, after = chart.marks
    assert (logged.title, before.title, after.title) == ("logged", "before", "after")
    off = np.abs(np.subtract(points(before.path)[:, 1], points(after.path)[:, 1]))
    span = HIGH / 1.08 / np.ptp(one.tau)
    assert np.median(off) == pytest.approx(span, rel=0.15)
    assert re.fullmatch(r"off by [\d.]+ % of the torque before, [\d.]+ % after", chart.text)
    same = torques(replace(one, after=one.before), 0, "N m")
    assert [mark.title for mark in same.marks] == ["logged", "same"]
    assert same.text.endswith("% of the torque, unchanged")


Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def small() -> Robot:
    return load("puma560_3dof", warn=lambda _: None)


def motion(residual: Callable[[Floats, Floats, Floats, Floats, Floats], Floats]) -> Series:
    """A rich motion of three joints, the residual at the second, a tenth of it noise everywhere."""
    t = np.linspace(0, 10, 3000)
    turns = np.outer(t, [1.3, 2.1, 3.7])
    slow = np.outer(t, [0.31, 0.43, 0.17])
    q = np.sin(turns) + np.sin(slow + 1)
    qd, qdd = np.gradient(q, t, axis=0), np.gradient(np.gradient(q, t, axis=0), t, axis=0)
    load_ = 20 * np.cos(q[:, [1, 2, 0]] + 0.4 * q[:, [2, 0, 1]])
    noise = 0.1 * np.random.default_rng(3).standard_normal(q.shape)
    before = noise.copy()
    before[:, 1] += residual(q[:, 1], qd[:, 1], qdd[:, 1], load_[:, 1], t)
    return Series("train", t, q, qd, qdd, load_, load_ + before, before, noise)


def gap(one: Series) -> Gap:
    before, after = (np.sqrt(np.mean(x**2, axis=0)) for x in (one.before, one.after))
    return Gap(before, after, before, after, np.full(3, 0.1))


@pytest.mark.parametrize(
    ("residual", "quantity"),
    [
        (lambda q, qd, qdd, load, t: np.full(len(t), 0.7), "constant"),
        (lambda q, qd, qdd, load, t: np.sign(qd), "direction"),
        (lambda q, qd, qdd, load, t: 0.4 * qd, "velocity"),
        (lambda q, qd, qdd, load, t: np.sin(3 * q), "position"),
        (lambda q, qd, qdd, load, t: 0.2 * qdd, "acceleration"),
        (lambda q, qd, qdd, load, t: 0.05 * load, "load"),
        (lambda q, qd, qdd, load, t: 0.05 * np.abs(load) * np.sign(qd), "load, each way"),
        (lambda q, qd, qdd, load, t: 3.0 * ((t > 4) & (t < 5)), "a short time"),
    ],
)
def test_the_quantity_that_shows_it(small: Robot, residual: Callable[..., Floats], quantity: str) -> None:
    one = motion(residual)
    found = made(small, series=(one, one), gap=gap(one))
    first, second, third = localised(found)
    assert second.best == quantity
    assert second.share > 0.99
    assert max(second.shown) > 0.7
    assert first.shown == third.shown == ()


def test_noise_is_shown_by_nothing() -> None:
    one = motion(lambda q, qd, qdd, load, t: 0 * t)
    shown = shown_over(one, 0)
    assert max(shown) < 0.05
    assert best_of(shown) is None
    assert best_of(()) is None


def test_what_the_motion_lacks(small: Robot) -> None:
    one = motion(lambda q, qd, qdd, load, t: 0 * t)
    t = one.times
    q, qd, load_ = one.q.copy(), one.qd.copy(), one.load.copy()
    q[:, 0], qd[:, 0] = t, 1.0  # one way only
    load_[:, 1] = np.abs(load_[:, 1]) + 1
    qd[:, 2] = 0.0
    rows = travelled(small, replace(one, q=q, qd=qd, load=load_))
    assert [row.wants for row in rows] == ["hardly reverses", "the load keeps its sign", "does not move"]
    found = made(small, verdict="consistent", findings=(), series=(one,))
    (step,) = advice(found, localised(found), rows)
    assert step["text"].startswith(
        "Joint 1: hardly reverses; joint 2: the load keeps its sign; joint 3: does not move."
    )
    assert all(row.limits == (-np.pi, np.pi) for row in rows) or rows[0].limits is None
