"""Ranges of a proof: read exactly, refused plainly."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest

from robodyn.certify import with_ranges
from robodyn.errors import InputError
from robodyn.robot import Robot, load, read_text
from robodyn.robot.values import PI

BARE = read_text("name: bare\nlinks: [{joint: revolute}, {joint: prismatic}, {joint: revolute}]")
PUMA = load("puma560", warn=lambda _: None)


def limits(robot: Robot) -> list[tuple[Any, Any, Any]]:
    joints = [link.joint.limits for link in robot.links]
    return [(limit.position, limit.velocity, limit.acceleration) for limit in joints]


def test_text_sets_all_joints_or_one_and_the_file_has_the_default() -> None:
    assert with_ranges(PUMA, None) == PUMA
    found = limits(with_ranges(BARE, "q=1, qd=3,qdd=10,q2=-1/4:1/3,qd3=0"))
    assert found == [((-1, 1), 3, 10), ((Fraction(-1, 4), Fraction(1, 3)), 3, 10), ((-1, 1), 0, 10)]
    low, high = limits(with_ranges(BARE, "q=pi,qd=3,qdd=10"))[0][0]
    assert low == -high
    assert abs(high - PI) < Fraction(1, 10**15)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("qd=3,qdd=10", "no limit of position at joints 1, 2, 3"),
        ("q=1,qd=3", "--ranges qdd=10"),
        ("q=1,qd=3,qdd=10,qd4=1", "found qd4; expected a joint from 1 to 3 of bare"),
        ("q=1,qd=3,qdd=-1", "a bound is below zero"),
        ("q=2:1,qd=3,qdd=1", "a range is empty"),
        ("q=1,qd=-1:3,qdd=1", "not the same to both sides"),
        ("q=__import__('os'),qd=1,qdd=1", "cannot be read"),
        ("q=1e999,qd=1,qdd=1", "cannot be read"),
        ("q=nan,qd=1,qdd=1", "cannot be read"),
        ("w=1", "something unknown; found 'w'"),
        ("q0=1", "something unknown"),
        ("3", "cannot be read; found '3'"),
        ("r.yaml", "cannot be read; found 'r.yaml'"),
        ("", "cannot be read"),
    ],
)
def test_bad_text_is_told(text: str, words: str) -> None:
    with pytest.raises(InputError) as caught:
        with_ranges(BARE, text)
    assert words in str(caught.value)
