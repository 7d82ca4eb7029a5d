"""``robodyn plan``: find a formulation, schedule and target that meet a deadline."""

from __future__ import annotations

from typing import Any

import click

from robodyn.errors import CheckError
from robodyn_cli.choices import PLANNED_TARGETS
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.options import functions_option, one_function
from robodyn_cli.output import show
from robodyn_cli.robot_files import load_robot


def _targets() -> str:
    from robodyn.targets import planned_targets

    names = ", ".join(target.name for target in planned_targets())
    return (
        f"Target; repeat for several: {names}, here (measured), or NAME:cores=4,mhz=1500,pass=150 (ns),"
        "mul=1,add=1,div=14,sqrt=14,sincos=46 (cycles). [default: all]"
    )


@click.command()
@robot_argument
@option("-p --processors=N", "Maximum number of cores.", int, default=1)
@option("--deadline=T", "Maximum time of a call: 100us, 0.5ms, 800ns.", required=True)
@option("--target=T targets", _targets, PLANNED_TARGETS, multiple=True)
@option("--scalar", "Scalar type: float or double.  [default: the target's]", ["float", "double"])
@functions_option("inverse_dynamics", "Function to plan.")
@flag("--strict", "Refuse physically implausible values.")
def command(robot: str, functions: str, strict: bool, **options: Any) -> None:
    """Find a formulation, schedule and target that meet a deadline.

    The formulations are split into tasks of several sizes and scheduled on 1 to N cores of every target, with
    its communication cost. The plan with the fewest cores that meets the deadline is chosen. Exits with 1 if
    there is none. With --json: {"robot", "deadline_ns", "chosen", "plans"}.
    """
    from robodyn.bench.plan import chosen, here, parse_deadline, parse_target, plans
    from robodyn.dynamics.functions import function_named
    from robodyn.report.benchmarks import plan_text, time_text
    from robodyn.targets import Target, planned_targets
    from robodyn_cli.progress import messages

    limit = parse_deadline(options["deadline"])
    function = one_function(functions)
    function_named(function)
    requested: list[Target | None] = [
        None if text == "here" else parse_target(text) for text in options["targets"]
    ]
    described = load_robot(robot, strict=strict)
    with messages() as tell:
        wanted = [target or here(described, tell) for target in requested] or list(planned_targets())
        candidates = plans(
            described, options["processors"], wanted, function=function, scalar=options["scalar"], tell=tell
        )
    best = chosen(candidates, limit)
    show(
        lambda: {
            "robot": described.name, "deadline_ns": limit,
            "chosen": None if best is None else best.to_dict(limit),
            "plans": [plan.to_dict(limit) for plan in candidates],
        },
        lambda: plan_text(described, robot, candidates, wanted, limit, function).splitlines(),
    )  # fmt: skip
    if best is None:
        raise CheckError(
            f"nothing meets {time_text(limit)}",
            found=f"{time_text(candidates[0].time_ns)} at best",
            remedy="allow more cores with -p, or choose another target or a longer deadline",
        )
