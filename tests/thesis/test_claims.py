"""The claims of the text: numbers, sections, verdicts and figures as a review has them, each verdict
following what it is computed from."""

from __future__ import annotations

import importlib
import inspect
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal

import pytest
import yaml

from robodyn import load
from robodyn.counts import Count
from robodyn.effects import thesis_friction
from robodyn.robot import Robot
from robodyn.schedule import TASKS, elimination, friction_tasks, general_graph, graph
from robodyn.thesis import claims, steps
from robodyn.thesis.claims import Arms, formulations, friction, processors, tasks
from robodyn.thesis.tables import customised, make
from robodyn.thesis.tables.claims import read_claims
from thesis.recomputed import Patch, changed, table

REVIEW = yaml.safe_load(Path(__file__).with_name("claims.yaml").read_text(encoding="utf-8"))
MODULES = ("formulations", "listings", "friction", "tasks", "processors")


def ours(row: str) -> dict[str, Any]:
    """Its figures before anything was patched."""
    return dict(table("claims").row(row).ours)


def test_numbers_sections_verdicts_and_figures_are_the_reviews() -> None:
    rows = table("claims").to_dict()["rows"]
    for row, review in zip(rows, REVIEW, strict=True):
        figures = {name: row["ours"].get(name) for name in review["ours"]}
        assert {**row, "ours": figures}.items() >= review.items(), row["row"]
    assert sorted({row["number"] for row in rows}) == list(range(1, 95))


@pytest.mark.thorough
def test_a_verdict_stands_in_the_data_only_where_no_figure_decides() -> None:
    recomputed = Arms()
    for claim in read_claims():
        _, holds = claim.recompute(recomputed)
        assert (
            claim.by is None or claim.verdict == "not recoverable" or (holds is None) == bool(claim.verdict)
        )
        assert claim.by or (claim.verdict and claim.ours.startswith("not recomputed")), claim.name


def test_every_function_belongs_to_a_claim() -> None:
    functions = {
        f"{name}.{function}"
        for name in MODULES
        for module in [importlib.import_module(f"robodyn.thesis.claims.{name}")]
        for function, value in vars(module).items()
        if inspect.isfunction(value) and value.__annotations__.get("return") == "Outcome"
        if function[0] != "_" and value.__module__ == module.__name__
    }
    assert functions == {claim.by for claim in read_claims() if claim.by}


def test_what_follows_from_printed_figures_is_apart() -> None:
    row: dict[str, Any] = table("claims").row("lambda form").to_dict()
    assert row["printed"].keys() == {"claim", "range_pct"}
    assert row["derived_from_printed"] == {"revolute": 34.9, "prismatic": 43.5}


def test_they_follow_the_counts(monkeypatch: Patch) -> None:
    def dearer(robot: Robot, formulation: str) -> Count:
        count = customised.plain(robot, formulation)
        return replace(count, mul=count.mul + 40) if formulation == "balafoutis" else count

    before, _ = formulations.no_advantage(Arms())
    monkeypatch.setattr(formulations, "plain", dearer)
    after, _ = formulations.no_advantage(Arms())
    assert [each["apart"]["balafoutis"]["customised_pct"] for each in (before, after)] == [-9.4, -1.2]


def test_they_follow_the_schedules_and_the_friction(monkeypatch: Patch) -> None:
    monkeypatch.setattr(thesis_friction, "journal_bearing", lambda mu, r, d, f, n, sign, **_: mu * f[0])
    bearings = {**friction_tasks._BEARINGS, "journal": friction_tasks._BEARINGS["torque"]}
    monkeypatch.setattr(friction_tasks, "_BEARINGS", bearings)
    load, _ = friction.load_with_friction(Arms())
    assert load["percent"] == 2.9
    assert load["tasks_percent"] < 10
    loose = replace(general_graph(6), after={task: frozenset() for task in general_graph(6).tasks})
    levels = processors.best_levels(loose, 7)
    assert processors.efficiency_share(loose, levels, 7) == 100  # nothing waits: all of them are busy


@pytest.mark.thorough
def test_they_follow_the_graphs_edges(monkeypatch: Patch) -> None:
    """Nothing handed back from the tip: the chain grows shorter. a besides waiting for lambda: longer."""
    fewer = tuple(replace(task, after=()) if task.row in (30, 31, 39, 40) else task for task in TASKS)
    monkeypatch.setattr(graph, "TASKS", fewer)
    loose = make("claims").row("parallel cost")
    waits: dict[int, tuple[Literal[-1, 0], int]] = {1 + 17: (0, 11), 4: (-1, 18)}
    more = tuple(
        replace(task, after=(*task.after, waits[task.row])) if task.row in waits else task for task in TASKS
    )
    monkeypatch.setattr(graph, "TASKS", more)
    tight = make("claims")
    assert loose.verdict == tight.row("parallel cost").verdict == "differs"
    assert loose.ours["layers"] < 27 < tight.row("parallel cost").ours["layers"]
    assert tight.row("speed-up").verdict == "differs"
    assert tight.row("six-link load").verdict == "reproduced"
    assert tight.row("least Stanford time").ours["levels"] > 25


@pytest.mark.thorough
def test_they_follow_the_rules_of_elimination(monkeypatch: Patch) -> None:
    """Nothing spared for the first and the last link: more tasks, wider layers, another share saved."""
    names = ("Stanford load", "six-link efficiency", "task reduction")
    printed = "maximum concurrency"  # of the tasks of Table 4.7, which no rule gives
    before = {name: ours(name) for name in (*names, printed)}
    monkeypatch.setattr(elimination, "FIRST_LINK", frozenset())
    monkeypatch.setattr(elimination, "LAST_LINK", frozenset())
    found = make("claims")
    assert found.row("six-link load").ours["subtasks"] == 43 * 6
    assert found.row("six-link load").verdict == "differs"
    assert all(found.row(name).ours != before[name] for name in names)
    assert found.row(printed).ours == before[printed]


def test_they_follow_the_steps_the_robot_and_friction(monkeypatch: Patch) -> None:
    corrected = "subtasks_step_3_corrected"
    form, load = formulations.lambda_form(Arms())[0], tasks.stanford_load(Arms())[0]
    monkeypatch.setattr(steps, "moment", lambda N, s, F, p_next, f_next, n_next: n_next)
    monkeypatch.setattr(thesis_friction, "driving", lambda tau, e, b, sign: tau / e)
    for module in (claims, tasks):
        monkeypatch.setattr(module, "bundled", changed("stanford", 2, com=(Fraction(1),) * 3))
    assert formulations.lambda_form(Arms())[0]["revolute"] > form["revolute"]
    assert tasks.stanford_load(Arms())[0][corrected] == load[corrected] + 6
    assert friction.transmissions_alone(Arms()) == ({"without_joint_friction": 2}, False)


def test_products_of_inertia_of_makers_arms() -> None:
    """What the reason of claim 27 says of the example arms, which are not in the package."""
    files = sorted((Path(__file__).parents[2] / "examples" / "arms").glob("*.yaml"))
    inertias = [[link.inertia for link in load(arm, warn=lambda _: None).links] for arm in files]
    oblique = [arm for arm in inertias if any(any((i.xy, i.xz, i.yz)) for i in arm)]
    (claim,) = (claim for claim in read_claims() if claim.claim_number == 27)
    assert f"of the {len(files)} arms from makers' files in examples/arms {len(oblique)} have" in claim.reason
