"""Standard DH beside its own product of matrices: poses, Jacobians, wrenches and solutions of the tool. Links
that state poses: frames and torques are those of the poses, in Pinocchio's words."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from numpy.typing import NDArray

import robodyn
from robodyn.formats.chain import Body, Chain, ChainJoint, Pose
from robodyn.robot import Robot, read_text, to_yaml
from robodyn.robot.rewriting import rewritten
from robodyn.simulate.kinematics import Kinematics
from robodyn.verify import Reference
from robodyn_testing import exactly, require_module, sampled
from robodyn_testing.random_chains import pinocchio_model, tip_poses

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


def test_what_is_written_has_the_same_frames() -> None:
    robot = read_text(description(placement("tool", TOOL)))
    again = read_text(to_yaml(robot))
    assert again == robot
    kernel = robodyn.compile(again, functions=("link_poses",))
    places, _ = kernel.link_poses(Q)
    np.testing.assert_allclose(places, [T[:3, 3] for T in frames(Q)[1:-1]], atol=1e-14)


# --- poses in place of rows -------------------------------------------------------------------------------

RIGHT = math.pi / 2
AXES = ("xx", "yy", "zz", "xy", "xz", "yz")
COM, TENSOR = (0.1, -0.2, 0.3), (0.5, 0.6, 0.7, 0.01, -0.02, 0.03)


def drawn(seed: int) -> tuple[str, Chain]:
    """A description in poses, and the chain that it describes."""
    rng = random.Random(seed)
    lines, joints = [f"name: arm{seed}"], []
    base = Pose()
    if seed % 3:
        lines.append("base: {xyz: [1, 2, 3], rpy: [0.1, 0.2, 0.3]}")
        base = Pose.from_rpy((1, 2, 3), (0.1, 0.2, 0.3))
    lines.append("links:")
    body = f"mass: 2, com: {list(COM)}, inertia: {{{', '.join(map('{}: {}'.format, AXES, TENSOR))}}}"
    for i in range(4):
        xyz = [round(rng.uniform(-1, 1), 3) for _ in range(3)]
        rpy = [rng.choice([0.0, RIGHT, -RIGHT, 2 * RIGHT, rng.gauss(0, 1)]) for _ in range(3)]
        kind = "prismatic" if rng.random() < 0.25 else "revolute"
        lines.append(f"  - {{joint: {kind}, pose: {{xyz: {xyz}, rpy: {rpy}}}, {body}}}")
        pose = Pose.from_rpy(xyz, rpy)
        joints.append(
            ChainJoint(f"j{i}", f"l{i}", kind, pose, body=Body(2.0, COM, TENSOR))  # type: ignore[arg-type]
        )
    return "\n".join(lines), Chain("arm", tuple(joints), base=base)


def last_frame(robot: Robot, q: Array) -> Array:
    """Pose [N, 4, 4] of the last link's frame in the world."""
    place, turn = Kinematics(robot).pose(q)
    T = np.tile(np.eye(4), (len(q), 1, 1))
    T[:, :3, :3], T[:, :3, 3] = turn, place
    return T


@pytest.mark.parametrize("seed", sampled(range(12), every=3))
def test_poses_are_rows_in_other_words(seed: int) -> None:
    pin = require_module("pinocchio")
    text, chain = drawn(seed)
    robot = read_text(text)
    assert read_text(to_yaml(robot)) == robot
    model = pinocchio_model(chain)
    data = model.createData()
    rng = np.random.default_rng(seed)
    q, qd, qdd = (rng.uniform(-2, 2, (3, 4)) for _ in range(3))
    tau = np.array([pin.rnea(model, data, *x) for x in zip(q, qd, qdd, strict=True)])
    scale = np.abs(tau).max()
    np.testing.assert_allclose(Reference(robot).inverse_dynamics(q, qd, qdd), tau, rtol=0, atol=1e-13 * scale)
    np.testing.assert_allclose(last_frame(robot, q), tip_poses(chain, q), rtol=0, atol=1e-13)


def test_right_angles_are_exact_and_frames_turn_as_little_as_can_be() -> None:
    text = """
name: arm
links:
  - {joint: revolute, pose: {xyz: [0, 0, 0.4]}}
  - {joint: revolute, pose: {xyz: [0, 0.2, 0], rpy: [-pi/2, 0, 0]}, com: [x, y, 0], mass: 1}
  - {joint: revolute, pose: {xyz: [0.1, 0.2, 0.3], rpy: [0, pi/2, 0]}}
"""
    robot = read_text(text)
    one, two, three = (link.joint for link in robot.links)
    assert [one.d, two.a, two.b, two.d] == [Fraction(2, 5), 0, 0, Fraction(1, 5)]
    assert [one.theta.quarter, two.alpha.quarter] == [0, -1]
    # The third axis is the second's x: its row begins with a turn by a quarter, and the centre turns back.
    assert two.theta.quarter in (1, -1)
    assert robot.links[1].com[2] == 0
    assert {str(value.terms[0][0]) for value in robot.links[1].com[:2]} == {"x", "y"}  # type: ignore[union-attr]
    assert sorted(map(abs, (three.a, three.b, three.d))) == list(  # type: ignore[arg-type]
        exactly(Fraction(1, 10), Fraction(1, 5), Fraction(3, 10))
    )


def test_new_inertials_of_posed_links_are_written_anew() -> None:
    text, _ = drawn(1)
    robot = read_text(text)
    one, *rest = robot.links
    heavier = replace(robot, links=(replace(one, mass=Fraction(3)), *rest))
    assert "pose:" in rewritten(text, robot, heavier, [])
    moved = replace(robot, links=(replace(one, com=exactly(1, 2, 3)), *rest))
    anew = rewritten(text, robot, moved, [])
    assert "pose:" not in anew
    assert read_text(anew) == moved
