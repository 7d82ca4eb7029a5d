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
