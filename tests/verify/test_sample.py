"""The states that kernels are compared at."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.robot.model import Limits
from robodyn.verify.sample import draw
from robodyn_testing.random_robots import random_robot


def test_the_sample_stays_within_the_limits() -> None:
    robot = random_robot(1, joints=3, prismatic=0.5)
    limits = Limits((Fraction(1, 4), Fraction(1, 2)), Fraction(1, 8), Fraction(2))
    first = replace(robot.links[0], joint=replace(robot.links[0].joint, limits=limits))
    slide = replace(robot.links[1], joint=replace(robot.links[1].joint, kind="prismatic", limits=Limits()))
    turn = replace(robot.links[2], joint=replace(robot.links[2].joint, kind="revolute", limits=Limits()))
    sample = draw(replace(robot, links=(first, slide, turn)), 2000, 0, np.dtype(np.float32))
    moving = slice(0, -4)
    bounds: dict[str, list[tuple[float, float]]] = {
        "q": [(0.25, 0.5), (-0.5, 0.5), (-3.1416, 3.1416)],
        "qd": [(-0.125, 0.125), (-3, 3), (-3, 3)],
        "qdd": [(-2, 2), (-10, 10), (-10, 10)],
    }
    for name, expected in bounds.items():
        values = getattr(sample, name)
        assert values.dtype == np.float64
        np.testing.assert_array_equal(values, values.astype(np.float32))
        for k, (low, high) in enumerate(expected):
            found = values[moving, k]
            assert low <= found.min() < low + 0.02 * (high - low)
            assert high >= found.max() > high - 0.02 * (high - low)
    assert not sample.q[-1].any()
    assert not sample.qd[-3:].any()
    assert sample.qdd[-3].all()
    with pytest.raises(InputError, match="nothing to compare; found 0 states"):
        draw(robot, 0, 0, np.dtype(np.float64))


def test_very_wide_limits_are_drawn_from_the_middle() -> None:
    robot = random_robot(1, joints=3)
    huge = Fraction(10**308)
    ranges = [(-huge, huge), (Fraction(5), huge), (Fraction(10**7), 17 * huge)]
    links = tuple(
        replace(link, joint=replace(link.joint, limits=Limits(position, huge, huge)))
        for link, position in zip(robot.links, ranges, strict=True)
    )
    sample = draw(replace(robot, links=links), 500, 0, np.dtype(np.float64))
    q = sample.q[:-4]
    assert -1000 <= q[:, 0].min() < -900
    assert 900 < q[:, 0].max() <= 1000
    assert 5 <= q[:, 1].min() < 20
    assert 900 < q[:, 1].max() <= 1000
    assert (q[:, 2] == 1e7).all()
    for rates in (sample.qd, sample.qdd):
        assert 0.9e6 < np.abs(rates).max() <= 1e6
