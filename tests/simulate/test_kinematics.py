"""Kinematics against Pinocchio, differences and closed forms; the inverse of the PUMA; rotation vectors."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import angle
from robodyn.simulate.kinematics import Kinematics, rotation_vector
from robodyn.thesis.puma_inverse import BRANCHES, PumaArm
from robodyn_testing import require_module
from robodyn_testing.random_robots import random_robot

POINT = (0.1, -0.2, 0.3)
NAMES = ("puma560", "stanford", "ur10", "panda")  # the second has a prismatic joint


def arm(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def states(robot: Robot, count: int = 20) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    q, qd, qdd = np.random.default_rng(1).normal(size=(3, count, robot.n))
    return q, qd, qdd


@pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("above", [0, 2])
def test_pinocchio_agrees(name: str, above: int) -> None:
    pin = require_module("pinocchio")
    from peers.pinocchio_peer import pinocchio_model

    robot = arm(name)
    link = robot.n - above
    model = pinocchio_model(robot)
    tip = model.addFrame(
        pin.Frame("tip", link, 0, pin.SE3(np.eye(3), np.array(POINT)), pin.FrameType.OP_FRAME)
    )
    data = model.createData()
    kinematics = Kinematics(robot, point=POINT, link=link)
    q, qd, _ = states(robot)
    position, rotation = kinematics.pose(q)
    J, Jd = kinematics.jacobian(q), kinematics.jacobian_rate(q, qd)
    world = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    for k in range(len(q)):
        pin.computeJointJacobiansTimeVariation(model, data, q[k], qd[k])
        pin.updateFramePlacements(model, data)
        np.testing.assert_allclose(position[k], data.oMf[tip].translation, atol=1e-14)
        np.testing.assert_allclose(rotation[k], data.oMf[tip].rotation, atol=1e-14)
        np.testing.assert_allclose(J[k], pin.getFrameJacobian(model, data, tip, world), atol=1e-14)
        rate = pin.getFrameJacobianTimeVariation(model, data, tip, world)
        np.testing.assert_allclose(Jd[k], rate, atol=1e-13)


@pytest.mark.parametrize("seed", range(6))
def test_rates_are_derivatives(seed: int) -> None:
    """On arms with any twist: velocity, turning and the Jacobian's rate by central differences."""
    robot = random_robot(seed, joints=5, aside=0.5)
    if seed % 2:  # and with the base somewhere in the world
        rpy = (angle(Fraction(1, 3)), angle(Fraction(-1, 2)), angle(Fraction(2)))
        robot = replace(robot, base=Placement((Fraction(1), Fraction(2), Fraction(3)), rpy))
    kinematics = Kinematics(robot, point=POINT)
    q, qd, _ = states(robot)
    h = 1e-6
    (p1, R1), (p0, R0) = kinematics.pose(q + h * qd), kinematics.pose(q - h * qd)
    twist = np.einsum("kij,kj->ki", kinematics.jacobian(q), qd)
    np.testing.assert_allclose(twist[:, :3], (p1 - p0) / (2 * h), atol=1e-7)
    turning = ((R1 - R0) / (2 * h)) @ np.swapaxes(kinematics.pose(q)[1], 1, 2)
    np.testing.assert_allclose(twist[:, 3:], turning[:, [2, 0, 1], [1, 2, 0]], atol=1e-7)
    difference = (kinematics.jacobian(q + h * qd) - kinematics.jacobian(q - h * qd)) / (2 * h)
    np.testing.assert_allclose(kinematics.jacobian_rate(q, qd), difference, atol=1e-7)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"link": 7}, "puma560 has no such link; found link 7; expected 1 to 6"),
        ({"point": (0.0, 1.0)}, "a point is three numbers"),
    ],
)
def test_refuses(options: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=re.escape(message)):
        Kinematics(arm("puma560"), **options)  # type: ignore[arg-type]


def test_refuses_states() -> None:
    kinematics = Kinematics(arm("puma560"))
    with pytest.raises(InputError, match=re.escape("found [5]; expected [6] or [N, 6] each")):
        kinematics.position(np.zeros(5))
    with pytest.raises(InputError, match="not finite"):
        kinematics.position([0, 0, np.nan, 0, 0, 0])


OFFSET, UPPER, FOREARM = 0.127, 0.4318, 0.4318  # of the thesis's program D.1.3


def three_joints(offset: float, upper: float, thetas: tuple[float, float, float] = (0, 0, 0)) -> Robot:
    rows = ((0, 0, 0), ("-pi/2", 0, offset - 0.3), (0, upper, 0.3))
    links = "".join(
        f"  - {{joint: revolute, alpha: {alpha}, a: {a}, d: {d:.6f}, theta: {theta}, mass: 1}}\n"
        for (alpha, a, d), theta in zip(rows, thetas, strict=True)
    )
    return read_text(f"name: three\nlinks:\n{links}", "three.yaml")


@settings(deadline=None, max_examples=50)
@given(
    q=st.tuples(*[st.floats(-3.1, 3.1)] * 3),
    lengths=st.tuples(
        st.floats(-0.5, 0.5), st.floats(0.1, 1) | st.floats(-1, -0.1), st.floats(-1, 1), st.floats(-0.5, 0.5)
    ),
)
def test_every_branch_leads_to_the_point(
    q: tuple[float, float, float], lengths: tuple[float, float, float, float]
) -> None:
    offset, upper, forearm, elbow = (round(x, 6) for x in lengths)
    if math.hypot(forearm, elbow) < 0.05:
        forearm = 0.3
    thetas = (0.3, -1.0, 2.0)
    robot = three_joints(offset, upper, thetas)
    kinematics = Kinematics(robot, point=(elbow, -forearm, 0))
    target = kinematics.position(list(q))
    found = PumaArm.of(robot, point=(elbow, -forearm, 0)).positions(target)
    assert np.abs(kinematics.position(found) - target).max() < 1e-14
    assert (np.abs(found) <= math.pi + 1e-15).all()
    # One of the four is where the point came from (or as near as two that meet allow).
    assert np.abs(within_half_a_turn(found - np.array(q))).max(axis=1).min() < 1e-5
    bare = PumaArm(offset, upper, forearm, elbow).positions(target)  # the lengths alone say as much
    np.testing.assert_allclose(within_half_a_turn(bare - found - thetas), 0, atol=1e-12)


def within_half_a_turn(q: np.ndarray) -> np.ndarray:
    return q - 2 * math.pi * np.round(q / (2 * math.pi))


def test_start_of_the_thesis_simulation() -> None:
    """D.4 starts at x = 0.4, y = z = 0.1: minus root of q1 (a turn on), plus root of q3, and the
    point along +y of frame 3."""
    arms = PumaArm(OFFSET, UPPER, -FOREARM)
    found = arms.positions([0.4, 0.1, 0.1])[BRANCHES.index((-1, 1))]
    np.testing.assert_allclose(found, [3.69968 - 2 * math.pi, 2.30828, 0.59505], atol=5e-6)
    near = arms.continuous([[0.4, 0.1, 0.1]], (-1, 1), near=(3.7, 2.3, 0.6))
    np.testing.assert_allclose(near, [[3.69968, 2.30828, 0.59505]], atol=5e-6)


@pytest.mark.parametrize(("x", "z"), [(0.3, 0.5796), (0.4, 0.5486)])
def test_reach(x: float, z: float) -> None:
    PumaArm(OFFSET, UPPER, FOREARM).positions([[x, z, z], [x, -z, -z]])
    with pytest.raises(InputError, match=r"point 2 of 2.* m from the shoulder.*expected 0 to 0\.8636 m"):
        PumaArm(OFFSET, UPPER, FOREARM).positions([[x, z, z], [x, z + 1e-4, z + 1e-4]])
    with pytest.raises(InputError, match=r"0\.05 m from the axis of joint 1; expected at least 0\.127 m"):
        PumaArm(OFFSET, UPPER, FOREARM).positions([0.03, 0.04, 0.2])


def test_edge_of_reach_keeps_its_digits() -> None:
    """Stretched and folded, where a cosine would lose half the digits."""
    kinematics = Kinematics(three_joints(OFFSET, 0.5), point=(0, -0.3, 0))
    for bend in (0.0, math.pi, 1e-9, math.pi - 1e-9):
        q = [0.4, -0.7, bend + math.pi / 2]
        target = kinematics.position(q)
        found = PumaArm(OFFSET, 0.5, 0.3).positions(target)
        assert np.abs(kinematics.position(found) - target).max() < 1e-14


@pytest.mark.parametrize("branch", BRANCHES)
def test_continuous_goes_round(branch: tuple[int, int]) -> None:
    """Twice round the shoulder's axis: the first joint goes on beyond pi, the others come back."""
    angle = np.linspace(0, 4 * math.pi, 400)
    path = np.stack([0.5 * np.cos(angle), 0.5 * np.sin(angle), 0.1 + 0 * angle], axis=1)
    arms = PumaArm(OFFSET, UPPER, FOREARM)
    q = arms.continuous(path, branch)
    np.testing.assert_allclose(q[0], arms.positions(path[0])[BRANCHES.index(branch)])
    np.testing.assert_allclose(q[:, 0] - q[0, 0], angle, atol=1e-12)
    np.testing.assert_allclose(q[:, 1:] - q[0, 1:], 0, atol=1e-12)
    with pytest.raises(InputError, match=r"sample 2 of the path: joint 1 would jump; found 2\.11 rad"):
        arms.continuous(path[::67], branch)


@example((0.3, -0.5, 0.2), math.pi)
@example((0.3, -0.5, 0.2), math.pi - 1e-9)
@example((0.0, -0.5, 0.0), math.pi - 1e-12)
@example((0.3, -0.5, 0.2), 1e-9)
@given(st.tuples(*[st.floats(-1, 1)] * 3), st.floats(0, math.pi))
def test_rotation_vector(axis: tuple[float, float, float], angle: float) -> None:
    length = math.hypot(*axis)
    if length < 1e-3:
        return
    x, y, z = u = np.array(axis) / length
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    R = np.eye(3) + math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
    found = rotation_vector(R)
    if angle > math.pi - 1e-7 and found @ u < 0:
        found = -found  # half a turn about u is one about -u
    np.testing.assert_allclose(found, angle * u, atol=1e-9)
