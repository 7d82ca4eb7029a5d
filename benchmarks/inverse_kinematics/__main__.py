"""Inverse kinematics beside EAIK, ssik and a search from many starts.

    python -m benchmarks.inverse_kinematics [ARM ...] [--poses 100000] [--hard 10000] [--searched 200]

Results go to results/inverse_kinematics.json, arm by arm, and from there into the tables of
docs/inverse-kinematics-benchmark.md (``--render`` does that alone).
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks.inverse_kinematics.measure import ROUNDS, arm_of, hard, raced, sets
from benchmarks.inverse_kinematics.tables import written
from benchmarks.peers.__main__ import machine
from benchmarks.peers.race import harness

from robodyn.dynamics.functions import NoSuchFunction
from robodyn.formats.loading import load

ROOT = Path(__file__).parents[2]
RESULTS = ROOT / "benchmarks" / "results" / "inverse_kinematics.json"
PAGE = ROOT / "docs" / "inverse-kinematics-benchmark.md"
_KINEMATICS, _ARMS = "examples/kinematics/{}.yaml", "examples/arms/{}.yaml"
#: The bundled arms, those of which the kinematics alone is public, and others.
ARMS = (
    *("puma560", "stanford", "rx90", "tx40", "ur5", "ur10", "panda", "iiwa", "iiwa7"),
    *map(
        _KINEMATICS.format, ("irb120", "kr6_r900", "lrmate200id", "gp8", "vs060", "rv4fr", "rs007n", "rx160")
    ),
    *map(_KINEMATICS.format, ("ur16e", "z1", "fr3", "xmatepro7")),
    *map(_ARMS.format, ("ur5e", "kr16", "vx300s", "jaco2", "xarm7")),
)


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, write, and return the exit code."""
    options = _parser().parse_args(arguments)
    if not options.render:
        work = Path(options.work).resolve()
        work.mkdir(parents=True, exist_ok=True)
        for name in options.arms or ARMS:
            figures = measured(name, harness(work), work, options)
            results = _results()
            results["machine"] = machine()
            results["arms"][Path(name).stem] = figures
            RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    PAGE.write_text(written(PAGE.read_text(encoding="utf-8"), _results()), encoding="utf-8")
    return 0


def measured(name: str, race_harness: Path, work: Path, options: argparse.Namespace) -> dict[str, Any]:
    """All of one arm."""
    begin = time.monotonic()
    robot = load(name if not name.endswith(".yaml") else ROOT / name)
    try:
        arm = arm_of(robot, race_harness, work)
    except NoSuchFunction as reason:
        return {"refused": str(reason)}
    figures = {
        "joints": robot.n,
        "redundant": arm.ours.redundant,
        "branches": arm.ours.branches,
        "conditions": arm.ours.conditions,
        "generated_seconds": arm.ours.seconds,
        "sets": [*sets(arm, options.poses, options.searched)] if robot.n >= 6 else [],
        "hard": [*hard(arm, options.hard)],
        "race": raced(arm, options.rounds) if robot.n >= 6 else None,
    }
    print(f"{robot.name}: {time.monotonic() - begin:.0f} s", file=sys.stderr, flush=True)
    return figures


def _results() -> dict[str, Any]:
    if RESULTS.is_file():
        return dict(json.loads(RESULTS.read_text(encoding="utf-8")))
    return {"machine": {}, "arms": {}}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="benchmarks.inverse_kinematics", description=(__doc__ or "").partition("\n")[0]
    )
    parser.add_argument("arms", nargs="*", help="bundled arms or files (default: those of the document)")
    parser.add_argument("--poses", type=int, default=100_000, help="poses of the sets (default: 100000)")
    parser.add_argument(
        "--hard", type=int, default=10_000, help="singular poses of each kind (default: 10000)"
    )
    parser.add_argument("--searched", type=int, default=200, help="poses of the search (default: 200)")
    parser.add_argument("--rounds", type=int, default=ROUNDS, help=f"rounds of the race (default: {ROUNDS})")
    parser.add_argument("--work", default="build/inverse_kinematics", help="where runners are compiled")
    parser.add_argument("--render", action="store_true", help="measure nothing, write the tables anew")
    return parser


if __name__ == "__main__":
    sys.exit(main())
