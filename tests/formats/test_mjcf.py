"""MJCF through MuJoCo: the same chains as MuJoCo computes itself, and what is not handed to it."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from robodyn.errors import InputError
from robodyn.formats.chain import Spring
from robodyn.formats.elements import parse
from robodyn.formats.mjcf import read_tree
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.tree import Tree
from robodyn.robot.model import Coupling
from robodyn_testing import commit_seeds, require_module, seed_counts
from robodyn_testing.mujoco_chains import check_chain
from robodyn_testing.random_mjcf import random_mjcf


@pytest.fixture(autouse=True)
def mujoco() -> Any:
    return require_module("mujoco")


def tree(text: str, path: Path | None = None) -> Tree:
    return read_tree(parse(text.encode(), "arm.xml"), path)


def chain(text: str, **options: Any) -> Serial:
    return serial_chain(tree(text), "arm", **options)


@pytest.mark.parametrize("count", seed_counts(8, 300))
def test_a_chain_is_what_mujoco_computes(count: int, mujoco: Any) -> None:
    for seed in commit_seeds(count):
        text = random_mjcf(seed)
        serial = serial_chain(tree(text), "tree", tip="tip")
        assert serial.chain.gravity == (1.0, 2.0, -9.5)
        assert serial.chain.joints[-1].gear is not None
        sides = [joint.name for joint in tree(text).joints if joint.name.startswith("s")]
        check_chain(mujoco, mujoco.MjModel.from_xml_string(text), serial, "tip", dict.fromkeys(sides, 0.0))


def mjcf(inside: str, head: str = "", tail: str = "") -> str:
    return f'<mujoco model="arm">{head}\n<worldbody>\n{inside}\n</worldbody>{tail}</mujoco>'


SOLID = '<inertial pos="0.1 0 0" mass="2" diaginertia="0.01 0.02 0.02"/>'
TWO = mjcf(
    f'<body name="a"><joint name="i"/>{SOLID}\n'
    f'<body name="b" pos="1 0 0"><joint name="j"/>{SOLID}</body></body>'
)


def test_a_mesh_is_never_opened_and_its_inertia_is_missing() -> None:
    text = mjcf(
        f'<body name="a"><joint name="i"/><geom mesh="m"/><geom type="box" size="1 1 1"/>'
        f'<body name="b"><joint name="j"/>{SOLID}<geom class="shown" mesh="m"/></body></body>',
        '<default><geom type="mesh"/><default class="shown"><geom density="0"/></default></default>'
        '<asset><mesh name="m" file="/dev/zero"/><texture name="t" file="missing.png"/></asset>',
    )
    serial = chain(text)
    assert serial.remarks == (
        "links without inertia, and so without mass: a",
        "joints that carry no mass: i",
    )
    assert serial.chain.joints[0].body.mass == 0
    assert serial.chain.joints[1].body.mass == 2
    assert [part.what for part in tree(text).unused] == ["meshes, textures and materials"]


@pytest.mark.parametrize("total", ["10", "-1"])
@pytest.mark.parametrize("mesh", ['<geom type="mesh" mesh="m"/>', '<geom type="mesh" mesh="m" density="0"/>'])
def test_masses_that_are_scaled_are_unknown_if_one_is_a_meshs(mesh: str, total: str) -> None:
    text = TWO.replace("<worldbody>", f'<compiler settotalmass="{total}"/><worldbody><body>{mesh}</body>')
    text = text.replace("<worldbody>", '<asset><mesh name="m" file="m.stl"/></asset><worldbody>')
    read, unknown = tree(text), "density" not in mesh and total == "10"
    assert any("settotalmass" in remark for remark in read.remarks) is unknown
    masses = [link.body and link.body.mass for link in read.links if link.name in ("a", "b")]
    assert masses == ([None, None] if unknown else [5, 5] if total == "10" else [2, 2])
    joints = serial_chain(read, "arm").chain.joints
    assert [joint.origins.unknown for joint in joints] == [unknown, unknown]


#: Where a body with a mesh is, and which joints have springs for its inertia.
MESHES = {
    "at the tip": ("</body></body>", "%s</body></body>", ["i", "j"]),
    "beside": ("</body></body>", "</body>%s</body>", ["i", "j"]),
    "on the world": ("<worldbody>", "<worldbody>%s", []),
    "of another arm": ("<worldbody>", "<worldbody><body><joint/>%s</body>", []),
}


@pytest.mark.parametrize("case", MESHES)
def test_springs_for_an_unknown_inertia_are_refused(case: str) -> None:
    old, new, refused = MESHES[case]
    text = TWO.replace("<joint ", '<joint springdamper="0.2 0.5" ')
    mesh = '<body><geom type="mesh" mesh="m"/></body>'
    read = tree(text.replace(old, new % (SOLID + mesh if "another" in case else mesh)))
    assert [(each.name, each.of) for each in read.physics] == [
        ("springdamper", f"joint {name}") for name in refused
    ]
    arm = [joint for joint in read.joints if joint.name in ("i", "j")]
    assert [joint.name for joint in arm if joint.spring is None and joint.damping is None] == refused


def test_inertias_of_shapes_are_mujocos_and_remarked(mujoco: Any) -> None:
    text = mjcf('<body name="a"><joint name="i"/><geom type="box" size="0.1 0.2 0.3" mass="3"/></body>')
    serial = chain(text)
    assert serial.remarks == ("inertia from shapes, as MuJoCo computes it: a",)
    assert serial.chain.joints[0].body.inertia[:3] == pytest.approx((0.13, 0.1, 0.05))


def test_a_tensor_is_that_of_the_file_to_the_digit() -> None:
    stated = SOLID.replace("diaginertia", "fullinertia").replace(
        "0.02 0.02", "0.021 0.022 0.001 0.002 -0.003"
    )
    serial = chain(TWO.replace(SOLID, stated, 1))
    assert serial.chain.joints[0].body.inertia == (0.01, 0.021, 0.022, 0.001, 0.002, -0.003)


def test_actuators_are_gears_and_limits_of_torque_and_springs_are_slack_where_the_file_says() -> None:
    spring = 'ref="0.1" springref="0.2" stiffness="3"'
    actuators = (
        '<actuator><motor joint="i" gear="100" ctrlrange="-2 2" armature="0.001"/>'
        '<motor joint="j" gear="40" ctrlrange="-1 1"/><motor site="s"/></actuator></mujoco>'
    )
    text = TWO.replace("</mujoco>", actuators).replace('name="j"', f'name="j" {spring}')
    first, second = chain(text.replace("<worldbody>", '<compiler angle="radian"/><worldbody>')).chain.joints
    assert first.gear is not None
    assert [first.gear.ratio, first.limits.torque, first.motor_inertia] == [100, 200, 10]
    assert [second.gear, second.limits.torque, second.spring] == [None, 40, Spring(3.0, 0.2)]


def test_joints_that_follow_and_loops() -> None:
    coupled = '<equality><joint name="e" joint1="j" joint2="i" polycoef="0.5 2 0 0 0"/></equality></mujoco>'
    follows = TWO.replace("</mujoco>", coupled)
    (mimic,) = [joint.mimic for joint in tree(follows).joints if joint.mimic]
    assert (mimic.leader, mimic.multiplier, mimic.offset) == ("i", 2, 0.5)
    assert chain(follows).chain.couplings == (Coupling(2, 1, Fraction(2), Fraction(1, 2)),)
    tied = TWO.replace("</mujoco>", '<equality>\n<weld name="w" body1="b"/></equality></mujoco>')
    with pytest.raises(InputError, match=r"arm\.xml:6:1: the constraint w closes a loop through the chain"):
        chain(tied)
    between = TWO.replace("</mujoco>", '<equality><weld name="w" body1="b" body2="a"/></equality></mujoco>')
    assert len(chain(between, locks={"j": 0.5}).chain.joints) == 1


def test_a_free_base_is_held_and_sites_are_tips() -> None:
    text = TWO.replace('<joint name="i"/>', '<freejoint name="f"/><site name="s" pos="0 0 1"/>')
    serial = chain(text)
    assert [joint.name for joint in serial.chain.joints] == ["j"]
    assert "the base is fixed: f is a floating joint at the root" in serial.remarks
    assert chain(
        TWO.replace("</body></body>", '<site name="s" pos="0 0 1"/></body></body>')
    ).chain.tool.xyz == (0, 0, 1)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('name="j"', 'name="j" type="knee"', "arm.xml:4:28: MuJoCo refuses the file; found XML"),
        (SOLID, "", "MuJoCo refuses the file; found Error: mass and inertia of moving bodies must be larger"),
        ("<worldbody>", '<size memory="900G"/><extension><plugin plugin="x"/></extension><worldbody>', ""),
    ],
)
def test_what_mujoco_refuses_has_its_place(old: str, new: str, words: str) -> None:
    text = TWO.replace(old, new, 1)
    if not words:
        assert len(chain(text).chain.joints) == 2
        return
    with pytest.raises(InputError) as caught:
        tree(text)
    assert words in str(caught.value)


def test_files_are_included_from_the_folder_and_below_only(tmp_path: Path) -> None:
    folder = tmp_path / "arm"
    (folder / "parts").mkdir(parents=True)
    body = f'<body name="a"><joint name="i"/>{SOLID}<light/></body>'
    (folder / "parts" / "a.xml").write_text(f"<mujocoinclude>\n{body}</mujocoinclude>")
    (tmp_path / "outside.xml").write_text(f"<mujocoinclude>{body}</mujocoinclude>")
    (folder / "link.xml").symlink_to(tmp_path / "outside.xml")
    (folder / "again.xml").write_text('<mujocoinclude><include file="again.xml"/></mujocoinclude>')
    path = folder / "arm.xml"
    read = tree(mjcf('<include file="parts/a.xml"/>'), path)
    assert [link.name for link in read.links] == ["world", "a"]
    assert (read.links[1].where.file, read.links[1].where.line) == ("parts/a.xml", 2)
    assert [part.text("arm.xml") for part in read.unused] == ["lights (parts/a.xml: line 2)"]
    for name, words in (
        ("../outside.xml", "outside of the folder; found '../outside.xml'"),
        (str(tmp_path / "outside.xml"), "outside of the folder"),
        ("link.xml", "outside of the folder"),
        ("again.xml", "again.xml:1:25: the file is included twice"),
        ("none.xml", "arm.xml:3:10: the file that is included is not there"),
        ("", "outside of the folder"),
    ):
        with pytest.raises(InputError) as caught:
            tree(mjcf(f'<include file="{name}"/>'), path)
        assert words in str(caught.value)


def test_nothing_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    tree(random_mjcf(250))  # whose mass matrix is near to singular
    assert list(tmp_path.iterdir()) == []


def test_a_joint_without_a_name_gets_one_that_no_other_has() -> None:
    text = """<mujoco><worldbody><body><joint/><geom size="1"/><body><joint name="joint2"/><geom size="1"/>
    </body></body></worldbody></mujoco>"""
    assert [joint.name for joint in tree(text).joints] == ["joint3", "joint2"]
