"""A wrench on the tool is felt by bearings and gears, whose friction depends on the load."""

from __future__ import annotations

import numpy as np
import pytest

import robodyn
from robodyn.robot import read_text
from robodyn.verify import verify
from robodyn_testing import covering

ARM = """
name: arm
base: {xyz: [0.1, 0.2, 0.3], rpy: [0.3, -0.2, 0.5]}
tool: {xyz: [0.05, 0.1, 0.2], rpy: [0.4, 0.1, -0.3]}
links:
  - joint: revolute
    mass: 3
    com: [0.1, 0.02, 0.05]
    inertia: {xx: 0.02, yy: 0.03, zz: 0.04}
    effects: [EFFECT]
  - {joint: JOINT, alpha: 1.1, a: 0.4, theta: 0.3, mass: 2, com: [0.2, 0, 0], inertia: {yy: 0.1, zz: 0.1}}
"""
FUNCTIONS = ("inverse_dynamics_with_wrench", "bias_with_wrench", "gravity_with_wrench")
EFFECTS = (
    "{effect: transmission_loss, efficiency: 0.7, breakaway: 0.4}",
    "{effect: transmission_loss, efficiency: [[0, 0.5], [0.5, 0.8], [1, 0.9]], rated_torque: 20}",
    "{effect: load_dependent_friction, bearing: journal, mu: 0.1, radius: 0.05, span: 0.2}",
    "{effect: load_dependent_friction, bearing: thrust, mu: 0.1, radius: 0.05}",
    "{effect: load_dependent_friction, bearing: torque, mu: 0.1}",
    "{effect: torque_ripple, amplitude: 1, cycles_per_rev: 3}",
)


@pytest.mark.parametrize(("effect", "joint"), covering(EFFECTS, ["revolute", "prismatic"]))
def test_what_bears_the_wrench_rubs(effect: str, joint: str) -> None:
    """Beside Newton-Euler that begins with the wrench at the tool, every drive at the load that passes it."""
    robot = read_text(ARM.replace("EFFECT", effect).replace("JOINT", joint))
    kernel = robodyn.compile(robot, functions=FUNCTIONS, mode="abi", flags=("-O0",))
    report = verify(robot, kernel, states=20)
    assert {comparison.function for comparison in report.comparisons} == set(FUNCTIONS)
    assert report.passed, report.to_text()


@pytest.mark.thorough
def test_a_gear_loses_by_the_wrench_as_well() -> None:
    """One joint that lifts: the motor's torque is the load's over the efficiency, whatever the load is."""
    text = "name: hoist\ngravity: [0, 0, 0]\nlinks: [{joint: prismatic, mass: 1, effects: [%s]}]"
    robot = read_text(text % "{effect: transmission_loss, efficiency: 0.5}")
    kernel = robodyn.compile(robot, functions=("bias_with_wrench",))
    push = np.array([0, 0, -10.0, 0, 0, 0])
    assert kernel.bias_with_wrench([0.0], [1.0], push).tolist() == [20.0]
    assert kernel.bias_with_wrench([0.0], [-1.0], push).tolist() == [5.0]
