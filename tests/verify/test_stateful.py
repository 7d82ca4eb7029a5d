"""Effects that remember: the reference's steps beside an integrator, and beside the catalogue's."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import robodyn
from effects.cases import CASES, draw, entry, floats
from robodyn.drives.coupling import TwistState, next_twist
from robodyn.drives.drive import layer_of
from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Site
from robodyn.verify.stateful import Twist, bristle_step, twist, twist_step
from robodyn_testing import exactly

PUMA = robodyn.load("puma560", warn=lambda _: None)


def close(found: Any, expected: Any, rel: float = 1e-12) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=rel * np.abs(expected).max())


def test_bristles_step_by_step() -> None:
    """Beside an integrator, and beside the catalogue."""
    from scipy.integrate import solve_ivp

    memory = effect("presliding_hysteresis").memory
    assert memory is not None
    rng = random.Random(1)
    p: dict[str, Any] = {}
    torque: Any = None
    for v, z, dt in (
        (0.8, 0.0, 0.1),
        (-2.0, 0.4, 0.3),
        (0.0, 0.1, 1.0),
        (1e-6, -0.2, 0.5),
        (3.0, 0.1, 500.0),
    ):
        p = floats(draw(CASES["presliding"], rng))
        if dt < 1:

            def rate(_: float, x: Any, v: float = v, p: Any = p) -> Any:
                return v - p["stiffness"] * abs(v) / p["level"] * x

            end = solve_ivp(rate, (0, dt), [z], rtol=1e-11, atol=1e-13).y[0, -1]
            assert bristle_step(p, np.array([v]), np.array([z]), dt)[0] == pytest.approx([end], abs=1e-9)
        (found,), torque = memory.step(p, Site(True, qd=v), (z,), dt)
        assert bristle_step(p, np.array([v]), np.array([z]), dt) == exactly(
            [pytest.approx(found)],
            [pytest.approx(torque)],
        )
    assert torque == pytest.approx(p["level"])  # after so long it slides


def twist_torque(effect: str, p: Any, way: Any, rate: Any) -> Any:
    """The inverse of the twist, by bisection, and damping."""
    low, high = np.zeros_like(way), p["stiffness"] * np.abs(way)
    for _ in range(200):
        middle = (low + high) / 2
        less = twist(effect, p, middle) < np.abs(way)
        low, high = np.where(less, middle, low), np.where(less, high, middle)
    return np.sign(way) * high + p["damping"] * rate


@pytest.mark.parametrize("damping", [Fraction(0), Fraction(3, 2)])
@pytest.mark.parametrize(
    ("id", "given"),
    [
        ("joint_elasticity", {"stiffness": Fraction(40)}),
        ("backlash", {"gap": Fraction(1, 50), "stiffness": Fraction(40)}),
    ],
)
def test_twists_step_by_step(id: str, given: Any, damping: Fraction) -> None:
    made = entry(id, 1, damping=damping, **given)
    p = floats(dict(made.settings))
    tau = np.array([-20.0, -0.01, 0.0, 0.3, 5.0])
    way = twist(id, p, tau)
    close(twist_torque(id, p, way, 0 * tau), tau)
    coupler = effect(id).coupler
    assert coupler is not None
    close(way, [coupler.twist(p, t) for t in tau], 1e-14)
    close(
        twist_torque(id, p, way, tau), [coupler.torque(p, x, t) for x, t in zip(way, tau, strict=True)], 1e-11
    )
    drive = layer_of(replace(PUMA, effects=(made,)), float, lambda _: 1).joints[0]
    before = Twist(0.1 * tau, tau, -tau)
    for dt in (0.0, 1e-3, 0.5):
        after = twist_step(id, p, tau, before, dt)
        for k, passed in enumerate(tau):
            state = TwistState(before.way[k], before.rate[k], before.acceleration[k])
            found = next_twist(drive, passed, state, dt)
            expected = [after.way[k], after.rate[k], after.acceleration[k]]
            assert [found.twist, found.rate, found.acceleration] == pytest.approx(
                expected, rel=1e-9, abs=1e-7
            )
