"""The face in sympy: the same model, symbol by symbol and result by result."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy

from dynamics.direct import exact_arm, with_named_numbers
from ir.programs import Point, exactly
from robodyn import InputError, Options, load, program, symbolic
from robodyn.counts import count
from robodyn.dynamics.functions import FUNCTIONS, function_named
from robodyn.ir import Input
from robodyn.ir.fingerprint import fingerprint
from robodyn.kernels.generate import generate
from robodyn.optimize.programs import Choice
from robodyn.robot import Robot
from robodyn.robot import read_text as read
from robodyn.robot.values import circle_point
from robodyn_testing import representative

CHOICES = (Choice(regroup=False, chains=False), Choice(), Choice("newton_euler", regroup=False, chains=False))


def bundled(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def read_text(text: str) -> Robot:
    return read(text, warn=lambda _: None)


def rational(x: Fraction) -> sympy.Rational:
    return sympy.Rational(x.numerator, x.denominator)


def angle_point(expression: sympy.Expr, at: Point) -> tuple[Fraction, Fraction]:
    """Cosine and sine of a sum of joint angles and a constant, at a rational point."""
    constant, rest = expression.as_coeff_Add()
    c, s = (
        circle_point(Fraction(int(constant.p), int(constant.q))) if constant else (Fraction(1), Fraction(0))
    )
    for term in sympy.Add.make_args(rest):
        multiple, symbol = term.as_coeff_Mul()
        cosine, sine = at.circle(Input("q", int(symbol.name[1:]) - 1))
        for _ in range(abs(int(multiple))):
            way = 1 if multiple > 0 else -1
            c, s = c * cosine - way * s * sine, s * cosine + way * c * sine
    return c, s


def evaluated(model: Any, robot: Robot, at: Point) -> list[Fraction]:
    """The results of a model in sympy, step by step, at a rational point."""
    known: dict[Any, Any] = {}
    for array, symbols in model.inputs.items():
        known |= {symbol: rational(at.number(Input(array, i))) for i, symbol in enumerate(symbols)}
    for name in robot.parameters:
        known[sympy.Symbol(name, real=True)] = rational(at.number(Input(name, None)))

    def value(expression: Any) -> Any:
        circles = {
            f: rational(angle_point(f.args[0], at)[isinstance(f, sympy.sin)])
            for f in sympy.sympify(expression).atoms(sympy.sin, sympy.cos)
        }
        return sympy.sympify(expression).xreplace(circles).xreplace(known)

    for symbol, expression in model.steps:
        assert symbol not in known
        known[symbol] = value(expression)
    return [Fraction(int(x.p), int(x.q)) for x in map(value, model.results)]


def arms() -> list[Robot]:
    found = [exact_arm(seed, joints=1 + seed % 4) for seed in range(50, 56)]
    few = with_named_numbers(found[2], lambda name: name.startswith(("mass", "com_x", "d_", "viscous")))
    return [*found, replace(few, name="named"), bundled("stanford_3dof"), bundled("puma560_3dof")]


@pytest.mark.parametrize(
    "robot", representative(arms(), arms()[-2], rest="slow"), ids=lambda robot: robot.name
)
def test_symbolic_models_are_the_graphs_programs(robot: Robot) -> None:
    at = Point(6)
    functions = [f for f in FUNCTIONS if f in generate(robot).counts]
    for function in functions:
        (expected,) = exactly(program(robot, function), at).values()
        for choice in CHOICES if function == "inverse_dynamics" else CHOICES[:1]:
            model = symbolic(robot, function, choice)
            assert evaluated(model, robot, at) == expected, (function, choice)
            assert len({symbol for symbol, _ in model.steps}) == len(model.steps) == len(model.labels)


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


def test_sympy_is_no_smaller() -> None:
    """What the graph is for: no more operations than sympy's ``cse`` leaves, and usually fewer. In sympy sums
    stand in another order, from which factoring may come out one better."""
    for name in ("stanford_3dof", "puma560_3dof", "stanford"):
        graph, through = (
            count(program(bundled(name), "inverse_dynamics", Options(engine=engine)))
            for engine in ("graph", "sympy")
        )
        assert graph.total <= through.total + 1


@pytest.mark.parametrize("name", ["q1", "qd2", "qdd1", "c2", "s1", "w2_x", "tau1", "lam2_11", "cse_0", "t1"])
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
