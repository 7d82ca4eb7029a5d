"""The command ``robodyn``: dispatches to the command's module.

A command's module is imported only when the command runs, so that ``robodyn gen`` does not import what
``robodyn verify`` needs. The table :data:`GROUPS` has the short helps for ``robodyn --help``. Only click
and light modules are imported here.
"""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Final

import click

from robodyn.errors import did_you_mean
from robodyn.version import VERSION
from robodyn_cli.failures import asks_for_json, guard
from robodyn_cli.output import Document

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

GROUPS: Final = {
    "Describe an arm": {
        "new": "Write a commented starter file to fill in.",
        "import": "Import a serial arm from URDF, MJCF, SDF or xacro as a description.",
        "robots": "List the bundled robots.",
        "effects": "List the effects of the catalogue, or describe one of them.",
        "schema": "Print the JSON Schema of the robot description.",
        "export": "Export a robot to URDF, MJCF or SDF.",
        "diff": "Compare two robots: numbers, frames, torques, operation counts.",
        "report": "Write a page that shows an arm, or two beside each other.",
    },
    "Generate code": {
        "gen": "Write the kernels of a robot, and print the operation counts.",
        "functions": "List the functions that kernels may have, or describe one of them.",
        "flops": "Count multiplications and additions, and check them against a budget.",
        "build": "Write or check the kernels of all robots of a project.",
        "verify": "Compare the compiled kernels with independent references.",
        "prove": "Prove properties of a kernel: rounding, run-time errors, stack, MISRA C:2012.",
        "bench": "Time a kernel on this machine: serial, packed, on threads, beside installed peers.",
        "plan": "Find a formulation, schedule and target that meet a deadline.",
    },
    "Deploy it": {
        "package": "Write a package of a robot's kernels for somebody else's build.",
        "doctor": "Show which programs and libraries are here, what each enables, and how to get the others.",
        "completion": "Print or install the script with which a shell completes robodyn.",
    },
    "Simulate and measure": {
        "ik": "Solve for the joint positions that bring the tool to a pose.",
        "simulate": "Simulate a robot with all its effects, and write the log.",
        "logs": "Show what is in a log, and propose which columns are what.",
        "identify": "Identify links, friction and rotors from logs, physically consistent, with intervals.",
        "diagnose": "Find the effects that a model is missing, add them, and validate the amended model.",
        "fleet": "Find the arms of a fleet that differ from their siblings or have changed.",
        "excite": "Design a motion within the limits that distinguishes effects.",
        "hide": "Make a blind test: hide effects in simulated logs and seal the answer.",
    },
    "The thesis": {
        "tables": "Compare the thesis's tables with recomputed figures.",
        "schedule": "Split the dynamics into tasks and schedule them on processors.",
        "case-study": "Repeat the thesis's case study of friction (chapter 3).",
    },
}
"""What people come for, in the order in which they need it -> name of a command -> its short help."""

COMMANDS: Final = {name: short for commands in GROUPS.values() for name, short in commands.items()}
"""Name of a command -> its short help."""


def module_of(name: str) -> str:
    """The module whose ``command`` the command ``name`` is."""
    return "robodyn_cli." + {"import": "import_"}.get(name, name.replace("-", "_"))


#: The variable in which a shell says what it asks for, as in ``templates/completion``.
COMPLETE: Final = "_ROBODYN_COMPLETE"
HELP: Final[dict[str, Any]] = {"help_option_names": ["-h", "--help"], "max_content_width": 110}


class LazyGroup(click.Group):
    """A group that imports a command only when it runs, and lists the commands without importing them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        from robodyn_cli.file_options import with_common_options

        return with_common_options(importlib.import_module(module_of(cmd_name)).command)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args[0] not in COMMANDS:
            hint = did_you_mean(args[0], COMMANDS) or f"the commands are {', '.join(COMMANDS)}."
            ctx.fail(f"No such command {args[0]!r}; {hint}")
        return super().resolve_command(ctx, args)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem[str]]:
        from click.shell_completion import CompletionItem

        commands = [
            CompletionItem(name, help=short)
            for name, short in COMMANDS.items()
            if name.startswith(incomplete)
        ]
        return [*commands, *click.Command.shell_complete(self, ctx, incomplete)]

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        width = max(map(len, COMMANDS))
        for title, commands in GROUPS.items():
            with formatter.section(title):
                formatter.write_dl([(f"{name:{width}}", short) for name, short in commands.items()])


EPILOG: Final = """\
Exit codes: 0 done; 1 a check failed or was not met; 2 bad input; 3 a tool is missing (a compiler ...);
4 diagnose reports unexplained. Results go to stdout, messages to stderr.
"""


@click.group(cls=LazyGroup, context_settings=HELP, epilog=EPILOG)
@click.version_option(VERSION, prog_name="robodyn", message="%(prog)s %(version)s")
def cli() -> None:
    """Generate small, counted and verified C and Fortran for the dynamics of a robot.

    Start with "robodyn gen puma560 --compile". ROBOT is the path of a YAML file or the name of a bundled
    robot ("robodyn robots" lists them); or a URDF, MJCF, SDF or xacro file with one tip ("robodyn import"
    takes any). "robodyn COMMAND --help" describes each command.
    """


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return the exit code; `arguments` default to those of the process."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    document = Document(as_json=asks_for_json(words))
    return guard(lambda: _begin(words, document), document)


def _begin(arguments: list[str], document: Document) -> None:
    _open_what_is_closed()
    if (instruction := os.environ.get(COMPLETE)) is not None:  # a shell asks for completions
        from click.shell_completion import shell_complete

        importlib.import_module("robodyn_cli.completion")  # our shells replace click's
        raise click.exceptions.Exit(shell_complete(cli, {}, "robodyn", COMPLETE, instruction))
    _run(arguments, document)


def _open_what_is_closed() -> None:
    """Open ``os.devnull`` for a stdout or stderr that was closed before the start (``>&-``).

    Otherwise it is None, and the first file that is opened gets its descriptor.
    """
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))


def _run(arguments: list[str], document: Document) -> None:
    try:
        with cli.make_context("robodyn", arguments, obj=document) as ctx:
            cli.invoke(ctx)
    finally:  # flush now, so that a closed pipe or a full disk is handled here and not at interpreter exit
        sys.stdout.flush()
