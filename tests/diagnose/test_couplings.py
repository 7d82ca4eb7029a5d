"""Motors that drive two joints: looked for where a shaft can reach, and only with an inertia."""

from __future__ import annotations

import numpy as np
import pytest

from identify.exact import log_of
from robodyn.diagnose.select.choice import confidence_of
from robodyn.diagnose.select.library import Candidate, candidates, context_of
from robodyn.diagnose.select.library.limits import COUPLED_BEYOND_SHARE
from robodyn.diagnose.select.scope import Scope
from robodyn.kernels.array_dynamics import Model
from robodyn.logs.signals import signals_of
from robodyn.robot import load


@pytest.fixture(scope="module")
def couplings() -> list[Candidate]:
    robot = load("puma560", warn=lambda _: None)
    context = context_of(Model(robot), signals_of(log_of(robot, noise=0.01, seconds=2.0)))
    return list(candidates(context, Scope(frozenset({"motor_coupling"}))))


def test_no_motor_reaches_over_two_joints(couplings: list[Candidate]) -> None:
    likely = [one for one in couplings if one.likely(np.ones(3))]
    assert len(likely) < len(couplings)
    shares = {(k, j): one.least_share for one in likely for j, k in [one.rows]}
    near = {(j, j + 1): 0.0 for j in range(5)}
    assert shares == near | {(j, j + 2): COUPLED_BEYOND_SHARE for j in range(4)}


def test_a_motor_has_an_inertia(couplings: list[Candidate]) -> None:
    assert not any(one.feasible(np.array([0.0, 2.0, 3.0])) for one in couplings)
    assert all(one.feasible(np.array([1e-3, 0.0, 0.0])) for one in couplings)


def test_a_name_with_three_rivals_is_no_claim() -> None:
    sure = [confidence_of("abcd"[:rivals]) for rivals in range(5)]
    assert sure == sorted(sure, reverse=True)
    assert [each >= 0.5 for each in sure] == [True, True, True, False, False]
