"""Poses of chains of axes."""

from __future__ import annotations

import math
import random

import pytest

from robodyn.formats.chain import (
    IDENTITY,
    Pose,
    about_axis,
    composed,
    cosine_and_sine,
    product,
    transposed,
    turned,
)


def random_pose(random_numbers: random.Random) -> Pose:
    xyz = [random_numbers.uniform(-1, 1) for _ in range(3)]
    return Pose.from_rpy(xyz, [random_numbers.uniform(-4, 4) for _ in range(3)])


def test_a_pose_and_its_inverse_are_the_identity() -> None:
    random_numbers = random.Random(1)
    for _ in range(20):
        pose = random_pose(random_numbers)
        nothing = composed(pose, pose.inverse())
        assert nothing.xyz == pytest.approx((0, 0, 0), abs=1e-15)
        for row, unit in zip(nothing.rotation, IDENTITY, strict=True):
            assert row == pytest.approx(unit, abs=1e-15)


def test_rpy_is_about_fixed_axes_x_first() -> None:
    roll, pitch, yaw = 0.3, -0.4, 0.5
    x, y, z = (about_axis(axis, a) for axis, a in zip(IDENTITY, (roll, pitch, yaw), strict=True))
    rotation = Pose.from_rpy((0, 0, 0), (roll, pitch, yaw)).rotation
    for row, expected in zip(rotation, product(z, product(y, x)), strict=True):
        assert row == pytest.approx(expected, abs=1e-15)


@pytest.mark.parametrize("text", ["1.57079632679", "-3.14159265359", "1.5707963267948966", "4.71238898038"])
def test_a_right_angle_in_twelve_digits_is_one(text: str) -> None:
    assert {abs(x) for x in cosine_and_sine(float(text))} == {0, 1}
    pose = Pose.from_rpy((0.1273, 12.93, -0.2), (float(text), 0, float(text)))
    assert set(map(abs, turned(pose.rotation, pose.xyz))) == {0.1273, 12.93, 0.2}


@pytest.mark.parametrize("angle", [1.5707963, 1.5708, 3.1415])
def test_a_right_angle_in_fewer_digits_stays_what_the_file_says(angle: float) -> None:
    assert cosine_and_sine(angle) == (math.cos(angle), math.sin(angle))


def test_a_quaternion_turns_like_its_axis_and_angle() -> None:
    half, axis = 0.35, (2 / 3, -1 / 3, 2 / 3)
    wxyz = (2 * math.cos(half), *(2 * math.sin(half) * x for x in axis))
    rotation = Pose.from_quaternion((0, 0, 0), wxyz).rotation
    for row, expected in zip(rotation, about_axis(axis, 2 * half), strict=True):
        assert row == pytest.approx(expected, abs=1e-15)
    for row, unit in zip(product(rotation, transposed(rotation)), IDENTITY, strict=True):
        assert row == pytest.approx(unit, abs=1e-15)


@pytest.mark.parametrize("wxyz", [(0, 0, 0, 0), (math.nan, 0, 0, 1), (math.inf, 0, 0, 1)])
def test_no_direction_of_no_quaternion(wxyz: tuple[float, ...]) -> None:
    with pytest.raises(ValueError, match="no direction"):
        Pose.from_quaternion((0, 0, 0), wxyz)
