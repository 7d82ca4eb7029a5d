"""A description without friction and rotors: all of it comes in at once, and nothing in its place."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import pytest
from benchmarks.blind_arms.arms import bare, rubbing

from identify.exact import log_of
from robodyn.diagnose.run import diagnose
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
