"""MJCF that is put together: default classes, replicas, models that are attached, files that are included.

MuJoCo reads the same files, meshes too; torques, mass matrices and tips must be those that it computes.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from robodyn.formats.arm import read_tree
from robodyn.formats.serial import serial_chain
from robodyn.formats.tree import MOVING
from robodyn_testing import require_module
from robodyn_testing.mjcf_arms import (
    ATTACHED,
    GRIPPER,
    HAND,
    IN_CLASS,
    MERGED,
    MESH,
    SHAPE,
    SOLID,
    TENDONS,
    arm,
    write,
)
from robodyn_testing.mujoco_chains import check_chain


@pytest.fixture(autouse=True)
def mujoco() -> Any:
    return require_module("mujoco")


TORUS = '<plugin plugin="mujoco.sdf.torus"/>'
GRIPPED = '<attach model="g" body="palm" prefix="p_"/>'
INCLUDED = f"<mujocoinclude><body name='in_parts'>{SOLID}{SHAPE}</body></mujocoinclude>"
OFF = '<default><default class="off"><equality active="false"/><default class="in"/></default></default>'


def gripped(head: str, *changes: tuple[str, str]) -> tuple[dict[str, str], str]:
    """The arm with a gripper attached, and the gripper with some ``changes``; its finger is the tip."""
    text = GRIPPER
    for old, new in changes:
        text = text.replace(old, new)
    return {"arm.xml": arm(GRIPPED, head + ATTACHED % "gripper.xml"), "gripper.xml": text}, "p_finger"


#: Files of which the first is read, and the tip of its chain; a text alone is a file whose tip is ``b``.
READ: dict[str, str | tuple[dict[str, str], str]] = {
    "class in a class": arm(
        '<geom class="g"/>', MESH + IN_CLASS % '<default class="g"><geom rgba="1 0 0 1"/></default>'
    ),
    "another shape than the class's": arm(
        '<geom class="f" type="capsule" size="0.1 0.2" pos="0.1 0 0"/><geom class="f" mesh="m" density="0"/>',
        MESH + '<default><default class="f"><geom type="mesh" density="500"/></default></default>', solid="",
    ),
    "plugins of shapes": arm(
        f'<geom type="sphere" size="0.1" mass="2" pos="1 2 3">{TORUS}</geom>'
        f'<body>{SOLID}<geom type="sdf" mesh="t">{TORUS}</geom></body>',
        f'<extension>{TORUS}</extension><asset><mesh name="t">{TORUS}</mesh></asset>', solid="",
    ),
    "childclass of a frame": arm(
        f'<frame childclass="f" pos="0.1 0 0.2" euler="10 20 30"><geom/><body name="c">{SOLID}<geom/>'
        '<geom class="main" type="sphere" size="0.1" mass="2"/></body></frame>', MESH + IN_CLASS % "",
    ),
    "main class": arm("<geom/>", MESH + '<default><geom type="mesh" mesh="m" density="0"/></default>'),
    "default sections": arm(
        '<geom class="f" size="0.1 0.2 0.3" density="9"/>',
        '<default><default class="f"><geom type="box"/></default></default>'
        '<default><geom type="mesh"/></default>', solid="",
    ),
    "inactive by default, by a class or itself": arm(
        "", OFF, '<equality><joint class="off" joint1="i" joint2="j" polycoef="0.4 1 0 0 0"/>'
        '<connect active="false" body1="b" anchor="0 0 0"/></equality>',
    ),
    "inactive equation of tendons by default": arm(
        "", '<default><equality active="false"/></default>', TENDONS % ""
    ),
    "inactive equation of tendons by a class in a class": arm("", OFF, TENDONS % 'class="in"'),
    "equations of tendons switched off": arm("", '<option><flag equality="disable"/></option>', TENDONS % ""),
    "replicas of replicas": arm(
        '<replicate count="3" sep="-" offset="0 0.1 0" euler="0 0 50">'
        '<replicate count="11" offset="0 0 0.02">'
        f'<body pos="0.2 0 0">{SOLID}{SHAPE}<site name="s"/></body></replicate>'
        f'<frame pos="1 0 0">{SHAPE}</frame></replicate>'
    ),
    "replicas with joints beside the chain": arm(
        '<replicate count="12" euler="0 0 30"><body name="f" pos="0.2 0 0">'
        f'<joint name="k"/>{SOLID}</body></replicate>'
    ),
    "frames": arm(
        f'<frame pos="1 2 3" euler="10 20 30"><frame euler="0 0 9">{SHAPE}</frame></frame>', solid=""
    ),
    "attached whole, by the model's name": (
        {
            "arm.xml": arm(
                '<attach model="gripper" prefix="p/"/>', '<asset><model file="parts/gripper.xml"/></asset>'
            ),
            "parts/gripper.xml": GRIPPER,
        },
        "p/finger",
    ),
    "attached twice, in replicas": (
        {
            "arm.xml": arm(
                '<frame pos="0 0 1" euler="9 0 0"><attach model="g" body="palm" prefix="l_"/></frame>'
                '<replicate count="2" offset="1 0 0"><attach model="g" body="palm" prefix="r_"/></replicate>',
                ATTACHED % "gripper.xml",
            ),
            "gripper.xml": GRIPPER,
        },
        "l_finger",
    ),
    "attached, its gravity taken over": gripped(MERGED, ("<compiler", '<option gravity="1 2 -3"/><compiler')),
    "attached, its flags taken over": gripped(
        MERGED, ("<compiler", '<option><flag gravity="disable"/></option><compiler')
    ),
    "attached in what is attached": (
        {
            "arm.xml": arm('<attach model="g" body="wrist" prefix="out_"/>', ATTACHED % "parts/hand.xml"),
            "parts/hand.xml": HAND,
            "parts/gripper.xml": GRIPPER,
        },
        "out_in_finger",
    ),
    "attached, its inertia from shapes": gripped(
        "", ("<compiler ", '<compiler inertiafromgeom="true" '), ("<geom mass", f"{SHAPE}<geom mass"),
        (f"{SOLID}</body></body>", f"{SOLID}{SHAPE}</body></body>"),
    ),
    "meshes in replicas and in what is attached": (
        {
            "arm.xml": arm(
                '<replicate count="2" euler="0 0 9"><geom class="f"/>'
                '<attach model="g" prefix="p_"/></replicate>',
                MESH + IN_CLASS % "" + ATTACHED % "gripper.xml",
            ),
            "gripper.xml": GRIPPER.replace("<compiler", f"{MESH}<compiler").replace(
                "<geom mass", '<geom type="mesh" mesh="m" density="0"/><geom mass'
            ),
        },
        "p_finger0",
    ),
    "included beside the file that includes, and beside the first": (
        {
            "arm.xml": arm(
                '<geom class="f"/><include file="parts/a.xml"/>', MESH + '<include file="classes.xml"/>'
            ),
            "classes.xml": f"<mujocoinclude>{IN_CLASS % ''}</mujocoinclude>",
            "parts/a.xml": '<mujocoinclude><include file="b.xml"/><include file="c.xml"/></mujocoinclude>',
            "parts/b.xml": INCLUDED,
            "parts/c.xml": "<mujocoinclude/>",
            "c.xml": INCLUDED.replace("in_parts", "beside"),
        },
        "b",
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", READ)
def test_the_arm_is_what_mujoco_makes_of_the_files(case: str, tmp_path: Path, mujoco: Any) -> None:
    read = READ[case]
    files, tip = ({"arm.xml": read}, "b") if isinstance(read, str) else read
    path = write(tmp_path, files)
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
