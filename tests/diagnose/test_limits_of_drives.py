"""A drive's limit: what it may explain, and what is left for it to be compared with; fits that diverge."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from diagnose.hidden.logs import effect
from peers.numbers import Array
from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.select.fit import problem
from robodyn.diagnose.select.library.limits import DRIVE_LIMITS, LIMIT_SHARE
from robodyn.diagnose.select.library.sensors import _is_limit, leave_little
from robodyn.diagnose.select.own_numbers import own_numbers
from robodyn.diagnose.select.refine import Freed, costs
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


def test_arms_that_cannot_be_cost_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    start = problem(np.ones((100, 3)), np.ones((100, 3, 1)), np.ones(3), 1.0)
    monkeypatch.setattr(
        Freed, "missed", lambda self, x: None if self.amendments and x[0] > 1 else np.ones(300)
    )
    monkeypatch.setattr(Freed, "own_numbers", lambda self, x: own_numbers(start))
    models = [[Amendment("viscous_friction", 1, {"coefficient": x})] for x in (2.0, 0.5)]
    first, second, none = costs(ROBOT, [*models, []], [], start)
    assert first == np.inf
    assert np.isfinite(second)
    assert second == none
