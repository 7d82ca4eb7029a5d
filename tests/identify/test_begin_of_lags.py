"""How a link on its spring is taken to have begun, where the log's edge says little of its accelerations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from robodyn.effects.catalogue import CATALOGUE
from robodyn.identify import twist
from robodyn.identify.oscillator import Oscillator
from robodyn.identify.twist import lag_of

PERIOD, INERTIA, SAMPLES = 1e-3, 2.0, 6000
STIFFNESS = INERTIA * (2 * np.pi * 7.0) ** 2
SPRINGS = {
    "joint_elasticity": {"stiffness": STIFFNESS, "damping": 2e-3 * STIFFNESS},
    "backlash": {"gap": 0.01, "stiffness": STIFFNESS, "damping": 4e-3 * STIFFNESS, "transition": 0.05},
}


@pytest.mark.parametrize("effect", SPRINGS)
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_state_behind_a_wrong_edge_is_that_of_the_torque(effect: str, side: float) -> None:
    t = PERIOD * np.arange(SAMPLES)
    values = SPRINGS[effect]
    load = 6 * np.sin(2.1 * t + 0.4) + 8 * np.sin(5.3 * t)
    felt: tuple[Any, Any, Any] = (np.full(SAMPLES, INERTIA), np.zeros(SAMPLES), np.zeros(SAMPLES))
    coupler = CATALOGUE[effect].coupler
    assert coupler is not None
    places = np.linspace(-0.1, 0.1, 20_001)
    force = np.asarray(coupler.torque(values, places, 0.0))
    spring = (force, -0.1, float(places[1] - places[0]))
    true = Oscillator((load, *felt), PERIOD, spring, values["damping"]).motion((side * 0.012, -side * 0.1))
    passed = np.interp(true[:, 0], places, force) + values["damping"] * true[:, 1]
    seen = load.copy()
    seen[:80] += side * 30.0  # accelerations of a filter that does not know what was before
    lag = lag_of(effect, values, seen, felt, PERIOD, passed)
    apart = (lag - true)[500:]  # within its backlash a link may be anywhere: no torque tells
    assert np.abs(apart[:, 0]).max() < 0.03 * np.abs(true[:, 0]).max()


def test_a_spring_is_as_stiff_in_samples_that_are_far_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    values = SPRINGS["joint_elasticity"]

    def lag(every: int) -> Any:
        t = PERIOD * every * np.arange(SAMPLES // every)
        load = 6 * np.sin(0.5 * (2 * np.pi * 7.0) * t) * np.minimum(t, 1.0)
        felt = (np.full(len(t), INERTIA), np.zeros(len(t)), np.zeros(len(t)))
        return lag_of("joint_elasticity", values, load, felt, PERIOD * every)[:, 0]

    fine = lag(1)
    for every in (4, 8):
        assert np.abs(lag(every) - fine[::every]).max() < 5e-4 * np.abs(fine).max()
    monkeypatch.setattr(twist, "STEP_ANGLE", 10.0)
    assert np.abs(lag(8) - fine[::8]).max() > 4e-3 * np.abs(fine).max()
