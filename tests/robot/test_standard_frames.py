"""Standard DH beside its own product of matrices: poses, Jacobians, wrenches and solutions of the tool."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import robodyn
from robodyn.robot import read_text, to_yaml

Array = NDArray[np.float64]
#: joint, a, alpha, d, theta
ROWS = (
    ("revolute", 0.3, -math.pi / 2, 0.4, 0.2),
    ("prismatic", 0.1, 0.7, 0.2, -0.5),
    ("revolute", 0.5, 1.1, 0.1, 0.0),
    ("revolute", 0.25, -0.6, 0.05, 0.9),
)
TOOL = (0.1, -0.2, 0.3, 0.4, -0.3, 1.2)
BASE = (1.0, 2.0, 3.0, 0.1, 0.2, 0.3)
Q = np.array([0.3, 0.2, -0.8, 1.1])


def turn(axis: int, angle: float) -> Array:
    T = np.eye(4)
    i, j = ((1, 2), (2, 0), (0, 1))[axis]
    T[i, i] = T[j, j] = math.cos(angle)
    T[j, i], T[i, j] = math.sin(angle), -math.sin(angle)
    return T


def shift(x: float, y: float, z: float) -> Array:
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def frame(x: float, y: float, z: float, roll: float, pitch: float, yaw: float) -> Array:
    return shift(x, y, z) @ turn(2, yaw) @ turn(1, pitch) @ turn(0, roll)


def frames(q: Array, tool: tuple[float, ...] | None = TOOL) -> list[Array]:
    """The base's, one a link by standard DH, the tool's."""
    T = [frame(*BASE)]
    for (joint, a, alpha, d, theta), x in zip(ROWS, q, strict=True):
        slide = x if joint == "prismatic" else 0.0
        T.append(T[-1] @ turn(2, theta + x - slide) @ shift(a, 0, d + slide) @ turn(0, alpha))
    return [*T, T[-1] if tool is None else T[-1] @ frame(*tool)]


def jacobian(q: Array) -> Array:
    """Joint i moves along or about the z axis of frame i-1."""
    T = frames(q)
    columns = []
    for (joint, *_), before in zip(ROWS, T, strict=False):
        z = before[:3, 2]
        v = z if joint == "prismatic" else np.cross(z, T[-1][:3, 3] - before[:3, 3])
        columns.append([*v, *(np.zeros(3) if joint == "prismatic" else z)])
    return np.array(columns).T


def placement(key: str, x: tuple[float, ...]) -> str:
    return f"{key}: {{xyz: {list(x[:3])}, rpy: {list(x[3:])}}}\n"


def description(*more: str) -> str:
    links = "".join(
        f"  - {{joint: {j}, a: {a}, alpha: {alpha!r}, d: {d}, theta: {theta}, mass: 1, com: [1, 0.1, 0]}}\n"
        for j, a, alpha, d, theta in ROWS
    )
    return f"name: arm\nconvention: sdh\nlinks:\n{links}{placement('base', BASE)}{''.join(more)}"


@pytest.mark.parametrize("tool", [TOOL, None])
def test_frames_are_products_of_standard_matrices(tool: tuple[float, ...] | None) -> None:
    robot = read_text(description("" if tool is None else placement("tool", tool)))
    functions = ("forward_kinematics", "link_poses", "jacobian", "tool_jacobian", "wrench_torques")
    kernel = robodyn.compile(robot, functions=functions)
    _, *links, end = frames(Q, tool)
    np.testing.assert_allclose(kernel.forward_kinematics(Q), end[:3], atol=1e-14)
    places, rotations = kernel.link_poses(Q)
    np.testing.assert_allclose(places, [T[:3, 3] for T in links], atol=1e-14)
    np.testing.assert_allclose(rotations, [T[:3, :3] for T in links], atol=1e-14)
    if tool is None:
        return
    J, w = jacobian(Q), np.array([3.0, -2.0, 1.0, 0.3, 0.5, -0.7])
    np.testing.assert_allclose(kernel.jacobian(Q), J, atol=1e-14)
    back = end[:3, :3].T
    np.testing.assert_allclose(kernel.tool_jacobian(Q), np.vstack([back @ J[:3], back @ J[3:]]), atol=1e-14)
    np.testing.assert_allclose(kernel.wrench_torques(Q, w), J.T @ w, atol=1e-14)


def test_two_links_of_one_metre_reach_two() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, a: 1, alpha: pi/2, mass: 1, com: [-0.5, 0, 0]}\n"
        "  - {joint: revolute, a: 1, mass: 1, com: [-0.5, 0, 0]}\n"
    )
    kernel = robodyn.compile(robot, functions=("forward_kinematics",))
    assert kernel.forward_kinematics([0, 0])[:, 3].tolist() == [2, 0, 0]


def test_solutions_are_those_of_the_tool() -> None:
    """A standard PUMA with a flange: every solution leads back in standard matrices."""
    rows = [(0, math.pi / 2, 0.67), (0.43, 0, 0.15), (-0.02, -math.pi / 2, 0), (0, math.pi / 2, 0.43)]
    rows += [(0, -math.pi / 2, 0), (0.03, 0.4, 0.06)]
    links = "".join(
        f"  - {{joint: revolute, a: {a}, alpha: {alpha!r}, d: {d}, mass: 1, com: [0.1, 0, 0]}}\n"
        for a, alpha, d in rows
    )
    robot = read_text(f"name: puma\nconvention: sdh\nlinks:\n{links}")
    kernel = robodyn.compile(robot, functions=("inverse_kinematics",))

    def end(q: Array) -> Array:
        T = np.eye(4)
        for (a, alpha, d), x in zip(rows, q, strict=True):
            T = T @ turn(2, x) @ shift(a, 0, d) @ turn(0, alpha)
        return T

    goal = end(np.array([0.3, -0.8, 0.5, 1.2, 0.7, -0.4]))
    reached = kernel.inverse_kinematics(goal).reached
    assert len(reached) == 8
    for q in reached:
        np.testing.assert_allclose(end(q), goal, atol=1e-12)


def test_what_is_written_has_the_same_frames(tmp_path: Path) -> None:
    robot = read_text(description(placement("tool", TOOL)))
    again = read_text(to_yaml(robot))
    assert again == robot
    kernel = robodyn.compile(again, functions=("link_poses",))
    places, _ = kernel.link_poses(Q)
    np.testing.assert_allclose(places, [T[:3, 3] for T in frames(Q)[1:-1]], atol=1e-14)
