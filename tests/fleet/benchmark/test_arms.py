"""Arms of a simulated fleet: run-time parameters are the numbers they stand for; changes, what they say."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.fleet.arm import Day, loaded, numbers_of, with_numbers, with_parameters
from benchmarks.fleet.changes import FRICTION, Change, changed, draw_effect, when, window
from benchmarks.fleet.limits import DAY, LEAST_LEVEL
from benchmarks.fleet.programs import draw_program
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.types import TrueType, draw_type
from benchmarks.fleet.units import draw_unit, log_of_day

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.effects.friction import COULOMB, VISCOUS
from robodyn.effects.rigid import PAYLOAD
from robodyn.effects.sensors import GAIN
from robodyn.effects.springs import BACKLASH
from robodyn.errors import InputError
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


def test_numbers_go_into_a_robot_and_out_again(true: TrueType) -> None:
    again = numbers_of(with_numbers(true.robot, true.numbers))
    assert again.by_name() == true.numbers.by_name()
    with pytest.raises(InputError, match="run-time parameters"):
        numbers_of(with_parameters(true.robot))


def _play(true: TrueType, level: float) -> Day:
    change = Change("play", (BACKLASH.id,), 2, 0.0, 10.0, 0.01, {})
    return changed(change, level, true, true.numbers)


def test_play_grows_from_nothing(true: TrueType) -> None:
    assert _play(true, 0.0).coupler is None
    gaps = {level: _play(true, level).values["planted_gap"] for level in (1e-6, 0.5, 1.0)}
    assert gaps == pytest.approx({1e-6: LEAST_LEVEL * 0.01, 0.5: 0.005, 1.0: 0.01})
    assert _play(true, 0.5).coupler == _play(true, 1.0).coupler  # compiled once


def test_friction_of_one_joint_changes_by_a_share(true: TrueType) -> None:
    change = Change(FRICTION, (VISCOUS.id,), 2, 100.0, 100.0, 0.4, {})
    numbers = changed(change, change.level(150.0), true, true.numbers).numbers
    assert numbers.viscous == pytest.approx(true.numbers.viscous * [1, 1.2, 1])
    assert numbers.coulomb == pytest.approx(true.numbers.coulomb)
    both = replace(change, effects=(COULOMB.id, VISCOUS.id))
    assert changed(both, 1.0, true, true.numbers).numbers.coulomb[1] == 1.4 * true.numbers.coulomb[1]


@pytest.mark.parametrize(
    ("begin", "growth", "shape", "levels"),
    [(None, 0.0, "always", (1, 1)), (10.0, 0.0, "step", (0, 1)), (10.0, 20.0, "drift", (0, 0.5))],
)
def test_shapes(begin: float | None, growth: float, shape: str, levels: tuple[float, float]) -> None:
    change = Change("", (), None, begin, growth, 1.0, {})
    assert change.shape == shape
    assert (change.level(9.0), change.level(20.0)) == levels


def test_changes_leave_two_logs_before_and_two_after() -> None:
    dates = np.array([0.0, 20, 30, 100, 150, 160]) * DAY
    assert window(dates, 140 * DAY) is None
    rng = np.random.default_rng(0)
    for _ in range(200):
        begin, growth = when(dates, (30 * DAY, 200 * DAY), rng)
        assert begin >= 20 * DAY
        assert begin + growth <= 150 * DAY
        assert 30 * DAY <= growth <= 200 * DAY


def test_an_effect_shows_as_much_as_it_should(true: TrueType) -> None:
    rng = np.random.default_rng(3)
    program = draw_program(true.robot, rng)
    change = draw_effect(
        GAIN.id, "gain", true, true.numbers, program, (5.0, 5.0), (None, 0.0), rng, None
    )  # fmt: skip
    assert change.joint is not None
    size = true.usual.tau[change.joint - 1] * abs(change.size) / true.noise[change.joint - 1]
    assert 2 < size < 12  # on another motion of the same arm
    with pytest.raises(InputError, match="at no joint"):
        draw_effect(GAIN.id, "", true, true.numbers, program, (1e9, 1e9), (None, 0.0), rng, None)


def test_a_log_is_as_a_controller_records_it(true: TrueType) -> None:
    recipe = Recipe(duration=(3.0, 3.0), short=0.0, slow=0.0, noise=0.02)
    unit = draw_unit(None, true, recipe, seed=5)
    log = log_of_day(unit, 0, true, recipe)
    assert log.qd is None
    steps = log.q / np.array(true.sensors.position_resolution)
    np.testing.assert_allclose(steps, np.rint(steps), atol=1e-6)
    np.testing.assert_allclose(np.diff(log.t), 1 / true.rate, rtol=1e-9)
    rough = np.diff(log.tau, n=3, axis=0).std(axis=0) / np.sqrt(20)  # noise alone, mostly
    assert (rough > 0.7 * true.noise).all()
    same = log_of_day(unit, 0, true, recipe)
    assert np.array_equal(log.tau, same.tau)
    assert not np.array_equal(log_of_day(unit, 1, true, recipe).tau[:100], log.tau[:100])


def test_units_scatter_and_warm_arms_rub_less(true: TrueType) -> None:
    recipe = Recipe()
    units = [draw_unit(None, true, recipe, seed) for seed in range(200)]
    spread = np.log([unit.numbers.viscous for unit in units]).std(axis=0)
    assert spread == pytest.approx(true.scatter, rel=0.2)
    assert ((true.scatter > 0.15) & (true.scatter < 0.25)).all()
    assert 5 <= min(len(unit.dates) for unit in units) < 8 < max(len(unit.dates) for unit in units) <= 20
    temperature = np.concatenate([unit.temperature for unit in units])
    assert 20 < temperature.mean() < 40
    assert "a data sheet" in true.sheet
