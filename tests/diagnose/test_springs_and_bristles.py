"""A gas spring is named where a spring relieves a joint of gravity; numbers of bristles that bend."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.blind.hide import Setup, hide
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.fit import problem
from robodyn.diagnose.select.library.candidate import Candidate
from robodyn.diagnose.select.limits import LEAST_SHAPE
from robodyn.diagnose.select.refine import Freed
from robodyn.diagnose.select.search import estimates
from robodyn.diagnose.select.selection import select
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.reader import read_text


def first_name(effect: str, seed: int) -> tuple[Candidate, dict[str, float | str], Amendment]:
    robot = load("puma560_3dof", warn=lambda _: None)
    blind = hide(robot, [Amendment(effect, 2, {})], setup=Setup(seed=seed))
    one = select(blind.model, blind.train).findings[0]
    return one.trial.candidate, one.trial.candidate.read(one.x), blind.effects[0]


@pytest.mark.parametrize("seed", [3, pytest.param(5, marks=pytest.mark.slow)])
@pytest.mark.thorough
def test_a_gas_spring_is_named_with_its_torque(seed: int) -> None:
    candidate, estimate, hidden = first_name("gas_spring", seed)
    assert (candidate.effect, candidate.joint) == ("gas_spring", 2)
    assert float(estimate["torque"]) == pytest.approx(float(hidden.parameters["torque"]), rel=0.15)
    assert float(estimate["dead_center"]) == pytest.approx(float(hidden.parameters["dead_center"]), abs=0.12)


@pytest.mark.thorough
def test_a_spring_that_is_no_counterbalance_stays_a_spring() -> None:
    assert first_name("spring", 1)[0].effect == "spring"


@pytest.mark.thorough
def test_a_weak_gas_spring_is_a_rival_of_what_explains_as_much() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    weak = {"torque": 3.0, "rise": 0.3, "dead_center": 0.68, "ratio": 0.28}
    blind = hide(robot, [Amendment("gas_spring", 2, weak)], setup=Setup(seed=3, rate=250.0))
    one = select(blind.model, blind.train).findings[0]
    assert one.trial.candidate.effect != "gas_spring"
    assert "gas_spring" in one.rivals


def test_what_shapes_its_curve_is_free_in_the_last_fit_only() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    spring = Amendment("gas_spring", 2, {"torque": 30.0, "rise": 0.0, "dead_center": 0.6, "ratio": 0.25})
    start = problem(np.zeros((100, 3)), np.ones((100, 3, 1)), np.ones(3), 1.0)
    sought, last = (Freed.of(robot, [spring], [], start, by_drives=which) for which in (False, True))
    assert [name for _, name in sought.places] == ["torque", "dead_center"]
    assert dict(zip([name for _, name in last.places], last.x, strict=True)) == {
        **spring.parameters, "rise": LEAST_SHAPE,
    }  # fmt: skip


@pytest.mark.thorough
def test_errors_follow_what_coefficients_do_together() -> None:
    """Two coefficients that are known by their sum alone: its error is small, and that of each is not."""
    robot = load("puma560_3dof", warn=lambda _: None)
    blind = hide(robot, [Amendment("gas_spring", 2, {})], setup=Setup(seed=3, rate=250.0))
    selection = select(blind.model, blind.train)
    candidate = selection.findings[0].trial.candidate
    x, way = np.array([5.0, 6.0]), np.array([[0.01, 1.0], [0.01, -1.0]])
    values, errors = estimates(candidate, x, way, selection.context.model)
    assert values["torque"] == pytest.approx(11.0)
    assert errors["torque"] == pytest.approx(0.02)
    assert errors["rise"] > 0.05


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
