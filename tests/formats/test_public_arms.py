"""Every serial chain of public arms, from file to description, against Pinocchio reading the same file."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest

from robodyn.errors import InputError
from robodyn.formats.arm import read_tree
from robodyn.formats.frames import description_of
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.topology import Topology
from robodyn.formats.tree import PHYSICS, Tree
from robodyn.robot import read_text, to_yaml
from robodyn.robot.masses import massless
from robodyn.verify import Reference
from robodyn.verify.against import comparable, compare, read_original
from robodyn_testing import require_module
from robodyn_testing.public_arms import ARMS, arm_file

FEW = ("ur_description/urdf/ur10_robot.urdf", "panda_description/urdf/panda.urdf", "al5d_robot.urdf")
#: Why no chain goes to a link.
REASONS = ("nothing moves", "follows the joint", "is floating")
QUICK = [arm for arm in ARMS if arm[1].endswith(FEW)]
#: Of the others every third in CI.
CASES = [
    *QUICK,
    *(
        pytest.param(*arm, marks=pytest.mark.slow if k % 3 else pytest.mark.thorough)
        for k, arm in enumerate(ARMS)
        if arm not in QUICK
    ),
]


def chains(tree: Tree) -> Iterator[tuple[str, Serial]]:
    """The chains to links at the ends of the tree, with their names; what no chain can go to is left out."""
    topology = Topology(tree)
    for link in topology.links:
        if not topology.below[link]:
            try:
                serial = serial_chain(tree, "arm", tip=link)
            except InputError as error:
                refusal = str(error)
                if not any(reason in refusal for reason in REASONS):
                    raise
            else:
                yield link, serial


@pytest.mark.parametrize(("package", "file"), CASES)
def test_every_chain_is_what_pinocchio_reads(package: str, file: str) -> None:
    require_module("pinocchio")
    path = arm_file(package, file)
    if path.suffix == ".xacro":
        require_module("xacro")
    tree, original = read_tree(path, without=PHYSICS), read_original(path)  # Pinocchio reads none of it
    count = 0
    for tip, serial in chains(tree):
        robot = massless(read_text(to_yaml(description_of(serial.chain)), warn=lambda _: None)).free
        arm = original.arm(robot, {})
        alike, _ = comparable(robot, arm)
        assert [row for row in compare(alike, arm, states=3) if not row.passed] == []
        q = np.random.default_rng(robot.n).uniform(-2, 2, (3, robot.n))
        assert Reference(robot).tool_pose(q) == pytest.approx(arm.frames(q).tips[tip], rel=0, abs=1e-10)
        count += 1
    assert count


def test_there_are_arms_enough() -> None:
    assert len(ARMS) > 50
