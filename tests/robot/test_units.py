"""Degrees in the place of radians are doubted, with what to write instead."""

from __future__ import annotations

import pytest

from robodyn.errors import InputError
from robodyn.robot import read_text


def test_an_angle_in_degrees_is_doubted() -> None:
    told: list[str] = []
    read_text("name: arm\nlinks: [{joint: revolute, alpha: -90, theta: 2*pi}]", "arm.yaml", warn=told.append)
    assert told == [
        "arm.yaml:2:34: link 1: alpha = -90 rad is more than one turn; "
        "angles are in rad: write -90*pi/180 if degrees are meant"
    ]


def test_limits_in_degrees_are_doubted() -> None:
    text = "name: arm\nlinks:\n- {joint: revolute, limits: {position: [-180, 180]}}"
    told: list[str] = []
    limits = read_text(text, "arm.yaml", warn=told.append).links[0].joint.limits
    assert list(limits.position or ()) == [-180, 180]
    assert told == [
        "arm.yaml:3:40: link 1: limits: position: -180 to 180 rad are more than six turns; "
        "limits are in rad: write [-180*pi/180, 180*pi/180] if degrees are meant"
    ]
    with pytest.raises(InputError, match="more than six turns"):
        read_text(text, strict=True)
    read_text(text.replace("{joint", "{acknowledged: a winch, joint"))
    for other in ("[-6.28, 6.28]", "[-41.5, 41.5]", "[-1e6, 1e6]", "[-720*pi/180, 0]"):
        assert read_text(text.replace("[-180, 180]", other), strict=True).n == 1
    assert read_text(text.replace("revolute", "prismatic"), strict=True).n == 1


def test_whole_turns_are_taken_off_exactly() -> None:
    robots = [
        read_text(f"name: arm\nlinks: [{{joint: revolute, theta: {text}}}]", warn=lambda _: None)
        for text in ("0.25", "0.25 + 2*pi", "0.25 - 20000*pi")
    ]
    assert len({robot.links[0].joint.theta for robot in robots}) == 1


def test_what_is_far_beyond_a_turn_is_no_angle() -> None:
    with pytest.raises(InputError, match=r"^arm\.yaml:2:34: link 1: theta is no angle"):
        read_text("name: arm\nlinks: [{joint: revolute, theta: 1e12}]", "arm.yaml")
