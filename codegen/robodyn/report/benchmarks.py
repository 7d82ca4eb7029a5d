"""``robodyn bench`` as text: kernels beside peers, and threads beside the serial kernel."""

from __future__ import annotations

import shlex
from collections.abc import Sequence

from robodyn.bench.kernel_bench import KernelBench
from robodyn.bench.parallel_bench import SIZES, Bench
from robodyn.bench.plan import FORMULATIONS, Plan, chip_of, chosen
from robodyn.dynamics.functions import function_named
from robodyn.robot.model import Robot
from robodyn.targets import Target


def kernel_text(measured: KernelBench) -> str:
    """Kernels in C and calls from Python: time, ratio to the first of its kind, instructions."""
    lines = []
    head = f"{'':<48} {'ns':>10} {'ratio':>8}"
    if measured.native:
        title = f"one state after another in C ({measured.flags})"
        lines += [title, f"{head} {'instructions':>14}"]
    missing = "not measured" if "instructions" in measured.absent else "-"
    for row in measured.native:
        counted = missing if row.instructions is None else f"{row.instructions:.0f}"
        lines.append(f"{row.title:<48} {row.ns:>10.1f} {row.ratio:>8.2f} {counted:>14}")
    if measured.python:
        lines += ["", "from Python, a state", head]
        lines += [f"{row.title:<48} {row.ns:>10.1f} {row.ratio:>8.2f}" for row in measured.python]
    lines += [f"not measured: {what}: {why}" for what, why in measured.absent.items()]
    return "\n".join(lines) + "\n"


def bench_text(bench: Bench) -> str:
    """Threads beside the serial kernel, from what size of task they win, and whether they win here."""
    first, serial, packed = bench.rows[0], bench.serial_ns, bench.packed_ns
    lines = [
        f"{bench.robot} {bench.function}: {first.operations} operations, {first.tasks} tasks; "
        f"{bench.cores} cores, {bench.compiler}",
        f"serial {serial:.0f} ns, {serial / first.operations:.2f} ns an operation; "
        f"packed, {bench.packed_lanes} lanes: {packed:.0f} ns ({packed / serial:.2f} times serial)",
        "",
        "threads  sync      levels  meetings  parallel ns  ns a meeting  speed-up  of schedule  wins "
        "from (operations)",
    ]
    for row in bench.rows:
        sizes = row.break_even_sizes
        size = "{operations_a_task:.0f} a task, {operations_in_all:.0f}".format(**sizes) if sizes else "never"
        each = f"{row.waiting_ns / row.meetings:.0f}" if row.meetings else "-"
        lines.append(
            f"{row.processors:>7}  {row.waiting:<8}  {row.levels:>6}  {row.meetings:>8}  "
            f"{row.parallel_ns:>11.0f}  {each:>12}  {row.serial_ns / row.parallel_ns:>8.3f}  "
            f"{row.operations / row.chain:>11.2f}  {size}"
        )
    lines += ["", "expected speed-up by operations a task, with the same waiting time:"]
    lines.append("threads  sync    " + "".join(f"{size:>10}" for size in SIZES))
    for row in bench.rows:
        cells = "".join(f"{row.speedup_at(size):>10.3f}" for size in SIZES)
        lines.append(f"{row.processors:>7}  {row.waiting:<8}{cells}")
    best = min((row for row in bench.rows if row.wins), key=lambda row: row.parallel_ns, default=None)
    verdict = "threads lose to the serial kernel here: synchronisation costs more than is saved"
    if best is not None:
        times = best.serial_ns / best.parallel_ns
        verdict = f"threads win here: {best.processors} of them, {best.waiting}, {times:.2f} times"
    lines += ["", verdict]
    if bench.load is not None and bench.load > bench.cores + 0.5:
        lines.append(f"the machine is busy (load {bench.load:.1f}): synchronisation is faster on an idle one")
    crowded = sorted({row.processors for row in bench.rows if row.processors > bench.cores})
    if crowded:
        threads = ", ".join(map(str, crowded))
        lines.append(f"with {bench.cores} cores, {threads} threads share cores: they take turns")
    return "\n".join(lines) + "\n"


def plan_text(
    robot: Robot,
    source: str,
    candidates: Sequence[Plan],
    targets: Sequence[Target],
    deadline_ns: float,
    function: str = "inverse_dynamics",
) -> str:
    """All plans for a person, those that meet the deadline marked; ``source`` names ``robot`` in commands."""
    lines = [
        f"{robot.name}: deadline {time_text(deadline_ns)}",
        "",
        "target       formulation            p  tasks of  waits     tasks  operations        time  meets",
    ]
    for plan in candidates:
        waits = "-" if plan.cut is None else ("levels" if plan.levels else "counters")
        lines.append(
            f"{plan.target:<12} {plan.formulation:<21} {plan.processors:>2}  {plan.cut or 'all':>8}  "
            f"{waits:<8} {plan.tasks:>6}  {plan.operations:>10}  {time_text(plan.time_ns):>10}  "
            f"{'yes' if plan.time_ns <= deadline_ns else 'no'}"
        )
    best = chosen(candidates, deadline_ns)
    verdict = f"nothing meets it; the shortest is {time_text(candidates[0].time_ns)}"
    if best is not None:
        verdict = f"take {best.formulation} on {best.target}, {_command(source, best, function)}"
    lines += ["", verdict]
    for target in targets:
        chip = chip_of(target)
        lines.append(f"{target.name}: {chip.cores} cores, {chip.mhz:.4g} MHz; {chip.source}")
    lines.append(
        "times are the schedules', by the targets' costs: estimates, until robodyn bench has measured them"
    )
    return "\n".join(lines) + "\n"


def _command(source: str, plan: Plan, function: str) -> str:
    robot, record = shlex.quote(source), function_named(function)
    options = FORMULATIONS[plan.formulation].items()
    switches = "".join(f" --{name} {value}" for name, value in options if value != "record")
    if plan.cut is None:
        named = "" if record.by_default else f" --functions {function}"
        return f"one core: robodyn gen {robot}{named}{switches}"
    waits = "" if plan.levels else " --no-levels"
    waits += "" if record.is_recursion else f" --functions {function}"
    return (
        f"{plan.processors} cores: robodyn schedule {robot} -p {plan.processors} --cut "
        f"{plan.cut}{waits}{switches} -o DIR"
    )


def time_text(ns: float) -> str:
    """A time [ns] with the largest unit of which it is at least one: 1.5 us."""
    size, unit = next(((s, u) for s, u in ((1e9, "s"), (1e6, "ms"), (1e3, "us")) if ns >= s), (1.0, "ns"))
    return f"{ns / size:.4g} {unit}"
