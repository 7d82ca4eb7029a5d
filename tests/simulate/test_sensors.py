"""Sensors against scipy, closed forms and the equations of the catalogue."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.simulate.differences import low_pass
from robodyn.simulate.sensors import (
    Sensors,
    measure,
    measured_position,
    measured_torque,
    resolution_of,
)
from robodyn_testing import require_module
from simulate.arms import STEP, smooth
from simulate.arms import effect as entry

TRUE = smooth()


def test_by_default_they_show_the_truth() -> None:
    log = measure(TRUE, Sensors(), seed=3)
    assert all(a.tobytes() == b.tobytes() for a, b in zip(log.arrays(), TRUE.arrays(), strict=True))


def test_the_offset_of_an_encoder() -> None:
    found = measured_position(
        TRUE.q, [entry("encoder_offset", 2, offset=0.125), entry("coulomb_friction", 1)]
    )
    np.testing.assert_allclose(found - TRUE.q, np.broadcast_to([0, 0.125, 0], TRUE.q.shape), atol=1e-15)


def test_nothing_is_written_into_what_is_given() -> None:
    copy = smooth()
    effects = [entry("torque_bias", bias=1), entry("torque_gain", gain=1), entry("encoder_offset", offset=1)]
    sensors = Sensors(0.1, 0.1, torque_noise=1.0, torque_resolution=1.0)
    measure(copy, sensors, effects)
    assert all(np.array_equal(a, b) for a, b in zip(copy.arrays(), TRUE.arrays(), strict=True))


def test_nan_stays_where_it_is() -> None:
    tau = np.array([[1.0], [np.nan], [np.inf]])
    effects = [entry("torque_bias", bias=1), entry("torque_saturation", limit=9, clips="sensor")]
    np.testing.assert_array_equal(measured_torque(tau, np.arange(3.0), effects), [[2.0], [np.nan], [9.0]])


# --- encoders and rates -----------------------------------------------------------------------------------


def test_an_encoder_counts_whole_steps() -> None:
    step = resolution_of(12)
    assert step == 2 * math.pi / 4096
    offset = entry("encoder_offset", 1, offset=0.3)
    log = measure(TRUE, Sensors(position_resolution=(step, 0.0, 0.25)), [offset])
    counts = log.q[:, 0] / step
    np.testing.assert_allclose(counts, np.rint(counts), atol=1e-9)
    assert 0.49 * step < np.abs(log.q[:, 0] - TRUE.q[:, 0] - 0.3).max() <= 0.5 * step * (1 + 1e-9)
    assert np.array_equal(log.q[:, 1], TRUE.q[:, 1])
    assert set(log.q[:, 2]) <= {-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0}


def test_differences_are_of_what_is_measured() -> None:
    step = 2.0**-10
    log = measure(TRUE, Sensors(position_resolution=step, velocity="difference", acceleration="difference"))
    assert log.qd is not None
    assert log.qdd is not None
    rate = (log.q[1:] - log.q[:-1]) / np.diff(TRUE.t)[:, None]
    assert np.array_equal(log.qd[1:], rate)
    assert np.array_equal(log.qd[0], rate[0])
    np.testing.assert_allclose(log.qdd[1:] * np.diff(TRUE.t)[:, None], np.diff(log.qd, axis=0), atol=1e-12)


def test_rates_that_are_absent() -> None:
    log = measure(replace(TRUE, qd=None, qdd=None), Sensors(velocity="none", acceleration="none"))
    assert (log.qd, log.qdd) == (None, None)
    log = measure(TRUE, Sensors(velocity="none", acceleration="difference"))
    assert log.qd is None
    assert log.qdd is not None
    assert TRUE.qdd is not None
    assert np.abs(log.qdd - TRUE.qdd)[3:].max() < 30 * STEP
    with pytest.raises(InputError, match="no true velocity to show; choose difference"):
        measure(replace(TRUE, qd=None), Sensors())


@pytest.mark.parametrize("order", [1, 2])
def test_at_its_cutoff_a_sine_keeps_half_its_power(order: int) -> None:
    t = np.asarray(np.arange(4000) * STEP, dtype=np.float64)
    x = np.sin(2 * math.pi * 20 * t)[:, None]
    settled = low_pass(t, x, 20.0, order)[2000:, 0]
    assert np.abs(2 * np.mean(settled**2) - 0.5) < 1e-6


def test_the_filter_looks_only_back_and_starts_settled() -> None:
    t = np.asarray(np.arange(100) * STEP, dtype=np.float64)
    x = np.full((100, 1), 4.0)
    np.testing.assert_allclose(low_pass(t, x, 10.0), x, rtol=1e-14)
    other = x.copy()
    other[60:] = -1
    assert np.array_equal(low_pass(t, other, 10.0)[:60], low_pass(t, x, 10.0)[:60])


# --- noise ------------------------------------------------------------------------------------------------


def test_noise_is_gaussian_of_its_size() -> None:
    stats = require_module("scipy.stats")
    zeros = np.zeros((20_000, 2))
    still = Log(np.arange(20_000.0), zeros, zeros, zeros, zeros)
    log = measure(still, Sensors(position_noise=(0.01, 0.02), torque_noise=3.0), seed=1)
    for values, size in (
        (log.q[:, 0], 0.01),
        (log.q[:, 1], 0.02),
        (log.tau[:, 0], 3.0),
        (log.tau[:, 1], 3.0),
    ):
        assert stats.kstest(values / size, "norm").pvalue > 1e-3
    every = np.column_stack([log.q, log.tau])
    assert np.abs(np.corrcoef(every.T) - np.eye(4)).max() < 0.03


def test_streams_are_apart() -> None:
    def noise(sensors: Sensors, seed: int = 5) -> np.ndarray[Any, Any]:
        log = measure(TRUE, sensors, seed=seed)
        return np.column_stack([log.q - TRUE.q, log.tau - TRUE.tau])

    all_on = noise(Sensors(position_noise=1.0, torque_noise=1.0))
    one_on = noise(Sensors(torque_noise=(0.0, 1.0, 0.0)))
    assert np.array_equal(one_on[:, 4], all_on[:, 4])
    assert not one_on[:, [0, 1, 2, 3, 5]].any()
    assert np.array_equal(all_on, noise(Sensors(position_noise=1.0, torque_noise=1.0)))
    assert not (all_on == noise(Sensors(position_noise=1.0, torque_noise=1.0), seed=6)).any()
    assert np.unique(all_on[0]).size == 6


# --- what is wrong ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"position_noise": -1.0}, "position_noise is not a size; found -1.0"),
        ({"torque_resolution": (0.0, math.nan)}, "torque_resolution is not a size; found nan"),
        (
            {"velocity": "tachometer"},
            "unknown kind of velocity; found 'tachometer'; expected true, difference",
        ),
        ({"order": 3}, "no such order; found 3"),
        ({"acceleration": "filtered"}, "the low-pass has no cutoff"),
    ],
)
def test_options_that_make_no_sense(options: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Sensors(**options)


@pytest.mark.parametrize(
    ("options", "times", "message"),
    [
        (
            {"torque_noise": (1.0, 2.0)},
            TRUE.t,
            "torque_noise does not fit the joints; found 2; expected 1 or 3",
        ),
        ({"velocity": "filtered", "cutoff": 500.0}, TRUE.t, "500 Hz; expected between 0 and half their rate"),
        ({"velocity": "filtered", "cutoff": 5.0}, TRUE.t**2, "needs evenly spaced samples"),
        ({"velocity": "difference"}, TRUE.t * 0, "at increasing times"),
    ],
)
def test_options_that_do_not_fit(options: dict[str, Any], times: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        measure(replace(TRUE, t=times), Sensors(**options))


def test_other_numbers_that_are_refused() -> None:
    with pytest.raises(InputError, match="there is no such joint; found 4; expected a joint of 1 to 3"):
        measured_torque(TRUE.tau, TRUE.t, [entry("torque_bias", 4, bias=1)])
    with pytest.raises(InputError, match="cannot be delayed where the times do not increase"):
        measured_torque(TRUE.tau, -TRUE.t, [entry("time_delay", 1, delay=1)])
    with pytest.raises(InputError, match="a seed is a number of 0 or more"):
        measure(TRUE, Sensors(), seed=-1)
    for bits in (0, 65):
        with pytest.raises(InputError, match="resolution of an encoder"):
            resolution_of(bits)
