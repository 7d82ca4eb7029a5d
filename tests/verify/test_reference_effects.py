"""The reference with effects: beside Pinocchio, and by hand."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

import robodyn
from effects.cases import entry
from robodyn.errors import InputError
from robodyn.robot.model import EffectEntry, Inertia, Robot
from robodyn.robot.values import parameter
from robodyn.verify import Reference
from robodyn_testing import constant, require_module
from robodyn_testing.random_robots import random_robot

PUMA = robodyn.load("puma560", warn=lambda _: None)
F = Fraction
TENSOR = Inertia(F(1, 50), F(1, 40), F(1, 60), F(1, 500), F(0), F(-1, 400))
LOAD = {"mass": F(5, 2), "com": (F(1, 10), F(-1, 20), F(1, 8)), "inertia": TENSOR}


def arm(*entries: EffectEntry, **changes: Any) -> Robot:
    return replace(PUMA, effects=entries, **changes)


def states(n: int = 6, count: int = 20, seed: int = 0) -> Any:
    rng = np.random.default_rng(seed)
    shape = (count, n)
    return rng.uniform(-3, 3, shape), rng.uniform(-2, 2, shape), rng.uniform(-5, 5, shape)


def close(found: Any, expected: Any, rel: float = 1e-12) -> None:
    np.testing.assert_allclose(found, expected, rtol=0, atol=rel * np.abs(expected).max())


# --- the rigid arm ----------------------------------------------------------------------------------------


def pinocchio(robot: Robot) -> Any:
    """Pinocchio's model of the rigid arm with its payload, built joint by joint."""
    pin = require_module("pinocchio")
    from peers.numbers import inertia_tensor
    from peers.pinocchio_peer import pinocchio_model

    model = pinocchio_model(replace(robot, effects=()))
    model.armature = np.zeros(robot.n)
    for load in robot.effects:
        com = np.array([float(x) for x in load["com"]])
        body = pin.Inertia(load.number("mass"), com, inertia_tensor(load["inertia"]))
        model.appendBodyToJoint(robot.n, body, pin.SE3.Identity())
    return pin, model


@pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")
@pytest.mark.parametrize("seed", [None, 3, 11])
def test_forces_in_the_joints_are_pinocchios(seed: int | None) -> None:
    """Seen through bearings: radial, thrust and journal, each at every joint, under a payload."""
    bare = PUMA if seed is None else random_robot(seed, joints=4, degenerate=0.0)
    bare = replace(bare, effects=(entry("payload", None, **LOAD),), torque_side="link", rest_velocity=None)
    pin, model = pinocchio(bare)
    data = model.createData()
    q, qd, qdd = states(bare.n)
    tau, f, n = np.empty(q.shape), np.empty((*q.shape, 3)), np.empty((*q.shape, 3))
    for k in range(len(q)):
        tau[k] = pin.rnea(model, data, q[k], qd[k], qdd[k])
        for i in range(bare.n):
            f[k, i], n[k, i] = data.f[i + 1].linear, data.f[i + 1].angular
    plain = Reference(bare).inverse_dynamics(q, qd, qdd)
    close(plain, tau)
    mu, span, way = 0.25, 0.5, np.sign(qd)
    carried = [f[..., :2] / 2 + s * np.stack([n[..., 1], -n[..., 0]], axis=-1) / span for s in (1, -1)]
    for kind, expected in (
        ("radial", np.hypot(f[..., 0], f[..., 1])),
        ("thrust", np.abs(f[..., 2])),
        ("journal", sum(np.linalg.norm(x, axis=-1) for x in carried)),
        ("linear", sum(np.abs(x).sum(axis=-1) for x in carried)),
    ):
        given: dict[str, Any] = {"mu": F(1, 4), "span": F(1, 2)} if kind == "linear" else {"mu_r": F(1, 4)}
        given |= {"span": F(1, 2)} if kind == "journal" else {}
        bearings = tuple(
            entry("load_dependent_friction", i + 1, bearing=kind, **given) for i in range(bare.n)
        )
        found = Reference(replace(bare, effects=bare.effects + bearings)).inverse_dynamics(q, qd, qdd)
        close(found - plain, mu * expected * way, 1e-11)


# --- the drive --------------------------------------------------------------------------------------------

SECOND = (
    entry("spring", 2, stiffness=F(12), rest=F(1, 5), cubic=F(-3)),
    entry("load_dependent_friction", 2, bearing="torque", mu=F(1, 10)),
    entry("load_dependent_friction", 2, bearing="torque", mu=F(1, 20)),
    entry("transmission_loss", 2, breakaway=F(2), efficiency=F(4, 5)),
    entry("asymmetric_friction", 2, positive=F(3), negative=F(1)),
    entry("stribeck_friction", 2, level=F(2), static=F(5), velocity=F(1, 2), exponent=F(1)),
    entry("torque_ripple", 2, amplitude=F(1, 2), cycles_per_rev=F(9), phase=F(1, 4)),
    entry("presliding_hysteresis", 2, stiffness=F(1000), level=F(7), damping=F(3)),
    entry("joint_elasticity", 2, stiffness=F(1000)),
    entry("torque_bias", 2, bias=F(100)),
    entry("torque_gain", 2, gain=F(100)),
)


def by_hand(q: float, qd: float, qdd: float, rigid: float, link_side: bool) -> float:
    """Joint 2 of the arm with the effects ``SECOND``, in the order of a drive."""
    joint = PUMA.links[1].joint
    way = int(np.sign(qd))
    total = rigid + 12 * (q - 0.2) - 3 * (q - 0.2) ** 3
    total += (0.1 + 0.05) * abs(total) * way
    if link_side:
        return total
    if way:
        total = (total / 0.8 if total * way > 0 else total * 0.8) + 2 * way
    total += (
        constant(joint.motor_inertia) * qdd + constant(joint.viscous) * qd + constant(joint.coulomb) * way
    )
    total += {1: 3, 0: 0, -1: -1}[way] + way * (2 + 3 * np.exp(-abs(qd) / 0.5)) + 7 * way
    return float(total + 0.5 * np.sin(9 * q + 0.25))


@pytest.mark.parametrize("side", ["motor", "link"])
def test_the_order_of_a_drive(side: Any) -> None:
    robot = arm(*SECOND, torque_side=side)
    q, qd, qdd = states()
    qd[:3] = 0.0
    found = Reference(robot).inverse_dynamics(q, qd, qdd)
    plain = Reference(arm(torque_side=side)).inverse_dynamics(q, qd, qdd)
    rigid = Reference(arm(torque_side="link")).inverse_dynamics(q, qd, qdd)[:, 1]
    rows = zip(q[:, 1], qd[:, 1], qdd[:, 1], rigid, strict=True)
    close(found[:, 1], [by_hand(*row, side == "link") for row in rows])
    others = [0, 2, 3, 4, 5]
    np.testing.assert_array_equal(found[:, others], plain[:, others])


@pytest.mark.parametrize(("rest", "band"), [(F(1, 10), None), (None, F(1))])
def test_directions_near_rest(rest: Fraction | None, band: Fraction | None) -> None:
    q, qd, qdd = states()
    robot = arm(SECOND[4], SECOND[3], rest_velocity=rest, dead_band=band)
    found = Reference(robot).inverse_dynamics(q, qd, qdd)[:, 1]
    joint = PUMA.links[1].joint
    tau = Reference(arm(torque_side="link")).inverse_dynamics(q, qd, qdd)[:, 1]
    v = qd[:, 1]
    s = np.tanh(v * 10) if rest else np.where(np.abs(v) < 1, 0, np.sign(v))
    tau = tau * (1 + ((1 / 0.8 + 0.8) / 2 - 1) * np.abs(s)) + np.abs(tau) * s * (1 / 0.8 - 0.8) / 2 + 2 * s
    tau += (
        constant(joint.motor_inertia) * qdd[:, 1] + constant(joint.viscous) * v + constant(joint.coulomb) * s
    )
    close(found, tau + (3 + 1) / 2 * s + (3 - 1) / 2 * np.abs(s))
    assert len(set(np.sign(s))) == (2 if rest else 3)


COUPLING = entry(
    "motor_coupling", 5, **{"with": 6}, ratio=F(-3, 4), inertia=F(1, 25), viscous=F(2), coulomb=F(3)
)


def test_a_motor_of_two_joints() -> None:
    q, qd, qdd = states()
    with_it, without = Reference(arm(COUPLING)), Reference(PUMA)
    u, a = (x[:, 4] - 0.75 * x[:, 5] for x in (qd, qdd))
    T = 0.04 * a + 2 * u + 3 * np.sign(u)
    added = np.zeros_like(q)
    added[:, 4], added[:, 5] = T, -0.75 * T
    close(with_it.inverse_dynamics(q, qd, qdd), without.inverse_dynamics(q, qd, qdd) + added)
    M = without.mass_matrix(q)
    M[:, 4:, 4:] += 0.04 * np.array([[1, -0.75], [-0.75, 0.5625]])
    close(with_it.mass_matrix(q), M)
    link = Reference(arm(COUPLING, torque_side="link"))
    plain = Reference(arm(torque_side="link"))
    np.testing.assert_array_equal(link.inverse_dynamics(q, qd, qdd), plain.inverse_dynamics(q, qd, qdd))
    np.testing.assert_array_equal(link.mass_matrix(q), plain.mass_matrix(q))


def test_functions_fit_together() -> None:
    """The matrix is the slope of the torque, gravity the torque at rest, bias that without acceleration."""
    entries = [e for e in SECOND if e.effect not in ("load_dependent_friction", "transmission_loss")]
    reference = Reference(arm(*entries, COUPLING, entry("payload", None, **LOAD)))
    q, qd, qdd = states()
    M, bias = reference.mass_matrix(q), reference.bias(q, qd)
    close(M, np.swapaxes(M, 1, 2))
    tau = reference.inverse_dynamics(q, qd, qdd)
    close(np.einsum("kij,kj->ki", M, qdd) + bias, tau)
    close(reference.forward_dynamics(q, qd, tau), qdd, 1e-11)
    zero = np.zeros_like(q)
    np.testing.assert_array_equal(reference.gravity(q), reference.inverse_dynamics(q, zero, zero))
    np.testing.assert_array_equal(bias, reference.inverse_dynamics(q, qd, zero))
    assert np.abs(reference.gravity(q) - Reference(PUMA).gravity(q))[:, 1].max() > 1


def loaded() -> Robot:
    bearings = [
        entry("load_dependent_friction", 1, bearing="journal", mu=F(1, 5), radius=F(1, 20), span=F(1, 4)),
        entry("load_dependent_friction", 3, bearing="radial", mu_r=F(1, 100)),
        *(entry("transmission_loss", i, breakaway=F(1), efficiency=1 - F(i, 20)) for i in range(1, 7)),
    ]
    return arm(*SECOND[:3], *bearings)


def test_accelerations_under_friction_that_depends_on_them() -> None:
    q, qd, qdd = states(count=40)
    qd[0] = 0.0
    tau = np.zeros_like(q)
    for robot in (loaded(), replace(loaded(), torque_side="link"), replace(loaded(), rest_velocity=F(1, 10))):
        reference = Reference(robot)
        tau = reference.inverse_dynamics(q, qd, qdd)
        close(reference.forward_dynamics(q, qd, tau), qdd, 1e-8)
        # Where the guess is far off, across a change of sign of the load.
        pushed = tau + np.random.default_rng(2).uniform(-100, 100, tau.shape)
        found = reference.forward_dynamics(q, qd, pushed)
        close(reference.inverse_dynamics(q, qd, found), pushed, 1e-11)
        np.testing.assert_allclose(reference.forward_dynamics(q[5], qd[5], pushed[5]), found[5], rtol=1e-7)
    assert np.abs(Reference(PUMA).forward_dynamics(q, qd, tau) - qdd).max() > 1


def test_accelerations_behind_very_poor_gears() -> None:
    """Newton's steps overshoot where most of the torque changes with its sign; they are halved then."""
    gears = (entry("transmission_loss", i, efficiency=F(1, 5)) for i in range(1, 7))
    reference = Reference(arm(*gears))
    q, qd, tau = np.random.default_rng(0).uniform(-10, 10, (3, 40, 6))
    close(reference.inverse_dynamics(q, qd, reference.forward_dynamics(q, qd, tau)), tau, 1e-8)


def test_an_arm_that_locks_is_refused() -> None:
    """More than all of the torque goes into the bearing: no acceleration brings back a torque of less."""
    jammed = entry("load_dependent_friction", 1, bearing="torque", mu=F(2))
    reference = Reference(arm(jammed, torque_side="link"))
    q, qd = np.zeros(6), np.array([1.0, 0, 0, 0, 0, 0])
    with pytest.raises(InputError, match="no accelerations fit the torques; found 1 of 1 states"):
        reference.forward_dynamics(q, qd, np.array([-5.0, 0, 0, 0, 0, 0]))


def test_run_time_names_are_numbers_filled_in() -> None:
    def made(k: Any, m: Any) -> Robot:
        spring = entry("spring", 3, stiffness=k, rest=F(1, 10))
        load = entry("payload", None, mass=m, com=(F(1, 10), m * F(1, 2), F(0)))
        pair = entry("motor_coupling", 4, **{"with": 5}, inertia=k * F(1, 4) + F(1))
        return arm(spring, load, pair)

    q, qd, qdd = states()
    named = made(parameter("k_hose"), parameter("m_tool"))
    assert set(named.parameters) == {"k_hose", "m_tool"}
    found = Reference(named, {"k_hose": 1.5, "m_tool": 0.25})
    filled = Reference(made(F(3, 2), F(1, 4)))
    np.testing.assert_array_equal(found.inverse_dynamics(q, qd, qdd), filled.inverse_dynamics(q, qd, qdd))
    np.testing.assert_array_equal(found.mass_matrix(q), filled.mass_matrix(q))
    with pytest.raises(InputError, match="without values; found no k_hose"):
        Reference(named, {"m_tool": 1.0})
