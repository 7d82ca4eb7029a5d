"""Inverse kinematics in closed form: every branch gives the pose again, and the positions are among them."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.dynamics.arm import build_arm
from robodyn.dynamics.functions import NoSuchFunction
from robodyn.dynamics.inverse import Inverse, inverse_of
from robodyn.formats.loading import load
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import Angle
from robodyn.verify.numbers import exact_value

UNIT = Fraction(1, 1 << 52)


def _inverse(robot: Robot) -> Inverse:
    limits = [link.joint.limits.position for link in robot.links]
    return inverse_of(build_arm(robot, lambda x: x, lambda name: name), limits)


def _pose(robot: Robot, q: list[float]) -> NDArray[np.float64]:
    """The tool's frame [4, 4], by products of transforms [4, 4] of the description's rows."""

    def placed(place: Placement | None) -> NDArray[np.float64]:
        T = np.eye(4)
        if place is not None:
            T[:3, :3] = np.array(place.rotation, dtype=np.float64)
            T[:3, 3] = np.array(place.xyz, dtype=np.float64)
        return T

    T = placed(robot.base)
    for link, x in zip(robot.links, q, strict=True):
        joint = link.joint
        turn, out = (x, 0.0) if joint.kind == "revolute" else (0.0, x)
        c, s = math.cos(joint.theta.radians + turn), math.sin(joint.theta.radians + turn)
        e, f = float(joint.alpha.cos), float(joint.alpha.sin)
        a, b, d = (float(exact_value(x, {})) for x in (joint.a, joint.b, joint.d))
        T = T @ np.array(
            [
                [c, -s, 0, a],
                [e * s, e * c, -f, e * b - f * (d + out)],
                [f * s, f * c, e, f * b + e * (d + out)],
                [0, 0, 0, 1],
            ]
        )
    return T @ placed(robot.tool)


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
    rng = random.Random(name)
    for _ in range(10):
        q = _drawn(robot, rng)
        T = _pose(robot, q)
        solved = inverse.solve(list(T[:3].ravel()), q, UNIT)
        distances = []
        for solution, exists in zip(solved.solutions, solved.exists, strict=True):
            if not exists:
                continue
            again = _pose(robot, solution)
            shape = (slice(3), slice(4) if robot.n > 3 else 3)
            assert np.abs(again[shape] - T[shape]).max() < 1e-13
            distances.append(_apart(solution, q))
        assert min(distances) < 1e-9
        best = inverse.nearest(list(T[:3].ravel()), [x + 1e-3 for x in q] if redundant is None else q, UNIT)
        assert best.exists
        assert _apart(best.solution, q) < 1e-9


def _text(rows: list[tuple[str, str, float, float, str]]) -> str:
    """A description of joints by kind, alpha, a, d and theta, with an uncommon base and tool."""
    links = "".join(
        f"  - {{joint: {kind}, alpha: {alpha}, a: {a}, d: {d}, theta: {theta}, mass: 1, com: [0, 0, 0], "
        "inertia: {xx: 1, yy: 1, zz: 1}}\n"
        for kind, alpha, a, d, theta in rows
    )
    return (
        "name: arm\ngravity: [0, 0, -9.81]\nbase: {xyz: [0.3, 0.1, 0.2], rpy: [0.4, 0.2, 0]}\n"
        "tool: {xyz: [0.1, 0.05, 0.2], rpy: [0.3, 0.2, pi/2]}\nlinks:\n" + links
    )


def _row(rng: random.Random, kind: str) -> tuple[str, str, float, float, str]:
    alpha, theta = rng.choice(["0", "pi/2", "-pi/2", "pi", "pi/3"]), rng.choice(["0", "pi/2", "0.4"])
    return kind, alpha, rng.choice([0, 0, 0.3]), rng.choice([0, 0.1, 0.4]), theta


def _drawn_arm(rng: random.Random) -> list[tuple[str, str, float, float, str]]:
    """Few joints; or three before a wrist of any angles; or three parallel axes in one or the other sense."""
    kinds = [rng.choice(["revolute", "prismatic"]) for _ in range(3)]
    turn = "revolute"
    case = rng.randrange(3)
    if case == 0:
        return [_row(rng, kind) for kind in kinds[: rng.randint(1, 3)]]
    if case == 1:
        wrist = [(turn, rng.choice(["pi/2", "-pi/2", "pi/3"]), 0.0, 0.0, "0.3") for _ in range(2)]
        return [*(_row(rng, kind) for kind in [*kinds, turn]), *wrist]
    parallel = [(turn, rng.choice(["0", "pi"]), 0.4 - 0.05 * k, 0.1 * k, "0.2") for k in range(2)]
    across = [(turn, rng.choice(["pi/2", "-pi/2", "pi/3"]), 0.05, 0.1, "0") for _ in range(2)]
    last = (turn, rng.choice(["pi/2", "-pi/2", "pi/4"]), 0.0, 0.1, "0")
    return [(turn, "0", 0.0, 0.2, "0"), across[0], *parallel, across[1], last]


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(40))
def test_arms_of_any_numbers_are_solved_or_refused(seed: int, tmp_path: Path) -> None:
    rng = random.Random(seed)
    solved_arms = 0
    for _ in range(6):
        file = tmp_path / "arm.yaml"
        file.write_text(_text(_drawn_arm(rng)), encoding="utf-8")
        robot = load(str(file))
        try:
            inverse = _inverse(robot)
        except NoSuchFunction:
            continue
        solved_arms += 1
        for _ in range(5):
            q = _drawn(robot, rng)
            T = _pose(robot, q)
            solved = inverse.solve(list(T[:3].ravel()), q, UNIT)
            existing = [x for x, exists in zip(solved.solutions, solved.exists, strict=True) if exists]
            shape = (slice(3), slice(4) if robot.n > 3 else 3)
            assert all(np.abs(_pose(robot, x)[shape] - T[shape]).max() < 1e-11 for x in existing)
            assert min(_apart(x, q) for x in existing) < 1e-6
    assert solved_arms


def test_out_of_reach_is_the_nearest_and_no_branch_exists() -> None:
    robot = _robot("puma560_3dof")
    solved = _inverse(robot).solve([1.0, 0, 0, 5.0, 0, 1, 0, 0, 0, 0, 1, 0], [0.0] * 3, UNIT)
    assert not any(solved.exists)
    assert all(math.isfinite(x) for q in solved.solutions for x in q)
    nearest = min(np.linalg.norm(_pose(robot, q)[:3, 3] - [5, 0, 0]) for q in solved.solutions)
    rng = random.Random(1)
    assert nearest <= min(
        np.linalg.norm(_pose(robot, _drawn(robot, rng))[:3, 3] - [5, 0, 0]) for _ in range(1000)
    )


def test_free_joints_stay_where_the_reference_has_them() -> None:
    robot = load("tx40")
    q = [0.3, -0.4, 1.1, 0.7, 0.0, -0.2]
    T = _pose(robot, q)
    near = [0.3, -0.4, 1.1, 0.9, 0.0, -0.4]
    best = _inverse(robot).nearest(list(T[:3].ravel()), near, UNIT)
    assert best.singular
    assert best.solution == pytest.approx(near, abs=1e-7)
    assert np.abs(_pose(robot, best.solution) - T).max() < 1e-13


@pytest.mark.parametrize("name", ["sawyer", "so100", "g1_left"])
def test_arms_of_no_class_are_refused(name: str) -> None:
    with pytest.raises(NoSuchFunction, match="closed form"):
        _inverse(load(f"examples/arms/{name}.yaml"))
