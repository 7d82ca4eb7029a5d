"""The options of ``robodyn schedule``, and checks of their combinations."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final, TypeVar

import click

from robodyn_cli.choices import FILE, FOLDER
from robodyn_cli.common import add_options
from robodyn_cli.options import functions_option, one_function

Command = TypeVar("Command", bound=Callable[..., Any])

#: ``robodyn.schedule.METHODS``, which tests hold equal to this: importing it would slow down ``--help``.
METHODS: Final = ("thesis", "critical-path", "dhlf", "df-ihs", "a-star", "branch-and-bound", "optimal")


schedule_options = add_options(
    click.option(
        "-p",
        "--processors",
        metavar="N",
        default=None,
        help="Number of processors: 4, 2,4,8 or 2..13.",
    ),
    click.option(
        "--links",
        metavar="N",
        type=int,
        help="Schedule any revolute arm of N joints (without ROBOT).",
    ),
    click.option(
        "--method",
        type=click.Choice(METHODS),
        default="critical-path",
        show_default=True,
        help="Method: list heuristics (thesis: section 4.3.3; critical-path; dhlf), searches (df-ihs,"
        " a-star, branch-and-bound: one processor per joint) or optimal (OR-Tools; proof or bound).",
    ),
    click.option("--as-printed", is_flag=True, help="Use the task set printed in the thesis."),
    click.option(
        "--friction",
        type=click.Choice(("none", "joint", "transmission", "both")),
        help="Tasks of friction in all joints; without this option, those that ROBOT describes.",
    ),
    click.option(
        "--cut",
        metavar="K",
        help="Split a kernel into tasks of at most K operations; thesis: the thesis's tasks.",
    ),
    functions_option("inverse_dynamics", "Function to split (with --cut K)."),
    click.option(
        "--form",
        metavar="F",
        help="Recursion (with --links): newton-euler, modified-newton-euler, lee-chang or lathrop.",
    ),
    click.option(
        "--forms",
        is_flag=True,
        help="Compare linear and logarithmic forms for up to --links N joints.",
    ),
    click.option("--cost", metavar="OP=N,...", help="Costs of operations: mul=1,add=1,div=14."),
    click.option(
        "--communication",
        metavar="T",
        type=int,
        default=0,
        help="Time to pass a value, or to synchronise between levels.",
    ),
    click.option("--no-levels", is_flag=True, help="Start tasks as soon as their inputs are available."),
    click.option(
        "--budget-seconds",
        "--seconds",
        "seconds",
        metavar="S",
        type=float,
        help="Time limit of a search. [default: 60, branch-and-bound 10]",
    ),
    click.option(
        "--nodes",
        metavar="N",
        type=click.IntRange(min=1),
        help="Limit of nodes that df-ihs and a-star visit. [default: 200000]",
    ),
    click.option("--seed", metavar="N", type=int, default=0, help="Seed of the optimiser."),
    click.option("--fewest", is_flag=True, help="Find the fewest processors that reach the critical path."),
    click.option("--thesis", metavar="TABLE", help="Check a printed schedule: 4.3, C.1, 4.8, all."),
    click.option(
        "--picture",
        type=FILE,
        metavar="FILE.svg",
        help="Write the Gantt chart; for a sweep, Figures 4.11-4.13.",
    ),
    click.option("--layers", type=FILE, metavar="FILE.svg", help="Write the layered graph."),
    click.option(
        "-o",
        "--output",
        "--emit",
        "emit",
        type=FOLDER,
        metavar="DIR",
        help="Write parallel C to DIR.",
    ),
    click.option("--sync", metavar="HOW", help="Synchronisation (with -o): barrier or counters."),
    click.option(
        "--packed",
        metavar="LANES",
        type=int,
        help="Also write the packed form (with -o): 2, 4 or 8 lanes.",
    ),
)
"""Add the options of tasks, machine, method and output."""


@dataclass(frozen=True, slots=True)
class ScheduleOptions:
    """The parsed options of ``robodyn schedule``."""

    robot: str | None
    processors: str
    links: int | None
    method: Any
    as_printed: bool
    friction: Any
    operations: int | None
    function: str
    form: str | None
    forms: bool
    cost: str | None
    communication: int
    no_levels: bool
    seconds: float
    nodes: int | None
    seed: int
    fewest: bool
    thesis: str | None
    picture: str | None
    layers: str | None
    emit: str | None
    sync: Any
    packed: int | None
    formulation: str
    optimize: str
    no_regroup: bool
    engine: str
    strict: bool

    @staticmethod
    def of(robot: str | None, options: dict[str, Any]) -> ScheduleOptions:
        """The options from the command line.

        Raises
        ------
        InputError: options that cannot be combined, or nothing to schedule.
        """
        from robodyn.errors import InputError

        cut = options.pop("cut")
        options["function"] = one_function(options.pop("functions"))
        operations = None if cut in (None, "thesis") else _operations(cut)
        if cut is None and (options["emit"] is not None or _kernel(options)):
            operations = 3  # for a kernel
        processors = options.pop("processors")
        if options["seconds"] is None:
            options["seconds"] = 10.0 if options["method"] == "branch-and-bound" else 60.0
        settings = ScheduleOptions(robot, processors=processors or "1", operations=operations, **options)
        settings = _with_form(settings)
        if settings.thesis is not None or settings.forms:
            if robot is not None:
                raise InputError(
                    f"{'--forms' if settings.forms else '--thesis'} takes no robot",
                    found=robot,
                    remedy="remove it",
                )
            return settings
        if (robot is None) == (settings.links is None):
            raise InputError(
                "nothing unique to schedule",
                found="neither ROBOT nor --links" if robot is None else "both ROBOT and --links",
                expected="one of ROBOT and --links N",
            )
        if processors is None and not settings.fewest:
            raise InputError("the number of processors is missing", remedy="add -p 4, -p 2..13, or --fewest")
        settings._fitting()
        return settings

    def _fitting(self) -> None:
        from robodyn.errors import InputError

        if self.links is not None and self.emit is not None:
            raise InputError(
                "a general arm (--links) has no parameters to emit", remedy="use a ROBOT instead"
            )
        if self.links is not None and self.operations is not None and self.form is None:
            raise InputError(
                "a general arm (--links) has no kernel to split", remedy="add --form, or use a ROBOT instead"
            )
        if self.form is not None and self.links is None:
            raise InputError("--form requires --links")
        if self.friction is not None and (self.operations is not None or self.emit is not None):
            raise InputError(
                "--friction is of the thesis's tasks; a kernel has the friction that its robot describes",
                remedy="leave out --cut and --emit, or --friction",
            )
        if self.as_printed and self.operations is not None:
            raise InputError(
                "--as-printed applies to the thesis's tasks, not to a kernel", remedy="remove --cut"
            )
        if self.cost is not None and self.operations is None and self.links is None:
            raise InputError("--cost requires tasks of operations", remedy="add --cut 1, or another number")
        if self.sync not in (None, "barrier", "counters"):
            raise InputError(
                f"unknown synchronisation {self.sync!r}", expected="--sync barrier or --sync counters"
            )
        for option, name in ((self.sync, "--sync"), (self.packed, "--packed")):
            if option is not None and self.emit is None:
                raise InputError(f"{name} requires -o")
        if not 0 < self.seconds < 1e7:
            raise InputError(
                "the time limit of the search is out of range",
                found=f"--budget-seconds {self.seconds:g}",
                expected="more than 0",
            )

    def check(self, machines: int) -> None:
        """Raise :class:`InputError` if there are several schedules and only one can be emitted."""
        from robodyn.errors import InputError

        if self.emit is not None and machines > 1:
            raise InputError(
                "only one schedule can be emitted", found=f"{machines} machines", expected="-p N"
            )

    def model(self) -> dict[str, Any]:
        """The options of the kernel."""
        return {
            "formulation": self.formulation,
            "optimize": self.optimize,
            "regroup": not self.no_regroup,
            "engine": self.engine,
        }


def _with_form(settings: ScheduleOptions) -> ScheduleOptions:
    from dataclasses import replace

    if settings.form is None:
        return settings
    from robodyn.errors import InputError
    from robodyn.thesis.logarithmic import FORMS

    name = "modified newton-euler" if settings.form == "modified-newton-euler" else settings.form
    if name not in FORMS:
        raise InputError(
            f"unknown form {settings.form!r}",
            expected=f"one of {', '.join(f.replace(' ', '-') for f in FORMS)}",
        )
    return replace(settings, form=name)


def _kernel(options: dict[str, Any]) -> bool:
    """Whether an option selects a kernel."""
    from robodyn.dynamics.functions import function_named

    usual = {"formulation": "modified_newton_euler", "optimize": "record", "engine": "graph"}
    changed = any(options[name] != value for name, value in usual.items())
    return changed or options["no_regroup"] or not function_named(options["function"]).is_recursion


def _operations(text: str) -> int:
    from robodyn.errors import InputError

    if not text.isdecimal() or len(text) > 6:
        raise InputError(
            "--cut cannot be read", found=repr(text), expected="thesis, or a number of operations"
        )
    return int(text)


def picture_file(text: str | None) -> Path | None:
    """The path of a picture.

    Raises
    ------
    InputError: the name does not end in .svg.
    """
    from robodyn.errors import InputError

    if text is None:
        return None
    if not text.endswith(".svg") or text == ".svg":
        raise InputError("pictures are written as SVG", found=repr(text), expected="a name that ends in .svg")
    return Path(text)
