"""Arms that miss a class of inverse kinematics by a little have a program that passes its proof, or are
refused with a reason: never an internal error."""

from __future__ import annotations

import pytest

from robodyn.dynamics import closure
from robodyn.dynamics.inverse import Numerical
from robodyn.dynamics.state import NoSuchFunction
from robodyn.kernels import proof
from robodyn.optimize.programs import Choice, build, inverse_kinematics_of
from robodyn.robot.reader import read_text
from robodyn_testing.nearly import nearly

#: Three axes that nearly meet, three others that do: the distance of these points is constant, but for what
#: axes miss.
TWO_SPHERES = """\
name: spheres
links:
  - {joint: revolute, alpha: 2.164e-05, a: -6.358e-05, d: 0.5624, theta: 1.357}
  - {joint: revolute, alpha: -pi/2+7.756e-05, a: 6.931e-05}
  - {joint: revolute, alpha: -pi/2+-3.972e-05, a: -7.082e-05, d: -0.7003, theta: pi/2}
  - {joint: revolute, alpha: -pi/2+3.353e-05, a: 0.30928144, d: 0.6966, theta: pi/2}
  - {joint: revolute, alpha: 2.467+3.267e-05, a: -1.347e-06, theta: -pi/2}
  - {joint: revolute, alpha: -0.6974+-2.104e-05, a: -9.567e-05}
base: {xyz: [-0.08317, 0.4564, -0.1487], rpy: [1.467, 0, pi/2]}
tool: {xyz: [0.1843, 0.1297, 0.1322], rpy: [0, pi/2, 2.369]}
"""
FUNCTION = "inverse_kinematics"


def test_an_arm_that_hardly_moves_in_a_direction_has_a_program_and_says_so() -> None:
    robot = read_text(TWO_SPHERES, warn=lambda _: None)
    solver = inverse_kinematics_of(robot)
    assert isinstance(solver, Numerical)
    assert solver.weak
    assert any("only because axes do not meet" in words for words in solver.conditions)
    proof.prove(robot, FUNCTION, build(robot, FUNCTION, Choice()))


@pytest.mark.parametrize("shape", ["slide_across_place", "slides", "two_turns", "scara_place", "scara"])
def test_so_has_an_arm_of_few_joints(shape: str) -> None:
    robot = nearly(shape, 0)
    program = build(robot, FUNCTION, Choice())
    proof.prove(robot, FUNCTION, program)
    assert program.outputs


def test_a_program_that_reaches_nothing_is_refused_with_a_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(closure, "flaw", lambda *_, **__: "no pose is reached")
    robot = read_text(TWO_SPHERES, warn=lambda _: None)
    with pytest.raises(NoSuchFunction, match="none of the poses they were tried at") as refused:
        proof.prove(robot, FUNCTION, build(robot, FUNCTION, Choice()))
    assert refused.value.exit_code == 2
