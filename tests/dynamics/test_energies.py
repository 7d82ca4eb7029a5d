"""Energies, momentum and Coriolis torques by Pinocchio and MuJoCo, and what they have to do with another."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from dynamics.direct import State
from dynamics.evaluated import BUNDLED, RANDOM, by_program, robot_named
from ir.programs import Point
from peers import mujoco_peer, pinocchio_peer
from peers.compared import WORST_CONDITION, worst_condition
from robodyn.dynamics.dual import Dual
from robodyn.dynamics.equality import same_in_field
from robodyn.dynamics.functions import FUNCTIONS
from robodyn.dynamics.functions.energies import FUNCTIONS as OWN
from robodyn.dynamics.vectors import unmarked
from robodyn.kernels.generate import NoForwardDynamics
from robodyn.optimize.programs import Choice, build, outputs_of
from robodyn.robot import Robot
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_states

STATES = 5


def by_pinocchio(robot: Robot, q: Any, qd: Any) -> dict[str, Any]:
    """The same by Pinocchio, rotors added."""
    pin = require_module("pinocchio")
    model = pinocchio_peer.pinocchio_model(robot)
    data = model.createData()
    M = pinocchio_peer.mass_matrix(model, robot, q)
    kinetic = np.einsum("ki,kij,kj->k", qd, M, qd) / 2
    potential = [pin.computePotentialEnergy(model, data, x) for x in q]
    coriolis, slope = [], []
    for x, v in zip(q, qd, strict=True):
        C = pin.computeCoriolisMatrix(model, data, x, v)
        coriolis.append(C @ v)
        slope.append(C.T @ v)
    gravity = pinocchio_peer.gravity(model, robot, q)
    return {
        "kinetic_energy": kinetic[:, None],
        "potential_energy": np.array(potential)[:, None],
        "momentum": np.einsum("kij,kj->ki", M, qd),
        "coriolis": np.array(coriolis),
        "momentum_observer_term": np.array(slope) - gravity,
    }


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=60))
def test_they_are_what_pinocchio_says(name: str) -> None:
    robot = robot_named(name)
    q, qd, _ = random_states(robot, STATES, 3)
    expected = by_pinocchio(robot, q, qd)
    for function, values in expected.items():
        actual = by_program(robot, function, q=q, qd=qd)
        scale = max(1.0, np.abs(values).max(), np.abs(expected["momentum_observer_term"]).max())
        np.testing.assert_allclose(actual, values, rtol=0, atol=1e-10 * scale, err_msg=function)


@pytest.mark.parametrize("name", ["puma560", "tx40", "stanford", "random 3", "random 14"])
def test_energies_are_what_mujoco_says(name: str) -> None:
    mujoco = require_module("mujoco")
    robot = robot_named(name)
    q, qd, _ = random_states(robot, STATES, 4)
    model = mujoco_peer.mujoco_model(robot)
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    data = mujoco.MjData(model)
    kinetic = by_program(robot, "kinetic_energy", q=q, qd=qd)[:, 0]
    potential = by_program(robot, "potential_energy", q=q)[:, 0]
    for k in range(STATES):
        data.qpos, data.qvel = q[k], qd[k]
        mujoco.mj_forward(model, data)
        scale = 1 + np.abs(data.energy).max()
        np.testing.assert_allclose((potential[k], kinetic[k]), data.energy, rtol=0, atol=1e-10 * scale)


class Along:
    """A robot at a rational point that moves on: functions and their rates, without rounding."""

    def __init__(self, robot: Robot) -> None:
        self.state = State(robot, Point(11))
        self.robot = robot
        given = self.state.given
        self.qd, self.qdd = given["qd"], given["qdd"]
        self.inputs = {
            "q": [Dual(x, v) for x, v in zip(given["q"], self.qd, strict=True)],
            "qd": [Dual(x, v) for x, v in zip(self.qd, self.qdd, strict=True)],
        }

    def trigonometry(self, angle: Any) -> tuple[Any, Any]:
        """Cosine and sine of an angle, and their rates."""
        c, s = self.state.trigonometry(angle)
        rate = sum(sign * self.qd[joint] for joint, sign in angle.terms)
        return Dual(c, -(s * rate)), Dual(s, c * rate)

    def values(self, function: str, **given: Any) -> list[Fraction]:
        """The function at the point."""
        state = self.state
        inputs = {**state.given, **given}
        return outputs_of(function, state.arm, Choice(), inputs, state.trigonometry, Fraction, unmarked)

    def rates(self, function: str) -> list[Fraction]:
        """Its time derivatives."""
        outputs = outputs_of(
            function, self.state.arm, Choice(), self.inputs, self.trigonometry, Fraction, unmarked
        )
        return [x.slope if isinstance(x, Dual) else Fraction(0) for x in outputs]


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=60))
def test_the_inverse_mass_matrix_is_what_pinocchio_says(name: str) -> None:
    pin = require_module("pinocchio")
    robot = robot_named(name)
    q = random_states(robot, STATES, 5)[0]
    model = pinocchio_peer.pinocchio_model(robot)
    M = pinocchio_peer.mass_matrix(model, robot, q)
    if worst_condition(M) > WORST_CONDITION:  # a joint moves nearly without inertia: digits are lost
        try:
            results = by_program(robot, "inverse_mass_matrix", q=q)
        except (NoForwardDynamics, RuntimeWarning):  # no inverse, or a pivot that rounds to 0
            assert np.linalg.cond(M).max() > 1e12, "only what has no inverse is refused"
        else:
            products = [x.reshape(robot.n, -1) @ m for x, m in zip(results, M, strict=True)]
            lost = 1e-15 * np.linalg.cond(M)
            assert all(
                np.abs(p - np.eye(robot.n)).max() < 1e3 * x for p, x in zip(products, lost, strict=True)
            )
        return
    data = model.createData()
    for one, actual in zip(q, by_program(robot, "inverse_mass_matrix", q=q), strict=True):
        pin.computeMinverse(model, data, one)
        expected = np.triu(data.Minv) + np.triu(data.Minv, 1).T
        scale = np.abs(expected).max()
        np.testing.assert_allclose(actual.reshape(robot.n, -1), expected, rtol=0, atol=1e-10 * scale)


def product(x: Any, y: Any) -> Any:
    return sum(a * b for a, b in zip(x, y, strict=True))


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=20))
def test_what_they_have_to_do_with_each_other(name: str) -> None:
    """Exactly: momentum, twice the energy, power, and the observer's equation of motion."""
    robot = robot_named(name, friction=False)
    at, n = Along(robot), robot.n
    matrix, p = at.values("mass_matrix"), at.values("momentum")
    assert p == [product(matrix[n * i : n * (i + 1)], at.qd) for i in range(n)]
    (energy,) = at.values("kinetic_energy")
    assert 2 * energy == product(p, at.qd)
    tau = at.values("inverse_dynamics")
    (kinetic,), (potential,) = at.rates("kinetic_energy"), at.rates("potential_energy")
    assert kinetic + potential == product(at.qd, tau)
    term = at.values("momentum_observer_term")
    assert at.rates("momentum") == [a + b for a, b in zip(tau, term, strict=True)]
    bias, gravity = at.values("bias"), at.values("gravity")
    assert at.values("coriolis") == [a - b for a, b in zip(bias, gravity, strict=True)]


def test_every_way_of_writing_them_is_the_same() -> None:
    """At a rational point, for arms of few joints and many."""
    for name in ("stanford_3dof", "random 3", "tx40", "random 14"):
        robot = robot_named(name, friction=False)
        at = Along(robot)
        for function in OWN:
            ways = function.writings(robot.n)
            assert len(ways) > (function.name in ("kinetic_energy", "momentum") and robot.n < 5)
            values = [
                outputs_of(
                    function.name, at.state.arm, choice, at.state.given, at.state.trigonometry, Fraction,
                    unmarked, way,
                )
                for way in ways
                for choice in (Choice(), Choice(regroup=False), Choice(chains=False))
            ]  # fmt: skip
            assert all(value == values[0] for value in values), (name, function.name)


def test_an_error_in_any_is_caught() -> None:
    """The comparison that every program goes through before it leaves."""
    robot = robot_named("puma560_3dof")
    for right in OWN:
        name = right.name
        assert same_in_field(robot, name, build(robot, name, Choice()))

        def wrong(at: Any, right: Any = right) -> Any:
            first, *others = right.outputs(at)
            return [first + Fraction(1, 10**9) * at.inputs["q"][1], *others]

        FUNCTIONS[name] = replace(right, outputs=wrong)
        try:
            assert not same_in_field(robot, name, build(robot, name, Choice()))
        finally:
            FUNCTIONS[name] = right


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=40))
def test_products_of_velocities_make_the_coriolis_torques(name: str) -> None:
    """Exactly: ``h_ikm qd_k qd_m``, and ``h_ikm = h_imk``; and h is half the slopes of the mass matrix."""
    robot = robot_named(name, friction=False)
    at, n = Along(robot), robot.n
    h = at.values("christoffel_symbols")
    rows = [h[n * n * i : n * n * (i + 1)] for i in range(n)]
    squares = [x * y for x in at.qd for y in at.qd]
    assert [product(row, squares) for row in rows] == at.values("coriolis")
    assert all(row[n * k + m] == row[n * m + k] for row in rows for k in range(n) for m in range(k))
    # dM_ij/dt = sum over k of (h_ijk + h_jik) qd_k
    slopes = at.rates("mass_matrix")
    for i in range(n):
        for j in range(n):
            both = [
                x + y for x, y in zip(rows[i][n * j : n * (j + 1)], rows[j][n * i : n * (i + 1)], strict=True)
            ]
            assert slopes[n * i + j] == product(both, at.qd)
