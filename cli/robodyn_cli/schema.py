"""``robodyn schema``: print the JSON Schema of the robot description, or of another file or output."""

from __future__ import annotations

import click

from robodyn.errors import InputError, error_schema
from robodyn_cli.common import echo_json, json_option


@click.command()
@click.option("--project", is_flag=True, help="That of the project file, robodyn.toml, instead.")
@click.option("--error", is_flag=True, help="That of what --json prints where a command fails, instead.")
@json_option
def command(project: bool, error: bool, as_json: bool) -> None:
    """Print the JSON Schema of the robot description.

    An editor can use it to complete keys and mark mistakes in the YAML file, or in robodyn.toml. The output
    is JSON with and without --json.
    """
    if project and error:
        raise InputError("one schema at a time", found="--project and --error", remedy="remove one of them")
    if error:
        echo_json(error_schema())
        return
    if project:
        from robodyn.project.schema import project_schema
        from robodyn_cli.choices import PACKAGES
        from robodyn_cli.project_keys import project_keys

        echo_json(project_schema(project_keys(), PACKAGES.words()))
        return
    import robodyn.robot

    echo_json(robodyn.robot.json_schema())
