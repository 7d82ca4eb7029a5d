"""Energies, momentum and Coriolis torques by Pinocchio and MuJoCo, and what they have to do with another."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dynamics.evaluated import BUNDLED, RANDOM, by_program, robot_named
from peers import mujoco_peer, pinocchio_peer
from peers.compared import WORST_CONDITION, worst_condition
from robodyn.kernels.generate import NoForwardDynamics
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


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=20, rest="slow"))
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


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=20, rest="slow"))
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
