"""Which formulation, which schedule and which target meet a deadline: the thesis's further work.

Every candidate is a program for the robot, cut into tasks and scheduled on some of a target's cores with the
target's cost of communication. It is judged by the time that its schedule takes.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Final

from robodyn.dynamics.functions import function_named
from robodyn.errors import InputError
from robodyn.ir.program import Program
from robodyn.ir.signature import ScalarType
from robodyn.kernels.generate import Options, program
from robodyn.robot.model import Robot
from robodyn.schedule import Machine, solve
from robodyn.schedule.cutting import COSTS, cut
from robodyn.targets import Chip, Costs, Target, planned_targets, target_named

#: Programs of the inverse dynamics that are tried, by the names of their options.
FORMULATIONS: Final[dict[str, Mapping[str, Any]]] = {
    "record": {"optimize": "record"},
    "modified_newton_euler": {"optimize": "none"},
    "newton_euler": {"formulation": "newton_euler", "optimize": "none"},
    "balafoutis": {"formulation": "balafoutis", "optimize": "none"},
}
#: Operations a task that are tried: coarser tasks pass fewer values and leave less to do side by side.
CUTS: Final = (1, 3, 8, 20, 60)


@dataclass(frozen=True, slots=True)
class Plan:
    """A way of computing: formulation, target, processors, tasks, and the time it takes [ns]."""

    target: str
    formulation: str
    processors: int
    cut: int | None
    levels: bool
    tasks: int
    operations: int
    time_ns: float
    lower_bound_ns: float

    def to_dict(self, deadline_ns: float) -> dict[str, Any]:
        """As ``plan --json`` prints it."""
        plan = {"synchronised" if key == "levels" else key: value for key, value in asdict(self).items()}
        return plan | {"meets": self.time_ns <= deadline_ns}


def parse_deadline(text: str) -> float:
    """``100us``, ``0.5 ms``, ``800 ns`` as nanoseconds.

    Raises
    ------
    InputError: not of that form, or not above 0.
    """
    match = re.fullmatch(r"\s*(\d+(?:\.\d+)?(?:e-?\d+)?)\s*(ns|us|ms|s)\s*", text)
    value = float(match[1]) * {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}[match[2]] if match else 0.0
    if not 0 < value < 1e15:
        raise InputError("the deadline cannot be read", found=repr(text), expected="100us, 0.5ms or 800ns")
    return value


#: A target of one's own, where it says nothing: cores, MHz, ns to pass a value, cycles of operations.
_OWN: Final = {
    "cores": 1.0, "mhz": 100.0, "pass": 0.0,
    "mul": 1.0, "add": 1.0, "div": 14.0, "sqrt": 14.0, "sincos": 46.0,
}  # fmt: skip


def parse_target(text: str) -> Target:
    """A target by its name, or one's own: ``NAME:cores=4,mhz=1500,pass=150,mul=1,add=1,div=14,sincos=46``.

    Raises
    ------
    InputError: unknown, or not of that form.
    """
    name, colon, rest = text.partition(":")
    if not colon:
        return target_named(
            name, planned_targets(), others=", here, or NAME:cores=4,mhz=1500,pass=150,mul=1 ..."
        )
    own = dict(_OWN)
    for part in filter(None, rest.split(",")):
        key, _, value = (piece.strip() for piece in part.partition("="))
        if key not in own or not re.fullmatch(r"\d+(\.\d+)?", value) or len(value) > 12:
            raise InputError(
                "a target cannot be read", found=repr(part), expected=f"KEY=NUMBER, keys {', '.join(own)}"
            )
        own[key] = float(value)
    if own["cores"] < 1 or own["mhz"] <= 0:
        raise InputError("a target has cores and a clock", found=repr(text))
    costs = Costs(own["mul"], own["add"], None, own["div"], own["sqrt"], own["sincos"])
    chip = Chip(own["mhz"], "as asked for", int(own["cores"]), own["pass"])
    return Target(name or "own", "a target of one's own", costs, chip=chip)


def here(robot: Robot, tell: Callable[[str], None] = lambda _: None) -> Target:
    """This machine, measured: the robot's own kernel serial and on two threads.

    Raises
    ------
    ToolError: no compiler, or no threads.
    """
    from robodyn.bench.parallel_bench import bench
    from robodyn.optimize.programs import signature

    tell("measuring this machine")
    tasks = cut(program(robot, "inverse_dynamics"), 8)
    measured = bench(robot, signature(robot, "inverse_dynamics"), tasks, (2,))
    row = min(measured.rows, key=lambda row: row.parallel_ns)
    load = "" if measured.load is None else f", load {measured.load:.1f}"
    chip = Chip(
        1e3 / row.operation_ns,
        f"measured now on {robot.name} with {measured.compiler}{load}; an operation a cycle",
        measured.cores,
        row.waiting_ns / row.meetings if row.meetings else 0.0,
    )
    costs = Costs(div=1.0, sqrt=1.0, sincos=0.0)  # sines are in what an operation takes
    return Target("here", "this machine", costs, chip=chip)


def plans(
    robot: Robot,
    processors: int,
    targets: Sequence[Target],
    *,
    function: str = "inverse_dynamics",
    scalar: ScalarType | None = None,
    tell: Callable[[str], None] = lambda _: None,
) -> list[Plan]:
    """Everything that was tried, of each target and formulation the best schedule on 1 to ``processors``
    cores: shortest first. ``scalar`` is that of the kernels; None: each target's own.

    Raises
    ------
    InputError: no processors, a target whose clock is not known, or an unknown function.
    """
    Machine(processors)
    chips = {target.name: chip_of(target) for target in targets}
    programs: dict[str, Program] = {}
    for name, options in FORMULATIONS.items():
        if function_named(function).is_recursion or "formulation" not in options:
            tell(name)
            programs[name] = program(robot, function, Options((function,), **options))
    candidates: list[Plan] = []
    for target in targets:
        for name, candidate in programs.items():
            tell(f"{target.name}, {name}")
            cores = min(processors, chips[target.name].cores)
            candidates += _of_target(target, name, candidate, cores, scalar)
    return sorted(candidates, key=lambda plan: (plan.time_ns, plan.processors))


def chip_of(target: Target) -> Chip:
    """The processor of ``target``.

    Raises
    ------
    InputError: its clock is not known.
    """
    if target.chip is None:
        raise InputError(f"there is no plan for {target.name}, whose clock is not known")
    return target.chip


def _of_target(
    target: Target, formulation: str, program: Program, most: int, scalar: ScalarType | None
) -> list[Plan]:
    """The serial kernel, and for every number of cores the best cut and machine."""
    units, costs = _units(target.costs_of(scalar or target.scalar))
    chip = chip_of(target)
    unit_ns = chip.cycle_ns / units
    whole_ns = unit_ns * sum(costs[operation.op] for operation in program.operations)
    operations = sum(COSTS[operation.op] for operation in program.operations)
    plans = [Plan(target.name, formulation, 1, None, True, 1, operations, whole_ns, whole_ns)]
    passing = round(chip.passing_ns / unit_ns)
    graphs = {k: cut(program, k, costs).graph for k in CUTS} if most > 1 else {}
    for p in range(2, most + 1):
        tried = []
        for (k, graph), levels in itertools.product(graphs.items(), (True, False)):
            solved = solve(graph, Machine(p, passing, levels), "critical-path")
            time, bound = solved.timetable.span * unit_ns, solved.lower_bound * unit_ns
            tried.append(Plan(target.name, formulation, p, k, levels, len(graph), operations, time, bound))
        best = min(tried, key=lambda plan: plan.time_ns)
        if best.time_ns < plans[-1].time_ns:  # more cores that gain nothing are no plan
            plans.append(best)
    return plans


def _units(costs: Costs) -> tuple[int, dict[str, int]]:
    """Costs as whole numbers, and how many of them are a cycle: tenths, where cycles are not whole."""
    named = {
        "mul": costs.mul, "add": costs.add, "sub": costs.add, "div": costs.div, "sqrt": costs.sqrt,
        "sin": costs.sincos / 2, "cos": costs.sincos / 2, "atan2": costs.sincos,
    }  # fmt: skip
    units = 1 if all(float(value).is_integer() for value in named.values()) else 10
    scaled = {op: round(units * value) for op, value in named.items()}
    return units, {**{op: units * value for op, value in COSTS.items()}, **scaled}


def chosen(candidates: Sequence[Plan], deadline_ns: float) -> Plan | None:
    """Of the plans that meet the deadline the one with the fewest processors, then the shortest."""
    meeting = [plan for plan in candidates if plan.time_ns <= deadline_ns]
    return min(meeting, key=lambda plan: (plan.processors, plan.time_ns), default=None)
