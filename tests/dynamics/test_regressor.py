"""Base parameters and the regressor: exact, minimal, and Pinocchio's."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import robodyn
from dynamics.evaluated import BUNDLED, RANDOM, by_program, robot_named
from peers import pinocchio_peer
from robodyn.dynamics.base_set import DRIVE, BaseParameter
from robodyn.errors import InputError
from robodyn.optimize.programs import base_set_of
from robodyn.robot import Robot, read_text
from robodyn.robot.values import parameter
from robodyn_testing import require_module, sampled
from robodyn_testing.random_robots import random_states

#: Pinocchio's parameters of a body about its joint: mass, first moments, Ixx Ixy Iyy Ixz Iyz Izz.
_PIN = ("m", "mx", "my", "mz")


def pinocchio_columns(robot: Robot, q: Any, qd: Any, qdd: Any) -> dict[str, Any]:
    """Torques [N n] by each inertial number of a link, second moments in place of inertias."""
    pin = require_module("pinocchio")
    model = pinocchio_peer.pinocchio_model(robot)
    data = model.createData()
    rows = [
        pin.computeJointTorqueRegressor(model, data, *state).copy() for state in zip(q, qd, qdd, strict=True)
    ]
    whole = np.concatenate([row.reshape(robot.n, -1) for row in rows])
    columns = {}
    for i in range(robot.n):
        block = whole[:, 10 * i : 10 * i + 10]
        xx, xy, yy, xz, yz, zz = block[:, 4:].T
        columns.update({f"{name}{i + 1}": block[:, k] for k, name in enumerate(_PIN)})
        # I = trace(K) - K
        second = {"Kxx": yy + zz, "Kyy": xx + zz, "Kzz": xx + yy, "Kxy": -xy, "Kxz": -xz, "Kyz": -yz}
        columns.update({f"{name}{i + 1}": column for name, column in second.items()})
    return columns


def inertial(columns: tuple[BaseParameter, ...]) -> list[BaseParameter]:
    """Those that are of links' masses, maybe with rotors."""
    return [column for column in columns if column.own.quantity not in DRIVE]


@pytest.mark.parametrize("name", sampled([*BUNDLED, *RANDOM], every=40, rest="slow"))
def test_it_is_pinocchios_columns_combined(name: str) -> None:
    """Each column is Pinocchio's of its own number; every number's column of Pinocchio is the sum that the
    terms say; and there are as many as Pinocchio's columns have rank."""
    robot = robot_named(name)
    q, qd, qdd = random_states(robot, max(12, 3 * robot.n), 6)
    columns = base_set_of(robot)
    own = pinocchio_columns(robot, q, qd, qdd)
    Y = by_program(robot, "regressor", q=q, qd=qd, qdd=qdd).reshape(len(q) * robot.n, -1)
    scale = max(1.0, max(np.abs(column).max() for column in own.values()))
    assert Y.shape[1] == len(columns)
    for k, column in enumerate(columns):
        if column.own.quantity not in DRIVE:
            np.testing.assert_allclose(Y[:, k], own[str(column.own)], rtol=0, atol=1e-10 * scale)
    sums = {name: np.zeros(len(Y)) for name in own}
    for k, column in enumerate(columns):
        for standard, factor in column.terms:
            if standard.quantity not in DRIVE:
                sums[str(standard)] += float(factor) * Y[:, k]
    for each, total in sums.items():
        np.testing.assert_allclose(total, own[each], rtol=0, atol=1e-9 * scale, err_msg=each)
    matrix = np.stack(list(own.values()), axis=1)
    size = np.abs(matrix).max(axis=0)
    matrix = matrix[:, size > 1e-12 * scale] / size[size > 1e-12 * scale]
    values = np.linalg.svd(matrix, compute_uv=False)
    rank = int((values > 1e-9 * values.max(initial=0.0)).sum())
    assert len(inertial(columns)) == rank


def test_known_sets() -> None:
    """As many as the literature counts: a 7-joint arm 43, a 6-joint one 36 (Khalil and Dombre, ch. 9)."""
    counts = {
        name: len(inertial(base_set_of(robot_named(name)))) for name in ("panda", "puma560", "stanford")
    }
    assert counts == {"panda": 43, "puma560": 36, "stanford": 33}
    first = base_set_of(robot_named("stanford_3dof"))[0]
    assert str(first) == "Kxx1 + Kyy1 + rotor1 + 0.02322576 m2 + 0.3048 mz2 + Kzz2 - 0.5 rotor2 + Kyy3"
    planar = read_text(
        "name: planar\ngravity: [0, 0, -9.81]\nlinks:\n"
        "  - {joint: revolute, mass: 2, com: [0.2, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}\n"
        "  - {joint: revolute, a: 0.5, mass: 1, com: [0.1, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}\n"
        "torque_side: link\n"
    )
    # Two parallel axes along gravity: m2 a^2 on the first, the second's inertia and two first moments.
    names = [str(column) for column in base_set_of(planar)]
    assert names == ["Kxx1 + Kyy1 + 0.25 m2", "mx2", "my2", "Kxx2 + Kyy2"]


def test_what_has_none_says_so() -> None:
    text = "name: {0}\nlinks:\n  - {{joint: revolute, mass: 2, com: [0.1, 0, 0], a: {1}{2}}}\n"
    named = read_text(text.format("named", "length", ""))
    with pytest.raises(InputError, match="a length that is a run-time parameter; state it as a number"):
        robodyn.program(named, "regressor")
    drives = ", effects: [{effect: power_law_friction, level: 0.4, exponent: 0.5}]"
    with pytest.raises(InputError, match="not linear in base parameters; found drives with effects"):
        robodyn.program(read_text(text.format("driven", 0, drives)), "regressor")
    masses = robot_named("stanford_3dof")
    loose = replace(masses, links=(*masses.links[:2], replace(masses.links[2], mass=parameter("m"))))
    assert robodyn.program(loose, "regressor") == robodyn.program(masses, "regressor")
    values = robodyn.base_parameters(loose, {"m": 4.25}).values
    np.testing.assert_allclose(values, robodyn.base_parameters(masses).values)


def test_compiled_they_take_and_give_arrays_of_their_own_length() -> None:
    functions = ("regressor", "inverse_dynamics_from_parameters", "inverse_dynamics")
    kernel = robodyn.compile("stanford_3dof", functions=functions, mode="abi", trig="builtin")
    columns, values = robodyn.base_parameters("stanford_3dof")
    q, qd, qdd = random_states(robot_named("stanford_3dof"), 5, 2)
    Y = kernel.regressor(q, qd, qdd)
    assert Y.shape == (5, 3, len(columns))
    assert kernel.base_parameters == tuple(map(str, columns))
    header = robodyn.generate("stanford_3dof", robodyn.Options(("regressor",))).files(["c"])[
        "stanford_3dof.h"
    ]
    for name in ("stanford_3dof", "STANFORD_3DOF"):
        assert f"#define {name}_REGRESSOR_COLUMNS {len(columns)}\n" in header
    tau = kernel.inverse_dynamics(q, qd, qdd)
    pi = np.tile(values, (5, 1))
    np.testing.assert_allclose(Y @ values, tau, rtol=0, atol=1e-11)
    np.testing.assert_allclose(
        kernel.inverse_dynamics_from_parameters(q, qd, qdd, pi), tau, rtol=0, atol=1e-11
    )
    assert np.array_equal(kernel.batch(q, qd, qdd, function="regressor"), Y)
    work = kernel.workspace("regressor")
    work.q, work.qd, work.qdd = q[2], qd[2], qdd[2]
    work()
    assert np.array_equal(work.Y, Y[2])
    with pytest.raises(InputError, match=r"pi has the wrong shape; found \[3\]"):
        kernel.inverse_dynamics_from_parameters(q[0], qd[0], qdd[0], q[0])
