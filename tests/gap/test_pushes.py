"""The tools that score pushes, and joints flipped and exchanged: what they draw, what they say of answers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.blind_arms.pushed import Push, Pushed
from benchmarks.gap.flips import answer, wrong
from benchmarks.gap.pushes import angle, graded, overlap, pushed_by, run, summary, untouched

from robodyn.identify.contact.contact import Contact
from robodyn.robot import load

PUSH = Push(2.0, 3.0, 3, np.array([0.0, 10.0, 0.0]), np.zeros(3), np.eye(3))


def window(start: float, end: float, force: tuple[float, float, float] = (0.0, 9.0, 0.0)) -> Contact:
    return Contact(start, end, 3, np.array(force), np.ones(3), 15.0, 0.9, True)


def pushed(*pushes: Push) -> Pushed:
    log = pushed_by("puma560_3dof", "calm", 1).log
    return Pushed(load("puma560_3dof", warn=lambda _: None), log, pushes, np.zeros(3))


def test_windows_are_scored_by_what_they_share_with_a_push() -> None:
    assert overlap(PUSH, window(2.0, 3.0)) == 1.0
    assert overlap(PUSH, window(2.5, 3.5)) == pytest.approx(1 / 3)
    assert overlap(PUSH, window(3.0, 4.0)) == 0.0
    assert angle(np.array([1.0, 0.0, 0.0]), np.array([0.0, 2.0, 0.0])) == pytest.approx(90.0)


def test_a_wrong_sign_and_a_false_window_are_counted() -> None:
    other = replace(PUSH, start=5.0, end=6.0)
    row = graded(
        pushed(PUSH, other), [window(2.1, 3.0), window(5.0, 6.0, (0.0, -9.0, 0.0)), window(7.0, 8.0)]
    )
    first, second = row["pushes"]
    assert first["angle"] == pytest.approx(0.0, abs=1e-3)
    assert second["angle"] == pytest.approx(180.0)
    assert first["off"][1] == -1.0
    assert row["false"] == [[7.0, 8.0, 3]]
    text = summary([{"kind": "rest", "cpu": 0.1, **row}])
    assert "2 of 2 pushes found, 1 false windows" in text
    assert "50 % within 20 degrees" in text
    assert "1 signs claimed and wrong" in text


@pytest.mark.thorough
def test_pushes_vary_and_are_the_same_for_the_same_seed() -> None:
    one, again, other = (pushed_by("puma560_3dof", "rest", seed) for seed in (2, 2, 3))
    np.testing.assert_array_equal(one.log.tau, again.log.tau)
    assert [p.start for p in one.pushes] != [p.start for p in other.pushes]
    assert all(p.rise > 0 for p in one.pushes)
    row = run(one, whole=False)
    assert all(p["overlap"] > 0.5 for p in row["pushes"])
    assert not row["false"]


@pytest.mark.thorough
def test_effects_are_hidden_where_nobody_pushes() -> None:
    hidden, log = next(untouched("puma560_3dof", 1))
    assert hidden.startswith("viscous_friction@")
    assert log.pushes == ()
    assert log.given.links[1].mass != load("puma560_3dof", warn=lambda _: None).links[1].mass


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
