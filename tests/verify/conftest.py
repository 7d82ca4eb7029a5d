"""Fixtures of this folder."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Literal

import pytest

from robodyn.robot.model import Robot
from robodyn_testing.random_robots import random_robot


@pytest.fixture(scope="module")
def arm() -> Robot:
    """Three joints, both kinds, nothing zero; rotor, friction on every joint."""
    robot = random_robot(4, joints=3, generic_angles=1.0, parallel=0.0, zeros=0.0, degenerate=0.0, exotic=0.0)
    links = []
    kinds: tuple[Literal["revolute", "prismatic"], ...] = ("revolute", "prismatic", "revolute")
    for link, kind in zip(robot.links, kinds, strict=True):
        drive = replace(
            link.joint,
            kind=kind,
            motor_inertia=Fraction(1, 3),
            viscous=Fraction(6, 5),
            coulomb=Fraction(7, 4),
        )
        links.append(replace(link, joint=drive))
    return replace(robot, links=tuple(links))
