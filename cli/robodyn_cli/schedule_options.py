"""The options of ``robodyn schedule``, and checks of their combinations."""

from __future__ import annotations

from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any, Final

import click

from robodyn.errors import InputError
from robodyn_cli.choices import FILE, FOLDER
from robodyn_cli.decorators import add_options, flag, option
from robodyn_cli.options import functions_option, one_function
from robodyn_cli.values import POSITIVE

#: ``robodyn.schedule.METHODS``, which tests hold equal to this: importing it would slow down ``--help``.
METHODS: Final = ("thesis", "critical-path", "dhlf", "df-ihs", "a-star", "branch-and-bound", "optimal")
#: Likewise the names of ``robodyn.thesis.logarithmic.FORMS``, with hyphens.
FORMS: Final = ("newton-euler", "modified-newton-euler", "lee-chang", "lathrop")


schedule_options = add_options(
    option("-p --processors=N", "Number of processors: 4, 2,4,8 or 2..13."),
    option("--links=N", "Schedule any revolute arm of N joints (without ROBOT).", int),
    option(
        "--method",
        "Method: list heuristics (thesis: section 4.3.3; critical-path; dhlf), searches (df-ihs, a-star, "
        "branch-and-bound: one processor per joint) or optimal (OR-Tools; proof or bound).",
        METHODS,
        default="critical-path",
    ),
    flag("--as-printed", "Use the task set printed in the thesis."),
    option(
        "--friction",
        "Tasks of friction in all joints; without this option, those that ROBOT describes.",
        ("none", "joint", "transmission", "both"),
    ),
    option("--cut=K", "Split a kernel into tasks of at most K operations; thesis: the thesis's tasks."),
    functions_option("inverse_dynamics", "Function to split (with --cut K)."),
    option("--form", "Recursion (with --links).", FORMS),
    flag("--forms", "Compare linear and logarithmic forms for up to --links N joints."),
    option("--cost=OP=N,...", "Costs of operations: mul=1,add=1,div=14."),
    option(
        "--communication=T",
        "Time to pass a value, or to synchronise between levels.",
        int,
        default=0,
        show_default=False,
    ),
    flag("--no-levels", "Start tasks as soon as their inputs are available."),
    option(
        "--budget-seconds --seconds=S seconds",
        "Time limit of a search. [default: 60, branch-and-bound 10]",
        POSITIVE,
    ),
    option(
        "--nodes=N", "Limit of nodes that df-ihs and a-star visit. [default: 200000]", click.IntRange(min=1)
    ),
    option("--seed=N", "Seed of the optimiser.", int, default=0, show_default=False),
    flag("--fewest", "Find the fewest processors that reach the critical path."),
    option("--thesis=TABLE", "Check a printed schedule: 4.3, C.1, 4.8, all."),
    option("--picture=FILE.svg", "Write the Gantt chart; for a sweep, Figures 4.11-4.13.", FILE),
    option("--layers=FILE.svg", "Write the layered graph.", FILE),
    option("-o --output --emit=DIR emit", "Write parallel C to DIR.", FOLDER),
    option("--sync", "Synchronisation (with -o).", ("barrier", "counters")),
    option("--packed=LANES", "Also write the packed form (with -o): 2, 4 or 8 lanes.", int),
)
"""Add the options of tasks, machine, method and output."""


class ScheduleOptions(SimpleNamespace):
    """The parsed options of ``robodyn schedule``; ``operations``: those of a task of a kernel, None for the
    thesis's tasks."""

    @staticmethod
    def of(robot: str | None, options: dict[str, Any]) -> ScheduleOptions:
        """The options from the command line.

        Raises
        ------
        InputError: options that cannot be combined, or nothing to schedule.
        """
        settings = ScheduleOptions(robot=robot, **options)
        settings.function = one_function(settings.functions)
        settings.operations = None if settings.cut in (None, "thesis") else _operations(settings.cut)
        if settings.cut is None and (settings.emit is not None or settings._is_kernel()):
            settings.operations = 3
        if settings.seconds is None:
            settings.seconds = 10.0 if settings.method == "branch-and-bound" else 60.0
        for refused, error in settings._refusals():
            if refused:
                raise error
        settings.processors = settings.processors or "1"
        return settings

    def _refusals(self) -> Iterator[tuple[bool, InputError]]:
        """What cannot be combined: whether it is here, and the error."""
        alone = "--forms" if self.forms else "--thesis" if self.thesis is not None else None
        if alone is not None:
            error = InputError(f"{alone} takes no robot", found=self.robot, remedy="remove it")
            yield self.robot is not None, error
            return
        general, kernel, emits = self.links is not None, self.operations is not None, self.emit is not None
        yield (
            (self.robot is not None) == general,
            InputError(
                "nothing unique to schedule",
                found="both ROBOT and --links" if general else "neither ROBOT nor --links",
                expected="one of ROBOT and --links N",
            ),
        )
        for refused, what, remedy in (
            (
                self.processors is None and not self.fewest,
                "the number of processors is missing",
                "add -p 4, -p 2..13, or --fewest",
            ),
            (general and emits, "a general arm (--links) has no parameters to emit", "use a ROBOT instead"),
            (
                general and kernel and self.form is None,
                "a general arm (--links) has no kernel to split",
                "add --form, or use a ROBOT instead",
            ),
            (self.form is not None and not general, "--form requires --links", None),
            (
                self.friction is not None and (kernel or emits),
                "--friction is of the thesis's tasks; a kernel has the friction that its robot describes",
                "leave out --cut and --emit, or --friction",
            ),
            (
                self.as_printed and kernel,
                "--as-printed applies to the thesis's tasks, not to a kernel",
                "remove --cut",
            ),
            (
                self.cost is not None and not kernel and not general,
                "--cost requires tasks of operations",
                "add --cut 1, or another number",
            ),
        ):
            yield refused, InputError(what, remedy=remedy)
        yield self.sync is not None and not emits, InputError("--sync requires -o")
        yield self.packed is not None and not emits, InputError("--packed requires -o")

    def check(self, machines: int) -> None:
        """Raise :class:`InputError` if there are several schedules and only one can be emitted."""
        if self.emit is not None and machines > 1:
            found = f"{machines} machines"
            raise InputError("only one schedule can be emitted", found=found, expected="-p N")

    def _is_kernel(self) -> bool:
        """Whether an option selects a kernel."""
        from robodyn.dynamics.functions import function_named

        default = {"formulation": "modified_newton_euler", "optimize": "record", "engine": "graph"}
        changed = any(getattr(self, name) != value for name, value in default.items())
        return changed or self.no_regroup or not function_named(self.function).is_recursion


def _operations(text: str) -> int:
    if not text.isdecimal() or len(text) > 6:
        expected = "thesis, or a number of operations"
        raise InputError("--cut cannot be read", found=repr(text), expected=expected)
    return int(text)
