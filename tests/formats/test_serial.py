"""Chains out of trees: tips, bases, locks, joints that follow others, loops."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from robodyn.errors import InputError
from robodyn.formats.chain import Pose
from robodyn.formats.elements import parse
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.tree import Tree
from robodyn.formats.urdf import read_tree
from robodyn_testing.urdf_text import GRIPPER, joint, link, robot


def tree(text: str) -> Tree:
    return read_tree(parse(text.encode(), "arm.urdf"))


def chain(text: str, **options: object) -> Serial:
    return serial_chain(tree(text), "arm", **options)  # type: ignore[arg-type]


def joints(serial: Serial) -> list[str]:
    return [joint.name for joint in serial.chain.joints]


def refused(text: str, **options: object) -> str:
    with pytest.raises(InputError) as caught:
        chain(text, **options)
    return str(caught.value)


def test_a_tip_is_taken_and_what_is_beyond_is_locked_and_lumped() -> None:
    serial = chain(GRIPPER, tip="hand")
    assert joints(serial) == ["shoulder", "elbow"]
    assert serial.chain.joints[1].link == "lower"
    body = serial.chain.joints[1].body  # lower, hand, two fingers: 1 kg each
    assert body.mass == 4
    centres = (0.1, 0.4, 0.7, 0.7)
    assert body.com == pytest.approx((sum(centres) / 4, 0, (0.01 - 0.01) / 4))
    assert serial.chain.tool == Pose((0.3, 0.0, 0.0))
    assert serial.remarks == (
        "locked, and lumped into the links that carry them: finger at 0.01, other_finger at -0.01",
    )


def test_locks_leave_one_tip() -> None:
    serial = chain(GRIPPER, locks={"finger": 0.03})
    assert joints(serial) == ["shoulder", "elbow"]
    assert "finger at 0.03, other_finger at -0.03" in serial.remarks[1]
    assert serial.remarks[0] == "the tool frame is that of lower; --tip chooses another: left, right"
    assert joints(chain(GRIPPER, tip="left", locks={"shoulder": 0.5})) == ["elbow", "finger"]


def test_a_base_is_where_the_file_puts_it() -> None:
    turned = GRIPPER.replace('<origin xyz="0.3 0 0"/>', '<origin xyz="0.3 0 0" rpy="1.57079632679 0 0"/>', 1)
    serial = chain(turned, base="upper", tip="hand", locks={"shoulder": 0.5})
    assert joints(serial) == ["elbow"]
    base = serial.chain.base
    assert base.xyz == (0.3, 0.0, 0.0)
    assert base.rotation[0] == pytest.approx((math.cos(0.5), -math.sin(0.5), 0))
    assert base.rotation[2] == pytest.approx((math.sin(0.5), math.cos(0.5), 0))
    assert "does not hang on the link 'left'" in refused(GRIPPER, base="left", tip="hand")


def test_a_joint_that_follows_another_is_no_joint_of_the_chain() -> None:
    message = refused(GRIPPER, tip="right")
    assert "'other_finger' of the chain follows the joint 'finger'" in message
    assert "--lock other_finger=VALUE" in message
    serial = chain(GRIPPER, tip="left")
    assert serial.remarks[0].endswith("other_finger at -0.01")
    assert "follow a joint of the chain: other_finger (finger)" in serial.remarks[1]


@pytest.mark.parametrize(
    ("locks", "words"),
    [
        ({"wrist": 0.0}, "did you mean|one of the joints"),
        ({"elbw": 0.0}, "did you mean 'elbow'"),
        ({"elbow": 90.0}, "found --lock elbow=90; expected -1 to 2 rad"),
        ({"flange": 1.0}, "fixed, cannot be locked there"),
    ],
)
def test_locks_that_cannot_be_are_refused(locks: dict[str, float], words: str) -> None:
    message = refused(GRIPPER, tip="hand", locks=locks)
    assert any(word in message for word in words.split("|")), message


def test_fixed_joints_are_merged_and_decimals_survive() -> None:
    text = robot(
        link("base"),
        link("a"),
        link("flange", ""),
        link("b"),
        joint("one", "base", "a"),
        joint("bolt", "a", "flange", "fixed"),
        joint("two", "flange", "b", "continuous"),
    )
    serial = chain(text)
    assert serial.chain.joints[1].pose == Pose((0.6, 0.0, 0.0))  # not 0.3 + 0.3 with noise
    assert serial.chain.joints[0].body.com == (0.1, 0.0, 0.0)
    assert serial.chain.joints[1].kind == "revolute"
    assert serial.chain.joints[1].limits.position is None
    assert serial.remarks == ()


def test_a_floating_base_is_held() -> None:
    text = robot(
        link("world", ""), link("base"), link("a"),
        joint("free", "world", "base", "floating"), joint("one", "base", "a"),
    )  # fmt: skip
    serial = chain(text)
    assert joints(serial) == ["one"]
    assert serial.remarks == ("the base is fixed: free is a floating joint at the root",)
    inner = robot(
        link("base"), link("a"), link("b"), joint("one", "base", "a"), joint("free", "a", "b", "floating")
    )
    assert "the joint 'free' of the chain is floating" in refused(inner, tip="b")
    assert joints(chain(inner, tip="a")) == ["one"]


def test_what_has_no_mass_is_reported() -> None:
    text = robot(
        link("base"), link("a", "<visual/>"), link("b"), joint("one", "base", "a"), joint("two", "a", "b")
    )
    assert chain(text).remarks == (
        "links without inertia, and so without mass: a",
        "joints that carry no mass: one",
    )


def test_joints_that_follow_each_other_are_refused() -> None:
    text = GRIPPER.replace('<limit lower="0.01" upper="0.04"/>', '<mimic joint="other_finger"/>')
    assert "follows a joint that follows it" in refused(text, tip="hand")


def test_what_sits_in_a_joint_arrives() -> None:
    inside = '<limit lower="-180" upper="180" velocity="3.14" effort="0"/>'
    inside += '<dynamics damping="0.5" friction="0.25"/>'
    drive = (
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type><joint name="j"/>'
        '<actuator name="m"><mechanicalReduction>-120</mechanicalReduction></actuator></transmission>'
    )
    text = robot(link("a"), link("b"), joint("j", "a", "b", "revolute", inside), drive)
    serial = chain(text)
    (only,) = serial.chain.joints
    assert (only.viscous, only.coulomb) == (0.5, 0.25)
    assert only.gear is not None
    assert only.gear.ratio == -120
    assert only.limits.position == (Fraction(-180), Fraction(180))
    assert (only.limits.velocity, only.limits.torque) == (Fraction("3.14"), None)
    assert serial.remarks == (
        "limits of -180 to 180 rad are more than six turns: were degrees meant?: j",
        "no limit of torque: 0: j",
    )
    assert not tree(text).unused


def test_a_follower_of_a_follower_is_where_both_put_it() -> None:
    third = joint(
        "thumb", "hand", "nail", "prismatic", '<mimic joint="other_finger" multiplier="2" offset="0.01"/>'
    )
    text = GRIPPER.replace('multiplier="-1"', 'multiplier="-1" offset="0.005"')
    text = text.replace("</robot>", link("nail") + third + "</robot>")
    serial = chain(text, tip="hand", locks={"finger": 0.03})
    assert serial.remarks[0].endswith("finger at 0.03, other_finger at -0.025, thumb at -0.04")
