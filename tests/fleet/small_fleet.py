"""A fleet of a two-link arm whose logs are files: small enough to be digested in a test."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robodyn.diagnose.result import Diagnosis
from robodyn.fleet.sources.fleet import ArmType, Fleet, LogFile
from robodyn.formats.loading import load, text_of
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot.model import Robot

NAME = "stanford_3dof"
DAY = 86400.0
Floats = NDArray[np.float64]


def motion(
    drawn: np.random.Generator,
    t: Floats,
    n: int,
    speeds: tuple[float, float] = (0.8, 2.5),
    sizes: tuple[float, float] = (0.05, 0.25),
    pace: float = 1.0,
) -> tuple[Floats, Floats, Floats]:
    """Positions, velocities and accelerations [K, n] of joints that swing with three frequencies each."""
    phase, speed, size = (drawn.uniform(*bounds, (3, n)) for bounds in ((0.0, 6.0), speeds, sizes))
    speed = speed * pace
    angle = speed[:, None] * t[None, :, None] + phase[:, None]
    q = (size[:, None] * np.sin(angle)).sum(axis=0)
    qd = ((size * speed)[:, None] * np.cos(angle)).sum(axis=0)
    return q, qd, -((size * speed**2)[:, None] * np.sin(angle)).sum(axis=0)


def write_log(path: Path, seed: int, friction: float = 5.0, seconds: float = 6.0, began: float = 0.0) -> None:
    """A log of a motion of its own, with viscous ``friction`` and noise, that ``began`` then [s]."""
    rng = np.random.default_rng(seed)
    robot = load(NAME)
    t = np.arange(int(seconds * 100)) / 100
    q, qd, qdd = motion(rng, t, 3)
    q[:, 2] += 0.8
    tau = Model(robot).torque(q, qd, qdd) + friction * qd
    log = Log(t + began, q, None, None, tau + 0.05 * rng.standard_normal(tau.shape))
    path.write_text(log.csv(), encoding="utf-8")


def small_fleet(folder: Path, units: int = 3, logs: int = 2, seconds: float = 6.0) -> Fleet:
    """Its logs, written into ``folder``."""
    folder.mkdir(exist_ok=True)
    files = []
    for unit in range(units):
        for k in range(logs):
            path = folder / f"{unit}-{k}.csv"
            write_log(path, 100 * unit + k, seconds=seconds)
            files.append(LogFile(str(path), NAME, f"unit {unit}", k * 30 * DAY, {}))
    return Fleet("small", {NAME: ArmType(NAME, NAME, text_of(NAME))}, tuple(files))


def quick_diagnosis(robot: Robot, logs: Sequence[Log], **_: object) -> Any:
    """In the place of a diagnosis, which takes seconds: one that only the torques of its logs make."""
    return SimpleNamespace(findings=[], verdict=f"torques of {sum(log.tau.sum() for log in logs)}", logs=logs)


def files_of(diagnosis: Diagnosis) -> Mapping[str, str]:
    """A page of few words."""
    return {"report.html": f"<p>{diagnosis.verdict}</p>", "diagnosis.json": str(len(diagnosis.logs))}
