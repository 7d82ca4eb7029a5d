"""What units and logs of a type have in common: scatters that odd units do not move, slopes, what goes
together."""

from __future__ import annotations

import numpy as np
import pytest

from robodyn.fleet.pool.population import Series, common_of, spread_of

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
