"""What adds arguments and options to a command, each said on a line; and refusals of options together."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final, TypeVar

import click

from robodyn.errors import InputError
from robodyn_cli.choices import ROBOTS

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


#: The option that every command has. Whether it is there stands in the :class:`Document`, which wrong usage
#: of the other options does not keep from being right.
JSON: Final = click.Option(
    ["--json", "as_json"],
    is_flag=True,
    expose_value=False,
    help="Print the results, or the error, as JSON.",
)


def at_most_one(options: Mapping[str, object]) -> str | None:
    """Which of the ``options``, by their spellings, is there; None: none of them.

    Raises
    ------
    InputError: two are, and contradict each other.
    """
    there = [name for name, value in options.items() if value not in (None, False, ())]
    if len(there) > 1:
        raise InputError(f"{there[0]} and {there[1]} cannot be combined", remedy="remove one of them")
    return there[0] if there else None
