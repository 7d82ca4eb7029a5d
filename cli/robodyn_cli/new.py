"""``robodyn new``: write a commented starter file."""

from __future__ import annotations

import click

from robodyn_cli.choices import FILE
from robodyn_cli.decorators import flag, option
from robodyn_cli.output import as_json, echo_json, printable, talk
from robodyn_cli.output_files import FORCE_FILE, new_file, write_file


@click.command()
@click.argument("name", default="my_robot")
@option("--joints=N", "Number of joints.", click.IntRange(min=1), default=6)
@option("-o --output=FILE", "Output file, - for stdout.  [default: NAME.yaml]", FILE)
@flag("--force", FORCE_FILE)
def command(name: str, joints: int, output: str | None, force: bool) -> None:
    """Write a commented starter file to fill in.

    NAME is the robot's name [default: my_robot], a C identifier: the prefix of every function generated for
    the robot.
    """
    import robodyn.robot

    text = robodyn.robot.starter(name, joints)
    if output == "-":
        if as_json():
            echo_json({"name": name, "joints": joints, "text": text})
        else:
            click.echo(text, nl=False)
        return
    path = new_file(f"{name}.yaml" if output is None else output, force=force)
    write_file(path, text, force=force)
    if as_json():
        echo_json({"name": name, "joints": joints, "path": str(path)})
    label = printable(path)
    talk(f"wrote {label}: fill it in, then run: robodyn gen {label}")
