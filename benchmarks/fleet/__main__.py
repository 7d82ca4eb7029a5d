"""Fleets of which is known what is planted, judged by ``robodyn fleet``.

    python -m benchmarks.fleet [--units 1000] [--seed S] [--simulator robodyn|mujoco] [--on local:N]

Robodyn's simulator: the default fleet of ``benchmarks.fleet.hide``, three types. MuJoCo: a fleet of the same
types, in more units of which something is planted, with bodies, friction and play of MuJoCo's own; 100 units
will do. Choose a seed that nothing was built with. A run that is broken off goes on where it was. Figures go
to results/fleet.json, and from there to results/fleet.md (``--render`` does that alone).
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks.fleet.plant import ANSWER, FLEET, finish, plant_fleet
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.score import score_fleet
from benchmarks.fleet.table import page
from benchmarks.fleet.units import Moved, moved
from benchmarks.peers.__main__ import machine

from robodyn.cluster import open_cluster
from robodyn.diagnose.blind.seal import unsealed
from robodyn.files import parsed_json
from robodyn.fleet.as_json import document
from robodyn.fleet.run import run_fleet
from robodyn.fleet.sources.reading import read_fleet
from robodyn.formats.loading import load

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "benchmarks" / "results" / "fleet.json"
TYPES = ("puma560", "ur10", "iiwa")
#: Where something is planted in a fleet that has to show it with few units, as shares of them.
_FRICTION, _PLAY, _PAYLOAD = 0.12, 0.05, 0.05
_SIMULATORS = ("robodyn", "mujoco")


def main(arguments: Sequence[str] | None = None) -> int:
    """Simulate, judge, score, write, and return the exit code: 1 if the score is not ``right``."""
    options = _parser().parse_args(arguments)
    code = 0
    if not options.render:
        figures = measured(options)
        results = _results()
        results["machine"] = machine()
        results.setdefault("fleets", {})[options.simulator] = figures
        RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
        code = int(figures["score"]["result"] != "right")
    RESULTS.with_suffix(".md").write_text(page(_results()), encoding="utf-8")
    return code


def measured(options: argparse.Namespace) -> dict[str, Any]:
    """A fleet simulated, judged and scored; times are the wall's."""
    folder = Path(options.work) / f"{options.simulator}-{options.units}-{options.seed}"
    by, recipe = _simulated(options.simulator, Recipe(units=options.units, seed=options.seed))
    begin, times = time.monotonic(), {}
    if not (folder / FLEET).exists():
        with open_cluster(options.on) as cluster:
            planted = plant_fleet(
                [load(name) for name in TYPES], recipe, folder, cluster=cluster, by=by,
                progress=lambda done, all: _tell(f"{done} of {all} units are simulated"),
            )  # fmt: skip
        finish(folder, planted)
        times["simulated"] = time.monotonic() - begin
    fleet, begin = read_fleet(folder), time.monotonic()
    result = run_fleet(
        fleet, folder / "found", options.on, diagnose="none",
        progress=lambda what, done, of: _tell(f"{what}: {done} of {of}"),
    )  # fmt: skip
    times["judged"] = time.monotonic() - begin
    claims = parsed_json(json.dumps(document(result)))
    answer = unsealed((folder / ANSWER).read_text(encoding="utf-8"))
    score = score_fleet(answer, claims).to_dict()
    _tell(f"{options.simulator}: {score['result']}\n")
    return {"seed": options.seed, "logs": len(fleet.logs), "seconds": times, "score": score}


def _simulated(simulator: str, recipe: Recipe) -> tuple[Moved, Recipe]:
    if simulator == "robodyn":
        return moved, recipe
    from benchmarks.fleet import by_mujoco  # robodyn's own fleet does without

    many = replace(recipe, friction_units=_FRICTION, play_units=_PLAY, payload_units=_PAYLOAD)
    return by_mujoco.moved, many


def _results() -> dict[str, Any]:
    return json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}


def _tell(text: str) -> None:
    if sys.stderr.isatty():
        print(f"\r{text:70}", end="", file=sys.stderr, flush=True)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m benchmarks.fleet", description=__doc__)
    parser.add_argument("--units", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--simulator", choices=_SIMULATORS, default="robodyn")
    parser.add_argument("--on", default="local", help="here, local:N or dask://HOST:PORT")
    parser.add_argument(
        "--work", default=str(ROOT / "build" / "fleet"), help="where the logs go (5 GB for 1000 units)"
    )
    parser.add_argument(
        "--render", action="store_true", help="write the page from the figures that are there"
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
