"""The command ``robodyn``: finds the command's module, and turns errors into one line and an exit code.

A command's module is imported when the command runs, and not before: ``robodyn gen`` must not pay for what
``robodyn verify`` needs. Hence the table :data:`COMMANDS`, whose short helps are all that ``robodyn --help``
reads, and hence nothing but click is imported here.
"""

from __future__ import annotations

import importlib
import os
import sys
from collections.abc import Callable, Sequence
from typing import Final

import click

from robodyn.errors import InputError, RobodynError

COMMANDS: Final[dict[str, tuple[str, str]]] = {
    "gen": ("robodyn_cli.gen", "Write the C and Fortran of a robot's dynamics, and print the counts."),
    "flops": ("robodyn_cli.flops", "Count multiplications and additions, and hold them to a budget."),
    "verify": ("robodyn_cli.verify", "Set the compiled kernels against independent references."),
    "robots": ("robodyn_cli.robots", "List the bundled robots."),
    "schema": ("robodyn_cli.schema", "Print the JSON Schema of the robot description."),
    "new": ("robodyn_cli.new", "Write a commented starter file to fill in."),
}
"""Name of a command -> (module whose ``command`` it is, short help)."""

HELP: Final = {"help_option_names": ["-h", "--help"]}
INTERNAL_ERROR: Final = 70  # EX_SOFTWARE: robodyn itself is at fault
INTERRUPTED: Final = 130  # 128 + SIGINT, what a shell reports
PIPE_CLOSED: Final = 141  # 128 + SIGPIPE


class LazyGroup(click.Group):
    """A group that imports a command when it is asked for, and lists them without importing any."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command = importlib.import_module(COMMANDS[cmd_name][0]).command
        assert isinstance(command, click.Command)
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        if args[0] not in COMMANDS:
            import difflib

            close = difflib.get_close_matches(args[0], COMMANDS, n=1)
            hint = f"did you mean {close[0]!r}?" if close else f"there are {', '.join(COMMANDS)}."
            ctx.fail(f"No such command {args[0]!r}; {hint}")
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        with formatter.section("Commands"):
            formatter.write_dl([(name, short) for name, (_, short) in COMMANDS.items()])


def _print_version(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted and not ctx.resilient_parsing:
        from importlib.metadata import version

        click.echo(f"robodyn {version('robodyn')}")
        ctx.exit()


EPILOG: Final = """\
Exit codes: 0 done; 1 a check failed or was not met; 2 bad input; 3 a tool is missing (a compiler ...);
4 diagnose says unexplained. Data goes to stdout, talk to stderr.
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
    """From a robot's description to small, counted, verified C and Fortran for its dynamics.

    Begin with "robodyn gen puma560 --compile". ROBOT is the path of a YAML file, or the name of a bundled
    robot ("robodyn robots" lists them). "robodyn COMMAND --help" tells more about each command.
    """


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return the exit code; `arguments` default to those of the process."""
    if "_ROBODYN_COMPLETE" in os.environ:  # a shell asks what could follow on its command line
        from click.shell_completion import shell_complete

        return shell_complete(cli, {}, "robodyn", "_ROBODYN_COMPLETE", os.environ["_ROBODYN_COMPLETE"])
    return guard(lambda: _run(list(sys.argv[1:] if arguments is None else arguments)))


def _run(arguments: list[str]) -> None:
    try:
        with cli.make_context("robodyn", arguments) as ctx:
            cli.invoke(ctx)
    finally:  # now, so that a closed pipe or a full disk is met here and not while the interpreter shuts down
        sys.stdout.flush()


def guard(run: Callable[[], None]) -> int:
    """Call `run` and return the exit code; an error becomes its message on stderr, never a traceback."""
    try:
        run()
    except click.exceptions.Exit as leave:
        return leave.exit_code
    except click.ClickException as error:  # wrong usage: click's own words, exit code 2
        error.show()
        return error.exit_code
    except RobodynError as error:
        _complain(f"error: {error}")
        return error.exit_code
    except (KeyboardInterrupt, click.Abort):
        _complain("interrupted")
        return INTERRUPTED
    except BrokenPipeError:  # the reader, `head` perhaps, has had enough
        _drop_stdout()
        return PIPE_CLOSED
    except Exception as error:
        if os.environ.get("ROBODYN_DEBUG") == "1":
            import traceback

            traceback.print_exc()
        if isinstance(error, OSError):  # a full disk and its like
            _drop_stdout()
            _complain(f"error: the system refused: {error}")
            return InputError.exit_code
        _complain(
            f"internal error: {type(error).__name__}: {error}; this is a bug in robodyn: please report "
            "it with the command, the robot file and what the command prints with ROBODYN_DEBUG=1 set"
        )
        return INTERNAL_ERROR
    return 0


def _drop_stdout() -> None:
    """Send what stdout still holds nowhere, lest the interpreter complain of it on its way out."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, sys.stdout.fileno())
    os.close(null)


def _complain(text: str) -> None:
    """Say `text` on stderr as one line."""
    click.echo(" ".join(f"robodyn: {text}".split()), err=True)
