"""Numbers of friction that bends before it slides, on a turntable with bristles integrated step by step."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.diagnose.run import diagnose
from robodyn.logs.log import Log
from robodyn.robot.reader import read_text

LEVEL, STIFFNESS, DAMPING, INERTIA, NOISE = 2.0, 150.0, 1.8, 0.5, 0.02


TURNTABLE = f"""
name: turntable
confidence: 0.01
links:
  - joint: revolute
    inertia: {{zz: {INERTIA}}}
"""


def log() -> Log:
    t = np.arange(8000) / 1000.0
    waves = ((0.30, 2.3, 0.0), (0.12, 7.1, 0.5), (0.05, 15.0, 1.5))
    q = sum(a * np.sin(w * t + p) for a, w, p in waves)
    qd = sum(a * w * np.cos(w * t + p) for a, w, p in waves)
    qdd = -sum(a * w**2 * np.sin(w * t + p) for a, w, p in waves)
    z, tau, fine = 0.0, np.empty(len(t)), 20
    for k, v in enumerate(qd.tolist()):
        for _ in range(fine):
            rate = v - STIFFNESS * abs(v) / LEVEL * z
            z += rate * 1e-3 / fine
        tau[k] = STIFFNESS * z + DAMPING * rate
    tau += INERTIA * qdd + NOISE * np.random.default_rng(1).standard_normal(len(t))
    return Log(t, q[:, None], None, None, tau[:, None])


@pytest.mark.thorough
def test_stiffness_and_damping_are_within_their_intervals() -> None:
    outcome = diagnose(read_text(TURNTABLE, warn=lambda _: None), [log()])
    (finding,) = outcome.findings
    assert finding.effect == "presliding_hysteresis"
    for name, true in (("level", LEVEL), ("stiffness", STIFFNESS), ("damping", DAMPING)):
        interval = finding.parameters[name].interval
        assert interval is not None
        low, high = interval
        assert low is not None
        assert high is not None
        assert 0.98 * low < true < 1.02 * high
        assert high - low < 0.5 * true
