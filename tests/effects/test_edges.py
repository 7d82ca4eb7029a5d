"""Cases at the edge in which effects once went wrong."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.ir.evaluate import evaluate
from robodyn.ir.program import Input
from robodyn.kernels.generate import NoForwardDynamics, Options, generate, program
from robodyn.kernels.robot_kernel import compile as compile_kernel
from robodyn.robot import Robot, load
from robodyn.verify import Reference

_ARM = """\
name: edge
gravity: [0, -9.81, 0]
links:
  - {joint: revolute, mass: 1, com: [0.3, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}, motor_inertia: 0.5}
  - {joint: revolute, a: 0.6, mass: %s}
"""
_ELASTIC = ", motor_inertia: 0.2, effects: [{effect: joint_elasticity, stiffness: 100, damping: %s}]"
Q, QD, QDD = np.array([[0.3, -0.7], [0.5, 1.1], [2.0, -3.0]])


def described(folder: Path, last: str, tail: str = "", mass: str = "0") -> Robot:
    path = folder / "edge.yaml"
    path.write_text(_ARM % (mass + last) + tail, encoding="utf-8")
    return load(str(path))


def test_a_run_time_parameter_may_be_called_dt(tmp_path: Path) -> None:
    one, other = (compile_kernel(described(tmp_path, _ELASTIC % name)) for name in ("dt", "d"))
    states = [np.zeros(3), np.zeros(3)]
    for dt in (0.0, 1e-3, 2e-3):
        tau = [
            kernel.inverse_dynamics(Q, QD, QDD, params={name: 0.7}, state=state, dt=dt)
            for kernel, name, state in zip((one, other), ("dt", "d"), states, strict=True)
        ]
        np.testing.assert_array_equal(tau[0], tau[1])
        np.testing.assert_array_equal(states[0], states[1])


def test_a_damping_of_zero_at_run_time_is_no_damping(tmp_path: Path) -> None:
    named, without = (compile_kernel(described(tmp_path, _ELASTIC % damping)) for damping in ("d", "0"))
    states = [np.zeros(3), np.zeros(3)]
    for dt in (0.0, 1e-3):
        tau = named.inverse_dynamics(Q, QD, QDD, params={"d": 0.0}, state=states[0], dt=dt)
        plain = without.inverse_dynamics(Q, QD, QDD, state=states[1], dt=dt)
        np.testing.assert_allclose(tau, plain, rtol=1e-14)
        np.testing.assert_allclose(states[0], states[1], rtol=1e-14)


def test_given_sines_are_of_positions_alone(tmp_path: Path) -> None:
    heavy = ", com: [0.2, 0, 0], inertia: {xx: 0.1, yy: 0.1, zz: 0.1}" + _ELASTIC % "1"
    made = generate(described(tmp_path, heavy, mass="1"), Options(trig="given"))
    assert made.unit.sc
    assert not any("state" in text for text in made.unit.sc)


@pytest.mark.parametrize(
    ("payload", "mass"),
    [
        ("{mass: m_load, com: [0.1, 0, 0]}", 0.0),
        ("{mass: m_load, com: [0.1, 0, 0]}", 2.8),
        ("{mass: 0, inertia: {xx: 1, yy: 1, zz: 1}}", None),
    ],
)
def test_a_payload_on_a_link_without_mass(tmp_path: Path, payload: str, mass: float | None) -> None:
    robot = described(tmp_path, "", f"effects: [{{effect: payload, {payload[1:]}]\n")
    values = {} if mass is None else {"m_load": mass}
    inputs = {Input(name, i): x for name, v in (("q", Q), ("qd", QD), ("qdd", QDD)) for i, x in enumerate(v)}
    inputs |= {Input(name, None): x for name, x in values.items()}
    (tau,) = evaluate(program(robot, "inverse_dynamics"), inputs).values()
    expected = Reference(robot, values).inverse_dynamics(Q, QD, QDD)
    np.testing.assert_allclose(tau, expected, rtol=1e-12, atol=1e-14)


def test_a_rotor_behind_a_spring_is_inertia_enough_for_forward_dynamics(tmp_path: Path) -> None:
    robot = described(tmp_path, _ELASTIC % "1")
    assert program(robot, "forward_dynamics").operations
    with pytest.raises(NoForwardDynamics, match="no forward dynamics"):
        program(described(tmp_path, ", effects: [{effect: spring, stiffness: 3}]"), "forward_dynamics")
