"""The claims of the text: numbers, sections, verdicts and figures as a review has them, each verdict
following what it is computed from. Table 4.1."""

from __future__ import annotations

import importlib
import inspect
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn import load
from robodyn.counts import Count
from robodyn.effects import thesis_friction
from robodyn.robot import Robot
from robodyn.schedule import TASKS, friction_tasks, general_graph, task_counts
from robodyn.thesis.claims import formulations, friction, processors
from robodyn.thesis.claims.arms import Arms
from robodyn.thesis.claims.claim import read_claims
from robodyn.thesis.printed_tasks import TABLE_4_1_MISPRINTS
from robodyn.thesis.tables import Table, make, table_4_1
from robodyn.thesis.tables.table_2_10 import load_quietly, plain

Patch = pytest.MonkeyPatch
REVIEW = yaml.safe_load(Path(__file__).with_name("claims.yaml").read_text(encoding="utf-8"))
MODULES = ("rates", "formulations", "listings", "friction", "tasks", "processors")


def test_numbers_sections_and_verdicts_are_the_reviews(tables: dict[str, Table]) -> None:
    rows = tables["claims"].to_dict()["rows"]
    keys = ("number", "section", "verdict")
    assert [[row[key] for key in keys] for row in rows] == [[row[key] for key in keys] for row in REVIEW]
    assert sorted({row["number"] for row in rows}) == list(range(1, 95))


def test_figures_are_the_reviews(tables: dict[str, Table]) -> None:
    for row, review in zip(tables["claims"].to_dict()["rows"], REVIEW, strict=True):
        assert {name: row["ours"].get(name) for name in review["ours"]} == review["ours"], row["row"]


def test_a_verdict_stands_in_the_data_only_where_no_figure_decides() -> None:
    arms = Arms(load_quietly)
    for claim in read_claims():
        _, holds = claim.recompute(arms)
        assert (
            claim.by is None or claim.verdict == "not recoverable" or (holds is None) == bool(claim.verdict)
        )
        assert claim.by or claim.ours.startswith("not recomputed"), claim.name
        assert claim.by or claim.verdict, claim.name


def test_every_function_belongs_to_a_claim() -> None:
    functions = {
        f"{name}.{function}"
        for name in MODULES
        for module in [importlib.import_module(f"robodyn.thesis.claims.{name}")]
        for function, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and function[0] != "_"
    }
    assert functions == {claim.by for claim in read_claims() if claim.by}


def test_what_follows_from_printed_figures_is_apart(tables: dict[str, Table]) -> None:
    row: dict[str, Any] = tables["claims"].row("lambda form").to_dict()
    assert row["printed"].keys() == {"claim", "range_pct"}
    assert row["derived_from_printed"] == {"revolute": 34.9, "prismatic": 43.5}


def test_they_follow_the_counts(monkeypatch: Patch) -> None:
    genuine = plain

    def dearer(robot: Robot, formulation: str) -> Count:
        count = genuine(robot, formulation)
        return replace(count, mul=count.mul + 40) if formulation == "balafoutis" else count

    genuine_figures, _ = formulations.no_advantage(Arms(load_quietly))
    monkeypatch.setattr(formulations, "plain", dearer)
    figures, _ = formulations.no_advantage(Arms(load_quietly))
    shares = [each["apart"]["balafoutis"]["customised_pct"] for each in (genuine_figures, figures)]
    assert shares == [-9.4, -1.2]


def test_they_follow_the_schedules_and_the_friction(monkeypatch: Patch) -> None:
    monkeypatch.setattr(thesis_friction, "journal_bearing", lambda mu, r, d, f, n, sign, **_: mu * f[0])
    bearings = {**friction_tasks._BEARINGS, "journal": friction_tasks._BEARINGS["torque"]}
    monkeypatch.setattr(friction_tasks, "_BEARINGS", bearings)
    load, _ = friction.load_with_friction(Arms(load_quietly))
    assert load["percent"] == 2.9
    assert load["tasks_percent"] < 10
    graph = general_graph(6)
    loose = replace(graph, after={task: frozenset() for task in graph.tasks})
    assert (
        processors._share(loose, processors._best(loose, 7), 7) == 100
    )  # nothing waits: all of them are busy


def test_table_4_1_prints_the_tasks_with_what_was_corrected() -> None:
    table = make("4.1")
    assert [row.name for row in table.rows] == [f"T{k}" for k in range(1, 44)]
    corrected = [row.name for row in table.rows if row.verdict == "differs"]
    assert corrected == ["T3", "T4", "T5", "T10", "T20", "T21", "T22", "T41", "T42", "T43"]
    assert table.row("T41").ours["after"] == "T27 to T29, T33 to T40"
    assert table.row("T17").ours["after"] == "T18 to T19 before, T12 to T14"
    assert table.row("T10").printed["does"].startswith("lambda_21 = k_x")
    assert all(1 <= row.ours["operations"] <= 3 for row in table.rows)
    for task in TASKS:  # what is called misprinted is not what we have
        slip = TABLE_4_1_MISPRINTS.get(task.row)
        if slip is not None:
            ours = {"step": task.step, "does": task.does, "after": table_4_1.predecessors(task)}
            assert slip.printed != ours[slip.what]


def test_table_4_1_counts_what_a_task_does(monkeypatch: Patch) -> None:
    counts = task_counts.operations_of_tasks(4)
    monkeypatch.setattr(table_4_1, "operations_of_tasks", lambda n: {**counts, 326: {"mul": 5}})
    assert table_4_1.table().row("T26").ours["operations"] == 5


def test_products_of_inertia_of_makers_arms() -> None:
    """What the reason of claim 27 says of the example arms, which are not in the package."""
    arms = sorted((Path(__file__).parents[2] / "examples" / "arms").glob("*.yaml"))
    inertias = [[link.inertia for link in load(arm, warn=lambda _: None).links] for arm in arms]
    oblique = [arm for arm in inertias if any(any((i.xy, i.xz, i.yz)) for i in arm)]
    (claim,) = (claim for claim in read_claims() if claim.claim_number == 27)
    assert f"of the {len(arms)} arms from makers' files in examples/arms {len(oblique)} have" in claim.reason
