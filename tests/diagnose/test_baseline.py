"""A description without friction and rotors: all of it comes in at once, and nothing in its place."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from benchmarks.blind_arms.arms import bare, rubbing

from identify.exact import log_of
from robodyn.diagnose.run import diagnose
from robodyn.diagnose.select.baseline import with_baseline
from robodyn.diagnose.select.members import Fit
from robodyn.diagnose.select.score import Trial
from robodyn.diagnose.select.steps import Steps
from robodyn.robot.model import Robot


def without_rotors(robot: Robot) -> Robot:
    """The arm with rotors of no inertia."""
    links = (replace(link, joint=replace(link.joint, motor_inertia=Fraction(0))) for link in robot.links)
    return replace(robot, links=tuple(links))


@pytest.mark.thorough
def test_what_every_joint_lacks_is_named_and_no_coupling_in_its_place() -> None:
    truth = rubbing(bare("puma560_3dof"))
    logs = [log_of(truth, noise=0.02, seed=seed) for seed in (1, 2)]
    found = diagnose(without_rotors(bare("puma560_3dof")), logs[:1], logs[1])
    claims = {(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5}
    dry = {(id, j) for id, j in claims if id == "coulomb_friction"}
    assert dry == {("coulomb_friction", j) for j in (1, 2, 3)}
    assert {id for id, _ in claims} <= {"coulomb_friction", "viscous_friction", "rotor_inertia"}
    assert {j for id, j in claims if id == "rotor_inertia"} >= {1, 2, 3} - {
        j for j, link in enumerate(truth.links, 1) if not link.joint.motor_inertia
    }
    assert all(
        after < 1.3 * noise
        for after, noise in zip(found.gap.validate_after, found.gap.noise_floor, strict=True)
    )


def test_a_baseline_that_is_not_worth_it_leaves_the_search_as_it_was(monkeypatch: pytest.MonkeyPatch) -> None:
    """One joint rubs: friction and rotors of all are no better than that of one, and what is banned stays."""
    arm = bare("puma560_3dof")
    first, *others = arm.links
    links = (replace(first, joint=replace(first.joint, coulomb=Fraction(3))), *others)
    log = log_of(replace(arm, links=links), noise=0.02)
    calls = []

    def watched(search: Steps, fit: Fit, best: Trial | None) -> Fit | None:
        search.banned.add(("payload", None))
        before = search.rows, search.dry.tolist(), search.families, set(search.banned)
        base = with_baseline(search, fit, best)
        calls.append(base)
        assert (search.rows, search.dry.tolist(), search.families, search.banned) == before
        return base

    monkeypatch.setattr("robodyn.diagnose.select.search.with_baseline", watched)
    found = diagnose(arm, [log])
    assert calls
    assert set(calls) == {None}
    assert [(f.effect, f.joint) for f in found.findings if f.confidence >= 0.5] == [("coulomb_friction", 1)]
