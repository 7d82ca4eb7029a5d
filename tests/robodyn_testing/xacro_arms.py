"""Everyday xacro files, written for the tests: what the descriptions of arms that are sold are built like."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Final

HEAD = '<?xml version="1.0"?><robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
#: A link and a joint that a case may use: its own numbers stand in ``${m}``.
BODY = """<link name="b"/><link name="l1"><inertial><origin xyz="0.1 0 0.2"/><mass value="${m}"/>
<inertia ixx="0.03" ixy="0" ixz="0" iyy="0.05" iyz="0" izz="0.04"/></inertial></link>
<joint name="j1" type="revolute"><origin xyz="0 0 0.3" rpy="0.1 0 0"/><parent link="b"/><child link="l1"/>
<axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="100" velocity="3"/></joint>"""


def arm(before: str) -> str:
    """A file with one joint, after ``before``, which binds ``m``."""
    return f"{HEAD}{before}{BODY}</robot>"


PACKAGE: Final = "<package format='3'><name>%s</name><version>0.0.1</version></package>"
_MACROS: Final = """<xacro:macro name="bar" params="name mass"><link name="${name}"><inertial>
<origin xyz="0 0 ${_len/2}"/><mass value="${mass}"/>
<inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.001"/></inertial></link></xacro:macro>
<xacro:macro name="axis" params="name type parent child z"><joint name="${name}" type="${type}">
<origin xyz="0 0 ${z}"/><parent link="${parent}"/><child link="${child}"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="40" velocity="3"/></joint></xacro:macro>"""
TWO_LINKS: Final = f"""{HEAD}<xacro:property name="_len" value="0.4"/>{_MACROS}
<link name="base"/><xacro:bar name="upper" mass="2"/><xacro:bar name="lower" mass="1.2"/>
<xacro:axis name="shoulder" type="revolute" parent="base" child="upper" z="0.1"/>
<xacro:axis name="elbow" type="revolute" parent="upper" child="lower" z="${{_len}}"/></robot>"""


def write(folder: Path, files: Mapping[str, str]) -> None:
    """Write ``files`` below ``folder``."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
