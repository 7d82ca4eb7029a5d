"""``robodyn plan`` as text: every schedule that was tried, and the command for the best one."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

from robodyn.bench.plan import FORMULATIONS, Plan, chip_of, chosen
from robodyn.dynamics.functions import function_named
from robodyn.robot.model import Robot
from robodyn.targets import Target


def plan_text(
    robot: Robot,
    source: str,
    candidates: Sequence[Plan],
    targets: Sequence[Target],
    deadline_ns: float,
    function: str = "inverse_dynamics",
) -> str:
    """All plans for a person, those that meet the deadline marked; ``source`` names ``robot`` in commands."""
    best = chosen(candidates, deadline_ns)
    lines = [f"{robot.name}: deadline {time_text(deadline_ns)}", ""]
    lines.append(
        "target       formulation            p  tasks of  waits     tasks  operations        time  meets"
    )
    for plan in candidates:
        how = "-" if plan.cut is None else ("levels" if plan.levels else "counters")
        lines.append(
            f"{plan.target:<12} {plan.formulation:<21} {plan.processors:>2}  {plan.cut or 'all':>8}  "
            f"{how:<8} "
            f"{plan.tasks:>6}  {plan.operations:>10}  {time_text(plan.time_ns):>10}  "
            f"{'yes' if plan.time_ns <= deadline_ns else 'no'}"
        )
    lines.append("")
    if best is None:
        lines.append(f"nothing meets it; the shortest is {time_text(candidates[0].time_ns)}")
    else:
        lines.append(f"take {best.formulation} on {best.target}, {_how(source, best, function)}")
    lines += [
        f"{target.name}: {chip.cores} cores, {chip.mhz:.4g} MHz; {chip.source}"
        for target, chip in ((target, chip_of(target)) for target in targets)
    ]
    lines.append(
        "times are the schedules', by the targets' costs: estimates, until robodyn bench has measured them"
    )
    return "\n".join(lines) + "\n"


def _how(source: str, plan: Plan, function: str) -> str:
    robot = shlex.quote(source)
    known = function_named(function)
    options = FORMULATIONS[plan.formulation]
    switches = "".join(
        f" --{name} {value}" for name, value in options.items() if (name, value) != ("optimize", "record")
    )
    if plan.cut is None:
        named = "" if known.by_default else f" --functions {function}"
        return f"one core: robodyn gen {robot}{named}{switches}"
    waits = "" if plan.levels else " --no-levels"
    waits += "" if known.is_recursion else f" --functions {function}"
    return (
        f"{plan.processors} cores: robodyn schedule {robot} -p {plan.processors} --cut "
        f"{plan.cut}{waits}{switches} "
        "-o DIR"
    )


def time_text(ns: float) -> str:
    """A time [ns] with the largest unit of which it is at least one: 1.5 us."""
    for size, unit in ((1e9, "s"), (1e6, "ms"), (1e3, "us")):
        if ns >= size:
            return f"{ns / size:.4g} {unit}"
    return f"{ns:.4g} ns"
