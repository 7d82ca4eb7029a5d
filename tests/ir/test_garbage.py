"""While programs are built Python looks for garbage rarely, and afterwards as often as before."""

from __future__ import annotations

import gc
from collections.abc import Iterator

import pytest

from robodyn.ir.program import RARELY, rarely_collected
from robodyn.kernels.generate import Options, generate


@pytest.fixture(params=[(700, 10, 10), (0, 10, 10), (RARELY[0] + 1, 3, 3)])
def thresholds(request: pytest.FixtureRequest) -> Iterator[tuple[int, int, int]]:
    before = gc.get_threshold()
    gc.set_threshold(*request.param)
    yield request.param
    gc.set_threshold(*before)


def test_it_is_rare_within_and_as_before_behind(thresholds: tuple[int, int, int]) -> None:
    rare = RARELY if thresholds == (700, 10, 10) else thresholds  # who looks more rarely is left alone
    with rarely_collected():
        assert gc.get_threshold() == rare
        with rarely_collected():
            assert gc.get_threshold() == rare
        assert gc.get_threshold() == rare
    assert gc.get_threshold() == thresholds
    with pytest.raises(ValueError, match="here"), rarely_collected():
        raise ValueError("here")
    assert gc.get_threshold() == thresholds


def test_generating_is_such_a_time(thresholds: tuple[int, int, int]) -> None:
    within: list[tuple[int, int, int]] = []
    options = Options(("potential_energy",))
    generate("puma560_3dof", options, progress=lambda _: within.append(gc.get_threshold()))
    assert within == [RARELY if thresholds == (700, 10, 10) else thresholds]
    assert gc.get_threshold() == thresholds
