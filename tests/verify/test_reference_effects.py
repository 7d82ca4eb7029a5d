"""The reference with effects: forces beside Pinocchio, and accelerations put back."""

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
from robodyn.verify import Reference
from robodyn_testing import require_module
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
)


def loaded() -> Robot:
    bearings = [
        entry("load_dependent_friction", 1, bearing="journal", mu=F(1, 5), radius=F(1, 20), span=F(1, 4)),
        entry("load_dependent_friction", 3, bearing="radial", mu_r=F(1, 100)),
        *(entry("transmission_loss", i, breakaway=F(1), efficiency=1 - F(i, 20)) for i in range(1, 7)),
    ]
    return arm(*SECOND, *bearings)


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
