"""Compiled kernels against Pinocchio and MuJoCo, on the bundled robots and on 200 random ones.

The measure is the difference as a share of the largest torque of that robot over all states tried (mass
matrices: of their largest entry). Pinocchio takes every robot. MuJoCo's compiler refuses some; those reach it
as :mod:`peers.mujoco_peer` says, and the reasons are printed.

Accelerations are not compared but put back: with x the kernel's, M, b and X a peer's mass matrix, bias and
accelerations, |M x + b - tau| must be at most 1e-10 (|M| |X| + |b| + |tau|), largest entries. A solution by
elimination without cancellation (M is positive definite) makes this residual a small multiple of the rounding
unit whatever the condition of M, which a comparison of x with X would have to allow for. Where M is singular,
or so near it that the residual would say little of x, there is no forward dynamics to test and none is asked
for.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Final

import pytest

import robodyn
import robodyn.robot
from peers.compared import (
    ALL_BUT_FORWARD,
    DOUBLE,
    TORQUES,
    Reference,
    complaints,
    kernel_of,
    peer_module,
    peers,
    references,
)
from robodyn.robot.model import Robot
from robodyn_testing import representative, sampled
from robodyn_testing.random_robots import random_robot

pytestmark = pytest.mark.filterwarnings("ignore:Please update your 'hppfcl'")  # Pinocchio 3.3, on import
RANDOM_ROBOTS: Final = 200
CHUNK: Final = 10
FLOAT: Final = 1e-5
"""Of the mass matrix scaled to a unit diagonal; beyond it forward dynamics is not asked for."""


def check(robot: Robot, refs: Sequence[Reference], functions: Sequence[str], **options: Any) -> list[str]:
    """Compile one kernel and hold it against every reference; complaints name robot and options."""
    wanted = [f for f in functions if all(f in ref.functions for ref in refs)]
    kernel = kernel_of(robot, wanted, **{"scalar": "double", "regroup": True, **options})
    tolerance = FLOAT if options.get("scalar") == "float" else DOUBLE
    return [
        f"{robot.name} ({robot.n} joints, {options}): {text}"
        for ref in refs
        for text in complaints(kernel, ref, wanted, tolerance)
    ]


@pytest.mark.parametrize("name", representative(robodyn.robot.bundled_names(), "stanford", rest="slow"))
def test_bundled_robot(name: str) -> None:
    robot = robodyn.robot.load(name, warn=print)
    refs = references(robot)
    found = check(robot, refs, refs[0].functions)
    found += check(robot, refs, refs[0].functions, regroup=False)
    found += check(robot, refs, TORQUES[:1], optimize="none")
    found += check(robot, refs, ALL_BUT_FORWARD, scalar="float")
    if "mujoco" in peers():
        for i, reason in peer_module("mujoco").refusals(robot).items():
            print(f"{name} is not expressible in MJCF: link {i + 1}: {reason}")
    assert found == []


def robots_of(chunk: int) -> Iterator[tuple[int, Robot, list[Reference]]]:
    """Random robots by their numbers, with what the peers say of them."""
    for seed in range(CHUNK * chunk, CHUNK * (chunk + 1)):
        robot = random_robot(seed, aside=0.3)
        yield seed, robot, references(robot, seed)


@pytest.mark.parametrize(
    "chunk", sampled(sampled(range(RANDOM_ROBOTS // CHUNK), every=10, rest="slow"), every=20)
)
def test_random_robots(chunk: int) -> None:
    """Torques of every robot in double and float; by turns the other functions, and without regrouping.

    With little or no optimisation by the compiler, to be quick; bundled robots are tried with all of it.
    """
    found = []
    for seed, robot, refs in robots_of(chunk):
        functions = refs[0].functions if seed % 4 == 0 else TORQUES[:1]
        found += check(robot, refs, functions, flags=("-O1",))
        found += check(robot, refs, TORQUES[:1], scalar="float", flags=("-O0",))
        if seed % 4 == 2:
            found += check(robot, refs, TORQUES[:1], regroup=False, flags=("-O0",))
    assert found == []
