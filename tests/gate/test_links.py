"""Second encoders go through the gate with their log: on its even grid, and only where they can be used."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gate.gated import GIVEN, at
from robodyn.errors import InputError
from robodyn.gate.gate import inspect
from robodyn.logs.log import Log

TWIST = 1e-3


def linked(log: Log, *joints: int) -> Log:
    """``log`` with a second encoder at the ``joints`` (from 0), twisted by TWIST from the first."""
    ql = np.full(log.q.shape, np.nan)
    ql[:, list(joints)] = log.q[:, list(joints)] + TWIST
    return replace(log, ql=ql)


def test_a_sound_log_keeps_them(log: Log) -> None:
    gate = inspect(linked(log, 0, 2), GIVEN)
    assert gate.log.linked == (0, 2)
    assert gate.log.ql is not None
    np.testing.assert_array_equal(gate.log.ql[:, [0, 2]], gate.log.q[:, [0, 2]] + TWIST)


def test_they_follow_the_grid_over_gaps_and_jitter(log: Log) -> None:
    rows = np.delete(np.arange(log.samples), np.r_[200:205, 300])
    broken = linked(at(log, rows), 1)
    gate = inspect(broken, GIVEN)
    assert gate.log.ql is not None
    assert gate.log.linked == (1,)
    np.testing.assert_allclose(gate.log.ql[:, 1], gate.log.q[:, 1] + TWIST, atol=1e-6)


def test_broken_ones_are_not_used(log: Log) -> None:
    both = linked(log, 0, 1)
    assert both.ql is not None
    both.ql[: log.samples // 2, 0] = 1e30
    both.ql[100, 1] = np.nan
    gate = inspect(both, GIVEN)
    assert gate.log.linked == (1,)
    assert [flag.where for flag in gate.flags_of("link_encoder_unusable")] == ["ql1"]
    assert [flag.where for flag in gate.flags_of("garbage")] == ["ql2"]
    assert gate.log.ql is not None
    assert not np.isnan(gate.log.ql[:, 1]).any()


@pytest.mark.parametrize("factor", [-1.0, 180 / np.pi, 0.0])
def test_one_that_does_not_follow_its_joint_is_refused(factor: float, log: Log) -> None:
    both = linked(log, 0, 1)
    assert both.ql is not None
    both.ql[:, 1] *= factor
    with pytest.raises(InputError, match="ql2 does not follow q2"):
        inspect(both, GIVEN, source="a.csv")
