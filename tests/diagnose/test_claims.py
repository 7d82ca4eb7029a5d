"""A claim needs numbers that are known, or a sum of them."""

from __future__ import annotations

import math
from dataclasses import replace
from statistics import NormalDist
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.findings import laws_at_rest
from robodyn.diagnose.refit import _with_estimates, without_vague_claim
from robodyn.diagnose.result import Estimate, Finding
from robodyn.diagnose.select.compare import ahead
from robodyn.diagnose.select.limits import ODDS
from robodyn.diagnose.select.odds import odds
from robodyn.effects.friction import COULOMB, STRIBECK, VISCOUS
from robodyn.effects.rigid import PAYLOAD


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


def test_odds_are_shared_with_rivals() -> None:
    alone = odds([], 0.9)
    first, by_share, most = ODDS
    assert alone == pytest.approx(most / (1 + math.exp(-first - by_share * math.log(0.9 / 0.1))))
    assert odds([(0.0, 0.0)], 0.9) == pytest.approx(alone / 2)  # the log cannot tell them apart
    assert odds([(0.0, 0.0)] * 3, 0.9) == pytest.approx(alone / 4)
    assert odds([(0.0, 1.0)], 0.9) == pytest.approx(alone / (1 + math.exp(-1)))  # one number more, a nat
    behind = NormalDist().cdf(-2.0)
    assert odds([(2.0, 0.0)], 0.9) == pytest.approx(alone * (1 - behind))  # the odds that it is no worse
    # A rival that is ahead, and one that is simpler, counts as one that is level.
    assert odds([(-3.0, -2.0)], 0.9) == odds([(0.0, 0.0)], 0.9)


def test_what_blocks_say_is_held_against_signs_that_are_drawn() -> None:
    """Blocks tell unlike amounts: ten that all say the same are sure, whatever one of them says more."""
    every = NormalDist().inv_cdf(1 - 1 / 1024)
    assert ahead(np.array([100.0, *[2.0] * 9])) == pytest.approx(every)
    assert ahead(np.full(10, 5.0)) == pytest.approx(every)
    assert ahead(np.array([100.0, *[-2.0] * 9])) < 0.1  # one alone, against all others
    assert ahead(np.full(10, 0.01)) == pytest.approx(0.1)  # a tenth of a nat is none
    assert ahead(-np.full(10, 5.0)) < -3


def test_the_more_is_left_the_less_sure_is_a_name() -> None:
    alone = [odds([], share) for share in (0.0, 0.3, 0.6, 0.9, 1.0)]
    assert alone == sorted(set(alone))
    assert 0 < alone[0] < alone[-1] < 1


def test_what_changes_where_directions_are_not_resolved_is_a_rival_of_plain_friction() -> None:
    """Joint 1 is unresolved up to twice the speed that its rates and encoders make so, joint 2 is not."""
    rows: Any = SimpleNamespace(speeds=np.array([0.1, 0.02]), expected=np.array([0.05, 0.05]))
    assert list(laws_at_rest((COULOMB.id, 1), rows)) == [STRIBECK.id]
    for key in ((COULOMB.id, 2), (STRIBECK.id, 1), (VISCOUS.id, 1), (PAYLOAD.id, None)):
        assert laws_at_rest(key, rows) == {}
