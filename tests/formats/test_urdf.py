"""URDF: what is read, what is not used, and what is wrong with its place."""

from __future__ import annotations

from robodyn.formats.elements import parse
from robodyn.formats.tree import Tree
from robodyn.formats.urdf import read_tree
from robodyn_testing.urdf_text import joint, link, robot


def tree(text: str) -> Tree:
    return read_tree(parse(text.encode(), "arm.urdf"))


def test_what_is_not_used_is_listed_with_its_lines() -> None:
    text = robot(
        '<material name="red"/>',
        link("a", '<visual name="v"><geometry/></visual>\n<collision/>'),
        link("b", "<visual/>"),
        joint("j", "a", "b", inside='<safety_controller k_position="1"/>'),
        "<gazebo/>",
        '<ros2_control name="x"/>',
        '<friend name="f"/>',
    ).replace('<robot name="arm">', '<robot name="arm" colour="red">')
    assert [(part.what, part.lines) for part in tree(text).unused] == [
        ("unknown to URDF: 'colour' of <robot>", (1,)),
        ("materials", (2,)),
        ("visual geometry", (3, 5)),
        ("collision geometry", (4,)),
        ("safety controllers", (6,)),
        ("settings of Gazebo", (7,)),
        ("ros2_control", (8,)),
        ("unknown to URDF: <friend> in <robot>", (9,)),
    ]
    assert tree(text).unused[2].text("arm.urdf") == "visual geometry (lines 3, 5)"
    assert tree(text).unused[1].text() == "materials (arm.urdf: line 2)"


def test_inertia_is_turned_into_the_link() -> None:
    inside = (
        '<inertial><origin xyz="0.1 0.2 0.3" rpy="0 0 1.57079632679"/><mass value="12.93"/>'
        '<inertia ixx="0.011" iyy="0.022" izz="0.03" ixy="0.001" ixz="0.002"/></inertial>'
    )
    (_, moved) = tree(robot(link("a"), link("b", inside), joint("j", "a", "b"))).links
    assert moved.body is not None
    assert moved.body.mass == 12.93
    assert moved.body.com == (0.1, 0.2, 0.3)
    assert moved.body.inertia == (0.022, 0.011, 0.03, -0.001, 0.0, 0.002)
