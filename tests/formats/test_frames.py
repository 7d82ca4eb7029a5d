"""Chains of axes in any direction as descriptions: torques, poses and lengths are those of the chain."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn import Options, program
from robodyn.counts import count
from robodyn.formats.arm import near_right_angles
from robodyn.formats.chain import Body, Chain, ChainJoint, Pose
from robodyn.formats.frames import description_of
from robodyn.robot import Robot, read_text, to_yaml
from robodyn.robot.model import Placement
from robodyn.robot.values import Value
from robodyn.simulate.kinematics import Kinematics
from robodyn.verify import Reference
from robodyn_testing import commit_seeds, require_module, sampled, seed_counts
from robodyn_testing.random_chains import pinocchio_model, random_chain, tip_poses

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
#: The corrections of a factory's calibration, as such arms have them: yaw, pitch, roll [rad], shifts [m].
DRIFT = 1e-4, 1e-3


def states(n: int, seed: int) -> tuple[Any, Any, Any]:
    rng = np.random.default_rng(seed)
    q, qd, qdd = (rng.uniform(-3, 3, (4, n)) for _ in range(3))
    q[0] = 0
    return q, qd, qdd


def tool_pose(robot: Robot, q: Any) -> Any:
    """Pose [N, 4, 4] of the tool's frame in the world."""
    place, turn = Kinematics(robot).pose(q)
    T = np.tile(np.eye(4), (len(q), 1, 1))
    T[:, :3, :3], T[:, :3, 3] = turn, place
    return T @ _matrix(robot.tool)


def _matrix(frame: Placement | None) -> Any:
    T = np.eye(4)
    if frame is not None:
        T[:3, :3] = [[float(x) for x in row] for row in frame.rotation]
        T[:3, 3] = [float(x) for x in frame.xyz]
    return T


def longest(robot: Robot) -> float:
    """The longest offset [m] of a joint."""
    joints = [link.joint for link in robot.links]
    return max(abs(float(x)) for j in joints for x in (j.a, j.b, j.d))  # type: ignore[arg-type]


def check_beside(chain: Chain, dynamics: Any, robot: Robot, seed: int = 0, tolerance: float = 1e-10) -> None:
    """Inverse dynamics, mass matrix and forward dynamics of ``dynamics`` beside Pinocchio's, and the tip."""
    pin = require_module("pinocchio")
    model = pinocchio_model(chain)
    data = model.createData()
    q, qd, qdd = states(len(chain.joints), seed)
    tau = np.array([pin.rnea(model, data, *x) for x in zip(q, qd, qdd, strict=True)])
    largest = np.abs(tau).max()
    np.testing.assert_allclose(dynamics.inverse_dynamics(q, qd, qdd), tau, rtol=0, atol=tolerance * largest)
    matrices = dynamics.mass_matrix(q)
    accelerations = dynamics.forward_dynamics(q, qd, tau)
    for k in range(len(q)):
        M = pin.crba(model, data, q[k])
        M = np.triu(M) + np.triu(M, 1).T
        np.testing.assert_allclose(matrices[k], M, rtol=0, atol=tolerance * np.abs(M).max())
        # What is left of the torques: where the matrix is ill conditioned, accelerations mean little.
        left = M @ (accelerations[k] - qdd[k])
        np.testing.assert_allclose(left, 0, rtol=0, atol=tolerance * (largest + np.abs(M @ qdd[k]).max()))
    np.testing.assert_allclose(tool_pose(robot, q), tip_poses(chain, q), rtol=0, atol=1e-10)


@pytest.mark.parametrize("count", seed_counts(10, 500))
def test_random_chains_are_what_pinocchio_makes_of_them(count: int) -> None:
    for seed in commit_seeds(count):
        chain = random_chain(seed)
        robot = description_of(chain)
        reach = sum(math.hypot(*joint.pose.xyz) for joint in chain.joints) + math.hypot(*chain.tool.xyz)
        assert longest(robot) <= 2 * reach
        check_beside(chain, Reference(robot), robot, seed)
        assert read_text(to_yaml(robot), warn=lambda _: None) == robot


# --- the same arm in other frames -------------------------------------------------------------------------


def test_decimals_and_zeros_survive() -> None:
    """Axes along y, origins where a file happened to put them: rows as one would write them by hand."""
    right = math.pi / 2
    chain = Chain(
        "arm",
        (
            ChainJoint("pan", "a", "revolute", Pose((0.0, 0.0, 0.1273))),
            ChainJoint("lift", "b", "revolute", Pose.from_rpy((0, 0.220941, 0), (0, right, 0)), Y),
            ChainJoint(
                "elbow", "c", "revolute", Pose((0.0, -0.1719, 0.612)), Y, Body(12.93, (0.0, 0.0, 0.28615))
            ),
            ChainJoint("wrist", "d", "revolute", Pose.from_rpy((0, 0.1149, 0.5723), (0, 1.57079632679, 0))),
        ),
        tool=Pose((0.0, 0.0, 0.0922)),
    )
    robot = description_of(chain)
    rows = [[getattr(link.joint, key) for key in ("a", "b", "d")] for link in robot.links]
    assert rows == [
        [0, 0, Fraction("0.1273")],
        [0, 0, 0],
        [Fraction("0.612"), 0, Fraction("0.163941")],
        [Fraction("0.5723"), 0, 0],
    ]
    assert [link.joint.alpha.quarter for link in robot.links] == [0, -1, 0, -1]
    assert [link.joint.theta.quarter for link in robot.links] == [0, 0, 0, 0]
    assert [link.name for link in robot.links] == ["pan", "lift", "elbow", "wrist"]
    elbow = robot.links[2]
    assert [elbow.mass, *elbow.com] == [Fraction("12.93"), Fraction("0.28615"), 0, Fraction("-0.1149")]
    assert robot.base is None
    assert robot.tool is not None
    assert list(robot.tool.xyz) == [0, 0, Fraction("0.0922")]


def test_a_base_that_is_turned() -> None:
    """A first axis that is not upright is the z axis of a base frame of its own."""
    chain = Chain("rail", (ChainJoint("slide", "a", "prismatic", Pose((0.0, 0.0, 1.5)), (1.0, 0.0, 0.0)),))
    robot = description_of(chain)
    (link,) = robot.links
    assert [link.joint.alpha.quarter, link.joint.a, link.joint.d] == [0, 0, 0]
    assert robot.base is not None
    assert list(robot.base.xyz) == [0, 0, Fraction("1.5")]
    assert [row[2] for row in robot.base.rotation] == [1, 0, 0]
    assert list(robot.gravity) == [0, 0, Fraction("-9.81")]
    assert robot.base_gravity[2] == 0


# --- nearly parallel axes ---------------------------------------------------------------------------------


def calibrated(seed: int) -> Chain:
    """A UR5e by its published numbers, each joint off by a calibration's 1e-4 to 1e-3 rad and 0.1 mm."""
    rng = np.random.default_rng(seed)
    right = math.pi / 2
    nominal = [
        ((0, 0, 0.1625), (0, 0, 0), 3.761, (0, -0.02561, 0.00193)),
        ((0, 0, 0), (right, 0, 0), 8.058, (-0.2125, 0, 0.11336)),
        ((-0.425, 0, 0), (0, 0, 0), 2.846, (-0.24225, 0, 0.0265)),
        ((-0.3922, 0, 0.1333), (0, 0, 0), 1.37, (0, -0.01634, -0.0018)),
        ((0, -0.0997, 0), (right, 0, 0), 1.3, (0, 0.01634, -0.0018)),
        ((0, 0.0996, 0), (-right, 0, 0), 0.365, (0, 0, -0.001159)),
    ]
    joints = []
    for i, (xyz, rpy, mass, com) in enumerate(nominal, 1):
        drift = rng.choice((-1, 1), 3) * 10 ** rng.uniform(math.log10(DRIFT[0]), math.log10(DRIFT[1]), 3)
        place = Pose.from_rpy((xyz + rng.normal(0, 1e-4, 3)).tolist(), (rpy + drift).tolist())
        body = Body(mass, com, (0.01, 0.02, 0.02, 0.0, 0.0, 0.0))
        joints.append(ChainJoint(f"joint_{i}", f"link_{i}", "revolute", place, body=body))
    return Chain("ur5e_calibrated", tuple(joints))


@pytest.mark.parametrize("seed", sampled(range(5), every=3))
def test_no_frame_of_a_calibrated_arm_is_far_away(seed: int) -> None:
    chain = calibrated(seed)
    robot = description_of(chain)
    assert longest(robot) < 0.5
    assert any(link.joint.b for link in robot.links)
    check_beside(chain, Reference(robot), robot)


# --- frames where numbers vanish ------------------------------------------------------------------------

BODY = Body(2.0, (0.01, 0.02, 0.03), (0.01, 0.02, 0.02, 0.001, 0.0, 0.0))


def checked(chain: Chain) -> Robot:
    robot = description_of(chain)
    check_beside(chain, Reference(robot), robot, tolerance=1e-12)
    return robot


def offsets(robot: Robot) -> list[list[Value]]:
    return [[link.joint.a, link.joint.b, link.joint.d] for link in robot.links]


def test_an_oblique_offset_between_parallel_axes_is_two_lengths_and_no_angle() -> None:
    """An elbow 20 mm beside the upper arm's axis."""
    chain = Chain(
        "arm",
        (
            ChainJoint("waist", "a", "revolute", body=BODY),
            ChainJoint("shoulder", "b", "revolute", Pose((0.0, 0.15, 0.0)), Y, BODY),
            ChainJoint("elbow", "c", "revolute", Pose((0.4318, 0.0, 0.0203)), Y, BODY),
            ChainJoint("wrist", "d", "revolute", Pose((0.0, 0.0, 0.4331)), Z, BODY),
        ),
    )
    robot = checked(chain)
    assert all(link.joint.theta.quarter is not None for link in robot.links)
    assert [abs(x) for x in offsets(robot)[2]] in [  # type: ignore[arg-type]
        [Fraction(one), Fraction(other), Fraction("0.15")]
        for one, other in (("0.4318", "0.0203"), ("0.0203", "0.4318"))
    ]


def test_a_gantry_has_no_offsets() -> None:
    chain = Chain(
        "gantry",
        tuple(
            ChainJoint(name, name, "prismatic", Pose(xyz), axis, BODY)
            for name, xyz, axis in (
                ("x", (0.1, 0.2, 1.3), X),
                ("y", (0.4, -0.2, 0.3), Y),
                ("z", (0.0, 0.7, -0.6), Z),
            )
        ),
        tool=Pose((0.0, 0.0, -0.2)),
    )
    robot = checked(chain)
    assert offsets(robot) == [[0, 0, 0]] * 3


def test_a_sliding_joint_has_its_line_through_the_next_axis() -> None:
    """A SCARA whose quill slides on a rail beside it: the rail's place costs nothing."""

    def quill(aside: float) -> Chain:
        return Chain(
            "scara",
            (
                ChainJoint("shoulder", "a", "revolute", body=BODY),
                ChainJoint("elbow", "b", "revolute", Pose((0.4, 0.0, 0.1)), Z, BODY),
                ChainJoint("lift", "c", "prismatic", Pose((0.3, aside, 0.2)), Z, BODY),
                ChainJoint("quill", "d", "revolute", Pose((0.05, -aside, -0.1)), Z, BODY),
            ),
        )

    robots = [checked(quill(aside)) for aside in (0.0, 0.08)]
    assert offsets(robots[0]) == offsets(robots[1])
    assert sum(x != 0 for row in offsets(robots[1]) for x in row) <= 3


# --- right angles in few digits ---------------------------------------------------------------------------


def test_right_angles_in_few_digits_are_listed_and_snapped() -> None:
    joints = [
        replace(
            joint, pose=replace(joint.pose, rotation=Pose.from_rpy((0, 0, 0), (way * 1.5708, 0, 0)).rotation)
        )
        for joint, way in zip(random_chain(12, 4).joints, (0, -1, 1, 1), strict=True)
    ]
    chain = Chain("arm", tuple(replace(j, kind="revolute", axis=Z) for j in joints))
    robot = description_of(chain)
    near = near_right_angles(robot)
    assert {(one.where, one.quarter) for one in near} >= {
        ("joint_2: alpha", -1),
        ("joint_3: alpha", 1),
        ("joint_4: alpha", 1),
    }
    assert all(3e-6 < abs(one.error) < 1e-4 for one in near)
    snapped = description_of(chain, snap=1e-4)
    assert near_right_angles(snapped) == ()
    assert [link.joint.alpha.quarter for link in snapped.links] == [0, -1, 1, 1]
    assert near_right_angles(description_of(chain), 1e-6) == ()
    fast = Options(optimize="fast")
    counts = [count(program(arm, "inverse_dynamics", fast)).total for arm in (snapped, robot)]
    assert counts[0] < counts[1]
    q = states(4, 2)[0]
    np.testing.assert_allclose(tool_pose(snapped, q), tip_poses(chain, q), rtol=0, atol=1e-4)
