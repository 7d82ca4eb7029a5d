"""Refitted numbers that come to one mass, and such that do not."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.one_body import one_body
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import Robot

ARM = load("puma560", warn=lambda _: None)


class Poses:
    """In the place of a gate: poses of a log."""

    def __init__(self, seed: int) -> None:
        q = np.random.default_rng(seed).uniform(-2, 2, (300, ARM.n))
        self.log = Log(np.arange(300) * 0.01, q, None, None, np.zeros_like(q))


def gates() -> Any:
    return [Poses(1)]


def heavier(robot: Robot, joint: int, mass: float, centre: tuple[float, float, float]) -> Robot:
    """``robot`` with a point mass at a link."""
    links = list(robot.links)
    link = links[joint - 1]
    m = float(link.mass)
    com = [(m * float(c) + mass * x) / (m + mass) for c, x in zip(link.com, centre, strict=True)]
    links[joint - 1] = replace(
        link, mass=Fraction(m + mass), com=(Fraction(com[0]), Fraction(com[1]), Fraction(com[2]))
    )
    return replace(robot, links=tuple(links))


@pytest.mark.parametrize("joint", [3, 4, 6])
def test_one_mass_is_one_mass(joint: int) -> None:
    body = one_body(ARM, heavier(ARM, joint, 3.0, (0.02, 0.05, 0.06)), gates())
    assert body is not None
    assert body.mass == pytest.approx(3.0, rel=0.15 if joint < 6 else 1e-3)
    assert body.link >= joint  # of links that do as well it is the outermost
    if joint == 6:
        assert body.explains > 0.999999
        assert body.centre[2] == pytest.approx(0.06, abs=1e-4)
    assert "heavier than described" in body.words()


def test_a_lighter_arm_is_lighter() -> None:
    body = one_body(ARM, heavier(ARM, 3, -2.0, (0.1, 0.0, 0.05)), gates())
    assert body is not None
    assert body.mass == pytest.approx(-2.0, rel=0.15)
    assert "lighter" in body.words()


def test_little_and_many_are_none() -> None:
    assert one_body(ARM, ARM, gates()) is None
    assert one_body(ARM, heavier(ARM, 6, 0.02, (0.0, 0.0, 0.0)), gates()) is None
    # Two that pull apart are not one.
    apart = heavier(heavier(ARM, 2, -6.0, (0.2, 0.0, 0.1)), 6, 3.0, (0.0, 0.0, 0.15))
    assert one_body(ARM, apart, gates()) is None
