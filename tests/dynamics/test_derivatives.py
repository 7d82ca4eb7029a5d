"""Derivatives: equal to the plain recursion differentiated, to Pinocchio's, and among each other."""

from __future__ import annotations

import numpy as np
import pytest

from peers.numbers import Array, number
from robodyn import Options, load, program
from robodyn.counts import count
from robodyn.ir import Input, Program
from robodyn.ir.evaluate import evaluate
from robodyn.kernels.generate import generate
from robodyn.robot import Robot
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_robot, random_states

FUNCTIONS = ("inverse_dynamics_derivatives", "forward_dynamics_derivatives", "coriolis_matrix")
FAST = Options(optimize="fast")
#: Some of them thorough.
SEEDS = sampled(range(200), every=25, rest="slow")


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
