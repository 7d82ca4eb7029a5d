"""The ROBOT of a command, and the values of its run-time parameters."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from robodyn_cli.output import note_robot, talk
from robodyn_cli.values import unique

if TYPE_CHECKING:
    from robodyn.robot import Robot


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
