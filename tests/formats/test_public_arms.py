"""Every serial chain of public arms, from file to description, against Pinocchio reading the same file."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn import Options, program
from robodyn.errors import InputError
from robodyn.formats.frames import description_of
from robodyn.formats.positions import Positions
from robodyn.formats.reading import read_tree
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, PHYSICS, Tree
from robodyn.formats.xacro import expanded
from robodyn.ir.evaluate import evaluate
from robodyn.robot import Robot, read_text, to_yaml
from robodyn.simulate.kinematics import Kinematics
from robodyn.verify import Reference
from robodyn_testing import representative, require_module
from robodyn_testing.chains import PinocchioArm
from robodyn_testing.public_arms import ARMS, arm_file

FEW = ("ur_description/urdf/ur10_robot.urdf", "panda_description/urdf/panda.urdf", "al5d_robot.urdf")
#: Why no chain goes to a link.
REASONS = ("nothing moves", "follows the joint", "is floating")
QUICK = [arm for arm in ARMS if arm[1].endswith(FEW)]


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


def tip_pose(robot: Robot, q: Any) -> Any:
    """Of the tool's frame in the world [4, 4]."""
    last, tool = np.eye(4), np.eye(4)
    place, turn = Kinematics(robot).pose(q)
    last[:3, :3], last[:3, 3] = turn, place
    if robot.tool is not None:
        tool[:3, :3] = [[float(x) for x in row] for row in robot.tool.rotation]
        tool[:3, 3] = [float(x) for x in robot.tool.xyz]
    return last @ tool


def friction(robot: Robot) -> Any:
    """Viscous [N m s/rad, N s/m] and Coulomb friction [N m, N] of the joints."""
    joints = [link.joint for link in robot.links]
    return np.array([[float(Fraction(str(x))) for x in (j.viscous, j.coulomb)] for j in joints]).T


@pytest.mark.parametrize(("package", "file"), representative(ARMS, *QUICK))
def test_every_chain_is_what_pinocchio_reads(package: str, file: str, tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
    path = arm_file(package, file)
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".xacro":
        require_module("xacro")
        text = expanded(path).text
    tree = read_tree(path, without=PHYSICS)  # Pinocchio reads none of it
    positions = Positions(Topology(tree), {})
    locked = {joint.name: positions.of(joint) for joint in tree.joints if joint.kind in MOVING}
    count = 0
    for tip, serial in chains(tree):
        names = [joint.name for joint in serial.chain.joints]
        peer = PinocchioArm(pinocchio, text, names, locked, serial.chain.gravity)
        robot = description_of(serial.chain)
        compare(robot, read_text(to_yaml(robot), warn=lambda _: None), peer, tip, first=not count)
        count += 1
    assert count


def compare(robot: Robot, read_back: Robot, peer: PinocchioArm, tip: str, first: bool) -> None:
    assert [link.name for link in read_back.links] == peer.names
    reference = Reference(read_back)
    draw = np.random.default_rng(robot.n)
    q, qd, qdd = draw.uniform(-2, 2, (3, 3, robot.n))
    torques = np.array([peer.torques(*state) for state in zip(q, qd, qdd, strict=True)])
    largest = abs(torques).max()
    viscous, coulomb = friction(robot)
    dry = viscous * qd + coulomb * np.sign(qd)
    ours = reference.inverse_dynamics(q, qd, qdd)
    assert ours - dry == pytest.approx(torques, rel=0, abs=1e-10 * largest + 1e-14)
    for k, state in enumerate(q):
        assert tip_pose(read_back, state) == pytest.approx(peer.tip(state, tip), rel=0, abs=1e-10)
        matrix = peer.mass_matrix(state)
        assert reference.mass_matrix(state) == pytest.approx(
            matrix, rel=0, abs=1e-10 * abs(matrix).max() + 1e-14
        )
        if np.linalg.cond(matrix) < 1e12:  # an arm without masses has no forward dynamics
            accelerations = reference.forward_dynamics(state, qd[k], ours[k])
            left = matrix @ (accelerations - qdd[k])  # as torque: a wrist accelerates fast
            assert left == pytest.approx(0 * left, abs=1e-10 * (largest + abs(matrix @ qdd[k]).max()))
    if first:
        kernel = program(read_back, "inverse_dynamics", Options(optimize="fast"))
        inputs = {x: float({"q": q, "qd": qd, "qdd": qdd}[x.array][0][x.index]) for x in kernel.inputs()}
        (values,) = evaluate(kernel, inputs).values()
        assert np.array(values) == pytest.approx(ours[0], rel=0, abs=1e-10 * largest + 1e-14)


def test_there_are_arms_enough() -> None:
    assert len(ARMS) > 50
