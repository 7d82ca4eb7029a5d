"""False names over the whole fleet, and how rare the largest of many is."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import chi2, norm

from robodyn.fleet.pool.changes import DAY, courses
from robodyn.fleet.pool.names import false_shares, inflation, tail


def test_false_shares_are_those_of_the_paper() -> None:
    """The example of Benjamini and Hochberg 1995, section 3.2: fifteen tests, four rejected at 0.05."""
    p = np.array([0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344, 0.0459])
    p = np.concatenate([p, [0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0]])
    order = np.random.default_rng(1).permutation(len(p))
    shares = np.empty(len(p))
    shares[order] = false_shares(p[order])
    assert (shares <= 0.05).sum() == 4
    assert shares[0] == pytest.approx(0.0001 * 15)
    assert (np.diff(shares) >= 0).all()


def test_names_are_false_as_often_as_stated() -> None:
    rng = np.random.default_rng(2)
    false, named = 0, 0
    for _ in range(300):
        z = rng.standard_normal(400)
        z[:20] += 4.5
        shares = false_shares(2 * norm.sf(np.abs(z)))
        false += int((shares[20:] <= 0.1).sum())
        named += int((shares <= 0.1).sum())
    assert 0.07 < false / named < 0.12


def test_the_largest_of_many_is_no_rarer_than_it_should_be() -> None:
    """The scan over days and courses: a level of 5 % is kept, and not by far."""
    rng = np.random.default_rng(3)
    dates = np.sort(rng.uniform(0, 365 * DAY, 12))
    several = courses(dates)
    centred = several.shares - several.shares.mean(axis=1, keepdims=True)
    centred /= np.sqrt((centred**2).sum(axis=1, keepdims=True))
    worth = ((rng.standard_normal((4000, 12)) @ centred.T) ** 2 / 2).max(axis=1)
    p = np.array([tail(x, 1, several.worth) for x in worth])
    assert 0.01 < (p < 0.05).mean() < 0.06
    assert (p < 0.001).mean() < 0.003


def test_inflation_is_that_of_the_middle() -> None:
    rng = np.random.default_rng(4)
    worth = chi2.rvs(2, size=4000, random_state=rng) / 2
    assert inflation(worth, 2) == pytest.approx(1.0, abs=0.08)
    assert inflation(2.5 * worth, 2) == pytest.approx(2.5, rel=0.08)
    worth[:200] += 40.0
    assert inflation(worth, 2) < 1.15
