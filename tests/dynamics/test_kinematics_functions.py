"""Poses, Jacobians and their rates: identities between them, exactly, and wrong formulas."""

from __future__ import annotations

from collections.abc import Sequence

from robodyn.ir.program import Program
from robodyn.kernels.generate import Options, generate
from robodyn.robot import read_text
from robodyn.robot.bundled import load
from robodyn.robot.model import Robot

#: An arm on a wall, with parallel joints, one of them upside down, a slide, a name and a tool.
ARM = """\
name: on_a_wall
base: {xyz: [0.1, -0.2, 1], rpy: [0, pi/2, 0.3]}
tool: {xyz: [0.02, 0, 0.1], rpy: [0, 0, 0.7]}
gravity: [0, 0, -9.81]
links:
  - {joint: revolute, d: 0.3, mass: 1}
  - {joint: revolute, alpha: -pi/2, a: 0.1, mass: 1}
  - {joint: revolute, alpha: pi, a: reach, d: 0.05, theta: pi/2, mass: 1}
  - {joint: prismatic, alpha: 0.4, a: 0.2, d: 0.1, mass: 1}
  - {joint: revolute, alpha: pi/2, d: 0.2, theta: 0.3, mass: 1}
"""
NAMES = ("forward_kinematics", "link_poses", "jacobian", "tool_jacobian", "jacobian_dot_qd")


def programs(robot: Robot, names: Sequence[str] = NAMES) -> dict[str, Program]:
    unit = generate(robot, Options(functions=tuple(names), optimize="fast")).unit
    return {interface.function: program for interface, program in unit.functions}


def test_nothing_of_drives_is_in_it() -> None:
    """An arm whose drives have losses and play has the programs of the arm alone."""
    loss = "effects: [{effect: transmission_loss, breakaway: 0.1}, {effect: backlash, gap: 0.01}]"
    loaded = read_text(ARM.replace("theta: 0.3, mass: 1}", f"theta: 0.3, mass: 1, {loss}}}"))
    assert loaded.effects
    assert programs(loaded) == programs(read_text(ARM))


def test_the_head_speaks_of_no_formulation_where_there_is_none() -> None:
    robot = load("stanford_3dof", warn=lambda _: None)
    heads = [generate(robot, Options(functions=names)).unit.notes for names in (("jacobian",), ("gravity",))]
    assert heads[0] == ()
    assert heads[1][0].startswith("Formulation: ")
