"""Solutions of inverse kinematics judged by the reference's forward kinematics."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from robodyn.arrays import Floats
from robodyn.dynamics.functions import function_named
from robodyn.robot import load
from robodyn.robot.model import Limits, Robot
from robodyn.simulate.kinematics import Kinematics
from robodyn.simulate.poses import PoseSolver
from robodyn.verify.poses import pose_errors
from robodyn.verify.reference import Reference
from robodyn.verify.sample import UNREACHABLE, draw, poses_of

DOUBLE = np.dtype(np.float64)
FUNCTION = function_named("inverse_kinematics")


def test_the_tool_where_the_arm_of_the_simulator_has_it() -> None:
    for name in ("stanford", "panda"):
        robot = load(name, warn=lambda _: None)
        q = draw(robot, 5, 1, DOUBLE).q
        np.testing.assert_allclose(Reference(robot).tool_pose(q), PoseSolver(robot).pose(q), atol=1e-15)
        place, _ = Kinematics(
            robot, point=[float(x) for x in robot.tool.xyz] if robot.tool else (0, 0, 0)
        ).pose(q[0])
        np.testing.assert_allclose(Reference(robot).tool_pose(q[0])[:, 3], place, atol=1e-15)


@cache
def sample() -> tuple[Robot, dict[str, Floats], dict[str, Floats]]:
    """An arm, poses, and right solutions of them."""
    robot = load("ur5", warn=lambda _: None)
    q = draw(robot, 24, 3, DOUBLE).q
    T = poses_of(Reference(robot), q, DOUBLE)
    solver = PoseSolver(robot)
    posed = [solver.solve(pose.reshape(1, 3, 4), near)[0] for pose, near in zip(T, q, strict=True)]
    every = [each.solutions for each in posed]
    results = {
        "solutions": np.array([np.concatenate([x.q for x in row]) for row in every]),
        **{
            flag: np.array([[float(getattr(x, flag)) for x in row] for row in every])
            for flag in ("exists", "within", "singular")
        },
    }
    results["solution_count"] = results["exists"].sum(axis=1, keepdims=True)
    return robot, {"q": q, "T": T}, results


def errors(**changed: Floats) -> Floats:
    robot, inputs, results = sample()
    return pose_errors(robot, Reference(robot), FUNCTION, {**results, **changed}, inputs, 1e-10, DOUBLE)


def at(name: str, place: tuple[int, ...], value: float) -> Floats:
    changed = sample()[2][name].copy()
    changed[place] = value
    return changed


def test_right_solutions_are_right() -> None:
    assert errors().max() < 1e-14


STATE = 10  # neither out of reach nor at rest


def existing() -> int:
    return int(np.argmax(sample()[2]["exists"][STATE]))


def test_a_wrong_position_is_measured() -> None:
    place = (STATE, 6 * existing())
    off = errors(solutions=at("solutions", place, sample()[2]["solutions"][place] + 1e-6))
    assert 1e-8 < off[STATE] < 1e-5
    assert np.delete(off, STATE).max() < 1e-14


@pytest.mark.parametrize(
    ("name", "place", "value"),
    [
        ("exists", (STATE,), 0.0),  # nothing is said to reach it
        ("exists", (UNREACHABLE - 1, 0), 1.0),
        ("exists", (STATE, 0), 0.5),
        ("within", (STATE, 0), 0.0),
        ("solutions", (STATE, 0), np.nan),
        ("solution_count", (STATE, 0), np.inf),
    ],
)
def test_what_is_wrong_and_has_no_size(name: str, place: tuple[int, ...], value: float) -> None:
    off = errors(**{name: at(name, place, value)})
    assert np.isinf(off[place[0]])
    assert np.isfinite(np.delete(off, place[0])).all()


def test_a_branch_that_is_missing_is_noticed() -> None:
    _, inputs, results = sample()
    apart = np.abs(results["solutions"][STATE].reshape(8, 6) - inputs["q"][STATE]).max(axis=1)
    off = errors(exists=at("exists", (STATE, int(np.argmin(apart))), 0.0))
    assert np.isinf(off[STATE])


def test_where_branches_meet_twice_they_are_told_apart_by_doubles_only() -> None:
    """An elbow that is nearly stretched and a wrist that nearly is: four branches within a tenth of a radian,
    all of which lead to the pose to within some 1e-6."""
    arm = load("panda", warn=lambda _: None)
    free = (replace(link, joint=replace(link.joint, limits=Limits())) for link in arm.links)
    robot = replace(arm, links=tuple(free))  # the branches are beyond the limits
    near = np.array([2.357533455, -2.08733058, -2.702033281, -0.474501967, 1.835986733, -1.745181441, 2.929])
    T = Reference(robot).tool_pose(near)
    rows = [x.q for x in PoseSolver(robot).solve(T[None], near)[0].solutions]
    gaps = np.abs(np.array(rows) - near).max(axis=1)
    other = rows[int(np.argmin(np.where(gaps < 1e-6, np.inf, gaps)))]
    assert 0.03 < np.abs(other - near).max() < 0.5
    results = {
        "solutions": np.array([other]),
        **{flag: np.ones((1, 1)) for flag in ("exists", "within")},
        "singular": np.zeros((1, 1)),
    }
    inputs = {"q": near[None], "T": T.reshape(1, 12)}
    judged = [
        pose_errors(robot, Reference(robot), FUNCTION, results, inputs, tolerance, DOUBLE)[0]
        for tolerance in (1e-5, 1e-10)
    ]
    assert judged[0] < 1e-14
    assert np.isinf(judged[1])
