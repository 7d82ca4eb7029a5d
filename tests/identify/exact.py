"""Logs without surprises: a smooth motion, torques of a model's own equations, noise if wanted."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot.model import Robot

Floats = NDArray[np.float64]


def motion(n: int, *, seconds: float = 12.0, rate: float = 200.0, seed: int = 1) -> tuple[Floats, ...]:
    """Times [K] and a sum of slow sines with its exact rates [K, n]."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(seconds * rate)) / rate
    q, qd, qdd = (np.zeros((len(t), n)) for _ in range(3))
    for j in range(n):
        for w in rng.uniform(0.8, 5.0, 6):
            a, phase = rng.uniform(0.1, 0.45), rng.uniform(0, 2 * np.pi)
            q[:, j] += a * np.sin(w * t + phase)
            qd[:, j] += a * w * np.cos(w * t + phase)
            qdd[:, j] -= a * w * w * np.sin(w * t + phase)
    return t, q, qd, qdd


def log_of(robot: Robot, *, noise: float = 0.0, seed: int = 1, seconds: float = 12.0) -> Log:
    """A log of ``robot``; ``noise`` as a share of each joint's RMS torque."""
    t, q, qd, qdd = motion(robot.n, seed=seed, seconds=seconds)
    tau = Model(robot).torque(q, qd, qdd)
    size = noise * np.sqrt(np.mean(tau**2, axis=0))
    return Log(t, q, None, None, tau + size * np.random.default_rng(seed).standard_normal(tau.shape))
