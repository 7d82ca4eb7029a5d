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
    complaint,
    complaints,
    kernel_of,
    peer_module,
    reference,
    references,
)
from robodyn.robot.model import AXES, Inertia, Robot
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


def _with_link(robot: Robot, i: int, **changes: Any) -> Robot:
    """``robot`` with link ``i`` (from 0) changed."""
    return replace(robot, links=(*robot.links[:i], replace(robot.links[i], **changes), *robot.links[i + 1 :]))


def _broken(robot: Robot) -> dict[str, Robot]:
    """``robot`` with one number off by a millionth, by its name: every centre of mass, all else of link 4."""
    broken = {}
    for i, link in enumerate(robot.links):
        for axis in range(3):
            com = tuple(c + MICRO * (k == axis) for k, c in enumerate(link.com))
            broken[f"com of link {i + 1}, {'xyz'[axis]}"] = _with_link(robot, i, com=com)
    link = robot.links[3]
    broken["mass"] = _with_link(robot, 3, mass=link.mass + MICRO)
    for axes in AXES:
        inertia = replace(link.inertia, **{axes: getattr(link.inertia, axes) + MICRO})
        broken[axes] = _with_link(robot, 3, inertia=inertia)
    for name in ("alpha", "a", "d", "theta", "motor_inertia", "viscous", "coulomb"):
        value = getattr(link.joint, name)
        turns = name in ("alpha", "theta")
        other: Any = angle(Fraction(value.radians) + MICRO) if turns else value + MICRO
        broken[name] = _with_link(robot, 3, joint=replace(link.joint, **{name: other}))
    x, y, z = robot.gravity
    return broken | {"gravity": replace(robot, gravity=(x, y + MICRO, z))}


@pytest.fixture(scope="module")
def generic_kernel() -> Any:
    return kernel_of(_generic_arm(), (*ALL_BUT_FORWARD, "forward_dynamics"), scalar="double")


@pytest.mark.parametrize("peer", PEERS)
def test_a_number_one_millionth_off_is_noticed(peer: str, generic_kernel: Any) -> None:
    """But for link 1's centre of mass along its own axis, which no torque depends on."""
    require_module(peer)
    robot = _generic_arm()
    states = random_states(robot, STATES, 1)
    assert complaints(generic_kernel, reference(peer, robot, states), TORQUES, DOUBLE) == []
    unnoticed = [
        name
        for name, other in _broken(robot).items()
        if not complaints(generic_kernel, reference(peer, other, states), TORQUES[:1], DOUBLE)
    ]
    assert unnoticed == ["com of link 1, z"]


@pytest.mark.parametrize("function", [*ALL_BUT_FORWARD, "forward_dynamics"])
def test_every_function_notices_a_wrong_centre_of_mass(function: str, generic_kernel: Any) -> None:
    for ref in references(_broken(_generic_arm())["com of link 4, x"]):
        assert len(complaints(generic_kernel, ref, [function], DOUBLE)) == 1


@pytest.mark.parametrize("wrong", [np.nan, np.inf])
def test_what_is_no_number_is_a_complaint(wrong: float) -> None:
    good = np.ones((3, 2))
    bad = good.copy()
    bad[2, 1] = wrong
    assert complaint("torque", good, good, 1.0, DOUBLE) is None
    assert "state 2, entry [2]" in str(complaint("torque", bad, good, 1.0, DOUBLE))
    assert complaint("torque", good[:2], good, 1.0, DOUBLE) is not None


def test_mujoco_says_which_links_it_refuses() -> None:
    require_module("mujoco")
    mujoco_peer = peer_module("mujoco")
    robot = random_robot(1, joints=3, degenerate=0)
    assert mujoco_peer.refusals(robot) == {}
    bare = _with_link(robot, 1, mass=Fraction(0), inertia=Inertia())
    assert list(mujoco_peer.refusals(bare)) == [1]
    mujoco_peer.mujoco_model(bare)
