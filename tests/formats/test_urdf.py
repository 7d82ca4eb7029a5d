"""URDF: what is read, what is not used, and what is wrong with its place."""

from __future__ import annotations

import pytest

from robodyn.errors import InputError
from robodyn.formats.elements import parse
from robodyn.formats.tree import Tree
from robodyn.formats.urdf import read_tree
from robodyn_testing.urdf_text import joint, link, robot


def tree(text: str) -> Tree:
    return read_tree(parse(text.encode(), "arm.urdf"))


PAIR = robot(link("a"), link("b"), joint("j", "a", "b"))


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


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('name="j" type', "type", "3:1|<joint> has no 'name'"),
        ('name="j" type', 'name="" type', "4:8: the name of a joint is empty"),
        (
            'type="revolute"',
            'type="hinge"',
            "4:17: joint 'j': the type is unknown; found 'hinge'; expected",
        ),
        ('<parent link="a"/>', '<parent link="c"/>', "4:1: joint 'j': there is no link of the name of its p"),
        ('<parent link="a"/>', "", "joint 'j': <joint> has no <parent>"),
        ('<child link="b"/>', "<child/>", "<child> has no 'link'"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>', "joint 'j': the axis has no direction"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0"/>', "xyz of <axis> must have 3 numbers; found '0 0'"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 nan"/>', "xyz of <axis> is not a number; found 'nan'"),
        ('xyz="0.3 0 0"', 'xyz="0,3 0 0"', "is not a number; found '0,3'; expected a decimal number"),
        ('value="1"', 'value="-1"', "2:55: link 'a': value of <mass> is negative; found '-1'"),
        ('value="1"', 'value="1_0"', "is not a number; found '1_0'"),
        ('value="1"', 'value=""', "is not a number; found nothing"),
        ('<mass value="1"/>', "", "link 'a': <inertial> has no <mass>"),
        ('ixx="0.01"', "", "link 'a': <inertia> has no 'ixx'"),
        ('name="b"', 'name="a"', "two links have the same name; found 'a'; expected another name; the first"),
        ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 1"/>' * 2, "joint 'j' has <axis> twice"),
        ('name="a"', 'name="a" name="b"', "2:16: the file is not XML; found duplicate attribute"),
        ('lower="-1"', 'lower="-l"', "lower is not a number; found '-l'"),
        ('name="a"', 'name="a&#1;"', "not XML"),
        ('name="a"', 'name="a&#x202e;"', "the name of a link contains the control character U+202E"),
        ("</robot>", f"{joint('j', 'a', 'b')}</robot>", "two joints have the same name"),
    ],
)
def test_errors_say_where_and_what(old: str, new: str, words: str) -> None:
    assert old in PAIR
    with pytest.raises(InputError) as caught:
        tree(PAIR.replace(old, new, 1))
    message = str(caught.value)
    assert message.startswith("arm.urdf:")
    assert any(word in message for word in words.split("|")), message
    assert "\n" not in message


def test_macros_in_urdf_are_no_links() -> None:
    with pytest.raises(
        InputError, match=r"the robot has no links; .*; this is a xacro file: name it \.xacro"
    ):
        tree('<robot name="arm"><xacro:arm/></robot>')
