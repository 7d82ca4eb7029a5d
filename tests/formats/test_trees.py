"""Chains out of random trees, as URDF and in several spellings of SDF, against Pinocchio with the URDF."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from robodyn.formats import sdf, urdf
from robodyn.formats.elements import parse
from robodyn.formats.frames import description_of
from robodyn.formats.serial import Positions, serial_chain
from robodyn.formats.topology import Topology
from robodyn.formats.tree import MOVING, Tree
from robodyn_testing import commit_seeds, require_module, seed_counts
from robodyn_testing.arms import RigidArm
from robodyn_testing.chains import PinocchioArm
from robodyn_testing.random_trees import random_urdf

VERSIONS = {"old": "1.4", "plain": "1.6", "relative": "1.7", "frames": "1.11"}
NO_BODY = "<mass>0</mass><inertia><ixx>0</ixx><iyy>0</iyy><izz>0</izz></inertia>"


def as_sdf(pin: Any, path: str, spelling: str) -> str:
    """A URDF as SDF: poses in the model (old: axes too), relative to parents, or by named frames."""
    model = pin.buildModelFromUrdf(path)
    data = model.createData()
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    robot: Any = ElementTree.parse(path).getroot()
    places = {link.get("name"): data.oMf[model.getFrameId(link.get("name"))] for link in robot.iter("link")}
    parents = {j.find("child").get("link"): j.find("parent").get("link") for j in robot.iter("joint")}

    def pose(placement: Any, attributes: str = "") -> str:
        numbers = [*placement.translation, *pin.rpy.matrixToRpy(placement.rotation)]
        return f"<pose{attributes}>{' '.join(repr(float(x)) for x in numbers)}</pose>"

    def link(element: Any) -> str:
        name, inertial = element.get("name"), element.find("inertial")
        text = pose(places[name])
        if spelling == "frames":
            text = f'<pose relative_to="at {name}"/>'
        elif spelling == "relative" and name in parents:
            parent = parents[name]
            text = pose(places[parent].actInv(places[name]), f' relative_to="{parent}"')
        body = NO_BODY  # nothing in a URDF, 1 kg in SDF
        if inertial is not None:
            origin, tensor = inertial.find("origin"), inertial.find("inertia").attrib.items()
            body = f"<pose>{origin.get('xyz')} {origin.get('rpy')}</pose>"
            body += f"<mass>{inertial.find('mass').get('value')}</mass><inertia>"
            body += "".join(f"<{key}>{value}</{key}>" for key, value in tensor) + "</inertia>"
        frame = f'<frame name="at {name}">{pose(places[name])}</frame>' if spelling == "frames" else ""
        return f'<link name="{name}">{text}<inertial>{body}</inertial></link>{frame}'

    def joint(element: Any) -> str:
        child, limit = element.find("child").get("link"), element.find("limit")
        axis = np.array(element.find("axis").get("xyz").split(), float)
        axis = places[child].rotation @ axis if spelling == "old" else axis
        attributes, shift = "", ""
        if spelling == "frames":
            attributes, shift = f' expressed_in="at {child}"', '<pose degrees="true">0 0 0 20 30 40</pose>'
        ends = "" if limit is None else "".join(f"<{k}>{limit.get(k)}</{k}>" for k in ("lower", "upper"))
        direction = f"<xyz{attributes}>{' '.join(map(repr, axis.tolist()))}</xyz>"
        return (
            f'<joint name="{element.get("name")}" type="{element.get("type")}">{shift}<child>{child}</child>'
            f"<parent>{parents[child]}</parent><axis>{direction}<limit>{ends}</limit></axis></joint>"
        )

    parts = [*map(link, robot.iter("link")), *map(joint, robot.iter("joint"))]
    return f'<sdf version="{VERSIONS[spelling]}"><model name="m">{"".join(parts)}</model></sdf>'


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


@pytest.mark.parametrize("count", seed_counts(20, 400))
def test_a_chain_of_a_tree_is_what_pinocchio_makes_of_it(count: int, tmp_path: Path) -> None:
    pinocchio = require_module("pinocchio")
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
        text = as_sdf(pinocchio, str(path), tuple(VERSIONS)[seed % 4])
        check(sdf.read_tree(parse(text.encode(), "tree.sdf")), path, seed, "", tip, {})
