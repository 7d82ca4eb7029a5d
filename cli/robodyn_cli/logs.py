"""``robodyn logs``: what is in a log, and the map that it needs."""

from __future__ import annotations

from pathlib import Path

import click

from robodyn.errors import InputError
from robodyn_cli.choices import FILE, ROBOTS
from robodyn_cli.decorators import option
from robodyn_cli.log_files import log_map, log_options, spare_inputs
from robodyn_cli.output import printable, show, talk
from robodyn_cli.output_files import write_file
from robodyn_cli.robot_files import load_robot


@click.command()
@click.argument("file", type=FILE, metavar="FILE")
@option("--robot=ROBOT", "Compare joints, limits and signs.", ROBOTS)
@log_options
@option("-o --output=MAP.yaml out", "Write the map to this file.", FILE)
def command(file: str, robot: str | None, map_file: str | None, columns: str | None, out: str | None) -> None:
    """Show what is in a log, and propose which columns are what.

    FILE is a recording of any kind that --map lists, or a folder of rosbag2. The command lists its columns
    with their ranges, proposes a map by their names and numbers, says why, and shows the log as the map reads
    it. Give the map to diagnose with --map.
    """
    from robodyn.logs.content import input_files
    from robodyn.logs.map_text import map_text
    from robodyn.logs.wizard import examine
    from robodyn.report.logs import data, lines

    described = None if robot is None else load_robot(robot)
    if out is not None:
        if not Path(out).name:
            raise InputError("the path after -o is empty", remedy="use -o map.yaml")
        inputs = [str(path) for path in input_files(file)]
        spare_inputs([Path(out)], [*inputs, *([map_file] if map_file else [])])
    result = examine(file, described, log_map(map_file, columns))
    show(lambda: data(result), lambda: lines(result, "" if described is None else described.name))
    if out is not None:
        title = f"Map of {Path(file).name}. Check it; robodyn logs FILE --map shows what it does."
        text = map_text(result.mapping, result.reasons, result.missing, title)
        path = Path(out)
        write_file(path, text)
        talk(f"robodyn: wrote {printable(out)}")
