"""The tool that flips and exchanges joints: what it changes, and how it scores the answers."""

from __future__ import annotations

import numpy as np
from benchmarks.gap.flips import answer, wrong
from benchmarks.gap.pushes import pushed_by


def test_each_joint_is_flipped_and_exchanged_with_the_next() -> None:
    log = pushed_by("puma560_3dof", "calm", 1).log
    changed = list(wrong(log))
    assert [what for what, _, _ in changed].count("tau flipped") == 3
    assert [what for what, _, _ in changed].count("q exchanged") == 2
    _, remedy, other = changed[1]
    assert remedy == "change the sign of tau1"
    np.testing.assert_array_equal(other.tau[:, 0], -log.tau[:, 0])
    np.testing.assert_array_equal(other.q, log.q)


def test_answers_are_scored_by_their_remedy() -> None:
    pushed = pushed_by("puma560_3dof", "calm", 1)
    _, remedy, other = next(x for x in wrong(pushed.log) if x[0] == "tau flipped")
    assert answer(other, pushed.given, remedy) == "right"
    assert answer(other, pushed.given, "change the sign of tau9") == "wrong"
    assert answer(pushed.log, pushed.given, remedy) == "missed"
