"""How exact a description is, as logs show it; errors of what only a prior says."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.diagnose.select.fit import Problem, by_prior, covariance, fitted, problem, tighter
from robodyn.diagnose.select.limits import LEAST_PRIOR_SHARE
from robodyn.diagnose.select.prior_share import prior_share

SAMPLES, NUMBERS = 400, 20


def log_of(share: float, seed: int, size: float = 3.0) -> Problem:
    """A log of an arm that is wrong by a ``share`` of what is said; each number shows by ``size``."""
    rng = np.random.default_rng(seed)
    Y = size * rng.standard_normal((SAMPLES, 1, NUMBERS))
    wrong = share * rng.standard_normal(NUMBERS)
    return problem(Y @ wrong + rng.standard_normal((SAMPLES, 1)), Y, np.ones(1), 1.0)


@pytest.mark.parametrize("share", [1.0, 0.3, 0.1])
def test_the_share_of_what_is_said_shows(share: float) -> None:
    logs = [log_of(share, seed) for seed in range(5)]
    shares = [prior_share(p, fitted(p)) for p in logs]
    assert 0.75 * share < np.mean(shares) < min(1.3 * share, 1.0)


def test_nothing_is_taken_to_be_exact_that_does_not_show() -> None:
    p = log_of(0.0, 1)
    assert prior_share(p, fitted(p)) < 3 * LEAST_PRIOR_SHARE
    p = log_of(0.0, 1, size=0.01)
    assert prior_share(p, fitted(p)) > 0.95
    p = tighter(p, LEAST_PRIOR_SHARE)
    assert prior_share(p, fitted(p)) == pytest.approx(LEAST_PRIOR_SHARE)


@pytest.mark.parametrize("share", [1.0, 0.03])
def test_intervals_beside_the_arms_numbers_hold_however_exact_these_are(share: float) -> None:
    off = []
    for seed in range(60):
        rng = np.random.default_rng((seed, 7))
        column = log_of(0.0, seed).A[:, :, :1].astype(np.float64) + 0.1 * rng.standard_normal((SAMPLES, 1, 1))
        p = log_of(share, seed).with_columns((0,), column)
        p = tighter(p, prior_share(p, fitted(p)))
        off.append(abs(fitted(p).known[-1]) / np.sqrt(covariance(p, fitted(p))[-1, -1]))
    assert 53 <= np.sum(np.array(off) < 1.96) <= 60
    assert np.median(off) > 0.3


def test_what_no_torque_shows_is_known_as_well_as_its_prior_says() -> None:
    rng = np.random.default_rng(2)
    columns = np.concatenate([rng.standard_normal((SAMPLES, 1, 1)), np.zeros((SAMPLES, 1, 1))], axis=2)
    p = log_of(0.0, 2).with_columns((0,), columns, np.array([5.0, 7.0]))
    seen, unseen = np.sqrt(np.diag(covariance(p, fitted(p)))[-2:])
    assert unseen == pytest.approx(7.0, rel=0.3)
    assert seen < 0.2
    own = np.sqrt(np.sum(by_prior(p, slice(NUMBERS, NUMBERS + 2)) ** 2, axis=1))
    assert own[0] < 0.05 * seen
    assert own[1] > 0.7 * unseen
