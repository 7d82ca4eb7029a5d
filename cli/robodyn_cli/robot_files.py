"""The ROBOT of a command, and the values of its run-time parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import click

from robodyn_cli.output import note_robot, talk
from robodyn_cli.values import unique

if TYPE_CHECKING:
    from robodyn.robot import Robot


#: Commands that know of joints that follow others; the rest refuse a robot with such.
_COUPLED: Final = ("gen", "flops", "verify", "package", "build", "export", "diff", "robots")


def load_robot(robot: str, *, strict: bool = False) -> Robot:
    """Load ROBOT, a path or a bundled name. Warnings about implausible values, and what is to be known of the
    file, go to stderr, one line each; the JSON document of the command has it too.

    Raises
    ------
    InputError: there is no such robot, the file is invalid, or `strict` is set and values are implausible; or
        its joints follow others, and the command does not know of that.
    """
    from robodyn.formats.loading import load

    described = load(
        robot,
        strict=strict,
        warn=lambda text: talk(f"robodyn: warning: {text}"),
        note=lambda text: talk(f"robodyn: note: {text}"),
    )
    command = click.get_current_context().info_name
    if described.couplings and command not in _COUPLED:
        from robodyn.robot.coupling import no_couplings

        no_couplings(described, f"robodyn {command}")
    note_robot(described)
    return described


def parameter_values(robot: Robot, options: Sequence[tuple[str, float]]) -> dict[str, float]:
    """The values of ``--param NAME=VALUE``, in the order of the robot's run-time parameters.

    Raises
    ------
    InputError: one stands there twice, or they do not fit the robot.
    """
    from robodyn.robot.filling import parameter_values

    return parameter_values(robot, unique(options, "--param"))
