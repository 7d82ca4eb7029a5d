"""Race our kernels against their peers: ``python -m benchmarks.peers`` (``make benchmarks``).

Every runner is given the same arm and the same states, and is timed only if it gives the same torques. All
run in one process, in short blocks one after another, so that what else the machine does hits all of them;
what counts are ratios within a round. Results go to ``benchmarks/results``: peers.json, and made from it
peers.md, peers.svg and growth.svg.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.peers import every_function, from_python, growth
from benchmarks.peers.building import compiler
from benchmarks.peers.candidates import MAKERS, Candidate, Missing, peers
from benchmarks.peers.numbers_in_c import text_of
from benchmarks.peers.ours import BUILDS, batches, kernels, reference
from benchmarks.peers.pictures import growth_picture, peers_picture
from benchmarks.peers.race import Race, harness, paired, random_states
from benchmarks.peers.tables import markdown

from robodyn.bench.peers.calls import checked, raced
from robodyn.bench.peers.numbers import TOLERANCE, TOLERANCE_FLOAT, Disagreement, hold_against, numbers_of
from robodyn.robot import load

RESULTS = Path(__file__).resolve().parents[1] / "results"
REFERENCE = "robodyn-builtin"
SEVEN_JOINTS = "panda"


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, write, and return the exit code."""
    parser = _parser()
    options = parser.parse_args(arguments)
    out = Path(options.out)
    work = Path(options.work).resolve()
    work.mkdir(parents=True, exist_ok=True)
    if options.render or options.only_functions:
        if not (out / "peers.json").is_file():
            parser.error(f"{out} has no peers.json; leave out --render and --only-functions to measure")
        figures = json.loads((out / "peers.json").read_text(encoding="utf-8"))
        if options.only_functions:
            figures["functions"] = functions(options, work, harness(work))
        write(figures, out)
    else:
        for figures in measured(options, work):
            write(figures, out)
    print((out / "peers.md").read_text(encoding="utf-8"))
    return 0


def write(figures: dict[str, Any], out: Path) -> None:
    """peers.json, and what is made from it."""
    out.mkdir(parents=True, exist_ok=True)
    (out / "peers.json").write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    (out / "peers.md").write_text(markdown(figures), encoding="utf-8")
    peers_picture(figures, out / "peers.svg")
    if figures["growth"]:
        growth_picture(figures["growth"], out / "growth.svg")


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="benchmarks.peers", description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--robot", default="puma560", help="a bundled robot or a file (default: puma560)")
    parser.add_argument("--rounds", type=int, default=600, help="rounds of the race (default: 600)")
    parser.add_argument(
        "--work", default="build/peers", help="where runners are compiled (default: build/peers)"
    )
    parser.add_argument("--out", default=str(RESULTS), help="where results go (default: benchmarks/results)")
    parser.add_argument("--peers", default=",".join(MAKERS), help="which peers, with commas (default: all)")
    parser.add_argument("--no-growth", action="store_true", help="leave out the arms of 1 to 30 joints")
    parser.add_argument("--only-functions", action="store_true", help="measure the other functions alone")
    parser.add_argument("--render", action="store_true", help="measure nothing, write anew from peers.json")
    return parser


def measured(options: argparse.Namespace, work: Path) -> Iterator[dict[str, Any]]:
    """Everything, as peers.json has it: once without growth, and once with it."""
    runs = max(20, options.rounds // 4)
    race_harness = harness(work)
    keys = tuple(name for name in options.peers.split(",") if name)
    folder = work / Path(options.robot).stem
    figures, pinocchio = native(options.robot, folder, race_harness, keys, options.rounds)
    figures = {"machine": machine(), **figures, "python": python(options.robot, runs), "growth": []}
    figures["functions"] = {}
    yield figures
    figures["functions"] = functions(options, work, race_harness)
    yield figures
    if not options.no_growth:
        figures["growth"] = growth.measured(work, race_harness, pinocchio, runs, 3)
        yield figures


def functions(options: argparse.Namespace, work: Path, race_harness: Path) -> dict[str, Any]:
    """The races of every function, of the robot and of an arm of seven joints."""
    runs = max(20, options.rounds // 4)
    robots = dict.fromkeys((options.robot, SEVEN_JOINTS))
    races = [one for robot in robots for one in every_function.measured(robot, work, race_harness, runs)]
    return {"machine": machine(), "races": races}


def native(
    name: str, folder: Path, race_harness: Path, keys: tuple[str, ...], rounds: int
) -> tuple[dict[str, Any], Candidate | None]:
    """The race in C and C++; and Pinocchio's runner, which takes any arm."""
    robot = load(name, warn=lambda _: None)
    arm, states = numbers_of(robot), random_states(robot.n)
    folder.mkdir(parents=True, exist_ok=True)
    states.write(folder / "states.bin")
    (folder / "arm.txt").write_text(text_of(arm), encoding="utf-8")
    race = Race(folder, race_harness)
    print("setting up our own kernels", file=sys.stderr)
    mine = kernels(robot, folder, states, tuple(BUILDS)) + batches(robot, folder)
    theirs = list(peers(arm, folder, keys))
    missing = [one for one in theirs if isinstance(one, Missing)]
    racing, worst = [], []
    wanted = reference(robot, states)
    for one in [*mine, *(one for one in theirs if isinstance(one, Candidate))]:
        try:
            torques = race.results(one.timed, wanted.shape)
            worst.append(
                hold_against(one.title, wanted, torques, TOLERANCE_FLOAT if one.single else TOLERANCE)
            )
            racing.append(one)
        except Disagreement as error:
            if one.ours:
                raise
            missing.append(Missing(one.key, one.title, f"refused: {error}"))
    print(f"racing {len(racing)} runners", file=sys.stderr)
    times = race.times([one.timed for one in racing], rounds)
    first = [one.key for one in racing].index(REFERENCE)
    rows = []
    for k, one in enumerate(racing):
        counted = race.instructions(one.counted, len(states.q)) if one.counted else None
        rows.append(
            {
                "key": one.key,
                "title": one.title,
                "flags": one.flags,
                "ours": one.ours,
                "note": one.note,
                "worst": worst[k],
                "ns": float(np.median(times[:, k])),
                "ratio": paired(times[:, k], times[:, first]).to_list(),
                "instructions": counted,
            }
        )
    index = {one.key: k for k, one in enumerate(racing)}
    table = {
        "robot": robot.name,
        "states": len(states.q),
        "rounds": rounds,
        "rows": rows,
        "missing": [{"title": one.title, "why": one.why} for one in missing],
        "demands": demands(times, index),
    }
    pinocchio = next((one for one in racing if one.key == "pinocchio"), None)
    return {"native": table}, pinocchio


#: What is asked for: peer, ours, how many times faster; also of our kernel in these other builds.
_OTHER_BUILDS = ("", "-scheduled", "-v3", "-portable")
DEMANDS = (
    ("pinocchio", "robodyn-builtin", 18.0),
    ("pinocchio-checked", "robodyn-builtin", 18.0),
    ("pinocchio_casadi", "robodyn-builtin", 3.0),
    ("symforce", "robodyn-builtin", 2.5),
    ("pinocchio", "batch-builtin-double-64", 70.0),
)


def demands(times: Any, index: dict[str, int]) -> list[dict[str, Any]]:
    """Each ratio that is asked for, measured, also with our kernels as built for any x86-64-v3."""
    ratios = []
    for peer, mine, wanted in DEMANDS:
        for key in (mine + build for build in _OTHER_BUILDS):
            if peer in index and key in index:
                ratio = paired(times[:, index[peer]], times[:, index[key]])
                ratios.append({"peer": peer, "ours": key, "wanted": wanted, "ratio": ratio.to_list()})
    return ratios


def python(name: str, rounds: int) -> dict[str, Any]:
    """The race from Python."""
    robot = load(name, warn=lambda _: None)
    states = random_states(robot.n)
    wanted = reference(robot, states)
    calls, missing = from_python.calls(robot, (states.q, states.qd, states.qdd))
    racing = []
    for call in calls:
        try:
            checked(call, wanted)
            racing.append(call)
        except Disagreement as error:
            missing.append(Missing(call.key, call.title, f"refused: {error}"))
    print(f"racing {len(racing)} calls from Python", file=sys.stderr)
    times = raced(racing, rounds)
    rows = [
        {
            "key": call.key,
            "title": call.title,
            "ns": float(np.median(times[:, k])),
            "ratio": paired(times[:, k], times[:, 0]).to_list(),
        }
        for k, call in enumerate(racing)
    ]
    index = {call.key: k for k, call in enumerate(racing)}
    goals = [("workspace", 5.0), ("batch-F", 50.0), ("batch-C", 50.0)]
    met = [
        {
            "peer": "pin.rnea",
            "ours": key,
            "wanted": wanted_ratio,
            "ratio": paired(times[:, index["pin.rnea"]], times[:, index[key]]).to_list(),
        }
        for key, wanted_ratio in goals
        if "pin.rnea" in index and key in index
    ]
    absent = [{"title": one.title, "why": one.why} for one in missing]
    return {"rounds": rounds, "rows": rows, "missing": absent, "demands": met}


def machine() -> dict[str, Any]:
    """What this was measured on."""
    model = platform.processor() or platform.machine()
    info = Path("/proc/cpuinfo")
    if info.is_file():
        lines = [x for x in info.read_text().splitlines() if x.startswith("model name")]
        model = lines[0].partition(":")[2].strip() if lines else model
    return {
        "processor": model,
        "cores": os.cpu_count(),
        "compiler": compiler("c")[1],
        "python": platform.python_version(),
        "load": round(os.getloadavg()[0], 1),
    }


if __name__ == "__main__":
    sys.exit(main())
