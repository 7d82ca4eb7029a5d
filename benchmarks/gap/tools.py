"""Everybody who explains real logs: from the fitted samples of an arm to what is left of all of them."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.gap.recordings import Floats, Motion
from benchmarks.gap.robots import RealArm
from benchmarks.gap.score import residual
from benchmarks.gap.split import split

from robodyn.robot import load

#: From this confidence on a finding is a claim.
CLAIM = 0.5


@dataclass(frozen=True, slots=True)
class Answer:
    """Residuals [K, n] of each log; CPU time [s] and peak memory [MB]; what else a tool says."""

    residuals: tuple[Floats, ...]
    cpu: float
    memory: float | None = None
    notes: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Tool:
    """A tool by its ``key`` and ``title``; ``ours``: it is part of robodyn."""

    key: str
    title: str
    run: Callable[[RealArm, Sequence[Motion], Path], Answer]
    ours: bool = False


def _inside(fit: Callable[[RealArm, Sequence[Motion]], Sequence[Floats]]) -> Any:
    """A tool that runs in this process, on filtered samples."""

    def run(arm: RealArm, motions: Sequence[Motion], folder: Path) -> Answer:
        start = time.process_time()
        residuals = tuple(fit(arm, motions))
        return Answer(residuals, time.process_time() - start)

    return run


def _before(arm: RealArm, motions: Sequence[Motion]) -> Sequence[Floats]:
    robot = arm.robot()
    return [residual(robot, m) for m in motions]


def _least_squares(arm: RealArm, motions: Sequence[Motion]) -> Sequence[Floats]:
    from benchmarks.gap.least_squares import fit

    return fit(arm.robot(), motions, smooth=True).residuals


def _sysid(arm: RealArm, motions: Sequence[Motion]) -> Sequence[Floats]:
    from benchmarks.gap.mujoco_sysid import fit

    return fit(arm.robot(), motions)


def _sparse(arm: RealArm, motions: Sequence[Motion]) -> Sequence[Floats]:
    from benchmarks.gap.sparse import fit

    return fit(arm.robot(), motions)


def _command(name: str, model: str) -> Any:
    """A command of robodyn, which gets the fitted samples as logs with gaps and writes a ``model``."""

    def run(arm: RealArm, motions: Sequence[Motion], folder: Path) -> Answer:
        pieces = [split(path, folder / "pieces", arm.raster)[0] for path in arm.paths()]
        out = folder / name
        described = arm.folder / arm.description
        words = [sys.executable, "-m", "robodyn", name, described, *pieces, "-o", out]
        cpu, memory = measured([*map(str, words), *(["--no-kernels"] if name == "diagnose" else [])])
        amended = load(str(out / model), warn=lambda _: None)
        notes = _claims(out / "diagnosis.json") if name == "diagnose" else {}
        result = {"identify": "identify.json", "diagnose": "diagnosis.json"}[name]
        rest = np.array(json.loads((out / result).read_text(encoding="utf-8"))["rest"])
        return Answer(tuple(residual(amended, m, rest) for m in motions), cpu, memory, notes)

    return run


#: Runs a command and writes its usage; a process of its own, for a child's peak memory counts from the memory
#: of who started it.
_LAUNCHER = """
import resource, subprocess, sys
done = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(done.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)
"""


def measured(words: Sequence[str]) -> tuple[float, float]:
    """CPU time [s] and peak memory [MB] of a command, its children's included.

    Raises
    ------
    RuntimeError: it fails; an ``unexplained`` residual (exit code 4) is no failure.
    """
    done = subprocess.run(
        [sys.executable, "-c", _LAUNCHER, *words], capture_output=True, text=True, check=True
    )
    code, cpu, memory = done.stdout.split()
    if code not in ("0", "4"):
        messages = done.stderr.strip().splitlines()
        raise RuntimeError(f"exit code {code}: {messages[-1] if messages else ''}")
    return float(cpu), float(memory)


def _claims(path: Path) -> dict[str, Any]:
    diagnosis = json.loads(path.read_text(encoding="utf-8"))
    claims = [f for f in diagnosis["findings"] if f["confidence"] >= CLAIM]
    names = [[f["effect"], f["joint"]] for f in claims]
    return {"verdict": diagnosis["verdict"], "claims": names, "kinds": len({name for name, _ in names})}


TOOLS = (
    Tool("before", "the description as it is", _inside(_before)),
    Tool("least_squares", "plain least squares", _inside(_least_squares)),
    Tool("mujoco_sysid", "`mujoco.sysid`", _inside(_sysid)),
    Tool("sparse", "sparse regression (PySINDy)", _inside(_sparse)),
    Tool("identify", "`robodyn identify`", _command("identify", "identified.yaml"), ours=True),
    Tool("diagnose", "`robodyn diagnose`", _command("diagnose", "model.yaml"), ours=True),
)
