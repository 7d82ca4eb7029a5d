"""Forward kinematics, Jacobian and its rate against Pinocchio, differences and exact rationals."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.robot import load
from robodyn.robot.model import Placement, Robot
from robodyn.robot.values import angle
from robodyn.simulate.kinematics import Kinematics
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


def test_one_state_is_a_row_of_many() -> None:
    kinematics = Kinematics(arm("stanford"), point=POINT)
    q, qd, _ = states(kinematics.robot, 3)
    origins, rotations = kinematics.frames(q)
    assert origins.shape == (3, 6, 3)
    for k in range(3):
        np.testing.assert_allclose(kinematics.position(q[k]), kinematics.position(q)[k], atol=1e-15)
        np.testing.assert_allclose(kinematics.jacobian(q[k]), kinematics.jacobian(q)[k], atol=1e-15)
        rate = kinematics.jacobian_rate(q[k], qd[k])
        np.testing.assert_allclose(rate, kinematics.jacobian_rate(q, qd)[k], atol=1e-14)
        np.testing.assert_allclose(kinematics.frames(q[k])[1], rotations[k], atol=1e-15)
        for one, other in zip(
            kinematics.pose_and_jacobian(q[k]),
            (*kinematics.pose(q[k]), kinematics.jacobian(q[k])),
            strict=True,
        ):
            np.testing.assert_array_equal(one, other)


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
