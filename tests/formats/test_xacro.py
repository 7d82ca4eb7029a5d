"""xacro: what expands, how packages are looked for, and what an untrusted file cannot do."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from robodyn.errors import InputError, ToolError
from robodyn.formats import xacro
from robodyn.formats.arm import import_arm, read_tree
from robodyn_testing import require_module
from robodyn_testing.urdf_text import link
from robodyn_testing.xacro_arms import PACKAGE

HEAD = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
MACRO = f"""{HEAD}
<xacro:macro name="arm" params="prefix length">
{link("${prefix}base")}{link("${prefix}tip")}
<joint name="${{prefix}}j" type="revolute"><origin xyz="${{length / 2 + sin(pi / 2)}} 0 0"/>
<parent link="${{prefix}}base"/><child link="${{prefix}}tip"/></joint>
</xacro:macro></robot>
"""
ARM = f"""{HEAD}
<xacro:arg name="prefix" default="left_"/>
<xacro:include filename="$(find arm_description)/urdf/macro.xacro"/>
<xacro:arm prefix="$(arg prefix)" length="0.5"/></robot>
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    require_module("xacro")
    path = tmp_path / "ws" / "arm_description" / "urdf"
    path.mkdir(parents=True)
    (path.parent / "package.xml").write_text(PACKAGE % "arm_description")
    (path / "macro.xacro").write_text(MACRO)
    (path / "arm.urdf.xacro").write_text(ARM)
    return path


def test_macros_arguments_and_packages_without_ros(folder: Path) -> None:
    imported = import_arm(folder / "arm.urdf.xacro")
    (only,) = imported.robot.links
    assert only.name == "left_j"
    assert import_arm(folder / "arm.urdf.xacro", arguments={"prefix": "r_"}).robot.links[0].name == "r_j"
    tree = read_tree(folder / "arm.urdf.xacro")
    assert tree.joints[0].origin.xyz == (1.25, 0.0, 0.0)
    assert tree.file == str(folder / "arm.urdf.xacro")
    assert tree.joints[0].where.file.endswith("arm.urdf.xacro (expanded)")


def test_packages_beside_and_of_ros_are_seen(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    other = folder.parents[1] / "other_description"
    other.mkdir()
    (other / "arm.xacro").write_text(ARM)
    assert len(read_tree(other / "arm.xacro").joints) == 1
    far = folder.parents[2] / "0" / "1" / "2" / "3" / "4" / "far.xacro"
    far.parent.mkdir(parents=True)
    far.write_text(ARM)
    with pytest.raises(InputError, match="none of ROS, names the package 'arm_description'"):
        read_tree(far)
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(folder.parents[1]))
    assert len(read_tree(far).joints) == 1
    share = folder.parents[2] / "opt" / "share"
    share.mkdir(parents=True)
    (share / "arm_description").mkdir()
    (share / "arm_description" / "urdf").symlink_to(folder)  # as colcon does it
    monkeypatch.setenv("ROS_PACKAGE_PATH", "")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(share.parent))
    assert len(read_tree(far).joints) == 1


def test_entities_are_refused_before_anything_runs(tmp_path: Path) -> None:
    path = tmp_path / "arm.xacro"
    path.write_text(f'<!DOCTYPE robot [<!ENTITY a "b">]>{HEAD}</robot>')
    with pytest.raises(InputError, match="the file has a document type"):
        xacro.expanded(path)


def test_without_the_package_the_extra_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "arm.xacro"
    path.write_text(f"{HEAD}</robot>")
    monkeypatch.setitem(sys.modules, "xacro", None)
    monkeypatch.setattr("importlib.util.find_spec", lambda _: None)
    with pytest.raises(ToolError, match=r"robodyn\[xacro\]") as caught:
        read_tree(path)
    assert caught.value.exit_code == 3
