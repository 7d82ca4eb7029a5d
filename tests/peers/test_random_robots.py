"""The random robots are the same every time, physical, and as varied as they are said to be."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from peers.numbers import inertia_tensor
from robodyn.robot.model import Inertia, Link
from robodyn_testing.random_robots import random_robot, random_states

ROBOTS = [random_robot(seed) for seed in range(200)]


def test_a_seed_gives_one_robot_and_one_set_of_states() -> None:
    assert [random_robot(seed) for seed in range(200)] == ROBOTS
    assert len({robot.links for robot in ROBOTS}) == 200
    for one, other in zip(random_states(ROBOTS[0], 5, 3), random_states(ROBOTS[0], 5, 3), strict=True):
        assert (one == other).all()
        assert one.shape == (5, ROBOTS[0].n)
        assert (one == one.astype(np.float32)).all()


def test_inertias_are_physical() -> None:
    """Positive semidefinite second moments of mass, which is stronger than the triangle inequality."""
    for robot in ROBOTS:
        for link in robot.links:
            if link.mass:
                tensor = inertia_tensor(link.inertia)
                moments = np.linalg.eigvalsh(np.eye(3) * np.trace(tensor) / 2 - tensor)
                assert moments.min() >= -1e-15


def _sort_of(link: Link) -> str:
    i = link.inertia
    if not link.mass:
        return "massless" if i == Inertia() else "inertia_only"
    if i == Inertia():
        return "point"
    return "full" if i.xy or i.xz or i.yz else "diagonal"


def test_everything_awkward_comes_up() -> None:
    seen: Counter[str] = Counter()
    for robot in ROBOTS:
        seen.update([f"{robot.n} joints", f"torque of the {robot.torque_side}"])
        seen["friction smooth at rest"] += robot.rest_velocity is not None
        seen["gravity off"] += not any(robot.gravity)
        seen["gravity in no axis"] += all(robot.gravity)
        for link in robot.links:
            joint = link.joint
            seen.update([joint.kind, _sort_of(link)])
            seen.update(f"{name} {getattr(joint, name).quarter}" for name in ("alpha", "theta"))
            seen[f"theta of a {joint.kind} joint"] += joint.theta.radians != 0
            seen["com partly zero"] += any(link.com) and not all(link.com)
            seen["com all there"] += all(link.com)
            seen.update(f"{name} zero" for name in ("a", "d") if not getattr(joint, name))
            seen.update(name for name in ("motor_inertia", "viscous", "coulomb") if getattr(joint, name))
    expected = [
        *(f"{n} joints" for n in range(1, 10)),
        "full",
        "diagonal",
        "point",
        "massless",
        "inertia_only",
    ]
    expected += [f"{name} {turn}" for name in ("alpha", "theta") for turn in (None, 0, 1, -1, 2)]
    expected += ["theta of a revolute joint", "theta of a prismatic joint", "gravity off"]
    assert [name for name in {*seen, *expected} if seen[name] < 3] == []


def test_options_rule() -> None:
    for seed in range(20):
        robot = random_robot(seed, joints=4, full=False, prismatic=1, degenerate=0, motors=0, friction=0)
        assert robot.n == 4
        assert {_sort_of(link) for link in robot.links} == {"diagonal"}
        assert {link.joint.kind for link in robot.links} == {"prismatic"}
        assert not any(link.joint.motor_inertia or link.joint.viscous for link in robot.links)
    with pytest.raises(ValueError, match="joints: found 0"):
        random_robot(0, joints=0)
