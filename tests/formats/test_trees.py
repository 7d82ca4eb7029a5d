"""Chains out of random trees, against Pinocchio reading the same URDF; what SDF adds: test_sdf_frames.py."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn.formats import urdf
from robodyn.formats.elements import parse
from robodyn.formats.frames import description_of
from robodyn.formats.serial import Positions, serial_chain
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, Tree
from robodyn_testing import commit_seeds, require_module, seed_counts
from robodyn_testing.arms import RigidArm
from robodyn_testing.chains import PinocchioArm
from robodyn_testing.random_trees import random_urdf


def check(tree: Tree, path: Path, seed: int, base: str, tip: str, locks: dict[str, float]) -> None:
    """A chain of ``tree``, with all that is locked, is what Pinocchio makes of the URDF at ``path``."""
    pinocchio, draw = require_module("pinocchio"), np.random.default_rng(seed)
    chain = serial_chain(tree, "tree", base, tip, locks).chain
    positions = Positions(Topology(tree), locks)
    locked = {joint.name: positions.of(joint) for joint in tree.joints if joint.kind in MOVING}
    names = [joint.name for joint in chain.joints]
    peer = PinocchioArm(pinocchio, path.read_text(), names, locked, chain.gravity)
    described = RigidArm(description_of(chain))
    picometre = 1e-12 * 9.81 * sum(joint.body.mass for joint in chain.joints)  # N m: is nothing
    for q, qd, qdd in draw.uniform(-2, 2, (3, 3, len(names))):
        torques, matrix = peer.torques(q, qd, qdd), peer.mass_matrix(q)
        largest = abs(torques).max()
        near = 1e-10 * largest + picometre
        assert described.torques(q, qd, qdd) == pytest.approx(torques, rel=0, abs=near)
        assert described.tip(q) == pytest.approx(peer.tip(q, tip), rel=0, abs=1e-11)
        near = 1e-10 * abs(matrix).max() + 1e-14
        assert described.mass_matrix(q) == pytest.approx(matrix, rel=0, abs=near)


@pytest.mark.parametrize("count", seed_counts(10, 400))
def test_a_chain_of_a_tree_is_what_pinocchio_makes_of_it(count: int, tmp_path: Path) -> None:
    for seed in commit_seeds(count):
        (path := tmp_path / "tree.urdf").write_text(random_urdf(seed))
        tree, draw = urdf.read_tree(parse(path.read_bytes(), "tree.urdf")), np.random.default_rng(seed)
        tip, second = tree.links[-1].name, tree.links[1].name
        above = Topology(tree).path(tip)
        on_path = {joint.name for joint in above} if len(above) <= 6 else set()
        beside = [each.name for each in tree.joints if each.kind in MOVING and each.name not in on_path]
        locks = {name: 1.0 for name in beside[:-1] if draw.random() < 0.3}
        base = second if seed % 3 == 0 and second in {joint.parent for joint in above} else ""
        check(tree, path, seed, base, tip, locks)
