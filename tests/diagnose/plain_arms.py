"""Arms of one or two joints whose torques are a line of numpy, and logs of them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from robodyn.logs.log import Log
from robodyn.robot import Robot, read_text

Floats = NDArray[np.float64]
#: What an arm lacks: torques or forces [K, n] by q, qd, qdd [K, n].
Lacks = Callable[[Floats, Floats, Floats], Floats]

INERTIA, MASS, ARM, G = 0.5, 3.0, 0.4, 9.81
TURNTABLE = f"""\
name: turntable
links:
  - {{joint: revolute, mass: 2, inertia: {{zz: {INERTIA}}}}}
"""
SLIDE = f"""\
name: slide
gravity: [0, 0, 0]
links:
  - {{joint: prismatic, mass: {MASS}}}
"""
PENDULUM = f"""\
name: pendulum
gravity: [0, -{G}, 0]
links:
  - {{joint: revolute, mass: {MASS}, com: [{ARM}, 0, 0], inertia: {{zz: {INERTIA}}}}}
"""
WEIGHTLESS = f"""\
name: weightless
gravity: [0, 0, 0]
links:
  - {{joint: revolute, mass: 2, inertia: {{zz: {INERTIA}}}}}
  - {{joint: prismatic, mass: {MASS}}}
"""


def read(text: str) -> Robot:
    return read_text(text, warn=lambda _: None)


def rigid(name: str, q: Floats, qdd: Floats) -> Floats:
    """Torques or forces [K, n] of the arm, by hand."""
    if name == "turntable":
        return INERTIA * qdd
    if name == "slide":
        return MASS * qdd
    if name == "pendulum":
        return (INERTIA + MASS * ARM**2) * qdd + MASS * G * ARM * np.cos(q)
    return np.array([INERTIA, MASS]) * qdd  # the slide is along the axis that the table turns about


def logged(
    robot: Robot,
    lacks: Lacks | None = None,
    *,
    seed: int = 1,
    noise: float = 0.05,
    seconds: float = 10.0,
    rate: float = 250.0,
) -> Log:
    """A log of a sum of sines, with what the arm ``lacks`` and white ``noise`` [N m or N]."""
    rng = np.random.default_rng(seed)
    t = np.arange(round(seconds * rate)) / rate
    q, qd, qdd = (np.zeros((len(t), robot.n)) for _ in range(3))
    for j in range(robot.n):
        for w in 2 * np.pi * rng.uniform(0.2, 1.0, 4):
            a, phase = rng.uniform(0.1, 0.4), rng.uniform(0, 2 * np.pi)
            q[:, j] += a * np.sin(w * t + phase)
            qd[:, j] += a * w * np.cos(w * t + phase)
            qdd[:, j] -= a * w**2 * np.sin(w * t + phase)
    tau = rigid(robot.name, q, qdd) + noise * rng.standard_normal(q.shape)
    if lacks is not None:
        tau = tau + lacks(q, qd, qdd)
    return Log(t, q + 1e-6 * rng.standard_normal(q.shape), None, None, tau)
