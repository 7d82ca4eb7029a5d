"""How time and size grow from 1 to 30 joints, on a family of arms made by rule."""

from __future__ import annotations

import resource
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.peers.building import Lacking
from benchmarks.peers.candidates import Candidate
from benchmarks.peers.family import family_text
from benchmarks.peers.numbers_in_c import text_of
from benchmarks.peers.ours import kernels, reference
from benchmarks.peers.race import Race, random_states

from robodyn.bench.peers.numbers import hold_against, numbers_of
from robodyn.counts import count
from robodyn.kernels.generate import Options, program
from robodyn.robot import load

JOINTS = (1, 2, 3, 4, 6, 8, 10, 12, 15, 18, 21, 24, 27, 30)


def measured(
    work: Path, harness: Path, pinocchio_at: Candidate | None, rounds: int, runs: int
) -> list[dict[str, Any]]:
    """A row for every number of joints: operations, generation time, and a call's time and instructions of
    ours and of Pinocchio."""
    return [_row(n, work / f"serial{n}", harness, pinocchio_at, rounds, runs) for n in JOINTS]


def _row(
    n: int, folder: Path, harness: Path, theirs: Candidate | None, rounds: int, runs: int
) -> dict[str, Any]:
    print(f"{n} joints", file=sys.stderr)
    folder.mkdir(parents=True, exist_ok=True)
    description = folder / f"serial{n}.yaml"
    description.write_text(family_text(n), encoding="utf-8")
    robot = load(str(description), warn=lambda _: None)
    arm, states = numbers_of(robot), random_states(n, 64)
    states.write(folder / "states.bin")
    (folder / "arm.txt").write_text(text_of(arm), encoding="utf-8")
    race = Race(folder, harness)
    racing = kernels(robot, folder, states, ("native",), "fast")
    if theirs is not None:
        racing.append(theirs)
    wanted = reference(robot, states)
    for one in racing:
        hold_against(f"{one.title}, {n} joints", wanted, race.results(one.timed, wanted.shape))
    times = np.median(race.times([one.timed for one in racing], rounds), axis=0)
    operations = count(program(robot, "inverse_dynamics", Options(optimize="fast")))
    instructions = {one.key: race.instructions(one.counted, 64) for one in racing if one.counted}
    return {
        "joints": n,
        "operations": operations.total,
        "generation_s": generation_seconds(description, folder, runs),
        "ns": {one.key: float(t) for one, t in zip(racing, times, strict=True)},
        "instructions": instructions,
    }


def generation_seconds(description: Path, folder: Path, runs: int) -> dict[str, float]:
    """CPU seconds of ``robodyn gen`` of the inverse dynamics, the whole process, the least of ``runs``; and
    what starting takes of it."""
    command = [sys.executable, "-m", "robodyn_cli", "gen", str(description), "--optimize", "fast"]
    command += ["--functions", "inverse_dynamics", "--lang", "c", "-o", str(folder / "generated")]
    whole = []
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode:
            raise Lacking(f"robodyn gen fails: {done.stderr}")
        whole.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return {"process": min(whole), "start": _start(runs)}


_STARTED: list[float] = []


def _start(runs: int) -> float:
    """The same for the shortest command, ``robodyn --help``: what starting costs."""
    if not _STARTED:
        for _ in range(runs):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([sys.executable, "-m", "robodyn_cli", "--help"], capture_output=True, check=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            _STARTED.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
    return min(_STARTED)
