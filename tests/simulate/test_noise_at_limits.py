"""What a torque channel shows on average where noise comes before its limit."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry
from robodyn.simulate.sensors import Sensors, measure, measured_torque


def test_noise_before_a_limit_lowers_the_mean_near_it() -> None:
    limit = EffectEntry("torque_saturation", 1, (("limit", Fraction(5)), ("clips", "sensor")))
    true = np.array([3.0, 4.8, 5.0, 5.3, 9.0, -5.1])
    spread, draws = 0.4, 40_000
    noisy = np.repeat(true, draws)[:, None]
    zeros = np.zeros_like(noisy)
    times = np.asarray(np.arange(len(noisy)) * 1e-3, dtype=np.float64)
    log = Log(times, zeros, zeros, zeros, noisy)
    shown = measure(log, Sensors(torque_noise=spread), [limit], seed=4).tau
    means = shown.reshape(len(true), draws).mean(axis=1)
    expected = measured_torque(true[:, None], np.arange(6.0), [limit], noise=np.array([spread]))[:, 0]
    np.testing.assert_allclose(means, expected, atol=5 * spread / np.sqrt(draws))
    assert expected[2] < 4.9
    assert expected[4] == pytest.approx(5.0)
