"""Arms made by rule: what growth is measured on, and that generation grows with the number of joints."""

from __future__ import annotations

import sys
from typing import Any

import pytest
from benchmarks.peers.family import family_text

from robodyn.counts import count
from robodyn.kernels.generate import Options, program
from robodyn.robot import Robot, read_text

FAST = Options(("inverse_dynamics",), optimize="fast")


def family(joints: int) -> Robot:
    return read_text(family_text(joints), warn=lambda _: None)


def test_operations_grow_by_the_same_with_every_joint() -> None:
    totals = [count(program(family(n), "inverse_dynamics", FAST)).total for n in (12, 15, 18, 30)]
    joint = (totals[1] - totals[0]) // 3
    assert totals == [totals[0] + joint * (n - 12) for n in (12, 15, 18, 30)]


def calls(joints: int) -> int:
    """How many Python functions a generation calls: what its time goes by, and the same on any machine."""
    robot = family(joints)
    made = 0

    def watch(frame: Any, event: str, argument: Any) -> None:
        nonlocal made
        made += event in ("call", "c_call")

    program(robot, "inverse_dynamics", FAST)  # what is remembered is remembered
    sys.setprofile(watch)
    try:
        program(robot, "inverse_dynamics", FAST)
    finally:
        sys.setprofile(None)
    return made


@pytest.mark.thorough
def test_generation_grows_with_the_number_of_joints() -> None:
    assert calls(30) <= 2.15 * calls(15)
