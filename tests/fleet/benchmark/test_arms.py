"""Arms of a simulated fleet: run-time parameters are the numbers they stand for; changes, what they say."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.fleet.arm import Day, loaded, with_numbers
from benchmarks.fleet.changes import Change, changed
from benchmarks.fleet.limits import LEAST_LEVEL
from benchmarks.fleet.programs import draw_program
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.types import TrueType, draw_type

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.effects.rigid import PAYLOAD
from robodyn.effects.springs import BACKLASH
from robodyn.kernels.array_dynamics import Model
from robodyn.robot import load
from robodyn.simulate.simulation import Follow, simulate


@pytest.fixture(scope="module")
def true() -> TrueType:
    return draw_type(load("puma560_3dof"), Recipe(), np.random.default_rng(4))


def test_run_time_parameters_are_the_numbers(true: TrueType) -> None:
    """A load, friction, inertial numbers: the same log from an arm compiled with them as constants."""
    numbers = loaded(true.numbers, 1.5, np.array([0.1, -0.05, 0.2]))
    rng = np.random.default_rng(1)
    motion = draw_program(true.robot, rng).motion(2.0, 1.0, rng)
    arm = true.arm(Day(true.numbers))
    log = arm.log(motion, numbers, 250.0)
    payload = Amendment(PAYLOAD.id, None, {"mass": 1.5, "com_x": 0.1, "com_y": -0.05, "com_z": 0.2})
    constant = amended(with_numbers(true.robot, true.numbers), [payload])
    follow = Follow(motion, "pd", arm.kp, arm.kd, model=with_numbers(true.robot, true.numbers))
    run = simulate(constant, follow, sample_period=1 / 250, step=1e-3)
    np.testing.assert_allclose(log.q, run.q, rtol=0, atol=1e-9)
    np.testing.assert_allclose(log.tau, run.command, rtol=0, atol=1e-6)
    torque = Model(constant).torque(run.q, run.qd, run.qdd)
    moving = (np.abs(run.qd) > 1e-3).all(axis=1)
    assert moving.sum() > 100
    np.testing.assert_allclose(log.tau[moving], torque[moving], rtol=0, atol=1e-6)


def _play(true: TrueType, level: float) -> Day:
    change = Change("play", (BACKLASH.id,), 2, 0.0, 10.0, 0.01, {})
    return changed(change, level, true, true.numbers)


def test_play_grows_from_nothing(true: TrueType) -> None:
    assert _play(true, 0.0).coupler is None
    gaps = {level: _play(true, level).values["planted_gap"] for level in (1e-6, 0.5, 1.0)}
    assert gaps == pytest.approx({1e-6: LEAST_LEVEL * 0.01, 0.5: 0.005, 1.0: 0.01})
    assert _play(true, 0.5).coupler == _play(true, 1.0).coupler  # compiled once
