"""A simulated fleet with hidden changes, as a blind test of ``robodyn fleet``.

    python -m benchmarks.fleet.hide ROBOT... -o DIR [--units N] [--seed S] [--recipe FILE.toml]
                                    [--format csv|parquet] [--on here|local:N|dask://HOST:PORT]

Units of several types scatter about their types, and in some friction grows, play grows or a payload is not
entered. DIR gets logs over a year (logs/), data sheets (types/), manifest.csv, fleet.toml and answer.sealed.
A run that is broken off goes on where it was. ``python -m benchmarks.fleet.score`` compares fleet.json with
the answer.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from benchmarks.fleet.plant import finish, plant_fleet
from benchmarks.fleet.recipe import Recipe, read_recipe

from robodyn.cluster import open_cluster
from robodyn.errors import RobodynError
from robodyn.formats.loading import load
from robodyn.tools.libraries import PYARROW


def main(arguments: Sequence[str] | None = None) -> int:
    """Simulate a fleet, and return the exit code."""
    options = _parser().parse_args(arguments)
    folder, chosen = Path(options.output), {"units": options.units, "seed": options.seed}
    try:
        recipe = read_recipe(Path(options.recipe), **chosen) if options.recipe else Recipe(**chosen)
        with open_cluster(options.on) as cluster:
            robots = [load(robot) for robot in options.robots]
            fleet = plant_fleet(robots, recipe, folder, format=options.format, cluster=cluster)
        finish(folder, fleet)
    except RobodynError as error:
        print(f"error: {error}", file=sys.stderr)
        return error.exit_code
    if not fleet.changes:
        print(f"note: the shares of the recipe hide nothing in {fleet.units} units", file=sys.stderr)
    print(f"{fleet.units} units, {fleet.logs} logs, {fleet.changes} changes are hidden in {folder}")
    return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.fleet.hide",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("robots", nargs="+", metavar="ROBOT")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--units", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--recipe", metavar="FILE.toml")
    parser.add_argument(
        "--format", choices=["csv", "parquet"], default="parquet" if PYARROW.present() else "csv"
    )
    parser.add_argument("--on", default="local")
    return parser


if __name__ == "__main__":
    sys.exit(main())
