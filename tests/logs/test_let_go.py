"""A long log is let go once it was looked at: what is used of it is a small part."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from robodyn.diagnose.run import diagnose
from robodyn.gate.limits import MOST_SAMPLES
from robodyn.identify.run import identify
from robodyn.logs.log import Log
from robodyn.robot import load
from robodyn_cli.log_files import handed_over


class _Enough(Exception):
    """The stage was reached at which it shows."""


def long_log() -> Log:
    """Of one joint, with more samples than are used."""
    t = np.asarray(2e-3 * np.arange(MOST_SAMPLES + 1000), dtype=np.float64)
    noise = 0.01 * np.random.default_rng(1).standard_normal((len(t), 1))
    swing = np.stack([2.0 * t], axis=1)
    return Log(t, np.sin(swing), None, None, np.asarray(-4 * 0.35 * np.sin(swing) + noise))


@pytest.mark.parametrize(
    ("work", "stage"),
    [(diagnose, "fitting the catalogue"), (identify, "fitting the arm")],
    ids=["diagnose", "identify"],
)
def test_nothing_of_a_long_log_stays_behind_the_data_check(work: Callable[..., Any], stage: str) -> None:
    arm = load("puma560_3dof", warn=lambda _: None)
    one_joint = replace(arm, links=arm.links[:1])
    logs = [long_log()]
    arrays = [weakref.ref(array) for array in (logs[0].q, logs[0].tau)]
    sources = handed_over(logs)
    assert logs == []

    def progress(words: str) -> None:
        if words == stage:
            raise _Enough

    with pytest.raises(_Enough):
        work(one_joint, sources, progress=progress)
    assert [array() for array in arrays] == [None, None]
