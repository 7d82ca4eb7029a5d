"""Strengths of effects, fitted together with the arm's own numbers; and rows of joints that rest."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

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
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn.robot.model import EffectEntry, Limits
from robodyn.simulate.trajectories import fourier
from robodyn.verify.reference import Reference


@pytest.mark.thorough
def test_a_load_dependent_loss_and_a_wrong_link_are_told_apart() -> None:
    """Each alone is wrong beside the other: what the loss does grows with the link."""
    described = load("puma560_3dof")
    described = replace(
        described, links=tuple(replace(link, confidence=Fraction(1, 2)) for link in described.links)
    )
    links = list(described.links)
    links[1] = replace(links[1], mass=links[1].mass * Fraction(7, 5))
    loss = EffectEntry("load_dependent_friction", 2, (("bearing", "torque"), ("mu", Fraction(3, 10))))
    truth = replace(described, links=tuple(links), effects=(loss,))
    limits = Limits((Fraction(-2), Fraction(2)), Fraction(2), Fraction(8))
    motion = fourier(described, 0.1, 5, default=limits, seed=4, periods=2, period=5e-3)
    rng = np.random.default_rng(1)
    tau = Reference(truth).inverse_dynamics(motion.q, motion.qd, motion.qdd)
    log = Log(motion.t, motion.q, None, None, tau + 0.05 * rng.standard_normal(tau.shape))
    gates = [inspect(log, described)]
    start = Amendment("load_dependent_friction", 2, {"bearing": "torque", "mu": 0.15})
    none = {name: frozenset[int]() for name in ("viscous", "coulomb", "rotor")}
    _, estimates = fit_with(described, [start], gates, Options(offsets=False, joints=none))
    mu = estimates["load_dependent_friction", 2]["mu"]
    assert mu.value == pytest.approx(0.3, rel=0.05)
    assert mu.stderr is not None
    assert abs(float(mu.value) - 0.3) < 4 * mu.stderr


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
