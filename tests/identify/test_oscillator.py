"""Elastic joints: kernels that do not diverge, links that oscillate as another engine has them."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.blind_arms.cases import Case

from robodyn.diagnose.run import diagnose
from robodyn.gate.gate import inspect
from robodyn.identify.oscillator import Oscillator
from robodyn.identify.predict import lacking
from robodyn.kernels.robot_kernel import compile as compile_kernel

ELASTIC = Case("puma560", (("joint_elasticity", 2),), 1, 4.855)


def test_a_swing_is_that_of_a_damped_oscillator() -> None:
    """Mass 2, spring 800, damping 3, let go at 0.1: the formula of any textbook."""
    count, h = 4001, 5e-4
    one = np.ones(count)
    places = np.linspace(-1, 1, 401)
    found = Oscillator((0 * one, 2 * one, 0 * one, 0 * one), h, (800 * places, -1.0, 0.005), 3.0).motion(
        (0.1, 0.0)
    )
    t = h * np.arange(count)
    decay, turn = 3 / 4, np.sqrt(400 - (3 / 4) ** 2)
    exact = 0.1 * np.exp(-decay * t) * (np.cos(turn * t) + decay / turn * np.sin(turn * t))
    assert np.abs(found[:, 0] - exact).max() < 2e-4


def test_what_flies_off_is_not_finite() -> None:
    one = np.ones(50)
    found = Oscillator(
        (one, -1e-9 * one, 0 * one, 0 * one), 1.0, (1e-9 * np.arange(3.0), -1.0, 1.0), 0.0
    ).motion((1e300, 1e300))
    assert np.isnan(found[-1]).all()


@pytest.mark.slow
def test_an_elastic_joint_is_named_and_its_spring_found() -> None:
    hidden = ELASTIC.make()
    found = diagnose(hidden.given, [hidden.train], hidden.validate)
    assert [(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5] == [("joint_elasticity", 2)]
    stiffness = found.findings[0].parameters["stiffness"].value
    true = next(e for e in hidden.truth.robot.effects if e.effect == "joint_elasticity").number("stiffness")
    assert stiffness == pytest.approx(true, rel=0.15)


@pytest.mark.thorough
def test_the_true_spring_leaves_noise() -> None:
    hidden = ELASTIC.make()
    gate = inspect(hidden.validate, hidden.given)
    left = [
        np.sqrt(np.mean(lacking(robot, gate)[200:-200] ** 2, axis=0)) / hidden.truth.noise
        for robot in (hidden.given, hidden.truth.robot)
    ]
    assert left[0].max() > 1.4
    assert left[1].max() - 1 < 0.75 * (left[0].max() - 1)


@pytest.mark.thorough
def test_a_kernel_that_is_given_the_motors_motion_stays_bounded() -> None:
    hidden = ELASTIC.make()
    kernel = compile_kernel(hidden.truth.robot, functions=["inverse_dynamics"], optimize="fast", mode="abi")
    log = hidden.truth.clean
    assert log.qd is not None
    assert log.qdd is not None
    tau = kernel.inverse_dynamics(log.q, log.qd, log.qdd, dt=1e-3)
    assert np.isfinite(tau).all()
    assert np.abs(tau).max() < 10 * np.abs(log.tau).max()
