"""Poses, Jacobians and their rates: identities between them, exactly, and wrong formulas."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from robodyn.ir.evaluate import evaluate_exact
from robodyn.ir.program import Input, Program
from robodyn.kernels.generate import Options, generate
from robodyn.robot import read_text
from robodyn.robot.bundled import load
from robodyn.robot.model import Robot
from robodyn.robot.values import circle_point

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


def test_numbers_of_a_flat_arm() -> None:
    """Craig, example 3.3 and 5.3: a planar arm of two links; and what its tool is accelerated by."""
    flat = read_text("""\
name: flat
tool: {xyz: [2, 0, 0], rpy: [0, 0, 0]}
links:
  - {joint: revolute, mass: 1}
  - {joint: revolute, a: 3, mass: 1}
""")
    inputs: dict[Input, Any] = {Input("q", 0): 0.0, Input("q", 1): 0.0}
    inputs |= {Input("qd", 0): Fraction(5), Input("qd", 1): Fraction(7)}
    c, s = Fraction(3, 5), Fraction(4, 5)  # of joint 1; joint 2 at a right angle
    points = {Input("q", 0): (c, s), Input("q", 1): (Fraction(0), Fraction(1))}
    at = {
        name: values
        for program in programs(flat).values()
        for name, values in evaluate_exact(program, inputs, points, circle_point).items()
    }
    x, y = 3 * c - 2 * s, 3 * s + 2 * c
    assert at["T"][3::4] == [x, y, 0]
    assert at["jac"] == [-y, -2 * c, x, -2 * s, 0, 0, 0, 0, 0, 0, 1, 1]
    assert at["drift"][:2] == [-(25 * 3 * c - 144 * 2 * s), -(25 * 3 * s + 144 * 2 * c)]
    assert at["jac_tool"][:4] == [3, 0, 2, 2]  # r1 (s2, c2) + r2 (0, 1)


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
