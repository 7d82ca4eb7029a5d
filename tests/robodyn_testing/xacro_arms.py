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


def named(name: str) -> str:
    """A property that is called ``name``, and what is computed of it."""
    return f'<xacro:property name="{name}" value="2.5"/><link name="l_{name}" value="${{{name} * 2}}"/>'


def values(*expressions: str, before: str = "") -> str:
    """A file that writes the values of ``expressions`` into its links."""
    links = "".join(f'<link name="l{i}" value="${{{text}}}"/>' for i, text in enumerate(expressions))
    return f"{HEAD}{before}{links}</robot>"


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

#: A family of arms in one package whose folder is called otherwise: a top file, a macro of the arm, macros of
#: all, and tables of numbers in YAML, by model.
FAMILY: Final = {
    "Series_Description-main/package.xml": PACKAGE % "series_description",
    "Series_Description-main/urdf/series.urdf.xacro": f"""{HEAD}
<xacro:arg name="name" default="series"/><xacro:arg name="model" default="s5"/>
<xacro:arg name="tf_prefix" default=""/>
<xacro:arg name="limits" default="$(find series_description)/config/$(arg model)/joint_limits.yaml"/>
<xacro:arg name="kinematics" default="$(find series_description)/config/$(arg model)/kinematics.yaml"/>
<xacro:arg name="absolute" default="false"/>
<xacro:include filename="$(find series_description)/urdf/series_macro.xacro"/>
<link name="world"/>
<xacro:series_robot name="$(arg name)" tf_prefix="$(arg tf_prefix)" parent="world"
 limits_file="$(arg limits)" kinematics_file="$(arg kinematics)"
 visual_file="$(find series_description)/config/visual.yaml" force_abs_paths="$(arg absolute)">
<origin xyz="0 0 0" rpy="0 0 ${{pi/4}}"/></xacro:series_robot></robot>""",
    "Series_Description-main/urdf/series_macro.xacro": f"""{HEAD}
<xacro:include filename="$(find series_description)/urdf/inc/common.xacro"/>
<xacro:macro name="series_robot" params="name tf_prefix parent *origin limits_file kinematics_file visual_file
 safety_limits:=false safety_pos_margin:=0.15 force_abs_paths:=false
 initial_positions:=${{dict(shoulder=0.0,elbow=-1.57)}}">
<xacro:read_model_data limits_file="${{limits_file}}" kinematics_file="${{kinematics_file}}"
 visual_file="${{visual_file}}" force_abs_paths="${{force_abs_paths}}"/>
<link name="${{tf_prefix}}base_link"><visual><geometry><xacro:get_mesh name="base" type="visual"/></geometry>
</visual></link>
<xacro:property name="lower" value="${{sec_limits['shoulder']['min']}}"/>
<joint name="${{tf_prefix}}mount" type="fixed"><xacro:insert_block name="origin"/>
<parent link="${{parent}}"/><child link="${{tf_prefix}}base_link"/></joint>
<xacro:stage name="shoulder" parent="${{tf_prefix}}base_link"/>
<xacro:stage name="elbow" parent="${{tf_prefix}}shoulder_link"/>
</xacro:macro>
<xacro:macro name="stage" params="name parent">
<xacro:property name="row" value="${{config_kinematics['kinematics'][name]}}"/>
<joint name="${{tf_prefix}}${{name}}_joint" type="revolute"><parent link="${{parent}}"/>
<child link="${{tf_prefix}}${{name}}_link"/>
<origin xyz="${{row['x']}} ${{row['y']}} ${{row['z']}}" rpy="${{row['roll']}} ${{row.pitch}} ${{row.yaw}}"/>
<axis xyz="0 0 1"/>
<xacro:unless value="${{safety_limits}}"><limit lower="${{sec_limits[name]['min']}}"
 upper="${{sec_limits[name]['max']}}" effort="${{sec_limits[name]['effort']}}"
 velocity="${{sec_limits[name]['velocity']}}"/></xacro:unless>
<dynamics damping="0" friction="0"/></joint>
<link name="${{tf_prefix}}${{name}}_link">
<visual><origin xyz="0 0 ${{sec_mesh_files[name]['offset']}}" rpy="${{pi/2}} 0 ${{-pi/2}}"/>
<geometry><xacro:get_mesh name="${{name}}" type="visual"/></geometry></visual>
<xacro:cylinder_inertial radius="0.06" length="0.5" mass="${{masses[name]}}">
<origin xyz="${{-0.5 * 0.425}} 0.0 0.13" rpy="0 ${{pi/2}} 0"/></xacro:cylinder_inertial></link>
<state name="${{name}}" value="${{initial_positions[name]}}"/>
</xacro:macro></robot>""",
    "Series_Description-main/urdf/inc/common.xacro": f"""{HEAD}
<xacro:macro name="cylinder_inertial" params="radius length mass *origin"><inertial><mass value="${{mass}}"/>
<xacro:insert_block name="origin"/>
<inertia ixx="${{0.0833333 * mass * (3 * radius * radius + length * length)}}" ixy="0.0" ixz="0.0"
 iyy="${{0.0833333 * mass * (3 * radius * radius + length * length)}}" iyz="0.0"
 izz="${{0.5 * mass * radius * radius}}"/></inertial></xacro:macro>
<xacro:macro name="get_visual_params" params="name:=^ type:=^">
<xacro:property name="visual_params" value="${{sec_mesh_files[name][type]}}" scope="parent"/></xacro:macro>
<xacro:macro name="get_mesh_path" params="name:=^ type:=^"><xacro:get_visual_params/>
<xacro:if value="${{force_abs_paths}}"><xacro:property name="mesh" scope="parent"
 value="file://$(find ${{visual_params['mesh']['package']}})/${{visual_params['mesh']['path']}}"/></xacro:if>
<xacro:unless value="${{force_abs_paths}}"><xacro:property name="mesh" scope="parent"
 value="package://${{visual_params['mesh']['package']}}/${{visual_params['mesh']['path']}}"/></xacro:unless>
</xacro:macro>
<xacro:macro name="get_mesh" params="name type"><xacro:get_mesh_path/><mesh filename="${{mesh}}"/>
</xacro:macro>
<xacro:macro name="read_model_data" params="limits_file kinematics_file visual_file force_abs_paths">
<xacro:property name="force_abs_paths" value="${{force_abs_paths}}" scope="parent"/>
<xacro:property name="config_limits" value="${{xacro.load_yaml(limits_file)}}"/>
<xacro:property name="config_kinematics" value="${{load_yaml(kinematics_file)}}" scope="parent"/>
<xacro:property name="config_visual" value="${{xacro.load_yaml(visual_file)}}"/>
<xacro:property name="sec_limits" value="${{config_limits['joint_limits']}}" scope="parent"/>
<xacro:property name="masses" value="${{config_limits.masses}}" scope="parent"/>
<xacro:property name="sec_mesh_files" value="${{config_visual['mesh_files']}}" scope="parent"/>
</xacro:macro></robot>""",
    "Series_Description-main/config/s5/joint_limits.yaml": """
joint_limits:
  shoulder: {min: !degrees -360.0, max: !degrees  360.0, velocity: !degrees 180, effort: 150.0}
  elbow: &elbow
    min: !radians -pi
    max: !radians pi
    velocity: !degrees  180.0
    effort: 28.0
  wrist: {<<: *elbow, effort: 12.0}
masses: {shoulder: 3.761, elbow: 8.058}
""",
    "Series_Description-main/config/s5/kinematics.yaml": """
kinematics:
  shoulder: {x: 0, y: 0.0, z: !millimeters 89.159, roll: -0, pitch: 0, yaw: 0}
  elbow: {x: -0.425, y: 0, z: 0, roll: 1.570796327, pitch: 0, yaw: 0}
  hash: calib_12788084448423163542
""",
    "Series_Description-main/config/visual.yaml": "mesh_files:\n"
    + "".join(
        f"  {name}: {{offset: 0.1, visual: {{mesh: {{package: series_description, path: m/{name}.dae}}}}}}\n"
        for name in ("base", "shoulder", "elbow")
    ),
}


def write(folder: Path, files: Mapping[str, str]) -> None:
    """Write ``files`` below ``folder``."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
