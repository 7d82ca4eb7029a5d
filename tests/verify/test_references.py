"""The references agree with each other and with what can be worked out by hand."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any, Literal

import mpmath
import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.robot.model import Inertia, Joint, Link, Robot
from robodyn.robot.values import PI, ZERO, angle, parameter
from robodyn.verify import Reference, exact_torque, lagrangian
from robodyn_testing import covering
from robodyn_testing.random_robots import random_robot

#: Every angle general, nothing zero, nothing parallel: the robots on which no term vanishes.
GENERIC: dict[str, Any] = {"generic_angles": 1.0, "parallel": 0.0, "zeros": 0.0, "degenerate": 0.0}


def states(robot: Robot, count: int, seed: int = 0) -> Any:
    rng = np.random.default_rng(seed)
    shape = (count, robot.n)
    return rng.uniform(-3, 3, shape), rng.uniform(-3, 3, shape), rng.uniform(-10, 10, shape)


def exact(robot: Robot, q: Any, qd: Any, qdd: Any, parameters: Any = None) -> Any:
    rows = zip(q.tolist(), qd.tolist(), qdd.tolist(), strict=True)
    return np.array([[float(x) for x in exact_torque(robot, *row, parameters)] for row in rows])


def joint(kind: Literal["revolute", "prismatic"] = "revolute", **numbers: Any) -> Joint:
    return Joint(kind, **{"alpha": angle(ZERO), "a": ZERO, "d": ZERO, "theta": angle(ZERO), **numbers})


@pytest.mark.parametrize("joints", [1, 2, 3, 4, 5])
@pytest.mark.parametrize("seed", range(2))
def test_newton_euler_is_virtual_work(joints: int, seed: int) -> None:
    robot = random_robot(seed, joints=joints, aside=0.4, **(GENERIC if seed % 2 else {}))
    q, qd, qdd = states(robot, 4, seed)
    qd[-1] = 0.0
    tau = Reference(robot).inverse_dynamics(q, qd, qdd)
    np.testing.assert_allclose(tau, exact(robot, q, qd, qdd), rtol=0, atol=2e-14 * np.abs(tau).max())


@pytest.mark.parametrize(("joints", "seed"), covering([2, 1, 3], range(100, 103)))
def test_newton_euler_is_the_lagrangian(joints: int, seed: int) -> None:
    robot = random_robot(seed, joints=joints, aside=0.4, **(GENERIC if joints < 3 or seed == 100 else {}))
    q, qd, qdd = states(robot, 20, seed)
    qd[-1] = 0.0
    tau = Reference(robot).inverse_dynamics(q, qd, qdd)
    found = lagrangian(robot)(q, qd, qdd)
    np.testing.assert_allclose(found, tau, rtol=0, atol=2e-14 * np.abs(tau).max())
    np.testing.assert_allclose(lagrangian(robot)(q[0], qd[0], qdd[0]), found[0], rtol=1e-15)


def test_the_lagrangian_of_more_joints_on_request() -> None:
    robot = random_robot(5, joints=5, generic_angles=0.0, prismatic=0.4)
    q, qd, qdd = states(robot, 20)
    tau = Reference(robot).inverse_dynamics(q, qd, qdd)
    found = lagrangian(robot, limit=5)(q, qd, qdd)
    np.testing.assert_allclose(found, tau, rtol=0, atol=2e-14 * np.abs(tau).max())
    with pytest.raises(InputError, match="too many joints for the Lagrangian; found 5; expected at most 3"):
        lagrangian(robot)


@pytest.mark.parametrize("seed", range(4))
def test_functions_of_the_reference_fit_together(seed: int) -> None:
    robot = random_robot(seed, joints=4, aside=0.5, **GENERIC)
    reference = Reference(robot)
    q, qd, qdd = states(robot, 5)
    tau = reference.inverse_dynamics(q, qd, qdd)
    M = reference.mass_matrix(q)
    scale = np.abs(tau).max()
    np.testing.assert_allclose(M, np.swapaxes(M, 1, 2), rtol=0, atol=1e-14 * np.abs(M).max())
    assert (np.linalg.eigvalsh(M) > 0).all()
    parts = np.einsum("kij,kj->ki", M, qdd) + reference.bias(q, qd)
    np.testing.assert_allclose(parts, tau, rtol=0, atol=1e-13 * scale)
    np.testing.assert_allclose(reference.forward_dynamics(q, qd, tau), qdd, rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(reference.bias(q, 0 * q), reference.gravity(q), rtol=0, atol=1e-14 * scale)
    rest, units = np.zeros((4, 4)), np.eye(4)
    still = np.tile(q[0], (4, 1))
    rational = exact(robot, still, rest, units) - exact(robot, still, rest, rest)
    np.testing.assert_allclose(M[0], rational.T, rtol=0, atol=1e-13 * np.abs(M).max())
    for name, arrays in (("gravity", (q,)), ("bias", (q, qd)), ("mass_matrix", (q,))):
        one = getattr(reference, name)(*(array[0] for array in arrays))
        np.testing.assert_allclose(one, getattr(reference, name)(*arrays)[0], rtol=0, atol=1e-14 * scale)


PENDULUM = Robot(
    name="pendulum",
    links=(
        Link(
            "rod",
            joint(
                alpha=angle(PI / 2), motor_inertia=Fraction(1, 8), viscous=Fraction(1, 4), coulomb=Fraction(3)
            ),
            mass=Fraction(2),
            com=(Fraction(1, 2), ZERO, ZERO),
            inertia=Inertia(zz=Fraction(1, 16)),
        ),
    ),
    gravity=(ZERO, ZERO, Fraction(-10)),
)


def test_a_pendulum_by_hand() -> None:
    """tau = (m l^2 + I + rotor) qdd + m g l cos q + viscous qd + coulomb sgn qd."""
    q, qd, qdd = 0.3, -2.0, 5.0
    want = (2 * 0.25 + 0.0625 + 0.125) * qdd + 2 * 10 * 0.5 * math.cos(q) - 0.25 * 2.0 - 3.0
    for found in (
        Reference(PENDULUM).inverse_dynamics([q], [qd], [qdd]),
        lagrangian(PENDULUM)([q], [qd], [qdd]),
        exact(PENDULUM, *(np.array([[x]]) for x in (q, qd, qdd)))[0],
    ):
        assert found[0] == pytest.approx(want, rel=1e-15)
    assert Reference(PENDULUM).gravity([0.0]).tolist() == [10.0]


def test_friction_at_rest_is_none() -> None:
    assert Reference(PENDULUM).bias([PI_HALF], [0.0])[0] == pytest.approx(0.0, abs=1e-14)
    assert exact_torque(PENDULUM, [0], [0], [0]) == [10]


PI_HALF = math.pi / 2


def test_the_link_side_has_no_rotor_and_no_friction() -> None:
    robot = replace(PENDULUM, torque_side="link")
    want = (2 * 0.25 + 0.0625) * 5.0 + 10 * math.cos(0.3)
    assert Reference(robot).inverse_dynamics([0.3], [-2.0], [5.0])[0] == pytest.approx(want, rel=1e-15)
    assert float(exact_torque(robot, [0.3], [-2.0], [5.0])[0]) == pytest.approx(want, rel=1e-15)
    assert lagrangian(robot)([0.3], [-2.0], [5.0])[0] == pytest.approx(want, rel=1e-15)
    assert Reference(robot).mass_matrix([0.3])[0, 0] == 0.5625


def test_exact_torque_has_28_digits() -> None:
    """Beside 50 digits of mpmath, at angles that no table knows, small and large."""
    with mpmath.workdps(50):
        for q in (0.3, -2.5, 1e-9, 100.0, 12345.678):
            want = mpmath.mpf(11) / 16 * 5 + 10 * mpmath.cos(mpmath.mpf(q)) + mpmath.mpf(1) / 2 + 3
            (found,) = exact_torque(PENDULUM, [q], [2.0], [5.0])
            assert abs(mpmath.mpf(found.numerator) / found.denominator - want) < mpmath.mpf(10) ** -28


@pytest.mark.parametrize("speed", [1e-12, 1e-4, 0.003, 0.01, 0.3, 0.7, -0.02, -3.0])
def test_smooth_friction_has_28_digits(speed: float) -> None:
    robot = replace(PENDULUM, rest_velocity=Fraction(1, 100))
    (found,) = exact_torque(robot, [0], [speed], [0])
    with mpmath.workdps(50):
        v = mpmath.mpf(speed)
        want = 10 + v / 4 + 3 * mpmath.tanh(v * 100)
        assert abs(mpmath.mpf(found.numerator) / found.denominator - want) < mpmath.mpf(10) ** -28
    assert Reference(robot).bias([0.0], [speed])[0] == pytest.approx(float(found), rel=1e-15)
    assert lagrangian(robot)([0.0], [speed], [0.0])[0] == pytest.approx(float(found), rel=1e-15)


def test_run_time_parameters_are_numbers_filled_in() -> None:
    fixed = random_robot(3, joints=2, **GENERIC)
    last = fixed.links[-1]
    values = {"m_tool": 2.5, "reach": 0.125}
    tool = 2 * parameter("m_tool") + Fraction(1, 4)
    tuned = replace(last, mass=tool, joint=replace(last.joint, a=parameter("reach")))
    by_name = replace(fixed, links=(*fixed.links[:-1], tuned))
    filled = replace(last, mass=Fraction(21, 4), joint=replace(last.joint, a=Fraction(1, 8)))
    by_value = replace(fixed, links=(*fixed.links[:-1], filled))
    assert set(by_name.parameters) == set(values)
    q, qd, qdd = states(fixed, 3)
    want = Reference(by_value).inverse_dynamics(q, qd, qdd)
    np.testing.assert_array_equal(Reference(by_name, values).inverse_dynamics(q, qd, qdd), want)
    np.testing.assert_array_equal(exact(by_name, q, qd, qdd, values), exact(by_value, q, qd, qdd))
    np.testing.assert_array_equal(lagrangian(by_name, values)(q, qd, qdd), lagrangian(by_value)(q, qd, qdd))
    for call in (Reference, lagrangian):
        with pytest.raises(InputError, match="without values; found no reach"):
            call(by_name, {"m_tool": 1.0})
    with pytest.raises(InputError, match="without values"):
        exact_torque(by_name, [0, 0], [0, 0], [0, 0])


def test_states_of_the_wrong_shape() -> None:
    for call in (Reference(PENDULUM).inverse_dynamics, lagrangian(PENDULUM)):
        for q in ([1.0, 2.0], 1.0, [[[1.0]]], [[1.0], [2.0]]):
            with pytest.raises(InputError, match=r"wrong shape; found .*; expected \[1\] or \[N, 1\] each"):
                call(q, [0.0], [0.0])


def test_a_singular_arm_has_no_forward_dynamics() -> None:
    robot = Robot("ghost", (Link("nothing", joint()),))
    with pytest.raises(InputError, match="the mass matrix is singular"):
        Reference(robot).forward_dynamics([0.0], [0.0], [1.0])
