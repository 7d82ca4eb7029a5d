"""``robodyn bench`` and ``robodyn plan``: honest figures, deadlines, and what is refused."""

from __future__ import annotations

import importlib.util
import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from cli.command import Capture, run
from robodyn.bench.parallel_bench import Measured
from robodyn.bench.plan import chosen, parse_deadline, parse_target, plans
from robodyn.report.benchmarks import time_text
from robodyn.robot import bundled_text, load
from robodyn.schedule.tasks import FLOPS_PER_TASK
from robodyn.targets import TARGETS, planned_targets
from robodyn.thesis.printed import LEVELS_STANFORD, TIMES_STANFORD
from robodyn_testing import require_tool

# --- bench --------------------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_bench_measures_and_says_what_follows(capsys: Capture) -> None:
    require_tool("cc")
    out, _ = run(capsys, "bench", "puma560_3dof", "-p", "2", "--states", "300", "--json")
    found = json.loads(out)
    assert (found["robot"], found["operations"]) == ("puma560_3dof", 80)
    assert found["serial_ns"] > 0
    assert found["packed"]["lanes"] == 4
    assert [row["sync"] for row in found["threads"]] == ["barrier", "counters"]
    for row in found["threads"]:
        assert row["wins"] == (row["speedup"] > 1)
        assert row["schedule_speedup"] > 1
        even = row["break_even"]
        assert even is None or even["operations_in_all"] > 0
    assert {row["key"] for row in found["kernels"]} >= {"builtin", "libm", "given"}
    assert found["kernels"][0]["ratio"] == 1
    assert {row["key"] for row in found["python"]} >= {"workspace", "function", "batch-F", "batch-C"}
    assert all(row["ns"] > 0 for row in [*found["kernels"], *found["python"]])
    require_tool("valgrind")
    counts = {row["key"]: row["instructions"] for row in found["kernels"]}
    assert 80 < counts["given"] < counts["libm"]  # it has 80 operations


@pytest.mark.thorough
def test_bench_names_what_is_not_measured(capsys: Capture, monkeypatch: pytest.MonkeyPatch) -> None:
    require_tool("cc")
    find = shutil.which
    monkeypatch.setattr(
        shutil, "which", lambda name, *a, **k: None if name == "valgrind" else find(name, *a, **k)
    )
    known = importlib.util.find_spec
    monkeypatch.setattr(
        importlib.util,
        "find_spec",
        lambda name, *a: None if name in ("pinocchio", "casadi") else known(name, *a),
    )
    out, _ = run(capsys, "bench", "puma560_3dof", "-p", "2", "--states", "200")
    assert "not measured: instructions: needs valgrind" in out
    assert "not measured: pin: not installed (pip install pin)" in out
    assert "not measured: casadi: not installed" in out
    assert "pin.rnea" not in out
    assert "ns an operation" in out
    assert "threads win here" in out or "threads lose to the serial kernel here" in out


@pytest.mark.thorough
def test_bench_beside_peers_that_do_not_know_the_robot(capsys: Capture, tmp_path: Path) -> None:
    require_tool("cc")
    before, at, after = bundled_text("puma560_3dof").partition("    motor_inertia: 1.14\n")
    path = tmp_path / "rubbing.yaml"
    path.write_text(f"{before}{at}    friction: {{viscous: 1, coulomb: 2}}\n{after}")
    arguments = ("bench", str(path), "-p", "2", "--states", "200")
    out, _ = run(capsys, *arguments)
    assert "not measured: pin: puma560_3dof has friction" in out
    assert "robodyn, built-in sine and cosine" in out
    path.write_text(f"{before}    motor_inertia: rotor\n{after}")
    out, _ = run(capsys, *arguments)
    assert "not measured: calls beside peers: puma560_3dof has run-time parameters" in out


def test_where_threads_break_even() -> None:
    """1000 operations of 1 ns, 600 of them one after another on 2 threads, 2000 ns of waiting."""
    row = Measured(2, "barrier", 100, 20, 1000.0, 2600.0, 1000, 600, 200)
    assert row.waiting_ns == 2000
    assert row.break_even == 5.0
    assert row.to_dict()["break_even"] == {"operations_a_task": 25.0, "operations_in_all": 5000.0}
    assert row.to_dict()["ns_a_meeting"] == 100
    longer = Measured(2, "barrier", 100, 20, 5000.0, 5000.0, 5000, 3000, 200)
    assert longer.break_even == 1.0  # tasks five times as long, the same waiting
    assert not row.wins
    assert row.speedup_at(5) == pytest.approx(1000 / 2600)
    assert row.speedup_at(25) == pytest.approx(1)
    assert 1.6 < row.speedup_at(300_000) < 1000 / 600
    assert Measured(2, "barrier", 100, 20, 1000.0, 900.0, 1000, 600, 200).wins
    assert Measured(1, "barrier", 100, 0, 1000.0, 900.0, 1000, 1000, 200).break_even is None


# --- plan ---------------------------------------------------------------------------------------------------


def planned(capsys: Capture, *arguments: str, code: int = 0) -> Any:
    return json.loads(run(capsys, "plan", *arguments, "--json", code=code)[0])


def test_the_fewest_cores_that_meet_the_deadline(capsys: Capture) -> None:
    robot, own = "puma560_3dof", "--target=slow:cores=4,mhz=1,pass=1,sincos=0"
    easy = planned(capsys, robot, "-p", "4", "--deadline", "90us", own)
    assert easy["chosen"]["processors"] == 1
    assert easy["chosen"]["formulation"] == "record"
    assert easy["chosen"]["time_ns"] == 80_000  # 80 operations of a microsecond
    hard = planned(capsys, robot, "-p", "4", "--deadline", "60us", own)
    assert hard["chosen"]["processors"] > 1
    fewer = [plan for plan in hard["plans"] if plan["processors"] < hard["chosen"]["processors"]]
    assert fewer
    assert all(plan["time_ns"] > 60_000 for plan in fewer)
    assert hard["chosen"]["meets"]
    for plan in hard["plans"]:
        assert plan["lower_bound_ns"] <= plan["time_ns"]
        assert plan["meets"] == (plan["time_ns"] <= 60_000)


@pytest.mark.thorough
def test_this_machine_is_measured(capsys: Capture) -> None:
    require_tool("cc")
    found = planned(capsys, "puma560_3dof", "-p", "2", "--deadline", "1s", "--target", "here")
    assert found["chosen"]["target"] == "here"
    assert found["chosen"]["processors"] == 1
    assert 1 < found["chosen"]["time_ns"] < 1e6


def test_passing_values_that_costs_much_leaves_one_core() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    far = parse_target("far:cores=4,mhz=1000,pass=100000")
    assert {plan.processors for plan in plans(robot, 4, [far])} == {1}
    near = parse_target("near:cores=8,mhz=1000,pass=0")
    assert max(plan.processors for plan in plans(robot, 4, [near])) == 4
    assert chosen(plans(robot, 2, [near]), 1.0) is None


@pytest.mark.parametrize(
    ("text", "ns"), [("100us", 1e5), ("0.5 ms", 5e5), ("800ns", 800.0), ("2s", 2e9), ("1e-1us", 100.0)]
)
def test_deadlines(text: str, ns: float) -> None:
    assert parse_deadline(text) == pytest.approx(ns)


def test_a_plan_is_for_the_scalar_type_that_is_asked_for(capsys: Capture) -> None:
    """A Cortex-M4F has float in hardware and double in software."""
    arguments = ("puma560_3dof", "--deadline", "1s", "--target", "cortex-m4f")
    own, single, double = (
        planned(capsys, *arguments, *more)["chosen"]["time_ns"]
        for more in ((), ("--scalar", "float"), ("--scalar", "double"))
    )
    assert own == single
    assert double > 30 * single


def test_known_targets_say_where_their_figures_are_from() -> None:
    chips = {target.name: target.chip for target in planned_targets()}
    assert all(chip is not None and chip.source for chip in chips.values())
    task_ns = 1e6 * TIMES_STANFORD[1] / LEVELS_STANFORD[1]
    assert TARGETS["thesis-1990"].chip is not None
    assert TARGETS["thesis-1990"].chip.cycle_ns == pytest.approx(task_ns / FLOPS_PER_TASK)
    assert [time_text(x) for x in (12.0, 1500.0, 2e6, 3e9)] == ["12 ns", "1.5 us", "2 ms", "3 s"]
