"""What changes torques in a file is modelled, as MuJoCo has it, or refused until it is left out by name."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from robodyn import InputError, load
from robodyn.robot import Robot
from robodyn.verify.against import compare, read_original
from robodyn.verify.reference import Reference
from robodyn_testing import require_module

MJCF = """<mujoco model="arm"><compiler angle="radian"/>{option}{default}
<worldbody><body name="b1" pos="0.1 0 0.3" quat="0.9 0.1 0.2 -0.3"{body}>
<joint name="j1" axis="0.3 0.5 0.8"{joint}/>
<inertial pos="0.1 0.02 -0.03" euler="0.2 0.3 0.4" mass="2.5" diaginertia="0.03 0.05 0.04"/>
<body name="b2" pos="0.1 0.2 0.3" euler="0.7 0.2 0.5">
<joint name="j2" type="slide" axis="-1 0.5 0.8" stiffness="12" springref="0.2" damping="0.4"/>
<inertial pos="0.2 -0.02 0.03" mass="1.5" fullinertia="0.02 0.03 0.025 -0.001 0.001 0.004"/>
<body name="b3" pos="0.1 0.2 -0.3" axisangle="0.2 0.3 0.5 1.2">
<joint name="j3" axis="0 -1 0" pos="0.02 0.03 0.01" frictionloss="0.7"/>
<inertial pos="0.02 0.1 0.03" mass="0.7" fullinertia="0.01 0.02 0.015 -0.001 0.001 0.002"/>
<site name="tool" pos="0.1 0.2 -0.3" euler="0.7 1.2 0.5"/>
</body></body></body></worldbody>{tail}</mujoco>"""
NOTHING = dict.fromkeys(("option", "default", "body", "joint", "tail"), "")

HELD = '<equality><joint joint1="j2" polycoef="0.25 0 0 0 0"/></equality>'
MODELLED = {
    "a joint that is held": {"tail": HELD},
    "motors on one joint": {
        "tail": '<actuator><motor joint="j1" gear="-50" armature="2e-4"/>'
        '<position joint="j1" kp="9" armature="1e-4" damping="0.3"/>'
        '<intvelocity joint="j3" kp="9" gear="3" armature="1e-3" actrange="-1 1"/></actuator>'
    },
    "a motor in the parent's frame": {
        "tail": '<actuator><motor jointinparent="j1" gear="5" armature="2e-4"/></actuator>'
    },
    "a tendon that only measures, with a motor that has neither": {
        "tail": '<tendon><fixed name="t"><joint joint="j1" coef="1"/></fixed></tendon>'
        '<actuator><motor tendon="t" gear="5"/></actuator>'
    },
    "a motor of a class": {
        "default": '<default><general armature="3e-4" damping="0.02"/></default>',
        "tail": '<actuator><damper joint="j3" gear="20" kv="1" ctrlrange="0 1"/>'
        '<motor joint="j2"/></actuator>',
    },
    "gravity compensated without gravity": {"option": '<option gravity="0 0 0"/>', "body": ' gravcomp="1"'},
}  # fmt: skip


def written(folder: Path, parts: dict[str, str]) -> Path:
    path = folder / "arm.xml"
    path.write_text(MJCF.format(**{**NOTHING, **parts}))
    return path


def check(robot: Robot, path: Path) -> None:
    """It is what MuJoCo reads in the file."""
    rows = compare(robot, read_original(path).arm(robot, {}), states=40)
    assert [row for row in rows if not row.passed] == []


@pytest.mark.parametrize("name", MODELLED)
def test_what_is_modelled_is_mujocos(name: str, tmp_path: Path) -> None:
    require_module("mujoco")
    path = written(tmp_path, MODELLED[name])
    check(load(path, warn=lambda _: None), path)


def test_what_is_left_out_leaves_the_rest_as_it_is(tmp_path: Path) -> None:
    require_module("mujoco")
    plain = load(written(tmp_path, {}), warn=lambda _: None)
    path = written(tmp_path, {"body": ' gravcomp="0.5"'})
    assert load(path, without=["gravcomp"], warn=lambda _: None) == plain
    with pytest.raises(InputError, match="nothing of this name is left out"):
        load(path, without=["wind"])


def test_a_site_between_two_points_is_a_frame_there(tmp_path: Path) -> None:
    """As the tip: at the middle, its z axis along the line, as MuJoCo has it."""
    mujoco = require_module("mujoco")
    site = 'type="capsule" size="0.01" fromto="0.1 0.2 -0.3 0.3 0.1 0.2"'
    text = MJCF.format(**NOTHING).replace('pos="0.1 0.2 -0.3" euler="0.7 1.2 0.5"', site)
    path = tmp_path / "arm.xml"
    path.write_text(text)
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    data.qpos[:] = 0.3, -0.2, 0.5
    mujoco.mj_kinematics(model, data)
    pose = np.array(Reference(load(path, warn=lambda _: None)).tool_pose(data.qpos))
    assert pose[:3, 3] == pytest.approx(data.site("tool").xpos, abs=1e-12)
    assert pose[:3, :3].ravel() == pytest.approx(data.site("tool").xmat, abs=1e-12)


def test_what_is_left_out_in_many_places_is_one_remark(tmp_path: Path) -> None:
    transmissions = "".join(TRANSMISSION.format(i, f"x{i}", 9) for i in range(100))
    (tmp_path / "arm.urdf").write_text(URDF.format(transmissions))
    remarks: list[str] = []
    load(tmp_path / "arm.urdf", without=["transmission"], warn=remarks.append)
    (remark,) = (remark for remark in remarks if "left out, although it changes torques" in remark)
    assert "(joint x0; " in remark
    assert remark.endswith(" and 60 more)")


@pytest.mark.parametrize("limits", ['forcerange="-2 3"', 'ctrlrange="-2 3"'])
def test_a_motor_that_turns_the_other_way(limits: str, tmp_path: Path) -> None:
    require_module("mujoco")
    remarks: list[str] = []
    tail = f'<actuator><motor joint="j1" gear="-50" {limits}/></actuator>'
    robot = load(written(tmp_path, {"tail": tail}), warn=remarks.append)
    gear = robot.links[0].joint.gear
    assert gear is not None
    assert gear.ratio == -50
    words = "forces -2 to 3 taken as the same both ways, the larger: joint j1"
    assert any(text.endswith(words) for text in remarks)


URDF = """<robot name="arm"><link name="base"/><link name="arm"><inertial><mass value="1"/>
<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>
{}</robot>"""
TRANSMISSION = """<transmission name="t{0}"><joint name="{1}"/><actuator name="m{0}">
<mechanicalReduction>{2}</mechanicalReduction></actuator></transmission>"""


def test_a_message_is_the_same_whatever_the_seed_of_hashes(tmp_path: Path) -> None:
    links = "".join(f'<link name="l{i}"/>' for i in range(9))
    names = [f"{letter}{i}" for i, letter in enumerate("qwertzui")]
    joints = "".join(
        f'<joint name="{name}" type="fixed"><parent link="l{i}"/><child link="l{i + 1}"/></joint>'
        for i, name in enumerate(names)
    )
    (tmp_path / "arm.urdf").write_text(
        f'<robot name="arm">{links}{joints}{TRANSMISSION.format(1, "x", 9)}</robot>'
    )
    with pytest.raises(InputError, match=f"one of the joints {', '.join(names)}"):
        load(tmp_path / "arm.urdf")


def test_urdf_twice_the_same(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(
        URDF.format(TRANSMISSION.format(1, "j", -9) + TRANSMISSION.format(2, "j", -9))
    )
    gear = load(tmp_path / "arm.urdf", warn=lambda _: None).links[0].joint.gear
    assert gear is not None
    assert gear.ratio == -9


NEUTRAL = """<sdf version="1.10"><model name="arm"><link name="base"/><joint name="fix" type="fixed">
<parent>world</parent><child>base</child></joint>
<link name="arm"><inertial><mass>1</mass></inertial><gravity>1</gravity><enable_wind>0</enable_wind></link>
<joint name="j" type="revolute"><parent>base</parent><child>arm</child><axis><xyz>0 1 0</xyz></axis></joint>
</model></sdf>"""


def test_words_that_change_nothing_are_not_refused(tmp_path: Path) -> None:
    (path := tmp_path / "arm.sdf").write_text(NEUTRAL)
    assert load(path, warn=lambda _: None).n == 1


def test_what_mujoco_refuses_leaves_no_log(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    require_module("mujoco")
    monkeypatch.chdir(tmp_path)
    path = written(tmp_path, {"option": '<option><flag gravity="perhaps"/></option>'})
    with pytest.raises(InputError, match=r"MuJoCo refuses the file; .*'perhaps'"):
        load(path)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]


def test_names_in_messages_are_one_line(tmp_path: Path) -> None:
    require_module("mujoco")
    path = tmp_path / "arm.xml"
    tail = '<actuator><motor joint="j&#10;1" forcerange="-1 2"/></actuator>'
    text = MJCF.format(**{**NOTHING, "tail": tail}).replace('name="j1"', 'name="j&#10;1"')
    text = text.replace('"j3"', '"nan"')  # a name, and no number
    path.write_text(text)
    remarks: list[str] = []
    load(path, warn=remarks.append)
    assert remarks
    assert not any("\n" in remark for remark in remarks)
    path.write_text(text.replace('name="b1"', 'name="b&#10;1" gravcomp="1"'))
    with pytest.raises(InputError) as raised:
        load(path)
    assert "\n" not in str(raised.value)
