"""Chains out of random trees against Pinocchio, which reads the same text."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.formats.elements import parse
from robodyn.formats.frames import description_of
from robodyn.formats.serial import Positions, serial_chain
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING
from robodyn.formats.urdf import read_tree
from robodyn.verify import Reference
from robodyn_testing import commit_seeds, require_module, seed_counts
from robodyn_testing.chains import PinocchioArm, WorldDynamics
from robodyn_testing.random_trees import random_urdf


@pytest.mark.parametrize("count", seed_counts(20, 500))
def test_a_chain_of_a_tree_is_what_pinocchio_makes_of_it(count: int, tmp_path: Path) -> None:
    for seed in commit_seeds(count):
        check(seed, tmp_path)


def check(seed: int, tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
    text = random_urdf(seed)
    path = tmp_path / "tree.urdf"
    path.write_text(text)
    tree = read_tree(parse(text.encode(), "tree.urdf"))
    draw = np.random.default_rng(seed)
    movable = [joint for joint in tree.joints if joint.kind in MOVING]
    tip = tree.links[-1].name
    on_path = {joint.name for joint in Topology(tree).path(tip)}
    beside = [joint.name for joint in movable if joint.name not in on_path or len(on_path) > 6]
    locks = {name: 1.0 for name in beside[:-1] if draw.random() < 0.3}
    base = tree.links[1].name if tree.links[1].name in {j.parent for j in Topology(tree).path(tip)} else ""
    serial = serial_chain(tree, "tree", base if seed % 3 == 0 else "", tip, locks)
    positions = Positions(Topology(tree), locks)
    locked = {joint.name: positions.of(joint) for joint in movable}
    names = [joint.name for joint in serial.chain.joints]
    peer = PinocchioArm(pinocchio, path.read_text(), names, locked, serial.chain.gravity)
    own = WorldDynamics(serial.chain)
    for _ in range(3):
        q, qd, qdd = draw.uniform(-2, 2, (3, len(names)))
        torques = peer.torques(q, qd, qdd)
        assert own.torques(q, qd, qdd) == pytest.approx(
            torques, rel=0, abs=1e-12 * abs(torques).max() + 1e-15
        )
        assert own.tip(q) == pytest.approx(peer.tip(q, tip), rel=0, abs=1e-13)
        described = Reference(description_of(serial.chain))
        ours = described.inverse_dynamics(q, qd, qdd)
        picometre = 1e-12 * 9.81 * sum(joint.body.mass for joint in serial.chain.joints)  # N m: is nothing
        near = 1e-10 * abs(torques).max() + picometre
        assert ours == pytest.approx(torques, rel=0, abs=near)
        matrix = peer.mass_matrix(q)
        near = 1e-10 * abs(matrix).max() + 1e-14
        assert described.mass_matrix(q) == pytest.approx(matrix, rel=0, abs=near)
