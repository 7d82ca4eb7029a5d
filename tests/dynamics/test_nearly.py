"""Arms that are nearly of a class: all branches, closed to rounding, and what was neglected is said."""

from __future__ import annotations

import dataclasses
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.inverse import Inverse, Numerical
from robodyn.dynamics.inverse.numerical import idealised
from robodyn.dynamics.inverse.screws import chain_of
from robodyn.optimize.programs import inverse_kinematics_of
from robodyn.robot import load
from robodyn.robot.model import Robot
from robodyn.robot.values import angle
from robodyn.simulate.kinematics import drawn_between, position_limits
from robodyn.simulate.poses import PoseSolver

Floats = NDArray[np.float64]


def plain(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def with_a_rounded_twist(robot: Robot) -> Robot:
    """The arm with its third axis as far from parallel to the second as 1.5708 is from a quarter turn."""
    links = list(robot.links)
    joint = dataclasses.replace(links[2].joint, alpha=angle(Fraction("3.6732e-6")))
    links[2] = dataclasses.replace(links[2], joint=joint)
    return dataclasses.replace(robot, links=tuple(links))


def calibrated(robot: Robot, by: float) -> Robot:
    """The arm with twists [rad] and offsets [m] that are off ``by`` so much."""
    random = np.random.default_rng(3)
    links = []
    for link in robot.links:
        joint = link.joint
        off = [Fraction(round(x, 9)) for x in by * random.normal(size=3)]
        moved: dict[str, Any] = {"a": joint.a + off[1], "d": joint.d + off[2]}
        moved["alpha"] = angle(Fraction(joint.alpha.radians) + off[0])
        links.append(dataclasses.replace(link, joint=dataclasses.replace(joint, **moved)))
    return dataclasses.replace(robot, links=tuple(links))


CASES = {
    "rounded": lambda: with_a_rounded_twist(plain("ur5")),
    "calibrated": lambda: calibrated(plain("puma560"), 1e-4),
    "of seven joints": lambda: calibrated(plain("iiwa"), 1e-4),
    "with an offset wrist": lambda: calibrated(plain("panda"), 1e-4),
    "with a prismatic joint": lambda: calibrated(plain("stanford"), 1e-4),
}
QUICK = ("calibrated",)


@pytest.mark.parametrize(
    "case", [x if x in QUICK else pytest.param(x, marks=pytest.mark.thorough) for x in CASES]
)
def test_all_branches_are_there_and_close_to_rounding(case: str) -> None:
    robot = CASES[case]()
    solver = PoseSolver(robot)
    assert isinstance(solver.solver, Numerical)
    assert solver.solver.branches == 8
    low, high = drawn_between(robot, *position_limits(robot).T)
    q: Floats = np.random.default_rng(1).uniform(np.maximum(low, -3), np.minimum(high, 3), (100, robot.n))
    T = solver.pose(q)
    rows, usable = solver.branches(T, q)
    for row in range(8):
        here = usable[:, row]
        assert np.abs(solver.pose(rows[here, row]) - T[here]).max(initial=0.0) < 1e-11
    if solver.solver.redundant is not None:
        k = solver.solver.redundant
        assert (rows[:, :, k] == q[:, None, k]).all()
    apart = np.abs(2 * np.sin((rows - q[:, None]) / 2)).max(axis=2)
    assert ((apart < 1e-7) & usable).any(axis=1).mean() >= 0.95
    assert usable.sum(axis=1).mean() > 2


def test_what_is_neglected_is_said() -> None:
    conditions = inverse_kinematics_of(CASES["rounded"]()).conditions
    assert "axes 2, 3 and 4 are parallel, and axes 1 and 5 are not" in conditions
    assert "axes are up to 3.7e-06 rad from where that holds" in conditions
    moved = inverse_kinematics_of(CASES["calibrated"]()).conditions
    assert any("axes miss each other by up to 0.1" in words for words in moved)


@pytest.mark.parametrize("name", ["puma560", "ur5", "panda"])
def test_nothing_is_neglected_of_arms_that_are_of_a_class(name: str) -> None:
    arm = build_arm(plain(name), lambda x: x, lambda name: name)
    chain = chain_of(arm)
    similar, neglected = idealised(chain)
    assert neglected == ()
    assert [x.direction for x in similar.axes] == [x.direction for x in chain.axes]
    assert isinstance(inverse_kinematics_of(plain(name)), Inverse)


def test_an_arm_that_is_far_from_a_class_has_one_solution() -> None:
    solver = inverse_kinematics_of(calibrated(plain("puma560"), 1e-2))
    assert isinstance(solver, Numerical)
    assert solver.alone
    assert solver.branches == 1
