"""The comparison with the peers can fail: what is slightly wrong is noticed."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any, Final

import numpy as np
import pytest

from peers.compared import (
    ALL_BUT_FORWARD,
    DOUBLE,
    PEERS,
    STATES,
    TORQUES,
    Reference,
    complaint,
    complaints,
    kernel_of,
    peer_module,
    reference,
    references,
)
from robodyn.robot.model import Inertia, Link, Robot
from robodyn.robot.values import angle
from robodyn_testing import require_module
from robodyn_testing.random_robots import random_robot, random_states

pytestmark = pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")  # Pinocchio 3.3, on import


# --- the check can fail -------------------------------------------------------------------------------------

MICRO: Final = Fraction(1, 10**6)


def _generic_arm() -> Robot:
    """Six revolute joints, no two consecutive axes parallel, nothing zero: every number tells, almost."""
    return random_robot(
        6, joints=6, prismatic=0, parallel=0, zeros=0, degenerate=0, exotic=0, motors=1, friction=1
    )


def _with_link(robot: Robot, i: int, link: Link) -> Robot:
    return replace(robot, links=(*robot.links[:i], link, *robot.links[i + 1 :]))


def _moved(robot: Robot, i: int, axis: int, by: Fraction = MICRO) -> Robot:
    """``robot`` with the centre of mass of link ``i`` (from 0) moved."""
    x, y, z = (c + by * (k == axis) for k, c in enumerate(robot.links[i].com))
    return _with_link(robot, i, replace(robot.links[i], com=(x, y, z)))


def _complains(kernel: Any, ref: Reference) -> bool:
    """Whether the torques of ``kernel`` are found wrong."""
    return bool(complaints(kernel, ref, TORQUES[:1], DOUBLE))


@pytest.fixture(scope="module")
def generic_kernel() -> Any:
    return kernel_of(_generic_arm(), (*ALL_BUT_FORWARD, "forward_dynamics"), scalar="double")


@pytest.mark.parametrize("peer", PEERS)
def test_a_centre_of_mass_one_micrometre_off_is_noticed(peer: str, generic_kernel: Any) -> None:
    """In every link and direction, but for link 1 along its own axis, which no torque depends on."""
    require_module(peer)
    robot = _generic_arm()
    states = random_states(robot, STATES, 1)
    assert complaints(generic_kernel, reference(peer, robot, states), TORQUES, DOUBLE) == []
    unnoticed = [
        (i + 1, "xyz"[axis])
        for i in range(robot.n)
        for axis in range(3)
        if not _complains(generic_kernel, reference(peer, _moved(robot, i, axis), states))
    ]
    assert unnoticed == [(1, "z")]


@pytest.mark.parametrize("function", [*ALL_BUT_FORWARD, "forward_dynamics"])
def test_every_function_notices_a_wrong_centre_of_mass(function: str, generic_kernel: Any) -> None:
    robot = _generic_arm()
    for ref in references(_moved(robot, 3, 0)):
        assert len(complaints(generic_kernel, ref, [function], DOUBLE)) == 1


def _changed_joint(link: Link, name: str) -> Link:
    value = getattr(link.joint, name)
    changes: dict[str, Any] = {
        name: angle(Fraction(value.radians) + MICRO) if name in ("alpha", "theta") else value + MICRO
    }
    return replace(link, joint=replace(link.joint, **changes))


def _changed_inertia(link: Link, entry: str) -> Link:
    entries = {name: getattr(link.inertia, name) for name in ("xx", "yy", "zz", "xy", "xz", "yz")}
    entries[entry] += MICRO
    return replace(link, inertia=Inertia(**entries))


@pytest.mark.parametrize("peer", PEERS)
def test_any_other_number_one_millionth_off_is_noticed(peer: str, generic_kernel: Any) -> None:
    require_module(peer)
    robot = _generic_arm()
    states = random_states(robot, STATES, 1)
    link = robot.links[3]
    broken = {"mass": replace(link, mass=link.mass + MICRO)}
    for entry in ("xx", "yy", "zz", "xy", "xz", "yz"):
        broken[entry] = _changed_inertia(link, entry)
    for name in ("alpha", "a", "d", "theta", "motor_inertia", "viscous", "coulomb"):
        broken[name] = _changed_joint(link, name)
    robots = {name: _with_link(robot, 3, other) for name, other in broken.items()}
    x, y, z = robot.gravity
    robots["gravity"] = replace(robot, gravity=(x, y + MICRO, z))
    unnoticed = [
        name
        for name, other in robots.items()
        if not _complains(generic_kernel, reference(peer, other, states))
    ]
    assert unnoticed == []


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_what_is_no_number_is_a_complaint(wrong: float) -> None:
    good = np.ones((3, 2))
    bad = good.copy()
    bad[2, 1] = wrong
    assert complaint("torque", good, good, 1.0, DOUBLE) is None
    text = complaint("torque", bad, good, 1.0, DOUBLE)
    assert text is not None
    assert "state 2, entry [2]" in text
    assert complaint("torque", good[:2], good, 1.0, DOUBLE) is not None


def test_mujoco_says_why_it_refuses_a_link() -> None:
    require_module("mujoco")
    mujoco_peer = peer_module("mujoco")
    robot = random_robot(1, joints=3, degenerate=0)
    assert mujoco_peer.refusals(robot) == {}
    bare = _with_link(robot, 1, replace(robot.links[1], mass=Fraction(0), inertia=Inertia()))
    assert list(mujoco_peer.refusals(bare)) == [1]
    with pytest.raises(mujoco_peer.NotExpressible, match="link 2: mass and inertia"):
        mujoco_peer.mujoco_model(bare, patch=False)
    mujoco_peer.mujoco_model(bare)
