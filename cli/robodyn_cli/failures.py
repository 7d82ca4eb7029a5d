"""What becomes of an error: one line on stderr and an exit code, and an object on stdout with ``--json``."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path
from typing import Final

import click

from robodyn.errors import InputError, OutputError, Place, RobodynError, ToolError, escaped
from robodyn.process import exit_code, quiet, received
from robodyn_cli.output import Document, drop, talk

INTERNAL_ERROR: Final = 70  # EX_SOFTWARE: robodyn itself is at fault
PIPE_CLOSED: Final = 141  # 128 + SIGPIPE


class _InternalError(RobodynError):
    """robodyn itself is at fault."""

    exit_code = INTERNAL_ERROR


class _SystemRefusedError(OutputError):
    """The operating system refused something; that may have been what stdout still buffers."""


class _Interrupted(RobodynError):
    """A signal has ended the command."""

    def __init__(self, word: str, exit_code: int) -> None:
        super().__init__(word)
        self.exit_code = exit_code


def asks_for_json(arguments: Sequence[str]) -> bool:
    """Whether ``--json``, or ``--format json`` of ``build``, is among the options.

    Looked for without click's help, which stops at the first word that is wrong.
    """
    words = list(arguments[: arguments.index("--")] if "--" in arguments else arguments)
    return "--json" in words or "--format=json" in words or ("--format", "json") in pairwise(words)


def guard(run: Callable[[], None], document: Document | None = None) -> int:
    """Call `run` and return the exit code; an error becomes its message on stderr, never a traceback.

    Where a `document` is asked for and none has begun, stdout gets ``{"error": ...}``.
    """
    try:
        run()
        quiet()
    except BaseException as error:
        quiet()
        return exit_code(_failed(error, document or Document()))
    return 0


def _failed(error: BaseException, document: Document) -> int:
    """Print the message of `error`; return its exit code."""
    if isinstance(error, click.exceptions.Exit):
        return error.exit_code
    if isinstance(error, BrokenPipeError):  # the reader, for instance `head`, closed the pipe
        drop(sys.stdout)
        return PIPE_CLOSED
    if isinstance(error, getattr(click.exceptions, "NoArgsIsHelpError", ())):  # click 8.1 has none
        talk(str(error.format_message()))  # type: ignore[attr-defined]
        return int(error.exit_code)  # type: ignore[attr-defined]
    failure = _failure(error)
    if document.as_json and not document.begun:
        _print(failure)
    if isinstance(failure, _SystemRefusedError):
        drop(sys.stdout)
    prefix = {_InternalError: "internal error: ", _Interrupted: ""}.get(type(failure), "error: ")
    _complain(f"{prefix}{failure}")
    return failure.exit_code


def _failure(error: BaseException) -> RobodynError:
    """`error` as one of the family, with the message and the exit code that it gets."""
    if isinstance(error, RobodynError):
        return error
    if isinstance(error, (KeyboardInterrupt, click.Abort)):
        code, word = received()
        return _Interrupted(word, code)
    if not isinstance(error, Exception):
        raise error
    if isinstance(error, click.ClickException):  # wrong usage
        context = error.ctx if isinstance(error, click.UsageError) else None
        command = context.command_path if context is not None else "robodyn"
        return InputError(error.format_message().rstrip("."), remedy=f"{_hint(error)}see {command} --help")
    if os.environ.get("ROBODYN_DEBUG") == "1":
        import traceback

        talk("".join(traceback.format_exception(error)).rstrip("\n"))
    if "Too many open files" in str(error):  # of the system, or of a library that was to be imported
        remedy = "raise it with ulimit -n 256"
        return _SystemRefusedError(f"the limit of open files is too low: {error}", remedy=remedy)
    if isinstance(error, (OSError, MemoryError)):  # a full disk and its like
        return _SystemRefusedError(f"the operating system refused: {str(error) or 'out of memory'}")
    if isinstance(error, ImportError) and not (error.name or "").startswith("robodyn"):
        return ToolError(f"a library cannot be loaded: {error}", remedy="reinstall robodyn or that library")
    return _InternalError(
        f"{type(error).__name__}: {error}",
        where=_origin(error),
        remedy="unless that file is yours, this is a bug in robodyn: please report it with the command, the "
        "robot file and the output of the command with ROBODYN_DEBUG=1",
    )


def _origin(error: Exception) -> Place | None:
    """Where in the package `error` came up: whoever adds an effect, a language or a format writes a file
    there, and a slip in it is no bug of robodyn."""
    import traceback

    import robodyn

    package = str(Path(robodyn.__file__).parent)
    frames = [x for x in traceback.extract_tb(error.__traceback__) if x.filename.startswith(package)]
    return Place(frames[-1].filename, frames[-1].lineno) if frames else None


def _print(failure: RobodynError) -> None:
    """Print ``{"error": ...}`` on stdout, if that can be written."""
    import json

    try:
        click.echo(json.dumps({"error": failure.to_dict()}, indent=2, ensure_ascii=False))
        sys.stdout.flush()
    except (OSError, ImportError):  # a full disk; no file left to read a module from
        drop(sys.stdout)


def _complain(text: str) -> None:
    """Print `text` on stderr as one line, control characters escaped."""
    talk(escaped(" ".join(f"robodyn: {text}".split())))


def _hint(error: click.ClickException) -> str:
    """What may have been meant where numbers are left over: those of an option are one word."""
    numbers = re.match(
        r"Got unexpected extra arguments? \([-+.\deE\s]+\)|No such option:? '?-\d", error.format_message()
    )
    return "" if numbers is None else "write the numbers of one option with commas, as 0.1,0.2,0.3; "
