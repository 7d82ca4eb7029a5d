"""Candidates of the library: a drive's limit, motors that drive two joints, play of gears."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.blind_arms.logs import effect

from identify.exact import log_of
from peers.numbers import Array
from robodyn.diagnose.select.library import Candidate, candidates, context_of
from robodyn.diagnose.select.library.limits import COUPLED_BEYOND_SHARE, DRIVE_LIMITS, LIMIT_SHARE
from robodyn.diagnose.select.library.sensors import _is_limit, leave_little
from robodyn.diagnose.select.scope import Scope
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import signals_of
from robodyn.robot import load

ROBOT = load("puma560_3dof", warn=lambda _: None)


def explains(commands: Array, needed: Array, limit: float) -> bool:
    """Whether a limit of the drive explains what the commands are more than what the arm needs."""
    beyond = np.sign(commands) * np.maximum(np.abs(commands) - limit, 0)
    return float(np.mean(beyond != 0)) < LIMIT_SHARE and _is_limit(commands, needed, beyond, limit)


def test_noise_about_a_level_is_no_limit() -> None:
    """Friction alone: the torque is level, and any limit that cuts off its noise leaves less."""
    rng, t = np.random.default_rng(1), np.linspace(0, 20, 4000)
    level = 0.27 * np.sign(np.sin(3 * t)) * (np.sin(0.7 * t) > 0)  # and at rest in between
    commands = level + 0.05 * rng.standard_normal(len(t))
    top = np.abs(commands).max()
    assert not any(explains(commands, level, limit) for limit in (*(x * top for x in DRIVE_LIMITS), 0.28))


@pytest.mark.parametrize("noise", [0.0, 0.05])
def test_what_an_arm_does_not_get_is_explained_by_the_limit(noise: float) -> None:
    rng, t = np.random.default_rng(1), np.linspace(0, 20, 4000)
    needed = np.sin(3 * t) * (np.sin(0.7 * t) > 0)
    commands = needed + noise * rng.standard_normal(len(t))
    assert not explains(commands, needed, 0.8)
    assert explains(commands, np.clip(needed, -0.8, 0.8), 0.8)


def test_a_limit_leaves_little_where_a_drive_is_at_it_most_of_the_time() -> None:
    tau = np.tile(np.linspace(0, 1, 1001)[:, None], (1, 3))
    for share, is_little in ((LIMIT_SHARE - 0.01, False), (LIMIT_SHARE + 0.01, True)):
        limit = effect("torque_saturation", 2, limit=1 - share, clips="drive")
        assert leave_little([tau], replace(ROBOT, effects=(limit,))) == is_little
        # of several logs, what all have
        assert not leave_little([tau, 0 * tau], replace(ROBOT, effects=(limit,)))
    assert not leave_little([tau], ROBOT)


# --- motors that drive two joints -------------------------------------------------------------------------


@pytest.fixture(scope="module")
def couplings() -> list[Candidate]:
    robot = load("puma560", warn=lambda _: None)
    context = context_of(Model(robot), signals_of(log_of(robot, noise=0.01, seconds=2.0)))
    return list(candidates(context, Scope(frozenset({"motor_coupling"}))))


def test_no_motor_reaches_over_two_joints(couplings: list[Candidate]) -> None:
    likely = [one for one in couplings if one.likely(np.ones(3))]
    assert len(likely) < len(couplings)
    shares = {(k, j): one.least_share for one in likely for j, k in [one.rows]}
    near = {(j, j + 1): 0.0 for j in range(5)}
    assert shares == near | {(j, j + 2): COUPLED_BEYOND_SHARE for j in range(4)}


def test_a_motor_has_an_inertia(couplings: list[Candidate]) -> None:
    assert not any(one.feasible(np.array([0.0, 2.0, 3.0])) for one in couplings)
    assert all(one.feasible(np.array([1e-3, 0.0, 0.0])) for one in couplings)


def test_no_gear_has_ten_degrees_of_play() -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    context = context_of(Model(robot), signals_of(log_of(robot, noise=0.01, seconds=1.0)))
    one = next(c for c in candidates(context, Scope(frozenset({"backlash"}))) if "stiffness" in c.values)
    assert one.again is not None
    likely = {gap: one.again(context, {**one.values, "gap": gap}) for gap in (0.004, 0.17)}
    assert [each.likely(np.ones(1)) for each in likely.values()] == [True, False]
