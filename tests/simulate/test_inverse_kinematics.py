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
from robodyn.simulate.inverse_kinematics import InverseKinematics
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


@pytest.mark.parametrize("name", ["puma560", "stanford", "ur10", "panda"])
@pytest.mark.parametrize("turned", [False, True])
def test_numerical_finds_what_can_be_reached(name: str, turned: bool) -> None:
    robot = arm(name)
    kinematics = Kinematics(robot, point=(0.1, -0.05, 0.2))
    search = InverseKinematics(kinematics)
    for q in np.random.default_rng(2).uniform(-1.5, 1.5, (5, robot.n)):
        point, rotation = kinematics.pose(q)
        found = search.solve(point, rotation if turned else None)
        place, turn = kinematics.pose(found)
        assert np.abs(place - point).max() < 1e-10
        assert not turned or np.abs(turn - rotation).max() < 1e-10
        np.testing.assert_array_equal(found, search.solve(point, rotation if turned else None))


def test_numerical_is_the_closed_form() -> None:
    robot = three_joints(OFFSET, UPPER)
    search = InverseKinematics(Kinematics(robot, point=(0, -FOREARM, 0)))
    for choice in PumaArm(OFFSET, UPPER, FOREARM).positions([0.3, 0.2, 0.4]):
        turns = np.array([2 * math.pi, 0, -4 * math.pi])
        found = search.solve([0.3, 0.2, 0.4], start=choice + 0.05 + turns)
        np.testing.assert_allclose(found, choice + turns, atol=1e-9)


def test_limits_hold() -> None:
    """The elbow may only bend one way: of the four branches those are found that do."""
    robot = three_joints(OFFSET, UPPER)
    kinematics = Kinematics(robot, point=(0, -FOREARM, 0))
    choices = PumaArm(OFFSET, UPPER, FOREARM).positions([0.3, 0.2, 0.4])
    room = np.array([9, 9, 0.3])
    for choice in choices:
        limits = np.stack([choice - room, choice + room], axis=1)
        search = InverseKinematics(kinematics, limits)
        found = search.solve([0.3, 0.2, 0.4], start=choices.mean(axis=0))
        assert (found >= limits[:, 0]).all()
        assert (found <= limits[:, 1]).all()
        assert np.abs(kinematics.position(found) - [0.3, 0.2, 0.4]).max() < 1e-10
    low, high = choices[:, 2].min() + 0.2, choices[:, 2].max() - 0.2
    search = InverseKinematics(kinematics, [[-9, 9], [-9, 9], [low, high]])
    with pytest.raises(InputError, match="cannot be reached; found an error of"):
        search.solve([0.3, 0.2, 0.4])
    with pytest.raises(InputError, match="no limits of joint positions"):
        InverseKinematics(kinematics, [[0, 1], [1, 0], [0, 1]])


def test_a_joint_at_its_limit_leaves_the_way_to_others() -> None:
    """Four joints in a plane, of which the first would do most of the way, and may not."""
    rows = "  - {joint: revolute, mass: 1}\n" + "  - {joint: revolute, a: 0.4, mass: 1}\n" * 3
    kinematics = Kinematics(read_text(f"name: plane\nlinks:\n{rows}", "plane.yaml"), point=(0.4, 0, 0))
    flat = kinematics.pose([0.1, 1.2, 0.5, -0.3])
    limits: list[list[float]] = [[-0.1, 0.1], *[[-3.0, 3.0]] * 3]
    search = InverseKinematics(kinematics, limits, starts=1)
    for point, rotation in (flat, (flat[0], None)):
        found = search.solve(point, rotation, start=[0.1, 0.1, 0.1, 0.1])
        assert -0.1 <= found[0] <= 0.1
        assert np.abs(kinematics.position(found) - point).max() < 1e-10


def test_answer_is_in_the_turn_of_the_start() -> None:
    """From a start where nothing pulls, another one finds it; the answer is put near the first."""
    robot = read_text("name: rod\nlinks:\n  - {joint: revolute, mass: 1}\n", "rod.yaml")
    search = InverseKinematics(Kinematics(robot, point=(0.5, 0, 0)))
    found = search.solve([0.5, 0, 0], start=[20 * math.pi + math.pi])
    assert abs(found[0] - 21 * math.pi) == pytest.approx(math.pi, abs=1e-8)


def test_best_error_is_the_distance() -> None:
    """Out of reach by 0.1 m: the best that can be done is to point there."""
    robot = read_text("name: rod\nlinks:\n  - {joint: revolute, mass: 1}\n", "rod.yaml")
    search = InverseKinematics(Kinematics(robot, point=(0.5, 0, 0)), starts=3)
    with pytest.raises(InputError, match=re.escape("found an error of 0.1 at best, from 3 starts")):
        search.solve([0, 0.6, 0])
    np.testing.assert_allclose(search.solve([0, 0.5, 0]), [math.pi / 2], atol=1e-9)


def test_along_follows_the_branch() -> None:
    arms = PumaArm(OFFSET, UPPER, FOREARM)
    search = InverseKinematics(Kinematics(three_joints(OFFSET, UPPER), point=(0, -FOREARM, 0)))
    path = np.linspace([0.4, 0.1, 0.1], [-0.2, 0.5, 0.2], 60)
    for branch in BRANCHES:
        q = arms.continuous(path, branch)
        np.testing.assert_allclose(search.along(path, start=q[0]), q, atol=1e-8)
    with pytest.raises(InputError, match=r"sample 57 of the path, .* cannot be reached"):
        search.along(np.linspace([0.4, 0.1, 0.1], [0.9, 0, 0], 60), start=arms.continuous(path)[0])


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
