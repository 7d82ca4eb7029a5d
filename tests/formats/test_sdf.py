"""SDF: truth values, limits, worlds, springs, and what is wrong with its place."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from robodyn import load
from robodyn.formats.chain import Spring
from robodyn.formats.elements import parse
from robodyn.formats.sdf import read_tree
from robodyn.formats.serial import Serial, serial_chain
from robodyn.formats.tree import Tree
from robodyn_testing import sdf_arms, urdf_text


def tree(text: str) -> Tree:
    return read_tree(parse(text.encode(), "arm.sdf"))


def chain(text: str, **options: Any) -> Serial:
    return serial_chain(tree(text), "arm", **options)


def sdf(inside: str, tail: str = "", version: str = "1.9") -> str:
    return f'<sdf version="{version}">\n<model name="arm">{inside}</model>{tail}</sdf>'


SOLID = "<inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.2</izz></inertia></inertial>"
A, B = f'<link name="a">{SOLID}</link>', f'<link name="b"><pose>0.1 0.2 0.3 0 0 0</pose>{SOLID}</link>'
J = (
    '<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz><limit>'
    "<lower>-1e16</lower><upper>1e16</upper><effort>-1</effort><velocity>2</velocity></limit>"
    "<dynamics><damping>0.5</damping><friction>0.25</friction></dynamics></axis></joint>"
)


@pytest.mark.parametrize("version", ["1.4", "1.9"])
@pytest.mark.parametrize("word", ["TRUE", " 1 ", "False"])
def test_truth_values_are_read_as_sdformat_does(word: str, version: str) -> None:
    """Whatever the case of their letters; a word that is stated counts in old versions too."""
    plain = {True: "true", False: "false"}[word.strip().lower() in ("true", "1")]
    flag = "<use_parent_model_frame>{0}</use_parent_model_frame>"
    pose = '<pose degrees="{0}">1 2 3 40 50 60'
    link, axis = B.replace("<pose>0.1 0.2 0.3 0 0 0", pose), J.replace("<limit>", flag + "<limit>")
    turned = sdf(A + link + axis, version=version)
    assert chain(turned.format(word)).chain == chain(turned.format(plain)).chain
    bare = chain(turned.replace(flag, "").format("true"))
    assert (bare.chain == chain(turned.format("true")).chain) == (version == "1.4")


def test_decimals_survive_and_limits_of_nothing_are_none() -> None:
    (joint,) = chain(
        sdf(A.replace("<inertial>", "<pose>0.3 0 0 0 0 0</pose><inertial>") + B + J)
    ).chain.joints
    assert joint.pose.xyz == (0.1, 0.2, 0.3)
    assert joint.body.mass == 2
    assert (joint.viscous, joint.coulomb) == (0.5, 0.25)
    assert joint.limits.position is None
    assert joint.limits.torque is None
    assert joint.limits.velocity == 2


def test_a_model_in_a_world_and_joined_to_it() -> None:
    world = '<world name="w"><gravity>1 2 -9</gravity><light name="sun"/>{}</world>'
    fixed = '<joint name="k" type="fixed"><parent>world</parent><child>a</child></joint>'
    model = f'<model name="m"><pose>0 0 1 1.57079632679 0 0</pose>{A + B + J + fixed}</model>'
    read = tree(f'<sdf version="1.9">{world.format(model)}</sdf>')
    serial = serial_chain(read, "arm")
    assert serial.chain.gravity == (1.0, 2.0, -9.0)
    assert serial.chain.joints[0].pose.xyz == (0.1, -0.3, 1.2)
    assert serial.remarks == ()
    assert [part.what for part in read.unused] == ["lights"]
    below = serial_chain(read, "arm", base="a").chain
    assert below.base.rotation == ((1, 0, 0), (0, 0, -1), (0, 1, 0))


def test_what_is_not_used_is_listed() -> None:
    text = sdf(
        A.replace("<inertial>", '<visual name="v"/><inertial auto="true">')
        + B
        + J
        + '<plugin name="p" filename="f"/>'
    )
    read = tree(text)
    assert [part.what for part in read.unused] == ["visual geometry", "plugins"]
    assert [(part.name, part.of) for part in read.physics] == [("auto", "link a")]


def test_springs_of_joints() -> None:
    spring = "<spring_reference>0.2</spring_reference><spring_stiffness>3</spring_stiffness></dynamics>"
    read = tree(sdf(A + B + J.replace("</dynamics>", spring)))
    assert [joint.spring for joint in read.joints if joint.name == "j"] == [Spring(3.0, 0.2)]
    assert not read.unused


# A damping, friction or rotor inertia of 0 that a file states is not one that nobody states.

URDF = urdf_text.robot(urdf_text.link("a"), urdf_text.link("b"), urdf_text.joint("j", "a", "b"))
SDF = sdf_arms.sdf(sdf_arms.model(sdf_arms.ARM))


@pytest.mark.parametrize(
    ("ending", "text", "stated", "friction", "rotor"),
    [
        ("urdf", URDF, "", "absent", "absent"),
        ("urdf", URDF, '<dynamics damping="0"/>', "stated", "absent"),
        ("urdf", URDF, '<dynamics friction="0" armature="0"/>', "stated", "stated"),
        ("sdf", SDF, "", "absent", "absent"),
        ("sdf", SDF, "<dynamics><damping>0</damping></dynamics>", "stated", "absent"),
    ],
)
def test_a_stated_0_is_not_what_nobody_states(
    ending: str, text: str, stated: str, friction: str, rotor: str, tmp_path: Path
) -> None:
    before = "</axis></joint>" if ending == "sdf" else "</joint>"
    path = tmp_path / f"arm.{ending}"
    path.write_text(text.replace(before, stated + before))
    for link in load(path, warn=lambda _: None).links:
        assert (link.origins.friction, link.origins.motor_inertia) == (friction, rotor)
