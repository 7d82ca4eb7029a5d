"""Numbers of an arm that are better than its description says: what then shows, and what is no news."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.blind_arms.arms import misjudged
from benchmarks.blind_arms.logs import hidden_log

from robodyn.diagnose.select.choice import _is_likely
from robodyn.diagnose.select.fit import Fit, fitted, problem
from robodyn.diagnose.select.forward import Chosen, Key, Named
from robodyn.diagnose.select.library.candidate import single
from robodyn.diagnose.select.limits import TIGHT
from robodyn.diagnose.select.selection import _View, select
from robodyn.diagnose.select.trial import Trial


@pytest.mark.thorough
def test_of_a_scatter_of_all_numbers_no_link_and_no_load_is_named() -> None:
    logs = hidden_log(
        "puma560_3dof", [], seed=5, duration=6.0, noise_share=0.015, validation=False, friction=False
    )
    assert select(misjudged(logs.given, 0.1, 5), logs.train).findings == ()


def view(names: list[Key], tight: float, evidence: float) -> _View:
    now = problem(np.ones((100, 1)), np.ones((100, 1, 1)), np.ones(1), 1.0)
    named = [
        Named(
            replace(one, candidate=replace(one.candidate, effect=effect, joint=joint)),
            (),
            0.9,
            *[np.zeros(1)] * 2,
        )
        for effect, joint in names
        for one in [trial(1.0, 0.1, 1.0)]
    ]
    return _View(now, Chosen(named, now, fitted(now), []), evidence, tight, None)


@pytest.mark.parametrize(
    ("names", "known", "tight", "evidence", "may"),
    [
        ([("gas_spring", 2)], [], 0.1, 6.0, True),
        ([("inertial_error", 2)], [], min(TIGHT), 1000.0, True),
        ([("inertial_error", 2)], [], max(TIGHT), 1000.0, False),  # the others are not exact
        ([("inertial_error", 2)], [], min(TIGHT), 20.0, False),
        ([("inertial_error", 2), ("inertial_error", 3)], [], min(TIGHT), 1000.0, False),
        ([("payload", None)], [], min(TIGHT), 1000.0, True),
        ([("payload", None)], [], max(TIGHT), 1000.0, False),
        ([("payload", None)], [("coulomb_friction", 1)], min(TIGHT), 1000.0, True),
        ([("payload", None)], [("inertial_error", 3)], min(TIGHT), 1000.0, False),
    ],
)
def test_a_body_is_news_beside_exact_numbers_only(
    names: list[Key], known: list[Key], tight: float, evidence: float, may: bool
) -> None:
    assert view(names, tight, evidence).may_name(view([], 1.0, 0.0), frozenset(known)) == may


def trial(x: float, error: float, left: float) -> Trial:
    """A candidate that is likely from 1 on: its coefficient, known to an error, and the mean square left."""
    candidate = single(
        "coulomb_friction", 0, [np.ones(10)], (1,), lambda x: {}, 1, likely=lambda x: bool(x[0] >= 1)
    )
    fit = Fit(np.array([x]), np.array([[error**2]]), np.zeros(0), np.full((10, 1), left), 0.0)
    return Trial(candidate, np.ones((10, 1, 1)), fit, 100.0, 5.0, 5.0, np.full(10, 10.0))


@pytest.mark.parametrize(
    ("x", "error", "left", "rough", "is_likely"),
    [
        (1.1, 0.0, 9.0, False, True),
        (0.8, 0.2, 9.0, False, False),
        (0.8, 0.2, 1.0, False, True),  # it alone explains the log
        (0.8, 0.2, 1.0, True, False),
    ],
)
def test_what_is_not_likely_needs_a_log_that_says_so(
    x: float, error: float, left: float, rough: bool, is_likely: bool
) -> None:
    now = problem(np.ones((100, 1)), np.ones((100, 1, 1)), np.ones(1), 1.0)
    one = trial(x, error, left)
    assert _is_likely(now, one, [one], rough=rough) == is_likely
    if is_likely and not rough and x < 1:  # but not beside another that explains as much
        assert not _is_likely(now, one, [one, trial(2.0, 0.1, left)], rough=False)
