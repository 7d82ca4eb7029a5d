"""Shared by the commands: arguments, output, and writing of files."""

from __future__ import annotations

import contextlib
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any, Final, TypeVar

import click

from robodyn.errors import CheckError, InputError
from robodyn.outputs import ELSEWHERE, write_files
from robodyn_cli.choices import ROBOTS

if TYPE_CHECKING:
    from robodyn.robot import Robot

Command = TypeVar("Command", bound=Callable[..., Any])


def add_options(*options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """A decorator that adds all ``options`` to a command, in this order of its help."""

    def add(command: Command) -> Command:
        for option in reversed(options):
            command = option(command)
        return command

    return add


def option(
    names: str, help: str | Callable[[], str], type: Any = str, **more: Any
) -> Callable[[Command], Command]:
    """A decorator that adds an option to a command: ``option("-o --output=DIR to", "Output folder.")`` has
    its spellings, what stands for the value, and the argument's name where that is not the last spelling.
    A list or tuple in place of a ``type`` has the words to choose from; a default is shown in the help, which
    is looked up when it is printed if it is a function."""
    spelled = [part.partition("=") for part in names.split()]
    metavar = next((metavar for _, _, metavar in spelled if metavar), None)
    more = {"metavar": metavar, "show_default": "default" in more, **more}
    if callable(help):
        more |= {"cls": _LateHelp, "look_up": help}
    else:
        more["help"] = help
    kind = click.Choice(type) if isinstance(type, (list, tuple)) else type
    return click.option(*(name for name, _, _ in spelled), type=kind, **more)


class _LateHelp(click.Option):
    """An option whose help lists what a table of the library has."""

    def __init__(self, *names: Any, look_up: Callable[[], str], **others: Any) -> None:
        super().__init__(*names, **others)
        self._look_up = look_up

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        self.help = self._look_up()
        return super().get_help_record(ctx)


def flag(names: str, help: str, **more: Any) -> Callable[[Command], Command]:
    """A decorator that adds a flag to a command: ``names`` are separated by blanks."""
    return click.option(*names.split(), is_flag=True, help=help, **more)


def robot_argument(command: Command) -> Command:
    """Add the argument ROBOT, passed to `command` as ``robot: str`` without any check."""
    return click.argument("robot", type=ROBOTS, metavar="ROBOT")(command)


#: The option that every command has.
JSON: Final = click.Option(
    ["--json", "as_json"], is_flag=True, help="Print the results, or the error, as JSON."
)


def as_json() -> bool:
    """Whether the command that runs has ``--json``."""
    return bool(click.get_current_context().params.get("as_json"))


def force_option(text: str) -> Callable[[Command], Command]:
    """Add the flag ``--force``, passed to the command as ``force: bool``; ``text`` is its help."""
    return flag("--force", text)


#: Help of ``--force`` where robodyn chooses the names of files.
FORCE: Final = "Also replace files that robodyn did not write, and links."
#: Help of ``--force`` where the command line names the file.
FORCE_FILE: Final = "Overwrite an existing file."


def write_file(
    path: Path, content: str | bytes, *, force: bool | None = None, remedy: str = ELSEWHERE
) -> None:
    """Write the file that the command line names: what is there is replaced, but no link.

    Raises
    ------
    InputError, OutputError: as of :func:`robodyn.outputs.write_files`.
    """
    write_files(path.parent, {path.name: content}, named=True, force=force, remedy=remedy)


@dataclass(slots=True)
class Document:
    """The one JSON document that stdout gets from a command: whether the command line asks for one, and
    whether its printing has begun; ``robots``: those that it is about. It is the object of
    click's context."""

    as_json: bool = False
    begun: bool = False
    robots: list[Robot] = field(default_factory=list)


def _document() -> Document | None:
    context = click.get_current_context(silent=True)
    return None if context is None else context.find_object(Document)


def echo_document(text: str) -> None:
    """Print `text`, a JSON document, on stdout: the only one there, even if the command fails afterwards."""
    if (document := _document()) is not None:
        document.begun = True
    click.echo(text.rstrip("\n"))


def echo_json(obj: object) -> None:
    """Print `obj` on stdout as indented JSON; keys keep their order, and NaN is refused (ValueError). What is
    known of the robots that were loaded stands at its end under ``account``."""
    import json

    echo_document(json.dumps(with_account(obj), indent=2, ensure_ascii=False, allow_nan=False))


def show(data: Callable[[], object], lines: Callable[[], Iterable[str]]) -> None:
    """Print the results: their ``data`` as JSON with --json, else as ``lines``."""
    if as_json():
        echo_json(data())
        return
    for line in lines():
        click.echo(line)


def with_account(obj: object) -> object:
    """`obj`, each of its mappings if it is a list, with what is known of the robots that were loaded."""
    document = _document()
    if document is None or not document.robots:
        return obj
    from robodyn.robot.account import account_to_dict

    account = [account_to_dict(robot) for robot in document.robots]
    if isinstance(obj, list):
        return [{**record, "account": account} for record in obj]
    assert isinstance(obj, dict)
    return {**obj, "account": account}


#: Columns of what is printed on stdout.
WIDTH: Final = 100


def wrapped(text: str) -> list[str]:
    """``text`` as lines of at most :data:`WIDTH` columns, all but the first indented; words stay whole."""
    import textwrap

    return textwrap.wrap(text, WIDTH, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def talk(text: str) -> None:
    """Print the message `text` on stderr; a stderr that cannot be written is ignored."""
    try:
        click.echo(text, err=True)
    except OSError:
        drop(sys.stderr)


def drop(stream: IO[str] | None) -> None:
    """Discard what `stream` still buffers, so that the interpreter does not complain at exit."""
    if stream is None:
        return
    with contextlib.suppress(OSError, ValueError):  # a replacement without a descriptor, as in tests
        descriptor = stream.fileno()
        null = os.open(os.devnull, os.O_WRONLY)
        os.dup2(null, descriptor)
        os.close(null)


def printable(path: Path | str) -> str:
    """`path` for a message: as it is, or quoted and escaped if it contains a control character."""
    from robodyn.robot.names import shown

    text = str(path)
    quoted = shown(text, len(text))
    return text if quoted == f"'{text}'" else quoted


def output_folder(text: str) -> Path:
    """The folder or file named by the option ``-o``.

    Raises
    ------
    InputError: the name is empty, for instance from an unset variable.
    """
    if not text:
        raise InputError("the path after -o is empty", remedy="use -o . for this folder")
    return Path(text)


def picture_file(text: str) -> Path:
    """The path of a picture.

    Raises
    ------
    InputError: the name does not end in .svg.
    """
    if not text.endswith(".svg") or text == ".svg":
        raise InputError("pictures are written as SVG", found=repr(text), expected="a name that ends in .svg")
    return Path(text)


def load_robot(robot: str, *, strict: bool = False) -> Robot:
    """Load ROBOT, a path or a bundled name. Warnings about implausible values, and what is to be known of the
    file, go to stderr, one line each; the JSON document of the command has it too.

    Raises
    ------
    InputError: there is no such robot, the file is invalid, or `strict` is set and values are implausible.
    """
    from robodyn.formats.loading import load

    described = load(
        robot,
        strict=strict,
        warn=lambda text: talk(f"robodyn: warning: {text}"),
        note=lambda text: talk(f"robodyn: note: {text}"),
    )
    if (document := _document()) is not None:
        document.robots.append(described)
    return described


def parameter_values(robot: Robot, options: Sequence[tuple[str, float]]) -> dict[str, float]:
    """The values of ``--param NAME=VALUE``, in the order of the robot's run-time parameters.

    Raises
    ------
    InputError: one stands there twice, or they do not fit the robot.
    """
    from robodyn.robot.filling import parameter_values

    names = [name for name, _ in options]
    twice = [name for name in names if names.count(name) > 1]
    if twice:
        raise InputError(
            f"a run-time parameter of {robot.name} has two values",
            found=f"--param {twice[0]}=... twice",
            remedy="leave one of the two out",
        )
    return parameter_values(robot, dict(options))


def new_file(text: str, *, force: bool) -> Path:
    """The file named by the option ``-o``, where nothing is unless ``force``, not even a broken link.

    Raises
    ------
    InputError: the name is empty, or something is there.
    """
    path = output_folder(text)
    if os.path.lexists(path) and not force:
        raise InputError(
            f"{printable(path)} already exists",
            remedy="choose another path with -o, or overwrite it with --force",
        )
    return path


def write_or_echo(text: str, path: Path | None, *, force: bool, joints: int) -> None:
    """Write ``text`` to the file of ``-o`` and say so; without one it is the result on stdout."""
    if path is not None:
        write_file(path, text, force=force)
        talk(f"robodyn: wrote {printable(path)}: {joints} joints")
    elif not as_json():
        click.echo(text, nl=False)


def check_files(folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Compare ``folder`` with what would be written there, for ``--check``.

    Raises
    ------
    CheckError: a file is missing, or differs.
    """
    different = compare_files(folder, files)
    if different:
        raise CheckError(
            f"{', '.join(printable(folder / name) for name in different)}: not up to date",
            remedy="run the same command without --check",
        )


def report_up_to_date(robot: str, folder: Path, files: Mapping[str, str | bytes]) -> None:
    """Compare ``folder`` with what would be written there, and say so.

    Raises
    ------
    CheckError: a file is missing, or differs.
    """
    check_files(folder, files)
    if as_json():
        echo_json({"robot": robot, "checked": [str(folder / file) for file in files]})
    else:
        click.echo(f"{robot}: {len(files)} files in {printable(folder)} are up to date")


def compare_files(folder: Path, files: Mapping[str, str | bytes]) -> list[str]:
    """The names among `files` (path relative to `folder` -> content) that are missing or differ, in order.

    Bytes are compared, so line endings matter. Other files in the folder are ignored.
    """
    return [
        name
        for name, content in files.items()
        if _read(folder / name) != (content if isinstance(content, bytes) else content.encode("utf-8"))
    ]


def _read(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except OSError:
        return None
