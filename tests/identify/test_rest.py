"""At rest dry friction is a set: speeds of rest, combinations of numbers, torques that are read late."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.blind_arms.arms import bare, perturbed, rubbing

import robodyn
from identify.exact import log_of, motion
from robodyn.gate.gate import inspect
from robodyn.identify.predict import lacking
from robodyn.logs.log import Log
from robodyn.report.identification import summary
from robodyn.robot.model import Robot
from robodyn.robot.reader import read_text

#: Published of the EMPS: moving mass with its rotor, viscous and Coulomb friction, offset of the force.
MASS, VISCOUS, COULOMB, OFFSET = 95.1, 203.5, 20.39, -3.16
SLIDE = """
name: slide
gravity: [0, 0, -9.81]
links:
  - joint: prismatic
    alpha: pi/2
    mass: 80
    confidence: 0.3
"""
TURNTABLE = """
name: turntable
links: [{joint: revolute, inertia: {zz: 0.5}, friction: {viscous: 0.4, coulomb: 0.4}}]
"""


def read(text: str) -> Robot:
    return read_text(text, warn=lambda _: None)


def slide(seconds: float = 24.0, rate: float = 1000.0) -> Log:
    """Back and forth between stops, as the EMPS is driven; position to 2e-6 m, noisy force."""
    rng = np.random.default_rng(7)
    t = np.arange(round(seconds * rate)) / rate
    q, qd, qdd = (np.zeros(len(t)) for _ in range(3))
    for w, a in ((2.1, 0.06), (4.7, 0.02), (9.2, 0.006)):
        q += a * np.sin(w * t)
        qd += a * w * np.cos(w * t)
        qdd -= a * w * w * np.sin(w * t)
    force = MASS * qdd + VISCOUS * qd + COULOMB * np.sign(qd) + OFFSET + rng.normal(0, 1.0, len(t))
    return Log(t, np.round(q / 2e-6)[:, None] * 2e-6, None, None, force[:, None])


def test_a_slide_shows_mass_and_rotor_together() -> None:
    outcome = robodyn.identify(read(SLIDE), [slide()])
    (together,) = (one for one in outcome.combinations if "link1.mass" in one.expression)
    assert set(together.expression.split(" + ")) == {"link1.mass", "joint1.rotor_inertia.inertia"}
    assert abs(together.value - MASS) < 2.6 * together.stderr
    assert together.stderr < 0.01 * MASS
    published = {
        "viscous_friction.coefficient": VISCOUS,
        "coulomb_friction.level": COULOMB,
        "torque_bias.bias": OFFSET,
    }
    for name, known in published.items():
        one = outcome.parameters[f"joint1.{name}"]
        assert one.stderr is not None
        assert abs(one.value - known) < 2.6 * one.stderr
        assert not one.only_in_combination
    assert outcome.parameters["link1.mass"].only_in_combination
    lines = summary(outcome, "x")
    assert any(line.startswith("rotor inertia") and "in combination" in line for line in lines)
    assert any(" + " in line and "joint1.rotor_inertia.inertia" in line for line in lines)


def sticking(seconds: float = 30.0) -> Log:
    """A turntable that rests half of the time, where friction holds whatever its drive gives."""
    t, q, _, _ = motion(1, rate=500.0, seconds=seconds)
    rng = np.random.default_rng(3)
    moves = np.clip(2 * np.sin(0.9 * t), 0.0, 1.0)[:, None]
    q = np.cumsum(moves * np.gradient(q, t, axis=0), axis=0) / 500
    qd = np.gradient(q, t, axis=0)
    qdd = np.gradient(qd, t, axis=0)
    held = 0.35 * np.sign(np.sin(0.9 * t + 0.2))[:, None]
    dry = np.where(np.abs(qd) > 1e-3, 0.4 * np.sign(qd), held)
    return Log(t, q, None, None, 0.5 * qdd + 0.4 * qd + dry + rng.normal(0, 0.02, q.shape))


def test_what_friction_holds_at_rest_biases_nothing() -> None:
    outcome = robodyn.identify(
        read(TURNTABLE.replace("viscous: 0.4, coulomb: 0.4", "viscous: 0.1")), [sticking()]
    )
    assert 0.3 < outcome.residual.rest_share[0] < 0.7
    assert outcome.residual.validate_after[0] < 1.5 * 0.02
    for name, known in (("coulomb_friction.level", 0.4), ("viscous_friction.coefficient", 0.4)):
        assert outcome.parameters[f"joint1.{name}"].value == pytest.approx(known, abs=0.02)


def test_a_direction_that_is_not_resolved_is_a_ramp() -> None:
    """Of a model with speeds of rest dry friction is on average less below them."""
    robot = read(TURNTABLE)
    t, q, qd, qdd = motion(1, rate=500.0)
    speed = 0.5
    tau = 0.5 * qdd + 0.4 * qd + 0.4 * np.clip(qd / speed, -1, 1)
    gate = inspect(Log(t, q, None, None, tau), robot)
    inner = slice(250, -250)
    assert np.abs(lacking(robot, gate, np.array([speed]))[inner]).max() < 0.02
    assert np.abs(lacking(robot, gate)[inner]).max() > 0.3
    found = robodyn.identify(robot, [gate.log]).fit.rest.speeds[0]
    assert speed / 2 < found < 2 * speed


@pytest.mark.parametrize("late", [0.02, 0.0])
def test_torques_that_are_read_late_are_noted(late: float) -> None:
    arm = rubbing(bare("puma560_3dof"))
    log = log_of(arm, noise=0.01)
    tau = np.stack([np.interp(log.t - late, log.t, x) for x in log.tau.T], axis=1)
    outcome = robodyn.identify(perturbed(arm, 0.1, 3), [replace(log, tau=tau)])
    if late:
        (one,) = outcome.torque_delay
        assert abs(one.value - late) < 2.6 * one.stderr
        assert one.stderr < 0.1 * late
        assert any("late" in line for line in outcome.words)
    else:
        assert not outcome.torque_delay
