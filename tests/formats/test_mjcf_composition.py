"""MJCF that is put together: default classes, replicas, models that are attached, files that are included.

MuJoCo reads the same files, meshes too; torques, mass matrices and tips must be those that it computes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from robodyn.formats.arm import read_tree
from robodyn.formats.serial import serial_chain
from robodyn.formats.tree import MOVING
from robodyn_testing import require_module
from robodyn_testing.mjcf_arms import (
    ATTACHED,
    MESH,
    SOLID,
    arm,
    write,
)
from robodyn_testing.mujoco_chains import check_chain


@pytest.fixture(autouse=True)
def mujoco() -> Any:
    return require_module("mujoco")


#: Files of which the first is read, and the tip of its chain.
READ: dict[str, dict[str, Any]] = yaml.safe_load(
    Path(__file__).with_name("mjcf_composition.yaml").read_text(encoding="utf-8")
)


@pytest.mark.parametrize("case", READ)
def test_the_arm_is_what_mujoco_makes_of_the_files(case: str, tmp_path: Path, mujoco: Any) -> None:
    tip = READ[case]["tip"]
    path = write(tmp_path, READ[case]["files"])
    model = mujoco.MjModel.from_xml_path(str(path))
    tree = read_tree(path)
    assert {link.name for link in tree.links} >= {model.body(i).name for i in range(model.nbody)} - {""}
    assert {joint.name for joint in tree.joints} >= {model.joint(i).name for i in range(model.njnt)}
    assert all(link.where.line for link in tree.links if link.name != "world")
    serial = serial_chain(tree, "arm", tip=tip)
    assert not [remark for remark in serial.remarks if "without inertia" in remark]
    chain = {joint.name for joint in serial.chain.joints}
    beside = [joint.name for joint in tree.joints if joint.kind in MOVING and joint.name not in chain]
    check_chain(mujoco, model, serial, tip, dict.fromkeys(beside, 0.0))
    dampings = [float(model.dof_damping[model.joint(joint.name).dofadr[0]]) for joint in serial.chain.joints]
    assert [joint.viscous for joint in serial.chain.joints] == dampings


@pytest.mark.parametrize("attached", [False, True])
@pytest.mark.parametrize(
    "rule", ['inertiafromgeom="true"', 'inertiafromgeom="true" inertiagrouprange="1 2"', ""]
)
def test_whether_a_mesh_counts_is_what_its_own_model_says(rule: str, attached: bool, tmp_path: Path) -> None:
    """MuJoCo puts the inertia of shapes in place of the one that is stated, in models that say so."""
    compiler = f"{MESH}<compiler {rule}/>"
    files = {"arm.xml": arm('<geom type="mesh" mesh="m"/>', compiler)}
    if attached:
        hand = f'<body name="b">{SOLID}<joint name="k"/><geom type="mesh" mesh="m"/></body>'
        files = {
            "arm.xml": arm('<attach model="g" prefix="p_"/>', ATTACHED % "hand.xml"),
            "hand.xml": f'<mujoco model="g">{compiler}<worldbody>{hand}</worldbody></mujoco>',
        }
    links = {link.name: link for link in read_tree(write(tmp_path, files)).links}
    assert (links["p_b" if attached else "b"].body is None) is (rule == 'inertiafromgeom="true"')
