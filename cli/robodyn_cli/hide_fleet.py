"""``robodyn hide --fleet``: make blind tests of ``robodyn fleet``."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from robodyn.outputs import write_files
from robodyn_cli import progress
from robodyn_cli.common import echo_json, load_robot, output_folder, printable, talk

if TYPE_CHECKING:
    from robodyn.fleet.planted.plant import Format
    from robodyn.fleet.planted.recipe import Recipe


def plant(robots: Sequence[str], options: dict[str, Any], *, as_json: bool) -> None:
    """Write a simulated fleet.

    Raises
    ------
    InputError: no robots or no folder, a recipe that is wrong, or a fleet that cannot be simulated.
    ToolError: no C compiler; no pyarrow.
    """
    from robodyn.cluster import open_cluster
    from robodyn.diagnose.blind.seal import seal
    from robodyn.errors import InputError
    from robodyn.fleet.planted.plant import ANSWER, finish, plant_fleet

    if options["output"] is None:
        raise InputError("no output folder", remedy="add -o DIR")
    folder = output_folder(options["output"])
    recipe = _recipe(options)
    loaded = [load_robot(robot) for robot in robots]
    with progress.line() as line, open_cluster(options["on"]) as cluster:
        planted = plant_fleet(
            loaded,
            recipe,
            folder,
            format=options["format"] or _format(),
            cluster=cluster,
            progress=lambda done, all: line.tell(f"robodyn: {done} of {all} units"),
        )
    write_files(folder, {**planted.files, ANSWER: seal(planted.answer)})
    finish(folder)
    if not planted.changes:
        talk(
            f"robodyn: note: in {planted.units} units nothing is hidden: too few for the recipe's shares; "
            "more of them, or larger shares in a --recipe, have some"
        )
    if as_json:
        echo_json(
            {
                "folder": str(folder),
                "types": [robot.name for robot in loaded],
                "units": planted.units,
                "logs": planted.logs,
                "changes": planted.changes,
            }
        )
        return
    at = printable(folder)
    click.echo(f"{planted.units} units, {planted.logs} logs, {planted.changes} changes are hidden in {at}")
    click.echo(f"robodyn fleet {at} -o {at}/found")
    click.echo(f"robodyn hide --score {at} {at}/found/fleet.json")


def _recipe(options: dict[str, Any]) -> Recipe:
    from robodyn.fleet.planted.recipe import Recipe, read_recipe

    chosen = {"units": options["fleet"], "seed": options["seed"]}
    path = options["recipe"]
    return Recipe(**chosen) if path is None else read_recipe(Path(path), **chosen)


def _format() -> Format:
    """Parquet where it can be written."""
    from robodyn.tools.libraries import PYARROW

    return "parquet" if PYARROW.present() else "csv"
