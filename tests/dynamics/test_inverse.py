"""Inverse kinematics in closed form: every branch gives the pose again, and the positions are among them."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.functions import NoSuchFunction
from robodyn.dynamics.inverse import Inverse, inverse_of
from robodyn.formats.loading import load
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import Angle
from robodyn_testing import sampled
from robodyn_testing.arms import RigidArm
from robodyn_testing.nearly import SHAPES, nearly

UNIT = Fraction(1, 1 << 52)
#: Shapes that do not move the tool all ways as they are drawn, or are of no class.
REFUSED = {
    "slide_across", "gantry_and_wrist", "two_spheres", "elbow", "slide_across_place", "slides", "two_turns",
    "scara", "palletizer", "five", "planar", "eight",
}  # fmt: skip


def _inverse(robot: Robot) -> Inverse:
    limits = [link.joint.limits.position for link in robot.links]
    return inverse_of(build_arm(robot, lambda x: x, lambda name: name), limits)


def _apart(one: list[float], other: list[float]) -> float:
    return max(abs(math.remainder(x - y, math.tau)) for x, y in zip(one, other, strict=True))


def _robot(name: str) -> Robot:
    """The arm; one of three joints that ends on its last axis, with a tool."""
    robot = load(name)
    level = Angle(0.0, Fraction(1), Fraction(0), 0)
    tool = Placement((Fraction(1, 5), Fraction(-3, 10), Fraction(0)), (level, level, level))
    return replace(robot, tool=tool) if robot.n == 3 else robot


def _drawn(robot: Robot, rng: random.Random) -> list[float]:
    """Positions within the limits: the nearest solution is one that is within them."""
    ends = {"revolute": (-3, 3), "prismatic": (0.1, 1)}
    return [
        rng.uniform(*map(float, link.joint.limits.position or ends[link.joint.kind])) for link in robot.links
    ]


@pytest.mark.parametrize(
    ("name", "branches", "redundant"),
    [
        ("puma560", 8, None),
        ("stanford", 8, None),
        ("ur5", 8, None),
        ("panda", 8, 6),
        ("iiwa", 8, 2),
        ("tx40", 8, None),
        ("puma560_3dof", 4, None),
        ("stanford_3dof", 4, None),
    ],
)
def test_branches_give_the_pose_again_and_the_positions_are_among_them(
    name: str, branches: int, redundant: int | None
) -> None:
    robot = _robot(name)
    inverse = _inverse(robot)
    assert (inverse.branches, inverse.redundant) == (branches, redundant)
    check(robot, inverse, random.Random(name), 1e-13, 1e-9)


def check(robot: Robot, inverse: Inverse, rng: random.Random, closure: float, apart: float) -> None:
    """Every branch that exists gives the pose again, and one of them is where the pose is from."""
    tip, shape = RigidArm(robot).tip, (slice(3), slice(4) if robot.n > 3 else 3)
    for _ in range(10):
        q = _drawn(robot, rng)
        T = tip(np.array(q))
        near = [x + 1e-3 * (k != inverse.redundant) for k, x in enumerate(q)]
        solved = inverse.solve(list(T[:3].ravel()), near, UNIT)
        existing = [x for x, exists in zip(solved.solutions, solved.exists, strict=True) if exists]
        assert all(np.abs(tip(np.array(x))[shape] - T[shape]).max() < closure for x in existing)
        assert min(_apart(x, q) for x in existing) < apart
        best = inverse.nearest(list(T[:3].ravel()), near, UNIT)
        assert best.exists
        assert _apart(best.solution, q) < apart or closure > 1e-12


@pytest.mark.parametrize("shape", sampled(SHAPES, every=6))
def test_arms_of_any_numbers_are_solved_or_refused(shape: str) -> None:
    rng = random.Random(shape)
    robot = nearly(shape, 1, exactly=True)
    try:
        inverse = _inverse(robot)
    except NoSuchFunction:
        assert shape in REFUSED
        return
    check(robot, inverse, rng, 1e-11, 1e-6)


def test_out_of_reach_is_the_nearest_and_no_branch_exists() -> None:
    robot = _robot("puma560_3dof")
    solved = _inverse(robot).solve([1.0, 0, 0, 5.0, 0, 1, 0, 0, 0, 0, 1, 0], [0.0] * 3, UNIT)
    assert not any(solved.exists)
    assert all(math.isfinite(x) for q in solved.solutions for x in q)
    tip, rng = RigidArm(robot).tip, random.Random(1)
    off = [
        [np.linalg.norm(tip(np.array(q))[:3, 3] - [5, 0, 0]) for q in positions]
        for positions in (solved.solutions, [_drawn(robot, rng) for _ in range(1000)])
    ]
    assert min(off[0]) <= min(off[1])


def test_free_joints_stay_where_the_reference_has_them() -> None:
    robot = load("tx40")
    q = [0.3, -0.4, 1.1, 0.7, 0.0, -0.2]
    T = RigidArm(robot).tip(np.array(q))
    near = [0.3, -0.4, 1.1, 0.9, 0.0, -0.4]
    best = _inverse(robot).nearest(list(T[:3].ravel()), near, UNIT)
    assert best.singular
    assert best.solution == pytest.approx(near, abs=1e-7)
    assert np.abs(RigidArm(robot).tip(np.array(best.solution)) - T).max() < 1e-13


@pytest.mark.parametrize("name", ["sawyer", "so100", "g1_left"])
def test_arms_of_no_class_are_refused(name: str) -> None:
    with pytest.raises(NoSuchFunction, match="closed form"):
        _inverse(load(f"examples/arms/{name}.yaml"))
