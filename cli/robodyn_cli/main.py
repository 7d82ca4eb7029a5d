"""The command ``robodyn``: dispatches to the command's module.

A command's module is imported only when the command runs, so that ``robodyn gen`` does not import what
``robodyn verify`` needs. The table :data:`COMMANDS` has the short helps for ``robodyn --help``. Only click
and light modules are imported here.
"""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import click

from robodyn_cli.common import Document
from robodyn_cli.failures import asks_for_json, guard

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

COMMANDS: Final[dict[str, tuple[str, str]]] = {
    "gen": ("robodyn_cli.gen", "Write the kernels of a robot, and print the operation counts."),
    "package": (
        "robodyn_cli.package",
        "Write a package of a robot's kernels for somebody else's build.",
    ),
    "build": ("robodyn_cli.build", "Write or check the kernels of all robots of a project."),
    "flops": ("robodyn_cli.flops", "Count multiplications and additions, and check them against a budget."),
    "tables": ("robodyn_cli.tables", "Compare the thesis's tables with recomputed figures."),
    "schedule": (
        "robodyn_cli.schedule",
        "Split the dynamics into tasks and schedule them on processors.",
    ),
    "plan": ("robodyn_cli.plan", "Find a formulation, schedule and target that meet a deadline."),
    "bench": (
        "robodyn_cli.bench",
        "Time a kernel on this machine: serial, packed, on threads, and compared with installed peers.",
    ),
    "ik": ("robodyn_cli.ik", "Solve for the joint positions that bring the tool to a pose."),
    "simulate": (
        "robodyn_cli.simulate",
        "Simulate a robot with all its effects, and write the log.",
    ),
    "diagnose": (
        "robodyn_cli.diagnose",
        "Find the effects that a model is missing, add them, and validate the amended model.",
    ),
    "fleet": (
        "robodyn_cli.fleet",
        "Find the arms of a fleet that differ from their siblings or have changed.",
    ),
    "logs": ("robodyn_cli.logs", "Show what is in a log, and propose which columns are what."),
    "identify": (
        "robodyn_cli.identify",
        "Identify links, friction and rotors from logs, physically consistent, with intervals.",
    ),
    "hide": ("robodyn_cli.hide", "Make a blind test: hide effects in simulated logs and seal the answer."),
    "excite": ("robodyn_cli.excite", "Design a motion within the limits that distinguishes effects."),
    "verify": ("robodyn_cli.verify", "Compare the compiled kernels with independent references."),
    "prove": (
        "robodyn_cli.prove",
        "Prove properties of a kernel: rounding, run-time errors, stack, MISRA C:2012.",
    ),
    "case-study": ("robodyn_cli.case_study", "Repeat the thesis's case study of friction (chapter 3)."),
    "effects": ("robodyn_cli.effects", "List the effects of the catalogue, or describe one of them."),
    "robots": ("robodyn_cli.robots", "List the bundled robots."),
    "import": ("robodyn_cli.import_", "Import a serial arm from URDF, MJCF, SDF or xacro as a description."),
    "export": ("robodyn_cli.export", "Export a robot to URDF, MJCF or SDF."),
    "diff": ("robodyn_cli.diff", "Compare two robots: numbers, frames, torques, operation counts."),
    "report": ("robodyn_cli.report", "Write a page that shows an arm, or two beside each other."),
    "schema": ("robodyn_cli.schema", "Print the JSON Schema of the robot description."),
    "new": ("robodyn_cli.new", "Write a commented starter file to fill in."),
    "doctor": (
        "robodyn_cli.doctor",
        "Show which programs and libraries are here, what each enables, and how to get the others.",
    ),
    "completion": (
        "robodyn_cli.completion",
        "Print or install the script with which a shell completes robodyn.",
    ),
}
"""Name of a command -> (module whose ``command`` it is, short help)."""

HELP: Final = {"help_option_names": ["-h", "--help"]}


class LazyGroup(click.Group):
    """A group that imports a command only when it runs, and lists the commands without importing them."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command = importlib.import_module(COMMANDS[cmd_name][0]).command
        assert isinstance(command, click.Command)
        from robodyn_cli.choices import ROBOTS

        if all(parameter.type is not ROBOTS for parameter in command.params):
            return command
        from robodyn_cli.file_options import with_file_options

        return with_file_options(command)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args[0] not in COMMANDS:
            from robodyn.errors import did_you_mean

            hint = did_you_mean(args[0], COMMANDS) or f"the commands are {', '.join(COMMANDS)}."
            ctx.fail(f"No such command {args[0]!r}; {hint}")
        return super().resolve_command(ctx, args)

    def shell_complete(self, ctx: click.Context, incomplete: str) -> list[CompletionItem[str]]:
        from click.shell_completion import CompletionItem

        commands = [
            CompletionItem(name, help=short)
            for name, (_, short) in COMMANDS.items()
            if name.startswith(incomplete)
        ]
        return [*commands, *click.Command.shell_complete(self, ctx, incomplete)]

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, short) for name, (_, short) in COMMANDS.items()])


def _print_version(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        import robodyn

        click.echo(f"robodyn {robodyn.__version__}")
        ctx.exit()


EPILOG: Final = """\
Exit codes: 0 done; 1 a check failed or was not met; 2 bad input; 3 a tool is missing (a compiler ...);
4 diagnose reports unexplained. Results go to stdout, messages to stderr.
"""


@click.group(cls=LazyGroup, context_settings=HELP, epilog=EPILOG)
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_version,
    help="Show the version and exit.",
)
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
    if "_ROBODYN_COMPLETE" in os.environ:  # a shell asks for completions
        from click.shell_completion import shell_complete

        from robodyn_cli.shells import VARIABLE

        raise click.exceptions.Exit(shell_complete(cli, {}, "robodyn", VARIABLE, os.environ[VARIABLE]))
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
