"""A gas spring is named where a spring relieves a joint of gravity; numbers of bristles that bend."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.result import Finding
from robodyn.diagnose.run import diagnose
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.reader import read_text


def named(effect: str, seed: int) -> tuple[Finding, Amendment]:
    """The claim at joint 2, in the place of what is hidden there."""
    robot = load("puma560_3dof", warn=lambda _: None)
    blind = hide(robot, [Amendment(effect, 2, {})], setup=Setup(seed=seed))
    (one,) = (f for f in diagnose(blind.model, [blind.train]).findings if f.confidence >= 0.5)
    assert one.joint == 2
    return one, blind.effects[0]


@pytest.mark.parametrize("seed", [3, pytest.param(5, marks=pytest.mark.slow)])
@pytest.mark.thorough
def test_a_gas_spring_is_named_with_its_torque(seed: int) -> None:
    found, hidden = named("gas_spring", seed)
    assert found.effect == "gas_spring"
    for name in ("torque", "dead_center", "ratio"):
        # Of its curve too: torque and rise fit alike with another ratio, which an error by itself leaves out.
        one, true = found.parameters[name], float(hidden.parameters[name])
        assert one.stderr is not None
        low, high = one.bounds or (float(one.value) - 2 * one.stderr, float(one.value) + 2 * one.stderr)
        assert (low or -np.inf) <= true <= (high or np.inf)


@pytest.mark.thorough
def test_a_spring_that_is_no_counterbalance_stays_a_spring() -> None:
    assert named("spring", 1)[0].effect == "spring"


# --- friction that bends before it slides, integrated step by step ------------------------------------------


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
