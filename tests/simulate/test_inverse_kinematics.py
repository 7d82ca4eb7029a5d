"""Inverse kinematics: the closed form of the PUMA; rotation vectors."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.model import Robot
from robodyn.simulate.kinematics import Kinematics, rotation_vector
from robodyn.thesis.puma_inverse import BRANCHES, PumaArm

OFFSET, UPPER, FOREARM = 0.127, 0.4318, 0.4318  # of the thesis's program D.1.3


def arm(name: str) -> Robot:
    return load(name, warn=lambda _: None)


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


def test_bundled_puma_and_others() -> None:
    robot = arm("puma560")
    wrist = Kinematics(robot, link=4)
    q = np.random.default_rng(0).uniform(-3, 3, (200, 6))
    target = wrist.position(q)
    found = PumaArm.of(robot).positions(target)
    for k in range(4):
        q[:, :3] = found[:, k]
        np.testing.assert_allclose(wrist.position(q), target, atol=1e-14)


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
