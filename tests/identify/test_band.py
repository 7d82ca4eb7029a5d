"""Through which filter motion is seen where models are set beside raw torques."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import robodyn
from identify.exact import motion
from robodyn.gate.gate import inspect
from robodyn.identify.band import banded
from robodyn.identify.predict import blurred_torque, lacking, model_torque, predicted
from robodyn.logs.limits import ENOUGH_CUTOFF
from robodyn.logs.log import Log
from robodyn.logs.signals import low_pass
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text

INERTIA, LEVEL, VISCOUS, NOISE = 0.5, 0.4, 0.4, 0.02
TURNTABLE = f"""
name: turntable
links:
  - joint: revolute
    inertia: {{zz: {INERTIA}}}
    friction: {{viscous: {VISCOUS}, coulomb: {LEVEL}}}
"""


def turntable(text: str = TURNTABLE) -> Robot:
    return read_text(text, warn=lambda _: None)


def soft(bits: int = 20, seconds: float = 12.0) -> Log:
    """The turntable under a torque without jumps, at 1 kHz: where it turns round, its acceleration jumps."""
    rng = np.random.default_rng(4)
    fine, step = 4, 2.5e-4
    t = np.linspace(0.0, seconds, round(seconds / step), endpoint=False)
    tau = sum(4.0 * np.sin(w * t + p) for w, p in zip((3.1, 5.3, 9.7), rng.uniform(0, 6, 3), strict=True))
    q, v, places = 0.0, 0.0, np.empty(len(t))
    for k, torque in enumerate(tau.tolist()):
        places[k] = q
        free = v + step * (torque - VISCOUS * v) / INERTIA
        rub = step * LEVEL / INERTIA
        v = free - rub if free > rub else free + rub if free < -rub else 0.0
        q += step * v
    unit = 2 * np.pi / 2**bits
    t, q_seen = t[::fine], (np.round(places / unit) * unit)[::fine, None]
    return Log(t, q_seen, None, None, tau[::fine, None] + NOISE * rng.standard_normal((len(t), 1)))


def stiff() -> Log:
    """The turntable on a smooth way: where it turns round, the torque jumps."""
    t, q, qd, qdd = motion(1, rate=1000.0)
    tau = INERTIA * qdd + VISCOUS * qd + LEVEL * np.sign(qd)
    return Log(t, q, None, None, tau + NOISE * np.random.default_rng(1).standard_normal(tau.shape))


def test_where_the_acceleration_jumps_friction_goes_through_the_filter() -> None:
    robot, log = turntable(), soft()
    (gate,) = banded(robot, [inspect(log, robot)])
    assert gate.blurred
    left = np.sqrt(np.mean(lacking(robot, gate)[200:-200] ** 2))
    fixed = replace(inspect(log, robot), cutoff=ENOUGH_CUTOFF)
    plainly = np.sqrt(np.mean(lacking(robot, fixed)[200:-200] ** 2))
    assert left < 1.1 * NOISE
    assert plainly > 2 * left


def test_a_torque_that_jumps_is_set_beside_friction_that_jumps() -> None:
    robot, log = turntable(), stiff()
    (gate,) = banded(robot, [inspect(log, robot)])
    assert not gate.blurred
    assert np.sqrt(np.mean(lacking(robot, gate)[200:-200] ** 2)) < 1.5 * NOISE


def test_noise_of_coarse_encoders_is_kept_out() -> None:
    robot = turntable()
    fine, coarse = (banded(robot, [inspect(soft(bits), robot)])[0].cutoff for bits in (20, 13))
    assert fine is not None
    assert coarse is not None
    assert coarse < 0.8 * fine


def test_what_moves_fast_is_let_through() -> None:
    """A motion up to 20 Hz, with encoders that can tell it."""
    t = np.linspace(0.0, 6.0, 6000, endpoint=False)
    q = 0.3 * np.sin(9 * t) + 1e-3 * np.sin(2 * np.pi * 20 * t)
    qd, qdd = np.gradient(q, t), np.gradient(np.gradient(q, t), t)
    tau = INERTIA * qdd + VISCOUS * qd + NOISE * np.random.default_rng(1).standard_normal(len(t))
    robot = turntable(TURNTABLE.partition("    friction")[0])
    (gate,) = banded(robot, [inspect(Log(t, q[:, None], None, None, tau[:, None]), robot)])
    assert gate.cutoff is not None
    assert gate.cutoff > 25


def test_friction_and_inertia_unknown_the_arm_is_identified_to_the_noise() -> None:
    guess = turntable("name: turntable\nlinks: [{joint: revolute, inertia: {zz: 0.65}, confidence: 0.3}]\n")
    residual = robodyn.identify(guess, [soft()]).residual
    assert residual.validate_after[0] < 1.1 * NOISE
    assert residual.validate_before[0] > 50 * NOISE


@pytest.mark.parametrize(
    "effect", ["", "effects: [{effect: presliding_hysteresis, stiffness: 4000, level: 1}]"]
)
def test_blurred_friction_is_the_same_friction_through_the_filter(effect: str) -> None:
    """Away from where the joint turns round nothing changes; there the jump becomes the filter's step. What
    remembers is filtered as it comes out of the kernel."""
    law = effect or "friction: {coulomb: 1}"
    robot = turntable(f"name: one\nlinks: [{{joint: revolute, inertia: {{zz: 0.5}}, {law}}}]\n")
    bare = turntable("name: one\nlinks: [{joint: revolute, inertia: {zz: 0.5}}]\n")
    t, q, qd, qdd = motion(1, rate=1000.0, seconds=4.0)
    sharp = model_torque(robot, t, q, qd, qdd)
    rigid = model_torque(bare, t, q, qd, qdd)
    expected = rigid + low_pass(sharp - rigid, 1000.0, 25.0)
    assert np.abs(sharp - expected).max() > 0.2
    assert np.allclose(blurred_torque(robot, t, q, qd, qdd, sharp, 25.0), expected, atol=1e-9)


def test_without_a_filter_of_its_own_a_log_is_seen_as_before() -> None:
    robot, log = turntable(), stiff()
    gate = inspect(log, robot)
    assert gate.cutoff is None
    assert not gate.blurred
    _, _, qd, qdd = motion(1, rate=1000.0)
    exact = INERTIA * qdd + VISCOUS * qd + LEVEL * np.sign(qd)
    assert np.median(np.abs(predicted(robot, gate) - exact)) < NOISE
