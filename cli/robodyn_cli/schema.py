"""``robodyn schema``: print the JSON Schema of the robot description, or of another file or output."""

from __future__ import annotations

import click

from robodyn.errors import error_schema
from robodyn_cli.decorators import at_most_one, flag
from robodyn_cli.output import echo_json


@click.command()
@flag("--project", "That of the project file, robodyn.toml, instead.")
@flag("--fleet", "That of fleet.json, the result of robodyn fleet, instead.")
@flag("--fleet-file", "That of the description of a fleet, fleet.toml, instead.")
@flag("--error", "That of what --json prints where a command fails, instead.")
def command(project: bool, fleet: bool, fleet_file: bool, error: bool) -> None:
    """Print the JSON Schema of the robot description.

    An editor can use it to complete keys and mark mistakes in the YAML file, in robodyn.toml or in
    fleet.toml. The output is JSON with and without --json.
    """
    at_most_one({"--project": project, "--fleet": fleet, "--fleet-file": fleet_file, "--error": error})
    if error:
        echo_json(error_schema())
    elif fleet:
        from robodyn.fleet.as_json import fleet_schema

        echo_json(fleet_schema())
    elif fleet_file:
        from robodyn.fleet.sources.schema import fleet_file_schema

        echo_json(fleet_file_schema())
    elif project:
        from robodyn.project.schema import project_schema
        from robodyn_cli.choices import PACKAGES
        from robodyn_cli.project_keys import project_keys

        echo_json(project_schema(project_keys(), PACKAGES.words()))
    else:
        import robodyn.robot

        echo_json(robodyn.robot.json_schema())
