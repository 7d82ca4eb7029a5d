"""Strengths of effects, fitted together with the arm's own numbers; and rows of joints that rest."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.amend.amend import Amendment
from robodyn.diagnose.refit import _with_estimates, without_vague_claim
from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.fit import less, problem, without
from robodyn.diagnose.select.limits import REST_WEIGHT
from robodyn.diagnose.select.selection import weight_of
from robodyn.diagnose.strengths import fit_with
from robodyn.gate.gate import inspect
from robodyn.identify.fit import Options
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Limits
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference

NONE = {name: frozenset[int]() for name in ("viscous", "coulomb", "rotor")}
DESCRIBED = load("puma560_3dof")


def fitted_with(lacks: EffectEntry, start: Amendment, periods: int) -> tuple[Any, Any, Any, Any]:
    """A fit of the arm, known to half, to a log of it with what it lacks and a second link 40 % heavier: the
    outcome, the estimates, the motion and its torques with noise of 0.05."""
    links = list(DESCRIBED.links)
    links[1] = replace(links[1], mass=links[1].mass * Fraction(7, 5))
    truth = replace(DESCRIBED, links=tuple(links), effects=(lacks,))
    limits = Limits((Fraction(-2), Fraction(2)), Fraction(2), Fraction(8))
    limited = [replace(link, joint=replace(link.joint, limits=limits)) for link in DESCRIBED.links]
    motion = fourier(replace(DESCRIBED, links=tuple(limited)), 0.1, 5, seed=4, periods=periods, period=5e-3)
    tau = Reference(truth).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    tau = tau + 0.05 * np.random.default_rng(1).standard_normal(tau.shape)
    guess = tuple(replace(link, confidence=Fraction(1, 2)) for link in DESCRIBED.links)
    gates = [inspect(Log(motion.t, motion.q, None, None, tau), DESCRIBED)]
    options = Options(offsets=False, joints=NONE)
    return *fit_with(replace(DESCRIBED, links=guess), [start], gates, options), motion, tau


@pytest.mark.thorough
def test_a_spring_and_a_wrong_link_are_told_apart() -> None:
    """Each alone is wrong beside the other: either bears weight."""
    settings = (("stiffness", Fraction(30)), ("rest", Fraction(0)), ("cubic", Fraction(0)))
    start = Amendment("spring", 2, {"stiffness": 18.0, "rest": 0.0, "cubic": 0.0})
    _, estimates, *_ = fitted_with(EffectEntry("spring", 2, settings), start, periods=2)
    stiffness = estimates["spring", 2]["stiffness"]
    assert stiffness.value == pytest.approx(30.0, rel=0.05)
    assert abs(float(stiffness.value) - 30.0) < 4 * stiffness.stderr


@pytest.mark.thorough
def test_friction_under_load_is_held_and_follows_the_arms_new_numbers() -> None:
    loss = EffectEntry("load_dependent_friction", 2, (("bearing", "torque"), ("mu", Fraction(3, 10))))
    start = Amendment("load_dependent_friction", 2, {"bearing": "torque", "mu": 0.3})
    outcome, estimates, motion, tau = fitted_with(loss, start, periods=1)
    assert not any(estimates.values())
    assert outcome.robot.effects == (loss,)
    left = tau - Model(outcome.robot).torque(motion.q, motion.qd, motion.qdd)
    moves = np.abs(motion.qd[:, 1]) > 0.2
    assert np.sqrt(np.mean(left[moves, 1] ** 2)) < 1.5 * 0.05


def test_rows_of_joints_that_rest_count_little() -> None:
    resting = np.zeros((100, 2), dtype=bool)
    resting[:40, 0] = True  # rests for a while
    resting[:95, 1] = True  # hardly moves: there is nothing better
    weight = weight_of(resting)
    assert set(weight[:40, 0]) == {REST_WEIGHT}
    assert set(weight[40:, 0]) == {1.0}
    assert set(weight[:, 1]) == {1.0}


def test_weights_reach_all_that_is_summed() -> None:
    rng = np.random.default_rng(2)
    rest, Y, column = (
        rng.standard_normal((200, 2)),
        rng.standard_normal((200, 2, 3)),
        rng.standard_normal((200, 1, 1)),
    )
    weight = rng.uniform(0.2, 1.0, (200, 2))
    p = problem(rest, Y, np.array([1.0, 2.0]), 1.0, None, weight)
    q = less(p.with_columns((1,), column), (1,), column[:, :, 0])
    expected = weight[:, 1] * column[:, 0, 0] / 2
    np.testing.assert_allclose(q.A[:, 1, -1], expected)
    np.testing.assert_allclose(q.rest[:, 1], weight[:, 1] * (rest[:, 1] - column[:, 0, 0]) / 2)
    gone = without(q, np.arange(200) < 50)
    assert not gone.weight[:50].any()
    assert gone.usual(gone.rest).shape == (2,)


@pytest.mark.parametrize(("stderr", "is_claim"), [(0.4, True), (0.6, False), (None, True)])
def test_a_claim_of_one_number_needs_that_number(stderr: float | None, is_claim: bool) -> None:
    offset = {"offset": Estimate(-1.0, stderr, "rad")}
    finding = Finding("encoder_offset", 2, offset, 0.95, (), "", None, 9.0, 3.0)
    assert (without_vague_claim(finding).confidence > 0.5) is is_claim
    two = replace(finding, parameters={**offset, "other": Estimate(1.0, 0.01, "1")})
    assert without_vague_claim(two).confidence == 0.95


@pytest.mark.parametrize(("id", "is_claim"), [("inertial_error", True), ("payload", False)])
def test_sums_of_a_links_numbers_are_known_where_each_is_vague(id: str, is_claim: bool) -> None:
    finding = Finding(id, 2, {}, 0.95, (), "", None, 100.0, 5.0)
    names = {"inertial_error": ("delta_mass", "delta_com_x"), "payload": ("mass", "com_x")}[id]
    estimates = {name: Estimate(0.8, 0.9, "kg") for name in names}
    assert (_with_estimates(finding, estimates).confidence > 0.5) is is_claim
