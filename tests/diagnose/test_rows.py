"""A row at rest says a set of dry friction: its moments are those of a speed whose sign nobody knows."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from diagnose.plain_arms import SLIDE, TURNTABLE, logged, read
from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.select.families import families
from robodyn.diagnose.select.library import context_of
from robodyn.diagnose.select.noise import rest_of
from robodyn.diagnose.select.nuisance import own_numbers
from robodyn.diagnose.select.rows import Rows, encoder_torque_noise, rows_of
from robodyn.diagnose.select.scope import Scope
from robodyn.gate.gate import inspect
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.logs.signals import signals_of, smoothed_motion
from robodyn.robot import load

LEVEL, UNRESOLVED = 3.0, 0.02
RUBBING = TURNTABLE.replace("zz: 0.5}", f"zz: 0.5}}, friction: {{coulomb: {LEVEL}}}")


def at_speed(share: float) -> tuple[Rows, Any]:
    """Rows of a joint that turns at a ``share`` of the speed that is resolved, its friction that of a speed
    that jitters by as much; and the signs [K] of that speed."""
    t = np.arange(5000) / 250
    speed = share * UNRESOLVED
    signs = np.sign(speed + UNRESOLVED * np.random.default_rng(1).uniform(-1, 1, len(t)))
    log = Log(t, (speed * t)[:, None], None, None, (LEVEL * signs)[:, None])
    gate: Any = SimpleNamespace(log=log, segments=(slice(0, len(t)),))
    return rows_of(read(RUBBING), [gate], np.array([UNRESOLVED])), signs


@pytest.mark.parametrize("share", [0.0, 0.3, -0.7, 1.5])
def test_rows_at_rest_weigh_as_their_set_says(share: float) -> None:
    rows, signs = at_speed(share)
    spread = signs.var()
    np.testing.assert_allclose(rows.unresolved, spread, atol=0.02)
    variance = rows.floor**2 + LEVEL**2 * rows.unresolved
    np.testing.assert_allclose(rows.weight, 1 / variance, rtol=1e-9)
    # The model's friction is the mean of the set: what is left has none.
    assert abs(rest_of(rows.robot, rows).mean()) < 0.05 * LEVEL


def test_rows_that_move_weigh_by_their_noise_alone() -> None:
    moving, resting = (at_speed(share)[0].weight.min() for share in (1.5, 0.0))
    assert moving > 100 * resting


@pytest.mark.parametrize("text", [TURNTABLE, SLIDE])
def test_a_law_within_the_speeds_that_are_not_resolved_is_no_candidate(text: str) -> None:
    robot = read(text)
    gate = inspect(logged(robot), robot)
    scope = Scope(only=frozenset({"stribeck_friction"}))
    seen, usual = [], rows_of(robot, [gate])
    for factor in (0.1, 1.0, 10.0):
        rows = replace(usual, expected=factor * usual.expected)
        velocities = [one.values["velocity"] for family in families(rows, scope) for one in family.ones]
        assert all(velocity > rows.expected[0] for velocity in velocities)
        seen.append(len(velocities))
    assert seen[0] > seen[1] > seen[2]


def test_a_tilted_base_shows_the_first_links_weight() -> None:
    """About a vertical axis only inertia shows; where the base tilts, also where the mass is in the plane."""
    arm = read(TURNTABLE)
    rows = rows_of(arm, [inspect(logged(arm), arm)])
    tilt = Amendment("base_tilt", None, {"tilt_x": 0.1, "tilt_y": 0.05})
    assert [own_numbers(rows, 0.3, tilts).shape[2] for tilts in ([], [tilt])] == [1, 3]


# --- signals ----------------------------------------------------------------------------------------------


def test_ends_of_a_motion_keep_their_acceleration() -> None:
    t = np.arange(450) / 1000
    q = np.sin(2 * np.pi * 1.3 * t)[:, None]
    smooth = smoothed_motion(q, 1000.0, 15.0)
    second = np.gradient(np.gradient(smooth, 1e-3, axis=0), 1e-3, axis=0)
    exact = -((2 * np.pi * 1.3) ** 2) * q
    assert np.abs(second - exact)[3:-3].max() < 0.15 * np.abs(exact).max()


def test_what_noise_of_the_encoders_makes_of_torques() -> None:
    robot, rng = load("ur5"), np.random.default_rng(0)
    t = np.arange(20_000) / 1000
    slow = 0.5 * np.sin(0.7 * t[:, None] + np.arange(6))
    noisy = signals_of(Log(t, slow + 1e-5 * rng.standard_normal(slow.shape), None, None, 0 * slow), cutoff=15)
    clean = signals_of(Log(t, slow, None, None, 0 * slow), cutoff=15)
    model = Model(robot)
    tau = [model.torque(s.q, s.qd, s.qdd) for s in (noisy, clean)]
    seen = noisy.thinned(noisy.filtered(tau[0] - tau[1])).std(axis=0)
    np.testing.assert_allclose(encoder_torque_noise(context_of(model, noisy)), seen, rtol=0.2)
