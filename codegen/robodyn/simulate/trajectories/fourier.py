"""Periodic motions that excite all joints, inside their limits at every moment."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from robodyn.arrays import Floats
from robodyn.errors import InputError
from robodyn.robot.model import Robot
from robodyn.simulate.trajectories.trajectory import PERIOD, Trajectory, sample_times

_PER_HARMONIC = 256  # points of the grid on which extremes are sought, a period of the highest harmonic
_SHARE = 0.98


def fourier(
    robot: Robot,
    frequency: float = 0.1,
    harmonics: int = 5,
    seed: int = 0,
    *,
    periods: int = 1,
    share: float = _SHARE,
    period: float = PERIOD,
) -> Trajectory:
    """A sum of ``harmonics`` of the base ``frequency`` [Hz] in every joint, for ``periods`` periods.

    At rest, without acceleration, at the beginning and at the end of every period. The amplitudes are random,
    the same for the same ``seed``, and each joint's are scaled until one of its limits of position, velocity
    or acceleration is used up to the ``share``, at every time and not at the samples only: with extremes
    M on a grid of N points a period, a sum of K harmonics stays below ``M / cos(pi K / N)`` (M. Riesz 1914).
    The range of a joint has its middle in that of its limits.

    Raises
    ------
    InputError: a limit is missing; fewer than two harmonics; numbers that are no frequency or share.
    """
    if not 2 <= harmonics <= 1000 or periods < 1:
        raise InputError(
            "such a sum cannot start and end at rest",
            found=f"{harmonics} harmonics, {periods} periods",
            expected="2 to 1000 harmonics, 1 period or more",
        )
    if not (0 < frequency < math.inf and 0 < share <= 1):
        raise InputError(
            "no frequency or no share",
            found=f"{frequency!r} Hz, {share!r}",
            expected="a positive frequency, a share in 0 .. 1",
        )
    low, high, velocity, acceleration = _limits(robot)
    middle, room = (low + high) / 2, (high - low) / 2
    base = 2 * math.pi * frequency
    sines, cosines = _drawn(harmonics, robot.n, seed)
    N = _PER_HARMONIC * harmonics
    grid = np.arange(N) / (N * frequency)
    q, qd, qdd = _law(base, np.zeros(robot.n), sines, cosines, grid)
    beyond = 1 / math.cos(math.pi * harmonics / N)
    lowest, highest = q.min(axis=0), q.max(axis=0)
    used = beyond * np.array(
        [
            (highest - lowest) / 2 / room,
            np.abs(qd).max(axis=0) / velocity,
            np.abs(qdd).max(axis=0) / acceleration,
        ]
    )
    scale = share / used.max(axis=0)
    mean = middle - scale * (lowest + highest) / 2
    law = partial(_law, base, mean, sines * scale, cosines * scale)
    t = sample_times(periods / frequency, period, beyond=False)
    provenance: dict[str, Any] = {
        "kind": "fourier",
        "frequency": float(frequency),
        "harmonics": harmonics,
        "periods": periods,
        "seed": seed,
        "share": float(share),
        "mean": mean.tolist(),
        "sines": (sines * scale).T.tolist(),
        "cosines": (cosines * scale).T.tolist(),
    }
    return Trajectory(t, *law(t), provenance, law)


def _law(
    base: float, mean: Floats, sines: Floats, cosines: Floats, t: Floats
) -> tuple[Floats, Floats, Floats]:
    """``mean + sum of sines_k sin(k base t) + cosines_k cos(k base t)`` and its rates [K, n]."""
    w = base * np.arange(1, len(sines) + 1)
    angles = t[:, None] * w
    s, c = np.sin(angles), np.cos(angles)
    velocity = c @ (sines * w[:, None]) - s @ (cosines * w[:, None])
    acceleration = -(s @ (sines * w[:, None] ** 2) + c @ (cosines * w[:, None] ** 2))
    return mean + s @ sines + c @ cosines, velocity, acceleration


def _drawn(harmonics: int, n: int, seed: int) -> tuple[Floats, Floats]:
    """Random amplitudes [K, n] of sines and cosines, falling as 1 / k, of curves at rest at time 0."""
    rng = np.random.default_rng(seed)
    k = np.arange(1.0, harmonics + 1)
    sines, cosines = rng.standard_normal((2, n, harmonics)) / k
    sines = sines - np.outer(sines @ k, k) / (k @ k)  # sum of k a_k = 0: no velocity
    cosines = cosines - np.outer(cosines @ k**2, k**2) / (k**2 @ k**2)  # sum of k^2 b_k = 0: no acceleration
    return sines.T, cosines.T


def _limits(robot: Robot) -> Floats:
    """Lowest and highest positions, velocities and accelerations of all joints [4, n]."""
    rows = []
    for i, link in enumerate(robot.links, 1):
        own = link.joint.limits
        stated = {"position": own.position, "velocity": own.velocity, "acceleration": own.acceleration}
        missing = [name for name, value in stated.items() if value is None]
        if own.position is None or own.velocity is None or own.acceleration is None:
            raise InputError(
                f"{robot.name}: link {i} states no limit of {', '.join(missing)}",
                remedy="add limits: {position: [-pi, pi], velocity: 2, acceleration: 10} to the link",
            )
        rows.append([float(x) for x in (*own.position, own.velocity, own.acceleration)])
        if not (own.velocity > 0 and own.acceleration > 0):
            expected = "positive velocity and acceleration"
            raise InputError(f"{robot.name}: link {i} has a limit of 0", expected=expected)
    return np.array(rows).T
