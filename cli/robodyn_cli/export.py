"""``robodyn export``: a description as URDF, MJCF or SDF."""

from __future__ import annotations

from collections.abc import Sequence

import click

from robodyn_cli.choices import FILE, TARGET_FORMATS
from robodyn_cli.decorators import flag, option, robot_argument
from robodyn_cli.output import as_json, echo_json, talk
from robodyn_cli.output_files import FORCE_FILE, new_file, write_or_echo
from robodyn_cli.robot_files import load_robot, parameter_values
from robodyn_cli.values import parameter_option


@click.command()
@robot_argument
@option("--to=FORMAT", "Format of the file: urdf, mjcf or sdf.", TARGET_FORMATS, required=True)
@parameter_option()
@option("-o --output=FILE", "Output file; default: stdout.", FILE)
@flag("--force", FORCE_FILE)
def command(robot: str, to: str, param: Sequence[tuple[str, float]], output: str | None, force: bool) -> None:
    """Export a robot to URDF, MJCF or SDF.

    The file has the same torques, poses and joint coordinates, base and tool frames, limits, viscous and
    Coulomb friction, and cylinders for pictures. What its format cannot say is listed on stderr.
    """
    from robodyn.formats.exporting import export_arm

    path = None if output in (None, "-") else new_file(str(output), force=force)
    arm = load_robot(robot)
    if param:
        arm = arm.at(parameter_values(arm, param))
    exported = export_arm(arm, to)
    for remark in exported.remarks:
        talk(f"robodyn: note: {remark}")
    for what in exported.missing:
        talk(f"robodyn: not in the file: {what}")
    write_or_echo(exported.text, path, force=force, joints=arm.n)
    if as_json():
        lists = {"remarks": list(exported.remarks), "missing": list(exported.missing)}
        file = {"joints": list(exported.names), "path": str(path) if path else None}
        echo_json({"name": arm.name, "format": to, **file, **lists, "text": exported.text})
