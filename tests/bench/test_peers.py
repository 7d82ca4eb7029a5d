"""The peers that kernels are timed beside: the same numbers, the same torques, or no time."""

from __future__ import annotations

import dataclasses
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from benchmarks.peers.numbers_in_c import text_of
from benchmarks.peers.textbook import inverse_dynamics

from robodyn.bench.peers.calls import PEERS, checked
from robodyn.bench.peers.numbers import Disagreement, NumbersLacking, hold_against, numbers_of
from robodyn.robot import Robot, load
from robodyn.verify.reference import Reference
from robodyn_testing import require_module

ROBOTS = ("puma560", "stanford", "panda", "ur10")


def arm(name: str) -> Robot:
    return load(name, warn=lambda _: None)


def states(n: int, count: int = 16) -> Any:
    random = np.random.default_rng(3)
    return tuple(random.uniform(-limit, limit, (count, n)) for limit in (math.pi, 3.0, 10.0))


@pytest.mark.parametrize("name", ROBOTS)
def test_the_textbook_gives_the_references_torques(name: str) -> None:
    robot = arm(name)
    at = states(robot.n)
    numbers = numbers_of(robot)
    found = [
        inverse_dynamics(numbers, q.tolist(), qd.tolist(), qdd.tolist(), math.sin, math.cos)
        for q, qd, qdd in zip(*at, strict=True)
    ]
    assert hold_against("textbook", Reference(robot).inverse_dynamics(*at), np.array(found)) < 1e-13


@pytest.mark.parametrize("module", ["pinocchio", "mujoco", "casadi"])
@pytest.mark.parametrize("name", ROBOTS)
def test_peers_give_the_references_torques(name: str, module: str) -> None:
    require_module(module)
    robot = arm(name)
    at = states(robot.n)
    call = PEERS[module](robot, at)
    assert checked(call, Reference(robot).inverse_dynamics(*at)) < 1e-12


def test_a_peer_with_another_arm_is_refused() -> None:
    require_module("pinocchio")
    robot = arm("puma560")
    at = states(robot.n)
    last = dataclasses.replace(robot.links[5], mass=robot.links[5].mass + Fraction(1, 10**6))
    other = dataclasses.replace(robot, links=(*robot.links[:5], last))
    with pytest.raises(Disagreement, match=r"pin\.rnea gives another torque in state"):
        checked(PEERS["pinocchio"](other, at), Reference(robot).inverse_dynamics(*at))


def test_what_agreement_means() -> None:
    ours = np.array([[1.0, -300.0], [0.01, 0.02]])
    assert hold_against("same", ours, ours) == 0
    assert hold_against("near", ours, ours + np.array([[0, 2e-7], [0, 9e-10]])) == pytest.approx(
        9e-10, rel=1e-3
    )
    for off in ([[0, 4e-7], [0, 0]], [[0, 0], [0, 1.1e-9]], [[0, np.nan], [0, 0]]):
        with pytest.raises(Disagreement, match=r"state [01], joint 2"):
            hold_against("wrong", ours, ours + np.array(off))
    with pytest.raises(Disagreement):
        hold_against("short", ours, ours[:1])


def test_what_peers_do_not_know_is_said() -> None:
    robot = arm("puma560_3dof")
    joint = dataclasses.replace(robot.links[0].joint, coulomb=Fraction(1))
    rubbing = dataclasses.replace(
        robot, links=(dataclasses.replace(robot.links[0], joint=joint), *robot.links[1:])
    )
    with pytest.raises(NumbersLacking, match="friction"):
        numbers_of(rubbing)
    assert numbers_of(dataclasses.replace(rubbing, torque_side="link")).links[0].rotor == 0


def test_numbers_survive_their_text() -> None:
    numbers = numbers_of(arm("stanford"))
    rows = [[float(x) for x in line.split()] for line in text_of(numbers).splitlines()]
    assert rows[0] == [6, *numbers.gravity]
    assert {len(row) for row in rows[1:]} == {35}
    assert [row[9] for row in rows[1:]] == [link.mass for link in numbers.links]
