"""An arm in URDF and in MJCF with all that is compared with the libraries that read it, and wrong copies."""

from __future__ import annotations

from typing import Final

MJCF: Final = """<mujoco model="arm"><compiler angle="radian"/><option gravity="0.5 0 -9.5"/><worldbody>
<body name="base" pos="0.1 0 0.3" euler="0.2 0.3 0.4"><inertial pos="0 0 0" mass="9" diaginertia="1 1 1"/>
<body name="upper" pos="0 0 0.2">
<joint name="i" axis="0 0 1" damping="1.5" frictionloss="0.7" armature="0.2"/>
<inertial pos="0.1 0.02 -0.03" mass="2" fullinertia="0.02 0.03 0.04 0.001 0.002 0.003"/>
<body name="lower" pos="0.2 0.1 0" euler="-0.5 0.1 0.7">
<joint name="j" axis="0 1 0" stiffness="8" springref="0.3" damping="0.4"/>
<inertial pos="0 0.1 0.2" mass="1.5" diaginertia="0.01 0.02 0.015"/>
<body name="slider" pos="0.3 0 0" euler="0 0.4 0"><joint name="k" type="slide" axis="1 0 0" armature="0.3"/>
<inertial pos="0.1 0 0" mass="0.8" diaginertia="0.01 0.02 0.015"/><site name="tool" pos="0.05 0 0.1"/>
<body name="finger" pos="0.2 0 0"><joint name="f" type="slide" axis="0 1 0" range="0.02 0.05" ref="0.2"/>
<inertial pos="0 0.1 0" mass="0.3" diaginertia="0.001 0.001 0.001"/></body>
<body name="thumb" pos="0.2 0 0"><joint name="g" type="slide" axis="0 1 0" ref="0.3"/>
<inertial pos="0 0.1 0" mass="0.4" diaginertia="0.001 0.001 0.001"/></body></body></body></body></body>
</worldbody><equality><joint joint1="g" joint2="f" polycoef="0.01 -1 2 0 0"/></equality>
<actuator><motor name="m" joint="j" gear="-50"/></actuator></mujoco>"""

URDF: Final = """<robot name="arm"><link name="world"/><link name="base"/><link name="upper"><inertial>
<origin xyz="0.1 0.02 -0.03" rpy="0.1 0.2 0.3"/><mass value="2"/>
<inertia ixx="0.02" iyy="0.03" izz="0.04" ixy="0.001" ixz="0.002" iyz="0.003"/></inertial></link>
<link name="lower"><inertial><origin xyz="0 0.1 0.2"/><mass value="1.5"/>
<inertia ixx="0.01" iyy="0.02" izz="0.015" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="slider"><inertial><origin xyz="0.1 0 0"/><mass value="0.8"/>
<inertia ixx="0.01" iyy="0.02" izz="0.015" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="finger"><inertial><origin xyz="0 0.1 0"/><mass value="0.3"/>
<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="thumb"><inertial><origin xyz="0 0.1 0"/><mass value="0.4"/>
<inertia ixx="0.001" iyy="0.001" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial></link><link name="tool"/>
<joint name="wall" type="fixed"><origin xyz="0.1 0 0.3" rpy="0.2 0.3 0.4"/><parent link="world"/>
<child link="base"/></joint>
<joint name="i" type="continuous"><origin xyz="0 0 0.2"/><parent link="base"/><child link="upper"/>
<axis xyz="0 0 1"/><dynamics damping="1.5" friction="0.7"/></joint>
<joint name="j" type="revolute"><origin xyz="0.2 0.1 0" rpy="-0.5 0.1 0.7"/><parent link="upper"/>
<child link="lower"/><axis xyz="0 1 0"/><limit lower="-2" upper="2" effort="9" velocity="3"/>
<dynamics damping="0.4"/></joint>
<joint name="k" type="prismatic"><origin xyz="0.3 0 0" rpy="0 0.4 0"/><parent link="lower"/>
<child link="slider"/><axis xyz="1 0 0"/><limit lower="-1" upper="1" effort="9" velocity="3"/></joint>
<joint name="hand" type="fixed"><origin xyz="0.05 0 0.1"/><parent link="slider"/><child link="tool"/></joint>
<joint name="f" type="prismatic"><origin xyz="0.2 0 0"/><parent link="slider"/><child link="finger"/>
<axis xyz="0 1 0"/><limit lower="0.02" upper="0.05" effort="9" velocity="3"/></joint>
<joint name="g" type="prismatic"><origin xyz="0.2 0 0"/><parent link="slider"/><child link="thumb"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="3"/>
<mimic joint="f" multiplier="-1" offset="0.01"/></joint></robot>"""

#: By text and what is wrong: what stands there, what takes its place, rows that differ, and the joint
#: (from 1) from which on the motion of links differs, if it does.
PLANTED: Final = {
    ("mjcf", "mass"): ('mass="1.5"', 'mass="1.51"', {"inverse_dynamics", "mass_matrix"}, None),
    ("mjcf", "axis"): ('axis="0 1 0" stiff', 'axis="0 -1 0" stiff', {"motion of links", "tool frame"}, 2),
    ("mjcf", "offset"): ('pos="0.3 0 0" euler', 'pos="0.301 0 0" euler', {"tool frame"}, None),
    ("mjcf", "place"): ('pos="0.2 0.1 0"', 'pos="0.2 0.101 0"', {"motion of links"}, 2),
    ("mjcf", "gear"): ('gear="-50"', 'gear="50"', {"gear ratios"}, None),
    ("mjcf", "gravity"): ("0.5 0 -9.5", "0.5 0 -9.51", {"inverse_dynamics"}, None),
    ("mjcf", "damping"): ('damping="0.4"', 'damping="0.41"', {"inverse_dynamics"}, None),
    ("mjcf", "friction"): ('frictionloss="0.7"', 'frictionloss="0.71"', {"inverse_dynamics"}, None),
    ("mjcf", "rotor"): ('armature="0.3"', 'armature="0.31"', {"inverse_dynamics", "mass_matrix"}, None),
    ("mjcf", "spring"): ('springref="0.3"', 'springref="0.31"', {"inverse_dynamics"}, None),
    ("mjcf", "finger"): ('range="0.02', 'range="0.03', {"inverse_dynamics", "mass_matrix"}, None),
    ("mjcf", "curve"): ("-1 2 0 0", "-1 2 0 1", {"inverse_dynamics", "mass_matrix"}, None),
    ("mjcf", "tool"): ('pos="0.05 0 0.1"', 'pos="0.05 0 0.101"', {"tool frame"}, None),
    ("urdf", "mass"): ('mass value="1.5"', 'mass value="1.51"', {"inverse_dynamics", "mass_matrix"}, None),
    ("urdf", "inertia"): ('ixz="0.002"', 'ixz="0.0021"', {"inverse_dynamics", "mass_matrix"}, None),
    ("urdf", "axis"): ('"lower"/><axis xyz="0 1 0"', '"lower"/><axis xyz="0 -1 0"', {"tool frame"}, None),
    ("urdf", "offset"): ('"0.1 0 0.3" rpy', '"0.1 0 0.301" rpy', {"motion of links", "tool frame"}, 1),
    ("urdf", "damping"): ('damping="0.4"', 'damping="0.41"', {"inverse_dynamics"}, None),
    ("urdf", "friction"): ('friction="0.7"', 'friction="0.71"', {"inverse_dynamics"}, None),
    ("urdf", "follower"): ('offset="0.01"', 'offset="0.02"', {"inverse_dynamics", "mass_matrix"}, None),
    ("urdf", "tool"): ('"0.05 0 0.1"', '"0.05 0 0.101"', {"tool frame"}, None),
}
