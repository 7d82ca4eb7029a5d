"""Torques in front of the gears and currents: the joint torques, divided; refused where nothing is known."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn import InputError, Options, compile, program
from robodyn.robot import read_text
from robodyn.verify.check import verify

TEXT = """
name: geared
torque_side: {side}
links:
  - {{joint: revolute, alpha: pi/2, mass: 3, com: [0.1, 0.2, 0.3], inertia: {{xx: 1, yy: 1}},
      motor_inertia: 0.5, friction: {{viscous: 1.2}}, gear: {{ratio: 100, torque_constant: 0.12}}}}
  - {{joint: prismatic, alpha: pi/2, mass: 2, com: [0.1, 0.2, 0.3], gear: {{ratio: 250{constant}}}}}
"""
WHOLE = TEXT.format(side="motor", constant=", torque_constant: 0.05")


def test_torques_and_currents_of_the_motors() -> None:
    robot = read_text(WHOLE)
    kernel = compile(robot, functions=["inverse_dynamics", "motor_torque", "motor_current"])
    states = np.random.default_rng(2).uniform(-1, 1, (3, 20, 2))
    tau = kernel.inverse_dynamics(*states)
    np.testing.assert_allclose(kernel.motor_torque(*states), tau / [100, 250], rtol=1e-13)
    np.testing.assert_allclose(kernel.motor_current(*states), tau / [100 * 0.12, 250 * 0.05], rtol=1e-13)
    report = verify(robot, kernel, states=20)
    assert report.passed
    assert {"motor_torque", "motor_current"} <= {c.function for c in report.comparisons}


def test_drives_with_effects_have_them_too() -> None:
    text = WHOLE.replace(
        "- {joint: prismatic,", "- {joint: prismatic, effects: [{effect: spring, stiffness: 3}],"
    )
    kernel = compile(read_text(text), functions=["inverse_dynamics", "motor_current"])
    states = np.random.default_rng(2).uniform(-1, 1, (3, 20, 2))
    expected = kernel.inverse_dynamics(*states) / [100 * 0.12, 250 * 0.05]
    np.testing.assert_allclose(kernel.motor_current(*states), expected, rtol=1e-13)


@pytest.mark.parametrize(
    ("text", "function", "message"),
    [
        (
            TEXT.format(side="motor", constant=""),
            "motor_current",
            "no torque constant at joint 2; ",
        ),
        (
            TEXT.format(side="link", constant=""),
            "motor_torque",
            r"no gear at joint 1, 2; .* torque_side: mo",
        ),
    ],
)
def test_what_is_not_known(text: str, function: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        program(read_text(text), function, Options(optimize="fast"))
