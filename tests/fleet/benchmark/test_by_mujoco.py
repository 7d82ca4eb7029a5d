"""Arms of a simulated fleet moved by MuJoCo: the torques are those of robodyn's own simulator."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.fleet import by_mujoco
from benchmarks.fleet.arm import Day, loaded
from benchmarks.fleet.changes import Change, changed
from benchmarks.fleet.programs import draw_program
from benchmarks.fleet.recipe import Recipe
from benchmarks.fleet.types import TrueType, draw_type
from benchmarks.fleet.units import moved

from robodyn.effects.springs import BACKLASH
from robodyn.robot import load
from robodyn.simulate.trajectories.trajectory import Trajectory


@pytest.fixture(scope="module")
def true() -> TrueType:
    return draw_type(load("puma560_3dof"), Recipe(), np.random.default_rng(4))


@pytest.fixture(scope="module")
def motion(true: TrueType) -> Trajectory:
    rng = np.random.default_rng(1)
    return draw_program(true.robot, rng).motion(4.0, 1.0, rng)


def test_the_same_torques(true: TrueType, motion: Trajectory) -> None:
    numbers = loaded(true.numbers, 1.5, np.array([0.1, -0.05, 0.2]))
    day = Day(replace(numbers, viscous=1.3 * numbers.viscous, coulomb=0.8 * numbers.coulomb))
    ours, peer = moved(true, day, motion), by_mujoco.moved(true, day, motion)
    assert ours.qd is not None
    fast = (np.abs(ours.qd) > 0.05).all(axis=1)
    assert fast.sum() > 300
    apart = np.sqrt(np.mean((ours.tau - peer.tau)[fast] ** 2, axis=0))
    assert (apart < true.noise).all()
    without = by_mujoco.moved(true, Day(true.numbers), motion)
    assert (np.sqrt(np.mean((ours.tau - without.tau)[fast] ** 2, axis=0)) > 2 * true.noise).any()


def test_play(true: TrueType, motion: Trajectory) -> None:
    """It shows at the joint that has it, more the wider it is, and not where there is next to none."""
    play = Change("play", (BACKLASH.id,), 1, None, 0.0, 0.004, {})
    rigid = by_mujoco.moved(true, Day(true.numbers), motion)
    apart = {}
    for level in (0.02, 0.5, 1.0):
        log = by_mujoco.moved(true, changed(play, level, true, true.numbers), motion)
        apart[level] = np.sqrt(np.mean((log.tau - rigid.tau) ** 2, axis=0))[0] / true.noise[0]
    assert apart[0.02] < apart[0.5] < apart[1.0]
    assert apart[1.0] > 2
