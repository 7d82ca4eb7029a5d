"""The face in sympy: the same model, symbol by symbol and result by result."""

from __future__ import annotations

import pytest
import sympy

from ir.programs import Point, exactly
from robodyn import InputError, Options, load, program, symbolic
from robodyn.dynamics.functions import FUNCTIONS, function_named
from robodyn.ir import Input
from robodyn.ir.fingerprint import fingerprint
from robodyn.robot import Robot
from robodyn.robot import read_text as read
from robodyn.robot.values import circle_point
from robodyn_testing import representative


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def read_text(text: str) -> Robot:
    return read(text, warn=lambda _: None)


def test_the_torques_as_closed_expressions() -> None:
    """One link: ``tau = (I + m r^2) qdd + m g r cos(q)``, and nothing but inputs in ``outputs``."""
    robot = read_text(
        "name: rod\ngravity: [0, -10, 0]\n"
        "links: [{joint: revolute, mass: m, com: [0.5, 0, 0], inertia: {zz: 2}, motor_inertia: j}]"
    )
    model = symbolic(robot)
    q, qdd, m, j = (sympy.Symbol(name, real=True) for name in ("q1", "qdd1", "m", "j"))
    (tau,) = model.tau
    assert sympy.expand(tau - ((2 + m / 4 + j) * qdd + 5 * m * sympy.cos(q))) == 0
    assert model.outputs == model.tau
    assert model.inputs["q"] == (q,)


def test_latex_names_every_step() -> None:
    model = symbolic(bundled("puma560_3dof"))
    lines = model.latex().splitlines()
    assert (lines[0], lines[-1]) == (r"\begin{align*}", r"\end{align*}")
    assert len(lines) == len(model.steps) + len(model.results) + 2
    assert all(" &= " in line and line.endswith(r"\\") for line in lines[1:-1])
    text = "\n".join(lines)
    assert r"{\omega}_{2,x}" in text
    assert r"\ddot q_{3}" in text
    assert r"\tau_{3} &=" in text
    assert all(line.count("{") == line.count("}") for line in lines)


# --- the engine -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("function", representative(list(FUNCTIONS), "regressor", rest="slow"))
def test_every_function_comes_through_sympy(function: str) -> None:
    robot = bundled("stanford_3dof")
    try:
        one = program(robot, function)
    except InputError as reason:  # no motors
        with pytest.raises(InputError, match=reason.what):
            program(robot, function, Options(engine="sympy"))
        return
    if function_named(function).of_pose:
        with pytest.raises(InputError, match="is not written through sympy; found a function of a pose"):
            program(robot, function, Options(engine="sympy"))
        return
    other = program(robot, function, Options(engine="sympy"))
    assert fingerprint(one, 1, circle_point) == fingerprint(other, 1, circle_point)


@pytest.mark.parametrize("name", ["q1", "c2", "tau1", "cse_0"])
def test_a_parameter_may_be_called_like_a_quantity_of_the_recursion(name: str) -> None:
    """In C it is ``p->c2`` beside ``c2``; in sympy both are symbols, and must be two."""
    text = f"""
name: arm
links:
  - {{joint: revolute, mass: 2, com: [0.1, 0.2, 0.3], inertia: {{xx: 1, yy: 1, zz: {name}}}}}
  - {{joint: revolute, alpha: pi/2, a: 0.3, mass: {name}, com: [0.3, 0.1, -0.2], inertia: {{zz: 0.2}}}}
"""
    robot = read_text(text)
    plain = read_text(text.replace(f"zz: {name}", "zz: m_tool").replace(f"mass: {name}", "mass: m_tool"))
    at = Point(3)
    value = {Input(name, None): at.number(Input("m_tool", None))}
    (expected,) = exactly(program(plain, "inverse_dynamics"), at).values()
    (found,) = exactly(program(robot, "inverse_dynamics"), at, value).values()
    assert found == expected
    (through,) = exactly(program(robot, "inverse_dynamics", Options(engine="sympy")), at, value).values()
    assert through == expected
