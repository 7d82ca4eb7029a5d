"""False names over the whole fleet, and how rare the largest of many is."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import chi2, f, norm

from robodyn.draw.scales import DAY
from robodyn.fleet.pool.changes import courses
from robodyn.fleet.pool.names import Chance, Odds, chance_of, false_shares, of_several
from robodyn.fleet.pool.population import Series, common_of, spread_of


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
    p = _odds(worth, tests=several.worth).tails(Chance())
    assert 0.01 < (p < 0.05).mean() < 0.06
    assert (p < 0.001).mean() < 0.003


def test_inflation_is_that_of_the_middle() -> None:
    rng = np.random.default_rng(4)
    worth = chi2.rvs(2, size=4000, random_state=rng) / 2
    assert chance_of(_odds(worth, 2)).inflation == pytest.approx(1.0, abs=0.08)
    assert chance_of(_odds(2.5 * worth, 2)).inflation == pytest.approx(2.5, rel=0.08)
    worth[:120] += 40.0
    assert chance_of(_odds(worth, 2)).inflation < 1.15


@pytest.mark.parametrize(("freedom", "likely"), [(np.inf, (15.0, np.inf)), (6.0, (4.0, 10.0))])
def test_heavy_tails_are_seen_where_most_units_are(freedom: float, likely: tuple[float, float]) -> None:
    """And a few units that are odd do not make them."""
    rng = np.random.default_rng(5)
    worth = f.rvs(1, freedom, size=30000, random_state=rng) / 2 if np.isfinite(freedom) else (
        chi2.rvs(1, size=30000, random_state=rng) / 2
    )  # fmt: skip
    assert likely[0] <= chance_of(_odds(worth)).freedom <= likely[1]
    worth[:300] += 40.0
    odd = chance_of(_odds(worth))
    assert likely[0] <= odd.freedom <= likely[1]
    p = _odds(worth).tails(odd)
    assert 0.003 < (p[300:] < 0.01).mean() < 0.012
    assert 0.1 < 1e3 * (p[300:] < 1e-3).mean() < 1.5


def test_few_units_say_nothing_of_tails() -> None:
    worth = chi2.rvs(1, size=12, random_state=np.random.default_rng(6)) / 2
    worth[0] = 30.0
    assert chance_of(_odds(worth)).freedom == np.inf
    assert chance_of(_odds(np.zeros(0))) == Chance()


@pytest.mark.parametrize("freedom", [np.inf, 7.0])
def test_sizes_are_those_of_tails(freedom: float) -> None:
    odds = _odds(np.linspace(0.1, 9, 50), 4, tests=5.5)
    worth = odds.sizes(0.03, freedom) / 2
    assert _odds(worth, 4, tests=5.5).tails(Chance(1.0, freedom)) == pytest.approx(0.03, rel=1e-9)


def test_the_rarest_of_several_is_less_rare() -> None:
    p = of_several(np.array([1e-12, 0.01, 1.0]), 20.0)
    assert p[0] == pytest.approx(20e-12)
    assert p[1] == pytest.approx(1 - 0.99**20)
    assert p[2] == pytest.approx(1.0)


def _odds(worth: np.ndarray, numbers: int = 1, tests: float = 1.0) -> Odds:
    same = np.ones_like(worth)
    return Odds(worth, numbers, tests * same, np.inf * same)


# --- what units have in common ----------------------------------------------------------------------------


UNITS, LOGS = 60, 9


def series(seed: int, drift: float = 0.0) -> Series:
    """Readings of 10 that scatter by 1.5 from unit to unit and by 0.4 from log to log, with errors of 0.2,
    and fall by 2 % a degree; one in ten units drifts."""
    rng = np.random.default_rng(seed)
    unit = np.repeat(np.arange(UNITS), LOGS)
    warmth = rng.uniform(-8, 8, len(unit)) + 3 * rng.standard_normal(UNITS)[unit]
    own = (10 + 1.5 * rng.standard_normal(UNITS))[unit] + 0.4 * rng.standard_normal(len(unit))
    own += drift * np.tile(np.linspace(0, 1, LOGS), UNITS) * (unit % 10 == 0)
    value = own * np.exp(-0.02 * warmth) + 0.2 * rng.standard_normal(len(unit))
    return Series(value, np.full(len(unit), 0.04), unit, warmth[:, None])


@pytest.mark.parametrize("drift", [0.0, 6.0])
def test_means_scatters_and_slopes_are_those_that_were_drawn(drift: float) -> None:
    common = common_of(series(1, drift), relative=True, usual=8.0)
    assert common.mean == pytest.approx(10, abs=0.6)
    assert common.between_units == pytest.approx(1.5, rel=0.35)
    assert common.between_logs == pytest.approx(0.4, rel=0.4)
    assert common.slopes[0] == pytest.approx(-0.02, rel=0.12)


def test_a_condition_that_does_nothing_or_does_not_vary_has_no_slope() -> None:
    one = series(2)
    rng = np.random.default_rng(3)
    idle = np.stack([rng.standard_normal(len(one.value)), np.full(len(one.value), 7.0)], axis=1)
    common = common_of(Series(one.value, one.variance, one.unit, idle), relative=True, usual=8.0)
    assert common.slopes.tolist() == [0.0, 0.0]


def test_numbers_that_go_together_are_not_counted_twice() -> None:
    rng = np.random.default_rng(4)
    shared = rng.standard_normal((4000, 1))
    values = np.hstack([shared, 2 * shared, rng.standard_normal((4000, 1))])
    spread = spread_of(values + 0.1 * rng.standard_normal((4000, 3)), np.array([1.0, 2.0, 1.0]))
    assert np.allclose(np.diag(spread), [1, 4, 1], rtol=0.05)
    assert spread[0, 1] == pytest.approx(2, rel=0.05)
    assert abs(spread[0, 2]) < 0.15
    assert np.linalg.eigvalsh(spread).min() > 0
