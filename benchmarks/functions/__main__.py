"""Count the operations of every function beside those of other tools: ``python -m benchmarks.functions``.

Of all bundled robots, ours as shipped and with ``--optimize fast``; CasADi's SX, SymForce and wrenfold given
the same function (:mod:`.natural`); Pinocchio's algorithms traced by CasADi. What a tool makes is evaluated
at random states and counted only if it gives our values. Results go to ``benchmarks/results``:
functions.json, and made from it functions.md, the table in ``docs`` and robots/records/peers.csv.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.functions.answers import Answers, answers_of
from benchmarks.functions.natural import NATURAL
from benchmarks.functions.tables import in_document, markdown
from benchmarks.functions.tables import versions as versions_text
from benchmarks.functions.tools import TOOLS
from benchmarks.peers.building import Lacking, version
from benchmarks.peers.candidates import pinocchio_traced
from benchmarks.peers.numbers_in_c import text_of
from benchmarks.peers.ours import values_of
from numpy.typing import NDArray

from robodyn.bench.peers.numbers import Disagreement, hold_against, numbers_of
from robodyn.counts import count
from robodyn.counts.peers import FILE, peers_csv
from robodyn.dynamics.functions import NoSuchFunction
from robodyn.kernels.generate import Options, program
from robodyn.robot import bundled_names, load

ROOT = Path(__file__).resolve().parents[2]
RESULTS, DOCUMENT = ROOT / "benchmarks" / "results", ROOT / "docs" / "function-counts.md"
PEERS = ROOT / "robots" / FILE
#: States at which values are compared, and how they are drawn: rad, rad/s and rad/s^2 (or N m).
STATES, SEED, REACH = 4, 11, (np.pi, 3.0, 10.0)
PACKAGES = {"casadi": "casadi", "symforce": "symforce", "wrenfold": "wrenfold", "pinocchio": "pin"}


def main(arguments: Sequence[str] | None = None) -> int:
    """Count, write, and return the exit code."""
    parser = argparse.ArgumentParser(
        prog="benchmarks.functions", description=(__doc__ or "").partition("\n")[0]
    )
    parser.add_argument("--robots", default=",".join(bundled_names()), help="with commas (default: all)")
    parser.add_argument("--functions", default=",".join(NATURAL), help="with commas (default: all)")
    parser.add_argument("--tools", default=",".join(TOOLS), help="with commas (default: all; '': only ours)")
    parser.add_argument("--seconds", type=int, default=8, help="of CPU for a function (default: 8)")
    parser.add_argument("--work", default="build/functions", help="where tools write")
    parser.add_argument("--out", default=str(RESULTS), help="where results go (default: benchmarks/results)")
    parser.add_argument("--keep", action="store_true", help="keep what functions.json has of other tools")
    parser.add_argument("--render", action="store_true", help="count nothing, write tables anew")
    options = parser.parse_args(arguments)
    out = Path(options.out)
    before: dict[str, Any] = {}
    if options.render or options.keep:
        before = json.loads((out / "functions.json").read_text(encoding="utf-8"))
    if options.render:
        figures = before
    else:
        robots = dict(before.get("robots", {}))
        figures = {"versions": versions(), "seconds": options.seconds, "states": STATES, "robots": robots}
        for name in options.robots.split(","):
            tools = [tool for tool in options.tools.split(",") if tool]
            table = of_robot(name, options.functions.split(","), tools, options)
            earlier = robots.get(name, {})
            robots[name] = earlier | {f: earlier.get(f, {}) | row for f, row in table.items()}
            figures["robots"] = {of: robots[of] for of in bundled_names() if of in robots}
            print(f"{name}: counted", file=sys.stderr, flush=True)
            write(figures, out)
    write(figures, out)
    print((out / "functions.md").read_text(encoding="utf-8"))
    return 0


def write(figures: dict[str, Any], out: Path) -> None:
    """functions.json, and what is made from it."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "functions.json").write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    (out / "functions.md").write_text(markdown(figures), encoding="utf-8")
    if out == RESULTS:
        PEERS.write_text(peers_text(figures), encoding="utf-8")
        DOCUMENT.write_text(in_document(figures, DOCUMENT.read_text(encoding="utf-8")), encoding="utf-8")


def peers_text(figures: dict[str, Any]) -> str:
    """peers.csv, which is shipped with the robots."""
    counted = ((load(name, warn=lambda _: None), row) for name, row in figures["robots"].items())
    return peers_csv(versions_text(figures), counted)


def versions() -> dict[str, str]:
    """Versions of the tools that are there."""
    present = {}
    for tool, package in PACKAGES.items():
        try:
            present[tool] = version(package)
        except Lacking as lacking:
            print(lacking, file=sys.stderr)
    return present


def of_robot(
    name: str, functions: Sequence[str], tools: Sequence[str], options: argparse.Namespace
) -> dict[str, Any]:
    """By function, then by tool: operations by kind, or why there are none."""
    robot = load(name, warn=lambda _: None)
    folder = Path(options.work).resolve() / name
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(SEED)
    states = np.array([random.uniform(-reach, reach, (STATES, robot.n)) for reach in REACH])
    np.save(folder / "states.npy", states)
    (folder / "arm.txt").write_text(text_of(numbers_of(robot)), encoding="utf-8")
    table: dict[str, Any] = {}
    expected = {}
    toolless = set()  # functions that the others, who get the arm without its tool, cannot be asked for
    for function in functions:
        try:
            shipped, fast = (
                program(robot, function, Options((function,), optimize=level)) for level in ("record", "fast")
            )
        except NoSuchFunction as reason:
            print(f"{name} has no {function}: {reason.found}", file=sys.stderr)
            continue
        if not count(shipped).total:
            print(f"{name}: {function} has no operations to compare", file=sys.stderr)
            continue
        table[function] = {"record": count(shipped).to_dict(), "fast": count(fast).to_dict()}
        expected[function] = values_of(shipped, states)
        bare = values_of(program(replace(robot, tool=None), function, Options((function,))), states)
        if not np.allclose(bare, expected[function]):
            toolless.add(function)
    for tool in tools:
        if tool == "pinocchio":
            traced(folder, [name + ending for name in table for ending in ("", "_world")])
        for function in toolless:
            table[function][tool] = {"why": "the arm is handed over without its tool"}
        comparable = [function for function in table if function not in toolless]
        for answers in answers_of(tool, folder, comparable, options.seconds):
            table[answers.function][tool] = _fewest(tool, answers, expected[answers.function])
    return table


def traced(folder: Path, functions: Iterable[str]) -> None:
    """Have Pinocchio's algorithms traced into ``folder``; without them the tool has no answers."""
    try:
        pinocchio_traced(folder, functions, folder.parent)
    except Lacking as lacking:
        print(lacking, file=sys.stderr)


def _fewest(tool: str, answers: Answers, expected: NDArray[np.float64]) -> dict[str, Any]:
    """Of the ways that give our values the one with the fewest operations."""
    best: dict[str, Any] | None = None
    why = answers.why or "there is no such algorithm"
    for operations, values in answers.ways:
        try:
            hold_against(tool, expected, np.array(values))
        except Disagreement as error:
            why = f"refused: {error}"
            print(f"{tool}, {answers.function}: {error}", file=sys.stderr)
            continue
        if best is None or operations["total"] < best["total"]:
            best = operations
    return best or {"why": why}


if __name__ == "__main__":
    sys.exit(main())
