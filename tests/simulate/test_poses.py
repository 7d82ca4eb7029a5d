"""Poses as they are written, and their solutions for arms with and without a closed form."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import pi
from pathlib import Path

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.model import Robot
from robodyn.simulate.pose_text import frame_of, frames_in, roll_pitch_yaw
from robodyn.simulate.poses import PoseSolver

QUARTER = np.array([[0.0, -1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 2.0], [0.0, 0.0, 1.0, 3.0]])


def odd_arm() -> Robot:
    """Six joints of no class, with a tool that is turned."""
    text = "name: odd\nlinks:\n"
    for k in range(6):
        text += f"  - {{joint: revolute, alpha: 0.{k + 3}, a: 0.{k + 1}, d: 0.2, mass: 1}}\n"
    return read_text(text + "tool: {xyz: [0.1, 0, 0.2], rpy: [0.3, 0, 0.1]}\n", "odd.yaml")


def test_three_ways_to_write_a_pose() -> None:
    rows: list[float] = QUARTER.ravel().tolist()
    for numbers in ([1, 2, 3, 0, 0, pi / 2], rows, [*rows, 0, 0, 0, 1]):
        np.testing.assert_allclose(frame_of(numbers), QUARTER, atol=1e-15)
    np.testing.assert_allclose(frame_of([1, 2, 3, 0, 0, 90], degrees=True), QUARTER, atol=1e-15)


@pytest.mark.parametrize("angles", [(0.3, -0.4, 2.0), (0.0, pi / 2, 0.5), (-3.0, 1.5, -3.1)])
def test_angles_there_and_back(angles: tuple[float, float, float]) -> None:
    R = frame_of([0, 0, 0, *angles])[:, :3]
    np.testing.assert_allclose(frame_of([0, 0, 0, *roll_pitch_yaw(R)])[:, :3], R, atol=1e-12)


def test_a_rotation_with_few_digits_is_the_nearest() -> None:
    R = frame_of([0, 0, 0, 0.3, -0.4, 2.0])
    rounded = frame_of(np.round(R, 5).ravel().tolist())[:, :3]
    assert np.abs(rounded @ rounded.T - np.eye(3)).max() < 1e-15
    assert np.abs(rounded - R[:, :3]).max() < 1e-5


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ([1, 2, 3], "not a pose; found 3 numbers; expected 6 numbers x y z roll pitch yaw"),
        ([1, 2, 3, 4, 5, float("nan")], "not finite"),
        ([*(2 * QUARTER).ravel()], "no rotation"),
        ([*QUARTER[[1, 0, 2]].ravel()], "no rotation"),
        ([*QUARTER.ravel(), 0, 0, 1, 1], "last row of a pose is wrong"),
    ],
)
def test_what_is_no_pose(numbers: list[float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        frame_of(numbers)


@pytest.mark.parametrize(
    ("file", "text", "count"),
    [
        ("poses.csv", "x,y,z,roll,pitch,yaw\n1,2,3,0,0,1.5707963267948966\n\n1,2,3,0,0,0\n", 2),
        ("poses.csv", ",".join(map(str, QUARTER.ravel())) + "\n", 1),
        ("poses.json", f"[{QUARTER.tolist()}, [1, 2, 3, 0, 0, 0]]", 2),
        ("poses.json", '{"poses": [[1, 2, 3, 0, 0, 1.5707963267948966]]}', 1),
        ("poses.json", "[1, 2, 3, 0, 0, 1.5707963267948966]", 1),
    ],
)
def test_files_of_poses(tmp_path: Path, file: str, text: str, count: int) -> None:
    (tmp_path / file).write_text(text, encoding="utf-8")
    frames = frames_in(tmp_path / file)
    assert frames.shape == (count, 3, 4)
    np.testing.assert_allclose(frames[0], QUARTER, atol=1e-15)


@pytest.mark.parametrize(
    ("file", "text", "message"),
    [
        ("a.csv", "1,2,3,0,0,0\n1,2,x,0,0,0\n", r"a.csv:2: .*something else than numbers; found .*'x'"),
        ("a.csv", "x,y\n", "there is no pose"),
        ("a.csv", "1,2,3,0,0,0\n1,2\n", r"a.csv:2: this is not a pose; found 2 numbers"),
        ("a.json", '{"frames": []}', "no list of poses"),
        ("a.json", '[[1, 2, 3, 0, 0, "x"]]', "pose 1 has something else than numbers"),
        ("a.json", "[[1, 2", "not JSON"),
    ],
)
def test_what_is_no_file_of_poses(tmp_path: Path, file: str, text: str, message: str) -> None:
    (tmp_path / file).write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match=message):
        frames_in(tmp_path / file)


@cache
def puma() -> PoseSolver:
    return PoseSolver(load("puma560", warn=lambda _: None))


@pytest.mark.thorough
def test_iteration_begins_elsewhere_where_the_reference_leads_nowhere() -> None:
    solver = PoseSolver(odd_arm())
    q = np.random.default_rng(1).uniform(-2, 2, (40, 6))
    posed = solver.solve(solver.pose(q))
    assert all(each.reached for each in posed)
    assert max(max(each.nearest.off) for each in posed) < 1e-11


def test_lengths_get_their_values_first() -> None:
    text = "name: lengthy\nlinks:\n"
    for alpha, a in ((0, 0), ("pi/2", 0), (0, "reach")):
        text += f"  - {{joint: revolute, alpha: {alpha}, a: {a}, mass: 1}}\n"
    solver = PoseSolver(read_text(text + "tool: {xyz: [0.4, 0, 0]}\n", "l.yaml"), {"reach": 0.5})
    assert solver.solver.place_only
    (posed,) = solver.solve(solver.pose(np.array([[0.1, 0.2, 0.3]])))
    assert len(posed.reached) == 4


def test_a_reference_of_another_length() -> None:
    with pytest.raises(InputError, match=r"no reference for 6 joints; found shape \[5\]"):
        PoseSolver(load("ur5", warn=lambda _: None)).solve(np.eye(3, 4)[None], np.zeros(5))


def test_joints_without_limits_stay_within_half_a_turn_out_of_reach() -> None:
    puma = load("puma560", warn=lambda _: None)
    joints = [replace(link.joint, limits=replace(link.joint.limits, position=None)) for link in puma.links]
    links = tuple(replace(link, joint=joint) for link, joint in zip(puma.links, joints, strict=True))
    (posed,) = PoseSolver(replace(puma, links=links)).solve(frame_of([1.2, -0.3, 13, 0, 1.57, 0])[None])
    assert not posed.nearest.exists
    assert np.abs(posed.nearest.q).max() <= np.pi
