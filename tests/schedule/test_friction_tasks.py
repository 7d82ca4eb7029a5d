"""Friction as tasks: the thesis's equations, three operations each, after what they read."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from graphlib import TopologicalSorter
from typing import Any

import pytest

from robodyn import InputError, load
from robodyn.counts.general import Tally
from robodyn.effects import thesis_friction as thesis
from robodyn.report.schedules import links_source, robot_source
from robodyn.robot.model import EffectEntry
from robodyn.schedule import TASKS, Machine, general_graph, robot_graph, solve
from robodyn.schedule import friction_tasks as module
from robodyn.schedule.friction_tasks import (
    Bearing,
    Efficiency,
    Friction,
    Site,
    chosen_friction,
    friction_of,
    friction_tasks,
    run_friction,
)
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.thesis.case_arm import robots
from robodyn.thesis.tables import make
from robodyn_testing import representative

BEARINGS: tuple[Bearing, ...] = ("journal", "linear", "thrust", "radial", "torque")
EFFICIENCIES: tuple[Efficiency, ...] = ("constant", "linear", "cubic")
KINDS = [
    Friction(bearing, transmission)
    for bearing in (None, *BEARINGS)
    for transmission in (None, *EFFICIENCIES)
    if bearing or transmission
]
MU, R, D, BREAKAWAY, E = 0.1, 0.08, 0.2, 5.5, (0.4, 0.012, -0.0003, 0.00001)


def name(friction: Friction) -> str:
    return f"{friction.bearing}-{friction.transmission}"


def constants(friction: Friction) -> dict[str, Any]:
    factor = {"journal": MU * R / D, "linear": MU / D, "torque": MU}.get(friction.bearing or "", MU * R)
    return {"h": D / 2, "k": factor, "breakaway": BREAKAWAY, "e": E, "efficiency": E[0], "inverse": 1 / E[0]}


def expected(friction: Friction, f: Any, n: Any, torque: float, direction: int) -> float:
    """By the equations, as the effects have them."""
    rubbing: dict[str | None, Callable[[], Any]] = {
        None: lambda: 0.0,
        "journal": lambda: thesis.journal_bearing(MU, R, D, f, n, direction),
        "linear": lambda: thesis.linear_bearing(MU, D, f, n, direction),
        "thrust": lambda: thesis.thrust_bearing(MU, R, f, direction),
        "radial": lambda: MU * R * math.hypot(f[0], f[1]) * direction,
        "torque": lambda: MU * abs(torque) * direction,
    }
    total = thesis.with_friction(torque, rubbing[friction.bearing]())
    if friction.transmission is None:
        return float(total)
    efficiencies: dict[str, Callable[[], Any]] = {
        "constant": lambda: E[0],
        "linear": lambda: thesis.linear_efficiency(abs(total), E),
        "cubic": lambda: thesis.cubic_efficiency(abs(total), E),
    }
    efficiency = efficiencies[friction.transmission]()
    law = thesis.driving if total * direction > 0 else thesis.braking
    return float(law(total, efficiency, BREAKAWAY, direction))


def site(friction: Friction, seed: int) -> tuple[Site, float]:
    rng = random.Random(seed)
    f, n = (tuple(rng.uniform(-9, 9) for _ in range(3)) for _ in range(2))
    torque, direction = rng.uniform(-20, 20), rng.choice((-1, 1))
    wanted = expected(friction, f, n, torque, direction)
    with_joint = expected(replace(friction, transmission=None), f, n, torque, direction)
    drives = with_joint * direction > 0
    return Site(f, n, torque, direction, drives, constants(friction)), wanted  # type: ignore[arg-type]


@pytest.mark.parametrize("friction", KINDS, ids=name)
def test_the_tasks_compute_the_equations_in_every_order_that_the_graph_allows(friction: Friction) -> None:
    """A task that read what it does not wait for would fail, or give something else."""
    numbers = {task.row for task in friction_tasks(friction)}
    needs = {
        task.row: [other for _, other in task.after if other in numbers] for task in friction_tasks(friction)
    }
    for seed in range(20):
        rng, sorter = random.Random(seed), TopologicalSorter(needs)
        sorter.prepare()
        order: list[int] = []
        waiting: list[int] = []
        while sorter.is_active():
            waiting += sorter.get_ready()
            order.append(waiting.pop(rng.randrange(len(waiting))))
            sorter.done(order[-1])
        at, wanted = site(friction, seed)
        assert run_friction(friction, at, tuple(order)) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.parametrize("friction", KINDS, ids=name)
@pytest.mark.parametrize("drives", [True, False])
def test_no_task_takes_more_than_three_operations(friction: Friction, drives: bool) -> None:
    ledger: dict[str, int] = {}

    def number(fixed: bool = False) -> Any:
        return Tally(ledger, fixed)

    def vector() -> Any:
        return number(), number(), number()

    fixed = {key: number(True) for key in ("h", "k", "breakaway", "efficiency", "inverse")}
    at = Site(
        vector(), vector(), number(), number(), drives, {**fixed, "e": [number(True) for _ in range(4)]}
    )
    for task in friction_tasks(friction):
        ledger.clear()
        try:
            run_friction(friction, at, (task.row,))
        except KeyError:
            assert task.row != friction_tasks(friction)[-1].row  # only "out" is not there yet
        done = sum(count for kind, count in ledger.items() if kind != "sqrt")
        assert 1 <= done <= FLOPS_PER_TASK, task


def test_a_joint_with_both_has_eight_tasks_as_24_operations_fill() -> None:
    both = chosen_friction("both")
    assert both is not None
    assert [task.row for task in friction_tasks(both)] == [44, 45, 46, 47, 48, 49, 50, 53]
    assert len({task.row for task in TASKS} & {task.row for task in friction_tasks(both)}) == 0
    found = make("friction")
    assert [found.row(f"tasks a joint, {kind}").verdict for kind in ("both", "transmission")] == [
        "reproduced", "reproduced",
    ]  # fmt: skip


@pytest.mark.parametrize("n", [2, 6])
def test_friction_adds_its_tasks_and_a_few_levels_whatever_the_number_of_joints(n: int) -> None:
    plain = general_graph(n)
    for friction, tasks, levels in (
        (Friction("journal"), 6 * n + 1, 3),
        (Friction(None, "linear"), 2 * n, 2),
        (Friction("journal", "linear"), 8 * n + 1, 5),
        (Friction("journal", "cubic"), 10 * n + 1, 6),
    ):
        graph = general_graph(n, friction)
        assert len(graph) - len(plain) == tasks
        assert graph.critical_path - plain.critical_path == levels
        assert (126 in graph.after) == friction.loaded
        assert 126 not in plain.after
        for task in plain.tasks:  # no task of the dynamics waits for friction
            assert all(other % 100 <= 43 for other in graph.after[task])


@pytest.mark.parametrize("p", representative(range(2, 14), 2, 5, 13, rest="slow"))
def test_the_case_studys_arm_with_and_without_friction(p: int) -> None:
    arms = robots(0.0, 0.2)
    figures = {"rigid": (72, 15), "with_bearings": (91, 18), "complete": (103, 21)}
    levels = {"rigid": [36, 24, 18], "with_bearings": [46, 31, 23, 19], "complete": [52, 35, 27, 22]}
    for which, (tasks, chain) in figures.items():
        graph = robot_graph(getattr(arms, which))
        assert (len(graph), graph.critical_path) == (tasks, chain)
        solved = solve(graph, Machine(p), "df-ihs", seconds=1e9, nodes=20_000)
        assert solved.optimal
        known = levels[which]
        assert solved.timetable.levels == (known[p - 2] if p - 2 < len(known) else chain)


def test_what_a_robot_has_of_friction() -> None:
    complete = robots(0.0, 0.2).complete
    assert friction_of(complete) == dict.fromkeys((1, 2, 3), Friction("journal", "cubic"))
    gear = EffectEntry("transmission_loss", 2, (("breakaway", Fraction(1)), ("efficiency", Fraction(1, 2))))
    spanless = EffectEntry("load_dependent_friction", 1, (("bearing", "journal"), ("mu_r", Fraction(1, 100))))
    viscous = EffectEntry("viscous_friction", 3, (("coefficient", Fraction(1)),))
    mixed = replace(complete, effects=(gear, spanless, viscous))
    assert friction_of(mixed) == {1: Friction("radial"), 2: Friction(None, "constant")}
    notes = " ".join(robot_source(mixed).notes)
    assert "effects in its joints that have no tasks" in notes
    assert "no tasks" not in " ".join(robot_source(complete).notes).replace("prints none", "")


def test_sources_with_friction_say_what_there_is_without() -> None:
    source = links_source(6, friction=Friction("journal", "linear"))
    assert source.plain is not None
    assert (len(source.graph), len(source.plain)) == (280, 231)
    assert "49 tasks more, and 5 levels more" in source.notes[0]
    stanford = load("stanford")
    assert robot_source(stanford).plain is None
    own = robot_source(stanford, friction={3: Friction("linear")})
    assert own.plain is not None
    assert len(own.plain) == 154 == len(own.graph) - 5
    for refused in ({"as_printed": True}, {"costs": {"mul": 1, "add": 1}}):
        with pytest.raises(InputError, match="friction"):
            links_source(6, friction=Friction("journal"), **refused)
    with pytest.raises(InputError, match="no tasks of friction"):
        robot_source(stanford, as_printed=True, friction={1: Friction("journal")})


@pytest.mark.thorough
def test_the_table_of_friction(monkeypatch: pytest.MonkeyPatch) -> None:
    found = make("friction")
    both = found.row("six joints, both").ours
    assert (both["tasks"], both["critical_path"]) == (280, 32)
    assert list(both["levels"].values()) == list(both["bounds"].values())
    assert list(both["levels"].values()) == [140, 94, 70, 56, 47, 41, 36, 33, 32, 32, 32, 32]
    assert found.row("case study, both").ours["tasks"] == 103
    shorter = dict(module._TRANSMISSIONS)
    shorter["linear"] = shorter["constant"]
    monkeypatch.setattr(module, "_TRANSMISSIONS", shorter)
    after = make("friction")
    assert after.row("tasks a joint, both").verdict == "differs"
    assert after.row("six joints, both").ours["tasks"] == 274
