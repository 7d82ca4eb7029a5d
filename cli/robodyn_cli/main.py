"""The command ``robodyn``: dispatches to the command's module, and turns errors into one line and an exit
code.

A command's module is imported only when the command runs, so that ``robodyn gen`` does not import what
``robodyn verify`` needs. The table :data:`COMMANDS` has the short helps for ``robodyn --help``. Only click
and light modules are imported here.
"""

from __future__ import annotations

import errno
import importlib
import os
import sys
from collections.abc import Callable, Sequence
from typing import Final

import click

from robodyn.errors import RobodynError, ToolError
from robodyn.process import quiet, received
from robodyn_cli.common import drop, talk
from robodyn_cli.renamed import renamed

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
    "simulate": (
        "robodyn_cli.simulate",
        "Simulate a robot with all its effects, and write the log.",
    ),
    "diagnose": (
        "robodyn_cli.diagnose",
        "Find the effects that a model is missing, add them, and validate the amended model.",
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
}
"""Name of a command -> (module whose ``command`` it is, short help)."""

HELP: Final = {"help_option_names": ["-h", "--help"]}
INTERNAL_ERROR: Final = 70  # EX_SOFTWARE: robodyn itself is at fault
IO_ERROR: Final = 74  # EX_IOERR: the system refused, as a full disk under stdout does
PIPE_CLOSED: Final = 141  # 128 + SIGPIPE


class LazyGroup(click.Group):
    """A group that imports a command only when it runs, and lists the commands without importing them."""

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
            hint = f"did you mean {close[0]!r}?" if close else f"the commands are {', '.join(COMMANDS)}."
            ctx.fail(f"No such command {args[0]!r}; {hint}")
        return super().resolve_command(ctx, [args[0], *renamed(args[0], args[1:])])

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
    return guard(lambda: _begin(list(sys.argv[1:] if arguments is None else arguments)))


def _begin(arguments: list[str]) -> None:
    _open_what_is_closed()
    if "_ROBODYN_COMPLETE" in os.environ:  # a shell asks for completions
        from click.shell_completion import shell_complete

        instruction = os.environ["_ROBODYN_COMPLETE"]
        raise click.exceptions.Exit(shell_complete(cli, {}, "robodyn", "_ROBODYN_COMPLETE", instruction))
    _run(arguments)


def _open_what_is_closed() -> None:
    """Open ``os.devnull`` for a stdout or stderr that was closed before the start (``>&-``).

    Otherwise it is None, and the first file that is opened gets its descriptor.
    """
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_WRONLY), "w", encoding="utf-8"))


def _run(arguments: list[str]) -> None:
    try:
        with cli.make_context("robodyn", arguments) as ctx:
            cli.invoke(ctx)
    finally:  # flush now, so that a closed pipe or a full disk is handled here and not at interpreter exit
        sys.stdout.flush()


def guard(run: Callable[[], None]) -> int:
    """Call `run` and return the exit code; an error becomes its message on stderr, never a traceback."""
    try:
        run()
        quiet()
    except BaseException as error:
        quiet()
        return _failed(error)
    return 0


def _failed(error: BaseException) -> int:
    """Print the message of `error` on stderr; return its exit code."""
    if isinstance(error, click.exceptions.Exit):
        return error.exit_code
    if isinstance(error, (KeyboardInterrupt, click.Abort)):
        code, word = received()
        _complain(word)
        return code
    if isinstance(error, BrokenPipeError):  # the reader, for instance `head`, closed the pipe
        drop(sys.stdout)
        return PIPE_CLOSED
    if not isinstance(error, Exception):
        raise error
    if isinstance(error, click.ClickException):  # wrong usage, exit code 2
        _complain_of_usage(error)
        return error.exit_code
    if isinstance(error, RobodynError):
        _complain(f"error: {error}")
        return error.exit_code
    if os.environ.get("ROBODYN_DEBUG") == "1":
        import traceback

        talk("".join(traceback.format_exception(error)).rstrip("\n"))
    if (limit := _few_files()) is not None:  # whatever its symptom, even a module that is not found
        drop(sys.stdout)
        _complain(
            f"error: the limit of open files is too low: {error}; found {limit}; raise it with ulimit -n 256"
        )
        return IO_ERROR
    if isinstance(error, (OSError, MemoryError)):  # a full disk and its like
        drop(sys.stdout)
        _complain(f"error: the operating system refused: {str(error) or 'out of memory'}")
        return IO_ERROR
    if isinstance(error, ImportError) and not (error.name or "").startswith("robodyn"):
        _complain(f"error: a library cannot be loaded: {error}; reinstall robodyn or that library")
        return ToolError.exit_code
    _complain(
        f"internal error: {type(error).__name__}: {error}; this is a bug in robodyn: please report "
        "it with the command, the robot file and the output of the command with ROBODYN_DEBUG=1"
    )
    return INTERNAL_ERROR


def _few_files() -> int | None:
    """The limit of open files, if it is nearly reached; else None."""
    opened: list[int] = []
    try:
        while len(opened) < 16:
            opened.append(os.open(os.devnull, os.O_RDONLY))
    except OSError as error:
        if error.errno not in (errno.EMFILE, errno.ENFILE):
            return None
    finally:
        for descriptor in opened:
            os.close(descriptor)
    if len(opened) == 16:
        return None
    try:
        import resource
    except ImportError:
        return len(opened)
    return resource.getrlimit(resource.RLIMIT_NOFILE)[0]


def _complain_of_usage(error: click.ClickException) -> None:
    """Print click's message and where to find help; ``robodyn`` alone prints the help."""
    context = error.ctx if isinstance(error, click.UsageError) else None
    if isinstance(error, getattr(click.exceptions, "NoArgsIsHelpError", ())):  # click 8.1 has none
        talk(error.format_message())
        return
    command = context.command_path if context is not None else "robodyn"
    _complain(f"error: {error.format_message().rstrip('.')} (see {command} --help)")


def _complain(text: str) -> None:
    """Print `text` on stderr as one line, control characters escaped."""
    line = " ".join(f"robodyn: {text}".split())
    talk("".join(c if c.isprintable() else ascii(c)[1:-1] for c in line))
