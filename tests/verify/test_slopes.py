"""Derivatives of the references: of each by its own way, equal to one another and to differences."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

import robodyn
from effects.cases import CASES, draw, entry
from robodyn.robot import read_text
from robodyn.robot.model import JointKind, Robot
from robodyn.verify import Reference, verify
from robodyn.verify.exact import exact_torque_slope
from robodyn_testing.random_robots import random_robot

Q, QD, QDD, DQ, DQD = np.random.default_rng(3).uniform(0.2, 1.4, (5, 3))


@pytest.mark.parametrize("seed", range(4))
def test_an_imaginary_step_and_exact_torques_agree(seed: int) -> None:
    """One by complex numbers through Newton-Euler, the other by differences of rational virtual work."""
    robot = random_robot(seed, joints=3)
    q, qd, qdd, dq, dqd = (x.tolist() for x in (Q, QD, QDD, DQ, DQD))
    values = dict.fromkeys(robot.parameters, 0.5)
    exact = exact_torque_slope(robot, q, qd, qdd, dq, dqd, values)
    slope = Reference(robot, values).torque_slope(Q, QD, QDD, DQ, DQD)
    np.testing.assert_allclose(slope, [float(x) for x in exact], rtol=1e-12, atol=1e-12 * np.abs(slope).max())


def _with(case: str) -> Robot:
    rng = random.Random(case)
    chosen = CASES[case]
    robot = random_robot(7, joints=3, exotic=0.0, degenerate=0.0)
    kind: JointKind = "revolute" if chosen.revolute else "prismatic"
    links = [replace(link, joint=replace(link.joint, kind=kind)) for link in robot.links]
    return replace(robot, links=tuple(links), effects=(entry(chosen.id, 1, **draw(chosen, rng)),))


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("smooth", [False, True])
def test_every_effect_is_differentiated(case: str, smooth: bool) -> None:
    """Complex numbers go through every equation: as differences of its own torques have it."""
    robot = replace(_with(case), rest_velocity=Fraction(1, 3) if smooth else None)
    reference = Reference(robot)
    slope, step = reference.torque_slope(Q, QD, QDD, DQ, DQD), 1e-6
    after, before = (reference.inverse_dynamics(Q + s * step * DQ, QD + s * step * DQD, QDD) for s in (1, -1))
    size = np.abs(reference.inverse_dynamics(Q, QD, QDD)).max() + np.abs(slope).max()
    np.testing.assert_allclose(slope, (after - before) / (2 * step), atol=1e-7 * size)


def test_smooth_friction_is_differentiated_exactly() -> None:
    robot = read_text(
        "name: a\nlinks: [{joint: revolute, mass: 1, com: [0.3, 0, 0], friction: {viscous: 2, coulomb: 3}}]\n"
        "friction_at_rest: {smooth: {velocity: 0.5}}"
    )
    (slope,) = exact_torque_slope(robot, [0.1], [0.2], [0.0], [0.0], [1.0])
    assert float(slope) == pytest.approx(2 + 3 * (1 - np.tanh(0.4) ** 2) / 0.5, rel=1e-14)


def test_what_no_energy_says_is_not_said_to_agree_with_energies() -> None:
    """Poses are compared with transforms, once; derivatives with what has them."""
    robot = read_text("name: a\nlinks: [{joint: revolute, a: 0.2, mass: 1, com: [0.3, 0, 0]}]")
    kernel = robodyn.compile(robot, functions=("forward_kinematics", "inverse_dynamics_derivatives"))
    report = verify(robot, kernel, states=20)
    assert report.passed
    against = {(comparison.function, comparison.against) for comparison in report.comparisons}
    functions = ("forward_kinematics", "inverse_dynamics_derivatives")
    assert against == {(function, oracle) for function in functions for oracle in ("reference", "exact")}
    assert "inverse_dynamics_derivatives with lagrangian" in report.skipped
