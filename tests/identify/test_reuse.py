"""What an evaluation along a log costs, counted: the rigid arm is evaluated once for all its drives."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.amend.amend import Amendment, amended
from robodyn.dynamics.newton_euler import newton_euler
from robodyn.formats.loading import robot_of
from robodyn.kernels import array_dynamics
from robodyn.kernels.array_dynamics import Model, Reuse

PUMA = robot_of("puma560_3dof")


def test_models_that_differ_in_their_drives_share_the_arm(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = []

    def counted(*arguments: Any) -> Any:
        calls.append(arguments)
        return newton_euler(*arguments)

    monkeypatch.setattr(array_dynamics, "newton_euler", counted)
    q, qd, qdd = np.random.default_rng(0).uniform(-1, 1, (3, 50, PUMA.n))
    reuse = Reuse()
    for level in (0.5, 1.0, 2.0):
        robot = amended(PUMA, [Amendment("coulomb_friction", 2, {"level": level})])
        shared = Model(robot, reuse=reuse).evaluate(q, qd, qdd).total
        assert len(calls) == 1
        alone = Model(robot).evaluate(q, qd, qdd).total
        calls.pop()
        np.testing.assert_array_equal(shared, alone)
    heavier = amended(PUMA, [Amendment("payload", None, {"mass": 1.0, "com_x": 0.1})])
    Model(heavier, reuse=reuse).evaluate(q, qd, qdd)
    assert len(calls) == 2
    moved = reuse.shifted(q, np.array([0.1, 0.0, 0.0]))
    assert reuse.shifted(q, np.array([0.1, 0.0, 0.0])) is moved
    np.testing.assert_array_equal(moved, q - [0.1, 0.0, 0.0])
