"""Standard DH rows as they are read: exact numbers, names, effects (their torques: tests/independent)."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from robodyn.robot import Inertia, read_text
from robodyn.robot.values import parameter
from robodyn_testing import exactly


def test_effects_of_a_standard_arm() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: 1, mass: 1, com: [0, 0, 1],\n"
        "     effects: [{effect: inertial_error, delta_com_y: dy}, {effect: spring, stiffness: 2}]}\n"
        "effects: [{effect: payload, mass: m, com: [0, y, 0], inertia: {yy: 1}}]\n"
    )
    spring, payload = robot.effects
    assert robot.links[0].com == exactly(1, -1, parameter("dy"))  # an error is one of the standard row
    assert spring["stiffness"] == 2
    assert payload["com"] == (1, 0, parameter("y"))
    assert payload["inertia"] == Inertia(zz=Fraction(1))


def test_names_go_through() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: reach, mass: m, com: [x, y, z], inertia: {yy: j}}\n"
        "  - {joint: revolute, alpha: 0.3, mass: 1, com: [0, y, 1]}\n"
    )
    first, second = robot.links
    reach, x, y, z, j = map(parameter, ("reach", "x", "y", "z", "j"))
    assert second.joint.a == reach
    assert first.com == (reach + x, -z, y)
    assert first.inertia == Inertia(zz=j)
    sine, cosine = (Fraction(repr(float(f(0.3)))) for f in (np.sin, np.cos))
    assert second.com[1] == y * cosine - sine
    assert robot.parameters == ("m", "reach", "x", "z", "y", "j")


def test_right_angles_stay_exact_and_others_are_doubles() -> None:
    robot = read_text(
        "name: arm\nconvention: sdh\nlinks:\n"
        "  - {joint: revolute, alpha: pi/2, a: 1/3, mass: 1, com: [1/3, 1/7, 0]}\n"
        "  - {joint: revolute, alpha: pi/3, a: 0.1, mass: 1, com: [1/3, 0.1, 0]}\n"
    )
    assert robot.links[0].com == exactly(Fraction(2, 3), 0, Fraction(1, 7))
    assert robot.links[1].com[2] == Fraction(repr(float(np.sin(np.pi / 3) * 0.1)))
