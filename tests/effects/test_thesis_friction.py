"""The thesis's friction: statics of two supports, limits, points of its tables."""

from __future__ import annotations

import math
import random
from typing import Any

import pytest
import sympy

from robodyn.effects import thesis_friction as friction

MU, R, D = 0.1, 0.08, 0.25


def loads(seed: int) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    rng = random.Random(seed)
    f, n = ([rng.uniform(-50, 50) for _ in range(3)] for _ in range(2))
    return (f[0], f[1], f[2]), (n[0], n[1], n[2])


def supports(f: Any, n: Any) -> tuple[tuple[float, float], tuple[float, float]]:
    """Forces of two supports at z = +-D/2 that balance ``f`` and the x and y moments of ``n``: solved as
    linear equations, with r x F for the moments."""
    A = sympy.Matrix(
        [[1, 0, 1, 0], [0, 1, 0, 1], [0, -D / 2, 0, D / 2], [D / 2, 0, -D / 2, 0]]
    )  # rows: f_x, f_y, n_x = -z F_y, n_y = z F_x
    x = A.LUsolve(sympy.Matrix([f[0], f[1], n[0], n[1]]))
    return (float(x[0]), float(x[1])), (float(x[2]), float(x[3]))


@pytest.mark.parametrize("seed", range(3))
def test_bearings_are_two_supports_in_balance(seed: int) -> None:
    f, n = loads(seed)
    one, other = supports(f, n)
    expected = MU * R * (math.hypot(*one) + math.hypot(*other))
    assert friction.journal_bearing(MU, R, D, f, n, 1) == pytest.approx(expected)
    assert friction.journal_bearing(MU, R, D, f, n, -1) == pytest.approx(-expected)
    printed = friction.journal_bearing(MU, R, D, f, n, 1, as_printed=True)
    assert abs(printed - expected) > 1e-3 * expected
    sliding = MU * sum(map(abs, (*one, *other)))
    assert friction.linear_bearing(MU, D, f, n, 1) == pytest.approx(sliding)


def test_thrust_and_sum() -> None:
    assert friction.thrust_bearing(MU, R, (1.0, 2.0, -3.0), -1) == pytest.approx(-0.024)
    assert friction.with_friction(2.0, -0.5) == 1.5


def test_the_three_points_of_table_3_5() -> None:
    """Torque, breakaway, direction, input torque, and the efficiency that they imply; the third brakes."""
    for torque, breakaway, direction, given, efficiency, case in (
        (2.9943, 6.3, 1, 12.8911, 0.4543, friction.driving),
        (-15.9646, 5.5, -1, -33.9117, 0.5619, friction.driving),
        (-0.6801, 2.6, 1, 2.3648, 0.3458, friction.braking),
    ):
        assert case(torque, efficiency, breakaway, direction) == pytest.approx(given, abs=2e-3)
    assert friction.load_fraction(-15.9646, 186.4) == pytest.approx(0.0856, abs=1e-4)


def test_cubics_are_one_cubic() -> None:
    e = (0.3, 1.5, -0.8, 0.25)
    for load in (0.0, 0.2, 1.0):
        expected = e[0] + e[1] * load + e[2] * load**2 + e[3] * load**3
        assert friction.cubic_efficiency(load, e) == pytest.approx(expected)
        assert friction.cubic_efficiency_in_pairs(load, e) == pytest.approx(expected)
    assert friction.linear_efficiency(0.5, (0.25, 0.5)) == 0.5
