"""What must lose energy loses it, in every direction of motion, and friction is what its sources say."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from effects.cases import CASES, Case, draw, floats
from robodyn.effects import thesis_friction as thesis
from robodyn.effects.catalogue import effect
from robodyn.effects.effect import Memory, Site
from robodyn.verify.effects import direction

DIRECTIONS = {"sharp": (None, None), "smooth": (0.375, None), "dead band": (None, 0.5)}
DISSIPATIVE = [name for name, case in CASES.items() if case.effect.dissipative]


def places(rng: np.random.Generator, way: str, count: int = 400) -> Site:
    """Random sites as one of arrays, in motion and at rest; the direction follows the velocity."""
    qd = rng.uniform(-3, 3, count)
    qd[:10] = 0.0
    tau = rng.uniform(-5, 5, count)
    tau[10:20] = 0.0
    f, n = rng.uniform(-50, 50, (2, 3, count))
    q, qdd = rng.uniform(-3, 3, (2, count))
    return Site(True, q, qd, qdd, direction(qd, *DIRECTIONS[way]), tau, tuple(f), tuple(n))  # type: ignore[arg-type]


def added(case: Case, values: Any, at: Site) -> Any:
    equation = case.effect.equation
    assert equation is not None
    return equation(values, at)


@pytest.mark.parametrize("way", DIRECTIONS)
@pytest.mark.parametrize("name", DISSIPATIVE)
def test_power_is_never_given_back(name: str, way: str) -> None:
    case, rng = CASES[name], random.Random(name)
    for seed in range(10):
        values = floats(draw(case, rng))
        if "inertia" in values:
            values["inertia"] = 0.0  # what an inertia takes it gives back
        at = places(np.random.default_rng(seed), way)
        torque = added(case, values, at)
        power = torque * at.qd
        assert power.min() >= 0
        assert power.max() > 0
        # Friction opposes motion: the motor's torque has the sign of the velocity, wherever there is some.
        assert (torque[at.direction * torque != 0] * at.qd[at.direction * torque != 0] > 0).all()
        still = added(case, values, replace(at, qd=0 * at.qd, direction=0 * at.qd))
        np.testing.assert_array_equal(still, 0 * at.qd)


# --- the transmission -------------------------------------------------------------------------------------


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("torque", [Fraction(7, 2), Fraction(-7, 2)])
def test_the_four_quadrants(torque: Fraction, sense: int) -> None:
    """Table 3.2, exactly."""
    case, eta, breakaway = CASES["efficiency"], Fraction(3, 5), Fraction(1, 4)
    p = {"efficiency": eta, "breakaway": breakaway, "interpolation": "linear"}
    at = Site(True, qd=Fraction(sense), direction=Fraction(sense), tau=torque)
    law = thesis.driving if torque * sense > 0 else thesis.braking
    assert torque + added(case, p, at) == law(torque, eta, breakaway, sense)
    assert (
        law(torque, eta, breakaway, sense)
        == (torque / eta if torque * sense > 0 else torque * eta) + breakaway * sense
    )


# --- what remembers ---------------------------------------------------------------------------------------


def bristles() -> Memory:
    memory = effect("presliding_hysteresis").memory
    assert memory is not None
    return memory


def dissipated(p: Any, v: Any, z: Any) -> Any:
    """Power in, less the rate of the storage function stiffness z^2 / 2."""
    at = Site(True, qd=v)
    (rate,) = bristles().rates(p, at, (z,))
    return bristles().torque(p, at, (z,)) * v - p["stiffness"] * z * rate


def test_bristles_lose_energy() -> None:
    """At any bend up to 4 level/damping of speed; at any speed while they are bent as far as they slide."""
    rng = np.random.default_rng(6)
    for _ in range(20):
        p = dict(zip(("stiffness", "level", "damping"), rng.uniform(0.1, 9, 3), strict=True))
        slides, bound = p["level"] / p["stiffness"], 4 * p["level"] / p["damping"]
        v, z = rng.uniform(-bound, bound, 500), slides * rng.uniform(-20, 20, 500)
        size = p["level"] * np.abs(v).max()
        assert dissipated(p, v, z).min() >= -1e-12 * size
        v, z = 100 * bound * rng.uniform(-1, 1, 500), slides * rng.uniform(-1, 1, 500)
        assert dissipated(p, v, z).min() >= 0
        # Both bounds are sharp: bent twice as far, and faster.
        assert dissipated(p, 0.99 * bound, 2 * slides) > 0 > dissipated(p, 1.01 * bound, 2 * slides)
