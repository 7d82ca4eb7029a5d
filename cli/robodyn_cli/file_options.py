"""``--arg``, ``--model``, ``--without``, ``--massless`` of every command with a ROBOT: how files are read."""

from __future__ import annotations

import copy
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from functools import wraps
from typing import Any

import click

from robodyn.errors import InputError
from robodyn_cli.choices import ROBOTS
from robodyn_cli.decorators import JSON, add_options, flag, option
from robodyn_cli.values import Argument, unique

file_options = add_options(
    option(
        "--arg=NAME=VALUE",
        "Set an argument of a xacro file, or ('find NAME') a folder that it or an MJCF file may read; may "
        "be repeated.",
        Argument(),
        multiple=True,
    ),
    option(
        "--model=NAME file_model",
        "Model to read from an SDF file that has several; OUTER::INNER for one in another.",
        default="",
        show_default=False,
    ),
    option(
        "--without=NAME left_out",
        "Leave out something that a file in another format states, that changes torques and that is not "
        "modelled: gravcomp, density, ...; may be repeated.",
        multiple=True,
    ),
    flag(
        "--massless",
        "Take masses and inertias that the file does not state as 0; without it, torques that rest on them "
        "are refused.",
    ),
)
"""Adds ``--arg`` (``arg``), ``--model`` (``file_model``), ``--without`` (``left_out``) and ``--massless``
(``massless``) to a command."""


def with_common_options(command: click.Command) -> click.Command:
    """``command`` with ``--json`` and, if it takes a ROBOT, with the options of how files are read, none of
    which its function gets."""
    callback = command.callback
    assert callback is not None
    takes_robot = any(parameter.type is ROBOTS for parameter in command.params)

    @wraps(callback)
    def with_options(**parameters: Any) -> Any:
        with files_read_by(parameters) if takes_robot else nullcontext():
            return callback(**parameters)

    wider = copy.copy(command)
    wider.params = [*command.params, JSON]
    if takes_robot:
        wider.params += reversed(file_options(with_options).__click_params__)  # type: ignore[attr-defined]
    wider.callback = with_options
    return wider


@contextmanager
def files_read_by(parameters: dict[str, Any]) -> Iterator[None]:
    """A context in which files are read as the options among ``parameters`` say, which are taken out.

    Raises
    ------
    InputError: an option that none of the robots of the command line can use.
    """
    options = ("arg", "file_model", "left_out", "massless")
    arg, file_model, left_out, massless = (parameters.pop(name) for name in options)
    if not arg and not file_model and not left_out and not massless:
        yield
        return
    from robodyn.formats.arm import how_files_are_read, is_sdf
    from robodyn.formats.loading import SUFFIXES

    robots = list(_robots(click.get_current_context()))
    only_folders = all(name.startswith("find ") for name, _ in arg)
    readers = (".xacro", ".xml", ".mjcf") if only_folders else (".xacro",)
    if arg and not any(robot.lower().endswith(readers) for robot in robots):
        raise _useless("arguments are for xacro files", robots, "leave --arg out")
    if left_out and not any(robot.lower().endswith(SUFFIXES) for robot in robots):
        raise _useless("what is left out is stated by other formats", robots, "leave --without out")
    if file_model and not any(map(is_sdf, robots)):
        of_controller = " (the controller's model is --controller-model ROBOT)"
        simulates = click.get_current_context().info_name == "simulate"
        raise _useless(
            "a model is chosen in SDF files", robots, f"leave --model out{of_controller if simulates else ''}"
        )
    with how_files_are_read(unique(arg, "--arg"), file_model, left_out, massless):
        yield


def _useless(what: str, robots: list[str], remedy: str) -> InputError:
    return InputError(what, found=", ".join(robots) or "no ROBOT", remedy=remedy)


def _robots(context: click.Context) -> Iterator[str]:
    """What the command line names as ROBOT."""
    for parameter in context.command.params:
        value = context.params.get(parameter.name or "")
        if parameter.type is ROBOTS and value:
            yield from (value,) if isinstance(value, str) else value
