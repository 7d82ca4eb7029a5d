"""Intervals of a fit whose truth is known: how often they hold it, and where they are open."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.select import uncertainty
from robodyn.diagnose.select.fit import problem
from robodyn.diagnose.select.local_fit import LocalFit
from robodyn.diagnose.select.own_numbers import own_numbers
from robodyn.diagnose.select.refine import Freed
from robodyn.diagnose.select.uncertainty import Uncertainty, uncertainties
from robodyn.robot import load

TRUTH = {"level": 1.0, "static": 2.5, "velocity": 0.1}
SAMPLES = 600
ROBOT = load("puma560_3dof", warn=lambda _: None)
SLIDING = load("stanford", warn=lambda _: None)


def speeds(least: float) -> Any:
    """Sweeps of one joint through rest, slower than ``least`` [rad/s] nowhere."""
    v = np.sin(np.linspace(0, 24 * np.pi, SAMPLES)) + 0.3 * np.sin(np.linspace(0, 7.3 * np.pi, SAMPLES))
    return np.sign(v) * np.maximum(np.abs(v), least)


def curve(v: Any, p: Any) -> Any:
    """The Stribeck curve over speeds [N]."""
    return (p["level"] + (p["static"] - p["level"]) * np.exp(-((v / p["velocity"]) ** 2))) * np.sign(v)


def noise(rng: np.random.Generator, alike: int) -> Any:
    """Noise of size 0.3 in which about as many neighbours are alike."""
    white = rng.standard_normal(SAMPLES + alike - 1)
    return 0.3 * np.convolve(white, np.ones(alike) / np.sqrt(alike), mode="valid")


def fitted(
    monkeypatch: pytest.MonkeyPatch, v: Any, torque: Any, begin: dict[str, float], thin: float = 1.0
) -> tuple[Amendment, dict[str, Uncertainty]]:
    """A law fitted to torques of which an offset, known to 0.2, is a number of the arm's own."""

    def missed(self: Freed, x: Any) -> Any:
        (one,) = self.changed(x)
        return (torque - curve(v, one.parameters)) / 0.3

    start = problem(torque[:, None], 0.2 * np.ones((SAMPLES, 1, 1)), np.array([0.3]), thin)
    monkeypatch.setattr(Freed, "missed", missed)
    monkeypatch.setattr(Freed, "own_numbers", lambda self, x: own_numbers(start))
    for _ in range(6):  # Gauss and Newton, as the search has done before
        freed = Freed.of(ROBOT, [Amendment("stribeck_friction", 1, begin)], [], start)
        fit = LocalFit.of(freed, freed.x)
        assert fit is not None
        outcome = fit.misfit_at(freed.x)
        assert outcome is not None
        x = freed.x - np.linalg.lstsq(fit.curvature, outcome[1], rcond=1e-9)[0]
        begin = {
            name: float(max(each, 0.2 * begin[name])) for (_, name), each in zip(freed.places, x, strict=True)
        }
    (one,), (sure,) = uncertainties(ROBOT, [Amendment("stribeck_friction", 1, begin)], [], start)
    return one, sure


@pytest.mark.parametrize("alike", [1, 5])
def test_intervals_hold_the_truth_as_often_as_they_say(monkeypatch: pytest.MonkeyPatch, alike: int) -> None:
    rng, v = np.random.default_rng(alike), speeds(0.0)
    held = dict.fromkeys(TRUTH, 0)
    for _ in range(60):
        offset = 0.2 * rng.standard_normal()
        one, sure = fitted(monkeypatch, v, curve(v, TRUTH) + offset + noise(rng, alike), TRUTH)
        for name, true in TRUTH.items():
            low, high = sure[name].low, sure[name].high
            assert low is not None
            assert high is not None
            assert low < float(one.parameters[name]) < high
            held[name] += low <= true <= high
    assert all(52 <= count <= 60 for count in held.values()), held
    assert sum(held.values()) < 179  # and not for being endless


def test_an_interval_is_open_where_the_motion_does_not_close_it(monkeypatch: pytest.MonkeyPatch) -> None:
    rng, v = np.random.default_rng(3), speeds(0.15)
    torque = curve(v, {**TRUTH, "velocity": 0.01}) + noise(rng, 1)
    _, sure = fitted(monkeypatch, v, torque, {**TRUTH, "velocity": 0.03})
    assert sure["velocity"].low is None
    assert sure["velocity"].stderr is None


def test_errors_allow_for_what_the_filter_takes_from_the_motion(monkeypatch: pytest.MonkeyPatch) -> None:
    v = speeds(0.0)
    torque = curve(v, TRUTH) + noise(np.random.default_rng(6), 1)
    start = problem(torque[:, None], 0.2 * np.ones((SAMPLES, 1, 1)), np.array([0.3]), 1.0)
    monkeypatch.setattr(Freed, "own_numbers", lambda self, x: own_numbers(start))
    errors = []
    for shift in (0.0, 0.5):

        def missed(self: Freed, x: Any, shift: float = shift) -> Any:
            (one,) = self.changed(x)
            static = float(one.parameters["static"]) - (0.0 if self.by_drives else shift)
            return (torque - curve(v, {**one.parameters, "static": static})) / 0.3

        monkeypatch.setattr(Freed, "missed", missed)
        monkeypatch.setattr(Freed, "smoother", lambda self: replace(self, by_drives=False))
        _, (sure,) = uncertainties(ROBOT, [Amendment("stribeck_friction", 1, TRUTH)], [], start)
        stderr = sure["static"].stderr
        assert stderr is not None
        errors.append(stderr)
    assert errors[1] == pytest.approx(np.hypot(errors[0], 0.5), rel=0.02)


def test_a_better_fit_on_the_way_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    v = speeds(0.0)
    torque = curve(v, TRUTH) + noise(np.random.default_rng(4), 1)

    def missed(self: Freed, x: Any) -> Any:
        (one,) = self.changed(x)
        return (torque - curve(v, one.parameters)) / 0.3

    start = problem(torque[:, None], 0.2 * np.ones((SAMPLES, 1, 1)), np.array([0.3]), 1.0)
    monkeypatch.setattr(Freed, "missed", missed)
    monkeypatch.setattr(Freed, "own_numbers", lambda self, x: own_numbers(start))
    off = {**TRUTH, "velocity": 0.11}
    (one,), (sure,) = uncertainties(ROBOT, [Amendment("stribeck_friction", 1, off)], [], start)
    assert abs(float(one.parameters["velocity"]) - 0.1) < 0.006
    assert sure["velocity"].low is not None
    assert sure["velocity"].low < 0.1


def test_noise_in_the_motion_of_a_link_behind_its_motor_is_allowed_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A coefficient of what is measured with noise is too small by the share of that noise in its squares
    (errors in variables): here by a fifth."""
    rng, true, share = np.random.default_rng(8), {"stiffness": 3.0, "damping": 0.5}, 0.2
    regular = np.stack([speeds(0.0), np.roll(speeds(0.0), 40)], axis=1)
    spread = np.sqrt(share / (1 - share)) * np.array([0.0, regular[:, 1].std()])
    monkeypatch.setattr(uncertainty, "fitted_about", lambda freed, x: (freed, x))  # of one number, no arm
    monkeypatch.setattr(Freed, "noisier", lambda self, draw: replace(self, contexts=(draw,)))
    held, values = 0, []
    for _ in range(20):
        seen = regular + spread * rng.standard_normal(regular.shape)
        torque = regular @ list(true.values()) + noise(rng, 1)
        start = problem(torque[:, None], 0.2 * np.ones((SAMPLES, 1, 1)), np.array([0.3]), 1.0)

        def missed(self: Freed, x: Any, seen: Any = seen, torque: Any = torque) -> Any:
            more = [np.random.default_rng(draw).standard_normal(seen.shape) for draw in self.contexts]
            return (torque - sum((spread * one for one in more), seen) @ x) / 0.3

        monkeypatch.setattr(Freed, "missed", missed)
        monkeypatch.setattr(Freed, "own_numbers", lambda self, x, start=start: own_numbers(start))
        (one,), (sure,) = uncertainties(ROBOT, [Amendment("joint_elasticity", 1, dict(true))], [], start)
        low, high = sure["damping"].low, sure["damping"].high
        assert low is not None
        assert high is not None
        held += low <= true["damping"] <= high
        values.append(float(one.parameters["damping"]))
    assert held >= 17
    assert np.mean(values) == pytest.approx(0.5, rel=0.05)  # 0.4 as fitted


def test_numbers_of_which_only_the_ratio_shows_are_open(monkeypatch: pytest.MonkeyPatch) -> None:
    rng, force = np.random.default_rng(5), 5.0 * speeds(0.0)
    torque = 0.3 * force + noise(rng, 3)
    start = problem(torque[:, None], 0.2 * np.ones((SAMPLES, 1, 1)), np.array([0.3]), 1.0)

    def missed(self: Freed, x: Any) -> Any:
        mu, span = x
        return (torque - mu / span * (1 + 1e-9 * span) * force) / 0.3

    monkeypatch.setattr(uncertainty, "fitted_about", lambda freed, x: (freed, x))  # of one number, no arm
    monkeypatch.setattr(Freed, "missed", missed)
    monkeypatch.setattr(Freed, "own_numbers", lambda self, x: own_numbers(start))
    begin: dict[str, float | str] = {"bearing": "linear", "mu": 0.0003, "span": 0.001}
    _, (sure,) = uncertainties(SLIDING, [Amendment("load_dependent_friction", 3, begin)], [], start)
    assert sure["span"] == Uncertainty(None, None, None)
    mu = sure["mu"].stderr
    assert mu is not None
    assert mu > 1000 * 0.0003
