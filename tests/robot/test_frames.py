"""Links that state poses: frames and torques are those of the poses, in Pinocchio's words (standard DH beside
its own matrices: tests/independent)."""

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


def test_two_links_of_one_metre_reach_two() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, a: 1, alpha: pi/2, mass: 1, com: [-0.5, 0, 0]}\n"
        "  - {joint: revolute, a: 1, mass: 1, com: [-0.5, 0, 0]}\n"
    )
    kernel = robodyn.compile(robot, functions=("forward_kinematics",))
    assert kernel.forward_kinematics([0, 0])[:, 3].tolist() == [2, 0, 0]


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
