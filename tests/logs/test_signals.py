"""Signals: how many samples are kept of what a filter passes, and motion above its cutoff."""

from __future__ import annotations

import numpy as np
import pytest

from identify.exact import motion
from robodyn.gate.gate import inspect
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import low_pass, rates, signals_of, thinning
from robodyn.robot import load

RATE, CUTOFF = 1000.0, 15.0


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


def test_what_is_measured_once_is_low_passed_once() -> None:
    """A link that rings at 14 Hz: its acceleration is compared with a torque that was not filtered before."""
    t = np.arange(10_000) / RATE
    wave = 2 * np.pi * 14.0
    q = np.stack([np.sin(t) + 1e-3 * np.sin(wave * t)], axis=1)
    q += 1e-6 * np.random.default_rng(1).standard_normal(q.shape)
    log = Log(t, q, None, None, np.zeros_like(q))
    true = -np.sin(t) - 1e-3 * wave**2 * np.sin(wave * t)
    once = low_pass(true, RATE, CUTOFF)[1000:-1000]

    def missed(wider: float) -> float:
        s = signals_of(log, cutoff=CUTOFF, wider=wider)
        ours = s.filtered(s.qdd)[1000 : len(once) + 1000, 0]
        return float(np.sqrt(np.mean((ours - once[: len(ours)]) ** 2) / np.mean(once**2)))

    assert missed(3.0) < 0.02
    assert missed(1.0) > 0.2


def test_where_only_noise_is_above_the_cutoff_the_filter_stays() -> None:
    t = np.arange(10_000) / RATE
    q = np.sin(2 * np.pi * np.round(t[:, None]) * 0)  # a joint that stands
    q = q + 1e-4 * np.random.default_rng(2).standard_normal(q.shape)
    log = Log(t, q, None, None, np.zeros_like(q))
    plain, wide = (signals_of(log, cutoff=CUTOFF, wider=wider).qdd for wider in (1.0, 3.0))
    assert np.std(wide) < 1.2 * np.std(plain)


def test_rates_of_a_motion_that_is_sampled_coarsely() -> None:
    """3 Hz at 200 Hz: by differences of second order accelerations would be 0.3 % too small."""
    t, w = np.arange(400) / 200, 2 * np.pi * 3
    q = np.stack([np.sin(w * t), np.cos(w * t)], axis=1)
    qdd = rates(rates(q, 1 / 200), 1 / 200)[8:-8]
    assert np.abs(qdd + w**2 * q[8:-8]).max() < 4e-5 * w**2
    for k in range(1, 5):
        assert rates(np.arange(float(k))[:, None], 0.5).ravel().tolist() == [2.0 if k > 1 else 0.0] * k
