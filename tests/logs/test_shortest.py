"""The numbers of a log against Python's own repr, which gives the shortest that reads back."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from robodyn.logs.shortest import table_text

RNG = np.random.default_rng(2)


def check(values: Any) -> None:
    x = np.asarray(values, dtype=np.float64)
    want = list(map(repr, x.tolist()))
    assert table_text(x[:, None]).decode().split("\n") == [*want, ""]
    assert table_text(-x[None]).decode() == ",".join(map(repr, (-x).tolist())) + "\n"


@given(st.lists(st.floats(), min_size=1), st.lists(st.floats(1e-4, 1e5), min_size=1))
def test_any_number(any: list[float], usual: list[float]) -> None:
    check(any)
    check(usual)


@pytest.mark.parametrize("exponent", range(-6, 7))
def test_sizes(exponent: int) -> None:
    check(RNG.uniform(1, 10, size=10_000) * 10.0**exponent)


def test_short_decimals_and_their_neighbours() -> None:
    values = RNG.uniform(1, 10, size=1500) * 10.0 ** RNG.integers(-5, 6, size=1500)
    for digits in range(1, 18):
        x = np.array([float(f"{value:.{digits}g}") for value in values])
        for each in (x, np.nextafter(x, 0), np.nextafter(x, np.inf)):
            check(each)


def test_powers_and_their_neighbours() -> None:
    """Steps are uneven about powers of two; at those of ten the number of digits changes."""
    x = np.concatenate([2.0 ** np.arange(-30, 30), 10.0 ** np.arange(-8, 9)])
    for each in (x, np.nextafter(x, 0), np.nextafter(x, np.inf), 5 * x):
        check(each)


def test_halves_lie_between_two_decimals() -> None:
    check(RNG.integers(1, 1 << 53, size=20_000) * 2.0 ** -RNG.integers(36, 67, size=20_000))
    check(RNG.integers(1, 1 << 30, size=20_000) * 2.0 ** -RNG.integers(14, 44, size=20_000))


def test_most_numbers_do_not_go_through_repr(monkeypatch: pytest.MonkeyPatch) -> None:
    from robodyn.logs import shortest

    asked: list[int] = []
    fill = shortest._fill

    def counted(*rest: Any) -> Any:
        left = fill(*rest)
        asked.append(len(left))
        return left

    monkeypatch.setattr(shortest, "_fill", counted)
    table_text(RNG.normal(size=(1000, 10)))
    assert asked[0] < 1000
