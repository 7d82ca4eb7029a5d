"""Inverse kinematics by iteration: it comes to poses, stays within limits, and says where it does not."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from robodyn.dynamics.inverse import Numerical
from robodyn.dynamics.inverse.descent import rotation_between
from robodyn.errors import InputError
from robodyn.ir import Input, Program
from robodyn.ir.evaluate import REAL_FUNCTIONS, evaluate
from robodyn.ir.program import Operation
from robodyn.kernels.generate import Options, generate
from robodyn.kernels.proof import closes
from robodyn.optimize.programs import Choice, build, inverse_kinematics_of
from robodyn.robot import read_text
from robodyn.robot.model import Robot
from robodyn.simulate.kinematics import Kinematics, rotation_vector

Floats = NDArray[np.float64]
VECTORS: dict[str, Callable[..., Any]] = {
    **REAL_FUNCTIONS,
    "sin": np.sin,
    "cos": np.cos,
    "sqrt": np.sqrt,
    "abs": np.abs,
}


@cache
def arm(n: int, limit: float = 2.5) -> Robot:
    """An arm of no class, of ``n`` joints."""
    text = f"name: odd{n}\nlinks:\n"
    for k in range(n):
        text += (
            f"  - {{joint: revolute, alpha: {(0.3, 1.2, -0.9, 1.4, -1.1)[k % 5]}, a: 0.{2 + k % 3}, d: 0.1, "
        )
        text += f"mass: 1, limits: {{position: [{-limit}, {limit}]}}}}\n"
    return read_text(text, "odd.yaml")


@cache
def nearest(robot: Robot) -> Program:
    return build(robot, "nearest_inverse_kinematics", Choice())


def poses(robot: Robot, q: Floats) -> Floats:
    p, R = Kinematics(robot).pose(q)
    return np.concatenate([R, p[:, :, None]], axis=2).reshape(-1, 12)


def solved(robot: Robot, T: Floats, near: Floats) -> tuple[Floats, Floats, Floats]:
    """Positions [K, n], exists [K], singular [K]."""
    inputs = {Input("T", k): x for k, x in enumerate(T.T)}
    inputs |= {Input("q_near", k): x for k, x in enumerate(near.T)}
    with np.errstate(all="ignore"):
        results = evaluate(nearest(robot), inputs, functions=VECTORS)
    rows: list[Any] = [
        np.stack([np.broadcast_to(x, len(T)) for x in results[name]], axis=1)
        for name in ("solution", "solution_exists", "solution_singular")
    ]
    return rows[0], rows[1][:, 0], rows[2][:, 0]


def drawn(n: int, count: int = 60) -> tuple[Floats, Floats]:
    random = np.random.default_rng(n)
    q = random.uniform(-2.2, 2.2, (count, n))
    return q, q + random.uniform(-0.3, 0.3, q.shape)


@pytest.mark.parametrize("n", [6, 7, pytest.param(4, marks=pytest.mark.thorough), 5])
def test_poses_near_the_reference_are_reached(n: int) -> None:
    robot = arm(n)
    q, near = drawn(n)
    T = poses(robot, q)
    solution, exists, _ = solved(robot, T, near)
    assert exists.mean() > 0.95
    off = np.abs(poses(robot, solution) - T).max(axis=1)
    assert off[exists == 1].max() < 1e-12
    assert (off[exists == 0] > 1e-13).all()
    assert np.abs(solution).max() <= 2.5
    if n > 6:  # it does not move further than it has to
        assert np.linalg.norm(solution - near, axis=1).mean() < np.linalg.norm(q - near, axis=1).mean()
    elif n == 6:
        assert np.median(np.abs(solution - q).max(axis=1)) < 1e-12


def test_where_no_pose_is_reached_the_error_is_least() -> None:
    robot = arm(5)
    T = poses(robot, drawn(5, 10)[0])
    T[:, 3::4] += 0.05
    solution, exists, _ = solved(robot, T, drawn(5, 10)[1])
    assert (exists == 0).all()
    solver = inverse_kinematics_of(robot)
    assert isinstance(solver, Numerical)

    def error(q: Floats) -> Floats:
        now = poses(robot, q).reshape(-1, 3, 4)
        goal = T.reshape(-1, 3, 4)
        place = ((goal - now)[:, :, 3] / float(solver.size)) ** 2
        turn = 3 - np.einsum("kij,kij->k", goal[:, :, :3], now[:, :, :3])
        total: Floats = place.sum(axis=1) + turn
        return total

    inside = np.abs(solution).max(axis=1) < 2.4
    assert inside.sum() >= 5
    for joint in range(5):
        step = 1e-4 * np.eye(5)[joint]
        slope = (error(solution + step) - error(solution - step)) / 2e-4
        assert np.abs(slope[inside]).max() < 2e-3


def test_a_limit_is_not_crossed() -> None:
    tight, free = arm(6, 0.5), arm(6)
    q = np.full((1, 6), 0.4)
    q[0, 2] = 0.7
    T = poses(free, q)
    solution, exists, _ = solved(tight, T, np.full((1, 6), 0.3))
    assert exists[0] == 0
    assert np.abs(solution).max() == 0.5
    assert solved(free, T, np.full((1, 6), 0.3))[1][0] == 1


def test_singular_poses_are_said_to_be() -> None:
    text = "name: straight\nlinks:\n"
    for a in (0, 0.5, 0.5, 0.4):
        text += f"  - {{joint: revolute, a: {a}, mass: 1}}\n"
    robot = read_text(text + "tool: {xyz: [0.3, 0, 0]}\n", "straight.yaml")
    q = np.array([[0.2, 0, 0, 0], [0.2, 0.5, -0.9, 0.4]])
    _, exists, singular = solved(robot, poses_with_tool(robot, q), q)
    assert exists.tolist() == [1, 1]
    assert singular.tolist() == [1, 1]  # four parallel axes never move it all ways


def poses_with_tool(robot: Robot, q: Floats) -> Floats:
    assert robot.tool is not None
    p, R = Kinematics(robot, point=[float(x) for x in robot.tool.xyz]).pose(q)
    return np.concatenate([R, p[:, :, None]], axis=2).reshape(-1, 12)


def test_no_pose_gives_what_is_no_number() -> None:
    robot = arm(6)
    T = np.full((2, 12), np.nan)
    T[1] = 1e300
    solution, exists, _ = solved(robot, T, np.zeros((2, 6)))
    assert np.isfinite(solution).all()
    assert (exists == 0).all()


@pytest.mark.parametrize("angle", [0.0, 1e-9, 0.4, 2.0, 3.1, math.pi - 1e-9, math.pi])
def test_the_rotation_that_is_missing(angle: float) -> None:
    for axis in np.vstack([np.eye(3), -np.eye(3), np.random.default_rng(1).normal(size=(10, 3))]):
        u = axis / np.linalg.norm(axis)
        K = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
        R = np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
        vector = np.array(rotation_between(R.tolist()))
        expected = 2 * math.sin(angle / 2) * (rotation_vector(R) / angle if angle else u)
        if angle == math.pi:  # either way round
            expected = expected * np.sign(vector @ expected)
        np.testing.assert_allclose(vector, expected, atol=2e-8)


def test_proof_accepts_it_and_refuses_what_is_said_to_be_reached() -> None:
    robot = arm(5)
    program = nearest(robot)
    assert closes(robot, "nearest_inverse_kinematics", program)
    outputs = tuple(
        (name, (Fraction(1),) if name == "solution_exists" else row) for name, row in program.outputs
    )
    assert not closes(robot, "nearest_inverse_kinematics", dataclasses.replace(program, outputs=outputs))


@pytest.mark.thorough
def test_proof_refuses_steps_that_lead_nowhere() -> None:
    robot = arm(5)
    program = nearest(robot)
    assert program.iteration is not None
    step = program.iteration.step
    operations = list(step.operations)
    k = next(k for k, op in enumerate(operations) if op.op == "div")
    operations[k] = Operation("mul", operations[k].args, operations[k].label)
    wrong = dataclasses.replace(step, operations=tuple(operations), origin=None)
    broken = dataclasses.replace(program, iteration=dataclasses.replace(program.iteration, step=wrong))
    assert not closes(robot, "nearest_inverse_kinematics", broken)


@pytest.mark.thorough
def test_given_sines_are_of_other_functions() -> None:
    options = Options(trig="given", functions=("nearest_inverse_kinematics",))
    with pytest.raises(InputError, match=r"given sines and cosines .* only of straight-line code"):
        generate(arm(5), options)
