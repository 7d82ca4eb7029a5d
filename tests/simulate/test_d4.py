"""Simulation D.4 of the thesis: the coefficients that its program prints, and its fixed steps of 0.02 s.

``data/d4_reference.csv`` has the mass matrix and the bias that the printed formulas of the program give at
100 random states. They take link 3 for 16.04 kg in the one and for 16.05 kg in the other.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.kernels import robot_kernel
from robodyn.robot.model import Robot
from robodyn.simulate.simulation import Torques, simulate
from simulate.arms import TIGHT, Floats, arm, plant_of

Accelerations = Callable[[Floats, Floats, Floats], Floats]

START = np.array([3.6997, 2.3083, 0.5951])
STEP = 0.02
ROBOT = arm("puma560_3dof_d4")


def weighing(mass: str) -> Robot:
    """The robot with link 3 of that mass."""
    *others, last = ROBOT.links
    return replace(ROBOT, links=(*others, replace(last, mass=Fraction(mass))))


def kernel(robot: Robot) -> Any:
    return robot_kernel.compile(robot, functions=["mass_matrix", "bias", "gravity"])


@pytest.fixture(scope="module")
def printed() -> Floats:
    """q, qd [3], M [9], h [3] of 100 states."""
    file = Path(__file__).parent / "data" / "d4_reference.csv"
    return np.loadtxt(file, delimiter=",", skiprows=1)


@pytest.fixture(scope="module")
def table() -> Floats:
    """Torques [100, 3] about those that hold the arm at the start."""
    hold = kernel(ROBOT).gravity(START[None])[0]
    waves: Floats = hold + 4 * np.sin(np.outer(STEP * np.arange(100), [2.0, 3.0, 5.0]))
    return waves


def test_the_mass_matrix_is_the_printed_one_of_the_lighter_link(printed: Floats) -> None:
    q, M = printed[:, :3], printed[:, 6:15].reshape(-1, 3, 3)
    off = {m: np.abs(kernel(weighing(m)).mass_matrix(q) - M).max() for m in ("16.04", "16.05")}
    print("mass matrix off by", off)
    assert len(q) == 100
    assert off["16.04"] < 3e-5
    assert off["16.05"] > 1e-3


def test_the_bias_is_the_printed_one_of_the_heavier_link(printed: Floats) -> None:
    q, qd, h = printed[:, :3], printed[:, 3:6], printed[:, 15:]
    off = {m: np.abs(kernel(weighing(m)).bias(q, qd) - h).max() for m in ("16.04", "16.05")}
    print("bias off by", off)
    assert off["16.05"] < 1e-4
    assert off["16.04"] > 1e-2


def by_kernels(mass: Any, bias: Any) -> Accelerations:
    def accelerations(q: Floats, qd: Floats, tau: Floats) -> Floats:
        result: Floats = np.linalg.solve(mass.mass_matrix(q), tau - bias.bias(q, qd))
        return result

    return accelerations


def runge_kutta(accelerations: Accelerations, table: Floats) -> Floats:
    """Positions [101, 3] by the classic method as a book has it; a row of torques holds for a step."""

    def slope(x: Floats, tau: Floats) -> Floats:
        return np.concatenate([x[3:], accelerations(x[:3], x[3:], tau)])

    x = np.concatenate([START, np.zeros(3)])
    states = [x]
    for tau in table:
        a = slope(x, tau)
        b = slope(x + STEP / 2 * a, tau)
        c = slope(x + STEP / 2 * b, tau)
        d = slope(x + STEP * c, tau)
        x = x + STEP / 6 * (a + 2 * b + 2 * c + d)
        states.append(x)
    return np.array(states)[:, :3]


def run(table: Floats, **options: Any) -> Floats:
    return simulate(
        ROBOT,
        Torques(table, STEP),
        start=START,
        duration=2.0,
        sample_period=STEP,
        plant=plant_of(ROBOT),
        **options,
    ).q


def test_two_seconds_of_a_hundred_steps(table: Floats) -> None:
    """From rest, to rounding."""
    own = kernel(ROBOT)
    found = run(table, step=STEP)
    assert np.ptp(found, axis=0).min() > 0.1
    np.testing.assert_allclose(found, runge_kutta(by_kernels(own, own), table), rtol=0, atol=1e-11)


def test_what_the_two_masses_and_the_long_steps_of_the_program_matter(table: Floats) -> None:
    """The mixture of masses moves the arm by less than a degree, the step of 0.02 s by less than 1e-6 rad."""
    own = kernel(ROBOT)
    right = run(table, **TIGHT)
    step = np.abs(run(table, step=STEP) - right).max()
    mixed = np.abs(runge_kutta(by_kernels(kernel(weighing("16.04")), own), table) - right).max()
    print(f"off by {step:.1e} rad for the step, {mixed:.1e} rad for the masses")
    assert 1e-9 < step < 1e-6
    assert step < mixed < 0.02
