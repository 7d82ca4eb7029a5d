"""Joints that follow others in a description: what they are in coordinates, written back, and refused."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

from robodyn.diagnose.run import diagnose
from robodyn.dynamics.arm import build_arm
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.identify.run import identify
from robodyn.logs.log import Log
from robodyn.robot.coupling import Circle, coupling_lines, transmission_of
from robodyn.robot.model import Coupling
from robodyn.robot.reader import read_text
from robodyn.robot.writer import to_yaml
from robodyn.verify.reference import Reference
from robodyn_testing.coupled_files import MIXED, PALLETIZER

ARM = "name: arm\nlinks:\n" + "".join(f"  - {{name: {name}, joint: revolute}}\n" for name in "abcd")


def coupled(*entries: str) -> str:
    return ARM + "couplings:\n" + "".join(f"  - {entry}\n" for entry in entries)


def refused(*entries: str) -> str:
    with pytest.raises(InputError) as caught:
        read_text(coupled(*entries), "arm.yaml")
    return str(caught.value)


def test_what_joints_are_in_the_coordinates() -> None:
    robot = read_text(
        coupled(
            "{joint: b, of: a, ratio: -2}", "{joint: d, of: b, offset: 1}", "{joint: d, of: c, ratio: 1/2}"
        )
    )
    at = transmission_of(robot)
    assert robot.commanded == at.commanded == (0, 2)
    assert [{k: float(g) for k, g in row.items()} for row in at.rows] == [
        {0: 1},
        {0: -2},
        {1: 1},
        {0: -2, 1: 0.5},
    ]
    assert list(map(float, at.offsets)) == [0, 0, 0, 1]
    assert [line.strip() for line in coupling_lines(robot)] == [
        "Coordinates, which arrays have an element for: a, c",
        "Joints that follow them:",
        "b = -2 a",
        "d = -2 a +0.5 c +1 rad",
    ]
    assert coupling_lines(robot.free) == []
    assert robot.free.commanded == (0, 1, 2, 3)


def test_an_offset_of_a_quarter_turn_is_one() -> None:
    at = transmission_of(
        read_text(coupled("{joint: b, of: a, offset: 0.3}", "{joint: c, of: b, offset: pi/2-0.3}"))
    )
    quarter = at.offsets[2]
    assert abs(quarter - Fraction(314159265358979323846264338328, 2 * 10**29)) < Fraction(1, 10**28)


@pytest.mark.parametrize("text", [PALLETIZER, MIXED])
def test_what_is_written_reads_back(text: str) -> None:
    robot = read_text(text)
    assert read_text(to_yaml(robot)) == robot


def test_circles_and_what_is_no_coupling_are_refused_with_their_place() -> None:
    assert "arm.yaml:8:20: coupling 1: of: there is no such link; found 'e'" in refused("{joint: a, of: e}")
    assert "arm.yaml:8:20: coupling 1: the joint follows itself" in refused("{joint: a, of: a}")
    twice = refused("{joint: a, of: b}", "{joint: a, of: b, ratio: 2}")
    assert "arm.yaml:9:20: coupling 2: the joint follows this one already" in twice
    assert "add the ratios up" in twice
    assert "coupling 1: ratio is 0" in refused("{joint: a, of: b, ratio: 0}")
    circle = refused("{joint: d, of: a}", "{joint: a, of: b}", "{joint: b, of: c}", "{joint: c, of: a}")
    assert "arm.yaml:9:5: coupling 2: joints follow each other in a circle; found a, b, c" in circle
    with pytest.raises(Circle, match="the joints 1, 2"):
        transmission_of(replace(read_text(ARM), couplings=(Coupling(1, 2), Coupling(2, 1))))


def test_who_does_not_know_of_couplings_refuses_them() -> None:
    robot = read_text(PALLETIZER)
    t, zero = np.linspace(0, 1, 50), np.zeros((50, 4))
    log = Log(t, zero, zero, zero, zero)
    for of_joints in (
        lambda: build_arm(robot, float, float),
        lambda: Reference(robot),
        lambda: diagnose(robot, [log]),
        lambda: identify(robot, [log]),
        lambda: inspect(log, robot),
    ):
        with pytest.raises(InputError, match=re.escape("cannot do joints that follow others yet")):
            of_joints()
