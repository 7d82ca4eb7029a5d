"""Sensors against scipy, closed forms and the equations of the catalogue."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Site
from robodyn.errors import InputError
from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import Affine
from robodyn.simulate.differences import difference, low_pass
from robodyn.simulate.sensors import (
    Sensors,
    measure,
    measured_position,
    measured_slopes,
    measured_torque,
    resolution_of,
)
from robodyn_testing import require_module

STEP = 1e-3


def entry(kind: str, joint: int | None = None, **settings: Any) -> EffectEntry:
    """An effect's entry; numbers become the exact ones of a robot file."""
    exact = {k: Fraction(str(v)) if isinstance(v, (int, float)) else v for k, v in settings.items()}
    return EffectEntry(kind, joint, tuple(exact.items()))


def smooth(samples: int = 400, n: int = 3) -> Log:
    t = np.asarray(np.arange(samples) * STEP, dtype=np.float64)
    w = np.arange(1.0, n + 1)
    x = np.multiply.outer(t, w)
    return Log(t, np.sin(x), w * np.cos(x), -w * w * np.sin(x), 10 * np.cos(x))


TRUE = smooth()


def test_by_default_they_show_the_truth() -> None:
    log = measure(TRUE, Sensors(), seed=3)
    assert all(a.tobytes() == b.tobytes() for a, b in zip(log.arrays(), TRUE.arrays(), strict=True))


# --- the torque channel -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("kind", "settings"),
    [("torque_bias", {"bias": 1.5}), ("torque_gain", {"gain": -0.25}),
     ("torque_saturation", {"limit": 4.0, "clips": "sensor"})],
)  # fmt: skip
@pytest.mark.parametrize("joint", [2, None])
def test_effects_of_the_torque_are_those_of_the_catalogue(
    kind: str, settings: dict[str, Any], joint: int | None
) -> None:
    equation = effect(kind).equation
    assert equation is not None
    at = slice(None) if joint is None else slice(joint - 1, joint)
    want = TRUE.tau.copy()
    want[:, at] += equation(settings, Site(True, tau=TRUE.tau[:, at]))
    found = measured_torque(TRUE.tau, TRUE.t, [entry(kind, joint, **settings)])
    np.testing.assert_allclose(found, want, rtol=0, atol=1e-14)


def test_the_offset_of_an_encoder() -> None:
    found = measured_position(
        TRUE.q, [entry("encoder_offset", 2, offset=0.125), entry("coulomb_friction", 1)]
    )
    np.testing.assert_allclose(found - TRUE.q, np.broadcast_to([0, 0.125, 0], TRUE.q.shape), atol=1e-15)


def test_a_delayed_line_is_a_shifted_line() -> None:
    t = np.array([0.0, 0.5, 0.7, 2.0, 3.0])
    tau = np.stack([2 * t + 1, t**2], axis=1)
    found = measured_torque(tau, t, [entry("time_delay", 1, delay=0.6)])
    np.testing.assert_allclose(found[:, 0], 2 * np.maximum(t - 0.6, 0) + 1, rtol=1e-15)
    assert np.array_equal(found[:, 1], tau[:, 1])


@pytest.mark.parametrize("samples", [1, 7, 1000])
def test_a_delay_of_whole_samples_shifts_them(samples: int) -> None:
    found = measured_torque(TRUE.tau, TRUE.t, [entry("time_delay", delay=samples * STEP)])
    kept = max(len(TRUE.t) - samples, 0)
    np.testing.assert_allclose(found[len(TRUE.t) - kept :], TRUE.tau[:kept], rtol=0, atol=1e-12)
    assert (found[: len(TRUE.t) - kept] == TRUE.tau[0]).all()


def test_a_delay_between_samples_is_of_second_order() -> None:
    """The line between samples is off by at most step^2 / 8 times the curvature."""
    found = measured_torque(TRUE.tau, TRUE.t, [entry("time_delay", delay=2.5 * STEP)])
    want = 10 * np.cos(np.multiply.outer(TRUE.t - 2.5 * STEP, [1, 2, 3]))
    error = np.abs(found - want)[3:].max(axis=0)
    bound = STEP**2 / 8 * 10 * np.array([1, 4, 9])
    assert (error <= 1.001 * bound).all()
    assert (error >= 0.9 * bound).all()


def test_the_order_of_the_channel() -> None:
    """Delay, gain, bias, saturation, quantisation, whatever the order of the list."""
    t, tau = np.array([0.0, 1.0, 2.0]), np.array([[1.0], [3.0], [-8.0]])
    effects = [
        entry("torque_saturation", 1, limit=6.6, clips="sensor"),
        entry("torque_bias", 1, bias=0.5),
        entry("torque_gain", None, gain=1.0),
        entry("time_delay", None, delay=0.5),
    ]
    # Delayed 1, 2, -2.5; twice that 2, 4, -5; with bias 2.5, 4.5, -4.5.
    assert measured_torque(tau, t, effects).tolist() == [[2.5], [4.5], [-4.5]]
    effects[0] = entry("torque_saturation", 1, limit=4.3, clips="sensor")
    for order in (effects, effects[::-1]):
        assert measured_torque(tau, t, order).tolist() == [[2.5], [4.3], [-4.3]]
    log = measure(Log(t, tau, tau, tau, tau), Sensors(torque_resolution=1.0), effects)
    assert log.tau.tolist() == [[2.0], [4.0], [-4.0]]


def test_noise_comes_before_the_saturation() -> None:
    limit = entry("torque_saturation", None, limit=2, clips="sensor")
    log = measure(TRUE, Sensors(torque_noise=5.0), [limit])
    assert np.abs(log.tau).max() == 2
    assert np.abs(measure(TRUE, Sensors(torque_noise=5.0)).tau).max() > 10


def test_entries_of_one_kind_add_up() -> None:
    effects = [
        entry("torque_gain", None, gain=0.5), entry("torque_gain", 1, gain=1),
        entry("torque_bias", None, bias=1), entry("torque_bias", 1, bias=2),
        entry("torque_saturation", 2, limit=6.5, clips="sensor"),
        entry("torque_saturation", None, limit=50, clips="sensor"),
    ]  # fmt: skip
    found = measured_torque(np.array([[4.0, 4.0, 400.0]]), np.zeros(1), effects)
    assert found.tolist() == [[15.0, 6.5, 50.0]]
    late = measured_torque(
        TRUE.tau, TRUE.t, [entry("time_delay", None, delay=2 * STEP), entry("time_delay", 3, delay=STEP)]
    )
    np.testing.assert_allclose(late[3:, 2], TRUE.tau[:-3, 2], atol=1e-12)
    np.testing.assert_allclose(late[3:, 1], TRUE.tau[1:-2, 1], atol=1e-12)


def test_small_changes_come_through_as_the_torque_does() -> None:
    entries = [
        entry("time_delay", 1, delay=0.02), entry("torque_gain", 2, gain=-0.3),
        entry("torque_bias", 2, bias=4), entry("torque_saturation", 3, limit=9.5, clips="sensor"),
    ]  # fmt: skip
    log, rng = smooth(200), np.random.default_rng(3)
    t, tau, changes = log.t, log.tau, rng.standard_normal((200, 3, 2))
    step = 1e-7
    expected = [
        (measured_torque(tau + step * change, t, entries) - measured_torque(tau, t, entries)) / step
        for change in np.moveaxis(changes, 2, 0)
    ]
    measured = measured_torque(tau, t, entries)
    shown = measured_slopes(changes, t, entries, measured)
    clear = (np.abs(measured) < 9.49) | (np.abs(measured) == 9.5)  # a log may be rounded
    clear[:, :2] = True
    np.testing.assert_allclose(shown[clear], np.stack(expected, axis=2)[clear], atol=1e-5)
    assert 0 < np.count_nonzero(shown[:, 2, 0]) < 200


def test_the_log_has_the_command_of_a_drive_that_clips() -> None:
    effects = [entry("torque_saturation", None, limit=1, clips="drive")]
    assert np.array_equal(measure(TRUE, Sensors(), effects).tau, TRUE.tau)


def test_parameters_that_are_named() -> None:
    bias = EffectEntry("torque_bias", 1, (("bias", Affine(Fraction(1), (("b", Fraction(2)),))),))
    found = measured_torque(np.zeros((1, 1)), np.zeros(1), [bias], {"b": 3.0})
    assert found.tolist() == [[7.0]]


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
@pytest.mark.parametrize("cutoff", [0.5, 30.0, 499.0])
def test_the_low_pass_is_scipys(order: int, cutoff: float) -> None:
    signal = require_module("scipy.signal")
    x = np.random.default_rng(0).normal(size=(500, 2)) + 3
    t = np.asarray(7 + np.arange(500) * STEP, dtype=np.float64)
    b, a = signal.butter(order, cutoff, fs=1 / STEP)
    settled = signal.lfilter_zi(b, a)[:, None] * x[0]
    want, _ = signal.lfilter(b, a, x, axis=0, zi=settled)
    np.testing.assert_allclose(low_pass(t, x, cutoff, order), want, rtol=0, atol=1e-9)


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


def test_filtered_rates() -> None:
    log = measure(TRUE, Sensors(velocity="filtered", acceleration="filtered", cutoff=40.0, order=1))
    assert log.qd is not None
    assert np.array_equal(log.qd, low_pass(TRUE.t, difference(TRUE.t, TRUE.q), 40.0, 1))
    assert log.qdd is not None
    assert np.array_equal(log.qdd, low_pass(TRUE.t, difference(TRUE.t, log.qd), 40.0, 1))


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
        (
            {"velocity": "filtered", "cutoff": 500.0},
            TRUE.t,
            "found 500 Hz; expected between 0 and half their rate",
        ),
        ({"velocity": "filtered", "cutoff": 5.0}, TRUE.t**2, "needs evenly spaced samples"),
        ({"velocity": "difference"}, TRUE.t * 0, "at increasing times"),
    ],
)
def test_options_that_do_not_fit(options: dict[str, Any], times: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        measure(replace(TRUE, t=times), Sensors(**options))


@pytest.mark.parametrize(
    ("effects", "times", "message"),
    [
        (
            [entry("torque_bias", 4, bias=1)],
            TRUE.t,
            "there is no such joint; found 4; expected a joint of 1 to 3",
        ),
        ([entry("time_delay", 1, delay=1)], -TRUE.t, "cannot be delayed where the times do not increase"),
    ],
)
def test_effects_that_do_not_fit(effects: Sequence[EffectEntry], times: Any, message: str) -> None:
    with pytest.raises(InputError, match=message):
        measured_torque(TRUE.tau, times, effects)


def test_other_numbers_that_are_refused() -> None:
    with pytest.raises(InputError, match="a seed is a number of 0 or more"):
        measure(TRUE, Sensors(), seed=-1)
    for bits in (0, 65):
        with pytest.raises(InputError, match="resolution of an encoder"):
            resolution_of(bits)


def test_they_describe_themselves() -> None:
    described = Sensors(position_noise=(0.1, 0.2), velocity="filtered", cutoff=10.0).describe()
    assert described["position_noise"] == (0.1, 0.2)
    assert (described["velocity"], described["cutoff"], described["order"]) == ("filtered", 10.0, 2)
