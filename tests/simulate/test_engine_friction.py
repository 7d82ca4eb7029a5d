"""Dry friction: stick and slip against closed forms, many elements against least squares within bounds."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.simulate.control import Control
from robodyn.simulate.engine import Record
from robodyn_testing import require_module
from simulate.systems import BLOCK, COUPLED, GEARS, LIFT, engine

Floats = NDArray[np.float64]
METHODS: list[dict[str, Any]] = [
    {"method": "rk4", "step": 1e-3},
    {"method": "adaptive", "rtol": 1e-10, "atol": 1e-12},
]
ROWS = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, -0.5, 0]])


def block(y: float, duration: float, parameters: list[float], **options: Any) -> Record:
    made = engine(BLOCK).run(
        [y], [0.0], duration=duration, parameters=parameters, **{"sample_period": 0.01, **options}
    )
    assert made.status == "done"
    return made


@pytest.mark.parametrize("options", METHODS, ids=["rk4", "adaptive"])
def test_a_coulomb_oscillator_stops_where_and_when_it_must(options: dict[str, Any]) -> None:
    """Stiffness 4, level 1: each half period of pi / 2 takes 1/2 off the amplitude, until it is below 1/4."""
    made = block(2.1, 10.0, [0, 4, 1, 1, 1, 0, 0], **options)
    turns, amplitude = np.floor(made.t / (np.pi / 2)), 2.1
    expected = np.empty_like(made.t)
    for k in range(4):
        part = turns == k
        sign = (-1) ** k
        centre = sign * 0.25
        expected[part] = centre + sign * (amplitude - 0.25) * np.cos(2 * (made.t[part] - k * np.pi / 2))
        amplitude -= 0.5
    expected[turns >= 4] = amplitude
    assert np.abs(made.y[:, 0] - expected).max() < 1e-8
    moving = np.nonzero(made.s[:, 0])[0]
    assert made.t[moving[-1]] < 2 * np.pi < made.t[moving[-1] + 1]
    after = made.t > 2 * np.pi
    assert np.ptp(made.y[after]) == 0.0
    assert (made.v[after] == 0.0).all()
    assert (made.s[after] == 0.0).all()
    assert made.loss[-1] == pytest.approx(2.1 + 2 * (1.6 + 1.1 + 0.6) + 0.1, abs=1e-8)
    assert made.counters["events"] == 4


@pytest.mark.parametrize(
    ("options", "most"), [(METHODS[0], 1e-6), (METHODS[1], 1e-14)], ids=["rk4", "adaptive"]
)
def test_break_away_is_when_the_force_passes_the_level(options: dict[str, Any], most: float) -> None:
    made = block(0.0, 1.0, [0, 0, 1, 1, 1, 3, 0], **options)
    since = np.maximum(made.t - 1 / 3, 0)
    assert np.abs(made.y[:, 0] - since**3 / 2).max() < most
    assert (made.y[made.t < 1 / 3] == 0).all()
    assert (made.s[:, 0] == (made.t > 1 / 3)).all()


def test_a_halt_within_a_long_step_is_not_missed() -> None:
    """v = 0.98 - 4 t + 4 t^2 until it is 0; then the block sticks until t = 1/2, and v = 4 (t - 1/2)^2."""
    made = engine(BLOCK).run(
        [0.0], [0.98], duration=1.0, sample_period=1.0, method="adaptive", step=1.0, rtol=1e-9, atol=1e-9,
        parameters=[0, 0, 1, 1, 1, 8, 0], control=Control.held([[-3.0]], 2.0),
    )  # fmt: skip
    halt = 0.5 - np.sqrt(0.02) / 2
    where = 0.98 * halt - 2 * halt**2 + 4 / 3 * halt**3
    assert made.y[-1, 0] == pytest.approx(where + 4 / 3 * 0.5**3, abs=1e-11)
    assert made.v[-1, 0] == pytest.approx(1.0, abs=1e-11)
    assert made.counters["events"] == 2


def accelerations(M: Floats, levels: Floats, load: Floats, v: Floats, most: float) -> Floats:
    """By least squares within bounds: at rest the multipliers take off as much acceleration as they can."""
    optimize = require_module("scipy.optimize")
    u = ROWS @ v
    rest = np.abs(u) <= most
    free = load - ROWS.T @ (levels * np.sign(u) * ~rest)
    if rest.any():
        factor = np.linalg.inv(np.linalg.cholesky(M))
        found = optimize.lsq_linear(
            factor @ ROWS[rest].T,
            factor @ free,
            bounds=(-levels[rest], levels[rest]),
            method="bvls",
            tol=1e-15,
        )
        free = free - ROWS[rest].T @ found.x
    return np.asarray(np.linalg.solve(M, free), dtype=np.float64)


def coupled(rng: np.random.Generator) -> tuple[Floats, Floats, Floats]:
    A = rng.normal(size=(3, 3))
    return A @ A.T + 0.05 * np.eye(3), rng.uniform(0.1, 2, 4), rng.normal(size=3)


def test_elements_at_rest_together_even_if_one_too_many() -> None:
    rng = np.random.default_rng(1)
    seen = set()
    for _ in range(400):
        M, levels, load = coupled(rng)
        v = rng.normal(size=3) * (rng.random(3) < 0.3)
        load *= rng.choice([0.3, 1, 3])
        made = engine(COUPLED).run(
            [0] * 3, v, duration=0, sample_period=1, parameters=np.concatenate([M.ravel(), levels, load])
        )
        assert made.status == "done"
        np.testing.assert_allclose(
            made.a[0], accelerations(M, levels, load, v, 0.0), atol=1e-10 * np.abs(np.linalg.inv(M)).max()
        )
        seen.add(tuple(np.abs(made.s[0])))
    assert len(seen) == 16, "every combination of what sticks"


@pytest.mark.parametrize("options", METHODS, ids=["rk4", "adaptive"])
def test_coupled_elements_in_motion(options: dict[str, Any]) -> None:
    """Everything that sticks, slides and turns: the law holds at the samples, and energy is accounted for."""
    rng = np.random.default_rng(2)
    events = 0
    for _ in range(8):
        M, levels, load = coupled(rng)
        torque = np.cumsum(rng.normal(size=(40, 3)), axis=0) * 0.5
        v = rng.normal(size=3) * (rng.random(3) < 0.7)
        made = engine(COUPLED).run(
            [0] * 3, v, duration=2.2, sample_period=0.0125, control=Control.held(torque, 0.05),
            parameters=np.concatenate([M.ravel(), levels, load]), **options,
        )  # fmt: skip
        assert made.status == "done"
        events += made.counters["events"]
        assert (made.a[made.s[:, :3] == 0] == 0).all()
        assert (made.v[made.s[:, :3] == 0] == 0).all()
        kinetic = 0.5 * np.einsum("ki,ij,kj->k", made.v, M, made.v) - made.y @ load
        assert np.abs(kinetic - kinetic[0] - made.work + made.loss).max() < 1e-8
        for k in range(0, len(made.t), 8):
            if options["method"] == "rk4" and k % 4:
                continue
            expected = accelerations(M, levels, load + made.applied[k], made.v[k], 1e-11)
            np.testing.assert_allclose(made.a[k], expected, atol=1e-9 * np.abs(np.linalg.inv(M)).max())
    assert events > 20


def test_a_coupling_that_sticks_does_not_drift() -> None:
    t = np.arange(0, 4.001, 0.01)
    torque = np.stack([3 * np.sin(7 * t), 2 * np.cos(3 * t), 0 * t], axis=1)
    made = engine(COUPLED).run(
        [0] * 3, [0.5, 1.0, 0], duration=4.0, sample_period=0.01, step=1e-3,
        control=Control.linear(torque, 0.01),
        parameters=[2, 0.3, 0.1, 0.3, 1.5, 0.2, 0.1, 0.2, 1, 1e-3, 1e-3, 1, 1e3, 0, 0, 0],
    )  # fmt: skip
    assert (made.s[:, 3] == 0).all()
    assert np.ptp(made.y[:, 0]) > 0.1
    assert np.abs(made.v @ ROWS[3]).max() <= 4e-16 * np.abs(made.v).max()


@pytest.mark.parametrize("options", METHODS, ids=["rk4", "adaptive"])
@pytest.mark.parametrize("torque", [60.0, 44.0, 20.0, 8.6, 7.0, -3.0])
def test_friction_of_a_load_that_depends_on_the_acceleration(torque: float, options: dict[str, Any]) -> None:
    """A gear of efficiency 0.4 lifts, holds or lets down by the torque; a block slides under its weight."""
    mu, efficiency, inertia, g = 0.3, 0.4, 0.5, 9.81
    made = engine(LIFT).run(
        [0, 0], [3.0, 0], duration=0.2, sample_period=0.02, parameters=[mu, efficiency, inertia],
        control=Control.held([[torque]], 1.0, place=[1]), **options,
    )  # fmt: skip
    up = (torque - 2 * g / efficiency) / (inertia + 2 / efficiency)
    down = (torque - 2 * g * efficiency) / (inertia + 2 * efficiency)
    lift = up if up > 0 else down if down < 0 else 0.0
    assert made.status == "done"
    np.testing.assert_allclose(made.a[:, 1], lift, atol=1e-12)
    np.testing.assert_allclose(made.a[:, 0], -mu * abs(lift + g), atol=1e-12)
    np.testing.assert_allclose(made.y[:, 1], lift * made.t**2 / 2, atol=1e-13)
    energy = made.v[:, 0] ** 2 / 2 + 1.25 * made.v[:, 1] ** 2 + 2 * g * made.y[:, 1]
    assert np.abs(energy - energy[0] - made.work + made.loss).max() < 1e-12
    if lift == 0:
        assert (made.v[:, 1] == 0).all()


def geared(
    M: Floats, weight: Floats, inertia: Floats, efficiency: Floats, torque: Floats, v: Floats
) -> list[Floats]:
    """Every acceleration that agrees with itself, of all signs of motion and load."""
    found: list[Floats] = []
    ways = [(0, 1, -1) if rate == 0 else (int(np.sign(rate)),) for rate in v]
    for modes, loads in product(product(*ways), product((1, -1), repeat=2)):
        way, sign = np.array(modes), np.array(loads)
        moves = way != 0
        gear = np.where(moves, np.where(way * sign > 0, 1 / efficiency, efficiency), 1.0)
        a = np.zeros(2)
        A = np.diag(inertia) + gear[:, None] * M
        a[moves] = np.linalg.solve(A[np.ix_(moves, moves)], (torque - gear * weight)[moves])
        load = M @ a + weight
        held = torque - load
        levels = np.sort([load / efficiency, load * efficiency], axis=0) - load
        right = np.where(moves, load * sign >= 0, (sign > 0) & (levels[0] <= held) & (held <= levels[1]))
        if right.all() and (way * a >= 0)[v == 0].all():
            found.append(a)
    return found


def test_newtons_method_finds_the_only_acceleration_of_two_gears() -> None:
    rng = np.random.default_rng(3)
    stuck = 0
    for _ in range(300):
        A = rng.normal(size=(2, 2))
        M, weight, torque = A @ A.T + 0.05 * np.eye(2), 3 * rng.normal(size=2), 6 * rng.normal(size=2)
        inertia, efficiency = rng.uniform(0, 2, 2) * rng.choice([0.05, 1]), rng.uniform(0.3, 1, 2)
        v = rng.normal(size=2) * (rng.random(2) < 0.5)
        made = engine(GEARS).run(
            [0, 0], v, duration=0, sample_period=1, control=Control.held([torque], 1.0),
            parameters=np.concatenate([M.ravel(), weight, inertia, efficiency]),
        )  # fmt: skip
        assert made.status == "done"
        (expected,) = geared(M, weight, inertia, efficiency, torque, v)
        np.testing.assert_allclose(made.a[0], expected, atol=1e-9 * np.abs(np.linalg.inv(M)).max())
        stuck += int((made.s == 0).sum())
    assert stuck > 30
