"""Many findings: a table of joints by kinds, cards by joint; and torques as logged and as modelled."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from report.made_up import made, many, series
from report.test_diagnosis_report import Page
from robodyn.report.chart_frames import HIGH
from robodyn.report.diagnosis import page
from robodyn.report.diagnosis_charts import torques
from robodyn.report.diagnosis_groups import FEW, by_joint, table_of_kinds
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


def heights(path: str) -> list[int]:
    """Vertical places of the points of a line, in the box of a chart."""
    start, _, steps = path.partition("l")
    numbers = [int(x) for x in re.findall(r"-?\d+", start + " " + steps)]
    return [int(y) for y in np.cumsum(np.reshape(numbers, (-1, 2)), axis=0)[:, 1]]


def test_the_model_is_drawn_beside_what_was_logged() -> None:
    """Friction of 1 N m is missing: the model as given is off by it, with the findings it is not."""
    one = series("train", 1)
    chart = torques(one, 0, "N m")
    logged, before, after = chart.marks
    assert (logged.title, before.title, after.title) == ("logged", "before", "after")
    off = np.abs(np.subtract(heights(before.path), heights(after.path)))
    span = HIGH / 1.08 / np.ptp(one.tau)
    assert np.median(off) == pytest.approx(span, rel=0.15)
    assert re.fullmatch(r"off by [\d.]+ % of the torque before, [\d.]+ % after", chart.text)
    same = torques(replace(one, after=one.before), 0, "N m")
    assert [mark.title for mark in same.marks] == ["logged", "same"]
    assert same.text.endswith("% of the torque, unchanged")
