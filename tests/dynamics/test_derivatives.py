"""Derivatives: equal to the plain recursion differentiated, to Pinocchio's, and among each other."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from ir.programs import Point, exactly
from peers.numbers import Array, number
from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.dynamics.functions import FUNCTIONS as RECORDS
from robodyn.ir import Graph, Input, Program
from robodyn.ir.derivative import jacobian
from robodyn.ir.evaluate import evaluate
from robodyn.ir.lowering import lower
from robodyn.kernels.generate import NoForwardDynamics, generate
from robodyn.kernels.proof import Unequal
from robodyn.robot import Robot, bundled_names, read_text
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_robot, random_states

FUNCTIONS = ("inverse_dynamics_derivatives", "forward_dynamics_derivatives", "coriolis_matrix")
FAST = Options(optimize="fast")
BUNDLED = sampled([load(name, warn=lambda _: None) for name in bundled_names()], every=5)
#: Some of them thorough.
SEEDS = sampled(range(200), every=50)

DRIVES = """\
name: driven
friction_at_rest: {smooth: {velocity: 0.05}}
links:
  - joint: revolute
    mass: 3
    com: [0.1, 0.02, 0.1]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.12}
    motor_inertia: 0.3
    friction: {viscous: 1.2, coulomb: 3}
    effects:
      - {effect: spring, stiffness: 20, rest: 0.3}
      - {effect: motor_coupling, with: 2, ratio: 0.5, inertia: 0.2}
  - joint: revolute
    alpha: pi/2
    a: 0.3
    mass: 2
    com: [0.1, 0.02, 0.1]
    inertia: {xx: 0.1, yy: 0.1, zz: 0.12}
    effects:
      - {effect: stribeck_friction, level: 1.0, static: 2.0, velocity: 0.1}
  - joint: prismatic
    alpha: pi/2
    mass: 2
"""


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("robot", BUNDLED, ids=lambda robot: robot.name)
def test_every_bundled_robot_has_them(robot: Robot, function: str) -> None:
    """No program leaves that is not equal to the plain recursion, differentiated by dual numbers."""
    if function == "forward_dynamics_derivatives" and robot.name in ("tx40", "puma560_3dof_d13"):
        with pytest.raises(NoForwardDynamics, match=f"{robot.name} has no forward dynamics derivatives"):
            program(robot, function, FAST)
    else:
        assert program(robot, function, FAST).results()


@pytest.mark.parametrize("seed", SEEDS)
def test_random_robots_have_them_as_pinocchio_says(seed: int) -> None:
    pin = require_module("pinocchio")
    from peers import pinocchio_peer

    robot = random_robot(seed)
    Q, Qd, Qdd = random_states(robot, 3, 1)
    model = pinocchio_peer.pinocchio_model(robot)
    data, n = model.createData(), robot.n
    made = program(robot, "inverse_dynamics_derivatives", FAST)
    coriolis = program(robot, "coriolis_matrix", FAST)
    for q, qd, qdd in zip(Q, Qd, Qdd, strict=True):
        state = {"q": q, "qd": qd, "qdd": qdd}
        by_q, by_qd, by_qdd = (np.array(x) for x in pin.computeRNEADerivatives(model, data, q, qd, qdd))
        ours = numbers(made, state)
        largest = max(np.abs(x).max() for x in (by_q, by_qd, by_qdd))
        np.testing.assert_allclose(ours["dtau_dq"].reshape(n, n), by_q, atol=1e-11 * largest)
        slopes = friction_slopes(robot, qd)
        np.testing.assert_allclose(
            ours["dtau_dqd"].reshape(n, n), by_qd + np.diag(slopes), atol=1e-11 * max(largest, *slopes)
        )
        matrix = numbers(coriolis, state)["C"].reshape(n, n)
        np.testing.assert_allclose(2 * matrix, by_qd, atol=1e-11 * largest)
        if np.linalg.cond(by_qdd := full(by_qdd)) > 1e6:
            continue
        tau = np.array(pin.rnea(model, data, q, qd, qdd))
        tau = tau + friction(robot, qd)
        forward = numbers(
            program(robot, "forward_dynamics_derivatives", FAST), {"q": q, "qd": qd, "tau": tau}
        )
        for name, torque in (
            ("dqdd_dq", -by_q),
            ("dqdd_dqd", -(by_qd + np.diag(slopes))),
            ("dqdd_dtau", np.eye(n)),
        ):
            np.testing.assert_allclose(
                by_qdd @ forward[name].reshape(n, n), torque, atol=1e-9 * max(1, np.abs(torque).max())
            )


def numbers(made: Program, state: dict[str, Array]) -> dict[str, Array]:
    inputs = {Input(name, i): float(x) for name, array in state.items() for i, x in enumerate(array)}
    return {name: np.array(x, float) for name, x in evaluate(made, inputs, constant=float).items()}


def full(upper: Array) -> Array:
    return np.triu(upper) + np.triu(upper, 1).T


def friction(robot: Robot, qd: Array) -> Array:
    from peers.numbers import friction as of

    torques: Array = of(robot, qd[None])[0]
    return torques


def friction_slopes(robot: Robot, qd: Array) -> list[float]:
    """By the formula of the description, written out once more."""
    if robot.torque_side == "link":
        return [0.0] * robot.n
    slopes = []
    for link, rate in zip(robot.links, qd, strict=True):
        slope = number(link.joint.viscous)
        if robot.rest_velocity is not None:
            rest = float(robot.rest_velocity)
            slope += number(link.joint.coulomb) / rest * (1 - np.tanh(rate / rest) ** 2)
        slopes.append(slope)
    return slopes


@pytest.mark.parametrize("name", ["puma560", "stanford"])
def test_the_change_of_the_mass_matrix_less_twice_the_coriolis_matrix_is_skew(name: str) -> None:
    """Exactly: ``dM/dt = C + C^T``, by the graph's own derivatives of the mass matrix."""
    robot = load(name, warn=lambda _: None)
    n, at = robot.n, Point(3)
    graph = Graph()
    entries = graph.replay(program(robot, "mass_matrix", FAST))
    slopes = jacobian(graph, entries, [Input("q", k) for k in range(n)])
    rates = [sum(x * graph.input("qd", k) for k, x in enumerate(row)) for row in slopes]
    change = exactly(lower(graph, [("M", rates)]), at)["M"]
    C = exactly(program(robot, "coriolis_matrix", FAST), at)["C"]
    assert change == [C[n * i + j] + C[n * j + i] for i in range(n) for j in range(n)]
    assert any(change)


def test_drives_are_differentiated_with_all_they_do() -> None:
    """Springs, motors that drive two joints, Stribeck's curve: beside differences of 40 digits."""
    import mpmath

    robot = read_text(DRIVES)
    made = program(robot, "inverse_dynamics_derivatives", FAST)
    torques = program(robot, "inverse_dynamics", FAST)
    functions = {name: getattr(mpmath, name) for name in ("sin", "cos", "tanh", "exp", "sign", "sqrt")}
    functions |= {"abs": abs, "pow": mpmath.power}
    state = {
        Input(a, i): mpmath.mpf(0.3 + 0.17 * i + 0.1 * len(a)) for a in ("q", "qd", "qdd") for i in range(3)
    }

    def run(one: Program, at: dict[Input, Any]) -> dict[str, list[Any]]:
        return evaluate(
            one, at, constant=lambda x: mpmath.mpf(x.numerator) / x.denominator, functions=functions
        )

    with mpmath.workdps(60):
        ours, step = run(made, state), mpmath.mpf(10) ** -20
        for array, result in (("q", "dtau_dq"), ("qd", "dtau_dqd")):
            for j in range(3):
                ends = [
                    run(torques, {**state, Input(array, j): state[Input(array, j)] + s * step})
                    for s in (1, -1)
                ]
                for i in range(3):
                    slope = (ends[0]["tau"][i] - ends[1]["tau"][i]) / (2 * step)
                    assert abs(slope - ours[result][3 * i + j]) < mpmath.mpf(10) ** -30


@pytest.mark.parametrize("function", FUNCTIONS)
def test_a_wrong_formula_is_noticed(function: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing leaves whose friction, gravity or momenta are not those of the recursion."""
    right = RECORDS[function]

    def wrong(at: Any) -> list[Any]:
        elements = list(right.outputs(at))
        elements[7] = elements[7] * Fraction(999, 1000)
        return elements

    monkeypatch.setitem(RECORDS, function, replace(right, outputs=wrong))
    with pytest.raises(Unequal):
        program(load("puma560_3dof"), function, FAST)


def test_what_is_always_zero_is_listed() -> None:
    """Nothing depends on how far the first joint has turned about the vertical, whatever its program says."""
    made = generate(load("puma560"), Options(("inverse_dynamics_derivatives", "gravity"), optimize="fast"))
    assert set(range(0, 36, 6)) <= set(made.zeros["inverse_dynamics_derivatives"]["dtau_dq"])
    listed = made.files(["c"])["puma560.h"].partition("Always 0, elements counted from 0:")[2]
    assert "inverse_dynamics_derivatives: dtau_dq is 0 at 0, 5, 6, 11, 12," in listed.partition("*/")[0]
    assert "gravity: tau is 0" not in listed


def test_of_a_record_they_are_taken_where_that_is_less() -> None:
    robot = load("ur10")
    written, taken = (
        program(robot, "inverse_dynamics_derivatives", options) for options in (FAST, Options())
    )
    assert count(taken).total < count(written).total
