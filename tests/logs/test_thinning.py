"""How many samples are kept of what a filter passes, and of a long log at any rate."""

from __future__ import annotations

import numpy as np
import pytest

from identify.exact import motion
from robodyn.gate.gate import inspect
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import signals_of, thinning
from robodyn.robot import load


@pytest.mark.parametrize("rate", [30.0, 95.0, 100.0, 125.0, 250.0, 500.0, 1000.0, 4000.0])
def test_what_the_filter_passes_is_carried_by_what_is_kept(rate: float) -> None:
    every = thinning(rate)
    cutoff = min(15.0, 0.2 * rate)
    assert every == 1 or every % 2 == 0
    assert rate / every >= 3 * cutoff
    assert every > 1 or rate < 100
    t, q, _, _ = motion(2, rate=rate, seconds=20.0)
    s = signals_of(Log(t, q, None, None, q), cutoff=cutoff)
    assert s.every == every
    assert len(s.coarse().thinned(s.coarse().q)) == len(s.thinned(s.q))


@pytest.mark.parametrize("rate", [40.0, 100.0, 500.0])
def test_of_a_long_log_no_more_is_kept_than_is_asked_for(rate: float) -> None:
    robot = load("puma560_3dof", warn=lambda _: None)
    t, q, qd, qdd = motion(3, rate=rate, seconds=100.0)
    tau = Model(robot).torque(q, qd, qdd) + 0.3 * np.random.default_rng(1).standard_normal(q.shape)
    gate = inspect(Log(t, q, None, None, tau), robot, thinned=500)
    assert gate.log.samples <= 500 * thinning(rate)
    assert gate.log.samples > 400 * thinning(rate)
    assert len(gate.segments) > 1
