"""``robodyn robots``: list the bundled robots."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from robodyn_cli.decorators import flag
from robodyn_cli.output import WIDTH, as_json, echo_json

if TYPE_CHECKING:
    from robodyn.robot import Robot


@click.command()
@flag("--names", "Print the names only, one per line.")
def command(names: bool) -> None:
    """List the bundled robots.

    Each line shows the joints from base to tip, R for revolute and P for prismatic, and where masses and
    inertias come from; arms whose numbers are invented come last. --json prints a list of objects {"name",
    "joints", "origin", "title"}; with --names, a list of names.
    """
    import textwrap

    import robodyn.robot
    from robodyn.robot.account import inertial_origin

    bundled = robodyn.robot.bundled_names()
    if names:
        if as_json():
            echo_json(list(bundled))
        else:
            for name in bundled:
                click.echo(name)
        return
    robots = [robodyn.robot.load(name, warn=lambda _: None) for name in bundled]
    rows = [(robot.name, _letters(robot), inertial_origin(robot.links), robot.title) for robot in robots]
    rows.sort(key=lambda row: row[2] == "synthetic")
    if as_json():
        echo_json([dict(zip(("name", "joints", "origin", "title"), row, strict=True)) for row in rows])
        return
    widths = [max((len(row[column]) for row in rows), default=0) for column in range(3)]
    for *columns, title in rows:
        head = "".join(f"{text:{width}}  " for text, width in zip(columns, widths, strict=True))
        indent = " " * len(head)
        lines = textwrap.wrap(title, max(20, WIDTH - len(indent)))
        click.echo((head + f"\n{indent}".join(lines)).rstrip())


def _letters(robot: Robot) -> str:
    """The kinds of a robot's joints, base to tip, as ``RRPRRR``."""
    return "".join(link.joint.kind[0].upper() for link in robot.links)
