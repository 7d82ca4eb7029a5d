"""Every key of a description, its default, and the ways in which its value may be written."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Final

import numpy as np
import pytest

from robodyn.robot import (
    Comparison,
    DoubtfulRobot,
    Gear,
    Inertia,
    Joint,
    Limits,
    Link,
    Robot,
    read_text,
    to_yaml,
)  # fmt: skip
from robodyn.robot.model import JointKind
from robodyn.robot.values import ZERO, Affine, angle, parameter
from robodyn_testing import exactly

EVERYTHING = """\
name: puma560
title: "PUMA 560: six joints"
source: where the numbers come from
gravity: [0, 1/2, -9.8]
compare: {table: 2.10, row: puma_6}
convention: mdh
links:
  - name: shoulder
    joint: revolute
    alpha: -pi/2
    a: 17*0.0254
    b: 2*0.1
    d: 0.2435
    theta: pi
    mass: 17.4
    com: [0.068, 0.006, -0.016]
    inertia: {xx: 0.13, yy: 0.524, zz: 0.539, xy: 0.01, xz: -0.02, yz: 0.03}
    motor_inertia: 4.71
    limits: {position: [-2.9, 2.9], velocity: 3.0, acceleration: 10.0, torque: 186.4}
    gear: {ratio: 121, torque_constant: 0.11}
    confidence: 0.02
    friction: {viscous: 1.2, coulomb: 3.0}
    effects: [{effect: spring, stiffness: 2*k}]
  - joint: prismatic
    mass: m_tool
torque_side: link
friction_at_rest: {smooth: {velocity: 1e-2}}
effects: [{effect: payload, mass: 2.5}]
"""


KINDS: Final[tuple[tuple[str, JointKind], ...]] = (("link1", "revolute"), ("link2", "prismatic"))


def _link(text: str) -> Link:
    """The one link with the keys in ``text``, which are written in flow style."""
    return read_text("name: arm\nlinks: [{joint: revolute, " + text + "}]").links[0]


def test_everything_stated() -> None:
    robot = read_text(EVERYTHING)
    f = Fraction
    texts = ("puma560", "PUMA 560: six joints", "where the numbers come from")
    assert (robot.name, robot.title, robot.source) == texts
    assert robot.gravity == exactly(0, f(1, 2), f(-98, 10))
    assert robot.compare == Comparison("2.10", "puma_6")  # not 2.1: the text counts
    assert (robot.torque_side, robot.rest_velocity, robot.dead_band) == ("link", f(1, 100), None)
    assert [(entry.effect, entry.joint) for entry in robot.effects] == [("spring", 1), ("payload", None)]
    assert robot.effects[0]["stiffness"] == 2 * parameter("k")
    assert robot.effects[1]["mass"] == f(5, 2)
    assert robot.parameters == ("m_tool", "k")
    shoulder, slide = robot.links
    assert (shoulder.name, shoulder.mass) == ("shoulder", f(174, 10))
    assert shoulder.com == (f(68, 1000), f(6, 1000), f(-16, 1000))
    moments = ("0.13", "0.524", "0.539", "0.01", "-0.02", "0.03")
    assert shoulder.inertia == Inertia(*map(f, moments))
    assert shoulder.confidence == shoulder.inertial_share == f(2, 100)
    joint = shoulder.joint
    assert joint.gear == Gear(f(121), f(11, 100))
    assert joint.gear.torque_per_ampere == f(1331, 100)
    assert (joint.kind, joint.alpha.quarter, joint.theta.quarter) == ("revolute", -1, 2)
    assert (joint.a, joint.b, joint.d) == (f(4318, 10000), f(1, 5), f(2435, 10000))
    assert joint.motor_inertia == f(471, 100)
    assert (joint.viscous, joint.coulomb) == (f(12, 10), f(3))
    assert joint.limits == Limits((f(-29, 10), f(29, 10)), f(3), f(10), f(1864, 10))
    assert (slide.name, slide.joint.kind, slide.mass) == ("link2", "prismatic", parameter("m_tool"))


def test_the_base_stands_in_the_world_and_the_tool_in_the_last_link() -> None:
    text = "name: arm\nlinks: [{joint: revolute}]\ngravity: [1, 2, 3]\n"
    f = Fraction
    robot = read_text(text + "base: {rpy: [pi/2, 0, pi/2]}\ntool: {xyz: [0, 0, 0.1]}")
    assert robot.gravity == exactly(1, 2, 3)
    # The base's x axis is the world's y, its y the world's z, its z the world's x.
    assert robot.base_gravity == exactly(2, 3, 1)
    assert robot.tool is not None
    assert robot.tool.xyz == exactly(0, 0, f(1, 10))
    assert robot.tool.rotation == (exactly(1, 0, 0), exactly(0, 1, 0), exactly(0, 0, 1))
    tilted = read_text(text + "base: {xyz: [5, 5, 5], rpy: [0.1, -0.2, 0.3]}")
    assert tilted.base is not None
    R = np.array([[float(x) for x in row] for row in tilted.base.rotation])
    np.testing.assert_allclose(R.T @ R, np.eye(3), rtol=0, atol=1e-15)
    np.testing.assert_allclose(R @ [float(x) for x in tilted.base_gravity], [1, 2, 3], rtol=0, atol=1e-14)
    assert R[2] == pytest.approx([np.sin(0.2), np.cos(0.2) * np.sin(0.1), np.cos(0.2) * np.cos(0.1)])
    assert read_text(text).base_gravity == exactly(1, 2, 3)


def test_only_name_links_and_joint_are_required() -> None:
    robot = read_text("name: arm\nlinks:\n- joint: revolute\n- joint: prismatic\n")
    flat, zero = angle(ZERO), (ZERO, ZERO, ZERO)
    revolute, prismatic = (
        Link(name, Joint(kind, flat, ZERO, ZERO, flat, *zero, Limits()), ZERO, zero, Inertia(), None)
        for name, kind in KINDS
    )
    assert robot == Robot("arm", (revolute, prismatic), "", "", exactly(0, 0, Fraction(-981, 100)))
    assert robot.links[0].inertial_share == Fraction(1, 10)


@pytest.mark.parametrize(
    ("text", "velocity"),
    [
        ("exact", None),
        ("smooth", Fraction(1, 1000)),
        ("{smooth: {}}", Fraction(1, 1000)),
        ("{smooth: {velocity: 1/50}}", Fraction(1, 50)),
    ],
)
def test_friction_at_rest(text: str, velocity: Fraction | None) -> None:
    """A dead band is written as a smoothed sign is."""
    for rule in ("smooth", "dead_band"):
        stated = text.replace("smooth", rule)
        robot = read_text(f"name: arm\nfriction_at_rest: {stated}\nlinks: [{{joint: revolute}}]")
        expected = (velocity, None) if rule == "smooth" else (None, velocity)
        assert (robot.rest_velocity, robot.dead_band) == expected
        assert read_text(to_yaml(robot)) == robot


def test_a_link_states_its_confidence_or_takes_the_robots_or_none_is_stated() -> None:
    links = "[{joint: revolute}, {joint: revolute, confidence: 0.1}, {joint: revolute, confidence: unknown}]"
    for stated, first in (("", None), ("unknown", "unknown"), ("0.5", Fraction(1, 2))):
        head = f"confidence: {stated}\n" if stated else ""
        read = read_text(f"name: arm\n{head}links: {links}").links
        assert [link.confidence for link in read] == [first, Fraction(1, 10), "unknown"]
        assert [link.inertial_share for link in read[1:]] == [Fraction(1, 10), 1]


def test_yaml_1_1_does_not_reinterpret_words_and_numbers() -> None:
    robot = read_text("name: yes\ntitle: 010\nsource: null and void\nlinks: [{name: 1e3, joint: revolute}]")
    assert (robot.name, robot.title, robot.source) == ("yes", "010", "null and void")
    assert robot.links[0].name == "1e3"
    assert _link("mass: 1e-3").mass == Fraction(1, 1000)
    assert _link("mass: 010").mass == 10
    assert _link("mass: '17.4'").mass == Fraction(174, 10)
    assert _link('mass: "2*(1 + 3)"').mass == 8


def test_layout_is_free() -> None:
    flow = read_text("{name: arm, links: [{joint: revolute, com: [0, 1, 2], mass: 1 +\n  2}]}")
    block = read_text(
        "%YAML 1.1\n---\nlinks:\n- com:\n  - 0\n  - 1\n  - 2\n"
        "  mass: >\n    3\n  joint: revolute\nname: arm\n...\n"
    )
    assert flow == block


def test_small_anchors_and_aliases_work() -> None:
    robot = read_text(
        "name: arm\nlinks:\n  - {joint: revolute, com: &c [0, 0, 1]}\n  - {joint: revolute, com: *c}\n"
        "  - &l {joint: revolute, mass: &m 2}\n  - *l\n  - {joint: revolute, mass: *m}\n"
    )
    assert robot.links[1].com == exactly(0, 0, 1)
    assert [link.mass for link in robot.links] == [0, 0, 2, 2, 2]
    assert robot.links[3].name == "link4"


def test_free_text_is_one_line() -> None:
    robot = read_text(
        "name: arm\ntitle: |\n  two\n  lines  \nsource: >-\n  folded\n  text\nlinks: [{joint: revolute}]"
    )
    assert (robot.title, robot.source) == ("two lines", "folded text")
    odd = "Größe */ /* ?\\/ \\\\ // 機械 %s {{ x }} \U0001f916"
    assert read_text(f"name: arm\ntitle: '{odd}'\nlinks: [{{joint: revolute}}]").title == odd


def test_angles_are_recognised_and_exact() -> None:
    joint = _link("alpha: 90*pi/180, theta: pi/6").joint
    assert joint.alpha.quarter == 1
    assert (joint.alpha.cos, joint.alpha.sin) == exactly(0, 1)
    assert joint.theta.quarter is None
    assert joint.theta.radians == 0.5235987755982989  # rounded once: math.pi / 6 is not
    assert joint.theta.sin**2 + joint.theta.cos**2 == 1
    assert abs(joint.theta.sin - Fraction(1, 2)) < Fraction(1, 10**16)
    assert _link("alpha: 1.5707963267949").joint.alpha.quarter == 1  # within 1e-12
    assert _link("alpha: 1.57079632").joint.alpha.quarter is None


def test_pi_in_a_length_is_the_double() -> None:
    assert _link("a: pi/4").joint.a == Fraction(repr(math.pi / 4))
    assert _link("a: 2*r + pi").joint.a == Affine(Fraction(repr(math.pi)), (("r", Fraction(2)),))


def test_names_stand_where_they_may() -> None:
    robot = read_text(
        "name: arm\nlinks:\n"
        "  - joint: revolute\n    a: a1\n    d: d1\n    mass: m\n    com: [x, y, z]\n"
        "    inertia: {xx: ixx, yy: iyy, zz: izz, xy: ixy, xz: ixz, yz: iyz}\n"
        "    motor_inertia: im\n    friction: {viscous: fv, coulomb: fc}\n"
        "  - {joint: prismatic, mass: m, com: [0, 0.5 - 2*x, 0]}\n"
    )
    assert " ".join(robot.parameters) == "a1 d1 m x y z ixx iyy izz ixy ixz iyz im fv fc"
    assert robot.links[1].com[1] == Affine(Fraction(1, 2), (("x", Fraction(-2)),))


@pytest.mark.parametrize(
    ("link", "doubt"),
    [
        ("inertia: {xx: 0.066, yy: 0.0125, zz: 0.086}", "55: link 2: inertia is not physical"),
        ("limits: {position: [-180, 180]}", "65: link 2: limits: position: -180 to 180 rad are"),
        ("alpha: -90, theta: 2*pi", "53: link 2: alpha = -90 rad is more than one turn"),
    ],
)
def test_doubts_are_told_and_the_robot_is_read(link: str, doubt: str) -> None:
    """With ``strict`` they are errors: tests/refusals."""
    told: list[str] = []
    text = f"name: arm\nlinks: [{{joint: revolute}}, {{joint: revolute, {link}}}]"
    assert read_text(text, "arm.yaml", warn=told.append).n == 2
    assert len(told) == 1
    assert told[0].startswith(f"arm.yaml:2:{doubt}")


def test_limits_that_are_no_degrees() -> None:
    text = "name: arm\nlinks: [{joint: revolute, limits: {position: [-180, 180]}}]"
    read_text(text.replace("{joint", "{acknowledged: a winch, joint"))
    for other in ("[-6.28, 6.28]", "[-41.5, 41.5]", "[-1e6, 1e6]", "[-720*pi/180, 0]"):
        assert read_text(text.replace("[-180, 180]", other), strict=True).n == 1
    assert read_text(text.replace("revolute", "prismatic"), strict=True).n == 1


def test_whole_turns_are_taken_off_exactly() -> None:
    robots = [
        read_text(f"name: arm\nlinks: [{{joint: revolute, theta: {text}}}]", warn=lambda _: None)
        for text in ("0.25", "0.25 + 2*pi", "0.25 - 20000*pi")
    ]
    assert len({robot.links[0].joint.theta for robot in robots}) == 1


@pytest.mark.parametrize(
    "keys",
    [
        "{xx: 1, yy: 1, zz: 2}",  # a flat body
        "{xx: 0.1, yy: 0.2, zz: 0.3}",  # 0.1 + 0.2 is 0.3, exactly
        "{xx: 0, yy: 1, zz: 1}",  # a thin rod
        "{xx: 2, yy: 2, zz: 2, xy: 1, xz: 0, yz: 0}",
        "{xx: 2/3, yy: 2/3, zz: 2/3, xy: -1/3, xz: -1/3, yz: -1/3}",  # a rod along (1, 1, 1)
        "{xx: i_x, yy: 1, zz: 5}",  # not known now
        "{}",
    ],
)
def test_tensors_of_bodies_are_not(keys: str) -> None:
    text = "name: arm\nlinks: [{joint: revolute}, {joint: revolute, inertia: " + keys + "}]"
    assert read_text(text, strict=True).n == 2


def test_izz_alone_is_enough_for_a_link_on_a_fixed_axis() -> None:
    for convention, alpha, axis in (("mdh", "0", "zz"), ("sdh", "-pi/2", "yy"), ("mdh", "pi/3", "zz")):
        text = f"name: arm\nconvention: {convention}\nlinks: [{{joint: revolute, alpha: {alpha}, "
        assert read_text(text + f"inertia: {{{axis}: 0.35}}}}]", strict=True).n == 1


def test_doubts_are_python_warnings_unless_taken() -> None:
    with pytest.warns(DoubtfulRobot, match=r"<text>:2:34: link 1: alpha = 90 rad"):
        robot = read_text("name: arm\nlinks: [{joint: revolute, alpha: 90}]")
    assert robot.n == 1
