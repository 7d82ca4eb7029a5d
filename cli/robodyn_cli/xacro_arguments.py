"""``--arg NAME=VALUE`` of every command that takes a ROBOT, which may be a xacro or an MJCF file."""

from __future__ import annotations

import copy
from collections.abc import Callable, Iterator
from functools import wraps
from typing import Any

import click

from robodyn.errors import InputError
from robodyn_cli.choices import ROBOTS
from robodyn_cli.values import Argument, unique


def with_xacro_arguments(command: click.Command) -> click.Command:
    """``command``, which takes a ROBOT, with ``--arg``; itself it stays as it is: no project has the key."""
    assert command.callback is not None
    wider = copy.copy(command)
    option = click.Option(
        ["--arg"],
        type=Argument(),
        multiple=True,
        metavar="NAME=VALUE",
        help="Set an argument of a xacro file, or ('find NAME') a folder that it or an MJCF file may read; "
        "may be repeated.",
    )
    wider.params = [*command.params, option]
    wider.callback = _in_their_context(command.callback)
    return wider


def _in_their_context(callback: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(callback)
    def with_arguments(*, arg: tuple[tuple[str, str], ...], **parameters: Any) -> Any:
        if not arg:
            return callback(**parameters)
        from robodyn.formats.reading import xacro_arguments

        robots = list(_robots(click.get_current_context()))
        only_folders = all(name.startswith("find ") for name, _ in arg)
        readers = (".xacro", ".xml", ".mjcf") if only_folders else (".xacro",)
        if not any(robot.lower().endswith(readers) for robot in robots):
            raise InputError(
                "arguments are for xacro files",
                found=", ".join(robots) or "no ROBOT",
                remedy="leave --arg out",
            )
        with xacro_arguments(unique(arg, "--arg")):
            return callback(**parameters)

    return with_arguments


def _robots(context: click.Context) -> Iterator[str]:
    """What the command line names as ROBOT."""
    for parameter in context.command.params:
        value = context.params.get(parameter.name or "")
        if parameter.type is ROBOTS and value:
            yield from (value,) if isinstance(value, str) else value
