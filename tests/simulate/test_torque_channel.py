"""The torque channel against closed forms and the equations of the catalogue."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Site
from robodyn.logs.log import Log
from robodyn.robot.model import EffectEntry
from robodyn.robot.values import Affine
from robodyn.simulate.sensors import Sensors, measure, measured_slopes, measured_torque
from simulate.arms import STEP, smooth
from simulate.arms import effect as entry

TRUE = smooth()


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


def test_noise_before_a_limit_lowers_the_mean_near_it() -> None:
    """What the channel shows on average where noise comes before its limit."""
    limit = entry("torque_saturation", 1, limit=5, clips="sensor")
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
