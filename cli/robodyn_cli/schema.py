"""``robodyn schema``: print the JSON Schema of the robot description."""

from __future__ import annotations

import click

from robodyn_cli.common import echo_json, json_option


@click.command()
@json_option
def command(as_json: bool) -> None:
    """Print the JSON Schema of the robot description.

    An editor can use it to complete keys and mark mistakes in the YAML file. The output is JSON with and
    without --json.
    """
    import robodyn.robot

    echo_json(robodyn.robot.json_schema())
