"""What the kernels of a robot depend on changes their fingerprint, and nothing else does."""

from __future__ import annotations

from pathlib import Path

import pytest

from records.made import ELBOW
from robodyn.project import fingerprint
from robodyn.project.fingerprint import fingerprints
from robodyn.project.reading import read_project
from robodyn.toolchain.sources import folder_key
from robodyn_cli.project_keys import project_keys
from robodyn_testing import require_module

ARM = """\
<mujoco model="arm"><worldbody><body name="a">
  <joint name="j" axis="0 0 1"/><inertial pos="0.1 0 0" mass="2" diaginertia="0.1 0.1 0.1"/>
  <include file="part.xml"/>
</body></worldbody></mujoco>
"""
PART = """\
<mujocoinclude><body name="b" pos="0.3 0 0"><joint name="k" axis="0 1 0"/>
  <inertial pos="0.1 0 0" mass="1" diaginertia="0.1 0.1 0.1"/></body></mujocoinclude>
"""
XACRO = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="mass.xacro"/>
  <link name="base"/><link name="tip"><inertial><mass value="${m}"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
  <joint name="j" type="continuous"><parent link="base"/><child link="tip"/><axis xyz="0 1 0"/></joint>
</robot>
"""
MASS = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="m" value="2"/></robot>\n'


def of(folder: Path, robot: str, options: str = "") -> str:
    """The fingerprint of the robot in that file."""
    path = folder / "robodyn.toml"
    path.write_text(f"[robots.arm]\nrobot = '{robot}'\n{options}\n", encoding="utf-8")
    (key,) = fingerprints(read_project(path, project_keys()).entries).values()
    return key


def test_what_matters_and_what_does_not(tmp_path: Path) -> None:
    arm = tmp_path / "arm.yaml"
    arm.write_text(ELBOW)
    before = of(tmp_path, "arm.yaml")
    assert before == of(tmp_path, "arm.yaml", "output = 'elsewhere'\nbudgets.gravity.total = 5  # a comment")
    assert before == of(tmp_path, "./arm.yaml", "misra = false")
    assert before != of(tmp_path, "arm.yaml", "misra = true")
    (tmp_path / "other.yaml").write_text(ELBOW)
    assert before == of(tmp_path, "arm.yaml") == of(tmp_path, "other.yaml")
    arm.write_text(ELBOW.replace("mass: 2", "mass: 3"))
    assert before != of(tmp_path, "arm.yaml")
    arm.write_text(ELBOW)
    (tmp_path / "records").mkdir()
    (tmp_path / "records" / "any.record").touch()
    assert before != of(tmp_path, "arm.yaml")


def test_robodyns_own_files_matter(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = of(tmp_path, "ur5")
    for change in ({"a.py": "x = 1\n"}, {"a.py": "x = 2\n"}, {"a.py": "x = 2\n", "b.py": ""}):
        for name, text in change.items():
            (tmp_path / name).write_text(text)
        key = folder_key(tmp_path)
        monkeypatch.setattr(fingerprint, "own_key", lambda key=key: key)
        assert before != (before := of(tmp_path, "ur5"))


@pytest.mark.parametrize(
    ("package", "name", "texts", "old", "new"),
    [
        ("mujoco", "arm.xml", {"arm.xml": ARM, "part.xml": PART}, 'mass="1"', 'mass="1.5"'),
        ("xacro", "arm.xacro", {"arm.xacro": XACRO, "mass.xacro": MASS}, 'value="2"', 'value="3"'),
    ],
)
def test_included_files_matter(
    package: str, name: str, texts: dict[str, str], old: str, new: str, tmp_path: Path
) -> None:
    require_module(package)
    for file, text in texts.items():
        (tmp_path / file).write_text(text)
    before = of(tmp_path, name)
    assert before == of(tmp_path, name)
    *_, part = texts
    (tmp_path / part).write_text(texts[part].replace(old, new))
    assert before != of(tmp_path, name)
