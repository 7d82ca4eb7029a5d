"""What differs between two robots is listed in its group; what is only written differently is not."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from robodyn.compare.robots import GROUPS, Comparison, compare
from robodyn.errors import InputError
from robodyn.robot import load, read_text
from robodyn.robot.model import Gear, Joint, Limits, Link, Placement, Robot
from robodyn.robot.values import quarter_turns

ARM = load("ur5")


def groups(comparison: Comparison) -> list[str]:
    return list(dict.fromkeys(difference.group for difference in comparison.differences))


def with_link(index: int, **changes: Any) -> Robot:
    links = list(ARM.links)
    links[index] = replace(links[index], **changes)
    return replace(ARM, links=tuple(links))


def with_joint(index: int, **changes: Any) -> Robot:
    joint: Joint = replace(ARM.links[index].joint, **changes)
    return with_link(index, joint=joint)


def test_a_robot_is_like_itself() -> None:
    comparison = compare(ARM, ARM)
    assert comparison.same
    assert comparison.share == 0
    assert comparison.tool == (0, 0)


def test_other_frames_of_the_same_arm_are_no_difference() -> None:
    """The frame of the last link turned by pi about its axis, which its row, body and tool make up for."""
    robot = load("rx90")
    last = robot.links[-1]
    assert (last.joint.theta.quarter, robot.tool) == (0, None)
    x, y, z = last.com
    inertia = replace(last.inertia, xz=-last.inertia.xz, yz=-last.inertia.yz)
    half = replace(last.joint, theta=quarter_turns(2))
    turned = Link(last.name, half, last.mass, (-x, -y, z), inertia, last.confidence)
    zero = Fraction(0)
    back = Placement((zero, zero, zero), (quarter_turns(0), quarter_turns(0), quarter_turns(2)))
    other = replace(robot, links=(*robot.links[:-1], turned), tool=back)
    comparison = compare(robot, other)
    assert comparison.same, comparison.differences
    assert groups(compare(robot, replace(other, tool=None))) == ["tool"]


DIFFERENT = {
    "names": with_link(0, name="shoulder"),
    "gravity": replace(ARM, gravity=(Fraction(0), Fraction(0), Fraction(-98, 10))),
    "links": with_link(2, mass=ARM.links[2].mass * Fraction(11, 10)),
    "rotors": with_joint(1, motor_inertia=Fraction(1, 2)),
    "friction": with_joint(5, coulomb=Fraction(1, 2)),
    "limits": with_joint(3, limits=Limits(velocity=Fraction(2))),
    "axes": with_joint(4, d=Fraction(1, 10)),
}


@pytest.mark.parametrize("group", DIFFERENT)
def test_each_difference_stands_in_its_group(group: str) -> None:
    comparison = compare(ARM, DIFFERENT[group])
    assert group in groups(comparison)
    assert compare(ARM, DIFFERENT[group], ignore=groups(comparison)).same
    only = {"names", "limits"}
    assert ("torques" in groups(comparison)) == (group not in only)
    assert groups(comparison) == sorted(groups(comparison), key=GROUPS.index)


def test_the_amount_is_stated() -> None:
    comparison = compare(ARM, DIFFERENT["friction"])
    (friction, torque) = comparison.differences
    assert (friction.where, friction.what, friction.left, friction.right) == ("link6", "coulomb", 0.0, 0.5)
    assert torque.by == pytest.approx(0.5)
    assert comparison.torques == pytest.approx((0, 0, 0, 0, 0, 0.5))
    assert comparison.share == pytest.approx(0.5 / comparison.largest)


def test_the_tolerance_is_a_share() -> None:
    heavier = with_link(2, mass=ARM.links[2].mass * Fraction(1001, 1000))
    assert not compare(ARM, heavier, tolerance=1e-5).same
    assert compare(ARM, heavier, tolerance=1e-2).same


def test_gears_and_effects_are_compared() -> None:
    geared = with_joint(0, gear=Gear(Fraction(100)))
    assert [(d.what, d.left, d.right) for d in compare(ARM, geared).differences] == [
        ("gear ratio", None, 100)
    ]
    text = "name: arm\nlinks:\n  - {joint: revolute, mass: 1, com: [0.1, 0, 0], effects: [EFFECT]}\n"
    soft, stiff = (
        read_text(text.replace("EFFECT", f"{{effect: spring, stiffness: {k}}}")) for k in ("3", "4")
    )
    (effect, torque) = compare(soft, stiff).differences
    assert (effect.group, effect.where, effect.what) == ("effects", "link1", "spring")
    assert effect.left["stiffness"] == 3
    assert torque.group == "torques"


def test_another_number_of_joints_ends_the_comparison() -> None:
    comparison = compare(load("puma560"), load("puma560_3dof"), ignore=["names"])
    assert [d.what for d in comparison.differences] == ["number of joints"]
    assert comparison.torques is None
    assert comparison.share is None


def test_run_time_parameters_have_the_same_values_in_both() -> None:
    text = "name: arm\nlinks:\n  - {joint: revolute, mass: m, com: [0.1, 0, 0]}\n"
    one, other = read_text(text), read_text(text.replace("m,", "2*m,"))
    assert compare(one, one).same
    assert groups(compare(one, other)) == ["links", "torques"]
    named = read_text(text.replace("m,", "mass,"))
    assert "parameters" in groups(compare(one, named))
    with pytest.raises(InputError, match="expected joints, names"):
        compare(one, one, ignore=["everything"])
