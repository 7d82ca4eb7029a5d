"""Simulation D.4 of the thesis: the coefficients that its program prints, and its fixed steps of 0.02 s.

``data/d4_reference.csv`` has the mass matrix and the bias that the printed formulas of the program give at
100 random states. They take link 3 for 16.04 kg in the one and for 16.05 kg in the other.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.kernels import robot_kernel
from robodyn.robot.model import Robot
from simulate.arms import Floats, arm

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
