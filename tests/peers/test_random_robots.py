"""The random robots are the same every time, physical, and as varied as they are said to be."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction

import numpy as np
import pytest

from peers.numbers import inertia_tensor
from robodyn.robot.model import Inertia, Link, Robot
from robodyn.robot.values import Affine
from robodyn_testing.random_robots import random_robot, random_states

ROBOTS = [random_robot(seed) for seed in range(200)]


def _exact(robot: Robot) -> Iterator[Fraction]:
    yield from robot.gravity
    for value in robot.values():
        assert not isinstance(value, Affine)
        yield value


def test_a_seed_gives_one_robot_and_one_set_of_states() -> None:
    assert [random_robot(seed) for seed in range(200)] == ROBOTS
    assert len({robot.links for robot in ROBOTS}) == 200
    for one, other in zip(random_states(ROBOTS[0], 5, 3), random_states(ROBOTS[0], 5, 3), strict=True):
        assert (one == other).all()
        assert one.shape == (5, ROBOTS[0].n)
        assert (one == one.astype(np.float32)).all()


def test_numbers_are_short_decimals() -> None:
    for robot in ROBOTS:
        assert all((value * 10**6).denominator == 1 for value in _exact(robot))


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
        seen[f"{robot.n} joints"] += 1
        seen[f"torque of the {robot.torque_side}"] += 1
        seen["friction smooth at rest"] += robot.rest_velocity is not None
        seen["gravity off"] += not any(robot.gravity)
        seen["gravity in no axis"] += all(robot.gravity)
        for link in robot.links:
            joint = link.joint
            seen[joint.kind] += 1
            seen[_sort_of(link)] += 1
            seen[f"alpha {'generic' if joint.alpha.quarter is None else joint.alpha.quarter}"] += 1
            seen[f"theta {'generic' if joint.theta.quarter is None else joint.theta.quarter}"] += 1
            seen[f"theta of a {joint.kind} joint"] += joint.theta.radians != 0
            seen["a zero"] += not joint.a
            seen["d zero"] += not joint.d
            seen["com partly zero"] += any(link.com) and not all(link.com)
            seen["com all there"] += all(link.com)
            seen["motor"] += bool(joint.motor_inertia)
            seen["viscous"] += bool(joint.viscous)
            seen["coulomb"] += bool(joint.coulomb)
    expected = [*(f"{n} joints" for n in range(1, 10)), *(f"alpha {a}" for a in ("generic", 0, 1, -1, 2))]
    expected += [*(f"theta {a}" for a in ("generic", 0, 1, -1, 2)), "full", "diagonal", "point", "massless"]
    expected += ["theta of a revolute joint", "theta of a prismatic joint", "inertia_only", "gravity off"]
    rare = [name for name in {*seen, *expected} if seen[name] < 3]
    assert rare == []


def test_options_rule() -> None:
    for seed in range(20):
        robot = random_robot(seed, joints=4, full=False, prismatic=1, degenerate=0, motors=0, friction=0)
        assert robot.n == 4
        assert {_sort_of(link) for link in robot.links} == {"diagonal"}
        assert {link.joint.kind for link in robot.links} == {"prismatic"}
        assert not any(link.joint.motor_inertia or link.joint.viscous for link in robot.links)
    with pytest.raises(ValueError, match="joints: found 0"):
        random_robot(0, joints=0)
